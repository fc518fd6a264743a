/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Options of the command line, all in one table, and the settings that SCENARIO and they come to. To add one:
 * a row in options.c and the member it fills. */
#ifndef CLI_OPTIONS_H
#define CLI_OPTIONS_H

#include "base/status.h"
#include "export/export.h"
#include "scenario/scenario.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum OptionKind {
    OPTION_FLAG,     /* bool */
    OPTION_TEXT,     /* const char * */
    OPTION_INPUT,    /* the same: a file that is read */
    OPTION_COUNT,    /* long, 1 or more */
    OPTION_NUMBER,   /* double, in a range */
    OPTION_BYTES,    /* size_t: 4096, 64k, 256M, 2G */
    OPTION_SIZE,     /* int[2]: 80x24 */
    OPTION_WORD,     /* const char *, one of some words */
    OPTION_OVERRIDE, /* sets a key of the scenario: KEY=VALUE, or the value of a key */
    OPTION_LIST,     /* appends to an OptionList */
    OPTION_AXIS,     /* appends to the axes of a sweep */
} OptionKind;

typedef struct Option {
    const char *name;     /* "--set" */
    const char *argument; /* "KEY=VALUE"; NULL: it has none */
    const char *commands; /* those that take it, each between spaces; " open " is that without a word */
    const char *help;     /* one line */
    OptionKind kind;
    size_t offset;            /* of the member in Options */
    const char *const *words; /* OPTION_WORD; ended by NULL */
    const char *key;          /* OPTION_OVERRIDE: the key; NULL: the argument names it */
    int most;                 /* OPTION_SIZE: of each number */
    double range[2];          /* OPTION_NUMBER: both ends are allowed */
    const char *clears;       /* OPTION_OVERRIDE: a key that it resets, since both mean the same */
    char letter;              /* its short form, 'o' of -o; 0: it has none */
} Option;

extern const Option options_table[];
extern const int n_options;

/* Of --template; an array of each name in cli/diagnose.c holds its lines. */
#define TEMPLATE_LANGUAGES(EACH) EACH(python) EACH(matlab) EACH(fortran) EACH(julia)

enum { WORDS_MAX = 1024, OVERRIDES_MAX = 128, AXES_MAX = 16, OPTION_LIST_MAX = 4 };

/* What a sweep varies, as given. */
typedef struct SweepAxis {
    const char *origin; /* "--vary" or "--with" */
    const char *text;   /* KEY=A,B,C or KEY=LO:HI:N */
} SweepAxis;

/* What an option was given, each time. */
typedef struct OptionList {
    const char *texts[OPTION_LIST_MAX];
    int count;
} OptionList;

/* What a command line came to; what was not given is 0, or what is usual. */
typedef struct Options {
    const char *words[WORDS_MAX]; /* arguments that are not options */
    int n_words;
    char **arguments; /* all, as they were given */
    int n_arguments;
    bool full, list, bare;

    Override overrides[OVERRIDES_MAX];
    int n_overrides;
    char keys[OVERRIDES_MAX][KEY_MAX]; /* where the keys of --set are kept */
    long steps;                        /* --steps */
    long threads;

    Outputs outputs; /* its dialect and force are filled in by options_parse() */
    const char *dialect, *vtk_data, *stages;
    bool force, quiet;

    SweepAxis axes[AXES_MAX]; /* --vary and --with, in their order */
    int n_axes;
    const char *output;
    const char *view;
    OptionList against;
    const char *data, *sought, *column, *figure; /* of a fit */
    const char *map;                             /* of a diagnosis */
    bool pairs;                                  /* likewise */
    const char *time_bound, *template;           /* likewise */
    bool json;
    double seconds, pitch;             /* of a sound */
    double fps, speed, idle, from, to; /* of a film */
    double limit;                      /* of a session, s */

    const char *name, *id, *handout, *moodle, *roster, *sheet; /* of homework */
    bool key, print, bom;

    bool paused, no_mouse, last, fast, plain;
    const char *record, *replay;
    const char *glyphs, *theme, *script, *screen_sheet;
    size_t history;
    int size[2];
} Options;

/* Whether an argument is --help or -h. */
bool options_asks_help(const char *argument);

/* False: the option of that command, or the word in place of a command ("command"), is one that went or
 * stands elsewhere now; the status says where. */
bool options_stand(const char *command, const char *name, Status *);

/* Reads the arguments of a command ("open": the laboratory). False: the status says which is wrong and what
 * is allowed. */
bool options_parse(const char *command, int count, char **arguments, Options *, Status *);

/* The usual check after it: the number of words, `least` to `most`; `expected` names them ("SCENARIO"). */
bool options_words(const Options *, int least, int most, const char *expected, Status *);

/* The settings of a scenario with all its options: --set, --end, --steps, --every, --frames, --at. */
bool options_load(const Options *, const char *scenario, Settings *, Status *);

/* An error from making the run gets the line or the option that gave the key which it names. */
void options_blame(const Options *, const char *scenario, Status *);

/* Prints the options of a command, a line each. */
void options_print(const char *command);
int options_count(const char *command);

#endif

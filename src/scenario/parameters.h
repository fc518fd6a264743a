/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parameter table: one row for each key of a scenario file that has a value. The scenario reader and
 * writer, --set, the fields on screen, `matvib params`, completion and the manual page read this table;
 * none repeats it. To add a parameter: a row in parameter_rows.inc and the member it fills in concern_*.h. */
#ifndef SCENARIO_PARAMETERS_H
#define SCENARIO_PARAMETERS_H

#include "problems/problem.h"
#include "scenario/rows/rows.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum ParameterType {
    PARAMETER_REAL,
    PARAMETER_INTEGER,
    PARAMETER_CHOICE, /* an enum; values are indices into choices */
    PARAMETER_FLAG,   /* a bool: yes | no */
    PARAMETER_TEXT
} ParameterType;

typedef enum Nudge {
    NUDGE_NONE,
    NUDGE_ONE,     /* +1, -1 */
    NUDGE_DOUBLE,  /* x2, /2 */
    NUDGE_1_2_5,   /* 1, 2, 5, 10, ...; 0 and then negative below the least rung, where these are allowed */
    NUDGE_SHARE,   /* 0, 0.1, 0.2, 0.5, 0.8, 0.9, ..., 0.999, 1: as fine at 1 as a share has to be */
    NUDGE_FIFTH,   /* +0.2, -0.2 */
    NUDGE_SPACING, /* one lattice spacing more or less: places and sizes of a beam */
    NUDGE_WIDE,    /* whole spacings, a fortieth of the body: seen in a map; finely one of them */
    NUDGE_NEXT     /* next choice */
} Nudge;

/* What a text may be; empty is always allowed. */
typedef enum TextRule {
    TEXT_ANY,
    TEXT_VIEW,       /* a view's digit, 1 to 9, or its word */
    TEXT_POSITIVE,   /* a number > 0 */
    TEXT_REFERENCES, /* one of parameter_reference_words */
    TEXT_SHEET,      /* one of parameter_sheet_words */
    TEXT_COLOUR      /* one of parameter_colour_words */
} TextRule;

/* Methods that read a parameter. */
enum { BY_EVERY_METHOD = 0, BY_MPM = 1 << METHOD_MPM, BY_PD = 1 << METHOD_PD };

typedef struct Parameter {
    const char *key;       /* "bar.youngs_modulus": section.key of the scenario file */
    int concern;           /* of the problems that have it: problems/problem.h; CONCERN_NONE: a text key */
    const char *group;     /* heading on screen: "Bar", "Start", "Mesh", "Method", "Time", ... */
    const char *label;     /* on screen, at most 15 columns: "Young's modulus" */
    const char *dimension; /* in units of one's own that fit each other: "force/area"; "" for a number */
    const char *unit;      /* SI: "Pa" */
    ParameterType type;
    size_t offset; /* of the member in Settings */
    size_t size;   /* of a text, in bytes */
    TextRule rule;
    const char *form;                /* what is allowed, in words */
    bool goes_on;                    /* in indented lines below */
    bool named;                      /* its values are known without its label: "USL" */
    double least, most;              /* inclusive range */
    bool above_least;                /* the least itself is not allowed */
    const char *const *choices;      /* ended by NULL */
    const char *(*choice_help)(int); /* a sentence for each of many but the first; NULL: help says it all */
    bool wrong;                      /* at work, the code is wrong in one place */
    const char *automatic;           /* a word that stands for 0, "auto"; NULL: none */
    double automatic_value;          /* it stands for this instead of 0 */
    Nudge nudge;
    bool live;                    /* may change in mid-run, */
    bool (*of_start)(int choice); /* but not from or to these, which hold from the start on; NULL: to all */
    int methods;                  /* that read it; 0: every one */
    bool stated; /* it is a part of the problem: at work, it is refused by a method that does not read it */
    const char *help; /* one line */
    double usual;     /* the default, where the problem has no other */
    double neutral;   /* the value at which it does nothing to the run, as if there were no such parameter */
    bool output;      /* about what is written of a run, not about the run */
    int n_choices;    /* parameter_in() says how many of its choices there are, the first ones, */
    const char *others; /* and of the others why not: "is for beams" */
} Parameter;

extern const Parameter parameters[];
extern const int n_parameters;

extern const char *const parameter_method_titles[]; /* on screen: "MPM" */

/* The words of view.references, ended by NULL. */
extern const char *const parameter_reference_words[];

/* The words of screen.sheet, ended by NULL, in the order of Sheet (panes/screen.h). */
extern const char *const parameter_sheet_words[];

/* The words of view.colour, ended by NULL, in the order in which the beam view goes through them. */
extern const char *const parameter_colour_words[];

/* Whether what is run with these settings has what the word stands for. */
bool parameter_colour_is_there(const Settings *, const char *word);

/* What one may look for as a parameter, but follows from the method: it has one value, and a reason. */
typedef struct FixedKey {
    const char *key;    /* "beam.poisson"; its end, "poisson", finds it too */
    int concern;        /* of the problems that have it */
    int methods;        /* by which it is fixed */
    const char *value;  /* "1/3" */
    const char *reason; /* why: the end of a sentence */
} FixedKey;

extern const FixedKey fixed_keys[]; /* ended by a NULL key */

/* The row of such a key for these settings; NULL: it is none. */
const FixedKey *fixed_key_find(const Settings *, const char *key);

/* "beam.poisson: is 1/3 here and cannot be set: why". */
void fixed_key_text(const FixedKey *, char *out, size_t size);

/* The row of a parameter; NULL: it is none. */
const Parameter *parameter_find(const char *key);

/* What it is called where no heading stands above it: "notch position" for a word alone, else its label. */
void parameter_name_alone(const Parameter *, char *out, size_t size);

/* Likewise of a text key: words of a scenario that are no parameters of its run, title, question, view. */
const Parameter *parameter_text_find(const char *key);

/* The key that is meant by its whole, by its end ("cell_size", "modulus") or by the words beside its field on
 * screen ("cell size"), among those that these settings have. False: there are several such, and the status
 * names them. What is called so nowhere is handed back as it is. */
bool settings_resolve_key(const Settings *, const char *words, char key[KEY_MAX], Status *);

/* The known key of this problem nearest to a wrong one, for "did you mean"; NULL: nothing is near. */
const char *parameter_nearest(const Problem *problem, const char *key);

/* The nearest of the words that are offered to a wrong one; NULL: none is near. */
typedef struct Nearest {
    const char *wrong, *word;
    size_t too_far;
} Nearest;

Nearest nearest_begin(const char *wrong);
void nearest_offer(Nearest *, const char *right);

/* The row as it is in this problem: with the default, help, choices, methods and word for automatic_value
 * that it has there, and for unit in the bar's consistent units a dimension; "": a number. */
Parameter parameter_in(const Parameter *, const Problem *);

/* Whether the problem has it, by any method. */
bool parameter_applies(const Parameter *, const Problem *);

/* Whether it may change in mid-run from one value to another. */
bool parameter_is_live(const Parameter *, double from, double to);

/* What a wrong code does in a run of these settings, from the start on or later: the choice's word, and its
 * row. NULL: nothing is wrong. */
const char *settings_mistake(const Settings *);

/* Refuses what is not for wrong codes: "KEY: WORD is a mistake, and WHAT". True: there is none. */
bool settings_refuse_mistake(const Settings *, const char *what, Status *);

/* Whether it differs from its neutral value, at which it does nothing. */
bool settings_are_at_work(const Settings *, const Parameter *);

/* Whether a run of these settings reads it: of their problem and of their method. */
bool parameter_applies_to(const Settings *, const Parameter *);

/* All values at the defaults of a problem, method as usual for it, texts empty. */
void settings_default(Settings *, const Problem *);

/* Sets one value from text as it is in a scenario file or after --set; parameters and text keys. False:
 * unknown key (with the nearest one), not used by this problem or its method, not a number, out of range: the
 * status's text is "KEY: what is wrong (what is allowed)", and nothing is changed. */
bool settings_set(Settings *, const char *key, const char *text, Status *);

/* The same where the whole makes sense with it. False: nothing is changed. */
bool settings_change(Settings *, const char *key, const char *text, Status *);

/* Sets the method alone, where it is among the keys: which of the others there are depends on it, so it comes
 * first wherever it stands. A mistake that this method does not know is none. */
bool settings_set_method(Settings *, const Assignment *keys, int n_keys, Status *);

/* Puts a number that is known to be allowed. */
void settings_put(Settings *, const Parameter *, double value);
bool settings_in_range(const Parameter *, const Problem *, double value);

/* The value as text that settings_set() reads back to the same value. */
void settings_get(const Settings *, const Parameter *, char out[LIST_MAX]);

/* The same for reading: at most six digits. */
void settings_show(const Settings *, const Parameter *, char out[LIST_MAX]);

/* The value as number: index for a choice, 0 or 1 for a flag; NAN for a text. */
double settings_number(const Settings *, const Parameter *);

/* The next value upwards (+1) or downwards (-1) by the parameter's nudge, kept in its range and such that
 * settings_check() allows it; a fine one goes by the second digit, a tenth of a spacing, a cell more or less.
 * False: there is none, nothing is changed; `why` (or NULL) has text where the nearest value is not allowed.
 */
bool settings_nudge(Settings *, const Parameter *, int direction, bool fine, Status *why);

/* The same for a value of rows: places by spacings, numbers up and down the ladder 1, 2, 5. */
bool settings_row_nudge(Settings *, const RowPlace *, int direction, bool fine);

/* What screen.ask names of what there is, in its order, or, where the scenario names none, what its question
 * and the usual ones are. Returns how many. False of the second: a word of the list is not a parameter of the
 * problem and no row of the scenario, or there are too many; the status says which. */
enum { ASKED_MAX = 4 };
typedef struct Asked {
    const Parameter *parameter; /* NULL: rows of a plate, or a value of theirs */
    RowPlace place;
} Asked;
int settings_asked(const Settings *, Asked out[ASKED_MAX]);

/* What a scenario asks about: its question.key, or what its method leaves open. NULL: nothing. */
const Parameter *settings_question(const Settings *);

/* Whether it is a size of a mesh or lattice: it is asked about by a smaller one. */
bool parameter_is_size(const Parameter *);

/* Whether a scenario can ask about it: it has choices, or it is a size of the mesh or lattice. */
bool parameter_can_be_asked(const Parameter *, const Problem *);

/* To the other answer to a question: what can be left out ("none") is taken away and put back, a size goes
 * one rung down from the usual one or back to it, of other things the next value is taken. False: there is
 * none. */
bool settings_answer_otherwise(Settings *, const Parameter *);

/* What is allowed, in words: "> 0", "1 to 8", "usf | usl | musl". */
void parameter_range(const Parameter *, const Problem *, char *out, size_t size);

/* What no single value shows: critical stretch and energy both given, notch outside the beam, load off the
 * beam, overtones that cannot be read, mode 0 with a fixed end, ... The status names the key.
 *
 * Asked by what makes settings: scenario_read(), settings_change(), settings_nudge(), changes_add(), and once
 * more by changes_advice(), since what is in force in mid-run may be no scenario; by nobody who takes it. */
bool settings_check(const Settings *, Status *);

/* Whether two settings lead to the same run. */
bool settings_same(const Settings *a, const Settings *b);
/* Whether they write the same of a run. */
bool settings_output_same(const Settings *a, const Settings *b);

/* Whether a parameter of both has another value, as a file would have it. */
bool settings_differ(const Settings *a, const Settings *b, const Parameter *);

/* What `a` is as against `b`, for a legend: "USL, cell size 1"; "the same" where nothing differs. What does
 * not fit whole is left out, and " ..." says so. */
void settings_name(const Settings *a, const Settings *b, char *out, size_t size);

/* What a change of settings did: "cell size 0.25 -> 0.5, USF -> USL". */
void settings_name_change(const Settings *from, const Settings *to, char *out, size_t size);

/* A value as a title or legend spells it: "USL", "hat", "0.5". */
void settings_spell(const Settings *, const Parameter *, char out[LIST_MAX]);

/* Two sets of settings as against what somebody was to change; how they compare as a whole is in
 * parameters.h. */

/* Whether they differ in anything but the keys that are allowed; then `key` is the first of it. A key of a
 * row allows all rows. What a run writes does not count. */
bool settings_differ_beyond(const Settings *a, const Settings *b, const char (*allowed)[KEY_MAX],
                            int n_allowed, char key[KEY_MAX]);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command table: one row for each thing that a user can ask for. The key map, the key line, the help
 * screen, the `:` line, the script player and the manual page read it. To add a command: one row in
 * command_rows.inc and the function that it names, in src/lab/commands; a word of the `:` line that
 * takes arguments: one row in line_rows.inc and the function that it names, in src/lab/prompt/line.c.
 */
#ifndef HELP_COMMAND_H
#define HELP_COMMAND_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define COMMAND(id, ...) COMMAND_##id,
#define DIGIT(n)         COMMAND_VIEW_##n,
typedef enum CommandId {
    COMMAND_NONE,
#include "help/command_rows.inc"
    COMMAND_COUNT
} CommandId;
#undef COMMAND
#undef DIGIT

/* Who may ask for it: a lesson as well as the user, or the user alone. */
enum { BY_USER = false, BY_LESSON = true };

typedef struct Command {
    CommandId id;
    const char *name;  /* "run-pause": for scripts and the `:` line */
    const char *keys;  /* names separated by spaces: "Space", "] s", "Home 0", "^R", "F1 ?" */
    const char *group; /* heading in the help: "Time", "Stages", "Views", ... */
    const char *brief; /* at most 8 columns, for the key line: "pause"; NULL: see pane_command_brief() */
    const char *help;  /* one line; NULL: see pane_command_help() */
    bool lesson; /* a lesson may ask for it: it changes the laboratory, and opens no question to write */
} Command;

/* What an argument of a line verb is, for completion. */
typedef enum LineArgument {
    ARGUMENT_OTHER,
    ARGUMENT_KEY,
    ARGUMENT_KEYS,     /* KEY=VALUE, several of them */
    ARGUMENT_KEY_LIST, /* KEY,KEY,... */
    ARGUMENT_SCENARIO,
    ARGUMENT_FILE,
    ARGUMENT_SERIES, /* a file, rather one of CSV */
    ARGUMENT_VIEW,
    ARGUMENT_TELL,   /* a view or a part of the screen */
    ARGUMENT_FIGURE, /* a view if one likes, then a file */
    ARGUMENT_REFERENCES,
    ARGUMENT_SHEET,
    ARGUMENT_LESSON,
    ARGUMENT_STOP,
    ARGUMENT_FIELD /* of one thing */
} LineArgument;

#define LINE(id, ...) LINE_##id,
typedef enum LineVerbId {
#include "help/line_rows.inc"
    LINE_COUNT
} LineVerbId;
#undef LINE

/* A word of the `:` line that takes arguments. A command of the same name is what it is without them. */
typedef struct LineVerb {
    LineVerbId id;
    const char *name;
    const char *arguments; /* "FILE.csv [X Y]", for the help */
    LineArgument argument;
    const char *help; /* one line */
    bool lesson;      /* as of a command */
} LineVerb;

extern const LineVerb line_verbs[];
extern const int n_line_verbs;

/* The verb whose name these bytes are; NULL: none. */
const LineVerb *line_verb_find(const char *word, size_t length);

/* What a line means: LINE_VERB with what stands behind it, LINE_COMMAND, KEY=VALUE, a time or #STEP. */
typedef struct LineMeaning {
    enum { LINE_UNKNOWN, LINE_VERB, LINE_COMMAND, LINE_ASSIGNMENT, LINE_PLACE } kind;
    const LineVerb *verb;
    const Command *command;
    const char *words; /* behind the first */
} LineMeaning;

LineMeaning line_meaning(const char *text);

/* Whether a lesson may have this line done; a LessonJudge. */
bool command_line_for_lessons(const char *text, Status *);

extern const Command commands[];
extern const int n_commands;

/* Which commands, of any number; there is room for one more than the table has. */
typedef struct CommandSet {
    uint64_t words[COMMAND_COUNT / 64 + 1];
} CommandSet;

void command_set_add(CommandSet *, CommandId);
bool command_set_has(const CommandSet *, CommandId);

/* The digit of a command that shows a view, 1 to 9; 0: it is another one. */
int command_digit(CommandId);
CommandId command_of_digit(int digit);

const Command *command_find(CommandId id);
const Command *command_by_name(const char *name);
const Command *command_by_key(const char *key);

enum { COMMAND_KEY_MAX = 12 };
void command_first_key(const Command *, char out[COMMAND_KEY_MAX]); /* the key that is shown: "Space" */

#endif

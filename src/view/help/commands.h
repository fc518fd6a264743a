/* The command table: one row for each thing that a user can ask for. The key map, the bottom bar, the help
 * screen, the `:` line, the script player and the manual page read it. To add a command: one row here and one
 * function where the laboratory carries commands out. */
#ifndef VIEW_COMMANDS_H
#define VIEW_COMMANDS_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum CommandId {
    COMMAND_NONE,
    COMMAND_RUN_PAUSE,
    COMMAND_STEP_FORWARD,
    COMMAND_STEP_BACK,
    COMMAND_STEP_FORWARD_TEN,
    COMMAND_STEP_BACK_TEN,
    COMMAND_STAGE_FORWARD,
    COMMAND_STAGE_BACK,
    COMMAND_FASTER,
    COMMAND_SLOWER,
    COMMAND_START,  /* t = 0 */
    COMMAND_NEWEST, /* the newest time */
    COMMAND_GO_TO,
    COMMAND_RESTART,
    COMMAND_NEXT_PANE,
    COMMAND_PREVIOUS_PANE,
    COMMAND_UP,
    COMMAND_DOWN,
    COMMAND_LEFT,
    COMMAND_RIGHT,
    COMMAND_PAGE_UP,
    COMMAND_PAGE_DOWN,
    COMMAND_ENTER,
    COMMAND_CANCEL,
    COMMAND_UNDO,
    COMMAND_REDO,
    COMMAND_VIEW_1, /* to COMMAND_VIEW_9, the digits: whichever view has it as its own */
    COMMAND_VIEW_2,
    COMMAND_VIEW_3,
    COMMAND_VIEW_4,
    COMMAND_VIEW_5,
    COMMAND_VIEW_6,
    COMMAND_VIEW_7,
    COMMAND_VIEW_8,
    COMMAND_VIEW_9,
    COMMAND_ZOOM,
    COMMAND_NARROWER,
    COMMAND_WIDER,
    COMMAND_AUTOMATIC,
    COMMAND_REFERENCES,
    COMMAND_QUESTION,
    COMMAND_PIN,
    COMMAND_DUEL,
    COMMAND_BOOKMARK,
    COMMAND_JUMP,
    COMMAND_LESSONS,
    COMMAND_EXPORT,
    COMMAND_OPEN,
    COMMAND_WRITE,
    COMMAND_LINE,
    COMMAND_HELP,
    COMMAND_INSPECT,
    COMMAND_GLYPHS,
    COMMAND_ZOOM_2D,
    COMMAND_LECTURE,
    COMMAND_FILTER,
    COMMAND_QUIT,
    COMMAND_INTERRUPT, /* ^C: cancel long work, then quit */
    COMMAND_REDRAW,
    COMMAND_SUSPEND,
    COMMAND_COUNT
} CommandId;

typedef struct Command {
    CommandId id;
    const char *name;  /* "run-pause": for scripts and the `:` line */
    const char *keys;  /* names separated by spaces: "Space", "] s", "Home 0", "^R", "F1 ?" */
    const char *group; /* heading in the help: "Time", "Stages", "Views", ... */
    const char *brief; /* at most 8 columns, for the bottom bar: "pause"; NULL: see command_brief() */
    const char *help;  /* one line; NULL: see command_help() */
    bool lesson; /* a lesson may ask for it: it changes the laboratory, and opens no question to write */
} Command;

/* What an argument of a line verb is, for completion. */
typedef enum LineArgument {
    ARGUMENT_OTHER,
    ARGUMENT_KEY,
    ARGUMENT_KEYS, /* KEY=VALUE, several of them */
    ARGUMENT_SCENARIO,
    ARGUMENT_FILE,
    ARGUMENT_SERIES, /* a file, rather one of CSV */
    ARGUMENT_VIEW,
    ARGUMENT_REFERENCES,
    ARGUMENT_LESSON
} LineArgument;

typedef enum LineVerbId {
    LINE_SET,
    LINE_OPEN,
    LINE_WRITE,
    LINE_EXPORT,
    LINE_FIGURE,
    LINE_GO_TO,
    LINE_DUEL,
    LINE_OVERLAY,
    LINE_SHOW,
    LINE_REFERENCES,
    LINE_PARTICLE,
    LINE_LESSON,
    LINE_COUNT
} LineVerbId;

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
bool line_is_for_lessons(const char *text, Status *);

/* Only commands that work stand in it: a row and the function that carries it out land together. */
extern const Command commands[];
extern const int n_commands;

/* The digit of a command that shows a view, 1 to 9; 0: it is another one. */
int command_digit(CommandId);
CommandId command_of_digit(int digit);

/* What the bar and the help say of a command: of a digit, what its view says. NULL: no view has it. */
const char *command_brief(const Command *);
const char *command_help(const Command *);

const Command *command_find(CommandId id);
const Command *command_by_name(const char *name);
const Command *command_by_key(const char *key);

enum { COMMAND_KEY_MAX = 12 };
void command_first_key(const Command *, char out[COMMAND_KEY_MAX]); /* the key that is shown: "Space" */

#endif

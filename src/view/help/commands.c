/* The rows of the command table and of the words of the `:` line, and how one is found by id, name or key. */
#include "view/help/commands.h"

#include "base/text.h"

#include <stddef.h>
#include <string.h>

/* Who may ask: LESSON stands for a lesson and the user, USER for the user alone. */
enum { USER = false, LESSON = true };

const Command commands[] = {
    {COMMAND_RUN_PAUSE, "run-pause", "Space", "Time", "run", "run or pause; at the end: from t = 0 again",
     LESSON},
    {COMMAND_STEP_FORWARD, "step", ".", "Time", "step", "finish this time step, or do the next one", LESSON},
    {COMMAND_STEP_BACK, "step-back", ",", "Time", "back", "one time step back", LESSON},
    {COMMAND_STEP_FORWARD_TEN, "step-ten", ">", "Time", "+10", "ten time steps forward", LESSON},
    {COMMAND_STEP_BACK_TEN, "step-back-ten", "<", "Time", "-10", "ten time steps back", LESSON},
    {COMMAND_STAGE_FORWARD, "stage", "] s", "Time", "stage", "the next stage of the time step only", LESSON},
    {COMMAND_STAGE_BACK, "stage-back", "[ S", "Time", "undo", "one stage back", LESSON},
    {COMMAND_FASTER, "faster", "+ =", "Time", "faster",
     "more steps a picture: 1, 2, 5, 10, ... (at first what fits)", LESSON},
    {COMMAND_SLOWER, "slower", "-", "Time", "slower", "fewer steps for each picture", LESSON},
    {COMMAND_START, "start", "0 Home", "Time", "t=0", "to t = 0; what has been computed is kept", LESSON},
    {COMMAND_NEWEST, "newest", "$ End", "Time", "newest", "to the newest time computed", LESSON},
    {COMMAND_GO_TO, "go", "g", "Time", "go to", "to a time (12.5) or a step (#1250)", USER},
    {COMMAND_BOOKMARK, "bookmark", "m", "Time", "mark",
     "remember this place in the run; on such a place: forget it", LESSON},
    {COMMAND_JUMP, "jump", "'", "Time", "jump", "to the next place that m remembers", LESSON},
    {COMMAND_RESTART, "restart", "r", "Time", "restart", "begin anew at t = 0 with these parameters", LESSON},

    {COMMAND_NEXT_PANE, "next-pane", "Tab", "Panes", "pane", "to the next pane", LESSON},
    {COMMAND_PREVIOUS_PANE, "previous-pane", "S-Tab", "Panes", "pane", "to the previous pane", LESSON},
    {COMMAND_UP, "up", "Up k", "Panes", "up", "up in a list; previous row of a table", LESSON},
    {COMMAND_DOWN, "down", "Down j", "Panes", "down", "down in a list; next row of a table", LESSON},
    {COMMAND_LEFT, "left", "Left h", "Panes", "less",
     "smaller value or previous choice; particle to the left; cursor back in a time plot", LESSON},
    {COMMAND_RIGHT, "right", "Right l", "Panes", "more",
     "larger value or next choice; particle to the right; cursor on in a time plot", LESSON},
    {COMMAND_PAGE_UP, "page-up", "PageUp", "Panes", "page up", "one page up", LESSON},
    {COMMAND_PAGE_DOWN, "page-down", "PageDown", "Panes", "page dn", "one page down", LESSON},
    {COMMAND_INSPECT, "inspect", "i", "Panes", "inspect",
     "the chosen particle or node: what it gives and takes; arrows: the next one", LESSON},
    {COMMAND_ZOOM, "zoom", "z", "Panes", "zoom", "the pane fills the screen; again: back", LESSON},

    {COMMAND_ENTER, "enter", "Enter", "Parameters", "edit", "edit the parameter, take what was typed", USER},
    {COMMAND_CANCEL, "cancel", "Esc", "Parameters", "cancel", "leave the field, the question or the help",
     USER},
    {COMMAND_UNDO, "undo", "u", "Parameters", "undo", "take the last change of a parameter back", LESSON},
    {COMMAND_REDO, "redo", "^R", "Parameters", "redo", "make it again", LESSON},
    {COMMAND_QUESTION, "question", "t", "Parameters", "try",
     "toggle what this scenario asks about; the old curve stays", LESSON},
    {COMMAND_FILTER, "filter", "/", "Parameters", "filter", "show only parameters whose name holds a text",
     USER},

    {COMMAND_VIEW_1, "view-1", "1", "Views", NULL, NULL, LESSON},
    {COMMAND_VIEW_2, "view-2", "2", "Views", NULL, NULL, LESSON},
    {COMMAND_VIEW_3, "view-3", "3", "Views", NULL, NULL, LESSON},
    {COMMAND_VIEW_4, "view-4", "4", "Views", NULL, NULL, LESSON},
    {COMMAND_VIEW_5, "view-5", "5", "Views", NULL, NULL, LESSON},
    {COMMAND_VIEW_6, "view-6", "6", "Views", NULL, NULL, LESSON},
    {COMMAND_VIEW_7, "view-7", "7", "Views", NULL, NULL, LESSON},
    {COMMAND_VIEW_8, "view-8", "8", "Views", NULL, NULL, LESSON},
    {COMMAND_VIEW_9, "view-9", "9", "Views", NULL, NULL, LESSON},
    {COMMAND_ZOOM_2D, "map-zoom", "Z", "Views", "magnify",
     "magnify the map of a beam: arrows move, + and - size, Esc shows the whole", LESSON},
    {COMMAND_REFERENCES, "references", "e", "Views", "curves",
     "reference curves and numbers: all, exact, predicted, none", LESSON},
    {COMMAND_PIN, "pin", "c", "Views", "pin", "keep these curves behind the next run; again: let them go",
     LESSON},
    {COMMAND_DUEL, "duel", "d", "Views", "duel",
     "a second run beside, with what the scenario changes; again: it ends, its curve stays", LESSON},
    {COMMAND_NARROWER, "narrower", "n", "Views", "narrow",
     "a shorter time window; in the map of a beam: displacements drawn smaller", LESSON},
    {COMMAND_WIDER, "wider", "N", "Views", "wide",
     "a longer time window; in the map: displacements drawn larger", LESSON},
    {COMMAND_AUTOMATIC, "automatic", "a", "Views", "auto",
     "the time window, or the size of displacements, as matvib likes", LESSON},
    {COMMAND_LECTURE, "lecture", "L", "Views", "large",
     "time and state in large letters, thick curves, little else; again: as before", LESSON},
    {COMMAND_GLYPHS, "glyphs", "G", "Views", "glyphs", "draw with braille, blocks or ASCII", USER},

    {COMMAND_EXPORT, "export", "x", "Files", "export",
     "write the run as CSV, or the focused view as a figure", USER},
    {COMMAND_OPEN, "open", "o", "Files", "open", "open a scenario: from a list with titles, by name or path",
     USER},
    {COMMAND_WRITE, "write", "w", "Files", "write", "write these parameters as a scenario file", USER},

    {COMMAND_LINE, "line", ":", "Program", "command", "a command by name, KEY=VALUE, a time; Tab completes",
     USER},
    {COMMAND_LESSONS, "lessons", "T", "Program", "lessons",
     "lessons beside the run; PageUp and PageDown turn their pages", USER},
    {COMMAND_HELP, "help", "? F1", "Program", "help", "this help; Left and Right turn its pages", USER},
    {COMMAND_REDRAW, "redraw", "^L", "Program", "redraw", "draw the screen anew", USER},
    {COMMAND_SUSPEND, "suspend", "^Z", "Program", "suspend", "back to the shell; fg returns", USER},
    {COMMAND_INTERRUPT, "interrupt", "^C", "Program", "stop", "stop long work, then quit", USER},
    {COMMAND_QUIT, "quit", "q F10", "Program", "quit", "close what is open, then quit", USER},
};

const int n_commands = sizeof commands / sizeof *commands;

const LineVerb line_verbs[] = {
    {LINE_SET, "set", "KEY VALUE", ARGUMENT_KEY, "a parameter, as KEY=VALUE does without the word set",
     LESSON},
    {LINE_OPEN, "open", "SCENARIO", ARGUMENT_SCENARIO,
     "open a scenario: from a list with titles, by name or path", LESSON},
    {LINE_WRITE, "write", "FILE", ARGUMENT_FILE, "write these parameters as a scenario file", USER},
    {LINE_EXPORT, "export", "NAME", ARGUMENT_OTHER, "write the run as NAME-series.csv and its tables", USER},
    {LINE_FIGURE, "figure", "FILE", ARGUMENT_FILE, "draw the focused view as FILE.svg, FILE.pdf or FILE.png",
     USER},
    {LINE_GO_TO, "goto", "TIME or #STEP", ARGUMENT_OTHER, "to a time, as the number alone does, or a step",
     LESSON},
    {LINE_DUEL, "duel", "KEY=VALUE ...", ARGUMENT_KEYS,
     "a second run beside that differs in these keys, in place of one that there is", LESSON},
    {LINE_SHOW, "show", "VIEW [VARIANT]", ARGUMENT_VIEW,
     "a view by its word or digit, and which of its variants", LESSON},
    {LINE_REFERENCES, "references", "all|exact|predicted|none", ARGUMENT_REFERENCES, "which reference curves",
     LESSON},
    {LINE_PARTICLE, "particle", "NUMBER", ARGUMENT_OTHER, "choose a particle", LESSON},
    {LINE_LESSON, "lesson", "NAME", ARGUMENT_LESSON, "open a lesson", USER},
    {LINE_OVERLAY, "overlay", "FILE.csv [X Y]", ARGUMENT_SERIES,
     "draw a foreign series over the plots, columns by name or number; alone: take it away", LESSON},
};

const int n_line_verbs = sizeof line_verbs / sizeof *line_verbs;

const LineVerb *line_verb_find(const char *word, size_t length)
{
    for (int i = 0; i < n_line_verbs; i++)
        if (strlen(line_verbs[i].name) == length && memcmp(line_verbs[i].name, word, length) == 0)
            return &line_verbs[i];
    return NULL;
}

int command_digit(CommandId id)
{
    return id >= COMMAND_VIEW_1 && id <= COMMAND_VIEW_9 ? (int)(id - COMMAND_VIEW_1) + 1 : 0;
}

CommandId command_of_digit(int digit)
{
    return digit >= 1 && digit <= 9 ? (CommandId)(COMMAND_VIEW_1 + digit - 1) : COMMAND_NONE;
}

const Command *command_find(CommandId id)
{
    for (int i = 0; i < n_commands; i++)
        if (commands[i].id == id)
            return &commands[i];
    return NULL;
}

const Command *command_by_name(const char *name)
{
    for (int i = 0; i < n_commands; i++)
        if (strcmp(commands[i].name, name) == 0)
            return &commands[i];
    return NULL;
}

const Command *command_by_key(const char *key)
{
    const size_t length = strlen(key);
    if (length == 0 || strchr(key, ' '))
        return NULL;
    for (int i = 0; i < n_commands; i++)
        for (const char *here = commands[i].keys; *here != '\0';) {
            size_t word = strcspn(here, " ");
            if (word == length && memcmp(here, key, length) == 0)
                return &commands[i];
            here += word;
            here += *here == ' ';
        }
    return NULL;
}

LineMeaning line_meaning(const char *text)
{
    const size_t length = strcspn(text, " ");
    const char *words = text + length + strspn(text + length, " ");
    const LineVerb *verb = line_verb_find(text, length);
    const Command *command = command_by_name(text);
    double time;
    LineMeaning line = {.words = words};
    if (verb && (*words || !command))
        line = (LineMeaning){.kind = LINE_VERB, .verb = verb, .words = words};
    else if (command)
        line = (LineMeaning){.kind = LINE_COMMAND, .command = command, .words = words};
    else if (strchr(text, '='))
        line.kind = LINE_ASSIGNMENT;
    else if (text[0] == '#' || text_to_double(text, &time))
        line.kind = LINE_PLACE;
    return line;
}

bool line_is_for_lessons(const char *text, Status *status)
{
    const LineMeaning line = line_meaning(text);
    const char *name = line.verb ? line.verb->name : line.command ? line.command->name : text;
    if (line.kind == LINE_UNKNOWN)
        return status_fail(status, STATUS_USAGE, "%.40s: unknown (a command, KEY=VALUE or a time is wanted)",
                           name);
    if ((line.verb && !line.verb->lesson) || (line.command && !line.command->lesson))
        return status_fail(status, STATUS_USAGE, "%s: a lesson may not (it changes the laboratory only)",
                           name);
    return true;
}

void command_first_key(const Command *command, char out[COMMAND_KEY_MAX])
{
    size_t word = strcspn(command->keys, " ");
    word = word < COMMAND_KEY_MAX - 1 ? word : COMMAND_KEY_MAX - 1;
    memcpy(out, command->keys, word);
    out[word] = '\0';
}

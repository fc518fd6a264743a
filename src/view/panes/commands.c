#include "view/panes/commands.h"

#include <stddef.h>
#include <string.h>

const Command commands[] = {
    {COMMAND_RUN_PAUSE, "run-pause", "Space", "Time", "run", "run or pause; at the end: from t = 0 again"},
    {COMMAND_STEP_FORWARD, "step", ".", "Time", "step", "finish this time step, or do the next one"},
    {COMMAND_STEP_BACK, "step-back", ",", "Time", "back", "one time step back"},
    {COMMAND_STEP_FORWARD_TEN, "step-ten", ">", "Time", "+10", "ten time steps forward"},
    {COMMAND_STEP_BACK_TEN, "step-back-ten", "<", "Time", "-10", "ten time steps back"},
    {COMMAND_STAGE_FORWARD, "stage", "] s", "Time", "stage", "the next stage of the time step only"},
    {COMMAND_STAGE_BACK, "stage-back", "[ S", "Time", "undo", "one stage back"},
    {COMMAND_FASTER, "faster", "+ =", "Time", "faster",
     "more steps a picture: 1, 2, 5, 10, ... (at first what fits)"},
    {COMMAND_SLOWER, "slower", "-", "Time", "slower", "fewer steps for each picture"},
    {COMMAND_START, "start", "0 Home", "Time", "t=0", "to t = 0; what has been computed is kept"},
    {COMMAND_NEWEST, "newest", "$ End", "Time", "newest", "to the newest time computed"},
    {COMMAND_GO_TO, "go", "g", "Time", "go to", "to a time (12.5) or a step (#1250)"},
    {COMMAND_BOOKMARK, "bookmark", "m", "Time", "mark",
     "remember this place in the run; on such a place: forget it"},
    {COMMAND_JUMP, "jump", "'", "Time", "jump", "to the next place that m remembers"},
    {COMMAND_RESTART, "restart", "r", "Time", "restart", "begin anew at t = 0 with these parameters"},

    {COMMAND_NEXT_PANE, "next-pane", "Tab", "Panes", "pane", "to the next pane"},
    {COMMAND_PREVIOUS_PANE, "previous-pane", "S-Tab", "Panes", "pane", "to the previous pane"},
    {COMMAND_UP, "up", "Up k", "Panes", "up", "up in a list; previous row of a table"},
    {COMMAND_DOWN, "down", "Down j", "Panes", "down", "down in a list; next row of a table"},
    {COMMAND_LEFT, "left", "Left h", "Panes", "less",
     "smaller value or previous choice; particle to the left; cursor back in a time plot"},
    {COMMAND_RIGHT, "right", "Right l", "Panes", "more",
     "larger value or next choice; particle to the right; cursor on in a time plot"},
    {COMMAND_PAGE_UP, "page-up", "PageUp", "Panes", "page up", "one page up"},
    {COMMAND_PAGE_DOWN, "page-down", "PageDown", "Panes", "page dn", "one page down"},
    {COMMAND_INSPECT, "inspect", "i", "Panes", "inspect",
     "the chosen particle or node: what it gives and takes; arrows: the next one"},
    {COMMAND_ZOOM, "zoom", "z", "Panes", "zoom", "the pane fills the screen; again: back"},

    {COMMAND_ENTER, "enter", "Enter", "Parameters", "edit", "edit the parameter, take what was typed"},
    {COMMAND_CANCEL, "cancel", "Esc", "Parameters", "cancel", "leave the field, the question or the help"},
    {COMMAND_UNDO, "undo", "u", "Parameters", "undo", "take the last change of a parameter back"},
    {COMMAND_REDO, "redo", "^R", "Parameters", "redo", "make it again"},
    {COMMAND_QUESTION, "question", "t", "Parameters", "try",
     "toggle what this scenario asks about; the old curve stays"},
    {COMMAND_FILTER, "filter", "/", "Parameters", "filter", "show only parameters whose name holds a text"},

    {COMMAND_VIEW_1, "view-1", "1", "Views", "profile",
     "along the bar or beam: displacement; again: velocity, stress, a beam's section"},
    {COMMAND_VIEW_2, "view-2", "2", "Views", "v_cm",
     "the probe over time; again: its velocity, length, a crack's path and angle"},
    {COMMAND_VIEW_3, "view-3", "3", "Views", "energy",
     "energies: seen by the grid, hidden, strain, work; again: what a crack costs"},
    {COMMAND_VIEW_4, "view-4", "4", "Views", "shapes",
     "shape functions of the mesh and their slopes; beams: a bond's force and its cut"},
    {COMMAND_VIEW_5, "view-5", "5", "Views", "errors",
     "dispersion: the error of every mode of this mesh; beams: period over horizon"},
    {COMMAND_VIEW_6, "view-6", "6", "Views", "spectrum",
     "amplitude spectrum of the probe; again: all frequencies, logarithmic"},
    {COMMAND_VIEW_7, "view-7", "7", "Views", "tables", "numbers of particles; again: of nodes"},
    {COMMAND_VIEW_8, "view-8", "8", "Views", "beam",
     "the beam as it lies, coloured; again: by another field"},
    {COMMAND_VIEW_9, "view-9", "9", "Views", "log", "what happened, in words; Enter goes there"},
    {COMMAND_ZOOM_2D, "map-zoom", "Z", "Views", "magnify",
     "magnify the map of a beam: arrows move, + and - size, Esc shows the whole"},
    {COMMAND_REFERENCES, "references", "e", "Views", "curves",
     "reference curves and numbers: all, exact, predicted, none"},
    {COMMAND_PIN, "pin", "c", "Views", "pin", "keep these curves behind the next run; again: let them go"},
    {COMMAND_DUEL, "duel", "d", "Views", "duel",
     "a second run beside, with what the scenario changes; again: it ends, its curve stays"},
    {COMMAND_NARROWER, "narrower", "n", "Views", "narrow",
     "a shorter time window; in the map of a beam: displacements drawn smaller"},
    {COMMAND_WIDER, "wider", "N", "Views", "wide",
     "a longer time window; in the map: displacements drawn larger"},
    {COMMAND_AUTOMATIC, "automatic", "a", "Views", "auto",
     "the time window, or the size of displacements, as matvib likes"},
    {COMMAND_LECTURE, "lecture", "L", "Views", "large",
     "time and state in large letters, thick curves, little else; again: as before"},
    {COMMAND_GLYPHS, "glyphs", "G", "Views", "glyphs", "draw with braille, blocks or ASCII"},

    {COMMAND_EXPORT, "export", "x", "Files", "export",
     "write the run as CSV, or the focused view as a figure"},
    {COMMAND_OPEN, "open", "o", "Files", "open", "open a scenario: from a list with titles, by name or path"},
    {COMMAND_WRITE, "write", "w", "Files", "write", "write these parameters as a scenario file"},

    {COMMAND_LINE, "line", ":", "Program", "command", "a command by name, KEY=VALUE, a time; Tab completes"},
    {COMMAND_LESSONS, "lessons", "T", "Program", "lessons",
     "lessons beside the run; PageUp and PageDown turn their pages"},
    {COMMAND_HELP, "help", "? F1", "Program", "help", "this help; Left and Right turn its pages"},
    {COMMAND_REDRAW, "redraw", "^L", "Program", "redraw", "draw the screen anew"},
    {COMMAND_SUSPEND, "suspend", "^Z", "Program", "suspend", "back to the shell; fg returns"},
    {COMMAND_INTERRUPT, "interrupt", "^C", "Program", "stop", "stop long work, then quit"},
    {COMMAND_QUIT, "quit", "q F10", "Program", "quit", "close what is open, then quit"},
};

const int n_commands = sizeof commands / sizeof *commands;

const LineVerb line_verbs[] = {
    {LINE_SET, "set", "KEY VALUE", ARGUMENT_KEY, "a parameter, as KEY=VALUE does without the word set"},
    {LINE_OPEN, "open", "SCENARIO", ARGUMENT_SCENARIO,
     "open a scenario: from a list with titles, by name or path"},
    {LINE_WRITE, "write", "FILE", ARGUMENT_FILE, "write these parameters as a scenario file"},
    {LINE_EXPORT, "export", "NAME", ARGUMENT_OTHER, "write the run as NAME-series.csv and its tables"},
    {LINE_FIGURE, "figure", "FILE", ARGUMENT_FILE, "draw the focused view as FILE.svg, FILE.pdf or FILE.png"},
    {LINE_GO_TO, "goto", "TIME or #STEP", ARGUMENT_OTHER, "to a time, as the number alone does, or a step"},
    {LINE_DUEL, "duel", "KEY=VALUE ...", ARGUMENT_KEYS,
     "a second run beside that differs in these keys, in place of one that there is"},
    {LINE_SHOW, "show", "VIEW [VARIANT]", ARGUMENT_VIEW, "a view by its number, and which of its variants"},
    {LINE_REFERENCES, "references", "all|exact|predicted|none", ARGUMENT_REFERENCES,
     "which reference curves"},
    {LINE_PARTICLE, "particle", "NUMBER", ARGUMENT_OTHER, "choose a particle"},
    {LINE_LESSON, "lesson", "NAME", ARGUMENT_LESSON, "open a lesson"},
    {LINE_OVERLAY, "overlay", "FILE.csv [X Y]", ARGUMENT_SERIES,
     "draw a foreign series over the plots, columns by name or number; alone: take it away"},
};

const int n_line_verbs = sizeof line_verbs / sizeof *line_verbs;

const LineVerb *line_verb_find(const char *word, size_t length)
{
    for (int i = 0; i < n_line_verbs; i++)
        if (strlen(line_verbs[i].name) == length && memcmp(line_verbs[i].name, word, length) == 0)
            return &line_verbs[i];
    return NULL;
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

void command_first_key(const Command *command, char out[COMMAND_KEY_MAX])
{
    size_t word = strcspn(command->keys, " ");
    word = word < COMMAND_KEY_MAX - 1 ? word : COMMAND_KEY_MAX - 1;
    memcpy(out, command->keys, word);
    out[word] = '\0';
}

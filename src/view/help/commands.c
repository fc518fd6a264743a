/* The rows of the command table and of the words of the `:` line, and how one is found by id, name or key. */
#include "view/help/commands.h"

#include "base/text.h"

#include <stddef.h>
#include <string.h>

const LineVerb line_verbs[] = {
    {LINE_SET, "set", "KEY VALUE", ARGUMENT_KEY, "a parameter, as KEY=VALUE does without the word set",
     BY_LESSON},
    {LINE_OPEN, "open", "SCENARIO", ARGUMENT_SCENARIO,
     "open a scenario: from a list with titles, by name or path", BY_LESSON},
    {LINE_WRITE, "write", "FILE", ARGUMENT_FILE, "write these parameters as a scenario file", BY_USER},
    {LINE_EXPORT, "export", "NAME", ARGUMENT_OTHER, "write the run as NAME-series.csv and its tables",
     BY_USER},
    {LINE_FIGURE, "figure", "FILE", ARGUMENT_FILE, "draw the focused view as FILE.svg, FILE.pdf or FILE.png",
     BY_USER},
    {LINE_GO_TO, "goto", "TIME or #STEP", ARGUMENT_OTHER, "to a time, as the number alone does, or a step",
     BY_LESSON},
    {LINE_UNTIL, "until", "t TIME|#STEP|end|[first] crossing|break|event", ARGUMENT_STOP,
     "run, and pause there; first: the first one of the run, back to it where it has happened; alone: never "
     "mind",
     BY_LESSON},
    {LINE_EVENT, "event", "NUMBER", ARGUMENT_OTHER, "to an event of the log, counted from 1", BY_LESSON},
    {LINE_LOOP, "loop", "TIME TIME", ARGUMENT_OTHER,
     "run from one time to the other again and again; alone: no longer, or between the bookmarks", BY_LESSON},
    {LINE_DUEL, "duel", "KEY=VALUE ...", ARGUMENT_KEYS,
     "a second run beside that differs in these keys, in place of one that there is", BY_LESSON},
    {LINE_SHOW, "show", "VIEW [VARIANT]", ARGUMENT_VIEW,
     "a view by its word or digit, and which of its variants", BY_LESSON},
    {LINE_REFERENCES, "references", "all|exact|predicted|none", ARGUMENT_REFERENCES, "which reference curves",
     BY_LESSON},
    {LINE_PARTICLE, "particle", "NUMBER", ARGUMENT_OTHER, "choose a particle", BY_LESSON},
    {LINE_LESSON, "lesson", "NAME", ARGUMENT_LESSON, "open a lesson", BY_USER},
    {LINE_OVERLAY, "overlay", "FILE.csv [X Y]", ARGUMENT_SERIES,
     "draw a foreign series over the plots, columns by name or number; alone: take it away", BY_LESSON},
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

bool command_line_for_lessons(const char *text, Status *status)
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

void command_set_add(CommandSet *set, CommandId id)
{
    set->words[id / 64] |= (uint64_t)1 << id % 64;
}

bool command_set_has(const CommandSet *set, CommandId id)
{
    return (set->words[id / 64] >> id % 64 & 1) != 0;
}

void command_first_key(const Command *command, char out[COMMAND_KEY_MAX])
{
    size_t word = strcspn(command->keys, " ");
    word = word < COMMAND_KEY_MAX - 1 ? word : COMMAND_KEY_MAX - 1;
    memcpy(out, command->keys, word);
    out[word] = '\0';
}

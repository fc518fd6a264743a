/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of the command table and of the words of the `:` line, and how one is found by id, name or key. */
#include "help/command.h"

#include <ctype.h>
#include <stddef.h>
#include <string.h>

#define LINE(id, function, ...) {LINE_##id, __VA_ARGS__},
const LineVerb line_verbs[] = {
#include "help/line_rows.inc"
};
#undef LINE

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
    LineMeaning line = {.words = words};
    if (verb && (*words || !command))
        line = (LineMeaning){.kind = LINE_VERB, .verb = verb, .words = words};
    else if (command)
        line = (LineMeaning){.kind = LINE_COMMAND, .command = command, .words = words};
    else if (strchr(text, '='))
        line.kind = LINE_ASSIGNMENT;
    else if (text[0] == '#' || text[0] == '.' || isdigit((unsigned char)text[0]))
        line.kind = LINE_PLACE;
    return line;
}

bool command_line_for_lessons(const char *text, Status *status)
{
    const LineMeaning line = line_meaning(text);
    const char *name = line.verb ? line.verb->name : line.command ? line.command->name : text;
    if (line.kind == LINE_UNKNOWN)
        return status_refuse(status, "%.40s: unknown (a command, KEY=VALUE or a time is expected)", name);
    if ((line.verb && !line.verb->lesson) || (line.command && !line.command->lesson))
        return status_refuse(status, "%s: a lesson may not (it changes the laboratory only)", name);
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

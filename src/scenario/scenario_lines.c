/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads a scenario line by line (scenario_lines.h). */
#include "scenario/scenario_lines.h"

#include "base/input.h"
#include "base/visible.h"
#include "scenario/parameters.h"

#include <stdlib.h>
#include <string.h>

const char *const scenario_sections[] = {
    "scenario", "bar",      "bar2",     "beam",     "plate",     "domain", "bodies",  "material",
    "motion",   "initial",  "mesh",     "mpm",      "pd",        "cuts",   "notch",   "load",
    "contact",  "loads",    "supports", "impulses", "protected", "probe",  "damping", "time",
    "output",   "question", "duel",     "changes",  "view",      "screen", NULL,
};

typedef struct Reader {
    const char *file;
    Status *status;
    Entries *entries;
    char section[16];
    bool may_continue; /* the last key's value may go on */
} Reader;

static bool fail(Reader *reader, const char *what, const char *allowed)
{
    return status_refuse(reader->status, "%s:%d: %s (%s)", reader->file, reader->entries->lines, what,
                         allowed);
}

static bool fail_about(Reader *reader, const char *subject, const char *what)
{
    return status_refuse(reader->status, "%s:%d: %s: %s", reader->file, reader->entries->lines, subject,
                         what);
}

enum { RAW_MAX = 1000 }; /* bytes of a line with its comment */

static size_t word_length(const char *text)
{
    return strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.-");
}

bool scenario_looks_like_key(const char *text)
{
    char word[KEY_MAX];
    size_t n = word_length(text);
    snprintf(word, sizeof word, "%.*s", (int)n, text);
    if (!(n > 0 && text[n + strspn(text + n, " ")] == '='))
        return false;
    /* whether the word is a key, or one without its section */
    for (int i = 0; i < n_parameters; i++)
        if (strcmp(parameters[i].key, word) == 0 || strcmp(strchr(parameters[i].key, '.') + 1, word) == 0)
            return true;
    return strcmp(word, "problem") == 0 || strcmp(word, "method") == 0;
}

bool scenario_may_continue(const char *section, const char *name)
{
    char key[2 * KEY_MAX];
    snprintf(key, sizeof key, "%s.%s", section, name);
    const Parameter *text = parameter_text_find(key), *parameter = text ? text : parameter_find(key);
    return parameter && parameter->goes_on;
}

static bool accept_section(Reader *reader, const char *line)
{
    size_t n = word_length(line + 1);
    if (line[n + 1] != ']' || line[n + 2] != '\0')
        return fail(reader, "a section's line must be its name in brackets", "such as [mesh]");
    char name[KEY_MAX];
    snprintf(name, sizeof name, "%.*s", (int)n, line + 1);
    Nearest nearest = nearest_begin(name);
    for (const char *const *known = scenario_sections; *known; known++) {
        if (strcmp(*known, name) == 0) {
            strcpy(reader->section, name);
            reader->may_continue = false;
            return true;
        }
        nearest_offer(&nearest, *known);
    }
    char subject[KEY_MAX + 2], what[96];
    snprintf(subject, sizeof subject, "[%s]", name);
    snprintf(what, sizeof what,
             nearest.word ? "unknown section (did you mean [%s]?)" : "unknown section (see: man 5 matvib)",
             nearest.word);
    return fail_about(reader, subject, what);
}

static bool accept_key(Reader *reader, const char *line)
{
    size_t n = word_length(line);
    const char *equals = line + n + strspn(line + n, " ");
    if (n == 0 || *equals != '=')
        return fail(reader, "this is not a line of a scenario", "[SECTION], KEY = VALUE or # comment");
    char name[64];
    snprintf(name, sizeof name, "%.*s", (int)n, line);
    if (n >= KEY_MAX)
        return fail_about(reader, name, "unknown key (no key is that long)");
    if (!*reader->section)
        return fail_about(reader, name, "is before any section (begin with [scenario])");
    if (equals[1] == '#' || equals[1] == ';')
        return fail_about(reader, name,
                          "the value begins like a comment (a space before # or ; makes it one)");
    reader->may_continue = scenario_may_continue(reader->section, name);
    Entries *entries = reader->entries;
    if (entries->count == entries->room) {
        int room = entries->room ? 2 * entries->room : 32;
        Entry *all = realloc(entries->all, (size_t)room * sizeof *all);
        if (!all)
            return status_fail(reader->status, "not enough memory for %s", reader->file);
        entries->all = all;
        entries->room = room;
    }
    Entry *entry = &entries->all[entries->count++];
    memset(entry, 0, sizeof *entry);
    entry->line = entries->lines;
    snprintf(entry->section, sizeof entry->section, "%s", reader->section);
    snprintf(entry->name, sizeof entry->name, "%.*s", KEY_MAX - 1, name);
    snprintf(entry->value, sizeof entry->value, "%s", equals + 1 + strspn(equals + 1, " "));
    return true;
}

static bool accept_indented(Reader *reader, const char *text)
{
    if (scenario_looks_like_key(text)) {
        char name[64];
        snprintf(name, sizeof name, "%.*s", (int)word_length(text), text);
        return fail_about(reader, name, "is indented (keys begin in the first column)");
    }
    if (!reader->may_continue)
        return fail(reader, "the indented line continues nothing",
                    "only scenario.about, initial.overtones and output.at go on in the next line");
    /* Lines of a text are joined by a space, those of a list by nothing. */
    Entry *entry = &reader->entries->all[reader->entries->count - 1];
    size_t length = strlen(entry->value);
    bool list = strcmp(entry->name, "about") != 0;
    int n = snprintf(entry->value + length, sizeof entry->value - length, "%s%s", list || !length ? "" : " ",
                     text);
    if (n < 0 || (size_t)n >= sizeof entry->value - length)
        return fail_about(reader, entry->name, "is too long (at most 1023 bytes)");
    return true;
}

bool entries_read(Entries *entries, FILE *stream, const char *file, Status *status)
{
    *entries = (Entries){0};
    Reader reader = {.file = file, .status = status, .entries = entries};
    InputLines lines = {.stream = stream, .name = file};
    InputGot got;
    char raw[RAW_MAX + 1];
    while ((got = input_line(&lines, raw, sizeof raw, status)) == INPUT_LINE) {
        entries->lines = (int)lines.number;
        if (entries->lines > SCENARIO_LINES_MAX)
            return fail(&reader, "too many lines for a scenario", "at most 5000");
        /* a tab is as good as a space; anything else that is not text is refused */
        for (char *tab = raw; (tab = strchr(tab, '\t'));)
            *tab = ' ';
        if (!visible_is_clean(raw))
            return fail(&reader, "bytes that are not text", "UTF-8 without control characters");
        /* Cuts the comment and the spaces at the end. */
        for (char *c = raw; *c; c++)
            if ((*c == '#' || *c == ';') && (c == raw || c[-1] == ' ')) {
                *c = '\0';
                break;
            }
        size_t n = strlen(raw);
        while (n > 0 && raw[n - 1] == ' ')
            raw[--n] = '\0';
        if (n > SCENARIO_LINE_MAX)
            return fail(&reader, "the line is too long", "at most 190 bytes");
        if (n > 0 && !(*raw == ' '   ? accept_indented(&reader, raw + strspn(raw, " "))
                       : *raw == '[' ? accept_section(&reader, raw)
                                     : accept_key(&reader, raw)))
            return false;
    }
    if (got == INPUT_WRONG)
        return false;
    if (entries->count == 0)
        return status_refuse(status, "%s:1: holds no scenario (at least [scenario] and a key)", file);
    return true;
}

void entries_free(Entries *entries)
{
    free(entries->all);
    *entries = (Entries){0};
}

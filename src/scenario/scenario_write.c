/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Settings as a scenario file that reads back to the last bit. */
#include "scenario/scenario.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/settings.h"
#include "base/text.h"
#include "base/visible.h"
#include "scenario/parameters.h"
#include "scenario/scenario_lines.h"

#include <errno.h>
#include <string.h>

/* A text that the reader would cut: comment signs after a space or at the start, spaces at an end. */
static bool would_be_damaged(const char *text)
{
    size_t n = strlen(text);
    if (!visible_is_clean(text) || (n > 0 && (text[0] == ' ' || text[n - 1] == ' ')))
        return true;
    for (size_t i = 0; i < n; i++)
        if ((text[i] == '#' || text[i] == ';') && (i == 0 || text[i - 1] == ' '))
            return true;
    return false;
}

/* Whether a text may be cut before `next`: a text at a single space, a list behind a comma. */
static bool may_cut(const char *text, const char *next, bool list)
{
    if (next <= text || *next == ' ' || !*next)
        return false;
    if (list)
        return next[-1] == ',';
    return next[-1] == ' ' && next - 1 > text && next[-2] != ' ' && !scenario_looks_like_key(next);
}

/* How much of a text goes into one line: all of it, or up to the last place where it may be cut within
 * `width` (failing that within the line's limit); 0: nowhere. */
static size_t line_share(const char *text, size_t width, bool list)
{
    size_t most = SCENARIO_LINE_MAX - 16;
    if (strlen(text) <= width)
        return strlen(text);
    for (size_t n = width; n > 0; n--)
        if (may_cut(text, text + n, list))
            return n;
    for (size_t n = width; n <= most && text[n]; n++)
        if (may_cut(text, text + n, list))
            return n;
    return strlen(text) <= most ? strlen(text) : 0;
}

static bool write_text(FILE *stream, const char *section, const char *name, const char *text, Status *status)
{
    bool list = strcmp(name, "about") != 0, may_continue = scenario_may_continue(section, name);
    size_t room = SCENARIO_LINE_MAX - strlen(name) - 3;
    if (would_be_damaged(text) || (!may_continue && strlen(text) > room))
        return status_refuse(status,
                             "%s.%s: this text would not read back (one short line; no # or ; after a space)",
                             section, name);
    fprintf(stream, "%s =", name);
    const char *margin = " ";
    while (*text) {
        size_t share = may_continue ? line_share(text, 96, list) : strlen(text);
        if (share == 0)
            return status_refuse(status, "%s.%s: this text cannot be cut into lines (spaces, commas)",
                                 section, name);
        size_t shown = share;
        while (shown > 0 && text[shown - 1] == ' ')
            shown--;
        fprintf(stream, "%s%.*s\n", margin, (int)shown, text);
        text += share;
        margin = "    ";
        if (!*text)
            return true;
    }
    fputc('\n', stream);
    return true;
}

/* --- sections ------------------------------------------------------------------------------------- */

/* The name behind the dot if the key is of this section; NULL: it is not. */
static const char *name_in(const char *key, const char *section)
{
    size_t n = strlen(section);
    return strncmp(key, section, n) == 0 && key[n] == '.' ? key + n + 1 : NULL;
}

/* What follows from another value, as critical stretch and energy do, and the gap from the shape: written, it
 * would be given. */
static bool is_derived(const Settings *settings, const Parameter *parameter)
{
    return (strcmp(parameter->key, "pd.critical_stretch") == 0 && settings_bonds(settings)->energy_given) ||
           (strcmp(parameter->key, "pd.critical_energy") == 0 && !settings_bonds(settings)->energy_given) ||
           (strcmp(parameter->key, "contact.gap") == 0 && !settings_contact(settings)->gap_given);
}

static const char *text_of(const Settings *settings, const Parameter *parameter)
{
    return (const char *)settings + parameter->offset;
}

/* Problem and method are in every file, and so is a title that is empty. */
static bool is_of_method(const Parameter *parameter)
{
    return parameter->offset == offsetof(Settings, method);
}

static bool is_written(const Settings *settings, const Parameter *parameter)
{
    return parameter->concern == CONCERN_NONE
               ? *text_of(settings, parameter) || parameter->offset == offsetof(Settings, title)
               : is_of_method(parameter) || parameter_applies_to(settings, parameter);
}

static bool write_section(FILE *stream, const Settings *settings, const char *section, Status *status)
{
    for (int i = 0; i < n_parameters; i++) {
        const Parameter *parameter = &parameters[i];
        const char *name = name_in(parameter->key, section);
        char value[LIST_MAX];
        if (!name || !is_written(settings, parameter))
            continue;
        if (parameter->type == PARAMETER_TEXT) {
            if (!write_text(stream, section, name, text_of(settings, parameter), status))
                return false;
            continue;
        }
        if (is_of_method(parameter))
            fprintf(stream, "problem = %s\n", settings->problem->word);
        settings_get(settings, parameter, value);
        if (is_derived(settings, parameter))
            fprintf(stream, "# %s = %s%s%s\n", name, value, *parameter->unit ? " " : "", parameter->unit);
        else
            fprintf(stream, "%s =%s%s\n", name, *value ? " " : "", value);
    }
    const int kind = row_kind_find(section);
    if (kind >= 0 && settings_have_rows(settings, kind)) {
        /* The rows of a section, or the values of the one that has no name. */
        char text[ROW_TEXT_MAX], word[ROW_TEXT_MAX];
        for (int row = 0; row < settings->rows[kind].count; row++) {
            settings_row_get(settings, kind, row, text);
            const char *rest = text;
            if (!row_kinds[kind].usual)
                fprintf(stream, "%s = %s\n", settings->rows[kind].rows[row].name, text);
            else
                for (int i = 0; text_next_word(&rest, word, sizeof word); i++)
                    fprintf(stream, "%s = %s\n", row_kinds[kind].columns[i].word, word);
        }
    }
    for (int i = 0; strcmp(section, "duel") == 0 && i < settings->n_duel; i++)
        if (!write_text(stream, section, settings->duel[i].key, settings->duel[i].value, status))
            return false;
    for (int i = 0; strcmp(section, "changes") == 0 && i < settings->n_changes; i++)
        fprintf(stream, "%ld = %s=%s\n", settings->changes[i].step, settings->changes[i].to.key,
                settings->changes[i].to.value);
    return true;
}

static bool has_section(const Settings *settings, const char *section)
{
    if (strcmp(section, "duel") == 0)
        return settings->n_duel > 0;
    if (strcmp(section, "changes") == 0)
        return settings->n_changes > 0;
    const int kind = row_kind_find(section);
    if (kind >= 0 && settings->rows[kind].count > 0)
        return true;
    for (int i = 0; i < n_parameters; i++)
        if (name_in(parameters[i].key, section) && is_written(settings, &parameters[i]))
            return true;
    return false;
}

bool scenario_write(FILE *stream, const Settings *settings, const char *comment, Status *status)
{
    bool first = !comment || !*comment;
    while (comment && *comment) {
        size_t n = strcspn(comment, "\n");
        fprintf(stream, "#%s%.*s\n", n ? " " : "", (int)n, comment);
        comment += n + (comment[n] == '\n');
    }
    for (const char *const *section = scenario_sections; *section; section++) {
        if (!has_section(settings, *section))
            continue;
        fprintf(stream, "%s[%s]\n", first ? "" : "\n", *section);
        first = false;
        if (!write_section(stream, settings, *section, status))
            return false;
    }
    if (fflush(stream) != 0 || ferror(stream))
        return status_fail(status, "cannot write the scenario: %s", strerror(errno));
    return true;
}

static void take_row(const char *section, const char *name, const char *value, AssignmentTaker *take,
                     void *context)
{
    char key[2 * KEY_MAX];
    snprintf(key, sizeof key, "%s.%s", section, name);
    take(context, key, value);
}

bool scenario_assignments(const char *name_or_path, const Settings *to, AssignmentTaker *take, void *context)
{
    Settings from;
    Status ignored = {0};
    const Override method = {"", "scenario.method", settings_method_words[to->method]};
    if (!scenario_load(name_or_path, &from, &ignored))
        return false;
    if (from.method != to->method) {
        take(context, method.key, method.value);
        if (!scenario_load_with(name_or_path, &method, 1, &from, &ignored))
            return false;
    }
    for (int i = 0; i < n_parameters; i++) {
        const Parameter *parameter = &parameters[i];
        char value[LIST_MAX];
        if (parameter->output || is_of_method(parameter) || !parameter_applies_to(to, parameter) ||
            is_derived(to, parameter) || (parameter->wrong && to->concealed) ||
            !(settings_differ(&from, to, parameter) || is_derived(&from, parameter)))
            continue;
        settings_get(to, parameter, value);
        take(context, parameter->key, value);
    }
    RowDifference row;
    for (int i = 0; settings_rows_difference(to, &from, i, &row); i++) {
        const RowKind *kind = &row_kinds[row.kind];
        char text[ROW_TEXT_MAX] = "none", word[ROW_TEXT_MAX];
        const char *rest = text;
        if (row.in_a)
            row_write(kind, row.in_a, 0, text);
        if (!kind->usual)
            take_row(kind->section, (row.in_a ? row.in_a : row.in_b)->name, text, take, context);
        else
            for (int k = 0; text_next_word(&rest, word, sizeof word); k++)
                take_row(kind->section, kind->columns[k].word, word, take, context);
    }
    return true;
}

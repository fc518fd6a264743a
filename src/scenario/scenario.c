/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads a scenario (scenario.h): lines come from scenario_lines.c as entries; problem and method are taken
 * first, since the allowed keys depend on them, then every entry by its key, then values from the command
 * line; then the whole is checked. An error gets the line or option that gave the key it names. */
#include "scenario/scenario.h"
#include "scenario/settings.h"
#include "base/input.h"
#include "base/text.h"
#include "scenario/parameters.h"
#include "scenario/scenario_lines.h"

#include <errno.h>
#include <string.h>

/* What is being read: the lines, where they come from and what stands above them. */
typedef struct Source {
    const char *file;
    Entries entries;
    const Override *overrides;
    int n_overrides;
} Source;

const char scenario_unnamed[] = "mode5";

static void full_key(const Entry *entry, char out[80])
{
    snprintf(out, 80, "%s.%s", entry->section, entry->name);
}

static const Entry *find_entry(const Source *source, const char *section, const char *name)
{
    for (int i = 0; i < source->entries.count; i++) {
        const Entry *entry = &source->entries.all[i];
        if (strcmp(entry->section, section) == 0 && strcmp(entry->name, name) == 0)
            return entry;
    }
    return NULL;
}

static bool at_line(const Source *source, const Entry *entry, Status *status)
{
    return status_prefix(status, "%s:%d", source->file, entry->line);
}

static bool check_twice(const Source *source, Status *status)
{
    const Entry *all = source->entries.all;
    for (int i = 0; i < source->entries.count; i++)
        for (int j = 0; j < i; j++) {
            /* several parameters may change in one step, each once */
            const bool change = strcmp(all[i].section, "changes") == 0;
            const size_t n = strcspn(all[i].value, " ="), m = strcspn(all[j].value, " =");
            char key[80];
            if (strcmp(all[i].section, all[j].section) != 0 || strcmp(all[i].name, all[j].name) != 0 ||
                (change && (n != m || strncmp(all[i].value, all[j].value, n) != 0)))
                continue;
            full_key(&all[i], key);
            status_refuse(status, "%s: is given twice (first in line %d)", key, all[j].line);
            return at_line(source, &all[i], status);
        }
    const Entry *stretch = find_entry(source, "pd", "critical_stretch");
    const Entry *energy = find_entry(source, "pd", "critical_energy");
    if (stretch && energy) {
        const Entry *later = stretch->line > energy->line ? stretch : energy;
        status_refuse(status, "pd.%s: pd.%s is given in line %d and says the same (one of them)", later->name,
                      later == stretch ? energy->name : stretch->name,
                      later == stretch ? energy->line : stretch->line);
        return at_line(source, later, status);
    }
    return true;
}

/* --- applying the lines --------------------------------------------------------------------------- */

/* The index of a word; -1 and a status if it is none of them. */
static int choose(const char *const *words, const Entry *entry, Status *status)
{
    char allowed[128] = "";
    const int chosen = text_place_in(entry->value, words);
    for (int i = 0; words[i]; i++)
        text_or(allowed, sizeof allowed, words[i]);
    if (chosen < 0)
        status_refuse(status, "scenario.%s: %.60s is not a choice (%s)", entry->name, entry->value, allowed);
    return chosen;
}

static bool fill_assignment(Assignment *to, const char *key, const char *value, Status *status)
{
    if (strlen(key) >= sizeof to->key || strlen(value) >= sizeof to->value)
        return status_refuse(status, "%.60s: the value is too long (at most %zu bytes)", key,
                             sizeof to->value - 1);
    strcpy(to->key, key);
    strcpy(to->value, value);
    return true;
}

static bool take_change(const Entry *entry, Settings *settings, Status *status)
{
    long step;
    char text[ABOUT_MAX];
    memcpy(text, entry->value, sizeof text);
    char *equals = strchr(text, '=');
    if (!text_to_long(entry->name, &step) || step < 0)
        return status_refuse(status, "changes.%s: is not a step (STEP = KEY=VALUE, STEP >= 0)", entry->name);
    if (!equals)
        return status_refuse(status, "changes.%s: \"%.60s\" changes nothing (STEP = KEY=VALUE)", entry->name,
                             text);
    *equals = '\0';
    text[strcspn(text, " ")] = '\0';
    if (settings->n_changes == CHANGES_MAX)
        return status_refuse(status, "changes.%s: too many changes (at most %d)", entry->name, CHANGES_MAX);
    /* kept in order of steps, those of one step in the order of the file */
    int place = settings->n_changes++;
    for (; place > 0 && settings->changes[place - 1].step > step; place--)
        settings->changes[place] = settings->changes[place - 1];
    memset(&settings->changes[place], 0, sizeof settings->changes[place]);
    settings->changes[place].step = step;
    return fill_assignment(&settings->changes[place].to, text, equals + 1 + strspn(equals + 1, " "), status);
}

static bool take_entry(const Entry *entry, Settings *settings, Status *status)
{
    if (strcmp(entry->section, "duel") == 0) {
        if (settings->n_duel == DUEL_MAX)
            return status_refuse(status, "duel: too many keys differ (at most %d)", DUEL_MAX);
        return fill_assignment(&settings->duel[settings->n_duel++], entry->name, entry->value, status);
    }
    if (strcmp(entry->section, "changes") == 0)
        return take_change(entry, settings, status);
    char key[80];
    full_key(entry, key);
    if (strcmp(key, "scenario.problem") == 0 || strcmp(key, "scenario.method") == 0)
        return true;
    return settings_set(settings, key, entry->value, status);
}

static bool take_overrides(const Source *source, Settings *settings, Status *status)
{
    bool stretch = false, energy = false;
    /* the method first: which keys there are depends on it */
    for (int i = 0; i < source->n_overrides; i++)
        if (strcmp(source->overrides[i].key, "scenario.method") == 0 &&
            !settings_set(settings, source->overrides[i].key, source->overrides[i].value, status))
            return status_prefix(status, "%s", source->overrides[i].origin);
    for (int i = 0; i < source->n_overrides; i++) {
        const Override *override = &source->overrides[i];
        stretch |= strcmp(override->key, "pd.critical_stretch") == 0;
        energy |= strcmp(override->key, "pd.critical_energy") == 0;
        if (stretch && energy)
            status_refuse(status, "%s: pd.critical_stretch and pd.critical_energy say the same (one of them)",
                          override->key);
        else if (settings_set(settings, override->key, override->value, status))
            continue;
        return status_prefix(status, "%s", override->origin);
    }
    return true;
}

/* --- where a fault of the whole comes from -------------------------------------------------------- */

/* Whether a message is about a key: it begins with it, or names it. */
static bool names(const char *message, const char *key, bool at_start)
{
    const char *found = strstr(message, key);
    for (; found; found = strstr(found + 1, key)) {
        char after = found[strlen(key)];
        bool whole = (found == message || found[-1] == ' ') &&
                     (after == ':' || after == ' ' || after == ')' || after == ',' || after == '\0');
        if (whole && (!at_start || found == message))
            return true;
    }
    return false;
}

/* Or, of one value of a row, whether it is about that row and names this value, or none of its values. */
static bool is_about(const char *message, const char *key, bool at_start)
{
    char row[KEY_MAX], section[KEY_MAX];
    const RowColumn *column = row_key_column(key);
    if (names(message, key, at_start))
        return true;
    if (!column)
        return false;
    snprintf(row, sizeof row, "%.*s", (int)(strrchr(key, '.') - key), key);
    if (!names(message, row, at_start))
        return false;
    if (names(message, column->word, false))
        return true;
    snprintf(section, sizeof section, "%.*s", (int)strcspn(key, "."), key);
    const RowKind *kind = &row_kinds[row_kind_find(section)];
    for (int k = 0; k < kind->n_columns; k++)
        if (names(message, kind->columns[k].word, false))
            return false;
    return true;
}

/* The status of a check gets its origin: the option or line that gave the key with which the message begins,
 * else one that gave another key of the message. False: neither. */
static bool find_origin(const Source *source, Status *status)
{
    for (int at_start = 1; at_start >= 0; at_start--) {
        for (int i = source->n_overrides - 1; i >= 0; i--)
            if (is_about(status->text, source->overrides[i].key, at_start)) {
                status_prefix(status, "%s", source->overrides[i].origin);
                return true;
            }
        for (int i = 0; i < source->entries.count; i++) {
            const Entry *entry = &source->entries.all[i];
            char key[80];
            /* As messages spell it. */
            if (strcmp(entry->section, "duel") == 0)
                snprintf(key, 80, "duel: %s", entry->name);
            else
                full_key(entry, key);
            if (!is_about(status->text, key, at_start))
                continue;
            at_line(source, entry, status);
            return true;
        }
    }
    return false;
}

/* False: the settings are of no use. */
static bool apply(const Source *source, Settings *settings, Status *status)
{
    if (!check_twice(source, status))
        return false;
    const Entry *problem = find_entry(source, "scenario", "problem");
    const char *words[PROBLEMS_MAX + 1] = {NULL};
    for (int i = 0; i < PROBLEMS_MAX && problems[i]; i++)
        words[i] = problems[i]->word;
    int chosen = problem ? choose(words, problem, status) : 0;
    if (chosen < 0)
        return at_line(source, problem, status);
    settings_default(settings, problems[chosen]);
    const Entry *method = find_entry(source, "scenario", "method");
    chosen = method ? choose(settings_method_words, method, status) : (int)settings->method;
    if (chosen < 0)
        return at_line(source, method, status);
    settings->method = (MethodKind)chosen;

    for (int i = 0; i < source->entries.count; i++)
        if (!take_entry(&source->entries.all[i], settings, status))
            return at_line(source, &source->entries.all[i], status);
    if (!take_overrides(source, settings, status))
        return false;
    if (settings_check(settings, status))
        return true;
    if (!status || find_origin(source, status))
        return false;
    /* without either it is the first option with which the whole is refused, or the file's last line */
    Source first = *source;
    for (first.n_overrides = 0; first.n_overrides < source->n_overrides; first.n_overrides++)
        if (!apply(&first, settings, NULL))
            break;
    if (first.n_overrides > 0)
        return status_prefix(status, "%s", source->overrides[first.n_overrides - 1].origin);
    return at_line(source, &source->entries.all[source->entries.count - 1], status);
}

/* --- files and built-ins -------------------------------------------------------------------------- */

static bool read_with(FILE *stream, const char *name, const Override *overrides, int count,
                      Settings *settings, Status *status)
{
    Source source = {.file = name, .overrides = overrides, .n_overrides = count};
    Settings read;
    bool good = entries_read(&source.entries, stream, name, status) && apply(&source, &read, status);
    entries_free(&source.entries);
    if (good)
        *settings = read;
    return good;
}

bool scenario_read(FILE *stream, const char *name, Settings *settings, Status *status)
{
    return read_with(stream, name, NULL, 0, settings, status);
}

const BuiltinScenario *scenario_builtin(const char *name)
{
    for (const BuiltinScenario *builtin = builtin_scenarios; builtin->name; builtin++)
        if (strcmp(builtin->name, name) == 0)
            return builtin;
    return NULL;
}

/* NULL: as input_open() has it. */
static FILE *open_scenario(const char *name_or_path, Status *status)
{
    const BuiltinScenario *builtin = scenario_builtin(name_or_path);
    return builtin ? input_text(builtin->text, name_or_path, status)
                   : input_open(name_or_path, SCENARIO_BYTES_MAX, status);
}

void scenario_blame(const char *name_or_path, const Override *overrides, int count, Status *status)
{
    Source source = {.file = name_or_path, .overrides = overrides, .n_overrides = count};
    char key[KEY_MAX] = "";
    if (!status)
        return;
    const size_t length = strcspn(status->text, ":");
    if (length < sizeof key)
        memcpy(key, status->text, length);
    FILE *stream = parameter_find(key) || parameter_text_find(key) ? open_scenario(name_or_path, NULL) : NULL;
    if (!stream)
        return;
    if (!entries_read(&source.entries, stream, name_or_path, NULL) || !find_origin(&source, status))
        status_prefix(status, "%s", name_or_path);
    entries_free(&source.entries);
    fclose(stream);
}

bool scenario_load_with(const char *name_or_path, const Override *overrides, int count, Settings *settings,
                        Status *status)
{
    FILE *stream = open_scenario(name_or_path, status);
    if (!stream && errno != ENOENT)
        return false; /* the status says why */
    if (!stream) {
        Nearest nearest = nearest_begin(name_or_path);
        for (const BuiltinScenario *builtin = builtin_scenarios; builtin->name; builtin++)
            nearest_offer(&nearest, builtin->name);
        return status_refuse(status,
                             nearest.word ? "%s: no such scenario or file (did you mean %s?)"
                                          : "%s: no such scenario or file (see: matvib list)",
                             name_or_path, nearest.word);
    }
    bool good = read_with(stream, name_or_path, overrides, count, settings, status);
    fclose(stream);
    return good;
}

bool scenario_load(const char *name_or_path, Settings *settings, Status *status)
{
    return scenario_load_with(name_or_path, NULL, 0, settings, status);
}

static const struct {
    const char *whole, *coarse;
} forms[] = {{"moving-cantilever-mpm", "moving-cantilever-mpm-coarse"}};

enum { N_FORMS = sizeof forms / sizeof *forms };

const char *scenario_on_screen(const char *name_or_path)
{
    for (int i = 0; i < N_FORMS; i++)
        if (strcmp(forms[i].whole, name_or_path) == 0)
            return forms[i].coarse;
    return name_or_path;
}

const char *scenario_whole(const char *name)
{
    for (int i = 0; i < N_FORMS; i++)
        if (strcmp(forms[i].coarse, name) == 0)
            return forms[i].whole;
    return NULL;
}

bool scenario_title(const BuiltinScenario *builtin, char title[TITLE_MAX])
{
    Settings settings;
    if (!scenario_load(builtin->name, &settings, NULL))
        return false;
    strcpy(title, settings.title);
    return true;
}

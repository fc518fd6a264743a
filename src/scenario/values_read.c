/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values of settings from texts, as a scenario, an option or a field gives them: read, held against the
 * parameter's range and words, or refused in one line. */
#include "scenario/parameters.h"
#include "scenario/settings.h"
#include "base/quantity.h"
#include "base/text.h"
#include "base/visible.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

bool settings_in_range(const Parameter *parameter, const Problem *problem, double value)
{
    if (parameter->choices ||
        (parameter_in(parameter, problem).automatic && value == parameter->automatic_value))
        return true;
    if (parameter->above_least && value <= parameter->least)
        return false;
    return value >= parameter->least && value <= parameter->most;
}

static bool refuse(const Parameter *parameter, const Problem *problem, const char *text, const char *what,
                   Status *status)
{
    char range[160];
    parameter_range(parameter, problem, range, sizeof range);
    if (!*text)
        return status_refuse(status, "%s: has no value (%s)", parameter->key, range);
    return status_refuse(status, "%s: %s %s (%s)", parameter->key, text, what, range);
}

static bool read_number(const Parameter *parameter, const Problem *problem, const char *text, double *value,
                        Status *status)
{
    const char *automatic = parameter_in(parameter, problem).automatic;
    if (automatic && strcmp(text, automatic) == 0) {
        *value = parameter->automatic_value;
        return true;
    }
    char why[QUANTITY_WHY_MAX];
    if (!quantity_read(text, problem->si ? parameter->unit : "", value, why))
        return refuse(parameter, problem, text, why, status);
    if (parameter->type == PARAMETER_INTEGER && *value != floor(*value))
        return refuse(parameter, problem, text, "is not a whole number", status);
    /* where nothing at all stands for 0, a 0 that was typed is a slip */
    bool silent_zero = automatic && !*automatic && *value == 0;
    /* and what a word says */
    bool unsaid = parameter->automatic_value != 0 && *value == parameter->automatic_value;
    if (silent_zero || unsaid || !settings_in_range(parameter, problem, *value))
        return refuse(parameter, problem, text, "is out of range", status);
    return true;
}

static bool read_choice(const Parameter *parameter, const Problem *problem, const char *text, double *value,
                        Status *status)
{
    const Parameter row = parameter_in(parameter, problem);
    const int choice = text_place_in(text, row.choices);
    *value = choice;
    return (choice >= 0 && choice < row.n_choices) ||
           refuse(parameter, problem, text, choice < 0 ? "is not a choice" : row.others, status);
}

static bool put_text(Settings *settings, const Parameter *parameter, const char *text, Status *status)
{
    if (strlen(text) >= parameter->size)
        return status_refuse(status, "%s: is %zu bytes long (at most %zu)", parameter->key, strlen(text),
                             parameter->size - 1);
    if (!visible_is_clean(text))
        return status_refuse(status, "%s: has characters that cannot be kept (one line of UTF-8)",
                             parameter->key);
    /* nothing of an earlier text behind the zero: equal settings are equal bytes */
    char *at = (char *)settings + parameter->offset;
    memset(at, 0, parameter->size);
    strcpy(at, text);
    return true;
}

static bool unknown(const Problem *problem, const char *key, Status *status)
{
    if (strcmp(key, "scenario.problem") == 0)
        return status_refuse(status, "%s: cannot be changed (choose another scenario)", key);
    char section[KEY_MAX];
    snprintf(section, sizeof section, "%.*s", (int)strcspn(key, "."), key);
    const int kind = row_kind_find(section);
    if (kind >= 0)
        return status_refuse(status, "%s: problem %s has no [%s] (%s)", key, problem->word, section,
                             row_kinds[kind].concern & problem->concerns ? "a name after a dot"
                             : row_kinds[kind].concern == CONCERN_PLATE  ? "a plate has"
                                                                         : "bodies have");
    const char *nearest = parameter_nearest(problem, key);
    if (nearest)
        return status_refuse(status, "%s: unknown key (did you mean %s?)", key, nearest);
    return status_refuse(status, "%s: unknown key (see: matvib params %s)", key, problem->word);
}

static bool not_of_settings(const Parameter *parameter, const Settings *settings, Status *status)
{
    const Problem *problem = settings->problem;
    if (parameter_applies(parameter, problem))
        return status_refuse(
            status, "%s: is not a parameter of method %s (only of %s)", parameter->key,
            settings_method_words[settings->method],
            settings_method_words[parameter_in(parameter, problem).methods & BY_MPM ? METHOD_MPM
                                                                                    : METHOD_PD]);
    char words[128] = "";
    for (int p = 0; problems[p]; p++)
        if (parameter_applies(parameter, problems[p]))
            text_list_add(words, sizeof words, problems[p]->word);
    return status_refuse(status, "%s: is not a parameter of problem %s (only of %s)", parameter->key,
                         problem->word, words);
}

/* A view's digit, or a word such as name views, perhaps with that of a variant, "profile:v"; which there are
 * the laboratory knows, not the scenario. */
static bool can_be_view(const char *text)
{
    const size_t letters = strspn(text, "abcdefghijklmnopqrstuvwxyz-");
    const bool digit = text[0] >= '1' && text[0] <= '9' && text[1] == '\0';
    const char *variant = text[letters] == ':' ? text + letters + 1 : "v";
    return digit || (letters > 0 && (text[letters] == '\0' || text[letters] == ':') && *variant &&
                     variant[strspn(variant, "abcdefghijklmnopqrstuvwxyz0123456789._-")] == '\0');
}

/* Empty is always allowed: as the laboratory likes. */
static bool check_words(const Settings *settings, const Parameter *key, const char *text, Status *status)
{
    const char *const *words = key->rule == TEXT_REFERENCES ? parameter_reference_words
                               : key->rule == TEXT_SHEET    ? parameter_sheet_words
                               : key->rule == TEXT_COLOUR   ? parameter_colour_words
                                                            : NULL;
    char allowed[160];
    double value;
    snprintf(allowed, sizeof allowed, "%s",
             key->rule == TEXT_VIEW ? "1 to 9, or a view's word"
             : words                ? ""
                                    : "> 0");
    bool sound = !*text || key->rule == TEXT_ANY || (key->rule == TEXT_VIEW && can_be_view(text));
    if (key->rule == TEXT_POSITIVE && text_to_double(text, &value))
        sound = value > 0;
    for (; words && *words; words++) {
        if (key->rule == TEXT_COLOUR && !parameter_colour_is_there(settings, *words))
            continue;
        sound |= strcmp(*words, text) == 0;
        text_or(allowed, sizeof allowed, *words);
    }
    if (!sound && !*allowed)
        return status_refuse(status, "%s: %.60s is not allowed (it is of beams and plates)", key->key, text);
    return sound || status_refuse(status, "%s: %.60s is not allowed (%s)", key->key, text, allowed);
}

bool settings_set(Settings *settings, const char *key, const char *text, Status *status)
{
    const Parameter *words = parameter_text_find(key);
    if (words)
        return check_words(settings, words, text, status) && put_text(settings, words, text, status);
    /* a support of a plate may be called as a parameter of another problem is */
    if (settings_row_is_key(settings, key))
        return settings_row_key_set(settings, key, text, status);
    const Parameter *parameter = parameter_find(key);
    const FixedKey *fixed = fixed_key_find(settings, key);
    if (fixed) {
        char why[sizeof status->text];
        fixed_key_text(fixed, why, sizeof why);
        return status_refuse(status, "%s", why);
    }
    if (!parameter)
        return unknown(settings->problem, key, status);
    if (!parameter_applies_to(settings, parameter))
        return not_of_settings(parameter, settings, status);
    if (parameter->type == PARAMETER_TEXT)
        return put_text(settings, parameter, text, status);
    double value;
    const bool concealed = parameter->wrong && *text == '?';
    text += concealed;
    for (int i = 0; concealed && parameter->choices[i]; i++) {
        char cipher[CIPHER_MAX];
        parameter_cipher(parameter->choices[i], cipher);
        if (strcmp(text, cipher) == 0)
            text = parameter->choices[i];
    }
    if (!(parameter->choices ? read_choice : read_number)(parameter, settings->problem, text, &value, status))
        return false;
    settings_put(settings, parameter, value);
    if (concealed)
        settings->concealed = value != parameter->neutral;
    return true;
}

bool settings_set_method(Settings *settings, const Assignment *keys, int n_keys, Status *status)
{
    for (int i = 0; i < n_keys; i++)
        if (strcmp(keys[i].key, "scenario.method") == 0 &&
            !settings_set(settings, keys[i].key, keys[i].value, status))
            return false;
    for (int i = 0; i < n_parameters; i++)
        if (parameters[i].wrong && parameter_applies(&parameters[i], settings->problem) &&
            !parameter_applies_to(settings, &parameters[i]))
            settings_put(settings, &parameters[i], parameters[i].neutral);
    return true;
}

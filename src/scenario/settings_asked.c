/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a scenario asks about: the key of its question, and those of its screen. */
#include "scenario/parameters.h"
#include "base/text.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

const Parameter *settings_question(const Settings *settings)
{
    const Parameter *asked = parameter_find(settings->question);
    if (!asked || !parameter_applies_to(settings, asked)) /* or it asks about the bar's other method */
        asked = parameter_find(settings->method == METHOD_MPM ? "mpm.algorithm" : "pd.surface_correction");
    return asked && parameter_applies_to(settings, asked) ? asked : NULL;
}

/* What is tried first where a scenario names nothing: the question, then of these what there is. */
static const char *const usually_asked[] = {
    "mesh.cell_size", "mesh.particles_per_cell", "time.courant", "pd.spacing", "pd.horizon", "load.stress",
    "time.step"};

int settings_asked(const Settings *settings, Asked out[ASKED_MAX])
{
    const char *list = settings_view(settings)->ask;
    char key[KEY_MAX];
    int n = 0;
    while (n < ASKED_MAX && text_next_item(&list, key, sizeof key)) {
        Asked *next = &out[n];
        *next = (Asked){.parameter = parameter_find(key)};
        if (next->parameter)
            n += parameter_applies_to(settings, next->parameter);
        else if (settings_row_is_key(settings, key) && settings_row_asked(settings, key, &next->place, NULL))
            n += next->place.row >= 0;
    }
    const Parameter *question = settings_question(settings);
    if (n == 0 && question)
        out[n++] = (Asked){.parameter = question};
    for (size_t i = 0;
         !*settings_view(settings)->ask && n < ASKED_MAX && i < sizeof usually_asked / sizeof *usually_asked;
         i++) {
        const Parameter *parameter = parameter_find(usually_asked[i]);
        if (parameter && parameter != question && parameter_applies_to(settings, parameter))
            out[n++] = (Asked){.parameter = parameter};
    }
    return n;
}

bool settings_check_asked(const Settings *settings, Status *status)
{
    const char *list = settings_view(settings)->ask;
    char key[KEY_MAX];
    for (int n = 0; text_next_item(&list, key, sizeof key); n++) {
        const Parameter *parameter = parameter_find(key);
        RowPlace place;
        if (!parameter && settings_row_is_key(settings, key)) {
            if (!settings_row_asked(settings, key, &place, status))
                return false;
        } else if (!parameter || !parameter_applies(parameter, settings->problem))
            return status_refuse(status,
                                 "screen.ask: %s is no parameter of problem %s (see: matvib params %s)", key,
                                 settings->problem->word, settings->problem->word);
        if (n == ASKED_MAX)
            return status_refuse(status, "screen.ask: names too many (at most %d)", ASKED_MAX);
    }
    return true;
}

/* Which key is meant by its end or by the words beside its field on screen. */

/* How a key may be called; each in turn, the first by which there is one. */
typedef enum Call { CALL_WHOLE, CALL_NAME, CALL_END, CALL_LABEL, CALLS } Call;

/* Whether the word ends the key, behind a mark. */
static bool ends_with(const char *key, const char *word, const char *marks)
{
    const size_t length = strlen(key), end = strlen(word);
    return length > end && end > 0 && strchr(marks, key[length - end - 1]) &&
           strcmp(key + length - end, word) == 0;
}

static bool is_called(const char *key, const char *label, const char *words, Call call)
{
    switch (call) {
    case CALL_WHOLE:
        return strcmp(key, words) == 0;
    case CALL_NAME:
        return ends_with(key, words, ".");
    case CALL_END:
        return ends_with(key, words, "_");
    case CALL_LABEL:
    case CALLS:
        break;
    }
    /* "CELL SIZE" is "cell size". */
    const char *a = label;
    const char *b = words;
    if (!label)
        return false;

    while (*a && tolower((unsigned char)*a) == tolower((unsigned char)*b))
        a++, b++;
    return !*a && !*b;
}

bool settings_resolve_key(const Settings *settings, const char *words, char key[KEY_MAX], Status *status)
{
    const char *found = NULL;
    char list[120] = "";
    int count = 0;
    for (Call call = CALL_WHOLE; call < CALLS && count == 0; call++) {
        for (int i = 0; i < n_parameters; i++)
            if (parameter_applies_to(settings, &parameters[i]) &&
                is_called(parameters[i].key, parameters[i].label, words, call)) {
                found = parameters[i].key;
                text_list_add(list, sizeof list, found);
                count++;
            }
        for (int i = 0; i < n_text_keys; i++)
            if (is_called(text_keys[i].key, NULL, words, call)) {
                found = text_keys[i].key;
                text_list_add(list, sizeof list, found);
                count++;
            }
    }
    if (count > 1)
        return status_refuse(status, "%s: which one? (%s)", words, list);
    /* what is none stays as it was typed, for the function that refuses it */
    snprintf(key, KEY_MAX, "%s", found ? found : words);
    return true;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a scenario asks about: the key of its question, and those of its screen. */
#include "scenario/parameters.h"
#include "base/text.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"

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

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Views by what people call them, and where they stand when a run is opened: all read off the list. */
#include "views/view.h"
#include "scenario/concern_output.h"
#include "base/text.h"
#include "answers/run_numbers.h"
#include "run/experiment.h"

#include <stdio.h>
#include <string.h>

const View *view_of_digit(int digit)
{
    for (int i = 0; i < n_views && digit != 0; i++)
        if (views[i]->digit == digit)
            return views[i];
    return NULL;
}

const View *view_named(const char *word)
{
    for (int i = 0; i < n_views; i++)
        if (strcmp(views[i]->word, word) == 0)
            return views[i];
    return word[0] >= '1' && word[0] <= '9' && word[1] == '\0' ? view_of_digit(word[0] - '0') : NULL;
}

void view_names(char *out, size_t size)
{
    out[0] = '\0';
    for (int i = 0; i < n_views; i++)
        text_append(out, size, "%s, ", views[i]->word);
    text_append(out, size, "or 1 to 9");
}

/* The one that is the most willing to open by itself; of equals the first in the list. */
const View *view_at_home(PaneId home, const Simulation *sim)
{
    const bool plane = sim && simulation_has_map(sim);
    const View *found = views[0];
    ViewOpening most = OPENS_ON_DEMAND;
    for (int i = 0; i < n_views; i++)
        if (views[i]->home == home && views[i]->opens > most &&
            (views[i]->opens != OPENS_IN_PLANE || plane)) {
            found = views[i];
            most = found->opens;
        }
    return found;
}

PaneId view_pane_of_number(const Screen *screen)
{
    const RunNumber *number = run_number_about(screen_settings(screen));
    /* a number of this moment is read off a curve along the body, one of the run off a curve over time */
    return number->of_moment ? PANE_UPPER : PANE_LOWER;
}

const View *view_of_map(void)
{
    for (int i = 0; i < n_views; i++)
        if (views[i]->is_map)
            return views[i];
    return NULL;
}

/* Of "profile:v" the view; "profile" and "1" are whole. */
static const View *view_of_name(const char *name)
{
    char word[VALUE_MAX];
    snprintf(word, sizeof word, "%.*s", (int)strcspn(name, ":"), name);
    return view_named(word);
}

/* Which variant "profile:v" names on a screen; -1: there is none. */
static int variant_of_name(const View *view, const Screen *screen, const char *name)
{
    return view_variant_named(view, screen, name + strcspn(name, ":") + 1);
}

/* Variants are of the run: one is made to ask for them. */
static bool check_variant(const Settings *settings, const View *view, const char *key, const char *name,
                          Status *status)
{
    char known[600] = "";
    Screen screen = {0};
    Experiment *experiment = experiment_create(settings, 0, 1, status);
    if (!experiment)
        return false;
    screen.experiment = experiment;
    const char *missing = view_missing(view, &screen), *word;
    for (int i = 0; !missing && (word = view_variant_word(view, &screen, i)) != NULL; i++)
        text_append(known, sizeof known, "%s%s", i ? ", " : "", word);
    const bool sound = missing || variant_of_name(view, &screen, name) >= 0;
    experiment_destroy(experiment);
    return sound || status_refuse(status, "%s: %.60s is not allowed (%s%s%s)", key, name, view->word,
                                  known[0] ? " with one of " : " alone", known);
}

bool view_check(const Settings *settings, const Settings *known, Status *status)
{
    static const char *const keys[2] = {"view.upper", "view.lower"};
    const ViewSettings *view = settings_view(settings), *good = known ? settings_view(known) : NULL;
    const char *const names[2] = {view->upper, view->lower};
    char all[320];
    for (int i = 0; i < 2; i++) {
        const View *named = view_of_name(names[i]);
        if (names[i][0] && !named) {
            view_names(all, sizeof all);
            return status_refuse(status, "%s: %.60s is not allowed (%s)", keys[i], names[i], all);
        }
        const bool is_known = good && strcmp(names[i], i ? good->lower : good->upper) == 0;
        if (strchr(names[i], ':') && !is_known && !check_variant(settings, named, keys[i], names[i], status))
            return false;
    }
    const RunNumber *about = view->about[0] ? run_number_find(view->about) : NULL;
    if (view->about[0] && (!about || !about->label)) {
        all[0] = '\0';
        for (const RunNumber *row = run_numbers; row->word; row++)
            if (row->label)
                text_append(all, sizeof all, "%s%s", all[0] ? ", " : "", row->word);
        return status_refuse(status, "screen.about: %.60s is not allowed (%s)", view->about, all);
    }
    return true;
}

/* A view that a scenario names, with its variant; one that cannot be shown gives way. */
static const View *open_named(Screen *screen, const char *name, PaneId home)
{
    const View *view = view_of_name(name);
    if (!view || view_missing(view, screen))
        return view_at_home(home, screen_simulation(screen));
    const int variant = strchr(name, ':') ? variant_of_name(view, screen, name) : -1;
    if (variant >= 0)
        view_choose_variant(view, screen, variant);
    return view;
}

void views_open(Screen *screen, const ViewSettings *settings)
{
    screen->views.upper = open_named(screen, settings->upper, PANE_UPPER);
    screen->views.lower = open_named(screen, settings->lower, PANE_LOWER);
}

const char *view_curve(const Screen *screen, bool over_time)
{
    const View *view = screen->panes.focus == PANE_UPPER ? screen->views.upper : screen->views.lower;
    for (int i = 0; i < n_views && (!view->curve || view->has_time_axis != over_time); i++)
        view = views[i];
    return view->curve ? view->curve(screen) : "";
}

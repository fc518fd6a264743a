/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One view on one screen: what it needs and which variant is chosen. Nothing here asks which view it is. */
#include "views/view.h"

#include <stdio.h>
#include <string.h>

#include "run/experiment.h"

static bool has_any(const Experiment *experiment, unsigned needs)
{
    return needs == 0 || (experiment_simulation(experiment)->has & needs) != 0;
}

const char *view_missing(const View *view, const Screen *screen)
{
    return has_any(screen->experiment, view->needs) ? NULL : view->lacking;
}

int view_variants(const View *view, const Screen *screen)
{
    int count = view->variants ? view->variants(screen) : 0;
    while (!view->variants && view->variant_word && view->variant_word(screen, count))
        count++;
    return count > 0 ? count : 1;
}

int view_variant(const View *view, const Screen *screen)
{
    for (int i = 0; i < screen->views.n_variants; i++) {
        const ViewVariant *chosen = &screen->views.variants[i];
        if (chosen->view != view)
            continue;
        if (!chosen->word[0])
            return chosen->variant % view_variants(view, screen);
        /* a run without it shows its first; the choice is kept for one that has it again */
        const int variant = view_variant_named(view, screen, chosen->word);
        return variant > 0 ? variant : 0;
    }
    return 0;
}

void view_choose_variant(const View *view, Screen *screen, int variant)
{
    int i = 0;
    while (i < screen->views.n_variants && screen->views.variants[i].view != view)
        i++;
    if (i == VIEWS_MAX)
        return;
    variant %= view_variants(view, screen);
    const char *word = view_variant_word(view, screen, variant);
    ViewVariant *chosen = &screen->views.variants[i];
    *chosen = (ViewVariant){.view = view, .variant = variant};
    snprintf(chosen->word, sizeof chosen->word, "%s", word ? word : "");
    if (i == screen->views.n_variants)
        screen->views.n_variants++;
}

bool view_is_on_paper(const View *view, const Screen *screen)
{
    return !view->no_figure && has_any(screen->experiment, view->on_paper_with) &&
           !view_missing(view, screen);
}

const char *view_variant_word(const View *view, const Screen *screen, int variant)
{
    const bool known = view->variant_word && variant >= 0 && variant < view_variants(view, screen);
    return known ? view->variant_word(screen, variant) : NULL;
}

int view_variant_named(const View *view, const Screen *screen, const char *name)
{
    for (int i = 0; i < view_variants(view, screen); i++) {
        const char *word = view_variant_word(view, screen, i);
        if (word && strcmp(word, name) == 0)
            return i;
    }
    return -1;
}

const ConvergenceStudy *view_study(const View *view, const Screen *screen)
{
    return view->study ? view->study(screen, view_variant(view, screen)) : NULL;
}

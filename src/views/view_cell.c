/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cell or one bond from near: what a stage passes between the chosen thing and those beside it. */
#include "views/view.h"

static void describe(const Screen *screen, int variant, Picture *picture)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    if (simulation_has(sim, HAS_BONDS))
        cell_bonds_describe(screen, variant, picture);
    else if (!simulation_has(sim, HAS_MESH) || sim->counts[0] < 1 || sim->counts[1] < 2)
        picture_say(picture, "one cell", "There is neither a mesh nor a bond.");
    else if (simulation_has(sim, HAS_LINE))
        cell_bar_describe(screen, variant, picture);
    else
        cell_plane_describe(screen, picture);
}

static const char *word_of(const Screen *screen, int variant)
{
    static const char *const bonds[] = {"bond", "family", NULL}, *const line[] = {"terms", "masses", NULL},
                             *const plane[] = {"terms", NULL};
    const Simulation *sim = experiment_simulation(screen->experiment);
    return (simulation_has(sim, HAS_BONDS)             ? bonds
            : simulation_has(sim, HAS_MESH | HAS_LINE) ? line
                                                       : plane)[variant];
}

const View view_cell = {
    .word = "cell",
    .brief = "cell",
    .help = "one cell from near, with the terms of a stage, or one bond; again: masses, or the family",
    .home = PANE_UPPER,
    .describe = describe,
    .variant_word = word_of,
    .duel = DUEL_APART,
    .of_moment = true,
    .is_wide = true,
    .on_paper = true,
};

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which inspector a simulation has: one row for each, the first that fits is taken. */
#include "views/inspector/inspector.h"
#include "views/view.h"

static const Inspector *const inspectors[] = {&inspector_mesh, &inspector_bonds, &inspector_family};

const Inspector *inspector_find(const Screen *screen)
{
    const Simulation *sim = screen_simulation(screen);
    for (size_t i = 0; i < sizeof inspectors / sizeof *inspectors; i++)
        if (simulation_has(sim, inspectors[i]->needs))
            return inspectors[i];
    return NULL;
}

void inspector_choose_across(Screen *screen, bool node)
{
    if (screen_has(screen, HAS_MESH))
        inspector_move(screen, 0, node ? -1 : 1, 1);
}

bool inspector_move(Screen *screen, int x, int y, int page)
{
    const Inspector *inspector = inspector_find(screen);
    if (!inspector || !inspector->move)
        return false;
    inspector->move(screen, x, y, page);
    return true;
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    (void)variant;
    if (inspector_find(screen))
        inspector_find(screen)->describe(screen, picture);
}

const View view_inspector = {
    .word = "inspector",
    .describe = describe,
    .duel = DUEL_TOGETHER,
    .of_moment = true,
    .is_list = true,
    .on_paper = true,
};

/* Which inspector a simulation has: one row for each, the first that fits is taken. */
#include "view/panes/panes.h"

static const Inspector inspectors[] = {
    {HAS_MESH | HAS_LINE, pane_mesh_inspector, pane_mesh_inspector_move},
    {HAS_BONDS | HAS_LINE, pane_bonds, pane_bonds_move},
    {HAS_BONDS | HAS_PLANE, pane_family, pane_family_move},
};

const Inspector *inspector_find(const Screen *screen)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    for (size_t i = 0; i < sizeof inspectors / sizeof *inspectors; i++)
        if (simulation_has(sim, inspectors[i].needs))
            return &inspectors[i];
    return NULL;
}

bool screen_has_inspector(const Screen *screen)
{
    return inspector_find(screen) != NULL;
}

void screen_choose_across(Screen *screen, bool node)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    if (simulation_has(sim, HAS_MESH))
        pane_mesh_inspector_move(screen, 0, node ? -1 : 1, 1);
}

bool screen_move_inspector(Screen *screen, int x, int y, int page)
{
    const Inspector *inspector = inspector_find(screen);
    if (!inspector || !inspector->move)
        return false;
    inspector->move(screen, x, y, page);
    return true;
}

/* Which inspector a method has: one row for each, the first that fits is taken. */
#include "view/panes.h"

static const Inspector inspectors[] = {
    {has_mesh, pane_mesh_inspector, move_mesh_inspector},
    {has_families, pane_family, move_node},
};

const Inspector *inspector_find(const Screen *screen)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    for (size_t i = 0; i < sizeof inspectors / sizeof *inspectors; i++)
        if (inspectors[i].fits(sim))
            return &inspectors[i];
    return NULL;
}

bool screen_has_inspector(const Screen *screen)
{
    return inspector_find(screen) != NULL;
}

bool screen_move_inspector(Screen *screen, int x, int y, int page)
{
    const Inspector *inspector = inspector_find(screen);
    if (!inspector || !inspector->move)
        return false;
    inspector->move(screen, x, y, page);
    return true;
}

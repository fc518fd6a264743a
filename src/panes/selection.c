/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which particle or node is the chosen one: all panes show that, and the arrows go on from it. */
#include "panes/screen.h"
#include "panes/parameters_shown.h"

void selection_next(Selection *selection, const Simulation *sim, int direction, size_t by)
{
    const bool node = selection->is_node && sim->n_sets > 1;
    size_t *chosen = node ? &selection->node : &selection->particle;
    const size_t count = sim->counts[node ? 1 : 0];
    if (count == 0)
        return;
    if (direction < 0)
        *chosen = *chosen > by ? *chosen - by : 0;
    else
        *chosen = *chosen + by < count ? *chosen + by : count - 1;
}

size_t selection_middle(const Simulation *sim)
{
    return sim->columns > 0 ? sim->rows / 2 * sim->columns + sim->columns / 2 : sim->counts[0] / 2;
}

int screen_row_of(const Screen *screen, const Parameter *parameter)
{
    ParameterRow rows[PARAMETER_ROWS_MAX];
    const int count = screen_parameter_rows(screen, rows);
    int first = 0, found = -1;
    while (first < count && rows[first].heading)
        first++;
    for (int i = first; i < count && found < 0; i++)
        if (rows[i].parameter && rows[i].parameter == parameter)
            found = i;
    return found >= 0 ? found : first < count ? first : 0;
}

const View *screen_view_in(const Screen *screen, PaneId pane)
{
    return pane == PANE_UPPER ? screen->views.upper : pane == PANE_LOWER ? screen->views.lower : NULL;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a stage hands on and between which things, from the names that it reads and writes. */
#include "panes/stage_flow.h"

#include "base/text.h"
#include "panes/screen_runs.h"

#include <string.h>

/* How many of the names only this set has. */
static int own_names(const Simulation *sim, const char *words, int set)
{
    char word[64];
    int count = 0;
    while (text_next_word(&words, word, sizeof word))
        count += simulation_find_field(sim, set, word) >= 0 && simulation_find_field(sim, 1 - set, word) < 0;
    return count;
}

int stage_flow_target(const Simulation *sim, const Stage *stage)
{
    if (!simulation_has(sim, HAS_MESH))
        return 0;
    const int particles = own_names(sim, stage->writes, 0), nodes = own_names(sim, stage->writes, 1);
    if (particles != nodes)
        return nodes > particles;
    /* only shared names: what it reads of the one it writes to the other */
    return own_names(sim, stage->reads, 0) > 0;
}

Flow stage_flow(const Screen *screen, bool *inside)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const Stage *stage = &sim->stages[screen_box_stage(screen, inside)];
    *inside = *inside && !screen_is_running(screen);
    if (!*inside || !simulation_has(sim, HAS_MESH))
        return FLOW_NONE;
    if (strcmp(stage->id, "forget") == 0)
        return FLOW_FORGET;
    for (int i = 0; i < sim->n_exchanges; i++)
        if (strcmp(sim->exchanges[i].stage, stage->id) == 0)
            return sim->exchanges[i].to == 1 ? FLOW_TO_NODES : FLOW_TO_PARTICLES;
    return FLOW_NONE;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keeps and drops keyframes (history.h). Snapshots are those of method.h; restoring one and replaying the
 * steps since gives the same bits as the run had. */
#include "run/history.h"

#include "base/assertion.h"

#include <stdlib.h>

/* Replaying a few dozen steps takes no noticeable time; a shorter interval would fill the memory with small
 * frames. */
enum { FIRST_INTERVAL = 32 };

void history_open(History *history, size_t budget)
{
    *history = (History){.budget = budget, .interval = FIRST_INTERVAL};
}

static void drop(History *history, size_t i)
{
    history->used -= history->frames[i].size;
    free(history->frames[i].bytes);
}

void history_close(History *history)
{
    for (size_t i = 0; i < history->count; i++)
        free(history->frames[i].bytes);
    free(history->frames);
    *history = (History){0};
}

static void thin(History *history)
{
    size_t kept = 0;
    history->interval *= 2;
    for (size_t i = 0; i < history->count; i++) {
        if (history->frames[i].step % history->interval == 0)
            history->frames[kept++] = history->frames[i];
        else
            drop(history, i);
    }
    history->count = kept;
}

void history_set_budget(History *history, size_t budget)
{
    history->budget = budget;
    while (history->count > 1 && history->used > budget)
        thin(history);
}

static bool make_room(History *history)
{
    if (history->count < history->room)
        return true;
    size_t room = history->room ? 2 * history->room : 16;
    Keyframe *frames = realloc(history->frames, room * sizeof *frames);
    if (!frames)
        return false;
    history->frames = frames;
    history->room = room;
    return true;
}

bool history_keep(History *history, const Simulation *sim)
{
    ASSERT_INT(sim->stage, ==, 0); /* a keyframe is a whole step */
    ASSERT_INT(sim->item, ==, 0);
    bool first = history->count == 0;
    if (sim->step % history->interval != 0 ||
        (!first && history->frames[history->count - 1].step >= sim->step))
        return true;
    size_t size = simulation_snapshot_size(sim);
    while (!first && history->used + size > history->budget) {
        if (history->count == 1)
            return true; /* nothing to give up but t = 0 */
        thin(history);
        if (sim->step % history->interval != 0)
            return true;
    }
    unsigned char *bytes = make_room(history) ? malloc(size) : NULL;
    if (!bytes)
        return !first;
    simulation_snapshot(sim, bytes);
    history->frames[history->count++] = (Keyframe){sim->step, size, bytes};
    history->used += size;
    return true;
}

const Keyframe *history_nearest(const History *history, long step)
{
    ASSERT_INT(step, >=, 0);
    size_t low = 0, high = history->count; /* frames before `low` are not later, from `high` on they are */
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (history->frames[middle].step <= step)
            low = middle + 1;
        else
            high = middle;
    }
    return low > 0 ? &history->frames[low - 1] : NULL;
}

void history_cut(History *history, long step)
{
    ASSERT_INT(step, >=, 0);
    while (history->count > 1 && history->frames[history->count - 1].step >= step)
        drop(history, --history->count);
}

void history_reset(History *history)
{
    history_cut(history, 1);
    history->interval = FIRST_INTERVAL;
}

long history_next(const History *history, long step)
{
    ASSERT_INT(step, >=, 0);
    return history->interval - step % history->interval;
}

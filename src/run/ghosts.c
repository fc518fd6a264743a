/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ghosts: the curves of earlier runs behind those of the present one. */
#include "run/experiment_internal.h"
#include "scenario/parameters.h"

#include <stdlib.h>
#include <string.h>

void experiment_drop_ghost(Ghost *ghost)
{
    free(ghost->settings);
    record_close(&ghost->record);
    profile_close(&ghost->profile);
    simulation_release_names(ghost->names);
    for (int i = 0; ghost->spectra && i < SPECTRUM_SPANS; i++)
        spectrum_close(&ghost->spectra[i]);
    free(ghost->spectra);
    memset(ghost, 0, sizeof *ghost);
}

void experiment_write_legends(Experiment *experiment)
{
    for (int i = 0; i < GHOSTS_MAX; i++) {
        Ghost *ghost = &experiment->ghosts[i];
        if (ghost->used)
            settings_name(ghost->settings, &experiment->base, ghost->legend, sizeof ghost->legend);
    }
}

Ghost experiment_leave(const Experiment *experiment, Record kept)
{
    const Record *record = &experiment->record;
    const size_t rows = record->count - record->loose_last;
    Ghost left = {
        .settings = malloc(sizeof *left.settings), .record = kept, .n_columns = experiment->n_columns};
    if (!left.settings)
        return left;
    *left.settings = experiment->base;
    memcpy(left.columns, experiment->columns, sizeof left.columns);
    references_readout(experiment->refs, record->rows, rows, record->n_columns, &left.readout);
    profile_take(&left.profile, experiment->run.sim, NULL);
    CrackFronts *fronts = &experiment->worked->fronts;
    crack_line_keep(experiment->run.sim, &experiment->base,
                    crack_fronts_update(fronts, experiment->run.sim) ? fronts : NULL, &left.crack);
    left.names = simulation_hold_names(experiment->run.sim);
    return left;
}

/* A place for a ghost; the unpinned one has its place for itself. NULL: all are taken. */
static Ghost *find_place(Experiment *experiment, bool pinned)
{
    Ghost *found = NULL;
    int n_pinned = 0;
    for (int i = GHOSTS_MAX - 1; i >= 0; i--) {
        Ghost *ghost = &experiment->ghosts[i];
        n_pinned += ghost->used && ghost->pinned;
        if (!ghost->used)
            found = ghost;
    }
    for (int i = 0; i < GHOSTS_MAX && !pinned; i++)
        if (experiment->ghosts[i].used && !experiment->ghosts[i].pinned)
            found = &experiment->ghosts[i];
    return pinned && n_pinned == GHOSTS_MAX - 1 ? NULL : found;
}

void experiment_keep_ghost(Experiment *experiment, bool pinned, Ghost *left)
{
    Ghost *ghost = left->settings && left->record.count > 0 ? find_place(experiment, pinned) : NULL;
    if (ghost) {
        experiment_drop_ghost(ghost);
        *ghost = *left;
        ghost->used = true;
        ghost->pinned = pinned;
        ghost->letter = (char)('a' + (ghost - experiment->ghosts));
        ghost->spectra = calloc(SPECTRUM_SPANS, sizeof *ghost->spectra);
        *left = (Ghost){.used = false};
    }
    experiment_drop_ghost(left);
}

bool experiment_has_curve(const Experiment *experiment)
{
    return experiment->record.count > 1 &&
           !(experiment->pending && experiment->newest < experiment->goal_step);
}

/* The pinned ghost of the same settings; NULL: there is none. */
static Ghost *pinned(Experiment *experiment)
{
    for (Ghost *ghost = experiment->ghosts; ghost < experiment->ghosts + GHOSTS_MAX; ghost++)
        if (ghost->used && ghost->pinned && settings_same(ghost->settings, &experiment->base))
            return ghost;
    return NULL;
}

bool experiment_is_pinned(Experiment *experiment)
{
    const Ghost *ghost = pinned(experiment);
    return ghost && ghost->record.count >= experiment->record.count;
}

void experiment_drop_unpinned(Experiment *experiment)
{
    for (int i = 0; i < GHOSTS_MAX; i++)
        if (!experiment->ghosts[i].pinned)
            experiment_drop_ghost(&experiment->ghosts[i]);
}

bool experiment_pin(Experiment *experiment, Status *status)
{
    if (pinned(experiment)) {
        experiment_drop_ghost(pinned(experiment));
        return true;
    }
    if (!find_place(experiment, true))
        return status_refuse(status, "%d curves are pinned already (unpin one first)", GHOSTS_MAX - 1);
    Record copy;
    if (!record_copy(&copy, &experiment->record))
        return status_fail(status, "not enough memory to pin the curves");
    Ghost left = experiment_leave(experiment, copy);
    experiment_keep_ghost(experiment, true, &left);
    experiment_write_legends(experiment);
    return true;
}

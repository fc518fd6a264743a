/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ghosts: the curves of earlier runs behind those of the present one. */
#include "run/experiment_internal.h"
#include "scenario/settings.h"
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

/* The readout of a run at the newest row of its record. */
static Readout read_whole(const Experiment *experiment)
{
    const Record *record = &experiment->record;
    Readout readout;
    size_t rows = record->count - (record->loose_last && record->count > 0 ? 1 : 0);
    references_readout(experiment->refs, record->rows, rows, record->n_columns, &readout);
    return readout;
}

GhostData experiment_ghost_data(const Experiment *experiment)
{
    GhostData ghost_data = {
        .base = experiment->base, .n_columns = experiment->n_columns, .readout = read_whole(experiment)};
    memcpy(ghost_data.columns, experiment->columns, sizeof ghost_data.columns);
    profile_take(&ghost_data.profile, experiment->run.sim, NULL);
    const CrackFronts *fronts = crack_fronts_update(&experiment->worked->fronts, experiment->run.sim)
                                    ? &experiment->worked->fronts
                                    : NULL;
    crack_line_keep(experiment->run.sim, &experiment->base, fronts, &ghost_data.crack);
    ghost_data.names = simulation_hold_names(experiment->run.sim);
    return ghost_data;
}

void experiment_drop_ghost_data(GhostData *ghost_data)
{
    profile_close(&ghost_data->profile);
    simulation_release_names(ghost_data->names);
    memset(ghost_data, 0, sizeof *ghost_data);
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

bool experiment_make_ghost(Experiment *experiment, bool pinned, Record *record, GhostData *ghost_data)
{
    Ghost *ghost = find_place(experiment, pinned);
    Settings *settings = ghost ? malloc(sizeof *settings) : NULL;
    if (!settings)
        return false;
    experiment_drop_ghost(ghost);
    ghost->used = true;
    ghost->pinned = pinned;
    ghost->letter = (char)('a' + (ghost - experiment->ghosts));
    *settings = ghost_data->base;
    ghost->settings = settings;
    ghost->record = *record;
    memcpy(ghost->columns, ghost_data->columns, sizeof ghost->columns);
    ghost->n_columns = ghost_data->n_columns;
    ghost->readout = ghost_data->readout;
    ghost->profile = ghost_data->profile;
    ghost->crack = ghost_data->crack;
    ghost->names = ghost_data->names;
    ghost->spectra = calloc(SPECTRUM_SPANS, sizeof *ghost->spectra);
    memset(record, 0, sizeof *record);
    memset(ghost_data, 0, sizeof *ghost_data);
    return true;
}

bool experiment_has_curve(const Experiment *experiment)
{
    return experiment->record.count > 1 &&
           !(experiment->pending && experiment->newest < experiment->goal_step);
}

bool experiment_is_pinned(const Experiment *experiment)
{
    for (int i = 0; i < GHOSTS_MAX; i++) {
        const Ghost *ghost = &experiment->ghosts[i];
        if (ghost->used && ghost->pinned && settings_same(ghost->settings, &experiment->base) &&
            ghost->record.count >= experiment->record.count)
            return true;
    }
    return false;
}

void experiment_drop_unpinned(Experiment *experiment)
{
    for (int i = 0; i < GHOSTS_MAX; i++)
        if (!experiment->ghosts[i].pinned)
            experiment_drop_ghost(&experiment->ghosts[i]);
}

bool experiment_pin(Experiment *experiment, Status *status)
{
    for (int i = 0; i < GHOSTS_MAX; i++) {
        Ghost *ghost = &experiment->ghosts[i];
        if (ghost->used && ghost->pinned && settings_same(ghost->settings, &experiment->base)) {
            experiment_drop_ghost(ghost);
            return true;
        }
    }
    if (!find_place(experiment, true))
        return status_refuse(status, "%d curves are pinned already (unpin one first)", GHOSTS_MAX - 1);
    Record copy;
    if (!record_copy(&copy, &experiment->record))
        return status_fail(status, "not enough memory to pin the curves");
    GhostData ghost_data = experiment_ghost_data(experiment);
    experiment_make_ghost(experiment, true, &copy, &ghost_data);
    experiment_write_legends(experiment);
    return true;
}

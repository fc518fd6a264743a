/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What front ends read of an experiment: step, rows, readout, references, events (experiment.h); and goals,
 * on whose way the run itself is moved by experiment_run.c. */
#include "base/assertion.h"
#include "run/experiment_internal.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void experiment_set_history(Experiment *experiment, size_t history)
{
    history_set_budget(&experiment->history, history);
}

/* --- what there is -------------------------------------------------------------------------------- */

#define READ(Type, name, what)                                                                               \
    Type name(const Experiment *experiment)                                                                  \
    {                                                                                                        \
        return what;                                                                                         \
    }
READ(const Settings *, experiment_settings, &experiment->now)
READ(const Settings *, experiment_base, &experiment->base)
READ(const Simulation *, experiment_simulation, experiment->run.sim)
READ(References *, experiment_references, experiment->refs)
READ(const Record *, experiment_record, &experiment->record)
READ(const Ghost *, experiment_ghosts, experiment->ghosts)
READ(const char *, experiment_advice, experiment->advice)
READ(double, experiment_time, simulation_time(experiment->run.sim))
READ(long, experiment_step, experiment->run.sim->step)
READ(int, experiment_stage, experiment->run.sim->stage)
READ(long, experiment_newest, experiment->newest)
READ(long, experiment_last_step, experiment->run.last)
READ(bool, experiment_at_end,
     experiment->run.sim->stage == 0 && experiment->run.sim->step >= experiment->run.last)
READ(bool, experiment_is_flowing, experiment->flowing)

const Column *experiment_columns(const Experiment *experiment, int *count)
{
    *count = experiment->n_columns;
    return experiment->columns;
}

const Event *experiment_events(const Experiment *experiment, int *count)
{
    event_log_update(&experiment->worked->log, experiment, experiment_readout(experiment));
    *count = experiment->worked->log.count;
    return experiment->worked->log.events;
}

int experiment_column(const Experiment *experiment, const char *name)
{
    return references_column(experiment->columns, experiment->n_columns, name);
}

int experiment_derived(const Experiment *experiment, Derived out[DERIVED_MAX])
{
    const Worked *worked = experiment->worked;
    if (worked->n_derived == 0 || memcmp(&worked->derived_for, &experiment->now, sizeof experiment->now) != 0)
        experiment_derive(experiment, (Cancel){0}); /* a picture is not interrupted */
    memcpy(out, worked->derived, (size_t)worked->n_derived * sizeof *out);
    return worked->n_derived;
}

bool experiment_failed(const Experiment *experiment, Status *status)
{
    if (experiment->run.failed)
        status_take(status, &experiment->run.failure);
    return experiment->run.failed;
}

void experiment_scenario(const Experiment *experiment, bool to_newest, Settings *out)
{
    long step = to_newest ? experiment->newest : experiment->run.sim->step;
    *out = experiment->base;
    problem_end_at(out, experiment->run.sim->dt, step);
}

/* A fit over thousands of rows is not free: while rows come in, it is done when their number has grown by a
 * tenth; once they stop coming, exactly. */
const Readout *experiment_readout(const Experiment *experiment)
{
    const Record *record = &experiment->record;
    Readout *readout = &experiment->worked->readout;
    size_t rows = record->count - record->loose_last, known = experiment->worked->readout_rows;
    bool still = !experiment->flowing || experiment->run.sim->step >= experiment->run.last;
    if (known == 0 || rows < known || rows > known + known / 10 || (still && rows != known)) {
        references_readout(experiment->refs, record->rows, rows, record->n_columns, readout);
        /* for want of memory it is asked for again */
        experiment->worked->readout_rows = readout->no_memory ? 0 : rows;
    }
    readout->time = simulation_time(experiment->run.sim);
    readout->late = readout_late(readout, readout->time);
    return readout;
}

const CrackFronts *experiment_fronts(const Experiment *experiment)
{
    CrackFronts *fronts = &experiment->worked->fronts;
    return crack_fronts_update(fronts, experiment->run.sim) ? fronts : NULL;
}

const Spectrum *experiment_spectrum(const Experiment *experiment, int column, SpectrumSpan span)
{
    ASSERT_INDEX(column, experiment->n_columns);
    Spectrum *spectrum = &experiment->worked->spectra[span];
    return spectrum_of(&experiment->record, column, span, spectrum) ? spectrum : NULL;
}

const Spectrum *experiment_ghost_spectrum(const Experiment *experiment, int i, int column, SpectrumSpan span)
{
    ASSERT_INDEX(i, GHOSTS_MAX);
    const Ghost *ghost = &experiment->ghosts[i];
    Spectrum *spectrum = ghost->spectra ? &ghost->spectra[span] : NULL;
    return spectrum && spectrum_of(&ghost->record, column, span, spectrum) ? spectrum : NULL;
}

/* The record's row where it is kept; else it is worked out, which is possible between steps only. */
const double *experiment_row(const Experiment *experiment)
{
    Simulation *sim = experiment->run.sim;
    Worked *worked = experiment->worked;
    const double time = simulation_time(sim), *kept = record_of_step(&experiment->record, sim->step);
    if (kept)
        return kept;
    if (worked->row_step == sim->step)
        return worked->row;
    const double *near = record_row(&experiment->record, record_find(&experiment->record, time));
    if (sim->stage != 0)
        return near;
    simulation_row(sim, experiment->run.block);
    references_row_again(experiment->refs, sim->step, time, experiment->run.block, near, worked->row);
    worked->row_step = sim->step;
    return worked->row;
}

/* --- forwards ------------------------------------------------------------------------------------- */

void experiment_flow(Experiment *experiment)
{
    experiment->flowing = true;
}

void experiment_rest(Experiment *experiment)
{
    experiment->flowing = false;
}

/* In a buffer that grows. False: not enough memory. */
static bool keep(const Simulation *sim, Kept *kept)
{
    size_t size = simulation_snapshot_size(sim);
    kept->known = false;
    if (size > kept->room) {
        unsigned char *more = realloc(kept->bytes, size);
        if (!more)
            return false;
        kept->bytes = more;
        kept->room = size;
    }
    simulation_snapshot(sim, kept->bytes);
    kept->head = size - sim->method->state_size(sim);
    return kept->known = true;
}

static bool next_stage(Experiment *experiment, Status *status)
{
    if (experiment_at_end(experiment))
        return true;
    experiment_row(experiment); /* in the middle of a step it could not be worked out */
    keep(experiment->run.sim, &experiment->before);
    if (experiment_go(experiment, RUN_STAGES, 1, status))
        return true;
    experiment->before.known = false;
    return false;
}

bool experiment_next_stage(Experiment *experiment, Status *status)
{
    experiment_cancel(experiment);
    return next_stage(experiment, status);
}

const void *experiment_before(const Experiment *experiment)
{
    const Kept *before = &experiment->before;
    return before->known ? before->bytes + before->head : NULL;
}

typedef struct Look {
    int field;
    size_t first, count;
    double *out;
} Look;

static void look(Simulation *sim, void *context)
{
    const Look *at = context;
    sim->method->field(sim, at->field, at->first, at->count, at->out);
}

bool experiment_field_before(const Experiment *experiment, int field, size_t first, size_t count, double *out)
{
    ASSERT_INDEX(field, experiment->run.sim->n_fields);
    return experiment->before.known && simulation_visit(experiment->run.sim, experiment->before.bytes, look,
                                                        &(Look){field, first, count, out});
}

/* The sums of a thing after a stage of the step that comes. */
typedef struct Ahead {
    int stage, set, terms;
    size_t index;
    char *out;
    size_t size;
    bool walked;
} Ahead;

static void look_ahead(Simulation *sim, void *context)
{
    Ahead *ahead = context;
    void *before;
    ahead->walked = simulation_make_stage(sim, ahead->stage, &before);
    if (ahead->walked)
        sim->method->explain(sim, ahead->stage, ahead->set, ahead->index, before, ahead->terms, ahead->out,
                             ahead->size);
    free(before);
}

bool experiment_explain_beside(const Experiment *experiment, const Experiment *other, int stage, int set,
                               size_t index, int terms, char *out, size_t size)
{
    Simulation *sim = experiment->run.sim;
    const Simulation *theirs = other->run.sim;
    Ahead ahead = {sim->n_stages - 1, set, terms, index, out, size, false};
    while (ahead.stage >= 0 && strcmp(sim->stages[ahead.stage].id, theirs->stages[stage].id) != 0)
        ahead.stage--;
    if (ahead.stage < 0 || set >= sim->n_sets || index >= sim->counts[set] || !sim->method->explain ||
        experiment->pending || sim->stage != 0 || sim->item != 0 || sim->step != theirs->step ||
        sim->dt != theirs->dt)
        return false;
    if (theirs->stage > 0)
        return simulation_visit(sim, NULL, look_ahead, &ahead) && ahead.walked;
    if (ahead.stage != sim->n_stages - 1) /* the step is whole, and what came before its last stage is gone */
        return false;
    sim->method->explain(sim, ahead.stage, set, index, NULL, terms, out, size);
    return true;
}

/* --- on the way to a goal --------------------------------------------------------------------------- */

static bool is_begun(const Simulation *sim)
{
    return sim->stage != 0 || sim->item != 0;
}

/* Back to where the step began. */
static void undo_part(Experiment *experiment)
{
    if (experiment->part.known)
        simulation_restore(experiment->run.sim, experiment->part.bytes);
    experiment->part.known = false;
}

void experiment_drop_part(Experiment *experiment)
{
    undo_part(experiment);
    experiment->pending = experiment->pending && !experiment->goes_on;
}

void experiment_seek(Experiment *experiment, long step, int stage)
{
    ASSERT_INT(stage, >=, 0);
    undo_part(experiment);
    if (step < 0)
        step = 0, stage = 0;
    if (step >= experiment->run.last)
        step = experiment->run.last, stage = 0;
    experiment->goes_on = false;
    experiment->goal_step = step;
    experiment->goal_stage = stage;
    experiment->pending = experiment->run.sim->step != step || experiment->run.sim->stage != stage;
}

void experiment_go_on(Experiment *experiment, long steps)
{
    ASSERT_INT(steps, >=, 0);
    undo_part(experiment);
    const Simulation *sim = experiment->run.sim;
    const long from = sim->step + is_begun(sim);
    experiment_seek(experiment, steps < experiment->run.last - from ? from + steps : experiment->run.last, 0);
    experiment->goes_on = experiment->flowing = true;
    experiment->before.known = false;
}

bool experiment_pending(const Experiment *experiment, long *steps_left)
{
    if (!experiment->pending)
        return false;
    const Simulation *sim = experiment->run.sim;
    long from = sim->step;
    if (from > experiment->goal_step) {
        const Keyframe *frame = history_nearest(&experiment->history, experiment->goal_step);
        from = frame ? frame->step : 0;
    }
    if (steps_left)
        *steps_left = experiment->goal_step - from;
    return true;
}

bool experiment_work_off(Experiment *experiment, Cancel cancel, Status *status)
{
    const long slice = simulation_steps_per_poll(experiment->run.sim);
    long left, all = 1;
    while (experiment_pending(experiment, &left)) {
        all = left > all ? left : all;
        if (!experiment_work(experiment, (Effort){.steps = slice}, &(bool){false}, status))
            return false;
        if (cancel_requested(&cancel, 1 - (double)left / (double)all))
            return status_fail(status, "interrupted");
    }
    return true;
}

void experiment_goal(const Experiment *experiment, long *step, int *stage)
{
    const Simulation *sim = experiment->run.sim;
    *step = experiment->pending ? experiment->goal_step : sim->step;
    *stage = experiment->pending ? experiment->goal_stage : sim->stage;
}

/* A part of a step, from which there is a way back; without memory for that there must be no stop in it. */
static bool do_part(Experiment *experiment, double share, bool *whole, Status *status)
{
    Kept *part = &experiment->part;
    const Simulation *sim = experiment->run.sim;
    const double items = fmin(share, 1) * (double)sim->stage_items;
    if (!is_begun(sim) && experiment->run.failed && sim->step >= experiment->newest)
        return status_take(status, &experiment->run.failure);
    if (!part->known && !keep(sim, part))
        return experiment_do_steps(experiment, !is_begun(sim), status);
    const bool sound = experiment_go(experiment, RUN_ITEMS, items < 1 ? 1 : (long)items, status);
    *whole = !is_begun(sim);
    part->known = sound && !*whole;
    return sound;
}

bool experiment_work(Experiment *experiment, Effort effort, bool *whole, Status *status)
{
    ASSERT_INT(effort.steps, >=, 0);
    const Simulation *sim = experiment->run.sim;
    bool sound = true;
    *whole = true;
    if (!(effort.share > 0))
        undo_part(experiment);
    if (!experiment->pending)
        return true;
    if (!experiment->part.known)
        experiment_approach(experiment, experiment->goal_step, experiment->goal_stage);
    if (sim->step < experiment->goal_step) {
        const long left = experiment->goal_step - sim->step - is_begun(sim);
        experiment->before.known = false;
        sound = effort.share > 0
                    ? do_part(experiment, effort.share, whole, status)
                    : experiment_do_steps(experiment, left < effort.steps ? left : effort.steps, status);
        experiment->pending = sound && (!*whole || sim->step < experiment->goal_step);
        if (!sound || experiment->pending)
            return sound;
    }
    experiment->pending = false;
    if (sim->stage == 0)
        experiment->before.known = false;
    while (sim->step == experiment->goal_step && sim->stage < experiment->goal_stage &&
           sim->stage + 1 < sim->n_stages)
        if (!next_stage(experiment, status))
            return false;
    return true;
}

bool experiment_advance(Experiment *experiment, long steps, Status *status)
{
    experiment_go_on(experiment, steps);
    return experiment_work(experiment, (Effort){.steps = LONG_MAX}, &(bool){false}, status);
}

void experiment_cancel(Experiment *experiment)
{
    undo_part(experiment);
    experiment->pending = false;
}

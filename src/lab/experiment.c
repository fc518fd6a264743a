#include "lab/experiment.h"
#include "lab/changes.h"
#include "lab/parameters.h"
#include "lab/trial.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The state before the last stage. */
typedef struct Before {
    unsigned char *bytes;
    size_t room, head; /* what simulation_snapshot() puts before the method's own bytes */
    bool known;
} Before;

struct Experiment {
    Trial trial;
    size_t history;
    int threads;
    Change given[CHANGES_MAX]; /* the changes that came with the settings, not made by hand */
    int n_given;
    Ghost ghosts[GHOSTS_MAX];
    bool pending;
    long goal_step;
    int goal_stage;
    Before before;
    double row[COLUMNS_MAX];
    long row_step; /* the step that `row` belongs to; -1: none */
    Readout readout;
    size_t readout_rows; /* how many rows it was worked out from */
    bool flowing;        /* rows come in: it is worked out now and then only */
};

/* --- life ----------------------------------------------------------------------------------------- */

static void keep_given(Experiment *experiment, const Settings *settings)
{
    memcpy(experiment->given, settings->changes, sizeof experiment->given);
    experiment->n_given = settings->n_changes;
}

Experiment *experiment_create(const Settings *settings, size_t history, int threads, Status *status)
{
    Experiment *experiment = calloc(1, sizeof *experiment);
    if (!experiment) {
        status_fail(status, STATUS_FAILED, "not enough memory");
        return NULL;
    }
    experiment->history = history;
    experiment->threads = threads;
    experiment->row_step = -1;
    keep_given(experiment, settings);
    if (!trial_open(&experiment->trial, settings, history, threads, status)) {
        free(experiment);
        return NULL;
    }
    return experiment;
}

static void drop_ghost(Ghost *ghost)
{
    record_close(&ghost->record);
    memset(ghost, 0, sizeof *ghost);
}

void experiment_destroy(Experiment *experiment)
{
    if (!experiment)
        return;
    for (int i = 0; i < GHOSTS_MAX; i++)
        drop_ghost(&experiment->ghosts[i]);
    trial_close(&experiment->trial);
    free(experiment->before.bytes);
    free(experiment);
}

/* --- what there is -------------------------------------------------------------------------------- */

const Settings *experiment_settings(const Experiment *experiment)
{
    return &experiment->trial.now;
}

const Simulation *experiment_simulation(const Experiment *experiment)
{
    return experiment->trial.sim;
}

References *experiment_references(const Experiment *experiment)
{
    return experiment->trial.refs;
}

const Record *experiment_record(const Experiment *experiment)
{
    return &experiment->trial.record;
}

const Column *experiment_columns(const Experiment *experiment, int *count)
{
    *count = experiment->trial.n_columns;
    return experiment->trial.columns;
}

const Ghost *experiment_ghosts(const Experiment *experiment)
{
    return experiment->ghosts;
}

const char *experiment_advice(const Experiment *experiment)
{
    return experiment->trial.advice;
}

const Event *experiment_events(const Experiment *experiment, int *count)
{
    *count = experiment->trial.n_events;
    return experiment->trial.events;
}

int experiment_derived(const Experiment *experiment, Derived out[DERIVED_MAX])
{
    return problem_derived(&experiment->trial.now, experiment->trial.sim, out);
}

double experiment_time(const Experiment *experiment)
{
    return simulation_time(experiment->trial.sim);
}

long experiment_step(const Experiment *experiment)
{
    return experiment->trial.sim->step;
}

int experiment_stage(const Experiment *experiment)
{
    return experiment->trial.sim->stage;
}

long experiment_newest(const Experiment *experiment)
{
    return experiment->trial.newest;
}

long experiment_last_step(const Experiment *experiment)
{
    return experiment->trial.last;
}

bool experiment_at_end(const Experiment *experiment)
{
    const Trial *trial = &experiment->trial;
    return trial->sim->stage == 0 && trial->sim->step >= trial->last;
}

bool experiment_failed(const Experiment *experiment, Status *status)
{
    if (experiment->trial.failed && status)
        *status = experiment->trial.failure;
    return experiment->trial.failed;
}

void experiment_scenario(const Experiment *experiment, bool to_newest, Settings *out)
{
    const Trial *trial = &experiment->trial;
    long step = to_newest ? trial->newest : trial->sim->step;
    *out = trial->base;
    problem_end_at(out, trial->sim->dt, step);
}

/* A fit over thousands of rows is not free: while rows come in, it is done when their number has grown by a
 * tenth; once they stop coming, exactly. */
const Readout *experiment_readout(Experiment *experiment)
{
    const Trial *trial = &experiment->trial;
    const Record *record = &trial->record;
    size_t rows = record->count - (record->loose_last && record->count > 0 ? 1 : 0);
    size_t known = experiment->readout_rows;
    bool still = !experiment->flowing || trial->sim->step >= trial->last;
    if (known == 0 || rows < known || rows > known + known / 10 || (still && rows != known)) {
        references_readout(trial->refs, record->rows, rows, record->n_columns, &experiment->readout);
        experiment->readout_rows = rows;
    }
    experiment->readout.time = simulation_time(trial->sim);
    experiment->readout.late = readout_late(&experiment->readout, experiment->readout.time);
    return &experiment->readout;
}

/* The record's row where it is kept; else it is worked out, which is possible between steps only. */
const double *experiment_row(Experiment *experiment)
{
    Trial *trial = &experiment->trial;
    Simulation *sim = trial->sim;
    const double *kept = record_of_step(&trial->record, sim->step);
    if (kept)
        return kept;
    const double *near = record_row(&trial->record, record_find(&trial->record, simulation_time(sim)));
    if (experiment->row_step == sim->step)
        return experiment->row;
    if (sim->stage != 0)
        return near;
    simulation_row(sim, trial->block);
    references_row_again(trial->refs, sim->step, simulation_time(sim), trial->block, near, experiment->row);
    experiment->row_step = sim->step;
    return experiment->row;
}

/* --- forwards ------------------------------------------------------------------------------------- */

bool experiment_advance(Experiment *experiment, long steps, Status *status)
{
    experiment->pending = false;
    experiment->flowing = true;
    experiment->before.known = false;
    return trial_steps(&experiment->trial, steps, status);
}

void experiment_rest(Experiment *experiment)
{
    experiment->flowing = false;
}

static void note_before(Experiment *experiment)
{
    const Simulation *sim = experiment->trial.sim;
    Before *before = &experiment->before;
    size_t size = simulation_snapshot_size(sim);
    before->known = false;
    if (size > before->room) {
        unsigned char *bytes = realloc(before->bytes, size);
        if (!bytes)
            return;
        before->bytes = bytes;
        before->room = size;
    }
    before->head = size - sim->method->state_size(sim);
    simulation_snapshot(sim, before->bytes);
    before->known = true;
}

static bool next_stage(Experiment *experiment, Status *status)
{
    if (experiment_at_end(experiment))
        return true;
    experiment_row(experiment); /* in the middle of a step it could not be worked out */
    note_before(experiment);
    if (trial_stage(&experiment->trial, status))
        return true;
    experiment->before.known = false;
    return false;
}

bool experiment_next_stage(Experiment *experiment, Status *status)
{
    experiment->pending = false;
    return next_stage(experiment, status);
}

const void *experiment_before(const Experiment *experiment)
{
    const Before *before = &experiment->before;
    return before->known ? before->bytes + before->head : NULL;
}

bool experiment_field_before(Experiment *experiment, int field, size_t first, size_t count, double *out)
{
    Simulation *sim = experiment->trial.sim;
    if (!experiment->before.known)
        return false;
    void *present = malloc(simulation_snapshot_size(sim));
    if (!present)
        return false;
    simulation_snapshot(sim, present);
    simulation_restore(sim, experiment->before.bytes);
    sim->method->field(sim, field, first, count, out);
    simulation_restore(sim, present);
    free(present);
    return true;
}

/* --- seeking -------------------------------------------------------------------------------------- */

void experiment_seek(Experiment *experiment, long step, int stage)
{
    const Trial *trial = &experiment->trial;
    if (step < 0)
        step = 0, stage = 0;
    if (step >= trial->last)
        step = trial->last, stage = 0;
    experiment->goal_step = step;
    experiment->goal_stage = stage > 0 ? stage : 0;
    experiment->pending = trial->sim->step != step || trial->sim->stage != experiment->goal_stage;
}

bool experiment_pending(const Experiment *experiment, long *steps_left)
{
    if (!experiment->pending)
        return false;
    const Simulation *sim = experiment->trial.sim;
    long from = sim->step;
    if (from > experiment->goal_step) {
        const Keyframe *frame = history_nearest(&experiment->trial.history, experiment->goal_step);
        from = frame ? frame->step : 0;
    }
    if (steps_left)
        *steps_left = experiment->goal_step - from;
    return true;
}

bool experiment_work(Experiment *experiment, long steps, Status *status)
{
    Trial *trial = &experiment->trial;
    Simulation *sim = trial->sim;
    if (!experiment->pending)
        return true;
    trial_approach(trial, experiment->goal_step, experiment->goal_stage);
    if (sim->step < experiment->goal_step) {
        experiment->before.known = false;
        bool begun = sim->stage != 0;
        bool sound = !begun || trial_steps(trial, 0, status);
        long left = experiment->goal_step - sim->step;
        if (!sound || !trial_steps(trial, left < steps ? left : steps, status)) {
            experiment->pending = false;
            return false;
        }
        if (sim->step < experiment->goal_step)
            return true;
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

void experiment_cancel(Experiment *experiment)
{
    experiment->pending = false;
}

/* --- ghosts --------------------------------------------------------------------------------------- */

static bool leads_to_the_same(const Settings *a, const Settings *b)
{
    return settings_same(a, b, NULL, 0);
}

/* Legends tell what differs from the run that is on screen now. */
static void write_legends(Experiment *experiment)
{
    for (int i = 0; i < GHOSTS_MAX; i++) {
        Ghost *ghost = &experiment->ghosts[i];
        if (ghost->used &&
            settings_same(&ghost->settings, &experiment->trial.base, ghost->legend, sizeof ghost->legend))
            snprintf(ghost->legend, sizeof ghost->legend, "the same");
    }
}

/* What the record of a run says to its newest row. */
static Readout read_whole(const Trial *trial)
{
    const Record *record = &trial->record;
    Readout readout;
    size_t rows = record->count - (record->loose_last && record->count > 0 ? 1 : 0);
    references_readout(trial->refs, record->rows, rows, record->n_columns, &readout);
    return readout;
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

/* The record is handed over, not copied. */
static void make_ghost(Experiment *experiment, Ghost *ghost, bool pinned, const Trial *from, Record *record,
                       const Readout *readout)
{
    drop_ghost(ghost);
    ghost->used = true;
    ghost->pinned = pinned;
    ghost->letter = (char)('a' + (ghost - experiment->ghosts));
    ghost->settings = from->base;
    ghost->record = *record;
    memcpy(ghost->columns, from->columns, sizeof ghost->columns);
    ghost->n_columns = from->n_columns;
    ghost->readout = *readout;
    memset(record, 0, sizeof *record);
}

/* Whether there is a curve worth keeping: one that is still on its way to the time on screen is not. */
static bool has_curve(const Experiment *experiment)
{
    return experiment->trial.record.count > 1 &&
           !(experiment->pending && experiment->trial.newest < experiment->goal_step);
}

bool experiment_pin(Experiment *experiment, Status *status)
{
    const Trial *trial = &experiment->trial;
    for (int i = 0; i < GHOSTS_MAX; i++) {
        Ghost *ghost = &experiment->ghosts[i];
        if (ghost->used && ghost->pinned && leads_to_the_same(&ghost->settings, &trial->base)) {
            drop_ghost(ghost);
            return true;
        }
    }
    Ghost *place = find_place(experiment, true);
    Record copy;
    if (!place)
        return status_fail(status, STATUS_USAGE, "%d curves are pinned already (unpin one first)",
                           GHOSTS_MAX - 1);
    if (!record_copy(&copy, &trial->record))
        return status_fail(status, STATUS_FAILED, "not enough memory to pin the curves");
    const Readout readout = read_whole(trial);
    make_ghost(experiment, place, true, trial, &copy, &readout);
    write_legends(experiment);
    return true;
}

/* --- edits ---------------------------------------------------------------------------------------- */

static void forget_derived(Experiment *experiment)
{
    experiment->before.known = false;
    experiment->row_step = -1;
    experiment->readout_rows = 0;
}

/* Another run takes the place of this one, and seeks the time that was on screen. */
static bool replace_trial(Experiment *experiment, const Settings *settings, bool keep_ghost, bool seek,
                          Status *status)
{
    Trial *trial = &experiment->trial;
    double time = simulation_time(trial->sim);
    if (experiment->pending)
        time = (double)experiment->goal_step * trial->sim->dt;
    Trial fresh;
    if (!trial_open(&fresh, settings, experiment->history, experiment->threads, status))
        return false;
    if (keep_ghost && has_curve(experiment)) {
        const Readout readout = read_whole(trial);
        make_ghost(experiment, find_place(experiment, false), false, trial, &trial->record, &readout);
    }
    trial_close(trial);
    *trial = fresh;
    experiment->pending = false;
    forget_derived(experiment);
    write_legends(experiment);
    if (seek)
        experiment_seek(experiment, lround(time / trial->sim->dt), 0);
    return true;
}

/* Copies the value of one parameter. */
static void copy_value(Settings *to, const Settings *from, const Parameter *parameter)
{
    char text[LIST_MAX];
    settings_get(from, parameter, text);
    settings_set(to, parameter->key, text, NULL);
}

/* What changes in mid-run begins with its own first value, whatever is in force now. */
static void begin_changed_ones(Settings *settings, const Settings *base)
{
    for (int i = 0; i < settings->n_changes; i++) {
        const Parameter *parameter = parameter_find(settings->changes[i].to.key);
        if (parameter)
            copy_value(settings, base, parameter);
    }
}

bool experiment_restart(Experiment *experiment, bool keep_ghost, Status *status)
{
    Trial *trial = &experiment->trial;
    Settings settings = trial->now;
    memcpy(settings.changes, experiment->given, sizeof settings.changes);
    settings.n_changes = experiment->n_given;
    begin_changed_ones(&settings, &trial->base);
    if (!replace_trial(experiment, &settings, keep_ghost, false, status))
        return false;
    for (int i = 0; i < GHOSTS_MAX && !keep_ghost; i++)
        if (!experiment->ghosts[i].pinned)
            drop_ghost(&experiment->ghosts[i]);
    return true;
}

typedef struct Difference {
    bool restart, live;
} Difference;

static bool recomputes(const Settings *settings, const Parameter *parameter)
{
    /* the moving cantilever's channel and its modal solution reach to the end */
    if (strcmp(parameter->key, "time.end") == 0)
        return settings->problem == PROBLEM_MOVING_CANTILEVER;
    /* the critical stretch says the same */
    if (strcmp(parameter->key, "pd.critical_energy") == 0)
        return false;
    return strncmp(parameter->key, "output.", 7) != 0;
}

static bool differs(const Settings *a, const Settings *b, const Parameter *parameter)
{
    char one[LIST_MAX], other[LIST_MAX];
    if (!parameter_applies(parameter, a->problem))
        return false;
    settings_get(a, parameter, one);
    settings_get(b, parameter, other);
    return strcmp(one, other) != 0;
}

static bool same_changes(const Settings *a, const Settings *b)
{
    if (a->n_changes != b->n_changes)
        return false;
    for (int i = 0; i < a->n_changes; i++)
        if (a->changes[i].step != b->changes[i].step ||
            strcmp(a->changes[i].to.key, b->changes[i].to.key) != 0 ||
            strcmp(a->changes[i].to.value, b->changes[i].to.value) != 0)
            return false;
    return true;
}

static Difference compare(const Settings *now, const Settings *wanted)
{
    Difference difference = {false, false};
    if (now->problem != wanted->problem || now->method != wanted->method || !same_changes(now, wanted))
        return (Difference){true, false};
    for (int i = 0; i < n_parameters; i++)
        if (differs(now, wanted, &parameters[i]) && recomputes(now, &parameters[i])) {
            if (parameters[i].live)
                difference.live = true;
            else
                difference.restart = true;
        }
    return difference;
}

/* Changes are known by their step; with another time step they keep their time. */
static void move_changes(Change *changes, int count, double from_dt, double to_dt)
{
    for (int i = 0; i < count; i++)
        changes[i].step = lround((double)changes[i].step * from_dt / to_dt);
}

/* Those that were made by hand become plain values; so does a given one that the new settings overrule. */
static void take_given_changes(const Experiment *experiment, Settings *wanted)
{
    const Settings *now = &experiment->trial.now;
    wanted->n_changes = 0;
    for (int i = 0; i < experiment->n_given; i++) {
        const Parameter *parameter = parameter_find(experiment->given[i].to.key);
        if (!parameter || !differs(now, wanted, parameter))
            wanted->changes[wanted->n_changes++] = experiment->given[i];
    }
}

static bool edit_from_start(Experiment *experiment, const Settings *wanted, bool live_from_start,
                            Status *status)
{
    const Trial *trial = &experiment->trial;
    Settings settings = *wanted;
    double dt = trial->sim->dt, new_dt = dt;
    if (live_from_start)
        take_given_changes(experiment, &settings);
    begin_changed_ones(&settings, &trial->base);
    if (settings.n_changes > 0 && !problem_time_step(&settings, &new_dt, status))
        return false;
    move_changes(settings.changes, settings.n_changes, dt, new_dt);
    if (!replace_trial(experiment, &settings, true, true, status))
        return false;
    move_changes(experiment->given, experiment->n_given, dt, new_dt);
    if (live_from_start)
        keep_given(experiment, &settings);
    return true;
}

static bool edit_live(Experiment *experiment, const Settings *wanted, Status *status)
{
    Trial *trial = &experiment->trial;
    const Settings before = trial->now;
    long step = trial->sim->step + (trial->sim->stage != 0);
    if (experiment->pending && experiment->goal_step >= step)
        step = experiment->goal_step + (experiment->goal_stage != 0);
    char advice[sizeof trial->advice];
    if (!problem_advice(wanted, advice, sizeof advice, status))
        return false;
    Record old = {0};
    Trial shell = {.base = trial->base, .n_columns = trial->n_columns};
    memcpy(shell.columns, trial->columns, sizeof shell.columns);
    const Readout readout = read_whole(trial);
    if (trial->newest > step && !record_copy(&old, &trial->record))
        return status_fail(status, STATUS_FAILED, "not enough memory to keep the curves");
    for (int i = 0; i < n_parameters; i++) {
        char text[LIST_MAX];
        if (!differs(&before, wanted, &parameters[i]) || !recomputes(wanted, &parameters[i]))
            continue;
        settings_get(wanted, &parameters[i], text);
        if (!trial_change(trial, step, parameters[i].key, text, status)) {
            record_close(&old);
            return false;
        }
    }
    memcpy(trial->advice, advice, sizeof advice);
    if (old.count > 0)
        make_ghost(experiment, find_place(experiment, false), false, &shell, &old, &readout);
    record_close(&old);
    forget_derived(experiment);
    write_legends(experiment);
    return true;
}

/* What does not touch the computed run. */
static void take_over_rest(Settings *to, const Settings *from)
{
    memcpy(to->title, from->title, sizeof to->title);
    memcpy(to->about, from->about, sizeof to->about);
    memcpy(to->question, from->question, sizeof to->question);
    memcpy(to->duel, from->duel, sizeof to->duel);
    to->n_duel = from->n_duel;
    to->view = from->view;
    to->every = from->every;
    to->frames = from->frames;
    memcpy(to->at, from->at, sizeof to->at);
}

bool experiment_edit(Experiment *experiment, const Settings *wanted, Status *status)
{
    Trial *trial = &experiment->trial;
    if (!settings_check(wanted, status))
        return false;
    Difference difference = compare(&trial->now, wanted);
    bool at_start = trial->sim->step == 0 && trial->sim->stage == 0 && !experiment->pending;
    if (difference.restart)
        return edit_from_start(experiment, wanted, false, status);
    if (difference.live && (at_start || experiment_at_end(experiment)))
        return edit_from_start(experiment, wanted, true, status);
    if (difference.live && !edit_live(experiment, wanted, status))
        return false;
    take_over_rest(&trial->base, wanted);
    take_over_rest(&trial->now, wanted);
    if (wanted->end != trial->base.end && wanted->problem != PROBLEM_MOVING_CANTILEVER) {
        trial_set_end(trial, wanted->end);
        if (experiment->pending)
            experiment_seek(experiment, experiment->goal_step, experiment->goal_stage);
        forget_derived(experiment);
    }
    return true;
}

bool experiment_rerun(Experiment *experiment, const Settings *wanted, Status *status)
{
    return edit_from_start(experiment, wanted, true, status);
}

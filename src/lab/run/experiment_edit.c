/* Ghosts, and the edits that make them. */
#include "lab/settings/changes.h"
#include "lab/run/experiment_internal.h"
#include "lab/settings/parameters.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* --- ghosts --------------------------------------------------------------------------------------- */

void experiment_drop_ghost(Ghost *ghost)
{
    record_close(&ghost->record);
    profile_close(&ghost->profile);
    for (int i = 0; i < SPECTRUM_SPANS; i++)
        spectrum_close(&ghost->spectra[i]);
    memset(ghost, 0, sizeof *ghost);
}

/* Legends tell what differs from the run that is on screen now. */
static void write_legends(Experiment *experiment)
{
    for (int i = 0; i < GHOSTS_MAX; i++) {
        Ghost *ghost = &experiment->ghosts[i];
        if (ghost->used)
            settings_name(&ghost->settings, &experiment->trial.base, ghost->legend, sizeof ghost->legend);
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

/* What a run leaves behind besides its record. */
typedef struct Remains {
    Readout readout;
    Profile profile; /* empty where memory is short */
} Remains;

static Remains remains_of(const Trial *trial)
{
    Remains remains = {.readout = read_whole(trial)};
    profile_take(&remains.profile, trial->sim, NULL);
    return remains;
}

/* Record and remains are handed over, not copied. */
static void make_ghost(Experiment *experiment, Ghost *ghost, bool pinned, const Trial *from, Record *record,
                       Remains *remains)
{
    experiment_drop_ghost(ghost);
    ghost->used = true;
    ghost->pinned = pinned;
    ghost->letter = (char)('a' + (ghost - experiment->ghosts));
    ghost->settings = from->base;
    ghost->record = *record;
    memcpy(ghost->columns, from->columns, sizeof ghost->columns);
    ghost->n_columns = from->n_columns;
    ghost->readout = remains->readout;
    ghost->profile = remains->profile;
    memset(record, 0, sizeof *record);
    memset(remains, 0, sizeof *remains);
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
        if (ghost->used && ghost->pinned && settings_same(&ghost->settings, &trial->base)) {
            experiment_drop_ghost(ghost);
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
    Remains remains = remains_of(trial);
    make_ghost(experiment, place, true, trial, &copy, &remains);
    write_legends(experiment);
    return true;
}

void experiment_become_ghost(Experiment *experiment, Experiment *heir)
{
    if (has_curve(experiment)) {
        Remains remains = remains_of(&experiment->trial);
        make_ghost(heir, find_place(heir, false), false, &experiment->trial, &experiment->trial.record,
                   &remains);
        write_legends(heir);
    }
    experiment_destroy(experiment);
}

/* --- edits ---------------------------------------------------------------------------------------- */

static void forget_answers(Experiment *experiment)
{
    experiment->before.known = false;
    experiment->row_step = -1;
    experiment->invariant.any = false;
    story_forget(&experiment->story);
    experiment->readout_rows = 0;
    experiment->n_derived = 0;
    for (int i = 0; i < SPECTRUM_SPANS; i++)
        spectrum_close(&experiment->spectra[i]);
}

/* Whether a pinned ghost shows all that this run would leave behind. */
static bool is_pinned(const Experiment *experiment)
{
    const Trial *trial = &experiment->trial;
    for (int i = 0; i < GHOSTS_MAX; i++) {
        const Ghost *ghost = &experiment->ghosts[i];
        if (ghost->used && ghost->pinned && settings_same(&ghost->settings, &trial->base) &&
            ghost->record.count >= trial->record.count)
            return true;
    }
    return false;
}

static void drop_unpinned(Experiment *experiment)
{
    for (int i = 0; i < GHOSTS_MAX; i++)
        if (!experiment->ghosts[i].pinned)
            experiment_drop_ghost(&experiment->ghosts[i]);
}

/* Another run takes the place of this one, and seeks the time that was on screen; the end, where that was the
 * end. */
static bool replace_trial(Experiment *experiment, const Settings *settings, bool keep_ghost, bool seek,
                          Status *status)
{
    Trial *trial = &experiment->trial;
    const long step = experiment->pending ? experiment->goal_step : trial->sim->step;
    const double time = (double)step * trial->sim->dt;
    const bool ended = step >= experiment_last_step(experiment) && settings->time.end == trial->base.time.end;
    Trial fresh;
    if (!trial_open(&fresh, settings, experiment->history, experiment->threads, status))
        return false;
    if (keep_ghost && is_pinned(experiment)) {
        drop_unpinned(experiment);
    } else if (keep_ghost && has_curve(experiment)) {
        Remains remains = remains_of(trial);
        make_ghost(experiment, find_place(experiment, false), false, trial, &trial->record, &remains);
    }
    trial_close(trial);
    *trial = fresh;
    experiment->pending = false;
    forget_answers(experiment);
    write_legends(experiment);
    if (seek)
        experiment_seek(experiment, ended ? experiment_last_step(experiment) : lround(time / trial->sim->dt),
                        0);
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

/* The same run from its beginning; nothing has to be made anew. */
static void rewind_trial(Experiment *experiment, bool keep_ghost)
{
    Record old;
    Trial *trial = &experiment->trial;
    const bool kept = keep_ghost && has_curve(experiment);
    Remains remains = {0};
    if (kept)
        remains = remains_of(trial);
    trial_rewind(trial, &old);
    if (kept && old.count > 0)
        make_ghost(experiment, find_place(experiment, false), false, trial, &old, &remains);
    profile_close(&remains.profile);
    record_close(&old);
    experiment->pending = false;
    forget_answers(experiment);
    write_legends(experiment);
}

bool experiment_restart(Experiment *experiment, bool keep_ghost, Status *status)
{
    Trial *trial = &experiment->trial;
    experiment_drop_part(experiment);
    Settings settings = trial->now;
    memcpy(settings.changes, experiment->given, sizeof settings.changes);
    settings.n_changes = experiment->n_given;
    begin_changed_ones(&settings, &trial->base);
    if (experiment->adopted || settings_same(&settings, &trial->base))
        rewind_trial(experiment, keep_ghost);
    else if (!replace_trial(experiment, &settings, keep_ghost, false, status))
        return false;
    if (!keep_ghost)
        drop_unpinned(experiment);
    return true;
}

typedef struct Difference {
    bool restart, live;
} Difference;

static bool recomputes(const Settings *settings, const Parameter *parameter)
{
    if (strcmp(parameter->key, "time.end") == 0)
        return settings->problem->end_matters;
    /* the critical stretch says the same */
    if (strcmp(parameter->key, "pd.critical_energy") == 0)
        return false;
    return !parameter->output;
}

static bool differs(const Settings *a, const Settings *b, const Parameter *parameter)
{
    char one[LIST_MAX], other[LIST_MAX];
    if (!settings_have(a, parameter))
        return false;
    settings_get(a, parameter, one);
    settings_get(b, parameter, other);
    return strcmp(one, other) != 0;
}

static Difference compare(const Settings *now, const Settings *wanted)
{
    Difference difference = {false, false};
    if (now->problem != wanted->problem || now->method != wanted->method || !changes_same(now, wanted))
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

bool experiment_recomputes(const Experiment *experiment, const Settings *wanted)
{
    const Difference difference = compare(&experiment->trial.now, wanted);
    return difference.restart || difference.live;
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
    experiment_drop_part(experiment);
    if (experiment->adopted)
        return status_fail(status, STATUS_USAGE, "this run has no parameters");
    double dt = trial->sim->dt, new_dt = dt;
    if (live_from_start)
        take_given_changes(experiment, &settings);
    if (settings.problem == trial->base.problem)
        begin_changed_ones(&settings, &trial->base);
    if (settings.n_changes > 0 && !problem_time_step(&settings, &new_dt, status))
        return false;
    move_changes(settings.changes, settings.n_changes, dt, new_dt);
    if (!replace_trial(experiment, &settings, true, true, status))
        return false;
    move_changes(experiment->given, experiment->n_given, dt, new_dt);
    if (live_from_start)
        experiment_keep_given(experiment, &settings);
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
    Remains remains = {0};
    if (trial->newest > step && !record_copy(&old, &trial->record))
        return status_fail(status, STATUS_FAILED, "not enough memory to keep the curves");
    if (old.count > 0)
        remains = remains_of(trial);
    for (int i = 0; i < n_parameters; i++) {
        char text[LIST_MAX];
        if (!differs(&before, wanted, &parameters[i]) || !recomputes(wanted, &parameters[i]))
            continue;
        settings_get(wanted, &parameters[i], text);
        if (!trial_change(trial, step, parameters[i].key, text, status)) {
            record_close(&old);
            profile_close(&remains.profile);
            return false;
        }
    }
    memcpy(trial->advice, advice, sizeof advice);
    if (old.count > 0)
        make_ghost(experiment, find_place(experiment, false), false, &shell, &old, &remains);
    record_close(&old);
    forget_answers(experiment);
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
    to->output.every = from->output.every;
    to->output.frames = from->output.frames;
    memcpy(to->output.at, from->output.at, sizeof to->output.at);
}

bool experiment_edit(Experiment *experiment, const Settings *wanted, Status *status)
{
    Trial *trial = &experiment->trial;
    if (!experiment->adopted && !settings_check(wanted, status))
        return false;
    if (wanted->time.end != trial->base.time.end &&
        !problem_check_steps(wanted->time.end, trial->sim->dt, status))
        return false;
    experiment_drop_part(experiment);
    Difference difference = compare(&trial->now, wanted);
    /* what is on screen, or will be as soon as the work is done */
    long step = experiment->pending ? experiment->goal_step : trial->sim->step;
    int stage = experiment->pending ? experiment->goal_stage : trial->sim->stage;
    if (difference.restart)
        return edit_from_start(experiment, wanted, false, status);
    if (difference.live && stage == 0 && (step == 0 || step >= trial->last))
        return edit_from_start(experiment, wanted, true, status);
    if (difference.live && !edit_live(experiment, wanted, status))
        return false;
    take_over_rest(&trial->base, wanted);
    take_over_rest(&trial->now, wanted);
    if (wanted->time.end != trial->base.time.end && !wanted->problem->end_matters) {
        trial_set_end(trial, wanted->time.end);
        if (experiment->pending)
            experiment_seek(experiment, experiment->goal_step, experiment->goal_stage);
        forget_answers(experiment);
    }
    return true;
}

bool experiment_replace(Experiment *experiment, const Settings *wanted, Status *status)
{
    Difference difference = compare(&experiment->trial.now, wanted);
    if (!difference.restart && !difference.live)
        return experiment_edit(experiment, wanted, status);
    return edit_from_start(experiment, wanted, false, status);
}

bool experiment_rerun(Experiment *experiment, const Settings *wanted, Status *status)
{
    return edit_from_start(experiment, wanted, true, status);
}

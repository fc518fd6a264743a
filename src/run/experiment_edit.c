/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Edits: another run in the place of this one, or another future of it. */
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "run/experiment_internal.h"
#include "scenario/changes.h"
#include "scenario/parameters.h"

#include <math.h>
#include <string.h>

static void forget_answers(Experiment *experiment)
{
    experiment->before.known = false;
    experiment->worked->row_step = -1;
    experiment->worked->invariant.any = false;
    experiment->worked->log.begun = false;
    experiment->worked->readout_rows = 0;
    experiment->worked->n_derived = 0;
    for (int i = 0; i < SPECTRUM_SPANS; i++)
        spectrum_close(&experiment->worked->spectra[i]);
}

/* Another run takes the place of this one, and seeks the time that was on screen; the end, where that was the
 * end. */
static bool replace_run(Experiment *experiment, const Settings *settings, bool keep_ghost, bool seek,
                        Status *status)
{
    const long step = experiment->pending ? experiment->goal_step : experiment->run.sim->step;
    const double time = (double)step * experiment->run.sim->dt;
    const bool ended = step >= experiment_last_step(experiment) &&
                       settings_time(settings)->end == settings_time(&experiment->base)->end;
    Experiment *fresh = experiment_create(settings, experiment->history.budget, experiment->threads, status);
    if (!fresh)
        return false;
    if (settings_same(settings, &experiment->base)) {
        /* the same curves come again */
    } else if (keep_ghost && experiment_is_pinned(experiment)) {
        experiment_drop_unpinned(experiment);
    } else if (keep_ghost && experiment_has_curve(experiment)) {
        Ghost left = experiment_leave(experiment, experiment->record);
        experiment->record = (Record){0};
        experiment_keep_ghost(experiment, false, &left);
    }
    /* what outlives a run */
    memcpy(fresh->ghosts, experiment->ghosts, sizeof fresh->ghosts);
    memset(experiment->ghosts, 0, sizeof experiment->ghosts);
    memcpy(fresh->given, experiment->given, sizeof fresh->given);
    fresh->n_given = experiment->n_given;
    fresh->flowing = experiment->flowing;
    enum { CHUNK = 4096 };
    unsigned char *one = (unsigned char *)experiment, *other = (unsigned char *)fresh, chunk[CHUNK];
    for (size_t left = sizeof *experiment, size; left > 0; left -= size, one += size, other += size) {
        size = left < CHUNK ? left : CHUNK;
        memcpy(chunk, one, size);
        memcpy(one, other, size);
        memcpy(other, chunk, size);
    }
    experiment->run.settings = &experiment->base;
    fresh->run.settings = &fresh->base;
    experiment_destroy(fresh);
    experiment_write_legends(experiment);
    if (seek)
        experiment_seek(experiment,
                        ended ? experiment_last_step(experiment) : lround(time / experiment->run.sim->dt), 0);
    return true;
}

/* What changes in mid-run begins with its own first value, whatever is in force now. */
static void begin_changed_ones(Settings *settings, const Settings *base)
{
    for (int i = 0; i < settings->n_changes; i++) {
        const Parameter *parameter = parameter_find(settings->changes[i].to.key);
        if (parameter) {
            char text[LIST_MAX];
            settings_get(base, parameter, text);
            settings_set(settings, parameter->key, text, NULL);
        }
    }
}

bool experiment_restart(Experiment *experiment, bool keep_ghost, Status *status)
{
    experiment_drop_part(experiment);
    Settings settings = experiment->now;
    memcpy(settings.changes, experiment->given, sizeof settings.changes);
    settings.n_changes = experiment->n_given;
    begin_changed_ones(&settings, &experiment->base);
    if (settings_same(&settings, &experiment->base)) {
        /* The same run from its beginning; nothing has to be made again. */
        Ghost left = {.used = false};
        if (keep_ghost && experiment_has_curve(experiment))
            left = experiment_leave(experiment, (Record){0});
        experiment_rewind(experiment, &left.record);
        experiment_keep_ghost(experiment, false, &left);
        experiment->pending = false;
        forget_answers(experiment);
        experiment_write_legends(experiment);
    } else if (!replace_run(experiment, &settings, keep_ghost, false, status))
        return false;
    if (!keep_ghost)
        experiment_drop_unpinned(experiment);
    return true;
}

/* What settings make of a run: the same one, another future of it, or another run. */
typedef enum Difference { SAME, LIVE, RESTART } Difference;

/* Another end is another run where it is for the problem, or where other answers are known so far. */
static bool end_matters(const Settings *now, const Settings *wanted)
{
    bool matters = now->problem->end_matters;
    for (Reference r = 0; r < REFERENCES; r++)
        matters = matters || !answer_invalid_because(now, r) != !answer_invalid_because(wanted, r);
    return matters && settings_time(now)->end != settings_time(wanted)->end;
}

static bool recomputes(const Parameter *parameter)
{
    if (strcmp(parameter->key, "time.end") == 0)
        return false; /* that is end_matters() */
    /* the critical stretch says the same */
    if (strcmp(parameter->key, "pd.critical_energy") == 0)
        return false;
    return !parameter->output || strcmp(parameter->key, "output.follow") == 0; /* columns from t = 0 on */
}

static bool differs(const Settings *a, const Settings *b, const Parameter *parameter)
{
    return parameter_applies_to(a, parameter) && settings_differ(a, b, parameter);
}

static Difference compare(const Settings *now, const Settings *wanted)
{
    Difference difference = SAME;
    if (now->problem != wanted->problem || now->method != wanted->method ||
        !settings_changes_same(now, wanted) || !settings_rows_same(now, wanted) || end_matters(now, wanted))
        return RESTART;
    for (int i = 0; i < n_parameters; i++)
        if (differs(now, wanted, &parameters[i]) && recomputes(&parameters[i])) {
            if (!parameter_is_live(&parameters[i], settings_number(now, &parameters[i]),
                                   settings_number(wanted, &parameters[i])))
                return RESTART;
            difference = LIVE;
        }
    return difference;
}

bool experiment_recomputes(const Experiment *experiment, const Settings *wanted)
{
    return compare(&experiment->now, wanted) != SAME;
}

static bool edit_from_start(Experiment *experiment, const Settings *wanted, bool live_from_start,
                            Status *status)
{
    Settings settings = *wanted;
    experiment_drop_part(experiment);
    double dt = experiment->run.sim->dt, new_dt = dt;
    if (live_from_start) {
        /* Those that were made by hand become plain values; so does a given one that the new settings
         * overrule. */
        const Settings *now = &experiment->now;
        settings.n_changes = 0;
        for (int i = 0; i < experiment->n_given; i++) {
            const Parameter *parameter = parameter_find(experiment->given[i].to.key);
            if (!parameter || !differs(now, &settings, parameter))
                settings.changes[settings.n_changes++] = experiment->given[i];
        }
    }
    if (settings.problem == experiment->base.problem)
        begin_changed_ones(&settings, &experiment->base);
    if (!changes_keep_time(&settings, &new_dt, status) ||
        !replace_run(experiment, &settings, true, true, status))
        return false;
    changes_move(experiment->given, experiment->n_given, dt, new_dt);
    if (live_from_start) {
        memcpy(experiment->given, settings.changes, sizeof experiment->given);
        experiment->n_given = settings.n_changes;
    }
    return true;
}

static bool edit_live(Experiment *experiment, const Settings *wanted, Status *status)
{
    Settings changed = experiment->base;
    long step = experiment->run.sim->step + (experiment->run.sim->stage != 0);
    if (experiment->pending && experiment->goal_step >= step)
        step = experiment->goal_step + (experiment->goal_stage != 0);
    char advice[sizeof experiment->advice];
    if (!settings_check(wanted, status) || !problem_advice(wanted, advice, sizeof advice, status))
        return false;
    for (int i = 0; i < n_parameters; i++) {
        char text[LIST_MAX];
        if (!differs(&experiment->now, wanted, &parameters[i]) || !recomputes(&parameters[i]))
            continue;
        settings_get(wanted, &parameters[i], text);
        if (!changes_add(&changed, step, parameters[i].key, text, status))
            return false;
    }
    Record old = {0};
    Ghost left = {.used = false};
    if (experiment->newest > step && !record_copy(&old, &experiment->record))
        return status_fail(status, "not enough memory to keep the curves");
    if (old.count > 0)
        left = experiment_leave(experiment, old);
    if (!experiment_change(experiment, step, &changed, status)) {
        experiment_drop_ghost(&left);
        return false;
    }
    memcpy(experiment->advice, advice, sizeof advice);
    experiment_keep_ghost(experiment, false, &left);
    forget_answers(experiment);
    experiment_write_legends(experiment);
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
    *settings_edit_view(to) = *settings_view(from);
    settings_take_output(to, from);
}

bool experiment_edit(Experiment *experiment, const Settings *wanted, Status *status)
{
    experiment_drop_part(experiment);
    const Difference difference = compare(&experiment->now, wanted);
    long step;
    int stage;
    experiment_goal(experiment, &step, &stage); /* what is on screen, or will be when the work is done */
    if (difference == RESTART)
        return edit_from_start(experiment, wanted, false, status);
    if (difference == LIVE && stage == 0 && (step == 0 || step >= experiment->run.last))
        return edit_from_start(experiment, wanted, true, status);
    if (!problem_check_steps(settings_time(wanted)->end, experiment->run.sim->dt, status))
        return false;
    if (difference == LIVE && !edit_live(experiment, wanted, status))
        return false;
    take_over_rest(&experiment->base, wanted);
    take_over_rest(&experiment->now, wanted);
    if (settings_time(wanted)->end != settings_time(&experiment->base)->end) {
        experiment_set_end(experiment, settings_time(wanted)->end);
        if (experiment->pending)
            experiment_seek(experiment, experiment->goal_step, experiment->goal_stage);
        forget_answers(experiment);
    }
    return true;
}

bool experiment_replace(Experiment *experiment, const Settings *wanted, Status *status)
{
    if (compare(&experiment->base, wanted) == SAME) {
        Settings settings = *wanted;
        begin_changed_ones(&settings, &experiment->now);
        return experiment_edit(experiment, &settings, status);
    }
    experiment_drop_part(experiment);
    const double dt = experiment->run.sim->dt;
    if (!replace_run(experiment, wanted, true, true, status))
        return false;
    changes_move(experiment->given, experiment->n_given, dt, experiment->run.sim->dt);
    return true;
}

bool experiment_rerun(Experiment *experiment, const Settings *wanted, Status *status)
{
    return edit_from_start(experiment, wanted, true, status);
}

void experiment_become_ghost(Experiment *experiment, Experiment *heir)
{
    if (experiment_has_curve(experiment)) {
        Ghost left = experiment_leave(experiment, experiment->record);
        experiment->record = (Record){0};
        experiment_keep_ghost(heir, false, &left);
        experiment_write_legends(heir);
    }
    experiment_destroy(experiment);
}

/* The sharp invariant (references.h) as the laboratory shows it: worked out once for each step that is looked
 * at, not while large bars run. */

enum { RUNNING_MAX = 20000, PAUSED_MAX = 500000 }; /* particles; a picture must not wait for more */

static void look(Simulation *sim, void *context)
{
    const Experiment *experiment = context;
    experiment->worked->invariant.start = references_invariant(sim, &experiment->base);
}

bool experiment_invariant(const Experiment *experiment, double *now, double *start)
{
    Simulation *sim = experiment->run.sim;
    Worked *worked = experiment->worked;
    if (!references_have_invariant(&experiment->now) || !references_have_invariant(&experiment->base))
        return false;
    if (sim->counts[0] > PAUSED_MAX)
        return false;
    const bool busy = experiment->flowing && sim->counts[0] > RUNNING_MAX;
    /* for want of memory it is asked for again */
    const int before = shortage_begin();
    if (!worked->invariant.any) {
        worked->invariant.step = -1;
        worked->invariant.start = NAN;
        simulation_visit(sim, history_nearest(&experiment->history, 0)->bytes, look, (void *)experiment);
        worked->invariant.any = errno != ENOMEM;
    }
    if (worked->invariant.step != sim->step && sim->stage == 0 && sim->item == 0 && !busy && !sim->failed) {
        worked->invariant.now = references_invariant(sim, &experiment->now);
        worked->invariant.step = errno != ENOMEM ? sim->step : -1;
    }
    shortage_end(before);
    *now = worked->invariant.now;
    *start = worked->invariant.start;
    /* within a step: whether it was looked at before the step must not be seen */
    return worked->invariant.step == sim->step && sim->stage == 0 && isfinite(*now) && isfinite(*start);
}

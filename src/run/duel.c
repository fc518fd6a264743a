/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two runs side by side (duel.h): every verb acts on A and then brings B to the same time; B is made again
 * whenever A becomes another run. */
#include "run/duel.h"

#include "base/assertion.h"
#include "scenario/changes.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "scenario/parameters.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* --- keys ------------------------------------------------------------------------------------------ */

int duel_read_keys(const char *text, Assignment keys[DUEL_MAX], Status *status)
{
    int count = 0;
    for (text += strspn(text, " "); *text; text += strspn(text, " ")) {
        const int length = (int)strcspn(text, " "), key = (int)strcspn(text, "= ");
        if (text[key] != '=' || key == 0 || key >= KEY_MAX || length - key - 1 >= VALUE_MAX) {
            status_refuse(status, "%.*s is not KEY=VALUE", length < 60 ? length : 60, text);
            return -1;
        }
        if (count == DUEL_MAX) {
            status_refuse(status, "too many keys differ (at most %d)", DUEL_MAX);
            return -1;
        }
        snprintf(keys[count].key, sizeof keys[count].key, "%.*s", key, text);
        snprintf(keys[count].value, sizeof keys[count].value, "%.*s", length - key - 1, text + key + 1);
        count++;
        text += length;
    }
    return count;
}

void duel_write_keys(const Assignment *keys, int n_keys, char *out, size_t size)
{
    out[0] = '\0';
    for (int i = 0; i < n_keys; i++)
        text_append(out, size, "%s%s=%s", i ? " " : "", keys[i].key, keys[i].value);
}

/* The parameter at its next choice or size; false: it has none. */
static bool suggest(const Settings *settings, const Parameter *parameter, Assignment *key)
{
    Settings other = *settings;
    char value[LIST_MAX];
    if (!parameter || !parameter_applies_to(settings, parameter) ||
        !parameter_can_be_asked(parameter, settings->problem) ||
        !settings_answer_otherwise(&other, parameter))
        return false;
    settings_get(&other, parameter, value);
    snprintf(key->key, sizeof key->key, "%s", parameter->key);
    snprintf(key->value, sizeof key->value, "%.*s", VALUE_MAX - 1, value);
    return true;
}

int duel_suggest(const Settings *settings, int which, Assignment keys[DUEL_MAX])
{
    ASSERT_INT(which, >=, 0);
    const Parameter *question = settings_question(settings);
    if (suggest(settings, question, keys) && which-- == 0)
        return 1;
    for (int of_method = 1; of_method >= 0; of_method--)
        for (int i = 0; i < n_parameters; i++)
            if (&parameters[i] != question &&
                (strncmp(parameters[i].key, settings->method == METHOD_MPM ? "mpm." : "pd.", 3) == 0) ==
                    of_method &&
                suggest(settings, &parameters[i], keys) && which-- == 0)
                return 1;
    return 0;
}

/* B's settings where A's are these: changes in mid-run keep their time, and of B's own keys there are none.
 */
static bool second_settings(const Duel *duel, const Settings *first, Settings *out, Status *status)
{
    double dt = 0;
    *out = *first;
    out->n_duel = out->n_changes = 0;
    if (!settings_set_method(out, duel->keys, duel->n_keys, status))
        return false;
    for (int i = 0; i < duel->n_keys; i++)
        if (!settings_set(out, duel->keys[i].key, duel->keys[i].value, status))
            return false;
    for (int i = 0; i < first->n_changes; i++) {
        int own = 0;
        while (own < duel->n_keys && strcmp(duel->keys[own].key, first->changes[i].to.key) != 0)
            own++;
        if (own == duel->n_keys)
            out->changes[out->n_changes++] = first->changes[i];
    }
    char advice[160];
    return (first->n_changes == 0 || problem_time_step(first, &dt, status)) &&
           changes_keep_time(out, &dt, status) && changes_advice(out, advice, sizeof advice, status);
}

/* Whether one curve stands for both: the exact answer at a few places and times. */
static bool same_exact(const Experiment *a, const Experiment *b)
{
    enum { TIMES = 7, PLACES = 5 };
    const Simulation *sim = experiment_simulation(a);
    const char *field = profile_field(sim, 1);
    const double end = settings_time(experiment_settings(a))->end;
    double last = 0;
    if (!field || sim->counts[0] == 0)
        return true;
    sim->method->field(sim, sim->position[0], sim->counts[0] - 1, 1, &last);
    for (int i = 1; i <= TIMES; i++)
        for (int k = 1; k <= PLACES; k++) {
            const double x = last * k / PLACES, time = end * i / (TIMES + 0.5);
            const double of_a = references_profile(experiment_references(a), field, x, time);
            const double of_b = references_profile(experiment_references(b), field, x, time);
            if (!(isnan(of_a) && isnan(of_b)) && !(fabs(of_a - of_b) <= 1e-9 * (fabs(of_a) + fabs(of_b))))
                return false;
        }
    return true;
}

/* --- beginning and end ----------------------------------------------------------------------------- */

void duel_open(Duel *duel, Experiment *a, size_t history, int threads)
{
    ASSERT(a);
    ASSERT_INT(threads, >=, 1);
    experiment_destroy(duel->b);
    *duel = (Duel){.a = a, .history = history, .threads = threads};
}

void duel_close(Duel *duel)
{
    experiment_destroy(duel->b);
    duel->b = NULL;
}

/* B stands at its last step that is not beyond A's goal: A's whole step counts. */
static void seek_second(Duel *duel)
{
    long step;
    int stage;
    if (!duel->b)
        return;
    experiment_goal(duel->a, &step, &stage);
    const double time = (double)step * experiment_simulation(duel->a)->dt;
    /* a step that ends at the same time but for rounding is not beyond it */
    const double steps = floor(time / experiment_simulation(duel->b)->dt * (1 + 1e-12) + 1e-9);
    const long most =
        experiment_failed(duel->b, NULL) ? experiment_newest(duel->b) : experiment_last_step(duel->b);
    experiment_seek(duel->b, steps < (double)most ? (long)steps : most, 0);
}

/* A new B for A as it is now. */
static bool make_second(Duel *duel, Status *status)
{
    Settings second;
    Experiment *fresh = NULL;
    if (second_settings(duel, experiment_base(duel->a), &second, status))
        fresh = experiment_create(&second, duel->history / 2, duel->threads, status);
    if (!fresh)
        return false;
    experiment_destroy(duel->b);
    duel->b = fresh;
    duel->same_exact = same_exact(duel->a, duel->b);
    const Settings *settings[2] = {experiment_settings(duel->a), experiment_settings(duel->b)};
    for (int run = 0; run < 2; run++) {
        char *name = duel->names[run];
        name[0] = '\0';
        for (int i = 0; i < duel->n_keys; i++) {
            const Parameter *parameter = parameter_find(duel->keys[i].key);
            char value[LIST_MAX];
            /* the spacing of a lattice says nothing of cells */
            if (parameter && parameter_applies_to(settings[run], parameter))
                settings_spell(settings[run], parameter, value);
            else if (settings_row_is_key(settings[run], duel->keys[i].key))
                settings_row_key_show(settings[run], duel->keys[i].key, value);
            else
                continue;
            if (!text_list_add(name, DUEL_NAME_MAX, value))
                break;
        }
    }
    seek_second(duel);
    return true;
}

static void let_go(Duel *duel, bool keep_ghost)
{
    Experiment *b = duel->b;
    duel->b = NULL;
    if (!b)
        return;
    if (keep_ghost)
        experiment_become_ghost(b, duel->a);
    else
        experiment_destroy(b);
    experiment_set_history(duel->a, duel->history);
}

void duel_end(Duel *duel)
{
    let_go(duel, true);
}

bool duel_start(Duel *duel, const Assignment *keys, int n_keys, Status *status)
{
    ASSERT_INT(n_keys, <=, DUEL_MAX);
    Settings settings;
    Duel tried = {.n_keys = n_keys};
    memcpy(tried.keys, keys, (size_t)n_keys * sizeof *keys);
    const Settings *base = experiment_base(duel->a);
    if (!second_settings(&tried, base, &settings, status))
        return false;
    if (settings_same(base, &settings))
        return status_refuse(status, "both runs would be the same: a key must differ");
    duel_end(duel);
    memcpy(duel->keys, tried.keys, sizeof duel->keys);
    duel->n_keys = n_keys;
    if (!make_second(duel, status))
        return false;
    experiment_set_history(duel->a, duel->history / 2);
    return true;
}

/* --- stepping -------------------------------------------------------------------------------------- */

bool duel_work(Duel *duel, Effort effort, bool *whole, Status *status)
{
    Experiment *turn = duel_turn(duel);
    *whole = true;
    if (!turn || experiment_work(turn, effort, whole, turn == duel->b ? NULL : status))
        return true;
    seek_second(duel);      /* A stands where it failed */
    return turn == duel->b; /* B's failure is B's: it stays at its last sound step */
}

static bool work_off(Duel *duel, Status *status)
{
    bool sound = true, whole;
    while (duel_pending(duel, NULL))
        sound = duel_work(duel, (Effort){.steps = LONG_MAX}, &whole, status) && sound;
    return sound;
}

bool duel_advance(Duel *duel, Effort effort, bool *whole, Status *status)
{
    if (!(effort.share > 0) || !duel_pending(duel, NULL)) {
        experiment_go_on(duel->a, effort.share > 0 ? experiment_stage(duel->a) == 0 : effort.steps);
        seek_second(duel);
        if (duel->b)
            experiment_flow(duel->b);
    }
    const bool sound = effort.share > 0 ? duel_work(duel, effort, whole, status) : work_off(duel, status);
    *whole = !duel_pending(duel, NULL);
    return sound;
}

bool duel_next_stage(Duel *duel, Status *status)
{
    const bool sound = experiment_next_stage(duel->a, status);
    seek_second(duel);
    work_off(duel, NULL);
    return sound;
}

void duel_seek(Duel *duel, long step, int stage)
{
    ASSERT_INT(step, >=, 0);
    ASSERT_INT(stage, >=, 0);
    experiment_seek(duel->a, step, stage);
    seek_second(duel);
}

Experiment *duel_turn(const Duel *duel)
{
    const bool first = experiment_pending(duel->a, NULL);
    const bool second = duel->b && experiment_pending(duel->b, NULL);
    if (first && second)
        return experiment_time(duel->b) < experiment_time(duel->a) ? duel->b : duel->a;
    return first ? duel->a : second ? duel->b : NULL;
}

bool duel_pending(const Duel *duel, long *steps_left)
{
    long first = 0, second = 0;
    const bool a = experiment_pending(duel->a, &first);
    const bool b = duel->b && experiment_pending(duel->b, &second);
    if (steps_left)
        *steps_left = first + second;
    return a || b;
}

void duel_drop_part(Duel *duel)
{
    experiment_drop_part(duel->a);
    if (duel->b)
        experiment_drop_part(duel->b);
    seek_second(duel);
}

void duel_cancel(Duel *duel)
{
    const bool waits = !experiment_pending(duel->a, NULL);
    experiment_cancel(duel->a);
    if (waits)
        let_go(duel, false);
    else
        seek_second(duel);
}

bool duel_restart(Duel *duel, bool keep_ghost, Status *status)
{
    Settings second;
    if (!experiment_restart(duel->a, keep_ghost, status))
        return false;
    if (!duel->b)
        return true;
    /* so does B, made again where it is no longer the same */
    if (!second_settings(duel, experiment_base(duel->a), &second, status) ||
        !(settings_same(&second, experiment_base(duel->b)) ? experiment_restart(duel->b, false, status)
                                                           : make_second(duel, status)))
        let_go(duel, false);
    return true;
}

bool duel_change(Duel *duel, const Settings *wanted, DuelChange change, Status *status)
{
    if (!duel->b)
        return change(duel->a, wanted, status);
    Settings second;
    if (!second_settings(duel, wanted, &second, status))
        return status_prefix(status, "run B");
    const bool again = experiment_recomputes(duel->a, wanted);
    if (again && change == experiment_edit)
        change = experiment_rerun;
    if (!change(duel->a, wanted, status))
        return false;
    Status why = {STATUS_DONE, ""};
    bool sound;
    if (again)
        sound = make_second(duel, &why);
    else { /* what does not touch a computed run */
        second = *experiment_settings(duel->b);
        settings_edit_time(&second)->end = settings_time(wanted)->end;
        settings_take_output(&second, wanted);
        sound = experiment_edit(duel->b, &second, &why);
        seek_second(duel);
    }
    if (!sound) {
        let_go(duel, false);
        status_take(status, &why);
    }
    return true;
}

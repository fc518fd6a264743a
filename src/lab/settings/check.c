/* What no single value shows: does the whole make sense? Every refusal names the key to be changed. */
#include "lab/settings/parameters.h"

#include "base/text.h"
#include "lab/answers/bar_problem.h"
#include "lab/answers/problem_rows.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- lists ---------------------------------------------------------------------------------------- */

/* Copies the next item of a list up to its comma and returns what follows; NULL at the end. */
static const char *next_item(const char *list, char item[LIST_MAX])
{
    if (!list || !*list)
        return NULL;
    size_t n = strcspn(list, ",");
    if (n >= LIST_MAX)
        n = LIST_MAX - 1;
    memcpy(item, list, n);
    item[n] = '\0';
    return list[n] == ',' ? list + n + 1 : list + n;
}

static bool is_blank(const char *text)
{
    return text[strspn(text, " ")] == '\0';
}

static bool ends_in_comma(const char *text)
{
    size_t n = strlen(text);
    return n > 0 && text[n - 1] == ',';
}

int overtones_read(const char *text, Overtone out[OVERTONES_MAX], Status *status)
{
    static const char key[] = "initial.overtones";
    if (is_blank(text))
        return 0;
    if (ends_in_comma(text))
        return status_fail(status, STATUS_USAGE, "%s: ends in a comma (mode:velocity,...)", key), -1;
    int count = 0;
    char item[LIST_MAX];
    while ((text = next_item(text, item))) {
        char *colon = strchr(item, ':');
        long mode;
        double velocity;
        if (colon)
            *colon = '\0';
        if (!colon || !text_to_long(item, &mode) || !text_to_double(colon + 1, &velocity) || mode < 1 ||
            mode > 9999) {
            if (colon)
                *colon = ':';
            return status_fail(status, STATUS_USAGE,
                               "%s: \"%s\" cannot be read (mode:velocity,... such as 3:0.03,7:0.01)", key,
                               item),
                   -1;
        }
        if (count == OVERTONES_MAX)
            return status_fail(status, STATUS_USAGE, "%s: too many modes (at most %d)", key, OVERTONES_MAX),
                   -1;
        for (int i = 0; i < count; i++)
            if (out[i].mode == mode)
                return status_fail(status, STATUS_USAGE, "%s: mode %ld stands twice (each once)", key, mode),
                       -1;
        out[count++] = (Overtone){(int)mode, velocity};
    }
    return count;
}

int times_read(const char *text, double out[TIMES_MAX], Status *status)
{
    static const char key[] = "output.at";
    if (is_blank(text))
        return 0;
    if (ends_in_comma(text))
        return status_fail(status, STATUS_USAGE, "%s: ends in a comma (time,time,...)", key), -1;
    int count = 0;
    char item[LIST_MAX];
    while ((text = next_item(text, item))) {
        double time;
        if (!text_to_double(item, &time) || time < 0)
            return status_fail(status, STATUS_USAGE,
                               "%s: \"%s\" is not a time (numbers >= 0 parted by commas)", key, item),
                   -1;
        if (count == TIMES_MAX)
            return status_fail(status, STATUS_USAGE, "%s: too many times (at most %d)", key, TIMES_MAX), -1;
        if (count > 0 && time <= out[count - 1])
            return status_fail(status, STATUS_USAGE, "%s: %g does not come after %g (ascending)", key, time,
                               out[count - 1]),
                   -1;
        out[count++] = time;
    }
    return count;
}

/* --- the bar -------------------------------------------------------------------------------------- */

static bool check_modes(const Settings *settings, Status *status)
{
    const double length = settings->geometry.length;
    const Mesh *mesh = &settings->mesh;
    double particles = settings->method == METHOD_PD
                           ? round(length / lattice_spacing(settings))
                           : round(length / mesh->cell_size) * mesh->particles_per_cell;
    if (settings->start.mode == 0 && settings->start.velocity != 0 &&
        settings->supports.ends != BAR_FREE_FREE)
        return status_fail(status, STATUS_USAGE,
                           "initial.mode: 0 is rigid motion, which a held bar has not (1 or more, or "
                           "bar.supports = free-free)");
    if (settings->start.mode > particles)
        return status_fail(
            status, STATUS_USAGE,
            "initial.mode: %d is finer than the particles can show (at most %.0f, their number)",
            settings->start.mode, particles);
    Overtone overtones[OVERTONES_MAX];
    int count = overtones_read(settings->start.overtones, overtones, status);
    for (int i = 0; i < count; i++) {
        if (overtones[i].mode == settings->start.mode)
            return status_fail(status, STATUS_USAGE,
                               "initial.overtones: mode %d is initial.mode already (other modes)",
                               settings->start.mode);
        if (overtones[i].mode > particles)
            return status_fail(status, STATUS_USAGE,
                               "initial.overtones: mode %d is finer than the particles can show (at most "
                               "%.0f, their number)",
                               overtones[i].mode, particles);
    }
    return count >= 0;
}

static bool check_bar(const Settings *settings, Status *status)
{
    const BarDef bar = bar_definition(settings);
    const RodDef rod = rod_definition(settings);
    if (!bar_check(&bar, status) || (settings->method == METHOD_PD && !rod_check(&rod, status)) ||
        !check_modes(settings, status))
        return false;
    return problem_check_steps(settings->time.end, bar_time_step(settings), status);
}

static bool check_beam(const Settings *settings, Status *status)
{
    const BeamDef beam = beam_definition(settings, 1);
    /* a step that is to be found is known to problem_simulate() only */
    return beam_check(&beam, status) &&
           (beam.dt == 0 || problem_check_steps(settings->time.end, beam.dt, status));
}

/* --- question, duel, changes ---------------------------------------------------------------------- */

static bool check_question(const Settings *settings, Status *status)
{
    if (!*settings->question)
        return true;
    const Parameter *parameter = parameter_find(settings->question);
    if (!parameter || !settings_can_ask(parameter, settings->problem))
        return status_fail(
            status, STATUS_USAGE,
            "question.key: %s cannot be toggled (a key of problem %s that has choices, or a size)",
            settings->question, problem_words[settings->problem]);
    return true;
}

/* The settings of the other run must be as sound as those of the first. */
static bool check_duel(const Settings *settings, Status *status)
{
    Settings other = *settings;
    other.n_duel = other.n_changes = 0;
    if (!settings_set_method(&other, settings->duel, settings->n_duel, status))
        return status_prefix(status, "duel");
    for (int i = 0; i < settings->n_duel; i++) {
        const Parameter *parameter = parameter_find(settings->duel[i].key);
        /* a file whose method was set from outside may speak of the other one */
        if (parameter && parameter_applies(parameter, other.problem) && !settings_have(&other, parameter))
            continue;
        if (!settings_set(&other, settings->duel[i].key, settings->duel[i].value, status))
            return status_prefix(status, "duel");
    }
    if (settings->n_duel > 0 && !settings_check(&other, status))
        return status_prefix(status, "duel");
    return true;
}

static bool check_changes(const Settings *settings, Status *status)
{
    Settings then = *settings;
    for (int i = 0; i < settings->n_changes; i++) {
        const Change *change = &settings->changes[i];
        const Parameter *parameter = parameter_find(change->to.key);
        if (!settings_set(&then, change->to.key, change->to.value, status))
            return status_prefix(status, "changes.%ld", change->step);
        if (!parameter || !parameter->live)
            return status_fail(
                status, STATUS_USAGE,
                "changes.%ld: %s: cannot change in mid-run (see: matvib params %s, marked live)",
                change->step, change->to.key, problem_words[settings->problem]);
        if (change->step < 0 || (i > 0 && change->step < settings->changes[i - 1].step))
            return status_fail(status, STATUS_USAGE, "changes.%ld: is out of order (steps >= 0, ascending)",
                               change->step);
    }
    return true;
}

bool settings_check(const Settings *settings, Status *status)
{
    if (!problem_allows(settings->problem, settings->method, status) ||
        !(settings->problem == PROBLEM_BAR ? check_bar : check_beam)(settings, status))
        return false;
    double times[TIMES_MAX];
    int n_times = times_read(settings->output.at, times, status);
    if (n_times < 0)
        return false;
    if (n_times > 0 && times[n_times - 1] > settings->time.end * (1 + 1e-9))
        return status_fail(status, STATUS_USAGE, "output.at: %g is after the end (at most time.end = %g)",
                           times[n_times - 1], settings->time.end);
    if (n_times > 0 && settings->output.frames > 0)
        return status_fail(status, STATUS_USAGE, "output.at: output.frames is given too (one of them)");
    return check_question(settings, status) && check_duel(settings, status) &&
           check_changes(settings, status);
}

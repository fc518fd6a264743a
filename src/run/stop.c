/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run stops at (stop.h): read from words, looked for after each step. */
#include "run/stop.h"

#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "base/quantity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What can happen, and what a run must have for it. */
static const struct {
    unsigned events;
    unsigned needs[2]; /* one of these suffices; 0: nothing */
    const char *told;  /* what is waited for */
    const char *lacking;
} kinds[] = {
    {1u << EVENT_CROSSING,
     {HAS_MESH | HAS_LINE, HAS_MESH | HAS_PLANE},
     "a crossing",
     "cell crossings are not recorded in this run"},
    {1u << EVENT_BREAK, {HAS_BREAKING, HAS_BREAKING}, "a break", "no bond can break in this run"},
    {1u << EVENT_TOUCH,
     {HAS_BODIES, HAS_BODIES},
     "a touch",
     "there are no bodies that can touch in this run"},
    {1u << EVENT_CROSSING | 1u << EVENT_BREAK | 1u << EVENT_TOUCH | 1u << EVENT_PART | 1u << EVENT_TEAR |
         1u << EVENT_ENERGY,
     {HAS_MESH, HAS_BREAKING},
     "an event",
     "nothing of the kind happens in this run"},
    {1u << EVENT_REST,
     {0, 0},
     "rest",
     "nothing comes to rest without damping (damping.rate, or time.rest = yes)"},
};
const char *const stop_event_words[] = {"crossing", "break", "touch", "event", "rest", NULL};
enum { REST_WORD = 4 };
#define REST_KINETIC 1e-10
#define REST_SPAN    0.1 /* of the time */

static bool read_event(Stop *stop, const char *word, const Experiment *experiment, bool *sound,
                       Status *status)
{
    const Simulation *sim = experiment_simulation(experiment);
    const Settings *settings = experiment_settings(experiment);
    const bool reports = settings_time(settings)->rest;
    const bool damped =
        settings->problem->concerns & CONCERN_DAMPING && settings_damping(settings)->rate != 0;
    const int i = text_place_in(word, stop_event_words);
    if (i < 0)
        return false;
    *stop = (Stop){
        .kind = STOP_AT_EVENT, .events = kinds[i].events, .rests = i == REST_WORD && !reports, .since = -1};
    *sound =
        (i == REST_WORD ? reports || damped
                        : simulation_has(sim, kinds[i].needs[0]) || simulation_has(sim, kinds[i].needs[1])) ||
        status_refuse(status, "%s", kinds[i].lacking);
    return true;
}

/* What stands behind one of two words and spaces; NULL: another word is there. */
static const char *behind(const char *text, const char *word, const char *other)
{
    const size_t length = strcspn(text, " ");
    const bool is_one = strlen(word) == length && strncmp(text, word, length) == 0;
    const bool is_other = strlen(other) == length && strncmp(text, other, length) == 0;
    return is_one || is_other ? text + length + strspn(text + length, " ") : NULL;
}

static bool within(long step, const Experiment *experiment, Status *status)
{
    const long last = experiment_last_step(experiment);
    if (step >= 0 && step <= last)
        return true;
    return status_refuse(status, "the run goes from 0 to %s (#0 to #%ld)",
                         text_rounded((double)last * experiment_simulation(experiment)->dt, 6).text, last);
}

/* Steps at which a time has come, with the rounding of step times dt left out; far outside: -1 or one too
 * many, so that nothing overflows. */
static long step_of(double time, const Experiment *experiment)
{
    const double steps = ceil(time / experiment_simulation(experiment)->dt * (1 - 1e-12) - 1e-9);
    const long last = experiment_last_step(experiment);
    if (time <= settings_time(experiment_settings(experiment))->end * (1 + 1e-9) && steps > (double)last)
        return last;
    return steps < 0 ? -1 : steps > (double)last ? last + 1 : (long)steps;
}

bool stop_read_time(const char *text, const Experiment *experiment, double *time)
{
    char why[QUANTITY_WHY_MAX];
    return quantity_read(text, experiment_settings(experiment)->problem->si ? "s" : "", time, why);
}

bool stop_read(Stop *stop, const char *text, const Experiment *experiment, Status *status)
{
    const char *time = behind(text, "t", "time"), *step = behind(text, "step", "step");
    const char *next = behind(text, "next", "next");
    bool sound = false;
    *stop = (Stop){.kind = STOP_NEVER};
    if (time && stop_read_time(time, experiment, &stop->time)) {
        stop->kind = STOP_AT_TIME;
        return within(step_of(stop->time, experiment), experiment, status);
    }
    if (text[0] == '#' || step) {
        stop->kind = STOP_AT_STEP;
        if (text_to_long(step ? step : text + 1, &stop->step))
            return within(stop->step, experiment, status);
    } else if (strcmp(text, "end") == 0) {
        *stop = (Stop){.kind = STOP_AT_STEP, .step = experiment_last_step(experiment)};
        return true;
    } else if (read_event(stop, next ? next : text, experiment, &sound, status))
        return sound;
    return status_refuse(
        status,
        "until what? (t TIME | step N | end | crossing | break | touch | event | rest, first or next)");
}

void stop_words(const Stop *stop, char out[STOP_WORDS_MAX])
{
    out[0] = '\0';
    switch (stop->kind) {
    case STOP_NEVER:
        return;
    case STOP_AT_STEP:
        snprintf(out, STOP_WORDS_MAX, "step %ld", stop->step);
        return;
    case STOP_AT_TIME:
        snprintf(out, STOP_WORDS_MAX, "t = %.27s", text_rounded(stop->time, 6).text);
        return;
    case STOP_AT_EVENT:
        for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
            if (kinds[i].events == stop->events)
                snprintf(out, STOP_WORDS_MAX, "%s", kinds[i].told);
    }
}

long stop_step(const Stop *stop, const Experiment *experiment)
{
    return stop->kind == STOP_AT_STEP   ? stop->step
           : stop->kind == STOP_AT_TIME ? step_of(stop->time, experiment)
                                        : -1;
}

/* Whether a damped run has come to rest; the rows that went before are looked through once. */
static bool is_at_rest(Stop *stop, const Experiment *experiment)
{
    const int column = experiment_column(experiment, "kinetic");
    const Record *record = experiment_record(experiment);
    const double *now = experiment_row(experiment);
    if (!stop->rests || column < 0 || !now)
        return false;
    const bool first = stop->most == 0;
    for (size_t i = 0; first && i < record->count; i++)
        stop->most = fmax(stop->most, record_row(record, i)[column]);
    stop->most = fmax(stop->most, now[column]);
    const bool still = now[column] < REST_KINETIC * stop->most;
    if (!still)
        stop->since = -1;
    else if (stop->since < 0)
        stop->since = now[1];
    return still && now[1] - stop->since >= REST_SPAN * now[1];
}

void stop_look(Stop *stop, const Experiment *experiment)
{
    /* How many of the events that it waits for there were; those that are not kept count too. */
    const Simulation *sim = experiment_simulation(experiment);
    long count = 0;
    for (int i = 0; i < sim->n_events; i++)
        count += stop->events >> sim->events[i].kind & 1;
    for (EventKind kind = 0; kind < EVENT_KINDS; kind++)
        count += stop->events >> kind & 1 ? sim->events_beyond.of[kind] : 0;
    stop->seen = count;
}

bool stop_happened(Stop *stop, const Experiment *experiment)
{
    const long before = stop->seen;
    stop_look(stop, experiment);
    return stop->kind == STOP_AT_EVENT && (is_at_rest(stop, experiment) || stop->seen > before);
}

/* The run on screen: playing and pausing it, going to another time of it, and what is said about it.
 * Everything else in this folder stands on this file. */
#include "tui/control/laboratory.h"

#include "base/visible.h"
#include "lab/answers/summary.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

/* One exact period should last this long on screen; a run without a period, this long as a whole. */
#define PERIOD_SECONDS 3.0
#define RUN_SECONDS    15.0

static const double tau = 6.283185307179586;

void say(Laboratory *lab, MessageKind kind, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char text[sizeof lab->screen.message];
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    text_visible(lab->screen.message, sizeof lab->screen.message, text);
    lab->screen.message_kind = lab->screen.message[0] ? kind : MESSAGE_NONE;
    lab->said_at = lab->host.now(lab->host.context);
}

/* --- the second run -------------------------------------------------------------------------------- */

void tell_second(Laboratory *lab)
{
    Status why = {STATUS_DONE, ""};
    const bool ended = lab->duel.b && experiment_failed(lab->duel.b, &why);
    if (ended && !lab->second_ended)
        say(lab, MESSAGE_WARNING, "B stopped: %s; A goes on", why.text);
    lab->second_ended = ended;
}

void duel_over(Laboratory *lab, const Status *status)
{
    if (status->text[0] && !lab->duel.b)
        say(lab, MESSAGE_WARNING, "the duel is over: %s", status->text);
}

/* --- where the run stands ---------------------------------------------------------------------------- */

void settle(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    Experiment *experiment = screen->experiment;
    long left;
    Status failure;
    if (duel_pending(&lab->duel, &left))
        screen->state = STATE_COMPUTING;
    else if (experiment_failed(experiment, &failure) &&
             experiment_step(experiment) >= experiment_newest(experiment)) {
        screen->state = STATE_FAILED;
        lab->resume = STATE_PAUSED;
        say(lab, MESSAGE_ERROR, "%s", failure.text);
    } else if (experiment_at_end(experiment)) {
        screen->state = STATE_ENDED;
        lab->resume = STATE_PAUSED;
        summary_of(experiment, &screen->summary);
        screen->summary_known = true;
    } else
        screen->state = lab->resume;
    if (screen->state != STATE_RUNNING) {
        experiment_rest(experiment);
        if (lab->duel.b)
            experiment_rest(lab->duel.b);
    }
    tell_second(lab);
}

void pause_run(Laboratory *lab)
{
    lab->resume = STATE_PAUSED;
    lab->owed = 0;
    settle(lab);
}

void present(const Laboratory *lab, long *step, int *stage)
{
    const Experiment *experiment = lab->screen.experiment;
    bool under_way = lab->screen.state == STATE_COMPUTING;
    *step = under_way ? lab->goal_step : experiment_step(experiment);
    *stage = under_way ? lab->goal_stage : experiment_stage(experiment);
}

void seek(Laboratory *lab, long step, int stage)
{
    long last = experiment_last_step(lab->screen.experiment);
    if (step < 0)
        step = 0, stage = 0;
    if (step >= last)
        step = last, stage = 0;
    lab->goal_step = step;
    lab->goal_stage = stage;
    duel_seek(&lab->duel, step, stage);
    settle(lab);
}

void drop_part(Laboratory *lab)
{
    duel_drop_part(&lab->duel);
    lab->in_parts = false;
    lab->part_seconds = 0;
}

/* --- pace -------------------------------------------------------------------------------------------- */

double next_125(double value, int direction)
{
    static const double mantissas[] = {1, 2, 5};
    double best = 0;
    for (int decade = -3; decade <= 9; decade++)
        for (int i = 0; i < 3; i++) {
            double candidate = mantissas[i] * pow(10, decade);
            if (direction > 0 && candidate > value * (1 + 1e-9) && (best <= 0 || candidate < best))
                best = candidate;
            if (direction < 0 && candidate < value * (1 - 1e-9) && candidate > best)
                best = candidate;
        }
    return best > 0 ? best : value;
}

void choose_pace(Laboratory *lab)
{
    Experiment *experiment = lab->screen.experiment;
    const Readout *readout = experiment_readout(experiment);
    double dt = experiment_simulation(experiment)->dt;
    double frames = PERIOD_SECONDS / FRAME_SECONDS, steps = 0;
    if (readout->moving && readout->exact_known && readout->exact > 0)
        steps = (readout->is_period ? readout->exact : tau / readout->exact) / dt;
    if (!(steps > 0) || !isfinite(steps)) {
        frames = RUN_SECONDS / FRAME_SECONDS;
        steps = (double)experiment_last_step(experiment);
    }
    double pace = steps / frames;
    /* whole steps per frame look steady; below one it is frames per step that are counted */
    lab->screen.pace = pace >= 1 ? round(pace) : pace > 0 ? 1 / round(1 / pace) : 1;
}

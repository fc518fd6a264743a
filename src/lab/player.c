/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The run on screen: playing and pausing it, going to another time of it. */
#include "lab/laboratory.h"

#include "base/math/functions.h"
#include "base/text.h"
#include "answers/summary.h"

#include <limits.h>
#include <math.h>
#include <string.h>

/* One exact period should last this long on screen; a run without a period, this long as a whole. A run that
 * comes to be half a period late should be so after LATE_SECONDS, as far as that leaves a period long enough
 * to be followed. */
#define PERIOD_SECONDS   3.0
#define SHORTEST_SECONDS 0.75
#define LATE_SECONDS     9.0
#define RUN_SECONDS      15.0

/* --- the second run -------------------------------------------------------------------------------- */

void player_tell_second(Laboratory *lab)
{
    Status why = {STATUS_DONE, ""};
    const bool ended = lab->player.duel.b && experiment_failed(lab->player.duel.b, &why);
    if (ended && !lab->player.second_ended)
        laboratory_say(lab, MESSAGE_WARNING, "B stopped: %s; A goes on", why.text);
    lab->player.second_ended = ended;
}

void player_tell_duel_over(Laboratory *lab, const Status *status)
{
    if (status->text[0] && !lab->player.duel.b)
        laboratory_say(lab, MESSAGE_WARNING, "the duel is over: %s", status->text);
}

/* --- where the run stands ---------------------------------------------------------------------------- */

void player_settle(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    Experiment *experiment = laboratory_run(lab);
    long left;
    Status failure;
    if (duel_pending(&lab->player.duel, &left))
        lab->player.playback.state = STATE_COMPUTING;
    else if (experiment_failed(experiment, &failure) &&
             experiment_step(experiment) >= experiment_newest(experiment)) {
        lab->player.playback.state = STATE_FAILED;
        lab->player.resume = STATE_PAUSED;
        laboratory_say(lab, MESSAGE_ERROR, "%s", failure.text);
        lab->player.playback.slow = false;
    } else if (experiment_at_end(experiment)) {
        lab->player.playback.state = STATE_ENDED;
        lab->player.playback.slow = false;
        lab->player.resume = STATE_PAUSED;
        summary_of(experiment, &lab->summary);
        screen->summary = &lab->summary;
    } else
        lab->player.playback.state = lab->player.resume;
    if (lab->player.playback.state != STATE_RUNNING) {
        experiment_rest(experiment);
        if (lab->player.duel.b)
            experiment_rest(lab->player.duel.b);
    }
    player_tell_second(lab);
}

void player_pause(Laboratory *lab)
{
    lab->player.playback.slow = false;
    lab->player.resume = STATE_PAUSED;
    lab->player.owed = 0;
    player_settle(lab);
}

Place player_place(const Laboratory *lab)
{
    Place place;
    experiment_goal(laboratory_run(lab), &place.step, &place.stage);
    return place;
}

void player_seek(Laboratory *lab, long step, int stage)
{
    long last = experiment_last_step(laboratory_run(lab));
    if (step < 0)
        step = 0, stage = 0;
    if (step >= last)
        step = last, stage = 0;
    duel_seek(&lab->player.duel, step, stage);
    player_settle(lab);
}

void player_go_to(Laboratory *lab, long step)
{
    player_pause(lab);
    player_seek(lab, step, 0);
}

void player_forget_rates(Player *player)
{
    memset(player->rates, 0, sizeof player->rates);
}

void player_drop_part(Player *player)
{
    duel_drop_part(&player->duel);
    player->in_parts = false;
    player->part_seconds = 0;
}

/* --- where it stops ----------------------------------------------------------------------------------- */

void player_stop_at(Laboratory *lab, const Stop *stop)
{
    lab->player.stop = *stop;
    stop_words(stop, lab->player.playback.until);
    lab->player.playback.until_step = laboratory_run(lab) ? stop_step(stop, laboratory_run(lab)) : -1;
}

void player_loop(Laboratory *lab, const Stretch *loop)
{
    lab->player.loop = *loop;
    lab->player.playback.looping = loop->on;
}

/* The last whole step of the stretch; at least one more than its first. */
static long loop_end(const Laboratory *lab, long *first)
{
    const Experiment *experiment = laboratory_run(lab);
    const double dt = experiment_simulation(experiment)->dt;
    const long last = experiment_last_step(experiment);
    const double from = lab->player.loop.from / dt, to = lab->player.loop.to / dt;
    *first = from < (double)last ? lround(from) : last - 1;
    const long end = to < (double)last ? lround(to) : last;
    return end > *first ? end : *first + 1;
}

long player_steps_ahead(const Laboratory *lab)
{
    const Player *player = &lab->player;
    const long step = experiment_step(laboratory_run(lab));
    const long stop = stop_step(&player->stop, laboratory_run(lab));
    long limit = player->run_limit >= 0 ? player->run_limit : LONG_MAX, first;
    if (stop >= step && stop < limit)
        limit = stop;
    if (player->loop.on && loop_end(lab, &first) < limit)
        limit = loop_end(lab, &first);
    return limit == LONG_MAX ? limit : limit > step ? limit - step : 0;
}

bool player_arrive(Laboratory *lab)
{
    Player *player = &lab->player;
    Experiment *experiment = laboratory_run(lab);
    const long step = experiment_step(experiment), stop = stop_step(&player->stop, experiment);
    const Stop never = {.kind = STOP_NEVER};
    long first;
    if (stop_happened(&player->stop, experiment) || stop == step) {
        player_pause(lab);
        /* The first thing that it waited for of the step that has just been done, in general words where the
         * run keeps no more events; else the time. */
        const Simulation *sim = laboratory_simulation(lab);
        const NumberText time = text_rounded(simulation_time(sim), 6);
        const char *what = player->playback.until;
        for (int i = sim->n_events - 1; i >= 0 && sim->events[i].step == sim->step; i--)
            if (player->stop.events >> sim->events[i].kind & 1)
                what = sim->events[i].text;
        if (player->stop.rests)
            laboratory_tell(lab, "stopped at t = %s: at rest", time.text);
        else if (player->stop.kind == STOP_AT_EVENT)
            laboratory_tell(lab, "stopped at t = %s: %s", time.text, what);
        else
            laboratory_tell(lab, "stopped at t = %s, step %ld", time.text, sim->step);
        player_stop_at(lab, &never);
        return true;
    }
    if (stop >= 0 && stop < step)
        player_stop_at(lab, &never); /* passed by other means */
    if (player->stop.kind == STOP_AT_EVENT && experiment_at_end(experiment)) {
        laboratory_tell(lab, "the run has ended: %s did not come", player->playback.until);
        player_stop_at(lab, &never);
    }
    if (!player->loop.on || step < loop_end(lab, &first))
        return false;
    player->owed = 0;
    player_seek(lab, first, 0);
    return true;
}

/* --- pace -------------------------------------------------------------------------------------------- */

double player_next_125(double value, int direction)
{
    static const double mantissas[] = {1, 2, 5};
    double best = 0;
    for (int decade = -3; decade <= 9; decade++)
        for (int i = 0; i < 3; i++) {
            double candidate = mantissas[i] * math_pow(10, decade);
            if (direction > 0 && candidate > value * (1 + 1e-9) && (best <= 0 || candidate < best))
                best = candidate;
            if (direction < 0 && candidate < value * (1 - 1e-9) && candidate > best)
                best = candidate;
        }
    return best > 0 ? best : value;
}

/* How long a period should last on screen. With the frequency off by a share e it is half a period late, or
 * early, after 1 / (2 e) periods. */
static double period_seconds(const Readout *readout, double period, double end)
{
    const double share = fabs(readout->predicted_error_frequency) / 100;
    const double periods = readout->predicted_known && share > 0 ? 0.5 / share : INFINITY;
    if (periods * period > end)
        return PERIOD_SECONDS;
    return fmin(fmax(LATE_SECONDS / periods, SHORTEST_SECONDS), PERIOD_SECONDS);
}

double player_pace_for(double steps, double seconds)
{
    const double pace = steps / (seconds / FRAME_SECONDS);
    /* whole steps per frame look steady; below one it is frames per step that are counted */
    return pace >= 1 ? round(pace) : pace > 0 ? 1 / round(1 / pace) : 1;
}

void player_choose_pace(Player *player)
{
    const Experiment *experiment = player->duel.a;
    const Readout *readout = experiment_readout(experiment);
    double dt = experiment_simulation(experiment)->dt;
    double seconds = 1, steps = 0;
    if (readout->nominal_period > 0) {
        const double period = readout->nominal_period, end = dt * (double)experiment_last_step(experiment);
        seconds = period_seconds(readout, period, end);
        steps = period / dt;
    }
    if (!(steps > 0) || !isfinite(steps)) {
        seconds = RUN_SECONDS;
        steps = (double)experiment_last_step(experiment);
    }
    player->playback.pace = player_pace_for(steps, seconds);
}

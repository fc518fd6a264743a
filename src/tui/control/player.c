/* The run on screen: playing and pausing it, going to another time of it. */
#include "tui/control/laboratory.h"

#include "lab/answers/summary.h"

#include <math.h>
#include <string.h>

/* One exact period should last this long on screen; a run without a period, this long as a whole. A run that
 * comes to be half a period late should be so after LATE_SECONDS, as far as that leaves a period long enough
 * to be followed. */
#define PERIOD_SECONDS   3.0
#define SHORTEST_SECONDS 0.75
#define LATE_SECONDS     9.0
#define RUN_SECONDS      15.0

static const double tau = 6.283185307179586;

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
    Experiment *experiment = screen->experiment;
    long left;
    Status failure;
    if (duel_pending(&lab->player.duel, &left))
        screen->playback.state = STATE_COMPUTING;
    else if (experiment_failed(experiment, &failure) &&
             experiment_step(experiment) >= experiment_newest(experiment)) {
        screen->playback.state = STATE_FAILED;
        lab->player.resume = STATE_PAUSED;
        laboratory_say(lab, MESSAGE_ERROR, "%s", failure.text);
    } else if (experiment_at_end(experiment)) {
        screen->playback.state = STATE_ENDED;
        lab->player.resume = STATE_PAUSED;
        summary_of(experiment, &screen->summary);
        screen->summary_known = true;
    } else
        screen->playback.state = lab->player.resume;
    if (screen->playback.state != STATE_RUNNING) {
        experiment_rest(experiment);
        if (lab->player.duel.b)
            experiment_rest(lab->player.duel.b);
    }
    player_tell_second(lab);
}

void player_pause(Laboratory *lab)
{
    lab->player.resume = STATE_PAUSED;
    lab->player.owed = 0;
    player_settle(lab);
}

void player_place(const Laboratory *lab, long *step, int *stage)
{
    const Experiment *experiment = lab->screen.experiment;
    bool under_way = lab->screen.playback.state == STATE_COMPUTING;
    *step = under_way ? lab->player.goal_step : experiment_step(experiment);
    *stage = under_way ? lab->player.goal_stage : experiment_stage(experiment);
}

void player_seek(Laboratory *lab, long step, int stage)
{
    long last = experiment_last_step(lab->screen.experiment);
    if (step < 0)
        step = 0, stage = 0;
    if (step >= last)
        step = last, stage = 0;
    lab->player.goal_step = step;
    lab->player.goal_stage = stage;
    duel_seek(&lab->player.duel, step, stage);
    player_settle(lab);
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

/* --- pace -------------------------------------------------------------------------------------------- */

double player_next_125(double value, int direction)
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

void player_choose_pace(Screen *screen)
{
    Experiment *experiment = screen->experiment;
    const Readout *readout = experiment_readout(experiment);
    double dt = experiment_simulation(experiment)->dt;
    double frames = 1, steps = 0;
    if (readout->moving && readout->exact_known && readout->exact > 0) {
        const double period = readout->is_period ? readout->exact : tau / readout->exact;
        const double end = dt * (double)experiment_last_step(experiment);
        frames = period_seconds(readout, period, end) / FRAME_SECONDS;
        steps = period / dt;
    }
    if (!(steps > 0) || !isfinite(steps)) {
        frames = RUN_SECONDS / FRAME_SECONDS;
        steps = (double)experiment_last_step(experiment);
    }
    double pace = steps / frames;
    /* whole steps per frame look steady; below one it is frames per step that are counted */
    screen->playback.pace = pace >= 1 ? round(pace) : pace > 0 ? 1 / round(1 / pace) : 1;
}

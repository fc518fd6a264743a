/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands of time: run, step, go back, bookmarks. */
#include "lab/commands/commands.h"
#include "scenario/concern_time.h"
#include "base/text.h"
#include "panes/screen.h"

#include <math.h>
#include <string.h>

#define AGAIN_SECONDS 2.0 /* of computing; a finished run that took longer is not given up unasked */

/* To t = 0 with the same parameters. */
static void begin_again(Laboratory *lab, bool running)
{
    Status status = {STATUS_DONE, ""};
    if (!duel_restart(&lab->player.duel, false, &status)) {
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
        return;
    }
    laboratory_say(lab, MESSAGE_NONE, "%s", "");
    lab->player.resume = running ? STATE_RUNNING : STATE_PAUSED;
    lab->player.owed = 0;
    lab->screen.summary = NULL;
    lab->screen.time.cursor = NAN;
    player_settle(lab);
    player_tell_duel_over(lab, &status);
}

static bool answer_again(Laboratory *lab, const char *text)
{
    (void)text;
    begin_again(lab, true);
    return true;
}

/* A run that is soon computed again begins again at once; one that took long is not thrown away by a slip. */
static void run_again(Laboratory *lab)
{
    const double rate = lab->player.rates[RATE_RUN];
    double seconds = rate > 0 ? (double)experiment_last_step(laboratory_run(lab)) / rate : 0;
    if (seconds < AGAIN_SECONDS) {
        begin_again(lab, true);
        return;
    }
    prompt_ask(lab, answer_again, true, "", "run again from t = 0? it takes about %s s",
               text_rounded(seconds, 2).text);
}

void command_run_or_pause(Laboratory *lab)
{
    if (lab->player.playback.slow)
        player_pause(lab);
    else if (lab->player.playback.state == STATE_ENDED)
        run_again(lab);
    else if (lab->player.playback.state == STATE_FAILED)
        laboratory_tell(lab, "the run cannot go on: change a parameter, step back, or r to begin again");
    else if (lab->player.playback.state == STATE_COMPUTING)
        /* on the way to another place the key says what comes then */
        lab->player.resume = lab->player.resume == STATE_RUNNING ? STATE_PAUSED : STATE_RUNNING;
    else if (lab->player.playback.state == STATE_RUNNING)
        player_pause(lab);
    else {
        lab->player.resume = STATE_RUNNING;
        lab->player.owed = 0;
        lab->player.playback.rate = 0;
        player_settle(lab);
    }
}

/* A step that has begun counts as one of those that are done. */
void command_step(Laboratory *lab, int steps)
{
    long step;
    int stage;
    player_place(lab, &step, &stage);
    player_pause(lab);
    if (steps < 0 && stage > 0)
        steps++;
    if (steps < 0 && step == 0 && stage == 0)
        laboratory_tell(lab, "this is t = 0");
    else if (steps > 0 && step >= experiment_last_step(laboratory_run(lab)))
        laboratory_tell(lab, "this is the end of the run");
    else
        player_seek(lab, step + steps, 0);
}

void command_stage_forward(Laboratory *lab)
{
    Experiment *experiment = laboratory_run(lab);
    long step;
    int stage;
    player_place(lab, &step, &stage);
    player_pause(lab);
    if (experiment_at_end(experiment)) {
        laboratory_tell(lab, "this is the end of the run");
        return;
    }
    if (lab->player.playback.state == STATE_COMPUTING) {
        /* from the place that it is on its way to, not from where it has come */
        bool whole = stage + 1 >= experiment_simulation(experiment)->n_stages;
        player_seek(lab, whole ? step + 1 : step, whole ? 0 : stage + 1);
        return;
    }
    Status status = {STATUS_DONE, ""};
    duel_next_stage(&lab->player.duel, &status);
    player_settle(lab);
    if (status.text[0])
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
    else if (lab->player.duel.b && experiment_stage(experiment) == 1)
        laboratory_tell(lab, "A goes by stages; B waits at its step %ld, before A's step ends",
                        experiment_step(lab->player.duel.b));
}

void command_stage_back(Laboratory *lab)
{
    long step;
    int stage;
    player_place(lab, &step, &stage);
    player_pause(lab);
    if (stage > 0)
        player_seek(lab, step, stage - 1);
    else if (step > 0)
        player_seek(lab, step - 1, laboratory_simulation(lab)->n_stages - 1);
    else
        laboratory_tell(lab, "this is t = 0");
}

void command_pace(Laboratory *lab, int direction)
{
    Screen *screen = &lab->screen;
    if (screen->eye.open && command_map_is_focused(&lab->screen)) {
        command_map_magnify(&lab->screen, direction);
        return;
    }
    if (lab->player.playback.slow) {
        /* Twice as fast or half as fast: from four stages in a second to one in eight. */
        enum { LEAST = 5, MOST = 8 * FRAMES_PER_SECOND };
        int *frames = &lab->player.slow_frames;
        const int wanted = direction > 0 ? *frames / 2 : *frames * 2;
        *frames = wanted < LEAST ? LEAST : wanted > MOST ? MOST : wanted;
        laboratory_tell(lab, "a stage every %.2g s", (double)*frames / FRAMES_PER_SECOND);
        return;
    }
    double pace = player_next_125(lab->player.playback.pace, direction);
    /* a step in a hundred frames, or ten million in one: beyond that nothing is seen of a change */
    if (pace < 0.01 || pace > 1e7)
        return;
    lab->player.playback.pace = pace;
    lab->player.playback.at_limit = false;
    lab->player.pace_automatic = false;
    lab->player.owed = 0;
    if (pace >= 1)
        laboratory_tell(lab, "%g steps a frame", pace);
    else
        laboratory_tell(lab, "a step every %g frames", round(1 / pace));
}

void command_to_start(Laboratory *lab)
{
    player_go_to(lab, 0);
}

void command_to_newest(Laboratory *lab)
{
    player_go_to(lab, experiment_newest(laboratory_run(lab)));
}

bool command_answer_go_to(Laboratory *lab, const char *text)
{
    long step = 0;
    double time = 0, dt = laboratory_simulation(lab)->dt;
    long last = experiment_last_step(laboratory_run(lab));
    if (text[0] == '#') {
        if (!text_to_long(text + 1, &step))
            return prompt_refuse(lab, "after # comes the number of a step, as in #1000");
    } else if (stop_read_time(text, laboratory_run(lab), &time)) {
        step = time / dt > (double)last ? last + 1 : time < 0 ? -1 : lround(time / dt);
        /* the last step may end a little before time.end; who types that means the end */
        if (time > (double)last * dt && time <= settings_time(laboratory_settings(lab))->end * (1 + 1e-9))
            step = last;
    } else
        return prompt_refuse(lab, "a time, as in 12.5, or a step, as in #1000");
    if (step < 0 || step > last) {
        return prompt_refuse(lab, "the run goes from 0 to %s (#0 to #%ld)",
                             text_rounded((double)last * dt, 6).text, last);
    }
    player_go_to(lab, step);
    return true;
}

void command_go_to(Laboratory *lab)
{
    prompt_ask(lab, command_answer_go_to, false, "", "go to time (or #step)");
}

void command_restart(Laboratory *lab)
{
    bool computing = lab->player.playback.state == STATE_COMPUTING;
    begin_again(lab, (computing ? lab->player.resume : lab->player.playback.state) == STATE_RUNNING);
}

/* The first bookmark that is not before a place. */
static int bookmark_from(const Screen *screen, long step, int stage)
{
    int at = 0;
    while (at < screen->bookmarks->count &&
           (screen_bookmark_step(screen, at) < step ||
            (screen_bookmark_step(screen, at) == step && screen->bookmarks->places[at].stage < stage)))
        at++;
    return at;
}

static bool is_bookmark(const Screen *screen, int at, long step, int stage)
{
    return at < screen->bookmarks->count && screen_bookmark_step(screen, at) == step &&
           screen->bookmarks->places[at].stage == stage;
}

/* Where there is one already it is taken away. */
void command_bookmark(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    long step;
    int stage;
    player_place(lab, &step, &stage);
    const int at = bookmark_from(screen, step, stage);
    Bookmark *place = &lab->player.bookmarks.places[at];
    const size_t after = (size_t)(lab->player.bookmarks.count - at);
    if (is_bookmark(screen, at, step, stage)) {
        memmove(place, place + 1, (after - 1) * sizeof *place);
        lab->player.bookmarks.count--;
        laboratory_tell(lab, "the bookmark at step %ld is gone", step);
    } else if (lab->player.bookmarks.count == BOOKMARKS_MAX) {
        laboratory_tell(lab, "there is room for %d bookmarks: m on one of them takes it away", BOOKMARKS_MAX);
    } else {
        memmove(place + 1, place, after * sizeof *place);
        *place = (Bookmark){(double)step * laboratory_simulation(lab)->dt, stage};
        lab->player.bookmarks.count++;
        laboratory_tell(lab, "bookmark at step %ld: ' comes back here, m again takes it away", step);
    }
}

/* To the next one in the run, from the last one to the first. */
void command_jump(Laboratory *lab)
{
    const Screen *screen = &lab->screen;
    const int n_stages = laboratory_simulation(lab)->n_stages;
    long step;
    int stage;
    if (lab->player.bookmarks.count == 0) {
        laboratory_tell(lab, "no bookmark yet: m sets one");
        return;
    }
    player_place(lab, &step, &stage);
    int at = bookmark_from(screen, step, stage);
    at += is_bookmark(screen, at, step, stage);
    at %= lab->player.bookmarks.count;
    stage = lab->player.bookmarks.places[at].stage;
    player_pause(lab);
    player_seek(lab, screen_bookmark_step(screen, at), stage < n_stages ? stage : 0);
    if (lab->player.bookmarks.count > 1)
        laboratory_tell(lab, "bookmark %d of %d", at + 1, lab->player.bookmarks.count);
}

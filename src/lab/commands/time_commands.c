/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands of time: run, step, go back, bookmarks; those that stop a run by themselves: until something,
 * from event to event, a stretch again and again; and slow motion. */
#include "lab/commands/commands.h"
#include "scenario/concern_time.h"
#include "base/text.h"

#include <math.h>
#include <string.h>
#include <stdio.h>

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

static bool answer_again(Laboratory *lab, const char *text, Status *status)
{
    (void)text;
    (void)status;
    begin_again(lab, true);
    return true;
}

void command_run_or_pause(Laboratory *lab)
{
    if (lab->player.playback.slow)
        player_pause(lab);
    else if (lab->player.playback.state == STATE_ENDED) {
        const double rate = lab->player.rates[RATE_RUN];
        const double seconds = rate > 0 ? (double)experiment_last_step(laboratory_run(lab)) / rate : 0;
        if (seconds < AGAIN_SECONDS)
            begin_again(lab, true);
        else
            prompt_ask(lab, answer_again, &prompt_yes_no, "", "run again from t = 0? it takes about %s s",
                       text_rounded(seconds, 2).text);
    } else if (lab->player.playback.state == STATE_FAILED)
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
    const Place at = player_place(lab);
    player_pause(lab);
    if (steps < 0 && at.stage > 0)
        steps++;
    if (steps < 0 && at.step == 0 && at.stage == 0)
        laboratory_tell(lab, "this is t = 0");
    else if (steps > 0 && at.step >= experiment_last_step(laboratory_run(lab)))
        laboratory_tell(lab, "this is the end of the run");
    else
        player_seek(lab, at.step + steps, 0);
}

void command_stage_forward(Laboratory *lab)
{
    Experiment *experiment = laboratory_run(lab);
    const Place at = player_place(lab);
    player_pause(lab);
    if (experiment_at_end(experiment)) {
        laboratory_tell(lab, "this is the end of the run");
        return;
    }
    if (lab->player.playback.state == STATE_COMPUTING) {
        /* from the place that it is on its way to, not from where it has come */
        bool whole = at.stage + 1 >= experiment_simulation(experiment)->n_stages;
        player_seek(lab, whole ? at.step + 1 : at.step, whole ? 0 : at.stage + 1);
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
    const Place at = player_place(lab);
    player_pause(lab);
    if (at.stage > 0)
        player_seek(lab, at.step, at.stage - 1);
    else if (at.step > 0)
        player_seek(lab, at.step - 1, laboratory_simulation(lab)->n_stages - 1);
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

/* Of what has been computed, the first (by -1) or the last. */
void command_to_end(Laboratory *lab, int by)
{
    player_go_to(lab, by < 0 ? 0 : experiment_newest(laboratory_run(lab)));
}

bool command_answer_go_to(Laboratory *lab, const char *text, Status *status)
{
    long step = 0;
    double time = 0, dt = laboratory_simulation(lab)->dt;
    long last = experiment_last_step(laboratory_run(lab));
    if (text[0] == '#') {
        if (!text_to_long(text + 1, &step))
            return status_refuse(status, "after # comes the number of a step, as in #1000");
    } else if (stop_read_time(text, laboratory_run(lab), &time)) {
        step = time / dt > (double)last ? last + 1 : time < 0 ? -1 : lround(time / dt);
        /* the last step may end a little before time.end; who types that means the end */
        if (time > (double)last * dt && time <= settings_time(laboratory_settings(lab))->end * (1 + 1e-9))
            step = last;
    } else
        return status_refuse(status, "a time, as in 12.5, or a step, as in #1000");
    if (step < 0 || step > last) {
        return status_refuse(status, "the run goes from 0 to %s (#0 to #%ld)",
                             text_rounded((double)last * dt, 6).text, last);
    }
    player_go_to(lab, step);
    return true;
}

void command_go_to(Laboratory *lab)
{
    prompt_ask(lab, command_answer_go_to, NULL, "", "go to time (or #step)");
}

void command_restart(Laboratory *lab)
{
    bool computing = lab->player.playback.state == STATE_COMPUTING;
    begin_again(lab, (computing ? lab->player.resume : lab->player.playback.state) == STATE_RUNNING);
}

/* The first bookmark that is not before where the run is; `is_here`: it is at this very place. */
static int next_bookmark(const Laboratory *lab, bool *is_here)
{
    const Bookmarks *bookmarks = &lab->player.bookmarks;
    const Place here = player_place(lab);
    for (int at = 0; at < bookmarks->count; at++) {
        const long step = screen_bookmark_step(&lab->screen, at);
        const int stage = bookmarks->places[at].stage;
        *is_here = step == here.step && stage == here.stage;
        if (step > here.step || (step == here.step && stage >= here.stage))
            return at;
    }
    *is_here = false;
    return bookmarks->count;
}

/* Where there is one already it is taken away. */
void command_bookmark(Laboratory *lab)
{
    Bookmarks *bookmarks = &lab->player.bookmarks;
    const Place here = player_place(lab);
    bool is_here;
    const int at = next_bookmark(lab, &is_here);
    Bookmark *place = &bookmarks->places[at];
    const size_t after = (size_t)(bookmarks->count - at);
    if (is_here) {
        memmove(place, place + 1, (after - 1) * sizeof *place);
        bookmarks->count--;
        laboratory_tell(lab, "the bookmark at step %ld is gone", here.step);
    } else if (bookmarks->count == BOOKMARKS_MAX) {
        laboratory_tell(lab, "there is room for %d bookmarks: m on one of them takes it away", BOOKMARKS_MAX);
    } else {
        memmove(place + 1, place, after * sizeof *place);
        *place = (Bookmark){(double)here.step * laboratory_simulation(lab)->dt, here.stage};
        bookmarks->count++;
        laboratory_tell(lab, "bookmark at step %ld: ' comes back here, m again takes it away", here.step);
    }
}

/* To the next one in the run, from the last one to the first. */
void command_jump(Laboratory *lab)
{
    const Bookmarks *bookmarks = &lab->player.bookmarks;
    bool is_here;
    if (bookmarks->count == 0) {
        laboratory_tell(lab, "no bookmark yet: m sets one");
        return;
    }
    int at = next_bookmark(lab, &is_here);
    at = (at + is_here) % bookmarks->count;
    const int stage = bookmarks->places[at].stage;
    player_pause(lab);
    player_seek(lab, screen_bookmark_step(&lab->screen, at),
                stage < laboratory_simulation(lab)->n_stages ? stage : 0);
    if (bookmarks->count > 1)
        laboratory_tell(lab, "bookmark %d of %d", at + 1, bookmarks->count);
}

/* --- until --------------------------------------------------------------------------------------------- */

static void run_to(Laboratory *lab, const Stop *stop)
{
    player_stop_at(lab, stop);
    lab->player.playback.slow = false;
    lab->player.resume = STATE_RUNNING;
    lab->player.owed = 0;
    player_settle(lab);
}

bool command_answer_until(Laboratory *lab, const char *text, Status *status)
{
    const Experiment *experiment = laboratory_run(lab);
    const bool first = strncmp(text, "first ", 6) == 0;
    Stop stop = {.kind = STOP_NEVER};
    if (!*text) {
        laboratory_tell(lab,
                        lab->player.playback.until[0] ? "the run does not stop at %s any more"
                                                      : "until what? as in until t 2.5, until crossing",
                        lab->player.playback.until);
        player_stop_at(lab, &stop);
        return true;
    }
    text += first ? 6 + strspn(text + 6, " ") : 0;
    if (!stop_read(&stop, text, experiment, status))
        return false;
    int count;
    const Event *events = experiment_events(experiment, &count);
    for (int i = 0; first && i < count; i++) /* what has happened already is gone back to */
        if (stop.events >> events[i].kind & 1) {
            player_go_to(lab, events[i].step);
            laboratory_tell(lab, "step %ld: %s", events[i].step, events[i].text);
            return true;
        }
    const long step = stop_step(&stop, experiment);
    if (step >= 0 && step <= experiment_step(experiment)) {
        player_go_to(lab, step);
    } else if (experiment_at_end(experiment) || lab->player.playback.state == STATE_FAILED)
        return status_refuse(status, "the run is at its end: r begins it again");
    else
        run_to(lab, &stop);
    return true;
}

/* --- events --- */

static void go_to_event(Laboratory *lab, const Event *events, int at, int count)
{
    const long step = events[at].step;
    player_go_to(lab, step);
    laboratory_tell(lab, "event %d of %d: %s", at + 1, count, events[at].text);
}

bool command_answer_event(Laboratory *lab, const char *text, Status *status)
{
    int count;
    const Event *events = experiment_events(laboratory_run(lab), &count);
    long number;
    if (text_to_long(text, &number) && number >= 1 && number <= count) {
        go_to_event(lab, events, (int)number - 1, count);
        return true;
    }
    return status_refuse(status,
                         count > 0 ? "which event? (1 to %d so far; :until event runs on to the next)"
                                   : "no event so far; :until event runs on to one",
                         count);
}

/* The next one, to which the run goes on if it has not been there yet, or (by -1) the one before. */
void command_event_beside(Laboratory *lab, int by)
{
    int count;
    const Place here = player_place(lab);
    const Event *events = experiment_events(laboratory_run(lab), &count);
    int at = 0; /* the first one behind this place */
    while (at < count && events[at].step <= here.step - (by < 0 && here.stage == 0))
        at++;
    at -= by < 0;
    if (at >= 0 && at < count) {
        go_to_event(lab, events, at, count);
        return;
    }
    Stop stop;
    Status status = {STATUS_DONE, ""};
    if (by < 0)
        laboratory_tell(lab, "there is no event before this time");
    else if (here.step >= experiment_last_step(laboratory_run(lab)) ||
             lab->player.playback.state == STATE_FAILED)
        laboratory_tell(lab, "there is no event after this one");
    else if (!stop_read(&stop, "event", laboratory_run(lab), &status))
        laboratory_tell(lab, "%s", status.text);
    else
        run_to(lab, &stop);
}

/* --- a stretch of time --- */

/* Two times separated by a space or, where they have spaces of their own, by "to". */
static bool read_times(const char *text, const Experiment *experiment, double *from, double *to)
{
    char first[2 * NUMBER_TEXT_MAX];
    const char *word = strstr(text, " to ");
    const size_t length = word ? (size_t)(word - text) : strcspn(text, " ");
    if (length == 0 || length >= sizeof first)
        return false;
    memcpy(first, text, length);
    first[length] = '\0';
    return stop_read_time(first, experiment, from) &&
           stop_read_time(text + length + (word ? 4 : 0), experiment, to);
}

bool command_answer_loop(Laboratory *lab, const char *text, Status *status)
{
    const double dt = laboratory_simulation(lab)->dt;
    const double end = (double)experiment_last_step(laboratory_run(lab)) * dt;
    Stretch loop = {.on = true};
    if (!*text && lab->player.playback.looping) {
        player_loop(lab, &(Stretch){.on = false});
        laboratory_tell(lab, "the run goes on to its end again");
        return true;
    }
    if (!*text && lab->player.bookmarks.count > 1) {
        loop.from = lab->player.bookmarks.places[0].time;
        loop.to = lab->player.bookmarks.places[lab->player.bookmarks.count - 1].time;
    } else if (!read_times(text, laboratory_run(lab), &loop.from, &loop.to) || !(loop.from >= 0) ||
               !(loop.to <= end * (1 + 1e-9)) || !(loop.to >= loop.from + dt * (1 - 1e-9))) {
        const NumberText last = text_rounded(end, 6);
        return status_refuse(status, "two times are expected, as in loop 0 %s, the second at most %s",
                             last.text, last.text);
    }
    player_pause(lab);
    player_loop(lab, &loop);
    lab->player.resume = STATE_RUNNING;
    player_seek(lab, lround(loop.from / dt), 0);
    laboratory_tell(lab, "again and again; :loop alone ends it");
    return true;
}

/* Stage after stage, each long enough to be looked at; the run counts as paused. */
void command_slow_motion(Laboratory *lab)
{
    enum { SLOW_FRAMES = 20 }; /* a stage in two thirds of a second */
    const bool on = !lab->player.playback.slow;
    if (experiment_at_end(laboratory_run(lab))) {
        laboratory_tell(lab, "this is the end of the run");
        return;
    }
    player_pause(lab);
    if (lab->player.slow_frames == 0)
        lab->player.slow_frames = SLOW_FRAMES;
    lab->player.slow_left = 0;
    lab->player.playback.slow =
        on && lab->player.playback.state != STATE_ENDED && lab->player.playback.state != STATE_FAILED;
}

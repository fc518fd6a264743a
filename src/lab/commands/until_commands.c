/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands that stop a run by themselves: until something, from event to event, a stretch again and
 * again; and slow motion. */
#include "lab/commands/commands.h"

#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* --- until --------------------------------------------------------------------------------------------- */

static void run_to(Laboratory *lab, const Stop *stop)
{
    player_stop_at(lab, stop);
    lab->player.playback.slow = false;
    lab->player.resume = STATE_RUNNING;
    lab->player.owed = 0;
    player_settle(lab);
}

/* What has happened already is gone back to; false: there is nothing of the kind. */
static bool go_to_first(Laboratory *lab, const Stop *stop)
{
    int count;
    const Event *events = experiment_events(laboratory_run(lab), &count);
    for (int i = 0; i < count; i++)
        if (stop->events >> events[i].kind & 1) {
            player_go_to(lab, events[i].step);
            laboratory_tell(lab, "step %ld: %s", events[i].step, events[i].text);
            return true;
        }
    return false;
}

bool command_answer_until(Laboratory *lab, const char *text)
{
    const Experiment *experiment = laboratory_run(lab);
    const bool first = strncmp(text, "first ", 6) == 0;
    Stop stop = {.kind = STOP_NEVER};
    Status status = {STATUS_DONE, ""};
    if (!*text) {
        laboratory_tell(lab,
                        lab->player.playback.until[0] ? "the run does not stop at %s any more"
                                                      : "until what? as in until t 2.5, until crossing",
                        lab->player.playback.until);
        player_stop_at(lab, &stop);
        return true;
    }
    text += first ? 6 + strspn(text + 6, " ") : 0;
    if (!stop_read(&stop, text, experiment, &status))
        return prompt_refuse(lab, "%s", status.text);
    if (first && go_to_first(lab, &stop))
        return true;
    const long step = stop_step(&stop, experiment);
    if (step >= 0 && step <= experiment_step(experiment)) {
        player_go_to(lab, step);
    } else if (experiment_at_end(experiment) || lab->player.playback.state == STATE_FAILED)
        return prompt_refuse(lab, "the run is at its end: r begins it again");
    else
        run_to(lab, &stop);
    return true;
}

/* --- events -----------------------------------------------------------------------------------------------
 */

static void go_to_event(Laboratory *lab, const Event *events, int at, int count)
{
    const long step = events[at].step;
    player_go_to(lab, step);
    laboratory_tell(lab, "event %d of %d: %s", at + 1, count, events[at].text);
}

bool command_answer_event(Laboratory *lab, const char *text)
{
    int count;
    const Event *events = experiment_events(laboratory_run(lab), &count);
    char why[96];
    long number;
    if (text_to_long(text, &number) && number >= 1 && number <= count) {
        go_to_event(lab, events, (int)number - 1, count);
        return true;
    }
    snprintf(why, sizeof why, "which event? (1 to %d so far; :until event runs on to the next)", count);
    return prompt_refuse(lab, "%s", count > 0 ? why : "no event so far; :until event runs on to one");
}

void command_next_event(Laboratory *lab)
{
    int count, at = 0, stage;
    long step;
    const Event *events = experiment_events(laboratory_run(lab), &count);
    player_place(lab, &step, &stage);
    while (at < count && events[at].step <= step)
        at++;
    if (at < count) {
        go_to_event(lab, events, at, count);
        return;
    }
    Stop stop;
    Status status = {STATUS_DONE, ""};
    if (step >= experiment_last_step(laboratory_run(lab)) || lab->player.playback.state == STATE_FAILED)
        laboratory_tell(lab, "there is no event after this one");
    else if (!stop_read(&stop, "event", laboratory_run(lab), &status))
        laboratory_tell(lab, "%s", status.text);
    else
        run_to(lab, &stop);
}

void command_previous_event(Laboratory *lab)
{
    int count, stage;
    long step;
    const Event *events = experiment_events(laboratory_run(lab), &count);
    player_place(lab, &step, &stage);
    int at = count - 1;
    while (at >= 0 && (events[at].step > step || (events[at].step == step && stage == 0)))
        at--;
    if (at >= 0)
        go_to_event(lab, events, at, count);
    else
        laboratory_tell(lab, "there is no event before this time");
}

/* --- a stretch of time -------------------------------------------------------------------------------------
 */

/* Two times parted by a space or, where they have spaces of their own, by "to". */
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

bool command_answer_loop(Laboratory *lab, const char *text)
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
        return prompt_refuse(lab, "two times are wanted, as in loop 0 %s, the second at most %s", last.text,
                             last.text);
    }
    player_pause(lab);
    player_loop(lab, &loop);
    lab->player.resume = STATE_RUNNING;
    player_seek(lab, lround(loop.from / dt), 0);
    laboratory_tell(lab, "again and again; :loop alone ends it");
    return true;
}

/* --- slow motion
 * --------------------------------------------------------------------------------------------- */

void command_slow_motion(Laboratory *lab)
{
    if (experiment_at_end(laboratory_run(lab)))
        laboratory_tell(lab, "this is the end of the run");
    else
        player_slow_motion(lab, !lab->player.playback.slow);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The engine's share of a frame: how many steps it takes, and when the next key, or the next picture, has its
 * turn.
 *
 * A run that goes on owes so many steps a frame (its pace); one on the way to a time does as many as the
 * frame has room for. Steps are done in pieces short enough to look at the clock between them, judged by what
 * the last ones took, and a step that is longer than a frame in parts. */
#include "lab/laboratory.h"

#include <math.h>

#define MESSAGE_SECONDS 4.0   /* after that long the keys come back into the key line */
#define CHUNK_SECONDS   0.004 /* the engine is let go for about that long before the clock is read again */
#define STEP_SHARE      0.5   /* of a frame: a step that takes longer is done in parts */
#define ROUND_FRAMES    15    /* frames in time before "max" goes from the title */

bool laboratory_active(const Laboratory *lab)
{
    return !lab->closed &&
           (lab->player.playback.state == STATE_RUNNING || lab->player.playback.state == STATE_COMPUTING ||
            lab->player.playback.slow || refining_is_due(lab));
}

double laboratory_message_left(const Laboratory *lab)
{
    return lab->message.kind == MESSAGE_INFO
               ? fmax(0, lab->said_at + MESSAGE_SECONDS - lab->host.now(lab->host.context))
               : -1;
}

/* Steps for the next piece of work: about CHUNK_SECONDS of it, judged by the last piece. */
static long chunk(double rate, long wanted, double time_left)
{
    double seconds = time_left < CHUNK_SECONDS ? time_left : CHUNK_SECONDS;
    double steps = rate > 0 ? rate * seconds : 1;
    return steps < 1 ? 1 : steps > (double)wanted ? wanted : (long)steps;
}

/* What the next step will take. */
static double step_seconds(double rate)
{
    return rate > 0 ? 1 / rate : 0;
}

static bool key_waits(const Host *host)
{
    return host->key_waits && host->key_waits(host->context);
}

/* Does a piece of work by `verb`, all of it or, of steps that are long, a part of one up to the deadline, and
 * informs the clock. Returns how many steps were completed. */
static long work(Laboratory *lab, bool (*verb)(Duel *, Effort, bool *, Status *), double *rate, long steps,
                 double deadline, bool *sound, Status *status)
{
    Player *player = &lab->player;
    /* not whole are the first one, of which nothing is known, and those that leave no room in a frame */
    const bool in_parts = player->in_parts || *rate <= 0 || step_seconds(*rate) >= STEP_SHARE * FRAME_SECONDS;
    /* all of a step may be in one stage */
    const Effort effort = {.steps = in_parts ? 1 : steps,
                           .share = !in_parts   ? 0
                                    : *rate > 0 ? CHUNK_SECONDS * *rate
                                                : 1.0 / 64};
    bool whole = false;
    double last = lab->host.now(lab->host.context);
    do {
        *sound = verb(&player->duel, effort, &whole, status);
        if (whole)
            lab->host.worked(lab->host.context, effort.steps);
        double now = lab->host.now(lab->host.context);
        player->part_seconds += now - last;
        last = now;
    } while (*sound && !whole && last < deadline && !key_waits(&lab->host));
    player->in_parts = *sound && !whole;
    if (player->in_parts)
        return 0;
    /* How fast the engine is: a running mean over pieces, so that one hiccup does not count; of a piece too
     * short for the clock only a bound is known. */
    const double seconds = player->part_seconds, steps_done = (double)effort.steps;
    const double now = seconds > 0 ? steps_done / seconds : 8 * steps_done / CHUNK_SECONDS;
    *rate = *rate <= 0 || seconds <= 0 ? fmax(now, *rate) : 0.7 * *rate + 0.3 * now;
    player->part_seconds = 0;
    return effort.steps;
}

static bool run_frame(Laboratory *lab, double deadline)
{
    Status status = {STATUS_DONE, ""};
    double begin = lab->host.now(lab->host.context);
    if (!lab->player.in_parts)
        lab->player.owed += lab->player.playback.pace;
    long wanted = lab->player.in_parts ? 1 : (long)lab->player.owed, done = 0;
    if (!lab->player.in_parts)
        lab->player.owed -= (double)wanted;
    const long ahead = player_steps_ahead(lab);
    if (!lab->player.in_parts && ahead < wanted)
        wanted = ahead; /* of a duel A may be there: the step is whole when B is too */
    bool sound = true, in_time = true, arrived = false;
    const bool watched = lab->player.stop.kind == STOP_AT_EVENT;
    if (!lab->player.in_parts) {
        stop_look(&lab->player.stop, laboratory_run(lab));
        arrived = player_arrive(lab); /* other keys may have brought it there */
    }
    double *rate = &lab->player.rates[RATE_RUN];
    while (sound && in_time && !arrived && done < wanted &&
           (lab->player.in_parts || !experiment_at_end(laboratory_run(lab)))) {
        if (done > 0 && key_waits(&lab->host)) {
            lab->player.owed += fmin((double)(wanted - done), lab->player.playback.pace);
            break;
        }
        double left = deadline - lab->host.now(lab->host.context);
        if (done > 0 && left < step_seconds(*rate)) {
            in_time = false;
        } else {
            done += work(lab, duel_advance, rate, watched ? 1 : chunk(*rate, wanted - done, left), deadline,
                         &sound, &status);
            in_time = !lab->player.in_parts;
        }
        arrived = sound && !lab->player.in_parts && player_arrive(lab);
    }
    lab->player.frames_in_time = in_time ? lab->player.frames_in_time + 1 : 0;
    if (!in_time)
        lab->player.playback.at_limit = true;
    else if (lab->player.frames_in_time >= ROUND_FRAMES)
        lab->player.playback.at_limit = false;
    double took = lab->host.now(lab->host.context) - begin;
    double reached = (double)done / (took > FRAME_SECONDS ? took / FRAME_SECONDS : 1);
    lab->player.playback.rate =
        lab->player.playback.rate > 0 ? 0.8 * lab->player.playback.rate + 0.2 * reached : reached;
    if (!arrived && !lab->player.in_parts && (!sound || experiment_at_end(laboratory_run(lab))))
        player_settle(lab);
    player_tell_second(lab);
    return !lab->player.in_parts || done > 0;
}

static bool compute_frame(Laboratory *lab, double deadline)
{
    Duel *duel = &lab->player.duel;
    Status status = {STATUS_DONE, ""};
    long left, most = 0;
    bool sound = true;
    for (bool first = true; sound && duel_pending(duel, &left); first = false) {
        double time_left = deadline - lab->host.now(lab->host.context);
        double *rate = &lab->player.rates[duel_turn(duel) == duel->b ? RATE_SECOND : RATE_FIRST];
        if (!first && (time_left < step_seconds(*rate) || key_waits(&lab->host)))
            break;
        if (left > most)
            most = left;
        work(lab, duel_work, rate, chunk(*rate, left > 0 ? left : 1, time_left), deadline, &sound, &status);
        if (lab->player.in_parts)
            return false;
    }
    if (!sound || !duel_pending(duel, &left)) {
        lab->player.playback.work_share = 0;
        player_settle(lab);
        return true;
    }
    /* the first frame of a work is where its length is known */
    if (lab->player.playback.work_share <= 0 || left > lab->player.work_total)
        lab->player.work_total = most > 0 ? most : 1;
    lab->player.playback.work_share = 1 - (double)left / (double)lab->player.work_total;
    if (lab->player.playback.work_share < 1e-6)
        lab->player.playback.work_share = 1e-6;
    return true;
}

static bool do_frame(Laboratory *lab, double deadline)
{
    if (laboratory_message_left(lab) == 0)
        laboratory_say(lab, MESSAGE_NONE, "%s", "");
    if (lab->player.playback.state == STATE_COMPUTING)
        return compute_frame(lab, deadline);
    if (lab->player.playback.state == STATE_RUNNING)
        return run_frame(lab, deadline);
    if (lab->player.playback.slow) {
        /* Slow motion: a stage, then a pause. */
        Status status = {STATUS_DONE, ""};
        if (lab->player.slow_left-- > 0)
            return false;
        lab->player.slow_left = lab->player.slow_frames - 1;
        if (experiment_stage(laboratory_run(lab)) == 0)
            stop_look(&lab->player.stop, laboratory_run(lab));
        duel_next_stage(&lab->player.duel, &status);
        if (experiment_stage(laboratory_run(lab)) > 0 || !player_arrive(lab))
            player_settle(lab);
        return true;
    }
    if (refining_is_due(lab))
        refining_work(lab);
    return true;
}

bool laboratory_frame(Laboratory *lab, double deadline)
{
    const bool news = do_frame(lab, deadline);
    lesson_play_continue(lab);
    lab->given_up = false;
    for (Key key; lesson_entry_next_key(lab, &key);)
        laboratory_key(lab, &key);
    return news;
}

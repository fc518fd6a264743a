/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Presses the keys of a session again, each at the step of the run at which it was pressed. */
#include "lab/session/session.h"

#include "lab/laboratory.h"

const SessionEvent *replay_next(const Replay *replay)
{
    return replay->session ? session_event(replay->session, replay->next) : NULL;
}

static bool is_there(const Laboratory *lab, const SessionEvent *event)
{
    const Experiment *experiment = laboratory_run(lab);
    return experiment_step(experiment) == event->step && experiment_stage(experiment) == event->stage;
}

/* A key that came while a loop jumped back to its beginning comes there again, in whichever round. False: the
 * run has not come to the end of its stretch. */
static bool reach_jump(Laboratory *lab, double deadline)
{
    while (lab->player.playback.state == STATE_RUNNING && lab->player.loop.on) {
        if (lab->host.now(lab->host.context) >= deadline)
            return false;
        lab->player.owed = (double)player_steps_ahead(lab);
        laboratory_frame(lab, deadline);
    }
    return true;
}

/* To the event's place: the run goes on, or else it is gone to, once; a run that ends or fails earlier than
 * it did stands where it is. A loop never runs beyond its end: such a place is gone to. False: it is on its
 * way. */
static bool approach(Replay *replay, Laboratory *lab, const SessionEvent *event, double deadline)
{
    while (lab->player.playback.state == STATE_COMPUTING || !is_there(lab, event)) {
        const long ahead = event->step - experiment_step(laboratory_run(lab));
        if (lab->player.playback.state == STATE_RUNNING && ahead > 0 &&
            (!lab->player.loop.on || ahead < player_steps_ahead(lab))) {
            lab->player.run_limit = event->step;
            lab->player.owed = (double)ahead;
        } else if (lab->player.playback.state != STATE_COMPUTING) {
            if (replay->sought)
                return true;
            replay->sought = true;
            player_seek(lab, event->step, event->stage);
        }
        laboratory_frame(lab, deadline);
        lab->player.run_limit = -1;
        if (lab->host.now(lab->host.context) >= deadline)
            return lab->player.playback.state != STATE_COMPUTING && is_there(lab, event);
    }
    return true;
}

bool replay_go_on(Replay *replay, Laboratory *lab, double deadline)
{
    const SessionEvent *event = replay_next(replay);
    if (event->is_stop) { /* what it stopped has been given up, with the key before it */
        replay->next++;
        session_note(lab->recording, lab, (SessionEvent){.is_stop = true, .key = {.x = -1}});
        return true;
    }
    if (event->on_the_way ? !reach_jump(lab, deadline) : !approach(replay, lab, event, deadline))
        return false;
    replay->next++;
    replay->sought = false;
    static const Key space = {.name = "Space", .x = -1, .y = -1};
    const Key *key = event->is_end ? &space : &event->key;
    /* opened again it is found paused; by a key, so that this too is recorded */
    if (event->is_end && (lab->player.playback.state != STATE_RUNNING || lab->screen.prompt->open ||
                          lab->screen.parameters->edit.open || lab->screen.help->open))
        return true;
    /* a click means the cell of the screen that it was made on */
    if (event->key.x >= 0 && event->width > 0) {
        lab->width = event->width;
        lab->height = event->height;
    }
    const SessionEvent *behind = replay_next(replay);
    lab->given_up = behind && behind->is_stop;
    laboratory_key(lab, key);
    lab->closed = false; /* it is the end of the session, not of this one */
    return true;
}

void replay_end(Replay *replay, Laboratory *lab)
{
    *replay = (Replay){.session = NULL};
    lab->player.run_limit = -1;
    prompt_close(&lab->prompting); /* its next key would be the user's, who did not see what was asked */
    lab->asker = laboratory_user(lab);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The points of a study of convergence, worked out while its view is on screen and nothing else goes on. */
#include "lab/laboratory.h"

#include "views/view.h"

/* The study on screen that still lacks points; NULL: none. */
static const ConvergenceStudy *study_to_do(const Laboratory *lab)
{
    const Screen *screen = &lab->screen;
    const View *const shown[] = {screen->views.lower, screen->views.upper};
    for (int i = 0; i < 2; i++) {
        const ConvergenceStudy *study = shown[i] ? view_study(shown[i], screen) : NULL;
        if (study && study != lab->refining.stopped &&
            convergence_lacks(&lab->refining.convergence, laboratory_settings(lab), study))
            return study;
    }
    return NULL;
}

bool refining_is_due(const Laboratory *lab)
{
    return laboratory_run(lab) && lab->player.playback.state != STATE_RUNNING &&
           lab->player.playback.state != STATE_COMPUTING && !lab->prompting.shown.open &&
           !lab->parameters.edit.open && !lab->help.open && study_to_do(lab);
}

/* A point takes up to some seconds. */
typedef struct Waiting {
    Laboratory *lab;
    const ConvergenceStudy *study;
    int point, count;
    bool for_key, stopped;
} Waiting;

static bool wait_for_point(double share, void *context)
{
    Waiting *waiting = context;
    Laboratory *lab = waiting->lab;
    const Host *host = &lab->host;
    waiting->for_key = host->key_waits && host->key_waits(host->context);
    if (waiting->for_key)
        return false;
    if (host->now(host->context) < lab->work_since + QUIET_SECONDS)
        return true;
    laboratory_tell(lab, "%s: point %d of %d, %d %%   ^C stops", waiting->study->title, waiting->point,
                    waiting->count, (int)(100 * share));
    waiting->stopped = !laboratory_go_on(lab);
    return !waiting->stopped;
}

void refining_work(Laboratory *lab)
{
    const Settings *settings = laboratory_settings(lab);
    const ConvergencePoint *points;
    Status status = {STATUS_DONE, ""};
    Waiting waiting = {.lab = lab, .study = study_to_do(lab)};
    if (!waiting.study)
        return;
    convergence_begin(&lab->refining.convergence, settings);
    waiting.point = 1 + convergence_known(&lab->refining.convergence, settings, waiting.study, &points);
    waiting.count = waiting.study->points;
    lab->work_since = lab->host.now(lab->host.context);
    const Cancel cancel = {wait_for_point, &waiting};
    if (convergence_next(&lab->refining.convergence, waiting.study, cancel, &status)) {
        if (lab->message.kind == MESSAGE_INFO && waiting.point == waiting.count)
            laboratory_say(lab, MESSAGE_NONE, "%s", "");
    } else if (waiting.stopped) {
        refining_stop(lab);
    } else if (!waiting.for_key) {
        lab->refining.stopped = waiting.study;
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
    }
}

bool refining_stop(Laboratory *lab)
{
    if (!refining_is_due(lab))
        return false;
    lab->refining.stopped = study_to_do(lab);
    laboratory_tell(lab, "%s: stopped; show the view again to go on", lab->refining.stopped->title);
    return true;
}

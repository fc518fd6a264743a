/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A progress bar with the time that is left, drawn ten times a second at most and only on a terminal; it
 * also tells a long command to stop when a signal came (progress.h). */
#include "cli/progress.h"
#include "base/clock.h"

#include "base/signals.h"
#include "base/threads.h"
#include "base/visible.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

void progress_begin(Progress *progress, bool quiet)
{
    signals_catch();
    *progress = (Progress){.visible = !quiet && isatty(STDERR_FILENO), .began = clock_seconds()};
}

bool progress_show(double share, void *context)
{
    Progress *progress = context;
    double now = progress->visible ? clock_seconds() : 0;
    /* a run that takes no time needs no bar */
    if (progress->visible && now - progress->began > 0.5 && now - progress->shown > 0.1) {
        enum { WIDTH = 40 };
        int full = (int)(share * WIDTH);
        char line[WIDTH + 1];
        for (int i = 0; i < WIDTH; i++)
            line[i] = i < full ? '#' : '.';
        line[WIDTH] = '\0';
        double left = share > 0 ? (now - progress->began) * (1 - share) / share : 0;
        visible_progress(stderr, "[%s] %3.0f %%  %.0f s left ", line, floor(100 * share), ceil(left));
        progress->shown = now;
    }
    return signals_ended_by() == 0;
}

void progress_end(const Progress *progress)
{
    if (progress->shown > 0)
        visible_progress(stderr, "%s", "");
}

double progress_seconds(const Progress *progress)
{
    return clock_seconds() - progress->began;
}

int progress_signal(void)
{
    return signals_ended_by();
}

int progress_result(bool done, const Status *status)
{
    return done ? STATUS_DONE : progress_signal() ? 128 + progress_signal() : (int)status->code;
}

int progress_threads(long wanted)
{
    return wanted > 0 ? (int)wanted : threads_default(false);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plans the frames (frames.h): evenly spaced over the run, or at the steps nearest to the given times;
 * ascending, each step once, and the last step where nothing else is asked for. */
#include "export/frames.h"
#include "scenario/concern_output.h"
#include "scenario/parameters.h"

#include <math.h>
#include <stdlib.h>

static void add(Frames *frames, long step)
{
    if (frames->count == 0 || frames->steps[frames->count - 1] < step)
        frames->steps[frames->count++] = step;
}

bool frames_plan(Frames *frames, const Settings *settings, double dt, long last, Status *status)
{
    double times[TIMES_MAX];
    int n_times = settings_times_read(settings_output(settings)->at, times, status);
    if (n_times < 0)
        return false;
    size_t most = settings_output(settings)->frames > 1 ? (size_t)settings_output(settings)->frames : 1;
    if ((size_t)n_times > most)
        most = (size_t)n_times;
    frames->count = 0;
    frames->steps = malloc(most * sizeof *frames->steps);
    if (!frames->steps)
        return status_fail(status, "not enough memory for %zu frames", most);
    if (settings_output(settings)->frames > 1)
        for (int i = 0; i < settings_output(settings)->frames; i++)
            add(frames, lround((double)last * i / (settings_output(settings)->frames - 1)));
    else if (n_times > 0)
        for (int i = 0; i < n_times; i++) {
            long step = lround(times[i] / dt);
            add(frames, step < last ? step : last);
        }
    else
        add(frames, last);
    return true;
}

void frames_free(Frames *frames)
{
    free(frames->steps);
    *frames = (Frames){0};
}

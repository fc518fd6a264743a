/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How many rows and columns panes take that both sheets have. */
#include "panes/panes.h"
#include "run/playback.h"

enum { WIDE = 120, LESSON_WIDTH = 37, WIDE_LESSON_WIDTH = 46 };

/* A caption is short; a stage, a summary and a table of runs are not. */
bool layout_has_caption(const Screen *screen)
{
    return !screen_second_run(screen) && pane_runs_rows(screen) == 0 &&
           (screen_is_running(screen) ||
            (screen->playback->state == STATE_COMPUTING && screen->playback->goes_on));
}

/* While a run goes on no more than the words need where there is a map: it takes the rest. */
int layout_box_rows(const Screen *screen, int height, bool map)
{
    if (layout_has_caption(screen))
        return height < 27 ? 3 : height < 30 ? 4 : height < 40 || map ? 5 : 6;
    return height < 22 ? 4 : height < 27 ? 5 : height < 30 ? 6 : height < 40 ? 9 : 10;
}

int layout_lesson_width(int width)
{
    return width < WIDE ? LESSON_WIDTH : WIDE_LESSON_WIDTH;
}

int layout_strip_rows(int height)
{
    return height < 28 ? 2 : height < 40 ? 3 : 4;
}

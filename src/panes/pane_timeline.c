/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The timeline: the part of the run that has been computed, where we are, and what happened when. */
#include "panes/panes.h"

#include "base/assertion.h"
#include "run/playback.h"

#include <math.h>
#include <stdio.h>

/* Where the line lies in a timeline of so many columns: the first cell is t = 0, the last one the end. */
typedef struct Line {
    int first, cells;
    char end[NUMBER_TEXT_MAX + 8];
} Line;

static Line line_of(const Screen *screen, int width)
{
    const Problem *facts = screen_problem(screen);
    const double dt = screen_simulation(screen)->dt;
    Line line = {.first = GUTTER};
    snprintf(
        line.end, sizeof line.end, "%s%s",
        text_fitted(dt * (double)experiment_last_step(screen->experiment) / facts->shown_time, 4, 10).text,
        facts->shown_time_unit);
    line.cells = width - GUTTER - 2 - glyphs_columns(line.end);
    return line;
}

static int cell_of(const Screen *screen, const Line *line, long step)
{
    const long last = experiment_last_step(screen->experiment);
    const double share = last > 0 ? (double)step / (double)last : 0;
    const int cell = (int)floor(share * (line->cells - 1) + 0.5);
    return line->first + (cell < line->cells ? cell : line->cells - 1);
}

long screen_bookmark_step(const Screen *screen, int index)
{
    ASSERT_INT(index, >=, 0);
    const double dt = screen_simulation(screen)->dt;
    const long step = lround(screen->bookmarks->places[index].time / dt),
               last = experiment_last_step(screen->experiment);
    return step < last ? step : last;
}

void pane_timeline(const Screen *screen, Area area)
{
    const Line line = line_of(screen, area.rect.width);
    if (line.cells < 8 || area.rect.height < 1)
        return;
    const int newest = cell_of(screen, &line, experiment_newest(screen->experiment));
    /* of a duel A's, by whose times the axes go */
    area_text_right(area, line.first, 0, screen_second_run(screen) ? "A t 0" : "t 0", STYLE_NORMAL);
    area_text(area, line.first + line.cells + 1, 0, line.end, STYLE_NORMAL);
    for (int x = line.first; x < line.first + line.cells; x++)
        area_put(area, x, 0, x > newest ? 0x00b7 : 0x2500, x > newest ? STYLE_FAINT : STYLE_NORMAL);
    area_put(area, line.first, 0, 0x251c, STYLE_NORMAL);
    area_put(area, newest, 0, 0x2524, STYLE_NORMAL);

    int count;
    bool seen[SCREEN_MARKS] = {false};
    const Event *events = experiment_events(screen->experiment, &count);
    for (size_t m = 0; m < SCREEN_MARKS; m++)
        for (int i = 0; i < count; i++)
            if (events[i].kind == screen_marks[m].kind) {
                seen[m] = true;
                area_put(area, cell_of(screen, &line, events[i].step), 0, (uint32_t)screen_marks[m].letter[0],
                         screen_marks[m].style);
            }
    for (int i = 0; i < screen->bookmarks->count; i++)
        area_put(area, cell_of(screen, &line, screen_bookmark_step(screen, i)), 0, 'm', STYLE_KEY);
    area_put(area, cell_of(screen, &line, experiment_step(screen->experiment)), 0, 0x25cf, STYLE_FOCUS);
    if (area.rect.height > 1) {
        /* What the marks are that there are. */
        Legend legend[SCREEN_MARKS + 2];
        char keys[SCREEN_MARKS][3];
        int n = 0;
        legend[n++] = (Legend){.style = STYLE_FOCUS, .name = "here", .key = "● "};
        if (screen->bookmarks->count > 0)
            legend[n++] = (Legend){.style = STYLE_KEY, .name = "bookmark", .key = "m "};
        for (size_t m = 0; m < SCREEN_MARKS; m++)
            if (seen[m]) {
                snprintf(keys[m], sizeof keys[m], "%s ", screen_marks[m].letter);
                legend[n++] =
                    (Legend){.style = screen_marks[m].style, .name = screen_marks[m].word, .key = keys[m]};
            }
        legend_draw(area, line.first, 1, legend, n);
    }
}

long screen_timeline_nearest(const Screen *screen, int width, int height, int x)
{
    const Rect rect = layout_make(screen, width, height).timeline;
    const Line line = line_of(screen, rect.width);
    int cell = x - rect.x - line.first;
    if (rect.width < 1 || line.cells < 8)
        return experiment_step(screen->experiment);
    cell = cell < 0 ? 0 : cell >= line.cells ? line.cells - 1 : cell;
    return lround((double)cell / (line.cells - 1) * (double)experiment_last_step(screen->experiment));
}

long screen_timeline_step(const Screen *screen, int width, int height, int x, int y)
{
    const Rect rect = layout_make(screen, width, height).timeline;
    const Line line = line_of(screen, rect.width);
    const int cell = x - rect.x - line.first;
    if (rect.width < 1 || y != rect.y || line.cells < 8 || cell < 0 || cell >= line.cells)
        return -1;
    return screen_timeline_nearest(screen, width, height, x);
}

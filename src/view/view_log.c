/* View 9: what happened, in words, newest last; one of them can be chosen and gone to. */
#include "view/panes.h"

#include <stdio.h>
#include <string.h>

enum { TIME_COLUMNS = 40 };

static void event_time(const Screen *screen, const Event *event, char out[48])
{
    time_text(screen, experiment_simulation(screen->experiment)->dt * (double)event->step, out, 48);
}

static Style style_of(const Event *event)
{
    switch (event->kind) {
    case EVENT_FAILURE:
        return STYLE_ERROR;
    case EVENT_ADVICE:
    case EVENT_ENERGY:
        return STYLE_WARNING;
    default:
        return STYLE_NORMAL;
    }
}

/* Lines that an event takes behind its time. */
static int lines_of(const Event *event, int width)
{
    const int lines = paragraph_lines(width, event->text);
    return lines > 1 ? lines : 1;
}

/* The first event to be drawn, so that the chosen one is seen and the rows are used. */
static int first_of(const Event *events, int count, int chosen, int width, int room)
{
    int first = chosen, lines = lines_of(&events[chosen], width);
    while (first > 0 && lines + lines_of(&events[first - 1], width) <= room)
        lines += lines_of(&events[--first], width);
    return count > 0 ? first : 0;
}

int screen_log_chosen(const Screen *screen)
{
    int count;
    experiment_events(screen->experiment, &count);
    return screen->log_event < 0 || screen->log_event >= count ? count - 1 : screen->log_event;
}

void view_log(const Screen *screen, Area area, Style heading, int variant)
{
    (void)variant;
    const Simulation *sim = experiment_simulation(screen->experiment);
    int count, columns = 0;
    const Event *events = experiment_events(screen->experiment, &count);
    char name[64], time[48];
    snprintf(name, sizeof name, "what happened: %d event%s", count, count == 1 ? "" : "s");
    area_rule(area, 0, name, heading);
    const int room = area.rect.height - 1 - (sim->events_beyond > 0);
    if (count == 0)
        area_text(area, 1, 1, "nothing out of the ordinary so far", STYLE_FAINT);
    for (int i = 0; i < count; i++) {
        event_time(screen, &events[i], time);
        columns = text_columns(time) > columns ? text_columns(time) : columns;
    }
    columns = columns < TIME_COLUMNS ? columns : TIME_COLUMNS;
    const int text = columns + 3, width = area.rect.width - text - 1, chosen = screen_log_chosen(screen);
    int y = 1;
    for (int i = count > 0 ? first_of(events, count, chosen, width, room) : 0; i < count && y <= room; i++) {
        const bool marked = i == chosen && heading == STYLE_FOCUS;
        const int lines = lines_of(&events[i], width);
        event_time(screen, &events[i], time);
        if (marked)
            for (int row = 0; row < lines; row++)
                for (int x = 0; x < area.rect.width; x++)
                    area_put(area, x, y + row, ' ', STYLE_SELECTED);
        area_text_right(area, 1 + columns, y, time, marked ? STYLE_SELECTED : STYLE_FAINT);
        area_paragraph(area, text, y, width, room - y + 1, events[i].text,
                       marked ? STYLE_SELECTED : style_of(&events[i]));
        y += lines;
    }
    if (sim->events_beyond > 0)
        area_print(area, 1, room + 1, STYLE_FAINT, "and %ld more crossings or breaks that are not kept",
                   sim->events_beyond);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What happened, in words, newest last, of both runs of a duel; one event can be chosen and gone to.
 */
#include "run/event_log.h"
#include "panes/panes.h"
#include "views/inspector/inspector.h"
#include "views/views.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { TIME_COLUMNS = 40, LOG_MAX = 2 * EVENT_LOG_MAX };

typedef struct LogEntry {
    const Event *event;
    double time;
    char run; /* 'A', 'B'; 0: there is one */
} LogEntry;

/* What the pane shows of them. */
typedef struct Log {
    LogEntry entries[LOG_MAX];
    int count, of_run[2];
    int columns; /* of the times */
    int text;    /* where the words begin, how wide they are, and rows for them */
    int width, room;
    int first; /* the first one to be drawn */
    long beyond;
} Log;

static void entry_time(const Screen *screen, const LogEntry *entry, char out[48])
{
    screen_time_text(screen, entry->time, out, 48);
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

/* --- what there is ---------------------------------------------------------------------------------- */

static void add_run(Log *log, Experiment *experiment, char run)
{
    const Simulation *sim = experiment_simulation(experiment);
    const Event *events = experiment_events(experiment, &log->of_run[run == 'B']);
    const int before = log->count;
    log->beyond += sim->events_beyond;
    for (int i = 0, at = 0; i < log->of_run[run == 'B'] && log->count < LOG_MAX; i++) {
        const LogEntry entry = {&events[i], sim->dt * (double)events[i].step, run};
        /* both lists ascend in time; at the same time A's stand first */
        while (at < before + i && log->entries[at].time <= entry.time * (1 + 1e-12))
            at++;
        memmove(&log->entries[at + 1], &log->entries[at], (size_t)(log->count - at) * sizeof entry);
        log->entries[at++] = entry;
        log->count++;
    }
}

static void list_entries(const Screen *screen, Log *log)
{
    *log = (Log){.count = 0};
    const bool both = screen_is_shared(screen);
    add_run(log, screen->experiment, both ? 'A' : '\0');
    if (both)
        add_run(log, screen_second_run(screen), 'B');
}

static int chosen_of(const LogPlace *place, const Log *log)
{
    return place->event < 0 || place->event >= log->count ? log->count - 1 : place->event;
}

int view_log_chosen(const Screen *screen)
{
    Log log;
    list_entries(screen, &log);
    return chosen_of(&screen->log, &log);
}

long view_log_step(const Screen *screen)
{
    Log log;
    list_entries(screen, &log);
    const int chosen = chosen_of(&screen->log, &log);
    if (chosen < 0)
        return -1;
    const LogEntry *entry = &log.entries[chosen];
    if (entry->run != 'B')
        return entry->event->step;
    /* the first step of A at which B has got there */
    const double steps = ceil(entry->time / experiment_simulation(screen->experiment)->dt - 1e-9);
    const long last = experiment_last_step(screen->experiment);
    return steps < (double)last ? (long)steps : last;
}

/* --- how much of it is seen ------------------------------------------------------------------------- */

/* Lines that an event takes behind its time. */
static int lines_of(const Log *log, int entry)
{
    const int lines = area_paragraph_lines(log->width, log->entries[entry].event->text);
    return lines > 1 ? lines : 1;
}

/* The first event with which the last one of these is seen too. */
static int first_with(const Log *log, int last)
{
    int first = last, lines = lines_of(log, last);
    while (first > 0 && lines + lines_of(log, first - 1) <= log->room)
        lines += lines_of(log, --first);
    return first;
}

/* As it was left, but so that the chosen event is seen and no row stays empty that could be used. */
static int first_of(const LogPlace *place, const Log *log)
{
    const int chosen = chosen_of(place, log), least = first_with(log, chosen),
              most = first_with(log, log->count - 1);
    int first = place->first > most ? most : place->first;
    first = first > chosen ? chosen : first;
    return first < least ? least : first;
}

static void open_log(const Screen *screen, int width, int height, Log *log)
{
    char time[48];
    list_entries(screen, log);
    for (int i = 0; i < log->count; i++) {
        entry_time(screen, &log->entries[i], time);
        log->columns = glyphs_columns(time) > log->columns ? glyphs_columns(time) : log->columns;
    }
    log->columns = log->columns < TIME_COLUMNS ? log->columns : TIME_COLUMNS;
    log->text = log->columns + 5 + (screen_is_shared(screen) ? 2 : 0);
    log->width = width - log->text - 1;
    log->room = height - 1 - (log->beyond > 0);
    log->first = log->count > 0 ? first_of(&screen->log, log) : 0;
}

static void draw(const Screen *screen, Area area, Style heading, int variant)
{
    (void)variant;
    Log log;
    char text[64], time[48];
    open_log(screen, area.rect.width, area.rect.height, &log);
    if (screen_is_shared(screen))
        snprintf(text, sizeof text, "what happened: %d event%s of A, %d of B", log.of_run[0],
                 log.of_run[0] == 1 ? "" : "s", log.of_run[1]);
    else
        snprintf(text, sizeof text, "what happened: %d event%s", log.count, log.count == 1 ? "" : "s");
    area_rule(area, 0, text, heading);
    if (log.count == 0)
        area_text(area, 1, 1, "nothing out of the ordinary so far", STYLE_FAINT);
    const int chosen = chosen_of(&screen->log, &log);
    for (int i = log.first, y = 1; i < log.count && y <= log.room; i++) {
        const LogEntry *entry = &log.entries[i];
        const bool marked = i == chosen && heading == STYLE_FOCUS;
        const int lines = lines_of(&log, i);
        entry_time(screen, entry, time);
        for (int row = 0; row < lines && marked && y + row <= log.room; row++)
            for (int x = 0; x < area.rect.width; x++)
                area_put(area, x, y + row, ' ', STYLE_SELECTED);
        if (marked)
            area_put(area, 0, y, '>', STYLE_SELECTED);
        area_text_right(area, 1 + log.columns, y, time, marked ? STYLE_SELECTED : STYLE_FAINT);
        area_put(area, log.text - 2, y, (uint32_t)pane_timeline_letter(entry->event->kind),
                 marked ? STYLE_SELECTED : style_of(entry->event));
        if (entry->run)
            area_put(area, log.text - 4, y, (uint32_t)entry->run,
                     marked              ? STYLE_SELECTED
                     : entry->run == 'B' ? STYLE_SECOND
                                         : STYLE_MEASURED);
        area_paragraph(area, log.text, y, log.width, log.room - y + 1, entry->event->text,
                       marked ? STYLE_SELECTED : style_of(entry->event));
        y += lines;
    }
    if (log.beyond > 0)
        area_print(area, 1, log.room + 1, STYLE_FAINT, "and %ld more crossings or breaks that are not kept",
                   log.beyond);
}

/* --- keys and mouse --------------------------------------------------------------------------------- */

/* False: there is nothing in it. */
static bool log_at(const Screen *screen, Rect rect, Log *log)
{
    if (rect.width <= 0)
        return false;
    open_log(screen, rect.width, rect.height, log);
    return log->count > 0;
}

/* At the end it follows the newest. */
static void choose(LogPlace *place, const Log *log, int to)
{
    place->event = to < 0 ? 0 : to >= log->count - 1 ? -1 : to;
    place->first = first_of(place, log);
}

static void move(Screen *screen, Rect rect, int x, int y, int page)
{
    Log log;
    (void)x;
    if (y == 0 || !log_at(screen, rect, &log))
        return;
    screen->log.first = log.first;
    choose(&screen->log, &log, chosen_of(&screen->log, &log) + y * page);
}

/* Where it happened is what one wants to look at. */
static long enter(Screen *screen)
{
    const long step = view_log_step(screen), broken = step >= 0 ? inspector_broken_node(screen, step) : -1;
    if (broken >= 0) {
        screen->chosen.particle = (size_t)broken;
        screen->chosen.is_node = false;
    }
    return step;
}

static bool holds(Rect rect, int x, int y)
{
    return x >= rect.x && x < rect.x + rect.width && y > rect.y && y < rect.y + rect.height;
}

static bool click(Screen *screen, Rect rect, int x, int y)
{
    Log log;
    if (!log_at(screen, rect, &log) || !holds(rect, x, y))
        return false;
    int at = log.first, end = rect.y + 1 + lines_of(&log, at);
    while (end <= y && ++at < log.count)
        end += lines_of(&log, at);
    screen->log.first = log.first;
    if (at < log.count)
        choose(&screen->log, &log, at);
    return true;
}

/* The chosen event is kept in sight. */
static bool scroll(Screen *screen, Rect rect, int x, int y, int by)
{
    Log log;
    if (!log_at(screen, rect, &log) || !holds(rect, x, y))
        return false;
    const int most = first_with(&log, log.count - 1), to = log.first + by;
    screen->log.first = to < 0 ? 0 : to > most ? most : to;
    int last = screen->log.first, lines = lines_of(&log, last);
    while (last + 1 < log.count && (lines += lines_of(&log, last + 1)) <= log.room)
        last++;
    const int chosen = chosen_of(&screen->log, &log);
    choose(&screen->log, &log,
           chosen < screen->log.first ? screen->log.first
           : chosen > last            ? last
                                      : chosen);
    return true;
}

const View view_log = {
    .word = "log",
    .brief = "log",
    .help = "what happened, in words; Enter goes there",
    .digit = 9,
    .home = PANE_LOWER,
    .draw = draw,
    .duel = DUEL_TOGETHER,
    .move = move,
    .enter = enter,
    .click = click,
    .scroll = scroll,
};

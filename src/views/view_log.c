/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What happened, in words, newest last, of both runs of a duel; one can choose an event and go to it. */
#include "run/event_log.h"
#include "panes/screen.h"
#include "views/view.h"

#include <math.h>
#include <string.h>

enum { LOG_MAX = 2 * EVENT_LOG_MAX };

typedef struct LogEntry {
    const Event *event;
    double time;
    char run; /* 'A', 'B'; 0: there is one */
} LogEntry;

typedef struct Log {
    LogEntry entries[LOG_MAX];
    int count, of_run[2];
    long beyond;
} Log;

/* What ends or endangers the run stands out: crossings and breaks come by the hundred. */
static const Style styles[EVENT_KINDS] = {[EVENT_FAILURE] = STYLE_ERROR,
                                          [EVENT_ADVICE] = STYLE_WARNING,
                                          [EVENT_ENERGY] = STYLE_WARNING,
                                          [EVENT_TEAR] = STYLE_WARNING};

static void add_run(Log *log, const Experiment *experiment, char run)
{
    const Simulation *sim = experiment_simulation(experiment);
    const Event *events = experiment_events(experiment, &log->of_run[run == 'B']);
    const int before = log->count;
    for (EventKind kind = 0; kind < EVENT_KINDS; kind++)
        log->beyond += sim->events_beyond.of[kind];
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

static void describe(const Screen *screen, int variant, Picture *picture)
{
    (void)variant;
    Log log = {.count = 0};
    const bool both = screen_is_shared(screen);
    add_run(&log, screen->experiment, both ? 'A' : '\0');
    if (both)
        add_run(&log, screen_second_run(screen), 'B');
    picture_heading(picture, both ? "what happened: %d event%s of A, %d of B" : "what happened: %d event%s",
                    log.of_run[0], log.of_run[0] == 1 ? "" : "s", log.of_run[1]);
    const LogPlace *place = &screen->log;
    /* until one is chosen it is the newest: the list goes on with the run */
    const int newest = log.count > 0 ? log.count - 1 : 0;
    const int chosen = place->event < 0 || place->event > newest ? newest : place->event;
    PictureList *list = picture_list(picture, -1, (size_t)log.count, (size_t)chosen, both ? 3 : 2);
    if (log.count == 0)
        picture_note(picture, STYLE_FAINT, "nothing out of the ordinary so far");
    if (log.beyond > 0)
        picture_note(picture, STYLE_FAINT, "and %ld more events that are not kept", log.beyond);
    if (!list)
        return;
    list->top = (size_t)place->first;
    list->columns[0].kind = list->columns[both].kind = LIST_SIGN;
    list->columns[both + 1].kind = LIST_WORDS;
    if (log.count > 0 && log.entries[chosen].run != 'B')
        picture->step = log.entries[chosen].event->step;
    else if (log.count > 0) {
        /* A's first step that is not before it: seen from there, it has happened */
        const double steps = ceil(log.entries[chosen].time / screen_simulation(screen)->dt - 1e-9);
        const long last = experiment_last_step(screen->experiment);
        picture->step = steps < (double)last ? (long)steps : last;
    }
    for (size_t i = 0; i < list->rows; i++) {
        const LogEntry *entry = &log.entries[i];
        const Style style = styles[entry->event->kind];
        strcpy(list->names[i], screen_time_text(screen, entry->time).text);
        *picture_cell(list, 0, i) =
            (PictureCell){.letter = entry->run, .style = entry->run == 'B' ? STYLE_SECOND : STYLE_MEASURED};
        *picture_cell(list, both, i) =
            (PictureCell){.letter = screen_event_letter(entry->event->kind)[0], .style = style};
        *picture_cell(list, both + 1, i) = (PictureCell){.words = entry->event->text, .style = style};
    }
}

const View view_log = {
    .word = "log",
    .help = "what happened, in words; Enter goes there",
    .digit = 9,
    .home = PANE_LOWER,
    .describe = describe,
    .is_list = true,
    .duel = DUEL_TOGETHER,
    .no_figure = true,
};

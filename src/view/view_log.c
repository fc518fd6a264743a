/* View 9: what happened, in words, newest last. */
#include "view/panes.h"

#include <stdio.h>

void view_log(const Screen *screen, Area area, Style heading, int variant)
{
    (void)variant;
    const Simulation *sim = experiment_simulation(screen->experiment);
    int count;
    const Event *events = experiment_events(screen->experiment, &count);
    char name[64];
    snprintf(name, sizeof name, "what happened: %d event%s", count, count == 1 ? "" : "s");
    area_rule(area, 0, name, heading);
    int room = area.rect.height - 1, y = 1;
    if (count == 0)
        area_text(area, 1, y, "nothing out of the ordinary so far", STYLE_FAINT);
    if (sim->events_beyond > 0)
        room--;
    int first = count - room - screen->table_scroll;
    for (int i = first > 0 ? first : 0; i < count && y <= room; i++, y++) {
        char time[48];
        time_text(screen, sim->dt * (double)events[i].step, time, sizeof time);
        int x = 1 + area_text(area, 1, y, time, STYLE_FAINT);
        const bool bad = events[i].kind == EVENT_FAILURE;
        area_text(area, x + 2, y, events[i].text, bad ? STYLE_ERROR : STYLE_NORMAL);
    }
    if (sim->events_beyond > 0)
        area_print(area, 1, y, STYLE_FAINT, "and %ld more that are not kept", sim->events_beyond);
}

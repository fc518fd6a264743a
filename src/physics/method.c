/* The driver that all methods share: stages, steps, snapshots, events. */
#include "physics/method.h"

#include "base/assertion.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool simulation_has(const Simulation *sim, unsigned what)
{
    return (sim->has & what) == what;
}

double simulation_time(const Simulation *sim)
{
    return (double)sim->step * sim->dt;
}

static bool may_go_on(const Simulation *sim, Status *status)
{
    if (!sim->failed)
        return true;
    if (status)
        *status = sim->failure;
    return false;
}

/* A piece of a stage, at most `items` of its things (0: all that are left). Stages are loops over ranges, so
 * a picture can be drawn, or a key answered, within a step of a large run; the bits do not depend on the
 * cuts. */
bool simulation_slice(Simulation *sim, size_t items, bool *stage_done, Status *status)
{
    *stage_done = false;
    ASSERT_INT(sim->stage, <, sim->n_stages);
    ASSERT_INT(sim->item, <, sim->stage_items);
    if (!may_go_on(sim, status))
        return false;
    size_t left = sim->stage_items - sim->item;
    size_t end = sim->item + (items == 0 || items > left ? left : items);
    if (!sim->method->stage(sim, sim->stage, sim->item, end, status))
        return false;
    if (end < sim->stage_items) {
        sim->item = end;
        return true;
    }
    sim->item = 0;
    *stage_done = true;
    if (++sim->stage == sim->n_stages) {
        sim->stage = 0;
        sim->step++;
    }
    return true;
}

bool simulation_stage(Simulation *sim, Status *status)
{
    bool stage_done;
    return simulation_slice(sim, 0, &stage_done, status);
}

/* As many steps as a hundredth of a second or so takes: how often a long run is asked whether it is still
 * wanted. */
long simulation_steps_a_question(const Simulation *sim)
{
    enum { ITEMS = 400000, STEPS_MAX = 4096 };
    size_t largest = 1;
    for (int set = 0; set < sim->n_sets; set++)
        largest = sim->counts[set] > largest ? sim->counts[set] : largest;
    const size_t steps = ITEMS / largest;
    return steps < 1 ? 1 : steps > STEPS_MAX ? STEPS_MAX : (long)steps;
}

/* Whole steps by the method's fast path where it has one; what has been begun stage by stage is finished
 * first. rows: the series after each step, n_series numbers apiece. On failure `done` says how many were
 * whole. */
bool simulation_steps(Simulation *sim, long count, double *rows, long *done, Status *status)
{
    ASSERT_INT(count, >=, 0);
    long counted = 0;
    long *total = done ? done : &counted;
    *total = 0;
    while (sim->stage != 0 || sim->item != 0)
        if (!simulation_stage(sim, status))
            return false;
    if (!may_go_on(sim, status))
        return false;
    if (sim->method->steps)
        return sim->method->steps(sim, count, rows, total, status);
    for (; *total < count; ++*total) {
        do {
            if (!simulation_stage(sim, status))
                return false;
        } while (sim->stage != 0);
        if (rows)
            sim->method->row(sim, rows + *total * sim->n_series);
    }
    return true;
}

void simulation_row(Simulation *sim, double *row)
{
    /* between steps only */
    ASSERT_INT(sim->stage, ==, 0);
    ASSERT_INT(sim->item, ==, 0);
    sim->method->row(sim, row);
}

/* A snapshot is this head and then the method's own bytes. */
typedef struct SnapshotHead {
    long step;
    int stage;
    int n_events;
    long events_beyond;
} SnapshotHead;

size_t simulation_snapshot_size(const Simulation *sim)
{
    return sizeof(SnapshotHead) + sim->method->state_size(sim);
}

void simulation_snapshot(const Simulation *sim, void *bytes)
{
    SnapshotHead head = {sim->step, sim->stage, sim->n_events, sim->events_beyond};
    memcpy(bytes, &head, sizeof head);
    sim->method->save(sim, (char *)bytes + sizeof head);
}

/* The run stands where it stood; of its events those are left that were known then. */
void simulation_restore(Simulation *sim, const void *bytes)
{
    SnapshotHead head;
    memcpy(&head, bytes, sizeof head);
    ASSERT_INT(head.n_events, <=, SIMULATION_EVENTS_MAX);
    sim->step = head.step;
    sim->stage = head.stage;
    sim->item = 0;
    sim->n_events = head.n_events;
    sim->events_beyond = head.events_beyond;
    sim->failed = false;
    sim->method->load(sim, (const char *)bytes + sizeof head);
}

void simulation_report(Simulation *sim, EventKind kind, const char *text)
{
    if (sim->n_events == SIMULATION_EVENTS_MAX) {
        sim->events_beyond++;
        return;
    }
    Event *event = &sim->events[sim->n_events++];
    event->step = sim->step;
    event->kind = kind;
    snprintf(event->text, sizeof event->text, "%s", text);
}

bool simulation_fail(Simulation *sim, Status *status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    sim->failed = true;
    sim->failure.code = STATUS_FAILED;
    vsnprintf(sim->failure.text, sizeof sim->failure.text, format, arguments);
    va_end(arguments);
    if (status)
        *status = sim->failure;
    return false;
}

int simulation_find_field(const Simulation *sim, int set, const char *name)
{
    for (int i = 0; i < sim->n_fields; i++)
        if (sim->fields[i].set == set && strcmp(sim->fields[i].quantity.name, name) == 0)
            return i;
    return -1;
}

double simulation_value(const Simulation *sim, int field, size_t index)
{
    double value = NAN;
    if (field >= 0)
        sim->method->field(sim, field, index, 1, &value);
    return value;
}

int simulation_find_series(const Simulation *sim, const char *name)
{
    for (int i = 0; i < sim->n_series; i++)
        if (strcmp(sim->series[i].name, name) == 0)
            return i;
    return -1;
}

int simulation_find_stage(const Simulation *sim, const char *id)
{
    for (int i = 0; i < sim->n_stages; i++)
        if (strcmp(sim->stages[i].id, id) == 0)
            return i;
    return -1;
}

void simulation_destroy(Simulation *sim)
{
    if (sim)
        sim->method->destroy(sim);
}

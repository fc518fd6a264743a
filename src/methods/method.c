/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The driver that all methods share: stages, steps, snapshots, events. */
#include "methods/method.h"
#include "base/text.h"

#include "base/assertion.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- things that are followed: their columns stand behind the method's, which knows nothing of them ---- */

typedef struct Follow Follow;
struct Follow {
    int own; /* columns of the method */
    int count;
    struct {
        int field;
        size_t index;
        char name[FOLLOW_TEXT_MAX], label[FOLLOW_TEXT_MAX], meaning[FOLLOW_TEXT_MAX];
    } things[FOLLOW_MAX];
    Quantity *series; /* all */
    void *present;    /* room for a snapshot, where what is followed is not ready between steps */
    int holders;      /* the simulation, and who else has its names */
};

struct Follow *simulation_hold_names(const Simulation *sim)
{
    if (sim->follow)
        sim->follow->holders++;
    return sim->follow;
}

void simulation_release_names(struct Follow *follow)
{
    if (!follow || --follow->holders > 0)
        return;
    free(follow->series);
    free(follow->present);
    free(follow);
}

static bool follow_steps(Simulation *, long count, double *rows, long *done, Status *);
static void follow_row(Simulation *, double *row);

/* --- steps --------------------------------------------------------------------------------------------- */

double simulation_carried(const Simulation *sim, int field)
{
    ASSERT_INDEX(field, sim->n_fields);
    return field < 0                       ? 0
           : field == sim->displacement[0] ? sim->common_speed * simulation_time(sim)
           : field == sim->velocity[0]     ? sim->common_speed
                                           : 0;
}

bool simulation_has(const Simulation *sim, unsigned what)
{
    return (sim->has & what) == what;
}

bool simulation_has_map(const Simulation *sim)
{
    return sim->has & (HAS_PLANE | HAS_BODIES);
}

double simulation_time(const Simulation *sim)
{
    return (double)sim->step * sim->dt;
}

static bool may_go_on(const Simulation *sim, Status *status)
{
    return !sim->failed || status_take(status, &sim->failure);
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
long simulation_steps_per_poll(const Simulation *sim)
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
    if (sim->follow)
        return follow_steps(sim, count, rows, total, status);
    if (sim->method->steps)
        return sim->method->steps(sim, count, rows, total, status);
    for (; *total < count && !sim->at_rest; ++*total) {
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
    if (sim->follow)
        follow_row(sim, row);
    else
        sim->method->row(sim, row);
}

/* A snapshot is this head and then the method's own bytes. */
typedef struct SnapshotHead {
    long step;
    int stage;
    int n_events;
    EventCounts events_beyond;
} SnapshotHead;

size_t simulation_snapshot_size(const Simulation *sim)
{
    return sizeof(SnapshotHead) + sim->method->state_size(sim);
}

void simulation_save(const Simulation *sim, void *bytes)
{
    memcpy(bytes, sim->state, sim->method->state_size(sim));
}

void simulation_snapshot(const Simulation *sim, void *bytes)
{
    SnapshotHead head = {sim->step, sim->stage, sim->n_events, sim->events_beyond};
    memcpy(bytes, &head, sizeof head);
    simulation_save(sim, (char *)bytes + sizeof head);
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

bool simulation_visit(Simulation *sim, const void *there, void (*look)(Simulation *, void *), void *context)
{
    void *present = malloc(simulation_snapshot_size(sim));
    if (!present)
        return false;
    simulation_snapshot(sim, present);
    if (there)
        simulation_restore(sim, there);
    if (look)
        look(sim, context);
    simulation_restore(sim, present);
    free(present);
    return true;
}

/* What is seen of a step ahead; `row` has room for one of the series. */
typedef struct StepAhead {
    double *before, *after, *strain, *row;
    bool done;
} StepAhead;

static void see_state(Simulation *sim, double *velocity, double *strain, double *row)
{
    simulation_row(sim, row);
    *strain = row[simulation_find_series(sim, "strain")];
    for (int d = 0; d < sim->dimensions; d++)
        sim->method->field(sim, sim->velocity[d], 0, sim->counts[0], velocity + (size_t)d * sim->counts[0]);
}

static void step_and_see(Simulation *sim, void *context)
{
    StepAhead *ahead = context;
    see_state(sim, ahead->before, &ahead->strain[0], ahead->row);
    ahead->done = simulation_steps(sim, 1, NULL, NULL, NULL);
    if (ahead->done)
        see_state(sim, ahead->after, &ahead->strain[1], ahead->row);
}

bool simulation_step_ahead(Simulation *sim, double *before, double *after, double strain[2])
{
    ASSERT_INT(sim->stage, ==, 0);
    ASSERT_INT(simulation_find_series(sim, "strain"), >=, 0);
    double *row = malloc((size_t)sim->n_series * sizeof *row);
    StepAhead ahead = {before, after, strain, row, false};
    const bool seen = row && simulation_visit(sim, NULL, step_and_see, &ahead);
    free(row);
    return seen && ahead.done;
}

void simulation_make_ready(Simulation *sim, int set)
{
    ASSERT_INDEX(set, sim->n_sets);
    for (int i = 0; i < sim->sets[set].ready_after && simulation_stage(sim, NULL); i++)
        ;
}

bool simulation_make_stage(Simulation *sim, int stage, void **before)
{
    ASSERT_INDEX(stage, sim->n_stages);
    ASSERT_INT(sim->stage, ==, 0);
    *before = NULL;
    for (int i = 0; i < stage; i++)
        if (!simulation_stage(sim, NULL))
            return false;
    *before = malloc(sim->method->state_size(sim));
    if (*before)
        simulation_save(sim, *before);
    return simulation_stage(sim, NULL);
}

bool simulation_forget_failure(Simulation *sim)
{
    return simulation_visit(sim, NULL, NULL, NULL);
}

void simulation_report(Simulation *sim, EventKind kind, const char *text)
{
    if (sim->n_events == SIMULATION_EVENTS_MAX) {
        sim->events_beyond.of[kind]++;
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
    return status_take(status, &sim->failure);
}

void simulation_lay(Simulation *sim, size_t columns, size_t rows, double spacing, int dimensions)
{
    static const char *const line[][3] = {{"x0", "u", "v"}}, *const plane[][3] = {{"x0", "ux", "vx"},
                                                                                  {"y0", "uy", "vy"}};
    const char *const(*const names)[3] = dimensions == 1 ? line : plane;
    ASSERT_INT(dimensions, <=, SIMULATION_DIMENSIONS_MAX);
    sim->columns = columns;
    sim->rows = rows;
    sim->spacing = spacing;
    sim->dimensions = dimensions;
    for (int d = 0; d < SIMULATION_DIMENSIONS_MAX; d++) {
        sim->position[d] = d < dimensions ? simulation_find_field(sim, 0, names[d][0]) : -1;
        sim->displacement[d] = d < dimensions ? simulation_find_field(sim, 0, names[d][1]) : -1;
        sim->velocity[d] = d < dimensions ? simulation_find_field(sim, 0, names[d][2]) : -1;
        ASSERT(d >= dimensions ||
               (sim->position[d] >= 0 && sim->displacement[d] >= 0 && sim->velocity[d] >= 0));
    }
}

void simulation_add_column(Simulation *sim, int entry, Quantity quantity)
{
    ASSERT_INDEX(sim->n_series, SIMULATION_SERIES_MAX);
    sim->series = sim->series_own;
    sim->series_entry[sim->n_series] = entry;
    sim->series_own[sim->n_series++] = quantity;
}

int simulation_find_field(const Simulation *sim, int set, const char *name)
{
    ASSERT_INDEX(set, sim->n_sets);
    for (int i = 0; i < sim->n_fields; i++)
        if (sim->fields[i].set == set && strcmp(sim->fields[i].quantity.name, name) == 0)
            return i;
    return -1;
}

double simulation_value(const Simulation *sim, int field, size_t index)
{
    ASSERT_INT(field, <, sim->n_fields);
    ASSERT(field < 0 || index < sim->counts[sim->fields[field].set]);
    double value = NAN;
    if (field >= 0)
        sim->method->field(sim, field, index, 1, &value);
    return value;
}

double simulation_named(const Simulation *sim, int set, const char *name, size_t index)
{
    return simulation_value(sim, simulation_find_field(sim, set, name), index);
}

bool stage_when(unsigned when, unsigned run, const unsigned *groups)
{
    for (; *groups; groups++)
        if ((when & *groups) && !(when & *groups & run))
            return false;
    return true;
}

Stage stage_words(const StageWords *rows, size_t count, int stage, unsigned run, const unsigned *groups)
{
    Stage words = {0};
    const char **const members[] = {&words.id,       &words.name,  &words.equation, &words.source,
                                    &words.sentence, &words.reads, &words.writes};
    for (const StageWords *row = rows; row < rows + count; row++) {
        const Stage *own = &row->words;
        const char *const others[] = {own->id,       own->name,  own->equation, own->source,
                                      own->sentence, own->reads, own->writes};
        for (size_t k = 0;
             row->stage == stage && stage_when(row->when, run, groups) && k < sizeof others / sizeof *others;
             k++)
            *members[k] = others[k] ? others[k] : *members[k];
    }
    return words;
}

static int by_pull(const void *a, const void *b)
{
    const Link *one = a, *other = b;
    if (one->broken != other->broken)
        return one->broken ? 1 : -1;
    const double left = fabs(link_pull(one)), right = fabs(link_pull(other));
    return left != right ? (left < right) - (left > right)
                         : (one->index > other->index) - (one->index < other->index);
}

void simulation_sort_links(Link *links, size_t count)
{
    qsort(links, count, sizeof *links, by_pull);
}

ExchangeTerm simulation_exchange(const Simulation *sim, int exchange, size_t index, const Link *link)
{
    ASSERT_INDEX(exchange, sim->n_exchanges);
    ExchangeTerm term = {0};
    term.count = sim->method->exchange(sim, exchange, index, link, term.factors);
    term.product = term.count > 0;
    for (int f = 0; f < term.count; f++)
        term.product *= term.factors[f];
    return term;
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
        simulation_release_names(sim->follow);
    if (sim)
        sim->method->destroy(sim);
}

/* --- what is followed ---------------------------------------------------------------------------------- */

static bool same_words(const char *a, const char *b)
{
    while (*a && tolower((unsigned char)*a) == tolower((unsigned char)*b))
        a++, b++;
    return !*a && !*b;
}

/* "particle 12 velocity": a set, a number, and a field's name or label. */
static bool find_thing(const Simulation *sim, const char *thing, int *field, size_t *index, Status *status)
{
    char word[16] = "", known[256] = "";
    unsigned long number = 0;
    int end = 0, set = 0;
    int digits = 0; /* %lu would take a sign */
    const bool whole = sscanf(thing, "%15s %n%9lu %n", word, &digits, &number, &end) == 2 && end > 0 &&
                       thing[end] && isdigit((unsigned char)thing[digits]);
    while (set < sim->n_sets && strcmp(sim->sets[set].name, word) != 0)
        set++;
    if (!whole || set == sim->n_sets)
        return status_refuse(status, "\"%.60s\" is nothing to follow (%s NUMBER FIELD, as in %s 0 %s)", thing,
                             sim->sets[0].name, sim->sets[0].name, sim->fields[0].quantity.name);
    if (number >= sim->counts[set])
        return status_refuse(status, "there is no %s %lu (0 to %zu)", word, number, sim->counts[set] - 1);
    *index = number;
    *field = simulation_find_field(sim, set, thing + end);
    for (int i = 0; i < sim->n_fields && *field < 0; i++) {
        if (sim->fields[i].set == set && same_words(sim->fields[i].quantity.label, thing + end))
            *field = i;
        else if (sim->fields[i].set == set)
            text_or(known, sizeof known, sim->fields[i].quantity.name);
    }
    return *field >= 0 || status_refuse(status, "%.40s is not a field of a %s (%s)", thing + end,
                                        sim->sets[set].name, known);
}

bool simulation_asks(const char *names, const char *column)
{
    const size_t length = strlen(column);
    for (const char *at = names + strspn(names, ", "); *at; at += strspn(at, ", ")) {
        const size_t n = strcspn(at, ", ");
        if ((n == length && memcmp(at, column, n) == 0) || (n == 3 && memcmp(at, "all", 3) == 0))
            return true;
        at += n;
    }
    return false;
}

bool simulation_is_on_request(const Simulation *sim, const char *column)
{
    const char *part = strchr(column, '.');
    const char *const *names = sim->method->on_request;
    return text_place_in(column, names) >= 0 || (part && text_place_in(part, names) >= 0);
}

void simulation_ask_columns(Simulation *sim, const char *names)
{
    ASSERT(!sim->follow);
    ASSERT_INT(sim->step, ==, 0);
    int count = 0;
    for (int i = 0; i < sim->n_series; i++) {
        if (simulation_is_on_request(sim, sim->series[i].name) &&
            !simulation_asks(names, sim->series[i].name))
            continue;
        const Quantity quantity = sim->series_own[count];
        sim->series_own[count] = sim->series_own[i];
        sim->series_own[i] = quantity;
        sim->series_entry[count++] = sim->series_entry[i];
    }
    sim->n_askable = sim->series == sim->series_own ? sim->n_series : 0;
    sim->n_series = count;
}

bool simulation_follow(Simulation *sim, const char *thing, Status *status)
{
    int field = -1;
    size_t index = 0;
    if (!find_thing(sim, thing, &field, &index, status))
        return false;
    Follow *follow = sim->follow ? sim->follow : calloc(1, sizeof *follow);
    if (!follow || (!sim->follow &&
                    !(follow->series = calloc((size_t)sim->n_series + FOLLOW_MAX, sizeof *follow->series)))) {
        free(follow);
        return status_fail(status, "not enough memory to follow a thing");
    }
    if (!sim->follow) {
        memcpy(follow->series, sim->series, (size_t)sim->n_series * sizeof *sim->series);
        follow->own = sim->n_series;
        follow->holders = 1;
        sim->follow = follow;
        sim->series = follow->series;
    }
    if (follow->count == FOLLOW_MAX)
        return status_refuse(status, "too many things are followed (at most %d)", FOLLOW_MAX);
    const Field *row = &sim->fields[field];
    if (sim->sets[row->set].ready_after > 0 && !follow->present &&
        !(follow->present = malloc(simulation_snapshot_size(sim))))
        return status_fail(status, "not enough memory to follow a thing");
    const char *set = sim->sets[row->set].name;
    char name[FOLLOW_TEXT_MAX];
    snprintf(name, sizeof name, "%s_%zu_%s", set, index, row->quantity.name);
    if (simulation_find_series(sim, name) >= 0)
        return status_refuse(status, "%s is followed twice (once)", thing);
    const int i = follow->count++;
    follow->things[i].field = field;
    follow->things[i].index = index;
    memcpy(follow->things[i].name, name, sizeof name);
    snprintf(follow->things[i].label, FOLLOW_TEXT_MAX, "%s of %s %zu", row->quantity.label, set, index);
    snprintf(follow->things[i].meaning, FOLLOW_TEXT_MAX, "%s %zu: %.40s", set, index, row->quantity.meaning);
    follow->series[sim->n_series++] = (Quantity){follow->things[i].name, follow->things[i].label,
                                                 row->quantity.unit, follow->things[i].meaning};
    return true;
}

/* The method sees its own columns only, for it may go by their number. A thing's value is that where its
 * field is ready: now, or after some stages of a step that is then taken back. */
static void follow_row(Simulation *sim, double *row)
{
    const Follow *follow = sim->follow;
    const int all = sim->n_series;
    sim->n_series = follow->own;
    sim->method->row(sim, row);
    sim->n_series = all;
    for (int i = 0; i < follow->count; i++) {
        const int set = sim->fields[follow->things[i].field].set;
        const bool ahead = sim->sets[set].ready_after > 0;
        if (ahead)
            simulation_snapshot(sim, follow->present);
        simulation_make_ready(sim, set); /* a run that fails there will do so by itself, in its own time */
        row[follow->own + i] = simulation_value(sim, follow->things[i].field, follow->things[i].index);
        if (ahead)
            simulation_restore(sim, follow->present);
    }
}

static bool follow_steps(Simulation *sim, long count, double *rows, long *done, Status *status)
{
    Follow *follow = sim->follow;
    for (*done = 0; *done < count && !sim->at_rest; ++*done) {
        long one;
        sim->follow = NULL; /* a step as ever */
        const bool sound = simulation_steps(sim, 1, NULL, &one, status);
        sim->follow = follow;
        if (!sound)
            return false;
        if (rows)
            follow_row(sim, rows + *done * sim->n_series);
    }
    return true;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What panes and views ask of the runs on screen: which ones there are, what is known of them, how far their
 * fields reach, and their times and units as text. */
#include "panes/screen.h"

#include "base/math/functions.h"
#include "base/text.h"
#include "run/duel.h"
#include "run/playback.h"
#include "scenario/concern_time.h"
#include "scenario/parameters.h"
#include "scenario/settings.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What follows from the screen at once. */
#define READ(Type, name, what)                                                                               \
    Type name(const Screen *screen)                                                                          \
    {                                                                                                        \
        return what;                                                                                         \
    }
READ(const Experiment *, screen_second_run, screen->duel ? screen->duel->b : NULL)
READ(bool, screen_is_shared, screen_second_run(screen) && screen->side == SIDE_BOTH)
READ(const Experiment *, screen_clock_run, screen_second_run(screen) ? screen->duel->a : screen->experiment)
READ(bool, screen_shows_exact, screen->views.references == SHOW_ALL || screen->views.references == SHOW_EXACT)
READ(bool, screen_shows_predicted,
     screen->views.references == SHOW_ALL || screen->views.references == SHOW_PREDICTED)
READ(bool, screen_is_running, screen->playback->state == STATE_RUNNING)
READ(bool, screen_is_inside,
     experiment_stage(screen->experiment) > 0 || experiment_before(screen->experiment) != NULL)
READ(bool, screen_is_rewound, experiment_newest(screen->experiment) > experiment_step(screen->experiment))
READ(bool, screen_is_plain, screen->panes.lecture || screen->panes.sheet == SHEET_PLAIN)
READ(const Problem *, screen_problem, screen_settings(screen)->problem)

Screen screen_of_side(const Screen *screen, DuelSide side)
{
    Screen one = *screen;
    one.side = side;
    one.experiment = side == SIDE_B ? screen->duel->b : screen->duel->a;
    return one;
}

bool screen_question(const Screen *screen, char *out, size_t size)
{
    enum { ROOM = 24 };
    Settings tried = *screen_settings(screen);
    const Parameter *parameter = settings_question(&tried);
    char value[LIST_MAX], name[48];
    if (!parameter || !settings_answer_otherwise(&tried, parameter))
        return false;
    settings_show(&tried, parameter, value);
    parameter_name_alone(parameter, name, sizeof name);
    const bool fits = strlen(name) + strlen(value) < ROOM; /* on the smallest screen */
    snprintf(out, size, "%s %.60s", fits ? name : parameter->label, value);
    return true;
}

ScreenText screen_time_text(const Screen *screen, double time)
{
    ScreenText out;
    const Problem *facts = screen_problem(screen);
    const double unit = facts->shown_time, dt = screen_simulation(screen)->dt / unit;
    int decimals = dt > 0 ? (int)ceil(-math_log10(dt) - 1e-9) : 2;
    decimals = decimals < 0 ? 0 : decimals > 6 ? 6 : decimals;
    snprintf(out.text, sizeof out.text, "t %.*f%s", decimals, time / unit, facts->shown_time_unit);
    return out;
}

double screen_derived(const Screen *screen, const char *name)
{
    Derived derived[DERIVED_MAX];
    const int count = experiment_derived(screen->experiment, derived);
    return derived_named(derived, count, name);
}

int screen_box_stage(const Screen *screen, bool *done)
{
    const Simulation *sim = screen_simulation(screen);
    int stage = experiment_stage(screen->experiment);
    *done = true;
    if (stage > 0)
        return stage - 1;
    if (experiment_before(screen->experiment))
        return sim->n_stages - 1;
    *done = false;
    return 0;
}

double screen_node_values(const Screen *screen, const char *name, bool before, double *out)
{
    const Simulation *sim = screen_simulation(screen);
    const int field = simulation_find_field(sim, 1, name);
    const size_t count = sim->counts[1];
    double most = 0;
    if (field < 0)
        return -1;
    if (!before || !experiment_field_before(screen->experiment, field, 0, count, out))
        sim->method->field(sim, field, 0, count, out);
    for (size_t i = 0; i < count; i++)
        most = fmax(most, fabs(out[i]));
    return most;
}

static double reach_of(const Experiment *experiment, int field, const double *now, size_t count)
{
    enum { TIMES = 24, PLACES = 8, PARTS = 4 }; /* parts: none waits for the one before */
    const Simulation *sim = experiment_simulation(experiment);
    const References *refs = experiment_references(experiment);
    const Readout *readout = experiment_readout(experiment);
    const char *name = sim->fields[field].quantity.name;
    double reach = 0, length = 0, parts[PARTS] = {0};
    for (size_t i = 0; i < count; i++) {
        double *most = &parts[i % PARTS];
        *most = fabs(now[i]) > *most ? fabs(now[i]) : *most;
    }
    for (int part = 0; part < PARTS; part++)
        reach = fmax(reach, parts[part]);
    if (count > 0)
        sim->method->field(sim, sim->position[0], count - 1, 1, &length);
    const double span = readout->nominal_period > 0 && !readout->drifting
                            ? readout->nominal_period
                            : settings_time(experiment_settings(experiment))->end;
    for (int i = 0; i <= TIMES; i++)
        for (int k = 1; k <= PLACES; k++) {
            double value = fabs(references_profile(refs, name, length * k / PLACES, span * i / TIMES));
            if (isfinite(value))
                reach = fmax(reach, value);
        }
    return isfinite(reach) ? reach : 0;
}

const Experiment *screen_other_run(const Screen *screen)
{
    const Experiment *second = screen_second_run(screen);
    return second && screen->experiment == second ? screen->duel->a : second;
}

/* Two runs are compared by one scale. */
double screen_field_reach(const Screen *screen, int field, const double *now, size_t count)
{
    double reach = reach_of(screen->experiment, field, now, count);
    const Experiment *other = screen_other_run(screen);
    if (!other)
        return reach;
    const Simulation *sim = experiment_simulation(other);
    const char *name = screen_simulation(screen)->fields[field].quantity.name;
    const int same = simulation_find_field(sim, 0, name);
    const size_t others = sim->counts[0];
    double *values = same >= 0 ? malloc((others + 1) * sizeof *values) : NULL;
    if (values) {
        sim->method->field(sim, same, 0, others, values);
        reach = fmax(reach, reach_of(other, same, values, others));
    }
    free(values);
    return reach;
}

ScreenText screen_unit_text(const Screen *screen, const Field *field)
{
    ScreenText out;
    const char *unit = field->quantity.unit;
    const bool none = !screen_problem(screen)->si || strcmp(unit, "1") == 0;
    snprintf(out.text, sizeof out.text, "%s%s", none ? "" : " ", none ? "" : unit);
    return out;
}

const EventMark screen_marks[SCREEN_MARKS] = {
    {EVENT_CROSSING, "x", STYLE_NORMAL, "crossing"}, {EVENT_BREAK, "b", STYLE_NORMAL, "break"},
    {EVENT_TOUCH, "t", STYLE_NORMAL, "touch"},       {EVENT_PART, "p", STYLE_NORMAL, "parting"},
    {EVENT_TEAR, "T", STYLE_WARNING, "torn"},        {EVENT_LATE, "L", STYLE_NORMAL, "lag"},
    {EVENT_ENERGY, "E", STYLE_WARNING, "energy"},    {EVENT_CHANGE, "c", STYLE_CHANGED, "change"},
    {EVENT_REST, "R", STYLE_NORMAL, "rest"},         {EVENT_FAILURE, "!", STYLE_ERROR, "stopped"},
};

const char *screen_event_letter(EventKind kind)
{
    for (int i = 0; i < SCREEN_MARKS; i++)
        if (screen_marks[i].kind == kind)
            return screen_marks[i].letter;
    return " ";
}

/* --- what a stage hands on ------------------------------------------------------------------------ */

/* How many of the names only this set has. */
static int own_names(const Simulation *sim, const char *words, int set)
{
    char word[64];
    int count = 0;
    while (text_next_word(&words, word, sizeof word))
        count += simulation_find_field(sim, set, word) >= 0 && simulation_find_field(sim, 1 - set, word) < 0;
    return count;
}

int flow_target(const Simulation *sim, const Stage *stage)
{
    if (!simulation_has(sim, HAS_MESH))
        return 0;
    const int particles = own_names(sim, stage->writes, 0), nodes = own_names(sim, stage->writes, 1);
    if (particles != nodes)
        return nodes > particles;
    /* only shared names: what it reads of the one it writes to the other */
    return own_names(sim, stage->reads, 0) > 0;
}

Flow flow_of_stage(const Screen *screen, bool *inside)
{
    const Simulation *sim = screen_simulation(screen);
    const Stage *stage = &sim->stages[screen_box_stage(screen, inside)];
    *inside = *inside && !screen_is_running(screen);
    if (!*inside || !simulation_has(sim, HAS_MESH))
        return FLOW_NONE;
    if (strcmp(stage->id, "forget") == 0)
        return FLOW_FORGET;
    for (int i = 0; i < sim->n_exchanges; i++)
        if (strcmp(sim->exchanges[i].stage, stage->id) == 0)
            return sim->exchanges[i].to == 1 ? FLOW_TO_NODES : FLOW_TO_PARTICLES;
    return FLOW_NONE;
}

/* --- what is chosen ------------------------------------------------------------------------------- */

void selection_next(Selection *selection, const Simulation *sim, int direction, size_t by)
{
    const bool node = selection->is_node && sim->n_sets > 1;
    size_t *chosen = node ? &selection->node : &selection->particle;
    const size_t count = sim->counts[node ? 1 : 0];
    if (count == 0)
        return;
    const size_t from = *chosen < count ? *chosen : count - 1; /* a finer mesh had it */
    if (direction < 0)
        *chosen = from > by ? from - by : 0;
    else
        *chosen = from + by < count ? from + by : count - 1;
}

size_t selection_middle(const Simulation *sim)
{
    return sim->columns > 0 ? sim->rows / 2 * sim->columns + sim->columns / 2 : sim->counts[0] / 2;
}

const View *screen_view_in(const Screen *screen, PaneId pane)
{
    return pane == PANE_UPPER ? screen->views.upper : pane == PANE_LOWER ? screen->views.lower : NULL;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bar by peridynamics: its memory, its start, its state as bytes, and the table of functions through
 * which a driver runs it (method.h). The state is one block: head, u with its mirrored nodes, v, f. */
#include "base/assertion.h"
#include "methods/bonds/line/pd_bar_internal.h"
#include "methods/axial.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- the state as bytes --------------------------------------------------------------------------- */

static size_t state_size(const Simulation *sim)
{
    return ((const PdBar *)sim)->state_size;
}

/* What the code of the state does; loads and mistakes word its stages. */
static void follow_state(PdBar *bar)
{
    bar->mistake = bonds_mistake_of(bar->head->mistake, bar->def.mistake_beside, &bar->both);
    pd_bar_set_stages(bar);
}

static void load(Simulation *sim, const void *bytes)
{
    PdBar *bar = (PdBar *)sim;
    memcpy(bar->head, bytes, bar->state_size);
    follow_state(bar);
}

static bool check_mistake(const PdBarDef *, Status *);

static bool change_mistake(PdBar *bar, double value, Status *status)
{
    PdBarDef def = bar->def;
    def.mistake = value >= 0 && value == floor(value) && value < INT_MAX ? (int)value : -1;
    if (!check_mistake(&def, status) ||
        !bonds_mistake_may_change(bar->head->mistake, def.mistake, def.conceals_mistake, status))
        return false;
    bar->head->mistake = def.mistake;
    follow_state(bar);
    return true;
}

static bool change(Simulation *sim, const char *key, double value, Status *status)
{
    PdBar *bar = (PdBar *)sim;
    ASSERT_INT(sim->stage, ==, 0);
    double *live = strcmp(key, "load.body_force") == 0 ? &bar->head->body_force
                   : strcmp(key, "load.traction") == 0 ? &bar->head->traction
                                                       : NULL;
    if (strcmp(key, "pd.mistake") == 0)
        return change_mistake(bar, value, status);
    if (!live)
        return status_refuse(
            status, "%s: cannot change in mid-run (load.body_force, load.traction and pd.mistake can)", key);
    if (!isfinite(value))
        return status_refuse(status, "%s: %g is not allowed (a number)", key, value);
    *live = value;
    follow_state(bar);
    if (!mistake_does(bar->mistake, BONDS_WRONG_FORCE_STAYS)) /* which would add it once more */
        pd_bar_forces(bar); /* the coming half kick takes the force of the new load */
    return true;
}

static void destroy(Simulation *sim)
{
    PdBar *bar = (PdBar *)sim;
    free(bar->memory);
    free(bar->head);
    free(bar->backup);
    free(bar);
}

static const char *const on_request[] = {"momentum", "reaction", NULL};

static const Method method = {
    .name = "pd",
    .title = "bond-based peridynamics",
    .destroy = destroy,
    .stage = pd_bar_stage,
    .steps = pd_bar_steps,
    .row = pd_bar_row,
    .on_request = on_request,
    .field = pd_bar_field,
    .links = pd_bar_links,
    .explain = pd_bar_explain,
    .state_size = state_size,
    .load = load,
    .change = change,
};

/* --- a new one ------------------------------------------------------------------------------------ */

/* The state is one block: head, u of n + 2 reach nodes (mirrored ones at both sides), v and f of n. */
static bool lay_out(PdBar *bar)
{
    bar->memory = pd_bar_lattice(&bar->def, &bar->lattice);
    if (!bar->memory)
        return false;
    const size_t n = (size_t)bar->lattice.n, padded = bar->lattice.padded;
    bar->state_size = sizeof(PdBarHead) + (padded + 2 * n) * sizeof(double);
    bar->head = calloc(1, bar->state_size);
    bar->backup = malloc(bar->state_size);
    if (!bar->head || !bar->backup)
        return false;
    bar->sim.state = bar->head;
    bar->u = (double *)(bar->head + 1);
    bar->v = bar->u + padded;
    bar->f = bar->v + n;
    return true;
}

enum { NODES_A_QUESTION = 16384 };

/* u = 0, v from the definition, and the force that the first half kick takes. */
static bool begin(PdBar *bar, Status *status)
{
    const PdBarDef *def = &bar->def;
    bar->head->body_force = def->body_force;
    bar->head->traction = def->traction;
    bar->head->mistake = def->mistake;
    follow_state(bar);
    for (int i = 0; i < bar->lattice.n && def->initial_velocity; i++) {
        if (i % NODES_A_QUESTION == 0 && cancel_requested(&def->cancel, (double)i / bar->lattice.n))
            return status_fail(status, "the building of the bar was cancelled");
        double x = pd_bar_position(&bar->lattice, i);
        bar->v[i] = def->initial_velocity(x, def->initial_context);
        if (!isfinite(bar->v[i]))
            return status_refuse(status, "initial.velocity: no finite number at x = %g", x);
    }
    pd_bar_forces(bar);
    return true;
}

Simulation *pd_bar_create(const PdBarDef *def, Status *status)
{
    double critical;
    if (!pd_bar_critical(def, &critical, status))
        return NULL;
    PdBar *bar = calloc(1, sizeof *bar);
    if (!bar) {
        status_fail(status, "not enough memory for the bar");
        return NULL;
    }
    bar->def = *def;
    bar->critical_step = critical;
    Simulation *sim = &bar->sim;
    sim->method = &method;
    sim->dt = def->dt;
    if (!lay_out(bar)) {
        status_fail(status, "not enough memory for the lattice of the bar");
        destroy(sim);
        return NULL;
    }
    sim->stage_items = (size_t)bar->lattice.n;
    pd_bar_set_fields(bar);
    if (!begin(bar, status)) {
        destroy(sim);
        return NULL;
    }
    return sim;
}

/* Whether the definition of a bar by peridynamics is sound: every number by itself, then what has to fit
 * together. */

typedef struct Bound {
    const char *key;
    double value;
    bool positive; /* else: any number */
} Bound;

static bool check_numbers(const PdBarDef *def, Status *status)
{
    const Bound bounds[] = {
        {"bar.length", def->length, true},       {"bar.youngs_modulus", def->youngs_modulus, true},
        {"bar.density", def->density, true},     {"pd.spacing", def->spacing, true},
        {"pd.horizon", def->horizon, true},      {"load.body_force", def->body_force, false},
        {"load.traction", def->traction, false}, {"time.courant", def->dt, true},
    };
    for (size_t k = 0; k < sizeof bounds / sizeof *bounds; k++)
        if (!isfinite(bounds[k].value) || (bounds[k].positive && !(bounds[k].value > 0)))
            return status_refuse(status, "%s: %g is not allowed (%s)", bounds[k].key, bounds[k].value,
                                 bounds[k].positive ? "greater than 0" : "a number");
    return true;
}

static bool check_mistake(const PdBarDef *def, Status *status)
{
    const BeamDef alike = {.spacing = def->spacing,
                           .horizon = def->horizon,
                           .volume_correction = def->volume_correction,
                           .influence = def->influence,
                           .stepping = def->stepping,
                           .mistake = def->mistake,
                           .mistake_beside = def->mistake_beside,
                           .conceals_mistake = def->conceals_mistake};
    BondsMistake both;
    if (!bonds_check_mistake(&alike, status))
        return false;
    const BondsMistake *mistake = bonds_mistake_of(def->mistake, def->mistake_beside, &both);
    return !mistake_does(mistake, BONDS_WRONG_IN_PLANE) ||
           status_refuse(status, "pd.mistake: %s is defined for beams and plates only",
                         def->conceals_mistake ? "?" : mistake->id);
}

bool pd_bar_check(const PdBarDef *def, Status *status)
{
    enum { NODES_MAX = 2000000 }; /* of 64 bytes with the least horizon, 248 with the largest */
    if (!check_numbers(def, status))
        return false;
    const double nodes = def->length / def->spacing, ratio = def->horizon / def->spacing;
    if (!(fabs(nodes - round(nodes)) <= 1e-6 * fmax(1, nodes) && nodes >= 0.5 && nodes <= NODES_MAX))
        return status_refuse(status,
                             "pd.spacing: the length %g is %g spacings of %g (a whole number, at most %d)",
                             def->length, nodes, def->spacing, NODES_MAX);
    if (ratio < 1 - 1e-9)
        return status_refuse(status, "pd.horizon: %g is below the spacing (at least pd.spacing = %g)",
                             def->horizon, def->spacing);
    if (ratio > PD_BAR_REACH_MAX * (1 + 1e-9))
        return status_refuse(status, "pd.horizon: %g is %.4g spacings (at most %d times pd.spacing)",
                             def->horizon, ratio, PD_BAR_REACH_MAX);
    if (def->influence == INFLUENCE_CONICAL && ratio < 1.5)
        return status_refuse(
            status,
            "pd.influence: conical leaves bonds as long as the horizon nothing, and pd.horizon "
            "is %.3g spacings (at least 1.5, or constant)",
            ratio);
    if (def->horizon > def->length * (1 + 1e-9))
        return status_refuse(status, "pd.horizon: %g reaches beyond the whole bar (at most bar.length = %g)",
                             def->horizon, def->length);
    if (def->surface_correction == SURFACE_VOLUME)
        return status_refuse(status, "pd.surface_correction: volume is for beams (on a bar: none | energy)");
    return check_mistake(def, status) &&
           axial_check_layer(def->traction_layer, def->spacing, def->length, status);
}

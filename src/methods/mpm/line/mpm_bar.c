/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A bar by the material point method is made, copied out, put back and changed. The state is one block of
 * arrays; a snapshot between steps is its first part, the particles, in the middle of a step all of it. At t
 * = 0 particles stand at s = (j + 1/2 + offset)/P in their cells, with stress 0, volume m/rho and the
 * velocity of eq. 19; m = rho dx/P, dt by eq. 21. */
#include "base/assertion.h"
#include "methods/axial.h"
#include "methods/mpm/line/bar_mistakes.h"
#include "methods/mpm/line/bar_state.h"
#include "methods/mpm/line/kernels/bar_kernels.h"
#include "methods/mpm/line/kernels/shape.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- memory --------------------------------------------------------------------------------------- */

/* Arrays of one block, placed so that no two begin at the same distance from a multiple of 4096 bytes:
 * processors take a load for dependent on an earlier store when these agree. */
typedef struct Layout {
    size_t size;
    bool taken[64]; /* 64-byte lines of a page on which an array begins, or next to one that does */
    int free;
} Layout;

static size_t place(Layout *layout, size_t bytes)
{
    size_t offset = (layout->size + 63) / 64 * 64;
    if (layout->free == 0) {
        memset(layout->taken, 0, sizeof layout->taken);
        layout->free = 64;
    }
    while (layout->taken[offset / 64 % 64])
        offset += 64;
    size_t line = offset / 64 % 64;
    for (size_t i = line + 63; i <= line + 65; i++) {
        layout->free -= !layout->taken[i % 64];
        layout->taken[i % 64] = true;
    }
    layout->size = offset + bytes;
    return offset;
}

/* Where each array of a bar stands in the state block; called twice: to measure, then to set pointers. */
static void lay_out(Bar *bar, unsigned char *block)
{
    Layout layout = {.size = 0, .free = 64};
    const size_t places = (size_t)bar->places * sizeof(double), nodes = (size_t)bar->n_nodes * sizeof(double);
#define ARRAY(pointer, bytes)                                                                                \
    do {                                                                                                     \
        size_t offset_ = place(&layout, bytes);                                                              \
        if (block)                                                                                           \
            (pointer) = (void *)(block + offset_);                                                           \
    } while (0)
    ARRAY(bar->head, sizeof(BarHead));
    ARRAY(bar->first, ((size_t)bar->n_cells + 1) * sizeof(int32_t));
    ARRAY(bar->crossed, ((size_t)bar->n_particles + 63) / 64 * sizeof(uint64_t));
    for (int j = 0; j < bar->slots; j++) {
        ARRAY(bar->s[j], places);
        ARRAY(bar->v[j], places);
        ARRAY(bar->stress[j], places);
        ARRAY(bar->volume[j], places);
    }
    bar->bytes_flip = layout.size;
    for (int j = 0; j < bar->slots; j++)
        ARRAY(bar->affine[j], places);
    bar->bytes_apic = layout.size;
    ARRAY(bar->kept_mass, nodes);
    ARRAY(bar->kept_momentum, nodes);
    bar->bytes_kept = layout.size;
    for (int j = 0; j < bar->slots && bar->def.shape == MPM_CPDI; j++)
        ARRAY(bar->half[j], places);
    for (int j = 0; j < bar->slots; j++)
        ARRAY(bar->moved[j], places);
    double **node_arrays[] = {&bar->node_mass,  &bar->node_inverse, &bar->node_momentum,
                              &bar->node_f_int, &bar->node_f_ext,   &bar->node_velocity,
                              &bar->node_kick,  &bar->node_drift,   &bar->node_pivot};
    for (size_t i = 0; i < sizeof node_arrays / sizeof node_arrays[0]; i++)
        ARRAY(*node_arrays[i], nodes);
    for (int d = 1; d <= bar->reach; d++) {
        ARRAY(bar->node_couple[d], nodes);
        ARRAY(bar->node_lower[d], nodes);
    }
    bar->bytes_whole = layout.size;
    /* scratch stands behind, in the same block of memory */
    const size_t cells = ((size_t)bar->n_cells + 8) * sizeof(double);
    for (int q = 0; q < 2; q++)
        for (int a = 0; a < bar->support; a++) {
            ARRAY(bar->part[q][a], cells);
            if (block)
                bar->part[q][a] += 4;
        }
    for (int d = 1; d <= bar->reach; d++)
        for (int a = 0; a + d < bar->support; a++) {
            ARRAY(bar->pair[d][a], cells);
            if (block)
                bar->pair[d][a] += 4;
        }
    ARRAY(bar->odd, ((size_t)bar->n_cells / BAR_CELL_BLOCK + 1) * sizeof(int16_t));
    ARRAY(bar->old_first, ((size_t)bar->n_cells + 1) * sizeof(int32_t));
    ARRAY(bar->backup, bar->bytes_kept);
    bar->bytes_memory = layout.size + 64; /* room to begin at a multiple of 64 */
#undef ARRAY
}

/* --- life ----------------------------------------------------------------------------------------- */

static void destroy(Simulation *sim)
{
    Bar *bar = bar_of(sim);
    free(bar->memory);
    free(bar->both);
    free(bar);
}

/* What front ends read depends on algorithm, transfer and loads, which may change between steps. */
static void take_schedule(Bar *bar)
{
    bar_list_stages(bar);
    bar_list_fields(bar);
    bar_list_exchanges(bar);
}

/* Between steps the grid is forgotten and is not saved. */
static size_t saved_bytes(const Bar *bar, const BarHead *head)
{
    return bar->sim.stage != 0 ? bar->bytes_whole : bar_lasting_bytes(bar, head);
}

static size_t state_size(const Simulation *sim)
{
    const Bar *bar = bar_of_const(sim);
    return saved_bytes(bar, bar->head);
}

static void load(Simulation *sim, const void *bytes)
{
    Bar *bar = bar_of(sim);
    BarHead head; /* it stands first, but the bytes may not be aligned */
    memcpy(&head, bytes, sizeof head);
    size_t size = saved_bytes(bar, &head);
    memcpy(bar->block, bytes, size);
    if (size < bar->bytes_kept)
        memset((char *)bar->block + size, 0, bar->bytes_kept - size);
    bar_count_odd_cells(bar);
    take_schedule(bar);
}

/* mu, with what 0 stands for. */
static double blend_of(const BarDef *def, double mass_blend)
{
    return mass_blend == 0.0 ? bar_mass_blend_auto(def->shape, def->particles_per_cell, def->courant)
                             : mass_blend;
}

/* Another scheme that is taken for this one is run as that. */
static void take_mistake(Bar *bar, int mistake)
{
    BarHead *head = bar->head;
    const BarMistake *row = bar_mistake_if(bar, mistake);
    head->mistake = mistake;
    if (!row)
        return;
    head->algorithm = row->algorithm;
    head->flip_fraction = row->does & BAR_WRONG_OF_GRID ? 0.0 : 1.0;
}

/* How momentum is transferred: the values that the run would have then, if they fit each other. C of APIC
 * begins at 0 where the transfer is changed: there is no slope to begin with. */
static bool change_method(Bar *bar, const char *key, double value, Status *status)
{
    BarDef def = bar->def;
    BarHead *head = bar->head;
    def.algorithm = head->algorithm;
    def.transfer = head->transfer;
    def.flip_fraction = head->flip_fraction;
    def.mass_blend = head->mass_blend;
    def.fmpm_order = head->fmpm_order;
    def.mistake = head->mistake;
    if (def.mistake != 0) /* one is made of these */
        def.algorithm = MPM_USF, def.flip_fraction = 1.0;
    bool algorithm = strcmp(key, "mpm.algorithm") == 0, transfer = strcmp(key, "mpm.transfer") == 0;
    if (algorithm || transfer) {
        int last = algorithm ? MPM_MUSL : MPM_FMPM;
        if (!(value >= 0 && value <= last && value == floor(value)))
            return status_refuse(status, "%s: %g is no choice (0 to %d)", key, value, last);
        if (algorithm)
            def.algorithm = (MpmAlgorithm)value;
        else
            def.transfer = (MpmTransfer)value;
    } else if (strcmp(key, "mpm.flip_fraction") == 0)
        def.flip_fraction = value;
    else if (strcmp(key, "mpm.mass_blend") == 0)
        def.mass_blend = value;
    else if (strcmp(key, "mpm.fmpm_order") == 0 && value >= 1 && value <= FMPM_ORDER_MAX &&
             value == floor(value))
        def.fmpm_order = (int)value;
    else if (strcmp(key, "mpm.mistake") == 0 && value >= 0 && value == floor(value) && value < INT_MAX)
        def.mistake = (int)value;
    else if (strcmp(key, "mpm.fmpm_order") == 0)
        return status_refuse(status, "%s: %g is out of range (1 to %d)", key, value, FMPM_ORDER_MAX);
    else
        return status_refuse(status, "%s: cannot be changed in mid-run", key);
    if (!bar_check(&def, status))
        return false;
    if (def.mistake != head->mistake &&
        (bar_mistake_is_of_start(def.mistake) || bar_mistake_is_of_start(head->mistake)))
        return status_refuse(
            status, "%s: %s is made at the start and holds for the whole run", key,
            def.conceals_mistake
                ? "?"
                : bar_mistake_words[bar_mistake_is_of_start(def.mistake) ? def.mistake : head->mistake]);
    if (def.mistake != head->mistake) {
        memset(bar->kept_mass, 0, (size_t)bar->n_nodes * sizeof(double));
        memset(bar->kept_momentum, 0, (size_t)bar->n_nodes * sizeof(double));
    }
    if (def.transfer != head->transfer)
        for (int j = 0; j < bar->slots; j++)
            memset(bar->affine[j], 0, (size_t)bar->places * sizeof(double));
    head->algorithm = def.algorithm;
    head->transfer = def.transfer;
    head->flip_fraction = def.flip_fraction;
    take_mistake(bar, def.mistake);
    head->mass_blend = blend_of(&def, def.mass_blend);
    head->fmpm_order = def.fmpm_order;
    take_schedule(bar);
    return true;
}

static bool change(Simulation *sim, const char *key, double value, Status *status)
{
    Bar *bar = bar_of(sim);
    BarHead *head = bar->head;
    ASSERT_INT(sim->stage, ==, 0);
    if (strncmp(key, "mpm.", 4) == 0)
        return change_method(bar, key, value, status);
    double *load = strcmp(key, "load.body_force") == 0 ? &head->body_force
                   : strcmp(key, "load.traction") == 0 ? &head->traction
                                                       : NULL;
    if (!load)
        return status_refuse(status, "%s: cannot be changed in mid-run", key);
    if (!isfinite(value))
        return status_refuse(status, "%s: %g is no finite number", key, value);
    *load = value;
    take_schedule(bar);
    return true;
}

static const Method method = {
    .name = "mpm",
    .title = "material point method",
    .destroy = destroy,
    .stage = bar_stage,
    .steps = bar_steps,
    .row = bar_row,
    .costly = bar_costly,
    .leave_out = bar_leave_out,
    .field = bar_field,
    .links = bar_links,
    .shapes = bar_shapes,
    .exchange = bar_exchange,
    .explain = bar_explain,
    .state_size = state_size,
    .load = load,
    .change = change,
};

/* Numbers of the model that follow from the definition: counts, m = rho dx/P, dt = courant dx/c with c =
 * sqrt(E/rho) (eq. 21; of two materials the faster), supports and the particles under traction (eq. 11). The
 * mesh has `padding` cells beyond each free end. A node that is not heavier than 1e-12 of a full cell is
 * inactive; a larger threshold would be seen in the results (1e-3 changes them visibly). */
static void derive(Bar *bar)
{
    BarDef *def = &bar->def;
    /* a joint between equals is none: the sums of a row would have two parts, and another last digit */
    if (def->joint_modulus == def->youngs_modulus && def->joint_density == def->density)
        def->joint = 0.0;
    bool left = def->supports == BAR_FIXED_FREE || def->supports == BAR_FIXED_FIXED;
    bool right = def->supports == BAR_FREE_FIXED || def->supports == BAR_FIXED_FIXED;
    bar->slots = def->particles_per_cell;
    bar->places = (int)round(def->length / def->cell_size);
    bar->n_particles = bar->places * bar->slots;
    bar->origin = left ? 0 : def->padding;
    bar->n_cells = bar->places + bar->origin + (right ? 0 : def->padding);
    bar->support = shape_support(def->shape);
    bar->reach = shape_reach(def->shape);
    bar->n_nodes = bar->n_cells + bar->support - 1;
    /* uGIMP, CPDI: the ghost node beyond the support is held as well */
    int held = def->shape == MPM_GIMP || def->shape == MPM_CPDI ? 2 : 1;
    bar->fixed_left = left ? held : 0;
    bar->fixed_right = right ? held : 0;

    bar->dx = def->length / bar->places;
    double speed = sqrt(def->youngs_modulus / def->density), lightest = def->density;
    bar->joint = bar->n_particles;
    bar->joint_weight = 1.0;
    if (def->joint > 0.0) {
        bar->joint = (int)round(def->joint / bar->dx) * bar->slots;
        bar->joint_weight = def->joint_density / def->density;
        speed = fmax(speed, sqrt(def->joint_modulus / def->joint_density));
        lightest = fmin(lightest, def->joint_density);
    }
    bar->dt = def->courant * bar->dx / speed;
    bar->mass = def->density * bar->dx / bar->slots;
    const BarMistake *mistake = bar_mistake_if(bar, def->mistake);
    if (mistake && (mistake->does & BAR_WRONG_MASS_OF_CELL))
        bar->mass = def->density * bar->dx;
    bar->mass_floor = 1e-12 * lightest * bar->dx;
    bar->gimp_half = 0.5 / bar->slots;

    double spacing = bar->dx / bar->slots;
    bar->layer = def->traction_layer > 0.0 ? def->traction_layer : spacing;
    int in_layer = axial_particles_in_layer(bar->layer, spacing, bar->n_particles);
    bar->layer_left = left ? 0 : in_layer;
    bar->layer_right = right ? 0 : in_layer;
}

/* Each cell's particles take the mean of the stress where they lie: what differs within a cell no velocity of
 * the grid can change, and it would stay there for ever. */
static bool begin_stress(Bar *bar, Status *status)
{
    const BarDef *def = &bar->def;
    for (int k = 0; def->initial_stress && k < bar->places; k++) {
        double sum = 0.0;
        for (int j = 0; j < bar->slots; j++)
            sum += def->initial_stress((k + bar->s[j][k]) * bar->dx, def->initial_context);
        if (!isfinite(sum))
            return status_refuse(status, "initial.pulse: no finite stress at x = %g", (k + 0.5) * bar->dx);
        for (int j = 0; j < bar->slots; j++)
            bar->stress[j][k] = sum / bar->slots;
    }
    return true;
}

enum { PLACES_A_QUESTION = 16384 }; /* a millisecond or less, as each takes a sine for every mode */

/* The state at t = 0: places s = (j + 1/2 + offset)/P, v by eq. 19, volume m/rho, stress 0 or that of a
 * pulse; APIC's slopes C = dv0/dx, since from C = 0 it loses energy in the first step (a quarter of it for
 * the paper's mode 10). */
static bool begin(Bar *bar, Status *status)
{
    const BarDef *def = &bar->def;
    const BarMistake *mistake = bar_mistake_if(bar, def->mistake);
    const bool at_centres = mistake && (mistake->does & BAR_WRONG_STARTS_AT_CENTRES);
    *bar->head = (BarHead){.algorithm = def->algorithm,
                           .transfer = def->transfer,
                           .flip_fraction = def->flip_fraction,
                           .body_force = def->body_force,
                           .traction = def->traction,
                           .mass_blend = blend_of(def, def->mass_blend),
                           .fmpm_order = def->fmpm_order};
    take_mistake(bar, def->mistake);
    for (int c = 0; c <= bar->n_cells; c++) {
        int place = c - bar->origin;
        place = place < 0 ? 0 : place > bar->places ? bar->places : place;
        bar->first[c] = place * bar->slots;
    }
    bar_count_odd_cells(bar);
    bar->head->cell_sum = (int64_t)bar->slots * bar->places * (bar->places - 1) / 2;
    for (int j = 0; j < bar->slots; j++) {
        double s = bar_place_at_start(bar, j);
        for (int k = 0; k < bar->places; k++) {
            if (k % PLACES_A_QUESTION == 0 &&
                !patience_lasts(&def->patience, (j + (double)k / bar->places) / bar->slots))
                return status_fail(status, "the building of the bar was given up");
            double x = (k + (at_centres ? 0.5 : s)) * bar->dx;
            bar->s[j][k] = s;
            bar->v[j][k] = def->initial_velocity ? def->initial_velocity(x, def->initial_context) : 0.0;
            bar->volume[j][k] = bar->mass / def->density;
            if (def->transfer == MPM_APIC && def->initial_slope)
                bar->affine[j][k] = def->initial_slope(x, def->initial_context);
            if (!isfinite(bar->v[j][k]))
                return status_refuse(status, "initial.velocity: no finite number at x = %g", x);
        }
    }
    if (!begin_stress(bar, status))
        return false;
    bar->energy_start = bar_energy(bar);
    if (!isfinite(bar->energy_start))
        return status_refuse(status, "initial.velocity: the kinetic energy is no finite number");
    return true;
}

Simulation *bar_create(const BarDef *definition, Status *status)
{
    ASSERT(bar_check(definition, NULL));
    Bar *bar = calloc(1, sizeof *bar);
    if (!bar) {
        status_fail(status, "not enough memory for the bar");
        return NULL;
    }
    bar->def = *definition;
    bar->both = definition->mistake_beside ? malloc(sizeof *bar->both) : NULL;
    if (definition->mistake_beside &&
        (!bar->both || !bar_mistakes_join(definition->mistake, definition->mistake_beside, bar->both))) {
        status_fail(status, "not enough memory for the bar");
        free(bar);
        return NULL;
    }
    derive(bar);
    lay_out(bar, NULL);
    bar->memory = calloc(1, bar->bytes_memory); /* pages that are never written cost nothing */
    if (!bar->memory) {
        status_fail(status, "not enough memory for a bar of %d particles (%zu MB)", bar->n_particles,
                    bar->bytes_memory / 1000000 + 1);
        free(bar->both);
        free(bar);
        return NULL;
    }
    bar->block = (unsigned char *)bar->memory + (64 - (uintptr_t)bar->memory % 64);
    lay_out(bar, bar->block);
    bar->sim.state = bar->block;
    bar->kernels = bar_kernels(cpu_best());

    Simulation *sim = &bar->sim;
    sim->method = &method;
    sim->stage_items = (size_t)bar->n_cells;
    sim->n_sets = BAR_SETS;
    sim->counts[BAR_PARTICLES] = (size_t)bar->n_particles;
    sim->counts[BAR_NODES] = (size_t)bar->n_nodes;
    bar_set_series(bar);
    axial_set_motion(sim, HAS_MESH, bar->def.cell_size / bar->def.particles_per_cell);
    sim->dt = bar->dt;
    if (!begin(bar, status)) {
        simulation_destroy(sim);
        return NULL;
    }
    take_schedule(bar);
    return sim;
}

CPU_KERNELS(BarKernels, bar_kernels)

void bar_use_kernels(Simulation *sim, CpuLevel level)
{
    bar_of(sim)->kernels = bar_kernels(level);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A beam by the material point method is made, copied out, put back and changed. The state is one block of
 * arrays; a snapshot between steps is its first part, the particles, in the middle of a step all of it. */
#include "base/assertion.h"
#include "methods/mpm/plane/kernels/plane_kernels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Where each array stands in the block; called twice: to measure, then to set pointers. Large arrays
 * begin at different distances from a multiple of 4096 bytes. */
static size_t lay_out(Plane *plane, unsigned char *block)
{
    size_t size = 0, number = 0;
    const size_t particles = (size_t)plane->n_places, blocks = (size_t)plane->n_blocks;
    /* the empty lanes of a run look beyond the last node */
    const size_t nodes = (size_t)plane_rows_reached(plane) * (size_t)plane->gx + 2 * PLANE_LANES;
#define ARRAY(pointer, count)                                                                                \
    do {                                                                                                     \
        if (block)                                                                                           \
            (pointer) = (void *)(block + size);                                                              \
        const size_t bytes_ = ((count) * sizeof *(pointer) + 63) / 64 * 64;                                  \
        size += bytes_ + (bytes_ < 4096 ? 0 : 64 * (++number % 3));                                          \
    } while (0)
    ARRAY(plane->head, 1);
    double **const of_particles[] = {&plane->x,   &plane->y,   &plane->vx,  &plane->vy,
                                     &plane->sxx, &plane->syy, &plane->sxy, &plane->volume};
    for (size_t k = 0; k < sizeof of_particles / sizeof *of_particles; k++)
        ARRAY(*of_particles[k], particles);
    ARRAY(plane->crossed, particles / PLANE_LANES);
    plane->bytes_particles = size;
    ARRAY(plane->sx, particles);
    ARRAY(plane->sy, particles);
    ARRAY(plane->base, particles);
    ARRAY(plane->runs, particles / PLANE_LANES);
    ARRAY(plane->blocks, blocks);
    ARRAY(plane->crossings, blocks);
    double **const of_nodes[] = {&plane->node_mass, &plane->node_inverse, &plane->px,      &plane->py,
                                 &plane->fx,        &plane->fy,           &plane->node_vx, &plane->node_vy};
    for (size_t k = 0; k < sizeof of_nodes / sizeof *of_nodes; k++)
        ARRAY(*of_nodes[k], nodes);
    ARRAY(plane->push, (size_t)plane->gx);
    plane->bytes_whole = size;
    /* scratch stands behind */
    ARRAY(plane->slots, plane_slot_numbers(plane) * (size_t)plane->def.threads);
    /* patches are of no use when a row is written, which is when there is something to do for plane_null.c */
    const size_t null = plane_null_pays(plane) ? plane_null_numbers(plane) : 0;
    const size_t patches = blocks * (size_t)plane->gy * PLANE_GIVEN * PLANE_PATCH;
    ARRAY(plane->patches, null > patches ? null : patches);
    ARRAY(plane->far, blocks);
    ARRAY(plane->trouble, blocks);
    ARRAY(plane->backup, plane->bytes_particles);
#undef ARRAY
    plane->null = plane->patches;
    return size;
}

static void destroy(Simulation *sim)
{
    Plane *plane = plane_of(sim);
    pool_destroy(plane->pool);
    free(plane->memory);
    free(plane);
}

/* What front ends read of the stages depends on algorithm and flip fraction, which may change between steps.
 */
static void take_schedule(Plane *plane)
{
    plane_list_stages(plane);
    plane->sim.exchanges = plane_exchanges(plane->head);
    plane->sim.n_exchanges = PLANE_EXCHANGES;
}

/* Between steps the grid is forgotten and is not saved. */
static size_t state_size(const Simulation *sim)
{
    const Plane *plane = plane_of_const(sim);
    return sim->stage == 0 ? plane->bytes_particles : plane->bytes_whole;
}

static void load(Simulation *sim, const void *bytes)
{
    Plane *plane = plane_of(sim);
    memcpy(plane->block, bytes, state_size(sim));
    take_schedule(plane);
}

/* A live parameter, between steps only: it belongs to the state, so a snapshot brings back its own. */
static bool change(Simulation *sim, const char *key, double value, Status *status)
{
    Plane *plane = plane_of(sim);
    ASSERT_INT(sim->stage, ==, 0);
    if (strcmp(key, "mpm.algorithm") == 0) {
        if (!(value >= 0 && value <= MPM_MUSL && value == floor(value)))
            return status_refuse(status, "%s: %g is no choice (0 to %d)", key, value, MPM_MUSL);
        plane->head->algorithm = (MpmAlgorithm)value;
    } else if (strcmp(key, "mpm.flip_fraction") == 0) {
        if (!(value >= 0 && value <= 1))
            return status_refuse(status, "%s: %g is out of range (0 to 1)", key, value);
        plane->head->flip_fraction = value;
    } else
        return status_refuse(status, "%s: cannot be changed in mid-run", key);
    take_schedule(plane);
    return true;
}

static const Method method = {
    .name = "mpm",
    .title = "material point method",
    .destroy = destroy,
    .stage = plane_stage,
    .steps = plane_steps,
    .row = plane_row,
    .costly = plane_costly,
    .leave_out = plane_leave_out,
    .field = plane_field,
    .links = plane_links,
    .shapes = plane_shapes,
    .exchange = plane_exchange,
    .explain = plane_explain,
    .state_size = state_size,
    .load = load,
    .change = change,
};

enum { PARTICLES_TO_SHARE = 2048 };

Simulation *plane_create(const PlaneDef *definition, Status *status)
{
    ASSERT(plane_check(definition, NULL));
    Plane *plane = calloc(1, sizeof *plane);
    if (!plane) {
        status_fail(status, "not enough memory for the beam");
        return NULL;
    }
    plane->def = *definition;
    plane_derive(plane);
    plane->kernels = plane_kernels(cpu_best());
    /* a step of fewer particles is over before another thread has heard of it */
    if (plane->n_particles < PARTICLES_TO_SHARE)
        plane->def.threads = 1;
    if (plane->def.threads > plane->n_blocks)
        plane->def.threads = plane->n_blocks;
    const size_t bytes = plane->bytes_memory = lay_out(plane, NULL);
    plane->memory = calloc(1, bytes + 64); /* pages that are never written cost nothing */
    if (!plane->memory) {
        status_fail(status, "not enough memory for a beam of %d particles (%zu MB)", plane->n_particles,
                    bytes / 1000000 + 1);
        free(plane);
        return NULL;
    }
    plane->block = (unsigned char *)plane->memory + (64 - (uintptr_t)plane->memory % 64);
    lay_out(plane, plane->block);

    Simulation *sim = &plane->sim;
    sim->method = &method;
    sim->state = plane->block;
    sim->stage_items = (size_t)(plane->n_blocks > plane->gy ? plane->n_blocks : plane->gy);
    sim->n_sets = PLANE_SETS;
    sim->counts[PLANE_PARTICLES] = (size_t)plane->n_particles;
    sim->counts[PLANE_NODES] = (size_t)plane->n_nodes;
    sim->dt = plane->dt;
    plane_set_fields(plane);
    plane_set_series(plane);
    *plane->head = (PlaneHead){.algorithm = plane->def.algorithm, .flip_fraction = plane->def.flip_fraction};
    if ((plane->def.threads > 1 && !(plane->pool = pool_create(plane->def.threads, status))) ||
        !plane_begin(plane, status)) {
        simulation_destroy(sim);
        return NULL;
    }
    take_schedule(plane);
    return sim;
}

CPU_KERNELS(PlaneKernels, plane_kernels)

void plane_use_kernels(Simulation *sim, CpuLevel level)
{
    plane_of(sim)->kernels = plane_kernels(level);
}

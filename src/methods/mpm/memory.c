/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a simulation is made, and its memory and state: one block of arrays, of which a snapshot between steps
 * is the first part, the particles, in the middle of a step all of it. */
#include "base/assertion.h"
#include "methods/mpm/mistakes.h"

#include <stdlib.h>
#include <string.h>

/* --- memory --------------------------------------------------------------------------------------- */

/* Where each array is; called twice: to measure, then to set pointers. The scratch and those arrays that
 * belong to the model come behind the state. Large arrays begin at different distances from a multiple of
 * 4096 bytes: processors take a load for dependent on an earlier store when these agree. */
static size_t lay_out(Mpm *mpm, unsigned char *block)
{
    size_t size = 0, number = 0;
    /* a box on the grid's last row or column has its third node, with weight 0, beyond it */
    const size_t particles = (size_t)mpm->n_particles,
                 nodes = (size_t)mpm->n_nodes + (mpm->dim == 2 ? (size_t)mpm->gx + 1 : 0);
#define ARRAY(pointer, count)                                                                                \
    do {                                                                                                     \
        if (block)                                                                                           \
            (pointer) = (void *)(block + size);                                                              \
        const size_t bytes_ = ((count) * sizeof *(pointer) + 63) / 64 * 64;                                  \
        size += bytes_ + (bytes_ < 4096 ? 0 : 64 * (++number % 7));                                          \
    } while (0)
#define AXES(pointers, count)                                                                                \
    for (int axis = 0; axis < mpm->dim; axis++)                                                              \
    ARRAY((pointers)[axis], count)
    ARRAY(mpm->head, 1);
    AXES(mpm->u, particles);
    AXES(mpm->v, particles);
    for (int k = 0; k < (mpm->dim == 2 ? MPM_STRESSES : 1); k++)
        ARRAY(mpm->stress[k], particles);
    ARRAY(mpm->volume, particles);
    ARRAY(mpm->crossed, particles);
    for (int k = 0; mpm->bodies && k < 4; k++) {
        ARRAY(mpm->rate[k], particles);
        ARRAY(mpm->deformation[k], bodies_are_neo(mpm) ? particles : 0);
    }
    mpm->bytes_flip = size;
    ARRAY(mpm->affine, mpm->dim == 1 ? particles : 0);
    mpm->bytes_apic = size;
    ARRAY(mpm->kept_mass, mpm_can_keep(mpm) ? nodes : 0);
    AXES(mpm->kept_momentum, mpm_can_keep(mpm) ? nodes : 0);
    ARRAY(mpm->kept_volume, mpm_can_keep(mpm) ? particles : 0);
    mpm->bytes_kept = size;
    ARRAY(mpm->base, particles);
    AXES(mpm->s, particles);
    if (mpm->shape == MPM_CPDI)
        ARRAY(mpm->domain, particles);
    mpm->bytes_placed = size;
    /* the sums of a stage lie side by side: mpm_begin_stage() empties them at once */
    AXES(mpm->momentum, nodes);
    ARRAY(mpm->node_mass, nodes);
    AXES(mpm->normal, mpm->bodies ? nodes : 0);
    AXES(mpm->moment, mpm->bodies ? nodes : 0);
    ARRAY(mpm->inverse, nodes);
    ARRAY(mpm->load, mpm->dim == 1 ? nodes : 0);
    AXES(mpm->force, nodes);
    AXES(mpm->velocity, nodes);
    AXES(mpm->kick, nodes);
    AXES(mpm->carry, nodes);
    AXES(mpm->start, mpm->bodies ? nodes : 0);
    ARRAY(mpm->touched, mpm->bodies ? nodes : 0);
    ARRAY(mpm->lost, mpm->bodies ? (size_t)mpm->grid_nodes : 0);
    ARRAY(mpm->pivot, mpm->dim == 1 ? nodes : 0);
    for (int d = 1; mpm->dim == 1 && d < mpm->support; d++) {
        ARRAY(mpm->couple[d], nodes);
        ARRAY(mpm->lower[d], nodes);
    }
    mpm->bytes_whole = size;
    AXES(mpm->rest, particles);
    AXES(mpm->free, nodes);
    ARRAY(mpm->above, mpm->bodies ? particles : 0);
    ARRAY(mpm->field, mpm->bodies ? particles : 0);
    AXES(mpm->at, mpm->bodies ? particles : 0);
    ARRAY(mpm->chunks, (size_t)mpm->n_chunks);
    ARRAY(mpm->null, mpm->dim == 2 && !mpm->bodies && plane_null_pays(mpm) ? plane_null_numbers(mpm) : 0);
    ARRAY(mpm->backup, mpm->bytes_kept);
#undef AXES
#undef ARRAY
    return size;
}

static void destroy(Simulation *sim)
{
    Mpm *mpm = mpm_of(sim);
    pool_destroy(mpm->pool);
    free(mpm->memory);
    free(mpm);
}

static void take_schedule(Mpm *mpm)
{
    mpm->wrong = mpm_wrong_with(mpm, mpm->head->mistake);
    mpm_list_stages(mpm);
    mpm_list_fields(mpm);
    mpm_list_exchanges(mpm);
}

/* --- state ---------------------------------------------------------------------------------------- */

/* Between steps the grid is forgotten and is not saved. */
static size_t saved_bytes(const Mpm *mpm, const MpmHead *head)
{
    return mpm->sim.stage != 0 ? mpm->bytes_whole : mpm_lasting_bytes(mpm, head);
}

static size_t state_size(const Simulation *sim)
{
    return saved_bytes(mpm_of_const(sim), mpm_of_const(sim)->head);
}

static void load(Simulation *sim, const void *bytes)
{
    Mpm *mpm = mpm_of(sim);
    MpmHead head; /* it stands first, but the bytes may not be aligned */
    memcpy(&head, bytes, sizeof head);
    const size_t size = saved_bytes(mpm, &head);
    memcpy(mpm->block, bytes, size);
    if (size < mpm->bytes_kept)
        memset(mpm->block + size, 0, mpm->bytes_kept - size);
    if (sim->stage == 0)
        mpm_find_all(mpm);
    take_schedule(mpm);
    mpm_find_held(mpm, sim->step);
}

/* Small motion of particles that stay in their places: their state as a vector, of which |x|^2 is twice the
 * energy, sum m v^2 + V stress^2/E (method.h). With APIC also m (dx C/2)^2; its D is dx^2/4 or near it. */
static size_t small(Simulation *sim, double *x, double unit, bool put)
{
    Mpm *mpm = mpm_of(sim);
    double *const arrays[] = {mpm->v[0], mpm->stress[0], mpm->affine};
    const int parts = mpm->head->transfer == MPM_APIC ? 3 : 2, count = mpm->n_particles;
    ASSERT_INT(mpm->dim, ==, 1);
    for (int k = 0; k < parts && x; k++)
        for (int p = 0; p < count; p++) {
            const double root = sqrt(mpm_mass(mpm, p));
            const double scale = k == 0   ? root
                                 : k == 1 ? unit * sqrt(mpm->volume[p] / mpm_modulus(mpm, p))
                                          : root * mpm->dx / 2.0;
            if (put)
                arrays[k][p] = x[k * count + p] / scale;
            else
                x[k * count + p] = arrays[k][p] * scale;
        }
    return (size_t)parts * (size_t)count;
}

/* --- made and changed ------------------------------------------------------------------------------- */

enum { BAR = 1 << MPM_BAR, BEAM = 1 << MPM_BEAM, BODIES = 1 << MPM_BODIES, ALL = BAR | BEAM | BODIES };

/* The parameters that may change in mid-run; they belong to the state. */
#define LIVE(key, of, is_number, member)                                                                     \
    {                                                                                                        \
        key, of, is_number, offsetof(MpmDef, member), offsetof(MpmHead, member)                              \
    }
static const struct Live {
    const char *key;
    unsigned of;
    bool is_number; /* else a choice, or a whole number: an int */
    size_t in_def, in_head;
} live[] = {
    LIVE("mpm.algorithm", ALL, false, algorithm),        LIVE("mpm.transfer", BAR | BODIES, false, transfer),
    LIVE("mpm.flip_fraction", ALL, true, flip_fraction), LIVE("mpm.mass_blend", BAR, true, mass_blend),
    LIVE("mpm.fmpm_order", BAR, false, fmpm_order),      LIVE("mpm.mistake", BAR | BEAM, false, mistake),
    LIVE("load.body_force", BAR, true, body_force),      LIVE("load.traction", BAR, true, traction),
};
enum { LIVE_ROWS = sizeof live / sizeof *live };

static size_t live_size(const struct Live *row)
{
    return row->is_number ? sizeof(double) : sizeof(int);
}

/* Those of the state as a definition has them; mu with what 0 stands for. */
static void take_live(MpmHead *head, const MpmDef *def)
{
    for (const struct Live *row = live; row < live + LIVE_ROWS; row++)
        memcpy((char *)head + row->in_head, (const char *)def + row->in_def, live_size(row));
    if (def->problem != MPM_BAR)
        head->mass_blend = 1;
    else if (def->mass_blend == 0.0)
        head->mass_blend = bar_mass_blend_auto(def->shape, def->particles_per_cell, def->courant);
}

/* A live parameter, between steps only: it belongs to the state, so a snapshot brings back its own. APIC's
 * gradients begin at 0 where the transfer is changed: there is none to begin with. */
static bool change(Simulation *sim, const char *key, double value, Status *status)
{
    Mpm *mpm = mpm_of(sim);
    MpmDef def = mpm->def; /* of a run that begins with the live parameters of now */
    bool found = false;
    ASSERT_INT(sim->stage, ==, 0);
    for (const struct Live *row = live; row < live + LIVE_ROWS; row++) {
        const bool asked = (row->of & 1u << def.problem) && strcmp(row->key, key) == 0;
        void *const to = (char *)&def + row->in_def;
        if (!asked)
            memcpy(to, (const char *)mpm->head + row->in_head, live_size(row));
        else if (row->is_number)
            memcpy(to, &value, sizeof value);
        else
            *(int *)to = (int)value;
        found = found || asked;
    }
    if (!found)
        return status_refuse(status, "%s: cannot be changed in mid-run", key);
    if (!mpm_check(&def, status) || !mpm_change_mistake(mpm, def.mistake, status))
        return false;
    const size_t bytes = (size_t)mpm->n_particles * sizeof(double);
    if (def.transfer != mpm->head->transfer && mpm->dim == 1)
        memset(mpm->affine, 0, bytes);
    for (int k = 0; def.transfer != mpm->head->transfer && mpm->bodies && k < 4; k++)
        memset(mpm->rate[k], 0, bytes);
    take_live(mpm->head, &def);
    take_schedule(mpm);
    return true;
}

/* What each problem has of its own. */
static const struct {
    const char *what;
    unsigned has;
    void (*derive)(Mpm *);
    bool (*begin)(Mpm *, Status *);
    Method method;
} problems_by_mpm[] = {
#define METHOD                                                                                               \
    .name = "mpm", .title = "material point method", .destroy = destroy, .stage = mpm_stage,                 \
    .steps = mpm_steps, .row = mpm_row, .field = mpm_field, .links = mpm_links, .shapes = mpm_shapes,        \
    .exchange = mpm_exchange, .explain = mpm_explain, .state_size = state_size, .load = load,                \
    .change = change
    [MPM_BAR] = {"bar",
                 HAS_LINE | HAS_MESH,
                 bar_derive,
                 bar_begin,
                 {METHOD, .on_request = mpm_on_request, .small = small}},
    [MPM_BEAM] =
        {"beam", HAS_PLANE | HAS_MESH, plane_derive, plane_begin, {METHOD, .on_request = mpm_on_request}},
    [MPM_BODIES] = {"bodies",
                    HAS_MESH | HAS_BODIES,
                    bodies_derive,
                    bodies_begin,
                    {METHOD, .on_request = (const char *const[]){".touching", NULL}}},
#undef METHOD
};

/* lambda and G of Lame; D of plane strain or plane stress. */
void mpm_derive(Mpm *mpm, const MpmDef *given)
{
    MpmDef *def = &mpm->def;
    *def = *given;
    if (def->problem != MPM_BEAM)
        def->thickness = 1;
    if (def->problem == MPM_BAR)
        def->threads = 1; /* it is too small to be shared */
    else
        def->body_force = def->traction = 0;
    if (!def->leaves_channel)
        def->speed = def->channel = def->grid_velocity = 0;
    const double E = def->youngs_modulus, nu = def->poisson;
    const bool plane_stress = def->problem == MPM_BEAM || def->plane == PLANE_STRESS;
    mpm->bodies = def->problem == MPM_BODIES;
    mpm->dim = def->problem == MPM_BAR ? 1 : 2;
    mpm->shape = def->shape;
    mpm->support = shape_support(def->shape);
    mpm->dt = mpm_time_step(def);
    mpm->wrong = mpm_wrong_with(mpm, def->mistake);
    const double width = mpm_does(mpm, WRONG_BOX_WHOLE) ? 2 : mpm_does(mpm, WRONG_BOX_QUARTER) ? 0.5 : 1;
    mpm->half = 0.5 / def->particles_per_cell * width;
    mpm->shear = E / (2 * (1 + nu));
    mpm->slide = mpm_does(mpm, WRONG_TENSOR_SHEAR) ? 0.5 * mpm->shear : mpm->shear;
    mpm->lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
    mpm->D11 = plane_stress ? E / (1 - nu * nu) : mpm->lambda + 2 * mpm->shear;
    mpm->D12 = plane_stress ? nu * mpm->D11 : mpm->lambda;
    mpm->turn = def->rotation != ROTATION_JAUMANN || mpm_does(mpm, WRONG_NO_ROTATION) ? 0
                : mpm_does(mpm, WRONG_SPIN_SIGN)                                      ? -0.25
                                                                                      : 0.25;
    problems_by_mpm[def->problem].derive(mpm);
}

Simulation *mpm_create(const MpmDef *def, Status *status)
{
    enum { PARTICLES_TO_SHARE = 2048 }; /* a step of fewer is over before another thread has heard of it */
    ASSERT(mpm_check(def, NULL));
    Mpm *mpm = calloc(1, sizeof *mpm);
    if (!mpm) {
        status_fail(status, "not enough memory for the %s", problems_by_mpm[def->problem].what);
        return NULL;
    }
    Simulation *sim = &mpm->sim;
    sim->method = &problems_by_mpm[def->problem].method;
    sim->has = problems_by_mpm[def->problem].has;
    mpm_derive(mpm, def);
    mpm->bytes_memory = lay_out(mpm, NULL);
    mpm->memory = calloc(1, mpm->bytes_memory + 64); /* pages that are never written cost nothing */
    if (!mpm->memory) {
        status_fail(status, "not enough memory for %d particles (%zu MB)", mpm->n_particles,
                    mpm->bytes_memory / 1000000 + 1);
        destroy(sim);
        return NULL;
    }
    mpm->block = (unsigned char *)mpm->memory + (64 - (uintptr_t)mpm->memory % 64);
    lay_out(mpm, mpm->block);
    if (!mpm->bodies)
        mpm->field = NULL;
    sim->state = mpm->block;
    sim->dt = mpm->dt;
    sim->stage_items = (size_t)mpm->n_chunks;
    sim->n_sets = MPM_SETS;
    sim->counts[MPM_PARTICLES] = (size_t)mpm->n_particles;
    sim->counts[MPM_NODES] = (size_t)mpm->n_nodes;
    take_live(mpm->head, &mpm->def);
    bool sound = problems_by_mpm[def->problem].begin(mpm, status);
    const int threads = mpm->def.threads > mpm->n_chunks / 2 ? mpm->n_chunks / 2 : mpm->def.threads;
    if (sound && threads > 1 && mpm->n_particles >= PARTICLES_TO_SHARE)
        sound = (mpm->pool = pool_create(threads, status)) != NULL;
    if (!sound) {
        destroy(sim);
        return NULL;
    }
    mpm_set_series(mpm);
    take_schedule(mpm);
    const bool beam = def->problem == MPM_BEAM;
    simulation_lay(sim, beam ? (size_t)mpm->nxp : sim->counts[MPM_PARTICLES], beam ? (size_t)mpm->nyp : 1,
                   mpm->spacing, mpm->dim);
    sim->has |= mpm->speed > 0 ? HAS_RELATIVE_ENERGY : 0u;
    sim->common_speed = mpm->speed;
    return sim;
}

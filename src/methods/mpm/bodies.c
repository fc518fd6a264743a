/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bodies are made and changed. Particles are the centres ((i + 1/2) d, (j + 1/2) d), d = dx/P, of one lattice
 * that lie in a body; m = rho d^2, V = d^2, v = v0 + w x (X - c). With APIC a body starts with its gradient
 * of velocity, B = C D: with B = 0 a disc of three cells would lose a tenth of its spin in the first step.
 * The grid begins BODIES_PADDING cells before the box and ends as many behind it. */
#include "base/assertion.h"
#include "base/math/functions.h"
#include "methods/mpm/bodies_inner.h"

#include <stdlib.h>
#include <string.h>

/* --- what is constant ----------------------------------------------------------------------------- */

/* Calls `take` for each particle of a body in their order: rows from below, in a row from the left. */
static int each_particle(const Mpm *mpm, const BodyDef *body, void (*take)(Mpm *, int, double, double),
                         Mpm *to, int next)
{
    const double d = mpm->spacing;
    double low[2], high[2];
    bodies_bounds(body, low, high);
    for (long j = (long)floor(low[1] / d) - 1; j <= (long)ceil(high[1] / d); j++)
        for (long i = (long)floor(low[0] / d) - 1; i <= (long)ceil(high[0] / d); i++) {
            const double x = ((double)i + 0.5) * d, y = ((double)j + 0.5) * d;
            if (!bodies_hold(body, x, y))
                continue;
            if (take)
                take(to, next, x, y);
            next++;
        }
    return next;
}

/* At most so many chunks: some rows of a body each. */
static int count_chunks(const Bodies *bodies, double dx)
{
    int count = 0;
    for (int k = 0; k < bodies->def.n_bodies; k++) {
        double low[2], high[2];
        bodies_bounds(&bodies->def.bodies[k], low, high);
        count += (int)((high[1] - low[1]) / (BODIES_CHUNK_CELLS * dx)) + 2;
    }
    return count;
}

static void derive(Mpm *mpm)
{
    Bodies *bodies = mpm->bodies;
    const BodiesDef *def = &bodies->def;
    const double nu = def->poisson, E = def->youngs_modulus;
    mpm->dim = 2;
    mpm->shape = def->shape;
    mpm->support = shape_support(def->shape);
    mpm->dx = def->cell_size;
    mpm->dt = bodies_step(def);
    mpm->spacing = mpm->dx / def->particles_per_cell;
    bodies->volume = mpm->spacing * mpm->spacing;
    mpm->mass[0] = def->density * bodies->volume;
    mpm->floor = 1e-12 * def->density * mpm->dx * mpm->dx;
    mpm->half = 0.5 / def->particles_per_cell;
    bodies->columns = (int)lround(def->width / mpm->dx);
    bodies->rows = (int)lround(def->height / mpm->dx);
    bodies->n_fields = def->fields == FIELDS_EACH ? def->n_bodies : 1;
    mpm->gx = bodies->columns + 2 * BODIES_PADDING + 1;
    mpm->gy = bodies->rows + 2 * BODIES_PADDING + 1;
    mpm->grid_nodes = mpm->gx * mpm->gy;
    mpm->n_nodes = bodies->n_fields * mpm->grid_nodes;
    mpm->cells = 1 << 30; /* no spline is an end's */
    mpm->edge = def->shape == MPM_GIMP ? -mpm->half : def->shape == MPM_BSPLINE2 ? -0.5 : 0.0;
    mpm->xmin = mpm->ymin = -BODIES_PADDING * mpm->dx;
    for (int axis = 0; axis < 2; axis++) { /* a particle may be 2.5 cells outside the box */
        mpm->low[axis] = BODIES_PADDING - 2.5 + mpm->edge;
        mpm->high[axis] = BODIES_PADDING + (axis ? bodies->rows : bodies->columns) + 2.5 + mpm->edge;
    }
    bodies->shear = mpm->shear = E / (2 * (1 + nu));
    mpm->turn = def->rotation == ROTATION_NONE || bodies_does(bodies, BODIES_NO_ROTATION) ? 0
                : bodies_does(bodies, BODIES_SPIN_SIGN)                                   ? -0.25
                                                                                          : 0.25;
    mpm->slide = bodies->shear * (bodies_does(bodies, BODIES_TENSOR_SHEAR) ? 0.5 : 1);
    mpm->keeps_volume = bodies_does(bodies, BODIES_VOLUME_KEPT);
    bodies->lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
    mpm->D11 = def->plane == PLANE_STRESS ? E / (1 - nu * nu) : bodies->lambda + 2 * bodies->shear;
    mpm->D12 = def->plane == PLANE_STRESS ? nu * mpm->D11 : bodies->lambda;
    for (int k = 0; k < def->n_bodies; k++)
        bodies->first[k + 1] = each_particle(mpm, &def->bodies[k], NULL, NULL, bodies->first[k]);
    mpm->joint = mpm->n_particles = bodies->first[def->n_bodies];
    mpm->n_chunks = count_chunks(bodies, mpm->dx);
}

/* --- chunks: some rows of a body each --------------------------------------------------------------- */

/* Particles of a body in rows of as many cells; from which particle on the next ones are. */
static int chunk_end(const Mpm *mpm, int first, int end)
{
    const double height = BODIES_CHUNK_CELLS * mpm->dx;
    const double row = floor(mpm->at[1][first] / height);
    while (first < end && floor(mpm->at[1][first] / height) == row)
        first++;
    return first;
}

/* Of at most as many as were counted; even ones first: engine.h. */
static bool make_chunks(Mpm *mpm)
{
    const Bodies *bodies = mpm->bodies;
    MpmChunk *all = calloc((size_t)mpm->n_chunks, sizeof *all);
    int count = 0;
    for (int k = 0; all && k < bodies->def.n_bodies; k++)
        for (int p = bodies->first[k], end; p < bodies->first[k + 1]; p = end) {
            end = chunk_end(mpm, p, bodies->first[k + 1]);
            ASSERT_INDEX(count, mpm->n_chunks);
            all[count++] = (MpmChunk){p, end - p, 1, 0};
        }
    if (!all)
        return false;
    mpm->n_chunks = count;
    mpm->sim.stage_items = (size_t)count;
    for (int k = 0; k < count; k++)
        mpm->chunks[k] = all[k < (count + 1) / 2 ? 2 * k : 2 * (k - (count + 1) / 2) + 1];
    free(all);
    return true;
}

/* --- particles at t = 0 ----------------------------------------------------------------------------- */

static void place(Mpm *mpm, int p, double x, double y)
{
    const double at[2] = {x, y};
    for (int axis = 0; axis < 2; axis++) {
        mpm->at[axis][p] = at[axis];
        mpm->rest[axis][p] = at[axis] / mpm->dx + BODIES_PADDING + mpm->edge;
    }
    mpm->volume[p] = mpm->bodies->volume;
    for (int k = 0; bodies_are_neo(mpm) && k < 4; k++)
        mpm->deformation[k][p] = k == 0 || k == 3;
}

/* v = v0 + w x (X - c), and of a block its wave along x */
static void start_of(const double x[2], const void *context, double v[2], double gradient[4])
{
    const BodyDef *body = context;
    double centre[2];
    bodies_centre(body, centre);
    v[0] = body->velocity[0] - body->spin * (x[1] - centre[1]);
    v[1] = body->velocity[1] + body->spin * (x[0] - centre[0]);
    gradient[0] = gradient[3] = 0;
    gradient[1] = -body->spin;
    gradient[2] = body->spin;
    if (body->wave != 0) {
        const double k = M_PI / (body->size[2] - body->size[0]), phase = k * (x[0] - body->size[0]);
        v[0] += body->wave * math_sin(phase);
        gradient[0] = body->wave * k * math_cos(phase);
    }
}

/* With APIC also B = C D of the field's gradient C. */
static void set_moving(Mpm *mpm, BodiesField *field, const void *context, int p)
{
    const double x[2] = {mpm->at[0][p], mpm->at[1][p]};
    double v[2], gradient[4];
    field(x, context, v, gradient);
    mpm->v[0][p] = v[0];
    mpm->v[1][p] = v[1];
    if (mpm->head->transfer != MPM_APIC)
        return;
    for (int k = 0; k < 4; k++) {
        const int axis = k % 2;
        MpmWeights w;
        shape_at(mpm->shape, mpm->half, 1 << 20, 2, mpm->s[axis][p], w.n[axis], w.dn[axis]);
        mpm->rate[k][p] =
            gradient[k] * (mpm->dx * mpm->dx) * mpm_spread(mpm->shape, mpm->edge, mpm->s[axis][p], w.n[axis]);
    }
}

/* By what a run that grows without bound is known. */
static void note_energy(Mpm *mpm)
{
    const BodiesDef *def = &mpm->bodies->def;
    const double fall = sqrt(def->gravity[0] * def->gravity[0] + def->gravity[1] * def->gravity[1]) *
                        (def->width + def->height);
    mpm->energy_start = bodies_energy(mpm) + mpm->mass[0] * mpm->n_particles * fall;
}

void bodies_begin_with(Simulation *sim, BodiesField *field, const void *context)
{
    Mpm *mpm = mpm_of(sim);
    ASSERT(sim->step == 0 && sim->stage == 0);
    for (int p = 0; p < mpm->n_particles; p++)
        set_moving(mpm, field, context, p);
    note_energy(mpm);
}

/* Of each particle the one above it: a row of a body is from the left, and the next row follows it. */
static void find_neighbours(Mpm *mpm)
{
    for (int body = 0; body < mpm->bodies->def.n_bodies; body++) {
        const int end = mpm->bodies->first[body + 1];
        int q = mpm->bodies->first[body];
        for (int p = q; p < end; p++) {
            const double x = mpm->at[0][p] - 0.5 * mpm->spacing, y = mpm->at[1][p] + 0.5 * mpm->spacing;
            while (q < end && (mpm->at[1][q] < y || (mpm->at[1][q] < y + mpm->spacing && mpm->at[0][q] < x)))
                q++;
            const bool is_above =
                q < end && mpm->at[1][q] < y + mpm->spacing && mpm->at[0][q] < x + mpm->spacing;
            mpm->above[p] = is_above ? q : -1;
        }
    }
}

static bool begin(Mpm *mpm, Status *status)
{
    const Bodies *bodies = mpm->bodies;
    const BodiesDef *def = &bodies->def;
    *mpm->head = (MpmHead){.algorithm = def->algorithm,
                           .transfer = def->transfer,
                           .flip_fraction = def->flip_fraction,
                           .mass_blend = 1};
    for (int k = 0; k < def->n_bodies; k++) {
        if (cancel_requested(&def->cancel, (double)k / def->n_bodies))
            return status_fail(status, "the building of the bodies was cancelled");
        each_particle(mpm, &def->bodies[k], place, mpm, bodies->first[k]);
        for (int p = bodies->first[k]; p < bodies->first[k + 1]; p++)
            mpm->field[p] = bodies->n_fields > 1 ? k * mpm->grid_nodes : 0;
    }
    find_neighbours(mpm);
    if (!make_chunks(mpm))
        return status_fail(status, "not enough memory for the bodies");
    mpm_find_all(mpm);
    for (int k = 0; k < def->n_bodies; k++)
        for (int p = bodies->first[k]; p < bodies->first[k + 1]; p++)
            set_moving(mpm, start_of, &def->bodies[k], p);
    note_energy(mpm);
    return isfinite(mpm->energy_start) ||
           status_refuse(status, "bodies: their energy is not a finite number");
}

/* --- made and changed ------------------------------------------------------------------------------- */

/* A live parameter, between steps only: it belongs to the state, so a snapshot brings back its own. */
static bool change(Simulation *sim, const char *key, double value, Status *status)
{
    Mpm *mpm = mpm_of(sim);
    ASSERT_INT(sim->stage, ==, 0);
    const bool whole = value >= 0 && value == floor(value);
    if (strcmp(key, "mpm.algorithm") == 0 && whole && value <= MPM_MUSL)
        mpm->head->algorithm = (MpmAlgorithm)value;
    else if (strcmp(key, "mpm.transfer") == 0 && whole && value <= MPM_APIC) {
        for (int k = 0; mpm->head->transfer != (MpmTransfer)value && k < 4; k++)
            memset(mpm->rate[k], 0,
                   (size_t)mpm->n_particles * sizeof(double)); /* the gradient is not known */
        mpm->head->transfer = (MpmTransfer)value;
    } else if (strcmp(key, "mpm.flip_fraction") == 0 && value >= 0 && value <= 1)
        mpm->head->flip_fraction = value;
    else
        return status_refuse(status, "%s: cannot be changed to %g in mid-run", key, value);
    mpm_take_schedule(mpm);
    return true;
}

static const char *const on_request[] = {".touching", NULL};

static const Method method = {MPM_METHOD, .on_request = on_request, .change = change};

Simulation *bodies_create(const BodiesDef *definition, Status *status)
{
    static const MpmMaker maker = {"bodies", &method, HAS_MESH | HAS_BODIES,
                                   derive,   begin,   bodies_set_series};
    ASSERT(bodies_check(definition, NULL));
    struct {
        Mpm mpm;
        Bodies bodies;
    } *both = calloc(1, sizeof *both);
    if (both) {
        both->mpm.bodies = &both->bodies;
        both->bodies.def = *definition;
    }
    return mpm_create(both ? &both->mpm : NULL, &maker, (int[2]){0}, definition->threads, status);
}

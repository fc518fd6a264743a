/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bodies: their numbers, and their particles at t = 0, the centres ((i + 1/2) d, (j + 1/2) d), d = dx/P, of
 * one lattice that lie in a body; m = rho d^2, V = d^2, v = v0 + w x (X - c). With APIC a body starts with
 * its gradient of velocity, B = C D: with B = 0 a disc of three cells would lose a tenth of its spin in the
 * first step. The grid begins BODIES_PADDING cells before the box and ends as many behind it. */
#include "base/assertion.h"
#include "base/math/functions.h"
#include "methods/mpm/mistakes.h"

const char *const bodies_walls[WALLS] = {"left", "right", "bottom", "top"};

/* --- shapes --------------------------------------------------------------------------------------- */

void bodies_centre(const BodyDef *body, double centre[2])
{
    const bool block = body->shape == BODY_BLOCK;
    for (int axis = 0; axis < 2; axis++)
        centre[axis] = block ? 0.5 * (body->size[axis] + body->size[2 + axis]) : body->size[axis];
}

void bodies_bounds(const BodyDef *body, double low[2], double high[2])
{
    const double *const size = body->size, radius = size[body->shape == BODY_RING ? 3 : 2];
    for (int axis = 0; axis < 2; axis++) {
        low[axis] = body->shape == BODY_BLOCK ? size[axis] : size[axis] - radius;
        high[axis] = body->shape == BODY_BLOCK ? size[2 + axis] : size[axis] + radius;
    }
}

bool bodies_hold(const BodyDef *body, double x, double y)
{
    const double *const size = body->size;
    if (body->shape == BODY_BLOCK)
        return x > size[0] && x < size[2] && y > size[1] && y < size[3];
    const double X = x - size[0], Y = y - size[1], squared = X * X + Y * Y;
    return body->shape == BODY_DISC ? squared < size[2] * size[2]
                                    : squared > size[2] * size[2] && squared < size[3] * size[3];
}

BodyWalk bodies_walk(const MpmDef *def, int body)
{
    const double d = def->cell_size / def->particles_per_cell;
    double low[2], high[2];
    bodies_bounds(&def->bodies[body], low, high);
    const long left = (long)floor(low[0] / d) - 1, bottom = (long)floor(low[1] / d) - 1;
    return (BodyWalk){.body = &def->bodies[body],
                      .spacing = d,
                      .left = left,
                      .right = (long)ceil(high[0] / d),
                      .top = (long)ceil(high[1] / d),
                      .i = left - 1,
                      .j = bottom};
}

bool bodies_next(BodyWalk *walk)
{
    do {
        if (++walk->i > walk->right) {
            walk->i = walk->left;
            walk->j++;
        }
        walk->x = ((double)walk->i + 0.5) * walk->spacing;
        walk->y = ((double)walk->j + 0.5) * walk->spacing;
    } while (walk->j <= walk->top && !bodies_hold(walk->body, walk->x, walk->y));
    return walk->j <= walk->top;
}

/* --- what is constant ----------------------------------------------------------------------------- */

void bodies_derive(Mpm *mpm)
{
    const MpmDef *def = &mpm->def;
    mpm->dx = def->cell_size;
    mpm->spacing = mpm->dx / def->particles_per_cell;
    mpm->volume_start = mpm->spacing * mpm->spacing;
    mpm->mass[0] = def->density * mpm->volume_start;
    mpm->floor = 1e-12 * def->density * mpm->dx * mpm->dx;
    mpm->box[0] = (int)lround(def->length / mpm->dx);
    mpm->box[1] = (int)lround(def->height / mpm->dx);
    mpm->n_fields = def->fields == FIELDS_EACH ? def->n_bodies : 1;
    mpm->gx = mpm->box[0] + 2 * BODIES_PADDING + 1;
    mpm->gy = mpm->box[1] + 2 * BODIES_PADDING + 1;
    mpm->grid_nodes = mpm->gx * mpm->gy;
    mpm->n_nodes = mpm->n_fields * mpm->grid_nodes;
    mpm->cells = 1 << 30; /* no spline is an end's */
    mpm->edge = def->shape == MPM_GIMP ? -mpm->half : def->shape == MPM_BSPLINE2 ? -0.5 : 0.0;
    mpm->xmin = mpm->ymin = -BODIES_PADDING * mpm->dx;
    for (int axis = 0; axis < 2; axis++) { /* a particle may be 2.5 cells outside the box */
        mpm->low[axis] = BODIES_PADDING - 2.5 + mpm->edge;
        mpm->high[axis] = BODIES_PADDING + mpm->box[axis] + 2.5 + mpm->edge;
    }
    for (int k = 0; k < def->n_bodies; k++) {
        double last = NAN; /* rows of particles within as many rows of cells are a chunk of a body */
        for (BodyWalk walk = bodies_walk(def, k); bodies_next(&walk); mpm->n_particles++) {
            const double row = floor(walk.y / (BODIES_CHUNK_CELLS * mpm->dx));
            mpm->n_chunks += row != last;
            last = row;
        }
        mpm->first[k + 1] = mpm->n_particles;
    }
    mpm->joint = mpm->n_particles;
}

/* --- particles at t = 0 ----------------------------------------------------------------------------- */

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
    const MpmWeights w = mpm_weights_of(mpm, p);
    for (int k = 0; k < 4; k++)
        mpm->rate[k][p] = gradient[k] * (mpm->dx * mpm->dx) *
                          mpm_spread(mpm->shape, mpm->edge, mpm->s[k % 2][p], w.n[k % 2]);
}

/* By what a run that grows without bound is known. */
static void note_energy(Mpm *mpm)
{
    const MpmDef *def = &mpm->def;
    const double fall = sqrt(def->gravity[0] * def->gravity[0] + def->gravity[1] * def->gravity[1]) *
                        (def->length + def->height);
    mpm->energy_start = mpm_energy(mpm) + mpm->mass[0] * mpm->n_particles * fall;
}

void bodies_begin_with(Simulation *sim, BodiesField *field, const void *context)
{
    Mpm *mpm = mpm_of(sim);
    ASSERT(sim->step == 0 && sim->stage == 0);
    for (int p = 0; p < mpm->n_particles; p++)
        set_moving(mpm, field, context, p);
    note_energy(mpm);
}

bool bodies_begin(Mpm *mpm, Status *status)
{
    const MpmDef *def = &mpm->def;
    for (int k = 0; k < def->n_bodies; k++) {
        if (cancel_requested(&def->cancel, (double)k / def->n_bodies))
            return status_fail(status, "the building of the bodies was cancelled");
        int p = mpm->first[k];
        for (BodyWalk walk = bodies_walk(def, k); bodies_next(&walk); p++) {
            mpm->at[0][p] = walk.x;
            mpm->at[1][p] = walk.y;
            for (int axis = 0; axis < 2; axis++)
                mpm->rest[axis][p] = mpm->at[axis][p] / mpm->dx + BODIES_PADDING + mpm->edge;
            mpm->volume[p] = mpm->volume_start;
            for (int i = 0; bodies_are_neo(mpm) && i < 4; i++)
                mpm->deformation[i][p] = i == 0 || i == 3;
            mpm->field[p] = mpm->n_fields > 1 ? k * mpm->grid_nodes : 0;
        }
    }
    /* of each particle the one above it: a row of a body is from the left, and the next row follows it */
    for (int body = 0; body < def->n_bodies; body++) {
        const int end = mpm->first[body + 1];
        int q = mpm->first[body];
        for (int p = q; p < end; p++) {
            const double x = mpm->at[0][p] - 0.5 * mpm->spacing, y = mpm->at[1][p] + 0.5 * mpm->spacing;
            while (q < end && (mpm->at[1][q] < y || (mpm->at[1][q] < y + mpm->spacing && mpm->at[0][q] < x)))
                q++;
            const bool is_above =
                q < end && mpm->at[1][q] < y + mpm->spacing && mpm->at[0][q] < x + mpm->spacing;
            mpm->above[p] = is_above ? q : -1;
        }
    }
    const double height = BODIES_CHUNK_CELLS * mpm->dx, *const y = mpm->at[1];
    for (int k = 0, count = 0; k < def->n_bodies; k++) /* some rows of a body each */
        for (int p = mpm->first[k], end; p < mpm->first[k + 1]; p = end) {
            for (end = p; end < mpm->first[k + 1] && floor(y[end] / height) == floor(y[p] / height);)
                end++;
            mpm_put_chunk(mpm, count++, (MpmChunk){p, end - p, .rows = 1});
        }
    mpm_find_all(mpm);
    for (int k = 0; k < def->n_bodies; k++)
        for (int p = mpm->first[k]; p < mpm->first[k + 1]; p++)
            set_moving(mpm, start_of, &def->bodies[k], p);
    note_energy(mpm);
    return isfinite(mpm->energy_start) ||
           status_refuse(status, "bodies: their energy is not a finite number");
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is seen of bodies beside their series: where one tears, how a disc that spins grows, how far a block
 * has bent. */
#include "methods/mpm/engine.h"

#include <stdio.h>
#include <string.h>

/* The largest distance of neighbours, to the right or above, over that at t = 0, and the particle that it
 * begins at. */
static double bodies_largest_stretch(const Mpm *mpm, int *at)
{
    const double d = mpm->spacing;
    double most = 0.0;
    for (int p = 0; p < mpm->n_particles; p++)
        for (int above = 0; above < 2; above++) {
            const int q = above ? mpm->above[p] : p + 1;
            if (q < 0 || q >= mpm->n_particles ||
                (!above &&
                 (mpm->at[1][q] != mpm->at[1][p] || !(fabs(mpm->at[0][q] - mpm->at[0][p] - d) < 0.5 * d))))
                continue;
            const double x = mpm->at[0][q] + mpm->u[0][q] - (mpm->at[0][p] + mpm->u[0][p]);
            const double y = mpm->at[1][q] + mpm->u[1][q] - (mpm->at[1][p] + mpm->u[1][p]);
            const double squared = (x * x + y * y) / (d * d);
            *at = squared > most ? p : *at;
            most = squared > most ? squared : most;
        }
    return sqrt(most);
}

void bodies_note_tear(Mpm *mpm)
{
    MpmHead *head = mpm->head;
    int at = 0;
    char text[200];
    if (head->torn > 0)
        return;
    /* neighbours whose distance grows over d lambda may share no node any more, and nothing holds them
     * together then: hats from lambda = P on, boxes from P + 1, splines from 2 P */
    const int P = mpm->def.particles_per_cell;
    const double stretch = bodies_largest_stretch(mpm, &at);
    if (!(stretch > (mpm->shape == MPM_HAT ? P : mpm->shape == MPM_GIMP ? P + 1 : 2 * P)))
        return;
    head->torn = mpm->sim.step + 1;
    head->torn_at = at;
    snprintf(text, sizeof text,
             "torn: particle %d at (%.3g, %.3g), its neighbour is %.3g times as far as at first (%smore "
             "particles)",
             at, mpm->at[0][at] + mpm->u[0][at], mpm->at[1][at] + mpm->u[1][at], stretch,
             mpm->shape == MPM_HAT ? "gimp or " : "");
    batch_report(&mpm->sim, EVENT_TEAR, text);
}

static double time_of(const Simulation *sim, long step)
{
    return step > 0 ? (double)step * sim->dt : NAN;
}

static bool spins_alone(const MpmDef *def)
{
    return def->n_bodies == 1 && def->bodies[0].shape == BODY_DISC && def->bodies[0].spin != 0.0;
}

/* I = sum m |X - c|^2, X = x at t = 0 or now. */
static double inertia(const Mpm *mpm, bool now)
{
    const double count = mpm->n_particles;
    double sum[2] = {0}, squares = 0.0;
    for (int axis = 0; axis < 2; axis++)
        for (int p = 0; p < mpm->n_particles; p++) {
            const double x = mpm->at[axis][p] + (now ? mpm->u[axis][p] : 0.0);
            sum[axis] += x;
            squares += x * x;
        }
    return mpm->mass[0] * (squares - (sum[0] * sum[0] + sum[1] * sum[1]) / count);
}

void bodies_note_spin(Mpm *mpm)
{
    if (!spins_alone(&mpm->def))
        return;
    double pull = 0.0;
    for (int p = 0; p < mpm->n_particles; p++)
        pull += 0.5 * mpm->volume[p] * (mpm->stress[0][p] + mpm->stress[1][p]);
    mpm->head->inertia += inertia(mpm, true);
    mpm->head->pull += pull;
}

double bodies_closing(const double *row)
{
    const double *const a = row + BODIES_X, *const b = a + BODY_COLUMNS;
    const double D[2] = {b[0] - a[0], b[1] - a[1]}, length = sqrt(D[0] * D[0] + D[1] * D[1]);
    return -(D[0] * (b[2] - a[2]) + D[1] * (b[3] - a[3])) / length;
}

BodiesSeen bodies_seen(const Simulation *sim)
{
    const Mpm *mpm = mpm_of_const(sim);
    const bool spins = spins_alone(&mpm->def) && sim->step > 0;
    const double steps = (double)sim->step, area = mpm->volume_start * mpm->n_particles;
    int at = 0;
    return (BodiesSeen){time_of(sim, mpm->head->met),
                        time_of(sim, mpm->head->hit),
                        time_of(sim, mpm->head->torn),
                        bodies_largest_stretch(mpm, &at),
                        mpm->head->meeting,
                        bodies_push(mpm->head) ? NAN : mpm->head->parting,
                        mpm->head->touching[0] >> (BODIES_MAX + WALL_BOTTOM) & 1,
                        spins ? mpm->head->inertia / steps / inertia(mpm, false) - 1.0 : NAN,
                        spins ? mpm->head->pull / steps / area : NAN};
}

void bodies_tip(const Simulation *sim, double tip[2])
{
    const Mpm *mpm = mpm_of_const(sim);
    const double *const size = mpm->def.bodies[0].size, d = mpm->spacing;
    double weight = 0.0, sum[2] = {0};
    for (int p = 0; p < mpm->first[1]; p++) {
        /* the two rows next to the middle, or that in it; of columns u_last + (u_last - u_before)/2 */
        const double column = size[2] - mpm->at[0][p], row = mpm->at[1][p] - 0.5 * (size[1] + size[3]);
        if (column > 2.0 * d || fabs(row) > 0.75 * d)
            continue;
        const double share = column < d ? 1.5 : -0.5;
        weight += share;
        for (int axis = 0; axis < 2; axis++)
            sum[axis] += share * mpm->u[axis][p];
    }
    for (int axis = 0; axis < 2; axis++)
        tip[axis] = sum[axis] / weight;
}

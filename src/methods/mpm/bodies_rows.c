/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Energies of bodies and the row of their series, per unit thickness:
 *
 *     kinetic    sum m v^2/2
 *     strain     sum V stress : D^-1 stress/2 (hypoelastic: no potential, only nearly kept), or
 *                sum V0 (G (tr F F^T - 2)/2 - G ln J + lambda (ln J)^2/2) (neo-Hookean)
 *     potential  -sum m g . x
 *     friction   what walls and contact took by it
 *     angular    about the middle of the box: sum m (x - c) x v, with APIC + sum m (B_yx - B_xy)
 *     NAME.spin  the body's own angular momentum, without B, over its own moment of inertia */
#include "base/math/functions.h"
#include "methods/mpm/engine.h"

#include <stdio.h>
#include <string.h>

double bodies_strain_at(const Mpm *mpm, int p)
{
    const double G = mpm->shear;
    if (bodies_are_neo(mpm)) {
        const double F[4] = {mpm->deformation[0][p], mpm->deformation[1][p], mpm->deformation[2][p],
                             mpm->deformation[3][p]};
        const double trace = F[0] * F[0] + F[1] * F[1] + F[2] * F[2] + F[3] * F[3];
        const double swell = math_log(F[0] * F[3] - F[1] * F[2]);
        return mpm->volume_start * (0.5 * G * (trace - 2.0) - G * swell + 0.5 * mpm->lambda * swell * swell);
    }
    const double xx = mpm->stress[0][p], yy = mpm->stress[1][p], xy = mpm->stress[2][p];
    const double whole = mpm->D11 * mpm->D11 - mpm->D12 * mpm->D12;
    const double direct = (mpm->D11 * (xx * xx + yy * yy) - 2.0 * mpm->D12 * (xx * yy)) / whole;
    return 0.5 * mpm->volume[p] * (direct + xy * xy / G);
}

/* Neighbours whose distance grows over d lambda may share no node any more, and nothing holds them together
 * then: hats from lambda = P on, boxes from P + 1, splines from 2 P. */
static double torn_stretch(const Mpm *mpm)
{
    const int P = mpm->def.particles_per_cell;
    return mpm->shape == MPM_HAT ? P : mpm->shape == MPM_GIMP ? P + 1 : 2 * P;
}

/* Squared distance over d^2 of a particle and its neighbour to the right or above; 0: it has none. */
static double squared_stretch(const Mpm *mpm, int p, bool above)
{
    const double d = mpm->spacing;
    const int q = above ? mpm->above[p] : p + 1;
    if (q < 0 || q >= mpm->n_particles ||
        (!above && (mpm->at[1][q] != mpm->at[1][p] || !(fabs(mpm->at[0][q] - mpm->at[0][p] - d) < 0.5 * d))))
        return 0.0;
    const double x = mpm->at[0][q] + mpm->u[0][q] - (mpm->at[0][p] + mpm->u[0][p]);
    const double y = mpm->at[1][q] + mpm->u[1][q] - (mpm->at[1][p] + mpm->u[1][p]);
    return (x * x + y * y) / (d * d);
}

/* The largest distance of neighbours over that at t = 0, and the particle that it begins at. */
static double bodies_largest_stretch(const Mpm *mpm, int *at)
{
    double most = 0.0;
    for (int p = 0; p < mpm->n_particles; p++)
        for (int above = 0; above < 2; above++) {
            const double squared = squared_stretch(mpm, p, above);
            if (squared > most) {
                most = squared;
                *at = p;
            }
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
    const double stretch = bodies_largest_stretch(mpm, &at);
    if (!(stretch > torn_stretch(mpm)))
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

/* Sums over some particles. */
typedef struct Sums {
    double x, y, vx, vy, turn, inertia; /* sum x, ..., sum x v_y - y v_x, sum x^2 + y^2 */
    double squares, strain, affine;     /* sum v^2, strain energies, sum B_yx - B_xy */
} Sums;

static Sums sum_particles(const Mpm *mpm, int first, int end)
{
    Sums sum = {0};
    for (int p = first; p < end; p++) {
        const double x = mpm->at[0][p] + mpm->u[0][p], y = mpm->at[1][p] + mpm->u[1][p];
        const double vx = mpm->v[0][p], vy = mpm->v[1][p];
        sum.x += x, sum.y += y, sum.vx += vx, sum.vy += vy;
        sum.turn += x * vy - y * vx;
        sum.inertia += x * x + y * y;
        sum.squares += vx * vx + vy * vy;
        sum.strain += bodies_strain_at(mpm, p);
        sum.affine += mpm->rate[2][p] - mpm->rate[1][p];
    }
    return sum;
}

double bodies_energy(const Mpm *mpm)
{
    const Sums sum = sum_particles(mpm, 0, mpm->n_particles);
    return 0.5 * mpm->mass[0] * sum.squares + sum.strain;
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

static const Quantity quantities[BODIES_X] = {
    [BODIES_KINETIC] = {"kinetic", "kinetic", "force*length", "kinetic energy of the particles"},
    [BODIES_STRAIN] = {"strain", "strain", "force*length", "strain energy of the particles"},
    [BODIES_POTENTIAL] = {"potential", "potential", "force*length",
                          "potential energy in the field of gravity, 0 at the origin"},
    [BODIES_FRICTION] = {"friction", "friction", "force*length",
                         "energy that friction at walls and in contact has taken"},
    [BODIES_TOTAL] = {"total", "total", "force*length", "kinetic + strain + potential + friction"},
    [BODIES_MOMENTUM_X] = {"momentum_x", "momentum x", "mass*length/time", "momentum of all bodies along x"},
    [BODIES_MOMENTUM_Y] = {"momentum_y", "momentum y", "mass*length/time", "momentum of all bodies along y"},
    [BODIES_ANGULAR] = {"angular", "angular mom.", "mass*length^2/time",
                        "angular momentum about the middle of the box"},
};

static void add_column(Mpm *mpm, int body, int k)
{
    static const struct {
        const char *name, *unit, *meaning;
    } of_body[] = {{"x", "length", "x of the centre of mass of "},
                   {"y", "length", "y of the centre of mass of "},
                   {"vx", "length/time", "mean velocity along x of "},
                   {"vy", "length/time", "mean velocity along y of "},
                   {"spin", "rad/time", "angular momentum over moment of inertia of "},
                   {"touching", "1", "1: a wall or another body is pushed in the step by "}};
    char *name = mpm->column_names[body][k], *meaning = mpm->column_meanings[body][k];
    char of[BODY_NAME_MAX]; /* or gcc fears that the text overlaps itself */
    memcpy(of, mpm->def.bodies[body].name, sizeof of);
    snprintf(name, sizeof mpm->column_names[body][k], "%s.%s", of, of_body[k].name);
    snprintf(meaning, sizeof mpm->column_meanings[body][k], "%s%s", of_body[k].meaning, of);
    mpm->series_entry[mpm->sim.n_series] = mpm->sim.n_series;
    mpm->series[mpm->sim.n_series++] = (Quantity){name, name, of_body[k].unit, meaning};
}

void bodies_set_series(Mpm *mpm)
{
    const int n = mpm->def.n_bodies;
    Simulation *sim = &mpm->sim;
    for (int k = 0; k < BODIES_X; k++)
        mpm->series[sim->n_series++] = quantities[k];
    for (int body = 0; body < n; body++)
        for (int k = 0; k < BODY_COLUMNS; k++)
            add_column(mpm, body, k);
    /* of bodies in one field nothing shows which of them acts */
    for (int body = 0; body < n && (n == 1 || mpm->n_fields > 1); body++)
        add_column(mpm, body, BODY_TOUCHING);
    sim->series = sim->series_asked = mpm->series;
    sim->series_entry = mpm->series_entry;
}

/* Of a body: its centre, its mean velocity, its spin. */
static void write_body(const Sums *sum, double count, double *out)
{
    const double x = sum->x / count, y = sum->y / count, vx = sum->vx / count, vy = sum->vy / count;
    const double turn = sum->turn - count * (x * vy - y * vx),
                 inertia = sum->inertia - count * (x * x + y * y);
    out[0] = x, out[1] = y, out[2] = vx, out[3] = vy;
    out[4] = inertia > 0.0 ? turn / inertia : 0.0;
}

static bool is_touching(const Mpm *mpm, int body)
{
    const uint32_t *const touching = mpm->head->touching;
    bool any = touching[body] != 0;
    for (int other = 0; other < body; other++)
        any = any || touching[other] >> body & 1;
    return any;
}

void bodies_row(const Simulation *sim, double *row)
{
    const Mpm *mpm = mpm_of_const(sim);
    const MpmDef *def = &mpm->def;
    const double m = mpm->mass[0];
    double affine = 0.0;
    for (int k = 0; k < BODIES_X; k++)
        row[k] = 0.0;
    for (int body = 0; body < def->n_bodies; body++) {
        const int first = mpm->first[body], end = mpm->first[body + 1];
        const Sums sum = sum_particles(mpm, first, end);
        row[BODIES_KINETIC] += 0.5 * m * sum.squares;
        row[BODIES_STRAIN] += sum.strain;
        row[BODIES_POTENTIAL] -= m * (def->gravity[0] * sum.x + def->gravity[1] * sum.y);
        row[BODIES_MOMENTUM_X] += m * sum.vx;
        row[BODIES_MOMENTUM_Y] += m * sum.vy;
        row[BODIES_ANGULAR] += m * (sum.turn - 0.5 * (def->length * sum.vy - def->height * sum.vx));
        affine += m * sum.affine;
        write_body(&sum, end - first, row + BODIES_X + body * BODY_COLUMNS);
    }
    if (mpm->head->transfer == MPM_APIC)
        row[BODIES_ANGULAR] += affine;
    row[BODIES_FRICTION] = mpm->head->friction;
    row[BODIES_TOTAL] =
        row[BODIES_KINETIC] + row[BODIES_STRAIN] + row[BODIES_POTENTIAL] + row[BODIES_FRICTION];
}

void bodies_write_row(const Mpm *mpm, double *row)
{
    const int first = BODIES_X + mpm->def.n_bodies * BODY_COLUMNS;
    bodies_row(&mpm->sim, row);
    for (int k = first; k < mpm->sim.n_series; k++)
        row[k] = is_touching(mpm, mpm->series_entry[k] - first);
}

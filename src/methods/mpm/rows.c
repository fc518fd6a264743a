/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Energies and the row of the series: sums over all particles and nodes, of a bar per unit cross-section, of
 * bodies per unit thickness, of a beam (b its thickness) without its common speed v0,
 *
 *     x_cm_rate     d(x_cm)/dt of the last step, sum m sum N_i v_i / M with v_i of eq. 15; before the first
 *                   step of the momenta that no force has changed yet
 *     kinetic       sum m v^2 / 2, with APIC + sum m D C^2 / 2, D = sum N (x_i - x)^2; b sum m |v - v0|^2/2
 *     kinetic_grid  sum p_i^2 / (2 m_i) of the particles mapped as in the first stage, supports applied;
 *                   b sum |p_i - m_i v0|^2/(2 m_i) over what nothing holds
 *     kinetic_null  the part in modes that the grid does not see (null.c, plane_null.c)
 *     strain        sum stress^2 volume / (2 E);
 *                   b sum ((sxx^2 + syy^2 - 2 nu sxx syy)/2E + sxy^2/2G) m/rho,  G = E/(2 (1 + nu))
 *
 * Rate, grid and null space are left out where nobody asks for them: the latter two need the grid, and the
 * last takes longer than the step. A row is taken between steps, when velocities and stresses of USF are half
 * a step apart: kinetic + strain ripples by about omega dt/2 of itself though nothing is lost (E* of
 * problems/ is the sum without ripple), of a beam worst where thickness modes ring. stress^2/2E is the energy
 * of small strains; where particles cross cells, strains are large enough to tell it from
 * E (1 + (e - 1) exp(e)), e = stress/E, which is what the updates of stress and density really store. kinetic
 * less kinetic_grid is not all hidden: lumped masses see even a smooth mode with too little energy (1.7e-3 of
 * it at 4 cells in the height of a beam, 4e-4 at 8).
 *
 * Of bodies strain is sum V stress : D^-1 stress/2 (hypoelastic: no potential, only nearly kept) or
 * sum V0 (G (tr F F^T - 2)/2 - G ln J + lambda (ln J)^2/2) (neo-Hookean), the angular momentum, about the
 * middle of the box, with APIC sum m ((x - c) x v + B_yx - B_xy), a body's own spin without B. */
#include "base/assertion.h"
#include "base/math/functions.h"
#include "methods/axial.h"
#include "methods/mpm/mistakes.h"

#include <stdio.h>
#include <string.h>

/* A sum over particles [first, end) is made of four, which are added in their order. Does something for each
 * particle p and its sum `lane`. */
enum { LANES = 4 };
#define IN_LANES(first, end, ...)                                                                            \
    do {                                                                                                     \
        int block = first;                                                                                   \
        for (; block + LANES <= (end); block += LANES)                                                       \
            for (int lane = 0, p = block; lane < LANES; lane++, p++)                                         \
                __VA_ARGS__                                                                                  \
        for (int lane = 0, p = block; p < (end); lane++, p++)                                                \
            __VA_ARGS__                                                                                      \
    } while (0)

static double fold(const double *lanes)
{
    return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

/* One material after the other. */
double mpm_sum(const Mpm *mpm, const double *a)
{
    double first[LANES] = {0}, second[LANES] = {0};
    IN_LANES(0, mpm->joint, first[lane] += a[p];);
    IN_LANES(mpm->joint, mpm->n_particles, second[lane] += a[p];);
    return mpm->mass[0] * fold(first) + mpm->mass[1] * fold(second);
}

/* Of a beam in plane stress s.D^-1 s/2 times its volume, J. */
double mpm_strain_at(const Mpm *mpm, int p)
{
    ASSERT_INDEX(p, mpm->n_particles);
    const MpmDef *def = &mpm->def;
    const double xx = mpm->stress[0][p], yy = mpm->stress[1][p], xy = mpm->stress[2][p], G = mpm->shear;
    if (bodies_are_neo(mpm)) {
        const double F[4] = {mpm->deformation[0][p], mpm->deformation[1][p], mpm->deformation[2][p],
                             mpm->deformation[3][p]};
        const double trace = F[0] * F[0] + F[1] * F[1] + F[2] * F[2] + F[3] * F[3];
        const double swell = math_log(F[0] * F[3] - F[1] * F[2]);
        return mpm->volume_start * (0.5 * G * (trace - 2.0) - G * swell + 0.5 * mpm->lambda * swell * swell);
    }
    if (mpm->bodies) {
        const double whole = mpm->D11 * mpm->D11 - mpm->D12 * mpm->D12;
        const double direct = (mpm->D11 * (xx * xx + yy * yy) - 2.0 * mpm->D12 * (xx * yy)) / whole;
        return 0.5 * mpm->volume[p] * (direct + xy * xy / G);
    }
    const double direct = xx * xx + yy * yy - 2 * def->poisson * (xx * yy);
    return (direct / (2 * def->youngs_modulus) + xy * xy / (2 * G)) * mpm->volume[p] * def->thickness;
}

typedef struct Energies {
    double kinetic, strain;
} Energies;

/* Of beams and bodies without the common speed; of bars a material after the other, and with APIC the energy
 * of its affine motion, sum m D C^2/2 with D = sum N_i d_i^2, d_i = x_i - x. */
static Energies energies_of(const Mpm *mpm)
{
    Energies sums = {0};
    for (int p = 0; mpm->dim == 2 && p < mpm->n_particles; p++) {
        const double vx = mpm->v[0][p] - mpm->speed, vy = mpm->v[1][p];
        sums.kinetic += vx * vx + vy * vy;
        sums.strain += mpm_strain_at(mpm, p);
    }
    sums.kinetic *= mpm->mass[0] / 2 * mpm->def.thickness;
    for (int k = 0; mpm->dim == 1 && k < (mpm->joint < mpm->n_particles ? 2 : 1); k++) {
        const int first = k * mpm->joint, end = k ? mpm->n_particles : mpm->joint;
        const double *const v = mpm->v[0], *const stress = mpm->stress[0], *const volume = mpm->volume;
        double squares[LANES] = {0}, strain[LANES] = {0};
        IN_LANES(first, end, {
            squares[lane] += v[p] * v[p];
            strain[lane] += stress[p] * stress[p] * volume[p];
        });
        sums.kinetic += 0.5 * mpm->mass[k] * fold(squares);
        sums.strain += fold(strain) / (2.0 * mpm->modulus[k]);
    }
    const bool affine = mpm->head->transfer == MPM_APIC && !mpm_does(mpm, WRONG_PLAIN_KINETIC);
    for (int p = 0; mpm->dim == 1 && affine && p < mpm->n_particles; p++) {
        const MpmWeights w = mpm_weights_of(mpm, p);
        const double speed = mpm->affine[p] * mpm->dx;
        double spread = 0.0;
        for (int a = 0; a < mpm->support; a++) {
            const double arm =
                shape_node_offset(mpm->shape, mpm->half, mpm->cells, mpm->base[p], a) - mpm->s[0][p];
            spread += w.n[0][a] * (arm * arm);
        }
        sums.kinetic += 0.5 * mpm_mass(mpm, p) * (spread * (speed * speed));
    }
    return sums;
}

double mpm_energy(const Mpm *mpm)
{
    const Energies sums = energies_of(mpm);
    return sums.kinetic + sums.strain;
}

/* Supports are the only thing beside the loads that changes the particles' momentum: what is internal adds up
 * to 0. */
static double reaction(const Mpm *mpm, int axis)
{
    const double now = mpm_sum(mpm, mpm->v[axis]),
                 before = mpm->sim.step > 0 ? mpm->head->momentum[axis] : now;
    return mpm->def.thickness * ((now - before) / mpm->dt - (axis == 0 ? mpm->head->pushed : 0.0));
}

/* The probe is the mean of up to four particles beside the point. */
static double probe(const Mpm *mpm, const double *of)
{
    const int *const at = mpm->probe;
    return (of[at[0]] + of[at[1]] + of[at[2]] + of[at[3]]) / 4.0;
}

/* What the columns of a row are worked out from. */
typedef struct Now {
    const Mpm *mpm;
    Energies sums;
    bool whole;
} Now;

/* A column that is one expression of it. */
#define COLUMN(name, value)                                                                                  \
    static double name(const Now *now)                                                                       \
    {                                                                                                        \
        const Mpm *const mpm = now->mpm;                                                                     \
        (void)mpm;                                                                                           \
        return value;                                                                                        \
    }

COLUMN(v_cm, mpm_sum(mpm, mpm->v[0]) / mpm->whole_mass)
COLUMN(x_cm, mpm->x_cm_start + mpm_sum(mpm, mpm->u[0]) / mpm->whole_mass)
COLUMN(u_probe, probe(mpm, mpm->u[1]))
COLUMN(v_probe, probe(mpm, mpm->v[1]))
COLUMN(length, mpm->def.length + mpm->def.speed * simulation_time(&mpm->sim))
COLUMN(kinetic, now->sums.kinetic)
COLUMN(strain, now->sums.strain)
COLUMN(work, mpm->head->work)
COLUMN(total, now->sums.kinetic + now->sums.strain)
COLUMN(momentum_x, mpm_sum(mpm, mpm->v[0]) * mpm->def.thickness)
COLUMN(momentum_y, mpm_sum(mpm, mpm->v[1]) * mpm->def.thickness)
COLUMN(reaction_x, reaction(mpm, 0))
COLUMN(reaction_y, reaction(mpm, 1))

static double x_cm_rate(const Now *now)
{
    const Mpm *mpm = now->mpm;
    double momentum = 0.0;
    if (mpm->sim.step > 0)
        return (mpm_sum(mpm, mpm->u[0]) - mpm->head->moment) / (mpm->whole_mass * mpm->dt);
    for (int i = 0; i < mpm->n_nodes; i++)
        momentum += mpm->node_mass[i] * mpm->velocity[0][i];
    return momentum / mpm->whole_mass;
}

/* The energy that lumped masses see, of velocities over a beam's common one. Held components of a beam are at
 * rest in its frame: p = m v0 there, and 0 across. A node of no mass has 1/m = 0 and no share. */
static double kinetic_grid(const Now *now)
{
    const Mpm *mpm = now->mpm;
    double sum = 0.0;
    for (int i = 0; i < mpm->n_nodes; i++)
        for (int axis = 0; axis < mpm->dim; axis++) {
            const double p = mpm->momentum[axis][i] - mpm->node_mass[i] * (axis == 0 ? mpm->speed : 0.0);
            if (mpm->dim == 1 || mpm->free[axis][i] != 0.0)
                sum += p * p * mpm->inverse[i];
        }
    return 0.5 * sum * mpm->def.thickness;
}

/* Of a beam it takes several times as long as a step: only in a row that is whole and due. */
static double kinetic_null(const Now *now)
{
    const Mpm *mpm = now->mpm;
    const bool is_due = mpm->sim.whole_rows == 0 || mpm->sim.step % mpm->sim.whole_rows == 0;
    return mpm->dim == 1          ? mpm_line_null_energy(mpm)
           : now->whole && is_due ? plane_null_energy(mpm, now->sums.kinetic)
                                  : NAN;
}

/* In their order. Those of bodies are numbers of mpm_row_of_bodies(). */
#define ROW(of, value, ...)                                                                                  \
    {                                                                                                        \
        of, value,                                                                                           \
        {                                                                                                    \
            __VA_ARGS__                                                                                      \
        }                                                                                                    \
    }
#define NOT_OF_GRID                                                                                          \
    "the part of it that no velocities of the grid can give: the rest is seen, or lost to lumped masses"
static const struct {
    MpmProblem of;
    double (*value)(const Now *);
    Quantity quantity;
} columns[] = {
    ROW(MPM_BAR, v_cm, AXIAL_V_CM),
    ROW(MPM_BAR, x_cm, AXIAL_X_CM),
    ROW(MPM_BAR, x_cm_rate, "x_cm_rate", "d(x_cm)/dt", "length/time",
        "rate of x_cm in the last step: particles move with the nodes, and not with their own velocities"),
    ROW(MPM_BAR, kinetic, AXIAL_KINETIC),
    ROW(MPM_BAR, kinetic_grid, "kinetic_grid", "seen by grid", "force/length",
        "the part of it that the grid sees: sum p^2/(2m) of the nodes, boundary applied"),
    ROW(MPM_BAR, kinetic_null, "kinetic_null", "null space", "force/length", NOT_OF_GRID),
    ROW(MPM_BAR, strain, "strain", "strain", "force/length", "strain energy of the particles"),
    ROW(MPM_BAR, work, AXIAL_WORK),
    ROW(MPM_BAR, total, AXIAL_TOTAL),
    ROW(MPM_BAR, momentum_x, AXIAL_MOMENTUM),
    ROW(MPM_BAR, reaction_x, AXIAL_REACTION " in the last step"),
    ROW(MPM_BEAM, u_probe, "u_probe", "u", "m", "transverse displacement at the probe"),
    ROW(MPM_BEAM, v_probe, "v_probe", "v", "m/s", "transverse velocity at the probe"),
    ROW(MPM_BEAM, length, "length", "length", "m", "length outside the channel, L0 + v0 t"),
    ROW(MPM_BEAM, kinetic, "kinetic", "kinetic", "J",
        "kinetic energy of the particles, without the common speed"),
    ROW(MPM_BEAM, kinetic_grid, "kinetic_grid", "seen by grid", "J",
        "the part of it that the grid sees: sum p^2/(2m) of the nodes, supports applied"),
    ROW(MPM_BEAM, kinetic_null, "kinetic_null", "null space", "J", NOT_OF_GRID),
    ROW(MPM_BEAM, strain, "strain", "strain", "J", "strain energy of the particles"),
    ROW(MPM_BEAM, work, "work", "work", "J", "work of the channel, which draws the beam out"),
    ROW(MPM_BEAM, total, "total", "total", "J",
        "kinetic + strain; it ripples, as the two are half a step apart"),
    ROW(MPM_BEAM, momentum_x, "momentum_x", "momentum x", "kg m/s", "momentum of all particles along x"),
    ROW(MPM_BEAM, momentum_y, "momentum_y", "momentum y", "kg m/s", "momentum of all particles along y"),
    ROW(MPM_BEAM, reaction_x, "reaction_x", "reaction x", "N",
        "force of what holds the beam, along x, in the last step"),
    ROW(MPM_BEAM, reaction_y, "reaction_y", "reaction y", "N",
        "force of what holds the beam, along y, in the last step"),
    ROW(MPM_BODIES, NULL, "kinetic", "kinetic", "force*length", "kinetic energy of the particles"),
    ROW(MPM_BODIES, NULL, "strain", "strain", "force*length", "strain energy of the particles"),
    ROW(MPM_BODIES, NULL, "potential", "potential", "force*length",
        "potential energy in the field of gravity, 0 at the origin"),
    ROW(MPM_BODIES, NULL, "friction", "friction", "force*length",
        "energy that friction at walls and in contact has taken"),
    ROW(MPM_BODIES, NULL, "total", "total", "force*length", "kinetic + strain + potential + friction"),
    ROW(MPM_BODIES, NULL, "momentum_x", "momentum x", "mass*length/time", "momentum of all bodies along x"),
    ROW(MPM_BODIES, NULL, "momentum_y", "momentum y", "mass*length/time", "momentum of all bodies along y"),
    ROW(MPM_BODIES, NULL, "angular", "angular mom.", "mass*length^2/time",
        "angular momentum about the middle of the box"),
};
enum { COLUMNS = sizeof columns / sizeof *columns }; /* from here on BODY_TOUCHING + 1 entries of each body */

static void add_column_of_body(Mpm *mpm, int body, int k)
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
    simulation_add_column(&mpm->sim, COLUMNS + body * (BODY_TOUCHING + 1) + k,
                          (Quantity){name, name, of_body[k].unit, meaning});
}

void mpm_set_series(Mpm *mpm)
{
    const int n = mpm->bodies ? mpm->def.n_bodies : 0;
    for (int k = 0; k < COLUMNS; k++) {
        double (*const value)(const Now *) = columns[k].value;
        if (columns[k].of == mpm->def.problem &&
            (value != reaction_x || mpm->dim == 2 || mpm->fixed_left > 0 || mpm->fixed_right > 0) &&
            (value != length || mpm->def.leaves_channel) &&
            (value != kinetic_null || mpm->dim == 1 || plane_null_pays(mpm)))
            simulation_add_column(&mpm->sim, k, columns[k].quantity);
    }
    for (int body = 0; body < n; body++)
        for (int k = 0; k < BODY_COLUMNS; k++)
            add_column_of_body(mpm, body, k);
    /* of bodies in one field nothing shows which of them acts */
    for (int body = 0; body < n && (n == 1 || mpm->n_fields > 1); body++)
        add_column_of_body(mpm, body, BODY_TOUCHING);
}

const char *const mpm_on_request[] = {"x_cm_rate",  "kinetic_grid", "kinetic_null", "momentum",   "reaction",
                                      "momentum_x", "momentum_y",   "reaction_x",   "reaction_y", NULL};

static bool has_column(const Mpm *mpm, double (*value)(const Now *))
{
    for (int k = 0; k < mpm->sim.n_series && !mpm->bodies; k++)
        if (columns[mpm->sim.series_entry[k]].value == value)
            return true;
    return false;
}

bool mpm_row_needs_grid(const Mpm *mpm)
{
    return has_column(mpm, kinetic_grid) || has_column(mpm, kinetic_null) ||
           (has_column(mpm, x_cm_rate) && mpm->sim.step == 0);
}

bool mpm_row_has_rates(const Mpm *mpm)
{
    return has_column(mpm, x_cm_rate) || has_column(mpm, reaction_x) || has_column(mpm, reaction_y);
}

void mpm_row_of_bodies(const Simulation *sim, double *row)
{
    const Mpm *mpm = mpm_of_const(sim);
    const MpmDef *def = &mpm->def;
    const double m = mpm->mass[0];
    double affine = 0.0;
    for (int k = 0; k < BODIES_X; k++)
        row[k] = 0.0;
    for (int body = 0; body < def->n_bodies; body++) {
        const double count = mpm->first[body + 1] - mpm->first[body];
        double sum[4] = {0}, squares = 0.0, strain = 0.0, gained = 0.0;
        double turn = 0.0, inertia = 0.0; /* sum x v_y - y v_x, sum x^2 + y^2 */
        for (int p = mpm->first[body]; p < mpm->first[body + 1]; p++) {
            const double x = mpm->at[0][p] + mpm->u[0][p], y = mpm->at[1][p] + mpm->u[1][p];
            const double vx = mpm->v[0][p], vy = mpm->v[1][p], values[] = {x, y, vx, vy};
            for (int k = 0; k < 4; k++)
                sum[k] += values[k];
            turn += x * vy - y * vx;
            inertia += x * x + y * y;
            squares += vx * vx + vy * vy;
            strain += mpm_strain_at(mpm, p);
            gained += mpm->rate[2][p] - mpm->rate[1][p];
        }
        row[BODIES_KINETIC] += 0.5 * m * squares;
        row[BODIES_STRAIN] += strain;
        row[BODIES_POTENTIAL] -= m * (def->gravity[0] * sum[0] + def->gravity[1] * sum[1]);
        row[BODIES_MOMENTUM_X] += m * sum[2];
        row[BODIES_MOMENTUM_Y] += m * sum[3];
        row[BODIES_ANGULAR] += m * (turn - 0.5 * (def->length * sum[3] - def->height * sum[2]));
        affine += m * gained;
        /* its centre, its mean velocity, its spin */
        double *const own = row + BODIES_X + body * BODY_COLUMNS;
        for (int k = 0; k < 4; k++)
            own[k] = sum[k] / count;
        turn -= count * (own[0] * own[3] - own[1] * own[2]);
        inertia -= count * (own[0] * own[0] + own[1] * own[1]);
        own[4] = inertia > 0.0 ? turn / inertia : 0.0;
    }
    if (mpm->head->transfer == MPM_APIC)
        row[BODIES_ANGULAR] += affine;
    row[BODIES_FRICTION] = mpm->head->friction;
    row[BODIES_TOTAL] =
        row[BODIES_KINETIC] + row[BODIES_STRAIN] + row[BODIES_POTENTIAL] + row[BODIES_FRICTION];
}

void mpm_write_row(const Mpm *mpm, double *row, bool whole)
{
    if (!mpm->bodies) {
        const Now now = {mpm, energies_of(mpm), whole};
        for (int k = 0; k < mpm->sim.n_series; k++)
            row[k] = columns[mpm->sim.series_entry[k]].value(&now);
        return;
    }
    const uint32_t *const touching = mpm->head->touching;
    mpm_row_of_bodies(&mpm->sim, row);
    for (int k = BODIES_X + mpm->def.n_bodies * BODY_COLUMNS; k < mpm->sim.n_series; k++) {
        const int body = (mpm->sim.series_entry[k] - COLUMNS) / (BODY_TOUCHING + 1);
        bool any = touching[body] != 0;
        for (int other = 0; other < body; other++)
            any = any || touching[other] >> body & 1;
        row[k] = any;
    }
}

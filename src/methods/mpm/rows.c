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
 * Of bodies
 *
 *     kinetic    sum m v^2/2
 *     strain     sum V stress : D^-1 stress/2 (hypoelastic: no potential, only nearly kept), or
 *                sum V0 (G (tr F F^T - 2)/2 - G ln J + lambda (ln J)^2/2) (neo-Hookean)
 *     potential  -sum m g . x
 *     friction   what walls and contact took by it
 *     angular    about the middle of the box: sum m (x - c) x v, with APIC + sum m (B_yx - B_xy)
 *     NAME.spin  the body's own angular momentum, without B, over its own moment of inertia */
#include "base/assertion.h"
#include "base/math/functions.h"
#include "methods/axial.h"
#include "methods/mpm/mistakes.h"

#include <stdio.h>
#include <string.h>

/* sum m D C^2 / 2 with D = sum N_i d_i^2, d_i = x_i - x: the energy of APIC's affine motion. */
static double affine_energy(const Mpm *mpm, int p)
{
    double n[SHAPE_SUPPORT_MAX], slopes[SHAPE_SUPPORT_MAX], spread = 0.0;
    const int base = mpm->base[p];
    shape_at(mpm->shape, mpm_half(mpm, p), mpm->cells, base, mpm->s[0][p], n, slopes);
    for (int a = 0; a < mpm->support; a++) {
        const double arm = shape_node_offset(mpm->shape, mpm->half, mpm->cells, base, a) - mpm->s[0][p];
        spread += n[a] * (arm * arm);
    }
    const double speed = mpm->affine[p] * mpm->dx;
    return 0.5 * mpm_mass(mpm, p) * (spread * (speed * speed));
}

/* sum m a over particles [first, end) of one material */
static double sum_material(const Mpm *mpm, const double *a, int which, int first, int end)
{
    double sum[MPM_LANES] = {0};
    int p = first;
    for (; p + MPM_LANES <= end; p += MPM_LANES)
        for (int lane = 0; lane < MPM_LANES; lane++)
            sum[lane] += a[p + lane];
    for (int lane = 0; p + lane < end; lane++)
        sum[lane] += a[p + lane];
    return mpm->mass[which] * mpm_fold(sum);
}

double mpm_sum(const Mpm *mpm, const double *a)
{
    const double first = sum_material(mpm, a, 0, 0, mpm->joint);
    return mpm->joint < mpm->n_particles ? first + sum_material(mpm, a, 1, mpm->joint, mpm->n_particles)
                                         : first;
}

typedef struct Energies {
    double kinetic, strain;
} Energies;

/* Of particles [first, end) of one material, along a line. */
static Energies energies_of_material(const Mpm *mpm, int which, int first, int end)
{
    double squares[MPM_LANES] = {0}, strain[MPM_LANES] = {0};
    const double *const v = mpm->v[0], *const stress = mpm->stress[0], *const volume = mpm->volume;
    int p = first;
    for (; p + MPM_LANES <= end; p += MPM_LANES)
        for (int lane = 0; lane < MPM_LANES; lane++) {
            squares[lane] += v[p + lane] * v[p + lane];
            strain[lane] += stress[p + lane] * stress[p + lane] * volume[p + lane];
        }
    for (int lane = 0; p + lane < end; lane++) {
        squares[lane] += v[p + lane] * v[p + lane];
        strain[lane] += stress[p + lane] * stress[p + lane] * volume[p + lane];
    }
    return (Energies){0.5 * mpm->mass[which] * mpm_fold(squares),
                      mpm_fold(strain) / (2.0 * mpm->modulus[which])};
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

/* Sums over some particles of bodies. */
typedef struct BodySums {
    double x, y, vx, vy, turn, inertia; /* sum x, ..., sum x v_y - y v_x, sum x^2 + y^2 */
    double squares, strain, affine;     /* sum v^2, strain energies, sum B_yx - B_xy */
} BodySums;

static BodySums sum_bodies(const Mpm *mpm, int first, int end)
{
    BodySums sum = {0};
    for (int p = first; p < end; p++) {
        const double x = mpm->at[0][p] + mpm->u[0][p], y = mpm->at[1][p] + mpm->u[1][p];
        const double vx = mpm->v[0][p], vy = mpm->v[1][p];
        sum.x += x, sum.y += y, sum.vx += vx, sum.vy += vy;
        sum.turn += x * vy - y * vx;
        sum.inertia += x * x + y * y;
        sum.squares += vx * vx + vy * vy;
        sum.strain += mpm_strain_at(mpm, p);
        sum.affine += mpm->rate[2][p] - mpm->rate[1][p];
    }
    return sum;
}

/* Of beams and bodies, without the common speed. */
static Energies energies_in_plane(const Mpm *mpm)
{
    Energies sums = {0};
    for (int p = 0; p < mpm->n_particles; p++) {
        const double vx = mpm->v[0][p] - mpm->speed, vy = mpm->v[1][p];
        sums.kinetic += vx * vx + vy * vy;
        sums.strain += mpm_strain_at(mpm, p);
    }
    sums.kinetic *= mpm->mass[0] / 2 * mpm->def.thickness;
    return sums;
}

static Energies energies_of(const Mpm *mpm)
{
    if (mpm->dim == 2)
        return energies_in_plane(mpm);
    Energies sums = energies_of_material(mpm, 0, 0, mpm->joint);
    if (mpm->joint < mpm->n_particles) {
        const Energies more = energies_of_material(mpm, 1, mpm->joint, mpm->n_particles);
        sums.kinetic += more.kinetic;
        sums.strain += more.strain;
    }
    const bool affine = mpm->head->transfer == MPM_APIC && !mpm_does(mpm, WRONG_PLAIN_KINETIC);
    for (int p = 0; affine && p < mpm->n_particles; p++)
        sums.kinetic += affine_energy(mpm, p);
    return sums;
}

double mpm_energy(const Mpm *mpm)
{
    const Energies sums = energies_of(mpm);
    return sums.kinetic + sums.strain;
}

/* The energy that lumped masses see, of velocities over a beam's common one. Held components of a beam are at
 * rest in its frame: p = m v0 there, and 0 across. A node of no mass has 1/m = 0 and no share. */
static double kinetic_grid(const Mpm *mpm)
{
    double sum = 0.0;
    for (int i = 0; i < mpm->n_nodes; i++)
        for (int axis = 0; axis < mpm->dim; axis++) {
            const double p = mpm->momentum[axis][i] - mpm->node_mass[i] * (axis == 0 ? mpm->speed : 0.0);
            if (mpm->dim == 1 || mpm->free[axis][i] != 0.0)
                sum += p * p * mpm->inverse[i];
        }
    return 0.5 * sum * mpm->def.thickness;
}

static double rate_of_centre(const Mpm *mpm)
{
    double momentum = 0.0;
    if (mpm->sim.step > 0)
        return (mpm_sum(mpm, mpm->u[0]) - mpm->head->moment) / (mpm->whole_mass * mpm->dt);
    for (int i = 0; i < mpm->n_nodes; i++)
        momentum += mpm->node_mass[i] * mpm->velocity[0][i];
    return momentum / mpm->whole_mass;
}

/* Supports are the only thing beside the loads that changes the particles' momentum: what is internal adds up
 * to 0. */
static double reaction(const Mpm *mpm, int axis)
{
    const double now = mpm_sum(mpm, mpm->v[axis]),
                 before = mpm->sim.step > 0 ? mpm->head->momentum[axis] : now;
    return (now - before) / mpm->dt - (axis == 0 ? mpm->head->pushed : 0.0);
}

/* The probe is the mean of up to four particles beside the point. */
static double probe(const Mpm *mpm, const double *values)
{
    double sum = 0.0;
    for (int k = 0; k < 4; k++)
        sum += values[mpm->probe[k]];
    return sum / 4.0;
}

typedef enum Entry {
    V_CM,
    X_CM,
    X_CM_RATE,
    U_PROBE,
    V_PROBE,
    LENGTH,
    KINETIC,
    KINETIC_GRID,
    KINETIC_NULL,
    STRAIN,
    POTENTIAL,
    FRICTION,
    WORK,
    TOTAL,
    MOMENTUM_X,
    MOMENTUM_Y,
    REACTION_X,
    REACTION_Y,
    ANGULAR,
    OF_BODIES /* from here on BODY_TOUCHING + 1 of each body */
} Entry;

/* In the order of the columns. */
static const struct {
    MpmProblem of;
    Entry entry;
    Quantity quantity;
} columns[] = {
    {MPM_BAR, V_CM, {AXIAL_V_CM}},
    {MPM_BAR, X_CM, {AXIAL_X_CM}},
    {MPM_BAR,
     X_CM_RATE,
     {"x_cm_rate", "d(x_cm)/dt", "length/time",
      "rate of x_cm in the last step: particles move with the nodes, and not with their own velocities"}},
    {MPM_BAR, KINETIC, {AXIAL_KINETIC}},
    {MPM_BAR,
     KINETIC_GRID,
     {"kinetic_grid", "seen by grid", "force/length",
      "the part of it that the grid sees: sum p^2/(2m) of the nodes, boundary applied"}},
    {MPM_BAR,
     KINETIC_NULL,
     {"kinetic_null", "null space", "force/length",
      "the part of it that no velocities of the grid can give: the rest is seen, or lost to lumped masses"}},
    {MPM_BAR, STRAIN, {"strain", "strain", "force/length", "strain energy of the particles"}},
    {MPM_BAR, WORK, {AXIAL_WORK}},
    {MPM_BAR, TOTAL, {AXIAL_TOTAL}},
    {MPM_BAR, MOMENTUM_X, {AXIAL_MOMENTUM}},
    {MPM_BAR, REACTION_X, {AXIAL_REACTION " in the last step"}},
    {MPM_BEAM, U_PROBE, {"u_probe", "u", "m", "transverse displacement at the probe"}},
    {MPM_BEAM, V_PROBE, {"v_probe", "v", "m/s", "transverse velocity at the probe"}},
    {MPM_BEAM, LENGTH, {"length", "length", "m", "length outside the channel, L0 + v0 t"}},
    {MPM_BEAM,
     KINETIC,
     {"kinetic", "kinetic", "J", "kinetic energy of the particles, without the common speed"}},
    {MPM_BEAM,
     KINETIC_GRID,
     {"kinetic_grid", "seen by grid", "J",
      "the part of it that the grid sees: sum p^2/(2m) of the nodes, supports applied"}},
    {MPM_BEAM,
     KINETIC_NULL,
     {"kinetic_null", "null space", "J",
      "the part of it that no velocities of the grid can give: the rest is seen, or lost to "
      "lumped masses"}},
    {MPM_BEAM, STRAIN, {"strain", "strain", "J", "strain energy of the particles"}},
    {MPM_BEAM, WORK, {"work", "work", "J", "work of the channel, which draws the beam out"}},
    {MPM_BEAM,
     TOTAL,
     {"total", "total", "J", "kinetic + strain; it ripples, as the two are half a step apart"}},
    {MPM_BEAM, MOMENTUM_X, {"momentum_x", "momentum x", "kg m/s", "momentum of all particles along x"}},
    {MPM_BEAM, MOMENTUM_Y, {"momentum_y", "momentum y", "kg m/s", "momentum of all particles along y"}},
    {MPM_BEAM,
     REACTION_X,
     {"reaction_x", "reaction x", "N", "force of what holds the beam, along x, in the last step"}},
    {MPM_BEAM,
     REACTION_Y,
     {"reaction_y", "reaction y", "N", "force of what holds the beam, along y, in the last step"}},
    {MPM_BODIES, KINETIC, {"kinetic", "kinetic", "force*length", "kinetic energy of the particles"}},
    {MPM_BODIES, STRAIN, {"strain", "strain", "force*length", "strain energy of the particles"}},
    {MPM_BODIES,
     POTENTIAL,
     {"potential", "potential", "force*length", "potential energy in the field of gravity, 0 at the origin"}},
    {MPM_BODIES,
     FRICTION,
     {"friction", "friction", "force*length", "energy that friction at walls and in contact has taken"}},
    {MPM_BODIES, TOTAL, {"total", "total", "force*length", "kinetic + strain + potential + friction"}},
    {MPM_BODIES,
     MOMENTUM_X,
     {"momentum_x", "momentum x", "mass*length/time", "momentum of all bodies along x"}},
    {MPM_BODIES,
     MOMENTUM_Y,
     {"momentum_y", "momentum y", "mass*length/time", "momentum of all bodies along y"}},
    {MPM_BODIES,
     ANGULAR,
     {"angular", "angular mom.", "mass*length^2/time", "angular momentum about the middle of the box"}},
};

/* Whether the run has such a thing. */
static bool is_there(const Mpm *mpm, Entry entry)
{
    return entry == REACTION_X     ? mpm->dim == 2 || mpm->fixed_left > 0 || mpm->fixed_right > 0
           : entry == LENGTH       ? mpm->def.leaves_channel
           : entry == KINETIC_NULL ? mpm->dim == 1 || plane_null_pays(mpm)
                                   : true;
}

static void add_column(Mpm *mpm, int entry, const Quantity *quantity)
{
    mpm->series_entry[mpm->sim.n_series] = entry;
    mpm->series[mpm->sim.n_series++] = *quantity;
}

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
    add_column(mpm, OF_BODIES + body * (BODY_TOUCHING + 1) + k,
               &(Quantity){name, name, of_body[k].unit, meaning});
}

void mpm_set_series(Mpm *mpm)
{
    const int n = mpm->bodies ? mpm->def.n_bodies : 0;
    for (size_t k = 0; k < sizeof columns / sizeof *columns; k++)
        if (columns[k].of == mpm->def.problem && is_there(mpm, columns[k].entry))
            add_column(mpm, (int)columns[k].entry, &columns[k].quantity);
    for (int body = 0; body < n; body++)
        for (int k = 0; k < BODY_COLUMNS; k++)
            add_column_of_body(mpm, body, k);
    /* of bodies in one field nothing shows which of them acts */
    for (int body = 0; body < n && (n == 1 || mpm->n_fields > 1); body++)
        add_column_of_body(mpm, body, BODY_TOUCHING);
    mpm->sim.series = mpm->sim.series_asked = mpm->series;
    mpm->sim.series_entry = mpm->series_entry;
}

const char *const mpm_on_request[] = {"x_cm_rate",  "kinetic_grid", "kinetic_null", "momentum",   "reaction",
                                      "momentum_x", "momentum_y",   "reaction_x",   "reaction_y", NULL};

static bool has_column(const Mpm *mpm, Entry entry)
{
    for (int k = 0; k < mpm->sim.n_series; k++)
        if (mpm->series_entry[k] == (int)entry)
            return true;
    return false;
}

bool mpm_row_needs_grid(const Mpm *mpm)
{
    return has_column(mpm, KINETIC_GRID) || has_column(mpm, KINETIC_NULL) ||
           (has_column(mpm, X_CM_RATE) && mpm->sim.step == 0);
}

bool mpm_row_has_rates(const Mpm *mpm)
{
    return has_column(mpm, X_CM_RATE) || has_column(mpm, REACTION_X) || has_column(mpm, REACTION_Y);
}

/* Of a beam kinetic_null takes several times as long as a step: only in a row that is whole and due. */
static double null_energy(Mpm *mpm, double kinetic, bool whole)
{
    const bool is_due = mpm->sim.whole_rows == 0 || mpm->sim.step % mpm->sim.whole_rows == 0;
    return mpm->dim == 1     ? mpm_line_null_energy(mpm)
           : whole && is_due ? plane_null_energy(mpm, kinetic)
                             : NAN;
}

static double value_of(Mpm *mpm, Entry entry, const Energies *sums, bool whole)
{
    const int axis = entry == MOMENTUM_Y || entry == REACTION_Y;
    switch (entry) {
    case V_CM:
        return mpm_sum(mpm, mpm->v[0]) / mpm->whole_mass;
    case X_CM:
        return mpm->x_cm_start + mpm_sum(mpm, mpm->u[0]) / mpm->whole_mass;
    case X_CM_RATE:
        return rate_of_centre(mpm);
    case KINETIC:
        return sums->kinetic;
    case KINETIC_GRID:
        return kinetic_grid(mpm);
    case KINETIC_NULL:
        return null_energy(mpm, sums->kinetic, whole);
    case STRAIN:
        return sums->strain;
    case WORK:
        return mpm->head->work;
    case TOTAL:
        return sums->kinetic + sums->strain;
    case MOMENTUM_X:
    case MOMENTUM_Y:
        return mpm->def.thickness * mpm_sum(mpm, mpm->v[axis]);
    case REACTION_X:
    case REACTION_Y:
        return mpm->def.thickness * reaction(mpm, axis);
    case U_PROBE:
        return probe(mpm, mpm->u[1]);
    case V_PROBE:
        return probe(mpm, mpm->v[1]);
    case LENGTH:
        return mpm->def.length + mpm->def.speed * simulation_time(&mpm->sim);
    default: /* those of bodies: mpm_row_of_bodies() */
        return NAN;
    }
}

/* Of a body: its centre, its mean velocity, its spin. */
static void write_body(const BodySums *sum, double count, double *out)
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

void mpm_row_of_bodies(const Simulation *sim, double *row)
{
    const Mpm *mpm = mpm_of_const(sim);
    const MpmDef *def = &mpm->def;
    const double m = mpm->mass[0];
    double affine = 0.0;
    for (int k = 0; k < BODIES_X; k++)
        row[k] = 0.0;
    for (int body = 0; body < def->n_bodies; body++) {
        const int first = mpm->first[body], end = mpm->first[body + 1];
        const BodySums sum = sum_bodies(mpm, first, end);
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

void mpm_write_row(Mpm *mpm, double *row, bool whole)
{
    if (mpm->bodies) {
        mpm_row_of_bodies(&mpm->sim, row);
        for (int k = BODIES_X + mpm->def.n_bodies * BODY_COLUMNS; k < mpm->sim.n_series; k++)
            row[k] = is_touching(mpm, (mpm->series_entry[k] - OF_BODIES) / (BODY_TOUCHING + 1));
        return;
    }
    const Energies sums = energies_of(mpm);
    for (int k = 0; k < mpm->sim.n_series; k++)
        row[k] = value_of(mpm, (Entry)mpm->series_entry[k], &sums, whole);
}

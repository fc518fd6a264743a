/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Energies and the row of the series of a bar and of a beam: sums over all particles and nodes, of a bar per
 * unit cross-section, of a beam (b its thickness) without its common speed v0,
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
 * it at 4 cells in the height of a beam, 4e-4 at 8). */
#include "base/assertion.h"
#include "methods/axial.h"
#include "methods/mpm/mistakes.h"

#include <string.h>

/* sum m D C^2 / 2 with D = sum N_i d_i^2, d_i = x_i - x: the energy of APIC's affine motion. */
static double affine_energy(const Mpm *mpm, int p)
{
    MpmWeights w;
    const int base = mpm->base[p];
    double s = mpm->s[0][p], spread = 0.0;
    mpm_weights(mpm, 1, mpm->shape, mpm_half(mpm, p), base, &s, &w);
    for (int a = 0; a < mpm->support; a++) {
        const double arm = shape_node_offset(mpm->shape, mpm->half, mpm->cells, base, a) - s;
        spread += w.n[0][a] * (arm * arm);
    }
    const double speed = mpm->affine[p] * mpm->dx;
    return 0.5 * mpm_mass(mpm, p) * (spread * (speed * speed));
}

typedef struct Sums {
    double momentum, moment, kinetic, strain;
} Sums;

/* Over particles [first, end) of one material: sum m v, sum m u, and energies. */
static Sums sum_material(const Mpm *mpm, int which, int first, int end)
{
    double momentum[MPM_LANES] = {0}, moment[MPM_LANES] = {0}, squares[MPM_LANES] = {0};
    double strain[MPM_LANES] = {0};
    const double *const u = mpm->u[0], *const v = mpm->v[0], *const stress = mpm->stress[0];
    const double *const volume = mpm->volume, m = mpm->mass[which];
#define ADD(lane, p)                                                                                         \
    do {                                                                                                     \
        momentum[lane] += v[p];                                                                              \
        moment[lane] += u[p];                                                                                \
        squares[lane] += v[p] * v[p];                                                                        \
        strain[lane] += stress[p] * stress[p] * volume[p];                                                   \
    } while (0)
    int p = first;
    for (; p + MPM_LANES <= end; p += MPM_LANES)
        for (int lane = 0; lane < MPM_LANES; lane++)
            ADD(lane, p + lane);
    for (int lane = 0; p + lane < end; lane++)
        ADD(lane, p + lane);
#undef ADD
    return (Sums){m * mpm_fold(momentum), m * mpm_fold(moment), 0.5 * m * mpm_fold(squares),
                  mpm_fold(strain) / (2.0 * mpm->modulus[which])};
}

/* Strain energy of a particle in plane stress, s.D^-1 s/2 times its volume, J. */
double mpm_strain_at(const Mpm *mpm, int at)
{
    ASSERT_INDEX(at, mpm->n_particles);
    const MpmDef *def = &mpm->def;
    const double xx = mpm->stress[0][at], yy = mpm->stress[1][at], xy = mpm->stress[2][at];
    const double direct = xx * xx + yy * yy - 2 * def->poisson * (xx * yy);
    return (direct / (2 * def->youngs_modulus) + xy * xy / (2 * mpm->shear)) * mpm->volume[at] *
           def->thickness;
}

static Sums sum_beam(const Mpm *mpm)
{
    Sums sums = {0};
    for (int p = 0; p < mpm->n_particles; p++) {
        const double vx = mpm->v[0][p] - mpm->speed, vy = mpm->v[1][p];
        sums.kinetic += vx * vx + vy * vy;
        sums.strain += mpm_strain_at(mpm, p);
    }
    sums.kinetic *= mpm->mass[0] / 2 * mpm->def.thickness;
    return sums;
}

static Sums sum_particles(const Mpm *mpm)
{
    if (mpm->dim == 2)
        return sum_beam(mpm);
    Sums sums = sum_material(mpm, 0, 0, mpm->joint);
    if (mpm->joint < mpm->n_particles) {
        const Sums more = sum_material(mpm, 1, mpm->joint, mpm->n_particles);
        sums.momentum += more.momentum;
        sums.moment += more.moment;
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
    if (mpm->bodies)
        return bodies_energy(mpm);
    const Sums sums = sum_particles(mpm);
    return sums.kinetic + sums.strain;
}

static double thickness(const Mpm *mpm)
{
    return mpm->dim == 1 ? 1.0 : mpm->def.thickness;
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
    return 0.5 * sum * thickness(mpm);
}

static double rate_of_centre(const Mpm *mpm, double moment)
{
    double momentum = 0.0;
    if (mpm->sim.step > 0)
        return (moment - mpm->head->moment) / (mpm->whole_mass * mpm->dt);
    for (int i = 0; i < mpm->n_nodes; i++)
        momentum += mpm->node_mass[i] * mpm->velocity[0][i];
    return momentum / mpm->whole_mass;
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
    V_CM, /* those of a bar, in the order of its columns */
    X_CM,
    X_CM_RATE,
    KINETIC,
    KINETIC_GRID,
    KINETIC_NULL,
    STRAIN,
    WORK,
    TOTAL,
    MOMENTUM_X,
    REACTION_X,
    LINE_ENTRIES,
    U_PROBE = LINE_ENTRIES,
    V_PROBE,
    LENGTH,
    MOMENTUM_Y,
    REACTION_Y,
    ENTRIES
} Entry;

static const Quantity line[LINE_ENTRIES] = {
    {AXIAL_V_CM},
    {AXIAL_X_CM},
    {"x_cm_rate", "d(x_cm)/dt", "length/time",
     "rate of x_cm in the last step: particles move with the nodes, and not with their own velocities"},
    {AXIAL_KINETIC},
    {"kinetic_grid", "seen by grid", "force/length",
     "the part of it that the grid sees: sum p^2/(2m) of the nodes, boundary applied"},
    {"kinetic_null", "null space", "force/length",
     "the part of it that no velocities of the grid can give: the rest is seen, or lost to lumped masses"},
    {"strain", "strain", "force/length", "strain energy of the particles"},
    {AXIAL_WORK},
    {AXIAL_TOTAL},
    {AXIAL_MOMENTUM},
    {AXIAL_REACTION " in the last step"},
};

/* In the order of the columns. */
static const struct {
    Entry entry;
    Quantity quantity;
} beam[] = {
    {U_PROBE, {"u_probe", "u", "m", "transverse displacement at the probe"}},
    {V_PROBE, {"v_probe", "v", "m/s", "transverse velocity at the probe"}},
    {LENGTH, {"length", "length", "m", "length outside the channel, L0 + v0 t"}},
    {KINETIC, {"kinetic", "kinetic", "J", "kinetic energy of the particles, without the common speed"}},
    {KINETIC_GRID,
     {"kinetic_grid", "seen by grid", "J",
      "the part of it that the grid sees: sum p^2/(2m) of the nodes, supports applied"}},
    {KINETIC_NULL,
     {"kinetic_null", "null space", "J",
      "the part of it that no velocities of the grid can give: the rest is seen, or lost to "
      "lumped masses"}},
    {STRAIN, {"strain", "strain", "J", "strain energy of the particles"}},
    {WORK, {"work", "work", "J", "work of the channel, which draws the beam out"}},
    {TOTAL, {"total", "total", "J", "kinetic + strain; it ripples, as the two are half a step apart"}},
    {MOMENTUM_X, {"momentum_x", "momentum x", "kg m/s", "momentum of all particles along x"}},
    {MOMENTUM_Y, {"momentum_y", "momentum y", "kg m/s", "momentum of all particles along y"}},
    {REACTION_X,
     {"reaction_x", "reaction x", "N", "force of what holds the beam, along x, in the last step"}},
    {REACTION_Y,
     {"reaction_y", "reaction y", "N", "force of what holds the beam, along y, in the last step"}},
};

/* A column of the series, unless the run has no such thing. */
static void add_column(Mpm *mpm, Entry entry, const Quantity *quantity)
{
    if ((entry == REACTION_X && mpm->dim == 1 && mpm->fixed_left == 0 && mpm->fixed_right == 0) ||
        (entry == LENGTH && !mpm->def.leaves_channel) ||
        (entry == KINETIC_NULL && mpm->dim == 2 && !plane_null_pays(mpm)))
        return;
    mpm->series_entry[mpm->sim.n_series] = (int)entry;
    mpm->series[mpm->sim.n_series++] = *quantity;
}

void mpm_set_series(Mpm *mpm)
{
    for (int k = 0; mpm->dim == 1 && k < LINE_ENTRIES; k++)
        add_column(mpm, (Entry)k, &line[k]);
    for (size_t k = 0; mpm->dim == 2 && k < sizeof beam / sizeof *beam; k++)
        add_column(mpm, beam[k].entry, &beam[k].quantity);
    mpm->sim.series = mpm->sim.series_asked = mpm->series;
    mpm->sim.series_entry = mpm->series_entry;
}

const char *const mpm_on_request[] = {"x_cm_rate",  "kinetic_grid", "kinetic_null", "momentum",   "reaction",
                                      "momentum_x", "momentum_y",   "reaction_x",   "reaction_y", NULL};

bool mpm_row_needs_grid(const Mpm *mpm)
{
    return !mpm->bodies && (mpm_has_column(mpm, KINETIC_GRID) || mpm_has_column(mpm, KINETIC_NULL) ||
                            (mpm_has_column(mpm, X_CM_RATE) && mpm->sim.step == 0));
}

bool mpm_row_has_rates(const Mpm *mpm)
{
    for (int k = 0; k < mpm->sim.n_series; k++) {
        const char *name = mpm->sim.series[k].name;
        if (strcmp(name, "x_cm_rate") == 0 || strncmp(name, "reaction", 8) == 0)
            return true;
    }
    return false;
}

/* Of a beam kinetic_null takes several times as long as a step: only in a row that is whole and due. */
static double null_energy(Mpm *mpm, double kinetic, bool whole)
{
    const bool is_due = mpm->sim.whole_rows == 0 || mpm->sim.step % mpm->sim.whole_rows == 0;
    return mpm->dim == 1     ? mpm_line_null_energy(mpm)
           : whole && is_due ? plane_null_energy(mpm, kinetic)
                             : NAN;
}

static double value_of(Mpm *mpm, Entry entry, const Sums *sums, bool whole)
{
    const int axis = entry == MOMENTUM_Y || entry == REACTION_Y;
    switch (entry) {
    case V_CM:
        return sums->momentum / mpm->whole_mass;
    case X_CM:
        return mpm->x_cm_start + sums->moment / mpm->whole_mass;
    case X_CM_RATE:
        return rate_of_centre(mpm, sums->moment);
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
        return thickness(mpm) * mpm_momentum(mpm, axis);
    case REACTION_X:
    case REACTION_Y:
        return thickness(mpm) * mpm_reaction(mpm, axis, mpm_momentum(mpm, axis));
    case U_PROBE:
        return probe(mpm, mpm->u[1]);
    case V_PROBE:
        return probe(mpm, mpm->v[1]);
    case LENGTH:
        return mpm->def.length + mpm->def.speed * simulation_time(&mpm->sim);
    case ENTRIES:
        break;
    }
    return NAN;
}

void mpm_write_row(Mpm *mpm, double *row, bool whole)
{
    if (mpm->bodies) {
        bodies_write_row(mpm, row);
        return;
    }
    const Sums sums = sum_particles(mpm);
    for (int k = 0; k < mpm->sim.n_series; k++)
        row[k] = value_of(mpm, (Entry)mpm->series_entry[k], &sums, whole);
}

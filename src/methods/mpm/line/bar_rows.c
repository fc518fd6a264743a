/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Energies of a bar and the row of its series: sums over all particles and nodes, per unit cross-section,
 *
 *     kinetic      sum m v^2 / 2, with APIC + sum m D C^2 / 2, D = sum N (x_i - x)^2
 *     kinetic_grid sum p_i^2 / (2 m_i) of the particles mapped as in the first stage, supports applied
 *     kinetic_null what the grid cannot see at all (bar_null.h)
 *     strain       sum stress^2 volume / (2 E)
 *
 * The second and third are left out where nobody asks for them: they need the grid, and the third takes
 * longer than the step. A row is taken between steps, when velocities and stresses of USF are half a step
 * apart: kinetic + strain ripples by about omega dt/2 of itself though nothing is lost (E* of problems/ is
 * the sum without ripple). stress^2/2E is the energy of small strains; where particles cross cells, strains
 * are large enough to tell it from E (e exp(e) - exp(e) + 1), e = stress/E, which is what the updates of
 * stress and density really store. Each sum is kept in BAR_LANES partial sums, so that neither vectors nor
 * tiles leave a trace.
 */
#include "base/assertion.h"
#include "methods/mpm/line/bar_null.h"
#include "methods/mpm/line/bar_state.h"
#include "methods/mpm/line/kernels/bar_kernels.h"
#include "methods/mpm/line/kernels/shape.h"

/* Adds the BAR_LANES partial sums pairwise, always in this order. */
static double fold(const double *lane)
{
    return ((lane[0] + lane[4]) + (lane[2] + lane[6])) + ((lane[1] + lane[5]) + (lane[3] + lane[7]));
}

/* sum m D C^2 / 2 with D = sum N_i d_i^2, d_i = x_i - x: the energy of APIC's affine motion. s, d in cells: C
 * dx d has the unit of a velocity. */
static double affine_energy(const Bar *bar)
{
    double sum = 0.0;
    for (int c = 0; c < bar->n_cells; c++)
        for (int p = bar->first[c]; p < bar->first[c + 1]; p++) {
            int j = p % bar->slots, k = p / bar->slots;
            double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX], spread = 0.0, s = bar->s[j][k];
            shape_at(bar->def.shape, bar_half(bar, p), bar->n_cells, c, s, n, dn);
            for (int a = 0; a < bar->support; a++) {
                double arm = shape_node_offset(bar->def.shape, bar->n_cells, c, a) - s;
                spread += n[a] * (arm * arm);
            }
            double speed = bar->affine[j][k] * bar->dx;
            sum += bar_weight(bar, p) * (spread * (speed * speed));
        }
    return 0.5 * bar->mass * sum;
}

/* A bar of two materials: the sums over the particles of each, and the particles' places x/dx weighed by
 * their mass. */
typedef struct BarParts {
    BarSums of[2];
    double moment;
} BarParts;

static BarParts sum_parts(const Bar *bar)
{
    BarParts parts = {.moment = 0.0};
    for (int c = 0; c < bar->n_cells; c++)
        for (int p = bar->first[c]; p < bar->first[c + 1]; p++) {
            const int j = p % bar->slots, k = p / bar->slots, lane = k % BAR_LANES;
            const double v = bar->v[j][k], stress = bar->stress[j][k];
            BarSums *sums = &parts.of[p >= bar->joint];
            sums->v[lane] += v;
            sums->square[lane] += v * v;
            sums->strain[lane] += stress * stress * bar->volume[j][k];
            parts.moment += bar_weight(bar, p) * (c - bar->origin + bar->s[j][k]);
        }
    return parts;
}

/* A sum over the second material's particles counts by their mass, or by their stiffness. */
static double both(double first, double factor, double second)
{
    return first + factor * second;
}

static double kinetic_of_parts(const Bar *bar, const BarParts *parts)
{
    const double squares = both(fold(parts->of[0].square), bar->joint_weight, fold(parts->of[1].square));
    const double kinetic = 0.5 * bar->mass * squares;
    return bar->head->transfer == MPM_APIC ? kinetic + affine_energy(bar) : kinetic;
}

static double strain_of_parts(const Bar *bar, const BarParts *parts)
{
    const double soft = bar->def.youngs_modulus / bar->def.joint_modulus;
    return both(fold(parts->of[0].strain), soft, fold(parts->of[1].strain)) / (2.0 * bar->def.youngs_modulus);
}

static double kinetic_of(const Bar *bar, const BarSums *sums)
{
    double kinetic = 0.5 * bar->mass * fold(sums->square);
    return bar->head->transfer == MPM_APIC ? kinetic + affine_energy(bar) : kinetic;
}

static double strain_of(const Bar *bar, const BarSums *sums)
{
    return fold(sums->strain) / (2.0 * bar->def.youngs_modulus);
}

double bar_energy(const Bar *bar)
{
    if (bar->def.joint > 0.0) {
        const BarParts parts = sum_parts(bar);
        return kinetic_of_parts(bar, &parts) + strain_of_parts(bar, &parts);
    }
    BarSums sums = {.v = {0}};
    bar->kernels->particle_sums(bar, 0, bar->places, &sums);
    return kinetic_of(bar, &sums) + strain_of(bar, &sums);
}

enum { V_CM, X_CM, KINETIC, KINETIC_GRID, KINETIC_NULL, STRAIN, WORK, TOTAL };

void bar_set_series(Bar *bar)
{
    Simulation *sim = &bar->sim;
    for (int k = 0; k < BAR_SERIES; k++) {
        bar->series[k] = bar_series[k];
        bar->series_entry[k] = k;
    }
    bar->has_grid_energy = bar->has_null_energy = true;
    sim->series = bar->series;
    sim->n_series = BAR_SERIES;
}

const char *const bar_costly[] = {"kinetic_grid", "kinetic_null", NULL};

void bar_leave_out(Simulation *sim, int column)
{
    ASSERT_INDEX(column, sim->n_series);
    ASSERT_INT(sim->step, ==, 0);
    Bar *bar = bar_of(sim);
    *(bar->series_entry[column] == KINETIC_GRID ? &bar->has_grid_energy : &bar->has_null_energy) = false;
    sim->n_series--;
    for (int k = column; k < sim->n_series; k++) {
        bar->series[k] = bar->series[k + 1];
        bar->series_entry[k] = bar->series_entry[k + 1];
    }
}

bool bar_row_needs_grid(const Bar *bar)
{
    return bar->has_grid_energy || bar->has_null_energy;
}

/* Those of the BAR_SERIES numbers that are not left out. */
static void write_row(const Bar *bar, double v_cm, double x_cm, double kinetic, double strain,
                      const double *grid_lanes, double null_energy, double *row)
{
    const double all[BAR_SERIES] = {
        [V_CM] = v_cm,
        [X_CM] = x_cm,
        [KINETIC] = kinetic,
        [KINETIC_GRID] = 0.5 * fold(grid_lanes),
        [KINETIC_NULL] = null_energy,
        [STRAIN] = strain,
        [WORK] = bar->head->work,
        [TOTAL] = kinetic + strain,
    };
    for (int k = 0; k < bar->sim.n_series; k++)
        row[k] = all[bar->series_entry[k]];
}

/* The numbers of bar_series: v_cm = sum v / n, x_cm = dx sum (cell - origin + s) / n with the
 * whole cells summed exactly in cell_sum, then the energies. */
void bar_write_row(const Bar *bar, const BarSums *sums, const double *grid_lanes, double null_energy,
                   int64_t cell_sum, double *row)
{
    const double x_cm = bar->dx * (((double)cell_sum + fold(sums->s)) / bar->n_particles);
    write_row(bar, fold(sums->v) / bar->n_particles, x_cm, kinetic_of(bar, sums), strain_of(bar, sums),
              grid_lanes, null_energy, row);
}

/* The same of two materials: v_cm = sum m v / sum m, x_cm likewise. */
static void write_row_of_parts(const Bar *bar, const double *grid_lanes, double null_energy, double *row)
{
    const BarParts parts = sum_parts(bar);
    const double whole = both(bar->joint, bar->joint_weight, bar->n_particles - bar->joint);
    const double v_cm = both(fold(parts.of[0].v), bar->joint_weight, fold(parts.of[1].v)) / whole;
    write_row(bar, v_cm, bar->dx * (parts.moment / whole), kinetic_of_parts(bar, &parts),
              strain_of_parts(bar, &parts), grid_lanes, null_energy, row);
}

void bar_step_row(Bar *bar, double *row)
{
    BarSums sums = {.v = {0}};
    double grid[BAR_LANES] = {0};
    double unseen = 0;
    if (bar->has_grid_energy)
        bar->kernels->node_sums(bar, 0, bar->n_nodes, grid);
    if (bar->has_null_energy) {
        BarNull null = {0};
        bar_null_add(bar, &null, bar->n_cells);
        unseen = bar_null_energy(bar, &null);
    }
    if (bar->def.joint > 0.0) {
        write_row_of_parts(bar, grid, unseen, row);
        return;
    }
    bar->kernels->particle_sums(bar, 0, bar->places, &sums);
    bar_write_row(bar, &sums, grid, unseen, bar->head->cell_sum, row);
}

void bar_row(Simulation *sim, double *row)
{
    ASSERT_INT(sim->stage, ==, 0);
    Bar *bar = bar_of(sim);
    if (bar_row_needs_grid(bar))
        bar_map_and_fix(bar); /* the grid is scratch between steps */
    bar_step_row(bar, row);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes the matrices of bar_rest.h: shape functions at the places where particles stand at rest, then sums
 * over the particles. Everything that theory says of the mesh (dispersion.c, step_limit.c,
 * step_spectrum.c) starts here. */
#include "theory/bar_rest.h"

#include "base/assertion.h"
#include "base/linear/cholesky.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

double bar_mesh_flip(const BarMesh *mesh)
{
    return mesh->apic || mesh->fmpm_order > 0 ? 0 : mesh->flip_fraction;
}

MeshResponse bar_mesh_response(const BarMesh *mesh, double filter)
{
    double moves = 1, power = 1;
    if (mesh->fmpm_order > 0)
        for (int j = 1; j < mesh->fmpm_order; j++)
            moves += power *= 1 - filter;
    else
        moves = 1 / (mesh->consistent * filter + (1 - mesh->consistent));
    const double alpha = bar_mesh_flip(mesh);
    return (MeshResponse){
        .moves = moves, .returns = filter * moves * moves, .kept = alpha + (1 - alpha) * (filter * moves)};
}

int bar_rest_degree(MpmShape shape)
{
    return shape == MPM_BSPLINE2 ? 2 : shape == MPM_BSPLINE3 ? 3 : 1;
}

/* --- B-splines ------------------------------------------------------------------------------------ */

/* Knots as seen from the left edge of a cell: whole numbers, so that nothing is lost far from x = 0. */
typedef struct Knots {
    int degree, cells, cell;
} Knots;

static double knot(const Knots *knots, int i)
{
    const int edge = i - knots->degree;
    return (edge < 0 ? 0 : edge > knots->cells ? knots->cells : edge) - knots->cell;
}

/* N of degree d that begins at knot i:
 *     N_i,0 = 1 in [k_i, k_i+1)
 *     N_i,d = (x - k_i)/(k_i+d - k_i) N_i,d-1 + (k_i+d+1 - x)/(k_i+d+1 - k_i+1) N_i+1,d-1,   0/0 = 0 */
static double spline(const Knots *knots, int d, int i, double x)
{
    if (d == 0)
        return knot(knots, i) <= x && x < knot(knots, i + 1) ? 1 : 0;
    const double left = knot(knots, i + d) - knot(knots, i);
    const double right = knot(knots, i + d + 1) - knot(knots, i + 1);
    double sum = 0;
    if (left > 0)
        sum += (x - knot(knots, i)) / left * spline(knots, d - 1, i, x);
    if (right > 0)
        sum += (knot(knots, i + d + 1) - x) / right * spline(knots, d - 1, i + 1, x);
    return sum;
}

/* N' = d (N_i,d-1 / (k_i+d - k_i) - N_i+1,d-1 / (k_i+d+1 - k_i+1)) */
static double spline_slope(const Knots *knots, int d, int i, double x)
{
    const double left = knot(knots, i + d) - knot(knots, i);
    const double right = knot(knots, i + d + 1) - knot(knots, i + 1);
    return (left > 0 ? d * spline(knots, d - 1, i, x) / left : 0) -
           (right > 0 ? d * spline(knots, d - 1, i + 1, x) / right : 0);
}

/* The Greville abscissa: the mean of the inner knots. */
static double spline_place(const Knots *knots, int i)
{
    double sum = 0;
    for (int d = 1; d <= knots->degree; d++)
        sum += knot(knots, i + d);
    return sum / knots->degree;
}

/* Where particle j of a cell stands, 0 to 1. */
static double place_of(const BarRest *rest, int j)
{
    return (j + 0.5 + rest->offset) / rest->per_cell;
}

/* What the nodes of a cell are to its particle j, at xi = (j + 1/2 + offset)/P of the cell: N_a, dx N_a' and
 * (x_a - x_p)/dx for a = 0 .. degree. For hats x_a is the node; a B-spline stands at its Greville abscissa,
 * where sum N_a x_a = x. Each output may be NULL. */
void bar_rest_weights(const BarRest *rest, int cell, int j, double n[REST_SUPPORT_MAX],
                      double slope[REST_SUPPORT_MAX], double arm[REST_SUPPORT_MAX])
{
    ASSERT_INT(cell, >=, 0);
    ASSERT_INT(j, >=, 0);
    const Knots knots = {rest->degree, rest->mesh_cells, cell + rest->origin};
    const double x = place_of(rest, j);
    for (int a = 0; a <= rest->degree; a++) {
        const int i = knots.cell + a;
        if (n)
            n[a] = spline(&knots, rest->degree, i, x);
        if (slope)
            slope[a] = spline_slope(&knots, rest->degree, i, x);
        if (arm)
            arm[a] = spline_place(&knots, i) - x;
    }
}

/* --- matrices ------------------------------------------------------------------------------------- */

/* Adds scale a a^T over the nodes that are kept; `first`: the index of a[0] among them. */
static void add_outer(const BarRest *rest, double *band, int first, const double *a, double scale)
{
    for (int r = 0; r <= rest->degree; r++)
        for (int c = 0; c <= r; c++)
            if (first + c >= 0 && first + r < rest->nodes)
                band[(first + r) * (rest->reach + 1) + r - c] += scale * a[r] * a[c];
}

/* Mass and stiffness of a particle of a cell over those of the first material's. */
static double density_in(const BarRest *rest, int cell)
{
    return cell < rest->joint ? 1 : rest->density_beyond;
}

/* The matrices of bar_rest.h in units of rho dx and E/dx: a particle has mass and volume 1/P of a cell's.
 *
 *     M_l,i = sum_p m N_i      M_ij = sum_p m N_i N_j      K_ij = sum_p V E N_i' N_j'
 *
 * APIC hands on a slope too, C_p = sum_i N_i v_i d_i / D with d_i = x_i - x_p and D = sum_i N_i d_i^2: to M
 * is added sum_p m (N_i d_i)(N_j d_j)/D. All are bands of half-width `degree`. */
static void assemble(BarRest *rest, bool apic)
{
    const double part = 1.0 / rest->per_cell;
    for (int cell = 0; cell < rest->cells; cell++)
        for (int j = 0; j < rest->per_cell; j++) {
            const int first = cell + rest->origin - rest->first_node;
            double n[REST_SUPPORT_MAX], slope[REST_SUPPORT_MAX], arm[REST_SUPPORT_MAX], spread = 0;
            const double mass = part * density_in(rest, cell);
            bar_rest_weights(rest, cell, j, n, slope, arm);
            add_outer(rest, rest->consistent, first, n, mass);
            add_outer(rest, rest->stiffness, first, slope,
                      part * (cell < rest->joint ? 1 : rest->modulus_beyond));
            for (int a = 0; a <= rest->degree; a++) {
                if (first + a >= 0 && first + a < rest->nodes)
                    rest->mass[first + a] += mass * n[a];
                spread += n[a] * arm[a] * arm[a];
                arm[a] *= n[a];
            }
            if (apic)
                add_outer(rest, rest->consistent, first, arm, mass / spread);
        }
}

/* The first cell of the second material. Of a longer bar each part keeps its cells, or half of those that are
 * kept. */
static int joint_among(const BarTheory *bar, const BarMesh *mesh, int cells)
{
    const double all = round(bar->length / mesh->cell_size), at = round(bar->joint / mesh->cell_size);
    const double half = floor(cells / 2.0);
    if (!bar_is_layered(bar))
        return cells;
    return (int)(cells >= all ? at : at < half ? at : all - at < cells - half ? cells - (all - at) : half);
}

/* Lumped mass, consistent mass and stiffness of the nodes that move. False: none does, or memory is short;
 * nothing has to be freed then. */
bool bar_rest_make(BarRest *rest, const BarTheory *bar, const BarMesh *mesh, int cells)
{
    ASSERT_INT(cells, >=, 1);
    /* open knots that lie more than two cells beyond the bar's end change no function that the bar touches */
    const int padding = mesh->padding < 2 ? mesh->padding : 2;
    const int degree = bar_rest_degree(mesh->shape);
    *rest = (BarRest){.cells = cells,
                      .per_cell = mesh->particles_per_cell,
                      .offset = mesh->offset,
                      .joint = joint_among(bar, mesh, cells),
                      .density_beyond = bar->joint_density / bar->density,
                      .modulus_beyond = bar->joint_modulus / bar->youngs_modulus,
                      .degree = degree,
                      .reach = degree};
    rest->origin = bar->left_fixed ? 0 : padding;
    rest->mesh_cells = rest->origin + cells + (bar->right_fixed ? 0 : padding);
    /* the nodes that the bar's cells touch, less the one that each support holds */
    rest->first_node = rest->origin + (bar->left_fixed ? 1 : 0);
    rest->nodes = rest->origin + cells + degree - (bar->right_fixed ? 1 : 0) - rest->first_node;
    if (rest->nodes < 1)
        return false;
    const size_t n = (size_t)rest->nodes, band = n * (size_t)(rest->reach + 1);
    rest->mass = calloc(n + 2 * band, sizeof *rest->mass);
    if (!rest->mass)
        return false;
    rest->consistent = rest->mass + n;
    rest->stiffness = rest->consistent + band;
    assemble(rest, mesh->apic);
    return true;
}

void bar_rest_free(BarRest *rest)
{
    free(rest->mass);
}

bool bar_rest_solve_mass(const BarRest *rest, double share, double *x)
{
    ASSERT_REAL(share, >=, 0);
    ASSERT_REAL(share, <=, 1);
    const size_t n = (size_t)rest->nodes, width = (size_t)rest->reach;
    if (share == 0) {
        for (size_t i = 0; i < n; i++)
            x[i] /= rest->mass[i];
        return true;
    }
    CholeskyBand band = {n, width, malloc(n * (width + 1) * sizeof(double))};
    if (!band.rows)
        return false;
    for (size_t i = 0; i < n; i++)
        for (size_t d = 0; d <= width; d++)
            band.rows[i * (width + 1) + d] =
                share * rest->consistent[i * (width + 1) + d] + (d == 0 ? (1 - share) * rest->mass[i] : 0);
    const bool good = cholesky_factor(&band, &(Cancel){0}) == CHOLESKY_DONE;
    if (good)
        cholesky_solve(&band, x, &(Cancel){0});
    free(band.rows);
    return good;
}

/* v_i = sum m N_i phi(x_p) / m_i: what mapping and eq. 4 of paper M make of a mode phi of unit velocity. */
void bar_rest_sample(const BarRest *rest, const BarTheory *bar, BarShape *shape, int number, double *velocity)
{
    ASSERT_INT(rest->per_cell, >=, 1);
    const double part = 1.0 / rest->per_cell, cell_size = bar->length / rest->cells;
    memset(velocity, 0, (size_t)rest->nodes * sizeof *velocity);
    for (int cell = 0; cell < rest->cells; cell++)
        for (int j = 0; j < rest->per_cell; j++) {
            double n[REST_SUPPORT_MAX];
            bar_rest_weights(rest, cell, j, n, NULL, NULL);
            const int first = cell + rest->origin - rest->first_node;
            const double v = shape(bar, number, (cell + place_of(rest, j)) * cell_size);
            for (int a = 0; a <= rest->degree; a++)
                if (first + a >= 0 && first + a < rest->nodes)
                    velocity[first + a] += part * density_in(rest, cell) * v * n[a];
        }
    for (int i = 0; i < rest->nodes; i++)
        velocity[i] /= rest->mass[i];
}

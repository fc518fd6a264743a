/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Small vibration of the lattice: rho u'' = -K u, so that omega^2 = lambda/rho with the lowest eigenvalue of
 * K.
 *
 * The linear bond of eq. 8 between the nodes a and b with the direction n = xi/|xi| gives the force density
 *
 *     f_a = k n (n . (u_b - u_a)),  f_b = -f_a,  k = c G w V/|xi|,
 *
 * so it adds k n n^T to the blocks (a,a) and (b,b) of K and takes it from (a,b) and (b,a). Held components
 * are uncoupled. With the nodes numbered by columns K is a narrow band: its Cholesky factor and a few steps
 * of inverse iteration, x <- K^-1 x, give lambda = x.x / x.K^-1 x to all digits that K has. Each turn makes
 * the square of the vector's error smaller by (lambda_1/lambda_2)^2, 1/256 or less for a slender beam: a
 * handful of turns; where two frequencies lie side by side it takes more. The half wave's own quotient x . K
 * x would be of no use (.79 ms in place of .85 at dx .25 mm): it violates the point supports, and K punishes
 * that. The same factor gives the beam at rest under its weight in one solution, K u = rho b. */
#include "methods/bonds/plane/bonds_plane.h"
#include "base/assertion.h"
#include "base/linear.h"
#include "methods/bonds/plane/bonds_internal.h"
#include "base/math/functions.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

/* Unknown number of a component of node (i, j): by columns. */
static size_t unknown(const Lattice *lattice, int i, int j, int component)
{
    return 2 * ((size_t)i * (size_t)lattice->ny + (size_t)j) + (size_t)component;
}

/* The band keeps the lower half only. */
static void add(Cholesky *stiffness, size_t row, size_t column, double value)
{
    if (column <= row)
        stiffness->rows[row * (stiffness->width + 1) + (row - column)] += value;
}

/* What K is made of: a lattice, how stiff its bonds are, and what is held. */
typedef struct Model {
    const Lattice *lattice;
    const double *coefficient; /* per slot, of bonds that are there; NULL: all are, and whole */
    const Support *supports;
    int n_supports, held_columns;
    double density;
    bool half_wave; /* what is known of its lowest vibration */
    const Cancel *cancel;
} Model;

/* One bond's share of K in the components that are free, k n n^T in four blocks, k = c G w V/|xi| in N/m^4.
 * Rows and columns of held components are left out: they would only say that nothing moves there. */
static void add_bond(Cholesky *stiffness, const Model *model, BondPlace bond, const bool *held)
{
    const Lattice *lattice = model->lattice;
    const Offset *offset = &lattice->offsets[bond.offset];
    const double n[2] = {offset->x / offset->length, offset->y / offset->length};
    const double k = (model->coefficient ? model->coefficient[lattice_slot(lattice, bond)]
                                         : lattice_coefficient(lattice, bond)) /
                     offset->length;
    const size_t ends[2] = {unknown(lattice, bond.i, bond.j, 0),
                            unknown(lattice, bond.i + offset->p, bond.j + offset->q, 0)};
    for (int r = 0; r < 4; r++)
        for (int c = 0; c < 4; c++) {
            const size_t row = ends[r / 2] + (size_t)(r % 2), column = ends[c / 2] + (size_t)(c % 2);
            const double share = k * n[r % 2] * n[c % 2];
            if (!held[row] && !held[column])
                add(stiffness, row, column, r / 2 == c / 2 ? share : -share);
        }
}

/* K from all bonds; a held component gets 1 on its diagonal and is coupled to nothing. False: to be given up.
 */
static bool assemble(Cholesky *stiffness, const Model *model, const bool *held)
{
    const Lattice *lattice = model->lattice;
    const double share = 0.01; /* of the whole: the factor takes most of the time */
    size_t number = 0;
    for (BondPlace bond = lattice_next_bond(lattice, (BondPlace){0, 0, -1}); bond.j < lattice->ny;
         bond = lattice_next_bond(lattice, bond), number++) {
        if (number % LATTICE_BONDS_A_QUESTION == 0 && cancel_requested(model->cancel, share))
            return false;
        add_bond(stiffness, model, bond, held);
    }
    for (size_t i = 0; i < stiffness->size; i++)
        if (held[i])
            add(stiffness, i, i, 1);
    return true;
}

/* The start, 0 in held components: half a wave, eq. 16, which is all but the lowest vibration of a supported
 * beam. Of any other body the lowest may be of any symmetry, and the iteration never finds what its start has
 * nothing of: pseudo-random numbers (xorshift) have something of all, the same for every run. */
static void fill(const Model *model, const bool *held, double *x)
{
    const Lattice *lattice = model->lattice;
    uint32_t hash = 2463534242u;
    for (int i = 0; i < lattice->nx; i++)
        for (int j = 0; j < lattice->ny; j++)
            for (int component = 0; component < 2; component++) {
                const size_t at = unknown(lattice, i, j, component);
                hash ^= hash << 13, hash ^= hash >> 17, hash ^= hash << 5;
                const double wave = component ? math_sin(M_PI * (i + 0.5) / lattice->nx) : 0,
                             any = (double)hash / 4294967296.0 - 0.5;
                x[at] = held[at] ? 0 : model->half_wave ? wave : any;
            }
}

/* The displacement of a point under its own weight: K u = rho b with b = 1 m/s^2, upwards; mean over its four
 * nodes. False: given up. */
static bool find_sag(const Cholesky *factor, const Model *model, const bool *held, const Beam *probed,
                     double *u, double *sag)
{
    for (size_t i = 0; i < factor->size; i++)
        u[i] = i % 2 == 1 && !held[i] ? model->density : 0;
    if (!cholesky_solve(factor, u, model->cancel))
        return false;
    *sag = 0;
    for (int b = 0; b < 2; b++)
        for (int a = 0; a < 2; a++)
            *sag += u[unknown(model->lattice, probed->probe_i[a], probed->probe_j[b], 1)] / 4;
    return true;
}

/* T = 2 pi/sqrt(lambda/rho), and the sag of a beam's probe (NULL: not wanted). They stay NAN where nothing
 * holds the body, where two lowest periods are too close to be distinguished, or where the band would take
 * more than BEAM_MODES_NUMBERS_MAX doubles. False: no memory, or interrupted. */
static bool solve(const Model *model, const Beam *probed, BeamLinear *out, Status *status)
{
    const Lattice *lattice = model->lattice;
    /* the largest distance of two unknowns that a bond couples: about 2 ny delta/dx, so a beam, long and low,
     * makes a narrow band. The factor takes n B^2 products and n (B + 1) doubles. */
    int most = 0;
    for (const Offset *o = lattice->offsets; o < lattice->offsets + lattice->n_offsets; o++)
        most = abs(o->p * lattice->ny + o->q) > most ? abs(o->p * lattice->ny + o->q) : most;
    Cholesky band = {.size = 2 * lattice_nodes(lattice), .width = 2 * (size_t)most + 1};
    *out = (BeamLinear){NAN, NAN};
    if ((double)band.size * (double)(band.width + 1) > BEAM_MODES_NUMBERS_MAX)
        return true;
    bool *held = calloc(band.size, sizeof *held);
    double *vectors = malloc(3 * band.size * sizeof *vectors);
    band.rows = calloc(band.size * (band.width + 1), sizeof *band.rows);
    bool done = held && vectors && band.rows;
    if (!done)
        status_fail(status, "not enough memory for the predicted period");
    if (done) {
        for (const Support *s = model->supports; s < model->supports + model->n_supports; s++)
            for (int k = 0; k < s->patch.columns * s->patch.rows; k++) {
                const int i = s->patch.i + k / s->patch.rows, j = s->patch.j + k % s->patch.rows;
                held[unknown(lattice, i, j, 0)] |= s->x;
                held[unknown(lattice, i, j, 1)] |= s->y;
            }
        for (size_t i = 0; i < 2 * (size_t)model->held_columns * (size_t)lattice->ny; i++)
            held[i] = true;
        fill(model, held, vectors);
        const CholeskyEnd end =
            assemble(&band, model, held) ? cholesky_factor(&band, model->cancel) : CHOLESKY_GIVEN_UP;
        double lambda = NAN;
        done = end == CHOLESKY_SINGULAR ||
               (end == CHOLESKY_DONE && linear_lowest(&band, NULL, vectors, &lambda, model->cancel) &&
                (!probed || find_sag(&band, model, held, probed, vectors, &out->sag))) ||
               status_fail(status, "the predicted period was cancelled");
        out->period = 2 * M_PI / sqrt(lambda / model->density);
    }
    free(held);
    free(vectors);
    free(band.rows);
    return done;
}

bool beam_linear(const Simulation *sim, BeamLinear *out, Status *status)
{
    const Beam *beam = (const Beam *)sim;
    const Model model = {.lattice = &beam->lattice,
                         .coefficient = beam->coefficient,
                         .supports = beam->supports,
                         .n_supports = beam->n_supports,
                         .held_columns = beam_held_columns(beam, 0),
                         .density = beam->def.density,
                         .half_wave = beam->def.problem == BEAM_SIMPLY_SUPPORTED,
                         .cancel = &beam->def.cancel};
    return solve(&model, beam, out, status);
}

bool beam_predicted_period(const BeamDef *definition, double *period, double *span, double *height,
                           Status *status)
{
    Lattice lattice;
    *period = NAN;
    if (definition->problem != BEAM_SIMPLY_SUPPORTED)
        return true;
    if (!lattice_init(&lattice, definition, status))
        return false;
    if (span)
        *span = (lattice.nx - 1) * lattice.spacing;
    if (height)
        *height = lattice.ny * lattice.spacing;
    Support supports[2];
    beam_simple_supports(&lattice, supports);
    const Model model = {.lattice = &lattice,
                         .supports = supports,
                         .n_supports = 2,
                         .density = definition->density,
                         .half_wave = true,
                         .cancel = &definition->cancel};
    BeamLinear linear;
    const bool done = solve(&model, NULL, &linear, status);
    *period = linear.period;
    lattice_free(&lattice);
    return done;
}

/* The stiffness matrix of the rows of a long beam that move against each other through the thickness, all
 * columns alike: the thickness modes of paper P's fig. 4 are its eigenvectors (theory/elastic_beam.c). Row j
 * of nodes obeys
 *
 *     rho u_j'' = -sum_k K_jk u_k,   K_jj = -sum_{k != j} K_jk
 *     K_jk = -sum of c G w V (xi_y/|xi|)^2/|xi| over the bonds from a node of row j to row k
 *
 * since the linear bond pulls with c G w V s along xi/|xi|, and s = xi.eta/|xi|^2 = xi_y (u_k - u_j)/|xi|^2.
 * The family is that of a node in the middle of the beam, surface correction included. */
bool beam_row_stiffness(const Simulation *sim, double *matrix)
{
    ASSERT(matrix);
    const Beam *beam = sim->method->field == beam_field ? (const Beam *)sim : NULL;
    if (!beam)
        return false;
    const Lattice *lattice = &beam->lattice;
    const size_t ny = (size_t)lattice->ny;
    for (size_t k = 0; k < ny * ny; k++)
        matrix[k] = 0;
    for (int j = 0; j < lattice->ny; j++) {
        BondPlace family[FAMILY_MAX];
        const size_t count = beam_family(beam, lattice->nx / 2, j, family);
        for (size_t k = 0; k < count; k++) {
            const Offset *offset = &lattice->offsets[family[k].offset];
            const double stiffness = lattice_coefficient(lattice, family[k]) * offset->y * offset->y /
                                     (offset->squared * offset->length);
            const int other = family[k].j == j ? j + offset->q : family[k].j;
            matrix[(size_t)j * ny + (size_t)j] += stiffness;
            matrix[(size_t)j * ny + (size_t)other] -= stiffness;
        }
    }
    return true;
}

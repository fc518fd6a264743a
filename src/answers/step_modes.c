/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The linear step of an engine by the method of Arnoldi (step_modes.h).
 *
 * With v_1 = y/|y| each new (A - 1) v_j is made orthogonal to the vectors before it, V = (v_1 .. v_m):
 *
 *     (A - 1) V = V H + h v_(m+1) e_m^T
 *
 * H w = mu w gives lambda = 1 + mu and the vector V w, with the residual h |w_m|. mu and not lambda, as small
 * steps have lambda near 1. With W = (w_1 .. w_m) and W c = |y| e_1 the part of y is c_k V w_k, and that of
 * x_0, as y = (A - 1) x_0, c_k/mu_k V w_k.
 *
 * States are scaled so far down that 1 + strain is 1 and no place changes: the map is linear to the last bit.
 */
#include "answers/step_modes.h"

#include "base/assertion.h"
#include "base/math/functions.h"
#include "theory/gsl_errors.h"

#include <errno.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

enum { VECTORS_MOST = 160, FIRST_LOOK = 24 };
static const double numbers_most = 2.5e7, work_most = 4e7;
static const double scale = 0x1p-200;
static const double closed = 1e-11;  /* h over the largest of H */
static const double settled = 3e-5;  /* residual of the largest share over |mu|; the error is its square */
static const double converged = 0.1; /* likewise, of the last look */
static const double grows = 1e-9;    /* |lambda| - 1 beyond round-off */

/* An eigenvalue; of a pair both are there. */
typedef struct Part {
    gsl_complex mu, of_v_cm; /* of_v_cm: its part of v_cm at t = 0 */
    double angle, decay;     /* lambda = exp(i angle - decay) */
    double share;            /* of |x_0|^2, of a pair both together */
    double residual;
    int column; /* of W */
} Part;

struct StepModes {
    double dt, v_cm; /* at t = 0 */
    bool whole;
    int count, largest;
    Part parts[VECTORS_MOST];
    double overlap;
    double *nodal; /* mass of each node, then momenta: of a start, of the largest mode's two parts */
};

typedef struct Space Space;
typedef bool Map(Space *, const gsl_vector *x, gsl_vector *out); /* false: the step failed */

/* What is at hand while the space of a map grows. */
struct Space {
    Simulation *sim, *still;
    Map *map;
    int v_cm, most, count; /* v_cm: the column, or -1 */
    double length, next, *row;
    gsl_vector *start, *state, *change;
    gsl_matrix *vectors, *h; /* rows are v_1, v_2 ... */
};

static void put(Space *space, Simulation *sim, const gsl_vector *x, double unit)
{
    gsl_vector_memcpy(space->state, x);
    gsl_vector_scale(space->state, scale);
    sim->step = 0;
    sim->method->small(sim, space->state->data, unit, true);
}

/* out = A x - x */
static bool step(Space *space, Simulation *sim, const gsl_vector *x, double unit, gsl_vector *out)
{
    put(space, sim, x, unit);
    if (!simulation_steps(sim, 1, NULL, NULL, NULL))
        return false;
    sim->method->small(sim, out->data, unit, false);
    gsl_vector_scale(out, 1 / scale);
    gsl_vector_sub(out, x);
    return true;
}

static bool of_step(Space *space, const gsl_vector *x, gsl_vector *out)
{
    return step(space, space->sim, x, 1, out);
}

/* out = -(1 + A_0)^-1 A_1 x by out <- out + (b - out - A_0 out)/2, b = -A_1 x: at once with FLIP, half of the
 * error is left otherwise. */
static bool of_limit(Space *space, const gsl_vector *x, gsl_vector *out)
{
    enum { TURNS_MOST = 60 };
    gsl_vector *b = space->start, *change = space->change;
    const double dt = space->sim->dt;
    if (!step(space, space->sim, x, dt, b) || !step(space, space->still, x, space->still->dt, change))
        return false;
    gsl_vector_sub(b, change);
    gsl_vector_scale(b, -1 / (dt * dt));
    const double enough = 1e-15 * gsl_blas_dnrm2(b);
    gsl_vector_set_zero(out);
    for (int turn = 0; turn < TURNS_MOST; turn++) {
        if (!step(space, space->still, out, space->still->dt, change))
            return false;
        gsl_vector_sub(change, b);
        gsl_blas_daxpy(2, out, change); /* A_0 out + out - b */
        gsl_blas_daxpy(-0.5, change, out);
        if (gsl_blas_dnrm2(change) <= enough)
            break;
    }
    return true;
}

static double v_cm_of(Space *space, const gsl_vector *x)
{
    if (space->v_cm < 0)
        return 0;
    put(space, space->sim, x, 1);
    simulation_row(space->sim, space->row);
    return space->row[space->v_cm] / scale;
}

/* One vector more; *ended: the space is closed. */
static bool grow(Space *space, bool *ended)
{
    const int m = space->count++;
    gsl_vector_view from = gsl_matrix_row(space->vectors, (size_t)m),
                    next = gsl_matrix_row(space->vectors, (size_t)m + 1);
    gsl_matrix_view before = gsl_matrix_submatrix(space->vectors, 0, 0, (size_t)m + 1, next.vector.size);
    gsl_vector_view column = gsl_matrix_subcolumn(space->h, (size_t)m, 0, (size_t)m + 1);
    double again[VECTORS_MOST];
    gsl_vector_view more = gsl_vector_view_array(again, (size_t)m + 1);
    if (!space->map(space, &from.vector, &next.vector))
        return false;
    for (int pass = 0; pass < 2; pass++) { /* the second takes away what rounding has left */
        gsl_blas_dgemv(CblasNoTrans, 1, &before.matrix, &next.vector, 0, &more.vector);
        gsl_blas_dgemv(CblasTrans, -1, &before.matrix, &more.vector, 1, &next.vector);
        gsl_vector_add(&column.vector, &more.vector);
    }
    space->next = gsl_blas_dnrm2(&next.vector);
    const gsl_matrix_view h = gsl_matrix_submatrix(space->h, 0, 0, (size_t)m + 1, (size_t)m + 1);
    const double largest = fmax(gsl_matrix_max(&h.matrix), -gsl_matrix_min(&h.matrix));
    /* what rounding in x_1 - x_0 has left of other modes is not looked for: it is eps/|y| of y, and as much
     * over |y| again of the second vector of a mode */
    const double left = 4e-16 / space->length;
    *ended = space->next <= fmax(closed * largest, left * fmax(1, 0.25 / space->length));
    if (!*ended) {
        gsl_vector_scale(&next.vector, 1 / space->next);
        if (m + 1 < space->most)
            gsl_matrix_set(space->h, (size_t)m + 1, (size_t)m, space->next);
    }
    return isfinite(space->next);
}

/* sum w_j x_j */
static gsl_complex product(const gsl_vector_complex *w, const double *x)
{
    gsl_complex sum = gsl_complex_rect(0, 0);
    for (size_t j = 0; j < w->size; j++)
        sum = gsl_complex_add(sum, gsl_complex_mul_real(gsl_vector_complex_get(w, j), x[j]));
    return sum;
}

/* The share of the largest that oscillates, else of all: what does not is what a transfer takes from the
 * particles at once. */
static int largest_part(const StepModes *modes)
{
    int best[2] = {-1, -1};
    for (int k = 0; k < modes->count; k++) {
        const int moves = GSL_IMAG(modes->parts[k].mu) != 0;
        if (best[moves] < 0 || modes->parts[k].share > modes->parts[best[moves]].share)
            best[moves] = k;
    }
    return best[1] >= 0 && (best[0] < 0 || modes->parts[best[1]].share > 0.1) ? best[1] : best[0];
}

/* --- overlap ---------------------------------------------------------------------------------------- */

static void see_masses(Simulation *sim, void *out)
{
    simulation_make_ready(sim, 1);
    sim->method->field(sim, simulation_find_field(sim, 1, "mass"), 0, sim->counts[1], out);
}

static void see_momenta(Simulation *sim, void *out)
{
    simulation_make_ready(sim, 1);
    sim->method->field(sim, simulation_find_field(sim, 1, "momentum"), 0, sim->counts[1], out);
}

/* |sum p* s/m| / (|p| |s|), |p|^2 = sum |p|^2/m over the nodes */
static double overlap_of(const StepModes *modes, size_t nodes)
{
    const double *mass = modes->nodal, *s = mass + nodes, *re = s + nodes, *im = re + nodes;
    double both[2] = {0, 0}, own = 0, of_start = 0;
    for (size_t i = 0; i < nodes; i++) {
        const double weight = mass[i] > 0 ? 1 / mass[i] : 0;
        both[0] += weight * re[i] * s[i];
        both[1] += weight * im[i] * s[i];
        own += weight * (re[i] * re[i] + im[i] * im[i]);
        of_start += weight * s[i] * s[i];
    }
    return math_hypot(both[0], both[1]) / sqrt(own * of_start);
}

/* What the nodes have of the start and of the largest mode, V w. False: not enough memory. */
static bool find_overlap(Space *space, StepModes *modes, const gsl_vector_complex *w)
{
    Simulation *sim = space->sim;
    const size_t nodes = sim->counts[1], m = (size_t)space->count;
    const gsl_matrix_view v = gsl_matrix_submatrix(space->vectors, 0, 0, m, space->start->size);
    const gsl_vector_const_view parts[] = {gsl_vector_complex_const_real(w),
                                           gsl_vector_complex_const_imag(w)};
    free(modes->nodal);
    modes->nodal = calloc(4 * nodes, sizeof *modes->nodal);
    if (!modes->nodal)
        return false;
    put(space, sim, space->start, 1);
    if (!simulation_visit(sim, NULL, see_masses, modes->nodal) ||
        !simulation_visit(sim, NULL, see_momenta, modes->nodal + nodes))
        return false;
    for (int k = 0; k < 2; k++) {
        gsl_blas_dgemv(CblasTrans, 1, &v.matrix, &parts[k].vector, 0, space->change);
        put(space, sim, space->change, 1);
        if (!simulation_visit(sim, NULL, see_momenta, modes->nodal + (size_t)(2 + k) * nodes))
            return false;
    }
    modes->overlap = overlap_of(modes, nodes);
    return true;
}

/* Eigenvalues and shares of the space so far. False: not enough memory, or GSL found none. */
static bool look(Space *space, StepModes *modes, double sums[2][VECTORS_MOST])
{
    const size_t m = (size_t)space->count;
    const gsl_matrix_view h = gsl_matrix_submatrix(space->h, 0, 0, m, m);
    gsl_matrix *copy = gsl_matrix_alloc(m, m);
    gsl_matrix_complex *w = gsl_matrix_complex_alloc(m, m), *qr = gsl_matrix_complex_alloc(m, m);
    gsl_vector_complex *mu = gsl_vector_complex_alloc(m), *c = gsl_vector_complex_calloc(m);
    gsl_vector_complex *tau = gsl_vector_complex_alloc(m);
    gsl_eigen_nonsymmv_workspace *work = gsl_eigen_nonsymmv_alloc(m);
    bool good = copy && w && qr && mu && c && tau && work;
    if (good) {
        gsl_matrix_memcpy(copy, &h.matrix);
        good = gsl_can_converge(copy) && gsl_eigen_nonsymmv(copy, mu, w, work) == GSL_SUCCESS;
    }
    if (good) {
        gsl_matrix_complex_memcpy(
            qr, w); /* GSL's LU takes memory of its own and does not look whether it got it */
        gsl_vector_complex_set(c, 0, gsl_complex_rect(space->length, 0));
        good = gsl_linalg_complex_QR_decomp(qr, tau) == GSL_SUCCESS &&
               gsl_linalg_complex_QR_svx(qr, tau, c) == GSL_SUCCESS;
    }
    modes->count = 0;
    for (size_t k = 0; good && k < m; k++) {
        const gsl_vector_complex_view vector = gsl_matrix_complex_column(w, k);
        Part *part = &modes->parts[modes->count];
        part->mu = gsl_vector_complex_get(mu, k);
        const double re = GSL_REAL(part->mu), im = GSL_IMAG(part->mu);
        part->angle = math_atan2(im, 1 + re);
        /* |lambda|^2 = 1 + 2 Re mu + |mu|^2, by log1p: |lambda| - 1 is often below 1e-9 */
        part->decay = -math_log1p(2 * re + re * re + im * im) / 2;
        part->column = (int)k;
        const double size = gsl_complex_abs(part->mu);
        if (size < closed) /* of what stays */
            continue;
        const gsl_complex much = gsl_complex_div(gsl_vector_complex_get(c, k), part->mu);
        part->share = GSL_REAL(gsl_complex_mul(much, product(&vector.vector, sums[0]))) *
                      (GSL_IMAG(part->mu) != 0 ? 2 : 1);
        part->of_v_cm = gsl_complex_mul(much, product(&vector.vector, sums[1]));
        part->residual = space->next * gsl_complex_abs(gsl_vector_complex_get(&vector.vector, m - 1)) / size;
        modes->count++;
    }
    modes->largest = largest_part(modes);
    if (good && modes->largest >= 0 && simulation_has(space->sim, HAS_MESH)) {
        const gsl_vector_complex_view vector =
            gsl_matrix_complex_column(w, (size_t)modes->parts[modes->largest].column);
        good = find_overlap(space, modes, &vector.vector);
    }
    gsl_eigen_nonsymmv_free(work);
    gsl_vector_complex_free(tau);
    gsl_vector_complex_free(c);
    gsl_vector_complex_free(mu);
    gsl_matrix_complex_free(qr);
    gsl_matrix_complex_free(w);
    gsl_matrix_free(copy);
    return good;
}

static double growth(const Part *part)
{
    return gsl_complex_abs(gsl_complex_add_real(part->mu, 1)) - 1;
}

/* With a real lambda below 0 it changes its sign in each step. */
static bool flips(const Part *part)
{
    return GSL_IMAG(part->mu) == 0 && GSL_REAL(part->mu) < -1;
}

/* Until the space is closed, the mode has settled, or the bound is reached. */
static bool explore(Space *space, StepModes *modes, bool whole, Cancel cancel)
{
    double sums[2][VECTORS_MOST];
    gsl_vector_view y = gsl_matrix_row(space->vectors, 0);
    space->sim->method->small(space->sim, space->start->data, 1, false);
    const double start = gsl_blas_dnrm2(space->start);
    modes->whole = start == 0;
    if (!(start > 0))
        return true;
    gsl_vector_scale(space->start, 1 / start);
    modes->v_cm = start * v_cm_of(space, space->start);
    if (!space->map(space, space->start, &y.vector))
        return true;
    space->length = gsl_blas_dnrm2(&y.vector);
    if (!(space->length > 0))
        return true;
    gsl_vector_scale(&y.vector, 1 / space->length);
    bool ended = false;
    for (int next = FIRST_LOOK; !ended && space->count < space->most;) {
        if (cancel_requested(&cancel, (double)space->count / space->most)) {
            errno = ECANCELED;
            return false;
        }
        gsl_vector_view v = gsl_matrix_row(space->vectors, (size_t)space->count);
        gsl_blas_ddot(space->start, &v.vector, &sums[0][space->count]);
        sums[1][space->count] = start * v_cm_of(space, &v.vector);
        if (!grow(space, &ended))
            return true;
        if (!ended && space->count < space->most && space->count < next)
            continue;
        next *= 2;
        if (!look(space, modes, sums))
            return false;
        if (!whole && modes->largest >= 0 && modes->parts[modes->largest].residual < settled)
            break;
    }
    modes->whole = ended;
    for (int k = 0; k < modes->count; k++)
        modes->whole = modes->whole && growth(&modes->parts[k]) < grows;
    return true;
}

static bool reserve(Space *space, size_t n)
{
    const double most = fmin(fmin(VECTORS_MOST, numbers_most / (double)n), sqrt(work_most / (double)n));
    space->most = 2 * (int)fmax(most / 2, 2); /* even: an odd one has a real eigenvalue among pairs */
    space->v_cm = simulation_find_series(space->sim, "v_cm");
    space->row = malloc((size_t)space->sim->n_series * sizeof *space->row);
    space->start = gsl_vector_alloc(n);
    space->state = gsl_vector_alloc(n);
    space->change = gsl_vector_alloc(n);
    space->vectors = gsl_matrix_alloc((size_t)space->most + 1, n);
    space->h = gsl_matrix_calloc((size_t)space->most, (size_t)space->most);
    return space->row && space->start && space->state && space->change && space->vectors && space->h;
}

static void release(Space *space)
{
    gsl_matrix_free(space->h);
    gsl_matrix_free(space->vectors);
    gsl_vector_free(space->change);
    gsl_vector_free(space->state);
    gsl_vector_free(space->start);
    free(space->row);
}

StepModes *step_modes_create(Simulation *sim, bool whole, Cancel cancel)
{
    ASSERT(sim->method->small);
    const size_t n = sim->method->small(sim, NULL, 1, false);
    Space space = {.sim = sim, .map = of_step};
    if (numbers_most / (double)n < 6)
        return NULL;
    gsl_errors_off();
    StepModes *modes = calloc(1, sizeof *modes);
    bool good = modes && reserve(&space, n);
    if (good) {
        modes->dt = sim->dt;
        modes->largest = -1;
        modes->overlap = 1;
        good = explore(&space, modes, whole, cancel);
    }
    release(&space);
    gsl_errors_on();
    if (good)
        return modes;
    step_modes_free(modes);
    return NULL;
}

void step_modes_free(StepModes *modes)
{
    if (modes)
        free(modes->nodal);
    free(modes);
}

StepMode step_modes_largest(const StepModes *modes)
{
    if (modes->largest < 0)
        return (StepMode){.frequency = NAN, .decay = NAN, .overlap = NAN};
    const Part *part = &modes->parts[modes->largest];
    bool known = part->residual < converged && growth(part) < grows;
    /* Beyond its limit a mode without damping has two real eigenvalues below 0, lambda and 1/lambda, and each
     * has its part in the start: the one that decays tells nothing of a run that the other takes over. */
    for (int k = 0; k < modes->count && known && flips(part); k++) {
        const Part *other = &modes->parts[k];
        known = !(flips(other) && growth(other) >= grows && other->share > part->share / 10);
    }
    return (StepMode){.known = known,
                      .frequency = fabs(part->angle) / modes->dt,
                      .decay = part->decay / modes->dt,
                      .overlap = modes->overlap};
}

double step_modes_overlap(const StepModes *modes, Simulation *start)
{
    const size_t nodes = start->counts[1];
    return modes->largest >= 0 && simulation_visit(start, NULL, see_momenta, modes->nodal + nodes)
               ? overlap_of(modes, nodes)
               : NAN;
}

bool step_modes_are_whole(const StepModes *modes)
{
    return modes->whole;
}

/* v_cm(0) + sum of_v_cm (lambda^n - 1) */
double step_modes_v_cm(const StepModes *modes, long step)
{
    ASSERT_INT(step, >=, 0);
    double sum = modes->v_cm;
    for (int k = 0; k < modes->count && step > 0; k++) {
        const Part *part = &modes->parts[k];
        const double angle = (double)step * part->angle, lost = (double)step * part->decay;
        const double kept = lost < 100 ? math_exp(-lost) : 0; /* e^-100 of a part is below every digit */
        sum += GSL_REAL(part->of_v_cm) * (kept * math_cos(angle) - 1) -
               GSL_IMAG(part->of_v_cm) * kept * math_sin(angle);
    }
    return sum;
}

/* --- the largest step ----------------------------------------------------------------------------- */

/* The largest 1/dt^2 of the space so far; of two ends alike rounding may part a pair a little off the real
 * axis. NAN: GSL found no eigenvalues. */
static double largest_eigenvalue(Space *space)
{
    const size_t m = (size_t)space->count;
    gsl_matrix_view h = gsl_matrix_submatrix(space->h, 0, 0, m, m);
    gsl_matrix *copy = gsl_matrix_alloc(m, m);
    gsl_vector_complex *values = gsl_vector_complex_alloc(m);
    gsl_eigen_nonsymm_workspace *work = gsl_eigen_nonsymm_alloc(m);
    double largest = NAN;
    if (copy && values && work && gsl_matrix_memcpy(copy, &h.matrix) == GSL_SUCCESS &&
        gsl_can_converge(copy) && gsl_eigen_nonsymm(copy, values, work) == GSL_SUCCESS) {
        largest = 0;
        for (size_t k = 0; k < m; k++) {
            const gsl_complex value = gsl_vector_complex_get(values, k);
            if (fabs(GSL_IMAG(value)) <= 1e-3 * GSL_REAL(value))
                largest = fmax(largest, GSL_REAL(value));
        }
    }
    gsl_eigen_nonsymm_free(work);
    gsl_vector_complex_free(values);
    gsl_matrix_free(copy);
    return largest;
}

double step_modes_limit(Simulation *still, Simulation *moving, Cancel cancel)
{
    Space space = {.sim = moving, .still = still, .map = of_limit};
    const size_t n = moving->method->small(moving, NULL, 1, false);
    double limit = NAN;
    gsl_errors_off();
    if (reserve(&space, n)) {
        /* any vector that has a part of every mode; the map takes away what no node sees */
        gsl_vector_view first = gsl_matrix_row(space.vectors, 0), second = gsl_matrix_row(space.vectors, 1);
        uint32_t noise = 1;
        for (size_t i = 0; i < n; i++) {
            noise = noise * 1664525u + 1013904223u;
            gsl_vector_set(&second.vector, i, (double)noise / 4294967296.0 - 0.5);
        }
        bool ended = false, good = of_limit(&space, &second.vector, &first.vector);
        space.length = good ? gsl_blas_dnrm2(&first.vector) : 0;
        if (space.length > 0) {
            gsl_vector_scale(&first.vector, 1 / space.length);
            while (good && !ended && space.count < space.most) {
                good = !cancel_requested(&cancel, (double)space.count / space.most);
                errno = good ? errno : ECANCELED;
                good = good && grow(&space, &ended);
            }
        }
        if (good)
            limit = space.length > 0 ? sqrt(1 / largest_eigenvalue(&space)) : INFINITY;
    }
    release(&space);
    gsl_errors_on();
    return limit;
}

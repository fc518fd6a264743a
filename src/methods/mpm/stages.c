/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One step of the material point method, a function for each stage:
 *
 *     map         m_i = sum m N_i              p_i = sum m v N_i                                (2, 3)
 *     fix         p_i = m_i v0 along x, 0 across where a support holds; v_i = p_i/m_i           (4)
 *     strain      de = dt sym(sum grad N_i v_i)    stress += D de    V *= 1 + tr de             (5 to 9)
 *     force       f_i = -sum stress . grad N_i V + loads,   none at supports                    (10 to 12)
 *     integrate   p_i += dt f_i                                                                 (13)
 *     update      v += dt sum N_i f_i/m_i          x += dt sum N_i p_i/m_i                      (14, 15)
 *
 * Source: A. da Silva Rocha, "Unidimensional Axial Vibration Using MPM" (paper M), whose numbers these are;
 * sums over particles at a node i, over nodes at a particle; V = m/rho. Along a line de = dt sum N'_i v_i and
 * D = E; in the plane N = N_x N_y and D is that of plane stress,
 *
 *     sxx += lambda (exx + nu eyy)    syy += lambda (eyy + nu exx)    sxy += G gxy,   lambda = E/(1 - nu^2).
 *
 * Lengths, masses and forces of a line are per unit cross-section, those of the plane per unit thickness.
 *
 * Bodies have a field of velocities each; their `fix` is walls and contact (bodies_walls.c), done once more
 * behind `integrate`, which has damping:
 *
 *     map         also n_i = sum m grad N_i, r_i = sum m N_i x
 *     strain      L = sum v_i grad N_i, which turns the stress too; or F <- (I + dt L) F
 *     force       f_i = sum (m N_i g - V stress . grad N_i)
 *     integrate   q_i += dt (f_i - damping q_i)
 *     update      v += sum N_i (q_i - q0_i)/m_i with q0 as mapped; APIC: v = sum N_i q_i/m_i,
 *                 B = sum N_i (q_i/m_i) (x_i - x)^T
 *
 * A node with m <= 1e-12 rho dx^2 is light: fix and update leave it out. */
#include "base/math/functions.h"
#include "methods/mpm/mistakes.h"

#include <stdio.h>
#include <string.h>

/* --- what happens to particles ---------------------------------------------------------------------- */

bool mpm_fail_particle(Mpm *mpm, Status *status, int particle, const char *what)
{
    const bool light = bar_feels_light_nodes(&mpm->def, mpm->head->transfer);
    char text[200];
    char where[60] = "";
    if (mpm->bodies)
        snprintf(where, sizeof where, " at (%.4g, %.4g)", mpm->at[0][particle] + mpm->u[0][particle],
                 mpm->at[1][particle] + mpm->u[1][particle]);
    snprintf(text, sizeof text, "%s%s%s", what, where, light ? " (" BAR_LIGHT_NODES ")" : "");
    return batch_fail_particle(&mpm->sim, status, particle, text, mpm->def.problem == MPM_BEAM ? " s" : "");
}

/* The first crossing of a particle is an event; in the plane one event a step, as particles of a lattice
 * cross many at once. */
static void mpm_report_crossings(Mpm *mpm)
{
    const size_t count = (size_t)mpm->n_particles;
    uint8_t *at = mpm->crossed;
    int first = -1, others = 0;
    char text[120];
    while ((at = memchr(at, 2, count - (size_t)(at - mpm->crossed))) != NULL) {
        const int p = (int)(at - mpm->crossed);
        *at++ = 1;
        if (mpm->dim == 2) {
            others += first >= 0;
            first = first >= 0 ? first : p;
        } else if (mpm->sim.n_events == SIMULATION_EVENTS_MAX)
            mpm->sim.events_beyond.of[EVENT_CROSSING]++;
        else {
            snprintf(text, sizeof text, "particle %d crossed into cell %d", p,
                     mpm_cell(mpm->base[p], mpm->s[0][p], mpm->edge));
            batch_report(&mpm->sim, EVENT_CROSSING, text);
        }
    }
    if (first < 0)
        return;
    const int used = snprintf(text, sizeof text, "particle %d crossed into cell (%d, %d)", first,
                              mpm_cell(mpm->base[first] % mpm->gx, mpm->s[0][first], mpm->edge),
                              mpm_cell(mpm->base[first] / mpm->gx, mpm->s[1][first], mpm->edge));
    if (others > 0)
        snprintf(text + used, sizeof text - (size_t)used, ", %d others with it", others);
    batch_report(&mpm->sim, EVENT_CROSSING, text);
}

/* --- loops --------------------------------------------------------------------------------------- */

/* A loop over the nodes (a, b) of a particle, from its first one; its index and its N. */
#define EACH_NODE(dim, shape)                                                                                \
    for (int b = 0; b < ((dim) == 2 ? shape_support(shape) : 1); b++)                                        \
    _Pragma("GCC unroll 4") for (int a = 0; a < shape_support(shape); a++)
#define NODE_OF(at, dim, base) ((base) + ((dim) == 2 ? b * (at).gx : 0) + a)
#define N_OF(w, dim)           ((dim) == 2 ? (w).n[0][a] * (w).n[1][b] : (w).n[0][a])

/* What a run is to the loops: the step of paper M without more (FLIP, lumped masses, one material, no
 * mistake), any other one of a bar or a beam, one of bodies. */
typedef enum Kind { PLAIN, OTHER, BODIES } Kind;

/* Does what is said with dimension, shape and kind as constants; or with dimension and shape. */
#define WITH(the_dim, the_shape, ...)                                                                        \
    if (mpm->dim == (the_dim) && mpm->shape == (the_shape)) {                                                \
        const int dim = the_dim;                                                                             \
        const MpmShape shape = the_shape;                                                                    \
        __VA_ARGS__;                                                                                         \
    }
#define ON_LINE(...)                                                                                         \
    WITH(1, MPM_HAT, __VA_ARGS__)                                                                            \
    WITH(1, MPM_GIMP, __VA_ARGS__)                                                                           \
    WITH(1, MPM_CPDI, __VA_ARGS__)                                                                           \
    WITH(1, MPM_BSPLINE2, __VA_ARGS__)                                                                       \
    WITH(1, MPM_BSPLINE3, __VA_ARGS__)
#define IN_PLANE(...)                                                                                        \
    WITH(2, MPM_HAT, __VA_ARGS__)                                                                            \
    WITH(2, MPM_GIMP, __VA_ARGS__)                                                                           \
    WITH(2, MPM_BSPLINE2, __VA_ARGS__)
#define AS(the_kind, ...)                                                                                    \
    if (kind_now == (the_kind)) {                                                                            \
        const Kind kind = the_kind;                                                                          \
        __VA_ARGS__;                                                                                         \
    }
#define BY_KIND(...)                                                                                         \
    ON_LINE(AS(PLAIN, __VA_ARGS__) AS(OTHER, __VA_ARGS__))                                                   \
    IN_PLANE(AS(PLAIN, __VA_ARGS__) AS(OTHER, __VA_ARGS__) AS(BODIES, __VA_ARGS__))

/* What a loop over particles asks of the engine, read once. */
typedef struct Places {
    const int32_t *base;
    const double *s[MPM_AXES], *domain;
    double half;
    int cells, gx;
} Places;

MPM_INLINE Places places_of(const Mpm *mpm)
{
    return (Places){mpm->base, {mpm->s[0], mpm->s[1]}, mpm->domain, mpm->half, mpm->cells, mpm->gx};
}

MPM_INLINE MpmWeights weights_at(const Places *at, const int dim, const MpmShape shape, int p)
{
    MpmWeights w;
    for (int axis = 0; axis < dim; axis++) /* in the plane B-splines stay as they are at the grid's ends */
        shape_at(shape, shape == MPM_CPDI ? at->domain[p] : at->half, dim == 2 ? 1 << 20 : at->cells,
                 dim == 2 ? 2 : at->base[p], at->s[axis][p], w.n[axis], w.dn[axis]);
    return w;
}

/* --- what a stage does ------------------------------------------------------------------------------ */

/* Eqs. 2, 3: m_i = sum m N, p_i = sum m v N, with APIC v + C (x_i - x) in place of v (Jiang et al. 2015), in
 * the plane C = B D^-1; of masses that are not lumped also the couplings M_c(i, i + d) = sum m N_i N_(i+d).
 * MUSL's second map has the same masses. */
MPM_INLINE void map(Mpm *mpm, const int dim, const MpmShape shape, const Kind kind, const bool again,
                    int first, int end)
{
    const Places at = places_of(mpm);
    const bool affine = kind != PLAIN && mpm->head->transfer == MPM_APIC;
    const bool couples = kind == OTHER && !again && !mpm_is_lumped(mpm);
    double *const mass = mpm->node_mass, *const momentum[MPM_AXES] = {mpm->momentum[0], mpm->momentum[1]};
    const double *const velocity[MPM_AXES] = {mpm->v[0], mpm->v[1]}, of_all = mpm->mass[0];
    const double edge = mpm->edge, dx = mpm->dx;
    for (int p = first; p < end; p++) {
        const MpmWeights w = weights_at(&at, dim, shape, p);
        const int base = at.base[p];
        const double m = kind != OTHER ? of_all : mpm_mass(mpm, p);
        double v[MPM_AXES] = {0}, C[4] = {affine && dim == 1 ? mpm->affine[p] * dx : 0.0}; /* times dx */
        for (int axis = 0; axis < dim; axis++)
            v[axis] = velocity[axis][p];
        for (int axis = 0; affine && dim == 2 && axis < dim; axis++) {
            const double D = mpm_spread(shape, edge, at.s[axis][p], w.n[axis]) * dx;
            C[axis] = D > 0.0 ? mpm->rate[axis][p] / D : 0.0;
            C[2 + axis] = D > 0.0 ? mpm->rate[2 + axis][p] / D : 0.0;
        }
        EACH_NODE(dim, shape)
        {
            const int i = NODE_OF(at, dim, base);
            const double share = m * N_OF(w, dim);
            double arm[MPM_AXES] = {0};
            if (!again)
                mass[i] += share;
            if (affine && dim == 1)
                arm[0] = shape_node_offset(shape, at.half, at.cells, base, a) - at.s[0][p];
            else if (affine)
                arm[0] = a - (at.s[0][p] - edge), arm[1] = b - (at.s[1][p] - edge);
            for (int axis = 0; axis < dim; axis++)
                momentum[axis][i] +=
                    share * (affine ? v[axis] + (dim == 1 ? C[0] * arm[0]
                                                          : C[2 * axis] * arm[0] + C[2 * axis + 1] * arm[1])
                                    : v[axis]);
            for (int axis = 0; kind == BODIES && !again && axis < dim; axis++) {
                const double slope = axis == 0 ? w.dn[0][a] * w.n[1][b] : w.n[0][a] * w.dn[1][b];
                mpm->normal[axis][i] += m / dx * slope;
                mpm->moment[axis][i] += share * (mpm->at[axis][p] + mpm->u[axis][p]);
            }
        }
        for (int d = 1; couples && d < shape_support(shape); d++)
            for (int a = 0; a + d < shape_support(shape); a++)
                mpm->couple[d][base + a] += m * (w.n[0][a] * w.n[0][a + d]);
    }
}

/* Step 2 of paper M: p = m v0 along x and 0 across where a support holds the node; the mass stays. Then
 * eq. 4. A node of hardly any mass moves along with the body: one at rest would strain a particle that lands
 * on its neighbour to the last bit by v0 dt/dx. */
static void fix(Mpm *mpm, bool holds, int first, int end)
{
    const double floor = mpm->floor, *const mass = mpm->node_mass;
    double *const inverse = mpm->inverse;
#pragma omp simd
    for (int i = first; i < end; i++)
        inverse[i] = mass[i] > floor ? 1.0 / mass[i] : 0.0;
    for (int axis = 0; axis < mpm->dim; axis++) {
        const double speed = axis == 0 ? mpm->speed : 0.0, *const free = mpm->free[axis];
        double *const momentum = mpm->momentum[axis], *const velocity = mpm->velocity[axis];
#pragma omp simd
        for (int i = first; i < end; i++) {
            const double p = holds && free[i] == 0.0 ? mass[i] * speed : momentum[i];
            momentum[i] = p;
            velocity[i] = inverse[i] > 0.0 ? p * inverse[i] : speed;
        }
    }
}

/* Eqs. 6 to 9 in the plane, hypoelastic (the turn of Hughes, Winget 1980, where it is asked for), with eps =
 * dt sym L and D of plane strain or plane stress:
 *
 *     dw = dt (dv/dx - du/dy)/2,   tan(theta/2) = dw/2,   Q = [c -s; s c]
 *     stress <- Q stress Q^T + D eps,   V <- V (1 + tr eps) */
MPM_INLINE double strain_hypoelastic(Mpm *mpm, const double *L, int p, const bool newest)
{
    double xx = newest ? 0.0 : mpm->stress[0][p], yy = newest ? 0.0 : mpm->stress[1][p];
    double xy = newest ? 0.0 : mpm->stress[2][p];
    if (mpm->turn != 0.0) {
        const double half = mpm->turn * (L[2] - L[1]), whole = 1.0 / (1.0 + half * half);
        const double c = (1.0 - half * half) * whole, s = 2.0 * half * whole;
        const double turn = 2.0 * c * s * xy, X = c * c * xx + s * s * yy - turn;
        xy = c * s * (xx - yy) + (c * c - s * s) * xy;
        yy = s * s * xx + c * c * yy + turn;
        xx = X;
    }
    mpm->stress[0][p] = xx + (mpm->D11 * L[0] + mpm->D12 * L[3]);
    mpm->stress[1][p] = yy + (mpm->D12 * L[0] + mpm->D11 * L[3]);
    mpm->stress[2][p] = xy + mpm->slide * (L[1] + L[2]);
    const double left = 1.0 + (L[0] + L[3]);
    mpm->volume[p] = mpm_volume_behind(mpm, mpm->volume[p], left);
    return left;
}

/* Neo-Hookean: F <- (I + dt L) F, J = det F, stress = (G (F F^T - I) + lambda ln J I)/J, V = J V0. */
MPM_INLINE double strain_neo_hookean(Mpm *mpm, const double *L, int p)
{
    const double G = mpm->shear;
    double *const F[4] = {mpm->deformation[0] + p, mpm->deformation[1] + p, mpm->deformation[2] + p,
                          mpm->deformation[3] + p};
    for (int column = 0; column < 2; column++) {
        const double x = *F[column], y = *F[2 + column];
        *F[column] = x + (L[0] * x + L[1] * y);
        *F[2 + column] = y + (L[2] * x + L[3] * y);
    }
    const double J = *F[0] * *F[3] - *F[1] * *F[2];
    mpm->volume[p] = J * mpm->volume_start;
    if (!(J > 0.0))
        return J;
    const double swell = mpm->lambda * math_log(J), inverse = 1.0 / J;
    mpm->stress[0][p] = (G * (*F[0] * *F[0] + *F[1] * *F[1] - 1.0) + swell) * inverse;
    mpm->stress[1][p] = (G * (*F[2] * *F[2] + *F[3] * *F[3] - 1.0) + swell) * inverse;
    mpm->stress[2][p] = G * (*F[0] * *F[2] + *F[1] * *F[3]) * inverse;
    return J;
}

/* Eqs. 5, 7, 8, 9: dt L, L = sum v_i grad N, and what it makes of the stress; along a line de = dt L. A light
 * node of bodies moves as the particle itself does: at rest it would make v/dx out of nothing. Returns the
 * first particle whose volume is not positive any more; -1: there is none. */
MPM_INLINE int strain(Mpm *mpm, const int dim, const MpmShape shape, const Kind kind, int first, int end)
{
    const Places at = places_of(mpm);
    const bool errs = kind == OTHER && mpm->wrong != 0;
    const bool newest = kind == OTHER && mpm_does(mpm, WRONG_ONLY_NEWEST);
    const bool late = kind == OTHER && mpm_does(mpm, WRONG_VOLUME_LATE);
    const bool neo = kind == BODIES && bodies_are_neo(mpm);
    const double rate = mpm_strain_span(mpm) * mpm_slope_scale(mpm, OP_STRAIN), of_all = mpm->modulus[0];
    const double *const vx = mpm->velocity[0], *const vy = mpm->velocity[1], *const inverse = mpm->inverse;
    double *const stress = mpm->stress[0], *const volume = mpm->volume, *const kept = mpm->kept_volume;
    int crushed = -1;
    for (int p = first; p < end; p++) {
        const MpmWeights w = weights_at(&at, dim, shape, p);
        const int base = at.base[p];
        double L[4] = {0}, v[SHAPE_SUPPORT_MAX], left; /* L: xx, xy, yx, yy */
        if (dim == 1)
            mpm_line_velocities(shape, vx, inverse, base, v);
        EACH_NODE(dim, shape)
        {
            const int i = NODE_OF(at, dim, base);
            if (dim == 1) {
                L[0] += w.dn[0][a] * v[a];
                continue;
            }
            const double bx = w.dn[0][a] * w.n[1][b], by = w.n[0][a] * w.dn[1][b];
            const bool light = kind == BODIES && !(inverse[i] > 0.0);
            const double x = light ? mpm->v[0][p] : vx[i], y = light ? mpm->v[1][p] : vy[i];
            L[0] += x * bx;
            L[1] += x * by;
            L[2] += y * bx;
            L[3] += y * by;
        }
        for (int k = 0; k < dim * dim; k++)
            L[k] *= rate;
        if (late)
            kept[p] = volume[p];
        if (dim == 2)
            left = neo ? strain_neo_hookean(mpm, L, p) : strain_hypoelastic(mpm, L, p, newest);
        else {
            left = 1.0 + L[0];
            stress[p] = (newest ? 0.0 : stress[p]) + (kind != OTHER ? of_all : mpm_modulus(mpm, p)) * L[0];
            volume[p] = errs ? mpm_volume_behind(mpm, volume[p], left) : volume[p] * left;
        }
        if (!(left > 0.0) && !(errs && isfinite(left) && left != 0.0) && crushed < 0) /* who errs goes on */
            crushed = p;
    }
    return crushed;
}

/* Eq. 10: f_i = -sum stress . grad N_i V, the same grad N that makes the strain: what forces do to nodes is
 * what stress does in particles. With USF stress and volume are those of this step, with USL and MUSL the old
 * ones. Eq. 11: each particle's load goes to its nodes by N. */
MPM_INLINE void force(Mpm *mpm, const int dim, const MpmShape shape, const Kind kind, int first, int end)
{
    const Places at = places_of(mpm);
    const bool loaded = dim == 1 && mpm_is_loaded(mpm);
    const ForceTerms loads = mpm_forces(mpm);
    const double scale = mpm_force_share(mpm) * mpm_slope_scale(mpm, OP_FORCE), of_load = mpm_load_share(mpm);
    const double *const stress = mpm->stress[0], *const volume = mpm->volume;
    const double *const syy = mpm->stress[1], *const sxy = mpm->stress[2];
    double *const fx = mpm->force[0], *const fy = mpm->force[1];
    const double *const g = kind == BODIES ? mpm->def.gravity : NULL, m = mpm->mass[0];
    for (int p = first; p < end; p++) {
        const MpmWeights w = weights_at(&at, dim, shape, p);
        const int base = at.base[p];
        if (dim == 2) {
            const double V = scale * (kind != OTHER ? volume[p] : mpm_force_volume(mpm, p));
            double of[MPM_STRESSES] = {stress[p], syy[p], sxy[p]};
            if (kind == OTHER)
                mpm_force_stress(mpm, p, of);
            const double xx = of[0] * V, yy = of[1] * V, xy = of[2] * V;
            EACH_NODE(dim, shape)
            {
                const double bx = w.dn[0][a] * w.n[1][b], by = w.n[0][a] * w.dn[1][b];
                const int i = NODE_OF(at, dim, base);
                const double share = kind == BODIES ? m * N_OF(w, dim) : 0.0;
                fx[i] += kind == BODIES ? share * g[0] + (bx * xx + by * xy) : bx * xx + by * xy;
                fy[i] += kind == BODIES ? share * g[1] + (bx * xy + by * yy) : bx * xy + by * yy;
            }
            continue;
        }
        double of[MPM_STRESSES] = {stress[p]};
        if (kind == OTHER)
            mpm_force_stress(mpm, p, of);
        const double pull = scale * (of[0] * (kind != OTHER ? volume[p] : mpm_force_volume(mpm, p)));
        EACH_NODE(dim, shape)
        fx[NODE_OF(at, dim, base)] += w.dn[0][a] * pull;
        if (!loaded)
            continue;
        const double load = of_load * forces_on(&loads, &mpm->sim, (size_t)p, 0);
        EACH_NODE(dim, shape)
        mpm->load[NODE_OF(at, dim, base)] += N_OF(w, dim) * load;
    }
}

/* Eqs. 12, 13: p_i += dt f_i; then what eqs. 14, 15 need of a node: kick = dt f_i/m_i and carry = p_i/m_i.
 * Where masses are not lumped kick is there already, and the integrated velocity is the one before plus it.
 * USF: the velocity that strained stays as it is. */
static void integrate(Mpm *mpm, int first, int end)
{
    const bool lumped = mpm_is_lumped(mpm), loaded = mpm_is_loaded(mpm),
               usf = mpm->head->algorithm == MPM_USF;
    const bool pulls = mpm_does(mpm, WRONG_HELD_PULL), all_free = pulls || mpm_does(mpm, WRONG_HELD_YIELD);
    const double dt = mpm->dt, *const inverse = mpm->inverse, *const mass = mpm->node_mass,
                 *const load = loaded ? mpm->load : NULL;
    for (int axis = 0; axis < mpm->dim; axis++) {
        const double speed = axis == 0 ? mpm->speed : 0.0, *const free = mpm->free[axis];
        double *const momentum = mpm->momentum[axis], *const force = mpm->force[axis];
        double *const kick = mpm->kick[axis], *const carry = mpm->carry[axis];
        double *const velocity = mpm->velocity[axis];
#pragma omp simd
        for (int i = first; i < end; i++) {
            const double f = load ? force[i] + load[i] : force[i];
            const double impulse = dt * (all_free ? f : f * free[i]);
            const double sum = momentum[i] + impulse;
            const double after = pulls && free[i] == 0.0 ? mass[i] * speed : sum;
            momentum[i] = after;
            if (lumped)
                kick[i] = impulse * inverse[i];
            carry[i] = !lumped ? velocity[i] + kick[i] : inverse[i] > 0.0 ? after * inverse[i] : speed;
        }
        if (!usf)
            memcpy(velocity + first, carry + first, (size_t)(end - first) * sizeof *carry);
    }
}

/* C = sum N_i v_i d_i/sum N_i d_i^2 with d_i = x_i - x; of hats C = sum N'_i v_i. A particle on the end of
 * the mesh has no spread. */
MPM_INLINE double slope_of(const Mpm *mpm, const MpmShape shape, int p, const MpmWeights *w)
{
    double v[SHAPE_SUPPORT_MAX], slope = 0.0, moment = 0.0, spread = 0.0;
    mpm_line_velocities(shape, mpm->carry[0], mpm->inverse, mpm->base[p], v);
    for (int a = 0; a < shape_support(shape); a++) {
        const double arm = shape_node_offset(shape, mpm->half, mpm->cells, mpm->base[p], a) - mpm->s[0][p];
        slope += w->dn[0][a] * v[a];
        moment += w->n[0][a] * v[a] * arm;
        spread += w->n[0][a] * (arm * arm);
    }
    if (mpm_does(mpm, WRONG_AFFINE_OF_BSPLINE)) /* its D is dx^2/4 */
        return 4.0 * moment / mpm->dx;
    if (mpm_does(mpm, WRONG_AFFINE_UNDIVIDED))
        return moment * mpm->dx;
    if (shape == MPM_HAT)
        return slope / mpm->dx;
    return spread > 0.0 ? moment / spread / mpm->dx : 0.0;
}

/* Eqs. 14, 15, shape functions those of the old place for v and x alike:
 *
 *     FLIP   v += sum N kick                                     x += dt sum N carry
 *     blend  v = alpha (v + sum N kick) + (1 - alpha) sum N carry
 *     APIC   v = sum N carry, C of slope_of(); in the plane B = sum N carry (x_i - x)^T
 *     FMPM   v = sum N carry                                     x += dt (v before + v)/2
 *
 * FLIP leaves in v whatever the grid cannot see; PIC's share and FMPM take it away in each step. x moves with
 * the nodes' velocity (eq. 15), not with the particle's own: neighbours cannot overtake each other, as the
 * grid's velocity is continuous. */
MPM_INLINE void update(Mpm *mpm, const int dim, const MpmShape shape, const Kind kind, int first, int end)
{
    const Places at = places_of(mpm);
    const double alpha = kind == PLAIN ? 1.0 : mpm->head->flip_fraction, dt = mpm->dt;
    const MpmTransfer transfer = kind == PLAIN ? MPM_FLIP : mpm->head->transfer;
    const bool by_itself = kind == OTHER && mpm_does(mpm, WRONG_MOVES_BY_ITSELF);
    const bool with_mapped = kind == OTHER && mpm_does(mpm, WRONG_MOVES_WITH_MAPPED);
    const bool as_nodes = kind != OTHER || !(mpm_does(mpm, WRONG_MOVES_WITH_OLD) ||
                                             mpm_does(mpm, WRONG_MOVES_WITH_MEAN) || with_mapped);
    const bool affine = dim == 2 && transfer == MPM_APIC;
    const double edge = mpm->edge, dx = mpm->dx;
    const bool new_weights = kind == OTHER && mpm_does(mpm, WRONG_NEW_WEIGHTS);
    double *const us[MPM_AXES] = {mpm->u[0], mpm->u[1]}, *const vs[MPM_AXES] = {mpm->v[0], mpm->v[1]};
    const double *const kick[MPM_AXES] = {mpm->kick[0], mpm->kick[1]};
    const double *const carry[MPM_AXES] = {mpm->carry[0], mpm->carry[1]};
    for (int p = first; p < end; p++) {
        const MpmWeights w = weights_at(&at, dim, shape, p);
        const int base = at.base[p];
        double dv[MPM_AXES] = {0}, now[MPM_AXES] = {0}, B[4] = {0}, other[MPM_AXES] = {0};
        EACH_NODE(dim, shape)
        {
            const int i = NODE_OF(at, dim, base);
            for (int axis = 0; axis < dim; axis++) {
                dv[axis] += N_OF(w, dim) * kick[axis][i];
                const double share = N_OF(w, dim) * carry[axis][i];
                now[axis] += share;
                if (affine) {
                    B[2 * axis] += share * (a - (at.s[0][p] - edge));
                    B[2 * axis + 1] += share * (b - (at.s[1][p] - edge));
                }
            }
            if (!as_nodes)
                for (int axis = 0; axis < dim; axis++)
                    other[axis] += N_OF(w, dim) * mpm_moving_velocity(mpm, axis, p, i);
        }
        for (int k = 0; affine && k < 4; k++)
            mpm->rate[k][p] = B[k] * dx;
        if (dim == 1 && transfer == MPM_APIC)
            mpm->affine[p] = slope_of(mpm, shape, p, &w);
        for (int axis = 0; axis < dim; axis++) {
            const double v = vs[axis][p], u = us[axis][p];
            const double mean = transfer == MPM_FMPM ? 0.5 * (v + now[axis]) : now[axis];
            if (!with_mapped)
                us[axis][p] = u + dt * (as_nodes ? mean : other[axis]);
            if (new_weights)
                dv[axis] = mpm_kick_at_new_place(mpm, p);
            vs[axis][p] = transfer != MPM_FLIP ? now[axis]
                          : alpha == 1.0       ? v + dv[axis]
                                               : alpha * (v + dv[axis]) + (1.0 - alpha) * now[axis];
            if (by_itself)
                us[axis][p] = u + dt * vs[axis][p];
        }
    }
}

/* --- the stages by their name ----------------------------------------------------------------------- */

bool mpm_op_gives(MpmOp op)
{
    return op == OP_MAP || op == OP_MAP_AGAIN || op == OP_FORCE;
}

bool mpm_op_of_nodes(MpmOp op)
{
    return op == OP_FIX || op == OP_FIX_FORCE || op == OP_FIX_MOVED || op == OP_INTEGRATE ||
           op == OP_FIX_AGAIN;
}

static void empty(double *from, const double *end)
{
    memset(from, 0, (size_t)(end - from) * sizeof *from);
}

/* Done before the first item of a stage: sums begin at 0. */
void mpm_begin_stage(Mpm *mpm, MpmOp op, long step)
{
    const bool loaded = mpm->dim == 1 && mpm_is_loaded(mpm);
    if (op == OP_MAP)
        empty(mpm->momentum[0], mpm->inverse);
    else if (op == OP_MAP_AGAIN)
        empty(mpm->momentum[0], mpm->node_mass);
    else if (op == OP_FORCE)
        empty(loaded ? mpm->load : mpm->force[0], mpm->velocity[0]);
    for (int d = 1; op == OP_MAP && d < mpm->support && !mpm_is_lumped(mpm); d++)
        empty(mpm->couple[d], mpm->couple[d] + mpm->n_nodes);
    if (op == OP_UPDATE && mpm->dim == 1 && mpm->notes_sums) {
        mpm->head->moment = mpm_sum(mpm, mpm->u[0]);
        mpm->head->pushed = 0.0;
        for (int i = 0; loaded && i < mpm->n_nodes; i++)
            mpm->head->pushed += mpm->load[i];
    }
    for (int axis = 0; op == OP_UPDATE && mpm->notes_sums && !mpm->bodies && axis < mpm->dim; axis++)
        mpm->head->momentum[axis] = mpm_sum(mpm, mpm->v[axis]);
    mpm_find_held(mpm, step);
    /* a channel that moves with v0 does work on the beam there: -f_x v0 dt times the thickness, J, f_x the
     * beam's force */
    double push = 0.0;
    for (int i = 0; op == OP_FIX_FORCE && mpm->speed != 0.0 && i < mpm->n_nodes; i++)
        if (mpm->free[0][i] == 0.0)
            push += mpm->force[0][i];
    if (op == OP_FIX_FORCE)
        mpm->head->work -= push * mpm->speed * mpm->dt * mpm->def.thickness;
}

/* Returns the first particle of [first, end) with which the run cannot go on; -1: there is none. */
int mpm_do_particles(Mpm *mpm, MpmTask task, MpmSpan *span, int first, int end)
{
    const bool plain = mpm->head->transfer == MPM_FLIP && mpm->head->flip_fraction == 1.0 &&
                       mpm_is_lumped(mpm) && mpm->wrong == 0 && mpm->joint == mpm->n_particles;
    const Kind kind_now = mpm->bodies ? BODIES : plain ? PLAIN : OTHER;
    const double shift = mpm_shift(mpm, task.step + 1); /* of the next step's grid */
    uint8_t *const crossed = mpm->bodies ? NULL : mpm->crossed;
    int bad = -1;
    switch (task.op) {
    case OP_MAP:
    case OP_MAP_AGAIN:
        BY_KIND(map(mpm, dim, shape, kind, task.op == OP_MAP_AGAIN, first, end))
        break;
    case OP_STRAIN:
        BY_KIND(bad = strain(mpm, dim, shape, kind, first, end))
        break;
    case OP_FORCE:
        BY_KIND(force(mpm, dim, shape, kind, first, end))
        break;
    case OP_UPDATE:
        BY_KIND(update(mpm, dim, shape, kind, first, end))
        break;
    case OP_FORGET: /* the grid: where the particles lie on that of the next step */
        ON_LINE(bad = mpm_set_places(mpm, dim, shape, shift, first, end, span, crossed))
        IN_PLANE(bad = mpm_set_places(mpm, dim, shape, shift, first, end, span, crossed))
        break;
    default:
        break;
    }
    return bad;
}

void mpm_do_nodes(Mpm *mpm, MpmOp op, int first, int end)
{
    if (mpm->bodies && op == OP_INTEGRATE)
        bodies_integrate(mpm, first, end);
    else if (mpm->bodies)
        bodies_fix(mpm, op, first, end);
    else if (op == OP_INTEGRATE)
        integrate(mpm, first, end);
    else if (op == OP_FIX_FORCE) { /* supports take the force of the nodes that they hold */
        for (int axis = 0; axis < 2; axis++)
            for (int i = first; i < end; i++)
                mpm->force[axis][i] = mpm_holds_force(mpm, axis, i) ? 0.0 : mpm->force[axis][i];
    } else
        fix(mpm,
            op == OP_FIX ? !mpm_does(mpm, WRONG_HOLDS_LATE) && !mpm_does(mpm, WRONG_HOLDS_NEVER)
                         : !mpm_does(mpm, WRONG_NO_SECOND_FIX),
            first, end);
}

/* What takes all of its items, or must be seen in order. */
bool mpm_end_stage(Mpm *mpm, MpmOp op, Status *status)
{
    const size_t bytes = (size_t)mpm->n_nodes * sizeof(double);
    if (mpm->bodies) {
        if (op == OP_FIX_MOVED)
            bodies_note_contact(mpm);
        if (op == OP_FORGET)
            bodies_note_tear(mpm), bodies_note_spin(mpm);
        return true;
    }
    for (int i = 0; mpm_adds_to_grid(mpm, op) && i < mpm->n_nodes; i++) {
        if (op == OP_MAP)
            mpm->node_mass[i] += mpm->kept_mass[i];
        for (int axis = 0; axis < mpm->dim; axis++)
            mpm->momentum[axis][i] += mpm->kept_momentum[axis][i];
    }
    switch (op) {
    case OP_MAP_AGAIN:
        if (mpm->dim == 2)
            return true; /* supports have a stage of their own */
        fix(mpm, !mpm_does(mpm, WRONG_NO_SECOND_FIX), 0, mpm->n_nodes);
        mpm_move_with_mapped(mpm);
        break;
    case OP_FIX_AGAIN:
        mpm_move_with_mapped(mpm);
        return true;
    case OP_STRAIN:
        for (int i = 0; mpm_does(mpm, WRONG_HOLDS_LATE) && i < mpm->n_nodes; i++)
            for (int axis = 0; axis < mpm->dim; axis++)
                if (mpm->free[axis][i] == 0.0)
                    mpm->momentum[axis][i] = axis == 0 ? mpm->node_mass[i] * mpm->speed : 0.0;
        for (int p = 0; mpm->shape == MPM_CPDI && p < mpm->n_particles; p++)
            if (!(mpm->volume[p] < 2.0 * mpm->dx))
                return mpm_fail_particle(mpm, status, p, "was stretched over two cells");
        return true;
    case OP_FORCE:
        if (mpm_is_lumped(mpm))
            return true; /* integrate() does it node by node */
        /* dt a with M a = f, or FMPM's series of dt f: it is linear, so that v(k) of p + dt f is the sum of
         * both */
        for (int i = 0; i < mpm->n_nodes; i++)
            mpm->kick[0][i] = mpm->dt * (mpm->force[0][i] + (mpm_is_loaded(mpm) ? mpm->load[i] : 0.0));
        mpm_solve(mpm, mpm->kick[0]);
        return true;
    case OP_INTEGRATE:
        /* the work of the loads, sum f_ext dx_i, with the velocity by which particles move */
        for (int i = 0; mpm->dim == 1 && mpm_is_loaded(mpm) && i < mpm->n_nodes; i++)
            if (!mpm_holds_force(mpm, 0, i))
                mpm->head->work += mpm->load[i] * (mpm->dt * mpm->carry[0][i]);
        if (mpm_does(mpm, WRONG_KEEPS_INTEGRATED) || mpm_does(mpm, WRONG_KEEPS_TWICE))
            for (int axis = 0; axis < mpm->dim; axis++)
                memcpy(mpm->kept_momentum[axis], mpm->momentum[axis], bytes);
        return true;
    case OP_FORGET:
        for (int k = 0; mpm->dim == 1 && k < mpm->n_chunks; k++) {
            const int p = mpm->chunks[k].first;
            if (p > 0 && mpm->base[p] + mpm->s[0][p] < mpm->base[p - 1] + mpm->s[0][p - 1])
                return mpm_fail_particle(mpm, status, p, "was overtaken by its neighbour (1 + de <= 0)");
        }
        mpm_report_crossings(mpm);
        if (mpm_does(mpm, WRONG_KEEPS_GRID)) {
            memcpy(mpm->kept_mass, mpm->node_mass, bytes);
            for (int axis = 0; axis < mpm->dim && !mpm_does(mpm, WRONG_KEEPS_INTEGRATED); axis++)
                memcpy(mpm->kept_momentum[axis], mpm->momentum[axis], bytes);
        }
        return true;
    default:
        break;
    }
    if ((op == OP_FIX || op == OP_MAP_AGAIN) && !mpm_is_lumped(mpm)) {
        /* supports are done: the velocities of all nodes together */
        if (op == OP_FIX)
            mpm_factor(mpm);
        memcpy(mpm->velocity[0], mpm->momentum[0], bytes);
        mpm_solve(mpm, mpm->velocity[0]);
    }
    return true;
}

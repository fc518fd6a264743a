/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Part of bar_kernels.c: the stages on a run of cells with P particles each, as many cells at once as a
 * vector has numbers. The j-th particles of these cells lie side by side (bar_state.h), so a vector holds one
 * number of the j-th particle of each cell, and every sum over a cell's particles is taken in the order of
 * kernels_cell.h: the bits are the same. The few cells at the end of a run that do not fill a vector are done
 * one by one there.
 *
 * A run ends where a cell has lost or won a particle, where the material changes and where the mesh ends:
 * within it all cells are alike. The shape, and for hats the usual two particles, are constants where these
 * functions are called, so their branches cost nothing. Sums over nodes (gather in bar_kernels.c) come
 * afterwards.
 *
 * The arrays of all functions: s, v, stress, volume, affine, moved by slot and place in the slot; node arrays
 * by node, the cell's a-th node being c + a; part[.][a] by cell. Units as in bar_kernels.c. */

#define REAL        Vector
#define SHAPE_INNER shape_inner_vector
#define ABSOLUTE(x) vector_absolute(x)
#include "methods/mpm/line/kernels/shape_inner.h"
#undef REAL
#undef SHAPE_INNER
#undef ABSOLUTE

/* The end of the run from c on, of cells with P particles of one material in which the shape functions are
 * the inner ones; c itself if there is none. B-splines differ in the first and last cells of the mesh, whose
 * knots are repeated. */
KERNEL_INLINE int run_end(const Bar *bar, MpmShape shape, int c, int end)
{
    const int ends = shape_end_cells(shape);
    if (c < ends)
        return c;
    if (end > bar->n_cells - ends)
        end = bar->n_cells - ends;
    if (c >= end)
        return c;
    const int stop = bar_run_end(bar, c, end), before = bar->joint - bar->first[c];
    return before > 0 && before < (stop - c) * bar->slots ? c + before / bar->slots : stop;
}

/* The same where hats strain, or give APIC its slope: a node may be inactive where the bar ends, see
 * bar_lend_velocity(), so that the last cells are done one by one. */
KERNEL_INLINE int strain_run_end(const Bar *bar, MpmShape shape, int c, int end)
{
    const int stop = run_end(bar, shape, c, end);
    if (shape != MPM_HAT || stop == c)
        return stop;
    if (c == 0 || bar->first[c - 1] == bar->first[c])
        return c;
    return stop - (stop == bar->n_cells || bar->first[stop] == bar->first[stop + 1]);
}

/* Two particles in a cell are what most people run: a copy of the loops over hats for them alone. */
#define EACH_CELL(first, end, run_end, cell, run)                                                            \
    for (int c = (first), stop; c < (end); c = stop) {                                                       \
        stop = run_end(bar, shape, c, end);                                                                  \
        if (stop == c) {                                                                                     \
            stop = c + 1;                                                                                    \
            cell;                                                                                            \
        } else if (shape == MPM_HAT && bar->slots == 2) {                                                    \
            const int slots = 2;                                                                             \
            run;                                                                                             \
        } else {                                                                                             \
            const int slots = bar->slots;                                                                    \
            run;                                                                                             \
        }                                                                                                    \
    }

/* Where the arrays of the j-th particles begin, j = 0 to P - 1, for a run whose first particle is given. */
KERNEL_INLINE void slots_of_run(double *const *arrays, int slots, int particle, double **out)
{
    int slot = particle % slots, k = particle / slots;
    for (int j = 0; j < slots; j++) {
        out[j] = arrays[slot] + k;
        if (++slot == slots) {
            slot = 0;
            k++;
        }
    }
}

/* The same of half-widths; only CPDI's particles have their own. */
KERNEL_INLINE void halves_of_run(const Bar *bar, MpmShape shape, int slots, int particle, double **out)
{
    if (shape == MPM_CPDI)
        slots_of_run(bar->half, slots, particle, out);
    else
        for (int j = 0; j < slots; j++)
            out[j] = NULL;
}

KERNEL_INLINE Vector vector_half(MpmShape shape, const double *own, int i, double of_all)
{
    return shape == MPM_CPDI ? vector_load(own + i) : (Vector){0} + of_all;
}

/* Where node a of an inner cell lies, from the cell's left edge in units of dx. */
KERNEL_INLINE double inner_offset(MpmShape shape, int a)
{
    return shape == MPM_HAT ? a : shape == MPM_BSPLINE2 ? a - 0.5 : a - 1;
}

/* Eqs. 2 and 3 over m, a cell's share: part[0][a] = sum N_a, part[1][a] = sum v N_a; APIC: v + C (x_a - x) in
 * place of v (Jiang et al. 2015, eq. 10). */
KERNEL_INLINE void map_run(Bar *bar, MpmShape shape, bool affine, int slots, int c, int stop)
{
    const int support = shape_support(shape);
    const double dx = bar->dx, weight = bar_weight(bar, bar->first[c]);
    double *h_of[BAR_SLOTS_MAX], *s_of[BAR_SLOTS_MAX], *v_of[BAR_SLOTS_MAX], *affine_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, bar->first[c], s_of);
    halves_of_run(bar, shape, slots, bar->first[c], h_of);
    slots_of_run(bar->v, slots, bar->first[c], v_of);
    slots_of_run(bar->affine, slots, bar->first[c], affine_of);
    for (int i = 0; c + VECTOR_WIDTH <= stop; c += VECTOR_WIDTH, i += VECTOR_WIDTH) {
        Vector mass[BAR_SUPPORT_MAX], momentum[BAR_SUPPORT_MAX];
#pragma GCC unroll 4
        for (int a = 0; a < support; a++)
            mass[a] = momentum[a] = -(Vector){0};
#pragma GCC unroll 2
        for (int j = 0; j < slots; j++) {
            const Vector h = vector_half(shape, h_of[j], i, bar->gimp_half);
            const Vector s = vector_load(s_of[j] + i), v = vector_load(v_of[j] + i);
            Vector n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_inner_vector(shape, &h, &s, n, dn);
#pragma GCC unroll 4
            for (int a = 0; a < support; a++) {
                Vector given = v;
                if (affine)
                    given += vector_load(affine_of[j] + i) * dx * (inner_offset(shape, a) - s);
                mass[a] += n[a];
                momentum[a] += given * n[a];
            }
        }
        if (weight != 1.0) /* of the second material */
            for (int a = 0; a < support; a++) {
                mass[a] *= weight;
                momentum[a] *= weight;
            }
#pragma GCC unroll 4
        for (int a = 0; a < support; a++) {
            vector_store(bar->part[0][a] + c, mass[a]);
            vector_store(bar->part[1][a] + c, momentum[a]);
        }
    }
    for (; c < stop; c++)
        map_cell(bar, shape, affine, c);
}

/* Eqs. 5, 7, 8, 9: de = dt sum N'_a v_a, stress += E de, volume *= 1 + de. False: 1 + de
 * <= 0 somewhere. */
KERNEL_INLINE bool strain_run(Bar *bar, MpmShape shape, int slots, int c, int stop)
{
    const int support = shape_support(shape);
    const double k = bar->dt / bar->dx, e = bar_modulus(bar, bar->first[c]);
    double *h_of[BAR_SLOTS_MAX], *s_of[BAR_SLOTS_MAX], *stress_of[BAR_SLOTS_MAX], *volume_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, bar->first[c], s_of);
    halves_of_run(bar, shape, slots, bar->first[c], h_of);
    slots_of_run(bar->stress, slots, bar->first[c], stress_of);
    slots_of_run(bar->volume, slots, bar->first[c], volume_of);
    VectorMask crushed = {0}; /* minus how many */
    for (int i = 0; c + VECTOR_WIDTH <= stop; c += VECTOR_WIDTH, i += VECTOR_WIDTH) {
        Vector v[BAR_SUPPORT_MAX];
#pragma GCC unroll 4
        for (int a = 0; a < support; a++)
            v[a] = vector_load(bar->node_velocity + c + a);
#pragma GCC unroll 2
        for (int j = 0; j < slots; j++) {
            const Vector h = vector_half(shape, h_of[j], i, bar->gimp_half);
            const Vector s = vector_load(s_of[j] + i);
            Vector n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_inner_vector(shape, &h, &s, n, dn);
            Vector gradient = dn[0] * v[0];
#pragma GCC unroll 4
            for (int a = 1; a < support; a++)
                gradient += dn[a] * v[a];
            const Vector de = k * gradient, stretch = 1.0 + de;
            crushed += ~(stretch > 0.0);
            vector_store(stress_of[j] + i, vector_load(stress_of[j] + i) + e * de);
            vector_store(volume_of[j] + i, vector_load(volume_of[j] + i) * stretch);
        }
    }
    bool sound = vector_is_zero(crushed);
    for (; c < stop; c++)
        sound = strain_cell(bar, shape, c) && sound;
    return sound;
}

/* Eq. 10 over -1, a cell's share: part[0][a] = sum N'_a stress m / rho, N' by s, so times dx of the force. */
KERNEL_INLINE void force_run(Bar *bar, MpmShape shape, int slots, int c, int stop)
{
    const int support = shape_support(shape);
    double *h_of[BAR_SLOTS_MAX], *s_of[BAR_SLOTS_MAX], *stress_of[BAR_SLOTS_MAX], *volume_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, bar->first[c], s_of);
    halves_of_run(bar, shape, slots, bar->first[c], h_of);
    slots_of_run(bar->stress, slots, bar->first[c], stress_of);
    slots_of_run(bar->volume, slots, bar->first[c], volume_of);
    for (int i = 0; c + VECTOR_WIDTH <= stop; c += VECTOR_WIDTH, i += VECTOR_WIDTH) {
        Vector force[BAR_SUPPORT_MAX];
#pragma GCC unroll 4
        for (int a = 0; a < support; a++)
            force[a] = -(Vector){0};
#pragma GCC unroll 2
        for (int j = 0; j < slots; j++) {
            const Vector h = vector_half(shape, h_of[j], i, bar->gimp_half);
            const Vector s = vector_load(s_of[j] + i);
            const Vector pull = vector_load(stress_of[j] + i) * vector_load(volume_of[j] + i);
            Vector n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_inner_vector(shape, &h, &s, n, dn);
#pragma GCC unroll 4
            for (int a = 0; a < support; a++)
                force[a] += dn[a] * pull;
        }
#pragma GCC unroll 4
        for (int a = 0; a < support; a++)
            vector_store(bar->part[0][a] + c, force[a]);
    }
    for (; c < stop; c++)
        force_cell(bar, shape, c);
}

/* Eqs. 14 and 15: v += sum N_a (dt f_a / m_a) and x += sum N_a (dt p_a / m_a), the brackets being node_kick
 * and dx node_drift. What goes for v and C with other transfers: update_cell(). */
KERNEL_INLINE void update_run(Bar *bar, MpmShape shape, Transfer transfer, int slots, int c, int stop)
{
    const int support = shape_support(shape);
    const double alpha = bar->head->flip_fraction;
    const double speed = bar->dx / bar->dt, rate = 1.0 / bar->dt, rate_of_places = bar->dt / bar->dx;
    double *h_of[BAR_SLOTS_MAX], *s_of[BAR_SLOTS_MAX], *v_of[BAR_SLOTS_MAX], *moved_of[BAR_SLOTS_MAX],
        *affine_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, bar->first[c], s_of);
    halves_of_run(bar, shape, slots, bar->first[c], h_of);
    slots_of_run(bar->v, slots, bar->first[c], v_of);
    slots_of_run(bar->moved, slots, bar->first[c], moved_of);
    slots_of_run(bar->affine, slots, bar->first[c], affine_of);
    for (int i = 0; c + VECTOR_WIDTH <= stop; c += VECTOR_WIDTH, i += VECTOR_WIDTH) {
        Vector kick[BAR_SUPPORT_MAX], drift[BAR_SUPPORT_MAX];
#pragma GCC unroll 4
        for (int a = 0; a < support; a++) {
            kick[a] = vector_load(bar->node_kick + c + a);
            drift[a] = vector_load(bar->node_drift + c + a);
        }
#pragma GCC unroll 2
        for (int j = 0; j < slots; j++) {
            const Vector h = vector_half(shape, h_of[j], i, bar->gimp_half);
            const Vector s = vector_load(s_of[j] + i), v = vector_load(v_of[j] + i);
            Vector n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_inner_vector(shape, &h, &s, n, dn);
            Vector dv = n[0] * kick[0], ds = n[0] * drift[0];
#pragma GCC unroll 4
            for (int a = 1; a < support; a++) {
                dv += n[a] * kick[a];
                ds += n[a] * drift[a];
            }
            vector_store(moved_of[j] + i, transfer == TO_FMPM ? s + 0.5 * (rate_of_places * v + ds) : s + ds);
            if (transfer == TO_FLIP)
                vector_store(v_of[j] + i, v + dv);
            else if (transfer == TO_FMPM)
                vector_store(v_of[j] + i, speed * ds);
            else if (transfer == TO_BLEND)
                vector_store(v_of[j] + i, alpha * (v + dv) + (1.0 - alpha) * (speed * ds));
            else {
                Vector slope = -(Vector){0}, spread = -(Vector){0};
#pragma GCC unroll 4
                for (int a = 0; a < support; a++) {
                    const Vector arm = inner_offset(shape, a) - s;
                    slope += shape == MPM_HAT ? dn[a] * drift[a] : n[a] * drift[a] * arm;
                    spread += n[a] * (arm * arm);
                }
                vector_store(affine_of[j] + i, rate * (shape == MPM_HAT ? slope : slope / spread));
                vector_store(v_of[j] + i, speed * ds);
            }
        }
    }
    for (; c < stop; c++)
        update_cell(bar, shape, transfer, c);
}

/* The same for a run of cells with P particles of one material each: VECTOR_WIDTH cells at once, in the same
 * order. */
KERNEL_INLINE void couple_run(Bar *bar, MpmShape shape, int slots, int c, int stop)
{
    const int support = shape_support(shape), reach = shape_reach(shape);
    const double weight = bar_weight(bar, bar->first[c]);
    double *h_of[BAR_SLOTS_MAX], *s_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, bar->first[c], s_of);
    halves_of_run(bar, shape, slots, bar->first[c], h_of);
    for (int i = 0; c + VECTOR_WIDTH <= stop; c += VECTOR_WIDTH, i += VECTOR_WIDTH) {
        Vector pair[BAR_REACH_MAX + 1][BAR_SUPPORT_MAX] = {{{0}}};
#pragma GCC unroll 2
        for (int j = 0; j < slots; j++) {
            const Vector h = vector_half(shape, h_of[j], i, bar->gimp_half);
            const Vector s = vector_load(s_of[j] + i);
            Vector n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_inner_vector(shape, &h, &s, n, dn);
#pragma GCC unroll 4
            for (int d = 1; d <= reach; d++)
#pragma GCC unroll 4
                for (int a = 0; a + d < support; a++)
                    pair[d][a] += weight * (n[a] * n[a + d]);
        }
#pragma GCC unroll 4
        for (int d = 1; d <= reach; d++)
#pragma GCC unroll 4
            for (int a = 0; a + d < support; a++)
                vector_store(bar->pair[d][a] + c, pair[d][a]);
    }
    for (; c < stop; c++)
        couple_cell(bar, shape, c);
}

/* Lets the particles of a run take their places if 0 <= moved_0 <= moved_1 ... < 1 in each cell: all are in
 * their cell after the step, in order. False: at least one is not, or is no number, and nothing was done:
 * bar_cells.c looks at each. */
KERNEL_INLINE bool settle_run(Bar *bar, int slots, int cells, int particle)
{
    double *s[BAR_SLOTS_MAX], *moved[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, particle, s);
    slots_of_run(bar->moved, slots, particle, moved);
    VectorMask astray = {0}; /* minus how many */
    int done = 0;
    for (; done + VECTOR_WIDTH <= cells; done += VECTOR_WIDTH) {
        Vector before = {0};
#pragma GCC unroll 2
        for (int j = 0; j < slots; j++) {
            const Vector here = vector_load(moved[j] + done);
            astray += ~(here >= before);
            before = here;
        }
        astray += ~(before < 1.0);
    }
    bool stay = vector_is_zero(astray);
    for (int i = done; i < cells; i++) {
        double before = 0.0;
        for (int j = 0; j < slots; j++) {
            stay = stay && moved[j][i] >= before;
            before = moved[j][i];
        }
        stay = stay && before < 1.0;
    }
    if (!stay)
        return false;
    for (int j = 0; j < slots; j++)
#pragma omp simd
        for (int i = 0; i < cells; i++)
            s[j][i] = moved[j][i];
    return true;
}

static bool settle(Bar *bar, int cells, int particle)
{
    return bar->slots == 2 ? settle_run(bar, 2, cells, particle)
                           : settle_run(bar, bar->slots, cells, particle);
}

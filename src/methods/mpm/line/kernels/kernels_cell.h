/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Part of bar_kernels.c: the stages on one cell with any number of particles, any shape, any transfer. The
 * order of every sum is defined here: over the particles of a cell as they stand, then over its nodes from
 * left to right. What a cell without particles gives to its nodes is 0. */

/* A particle of the storage by slots. */
typedef struct Place {
    int slot, k;
} Place;

KERNEL_INLINE Place place_of(const Bar *bar, int particle)
{
    return (Place){particle % bar->slots, particle / bar->slots};
}

KERNEL_INLINE Place next_place(const Bar *bar, Place at)
{
    return at.slot + 1 < bar->slots ? (Place){at.slot + 1, at.k} : (Place){0, at.k + 1};
}

/* A particle's half-width over dx. */
KERNEL_INLINE double half_of(const Bar *bar, MpmShape shape, Place at)
{
    return shape == MPM_CPDI ? bar->half[at.slot][at.k] : bar->gimp_half;
}

/* What has no terms is 0. */
KERNEL_INLINE void clear_part(Bar *bar, int which, int support, int c)
{
#pragma GCC unroll 4
    for (int a = 0; a < support; a++)
        bar->part[which][a][c] = 0.0;
}

/* Eqs. 2 and 3 over m of the first material, the cell's share:
 *
 *     part[0][a] = sum N_a,   part[1][a] = sum v N_a         each term times bar_weight() of its particle
 *
 * with APIC v + C (x_a - x) in place of v (Jiang et al. 2015). Reads s, v, affine; s in cells, C dx a
 * velocity per cell. */
KERNEL_INLINE void map_cell(Bar *bar, MpmShape shape, bool affine, int c)
{
    const int support = shape_support(shape);
    if (bar->first[c] == bar->first[c + 1]) {
        clear_part(bar, 0, support, c);
        clear_part(bar, 1, support, c);
        return;
    }
    double mass[BAR_SUPPORT_MAX], momentum[BAR_SUPPORT_MAX];
#pragma GCC unroll 4
    for (int a = 0; a < support; a++)
        mass[a] = momentum[a] = EMPTY_SUM;
    Place at = place_of(bar, bar->first[c]);
    for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
        double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
        double s = bar->s[at.slot][at.k], v = bar->v[at.slot][at.k];
        shape_at(shape, half_of(bar, shape, at), bar->n_cells, c, s, n, dn);
        const double weight = bar_weight(bar, p);
        double spin = affine ? bar->affine[at.slot][at.k] * bar->dx : 0.0;
#pragma GCC unroll 4
        for (int a = 0; a < support; a++) {
            double given = v;
            if (affine)
                given += spin * (shape_node_offset(shape, bar->n_cells, c, a) - s);
            mass[a] += weight * n[a];
            momentum[a] += weight * (given * n[a]);
        }
    }
#pragma GCC unroll 4
    for (int a = 0; a < support; a++) {
        bar->part[0][a][c] = mass[a];
        bar->part[1][a][c] = momentum[a];
    }
}

/* sum N'_a v_a by s = x / dx, a velocity: the strain increment of a particle, eq. 5, times dx / dt. */
KERNEL_INLINE double gradient_of(MpmShape shape, const double *dn, const double *v)
{
    double gradient = dn[0] * v[0];
#pragma GCC unroll 4
    for (int a = 1; a < shape_support(shape); a++)
        gradient += dn[a] * v[a];
    return gradient;
}

/* Velocities of the nodes of a cell, as its particles are strained by them. */
KERNEL_INLINE void strain_velocities(const Bar *bar, MpmShape shape, int c, double *v)
{
#pragma GCC unroll 4
    for (int a = 0; a < shape_support(shape); a++)
        v[a] = bar->node_velocity[c + a];
    if (shape == MPM_HAT)
        bar_lend_velocity(bar, c, v);
}

/* Eqs. 5, 7, 8, 9: de = dt sum N'_a v_a, stress += E de, volume *= 1 + de, the density being mass / volume.
 * Stress in the unit of E; on a line eq. 5's symmetric part is the gradient itself, and there is no spin to
 * turn the stress by. False: 1 + de <= 0 somewhere (that particle is done too). */
KERNEL_INLINE bool strain_cell(Bar *bar, MpmShape shape, int c)
{
    const double k = bar->dt / bar->dx;
    double v[BAR_SUPPORT_MAX];
    bool good = true;
    strain_velocities(bar, shape, c, v);
    Place at = place_of(bar, bar->first[c]);
    for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
        double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
        shape_at(shape, half_of(bar, shape, at), bar->n_cells, c, bar->s[at.slot][at.k], n, dn);
        double de = k * gradient_of(shape, dn, v), stretch = 1.0 + de;
        good = good && stretch > 0.0;
        bar->stress[at.slot][at.k] += bar_modulus(bar, p) * de;
        bar->volume[at.slot][at.k] *= stretch;
    }
    return good;
}

/* The first particle of cells [c, stop) for which 1 + de <= 0, or -1; computed again, as only the name is
 * wanted of it. */
static int find_crushed(const Bar *bar, MpmShape shape, int c, int stop)
{
    for (; c < stop; c++) {
        double v[BAR_SUPPORT_MAX];
        strain_velocities(bar, shape, c, v);
        for (int p = bar->first[c]; p < bar->first[c + 1]; p++) {
            double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            Place at = place_of(bar, p);
            shape_at(shape, half_of(bar, shape, at), bar->n_cells, c, bar->s[at.slot][at.k], n, dn);
            if (!(1.0 + bar->dt / bar->dx * gradient_of(shape, dn, v) > 0.0))
                return p;
        }
    }
    return -1;
}

/* Of cells [c, stop), which were strained soundly or not, the particle that was crushed if it is the first.
 */
KERNEL_INLINE void note_crushed(const Bar *bar, MpmShape shape, bool sound, int c, int stop, int *crushed)
{
    if (!sound && *crushed < 0)
        *crushed = find_crushed(bar, shape, c, stop);
}

/* Eq. 10 over -1, the cell's share: part[0][a] = sum N'_a stress volume, N' by s, so times dx of the force.
 */
KERNEL_INLINE void force_cell(Bar *bar, MpmShape shape, int c)
{
    const int support = shape_support(shape);
    if (bar->first[c] == bar->first[c + 1]) {
        clear_part(bar, 0, support, c);
        return;
    }
    double force[BAR_SUPPORT_MAX];
#pragma GCC unroll 4
    for (int a = 0; a < support; a++)
        force[a] = EMPTY_SUM;
    Place at = place_of(bar, bar->first[c]);
    for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
        double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
        shape_at(shape, half_of(bar, shape, at), bar->n_cells, c, bar->s[at.slot][at.k], n, dn);
        double pull = bar->stress[at.slot][at.k] * bar->volume[at.slot][at.k];
#pragma GCC unroll 4
        for (int a = 0; a < support; a++)
            force[a] += dn[a] * pull;
    }
#pragma GCC unroll 4
    for (int a = 0; a < support; a++)
        bar->part[0][a][c] = force[a];
}

/* Eq. 11's second sum, the cell's share: part[1][a] = sum N_a (t / h) volume over the layers at free ends. */
KERNEL_INLINE void traction_cell(Bar *bar, MpmShape shape, int c)
{
    const int support = shape_support(shape);
    const double pressure = bar->head->traction / bar->layer;
    clear_part(bar, 1, support, c);
    for (int p = bar->first[c]; p < bar->first[c + 1]; p++) {
        /* outwards: to the left at the left end; a particle of a short bar may bear both */
        int side = (p >= bar->n_particles - bar->layer_right) - (p < bar->layer_left);
        if (side == 0)
            continue;
        double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
        Place at = place_of(bar, p);
        shape_at(shape, half_of(bar, shape, at), bar->n_cells, c, bar->s[at.slot][at.k], n, dn);
        double pull = side * pressure * bar->volume[at.slot][at.k];
#pragma GCC unroll 4
        for (int a = 0; a < support; a++)
            bar->part[1][a][c] += n[a] * pull;
    }
}

/* Eqs. 14 and 15, kick and drift being dt f / m and dt p / (m dx) of the nodes, or what stands for them where
 * masses are not lumped:
 *
 *     FLIP   v += sum N_a kick_a                       every transfer   moved = s + sum N_a drift_a,
 *     FMPM   v = sum N_a v_a                           but FMPM         moved = s + (dt/dx)(v before + v)/2
 *     blend  v = alpha (v + sum N_a kick_a) + (1 - alpha) sum N_a v_a
 *     APIC   v = sum N_a v_a,   C = sum N_a v_a (x_a - x) / sum N_a (x_a - x)^2; hats: C = sum N'_a v_a,
 *            in which an inactive node moves as it does for the strain: bar_lend_velocity()
 *
 * FLIP leaves in v whatever the grid cannot see, PIC's share and FMPM take it away. They do
 * so in each step, so half the step damps twice as much in a time. Writes moved, v, affine; cannot fail. */
KERNEL_INLINE void update_cell(Bar *bar, MpmShape shape, Transfer transfer, int c)
{
    const int support = shape_support(shape);
    const double alpha = bar->head->flip_fraction, speed = bar->dx / bar->dt, rate = 1.0 / bar->dt;
    const double rate_of_places = bar->dt / bar->dx;
    const double *kick = bar->node_kick + c, *drift = bar->node_drift + c;
    double lent[BAR_SUPPORT_MAX] = {drift[0], drift[1]};
    if (transfer == TO_APIC && shape == MPM_HAT)
        bar_lend_velocity(bar, c, lent);
    Place at = place_of(bar, bar->first[c]);
    for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
        double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
        double s = bar->s[at.slot][at.k], v = bar->v[at.slot][at.k];
        shape_at(shape, half_of(bar, shape, at), bar->n_cells, c, s, n, dn);
        double dv = n[0] * kick[0], ds = n[0] * drift[0];
#pragma GCC unroll 4
        for (int a = 1; a < support; a++) {
            dv += n[a] * kick[a];
            ds += n[a] * drift[a];
        }
        bar->moved[at.slot][at.k] = transfer == TO_FMPM ? s + 0.5 * (rate_of_places * v + ds) : s + ds;
        if (transfer == TO_FLIP)
            bar->v[at.slot][at.k] = v + dv;
        else if (transfer == TO_FMPM)
            bar->v[at.slot][at.k] = speed * ds;
        else if (transfer == TO_BLEND)
            bar->v[at.slot][at.k] = alpha * (v + dv) + (1.0 - alpha) * (speed * ds);
        else {
            double slope = EMPTY_SUM, spread = EMPTY_SUM;
#pragma GCC unroll 4
            for (int a = 0; a < support; a++) {
                double arm = shape_node_offset(shape, bar->n_cells, c, a) - s;
                slope += shape == MPM_HAT ? dn[a] * lent[a] : n[a] * drift[a] * arm;
                spread += n[a] * (arm * arm);
            }
            if (shape != MPM_HAT) /* a particle on the end of the mesh has no spread */
                slope = spread > 0.0 ? slope / spread : 0.0;
            bar->affine[at.slot][at.k] = rate * slope;
            bar->v[at.slot][at.k] = speed * ds;
        }
    }
}

/* A cell's share over m of the first material: pair[d][a] = sum N_a N_a+d. */
KERNEL_INLINE void couple_cell(Bar *bar, MpmShape shape, int c)
{
    const int support = shape_support(shape), reach = shape_reach(shape);
    double pair[BAR_REACH_MAX + 1][BAR_SUPPORT_MAX] = {{0}};
    Place at = place_of(bar, bar->first[c]);
    for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
        double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
        shape_at(shape, half_of(bar, shape, at), bar->n_cells, c, bar->s[at.slot][at.k], n, dn);
        for (int d = 1; d <= reach; d++)
            for (int a = 0; a + d < support; a++)
                pair[d][a] += bar_weight(bar, p) * (n[a] * n[a + d]);
    }
    for (int d = 1; d <= reach; d++)
        for (int a = 0; a + d < support; a++)
            bar->pair[d][a][c] = pair[d][a];
}

/* One step of the material point method on a bar, stage by stage:
 *
 *     m_i = sum m N_i          p_i = sum m v N_i                                    (2, 3)
 *     v_i = p_i / m_i          de = dt sum N'_i v_i                                 (4, 5)
 *     stress += E de           volume *= 1 + de  (rho /= 1 + de)                    (7, 8, 9)
 *     f_int = -sum N'_i stress m / rho           f_ext = sum m N_i b + sum N_i t m / (rho h)   (10, 11)
 *     p_i += dt f_i                                                                 (12, 13)
 *     v += dt sum N_i f_i / m_i                  x += dt sum N_i p_i / m_i          (14, 15)
 *
 * Sources: paper M (A. da Silva Rocha); Bardenhagen and Kober 2004 for uGIMP, Steffen, Kirby and Berzins 2008
 * for B-splines, Jiang et al. 2015 for APIC.
 *
 * This file is compiled once for each instruction set; BAR_KERNELS is the name of the table. */
#include "physics/mpm/kernels.h"
#include "physics/mpm/shape.h"

#define INLINE static inline __attribute__((always_inline))

#ifndef BAR_KERNELS
#define BAR_KERNELS bar_kernels_plain
#endif

extern const BarKernels BAR_KERNELS;

/* A particle of the storage by slots. */
typedef struct Place {
    int slot, k;
} Place;

INLINE Place place_of(const Bar *bar, int particle)
{
    return (Place){particle % bar->slots, particle / bar->slots};
}

INLINE Place next_place(const Bar *bar, Place at)
{
    return at.slot + 1 < bar->slots ? (Place){at.slot + 1, at.k} : (Place){0, at.k + 1};
}

/* Nodes that come with cells [first, end). */
INLINE int nodes_end(const Bar *bar, int end)
{
    return end == bar->n_cells ? bar->n_nodes : end;
}

/* What the cells gave to node i, in the order of the cells. */
INLINE double gather(double *const *part, int support, int i)
{
    double sum = part[support - 1][i - support + 1];
    for (int a = support - 2; a >= 0; a--)
        sum += part[a][i - a];
    return sum;
}

INLINE void map_cell(Bar *bar, MpmShape shape, bool affine, int c)
{
    const int support = shape_support(shape);
    double mass[BAR_SUPPORT_MAX] = {0.0}, momentum[BAR_SUPPORT_MAX] = {0.0};
    Place at = place_of(bar, bar->first[c]);
    for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
        double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
        double s = bar->s[at.slot][at.k], v = bar->v[at.slot][at.k];
        shape_at(shape, bar->gimp_half, bar->n_cells, c, s, n, dn);
        double spin = affine ? bar->affine[at.slot][at.k] * bar->dx : 0.0;
        for (int a = 0; a < support; a++) {
            double given = v;
            if (affine)
                given += spin * (shape_node_offset(shape, bar->n_cells, c, a) - s);
            mass[a] += n[a];
            momentum[a] += given * n[a];
        }
    }
    for (int a = 0; a < support; a++) {
        bar->part[0][a][c] = mass[a];
        bar->part[1][a][c] = momentum[a];
    }
}

INLINE void map_shape(Bar *bar, MpmShape shape, int first, int end, bool again)
{
    const int support = shape_support(shape);
    bool affine = bar->head->transfer == MPM_APIC;
    for (int c = first; c < end; c++)
        map_cell(bar, shape, affine, c);
    const int last = nodes_end(bar, end);
    for (int i = first; i < last; i++)
        bar->node_momentum[i] = bar->mass * gather(bar->part[1], support, i);
    if (again)
        return;
    for (int i = first; i < last; i++) {
        double mass = bar->mass * gather(bar->part[0], support, i);
        bar->node_mass[i] = mass;
        bar->node_inverse[i] = mass > bar->mass_floor ? 1.0 / mass : 0.0;
    }
}

INLINE int strain_shape(Bar *bar, MpmShape shape, int first, int end)
{
    const int support = shape_support(shape);
    const double k = bar->dt / bar->dx, e = bar->def.youngs_modulus;
    int bad = -1;
    for (int c = first; c < end; c++) {
        double v[BAR_SUPPORT_MAX];
        for (int a = 0; a < support; a++)
            v[a] = bar->node_momentum[c + a] * bar->node_inverse[c + a];
        if (shape == MPM_HAT)
            bar_lend_velocity(bar, c, v);
        Place at = place_of(bar, bar->first[c]);
        for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
            double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_at(shape, bar->gimp_half, bar->n_cells, c, bar->s[at.slot][at.k], n, dn);
            double gradient = dn[0] * v[0];
            for (int a = 1; a < support; a++)
                gradient += dn[a] * v[a];
            double de = k * gradient, stretch = 1.0 + de;
            if (!(stretch > 0.0) && bad < 0)
                bad = p;
            bar->stress[at.slot][at.k] += e * de;
            bar->volume[at.slot][at.k] *= stretch;
        }
    }
    return bad;
}

INLINE void force_shape(Bar *bar, MpmShape shape, int first, int end)
{
    const int support = shape_support(shape);
    for (int c = first; c < end; c++) {
        double force[BAR_SUPPORT_MAX] = {0.0};
        Place at = place_of(bar, bar->first[c]);
        for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
            double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_at(shape, bar->gimp_half, bar->n_cells, c, bar->s[at.slot][at.k], n, dn);
            double pull = bar->stress[at.slot][at.k] * bar->volume[at.slot][at.k];
            for (int a = 0; a < support; a++)
                force[a] += dn[a] * pull;
        }
        for (int a = 0; a < support; a++)
            bar->part[0][a][c] = force[a];
    }
    const int last = nodes_end(bar, end);
    const double scale = -1.0 / bar->dx;
    for (int i = first; i < last; i++)
        bar->node_f_int[i] = scale * gather(bar->part[0], support, i);

    if (bar->head->traction != 0.0) {
        const double pressure = bar->head->traction / bar->layer;
        for (int c = first; c < end; c++) {
            double force[BAR_SUPPORT_MAX] = {0.0};
            Place at = place_of(bar, bar->first[c]);
            for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
                /* outwards: to the left at the left end; a particle of a short bar may bear both */
                int side = (p >= bar->n_particles - bar->layer_right) - (p < bar->layer_left);
                if (side == 0)
                    continue;
                double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
                shape_at(shape, bar->gimp_half, bar->n_cells, c, bar->s[at.slot][at.k], n, dn);
                double pull = side * pressure * bar->volume[at.slot][at.k];
                for (int a = 0; a < support; a++)
                    force[a] += n[a] * pull;
            }
            for (int a = 0; a < support; a++)
                bar->part[1][a][c] = force[a];
        }
        for (int i = first; i < last; i++)
            bar->node_f_ext[i] = bar->node_mass[i] * bar->head->body_force + gather(bar->part[1], support, i);
    } else {
        for (int i = first; i < last; i++)
            bar->node_f_ext[i] = bar->node_mass[i] * bar->head->body_force;
    }
}

static void integrate(Bar *bar, int first, int end)
{
    const int last = nodes_end(bar, end);
    const double dt = bar->dt, drift = bar->dt / bar->dx;
    const int free_first = first > bar->fixed_left ? first : bar->fixed_left;
    const int free_end = last < bar->n_nodes - bar->fixed_right ? last : bar->n_nodes - bar->fixed_right;
    for (int i = first; i < last && i < bar->fixed_left; i++)
        bar->node_kick[i] = bar->node_drift[i] = 0.0;
    for (int i = free_first; i < free_end; i++) {
        double impulse = dt * (bar->node_f_int[i] + bar->node_f_ext[i]);
        bar->node_momentum[i] += impulse;
        bar->node_kick[i] = impulse * bar->node_inverse[i];
        bar->node_drift[i] = drift * (bar->node_momentum[i] * bar->node_inverse[i]);
    }
    for (int i = first > bar->n_nodes - bar->fixed_right ? first : bar->n_nodes - bar->fixed_right; i < last;
         i++)
        bar->node_kick[i] = bar->node_drift[i] = 0.0;
    if (bar->head->body_force != 0.0 || bar->head->traction != 0.0)
        for (int i = free_first; i < free_end; i++)
            bar->head->work += bar->node_f_ext[i] * (bar->node_drift[i] * bar->dx);
}

INLINE void update_shape(Bar *bar, MpmShape shape, int first, int end)
{
    const int support = shape_support(shape);
    const bool apic = bar->head->transfer == MPM_APIC;
    const double alpha = bar->head->flip_fraction, speed = bar->dx / bar->dt, rate = 1.0 / bar->dt;
    for (int c = first; c < end; c++) {
        const double *kick = bar->node_kick + c, *drift = bar->node_drift + c;
        Place at = place_of(bar, bar->first[c]);
        for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
            double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            double s = bar->s[at.slot][at.k], v = bar->v[at.slot][at.k];
            shape_at(shape, bar->gimp_half, bar->n_cells, c, s, n, dn);
            double dv = n[0] * kick[0], ds = n[0] * drift[0];
            for (int a = 1; a < support; a++) {
                dv += n[a] * kick[a];
                ds += n[a] * drift[a];
            }
            bar->moved[at.slot][at.k] = s + ds;
            if (apic) {
                double slope = 0.0, spread = 0.0;
                for (int a = 0; a < support; a++) {
                    if (shape == MPM_HAT) {
                        slope += dn[a] * drift[a];
                        spread = 1.0;
                    } else {
                        double arm = shape_node_offset(shape, bar->n_cells, c, a) - s;
                        slope += n[a] * drift[a] * arm;
                        spread += n[a] * (arm * arm);
                    }
                }
                bar->affine[at.slot][at.k] = spread > 0.0 ? rate * (slope / spread) : 0.0;
                bar->v[at.slot][at.k] = speed * ds;
            } else if (alpha == 1.0)
                bar->v[at.slot][at.k] = v + dv;
            else
                bar->v[at.slot][at.k] = alpha * (v + dv) + (1.0 - alpha) * (speed * ds);
        }
    }
}

static bool settle(Bar *bar, int cells, int particle)
{
    Place start = place_of(bar, particle), at = start;
    for (int c = 0; c < cells; c++) {
        double before = 0.0;
        for (int j = 0; j < bar->slots; j++, at = next_place(bar, at)) {
            double moved = bar->moved[at.slot][at.k];
            if (!(moved >= before && moved < 1.0))
                return false;
            before = moved;
        }
    }
    at = start;
    for (int i = 0; i < cells * bar->slots; i++, at = next_place(bar, at))
        bar->s[at.slot][at.k] = bar->moved[at.slot][at.k];
    return true;
}

/* Eight partial sums whatever the width of the machine's registers, then always the same tree. */
enum { LANES = 8 };

INLINE double fold(const double *lane)
{
    return ((lane[0] + lane[4]) + (lane[2] + lane[6])) + ((lane[1] + lane[5]) + (lane[3] + lane[7]));
}

static void particle_sums(const Bar *bar, int first, int end, double sums[4])
{
    for (int block = first; block < end; block++) {
        double lane[4][LANES] = {{0.0}};
        int begin = block * BAR_SUM_BLOCK;
        int stop = begin + BAR_SUM_BLOCK < bar->places ? begin + BAR_SUM_BLOCK : bar->places;
        for (int j = 0; j < bar->slots; j++) {
            const double *s = bar->s[j], *v = bar->v[j], *stress = bar->stress[j], *volume = bar->volume[j];
            for (int k = begin; k < stop; k++) {
                int l = k % LANES;
                lane[0][l] += v[k];
                lane[1][l] += s[k];
                lane[2][l] += v[k] * v[k];
                lane[3][l] += stress[k] * stress[k] * volume[k];
            }
        }
        for (int q = 0; q < 4; q++)
            sums[q] += fold(lane[q]);
    }
}

static void node_sums(const Bar *bar, int first, int end, double *sum)
{
    for (int block = first; block < end; block++) {
        double lane[LANES] = {0.0};
        int begin = block * BAR_SUM_BLOCK;
        int stop = begin + BAR_SUM_BLOCK < bar->n_nodes ? begin + BAR_SUM_BLOCK : bar->n_nodes;
        for (int i = begin; i < stop; i++)
            lane[i % LANES] += bar->node_momentum[i] * bar->node_momentum[i] * bar->node_inverse[i];
        *sum += fold(lane);
    }
}

/* A function of constants for each shape, so that the loops over the support are unrolled. */
static void map(Bar *bar, int first, int end, bool again)
{
    switch (bar->def.shape) {
    case MPM_HAT:
        map_shape(bar, MPM_HAT, first, end, again);
        return;
    case MPM_GIMP:
        map_shape(bar, MPM_GIMP, first, end, again);
        return;
    case MPM_BSPLINE2:
        map_shape(bar, MPM_BSPLINE2, first, end, again);
        return;
    case MPM_BSPLINE3:
        map_shape(bar, MPM_BSPLINE3, first, end, again);
        return;
    }
}

static int strain(Bar *bar, int first, int end)
{
    switch (bar->def.shape) {
    case MPM_HAT:
        return strain_shape(bar, MPM_HAT, first, end);
    case MPM_GIMP:
        return strain_shape(bar, MPM_GIMP, first, end);
    case MPM_BSPLINE2:
        return strain_shape(bar, MPM_BSPLINE2, first, end);
    case MPM_BSPLINE3:
        return strain_shape(bar, MPM_BSPLINE3, first, end);
    }
    return -1;
}

static void force(Bar *bar, int first, int end)
{
    switch (bar->def.shape) {
    case MPM_HAT:
        force_shape(bar, MPM_HAT, first, end);
        return;
    case MPM_GIMP:
        force_shape(bar, MPM_GIMP, first, end);
        return;
    case MPM_BSPLINE2:
        force_shape(bar, MPM_BSPLINE2, first, end);
        return;
    case MPM_BSPLINE3:
        force_shape(bar, MPM_BSPLINE3, first, end);
        return;
    }
}

static void update(Bar *bar, int first, int end)
{
    switch (bar->def.shape) {
    case MPM_HAT:
        update_shape(bar, MPM_HAT, first, end);
        return;
    case MPM_GIMP:
        update_shape(bar, MPM_GIMP, first, end);
        return;
    case MPM_BSPLINE2:
        update_shape(bar, MPM_BSPLINE2, first, end);
        return;
    case MPM_BSPLINE3:
        update_shape(bar, MPM_BSPLINE3, first, end);
        return;
    }
}

const BarKernels BAR_KERNELS = {
    .map = map,
    .strain = strain,
    .force = force,
    .integrate = integrate,
    .update = update,
    .settle = settle,
    .particle_sums = particle_sums,
    .node_sums = node_sums,
};

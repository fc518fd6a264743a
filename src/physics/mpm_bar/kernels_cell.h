/* Part of kernels.c: one cell, any number of particles, any shape. The order of the sums is defined here. */

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

/* What has no terms is 0. */
INLINE void clear_part(Bar *bar, int which, int support, int c)
{
    UNROLL
    for (int a = 0; a < support; a++)
        bar->part[which][a][c] = 0.0;
}

INLINE void map_cell(Bar *bar, MpmShape shape, bool affine, int c)
{
    const int support = shape_support(shape);
    if (bar->first[c] == bar->first[c + 1]) {
        clear_part(bar, 0, support, c);
        clear_part(bar, 1, support, c);
        return;
    }
    double mass[BAR_SUPPORT_MAX], momentum[BAR_SUPPORT_MAX];
    UNROLL
    for (int a = 0; a < support; a++)
        mass[a] = momentum[a] = EMPTY_SUM;
    Place at = place_of(bar, bar->first[c]);
    for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
        double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
        double s = bar->s[at.slot][at.k], v = bar->v[at.slot][at.k];
        shape_at(shape, bar->gimp_half, bar->n_cells, c, s, n, dn);
        double spin = affine ? bar->affine[at.slot][at.k] * bar->dx : 0.0;
        UNROLL
        for (int a = 0; a < support; a++) {
            double given = v;
            if (affine)
                given += spin * (shape_node_offset(shape, bar->n_cells, c, a) - s);
            mass[a] += n[a];
            momentum[a] += given * n[a];
        }
    }
    UNROLL
    for (int a = 0; a < support; a++) {
        bar->part[0][a][c] = mass[a];
        bar->part[1][a][c] = momentum[a];
    }
}

/* The strain increment of a particle, times dx / dt. */
INLINE double gradient_of(MpmShape shape, const double *dn, const double *v)
{
    double gradient = dn[0] * v[0];
    UNROLL
    for (int a = 1; a < shape_support(shape); a++)
        gradient += dn[a] * v[a];
    return gradient;
}

INLINE void strain_velocities(const Bar *bar, MpmShape shape, int c, double *v)
{
    UNROLL
    for (int a = 0; a < shape_support(shape); a++)
        v[a] = bar->node_momentum[c + a] * bar->node_inverse[c + a];
    if (shape == MPM_HAT)
        bar_lend_velocity(bar, c, v);
}

/* False: 1 + de <= 0 somewhere. */
INLINE bool strain_cell(Bar *bar, MpmShape shape, int c)
{
    const double k = bar->dt / bar->dx, e = bar->def.youngs_modulus;
    double v[BAR_SUPPORT_MAX];
    bool good = true;
    strain_velocities(bar, shape, c, v);
    Place at = place_of(bar, bar->first[c]);
    for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
        double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
        shape_at(shape, bar->gimp_half, bar->n_cells, c, bar->s[at.slot][at.k], n, dn);
        double de = k * gradient_of(shape, dn, v), stretch = 1.0 + de;
        good = good && stretch > 0.0;
        bar->stress[at.slot][at.k] += e * de;
        bar->volume[at.slot][at.k] *= stretch;
    }
    return good;
}

/* The first particle of cells [c, stop) for which 1 + de <= 0. */
static int find_crushed(const Bar *bar, MpmShape shape, int c, int stop)
{
    for (; c < stop; c++) {
        double v[BAR_SUPPORT_MAX];
        strain_velocities(bar, shape, c, v);
        for (int p = bar->first[c]; p < bar->first[c + 1]; p++) {
            double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            Place at = place_of(bar, p);
            shape_at(shape, bar->gimp_half, bar->n_cells, c, bar->s[at.slot][at.k], n, dn);
            if (!(1.0 + bar->dt / bar->dx * gradient_of(shape, dn, v) > 0.0))
                return p;
        }
    }
    return -1;
}

INLINE void force_cell(Bar *bar, MpmShape shape, int c)
{
    const int support = shape_support(shape);
    if (bar->first[c] == bar->first[c + 1]) {
        clear_part(bar, 0, support, c);
        return;
    }
    double force[BAR_SUPPORT_MAX];
    UNROLL
    for (int a = 0; a < support; a++)
        force[a] = EMPTY_SUM;
    Place at = place_of(bar, bar->first[c]);
    for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
        double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
        shape_at(shape, bar->gimp_half, bar->n_cells, c, bar->s[at.slot][at.k], n, dn);
        double pull = bar->stress[at.slot][at.k] * bar->volume[at.slot][at.k];
        UNROLL
        for (int a = 0; a < support; a++)
            force[a] += dn[a] * pull;
    }
    UNROLL
    for (int a = 0; a < support; a++)
        bar->part[0][a][c] = force[a];
}

/* Eq. 11's second sum. */
INLINE void traction_cell(Bar *bar, MpmShape shape, int c)
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
        shape_at(shape, bar->gimp_half, bar->n_cells, c, bar->s[at.slot][at.k], n, dn);
        double pull = side * pressure * bar->volume[at.slot][at.k];
        UNROLL
        for (int a = 0; a < support; a++)
            bar->part[1][a][c] += n[a] * pull;
    }
}

INLINE void update_cell(Bar *bar, MpmShape shape, Transfer transfer, int c)
{
    const int support = shape_support(shape);
    const double alpha = bar->head->flip_fraction, speed = bar->dx / bar->dt, rate = 1.0 / bar->dt;
    const double *kick = bar->node_kick + c, *drift = bar->node_drift + c;
    Place at = place_of(bar, bar->first[c]);
    for (int p = bar->first[c]; p < bar->first[c + 1]; p++, at = next_place(bar, at)) {
        double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
        double s = bar->s[at.slot][at.k], v = bar->v[at.slot][at.k];
        shape_at(shape, bar->gimp_half, bar->n_cells, c, s, n, dn);
        double dv = n[0] * kick[0], ds = n[0] * drift[0];
        UNROLL
        for (int a = 1; a < support; a++) {
            dv += n[a] * kick[a];
            ds += n[a] * drift[a];
        }
        bar->moved[at.slot][at.k] = s + ds;
        if (transfer == TO_FLIP)
            bar->v[at.slot][at.k] = v + dv;
        else if (transfer == TO_BLEND)
            bar->v[at.slot][at.k] = alpha * (v + dv) + (1.0 - alpha) * (speed * ds);
        else {
            double slope = EMPTY_SUM, spread = EMPTY_SUM;
            UNROLL
            for (int a = 0; a < support; a++) {
                double arm = shape_node_offset(shape, bar->n_cells, c, a) - s;
                slope += shape == MPM_HAT ? dn[a] * drift[a] : n[a] * drift[a] * arm;
                spread += n[a] * (arm * arm);
            }
            if (shape != MPM_HAT) /* a particle on the end of the mesh has no spread */
                slope = spread > 0.0 ? slope / spread : 0.0;
            bar->affine[at.slot][at.k] = rate * slope;
            bar->v[at.slot][at.k] = speed * ds;
        }
    }
}

/* Part of kernels.c: any shape and transfer, runs of inner cells with P particles each. The slots are done
 * one after the other: what the j-th particles of all cells give is added to what the ones before them gave.
 */

/* Places of the nodes of an inner cell, from its left edge, in units of dx. */
INLINE double inner_offset(MpmShape shape, int a)
{
    return shape == MPM_HAT ? a : shape == MPM_BSPLINE2 ? a - 0.5 : a - 1;
}

INLINE void shape_map(Bar *bar, MpmShape shape, bool affine, int c, int count, bool again)
{
    const int support = shape_support(shape);
    const double h = bar->gimp_half, dx = bar->dx;
    double *masses[BAR_SUPPORT_MAX], *momenta[BAR_SUPPORT_MAX];
    UNROLL
    for (int a = 0; a < support; a++) {
        masses[a] = bar->part[0][a] + c;
        momenta[a] = bar->part[1][a] + c;
    }
    double *s_of[BAR_SLOTS_MAX], *v_of[BAR_SLOTS_MAX], *affine_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, bar->slots, bar->first[c], s_of);
    slots_of_run(bar->v, bar->slots, bar->first[c], v_of);
    slots_of_run(bar->affine, bar->slots, bar->first[c], affine_of);
    (void)again; /* the masses are the same again, and cost little */
    for (int j = 0; j < bar->slots; j++) {
        const double *s = s_of[j], *v = v_of[j], *slope = affine_of[j];
        const bool begun = j > 0;
        VECTOR
        for (int i = 0; i < count; i++) {
            double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_inner(shape, h, s[i], n, dn);
            double spin = affine ? slope[i] * dx : 0.0;
            UNROLL
            for (int a = 0; a < support; a++) {
                double given = affine ? v[i] + spin * (inner_offset(shape, a) - s[i]) : v[i];
                masses[a][i] = (begun ? masses[a][i] : EMPTY_SUM) + n[a];
                momenta[a][i] = (begun ? momenta[a][i] : EMPTY_SUM) + given * n[a];
            }
        }
    }
}

INLINE bool shape_strain(Bar *bar, MpmShape shape, int c, int count)
{
    const double k = bar->dt / bar->dx, e = bar->def.youngs_modulus, h = bar->gimp_half;
    const double *velocity = bar->node_velocity + c;
    double *s_of[BAR_SLOTS_MAX], *stress_of[BAR_SLOTS_MAX], *volume_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, bar->slots, bar->first[c], s_of);
    slots_of_run(bar->stress, bar->slots, bar->first[c], stress_of);
    slots_of_run(bar->volume, bar->slots, bar->first[c], volume_of);
    int64_t crushed = 0;
    for (int j = 0; j < bar->slots; j++) {
        const double *s = s_of[j];
        double *stress = stress_of[j], *volume = volume_of[j];
        _Pragma("omp simd reduction(| : crushed)") for (int i = 0; i < count; i++)
        {
            double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_inner(shape, h, s[i], n, dn);
            double de = k * gradient_of(shape, dn, velocity + i), stretch = 1.0 + de;
            crushed |= !(stretch > 0.0);
            stress[i] += e * de;
            volume[i] *= stretch;
        }
    }
    return crushed == 0;
}

INLINE void shape_force(Bar *bar, MpmShape shape, int c, int count)
{
    const int support = shape_support(shape);
    const double h = bar->gimp_half;
    double *forces[BAR_SUPPORT_MAX];
    UNROLL
    for (int a = 0; a < support; a++)
        forces[a] = bar->part[0][a] + c;
    double *s_of[BAR_SLOTS_MAX], *stress_of[BAR_SLOTS_MAX], *volume_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, bar->slots, bar->first[c], s_of);
    slots_of_run(bar->stress, bar->slots, bar->first[c], stress_of);
    slots_of_run(bar->volume, bar->slots, bar->first[c], volume_of);
    for (int j = 0; j < bar->slots; j++) {
        const double *s = s_of[j], *stress = stress_of[j], *volume = volume_of[j];
        const bool begun = j > 0;
        VECTOR
        for (int i = 0; i < count; i++) {
            double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_inner(shape, h, s[i], n, dn);
            double pull = stress[i] * volume[i];
            UNROLL
            for (int a = 0; a < support; a++)
                forces[a][i] = (begun ? forces[a][i] : EMPTY_SUM) + dn[a] * pull;
        }
    }
}

INLINE void shape_update(Bar *bar, MpmShape shape, Transfer transfer, int c, int count)
{
    const int support = shape_support(shape);
    const double h = bar->gimp_half, alpha = bar->head->flip_fraction;
    const double speed = bar->dx / bar->dt, rate = 1.0 / bar->dt;
    const double *kick = bar->node_kick + c, *drift = bar->node_drift + c;
    double *s_of[BAR_SLOTS_MAX], *v_of[BAR_SLOTS_MAX], *moved_of[BAR_SLOTS_MAX], *affine_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, bar->slots, bar->first[c], s_of);
    slots_of_run(bar->v, bar->slots, bar->first[c], v_of);
    slots_of_run(bar->moved, bar->slots, bar->first[c], moved_of);
    slots_of_run(bar->affine, bar->slots, bar->first[c], affine_of);
    for (int j = 0; j < bar->slots; j++) {
        const double *s = s_of[j];
        double *v = v_of[j], *moved = moved_of[j], *affine = affine_of[j];
        VECTOR
        for (int i = 0; i < count; i++) {
            double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_inner(shape, h, s[i], n, dn);
            double dv = n[0] * kick[i], ds = n[0] * drift[i];
            UNROLL
            for (int a = 1; a < support; a++) {
                dv += n[a] * kick[i + a];
                ds += n[a] * drift[i + a];
            }
            if (transfer == TO_FLIP)
                v[i] += dv;
            else if (transfer == TO_BLEND)
                v[i] = alpha * (v[i] + dv) + (1.0 - alpha) * (speed * ds);
            else {
                double slope = EMPTY_SUM, spread = EMPTY_SUM;
                UNROLL
                for (int a = 0; a < support; a++) {
                    double arm = inner_offset(shape, a) - s[i];
                    slope += shape == MPM_HAT ? dn[a] * drift[i + a] : n[a] * drift[i + a] * arm;
                    spread += n[a] * (arm * arm);
                }
                if (shape != MPM_HAT) {
                    double ratio = slope / spread;
                    slope = spread > 0.0 ? ratio : 0.0;
                }
                affine[i] = rate * slope;
                v[i] = speed * ds;
            }
            moved[i] = s[i] + ds;
        }
    }
}

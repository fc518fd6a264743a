/* Part of kernels.c: any shape and transfer, runs of inner cells with P particles each, WIDTH cells at once;
 * the few that are left over are done one by one. */

#define EMPTY_SUMS (-(Piece){0})

/* Places of the nodes of an inner cell, from its left edge, in units of dx. */
INLINE double inner_offset(MpmShape shape, int a)
{
    return shape == MPM_HAT ? a : shape == MPM_BSPLINE2 ? a - 0.5 : a - 1;
}

INLINE void wide_map(Bar *bar, MpmShape shape, bool affine, int c, int stop, bool again)
{
    const int support = shape_support(shape), slots = bar->slots;
    const double h = bar->gimp_half, dx = bar->dx;
    double *s_of[BAR_SLOTS_MAX], *v_of[BAR_SLOTS_MAX], *affine_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, bar->first[c], s_of);
    slots_of_run(bar->v, slots, bar->first[c], v_of);
    slots_of_run(bar->affine, slots, bar->first[c], affine_of);
    for (int i = 0; c + WIDTH <= stop; c += WIDTH, i += WIDTH) {
        Piece mass[BAR_SUPPORT_MAX], momentum[BAR_SUPPORT_MAX];
        UNROLL
        for (int a = 0; a < support; a++)
            mass[a] = momentum[a] = EMPTY_SUMS;
        for (int j = 0; j < slots; j++) {
            const Piece s = CONST_PIECE_AT(s_of[j], i), v = CONST_PIECE_AT(v_of[j], i);
            const Piece spin = affine ? CONST_PIECE_AT(affine_of[j], i) * dx : s;
            Piece n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_inner_wide(shape, h, &s, n, dn);
            UNROLL
            for (int a = 0; a < support; a++) {
                Piece given = affine ? v + spin * (inner_offset(shape, a) - s) : v;
                momentum[a] += given * n[a];
            }
            if (!again)
                UNROLL
            for (int a = 0; a < support; a++)
                mass[a] += n[a];
        }
        UNROLL
        for (int a = 0; a < support; a++)
            PIECE_AT(bar->part[1][a], c) = momentum[a];
        if (!again)
            UNROLL
        for (int a = 0; a < support; a++)
            PIECE_AT(bar->part[0][a], c) = mass[a];
    }
    for (; c < stop; c++)
        map_cell(bar, shape, affine, c);
}

INLINE bool wide_strain(Bar *bar, MpmShape shape, int c, int stop)
{
    const int support = shape_support(shape), slots = bar->slots;
    const double k = bar->dt / bar->dx, e = bar->def.youngs_modulus, h = bar->gimp_half;
    double *s_of[BAR_SLOTS_MAX], *stress_of[BAR_SLOTS_MAX], *volume_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, bar->first[c], s_of);
    slots_of_run(bar->stress, slots, bar->first[c], stress_of);
    slots_of_run(bar->volume, slots, bar->first[c], volume_of);
    PieceBits crushed = {0};
    for (int i = 0; c + WIDTH <= stop; c += WIDTH, i += WIDTH) {
        for (int j = 0; j < slots; j++) {
            const Piece s = CONST_PIECE_AT(s_of[j], i);
            Piece n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_inner_wide(shape, h, &s, n, dn);
            Piece gradient = dn[0] * CONST_PIECE_AT(bar->node_velocity, c);
            UNROLL
            for (int a = 1; a < support; a++)
                gradient += dn[a] * CONST_PIECE_AT(bar->node_velocity, c + a);
            const Piece de = k * gradient, stretch = 1.0 + de;
            crushed |= (PieceBits)(stretch - SMALLEST);
            PIECE_AT(stress_of[j], i) += e * de;
            PIECE_AT(volume_of[j], i) *= stretch;
        }
    }
    bool good = !any_negative(&crushed, 0);
    for (; c < stop; c++)
        good = strain_cell(bar, shape, c) && good;
    return good;
}

INLINE void wide_force(Bar *bar, MpmShape shape, int c, int stop)
{
    const int support = shape_support(shape), slots = bar->slots;
    const double h = bar->gimp_half;
    double *s_of[BAR_SLOTS_MAX], *stress_of[BAR_SLOTS_MAX], *volume_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, bar->first[c], s_of);
    slots_of_run(bar->stress, slots, bar->first[c], stress_of);
    slots_of_run(bar->volume, slots, bar->first[c], volume_of);
    for (int i = 0; c + WIDTH <= stop; c += WIDTH, i += WIDTH) {
        Piece force[BAR_SUPPORT_MAX];
        UNROLL
        for (int a = 0; a < support; a++)
            force[a] = EMPTY_SUMS;
        for (int j = 0; j < slots; j++) {
            const Piece s = CONST_PIECE_AT(s_of[j], i);
            Piece n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_inner_wide(shape, h, &s, n, dn);
            const Piece pull = CONST_PIECE_AT(stress_of[j], i) * CONST_PIECE_AT(volume_of[j], i);
            UNROLL
            for (int a = 0; a < support; a++)
                force[a] += dn[a] * pull;
        }
        UNROLL
        for (int a = 0; a < support; a++)
            PIECE_AT(bar->part[0][a], c) = force[a];
    }
    for (; c < stop; c++)
        force_cell(bar, shape, c);
}

INLINE void wide_update(Bar *bar, MpmShape shape, Transfer transfer, int c, int stop)
{
    const int support = shape_support(shape), slots = bar->slots;
    const double h = bar->gimp_half, alpha = bar->head->flip_fraction;
    const double speed = bar->dx / bar->dt, rate = 1.0 / bar->dt;
    double *s_of[BAR_SLOTS_MAX], *v_of[BAR_SLOTS_MAX], *moved_of[BAR_SLOTS_MAX], *affine_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, bar->first[c], s_of);
    slots_of_run(bar->v, slots, bar->first[c], v_of);
    slots_of_run(bar->moved, slots, bar->first[c], moved_of);
    slots_of_run(bar->affine, slots, bar->first[c], affine_of);
    for (int i = 0; c + WIDTH <= stop; c += WIDTH, i += WIDTH) {
        Piece kick[BAR_SUPPORT_MAX], drift[BAR_SUPPORT_MAX];
        UNROLL
        for (int a = 0; a < support; a++) {
            kick[a] = CONST_PIECE_AT(bar->node_kick, c + a);
            drift[a] = CONST_PIECE_AT(bar->node_drift, c + a);
        }
        for (int j = 0; j < slots; j++) {
            const Piece s = CONST_PIECE_AT(s_of[j], i), v = CONST_PIECE_AT(v_of[j], i);
            Piece n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
            shape_inner_wide(shape, h, &s, n, dn);
            Piece dv = n[0] * kick[0], ds = n[0] * drift[0];
            UNROLL
            for (int a = 1; a < support; a++) {
                dv += n[a] * kick[a];
                ds += n[a] * drift[a];
            }
            PIECE_AT(moved_of[j], i) = s + ds;
            if (transfer == TO_FLIP)
                PIECE_AT(v_of[j], i) = v + dv;
            else if (transfer == TO_BLEND)
                PIECE_AT(v_of[j], i) = alpha * (v + dv) + (1.0 - alpha) * (speed * ds);
            else {
                Piece slope = EMPTY_SUMS, spread = EMPTY_SUMS;
                UNROLL
                for (int a = 0; a < support; a++) {
                    const Piece arm = inner_offset(shape, a) - s;
                    slope += shape == MPM_HAT ? dn[a] * drift[a] : n[a] * drift[a] * arm;
                    spread += n[a] * (arm * arm);
                }
                PIECE_AT(affine_of[j], i) = rate * (shape == MPM_HAT ? slope : slope / spread);
                PIECE_AT(v_of[j], i) = speed * ds;
            }
        }
    }
    for (; c < stop; c++)
        update_cell(bar, shape, transfer, c);
}

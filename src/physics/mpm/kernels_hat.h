/* Part of kernels.c: hats with FLIP, runs of cells with P particles each. P is a constant, so that a cell's
 * sums stay in registers. Strain and force are the same for all particles of a cell. */

/* The j-th particles of a run of cells, side by side. */
INLINE void slots_of_run(double *const *arrays, int slots, int particle, double **out)
{
    int slot = particle % slots, k = particle / slots;
    UNROLL
    for (int j = 0; j < slots; j++) {
        out[j] = arrays[slot] + k;
        if (++slot == slots) {
            slot = 0;
            k++;
        }
    }
}

/* By particles per cell. */
#define FOR_SLOTS(which, call)                                                                               \
    switch (which) {                                                                                         \
        CASE(1, int, slots, call)                                                                            \
        CASE(2, int, slots, call)                                                                            \
        CASE(3, int, slots, call)                                                                            \
        CASE(4, int, slots, call)                                                                            \
        CASE(5, int, slots, call)                                                                            \
        CASE(6, int, slots, call)                                                                            \
        CASE(7, int, slots, call)                                                                            \
        CASE(8, int, slots, call)                                                                            \
    }

INLINE void hat_map_of(Bar *bar, const int slots, int c, int count, bool again)
{
    double *s[BAR_SLOTS_MAX], *v[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, bar->first[c], s);
    slots_of_run(bar->v, slots, bar->first[c], v);
    double *left_mass = bar->part[0][0] + c, *right_mass = bar->part[0][1] + c;
    double *left_momentum = bar->part[1][0] + c, *right_momentum = bar->part[1][1] + c;
    if (again) {
        VECTOR
        for (int i = 0; i < count; i++) {
            double left = EMPTY_SUM, right = EMPTY_SUM;
            UNROLL
            for (int j = 0; j < slots; j++) {
                left += v[j][i] * (1.0 - s[j][i]);
                right += v[j][i] * s[j][i];
            }
            left_momentum[i] = left;
            right_momentum[i] = right;
        }
        return;
    }
    VECTOR
    for (int i = 0; i < count; i++) {
        double left = EMPTY_SUM, right = EMPTY_SUM, left_p = EMPTY_SUM, right_p = EMPTY_SUM;
        UNROLL
        for (int j = 0; j < slots; j++) {
            double r = 1.0 - s[j][i];
            left += r;
            right += s[j][i];
            left_p += v[j][i] * r;
            right_p += v[j][i] * s[j][i];
        }
        left_mass[i] = left;
        right_mass[i] = right;
        left_momentum[i] = left_p;
        right_momentum[i] = right_p;
    }
}

static void hat_map(Bar *bar, int c, int count,
                    bool again){FOR_SLOTS(bar->slots, hat_map_of(bar, slots, c, count, again))}

INLINE bool hat_strain_of(Bar *bar, const int slots, int c, int count)
{
    double *stress[BAR_SLOTS_MAX], *volume[BAR_SLOTS_MAX];
    slots_of_run(bar->stress, slots, bar->first[c], stress);
    slots_of_run(bar->volume, slots, bar->first[c], volume);
    const double *momentum = bar->node_momentum + c, *inverse = bar->node_inverse + c;
    const double k = bar->dt / bar->dx, e = bar->def.youngs_modulus;
    int64_t crushed = 0;
    _Pragma("omp simd reduction(| : crushed)") for (int i = 0; i < count; i++)
    {
        double left = momentum[i] * inverse[i], right = momentum[i + 1] * inverse[i + 1];
        /* an inactive node moves with the other one: see bar_lend_velocity() */
        double least = inverse[i] < inverse[i + 1] ? inverse[i] : inverse[i + 1];
        double gradient = least > 0.0 ? right - left : 0.0;
        double de = k * gradient, stretch = 1.0 + de, rise = e * de;
        crushed |= !(stretch > 0.0);
        UNROLL
        for (int j = 0; j < slots; j++) {
            stress[j][i] += rise;
            volume[j][i] *= stretch;
        }
    }
    return crushed == 0;
}

static bool hat_strain(Bar *bar, int c, int count)
{
    bool good = true;
    FOR_SLOTS(bar->slots, good = hat_strain_of(bar, slots, c, count))
    return good;
}

INLINE void hat_force_of(Bar *bar, const int slots, int c, int count)
{
    double *stress[BAR_SLOTS_MAX], *volume[BAR_SLOTS_MAX];
    slots_of_run(bar->stress, slots, bar->first[c], stress);
    slots_of_run(bar->volume, slots, bar->first[c], volume);
    double *left = bar->part[0][0] + c, *right = bar->part[0][1] + c;
    VECTOR
    for (int i = 0; i < count; i++) {
        double pull = EMPTY_SUM;
        UNROLL
        for (int j = 0; j < slots; j++)
            pull += stress[j][i] * volume[j][i];
        left[i] = -pull;
        right[i] = pull;
    }
}

static void hat_force(Bar *bar, int c, int count){FOR_SLOTS(bar->slots, hat_force_of(bar, slots, c, count))}

INLINE void hat_update_of(Bar *bar, const int slots, int c, int count)
{
    double *s[BAR_SLOTS_MAX], *v[BAR_SLOTS_MAX], *moved[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, bar->first[c], s);
    slots_of_run(bar->v, slots, bar->first[c], v);
    slots_of_run(bar->moved, slots, bar->first[c], moved);
    const double *kick = bar->node_kick + c, *drift = bar->node_drift + c;
    VECTOR
    for (int i = 0; i < count; i++) {
        UNROLL
        for (int j = 0; j < slots; j++) {
            double right = s[j][i], left = 1.0 - right;
            v[j][i] += left * kick[i] + right * kick[i + 1];
            moved[j][i] = right + (left * drift[i] + right * drift[i + 1]);
        }
    }
}

static void hat_update(Bar *bar, int c, int count){FOR_SLOTS(bar->slots, hat_update_of(bar, slots, c, count))}

/* Any shape: whether the particles of a run all stay in their cells and in their order; if so they move. */
INLINE bool settle_of(Bar *bar, const int slots, int particle, int count)
{
    double *s[BAR_SLOTS_MAX], *moved[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, particle, s);
    slots_of_run(bar->moved, slots, particle, moved);
    int64_t gone = 0;
    _Pragma("omp simd reduction(| : gone)") for (int i = 0; i < count; i++)
    {
        double before = 0.0;
        UNROLL
        for (int j = 0; j < slots; j++) {
            gone |= !(moved[j][i] >= before);
            before = moved[j][i];
        }
        gone |= !(before < 1.0);
    }
    if (gone)
        return false;
    VECTOR
    for (int i = 0; i < count; i++) {
        UNROLL
        for (int j = 0; j < slots; j++)
            s[j][i] = moved[j][i];
    }
    return true;
}

static bool settle(Bar *bar, int count, int particle)
{
    bool stay = false;
    FOR_SLOTS(bar->slots, stay = settle_of(bar, slots, particle, count))
    return stay;
}

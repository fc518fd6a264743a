/* Part of kernels.c: hats with FLIP, runs of cells with P particles each. P is a constant, so that a cell's
 * sums stay in registers; strain and pull are the same for all particles of a cell. What is done to WIDTH
 * cells at once and to the last ones one by one is written once, in kernels_lanes.h. */

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

/* One of eight copies, by particles per cell. */
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
    double *const mass[2] = {bar->part[0][0] + c, bar->part[0][1] + c};
    double *const momentum[2] = {bar->part[1][0] + c, bar->part[1][1] + c};
    if (again)
        FOR_RANGE(0, count, map_again_wide(slots, s, v, momentum, i),
                  map_again_one(slots, s, v, momentum, i));
    else
        FOR_RANGE(0, count, map_wide(slots, s, v, mass, momentum, i),
                  map_one(slots, s, v, mass, momentum, i));
}

static void hat_map(Bar *bar, int c, int count, bool again)
{
    FOR_SLOTS(bar->slots, hat_map_of(bar, slots, c, count, again));
}

INLINE bool hat_strain_of(Bar *bar, const int slots, int c, int count)
{
    double *stress[BAR_SLOTS_MAX], *volume[BAR_SLOTS_MAX];
    slots_of_run(bar->stress, slots, bar->first[c], stress);
    slots_of_run(bar->volume, slots, bar->first[c], volume);
    double *momentum = bar->node_momentum + c, *inverse = bar->node_inverse + c;
    const double k = bar->dt / bar->dx, e = bar->def.youngs_modulus;
    PieceBits crushed_wide = {0};
    int64_t crushed = 0;
    FOR_RANGE(0, count, strain_wide(slots, stress, volume, momentum, inverse, k, e, &crushed_wide, i),
              strain_one(slots, stress, volume, momentum, inverse, k, e, &crushed, i));
    return !any_negative(&crushed_wide, crushed);
}

static bool hat_strain(Bar *bar, int c, int count)
{
    bool good = true;
    FOR_SLOTS(bar->slots, good = hat_strain_of(bar, slots, c, count));
    return good;
}

INLINE void hat_force_of(Bar *bar, const int slots, int c, int count)
{
    double *stress[BAR_SLOTS_MAX], *volume[BAR_SLOTS_MAX];
    slots_of_run(bar->stress, slots, bar->first[c], stress);
    slots_of_run(bar->volume, slots, bar->first[c], volume);
    double *pull = bar->part[0][1] + c;
    FOR_RANGE(0, count, pull_wide(slots, stress, volume, pull, i), pull_one(slots, stress, volume, pull, i));
}

/* Gives part[0][1] only: the pull at the right node; that at the left is its negative. */
static void hat_force(Bar *bar, int c, int count)
{
    FOR_SLOTS(bar->slots, hat_force_of(bar, slots, c, count));
}

INLINE void hat_update_of(Bar *bar, const int slots, int c, int count)
{
    double *s[BAR_SLOTS_MAX], *v[BAR_SLOTS_MAX], *moved[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, bar->first[c], s);
    slots_of_run(bar->v, slots, bar->first[c], v);
    slots_of_run(bar->moved, slots, bar->first[c], moved);
    double *kick = bar->node_kick + c, *drift = bar->node_drift + c;
    FOR_RANGE(0, count, update_wide(slots, s, v, moved, kick, drift, i),
              update_one(slots, s, v, moved, kick, drift, i));
}

static void hat_update(Bar *bar, int c, int count)
{
    FOR_SLOTS(bar->slots, hat_update_of(bar, slots, c, count));
}

/* Any shape. */
INLINE bool settle_of(Bar *bar, const int slots, int particle, int count)
{
    double *s[BAR_SLOTS_MAX], *moved[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, particle, s);
    slots_of_run(bar->moved, slots, particle, moved);
    PieceBits gone_wide = {0};
    int64_t gone = 0;
    FOR_RANGE(0, count, leave_cell_wide(slots, moved, &gone_wide, i), leave_cell_one(slots, moved, &gone, i));
    if (any_negative(&gone_wide, gone))
        return false;
    FOR_RANGE(0, count, move_wide(slots, s, moved, i), move_one(slots, s, moved, i));
    return true;
}

static bool settle(Bar *bar, int count, int particle)
{
    bool stay = false;
    FOR_SLOTS(bar->slots, stay = settle_of(bar, slots, particle, count));
    return stay;
}

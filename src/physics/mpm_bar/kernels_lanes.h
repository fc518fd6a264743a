/* Part of kernels.c: what is done to as many nodes or cells as a REAL has numbers, from i on. Included once
 * for vectors (_wide) and once for single numbers (_one). */

/* --- nodes ---------------------------------------------------------------------------------------- */

/* What the cells gave to node i, in the order of the cells. */
INLINE REAL NAME(gather)(double *const *part, const int support, int i)
{
    REAL sum = AT(part[support - 1], i - support + 1);
    UNROLL
    for (int a = support - 2; a >= 0; a--)
        sum += AT(part[a], i - a);
    return sum;
}

INLINE void NAME(scaled_gather)(double *const *part, const int support, double scale, double *out, int i)
{
    AT(out, i) = scale * NAME(gather)(part, support, i);
}

INLINE void NAME(node_mass)(double *const *part, const int support, double unit, double floor, double *masses,
                            double *inverses, int i)
{
    const REAL mass = unit * NAME(gather)(part, support, i);
    AT(masses, i) = mass;
    AT(inverses, i) = KEEP_IF(mass > floor, 1.0 / mass);
}

/* Of hats: a cell pulls its left node to the right, its right node as much to the left. */
INLINE void NAME(hat_force)(double *pull, double scale, double *force, int i)
{
    AT(force, i) = scale * (AT(pull, i - 1) - AT(pull, i));
}

INLINE void NAME(node_velocity)(double *momentum, double *inverse, double *velocity, int i)
{
    AT(velocity, i) = AT(momentum, i) * AT(inverse, i);
}

INLINE void NAME(integrate)(double *f_int, double *f_ext, double *inverse, double *momentum, double *kick,
                            double *drift, double dt, double drift_scale, int i)
{
    const REAL force = f_ext ? AT(f_int, i) + AT(f_ext, i) : AT(f_int, i), weight = AT(inverse, i);
    const REAL impulse = dt * force, after = AT(momentum, i) + impulse;
    AT(momentum, i) = after;
    AT(kick, i) = impulse * weight;
    AT(drift, i) = drift_scale * (after * weight);
}

/* --- cells of hats with FLIP ---------------------------------------------------------------------- */

INLINE void NAME(map)(const int slots, double *const *s, double *const *v, double *const *mass,
                      double *const *momentum, int i)
{
    REAL left = NO_TERMS, right = NO_TERMS, left_momentum = NO_TERMS, right_momentum = NO_TERMS;
    UNROLL
    for (int j = 0; j < slots; j++) {
        const REAL n = AT(s[j], i), speed = AT(v[j], i);
        left += 1.0 - n;
        right += n;
        left_momentum += speed * (1.0 - n);
        right_momentum += speed * n;
    }
    AT(mass[0], i) = left;
    AT(mass[1], i) = right;
    AT(momentum[0], i) = left_momentum;
    AT(momentum[1], i) = right_momentum;
}

INLINE void NAME(map_again)(const int slots, double *const *s, double *const *v, double *const *momentum,
                            int i)
{
    REAL left = NO_TERMS, right = NO_TERMS;
    UNROLL
    for (int j = 0; j < slots; j++) {
        const REAL n = AT(s[j], i), speed = AT(v[j], i);
        left += speed * (1.0 - n);
        right += speed * n;
    }
    AT(momentum[0], i) = left;
    AT(momentum[1], i) = right;
}

INLINE void NAME(strain)(const int slots, double *const *stress, double *const *volume, double *momentum,
                         double *inverse, double k, double e, BITS *crushed, int i)
{
    const REAL left = AT(momentum, i) * AT(inverse, i), right = AT(momentum, i + 1) * AT(inverse, i + 1);
    const REAL de = k * (right - left), stretch = 1.0 + de, rise = e * de;
    *crushed |= SIGN_BITS(stretch - SMALLEST);
    UNROLL
    for (int j = 0; j < slots; j++) {
        AT(stress[j], i) += rise;
        AT(volume[j], i) *= stretch;
    }
}

INLINE void NAME(pull)(const int slots, double *const *stress, double *const *volume, double *pull, int i)
{
    REAL sum = NO_TERMS;
    UNROLL
    for (int j = 0; j < slots; j++)
        sum += AT(stress[j], i) * AT(volume[j], i);
    AT(pull, i) = sum;
}

INLINE void NAME(update)(const int slots, double *const *s, double *const *v, double *const *moved,
                         double *kick, double *drift, int i)
{
    const REAL kick_left = AT(kick, i), kick_right = AT(kick, i + 1);
    const REAL drift_left = AT(drift, i), drift_right = AT(drift, i + 1);
    UNROLL
    for (int j = 0; j < slots; j++) {
        const REAL right = AT(s[j], i), left = 1.0 - right;
        AT(v[j], i) += left * kick_left + right * kick_right;
        AT(moved[j], i) = right + (left * drift_left + right * drift_right);
    }
}

/* Sets the sign bit where a particle is not in its cell after the step, or not in its order. */
INLINE void NAME(leave_cell)(const int slots, double *const *moved, BITS *gone, int i)
{
    REAL before = AT(moved[0], i);
    *gone |= SIGN_BITS(before);
    UNROLL
    for (int j = 1; j < slots; j++) {
        const REAL next = AT(moved[j], i);
        *gone |= SIGN_BITS(next - before);
        before = next;
    }
    *gone |= SIGN_BITS(BELOW_ONE - before);
}

INLINE void NAME(move)(const int slots, double *const *s, double *const *moved, int i)
{
    UNROLL
    for (int j = 0; j < slots; j++)
        AT(s[j], i) = AT(moved[j], i);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Part of bar_kernels.c: nodal velocities where masses are not lumped.
 *
 * The consistent mass matrix is M_c(i, j) = sum m N_i N_j. Its couplings of different nodes alone are kept,
 * node_couple[d][i] = M_c(i, i + d): as the N of a particle add up to 1, a row of M_c adds up to m_i, so that
 *
 *     M_c(i, i) = m_i - sum over j != i of M_c(i, j)
 *
 * Held and inactive nodes take no part: their velocity is 0. */

/* --- couplings ------------------------------------------------------------------------------------ */

/* M_c(i, i + d), d = 1 .. reach, from the cells' shares, in the order of the cells; mass per unit
 * cross-section, n_nodes entries each. */
KERNEL_INLINE void couple_shape(Bar *bar, MpmShape shape, int first, int end)
{
    EACH_CELL(first, end, run_end, couple_cell(bar, shape, c), couple_run(bar, shape, slots, c, stop))
    const int support = shape_support(shape), reach = shape_reach(shape), last = nodes_end(bar, end);
    const double unit = bar->mass;
    for (int d = 1; d <= reach; d++) {
        double *const couple = bar->node_couple[d], *const *const pair = bar->pair[d];
        for (int i = first; i < last; i++) {
            double sum = pair[support - 1 - d][i - (support - 1 - d)];
#pragma GCC unroll 4
            for (int a = support - 2 - d; a >= 0; a--)
                sum += pair[a][i - a];
            couple[i] = unit * sum;
        }
    }
}

static void couple(Bar *bar, int first, int end){BY_SHAPE(bar, couple_shape(bar, shape, first, end))}

/* --- mass blend ----------------------------------------------------------------------------------- */

/* M = (1 - mu) M_c + mu M_l = L D L^T without pivoting: M >= mu M_l, so that D > 0. Row i, from the left,
 * with e(d) = L(i, i - d) D(i - d):
 *
 *     e(d) = M(i, i - d) - sum over k > d of e(k) L(i - d, i - k)
 *     L(i, i - d) = e(d)/D(i - d)      D(i) = M(i, i) - sum e(d) L(i, i - d)
 *
 * (Golub and Van Loan, Matrix Computations, section 4.3.5.) A node that takes no part has an empty row with
 * 1/D = 0, so that it neither gets nor gives anything. */
KERNEL_INLINE void factor_reach(Bar *bar, const int reach)
{
    const double share = 1.0 - bar->head->mass_blend;
    double *const pivot = bar->node_pivot;
    for (int i = 0; i < bar->n_nodes; i++) {
        double whole = bar->node_mass[i], e[BAR_REACH_MAX + 1] = {0};
        const bool free = bar_node_moves(bar, i);
        for (int d = reach; d >= 1; d--) {
            const double before = i >= d ? share * bar->node_couple[d][i - d] : 0.0;
            whole -= before + share * bar->node_couple[d][i];
            e[d] = free && i >= d && pivot[i - d] > 0.0 ? before : 0.0;
            for (int k = d + 1; k <= reach && k <= i; k++)
                e[d] -= e[k] * bar->node_lower[k - d][i - d];
        }
        for (int d = 1; d <= reach; d++) {
            const double lower = i >= d ? e[d] * pivot[i - d] : 0.0;
            bar->node_lower[d][i] = lower;
            whole -= e[d] * lower;
        }
        pivot[i] = free ? 1.0 / whole : 0.0;
    }
}

/* x <- M^-1 x in place, n_nodes entries: L y = x from the left, then L^T x = D^-1 y from the right. At held
 * and inactive nodes x becomes 0. */
KERNEL_INLINE void solve_reach(const Bar *bar, const int reach, double *x)
{
    const int n = bar->n_nodes;
    for (int i = 0; i < n; i++)
        for (int d = 1; d <= reach && d <= i; d++)
            x[i] -= bar->node_lower[d][i] * x[i - d];
    for (int i = n - 1; i >= 0; i--) {
        x[i] *= bar->node_pivot[i];
        for (int d = 1; d <= reach && i + d < n; d++)
            x[i] -= bar->node_lower[d][i + d] * x[i + d];
    }
}

/* Hats: M is tridiagonal, and each row of the recurrences waits for the one before. A long bar is therefore
 * done in CHAINS stretches side by side, each of which begins WARM nodes early with what it has not seen left
 * out. That is forgotten on the way: M_l^-1 M has its eigenvalues between mu and 1, so that entries of M^-1
 * fall by q = (1 - sqrt(mu))/(1 + sqrt(mu)) or more from node to node (Demko, Moss and Smith 1984), and
 * q^WARM is 1e-19 at mu = .05, below a double's last digit. The stretches depend on the number of nodes
 * alone. */
enum { CHAINS = 8, WARM = 96, CHAINS_LEAST = 2048 };

typedef struct Chains {
    int count, length;     /* all have this length but the last, which has the rest too */
    int begin[CHAINS + 1]; /* of each, and the end of the last */
} Chains;

KERNEL_INLINE Chains chains_of(const Bar *bar)
{
    Chains chains = {.count = bar->n_nodes < CHAINS_LEAST ? 1 : CHAINS};
    chains.length = bar->n_nodes / chains.count;
    for (int c = 0; c < chains.count; c++)
        chains.begin[c] = c * chains.length;
    chains.begin[chains.count] = bar->n_nodes;
    return chains;
}

/* One row: e = M(i, i - 1), D = M(i, i) - e^2/D(i - 1); `before` is 1/D(i - 1) and becomes 1/D(i), 0 where
 * the node takes no part. */
KERNEL_INLINE double next_pivot(const double *own, double e, int i, double before)
{
    return own[i] > 0.0 ? 1.0 / (own[i] - e * (e * before)) : 0.0;
}

static void factor_hat(Bar *bar)
{
    const int n = bar->n_nodes;
    const double share = 1.0 - bar->head->mass_blend;
    const double *const couple = bar->node_couple[1], *const mass = bar->node_mass;
    const double *const inverse = bar->node_inverse;
    double *const pivot = bar->node_pivot, *const lower = bar->node_lower[1];
    /* first M(i, i) in the place of 1/D and M(i, i - 1) in that of L; 0 where a node takes no part */
    pivot[0] = mass[0] - share * couple[0];
    lower[0] = 0.0;
#pragma omp simd
    for (int i = 1; i < n; i++) {
        const bool moves = inverse[i] > 0.0, both = moves && inverse[i - 1] > 0.0;
        pivot[i] = moves ? mass[i] - share * (couple[i - 1] + couple[i]) : 0.0;
        lower[i] = both ? share * couple[i - 1] : 0.0;
    }
    if (bar->fixed_left > 0 || !(inverse[0] > 0.0))
        pivot[0] = lower[1] = 0.0; /* hats have one held node at an end at most */
    if (bar->fixed_right > 0)
        pivot[n - 1] = lower[n - 1] = 0.0;
    const Chains chains = chains_of(bar);
    double before[CHAINS] = {0};
    for (int c = 1; c < chains.count; c++)
        for (int i = chains.begin[c] - WARM; i < chains.begin[c]; i++)
            before[c] = next_pivot(pivot, lower[i], i, before[c]);
    for (int t = 0; chains.count == CHAINS && t < chains.length; t++)
#pragma GCC unroll 8
        for (int c = 0; c < CHAINS; c++) {
            const int i = chains.begin[c] + t;
            const double e = lower[i], now = next_pivot(pivot, e, i, before[c]);
            lower[i] = e * before[c];
            pivot[i] = before[c] = now;
        }
    double last = before[chains.count - 1];
    for (int i = chains.count == CHAINS ? CHAINS * chains.length : 0; i < n; i++) {
        const double e = lower[i], now = next_pivot(pivot, e, i, last);
        lower[i] = e * last;
        pivot[i] = last = now;
    }
}

static void solve_hat(const Bar *bar, double *x)
{
    const int n = bar->n_nodes;
    const double *const pivot = bar->node_pivot, *const lower = bar->node_lower[1];
    const Chains chains = chains_of(bar);
    const int rest = chains.count == CHAINS ? CHAINS * chains.length : 0;
    double before[CHAINS] = {0}, after[CHAINS] = {0};
    /* L y = x */
    for (int c = 1; c < chains.count; c++)
        for (int i = chains.begin[c] - WARM; i < chains.begin[c]; i++)
            before[c] = x[i] - lower[i] * before[c];
    for (int t = 0; chains.count == CHAINS && t < chains.length; t++)
#pragma GCC unroll 8
        for (int c = 0; c < CHAINS; c++) {
            const int i = chains.begin[c] + t;
            x[i] = before[c] = x[i] - lower[i] * before[c];
        }
    double last = before[chains.count - 1];
    for (int i = rest; i < n; i++)
        x[i] = last = x[i] - lower[i] * last;
    /* L^T x = D^-1 y; L(i + 1, i) of the node after the last is 0 */
    for (int c = 0; c + 1 < chains.count; c++)
        for (int i = chains.begin[c + 1] + WARM - 1; i >= chains.begin[c + 1]; i--)
            after[c] = x[i] * pivot[i] - lower[i + 1] * after[c];
    last = 0.0;
    for (int i = n - 1; i >= rest; i--)
        x[i] = last = x[i] * pivot[i] - (i + 1 < n ? lower[i + 1] : 0.0) * last;
    after[chains.count - 1] = last;
    for (int t = chains.length - 1; chains.count == CHAINS && t >= 0; t--)
#pragma GCC unroll 8
        for (int c = 0; c < CHAINS; c++) {
            const int i = chains.begin[c] + t;
            const double beside = i + 1 < n ? lower[i + 1] : 0.0;
            x[i] = after[c] = x[i] * pivot[i] - beside * after[c];
        }
}

static void factor(Bar *bar)
{
    if (bar->reach == 1)
        factor_hat(bar);
    else if (bar->reach == 2)
        factor_reach(bar, 2);
    else
        factor_reach(bar, 3);
}

static void solve(const Bar *bar, double *x)
{
    if (bar->reach == 1)
        solve_hat(bar, x);
    else if (bar->reach == 2)
        solve_reach(bar, 2, x);
    else
        solve_reach(bar, 3, x);
}

/* --- FMPM ----------------------------------------------------------------------------------------- */

/* v = d_1 + .. + d_k, where d_1 = p/m and each further term puts right what the terms before give back
 * wrongly through the particles (Nairn and Hammerquist, CMAME 377, 2021, 113667):
 *
 *     d_j+1 = d_j - (1/m) sum m N (sum N d_j) = (1/m_i) sum over n of M_c(i, n) (d_j(i) - d_j(n))
 *
 * as a row of M_c adds up to m_i. Each term is 0 at held nodes. x: p, then v; term and next are d_j and
 * d_j+1, in arrays that a mass blend would need for its factors. */
KERNEL_INLINE double next_term(const Bar *bar, const int reach, const bool inside, const double *term, int i)
{
    double sum = 0.0;
#pragma GCC unroll 4
    for (int d = 1; d <= reach; d++) {
        const double *const couple = bar->node_couple[d];
        if (inside || i + d < bar->n_nodes)
            sum += couple[i] * (term[i] - term[i + d]);
        if (inside || i >= d)
            sum += couple[i - d] * (term[i] - term[i - d]);
    }
    return sum * bar->node_inverse[i];
}

/* The terms at nodes [first, end) near an end of the mesh, where neighbours are missing or nodes are held. */
KERNEL_INLINE void next_terms_of_end(const Bar *bar, const int reach, const double *term, double *next,
                                     double *x, int first, int end)
{
    for (int i = first; i < end; i++) {
        next[i] = bar_node_moves(bar, i) ? next_term(bar, reach, false, term, i) : 0.0;
        x[i] += next[i];
    }
}

/* clang does not take the sum over neighbours apart before it looks for vectors, so it cannot do what the
 * pragma asks for, and warns. */
#ifdef __clang__
#define TERMS_SIMD
#else
#define TERMS_SIMD _Pragma("omp simd")
#endif

KERNEL_INLINE void series_reach(Bar *bar, const int reach, double *x)
{
    const int n = bar->n_nodes;
    const int left = bar->fixed_left > reach ? bar->fixed_left : reach;
    const int right = n - (bar->fixed_right > reach ? bar->fixed_right : reach);
    double *term = bar->node_pivot, *next = bar->node_lower[1];
    const double *const inverse = bar->node_inverse;
#pragma omp simd
    for (int i = 0; i < n; i++)
        x[i] = term[i] = inverse[i] > 0.0 ? x[i] * inverse[i] : 0.0;
    for (int i = 0; i < bar->fixed_left; i++)
        x[i] = term[i] = 0.0;
    for (int i = n - bar->fixed_right; i < n; i++)
        x[i] = term[i] = 0.0;
    for (int j = 1; j < bar->head->fmpm_order; j++) {
        next_terms_of_end(bar, reach, term, next, x, 0, left);
        TERMS_SIMD
        for (int i = left; i < right; i++) {
            next[i] = next_term(bar, reach, true, term, i);
            x[i] += next[i];
        }
        next_terms_of_end(bar, reach, term, next, x, right > left ? right : left, n);
        double *const kept = term;
        term = next;
        next = kept;
    }
}

static void series(Bar *bar, double *x)
{
    if (bar->reach == 1)
        series_reach(bar, 1, x);
    else if (bar->reach == 2)
        series_reach(bar, 2, x);
    else
        series_reach(bar, 3, x);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Nodal velocities along a line where masses are not lumped.
 *
 * The consistent mass matrix is M_c(i, j) = sum m N_i N_j. Its couplings of different nodes alone are kept,
 * couple[d][i] = M_c(i, i + d): as the N of a particle add up to 1, a row of M_c adds up to m_i, so that
 *
 *     M_c(i, i) = m_i - sum over j != i of M_c(i, j)
 *
 * Held and inactive nodes take no part: their velocity is 0. */
#include "base/assertion.h"
#include "methods/mpm/engine.h"

double mpm_consistent_mass(const Mpm *mpm, int i, int j)
{
    ASSERT(!mpm_is_lumped(mpm));
    ASSERT_INDEX(i, mpm->n_nodes);
    const int d = i < j ? j - i : i - j;
    if (d > 0)
        return d < mpm->support ? mpm->couple[d][i < j ? i : j] : 0.0;
    double mass = mpm->node_mass[i];
    for (int k = 1; k < mpm->support; k++)
        mass -= mpm->couple[k][i] + (i >= k ? mpm->couple[k][i - k] : 0.0);
    return mass;
}

/* M(i, j) = (1 - mu) M_c(i, j) + mu M_l(i, j), with FMPM M_c(i, j). */
double mpm_mass_between(const Mpm *mpm, int i, int j)
{
    if (mpm->head->transfer == MPM_FMPM)
        return mpm_consistent_mass(mpm, i, j);
    const double mu = mpm->head->mass_blend;
    return (1.0 - mu) * mpm_consistent_mass(mpm, i, j) + (i == j ? mu * mpm->node_mass[i] : 0.0);
}

/* M = (1 - mu) M_c + mu M_l = L D L^T without pivoting: M >= mu M_l, so that D > 0. Row i, from the left,
 * with e(d) = L(i, i - d) D(i - d):
 *
 *     e(d) = M(i, i - d) - sum over k > d of e(k) L(i - d, i - k)
 *     L(i, i - d) = e(d)/D(i - d)      D(i) = M(i, i) - sum e(d) L(i, i - d)
 *
 * (Golub and Van Loan, Matrix Computations, section 4.3.5.) A node that takes no part has an empty row with
 * 1/D = 0, so that it neither gets nor gives anything. */
void mpm_factor(Mpm *mpm)
{
    const double share = 1.0 - mpm->head->mass_blend;
    const int reach = mpm->support - 1;
    if (mpm->head->transfer == MPM_FMPM)
        return;
    for (int i = 0; i < mpm->n_nodes; i++) {
        double whole = mpm->node_mass[i], e[MPM_REACH_MAX + 1] = {0};
        const bool free = mpm_moves(mpm, i);
        for (int d = reach; d >= 1; d--) {
            const double before = i >= d ? share * mpm->couple[d][i - d] : 0.0;
            whole -= before + share * mpm->couple[d][i];
            e[d] = free && i >= d && mpm->pivot[i - d] > 0.0 ? before : 0.0;
            for (int k = d + 1; k <= reach && k <= i; k++)
                e[d] -= e[k] * mpm->lower[k - d][i - d];
        }
        for (int d = 1; d <= reach; d++) {
            const double lower = i >= d ? e[d] * mpm->pivot[i - d] : 0.0;
            mpm->lower[d][i] = lower;
            whole -= e[d] * lower;
        }
        mpm->pivot[i] = free ? 1.0 / whole : 0.0;
    }
}

/* L y = x from the left, then L^T x = D^-1 y from the right. */
static void solve_blend(const Mpm *mpm, double *x)
{
    const int n = mpm->n_nodes, reach = mpm->support - 1;
    for (int i = 0; i < n; i++)
        for (int d = 1; d <= reach && d <= i; d++)
            x[i] -= mpm->lower[d][i] * x[i - d];
    for (int i = n - 1; i >= 0; i--) {
        x[i] *= mpm->pivot[i];
        for (int d = 1; d <= reach && i + d < n; d++)
            x[i] -= mpm->lower[d][i + d] * x[i + d];
    }
}

/* FMPM(k): v = d_1 + .. + d_k, where d_1 = p/m and each further term puts right what the terms before give
 * back wrongly through the particles (Nairn and Hammerquist, CMAME 377, 2021, 113667):
 *
 *     d_j+1 = d_j - (1/m) sum m N (sum N d_j) = (1/m_i) sum over n of M_c(i, n) (d_j(i) - d_j(n))
 *
 * as a row of M_c adds up to m_i. Each term is 0 at held nodes. term and next are d_j and d_j+1, in arrays
 * that a mass blend would need for its factors. */
static void solve_series(Mpm *mpm, double *x)
{
    const int n = mpm->n_nodes, reach = mpm->support - 1;
    double *term = mpm->pivot, *next = mpm->lower[1];
    for (int i = 0; i < n; i++)
        x[i] = term[i] = mpm_moves(mpm, i) ? x[i] * mpm->inverse[i] : 0.0;
    for (int j = 1; j < mpm->head->fmpm_order; j++) {
        for (int i = 0; i < n; i++) {
            double sum = 0.0;
            for (int d = 1; d <= reach && mpm_moves(mpm, i); d++) {
                if (i + d < n)
                    sum += mpm->couple[d][i] * (term[i] - term[i + d]);
                if (i >= d)
                    sum += mpm->couple[d][i - d] * (term[i] - term[i - d]);
            }
            next[i] = sum * mpm->inverse[i];
            x[i] += next[i];
        }
        double *const kept = term;
        term = next;
        next = kept;
    }
}

void mpm_solve(Mpm *mpm, double *x)
{
    if (mpm->head->transfer == MPM_FMPM)
        solve_series(mpm, x);
    else
        solve_blend(mpm, x);
}

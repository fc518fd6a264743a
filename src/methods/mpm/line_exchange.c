/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a particle and a node of its cell exchange, factor by factor: the single terms of the sums of the
 * step,
 *
 *     m N_i                          mass                            (2)
 *     m v N_i                        momentum                        (3), APIC: v + C (x_i - x) in place of v
 *     -N'_i stress V                 internal force                  (10), V = m/rho
 *     N_i (m b + t V/h)              external force                  (11)
 *     dt N'_i v_i                    strain increment                (5), v_i = p_i/m_i (4)
 *     dt N_i f_i/m_i                 velocity                        (14)
 *     dt N_i p_i/m_i                 position                        (15)
 *
 * for the inspector and the written-out sums (line_explain.c). The stages themselves do not call this: their
 * loops are in stages.c. */
#include "base/assertion.h"
#include "methods/mpm/mistakes.h"

#include <math.h>
#include <string.h>

#define TABLE_TO(momentum, momentum_ascii, momentum_note, taken, taken_ascii, taken_note, taken_adds, place, \
                 place_ascii, place_note)                                                                    \
    {                                                                                                        \
        [GIVE_MASS] = {"map", MPM_PARTICLES, MPM_NODES, "mass", false, "m N", "m N", NULL},                  \
        [GIVE_MOMENTUM] = {"map", MPM_PARTICLES, MPM_NODES,      "momentum",                                 \
                           false, momentum,      momentum_ascii, momentum_note},                             \
        [GIVE_F_INT] =                                                                                       \
            {"force", MPM_PARTICLES, MPM_NODES, "f_int", false, "-N′ σ V", "-N' s V", "V = m/rho"},          \
        [GIVE_F_EXT] = {"force", MPM_PARTICLES, MPM_NODES, "f_ext", false, "N load", "N load", NULL},        \
        [GIVE_MOMENTUM_AGAIN] = {"map_again", MPM_PARTICLES, MPM_NODES,      "momentum",                     \
                                 false,       momentum,      momentum_ascii, momentum_note},                 \
        [TAKE_STRAIN] = {"strain", MPM_NODES, MPM_PARTICLES, "strain_increment",                             \
                         false,    "Δt N′ v", "dt N' v",     NULL},                                          \
        [TAKE_VELOCITY] = {"update",   MPM_NODES, MPM_PARTICLES, "v",                                        \
                           taken_adds, taken,     taken_ascii,   taken_note},                                \
        [TAKE_PLACE] = {"update", MPM_NODES, MPM_PARTICLES, "x", true, place, place_ascii, place_note},      \
    }
#define TABLE(...) TABLE_TO(__VA_ARGS__, "Δt N v", "dt N v", NULL)

static const Exchange flip_exchanges[BAR_EXCHANGES] =
    TABLE("m v N", "m v N", NULL, "Δt N a", "dt N a", "a = f/m", true);
static const Exchange blend_exchanges[BAR_EXCHANGES] =
    TABLE("m v N", "m v N", NULL, "N gain", "N gain", "gain = alpha dt f/m + (1 - alpha)(v_i - v_p)", true);
static const Exchange mass_exchanges[BAR_EXCHANGES] =
    TABLE("m v N", "m v N", NULL, "Δt N a", "dt N a", "a of M a = f", true);
static const Exchange mass_blend_exchanges[BAR_EXCHANGES] =
    TABLE("m v N", "m v N", NULL, "N gain", "N gain", "gain = alpha dt a + (1 - alpha)(v_i - v_p)", true);
static const Exchange pic_exchanges[BAR_EXCHANGES] = TABLE("m v N", "m v N", NULL, "N v", "N v", NULL, false);
static const Exchange apic_exchanges[BAR_EXCHANGES] =
    TABLE("m w N", "m w N", "w = v + C (x_i - x_p)", "N v", "N v", NULL, false);

static const Exchange series_exchanges[BAR_EXCHANGES] = TABLE_TO(
    "m v N", "m v N", NULL, "N v", "N v", NULL, false, "Δt N w", "dt N w", "w = (v_p before + v_i)/2");

/* Which table: what a transfer and the masses make of eqs. 3, 14 and 15. */
static const Exchange *exchanges_of(const MpmHead *head)
{
    const bool blended = head->mass_blend < 1.0;
    return head->transfer == MPM_APIC   ? apic_exchanges
           : head->transfer == MPM_FMPM ? series_exchanges
           : head->flip_fraction == 1.0 ? (blended ? mass_exchanges : flip_exchanges)
           : head->flip_fraction == 0.0 ? pic_exchanges
           : blended                    ? mass_blend_exchanges
                                        : blend_exchanges;
}

void mpm_list_exchanges(Mpm *mpm)
{
    memcpy(mpm->exchanges, exchanges_of(mpm->head), sizeof mpm->exchanges);
    mpm->exchanges[GIVE_F_EXT].note = *mpm->force_words.load ? mpm->force_words.load : NULL;
    mpm->sim.exchanges = mpm->exchanges;
    mpm->sim.n_exchanges = BAR_EXCHANGES;
}

/* Whether the numbers of an exchange can be had at this point of the step: computed already, not yet
 * overwritten. */
static bool at_hand(const Mpm *mpm, MpmExchange exchange)
{
    const bool updated = mpm_has_done(mpm, OP_UPDATE), strained = mpm_has_done(mpm, OP_STRAIN);
    const bool forced = mpm_has_done(mpm, OP_FORCE);
    switch (exchange) {
    case GIVE_MASS:
        return true;
    case GIVE_MOMENTUM:
        return !updated;
    case GIVE_F_INT:
        return forced && (mpm->head->algorithm == MPM_USF || !strained);
    case GIVE_F_EXT:
        return forced && mpm_is_loaded(mpm) && (mpm->head->algorithm == MPM_USF || !strained);
    case GIVE_MOMENTUM_AGAIN:
        return updated && mpm->head->algorithm == MPM_MUSL && mpm_has_done(mpm, OP_MAP_AGAIN);
    case TAKE_STRAIN:
        return strained;
    case TAKE_VELOCITY:
        return updated;
    case TAKE_PLACE:
        return mpm_has_done(mpm, mpm_moves_by(mpm) == MOVES_WITH_MAPPED ? OP_MAP_AGAIN : OP_UPDATE);
    case BAR_EXCHANGES:
        break;
    }
    return false;
}

/* The particle's velocity as seen at its node a: v, with APIC v + C (x_a - x). */
static double given_velocity(const Mpm *mpm, int particle, int base, int a, double s)
{
    if (mpm->head->transfer != MPM_APIC)
        return mpm->v[0][particle];
    const double arm = shape_node_offset(mpm->shape, mpm->half, mpm->cells, base, a) - s;
    return mpm->v[0][particle] + mpm->affine[particle] * (mpm->dx * arm);
}

/* With flip_fraction alpha < 1 a particle's new velocity is
 *
 *     v' = alpha (v + sum N_i kick_i) + (1 - alpha) sum N_i v_i
 *        = v + sum N_i [alpha kick_i + (1 - alpha)(v_i - v)],   as sum N_i = 1;
 *
 * this is the bracket of node a. The old v is no longer stored after the update: it is solved for. */
static double blended_gain(const Mpm *mpm, const double n[], int base, int particle, int a)
{
    const double alpha = mpm->head->flip_fraction, now = mpm->v[0][particle];
    double kick = 0, mean = 0;
    for (int i = 0; i < mpm->support; i++) {
        kick += n[i] * mpm->kick[0][base + i];
        mean += n[i] * mpm->carry[0][base + i];
    }
    const double old = (now - (1 - alpha) * mean) / alpha - kick;
    return alpha * mpm->kick[0][base + a] + (1 - alpha) * (mpm->carry[0][base + a] - old);
}

/* N of a particle at its node, by which it takes its velocity. */
static double kick_weight(const Mpm *mpm, int particle, int node, double weight)
{
    double n[SHAPE_SUPPORT_MAX];
    int base;
    if (!mpm_mistake(mpm))
        return weight;
    mpm_kick_weights(mpm, particle, &base, n);
    return node >= base && node < base + mpm->support ? n[node - base] : 0.0;
}

/* The factors of one term, in the order of the exchange's words. 0: not at hand, or the node is none of the
 * particle's cell. */
int mpm_exchange(const Simulation *sim, int exchange, size_t from, size_t to,
                 double factors[EXCHANGE_FACTORS_MAX])
{
    ASSERT_INDEX(exchange, sim->n_exchanges);
    ASSERT_INDEX(from, sim->counts[sim->exchanges[exchange].from]);
    ASSERT_INDEX(to, sim->counts[sim->exchanges[exchange].to]);
    const Mpm *mpm = mpm_of_const(sim);
    if (!at_hand(mpm, (MpmExchange)exchange))
        return 0;
    const bool gives = mpm->sim.exchanges[exchange].from == MPM_PARTICLES;
    const int particle = (int)(gives ? from : to), node = (int)(gives ? to : from);
    MpmWeights w;
    double v[SHAPE_SUPPORT_MAX];
    const int base = mpm->base[particle];
    const double s = mpm->s[0][particle];
    const int a = node - base;
    if (a < 0 || a >= mpm->support)
        return 0;
    mpm_weights(mpm, 1, mpm->shape, mpm_half(mpm, particle), base, &s, &w);
    const double *n = w.n[0], *dn = w.dn[0];
    switch ((MpmExchange)exchange) {
    case GIVE_MASS:
        return exchange_two(factors, mpm_mass(mpm, particle), n[a]);
    case GIVE_MOMENTUM:
    case GIVE_MOMENTUM_AGAIN:
        return exchange_three(factors, mpm_mass(mpm, particle), given_velocity(mpm, particle, base, a, s),
                              n[a]);
    case GIVE_F_INT:
        if (mpm_mistake(mpm))
            return exchange_three(factors,
                                  copysign(mpm_slope_scale(mpm, OP_FORCE), mpm_force_share(mpm)) * dn[a],
                                  mpm_force_stress(mpm, particle), mpm_force_volume(mpm, particle));
        return exchange_three(factors, -dn[a] / mpm->dx, mpm->stress[0][particle], mpm->volume[particle]);
    case GIVE_F_EXT:
        return exchange_two(factors, n[a], mpm_load_on(mpm, particle));
    case TAKE_STRAIN:
        mpm_line_velocities(mpm->shape, mpm->velocity[0], mpm->inverse, base, v);
        if (mpm_mistake(mpm))
            return exchange_three(factors, mpm_strain_span(mpm), mpm_slope_scale(mpm, OP_STRAIN) * dn[a],
                                  v[a]);
        return exchange_three(factors, mpm->dt, dn[a] / mpm->dx, v[a]);
    case TAKE_VELOCITY:
        if (mpm->head->transfer != MPM_FLIP || mpm->head->flip_fraction == 0.0)
            return exchange_two(factors, n[a], mpm->carry[0][node]);
        if (mpm->head->flip_fraction != 1.0)
            return exchange_two(factors, n[a], blended_gain(mpm, n, base, particle, a));
        return exchange_three(factors, mpm->dt, kick_weight(mpm, particle, node, n[a]),
                              mpm->kick[0][node] / mpm->dt);
    case TAKE_PLACE:
        if (mpm->head->transfer == MPM_FMPM) {
            /* the velocity before is no longer stored: it is solved for */
            const double now = mpm->v[0][particle];
            const double before = 2.0 * mpm_way(mpm, particle) / mpm->dt - now;
            return exchange_three(factors, mpm->dt, n[a], 0.5 * (before + mpm->carry[0][node]));
        }
        return exchange_three(factors, mpm->dt, n[a], mpm_moving_velocity(mpm, particle, node));
    case BAR_EXCHANGES:
        break;
    }
    return 0;
}

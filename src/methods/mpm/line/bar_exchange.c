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
 * for the inspector and the written-out sums (bar_explain.c). The stages themselves do not call this: their
 * loops are in bar_kernels.c. */
#include "base/assertion.h"
#include "methods/mpm/line/bar_mistakes.h"
#include "methods/mpm/line/bar_state.h"
#include "methods/mpm/line/kernels/shape.h"

#include <math.h>
#include <string.h>

#define TABLE_TO(momentum, momentum_ascii, momentum_note, taken, taken_ascii, taken_note, taken_adds, place, \
                 place_ascii, place_note)                                                                    \
    {                                                                                                        \
        [GIVE_MASS] = {"map", BAR_PARTICLES, BAR_NODES, "mass", false, "m N", "m N", NULL},                  \
        [GIVE_MOMENTUM] = {"map", BAR_PARTICLES, BAR_NODES,      "momentum",                                 \
                           false, momentum,      momentum_ascii, momentum_note},                             \
        [GIVE_F_INT] =                                                                                       \
            {"force", BAR_PARTICLES, BAR_NODES, "f_int", false, "-N′ σ V", "-N' s V", "V = m/rho"},          \
        [GIVE_F_EXT] = {"force", BAR_PARTICLES, BAR_NODES, "f_ext", false, "N load", "N load", NULL},        \
        [GIVE_MOMENTUM_AGAIN] = {"map_again", BAR_PARTICLES, BAR_NODES,      "momentum",                     \
                                 false,       momentum,      momentum_ascii, momentum_note},                 \
        [TAKE_STRAIN] = {"strain", BAR_NODES, BAR_PARTICLES, "strain_increment",                             \
                         false,    "Δt N′ v", "dt N' v",     NULL},                                          \
        [TAKE_VELOCITY] = {"update",   BAR_NODES, BAR_PARTICLES, "v",                                        \
                           taken_adds, taken,     taken_ascii,   taken_note},                                \
        [TAKE_PLACE] = {"update", BAR_NODES, BAR_PARTICLES, "x", true, place, place_ascii, place_note},      \
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
static const Exchange *exchanges_of(const BarHead *head)
{
    const bool blended = head->mass_blend < 1.0;
    return head->transfer == MPM_APIC   ? apic_exchanges
           : head->transfer == MPM_FMPM ? series_exchanges
           : head->flip_fraction == 1.0 ? (blended ? mass_exchanges : flip_exchanges)
           : head->flip_fraction == 0.0 ? pic_exchanges
           : blended                    ? mass_blend_exchanges
                                        : blend_exchanges;
}

void bar_list_exchanges(Bar *bar)
{
    memcpy(bar->exchanges, exchanges_of(bar->head), sizeof bar->exchanges);
    bar->exchanges[GIVE_F_EXT].note = *bar->force_words.load ? bar->force_words.load : NULL;
    bar->sim.exchanges = bar->exchanges;
    bar->sim.n_exchanges = BAR_EXCHANGES;
}

/* Whether the numbers of an exchange can be had at this point of the step: computed already, not yet
 * overwritten. */
static bool at_hand(const Bar *bar, BarExchange exchange)
{
    const bool updated = bar_has_done(bar, OP_UPDATE), strained = bar_has_done(bar, OP_STRAIN);
    const bool forced = bar_has_done(bar, OP_FORCE);
    switch (exchange) {
    case GIVE_MASS:
        return true;
    case GIVE_MOMENTUM:
        return !updated;
    case GIVE_F_INT:
        return forced && (bar->head->algorithm == MPM_USF || !strained);
    case GIVE_F_EXT:
        return forced && bar_is_loaded(bar) && (bar->head->algorithm == MPM_USF || !strained);
    case GIVE_MOMENTUM_AGAIN:
        return updated && bar->head->algorithm == MPM_MUSL && bar_has_done(bar, OP_MAP_AGAIN);
    case TAKE_STRAIN:
        return strained;
    case TAKE_VELOCITY:
    case TAKE_PLACE:
        return updated;
    case BAR_EXCHANGES:
        break;
    }
    return false;
}

/* The particle's velocity as seen at node a of its cell: v, with APIC v + C (x_a - x). */
static double given_velocity(const Bar *bar, int particle, int cell, int a, double s)
{
    const int slot = particle % bar->slots, k = particle / bar->slots;
    if (bar->head->transfer != MPM_APIC)
        return bar->v[slot][k];
    double arm = shape_node_offset(bar->def.shape, bar->n_cells, cell, a) - s;
    return bar->v[slot][k] + bar->affine[slot][k] * (bar->dx * arm);
}

/* With flip_fraction alpha < 1 a particle's new velocity is
 *
 *     v' = alpha (v + sum N_i kick_i) + (1 - alpha) sum N_i v_i
 *        = v + sum N_i [alpha kick_i + (1 - alpha)(v_i - v)],   as sum N_i = 1;
 *
 * this is the bracket of node a. The old v is no longer stored after the update: it is solved for. */
static double blended_gain(const Bar *bar, const double n[], int cell, int particle, int a)
{
    const double alpha = bar->head->flip_fraction, speed = bar->dx / bar->dt;
    const double now = bar->v[particle % bar->slots][particle / bar->slots];
    double kick = 0, mean = 0;
    for (int i = 0; i < bar->support; i++) {
        kick += n[i] * bar->node_kick[cell + i];
        mean += n[i] * bar->node_drift[cell + i] * speed;
    }
    const double old = (now - (1 - alpha) * mean) / alpha - kick;
    return alpha * bar->node_kick[cell + a] + (1 - alpha) * (bar->node_drift[cell + a] * speed - old);
}

/* N of a particle at a node of its cell, by which it takes its velocity. */
static double kick_weight(const Bar *bar, int particle, int node, double weight)
{
    double n[2];
    int cell;
    if (!bar_mistake(bar))
        return weight;
    bar_kick_weights(bar, particle, &cell, n);
    return node == cell || node == cell + 1 ? n[node - cell] : 0.0;
}

/* The factors of one term, in the order of the exchange's words. 0: not at hand, or the node is none of the
 * particle's cell. */
int bar_exchange(const Simulation *sim, int exchange, size_t from, size_t to,
                 double factors[EXCHANGE_FACTORS_MAX])
{
    ASSERT_INDEX(exchange, sim->n_exchanges);
    ASSERT_INDEX(from, sim->counts[sim->exchanges[exchange].from]);
    ASSERT_INDEX(to, sim->counts[sim->exchanges[exchange].to]);
    const Bar *bar = bar_of_const(sim);
    if (!at_hand(bar, (BarExchange)exchange))
        return 0;
    const bool gives = bar->sim.exchanges[exchange].from == BAR_PARTICLES;
    const int particle = (int)(gives ? from : to), node = (int)(gives ? to : from);
    const int cell = bar_cell_of(bar, particle), a = node - cell;
    if (a < 0 || a >= bar->support)
        return 0;
    const int slot = particle % bar->slots, k = particle / bar->slots;
    const double s = bar->s[slot][k], volume = bar->volume[slot][k];
    double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX], v[BAR_SUPPORT_MAX];
    shape_at(bar->def.shape, bar_half(bar, particle), bar->n_cells, cell, s, n, dn);
    switch ((BarExchange)exchange) {
    case GIVE_MASS:
        return exchange_two(factors, bar_particle_mass(bar, particle), n[a]);
    case GIVE_MOMENTUM:
    case GIVE_MOMENTUM_AGAIN:
        return exchange_three(factors, bar_particle_mass(bar, particle),
                              given_velocity(bar, particle, cell, a, s), n[a]);
    case GIVE_F_INT:
        if (bar_mistake(bar))
            return exchange_three(factors, copysign(bar_slope_scale(bar), bar_force_share(bar)) * dn[a],
                                  bar_force_stress(bar, particle), bar_force_volume(bar, particle));
        return exchange_three(factors, -dn[a] / bar->dx, bar->stress[slot][k], volume);
    case GIVE_F_EXT:
        return exchange_two(factors, n[a], bar_load_on(bar, particle));
    case TAKE_STRAIN:
        bar_strain_velocities(bar, cell, v);
        if (bar_mistake(bar))
            return exchange_three(factors, bar_strain_span(bar), bar_slope_scale(bar) * dn[a], v[a]);
        return exchange_three(factors, bar->dt, dn[a] / bar->dx, v[a]);
    case TAKE_VELOCITY:
        if (bar->head->transfer != MPM_FLIP || bar->head->flip_fraction == 0.0)
            return exchange_two(factors, n[a], bar_integrated_velocity(bar, node));
        if (bar->head->flip_fraction != 1.0)
            return exchange_two(factors, n[a], blended_gain(bar, n, cell, particle, a));
        return exchange_three(factors, bar->dt, kick_weight(bar, particle, node, n[a]),
                              bar->node_kick[node] / bar->dt);
    case TAKE_PLACE:
        if (bar->head->transfer == MPM_FMPM) {
            /* the velocity before is no longer stored: it is solved for */
            const double now = bar->v[slot][k];
            const double before = 2.0 * (bar->moved[slot][k] - s) * (bar->dx / bar->dt) - now;
            return exchange_three(factors, bar->dt, n[a],
                                  0.5 * (before + bar_integrated_velocity(bar, node)));
        }
        return exchange_three(factors, bar->dt, n[a], bar_moving_velocity(bar, particle, node));
    case BAR_EXCHANGES:
        break;
    }
    return 0;
}

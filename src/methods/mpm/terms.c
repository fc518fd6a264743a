/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of exchanges: who gives what to whom in which stage, as a product of named factors. The sums of
 * a step are sums of these products over the pairs of a particle p and a node i of its cell; the written-out
 * sums (explain.c), the arrows of the cell view and the inspector are made of them, and
 * tests/methods/check_terms.c holds the loops of stages.c to them. In the plane "@" is x and y.
 *
 *     m N_i                               mass                        (2)
 *     m v N_i                             momentum                    (3), APIC: v + C (x_i - x) for v
 *
 *     -grad N_i . stress V                internal force              (10), V = m/rho; of bodies with weight
 *
 *     N_i (m b + t V/h)                   external force of a line    (11)
 *     dt grad N_i v_i                     strain increment            (5), v_i = p_i/m_i (4)
 *     dt N_i f_i/m_i                      velocity                    (14)
 *     dt N_i p_i/m_i                      position                    (15) */
#include "base/assertion.h"
#include "base/text.h"
#include "methods/calculation.h"
#include "methods/mpm/mistakes.h"

#include <string.h>

typedef struct Row {
    MpmTerm term;
    MpmOp op;
    unsigned when;        /* mpm_is() */
    const char *field[2]; /* of the receiver, along a line and in the plane; NULL: not there */
    const char *symbol;   /* how the sum begins */
    bool adds;            /* to what the field was */
    const char *factors;  /* one word each */
    const char *note;     /* what a factor is; NULL: the stage's equation says it */
} Row;

#define NO_APIC (BY_FLIP | BY_BLEND | BY_PIC | BY_FMPM)
#define INTO_P  {"momentum", "p@"}, "p@", false
#define INTO_F  {NULL, "f@"}, "f@", false
#define INTO_V  {"v", "v@"}, "v@", true
#define INTO_X  {"x", "@"}, "@", true

static const char *const stage_ids[OP_COUNT] = {[OP_MAP] = "map",
                                                [OP_STRAIN] = "strain",
                                                [OP_FORCE] = "force",
                                                [OP_UPDATE] = "update",
                                                [OP_MAP_AGAIN] = "map_again"};

static const Row rows[] = {
    {TERM_MASS, OP_MAP, 0, {"mass", "mass"}, "m", false, "m N", NULL},
    {TERM_MOMENTUM, OP_MAP, NO_APIC, INTO_P, "m v@ N", NULL},
    {TERM_MOMENTUM, OP_MAP, BY_APIC, INTO_P, "m w@ N", "w = v + C (x_i - x_p)"},
    {TERM_STRESS, OP_FORCE, 0, {"f_int", NULL}, "f_int", false, "-N′ σ V", "V = m/rho"},
    {TERM_STRESS, OP_FORCE, IN_BEAM, INTO_F, "s@ V", "s@ = -(σ@x N,x + σ@y N,y), V = m/ρ"},
    {TERM_STRESS, OP_FORCE, IN_BODIES, INTO_F, "s@ V", "s@ = ρ g@ N - (σ@x N,x + σ@y N,y), V = m/ρ"},
    {TERM_LOAD, OP_FORCE, 0, {"f_ext", NULL}, "f_ext", false, "N load", NULL},
    {TERM_MOMENTUM, OP_MAP_AGAIN, NO_APIC, INTO_P, "m v@ N", NULL},
    {TERM_MOMENTUM, OP_MAP_AGAIN, BY_APIC, INTO_P, "m w@ N", "w = v + C (x_i - x_p)"},
    {TERM_STRAIN, OP_STRAIN, 0, {"strain_increment", NULL}, "Δε", false, "Δt N′ v", NULL},
    {TERM_STRAIN, OP_STRAIN, 0, {NULL, "e@@"}, "Δε@@", false, "Δt N,@ v@", NULL},
    {TERM_SHEAR, OP_STRAIN, 0, {NULL, "gxy"}, "Δγxy", false, "Δt turn", "turn = N,y vx + N,x vy"},
    {TERM_VELOCITY, OP_UPDATE, IN_LINE | IN_BEAM | BY_FLIP | IS_LUMPED, INTO_V, "Δt N a@", "a = f/m"},
    {TERM_VELOCITY, OP_UPDATE, BY_FLIP | IS_COUPLED, INTO_V, "Δt N a@", "a of M a = f"},
    {TERM_VELOCITY, OP_UPDATE, IN_BODIES | BY_FLIP, INTO_V, "N gain_@", "gain = (q - q0)/m"},
    {TERM_VELOCITY, OP_UPDATE, IN_LINE | IN_BEAM | BY_BLEND | IS_LUMPED, INTO_V, "N gain_@",
     "gain = alpha dt f/m + (1 - alpha)(v_i - v_p)"},
    {TERM_VELOCITY, OP_UPDATE, BY_BLEND | IS_COUPLED, INTO_V, "N gain_@",
     "gain = alpha dt a + (1 - alpha)(v_i - v_p)"},
    {TERM_VELOCITY, OP_UPDATE, IN_BODIES | BY_BLEND, INTO_V, "N gain_@",
     "gain = alpha (q - q0)/m + (1 - alpha)(v_i - v_p)"},
    {TERM_VELOCITY, OP_UPDATE, BY_PIC | BY_APIC | BY_FMPM, {"v", "v@"}, "v@", false, "N v@", NULL},
    {TERM_PLACE, OP_UPDATE, BY_FLIP | BY_BLEND | BY_PIC | BY_APIC, INTO_X, "Δt N v@", NULL},
    {TERM_PLACE, OP_UPDATE, BY_FMPM, INTO_X, "Δt N w", "w = (v_p before + v_i)/2"},
};

static void write_form(const Mpm *mpm, const char *form, int axis, char *out, size_t size)
{
    text_append(out, size, "%s", calculation_label(mpm->dim, form ? form : "", axis, 0).text);
}

void mpm_list_exchanges(Mpm *mpm)
{
    int count = 0;
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const Row *row = &rows[k];
        const char *form = row->field[mpm->dim - 1];
        for (int axis = 0; form && mpm_is(mpm, row->when) && axis < (strchr(row->symbol, '@') ? mpm->dim : 1);
             axis++) {
            MpmExchange *words = &mpm->terms[count];
            *words = (MpmExchange){.term = row->term, .op = row->op, .axis = axis};
            write_form(mpm, form, axis, words->field, sizeof words->field);
            write_form(mpm, *row->symbol == '@' ? form : row->symbol, axis, words->symbol,
                       sizeof words->symbol);
            write_form(mpm, row->factors, axis, words->factors, sizeof words->factors);
            write_form(mpm, row->term == TERM_LOAD ? mpm->force_words.load : row->note, axis, words->note,
                       sizeof words->note);
            const bool gives = mpm_op_gives(row->op);
            mpm->exchanges[count++] = (Exchange){.stage = stage_ids[row->op],
                                                 .from = gives ? MPM_PARTICLES : MPM_NODES,
                                                 .to = gives ? MPM_NODES : MPM_PARTICLES,
                                                 .field = words->field,
                                                 .adds = row->adds || mpm_adds_to_grid(mpm, row->op),
                                                 .factors = words->factors,
                                                 .note = *words->note ? words->note : NULL};
        }
    }
    mpm->sim.exchanges = mpm->exchanges;
    mpm->sim.n_exchanges = count;
}

/* Whether the numbers of an exchange can be had at this point of the step: computed already, not yet
 * overwritten. */
static bool at_hand(const Mpm *mpm, const MpmExchange *of)
{
    const bool updated = mpm_has_done(mpm, OP_UPDATE), strained = mpm_has_done(mpm, OP_STRAIN);
    if (of->term == TERM_MASS)
        return true;
    if (of->term == TERM_MOMENTUM)
        return of->op == OP_MAP ? !updated : mpm_has_done(mpm, OP_MAP_AGAIN);
    if (of->term == TERM_PLACE && mpm_does(mpm, WRONG_MOVES_WITH_MAPPED))
        return mpm_has_done(mpm, OP_MAP_AGAIN);
    if (of->term == TERM_LOAD && !mpm_is_loaded(mpm))
        return false;
    return mpm_has_done(mpm, of->op) && (of->op != OP_FORCE || mpm->head->algorithm == MPM_USF || !strained);
}

/* The particle's velocity as seen at its node (a, b): with APIC v + C (x_i - x). */
static double given_velocity(const Mpm *mpm, int axis, int p, const int at[2], const MpmWeights *w)
{
    double v = mpm->v[axis][p];
    if (mpm->head->transfer != MPM_APIC)
        return v;
    if (mpm->dim == 1) {
        const double arm =
            shape_node_offset(mpm->shape, mpm->half, mpm->cells, mpm->base[p], at[0]) - mpm->s[0][p];
        return v + mpm->affine[p] * (mpm->dx * arm);
    }
    for (int k = 0; k < 2; k++) {
        const double D = mpm_spread(mpm->shape, mpm->edge, mpm->s[k][p], w->n[k]) * mpm->dx;
        v += D > 0.0 ? mpm->rate[2 * axis + k][p] / D * (at[k] - (mpm->s[k][p] - mpm->edge)) : 0.0;
    }
    return v;
}

/* With a flip fraction alpha a particle's new velocity is
 *
 *     v' = alpha (v + sum N_i kick_i) + (1 - alpha) sum N_i v_i
 *        = v + sum N_i [alpha kick_i + (1 - alpha)(v_i - v)],   as sum N_i = 1;
 *
 * this is the bracket of a node. The old v is no longer stored after the update: it is solved for. */
static double gain_of(const Mpm *mpm, int axis, int p, int node, const MpmWeights *w)
{
    const double alpha = mpm->head->flip_fraction, *const kick = mpm->kick[axis], *const v = mpm->carry[axis];
    double kicks = 0.0, mean = 0.0;
    for (int b = 0; b < mpm_across(mpm); b++)
        for (int a = 0; a < mpm->support; a++) {
            const double N = w->n[0][a] * w->n[1][b];
            kicks += N * kick[mpm->base[p] + b * mpm->gx + a];
            mean += N * v[mpm->base[p] + b * mpm->gx + a];
        }
    const double old = (mpm->v[axis][p] - (1.0 - alpha) * mean) / alpha - kicks;
    return alpha * kick[node] + (1.0 - alpha) * (v[node] - old);
}

/* The factors of one term, in the order of the exchange's words. 0: not at hand, or the node is none of the
 * particle's cell. */
int mpm_exchange(const Simulation *sim, int exchange, size_t index, const Link *link,
                 double factors[EXCHANGE_FACTORS_MAX])
{
    ASSERT_INDEX(exchange, sim->n_exchanges);
    ASSERT_INDEX(index, sim->counts[1 - link->set]);
    ASSERT_INDEX(link->index, sim->counts[link->set]);
    const Mpm *mpm = mpm_of_const(sim);
    const MpmExchange *of = &mpm->terms[exchange];
    const bool own = link->set == MPM_NODES;
    const int p = (int)(own ? index : link->index), node = (int)(own ? link->index : index);
    const int base = mpm->base[p];
    const int gx = mpm->gx, axis = of->axis;
    const int at[2] = {node % gx - base % gx, node / gx - base / gx};
    if (!at_hand(mpm, of) || at[0] < 0 || at[0] >= mpm->support || at[1] < 0 || at[1] >= mpm_across(mpm))
        return 0;
    const MpmWeights w = mpm_weights_of(mpm, p);
    const double *const n = w.n[0], *const dn = w.dn[0];
    const double ny = w.n[1][at[1]], m = mpm_mass(mpm, p);
    double N = n[at[0]] * ny;
    const double slope[2] = {dn[at[0]] * ny, n[at[0]] * w.dn[1][at[1]]};
    switch (of->term) {
    case TERM_MASS:
        return exchange_two(factors, m, N);
    case TERM_MOMENTUM:
        return exchange_three(factors, m, given_velocity(mpm, axis, p, at, &w), N);
    case TERM_STRESS: {
        const double scale = copysign(mpm_slope_scale(mpm, OP_FORCE), mpm_force_share(mpm));
        const double V = mpm_force_volume(mpm, p);
        double stress[MPM_STRESSES];
        mpm_force_stress(mpm, p, stress);
        if (mpm->dim == 1)
            return exchange_three(factors, scale * slope[0], stress[0], V);
        const double weight = mpm->bodies ? m / V * N * mpm->def.gravity[axis] : 0.0;
        return exchange_two(factors,
                            weight + scale * (slope[axis] * stress[axis] + slope[1 - axis] * stress[2]), V);
    }
    case TERM_LOAD:
        return exchange_two(factors, N, mpm_load_on(mpm, p));
    case TERM_STRAIN:
        return exchange_three(factors, mpm_strain_span(mpm), mpm_slope_scale(mpm, OP_STRAIN) * slope[axis],
                              mpm_straining_velocity(mpm, axis, p, node));
    case TERM_SHEAR:
        return exchange_two(factors, mpm_strain_span(mpm),
                            mpm_slope_scale(mpm, OP_STRAIN) *
                                (slope[1] * mpm_straining_velocity(mpm, 0, p, node) +
                                 slope[0] * mpm_straining_velocity(mpm, 1, p, node)));
    case TERM_VELOCITY:
        if (mpm->head->transfer != MPM_FLIP || mpm->head->flip_fraction == 0.0)
            return exchange_two(factors, N, mpm->carry[axis][node]);
        if (mpm->bodies || mpm->head->flip_fraction != 1.0)
            return exchange_two(factors, N, gain_of(mpm, axis, p, node, &w));
        if (mpm_does(mpm, WRONG_NEW_WEIGHTS)) {
            double new[SHAPE_SUPPORT_MAX];
            int first;
            mpm_kick_weights(mpm, p, &first, new);
            N = node >= first && node < first + mpm->support ? new[node - first] : 0.0;
        }
        return exchange_three(factors, mpm->dt, N, mpm->kick[axis][node] / mpm->dt);
    case TERM_PLACE: {
        if (mpm->head->transfer != MPM_FMPM)
            return exchange_three(factors, mpm->dt, N, mpm_moving_velocity(mpm, axis, p, node));
        /* the velocity before, no longer stored, is solved for from the way in this step */
        const double way = ((mpm->rest[0][p] - base + mpm->u[0][p] / mpm->dx) - mpm->s[0][p]) * mpm->dx;
        const double before = 2.0 * way / mpm->dt - mpm->v[0][p];
        return exchange_three(factors, mpm->dt, N, 0.5 * (before + mpm->carry[0][node]));
    }
    }
    return 0;
}

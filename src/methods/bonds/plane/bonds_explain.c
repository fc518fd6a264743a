/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stages as people read them, and the sum of the stage just done with its numbers. */
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_mistakes.h"
#include "methods/bonds/plane/verlet.h"
#include "methods/calculation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of beams on supports. */
static const Stage stage_table[N_STAGES] = {
    [STAGE_HALF_KICK] = VERLET_HALF_KICK("vx vy fx fy", "vx vy"),
    [STAGE_DRIFT] = VERLET_DRIFT("ux uy vx vy", "ux uy"),
    [STAGE_CONSTRAINTS] = {"constraints", "supports", "uy = 0 at the supports, ux = 0 at the left one",
                           "uy = 0 at the supports, ux = 0 at the left one", "eqs. 12, 13",
                           "Supported nodes stay where they are.", "ux uy vx vy held", "ux uy vx vy"},
    [STAGE_BONDS] =
        {"bonds", "bond forces",
         "s = (|ξ+η| − |ξ|)/|ξ|,   s ≥ s0: broken for ever\n"
         "f(i) = Σ c G w s V (ξ+η)/|ξ+η|",
         "s = (|xi+eta| - |xi|)/|xi|,   s >= s0: broken for ever\n"
         "f(i) = sum c G w s V (xi+eta)/|xi+eta|",
         "eqs. 2, 3, 6, 8",
         "Each bond pulls as much as it is stretched, or breaks; a node feels the sum of its family.",
         "ux uy", "fx fy stretch broken broken_at"},
    [STAGE_BODY_FORCE] = {"body-force", "body force", NULL, NULL, "eq. 8", NULL, "loaded fy",
                          "fy"}, /* by its terms */
    [STAGE_SECOND_KICK] = VERLET_SECOND_KICK(
        "The new force completes the step's velocity; supports hold again.", "vx vy fx fy held", "vx vy"),
    [STAGE_DAMAGE] = {"damage", "damage", "φ(i) = 1 − Σ μ w V / Σ w V", "phi(i) = 1 - sum mu w V / sum w V",
                      "eqs. 5, 6", "Damage of a node is the share of its family that it has lost.", "broken",
                      "damage"},
};

/* The kicks of the steppings other than velocity Verlet, before the drift and after it. */
typedef struct KickWords {
    const char *equation, *ascii, *sentence;
} KickWords;
static const KickWords no_kick = {"nothing", "nothing", "One kick a step is enough."};
static const KickWords kick_words[][2] = {
    [STEPPING_EULER] = {{"v(n+1) = v(n) + Δt a(n),   a = f/ρ", "v(n+1) = v(n) + dt a(n),   a = f/rho",
                         "The force of the last step gives every node its new velocity."}},
    [STEPPING_EULER_POSITION] = {{NULL},
                                 {"v(n+1) = v(n) + Δt a(n+1)", "v(n+1) = v(n) + dt a(n+1)",
                                  "The new force gives every node its new velocity."}},
    [STEPPING_LEAPFROG] = {{"v(n+½) = v(n−½) + Δt a(n),   in step 1: v(½) = v(0) + Δt/2 a(0)",
                            "v(n+1/2) = v(n-1/2) + dt a(n),   in step 1: v(1/2) = v(0) + dt/2 a(0)",
                            "The force of the last step carries the velocity from half step to half step."}},
    [STEPPING_LEAPFROG_AHEAD] = {{"in step 1 alone: v(½) = v(0) + Δt/2 a(0)",
                                  "in step 1 alone: v(1/2) = v(0) + dt/2 a(0)",
                                  "Before the first step a half kick sets the velocity half a step ahead."},
                                 {"v(n+3/2) = v(n+½) + Δt a(n+1)", "v(n+3/2) = v(n+1/2) + dt a(n+1)",
                                  "The new force carries the velocity from half step to half step."}},
};

void bonds_word_kicks(Stage *stages, Stepping stepping)
{
    for (int k = 0; k < 2 && stepping != STEPPING_VERLET; k++) {
        Stage *stage = &stages[k == 0 ? STAGE_HALF_KICK : STAGE_SECOND_KICK];
        const KickWords *words = kick_words[stepping][k].equation ? &kick_words[stepping][k] : &no_kick;
        stage->name = k == 0 ? "first kick" : "second kick";
        stage->equation = words->equation;
        stage->ascii = words->ascii;
        stage->sentence = words->sentence;
        stage->source = "in words";
    }
    if (stepping != STEPPING_VERLET) {
        stages[STAGE_DRIFT].equation = "u(n+1) = u(n) + Δt v";
        stages[STAGE_DRIFT].ascii = "u(n+1) = u(n) + dt v";
        stages[STAGE_DRIFT].sentence = "Every node moves on with the velocity that it has now.";
    }
}

void bonds_word_mistake(Stage *stages, const BondsMistake *mistake)
{
    for (int k = 0; mistake && k < MISTAKE_LINES && mistake->lines[k].equation; k++) {
        Stage *stage = &stages[mistake->lines[k].stage];
        stage->equation = mistake->lines[k].equation;
        stage->ascii = mistake->lines[k].ascii;
        stage->source = mistake->id;
        stage->sentence = mistake->sentence;
    }
}

void beam_set_stages(Beam *beam)
{
    memcpy(beam->stages, stage_table, sizeof beam->stages);
    if (beam->def.problem == BEAM_MOVING_CANTILEVER) {
        Stage *constraints = &beam->stages[STAGE_CONSTRAINTS];
        constraints->name = "clamp";
        constraints->equation = "in the channel uy = 0, with a full clamp ux = v0t";
        constraints->ascii = "in the channel uy = 0, with a full clamp ux = v0 t";
        constraints->source = "in words";
        constraints->sentence = "The channel guides the nodes inside it.";
        beam->stages[STAGE_SECOND_KICK].sentence =
            "The new force completes the step's velocity; the clamp holds again.";
    }
    if (beam->def.problem == BEAM_NOTCHED) {
        Stage *constraints = &beam->stages[STAGE_CONSTRAINTS];
        constraints->source = "in words";
        if (!beam->def.pinned)
            constraints->equation = constraints->ascii = "uy = 0 at the supports, ux is free";
    }
    if (beam->def.problem == BEAM_PLATE) {
        Stage *constraints = &beam->stages[STAGE_CONSTRAINTS], *force = &beam->stages[STAGE_BODY_FORCE];
        constraints->equation = "v = V in the directions that a support gives; V = 0 holds";
        constraints->ascii = constraints->equation;
        constraints->source = "in words";
        constraints->sentence = "Supports keep their velocity, whatever the bonds pull.";
        force->reads = "loaded fx fy";
        force->writes = "fx fy";
    }
    if (beam->damping > 0) {
        Stage *first = &beam->stages[STAGE_HALF_KICK], *second = &beam->stages[STAGE_SECOND_KICK];
        first->equation = "v(n+½) = (1 − α Δt/2) v(n) + Δt/2 f/ρ";
        first->ascii = "v(n+1/2) = (1 - alpha dt/2) v(n) + dt/2 f/rho";
        first->sentence = "The last force adds half a step's worth of velocity, and damping takes its share.";
        second->equation = "v(n+1) = (v(n+½) + Δt/2 f/ρ)/(1 + α Δt/2)";
        second->ascii = "v(n+1) = (v(n+1/2) + dt/2 f/rho)/(1 + alpha dt/2)";
        if (beam->def.problem == BEAM_MOVING_CANTILEVER)
            first->sentence =
                "The last force adds half a step's worth of velocity, and damping takes its share: of "
                "vx what differs from v0.";
    }
    bonds_word_kicks(beam->stages, beam->def.stepping);
    if (beam->n_loads == 0)
        beam->stages[STAGE_BODY_FORCE].reads = "fy";
    const ForceTerms forces = beam_terms(beam);
    forces_word_stage(&forces, &beam->force_words, &beam->stages[STAGE_BODY_FORCE]);
    bonds_word_mistake(beam->stages, beam->def.conceals_mistake ? NULL : bonds_mistake(beam));
    beam->sim.stages = beam->stages;
    beam->sim.n_stages = N_STAGES;
}

/* A node, now and before the stage. */
typedef struct NodeNow {
    size_t at; /* in padded arrays */
    double ux, uy, vx, vy, fx, fy;
} NodeNow;

static NodeNow node_now(const Beam *beam, size_t index)
{
    size_t nx = (size_t)beam->lattice.nx;
    size_t at = lattice_at(&beam->lattice, (int)(index % nx), (int)(index / nx));
    const NodeArrays *nodes = &beam->nodes;
    return (NodeNow){at,           nodes->ux[at], nodes->uy[at], nodes->vx[at], nodes->vy[at], nodes->fx[at],
                     nodes->fy[at]};
}

/* The same numbers as they were before the stage, from the saved state: six arrays, one behind the other. */
static NodeNow node_before(const Beam *beam, size_t at, const void *before)
{
    double value[6];
    for (size_t k = 0; k < 6; k++)
        value[k] = calculation_before(beam->state, beam->nodes.ux + k * beam->array + at, before);
    return (NodeNow){at, value[0], value[1], value[2], value[3], value[4], value[5]};
}

/* "vx = 0.1 + 2e-11 × 5 = 0.2 m/s" */
static void write_change(Calculation *calculation, const char *label, double was, double factor, double rate,
                         double now, const char *unit)
{
    if (fabs(was + factor * rate - now) > 1e-9 * fmax(fabs(was), fabs(factor * rate))) {
        calculation_number(calculation, label, now);
        calculation_write(calculation, " %s: the node is held\n", unit);
        return;
    }
    calculation_change(calculation, label, was, factor, rate, now, unit);
}

static void write_pair(Calculation *calculation, const char *words, double x, double y, const char *unit)
{
    calculation_number(calculation, words, x);
    calculation_number(calculation, ", ", y);
    calculation_write(calculation, " %s\n", unit);
}

/* The same with damping, both halves as v = v + h (f/rho - alpha v): h = dt/2 in the first, that over 1 +
 * alpha dt/2 in the second. */
static void explain_damped(const Beam *beam, Calculation *calculation, bool second, const NodeNow *now,
                           const NodeNow *was)
{
    const double half = beam->sim.dt / 2, alpha = beam->damping, density = beam->def.density;
    const double factor = second ? half / (1 + alpha * half) : half;
    const double ahead = beam->def.problem == BEAM_MOVING_CANTILEVER ? beam->def.speed : 0;
    const char *along =
        second ? "vx = vx + Δt/2/(1 + α Δt/2) (fx/ρ − α vx) = " : "vx = vx + Δt/2 (fx/ρ − α vx) = ";
    if (beam->def.problem == BEAM_MOVING_CANTILEVER)
        along = second ? "vx = vx + Δt/2/(1 + α Δt/2) (fx/ρ − α (vx − v0)) = "
                       : "vx = vx + Δt/2 (fx/ρ − α (vx − v0)) = ";
    write_change(calculation, along, was->vx, factor, was->fx / density - alpha * (was->vx - ahead), now->vx,
                 "m/s");
    write_change(calculation,
                 second ? "vy = vy + Δt/2/(1 + α Δt/2) (fy/ρ − α vy) = " : "vy = vy + Δt/2 (fy/ρ − α vy) = ",
                 was->vy, factor, was->fy / density - alpha * was->vy, now->vy, "m/s");
}

/* Eqs. 9 and 11, each half of a step, or a whole kick: v = v + dt/(2 rho) f, from the velocity before the
 * stage. */
static void explain_kick(const Beam *beam, Calculation *calculation, bool second, const NodeNow *now,
                         const NodeNow *was)
{
    const double share = bonds_kick_share(beam->def.stepping, bonds_mistake(beam), second, beam->sim.step);
    const double factor = share * beam->sim.dt / beam->def.density;
    if (share == 0) {
        write_pair(calculation, "vx, vy stay ", now->vx, now->vy, "m/s");
    } else if (was && beam->damping > 0) {
        explain_damped(beam, calculation, second, now, was);
    } else if (was) {
        write_change(calculation, share == 1 ? "vx = vx + Δt/ρ fx = " : "vx = vx + Δt/(2ρ) fx = ", was->vx,
                     factor, was->fx, now->vx, "m/s");
        write_change(calculation, share == 1 ? "vy = vy + Δt/ρ fy = " : "vy = vy + Δt/(2ρ) fy = ", was->vy,
                     factor, was->fy, now->vy, "m/s");
    } else {
        write_pair(calculation, "vx, vy = ", now->vx, now->vy, "m/s");
    }
}

/* Eq. 10: u = u + dt v. */
static void explain_drift(const Beam *beam, Calculation *calculation, const NodeNow *now, const NodeNow *was)
{
    const double kick = beam->sim.dt / beam->def.density;
    const bool twice = bonds_does(beam, BONDS_WRONG_DRIFTS_TWICE);
    const double dt = twice ? 2 * beam->sim.dt : beam->sim.dt;
    if (was) {
        write_change(calculation, twice ? "ux = ux + 2 Δt vx = " : "ux = ux + Δt vx = ", was->ux, dt, was->vx,
                     now->ux, "m");
        write_change(calculation, twice ? "uy = uy + 2 Δt vy = " : "uy = uy + Δt vy = ", was->uy, dt, was->vy,
                     now->uy, "m");
        if (bonds_does(beam, BONDS_WRONG_KICKS_LATE)) {
            write_change(calculation, "vx = vx + Δt/ρ fx = ", was->vx, kick, was->fx, now->vx, "m/s");
            write_change(calculation, "vy = vy + Δt/ρ fy = ", was->vy, kick, was->fy, now->vy, "m/s");
        }
    } else {
        write_pair(calculation, "ux, uy = ", now->ux, now->uy, "m");
    }
}

/* Eqs. 12, 13, or the channel: which components are given, at the time that the step ends. */
static void explain_constraints(const Beam *beam, Calculation *calculation, size_t index, const NodeNow *now)
{
    size_t nx = (size_t)beam->lattice.nx;
    double time = (double)(beam->sim.step + 1) * beam->sim.dt;
    if ((int)(index % nx) < beam_held_columns(beam, time)) {
        if (beam->def.clamp == CLAMP_FULL)
            calculation_number(calculation, "in the channel: uy = 0, ux = v0 t = ", now->ux);
        else
            calculation_number(calculation, "in the channel: uy = 0, free to slide: ux = ", now->ux);
        calculation_write(calculation, " m\n");
        return;
    }
    for (const Support *s = beam->supports; s < beam->supports + beam->n_supports; s++)
        if (patch_has(&s->patch, (int)(index % nx), (int)(index / nx))) {
            if (s->vx != 0 || s->vy != 0)
                write_pair(calculation, "moved by a support: vx, vy = ", now->vx, now->vy, "m/s");
            else
                calculation_write(calculation, "at a support: %s\n",
                                  s->x && s->y ? "ux = uy = 0"
                                  : s->x       ? "ux = 0"
                                               : "uy = 0");
            return;
        }
    calculation_write(calculation, "free: nothing holds this node\n");
}

static int by_pull(const void *a, const void *b)
{
    const double one = fabs(((const BondNow *)a)->pull), other = fabs(((const BondNow *)b)->pull);
    return (one < other) - (one > other);
}

/* How many bonds of a family are broken, and how many of these the notch cut. */
static void write_lost(const Beam *beam, Calculation *calculation, const BondPlace *family, size_t n)
{
    size_t broken = 0, cut = 0;
    for (size_t k = 0; k < n; k++) {
        const size_t slot = lattice_slot(&beam->lattice, family[k]);
        if (beam_bit(beam->notched, slot))
            cut++;
        else
            broken += beam_bit(beam->broken, slot);
    }
    calculation_write(calculation, "%zu of %zu bonds broken", broken, n);
    if (cut > 0)
        calculation_write(calculation, ", %zu cut%s", cut,
                          beam->def.problem == BEAM_NOTCHED ? " by the notch" : " from the start");
}

/* The strongest bonds first, the rest as one number. */
static void explain_bonds(const Beam *beam, Calculation *calculation, size_t index, const NodeNow *now)
{
    size_t nx = (size_t)beam->lattice.nx;
    BondPlace family[FAMILY_MAX];
    BondNow bonds[FAMILY_MAX];
    size_t n = beam_family(beam, (int)(index % nx), (int)(index / nx), family);
    CalculationSum sums[2] = {{.label = "fx = ", .unit = "N/m³"}, {.label = "fy = ", .unit = "N/m³"}};
    for (size_t k = 0; k < n; k++) {
        bonds[k] = bonds_seen_from(beam, family[k], index);
    }
    qsort(bonds, n, sizeof *bonds, by_pull);
    write_lost(beam, calculation, family, n);
    if (n > 0 && bonds[0].stretch != 0) {
        const BondNow *first = &bonds[0];
        calculation_write(calculation, "; to %zu: ", first->b);
        CalculationSum pull = {.label = "c G w V s = ", .result = first->pull};
        calculation_add(&pull, 2, first->pull / first->stretch, first->stretch, 0);
        calculation_sum(calculation, &pull);
    } else {
        calculation_write(calculation, "; none is stretched\n");
    }
    for (size_t k = 0; k < n; k++) {
        const double parts[2] = {bonds[k].direction_x, bonds[k].direction_y};
        for (int d = 0; d < 2; d++) {
            if (bonds[k].pull == 0)
                continue;
            sums[d].result += bonds[k].pull * parts[d];
            calculation_add(&sums[d], 2, bonds[k].pull, parts[d], 0);
        }
    }
    const double f[2] = {now->fx, now->fy};
    for (int d = 0; d < 2; d++) {
        if (bonds_does(beam, BONDS_WRONG_FORCE_STAYS)) {
            sums[d].has_base = true;
            sums[d].base = f[d] - sums[d].result;
            sums[d].result = f[d];
        }
        calculation_sum(calculation, &sums[d]);
    }
}

/* The terms of eq. 8's b that act on the node; what the bonds had left in f is solved for. */
static void explain_body_force(const Beam *beam, Calculation *calculation, size_t index, const NodeNow *now)
{
    const ForceTerms forces = beam_terms(beam);
    const double f[2] = {now->fx, now->fy};
    bool loaded = false;
    for (int d = 0; d < 2; d++) {
        CalculationSum sum = {.label = d == 0 ? "fx = fx + b = " : "fy = fy + b = ",
                              .has_base = true,
                              .base = f[d] - forces_on(&forces, &beam->sim, index, d),
                              .result = f[d],
                              .unit = "N/m³"};
        for (int k = 0; k < forces.count; k++) {
            const double force = forces.terms[k]->on(&beam->sim, index, d, forces.terms[k]->context);
            if (force != 0)
                calculation_add(&sum, 1, force, 0, 0);
        }
        if (sum.count > 0)
            calculation_sum(calculation, &sum);
        loaded = loaded || sum.count > 0;
    }
    if (!loaded)
        write_pair(calculation, "no load on this node: f stays ", now->fx, now->fy, "N/m³");
}

/* Eq. 5 by weights w, all areas being equal: broken over all. */
static void explain_damage(const Beam *beam, Calculation *calculation, size_t index)
{
    size_t nx = (size_t)beam->lattice.nx;
    BondPlace family[FAMILY_MAX];
    size_t n = beam_family(beam, (int)(index % nx), (int)(index / nx), family);
    double all = 0, broken = 0;
    for (size_t k = 0; k < n; k++) {
        double weight = beam->lattice.offsets[family[k].offset].weight;
        bool gone = beam_bit(beam->broken, lattice_slot(&beam->lattice, family[k]));
        all += weight;
        broken += gone ? weight : 0;
    }
    write_lost(beam, calculation, family, n);
    calculation_number(calculation, "; in weights ", broken);
    calculation_value(calculation, " of ", all);
    CalculationSum sum = {.label = "φ = ", .result = beam->damage[index]};
    calculation_add(&sum, 1, broken, 0, 0)->divisor = all;
    calculation_sum(calculation, &sum);
}

/* One bond by eqs. 3 and 8: stretch against s0, pull, energy. */
static void explain_bond(const Beam *beam, Calculation *calculation, size_t index)
{
    BondNow bond = beam_bond(beam, lattice_bond_place(&beam->lattice, index));
    calculation_write(calculation, "bond %zu to %zu: ", bond.a, bond.b);
    calculation_number(calculation, "s = ", bond.stretch);
    if (beam->head->critical_stretch > 0)
        calculation_number(calculation, " of s0 = ", beam->head->critical_stretch);
    if (bond.broken) {
        calculation_write(calculation, "; broken: it carries nothing\n");
        return;
    }
    calculation_number(calculation, ", pull ", bond.pull);
    calculation_number(calculation, " N/m³, energy ", bond.energy);
    calculation_write(calculation, " J\n");
}

void beam_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, int terms,
                  char *out, size_t size)
{
    ASSERT_INDEX(stage, N_STAGES);
    ASSERT_INDEX(index, sim->counts[set]);
    const Beam *beam = (const Beam *)sim;
    Calculation text;
    calculation_open(&text, out, size, terms);
    if (set == SET_BOND) {
        explain_bond(beam, &text, index);
        return;
    }
    NodeNow now = node_now(beam, index), earlier, *was = NULL;
    if (before) {
        earlier = node_before(beam, now.at, before);
        was = &earlier;
    }
    switch (stage) {
    case STAGE_HALF_KICK:
    case STAGE_SECOND_KICK:
        explain_kick(beam, &text, stage == STAGE_SECOND_KICK, &now, was);
        break;
    case STAGE_DRIFT:
        explain_drift(beam, &text, &now, was);
        break;
    case STAGE_CONSTRAINTS:
        explain_constraints(beam, &text, index, &now);
        break;
    case STAGE_BONDS:
        explain_bonds(beam, &text, index, &now);
        break;
    case STAGE_BODY_FORCE:
        explain_body_force(beam, &text, index, &now);
        break;
    default:
        explain_damage(beam, &text, index);
    }
}

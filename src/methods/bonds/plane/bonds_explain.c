/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stages as people read them, and the sum of the stage just done with its numbers. */
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_mistakes.h"
#include "methods/calculation.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Velocity Verlet (paper P, eqs. 9 to 11), with the fields that it reads and writes. */
#define VERLET_HALF_KICK(fields_read, fields_written)                                                        \
    {                                                                                                        \
        "half-kick", "half kick", "v(n+½) = v(n) + Δt/2 a(n),   a = f/ρ", "eq. 9",                           \
            "The force of the last step changes the velocity of each node over half a step.", fields_read,   \
            fields_written                                                                                   \
    }

#define VERLET_DRIFT(fields_read, fields_written)                                                            \
    {                                                                                                        \
        "drift", "drift", "u(n+1) = u(n) + Δt v(n+½)", "eq. 10",                                             \
            "Each node moves with its half-step velocity.", fields_read, fields_written                      \
    }

#define VERLET_SECOND_KICK(says, fields_read, fields_written)                                                \
    {                                                                                                        \
        "second-kick", "second half kick", "v(n+1) = v(n+½) + Δt/2 a(n+1)", "eq. 11", says, fields_read,     \
            fields_written                                                                                   \
    }

/* Of beams on supports. */
static const Stage stage_table[N_STAGES] = {
    [STAGE_HALF_KICK] = VERLET_HALF_KICK("vx vy fx fy", "vx vy"),
    [STAGE_DRIFT] = VERLET_DRIFT("ux uy vx vy", "ux uy"),
    [STAGE_CONSTRAINTS] = {"constraints", "supports", "uy = 0 at the supports, ux = 0 at the left one",
                           "eqs. 12, 13", "Supported nodes stay where they are.", "ux uy vx vy held",
                           "ux uy vx vy"},
    [STAGE_BONDS] = {"bonds", "bond forces",
                     "s = (|ξ+η| − |ξ|)/|ξ|,   s ≥ s0: broken\n"
                     "f(i) = Σ c G w s V (ξ+η)/|ξ+η|",
                     "eqs. 2, 3, 6, 8",
                     "The force of a bond is in proportion to its stretch until it breaks; the force on a "
                     "node is the sum over its family.",
                     "ux uy", "fx fy stretch broken broken_at"},
    [STAGE_BODY_FORCE] = {"body-force", "body force", NULL, "eq. 8", NULL, "loaded fy",
                          "fy"}, /* by its terms */
    [STAGE_SECOND_KICK] =
        VERLET_SECOND_KICK("The new force completes the velocity of the step; supports hold again.",
                           "vx vy fx fy held", "vx vy"),
    [STAGE_DAMAGE] = {"damage", "damage", "φ(i) = 1 − Σ μ w V / Σ w V", "eqs. 5, 6",
                      "The damage of a node is the fraction of its bonds that are broken.", "broken",
                      "damage"},
};

/* Of a bar; nothing of it breaks. */
static const Stage line_stages[STAGE_DAMAGE] = {
    [STAGE_HALF_KICK] = VERLET_HALF_KICK("v force acceleration", "v"),
    [STAGE_DRIFT] = VERLET_DRIFT("u v", "u x"),
    [STAGE_CONSTRAINTS] =
        {"mirror", "mirrored ends", "fixed end at 0:  u(−X) = −u(X),   so u(0) = 0", "odd reflection",
         "Beyond a fixed end lies a mirror image of the bar; beyond a free end there is nothing.", "u", "u"},
    [STAGE_BONDS] = {"bonds", "bond forces",
                     "s = (|ξ+η| − |ξ|)/|ξ|,   c = c(|ξ|)\n"
                     "f(i) = Σ c G w s V sign(ξ+η)",
                     "eqs. 2, 3, 8",
                     "The force of a bond is in proportion to its stretch; the force on a node is the sum "
                     "over its family.",
                     "u family surface_factor", "force stress strain density strain_energy"},
    [STAGE_BODY_FORCE] = {"load", "loads", NULL, "eq. 8", NULL, "load force", "force"}, /* by its terms */
    [STAGE_SECOND_KICK] =
        VERLET_SECOND_KICK("The new force completes the velocity of the step.", "v force acceleration", "v"),
};

/* The kicks of the steppings other than velocity Verlet, before the drift and after it. */
typedef struct KickWords {
    const char *equation, *sentence;
} KickWords;
static const KickWords no_kick = {"nothing", "One kick a step is enough."};
static const KickWords kick_words[][2] = {
    [STEPPING_EULER] = {{"v(n+1) = v(n) + Δt a(n),   a = f/ρ",
                         "The force of the last step gives every node its new velocity."}},
    [STEPPING_EULER_POSITION] = {{NULL, NULL},
                                 {"v(n+1) = v(n) + Δt a(n+1)",
                                  "The new force gives every node its new velocity."}},
    [STEPPING_LEAPFROG] = {{"v(n+½) = v(n−½) + Δt a(n),   in step 1: v(½) = v(0) + Δt/2 a(0)",
                            "The force of the last step carries the velocity from half step to half step."}},
    [STEPPING_LEAPFROG_AHEAD] = {{"in step 1 alone: v(½) = v(0) + Δt/2 a(0)",
                                  "Before the first step a half kick sets the velocity half a step ahead."},
                                 {"v(n+3/2) = v(n+½) + Δt a(n+1)",
                                  "The new force carries the velocity from half step to half step."}},
};

/* What bonds give their ends, along a line and in the plane. */
#define BONDS_GIVE(field, factors)                                                                           \
    {                                                                                                        \
        "bonds", SET_PARTICLE, SET_PARTICLE, field, false, factors, "p = c G w V s"                          \
    }
static const Exchange exchange_table[] = {BONDS_GIVE("force", "p n"), BONDS_GIVE("fx", "p nx"),
                                          BONDS_GIVE("fy", "p ny")};

/* NULL: as it is. */
static void reword(Stage *stage, const char *equation, const char *source, const char *sentence)
{
    stage->equation = equation ? equation : stage->equation;
    stage->source = source ? source : stage->source;
    stage->sentence = sentence ? sentence : stage->sentence;
}

static void word_kicks(Stage *stages, Stepping stepping)
{
    for (int k = 0; k < 2 && stepping != STEPPING_VERLET; k++) {
        Stage *stage = &stages[k == 0 ? STAGE_HALF_KICK : STAGE_SECOND_KICK];
        const KickWords *words = kick_words[stepping][k].equation ? &kick_words[stepping][k] : &no_kick;
        stage->name = k == 0 ? "first kick" : "second kick";
        reword(stage, words->equation, "in words", words->sentence);
    }
    if (stepping != STEPPING_VERLET)
        reword(&stages[STAGE_DRIFT], "u(n+1) = u(n) + Δt v", NULL,
               "Each node moves with its present velocity.");
}

static void word_mistake(Stage *stages, const BondsMistake *mistake)
{
    for (int k = 0; mistake && k < MISTAKE_LINES && mistake->lines[k].equation; k++)
        reword(&stages[mistake->lines[k].stage], mistake->lines[k].equation, mistake->id, mistake->sentence);
}

void beam_set_stages(Beam *beam)
{
    if (beam->lattice.line)
        memcpy(beam->stages, line_stages, sizeof line_stages);
    else
        memcpy(beam->stages, stage_table, sizeof stage_table);
    Stage *const first = &beam->stages[STAGE_HALF_KICK], *const second = &beam->stages[STAGE_SECOND_KICK],
                 *const constraints = &beam->stages[STAGE_CONSTRAINTS],
                 *const force = &beam->stages[STAGE_BODY_FORCE];
    const bool moving = beam->def.problem == BEAM_MOVING_CANTILEVER;
    if (moving) {
        constraints->name = "clamp";
        reword(constraints, "in the channel uy = 0, with a full clamp ux = v0t", "in words",
               "The channel guides the nodes inside it.");
        second->sentence = "The new force completes the step's velocity; the clamp holds again.";
    }
    if (beam->def.problem == BEAM_NOTCHED)
        reword(constraints, beam->def.pinned ? NULL : "uy = 0 at the supports, ux is free", "in words", NULL);
    if (beam->def.problem == BEAM_PLATE) {
        reword(constraints, "v = V in the directions that a support gives; V = 0 holds", "in words",
               "Supports keep their velocity, whatever the bonds pull.");
        force->reads = "loaded fx fy";
        force->writes = "fx fy";
    }
    if (beam->damping > 0) {
        reword(first, "v(n+½) = (1 − α Δt/2) v(n) + Δt/2 f/ρ", NULL,
               moving
                   ? "The last force adds half a step's worth of velocity, and damping takes its share: of "
                     "vx what differs from v0."
                   : "The last force adds half a step's worth of velocity, and damping takes its share.");
        second->equation = "v(n+1) = (v(n+½) + Δt/2 f/ρ)/(1 + α Δt/2)";
    }
    word_kicks(beam->stages, beam->def.stepping);
    if (beam->n_loads == 0 && !beam->lattice.line)
        force->reads = "fy";
    const ForceTerms forces = beam_terms(beam);
    forces_word_stage(&forces, &beam->force_words, force);
    word_mistake(beam->stages, beam->def.conceals_mistake ? NULL : bonds_mistake(beam));
    beam->sim.stages = beam->stages;
    beam->sim.n_stages = beam->lattice.line ? STAGE_DAMAGE : N_STAGES;
    beam->sim.exchanges = beam->exchanges;
    beam->sim.n_exchanges = beam->lattice.line ? 1 : 2;
    for (int d = 0; d < beam->sim.n_exchanges; d++) {
        beam->exchanges[d] = exchange_table[beam->lattice.line ? 0 : 1 + d];
        beam->exchanges[d].adds = bonds_does(beam, BONDS_WRONG_FORCE_STAYS);
    }
}

/* A node, now and before the stage. */
typedef struct NodeNow {
    double u[2], v[2], f[2];
} NodeNow;

/* Its six numbers of the state, six arrays one behind the other; `before` as in the saved state, or NULL. */
static NodeNow node_at(const Beam *beam, size_t index, const void *before)
{
    const Lattice *lattice = &beam->lattice;
    const size_t at = lattice_at(lattice, lattice_column(lattice, index), lattice_row(lattice, index));
    NodeNow node;
    double *const values[3] = {node.u, node.v, node.f};
    for (size_t k = 0; k < 6; k++) {
        const double *now = beam->nodes.ux + k * beam->array + at;
        values[k / 2][k % 2] = before ? calculation_before(beam->state, now, before) : *now;
    }
    return node;
}

/* A form of words in a direction: of "v@" vx, vy or, along a bar, v. */
typedef struct Label {
    char text[120];
} Label;

static Label label(const Beam *beam, const char *form, int axis)
{
    Label out = {""};
    for (size_t used = 0; *form && used + 1 < sizeof out.text; form++)
        if (*form != '@')
            out.text[used++] = *form;
        else if (!beam->lattice.line)
            out.text[used++] = axis ? 'y' : 'x';
    return out;
}

/* The units of a bar are anybody's. */
static const char *unit_of(const Beam *beam, const char *unit)
{
    return beam->lattice.line ? NULL : unit;
}

/* "vx = 0.1 + 2e-11 × 5 = 0.2 m/s" */
static void write_change(const Beam *beam, Calculation *calculation, Label label, double was, double factor,
                         double rate, double now, const char *unit)
{
    if (fabs(was + factor * rate - now) > 1e-9 * fmax(fabs(was), fabs(factor * rate))) {
        calculation_number(calculation, label.text, now);
        calculation_write(calculation, "%s%s: the node is held\n", beam->lattice.line ? "" : " ",
                          beam->lattice.line ? "" : unit);
        return;
    }
    calculation_change(calculation, label.text, was, factor, rate, now, unit_of(beam, unit));
}

/* "vx, vy = 0.1, 0.2 m/s", along a bar "v = 0.1". */
static void write_vector(const Beam *beam, Calculation *calculation, const char *words, const char *along,
                         const double value[2], const char *unit)
{
    if (beam->lattice.line) {
        calculation_value(calculation, along, value[0]);
        return;
    }
    calculation_number(calculation, words, value[0]);
    calculation_number(calculation, ", ", value[1]);
    calculation_write(calculation, " %s\n", unit);
}

/* Eqs. 9 and 11, each half of a step, or a whole kick: v = v + dt/(2 rho) f, from the velocity before the
 * stage. With damping both halves as v = v + h (f/rho - alpha v): h = dt/2 in the first, that over 1 + alpha
 * dt/2 in the second. */
static void explain_kick(const Beam *beam, Calculation *calculation, bool second, const NodeNow *now,
                         const NodeNow *was)
{
    const double share = bonds_kick_share(beam->def.stepping, bonds_mistake(beam), second, beam->sim.step);
    const double density = beam->def.density, half = beam->sim.dt / 2, alpha = beam->damping;
    if (share == 0)
        write_vector(beam, calculation, "vx, vy stay ", "v stays ", now->v, "m/s");
    else if (!was)
        write_vector(beam, calculation, "vx, vy = ", "v = ", now->v, "m/s");
    for (int d = 0; share != 0 && was && d < beam->sim.dimensions; d++) {
        const bool moving = d == 0 && beam->def.problem == BEAM_MOVING_CANTILEVER;
        const char *form = share == 1 ? "v@ = v@ + Δt/ρ f@ = " : "v@ = v@ + Δt/(2ρ) f@ = ";
        double factor = share * beam->sim.dt / density, rate = was->f[d];
        if (alpha > 0) {
            factor = second ? half / (1 + alpha * half) : half;
            rate = was->f[d] / density - alpha * (was->v[d] - (moving ? beam->def.speed : 0));
            form = moving   ? second ? "v@ = v@ + Δt/2/(1 + α Δt/2) (f@/ρ − α (v@ − v0)) = "
                                     : "v@ = v@ + Δt/2 (f@/ρ − α (v@ − v0)) = "
                   : second ? "v@ = v@ + Δt/2/(1 + α Δt/2) (f@/ρ − α v@) = "
                            : "v@ = v@ + Δt/2 (f@/ρ − α v@) = ";
        }
        write_change(beam, calculation, label(beam, form, d), was->v[d], factor, rate, now->v[d], "m/s");
    }
}

/* Eq. 10: u = u + dt v. */
static void explain_drift(const Beam *beam, Calculation *calculation, const NodeNow *now, const NodeNow *was)
{
    const bool twice = bonds_does(beam, BONDS_WRONG_DRIFTS_TWICE),
               late = bonds_does(beam, BONDS_WRONG_KICKS_LATE);
    const double dt = twice ? 2 * beam->sim.dt : beam->sim.dt, kick = beam->sim.dt / beam->def.density;
    if (!was)
        write_vector(beam, calculation, "ux, uy = ", "u = ", now->u, "m");
    for (int d = 0; was && d < beam->sim.dimensions; d++)
        write_change(beam, calculation, label(beam, twice ? "u@ = u@ + 2 Δt v@ = " : "u@ = u@ + Δt v@ = ", d),
                     was->u[d], dt, was->v[d], now->u[d], "m");
    for (int d = 0; was && late && d < beam->sim.dimensions; d++)
        write_change(beam, calculation, label(beam, "v@ = v@ + Δt/ρ f@ = ", d), was->v[d], kick, was->f[d],
                     now->v[d], "m/s");
}

/* At a bar's fixed ends: where the image of a node lies, and how it moves. */
static void explain_mirror(const Beam *beam, Calculation *calculation, size_t index, const NodeNow *now)
{
    const Lattice *lattice = &beam->lattice;
    const size_t nodes = lattice_nodes(lattice), from_end[2] = {index, nodes - 1 - index};
    const double place = lattice_x(lattice, lattice_column(lattice, index));
    bool any = false;
    for (int side = 0; side < 2; side++)
        if (from_end[side] < (size_t)lattice->images[side]) {
            calculation_number(calculation,
                               "the mirror image at X = ", side ? 2 * beam->def.length - place : -place);
            calculation_value(calculation, " moves by ", -now->u[0]);
            any = true;
        }
    if (!any)
        calculation_write(calculation,
                          "no fixed end within the horizon: this node has no mirror image that matters\n");
}

/* Eqs. 12, 13, or the channel: which components are given, at the time that the step ends. */
static void explain_constraints(const Beam *beam, Calculation *calculation, size_t index, const NodeNow *now)
{
    const int i = lattice_column(&beam->lattice, index), j = lattice_row(&beam->lattice, index);
    if (beam->lattice.line) {
        explain_mirror(beam, calculation, index, now);
        return;
    }
    if (i < beam_held_columns(beam, (double)(beam->sim.step + 1) * beam->sim.dt)) {
        calculation_number(calculation,
                           beam->def.clamp == CLAMP_FULL ? "in the channel: uy = 0, ux = v0 t = "
                                                         : "in the channel: uy = 0, free to slide: ux = ",
                           now->u[0]);
        calculation_write(calculation, " m\n");
        return;
    }
    for (const Support *s = beam->supports; s < beam->supports + beam->n_supports; s++)
        if (patch_has(&s->patch, i, j)) {
            if (s->vx != 0 || s->vy != 0)
                write_vector(beam, calculation, "moved by a support: vx, vy = ", NULL, now->v, "m/s");
            else
                calculation_write(calculation, "at a support: %s\n",
                                  s->x && s->y ? "ux = uy = 0"
                                  : s->x       ? "ux = 0"
                                               : "uy = 0");
            return;
        }
    calculation_write(calculation, "free: nothing holds this node\n");
}

/* How many bonds of a family are broken, and how many of these the notch cut. */
static void write_lost(const Beam *beam, Calculation *calculation, const Link *family, size_t n)
{
    size_t broken = 0, cut = 0;
    for (const Link *link = family; link < family + n; link++) {
        broken += link->broken && link->broken_at > 0;
        cut += link->broken && link->broken_at == 0;
    }
    calculation_write(calculation, "%zu of %zu bonds broken", broken, n);
    if (cut > 0)
        calculation_write(calculation, ", %zu cut%s", cut,
                          beam->def.problem == BEAM_NOTCHED ? " by the notch" : " from the start");
    calculation_write(calculation, "; ");
}

/* The pull of the strongest bond, and the sums of the table of exchanges. */
static void explain_bonds(const Beam *beam, Calculation *calculation, Link *family, size_t n, size_t index)
{
    const Simulation *sim = &beam->sim;
    const char *pull = strchr(sim->exchanges[0].note, '=') + 2;
    size_t whole = 0;
    simulation_sort_links(family, n);
    while (whole < n && !family[whole].broken)
        whole++;
    if (!beam->lattice.line)
        write_lost(beam, calculation, family, n);
    if (whole > 0) {
        char words[64];
        snprintf(words, sizeof words, "to %s%zu: %s = ", family->mirrored ? "the mirror of " : "",
                 family->index, pull);
        CalculationSum sum = {.label = words, .result = link_pull(family)};
        calculation_add(&sum, 2, family->stiffness, family->stretch, 0);
        calculation_sum(calculation, &sum);
    }
    for (int d = 0; d < sim->n_exchanges; d++) {
        const Label words = label(beam, "f@ = ", d);
        CalculationSum sum = {.label = words.text, .unit = unit_of(beam, "N/m³")};
        calculation_exchange(calculation, &sum, sim, d, index, family, whole);
    }
}

/* The terms of eq. 8's b that act on the node; what the bonds had left in f is solved for. */
static void explain_body_force(const Beam *beam, Calculation *calculation, size_t index, const NodeNow *now)
{
    const ForceTerms forces = beam_terms(beam);
    bool loaded = false;
    for (int d = 0; d < beam->sim.dimensions; d++) {
        const Label words = label(beam, "f@ = f@ + b = ", d);
        CalculationSum sum = {.label = words.text,
                              .has_base = true,
                              .base = now->f[d] - forces_on(&forces, &beam->sim, index, d),
                              .result = now->f[d],
                              .unit = unit_of(beam, "N/m³")};
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
        write_vector(beam, calculation, "no load on this node: f stays ", "no load on this node: f stays ",
                     now->f, "N/m³");
}

/* Eq. 5 by weights w, all areas being equal: broken over all. */
static void explain_damage(const Beam *beam, Calculation *calculation, const Link *family, size_t n,
                           size_t index)
{
    double broken;
    const double all = beam_family_weight(beam, index, LONG_MAX, &broken);
    write_lost(beam, calculation, family, n);
    calculation_number(calculation, "in weights ", broken);
    calculation_value(calculation, " of ", all);
    CalculationSum sum = {.label = "φ = ", .result = beam->damage[index]};
    calculation_add(&sum, 1, broken, 0, 0)->divisor = all;
    calculation_sum(calculation, &sum);
}

void beam_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, int terms,
                  char *out, size_t size)
{
    ASSERT_INDEX(stage, N_STAGES);
    ASSERT_INDEX(index, sim->counts[set]);
    const Beam *beam = (const Beam *)sim;
    Calculation text;
    calculation_open(&text, out, size, terms);
    Link family[FAMILY_MAX];
    const size_t n = beam_links(sim, set, index, family, FAMILY_MAX);
    const NodeNow now = node_at(beam, index, NULL), earlier = node_at(beam, index, before);
    const NodeNow *was = before ? &earlier : NULL;
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
        explain_bonds(beam, &text, family, n, index);
        break;
    case STAGE_BODY_FORCE:
        explain_body_force(beam, &text, index, &now);
        break;
    default:
        explain_damage(beam, &text, family, n, index);
    }
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stages as people read them, and the sum of the stage just done with its numbers. */
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_mistakes.h"
#include "methods/calculation.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* What a run is, as far as the words of its stages depend on it: one of each group. */
#define OF(problem)  (1u << (problem))
#define BY(stepping) (1u << (8 + (int)(stepping)))
#define IN_PLANE     (OF(BEAM_SIMPLY_SUPPORTED) | OF(BEAM_MOVING_CANTILEVER) | OF(BEAM_NOTCHED) | OF(BEAM_PLATE))
#define ONE_KICK                                                                                             \
    (BY(STEPPING_EULER) | BY(STEPPING_EULER_POSITION) | BY(STEPPING_LEAPFROG) | BY(STEPPING_LEAPFROG_AHEAD))
enum { DAMPED = 1 << 16, UNPINNED = 1 << 17, UNLOADED = 1 << 18 };
static const unsigned groups[] = {
    IN_PLANE | OF(BEAM_BAR), BY(STEPPING_VERLET) | ONE_KICK, DAMPED, UNPINNED, UNLOADED, 0};

/* The force of loads is worded by its terms. */
static const StageWords rows[] = {
    /* velocity Verlet (paper P, eqs. 9 to 11) of beams on supports */
    STAGE_WORDS(STAGE_HALF_KICK, 0, "half-kick", "half kick", "v(n+½) = v(n) + Δt/2 a(n),   a = f/ρ", "eq. 9",
                "The force of the last step changes the velocity of each node over half a step.",
                "vx vy fx fy", "vx vy"),
    STAGE_WORDS(STAGE_DRIFT, 0, "drift", "drift", "u(n+1) = u(n) + Δt v(n+½)", "eq. 10",
                "Each node moves with its half-step velocity.", "ux uy vx vy", "ux uy"),
    STAGE_WORDS(STAGE_CONSTRAINTS, 0, "constraints", "supports",
                "uy = 0 at the supports, ux = 0 at the left one", "eqs. 12, 13",
                "Supported nodes stay where they are.", "ux uy vx vy held", "ux uy vx vy"),
    STAGE_WORDS(STAGE_BONDS, 0, "bonds", "bond forces",
                "s = (|ξ+η| − |ξ|)/|ξ|,   s ≥ s0: broken\n"
                "f(i) = Σ c G w s V (ξ+η)/|ξ+η|",
                "eqs. 2, 3, 6, 8",
                "The force of a bond is in proportion to its stretch until it breaks; the force on a "
                "node is the sum over its family.",
                "ux uy", "fx fy stretch broken broken_at"),
    STAGE_WORDS(STAGE_BODY_FORCE, 0, "body-force", "body force", NULL, "eq. 8", NULL, "loaded fy", "fy"),
    STAGE_WORDS(STAGE_SECOND_KICK, 0, "second-kick", "second half kick", "v(n+1) = v(n+½) + Δt/2 a(n+1)",
                "eq. 11", "The new force completes the velocity of the step; supports hold again.",
                "vx vy fx fy held", "vx vy"),
    STAGE_WORDS(STAGE_DAMAGE, 0, "damage", "damage", "φ(i) = 1 − Σ μ w V / Σ w V", "eqs. 5, 6",
                "The damage of a node is the fraction of its bonds that are broken.", "broken", "damage"),

    /* a bar; nothing of it breaks */
    STAGE_WORDS(STAGE_HALF_KICK, OF(BEAM_BAR), .reads = "v force acceleration", .writes = "v"),
    STAGE_WORDS(STAGE_DRIFT, OF(BEAM_BAR), .reads = "u v", .writes = "u x"),
    STAGE_WORDS(STAGE_CONSTRAINTS, OF(BEAM_BAR), "mirror", "mirrored ends",
                "fixed end at 0:  u(−X) = −u(X),   so u(0) = 0", "odd reflection",
                "Beyond a fixed end lies a mirror image of the bar; beyond a free end there is nothing.", "u",
                "u"),
    STAGE_WORDS(STAGE_BONDS, OF(BEAM_BAR),
                .equation = "s = (|ξ+η| − |ξ|)/|ξ|,   c = c(|ξ|)\n"
                            "f(i) = Σ c G w s V sign(ξ+η)",
                .source = "eqs. 2, 3, 8",
                .sentence = "The force of a bond is in proportion to its stretch; the force on a node "
                            "is the sum over its family.",
                .reads = "u family surface_factor", .writes = "force stress strain density strain_energy"),
    STAGE_WORDS(STAGE_BODY_FORCE, OF(BEAM_BAR), .id = "load", .name = "loads", .reads = "load force",
                .writes = "force"),
    STAGE_WORDS(STAGE_SECOND_KICK, OF(BEAM_BAR),
                .sentence = "The new force completes the velocity of the step.",
                .reads = "v force acceleration", .writes = "v"),

    /* other problems */
    STAGE_WORDS(STAGE_CONSTRAINTS, OF(BEAM_MOVING_CANTILEVER), .name = "clamp",
                .equation = "in the channel uy = 0, with a full clamp ux = v0t", .source = "in words",
                .sentence = "The channel guides the nodes inside it."),
    STAGE_WORDS(STAGE_SECOND_KICK, OF(BEAM_MOVING_CANTILEVER),
                .sentence = "The new force completes the step's velocity; the clamp holds again."),
    STAGE_WORDS(STAGE_CONSTRAINTS, OF(BEAM_NOTCHED), .source = "in words"),
    STAGE_WORDS(STAGE_CONSTRAINTS, OF(BEAM_NOTCHED) | UNPINNED,
                .equation = "uy = 0 at the supports, ux is free"),
    STAGE_WORDS(STAGE_CONSTRAINTS, OF(BEAM_PLATE),
                .equation = "v = V in the directions that a support gives; V = 0 holds", .source = "in words",
                .sentence = "Supports keep their velocity, whatever the bonds pull."),
    STAGE_WORDS(STAGE_BODY_FORCE, OF(BEAM_PLATE), .reads = "loaded fx fy", .writes = "fx fy"),
    STAGE_WORDS(STAGE_BODY_FORCE, IN_PLANE | UNLOADED, .reads = "fy"),

    /* damped */
    STAGE_WORDS(STAGE_HALF_KICK, DAMPED, .equation = "v(n+½) = (1 − α Δt/2) v(n) + Δt/2 f/ρ",
                .sentence =
                    "The last force adds half a step's worth of velocity, and damping takes its share."),
    STAGE_WORDS(STAGE_HALF_KICK, DAMPED | OF(BEAM_MOVING_CANTILEVER),
                .sentence = "The last force adds half a step's worth of velocity, and "
                            "damping takes its share: of vx what differs from v0."),
    STAGE_WORDS(STAGE_SECOND_KICK, DAMPED, .equation = "v(n+1) = (v(n+½) + Δt/2 f/ρ)/(1 + α Δt/2)"),

    /* one kick a step, before the drift or after it */
    STAGE_WORDS(STAGE_HALF_KICK, ONE_KICK, .name = "first kick", .equation = "nothing", .source = "in words",
                .sentence = "One kick a step is enough."),
    STAGE_WORDS(STAGE_SECOND_KICK, ONE_KICK, .name = "second kick", .equation = "nothing",
                .source = "in words", .sentence = "One kick a step is enough."),
    STAGE_WORDS(STAGE_DRIFT, ONE_KICK, .equation = "u(n+1) = u(n) + Δt v",
                .sentence = "Each node moves with its present velocity."),
    STAGE_WORDS(STAGE_HALF_KICK, BY(STEPPING_EULER), .equation = "v(n+1) = v(n) + Δt a(n),   a = f/ρ",
                .sentence = "The force of the last step gives every node its new velocity."),
    STAGE_WORDS(STAGE_SECOND_KICK, BY(STEPPING_EULER_POSITION), .equation = "v(n+1) = v(n) + Δt a(n+1)",
                .sentence = "The new force gives every node its new velocity."),
    STAGE_WORDS(STAGE_HALF_KICK, BY(STEPPING_LEAPFROG),
                .equation = "v(n+½) = v(n−½) + Δt a(n),   in step 1: v(½) = v(0) + Δt/2 a(0)",
                .sentence = "The force of the last step carries the velocity from half step to half step."),
    STAGE_WORDS(STAGE_HALF_KICK, BY(STEPPING_LEAPFROG_AHEAD),
                .equation = "in step 1 alone: v(½) = v(0) + Δt/2 a(0)",
                .sentence = "Before the first step a half kick sets the velocity half a step ahead."),
    STAGE_WORDS(STAGE_SECOND_KICK, BY(STEPPING_LEAPFROG_AHEAD), .equation = "v(n+3/2) = v(n+½) + Δt a(n+1)",
                .sentence = "The new force carries the velocity from half step to half step."),
};

/* What bonds give their ends, along a line and in the plane. */
#define BONDS_GIVE(field, factors)                                                                           \
    {                                                                                                        \
        "bonds", SET_PARTICLE, SET_PARTICLE, field, false, factors, "p = c G w V s"                          \
    }
static const Exchange exchange_table[] = {BONDS_GIVE("force", "p n"), BONDS_GIVE("fx", "p nx"),
                                          BONDS_GIVE("fy", "p ny")};

void beam_set_stages(Beam *beam)
{
    const BeamDef *def = &beam->def;
    const unsigned run = OF(def->problem) | BY(def->stepping) | (beam->damping > 0 ? DAMPED : 0u) |
                         (def->pinned ? 0u : UNPINNED) | (beam->n_loads > 0 ? 0u : UNLOADED);
    for (int k = 0; k < N_STAGES; k++)
        beam->stages[k] = stage_words(rows, sizeof rows / sizeof *rows, k, run, groups);
    const ForceTerms forces = beam_terms(beam);
    forces_word_stage(&forces, &beam->force_words, &beam->stages[STAGE_BODY_FORCE]);
    const BondsMistake *mistake = beam->def.conceals_mistake ? NULL : bonds_mistake(beam);
    for (int k = 0; mistake && k < MISTAKE_LINES && mistake->lines[k].equation; k++) {
        Stage *const stage = &beam->stages[mistake->lines[k].stage];
        stage->equation = mistake->lines[k].equation;
        stage->source = mistake->id;
        stage->sentence = mistake->sentence;
    }
    beam->sim.stages = beam->stages;
    beam->sim.n_stages = beam->lattice.line ? STAGE_DAMAGE : N_STAGES;
    beam->sim.exchanges = beam->exchanges;
    beam->sim.n_exchanges = beam->lattice.line ? 1 : 2;
    for (int d = 0; d < beam->sim.n_exchanges; d++) {
        beam->exchanges[d] = exchange_table[beam->lattice.line ? 0 : 1 + d];
        beam->exchanges[d].adds = bonds_does(beam, BONDS_WRONG_FORCE_STAYS);
    }
}

/* What a stage is explained for, with its family: the bonds that are whole before the others, the strongest
 * first. */
typedef struct Subject {
    const Beam *beam;
    int stage;
    const void *before; /* the state before the stage; NULL: not known */
    size_t index, at;   /* the node, and where it is in a padded array */
    Link family[FAMILY_MAX];
    size_t n, whole, cut; /* bonds, those that carry something, those that the notch cut */
    Calculation *to;
} Subject;

/* Six numbers of the state, six arrays one behind the other: ux, uy, vx, vy, fx, fy. */
enum { OF_U, OF_V = 2, OF_F = 4 };

static double now(const Subject *subject, int what)
{
    return subject->beam->nodes.ux[(size_t)what * subject->beam->array + subject->at];
}

static double was(const Subject *subject, int what)
{
    const Beam *beam = subject->beam;
    return calculation_before(beam->state, &beam->nodes.ux[(size_t)what * beam->array + subject->at],
                              subject->before);
}

/* The units of a bar are anybody's. */
static const char *unit_of(const Subject *subject, const char *unit)
{
    return subject->beam->lattice.line ? NULL : unit;
}

static CalculationLabel label_of(const Subject *subject, const char *form, int axis)
{
    return calculation_label(subject->beam->sim.dimensions, form, axis, 0);
}

/* "vx = 0.1 + 2e-11 × 5 = 0.2 m/s" */
static void write_change(const Subject *subject, const char *form, int what, int axis, double factor,
                         double rate, const char *unit)
{
    const CalculationLabel label = label_of(subject, form, axis);
    const double old = was(subject, what + axis), new = now(subject, what + axis);
    if (fabs(old + factor * rate - new) > 1e-9 * fmax(fabs(old), fabs(factor * rate))) {
        calculation_number(subject->to, label.text, new);
        unit = unit_of(subject, unit);
        calculation_write(subject->to, "%s%s: the node is held\n", unit ? " " : "", unit ? unit : "");
        return;
    }
    calculation_change(subject->to, label.text, old, factor, rate, new, unit_of(subject, unit));
}

/* "vx, vy = 0.1, 0.2 m/s", along a bar "v = 0.1". */
static void write_vector(const Subject *subject, const char *words, const char *along, int what,
                         const char *unit)
{
    if (subject->beam->lattice.line) {
        calculation_value(subject->to, along, now(subject, what));
        return;
    }
    calculation_number(subject->to, words, now(subject, what));
    calculation_number(subject->to, ", ", now(subject, what + 1));
    calculation_write(subject->to, " %s\n", unit);
}

/* Eqs. 9 and 11, each half of a step, or a whole kick: v = v + dt/(2 rho) f, from the velocity before the
 * stage. With damping both halves as v = v + h (f/rho - alpha v): h = dt/2 in the first, that over 1 + alpha
 * dt/2 in the second. */
static void explain_kick(const Subject *subject)
{
    const Beam *beam = subject->beam;
    const bool second = subject->stage == STAGE_SECOND_KICK;
    const double share = bonds_kick_share(beam, second, beam->sim.step);
    const double density = beam->def.density, half = beam->sim.dt / 2, alpha = beam->damping;
    if (share == 0)
        write_vector(subject, "vx, vy stay ", "v stays ", OF_V, "m/s");
    else if (!subject->before)
        write_vector(subject, "vx, vy = ", "v = ", OF_V, "m/s");
    for (int d = 0; share != 0 && subject->before && d < beam->sim.dimensions; d++) {
        const bool moving = d == 0 && beam->def.problem == BEAM_MOVING_CANTILEVER;
        const char *form = share == 1 ? "v@ = v@ + Δt/ρ f@ = " : "v@ = v@ + Δt/(2ρ) f@ = ";
        double factor = share * beam->sim.dt / density, rate = was(subject, OF_F + d);
        if (alpha > 0) {
            factor = second ? half / (1 + alpha * half) : half;
            rate = rate / density - alpha * (was(subject, OF_V + d) - (moving ? beam->def.speed : 0));
            form = moving   ? second ? "v@ = v@ + Δt/2/(1 + α Δt/2) (f@/ρ − α (v@ − v0)) = "
                                     : "v@ = v@ + Δt/2 (f@/ρ − α (v@ − v0)) = "
                   : second ? "v@ = v@ + Δt/2/(1 + α Δt/2) (f@/ρ − α v@) = "
                            : "v@ = v@ + Δt/2 (f@/ρ − α v@) = ";
        }
        write_change(subject, form, OF_V, d, factor, rate, "m/s");
    }
}

/* Eq. 10: u = u + dt v. */
static void explain_drift(const Subject *subject)
{
    const Beam *beam = subject->beam;
    const double dt = beam->sim.dt;
    const bool twice = bonds_does(beam, BONDS_WRONG_DRIFTS_TWICE),
               late = bonds_does(beam, BONDS_WRONG_KICKS_LATE);
    if (!subject->before)
        write_vector(subject, "ux, uy = ", "u = ", OF_U, "m");
    for (int d = 0; subject->before && d < beam->sim.dimensions; d++)
        write_change(subject, twice ? "u@ = u@ + 2 Δt v@ = " : "u@ = u@ + Δt v@ = ", OF_U, d,
                     twice ? 2 * dt : dt, was(subject, OF_V + d), "m");
    for (int d = 0; subject->before && late && d < beam->sim.dimensions; d++)
        write_change(subject, "v@ = v@ + Δt/ρ f@ = ", OF_V, d, dt / beam->def.density, was(subject, OF_F + d),
                     "m/s");
}

/* At a bar's fixed ends: where the image of a node lies, and how it moves. */
static void explain_mirror(const Subject *subject)
{
    const Beam *beam = subject->beam;
    const Lattice *lattice = &beam->lattice;
    const size_t from_end[2] = {subject->index, lattice_nodes(lattice) - 1 - subject->index};
    const double place = lattice_x(lattice, lattice_column(lattice, subject->index));
    bool any = false;
    for (int side = 0; side < 2; side++)
        if (from_end[side] < (size_t)lattice->images[side]) {
            calculation_number(subject->to,
                               "the mirror image at X = ", side ? 2 * beam->def.length - place : -place);
            calculation_value(subject->to, " moves by ", -now(subject, OF_U));
            any = true;
        }
    if (!any)
        calculation_write(subject->to,
                          "no fixed end within the horizon: this node has no mirror image that matters\n");
}

/* Eqs. 12, 13, or the channel: which components are given, at the time that the step ends. */
static void explain_constraints(const Subject *subject)
{
    const Beam *beam = subject->beam;
    if (beam->lattice.line) {
        explain_mirror(subject);
        return;
    }
    const int i = lattice_column(&beam->lattice, subject->index),
              j = lattice_row(&beam->lattice, subject->index);
    if (i < beam_held_columns(beam, (double)(beam->sim.step + 1) * beam->sim.dt)) {
        calculation_number(subject->to,
                           beam->def.clamp == CLAMP_FULL ? "in the channel: uy = 0, ux = v0 t = "
                                                         : "in the channel: uy = 0, free to slide: ux = ",
                           now(subject, OF_U));
        calculation_write(subject->to, " m\n");
        return;
    }
    for (const Support *s = beam->supports; s < beam->supports + beam->n_supports; s++)
        if (patch_has(&s->patch, i, j)) {
            if (s->vx != 0 || s->vy != 0)
                write_vector(subject, "moved by a support: vx, vy = ", NULL, OF_V, "m/s");
            else
                calculation_write(subject->to, "at a support: %s\n",
                                  s->x && s->y ? "ux = uy = 0"
                                  : s->x       ? "ux = 0"
                                               : "uy = 0");
            return;
        }
    calculation_write(subject->to, "free: nothing holds this node\n");
}

/* How many bonds of a family are broken, and how many the notch cut. */
static void write_lost(const Subject *subject)
{
    calculation_write(subject->to, "%zu of %zu bonds broken", subject->n - subject->whole - subject->cut,
                      subject->n);
    if (subject->cut > 0)
        calculation_write(subject->to, ", %zu cut%s", subject->cut,
                          subject->beam->def.problem == BEAM_NOTCHED ? " by the notch" : " from the start");
    calculation_write(subject->to, "; ");
}

/* The pull of the strongest bond, and the sums of the table of exchanges. */
static void explain_bonds(const Subject *subject)
{
    const Simulation *sim = &subject->beam->sim;
    const Link *strongest = subject->family;
    size_t pulling = subject->whole;
    while (pulling > 0 && link_pull(&subject->family[pulling - 1]) == 0)
        pulling--;
    if (!subject->beam->lattice.line)
        write_lost(subject);
    if (pulling == 0)
        calculation_write(subject->to, "no bond pulls\n");
    else {
        char words[64];
        snprintf(words, sizeof words, "to %s%zu: %s = ", link_mirror(strongest), strongest->index,
                 strchr(sim->exchanges[0].note, '=') + 2);
        CalculationSum sum = {.label = words, .result = link_pull(strongest)};
        calculation_add(&sum, 2, strongest->stiffness, strongest->stretch, 0);
        calculation_sum(subject->to, &sum);
    }
    for (int d = 0; d < sim->n_exchanges; d++) {
        const CalculationLabel words = label_of(subject, "f@ = ", d);
        CalculationSum sum = {.label = words.text, .unit = unit_of(subject, "N/m³")};
        calculation_exchange(subject->to, &sum, sim, d, subject->index, subject->family, pulling);
    }
}

/* The terms of eq. 8's b that act on the node; what the bonds had left in f is solved for. */
static void explain_body_force(const Subject *subject)
{
    const Simulation *sim = &subject->beam->sim;
    const ForceTerms forces = beam_terms(subject->beam);
    bool loaded = false;
    for (int d = 0; d < sim->dimensions; d++) {
        const CalculationLabel words = label_of(subject, "f@ = f@ + b = ", d);
        const double force = now(subject, OF_F + d);
        CalculationSum sum = {.label = words.text,
                              .has_base = true,
                              .base = force - forces_on(&forces, sim, subject->index, d),
                              .result = force,
                              .unit = unit_of(subject, "N/m³")};
        for (int k = 0; k < forces.count; k++) {
            const double term = forces.terms[k]->on(sim, subject->index, d, forces.terms[k]->context);
            if (term != 0)
                calculation_add(&sum, 1, term, 0, 0);
        }
        if (sum.count > 0)
            calculation_sum(subject->to, &sum);
        loaded = loaded || sum.count > 0;
    }
    if (!loaded)
        write_vector(subject, "no load on this node: f stays ", "no load on this node: f stays ", OF_F,
                     "N/m³");
}

/* Eq. 5 by weights w, all areas being equal: broken over all. */
static void explain_damage(const Subject *subject)
{
    double broken;
    const double all = beam_family_weight(subject->beam, subject->index, LONG_MAX, &broken);
    write_lost(subject);
    calculation_number(subject->to, "in weights ", broken);
    calculation_value(subject->to, " of ", all);
    CalculationSum sum = {.label = "φ = ", .result = subject->beam->damage[subject->index]};
    calculation_add(&sum, 1, broken, 0, 0)->divisor = all;
    calculation_sum(subject->to, &sum);
}

static void (*const of_stage[N_STAGES])(const Subject *) = {
    [STAGE_HALF_KICK] = explain_kick,          [STAGE_DRIFT] = explain_drift,
    [STAGE_CONSTRAINTS] = explain_constraints, [STAGE_BONDS] = explain_bonds,
    [STAGE_BODY_FORCE] = explain_body_force,   [STAGE_SECOND_KICK] = explain_kick,
    [STAGE_DAMAGE] = explain_damage,
};

void beam_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, int terms,
                  char *out, size_t size)
{
    ASSERT_INDEX(stage, N_STAGES);
    const Beam *beam = (const Beam *)sim;
    const Lattice *lattice = &beam->lattice;
    Calculation text;
    calculation_open(&text, out, size, terms);
    Subject subject = {.beam = beam,
                       .stage = stage,
                       .before = before,
                       .index = index,
                       .at = lattice_at(lattice, lattice_column(lattice, index), lattice_row(lattice, index)),
                       .to = &text};
    subject.n = beam_links(sim, set, index, subject.family, FAMILY_MAX);
    simulation_sort_links(subject.family, subject.n);
    for (const Link *link = subject.family; link < subject.family + subject.n; link++) {
        subject.whole += !link->broken;
        subject.cut += link->broken && link->broken_at == 0;
    }
    of_stage[stage](&subject);
}

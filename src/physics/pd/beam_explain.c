/* The stages as people read them, and the sum of the stage just done with its numbers. */
#include "physics/pd/beam_internal.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const Stage beam_stage_table[N_STAGES] = {
    [STAGE_HALF_KICK] = {"half-kick", "half kick", "v(n+½) = v(n) + Δt/2 a(n),   a = f/ρ",
                         "v(n+1/2) = v(n) + dt/2 a(n),   a = f/rho", "eq. 9",
                         "The force of the last step gives every node half a step's worth of new velocity.",
                         "vx vy fx fy", "vx vy"},
    [STAGE_DRIFT] = {"drift", "drift", "u(n+1) = u(n) + Δt v(n+½)", "u(n+1) = u(n) + dt v(n+1/2)", "eq. 10",
                     "Every node moves on with its half-step velocity.", "ux uy vx vy", "ux uy"},
    [STAGE_CONSTRAINTS] = {"constraints", "supports and clamp",
                           "u = 0 at supports;   in the channel u = v0t, 0",
                           "u = 0 at supports;   in the channel u = v0 t, 0", "eqs. 12, 13",
                           "Supported nodes stay where they are; the channel guides the nodes inside it.",
                           "ux uy vx vy held", "ux uy vx vy"},
    [STAGE_BONDS] =
        {"bonds", "bond forces",
         "s = (|ξ+η| − |ξ|)/|ξ|,   s ≥ s0: broken for ever\n"
         "f(i) = Σ c G w s V (ξ+η)/|ξ+η|",
         "s = (|xi+eta| - |xi|)/|xi|,   s >= s0: broken for ever\n"
         "f(i) = sum c G w s V (xi+eta)/|xi+eta|",
         "eqs. 2, 3, 6, 8",
         "Each bond pulls as much as it is stretched, or breaks; a node feels the sum of its family.",
         "ux uy", "fx fy stretch broken broken_at"},
    [STAGE_BODY_FORCE] = {"body-force", "body force",
                          "f(i) += b(t),   b = −p min(1, t/t0)/Δx on loaded nodes",
                          "f(i) += b(t),   b = -p min(1, t/t0)/dx on loaded nodes", "eq. 8",
                          "The load pushes the nodes of the top row that it rests on.", "loaded fy", "fy"},
    [STAGE_SECOND_KICK] = {"second-kick", "second half kick", "v(n+1) = v(n+½) + Δt/2 a(n+1)",
                           "v(n+1) = v(n+1/2) + dt/2 a(n+1)", "eq. 11",
                           "The new force completes the step's velocity; supports and clamp hold again.",
                           "vx vy fx fy held", "vx vy"},
    [STAGE_DAMAGE] = {"damage", "damage", "φ(i) = 1 − Σ μ w V / Σ w V", "phi(i) = 1 - sum mu w V / sum w V",
                      "eqs. 5, 6", "Damage of a node is the share of its family that it has lost.", "broken",
                      "damage"},
};

/* Text that grows to its limit and no further. */
typedef struct Text {
    char *out;
    size_t size, used;
} Text;

static void say(Text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void say(Text *text, const char *format, ...)
{
    if (text->used + 1 >= text->size)
        return;
    va_list arguments;
    va_start(arguments, format);
    int n = vsnprintf(text->out + text->used, text->size - text->used, format, arguments);
    va_end(arguments);
    if (n > 0)
        text->used += (size_t)n < text->size - text->used ? (size_t)n : text->size - text->used - 1;
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

static NodeNow node_before(const Beam *beam, size_t at, const void *before)
{
    /* the saved block is laid out as the state is */
    double value[6];
    for (size_t k = 0; k < 6; k++) {
        size_t offset = (size_t)((char *)(beam->nodes.ux + k * beam->array + at) - (char *)beam->state);
        memcpy(&value[k], (const char *)before + offset, sizeof value[k]);
    }
    return (NodeNow){at, value[0], value[1], value[2], value[3], value[4], value[5]};
}

static void explain_kick(const Beam *beam, Text *text, const NodeNow *now, const NodeNow *was)
{
    double factor = beam->sim.dt / (2 * beam->def.density);
    say(text, "a = f/ρ = %.4g, %.4g m/s²\n", now->fx / beam->def.density, now->fy / beam->def.density);
    if (was) {
        say(text, "vx: %.6g + %.3g × %.4g = %.6g\n", was->vx, factor, was->fx, now->vx);
        say(text, "vy: %.6g + %.3g × %.4g = %.6g", was->vy, factor, was->fy, now->vy);
    } else {
        say(text, "v = %.6g, %.6g m/s", now->vx, now->vy);
    }
}

static void explain_drift(const Beam *beam, Text *text, const NodeNow *now, const NodeNow *was)
{
    if (was) {
        say(text, "ux: %.6g + %.3g × %.4g = %.6g\n", was->ux, beam->sim.dt, now->vx, now->ux);
        say(text, "uy: %.6g + %.3g × %.4g = %.6g", was->uy, beam->sim.dt, now->vy, now->uy);
    } else {
        say(text, "u = %.6g, %.6g m", now->ux, now->uy);
    }
}

static void explain_constraints(const Beam *beam, Text *text, size_t index, const NodeNow *now)
{
    size_t nx = (size_t)beam->lattice.nx;
    double time = (double)(beam->sim.step + 1) * beam->sim.dt;
    if ((int)(index % nx) < beam_held_columns(beam, time)) {
        if (beam->def.clamp == CLAMP_FULL)
            say(text, "in the channel: ux = v0t = %.6g, uy = 0", now->ux);
        else
            say(text, "in the channel: uy = 0, ux = %.6g stays free", now->ux);
        return;
    }
    for (const Support *s = beam->supports; s < beam->supports + beam->n_supports; s++)
        if ((size_t)s->j * nx + (size_t)s->i == index) {
            say(text, "support: %s", s->x && s->y ? "ux = uy = 0" : s->x ? "ux = 0" : "uy = 0");
            return;
        }
    say(text, "free: nothing holds this node");
}

enum { BONDS_SAID = 3 };

/* The strongest bonds by name, the rest as one sum. */
static void explain_bonds(const Beam *beam, Text *text, size_t index)
{
    size_t nx = (size_t)beam->lattice.nx;
    BondPlace family[FAMILY_MAX];
    size_t n = beam_family(beam, (int)(index % nx), (int)(index / nx), family), n_broken = 0;
    size_t strongest[BONDS_SAID];
    size_t n_said = 0;
    double sum_x = 0, sum_y = 0, said_x = 0, said_y = 0;
    BondNow bonds[FAMILY_MAX];
    for (size_t k = 0; k < n; k++) {
        bonds[k] = beam_bond(beam, family[k]);
        if (bonds[k].a != index) { /* seen from this end */
            bonds[k].direction_x = -bonds[k].direction_x;
            bonds[k].direction_y = -bonds[k].direction_y;
            bonds[k].b = bonds[k].a;
        }
        n_broken += bonds[k].broken;
        sum_x += bonds[k].pull * bonds[k].direction_x;
        sum_y += bonds[k].pull * bonds[k].direction_y;
        size_t rank = n_said;
        while (rank > 0 && fabs(bonds[k].pull) > fabs(bonds[strongest[rank - 1]].pull))
            rank--;
        if (rank == BONDS_SAID)
            continue;
        if (n_said < BONDS_SAID)
            n_said++;
        for (size_t r = n_said - 1; r > rank; r--)
            strongest[r] = strongest[r - 1];
        strongest[rank] = k;
    }
    for (size_t r = 0; r < n_said; r++) {
        const BondNow *bond = &bonds[strongest[r]];
        said_x += bond->pull * bond->direction_x;
        said_y += bond->pull * bond->direction_y;
        say(text, "to %zu: c G w V s = %.4g × %.4g = %.4g along (%.3g, %.3g)\n", bond->b,
            bond->stretch != 0 ? bond->pull / bond->stretch : 0, bond->stretch, bond->pull, bond->direction_x,
            bond->direction_y);
    }
    say(text, "and %zu more, %zu of %zu broken: (%.4g, %.4g)\n", n - n_said, n_broken, n, sum_x - said_x,
        sum_y - said_y);
    say(text, "f = (%.5g, %.5g) N/m³", sum_x, sum_y);
}

static void explain_body_force(const Beam *beam, Text *text, size_t index, const NodeNow *now)
{
    size_t nx = (size_t)beam->lattice.nx;
    int i = (int)(index % nx);
    if ((int)(index / nx) != beam->lattice.ny - 1 || i < beam->load_first || i >= beam->load_end) {
        say(text, "no load on this node: f = (%.5g, %.5g) stays", now->fx, now->fy);
        return;
    }
    double force = beam_body_force(beam, (double)(beam->sim.step + 1) * beam->sim.dt);
    say(text, "fy: %.5g + (%.5g) = %.5g N/m³", now->fy - force, force, now->fy);
}

static void explain_damage(const Beam *beam, Text *text, size_t index)
{
    size_t nx = (size_t)beam->lattice.nx;
    BondPlace family[FAMILY_MAX];
    size_t n = beam_family(beam, (int)(index % nx), (int)(index / nx), family), n_broken = 0;
    double all = 0, broken = 0;
    for (size_t k = 0; k < n; k++) {
        double weight = beam->lattice.offsets[family[k].offset].weight;
        bool gone = beam_bit(beam->broken, lattice_slot(&beam->lattice, family[k]));
        all += weight;
        broken += gone ? weight : 0;
        n_broken += gone;
    }
    say(text, "%zu of %zu bonds broken, weights %.5g of %.5g\nφ = 1 − %.5g/%.5g = %.5g", n_broken, n, broken,
        all, all - broken, all, beam->damage[index]);
}

static void explain_bond(const Beam *beam, Text *text, size_t index)
{
    BondNow bond = beam_bond(beam, lattice_bond_place(&beam->lattice, index));
    say(text, "bond %zu to %zu: s = %.4g", bond.a, bond.b, bond.stretch);
    if (beam->head->critical_stretch > 0)
        say(text, " of s0 = %.4g", beam->head->critical_stretch);
    say(text, bond.broken ? "\nbroken: it carries nothing" : "\npull %.4g N/m³, energy %.4g J", bond.pull,
        bond.energy);
}

void beam_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, char *out,
                  size_t size)
{
    const Beam *beam = (const Beam *)sim;
    Text text = {out, size, 0};
    if (size == 0)
        return;
    out[0] = '\0';
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
        explain_kick(beam, &text, &now, was);
        break;
    case STAGE_DRIFT:
        explain_drift(beam, &text, &now, was);
        break;
    case STAGE_CONSTRAINTS:
        explain_constraints(beam, &text, index, &now);
        break;
    case STAGE_BONDS:
        explain_bonds(beam, &text, index);
        break;
    case STAGE_BODY_FORCE:
        explain_body_force(beam, &text, index, &now);
        break;
    default:
        explain_damage(beam, &text, index);
    }
}

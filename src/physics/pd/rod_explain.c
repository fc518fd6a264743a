/* The stages as people read them, and the sum of the stage just done with its numbers. */
#include "physics/pd/rod_internal.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const Stage rod_stage_table[ROD_STAGES] = {
    [ROD_HALF_KICK] = {"half-kick", "half kick", "v(n+½) = v(n) + Δt/2 a(n),   a = f/ρ",
                       "v(n+1/2) = v(n) + dt/2 a(n),   a = f/rho", "eq. 9",
                       "The force of the last step gives every node half a step's worth of new velocity.",
                       "v force acceleration", "v"},
    [ROD_DRIFT] = {"drift", "drift", "u(n+1) = u(n) + Δt v(n+½)", "u(n+1) = u(n) + dt v(n+1/2)", "eq. 10",
                   "Every node moves on with its half-step velocity.", "u v", "u x"},
    [ROD_MIRROR] =
        {"mirror", "mirrored ends", "fixed end at 0:  u(−X) = −u(X),   so u(0) = 0",
         "fixed end at 0:  u(-X) = -u(X),   so u(0) = 0", "odd reflection",
         "Beyond a fixed end the bar goes on as its own mirror image; a free end has nothing there.", "x0 u",
         ""},
    [ROD_BONDS] = {"bonds", "bond forces",
                   "s = (|ξ+η| − |ξ|)/|ξ|,   c = 2E/(A δ²)\n"
                   "f(i) = Σ c G w s V sign(ξ+η)",
                   "s = (|xi+eta| - |xi|)/|xi|,   c = 2E/(A delta^2)\n"
                   "f(i) = sum c G w s V sign(xi+eta)",
                   "eqs. 2, 3, 8",
                   "Each bond pulls as much as it is stretched; a node feels the sum of its family.",
                   "u family surface_factor", "force stress strain density strain_energy"},
    [ROD_LOAD] = {"load", "loads", "f(i) += ρb,   and ±t/h in the layer at a free end",
                  "f(i) += rho b,   and +-t/h in the layer at a free end", "eq. 8",
                  "The body force acts on every node, the traction on the last ones at a free end.",
                  "load force", "force"},
    [ROD_SECOND_KICK] = {"second-kick", "second half kick", "v(n+1) = v(n+½) + Δt/2 a(n+1)",
                         "v(n+1) = v(n+1/2) + dt/2 a(n+1)", "eq. 11",
                         "The new force completes the step's velocity.", "v force acceleration", "v"},
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

/* The same number in the saved block, which is laid out as the state is. */
static double before_of(const Rod *rod, const double *now, const void *before)
{
    double value;
    memcpy(&value, (const char *)before + ((const char *)now - (const char *)rod->head), sizeof value);
    return value;
}

static void explain_kick(const Rod *rod, Text *text, int i, const void *before)
{
    const double half = rod->sim.dt / 2, acceleration = rod->f[i] / rod->def.density;
    say(text, "a = f/ρ = %.5g/%.4g = %.5g\n", rod->f[i], rod->def.density, acceleration);
    if (before)
        say(text, "v: %.7g + %.4g × %.5g = %.7g", before_of(rod, &rod->v[i], before), half, acceleration,
            rod->v[i]);
    else
        say(text, "v = %.7g", rod->v[i]);
}

static void explain_drift(const Rod *rod, Text *text, int i, const void *before)
{
    const double *u = &rod->u[rod_at(&rod->lattice, i)];
    if (before)
        say(text, "u: %.7g + %.4g × %.6g = %.7g", before_of(rod, u, before), rod->sim.dt, rod->v[i], *u);
    else
        say(text, "u = %.7g", *u);
}

static void explain_mirror(const Rod *rod, Text *text, int i)
{
    const RodLattice *lattice = &rod->lattice;
    const double u = rod->u[rod_at(lattice, i)];
    const bool left = rod->def.left_fixed && i < lattice->reach;
    const bool right = rod->def.right_fixed && i >= lattice->n - lattice->reach;
    if (left)
        say(text, "mirror image at X = %.5g: u = −(%.6g) = %.6g", -rod_position(lattice, i), u, -u);
    if (right)
        say(text, "%smirror image at X = %.5g: u = −(%.6g) = %.6g", left ? "\n" : "",
            2 * rod->def.length - rod_position(lattice, i), u, -u);
    if (!left && !right)
        say(text, "no fixed end within the horizon: this node has no mirror image that matters");
}

/* The pull of one bond on node i: "to p17 +13.3 × 1.2e-4 = ...". */
static void explain_bonds(const Rod *rod, Text *text, int i)
{
    const RodLattice *lattice = &rod->lattice;
    double sum = 0;
    int said = 0;
    for (int m = 1; m <= lattice->reach; m++)
        for (int side = -1; side <= 1; side += 2) {
            const int other = i + side * m, k = side < 0 ? other : i;
            const double stiffness = rod_stiffness(rod, k, m), elongation = rod_elongation(rod, k, m);
            if (!(stiffness > 0))
                continue;
            const double pull = side * stiffness * elongation;
            const bool mirrored = other < 0 || other >= lattice->n;
            sum += pull;
            if (said++ < 4)
                say(text, "%s%d%s: c G w V s = %.5g × %.5g = %.5g\n", mirrored ? "mirror of p" : "to p",
                    rod_partner(lattice, other), side < 0 ? ", on the left" : "",
                    side * stiffness * m * lattice->h, elongation / (m * lattice->h), pull);
        }
    if (said > 4)
        say(text, "and %d more\n", said - 4);
    say(text, "f = %.6g", sum);
}

static void explain_load(const Rod *rod, Text *text, int i)
{
    const double load = rod_load(rod, i);
    if (load == 0)
        say(text, "no load on this node: f = %.6g stays", rod->f[i]);
    else
        say(text, "f: %.6g + (%.6g) = %.6g", rod->f[i] - load, load, rod->f[i]);
}

static void explain_bond(const Rod *rod, Text *text, size_t index)
{
    Link ends[2];
    rod_links(&rod->sim, ROD_BOND, index, ends, 2);
    say(text, "bond p%zu to p%zu: s = %.5g, pull %.5g per unit cross-section", ends[0].index, ends[1].index,
        ends[0].weight, ends[0].gradient);
}

void rod_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, char *out,
                 size_t size)
{
    const Rod *rod = (const Rod *)sim;
    Text text = {out, size, 0};
    const int i = (int)index;
    if (size == 0)
        return;
    out[0] = '\0';
    if (set == ROD_BOND) {
        explain_bond(rod, &text, index);
        return;
    }
    switch (stage) {
    case ROD_HALF_KICK:
    case ROD_SECOND_KICK:
        explain_kick(rod, &text, i, before);
        break;
    case ROD_DRIFT:
        explain_drift(rod, &text, i, before);
        break;
    case ROD_MIRROR:
        explain_mirror(rod, &text, i);
        break;
    case ROD_BONDS:
        explain_bonds(rod, &text, i);
        break;
    default:
        explain_load(rod, &text, i);
    }
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stages as people read them, and the sum of the stage just done with its numbers. */
#include "base/assertion.h"
#include "methods/bonds/line/pd_bar_internal.h"
#include "methods/bonds/plane/verlet.h"
#include "methods/calculation.h"

#include <string.h>

static const Stage stage_table[PD_BAR_STAGES] = {
    [PD_BAR_HALF_KICK] = VERLET_HALF_KICK("v force acceleration", "v"),
    [PD_BAR_DRIFT] = VERLET_DRIFT("u v", "u x"),
    [PD_BAR_MIRROR] =
        {"mirror", "mirrored ends", "fixed end at 0:  u(−X) = −u(X),   so u(0) = 0",
         "fixed end at 0:  u(-X) = -u(X),   so u(0) = 0", "odd reflection",
         "Beyond a fixed end the bar goes on as its own mirror image; a free end has nothing there.", "u",
         "u"},
    [PD_BAR_BONDS] = {"bonds", "bond forces",
                      "s = (|ξ+η| − |ξ|)/|ξ|,   c = c(|ξ|)\n"
                      "f(i) = Σ c G w s V sign(ξ+η)",
                      "s = (|xi+eta| - |xi|)/|xi|,   c = c(|xi|)\n"
                      "f(i) = sum c G w s V sign(xi+eta)",
                      "eqs. 2, 3, 8",
                      "Each bond pulls as much as it is stretched; a node feels the sum of its family.",
                      "u family surface_factor", "force stress strain density strain_energy"},
    [PD_BAR_LOAD] = {"load", "loads", NULL, NULL, "eq. 8", NULL, "load force", "force"}, /* by its terms */
    [PD_BAR_SECOND_KICK] =
        VERLET_SECOND_KICK("The new force completes the step's velocity.", "v force acceleration", "v"),
};

void pd_bar_set_stages(PdBar *bar)
{
    const ForceTerms forces = pd_bar_terms(bar);
    _Static_assert((int)PD_BAR_BONDS == (int)STAGE_BONDS && (int)PD_BAR_SECOND_KICK == (int)STAGE_SECOND_KICK,
                   "lines of mistakes are of the stage of that number");
    memcpy(bar->stages, stage_table, sizeof bar->stages);
    bonds_word_kicks(bar->stages, bar->def.stepping);
    bonds_word_mistake(bar->stages, bar->def.conceals_mistake ? NULL : bar->mistake);
    forces_word_stage(&forces, &bar->force_words, &bar->stages[PD_BAR_LOAD]);
    bar->sim.stages = bar->stages;
    bar->sim.n_stages = PD_BAR_STAGES;
}

static void explain_kick(const PdBar *bar, Calculation *calculation, int i, bool second, const void *before)
{
    const double share = bonds_kick_share(bar->def.stepping, bar->mistake, second, bar->sim.step);
    if (share == 0) {
        calculation_value(calculation, "v stays ", bar->v[i]);
        return;
    }
    CalculationSum sum = {.label = "a = f/ρ = ", .result = bar->f[i] / bar->def.density};
    calculation_add(&sum, 1, bar->f[i], 0, 0)->divisor = bar->def.density;
    calculation_sum(calculation, &sum);
    if (before)
        calculation_change(calculation, share == 1 ? "v = v + Δt a = " : "v = v + Δt/2 a = ",
                           calculation_before(bar->head, &bar->v[i], before), share * bar->sim.dt, sum.result,
                           bar->v[i], NULL);
    else
        calculation_value(calculation, "v = ", bar->v[i]);
}

static void explain_drift(const PdBar *bar, Calculation *calculation, int i, const void *before)
{
    const double *u = &bar->u[pd_bar_at(&bar->lattice, i)];
    const bool twice = mistake_does(bar->mistake, BONDS_WRONG_DRIFTS_TWICE);
    if (before && mistake_does(bar->mistake, BONDS_WRONG_KICKS_LATE)) {
        const double v = calculation_before(bar->head, &bar->v[i], before);
        calculation_change(calculation, "u = u + Δt v = ", calculation_before(bar->head, u, before),
                           bar->sim.dt, v, *u, NULL);
        calculation_change(calculation, "v = v + Δt/ρ f = ", v, bar->sim.dt / bar->def.density, bar->f[i],
                           bar->v[i], NULL);
    } else if (before)
        calculation_change(calculation, twice ? "u = u + 2 Δt v = " : "u = u + Δt v = ",
                           calculation_before(bar->head, u, before), (twice ? 2 : 1) * bar->sim.dt, bar->v[i],
                           *u, NULL);
    else
        calculation_value(calculation, "u = ", *u);
}

static void write_image(Calculation *calculation, double place, double u)
{
    calculation_number(calculation, "the mirror image at X = ", place);
    calculation_value(calculation, " moves by ", -u);
}

static void explain_mirror(const PdBar *bar, Calculation *calculation, int i)
{
    const PdBarLattice *lattice = &bar->lattice;
    const double u = bar->u[pd_bar_at(lattice, i)];
    const bool left = bar->def.left_fixed && i < lattice->reach;
    const bool right = bar->def.right_fixed && i >= lattice->n - lattice->reach;
    if (left)
        write_image(calculation, -pd_bar_position(lattice, i), u);
    if (right)
        write_image(calculation, 2 * bar->def.length - pd_bar_position(lattice, i), u);
    if (!left && !right)
        calculation_write(calculation,
                          "no fixed end within the horizon: this node has no mirror image that matters\n");
}

/* f = Σ c G w V s, bond by bond; c G w V and s of the nearest neighbours. */
static void explain_bonds(const PdBar *bar, Calculation *calculation, int i)
{
    const PdBarLattice *lattice = &bar->lattice;
    CalculationSum sum = {.label = "f = Σ (c G w V) s = "};
    for (int m = 1; m <= lattice->reach; m++)
        for (int side = -1; side <= 1; side += 2) {
            const int other = i + side * m, k = side < 0 ? other : i;
            const double stiffness = pd_bar_stiffness(bar, k, m), elongation = pd_bar_elongation(bar, k, m);
            if (!(stiffness > 0))
                continue;
            const double stretch = elongation / (m * lattice->h), pull = pd_bar_pull(bar, i, side * m);
            calculation_add(&sum, 2, stretch != 0 ? pull / stretch : side * stiffness * m * lattice->h,
                            stretch, 0);
            sum.result += pull;
        }
    if (mistake_does(bar->mistake, BONDS_WRONG_FORCE_STAYS)) {
        sum.has_base = true;
        sum.base = bar->f[i] - sum.result;
        sum.result = bar->f[i];
    }
    calculation_write(calculation, "nearest bonds first: ");
    const char *comma = "";
    for (int side = -1; side <= 1; side += 2) {
        const int other = i + side;
        if (!(pd_bar_stiffness(bar, side < 0 ? other : i, 1) > 0))
            continue; /* a free end */
        calculation_write(calculation, "%s%s%d", comma,
                          other < 0 || other >= lattice->n ? "to the mirror of p" : "to p",
                          pd_bar_partner(lattice, other));
        comma = ", ";
    }
    calculation_write(calculation, ", and so on\n");
    calculation_sum(calculation, &sum);
}

static void explain_load(const PdBar *bar, Calculation *calculation, int i)
{
    const double load = pd_bar_load(bar, i);
    if (load == 0) {
        calculation_value(calculation, "no load on this node: f stays ", bar->f[i]);
        return;
    }
    const ForceTerms forces = pd_bar_terms(bar);
    CalculationSum sum = {
        .label = "f = f + b = ", .has_base = true, .base = bar->f[i] - load, .result = bar->f[i]};
    for (int k = 0; k < forces.count; k++)
        calculation_add(&sum, 1, forces.terms[k]->on(&bar->sim, (size_t)i, 0, forces.terms[k]->context), 0,
                        0);
    calculation_sum(calculation, &sum);
}

static void explain_bond(const PdBar *bar, Calculation *calculation, size_t index)
{
    Link ends[2];
    pd_bar_links(&bar->sim, PD_BAR_BOND, index, ends, 2);
    calculation_write(calculation, "bond p%zu to p%zu: ", ends[0].index, ends[1].index);
    calculation_number(calculation, "s = ", ends[0].weight);
    calculation_number(calculation, ", pull ", ends[0].pull);
    calculation_write(calculation, " per unit cross-section\n");
}

void pd_bar_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, int terms,
                    char *out, size_t size)
{
    ASSERT_INDEX(stage, PD_BAR_STAGES);
    ASSERT_INDEX(index, sim->counts[set]);
    const PdBar *bar = (const PdBar *)sim;
    Calculation text;
    calculation_open(&text, out, size, terms);
    const int i = (int)index;
    if (set == PD_BAR_BOND) {
        explain_bond(bar, &text, index);
        return;
    }
    switch (stage) {
    case PD_BAR_HALF_KICK:
    case PD_BAR_SECOND_KICK:
        explain_kick(bar, &text, i, stage == PD_BAR_SECOND_KICK, before);
        break;
    case PD_BAR_DRIFT:
        explain_drift(bar, &text, i, before);
        break;
    case PD_BAR_MIRROR:
        explain_mirror(bar, &text, i);
        break;
    case PD_BAR_BONDS:
        explain_bonds(bar, &text, i);
        break;
    default:
        explain_load(bar, &text, i);
    }
}

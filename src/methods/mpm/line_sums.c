/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sums of one particle or node as lines of a calculation, term by term from line_exchange.c. Terms that
 * are exactly 0 by their shape function are left out. */
#include "methods/mpm/line_sums.h"

#include "base/assertion.h"
#include "base/text.h"

LineLabel line_label(const char *before, int node, const char *after)
{
    ASSERT_INT(node, >=, 0);
    LineLabel label;
    Calculation words;
    calculation_open(&words, label.text, sizeof label.text, 0);
    calculation_write(&words, "%s%d%s", before, node, after);
    return label;
}

static bool uses_slope(MpmExchange exchange)
{
    return exchange == GIVE_F_INT || exchange == TAKE_STRAIN;
}

/* Mass and time step stand before the bracket. */
static bool leads(MpmExchange exchange, int n_factors)
{
    return exchange == GIVE_MASS || (n_factors == 3 && exchange != GIVE_F_INT);
}

/* The terms that the subject is given in an exchange, m or dt before the bracket; returns their sum. */
double line_add_terms(const Subject *subject, MpmExchange exchange, CalculationSum *sum)
{
    double total = 0;
    for (size_t i = 0; i < subject->n_links; i++) {
        const Link *link = &subject->links[i];
        double f[EXCHANGE_FACTORS_MAX] = {0};
        int n;
        const double term = subject_term(subject, (int)exchange, link->index, (size_t)subject->index, &n, f);
        if (n == 0 || (uses_slope(exchange) ? link->gradient[0] : link->weight) == 0.0)
            continue;
        total += term;
        if (exchange == GIVE_F_INT)
            calculation_add(sum, 2, f[0], f[1] * f[2], 0);
        else if (leads(exchange, n)) {
            sum->scale = f[0];
            calculation_add(sum, n - 1, f[1], f[2], 0);
        } else
            calculation_add(sum, n, f[0], f[1], 0);
    }
    return total;
}

void line_write_load(const Subject *subject, double load)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const ForceTerms forces = mpm_forces(mpm);
    char label[sizeof mpm->force_words.load + 4] = "";
    text_append(label, sizeof label, "%s = ", mpm->force_words.load);
    CalculationSum sum = {.label = label, .result = load};
    for (int i = 0; i < forces.count; i++)
        calculation_add(&sum, 1,
                        forces.terms[i]->on(&mpm->sim, (size_t)subject->index, 0, forces.terms[i]->context),
                        0, 0);
    calculation_sum(subject->calculation, &sum);
}

/* A node's value over its mass, or that it is inactive. */
void line_write_ratio(const Subject *subject, const char *label, double above, double result)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    CalculationSum sum = {.label = label, .result = result};
    if (mpm->inverse[subject->index] == 0.0) {
        calculation_write(subject->calculation, "%s0: too little mass is here, the node is inactive\n",
                          label);
        return;
    }
    calculation_add(&sum, 1, above, 0, 0)->divisor = mpm->node_mass[subject->index];
    calculation_sum(subject->calculation, &sum);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sums of one particle or node as lines of a calculation, term by term from bar_exchange.c. Terms that
 * are exactly 0 by their shape function are left out. */
#include "methods/mpm/line/bar_sums.h"

#include "base/text.h"

BarLabel bar_label(const char *before, int node, const char *after)
{
    BarLabel label;
    Calculation words;
    calculation_open(&words, label.text, sizeof label.text, 0);
    calculation_write(&words, "%s%d%s", before, node, after);
    return label;
}

static bool uses_slope(BarExchange exchange)
{
    return exchange == GIVE_F_INT || exchange == TAKE_STRAIN;
}

/* Mass and time step stand before the bracket. */
static bool leads(BarExchange exchange, int n_factors)
{
    return exchange == GIVE_MASS || (n_factors == 3 && exchange != GIVE_F_INT);
}

/* The terms that the subject is given in an exchange, m or dt before the bracket; returns their sum. */
double bar_add_terms(const BarSubject *subject, BarExchange exchange, CalculationSum *sum)
{
    const Simulation *sim = &subject->bar->sim;
    double total = 0;
    for (size_t i = 0; i < subject->n_links; i++) {
        const Link *link = &subject->links[i];
        double f[EXCHANGE_FACTORS_MAX] = {0};
        const int n = bar_exchange(sim, (int)exchange, link->index, (size_t)subject->index, f);
        if (n == 0 || (uses_slope(exchange) ? link->gradient[0] : link->weight) == 0.0)
            continue;
        total += f[0] * f[1] * (n == 3 ? f[2] : 1);
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

/* How what a particle gives is divided among its nodes; `whole` is what the shares add up to. */
void bar_write_shares(const BarSubject *subject, BarExchange exchange, const char *label, double whole)
{
    CalculationSum sum = {.label = label, .result = whole};
    for (size_t i = 0; i < subject->n_links; i++) {
        double f[EXCHANGE_FACTORS_MAX] = {0};
        const size_t node = subject->links[i].index;
        const int n = bar_exchange(&subject->bar->sim, (int)exchange, (size_t)subject->index, node, f);
        if (n > 0)
            calculation_add(&sum, 1, f[0] * f[1] * (n == 3 ? f[2] : 1), 0, 0)->to = (long)node;
    }
    calculation_sum(subject->calculation, &sum);
}

void bar_write_load(const BarSubject *subject, double load)
{
    const Bar *bar = subject->bar;
    const ForceTerms forces = bar_forces(bar);
    char label[sizeof bar->force_words.load + 4] = "";
    text_append(label, sizeof label, "%s = ", bar->force_words.load);
    CalculationSum sum = {.label = label, .result = load};
    for (int i = 0; i < forces.count; i++)
        calculation_add(&sum, 1,
                        forces.terms[i]->on(&bar->sim, (size_t)subject->index, 0, forces.terms[i]->context),
                        0, 0);
    calculation_sum(subject->calculation, &sum);
}

/* A node's value over its mass, or that it is inactive. */
void bar_write_ratio(const BarSubject *subject, const char *label, double above, double result)
{
    const double mass = subject->bar->node_mass[subject->index];
    CalculationSum sum = {.label = label, .result = result};
    if (subject->bar->node_inverse[subject->index] == 0.0) {
        calculation_write(subject->calculation, "%s0: too little mass is here, the node is inactive\n",
                          label);
        return;
    }
    calculation_add(&sum, 1, above, 0, 0)->divisor = mass;
    calculation_sum(subject->calculation, &sum);
}

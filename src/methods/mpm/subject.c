/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The particle or node whose sums are written out: its links, a term of an exchange, what it gives. */
#include "methods/mpm/subject.h"

#include "base/assertion.h"

Subject subject_of(const Simulation *sim, int set, size_t index, const void *before, Calculation *calculation)
{
    ASSERT_INDEX(index, sim->counts[set]);
    Subject subject = {
        .sim = sim, .before = before, .set = set, .index = (int)index, .calculation = calculation};
    subject.n_links = sim->method->links(sim, set, index, subject.links, SUBJECT_LINKS_MAX);
    ASSERT_INT(subject.n_links, <=, SUBJECT_LINKS_MAX);
    return subject;
}

double subject_term(const Subject *subject, int exchange, size_t from, size_t to, int *count,
                    double factors[EXCHANGE_FACTORS_MAX])
{
    ASSERT_INDEX(exchange, subject->sim->n_exchanges);
    *count = subject->sim->method->exchange(subject->sim, exchange, from, to, factors);
    ASSERT_INT(*count, <=, EXCHANGE_FACTORS_MAX);
    double value = *count > 0 ? 1 : 0;
    for (int k = 0; k < *count; k++)
        value *= factors[k];
    return value;
}

void subject_write_given(const Subject *subject, int exchange, const char *label, double whole)
{
    ASSERT_INT(subject->index, >=, 0);
    CalculationSum sum = {.label = label, .result = whole};
    double factors[EXCHANGE_FACTORS_MAX];
    for (size_t i = 0; i < subject->n_links; i++) {
        const size_t to = subject->links[i].index;
        int n;
        const double term = subject_term(subject, exchange, (size_t)subject->index, to, &n, factors);
        if (n > 0)
            calculation_add(&sum, 1, term, 0, 0)->to = (long)to;
    }
    calculation_sum(subject->calculation, &sum);
}

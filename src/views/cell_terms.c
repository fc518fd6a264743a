/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The terms of a stage on the arrows of a cell (cell_terms.h). */
#include "views/cell_terms.h"

#include "base/math/functions.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The terms of one exchange; false: nothing passes in it now. */
static bool take_flow(const CellTerms *terms, int exchange, Flowing *flow)
{
    const Simulation *sim = terms->sim;
    *flow = (Flowing){.exchange = &sim->exchanges[exchange]};
    bool any = false;
    for (size_t i = 0; i < terms->n_links; i++) {
        const ExchangeTerm term = simulation_exchange(sim, exchange, terms->index, &terms->links[i]);
        flow->terms[i] = term.product;
        flow->last[i] = term.count > 0 ? term.factors[term.count - 1] : 0;
        flow->sum += term.product;
        any |= term.count > 0;
    }
    /* all with the same last decimal: they are compared by eye, and add up as they stand */
    flow->writing = writing_of(flow->terms, terms->n_links, 0, flow->sum, CELL_TERM_WIDTH);
    return any;
}

/* Of one unit the stronger goes first; what cannot be compared is put by its formula, the longer one first.
 */
static bool is_before(const CellTerms *terms, const Flowing *flow, const Flowing *other)
{
    const Simulation *sim = terms->sim;
    const Exchange *both[2] = {flow->exchange, other->exchange};
    const char *units[2] = {"", ""};
    double strength[2] = {0, 0};
    for (int k = 0; k < 2; k++) {
        const int field = simulation_find_field(sim, both[k]->to, both[k]->field);
        units[k] = field >= 0 ? sim->fields[field].quantity.unit : "";
        for (size_t i = 0; i < terms->n_links; i++)
            strength[k] = fmax(strength[k], fabs((k ? other : flow)->terms[i]));
    }
    return strcmp(units[0], units[1]) == 0 ? strength[0] > strength[1]
                                           : strlen(both[0]->factors) > strlen(both[1]->factors);
}

void cell_terms_find(CellTerms *terms, const Stage *stage, size_t most)
{
    const Simulation *sim = terms->sim;
    const size_t count = sim->method->links(sim, terms->set, terms->index, terms->links, CELL_LINKS_MAX);
    terms->n_links = count < CELL_LINKS_MAX ? count : CELL_LINKS_MAX;
    for (int e = 0; stage && e < sim->n_exchanges && terms->n_flows < PICTURE_ARROW_LINES; e++) {
        Flowing flow;
        if (strcmp(sim->exchanges[e].stage, stage->id) != 0 || !take_flow(terms, e, &flow))
            continue;
        int at = terms->n_flows++;
        for (; at > 0 && is_before(terms, &flow, &terms->flows[at - 1]); at--)
            terms->flows[at] = terms->flows[at - 1];
        terms->flows[at] = flow;
        terms->to_nodes = flow.exchange->to == 1;
    }
    /* the largest first: what finds no room is the smallest */
    for (size_t i = 0; i < terms->n_links; i++) {
        const double *by = terms->n_flows > 0 ? terms->flows[0].terms : NULL;
        size_t at = i;
        for (; at > 0 && by && fabs(by[terms->order[at - 1]]) < fabs(by[i]); at--)
            terms->order[at] = terms->order[at - 1];
        terms->order[at] = i;
    }
    /* where they do not fit, one place is for what the others come to */
    terms->shown = terms->n_links <= most ? terms->n_links : most - 1;
}

NumberText cell_term_text(double value, Writing writing)
{
    const int first = value != 0 ? (int)floor(math_log10(fabs(value))) : 0;
    /* not beyond the last decimal of its column */
    const int digits = first - (writing.exponent - writing.decimals) + 1;
    return text_rounded(digits > 0 ? value : 0, digits > 1 ? digits : 1);
}

void cell_terms_arrow(const CellTerms *terms, size_t link, PictureArrow *arrow)
{
    const size_t other = terms->links[link].index;
    const size_t particle = terms->set ? other : terms->index, node = terms->set ? terms->index : other;
    snprintf(arrow->told, sizeof arrow->told, "%s %zu gives to %s %zu", terms->to_nodes ? "particle" : "node",
             terms->to_nodes ? particle : node, terms->to_nodes ? "node" : "particle",
             terms->to_nodes ? node : particle);
    for (int f = 0; f < terms->n_flows; f++) {
        const Flowing *flow = &terms->flows[f];
        char words[32];
        strcpy(arrow->brief[f], cell_term_text(flow->terms[link], flow->writing).text);
        snprintf(arrow->text[f], sizeof arrow->text[f], "%s %.20s", flow->exchange->factors, arrow->brief[f]);
        text_to_ascii(flow->exchange->factors, words, sizeof words);
        text_append(arrow->told, sizeof arrow->told, "%s %s = %.20s", f ? " and" : "", words,
                    arrow->brief[f]);
    }
}

void cell_terms_rest(const CellTerms *terms, char *out, size_t size)
{
    out[0] = '\0';
    for (int f = 0; f < terms->n_flows && terms->shown < terms->n_links; f++) {
        double rest = 0;
        for (size_t i = terms->shown; i < terms->n_links; i++)
            rest += terms->flows[f].terms[terms->order[i]];
        if (f == 0)
            text_append(out, size, "%zu more: ", terms->n_links - terms->shown);
        text_append(out, size, "%s%s %s", f ? ", " : "", terms->flows[f].exchange->factors,
                    cell_term_text(rest, terms->flows[f].writing).text);
    }
}

void cell_value_add(const Screen *screen, int set, size_t index, const char *name, const char *label,
                    bool change, char *out, size_t size)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const int field = simulation_find_field(sim, set, name);
    double before;
    if (field < 0)
        return;
    const double now = simulation_value(sim, field, index);
    text_append(out, size, "\n%s ", label);
    /* an arrow says that the stage has changed it */
    if (change && experiment_field_before(screen->experiment, field, index, 1, &before) && before != now)
        text_append(out, size, "%s→", text_fitted(before, 5, 10).text);
    text_append(out, size, "%s", text_fitted(now, 5, 10).text);
}

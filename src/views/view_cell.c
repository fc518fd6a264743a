/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cell of a mesh from near: the chosen particle or node, what it is linked with, and the terms that pass
 * between them in the stage that the box speaks of, each on its arrow and written so that they add up as they
 * are. The terms are the method's own (Simulation.exchanges). The nodes of a bar are drawn above its
 * particles, with bars of mass and momentum; in the plane all is where it is now. Where contact acts, a node
 * that two bodies share has the common normal, both velocities before, and what one gives. Of bonds:
 * view_cell_bonds.c. */
#include "base/math/functions.h"
#include "base/text.h"
#include "panes/screen.h"
#include "picture/sum_column.h"
#include "scenario/settings.h"
#include "views/inspector/inspector.h"
#include "views/view.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* LOW_ROWS: in fewer what is looked at is shown, and not what is beside it. */
enum { SHOWN_OF_LINE = 8, SHOWN_OF_PLANE = 4, LINKS_MAX = 256, TERM_WIDTH = 10, LOW_ROWS = 10 };

/* Heights in the drawing of a bar, of which the numbers of nodes have the upper end. */
#define ROWS       12.0
#define NUMBER_ROW 11.8
#define DOTS_ROW   1.6
#define ENDS       0.14 /* of its way that an arrow leaves free at both ends */

/* What a stage passes between the chosen one and its links, in one exchange. */
typedef struct Flowing {
    const Exchange *exchange;
    const char *unit;
    double strongest;
    double terms[LINKS_MAX], last[LINKS_MAX]; /* and the last factor of each, which is of the giver */
    Writing writing;
} Flowing;

/* Of one unit the stronger goes first; of what cannot be compared the one with the longer formula: mass
 * with velocity before mass alone. */
static bool is_before(const Flowing *flow, const Flowing *other)
{
    return strcmp(flow->unit, other->unit) == 0
               ? flow->strongest > other->strongest
               : strlen(flow->exchange->factors) > strlen(other->exchange->factors);
}

typedef struct CellView {
    const Screen *screen;
    const Simulation *sim;
    const Stage *stage;
    bool done, running;
    bool wiped; /* the last stage reset the grid: its nodes hold nothing */
    bool line;  /* a bar */
    double grid,
        tall; /* of a bar: the row of its grid, and how high bars on it can be: more where nothing passes */
    int set;  /* of the chosen one: 0 a particle, 1 a node */
    size_t index;
    Link links[LINKS_MAX];
    size_t n_links;
    size_t order[LINKS_MAX]; /* of links: the first ones are drawn */
    size_t shown;
    Flowing flows[PICTURE_ARROW_LINES];
    int n_flows;
    bool to_nodes;
    bool masses; /* where the mass of the chosen node sits, not what the stage passes */
    bool has_row;
    MassRow row; /* of the mass matrix, */
    double row_sum;
    Writing row_writing; /* and how it is written */
    bool meets;          /* contact acts in the stage */
    long met;            /* the node whose contact is drawn; -1: none */
    double low[2], high[2], spacing;
    int places[2];                                           /* fields of nodes: x, y */
    double *node_masses, *momenta, most_mass, most_momentum; /* of all nodes of a bar, in one block */
} CellView;

/* --- the terms of a stage ---------------------------------------------------------------------------- */

/* The links of `set`, `index`, and what passes in the stage (NULL: nothing), strongest first; of more links
 * than `most`, most - 1 are shown. */
static void find_terms(CellView *view, const Stage *stage, size_t most)
{
    const Simulation *sim = view->sim;
    const size_t count = sim->method->links(sim, view->set, view->index, view->links, LINKS_MAX);
    view->n_links = count < LINKS_MAX ? count : LINKS_MAX;
    for (int e = 0; stage && e < sim->n_exchanges && view->n_flows < PICTURE_ARROW_LINES; e++) {
        Flowing flow = {.exchange = &sim->exchanges[e], .unit = ""};
        const int field = simulation_find_field(sim, flow.exchange->to, flow.exchange->field);
        const bool of_stage = strcmp(flow.exchange->stage, stage->id) == 0;
        bool passes = false;
        double sum = 0;
        for (size_t i = 0; i < view->n_links && of_stage; i++) {
            const ExchangeTerm term = simulation_exchange(sim, e, view->index, &view->links[i]);
            flow.terms[i] = term.product;
            flow.last[i] = term.count > 0 ? term.factors[term.count - 1] : 0;
            flow.strongest = fmax(flow.strongest, fabs(term.product));
            sum += term.product;
            passes |= term.count > 0;
        }
        if (!passes)
            continue;
        if (field >= 0)
            flow.unit = sim->fields[field].quantity.unit;
        /* all with the same last decimal: they are compared by eye, and add up as they stand */
        flow.writing = writing_of(flow.terms, view->n_links, 0, sum, TERM_WIDTH);
        int at = view->n_flows++;
        for (; at > 0 && is_before(&flow, &view->flows[at - 1]); at--)
            view->flows[at] = view->flows[at - 1];
        view->flows[at] = flow;
        view->to_nodes = flow.exchange->to == 1;
    }
    /* the largest first: what finds no room is the smallest */
    for (size_t i = 0; i < view->n_links; i++) {
        const double *by = view->n_flows > 0 ? view->flows[0].terms : NULL;
        size_t at = i;
        for (; at > 0 && by && fabs(by[view->order[at - 1]]) < fabs(by[i]); at--)
            view->order[at] = view->order[at - 1];
        view->order[at] = i;
    }
    /* where they do not fit, one place is for what the others come to */
    view->shown = view->n_links <= most ? view->n_links : most - 1;
}

/* A term as it is in a sum of such a writing. */
static NumberText term_text(double value, Writing writing)
{
    const int first = value != 0 ? (int)floor(math_log10(fabs(value))) : 0;
    /* not beyond the last decimal of its column */
    const int digits = first - (writing.exponent - writing.decimals) + 1;
    return text_rounded(digits > 0 ? value : 0, digits > 1 ? digits : 1);
}

/* A line "p 0.035" of a field by its name, or with what it was before the stage "p 0.0012→0". */
static void add_value(const Screen *screen, int set, size_t index, const char *name, const char *label,
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

/* --- what is in sight --------------------------------------------------------------------------------- */

static void place_of(const CellView *view, int set, size_t index, double at[2])
{
    const Simulation *sim = view->sim;
    for (int d = 0; d < 2; d++)
        at[d] = view->line && d == 1 ? (set ? view->grid : DOTS_ROW)
                : set                ? simulation_value(sim, view->places[d], index)
                                     : simulation_value(sim, sim->position[d], index) +
                            simulation_value(sim, sim->displacement[d], index);
}

static bool is_own(const CellView *view, int set, size_t index)
{
    return set == view->set && index == view->index;
}

static bool is_link(const CellView *view, int set, size_t index)
{
    for (size_t i = 0; i < view->n_links && set != view->set; i++)
        if (view->links[i].index == index)
            return true;
    return is_own(view, set, index);
}

static bool is_in_row(const CellView *view, size_t node)
{
    return view->has_row && node >= view->row.first && node < view->row.first + view->row.count;
}

static void widen(CellView *view, int set, size_t index, double beside)
{
    double at[2];
    place_of(view, set, index, at);
    for (int d = 0; d < 2; d++) {
        view->low[d] = fmin(view->low[d], at[d] - beside);
        view->high[d] = fmax(view->high[d], at[d] + beside);
    }
}

/* From beyond the first to beyond the last link; beyond the ends of a bar's mesh there is nothing. */
static void find_sides(CellView *view)
{
    const bool node = view->set == 1;
    double ends[2][2];
    place_of(view, 1, 0, ends[0]);
    place_of(view, 1, 1, ends[1]);
    view->spacing = ends[1][0] - ends[0][0];
    view->low[0] = view->low[1] = HUGE_VAL;
    view->high[0] = view->high[1] = -HUGE_VAL;
    widen(view, view->set, view->index, node ? view->spacing : 0);
    for (size_t i = 0; i < view->n_links; i++)
        widen(view, 1 - view->set, view->links[i].index, 0);
    for (size_t k = 0; k < view->row.count && view->has_row; k++)
        if (view->row.masses[k] != 0)
            widen(view, 1, view->row.first + k, 0);
    if (view->line) {
        place_of(view, 1, view->sim->counts[1] - 1, ends[1]);
        view->low[0] = fmax(view->low[0], ends[0][0]);
        view->high[0] = fmin(view->high[0], ends[1][0]);
    }
    view->low[0] -= (node ? 0.2 : 0.7) * view->spacing, view->high[0] += (node ? 0.6 : 0.8) * view->spacing;
    view->low[1] = view->line ? 0 : view->low[1] - 0.25 * view->spacing;
    view->high[1] = view->line ? ROWS : view->high[1] + 0.25 * view->spacing;
}

static const char *name_of_body(const CellView *view, double body)
{
    return experiment_settings(view->screen->experiment)->rows[ROWS_BODIES].rows[(int)body].name;
}

/* The node of another body at the same place, where both have mass and no wall acts, so that what one loses
 * is what it gives; -1: there is none. */
static long other_at(const CellView *view, size_t node)
{
    const Simulation *sim = view->sim;
    const int body = simulation_find_field(sim, 1, "body"), active = simulation_find_field(sim, 1, "active");
    if (!(simulation_value(sim, active, node) > 0) || simulation_named(sim, 1, "fixed", node) > 0)
        return -1;
    for (size_t other = 0; other < sim->counts[1]; other++)
        if (simulation_value(sim, view->places[0], other) == simulation_value(sim, view->places[0], node) &&
            simulation_value(sim, view->places[1], other) == simulation_value(sim, view->places[1], node) &&
            simulation_value(sim, body, other) != simulation_value(sim, body, node) &&
            simulation_value(sim, active, other) > 0)
            return (long)other;
    return -1;
}

/* The link with the largest share, of those nodes that two bodies share if `shared`; -1: there is none. */
static long heaviest(const CellView *view, bool shared)
{
    long most = -1;
    double weight = 0;
    for (size_t i = 0; i < view->n_links; i++)
        if (view->links[i].weight > weight && (!shared || other_at(view, view->links[i].index) >= 0)) {
            most = (long)view->links[i].index;
            weight = view->links[i].weight;
        }
    return most;
}

/* False: no memory. */
static bool look(CellView *view, const Screen *screen, bool masses)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const int set = screen->chosen.is_node;
    const size_t chosen = set ? screen->chosen.node : screen->chosen.particle, count = sim->counts[set];
    *view = (CellView){.screen = screen,
                       .sim = sim,
                       .line = simulation_has(sim, HAS_LINE),
                       .running = screen_is_running(screen),
                       .masses = masses,
                       .grid = masses ? 4.4 : 8.5,
                       .tall = masses ? 6.2 : 2.4,
                       .met = -1,
                       .set = set,
                       .index = chosen < count ? chosen : count - 1,
                       .places = {simulation_find_field(sim, 1, "x"), simulation_find_field(sim, 1, "y")}};
    view->stage = &sim->stages[screen_box_stage(screen, &view->done)];
    view->done &= !view->running;
    view->wiped = view->done && experiment_stage(screen->experiment) == 0;
    find_terms(view, view->done && !masses ? view->stage : NULL, view->line ? SHOWN_OF_LINE : SHOWN_OF_PLANE);
    const long most = masses && set == 0 ? heaviest(view, false) : -1;
    if (most >= 0) { /* of a particle the node that it gives most to */
        view->set = 1;
        view->index = (size_t)most;
        find_terms(view, NULL, SHOWN_OF_LINE);
    }
    if (view->set == 1 && view->n_flows == 0 && view->done && !view->wiped)
        view->has_row = inspector_mass_row(sim, 1, view->index, &view->row);
    const double own = masses && view->set == 1 ? simulation_named(sim, 1, "mass", view->index) : 0;
    if (masses && view->done && !view->wiped && !view->has_row && own > 0) { /* lumped: all is its own */
        view->has_row = true;
        view->row = (MassRow){view->index, 1, {own}};
    }
    for (size_t k = 0; k < view->row.count; k++)
        view->row_sum += view->row.masses[k];
    if (view->has_row)
        view->row_writing = writing_of(view->row.masses, view->row.count, 0, view->row_sum, TERM_WIDTH);
    find_sides(view);
    view->meets = view->done && simulation_has(sim, HAS_BODIES) && strncmp(view->stage->id, "fix", 3) == 0;
    if (view->meets)
        view->met = set == 0 ? heaviest(view, true) : other_at(view, chosen) >= 0 ? (long)chosen : -1;
    view->node_masses = calloc(2 * sim->counts[1] + 1, sizeof *view->node_masses);
    if (!view->node_masses)
        return false;
    view->momenta = view->node_masses + sim->counts[1];
    view->most_mass = screen_node_values(screen, "mass", false, view->node_masses);
    view->most_momentum = screen_node_values(screen, "momentum", false, view->momenta);
    return true;
}

/* --- nodes ----------------------------------------------------------------------------------------- */

static bool writes(const CellView *view, const char *name)
{
    return view->done && !view->wiped && text_has_word(view->stage->writes, name);
}

/* What a node has to do with the stage: its share, what the stage writes of it or what it gives in it. */
static void node_numbers(const CellView *view, size_t node, char *out, size_t size)
{
    static const struct {
        const char *written, *field, *label;
    } values[] = {{"mass", "mass", "m"},    {"momentum", "momentum", "p"},
                  {"momentum", "px", "px"}, {"momentum", "py", "py"},
                  {"f", "f", "f"},          {"f", "fx", "fx"},
                  {"f", "fy", "fy"}};
    const bool made = view->n_flows > 0; /* again, by terms that are seen */
    const bool over = view->done && view->stage == &view->sim->stages[view->sim->n_stages - 1];
    if (is_in_row(view, node)) {
        const double mass = view->row.masses[node - view->row.first];
        text_append(out, size, "\nM %s", term_text(mass, view->row_writing).text);
        if (!view->masses)
            add_value(view->screen, 1, node, "velocity", "v", false, out, size);
    }
    if (view->masses || (is_in_row(view, node) && node != view->index))
        return;
    for (size_t i = 0; i < view->n_links && view->set == 0 && !view->running; i++)
        if (view->links[i].index == node && (view->line ? !view->done : !over && !view->meets))
            text_append(out, size, "\nN %s", text_fitted(view->links[i].weight, 5, 9).text);
    for (size_t k = 0; k < sizeof values / sizeof *values && !view->meets; k++)
        if (writes(view, values[k].written))
            add_value(view->screen, 1, node, values[k].field, values[k].label, !made, out, size);
    /* The velocity by which a node gives, of a bar; each once. */
    for (int f = 0; f < view->n_flows && !view->to_nodes && view->line; f++) {
        const char *factor = text_last_word(view->flows[f].exchange->factors);
        bool told = f > 0 && strcmp(factor, text_last_word(view->flows[0].exchange->factors)) == 0;
        for (size_t i = 0; i < view->n_links && !told; i++)
            if (view->set ? node == view->index : view->links[i].index == node) {
                text_append(out, size, "\n%s %s", factor, text_fitted(view->flows[f].last[i], 5, 10).text);
                told = true;
            }
    }
}

static Style style_of_masses(const CellView *view)
{
    return writes(view, "mass") || view->has_row ? STYLE_SECOND : STYLE_FAINT;
}

static Style style_of_momenta(const CellView *view)
{
    return writes(view, "momentum") ? STYLE_PREDICTED : STYLE_FAINT;
}

/* A bar of so much of its band at the left of the node, from so many spacings on; words are at the right. */
static void add_bar(const CellView *view, Picture *picture, double x, double from, double share, char letter,
                    Style style, int fill)
{
    if (share > 1e-6)
        picture_box(picture, (double[]){x + from * view->spacing, x + (from + 0.04) * view->spacing},
                    (double[]){view->grid, view->grid + share * view->tall},
                    (Pen){LINE_SOLID, letter, style, RANK_BAND, fill});
}

/* What a node of a bar has: its support, its mass (of a row what it shares with the chosen one) and momentum,
 * and the vector that the stage makes or goes by, the longest of all a little less than half a cell. */
static void add_bars(const CellView *view, Picture *picture, size_t node, double x)
{
    const double mass = is_in_row(view, node) ? view->row.masses[node - view->row.first]
                        : view->masses        ? 0
                                              : view->node_masses[node];
    const char *vector = !view->done || view->wiped ? NULL
                         : text_has_word(view->stage->writes, "f") || text_has_word(view->stage->reads, "f")
                             ? "f"
                         : text_has_word(view->stage->reads, "velocity") ? "velocity"
                                                                         : NULL;
    const int field = vector && !view->masses ? simulation_find_field(view->sim, 1, vector) : -1;
    double most = 0;
    if (simulation_named(view->sim, 1, "fixed", node) > 0) {
        const double side = node < view->sim->counts[1] / 2 ? -0.19 : 0.02;
        picture_box(picture, (double[]){x + side * view->spacing, x + (side + 0.06) * view->spacing},
                    (double[]){0.5, view->grid}, (Pen){LINE_SOLID, '%', STYLE_FRAME, RANK_BAND, 1});
    }
    add_bar(view, picture, x, -0.11, view->most_mass > 0 ? mass / view->most_mass : 0, 'm',
            style_of_masses(view), 0);
    if (view->most_momentum > 0 && !view->masses)
        add_bar(view, picture, x, -0.06, fabs(view->momenta[node]) / view->most_momentum, 'p',
                style_of_momenta(view), 1);
    for (size_t i = 0; field >= 0 && i < view->sim->counts[1]; i++)
        most = fmax(most, fabs(simulation_value(view->sim, field, i)));
    const double share = most > 0 ? simulation_value(view->sim, field, node) / most : 0;
    const double from = x - (share < 0 ? 0.13 * view->spacing : 0);
    if (fabs(share) >= 0.02)
        picture_arrow(picture,
                      &(PictureArrow){.from = {from, view->grid + 0.7},
                                      .to = {from + 0.35 * share * view->spacing, view->grid + 0.7},
                                      .style = is_link(view, 1, node) ? STYLE_CHANGED : STYLE_NORMAL});
}

/* --- contact, and nodes ------------------------------------------------------------------------ */

/* From the node that is drawn, as long as its share of `length`. */
static void add_vector(const CellView *view, Picture *picture, const double vector[2], double length,
                       Style style, const char *name, const char *told)
{
    PictureArrow arrow = {.style = style, .place = 0.8};
    place_of(view, 1, (size_t)view->met, arrow.from);
    for (int d = 0; d < 2; d++)
        arrow.to[d] = arrow.from[d] + length * vector[d];
    snprintf(arrow.text[0], sizeof arrow.text[0], "%.40s", name);
    snprintf(arrow.brief[0], sizeof arrow.brief[0], "%.30s", name);
    snprintf(arrow.told, sizeof arrow.told, "%s: %s %s, %s", told, name, text_fitted(vector[0], 3, 8).text,
             text_fitted(vector[1], 3, 8).text);
    picture_arrow(picture, &arrow);
}

/* At a node that another body shares: its number too, the common normal and what contact gives; at the one
 * that matters most to the chosen particle also as arrows, with both velocities before. */
static void add_contact(const CellView *view, Picture *picture, size_t node, PictureLabel *label)
{
    static const char *const fields[3][2] = {{"px", "py"}, {"nx", "ny"}, {"mass", "mass"}};
    const Simulation *sim = view->sim;
    const long other = other_at(view, node);
    if (other < 0)
        return;
    const size_t both[2] = {node, (size_t)other};
    double v[2][2], gives[2], n[2] = {0, 0}, fastest = 0;
    for (int k = 1; k >= 0; k--) {
        for (int d = 0; d < 2; d++) {
            const int momentum = simulation_find_field(sim, 1, fields[0][d]);
            const double now = simulation_value(sim, momentum, both[k]);
            double before = now;
            experiment_field_before(view->screen->experiment, momentum, both[k], 1, &before);
            v[k][d] = before / simulation_named(sim, 1, "mass", both[k]);
            gives[d] = before - now;
            n[d] += (k ? -1 : 1) * simulation_named(sim, 1, fields[1][d], both[k]);
        }
        fastest = fmax(fastest, math_hypot(v[k][0], v[k][1]));
    }
    const double length = math_hypot(n[0], n[1]), size = math_hypot(gives[0], gives[1]);
    for (int d = 0; d < 2; d++)
        n[d] = length > 0 ? n[d] / length : 0; /* 0 0: there is none */
    text_append(label->text, sizeof label->text, " | %zu\nn %s", both[1], text_fitted(n[0], 3, 6).text);
    text_append(label->text, sizeof label->text, " %s\n%s", text_fitted(n[1], 3, 6).text,
                size > 0 ? "gives " : "gives nothing");
    if (size > 0)
        text_append(label->text, sizeof label->text, "%s %s", text_fitted(gives[0], 4, 9).text,
                    text_fitted(gives[1], 4, 9).text);
    label->style = size > 0 ? STYLE_CHANGED : STYLE_NORMAL;
    if ((long)node != view->met)
        return;
    char told[64];
    snprintf(told, sizeof told, "node %zu", node);
    add_vector(view, picture, (double[]){n[0], n[1]}, 0.45 * view->spacing, STYLE_CHANGED, "n", told);
    for (int k = 0; k < 2; k++) {
        const double body = simulation_named(sim, 1, "body", both[k]);
        snprintf(told, sizeof told, "node %zu, %s", both[k], name_of_body(view, body));
        add_vector(view, picture, v[k], fastest > 0 ? 0.4 * view->spacing / fastest : 0,
                   picture_kind_style((int)body), "v", told);
    }
}

static void add_node(const CellView *view, Picture *picture, size_t node)
{
    const bool own = is_own(view, 1, node), linked = is_link(view, 1, node), line = view->line;
    const Style there = experiment_stage(view->screen->experiment) > 0 ? STYLE_NORMAL : STYLE_FAINT;
    double at[2], beside[2];
    place_of(view, 1, node, at);
    place_of(view, view->set, view->index, beside);
    const Style words = own ? STYLE_SELECTED : linked ? STYLE_NORMAL : STYLE_FAINT;
    PictureLabel *label = picture_label(picture, at[0], line ? NUMBER_ROW : at[1],
                                        !line && at[0] < beside[0] ? -1 : 1, words, "%zu", node);
    label->thing = "node";
    label->says_thing = true;
    const Pen pen = {LINE_SOLID, '|', line ? there : STYLE_FRAME, RANK_GHOST, 0};
    picture_line(picture, at[0], line ? view->grid - 0.4 : view->low[1], at[0],
                 line ? view->grid + 0.4 : view->high[1], pen);
    if (line)
        add_bars(view, picture, node, at[0]);
    else
        picture_line(picture, view->low[0], at[1], view->high[0], at[1],
                     (Pen){LINE_SOLID, '-', STYLE_FRAME, RANK_GHOST, 0});
    if (view->meets)
        add_contact(view, picture, node, label);
    node_numbers(view, node, label->text, sizeof label->text);
    picture_thing(picture, at[0], at[1],
                  own || (!line && linked) ? 0x25a0
                  : linked                 ? 0x25cf
                                           : 0x253c,
                  own || (!line && linked) ? STYLE_CHANGED : there, (PictureThing){1, node});
}

/* --- particles, and what passes ---------------------------------------------------------------------- */

static void add_particle(const CellView *view, Picture *picture, size_t particle)
{
    const bool own = is_own(view, 0, particle), linked = is_link(view, 0, particle);
    double at[2];
    place_of(view, 0, particle, at);
    const Style style = own ? STYLE_CHANGED
                        : simulation_has(view->sim, HAS_BODIES)
                            ? picture_kind_style((int)simulation_named(view->sim, 0, "body", particle))
                        : linked ? STYLE_MEASURED
                                 : STYLE_FAINT;
    picture_thing(picture, at[0], at[1], own || (linked && view->set) ? 0x25cf : 0x25cb, style,
                  (PictureThing){0, particle});
    if (!own && view->meets)
        return;
    const Style words = own ? STYLE_SELECTED : linked ? STYLE_NORMAL : STYLE_FAINT;
    PictureLabel *label = picture_label(picture, at[0], at[1], 1, words, "%zu", particle);
    label->spare = !own && !(view->line && linked);
    label->thing = "particle";
    if (own && view->line && (view->to_nodes || view->n_flows == 0))
        add_value(view->screen, 0, particle, "x", "x", false, label->text, sizeof label->text);
    for (int f = 0; f < view->n_flows && own && !view->to_nodes; f++) {
        const char *field = view->flows[f].exchange->field;
        const int index = simulation_find_field(view->sim, 0, field);
        if (index >= 0)
            add_value(view->screen, 0, particle, field, view->sim->fields[index].quantity.label,
                      view->line || view->flows[f].exchange->adds, label->text, sizeof label->text);
    }
}

/* The way that the stage passes something, with the terms of the strongest; between steps to all links. */
static void add_arrow(const CellView *view, Picture *picture, size_t rank)
{
    const size_t link = view->order[rank], other = view->links[link].index;
    const size_t particle = view->set ? other : view->index, node = view->set ? view->index : other;
    const bool taken = view->n_flows > 0 && !view->to_nodes, named = view->n_flows > 0 && rank < view->shown;
    PictureArrow arrow = {.style = named ? STYLE_CHANGED : STYLE_FAINT};
    double ends[2][2];
    place_of(view, 0, particle, ends[taken]);
    place_of(view, 1, node, ends[!taken]);
    if (view->line) /* at the side of the tick from which it comes */
        ends[!taken][0] += (ends[taken][0] < ends[!taken][0] ? -0.03 : 0.03) * view->spacing;
    for (int d = 0; d < 2; d++) {
        arrow.from[d] = ends[0][d] + ENDS * (ends[1][d] - ends[0][d]);
        arrow.to[d] = ends[1][d] - ENDS * (ends[1][d] - ends[0][d]);
    }
    /* nearer to the other end, where arrows are apart; in the plane beside it */
    arrow.place = (view->set == 0) == view->to_nodes ? 0.62 : 0.38;
    if (named) {
        const char *giver = view->to_nodes ? "particle" : "node",
                   *taker = view->to_nodes ? "node" : "particle";
        snprintf(arrow.told, sizeof arrow.told, "%s %zu gives to %s %zu", giver,
                 view->to_nodes ? particle : node, taker, view->to_nodes ? node : particle);
    }
    for (int f = 0; f < view->n_flows && named; f++) {
        const Flowing *flow = &view->flows[f];
        char words[32];
        strcpy(arrow.brief[f], term_text(flow->terms[link], flow->writing).text);
        snprintf(arrow.text[f], sizeof arrow.text[f], "%s %.20s", flow->exchange->factors, arrow.brief[f]);
        text_to_ascii(flow->exchange->factors, words, sizeof words);
        text_append(arrow.told, sizeof arrow.told, "%s %s = %.20s", f ? " and" : "", words, arrow.brief[f]);
    }
    if (named && !view->line) {
        double own[2];
        place_of(view, 1 - view->set, other, arrow.at);
        place_of(view, view->set, view->index, own);
        arrow.side = arrow.at[0] < own[0] ? 1 : -1;
        if (picture->rows < LOW_ROWS)
            arrow.text[1][0] = '\0';
    }
    picture_arrow(picture, &arrow);
}

/* M v = p at the chosen node: what each node of the row brings in. */
static void add_row(const CellView *view, Picture *picture)
{
    double terms[2 * MASSES_BESIDE_MAX + 1], sum = 0, own[2], at[2];
    place_of(view, 1, view->index, own);
    for (size_t k = 0; k < view->row.count; k++)
        sum += terms[k] =
            view->row.masses[k] * simulation_named(view->sim, 1, "velocity", view->row.first + k);
    const Writing writing = writing_of(terms, view->row.count, 0, sum, TERM_WIDTH);
    for (size_t k = 0; k < view->row.count; k++) {
        const size_t node = view->row.first + k;
        const double apart = fabs((double)node - (double)view->index), y = view->grid - 1 - 1.2 * apart;
        const double aside = apart > 0 ? (node < view->index ? -0.06 : 0.06) * view->spacing : 0;
        place_of(view, 1, node, at);
        PictureArrow arrow = {.style = STYLE_CHANGED,
                              .from = {at[0], apart > 0 ? y : DOTS_ROW + 1},
                              .to = {own[0] + aside, y},
                              .place = apart > 0 ? 0.4 : 0.5};
        strcpy(arrow.brief[0], term_text(terms[k], writing).text);
        snprintf(arrow.text[0], sizeof arrow.text[0], "M v %.20s", arrow.brief[0]);
        snprintf(arrow.told, sizeof arrow.told, "node %zu brings M v = %.20s into node %zu", node,
                 arrow.brief[0], view->index);
        picture_arrow(picture, &arrow);
    }
}

/* "0.1875 + 0.625 + 0.1875 = 1" */
static void tell_row(const CellView *view, Picture *picture)
{
    const NumberText sum = text_fitted(view->row_sum, 5, 10);
    double at[2];
    place_of(view, 1, view->index, at);
    char text[sizeof picture->labels[0].text] = "";
    if (view->row.count == 1)
        snprintf(text, sizeof text, "lumped: all of %s\nis the node's own", sum.text);
    else {
        for (size_t k = 0; k < view->row.count; k++)
            text_append(text, sizeof text, "%s%s", k ? " + " : "",
                        term_text(view->row.masses[k], view->row_writing).text);
        text_append(text, sizeof text, " = %s", sum.text);
    }
    picture_label(picture, at[0], 3.2, 0, STYLE_CHANGED, "%s", text);
}

/* --- words ----------------------------------------------------------------------------------------- */

/* As many lines as it needs, broken where the box breaks it: not at a no-break space. */
static void add_spare(Picture *picture, const char *text)
{
    while (*text) {
        char plain[PICTURE_TEXT_MAX];
        const char *rest;
        size_t used = 0;
        const char *end = text + glyphs_line(text, picture->columns - 2, &rest);
        for (; text < end && used + 1 < sizeof plain; text++) {
            const bool held = strncmp(text, "\u00a0", 2) == 0;
            plain[used++] = held ? ' ' : *text;
            text += held;
        }
        plain[used] = '\0';
        picture_note(picture, STYLE_NORMAL, "%s", plain)->spare = true;
        text = rest;
    }
}

/* The equation of the stage and its sums, where no box has them. */
static void add_sums(const CellView *view, Picture *picture)
{
    enum { SUMS_MAX = 4096, LINES_MAX = 4 };
    const Simulation *sim = view->sim;
    char sums[SUMS_MAX] = "", text[PICTURE_TEXT_MAX], *rest;
    snprintf(text, sizeof text, "%.*s", (int)strcspn(view->stage->equation, "\n"), view->stage->equation);
    add_spare(picture, text);
    if (!view->done || !sim->method->explain)
        return;
    sim->method->explain(sim, (int)(view->stage - sim->stages), view->set, view->index,
                         experiment_before(view->screen->experiment), picture->columns / 16, sums,
                         sizeof sums);
    int lines = 0;
    for (char *line = strtok_r(sums, "\n", &rest); line && lines < LINES_MAX;
         line = strtok_r(NULL, "\n", &rest), lines++)
        add_spare(picture, line);
}

/* What a picture of a plane without terms means; NULL: it has terms. */
static const char *note_of(const CellView *view)
{
    const bool over = view->stage == &view->sim->stages[view->sim->n_stages - 1];
    return view->line || view->running ? NULL
           : view->n_links == 0
               ? (view->set ? "no particle is near: this node is empty" : "this particle sees no nodes")
           : !view->done || view->n_flows > 0 ? NULL
           : over
               ? LONG_SHORT("the step is over: the particles are where it has moved them", "the step is over")
           : view->met >= 0
               ? LONG_SHORT("n from this body to the other; v of each before; what it gives the other",
                            "n: to the other body; v: before")
           : view->meets ? "no other body shares these nodes"
                         : LONG_SHORT("nothing passes between particles and nodes in this stage",
                                      "nothing passes in this stage");
}

/* --- the whole ------------------------------------------------------------------------------------- */

/* The chosen one first, then what it is linked with: where there is little room it is named. Nodes of a plane
 * that it is not linked with are left out, in a low pane particles too: the terms are there. */
static void add_things(const CellView *view, Picture *picture)
{
    double at[2];
    (view->set ? add_node : add_particle)(view, picture, view->index);
    for (int linked = 1; linked >= 0; linked--)
        for (int set = 1; set >= 0; set--)
            for (size_t i = 0; i < view->sim->counts[set]; i++) {
                place_of(view, set, i, at);
                const bool in_sight = at[0] > view->low[0] && at[0] < view->high[0] && at[1] > view->low[1] &&
                                      at[1] < view->high[1];
                const bool left_out =
                    !view->line && !linked && (set || (view->n_flows > 0 && picture->rows < LOW_ROWS));
                if (in_sight && !is_own(view, set, i) && is_link(view, set, i) == linked && !left_out)
                    (set ? add_node : add_particle)(view, picture, i);
            }
}

static void describe_mesh(const CellView *view, Picture *picture)
{
    const RowList *bodies = &experiment_settings(view->screen->experiment)->rows[ROWS_BODIES];
    char name[PICTURE_TEXT_MAX], rest[sizeof picture->labels[0].text] = "";
    const double cell = simulation_named(view->sim, view->set, "cell", view->index);
    snprintf(name, PICTURE_TEXT_MAX, "%s %zu", view->sim->sets[view->set].name, view->index);
    if (view->n_flows > 0 && !view->line) /* numbers of a plane have no words of their own */
        text_append(name, PICTURE_TEXT_MAX, ", %s", view->flows[0].exchange->factors);
    if (view->masses)
        text_append(name, PICTURE_TEXT_MAX,
                    view->has_row ? ", its row of the mass matrix M" : ": masses are mapped in stage 1");
    else if (!view->running)
        text_append(name, PICTURE_TEXT_MAX, ", %sstage %d: %s", view->done ? "" : "next ",
                    (int)(view->stage - view->sim->stages) + 1, view->stage->name);
    if (simulation_has(view->sim, HAS_BODIES))
        text_append(name, PICTURE_TEXT_MAX, ", of %s",
                    name_of_body(view, simulation_named(view->sim, view->set, "body", view->index)));
    if (!view->line && isfinite(cell))
        text_append(name, PICTURE_TEXT_MAX, ", in cell %.0f", cell);
    picture->kind = PICTURE_DRAWING;
    picture->bare = true;
    picture_axes(picture, axis_make(view->low[0], view->high[0]), "x", "",
                 axis_make(view->low[1], view->high[1]), name, "");
    if (view->line)
        picture_line(picture, view->low[0], view->grid, view->high[0], view->grid,
                     (Pen){LINE_SOLID, '-', STYLE_FRAME, RANK_GHOST, 0});
    add_things(view, picture);
    for (size_t rank = 0; rank < (view->line ? view->shown : view->n_links); rank++)
        if (view->n_flows > 0 || (!view->done && !view->running && !view->masses))
            add_arrow(view, picture, rank);
    /* The weaker ones, each exchange as one number: "5 more: m v N 0.01, m N 0.2". */
    for (int f = 0; f < view->n_flows && view->shown < view->n_links; f++) {
        double sum = 0;
        for (size_t i = view->shown; i < view->n_links; i++)
            sum += view->flows[f].terms[view->order[i]];
        if (f == 0)
            text_append(rest, sizeof rest, "%zu more: ", view->n_links - view->shown);
        text_append(rest, sizeof rest, "%s%s %s", f ? ", " : "", view->flows[f].exchange->factors,
                    term_text(sum, view->flows[f].writing).text);
    }
    if (rest[0])
        picture_label(picture, view->low[0], (view->low[1] + view->high[1]) / 2, 1, STYLE_CHANGED, "%s",
                      rest);
    if (view->has_row)
        (view->masses ? tell_row : add_row)(view, picture);
    if (view->line)
        picture_key(picture, (PictureKey){LINE_SOLID, 'm', style_of_masses(view), "mass", SIGN_BAND, 0});
    if (view->line && !view->masses)
        picture_key(picture,
                    (PictureKey){LINE_SOLID, 'p', style_of_momenta(view), "|momentum|", SIGN_BAND, 1});
    for (int body = 0; simulation_has(view->sim, HAS_BODIES) && body < bodies->count; body++)
        picture_key(picture, (PictureKey){LINE_SOLID, 'o', picture_kind_style(body), bodies->rows[body].name,
                                          0x25cb, 0});
    if (note_of(view))
        picture_note(picture, STYLE_FAINT, "%s", note_of(view));
    if (!view->running && !view->masses)
        add_sums(view, picture);
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    CellView view = {0};
    if (simulation_has(sim, HAS_BONDS))
        cell_bonds_describe(screen, variant, picture);
    else if (!simulation_has(sim, HAS_MESH) || sim->counts[0] < 1 || sim->counts[1] < 2)
        picture_say(picture, "one cell", "There is neither a mesh nor a bond.");
    else if (look(&view, screen, variant == 1))
        describe_mesh(&view, picture);
    free(view.node_masses);
}

static const char *word_of(const Screen *screen, int variant)
{
    static const char *const words[][3] = {{"bond", "family"}, {"terms", "masses"}, {"terms"}};
    const Simulation *sim = experiment_simulation(screen->experiment);
    return words[simulation_has(sim, HAS_BONDS)             ? 0
                 : simulation_has(sim, HAS_MESH | HAS_LINE) ? 1
                                                            : 2][variant];
}

const View view_cell = {
    .word = "cell",
    .help = "one cell from near, with the terms of a stage, or one bond; again: masses, or the family",
    .home = PANE_UPPER,
    .describe = describe,
    .variant_word = word_of,
    .duel = DUEL_APART,
    .is_wide = true,
};

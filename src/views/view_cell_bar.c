/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A bar's cell from near: two or three cells of its mesh with their nodes and particles, and the terms that
 * pass between the chosen one and the others in the stage that the box speaks of, each on its arrow. What is
 * not of the stage is faint. The terms are the method's own (Simulation.exchanges), written so that they add
 * up as they stand. */
#include "panes/screen.h"
#include "views/cell_terms.h"
#include "views/inspector/inspector.h"
#include "views/view.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SHOWN_MAX = 8 };

/* Heights in the drawing: the bars of a node stand on the line of the grid, its numbers beside them. */
#define ROWS       12.0
#define NUMBER_ROW 11.8
#define VECTOR_ROW 9.2
#define UPPER_END  7.5 /* of arrows between nodes and particles */
#define LOWER_END  2.6
#define DOTS_ROW   1.6

/* --- what is there --------------------------------------------------------------------------------- */

typedef struct CellView {
    const Screen *screen;
    const Simulation *sim;
    int stage;
    bool done, running;
    bool wiped; /* the grid was put back in the last stage: what it held is drawn as it was */
    CellTerms terms;
    bool masses; /* where the mass of the chosen node sits, not what the stage passes */
    bool has_row;
    MassRow row; /* of the mass matrix */
    double low, high, spacing;
    double *node_masses, *momenta, most_mass, most_momentum; /* of all nodes, in one block */
} CellView;

static double node_at(const CellView *near, size_t node)
{
    return simulation_named(near->sim, 1, "x", node);
}

static double particle_at(const CellView *near, size_t particle)
{
    return simulation_value(near->sim, near->sim->position[0], particle) +
           simulation_value(near->sim, near->sim->displacement[0], particle);
}

static double place_of(const CellView *near, int set, size_t index)
{
    return set ? node_at(near, index) : particle_at(near, index);
}

static bool is_link(const CellView *near, int set, size_t index)
{
    for (size_t i = 0; i < near->terms.n_links && set != near->terms.set; i++)
        if (near->terms.links[i].index == index)
            return true;
    return set == near->terms.set && index == near->terms.index;
}

/* From beyond the first to beyond the last link, two or three cells of a hat. */
static void find_sides(CellView *near)
{
    const size_t nodes = near->sim->counts[1], middle = nodes / 2;
    const double own = place_of(near, near->terms.set, near->terms.index);
    near->spacing = node_at(near, middle) - node_at(near, middle - 1);
    near->low = near->high = own;
    for (size_t i = 0; i < near->terms.n_links; i++) {
        const double at = place_of(near, 1 - near->terms.set, near->terms.links[i].index);
        near->low = fmin(near->low, at);
        near->high = fmax(near->high, at);
    }
    if (near->terms.set == 1) {
        near->low = fmin(near->low, own - near->spacing);
        near->high = fmax(near->high, own + near->spacing);
    }
    for (size_t k = 0; k < near->row.count; k++)
        if (near->row.masses[k] != 0) {
            const double at = node_at(near, near->row.first + k);
            near->low = fmin(near->low, at);
            near->high = fmax(near->high, at);
        }
    /* beyond the ends of the mesh there is nothing; numbers of a node stand at its right */
    near->low = fmax(near->low, node_at(near, 0));
    near->high = fmin(near->high, node_at(near, nodes - 1));
    near->low -= (near->terms.set == 1 ? 0.2 : 0.7) * near->spacing;
    near->high += (near->terms.set == 1 ? 0.6 : 0.8) * near->spacing;
}

/* The row of the chosen node, or of the one that the chosen particle gives most to; lumped, all is its own.
 */
static void take_masses(CellView *near)
{
    if (near->terms.set == 0) {
        size_t most = 0;
        for (size_t i = 1; i < near->terms.n_links; i++)
            most = near->terms.links[i].weight > near->terms.links[most].weight ? i : most;
        if (near->terms.n_links == 0)
            return;
        near->terms.set = 1;
        near->terms.index = near->terms.links[most].index;
        cell_terms_find(&near->terms, NULL, SHOWN_MAX);
    }
    const double own = simulation_named(near->sim, 1, "mass", near->terms.index);
    near->has_row = near->done && !near->wiped && own > 0;
    if (near->has_row && !inspector_mass_row(near->sim, 1, near->terms.index, &near->row))
        near->row = (MassRow){near->terms.index, 1, {own}};
}

/* False: no memory. */
static bool look_near(CellView *near, const Screen *screen, bool masses)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    *near = (CellView){
        .screen = screen, .sim = sim, .terms = {.sim = sim, .set = screen->chosen.is_node}, .masses = masses};
    const size_t chosen = near->terms.set ? screen->chosen.node : screen->chosen.particle,
                 count = sim->counts[near->terms.set];
    near->terms.index = chosen < count ? chosen : count - 1;
    near->stage = screen_box_stage(screen, &near->done);
    near->running = screen_is_running(screen);
    near->done &= !near->running;
    near->wiped = near->done && experiment_stage(screen->experiment) == 0;
    cell_terms_find(&near->terms, near->done && !masses ? &sim->stages[near->stage] : NULL, SHOWN_MAX);
    if (masses)
        take_masses(near);
    if (near->terms.set == 1 && near->terms.n_flows == 0 && !masses && near->done && !near->wiped)
        near->has_row = inspector_mass_row(sim, 1, near->terms.index, &near->row);
    find_sides(near);
    near->node_masses = calloc(2 * sim->counts[1] + 1, sizeof *near->node_masses);
    if (!near->node_masses)
        return false;
    near->momenta = near->node_masses + sim->counts[1];
    near->most_mass = screen_node_values(screen, "mass", near->wiped, near->node_masses);
    near->most_momentum = screen_node_values(screen, "momentum", near->wiped, near->momenta);
    return true;
}

/* The line of the grid, and how high a bar on it can be: higher where nothing passes below. */
static double grid_row(const CellView *near)
{
    return near->masses ? 4.4 : 8.5;
}

static double bars_height(const CellView *near)
{
    return near->masses ? 6.2 : 2.4;
}

/* --- numbers --------------------------------------------------------------------------------------- */

/* Whether a stage names a field among those that it writes, or reads. */
static bool names(const char *words, const char *name)
{
    char word[64];
    while (text_next_word(&words, word, sizeof word))
        if (strcmp(word, name) == 0)
            return true;
    return false;
}

static bool writes(const CellView *near, const char *name)
{
    return near->done && !near->wiped && names(near->sim->stages[near->stage].writes, name);
}

/* --- nodes ----------------------------------------------------------------------------------------- */

static const struct {
    const char *field, *label;
} node_values[] = {{"mass", "m"}, {"momentum", "p"}, {"f", "f"}};

static bool is_in_row(const CellView *near, size_t node)
{
    return near->has_row && node >= near->row.first && node < near->row.first + near->row.count;
}

static double sum_of_row(const CellView *near)
{
    double sum = 0;
    for (size_t k = 0; k < near->row.count; k++)
        sum += near->row.masses[k];
    return sum;
}

static Writing writing_of_row(const CellView *near)
{
    return writing_of(near->row.masses, near->row.count, 0, sum_of_row(near), CELL_TERM_WIDTH);
}

/* The last factor of an exchange: what the giver has. */
static const char *last_word(const char *words)
{
    const char *space = strrchr(words, ' ');
    return space ? space + 1 : words;
}

/* What a node has to do with the stage: what the stage writes of it or what it gives in it. */
static void node_numbers(const CellView *near, size_t node, char *out, size_t size)
{
    const bool made = near->terms.n_flows > 0; /* again, by terms that are seen */
    const bool in_row = is_in_row(near, node);
    if (in_row) {
        const double mass = near->row.masses[node - near->row.first];
        text_append(out, size, "\nM %s", cell_term_text(mass, writing_of_row(near)).text);
    }
    if (in_row && !near->masses)
        cell_value_add(near->screen, 1, node, "velocity", "v", false, out, size);
    if (near->masses || (in_row && node != near->terms.index))
        return;
    for (size_t k = 0; k < sizeof node_values / sizeof *node_values; k++)
        if (writes(near, node_values[k].field))
            cell_value_add(near->screen, 1, node, node_values[k].field, node_values[k].label, !made, out,
                           size);
    for (int f = 0; f < near->terms.n_flows && !near->terms.to_nodes; f++) {
        const char *factor = last_word(near->terms.flows[f].exchange->factors);
        if (f > 0 && strcmp(factor, last_word(near->terms.flows[0].exchange->factors)) == 0)
            continue; /* the same velocity moves it */
        for (size_t i = 0; i < near->terms.n_links; i++) {
            const bool given =
                near->terms.set ? node == near->terms.index : near->terms.links[i].index == node;
            if (!given || (near->terms.set && i > 0))
                continue;
            text_append(out, size, "\n%s %s", factor, text_fitted(near->terms.flows[f].last[i], 5, 10).text);
        }
    }
}

static Style style_of_masses(const CellView *near)
{
    return writes(near, "mass") || near->has_row ? STYLE_SECOND : STYLE_FAINT;
}

/* What the bar of a node stands for: its mass or, of a row, what it shares with the chosen one. */
static double mass_beside(const CellView *near, size_t node)
{
    if (is_in_row(near, node))
        return near->row.masses[node - near->row.first];
    return near->masses ? 0 : near->node_masses[node];
}

static Style style_of_momenta(const CellView *near)
{
    return writes(near, "momentum") ? STYLE_PREDICTED : STYLE_FAINT;
}

/* A bar of so much of its band, beside the node. */
static void add_bar(const CellView *near, Picture *picture, double x, double width, double share, Style style,
                    char letter, int fill)
{
    if (!(share > 1e-6))
        return;
    picture_box(picture, (double[]){x, x + width},
                (double[]){grid_row(near), grid_row(near) + share * bars_height(near)},
                (Pen){LINE_SOLID, letter, style, RANK_BAND, fill});
}

/* The vector at the nodes that the stage makes, or goes by. */
static const char *vector_of(const CellView *near)
{
    const Stage *stage = &near->sim->stages[near->stage];
    if (!near->done || near->wiped)
        return NULL;
    if (names(stage->writes, "f") || names(stage->reads, "f"))
        return "f";
    return names(stage->reads, "velocity") ? "velocity" : NULL;
}

/* To the side that it pulls or moves to, the longest of all nodes a little less than half a cell. */
static void add_vector(const CellView *near, Picture *picture, size_t node, double most)
{
    const double value = vector_of(near) ? simulation_named(near->sim, 1, vector_of(near), node) : 0;
    const double x = node_at(near, node), share = most > 0 ? value / most : 0;
    if (!(fabs(share) >= 0.02))
        return;
    PictureArrow arrow = {.from = {x, VECTOR_ROW},
                          .to = {x + 0.42 * share * near->spacing, VECTOR_ROW},
                          .style = is_link(near, 1, node) ? STYLE_CHANGED : STYLE_NORMAL};
    picture_arrow(picture, &arrow);
}

static void add_support(const CellView *near, Picture *picture, size_t node)
{
    if (!(simulation_named(near->sim, 1, "fixed", node) > 0))
        return;
    const double x = node_at(near, node), side = node < near->sim->counts[1] / 2 ? -0.08 : 0.02;
    picture_box(picture, (double[]){x + side * near->spacing, x + (side + 0.06) * near->spacing},
                (double[]){0.5, grid_row(near)}, (Pen){LINE_SOLID, '%', STYLE_FRAME, RANK_BAND, 1});
}

static void add_node(const CellView *near, Picture *picture, size_t node, double most)
{
    const double x = node_at(near, node);
    const bool own = near->terms.set == 1 && node == near->terms.index, linked = is_link(near, 1, node);
    const bool there = experiment_stage(near->screen->experiment) > 0;
    const Style style = own ? STYLE_SELECTED : linked ? STYLE_NORMAL : STYLE_FAINT;
    const Pen pen = {LINE_SOLID, '|', there ? STYLE_NORMAL : STYLE_FAINT, RANK_GHOST, 0};
    PictureLabel label = {
        .x = x, .y = NUMBER_ROW, .side = 1, .style = style, .thing = "node", .says_thing = true};
    picture_line(picture, x, grid_row(near) - 0.4, x, grid_row(near) + 0.4, pen);
    add_support(near, picture, node);
    add_bar(near, picture, x - 0.05 * near->spacing, 0.04 * near->spacing,
            near->most_mass > 0 ? mass_beside(near, node) / near->most_mass : 0, style_of_masses(near), 'm',
            0);
    add_bar(near, picture, x + 0.01 * near->spacing, 0.04 * near->spacing,
            near->most_momentum > 0 && !near->masses ? fabs(near->momenta[node]) / near->most_momentum : 0,
            style_of_momenta(near), 'p', 1);
    add_vector(near, picture, node, most);
    picture_thing(picture, x, grid_row(near),
                  own      ? 0x25a0
                  : linked ? 0x25cf
                           : 0x253c,
                  own ? STYLE_CHANGED : pen.style, (PictureThing){1, node});
    snprintf(label.text, sizeof label.text, "%zu", node);
    node_numbers(near, node, label.text, sizeof label.text);
    picture_label(picture, &label);
}

/* --- particles ------------------------------------------------------------------------------------- */

static void add_particle(const CellView *near, Picture *picture, size_t particle)
{
    const bool own = near->terms.set == 0 && particle == near->terms.index,
               linked = is_link(near, 0, particle);
    const double x = particle_at(near, particle);
    const Style style = own ? STYLE_SELECTED : linked ? STYLE_NORMAL : STYLE_FAINT;
    PictureLabel label = {
        .x = x, .y = DOTS_ROW, .side = 1, .spare = !own && !linked, .style = style, .thing = "particle"};
    picture_thing(picture, x, DOTS_ROW, own || (linked && near->terms.set) ? 0x25cf : 0x25cb,
                  own      ? STYLE_CHANGED
                  : linked ? STYLE_MEASURED
                           : STYLE_FAINT,
                  (PictureThing){0, particle});
    snprintf(label.text, sizeof label.text, "%zu", particle);
    if (own && (near->terms.to_nodes || near->terms.n_flows == 0))
        cell_value_add(near->screen, 0, particle, "x", "x", false, label.text, sizeof label.text);
    for (int f = 0; f < near->terms.n_flows && own && !near->terms.to_nodes; f++) {
        const char *field = near->terms.flows[f].exchange->field;
        const int at = simulation_find_field(near->sim, 0, field);
        if (at >= 0)
            cell_value_add(near->screen, 0, particle, field, near->sim->fields[at].quantity.label, true,
                           label.text, sizeof label.text);
    }
    picture_label(picture, &label);
}

/* --- what passes ----------------------------------------------------------------------------------- */

static void add_arrow(const CellView *near, Picture *picture, size_t link)
{
    const size_t other = near->terms.links[link].index;
    const size_t particle = near->terms.set ? other : near->terms.index,
                 node = near->terms.set ? near->terms.index : other;
    const double below = particle_at(near, particle), above = node_at(near, node);
    const double aside = below < above ? -0.03 : 0.03;
    PictureArrow arrow = {.style = STYLE_CHANGED};
    const double ends[2][2] = {{below, LOWER_END}, {above + aside * near->spacing, UPPER_END}};
    memcpy(arrow.from, ends[!near->terms.to_nodes], sizeof arrow.from);
    memcpy(arrow.to, ends[near->terms.to_nodes], sizeof arrow.to);
    /* nearer to the other end, where arrows are apart */
    arrow.place = (near->terms.set == 0) == near->terms.to_nodes ? 0.62 : 0.38;
    cell_terms_arrow(&near->terms, link, &arrow);
    picture_arrow(picture, &arrow);
}

/* M v = p at the chosen node: what each node of the row brings in. */
static void add_row(const CellView *near, Picture *picture)
{
    double terms[2 * MASSES_BESIDE_MAX + 1], sum = 0;
    for (size_t k = 0; k < near->row.count; k++)
        sum += terms[k] =
            near->row.masses[k] * simulation_named(near->sim, 1, "velocity", near->row.first + k);
    const Writing writing = writing_of(terms, near->row.count, 0, sum, CELL_TERM_WIDTH);
    for (size_t k = 0; k < near->row.count; k++) {
        const size_t node = near->row.first + k;
        const double x = node_at(near, node), own = node_at(near, near->terms.index);
        const double apart = node > near->terms.index ? (double)(node - near->terms.index)
                                                      : (double)(near->terms.index - node);
        const double y = UPPER_END - 1.2 * apart, aside = node < near->terms.index ? -0.06 : 0.06;
        PictureArrow arrow = {
            .style = STYLE_CHANGED,
            .from = {x, apart > 0 ? y : LOWER_END},
            .to = {apart > 0 ? own + aside * near->spacing : own, apart > 0 ? y : UPPER_END},
            .place = apart > 0 ? 0.4 : 0.5};
        strcpy(arrow.brief[0], cell_term_text(terms[k], writing).text);
        snprintf(arrow.text[0], sizeof arrow.text[0], "M v %.20s", arrow.brief[0]);
        snprintf(arrow.told, sizeof arrow.told, "node %zu brings M v = %.20s into node %zu", node,
                 arrow.brief[0], near->terms.index);
        picture_arrow(picture, &arrow);
    }
}

/* "0.1875 + 0.625 + 0.1875 = 1" */
static void tell_row(const CellView *near, Picture *picture)
{
    PictureLabel label = {.x = node_at(near, near->terms.index), .y = 3.2, .style = STYLE_CHANGED};
    const NumberText sum = text_fitted(sum_of_row(near), 5, 10);
    char line[sizeof label.text - 24] = "";
    const Writing writing = writing_of_row(near);
    for (size_t k = 0; k < near->row.count; k++)
        text_append(line, sizeof line, "%s%s", k ? " + " : "",
                    cell_term_text(near->row.masses[k], writing).text);
    if (near->row.count == 1)
        snprintf(label.text, sizeof label.text, "lumped: all of %s\nis the node's own", sum.text);
    else
        snprintf(label.text, sizeof label.text, "%s = %s", line, sum.text);
    picture_label(picture, &label);
}

/* The weaker ones as one number. */
static void tell_rest(const CellView *near, Picture *picture)
{
    char text[sizeof(PictureLabel){0}.text];
    cell_terms_rest(&near->terms, text, sizeof text);
    if (!text[0])
        return;
    PictureLabel label = {
        .x = near->low, .y = (UPPER_END + LOWER_END) / 2, .side = 1, .style = STYLE_CHANGED};
    snprintf(label.text, sizeof label.text, "%s", text);
    picture_label(picture, &label);
}

/* --- words ----------------------------------------------------------------------------------------- */

static void name_of(const CellView *near, char out[PICTURE_TEXT_MAX])
{
    const Simulation *sim = near->sim;
    snprintf(out, PICTURE_TEXT_MAX, "%s %zu", sim->sets[near->terms.set].name, near->terms.index);
    if (near->masses)
        text_append(out, PICTURE_TEXT_MAX,
                    near->has_row ? ", its row of the mass matrix M" : ": masses are mapped in stage 1");
    else if (!near->running)
        text_append(out, PICTURE_TEXT_MAX, ", %sstage %d: %s", near->done ? "" : "next ", near->stage + 1,
                    sim->stages[near->stage].name);
}

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
        picture_note(picture, STYLE_NORMAL, plain)->spare = true;
        text = rest;
    }
}

/* The equation of the stage and its sums, where no box has them. */
static void add_sums(const CellView *near, Picture *picture)
{
    enum { SUMS_MAX = 4096, LINES_MAX = 3 };
    const Simulation *sim = near->sim;
    const char *equation = sim->stages[near->stage].equation;
    char sums[SUMS_MAX] = "", text[PICTURE_TEXT_MAX], *rest;
    snprintf(text, sizeof text, "%.*s", (int)strcspn(equation, "\n"), equation);
    add_spare(picture, text);
    if (!near->done || !sim->method->explain)
        return;
    sim->method->explain(sim, near->stage, near->terms.set, near->terms.index,
                         experiment_before(near->screen->experiment), picture->columns / 16, sums,
                         sizeof sums);
    int lines = 0;
    for (char *line = strtok_r(sums, "\n", &rest); line && lines < LINES_MAX;
         line = strtok_r(NULL, "\n", &rest), lines++)
        add_spare(picture, line);
}

/* --- the whole ------------------------------------------------------------------------------------- */

static void describe_near(const CellView *near, Picture *picture)
{
    const Simulation *sim = near->sim;
    const int vector = vector_of(near) ? simulation_find_field(sim, 1, vector_of(near)) : -1;
    char name[PICTURE_TEXT_MAX];
    double most = 0;
    name_of(near, name);
    picture->kind = PICTURE_DRAWING;
    picture->bare = true;
    picture_axes(picture, axis_make(near->low, near->high), "x", "", axis_make(0, ROWS), name, "");
    for (size_t i = 0; i < sim->counts[1] && vector >= 0; i++)
        most = fmax(most, fabs(simulation_value(sim, vector, i)));
    picture_line(picture, near->low, grid_row(near), near->high, grid_row(near),
                 (Pen){LINE_SOLID, '-', STYLE_FRAME, RANK_GHOST, 0});
    /* the chosen one first: where there is little room it is named */
    (near->terms.set ? add_node(near, picture, near->terms.index, most)
                     : add_particle(near, picture, near->terms.index));
    for (int linked = 1; linked >= 0; linked--) {
        for (size_t i = 0; i < sim->counts[1]; i++)
            if (is_link(near, 1, i) == linked && !(near->terms.set == 1 && i == near->terms.index) &&
                node_at(near, i) > near->low && node_at(near, i) < near->high)
                add_node(near, picture, i, most);
        for (size_t i = 0; i < sim->counts[0]; i++)
            if (is_link(near, 0, i) == linked && !(near->terms.set == 0 && i == near->terms.index) &&
                particle_at(near, i) > near->low && particle_at(near, i) < near->high)
                add_particle(near, picture, i);
    }
    for (size_t i = 0; i < near->terms.shown && near->terms.n_flows > 0; i++)
        add_arrow(near, picture, near->terms.order[i]);
    tell_rest(near, picture);
    if (near->has_row && near->masses)
        tell_row(near, picture);
    else if (near->has_row)
        add_row(near, picture);
    picture_key(picture, (PictureKey){LINE_SOLID, 'm', style_of_masses(near), "mass", SIGN_BAND, 0});
    if (!near->masses)
        picture_key(picture,
                    (PictureKey){LINE_SOLID, 'p', style_of_momenta(near), "|momentum|", SIGN_BAND, 1});
    if (!near->running && !near->masses)
        add_sums(near, picture);
}

void cell_bar_describe(const Screen *screen, int variant, Picture *picture)
{
    CellView near;
    if (look_near(&near, screen, variant == 1))
        describe_near(&near, picture);
    free(near.node_masses);
}

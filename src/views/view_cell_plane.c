/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cell of a plane mesh from near: the chosen particle, the nodes that it sees and by how much, N, the
 * terms that pass between them in the stage that the box speaks of, the strongest on their arrows, and the
 * particles around it where they are now, those of each body in its colour. Where walls and contact act on
 * nodes, each that two bodies share has the common normal, both velocities before, and what one gives. */
#include "base/math/functions.h"
#include "panes/screen.h"
#include "scenario/settings.h"
#include "views/cell_terms.h"
#include "views/view.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SHOWN_MAX = 4 };

static double node_at(const Simulation *sim, int direction, size_t node)
{
    return simulation_named(sim, 1, direction ? "y" : "x", node);
}

static double particle_at(const Simulation *sim, int direction, size_t particle)
{
    return simulation_value(sim, sim->position[direction], particle) +
           simulation_value(sim, sim->displacement[direction], particle);
}

/* The nodes that it sees, and a share of a cell around them. */
static void find_sides(const Simulation *sim, const Link *links, size_t count, double beside, double low[2],
                       double high[2])
{
    const double spacing = node_at(sim, 0, 1) - node_at(sim, 0, 0);
    for (int d = 0; d < 2; d++) {
        low[d] = HUGE_VAL, high[d] = -HUGE_VAL;
        for (size_t i = 0; i < count; i++) {
            low[d] = fmin(low[d], node_at(sim, d, links[i].index));
            high[d] = fmax(high[d], node_at(sim, d, links[i].index));
        }
    }
    low[0] -= beside * spacing, high[0] += beside * spacing;
    low[1] -= 0.25 * spacing, high[1] += 0.25 * spacing;
}

static bool is_near(const double at[2], const double low[2], const double high[2])
{
    return at[0] > low[0] && at[0] < high[0] && at[1] > low[1] && at[1] < high[1];
}

/* The grid lines of the nodes that it sees, each once. */
static void add_grid(Picture *picture, const Simulation *sim, const Link *links, size_t count)
{
    const Axis *x = &picture->plot.x, *y = &picture->plot.y;
    for (size_t i = 0; i < count; i++) {
        const double at[2] = {node_at(sim, 0, links[i].index), node_at(sim, 1, links[i].index)};
        bool drawn[2] = {false, false};
        for (size_t k = 0; k < i; k++)
            for (int d = 0; d < 2; d++)
                drawn[d] |= node_at(sim, d, links[k].index) == at[d];
        if (!drawn[0])
            picture_line(picture, at[0], y->low, at[0], y->high,
                         (Pen){LINE_SOLID, '|', STYLE_FRAME, RANK_GHOST, 0});
        if (!drawn[1])
            picture_line(picture, x->low, at[1], x->high, at[1],
                         (Pen){LINE_SOLID, '-', STYLE_FRAME, RANK_GHOST, 0});
    }
}

/* N, and of the sums that its terms go into what has come together, or what it gives. */
static void add_node(Picture *picture, const Screen *screen, const CellTerms *terms, size_t link)
{
    const Simulation *sim = terms->sim;
    const size_t node = terms->links[link].index;
    const double x = node_at(sim, 0, node), y = node_at(sim, 1, node);
    PictureLabel label = {.x = x,
                          .y = y,
                          .side = x < particle_at(sim, 0, terms->index) ? -1 : 1,
                          .thing = "node",
                          .says_thing = true};
    snprintf(label.text, sizeof label.text, "%zu\nN %s", node,
             text_fitted(terms->links[link].weight, 5, 9).text);
    for (int f = 0; f < terms->n_flows && terms->to_nodes; f++) {
        const char *field = terms->flows[f].exchange->field;
        cell_value_add(screen, 1, node, field, strcmp(field, "mass") == 0 ? "m" : field, false, label.text,
                       sizeof label.text);
    }
    picture_label(picture, &label);
    picture_thing(picture, x, y, 0x25a0, STYLE_CHANGED, (PictureThing){1, node});
}

/* Where a stage passes something the way that it takes, with the terms of the strongest; between steps to all
 * that it sees. */
static void add_arrow(Picture *picture, const CellTerms *terms, size_t rank)
{
    const Simulation *sim = terms->sim;
    const size_t link = terms->order[rank], node = terms->links[link].index;
    const bool taken = terms->n_flows > 0 && !terms->to_nodes;
    PictureArrow arrow = {.style = rank < terms->shown ? STYLE_CHANGED : STYLE_FAINT};
    for (int d = 0; d < 2; d++) {
        const double particle = particle_at(sim, d, terms->index), at = node_at(sim, d, node);
        arrow.from[d] = taken ? at : particle;
        arrow.to[d] = arrow.from[d] + 0.88 * (taken ? particle - at : at - particle);
    }
    if (rank < terms->shown && terms->n_flows > 0) {
        arrow.side = node_at(sim, 0, node) < particle_at(sim, 0, terms->index) ? 1 : -1;
        arrow.at[0] = node_at(sim, 0, node), arrow.at[1] = node_at(sim, 1, node);
        cell_terms_arrow(terms, link, &arrow);
        if (picture_is_low(picture))
            arrow.text[1][0] = '\0';
    }
    picture_arrow(picture, &arrow);
}

/* Which body a particle, or the field of a node, is of. */
static int body_of(const Simulation *sim, int set, size_t index)
{
    return (int)simulation_named(sim, set, "body", index);
}

static const char *name_of_body(const Screen *screen, int body)
{
    return experiment_settings(screen->experiment)->rows[ROWS_BODIES].rows[body].name;
}

/* The node of another body at the same place, where it has mass too; false: there is none. */
static bool find_other(const Simulation *sim, size_t node, size_t *other)
{
    for (*other = 0; *other < sim->counts[1]; ++*other)
        if (node_at(sim, 0, *other) == node_at(sim, 0, node) &&
            node_at(sim, 1, *other) == node_at(sim, 1, node) &&
            body_of(sim, 1, *other) != body_of(sim, 1, node) &&
            simulation_named(sim, 1, "active", *other) > 0)
            return true;
    return false;
}

/* The momentum of a node before the stage and now. */
static void momenta_of(const Screen *screen, size_t node, double before[2], double now[2])
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    for (int d = 0; d < 2; d++) {
        const int field = simulation_find_field(sim, 1, d ? "py" : "px");
        now[d] = before[d] = simulation_value(sim, field, node);
        experiment_field_before(screen->experiment, field, node, 1, &before[d]);
    }
}

/* From a node, as long as its share of `length`. */
static void add_vector(Picture *picture, const double at[2], const double vector[2], double length,
                       Style style, const char *name, const char *told)
{
    PictureArrow arrow = {.from = {at[0], at[1]},
                          .to = {at[0] + length * vector[0], at[1] + length * vector[1]},
                          .style = style,
                          .place = 0.9};
    snprintf(arrow.text[0], sizeof arrow.text[0], "%.40s", name);
    snprintf(arrow.brief[0], sizeof arrow.brief[0], "%.30s", name);
    snprintf(arrow.told, sizeof arrow.told, "%s", told);
    picture_arrow(picture, &arrow);
}

/* What contact does at a node that another body shares; `named`: its arrows are. False: none shares it, or a
 * wall acts there too, so that what a body loses is not what it gives. */
static bool add_contact(Picture *picture, const Screen *screen, size_t node, bool named)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const double spacing = node_at(sim, 0, 1) - node_at(sim, 0, 0);
    const double at[2] = {node_at(sim, 0, node), node_at(sim, 1, node)};
    double v[2][2], given[2], n[2], before[2], now[2], fastest = 0;
    size_t both[2] = {node, 0};
    if (!(simulation_named(sim, 1, "active", node) > 0) || simulation_named(sim, 1, "fixed", node) > 0 ||
        !find_other(sim, node, &both[1]))
        return false;
    for (int k = 0; k < 2; k++) {
        momenta_of(screen, both[k], before, now);
        for (int d = 0; d < 2; d++) {
            v[k][d] = before[d] / simulation_named(sim, 1, "mass", both[k]);
            given[d] = k == 0 ? before[d] - now[d] : given[d];
        }
        fastest = fmax(fastest, math_hypot(v[k][0], v[k][1]));
    }
    for (int d = 0; d < 2; d++)
        n[d] = simulation_named(sim, 1, d ? "ny" : "nx", both[0]) -
               simulation_named(sim, 1, d ? "ny" : "nx", both[1]);
    const double length = math_hypot(n[0], n[1]);
    char text[sizeof((PictureLabel *)0)->text] = "", told[192];
    for (int d = 0; d < 2 && length > 0; d++)
        n[d] /= length;
    snprintf(told, sizeof told, "node %zu: n = %s, %s", node, text_fitted(n[0], 3, 8).text,
             text_fitted(n[1], 3, 8).text);
    add_vector(picture, at, n, 0.45 * spacing, STYLE_CHANGED, named ? "n" : "", told);
    for (int k = 0; k < 2; k++) {
        const int body = body_of(sim, 1, both[k]);
        snprintf(told, sizeof told, "%s at node %zu: v = %s, %s", name_of_body(screen, body), both[k],
                 text_fitted(v[k][0], 4, 9).text, text_fitted(v[k][1], 4, 9).text);
        add_vector(picture, at, v[k], fastest > 0 ? 0.4 * spacing / fastest : 0, picture_kind_style(body),
                   named ? "v" : "", told);
    }
    const bool gives = given[0] != 0 || given[1] != 0;
    text_append(text, sizeof text, "%zu | %zu\nn %s %s\n%s", node, both[1], text_fitted(n[0], 3, 6).text,
                text_fitted(n[1], 3, 6).text, gives ? "gives " : "gives nothing");
    if (gives)
        text_append(text, sizeof text, "%s %s", text_fitted(given[0], 4, 9).text,
                    text_fitted(given[1], 4, 9).text);
    PictureLabel label = {.x = at[0],
                          .y = at[1],
                          .side = at[0] < particle_at(sim, 0, screen->chosen.particle) ? -1 : 1,
                          .style = gives ? STYLE_CHANGED : STYLE_NORMAL,
                          .thing = "node",
                          .says_thing = true};
    snprintf(label.text, sizeof label.text, "%s", text);
    picture_label(picture, &label);
    picture_thing(picture, at[0], at[1], 0x25a0, STYLE_CHANGED, (PictureThing){1, node});
    return true;
}

/* How many links of the particle have a larger share N than this one. */
static size_t heavier_links(const CellTerms *terms, size_t link)
{
    size_t count = 0;
    for (size_t i = 0; i < terms->n_links; i++)
        count += terms->links[i].weight > terms->links[link].weight ||
                 (terms->links[i].weight == terms->links[link].weight && i < link);
    return count;
}

static void add_particle(Picture *picture, const Screen *screen, const CellTerms *terms, size_t particle,
                         bool meets)
{
    const Simulation *sim = terms->sim;
    const bool chosen = particle == terms->index;
    const double at[2] = {particle_at(sim, 0, particle), particle_at(sim, 1, particle)};
    const Style style = chosen                            ? STYLE_CHANGED
                        : simulation_has(sim, HAS_BODIES) ? picture_kind_style(body_of(sim, 0, particle))
                                                          : STYLE_FAINT;
    PictureLabel label = {
        .x = at[0], .y = at[1], .side = 1, .spare = !chosen, .style = style, .thing = "particle"};
    snprintf(label.text, sizeof label.text, "%zu", particle);
    for (int f = 0; f < terms->n_flows && chosen && !terms->to_nodes; f++) {
        const char *field = terms->flows[f].exchange->field;
        cell_value_add(screen, 0, particle, field, field, terms->flows[f].exchange->adds, label.text,
                       sizeof label.text);
    }
    if (chosen || !meets)
        picture_label(picture, &label);
    picture_thing(picture, at[0], at[1], chosen ? 0x25cf : 0x25cb, style, (PictureThing){0, particle});
}

void cell_plane_describe(const Screen *screen, Picture *picture)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const bool running = screen_is_running(screen);
    const int cell = simulation_find_field(sim, 0, "cell");
    CellTerms terms = {.sim = sim,
                       .index = screen->chosen.particle < sim->counts[0] ? screen->chosen.particle : 0};
    bool done;
    const Stage *stage = &sim->stages[screen_box_stage(screen, &done)];
    double low[2], high[2];
    char name[128];
    done &= !running;
    cell_terms_find(&terms, done ? stage : NULL, SHOWN_MAX);
    if (terms.n_links == 0) {
        picture_say(picture, "one cell", "This particle sees no nodes.");
        return;
    }
    find_sides(sim, terms.links, terms.n_links, done ? 0.6 : 0.8, low, high);
    snprintf(name, sizeof name, "particle %zu", terms.index);
    if (terms.n_flows > 0) /* before what may be cut: the numbers stand bare */
        text_append(name, sizeof name, ", %s", terms.flows[0].exchange->factors);
    if (done)
        text_append(name, sizeof name, ", stage %d: %s", (int)(stage - sim->stages) + 1, stage->name);
    else
        text_append(name, sizeof name, " and its nodes, by their shares N");
    const bool bodies = simulation_has(sim, HAS_BODIES),
               meets = bodies && done && strncmp(stage->id, "fix", 3) == 0;
    if (bodies)
        text_append(name, sizeof name, ", of %s", name_of_body(screen, body_of(sim, 0, terms.index)));
    if (cell >= 0)
        text_append(name, sizeof name, ", in cell %.0f", simulation_value(sim, cell, terms.index));
    picture->kind = PICTURE_DRAWING;
    picture->bare = true;
    picture_axes(picture, axis_make(low[0], high[0]), "x", "", axis_make(low[1], high[1]), name, "");
    add_grid(picture, sim, terms.links, terms.n_links);
    size_t shared = 0;
    for (size_t i = 0; i < terms.n_links; i++)
        if (meets && heavier_links(&terms, i) < SHOWN_MAX &&
            add_contact(picture, screen, terms.links[i].index, heavier_links(&terms, i) == 0))
            shared++;
        else
            add_node(picture, screen, &terms, i);
    for (size_t rank = 0; rank < terms.n_links && !running && (!done || terms.n_flows > 0); rank++)
        add_arrow(picture, &terms, rank);
    add_particle(picture, screen, &terms, terms.index, meets);
    /* in a low pane they stand where the terms would */
    for (size_t p = 0; p < sim->counts[0] && (terms.n_flows == 0 || !picture_is_low(picture)); p++)
        if (p != terms.index &&
            is_near((const double[2]){particle_at(sim, 0, p), particle_at(sim, 1, p)}, low, high))
            add_particle(picture, screen, &terms, p, meets);
    PictureLabel rest = {.x = low[0], .y = (low[1] + high[1]) / 2, .side = 1, .style = STYLE_CHANGED};
    cell_terms_rest(&terms, rest.text, sizeof rest.text);
    if (rest.text[0])
        picture_label(picture, &rest);
    if (done && terms.n_flows == 0 && stage == &sim->stages[sim->n_stages - 1])
        picture_note(picture, STYLE_FAINT, "the step is over: the shares N are those of the new place");
    else if (shared > 0)
        picture_note(picture, STYLE_FAINT,
                     "n from this body to the other; v of each before; what it gives the other");
    else if (done && terms.n_flows == 0)
        picture_note(picture, STYLE_FAINT,
                     meets ? "no other body shares these nodes"
                           : "nothing passes between particles and nodes in this stage");
    for (int body = 0; bodies && body < experiment_settings(screen->experiment)->rows[ROWS_BODIES].count;
         body++)
        picture_key(picture, (PictureKey){LINE_SOLID, 'o', picture_kind_style(body),
                                          name_of_body(screen, body), 0x25cb, 0});
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cell of a plane mesh from near: the chosen particle, the nodes that it sees and by how much, N, the
 * terms that pass between them in the stage that the box speaks of, the strongest on their arrows, and the
 * particles around it where they are now. */
#include "panes/screen_runs.h"
#include "views/cell_terms.h"
#include "views/views.h"

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

static void add_particle(Picture *picture, const Screen *screen, const CellTerms *terms, size_t particle)
{
    const Simulation *sim = terms->sim;
    const bool chosen = particle == terms->index;
    const double at[2] = {particle_at(sim, 0, particle), particle_at(sim, 1, particle)};
    const Style style = chosen ? STYLE_CHANGED : STYLE_FAINT;
    PictureLabel label = {
        .x = at[0], .y = at[1], .side = 1, .spare = !chosen, .style = style, .thing = "particle"};
    snprintf(label.text, sizeof label.text, "%zu", particle);
    for (int f = 0; f < terms->n_flows && chosen && !terms->to_nodes; f++) {
        const char *field = terms->flows[f].exchange->field;
        cell_value_add(screen, 0, particle, field, field, terms->flows[f].exchange->adds, label.text,
                       sizeof label.text);
    }
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
    if (cell >= 0)
        text_append(name, sizeof name, ", in cell %.0f", simulation_value(sim, cell, terms.index));
    picture->kind = PICTURE_DRAWING;
    picture->bare = true;
    picture_axes(picture, axis_make(low[0], high[0]), "x", "", axis_make(low[1], high[1]), name, "");
    add_grid(picture, sim, terms.links, terms.n_links);
    for (size_t i = 0; i < terms.n_links; i++)
        add_node(picture, screen, &terms, i);
    for (size_t rank = 0; rank < terms.n_links && !running && (!done || terms.n_flows > 0); rank++)
        add_arrow(picture, &terms, rank);
    add_particle(picture, screen, &terms, terms.index);
    /* in a low pane they stand where the terms would */
    for (size_t p = 0; p < sim->counts[0] && (terms.n_flows == 0 || !picture_is_low(picture)); p++)
        if (p != terms.index &&
            is_near((const double[2]){particle_at(sim, 0, p), particle_at(sim, 1, p)}, low, high))
            add_particle(picture, screen, &terms, p);
    PictureLabel rest = {.x = low[0], .y = (low[1] + high[1]) / 2, .side = 1, .style = STYLE_CHANGED};
    cell_terms_rest(&terms, rest.text, sizeof rest.text);
    if (rest.text[0])
        picture_label(picture, &rest);
    if (done && terms.n_flows == 0 && stage == &sim->stages[sim->n_stages - 1])
        picture_note(picture, STYLE_FAINT, "the step is over: the shares N are those of the new place");
    else if (done && terms.n_flows == 0)
        picture_note(picture, STYLE_FAINT, "nothing passes between particles and nodes in this stage");
}

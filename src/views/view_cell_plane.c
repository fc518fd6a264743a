/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cell of a plane mesh from near: the chosen particle, the nodes that it sees and by how much, N, and the
 * particles around it where they are now. */
#include "views/views.h"

#include <math.h>
#include <stdio.h>

enum { LINKS_MAX = 32 };

static double node_at(const Simulation *sim, int direction, size_t node)
{
    return simulation_value(sim, simulation_find_field(sim, 1, direction ? "y" : "x"), node);
}

static double particle_at(const Simulation *sim, int direction, size_t particle)
{
    return simulation_value(sim, sim->position[direction], particle) +
           simulation_value(sim, sim->displacement[direction], particle);
}

/* The nodes that it sees, and half a cell around them. */
static void find_sides(const Simulation *sim, const Link *links, size_t count, double low[2], double high[2])
{
    const double spacing = node_at(sim, 0, 1) - node_at(sim, 0, 0);
    for (int d = 0; d < 2; d++) {
        low[d] = HUGE_VAL, high[d] = -HUGE_VAL;
        for (size_t i = 0; i < count; i++) {
            low[d] = fmin(low[d], node_at(sim, d, links[i].index));
            high[d] = fmax(high[d], node_at(sim, d, links[i].index));
        }
    }
    low[0] -= 0.8 * spacing, high[0] += 0.8 * spacing;
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
            picture_line(picture, at[0], y->low, at[0], y->high, LINE_SOLID, STYLE_FRAME, '|');
        if (!drawn[1])
            picture_line(picture, x->low, at[1], x->high, at[1], LINE_SOLID, STYLE_FRAME, '-');
    }
}

static void add_node(Picture *picture, const Simulation *sim, size_t particle, const Link *link, bool arrow)
{
    const double x = node_at(sim, 0, link->index), y = node_at(sim, 1, link->index);
    const double from[2] = {particle_at(sim, 0, particle), particle_at(sim, 1, particle)};
    char share[NUMBER_TEXT_MAX];
    text_fitted(link->weight, 5, 9, share);
    PictureLabel label = {.x = x, .y = y, .side = x < from[0] ? -1 : 1, .thing = "node", .says_thing = true};
    snprintf(label.text, sizeof label.text, "%zu\nN %s", link->index, share);
    picture_label(picture, &label);
    picture_add_mark(picture, (PictureMark){.x = x,
                                            .y = y,
                                            .glyph = 0x25a0,
                                            .style = STYLE_CHANGED,
                                            .is_target = true,
                                            .set = 1,
                                            .index = link->index});
    if (arrow)
        picture_arrow(picture, &(PictureArrow){.from = {from[0], from[1]},
                                               .to = {x + 0.12 * (from[0] - x), y + 0.12 * (from[1] - y)},
                                               .style = STYLE_CHANGED});
}

void cell_plane_describe(const Screen *screen, Picture *picture)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const size_t chosen = screen->chosen.particle < sim->counts[0] ? screen->chosen.particle : 0;
    const bool running = screen->playback.state == STATE_RUNNING;
    const int cell = simulation_find_field(sim, 0, "cell");
    Link links[LINKS_MAX];
    double low[2], high[2];
    char name[96];
    size_t count = sim->method->links(sim, 0, chosen, links, LINKS_MAX);
    count = count < LINKS_MAX ? count : LINKS_MAX;
    if (count == 0) {
        picture_say(picture, "one cell", "This particle sees no nodes.");
        return;
    }
    find_sides(sim, links, count, low, high);
    snprintf(name, sizeof name, "particle %zu and its nodes, by their shares N", chosen);
    if (cell >= 0)
        text_append(name, sizeof name, ", in cell %.0f", simulation_value(sim, cell, chosen));
    picture->kind = PICTURE_DRAWING;
    picture->bare = true;
    picture_axes(picture, axis_make(low[0], high[0]), "x", "", axis_make(low[1], high[1]), name, "");
    add_grid(picture, sim, links, count);
    for (size_t i = 0; i < count; i++)
        add_node(picture, sim, chosen, &links[i], !running);
    for (size_t pass = 0; pass < 2; pass++)
        for (size_t p = 0; p < sim->counts[0]; p++) {
            const double at[2] = {particle_at(sim, 0, p), particle_at(sim, 1, p)};
            if ((p == chosen) != (pass == 0) || !is_near(at, low, high))
                continue;
            PictureLabel label = {.x = at[0],
                                  .y = at[1],
                                  .side = 1,
                                  .spare = pass > 0,
                                  .style = pass > 0 ? STYLE_FAINT : STYLE_CHANGED,
                                  .thing = "particle"};
            snprintf(label.text, sizeof label.text, "%zu", p);
            picture_label(picture, &label);
            picture_add_mark(picture, (PictureMark){.x = at[0],
                                                    .y = at[1],
                                                    .glyph = pass > 0 ? 0x25cb : 0x25cf,
                                                    .style = pass > 0 ? STYLE_FAINT : STYLE_CHANGED,
                                                    .is_target = true,
                                                    .index = p});
        }
}

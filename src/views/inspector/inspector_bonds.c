/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inspector of a bar without a mesh: the chosen node, each of its bonds with what its force is made of,
 * and the forces as they add up to the node's. */
#include "views/inspector/inspector.h"
#include "base/text.h"
#include "panes/screen.h"
#include "scenario/concern_bonds.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void describe_node(const Screen *screen, size_t node, size_t n_bonds, Picture *picture)
{
    static const char *const told[][2] = {
        {"u", "u"}, {"v", "v"}, {"stress", "stress"}, {"strain", "strain"}, {"g", "surface_factor"}};
    const Simulation *sim = screen_simulation(screen);
    char text[160] = "";
    picture_heading(picture, "%snode %zu at X = %s: %zu bonds", screen_second_run(screen) ? "A: " : "", node,
                    text_fitted(simulation_named(sim, 0, "x0", node), 6, 12).text, n_bonds);
    snprintf(picture->hints[0], sizeof picture->hints[0], " ← → next node  i closes ");
    text[0] = '\0';
    for (size_t i = 0; i < sizeof told / sizeof *told; i++) {
        if (simulation_find_field(sim, 0, told[i][1]) < 0)
            continue;
        text_append(text, sizeof text, "%s%s = %s", *text ? "  " : "", told[i][0],
                    text_fitted(simulation_named(sim, 0, told[i][1], node), 5, 11).text);
    }
    picture_note(picture, STYLE_NORMAL, "%s", text);
    picture_note(picture, STYLE_FAINT,
                 "f = Σ (c G w V) s n  n: towards the other end  w: share of its cell within reach");
}

/* Who is at the other end: beyond a fixed end a mirror image. The longest bonds are told as one first. */
static void describe_row(const Link *link, size_t node, double spacing, struct TableRow *row)
{
    const long place = (long)node + lround(link->length / spacing);
    snprintf(row->name, sizeof row->name, place == (long)link->index ? "%zu" : "mirror of %zu", link->index);
    row->rank = abs((int)lround(link->length / spacing));
    row->thing = (PictureThing){0, link->index};
}

static void describe_sum(const Screen *screen, size_t node, const Link *links, size_t count,
                         PictureTable *table)
{
    static const char *const names[] = {"ξ", "stretch s", "c G w V", "force on it"};
    enum { LENGTH, STRETCH, STIFFNESS, FORCE, COLUMNS };
    const Simulation *sim = screen_simulation(screen);
    const int bonds = simulation_find_stage(sim, "bonds"), drift = simulation_find_stage(sim, "drift");
    const bool just_bonds = sim->stage == bonds + 1;               /* the load is not yet in the force */
    const bool is_old = sim->stage > drift && sim->stage <= bonds; /* that is still the last step's */
    const double spacing = lattice_spacing(screen_settings(screen));
    table->count = count;
    table->n_columns = COLUMNS;
    table->what = "bond to";
    table->more = "longer ones";
    for (int c = 0; c < COLUMNS; c++) {
        table->columns[c] = (TableColumn){.adds = c == FORCE, .stays = c != FORCE, .in = 1u << FORCE};
        snprintf(table->columns[c].name, sizeof table->columns[c].name, "%s", names[c]);
    }
    for (size_t i = 0; i < count; i++) {
        describe_row(&links[i], node, spacing, &table->rows[i]);
        table->columns[LENGTH].values[i] = links[i].length;
        table->columns[STRETCH].values[i] = links[i].stretch;
        table->columns[STIFFNESS].values[i] = links[i].stiffness;
        table->columns[FORCE].values[i] =
            copysign(1, links[i].length) * links[i].stiffness * links[i].stretch;
    }
    TableColumn *force = &table->columns[FORCE];
    const Style changed = just_bonds ? STYLE_CHANGED : STYLE_NORMAL;
    force->style = changed;
    force->base = just_bonds || is_old ? NAN : simulation_named(sim, 0, "load", node);
    force->result = simulation_named(sim, 0, "force", node);
    table->totals[TOTAL_SUM] = (struct TableTotals){"all its bonds", changed};
    table->totals[TOTAL_BASE] =
        (struct TableTotals){just_bonds || is_old ? NULL : "load on it", STYLE_NORMAL};
    table->totals[TOTAL_RESULT] = (struct TableTotals){is_old       ? "f, of the last step"
                                                       : just_bonds ? "f, without the load"
                                                                    : "f of the node",
                                                       is_old ? STYLE_NORMAL : STYLE_CHANGED};
}

static void describe(const Screen *screen, Picture *picture)
{
    const Simulation *sim = screen_simulation(screen);
    Link links[TABLE_ROWS_MAX];
    const size_t chosen = screen->chosen.particle, last = sim->counts[0] - 1;
    const size_t node = chosen < last ? chosen : last;
    const size_t found = sim->method->links(sim, 0, node, links, TABLE_ROWS_MAX);
    const size_t count = found < TABLE_ROWS_MAX ? found : TABLE_ROWS_MAX;
    describe_node(screen, node, count, picture);
    PictureTable *table = picture_table(picture);
    if (table)
        describe_sum(screen, node, links, count, table);
}

static void move_on(Screen *screen, int x, int y, int page)
{
    const size_t count = screen_simulation(screen)->counts[0];
    const long to = (long)screen->chosen.particle + (x != 0 ? x : page > 1 ? y : 0) * (long)page;
    screen->chosen.particle = to < 0 ? 0 : to < (long)count ? (size_t)to : count - 1;
    screen->chosen.is_node = false;
}

const Inspector inspector_bonds = {.needs = HAS_BONDS | HAS_LINE, .describe = describe, .move = move_on};

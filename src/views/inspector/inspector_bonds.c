/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inspector of a bar without a mesh: the chosen node, each of its bonds with what its force is made of,
 * and the forces as they add up to the node's. */
#include "views/inspector/inspector.h"
#include "scenario/concern_bonds.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { BONDS_MAX = 64, NAME_WIDTH = 22, COLUMN_WIDTH = 13, HEAD_ROWS = 4, TOTALS_MAX = 3 };

typedef struct BondSum {
    const Simulation *sim;
    size_t node, count;
    Link links[BONDS_MAX];
    double forces[BONDS_MAX]; /* on the node, per volume */
    double all;               /* of all bonds */
    double nearest;           /* bonds up to this length are written one by one */
    size_t shown;
    double load, force; /* the node's */
    bool just_bonds;    /* the load is not yet in the force */
    bool is_old;        /* the force is that of the last step, the stretches are new */
    Writing writing;
} BondSum;

static double named(const BondSum *sum, const char *field)
{
    double value = 0;
    const int index = simulation_find_field(sum->sim, 0, field);
    if (index >= 0)
        sum->sim->method->field(sum->sim, index, sum->node, 1, &value);
    return value;
}

/* Bonds that are as short as the limit or shorter. */
static size_t bonds_within(const BondSum *sum, double limit)
{
    size_t count = 0;
    for (size_t i = 0; i < sum->count; i++)
        count += fabs(sum->links[i].length) <= limit;
    return count;
}

/* The longest bonds are the first to be left out: they are told as one. */
static void choose_shown(BondSum *sum, size_t room)
{
    for (size_t i = 0; i < sum->count; i++)
        sum->nearest = fmax(sum->nearest, fabs(sum->links[i].length) * (1 + 1e-9));
    sum->shown = sum->count;
    while (sum->shown > 0 && sum->shown + (sum->shown < sum->count) > room) {
        double next = 0;
        for (size_t i = 0; i < sum->count; i++) {
            const double length = fabs(sum->links[i].length) * (1 + 1e-9);
            if (length < sum->nearest * (1 - 1e-6))
                next = fmax(next, length);
        }
        sum->nearest = next;
        sum->shown = bonds_within(sum, next);
    }
}

static void make_sum(BondSum *sum, const Screen *screen, int rows)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const int bonds = simulation_find_stage(sim, "bonds"), drift = simulation_find_stage(sim, "drift");
    *sum = (BondSum){.sim = sim, .node = screen->chosen.particle};
    if (sum->node >= sim->counts[0])
        sum->node = sim->counts[0] - 1;
    const size_t count = sim->method->links(sim, 0, sum->node, sum->links, BONDS_MAX);
    sum->count = count < BONDS_MAX ? count : BONDS_MAX;
    for (size_t i = 0; i < sum->count; i++) {
        const Link *link = &sum->links[i];
        sum->forces[i] = copysign(1, link->length) * link->stiffness * link->stretch;
        sum->all += sum->forces[i];
    }
    sum->just_bonds = sim->stage == bonds + 1;
    sum->is_old = sim->stage > drift && sim->stage <= bonds;
    sum->force = named(sum, "force");
    sum->load = sum->just_bonds || sum->is_old ? 0 : named(sum, "load");
    const int room = rows - HEAD_ROWS - 1 - TOTALS_MAX; /* a row of scales may be needed */
    choose_shown(sum, room > 0 ? (size_t)room : 0);
    double terms[BONDS_MAX + 1] = {0};
    size_t n = 0;
    for (size_t i = 0; i < sum->count; i++)
        if (fabs(sum->links[i].length) <= sum->nearest)
            terms[n++] = sum->forces[i];
        else
            terms[sum->shown] += sum->forces[i];
    n += sum->shown < sum->count;
    sum->writing = writing_of(terms, n, sum->load, sum->all, COLUMN_WIDTH - 1);
}

/* --- drawing ---------------------------------------------------------------------------------------- */

static int column_end(int column)
{
    return NAME_WIDTH + (column + 1) * COLUMN_WIDTH;
}

static void draw_node(const Screen *screen, const BondSum *sum, Area area)
{
    static const struct {
        const char *label, *field;
    } told[] = {{"u", "u"}, {"v", "v"}, {"stress", "stress"}, {"strain", "strain"}, {"g", "surface_factor"}};
    char text[160] = "", number[NUMBER_TEXT_MAX];
    text_fitted(named(sum, "x0"), 6, 12, number);
    snprintf(text, sizeof text, "%snode %zu at X = %s: %zu bonds", screen_second_run(screen) ? "A: " : "",
             sum->node, number, sum->count);
    area_rule(area, 0, text, screen_is_focused(screen, PANE_INSPECTOR) ? STYLE_FOCUS : STYLE_HEADING);
    heading_hint(area, 5 + glyphs_columns(text), area.rect.width - 1, " ← → next node  i closes ");
    text[0] = '\0';
    for (size_t i = 0; i < sizeof told / sizeof *told; i++) {
        if (simulation_find_field(sum->sim, 0, told[i].field) < 0)
            continue;
        text_fitted(named(sum, told[i].field), 5, 11, number);
        text_append(text, sizeof text, "%s%s = %s", *text ? "  " : "", told[i].label, number);
    }
    area_phrases(area, 1, 1, area.rect.width - 2, 1, text, STYLE_NORMAL);
}

/* Who is at the other end: beyond a fixed end a mirror image. */
static void name_partner(const BondSum *sum, const Link *link, double spacing, char *out, size_t size)
{
    const long place = (long)sum->node + lround(link->length / spacing);
    if (place == (long)link->index)
        snprintf(out, size, "%zu", link->index);
    else
        snprintf(out, size, "mirror of %zu", link->index);
}

static void draw_bond(const BondSum *sum, Area area, size_t i, double spacing, int y)
{
    const Link *link = &sum->links[i];
    const double values[] = {link->length, link->stretch, link->stiffness};
    char text[NUMBER_TEXT_MAX + 32];
    name_partner(sum, link, spacing, text, sizeof text);
    area_text_right(area, NAME_WIDTH - 1, y, text, STYLE_NORMAL);
    for (int c = 0; c < 3; c++) {
        text_fitted(values[c], 6, COLUMN_WIDTH - 1, text);
        area_text_right(area, column_end(c), y, text, STYLE_NORMAL);
    }
    inspector_write(area, column_end(3), y, sum->forces[i], sum->writing, sum->writing.decimals,
                    sum->just_bonds ? STYLE_CHANGED : STYLE_NORMAL);
}

static void draw_total(const BondSum *sum, Area area, int y, const char *name, double value, int decimals,
                       bool changed)
{
    area_text_right(area, NAME_WIDTH - 1, y, name, STYLE_HEADING);
    inspector_write(area, column_end(3), y, value, sum->writing, decimals,
                    changed ? STYLE_CHANGED : STYLE_NORMAL);
}

static void draw(const Screen *screen, Area area)
{
    const bool ascii = area.glyphs == GLYPHS_ASCII;
    BondSum sum;
    make_sum(&sum, screen, area.rect.height);
    draw_node(screen, &sum, area);
    area_phrases(area, 1, 2, area.rect.width - 2, 1,
                 ascii ? "f = sum (c G w V) s n  n: towards the other end  w: share of its cell within reach"
                       : "f = Σ (c G w V) s n  n: towards the other end  w: share of its cell within reach",
                 STYLE_FAINT);
    const Writing *writing = &sum.writing;
    const int scaled = writing->exponent != 0, heads = HEAD_ROWS - 1;
    const char *const names[] = {ascii ? "xi" : "ξ", "stretch s", "c G w V", "force on it"};
    area_text_right(area, NAME_WIDTH - 1, heads, "bond to", STYLE_HEADING);
    for (int c = 0; c < 4; c++)
        area_text_right(area, column_end(c), heads, names[c], STYLE_HEADING);
    if (scaled)
        area_print(area, column_end(2) + 1, heads + 1, STYLE_HEADING, "%*sx10^%d", COLUMN_WIDTH - 8, "",
                   writing->exponent);
    int y = HEAD_ROWS + scaled;
    double rest = 0;
    const double spacing = lattice_spacing(experiment_settings(screen->experiment));
    for (size_t i = 0; i < sum.count; i++)
        if (fabs(sum.links[i].length) <= sum.nearest)
            draw_bond(&sum, area, i, spacing, y++);
        else
            rest += sum.forces[i];
    if (sum.shown < sum.count) {
        char text[48];
        snprintf(text, sizeof text, "%zu longer ones", sum.count - sum.shown);
        area_text_right(area, NAME_WIDTH - 1, y, text, STYLE_FAINT);
        inspector_write(area, column_end(3), y++, rest, *writing, writing->decimals, STYLE_NORMAL);
    }
    const bool based = sum.load != 0;
    draw_total(&sum, area, y++, "all its bonds", sum.all, based ? writing->decimals : writing->sum_decimals,
               sum.just_bonds);
    if (!sum.just_bonds && !sum.is_old)
        draw_total(&sum, area, y++, "load on it", sum.load, based ? writing->decimals : writing->sum_decimals,
                   false);
    draw_total(&sum, area, y,
               sum.is_old       ? "f, of the last step"
               : sum.just_bonds ? "f, without the load"
                                : "f of the node",
               sum.force, writing->sum_decimals, !sum.is_old);
}

static void move_on(Screen *screen, int x, int y, int page)
{
    const size_t count = experiment_simulation(screen->experiment)->counts[0];
    const long to = (long)screen->chosen.particle + (x != 0 ? x : page > 1 ? y : 0) * (long)page;
    screen->chosen.particle = to < 0 ? 0 : to < (long)count ? (size_t)to : count - 1;
    screen->chosen.is_node = false;
}

const Inspector inspector_bonds = {.needs = HAS_BONDS | HAS_LINE, .draw = draw, .move = move_on};

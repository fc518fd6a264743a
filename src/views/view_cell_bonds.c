/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bonds from near: the strongest bond of the chosen node with its two ends, at rest and as it is, its
 * pull and the factors of that; or the family, the strongest bonds one by one and the others as a sum. The
 * links are the method's (Method.links), in the order of the box: the strongest first. */
#include "base/math/functions.h"
#include "panes/screen.h"
#include "views/view.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINKS_MAX = 512, SHOWN_MAX = 8 };

#define ROWS 12.0

typedef struct NearBonds {
    const Simulation *sim;
    size_t node, count;
    Link links[LINKS_MAX]; /* the strongest first, broken ones last */
    size_t whole;          /* that carry something */
    const char *unit;      /* of a force density, with a space before it */
} NearBonds;

static void add_end(Picture *picture, double x, double y, size_t node, bool own, bool now)
{
    picture_thing(picture, x, y, now ? 0x25cf : 0x25cb,
                  own   ? STYLE_CHANGED
                  : now ? STYLE_MEASURED
                        : STYLE_FAINT,
                  (PictureThing){0, node});
}

static void open_drawing(Picture *picture, double low, double high, const char *name)
{
    picture->kind = PICTURE_DRAWING;
    picture->bare = true;
    picture_axes(picture, axis_make(low, high), "x", "", axis_make(0, ROWS), name, "");
}

/* As this view writes numbers. */
static NumberText number_of(double value)
{
    enum { DIGITS = 5, COLUMNS = 11 };
    return text_fitted(value, DIGITS, COLUMNS);
}

/* --- one bond --------------------------------------------------------------------------------------- */

/* "c G w V s = 133.3 × 1 × 0.5 × 0.5 × -0.0073 = -0.32": factors by name, in words if they fit; product. */
static void write_product(const NearBonds *bonds, const Link *link, int columns, char out[2][160])
{
    static const char *const names[LINK_FACTORS] = {"micromodulus c", "surface G", "share w", "volume V"};
    char brief[160] = "";
    double product = link->stretch;
    out[0][0] = out[1][0] = '\0';
    for (int f = 0; f < LINK_FACTORS; f++) {
        const NumberText factor = number_of(link->factors[f]);
        const char *gap = f ? "  " : "";
        text_append(brief, sizeof brief, "%s%s %s", gap, text_last_word(names[f]), factor.text);
        text_append(out[0], 160, "%s%s %s", gap, names[f], factor.text);
        text_append(out[1], 160, "%s × ", factor.text);
        product *= link->factors[f];
    }
    if (glyphs_columns(out[0]) + 2 > columns)
        snprintf(out[0], 160, "%s", brief);
    text_append(out[1], 160, "%s = ", number_of(link->stretch).text);
    text_append(out[1], 160, "%s%s", number_of(product).text, bonds->unit);
}

/* As the stage leaves it; NULL: between steps. */
static void describe_bond(const NearBonds *bonds, const Stage *stage, Picture *picture)
{
    const Link *link = &bonds->links[0];
    /* the stretch is enlarged so that it is seen: a quarter of the length at most */
    const double factor = link->stretch != 0 ? axis_step_down(0.25 / fabs(link->stretch)) : 1;
    const double half = 0.25 * (1 + factor * link->stretch);
    char text[200], product[2][160];
    const bool left = link->apart[0] < 0; /* its other end */
    const size_t ends[2] = {left ? link->index : bonds->node, left ? bonds->node : link->index};
    snprintf(text, sizeof text, "the bond %zu to %s%zu, the %s of %zu", bonds->node, link_mirror(link),
             link->index, link->broken ? "first" : "strongest", bonds->count);
    if (stage)
        text_append(text, sizeof text, ", stage %d: %s", (int)(stage - bonds->sim->stages) + 1, stage->name);
    open_drawing(picture, 0, 1, text);
    for (int e = 0; e < 2; e++) {
        const double rest = e ? 0.75 : 0.25, now = e ? 0.5 + half : 0.5 - half;
        add_end(picture, rest, 10, ends[e], ends[e] == bonds->node, false);
        add_end(picture, now, 6.5, ends[e], ends[e] == bonds->node, true);
        PictureLabel *name = picture_label(picture, rest, 10, e ? 1 : -1, STYLE_NORMAL, "%zu%s", ends[e],
                                           link->mirrored && left != e ? " mirrored" : "");
        name->thing = "node";
        name->says_thing = true;
        const double pull = copysign(0.1, link->stretch) * (e ? -1 : 1);
        if (!link->broken && link->stretch != 0)
            picture_arrow(picture, &(PictureArrow){
                                       .from = {now, 6.5}, .to = {now + pull, 6.5}, .style = STYLE_CHANGED});
    }
    picture_line(picture, 0.25, 10, 0.75, 10, (Pen){LINE_SOLID, '-', STYLE_FAINT, RANK_GHOST, 0});
    picture_line(picture, 0.5 - half, 6.5, 0.5 + half, 6.5,
                 link->broken ? (Pen){LINE_DASHED, '-', STYLE_FAINT, RANK_GHOST, 0}
                              : (Pen){LINE_SOLID, '-', STYLE_MEASURED, RANK_GHOST, 0});
    picture_label(picture, 0.5, 11.6, 0, STYLE_FAINT, "at rest: |ξ| %s",
                  number_of(math_hypot(link->apart[0], link->apart[1])).text);
    if (link->broken) {
        picture_label(picture, 0.5, 8, 0, STYLE_CHANGED, "broken: it carries nothing");
        return;
    }
    picture_label(picture, 0.5, 8.2, 0, STYLE_CHANGED, "now: s %s, drawn %s times",
                  number_of(link->stretch).text, text_factor(factor).text);
    write_product(bonds, link, picture->columns, product);
    picture_label(picture, 0.5, 4.6, 0, STYLE_CHANGED, "%s %s%s at each end",
                  link->stretch < 0 ? "pushes" : "pulls", number_of(link_pull(link)).text, bonds->unit);
    picture_label(picture, 0.5, 2.8, 0, STYLE_NORMAL, "%.90s", product[0]);
    snprintf(text, sizeof text, "c G w V s = %s", product[1]);
    if (glyphs_columns(text) + 2 > picture->columns) /* what it comes to stands above */
        snprintf(text, sizeof text, "%.*s", (int)(strstr(product[1], " = ") - product[1]), product[1]);
    picture_label(picture, 0.5, 1.2, 0, STYLE_NORMAL, "%.90s", text);
}

/* --- a family --------------------------------------------------------------------------------------- */

static void describe_family(const NearBonds *bonds, Picture *picture)
{
    const size_t shown = bonds->whole < SHOWN_MAX ? bonds->whole : SHOWN_MAX;
    const bool line = simulation_has(bonds->sim, HAS_LINE);
    char name[96];
    double rest[2] = {0, 0}, reach = bonds->sim->spacing;
    snprintf(name, sizeof name, "node %zu: %zu bonds, %zu broken; the strongest pulls%s", bonds->node,
             bonds->count, bonds->count - bonds->whole, bonds->unit);
    open_drawing(picture, 0, 1, name);
    /* The body around the node: the other ends as dots, those that are written out with their letters. */
    for (size_t k = 0; k < bonds->count; k++)
        for (int d = 0; d < 2; d++)
            reach = fmax(reach, fabs(bonds->links[k].apart[d]));
    for (size_t k = 0; k < bonds->count; k++) {
        const Link *link = &bonds->links[k];
        picture_thing(picture, 0.16 + 0.13 / reach * link->apart[0], 6 + 5 / reach * link->apart[1],
                      k < shown      ? (uint32_t)('a' + k)
                      : link->broken ? 'x'
                                     : 0x00b7,
                      k < shown ? STYLE_CHANGED : STYLE_FAINT, (PictureThing){0, link->index});
    }
    picture_mark(picture, 0.16, 6, 0x25cf, STYLE_MEASURED);
    const double most = shown > 0 ? fabs(link_pull(&bonds->links[0])) : 0;
    for (size_t k = 0; k < shown; k++) {
        /* A row for a bond, its bar as long as the pull is strong, towards the right if it pulls. */
        const double pull = link_pull(&bonds->links[k]), length = most > 0 ? pull / most * 0.12 : 0;
        const double y = 11.4 - 1.2 * (double)k, middle = 0.85;
        picture_box(picture, (double[]){middle + fmin(length, 0), middle + fmax(length, 0)},
                    (double[]){y - 0.3, y + 0.3},
                    pull < 0 ? (Pen){LINE_SOLID, '<', STYLE_PREDICTED, RANK_BAND, 1}
                             : (Pen){LINE_SOLID, '>', STYLE_SECOND, RANK_BAND, 0});
        picture_label(picture, 0.32, y, 1, STYLE_CHANGED, "%c to %s%zu  %.20s", (char)('a' + k),
                      link_mirror(&bonds->links[k]), bonds->links[k].index, number_of(pull).text);
    }
    for (size_t k = shown; k < bonds->whole; k++)
        for (int d = 0; d < bonds->sim->n_exchanges; d++)
            rest[d] += simulation_exchange(bonds->sim, d, bonds->node, &bonds->links[k]).product;
    if (shown < bonds->whole) {
        PictureLabel *more = picture_label(picture, 0.32, 1.4, 1, STYLE_NORMAL,
                                           line ? "%zu more: %s" : "%zu more together: fx %s",
                                           bonds->whole - shown, number_of(rest[0]).text);
        if (!line)
            text_append(more->text, sizeof more->text, ", fy %s", number_of(rest[1]).text);
    }
}

void cell_bonds_describe(const Screen *screen, int variant, Picture *picture)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const size_t nodes = sim->counts[0], chosen = screen->chosen.particle;
    NearBonds *bonds = calloc(1, sizeof *bonds);
    if (bonds && nodes > 0) {
        bonds->sim = sim;
        bonds->unit = screen_problem(screen)->si ? " N/m³" : "";
        bonds->node = chosen < nodes ? chosen : nodes - 1;
        const size_t count = sim->method->links(sim, 0, bonds->node, bonds->links, LINKS_MAX);
        bonds->count = count < LINKS_MAX ? count : LINKS_MAX;
        simulation_sort_links(bonds->links, bonds->count);
        while (bonds->whole < bonds->count && !bonds->links[bonds->whole].broken)
            bonds->whole++;
    }
    if (!bonds || bonds->count == 0)
        picture_say(picture, "close-up of bonds", "This node has no bonds.");
    else if (variant == 1)
        describe_family(bonds, picture);
    else {
        bool done;
        const Stage *stage = &bonds->sim->stages[screen_box_stage(screen, &done)];
        describe_bond(bonds, done && !screen_is_running(screen) ? stage : NULL, picture);
    }
    free(bonds);
}

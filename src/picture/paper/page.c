/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The page: title, panels in a grid, notes, and at its foot the parameters of the run. */
#include "picture/paper/page.h"

#include "base/assertion.h"
#include "picture/paper/draw.h"

#include <math.h>
#include <string.h>

#define MARGIN      10.0
#define BARE_MARGIN 3.0         /* for the ends of lines and digits */
#define MILLIMETRES (72 / 25.4) /* points in one */

enum { COLUMNS_MANY = 3 }; /* from so many panels on they are in two columns */

static const Type small = {.size = SIZE_SMALL, .colour = GREY};

static bool has_key(const Picture *picture, const PictureKey *key)
{
    for (int i = 0; i < picture->n_keys; i++)
        if (strcmp(picture->keys[i].name, key->name) == 0 && picture->keys[i].sign == key->sign)
            return true;
    return false;
}

/* The panel whose legend and colours can stand for all: the one that names most. NULL: there is none, or no
 * other panel. */
static const Picture *common_of(const Figure *figure)
{
    const Picture *most = &figure->panels[0]->picture;
    for (int i = 1; i < figure->count; i++)
        if (figure->panels[i]->picture.n_keys > most->n_keys)
            most = &figure->panels[i]->picture;
    for (int i = 0; i < figure->count; i++) {
        const Picture *picture = &figure->panels[i]->picture;
        for (int k = 0; k < picture->n_keys; k++)
            if (!has_key(most, &picture->keys[k]))
                return NULL;
        if (most->map &&
            (!picture->map || picture->map->low != most->map->low || picture->map->high != most->map->high))
            return NULL;
    }
    return figure->count > 1 ? most : NULL;
}

/* --- a panel --------------------------------------------------------------------------------------- */

/* Explanations, or results. */
static double draw_notes(Paper *paper, const Picture *picture, bool faint, Box box)
{
    double height = 0;
    for (int i = 0; i < picture->n_notes; i++) {
        if (picture->notes[i].told || picture->kind == PICTURE_TABLES || /* which have theirs themselves */
            (picture->notes[i].style == STYLE_FAINT) != faint)
            continue;
        const Type type = {.size = SIZE_WORDS,
                           .colour = (picture->notes[i].style == STYLE_FAINT) ? GREY : BLACK};
        const Box rest = {box.x, box.y + height, box.width, box.height - height};
        height += draw_phrases(paper, picture->notes[i].text, rest, &type);
    }
    return height;
}

/* Under a panel: results, and explanations if they do not stand once for all. */
static double draw_all_notes(Paper *paper, const Picture *picture, bool alone, Box box)
{
    const double results = draw_notes(paper, picture, false, box);
    box.y += results;
    return results + (alone ? draw_notes(paper, picture, true, box) : 0);
}

static double margin_of(const Figure *figure)
{
    return figure->bare ? BARE_MARGIN : MARGIN;
}

/* What stands above and below the picture itself; `alone`: with a legend of its own. */
static double height_around(const FigurePanel *panel, double width, bool alone)
{
    const Box box = {0, 0, width, 0};
    double height = panel->caption[0] ? LINE_HEIGHT * SIZE_WORDS : 0;
    if (alone && panel->picture.n_keys > 0)
        height += draw_legend_rows(NULL, &panel->picture, box) + 2;
    if (alone)
        height += draw_heat_bar(NULL, &panel->picture, box);
    const double notes = draw_all_notes(NULL, &panel->picture, alone, box);
    return height + (notes > 0 ? notes + 4 : 0);
}

static void draw_panel(Paper *paper, const FigurePanel *panel, Box box, bool alone)
{
    const Type caption = {.size = SIZE_WORDS, .bold = true};
    if (panel->caption[0]) {
        draw_words(paper, box.x, box.y + SIZE_WORDS, panel->caption, &caption);
        box.y += LINE_HEIGHT * SIZE_WORDS;
        box.height -= LINE_HEIGHT * SIZE_WORDS;
    }
    if (alone && panel->picture.n_keys > 0) {
        const double height = draw_legend_rows(paper, &panel->picture, box) + 2;
        box.y += height;
        box.height -= height;
    }
    double notes = draw_all_notes(NULL, &panel->picture, alone, box);
    notes += notes > 0 ? 4 : 0;
    const double bar = alone ? draw_heat_bar(NULL, &panel->picture, box) : 0;
    box.height -= notes + bar;
    draw_plot(paper, &panel->picture, box);
    if (bar > 0)
        draw_heat_bar(paper, &panel->picture, (Box){box.x, box.y + box.height, box.width, bar});
    draw_all_notes(paper, &panel->picture, alone,
                   (Box){box.x, box.y + box.height + bar + 4, box.width, notes});
}

/* --- the whole ------------------------------------------------------------------------------------- */

static int columns_of(const Figure *figure)
{
    return figure->count >= COLUMNS_MANY ? 2 : 1;
}

static double panel_width(const Figure *figure, int count)
{
    const double inner = figure->width * MILLIMETRES - 2 * margin_of(figure);
    return count >= COLUMNS_MANY ? (inner - MARGIN) / 2 : inner;
}

static double usual_height(const Figure *figure, int panels)
{
    return (panels == 1 ? 0.56 : 0.5) * panel_width(figure, panels);
}

void page_panel_cells(const Figure *figure, int panels, int *columns, int *rows)
{
    ASSERT_INT(panels, >=, 1);
    *columns = (int)(panel_width(figure, panels) / (0.66 * SIZE_WORDS));
    *rows = (int)(usual_height(figure, panels) / (1.3 * SIZE_WORDS));
}

static double plot_height(const Figure *figure)
{
    double height = 0;
    for (int i = 0; i < figure->count; i++)
        height =
            fmax(height, draw_plot_height(&figure->panels[i]->picture, panel_width(figure, figure->count)));
    return height > 0 ? height : usual_height(figure, figure->count);
}

/* Pictures alone, each with its axes and, beside others, its time. */
static double lay_out_bare(Paper *paper, const Figure *figure, double height)
{
    const int columns = columns_of(figure), rows = (figure->count + columns - 1) / columns;
    const double wide = panel_width(figure, figure->count);
    const double caption = figure->count > 1 ? LINE_HEIGHT * SIZE_WORDS : 0;
    double high = plot_height(figure) + caption;
    if (height > 0)
        high = (height - 2 * BARE_MARGIN - (rows - 1) * MARGIN) / rows;
    for (int i = 0; i < figure->count && paper; i++) {
        const double x = BARE_MARGIN + i % columns * (wide + MARGIN);
        const double y = BARE_MARGIN + i / columns * (high + MARGIN);
        const Type words = {.size = SIZE_WORDS, .bold = true};
        if (caption > 0)
            draw_words(paper, x, y + SIZE_WORDS, figure->panels[i]->caption, &words);
        draw_plot(paper, &figure->panels[i]->picture, (Box){x, y + caption, wide, high - caption});
    }
    return 2 * BARE_MARGIN + rows * high + (rows - 1) * MARGIN;
}

/* Draws the page, or measures it if there is no paper: its height follows from what is on it. */
static double lay_out(Paper *paper, const Figure *figure, double height)
{
    if (figure->bare)
        return lay_out_bare(paper, figure, height);
    const double width = figure->width * MILLIMETRES - 2 * MARGIN;
    const Picture *common = common_of(figure);
    const Type title = {.size = SIZE_TITLE, .bold = true};
    const Box whole = {MARGIN, MARGIN, width, 0};
    double y = MARGIN;
    y += draw_phrases(paper, figure->title, whole, &title) + (figure->title[0] ? 3 : 0);
    if (common) {
        y += draw_legend_rows(paper, common, (Box){MARGIN, y, width, 0}) + 2;
        y += draw_heat_bar(paper, common, (Box){MARGIN, y, width, 0}) + 2;
        y += draw_notes(paper, common, true, (Box){MARGIN, y, width, 0}) + 4;
    }

    const double foot = draw_phrases(NULL, figure->parameters, whole, &small);
    const int columns = columns_of(figure), rows = (figure->count + columns - 1) / columns;
    const double wide = panel_width(figure, figure->count);
    double around = 0;
    for (int i = 0; i < figure->count; i++)
        around = fmax(around, height_around(figure->panels[i], wide, !common));
    double high = plot_height(figure) + around;
    if (height > 0)
        high = (height - y - foot - 6 - MARGIN - (rows - 1) * MARGIN) / rows;
    for (int i = 0; i < figure->count && paper; i++)
        draw_panel(
            paper, figure->panels[i],
            (Box){MARGIN + i % columns * (wide + MARGIN), y + i / columns * (high + MARGIN), wide, high},
            !common);
    y += rows * high + (rows - 1) * MARGIN + 6;
    return y + draw_phrases(paper, figure->parameters, (Box){MARGIN, y, width, 0}, &small) + MARGIN;
}

double page_width(const Figure *figure)
{
    return figure->width * MILLIMETRES;
}

double page_height(const Figure *figure)
{
    return figure->height > 0 ? figure->height * MILLIMETRES : lay_out(NULL, figure, 0);
}

void page_draw(const Figure *figure, Paper *paper)
{
    lay_out(paper, figure, figure->height > 0 ? figure->height * MILLIMETRES : 0);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One view on one screen: what it needs, which variant is chosen, and how it is drawn, alone or for the two
 * runs of a duel. Nothing here asks which view it is. */
#include "views/view.h"

#include "panes/panes.h"
#include "picture/cells/cells.h"

#include <stdio.h>

static bool has_any(const Experiment *experiment, unsigned needs)
{
    return needs == 0 || (experiment_simulation(experiment)->has & needs) != 0;
}

const char *view_missing(const View *view, const Screen *screen)
{
    return has_any(screen->experiment, view->needs) ? NULL : view->lacking;
}

int view_variants(const View *view, const Screen *screen)
{
    const int count = view->variants ? view->variants(screen) : 1;
    return count > 0 ? count : 1;
}

/* What was chosen, as it was counted: more than there are begins anew. */
static const int *chosen_variant(const View *view, const ViewsShown *shown)
{
    static const int first = 0;
    for (int i = 0; i < shown->n_variants; i++)
        if (shown->variants[i].view == view)
            return &shown->variants[i].variant;
    return &first;
}

int view_variant(const View *view, const Screen *screen)
{
    const int variant = *chosen_variant(view, &screen->views);
    return variant > 0 ? variant % view_variants(view, screen) : 0;
}

void view_choose_variant(const View *view, Screen *screen, int variant)
{
    int i = 0;
    while (i < screen->views.n_variants && screen->views.variants[i].view != view)
        i++;
    if (i == VIEWS_MAX)
        return;
    screen->views.variants[i].view = view;
    screen->views.variants[i].variant = variant;
    if (i == screen->views.n_variants)
        screen->views.n_variants++;
}

bool view_is_on_paper(const View *view, const Screen *screen)
{
    return view->on_paper && has_any(screen->experiment, view->on_paper_with) && !view_missing(view, screen);
}

const char *view_variant_word(const View *view, const Screen *screen, int variant)
{
    const bool known = view->variant_word && variant >= 0 && variant < view_variants(view, screen);
    return known ? view->variant_word(screen, variant) : NULL;
}

bool view_makes_figure(const View *view, const Screen *screen)
{
    return view_is_on_paper(view, screen) &&
           (!view->variant_word || view->variant_word(screen, view_variant(view, screen)));
}

const ConvergenceStudy *view_study(const View *view, const Screen *screen)
{
    return view->study ? view->study(screen, view_variant(view, screen)) : NULL;
}

bool view_shows_start(const View *view, const Screen *screen)
{
    return view->shows_start && view->shows_start(screen, view_variant(view, screen));
}

/* --- drawing ---------------------------------------------------------------------------------------- */

void view_draw_variant(const View *view, const Screen *screen, Area area, Style heading, int variant)
{
    if (!view->describe) {
        view->draw(screen, area, heading, variant);
        return;
    }
    Picture picture;
    cells_open(&picture, area.rect.width, area.glyphs);
    view->describe(screen, variant, &picture);
    if (screen_is_plain(screen) && !screen->lesson.open) /* one number is in large digits, below */
        picture.n_notes = 0;
    cells_draw(&picture, area, heading, screen->look.colours > 0);
    picture_close(&picture);
}

static void draw_one(const View *view, const Screen *screen, Area area, Style heading)
{
    view_draw_variant(view, screen, area, heading, view_variant(view, screen));
}

/* Whose picture it is stands at the end of its heading, in as few words as there is room for. */
static void name_side(const Duel *duel, DuelSide side, const char *note, Area area)
{
    const char letter = side == SIDE_A ? 'A' : 'B';
    char names[3][DUEL_NAME_MAX + 32];
    int end = area.rect.width - 1; /* the heading's words */
    while (end > 0) {
        const uint32_t glyph = area.canvas->cells[area.rect.y * area.canvas->width + area.rect.x + end].glyph;
        if (glyph != 0x2500 && glyph != ' ' && glyph != '-')
            break;
        end--;
    }
    snprintf(names[0], sizeof names[0], " %c %s%s ", letter, duel->names[side == SIDE_B], note);
    snprintf(names[1], sizeof names[1], " %c%s ", letter, note);
    snprintf(names[2], sizeof names[2], " %c ", letter);
    int form = 0;
    while (form < 2 && end + glyphs_columns(names[form]) + 1 > area.rect.width - 1)
        form++;
    area_text_right(area, area.rect.width - 1, 0, names[form],
                    side == SIDE_A ? STYLE_MEASURED : STYLE_SECOND);
}

/* The picture of one run of a duel. */
static void draw_side(const View *view, const Screen *screen, DuelSide side, const char *note, Area area,
                      Style heading)
{
    const Screen one = screen_of_side(screen, side);
    draw_one(view, &one, area, heading);
    if (view->duel != DUEL_IN_AXES || view->names_run)
        name_side(screen->duel, side, note, area);
}

static void draw_sides(const View *view, const Screen *screen, Area area, Style heading)
{
    enum { STACK_HEIGHT = 14 };
    const int width = area.rect.width, height = area.rect.height;
    const bool wide = area.canvas->width >= SIDE_BY_SIDE;
    if (view->duel == DUEL_TOGETHER || (view->duel == DUEL_IN_AXES && !wide)) {
        draw_one(view, screen, area, heading);
    } else if (wide) {
        const int left = (width - 1) / 2;
        draw_side(view, screen, SIDE_A, "", area_part(area, 0, 0, left, height), heading);
        draw_side(view, screen, SIDE_B, "", area_part(area, left + 1, 0, width - left - 1, height), heading);
    } else if (height >= STACK_HEIGHT) {
        draw_side(view, screen, SIDE_A, "", area_part(area, 0, 0, width, height / 2), heading);
        draw_side(view, screen, SIDE_B, "", area_part(area, 0, height / 2, width, height - height / 2),
                  heading);
    } else {
        draw_side(view, screen, SIDE_A, screen->panes.zoomed ? "" : ", z: and B", area, heading);
    }
}

/* A figure has one pair of axes. */
void view_describe(const View *view, const Screen *screen, int columns, int rows, Picture *picture)
{
    enum { PLOT_LEAST = 1 };
    const Screen one = screen_is_shared(screen) ? screen_of_side(screen, SIDE_A) : *screen;
    const Screen *shown = view->duel == DUEL_APART ? &one : screen;
    const int variant = view_variant(view, shown);
    cells_open(picture, columns, GLYPHS_NONE);
    if (view->describe) {
        view->describe(shown, variant, picture);
    } else {
        Canvas canvas = {.width = columns, .height = rows, .picture = picture};
        view->draw(shown, (Area){&canvas, {0, 0, columns, rows}, GLYPHS_NONE}, STYLE_HEADING, variant);
    }
    if (picture->across == 0 || rows - 2 < PLOT_LEAST) { /* then the page is to blame */
        picture->has_axes = false;
        picture->n_notes = 0;
    }
    picture->of_moment = view->of_moment;
    if (!picture->time[0])
        screen_time_text(screen, experiment_time(screen->experiment), picture->time, sizeof picture->time);
    cells_fit(picture, rows);
}

void view_draw(const View *view, const Screen *screen, Area area, bool focused)
{
    const Style heading = focused ? STYLE_FOCUS : STYLE_HEADING;
    if (area.rect.width < 1 || area.rect.height < 1)
        return;
    if (screen_is_shared(screen))
        draw_sides(view, screen, area, heading);
    else
        draw_one(view, screen, area, heading);
}

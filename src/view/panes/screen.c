#include "view/panes/screen.h"
#include "view/panes/panes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void screen_default(Screen *screen)
{
    *screen = (Screen){
        .glyphs = GLYPHS_BRAILLE,
        .colours = 256,
        .state = STATE_PAUSED,
        .pace = 1,
        .focus = PANE_PARAMETERS,
        .upper = 1,
        .lower = 2,
        .references = SHOW_ALL,
        .magnified = 1,
        .looked_at = {0.5, 0.5},
        .cursor_time = NAN,
        .log_event = -1,
    };
}

void screen_read_view(Screen *screen, const ViewSettings *view)
{
    double window;
    if (sscanf(view->window, "%lf", &window) == 1 && window > 0)
        screen->window = window;
    for (int i = 0; i < SHOW_COUNT; i++)
        if (strcmp(view->references, reference_words[i]) == 0)
            screen->references = (ReferencesShown)i;
    for (int i = 0; colour_words[i]; i++)
        if (strcmp(view->colour, colour_words[i]) == 0)
            screen->variant[8] = i;
}

/* --- views ---------------------------------------------------------------------------------------- */

static int one_variant(const Screen *screen)
{
    (void)screen;
    return 1;
}

static const View views[] = {
    {1, "profile", view_profile, view_profile_variants, "profile", view_profile_word, true},
    {2, "probe", view_probe, view_probe_variants, "probe", view_probe_word, false},
    {3, "energies", view_energies, view_energies_variants, "energies", view_energies_word, false},
    {4, "shape functions", view_shapes, view_shapes_variants, "shapes", view_shapes_word, true},
    {5, "dispersion", view_dispersion, view_dispersion_variants, "dispersion", view_dispersion_word, false},
    {6, "spectrum", view_spectrum, view_spectrum_variants, "spectrum", view_spectrum_word, false},
    {7, "tables", view_table, view_table_variants, NULL, NULL, true},
    {8, "beam", view_beam, view_beam_variants, "beam", view_beam_word, true},
    {9, "log", view_log, one_variant, NULL, NULL, false},
};

/* NULL: there is none of that number. */
static const View *view_find(int number)
{
    for (size_t i = 0; i < sizeof views / sizeof *views; i++)
        if (views[i].number == number)
            return &views[i];
    return NULL;
}

const char *screen_view_missing(const Screen *screen, int view)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    if (!view_find(view))
        return "there is no such view for this problem";
    if (view == 4 && !bond_law_fits(sim) && (!sim->method->shapes || sim->n_sets < 2))
        return "this method has no mesh, so no shape functions";
    return NULL;
}

/* How two runs are shown in a view. */
typedef enum Sharing {
    SHARE_AXES, /* in the same axes; on a wide screen each in its own */
    SHARE_ONE,  /* always in the same: a run is a dot, or a letter in a list */
    SHARE_NONE  /* always each in its own, as far as there is room: else A alone */
} Sharing;

static Sharing sharing_of(int number)
{
    return number == 5 || number == 9 ? SHARE_ONE : number <= 3 || number == 6 ? SHARE_AXES : SHARE_NONE;
}

static void draw_one(const Screen *screen, const View *view, Area area, Style heading)
{
    const int variants = view->variants(screen), variant = screen->variant[view->number];
    view->draw(screen, area, heading, variant > 0 ? variant % variants : 0);
}

/* Whose picture it is stands at the end of its heading, in as few words as there is room for. */
static void name_side(const Screen *screen, DuelSide side, const char *note, Area area)
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
    snprintf(names[0], sizeof names[0], " %c %s%s ", letter, screen->duel->names[side == SIDE_B], note);
    snprintf(names[1], sizeof names[1], " %c%s ", letter, note);
    snprintf(names[2], sizeof names[2], " %c ", letter);
    int form = 0;
    while (form < 2 && end + text_columns(names[form]) + 1 > area.rect.width - 1)
        form++;
    area_text_right(area, area.rect.width - 1, 0, names[form],
                    side == SIDE_A ? STYLE_MEASURED : STYLE_SECOND);
}

/* The picture of one run of a duel. */
static void draw_side(const Screen *screen, DuelSide side, const char *note, const View *view, Area area,
                      Style heading)
{
    const Screen one = screen_of_side(screen, side);
    draw_one(&one, view, area, heading);
    if (sharing_of(view->number) != SHARE_AXES || view->number == 3)
        name_side(screen, side, note, area);
}

static void draw_sides(const Screen *screen, const View *view, Area area, Style heading)
{
    enum { STACK_HEIGHT = 14 };
    const int width = area.rect.width, height = area.rect.height;
    const bool wide = area.canvas->width >= SIDE_BY_SIDE;
    const Sharing sharing = sharing_of(view->number);
    if (!area.canvas->cells) {
        /* a figure has one pair of axes */
        const Screen one = screen_of_side(screen, SIDE_A);
        draw_one(sharing == SHARE_NONE ? &one : screen, view, area, heading);
    } else if (sharing == SHARE_ONE || (sharing == SHARE_AXES && !wide)) {
        draw_one(screen, view, area, heading);
    } else if (wide) {
        const int left = (width - 1) / 2;
        draw_side(screen, SIDE_A, "", view, area_part(area, 0, 0, left, height), heading);
        draw_side(screen, SIDE_B, "", view, area_part(area, left + 1, 0, width - left - 1, height), heading);
    } else if (height >= STACK_HEIGHT) {
        draw_side(screen, SIDE_A, "", view, area_part(area, 0, 0, width, height / 2), heading);
        draw_side(screen, SIDE_B, "", view, area_part(area, 0, height / 2, width, height - height / 2),
                  heading);
    } else {
        draw_side(screen, SIDE_A, screen->zoomed ? "" : ", z: and B", view, area, heading);
    }
}

void view_draw(const Screen *screen, int number, Area area, bool focused)
{
    const View *view = view_find(number);
    const Style heading = focused ? STYLE_FOCUS : STYLE_HEADING;
    if (!view)
        view = &views[0];
    if (area.rect.width < 1 || area.rect.height < 1)
        return;
    if (is_shared(screen))
        draw_sides(screen, view, area, heading);
    else
        draw_one(screen, view, area, heading);
}

/* --- the whole ------------------------------------------------------------------------------------ */

static Area area_of(const Screen *screen, Canvas *canvas, Rect rect)
{
    return area_part((Area){canvas, {0, 0, canvas->width, canvas->height}, screen->glyphs}, rect.x, rect.y,
                     rect.width, rect.height);
}

static void draw_too_small(Canvas *canvas)
{
    char text[64];
    snprintf(text, sizeof text, "matvib needs 40x12, this is %dx%d", canvas->width, canvas->height);
    Area whole = {canvas, {0, 0, canvas->width, canvas->height}, GLYPHS_ASCII};
    int lines = paragraph_lines(canvas->width, text), y = (canvas->height - lines) / 2;
    y = y > 0 ? y : 0;
    area_paragraph(whole, 0, y, canvas->width, canvas->height - y, text, STYLE_NORMAL);
}

static void draw_pane(const Screen *screen, PaneId pane, Area area)
{
    if (area.rect.width < 1 || area.rect.height < 1)
        return;
    switch (pane) {
    case PANE_PARAMETERS:
        if (screen->lesson.open)
            pane_lesson(screen, area);
        else if (area.rect.height == 1)
            pane_chosen_parameter(screen, area);
        else
            pane_parameters(screen, area);
        break;
    case PANE_MESH:
        pane_mesh(screen, area);
        break;
    case PANE_UPPER:
        view_draw(screen, screen->upper, area, is_focused(screen, pane));
        break;
    case PANE_LOWER:
        view_draw(screen, screen->lower, area, is_focused(screen, pane));
        break;
    case PANE_BOX:
        pane_box(screen, area);
        break;
    case PANE_INSPECTOR:
        if (inspector_find(screen))
            inspector_find(screen)->draw(screen, area);
        break;
    case PANE_COUNT:
        break;
    }
}

void screen_draw(const Screen *screen, Canvas *canvas)
{
    canvas_clear(canvas);
    canvas->large = screen->lecture;
    const Layout layout = layout_make(screen, canvas->width, canvas->height);
    if (layout.kind == LAYOUT_TOO_SMALL) {
        draw_too_small(canvas);
        if (screen->glyphs == GLYPHS_ASCII)
            canvas_to_ascii(canvas);
        return;
    }
    if (screen->help) {
        Rect all = {0, 1, canvas->width, canvas->height - 2};
        pane_help(screen, area_of(screen, canvas, all));
    } else {
        if (layout.banner.width > 0)
            pane_banner(screen, area_of(screen, canvas, layout.banner));
        for (int pane = 0; pane < PANE_COUNT; pane++)
            draw_pane(screen, (PaneId)pane, area_of(screen, canvas, layout.panes[pane]));
        if (layout.timeline.width > 0)
            pane_timeline(screen, area_of(screen, canvas, layout.timeline));
        if (layout.sides[0].width > 0) {
            view_energies(screen, area_of(screen, canvas, layout.sides[0]), STYLE_HEADING, 0);
            for (int i = 1; i < SIDES_MAX; i++)
                if (layout.sides[i].width > 0)
                    view_table(screen, area_of(screen, canvas, layout.sides[i]), STYLE_HEADING, i - 1);
        }
    }
    pane_title(screen, area_of(screen, canvas, layout.title));
    pane_bar(screen, area_of(screen, canvas, layout.bar));
    if (screen->glyphs == GLYPHS_ASCII)
        canvas_to_ascii(canvas);
}

/* --- on paper --------------------------------------------------------------------------------------- */

const char *screen_view_word(const Screen *screen, int number)
{
    const View *view = view_find(number);
    const bool drawn =
        view && (view->draw != view_beam || experiment_simulation(screen->experiment)->dimensions == 2);
    return drawn && !screen_view_missing(screen, number) ? view->word : NULL;
}

const char *screen_variant_word(const Screen *screen, int number, int variant)
{
    const View *view = view_find(number);
    const bool known = view && view->variant_word && variant >= 0 && variant < view->variants(screen);
    return known ? view->variant_word(screen, variant) : NULL;
}

bool screen_makes_figure(const Screen *screen, int number)
{
    const View *view = view_find(number);
    if (!screen_view_word(screen, number))
        return false;
    const int variants = view->variants(screen), variant = screen->variant[number];
    return !view->variant_word || view->variant_word(screen, variant > 0 ? variant % variants : 0);
}

void screen_sketch(const Screen *screen, int number, int columns, int rows, Sketch *sketch)
{
    Canvas canvas = {.width = columns, .height = rows, .sketch = sketch};
    const View *view = view_find(number);
    sketch_open(sketch);
    sketch->of_moment = view && view->of_moment;
    time_text(screen, experiment_time(screen->experiment), sketch->time, sizeof sketch->time);
    view_draw(screen, number, (Area){&canvas, {0, 0, columns, rows}, GLYPHS_NONE}, false);
}

CommandId screen_bar_command(const Screen *screen, int width, int x)
{
    return bar_command_at(screen, width, x);
}

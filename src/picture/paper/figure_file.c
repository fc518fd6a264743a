/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A figure from its name to its file: which views make one, panels, what the page says of the run. */
#include "picture/paper/figure_file.h"
#include "scenario/parameters.h"
#include "scenario/settings.h"
#include "scenario/rows/rows.h"
#include "base/text.h"
#include "views/view.h"
#include "picture/paper/paper.h"
#include "base/assertion.h"
#include "picture/paper/cairo_calls.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* The layout of a figure's page, in points. */

#define MARGIN      10.0
#define BARE_MARGIN 3.0         /* for the ends of lines and digits */
#define MILLIMETRES (72 / 25.4) /* points in one */

enum { COLUMNS_MANY = 3 }; /* from so many panels on they are in two columns */

static const Type small = {.size = SIZE_SMALL, .colour = GREY};

/* The panel whose legend and colours can stand for all: that which names most. NULL: none, or it is alone. */
static const Picture *common_of(const Figure *figure)
{
    const Picture *most = &figure->panels[0]->picture;
    for (int i = 1; i < figure->count; i++)
        if (figure->panels[i]->picture.n_keys > most->n_keys)
            most = &figure->panels[i]->picture;
    for (int i = 0; i < figure->count; i++) {
        const Picture *picture = &figure->panels[i]->picture;
        for (int k = 0; k < picture->n_keys; k++) {
            const PictureKey *key = &picture->keys[k];
            int at = 0;
            while (at < most->n_keys &&
                   (strcmp(most->keys[at].name, key->name) != 0 || most->keys[at].sign != key->sign))
                at++;
            if (at == most->n_keys)
                return NULL;
        }
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
        const Type type = {.size = SIZE_WORDS, .colour = faint ? GREY : BLACK};
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

/* A picture with what stands above and below it, of which the height is returned; without paper that is only
 * measured. `alone`: with a legend of its own. A bare one has its axes and, beside others, its time. */
static double draw_panel(Paper *paper, const Figure *figure, int index, Box box, bool alone)
{
    const Type caption = {.size = SIZE_WORDS, .bold = true};
    const FigurePanel *panel = figure->panels[index];
    const Picture *picture = &panel->picture;
    const bool titled = figure->bare ? figure->count > 1 : panel->caption[0];
    const double title = titled ? LINE_HEIGHT * SIZE_WORDS : 0;
    const double legend = alone && picture->n_keys > 0 ? draw_legend_rows(NULL, picture, box) + 2 : 0;
    const double bar = alone ? draw_heat_bar(NULL, picture, box) : 0;
    double notes = figure->bare ? 0 : draw_all_notes(NULL, picture, alone, box);
    notes += notes > 0 ? 4 : 0;
    const double around = title + legend + bar + notes;
    if (!paper)
        return around;
    if (title > 0)
        draw_words(paper, box.x, box.y + SIZE_WORDS, panel->caption, &caption);
    box.y += title;
    if (legend > 0)
        draw_legend_rows(paper, picture, box);
    box.y += legend;
    box.height = box.height - title - legend - (notes + bar);
    draw_plot(paper, picture, box);
    if (bar > 0)
        draw_heat_bar(paper, picture, (Box){box.x, box.y + box.height, box.width, bar});
    if (notes > 0)
        draw_all_notes(paper, picture, alone, (Box){box.x, box.y + box.height + bar + 4, box.width, notes});
    return around;
}

/* --- the whole ------------------------------------------------------------------------------------- */

static int columns_of(const Figure *figure)
{
    return figure->count >= COLUMNS_MANY ? 2 : 1;
}

static double panel_width(const Figure *figure, int count)
{
    const double inner = figure->width * MILLIMETRES - 2 * (figure->bare ? BARE_MARGIN : MARGIN);
    return count >= COLUMNS_MANY ? (inner - MARGIN) / 2 : inner;
}

static double usual_height(const Figure *figure, int panels)
{
    return (panels == 1 ? 0.56 : 0.5) * panel_width(figure, panels);
}

static int rows_of(const Figure *figure)
{
    return (figure->count + columns_of(figure) - 1) / columns_of(figure);
}

/* Draws the page with plots of this height, 0: the usual one, or measures it if there is no paper: its height
 * follows from what is on it. */
static double lay_out(Paper *paper, const Figure *figure, double plot)
{
    const bool bare = figure->bare;
    const int columns = columns_of(figure), rows = rows_of(figure);
    const double wide = panel_width(figure, figure->count), width = figure->width * MILLIMETRES - 2 * MARGIN;
    const double margin = bare ? BARE_MARGIN : MARGIN;
    const Picture *common = bare ? NULL : common_of(figure);
    const bool alone = !bare && !common;
    const Type title = {.size = SIZE_TITLE, .bold = true};
    const Box whole = {MARGIN, MARGIN, width, 0};
    double y = margin, around = 0, high = 0;
    if (!bare)
        y += draw_phrases(paper, figure->title, whole, &title) + (figure->title[0] ? 3 : 0);
    if (common) {
        y += draw_legend_rows(paper, common, (Box){MARGIN, y, width, 0}) + 2;
        y += draw_heat_bar(paper, common, (Box){MARGIN, y, width, 0}) + 2;
        y += draw_notes(paper, common, true, (Box){MARGIN, y, width, 0}) + 4;
    }
    for (int i = 0; i < figure->count; i++) {
        around = fmax(around, draw_panel(NULL, figure, i, (Box){0, 0, wide, 0}, alone));
        high = fmax(high, draw_plot_height(&figure->panels[i]->picture, wide));
    }
    high = (plot > 0 ? plot : high > 0 ? high : usual_height(figure, figure->count)) + around;
    for (int i = 0; i < figure->count && paper; i++) {
        const Box box = {margin + i % columns * (wide + MARGIN), y + i / columns * (high + MARGIN), wide,
                         high};
        draw_panel(paper, figure, i, box, alone);
    }
    y += rows * high + (rows - 1) * MARGIN + (bare ? 0 : 6);
    if (!bare)
        y += draw_phrases(paper, figure->parameters, (Box){MARGIN, y, width, 0}, &small);
    return y + margin;
}

#define PLOT_LEAST    70.0  /* points, with its axes: less is not read */
#define WIDTH_DEFAULT 160.0 /* mm: the text of an A4 page */

enum { NAME_MAX_BYTES = 48 };

/* --- kinds of files -------------------------------------------------------------------------------- */

typedef enum Format { FORMAT_SVG, FORMAT_TEX, FORMAT_GP, FORMAT_PDF, FORMAT_PNG, FORMAT_NONE } Format;

static Format format_of(const char *file)
{
    static const char *const endings[] = {".svg", ".tex", ".gp", ".pdf", ".png"};
    const char *dot = strrchr(file, '.');
    for (int i = 0; dot && i < FORMAT_NONE; i++)
        if (strcasecmp(dot, endings[i]) == 0)
            return (Format)i;
    return FORMAT_NONE;
}

bool figure_is_name(const char *file)
{
    return format_of(file) != FORMAT_NONE;
}

bool figure_allowed(const char *file, Status *status)
{
    const Format format = format_of(file);
    if (format == FORMAT_NONE)
        return status_refuse(status, "%.200s: not a figure file (FILE.svg, .pdf, .png, .tex or .gp)", file);
    return format < FORMAT_PDF || cairo_load(status);
}

/* --- views by name --------------------------------------------------------------------------------- */

/* The next name ("beam", or "beam:damage" for a variant) that stands for a view here, of view *i and its
 * variant, which begin at 0 and -1; false: no more. */
static bool next_name(const Screen *screen, int *i, int *variant, char name[NAME_MAX_BYTES])
{
    for (++*variant; *i < n_views; ++*i, *variant = 0) {
        const View *view = views[*i];
        const char *part = view_variant_word(view, screen, *variant);
        name[0] = '\0';
        if (view_is_on_paper(view, screen) && (part || *variant == 0)) {
            snprintf(name, NAME_MAX_BYTES, "%s%s%s", view->word, part ? ":" : "", part ? part : "");
            return true;
        }
    }
    return false;
}

bool figure_view(Screen *screen, const char *wanted, const View **view, Status *status)
{
    char name[NAME_MAX_BYTES], all[400] = "";
    *view = view_named(wanted); /* by its digit */
    if (*view && view_is_on_paper(*view, screen))
        return true;
    for (int i = 0, variant = -1; next_name(screen, &i, &variant, name);) {
        const char *colon = strchr(name, ':');
        const bool whole = strcmp(name, wanted) == 0;
        const bool bare = colon && strlen(wanted) == (size_t)(colon - name) &&
                          strncmp(name, wanted, (size_t)(colon - name)) == 0;
        *view = views[i];
        if (whole)
            view_choose_variant(*view, screen, variant);
        if (whole || bare)
            return true;
        /* the view is named once: profile:u|v|stress */
        text_append(all, sizeof all, "%s%s",
                    variant > 0 ? "|"
                    : *all      ? " "
                                : "",
                    variant > 0 ? colon + 1 : name);
    }
    return status_refuse(status, "%.60s: no such view here (%s)", wanted, all);
}

void figure_names(const Screen *screen, FILE *stream)
{
    char name[NAME_MAX_BYTES];
    for (int i = 0, variant = -1; next_name(screen, &i, &variant, name);)
        fprintf(stream, "%s\n", name);
}

/* --- what stands around the panels ------------------------------------------------------------------ */

/* All parameters but where files go, by groups: "Bar: length 25, density 1;  Start: mode 5". */
static void tell_parameters(const Settings *settings, char *out, size_t size)
{
    const char *group = "";
    out[0] = '\0';
    for (int i = 0; i < n_parameters; i++) {
        const Parameter *parameter = &parameters[i];
        char value[LIST_MAX];
        if (!parameter_applies_to(settings, parameter) || strncmp(parameter->key, "output.", 7) == 0)
            continue;
        settings_show(settings, parameter, value);
        const char *unit = settings->problem->si ? parameter_in(parameter, settings->problem).unit : "";
        if (!value[0] || strcmp(value, "-") == 0)
            continue;
        const bool more = strcmp(group, parameter->group) == 0;
        double number;
        if (strcmp(unit, "1") == 0 || !text_to_double(value, &number))
            unit = ""; /* of a word */
        text_append(out, size, "%s%s%s%s %s%s%s",
                    !*out  ? ""
                    : more ? ",  "
                           : ";  ",
                    more ? "" : parameter->group, more ? "" : ": ", parameter->label, value,
                    unit[0] ? " " : "", unit);
        group = parameter->group;
    }
    /* "cuts: notch 0 50% 50% 50%;  loads: top top 0% 100% 0 1.2e7,  bottom ...". */
    char text[ROW_TEXT_MAX];
    for (int kind = 0; kind < ROW_KINDS; kind++)
        for (int row = 0; settings_have_rows(settings, kind) && row < settings->rows[kind].count; row++) {
            const char *name = settings->rows[kind].rows[row].name;
            settings_row_show(settings, kind, row, text);
            text_append(out, size, "%s%s%s%s%s", row > 0 ? ",  " : ";  ",
                        row > 0 ? "" : row_kinds[kind].section, row > 0 ? "" : ": ", name, *name ? " " : "");
            text_append(out, size, "%s", text);
        }
    text_append(out, size, ".  matvib " PACKAGE_VERSION);
}

void figure_open(Figure *figure, double width, double height)
{
    *figure = (Figure){.width = width > 0 ? width : WIDTH_DEFAULT, .height = height};
}

void figure_close(Figure *figure)
{
    for (int i = 0; i < figure->count; i++) {
        picture_close(&figure->panels[i]->picture);
        free(figure->panels[i]);
    }
    figure->count = 0;
}

static bool no_memory(Status *status)
{
    return status_fail(status, "not enough memory for a figure");
}

bool figure_add(Figure *figure, const Screen *screen, const View *view, int panels, Status *status)
{
    const Settings *settings = screen_settings(screen);
    if (figure->count == FIGURE_PANELS_MAX)
        return status_refuse(status, "a page has room for %d pictures", FIGURE_PANELS_MAX);
    FigurePanel *panel = calloc(1, sizeof *panel);
    if (!panel)
        return no_memory(status);
    /* as many ticks as a pane of the terminal has that is as large, counted in characters of the labels */
    ASSERT_INT(panels, >=, 1);
    const int columns = (int)(panel_width(figure, panels) / (0.66 * SIZE_WORDS));
    const int rows = (int)(usual_height(figure, panels) / (1.3 * SIZE_WORDS));
    errno = 0;
    view_describe(view, screen, columns, rows, &panel->picture);
    const Picture *picture = &panel->picture;
    /* a screen is drawn again, a page is not */
    const bool in_want = errno == ENOMEM || picture->plot.lost;
    if (in_want || !(picture->has_axes || picture->n_tables > 0)) {
        const char *name = *picture->heading ? picture->heading : view->word;
        if (in_want)
            no_memory(status);
        else if (picture->n_notes > 0)
            status_fail(status, "%s: nothing to draw: %s", name, picture->notes[0].text);
        else
            status_refuse(status, "%s: nothing to draw: the page is too small for it (at least 30x30 mm)",
                          name);
        picture_close(&panel->picture);
        free(panel);
        return false;
    }
    if (picture->of_moment || panels > 1) { /* "t 0.1200 ms" as "t = 0.12 ms" */
        const char *number = picture->time + strcspn(picture->time, "0123456789");
        const char *point = strchr(number, '.');
        const size_t whole = strspn(number, "0123456789");
        size_t kept = whole;
        for (size_t i = 1; point && point[i] >= '0' && point[i] <= '9'; i++)
            if (point[i] != '0')
                kept = whole + 1 + i;
        snprintf(panel->caption, sizeof panel->caption, "t = %.*s%s", (int)kept, number,
                 number + strspn(number, "0123456789."));
    }
    if (figure->count == 0) {
        const char *mistake = settings_mistake(settings);
        snprintf(figure->title, sizeof figure->title, "%s%s%s", settings->title,
                 mistake ? "  with a mistake: " : "", mistake ? mistake : "");
        tell_parameters(settings, figure->parameters, sizeof figure->parameters);
    }
    figure->panels[figure->count++] = panel;
    return true;
}

/* --- the file --------------------------------------------------------------------------------------- */

double figure_enlargement(const Figure *figure, bool *differ)
{
    double least = 0, most = 0;
    for (int i = 0; i < figure->count; i++) {
        const PictureMap *map = figure->panels[i]->picture.map;
        const double factor = map ? map->enlarged : 0;
        least = i == 0 || factor < least ? factor : least;
        most = factor > most ? factor : most;
    }
    *differ = least < most;
    return least;
}

bool figure_suits(const Figure *figure, const char *name, Status *status)
{
    const Format format = format_of(name);
    for (int i = 0; i < figure->count && (format == FORMAT_TEX || format == FORMAT_GP); i++)
        if (figure->panels[i]->picture.kind > PICTURE_PATH)
            return status_refuse(
                status, "%s: the view has no curves, which .tex and .gp need (.svg, .pdf or .png)", name);
    return figure_allowed(name, status);
}

/* Words that a low page has no room for: parameters, then explanations, then results. False: these were all.
 */
static bool leave_out(Figure *figure, int which)
{
    if (which == 0)
        figure->parameters[0] = '\0';
    for (int i = 0; i < figure->count && which > 0; i++)
        for (int k = 0; k < figure->panels[i]->picture.n_notes; k++) {
            PictureNote *note = &figure->panels[i]->picture.notes[k];
            note->told |= which > 1 || note->style == STYLE_FAINT;
        }
    return which < 3;
}

bool figure_write(Figure *figure, Asker asker, const char *name, bool force, Status *status)
{
    const Format format = format_of(name);
    const bool drawn = format != FORMAT_TEX && format != FORMAT_GP;
    OutputFile file;
    double plot = 0;
    if (!figure_suits(figure, name, status))
        return false;
    for (int left = 0; figure->height > 0 && drawn; left++) {
        const double words = lay_out(NULL, figure, 1) - rows_of(figure);
        const double usual = (lay_out(NULL, figure, 0) - words) / rows_of(figure);
        const double least = fmin(PLOT_LEAST, usual);
        plot = (figure->height * MILLIMETRES - words) / rows_of(figure);
        if (plot >= least)
            break;
        if (!leave_out(figure, left))
            return status_refuse(status,
                                 "%s: %g mm are too low for this page (at least %.0f, or a wider one)", name,
                                 figure->height, ceil((words + rows_of(figure) * least) / MILLIMETRES));
    }
    if (!output_open(&file, asker, name, force, status))
        return false;
    /* What is compared is drawn to one measure. */
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < figure->count; i++) {
        const PictureMap *map = figure->panels[i]->picture.map;
        low = map ? fmin(low, map->low) : low;
        high = map ? fmax(high, map->high) : high;
    }
    for (int i = 0; i < figure->count; i++)
        if (figure->panels[i]->picture.map) {
            figure->panels[i]->picture.map->low = low;
            figure->panels[i]->picture.map->high = high;
        }
    const double width = figure->width * MILLIMETRES,
                 height = figure->height > 0 ? figure->height * MILLIMETRES : lay_out(NULL, figure, 0);
    if (!drawn) {
        (format == FORMAT_TEX ? figure_write_tex : figure_write_gnuplot)(file.stream, figure,
                                                                         columns_of(figure));
        return output_end(&file, true, status);
    }
    Paper *paper = format == FORMAT_SVG   ? paper_svg(file.stream, width, height, figure->title, status)
                   : format == FORMAT_PDF ? paper_pdf(file.stream, width, height, figure->title, status)
                                          : paper_png(file.stream, width, height, status);
    bool sound = paper != NULL;
    if (paper) {
        errno = 0;
        lay_out(paper, figure, plot);
        const bool in_want = errno == ENOMEM;
        sound = paper->kind->finish(paper, status) && (!in_want || no_memory(status));
    }
    return output_end(&file, sound, status);
}

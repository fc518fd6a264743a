/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A body in the plane through its height, at the chosen particle's x, beside what beam theory says of a
 * section: the axial displacement lies on the line -y duy/dx where sections stay plane and upright (eq. 14 of
 * paper P); the bending stress is a straight line; the shear stress a parabola. Where cells hold several
 * columns of particles those of the chosen one's cell are drawn, and their mean: what shears them apart is
 * not shear of the beam but that of cells that cannot bend. */
#include "views/map/map.h"
#include "scenario/concern_body.h"
#include "scenario/concern_time.h"
#include "views/view.h"
#include "base/math/functions.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* What is drawn: a field of set 0. */
typedef struct SectionPart {
    const char *field, *name, *unit;
    const char *theory; /* the line beside, where theory knows the run */
    const char *own;    /* the same for the section's own moment or force; "": from the slope */
    const char *resultant, *resultant_unit; /* NULL: none */
    int power;                              /* of y in the resultant: a moment or a force */
} SectionPart;

static const SectionPart parts[] = {
    {"ux", "section, y", "m", "-y duy/dx (eq. 14)", "", NULL, NULL, 0},
    {"sxx", "bending, y", "Pa", "beam theory", "same moment", "moment", "N m", 1},
    {"sxy", "shear, y", "Pa", "beam theory", "same force", "force", "N", 0},
};

enum { PARTS = sizeof parts / sizeof *parts, COLUMNS_MOST = 12 };

/* The columns of one cell, the chosen one among them. */
typedef struct Section {
    const Screen *screen;
    const Simulation *sim;
    const SectionPart *of;
    Body body;
    size_t chosen, first, columns; /* columns of the lattice: first, first + 1, ... */
    size_t rows;
    double x, middle;          /* where it is at rest, and the height of the axis */
    double *y, *mean, *theory; /* over the rows, in one block with the values of each column */
    double *values[COLUMNS_MOST];
    bool known; /* the theory is that of the run; else of the section's own moment or force */
    double resultant;
} Section;

static double named_at(const Section *section, const char *name, size_t row, size_t column)
{
    return simulation_named(section->sim, 0, name, row * (size_t)section->body.nx + column);
}

/* The mean of a field over the middle row, or the two middle ones, of a column. */
static double on_axis(const Section *section, const char *name, size_t column)
{
    const size_t rows = section->rows;
    return (named_at(section, name, (rows - 1) / 2, column) + named_at(section, name, rows / 2, column)) / 2;
}

/* --- what is there ---------------------------------------------------------------------------------- */

/* The line -y duy/dx by the slope over two spacings, one at an end; the stresses of theory as it knows the
 * run, or those that have the section's own moment M or force Q: M y/I, 3 Q/(2 A) (1 - (2 y/h)^2). */
static double theory_at(const Section *section, double y, double time)
{
    const Settings *settings = experiment_settings(section->screen->experiment);
    const double height = section->body.size[1], area = height * settings_geometry(settings)->thickness;
    if (section->known)
        return references_section(experiment_references(section->screen->experiment), section->of->field,
                                  section->x, y, time);
    if (section->of->power == 1)
        return section->resultant * y * 12 / (area * height * height);
    return 1.5 * section->resultant / area * (1 - 4 * y * y / (height * height));
}

static double slope_of(const Section *section)
{
    const size_t at = section->chosen, left = at > 0 ? at - 1 : at,
                 right = at + 1 < (size_t)section->body.nx ? at + 1 : at;
    return (on_axis(section, "uy", right) - on_axis(section, "uy", left)) /
           (named_at(section, "x0", 0, right) - named_at(section, "x0", 0, left));
}

static bool take_section(Section *section, const Screen *screen, const SectionPart *of)
{
    *section = (Section){.screen = screen, .of = of, .sim = screen_simulation(screen)};
    if (!body_of(section->sim, &section->body) || section->body.ny < 2 || section->body.nx < 2)
        return false;
    const size_t nx = (size_t)section->body.nx, count = section->body.count;
    const size_t rows = section->rows = (size_t)section->body.ny;
    section->chosen = (screen->chosen.particle < count ? screen->chosen.particle : 0) % nx;
    section->middle = section->body.low[1] + section->body.size[1] / 2;
    /* The columns whose particles of the middle row lie in one cell of the mesh. */
    const Simulation *sim = section->sim;
    section->first = section->chosen;
    section->columns = 1;
    if (simulation_has(sim, HAS_MESH) && section->of->resultant) {
        const int node_x = simulation_find_field(sim, 1, "x");
        const double from = simulation_value(sim, node_x, 0), cell = simulation_value(sim, node_x, 1) - from;
        const size_t row = section->rows / 2;
        const double own = floor((named_at(section, "x", row, section->chosen) - from) / cell);
        while (section->first > 0 &&
               floor((named_at(section, "x", row, section->first - 1) - from) / cell) == own)
            section->first--;
        while (section->first + section->columns < nx && section->columns < COLUMNS_MOST &&
               floor((named_at(section, "x", row, section->first + section->columns) - from) / cell) == own)
            section->columns++;
    }
    section->y = calloc((3 + section->columns) * rows, sizeof *section->y);
    if (!section->y)
        return false;
    section->mean = section->y + rows;
    section->theory = section->mean + rows;
    for (size_t c = 0; c < section->columns; c++) {
        section->values[c] = section->theory + (1 + c) * rows;
        section->x += named_at(section, "x0", 0, section->first + c) / (double)section->columns;
        const double of_axis = of->resultant ? 0 : on_axis(section, of->field, section->first + c);
        for (size_t j = 0; j < rows; j++) {
            section->y[j] = named_at(section, "y0", j, section->first + c);
            section->values[c][j] = named_at(section, of->field, j, section->first + c) - of_axis;
            section->mean[j] += section->values[c][j] / (double)section->columns;
        }
    }
    const double time = experiment_time(screen->experiment), slope = slope_of(section);
    /* The resultant of a stress over the height: force sum sxy dA, moment sum sxx y dA. */
    const double area = section->body.spacing *
                        settings_geometry(experiment_settings(section->screen->experiment))->thickness;
    section->resultant = 0;
    for (size_t j = 0; j < section->rows; j++)
        section->resultant +=
            section->mean[j] * math_pow(section->y[j] - section->middle, section->of->power) * area;
    section->known = of->resultant && isfinite(references_section(experiment_references(screen->experiment),
                                                                  of->field, section->x, 0, time));
    for (size_t j = 0; j < rows; j++) {
        const double y = section->y[j] - section->middle;
        section->theory[j] = of->resultant ? theory_at(section, y, time) : -y * slope;
    }
    return true;
}

/* --- words ------------------------------------------------------------------------------------------ */

/* How far the columns of the cell are from their mean, root mean square. */
static double apart(const Section *section)
{
    double sum = 0;
    for (size_t c = 0; c < section->columns; c++)
        for (size_t j = 0; j < section->rows; j++) {
            const double off = section->values[c][j] - section->mean[j];
            sum += off * off;
        }
    return sqrt(sum / (double)(section->columns * section->rows));
}

static void append_quantity(char out[160], const char *before, double value, const char *unit)
{
    Axis axis = axis_symmetric(fabs(value));
    char scale[TICK_TEXT_MAX];
    axis_scale_text(&axis, unit, scale);
    text_append(out, 160, "%s %s%s%s", before, text_fitted(value / math_pow(10, axis.exponent), 3, 8).text,
                scale[0] ? " " : "", scale);
}

static void section_line(const Section *section, char out[160])
{
    const SectionPart *of = section->of;
    /* How far the section is from the line, root mean square, and against how far the line reaches. */
    double off = 0, line = 0;
    for (size_t j = 0; j < section->rows; j++) {
        const double there = section->theory[j];
        off += (section->mean[j] - there) * (section->mean[j] - there);
        line += there * there;
    }
    const double share = line > 0 ? sqrt(off / line) : NAN;
    snprintf(out, 160, "at x %.2f mm", section->x / 1e-3);
    /* sections of a beam stay plane; of a plate nothing of the kind is known */
    if (!(screen_problem(section->screen)->concerns & CONCERN_BEAM))
        return;
    if (!of->resultant) {
        append_quantity(out, "  off the line by", sqrt(off / (double)section->rows), of->unit);
        if (share < 1)
            text_append(out, 160, " = %.1f %%", 100 * share);
        text_append(out, 160, "  duy/dx %s", text_fitted(slope_of(section), 3, 10).text);
        return;
    }
    text_append(out, 160, "  %s %.3g %s", of->resultant, section->resultant, of->resultant_unit);
    if (share < 1)
        text_append(out, 160, "  off %s by %.1f %%", section->known ? "theory" : "the line", 100 * share);
    if (!section->known)
        text_append(out, 160, "  theory not known");
    if (section->columns > 1)
        append_quantity(out, "  columns apart", apart(section), of->unit);
}

/* --- the view ---------------------------------------------------------------------------------------- */

static void add_curve(const Section *section, const double *values, Pen pen, Plot *plot)
{
    plot_begin(plot, STROKE_LINE, pen);
    for (size_t j = 0; j < section->rows; j++)
        plot_point(plot, values[j], section->y[j]);
}

/* Those whose field there is, one after the other; NULL: no more. */
static const SectionPart *part_of(const Screen *screen, int variant)
{
    const Simulation *sim = screen_simulation(screen);
    for (int i = 0; i < PARTS; i++)
        if (simulation_find_field(sim, 0, parts[i].field) >= 0 && variant-- == 0)
            return &parts[i];
    return NULL;
}

static const char *word_of(const Screen *screen, int variant)
{
    const SectionPart *part = part_of(screen, variant);
    return part ? part->field : NULL;
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    const SectionPart *part = part_of(screen, variant);
    Section section = {.y = NULL};
    if (part && screen_has(screen, HAS_PLANE) && take_section(&section, screen, part)) {
        const bool theory = screen_shows_exact(screen) && screen_problem(screen)->concerns & CONCERN_BEAM;
        const bool several = section.columns > 1;
        const double bottom = section.body.low[1];
        char line[160];
        picture->kind = PICTURE_UPRIGHT;
        picture->compares = true;
        /* So that the axis keeps still while the body oscillates: what theory reaches in the run too. */
        enum { TIMES = 32, HEIGHTS = 2 };
        const double end = settings_time(experiment_settings(section.screen->experiment))->end;
        double reach = 0;
        for (size_t j = 0; j < section.rows; j++) {
            reach = fmax(reach, fabs(section.theory[j]));
            for (size_t c = 0; c < section.columns; c++)
                reach = fmax(reach, fabs(section.values[c][j]));
        }
        for (int i = 0; i <= TIMES && section.known; i++)
            for (int k = 0; k <= HEIGHTS; k++)
                reach = fmax(reach, fabs(theory_at(&section, section.body.size[1] * k / 4, end * i / TIMES)));
        picture_axes(picture, axis_symmetric(reach), part->field, part->unit,
                     axis_make(bottom, bottom + section.body.size[1]), part->name, "m");
        picture_name(picture, pen_measured, several ? "mean" : "measured");
        if (several)
            picture_name(picture, pen_second, "columns");
        if (theory)
            picture_name(picture, pen_exact, section.known || !part->resultant ? part->theory : part->own);
        if (theory) {
            enum { PIECES = 48 };
            const double slope = part->resultant ? 0 : slope_of(&section);
            const double time = experiment_time(screen->experiment);
            plot_begin(&picture->plot, STROKE_LINE, pen_exact);
            for (int i = 0; i <= PIECES; i++) {
                const double y = bottom + section.body.size[1] * i / PIECES, up = y - section.middle;
                plot_point(&picture->plot, part->resultant ? theory_at(&section, up, time) : -up * slope, y);
            }
        }
        for (size_t c = 0; c < section.columns && several; c++)
            add_curve(&section, section.values[c], pen_second, &picture->plot);
        add_curve(&section, section.mean, pen_measured, &picture->plot);
        section_line(&section, line);
        picture_note(picture, STYLE_NORMAL, "%s", line);
    } else
        picture_say(picture, "section",
                    "A bar has no height: only a body in the plane has a section to look at.");
    free(section.y);
}

const View view_section = {
    .word = "section",
    .help = "a beam or plate through its height at the chosen particle: displacement; again: bending stress, "
            "shear",
    .home = PANE_UPPER,
    .describe = describe,
    .variant_word = word_of,
    .duel = DUEL_APART,
    .on_paper_with = HAS_PLANE,
    .needs = HAS_PLANE,
    .lacking = "a bar has no height to look through",
};

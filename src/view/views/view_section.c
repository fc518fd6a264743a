/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One more profile of a beam: the axial displacement through its thickness, at the chosen particle's x, with
 * the line on which it lies where sections stay plane and upright (eq. 14 of paper P): ux = -y duy/dx. */
#include "view/views/views.h"
#include "view/panes/panes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct Section {
    double *y, *ux; /* over the rows; ux less that of the axis */
    size_t rows;
    double x, axis, slope; /* place, height of the axis, duy/dx there */
} Section;

static double named_at(const Simulation *sim, const char *name, size_t index)
{
    return simulation_value(sim, simulation_find_field(sim, 0, name), index);
}

static void free_section(Section *section)
{
    free(section->y);
    free(section->ux);
}

/* The mean of a field over the middle row, or the two middle ones, of a column. */
static double on_axis(const Simulation *sim, const char *name, size_t column, size_t columns, size_t rows)
{
    return (named_at(sim, name, (rows - 1) / 2 * columns + column) +
            named_at(sim, name, rows / 2 * columns + column)) /
           2;
}

static bool take_section(const Screen *screen, Section *section)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const size_t columns = (size_t)screen_derived(screen, "columns"), count = sim->counts[0];
    *section = (Section){.rows = columns > 0 ? count / columns : 0};
    if (section->rows < 2 || columns < 2)
        return false;
    const size_t column = (screen->chosen.particle < count ? screen->chosen.particle : 0) % columns;
    section->y = malloc(section->rows * sizeof *section->y);
    section->ux = malloc(section->rows * sizeof *section->ux);
    if (!section->y || !section->ux)
        return false;
    section->x = named_at(sim, "x0", column);
    section->axis = on_axis(sim, "y0", column, columns, section->rows);
    const double ux = on_axis(sim, "ux", column, columns, section->rows);
    for (size_t j = 0; j < section->rows; j++) {
        section->y[j] = named_at(sim, "y0", j * columns + column);
        section->ux[j] = named_at(sim, "ux", j * columns + column) - ux;
    }
    /* over two spacings, one at an end */
    const size_t left = column > 0 ? column - 1 : column, right = column + 1 < columns ? column + 1 : column;
    section->slope = (on_axis(sim, "uy", right, columns, section->rows) -
                      on_axis(sim, "uy", left, columns, section->rows)) /
                     (named_at(sim, "x0", right) - named_at(sim, "x0", left));
    return true;
}

static double on_line(const Section *section, double y)
{
    return -(y - section->axis) * section->slope;
}

/* How far the section is from the line, root mean square, and against how far the line reaches. */
static double off_line(const Section *section, double *share)
{
    double off = 0, line = 0;
    for (size_t j = 0; j < section->rows; j++) {
        const double there = on_line(section, section->y[j]);
        off += (section->ux[j] - there) * (section->ux[j] - there);
        line += there * there;
    }
    *share = line > 0 ? sqrt(off / line) : NAN;
    return sqrt(off / (double)section->rows);
}

static void section_line(const Section *section, char out[160])
{
    char slope[NUMBER_TEXT_MAX], off[NUMBER_TEXT_MAX];
    double share, away = off_line(section, &share);
    const bool large = away >= 1e-6;
    text_fitted(away / (large ? 1e-6 : 1e-9), 2, 8, off);
    text_fitted(section->slope, 3, 10, slope);
    snprintf(out, 160, "at x %.2f mm", section->x / 1e-3);
    text_append(out, 160, "  off the line by %s %s", off, large ? "um" : "nm");
    if (share < 1)
        text_append(out, 160, " = %.1f %%", 100 * share);
    text_append(out, 160, "  duy/dx %s", slope);
}

void section_draw(const Screen *screen, Area area, Style heading)
{
    Section section;
    if (!take_section(screen, &section)) {
        area_rule(area, 0, "section", heading);
        free_section(&section);
        return;
    }
    const int under = area.rect.height < 8 ? 0 : 1;
    Area plot_area = area_part(area, 0, 1, area.rect.width, area.rect.height - 1 - under);
    double reach = 0;
    const size_t rows = section.rows;
    const double half = (section.y[1] - section.y[0]) / 2, bottom = section.y[0] - half,
                 top = section.y[rows - 1] + half;
    for (size_t j = 0; j < rows; j++)
        reach = fmax(reach, fmax(fabs(section.ux[j]), fabs(on_line(&section, section.y[j]))));
    Axis x = axis_symmetric(reach, area.rect.width / 9);
    Axis y = axis_make(bottom, top, plot_area.rect.height < 6 ? 3 : 5);
    const Legend legend[] = {{LINE_SOLID, '*', STYLE_MEASURED, "measured", NULL},
                             {LINE_DOTTED, '.', STYLE_EXACT, "-y duy/dx (eq. 14)", NULL}};
    char scale[TICK_TEXT_MAX], x_scale[TICK_TEXT_MAX], name[TICK_TEXT_MAX + 8];
    axis_scale_text(&y, "m", scale);
    axis_scale_text(&x, "m", x_scale);
    snprintf(name, sizeof name, "ux, %s", x_scale);
    heading_draw(area, heading, "section, y", scale, legend, screen_shows_exact(screen) ? 2 : 1);
    Area inner = axes_draw(plot_area, &x, &y, name, GUTTER);

    Plot plot;
    plot_open(&plot, x, y);
    if (screen_shows_exact(screen)) {
        plot_begin(&plot, STROKE_LINE, LINE_DOTTED, STYLE_EXACT, RANK_EXACT, '.');
        plot_point(&plot, on_line(&section, bottom), bottom);
        plot_point(&plot, on_line(&section, top), top);
    }
    plot_begin(&plot, STROKE_LINE, LINE_SOLID, STYLE_MEASURED, RANK_MEASURED, '*');
    for (size_t j = 0; j < rows; j++)
        plot_point(&plot, section.ux[j], section.y[j]);
    plot_draw(&plot, inner);
    plot_close(&plot);
    char line[160];
    section_line(&section, line);
    if (under > 0)
        area_phrases(area, 1, area.rect.height - 1, area.rect.width - 2, 1, line, STYLE_NORMAL);
    free_section(&section);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Waves in the plane of bonds (waves_plane.h). */
#include "views/waves_plane.h"

#include "answers/waves.h"
#include "views/plots/runs.h"
#include "views/views.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A curve of the lattice. */
typedef struct Curve {
    Influence influence;
    double angle;
    LineStyle line;
    char letter;
    Style style;
} Curve;

enum { CURVES = 4 };
static const Curve curves[CURVES] = {
    {INFLUENCE_CONSTANT, 0, LINE_SOLID, 'c', STYLE_MEASURED},
    {INFLUENCE_CONSTANT, M_PI / 4, LINE_DASHED, 'c', STYLE_MEASURED},
    {INFLUENCE_CONICAL, 0, LINE_SOLID, 'k', STYLE_SECOND},
    {INFLUENCE_CONICAL, M_PI / 4, LINE_DASHED, 'k', STYLE_SECOND},
};

static double speed(const Settings *settings, const Curve *curve, bool transverse, double share)
{
    return 100 * waves_on_lattice(settings, curve->influence, transverse, curve->angle,
                                  share * M_PI / settings->lattice.spacing);
}

static double integral(const Settings *settings, Influence influence, bool transverse, double share)
{
    return 100 * waves_of_bonds(settings, influence, transverse, share * M_PI / settings->lattice.spacing);
}

static void add_curves(Plot *plot, const Settings *settings, bool transverse, int points)
{
    for (int i = 0; i < CURVES; i++) {
        plot_begin(plot, STROKE_LINE, curves[i].line, curves[i].style, RANK_MEASURED, curves[i].letter);
        for (int k = 1; k <= points; k++)
            plot_point(plot, (double)k / points, speed(settings, &curves[i], transverse, (double)k / points));
    }
    for (int shape = INFLUENCE_CONSTANT; shape <= INFLUENCE_CONICAL; shape++) {
        plot_begin(plot, STROKE_LINE, LINE_DOTTED, STYLE_EXACT, RANK_EXACT, '.');
        for (int k = 1; k <= points; k++)
            plot_point(plot, (double)k / points,
                       integral(settings, (Influence)shape, transverse, (double)k / points));
    }
}

/* A wave of ten spacings in words, for the run's own shape. */
static void tell(const Settings *settings, bool transverse, bool ascii, bool narrow, char out[160])
{
    const double share = 0.2;
    const bool conical = settings->lattice.influence == INFLUENCE_CONICAL;
    const Curve *own = &curves[conical ? 2 : 0];
    const char *degrees = ascii ? " deg" : "°";
    snprintf(out, 160,
             narrow ? "10 dx: 0%s %.1f %%, 45%s %.1f %%, integral %.1f %%"
                    : "10 spacings long: 0%s %.1f %%, 45%s %.1f %%, integral %.1f %%",
             degrees, speed(settings, &own[0], transverse, share), degrees,
             speed(settings, &own[1], transverse, share),
             integral(settings, own->influence, transverse, share));
}

/* Colour alone tells nobody apart: a letter stands on each curve along the rows. */
static void mark(Area inner, const Axis *x, const Axis *y, const Settings *settings, bool transverse)
{
    const double at = 0.5;
    for (int i = 0; i < CURVES; i += 2)
        axes_mark(inner, x, y, at, speed(settings, &curves[i], transverse, at),
                  (uint32_t)(unsigned char)curves[i].letter, curves[i].style);
}

void waves_plane_draw(const Screen *screen, Area area, Style heading, bool transverse)
{
    enum { POINTS = 60 };
    const Settings *settings = experiment_settings(screen->experiment);
    const bool ascii = area.glyphs == GLYPHS_ASCII;
    const int under = area.rect.height > 8;
    Area plot_area = area_part(area, 0, 1, area.rect.width, area.rect.height - 1 - under);
    const int rows = plot_area.rect.height - 1;
    double most = 100;
    for (int i = 0; i < CURVES; i++)
        for (int k = 1; k <= POINTS; k++)
            most = fmax(most, speed(settings, &curves[i], transverse, (double)k / POINTS));
    Axis x = axis_make(0, 1, area.rect.width / 9), y = axis_make(0, axis_round_up(most), rows < 5 ? 3 : 5);
    /* on screen one entry stands for both dashed curves; paper and words have room for each */
    const bool roomy = area.canvas->picture != NULL;
    const Legend legend[] = {{LINE_SOLID, 'c', STYLE_MEASURED, "c constant", NULL},
                             {LINE_SOLID, 'k', STYLE_SECOND, "k conical", NULL},
                             {LINE_DASHED, '-', STYLE_MEASURED,
                              roomy   ? "c at 45°"
                              : ascii ? "45 deg"
                                      : "45°",
                              NULL},
                             {LINE_DOTTED, '.', STYLE_EXACT, "integral", NULL},
                             {LINE_DASHED, '-', STYLE_SECOND, "k at 45°", NULL}};
    heading_draw(area, heading, transverse ? "shear waves, % of long" : "pressure waves, % of long", "",
                 legend, (int)(sizeof legend / sizeof *legend) - !roomy);
    Area inner = axes_draw(plot_area, &x, &y, ascii ? "2 dx/wavelength" : "2Δx/wavelength", GUTTER);
    Plot plot;
    plot_open(&plot, x, y);
    add_curves(&plot, settings, transverse, POINTS);
    plot_draw(&plot, inner);
    plot_close(&plot);
    mark(inner, &x, &y, settings, transverse);
    char line[160];
    tell(settings, transverse, ascii, area.rect.width < 66, line);
    if (under)
        area_phrases(area, 1, area.rect.height - 1, area.rect.width - 2, 1, line, STYLE_NORMAL);
}

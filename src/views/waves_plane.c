/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Waves in the plane of bonds (waves_plane.h). */
#include "views/waves_plane.h"
#include "scenario/concern_bonds.h"
#include "base/kinds.h"
#include "answers/waves.h"
#include "views/plots/runs.h"

#include <math.h>
#include <stdio.h>

/* A curve of the lattice. */
typedef struct Curve {
    Influence influence;
    double angle;
    Pen pen;
} Curve;

enum { CURVES = 4 };
static const Curve curves[CURVES] = {
    {INFLUENCE_CONSTANT, 0, {LINE_SOLID, 'c', STYLE_MEASURED, RANK_MEASURED, 0}},
    {INFLUENCE_CONSTANT, M_PI / 4, {LINE_DASHED, 'c', STYLE_MEASURED, RANK_MEASURED, 0}},
    {INFLUENCE_CONICAL, 0, {LINE_SOLID, 'k', STYLE_SECOND, RANK_MEASURED, 0}},
    {INFLUENCE_CONICAL, M_PI / 4, {LINE_DASHED, 'k', STYLE_SECOND, RANK_MEASURED, 0}},
};

static double speed(const Settings *settings, const Curve *curve, bool transverse, double share)
{
    return 100 * waves_on_lattice(settings, curve->influence, transverse, curve->angle,
                                  share * M_PI / settings_lattice(settings)->spacing);
}

static double integral(const Settings *settings, Influence influence, bool transverse, double share)
{
    return 100 * waves_of_bonds(settings, influence, transverse,
                                share * M_PI / settings_lattice(settings)->spacing);
}

static void add_curves(Picture *picture, const Settings *settings, bool transverse, int points)
{
    Plot *plot = &picture->plot;
    for (int i = 0; i < CURVES; i++) {
        plot_begin(plot, STROKE_LINE, curves[i].pen);
        for (int k = 1; k <= points; k++)
            plot_point(plot, (double)k / points, speed(settings, &curves[i], transverse, (double)k / points));
    }
    for (int shape = INFLUENCE_CONSTANT; shape <= INFLUENCE_CONICAL; shape++) {
        plot_begin(plot, STROKE_LINE, pen_exact);
        for (int k = 1; k <= points; k++)
            plot_point(plot, (double)k / points,
                       integral(settings, (Influence)shape, transverse, (double)k / points));
    }
}

/* A wave of ten spacings in words, for the run's own shape. */
static void tell(const Settings *settings, bool transverse, bool narrow, char out[160])
{
    const double share = 0.2;
    const bool conical = settings_lattice(settings)->influence == INFLUENCE_CONICAL;
    const Curve *own = &curves[conical ? 2 : 0];
    snprintf(out, 160,
             narrow ? "10 dx: 0° %.1f %%, 45° %.1f %%, integral %.1f %%"
                    : "10 spacings long: 0° %.1f %%, 45° %.1f %%, integral %.1f %%",
             speed(settings, &own[0], transverse, share), speed(settings, &own[1], transverse, share),
             integral(settings, own->influence, transverse, share));
}

void waves_plane_describe(const Screen *screen, bool transverse, Picture *picture)
{
    enum { POINTS = 60 };
    const Settings *settings = experiment_settings(screen->experiment);
    const double letter_at = 0.5;
    char line[160];
    double most = 100;
    for (int i = 0; i < CURVES; i++)
        for (int k = 1; k <= POINTS; k++)
            most = fmax(most, speed(settings, &curves[i], transverse, (double)k / POINTS));
    picture_axes(picture, axis_make(0, 1), "2Δx/wavelength", "", axis_make(0, axis_round_up(most)),
                 transverse ? "shear waves, % of long" : "pressure waves, % of long", "");
    static const PictureKey keys[] = {{LINE_SOLID, 'c', STYLE_MEASURED, "c constant", 0, 0},
                                      {LINE_SOLID, 'k', STYLE_SECOND, "k conical", 0, 0},
                                      {LINE_DASHED, '-', STYLE_MEASURED, "c at 45°", 0, 0},
                                      {LINE_DOTTED, '.', STYLE_EXACT, "integral", 0, 0},
                                      {LINE_DASHED, '-', STYLE_SECOND, "k at 45°", 0, 0}};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        picture_key(picture, keys[i]);
    add_curves(picture, settings, transverse, POINTS);
    /* colour alone tells nobody apart: a letter stands on each curve along the rows */
    for (int i = 0; i < CURVES; i += 2)
        picture_mark(picture, letter_at, speed(settings, &curves[i], transverse, letter_at),
                     (uint32_t)(unsigned char)curves[i].pen.letter, curves[i].pen.style);
    tell(settings, transverse, false, line);
    PictureNote *note = picture_note(picture, STYLE_NORMAL, line);
    tell(settings, transverse, true, note->brief);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Errors by mode. A bar: by how much each mode of its mesh is off, the paper's 5 % and 20 % explained. A
 * beam: its period over the horizon, between the two beam theories. Earlier runs leave their dot. */
#include "views/plots/plots.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_cells.h"
#include "scenario/settings.h"
#include "views/view.h"
#include "answers/dispersion_curves.h"
#include "base/text.h"
#include "base/kinds.h"

#include <math.h>
#include <stdio.h>

/* Part of the dispersion view: waves in the plane of bonds. */

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
    return 100 * dispersion_on_lattice(settings, curve->influence, transverse, curve->angle,
                                       share * M_PI / settings_lattice(settings)->spacing);
}

static double integral(const Settings *settings, Influence influence, bool transverse, double share)
{
    return 100 * dispersion_of_bonds(settings, influence, transverse,
                                     share * M_PI / settings_lattice(settings)->spacing);
}

/* Speed of waves that press (or, transverse, shear) over their length, along rows and diagonals of the
 * lattice, for both shapes of the micromodulus; dotted the integrals that they stand for. */
static void waves_plane_describe(const Screen *screen, bool transverse, Picture *picture)
{
    enum { POINTS = 60 };
    const Settings *settings = screen_settings(screen);
    const double letter_at = 0.5;
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
    Plot *plot = &picture->plot;
    for (int i = 0; i < CURVES; i++) {
        plot_begin(plot, STROKE_LINE, curves[i].pen);
        for (int k = 1; k <= POINTS; k++)
            plot_point(plot, (double)k / POINTS, speed(settings, &curves[i], transverse, (double)k / POINTS));
    }
    for (int shape = INFLUENCE_CONSTANT; shape <= INFLUENCE_CONICAL; shape++) {
        plot_begin(plot, STROKE_LINE, pen_exact);
        for (int k = 1; k <= POINTS; k++)
            plot_point(plot, (double)k / POINTS,
                       integral(settings, (Influence)shape, transverse, (double)k / POINTS));
    }
    /* colour alone does not distinguish them: a letter stands on each curve along the rows */
    for (int i = 0; i < CURVES; i += 2)
        picture_mark(picture, letter_at, speed(settings, &curves[i], transverse, letter_at),
                     (uint32_t)(unsigned char)curves[i].pen.letter, curves[i].pen.style);
    /* A wave of ten spacings in words, for the run's own shape. */
    const double share = 0.2;
    const bool conical = settings_lattice(settings)->influence == INFLUENCE_CONICAL;
    const Curve *own = &curves[conical ? 2 : 0];
    picture_note(picture, STYLE_NORMAL,
                 LONG_SHORT("10 spacings long:", "10 dx:") " 0° %.1f %%, 45° %.1f %%, integral %.1f %%",
                 speed(settings, &own[0], transverse, share), speed(settings, &own[1], transverse, share),
                 integral(settings, own->influence, transverse, share));
}

/* One run in the picture, in a duel with its letter; ghosts are rings. */
static PictureMark dot_of(const ShownRun *run, double x, double y)
{
    return (PictureMark){x, y, run->experiment ? 0x25cf : 0x25cb, run->experiment ? run->style : STYLE_NORMAL,
                         .letter = run->letter};
}

static void widen(double value, double *least, double *most)
{
    if (!isfinite(value))
        return;
    *least = value < *least ? value : *least;
    *most = value > *most ? value : *most;
}

/* --- a bar ---------------------------------------------------------------------------------------- */

static double percent(double ratio)
{
    return 100 * (ratio - 1);
}

enum { NOTE_TEXT = 320 };

/* "= mesh K -1.33 %, filter F -2.96 %": factors multiply, so their errors do not quite add up. */
static void append_factor(char line[NOTE_TEXT], const char *name, double value)
{
    text_append(line, NOTE_TEXT, LONG_SHORT("%s %s %+.2f %%", "%s (1%+.2f%%)%s"), line[0] ? "," : "=", name,
                percent(value), line[0] ? "" : "=", percent(value), text_last_word(name));
}

/* "mode 5: measured -4.24 %, predicted -4.24 %" and where it comes from; in brief "pred" and letters. */
static void mode_lines(const Screen *screen, char first[NOTE_TEXT], char second[NOTE_TEXT])
{
    const Readout *readout = experiment_readout(screen->experiment);
    ModeOnMesh mode;
    first[0] = second[0] = '\0';
    if (readout->mode < 1 || !readout->moving) {
        snprintf(first, NOTE_TEXT,
                 readout->moving ? "this motion is not a mode of a bar"
                                 : "nothing vibrates here: no mode to measure");
        return;
    }
    snprintf(first, NOTE_TEXT, "mode %d:", readout->mode);
    if (readout->measured_known)
        text_append(first, NOTE_TEXT, " measured %+.2f %%", percent(readout->measured / readout->exact));
    else
        text_append(first, NOTE_TEXT, " measuring");
    const bool found = dispersion_mode(screen_settings(screen), readout->mode, &mode);
    if (!screen_shows_predicted(screen))
        return;
    if (!found || isnan(mode.predicted)) {
        const bool has_waves = dispersion_modes(screen_settings(screen)) > 0;
        snprintf(second, NOTE_TEXT, "%s",
                 found       ? "such a wave does not oscillate with this time step"
                 : has_waves ? "too short a wave for this mesh"
                             : "its modes do not have a single wavelength here");
        if (!has_waves && readout->predicted_known)
            text_append(first, NOTE_TEXT, ", " LONG_SHORT("predicted", "pred") " %+.2f %%",
                        percent(readout->predicted / readout->exact));
        return;
    }
    /* the readout's prediction knows of free ends, the curve does not */
    const double predicted = readout->predicted_known ? readout->predicted : mode.predicted;
    text_append(first, NOTE_TEXT, ", " LONG_SHORT("predicted", "pred") " %+.2f %%",
                percent(predicted / mode.exact));
    for (int i = 0; i < mode.n_factors; i++)
        append_factor(second, mode.factors[i].name, mode.factors[i].value);
    if (fabs(predicted / mode.predicted - 1) > 1e-9)
        append_factor(second, "free end", predicted / mode.predicted);
}

/* --- the other ways of a method --- */

enum { WAYS_MAX = 6 };
static const char transfer_letters[WAYS_MAX] = {'l', '*', 'c', '2', '4', '6'};
static const char shape_letters[WAYS_MAX] = {'c', 'k', 'C', 'K'};

static const char *letters_of(const Screen *screen)
{
    return screen_has(screen, HAS_MESH) ? transfer_letters : shape_letters;
}

static const Style way_styles[WAYS_MAX] = {STYLE_GHOST_A, STYLE_GHOST_B, STYLE_GHOST_C,
                                           STYLE_GHOST_D, STYLE_GHOST_E, STYLE_FAINT};

static double error_by_way(const Settings *settings, int which, int number)
{
    ModeOnMesh mode;
    double frequency;
    if (!dispersion_other_way(settings, which, number, &frequency) ||
        !dispersion_mode(settings, number, &mode))
        return NAN;
    return percent(frequency / mode.exact);
}

static int count_ways(const Settings *settings)
{
    int count = 0;
    double unused;
    while (count < WAYS_MAX && dispersion_other_way(settings, count, 1, &unused))
        count++;
    return count;
}

/* The modes that are shown: all that the mesh can carry or, as a variant, those around the present one. */
static int last_mode(const Experiment *experiment, int variant)
{
    enum { NEAR = 12 };
    const int all = dispersion_modes(experiment_settings(experiment));
    const int mode = experiment_readout(experiment)->mode;
    const int near = mode > NEAR / 2 ? 2 * mode : NEAR;
    return all == 0 || (variant == 1 && near < all) ? near : all; /* 0: of which there are no waves */
}

/* Two lines and what their words mean; of the other ways what their letters mean. */
static void note_mode(const Screen *screen, Picture *picture, int n_ways)
{
    const Settings *settings = screen_settings(screen);
    char lines[2][NOTE_TEXT], text[160] = "", brief[160];
    mode_lines(screen, lines[0], lines[1]);
    for (int i = 0; i < n_ways; i++) { /* "l lumped  * mu*  c consistent" */
        double unused;
        text_append(text, 160, "%s%c %s", i ? "  " : "", letters_of(screen)[i],
                    dispersion_other_way(settings, i, 1, &unused));
    }
    if (n_ways > 0)
        picture_note(picture, STYLE_NORMAL, "%s", text);
    for (int i = 0; i < 2 - (n_ways > 0); i++)
        picture_note(picture, STYLE_NORMAL, "%s", lines[i]);
    /* What the factors' names mean; in brief, the last of them. */
    ModeOnMesh mode;
    const bool known = dispersion_mode(settings, 1, &mode);
    text[0] = '\0';
    for (int i = 0; known && i < mode.n_factors; i++)
        if (mode.factors[i].meaning) {
            text_append(text, 160, "%s%s: %s", text[0] ? "; " : "", mode.factors[i].name,
                        mode.factors[i].meaning);
            snprintf(brief, 160, "%s: %s", text_last_word(mode.factors[i].name), mode.factors[i].meaning);
        }
    if (text[0])
        picture_note(picture, STYLE_FAINT, LONG_SHORT("%s", "%s"), text, brief)->spare = true;
}

static void describe_bar(const Screen *screen, int variant, bool with_ways, Picture *picture)
{
    const Settings *settings = screen_settings(screen);
    const int n_ways = with_ways ? count_ways(settings) : 0, last = last_mode(screen->experiment, variant);
    const int columns = picture->dots > 1 ? picture->dots : 2;
    const int every = last > columns ? (last + columns - 1) / columns : 1;
    PictureMark dots[RUNS_MAX];
    ShownRun runs[RUNS_MAX];
    const int n_runs = runs_of(screen, runs);
    int n_dots = 0;
    for (int i = 0; i < n_runs; i++) {
        const Readout *readout = runs[i].readout;
        if (readout->mode > 0 && readout->measured_known)
            dots[n_dots++] = dot_of(&runs[i], readout->mode, percent(readout->measured / readout->exact));
    }
    double least = 0, most = 0;
    ModeOnMesh mode;
    bool predicted = false;
    for (int i = 0; i < n_runs && screen_shows_predicted(screen); i++)
        for (int n = 1; n <= last && runs[i].experiment; n += every)
            if (dispersion_mode(runs[i].settings, n, &mode)) {
                widen(percent(mode.predicted / mode.exact), &least, &most);
                predicted |= isfinite(mode.predicted);
            }
    for (int i = 0; i < n_dots; i++)
        if (dots[i].x <= last)
            widen(dots[i].y, &least, &most);
    for (int i = 0; i < n_ways; i++)
        for (int n = 1; n <= last; n += every)
            widen(error_by_way(settings, i, n), &least, &most);
    const double low = least < -0.01 ? -axis_round_up(-1.02 * least) : -1;
    picture_axes(picture, axis_make(0, last > 1 ? last : 2), "mode n", "",
                 axis_make_root(low, most > 0.01 ? axis_round_up(1.02 * most) : 0),
                 "error of ω, % (square-root scale)", "");
    /* the other ways have a letter on their curve, and a line below that names them */
    picture_key(picture, (PictureKey){LINE_SOLID, 'O', STYLE_MEASURED, "measured", 0x25cf, 0});
    if (screen_shows_exact(screen))
        picture_level(picture, 0, pen_exact, "exact");
    if (predicted)
        picture_name(picture, pen_predicted, "predicted");
    /* A letter on each curve: colour alone does not distinguish them. */
    const char *letters = letters_of(screen);
    for (int i = 0; i < n_ways; i++) {
        plot_begin(&picture->plot, STROKE_LINE, (Pen){LINE_SOLID, letters[i], way_styles[i], RANK_GHOST, 0});
        for (int n = 1; n <= last; n += every)
            plot_point(&picture->plot, n, error_by_way(settings, i, n));
        const int n = 1 + (last - 1) * (3 + i) / 10;
        const double error = error_by_way(settings, i, n);
        if (isfinite(error))
            picture_mark(picture, n, error, (uint32_t)(unsigned char)letters[i], way_styles[i]);
    }
    for (int i = 0; i < n_runs && predicted; i++)
        if (runs[i].experiment) { /* the curve of each run that can go on: of both in a duel */
            plot_begin(&picture->plot, STROKE_LINE, pen_predicted);
            for (int n = 1; n <= last; n += every)
                if (dispersion_mode(runs[i].settings, n, &mode))
                    plot_point(&picture->plot, n, percent(mode.predicted / mode.exact));
        }
    for (int i = 0; i < n_dots; i++) /* ghosts first, so that the present run lies on top */
        picture_add_mark(picture, dots[i]);
    note_mode(screen, picture, n_ways);
}

/* --- a beam --------------------------------------------------------------------------------------- */

static double milliseconds(double seconds)
{
    return seconds / 1e-3;
}

/* What a period depends on: how far bonds reach or, where there are none, the cells. */
static double reach_of(const Screen *screen, const Settings *settings)
{
    return screen_has(screen, HAS_BONDS) ? settings_lattice(settings)->horizon
                                         : settings_mesh(settings)->cell_size;
}

static int beam_dots(const Screen *screen, PictureMark dots[RUNS_MAX])
{
    ShownRun runs[RUNS_MAX];
    const int n_runs = runs_of(screen, runs);
    const Settings *own = screen_settings(screen);
    int count = 0;
    for (int i = 0; i < n_runs; i++) {
        const Settings *settings = runs[i].settings;
        const Readout *readout = runs[i].readout;
        /* the period of a moving beam grows, so the error is that of its last one */
        if (settings->problem == own->problem && settings->method == own->method && readout->measured_known)
            dots[count++] =
                dot_of(&runs[i], reach_of(screen, settings),
                       readout->drifting ? readout->error_period : milliseconds(readout->measured));
    }
    return count;
}

static void note_period(Picture *picture, const Readout *readout, double height, double span)
{
    if (!readout->measured_known)
        picture_note(picture, STYLE_NORMAL, "T measuring");
    else if (readout->drifting)
        picture_note(picture, STYLE_NORMAL,
                     LONG_SHORT("the last period was", "last period") " %.4f ms, %+.2f %% of " LONG_SHORT(
                         "the modal one's", "modal"),
                     milliseconds(readout->measured), readout->error_period);
    else
        picture_note(picture, STYLE_NORMAL,
                     "T %.4f ms: %+.2f %%, its " LONG_SHORT("real size alone", "size") " %+.2f %%",
                     milliseconds(readout->measured), percent(readout->measured / readout->exact),
                     percent(readout->real_size / readout->exact));
    /* a mesh has the size that is asked for */
    if (readout->measured_known && !readout->drifting && isfinite(height) && isfinite(span))
        picture_note(picture, STYLE_FAINT,
                     "real height %.4g mm, span %.4g mm" LONG_SHORT("; T as span^2/height", ""),
                     height / 1e-3, span / 1e-3);
    else
        picture_note(picture, STYLE_FAINT, "%s", "");
}

/* --- either --------------------------------------------------------------------------------------- */

static bool shows_ways(const Screen *screen, int variant)
{
    /* All modes, those near the present one if there are more, and all by the other ways of the method. */
    return variant == 1 + (last_mode(screen->experiment, 1) < last_mode(screen->experiment, 0));
}

/* The bonds of a plane carry waves that know its directions. */
static bool has_waves(const Screen *screen)
{
    return screen_has(screen, HAS_PLANE | HAS_BONDS);
}

static const char *word_of(const Screen *screen, int variant)
{
    static const char *const waves[] = {"period", "pressure", "shear", NULL};
    if (has_waves(screen))
        return waves[variant];
    if (!shows_ways(screen, variant))
        return variant == 0 ? "all" : variant == 1 ? "near" : NULL;
    return count_ways(screen_settings(screen)) == 0 ? NULL
           : letters_of(screen) == shape_letters    ? "shapes"
                                                    : "transfers";
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    const Settings *settings = screen_settings(screen);
    const bool ways = shows_ways(screen, variant);
    char text[96];
    snprintf(text, sizeof text,
             "A body that breaks has no period to compare. The log (%d) shows when and where.",
             view_log.digit);
    if (screen_has(screen, HAS_LINE))
        describe_bar(screen, ways ? 0 : variant, ways, picture);
    else if (has_waves(screen) && variant > 0)
        waves_plane_describe(screen, variant == 2, picture);
    else if (settings->problem->concerns & CONCERN_NOTCH)
        picture_say(picture, "period", "%s", text);
    else if (!experiment_readout(screen->experiment)->moving)
        picture_say(picture, "period", "Nothing vibrates here: there is no period to measure.");
    else {
        const Readout *readout = experiment_readout(screen->experiment);
        const bool bonds = screen_has(screen, HAS_BONDS);
        const struct {
            const char *name;
            double value;
            Pen pen;
        } theories[] = {
            {readout->drifting ? "modal" : "Euler",
             readout->drifting ? 0 : milliseconds(screen_derived(screen, "period_euler")), pen_exact},
            {"Timoshenko",
             readout->drifting ? NAN : milliseconds(screen_derived(screen, "period_timoshenko")),
             (Pen){LINE_DASHED, '-', STYLE_THIRD, RANK_EXACT, 0}},
        };
        PictureMark dots[RUNS_MAX];
        const int n_dots = beam_dots(screen, dots);
        double least = INFINITY, most = -INFINITY, furthest = reach_of(screen, settings);
        for (int i = 0; i < 2; i++)
            widen(theories[i].value, &least, &most);
        for (int i = 0; i < n_dots; i++) {
            widen(dots[i].y, &least, &most);
            furthest = fmax(furthest, dots[i].x);
        }
        picture_axes(
            picture, axis_make(0, axis_round_up(1.2 * furthest)), bonds ? "horizon" : "cell size", "m",
            readout->drifting ? axis_symmetric(fmax(fabs(least), fabs(most))) : axis_around(least, most),
            readout->drifting ? "error of the last period, %" : "period, ms", "");
        picture_key(picture, (PictureKey){LINE_SOLID, 'O', STYLE_MEASURED, "measured", 0x25cf, 0});
        for (int i = 0; i < 2 && screen_shows_exact(screen); i++)
            if (isfinite(theories[i].value))
                picture_level(picture, theories[i].value, theories[i].pen, theories[i].name);
        for (int i = 0; i < n_dots; i++)
            picture_add_mark(picture, dots[i]);
        note_period(picture, readout, screen_derived(screen, "real_height"),
                    screen_derived(screen, "real_span"));
    }
}

const View view_dispersion = {
    .word = "dispersion",
    .brief = "errors",
    .help = "dispersion: error of every mode; beams: period over horizon or cell size, waves",
    .digit = 5,
    .home = PANE_LOWER,
    .describe = describe,
    .variant_word = word_of,
    .duel = DUEL_TOGETHER,
};

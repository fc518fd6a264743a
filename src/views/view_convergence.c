/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What becomes of the error when mesh or lattice are refined: the predicted answers of a study beside theory,
 * as many of its points as are known, and the order with which the error falls. The lattices of paper P's
 * Table 1 are shown as periods, for what they differ in is the size that their layers give the beam. */
#include "panes/screen.h"
#include "scenario/settings.h"
#include "views/view.h"
#include "answers/convergence.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>

/* A study as it stands. */
typedef struct Study {
    const ConvergenceStudy *of;
    const ConvergencePoint *points;
    int known, count;
    int lines, line_points; /* one after the other */
    bool periods;           /* of a beam, in s, and sizes in m; else frequencies, in the bar's own units */
    double limit;           /* convergence_limit() */
} Study;

static const ConvergenceStudy *study_of(const Screen *screen, int variant)
{
    const ConvergenceStudy *studies[CONVERGENCE_STUDIES_MAX];
    return variant < convergence_studies(screen_settings(screen), studies) ? studies[variant] : NULL;
}

static const char *word_of(const Screen *screen, int variant)
{
    const ConvergenceStudy *study = study_of(screen, variant);
    return study ? study->word : NULL;
}

static bool shows_start(const Screen *screen, int variant)
{
    (void)screen, (void)variant;
    return true;
}

/* As it is shown: a beam's in millimetres and milliseconds. */
static double shown(const Study *study, double value)
{
    return study->periods ? value / 1e-3 : value;
}

/* --- words ---------------------------------------------------------------------------------------- */

static void verdict_of(const Screen *screen, const Study *study, char out[160])
{
    if (study->known < study->count && screen_is_running(screen) && !screen->panes.lecture) {
        snprintf(out, 160, "%d of %d points  they come while the run is paused", study->known, study->count);
        return;
    }
    const int n = study->known;
    const double order =
                     n < 2 ? NAN
                     : isfinite(study->limit)
                         ? convergence_order_to(study->limit, &study->points[n - 2], &study->points[n - 1])
                         : convergence_order(&study->points[n - 2], &study->points[n - 1]),
                 fitted = convergence_fitted_order(study->points, study->known);
    snprintf(out, 160, "%d of %d points", study->known, study->count);
    const int points = study->line_points;
    for (int line = 0; study->of->lines && line < study->lines; line++) {
        /* "  order: 2 x 2 2.00, 3 x 3 2.01" */
        if (study->known - line * study->line_points < points)
            return;
        const double of_line = convergence_fitted_order(study->points + line * points, points);
        text_append(out, 160, line > 0 ? ", %s" : "  order: %s", study->of->lines[line]);
        text_append(out, 160, isfinite(of_line) ? " %.2f" : " none", of_line);
    }
    if (study->of->lines)
        return;
    if (study->of->paper)
        text_append(out, 160, "  the layers make the beam thinner: see its height");
    else if (isfinite(study->limit)) {
        /* However small the horizon is an error is left: said, lest it be taken for no convergence. */
        text_append(out, 160, "  T tends to %.3f of theory, not to 1", study->limit);
        if (isfinite(order))
            text_append(out, 160, "  to that with order %.2f", order);
        text_append(out, 160, "  without correction m has to grow too");
    } else if (isfinite(fitted))
        text_append(out, 160, "  fitted order %.2f  the last two %.2f", fitted, order);
    else if (isfinite(order))
        text_append(out, 160, "  order of the last two %.2f  no one order", order);
    else if (study->known > 1)
        text_append(out, 160, "  no one order: the error does not fall with one sign");
}

/* Of point k: its size, its answers, its error, the order from the one before; in brief, the last two. */
static void point_line(const Study *study, int k, char out[200])
{
    const ConvergencePoint *point = &study->points[k];
    const Prediction *is = &point->prediction;
    const int line = k / study->line_points, in_line = k % study->line_points;
    snprintf(out, 200, study->of->lines ? "%s %.4g%s" : LONG_SHORT("%s ", "") "%.4g%s",
             study->of->lines ? study->of->lines[line] : study->of->size, shown(study, point->size),
             study->periods ? " mm" : "");
    if (study->of->paper)
        text_append(out, 200, ", %.1f high", is->real_height / 1e-3);
    else if (point->of_mesh)
        text_append(out, 200, LONG_SHORT(", %.0f cells", ""), point->nodes);
    else
        text_append(out, 200, LONG_SHORT(", m %.3g", ""), point->nodes);
    if (!point->known) {
        text_append(out, 200, study->of->by_run ? ": no answer" : ": none can be made");
        return;
    }
    text_append(out, 200, ": %+.2f %%", point->error);
    const double order =
        in_line > 0 && !study->of->paper ? convergence_order(&study->points[k - 1], point) : NAN;
    if (isfinite(order))
        text_append(out, 200, ", order %.2f", order);
    if (study->of->by_run) {
        text_append(out, 200, "  %s %.4g", point->of, is->predicted);
        if (is->real_size != 0)
            text_append(out, 200, " (reference %.4g)", is->real_size);
        return;
    }
    text_append(out, 200, "  %s %.4f", study->of->paper ? "T" : "predicted", shown(study, is->predicted));
    if (study->of->paper)
        text_append(out, 200, "  paper %.3f", point->paper / 1e-3);
    text_append(out, 200, "  theory %.4f%s", shown(study, is->real_size), study->periods ? " ms" : "");
}

/* --- pictures ------------------------------------------------------------------------------------- */

static void widen(double value, double *least, double *most)
{
    *least = fmin(*least, value);
    *most = fmax(*most, value);
}

/* The size of the error over what is refined, by powers of ten: an order is a slope. A ring: below theory. */
static void describe_errors(Picture *picture, const Study *study)
{
    double least = INFINITY, most = 0, smallest = INFINITY, largest = 0;
    for (int k = 0; k < study->known; k++) {
        const ConvergencePoint *point = &study->points[k];
        if (!point->known || !(fabs(point->error) > 0))
            continue;
        widen(fabs(point->error), &least, &most);
        widen(shown(study, point->size), &smallest, &largest);
    }
    static const Pen pens[CONVERGENCE_LINES_MAX] = {{LINE_DASHED, '-', STYLE_PREDICTED, RANK_PREDICTED, 0},
                                                    {LINE_SOLID, '*', STYLE_SECOND, RANK_PREDICTED, 0},
                                                    {LINE_DOTTED, '.', STYLE_THIRD, RANK_PREDICTED, 0}};
    char name[64];
    snprintf(name, sizeof name, "%s%s", study->of->size, study->periods ? ", mm" : "");
    picture_axes(picture, axis_make_log(smallest * 0.99, largest * 1.01), name, "",
                 axis_make_log(least * 0.99, most * 1.01), "|error|, %", "");
    for (int line = 0; line < study->lines && study->of->lines; line++)
        picture_name(picture, pens[line], study->of->lines[line]);
    picture_key(picture, (PictureKey){LINE_SOLID, 'O', STYLE_PREDICTED,
                                      study->of->by_run ? "above"
                                      : study->periods  ? "T above theory"
                                                        : "ω above",
                                      0x25cf, 0});
    picture_key(picture, (PictureKey){LINE_SOLID, 'o', STYLE_PREDICTED, "below", 0x25cb, 0});
    for (int k = 0; k < study->known; k++) {
        const ConvergencePoint *point = &study->points[k];
        const int line = k / study->line_points;
        const double size = shown(study, point->size), error = fabs(point->error);
        if (k % study->line_points == 0)
            plot_begin(&picture->plot, STROKE_LINE, pens[line]);
        if (!point->known)
            continue;
        plot_point(&picture->plot, size, error);
        picture_mark(picture, size, error, point->error < 0 ? 0x25cb : 0x25cf, pens[line].style);
    }
}

enum { PREDICTED, THEORY, PAPER, PERIODS };

static double period_of(const ConvergencePoint *point, int curve)
{
    const double periods[PERIODS] = {point->prediction.predicted, point->prediction.real_size, point->paper};
    return periods[curve];
}

/* The periods of Table 1 and what theory says of a beam of that height and span. */
static void describe_periods(Picture *picture, const Study *study)
{
    const struct {
        Pen pen;
        const char *name;
    } curves[PERIODS] = {[PREDICTED] = {pen_predicted, "predicted"},
                         [THEORY] = {pen_exact, "theory, real size"},
                         [PAPER] = {{LINE_SOLID, 'p', STYLE_SECOND, RANK_SECOND, 0}, "paper"}};
    double least = INFINITY, most = -INFINITY, largest = 0;
    for (int i = 0; i < PERIODS; i++)
        for (int k = 0; k < study->known; k++) {
            widen(shown(study, period_of(&study->points[k], i)), &least, &most);
            largest = fmax(largest, shown(study, study->points[k].size));
        }
    picture_axes(picture, axis_make(0, axis_round_up(1.05 * largest)), "horizon, mm", "",
                 axis_around(least, most), "Table 1: T, ms", "");
    for (int i = 0; i < PERIODS; i++) {
        picture_name(picture, curves[i].pen, curves[i].name);
        plot_begin(&picture->plot, STROKE_LINE, curves[i].pen);
        for (int k = 0; k < study->known; k++)
            plot_point(&picture->plot, shown(study, study->points[k].size),
                       shown(study, period_of(&study->points[k], i)));
    }
    for (int k = 0; k < study->known; k++)
        picture_mark(picture, shown(study, study->points[k].size),
                     shown(study, period_of(&study->points[k], PREDICTED)), 0x25cf, STYLE_PREDICTED);
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    const ConvergenceStudy *of = study_of(screen, variant);
    char line[200];
    if (!of) {
        picture_say(picture, "convergence", "There is no predicted answer here that could converge.");
        return;
    }
    const Settings *settings = screen_settings(screen);
    Study study = {.of = of,
                   .count = of->points,
                   .periods = settings->problem->si,
                   .limit = convergence_limit(of, settings)};
    study.line_points = of->lines ? of->line_points : study.count;
    while (of->lines && of->lines[study.lines])
        study.lines++;
    study.lines = study.lines ? study.lines : 1;
    if (screen->convergence)
        study.known = convergence_known(screen->convergence, settings, of, &study.points);
    verdict_of(screen, &study, line);
    int count = 0;
    for (int k = 0; k < study.known; k++)
        count += study.points[k].known;
    if (count < 2) {
        picture_say(picture, of->title, "%s",
                    of->by_run && study.known == study.count
                        ? "No number of these runs has an exact or reference answer."
                        : line);
        return;
    }
    if (of->paper)
        describe_periods(picture, &study);
    else
        describe_errors(picture, &study);
    picture_note(picture, STYLE_NORMAL, "%s", line);
    for (int k = 0; k < study.known; k++) {
        point_line(&study, k, line);
        picture_note(picture, STYLE_FAINT, "%s", line)->spare = true;
    }
}

const View view_convergence = {
    .word = "convergence",
    .brief = "converge",
    .help = "convergence: the error as cells, horizon or spacing grow smaller, particles more: predicted, "
            "of bodies by runs; both methods; Table 1",
    .home = PANE_LOWER,
    .describe = describe,
    .variant_word = word_of,
    .duel = DUEL_TOGETHER,
    .shows_start = shows_start,
    .study = study_of,
};

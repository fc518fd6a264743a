/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The amplitude spectrum of the probe, with the predicted and the exact lines marked. The slow lines
 * on an even scale, or everything that the mesh can do on a logarithmic one. */
#include "views/plots/runs.h"
#include "views/views.h"

#include "base/math/functions.h"
#include "answers/dispersion_curves.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MARKS_MAX = 12, PEAKS_MAX = 4, PERIODS_LEAST = 2 };

/* What a variant shows. */
typedef struct Choice {
    int column;
    bool fast; /* all frequencies of the mesh, logarithmic; else those around the line */
} Choice;

/* A line that should be there, in radians per unit time. */
typedef struct Mark {
    double frequency;
    bool exact;
} Mark;

typedef struct Scale {
    const Spectrum *spectrum;
    double unit; /* radians per unit time in one unit of the axis */
    Axis x;
} Scale;

/* --- what is asked for ---------------------------------------------------------------------------- */

static Choice choice_of(const Screen *screen, int variant)
{
    if (!screen_problem(screen)->si) {
        const Readout *readout = experiment_readout(screen->experiment);
        const int column = screen_column(screen, readout->moving ? readout->column : "v_cm");
        return (Choice){column, variant % 2 == 1};
    }
    /* a beam swings a few times only in a run: what it does at once is its thickness modes */
    return (Choice){screen_column(screen, variant < 2 ? "v_probe" : "u_probe"), variant == 0};
}

static int variants_of(const Screen *screen)
{
    return !screen_problem(screen)->si ? 2 : 3;
}

static const char *word_of(const Screen *screen, int variant)
{
    static const char *const bar[] = {"slow", "fast"}, *const beam[] = {"fast", "slow", "displacement"};
    return !screen_problem(screen)->si ? bar[variant % 2] : beam[variant % 3];
}

/* The lines that theory knows: of the watched mode, of the bar's other modes where v_cm is watched, and, in
 * the picture of all that a mesh does (`fast`), of a beam's height. */
static int marks_of(const Screen *screen, bool fast, Mark marks[MARKS_MAX])
{
    const Settings *settings = experiment_settings(screen->experiment);
    const Readout *readout = experiment_readout(screen->experiment);
    Overtone overtones[OVERTONES_MAX];
    int count = 0, n_overtones = 0;
    if (!readout->moving)
        return 0;
    const double turn = readout->is_period ? 2 * M_PI : readout->times;
    if (readout->exact_known)
        marks[count++] = (Mark){readout->is_period ? turn / readout->exact : turn * readout->exact, true};
    if (readout->predicted_known)
        marks[count++] =
            (Mark){readout->is_period ? turn / readout->predicted : turn * readout->predicted, false};
    double thickness[THICKNESS_LINES_MAX];
    const int n_thickness =
        fast ? references_thickness_lines(experiment_references(screen->experiment), thickness) : 0;
    for (int i = 0; i < n_thickness && count < MARKS_MAX; i++)
        marks[count++] = (Mark){thickness[i], false};
    if (!screen_problem(screen)->si && readout->times < 1.5)
        n_overtones = overtones_read(settings->start.overtones, overtones, NULL);
    for (int i = 0; i < n_overtones && count + 2 <= MARKS_MAX; i++) {
        ModeOnMesh mode;
        if (overtones[i].mode == readout->mode || !dispersion_mode(settings, overtones[i].mode, &mode))
            continue;
        marks[count++] = (Mark){mode.exact, true};
        if (isfinite(mode.predicted) && readout->predicted_known)
            marks[count++] = (Mark){mode.predicted, false};
    }
    return count;
}

/* The highest frequency that the mesh can carry. */
static double highest_of(const Screen *screen)
{
    const Settings *settings = experiment_settings(screen->experiment);
    const double critical = screen_derived(screen, "dt_crit");
    ModeOnMesh mode;
    if (critical > 0)
        return 2 / critical;
    if (dispersion_mode(settings, dispersion_modes(settings), &mode))
        return mode.exact;
    return M_PI / experiment_simulation(screen->experiment)->dt;
}

/* --- the picture ---------------------------------------------------------------------------------- */

static double sample(const void *context, size_t index, double *x)
{
    const Scale *picture = context;
    *x = (double)index * picture->spectrum->step / picture->unit;
    return picture->spectrum->amplitudes[index];
}

/* One bin beyond the axis at most. */
static size_t bins_within(const Scale *picture)
{
    const double bins = ceil(picture->x.high * picture->unit / picture->spectrum->step) + 1;
    return bins < (double)picture->spectrum->count ? (size_t)bins : picture->spectrum->count;
}

/* The same column of another run; NULL: it has too few rows. */
static const Spectrum *spectrum_of_run(Experiment *experiment, const Run *run, const char *column,
                                       SpectrumSpan span)
{
    const int at = run_column(run, column);
    return at < 0            ? NULL
           : run->experiment ? experiment_spectrum(run->experiment, at, span)
                             : experiment_ghost_spectrum(experiment, run->ghost, at, span);
}

static double largest_of(const Scale *picture)
{
    double largest = 0;
    for (size_t k = 1; k < bins_within(picture); k++)
        largest = fmax(largest, picture->spectrum->amplitudes[k]);
    return largest;
}

/* How far the even scale reaches: the marks well inside, and whatever else stands out below the highest. */
static double slow_range(const Screen *screen, const Spectrum *spectrum, const Mark *marks, int n_marks)
{
    double range = 0;
    for (int i = 0; i < n_marks; i++)
        range = fmax(range, marks[i].frequency * (!screen_problem(screen)->si ? 2 : 4));
    if (screen_problem(screen)->si)
        return range;
    double largest = 0;
    for (size_t k = 1; k < spectrum->count; k++)
        largest = fmax(largest, spectrum->amplitudes[k]);
    for (size_t k = 1; k < spectrum->count; k++)
        if (spectrum->amplitudes[k] > 0.05 * largest)
            range = fmax(range, 1.25 * (double)k * spectrum->step);
    return fmin(range, highest_of(screen));
}

/* Between two bins by the parabola through the logarithms: a window's line is nearly one. */
static double place_of_peak(const double *a, size_t k)
{
    if (!(a[k - 1] > 0) || !(a[k + 1] > 0))
        return (double)k;
    const double left = math_log(a[k - 1] / a[k]), right = math_log(a[k + 1] / a[k]);
    return left + right < 0 ? (double)k + (left - right) / (2 * (left + right)) : (double)k;
}

/* What the Hann window shows of a line of amplitude 1 so many bins away, at most: its side lobes. */
static double side_lobe(double bins)
{
    const double away = fmax(fabs(bins), 1.5);
    return 1 / (M_PI * away * (away * away - 1));
}

/* The places of the highest peaks, ascending: three bins apart at least, four times what a higher one leaks
 * there; those of the logarithmic picture at least a fiftieth of the axis apart and a thousandth of the
 * highest. */
static int peaks_of(const Scale *picture, bool fast, double peaks[PEAKS_MAX])
{
    const double *a = picture->spectrum->amplitudes;
    const size_t end = bins_within(picture), fiftieth = fast ? end / 50 + 1 : 0,
                 apart = fiftieth > 3 ? fiftieth : 3;
    const double least = largest_of(picture) * (fast ? 1e-3 : 0.05);
    size_t found[PEAKS_MAX];
    int count = 0;
    while (count < PEAKS_MAX) {
        size_t best = 0;
        for (size_t k = 2; k + 1 < end; k++) {
            bool taken = a[k] < a[k - 1] || a[k] < a[k + 1] || a[k] < least || (best && a[k] <= a[best]);
            for (int i = 0; i < count; i++)
                taken |= (k + apart > found[i] && found[i] + apart > k) ||
                         a[k] < 4 * a[found[i]] * side_lobe((double)k - (double)found[i]);
            if (!taken)
                best = k;
        }
        if (best == 0)
            break;
        found[count++] = best;
    }
    for (int i = 0; i < count; i++)
        peaks[i] = place_of_peak(a, found[i]) * picture->spectrum->step / picture->unit;
    for (int i = 1; i < count; i++)
        for (int k = i; k > 0 && peaks[k] < peaks[k - 1]; k--) {
            const double held = peaks[k];
            peaks[k] = peaks[k - 1];
            peaks[k - 1] = held;
        }
    return count;
}

static void peak_line(const Screen *screen, const Scale *picture, bool fast, char out[160])
{
    double peaks[PEAKS_MAX];
    const int count = peaks_of(picture, fast, peaks);
    const double bin = picture->spectrum->step / picture->unit;
    char number[NUMBER_TEXT_MAX];
    snprintf(out, 160, count == 0 ? "no peak stands out" : count == 1 ? "peak at" : "peaks at");
    for (int i = 0; i < count; i++) {
        text_fitted(peaks[i], 4, 8, number);
        text_append(out, 160, "%s %s", i > 0 ? "," : "", number);
    }
    text_fitted(bin, 2, 8, number);
    text_append(out, 160, "%s; a bin is %s", !screen_problem(screen)->si ? "" : " kHz", number);
}

/* Why there is no picture yet; false: there is one. */
static bool wants_time(const Screen *screen, const Spectrum *spectrum, Choice choice, const Mark *marks,
                       int n_marks, char out[160])
{
    const Readout *readout = experiment_readout(screen->experiment);
    char time[48];
    if (!screen_problem(screen)->si && !readout->moving) {
        snprintf(out, 160, "Nothing vibrates here: there is no line to look for.");
        return true;
    }
    if (!spectrum) {
        snprintf(out, 160, "needs more time: %d rows at least", SPECTRUM_ROWS_MIN);
        return true;
    }
    if (choice.fast)
        return false;
    if (n_marks == 0) {
        snprintf(out, 160, "needs more time: no swing is known yet");
        return true;
    }
    const double needed = PERIODS_LEAST * 2 * M_PI / marks[0].frequency;
    if (spectrum->to >= needed)
        return false;
    screen_time_text(screen, needed, time, sizeof time);
    snprintf(out, 160, "needs more time: two periods, that is until %s", time);
    return true;
}

/* "predicted through height 1098, 2038 kHz", as many as there is room for; false: there is nothing to tell.
 */
static bool thickness_line(Experiment *experiment, int width, char out[160])
{
    double thickness[THICKNESS_LINES_MAX];
    int count = references_thickness_lines(experiment_references(experiment), thickness);
    for (count = count < PEAKS_MAX ? count : PEAKS_MAX; count > 0; count--) {
        snprintf(out, 160, "predicted through height");
        for (int i = 0; i < count; i++)
            text_append(out, 160, "%s %.0f", i > 0 ? "," : "", thickness[i] / (2e3 * M_PI));
        text_append(out, 160, " kHz");
        if (glyphs_columns(out) < width)
            break;
    }
    return count > 0;
}

static void add_marks(const Screen *screen, Plot *plot, const Scale *picture, const Mark *marks, int n_marks)
{
    for (int i = 0; i < n_marks; i++) {
        if (marks[i].exact ? !screen_shows_exact(screen) : !screen_shows_predicted(screen))
            continue;
        const double x = marks[i].frequency / picture->unit;
        plot_begin(plot, STROKE_LINE, marks[i].exact ? LINE_DOTTED : LINE_DASHED,
                   marks[i].exact ? STYLE_EXACT : STYLE_PREDICTED,
                   marks[i].exact ? RANK_EXACT : RANK_PREDICTED, marks[i].exact ? '.' : '-');
        plot_point(plot, x, plot->y.low);
        plot_point(plot, x, plot->y.high);
    }
}

/* A run's letter stands at its highest peak. */
static void letter_at_peak(Experiment *experiment, const Plot *plot, Area inner, const Scale *picture,
                           const Run *run, const char *column, SpectrumSpan span)
{
    Scale of_run = *picture;
    of_run.spectrum = spectrum_of_run(experiment, run, column, span);
    if (!run->letter || !run->shown || !of_run.spectrum)
        return;
    size_t best = 0;
    for (size_t k = 1; k < bins_within(&of_run); k++)
        if (best == 0 || of_run.spectrum->amplitudes[k] > of_run.spectrum->amplitudes[best])
            best = k;
    double x;
    const double y = sample(&of_run, best, &x);
    run_letter(run, plot, inner, x, y);
}

static void draw(const Screen *screen, Area area, Style heading, int variant)
{
    Choice choice = choice_of(screen, variant);
    int n;
    const Column *columns = experiment_columns(screen->experiment, &n);
    if (choice.column < 0) {
        area_rule(area, 0, "spectrum", heading);
        return;
    }
    const Quantity *quantity = &columns[choice.column].quantity;
    Mark marks[MARKS_MAX];
    const int n_marks = marks_of(screen, choice.fast, marks);
    /* what breaks has no line of its own: all that the mesh does is shown */
    choice.fast |= screen_problem(screen)->si && !experiment_readout(screen->experiment)->moving;
    Scale picture = {.unit = !screen_problem(screen)->si ? 1 : 2e3 * M_PI};
    picture.spectrum =
        experiment_spectrum(screen->experiment, choice.column, choice.fast ? SPECTRUM_FAST : SPECTRUM_SLOW);
    char name[64], text[160], lines[160];
    if (wants_time(screen, picture.spectrum, choice, marks, n_marks, text)) {
        snprintf(name, sizeof name, "spectrum of %s", quantity->label);
        area_rule(area, 0, name, heading);
        area_paragraph(area, 1, 1, area.rect.width - 2, area.rect.height - 1, text, STYLE_FAINT);
        return;
    }

    const bool rings = choice.fast && screen_shows_predicted(screen) &&
                       thickness_line(screen->experiment, area.rect.width, lines);
    const int under = area.rect.height < 8             ? 0
                      : area.rect.height < 9 || !rings ? 1
                                                       : 2,
              rows = area.rect.height - 2 - under;
    const double range =
        choice.fast ? highest_of(screen) : slow_range(screen, picture.spectrum, marks, n_marks);
    picture.x = axis_make(0, axis_round_up(range / picture.unit), area.rect.width / 9);
    const SpectrumSpan span = choice.fast ? SPECTRUM_FAST : SPECTRUM_SLOW;
    Run runs[RUNS_MAX];
    const int n_runs = runs_with(runs, runs_of(screen, runs), quantity->name);
    double largest = 0;
    for (int i = 0; i < n_runs; i++) {
        Scale of_run = picture;
        of_run.spectrum = spectrum_of_run(screen->experiment, &runs[i], quantity->name, span);
        if (runs[i].experiment && of_run.spectrum)
            largest = fmax(largest, largest_of(&of_run));
    }
    Axis y = choice.fast
                 ? axis_make_log(fmax(largest, 1e-290) * 1e-3, fmax(largest, 1e-286) * 1.02, rows < 5 ? 3 : 5)
                 : axis_make(0, axis_round_up(1.02 * largest), rows < 5 ? 3 : 5);

    /* where there is little room the solid line goes without saying */
    Legend legend[RUNS_MAX + 2];
    int n_legend = 0;
    for (int i = n_runs - 1; i >= 0; i--) /* the present run first */
        if (runs[i].experiment && runs[i].shown && (runs[i].letter || area.rect.width >= 70))
            legend[n_legend++] = run_legend(&runs[i]);
    bool exact = false, predicted = false;
    for (int i = 0; i < n_marks; i++) {
        exact |= marks[i].exact;
        predicted |= !marks[i].exact;
    }
    if (exact && screen_shows_exact(screen))
        legend[n_legend++] = (Legend){LINE_DOTTED, '.', STYLE_EXACT, screen_problem(screen)->answer, NULL};
    if (predicted && screen_shows_predicted(screen))
        legend[n_legend++] = (Legend){LINE_DASHED, '-', STYLE_PREDICTED, "predicted", NULL};
    char scale[TICK_TEXT_MAX] = "";
    if (!choice.fast)
        axis_scale_text(&y, quantity->unit, scale);
    else if (screen_problem(screen)->si)
        snprintf(scale, sizeof scale, "%s", quantity->unit);
    snprintf(name, sizeof name, "spectrum of %s", quantity->label);
    n_legend += runs_ghost_legends(runs, n_runs, legend + n_legend);
    heading_draw(area, heading, name, scale, legend, n_legend);
    Area inner = axes_draw(area_part(area, 0, 1, area.rect.width, area.rect.height - 1 - under), &picture.x,
                           &y, !screen_problem(screen)->si ? "w" : "f, kHz", GUTTER);

    Plot plot;
    plot_open(&plot, picture.x, y);
    add_marks(screen, &plot, &picture, marks, n_marks);
    for (int i = 0; i < n_runs; i++) {
        Scale of_run = picture;
        of_run.spectrum = spectrum_of_run(screen->experiment, &runs[i], quantity->name, span);
        if (!runs[i].shown || !of_run.spectrum)
            continue;
        run_begin(&plot, &runs[i]);
        plot_curve(&plot, sample, &of_run, 0, bins_within(&of_run),
                   inner.rect.width * plot_dots_across(area.glyphs));
    }
    plot_draw(&plot, inner);
    for (int i = 0; i < n_runs; i++)
        letter_at_peak(screen->experiment, &plot, inner, &picture, &runs[i], quantity->name, span);
    plot_close(&plot);
    if (under > 0) {
        peak_line(screen, &picture, choice.fast, text);
        const int x =
            1 +
            (screen_is_shared(screen) ? area_text(area, 1, area.rect.height - under, "A ", STYLE_NORMAL) : 0);
        char *bin = strchr(text, ';');
        if (bin && x + glyphs_columns(text) > area.rect.width)
            *bin = '\0';
        area_text(area, x, area.rect.height - under, text, STYLE_NORMAL);
    }
    if (under > 1)
        area_text(area, 1, area.rect.height - 1, lines, STYLE_FAINT);
}

const View view_spectrum = {
    .word = "spectrum",
    .brief = "spectrum",
    .help = "amplitude spectrum of the probe; again: other frequencies, logarithmic",
    .digit = 6,
    .home = PANE_LOWER,
    .draw = draw,
    .variants = variants_of,
    .variant_word = word_of,
    .on_paper = true,
};

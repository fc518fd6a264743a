/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The amplitude spectrum of the probe, with the predicted and the exact lines marked. The slow lines
 * on an even scale, or everything that the mesh can do on a logarithmic one. */
#include "views/plots/plots.h"
#include "scenario/concern_loads.h"
#include "views/view.h"
#include "base/math/functions.h"
#include "answers/dispersion_curves.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>

enum { MARKS_MAX = 12, PEAKS_MAX = 4, PERIODS_LEAST = 2 };

/* A line that should be there, in radians per unit time. */
typedef struct Mark {
    double frequency;
    bool exact;
} Mark;

typedef struct Scale {
    const Spectrum *spectrum;
    double unit; /* radians per unit time in one unit of the axis */
    double end;  /* of the axis, in it */
} Scale;

/* --- what is asked for ---------------------------------------------------------------------------- */

/* The column of a variant; `fast`: all frequencies of the mesh, logarithmic; else those around the line. A
 * beam oscillates a few times only in a run: what it does at once is its thickness modes. */
static int column_of(const Screen *screen, int variant, bool *fast)
{
    const Readout *readout = experiment_readout(screen->experiment);
    const bool si = screen_problem(screen)->si;
    *fast = si ? variant == 0 : variant % 2 == 1;
    return experiment_column(screen->experiment, si                ? (variant < 2 ? "v_probe" : "u_probe")
                                                 : readout->moving ? readout->column
                                                                   : "v_cm");
}

static const char *word_of(const Screen *screen, int variant)
{
    static const char *const bar[] = {"slow", "fast", NULL}, *const beam[] = {"fast", "slow", "displacement",
                                                                              NULL};
    return (!screen_problem(screen)->si ? bar : beam)[variant];
}

/* The lines that theory knows: of the watched mode, of the bar's other modes where v_cm is watched, and, in
 * the picture of all that a mesh does (`fast`), of a beam's height. */
static int marks_of(const Screen *screen, bool fast, Mark marks[MARKS_MAX])
{
    const Settings *settings = screen_settings(screen);
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
        n_overtones = overtones_read(settings_start(settings)->overtones, overtones, NULL);
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
    const Settings *settings = screen_settings(screen);
    const double critical = screen_derived(screen, "dt_crit");
    ModeOnMesh mode;
    if (critical > 0)
        return 2 / critical;
    if (dispersion_mode(settings, dispersion_modes(settings), &mode))
        return mode.exact;
    return M_PI / screen_simulation(screen)->dt;
}

/* --- the picture ---------------------------------------------------------------------------------- */

static double sample(const void *context, size_t index, double *x)
{
    const Scale *scale = context;
    *x = (double)index * scale->spectrum->step / scale->unit;
    return scale->spectrum->amplitudes[index];
}

/* One bin beyond the axis at most. */
static size_t bins_within(const Scale *scale)
{
    const double bins = ceil(scale->end * scale->unit / scale->spectrum->step) + 1;
    return bins < (double)scale->spectrum->count ? (size_t)bins : scale->spectrum->count;
}

static double largest_of(const Scale *scale)
{
    double largest = 0;
    for (size_t k = 1; k < bins_within(scale); k++)
        largest = fmax(largest, scale->spectrum->amplitudes[k]);
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
static int peaks_of(const Scale *scale, bool fast, double peaks[PEAKS_MAX])
{
    const double *a = scale->spectrum->amplitudes;
    const size_t end = bins_within(scale), fiftieth = fast ? end / 50 + 1 : 0,
                 apart = fiftieth > 3 ? fiftieth : 3;
    const double least = largest_of(scale) * (fast ? 1e-3 : 0.05);
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
        peaks[i] = place_of_peak(a, found[i]) * scale->spectrum->step / scale->unit;
    for (int i = 1; i < count; i++)
        for (int k = i; k > 0 && peaks[k] < peaks[k - 1]; k--) {
            const double held = peaks[k];
            peaks[k] = peaks[k - 1];
            peaks[k - 1] = held;
        }
    return count;
}

/* Says why there is no picture yet; false: there is one. */
static bool wants_time(const Screen *screen, const Spectrum *spectrum, bool fast, const Mark *marks,
                       int n_marks, Picture *picture, const char *name)
{
    const double needed = n_marks > 0 ? PERIODS_LEAST * 2 * M_PI / marks[0].frequency : INFINITY;
    if (!screen_problem(screen)->si && !experiment_readout(screen->experiment)->moving)
        picture_say(picture, name, "Nothing vibrates here: there is no line to look for.");
    else if (!spectrum)
        picture_say(picture, name, "needs more time: %d rows at least", SPECTRUM_ROWS_MIN);
    else if (fast || spectrum->to >= needed)
        return false;
    else if (n_marks == 0)
        picture_say(picture, name, "needs more time: no period is known yet");
    else
        picture_say(picture, name, "needs more time: two periods, that is until %s",
                    screen_time_text(screen, needed).text);
    return true;
}

/* "predicted through height 1098, 2038 kHz", so many; false: nothing to describe. */
static bool thickness_line(const Experiment *experiment, int most, char out[160])
{
    double thickness[THICKNESS_LINES_MAX];
    int count = references_thickness_lines(experiment_references(experiment), thickness);
    count = count < most ? count : most;
    snprintf(out, 160, "predicted through height");
    for (int i = 0; i < count; i++)
        text_append(out, 160, "%s %.0f", i > 0 ? "," : "", thickness[i] / (2e3 * M_PI));
    text_append(out, 160, " kHz");
    return count > 0;
}

static void add_marks(const Screen *screen, Picture *picture, const Scale *scale, const Mark *marks,
                      int n_marks)
{
    const bool shown[2] = {screen_shows_predicted(screen), screen_shows_exact(screen)};
    bool named[2] = {false, false};
    for (int i = 0; i < n_marks; i++) {
        const bool exact = marks[i].exact;
        if (!shown[exact])
            continue;
        named[exact] = true;
        const double x = marks[i].frequency / scale->unit;
        picture_line(picture, x, picture->plot.y.low, x, picture->plot.y.high,
                     exact ? pen_exact : pen_predicted);
    }
    if (named[true])
        picture_name(picture, pen_exact, screen_problem(screen)->answer);
    if (named[false])
        picture_name(picture, pen_predicted, "predicted");
}

static void note_peaks(const Screen *screen, Picture *picture, const Scale *scale, bool fast)
{
    char text[160], brief[160];
    double peaks[PEAKS_MAX];
    const int count = peaks_of(scale, fast, peaks);
    const double bin = scale->spectrum->step / scale->unit;
    snprintf(text, 160, count == 0 ? "no peak stands out" : count == 1 ? "peak at" : "peaks at");
    for (int i = 0; i < count; i++)
        text_append(text, 160, "%s %s", i > 0 ? "," : "", text_fitted(peaks[i], 4, 8).text);
    picture_note(picture, STYLE_NORMAL, "%s%s%s" LONG_SHORT("; a bin is %s", ""),
                 screen_is_shared(screen) ? "A " : "", text, !screen_problem(screen)->si ? "" : " kHz",
                 text_fitted(bin, 2, 8).text);
    if (!fast || !screen_shows_predicted(screen) || !thickness_line(screen->experiment, PEAKS_MAX, text))
        return;
    thickness_line(screen->experiment, 2, brief);
    picture_note(picture, STYLE_FAINT, LONG_SHORT("%s", "%s"), text, brief);
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    bool fast;
    int n;
    const int column = column_of(screen, variant, &fast);
    const Column *columns = experiment_columns(screen->experiment, &n);
    if (column < 0) {
        picture_say(picture, "spectrum", "There is no frequency to look for here.");
        return;
    }
    const Quantity *quantity = &columns[column].quantity;
    const bool si = screen_problem(screen)->si;
    Mark marks[MARKS_MAX];
    const int n_marks = marks_of(screen, fast, marks);
    /* what breaks has no line of its own: all that the mesh does is shown */
    fast |= si && !experiment_readout(screen->experiment)->moving;
    const SpectrumSpan span = fast ? SPECTRUM_FAST : SPECTRUM_SLOW;
    Scale scale = {.unit = !si ? 1 : 2e3 * M_PI};
    scale.spectrum = experiment_spectrum(screen->experiment, column, span);
    char name[64];
    snprintf(name, sizeof name, "spectrum of %s", quantity->label);
    if (wants_time(screen, scale.spectrum, fast, marks, n_marks, picture, name))
        return;
    const double range = fast ? highest_of(screen) : slow_range(screen, scale.spectrum, marks, n_marks);
    scale.end = axis_round_up(range / scale.unit);
    ShownRun runs[RUNS_MAX];
    Scale of_run[RUNS_MAX];
    const int n_runs = runs_with(runs, runs_of(screen, runs), quantity->name);
    double largest = 0;
    for (int i = 0; i < n_runs; i++) {
        of_run[i] = scale;
        /* The same column of another run; NULL: it has too few rows. */
        const int at = runs_column(&runs[i], quantity->name);
        of_run[i].spectrum = at < 0 ? NULL
                             : runs[i].experiment
                                 ? experiment_spectrum(runs[i].experiment, at, span)
                                 : experiment_ghost_spectrum(screen->experiment, runs[i].ghost, at, span);
        if (runs[i].experiment && of_run[i].spectrum)
            largest = fmax(largest, largest_of(&of_run[i]));
    }
    picture_axes(picture, axis_make(0, scale.end), !si ? "ω" : "f, kHz", "",
                 fast ? axis_make_log(fmax(largest, 1e-290) * 1e-3, fmax(largest, 1e-286) * 1.02)
                      : axis_make(0, axis_round_up(1.02 * largest)),
                 name, !fast || si ? quantity->unit : "");
    for (int i = n_runs - 1; i >= 0; i--) /* the present run first */
        if (runs[i].experiment && runs[i].shown)
            picture_key(picture, runs_key(&runs[i]));
    add_marks(screen, picture, &scale, marks, n_marks);
    runs_add_keys(picture, runs, n_runs);
    for (int i = 0; i < n_runs; i++) {
        /* A run's letter stands at its highest peak. */
        if (runs[i].shown && of_run[i].spectrum) {
            runs_begin(picture, &runs[i]);
            plot_curve(&picture->plot, sample, &of_run[i], 0, bins_within(&of_run[i]), picture->dots);
            size_t best = 0;
            for (size_t k = 1; k < bins_within(&of_run[i]); k++)
                if (best == 0 || of_run[i].spectrum->amplitudes[k] > of_run[i].spectrum->amplitudes[best])
                    best = k;
            double x;
            const double y = sample(&of_run[i], best, &x);
            runs_letter(picture, &runs[i], x, y, MARK_PLACE);
        }
    }
    note_peaks(screen, picture, &scale, fast);
}

const View view_spectrum = {
    .word = "spectrum",
    .help = "amplitude spectrum of the probe; again: other frequencies, logarithmic",
    .digit = 6,
    .home = PANE_LOWER,
    .describe = describe,
    .variant_word = word_of,
};

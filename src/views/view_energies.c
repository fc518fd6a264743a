/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energies over time, stacked. */
#include "views/plots/plots.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/settings.h"
#include "base/kinds.h"
#include "views/view.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>

/* Energies stacked from below: what the grid sees, what it does not, strain, dissipated. */
typedef struct Layer {
    const char *name;
    int column, minus, less; /* its height: column - minus - less */
    Style style;
} Layer;

typedef struct Stack {
    const Record *record;
    Layer layers[6];
    int count;
} Stack;

static double stack_height(const Stack *stack, size_t index, int upto)
{
    const Record *record = stack->record;
    double sum = 0;
    for (int i = 0; i < upto; i++) {
        const Layer *layer = &stack->layers[i];
        sum += record_known(record, index, layer->column) -
               (layer->minus >= 0 ? record_known(record, index, layer->minus) : 0) -
               (layer->less >= 0 ? record_known(record, index, layer->less) : 0);
    }
    return sum;
}

static void add_layer(const Screen *screen, Stack *stack, const char *name, const char *column, Style style)
{
    const int at = experiment_column(screen->experiment, column);
    if (at >= 0)
        stack->layers[stack->count++] = (Layer){name, at, -1, -1, style};
}

/* The kinetic energy of the beam moving on as a whole, 1/2 m v0^2; 0: it does not. That of the vibration is a
 * millionth of it, and the two cannot be distinguished by a difference: a hundred-millionth more speed along
 * the beam, times its mass and its speed, is as much as the whole vibration. */
static double rigid_energy(const Experiment *experiment)
{
    const Settings *settings = experiment_settings(experiment);
    /* what is mapped to a grid counts without its common speed */
    if (!(settings->problem->concerns & CONCERN_MOTION) ||
        simulation_has(experiment_simulation(experiment), HAS_MESH))
        return 0;
    const double volume = settings_lattice(settings)->spacing * settings_lattice(settings)->spacing *
                          settings_geometry(settings)->thickness;
    const double nodes = (double)experiment_simulation(experiment)->counts[0];
    return nodes * volume * settings_material(settings)->density * settings_motion(settings)->speed *
           settings_motion(settings)->speed / 2;
}

/* Of APIC the null space is that of velocities without their slopes: no part of the sum. */
static int null_column(const Screen *screen)
{
    const bool apic = settings_transfer(screen_settings(screen))->transfer == MPM_APIC;
    return apic ? -1 : experiment_column(screen->experiment, "kinetic_null");
}

static Stack stack_of(const Screen *screen)
{
    Stack stack = {.record = experiment_record(screen->experiment)};
    if (rigid_energy(screen->experiment) > 0) {
        add_layer(screen, &stack, "strain, for travel dwarfs the rest", "strain", STYLE_EXACT);
        return stack;
    }
    const int grid = experiment_column(screen->experiment, "kinetic_grid"), null = null_column(screen);
    if (grid >= 0) {
        add_layer(screen, &stack, "grid", "kinetic_grid", STYLE_MEASURED);
        add_layer(screen, &stack, "lumping", "kinetic", STYLE_SECOND);
        stack.layers[stack.count - 1].minus = grid;
        stack.layers[stack.count - 1].less = null;
        if (null >= 0)
            add_layer(screen, &stack, "null", "kinetic_null", STYLE_THIRD);
    } else
        add_layer(screen, &stack, "kinetic", "kinetic", STYLE_MEASURED);
    add_layer(screen, &stack, "strain", "strain", STYLE_EXACT);
    if (grid >= 0 || screen_has(screen, HAS_BREAKING))
        add_layer(screen, &stack, "dissipated", "dissipated", STYLE_THIRD);
    /* on a tilted floor it has no least value */
    const Settings *settings = screen_settings(screen);
    const Loads *loads = settings_loads(settings);
    if (loads->gravity > 0 && loads->incline == 0)
        add_layer(screen, &stack, "potential", "potential", STYLE_SECOND);
    if (settings_contact(settings)->friction > 0 || settings_domain(settings)->friction > 0)
        add_layer(screen, &stack, "friction", "friction", STYLE_THIRD);
    add_layer(screen, &stack, "damped", "damped", STYLE_SECOND);
    return stack;
}

/* Dots across in which single oscillations are seen; no screen is as fine. */
enum { FINE = 500 };

/* How long one oscillation takes, as well as it is known; 0: nothing oscillates steadily. */
static double oscillation_period(const Screen *screen)
{
    const Readout *readout = experiment_readout(screen->experiment);
    const double known = readout->measured_known    ? readout->measured
                         : readout->predicted_known ? readout->predicted
                         : readout->exact_known     ? readout->exact
                                                    : 0;
    if (!readout->moving || readout->drifting || !(known > 0))
        return 0;
    return readout->is_period ? known : 2 * M_PI / known;
}

/* The mean height of the first `upto` layers over a whole oscillation around a time: kinetic and strain
 * energy change places twice in an oscillation, and what stays, grows or goes is read where they do not. Near
 * the ends of the record it is the first or the last whole oscillation. */
static double mean_height(const Stack *stack, double time, double period, int upto)
{
    enum { SAMPLES = 64 };
    const Record *record = stack->record;
    const double end = record_row(record, record->count - 1)[1];
    double from = fmin(fmax(time - period / 2, 0), fmax(end - period, 0)), sum = 0;
    const double length = fmin(period, end - from);
    for (int i = 0; i < SAMPLES; i++)
        sum += stack_height(stack, record_find(record, from + length * (i + 0.5) / SAMPLES), upto);
    return sum / SAMPLES;
}

/* The mean height of the first `upto` layers over the rows of a column of dots. */
static double column_height(const Stack *stack, double from, double to, int upto)
{
    const size_t first = record_find(stack->record, from), end = record_find(stack->record, to);
    double sum = 0;
    for (size_t k = first; k <= end; k++)
        sum += stack_height(stack, k, upto);
    return sum / (double)(end - first + 1);
}

/* One point a column of dots: the rows of it. Bands need no extremes: their edges are sums that hardly change
 * within a column when the curve's oscillation is wider than one; where it is narrower, its mean is given. */
static void add_bands(Picture *picture, const Stack *stack, double period, bool means)
{
    Plot *plot = &picture->plot;
    const int dots = picture->dots;
    const Record *record = stack->record;
    const double step = (plot->x.high - plot->x.low) / dots;
    const size_t begin = record_find(record, plot->x.low), last = record_find(record, plot->x.high);
    const bool every_row = !means && last - begin < (size_t)dots && dots >= FINE;
    const double newest = record->count && !every_row ? record_row(record, record->count - 1)[1] : -INFINITY;
    for (int layer = 0; layer < stack->count; layer++) {
        const Style style = stack->layers[layer].style;
        plot_begin(plot, STROKE_BAND, (Pen){LINE_SOLID, "#+.:"[layer & 3], style, RANK_BAND, layer});
        for (size_t k = begin; every_row && k <= last && k < record->count; k++)
            for (int edge = 0; edge < 2; edge++)
                plot_point(plot, record_row(record, k)[1], stack_height(stack, k, layer + edge));
        for (int i = 0; i < dots && plot->x.low + i * step <= newest; i++) {
            const double from = plot->x.low + i * step,
                         time = means ? plot->x.low + (i + 0.5) * step : from + step / 2;
            for (int edge = 0; edge < 2; edge++)
                plot_point(plot, time,
                           means ? mean_height(stack, time, period, layer + edge)
                                 : column_height(stack, from, from + step, layer + edge));
        }
    }
}

/* The shares of the kinetic energy that the grid has not, over what the plot shows: what lumped masses make
 * too small, and the null space. False: not known. */
static bool unseen_shares(const Screen *screen, const Record *record, const Axis *x, double *lumping,
                          double *hidden)
{
    const int kinetic = experiment_column(screen->experiment, "kinetic"),
              grid = experiment_column(screen->experiment, "kinetic_grid");
    const int null = null_column(screen);
    double all = 0, seen = 0, blind = 0;
    if (kinetic < 0 || grid < 0 || record->count == 0)
        return false;
    for (size_t i = record_find(record, x->low); i < record->count && record_row(record, i)[1] <= x->high;
         i++) {
        const double *row = record_row(record, i);
        all += row[kinetic];
        seen += row[grid];
        blind += null >= 0 ? record_known(record, i, null) : 0;
    }
    *lumping = 1 - (seen + blind) / all;
    *hidden = null >= 0 ? blind / all : NAN;
    return all > 0;
}

/* Where more than that is lost or gained it is not the ripple that is to be explained. */
#define KEPT_SHARE 0.05

/* Phrases separated by two spaces: total, E*, what the grid has not, and what the ripple is. */
static void energy_phrases(const Screen *screen, const Stack *stack, const Axis *x, char out[320])
{
    const Record *record = stack->record;
    const double *now = experiment_row(screen->experiment), *start = record_row(record, 0);
    const int total = experiment_column(screen->experiment, "total");
    out[0] = '\0';
    if (record->count == 0 || !now || total < 0)
        return;
    double sharp, first;
    text_append(out, 320, "total %s", text_fitted(now[total], 4, 10).text);
    /* what is kept is told once: the total as a share of the start would tell its ripple as well; the zero of
     * a potential is anywhere, so that a share of it says nothing */
    const bool known = experiment_invariant(screen->experiment, &sharp, &first) && first > 0;
    const bool shared = start[total] != 0 && settings_loads(screen_settings(screen))->gravity == 0;
    if (shared && !known) {
        const double share = now[total] / start[total];
        if (share > 100) /* a run that blows up */
            text_append(out, 320, " = %.0f times the start", share);
        else
            text_append(out, 320, " = %.2f %%" LONG_SHORT(" of the start", ""), 100 * share);
    }
    if (known) {
        const double loss = 100 * (1 - sharp / first);
        text_append(out, 320, "  E* %s, %s %.3f %%", text_fitted(sharp, 4, 10).text,
                    loss < -5e-4 ? "gain" : "loss", fabs(loss));
    }
    double lumping, hidden;
    const bool shares = unseen_shares(screen, record, x, &lumping, &hidden);
    const double rigid = rigid_energy(screen->experiment);
    if (rigid > 0)
        text_append(out, 320, "  kinetic %s J of travel" LONG_SHORT(" (1/2 m v0^2)", "") ": not drawn",
                    text_fitted(rigid, 4, 10).text);
    if (shares && isfinite(hidden))
        text_append(out, 320, "  null space %.2f %%" LONG_SHORT(" of kinetic in this window", ""),
                    100 * hidden);
    if (shares)
        text_append(out, 320, "  lumping %.2f %%", 100 * lumping);
    const double kept = known ? sharp / first : shared ? now[total] / start[total] : 1;
    if (shares && fabs(1 - kept) < KEPT_SHARE)
        text_append(out, 320,
                    LONG_SHORT("  the ripple comes from v and stress half a step apart; no energy is lost",
                               "  ripple: v, stress half a step apart"));
}

static const char *word_of(const Screen *screen, int variant)
{
    return variant > 0 ? crack_cost_variant_word(screen, variant - 1) : "stack";
}

/* The largest work up to the present row. */
static double most_work_by(const Record *record, int work, const double *now)
{
    double most = fabs(now[work]);
    for (size_t i = 0; i < record->count && record_row(record, i)[1] <= now[1]; i += time_plot_stride(record))
        most = fmax(most, fabs(record_row(record, i)[work]));
    return most;
}

static void note_run(const Screen *screen, Picture *picture, const char *run, int rows)
{
    const Stack stack = stack_of(screen);
    char phrases[320];
    const double *now = experiment_row(screen->experiment);
    const int total = experiment_column(screen->experiment, "total"),
              work = experiment_column(screen->experiment, "work");
    const double most_work = now && work >= 0 && !screen_has(screen, HAS_RELATIVE_ENERGY)
                                 ? most_work_by(stack.record, work, now)
                                 : 0;
    energy_phrases(screen, &stack, &picture->plot.x, phrases);
    if (most_work > 0 && experiment_column(screen->experiment, "kinetic_grid") < 0 && total >= 0 &&
        stack.record->count > 0) {
        /* What the balance lacks: kinetic + strain + dissipated less the start and the work of the load,
         * against the largest work so far; of second order in the time step. */
        const double residual = now[total] - record_row(stack.record, 0)[total] - now[work];
        snprintf(phrases, sizeof phrases, "residual %+.2f %% of the work  total %s J  work %s J",
                 100 * residual / most_work, text_fitted(now[total], 4, 9).text,
                 text_fitted(now[work], 4, 9).text);
    }
    picture_note(picture, STYLE_NORMAL, "%s%s", run, phrases)->rows = rows;
}

static void add_keys(Picture *picture, const Stack *stack, const ShownRun *runs, int n_runs,
                     const ShownRun *second, bool work)
{
    if (second) {
        picture_key(picture, (PictureKey){LINE_SOLID, '#', STYLE_MEASURED, "A", 0, 0});
        picture_key(picture, runs_key(second));
    }
    for (int i = 0; i < stack->count; i++)
        picture_key(picture, (PictureKey){LINE_SOLID, '#', stack->layers[i].style, stack->layers[i].name,
                                          SIGN_BAND, i});
    if (work)
        picture_name(picture, pen_predicted, "work");
    runs_add_keys(picture, runs, n_runs);
}

/* One line for each run of a duel; else as many as are needed. */
static void note_runs(const Screen *screen, Picture *picture, bool both, double most_work)
{
    /* of velocities and stresses half a step apart there is more to say; velocity Verlet has none */
    const bool staggered = experiment_column(screen->experiment, "kinetic_grid") >= 0;
    const bool more = staggered || most_work > 0 || rigid_energy(screen->experiment) > 0;
    const int rows = 1 + more + (staggered || screen_has(screen, HAS_BREAKING));
    for (int run = 0; run < 2 && both; run++) {
        const Screen one = screen_of_side(screen, run == 0 ? SIDE_A : SIDE_B);
        note_run(&one, picture, run == 0 ? "A " : "B ", 1);
    }
    if (!both)
        note_run(screen, picture, "", rows);
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    if (variant > 0) {
        crack_cost_describe(screen, variant - 1, picture);
        return;
    }
    const Stack stack = stack_of(screen);
    const Record *record = stack.record;
    const bool apart = screen_has(screen, HAS_RELATIVE_ENERGY);
    const int work = apart ? -1 : experiment_column(screen->experiment, "work");
    double most = 0, most_work = 0;
    for (size_t i = 0; i < record->count; i += time_plot_stride(record)) {
        most = fmax(most, stack_height(&stack, i, stack.count));
        if (work >= 0)
            most_work = fmax(most_work, fabs(record_row(record, i)[work]));
    }
    const char *line = rigid_energy(screen->experiment) > 0 ? "strain" : "total"; /* of the other runs */
    ShownRun runs[RUNS_MAX];
    const int n_runs = runs_with(runs, runs_of(screen, runs), line);
    const ShownRun *second =
        screen_is_shared(screen) && n_runs > 1 && runs[n_runs - 2].experiment ? &runs[n_runs - 2] : NULL;
    for (int i = 0; i < n_runs; i++)
        if (runs[i].experiment)
            most = fmax(most, time_plot_reach(runs[i].record, runs_column(&runs[i], line)));
    overlay_widen(screen, line, false, &(double){0}, &most);
    time_plot_axes(screen, picture, axis_make(0, axis_round_up(fmax(most, most_work) * 1.02)), "energy",
                   screen_problem(screen)->si ? "J" : "");
    add_keys(picture, &stack, runs, n_runs, second, most_work > 0);
    const double period = oscillation_period(screen);
    const bool means = period > 0 && picture->dots < FINE;
    add_bands(picture, &stack, period, means);
    if (means) {
        /* Each band that is high enough has its name in it: colours alone would not distinguish them. */
        const Axis *x = &picture->plot.x, *y = &picture->plot.y;
        const double time = x->low + (x->high - x->low) / 16, least = (y->high - y->low) / 24;
        for (int layer = 0; layer < stack.count && stack.record->count > 0; layer++) {
            const double low = mean_height(&stack, time, period, layer);
            const double high = mean_height(&stack, time, period, layer + 1);
            if (high - low > least)
                picture_label(picture, time, (low + high) / 2, 1, STYLE_NORMAL, "%s",
                              stack.layers[layer].name)
                    ->height = high - low;
        }
    }
    if (most_work > 0) {
        plot_begin(&picture->plot, STROKE_LINE, pen_predicted);
        time_plot_curve(picture, &(TimeCurve){record, work, NULL, NULL});
    }
    runs_add_ghosts(picture, runs, n_runs, line);
    if (second) {
        runs_begin(picture, second);
        time_plot_curve(picture, &(TimeCurve){second->record, runs_column(second, line), NULL, NULL});
    }
    overlay_add(screen, picture, line, false);
    runs_add_letters(picture, runs, n_runs, line);
    note_runs(screen, picture, second != NULL, most_work);
}

static const char *curve(const Screen *screen)
{
    (void)screen;
    return "total";
}

const View view_energies = {
    .word = "energies",
    .brief = "energy",
    .help = "energies: grid, lumping, null space, strain, work; again: a crack's cost, its parts",
    .digit = 3,
    .home = PANE_LOWER,
    .describe = describe,
    .variant_word = word_of,
    .names_run = true,
    .has_time_axis = true,
    .curve = curve,
};

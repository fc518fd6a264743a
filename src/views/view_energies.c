/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energies over time, stacked. */
#include "views/plots/overlay_plot.h"
#include "views/plots/runs.h"
#include "views/plots/time_plot.h"
#include "views/views.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Energies stacked from below: what the grid sees, what it does not, strain, dissipated. */
typedef struct Layer {
    const char *name;
    int column, minus, less; /* its height: column - minus - less */
    Style style;
    int fill;
} Layer;

typedef struct Stack {
    const Record *record;
    Layer layers[4];
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

static void add_layer(Stack *stack, const char *name, int column, int minus, Style style)
{
    if (column >= 0) {
        stack->layers[stack->count] = (Layer){name, column, minus, -1, style, stack->count};
        stack->count++;
    }
}

static bool breaks(const Experiment *experiment)
{
    return simulation_has(experiment_simulation(experiment), HAS_BREAKING);
}

/* The kinetic energy of the beam moving on as a whole, 1/2 m v0^2; 0: it does not. That of the vibration is a
 * millionth of it, and the two cannot be told apart by a difference: a hundred-millionth more speed along the
 * beam, times its mass and its speed, is as much as the whole vibration. */
static double rigid_energy(const Experiment *experiment)
{
    const Settings *settings = experiment_settings(experiment);
    /* what is mapped to a grid counts without its common speed */
    if (!(settings->problem->concerns & CONCERN_MOTION) ||
        simulation_has(experiment_simulation(experiment), HAS_MESH))
        return 0;
    const double volume =
        settings->lattice.spacing * settings->lattice.spacing * settings->geometry.thickness;
    const double nodes = (double)experiment_simulation(experiment)->counts[0];
    return nodes * volume * settings->material.density * settings->motion.speed * settings->motion.speed / 2;
}

/* Of APIC the null space is that of velocities without their slopes: no part of the sum. */
static int null_column(const Screen *screen)
{
    const bool apic = experiment_settings(screen->experiment)->mpm.transfer == MPM_APIC;
    return apic ? -1 : screen_column(screen, "kinetic_null");
}

static Stack stack_of(const Screen *screen)
{
    Stack stack = {.record = experiment_record(screen->experiment)};
    if (rigid_energy(screen->experiment) > 0) {
        add_layer(&stack, "strain, for travel dwarfs the rest", screen_column(screen, "strain"), -1,
                  STYLE_EXACT);
        return stack;
    }
    const int kinetic = screen_column(screen, "kinetic"), grid = screen_column(screen, "kinetic_grid");
    const int null = null_column(screen);
    if (grid >= 0) {
        add_layer(&stack, "grid", grid, -1, STYLE_MEASURED);
        add_layer(&stack, "lumping", kinetic, grid, STYLE_SECOND);
        if (null >= 0) {
            stack.layers[stack.count - 1].less = null;
            add_layer(&stack, "null", null, -1, STYLE_THIRD);
        }
    } else {
        add_layer(&stack, "kinetic", kinetic, -1, STYLE_MEASURED);
    }
    add_layer(&stack, "strain", screen_column(screen, "strain"), -1, STYLE_EXACT);
    if (screen_column(screen, "kinetic_grid") >= 0 || breaks(screen->experiment))
        add_layer(&stack, "dissipated", screen_column(screen, "dissipated"), -1, STYLE_THIRD);
    add_layer(&stack, "damped", screen_column(screen, "damped"), -1, STYLE_SECOND);
    return stack;
}

enum { PAPER_DOTS = 500 }; /* no screen is as fine */

/* How long one swing takes, as well as it is known; 0: nothing swings steadily. */
static double swing_of(const Screen *screen)
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

/* The mean height of the first `upto` layers over a whole swing around a time: kinetic and strain energy
 * change places twice in a swing, and what stays, grows or goes is read where they do not. Near the ends of
 * the record it is the first or the last whole swing. */
static double mean_height(const Stack *stack, double time, double swing, int upto)
{
    enum { SAMPLES = 64 };
    const Record *record = stack->record;
    const double end = record_row(record, record->count - 1)[1];
    double from = fmin(fmax(time - swing / 2, 0), fmax(end - swing, 0)), sum = 0;
    const double length = fmin(swing, end - from);
    for (int i = 0; i < SAMPLES; i++)
        sum += stack_height(stack, record_find(record, from + length * (i + 0.5) / SAMPLES), upto);
    return sum / SAMPLES;
}

static void add_means(Plot *plot, const Stack *stack, double swing, int dots, bool solid)
{
    const Record *record = stack->record;
    const double step = (plot->x.high - plot->x.low) / dots;
    const double newest = record->count ? record_row(record, record->count - 1)[1] : -INFINITY;
    for (int layer = 0; layer < stack->count; layer++) {
        plot_begin(plot, STROKE_BAND, LINE_SOLID, stack->layers[layer].style, RANK_BAND, "#+.:"[layer & 3]);
        plot->strokes[plot->n_strokes - 1].fill = solid ? 0 : stack->layers[layer].fill;
        for (int i = 0; i < dots && plot->x.low + i * step <= newest; i++) {
            const double time = plot->x.low + (i + 0.5) * step;
            plot_point(plot, time, mean_height(stack, time, swing, layer));
            plot_point(plot, time, mean_height(stack, time, swing, layer + 1));
        }
    }
}

/* One point a column of dots: the row at its middle. Bands need no extremes: their edges are sums that hardly
 * change within a column when the curve's swing is wider than one; where it is narrower, the mean is told. */
static void add_stack(Plot *plot, const Stack *stack, int dots, bool solid)
{
    const Record *record = stack->record;
    const double step = (plot->x.high - plot->x.low) / dots;
    const size_t begin = record_find(record, plot->x.low), last = record_find(record, plot->x.high);
    const bool every_row = last - begin < (size_t)dots && dots >= PAPER_DOTS;
    for (int layer = 0; layer < stack->count; layer++) {
        plot_begin(plot, STROKE_BAND, LINE_SOLID, stack->layers[layer].style, RANK_BAND, "#+.:"[layer & 3]);
        plot->strokes[plot->n_strokes - 1].fill = solid ? 0 : stack->layers[layer].fill;
        for (size_t k = begin; every_row && k <= last && k < record->count; k++) {
            plot_point(plot, record_row(record, k)[1], stack_height(stack, k, layer));
            plot_point(plot, record_row(record, k)[1], stack_height(stack, k, layer + 1));
        }
        const double newest =
            record->count && !every_row ? record_row(record, record->count - 1)[1] : -INFINITY;
        for (int i = 0; i < dots; i++) {
            double from = plot->x.low + i * step, low = 0, high = 0;
            if (from > newest)
                break;
            size_t first = record_find(record, from), end = record_find(record, from + step);
            for (size_t k = first; k <= end; k++) {
                low += stack_height(stack, k, layer);
                high += stack_height(stack, k, layer + 1);
            }
            double count = (double)(end - first + 1);
            plot_point(plot, from + step / 2, low / count);
            plot_point(plot, from + step / 2, high / count);
        }
    }
}

/* Each band that is high enough has its name in it, at the left: colours alone would not tell them apart. */
static void name_bands(const Stack *stack, Area inner, const Axis *x, const Axis *y, double swing)
{
    if (stack->record->count == 0)
        return;
    const double time = x->low + (x->high - x->low) / 16, row = (y->high - y->low) / inner.rect.height;
    int last = inner.rect.height;
    for (int layer = 0; layer < stack->count; layer++) {
        const double low = swing > 0 ? mean_height(stack, time, swing, layer) : 0;
        const double high = swing > 0 ? mean_height(stack, time, swing, layer + 1) : 0;
        const int at = axis_row(y, (low + high) / 2, inner.rect.height);
        if (high - low > 0.9 * row && at >= 0 && at < last)
            area_print(inner, 1, last = at, STYLE_NORMAL, " %s ", stack->layers[layer].name);
    }
}

/* The shares of the kinetic energy that the grid has not, over what the plot shows: what lumped masses make
 * too small, and the null space. False: not known. */
static bool unseen_shares(const Screen *screen, const Record *record, const Axis *x, double *lumping,
                          double *hidden)
{
    const int kinetic = screen_column(screen, "kinetic"), grid = screen_column(screen, "kinetic_grid");
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

/* Phrases parted by two spaces: total, E*, what the grid has not, and what the ripple is. */
static void energy_phrases(const Screen *screen, const Stack *stack, const Axis *x, bool wide, char out[320])
{
    const Record *record = stack->record;
    const double *now = experiment_row(screen->experiment), *start = record_row(record, 0);
    const int total = screen_column(screen, "total");
    out[0] = '\0';
    if (record->count == 0 || !now || total < 0)
        return;
    char number[NUMBER_TEXT_MAX];
    double sharp, first;
    text_fitted(now[total], 4, 10, number);
    text_append(out, 320, "total %s", number);
    /* what is kept is told once: the total as a share of the start would tell its ripple as well */
    const bool known = experiment_invariant(screen->experiment, &sharp, &first) && first > 0;
    if (start[total] != 0 && !known) {
        const double share = now[total] / start[total];
        if (share > 100) /* a run that blows up */
            text_append(out, 320, " = %.0f times the start", share);
        else
            text_append(out, 320, " = %.2f %%%s", 100 * share, wide ? " of the start" : "");
    }
    if (known) {
        const double loss = 100 * (1 - sharp / first);
        text_fitted(sharp, 4, 10, number);
        text_append(out, 320, "  E* %s, %s %.3f %%", number, loss < -5e-4 ? "gain" : "loss", fabs(loss));
    }
    double lumping, hidden;
    const bool shares = unseen_shares(screen, record, x, &lumping, &hidden);
    const double rigid = rigid_energy(screen->experiment);
    if (rigid > 0) {
        text_fitted(rigid, 4, 10, number);
        text_append(out, 320, "  kinetic %s J of travel%s: not drawn", number, wide ? " (1/2 m v0^2)" : "");
    }
    if (shares && isfinite(hidden))
        text_append(out, 320, "  null space %.2f %%%s", 100 * hidden,
                    wide ? " of kinetic in this window" : "");
    if (shares)
        text_append(out, 320, "  lumping %.2f %%", 100 * lumping);
    const double kept = known ? sharp / first : start[total] != 0 ? now[total] / start[total] : 1;
    if (shares && fabs(1 - kept) < KEPT_SHARE)
        text_append(out, 320,
                    wide ? "  the ripple is staggering (v and stress half a step apart), not loss"
                         : "  the ripple is staggering, not loss");
}

/* What the balance lacks: kinetic + strain + dissipated less the start and the work of the load, against the
 * largest work so far. A bond breaks at the first step beyond its limit and takes along what it then holds
 * too much, so where bonds break the residual is of first order in the time step, and a share of what they
 * took. */
static void residual_phrases(const Screen *screen, double most_work, char out[320])
{
    const double *now = experiment_row(screen->experiment);
    const int total = screen_column(screen, "total"), work = screen_column(screen, "work");
    const Record *record = experiment_record(screen->experiment);
    if (!now || !(most_work > 0) || work < 0 || total < 0 || record->count == 0)
        return;
    const double residual = now[total] - record_row(record, 0)[total] - now[work];
    char sum[NUMBER_TEXT_MAX], load[NUMBER_TEXT_MAX];
    text_fitted(now[total], 4, 9, sum);
    text_fitted(now[work], 4, 9, load);
    snprintf(out, 320, "residual %+.2f %% of the work", 100 * residual / most_work);
    const int dissipated = screen_column(screen, "dissipated");
    if (breaks(screen->experiment) && dissipated >= 0 && now[dissipated] > 0)
        text_append(out, 320, "  = %.1f %% of what broke  breaking is first order in dt",
                    100 * residual / now[dissipated]);
    text_append(out, 320, "  total %s J  work %s J", sum, load);
}

static int variants_of(const Screen *screen)
{
    return 1 + crack_cost_variants(screen);
}

static const char *word_of(const Screen *screen, int variant)
{
    return variant > 0 ? crack_cost_variant_word(screen, variant - 1) : "stack";
}

static void draw(const Screen *screen, Area area, Style heading, int variant)
{
    if (variant > 0) {
        crack_cost_draw(screen, area, heading, variant - 1);
        return;
    }
    const Stack stack = stack_of(screen);
    const Record *record = stack.record;
    const bool apart = simulation_has(experiment_simulation(screen->experiment), HAS_RELATIVE_ENERGY);
    const int work = apart ? -1 : screen_column(screen, "work");
    double most = 0, most_work = 0;
    for (size_t i = 0; i < record->count; i += time_plot_stride(record)) {
        most = fmax(most, stack_height(&stack, i, stack.count));
        if (work >= 0)
            most_work = fmax(most_work, fabs(record_row(record, i)[work]));
    }
    const bool is_rigid = rigid_energy(screen->experiment) > 0;
    const char *line = is_rigid ? "strain" : "total"; /* of the other runs */
    Run runs[RUNS_MAX];
    const int n_runs = runs_with(runs, runs_of(screen, runs), line);
    const Run *second =
        screen_is_shared(screen) && n_runs > 1 && runs[n_runs - 2].experiment ? &runs[n_runs - 2] : NULL;
    for (int i = 0; i < n_runs; i++)
        if (runs[i].experiment)
            most = fmax(most, time_plot_reach(runs[i].record, run_column(&runs[i], line)));
    overlay_widen(screen, line, false, &(double){0}, &most);
    /* bands are told apart by colour or, without colours, by how densely they are filled: the legend shows a
     * piece of each */
    const bool solid = screen->look.colours > 0 && area.glyphs != GLYPHS_NONE && !area.canvas->picture;
    const double swing = swing_of(screen);
    static const char *const keys[GLYPHS_NONE + 1][4] = {
        [GLYPHS_BRAILLE] = {"⣿⣿", "⢕⢕", "⠅⠅", "⠁⠁"},
        [GLYPHS_BLOCK] = {"▓▓", "▒▒", "░░", "··"},
        [GLYPHS_ASCII] = {"##", "++", "..", "::"},
    };
    Legend legend[8 + RUNS_MAX];
    int n_legend = 0;
    if (second) {
        legend[n_legend++] = (Legend){LINE_SOLID, '#', STYLE_MEASURED, "A", NULL};
        legend[n_legend++] = run_legend(second);
    }
    for (int i = 0; i < stack.count; i++)
        legend[n_legend++] =
            (Legend){LINE_SOLID, '#', stack.layers[i].style, stack.layers[i].name,
                     keys[area.glyphs][solid && area.glyphs != GLYPHS_ASCII ? 0 : stack.layers[i].fill & 3]};
    if (most_work > 0)
        legend[n_legend++] = (Legend){LINE_DASHED, '-', STYLE_PREDICTED, "work", NULL};
    n_legend += runs_ghost_legends(runs, n_runs, legend + n_legend);
    const int height = area.rect.height;
    Axis y = axis_make(0, axis_round_up(fmax(most, most_work) * 1.02), height < 7 ? 2 : height < 15 ? 4 : 6);
    char scale[TICK_TEXT_MAX], name[32], phrases[320];
    axis_scale_text(&y, screen_problem(screen)->si ? "J" : "", scale);
    /* a band without a name says nothing: what the heading has no room for stands below it */
    const int named = heading_draw(area, heading, "energy", scale, legend, n_legend),
              top = 1 + (named < n_legend);
    legend_draw_short(area, 2, 1, legend + named, n_legend - named);
    /* of velocities and stresses half a step apart there is more to say; velocity Verlet has none */
    const bool staggered = screen_column(screen, "kinetic_grid") >= 0, tall = height - top >= 10;
    const int lines = (staggered || most_work > 0 || is_rigid ? 2 : 1) +
                      (tall && (staggered || breaks(screen->experiment)));
    const int under = height - top >= 7 ? lines : height - top >= 5 ? 1 : 0;
    Area plot_area = area_part(area, 0, top, area.rect.width, height - top - under);
    const int width = plot_area.rect.width - GUTTER - 1, dots = width * plot_dots_across(area.glyphs);
    Axis x = time_plot_axis(screen, width);
    Area inner = axes_draw(plot_area, &x, &y, time_plot_name(screen, &x, name, sizeof name), GUTTER);
    Plot plot;
    plot_open(&plot, x, y);
    if (swing > 0 && !area.canvas->picture)
        add_means(&plot, &stack, swing, dots, solid);
    else
        add_stack(&plot, &stack, dots, solid);
    if (most_work > 0) {
        plot_begin(&plot, STROKE_LINE, LINE_DASHED, STYLE_PREDICTED, RANK_PREDICTED, '-');
        time_plot_curve(&plot, &(Curve){.record = record, .column = work, .minus = -1, .plus = -1}, dots);
    }
    runs_add_ghosts(&plot, runs, n_runs, line, dots);
    if (second) {
        run_begin(&plot, second);
        time_plot_curve(
            &plot,
            &(Curve){.record = second->record, .column = run_column(second, line), .minus = -1, .plus = -1},
            dots);
    }
    overlay_stroke(screen, &plot, line, false, dots);
    time_plot_breaks(screen, inner, &x);
    time_plot_now(screen, inner, &x);
    plot_draw(&plot, inner);
    if (swing > 0 && solid)
        name_bands(&stack, inner, &x, &y, swing);
    overlay_marks(screen, inner, &plot, line, false);
    runs_draw_letters(&plot, inner, runs, n_runs, line);
    plot_close(&plot);

    const bool wide = area.rect.width > 90;
    energy_phrases(screen, &stack, &x, wide, phrases);
    if (most_work > 0 && screen_column(screen, "kinetic_grid") < 0)
        residual_phrases(screen, most_work, phrases);
    if (!second || under < 2) {
        const int x0 = 1 + (second && under ? area_text(area, 1, height - under, "A ", STYLE_NORMAL) : 0);
        area_phrases(area, x0, height - under, area.rect.width - 1 - x0, under, phrases, STYLE_NORMAL);
        return;
    }
    for (int run = 0; run < 2; run++) {
        const Screen one = screen_of_side(screen, run == 0 ? SIDE_A : SIDE_B);
        const Stack of_one = stack_of(&one);
        energy_phrases(&one, &of_one, &x, wide, phrases);
        if (most_work > 0 && screen_column(&one, "kinetic_grid") < 0)
            residual_phrases(&one, most_work, phrases);
        area_text(area, 1, height - under + run, run == 0 ? "A" : "B", STYLE_NORMAL);
        area_phrases(area, 3, height - under + run, area.rect.width - 4, 1, phrases, STYLE_NORMAL);
    }
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
    .draw = draw,
    .variants = variants_of,
    .variant_word = word_of,
    .names_run = true,
    .has_time_axis = true,
    .on_paper = true,
    .curve = curve,
};

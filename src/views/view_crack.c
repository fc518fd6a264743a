/* SPDX-License-Identifier: GPL-3.0-or-later */
/* More pictures of a beam that breaks: the crack's path with its angle, the angle over time, and what a piece
 * of crack has cost beside the fracture energy that it should cost. */
#include "views/views.h"
#include "views/plots/runs.h"
#include "views/plots/time_plot.h"

#include "base/math/functions.h"
#include "answers/crack_growth.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct Notch {
    double x, y; /* its end, m */
} Notch;

static Notch notch_of(const Settings *settings)
{
    return (Notch){settings->notch.position, settings->notch.depth};
}

static bool has_crack(const Screen *screen)
{
    return screen_column(screen, "crack_x") >= 0;
}

/* Under a plot of the crack: the same two lines as under the others. */
static int lines_under(Area area)
{
    return area.rect.height < 7 ? 0 : area.rect.width >= 100 ? 1 : 2;
}

/* `first`: what this plot tells beside them; "": nothing. */
static void draw_lines(const Screen *screen, Area area, int under, const char *first)
{
    char lines[2][160];
    beam_lines(screen, area.rect.width - 2, lines[0], lines[1]);
    if (*first)
        snprintf(lines[0], sizeof lines[0], "%s", first);
    if (under == 1)
        text_append(lines[0], sizeof lines[0], "  %s", lines[1]);
    for (int i = 0; i < under; i++)
        area_phrases(area, 1, area.rect.height - under + i, area.rect.width - 2, 1, lines[i], STYLE_NORMAL);
}

/* The present run, what it should be, and the ghosts. */
static void draw_runs_heading(const Screen *screen, Area area, Style heading, const char *name,
                              const char *scale, const Run *runs, int n_runs, const Legend *target)
{
    Legend legend[RUNS_MAX + 1];
    int count = 0;
    for (int r = 0; r < n_runs; r++)
        if (runs[r].ghost < 0 && runs[r].shown)
            legend[count++] = run_legend(&runs[r]);
    if (screen_shows_exact(screen))
        legend[count++] = *target;
    count += runs_ghost_legends(runs, n_runs, legend + count);
    heading_draw(area, heading, name, scale, legend, count);
}

/* The places of the tip of an earlier run, of which no more is kept. */
static void add_tips(Plot *plot, const Run *run)
{
    if (run->ghost < 0 || !run->shown)
        return;
    const int x = run_column(run, "crack_x"), y = run_column(run, "crack_y");
    const Notch notch = notch_of(run->settings);
    double last_x = notch.x, last_y = notch.y;
    run_begin(plot, run);
    plot_point(plot, last_x, last_y);
    for (size_t i = 0; i < run->record->count; i++) {
        const double *row = record_row(run->record, i);
        if (row[x] == last_x && row[y] == last_y)
            continue;
        plot_point(plot, last_x = row[x], last_y = row[y]);
    }
}

/* --- the path ------------------------------------------------------------------------------------- */

static void draw_path(const Screen *screen, Area area, Style heading)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const Settings *settings = experiment_settings(screen->experiment);
    const Notch notch = notch_of(experiment_settings(screen->experiment));
    const int under = lines_under(area);
    Area plot_area = area_part(area, 0, 1, area.rect.width, area.rect.height - 1 - under);
    const double left = fmin(notch.x, settings->loads.position) - 0.02;
    const double right = fmax(notch.x, settings->loads.position) + 0.02;
    Axis x = axis_make(fmax(0, left), fmin(settings->geometry.length, right), area.rect.width / 9);
    Axis y = axis_make(0, settings->geometry.height, plot_area.rect.height < 8 ? 3 : 6);
    const Legend target = {LINE_DOTTED, '.', STYLE_EXACT, "30 deg", NULL};
    Run runs[RUNS_MAX];
    const int n_runs = runs_with(runs, runs_of(screen, runs), "crack_x");
    char scale[TICK_TEXT_MAX], x_scale[TICK_TEXT_MAX], name[TICK_TEXT_MAX + 4];
    axis_scale_text(&y, "m", scale);
    axis_scale_text(&x, "m", x_scale);
    snprintf(name, sizeof name, "x, %s", x_scale);
    draw_runs_heading(screen, area, heading, "crack's path, y", scale, runs, n_runs, &target);
    Area inner = axes_draw(plot_area, &x, &y, name, GUTTER);

    Plot plot;
    plot_open(&plot, x, y);
    plot_begin(&plot, STROKE_LINE, LINE_DASHED, STYLE_FAINT, RANK_PREDICTED, '-');
    plot_point(&plot, notch.x, 0);
    plot_point(&plot, notch.x, notch.y);
    plot_begin(&plot, STROKE_LINE, LINE_DASHED, STYLE_FAINT, RANK_PREDICTED, '-');
    plot_point(&plot, settings->loads.position, settings->geometry.height);
    plot_point(&plot, settings->loads.position, settings->geometry.height - settings->bonds.protected_depth);
    if (screen_shows_exact(screen)) {
        const double towards = settings->loads.position < notch.x ? -1 : 1,
                     rise = settings->geometry.height - notch.y;
        plot_begin(&plot, STROKE_LINE, LINE_DOTTED, STYLE_EXACT, RANK_EXACT, '.');
        plot_point(&plot, notch.x, notch.y);
        plot_point(&plot, notch.x + towards * rise * math_tan(CRACK_PAPER_ANGLE * M_PI / 180),
                   settings->geometry.height);
    }
    for (int r = 0; r < n_runs; r++)
        add_tips(&plot, &runs[r]);
    const size_t most = (size_t)ceil(settings->geometry.height / settings->lattice.spacing) + 1;
    double *path = malloc(2 * most * sizeof *path);
    const size_t count = path ? crack_line(sim, path, path + most, most) : 0;
    plot_begin(&plot, STROKE_LINE, LINE_SOLID, STYLE_MEASURED, RANK_MEASURED, '*');
    plot_point(&plot, notch.x, notch.y);
    for (size_t i = 0; i < count; i++)
        plot_point(&plot, path[i], path[most + i]);
    free(path);
    plot_draw(&plot, inner);
    for (int r = 0; r < n_runs; r++) {
        const Record *record = runs[r].record;
        if (runs[r].ghost < 0 || !runs[r].shown || record->count == 0)
            continue;
        const double *row = record_row(record, record->count - 1);
        run_letter(&runs[r], &plot, inner, row[run_column(&runs[r], "crack_x")],
                   row[run_column(&runs[r], "crack_y")]);
    }
    plot_close(&plot);
    CrackFacts facts;
    if (crack_facts(sim, &facts) && facts.measured.begun)
        axes_mark(inner, &x, &y, facts.measured.x, facts.measured.y, 0x25cf, STYLE_CHANGED);
    draw_lines(screen, area, under, "");
}

/* --- curves over time ------------------------------------------------------------------------------ */

typedef struct CrackColumns {
    int x, y, length, dissipated, speed;
    Notch notch;
    double thickness;
} CrackColumns;

/* Degrees between the notch and the line from its end to the tip. */
static double tip_angle(const double *row, const void *context)
{
    const CrackColumns *columns = context;
    const double rise = row[columns->y] - columns->notch.y, aside = row[columns->x] - columns->notch.x;
    return rise > 0 ? math_atan(aside / rise) * 180 / M_PI : NAN;
}

/* What the crack has cost per area, J/m^2. Its first few millimetres say little: bonds break around them. */
static double energy_of_crack(const double *row, const void *context)
{
    const CrackColumns *columns = context;
    const double area = row[columns->length] * columns->thickness;
    return row[columns->length] > 2e-3 ? row[columns->dissipated] / area : NAN;
}

static double tip_speed(const double *row, const void *context)
{
    return row[((const CrackColumns *)context)->speed];
}

static CrackColumns crack_columns(const Run *run)
{
    return (CrackColumns){run_column(run, "crack_x"),       run_column(run, "crack_y"),
                          run_column(run, "crack_length"),  run_column(run, "dissipated"),
                          run_column(run, "crack_speed"),   notch_of(run->settings),
                          run->settings->geometry.thickness};
}

typedef struct CrackCurve {
    const char *name, *unit, *target_name;
    double (*value)(const double *row, const void *context);
    double target;    /* what it should be */
    const char *line; /* below, in the place of the tip; "": nothing */
} CrackCurve;

static void draw_over_time(const Screen *screen, Area area, Style heading, const CrackCurve *curve)
{
    Run runs[RUNS_MAX];
    CrackColumns columns[RUNS_MAX];
    const int n_runs = runs_with(runs, runs_of(screen, runs), "crack_x"), under = lines_under(area);
    Area plot_area = area_part(area, 0, 1, area.rect.width, area.rect.height - 1 - under);
    const int width = plot_area.rect.width - GUTTER - 1, dots = width * plot_dots_across(area.glyphs);
    const int rows = plot_area.rect.height - 1;
    double least = 0, most = curve->target;
    for (int r = 0; r < n_runs; r++) {
        columns[r] = crack_columns(&runs[r]);
        for (size_t i = 0; i < runs[r].record->count; i += time_plot_stride(runs[r].record)) {
            const double value = curve->value(record_row(runs[r].record, i), &columns[r]);
            least = value < least ? value : least;
            most = value > most ? value : most;
        }
    }
    Axis y = axis_around(least, axis_round_up(most * 1.02), rows < 5 ? 3 : 5);
    Axis x = time_plot_axis(screen, width);
    const Legend target = {LINE_DOTTED, '.', STYLE_EXACT, curve->target_name, NULL};
    char scale[TICK_TEXT_MAX], name[32];
    axis_scale_text(&y, curve->unit, scale);
    draw_runs_heading(screen, area, heading, curve->name, scale, runs, n_runs, &target);
    Area inner = axes_draw(plot_area, &x, &y, time_plot_name(screen, &x, name, sizeof name), GUTTER);
    Plot plot;
    plot_open(&plot, x, y);
    if (screen_shows_exact(screen)) {
        plot_begin(&plot, STROKE_LINE, LINE_DOTTED, STYLE_EXACT, RANK_EXACT, '.');
        plot_point(&plot, x.low, curve->target);
        plot_point(&plot, x.high, curve->target);
    }
    for (int r = 0; r < n_runs; r++) {
        if (!runs[r].shown)
            continue;
        run_begin(&plot, &runs[r]);
        time_plot_curve(&plot, &(Curve){runs[r].record, -1, -1, -1, curve->value, &columns[r]}, dots);
    }
    time_plot_breaks(screen, inner, &x);
    time_plot_now(screen, inner, &x);
    plot_draw(&plot, inner);
    for (int r = 0; r < n_runs; r++) {
        const Record *record = runs[r].record;
        if (!runs[r].shown || record->count == 0)
            continue;
        const double *row = record_row(record, record_find(record, x.high));
        run_letter(&runs[r], &plot, inner, row[1], curve->value(row, &columns[r]));
    }
    plot_close(&plot);
    draw_lines(screen, area, under, curve->line);
}

static const char *const pictures[] = {"path", "angle", "speed"};

int crack_variants(const Screen *screen)
{
    return has_crack(screen) ? (int)(sizeof pictures / sizeof *pictures) : 0;
}

const char *crack_variant_word(int variant)
{
    return pictures[variant];
}

void crack_draw(const Screen *screen, Area area, Style heading, int variant)
{
    static const CrackCurve angle = {"chord to tip, deg", "", "30 deg", tip_angle, CRACK_PAPER_ANGLE, ""};
    const double rayleigh = crack_rayleigh_speed(experiment_settings(screen->experiment));
    char line[160] = "";
    CrackFacts facts;
    if (crack_facts(experiment_simulation(screen->experiment), &facts) && facts.measured.fastest > 0)
        beam_lines_tip_speed(&facts.measured, rayleigh, line);
    const CrackCurve speed = {"tip's speed", "m/s", "Rayleigh's c_R", tip_speed, rayleigh, line};
    if (variant == 0)
        draw_path(screen, area, heading);
    else
        draw_over_time(screen, area, heading, variant == 1 ? &angle : &speed);
}

int crack_cost_variants(const Screen *screen)
{
    return has_crack(screen) ? 2 : experiment_fronts(screen->experiment) ? 1 : 0;
}

/* What it costs over time is a column's of the notched beam alone. */
static bool is_over_time(const Screen *screen, int variant)
{
    return has_crack(screen) && variant == 0;
}

const char *crack_cost_variant_word(const Screen *screen, int variant)
{
    return is_over_time(screen, variant) ? "fracture" : "cost";
}

/* --- where the energy went ------------------------------------------------------------------------- */

enum { PARTS = 4 };

/* A bar a part, beside what theory and what a plane through this lattice would cost. */
static void draw_bars(const Screen *screen, Area area, const double parts[PARTS], const CrackPrice *price)
{
    double most = fmax(price->critical_energy, price->cost.plane);
    for (int i = 0; i < PARTS; i++)
        most = fmax(most, parts[i]);
    const Axis x = axis_make(0, PARTS + 1, PARTS + 2);
    const Axis y = axis_make(0, axis_round_up(most * 1.02), area.rect.height < 7 ? 3 : 5);
    Area inner = axes_draw(area, &x, &y, "part", GUTTER);
    Plot plot;
    plot_open(&plot, x, y);
    for (int i = 0; i < PARTS; i++) {
        plot_begin(&plot, STROKE_BAND, LINE_SOLID, STYLE_MEASURED, RANK_BAND, '#');
        for (int side = -1; side <= 1; side += 2) {
            plot_point(&plot, i + 1 + 0.3 * side, 0);
            plot_point(&plot, i + 1 + 0.3 * side, parts[i]);
        }
    }
    for (int i = 0; i < 2 && screen_shows_exact(screen); i++) {
        const double level = i == 0 ? price->critical_energy : price->cost.plane;
        plot_begin(&plot, STROKE_LINE, i == 0 ? LINE_DOTTED : LINE_DASHED,
                   i == 0 ? STYLE_EXACT : STYLE_PREDICTED, i == 0 ? RANK_EXACT : RANK_PREDICTED,
                   i == 0 ? '.' : '-');
        plot_point(&plot, x.low, level);
        plot_point(&plot, x.high, level);
    }
    plot_draw(&plot, inner);
    plot_close(&plot);
}

/* A picture takes no keys while it is drawn, so its work has a bound: so many questions, a quarter of a
 * second or so. */
enum { QUESTIONS_MAX = 256 };

static bool is_quick(double share, void *context)
{
    int *asked = context;
    (void)share;
    return ++*asked <= QUESTIONS_MAX;
}

static void draw_cost(const Screen *screen, Area area, Style heading)
{
    static const Legend targets[] = {{LINE_DOTTED, '.', STYLE_EXACT, "G0", NULL},
                                     {LINE_DASHED, '-', STYLE_PREDICTED, "a plane of this lattice", NULL}};
    CrackPrice price;
    int asked = 0;
    const Patience quickly = {is_quick, &asked};
    const bool known =
        crack_price(experiment_simulation(screen->experiment), experiment_settings(screen->experiment),
                    experiment_fronts(screen->experiment), &quickly, &price);
    heading_draw(area, heading, "where the energy went, J/m^2", "", targets,
                 known && screen_shows_exact(screen) ? 2 : 0);
    if (!known) {
        area_paragraph(
            area, 1, 1, area.rect.width - 2, area.rect.height - 1,
            asked > QUESTIONS_MAX
                ? "So many bonds broke that a picture would take too long: the summary at the end of a run "
                  "tells."
                : "There is no crack as yet, or s0 was changed on the way: then no bond's share is known.",
            STYLE_FAINT);
        return;
    }
    const CrackCost *cost = &price.cost;
    const double parts[PARTS] = {cost->through / cost->area, cost->beside / cost->area,
                                 cost->far / cost->area, cost->beyond / cost->area};
    const int under = area.rect.height < 7 ? 1 : 3;
    draw_bars(screen, area_part(area, 0, 1, area.rect.width, area.rect.height - 1 - under), parts, &price);
    char lines[3][160];
    const bool wide = area.rect.width >= 52;
    snprintf(lines[0], sizeof lines[0],
             wide ? "all %.1f  G0 %.1f, a plane of this lattice %.1f  crack %.1f mm"
                  : "all %.1f  G0 %.1f  plane %.1f  %.1f mm",
             cost->total / cost->area, price.critical_energy, cost->plane,
             cost->area / experiment_settings(screen->experiment)->geometry.thickness / 1e-3);
    snprintf(lines[1], sizeof lines[1],
             wide ? "1 through the path %.1f  2 beside it %.1f" : "1 through path %.1f  2 beside %.1f",
             parts[0], parts[1]);
    snprintf(lines[2], sizeof lines[2],
             wide ? "3 further than a horizon %.1f  4 held beyond s0 %.1f"
                  : "3 far off %.1f  4 held beyond s0 %.1f",
             parts[2], parts[3]);
    for (int i = 0; i < under; i++)
        area_phrases(area, 1, area.rect.height - under + i, area.rect.width - 2, 1, lines[i],
                     i == 0 ? STYLE_NORMAL : STYLE_FAINT);
}

void crack_cost_draw(const Screen *screen, Area area, Style heading, int variant)
{
    const CrackCurve cost = {
        "crack's cost, J/m^2", "", "G0", energy_of_crack, screen_derived(screen, "critical_energy"), ""};
    if (is_over_time(screen, variant))
        draw_over_time(screen, area, heading, &cost);
    else
        draw_cost(screen, area, heading);
}

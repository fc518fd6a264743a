/* SPDX-License-Identifier: GPL-3.0-or-later */
/* More pictures of a beam that breaks: the crack's path with its angle, the angle over time, and what a piece
 * of crack has cost beside the fracture energy that it should cost. */
#include "views/view.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_loads.h"
#include "views/plots/plots.h"
#include "base/math/functions.h"
#include "answers/crack_growth.h"

#include <math.h>
#include <stdlib.h>

static bool has_crack(const Screen *screen)
{
    return experiment_column(screen->experiment, "crack_x") >= 0;
}

/* The present run, what it should be, and the ghosts. */
static void add_keys(const Screen *screen, Picture *picture, const ShownRun *runs, int n_runs,
                     const char *target)
{
    for (int r = 0; r < n_runs; r++)
        if (runs[r].ghost < 0 && runs[r].shown)
            picture_key(picture, runs_key(&runs[r]));
    if (screen_shows_exact(screen))
        picture_name(picture, pen_exact, target);
    runs_add_keys(picture, runs, n_runs);
}

static void describe_path(const Screen *screen, Picture *picture)
{
    const Simulation *sim = screen_simulation(screen);
    const Settings *settings = screen_settings(screen);
    const Cut *notch = settings_notch(settings);
    const double load = settings_loads(settings)->position, height = settings_geometry(settings)->height;
    const double beside = height * 2 / 7;
    double left = fmin(notch->position, load) - beside, right = fmax(notch->position, load) + beside;
    ShownRun runs[RUNS_MAX];
    const int n_runs = runs_with(runs, runs_of(screen, runs), "crack_x");
    for (int r = 0; r < n_runs; r++)
        if (runs[r].ghost >= 0 && runs[r].crack->count > 0) {
            left = fmin(left, settings_notch(runs[r].settings)->position - beside);
            right = fmax(right, settings_notch(runs[r].settings)->position + beside);
        }
    Plot *plot = &picture->plot;
    picture->kind = PICTURE_PATH;
    picture_axes(picture, axis_make(fmax(0, left), fmin(settings_geometry(settings)->length, right)), "x",
                 "m", axis_make(0, height), "crack's path, y", "m");
    add_keys(screen, picture, runs, n_runs, "30 deg");
    const Pen pen = {LINE_DASHED, '-', STYLE_FAINT, RANK_PREDICTED, 0};
    picture_line(picture, notch->position, 0, notch->position, notch->depth, pen);
    picture_line(picture, load, height, load, height - settings_bonds(settings)->protected_depth, pen);
    if (screen_shows_exact(screen)) {
        const double towards = load < notch->position ? -1 : 1, rise = height - notch->depth;
        const double end = notch->position + towards * rise * CRACK_PAPER_SLOPE;
        picture_line(picture, notch->position, notch->depth, end, height, pen_exact);
    }
    for (int r = 0; r < n_runs; r++) {
        /* The path of an earlier run with its notch, as it was last on screen. */
        const CrackLine *crack = runs[r].crack;
        if (runs[r].ghost >= 0 && runs[r].shown && crack->count != 0) {
            for (size_t i = 0; i < crack->count; i++) {
                if (crack->begins[i])
                    runs_begin(picture, &runs[r]);
                plot_point(&picture->plot, crack->x[i], crack->y[i]);
            }
            runs_letter(picture, &runs[r], crack->x[crack->count - 1], crack->y[crack->count - 1],
                        MARK_PLACE);
        }
    }
    const size_t most = (size_t)ceil(height / settings_lattice(settings)->spacing) + 1;
    double *path = malloc(2 * most * sizeof *path);
    const size_t count = path ? crack_line(sim, path, path + most, most) : 0;
    plot_begin(plot, STROKE_LINE, pen_measured);
    plot_point(plot, notch->position, notch->depth);
    for (size_t i = 0; i < count; i++)
        plot_point(plot, path[i], path[most + i]);
    free(path);
    CrackFacts facts;
    if (crack_facts(sim, &facts) && facts.measured.begun)
        picture_mark(picture, facts.measured.x, facts.measured.y, 0x25cf, STYLE_CHANGED);
    beam_note_lines(screen, picture, "");
}

/* --- curves over time ------------------------------------------------------------------------------ */

typedef struct CrackColumns {
    int x, y, length, dissipated, speed;
    const Cut *notch;
    double thickness, horizon;
} CrackColumns;

/* Degrees between the notch and the line from its end to the tip. */
static double tip_angle(const double *row, const void *context)
{
    const CrackColumns *columns = context;
    const double rise = row[columns->y] - columns->notch->depth,
                 aside = row[columns->x] - columns->notch->position;
    return rise > 0 ? math_atan(aside / rise) * 180 / M_PI : NAN;
}

/* What the crack has cost per area, J/m^2. Its first horizon says little: bonds break around it. */
static double energy_of_crack(const double *row, const void *context)
{
    const CrackColumns *columns = context;
    const double area = row[columns->length] * columns->thickness;
    return row[columns->length] > columns->horizon ? row[columns->dissipated] / area : NAN;
}

static double tip_speed(const double *row, const void *context)
{
    return row[((const CrackColumns *)context)->speed];
}

typedef struct CrackCurve {
    const char *name, *unit, *target_name;
    double (*value)(const double *row, const void *context);
    double target;    /* what it should be */
    const char *line; /* below, in the place of the tip; "": nothing */
} CrackCurve;

static void describe_over_time(const Screen *screen, Picture *picture, const CrackCurve *curve)
{
    ShownRun runs[RUNS_MAX];
    CrackColumns columns[RUNS_MAX];
    const int n_runs = runs_with(runs, runs_of(screen, runs), "crack_x");
    double least = 0, most = curve->target;
    for (int r = 0; r < n_runs; r++) {
        columns[r] = (CrackColumns){runs_column(&runs[r], "crack_x"),
                                    runs_column(&runs[r], "crack_y"),
                                    runs_column(&runs[r], "crack_length"),
                                    runs_column(&runs[r], "dissipated"),
                                    runs_column(&runs[r], "crack_speed"),
                                    settings_notch(runs[r].settings),
                                    settings_geometry(runs[r].settings)->thickness,
                                    settings_lattice(runs[r].settings)->horizon};
        for (size_t i = 0; i < runs[r].record->count; i += time_plot_stride(runs[r].record)) {
            const double value = curve->value(record_row(runs[r].record, i), &columns[r]);
            least = value < least ? value : least;
            most = value > most ? value : most;
        }
    }
    time_plot_axes(screen, picture, axis_around(least, axis_round_up(most * 1.02)), curve->name, curve->unit);
    add_keys(screen, picture, runs, n_runs, curve->target_name);
    if (screen_shows_exact(screen))
        picture_level(picture, curve->target, pen_exact, NULL);
    for (int r = 0; r < n_runs; r++) {
        const Record *record = runs[r].record;
        if (!runs[r].shown)
            continue;
        runs_begin(picture, &runs[r]);
        time_plot_curve(picture, &(TimeCurve){record, -1, curve->value, &columns[r]});
        if (record->count == 0)
            continue;
        const double *row = record_row(record, record_find(record, picture->plot.x.high));
        runs_letter(picture, &runs[r], row[1], curve->value(row, &columns[r]), MARK_PLACE);
    }
    beam_note_lines(screen, picture, curve->line);
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

void crack_describe(const Screen *screen, int variant, Picture *picture)
{
    static const CrackCurve angle = {"chord to tip, deg", "", "30 deg", tip_angle, CRACK_PAPER_ANGLE, ""};
    const double rayleigh = crack_rayleigh_speed(screen_settings(screen));
    char line[160] = "";
    CrackFacts facts;
    if (crack_facts(screen_simulation(screen), &facts) && facts.measured.fastest > 0)
        beam_lines_tip_speed(&facts.measured, rayleigh, line);
    const CrackCurve speed = {"tip's speed", "m/s", "Rayleigh's c_R", tip_speed, rayleigh, line};
    if (variant == 0)
        describe_path(screen, picture);
    else
        describe_over_time(screen, picture, variant == 1 ? &angle : &speed);
}

const char *crack_cost_variant_word(const Screen *screen, int variant)
{
    static const char *const words[] = {"fracture", "cost", NULL};
    return words[variant + (has_crack(screen) ? 0 : experiment_fronts(screen->experiment) ? 1 : 2)];
}

/* --- where the energy went ------------------------------------------------------------------------- */

enum { PARTS = 3 };

/* A picture takes no keys while it is drawn, so its work has a bound: about a quarter of a second. */
enum { QUESTIONS_MAX = 256 };

static bool is_quick(double share, void *context)
{
    int *asked = context;
    (void)share;
    return ++*asked <= QUESTIONS_MAX;
}

void crack_cost_describe(const Screen *screen, int variant, Picture *picture)
{
    const CrackCurve over_time = {
        "crack's cost, J/m^2", "", "G0", energy_of_crack, screen_derived(screen, "critical_energy"), ""};
    /* what it costs over time is a column's of the notched beam alone */
    if (has_crack(screen) && variant == 0) {
        describe_over_time(screen, picture, &over_time);
        return;
    }
    CrackPrice price;
    int asked = 0;
    const Cancel quickly = {is_quick, &asked};
    if (!crack_price(screen_simulation(screen), screen_settings(screen),
                     experiment_fronts(screen->experiment), &quickly, &price)) {
        picture_say(
            picture, "where the energy went, J/m^2", "%s",
            asked > QUESTIONS_MAX
                ? "So many bonds broke that a picture would take too long: the summary at the end of a run "
                  "shows where the energy went."
                : "There is no crack yet, or s0 was changed during the run: then no bond's share is known.");
        return;
    }
    const CrackCost *cost = &price.cost;
    const double parts[PARTS] = {cost->through / cost->area, cost->beside / cost->area,
                                 cost->far / cost->area};
    const double thickness = settings_geometry(screen_settings(screen))->thickness;
    /* A bar a part, beside what theory and what a plane through this lattice would cost. */
    double most = fmax(price.critical_energy, price.cost.plane);
    for (int i = 0; i < PARTS; i++)
        most = fmax(most, parts[i]);
    picture->kind = PICTURE_BARS;
    picture_axes(picture, axis_count(PARTS + 1), "part", "", axis_make(0, axis_round_up(most * 1.02)),
                 "where the energy went, J/m^2", "");
    for (int i = 0; i < PARTS; i++)
        picture_box(picture, (double[]){i + 0.7, i + 1.3}, (double[]){0, parts[i]},
                    (Pen){LINE_SOLID, '#', STYLE_MEASURED, RANK_BAND, 0});
    if (screen_shows_exact(screen)) {
        picture_level(picture, price.critical_energy, pen_exact, "G0");
        picture_level(picture, price.cost.plane, pen_predicted, "a plane of this lattice");
    }
    const double whole = cost->total / cost->area, length = cost->area / thickness / 1e-3;
    picture_note(picture, STYLE_NORMAL,
                 "all %.1f  G0 %.1f" LONG_SHORT(", a plane of this lattice",
                                                "  plane") " %.1f  " LONG_SHORT("crack ", "") "%.1f mm",
                 whole, price.critical_energy, cost->plane, length);
    picture_note(picture, STYLE_FAINT,
                 "1 through " LONG_SHORT("the ", "") "path %.1f  2 beside " LONG_SHORT("it ", "") "%.1f",
                 parts[0], parts[1]);
    picture_note(picture, STYLE_FAINT, "3 " LONG_SHORT("further than a horizon", "far off") " %.1f",
                 parts[2]);
}

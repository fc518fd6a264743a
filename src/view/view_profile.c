/* View 1: a field of the particles along the bar, or along the middle of a beam, with the exact curve behind.
 */
#include "view/panes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The fields worth a picture, by method; the first is shown first. */
static const char *const one_dimension[] = {"u", "v", "stress", "density", "strain"};
static const char *const two_dimensions[] = {"uy", "vy", "ux", "vx", "damage"};
enum { PROFILES = 5 };

static const char *const *names_of(const Simulation *sim)
{
    return sim->dimensions == 1 ? one_dimension : two_dimensions;
}

int view_profile_variants(const Screen *screen)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    int count = 0;
    while (count < PROFILES && simulation_find_field(sim, 0, names_of(sim)[count]) >= 0)
        count++;
    return count ? count : 1;
}

/* The particles that are drawn: all of a bar; of a beam those of its middle row. */
typedef struct Row {
    double *x, *value;
    size_t count;
} Row;

static void free_row(Row *row)
{
    free(row->x);
    free(row->value);
}

static bool take_row(const Simulation *sim, int field, Row *row)
{
    const size_t all = sim->counts[0];
    double *y = NULL;
    *row = (Row){.x = malloc((all + 1) * sizeof(double)), .value = malloc((all + 1) * sizeof(double))};
    if (!row->x || !row->value)
        return false;
    sim->method->field(sim, sim->position[0], 0, all, row->x);
    sim->method->field(sim, field, 0, all, row->value);
    row->count = all;
    if (sim->dimensions < 2 || all == 0)
        return true;
    y = malloc(all * sizeof *y);
    if (!y)
        return false;
    sim->method->field(sim, sim->position[1], 0, all, y);
    double least = y[0], most = y[0], middle = y[0];
    for (size_t i = 0; i < all; i++) {
        least = y[i] < least ? y[i] : least;
        most = y[i] > most ? y[i] : most;
    }
    const double centre = (least + most) / 2, slack = 1e-9 * (most - least);
    for (size_t i = 0; i < all; i++)
        if (fabs(y[i] - centre) < fabs(middle - centre) - slack)
            middle = y[i];
    row->count = 0;
    for (size_t i = 0; i < all; i++)
        if (fabs(y[i] - middle) <= slack) {
            row->x[row->count] = row->x[i];
            row->value[row->count++] = row->value[i];
        }
    free(y);
    return true;
}

/* How far the exact answer reaches over the run, so that the axis keeps still; 0: not known. */
static double exact_reach(const Screen *screen, const char *field, const double *x, size_t count, double base)
{
    enum { TIMES = 24, PLACES = 12 };
    const References *refs = experiment_references(screen->experiment);
    const Readout *readout = experiment_readout(screen->experiment);
    double span = experiment_settings(screen->experiment)->end, reach = 0;
    if (readout->exact_known && readout->moving && !readout->drifting)
        span = readout->is_period ? readout->exact : 2 * M_PI / readout->exact;
    for (int i = 0; count > 0 && i <= TIMES; i++)
        for (int k = 0; k <= PLACES; k++) {
            double place = x[(count - 1) * (size_t)k / PLACES];
            double value = references_profile(refs, field, place, span * i / TIMES) - base;
            reach = fabs(value) > reach ? fabs(value) : reach;
        }
    return reach;
}

static Axis value_axis(const Screen *screen, const Simulation *sim, const char *field, const Row *row,
                       int rows)
{
    const int most = rows < 5 ? 3 : rows < 12 ? 5 : 7;
    double reach = 0, base = 0;
    if (strcmp(field, "damage") == 0)
        return axis_make(0, 1, most);
    if (strcmp(field, "density") == 0 && sim->dimensions == 1)
        base = experiment_settings(screen->experiment)->bar.density;
    for (size_t i = 0; i < row->count; i++)
        if (isfinite(row->value[i]) && fabs(row->value[i] - base) > reach)
            reach = fabs(row->value[i] - base);
    double exact = exact_reach(screen, field, row->x, row->count, base);
    reach = exact > reach ? exact : reach;
    if (base != 0) {
        double end = reach > 0 ? axis_round_up(reach * 1.02) : 0.01 * base;
        return axis_make(base - end, base + end, most);
    }
    return axis_symmetric(reach, most);
}

static void draw_exact(const Screen *screen, Plot *plot, const char *field, const Row *row, int dots)
{
    const References *refs = experiment_references(screen->experiment);
    const double time = experiment_time(screen->experiment);
    const double from = row->x[0], to = row->x[row->count - 1], margin = (to - from) / (double)row->count / 2;
    plot_begin(plot, STROKE_LINE, LINE_DOTTED, STYLE_EXACT, RANK_EXACT, '.');
    for (int i = 0; i <= dots; i++) {
        double x = from - margin + (to - from + 2 * margin) * i / dots;
        plot_point(plot, x, references_profile(refs, field, x, time));
    }
}

static void draw_particles(Area inner, const Axis *x, const Axis *y, const Row *row)
{
    for (size_t i = 0; i < row->count; i++)
        area_put(inner, axis_column(x, row->x[i], inner.rect.width),
                 axis_row(y, row->value[i], inner.rect.height), inner.glyphs == GLYPHS_ASCII ? 'o' : 0x25cf,
                 STYLE_MEASURED);
}

void view_profile(const Screen *screen, Area area, Style heading, int variant)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    /* at t = 0 nothing has moved yet: what there is to see is the velocity */
    const bool at_start =
        experiment_step(screen->experiment) == 0 && experiment_stage(screen->experiment) == 0;
    if (variant == 0 && at_start && screen->state != STATE_RUNNING && sim->dimensions == 1)
        variant = 1;
    const char *name = names_of(sim)[variant];
    const int field = simulation_find_field(sim, 0, name);
    Row row;
    if (field < 0 || !take_row(sim, field, &row) || row.count == 0) {
        area_rule(area, 0, "profile", heading);
        if (field >= 0)
            free_row(&row);
        return;
    }
    const Quantity *quantity = &sim->fields[field].quantity;
    const int rows = area.rect.height - 2;
    Axis y = value_axis(screen, sim, name, &row, rows);
    double from = row.x[0], to = row.x[row.count - 1];
    for (size_t i = 0; i < row.count; i++) {
        from = row.x[i] < from ? row.x[i] : from;
        to = row.x[i] > to ? row.x[i] : to;
    }
    const double margin = (to - from) / (double)row.count;
    if (from > 0 && from < 2 * margin)
        from = 0;
    Axis x = axis_make(from, to + margin, area.rect.width / 9);

    const bool exact =
        shows_exact(screen) &&
        isfinite(references_profile(experiment_references(screen->experiment), name, row.x[row.count / 2],
                                    experiment_time(screen->experiment)));
    const Legend legend[] = {
        {LINE_SOLID, '*', STYLE_MEASURED, sim->dimensions == 1 ? "measured" : "measured, middle row", NULL},
        {LINE_DOTTED, '.', STYLE_EXACT, "exact", NULL}};
    char scale[TICK_TEXT_MAX], x_scale[TICK_TEXT_MAX], x_name[TICK_TEXT_MAX + 4];
    axis_scale_text(&y, quantity->unit, scale);
    axis_scale_text(&x, sim->fields[sim->position[0]].quantity.unit, x_scale);
    strcpy(x_name, x_scale[0] ? "x, " : "x");
    strcat(x_name, x_scale);
    draw_heading(area, heading, quantity->label, scale, legend, exact ? 2 : 1);
    Area inner =
        axes_draw(area_part(area, 0, 1, area.rect.width, area.rect.height - 1), &x, &y, x_name, GUTTER);

    Plot plot;
    plot_open(&plot, x, y);
    const int dots = inner.rect.width * plot_dots_across(area.glyphs);
    if (exact && inner.rect.width > 0)
        draw_exact(screen, &plot, name, &row, dots);
    plot_begin(&plot, STROKE_LINE, LINE_SOLID, STYLE_MEASURED, RANK_MEASURED, '*');
    for (size_t i = 0; i < row.count; i++)
        plot_point(&plot, row.x[i], row.value[i]);
    plot_draw(&plot, inner);
    plot_close(&plot);
    /* particles that lie well apart are seen one by one */
    if ((size_t)inner.rect.width >= 2 * row.count)
        draw_particles(inner, &x, &y, &row);
    free_row(&row);
}

/* View 2: what is measured at the probe, over time, with the reference curves, earlier runs and the readout.
 */
#include "view/overlay_plot.h"
#include "view/runs.h"
#include "view/time_plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The columns that can stand in the probe view: what is measured and is no energy. */
static bool is_energy(const char *name)
{
    static const char *const energies[] = {"kinetic", "kinetic_grid", "strain",
                                           "work",    "dissipated",   "total"};
    for (size_t i = 0; i < sizeof energies / sizeof *energies; i++)
        if (strcmp(name, energies[i]) == 0)
            return true;
    return false;
}

/* What a beam that breaks is looked at for comes first; where bonds never break there is nothing to count. */
static int probe_columns(const Screen *screen, int out[COLUMNS_MAX])
{
    int n, count = 0;
    const Column *columns = experiment_columns(screen->experiment, &n);
    const bool cracks = view_crack_variants(screen) > 0;
    const bool breaks = experiment_settings(screen->experiment)->beam.critical_stretch > 0;
    const int broken = find_column(screen, "broken_bonds");
    if (cracks && broken >= 0)
        out[count++] = broken;
    for (int i = 2; i < n; i++)
        if (columns[i].kind == COLUMN_MEASURED && columns[i].of < 0 && !is_energy(columns[i].quantity.name) &&
            (i != broken || (breaks && !cracks)))
            out[count++] = i;
    return count;
}

/* The column of a variant; after the first one stand the pictures of a crack, *picture tells which (-1: it is
 * a column). */
static int probe_column(const Screen *screen, int variant, int *picture)
{
    int columns[COLUMNS_MAX];
    const int count = probe_columns(screen, columns), pictures = view_crack_variants(screen);
    *picture = variant > 0 && variant <= pictures ? variant - 1 : -1;
    if (variant > pictures)
        variant -= pictures;
    return variant < count ? columns[variant] : -1;
}

int view_probe_variants(const Screen *screen)
{
    int columns[COLUMNS_MAX];
    const int count = probe_columns(screen, columns) + view_crack_variants(screen);
    return count > 0 ? count : 1;
}

const char *screen_time_curve(const Screen *screen)
{
    int n, picture;
    const Column *columns = experiment_columns(screen->experiment, &n);
    const int view = screen->focus == PANE_UPPER ? screen->upper : screen->lower;
    const int variants = view_probe_variants(screen);
    const int column = probe_column(screen, screen->variant[2] % variants, &picture);
    return view == 3 ? "total" : column >= 0 ? columns[column].quantity.name : "";
}

/* How a column that answers another is drawn; false: it is not shown. */
static bool legend_of(const Screen *screen, const Column *column, int exact_before, Legend *out)
{
    *out = (Legend){LINE_DOTTED, '.', STYLE_EXACT, column->quantity.label, NULL};
    switch (column->kind) {
    case COLUMN_EXACT:
        if (exact_before > 0)
            *out = (Legend){LINE_DASHED, '-', STYLE_THIRD, column->quantity.label, NULL};
        return shows_exact(screen);
    case COLUMN_PREDICTED:
        *out = (Legend){LINE_DASHED, '-', STYLE_PREDICTED, column->quantity.label, NULL};
        return shows_predicted(screen);
    case COLUMN_MEASURED:
        *out = (Legend){LINE_SOLID, 'o', STYLE_SECOND, column->quantity.label, NULL};
        return true;
    }
    return false;
}

static bool has_envelope(const Screen *screen, const char *name)
{
    return shows_exact(screen) &&
           isfinite(references_envelope(experiment_references(screen->experiment), name, 0));
}

/* How far a beam that grows would swing by its lengthening alone. */
static void add_envelope(const Screen *screen, Plot *plot, const char *name)
{
    enum { PIECES = 60 };
    const References *refs = experiment_references(screen->experiment);
    if (!has_envelope(screen, name))
        return;
    for (int sign = -1; sign <= 1; sign += 2) {
        plot_begin(plot, STROKE_LINE, LINE_DASHED, STYLE_FAINT, RANK_GHOST, ',');
        for (int i = 0; i <= PIECES; i++) {
            const double t = plot->x.low + (plot->x.high - plot->x.low) * i / PIECES;
            plot_point(plot, t, sign * references_envelope(refs, name, t));
        }
    }
}

/* Lines under the plot: what the run is judged by. In a narrow pane the words are shorter; a number is never
 * cut. */
static void frequency_lines(const Screen *screen, int width, char first[160], char second[160])
{
    if (beam_lines(screen, width, first, second))
        return;
    const Readout *readout = experiment_readout(screen->experiment);
    const bool exact = readout->exact_known && shows_exact(screen);
    const bool predicted = readout->predicted_known && shows_predicted(screen);
    if (!readout->moving) {
        snprintf(first, 160, "nothing vibrates: no frequency to measure");
        return;
    }
    const bool narrow = width < 52;
    if (readout->measured_known)
        append(first, 160, narrow ? "w %.4f" : "w measured %.4f", readout->measured);
    else
        append(first, 160, narrow ? "w ..." : "w measuring");
    if (predicted)
        append(first, 160, narrow ? " pred %.4f" : "  predicted %.4f", readout->predicted);
    if (exact)
        append(first, 160, narrow ? " exact %.4f" : "  exact %.4f", readout->exact);
    if (!readout->measured_known || !exact)
        return;
    append(second, 160, "w %+.2f %%  T %+.2f %%", readout->error_frequency, readout->error_period);
    append(second, 160, narrow ? "  %s %.2f T" : "  %s by %.2f periods", readout->late < 0 ? "early" : "late",
           fabs(readout->late));
}

/* The values of every curve at the cursor: with so many digits, and in short words if wanted. */
static void cursor_line(const Screen *screen, int column, int digits, bool brief, char out[160])
{
    int n;
    const Column *columns = experiment_columns(screen->experiment, &n);
    const Record *record = experiment_record(screen->experiment);
    if (record->count == 0)
        return;
    const double *row = record_row(record, record_find(record, screen->cursor_time));
    char time[48], number[NUMBER_TEXT_MAX];
    time_text(screen, row[1], time, sizeof time);
    number_text(row[column], digits, 12, number);
    snprintf(out, 160, brief ? "%s  meas %s" : "%s  measured %s", time, number);
    int exact = 0;
    for (int i = 2; i < n; i++) {
        Legend legend;
        if (columns[i].of != column)
            continue;
        bool shown = legend_of(screen, &columns[i], exact, &legend);
        exact += columns[i].kind == COLUMN_EXACT;
        if (!shown || !isfinite(row[i]))
            continue;
        number_text(row[i], digits, 12, number);
        append(out, 160, "  %s %s", brief ? short_word(legend.name) : legend.name, number);
    }
    const double foreign = overlay_value(screen, columns[column].quantity.name, false, row[1]);
    if (isfinite(foreign)) {
        number_text(foreign, digits, 12, number);
        append(out, 160, "  %s %s", brief ? "file" : screen->overlay->file, number);
    }
}

static void draw_readout(const Screen *screen, Area area, int column)
{
    char first[160], second[160], cursor[160] = "";
    const int width = area.rect.width - 2, rows = area.rect.height;
    frequency_lines(screen, width, first, second);
    if (isfinite(screen->cursor_time)) {
        /* every value is seen: with fewer digits and shorter words, else on both lines */
        static const struct {
            int digits;
            bool brief;
        } forms[] = {{5, false}, {5, true}, {4, true}, {3, true}};
        const size_t n_forms = rows > 1 ? 3 : 4;
        for (size_t i = 0; i < n_forms; i++) {
            cursor_line(screen, column, forms[i].digits, forms[i].brief, cursor);
            if (text_columns(cursor) <= width)
                break;
        }
        if (rows > 1 && text_columns(cursor) > width) {
            cursor_line(screen, column, 5, false, cursor);
            area_phrases(area, 1, 0, width, rows, cursor, STYLE_SELECTED);
            return;
        }
        area_phrases(area, 1, rows - 1, width, 1, cursor, STYLE_SELECTED);
        if (rows > 1)
            area_phrases(area, 1, 0, width, 1, first, STYLE_NORMAL);
        return;
    }
    if (rows == 1 && second[0])
        append(first, sizeof first, "   %s", second);
    area_phrases(area, 1, 0, width, 1, first, STYLE_NORMAL);
    if (rows > 1)
        area_phrases(area, 1, 1, width, 1, second, STYLE_NORMAL);
}

void view_probe(const Screen *screen, Area area, Style heading, int variant)
{
    int n, picture;
    const Column *columns = experiment_columns(screen->experiment, &n);
    const Record *record = experiment_record(screen->experiment);
    const int column = probe_column(screen, variant, &picture);
    if (picture >= 0) {
        view_crack(screen, area, heading, picture);
        return;
    }
    if (column < 0) {
        area_rule(area, 0, "over time", heading);
        return;
    }
    const Quantity *quantity = &columns[column].quantity;
    const Readout *readout = experiment_readout(screen->experiment);
    const bool judged = strcmp(readout->column, quantity->name) == 0 || isfinite(screen->cursor_time) ||
                        experiment_settings(screen->experiment)->problem != PROBLEM_BAR;
    const int under = !judged || area.rect.height < 6                  ? 0
                      : area.rect.width >= 100 || area.rect.height < 8 ? 1
                                                                       : 2;
    Area plot_area = area_part(area, 0, 1, area.rect.width, area.rect.height - 1 - under);
    const int width = plot_area.rect.width - GUTTER - 1, dots = width * plot_dots_across(area.glyphs);

    /* around zero for what swings; what only grows has its own range */
    double reach = time_plot_reach(record, column), least = 0, most = 0, to_come[COLUMNS_MAX];
    Legend legend[6];
    int n_legend = 0, exact = 0, shown[COLUMNS_MAX];
    legend[n_legend++] = (Legend){LINE_SOLID, '*', STYLE_MEASURED, "measured", NULL};
    shown[0] = column;
    bool swings = false, smoothed = false;
    for (int i = 2; i < n && n_legend < 6; i++) {
        if (columns[i].of != column)
            continue;
        if (!swings)
            time_plot_reach_to_come(screen, to_come);
        swings = true;
        if (legend_of(screen, &columns[i], exact, &legend[n_legend]))
            shown[n_legend++] = i;
        smoothed |= columns[i].kind == COLUMN_MEASURED;
        if (columns[i].kind != COLUMN_MEASURED)
            reach = fmax(reach, to_come[i]);
        exact += columns[i].kind == COLUMN_EXACT;
    }
    for (size_t i = 0; i < record->count; i += time_plot_stride(record)) {
        double value = record_row(record, i)[column];
        least = i == 0 || value < least ? value : least;
        most = i == 0 || value > most ? value : most;
    }
    overlay_widen(screen, quantity->name, false, &least, &most);
    reach = fmax(reach, overlay_reach(screen, quantity->name, false));
    if (has_envelope(screen, quantity->name)) {
        const double end = experiment_settings(screen->experiment)->end;
        const References *refs = experiment_references(screen->experiment);
        reach = fmax(reach, fmax(references_envelope(refs, quantity->name, 0),
                                 references_envelope(refs, quantity->name, end)));
    }
    const int rows = plot_area.rect.height - 1, most_ticks = rows < 5 ? 3 : rows < 12 ? 5 : 7;
    Axis y = swings || least < 0 ? axis_symmetric(reach, most_ticks) : axis_around(least, most, most_ticks);
    Axis x = time_plot_axis(screen, width);

    char scale[TICK_TEXT_MAX], name[32];
    axis_scale_text(&y, quantity->unit, scale);
    Run runs[RUNS_MAX];
    const int n_runs = runs_with(runs, runs_of(screen, runs), quantity->name);
    Legend entries[6 + RUNS_MAX + 1];
    int used = 9 + text_columns(quantity->label) + text_columns(scale);
    for (int i = 0; i < n_legend; i++) {
        entries[i] = legend[i];
        used += text_columns(legend[i].name) + 5;
    }
    int n_ghosts = ghost_legends(runs, n_runs, legend_room(area) - used, entries + n_legend);
    shorten_legend(area, quantity->label, scale, entries, n_legend + n_ghosts);
    if (has_envelope(screen, quantity->name))
        entries[n_legend + n_ghosts++] =
            (Legend){LINE_DASHED, ',', STYLE_FAINT, quantity->name[0] == 'u' ? "~L^1/2" : "~L^-3/2", NULL};
    draw_heading(area, heading, quantity->label, scale, entries, n_legend + n_ghosts);
    Area inner = axes_draw(plot_area, &x, &y, time_plot_name(screen, &x, name, sizeof name), GUTTER);
    Plot plot;
    plot_open(&plot, x, y);
    add_ghosts(&plot, runs, n_runs, quantity->name, dots);
    for (int i = 0; i < n_legend; i++) {
        const int rank = columns[shown[i]].kind == COLUMN_EXACT       ? RANK_EXACT
                         : columns[shown[i]].kind == COLUMN_PREDICTED ? RANK_PREDICTED
                         : i > 0                                      ? RANK_SECOND
                         : smoothed                                   ? RANK_BAND /* the raw one lies below */
                                                                      : RANK_MEASURED;
        plot_begin(&plot, STROKE_LINE, legend[i].line, legend[i].style, rank, legend[i].letter);
        time_plot_curve(&plot, &(Curve){.record = record, .column = shown[i], .minus = -1, .plus = -1}, dots);
    }
    overlay_stroke(screen, &plot, quantity->name, false, dots);
    add_envelope(screen, &plot, quantity->name);
    time_plot_breaks(screen, inner, &x);
    time_plot_now(screen, inner, &x);
    plot_draw(&plot, inner);
    overlay_marks(screen, inner, &plot, quantity->name, false);
    draw_run_letters(&plot, inner, runs, n_runs, quantity->name);
    plot_close(&plot);
    if (under > 0)
        draw_readout(screen, area_part(area, 0, area.rect.height - under, area.rect.width, under), column);
}

/* Time plots: the probe (view 2) and the energies (view 3). */
#include "view/panes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* --- the time window ------------------------------------------------------------------------------ */

static double automatic_window(const Screen *screen, double end)
{
    enum { PERIODS = 4 };
    const Readout *readout = experiment_readout(screen->experiment);
    double window = end;
    if (readout->moving && readout->exact_known && readout->exact > 0 && !readout->drifting)
        window = step_round_up(PERIODS * (readout->is_period ? readout->exact : 2 * M_PI / readout->exact));
    return window < end ? window : end;
}

void screen_time_window(const Screen *screen, double *from, double *to)
{
    const double present = experiment_time(screen->experiment);
    const double dt = experiment_simulation(screen->experiment)->dt;
    const double newest = dt * (double)experiment_newest(screen->experiment);
    const double last = dt * (double)experiment_last_step(screen->experiment);
    double window = screen->window > 0 ? screen->window : automatic_window(screen, last);
    if (!(window > 0))
        window = last > 0 ? last : 1;
    /* it shows the newest; rewound far, the present stands in the middle */
    double right = newest - present <= window / 2 ? newest : present + window / 2;
    right = fmax(right, present);
    /* move by whole hundredths, so that curves shift by whole cells and do not shimmer */
    const double grain = window / 100;
    *from = right <= window ? 0 : ceil((right - window) / grain - 1e-9) * grain;
    *to = *from + window;
}

/* The same window, but such that it begins at a whole cell of a plot of so many columns. */
static Axis time_axis(const Screen *screen, int columns)
{
    double from, to;
    screen_time_window(screen, &from, &to);
    const double window = to - from, cell = window / (columns > 0 ? columns : 1);
    if (from > 0)
        from = ceil(from / cell - 1e-9) * cell;
    return axis_make(from, from + window, columns / 9);
}

/* --- curves --------------------------------------------------------------------------------------- */

typedef struct Curve {
    const Record *record;
    int column;
    int minus, plus; /* the value is column - minus + plus; -1: none */
} Curve;

static double curve_sample(const void *context, size_t index, double *x)
{
    const Curve *curve = context;
    const double *row = record_row(curve->record, index);
    double value = row[curve->column];
    if (curve->minus >= 0)
        value -= row[curve->minus];
    if (curve->plus >= 0)
        value += row[curve->plus];
    *x = row[1];
    return value;
}

static void add_curve(Plot *plot, const Curve *curve, int columns)
{
    const Record *record = curve->record;
    if (record->count == 0)
        return;
    size_t first = record_find(record, plot->x.low), end = record_find(record, plot->x.high) + 2;
    plot_curve(plot, curve_sample, curve, first, end < record->count ? end : record->count, columns);
}

/* The largest magnitude of a column in the whole record, so that the axis does not depend on the window. */
static double reach_of(const Record *record, int column)
{
    double reach = 0;
    for (size_t i = 0; i < record->count; i++) {
        double value = fabs(record_row(record, i)[column]);
        if (value > reach && isfinite(value))
            reach = value;
    }
    return reach;
}

/* What a reference will reach: asked for times to come, so that the axis is right from the start. */
static double reach_to_come(const Screen *screen, int column, int n_columns)
{
    enum { TIMES = 96 };
    const Simulation *sim = experiment_simulation(screen->experiment);
    References *refs = experiment_references(screen->experiment);
    const long last = experiment_last_step(screen->experiment);
    double from, to, nothing[COLUMNS_MAX] = {0}, earlier[COLUMNS_MAX] = {0}, row[COLUMNS_MAX], reach = 0;
    screen_time_window(screen, &from, &to);
    long steps = sim->dt > 0 ? (long)((to - from) / sim->dt) : 0;
    steps = steps < last ? steps : last;
    if (n_columns > COLUMNS_MAX)
        return 0;
    for (int i = 0; i <= TIMES; i++) {
        long step = steps / TIMES * i + steps % TIMES * i / TIMES;
        references_row_again(refs, step, sim->dt * (double)step, nothing, earlier, row);
        double value = fabs(row[column]);
        if (isfinite(value) && value > reach)
            reach = value;
    }
    return reach;
}

static void draw_now(const Screen *screen, Area inner, const Axis *x)
{
    const double present = experiment_time(screen->experiment);
    if (experiment_newest(screen->experiment) > experiment_step(screen->experiment)) {
        int column = axis_column(x, present, inner.rect.width);
        for (int y = 0; column >= 0 && y < inner.rect.height; y++)
            area_put(inner, column, y, 0x2502, STYLE_FOCUS);
    }
    if (isfinite(screen->cursor_time)) {
        int column = axis_column(x, screen->cursor_time, inner.rect.width);
        for (int y = 0; column >= 0 && y < inner.rect.height; y++)
            area_put(inner, column, y, 0x2502, STYLE_SELECTED);
    }
}

static const char *time_name(const Screen *screen, const Axis *x, char *out, size_t size)
{
    char scale[TICK_TEXT_MAX];
    const bool seconds = experiment_settings(screen->experiment)->problem != PROBLEM_BAR;
    axis_scale_text(x, seconds ? "s" : "", scale);
    snprintf(out, size, scale[0] ? "t, %s" : "t", scale);
    return out;
}

/* --- view 2 --------------------------------------------------------------------------------------- */

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

static int probe_column(const Screen *screen, int variant, int *count)
{
    int n, found = -1;
    const Column *columns = experiment_columns(screen->experiment, &n);
    *count = 0;
    for (int i = 2; i < n; i++)
        if (columns[i].kind == COLUMN_MEASURED && columns[i].of < 0 && !is_energy(columns[i].quantity.name)) {
            if (*count == variant)
                found = i;
            (*count)++;
        }
    return found;
}

int view_probe_variants(const Screen *screen)
{
    int count;
    probe_column(screen, 0, &count);
    return count > 0 ? count : 1;
}

/* A curve's name where room is short. */
static const char *short_word(const char *name)
{
    return strcmp(name, "predicted") == 0 ? "pred" : strcmp(name, "measured") == 0 ? "meas" : name;
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

static int ghost_column(const Ghost *ghost, const char *name)
{
    for (int i = 0; i < ghost->n_columns; i++)
        if (strcmp(ghost->columns[i].quantity.name, name) == 0)
            return i;
    return -1;
}

static void add_ghosts(const Screen *screen, Plot *plot, const char *name, int dots)
{
    const Ghost *ghosts = experiment_ghosts(screen->experiment);
    for (int i = 0; i < GHOSTS_MAX; i++) {
        int column = ghosts[i].used ? ghost_column(&ghosts[i], name) : -1;
        if (column < 0)
            continue;
        plot_begin(plot, STROKE_LINE, LINE_SOLID, STYLE_FAINT, RANK_GHOST, ':');
        add_curve(plot, &(Curve){&ghosts[i].record, column, -1, -1}, dots);
    }
}

/* A ghost's letter stands at the end of its curve, so that it is told by more than its faint colour. */
static void draw_ghost_letters(const Screen *screen, Area inner, const Plot *plot, const char *name)
{
    const Ghost *ghosts = experiment_ghosts(screen->experiment);
    for (int i = 0; i < GHOSTS_MAX; i++) {
        int column = ghosts[i].used ? ghost_column(&ghosts[i], name) : -1;
        if (column < 0 || ghosts[i].record.count == 0)
            continue;
        const double *row = record_row(&ghosts[i].record, record_find(&ghosts[i].record, plot->x.high));
        int x = axis_column(&plot->x, row[1], inner.rect.width);
        int y = axis_row(&plot->y, row[column], inner.rect.height);
        if (x >= 0 && y >= 0)
            area_put(inner, x, y, (uint32_t)(unsigned char)ghosts[i].letter, STYLE_FAINT);
    }
}

/* Ghosts in the legend, by the letter at the end of their curve. What differs is told where there is room;
 * else the letter has to do. */
static int ghost_legend(const Screen *screen, const char *name, int room, char keys[][4], Legend *out)
{
    const Ghost *ghosts = experiment_ghosts(screen->experiment);
    int count = 0;
    for (int i = 0; i < GHOSTS_MAX; i++) {
        if (!ghosts[i].used || ghost_column(&ghosts[i], name) < 0)
            continue;
        snprintf(keys[count], 4, "%c:", ghosts[i].letter);
        const char *word = text_columns(ghosts[i].legend) + 5 <= room ? ghosts[i].legend : "before";
        room -= text_columns(word) + 5;
        out[count] = (Legend){LINE_SOLID, ':', STYLE_FAINT, word, keys[count]};
        count++;
    }
    return count;
}

/* What a beam that breaks is judged by; false: this one does not. */
static bool crack_line(const Screen *screen, char out[160])
{
    const int broken = find_column(screen, "broken_bonds"), x = find_column(screen, "crack_x");
    const int y = find_column(screen, "crack_y");
    const double *row = experiment_row(screen->experiment);
    if (broken < 0 || x < 0 || y < 0 || !row)
        return false;
    snprintf(out, 160, "broken bonds %.0f", row[broken]);
    if (isfinite(row[x]) && isfinite(row[y]))
        append(out, 160, "  crack's tip at x %.1f, y %.1f mm", 1e3 * row[x], 1e3 * row[y]);
    return true;
}

/* Lines under the plot: what the run is judged by. In a narrow pane the words are shorter; a number is never
 * cut. */
static void frequency_lines(const Screen *screen, int width, char first[160], char second[160])
{
    const Readout *readout = experiment_readout(screen->experiment);
    const bool period = readout->is_period, exact = readout->exact_known && shows_exact(screen);
    const bool predicted = readout->predicted_known && shows_predicted(screen);
    const double unit = period ? 1e-3 : 1;
    const char *symbol = period ? "T" : "w", *tail = period ? " ms" : "";
    first[0] = second[0] = '\0';
    if (!readout->moving) {
        if (!crack_line(screen, first))
            snprintf(first, 160, "nothing vibrates: no %s to measure", period ? "period" : "frequency");
        return;
    }
    const bool narrow = width < 52;
    if (readout->measured_known)
        append(first, 160, narrow ? "%s %.4f" : "%s measured %.4f", symbol, readout->measured / unit);
    else
        append(first, 160, narrow ? "%s ..." : "%s measuring", symbol);
    if (predicted)
        append(first, 160, narrow ? " pred %.4f" : "  predicted %.4f", readout->predicted / unit);
    if (exact)
        append(first, 160, narrow ? " exact %.4f" : "  exact %.4f", readout->exact / unit);
    if (readout->measured_known || predicted || exact)
        append(first, 160, "%s", tail);
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
    int n, count;
    const Column *columns = experiment_columns(screen->experiment, &n);
    const Record *record = experiment_record(screen->experiment);
    const int column = probe_column(screen, variant, &count);
    if (column < 0) {
        area_rule(area, 0, "over time", heading);
        return;
    }
    const Quantity *quantity = &columns[column].quantity;
    const Readout *readout = experiment_readout(screen->experiment);
    const bool judged = strcmp(readout->column, quantity->name) == 0 || isfinite(screen->cursor_time) ||
                        find_column(screen, "crack_x") >= 0;
    const int under = !judged || area.rect.height < 6                  ? 0
                      : area.rect.width >= 100 || area.rect.height < 8 ? 1
                                                                       : 2;
    Area plot_area = area_part(area, 0, 1, area.rect.width, area.rect.height - 1 - under);
    const int width = plot_area.rect.width - GUTTER - 1, dots = width * plot_dots_across(area.glyphs);

    /* around zero for what swings; what only grows has its own range */
    double reach = reach_of(record, column), least = 0, most = 0;
    Legend legend[6];
    int n_legend = 0, exact = 0, shown[COLUMNS_MAX];
    legend[n_legend++] = (Legend){LINE_SOLID, '*', STYLE_MEASURED, "measured", NULL};
    shown[0] = column;
    bool swings = false;
    for (int i = 2; i < n && n_legend < 6; i++) {
        if (columns[i].of != column)
            continue;
        swings = true;
        if (legend_of(screen, &columns[i], exact, &legend[n_legend]))
            shown[n_legend++] = i;
        if (columns[i].kind != COLUMN_MEASURED)
            reach = fmax(reach, reach_to_come(screen, i, n));
        exact += columns[i].kind == COLUMN_EXACT;
    }
    for (size_t i = 0; i < record->count; i++) {
        double value = record_row(record, i)[column];
        least = i == 0 || value < least ? value : least;
        most = i == 0 || value > most ? value : most;
    }
    const int rows = plot_area.rect.height - 1, most_ticks = rows < 5 ? 3 : rows < 12 ? 5 : 7;
    Axis y = swings || least < 0 ? axis_symmetric(reach, most_ticks) : axis_around(least, most, most_ticks);
    Axis x = time_axis(screen, width);

    char scale[TICK_TEXT_MAX], name[32];
    axis_scale_text(&y, quantity->unit, scale);
    Legend entries[6 + GHOSTS_MAX];
    char keys[GHOSTS_MAX][4];
    int used = 9 + text_columns(quantity->label) + text_columns(scale);
    for (int i = 0; i < n_legend; i++) {
        entries[i] = legend[i];
        used += text_columns(legend[i].name) + 5;
    }
    const int n_ghosts =
        ghost_legend(screen, quantity->name, area.rect.width - used, keys, entries + n_legend);
    if (n_ghosts > 0 && used + text_columns(entries[n_legend].name) + 5 > area.rect.width)
        for (int i = 0; i < n_legend; i++)
            entries[i].name = short_word(entries[i].name);
    draw_heading(area, heading, quantity->label, scale, entries, n_legend + n_ghosts);
    Area inner = axes_draw(plot_area, &x, &y, time_name(screen, &x, name, sizeof name), GUTTER);
    Plot plot;
    plot_open(&plot, x, y);
    add_ghosts(screen, &plot, quantity->name, dots);
    for (int i = 0; i < n_legend; i++) {
        const int rank = columns[shown[i]].kind == COLUMN_EXACT       ? RANK_EXACT
                         : columns[shown[i]].kind == COLUMN_PREDICTED ? RANK_PREDICTED
                         : i > 0                                      ? RANK_SECOND
                                                                      : RANK_MEASURED;
        plot_begin(&plot, STROKE_LINE, legend[i].line, legend[i].style, rank, legend[i].letter);
        add_curve(&plot, &(Curve){record, shown[i], -1, -1}, dots);
    }
    draw_now(screen, inner, &x);
    plot_draw(&plot, inner);
    draw_ghost_letters(screen, inner, &plot, quantity->name);
    plot_close(&plot);
    if (under > 0)
        draw_readout(screen, area_part(area, 0, area.rect.height - under, area.rect.width, under), column);
}

/* --- view 3 --------------------------------------------------------------------------------------- */

/* Energies stacked from below: what the grid sees, what it does not, strain, dissipated. */
typedef struct Layer {
    const char *name;
    int column, minus; /* its height: column - minus */
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
    const double *row = record_row(stack->record, index);
    double sum = 0;
    for (int i = 0; i < upto; i++) {
        const Layer *layer = &stack->layers[i];
        sum += row[layer->column] - (layer->minus >= 0 ? row[layer->minus] : 0);
    }
    return sum;
}

static void add_layer(Stack *stack, const char *name, int column, int minus, Style style)
{
    if (column >= 0) {
        stack->layers[stack->count] = (Layer){name, column, minus, style, stack->count};
        stack->count++;
    }
}

static Stack stack_of(const Screen *screen)
{
    Stack stack = {.record = experiment_record(screen->experiment)};
    const int kinetic = find_column(screen, "kinetic"), grid = find_column(screen, "kinetic_grid");
    if (grid >= 0) {
        add_layer(&stack, "grid", grid, -1, STYLE_MEASURED);
        add_layer(&stack, "hidden", kinetic, grid, STYLE_SECOND);
    } else {
        add_layer(&stack, "kinetic", kinetic, -1, STYLE_MEASURED);
    }
    add_layer(&stack, "strain", find_column(screen, "strain"), -1, STYLE_EXACT);
    add_layer(&stack, "dissipated", find_column(screen, "dissipated"), -1, STYLE_THIRD);
    return stack;
}

/* One point a column of dots: the row at its middle. Bands need no extremes: their edges are sums that hardly
 * change within a column when the curve's swing is wider than one; where it is narrower, the mean is told. */
static void add_stack(Plot *plot, const Stack *stack, int dots)
{
    const Record *record = stack->record;
    const double step = (plot->x.high - plot->x.low) / dots;
    for (int layer = 0; layer < stack->count; layer++) {
        plot_begin(plot, STROKE_BAND, LINE_SOLID, stack->layers[layer].style, RANK_BAND, "#+.:"[layer & 3]);
        plot->strokes[plot->n_strokes - 1].fill = stack->layers[layer].fill;
        const double newest = record->count ? record_row(record, record->count - 1)[1] : -1;
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

static void energy_line(const Screen *screen, const Stack *stack, int width, char out[160])
{
    const Record *record = stack->record;
    out[0] = '\0';
    if (record->count == 0)
        return;
    const double *now = experiment_row(screen->experiment), *start = record_row(record, 0);
    const int total = find_column(screen, "total"), kinetic = find_column(screen, "kinetic");
    const int grid = find_column(screen, "kinetic_grid");
    if (!now || total < 0)
        return;
    char number[NUMBER_TEXT_MAX], hidden[48] = "";
    number_text(now[total], 5, 10, number);
    append(out, 160, "total %s", number);
    if (start[total] != 0)
        append(out, 160, " = %.2f %% of the start", 100 * now[total] / start[total]);
    if (grid >= 0 && kinetic >= 0 && now[kinetic] > 0)
        append(hidden, sizeof hidden, ", %.1f %% of kinetic hidden", 100 * (1 - now[grid] / now[kinetic]));
    if (text_columns(out) + text_columns(hidden) <= width)
        append(out, 160, "%s", hidden);
}

void view_energies(const Screen *screen, Area area, Style heading, int variant)
{
    (void)variant;
    const Stack stack = stack_of(screen);
    const Record *record = stack.record;
    const int work = find_column(screen, "work");
    double most = 0, most_work = 0;
    for (size_t i = 0; i < record->count; i++) {
        most = fmax(most, stack_height(&stack, i, stack.count));
        if (work >= 0)
            most_work = fmax(most_work, fabs(record_row(record, i)[work]));
    }
    /* the ripple comes of velocities and stresses half a step apart; velocity Verlet has none */
    const bool staggered = find_column(screen, "kinetic_grid") >= 0;
    const int under = area.rect.height >= 8 && staggered ? 2 : area.rect.height >= 6 ? 1 : 0;
    Area plot_area = area_part(area, 0, 1, area.rect.width, area.rect.height - 1 - under);
    const int width = plot_area.rect.width - GUTTER - 1, dots = width * plot_dots_across(area.glyphs);
    const int rows = plot_area.rect.height - 1;
    Axis y = axis_make(0, axis_round_up(fmax(most, most_work) * 1.02), rows < 4 ? 2 : rows < 12 ? 4 : 6);
    Axis x = time_axis(screen, width);

    /* bands are told apart by how densely they are filled: the legend shows a piece of each */
    static const char *const keys[GLYPHS_COUNT][4] = {
        [GLYPHS_BRAILLE] = {"⣿⣿", "⢕⢕", "⠅⠅", "⠁⠁"},
        [GLYPHS_BLOCK] = {"▓▓", "▒▒", "░░", "··"},
        [GLYPHS_ASCII] = {"##", "++", "..", "::"},
    };
    Legend legend[6];
    int n_legend = 0;
    for (int i = 0; i < stack.count; i++)
        legend[n_legend++] = (Legend){LINE_SOLID, '#', stack.layers[i].style, stack.layers[i].name,
                                      keys[area.glyphs][stack.layers[i].fill & 3]};
    if (most_work > 0)
        legend[n_legend++] = (Legend){LINE_DASHED, '-', STYLE_PREDICTED, "work", NULL};
    char scale[TICK_TEXT_MAX], name[32], line[160];
    axis_scale_text(&y, experiment_settings(screen->experiment)->problem == PROBLEM_BAR ? "" : "J", scale);
    const int named = draw_heading(area, heading, "energy", scale, legend, n_legend);
    Area inner = axes_draw(plot_area, &x, &y, time_name(screen, &x, name, sizeof name), GUTTER);
    Plot plot;
    plot_open(&plot, x, y);
    add_stack(&plot, &stack, dots);
    if (most_work > 0) {
        plot_begin(&plot, STROKE_LINE, LINE_DASHED, STYLE_PREDICTED, RANK_PREDICTED, '-');
        add_curve(&plot, &(Curve){record, work, -1, -1}, dots);
    }
    draw_now(screen, inner, &x);
    plot_draw(&plot, inner);
    plot_close(&plot);

    if (under > 0) {
        energy_line(screen, &stack, area.rect.width - 2, line);
        area_text(area, 1, area.rect.height - under, line, STYLE_NORMAL);
    }
    /* a band without a name says nothing: what the heading has no room for comes before the remark */
    if (under > 1 && named < n_legend)
        draw_legend(area, 1, area.rect.height - 1, legend + named, n_legend - named);
    else if (under > 1)
        area_text(area, 1, area.rect.height - 1,
                  text_columns("the ripple is staggering (v and stress half a step apart), not loss") <
                          area.rect.width - 1
                      ? "the ripple is staggering (v and stress half a step apart), not loss"
                      : "the ripple is staggering, not loss",
                  STYLE_FAINT);
}

/* The table of problems, and what all references share. */
#include "lab/answers/problem.h"
#include "base/text.h"
#include "lab/settings/parameters.h"
#include "lab/answers/problem_rows.h"
#include "theory/frequency.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A run of more would not end in a lifetime, and a double would no longer count its steps exactly. */
#define STEPS_MOST 1e12

#define SI_UNITS .si = true, .unit_of_time = "s", .told_time = 1e-3, .told_time_unit = " ms"

const ProblemFacts problem_facts[PROBLEM_COUNT] = {
    [PROBLEM_BAR] = {.title = "axial vibration of a bar",
                     .usual_method = METHOD_MPM,
                     .si = false,
                     .unit_of_time = "time",
                     .told_time = 1,
                     .told_time_unit = ""},
    [PROBLEM_SUPPORTED_BEAM] = {.title = "vibration of a simply supported beam",
                                .usual_method = METHOD_PD,
                                .beam = BEAM_SIMPLY_SUPPORTED,
                                SI_UNITS},
    [PROBLEM_MOVING_CANTILEVER] = {.title = "vibration of an axially moving cantilever",
                                   .usual_method = METHOD_PD,
                                   .beam = BEAM_MOVING_CANTILEVER,
                                   SI_UNITS},
    [PROBLEM_NOTCHED_BEAM] = {.title = "three-point bending of a beam with an offset notch",
                              .usual_method = METHOD_PD,
                              .beam = BEAM_NOTCHED,
                              SI_UNITS},
};

static const ProblemRow *const rows_of_problems[] = {
    &bar_mpm_row, &bar_pd_row, &supported_pd_row, &moving_pd_row, &notched_pd_row,
};
enum { N_ROWS = sizeof rows_of_problems / sizeof *rows_of_problems };

static const ProblemRow *find_row(Problem problem, MethodKind method)
{
    for (int i = 0; i < N_ROWS; i++)
        if (rows_of_problems[i]->problem == problem && rows_of_problems[i]->method == method)
            return rows_of_problems[i];
    return NULL;
}

bool problem_allows(Problem problem, MethodKind method, Status *status)
{
    return find_row(problem, method) ||
           status_fail(status, STATUS_USAGE, "scenario.method: %s cannot solve problem %s (%s)",
                       method_words[method], problem_words[problem],
                       method_words[problem_facts[problem].usual_method]);
}

static const ProblemRow *need_row(const Settings *settings, Status *status)
{
    problem_allows(settings->problem, settings->method, status);
    return find_row(settings->problem, settings->method);
}

bool problem_check_steps(double end, double dt, Status *status)
{
    char most[NUMBER_TEXT_MAX];
    if (end / dt <= STEPS_MOST)
        return true;
    text_shortest(most, STEPS_MOST);
    return status_fail(status, STATUS_USAGE, "time.end: %g takes %.3g steps of %.3g (at most %s steps)", end,
                       end / dt, dt, most);
}

Simulation *problem_simulate(const Settings *settings, int threads, Status *status)
{
    const ProblemRow *row = need_row(settings, status);
    Simulation *sim = row ? row->simulate(settings, threads, status) : NULL;
    if (!sim || problem_check_steps(settings->time.end, sim->dt, status))
        return sim;
    simulation_destroy(sim);
    return NULL;
}

int problem_derived(const Settings *settings, const Simulation *sim, Derived out[DERIVED_MAX])
{
    const ProblemRow *row = find_row(settings->problem, settings->method);
    return row ? row->derived(settings, sim, out) : 0;
}

bool problem_advice(const Settings *settings, char *advice, size_t size, Status *status)
{
    const ProblemRow *row = need_row(settings, status);
    if (size > 0)
        advice[0] = '\0';
    return row && row->advice(settings, advice, size, status);
}

bool problem_time_step(const Settings *settings, double *dt, Status *status)
{
    Simulation *sim = problem_simulate(settings, 1, status);
    if (!sim)
        return false;
    *dt = sim->dt;
    simulation_destroy(sim);
    return true;
}

void problem_end_at(Settings *settings, double dt, long step)
{
    double times[TIMES_MAX];
    settings->time.end = (double)step * dt;
    if (settings->problem != PROBLEM_BAR)
        settings->time.step = dt;
    while (settings->n_changes > 0 && settings->changes[settings->n_changes - 1].step > step)
        settings->n_changes--;
    int n = times_read(settings->output.at, times, NULL), kept = n;
    while (kept > 0 && lround(times[kept - 1] / dt) > step)
        kept--;
    if (kept == n)
        return;
    size_t length = 0;
    settings->output.at[0] = '\0';
    for (int i = 0; i < kept; i++) {
        char text[NUMBER_TEXT_MAX];
        text_shortest(text, times[i]);
        length += (size_t)snprintf(settings->output.at + length, sizeof settings->output.at - length, "%s%s",
                                   i > 0 ? "," : "", text);
    }
}

long problem_last_step(double dt, double end)
{
    double enough = end * (1 - 1e-9);
    if (!(dt > 0) || !(enough > 0))
        return 0;
    long last = (long)fmin(ceil(enough / dt), 2 * STEPS_MOST);
    /* the quotient may be off by a rounding; the product decides */
    while (last > 0 && (double)(last - 1) * dt >= enough)
        last--;
    while ((double)last * dt < enough && last < (long)STEPS_MOST)
        last++;
    return last;
}

/* --- derived numbers ------------------------------------------------------------------------------ */

void derived_add(Derived out[DERIVED_MAX], int *count, const char *name, const char *label, const char *unit,
                 double value, bool integer)
{
    if (*count < DERIVED_MAX)
        out[(*count)++] = (Derived){name, label, unit, value, integer};
}

/* --- the plan of columns -------------------------------------------------------------------------- */

int plan_find(const References *refs, const char *column)
{
    for (int i = 0; i < refs->n_columns; i++)
        if (strcmp(refs->plan[i].column.quantity.name, column) == 0)
            return i;
    return -1;
}

static void plan_add(References *refs, PlannedColumn planned)
{
    if (refs->n_columns < COLUMNS_MAX)
        refs->plan[refs->n_columns++] = planned;
}

void plan_method(References *refs, const Simulation *sim, const char *series)
{
    int index = simulation_find_series(sim, series);
    if (index >= 0 && plan_find(refs, series) < 0)
        plan_add(refs, (PlannedColumn){{sim->series[index], COLUMN_MEASURED, -1}, index, NULL, false});
}

/* All that is not planned yet. */
static void plan_rest_of_method(References *refs, const Simulation *sim)
{
    for (int i = 0; i < sim->n_series; i++)
        plan_method(refs, sim, sim->series[i].name);
}

void plan_answer(References *refs, const Quantity *quantity, ColumnKind kind, const char *of, Answer *answer)
{
    plan_add(refs, (PlannedColumn){{*quantity, kind, of ? plan_find(refs, of) : -1}, -1, answer, false});
}

void plan_filter(References *refs, const Quantity *quantity, const char *of, Answer *answer)
{
    plan_add(refs, (PlannedColumn){{*quantity, COLUMN_MEASURED, plan_find(refs, of)}, -1, answer, true});
}

static bool prepare_nothing(References *refs, const Settings *settings, const Simulation *sim, Status *status)
{
    (void)refs, (void)settings, (void)sim, (void)status;
    return true;
}

static double know_nothing(const References *refs, const char *field, double x, double time)
{
    (void)refs, (void)field, (void)x, (void)time;
    return NAN;
}

static void read_nothing(const References *refs, const double *rows, size_t n_rows, int n_columns,
                         Readout *out)
{
    (void)refs, (void)rows, (void)n_rows, (void)n_columns, (void)out;
}

static const ProblemRow no_problem = {
    .prepare = prepare_nothing, .profile = know_nothing, .readout = read_nothing};

static References *make_references(const ProblemRow *row, const Settings *settings, const Simulation *sim,
                                   const char *unit_of_time, Status *status)
{
    References *refs = calloc(1, sizeof *refs);
    if (!refs) {
        status_fail(status, STATUS_FAILED, "not enough memory for the reference solutions");
        return NULL;
    }
    static const Quantity step = {"step", "step", "1", "whole time steps done"};
    Quantity time = {"time", "t", unit_of_time, "step * dt"};
    refs->kind = row;
    refs->dt = sim->dt;
    plan_answer(refs, &step, COLUMN_MEASURED, NULL, NULL);
    plan_answer(refs, &time, COLUMN_MEASURED, NULL, NULL);
    if (!row->prepare(refs, settings, sim, status)) {
        references_destroy(refs);
        return NULL;
    }
    plan_rest_of_method(refs, sim);
    return refs;
}

References *problem_references(const Settings *settings, const Simulation *sim, Status *status)
{
    const ProblemRow *row = need_row(settings, status);
    return row ? make_references(row, settings, sim, problem_facts[settings->problem].unit_of_time, status)
               : NULL;
}

References *problem_no_references(const Simulation *sim, Status *status)
{
    return make_references(&no_problem, NULL, sim, "time", status);
}

void references_destroy(References *refs)
{
    if (!refs)
        return;
    if (refs->beam.moving)
        moving_cantilever_free(refs->beam.moving);
    free(refs->beam.window.values);
    rod_modes_free(refs->bar.modes);
    free(refs);
}

int references_columns(const References *refs, Column columns[COLUMNS_MAX])
{
    for (int i = 0; i < refs->n_columns; i++)
        columns[i] = refs->plan[i].column;
    return refs->n_columns;
}

long references_memory(const References *refs)
{
    return refs->beam.window.size;
}

void references_reset(References *refs)
{
    refs->beam.window.filled = refs->beam.window.next = 0;
}

static void remember(Window *window, double value)
{
    if (window->size == 0)
        return;
    window->values[window->next] = value;
    window->next = (window->next + 1) % window->size;
    if (window->filled < window->size)
        window->filled++;
}

static void fill_row(References *refs, long step, double time, const double *method_row,
                     const double *earlier, double *row)
{
    row[0] = (double)step;
    row[1] = time;
    for (int i = 2; i < refs->n_columns; i++) {
        const PlannedColumn *planned = &refs->plan[i];
        if (!planned->answer)
            row[i] = method_row[planned->from_method];
        else if (planned->remembers && earlier)
            row[i] = earlier[i];
        else
            row[i] = planned->answer(refs, step, time, method_row);
    }
}

void references_row(References *refs, long step, double time, const double *method_row, double *row)
{
    if (refs->beam.window.size > 0)
        remember(&refs->beam.window, method_row[refs->beam.v_probe]);
    fill_row(refs, step, time, method_row, NULL, row);
}

void references_row_again(References *refs, long step, double time, const double *method_row,
                          const double *earlier, double *row)
{
    fill_row(refs, step, time, method_row, earlier, row);
}

double references_profile(const References *refs, const char *field, double x, double time)
{
    return refs->kind->profile(refs, field, x, time);
}

static double length_at(const References *refs, double time)
{
    return refs->beam.theory.length + refs->beam.speed * time;
}

double references_envelope(const References *refs, const char *column, double time)
{
    const BeamTheory *beam = &refs->beam.theory;
    if (!refs->beam.moving)
        return NAN;
    const double growth = length_at(refs, time) / beam->length, tip = 2 * fabs(beam->amplitude);
    if (strcmp(column, "u_probe") == 0)
        return tip * sqrt(growth);
    if (strcmp(column, "v_probe") == 0)
        return tip * cantilever_frequency(beam, beam->length) * pow(growth, -1.5);
    return NAN;
}

double references_standing_frequency(const References *refs, double time)
{
    return refs->beam.moving ? cantilever_frequency(&refs->beam.theory, length_at(refs, time)) / (2 * M_PI)
                             : NAN;
}

int references_thickness_lines(const References *refs, double out[THICKNESS_LINES_MAX])
{
    memcpy(out, refs->beam.thickness, sizeof refs->beam.thickness);
    return refs->beam.n_thickness;
}

/* --- the readout ---------------------------------------------------------------------------------- */

bool readout_fit(const double *rows, size_t n_rows, int n_columns, int column, double start,
                 const double *ratios, int n_lines, double *frequency)
{
    enum { SAMPLES_MAX = 4096, PER_PERIOD = 12, PER_PERIOD_OF_EACH = 3 };
    double samples[SAMPLES_MAX];
    size_t width = (size_t)n_columns;
    if (n_rows < 8 || !(start > 0))
        return false;
    double t0 = rows[1], dt = (rows[(n_rows - 1) * width + 1] - t0) / (double)(n_rows - 1);
    double span = dt * (double)(n_rows - 1);
    if (!(dt > 0) || start * span < (n_lines > 1 ? 2 * M_PI * (1 - 1e-3) : M_PI))
        return false;
    double highest = 1;
    for (int i = 0; i < n_lines; i++)
        highest = fmax(highest, ratios[i]);
    /* a long record is sampled as thinly as its period allows; of one that is longer still, the beginning is
     * fitted; each sample costs as much as there are lines */
    const double per_period = fmax(PER_PERIOD, PER_PERIOD_OF_EACH * highest);
    const size_t most = (size_t)(SAMPLES_MAX * 2 / (1 + n_lines));
    double thinnest = fmax(1, floor(2 * M_PI / start / per_period / dt));
    size_t stride = (n_rows + most - 1) / most;
    if ((double)stride > thinnest)
        stride = (size_t)thinnest;
    size_t count = (n_rows - 1) / stride + 1;
    if (count > most)
        count = most;
    for (size_t k = 0; k < count; k++)
        samples[k] = rows[k * stride * width + (size_t)column];
    FrequencyFit fit;
    if (!frequency_fit_lines(samples, count, t0, dt * (double)stride, start, ratios, n_lines, &fit, NULL))
        return false;
    *frequency = fit.frequency;
    return true;
}

/* Root mean square of a column about its mean. */
static double liveliness(const double *rows, size_t n_rows, int n_columns, int column)
{
    double sum = 0, squares = 0;
    for (size_t i = 0; i < n_rows; i++)
        sum += rows[i * (size_t)n_columns + (size_t)column];
    for (size_t i = 0; i < n_rows; i++) {
        const double off = rows[i * (size_t)n_columns + (size_t)column] - sum / (double)n_rows;
        squares += off * off;
    }
    return sqrt(squares / (double)n_rows);
}

/* What has come to rest long before the end swings no more than a little in the last quarter of its record.
 */
static const char *why_unmeasured(const References *refs, const Readout *readout, const double *rows,
                                  size_t n_rows, int n_columns)
{
    const int column = plan_find(refs, readout->column);
    const double turn = readout->predicted_known ? readout->predicted : readout->exact;
    const double period = readout->is_period ? turn : 2 * M_PI / (turn * readout->times);
    const size_t quarter = n_rows / 4;
    if (quarter < 8 || column < 0 || !(readout->time >= period))
        return "too short a run to measure it";
    const double first = liveliness(rows, quarter, n_columns, column);
    const double last = liveliness(rows + (n_rows - quarter) * (size_t)n_columns, quarter, n_columns, column);
    return last < first / 2 ? "the motion has decayed: nothing to measure" : "no steady frequency to measure";
}

void references_readout(const References *refs, const double *rows, size_t n_rows, int n_columns,
                        Readout *readout)
{
    *readout = (Readout){.measured = NAN,
                         .predicted = NAN,
                         .exact = NAN,
                         .error_frequency = NAN,
                         .error_period = NAN,
                         .predicted_error_frequency = NAN,
                         .late = NAN,
                         .by_zeros = NAN,
                         .column = "",
                         .unmeasured = "",
                         .times = 1};
    if (n_rows > 0)
        readout->time = rows[(n_rows - 1) * (size_t)n_columns + 1];
    refs->kind->readout(refs, rows, n_rows, n_columns, readout);
    if (readout->moving && !readout->measured_known)
        readout->unmeasured = why_unmeasured(refs, readout, rows, n_rows, n_columns);
    /* a period is the inverse of a frequency, and so are their errors */
    bool period = readout->is_period;
    if (readout->measured_known && readout->exact_known) {
        double ratio = readout->measured / readout->exact;
        readout->error_frequency = 100 * ((period ? 1 / ratio : ratio) - 1);
        readout->error_period = 100 * ((period ? ratio : 1 / ratio) - 1);
    }
    if (readout->predicted_known && readout->exact_known) {
        double ratio = readout->predicted / readout->exact;
        readout->predicted_error_frequency = 100 * ((period ? 1 / ratio : ratio) - 1);
    }
    readout->late = readout_late(readout, readout->time);
}

double readout_late(const Readout *readout, double time)
{
    if (!readout->measured_known || !readout->exact_known)
        return NAN;
    if (readout->drifting)
        return readout->late;
    if (readout->is_period)
        return time / readout->exact - time / readout->measured;
    return (readout->exact - readout->measured) * time / (2 * M_PI);
}

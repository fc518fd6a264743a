/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a verification reads from a run: see verify.h. Times are those of rows. */
#include "cli/verify/verify.h"

#include "base/math/functions.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "methods/bonds/cracks/crack_cost.h"
#include "methods/bonds/cracks/fronts.h"
#include "theory/frequency.h"
#include "methods/mpm/mpm.h"
#include "scenario/concern_body.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>

/* The value of a column in a row; the column is there. */
static double at(const VerifyRun *run, const double *column, size_t k)
{
    return column[k * (size_t)run->n_columns];
}

static double time_of(const VerifyRun *run, size_t k)
{
    return (double)k * run->spacing;
}

/* --- the readout --------------------------------------------------------------------------------- */

static double derived_of(const VerifyRun *run, const char *name)
{
    return derived_named(run->derived, run->n_derived, name);
}

static Finding finding_of(const VerifyRun *run, const char *name)
{
    Finding findings[FINDINGS_MAX];
    const int count = references_findings(run->refs, run->passing.sim, findings);
    return finding_named(findings, count, name);
}

double quantity_longer_than(VerifyRun *run, const VerifyRow *row)
{
    VerifyRun shorter;
    double percent = NAN;
    if (verify_run_open(&shorter, row->other, run->threads, run->settings.cancel))
        percent = 100 * (run->readout.measured / shorter.readout.measured - 1);
    verify_run_close(&shorter);
    return percent;
}

/* log(e_a/e_b)/log(a/b) of a finding of this run and of another with smaller cells. */
double quantity_finding_order(VerifyRun *run, const VerifyRow *row)
{
    VerifyRun finer;
    double order = NAN;
    if (verify_run_open(&finer, row->other, run->threads, run->settings.cancel))
        order =
            math_log(finding_of(run, row->column).measured / finding_of(&finer, row->column).measured) /
            math_log(settings_mesh(&run->settings)->cell_size / settings_mesh(&finer.settings)->cell_size);
    verify_run_close(&finer);
    return order;
}

/* --- a column of the series ---------------------------------------------------------------------- */

/* By straight lines between rows. */
static double at_time(const VerifyRun *run, const char *name, double t)
{
    const double *column = verify_column(run, name);
    double place = t / run->spacing;
    if (!column || !(place < (double)run->count))
        return NAN;
    size_t k = (size_t)(place + 1e-9);
    double share = fmax(place - (double)k, 0);
    if (share < 1e-9)
        return at(run, column, k);
    return k + 1 < run->count ? at(run, column, k) + share * (at(run, column, k + 1) - at(run, column, k))
                              : NAN;
}

static double mean(const VerifyRun *run, const char *name, double from, double to)
{
    const double *column = verify_column(run, name);
    size_t first, count = verify_rows_between(run, from, to, &first);
    double sum = 0;
    for (size_t k = first; column && k < first + count; k++)
        sum += at(run, column, k);
    return column ? sum / (double)count : NAN;
}

double quantity_amplitude_share(VerifyRun *run, const VerifyRow *row)
{
    const double *column = verify_column(run, row->column), *exact = verify_column(run, row->other);
    size_t first, count = verify_rows_between(run, row->from, row->to, &first);
    double *values = malloc(run->count * sizeof *values);
    FrequencyFit fit = {.amplitude = NAN};
    const Readout *readout = &run->readout;
    double start = readout->is_period ? 2 * M_PI / readout->measured : readout->measured;
    for (size_t k = 0; values && column && k < count; k++)
        values[k] = at(run, column, first + k);
    if (!values || !column || !exact ||
        !frequency_fit(values, count, time_of(run, first), run->spacing, start, &fit, &run->failure))
        fit.amplitude = NAN;
    free(values);
    return exact ? fit.amplitude / fabs(at(run, exact, 0)) : NAN;
}

double quantity_furthest(VerifyRun *run, const VerifyRow *row)
{
    const double *column = verify_column(run, row->column), *other = verify_column(run, row->other);
    double most = 0;
    for (size_t k = 0; column && other && k < run->count; k++)
        most = fmax(most, fabs(at(run, column, k) - at(run, other, k)));
    return column && other ? most : NAN;
}

typedef struct Peaks {
    double first, first_time, largest, largest_time;
} Peaks;

/* The first local maximum of a column, and its largest value. */
static Peaks peaks_of(const VerifyRun *run, const char *name)
{
    Peaks peaks = {NAN, NAN, NAN, NAN};
    const double *column = verify_column(run, name);
    for (size_t k = 1; column && k + 1 < run->count; k++) {
        double before = at(run, column, k - 1), here = at(run, column, k);
        if (isnan(peaks.first) && here > before && here >= at(run, column, k + 1))
            peaks.first = here, peaks.first_time = time_of(run, k);
        if (!(here <= peaks.largest))
            peaks.largest = here, peaks.largest_time = time_of(run, k);
    }
    return peaks;
}

/* The zero of a column nearest to a time; NAN: there is none within a tenth of it. */
static double zero_of(const VerifyRun *run, const char *name, double t)
{
    const double *column = verify_column(run, name);
    double best = NAN;
    for (size_t k = 1; column && k < run->count; k++) {
        double before = at(run, column, k - 1), after = at(run, column, k);
        if ((before < 0) == (after < 0))
            continue;
        double here = run->spacing * ((double)(k - 1) + before / (before - after));
        if (fabs(here - t) < 0.1 * t && !(fabs(here - t) >= fabs(best - t)))
            best = here;
    }
    return best;
}

double quantity_distance(VerifyRun *run, const VerifyRow *row)
{
    const double *column = verify_column(run, row->column), *other = verify_column(run, row->other);
    size_t first, count = verify_rows_between(run, row->from, row->to, &first);
    double left = 0, whole = 0;
    for (size_t k = first; column && other && k < first + count; k++) {
        double difference = at(run, column, k) - at(run, other, k);
        left += difference * difference;
        whole += at(run, other, k) * at(run, other, k);
    }
    return 100 * sqrt(left / whole);
}

static double amplitude_ratio(const VerifyRun *run, const VerifyRow *row, const char *name)
{
    const double *column = verify_column(run, name);
    double before = 0, after = 0;
    for (size_t k = 0; column && k < run->count; k++) {
        double size = fabs(at(run, column, k));
        if (time_of(run, k) <= row->from)
            before = fmax(before, size);
        if (time_of(run, k) >= row->to)
            after = fmax(after, size);
    }
    return after / before;
}

double quantity_line(VerifyRun *run, const VerifyRow *row)
{
    const double *column = verify_column(run, row->column);
    double *values = malloc(run->count * sizeof *values);
    double *lines = malloc((run->count / 2 + 1) * sizeof *lines);
    double bin = 1 / ((double)run->count * run->spacing), frequency = NAN, highest = 0;
    for (size_t k = 0; values && column && k < run->count; k++)
        values[k] = at(run, column, k);
    if (column && values && lines && frequency_spectrum(values, run->count, lines))
        for (size_t k = (size_t)ceil(row->from / bin); k <= run->count / 2 && (double)k * bin <= row->to; k++)
            if (lines[k] > highest)
                highest = lines[k], frequency = (double)k * bin;
    free(values), free(lines);
    return frequency;
}

double quantity_first_above(VerifyRun *run, const VerifyRow *row)
{
    const double *column = verify_column(run, row->column);
    for (size_t k = 0; column && k < run->count; k++)
        if (at(run, column, k) >= row->from)
            return time_of(run, k);
    return NAN;
}

/* --- energy -------------------------------------------------------------------------------------- */

double quantity_energy_left(VerifyRun *run, const VerifyRow *row)
{
    double first = mean(run, "kinetic", 0, row->from) + mean(run, "strain", 0, row->from);
    return (mean(run, "kinetic", row->to, INFINITY) + mean(run, "strain", row->to, INFINITY)) / first;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double quantity_energy_left_of_starts(VerifyRun *run, const VerifyRow *row)
{
    if (!run->starts_known) {
        for (int i = 0; i < VERIFY_STARTS; i++) {
            const double off = 0.01 * (2.0 * i / (VERIFY_STARTS - 1) - 1);
            char scenario[256];
            VerifyRun other;
            snprintf(scenario, sizeof scenario, "%s initial.velocity=%.17g", run->scenario,
                     settings_start(&run->settings)->velocity * (1 + off));
            if (verify_run_open(&other, scenario, run->threads, run->settings.cancel))
                run->starts[run->n_starts++] = quantity_energy_left(&other, row);
            verify_run_close(&other);
        }
        qsort(run->starts, (size_t)run->n_starts, sizeof *run->starts, by_size);
        run->starts_known = true;
    }
    return run->n_starts > VERIFY_STARTS / 2 ? run->starts[(int)(row->part * (run->n_starts - 1))] : NAN;
}

double quantity_energy_off_work(VerifyRun *run, const VerifyRow *row)
{
    const double *total = verify_column(run, "total"), *work = verify_column(run, "work");
    size_t first, count = verify_rows_between(run, row->from, INFINITY, &first);
    double most = total && work ? 0 : NAN;
    for (size_t k = first; total && work && k < first + count; k++)
        most = fmax(most, 100 * fabs(at(run, total, k) / at(run, work, k) - 1));
    return most;
}

double quantity_energy_gained(VerifyRun *run, const VerifyRow *row)
{
    (void)row;
    const double *total = verify_column(run, "total"), *work = verify_column(run, "work");
    const size_t last = run->count - 1;
    return total && work ? 100 * ((at(run, total, last) - at(run, total, 0)) / at(run, work, last) - 1) : NAN;
}

/* --- by bisection ---------------------------------------------------------------------------------- */

double quantity_crossing_velocity(VerifyRun *verified, const VerifyRow *row)
{
    Settings settings = verified->settings;
    Status *status = &verified->failure;
    double low = row->from, high = row->to;
    while (high - low > 1e-4) {
        settings_edit_start(&settings)->velocity = (low + high) / 2;
        Run run;
        const bool sound = run_open(&run, &settings, problem_simulate(&settings, 1, status), status) &&
                           run_start(&run, NULL, status) && run_to_end(&run, NULL, status);
        bool crossed = false;
        for (int i = 0; sound && i < run.sim->n_events; i++)
            crossed = crossed || run.sim->events[i].kind == EVENT_CROSSING;
        run_close(&run);
        if (!sound)
            return NAN;
        *(crossed ? &high : &low) = settings_start(&settings)->velocity;
    }
    return high;
}

/* The Courant number up to which the energy stays what it was, but for a ripple. What grows, grows from the
 * rounding of numbers. */
double quantity_courant_limit(VerifyRun *verified, const VerifyRow *row)
{
    enum { STEPS = 20000 };
    Settings settings = verified->settings;
    Status *status = &verified->failure;
    double low = row->from, high = row->to, cells[COLUMNS_MAX];
    while (high - low > 2e-4 * high) {
        settings_edit_time(&settings)->courant = (low + high) / 2;
        bool bounded = false;
        Run run;
        const bool open = run_open(&run, &settings, problem_simulate(&settings, 1, status), status);
        if (open) {
            const int total = simulation_find_series(run.sim, "total");
            simulation_row(run.sim, cells);
            const double start = cells[total];
            Status stopped; /* a run that blows up may stop by itself: that is the answer, not a failure */
            run.last = STEPS;
            bounded = run_to_end(&run, NULL, &stopped);
            simulation_row(run.sim, cells);
            bounded = bounded && cells[total] < 100 * start;
        }
        run_close(&run);
        if (!open)
            return NAN;
        *(bounded ? &low : &high) = settings_time(&settings)->courant;
    }
    return (low + high) / 2;
}

/* --- beams ----------------------------------------------------------------------------------------- */

double quantity_middle_factor(VerifyRun *run, const VerifyRow *row)
{
    (void)row;
    double factor = NAN;
    size_t columns = (size_t)derived_of(run, "columns"), rows = (size_t)derived_of(run, "rows");
    int field = simulation_find_field(run->passing.sim, 0, "surface_factor");
    if (field >= 0)
        run->passing.sim->method->field(run->passing.sim, field, rows / 2 * columns + columns / 2, 1,
                                        &factor);
    return factor;
}

double quantity_energy_after_steps(VerifyRun *run, const VerifyRow *row)
{
    Status *status = &run->failure;
    double values[COLUMNS_MAX], ratio = NAN;
    Run other;
    const bool open =
        run_open(&other, &run->settings, problem_simulate(&run->settings, run->threads, status), status);
    if (open) /* behind the check that refuses a step beyond the critical one */
        other.sim->dt = row->from * derived_of(run, "dt_crit");
    if (open && run_advance(&other, RUN_STEPS, 1, NULL, status)) {
        const int total = simulation_find_series(other.sim, "total");
        simulation_row(other.sim, values);
        const double start = values[total];
        other.last = 1 + (long)row->to;
        Status stopped = {STATUS_DONE, ""}; /* where it blows up that is the answer, not a failure */
        if (run_to_end(&other, NULL, &stopped)) {
            simulation_row(other.sim, values);
            ratio = values[total] / start;
        } else if (other.failed) {
            ratio = INFINITY;
        }
    }
    run_close(&other);
    return ratio;
}

/* --- the crack ------------------------------------------------------------------------------------- */

static Crack crack_of(const VerifyRun *run)
{
    Crack crack = {.first_break = NAN, .twentieth_break = NAN};
    crack_measure(run->passing.sim, &crack);
    return crack;
}

double quantity_plane_energy(VerifyRun *run, const VerifyRow *row)
{
    (void)row;
    CrackCost cost;
    return crack_cost(run->passing.sim, &(Cancel){0}, &cost) ? cost.plane : NAN;
}

typedef struct Front {
    double branch_x, branch_time, half_angle, fastest, angle;
} Front;

/* The first front, its angle over a height; NAN: there is no front, or it has no such number. */
static Front front_of(const VerifyRun *run, double height)
{
    CrackFronts fronts = {0};
    Front first = {NAN, NAN, NAN, NAN, NAN};
    if (crack_fronts_update(&fronts, run->passing.sim) && fronts.count > 0) {
        const CrackFront *front = &fronts.fronts[0];
        if (front->branched)
            first = (Front){front->branch[0], front->branch_time, front->half_angle, NAN, NAN};
        first.fastest = front->fastest;
        first.angle = fabs(crack_fronts_angle(front, height));
    }
    crack_fronts_free(&fronts);
    return first;
}

/* --- those of one expression ------------------------------------------------------------------------- */

#define QUANTITY(name, value)                                                                                \
    double quantity_##name(VerifyRun *run, const VerifyRow *row)                                             \
    {                                                                                                        \
        (void)row;                                                                                           \
        return value;                                                                                        \
    }
#include "cli/verify/verify_quantity_rows.inc"

/* --- bodies that begin with a velocity field which no scenario has ------------------------------------ */

/* v = C x */
static void affine(const double x[2], const void *context, double v[2], double gradient[4])
{
    const double *const C = context;
    for (int k = 0; k < 4; k++)
        gradient[k] = C[k];
    for (int axis = 0; axis < 2; axis++)
        v[axis] = C[2 * axis] * x[0] + C[2 * axis + 1] * x[1];
}

/* The run's scenario with that field at t = 0, after a step. NULL: the run's failure. */
static Simulation *moved(VerifyRun *run, const double C[4])
{
    Simulation *sim = problem_simulate(&run->settings, run->threads, &run->failure);
    if (!sim)
        return NULL;
    bodies_begin_with(sim, affine, C);
    if (simulation_steps(sim, 1, NULL, NULL, &run->failure))
        return sim;
    simulation_destroy(sim);
    return NULL;
}

static double largest_off(const Simulation *sim, const double right[3])
{
    static const char *const fields[3] = {"sxx", "syy", "sxy"};
    double most = 0;
    for (int k = 0; k < 3; k++)
        for (size_t p = 0; p < sim->counts[0]; p++)
            most = fmax(most, fabs(simulation_named(sim, 0, fields[k], p) - right[k]));
    return most;
}

/* D_11 = E (1 - nu)/((1 + nu)(1 - 2 nu)), D_12 = D_11 nu/(1 - nu), G = E/(2 (1 + nu)): plane strain. */
double quantity_stretch_error(VerifyRun *run, const VerifyRow *row)
{
    static const double C[4] = {.1, .03, -.02, .05};
    const double E = settings_material(&run->settings)->youngs_modulus,
                 nu = settings_material(&run->settings)->poisson;
    const double D11 = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)), D12 = D11 * nu / (1 - nu);
    Simulation *sim = moved(run, C);
    (void)row;
    if (!sim)
        return NAN;
    const double right[3] = {sim->dt * (D11 * C[0] + D12 * C[3]), sim->dt * (D12 * C[0] + D11 * C[3]),
                             sim->dt * E / (2 * (1 + nu)) * (C[1] + C[2])};
    const double off = largest_off(sim, right) / right[0];
    simulation_destroy(sim);
    return off;
}

/* Hypoelastic: 0. Neo-Hookean, x = (w dt)^2: (G x + lambda ln(1 + x))/(1 + x), for I + dt W is not a
 * rotation.
 */
double quantity_turn_error(VerifyRun *run, const VerifyRow *row)
{
    const Material *material = settings_material(&run->settings);
    const double w = row->from, C[4] = {0, -w, w, 0}, E = material->youngs_modulus, nu = material->poisson;
    const double G = E / (2 * (1 + nu)), lambda = 2 * G * nu / (1 - 2 * nu);
    Simulation *sim = moved(run, C);
    if (!sim)
        return NAN;
    const double x = w * w * sim->dt * sim->dt;
    const double normal = material->law == LAW_NEO_HOOKEAN ? (G * x + lambda * math_log(1 + x)) / (1 + x) : 0;
    const double off = largest_off(sim, (const double[3]){normal, normal, 0}) / (G * w * sim->dt);
    simulation_destroy(sim);
    return off;
}

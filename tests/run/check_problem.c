/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Problems with their references: columns, answers, readouts, advice. */
#include "answers/dispersion_curves.h"
#include "scenario/concern_body.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "answers/bar_answers.h"
#include "answers/references.h"
#include "scenario/scenario.h"
#include "run/lab_case.h"
#include "suite.h"
#include "theory/elastic_beam.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

static Simulation *simulate(const Settings *settings)
{
    Status status = {0};
    Simulation *sim = problem_simulate(settings, 1, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    return sim;
}

static References *refer(const Settings *settings, const Simulation *sim)
{
    Status status = {0};
    References *refs = references_create(settings, sim, &status);
    ck_assert_msg(refs != NULL, "%s", status.text);
    return refs;
}

static bool has_column(const Settings *settings, const char *name)
{
    Simulation *sim = simulate(settings);
    References *refs = refer(settings, sim);
    Column columns[COLUMNS_MAX];
    bool found = false;
    int n = references_columns(refs, columns);
    for (int i = 0; i < n; i++) {
        found = found || strcmp(columns[i].quantity.name, name) == 0;
        ck_assert(columns[i].of < i);
        ck_assert(*columns[i].quantity.meaning && *columns[i].quantity.unit);
    }
    references_destroy(refs);
    simulation_destroy(sim);
    return found;
}

START_TEST(a_column_that_a_run_has_not_is_absent)
{
    static const char *const unpredicted[][2] = {
        {"mpm.algorithm", "usl"},   {"mpm.shape", "gimp"},         {"mpm.transfer", "apic"},
        {"mpm.flip_fraction", "0"}, {"bar.supports", "free-free"}, {"load.body_force", "1e-3"},
        {"load.traction", "1e-3"},
    };
    Settings settings = bar_settings(1, 1);
    ck_assert(has_column(&settings, "v_cm_predicted"));
    for (size_t i = 0; i < sizeof unpredicted / sizeof *unpredicted; i++) {
        Settings other = settings;
        set(&other, unpredicted[i][0], unpredicted[i][1]);
        ck_assert_msg(!has_column(&other, "v_cm_predicted"), "%s", unpredicted[i][1]);
        ck_assert(has_column(&other, "v_cm_exact"));
    }
    settings.n_changes = 1;
    settings.changes[0] = (Change){5, {"mpm.algorithm", "musl"}};
    ck_assert(!has_column(&settings, "v_cm_predicted"));
    ck_assert(has_column(&settings, "v_cm_exact"));
    settings.changes[0] = (Change){5, {"load.traction", "0.1"}};
    ck_assert(!has_column(&settings, "v_cm_exact"));
}
END_TEST

START_TEST(answers_stand_beside_what_they_answer)
{
    Settings settings = bar_settings(5, 10);
    strcpy(settings_edit_start(&settings)->overtones, "3:0.03,7:0.01");
    settings_edit_start(&settings)->velocity = 1e-6;
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    ck_assert(experiment_advance(experiment, 1000, NULL));
    BarTheory theory;
    ck_assert(bar_theory_of(&settings, &theory, NULL));
    ck_assert_int_eq(theory.n_modes, 3);
    int n;
    const Column *columns = experiment_columns(experiment, &n);
    ck_assert_str_eq(columns[3].quantity.name, "v_cm_exact");
    ck_assert_int_eq(columns[3].of, 2);
    ck_assert_int_eq(columns[3].kind, COLUMN_EXACT);
    ck_assert_int_eq(columns[4].kind, COLUMN_PREDICTED);
    const Record *record = experiment_record(experiment);
    double worst_exact = 0;
    for (size_t i = 0; i < record->count; i++) {
        const double *row = record_row(record, i);
        worst_exact = fmax(worst_exact, fabs(row[3] - bar_centre_velocity(&theory, row[1])));
    }
    ck_assert_double_eq(worst_exact, 0);
    experiment_destroy(experiment);

    /* with small motion the prediction is the run */
    settings_edit_start(&settings)->overtones[0] = '\0';
    experiment = open_experiment(&settings, 1 << 20);
    ck_assert(experiment_advance(experiment, 1000, NULL));
    record = experiment_record(experiment);
    double worst = 0;
    for (size_t i = 0; i < record->count; i++)
        worst = fmax(worst, fabs(record_row(record, i)[2] - record_row(record, i)[4]));
    ck_assert_double_lt(worst, 1e-6 * 1e-6);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(exact_profiles_are_the_theory)
{
    Settings settings = bar_settings(2, 10);
    set(&settings, "load.body_force", "1e-2");
    Simulation *sim = simulate(&settings);
    References *refs = refer(&settings, sim);
    BarTheory theory;
    ck_assert(bar_theory_of(&settings, &theory, NULL));
    double x = 7.3, t = 1.9, stress = bar_stress(&theory, x, t);
    ck_assert_double_eq(references_profile(refs, "u", x, t), bar_displacement(&theory, x, t));
    ck_assert_double_eq(references_profile(refs, "v", x, t), bar_velocity(&theory, x, t));
    ck_assert_double_eq(references_profile(refs, "stress", x, t), stress);
    ck_assert_double_eq(references_profile(refs, "density", x, t), 1 / (1 + stress / 100));
    ck_assert(isnan(references_profile(refs, "u", 25.1, t)));
    ck_assert(isnan(references_profile(refs, "mass", x, t)));
    references_destroy(refs);
    simulation_destroy(sim);
}
END_TEST

/* The readout of a run to its end. */
static Readout read_out(const Settings *settings)
{
    Experiment *experiment = open_experiment(settings, 1 << 20);
    ck_assert(experiment_advance(experiment, 10000000, NULL));
    Readout readout = *experiment_readout(experiment);
    experiment_destroy(experiment);
    return readout;
}

START_TEST(the_paper_s_errors_are_read)
{
    static const struct {
        int mode;
        double error, predicted;
    } cases[] = {{1, -0.053, -0.053}, {5, -4.239, -4.239}, {10, -17.723, -17.710}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Settings settings = bar_settings(cases[i].mode, 20);
        Readout readout = read_out(&settings);
        ck_assert(readout.moving && readout.measured_known && readout.predicted_known && !readout.is_period);
        ck_assert_str_eq(readout.column, "v_cm");
        ck_assert_double_eq_tol(readout.error_frequency, cases[i].error, 1e-3);
        ck_assert_double_eq_tol(readout.predicted_error_frequency, cases[i].predicted, 1e-3);
        ck_assert_double_eq_tol(readout.error_period, 100 * (readout.exact / readout.measured - 1), 1e-9);
    }
}
END_TEST

START_TEST(the_lag_grows_with_time)
{
    Settings settings = bar_settings(5, 20);
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    ck_assert(!experiment_readout(experiment)->measured_known);
    ck_assert(experiment_advance(experiment, 40, NULL)); /* a third of a period */
    ck_assert(!experiment_readout(experiment)->measured_known);
    ck_assert(isnan(experiment_readout(experiment)->late));
    ck_assert(experiment_advance(experiment, 40, NULL));
    ck_assert(experiment_readout(experiment)->measured_known);
    ck_assert(experiment_advance(experiment, 1230, NULL));
    /* half a period at t = 13.1, at the present time wherever that is */
    ck_assert_double_eq_tol(experiment_readout(experiment)->late, 0.5, 0.002);
    experiment_seek(experiment, 655, 0);
    finish_work(experiment);
    ck_assert_double_eq_tol(experiment_readout(experiment)->late, 0.25, 0.001);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(symmetric_bars_are_measured_on_their_strain)
{
    static const char *const supports[] = {"free-free", "fixed-fixed"};
    for (int i = 0; i < 2; i++) {
        Settings settings = bar_settings(2, 20);
        set(&settings, "bar.supports", supports[i]);
        settings_edit_start(&settings)->velocity = 1e-3;
        Readout readout = read_out(&settings);
        ck_assert(readout.moving && readout.measured_known && readout.predicted_known);
        ck_assert_str_eq(readout.column, "strain");
        ck_assert_double_eq_tol(readout.measured / readout.predicted, 1, 1e-4);
    }
    /* an odd mode between two walls shows in the centre */
    Settings settings = bar_settings(1, 20);
    set(&settings, "bar.supports", "fixed-fixed");
    ck_assert_str_eq(read_out(&settings).column, "v_cm");
}
END_TEST

START_TEST(what_rests_has_no_frequency)
{
    Settings settings = bar_settings(1, 5);
    settings_edit_start(&settings)->velocity = 0;
    ck_assert(!read_out(&settings).moving);
    set(&settings, "bar.supports", "free-free");
    settings_edit_start(&settings)->mode = 0;
    settings_edit_start(&settings)->velocity = 0.1;
    ck_assert(!read_out(&settings).moving);
    /* gravity alone moves a free bar as a whole */
    set(&settings, "load.body_force", "1e-3");
    ck_assert(!read_out(&settings).moving);
    /* an overtone is a vibration */
    strcpy(settings_edit_start(&settings)->overtones, "2:0.01");
    ck_assert(read_out(&settings).moving);
    settings = beam_settings(&problem_notched_beam, 2e-6);
    ck_assert(!read_out(&settings).moving);
}
END_TEST

START_TEST(loads_from_rest_oscillate_with_the_lowest_mode)
{
    static const char *const loads[][2] = {{"load.body_force", "1e-3"}, {"load.traction", "1e-2"}};
    for (int i = 0; i < 2; i++) {
        Settings settings = bar_settings(1, 9);
        settings_edit_start(&settings)->velocity = 0;
        set(&settings, loads[i][0], loads[i][1]);
        /* several lines in a part of a period could be anything: nothing is told before the first whole one
         */
        Readout readout = read_out(&settings);
        ck_assert(readout.moving && readout.exact_known && !readout.measured_known);
        ck_assert_double_eq_tol(readout.exact, 2 * pi / 10, 1e-12); /* period 4 L / c */
        settings_edit_time(&settings)->end = 50;
        readout = read_out(&settings);
        ck_assert(readout.measured_known);
        /* the mesh is 0.053 % off; where the record ends does not matter */
        for (settings_edit_time(&settings)->end = 15; settings_time(&settings)->end < 60;
             settings_edit_time(&settings)->end *= 1.21) {
            readout = read_out(&settings);
            ck_assert_msg(readout.measured_known && fabs(readout.measured / readout.predicted - 1) < 2e-4,
                          "%s until %g: %.9g, not %.9g", loads[i][0], settings_time(&settings)->end,
                          readout.measured, readout.predicted);
        }
    }
}
END_TEST

START_TEST(a_thinned_record_reads_the_same)
{
    Settings settings = bar_settings(5, 400);
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    ck_assert(experiment_advance(experiment, 40000, NULL));
    Readout all = *experiment_readout(experiment);
    const Record *record = experiment_record(experiment);
    Record thin;
    record_open(&thin, record->n_columns, 1, 3000 * (size_t)record->n_columns * sizeof(double));
    for (size_t i = 0; i < record->count; i++)
        ck_assert(record_append(&thin, record_row(record, i)));
    Readout some;
    references_readout(experiment_references(experiment), thin.rows, thin.count - thin.loose_last,
                       thin.n_columns, &some);
    ck_assert(all.measured_known && some.measured_known);
    ck_assert_double_eq_tol(some.measured / all.measured, 1, 1e-4);
    record_close(&thin);
    experiment_destroy(experiment);
}
END_TEST

/* --- beams ---------------------------------------------------------------------------------------- */

START_TEST(a_supported_beam_s_period_is_read)
{
    /* Table 1's coarsest lattice */
    Settings settings;
    settings_default(&settings, &problem_supported_beam);
    set(&settings, "pd.horizon", "5e-3");
    set(&settings, "pd.spacing", "1.2e-3");
    settings_edit_time(&settings)->end = 2e-3;
    Readout readout = read_out(&settings);
    ck_assert(readout.is_period && readout.measured_known);
    ck_assert_double_eq_tol(readout.measured / 0.9927e-3, 1, 2e-3);
    ck_assert_double_eq_tol(readout.exact / 0.86381e-3, 1, 1e-5);
    ck_assert_double_eq_tol(readout.by_zeros / readout.measured, 1, 5e-3);
    /* Timoshenko's beam as it lies on the lattice: 4 rows, 82 spacings between the supports */
    BeamTheory real = {.length = 82 * 1.2e-3,
                       .height = 4 * 1.2e-3,
                       .youngs_modulus = settings_material(&settings)->youngs_modulus,
                       .density = settings_material(&settings)->density,
                       .poisson = 1.0 / 3};
    ck_assert_double_eq_tol(readout.real_size / beam_period_timoshenko(&real), 1, 1e-12);
    /* and its lattice's own period, from an independent solver; the fit finds it again */
    ck_assert(readout.predicted_known);
    ck_assert_double_eq_tol(readout.predicted / 0.99268893477e-3, 1, 1e-8);
    ck_assert_double_eq_tol(readout.measured / readout.predicted, 1, 3e-5);
    ck_assert_double_lt(readout.error_frequency, -12);
}
END_TEST

/* The fastest line of the velocity is where the rows of the lattice ring against each other. */
START_TEST(a_beam_rings_through_its_height)
{
    Settings settings;
    settings_default(&settings, &problem_supported_beam);
    set(&settings, "pd.horizon", "2e-3");
    set(&settings, "pd.spacing", "0.5e-3");
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    ck_assert(experiment_advance(experiment, 4000, NULL));
    int n, column = 0;
    const Column *columns = experiment_columns(experiment, &n);
    while (column < n && strcmp(columns[column].quantity.name, "v_probe") != 0)
        column++;
    const Spectrum *spectrum = experiment_spectrum(experiment, column, SPECTRUM_FAST);
    double lines[THICKNESS_LINES_MAX];
    ck_assert_ptr_nonnull(spectrum);
    ck_assert_int_gt(references_thickness_lines(experiment_references(experiment), lines), 2);
    size_t from = (size_t)(0.6 * lines[0] / spectrum->step), end = (size_t)(1.2 * lines[0] / spectrum->step);
    size_t peak = from;
    for (size_t k = from; k < end; k++)
        if (spectrum->amplitudes[k] > spectrum->amplitudes[peak])
            peak = k;
    ck_assert_double_le(fabs((double)peak * spectrum->step - lines[0]), spectrum->step);
    experiment_destroy(experiment);
}
END_TEST

/* A tip that does what the modal solution does, a little later. */
START_TEST(a_moving_cantilever_is_read_at_its_zeros)
{
    const double shift = 2e-5;
    Settings settings = beam_settings(&problem_moving_cantilever, 5e-3);
    Simulation *sim = simulate(&settings);
    References *refs = refer(&settings, sim);
    BeamTheory theory = {.length = settings_geometry(&settings)->length,
                         .height = settings_geometry(&settings)->height,
                         .youngs_modulus = settings_material(&settings)->youngs_modulus,
                         .density = settings_material(&settings)->density,
                         .amplitude = settings_start(&settings)->amplitude};
    MovingCantilever *tip = moving_cantilever_solve(&theory, settings_motion(&settings)->speed, 5e-3, NULL);
    ck_assert_ptr_nonnull(tip);
    Column columns[COLUMNS_MAX];
    Record record;
    int n = references_columns(refs, columns), u_probe = simulation_find_series(sim, "u_probe");
    record_open(&record, n, 1, 1 << 24);
    double method_row[COLUMNS_MAX] = {0}, row[COLUMNS_MAX];
    long steps = problem_last_step(sim->dt, 5e-3);
    Readout readout;
    for (long k = 0; k <= steps; k++) {
        double t = (double)k * sim->dt;
        method_row[u_probe] = moving_cantilever_tip(tip, t - shift);
        references_row(refs, k, t, method_row, row);
        ck_assert(record_append(&record, row));
        if (k == lround(2e-3 / sim->dt)) { /* one zero so far */
            references_readout(refs, record.rows, record.count, n, &readout);
            ck_assert(readout.moving && !readout.measured_known);
        }
    }
    references_readout(refs, record.rows, record.count, n, &readout);
    ck_assert(readout.is_period && readout.drifting && readout.measured_known && readout.exact_known);
    /* zeros at 2.1919 and 4.2915 ms */
    ck_assert_double_eq_tol(readout.exact, 2 * (4.2915e-3 - 2.1919e-3), 4e-7);
    ck_assert_double_eq_tol(readout.measured / readout.exact, 1, 1e-6);
    ck_assert_double_eq_tol(readout.late, shift / readout.exact, 1e-6);
    ck_assert(isnan(references_envelope(refs, "strain", 0)));
    ck_assert_double_eq_tol(references_envelope(refs, "u_probe", 0), 6e-6, 1e-18);
    /* the oscillations end at their envelopes: within 3 % of them */
    const double spans[][2] = {{1e-3, 1.9e-3}, {2.6e-3, 3.6e-3}};
    for (int i = 0; i < 2; i++) {
        double most = 0, then = 0;
        for (double t = spans[i][0]; t < spans[i][1]; t += 1e-6)
            if (fabs(moving_cantilever_tip(tip, t)) > most)
                most = fabs(moving_cantilever_tip(tip, then = t));
        ck_assert_double_eq_tol(most / references_envelope(refs, "u_probe", then), 1, 0.03);
    }
    double fastest = 0, then = 0;
    for (double t = 1.5e-3; t < 3e-3; t += 1e-6)
        if (fabs(moving_cantilever_tip_velocity(tip, t)) > fastest)
            fastest = fabs(moving_cantilever_tip_velocity(tip, then = t));
    ck_assert_double_eq_tol(fastest / references_envelope(refs, "v_probe", then), 1, 0.03);
    ck_assert_double_eq_tol(references_standing_frequency(refs, 0), 1 / 2.41436e-3, 1e-3);
    record_close(&record);
    moving_cantilever_free(tip);
    references_destroy(refs);
    simulation_destroy(sim);
}
END_TEST

/* A slow motion and a thickness mode of 1 MHz that is four tenths as strong. */
static double slow(double t)
{
    return cos(2 * pi * t / 2.4e-3);
}

START_TEST(the_filter_takes_thickness_modes_away_and_does_not_lag)
{
    Settings settings = beam_settings(&problem_moving_cantilever, 5e-3);
    Simulation *sim = simulate(&settings);
    References *refs = refer(&settings, sim);
    Column columns[COLUMNS_MAX];
    int n = references_columns(refs, columns), filtered = 0, v_probe = simulation_find_series(sim, "v_probe");
    while (filtered < n && strcmp(columns[filtered].quantity.name, "v_filtered") != 0)
        filtered++;
    ck_assert_int_lt(filtered, n);
    ck_assert_int_eq(references_memory(refs), lround(1e-4 / sim->dt) + 1);
    double method_row[COLUMNS_MAX] = {0}, row[COLUMNS_MAX], off = 0, whole = 0, first = 0;
    long steps = problem_last_step(sim->dt, 5e-3);
    for (int round = 0; round < 2; round++) {
        references_reset(refs);
        for (long k = 0; k <= steps; k++) {
            double t = (double)k * sim->dt;
            method_row[v_probe] = slow(t) + 0.4 * sin(2 * pi * 1.1e6 * t);
            references_row(refs, k, t, method_row, row);
            if (k == 1000 && round == 0)
                first = row[filtered];
            if (k == 1000)
                ck_assert_double_eq(first, row[filtered]); /* the reset forgets all */
            if (t < 1e-4 || round > 0)
                continue;
            off += (row[filtered] - slow(t)) * (row[filtered] - slow(t));
            whole += slow(t) * slow(t);
        }
    }
    ck_assert_double_lt(sqrt(off / whole), 0.03);
    references_destroy(refs);
    simulation_destroy(sim);
}
END_TEST

/* --- advice and numbers --------------------------------------------------------------------------- */

START_TEST(courant_numbers_are_warned_of_and_refused)
{
    static const struct {
        const char *algorithm, *courant;
        bool allowed, warned;
        const char *limit;
    } cases[] = {
        {"usf", "1.55", true, false, ""},        {"usf", "1.57", true, true, "1.732"},
        {"musl", "1.73", true, true, "1.732"},   {"usf", "1.74", false, false, "1.732"},
        {"usl", "0.67", true, false, ""},        {"usl", "0.69", true, true, "0.7559"},
        {"usl", "0.76", false, false, "0.7559"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Settings settings = bar_settings(1, 1);
        char advice[200];
        Status status = {0};
        set(&settings, "mpm.algorithm", cases[i].algorithm);
        set(&settings, "time.courant", cases[i].courant);
        ck_assert(problem_advice(&settings, advice, sizeof advice, &status) == cases[i].allowed);
        ck_assert_msg((*advice != 0) == cases[i].warned, "%s %s: %s", cases[i].algorithm, cases[i].courant,
                      advice);
        const char *said = cases[i].allowed ? advice : status.text;
        ck_assert_msg(strstr(said, cases[i].limit) != NULL, "%s", said);
        if (!cases[i].allowed)
            ck_assert_msg(strstr(said, cases[i].courant) != NULL, "%s", said);
    }
    /* cubic splines have a limit of their own */
    Settings settings = bar_settings(1, 1);
    char advice[200];
    set(&settings, "mpm.shape", "bspline3");
    set(&settings, "time.courant", "1.8");
    ck_assert(problem_advice(&settings, advice, sizeof advice, NULL));
    ck_assert_msg(strstr(advice, "1.9413") != NULL, "%s", advice);
    settings = beam_settings(&problem_notched_beam, 1e-6);
    ck_assert(problem_advice(&settings, advice, sizeof advice, NULL));
    ck_assert_str_eq(advice, "");
    set(&settings, "pd.horizon", "6e-3");
    ck_assert(problem_advice(&settings, advice, sizeof advice, NULL));
    ck_assert_msg(strstr(advice, "6 spacings") != NULL, "%s", advice);
}
END_TEST

static double derived_value(const Derived *rows, int n, const char *name)
{
    for (int i = 0; i < n; i++)
        if (strcmp(rows[i].name, name) == 0)
            return rows[i].value;
    ck_abort_msg("no derived %s", name);
    return 0;
}

/* Of the mesh with its ends; how much of a sampled mode the predicted one is, where it is a mixture. */
START_TEST(derived_numbers_know_the_ends)
{
    Derived rows[DERIVED_MAX];
    Settings settings = bar_settings(10, 1);
    set(&settings, "mpm.shape", "bspline2");
    int n = problem_derived(&settings, NULL, rows);
    ck_assert_double_eq_tol(derived_value(rows, n, "omega_predicted"), 8.256228915, 5.1e-10);
    ck_assert_double_eq_tol(derived_value(rows, n, "mode_overlap"), 0.73, 0.01);
    ck_assert_double_eq_tol(derived_value(rows, n, "largest_courant"), 2.0510, 5.1e-5);
    settings = bar_settings(2, 1);
    set(&settings, "mpm.shape", "bspline2");
    set(&settings, "bar.length", "13");
    set(&settings, "bar.supports", "fixed-fixed");
    n = problem_derived(&settings, NULL, rows);
    ck_assert_double_eq_tol(derived_value(rows, n, "omega_predicted"), 4.5734, 5.1e-5);
    set(&settings, "mesh.padding", "0");
    set(&settings, "bar.supports", "free-free");
    n = problem_derived(&settings, NULL, rows);
    ck_assert_double_lt(derived_value(rows, n, "largest_courant"), 1.6); /* no room beyond the ends */
}
END_TEST

START_TEST(derived_numbers_follow_from_the_settings)
{
    Derived rows[DERIVED_MAX];
    for (int p = 0; problems[p]; p++) {
        const Problem *problem = problems[p];
        const bool beam = problem->concerns & CONCERN_BEAM,
                   lattice = beam || problem->concerns & CONCERN_PLATE;
        Settings settings = beam ? beam_settings(problem, 1e-6) : bar_settings(5, 1);
        if (!beam && problem != &problem_bar)
            settings_default(&settings, problem);
        if (problem->concerns & CONCERN_BODIES) {
            Status status = {0};
            ck_assert_msg(settings_set(&settings, "bodies.one", "disc 0.5 0.5 0.3", &status), "%s",
                          status.text);
        }
        Simulation *sim = simulate(&settings);
        int n = problem_derived(&settings, sim, rows), without = 0;
        ck_assert_int_ge(n, 4);
        ck_assert_int_lt(n, DERIVED_MAX);
        for (int i = 0; i < n; i++)
            for (int j = 0; j < i; j++)
                ck_assert_str_ne(rows[i].name, rows[j].name);
        ck_assert_double_eq(derived_value(rows, n, "dt"), sim->dt);
        if (problem == &problem_bar) {
            ck_assert_double_eq_tol(derived_value(rows, n, "omega"), 5.6548667765, 1e-9);
            ck_assert_double_eq_tol(derived_value(rows, n, "omega_predicted"), 5.4151680880, 1e-9);
            ck_assert_double_eq(derived_value(rows, n, "particles"), 50);
            ck_assert_double_eq_tol(derived_value(rows, n, "largest_courant"), sqrt(3), 1e-9);
        } else if (lattice) {
            ck_assert_double_gt(derived_value(rows, n, "dt_crit"), sim->dt);
        }
        /* what needs no simulation is there without one */
        without = problem_derived(&settings, NULL, rows);
        ck_assert(lattice || problem->concerns & CONCERN_BODIES ? without > 0 && without < n : without == n);
        simulation_destroy(sim);
    }
    Settings settings;
    settings_default(&settings, &problem_notched_beam);
    int n = problem_derived(&settings, NULL, rows);
    ck_assert_double_eq_tol(derived_value(rows, n, "critical_energy"), 35.68, 0.01);
}
END_TEST

START_TEST(the_last_step_is_the_first_to_reach_the_end)
{
    unsigned long seed = 5;
    for (int i = 0; i < 20000; i++) {
        double dt = 1e-9 * (double)(1 + draw(&seed, 1000000)), end = dt * (double)draw(&seed, 5000);
        if (i % 3 == 0)
            end += dt * 1e-6 * (double)draw(&seed, 1000000);
        long last = problem_last_step(dt, end), bad = 0;
        bad += !((double)last * dt >= end * (1 - 1e-9));
        bad += last > 0 && (double)(last - 1) * dt >= end * (1 - 1e-9);
        /* and its time, taken for the end, leads to it again */
        bad += problem_last_step(dt, (double)last * dt) != last;
        if (bad)
            ck_abort_msg("dt %.17g, end %.17g: last step %ld", dt, end, last);
    }
    ck_assert_int_eq(problem_last_step(0.01, 100), 10000);
}
END_TEST

START_TEST(a_run_cut_short_leaves_out_what_comes_later)
{
    Settings settings = bar_settings(1, 10);
    strcpy(settings_edit_output(&settings)->at, "0,0.5,2,7");
    settings.n_changes = 2;
    settings.changes[0] = (Change){100, {"mpm.algorithm", "usl"}};
    settings.changes[1] = (Change){300, {"mpm.algorithm", "usf"}};
    problem_end_at(&settings, 0.01, 200);
    ck_assert_double_eq(settings_time(&settings)->end, 2);
    ck_assert_str_eq(settings_output(&settings)->at, "0,0.5,2");
    ck_assert_int_eq(settings.n_changes, 1);
    Settings beam = beam_settings(&problem_supported_beam, 1e-3);
    problem_end_at(&beam, 1.5e-7, 10);
    ck_assert_double_eq(settings_time(&beam)->step, 1.5e-7);
}
END_TEST

/* Errors of the frequency in per cent, modes 5 and 10 of the usual bar. */
START_TEST(other_ways_on_the_same_mesh)
{
    static const struct {
        const char *name;
        double fifth, tenth;
    } known[] = {{"lumped", -4.2388, -17.7099},
                 {"mu*", -.0361, -.7647},
                 {"consistent", 1.6996, 7.8753},
                 {"FMPM(2)", 1.3946, .411},
                 {"FMPM(4)", 1.6987, 7.612}};
    Settings settings = bar_settings(5, 0.1);
    ModeOnMesh mode;
    double frequency;
    for (int i = 0; i < 5; i++)
        for (int number = 5; number <= 10; number += 5) {
            ck_assert(dispersion_mode(&settings, number, &mode));
            ck_assert_str_eq(dispersion_other_way(&settings, i, number, &frequency), known[i].name);
            ck_assert_double_eq_tol(100 * (frequency / mode.exact - 1),
                                    number == 5 ? known[i].fifth : known[i].tenth, 5.1e-4);
        }
    ck_assert_ptr_null(dispersion_other_way(&settings, 5, 5, &frequency));
    settings_edit_time(&settings)->courant = 0.8;
    dispersion_other_way(&settings, 1, 5, &frequency);
    ck_assert_double_eq_tol(100 * (frequency / (10 * 4.5 * M_PI / 25) - 1), -.0455, 5.1e-5);
    settings_edit_transfer(&settings)->shape = MPM_BSPLINE3; /* whose share is below what is allowed */
    settings_edit_time(&settings)->courant = 0.1;
    ck_assert_str_eq(dispersion_other_way(&settings, 1, 5, &frequency), "no mu*");
    ck_assert_ptr_null(dispersion_other_way(&settings, 0, 26, &frequency));
    /* between equals nothing changes; else no wave has one length */
    settings_put(&settings, parameter_find("bar2.joint"), 10);
    ck_assert_ptr_nonnull(dispersion_other_way(&settings, 0, 5, &frequency));
    settings_put(&settings, parameter_find("bar2.youngs_modulus"), 400);
    ck_assert_ptr_null(dispersion_other_way(&settings, 0, 5, &frequency));
}
END_TEST

/* Between fixed ends a wave of the endless lattice is a mode of the bar's own step. */
START_TEST(a_wave_is_a_mode_between_fixed_ends)
{
    const int number = 9;
    Settings settings = bar_settings(number, 0.1);
    set(&settings, "scenario.method", "pd");
    set(&settings, "bar.supports", "fixed-fixed");
    set(&settings, "time.courant", "0.9");
    Derived derived[DERIVED_MAX];
    ModeOnMesh mode;
    const int n = problem_derived(&settings, NULL, derived);
    double by_step = NAN;
    for (int i = 0; i < n; i++)
        if (strcmp(derived[i].name, "omega_predicted") == 0)
            by_step = derived[i].value;
    ck_assert(dispersion_mode(&settings, number, &mode));
    ck_assert_double_eq_tol(mode.predicted / by_step, 1, 1e-12);
    ck_assert_double_gt(fabs(mode.factors[1].value - 1), 0.04);
}
END_TEST

/* --- two materials -------------------------------------------------------------------------------- */

static Settings loaded(const char *scenario, const char *const *pairs)
{
    Settings settings;
    Status status = {0};
    ck_assert_msg(scenario_load(scenario, &settings, &status), "%s", status.text);
    for (; *pairs; pairs += 2)
        set(&settings, pairs[0], pairs[1]);
    return settings;
}

/* Met at 4, half as long as 2.8; the left part takes 10, the right one 5. A fixed end turns the velocity on
 * its way, a free one lets it be told until it is back. */
START_TEST(an_echo_is_told_while_it_is_in_one_piece)
{
    static const struct {
        const char *supports;
        double time;
        const char *told;
    } cases[] = {
        {"free-free", 6.7, "sent back R not yet  let on T not yet"},
        {"free-free", 6.85, "sent back R -0.333"},
        {"free-free", 11, "sent back R -0.3333  let on T 0.6667"},
        {"free-free", 11.3, "sent back R no longer  let on T no longer"},
        {"fixed-free", 11, "sent back R -0.3333  let on T 0.6667"},
        {"fixed-free", 11.3, "sent back R no longer  let on T no longer"},
        {"fixed-fixed", 5, "sent back R not yet  let on T never in one piece"},
        {"fixed-fixed", 9.5, "sent back R -0.3333  let on T no longer"},
        {"fixed-fixed", 11, "sent back R -0.3333  let on T no longer"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *const pairs[] = {"bar.supports", cases[i].supports, NULL};
        Settings settings = loaded("two-materials", pairs);
        settings_edit_time(&settings)->end = cases[i].time;
        Experiment *experiment = open_experiment(&settings, 1 << 20);
        ck_assert(experiment_advance(experiment, 1000000, NULL));
        Finding findings[FINDINGS_MAX];
        char told[200];
        const int n = references_findings(experiment_references(experiment),
                                          experiment_simulation(experiment), findings);
        ck_assert_int_eq(n, 3);
        findings_text(findings, 2, false, told, sizeof told);
        ck_assert_msg(strstr(told, cases[i].told) == told, "%s, %g: %s", cases[i].supports, cases[i].time,
                      told);
        experiment_destroy(experiment);
    }
    /* nor of one that goes both ways at once */
    static const char *const both[] = {"initial.pulse_way", "both", NULL};
    Settings hit = loaded("two-materials", both);
    settings_edit_time(&hit)->end = 9;
    Experiment *of_hit = open_experiment(&hit, 1 << 20);
    ck_assert(experiment_advance(of_hit, 1000000, NULL));
    Finding of_both[FINDINGS_MAX];
    ck_assert_int_eq(
        references_findings(experiment_references(of_hit), experiment_simulation(of_hit), of_both), 3);
    ck_assert_str_eq(of_both[0].missing, "never in one piece");
    ck_assert_double_lt(of_both[2].measured, 0.2); /* distance from the exact motion */
    experiment_destroy(of_hit);
    /* where a mode oscillates besides, nothing of the pulse alone can be told */
    static const char *const oscillating[] = {"initial.velocity", "1e-4", NULL};
    Settings settings = loaded("two-materials", oscillating);
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    Finding findings[FINDINGS_MAX];
    ck_assert_int_eq(
        references_findings(experiment_references(experiment), experiment_simulation(experiment), findings),
        1);
    experiment_destroy(experiment);
}
END_TEST

/* A wave to the right is pressed where it moves, one to the left is drawn, and a hit is neither. */
START_TEST(a_pulse_goes_where_it_is_sent)
{
    static const struct {
        const char *way;
        double stress; /* over sqrt(E rho) v; all particles of a cell have the cell's mean */
    } cases[] = {{"right", -1}, {"left", 1}, {"both", 0}};
    const char *const sent[] = {"initial.pulse_way", cases[_i].way, NULL};
    Settings settings = loaded("pulse", sent);
    Pulse pulse;
    ck_assert(pulse_read(settings_start(&settings)->pulse, &pulse, NULL));
    const Material *material = settings_material(&settings);
    const double impedance = sqrt(material->youngs_modulus * material->density);
    Simulation *sim = problem_simulate(&settings, 1, NULL);
    ck_assert_ptr_nonnull(sim);
    const size_t middle =
        (size_t)(pulse.centre / settings_geometry(&settings)->length * (double)sim->counts[0]);
    const double v = simulation_value(sim, simulation_find_field(sim, 0, "v"), middle);
    const double stress = simulation_value(sim, simulation_find_field(sim, 0, "stress"), middle);
    ck_assert_double_gt(v, 0.9 * pulse.velocity);
    ck_assert_double_eq_tol(stress, cases[_i].stress * impedance * v, 0.05 * impedance * v);
    simulation_destroy(sim);
}
END_TEST

/* Particles beside the middle of their shares are in every answer; boxes that touch the edge of their cell
 * take the prediction out, and with it the largest step. */
START_TEST(an_offset_is_known)
{
    static const char *const beside[] = {"initial.offset", "-0.4", "initial.velocity", "1e-4", NULL};
    Settings settings = loaded("mode5", beside);
    for (int r = 0; r < REFERENCES; r++)
        ck_assert_ptr_null(answer_invalid_because(&settings, (Reference)r));
    const Readout readout = read_out(&settings);
    ck_assert_double_eq_tol(readout.measured, readout.predicted, 1e-3);
    ck_assert_double_eq_tol(readout.exact, 5.654866776461628, 1e-12);
    ck_assert_double_gt(readout.measured - 5.415, 0.05); /* as it is in the middle */
    /* v_cm is a mixture: one dying oscillation laid through it tells nothing (89.6 % of what keeps 98.1 %) */
    set(&settings, "mpm.algorithm", "usl");
    const Readout dying = read_out(&settings);
    ck_assert(isnan(dying.kept_measured) && dying.kept_predicted < 0.99);
    set(&settings, "initial.offset", "0");
    const Readout middle = read_out(&settings);
    ck_assert_double_eq_tol(middle.kept_measured, middle.kept_predicted, 1e-3);
    set(&settings, "initial.offset", "-0.4");
    set(&settings, "mpm.algorithm", "usf");
    set(&settings, "mpm.shape", "gimp");
    for (int r = 0; r < REFERENCES; r++)
        ck_assert_ptr_null(answer_invalid_because(&settings, (Reference)r));
    const Readout boxes = read_out(&settings);
    ck_assert(boxes.predicted_known && fabs(boxes.predicted - readout.predicted) > 1e-3);
    ck_assert_double_eq_tol(boxes.measured, boxes.predicted, 0.02);
    ck_assert(!settings_set(&settings, "mpm.mass_blend", "auto", NULL) || !settings_check(&settings, NULL));
    ck_assert(!settings_set(&settings, "initial.offset", "0.5", NULL));
}
END_TEST

/* With the exact shape the run shows the frequency that is predicted, with the sine a mixture about it, which
 * is told; v_cm has its exact answer with both, and with a load neither. */
START_TEST(two_materials_have_a_frequency)
{
    static const char *const two[] = {
        "mesh.cell_size",   "0.5",  "bar2.joint", "12.5", "bar2.youngs_modulus", "400",
        "initial.velocity", "1e-4", NULL};
    Settings settings = loaded("mode5", two);
    settings_edit_time(&settings)->end = 10;
    Readout sine = read_out(&settings);
    set(&settings, "initial.shape", "exact");
    Readout exact = read_out(&settings);
    ck_assert_double_eq_tol(exact.exact, 7.53982236861551, 1e-13);
    ck_assert(exact.predicted_known && exact.measured_known && sine.measured_known);
    ck_assert_double_eq_tol(exact.measured, exact.predicted, 1e-3); /* of 10 units; closer: check_step */
    ck_assert_double_eq_tol(sine.measured, exact.predicted, 5e-3);  /* .2 without its other lines */
    ck_assert(exact.overlap > READOUT_PURE && sine.overlap < 0.3 && sine.predicted == exact.predicted);
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    ck_assert_int_ge(column_of(experiment, "v_cm_exact"), 0);
    const int v_cm = column_of(experiment, "v_cm"), predicted = column_of(experiment, "v_cm_predicted");
    ck_assert_int_ge(predicted, 0);
    ck_assert(experiment_advance(experiment, 1000, NULL));
    const Record *record = experiment_record(experiment);
    double worst = 0;
    for (size_t i = 0; i < record->count; i++)
        worst = fmax(worst, fabs(record_row(record, i)[v_cm] - record_row(record, i)[predicted]));
    ck_assert_double_lt(worst, 1e-4 * 1e-4); /* of the velocity; closer: check_predicted */
    experiment_destroy(experiment);
    static const char *const unpredicted[][2] = {{"mpm.algorithm", "usl"},
                                                 {"mpm.transfer", "apic"},
                                                 {"load.traction", "1e-3"},
                                                 {"initial.pulse", "5,1,1e-3"}};
    for (size_t i = 0; i < sizeof unpredicted / sizeof *unpredicted; i++) {
        Settings other = settings;
        set(&other, unpredicted[i][0], unpredicted[i][1]);
        ck_assert_msg(!has_column(&other, "v_cm_predicted"), "%s", unpredicted[i][0]);
    }
    settings_edit_time(&settings)->end = 1e4; /* for ever */
    ck_assert_ptr_null(answer_invalid_because(&settings, REFERENCE_EXACT));
    set(&settings, "initial.shape", "sine");
    ck_assert_str_eq(answer_invalid_because(&settings, REFERENCE_EXACT), "bar2.joint");
    settings_edit_time(&settings)->end = 100;
    ck_assert_ptr_null(answer_invalid_because(&settings, REFERENCE_EXACT));
    set(&settings, "load.body_force", "0.01");
    ck_assert_str_eq(answer_invalid_because(&settings, REFERENCE_EXACT), "bar2.joint");
    ck_assert_ptr_null(answer_invalid_because(&settings, REFERENCE_FREQUENCY));
    /* between equals nothing is changed */
    static const char *const equals[] = {"mesh.cell_size", "0.5", "bar2.joint", "12.5", NULL};
    Settings joined = loaded("mode5", equals), one = loaded("mode5", equals);
    set(&one, "bar2.joint", "none");
    settings_edit_time(&joined)->end = settings_edit_time(&one)->end = 5;
    const Readout a = read_out(&joined), b = read_out(&one);
    ck_assert_double_eq(a.measured, b.measured);
    ck_assert_double_eq(a.predicted, b.predicted);
    ck_assert_double_eq(a.exact, b.exact);
    Experiment *of_joined = open_experiment(&joined, 1 << 20), *of_one = open_experiment(&one, 1 << 20);
    ck_assert(experiment_advance(of_joined, 500, NULL) && experiment_advance(of_one, 500, NULL));
    expect_same_records(experiment_record(of_joined), experiment_record(of_one), "a joint between equals");
    experiment_destroy(of_joined);
    experiment_destroy(of_one);
}
END_TEST

START_TEST(a_column_s_support_bears_its_weight)
{
    static const char *const none[] = {NULL};
    const Settings settings = loaded("column", none);
    Derived derived[DERIVED_MAX];
    const int count = problem_derived(&settings, NULL, derived);
    double bears = NAN;
    for (int i = 0; i < count; i++)
        if (strcmp(derived[i].name, "stress_support") == 0)
            bears = derived[i].value;
    ck_assert_double_eq_tol(bears, 1 * 0.1 * 25, 1e-14);
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    Finding findings[FINDINGS_MAX];
    references_findings(experiment_references(experiment), experiment_simulation(experiment), findings);
    ck_assert_str_eq(findings[1].label, "first particle's stress");
    ck_assert_double_eq_tol(findings[1].exact, 0.1 * (25 - 0.25), 1e-14);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(every_problem_has_its_method)
{
    for (int p = 0; problems[p]; p++) {
        const Problem *problem = problems[p];
        const bool both = problem->concerns & CONCERN_METHODS,
                   mesh = problem->concerns & (CONCERN_MESH | CONCERN_BODIES);
        ck_assert(problem_allows(problem, METHOD_MPM, NULL) == (both || mesh));
        ck_assert(problem_allows(problem, METHOD_PD, NULL) == (both || !mesh));
        ck_assert_uint_gt(strlen(problem->title), 10);
    }
    Settings settings = beam_settings(&problem_notched_beam, 1e-5);
    settings.method = METHOD_MPM;
    Status status = {0};
    ck_assert(!settings_check(&settings, &status));
    ck_assert_int_eq(status.code, STATUS_USAGE);
}
END_TEST

/* --- bodies --------------------------------------------------------------------------------------------- */

/* The first row at or after a time; experiment_destroy() it. */
static Experiment *at_time(const Settings *settings, double time)
{
    Experiment *experiment = open_experiment(settings, 1 << 20);
    const double dt = experiment_simulation(experiment)->dt;
    ck_assert(experiment_advance(experiment, (long)ceil(time / dt), NULL));
    return experiment;
}

static double now(const Experiment *experiment, const char *column)
{
    const int k = column_of(experiment, column);
    ck_assert_msg(k >= 0, "no column %s", column);
    return experiment_row(experiment)[k];
}

/* Of a name, with NAN for both when there is none; its name is NULL then. */
static Finding found(const Experiment *experiment, const char *name)
{
    Finding findings[FINDINGS_MAX];
    const int n =
        references_findings(experiment_references(experiment), experiment_simulation(experiment), findings);
    for (int i = 0; i < n; i++)
        if (strcmp(findings[i].name, name) == 0)
            return findings[i];
    return (Finding){.measured = NAN, .exact = NAN};
}

/* Velocity and stress of one step are half a step apart, which would make it ripple by 5 %. */
START_TEST(one_particle_s_invariant_does_not_ripple)
{
    static const char *const algorithms[][3] = {{"mpm.algorithm", "usf", NULL},
                                                {"mpm.algorithm", "musl", NULL}};
    const Settings settings = loaded("one-particle", algorithms[_i]);
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    for (int step = 0; step < 64; step++) {
        ck_assert_double_eq_tol(found(experiment, "invariant").measured, 1, 2e-3);
        ck_assert(experiment_advance(experiment, 1, NULL));
    }
    experiment_destroy(experiment);
}
END_TEST

/* While bodies push each other it is that of now; once they have parted it stays, though the line of their
 * centres turns. */
START_TEST(restitution_stays_once_bodies_have_parted)
{
    static const struct {
        const char *scenario;
        double pushing, parted, later, now, restitution;
    } known[] = {{"colliding-rings", 1, 1.15, 1.2, 0.5868, 0.6853},
                 {"two-discs-off-centre", 1.35, 1.45, 1.6, 0.7183, 0.7261}};
    static const char *const longer[] = {"time.end", "2", NULL};
    const Settings settings = loaded(known[_i].scenario, longer);
    const double times[] = {0, known[_i].pushing, known[_i].parted, known[_i].later};
    for (int k = 0; k < 4; k++) {
        Experiment *experiment = at_time(&settings, times[k]);
        const double measured = found(experiment, "restitution").measured;
        if (k == 0)
            ck_assert_msg(isnan(measured), "%g at t = 0", measured);
        else
            ck_assert_double_eq_tol(measured, k == 1 ? known[_i].now : known[_i].restitution, 1e-4);
        experiment_destroy(experiment);
    }
}
END_TEST

/* 0.05 from a body at rest, which is struck at t = 0.25 and then moves on to a wall; the one that strikes
 * would be there at 2.5. */
START_TEST(momenta_are_exact_until_a_wall_can_act)
{
    static const char *const row[] = {"bodies.left",
                                      "disc 0.3 0.5 0.2 velocity 0.2 0",
                                      "bodies.right",
                                      "disc 0.75 0.5 0.2",
                                      "domain.right",
                                      "slip",
                                      NULL};
    Settings settings = loaded("two-discs", row);
    Experiment *before = at_time(&settings, 0.2), *after = at_time(&settings, 0.3);
    ck_assert_double_eq_tol(now(before, "momentum_x") / now(before, "momentum_x_exact"), 1, 1e-9);
    ck_assert_double_eq(now(before, "momentum_y_exact"), 0);
    ck_assert(isnan(now(after, "momentum_x_exact")) && isnan(now(after, "angular_exact")));
    ck_assert_ptr_null(found(after, "momentum_error").name);
    ck_assert_double_eq_tol(found(after, "first_touch").exact, 0.25, 1e-12);
    experiment_destroy(before);
    experiment_destroy(after);
    set(&settings, "domain.right", "open");
    after = at_time(&settings, 0.6);
    ck_assert_double_eq_tol(now(after, "momentum_x") / now(after, "momentum_x_exact"), 1, 1e-9);
    ck_assert_double_lt(found(after, "momentum_error").measured, 1e-9);
    experiment_destroy(after);
}
END_TEST

/* A block that vibrates does not move rigidly: nobody knows when it reaches a wall. */
START_TEST(a_wave_touches_at_no_known_time)
{
    static const char *const box[] = {"domain.left",
                                      "slip",
                                      "domain.right",
                                      "slip",
                                      "bodies.block",
                                      "block 0.3 0.4 0.6 0.6 velocity 0.1 0 wave 0.3",
                                      "time.end",
                                      "2",
                                      NULL};
    Settings settings = loaded("vibrating-block", box);
    Experiment *run = at_time(&settings, 1.6);
    ck_assert(isnan(found(run, "wall_touch").exact));
    experiment_destroy(run);
    set(&settings, "bodies.block", "block 0.3 0.4 0.6 0.6 velocity 0.1 0");
    run = at_time(&settings, 1.6);
    ck_assert_double_eq_tol(found(run, "wall_touch").exact, 4, 1e-9);
    experiment_destroy(run);
}
END_TEST

/* a = g (sin - mu cos) as tan 30 > 3 mu; 2/3 g sin where it rolls. The wall ahead is 1.8 away. */
START_TEST(an_incline_ends_at_its_wall)
{
    static const char *const walled[] = {"domain.right", "slip", "time.end", "1.5", NULL};
    Settings settings = loaded("roll-or-slide", walled);
    const double g = 9.81, slides = g * (0.5 - 0.1 * sqrt(0.75)), until = sqrt(2 * 1.8 / slides);
    Experiment *before = at_time(&settings, 0.9 * until), *after = at_time(&settings, 1.01 * until);
    const double t = simulation_time(experiment_simulation(before));
    ck_assert_double_eq_tol(now(before, "disc.x_exact"), 0.7 + slides * t * t / 2, 1e-4); /* from particles */
    ck_assert_double_eq_tol(now(before, "disc.vx_exact"), slides * t, 1e-12);
    ck_assert_double_eq_tol(now(before, "disc.spin_exact"), -2 * 0.1 * g * sqrt(0.75) / 0.5 * t, 1e-12);
    ck_assert_double_eq_tol(found(before, "acceleration").exact, slides, 1e-12);
    ck_assert_ptr_null(found(before, "wall_touch").name); /* it lies on one */
    ck_assert(isnan(now(after, "disc.x_exact")) && isnan(now(after, "disc.spin_exact")));
    ck_assert(isnan(found(after, "acceleration").exact) && found(after, "acceleration").measured > 0);
    experiment_destroy(before);
    experiment_destroy(after);
    set(&settings, "domain.right", "open");
    set(&settings, "domain.wall_friction", "0.6");
    after = at_time(&settings, 0.5);
    ck_assert_double_eq_tol(found(after, "acceleration").exact, 2 * g * 0.5 / 3, 1e-12);
    ck_assert_double_eq_tol(now(after, "disc.spin_exact") / now(after, "disc.vx_exact"), -2, 1e-12);
    experiment_destroy(after);
}
END_TEST

/* With damping no answer is exact, but what the disc does is still told; where the floor does not let it
 * slip, it does not bounce by y + v^2/(2 g). */
START_TEST(a_bounce_is_told)
{
    static const char *const as_it_is[] = {NULL};
    Settings settings = loaded("bouncing-disc", as_it_is);
    Experiment *flying = at_time(&settings, 0.2), *run = at_time(&settings, 0.45);
    const double t = simulation_time(experiment_simulation(flying));
    ck_assert_double_eq_tol(now(flying, "disc.y_exact"), 0.6 - 5 * t * t, 1e-9);
    ck_assert_double_eq_tol(now(flying, "disc.y"), now(flying, "disc.y_exact"), 1e-3);
    ck_assert_double_eq_tol(now(flying, "disc.vy_exact"), -10 * t, 1e-12);
    ck_assert_double_eq_tol(found(run, "wall_touch").exact, sqrt(0.08), 1e-9);
    ck_assert_double_eq_tol(found(run, "wall_touch").measured, sqrt(0.08), 0.01);
    const double height = found(run, "bounce_height").measured;
    ck_assert(height > 0.45 && height < 0.6 && isnan(now(run, "disc.y_exact")));
    Experiment *on_floor = at_time(&settings, 0.35), *falling = at_time(&settings, 0.6);
    ck_assert(isnan(found(on_floor, "bounce_height").measured));
    ck_assert_double_eq_tol(found(falling, "bounce_height").measured, height, 1e-3);
    experiment_destroy(on_floor);
    experiment_destroy(falling);
    experiment_destroy(flying);
    experiment_destroy(run);
    set(&settings, "damping.rate", "3");
    run = at_time(&settings, 0.45);
    ck_assert_int_lt(column_of(run, "disc.y_exact"), 0);
    static const char *const told[] = {"wall_touch", "bounce_height", "stretch"};
    for (int i = 0; i < 3; i++) {
        const Finding finding = found(run, told[i]);
        ck_assert_msg(isfinite(finding.measured) && isnan(finding.exact), "%s", told[i]);
    }
    ck_assert_double_lt(found(run, "bounce_height").measured, height);
    ck_assert_ptr_null(found(run, "momentum_error").name);
    experiment_destroy(run);
    set(&settings, "domain.bottom", "friction");
    run = at_time(&settings, 0);
    ck_assert_ptr_null(found(run, "bounce_height").name);
    experiment_destroy(run);
}
END_TEST

/* After a fourth of a period all is at rest for a moment, sin(k c t) = 1, and every particle is as far as it
 * goes. Where the formula does not hold nothing is told. */
START_TEST(a_block_between_clamps_vibrates)
{
    static const char *const as_it_is[] = {NULL};
    static const char *const others[][2] = {{"material.poisson", "0.1"},
                                            {"domain.left", "slip"},
                                            {"load.gravity", "1e-9"},
                                            {"damping.rate", "0.1"},
                                            {"bodies.block", "block 0 0.4 1 0.6 wave 1e-2"},
                                            {"bodies.block", "block 0 0.4 0.8 0.6 wave 1e-5"},
                                            {"bodies.block", "block 0 0.4 1 0.6 velocity 0 1e-6 wave 1e-5"}};
    Settings settings = loaded("vibrating-block", as_it_is);
    Experiment *run = at_time(&settings, 0.5);
    const Simulation *sim = experiment_simulation(run);
    double sum = 0;
    for (size_t p = 0; p < sim->counts[0]; p++) {
        const double x = simulation_named(sim, 0, "x0", p);
        const double off = simulation_named(sim, 0, "x", p) - x - 1e-5 / M_PI * sin(M_PI * x);
        sum += off * off;
    }
    const double rms = sqrt(sum / (double)sim->counts[0]) / (1e-5 / M_PI);
    ck_assert_double_eq_tol(found(run, "u_error").measured, rms, 1e-9);
    ck_assert(rms > 1e-4 && rms < 0.02);
    ck_assert_double_eq(found(run, "u_error").exact, 0);
    experiment_destroy(run);
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        settings = loaded("vibrating-block", as_it_is);
        set(&settings, others[i][0], others[i][1]);
        run = at_time(&settings, 0.1);
        ck_assert_msg(!found(run, "u_error").name, "%s", others[i][1]);
        experiment_destroy(run);
    }
}
END_TEST

START_TEST(a_spin_of_round_off_is_none)
{
    static const char *const as_it_is[] = {NULL};
    Settings settings = loaded("two-discs", as_it_is);
    Experiment *run = at_time(&settings, 1);
    ck_assert_double_eq(found(run, "body_spin").measured, 0);
    experiment_destroy(run);
    settings = loaded("two-discs-off-centre", as_it_is);
    run = at_time(&settings, settings_time(&settings)->end);
    ck_assert_double_gt(fabs(found(run, "body_spin").measured), 1e-3);
    experiment_destroy(run);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("problem");
    tcase_add_test(tcase, a_column_that_a_run_has_not_is_absent);
    tcase_add_test(tcase, answers_stand_beside_what_they_answer);
    tcase_add_test(tcase, exact_profiles_are_the_theory);
    tcase_add_test(tcase, the_paper_s_errors_are_read);
    tcase_add_test(tcase, the_lag_grows_with_time);
    tcase_add_test(tcase, symmetric_bars_are_measured_on_their_strain);
    tcase_add_test(tcase, what_rests_has_no_frequency);
    tcase_add_test(tcase, a_supported_beam_s_period_is_read);
    tcase_add_test(tcase, courant_numbers_are_warned_of_and_refused);
    tcase_add_test(tcase, derived_numbers_know_the_ends);
    tcase_add_test(tcase, derived_numbers_follow_from_the_settings);
    tcase_add_test(tcase, the_last_step_is_the_first_to_reach_the_end);
    tcase_add_test(tcase, a_run_cut_short_leaves_out_what_comes_later);
    if (!suite_sanitized()) { /* long runs */
        tcase_add_test(tcase, loads_from_rest_oscillate_with_the_lowest_mode);
        tcase_add_test(tcase, a_thinned_record_reads_the_same);
        tcase_add_test(tcase, a_beam_rings_through_its_height);
        tcase_add_test(tcase, a_moving_cantilever_is_read_at_its_zeros);
        tcase_add_test(tcase, the_filter_takes_thickness_modes_away_and_does_not_lag);
        tcase_add_test(tcase, an_offset_is_known);
        tcase_add_test(tcase, an_echo_is_told_while_it_is_in_one_piece);
        tcase_add_test(tcase, two_materials_have_a_frequency);
    }
    tcase_add_loop_test(tcase, a_pulse_goes_where_it_is_sent, 0, 3);
    tcase_add_test(tcase, a_column_s_support_bears_its_weight);
    tcase_add_loop_test(tcase, one_particle_s_invariant_does_not_ripple, 0, 2);
    tcase_add_test(tcase, every_problem_has_its_method);
    tcase_add_test(tcase, other_ways_on_the_same_mesh);
    tcase_add_test(tcase, a_wave_is_a_mode_between_fixed_ends);
    suite_add_tcase(suite, tcase);
    TCase *bodies = tcase_create("bodies");
    tcase_set_timeout(bodies, 120);
    tcase_add_test(bodies, momenta_are_exact_until_a_wall_can_act);
    tcase_add_loop_test(bodies, restitution_stays_once_bodies_have_parted, 0, 2);
    tcase_add_test(bodies, a_wave_touches_at_no_known_time);
    if (!suite_sanitized())
        tcase_add_test(bodies, an_incline_ends_at_its_wall);
    tcase_add_test(bodies, a_bounce_is_told);
    tcase_add_test(bodies, a_spin_of_round_off_is_none);
    tcase_add_test(bodies, a_block_between_clamps_vibrates);
    suite_add_tcase(suite, bodies);
}

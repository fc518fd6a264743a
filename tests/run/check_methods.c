/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One bar by two methods: which keys each has, how a scenario changes from one to the other, and what stands
 * beside a run by peridynamics. */
#include "base/text.h"
#include "answers/bar_answers.h"
#include "scenario/parameters.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_cells.h"
#include "scenario/settings.h"
#include "run/lab_case.h"
#include "scenario/scenario.h"
#include "methods/bonds/cracks/crack.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Settings bar_of_bonds(int mode, double end)
{
    Settings settings = bar_settings(mode, end);
    set(&settings, "scenario.method", "pd");
    return settings;
}

/* --- keys ----------------------------------------------------------------------------------------- */

static bool read_text(const char *text, Settings *settings, Status *status)
{
    FILE *stream = fmemopen((void *)text, strlen(text), "r");
    ck_assert(stream != NULL);
    bool good = scenario_read(stream, "f.ini", settings, status);
    fclose(stream);
    return good;
}

START_TEST(each_method_has_its_keys)
{
    Settings mpm = bar_settings(1, 1), pd = bar_of_bonds(1, 1);
    Status status = {0};
    ck_assert(!settings_set(&mpm, "pd.horizon", "2", &status));
    ck_assert_str_eq(status.text, "pd.horizon: is not a parameter of method mpm (only of pd)");
    ck_assert(!settings_set(&pd, "mpm.algorithm", "usl", &status));
    ck_assert(!settings_set(&pd, "mesh.padding", "2", &status));
    ck_assert(!settings_set(&pd, "pd.horizon", "0", NULL) || lattice_horizon(&pd) == 1.5);
    static const char *const both[][2] = {
        {"mesh.cell_size", "0.5"}, {"mesh.particles_per_cell", "3"}, {"time.courant", "0.05"},
        {"load.body_force", "1"},  {"bar.supports", "fixed-fixed"},
    };
    for (size_t i = 0; i < sizeof both / sizeof *both; i++) {
        set(&mpm, both[i][0], both[i][1]);
        set(&pd, both[i][0], both[i][1]);
    }
    /* one node where each particle is, three spacings, the same time step */
    ck_assert_double_eq(lattice_spacing(&pd), 0.5 / 3);
    ck_assert_double_eq(lattice_horizon(&pd), 0.5);
    ck_assert_double_eq(bar_pd_definition(&pd).dt, bar_time_step(&mpm));
    Settings beam = beam_settings(&problem_notched_beam, 1e-5);
    ck_assert(!settings_set(&beam, "pd.spacing", "auto", &status));
    ck_assert_str_eq(status.text, "pd.spacing: auto is not a number (> 0)");
    ck_assert(!settings_set(&beam, "scenario.method", "mpm", &status));
}
END_TEST

START_TEST(a_scenario_goes_over_to_the_other_method)
{
    const Override by_pd[] = {{"--set", "pd.horizon", "2"}, {"--set", "scenario.method", "pd"}};
    const Override wrong[] = {{"--set", "scenario.method", "pd"}, {"--set", "mpm.shape", "gimp"}};
    Settings settings;
    Status status = {0};
    ck_assert_msg(scenario_load_with("crossing", by_pd, 2, &settings, &status), "%s", status.text);
    ck_assert(settings.method == METHOD_PD && settings_lattice(&settings)->horizon == 2);
    ck_assert(!scenario_load_with("crossing", wrong, 2, &settings, &status));
    ck_assert_str_eq(status.text, "--set: mpm.shape: is not a parameter of method pd (only of mpm)");
    /* how it is solved may be left behind, what is solved may not */
    static const struct {
        const char *scenario, *method, *refusal;
    } dropped[] = {
        {"two-materials", "pd",
         "--set: scenario.method: pd does not know initial.pulse, which is 60,8,1e-4 here (mpm)"},
        {"pulse", "pd",
         "--set: scenario.method: pd does not know initial.pulse, which is 50,3,1e-4 here (mpm)"},
        {"hanging-beam", "mpm",
         "--set: scenario.method: mpm does not know damping.rate, which is critical here (pd)"},
    };
    for (size_t i = 0; i < sizeof dropped / sizeof *dropped; i++) {
        const Override other[] = {{"--set", "scenario.method", dropped[i].method}};
        ck_assert(!scenario_load_with(dropped[i].scenario, other, 1, &settings, &status));
        ck_assert_str_eq(status.text, dropped[i].refusal);
    }
    const Override joint[] = {{"--set", "bar2.joint", "10"}, {"--set", "bar2.youngs_modulus", "400"}};
    ck_assert(scenario_load_with("mode5", joint, 2, &settings, &status));
    ck_assert(settings_set(&settings, "scenario.method", "pd", &status) &&
              !settings_check(&settings, &status));
    ck_assert_str_eq(status.text, "scenario.method: pd does not know bar2.joint, which is 10 here (mpm)");
    /* what is written is read again, and has the keys of its method */
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    ck_assert(stream && scenario_write(stream, &settings, NULL, &status));
    fclose(stream);
    ck_assert(strstr(text, "method = pd\n") && strstr(text, "spacing = auto\n"));
    ck_assert(!strstr(text, "[mpm]") && !strstr(text, "padding"));
    ck_assert(strstr(text, "method = ") == strstr(text, "method = pd")); /* once */
    Settings again;
    ck_assert_msg(read_text(text, &again, &status), "%s", status.text);
    ck_assert(settings_same(&settings, &again));
    free(text);
}
END_TEST

START_TEST(a_duel_may_change_the_method)
{
    static const char duel[] = "[scenario]\nproblem = bar\n[mpm]\nalgorithm = musl\n"
                               "[duel]\npd.horizon = 2\nscenario.method = pd\n";
    Settings settings;
    Status status = {0};
    ck_assert_msg(read_text(duel, &settings, &status), "%s", status.text);
    ck_assert_int_eq(settings.method, METHOD_MPM);
    ck_assert_int_eq(settings.n_duel, 2);
}
END_TEST

START_TEST(the_method_is_a_field_that_can_be_nudged)
{
    Settings settings = bar_settings(5, 1), other = settings;
    char name[LEGEND_MAX];
    ck_assert(settings_nudge(&other, parameter_find("scenario.method"), 1, false, NULL));
    ck_assert_int_eq(other.method, METHOD_PD);
    settings_name(&settings, &other, name, sizeof name);
    ck_assert_str_eq(name, "MPM");
    /* from what "auto" comes to */
    ck_assert(settings_nudge(&other, parameter_find("pd.horizon"), 1, false, NULL));
    ck_assert_double_eq(settings_lattice(&other)->horizon, 2);
    ck_assert(settings_nudge(&other, parameter_find("pd.spacing"), -1, false, NULL));
    ck_assert_double_eq(settings_lattice(&other)->spacing, 0.25);
    /* the volume correction of the beams is passed over */
    ck_assert(settings_nudge(&other, parameter_find("pd.surface_correction"), 1, false, NULL));
    ck_assert_int_eq(settings_lattice(&other)->surface_correction, SURFACE_NONE);
    ck_assert(settings_nudge(&other, parameter_find("pd.surface_correction"), 1, false, NULL));
    ck_assert_int_eq(settings_lattice(&other)->surface_correction, SURFACE_ENERGY);
    Settings beam = beam_settings(&problem_notched_beam, 1e-5);
    ck_assert(!settings_nudge(&beam, parameter_find("scenario.method"), 1, false, NULL));
}
END_TEST

START_TEST(an_edit_of_the_method_keeps_the_time)
{
    Settings settings = bar_settings(5, 5);
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    Status status = {0};
    ck_assert(experiment_advance(experiment, 250, &status));
    set(&settings, "scenario.method", "pd");
    ck_assert_msg(experiment_edit(experiment, &settings, &status), "%s", status.text);
    finish_work(experiment);
    ck_assert_int_eq(experiment_step(experiment), 250);
    ck_assert_str_eq(experiment_simulation(experiment)->method->name, "pd");
    ck_assert_str_eq(experiment_ghosts(experiment)[0].legend, "MPM");
    set(&settings, "scenario.method", "mpm");
    ck_assert_msg(experiment_edit(experiment, &settings, &status), "%s", status.text);
    finish_work(experiment);
    ck_assert_int_eq(experiment_step(experiment), 250);
    experiment_destroy(experiment);
}
END_TEST

/* --- what stands beside a run --------------------------------------------------------------------- */

static Experiment *run(const Settings *settings)
{
    Experiment *experiment = open_experiment(settings, 1 << 20);
    Status status = {0};
    ck_assert_msg(experiment_advance(experiment, experiment_last_step(experiment), &status), "%s",
                  status.text);
    experiment_rest(experiment);
    return experiment;
}

START_TEST(columns_are_those_of_the_bar)
{
    static const char *const names[] = {"step",           "time",  "v_cm",     "v_cm_exact",
                                        "v_cm_predicted", "x_cm",  "kinetic",  "strain",
                                        "work",           "total", "momentum", "reaction"};
    Settings settings = bar_of_bonds(5, 2);
    Experiment *experiment = run(&settings);
    int count;
    const Column *columns = experiment_columns(experiment, &count);
    ck_assert_int_eq(count, 12);
    for (int i = 0; i < count; i++)
        ck_assert_str_eq(columns[i].quantity.name, names[i]);
    /* v_cm is predicted whole, free end or not */
    const Record *record = experiment_record(experiment);
    for (size_t k = 0; k < record->count; k++) {
        const double *row = record->rows + k * (size_t)count;
        ck_assert_double_eq_tol(row[4], row[2], 1e-12);
    }
    experiment_destroy(experiment);
    set(&settings, "load.body_force", "1e-3");
    experiment = open_experiment(&settings, 1 << 20);
    ck_assert_int_lt(column_of(experiment, "v_cm_predicted"), 0);
    ck_assert_int_ge(column_of(experiment, "v_cm_exact"), 0);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(frequencies_are_as_predicted)
{
    static const struct {
        const char *supports;
        int mode;
        double tolerance; /* measured against predicted */
    } cases[] = {
        {"fixed-fixed", 1, 1e-9}, {"fixed-fixed", 2, 1e-7}, {"fixed-fixed", 5, 1e-9},
        {"fixed-fixed", 9, 1e-9}, {"fixed-free", 5, 3e-4},  {"free-fixed", 1, 1e-5},
        {"free-free", 4, 1e-3},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Settings settings = bar_of_bonds(cases[i].mode, 60);
        set(&settings, "bar.supports", cases[i].supports);
        Experiment *experiment = run(&settings);
        const Readout *readout = experiment_readout(experiment);
        ck_assert(readout->measured_known && readout->predicted_known && readout->exact_known);
        ck_assert_double_eq_tol(readout->measured / readout->predicted, 1, cases[i].tolerance);
        experiment_destroy(experiment);
    }
}
END_TEST

/* From rest, fixed at the left: v_cm is the parabola of period 4L/c whose crest is b (L/c)/2. */
START_TEST(loads_as_by_the_other_method)
{
    double crest[2];
    for (int method = 0; method < 2; method++) {
        Settings settings = bar_settings(1, 5);
        set(&settings, "scenario.method", settings_method_words[method]);
        set(&settings, "initial.velocity", "0");
        set(&settings, "load.body_force", "1e-3");
        Experiment *experiment = run(&settings);
        const Record *record = experiment_record(experiment);
        const int v_cm = column_of(experiment, "v_cm");
        int count;
        experiment_columns(experiment, &count);
        crest[method] = 0;
        for (size_t k = 0; k < record->count; k++)
            crest[method] = fmax(crest[method], record->rows[k * (size_t)count + (size_t)v_cm]);
        experiment_destroy(experiment);
        ck_assert_double_eq_tol(crest[method], 1.25e-3, 1e-5);
    }
}
END_TEST

START_TEST(too_large_a_step_is_refused_with_both_numbers)
{
    Settings settings = bar_of_bonds(1, 1);
    char advice[160];
    Status status = {0};
    set(&settings, "time.courant", "0.9");
    ck_assert(!problem_advice(&settings, advice, sizeof advice, &status));
    ck_assert_str_eq(status.text, "time.courant: the time step 0.09 is above the critical one, 0.0880243 "
                                  "(courant at most 0.88024)");
    set(&settings, "time.courant", "0.86");
    ck_assert(problem_advice(&settings, advice, sizeof advice, &status));
    ck_assert_str_eq(advice, "time step 0.086 is near the critical one, 0.088024");
    set(&settings, "time.courant", "0.5");
    ck_assert(problem_advice(&settings, advice, sizeof advice, &status));
    ck_assert_str_eq(advice, "");
}
END_TEST

START_TEST(derived_numbers_of_the_lattice)
{
    Settings settings = bar_of_bonds(5, 1);
    Simulation *sim = problem_simulate(&settings, 1, NULL);
    Derived derived[DERIVED_MAX];
    ck_assert(sim != NULL);
    const int n = problem_derived(&settings, sim, derived);
    static const struct {
        const char *name;
        double value;
    } expected[] = {
        {"dt", 0.01},
        {"particles", 50},
        {"lattice_spacing", 0.5},
        {"lattice_horizon", 1.5},
        {"family", 6},
        {"micromodulus", 200 / 2.25},
        {"modulus_of_bonds", 100},
        {"end_factor", 2},
        {"dt_crit", 0.0880243},
        {"omega_predicted", 5.58684},
    };
    for (size_t k = 0; k < sizeof expected / sizeof *expected; k++) {
        int found = 0;
        for (int i = 0; i < n; i++)
            if (strcmp(derived[i].name, expected[k].name) == 0) {
                ck_assert_double_eq_tol(derived[i].value / expected[k].value, 1, 2e-6);
                found++;
            }
        ck_assert_msg(found == 1, "%s", expected[k].name);
    }
    simulation_destroy(sim);
}
END_TEST

/* A load that changes in mid-run belongs to the state: any way to a later step is the same. */
START_TEST(a_change_of_the_load_is_taken_back)
{
    Settings settings = bar_of_bonds(1, 3);
    settings.n_changes = 1;
    settings.changes[0] = (Change){60, {"load.body_force", "0.5"}};
    Experiment *straight = run(&settings), *walked = run(&settings);
    experiment_seek(walked, 30, 2);
    finish_work(walked);
    experiment_seek(walked, 200, 0);
    finish_work(walked);
    experiment_seek(straight, 200, 0);
    finish_work(straight);
    expect_same_states(experiment_simulation(walked), experiment_simulation(straight), "a change");
    expect_same_records(experiment_record(walked), experiment_record(straight), "a change");
    ck_assert_int_lt(column_of(walked, "v_cm_exact"), 0);
    experiment_destroy(straight);
    experiment_destroy(walked);
}
END_TEST

/* --- the manual ----------------------------------------------------------------------------------- */

/* matvib-equations(7) as it is read: without the escapes of roff. */
static char *page_of_equations(void)
{
    /* made in the build folder of a checkout, part of the sources of a release */
    const char *build = getenv("MATVIB_BUILDDIR");
    char made[4096];
    snprintf(made, sizeof made, "%s/man/matvib-equations.7", build ? build : ".");
    FILE *file = fopen(made, "r");
    if (!file)
        file = fopen(source_path("man/matvib-equations.7"), "r");
    ck_assert_ptr_nonnull(file);
    enum { MOST = 1 << 18 };
    char *page = calloc(1, MOST);
    size_t n = 0;
    for (int c; (c = getc(file)) != EOF && n < MOST - 1;)
        if (c != '\\')
            page[n++] = (char)c;
        else if ((c = getc(file)) == '(') /* an apostrophe or a caret: \(aq, \(ha */
            page[n++] = getc(file) == 'a' ? '\'' : '^', (void)getc(file);
        else
            page[n++] = (char)c;
    fclose(file);
    ck_assert_uint_lt(n, MOST - 1);
    return page;
}

static void expect_number(const char *page, const char *format, double number)
{
    char text[80];
    snprintf(text, sizeof text, format, number);
    ck_assert_msg(strstr(page, text), "matvib-equations(7) has no \"%s\"", text);
}

static void expect_stages(const char *page, const Settings *settings, const char *scenario)
{
    Status status = {0};
    Simulation *sim = problem_simulate(settings, 1, &status);
    ck_assert_msg(sim, "%s: %s", scenario, status.text);
    for (int i = 0; i < sim->n_stages; i++) {
        char text[512];
        text_to_ascii(sim->stages[i].equation, text, sizeof text);
        for (char *rest, *line = strtok_r(text, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest))
            ck_assert_msg(strstr(page, line), "%s: matvib-equations(7) has no \"%s\"", scenario, line);
        ck_assert_msg(strstr(page, sim->stages[i].sentence), "%s: it does not say \"%s\"", scenario,
                      sim->stages[i].sentence);
    }
    simulation_destroy(sim);
}

START_TEST(the_manual_has_every_mistake)
{
    char *page = page_of_equations();
    for (int p = 0; p < n_parameters; p++)
        for (int i = 1; parameters[p].wrong && parameters[p].choices[i]; i++) {
            char entry[512];
            snprintf(entry, sizeof entry, ".B %s\n%s\n", parameters[p].choices[i],
                     parameters[p].choice_help(i));
            ck_assert_msg(strstr(page, entry), "matvib-equations(7) does not define %s",
                          parameters[p].choices[i]);
        }
    free(page);
}
END_TEST

/* Made from the same tables, but by a frame that names each wording; so a new one is missed here. */
START_TEST(the_manual_has_every_stage)
{
    static const char *const changes[][4] = {
        {"mode1"},
        {"mode1", "mpm.flip_fraction", "0.5"},
        {"mode1", "mpm.transfer", "apic"},
        {"mode1", "mpm.transfer", "fmpm"},
        {"mode1", "mpm.mass_blend", "0.5"},
        {"supported-beam-mpm-coarse", "mpm.flip_fraction", "1"},
        {"moving-cantilever-mpm-coarse", "mpm.flip_fraction", "0.5"},
        {"mode5-peridynamics"},
        {"supported-beam-coarse"},
        {"supported-beam-coarse", "damping.rate", "1000"},
        {"moving-cantilever-coarse"},
        {"moving-cantilever-coarse", "damping.rate", "1000"},
        {"notched-beam-coarse"},
        {"notched-beam-coarse", "damping.rate", "1000"},
        {"branching-coarse"},
        {"branching-coarse", "load.body_force", "-9.81"},
    };
    static const char *const algorithms[] = {"usf", "usl", "musl"};
    char *page = page_of_equations();
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        Settings settings;
        ck_assert(scenario_load(changes[i][0], &settings, NULL));
        if (changes[i][1])
            set(&settings, changes[i][1], changes[i][2]);
        if (strcmp(changes[i][0], "mode1") == 0) { /* the page has the force with all terms that there are */
            set(&settings, "load.body_force", "1");
            set(&settings, "load.traction", "1");
        }
        expect_stages(page, &settings, changes[i][0]);
        const Parameter *algorithm = parameter_find("mpm.algorithm");
        for (size_t k = 0; k < 3 && parameter_applies_to(&settings, algorithm); k++) {
            set(&settings, "mpm.algorithm", algorithms[k]);
            expect_stages(page, &settings, changes[i][0]);
        }
        if (settings_transfer(&settings)->transfer == MPM_APIC) {
            set(&settings, "mpm.shape", "bspline2");
            expect_stages(page, &settings, changes[i][0]);
        } else if (settings_transfer(&settings)->mass_blend != 1 &&
                   parameter_applies_to(&settings, algorithm)) {
            set(&settings, "mpm.flip_fraction", "0.5");
            expect_stages(page, &settings, changes[i][0]);
        }
    }
    free(page);
}
END_TEST

START_TEST(the_manual_has_the_numbers_of_the_program)
{
    char *page = page_of_equations();
    expect_number(page, "phi > %g and", CRACK_DAMAGE);
    expect_number(page, "every %g steps", BEAM_REST_EVERY);
    expect_number(page, "below %g of its largest", BEAM_REST_SHARE);
    Settings settings = beam_settings(&problem_supported_beam, 1e-5);
    set(&settings, "pd.spacing", "0.5e-3");
    set(&settings, "pd.horizon", "2e-3");
    set(&settings, "pd.volume_correction", "partial");
    Simulation *beam = problem_simulate(&settings, 1, NULL);
    ck_assert_ptr_nonnull(beam);
    const size_t middle = beam->columns * (beam->rows / 2) + beam->columns / 2;
    const double g = simulation_value(beam, simulation_find_field(beam, 0, "surface_x"), middle);
    expect_number(page, "g is not 1 (%.6f at", g);
    simulation_destroy(beam);
    free(page);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("methods");
    tcase_add_test(tcase, each_method_has_its_keys);
    tcase_add_test(tcase, a_scenario_goes_over_to_the_other_method);
    tcase_add_test(tcase, a_duel_may_change_the_method);
    tcase_add_test(tcase, the_method_is_a_field_that_can_be_nudged);
    tcase_add_test(tcase, an_edit_of_the_method_keeps_the_time);
    tcase_add_test(tcase, columns_are_those_of_the_bar);
    tcase_add_test(tcase, frequencies_are_as_predicted);
    tcase_add_test(tcase, loads_as_by_the_other_method);
    tcase_add_test(tcase, too_large_a_step_is_refused_with_both_numbers);
    tcase_add_test(tcase, derived_numbers_of_the_lattice);
    tcase_add_test(tcase, a_change_of_the_load_is_taken_back);
    tcase_add_test(tcase, the_manual_has_every_stage);
    tcase_add_test(tcase, the_manual_has_every_mistake);
    tcase_add_test(tcase, the_manual_has_the_numbers_of_the_program);
    suite_add_tcase(suite, tcase);
}

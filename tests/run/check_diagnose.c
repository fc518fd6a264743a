/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs of our own mistakes on settings at random, written with some digits, and what is made of them: the
 * mistake is named, alone or among those that the file cannot tell apart, or the file cannot show it. A wrong
 * name never stands alone, and right numbers are right.
 *
 *     MATVIB_DIAGNOSES=N  so many settings of a bar (3)   MATVIB_SEED=N  those of another draw
 *     MATVIB_WIDE=1       every case of each kind */
#include "run/lab_case.h"

#include "answers/diagnose/diagnose.h"
#include "answers/diagnose/diagnose_internal.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "methods/mpm/mpm.h"
#include "problems/problem.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_cells.h"
#include "scenario/scenario.h"
#include "scenario/settings.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static long number_of(const char *name, long otherwise)
{
    return getenv(name) ? atol(getenv(name)) : otherwise;
}

/* Every case, and not some of each kind. */
static bool is_wide(void)
{
    return getenv("MATVIB_DIAGNOSES") || getenv("MATVIB_WIDE");
}

static unsigned long chosen(unsigned long *state, const char *const *words)
{
    unsigned long count = 0;
    while (words[count])
        count++;
    return draw(state, count);
}

/* --- files ------------------------------------------------------------------------------------------ */

static const char *const columns_of_bar[][6] = {
    {"v_cm", NULL}, {"v_cm", "kinetic", "strain", NULL}, {"x_cm", "v_cm", NULL}};
static const char *const columns_of_beam[] = {"v_probe", "u_probe", "kinetic", NULL};

/* The first `steps` steps of a run, or as far as it goes, as a table. Returns the rows. */
static long write_run(const char *path, const Settings *settings, long steps, const char *const *columns,
                      int digits)
{
    Status status = {0};
    Simulation *sim = problem_simulate(settings, 1, &status);
    FILE *file = fopen(path, "w");
    long rows = 0;
    ck_assert_msg(sim && file, "%s", status.text);
    fprintf(file, "step");
    for (int i = 0; columns[i]; i++)
        fprintf(file, ",%s", columns[i]);
    double row[32];
    do {
        simulation_row(sim, row);
        fprintf(file, "\n%ld", sim->step);
        for (int i = 0; columns[i]; i++)
            fprintf(file, ",%.*g", digits, row[simulation_find_series(sim, columns[i])]);
        rows++;
    } while (sim->step < steps && simulation_steps(sim, 1, NULL, NULL, NULL));
    fprintf(file, "\n");
    fclose(file);
    simulation_destroy(sim);
    return rows;
}

static void diagnose_file(const char *path, const Settings *settings, bool pairs, Diagnosis *found)
{
    Status status = {0};
    DiagnoseTable *table = calloc(1, sizeof *table);
    const DiagnoseTask task = {.settings = settings, .threads = 1, .pairs = pairs};
    ck_assert_msg(diagnose_read(table, path, settings, NULL, &status) &&
                      diagnose(&task, table, found, &status),
                  "%s", status.text);
    diagnose_close(table);
    free(table);
}

static bool names(const Diagnosis *found, const char *mistake)
{
    for (int i = 0; i < found->n_explanations; i++)
        if (strcmp(found->explanations[i].id, mistake) == 0)
            return true;
    return false;
}

/* "VERDICT: a b c" */
static const char *told(const Diagnosis *found)
{
    static char text[1000];
    size_t used = (size_t)snprintf(text, sizeof text, "verdict %d:", (int)found->verdict);
    for (int i = 0; i < found->n_explanations && used + 90 < sizeof text; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, " %s", found->explanations[i].id);
    return text;
}

/* A mistake (NULL: none) with so many digits. */
static void judge(const Settings *right, const char *key, const char *mistake, long steps,
                  const char *const *columns, int digits)
{
    char path[] = "/tmp/check_diagnose.XXXXXX";
    const int made = mkstemp(path);
    Settings wrong = *right;
    Diagnosis *found = calloc(1, sizeof *found);
    ck_assert(made >= 0 && found);
    close(made);
    if (mistake && !settings_change(&wrong, key, mistake, NULL)) { /* not of this scheme */
        unlink(path);
        free(found);
        return;
    }
    write_run(path, &wrong, steps, columns, digits);
    diagnose_file(path, right, false, found);
    unlink(path);
    char with[200] = "";
    for (int i = 0; columns[i]; i++)
        snprintf(with + strlen(with), sizeof with - strlen(with), " %s", columns[i]);
    const bool mute = found->verdict == DIAGNOSE_MUTE;
    if (mistake)
        ck_assert_msg(mute || names(found, mistake) || found->more > 0, "%s, %d digits, %ld steps,%s: %s",
                      mistake, digits, steps, with, told(found));
    else
        ck_assert_msg(mute || found->verdict == DIAGNOSE_RIGHT, "%d digits, %ld steps,%s: %s", digits, steps,
                      with, told(found));
    free(found);
}

/* --- bars ------------------------------------------------------------------------------------------- */

static void put(Settings *settings, const char *key, const char *const *words, unsigned long *state)
{
    set(settings, key, words[chosen(state, words)]);
}

static Settings any_bar(unsigned long *state)
{
    static const char *const supports[] = {"fixed-free", "free-fixed", "fixed-fixed", "free-free", NULL};
    static const char *const particles[] = {"1", "2", "3", "4", NULL}, *const modes[] = {"1", "2", "5", NULL};
    static const char *const cells[] = {"0.25", "0.5", "1", "2.5", NULL}, *const lengths[] = {"10", "20",
                                                                                              "25", NULL};
    static const char *const densities[] = {"0.5", "1", "2", "7.8", NULL}, *const moduli[] = {"50", "100",
                                                                                              "210", NULL};
    static const char *const courants[] = {"0.05", "0.1", "0.3", NULL}, *const velocities[] = {"0.01", "0.1",
                                                                                               "1", NULL};
    static const char *const algorithms[] = {"usf", "usl", "musl", NULL};
    static const char *const shapes[] = {"hat", "hat", "gimp", NULL};
    static const char *const transfers[] = {"flip", "flip", "apic", NULL};
    Settings settings = bar_settings(5, 100);
    put(&settings, "mpm.algorithm", algorithms, state);
    put(&settings, "mpm.shape", shapes, state);
    put(&settings, "mpm.transfer", transfers, state);
    put(&settings, "bar.supports", supports, state);
    put(&settings, "mesh.particles_per_cell", particles, state);
    put(&settings, "mesh.cell_size", cells, state);
    put(&settings, "bar.density", densities, state);
    put(&settings, "bar.length", lengths, state);
    put(&settings, "bar.youngs_modulus", moduli, state);
    put(&settings, "initial.mode", modes, state);
    put(&settings, "time.courant", courants, state);
    put(&settings, "initial.velocity", velocities, state);
    return settings;
}

/* Each mistake once, in turn with each setting and number of digits, unless all are asked for. */
START_TEST(a_bars_mistake_is_named)
{
    static const int digits[] = {6, 9, 17};
    static const long steps[] = {3, 10, 40, 150, 400};
    const long settings_wanted = number_of("MATVIB_DIAGNOSES", 3);
    const bool all = is_wide();
    unsigned long state = (unsigned long)number_of("MATVIB_SEED", 1) * 7919;
    for (long k = 0; k < settings_wanted; k++) {
        const Settings right = any_bar(&state);
        const char *const *columns = columns_of_bar[draw(&state, 3)];
        const long count = steps[draw(&state, 5)];
        for (int m = 0; mpm_mistake_words[m]; m++)
            for (int d = 0; d < 3; d++)
                if (all || (m % settings_wanted == k && (m / 3 + m) % 3 == d))
                    /* three numbers of six digits fit a mistake with another value too */
                    judge(&right, "mpm.mistake", m > 0 ? mpm_mistake_words[m] : NULL,
                          digits[d] < 9 && count < 10 ? 10 : count, columns, digits[d]);
    }
}
END_TEST

/* Which a right code of another scheme makes too. */
START_TEST(a_mistake_that_is_another_scheme_is_named_with_it)
{
    Settings right = bar_settings(5, 100);
    set(&right, "mpm.shape", "gimp");
    judge(&right, "mpm.mistake", "gimp_half_of_half", 60, columns_of_bar[1], 17);
}
END_TEST

/* In a scheme that the scenario has not, it is named with that scheme; without a mistake the code is right.
 */
START_TEST(a_mistake_is_named_in_every_scheme)
{
    static const char *const schemes[][4] = {{"usl", "hat", "flip", "USL"},
                                             {"musl", "hat", "flip", "MUSL"},
                                             {"usl", "gimp", "flip", "USL, gimp"},
                                             {"musl", "bspline2", "apic", "MUSL, bspline2, apic"},
                                             {"usf", "gimp", "apic", "USF, gimp, apic"}};
    static const char *const mistakes[] = {"none", "force_sign", "natural_slope_in_force", "stress_of_next",
                                           "no_volume"};
    char path[] = "/tmp/check_diagnose.XXXXXX";
    const int made = mkstemp(path);
    Settings right = bar_settings(3, 100);
    Diagnosis *found = calloc(1, sizeof *found);
    ck_assert(made >= 0 && found);
    close(made);
    set(&right, "mesh.cell_size", "0.5");
    set(&right, "mesh.particles_per_cell", "3");
    set(&right, "bar.density", "2");
    for (int s = 0; s < 5; s++)
        for (int m = 0; m < 5; m++) {
            Settings wrong = right;
            if (!is_wide() && m > 0 && (m + s) % 4 != 0) /* each mistake, and each scheme with one */
                continue;
            set(&wrong, "mpm.algorithm", schemes[s][0]);
            set(&wrong, "mpm.shape", schemes[s][1]);
            set(&wrong, "mpm.transfer", schemes[s][2]);
            set(&wrong, "mpm.mistake", mistakes[m]);
            write_run(path, &wrong, 40, columns_of_bar[1], 12);
            diagnose_file(path, &right, false, found);
            ck_assert_msg(found->verdict == (m == 0 ? DIAGNOSE_RIGHT : DIAGNOSE_EXPLAINED), "%s %s: %s",
                          schemes[s][3], mistakes[m], told(found));
            ck_assert_str_eq(found->scheme, schemes[s][3]);
            ck_assert_msg(m == 0 || names(found, mistakes[m]), "%s %s: %s", schemes[s][3], mistakes[m],
                          told(found));
        }
    unlink(path);
    free(found);
}
END_TEST

static void run_both(const Settings *settings, int mistake, int beside, double row[32])
{
    Settings wrong = *settings;
    settings_edit_transfer(&wrong)->mistake = mistake;
    settings_edit_transfer(&wrong)->mistake_beside = beside;
    Simulation *sim = problem_simulate(&wrong, 1, NULL);
    ck_assert_ptr_nonnull(sim);
    ck_assert(simulation_steps(sim, 20, NULL, NULL, NULL));
    simulation_row(sim, row);
    simulation_destroy(sim);
}

/* With cells of 1 dN/ds is dN/dx: beside it each mistake does all that it does alone, from either side. */
START_TEST(a_second_mistake_takes_nothing_from_the_first)
{
    const Settings settings = bar_settings(5, 100);
    int hidden = 0;
    while (strcmp(mpm_mistake_words[hidden], "gradient_without_h") != 0)
        hidden++;
    for (int m = 1; mpm_mistake_words[m]; m++) {
        double alone[32], beside[32], before[32];
        Settings wrong = settings;
        if (m == hidden || !settings_change(&wrong, "mpm.mistake", mpm_mistake_words[m], NULL))
            continue;
        settings_edit_transfer(&wrong)->mistake_beside = hidden;
        if (!settings_check(&wrong, NULL)) /* one and the same thing */
            continue;
        run_both(&settings, m, 0, alone);
        run_both(&settings, m, hidden, beside);
        run_both(&settings, hidden, m, before);
        for (int i = 0; i < 4; i++) {
            ck_assert_msg(fabs(beside[i] - alone[i]) <= 1e-12 * fabs(alone[i]), "%s: %g, not %g",
                          mpm_mistake_words[m], beside[i], alone[i]);
            ck_assert_msg(fabs(before[i] - alone[i]) <= 1e-12 * fabs(alone[i]), "before %s: %g, not %g",
                          mpm_mistake_words[m], before[i], alone[i]);
        }
    }
}
END_TEST

/* Two mistakes at once are named as two, unless one alone comes to the same. True: they were. */
static bool judge_two(const Settings *right, const Settings *wrong, const char *const *words, int beside,
                      int mistake, const char *const *columns, bool pairs)
{
    char path[] = "/tmp/check_diagnose.XXXXXX", pair[2 * KEY_MAX];
    const int made = mkstemp(path);
    Diagnosis *found = calloc(1, sizeof *found);
    ck_assert(made >= 0 && found);
    close(made);
    write_run(path, wrong, 30, columns, 17);
    snprintf(pair, sizeof pair, "%s+%s", words[beside], words[mistake]);
    diagnose_file(path, right, pairs, found);
    const bool simpler = found->verdict == DIAGNOSE_EXPLAINED && !strchr(found->explanations[0].id, '+');
    const bool named = names(found, pair);
    ck_assert_msg(simpler || named, "%s: %s", pair, told(found));
    if (getenv("MATVIB_TELL"))
        printf("%s: %s\n", pair, told(found));
    if (named && pairs) {
        diagnose_file(path, right, false, found);
        ck_assert_msg(found->verdict == DIAGNOSE_UNKNOWN && found->pairs_left, "%s: %s", pair, told(found));
    }
    unlink(path);
    free(found);
    return named;
}

START_TEST(two_mistakes_are_named)
{
    static const char *const columns[] = {"v_cm", "kinetic", "strain", NULL};
    const long wanted = is_wide() ? 60 : 5;
    unsigned long state = (unsigned long)number_of("MATVIB_SEED", 1) * 104729;
    Settings right = bar_settings(3, 100);
    set(&right, "mesh.cell_size", "0.5");
    set(&right, "mesh.particles_per_cell", "3");
    set(&right, "bar.density", "2");
    long two = 0, tried = 0;
    unsigned long count = 0;
    while (mpm_mistake_words[count + 1])
        count++;
    for (long k = 0; k < wanted; k++) {
        const unsigned long one = 1 + draw(&state, count), other = 1 + draw(&state, count);
        Settings wrong = right;
        settings_edit_transfer(&wrong)->mistake = (int)(one > other ? one : other);
        settings_edit_transfer(&wrong)->mistake_beside = (int)(one > other ? other : one);
        if (!settings_check(&wrong, NULL))
            continue;
        tried++;
        two += judge_two(&right, &wrong, mpm_mistake_words, settings_transfer(&wrong)->mistake_beside,
                         settings_transfer(&wrong)->mistake, columns, false);
    }
    ck_assert_int_gt(two, tried / 2);
}
END_TEST

/* --- beams ------------------------------------------------------------------------------------------ */

static Settings small_beam(const char *length, const char *height)
{
    Settings settings = beam_settings(&problem_supported_beam, 1e-3);
    set(&settings, "beam.length", length);
    set(&settings, "beam.height", height);
    set(&settings, "pd.spacing", "0.0005");
    set(&settings, "pd.horizon", "0.002");
    return settings;
}

/* On request; without it they are of no code that was tried. */
START_TEST(two_mistakes_of_a_beam_are_named)
{
    static const char *const pairs[][2] = {
        {"one_way", "stretch_of_current"},         {"counted_twice", "euler_forward"},
        {"no_volume_factor", "no_surface_factor"}, {"horizon_strict", "direction_of_reference"},
        {"micromodulus_3d", "start_unsupported"},  {"micromodulus_plane_strain", "one_way"}};
    const Settings right = small_beam("0.02", "0.002");
    const int count = is_wide() ? 6 : 2;
    int two = 0;
    for (int k = 0; k < count; k++) {
        Settings wrong = right;
        int both[2] = {0, 0};
        for (int i = 0; i < 2; i++)
            while (strcmp(beam_mistake_words[both[i]], pairs[k][i]) != 0)
                both[i]++;
        settings_edit_lattice(&wrong)->mistake_beside = both[0] < both[1] ? both[0] : both[1];
        settings_edit_lattice(&wrong)->mistake = both[0] < both[1] ? both[1] : both[0];
        two += judge_two(&right, &wrong, beam_mistake_words, settings_lattice(&wrong)->mistake_beside,
                         settings_lattice(&wrong)->mistake, columns_of_beam, true);
    }
    ck_assert_int_ge(two, 2);
}
END_TEST

START_TEST(a_beams_mistake_is_named)
{
    static const char *const sizes[][2] = {{"0.02", "0.002"}, {"0.03", "0.003"}, {"0.04", "0.002"}};
    const bool all = is_wide();
    for (int s = 0; s < (all ? 3 : 1); s++)
        for (int m = 0; beam_mistake_words[m]; m++)
            for (int digits = 9; digits <= 17; digits += 8) {
                Settings right = small_beam(sizes[s][0], sizes[s][1]);
                set(&right, "pd.surface_correction", m % 2 == 0 ? "none" : "energy");
                if (all || (m + digits / 9) % 3 == 0)
                    judge(&right, "pd.mistake", m > 0 ? beam_mistake_words[m] : NULL, 12, columns_of_beam,
                          digits);
            }
}
END_TEST

/* Of cells: those of a bar that mean something in the plane, in the scenario's scheme. */
START_TEST(a_mistake_of_cells_is_named)
{
    static const char *const algorithms[] = {"usf", "usl", "musl", NULL};
    for (int m = 0; mpm_mistake_words[m]; m++) {
        Settings right = small_beam("0.02", "0.005");
        set(&right, "scenario.method", "mpm");
        set(&right, "mesh.cell_size", "0.0025");
        set(&right, "mesh.particles_per_cell", "3");
        for (int i = 0; algorithms[i]; i++) {
            set(&right, "mpm.algorithm", algorithms[i]);
            if (is_wide() || m % 3 == i || strstr(mpm_mistake_words[m], "keep_grid_"))
                judge(&right, "mpm.mistake", m > 0 ? mpm_mistake_words[m] : NULL, 30, columns_of_beam, 15);
        }
    }
}
END_TEST

/* Four steps of a nudge each way; of what is doubled and halved one (2 cannot be had: the bar is 25 long). */
START_TEST(values_beside_the_right_one_are_tried)
{
    static const double moduli[] = {50, 20, 10, 5, 200, 500, 1000, 2000}, halved = 0.5;
    static Candidate candidates[CANDIDATES_MAX];
    Settings settings;
    Status status = {0};
    ck_assert(scenario_load("mode5", &settings, &status));
    const int count = diagnose_candidates(&settings, MISTAKES_AND_VALUES, candidates);
    int n_moduli = 0, n_sizes = 0;
    for (int i = 0; i < count; i++) {
        const Parameter *parameter = candidates[i].parameter;
        if (parameter == parameter_find("bar.youngs_modulus")) {
            ck_assert_int_lt(n_moduli, 8);
            ck_assert_double_eq_tol(candidates[i].value, moduli[n_moduli], 1e-9);
            n_moduli++;
        }
        if (parameter == parameter_find("mesh.cell_size")) {
            ck_assert_double_eq_tol(candidates[i].value, halved, 1e-9);
            n_sizes++;
        }
    }
    ck_assert_int_eq(n_moduli, 8);
    ck_assert_int_eq(n_sizes, 1);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *cases = tcase_create("named");
    tcase_set_timeout(cases, 1200);
    tcase_add_test(cases, a_bars_mistake_is_named);
    tcase_add_test(cases, a_mistake_that_is_another_scheme_is_named_with_it);
    tcase_add_test(cases, a_mistake_is_named_in_every_scheme);
    tcase_add_test(cases, a_beams_mistake_is_named);
    tcase_add_test(cases, a_mistake_of_cells_is_named);
    tcase_add_test(cases, values_beside_the_right_one_are_tried);
    TCase *pairs = tcase_create("pairs");
    tcase_set_timeout(pairs, 1200);
    tcase_add_test(pairs, a_second_mistake_takes_nothing_from_the_first);
    tcase_add_test(pairs, two_mistakes_are_named);
    tcase_add_test(pairs, two_mistakes_of_a_beam_are_named);
    suite_add_tcase(suite, pairs);
    suite_add_tcase(suite, cases);
}

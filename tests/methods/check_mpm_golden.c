/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bar against runs of an independent program, digit by digit: only these catch a small error of
 * convention, which a frequency does not show. */
#include "base/text.h"
#include "methods/bar_case.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES_MAX = 16, PARTICLES_MAX = 512, SPOTS_MAX = 64 };

/* Files of cases, and how many there are in each. */
static const struct {
    const char *path;
    int count;
} files[] = {{"tests/golden/mpm.txt", 13}, {"tests/golden/cures.txt", 14}};
enum { CASES = 27 };

typedef struct Golden {
    char name[40];
    BarCase bar;
    long steps;
    int n_samples, n_particles;
    struct {
        long step;
        double v_cm, x_cm, kinetic, strain;
        int n_more; /* of the rest: 0 or 3 */
        double kinetic_grid, kinetic_null, kinetic_affine;
    } samples[SAMPLES_MAX];
    int n_spots; /* some particles at the time of some samples */
    struct {
        long step;
        int particle;
        double x, v, stress, density, affine;
    } spots[SPOTS_MAX];
    double x[PARTICLES_MAX], v[PARTICLES_MAX], stress[PARTICLES_MAX], density[PARTICLES_MAX];
} Golden;

static int word_index(const char *word, const char *const *words)
{
    for (int i = 0; words[i]; i++)
        if (strcmp(word, words[i]) == 0)
            return i;
    ck_abort_msg("unknown word %s", word);
    return -1;
}

static void set(Golden *golden, const char *key, const char *value)
{
    static const char *const supports[] = {"fixed-free", "free-fixed", "fixed-fixed", "free-free", NULL};
    static const char *const algorithms[] = {"usf", "usl", "musl", NULL};
    static const char *const shapes[] = {
        "hat", "gimp", "bspline2", "bspline3", "cpdi", "bspline2_uniform", "bspline3_uniform", NULL};
    static const char *const transfers[] = {"flip", "apic", "fmpm", NULL};
    static const char *const affine_starts[] = {"gradient", "zero", NULL};
    MpmDef *def = &golden->bar.def;
    const struct {
        const char *key;
        double *number;
    } numbers[] = {
        {"bar.length", &def->length},         {"bar.youngs_modulus", &def->youngs_modulus},
        {"bar.density", &def->density},       {"initial.velocity", &golden->bar.modes[0].velocity},
        {"mesh.cell_size", &def->cell_size},  {"mpm.flip_fraction", &def->flip_fraction},
        {"time.courant", &def->courant},      {"initial.offset", &def->offset},
        {"mpm.mass_blend", &def->mass_blend},
    };
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
        if (strcmp(key, numbers[i].key) == 0) {
            ck_assert(text_to_double(value, numbers[i].number));
            return;
        }
    if (strcmp(key, "bar.supports") == 0)
        def->supports = (BarSupports)word_index(value, supports);
    else if (strcmp(key, "mpm.algorithm") == 0)
        def->algorithm = (MpmAlgorithm)word_index(value, algorithms);
    else if (strcmp(key, "mpm.shape") == 0)
        def->shape = (MpmShape)word_index(value, shapes);
    else if (strcmp(key, "mpm.transfer") == 0)
        def->transfer = (MpmTransfer)word_index(value, transfers);
    else if (strcmp(key, "mpm.affine_start") == 0)
        golden->bar.zero_slope = word_index(value, affine_starts) == 1;
    else if (strcmp(key, "initial.mode") == 0)
        golden->bar.modes[0].number = atoi(value);
    else if (strcmp(key, "mesh.particles_per_cell") == 0)
        def->particles_per_cell = atoi(value);
    else if (strcmp(key, "mpm.fmpm_order") == 0)
        def->fmpm_order = atoi(value);
    else if (strcmp(key, "mesh.padding") == 0)
        def->padding = atoi(value);
    else if (strcmp(key, "initial.overtones") == 0) {
        int mode = 0;
        double v0 = 0;
        ck_assert_int_eq(sscanf(value, "%d:%lf", &mode, &v0), 2);
        bar_case_add_mode(&golden->bar, mode, v0);
    } else
        ck_abort_msg("unknown key %s", key);
}

static Golden golden;

static bool read_case(FILE *file)
{
    char line[400], key[40], value[40];
    bool begun = false;
    golden = (Golden){.bar = bar_case(1, 0)};
    golden.bar.zero_slope = true; /* unless a case says other */
    while (fgets(line, sizeof line, file)) {
        if (sscanf(line, "case %39s", golden.name) == 1)
            begun = true;
        else if (strncmp(line, "end", 3) == 0)
            return true;
        else if (sscanf(line, "set %39s %39s", key, value) == 2)
            set(&golden, key, value);
        else if (strncmp(line, "sample", 6) == 0) {
            int i = golden.n_samples++;
            ck_assert_int_lt(i, SAMPLES_MAX);
            int read = sscanf(line, "sample %ld %lf %lf %lf %lf %lf %lf %lf", &golden.samples[i].step,
                              &golden.samples[i].v_cm, &golden.samples[i].x_cm, &golden.samples[i].kinetic,
                              &golden.samples[i].strain, &golden.samples[i].kinetic_grid,
                              &golden.samples[i].kinetic_null, &golden.samples[i].kinetic_affine);
            ck_assert(read == 5 || read == 8);
            golden.samples[i].n_more = read - 5;
        } else if (strncmp(line, "at ", 3) == 0) {
            int i = golden.n_spots++;
            ck_assert_int_lt(i, SPOTS_MAX);
            ck_assert_int_eq(sscanf(line, "at %ld %d %lf %lf %lf %lf %lf", &golden.spots[i].step,
                                    &golden.spots[i].particle, &golden.spots[i].x, &golden.spots[i].v,
                                    &golden.spots[i].stress, &golden.spots[i].density,
                                    &golden.spots[i].affine),
                             7);
        } else if (sscanf(line, "particles %d", &(int){0}) == 1 || line[0] == '#')
            continue;
        else if (strncmp(line, "particle", 8) == 0) {
            int p = golden.n_particles++;
            ck_assert_int_lt(p, PARTICLES_MAX);
            ck_assert_int_eq(sscanf(line, "particle %lf %lf %lf %lf", &golden.x[p], &golden.v[p],
                                    &golden.stress[p], &golden.density[p]),
                             4);
        } else
            ck_assert_int_eq(sscanf(line, "steps %ld", &golden.steps), 1);
    }
    ck_assert(!begun);
    return false;
}

static double largest(const double *values, int count)
{
    double most = 0;
    for (int i = 0; i < count; i++)
        most = fmax(most, fabs(values[i]));
    return most;
}

static void expect_close(const char *what, long index, double got, double expected, double tolerance)
{
    ck_assert_msg(fabs(got - expected) <= tolerance,
                  "%s: %s %ld is %.17g, not %.17g (off %.3g, allowed %.3g)", golden.name, what, index, got,
                  expected, got - expected, tolerance);
}

static void expect_array(const Simulation *sim, const char *name, const double *expected, double tolerance)
{
    double *got = field_now(sim, 0, name);
    for (int p = 0; p < golden.n_particles; p++)
        expect_close(name, p, got[p], expected[p], tolerance);
    free(got);
}

/* The energies of a sample that tell what the grid sees. */
static void expect_more(Simulation *sim, int i, double energy_most)
{
    if (golden.samples[i].n_more == 0)
        return;
    const double tolerance = 1e-12 * energy_most;
    expect_close("kinetic_null at step", sim->step, series_now(sim, "kinetic_null"),
                 golden.samples[i].kinetic_null, tolerance);
    expect_close("kinetic at step", sim->step, series_now(sim, "kinetic"), golden.samples[i].kinetic_affine,
                 tolerance);
    if (golden.bar.def.transfer == MPM_FLIP) /* else the grid sees affine motion too */
        expect_close("kinetic_grid at step", sim->step, series_now(sim, "kinetic_grid"),
                     golden.samples[i].kinetic_grid, tolerance);
}

static void expect_spots(const Simulation *sim, double v_most, double stress_most)
{
    static const char *const names[] = {"x", "v", "stress", "density", "affine"};
    for (int i = 0; i < golden.n_spots; i++) {
        if (golden.spots[i].step != sim->step)
            continue;
        const double expected[] = {golden.spots[i].x, golden.spots[i].v, golden.spots[i].stress,
                                   golden.spots[i].density, golden.spots[i].affine};
        const double tolerance[] = {1e-13 * golden.bar.def.length, 1e-11 * v_most,
                                    1e-11 * fmax(stress_most, 1e-3), 1e-12, 1e-11 * v_most};
        for (int q = 0; q < 5; q++) {
            double *got = field_now(sim, 0, names[q]);
            expect_close(names[q], golden.spots[i].particle, got[golden.spots[i].particle], expected[q],
                         tolerance[q]);
            free(got);
        }
    }
}

static void run_golden(void)
{
    Simulation *sim = bar_case_create(&golden.bar);
    if (golden.n_spots == 0)
        ck_assert_uint_eq(sim->counts[0], (size_t)golden.n_particles);
    double v_cm_most = 0, v_most = 0, stress_most = 0, energy_most = 0;
    for (int i = 0; i < golden.n_samples; i++) {
        v_cm_most = fmax(v_cm_most, fabs(golden.samples[i].v_cm));
        energy_most = fmax(energy_most, golden.samples[i].kinetic + golden.samples[i].strain);
    }
    double v0 = fabs(golden.bar.modes[0].velocity);
    if (v_cm_most < 1e-6 * v0) /* symmetry makes the centre of mass rest */
        v_cm_most = v0;
    double mass = golden.bar.def.density * golden.bar.def.cell_size / golden.bar.def.particles_per_cell;
    for (int i = 0; i < golden.n_samples; i++) {
        advance(sim, golden.samples[i].step - sim->step);
        long step = sim->step;
        double *v = field_now(sim, 0, "v"), *stress = field_now(sim, 0, "stress"), kinetic = 0;
        const int particles = (int)sim->counts[0];
        for (int p = 0; p < particles; p++)
            kinetic += 0.5 * mass * v[p] * v[p];
        v_most = fmax(v_most, largest(v, particles));
        stress_most = fmax(stress_most, largest(stress, particles));
        free(v);
        free(stress);
        expect_close("v_cm at step", step, series_now(sim, "v_cm"), golden.samples[i].v_cm,
                     1e-12 * v_cm_most);
        expect_close("x_cm at step", step, series_now(sim, "x_cm"), golden.samples[i].x_cm,
                     1e-13 * golden.bar.def.length);
        expect_close("kinetic at step", step, kinetic, golden.samples[i].kinetic, 1e-12 * energy_most);
        expect_close("strain at step", step, series_now(sim, "strain"), golden.samples[i].strain,
                     1e-12 * energy_most);
        if (golden.bar.def.transfer == MPM_FLIP)
            expect_close("kinetic at step", step, series_now(sim, "kinetic"), golden.samples[i].kinetic,
                         1e-12 * energy_most);
        expect_more(sim, i, energy_most);
        expect_spots(sim, v_most, stress_most);
    }
    ck_assert_int_eq(sim->step, golden.steps);
    expect_array(sim, "x", golden.x, 1e-13 * golden.bar.def.length);
    expect_array(sim, "v", golden.v, 1e-11 * v_most);
    /* a rigid motion has no stress: its scale is that of an impact at the same speed, rho c v */
    double scale = sqrt(golden.bar.def.youngs_modulus * golden.bar.def.density) * v0;
    expect_array(sim, "stress", golden.stress, 1e-11 * (golden.bar.modes[0].number ? stress_most : scale));
    expect_array(sim, "density", golden.density, 1e-12 * largest(golden.density, golden.n_particles));
    simulation_destroy(sim);
}

static void run_case(int which)
{
    int file_number = 0;
    while (which >= files[file_number].count)
        which -= files[file_number++].count;
    FILE *file = fopen(source_path(files[file_number].path), "r");
    ck_assert_ptr_nonnull(file);
    for (int i = 0; i <= which; i++)
        ck_assert(read_case(file));
    fclose(file);
    run_golden();
}

START_TEST(golden_case)
{
    run_case(_i);
}
END_TEST

START_TEST(all_cases_are_there)
{
    int all = 0;
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        FILE *file = fopen(source_path(files[i].path), "r");
        ck_assert_ptr_nonnull(file);
        int count = 0;
        while (read_case(file))
            count++;
        fclose(file);
        ck_assert_int_eq(count, files[i].count);
        all += count;
    }
    ck_assert_int_eq(all, CASES);
}
END_TEST

START_TEST(first_step_of_the_first_mode)
{
    BarCase bar = bar_case(1, 0.1);
    Simulation *sim = bar_case_create(&bar);
    advance(sim, 1);
    static const struct {
        const char *name;
        double value;
    } expected[] = {{"x", .250015691201504},
                    {"v", .0015706697949751998},
                    {"stress", .006276728346441611},
                    {"density", .9999372366560203}};
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        double *got = field_now(sim, 0, expected[i].name);
        ck_assert_double_eq_tol(got[0], expected[i].value, 1e-15);
        free(got);
    }
    simulation_destroy(sim);
}
END_TEST

/* What is left of the energy after one step of APIC that starts without slopes, with the part that the slopes
 * hold: it is theirs alone to keep it, each shape by its own formula. Digits of an independent program. */
START_TEST(the_first_step_of_apic)
{
    static const struct {
        MpmShape shape;
        int mode;
        double change, allowed; /* of kinetic and strain energy, percent */
    } known[] = {
        {MPM_HAT, 1, 100 * (.0624512849 / .0625 - 1), 2e-7},
        {MPM_HAT, 5, 100 * (.0586681590 / .0625 - 1), 2e-7},
        {MPM_HAT, 10, 100 * (.0470557789 / .0625 - 1), 2e-7},
        {MPM_BSPLINE2, 5, -7.93, 5.1e-3},
        {MPM_BSPLINE2, 10, -32.6, 5.1e-2},
        {MPM_BSPLINE3, 5, -10.2, 5.1e-2},
        {MPM_BSPLINE3, 10, -41.4, 5.1e-2},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        BarCase bar = bar_case(known[i].mode, 0.1);
        bar.def.shape = known[i].shape;
        bar.def.transfer = MPM_APIC;
        bar.zero_slope = true;
        Simulation *sim = bar_case_create(&bar);
        const double before = series_now(sim, "kinetic");
        advance(sim, 1);
        const double now = series_now(sim, "kinetic") + series_now(sim, "strain");
        ck_assert_double_eq_tol(100 * (now / before - 1), known[i].change, known[i].allowed);
        simulation_destroy(sim);
    }
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *test = tcase_create("golden");
    tcase_add_test(test, all_cases_are_there);
    tcase_add_test(test, first_step_of_the_first_mode);
    tcase_add_test(test, the_first_step_of_apic);
    tcase_add_loop_test(test, golden_case, 0, CASES);
    suite_add_tcase(suite, test);
}

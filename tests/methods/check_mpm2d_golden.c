/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams by the material point method against runs of an independent program, digit by digit: only these catch
 * a small error of convention. */
#include "base/text.h"
#include "methods/mpm/mpm.h"
#include "methods/default_defs.h"
#include "methods/run_case.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CASES = 6, STATES_MAX = 8, SPOTS_MAX = 8, QUANTITIES = 8, ENERGIES = 7 };

typedef struct State {
    long step;
    double energies[ENERGIES]; /* as `energy_names` */
    int n_spots;
    int particle[SPOTS_MAX];
    double values[SPOTS_MAX][QUANTITIES]; /* as `names` */
} State;

typedef struct Golden {
    char name[60];
    MpmDef def;
    double dt, xmin, ymin;
    int columns, rows, gx, gy;
    int n_states;
    State states[STATES_MAX];
} Golden;

static const char *const names[QUANTITIES] = {"x", "y", "vx", "vy", "sxx", "syy", "sxy", "density"};

static int word_index(const char *word, const char *const *words)
{
    for (int i = 0; words[i]; i++)
        if (strcmp(word, words[i]) == 0)
            return i;
    ck_abort_msg("unknown word %s", word);
    return -1;
}

static void set(MpmDef *def, const char *key, const char *value)
{
    static const char *const algorithms[] = {"usf", "usl", "musl", NULL};
    static const char *const shapes[] = {"hat", "gimp", NULL};
    static const char *const stresses[] = {"relaxed", "grid", "exact", NULL};
    static const char *const starts[] = {"deflection", "velocity", NULL};
    static const char *const supports[] = {"section", "point", "full", "guide", NULL};
    static const char *const cases[] = {"S", "C", NULL};
    const struct {
        const char *key;
        double *number;
    } numbers[] = {
        {"L", &def->length},
        {"h", &def->height},
        {"b", &def->thickness},
        {"E", &def->youngs_modulus},
        {"rho", &def->density},
        {"nu", &def->poisson},
        {"dx", &def->cell_size},
        {"U", &def->amplitude},
        {"courant", &def->courant},
        {"v0", &def->speed},
        {"channel", &def->channel},
        {"gridv", &def->grid_velocity},
        {"alpha", &def->flip_fraction},
    };
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        if (strcmp(key, numbers[i].key) == 0) {
            ck_assert(text_to_double(value, numbers[i].number));
            return;
        }
    if (strcmp(key, "ppc") == 0)
        def->particles_per_cell = atoi(value);
    else if (strcmp(key, "pad") == 0)
        def->padding = atoi(value);
    else if (strcmp(key, "case") == 0)
        def->leaves_channel = word_index(value, cases) == 1;
    else if (strcmp(key, "shape") == 0)
        def->shape = (MpmShape)word_index(value, shapes);
    else if (strcmp(key, "algo") == 0)
        def->algorithm = (MpmAlgorithm)word_index(value, algorithms);
    else if (strcmp(key, "stress0") == 0)
        def->stress = (PlaneStress)word_index(value, stresses);
    else if (strcmp(key, "start") == 0)
        def->start = (PlaneStart)word_index(value, starts);
    else if (strcmp(key, "sup") == 0) {
        const int which = word_index(value, supports);
        def->ends = which == 1 ? PLANE_POINT : PLANE_SECTION;
        def->clamp = which == 3 ? CLAMP_GUIDE : CLAMP_FULL;
    } else
        ck_abort_msg("unknown key %s", key);
}

static bool read_case(FILE *file, Golden *golden)
{
    char line[400], key[40], value[60];
    *golden = (Golden){.def = plane_default(false)};
    while (fgets(line, sizeof line, file)) {
        State *state = &golden->states[golden->n_states > 0 ? golden->n_states - 1 : 0];
        if (line[0] == '#' || sscanf(line, "case %59s", golden->name) == 1)
            continue;
        if (strncmp(line, "end", 3) == 0)
            return true;
        if (sscanf(line, "set %39s %59s", key, value) == 2)
            set(&golden->def, key, value);
        else if (strncmp(line, "state", 5) == 0) {
            ck_assert_int_lt(golden->n_states, STATES_MAX);
            state = &golden->states[golden->n_states++];
            double *e = state->energies;
            ck_assert_int_eq(sscanf(line, "state %ld %lf %lf %lf %lf %lf %lf %lf", &state->step, e, e + 1,
                                    e + 2, e + 3, e + 4, e + 5, e + 6),
                             1 + ENERGIES);
        } else if (strncmp(line, "at", 2) == 0) {
            ck_assert_int_lt(state->n_spots, SPOTS_MAX);
            double *v = state->values[state->n_spots];
            ck_assert_int_eq(sscanf(line, "at %d %lf %lf %lf %lf %lf %lf %lf %lf",
                                    &state->particle[state->n_spots], v, v + 1, v + 2, v + 3, v + 4, v + 5,
                                    v + 6, v + 7),
                             1 + QUANTITIES);
            state->n_spots++;
        } else
            ck_assert(sscanf(line, "dt %lf", &golden->dt) == 1 ||
                      sscanf(line, "particles %d %d", &golden->columns, &golden->rows) == 2 ||
                      sscanf(line, "nodes %d %d", &golden->gx, &golden->gy) == 2 ||
                      sscanf(line, "edge %lf %lf", &golden->xmin, &golden->ymin) == 2);
    }
    return false;
}

static void expect_close(const Golden *golden, const char *what, long step, double got, double expected,
                         double tolerance)
{
    ck_assert_msg(fabs(got - expected) <= tolerance,
                  "%s: %s at step %ld is %.17g, not %.17g (off %.3g, allowed %.3g)", golden->name, what, step,
                  got, expected, got - expected, tolerance);
}

/* The largest magnitude of a number in all states; velocities without the common speed. */
static double largest(const Golden *golden, int quantity)
{
    double most = 0;
    for (int s = 0; s < golden->n_states; s++)
        for (int k = 0; k < golden->states[s].n_spots; k++) {
            const double value = golden->states[s].values[k][quantity];
            most = fmax(most, fabs(quantity == 2 ? value - golden->def.speed : value));
        }
    return most;
}

static double largest_energy(const Golden *golden, int which)
{
    double most = 0;
    for (int s = 0; s < golden->n_states; s++)
        most = fmax(most, fabs(golden->states[s].energies[which]));
    return most;
}

/* What the grid sees with the supports of the step that was done. A grid that rides carries its nodes out of
 * the channel, and the reference looks before it lets them go; ours decides anew, as the next step will. */
static double seen_by_old_supports(const Golden *golden, Simulation *sim)
{
    Status status;
    unsigned char *bytes = snapshot_now(sim);
    ck_assert(simulation_stage(sim, &status));
    double *x = field_now(sim, 1, "x"), *m = field_now(sim, 1, "mass"), *px = field_now(sim, 1, "px");
    double *py = field_now(sim, 1, "py"), sum = 0;
    const double mouth = golden->def.grid_velocity * sim->dt + 1e-6 * golden->def.cell_size;
    for (size_t i = 0; i < sim->counts[1]; i++)
        if (m[i] > 1e-12) {
            const bool held = sim->step > 0 && x[i] <= mouth;
            const double along = px[i] - m[i] * golden->def.speed, across = held ? 0 : py[i];
            sum += (along * along + across * across) / m[i] / 2;
        }
    free(x), free(m), free(px), free(py);
    simulation_restore(sim, bytes);
    free(bytes);
    return sum * golden->def.thickness;
}

static void expect_energies(const Golden *golden, const State *state, Simulation *sim, double probe_most,
                            double loose)
{
    static const char *const energy_names[ENERGIES] = {"kinetic", NULL, "kinetic_grid", "strain",
                                                       "work",    NULL, "v_probe"};
    const double whole = largest_energy(golden, 0) + largest_energy(golden, 3);
    for (int k = 0; k < ENERGIES; k++)
        if (k == 2 && golden->def.grid_velocity > 0) /* of the guide */
            expect_close(golden, "kinetic_grid", state->step, seen_by_old_supports(golden, sim),
                         state->energies[k], 1e-11 * whole);
        else if (energy_names[k])
            expect_close(golden, energy_names[k], state->step, series_now(sim, energy_names[k]),
                         state->energies[k],
                         k == 4   ? 3e-8 * fmax(largest_energy(golden, 4), 1e-30)
                         : k == 6 ? loose * probe_most
                                  : fmax(1e-11, loose / 10) * whole);
    expect_close(golden, "u_probe", state->step, series_now(sim, "u_probe"), state->energies[5],
                 1e-14 * golden->def.length);
}

/* Stresses are held to the largest of any, velocities likewise. */
static void expect_spots(const Golden *golden, const State *state, const Simulation *sim, double loose)
{
    const double v = fmax(largest(golden, 2), largest(golden, 3));
    const double s = fmax(largest(golden, 4), fmax(largest(golden, 5), largest(golden, 6)));
    const double place = 1e-14 * golden->def.length;
    const double tolerance[QUANTITIES] = {place,     place,     loose * v, loose * v,
                                          loose * s, loose * s, loose * s, 1e-11 * golden->def.density};
    for (int q = 0; q < QUANTITIES; q++) {
        double *got = field_now(sim, 0, names[q]);
        for (int k = 0; k < state->n_spots; k++)
            expect_close(golden, names[q], state->step, got[state->particle[k]], state->values[k][q],
                         tolerance[q]);
        free(got);
    }
}

static void run_golden(Golden *golden)
{
    Status status = {0};
    /* 200 steps, as many as the grid has to reach */
    golden->def.end = 200 * golden->dt;
    Simulation *sim = mpm_create(&golden->def, &status);
    ck_assert_msg(sim != NULL, "%s: %s", golden->name, status.text);
    ck_assert_double_eq_tol(sim->dt, golden->dt, 1e-15 * golden->dt);
    ck_assert_uint_eq(sim->columns, (size_t)golden->columns);
    ck_assert_uint_eq(sim->rows, (size_t)golden->rows);
    ck_assert_uint_eq(sim->counts[1], (size_t)(golden->gx * golden->gy));
    double *x = field_now(sim, 1, "x"), *y = field_now(sim, 1, "y");
    ck_assert_double_eq_tol(x[0], golden->xmin, 1e-15);
    ck_assert_double_eq_tol(y[0], golden->ymin, 1e-15);
    free(x);
    free(y);
    /* boxes that move have light nodes, which two programs round differently */
    const double loose = golden->def.shape == MPM_HAT ? 3e-11 : golden->def.leaves_channel ? 1e-9 : 2e-11;
    const double v = fmax(largest(golden, 2), largest(golden, 3));
    for (int k = 0; k < golden->n_states; k++) {
        const State *state = &golden->states[k];
        advance(sim, state->step - sim->step);
        expect_spots(golden, state, sim, loose);
        expect_energies(golden, state, sim, v, loose);
    }
    simulation_destroy(sim);
}

START_TEST(golden_case)
{
    static Golden golden;
    FILE *file = fopen(source_path("tests/golden/mpm2d.txt"), "r");
    ck_assert_ptr_nonnull(file);
    for (int i = 0; i <= _i; i++)
        ck_assert(read_case(file, &golden));
    fclose(file);
    run_golden(&golden);
}
END_TEST

START_TEST(all_cases_are_there)
{
    static Golden golden;
    FILE *file = fopen(source_path("tests/golden/mpm2d.txt"), "r");
    ck_assert_ptr_nonnull(file);
    int count = 0;
    while (read_case(file, &golden)) {
        ck_assert_int_eq(golden.n_states, 4);
        count++;
    }
    fclose(file);
    ck_assert_int_eq(count, CASES);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *test = tcase_create("golden");
    tcase_add_test(test, all_cases_are_there);
    tcase_add_loop_test(test, golden_case, 0, CASES);
    suite_add_tcase(suite, test);
}

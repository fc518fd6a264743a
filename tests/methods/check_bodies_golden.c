/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bodies by the material point method against runs of independent programs, digit by digit. */
#include "base/text.h"
#include "methods/mpm/mpm.h"
#include "methods/run_case.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CASES = 11, QUANTITIES = 8, SUMS = 6, SPOTS_MAX = 32, TEXT_MAX = 400 };

static const char *const names[QUANTITIES] = {"x", "y", "vx", "vy", "sxx", "syy", "sxy", "density"};
static const char *const sums[SUMS] = {"kinetic",    "strain",     "potential",
                                       "momentum_x", "momentum_y", "angular"};

static int word_index(const char *word, const char *const *words)
{
    for (int i = 0; words[i]; i++)
        if (strcmp(word, words[i]) == 0)
            return i;
    ck_abort_msg("unknown word %s", word);
    return -1;
}

static bool set_number(MpmDef *def, const char *key, double value)
{
    const struct {
        const char *key;
        double *number;
    } numbers[] = {{"E", &def->youngs_modulus}, {"nu", &def->poisson},        {"rho", &def->density},
                   {"gx", &def->gravity[0]},    {"gy", &def->gravity[1]},     {"alpha", &def->flip_fraction},
                   {"mu", &def->friction},      {"muw", &def->wall_friction}, {"W", &def->length},
                   {"H", &def->height},         {"dx", &def->cell_size},      {"courant", &def->courant},
                   {"near", &def->gap}};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        if (strcmp(key, numbers[i].key) == 0) {
            *numbers[i].number = value;
            return true;
        }
    if (strcmp(key, "P") == 0)
        def->particles_per_cell = (int)value;
    else if (strcmp(key, "apic") == 0)
        def->transfer = value != 0 ? MPM_APIC : MPM_FLIP;
    else if (strcmp(key, "contact") == 0)
        def->fields = value != 0 ? FIELDS_EACH : FIELDS_ONE;
    else
        return false;
    return true;
}

static void set(MpmDef *def, const char *key, const char *value)
{
    static const char *const algorithms[] = {"usf", "usl", "musl", NULL};
    static const char *const shapes[] = {"hat", "gimp", "bspline2", NULL};
    static const char *const laws[] = {"hypo", "neo", "hypo0", NULL};
    static const char *const planes[] = {"strain", "stress", NULL};
    static const char *const walls[] = {"open", "clamp", "slip", "fric", NULL};
    static const char *const sides[] = {"left", "right", "bottom", "top", NULL};
    double number;
    if (text_to_double(value, &number) && set_number(def, key, number)) {
        if (def->gap == 9)
            def->gap = INFINITY;
    } else if (strcmp(key, "law") == 0) {
        def->law = word_index(value, laws) == 1 ? LAW_NEO_HOOKEAN : LAW_HYPOELASTIC;
        def->rotation = word_index(value, laws) == 2 ? ROTATION_NONE : ROTATION_JAUMANN;
    } else if (strcmp(key, "plane") == 0)
        def->plane = (BodyPlane)word_index(value, planes);
    else if (strcmp(key, "algo") == 0)
        def->algorithm = (MpmAlgorithm)word_index(value, algorithms);
    else if (strcmp(key, "shape") == 0)
        def->shape = (MpmShape)word_index(value, shapes);
    else
        def->walls[word_index(key, sides)] = (BodyWall)word_index(value, walls);
}

static void add_body(MpmDef *def, const char *line)
{
    static const char *const shapes[] = {"disc", "ring", "block", NULL};
    char word[20];
    double n[7];
    ck_assert_int_ge(sscanf(line, "body %19s %lf %lf %lf %lf %lf %lf %lf", word, n, n + 1, n + 2, n + 3,
                            n + 4, n + 5, n + 6),
                     7);
    BodyDef *body = &def->bodies[def->n_bodies];
    body->shape = (BodyShape)word_index(word, shapes);
    snprintf(body->name, sizeof body->name, "body%d", def->n_bodies++);
    const int sizes = body->shape == BODY_DISC ? 3 : 4;
    memcpy(body->size, n, (size_t)sizes * sizeof *n);
    memcpy(body->velocity, n + sizes, sizeof body->velocity);
    body->spin = n[sizes + 2];
}

/* --- a state against the run ------------------------------------------------------------------------ */

typedef struct State {
    long step;
    double sums[SUMS];
    int particle[SPOTS_MAX], count;
    double values[SPOTS_MAX][QUANTITIES];
} State;

/* 1e-9 of the column's largest; the block whose stress does not turn is sensitive to round-off. */
static void expect_state(const char *name, const MpmDef *def, const State *state, Simulation *sim)
{
    const double tolerance = strcmp(name, "spin-hat-hypo-unrotated") == 0 ? 1e-7 : 1e-9;
    advance(sim, state->step - sim->step);
    for (int q = 0; q < QUANTITIES; q++) {
        double *got = field_now(sim, 0, names[q]),
               most = q >= 4 && q < 7 ? 1e-6 * def->youngs_modulus : 1e-12;
        for (int k = 0; k < state->count; k++)
            most = fmax(most, fabs(state->values[k][q]));
        for (int k = 0; k < state->count; k++)
            ck_assert_msg(fabs(got[state->particle[k]] - state->values[k][q]) <= tolerance * most,
                          "%s: %s of particle %d at step %ld is %.17g, not %.17g (off %.2g of the largest)",
                          name, names[q], state->particle[k], state->step, got[state->particle[k]],
                          state->values[k][q], fabs(got[state->particle[k]] - state->values[k][q]) / most);
        free(got);
    }
    const double energy = fabs(state->sums[0]) + fabs(state->sums[1]) + fabs(state->sums[2]);
    const double mass = def->density * def->length * def->height, moment = sqrt(2 * energy * mass);
    for (int k = 0; k < SUMS; k++)
        ck_assert_double_eq_tol(series_now(sim, sums[k]), state->sums[k],
                                tolerance * (k < 3   ? energy
                                             : k < 5 ? moment
                                                     : moment * def->length));
}

static void run_golden(FILE *file, int which)
{
    static MpmDef def;
    static State state;
    char line[TEXT_MAX], name[80] = "", key[40], value[60];
    double dt = NAN;
    Simulation *sim = NULL;
    Status status = {0};
    int number = -1, particles = 0;
    def = (MpmDef){.problem = MPM_BODIES, .threads = 1};
    while (fgets(line, sizeof line, file)) {
        number += strncmp(line, "case ", 5) == 0;
        if (number != which)
            continue;
        double *v = state.values[state.count], *e = state.sums;
        const bool ends = strncmp(line, "end", 3) == 0 || strncmp(line, "state", 5) == 0;
        if (ends && sim && state.count > 0)
            expect_state(name, &def, &state, sim);
        if (strncmp(line, "end", 3) == 0)
            break;
        if (strncmp(line, "body ", 5) == 0)
            add_body(&def, line);
        else if (sscanf(line, "set %39s %59s", key, value) == 2)
            set(&def, key, value);
        else if (strncmp(line, "state", 5) == 0) {
            ck_assert_int_eq(sscanf(line, "state %ld %lf %lf %lf %lf %lf %lf", &state.step, e, e + 1, e + 2,
                                    e + 3, e + 4, e + 5),
                             1 + SUMS);
            state.count = 0;
        } else if (strncmp(line, "at", 2) == 0) {
            ck_assert_int_lt(state.count, SPOTS_MAX);
            ck_assert_int_eq(sscanf(line, "at %d %lf %lf %lf %lf %lf %lf %lf %lf",
                                    &state.particle[state.count++], v, v + 1, v + 2, v + 3, v + 4, v + 5,
                                    v + 6, v + 7),
                             1 + QUANTITIES);
        } else if (sscanf(line, "particles %d", &particles) == 1) {
            ck_assert_msg(mpm_check(&def, &status), "%s: %s", name, status.text);
            sim = mpm_create(&def, &status);
            ck_assert_msg(sim != NULL, "%s: %s", name, status.text);
            ck_assert_double_eq_tol(sim->dt, dt, 1e-15 * dt);
            ck_assert_uint_eq(sim->counts[0], (size_t)particles);
        } else
            ck_assert(sscanf(line, "case %79s", name) == 1 || sscanf(line, "dt %lf", &dt) == 1);
    }
    ck_assert_ptr_nonnull(sim);
    simulation_destroy(sim);
}

START_TEST(golden_case)
{
    FILE *file = fopen(source_path("tests/golden/bodies.txt"), "r");
    ck_assert_ptr_nonnull(file);
    run_golden(file, _i);
    fclose(file);
}
END_TEST

START_TEST(all_cases_are_there)
{
    FILE *file = fopen(source_path("tests/golden/bodies.txt"), "r");
    char line[TEXT_MAX];
    int count = 0;
    ck_assert_ptr_nonnull(file);
    while (fgets(line, sizeof line, file))
        count += strncmp(line, "case ", 5) == 0;
    fclose(file);
    ck_assert_int_eq(count, CASES);
}
END_TEST

void add_cases(Suite *suite)
{
    suite_fork();
    TCase *test = tcase_create("golden");
    tcase_add_test(test, all_cases_are_there);
    tcase_add_loop_test(test, golden_case, 0, CASES);
    suite_add_tcase(suite, test);
}

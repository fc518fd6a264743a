/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A thing that is followed is a column more, and nothing else: the same bits in all others, the values that
 * its table has, whatever way the run is gone. */
#include "suite.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "problems/problem.h"
#include "run/experiment.h"
#include "scenario/parameters.h"
#include "scenario/scenario.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 60, COLUMNS = 40 };

static const struct {
    const char *scenario, *follow[2];
    struct {
        int set;
        size_t index;
        const char *field;
    } of[2];
} cases[] = {
    {"mode5", {"particle 12 velocity", "node 7 momentum"}, {{0, 12, "v"}, {1, 7, "momentum"}}},
    {"crossing", {"node 9 f", "particle 3 u"}, {{1, 9, "f"}, {0, 3, "u"}}},
    {"supported-beam-coarse", {"particle 40 uy", "particle 7 uy"}, {{0, 40, "uy"}, {0, 7, "uy"}}},
};

static Simulation *simulate(const char *scenario)
{
    Settings settings;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scenario_load(scenario, &settings, &status), "%s", status.text);
    Simulation *sim = problem_simulate(&settings, 1, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    return sim;
}

/* As its table is written: after the stages that make it ready, which are then taken back. */
static double in_table(Simulation *sim, int set, size_t index, const char *field)
{
    double value;
    void *bytes = malloc(simulation_snapshot_size(sim));
    simulation_snapshot(sim, bytes);
    for (int i = 0; i < sim->sets[set].ready_after; i++)
        ck_assert(simulation_stage(sim, NULL));
    sim->method->field(sim, simulation_find_field(sim, set, field), index, 1, &value);
    simulation_restore(sim, bytes);
    free(bytes);
    return value;
}

START_TEST(it_is_a_column_and_nothing_else)
{
    Simulation *plain = simulate(cases[_i].scenario), *followed = simulate(cases[_i].scenario);
    Status status = {STATUS_DONE, ""};
    for (int i = 0; i < 2; i++)
        ck_assert_msg(simulation_follow(followed, cases[_i].follow[i], &status), "%s", status.text);
    const int own = plain->n_series;
    ck_assert_int_eq(followed->n_series, own + 2);
    double *rows = malloc(STEPS * COLUMNS * sizeof *rows), *others = malloc(STEPS * COLUMNS * sizeof *others);
    ck_assert(simulation_steps(plain, STEPS, rows, NULL, &status));
    ck_assert(simulation_steps(followed, STEPS, others, NULL, &status));
    for (int k = 0; k < STEPS; k++)
        ck_assert_int_eq(memcmp(rows + k * own, others + k * (own + 2), (size_t)own * sizeof *rows), 0);
    ck_assert_int_eq(followed->step, STEPS);
    ck_assert_int_eq(followed->stage, 0);
    for (int i = 0; i < 2; i++) {
        const double value =
            in_table(plain, cases[_i].of[i].set, cases[_i].of[i].index, cases[_i].of[i].field);
        ck_assert_double_eq(others[(STEPS - 1) * (own + 2) + own + i], value);
        ck_assert_double_ne(value, others[own + i]); /* it moves */
    }
    double row[COLUMNS];
    simulation_row(followed, row);
    ck_assert_int_eq(memcmp(row, others + (STEPS - 1) * (own + 2), (size_t)(own + 2) * sizeof *row), 0);
    free(rows);
    free(others);
    simulation_destroy(plain);
    simulation_destroy(followed);
}
END_TEST

static const char *const bad[][2] = {
    {"", "is nothing to follow (particle NUMBER FIELD"},
    {"particle", "is nothing to follow"},
    {"particle 12", "is nothing to follow"},
    {"bond 3 stretch", "is nothing to follow"},
    {"particle -1 v", "\"particle -1 v\" is nothing to follow"},
    {"particle +1 v", "\"particle +1 v\" is nothing to follow"},
    {"particle 50 v", "there is no particle 50 (0 to 49)"},
    {"particle 12 colour", "colour is not a field of a particle (x0 |"},
};

START_TEST(what_is_not_there_is_refused)
{
    Simulation *sim = simulate("mode5");
    Status status = {STATUS_DONE, ""};
    const int own = sim->n_series;
    ck_assert(!simulation_follow(sim, bad[_i][0], &status));
    ck_assert_msg(strstr(status.text, bad[_i][1]) != NULL, "%s", status.text);
    ck_assert_int_eq(sim->n_series, own);
    simulation_destroy(sim);
}
END_TEST

START_TEST(not_more_than_a_few)
{
    Simulation *sim = simulate("mode5");
    Status status = {STATUS_DONE, ""};
    char thing[FOLLOW_TEXT_MAX];
    for (int i = 0; i < FOLLOW_MAX; i++) {
        snprintf(thing, sizeof thing, "particle %d v", i);
        ck_assert(simulation_follow(sim, thing, &status));
        ck_assert(!simulation_follow(sim, thing, &status));
    }
    ck_assert(!simulation_follow(sim, "particle 20 v", &status));
    simulation_destroy(sim);
}
END_TEST

/* The curves of a run stay when another one takes its place, and so do the names of what it followed. */
START_TEST(a_ghost_keeps_its_names)
{
    Settings settings;
    Status status = {STATUS_DONE, ""};
    ck_assert(scenario_load("mode5", &settings, &status));
    strcpy(settings_edit_output(&settings)->follow, "particle 12 velocity");
    Experiment *experiment = experiment_create(&settings, 1 << 20, 1, &status);
    ck_assert_msg(experiment != NULL, "%s", status.text);
    ck_assert(experiment_advance(experiment, 20, &status));
    ck_assert(experiment_pin(experiment, &status));
    settings = *experiment_settings(experiment);
    settings_edit_output(&settings)->follow[0] = '\0';
    ck_assert(settings_set(&settings, "mesh.cell_size", "0.5", &status));
    ck_assert_msg(experiment_edit(experiment, &settings, &status), "%s", status.text);
    const Ghost *ghost = experiment_ghosts(experiment);
    bool named = false;
    for (int i = 0; i < ghost->n_columns; i++)
        named |= strstr(ghost->columns[i].quantity.label, "of particle 12") != NULL;
    ck_assert(ghost->used && named);
    experiment_destroy(experiment);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("follow");
    tcase_add_loop_test(tcase, it_is_a_column_and_nothing_else, 0, sizeof cases / sizeof *cases);
    tcase_add_loop_test(tcase, what_is_not_there_is_refused, 0, sizeof bad / sizeof *bad);
    tcase_add_test(tcase, not_more_than_a_few);
    tcase_add_test(tcase, a_ghost_keeps_its_names);
    suite_add_tcase(suite, tcase);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contract of method.h, held by assertions whatever the build: these files are compiled into the test
 * with assertions switched on, in place of the library's. */
#define MATVIB_ASSERTIONS 1
#include "methods/method.c"

#include "methods/mpm/fields.c"
#include "methods/mpm/links.c"

#include "methods/bar_case.h"
#include "suite.h"

#include <signal.h>

static Simulation *half_way(void)
{
    BarCase bar = bar_case(1, 0.1);
    Simulation *sim = bar_case_create(&bar);
    ck_assert(simulation_stage(sim, NULL));
    return sim;
}

START_TEST(promises_kept_are_silent)
{
    double row[16], out[4];
    Link links[8];
    Simulation *sim = half_way();
    ck_assert(simulation_steps(sim, 0, NULL, NULL, NULL));
    simulation_row(sim, row);
    sim->method->field(sim, 0, sim->counts[0] - 4, 4, out);
    ck_assert_uint_gt(sim->method->links(sim, 0, sim->counts[0] - 1, links, 8), 0);
    simulation_destroy(sim);
}
END_TEST

START_TEST(a_row_in_mid_step)
{
    double row[16];
    simulation_row(half_way(), row);
}
END_TEST

START_TEST(a_negative_number_of_steps)
{
    simulation_steps(half_way(), -1, NULL, NULL, NULL);
}
END_TEST

START_TEST(a_field_that_is_not_there)
{
    double out[1];
    Simulation *sim = half_way();
    sim->method->field(sim, sim->n_fields, 0, 1, out);
}
END_TEST

START_TEST(a_particle_too_many)
{
    double out[8];
    Simulation *sim = half_way();
    sim->method->field(sim, 0, sim->counts[0] - 4, 5, out);
}
END_TEST

START_TEST(the_links_of_nothing)
{
    Link links[8];
    Simulation *sim = half_way();
    sim->method->links(sim, 1, sim->counts[1], links, 8);
}
END_TEST

/* --- what is followed --- */

static bool no_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status)
{
    (void)sim, (void)stage, (void)first, (void)end, (void)status;
    return true;
}

static void no_row(Simulation *sim, double *row)
{
    (void)sim;
    row[0] = 1;
}

static void not_a_number(const Simulation *sim, int field, size_t first, size_t count, double *out)
{
    (void)sim, (void)first;
    for (size_t i = 0; i < count; i++)
        out[i] = field == 0 ? NAN : INFINITY;
}

static size_t no_state(const Simulation *sim)
{
    (void)sim;
    return 0;
}

static void load_nothing(Simulation *sim, const void *bytes)
{
    (void)sim, (void)bytes;
}

static void free_nothing(Simulation *sim)
{
    (void)sim;
}

/* What has no value is told as having none, not as 0; of a set that is not ready between steps too. */
START_TEST(what_is_no_number_stays_none)
{
    static const Method method = {.stage = no_stage,
                                  .row = no_row,
                                  .field = not_a_number,
                                  .state_size = no_state,
                                  .load = load_nothing,
                                  .destroy = free_nothing};
    const Set set = {"thing", "things", _i};
    static const Field two_fields[] = {{{"a", "a", "1", "none"}, 0, true, false, 0, 0},
                                       {{"b", "b", "1", "too large"}, 0, true, false, 0, 0}};
    static const Stage stages[2] = {{.id = "one"}, {.id = "two"}};
    static const Quantity series[] = {{"c", "c", "1", "a column"}};
    Simulation sim = {.method = &method,
                      .state = &method, /* of which nothing is kept */
                      .sets = &set,
                      .n_sets = 1,
                      .counts = {3},
                      .fields = two_fields,
                      .n_fields = 2,
                      .stages = stages,
                      .n_stages = 2,
                      .stage_items = 1,
                      .series = series,
                      .n_series = 1};
    double row[3] = {0};
    ck_assert(simulation_follow(&sim, "thing 2 a", NULL));
    ck_assert(simulation_follow(&sim, "thing 0 b", NULL));
    simulation_row(&sim, row);
    ck_assert(row[0] == 1 && isnan(row[1]) && isinf(row[2]));
    ck_assert(sim.step == 0 && sim.stage == 0);
    simulation_destroy(&sim);
}
END_TEST

void add_cases(Suite *suite)
{
    suite_fork();
    TCase *follow = tcase_create("follow");
    tcase_add_loop_test(follow, what_is_no_number_stays_none, 0, 2);
    suite_add_tcase(suite, follow);
    TCase *contract = tcase_create("contract");
    tcase_add_test(contract, promises_kept_are_silent);
    tcase_add_test_raise_signal(contract, a_row_in_mid_step, SIGABRT);
    tcase_add_test_raise_signal(contract, a_negative_number_of_steps, SIGABRT);
    tcase_add_test_raise_signal(contract, a_field_that_is_not_there, SIGABRT);
    tcase_add_test_raise_signal(contract, a_particle_too_many, SIGABRT);
    tcase_add_test_raise_signal(contract, the_links_of_nothing, SIGABRT);
    suite_add_tcase(suite, contract);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contract of method.h, held by assertions whatever the build: these two files are compiled into the test
 * with assertions switched on, in place of the library's. */
#define MATVIB_ASSERTIONS 1
#include "physics/method.c"

#include "physics/mpm_bar/bar_fields.c"

#include "physics/bar_case.h"
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

void add_cases(Suite *suite)
{
    TCase *contract = tcase_create("contract");
    tcase_add_test(contract, promises_kept_are_silent);
    tcase_add_test_raise_signal(contract, a_row_in_mid_step, SIGABRT);
    tcase_add_test_raise_signal(contract, a_negative_number_of_steps, SIGABRT);
    tcase_add_test_raise_signal(contract, a_field_that_is_not_there, SIGABRT);
    tcase_add_test_raise_signal(contract, a_particle_too_many, SIGABRT);
    tcase_add_test_raise_signal(contract, the_links_of_nothing, SIGABRT);
    suite_add_tcase(suite, contract);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The paper's notched beam to the end: when and where it cracks (paper P, figs. 9 and 10), with the numbers
 * of an independent program and the tolerances that its own sensitivity asks for. */
#include "methods/beam_case.h"
#include "methods/default_defs.h"
#include "methods/bonds/cracks/crack.h"
#include "methods/bonds/cracks/crack_cost.h"
#include "suite.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

typedef struct TipAt {
    long step;
    double x, y; /* mm */
} TipAt;

static void expect_balance(Simulation *sim)
{
    double total = series_now(sim, "total"), work = series_now(sim, "work");
    ck_assert_msg(fabs(total - work) < 1e-3 * work, "energy %.6g, work %.6g at step %ld", total, work,
                  sim->step);
}

START_TEST(the_crack_goes_as_the_paper_says)
{
    static const TipAt tips[] = {{1040, 66.8, 22.8}, {1360, 74.3, 36.8},  {1680, 85.8, 51.8},
                                 {2000, 94.8, 59.8}, {2320, 100.3, 65.3}, {2480, 100.8, 66.3}};
    BeamDef def = beam_default(BEAM_NOTCHED);
    def.threads = 2;
    Simulation *sim = beam_case_create(&def, NULL);
    Crack crack;
    for (size_t k = 0; k < sizeof tips / sizeof *tips; k++) {
        advance(sim, tips[k].step - sim->step);
        ck_assert(crack_measure(sim, &crack));
        ck_assert_msg(fabs(crack.x * 1e3 - tips[k].x) < 1 && fabs(crack.y * 1e3 - tips[k].y) < 1,
                      "tip at %.2f, %.2f mm at step %ld", crack.x * 1e3, crack.y * 1e3, sim->step);
        ck_assert_msg(fabs(series_now(sim, "crack_y") - crack.y) < 1e-12, "the series tells another tip");
        expect_balance(sim);
        ck_assert_double_eq_tol(crack.first_break, 73.4e-6, 2e-6);
        ck_assert_double_eq_tol(crack.twentieth_break, 82.8e-6, 2e-6);
        if (!suite_wide()) {
            simulation_destroy(sim);
            return;
        }
    }
    ck_assert_msg(crack.arrival > 235e-6 && crack.arrival < 256e-6, "arrived at %.4g s", crack.arrival);
    advance(sim, 3000 - sim->step);
    expect_balance(sim);
    ck_assert_double_eq_tol(crack_angle(sim, 0.010), 26, 3);
    ck_assert_double_eq_tol(crack_angle(sim, 0.020), 29, 3);
    ck_assert_double_eq_tol(crack_angle(sim, 0.038), 35, 3);
    ck_assert(crack_measure(sim, &crack));
    ck_assert_msg(labs(crack.broken - 6941) < 70, "%ld bonds broken", crack.broken);
    /* an independent program has 879 m/s with the tip's path smoothed over nine rows, 838 over twice the
     * time; Rayleigh's speed is 2134 */
    ck_assert_double_eq_tol(crack.fastest, 879, 0.02 * 879);
    /* G0 = 35.68: what the path's own bonds take lies below it, what is dissipated above */
    CrackCost cost;
    ck_assert(crack_cost(sim, &(Cancel){0}, &cost));
    ck_assert_double_eq_tol(cost.plane / 35.68, 0.9537, 2e-4);
    ck_assert_double_eq_tol(cost.total / cost.area, 40.8, 0.5);
    ck_assert_double_eq_tol(cost.through / cost.area, 31.2, 1);
    ck_assert_double_eq_tol(cost.beside / cost.area, 9.0, 0.5);
    simulation_destroy(sim);
}
END_TEST

/* The load's width rules the start: five millimetres instead of three bring it forward by a quarter. */
typedef struct Asked {
    int count, most;
    double share;
} Asked;

static bool goes_on(double share, void *context)
{
    Asked *asked = context;
    ck_assert_msg(asked->count == 0 ? share == 0 : share > asked->share && share <= 1, "%g after %g", share,
                  asked->share);
    asked->share = share;
    return ++asked->count <= asked->most;
}

/* A shattered plate and a path of many pieces: it is asked often enough, from 0 on, and given up at each
 * answer; what it comes to does not depend on who asks. */
START_TEST(a_cost_can_be_given_up)
{
    enum { PIECES = 30000 };
    static double x[PIECES], y[PIECES];
    for (int k = 0; k < PIECES; k++)
        x[k] = 0.02 + 1e-6 * k, y[k] = 0.02;
    const BeamDef def = struck_plate();
    Simulation *sim = beam_case_create(&def, NULL);
    advance(sim, 700);
    const double pairs = series_now(sim, "broken_bonds") * (PIECES + 1);
    const CrackPath path = {PIECES, x, y};
    CrackCost alone, cost;
    Asked asked = {0, INT_MAX, 0};
    ck_assert(crack_cost_along(sim, &path, 1, 0.03, &(Cancel){0}, &alone));
    ck_assert(crack_cost_along(sim, &path, 1, 0.03, &(Cancel){goes_on, &asked}, &cost));
    ck_assert_mem_eq(&alone, &cost, sizeof cost);
    ck_assert_double_gt(cost.far, 0);
    ck_assert_msg(asked.count > 3 && asked.count > 0.7 * pairs / CRACK_COST_PAIRS_A_QUESTION,
                  "asked %d times over %g pairs", asked.count, pairs);
    for (int most = 0; most < 3; most++) {
        asked = (Asked){0, most, 0};
        ck_assert(!crack_cost_along(sim, &path, 1, 0.03, &(Cancel){goes_on, &asked}, &cost));
        ck_assert_int_eq(asked.count, most + 1);
    }
    simulation_destroy(sim);
}
END_TEST

/* A row of bonds' middles a little farther than a horizon from the path is not beside it: as when it lies
 * twice as far beyond, with nothing else passed on the way. */
START_TEST(beside_is_within_a_horizon)
{
    const BeamDef def = struck_plate();
    Simulation *sim = beam_case_create(&def, NULL);
    advance(sim, 700);
    double beside = 0;
    for (int row = 20; row < 60; row++) {
        CrackCost cost[2];
        for (int k = 0; k < 2; k++) {
            const double level = row * def.spacing / 2 - (k == 0 ? 1.004 : 1.02) * def.horizon;
            double x[2] = {-1, 1}, y[2] = {level, level};
            ck_assert(crack_cost_along(sim, &(CrackPath){2, x, y}, 1, 0.03, &(Cancel){0}, &cost[k]));
        }
        ck_assert_double_eq(cost[0].beside, cost[1].beside);
        ck_assert_double_eq(cost[0].far, cost[1].far);
        beside += cost[0].beside;
    }
    ck_assert_double_gt(beside, 0);
    simulation_destroy(sim);
}
END_TEST

START_TEST(a_wider_load_cracks_earlier)
{
    BeamDef def = beam_default(BEAM_NOTCHED);
    def.threads = 2;
    def.load_width = 0.005;
    Simulation *sim = beam_case_create(&def, NULL);
    advance(sim, 700);
    Crack crack;
    ck_assert(crack_measure(sim, &crack));
    ck_assert_msg(crack.first_break < 60e-6 && crack.twentieth_break < 65e-6, "started at %.4g and %.4g s",
                  crack.first_break, crack.twentieth_break);
    simulation_destroy(sim);
}
END_TEST

/* What broken bonds took from the motion closes the balance to second order in the step, and is what the
 * shares of the cost come to. */
START_TEST(half_the_step_is_off_by_a_quarter)
{
    double off[2];
    for (int k = 0; k < 2; k++) {
        BeamDef def = small_beam(BEAM_NOTCHED);
        CrackCost cost;
        def.dt /= k + 1;
        Simulation *sim = beam_case_create(&def, NULL);
        advance(sim, 900 * (k + 1));
        ck_assert(crack_cost(sim, &(Cancel){0}, &cost));
        ck_assert_double_gt(cost.through, 0);
        ck_assert_double_eq_tol(cost.through + cost.beside + cost.far, series_now(sim, "dissipated"),
                                1e-12 * cost.total);
        off[k] = fabs(series_now(sim, "total") / series_now(sim, "work") - 1);
        simulation_destroy(sim);
    }
    ck_assert_msg(off[0] < 1e-3 && off[1] < 0.35 * off[0], "%.3g at dt, %.3g at dt/2", off[0], off[1]);
}
END_TEST

/* Lengths and times of a notched beam times a factor: the same crack, the same shares of its cost. */
START_TEST(similar_beams_crack_alike)
{
    double angle = 0, length = 0, shares[2] = {0, 0};
    for (int k = 0; k < 2; k++) {
        const double factor = k == 0 ? 1 : 1e3;
        BeamDef def = small_beam(BEAM_NOTCHED);
        double *const lengths[] = {
            &def.length,     &def.height,         &def.horizon,       &def.spacing,
            &def.load_ramp,  &def.notch_position, &def.notch_depth,   &def.load_position,
            &def.load_width, &def.support_left,   &def.support_right, &def.protected_depth,
            &def.dt};
        for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++)
            *lengths[i] *= factor;
        Simulation *sim = beam_case_create(&def, NULL);
        Crack crack;
        CrackCost cost;
        advance(sim, 900);
        ck_assert(crack_measure(sim, &crack) && crack.begun && crack_cost(sim, &(Cancel){0}, &cost));
        if (k == 0) {
            angle = crack_angle(sim, INFINITY);
            length = crack.length;
            shares[0] = cost.through / cost.total, shares[1] = cost.beside / cost.total;
            ck_assert(isfinite(angle) && length > 0);
        }
        ck_assert_double_eq_tol(crack_angle(sim, INFINITY), angle, 1e-9);
        ck_assert_double_eq_tol(crack.length / factor, length, 1e-9 * length);
        ck_assert_double_eq_tol(cost.through / cost.total, shares[0], 1e-9);
        ck_assert_double_eq_tol(cost.beside / cost.total, shares[1], 1e-9);
        simulation_destroy(sim);
    }
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *paper = tcase_create("paper");
    tcase_add_test(paper, the_crack_goes_as_the_paper_says);
    if (suite_wide()) /* seconds */
        tcase_add_test(paper, a_wider_load_cracks_earlier);
    TCase *cost = tcase_create("cost");
    tcase_add_test(cost, a_cost_can_be_given_up);
    tcase_add_test(cost, beside_is_within_a_horizon);
    tcase_add_test(cost, similar_beams_crack_alike);
    suite_add_tcase(suite, cost);
    tcase_add_test(paper, half_the_step_is_off_by_a_quarter);
    suite_add_tcase(suite, paper);
}

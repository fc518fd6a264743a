/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cracks of plates against the runs of independent programs (tests/golden/plates.txt holds these runs
 * digit by digit): where and when they branch, how fast they run, at which angle; and that what is told at a
 * step does not depend on the way there. Angles and speeds as the reference rounded or smoothed them: within
 * what its own definition leaves open, less than half a degree and one in a hundred. */
#include "answers/crack_growth.h"
#include "scenario/settings.h"
#include "problems/problem.h"
#include "run/lab_case.h"
#include "methods/bonds/cracks/crack.h"
#include "methods/bonds/cracks/fronts.h"
#include "methods/run_case.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const glass[] = {"plate.length",
                                    ".1",
                                    "plate.height",
                                    ".04",
                                    "plate.youngs_modulus",
                                    "65e9",
                                    "plate.density",
                                    "2235",
                                    "pd.critical_energy",
                                    "204",
                                    "cuts.notch",
                                    "0 .02 .05 .02",
                                    "loads.top",
                                    "top 0 100% 0 12e6",
                                    "loads.bottom",
                                    "bottom 0 100% 0 -12e6",
                                    "time.end",
                                    "50e-6",
                                    NULL};
static const char *const struck[] = {"plate.length",
                                     ".1",
                                     "plate.height",
                                     ".2",
                                     "plate.youngs_modulus",
                                     "190e9",
                                     "plate.density",
                                     "8000",
                                     "pd.critical_energy",
                                     "22170",
                                     "cuts.low",
                                     "0 .075 .05 .075",
                                     "cuts.high",
                                     "0 .125 .05 .125",
                                     "supports.blow",
                                     "0 .075 .0009 .125 ux 16.5",
                                     "time.end",
                                     "100e-6",
                                     NULL};

static Simulation *plate_with(const char *const keys[], const char *spacing, const char *horizon,
                              const char *step, const char *other_cut)
{
    Settings settings;
    Status status = {0};
    settings_default(&settings, &problem_plate);
    for (int i = 0; keys[i]; i += 2)
        set(&settings, keys[i], keys[i + 1]);
    set(&settings, "pd.spacing", spacing);
    set(&settings, "pd.horizon", horizon);
    set(&settings, "time.step", step);
    if (other_cut)
        set(&settings, "cuts.other", other_cut);
    ck_assert_msg(settings_check(&settings, &status), "%s", status.text);
    Simulation *sim = problem_simulate(&settings, 1, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    return sim;
}

static Simulation *plate(const char *const keys[], const char *spacing, const char *horizon, const char *step)
{
    return plate_with(keys, spacing, horizon, step, NULL);
}

static void steps(Simulation *sim, long count)
{
    Status status = {0};
    long done;
    ck_assert_msg(simulation_steps(sim, count, NULL, &done, &status), "%s", status.text);
    ck_assert_int_eq(done, count);
}

static void expect_within(const char *what, double value, double expected, double allowed)
{
    ck_assert_msg(fabs(value - expected) <= allowed, "%s is %.8g, expected %.8g within %g", what, value,
                  expected, allowed);
}

static const struct {
    const char *spacing, *horizon, *step;
    long steps;
    double x, time, half_angle, fastest; /* NAN: not told */
} branches[] = {
    {".001", ".004", "2e-7", 250, .0815, NAN, NAN, NAN},
    {".0005", ".002", "1e-7", 500, .06975, 26e-6, 26.4, 1854},
};

START_TEST(a_crack_branches_where_and_when_the_reference_does)
{
    Simulation *sim = plate(glass, branches[_i].spacing, branches[_i].horizon, branches[_i].step);
    CrackFronts fronts = {0};
    steps(sim, branches[_i].steps);
    ck_assert(crack_fronts_update(&fronts, sim));
    ck_assert_int_eq(fronts.count, 1);
    const CrackFront *front = &fronts.fronts[0];
    ck_assert(front->begun && front->branched);
    ck_assert_int_eq(front->n_tips, 2);
    expect_within("x of the branch", front->branch[0], branches[_i].x, 1e-9);
    expect_within("y of the branch", front->branch[1], .02, 1e-9);
    expect_within("the tips' heights together", front->tips[0][1] + front->tips[1][1], .04, 1e-9);
    if (isfinite(branches[_i].time)) {
        expect_within("time of the branch", front->branch_time, branches[_i].time, 1e-12);
        expect_within("half angle", front->half_angle, branches[_i].half_angle, .05);
        expect_within("largest speed", front->fastest, branches[_i].fastest, .01 * branches[_i].fastest);
    }
    /* three paths: as far as there is one crack, and the branches */
    ck_assert_int_eq(front->n_paths, 3);
    ck_assert(fronts.length > front->advance && fronts.surface > fronts.length);
    crack_fronts_free(&fronts);
    simulation_destroy(sim);
}
END_TEST

START_TEST(struck_between_two_cuts_cracks_turn_as_in_the_reference)
{
    Simulation *sim = plate(struck, ".001", ".004", "2e-7");
    CrackFronts fronts = {0};
    steps(sim, 500);
    ck_assert(crack_fronts_update(&fronts, sim));
    ck_assert_int_eq(fronts.count, 2);
    for (int f = 0; f < 2; f++) {
        const CrackFront *front = &fronts.fronts[f];
        ck_assert_int_eq(front->axis, 1);
        ck_assert_int_eq(front->sign, f == 0 ? -1 : 1);
        ck_assert(!front->branched);
        expect_within("angle over 70 mm", crack_fronts_angle(front, .07), 63.6, .5);
    }
    expect_within("both as far", fronts.fronts[0].advance, fronts.fronts[1].advance, 1e-12);
    crack_fronts_free(&fronts);
    simulation_destroy(sim);
}
END_TEST

/* A crack that passes the end of another cut at 10 mm is still its own, and none of that cut's; young, it
 * runs straight on, or no angle is told. */
START_TEST(a_crack_stays_that_of_its_cut)
{
    Simulation *sim = plate_with(glass, ".0005", ".002", "1e-7", ".06 .01 .1 .01");
    CrackFronts fronts = {0};
    bool has_begun = false;
    for (int i = 0; i < 22; i++) {
        steps(sim, 10);
        ck_assert(crack_fronts_update(&fronts, sim));
        ck_assert_int_eq(fronts.count, 2);
        const CrackFront *own = &fronts.fronts[0], *other = &fronts.fronts[1];
        ck_assert_str_eq(own->cut, "notch");
        ck_assert_msg(!(own->angle > 30), "%g degrees at step %ld", own->angle, sim->step);
        ck_assert_msg(!(own->fastest > .6 * crack_speed_rayleigh(65e9, 2235)), "%g m/s at step %ld",
                      own->fastest, sim->step);
        ck_assert_msg(!(other->fastest > .6 * crack_speed_rayleigh(65e9, 2235)), "%g m/s at step %ld",
                      other->fastest, sim->step);
        has_begun = has_begun || (own->begun && isnan(own->angle));
    }
    ck_assert_msg(has_begun, "never young");
    expect_within("advance", fronts.fronts[0].advance, .02, .01);
    crack_fronts_free(&fronts);
    simulation_destroy(sim);
}
END_TEST

/* A front that meets what was torn before did not run there. */
START_TEST(joining_is_no_speed)
{
    const char *torn[sizeof glass / sizeof *glass];
    memcpy(torn, glass, sizeof glass);
    for (size_t i = 0; torn[i]; i++)
        if (strstr(torn[i], "12e6"))
            torn[i] = strchr(torn[i], '-') ? "bottom 0 100% 0 -40e6" : "top 0 100% 0 40e6";
    Simulation *sim = plate(torn, ".0005", ".002", "1e-7");
    CrackFronts fronts = {0};
    steps(sim, 500);
    ck_assert(crack_fronts_update(&fronts, sim));
    const CrackFront *front = &fronts.fronts[0];
    double jump = 0;
    for (size_t k = 1; k < fronts.n_samples; k++)
        jump = fmax(jump, front->advances[k] - front->advances[k - 1]);
    ck_assert_msg(jump > .002, "nothing is met: %g", jump);
    ck_assert_msg(front->fastest > 0 && front->fastest < crack_speed_rayleigh(65e9, 2235), "%g m/s",
                  front->fastest);
    crack_fronts_free(&fronts);
    simulation_destroy(sim);
}
END_TEST

/* One state later worked out anew, or from nothing: the same. Before anything broke there is nothing, though
 * the nodes beside the cut are damaged from the start. */
START_TEST(fronts_do_not_remember)
{
    Simulation *sim = plate(glass, ".001", ".004", "2e-7");
    CrackFronts kept = {0}, anew = {0};
    ck_assert(crack_fronts_update(&kept, sim));
    ck_assert(!kept.fronts[0].begun && kept.fronts[0].n_tips == 0 && kept.length == 0);
    for (int i = 0; i < 5; i++) {
        steps(sim, 47);
        ck_assert(crack_fronts_update(&kept, sim));
        ck_assert(crack_fronts_update(&anew, sim));
        ck_assert_int_eq(kept.fronts[0].n_tips, anew.fronts[0].n_tips);
        ck_assert(kept.fronts[0].advance == anew.fronts[0].advance && kept.length == anew.length);
        ck_assert(kept.n_samples == (size_t)sim->step + 1);
        ck_assert(kept.fronts[0].advances[sim->step] == kept.fronts[0].advance);
        crack_fronts_free(&anew);
    }
    crack_fronts_free(&kept);
    simulation_destroy(sim);
}
END_TEST

/* Nearer to an end of the record than half the window there is no speed. */
START_TEST(a_speed_needs_its_window)
{
    Simulation *sim = plate(glass, ".001", ".004", "2e-7");
    CrackFronts fronts = {0};
    steps(sim, 100);
    ck_assert(crack_fronts_update(&fronts, sim));
    const size_t half = fronts.window / 2;
    ck_assert(isnan(crack_fronts_speed(&fronts, &fronts.fronts[0], half - 1)));
    ck_assert(isfinite(crack_fronts_speed(&fronts, &fronts.fronts[0], half)));
    ck_assert(isfinite(crack_fronts_speed(&fronts, &fronts.fronts[0], 100 - half)));
    ck_assert(isnan(crack_fronts_speed(&fronts, &fronts.fronts[0], 101 - half)));
    expect_within("the window", (double)(fronts.window - 1) * fronts.every, 4 * .004 / 3036.259,
                  fronts.every);
    crack_fronts_free(&fronts);
    simulation_destroy(sim);
}
END_TEST

/* Of several cracks that branched the earliest is told, whichever cut comes first. */
START_TEST(the_first_branch_is_told)
{
    static CrackFronts fronts = {.count = 3};
    for (int f = 0; f < fronts.count; f++)
        fronts.fronts[f] = (CrackFront){.branched = true,
                                        .branch = {.01 * (f + 1), .02},
                                        .branch_time = 1e-6 * ((f + _i) % 3 + 1),
                                        .half_angle = 10 * (f + 1),
                                        .fastest = NAN,
                                        .angle = NAN};
    FrontsFacts facts;
    crack_fronts_facts(&fronts, &facts);
    const int first = (3 - _i) % 3;
    ck_assert(facts.branched);
    ck_assert(facts.branch_time == 1e-6);
    ck_assert(facts.branch[0] == .01 * (first + 1) && facts.half_angle == 10 * (first + 1));
}
END_TEST

/* Lengths and times of a body times a factor, and the energy of its cracks: the same cracks. */
static CrackFront similar(double factor)
{
    static const char *const lengths[] = {"plate.length", "plate.height", "pd.spacing",
                                          "pd.horizon",   "time.step",    "time.end"};
    static const double values[] = {.1, .04, 5e-4, 2e-3, 1e-7, 50e-6};
    Settings settings;
    Status status = {0};
    char text[128];
    settings_default(&settings, &problem_plate);
    for (size_t k = 0; k < sizeof values / sizeof *values; k++) {
        snprintf(text, sizeof text, "%.17g", factor * values[k]);
        set(&settings, lengths[k], text);
    }
    snprintf(text, sizeof text, "%.17g", factor * 204);
    set(&settings, "pd.critical_energy", text);
    snprintf(text, sizeof text, "0 %.17g %.17g %.17g", .02 * factor, .05 * factor, .02 * factor);
    set(&settings, "cuts.notch", text);
    snprintf(text, sizeof text, "top 0 %.17g 0 12e6", .1 * factor);
    set(&settings, "loads.top", text);
    snprintf(text, sizeof text, "bottom 0 %.17g 0 -12e6", .1 * factor);
    set(&settings, "loads.bottom", text);
    set(&settings, "plate.youngs_modulus", "65e9");
    set(&settings, "plate.density", "2235");
    ck_assert_msg(settings_check(&settings, &status), "%s", status.text);
    Simulation *sim = problem_simulate(&settings, 1, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    CrackFronts fronts = {0};
    steps(sim, 400);
    ck_assert(crack_fronts_update(&fronts, sim));
    ck_assert_int_eq(fronts.count, 1);
    const CrackFront front = fronts.fronts[0];
    crack_fronts_free(&fronts);
    simulation_destroy(sim);
    return front;
}

START_TEST(similar_bodies_crack_alike)
{
    const CrackFront one = similar(1);
    ck_assert(one.branched && isfinite(one.half_angle) && isfinite(one.angle));
    for (int k = 0; k < 2; k++) {
        const double factor = k == 0 ? 1e-3 : 1e3;
        const CrackFront other = similar(factor);
        expect_within("half angle", other.half_angle, one.half_angle, 1e-9);
        expect_within("angle", other.angle, one.angle, 1e-9);
        expect_within("branch", other.branch[0] / factor, one.branch[0], 1e-12);
        expect_within("advance", other.advance / factor, one.advance, 1e-12);
        expect_within("fastest", other.fastest, one.fastest, 1e-6);
    }
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *reference = tcase_create("reference"), *tells = tcase_create("tells");
    tcase_add_loop_test(reference, a_crack_branches_where_and_when_the_reference_does, 0,
                        sizeof branches / sizeof *branches);
    if (!suite_sanitized())
        tcase_add_test(reference, struck_between_two_cuts_cracks_turn_as_in_the_reference);
    tcase_add_test(tells, a_crack_stays_that_of_its_cut);
    if (!suite_sanitized()) {
        tcase_add_test(tells, joining_is_no_speed);
        tcase_add_test(tells, similar_bodies_crack_alike);
    }
    tcase_add_test(tells, fronts_do_not_remember);
    tcase_add_test(tells, a_speed_needs_its_window);
    tcase_add_loop_test(tells, the_first_branch_is_told, 0, 3);
    suite_add_tcase(suite, reference);
    suite_add_tcase(suite, tells);
}

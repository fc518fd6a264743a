/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The moving cantilever at the paper's spacing, whole, against Euler-Bernoulli on a growing length (figs. 6,
 * 7). */
#include "methods/beam_case.h"
#include "methods/default_defs.h"
#include "suite.h"
#include "theory/elastic_beam.h"

#include <math.h>

/* The relative L2 difference of the tip over 5 ms; tips at whole milliseconds and the zeros on the way. */
static double follow(Clamp clamp, double tips[5], double zeros[3])
{
    BeamDef def = beam_default(BEAM_MOVING_CANTILEVER);
    def.clamp = clamp;
    def.threads = 2;
    Simulation *sim = beam_case_create(&def, NULL);
    BeamTheory theory = {.length = def.length,
                         .height = def.height,
                         .youngs_modulus = def.youngs_modulus,
                         .density = def.density,
                         .amplitude = def.amplitude};
    Status status = {0};
    MovingCantilever *modal = moving_cantilever_solve(&theory, def.speed, 5.1e-3, &status);
    ck_assert_msg(modal != NULL, "%s", status.text);

    double before = series_now(sim, "u_probe"), then = 0, difference = 0, size = 0;
    int n_tips = 0, n_zeros = 0;
    while (then < 5e-3) {
        advance(sim, 10);
        double now = simulation_time(sim), tip = series_now(sim, "u_probe");
        double exact = moving_cantilever_tip(modal, now);
        difference += (tip - exact) * (tip - exact);
        size += exact * exact;
        if (before * tip < 0 && n_zeros < 3)
            zeros[n_zeros++] = then + (now - then) * before / (before - tip);
        if (n_tips < 5 && now >= 1e-3 * (n_tips + 1)) {
            tips[n_tips] = before + (tip - before) * (1e-3 * (n_tips + 1) - then) / (now - then);
            n_tips++;
        }
        before = tip;
        then = now;
    }
    ck_assert_int_eq(n_tips, 5);
    ck_assert_int_eq(n_zeros, 3);
    moving_cantilever_free(modal);
    simulation_destroy(sim);
    return sqrt(difference / size);
}

START_TEST(a_full_clamp_is_the_theorys)
{
    static const double tips_expected[] = {-4.644e-6, -2.112e-6, 6.653e-6, 2.557e-6, -5.643e-6};
    static const double zeros_expected[] = {0.9976 * .6249e-3, 0.9982 * 2.1919e-3, 0.9974 * 4.2915e-3};
    double tips[5], zeros[3], difference = follow(CLAMP_FULL, tips, zeros);
    for (int k = 0; k < 5; k++)
        ck_assert_msg(fabs(tips[k] - tips_expected[k]) < 0.002e-6, "tip %.5g at %d ms", tips[k], k + 1);
    for (int k = 0; k < 3; k++)
        ck_assert_msg(fabs(zeros[k] / zeros_expected[k] - 1) < 3e-4, "zero at %.6g s", zeros[k]);
    ck_assert_msg(difference > 0.011 && difference < 0.014, "relative L2 %.4g", difference);
}
END_TEST

/* The paper's words, uy = 0 in the channel and no more, let the root rotate: worth showing, and no
 * cantilever. */
START_TEST(a_guide_is_not)
{
    double tips[5], zeros[3], difference = follow(CLAMP_GUIDE, tips, zeros);
    ck_assert_msg(difference > 0.22 && difference < 0.26, "relative L2 %.4g", difference);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *moving = tcase_create("moving");
    tcase_add_test(moving, a_full_clamp_is_the_theorys);
    tcase_add_test(moving, a_guide_is_not);
    suite_add_tcase(suite, moving);
}

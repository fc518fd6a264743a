/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of paper P, section 3.3: the crack of the beam with an offset notch. Reference digits are those of an
 * independent solver. */
#include "cli/verify/verify_checks.h"
#include "cli/verify/verify_quantity.h"

/* a row each microsecond */
#define CRACK "notched-beam output.every=10"

static const VerifyRow times[] = {
    {.what = "first break, us",
     .scenario = CRACK,
     .quantity = quantity_first_break,
     .scale = 1e6,
     .decimals = 1,
     .reference = WITHIN(73.4, 2),
     .paper = PRINTS_WITH_REMARK("begins to growth at the time of 90", 90,
                                 "load width and protected zone are not in the paper")},
    {.what = "twentieth break, us",
     .quantity = quantity_twentieth_break,
     .scale = 1e6,
     .decimals = 1,
     .reference = WITHIN(82.8, 2)},
    {.what = "66 mm high at, us",
     .quantity = quantity_first_above,
     .column = "crack_y",
     .from = 66e-3,
     .scale = 1e6,
     .reference = {235, 256}},
    /* the paper says the whole specimen: the upper edge, which it reaches beside the protected zone */
    {.what = "69.5 mm high at, us",
     .quantity = quantity_first_above,
     .column = "crack_y",
     .from = 69.5e-3,
     .scale = 1e6,
     .reference = WITHIN(297, 3),
     .paper = PRINTS_WITH_REMARK("the crack runs through the whole specimen", 250, "at 250 us")},
    {.what = "bonds broken at 300 us", .quantity = quantity_broken_bonds, .reference = WITHIN(6941, 69.41)},
    /* a bond breaks at the first step past its critical stretch and takes the overshoot along */
    {.what = "energy off the work, %",
     .quantity = quantity_energy_off_work,
     .from = 10e-6,
     .decimals = 3,
     .bound = {0, 1}},
};

#define ANGLE_ROW(label, run, height, number, ...)                                                           \
    {                                                                                                        \
        .what = label, .scenario = run, .quantity = quantity_angle_over, .from = height, .decimals = 1,      \
        .reference = WITHIN(number, 3), .paper = __VA_ARGS__                                                 \
    }
#define TIP_ROWS(time, mm_x, mm_y, ...)                                                                      \
    {.what = "tip at " #time " us: x, mm",                                                                   \
     .quantity = quantity_value_at,                                                                          \
     .column = "crack_x",                                                                                    \
     .from = time * 1e-6,                                                                                    \
     .scale = 1e3,                                                                                           \
     .decimals = 1,                                                                                          \
     .reference = WITHIN(mm_x, 1),                                                                           \
     .paper = __VA_ARGS__},                                                                                  \
    {                                                                                                        \
        .what = "  y, mm", .quantity = quantity_value_at, .column = "crack_y", .from = time * 1e-6,          \
        .scale = 1e3, .decimals = 1, .reference = WITHIN(mm_y, 1)                                            \
    }

static const VerifyRow path[] = {
    ANGLE_ROW("degrees over 10 mm", CRACK, 10e-3, 26, ABOUT("initially grows at about 30", 30)),
    ANGLE_ROW("degrees over 20 mm", NULL, 20e-3, 29, NOTHING),
    ANGLE_ROW("degrees over 38 mm", NULL, 38e-3, 35, NOTHING),
    {.what = "turned from 10 to 38 mm",
     .quantity = quantity_angle_turned,
     .from = 10e-3,
     .to = 38e-3,
     .decimals = 1,
     .reference = WITHIN(9, 3),
     .paper = CLAIM("then curves towards", 3, 60)},
    TIP_ROWS(104, 66.8, 22.8, NOTHING),
    TIP_ROWS(136, 74.3, 36.8, NOTHING),
    TIP_ROWS(168, 85.8, 51.8, NOTHING),
    TIP_ROWS(200, 94.8, 59.8, NOTHING),
    TIP_ROWS(232, 100.3, 65.3, NOTHING),
    /* the load begins at 103.5 mm */
    TIP_ROWS(248, 100.8, 66.3, CLAIM("does not go to the point", 0, 103.5)),
};

const VerifyCheck verify_crack_checks[] = {
    {"P-fig9", "times of the crack, as in figure 9", VERIFY_ROWS(times),
     "All at a time step of .1 us: when a bond breaks depends on it."},
    {"P-fig10", "path of the crack, as in figure 10", VERIFY_ROWS(path),
     "Of the experiment in figure 10 the paper gives no number."},
    {NULL, NULL, NULL, 0, NULL},
};

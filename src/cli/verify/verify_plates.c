/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of plates: a crack that branches, and Kalthoff and Winkler's blow. Neither is in the two papers.
 * Reference digits are those of two independent solvers; where every broken bond is the same at any order of
 * summation the count is held exactly, else within 1 %. */
#include "cli/verify/verify_checks.h"
#include "cli/verify/verify_quantity.h"

#define COARSE "branching-coarse"
#define FINE   "branching"

#define EXACTLY(count)                                                                                       \
    {                                                                                                        \
        count, count                                                                                         \
    }
#define CUT_ROW(label, run, count, ...)                                                                      \
    {                                                                                                        \
        .what = label, .scenario = run, .quantity = quantity_derived_number, .column = "cut_bonds",          \
        .reference = EXACTLY(count), __VA_ARGS__                                                             \
    }
#define BROKEN_ROW(label, time, band, ...)                                                                   \
    {                                                                                                        \
        .what = label, .quantity = quantity_value_at, .column = "broken_bonds", .from = time,                \
        .reference = band, __VA_ARGS__                                                                       \
    }
#define FIRST_ROW(label, us, tolerance, ...)                                                                 \
    {                                                                                                        \
        .what = label, .quantity = quantity_first_above, .column = "broken_bonds", .from = 1, .scale = 1e6,  \
        .decimals = 2, .reference = WITHIN(us, tolerance), __VA_ARGS__                                       \
    }
/* breaking is of first order in the time step: a bond takes along what it has beyond its critical stretch */
#define BALANCE_ROW(label, percent, ...)                                                                     \
    {                                                                                                        \
        .what = label, .quantity = quantity_energy_gained, .decimals = 2, .bound = {0, percent}, __VA_ARGS__ \
    }

#define FRONT_ROW(label, number, scale_, digits, band, ...)                                                  \
    {                                                                                                        \
        .what = label, .quantity = number, .scale = scale_, .decimals = digits, .reference = band,           \
        __VA_ARGS__                                                                                          \
    }
/* place, time and speed as the scatter of lattices and steps has them; the angle as all of them together */
#define BRANCH_ROWS(x, us, speed, is_full)                                                                   \
    FRONT_ROW("branches at x, mm", fronts_branch_x, 1e3, 1, WITHIN(x, 2), .full = is_full),                  \
        FRONT_ROW("  at t, us", fronts_branch_time, 1e6, 1, WITHIN(us, 1.5), .full = is_full),               \
        FRONT_ROW("  half angle, degrees", fronts_half_angle, 1, 1, WITHIN(29, 3), .full = is_full),         \
        FRONT_ROW("largest speed, m/s", fronts_speed, 1, 0, WITHIN(speed, 100), .full = is_full)

static const VerifyRow branching[] = {
    CUT_ROW("coarse: bonds cut", COARSE, 3978, .full = false),
    FIRST_ROW("first break, us", 6.7, 0.01, .full = false),
    BROKEN_ROW("broken at 10 us", 10e-6, EXACTLY(188), .full = false),
    BROKEN_ROW("broken at 25 us", 25e-6, EXACTLY(2659), .full = false),
    BROKEN_ROW("broken at 50 us", 50e-6, EXACTLY(9622), .full = false),
    BRANCH_ROWS(69.8, 26, 1854, false),
    BALANCE_ROW("energy gained, % of the work", 1.2, .full = false),
    FRONT_ROW("at .2 us steps: branches at x", fronts_branch_x, 1e3, 1, WITHIN(77.8, 2),
              .scenario = COARSE " time.step=2e-7"),
    CUT_ROW("spacing 0.25 mm: bonds cut", FINE, 7978, .full = true),
    FIRST_ROW("first break, us", 6.3, 0.01, .full = true),
    BROKEN_ROW("broken at 25 us", 25e-6, WITHIN(5443, 54.43), .full = true),
    BROKEN_ROW("broken at 50 us", 50e-6, WITHIN(19393, 193.93), .full = true),
    BRANCH_ROWS(66.4, 22.8, 1813, true),
    BALANCE_ROW("energy gained, % of the work", 1.2, .full = true),
};

static const VerifyRow kalthoff[] = {
    CUT_ROW("coarse: bonds cut", "kalthoff-coarse", 3956, .full = false),
    FIRST_ROW("first break, us", 14, 0.01, .full = false),
    BROKEN_ROW("broken at 30 us", 30e-6, EXACTLY(720), .full = false),
    BROKEN_ROW("broken at 50 us", 50e-6, EXACTLY(5292), .full = false),
    BROKEN_ROW("broken at 100 us", 100e-6, EXACTLY(16273), .full = false),
    BALANCE_ROW("energy gained, % of the work", 6, .full = false),
    CUT_ROW("spacing 0.5 mm: bonds cut", "kalthoff", 7956, .full = true),
    FIRST_ROW("first break, us", 13.5, 0.01, .full = true),
    BROKEN_ROW("broken at 50 us", 50e-6, WITHIN(10286, 102.86), .full = true),
    BROKEN_ROW("broken at 100 us", 100e-6, WITHIN(19682, 196.82), .full = true),
    {.what = "degrees to the cut over 30 mm",
     .quantity = fronts_angle,
     .from = 30e-3,
     .decimals = 1,
     .reference = WITHIN(65.5, 2),
     .full = true},
    {.what = "degrees to the cut over 70 mm",
     .quantity = fronts_angle,
     .from = 70e-3,
     .decimals = 1,
     .reference = WITHIN(65.5, 2),
     .full = true},
};

const VerifyCheck verify_plate_checks[] = {
    {"P-branching", "a crack in glass branches: not from the two papers", VERIFY_ROWS(branching),
     "The reference is that of two independent solvers, at the scenario's time step:\n"
     "  .1 us, and .05 us at the finer spacing. When a bond breaks depends on it."},
    {"P-kalthoff", "cracks turn under a blow: not from the two papers", VERIFY_ROWS(kalthoff),
     "The reference is that of two independent solvers, at the scenario's time step:\n"
     "  .2 us, and .1 us at the finer spacing. When a bond breaks depends on it."},
    {NULL, NULL, NULL, 0, NULL},
};

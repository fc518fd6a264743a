/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tests of the field on the bar, each with an exact answer that is none of paper M's: one particle at large
 * amplitude, a pulse that comes back, the echo of a second material, a bar that hangs; and what the start of
 * APIC's slopes does to the energy, and every limit of stability. */
#include "cli/verify/verify_checks.h"
#include "cli/verify/verify_quantity.h"

/* --- one particle ---------------------------------------------------------------------------------- */

/* 2 pi over the exact period, and over that which update-stress-first has at this step. It feeds large
 * motions, so that their period grows as they go on: the mean of the reference is over some eleven periods.
 */
#define PARTICLE_ROW(label, keys, period, period_by_usf, slack)                                              \
    {.what = label,                                                                                          \
     .scenario = "one-particle time.end=7 " keys,                                                            \
     .quantity = quantity_measured,                                                                          \
     .decimals = 5,                                                                                          \
     .reference = WITHIN(2 * M_PI / (period_by_usf), slack)},                                                \
    {                                                                                                        \
        .what = "  exact", .theory = quantity_exact, .decimals = 6,                                          \
        .reference = WITHIN(2 * M_PI / (period), 2e-7)                                                       \
    }

static const VerifyRow particle[] = {
    PARTICLE_ROW("w, v0 = 1e-6", "initial.velocity=1e-6", .62831853, .62805681, 1e-5),
    PARTICLE_ROW("w, v0 = 0.1", "initial.velocity=0.1", .62833293, .62809849, 1e-5),
    PARTICLE_ROW("w, v0 = 1", "initial.velocity=1", .62976369, .63226101, 3e-4),
    PARTICLE_ROW("w, v0 = 3", "initial.velocity=3", .64171857, .66624818, 0.015),
    {.what = "period error, v0 = 1, %",
     .scenario = "one-particle time.end=7",
     .quantity = quantity_period_error,
     .decimals = 2,
     .reference = WITHIN(0.40, 0.0061)},
    {.what = "  half the step",
     .scenario = "one-particle time.end=7 time.courant=0.05",
     .quantity = quantity_period_error,
     .decimals = 2,
     .reference = WITHIN(0.21, 0.0131)},
};

/* --- a pulse ----------------------------------------------------------------------------------------- */

#define FINDING_ROW(label, run, finding, digits, number, slack)                                              \
    {                                                                                                        \
        .what = label, .scenario = run, .quantity = quantity_finding, .column = finding, .decimals = digits, \
        .reference = WITHIN(number, slack)                                                                   \
    }
/* Where the reference's measure of distance is not known to the last digit, it is off by two of the third. */
#define PULSE_ROWS(label, keys, error, lag, slack)                                                           \
    FINDING_ROW(label ": L2 error of v", "pulse " keys, "v_error", 3, error, 0.0021),                        \
        FINDING_ROW("  late by cells", NULL, "lag", 2, lag, slack)

/* mu* of a time step that goes to 0, of which our reference solver tells */
#define FIVE_EIGHTEENTHS "mpm.mass_blend=.277777777777777778"

static const VerifyRow pulse[] = {
    PULSE_ROWS("width 3", "", 0.741, 2.43, 0.031),
    PULSE_ROWS("width 3, fixed ends", "bar.supports=fixed-fixed", 0.740, 2.43, 0.031),
    PULSE_ROWS("width 6", "initial.pulse=50,6,1e-4", 0.216, 1.02, 0.031),
    PULSE_ROWS("width 3, 5/18", FIVE_EIGHTEENTHS, 0.037, 0.00, 0.051),
    /* .008 where velocities count half a step late, which is .05 cells */
    {.what = "width 6, 5/18: L2 error of v",
     .scenario = "pulse " FIVE_EIGHTEENTHS " initial.pulse=50,6,1e-4",
     .quantity = quantity_finding,
     .column = "v_error",
     .decimals = 3,
     .bound = {0, 0.008}},
    PULSE_ROWS("width 6, fixed ends", "bar.supports=fixed-fixed initial.pulse=50,6,1e-4", 0.216, 1.02, 0.031),
};

/* --- two materials ------------------------------------------------------------------------------------- */

/* At t = 8: the pulse is in one piece on both sides. */
#define JOINT_ROWS(label, keys)                                                                              \
    {.what = label ": R",                                                                                    \
     .scenario = "two-materials " keys,                                                                      \
     .quantity = quantity_finding,                                                                           \
     .column = "reflected",                                                                                  \
     .decimals = 5,                                                                                          \
     .theory = quantity_exact_finding,                                                                       \
     .tolerance = 4e-4},                                                                                     \
    {                                                                                                        \
        .what = "  T", .quantity = quantity_finding, .column = "transmitted", .decimals = 5,                 \
        .theory = quantity_exact_finding, .tolerance = 4e-4                                                  \
    }

static const VerifyRow joint[] = {
    JOINT_ROWS("E 400, rho 1", ""),
    JOINT_ROWS("E 25, rho 1", "bar2.youngs_modulus=25"),
    JOINT_ROWS("E 100, rho 4", "bar2.youngs_modulus=100 bar2.density=4"),
    JOINT_ROWS("E 400, rho 4", "bar2.density=4"),
    {.what = "E 400, rho 1, mu*: R",
     .scenario = "two-materials mpm.mass_blend=auto",
     .quantity = quantity_finding,
     .column = "reflected",
     .decimals = 5,
     .theory = quantity_exact_finding,
     .tolerance = 4e-4},
};

/* --- a bar that hangs ------------------------------------------------------------------------------------
 */

#define COLUMN_ROW(label, keys, exact, number)                                                               \
    {                                                                                                        \
        .what = label, .scenario = "column output.every=100 " keys, .quantity = quantity_finding,            \
        .column = "u_last", .decimals = 5, .reference = WITHIN(number, 6e-6),                                \
        .theory = quantity_exact_finding                                                                     \
    }

static const VerifyRow column[] = {
    COLUMN_ROW("b 0.1, uGIMP", "", .31509, .31513),
    COLUMN_ROW("b 0.1, B-spline 2", "mpm.shape=bspline2", .31509, .31537),
    COLUMN_ROW("b 0.1, hat", "mpm.shape=hat", .31509, .41652),
    COLUMN_ROW("b 0.5, uGIMP", "load.body_force=0.5", 1.62953, 1.67133),
    COLUMN_ROW("b 0.5, B-spline 2", "load.body_force=0.5 mpm.shape=bspline2", 1.62953, 1.67171),
};

/* --- cures of the late frequency -------------------------------------------------------------------------
 */

/* Small motions, whose error is the eigenvalue's; and what is left of the energy of larger ones at t = 100.
 */
#define LATE_ROW(label, keys, late)                                                                          \
    {                                                                                                        \
        .what = label, .scenario = keys " initial.velocity=1e-6 time.end=20",                                \
        .quantity = quantity_frequency_error, .decimals = 4, .reference = WITHIN(late, 1.1e-4),              \
        .eigenvalue = quantity_predicted_frequency_error, .tolerance = 1.1e-4                                \
    }
/* The order of what mu* leaves, at any step. */
#define ORDER_ROW(label, cell, courant, late)                                                                \
    {                                                                                                        \
        .what = label,                                                                                       \
        .scenario = "mode5" BEST " time.courant=" courant " mesh.cell_size=" cell                            \
                    " initial.velocity=1e-6 time.end=20",                                                    \
        .quantity = quantity_frequency_error, .decimals = 6, .reference = WITHIN(late, 2e-6),                \
        .eigenvalue = quantity_predicted_frequency_error, .tolerance = 2e-6                                  \
    }
/* What decays too fast to be measured to the last digit. */
#define EIGEN_ROW(label, keys, late)                                                                         \
    {                                                                                                        \
        .what = label, .scenario = keys " initial.velocity=1e-6 time.end=1",                                 \
        .eigenvalue = quantity_predicted_frequency_error, .decimals = 3, .reference = WITHIN(late, 6e-4)     \
    }
/* What one exact period keeps of the energy, by the series and by the eigenvalue. */
#define PERIOD_KEEPS_ROW(label, keys, digits, share)                                                         \
    {                                                                                                        \
        .what = label, .scenario = keys " initial.velocity=1e-6 time.end=10", .quantity = quantity_kept,     \
        .decimals = digits + 2, .reference = WITHIN(share, 0.51 * 1e-##digits),                              \
        .eigenvalue = quantity_predicted_kept, .tolerance = 1e-##digits                                      \
    }
#define WHOLE " output.columns=all" /* the null space too */
/* Share of the kinetic energy that is in the null space, in the mean of a period of the lumped
 * mesh before `end`. */
#define HIDDEN_ROW(label, keys, end, share, slack)                                                           \
    {                                                                                                        \
        .what = label, .scenario = keys, .quantity = quantity_mean_share, .column = "kinetic_null",          \
        .other = "kinetic", .from = end - 0.6396, .to = end, .decimals = 3,                                  \
        .reference = WITHIN(share, slack)                                                                    \
    }
#define KEPT_ROW(label, keys, share)                                                                         \
    {                                                                                                        \
        .what = label, .scenario = keys, .quantity = quantity_energy_left, .from = 10, .to = 90,             \
        .decimals = 4, .reference = WITHIN(share, 0.003)                                                     \
    }
#define BEST  " mpm.mass_blend=auto"
#define STILL " " FIVE_EIGHTEENTHS
#define FMPM  " mpm.transfer=fmpm"
#define FMPM4 FMPM " mpm.fmpm_order=4"

static const VerifyRow cures[] = {
    LATE_ROW("w %: lumped, n = 1", "mode1", -.0533),
    LATE_ROW("  n = 5", "mode5", -4.2388),
    LATE_ROW("blend .5, n = 1", "mode1 mpm.mass_blend=0.5", -.0163),
    LATE_ROW("  n = 5", "mode5 mpm.mass_blend=0.5", -1.3589),
    LATE_ROW("  n = 10", "mode10 mpm.mass_blend=0.5", -6.6394),
    LATE_ROW("blend 5/18, n = 1", "mode1" STILL, +.0002),
    LATE_ROW("  n = 5", "mode5" STILL, -.0226),
    LATE_ROW("  n = 10", "mode10" STILL, -.7016),
    LATE_ROW("  n = 5, courant .8", "mode5 time.courant=.8" STILL, .8361),
    LATE_ROW("blend mu*, n = 1", "mode1" BEST, .0000),
    LATE_ROW("  n = 5", "mode5" BEST, -.0361),
    LATE_ROW("  n = 10", "mode10" BEST, -.7647),
    ORDER_ROW("  n = 5, courant .4", "1", ".4", -.039255),
    ORDER_ROW("    cells of 1/2", ".5", ".4", -.002414),
    ORDER_ROW("    cells of 1/4", ".25", ".4", -.000150),
    ORDER_ROW("  n = 5, courant .8", "1", ".8", -.045542),
    ORDER_ROW("    cells of 1/2", ".5", ".8", -.002787),
    ORDER_ROW("    cells of 1/4", ".25", ".8", -.000173),
    LATE_ROW("APIC, n = 1", "mode1 mpm.transfer=apic", -.0163),
    LATE_ROW("  n = 5", "mode5 mpm.transfer=apic", -1.3142),
    EIGEN_ROW("FMPM(2), n = 5", "mode5" FMPM, +1.3946),
    EIGEN_ROW("  n = 10", "mode10" FMPM, +.411),
    EIGEN_ROW("FMPM(4), n = 5", "mode5" FMPM4, +1.6987),
    EIGEN_ROW("  n = 10", "mode10" FMPM4, +7.612),
    KEPT_ROW("energy: 5/18 USF, n = 5", "mode5" STILL, .999),
    KEPT_ROW("  n = 10", "mode10" STILL, 1.004),
    KEPT_ROW("5/18 MUSL, n = 5", "mode5 mpm.algorithm=musl" STILL, 1.001),
    KEPT_ROW("  n = 10", "mode10 mpm.algorithm=musl" STILL, .996),
    KEPT_ROW("5/18 USL, n = 5", "mode5 mpm.algorithm=usl" STILL, .620),
    KEPT_ROW("  n = 10", "mode10 mpm.algorithm=usl" STILL, .047),
    PERIOD_KEEPS_ROW("period keeps: PIC, n = 5", "mode5 mpm.flip_fraction=0", 4, .0013),
    PERIOD_KEEPS_ROW("FMPM(2), n = 5", "mode5" FMPM, 3, .684),
    PERIOD_KEEPS_ROW("  n = 10", "mode10" FMPM, 3, .048),
    PERIOD_KEEPS_ROW("FMPM(4), n = 5", "mode5" FMPM4, 4, .9987),
    PERIOD_KEEPS_ROW("  n = 10", "mode10" FMPM4, 3, .847),
    HIDDEN_ROW("null space: lumped, t = 20", "mode10" WHOLE, 20, .19, .0051),
    HIDDEN_ROW("  t = 50", NULL, 50, .64, .0051),
    HIDDEN_ROW("  t = 100", NULL, 100, .93, .0051),
    HIDDEN_ROW("5/18, t = 20", "mode10" STILL WHOLE, 20, .26, .0051),
    HIDDEN_ROW("  t = 50", NULL, 50, .76, .0051),
    HIDDEN_ROW("  t = 100", NULL, 100, .96, .0051),
    HIDDEN_ROW("APIC, t = 20", "mode10 mpm.transfer=apic" WHOLE, 20, 0, 5e-4),
    HIDDEN_ROW("FMPM(2), t = 20", "mode10" FMPM WHOLE, 20, 0, 5e-5),
    HIDDEN_ROW("FMPM(4), t = 20", "mode10" FMPM4 WHOLE, 20, 0, 5e-5),
    KEPT_ROW("crossing, uGIMP: FMPM(2)", "crossing mpm.shape=gimp mesh.padding=16" FMPM, .976),
    KEPT_ROW("  FMPM(4)", "crossing mpm.shape=gimp mesh.padding=16" FMPM4, .985),
    KEPT_ROW("  5/18", "crossing mpm.shape=gimp mesh.padding=16" STILL, .9945),
};

/* --- APIC's start ------------------------------------------------------------------------------------------
 */

/* Kinetic with the affine part, and strain, after the first step. */
#define APIC_ROW(label, run, affine_start, energy)                                                           \
    {                                                                                                        \
        .what = label, .scenario = run " mpm.transfer=apic time.end=1 mpm.affine_start=" affine_start,       \
        .quantity = quantity_value_at, .column = "total", .from = 0.01, .decimals = 10,                      \
        .reference = WITHIN(energy, 1e-10)                                                                   \
    }

static const VerifyRow apic[] = {
    APIC_ROW("n = 1, from the gradient", "mode1", "gradient", .0625437822),
    APIC_ROW("  from zero", "mode1", "zero", .0624512849),
    APIC_ROW("n = 5, from the gradient", "mode5", "gradient", .0659643802),
    APIC_ROW("  from zero", "mode5", "zero", .0586681590),
    APIC_ROW("n = 10, from the gradient", "mode10", "gradient", .0765488143),
    APIC_ROW("  from zero", "mode10", "zero", .0470557789),
};

/* --- every limit
 * -------------------------------------------------------------------------------------------- */

#define LIMIT(label, keys, limit)                                                                            \
    {                                                                                                        \
        .what = label, .scenario = "mode1 time.end=0.1 time.courant=0.01 " keys,                             \
        .predicted = quantity_derived_number, .column = "largest_courant", .decimals = 4,                    \
        .reference = WITHIN(limit, 9e-4), .full = true                                                       \
    }
#define ENDS(label, keys, one_free, both_free, fixed)                                                        \
    LIMIT(label " fixed-free", keys, one_free),                                                              \
        LIMIT("  free-free", "bar.supports=free-free " keys, both_free),                                     \
        LIMIT("  fixed-fixed", "bar.supports=fixed-fixed " keys, fixed)
#define P(count)    "mesh.particles_per_cell=" #count
#define SHAPE(word) " mpm.shape=" #word
#define USL         " mpm.algorithm=usl"
#define APIC        " mpm.transfer=apic"

static const VerifyRow limits[] = {
    ENDS("hat 1 USF", P(1), 2.0000, 2.0000, 2.0000),
    ENDS("hat 2 USF", P(2), 1.7321, 1.7321, 1.7321),
    ENDS("hat 4 USF", P(4), 1.6583, 1.6583, 1.6583),
    ENDS("hat 1 USL", P(1) USL, 0.7071, 0.7071, 0.7071),
    ENDS("hat 2 USL", P(2) USL, 0.7559, 0.7559, 0.7559),
    ENDS("hat 4 USL", P(4) USL, 0.7698, 0.7698, 0.7698),
    ENDS("hat 2 APIC", P(2) APIC, 1.0000, 1.0000, 1.0000),
    ENDS("hat 2 APIC USL", P(2) APIC USL, 1.0000, 1.0000, 1.0000),
    ENDS("bspline2 1 USF", P(1) SHAPE(bspline2), 2.3815, 2.5054, 2.3814),
    ENDS("bspline2 2 USF", P(2) SHAPE(bspline2), 2.0510, 2.2973, 2.0510),
    ENDS("bspline2 4 USF", P(4) SHAPE(bspline2), 1.9559, 2.2591, 1.9559),
    ENDS("bspline2 1 USL", P(1) SHAPE(bspline2) USL, 0.9735, 0.9735, 1.6313),
    ENDS("bspline2 2 USL", P(2) SHAPE(bspline2) USL, 0.9986, 0.9986, 1.2261),
    ENDS("bspline2 4 USL", P(4) SHAPE(bspline2) USL, 0.9987, 0.9987, 1.1284),
    ENDS("bspline2 1 APIC", P(1) SHAPE(bspline2) APIC, 1.4535, 1.4535, 2.0345),
    ENDS("bspline2 2 APIC", P(2) SHAPE(bspline2) APIC, 1.4000, 1.4000, 1.6227),
    ENDS("bspline2 4 APIC", P(4) SHAPE(bspline2) APIC, 1.3996, 1.3996, 1.5223),
    ENDS("bspline2 2 APIC USL", P(2) SHAPE(bspline2) APIC USL, 1.2857, 1.2857, 1.4449),
    ENDS("bspline3 1 USF", P(1) SHAPE(bspline3), 2.6235, 2.6474, 2.6225),
    ENDS("bspline3 2 USF", P(2) SHAPE(bspline3), 1.9413, 2.6115, 1.9413),
    ENDS("bspline3 4 USF", P(4) SHAPE(bspline3), 1.7133, 2.6015, 1.7133),
    ENDS("bspline3 1 USL", P(1) SHAPE(bspline3) USL, 1.0364, 1.0364, 1.2643),
    ENDS("bspline3 2 USL", P(2) SHAPE(bspline3) USL, 1.1184, 1.1184, 1.1426),
    ENDS("bspline3 4 USL", P(4) SHAPE(bspline3) USL, 0.9627, 1.1322, 0.9627),
    ENDS("bspline3 1 APIC", P(1) SHAPE(bspline3) APIC, 1.5253, 1.5253, 1.8391),
    ENDS("bspline3 2 APIC", P(2) SHAPE(bspline3) APIC, 1.5430, 1.5960, 1.5430),
    ENDS("bspline3 4 APIC", P(4) SHAPE(bspline3) APIC, 1.3321, 1.6078, 1.3321),
    ENDS("bspline3 2 APIC USL", P(2) SHAPE(bspline3) APIC USL, 1.3059, 1.4071, 1.3059),
};

const VerifyCheck verify_field_checks[] = {
    {"M-particle", "one particle in one cell, at any amplitude: frequency", VERIFY_ROWS(particle),
     "USF is of first order in the step at large amplitude, of second only where it is small."},
    {"M-pulse", "a pulse comes back from the end (t = 10)", VERIFY_ROWS(pulse), NULL},
    {"M-joint", "a pulse meets a second material: what comes back, what goes on", VERIFY_ROWS(joint), NULL},
    {"M-column", "a bar hangs at rest: displacement of its last particle", VERIFY_ROWS(column),
     "Between: exact at any strain. With hats particles cross cells, and the force jumps."},
    {"M-cures", "transfers: error of omega (%), energy left, kept by a period, hidden", VERIFY_ROWS(cures),
     "mu*(C): blend of lumped and consistent mass (mpm.mass_blend = auto) whose error\n"
     "  of omega falls as the fourth power of the cell: for small motions of a uniform\n"
     "  bar. 5/18 is its limit for small steps."},
    {"M-apic", "energy after APIC's first step, by the slopes of its start", VERIFY_ROWS(apic), NULL},
    {"M-limits-ends", "largest stable courant number, shapes, particles and ends", VERIFY_ROWS(limits),
     "The least of the bar's own and that of an endless mesh, which hats with two\n"
     "  like ends exceed by up to .3 %."},
    {NULL, NULL, NULL, 0, NULL},
};

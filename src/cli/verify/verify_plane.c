/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of the beams by the material point method. No paper has them: their references are independent solvers
 * and the mesh's own eigenvalue. */
#include "cli/verify/verify_checks.h"
#include "cli/verify/verify_quantity.h"

/* --- the supported beam
 * ------------------------------------------------------------------------------------------ */

#define BEAM(cells)                                                                                          \
    "supported-beam-mpm mesh.cell_size=" cells " time.courant=1 time.end=4e-3 output.every=16 "
#define HAT "mpm.shape=hat "

/* Of hats all six digits that are known; boxes are kinked where their particles start. */
#define PERIOD_ROW(label, run, number, slack, long_one)                                                      \
    {                                                                                                        \
        .what = label, .scenario = run, .quantity = quantity_measured, .scale = 1e3, .decimals = 6,          \
        .reference = WITHIN(number, slack), .eigenvalue = quantity_predicted, .tolerance = slack,            \
        .full = long_one                                                                                     \
    }
#define SHARE_ROW(label, run, number)                                                                        \
    {                                                                                                        \
        .what = label, .scenario = run, .quantity = quantity_measured_over, .column = "period_plane",        \
        .decimals = 5, .reference = WITHIN(number, 1e-4)                                                     \
    }

static const VerifyRow periods[] = {
    PERIOD_ROW("1.25 mm, hat", BEAM("1.25e-3") HAT, 0.860590, 1.6e-6, false),
    PERIOD_ROW("1.25 mm, boxes", BEAM("1.25e-3"), 0.860538, 8e-5, false),
    PERIOD_ROW("1.25 mm, held at points", BEAM("1.25e-3") HAT "supports.ends=point", 0.860702, 1.6e-6, false),
    PERIOD_ROW("1.25 mm, 3 x 3 particles", BEAM("1.25e-3") HAT "mesh.particles_per_cell=3", 0.855087, 1.6e-6,
               false),
    PERIOD_ROW("0.625 mm, hat", BEAM("0.625e-3") HAT, 0.862906, 1.6e-6, true),
    PERIOD_ROW("0.5 mm, hat", BEAM("0.5e-3") HAT, 0.863188, 1.6e-6, true),
    PERIOD_ROW("0.5 mm, boxes", BEAM("0.5e-3"), 0.863162, 8e-5, true),
    SHARE_ROW("nu = 0: over the plane's", BEAM("1.25e-3") HAT "beam.poisson=0", 0.9964),
    SHARE_ROW("nu = 0.45", BEAM("1.25e-3") HAT "beam.poisson=0.45", 0.9941),
};

/* --- the cantilever
 * ---------------------------------------------------------------------------------------------- */

#define MOVING   "moving-cantilever-mpm-coarse time.end=5.01e-3 output.every=16 "
#define FINE     "moving-cantilever-mpm time.end=5.01e-3 output.every=20 "
#define ALL_FLIP "mpm.flip_fraction=1 "
#define RIDING   "mpm.shape=hat mesh.velocity=10 initial.stress=grid "

#define DISTANCE_ROW(label, run, number, slack)                                                              \
    {                                                                                                        \
        .what = label, .scenario = run, .quantity = quantity_distance, .column = "u_probe",                  \
        .other = "u_modal", .to = 5e-3, .decimals = 2, .reference = WITHIN(number, slack), .full = true      \
    }
/* The mean from a time on. Energy ripples with the waves that run through the height: by 2 % of it where a
 * beam starts with more of them (initial.stress = grid), so one row says little there. */
#define ENERGY_ROW(label, since, number, slack)                                                              \
    {                                                                                                        \
        .what = label, .quantity = quantity_energy_left, .from = 1e-9, .to = since, .decimals = 3,           \
        .reference = WITHIN(number, slack), .full = true                                                     \
    }
/* The reference wrote a row every 20 steps, and its tip at 1 to 5 ms is that of the nearest row: up to .4 us
 * beside, in which the tip moves by .004 um. Times are those of its rows; its digits are then ours, all of
 * them. */
#define TIP_ROW(label, time, number)                                                                         \
    {                                                                                                        \
        .what = label, .quantity = quantity_value_at, .column = "u_probe", .other = "u_modal", .from = time, \
        .scale = 1e6, .decimals = 3, .reference = WITHIN(number, 0.0006), .theory = quantity_other_at,       \
        .full = true                                                                                         \
    }

static const VerifyRow cantilever[] = {
    {.what = "1.25 mm: zero 1 over theory's",
     .scenario = MOVING ALL_FLIP "time.end=1e-3",
     .quantity = quantity_zero_over_other,
     .column = "u_probe",
     .other = "u_modal",
     .from = 0.6249e-3,
     .decimals = 4,
     .reference = WITHIN(1.007, 6e-4)},
    DISTANCE_ROW("1.25 mm: L2 to 5 ms, %", MOVING ALL_FLIP, 4.2, 0.06),
    ENERGY_ROW("energy left", 4.999e-3, 0.90, 0.006),
    DISTANCE_ROW("hats on a riding mesh: L2, %", MOVING ALL_FLIP RIDING, 5.2, 0.06),
    ENERGY_ROW("energy left", 4.9e-3, 1.02, 0.006),
    DISTANCE_ROW("0.5 mm, flip .999: L2, %", FINE, 1.31, 0.01),
    ENERGY_ROW("energy left", 4.999e-3, 0.67, 0.006),
    TIP_ROW("tip at 1 ms, um", 1.000173506e-3, -4.609),
    TIP_ROW("tip at 2 ms, um", 2.000347012e-3, -2.191),
    TIP_ROW("tip at 3 ms, um", 2.999601241e-3, 6.593),
    TIP_ROW("tip at 4 ms, um", 3.999774747e-3, 2.754),
    TIP_ROW("tip at 5 ms, um", 4.999948253e-3, -5.470),
};

const VerifyCheck verify_plane_checks[] = {
    {"M2-beam", "period of the supported beam by cells (ms)", VERIFY_ROWS(periods),
     "Cells in mm; the eigenvalue is the lowest of the mesh."},
    {"M2-cantilever", "the beam that leaves its channel, by cells", VERIFY_ROWS(cantilever),
     "The channel does work that no mesh of nodes let go one by one does: of the\n"
     "  exact solution .4717 of the energy is left at 5 ms."},
    {NULL, NULL, NULL, 0, NULL},
};

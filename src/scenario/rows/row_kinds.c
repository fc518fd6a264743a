/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of kinds of rows (rows.h): nothing else. A kind that is new is one entry here, and what is made
 * of its rows stands with the solver. */
#include "problems/problem.h"
#include "scenario/rows/rows.h"

#include <math.h>

const char *const row_edge_words[] = {"top", "bottom", "left", "right", NULL};
const char *const row_shape_words[] = {"disc", "ring", "block", NULL};

#define PLACE(name, along)                                                                                   \
    {                                                                                                        \
        .word = name, .value = along, .unit = "m"                                                            \
    }
#define RECTANGLE                                                                                            \
    PLACE("x0", ROW_ALONG_X), PLACE("y0", ROW_ALONG_Y), PLACE("x1", ROW_ALONG_X), PLACE("y1", ROW_ALONG_Y)
#define NUMBER(name, its_unit)                                                                               \
    {                                                                                                        \
        .word = name, .value = ROW_NUMBER, .unit = its_unit                                                  \
    }
#define OPTION(name, its_value, its_unit, if_absent)                                                         \
    {                                                                                                        \
        .word = name, .value = its_value, .unit = its_unit, .optional = true, .absent = if_absent            \
    }
/* Of bodies, in units of one's own. */
#define OF_SHAPES(name, its_value, shapes)                                                                   \
    {                                                                                                        \
        .word = name, .value = its_value, .unit = "", .of = shapes                                           \
    }
enum { DISC = 1 << 0, RING = 1 << 1, BLOCK = 1 << 2 };

const RowKind row_kinds[ROW_KINDS] = {
    [ROWS_CUTS] = {.section = "cuts",
                   .one = "cut",
                   .form = "X0 Y0 X1 Y1",
                   .fresh = "25% 50% 75% 50%",
                   .help = "a straight cut from one place to another: the bonds that cross it are gone",
                   .concern = CONCERN_PLATE,
                   .columns = {RECTANGLE},
                   .n_columns = 4},
    [ROWS_LOADS] = {.section = "loads",
                    .one = "load",
                    .form = "EDGE FROM TO SX SY [ramp T] [until T]",
                    .fresh = "top 0% 100% 0 1e6",
                    .help =
                        "a traction on a stretch of an edge (top | bottom | left | right) from t = 0 on; it "
                        "rises in the time ramp and is gone after until",
                    .concern = CONCERN_PLATE,
                    .columns = {{.word = "edge", .value = ROW_EDGE, .unit = ""},
                                PLACE("from", ROW_ALONG_EDGE),
                                PLACE("to", ROW_ALONG_EDGE),
                                NUMBER("sx", "Pa"),
                                NUMBER("sy", "Pa"),
                                OPTION("ramp", ROW_TIME, "s", 0),
                                OPTION("until", ROW_TIME, "s", HUGE_VAL)},
                    .n_columns = 7},
    [ROWS_SUPPORTS] = {.section = "supports",
                       .one = "support",
                       .form = "X0 Y0 X1 Y1 [ux V] [uy V]",
                       .fresh = "0% 0% 10% 10% ux 0 uy 0",
                       .help = "a rectangle that moves with a given velocity, along x, y or both; 0 holds it",
                       .concern = CONCERN_PLATE,
                       .needs_optional = true,
                       .columns = {RECTANGLE, OPTION("ux", ROW_NUMBER, "m/s", 0),
                                   OPTION("uy", ROW_NUMBER, "m/s", 0)},
                       .n_columns = 6},
    [ROWS_IMPULSES] = {.section = "impulses",
                       .one = "impulse",
                       .form = "X0 Y0 X1 Y1 VX VY",
                       .fresh = "25% 25% 75% 75% 0 1",
                       .help = "the velocity of a rectangle at t = 0",
                       .concern = CONCERN_PLATE,
                       .columns = {RECTANGLE, NUMBER("vx", "m/s"), NUMBER("vy", "m/s")},
                       .n_columns = 6},
    [ROWS_PROTECTED] = {.section = "protected",
                        .one = "protected region",
                        .form = "X0 Y0 X1 Y1",
                        .fresh = "0% 0% 10% 100%",
                        .help = "a rectangle whose nodes keep their bonds, however far these stretch",
                        .concern = CONCERN_PLATE,
                        .columns = {RECTANGLE},
                        .n_columns = 4},
    [ROWS_PROBE] = {.section = "probe",
                    .one = "probe",
                    .form = "X Y",
                    .help = "the place whose motion the time plots show",
                    .concern = CONCERN_PLATE,
                    .usual = "50% 50%",
                    .columns = {PLACE("x", ROW_ALONG_X), PLACE("y", ROW_ALONG_Y)},
                    .n_columns = 2},
    [ROWS_BODIES] =
        {.section = "bodies",
         .one = "body",
         .form = "disc CX CY R | ring CX CY RI RO | block X0 Y0 X1 Y1, then [velocity VX VY] [spin W]",
         .fresh = "disc 50% 50% 0.1",
         .help = "an elastic body with its velocity and its spin about its centre, counterclockwise",
         .concern = CONCERN_BODIES,
         .plain_names = true,
         .columns = {{.word = "shape", .value = ROW_SHAPE, .unit = ""},
                     OF_SHAPES("cx", ROW_ALONG_X, DISC | RING),
                     OF_SHAPES("cy", ROW_ALONG_Y, DISC | RING),
                     OF_SHAPES("r", ROW_SIZE, DISC),
                     OF_SHAPES("ri", ROW_SIZE, RING),
                     OF_SHAPES("ro", ROW_SIZE, RING),
                     OF_SHAPES("x0", ROW_ALONG_X, BLOCK),
                     OF_SHAPES("y0", ROW_ALONG_Y, BLOCK),
                     OF_SHAPES("x1", ROW_ALONG_X, BLOCK),
                     OF_SHAPES("y1", ROW_ALONG_Y, BLOCK),
                     {.word = "vx", .value = ROW_NUMBER, .unit = "", .optional = true, .line = "velocity"},
                     {.word = "vy", .value = ROW_NUMBER, .unit = "", .optional = true, .follows = true},
                     OPTION("spin", ROW_NUMBER, "", 0)},
         .n_columns = 13},
};

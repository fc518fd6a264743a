/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The words and macros of which parameter_rows.inc is made; for who reads it. */
#ifndef SCENARIO_PARAMETER_TABLE_H
#define SCENARIO_PARAMETER_TABLE_H

#include "methods/bonds/plane/bonds_plane.h"
#include "methods/mpm/mpm.h"
#include "scenario/settings_values.h"
#include "scenario/parameters.h"

#include <math.h>

static const char *const bar_supports[] = {"fixed-free", "free-fixed", "fixed-fixed", "free-free", NULL};
static const char *const algorithms[] = {"usf", "usl", "musl", NULL};
static const char *const shapes[] = {
    "hat", "gimp", "bspline2", "bspline3", "cpdi", "bspline2_uniform", "bspline3_uniform", NULL};
static const char *const transfers[] = {"flip", "apic", "fmpm", NULL};
static const char *const affine_starts[] = {"gradient", "zero", NULL};
static const char *const surface_corrections[] = {"none", "energy", "volume", NULL};
static const char *const volume_corrections[] = {"none", "partial", "hhb", NULL};
static const char *const influences[] = {"constant", "conical", NULL};
static const char *const steppings[] = {"verlet",   "euler",          "euler_position",
                                        "leapfrog", "leapfrog_ahead", NULL};
static const char *const clamps[] = {"full", "guide", NULL};
static const char *const plane_ends[] = {"section", "point", NULL};
static const char *const pulse_ways[] = {"right", "left", "both", NULL};
static const char *const start_shapes[] = {"sine", "exact", NULL};
static const char *const plane_starts[] = {"deflection", "velocity", NULL};
static const char *const plane_stresses[] = {"relaxed", "grid", "beam", NULL};
static const char *const body_laws[] = {"hypoelastic", "neo-hookean", NULL};
static const char *const body_planes[] = {"strain", "stress", NULL};
static const char *const body_rotations[] = {"jaumann", "none", NULL};
static const char *const body_walls[] = {"open", "clamp", "slip", "friction", NULL};
static const char *const body_fields[] = {"one", "each", NULL};
static const char *const flags[] = {"no", "yes", NULL};

/* Enum members are read and written as int. */
_Static_assert(sizeof(MpmAlgorithm) == sizeof(int) && sizeof(Clamp) == sizeof(int), "enums are ints");

#define IN_CELLS        (CONCERN_MESH | CONCERN_PLANE | CONCERN_BODIES)
#define AT(member)      .offset = VALUE_OFFSET(member)
#define REAL_AT(member) .type = PARAMETER_REAL, AT(member)
#define TEXT(member)    .type = PARAMETER_TEXT, AT(member), .size = sizeof(((SettingsValues *)NULL)->member)
#define SAID(member)                                                                                         \
    NULL, "", "", .type = PARAMETER_TEXT, .offset = offsetof(Settings, member),                              \
                  .size = sizeof(((Settings *)NULL)->member)
#define SHOWN(member) NULL, "", "", TEXT(view.member)
#define ABOVE_ZERO    .least = 0, .most = HUGE_VAL, .above_least = true
#define FROM_ZERO     .least = 0, .most = HUGE_VAL
#define ANY           .least = -HUGE_VAL, .most = HUGE_VAL
#define CHOICE(words) .type = PARAMETER_CHOICE, .choices = words, .nudge = NUDGE_NEXT

#endif

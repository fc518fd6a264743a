/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the room for values in Settings holds: for the parameter table and code that asks which row of it
 * stands for a member. All others read one concern by its header. */
#ifndef SCENARIO_SETTINGS_VALUES_H
#define SCENARIO_SETTINGS_VALUES_H

#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"

typedef struct SettingsValues {
    Geometry geometry;
    Material material;
    Joint joint;
    Domain domain;
    Contact contact;
    Start start;
    Mesh mesh;
    Transfer transfer;
    Lattice lattice;
    Bonds bonds;
    Motion motion;
    Cut notch;
    Loads loads;
    Supports supports;
    Damping damping;
    TimeSettings time;
    Output output;
    ViewSettings view;
} SettingsValues;

/* Where a member of SettingsValues lies in Settings. */
#define VALUE_OFFSET(member) (offsetof(Settings, values) + offsetof(SettingsValues, member))

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The concerns of a scenario, each by its own functions. */
#include "scenario/settings_values.h"

_Static_assert(sizeof(SettingsValues) <= sizeof((Settings *)NULL)->values,
               "settings.h has room for all values");

/* settings_mesh() to read a concern */
#define READ(Type, name)                                                                                     \
    const Type *settings_##name(const Settings *settings)                                                    \
    {                                                                                                        \
        return &((const SettingsValues *)(const void *)&settings->values)->name;                             \
    }

/* and settings_edit_mesh() to change it */
#define READ_AND_EDIT(Type, name)                                                                            \
    READ(Type, name)                                                                                         \
    Type *settings_edit_##name(Settings *settings)                                                           \
    {                                                                                                        \
        return &((SettingsValues *)(void *)&settings->values)->name;                                         \
    }

READ_AND_EDIT(Geometry, geometry)
READ(Material, material)
READ(Joint, joint)
READ(Domain, domain)
READ_AND_EDIT(Contact, contact)
READ_AND_EDIT(Start, start)
READ_AND_EDIT(Mesh, mesh)
READ_AND_EDIT(Transfer, transfer)
READ_AND_EDIT(Lattice, lattice)
READ_AND_EDIT(Bonds, bonds)
READ(Motion, motion)
READ(Cut, notch)
READ(Loads, loads)
READ_AND_EDIT(Supports, supports)
READ_AND_EDIT(Damping, damping)
READ_AND_EDIT(TimeSettings, time)
READ_AND_EDIT(Output, output)
READ_AND_EDIT(ViewSettings, view)

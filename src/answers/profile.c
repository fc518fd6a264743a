/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Copies fields of the particles at one moment (profile.h), of a beam those of its middle row, in the
 * order of x. */
#include "answers/profile.h"

#include "base/assertion.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const one_dimension[PROFILE_FIELDS] = {"u", "v", "stress", "density", "strain"};
static const char *const two_dimensions[PROFILE_FIELDS] = {"uy", "vy", "ux", "vx", "damage"};

/* The fields that are listed, by number: of a bar along it, of a beam across it first. */
const char *profile_field(const Simulation *sim, int i)
{
    ASSERT_INT(i, >=, 0);
    const char *name =
        i < 0 || i >= PROFILE_FIELDS ? NULL : (sim->dimensions == 1 ? one_dimension : two_dimensions)[i];
    return name && simulation_find_field(sim, 0, name) >= 0 ? name : NULL;
}

/* Puts the values of the middle row first and returns how many it has: the lattice has an even number of rows
 * as often as not, then it is the lower one of the two. NULL: a row as it is. */
static size_t keep_middle(const double *y, size_t all, double *values)
{
    double least = y[0], most = y[0], middle = y[0];
    for (size_t i = 0; i < all; i++) {
        least = y[i] < least ? y[i] : least;
        most = y[i] > most ? y[i] : most;
    }
    const double centre = (least + most) / 2, slack = 1e-9 * (most - least);
    for (size_t i = 0; i < all; i++)
        if (fabs(y[i] - centre) < fabs(middle - centre) - slack)
            middle = y[i];
    size_t count = 0;
    for (size_t i = 0; i < all; i++)
        if (fabs(y[i] - middle) <= slack)
            values[count++] = values[i];
    return count;
}

/* The values of a field along the row; NULL: no memory. `y` is NULL for a bar. */
static double *take(const Simulation *sim, int field, const double *y, size_t *count)
{
    const size_t all = sim->counts[0];
    double *values = malloc((all + 1) * sizeof *values);
    if (!values)
        return NULL;
    sim->method->field(sim, field, 0, all, values);
    *count = y ? keep_middle(y, all, values) : all;
    return values;
}

/* x and the wanted fields (all: `field` NULL), each of profile->count values. False: no memory, or no such
 * field. */
static bool take_all(Profile *profile, const Simulation *sim, const char *field, const double *y)
{
    profile->x = take(sim, sim->position[0], y, &profile->count);
    if (!profile->x)
        return false;
    const char *name;
    for (int i = 0; (name = profile_field(sim, i)) != NULL; i++) {
        if (field && strcmp(field, name) != 0)
            continue;
        const int n = profile->n_fields++;
        profile->names[n] = name;
        const int wanted = simulation_find_field(sim, 0, name);
        profile->values[n] = take(sim, wanted, y, &profile->count);
        if (!profile->values[n])
            return false;
        const double carried = simulation_carried(sim, wanted);
        for (size_t k = 0; k < profile->count; k++)
            profile->values[n][k] -= carried;
    }
    return profile->n_fields > 0;
}

bool profile_take(Profile *profile, const Simulation *sim, const char *field)
{
    *profile = (Profile){.time = simulation_time(sim)};
    const size_t all = sim->counts[0];
    double *y = NULL;
    bool sound = all > 0;
    if (sound && sim->dimensions > 1) {
        y = malloc(all * sizeof *y);
        sound = y != NULL;
        if (y)
            sim->method->field(sim, sim->position[1], 0, all, y);
    }
    sound = sound && take_all(profile, sim, field, y);
    free(y);
    if (!sound)
        profile_close(profile);
    return sound;
}

void profile_close(Profile *profile)
{
    free(profile->x);
    for (int i = 0; i < profile->n_fields; i++)
        free(profile->values[i]);
    *profile = (Profile){0};
}

const double *profile_values(const Profile *profile, const char *field)
{
    for (int i = 0; i < profile->n_fields; i++)
        if (strcmp(profile->names[i], field) == 0)
            return profile->values[i];
    return NULL;
}

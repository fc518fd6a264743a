/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What settings come to without the parameter table: lengths left to themselves, lists inside texts. */
#include "methods/bonds/plane/lattice/volume.h"

#include "base/quantity.h"
#include "base/text.h"
#include "scenario/settings_values.h"

#include <string.h>

const char *const settings_method_words[] = {"mpm", "pd", NULL};

double lattice_spacing(const Settings *settings)
{
    const double given = settings_lattice(settings)->spacing;
    return given > 0 ? given
                     : settings_mesh(settings)->cell_size / settings_mesh(settings)->particles_per_cell;
}

double lattice_horizon(const Settings *settings)
{
    const double given = settings_lattice(settings)->horizon;
    return given > 0 ? given : 3 * lattice_spacing(settings);
}

double lattice_reach(const Settings *settings)
{
    /* a cone binds nothing beyond the horizon */
    const VolumeCorrection how = settings_lattice(settings)->influence == INFLUENCE_CONICAL
                                     ? VOLUME_PARTIAL
                                     : settings_lattice(settings)->volume_correction;
    return volume_reach(how, lattice_horizon(settings), lattice_spacing(settings));
}

/* Copies the next item of a list up to its comma and returns what follows; NULL at the end. */
static const char *next_item(const char *list, char item[LIST_MAX])
{
    if (!list || !*list)
        return NULL;
    size_t n = strcspn(list, ",");
    if (n >= LIST_MAX)
        n = LIST_MAX - 1;
    memcpy(item, list, n);
    item[n] = '\0';
    return list[n] == ',' ? list + n + 1 : list + n;
}

static bool is_blank(const char *text)
{
    return text[strspn(text, " ")] == '\0';
}

static bool ends_in_comma(const char *text)
{
    size_t n = strlen(text);
    return n > 0 && text[n - 1] == ',';
}

int overtones_read(const char *text, Overtone out[OVERTONES_MAX], Status *status)
{
    static const char key[] = "initial.overtones";
    if (is_blank(text))
        return 0;
    if (ends_in_comma(text))
        return status_refuse(status, "%s: ends in a comma (mode:velocity,...)", key), -1;
    int count = 0;
    char item[LIST_MAX];
    while ((text = next_item(text, item))) {
        char *colon = strchr(item, ':');
        long mode;
        double velocity;
        if (colon)
            *colon = '\0';
        if (!colon || !text_to_long(item, &mode) || !text_to_double(colon + 1, &velocity) ||
            !quantity_is_sound(velocity) || mode < 1 || mode > 9999) {
            if (colon)
                *colon = ':';
            return status_refuse(status,
                                 "%s: \"%s\" cannot be read (mode:velocity,... such as 3:0.03,7:0.01)", key,
                                 item),
                   -1;
        }
        if (count == OVERTONES_MAX)
            return status_refuse(status, "%s: too many modes (at most %d)", key, OVERTONES_MAX), -1;
        for (int i = 0; i < count; i++)
            if (out[i].mode == mode)
                return status_refuse(status, "%s: mode %ld is given twice (each once)", key, mode), -1;
        out[count++] = (Overtone){(int)mode, velocity};
    }
    return count;
}

bool pulse_read(const char *text, Pulse *out, Status *status)
{
    double numbers[3];
    const char *rest = text;
    char item[LIST_MAX];
    int count = 0;
    *out = (Pulse){.width = 1};
    if (is_blank(text))
        return true;
    while (count < 3 && (rest = next_item(rest, item)) && text_to_double(item, &numbers[count]) &&
           quantity_is_sound(numbers[count]))
        count++;
    if (count < 3 || *rest || ends_in_comma(text) || !(numbers[1] > 0))
        return status_refuse(
            status,
            "initial.pulse: \"%s\" is not a pulse (centre,width,velocity, the width above 0, "
            "such as 50,3,1e-4)",
            text);
    *out = (Pulse){numbers[0], numbers[1], numbers[2]};
    return true;
}

int settings_times_read(const char *text, double out[TIMES_MAX], Status *status)
{
    static const char key[] = "output.at";
    if (is_blank(text))
        return 0;
    if (ends_in_comma(text))
        return status_refuse(status, "%s: ends in a comma (time,time,...)", key), -1;
    int count = 0;
    char item[LIST_MAX];
    while ((text = next_item(text, item))) {
        double time;
        if (!text_to_double(item, &time) || time < 0)
            return status_refuse(status, "%s: \"%s\" is not a time (numbers >= 0 separated by commas)", key,
                                 item),
                   -1;
        if (count == TIMES_MAX)
            return status_refuse(status, "%s: too many times (at most %d)", key, TIMES_MAX), -1;
        if (count > 0 && time <= out[count - 1])
            return status_refuse(status, "%s: %g does not come after %g (ascending)", key, time,
                                 out[count - 1]),
                   -1;
        out[count++] = time;
    }
    return count;
}

/* The concerns of a scenario, each by its own functions. */

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

void settings_take_output(Settings *settings, const Settings *from)
{
    Output output = *settings_output(from);
    memcpy(output.follow, settings_output(settings)->follow, sizeof output.follow);
    *settings_edit_output(settings) = output;
}

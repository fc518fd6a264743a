/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values of settings through the parameter table: numbers into members and back, and as texts. */
#include "scenario/parameters.h"
#include "scenario/settings_values.h"
#include "scenario/rows/rows.h"
#include "base/kinds.h"
#include "base/assertion.h"
#include "base/hash.h"
#include "base/text.h"
#include "problems/problem.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const void *member_of(const Settings *settings, size_t offset)
{
    return (const char *)settings + offset;
}

/* --- critical stretch and critical energy --------------------------------------------------------- */

static bool is_energy(const Parameter *parameter)
{
    return parameter->offset == VALUE_OFFSET(bonds.critical_energy);
}

/* --- numbers into members and back ---------------------------------------------------------------- */

void settings_put(Settings *settings, const Parameter *parameter, double value)
{
    void *at = (char *)settings + parameter->offset;
    switch (parameter->type) {
    case PARAMETER_REAL:
        *(double *)at = value;
        break;
    case PARAMETER_FLAG:
        *(bool *)at = value != 0;
        break;
    case PARAMETER_INTEGER:
    case PARAMETER_CHOICE: {
        int whole = (int)value;
        memcpy(at, &whole, sizeof whole);
        break;
    }
    case PARAMETER_TEXT:
        return;
    }
    if (parameter->wrong)
        settings->concealed = false;
    if (is_energy(parameter))
        settings_edit_bonds(settings)->energy_given = true;
    if (parameter->offset == VALUE_OFFSET(bonds.critical_stretch))
        settings_edit_bonds(settings)->energy_given = false;
    if (parameter->offset == VALUE_OFFSET(contact.gap))
        settings_edit_contact(settings)->gap_given = true;
    /* G0 = 9 E delta s0^2 / (4 pi) and back (paper P, two dimensions), conical with 5 pi in place of 4 pi.
     * The one that was given stays as it is. */
    Bonds *bonds = settings_edit_bonds(settings);
    const int quarters = settings_lattice(settings)->influence == INFLUENCE_CONICAL ? 5 : 4;
    double stiffness = 9 * settings_material(settings)->youngs_modulus * settings_lattice(settings)->horizon /
                       (quarters * M_PI);
    if (bonds->energy_given)
        bonds->critical_stretch = sqrt(bonds->critical_energy / stiffness);
    else
        bonds->critical_energy = stiffness * bonds->critical_stretch * bonds->critical_stretch;
    /* The usual gap at which bodies meet: a body that touches a wall on a row of nodes has its mean mapped
     * place so many cells from it, which is more for wider shape functions. */
    if (!settings_contact(settings)->gap_given)
        settings_edit_contact(settings)->gap =
            settings_transfer(settings)->shape == MPM_BSPLINE2 ? 0.45 : 0.4;
}

double settings_number(const Settings *settings, const Parameter *parameter)
{
    const void *at = member_of(settings, parameter->offset);
    int whole;
    switch (parameter->type) {
    case PARAMETER_REAL:
        return *(const double *)at;
    case PARAMETER_FLAG:
        return *(const bool *)at;
    case PARAMETER_INTEGER:
    case PARAMETER_CHOICE:
        memcpy(&whole, at, sizeof whole);
        return whole;
    case PARAMETER_TEXT:
        break;
    }
    return NAN;
}

void settings_default(Settings *settings, const Problem *problem)
{
    memset(settings, 0, sizeof *settings);
    settings->problem = problem;
    settings->method = problem->solvers[0]->method;
    for (int i = 0; i < n_parameters; i++)
        /* the energy follows from the stretch, but where a problem begins with an energy of its own */
        if (parameter_applies(&parameters[i], problem) &&
            (!is_energy(&parameters[i]) || parameter_use(&parameters[i], problem)))
            settings_put(settings, &parameters[i], parameter_usual(&parameters[i], problem));
    settings_edit_contact(settings)->gap_given = false;
    settings_default_rows(settings);
}

/* --- text out ------------------------------------------------------------------------------------- */

void parameter_cipher(const char *word, char out[CIPHER_MAX])
{
    snprintf(out, CIPHER_MAX, "%04x", (unsigned)(hash_bytes(HASH_BEGIN, word, strlen(word)) & 0xffff));
}

/* digits 0: as many as it takes to read back to the same number. */
static void write_value(const Settings *settings, const Parameter *parameter, int digits, char out[LIST_MAX])
{
    if (parameter->type == PARAMETER_TEXT) {
        memcpy(out, member_of(settings, parameter->offset), LIST_MAX);
        return;
    }
    double value = settings_number(settings, parameter);
    if (parameter->choices) {
        ASSERT_INT(value, >=, 0);
        ASSERT_INT(value, <, parameter_choices(parameter, settings->problem));
        const char *word = parameter->choices[(int)value];
        const bool concealed = parameter->wrong && settings->concealed;
        char cipher[CIPHER_MAX] = "";
        if (concealed && digits == 0)
            parameter_cipher(word, cipher);
        snprintf(out, LIST_MAX, "%s%s", concealed ? "?" : "", concealed ? cipher : word);
    } else if (parameter_automatic(parameter, settings->problem) && value == parameter->automatic_value)
        strcpy(out, parameter_automatic(parameter, settings->problem));
    else if (digits == 0 || parameter->type == PARAMETER_INTEGER)
        text_shortest(out, value);
    else
        strcpy(out, text_rounded(value, digits).text);
}

void settings_get(const Settings *settings, const Parameter *parameter, char out[LIST_MAX])
{
    write_value(settings, parameter, 0, out);
}

/* To what another value than its first one a parameter is changed in mid-run; NULL: it is not. */
static const char *change_of(const Settings *settings, const Parameter *parameter)
{
    for (int i = 0; i < settings->n_changes; i++)
        for (int word = 1;
             strcmp(settings->changes[i].to.key, parameter->key) == 0 && parameter->choices[word]; word++)
            if (strcmp(settings->changes[i].to.value, parameter->choices[word]) == 0)
                return parameter->choices[word];
    return NULL;
}

static const Parameter *mistake_row(const Settings *settings)
{
    for (int i = 0; i < n_parameters; i++)
        if (parameters[i].wrong && parameter_applies_to(settings, &parameters[i]) &&
            (settings_are_at_work(settings, &parameters[i]) || change_of(settings, &parameters[i])))
            return &parameters[i];
    return NULL;
}

const char *settings_mistake(const Settings *settings)
{
    const Parameter *row = mistake_row(settings);
    if (!row)
        return NULL;
    if (!settings_are_at_work(settings, row))
        return change_of(settings, row);
    return settings->concealed ? "?" : row->choices[(int)settings_number(settings, row)];
}

bool settings_refuse_mistake(const Settings *settings, const char *what, Status *status)
{
    const Parameter *row = mistake_row(settings);
    return !row ||
           status_refuse(status, "%s: %s is a mistake, and %s", row->key, settings_mistake(settings), what);
}

bool parameter_is_live(const Parameter *parameter, double from, double to)
{
    return parameter->live &&
           (!parameter->of_start || (!parameter->of_start((int)from) && !parameter->of_start((int)to)));
}

bool settings_are_at_work(const Settings *settings, const Parameter *parameter)
{
    char text[LIST_MAX];
    if (parameter->type != PARAMETER_TEXT)
        return settings_number(settings, parameter) != parameter->neutral;
    settings_get(settings, parameter, text);
    return *text != '\0';
}

void settings_show(const Settings *settings, const Parameter *parameter, char out[LIST_MAX])
{
    write_value(settings, parameter, 6, out);
}

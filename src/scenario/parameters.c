/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds rows of the parameter table and of the table of text keys, and answers what follows from a row
 * alone: choices, range, default in a problem, unit. Values are set and read below. */
#include "scenario/parameters.h"

#include "scenario/settings_values.h"
#include "base/text.h"
#include "base/assertion.h"
#include "base/hash.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

const char *const parameter_method_titles[] = {"MPM", "PD"};
const char *const parameter_reference_words[] = {"all", "exact", "predicted", "none", NULL};
const char *const parameter_sheet_words[] = {"full", "plain", NULL};
const char *const parameter_colour_words[] = {
    "body",           "uy",        "ux",        "velocity",  "energy", "damage",  "family",
    "surface_factor", "stress_xx", "stress_yy", "stress_xy", "mises",  "kinetic", "speed",
    "pressure",       "det_f",     "drawing",   NULL};

bool parameter_colour_is_there(const Settings *settings, const char *word)
{
    static const char *const of_one_method[][6] = {
        [METHOD_MPM] = {"mises", "kinetic"},
        [METHOD_PD] = {"damage", "family", "surface_factor"},
    };
    static const char *const of_bodies[] = {"body", "speed", "pressure", "det_f", NULL};
    const bool bodies = settings->problem->concerns & CONCERN_BODIES;
    bool there = (settings->problem->concerns & (CONCERN_BEAM | CONCERN_PLATE)) || bodies;
    for (int i = 0; of_bodies[i]; i++)
        there = there && (bodies || strcmp(of_bodies[i], word) != 0);
    there = there && !(bodies && strcmp(word, "drawing") == 0);
    for (int method = 0; method <= METHOD_PD; method++)
        for (int i = 0; of_one_method[method][i]; i++)
            there = there && (method == (int)settings->method || strcmp(of_one_method[method][i], word) != 0);
    return there;
}

static const Parameter *row_of(const char *key, bool text)
{
    for (int i = 0; i < n_parameters; i++)
        if (strcmp(parameters[i].key, key) == 0)
            return (parameters[i].concern == CONCERN_NONE) == text ? &parameters[i] : NULL;
    return NULL;
}

const Parameter *parameter_find(const char *key)
{
    return row_of(key, false);
}

const Parameter *parameter_text_find(const char *key)
{
    return row_of(key, true);
}

void parameter_name_alone(const Parameter *parameter, char *out, size_t size)
{
    const bool alone = !strpbrk(parameter->label, " /");
    snprintf(out, size, "%s%s%s", alone ? parameter->group : "", alone ? " " : "", parameter->label);
    if (alone)
        out[0] = (char)tolower((unsigned char)out[0]);
}

static const char narrower[] =
    "bonds pull along their own line alone; a sheet of such springs grows narrower by a third of its stretch";
const FixedKey fixed_keys[] = {
    {"beam.poisson", CONCERN_BEAM, BY_PD, "1/3", narrower},
    {"plate.poisson", CONCERN_PLATE, BY_PD, "1/3", narrower},
    {"scenario.method", CONCERN_NOTCH | CONCERN_PLATE, BY_PD, "pd",
     "nothing breaks by the material point method"},
    {NULL, 0, 0, NULL, NULL},
};

const FixedKey *fixed_key_find(const Settings *settings, const char *key)
{
    for (const FixedKey *fixed = fixed_keys; fixed->key; fixed++)
        if ((strcmp(key, fixed->key) == 0 || strcmp(key, strchr(fixed->key, '.') + 1) == 0) &&
            (fixed->concern & settings->problem->concerns) && (fixed->methods & 1 << settings->method))
            return fixed;
    return NULL;
}

void fixed_key_text(const FixedKey *fixed, char *out, size_t size)
{
    snprintf(out, size, "%s: is %s here and cannot be set: %s", fixed->key, fixed->value, fixed->reason);
}

bool parameter_applies(const Parameter *parameter, const Problem *problem)
{
    return parameter->concern == CONCERN_ANY || (parameter->concern & problem->concerns) != 0;
}

/* Where the problem overrides its row; NULL: nowhere. */
static const ParameterUse *parameter_use(const Parameter *parameter, const Problem *problem)
{
    for (int i = 0; i < problem->n_uses; i++)
        if (strcmp(problem->uses[i].key, parameter->key) == 0)
            return &problem->uses[i];
    return NULL;
}

Parameter parameter_in(const Parameter *parameter, const Problem *problem)
{
    const ParameterUse *use = parameter_use(parameter, problem);
    Parameter row = *parameter;
    row.unit = problem->si ? row.unit : row.dimension;
    while (row.choices && row.choices[row.n_choices])
        row.n_choices++;
    if (!use)
        return row;
    row.usual = use->usual;
    row.methods = use->methods ? use->methods : row.methods;
    row.help = use->help ? use->help : row.help;
    row.automatic = use->automatic ? use->automatic : row.automatic;
    row.n_choices = use->choices > 0 ? use->choices : row.n_choices;
    row.others = use->others;
    return row;
}

bool parameter_applies_to(const Settings *settings, const Parameter *parameter)
{
    const ParameterUse *use = parameter_use(parameter, settings->problem);
    const int methods = use && use->methods ? use->methods : parameter->methods;
    return parameter_applies(parameter, settings->problem) &&
           (methods == BY_EVERY_METHOD || methods & 1 << settings->method);
}

Nearest nearest_begin(const char *wrong)
{
    const size_t length = strlen(wrong), share = length / 3;
    return (Nearest){wrong, NULL, length < 4 ? (length + 1) / 2 : (share < 2 ? 2 : share) + 1};
}

void nearest_offer(Nearest *nearest, const char *right)
{
    /* the right name in a wrong section, or in none, is one slip */
    const char *right_dot = strchr(right, '.'), *wrong_dot = strchr(nearest->wrong, '.');
    const bool slip = right_dot && strcmp(right_dot + 1, wrong_dot ? wrong_dot + 1 : nearest->wrong) == 0;
    const size_t distance = slip ? 1 : text_distance(right, nearest->wrong);
    if (distance < nearest->too_far)
        nearest->too_far = distance, nearest->word = right;
}

const char *parameter_nearest(const Problem *problem, const char *key)
{
    Nearest nearest = nearest_begin(key);
    for (int i = 0; i < n_parameters; i++) {
        if (parameters[i].concern != CONCERN_NONE && !parameter_applies(&parameters[i], problem))
            continue;
        const char *right = parameters[i].key, *dot = strchr(key, '.') ? NULL : strchr(right, '.');
        const size_t before = nearest.too_far;
        nearest_offer(&nearest, right);
        if (dot) /* who leaves the section away means the same */
            nearest_offer(&nearest, dot + 1);
        if (nearest.too_far < before)
            nearest.word = right;
    }
    return nearest.word;
}

void parameter_range(const Parameter *parameter, const Problem *problem, char *out, size_t size)
{
    char least[NUMBER_TEXT_MAX], most[NUMBER_TEXT_MAX];
    text_shortest(least, parameter->least);
    text_shortest(most, parameter->most);
    const Parameter row = parameter_in(parameter, problem);
    const char *automatic = row.automatic;
    const char *or_word = automatic ? *automatic ? automatic : "empty" : "";
    const char *or_bar = automatic ? " | " : "";
    if (parameter->choice_help && parameter->wrong) {
        snprintf(out, size, "%s, or one of %d: matvib params %s", parameter->choices[0], row.n_choices - 1,
                 problem->word);
    } else if (parameter->choices) {
        *out = '\0';
        for (int i = 0; i < row.n_choices; i++)
            text_or(out, size, parameter->choices[i]);
    } else if (parameter->type == PARAMETER_TEXT) {
        snprintf(out, size, "%s", parameter->form);
    } else if (isinf(parameter->least)) {
        snprintf(out, size, "any number");
    } else if (isinf(parameter->most)) {
        const bool above =
            parameter->above_least || (automatic && parameter->automatic_value == parameter->least);
        const char *sign = above ? ">" : ">=";
        snprintf(out, size, "%s%s%s %s", or_word, or_bar, sign, least);
    } else {
        const char *above = parameter->type == PARAMETER_INTEGER ? "1" : "above 0";
        snprintf(out, size, "%s%s%s to %s", or_word, or_bar,
                 automatic && parameter->least == 0 ? above : least, most);
    }
}

bool parameter_is_size(const Parameter *parameter)
{
    return parameter->nudge == NUDGE_DOUBLE || parameter->nudge == NUDGE_SPACING ||
           parameter->nudge == NUDGE_WIDE;
}

bool parameter_can_be_asked(const Parameter *parameter, const Problem *problem)
{
    return parameter_applies(parameter, problem) && (parameter->choices || parameter_is_size(parameter));
}

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
    Bonds *bonds = settings_edit_bonds(settings);
    if (parameter->offset == VALUE_OFFSET(bonds.critical_energy))
        bonds->energy_given = true;
    if (parameter->offset == VALUE_OFFSET(bonds.critical_stretch))
        bonds->energy_given = false;
    if (parameter->offset == VALUE_OFFSET(contact.gap))
        settings_edit_contact(settings)->gap_given = true;
    /* G0 = 9 E delta s0^2 / (4 pi) and back (paper P, two dimensions), conical with 5 pi in place of 4 pi.
     * The one that was given stays as it is. */
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
    const void *at = (const char *)settings + parameter->offset;
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
            (parameters[i].offset != VALUE_OFFSET(bonds.critical_energy) ||
             parameter_use(&parameters[i], problem)))
            settings_put(settings, &parameters[i], parameter_in(&parameters[i], problem).usual);
    settings_edit_contact(settings)->gap_given = false;
    settings_default_rows(settings);
}

void parameter_cipher(const char *word, char out[CIPHER_MAX])
{
    snprintf(out, CIPHER_MAX, "%04x", (unsigned)(hash_bytes(HASH_BEGIN, word, strlen(word)) & 0xffff));
}

/* digits 0: as many as it takes to read back to the same number. */
static void write_value(const Settings *settings, const Parameter *parameter, int digits, char out[LIST_MAX])
{
    if (parameter->type == PARAMETER_TEXT) {
        strcpy(out, (const char *)settings + parameter->offset);
        return;
    }
    const Parameter row = parameter_in(parameter, settings->problem);
    double value = settings_number(settings, parameter);
    if (parameter->choices) {
        ASSERT_INT(value, >=, 0);
        ASSERT_INT(value, <, row.n_choices);
        const char *word = parameter->choices[(int)value];
        const bool concealed = parameter->wrong && settings->concealed;
        char cipher[CIPHER_MAX] = "";
        if (concealed && digits == 0)
            parameter_cipher(word, cipher);
        snprintf(out, LIST_MAX, "%s%s", concealed ? "?" : "", concealed ? cipher : word);
    } else if (row.automatic && value == row.automatic_value)
        strcpy(out, row.automatic);
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

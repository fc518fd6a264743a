/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds rows of the parameter table and of the table of text keys, and answers what follows from a row
 * alone: choices, range, default in a problem, unit. Values are set and read in values.c. */
#include "scenario/parameters.h"

#include "scenario/settings_values.h"
#include "base/text.h"

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

#define TEXT(member) offsetof(Settings, member), sizeof(((Settings *)NULL)->member)
#define VIEW(member) VALUE_OFFSET(view.member), sizeof(((SettingsValues *)NULL)->view.member)

const TextKey text_keys[] = {
    {"scenario.title", TEXT(title), "one line that names the scenario in lists", TEXT_ANY},
    {"scenario.about", TEXT(about), "what there is to see; further lines are indented", TEXT_ANY},
    {"question.key", TEXT(question), "the choice that the key t toggles", TEXT_ANY},
    {"view.upper", VIEW(upper), "view in the upper plot: its word, or 1 to 9", TEXT_VIEW},
    {"view.lower", VIEW(lower), "view in the lower plot: its word, or 1 to 9", TEXT_VIEW},
    {"view.window", VIEW(window), "length of the time window", TEXT_POSITIVE},
    {"view.pace", VIEW(pace), "steps per frame", TEXT_POSITIVE},
    {"view.colour", VIEW(colour), "what colours a beam, or its drawing with dimensions", TEXT_COLOUR},
    {"view.exaggeration", VIEW(exaggeration), "factor by which displacements are drawn", TEXT_POSITIVE},
    {"view.references", VIEW(references), "reference curves: all, exact, predicted, none", TEXT_REFERENCES},
    {"screen.sheet", VIEW(sheet), "how much there is on the screen at first: plain or full", TEXT_SHEET},
    {"screen.about", VIEW(about), "the number shown in large digits: a word of exercises", TEXT_ANY},
    {"screen.ask", VIEW(ask),
     "keys of up to four parameters to be changed, or of rows of a plate, parted by commas", TEXT_ANY},
};

const int n_text_keys = (int)(sizeof text_keys / sizeof *text_keys);

const Parameter *parameter_find(const char *key)
{
    for (int i = 0; i < n_parameters; i++)
        if (strcmp(parameters[i].key, key) == 0)
            return &parameters[i];
    return NULL;
}

void parameter_name_alone(const Parameter *parameter, char *out, size_t size)
{
    const bool alone = !strpbrk(parameter->label, " /");
    snprintf(out, size, "%s%s%s", alone ? parameter->group : "", alone ? " " : "", parameter->label);
    if (alone)
        out[0] = (char)tolower((unsigned char)out[0]);
}

const FixedKey fixed_keys[] = {
    {"beam.poisson", CONCERN_BEAM, BY_PD, "1/3",
     "bonds pull along their own line alone; a sheet of such springs grows narrower by a third of its "
     "stretch"},
    {"plate.poisson", CONCERN_PLATE, BY_PD, "1/3",
     "bonds pull along their own line alone; a sheet of such springs grows narrower by a third of its "
     "stretch"},
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

const TextKey *text_key_find(const char *key)
{
    for (int i = 0; i < n_text_keys; i++)
        if (strcmp(text_keys[i].key, key) == 0)
            return &text_keys[i];
    return NULL;
}

bool parameter_applies(const Parameter *parameter, const Problem *problem)
{
    return parameter->concern == CONCERN_ANY || (parameter->concern & problem->concerns) != 0;
}

const ParameterUse *parameter_use(const Parameter *parameter, const Problem *problem)
{
    for (int i = 0; i < problem->n_uses; i++)
        if (strcmp(problem->uses[i].key, parameter->key) == 0)
            return &problem->uses[i];
    return NULL;
}

double parameter_usual(const Parameter *parameter, const Problem *problem)
{
    const ParameterUse *use = parameter_use(parameter, problem);
    return use ? use->usual : parameter->usual;
}

int parameter_methods(const Parameter *parameter, const Problem *problem)
{
    const ParameterUse *use = parameter_use(parameter, problem);
    return use && use->methods ? use->methods : parameter->methods;
}

bool parameter_applies_to(const Settings *settings, const Parameter *parameter)
{
    const int methods = parameter_methods(parameter, settings->problem);
    return parameter_applies(parameter, settings->problem) &&
           (methods == BY_EVERY_METHOD || methods & 1 << settings->method);
}

/* The distance of a wrong word from a right one; the right name in a wrong section, or in none, is one slip.
 */
static size_t slip(const char *right, const char *wrong)
{
    const char *right_dot = strchr(right, '.'), *wrong_dot = strchr(wrong, '.');
    if (right_dot && strcmp(right_dot + 1, wrong_dot ? wrong_dot + 1 : wrong) == 0)
        return 1;
    return text_distance(right, wrong);
}

static void keep_nearest(const char *right, const char *wrong, const char **nearest, size_t *least)
{
    size_t distance = slip(right, wrong);
    if (distance < *least)
        *least = distance, *nearest = right;
}

static size_t too_far(const char *wrong)
{
    size_t length = strlen(wrong), share = length / 3;
    return length < 4 ? (length + 1) / 2 : (share < 2 ? 2 : share) + 1;
}

const char *parameter_nearest_word(const char *const *words, const char *wrong)
{
    const char *nearest = NULL;
    size_t least = too_far(wrong);
    for (; *words; words++)
        keep_nearest(*words, wrong, &nearest, &least);
    return nearest;
}

/* Who leaves the section away means the same. */
static void keep_nearest_key(const char *right, const char *wrong, const char **nearest, size_t *least)
{
    const char *dot = strchr(wrong, '.') ? NULL : strchr(right, '.');
    const size_t before = *least;
    keep_nearest(right, wrong, nearest, least);
    if (dot)
        keep_nearest(dot + 1, wrong, nearest, least);
    if (*least < before)
        *nearest = right;
}

const char *parameter_nearest(const Problem *problem, const char *key)
{
    const char *nearest = NULL;
    size_t least = too_far(key);
    for (int i = 0; i < n_parameters; i++)
        if (parameter_applies(&parameters[i], problem))
            keep_nearest_key(parameters[i].key, key, &nearest, &least);
    for (int i = 0; i < n_text_keys; i++)
        keep_nearest(text_keys[i].key, key, &nearest, &least);
    return nearest;
}

const char *parameter_unit(const Parameter *parameter, const Problem *problem)
{
    return problem->si ? parameter->unit : parameter->dimension;
}

const char *parameter_help(const Parameter *parameter, const Problem *problem)
{
    const ParameterUse *use = parameter_use(parameter, problem);
    return use && use->help ? use->help : parameter->help;
}

const char *parameter_automatic(const Parameter *parameter, const Problem *problem)
{
    const ParameterUse *use = parameter_use(parameter, problem);
    return use && use->automatic ? use->automatic : parameter->automatic;
}

int parameter_choices(const Parameter *parameter, const Problem *problem)
{
    const ParameterUse *use = parameter_use(parameter, problem);
    int count = 0;
    if (use && use->choices > 0)
        return use->choices;
    while (parameter->choices && parameter->choices[count])
        count++;
    return count;
}

void parameter_range(const Parameter *parameter, const Problem *problem, char *out, size_t size)
{
    char least[NUMBER_TEXT_MAX], most[NUMBER_TEXT_MAX];
    text_shortest(least, parameter->least);
    text_shortest(most, parameter->most);
    const char *automatic = parameter_automatic(parameter, problem);
    const char *or_word = automatic ? *automatic ? automatic : "empty" : "";
    const char *or_bar = automatic ? " | " : "";
    if (parameter->choice_help && parameter->wrong) {
        snprintf(out, size, "%s, or one of %d: matvib params %s", parameter->choices[0],
                 parameter_choices(parameter, problem) - 1, problem->word);
    } else if (parameter->choices) {
        *out = '\0';
        for (int i = 0; i < parameter_choices(parameter, problem); i++)
            text_or(out, size, parameter->choices[i]);
    } else if (parameter->type == PARAMETER_TEXT) {
        snprintf(out, size, "%s",
                 strcmp(parameter->key, "initial.overtones") == 0 ? "mode:velocity,..."
                 : strcmp(parameter->key, "initial.pulse") == 0   ? "centre,width,velocity"
                 : strcmp(parameter->key, "output.follow") == 0   ? "particle 12 velocity, ..."
                 : strcmp(parameter->key, "output.columns") == 0  ? "all | v_cm,kinetic_null,..."
                                                                  : "time,time,...");
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

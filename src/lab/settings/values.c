/* Values of settings through the parameter table: set, get, show, nudge, compare. */
#include "lab/settings/parameters.h"

#include "base/text.h"
#include "base/visible.h"
#include "lab/settings/changes.h"
#include "lab/answers/problem.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *member(Settings *settings, size_t offset)
{
    return (char *)settings + offset;
}

static const void *member_of(const Settings *settings, size_t offset)
{
    return (const char *)settings + offset;
}

/* --- the two handles on breaking ------------------------------------------------------------------ */

/* G0 = 9 E delta s0^2 / (4 pi) and back (paper P, two dimensions). The one that was said stays as it is. */
static void join_handles(Settings *settings)
{
    Bonds *bonds = &settings->bonds;
    double stiffness = 9 * settings->material.youngs_modulus * settings->lattice.horizon / (4 * M_PI);
    if (bonds->energy_given)
        bonds->critical_stretch = sqrt(bonds->critical_energy / stiffness);
    else
        bonds->critical_energy = stiffness * bonds->critical_stretch * bonds->critical_stretch;
}

static bool is_energy(const char *key)
{
    return strcmp(key, "pd.critical_energy") == 0;
}

static bool is_stretch(const char *key)
{
    return strcmp(key, "pd.critical_stretch") == 0;
}

/* --- numbers into members and back ---------------------------------------------------------------- */

static void put_number(Settings *settings, const Parameter *parameter, double value)
{
    void *at = member(settings, parameter->offset);
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
    if (is_energy(parameter->key))
        settings->bonds.energy_given = true;
    if (is_stretch(parameter->key))
        settings->bonds.energy_given = false;
    join_handles(settings);
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

double lattice_spacing(const Settings *settings)
{
    const double said = settings->lattice.spacing;
    return said > 0 ? said : settings->mesh.cell_size / settings->mesh.particles_per_cell;
}

double lattice_horizon(const Settings *settings)
{
    const double said = settings->lattice.horizon;
    return said > 0 ? said : 3 * lattice_spacing(settings);
}

void settings_default(Settings *settings, Problem problem)
{
    memset(settings, 0, sizeof *settings);
    settings->problem = problem;
    settings->method = problem_facts[problem].usual_method;
    for (int i = 0; i < n_parameters; i++)
        if (parameter_applies(&parameters[i], problem) && !is_energy(parameters[i].key))
            put_number(settings, &parameters[i], parameters[i].defaults[problem]);
}

/* --- text in -------------------------------------------------------------------------------------- */

static bool in_range(const Parameter *parameter, Problem problem, double value)
{
    if (parameter->choices || (parameter_automatic(parameter, problem) && value == 0))
        return true;
    if (parameter->above_least && value <= parameter->least)
        return false;
    return value >= parameter->least && value <= parameter->most;
}

static bool refuse(const Parameter *parameter, Problem problem, const char *text, const char *what,
                   Status *status)
{
    char range[160];
    parameter_range(parameter, problem, range, sizeof range);
    if (!*text)
        return status_fail(status, STATUS_USAGE, "%s: has no value (%s)", parameter->key, range);
    return status_fail(status, STATUS_USAGE, "%s: %s %s (%s)", parameter->key, text, what, range);
}

static bool read_number(const Parameter *parameter, Problem problem, const char *text, double *value,
                        Status *status)
{
    const char *automatic = parameter_automatic(parameter, problem);
    if (automatic && strcmp(text, automatic) == 0) {
        *value = 0;
        return true;
    }
    if (!text_to_double(text, value))
        return refuse(parameter, problem, text, "is not a number", status);
    if (parameter->type == PARAMETER_INTEGER && *value != floor(*value))
        return refuse(parameter, problem, text, "is not a whole number", status);
    /* where nothing at all stands for 0, a 0 that was typed is a slip */
    bool silent_zero = automatic && !*automatic && *value == 0;
    if (silent_zero || !in_range(parameter, problem, *value))
        return refuse(parameter, problem, text, "is out of range", status);
    return true;
}

static bool read_choice(const Parameter *parameter, Problem problem, const char *text, double *value,
                        Status *status)
{
    for (int i = 0; i < parameter_choices(parameter, problem); i++)
        if (strcmp(parameter->choices[i], text) == 0) {
            *value = i;
            return true;
        }
    for (int i = parameter_choices(parameter, problem); parameter->choices[i]; i++)
        if (strcmp(parameter->choices[i], text) == 0)
            return refuse(parameter, problem, text, "is for beams", status);
    return refuse(parameter, problem, text, "is not a choice", status);
}

static bool put_text(Settings *settings, const char *key, size_t offset, size_t size, const char *text,
                     Status *status)
{
    if (strlen(text) >= size)
        return status_fail(status, STATUS_USAGE, "%s: is %zu bytes long (at most %zu)", key, strlen(text),
                           size - 1);
    if (!text_is_clean(text))
        return status_fail(status, STATUS_USAGE, "%s: has characters that cannot be kept (one line of UTF-8)",
                           key);
    char *at = member(settings, offset);
    memset(at, 0, size); /* nothing of an earlier text behind the zero: equal settings are equal bytes */
    strcpy(at, text);
    return true;
}

static bool unknown(Problem problem, const char *key, Status *status)
{
    if (strcmp(key, "scenario.problem") == 0)
        return status_fail(status, STATUS_USAGE, "%s: cannot be changed (choose another scenario)", key);
    const char *nearest = parameter_nearest(problem, key);
    if (nearest)
        return status_fail(status, STATUS_USAGE, "%s: unknown key (did you mean %s?)", key, nearest);
    return status_fail(status, STATUS_USAGE, "%s: unknown key (see: matvib params %s)", key,
                       problem_words[problem]);
}

static bool not_of_settings(const Parameter *parameter, const Settings *settings, Status *status)
{
    const Problem problem = settings->problem;
    if (parameter_applies(parameter, problem))
        return status_fail(status, STATUS_USAGE, "%s: is no parameter of method %s (only of %s)",
                           parameter->key, method_words[settings->method],
                           method_words[parameter->only == OF_MPM ? METHOD_MPM : METHOD_PD]);
    char problems[128];
    size_t used = 0;
    for (int p = 0; p < PROBLEM_COUNT; p++)
        if (parameter_applies(parameter, (Problem)p))
            used += (size_t)snprintf(problems + used, sizeof problems - used, "%s%s", used ? ", " : "",
                                     problem_words[p]);
    return status_fail(status, STATUS_USAGE, "%s: is no parameter of problem %s (only of %s)", parameter->key,
                       problem_words[problem], problems);
}

/* The words of a rule that names them; NULL: it asks for something else. */
static const char *const *words_of(TextRule rule)
{
    return rule == TEXT_REFERENCES ? reference_words : rule == TEXT_COLOUR ? colour_words : NULL;
}

/* Empty is always allowed: as the laboratory likes. */
static bool check_words(const TextKey *key, const char *text, Status *status)
{
    const char *const *words = words_of(key->rule);
    char allowed[160];
    double value;
    snprintf(allowed, sizeof allowed, "%s", key->rule == TEXT_VIEW ? "1 to 9" : words ? "" : "> 0");
    bool sound = !*text || key->rule == TEXT_ANY;
    if (!sound && !words && text_to_double(text, &value))
        sound = key->rule == TEXT_VIEW ? value >= 1 && value <= 9 && value == floor(value) : value > 0;
    for (size_t used = 0; words && *words; words++) {
        sound |= strcmp(*words, text) == 0;
        used += (size_t)snprintf(allowed + used, sizeof allowed - used, "%s%s", used ? " | " : "", *words);
    }
    return sound ||
           status_fail(status, STATUS_USAGE, "%s: %.60s is not allowed (%s)", key->key, text, allowed);
}

bool settings_set(Settings *settings, const char *key, const char *text, Status *status)
{
    const TextKey *words = text_key_find(key);
    if (words)
        return check_words(words, text, status) &&
               put_text(settings, key, words->offset, words->size, text, status);
    const Parameter *parameter = parameter_find(key);
    if (!parameter)
        return unknown(settings->problem, key, status);
    if (!settings_have(settings, parameter))
        return not_of_settings(parameter, settings, status);
    if (parameter->type == PARAMETER_TEXT)
        return put_text(settings, key, parameter->offset, LIST_MAX, text, status);
    double value;
    if (!(parameter->choices ? read_choice : read_number)(parameter, settings->problem, text, &value, status))
        return false;
    put_number(settings, parameter, value);
    return true;
}

bool settings_set_method(Settings *settings, const Assignment *keys, int n_keys, Status *status)
{
    for (int i = 0; i < n_keys; i++)
        if (strcmp(keys[i].key, "scenario.method") == 0 &&
            !settings_set(settings, keys[i].key, keys[i].value, status))
            return false;
    return true;
}

/* --- text out ------------------------------------------------------------------------------------- */

/* digits 0: as many as it takes to read back to the same number. */
static void write_value(const Settings *settings, const Parameter *parameter, int digits, char out[LIST_MAX])
{
    if (parameter->type == PARAMETER_TEXT) {
        memcpy(out, member_of(settings, parameter->offset), LIST_MAX);
        return;
    }
    double value = settings_number(settings, parameter);
    if (parameter->choices)
        strcpy(out, parameter->choices[(int)value]);
    else if (parameter_automatic(parameter, settings->problem) && value == 0)
        strcpy(out, parameter->automatic);
    else if (digits == 0 || parameter->type == PARAMETER_INTEGER)
        text_shortest(out, value);
    else
        text_rounded(out, value, digits);
}

void settings_get(const Settings *settings, const Parameter *parameter, char out[LIST_MAX])
{
    write_value(settings, parameter, 0, out);
}

void settings_show(const Settings *settings, const Parameter *parameter, char out[LIST_MAX])
{
    write_value(settings, parameter, 6, out);
}

/* --- nudges --------------------------------------------------------------------------------------- */

/* Rungs 1, 2, 5 of each decade are numbered: 0 is 1, 1 is 2, 2 is 5, 3 is 10, -1 is 0.5. */
static double rung_value(long rung)
{
    static const char steps[] = "125";
    long decade = (rung - (((rung % 3) + 3) % 3)) / 3;
    char text[NUMBER_TEXT_MAX];
    snprintf(text, sizeof text, "%ce%ld", steps[((rung % 3) + 3) % 3], decade);
    return strtod(text, NULL); /* as if it had been typed */
}

/* The first rung above a positive value (direction 1) or below it (-1). */
static long next_rung(double value, int direction)
{
    long rung = 3 * (long)floor(log10(value)) - 3;
    while (rung_value(rung) <= value * (1 + 1e-12))
        rung++;
    if (direction > 0)
        return rung;
    rung--;
    while (rung_value(rung) >= value * (1 - 1e-12))
        rung--;
    return rung;
}

/* Up and down the ladder ... -2 -1 0 1 2 5 ...; the least rung beside 0 depends on what is usual. */
static double next_on_ladder(double value, int direction, double usual, bool whole)
{
    double least = whole ? 1 : 1e-3 * (usual == 0 ? 1 : pow(10, floor(log10(fabs(usual)) + 1e-9)));
    int outwards = value < 0 ? -direction : direction;
    if (value == 0)
        return direction * rung_value(next_rung(least, 1) - 1);
    if (outwards < 0 && fabs(value) <= least * (1 + 1e-9))
        return 0;
    return copysign(rung_value(next_rung(fabs(value), outwards)), value);
}

static double nudged(const Settings *settings, const Parameter *parameter, double value, int direction)
{
    double usual = parameter->defaults[settings->problem];
    int n = 0;
    switch (parameter->nudge) {
    case NUDGE_ONE:
        return value + direction;
    case NUDGE_DOUBLE:
        return direction > 0 ? value * 2 : value / 2;
    case NUDGE_1_2_5:
        return next_on_ladder(value, direction, usual, parameter->type == PARAMETER_INTEGER);
    case NUDGE_SPACING: {
        /* rounded to six digits of a spacing, so that 0.003 + 0.0005 is 0.0035 and nothing piles up */
        double dx = lattice_spacing(settings);
        char text[NUMBER_TEXT_MAX];
        snprintf(text, sizeof text, "%.12g", (value / dx + direction) * dx);
        return strtod(text, NULL);
    }
    case NUDGE_NEXT:
        n = parameter_choices(parameter, settings->problem);
        return (int)(value + direction + n) % n;
    case NUDGE_NONE:
        break;
    }
    return value;
}

/* A length of the bar's lattice that was left to itself is nudged from what it comes to. */
static double nudge_start(const Settings *settings, const Parameter *parameter)
{
    if (parameter->offset == offsetof(Settings, lattice.spacing))
        return lattice_spacing(settings);
    if (parameter->offset == offsetof(Settings, lattice.horizon))
        return lattice_horizon(settings);
    return settings_number(settings, parameter);
}

bool settings_nudge(Settings *settings, const Parameter *parameter, int direction)
{
    enum { TRIES = 60 }; /* a rung that the other values do not allow is passed over */
    if (!settings_have(settings, parameter) || parameter->type == PARAMETER_TEXT)
        return false;
    double start = nudge_start(settings, parameter), value = start;
    for (int i = 0; i < TRIES; i++) {
        double next = nudged(settings, parameter, value, direction);
        if (next == value || next == start || !in_range(parameter, settings->problem, next))
            return false;
        Settings candidate = *settings;
        put_number(&candidate, parameter, next);
        if (settings_check(&candidate, NULL)) {
            *settings = candidate;
            return true;
        }
        if (parameter->nudge != NUDGE_NEXT && parameter->nudge != NUDGE_1_2_5)
            return false;
        value = next;
    }
    return false;
}

/* --- comparison ----------------------------------------------------------------------------------- */

/* What a run writes does not make it another run; of the two handles on breaking only the given one counts.
 */
static bool matters(const Settings *a, const Settings *b, const Parameter *parameter)
{
    if (strncmp(parameter->key, "output.", 7) == 0 || !settings_have(a, parameter) ||
        !settings_have(b, parameter))
        return false;
    bool by_energy = a->bonds.energy_given && b->bonds.energy_given;
    return is_energy(parameter->key) ? by_energy : is_stretch(parameter->key) ? !by_energy : true;
}

static bool differ_in(const Settings *a, const Settings *b, const Parameter *parameter)
{
    char from[LIST_MAX], to[LIST_MAX];
    if (!matters(a, b, parameter))
        return false;
    settings_get(a, parameter, from);
    settings_get(b, parameter, to);
    return strcmp(from, to) != 0;
}

bool settings_same(const Settings *a, const Settings *b)
{
    for (int i = 0; i < n_parameters; i++)
        if (differ_in(a, b, &parameters[i]))
            return false;
    return a->problem == b->problem && changes_same(a, b);
}

/* Those whose values are known by themselves. */
static bool is_name(const Parameter *parameter)
{
    static const char *const keys[] = {"mpm.algorithm", "mpm.shape", "mpm.transfer", "scenario.method"};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (strcmp(parameter->key, keys[i]) == 0)
            return true;
    return false;
}

void settings_spell(const Settings *settings, const Parameter *parameter, char out[LIST_MAX])
{
    settings_show(settings, parameter, out);
    if (is_name(parameter) && strcmp(parameter->key, "mpm.shape") != 0)
        for (char *c = out; *c; c++)
            *c = (char)toupper((unsigned char)*c);
}

void settings_name(const Settings *a, const Settings *b, char *out, size_t size)
{
    *out = '\0';
    if (a->problem != b->problem) {
        text_list_add(out, size, problem_words[a->problem]);
        return;
    }
    bool room = true;
    for (int i = 0; i < n_parameters && room; i++) {
        char value[LIST_MAX], item[LIST_MAX + 64];
        if (!differ_in(a, b, &parameters[i]))
            continue;
        settings_spell(a, &parameters[i], value);
        snprintf(item, sizeof item, "%s%s%s", is_name(&parameters[i]) ? "" : parameters[i].label,
                 is_name(&parameters[i]) ? "" : " ", *value ? value : "none");
        room = text_list_add(out, size, item);
    }
    if (room && !changes_same(a, b)) {
        char item[48];
        snprintf(item, sizeof item, a->n_changes == 0 ? "unchanged" : "%d changed in mid-run", a->n_changes);
        text_list_add(out, size, item);
    }
    if (*out == '\0')
        snprintf(out, size, "the same");
}

/* Of a mesh or lattice: it is asked about by a smaller one. */
static bool is_size(const Parameter *parameter)
{
    return parameter->nudge == NUDGE_DOUBLE || parameter->nudge == NUDGE_SPACING;
}

const Parameter *settings_question(const Settings *settings)
{
    const Parameter *asked = parameter_find(settings->question);
    if (!asked || !settings_have(settings, asked)) /* or it asks about the bar's other method */
        asked = parameter_find(settings->method == METHOD_MPM ? "mpm.algorithm" : "pd.surface_correction");
    return asked && settings_have(settings, asked) ? asked : NULL;
}

/* A size: one rung below the usual one and, from anywhere else, back to it. */
static bool answer_by_size(Settings *settings, const Parameter *parameter)
{
    const double usual = parameter->defaults[settings->problem];
    if (settings_number(settings, parameter) == usual)
        return settings_nudge(settings, parameter, -1);
    Settings candidate = *settings;
    put_number(&candidate, parameter, usual);
    if (!settings_check(&candidate, NULL))
        return false;
    *settings = candidate;
    return true;
}

bool settings_can_ask(const Parameter *parameter, Problem problem)
{
    return parameter_applies(parameter, problem) && (parameter->choices || is_size(parameter));
}

bool settings_answer_otherwise(Settings *settings, const Parameter *parameter)
{
    char now[LIST_MAX];
    if (is_size(parameter))
        return answer_by_size(settings, parameter);
    for (int i = 0; i < parameter_choices(parameter, settings->problem); i++) {
        const char *usual = parameter->choices[(int)parameter->defaults[settings->problem]];
        if (strcmp(parameter->choices[i], "none") != 0 || strcmp(usual, "none") == 0)
            continue;
        settings_get(settings, parameter, now);
        return settings_set(settings, parameter->key, strcmp(now, "none") == 0 ? usual : "none", NULL);
    }
    return settings_nudge(settings, parameter, 1);
}

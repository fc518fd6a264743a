/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What no single value shows: does the whole make sense? Every refusal names the key to be changed. */
#include "scenario/parameters.h"
#include "scenario/changes.h"
#include "base/text.h"
#include "scenario/settings_values.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

static bool check_changes(const Settings *settings, Status *status)
{
    Settings then = *settings;
    for (int i = 0; i < settings->n_changes; i++) {
        const Change *change = &settings->changes[i];
        const Parameter *parameter = parameter_find(change->to.key);
        const double before = parameter ? settings_number(&then, parameter) : 0;
        const bool concealed = then.concealed;
        if (!settings_set(&then, change->to.key, change->to.value, status))
            return status_prefix(status, "changes.%ld", change->step);
        if (parameter && parameter->live &&
            !parameter_is_live(parameter, before, settings_number(&then, parameter)))
            return status_refuse(
                status, "changes.%ld: %s: %s is made at the start and holds for the whole run", change->step,
                change->to.key,
                !parameter->of_start((int)before) ? parameter->choices[(int)settings_number(&then, parameter)]
                : concealed                       ? "?"
                                                  : parameter->choices[(int)before]);
        if (then.concealed && !concealed)
            return status_refuse(status, "changes.%ld: %s: %s is concealed from the start on, or not at all",
                                 change->step, change->to.key, change->to.value);
        if (!parameter || !parameter->live)
            return status_refuse(
                status, "changes.%ld: %s: cannot change in mid-run (see: matvib params %s, marked live)",
                change->step, change->to.key, settings->problem->word);
        if (change->step < 0 || (i > 0 && change->step < settings->changes[i - 1].step))
            return status_refuse(status, "changes.%ld: is out of order (steps >= 0, ascending)",
                                 change->step);
    }
    return true;
}

/* A part of the problem that the method knows nothing of must not be dropped in silence. */
static bool check_stated(const Settings *settings, Status *status)
{
    const Problem *problem = settings->problem;
    for (int i = 0; i < n_parameters; i++) {
        const Parameter *parameter = &parameters[i];
        char text[LIST_MAX];
        if (!parameter->stated || !parameter_applies(parameter, problem) ||
            parameter_applies_to(settings, parameter) || !settings_are_at_work(settings, parameter) ||
            (parameter->type != PARAMETER_TEXT &&
             settings_number(settings, parameter) == parameter_in(parameter, problem).usual))
            continue;
        settings_get(settings, parameter, text);
        return status_refuse(
            status, "scenario.method: %s does not know %s, which is %s here (%s)",
            settings_method_words[settings->method], parameter->key, text,
            settings_method_words[parameter_in(parameter, problem).methods & BY_MPM ? METHOD_MPM
                                                                                    : METHOD_PD]);
    }
    return true;
}

bool settings_change(Settings *settings, const char *key, const char *text, Status *status)
{
    Settings wanted = *settings;
    if (!settings_set(&wanted, key, text, status) || !settings_check(&wanted, status))
        return false;
    *settings = wanted;
    return true;
}

static bool check_asked(const Settings *settings, Status *status)
{
    const char *list = settings_view(settings)->ask;
    char key[KEY_MAX];
    for (int n = 0; text_next_item(&list, key, sizeof key); n++) {
        const Parameter *parameter = parameter_find(key);
        RowPlace place;
        if (!parameter && settings_row_is_key(settings, key)) {
            if (!settings_row_asked(settings, key, &place, status))
                return false;
        } else if (!parameter || !parameter_applies(parameter, settings->problem))
            return status_refuse(status,
                                 "screen.ask: %s is not a parameter of problem %s (see: matvib params %s)",
                                 key, settings->problem->word, settings->problem->word);
        if (n == ASKED_MAX)
            return status_refuse(status, "screen.ask: names too many (at most %d)", ASKED_MAX);
    }
    return true;
}

bool settings_check(const Settings *settings, Status *status)
{
    if (!problem_allows(settings->problem, settings->method, status) || !check_stated(settings, status) ||
        !settings_rows_check(settings, status) ||
        !problem_solver(settings->problem, settings->method)->check(settings, status))
        return false;
    double times[TIMES_MAX];
    int n_times = settings_times_read(settings_output(settings)->at, times, status);
    if (n_times < 0)
        return false;
    if (n_times > 0 && times[n_times - 1] > settings_time(settings)->end * (1 + 1e-9))
        return status_refuse(status, "output.at: %g is after the end (at most time.end = %g)",
                             times[n_times - 1], settings_time(settings)->end);
    if (n_times > 0 && settings_output(settings)->frames > 0)
        return status_refuse(status, "output.at: output.frames is given too (one of them)");
    const Parameter *question = parameter_find(settings->question);
    if (*settings->question && !(question && parameter_can_be_asked(question, settings->problem)))
        return status_refuse(
            status, "question.key: %s cannot be toggled (a key of problem %s that has choices, or a size)",
            settings->question, settings->problem->word);
    if (!check_asked(settings, status))
        return false;

    /* The settings of the other run must be as sound as those of the first. */
    Settings other = *settings;
    other.n_duel = other.n_changes = 0;
    if (!settings_set_method(&other, settings->duel, settings->n_duel, status))
        return status_prefix(status, "duel");
    for (int i = 0; i < settings->n_duel; i++) {
        const Parameter *parameter = parameter_find(settings->duel[i].key);
        /* a file whose method was set from outside may speak of the other one */
        if (parameter && parameter_applies(parameter, other.problem) &&
            !parameter_applies_to(&other, parameter))
            continue;
        if (!settings_set(&other, settings->duel[i].key, settings->duel[i].value, status))
            return status_prefix(status, "duel");
    }
    if (settings->n_duel > 0 && !settings_check(&other, status))
        return status_prefix(status, "duel");
    return check_changes(settings, status);
}

/* What a scenario asks about: the key of its question, and those of its screen. */

const Parameter *settings_question(const Settings *settings)
{
    const Parameter *asked = parameter_find(settings->question);
    if (!asked || !parameter_applies_to(settings, asked)) /* or it asks about the bar's other method */
        asked = parameter_find(settings->method == METHOD_MPM ? "mpm.algorithm" : "pd.surface_correction");
    return asked && parameter_applies_to(settings, asked) ? asked : NULL;
}

/* What is tried first where a scenario names nothing: the question, then of these what there is. */
static const char *const usually_asked[] = {
    "mesh.cell_size", "mesh.particles_per_cell", "time.courant", "pd.spacing", "pd.horizon", "load.stress",
    "time.step"};

int settings_asked(const Settings *settings, Asked out[ASKED_MAX])
{
    const char *list = settings_view(settings)->ask;
    char key[KEY_MAX];
    int n = 0;
    while (n < ASKED_MAX && text_next_item(&list, key, sizeof key)) {
        Asked *next = &out[n];
        *next = (Asked){.parameter = parameter_find(key)};
        if (next->parameter)
            n += parameter_applies_to(settings, next->parameter);
        else if (settings_row_is_key(settings, key) && settings_row_asked(settings, key, &next->place, NULL))
            n += next->place.row >= 0;
    }
    const Parameter *question = settings_question(settings);
    if (n == 0 && question)
        out[n++] = (Asked){.parameter = question};
    for (size_t i = 0;
         !*settings_view(settings)->ask && n < ASKED_MAX && i < sizeof usually_asked / sizeof *usually_asked;
         i++) {
        const Parameter *parameter = parameter_find(usually_asked[i]);
        if (parameter && parameter != question && parameter_applies_to(settings, parameter))
            out[n++] = (Asked){.parameter = parameter};
    }
    return n;
}

/* Which key is meant by its end or by the words beside its field on screen. */

/* How a key may be called; each in turn, the first by which there is one. */
typedef enum Call { CALL_WHOLE, CALL_NAME, CALL_END, CALL_LABEL, CALLS } Call;

static bool is_called(const char *key, const char *label, const char *words, Call call)
{
    if (call == CALL_WHOLE)
        return strcmp(key, words) == 0;
    if (call == CALL_LABEL) /* "CELL SIZE" is "cell size" */
        return label && strcasecmp(label, words) == 0;
    /* whether the words end the key, behind a mark */
    const size_t length = strlen(key), end = strlen(words);
    return length > end && end > 0 && key[length - end - 1] == (call == CALL_NAME ? '.' : '_') &&
           strcmp(key + length - end, words) == 0;
}

bool settings_resolve_key(const Settings *settings, const char *words, char key[KEY_MAX], Status *status)
{
    const char *found = NULL;
    char list[120] = "";
    int count = 0;
    for (Call call = CALL_WHOLE; call < CALLS && count == 0; call++) {
        for (int i = 0; i < n_parameters; i++)
            if ((parameters[i].concern == CONCERN_NONE || parameter_applies_to(settings, &parameters[i])) &&
                is_called(parameters[i].key, parameters[i].label, words, call)) {
                found = parameters[i].key;
                text_list_add(list, sizeof list, found);
                count++;
            }
    }
    if (count > 1)
        return status_refuse(status, "%s: which one? (%s)", words, list);
    /* what is none stays as it was typed, for the function that refuses it */
    snprintf(key, KEY_MAX, "%s", found ? found : words);
    return true;
}

/* What one set of settings is as against another. */

bool settings_differ(const Settings *a, const Settings *b, const Parameter *parameter)
{
    char one[LIST_MAX], other[LIST_MAX];
    settings_get(a, parameter, one);
    settings_get(b, parameter, other);
    return strcmp(one, other) != 0;
}

/* What a run writes does not make it another run; of critical stretch and critical energy only the given one
 * counts. */
static bool differ_in(const Settings *a, const Settings *b, const Parameter *parameter)
{
    const bool by_energy = settings_bonds(a)->energy_given && settings_bonds(b)->energy_given;
    const size_t ignored =
        by_energy ? VALUE_OFFSET(bonds.critical_stretch) : VALUE_OFFSET(bonds.critical_energy);
    return !parameter->output && parameter->offset != ignored && parameter_applies_to(a, parameter) &&
           parameter_applies_to(b, parameter) && settings_differ(a, b, parameter);
}

bool settings_changes_same(const Settings *a, const Settings *b)
{
    if (a->n_changes != b->n_changes)
        return false;
    for (int i = 0; i < a->n_changes; i++) {
        const Change *one = &a->changes[i], *other = &b->changes[i];
        if (one->step != other->step || strcmp(one->to.key, other->to.key) != 0 ||
            strcmp(one->to.value, other->to.value) != 0)
            return false;
    }
    return true;
}

bool settings_output_same(const Settings *a, const Settings *b)
{
    for (int i = 0; i < n_parameters; i++)
        if (parameters[i].output && settings_differ(a, b, &parameters[i]))
            return false;
    return true;
}

bool settings_same(const Settings *a, const Settings *b)
{
    for (int i = 0; i < n_parameters; i++)
        if (differ_in(a, b, &parameters[i]))
            return false;
    return a->problem == b->problem && settings_rows_same(a, b) && settings_changes_same(a, b);
}

bool settings_differ_beyond(const Settings *a, const Settings *b, const char (*allowed)[KEY_MAX],
                            int n_allowed, char key[KEY_MAX])
{
    bool rows_may = false;
    if (a->problem != b->problem)
        return snprintf(key, KEY_MAX, "scenario.problem") > 0;
    for (int i = 0; i < n_parameters; i++) {
        bool may = !differ_in(a, b, &parameters[i]);
        for (int k = 0; k < n_allowed && !may; k++)
            may = strcmp(allowed[k], parameters[i].key) == 0;
        if (!may)
            return snprintf(key, KEY_MAX, "%s", parameters[i].key) > 0;
    }
    char about[64], in_a[ROW_TEXT_MAX], in_b[ROW_TEXT_MAX];
    RowDifference row;
    for (int k = 0; k < n_allowed; k++)
        rows_may = rows_may || settings_row_is_key(a, allowed[k]);
    if (rows_may || !settings_rows_difference(a, b, 0, &row))
        return false;
    row_difference_show(&row, about, in_a, in_b);
    return snprintf(key, KEY_MAX, "%s", about) > 0;
}

void settings_spell(const Settings *settings, const Parameter *parameter, char out[LIST_MAX])
{
    settings_show(settings, parameter, out);
    if (parameter->named && strcmp(parameter->key, "mpm.shape") != 0)
        for (char *c = out; *c; c++)
            *c = (char)toupper((unsigned char)*c);
}

/* What `a` has of its own, "USL, cell size 1", or, of a change, "Algorithm USF -> USL, cell size 0.25 -> 1".
 * False: there is no room for more. */
static bool name_values(const Settings *a, const Settings *b, bool change, char *out, size_t size)
{
    bool room = true;
    for (int i = 0; i < n_parameters && room; i++) {
        const Parameter *parameter = &parameters[i];
        const bool bare = !change && parameter->named;
        char own[LIST_MAX], other[LIST_MAX], item[2 * LIST_MAX + 64];
        if (!differ_in(a, b, parameter) && !(change && parameter->output && settings_differ(a, b, parameter)))
            continue;
        settings_spell(a, parameter, own);
        settings_spell(b, parameter, other);
        snprintf(item, sizeof item, "%s%s%s%s%s", bare ? "" : parameter->label, bare ? "" : " ",
                 *own ? own : "none", change ? " -> " : "",
                 !change  ? ""
                 : *other ? other
                          : "none");
        room = text_list_add(out, size, item);
    }
    char about[64], own[ROW_TEXT_MAX], other[ROW_TEXT_MAX];
    RowDifference row;
    for (int i = 0; room && settings_rows_difference(a, b, i, &row); i++) {
        char item[2 * ROW_TEXT_MAX + 72];
        row_difference_show(&row, about, own, other);
        snprintf(item, sizeof item, "%s %s%s%s", about, own, change ? " -> " : "", change ? other : "");
        room = text_list_add(out, size, item);
    }
    return room;
}

void settings_name(const Settings *a, const Settings *b, char *out, size_t size)
{
    *out = '\0';
    if (a->problem != b->problem) {
        text_list_add(out, size, a->problem->word);
        return;
    }
    if (name_values(a, b, false, out, size) && !settings_changes_same(a, b)) {
        char item[48];
        snprintf(item, sizeof item, a->n_changes == 0 ? "unchanged" : "%d changed in mid-run", a->n_changes);
        text_list_add(out, size, item);
    }
    if (*out == '\0')
        snprintf(out, size, "the same");
}

void settings_name_change(const Settings *from, const Settings *to, char *out, size_t size)
{
    *out = '\0';
    if (from->problem == to->problem)
        name_values(from, to, true, out, size);
    if (*out == '\0')
        snprintf(out, size, "a change in mid-run");
}

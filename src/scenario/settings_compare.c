/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What one set of settings is as against another. */
#include "scenario/settings_compare.h"
#include "scenario/settings_values.h"
#include "scenario/rows/rows.h"
#include "base/text.h"
#include "problems/problem.h"
#include "scenario/changes.h"
#include "scenario/parameters.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* What a run writes does not make it another run; of critical stretch and critical energy only the given one
 * counts.
 */
static bool matters(const Settings *a, const Settings *b, const Parameter *parameter)
{
    if (parameter->output || !parameter_applies_to(a, parameter) || !parameter_applies_to(b, parameter))
        return false;
    bool by_energy = settings_bonds(a)->energy_given && settings_bonds(b)->energy_given;
    if (parameter->offset == VALUE_OFFSET(bonds.critical_energy))
        return by_energy;
    return parameter->offset != VALUE_OFFSET(bonds.critical_stretch) || !by_energy;
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
    return a->problem == b->problem && settings_rows_same(a, b) && changes_same(a, b);
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
    for (int k = 0; k < n_allowed; k++)
        rows_may = rows_may || settings_row_is_key(a, allowed[k]);
    return !rows_may && settings_rows_difference(a, b, 0, about, in_a, in_b) &&
           snprintf(key, KEY_MAX, "%s", about) > 0;
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
        text_list_add(out, size, a->problem->word);
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
    char about[64], in_a[ROW_TEXT_MAX], in_b[ROW_TEXT_MAX];
    for (int i = 0; room && settings_rows_difference(a, b, i, about, in_a, in_b); i++) {
        char item[ROW_TEXT_MAX + 72];
        snprintf(item, sizeof item, "%s %s", about, in_a);
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

void settings_name_change(const Settings *from, const Settings *to, char *out, size_t size)
{
    *out = '\0';
    bool room = from->problem == to->problem;
    for (int i = 0; i < n_parameters && room; i++) {
        char before[LIST_MAX], after[LIST_MAX], item[2 * LIST_MAX + 64];
        if (!differ_in(from, to, &parameters[i]))
            continue;
        settings_spell(from, &parameters[i], before);
        settings_spell(to, &parameters[i], after);
        snprintf(item, sizeof item, "%s %s -> %s", parameters[i].label, *before ? before : "none",
                 *after ? after : "none");
        room = text_list_add(out, size, item);
    }
    char about[64], before[ROW_TEXT_MAX], after[ROW_TEXT_MAX];
    for (int i = 0; room && settings_rows_difference(from, to, i, about, before, after); i++) {
        char item[2 * ROW_TEXT_MAX + 72];
        snprintf(item, sizeof item, "%s %s -> %s", about, before, after);
        room = text_list_add(out, size, item);
    }
    if (*out == '\0')
        snprintf(out, size, "a change in mid-run");
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What else could have made a foreign code's numbers (diagnose_internal.h): every mistake, every other choice
 * of a scheme, every value beside the scenario's, all from the parameter table; and which run tells two of
 * them apart. */
#include "answers/diagnose_internal.h"

#include "base/text.h"
#include "problems/problem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- the list ------------------------------------------------------------------------------------------- */

typedef struct List {
    Candidate *out;
    int count;
} List;

static void add(List *list, DiagnoseKind kind, const Parameter *parameter, double value, long shift)
{
    if (list->count < CANDIDATES_MAX)
        list->out[list->count++] = (Candidate){kind, parameter, value, shift, 0};
}

static void add_choices(List *list, const Settings *right, const Parameter *parameter)
{
    const int now = (int)settings_number(right, parameter);
    const int count = parameter->type == PARAMETER_FLAG ? 2 : parameter_choices(parameter, right->problem);
    for (int i = 0; i < count; i++)
        if (i != now)
            add(list, parameter->wrong ? DIAGNOSE_MISTAKE : DIAGNOSE_SCHEME, parameter, i, 0);
}

/* Its neighbours, and the ends of a range that has two. */
static void add_values(List *list, const Settings *right, const Parameter *parameter)
{
    enum { NEIGHBOURS = 4 };
    const double now = settings_number(right, parameter);
    const bool whole = parameter->type == PARAMETER_INTEGER, share = parameter->nudge == NUDGE_SHARE;
    if (!whole && (share || (parameter->least == 0 && parameter->most == 1))) {
        for (int end = 0; end < 2; end++)
            if (now != end)
                add(list, DIAGNOSE_SCHEME, parameter, end, 0);
        return;
    }
    for (int direction = -1; direction <= 1; direction += 2) {
        Settings moved = *right;
        const int steps = parameter->nudge == NUDGE_DOUBLE ? 1 : NEIGHBOURS;
        for (int i = 0; i < steps && settings_nudge(&moved, parameter, direction, false); i++)
            add(list, DIAGNOSE_VALUE, parameter, settings_number(&moved, parameter), 0);
    }
}

bool diagnose_is_tried(const Settings *right, const Parameter *parameter)
{
    return !parameter->output && parameter->type != PARAMETER_TEXT &&
           parameter_applies_to(right, parameter) && strncmp(parameter->key, "time.", 5) != 0;
}

int diagnose_candidates(const Settings *right, Candidate out[CANDIDATES_MAX])
{
    List list = {out, 0};
    for (int i = 0; i < n_parameters; i++)
        if (diagnose_is_tried(right, &parameters[i]) && parameters[i].wrong)
            add_choices(&list, right, &parameters[i]);
    for (int i = 0; i < n_parameters; i++)
        if (diagnose_is_tried(right, &parameters[i]) && !parameters[i].wrong &&
            (parameters[i].type == PARAMETER_CHOICE || parameters[i].type == PARAMETER_FLAG))
            add_choices(&list, right, &parameters[i]);
    add(&list, DIAGNOSE_SHIFT, NULL, 0, 1);
    add(&list, DIAGNOSE_SHIFT, NULL, 0, -1);
    for (int i = 0; i < n_parameters; i++)
        if (diagnose_is_tried(right, &parameters[i]) && parameters[i].nudge != NUDGE_NONE &&
            (parameters[i].type == PARAMETER_REAL || parameters[i].type == PARAMETER_INTEGER))
            add_values(&list, right, &parameters[i]);
    return list.count;
}

int diagnose_pairs(const Settings *right, Candidate out[CANDIDATES_MAX])
{
    const Parameter *mistake = parameter_find("mpm.mistake");
    int count = 0;
    if (!mistake || !parameter_applies_to(right, mistake) || right->problem->concerns & CONCERN_PLANE)
        return 0;
    for (int i = 1; i < parameter_choices(mistake, right->problem); i++)
        for (int k = 1; k < i && count < CANDIDATES_MAX; k++)
            out[count++] = (Candidate){DIAGNOSE_MISTAKE, mistake, i, 0, k};
    return count;
}

/* --- one of them ---------------------------------------------------------------------------------------- */

bool diagnose_settings_of(const Candidate *candidate, const Settings *right, const DiagnoseTable *table,
                          Settings *out)
{
    *out = *right;
    if (candidate->parameter) {
        if (!settings_in_range(candidate->parameter, right->problem, candidate->value))
            return false;
        settings_put(out, candidate->parameter, candidate->value);
        out->mpm.mistake_beside = candidate->beside;
    }
    return settings_check(out, NULL) && diagnose_hold_step(out, table->dt) && settings_check(out, NULL);
}

/* --- what a factor is ----------------------------------------------------------------------------------- */

static double number_of(const Settings *settings, const char *key)
{
    const Parameter *parameter = parameter_find(key);
    return parameter && parameter_applies_to(settings, parameter) ? settings_number(settings, parameter)
                                                                  : NAN;
}

void diagnose_name_factor(double factor, double tolerance, const Settings *settings, char *out, size_t size)
{
    double dt = NAN;
    problem_time_step(settings, &dt, NULL);
    const struct {
        double value;
        const char *name;
    } known[] = {
        {-1, "-1"},
        {2, "2"},
        {0.5, "1/2"},
        {number_of(settings, "mesh.particles_per_cell"), "P, the particles in a cell"},
        {1 / number_of(settings, "mesh.particles_per_cell"), "1/P, P the particles in a cell"},
        {number_of(settings, "mesh.cell_size"), "dx, the size of a cell"},
        {1 / number_of(settings, "mesh.cell_size"), "1/dx, dx the size of a cell"},
        {number_of(settings, "pd.spacing"), "dx, the spacing of nodes"},
        {1 / number_of(settings, "pd.spacing"), "1/dx, dx the spacing of nodes"},
        {settings->material.density, "rho, the density"},
        {1 / settings->material.density, "1/rho, rho the density"},
        {dt, "dt, the time step"},
        {1 / dt, "1/dt, dt the time step"},
    };
    out[0] = '\0';
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (known[i].value != 1 && fabs(factor - known[i].value) <= tolerance * fabs(known[i].value))
            text_append(out, size, "%s%s", *out ? " = " : "", known[i].name);
}

/* --- in words -------------------------------------------------------------------------------- */

/* The stage of a wrong code that differs, with its line as it is wrongly written. */
static void say_where(const Settings *wrong, char *out, size_t size)
{
    Simulation *sim = problem_simulate(wrong, 1, NULL);
    out[0] = '\0';
    for (int i = 0; sim && i < sim->n_stages && !*out; i++) {
        const char *line = sim->stages[i].ascii;
        if (!strstr(line, STAGE_WRONG_OPEN_ASCII))
            continue;
        text_append(out, size, "stage %d, %s:  ", i + 1, sim->stages[i].name);
        for (; *line; line++)
            text_append(out, size, *line == '\n' ? "    " : "%c", *line);
    }
    simulation_destroy(sim);
}

void diagnose_explain(const Candidate *candidate, const Settings *right, const Settings *wrong,
                      Explanation *out)
{
    const Parameter *parameter = candidate->parameter;
    char value[LIST_MAX], before[LIST_MAX];
    *out = (Explanation){.kind = candidate->kind};
    if (candidate->kind == DIAGNOSE_SHIFT) {
        text_append(out->id, sizeof out->id, "rows%+ld", candidate->shift);
        text_append(out->words, sizeof out->words,
                    "the right code, whose rows are counted otherwise: its step n is step n%+ld",
                    candidate->shift);
        return;
    }
    settings_get(wrong, parameter, value);
    settings_get(right, parameter, before);
    if (candidate->beside) {
        text_append(out->id, sizeof out->id, "%s+%s", parameter->choices[candidate->beside], value);
        text_append(out->words, sizeof out->words, "%s %s", parameter->choice_help(candidate->beside),
                    parameter->choice_help((int)candidate->value));
        return;
    }
    if (candidate->kind == DIAGNOSE_MISTAKE) {
        text_append(out->id, sizeof out->id, "%s", value);
        text_append(out->words, sizeof out->words, "%s", parameter->choice_help((int)candidate->value));
        say_where(wrong, out->where, sizeof out->where);
        return;
    }
    text_append(out->id, sizeof out->id, "%s=%s", parameter->key, value);
    const double now = settings_number(right, parameter);
    if (candidate->kind == DIAGNOSE_SCHEME || now == 0)
        text_append(out->words, sizeof out->words, "%s, the scenario has %s",
                    candidate->kind == DIAGNOSE_SCHEME ? "no mistake, but another choice" : "another value",
                    before);
    else {
        char name[96], factor[NUMBER_TEXT_MAX];
        diagnose_name_factor(candidate->value / now, 1e-9, right, name, sizeof name);
        text_rounded(factor, candidate->value / now, 8);
        text_append(out->words, sizeof out->words, "another value, the scenario's %s times %s", before,
                    *name ? name : factor);
    }
}

/* --- telling two apart ---------------------------------------------------------------------------------- */

enum { LOOK = 12 }; /* so many steps tell any two codes apart that differ */

/* The column of the series, or else the field of the first set, in which two codes differ within some steps;
 * NULL: none. Of the columns of the file alone where a table is given. */
static bool differ(const Settings *a, const Settings *b, const DiagnoseTable *only,
                   char name[OVERLAY_NAME_MAX])
{
    Simulation *sims[2] = {problem_simulate(a, 1, NULL), problem_simulate(b, 1, NULL)};
    bool found = false;
    double *rows[2] = {NULL, NULL};
    for (int s = 0; s < 2 && sims[0] && sims[1]; s++)
        rows[s] = calloc((size_t)sims[s]->n_series + 1, sizeof(double));
    double size[64] = {0};
    for (int step = 0; step < LOOK && rows[0] && rows[1] && !found; step++) {
        for (int s = 0; s < 2; s++)
            simulation_row(sims[s], rows[s]);
        for (int i = 0; i < sims[0]->n_series && i < 64 && !found; i++) {
            const int other = simulation_find_series(sims[1], sims[0]->series[i].name);
            if (other < 0)
                continue;
            double group = 0;
            for (int k = 0; k < sims[0]->n_series; k++)
                if (strcmp(sims[0]->series[k].unit, sims[0]->series[i].unit) == 0)
                    group = fmax(group, fabs(rows[0][k]));
            size[i] = fmax(size[i], group);
            bool wanted = only == NULL;
            for (int c = 0; only && c < only->n_columns; c++)
                wanted = wanted ||
                         (only->set < 0 ? strcmp(only->columns[c].name, sims[0]->series[i].name) == 0 : 1);
            found = wanted && fabs(rows[0][i] - rows[1][other]) > 1e-9 * size[i];
            if (found)
                snprintf(name, OVERLAY_NAME_MAX, "%s", sims[0]->series[i].name);
        }
        for (int s = 0; s < 2 && !found; s++)
            if (!simulation_steps(sims[s], 1, NULL, NULL, NULL))
                step = LOOK;
    }
    for (int s = 0; s < 2; s++) {
        free(rows[s]);
        simulation_destroy(sims[s]);
    }
    return found;
}

bool diagnose_tell_apart(const Settings *a, const Settings *b, const DiagnoseTable *table, char *out,
                         size_t size)
{
    char name[OVERLAY_NAME_MAX];
    out[0] = '\0';
    if (table->set < 0 && differ(a, b, NULL, name)) {
        bool has = false;
        for (int c = 0; c < table->n_columns; c++)
            has = has || strcmp(table->columns[c].name, name) == 0;
        snprintf(out, size, has ? "more rows or digits of %s tell" : "the column %s tells", name);
        return true;
    }
    for (int i = 0; i < n_parameters; i++) {
        const Parameter *parameter = &parameters[i];
        if (!diagnose_is_tried(a, parameter) || parameter->wrong || parameter->nudge == NUDGE_NONE ||
            (parameter->type != PARAMETER_REAL && parameter->type != PARAMETER_INTEGER) ||
            settings_number(a, parameter) != settings_number(b, parameter))
            continue;
        for (int direction = -1; direction <= 1; direction += 2) {
            Settings others[2] = {*a, *b};
            if (!settings_nudge(&others[0], parameter, direction, false))
                continue;
            settings_put(&others[1], parameter, settings_number(&others[0], parameter));
            if (!settings_check(&others[1], NULL) || !differ(&others[0], &others[1], table, name))
                continue;
            char value[LIST_MAX];
            settings_get(&others[0], parameter, value);
            snprintf(out, size, "--set %s=%s tells", parameter->key, value);
            return true;
        }
    }
    return false;
}

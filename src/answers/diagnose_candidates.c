/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What else could have made a foreign code's numbers (diagnose_internal.h): every mistake, every other choice
 * of a scheme, every value beside the scenario's, all from the parameter table; and which run tells two of
 * them apart. */
#include "answers/diagnose_internal.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_cells.h"

#include "base/assertion.h"
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
        list->out[list->count++] = (Candidate){kind, parameter, value, shift, 0, NULL};
}

static void add_choices(List *list, const Settings *right, const Parameter *parameter)
{
    const int now = (int)settings_number(right, parameter);
    const int count = parameter->type == PARAMETER_FLAG ? 2 : parameter_choices(parameter, right->problem);
    for (int i = 0; i < count; i++)
        if (i != now)
            add(list, parameter->wrong ? DIAGNOSE_MISTAKE : DIAGNOSE_SCHEME, parameter, i, 0);
}

/* The other sign, its neighbours, and the ends of a range that has two. */
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
    if (!whole && now != 0 && settings_in_range(parameter, right->problem, -now))
        add(list, DIAGNOSE_VALUE, parameter, -now, 0);
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
    int count = 0;
    for (int p = 0; p < n_parameters; p++)
        if (diagnose_is_tried(right, &parameters[p]) && parameters[p].wrong)
            for (int i = 1; i < parameter_choices(&parameters[p], right->problem); i++)
                for (int k = 1; k < i && count < CANDIDATES_MAX; k++)
                    out[count++] = (Candidate){DIAGNOSE_MISTAKE, &parameters[p], i, 0, k, NULL};
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
        settings_edit_transfer(out)->mistake_beside = settings_edit_lattice(out)->mistake_beside =
            candidate->beside;
    }
    if (!candidate->own_step)
        return diagnose_hold_step(out, table->dt, NULL);
    *settings_edit_time(out) = *candidate->own_step;
    return settings_check(out, NULL);
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
        {settings_material(settings)->density, "rho, the density"},
        {1 / settings_material(settings)->density, "1/rho, rho the density"},
        {dt, "dt, the time step"},
        {1 / dt, "1/dt, dt the time step"},
    };
    out[0] = '\0';
    if (!isfinite(factor))
        return;
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
        char name[96];
        diagnose_name_factor(candidate->value / now, 1e-9, right, name, sizeof name);
        text_append(out->words, sizeof out->words, "another value, the scenario's %s times %s", before,
                    *name ? name : text_rounded(candidate->value / now, 8).text);
    }
}

/* --- telling two apart ---------------------------------------------------------------------------------- */

enum { LOOK = 12, SERIES_MAX = 64 }; /* so many steps tell any two codes apart that differ */

/* The first rows of a run. */
typedef struct Beginning {
    Run run;
    double rows[LOOK][SERIES_MAX];
    long count;
} Beginning;

static bool take_row(void *owner, Run *run, long step, const double *row, Status *status)
{
    Beginning *beginning = owner;
    const int count = run->sim->n_series < SERIES_MAX ? run->sim->n_series : SERIES_MAX;
    (void)status;
    ASSERT_INDEX(step, LOOK);
    memcpy(beginning->rows[step], row, (size_t)count * sizeof *row);
    beginning->count = step + 1;
    return true;
}

/* Up to where it fails, if it does. */
static bool begin(Beginning *beginning, const Settings *settings)
{
    const Sink sink = {.every = 1, .row = take_row, .owner = beginning};
    Run *run = &beginning->run;
    if (!run_open(run, settings, problem_simulate(settings, 1, NULL), NULL) || !run_start(run, &sink, NULL))
        return false;
    run_advance(run, (RunUntil){RUN_STEPS, LOOK - 1}, &sink, NULL);
    return true;
}

/* The largest number of a column's unit in a row. */
static double size_in(const Simulation *sim, const double *row, int column)
{
    double size = 0;
    for (int i = 0; i < sim->n_series && i < SERIES_MAX; i++)
        if (strcmp(sim->series[i].unit, sim->series[column].unit) == 0)
            size = fmax(size, fabs(row[i]));
    return size;
}

static bool has_column(const DiagnoseTable *table, const char *name)
{
    for (int c = 0; c < table->n_columns; c++)
        if (strcmp(table->columns[c].name, name) == 0)
            return true;
    return false;
}

/* The first column of the series in which two beginnings differ; of a series' file one of its columns; NULL:
 * none. */
static const char *difference(const Beginning *a, const Beginning *b, const DiagnoseTable *only)
{
    const Simulation *sim = a->run.sim;
    double size[SERIES_MAX] = {0};
    for (long step = 0; step < a->count && step < b->count; step++)
        for (int i = 0; i < sim->n_series && i < SERIES_MAX; i++) {
            const char *name = sim->series[i].name;
            const int other = simulation_find_series(b->run.sim, name);
            size[i] = fmax(size[i], size_in(sim, a->rows[step], i));
            if (other >= 0 && other < SERIES_MAX && (!only || only->set >= 0 || has_column(only, name)) &&
                fabs(a->rows[step][i] - b->rows[step][other]) > 1e-9 * size[i])
                return name;
        }
    return NULL;
}

/* Whether two codes differ within some steps, and in which column. */
static bool differ(const Settings *a, const Settings *b, const DiagnoseTable *only,
                   char name[OVERLAY_NAME_MAX])
{
    Beginning *both = calloc(2, sizeof *both);
    const char *found =
        both && begin(&both[0], a) && begin(&both[1], b) ? difference(&both[0], &both[1], only) : NULL;
    snprintf(name, OVERLAY_NAME_MAX, "%s", found ? found : "");
    for (int i = 0; i < 2 && both; i++)
        run_close(&both[i].run);
    free(both);
    return *name;
}

bool diagnose_tell_apart(const Settings *a, const Settings *b, const DiagnoseTable *table, char *out,
                         size_t size)
{
    char name[OVERLAY_NAME_MAX];
    out[0] = '\0';
    if (table->set < 0 && differ(a, b, NULL, name)) {
        snprintf(out, size,
                 has_column(table, name) ? "more rows or digits of %s tell" : "the column %s tells", name);
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
            char value[LIST_MAX];
            if (!settings_nudge(&others[0], parameter, direction, false))
                continue;
            settings_get(&others[0], parameter, value);
            if (!settings_change(&others[1], parameter->key, value, NULL) ||
                !differ(&others[0], &others[1], table, name))
                continue;
            snprintf(out, size, "--set %s=%s tells", parameter->key, value);
            return true;
        }
    }
    return false;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What else could have made a foreign code's numbers (diagnose_internal.h): every mistake, every other choice
 * of a scheme, every value beside the scenario's, all from the parameter table; and which run distinguishes
 * two of them. */
#include "answers/diagnose/diagnose_internal.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_cells.h"

#include "base/assertion.h"
#include "base/math/functions.h"
#include "base/text.h"
#include "problems/problem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- the list ------------------------------------------------------------------------------------------- */

bool diagnose_is_of_plane(const Settings *settings)
{
    return !(settings->problem->concerns & (CONCERN_BAR | CONCERN_POINT));
}

bool diagnose_is_share(const Parameter *parameter)
{
    return parameter->type == PARAMETER_REAL && parameter->least == 0 && parameter->most == 1;
}

DiagnoseKind diagnose_kind(const Parameter *parameter)
{
    const bool scheme = strncmp(parameter->key, "mpm.", 4) == 0 || strncmp(parameter->key, "pd.", 3) == 0;
    const bool choice = parameter->type == PARAMETER_CHOICE || parameter->type == PARAMETER_FLAG;
    return parameter->wrong                                     ? DIAGNOSE_MISTAKE
           : scheme && (choice || diagnose_is_share(parameter)) ? DIAGNOSE_SCHEME
                                                                : DIAGNOSE_VALUE;
}

static void add(Candidate *out, int *count, const Parameter *parameter, double value, int beside)
{
    if (*count < CANDIDATES_MAX)
        out[(*count)++] = (Candidate){diagnose_kind(parameter), parameter, value, beside, NULL};
}

/* The other sign, its neighbours, and the ends of a range that has two. */
static void add_values(Candidate *out, int *count, const Settings *right, const Parameter *parameter)
{
    enum { NEIGHBOURS = 4 };
    const double now = settings_number(right, parameter);
    if (diagnose_is_share(parameter)) {
        for (int end = 0; end < 2; end++)
            if (now != end)
                add(out, count, parameter, end, 0);
        return;
    }
    if (parameter->type == PARAMETER_REAL && now != 0 && settings_in_range(parameter, right->problem, -now))
        add(out, count, parameter, -now, 0);
    for (int direction = -1; direction <= 1; direction += 2) {
        Settings moved = *right;
        const int steps = parameter->nudge == NUDGE_DOUBLE ? 1 : NEIGHBOURS;
        for (int i = 0; i < steps && settings_nudge(&moved, parameter, direction, false, NULL); i++)
            add(out, count, parameter, settings_number(&moved, parameter), 0);
    }
}

bool diagnose_is_tried(const Settings *right, const Parameter *parameter)
{
    /* of bodies mpm.rotation = none is the mistake no_rotation */
    return !parameter->output && parameter->type != PARAMETER_TEXT &&
           (strcmp(parameter->key, "mpm.rotation") != 0 || !(right->problem->concerns & CONCERN_BODIES)) &&
           parameter_applies_to(right, parameter) && strncmp(parameter->key, "time.", 5) != 0;
}

int diagnose_candidates(const Settings *right, DiagnoseListed what, Candidate out[CANDIDATES_MAX])
{
    enum { WRONG, CHOICES, NUMBERS, GROUPS };
    int count = 0;
    for (int group = WRONG; group < (what == MISTAKES_AND_VALUES ? GROUPS : CHOICES); group++)
        for (int i = 0; i < n_parameters; i++) {
            const Parameter *parameter = &parameters[i];
            const bool choice = parameter->type == PARAMETER_CHOICE || parameter->type == PARAMETER_FLAG;
            const int choices = parameter_in(parameter, right->problem).n_choices;
            if (group != (parameter->wrong ? WRONG
                          : choice         ? CHOICES
                                           : NUMBERS) ||
                !diagnose_is_tried(right, parameter))
                continue;
            if (group == NUMBERS && parameter->nudge != NUDGE_NONE)
                add_values(out, &count, right, parameter);
            for (int k = 0; k < choices && group != NUMBERS && what != PAIRS_OF_MISTAKES; k++)
                if (k != settings_number(right, parameter))
                    add(out, &count, parameter, k, 0);
            for (int k = 1; k < choices && what == PAIRS_OF_MISTAKES; k++)
                for (int beside = 1; beside < k; beside++)
                    add(out, &count, parameter, k, beside);
        }
    return count;
}

/* --- schemes -------------------------------------------------------------------------------------------- */

/* What a scheme is chosen of: one of each axis. */
enum { AXES_OF_A_SCHEME = ANY_CHOICES, WAYS_MAX = 10 };
static const char *const mpm_axes[AXES_OF_A_SCHEME][WAYS_MAX] = {
    {"mpm.algorithm=usf", "mpm.algorithm=usl", "mpm.algorithm=musl"},
    {"mpm.shape=hat", "mpm.shape=gimp", "mpm.shape=bspline2", "mpm.shape=bspline3",
     "mpm.shape=bspline2_uniform", "mpm.shape=bspline3_uniform"},
    {"mpm.transfer=flip,mpm.flip_fraction=1", "mpm.transfer=flip,mpm.flip_fraction=0",
     "mpm.transfer=apic,mpm.affine_start=gradient", "mpm.transfer=apic,mpm.affine_start=zero",
     "mpm.transfer=flip,mpm.flip_fraction=0.99", "mpm.transfer=flip,mpm.flip_fraction=0.95",
     "mpm.transfer=flip,mpm.flip_fraction=0.9", "mpm.transfer=flip,mpm.flip_fraction=0.5"},
};
static const char *const pd_axes[AXES_OF_A_SCHEME][WAYS_MAX] = {
    {"pd.stepping=verlet", "pd.stepping=euler", "pd.stepping=euler_position", "pd.stepping=leapfrog",
     "pd.stepping=leapfrog_ahead"},
    {"pd.surface_correction=none", "pd.surface_correction=energy", "pd.surface_correction=volume"},
    {"pd.surface_correction=none,pd.volume_correction=none", "pd.volume_correction=none",
     "pd.volume_correction=partial", "pd.volume_correction=hhb"}, /* the plain code is one choice */
    {"pd.influence=constant", "pd.influence=conical"},
    {"pd.horizon"},
};

/* Takes one way of an axis, "key=value,key=value"; the horizon's is .015 spacings more, as codes have it that
 * fear round-off. False: it is not allowed, or changes nothing. */
static bool take_way(Settings *settings, const char *way)
{
    char text[VALUE_MAX];
    bool changes = false;
    if (strcmp(way, "pd.horizon") == 0) {
        const double ratio = lattice_horizon(settings) / lattice_spacing(settings);
        snprintf(text, sizeof text, "%.17g", (ratio + 0.015) * lattice_spacing(settings));
        return fabs(ratio - round(ratio)) < 1e-9 && settings_change(settings, way, text, NULL);
    }
    while (*way) {
        char key[KEY_MAX];
        const size_t length = strcspn(way, "="), wide = strcspn(way + length + 1, ",");
        snprintf(key, sizeof key, "%.*s", (int)length, way);
        snprintf(text, sizeof text, "%.*s", (int)wide, way + length + 1);
        const Parameter *parameter = parameter_find(key);
        const double before = settings_number(settings, parameter);
        const bool applies = parameter_applies_to(settings, parameter); /* bodies have no start of slopes */
        if (applies && !settings_change(settings, key, text, NULL))
            return false;
        changes = changes || (applies && settings_number(settings, parameter) != before);
        way += length + 1 + wide + (way[length + 1 + wide] == ',');
    }
    return changes;
}

typedef struct Schemes {
    DiagnoseScheme *all;
    int count, room;
} Schemes;

static bool add_scheme(Schemes *schemes, const Settings *settings, int choices, int axis)
{
    if (schemes->count == schemes->room) {
        const int room = 2 * schemes->room + 16;
        DiagnoseScheme *more = realloc(schemes->all, (size_t)room * sizeof *more);
        if (!more)
            return false;
        schemes->all = more;
        schemes->room = room;
    }
    schemes->all[schemes->count++] = (DiagnoseScheme){*settings, choices, axis};
    return true;
}

/* What else a scheme may choose, beside those of one choice. */
static bool add_others(Schemes *schemes, const Settings *right, const DiagnoseTable *table)
{
    Candidate *others = malloc(CANDIDATES_MAX * sizeof *others);
    const int before = schemes->count,
              count = others ? diagnose_candidates(right, MISTAKES_AND_VALUES, others) : 0;
    bool sound = others != NULL;
    for (int i = 0; i < count && sound; i++) {
        Settings other;
        bool known =
            others[i].kind != DIAGNOSE_SCHEME || !diagnose_settings_of(&others[i], right, table, &other);
        for (int s = 0; s < before && !known; s++)
            known = schemes->all[s].choices == 1 &&
                    settings_number(&schemes->all[s].settings, others[i].parameter) == others[i].value;
        sound = known || add_scheme(schemes, &other, 1, AXES_OF_A_SCHEME);
    }
    free(others);
    return sound;
}

int diagnose_schemes(const Settings *right, const DiagnoseTable *table, int most, DiagnoseScheme **out)
{
    const char *const(*const axes)[WAYS_MAX] = right->method == METHOD_PD ? pd_axes : mpm_axes;
    Schemes schemes = {0};
    bool sound = add_scheme(&schemes, right, 0, -1);
    for (int choices = 1, first = 0; sound && choices <= most && first < schemes.count; choices++) {
        const int end = schemes.count;
        for (int axis = 0; axis < AXES_OF_A_SCHEME; axis++)
            for (int s = first; s < end; s++)
                for (int way = 0; sound && way < WAYS_MAX && axes[axis][way]; way++) {
                    /* who says that boxes are meant has no splines: of twice the length they are the same */
                    if (schemes.all[s].axis >= axis ||
                        (settings_transfer(right)->shape == MPM_GIMP && strstr(axes[axis][way], "_uniform")))
                        continue;
                    Settings other = schemes.all[s].settings;
                    if (take_way(&other, axes[axis][way]) && diagnose_hold_step(&other, table->as.dt, NULL))
                        sound = add_scheme(&schemes, &other, choices, axis);
                }
        sound = sound && (choices > 1 || add_others(&schemes, right, table));
        first = end;
    }
    if (!sound)
        free(schemes.all);
    *out = sound ? schemes.all : NULL;
    return sound ? schemes.count : 0;
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
    if (candidate->parameter && candidate->kind == DIAGNOSE_MISTAKE) /* which leaves the step */
        return settings_check(out, NULL);
    if (!candidate->own_step)
        return diagnose_hold_step(out, table->as.dt, NULL);
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
        /* "auto" is 0, and what the problem has not is NAN */
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
    if (!isfinite(factor) || tolerance > 0.05) /* else it would have every name */
        return;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (known[i].value != 1 && isfinite(known[i].value) &&
            fabs(factor - known[i].value) <= tolerance * fabs(known[i].value))
            text_append(out, size, "%s%s", *out ? " = " : "", known[i].name);
}

/* --- in words -------------------------------------------------------------------------------- */

void diagnose_name_scheme(const Settings *settings, char *out, size_t size)
{
    static const struct {
        const char *key, *before;
        double silent; /* the value of which nothing is said */
    } words[] = {{"mpm.algorithm", "", -1},
                 {"mpm.shape", "", 0},
                 {"mpm.transfer", "", 0},
                 {"mpm.flip_fraction", "flip_fraction ", 1},
                 {"mpm.affine_start", "affine start ", 0},
                 {"mpm.rotation", "rotation ", ROTATION_NONE},
                 {"pd.stepping", "", 0},
                 {"pd.surface_correction", "surface ", 0},
                 {"pd.volume_correction", "volume ", 0},
                 {"pd.influence", "influence ", 0}};
    out[0] = '\0';
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        const Parameter *parameter = parameter_find(words[i].key);
        char value[LIST_MAX];
        if (!diagnose_is_tried(settings, parameter))
            continue;
        settings_get(settings, parameter, value);
        if (i == 0)
            for (char *c = value; *c; c++)
                *c = (char)(*c >= 'a' && *c <= 'z' ? *c - 'a' + 'A' : *c);
        if (settings_number(settings, parameter) == words[i].silent)
            continue;
        text_append(out, size, "%s%s%s", *out ? ", " : "", words[i].before,
                    parameter->choice_help ? parameter->choice_help((int)settings_number(settings, parameter))
                                           : value);
    }
    if (settings->method == METHOD_PD && diagnose_is_of_plane(settings) &&
        settings_lattice(settings)->surface_correction == SURFACE_NONE &&
        settings_lattice(settings)->volume_correction == VOLUME_NONE)
        text_list_add(out, size, "no corrections");
}

/* The stage of a wrong code that differs, with its line as it is wrongly written. */
static void say_where(const Settings *wrong, char *out, size_t size, char stage[24])
{
    Simulation *sim = problem_simulate(wrong, 1, NULL);
    out[0] = '\0';
    for (int i = 0; sim && i < sim->n_stages && !*out; i++) {
        char line[512];
        if (!strstr(sim->stages[i].equation, STAGE_WRONG_OPEN))
            continue;
        text_to_ascii(sim->stages[i].equation, line, sizeof line);
        text_append(out, size, "stage %d, %s:  ", i + 1, sim->stages[i].name);
        snprintf(stage, 24, "%s", sim->stages[i].id);
        for (const char *c = line; *c; c++)
            text_append(out, size, *c == '\n' ? "    " : "%c", *c);
    }
    simulation_destroy(sim);
}

void diagnose_explain(const Candidate *candidate, const Settings *right, const Settings *wrong,
                      Explanation *out)
{
    const Parameter *parameter = candidate->parameter;
    char value[LIST_MAX], before[LIST_MAX];
    *out = (Explanation){.kind = candidate->kind};
    diagnose_name_scheme(wrong, out->scheme, sizeof out->scheme);
    if (candidate->kind == DIAGNOSE_SCHEME) {
        int choices = 0;
        for (int i = 0; i < n_parameters; i++)
            if (diagnose_is_tried(wrong, &parameters[i]) &&
                settings_number(wrong, &parameters[i]) != settings_number(right, &parameters[i])) {
                settings_get(wrong, &parameters[i], value);
                settings_get(right, &parameters[i], before);
                text_append(out->id, sizeof out->id, "%s%s=%s", choices++ > 0 ? " " : "", parameters[i].key,
                            value);
            }
        text_append(out->words, sizeof out->words,
                    choices == 1 ? "no mistake, but another choice, the scenario has %s"
                                 : "no mistake, but other choices than the scenario's",
                    before);
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
        say_where(wrong, out->where, sizeof out->where, out->stage);
        return;
    }
    text_append(out->id, sizeof out->id, "%s=%s", parameter->key, value);
    const double now = settings_number(right, parameter);
    if (now == 0 || parameter->type != PARAMETER_REAL)
        text_append(out->words, sizeof out->words, "another value, the scenario has %s", before);
    else {
        char name[96];
        diagnose_name_factor(candidate->value / now, 1e-9, right, name, sizeof name);
        text_append(out->words, sizeof out->words, "another value, the scenario's %s times %s", before,
                    *name ? name : text_rounded(candidate->value / now, 8).text);
    }
}

/* --- distinguishing two -------------------------------------------------------------------------------- */

enum { LOOK = 12, COLUMNS_MOST = 64 }; /* so many steps distinguish any two codes that differ */

/* One of two codes that run side by side. */
typedef struct Code {
    Simulation *sim;
    int set;                               /* of the file */
    const Quantity *columns[COLUMNS_MOST]; /* of the series, or of the file's set */
    int n_columns;
    size_t things;
    double *values; /* at the present step, [column][thing] */
} Code;

static bool open_code(Code *code, const Settings *settings, int set)
{
    const Simulation *sim = code->sim = diagnose_simulate(settings, 1, NULL);
    const int count = !sim ? 0 : set < 0 ? sim->n_series : sim->n_fields;
    code->set = set;
    for (int i = 0; i < count; i++) {
        if (set >= 0 && sim->fields[i].set != set)
            continue;
        if (code->n_columns == COLUMNS_MOST)
            return false;
        code->columns[code->n_columns++] = set < 0 ? &sim->series[i] : &sim->fields[i].quantity;
    }
    code->things = set < 0 || !sim ? 1 : sim->counts[set];
    code->values = malloc(((size_t)code->n_columns * code->things + 1) * sizeof *code->values);
    return sim && code->values;
}

static void read_fields(Simulation *sim, void *context)
{
    const Code *code = context;
    double *values = code->values;
    if (sim->sets[code->set].ready_after > 0)
        simulation_make_ready(sim, code->set);
    for (int f = 0; f < sim->n_fields; f++)
        if (sim->fields[f].set == code->set) {
            sim->method->field(sim, f, 0, code->things, values);
            values += code->things;
        }
}

static bool read_code(Code *code)
{
    Simulation *sim = code->sim;
    if (code->set >= 0 && sim->sets[code->set].ready_after > 0)
        return simulation_visit(sim, NULL, read_fields, code);
    if (code->set >= 0)
        read_fields(sim, code);
    else
        simulation_row(sim, code->values);
    return true;
}

/* Of the file; NULL: it has none of that name. */
static const DiagnoseColumn *column_of_file(const DiagnoseTable *table, const char *name)
{
    for (int c = 0; c < table->as.n_columns; c++)
        if (strcmp(table->as.columns[c].name, name) == 0)
            return &table->as.columns[c];
    return NULL;
}

/* The first column in which two codes differ at their present steps, with what numbers of its unit were at
 * most so far; `by_file`: of those that the file has, and to its digits. NULL: none. */
static const char *difference(const Code codes[2], const DiagnoseTable *table, bool by_file,
                              double most[COLUMNS_MOST])
{
    const Code *one = &codes[0], *two = &codes[1];
    const size_t things = one->things;
    for (int c = 0; c < one->n_columns; c++)
        for (size_t k = 0; k < things; k++)
            most[c] = fmax(most[c], fabs(one->values[(size_t)c * things + k]));
    for (int c = 0; c < one->n_columns; c++) {
        const Quantity *quantity = one->columns[c];
        const DiagnoseColumn *written = column_of_file(table, quantity->name);
        double size = 0, least = 1e-9;
        int other = 0;
        while (other < two->n_columns && strcmp(two->columns[other]->name, quantity->name) != 0)
            other++;
        if (other == two->n_columns || (by_file && !written))
            continue;
        for (int i = 0; i < one->n_columns; i++)
            if (strcmp(one->columns[i]->unit, quantity->unit) == 0)
                size = fmax(size, most[i]);
        if (by_file)
            least = fmax(least, math_pow(10, 1 - table->file.columns[written->theirs].digits));
        for (size_t k = 0; k < things; k++)
            if (fabs(one->values[(size_t)c * things + k] - two->values[(size_t)other * things + k]) >
                least * size)
                return quantity->name;
    }
    return NULL;
}

/* Whether two codes differ within some steps, and in which column. */
static bool differ(const Settings *a, const Settings *b, const DiagnoseTable *table, bool by_file,
                   char name[OVERLAY_NAME_MAX])
{
    Code codes[2] = {{.sim = NULL}, {.sim = NULL}};
    double most[COLUMNS_MOST] = {0};
    const char *found = NULL;
    bool goes_on = open_code(&codes[0], a, table->set) && open_code(&codes[1], b, table->set) &&
                   codes[0].things == codes[1].things;
    for (int step = 0; step < LOOK && goes_on && !found; step++) {
        goes_on = read_code(&codes[0]) && read_code(&codes[1]);
        found = goes_on ? difference(codes, table, by_file, most) : NULL;
        goes_on = goes_on && simulation_steps(codes[0].sim, 1, NULL, NULL, NULL) &&
                  simulation_steps(codes[1].sim, 1, NULL, NULL, NULL);
    }
    snprintf(name, OVERLAY_NAME_MAX, "%s", found ? found : "");
    for (int i = 0; i < 2; i++) {
        simulation_destroy(codes[i].sim);
        free(codes[i].values);
    }
    return *name;
}

void diagnose_tell_apart(const Settings *a, const Settings *b, const DiagnoseTable *table, Explanation *out)
{
    char name[OVERLAY_NAME_MAX];
    const size_t size = sizeof out->apart;
    out->compared = 1;
    if (differ(a, b, table, false, name)) {
        snprintf(out->apart, size,
                 column_of_file(table, name) ? "more rows or digits of %s distinguish them"
                                             : "the column %s distinguishes them",
                 name);
        return;
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
            if (!settings_nudge(&others[0], parameter, direction, false, NULL))
                continue;
            settings_get(&others[0], parameter, value);
            if (!settings_change(&others[1], parameter->key, value, NULL))
                continue;
            out->compared++;
            if (!differ(&others[0], &others[1], table, true, name))
                continue;
            text_append(out->set, sizeof out->set, "%s=%s", parameter->key, value);
            text_append(out->apart, size, "--set %s distinguishes them", out->set);
            return;
        }
    }
}

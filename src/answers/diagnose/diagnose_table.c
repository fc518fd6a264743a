/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of a foreign code as it can be laid beside a run (diagnose.h): which columns are which, of what
 * step, stage and thing each row is, and what its time step is. What is odd but can be read is noted; what
 * cannot is refused in one line. */
#include "answers/diagnose/diagnose_internal.h"
#include "scenario/settings.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"

#include "base/assertion.h"
#include "base/input.h"
#include "base/text.h"
#include "problems/problem.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* --- names ---------------------------------------------------------------------------------------------- */

/* What others call it, in the order in which a column is taken for it. */
static const struct {
    const char *ours, *others;
} synonyms[] = {
    {"step", "nstep n_step step_number timestep iteration iter it n schritt"},
    {"time", "t ta zeit times t_n tn temps sim_time simulation_time elapsed_time"},
    {"stage", "stage_number"},
    {"stage_id", "stage_name"},
    {"particle", "particle_id particle_index pid point id index"},
    {"node", "node_id node_index nid id index"},
    {"v_cm", "vcm v_com vcom com_velocity mean_velocity v_mean velocity v va vel geschwindigkeit speed v_tip "
             "vtip v_end "
             "momentum p p_cm"},
    {"x_cm", "xcm x_com xcom com_position mean_position x_mean position x xa pos u ua displacement disp "
             "verschiebung u_tip utip x_tip"},
    {"v_probe", "vy v velocity v_y vel"},
    {"u_probe", "uy u displacement deflection u_y disp w"},
    {"kinetic", "kinetic_energy e_kin ekin ek ke ka"},
    {"strain", "strain_energy e_strain estrain potential_energy epot ep se pe sa internal_energy"},
    {"total", "total_energy energy e_tot e_total etot te e"},
    {"work", "external_work w_ext"},
    {"x", "position pos xp xa x_tip"},
    {"u", "displacement disp up ua verschiebung u_tip utip"},
    {"v", "velocity vel vp va speed geschwindigkeit v_tip vtip v_end"},
    {"velocity", "v vel"},
    {"momentum", "p mv"},
    {"stress", "sigma sig s"},
    {"strain", "epsilon eps"},
    {"density", "rho"},
    {"mass", "m"},
    {"ux", "u_x"},
    {"uy", "u_y deflection w"},
    {"vx", "v_x"},
    {"vy", "v_y"},
};

void diagnose_note(DiagnoseTable *table, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (table->n_notes < DIAGNOSE_NOTES_MAX)
        vsnprintf(table->notes[table->n_notes++], sizeof table->notes[0], format, arguments);
    va_end(arguments);
}

/* What --map says of a column of theirs. */
typedef struct Mapped {
    int theirs;
    char ours[OVERLAY_NAME_MAX];
    double factor;
} Mapped;

typedef struct Names {
    Mapped mapped[DIAGNOSE_COLUMNS_MAX];
    int n_mapped;
} Names;

static bool read_map(Names *names, const Overlay *file, const char *map, Status *status)
{
    for (const char *at = map ? map + strspn(map, ", ") : ""; *at; at += strspn(at, ", ")) {
        char pair[2 * OVERLAY_NAME_MAX];
        const size_t length = strcspn(at, ",");
        snprintf(pair, sizeof pair, "%.*s", (int)(length < sizeof pair ? length : sizeof pair - 1), at);
        at += length;
        char *equals = strchr(pair, '='), *times = equals ? strchr(equals, '*') : NULL;
        if (!equals || equals == pair || names->n_mapped == DIAGNOSE_COLUMNS_MAX)
            return status_refuse(
                status, "--map: \"%.60s\" is not of the form theirs=ours or theirs=ours*FACTOR", pair);
        Mapped *mapped = &names->mapped[names->n_mapped++];
        *equals = '\0';
        mapped->factor = 1;
        if (times && (!text_to_double(times + 1, &mapped->factor) || mapped->factor == 0))
            return status_refuse(status, "--map: invalid factor %.40s", times + 1);
        if (times)
            *times = '\0';
        snprintf(mapped->ours, sizeof mapped->ours, "%.47s", equals + 1);
        if ((mapped->theirs = overlay_column(file, pair, status)) < 0)
            return status_prefix(status, "--map");
    }
    return true;
}

/* What is mapped to a name of ours; NULL: nothing. */
static const Mapped *mapped_to(const Names *names, const char *ours)
{
    for (int i = 0; i < names->n_mapped; i++)
        if (strcmp(names->mapped[i].ours, ours) == 0)
            return &names->mapped[i];
    return NULL;
}

static bool is_mapped(const Names *names, int column)
{
    for (int i = 0; i < names->n_mapped; i++)
        if (names->mapped[i].theirs == column)
            return true;
    return false;
}

static double factor_of(const Names *names, const char *ours)
{
    const Mapped *mapped = mapped_to(names, ours);
    return mapped ? mapped->factor : 1;
}

static int named(const Overlay *file, const Names *names, const char *name)
{
    for (int i = 0; i < file->n_columns; i++)
        if (!is_mapped(names, i) && strcasecmp(file->columns[i].name, name) == 0)
            return i;
    return -1;
}

/* The column of the file that is ours of that name; -1: none. `taken`: columns that are something else. */
static int column_of(const Overlay *file, const Names *names, const char *ours, const bool *taken)
{
    const Mapped *mapped = mapped_to(names, ours);
    int found = mapped ? mapped->theirs : named(file, names, ours);
    if (found >= 0)
        return found;
    for (size_t i = 0; i < sizeof synonyms / sizeof *synonyms; i++) {
        const char *others = synonyms[i].others;
        char other[OVERLAY_NAME_MAX];
        if (strcmp(synonyms[i].ours, ours) != 0)
            continue;
        while (text_next_word(&others, other, sizeof other))
            if ((found = named(file, names, other)) >= 0 && !taken[found])
                return found;
    }
    return -1;
}

static const char any_kind[] = "v_cm v x_cm u x stress kinetic strain total v_probe u_probe vy uy momentum";

/* What a column may be by another's name than ours; "": one thing alone. */
static void find_kinds(const char *name, char *out, size_t size)
{
    int count = 0;
    out[0] = '\0';
    for (size_t i = 0; i < sizeof synonyms / sizeof *synonyms; i++) {
        const char *others = synonyms[i].others;
        char other[OVERLAY_NAME_MAX];
        bool is = strcasecmp(synonyms[i].ours, name) == 0;
        while (!is && text_next_word(&others, other, sizeof other))
            is = strcasecmp(other, name) == 0;
        if (is) /* a displacement may be a place */
            text_append(out, size, "%s%s", count++ > 0 ? " " : "",
                        strcmp(synonyms[i].ours, "u") == 0 ? "u x" : synonyms[i].ours);
    }
    if (count < 2)
        out[0] = '\0';
}

/* A name without the unit behind it, "time (s)", "v [m/s]", "t_ms" and "time in ms", its words joined. */
static void clean_name(char name[OVERLAY_NAME_MAX])
{
    static const char *const units[] = {"_mm_s", "_m_s", "_ms", "_us", "_sec", "_s", "_mm"};
    const size_t length = strcspn(name, "([");
    char *in = strstr(name, " in ");
    in = in ? in : strstr(name, "_in_");
    if (length > 0)
        name[length] = '\0';
    if (in && in > name)
        *in = '\0';
    char *unit = strchr(name, '/'); /* t / s, t/ms */
    if (unit && unit > name && (strncmp(unit - 1, " / ", 3) == 0 || strlen(unit) <= 4))
        *unit = '\0';
    for (size_t end = strlen(name); end > 0 && strchr(" \t,_", name[end - 1]); end--)
        name[end - 1] = '\0';
    for (char *c = name; *c; c++)
        *c = *c == ' ' ? '_' : *c;
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        const size_t end = strlen(name), wide = strlen(units[i]);
        if (end > wide && strcmp(name + end - wide, units[i]) == 0) {
            name[end - wide] = '\0';
            break;
        }
    }
}

/* Names of columns without their units; that of the times is kept. */
static void clean_names(DiagnoseTable *table)
{
    static const struct {
        const char *name;
        double factor;
    } units[] = {{"s", 1},     {"sec", 1},          {"ms", 1e-3},       {"msec", 1e-3},
                 {"us", 1e-6}, {"\xc2\xb5s", 1e-6}, {"\xce\xbcs", 1e-6}};
    const Names none = {.n_mapped = 0};
    const bool taken[OVERLAY_COLUMNS_MAX] = {false};
    char head[OVERLAY_NAME_MAX];
    for (int c = 0; c < table->file.n_columns; c++) {
        char *name = table->file.columns[c].name;
        memcpy(head, name, sizeof head);
        clean_name(name);
        if (column_of(&table->file, &none, "time", taken) != c)
            continue;
        const char *unit = head + strlen(name);
        unit += strspn(unit, " ,_/([");
        unit += strncmp(unit, "in ", 3) == 0 || strncmp(unit, "in_", 3) == 0 ? 3 : 0;
        const size_t wide = strcspn(unit, ")] ");
        for (size_t i = 0; i < sizeof units / sizeof *units; i++)
            if (strlen(units[i].name) == wide && strncasecmp(unit, units[i].name, wide) == 0)
                table->head_factor = units[i].factor;
    }
}

/* --- words in cells ------------------------------------------------------------------------------------- */

/* The name of a stage is its number; what overflowed is infinite, and what was not written is missing. */
static bool take_word(const char *column, const char *cell, double *value, void *context)
{
    static const char *const missing[] = {"null", "none"};
    const DiagnoseTable *table = context;
    for (int i = 0; i < table->n_stages; i++)
        if (strcasecmp(cell, table->stage_ids[i]) == 0) {
            *value = i + 1;
            return true;
        }
    *value = overlay_is_not_finite(cell) ? INFINITY : NAN;
    if (!isnan(*value))
        return true;
    for (size_t i = 0; i < sizeof missing / sizeof *missing; i++)
        if (strcasecmp(cell, missing[i]) == 0)
            return true;
    return strcasecmp(column, "comment") == 0 || strcasecmp(column, "note") == 0;
}

/* --- columns -------------------------------------------------------------------------------------------- */

/* Which columns of the file say of what its rows are. */
typedef struct ColumnMap {
    int step, time, stage, stage_id, thing, i, j;
    double time_factor;
} ColumnMap;

/* What sums over bodies may cancel to 0 of: their terms in these units. P = sqrt(2 K M), L = P times the
 * extent, spin = P/(M extent). */
static double size_of_terms(Simulation *sim, const char *unit, const double *row)
{
    static const char *const units[] = {"mass*length/time", "mass*length^2/time", "rad/time"};
    static const Quantity place = {"x", "length", "", ""};
    int k = 0;
    while (k < 3 && strcmp(unit, units[k]) != 0)
        k++;
    const int kinetic = simulation_find_series(sim, "kinetic");
    if (k == 3 || kinetic < 0 || simulation_find_series(sim, "angular") < 0)
        return 0;
    const double mass = (double)sim->counts[0] * simulation_named(sim, 0, "mass", 0);
    const double extent = diagnose_size_at_start(sim, &place, row), P = sqrt(2 * row[kinetic] * mass);
    return k == 0 ? P : k == 1 ? P * extent : P / (mass * extent);
}

static bool is_displacement(const Quantity *quantity)
{
    return strncmp(quantity->name, "u", 1) == 0 && strchr("_xy", quantity->name[1]);
}

bool diagnose_are_alike(const Quantity *a, const Quantity *b)
{
    return strcmp(a->unit, b->unit) == 0 && is_displacement(a) == is_displacement(b);
}

static double noise_of(const Simulation *sim)
{
    return simulation_has(sim, HAS_BONDS) || simulation_has(sim, HAS_PLANE) ? 1e-9 : 1e-13;
}

double diagnose_size_at_start(Simulation *sim, const Quantity *like, const double *row)
{
    enum { BLOCK = 1024 };            /* one by one each bond would be looked for */
    const double last_digits = 1e-14; /* of a place, as a share of the largest */
    double size = size_of_terms(sim, like->unit, row), values[BLOCK];
    if (is_displacement(like)) {
        const Quantity place = {"x", like->unit, "", ""};
        size = last_digits / noise_of(sim) * diagnose_size_at_start(sim, &place, row);
    }
    for (int i = 0; i < sim->n_series; i++)
        if (diagnose_are_alike(&sim->series[i], like) && isfinite(row[i]))
            size = fmax(size, fabs(row[i]));
    for (int f = 0; f < sim->n_fields; f++)
        if (diagnose_are_alike(&sim->fields[f].quantity, like) && !sim->fields[f].integer)
            for (size_t k = 0, all = sim->counts[sim->fields[f].set]; k < all; k += BLOCK) {
                const size_t count = all - k < BLOCK ? all - k : BLOCK;
                sim->method->field(sim, f, k, count, values);
                for (size_t i = 0; i < count; i++)
                    if (isfinite(values[i]))
                        size = fmax(size, fabs(values[i]));
            }
    return size;
}

static void add_column(DiagnoseTable *table, int theirs, const Quantity *ours, double factor, bool own)
{
    if (table->as.n_columns == DIAGNOSE_COLUMNS_MAX)
        return;
    DiagnoseColumn *column = &table->as.columns[table->as.n_columns];
    *column = (DiagnoseColumn){
        .theirs = theirs, .factor = factor, .scale = 1, .group = table->as.n_columns, .own = own};
    snprintf(column->name, sizeof column->name, "%s", ours->name);
    snprintf(column->unit, sizeof column->unit, "%s", ours->unit);
    for (int i = 0; i < table->as.n_columns && column->group == table->as.n_columns; i++)
        if (strcmp(table->as.columns[i].unit, column->unit) == 0)
            column->group = i;
    table->as.n_columns++;
}

/* The set whose things the rows are of. A series has a column that is the series' alone, or no index. */
static int set_of(const Overlay *file, const Names *names, const Simulation *sim, ColumnMap *columns)
{
    const bool none[OVERLAY_COLUMNS_MAX] = {false};
    for (int s = 0; s < sim->n_sets; s++)
        if ((columns->thing = column_of(file, names, sim->sets[s].name, none)) >= 0)
            return s;
    /* nodes of a lattice, which are our particles */
    if (!simulation_has(sim, HAS_MESH) && (columns->thing = column_of(file, names, "node", none)) >= 0)
        return 0;
    columns->i = named(file, names, "i");
    columns->j = named(file, names, "j");
    for (int s = 0; s < sim->n_sets && columns->i >= 0 && columns->j >= 0; s++)
        if (simulation_find_field(sim, s, "i") >= 0 && simulation_find_field(sim, s, "j") >= 0)
            return s;
    return -1;
}

/* Where nothing has a name that is known, a column may be anything. */
static void add_unknown(DiagnoseTable *table, const Names *names, const bool *taken)
{
    static const Quantity anything = {"?", "", "", ""};
    for (int i = 0; i < table->file.n_columns && (table->as.n_columns == 0 || !*table->file.columns[i].name);
         i++) {
        if (taken[i] || names->n_mapped > 0)
            continue;
        add_column(table, i, &anything, 1, false);
        snprintf(table->as.columns[table->as.n_columns - 1].kinds, sizeof table->as.columns[0].kinds, "%s",
                 any_kind);
    }
}

/* Whether a column counts rows or steps by so many, from 0 or one of the first on. */
static bool does_count(const OverlayColumn *column, size_t count, double by)
{
    const double *values = column->values;
    bool counts = count > 1 && values[0] >= 0 && values[0] <= by && values[0] == floor(values[0]) &&
                  values[count - 1] > values[0];
    for (size_t r = 1; r < count && counts; r++)
        counts = values[r] == values[r - 1] || values[r] == values[r - 1] + by;
    return counts;
}

/* Whether a column without a name counts steps, or every k-th of them. It may hold whole
 * milliseconds or microseconds instead: a multiple of the scenario's step, or a part of it. */
static bool counts_steps(const OverlayColumn *column, size_t count, double dt)
{
    static const double units[] = {1e-3, 1e-6};
    for (int by = 1; by <= 25; by++) {
        bool counts = does_count(column, count, by);
        for (size_t i = 0; i < sizeof units / sizeof *units && by > 1; i++) {
            const double ratio = by * units[i] / dt, whole = fmax(ratio, 1 / ratio);
            counts = counts && !(whole < 20.5 && fabs(whole - round(whole)) < 1e-6 * whole);
        }
        if (counts)
            return true;
    }
    return false;
}

/* Columns without names: steps, times, or both come first. */
static void find_unnamed(const Overlay *file, double dt, ColumnMap *columns)
{
    for (int c = 0; c < 2 && c < file->n_columns - 1; c++) {
        const double *values = file->columns[c].values;
        bool rises = file->count > 1 && values[0] >= 0;
        for (size_t r = 1; r < file->count; r++)
            rises = rises && values[r] >= values[r - 1];
        if (c == 0 && counts_steps(&file->columns[c], file->count, dt))
            columns->step = c;
        else if (rises && columns->time < 0 && values[file->count - 1] > values[0] &&
                 (c == 0 || (columns->step == 0 && fabs(values[1] - values[0] -
                                                        (values[file->count - 1] - values[file->count - 2])) <
                                                       1e-6 * values[file->count - 1])))
            columns->time = c;
    }
}

static bool find_columns(DiagnoseTable *table, const Names *names, Simulation *sim, ColumnMap *columns,
                         Status *status)
{
    const Overlay *file = &table->file;
    bool taken[OVERLAY_COLUMNS_MAX] = {false};
    double *row = calloc((size_t)sim->n_series + 1, sizeof *row);
    char known[300] = "";
    *columns = (ColumnMap){.step = column_of(file, names, "step", taken),
                           .time = column_of(file, names, "time", taken),
                           .stage = column_of(file, names, "stage", taken),
                           .stage_id = column_of(file, names, "stage_id", taken),
                           .thing = -1,
                           .i = -1,
                           .j = -1,
                           .time_factor = factor_of(names, "time")};
    if (!row)
        return status_fail(status, "out of memory");
    simulation_row(sim, row);
    bool named_any = names->n_mapped > 0;
    for (int i = 0; i < file->n_columns; i++)
        named_any = named_any || *file->columns[i].name;
    if (!named_any)
        find_unnamed(file, sim->dt, columns);
    table->set = set_of(file, names, sim, columns);
    const int of_row[] = {columns->step,  columns->time, columns->stage, columns->stage_id,
                          columns->thing, columns->i,    columns->j};
    for (size_t i = 0; i < sizeof of_row / sizeof *of_row; i++)
        if (of_row[i] >= 0)
            taken[of_row[i]] = true;
    for (int c = 0; c < file->n_columns && named_any; c++) /* row numbers, as pandas writes them */
        taken[c] = taken[c] || (!*file->columns[c].name && does_count(&file->columns[c], file->count, 1));
    table->of_stages = columns->stage >= 0 || columns->stage_id >= 0;
    const int count = table->set < 0 ? sim->n_series : sim->n_fields;
    for (int pass = 0; pass < 2; pass++) /* by our names first: another's word must not take the place */
        for (int i = 0; i < count; i++) {
            const Quantity *ours = table->set < 0 ? &sim->series[i] : &sim->fields[i].quantity;
            if (table->set >= 0 && sim->fields[i].set != table->set)
                continue;
            if (pass == 0)
                text_list_add(known, sizeof known, ours->name);
            bool has = false;
            for (int c = 0; c < table->as.n_columns; c++)
                has = has || strcmp(table->as.columns[c].name, ours->name) == 0;
            const int theirs = has         ? -1
                               : pass == 0 ? named(file, names, ours->name)
                                           : column_of(file, names, ours->name, taken);
            if (theirs < 0 || taken[theirs])
                continue;
            taken[theirs] = true;
            const bool own = pass == 0 || is_mapped(names, theirs);
            add_column(table, theirs, ours, pass == 0 ? 1 : factor_of(names, ours->name), own);
            if (!own)
                find_kinds(file->columns[theirs].name, table->as.columns[table->as.n_columns - 1].kinds,
                           sizeof table->as.columns[0].kinds);
        }
    add_unknown(table, names, taken);
    for (int c = 0; c < table->as.n_columns; c++) {
        DiagnoseColumn *column = &table->as.columns[c];
        column->natural = diagnose_size_at_start(sim, &(Quantity){column->name, "", column->unit, ""}, row);
        column->terms = diagnose_terms(file, column->theirs);
    }
    free(row);
    for (int i = 0; i < names->n_mapped; i++)
        if (!taken[names->mapped[i].theirs])
            return status_refuse(status, "--map: %.40s is not a column of ours (step, time, %s)",
                                 names->mapped[i].ours, known);
    if (columns->step < 0 && columns->time < 0)
        return status_refuse(status, "%s:1: no column step or time (--map 1=time names the first so)",
                             file->file);
    return table->as.n_columns > 0 ||
           status_refuse(status, "%s:1: none of its columns is one of %s (--map theirs=ours)", file->file,
                         known);
}

/* --- steps ---------------------------------------------------------------------------------------------- */

typedef struct Place {
    long step;
    int stage;
    size_t thing, row;
} Place;

static int by_place(const void *a, const void *b)
{
    const Place *p = a, *q = b;
    if (p->step != q->step)
        return p->step < q->step ? -1 : 1;
    if (p->stage != q->stage)
        return p->stage < q->stage ? -1 : 1;
    if (p->thing != q->thing)
        return p->thing < q->thing ? -1 : 1;
    return p->row < q->row ? -1 : p->row > q->row;
}

static bool whole_number(double value, double most, long *out)
{
    if (!(value >= 0 && value <= most) || value != floor(value))
        return false;
    *out = (long)value;
    return true;
}

/* A unit of the last digit with which the time of a row is written, in our units. */
static double time_bound(const Overlay *file, const ColumnMap *columns, size_t row)
{
    const OverlayColumn *column = &file->columns[columns->time];
    const double written = column->values[row];
    return fabs(columns->time_factor) * (diagnose_last_digit(column, written) + 1e-15 * fabs(written));
}

/* The time step of times beside steps. */
static void time_step_of_steps(DiagnoseTable *table, const ColumnMap *columns, double dt)
{
    const Overlay *file = &table->file;
    const double *times = file->columns[columns->time].values, *steps = file->columns[columns->step].values;
    size_t low = file->count, high = file->count;
    for (size_t r = 0; r < file->count; r++) {
        if (!isfinite(times[r]) || !isfinite(steps[r]))
            continue;
        low = low == file->count || steps[r] < steps[low] ? r : low;
        high = high == file->count || steps[r] > steps[high] ? r : high;
    }
    if (low == file->count || steps[high] == steps[low])
        return;
    const double t[2] = {times[low] * columns->time_factor, times[high] * columns->time_factor};
    const double count = steps[high] - steps[low], own = (t[1] - t[0]) / count;
    const double bound = 2 * fmax(time_bound(file, columns, low), time_bound(file, columns, high)) / count;
    table->dt_bound = bound;
    if (!(own > 0) || fabs(own - dt) <= bound + DIAGNOSE_SAME_STEP * dt)
        return;
    table->as.dt = own;
}

/* The time step of times alone: the scenario's where rows are a multiple of it apart, else that of the rows.
 */
static bool time_step_of_times(DiagnoseTable *table, const ColumnMap *columns, Status *status)
{
    const Overlay *file = &table->file;
    const double *times = file->columns[columns->time].values;
    double first = INFINITY, last = -INFINITY, last_bound = 0, spacing = INFINITY, bound = 0, before = NAN;
    for (size_t r = 0; r < file->count; r++) {
        const double t = times[r];
        if (!isfinite(t))
            continue;
        const double own_bound = time_bound(file, columns, r) / columns->time_factor;
        if (t < -own_bound)
            return status_refuse(status, "%s: row %zu: a time below 0 (a run begins at 0)", file->file,
                                 r + 1);
        const double apart = fabs(t - before);
        if (apart > 0.5 * own_bound && apart + 2 * own_bound < spacing)
            spacing = apart, bound = 2 * own_bound;
        before = t;
        first = fmin(first, t);
        if (t > last)
            last = t, last_bound = own_bound;
    }
    if (!isfinite(spacing))
        return true;
    for (size_t r = 0; r < file->count; r++) { /* the farther from the first, the sharper */
        const double apart = times[r] - first, own_rows = round(apart / spacing);
        const double own_bound = 2 * time_bound(file, columns, r) / columns->time_factor / own_rows;
        if (own_rows >= 1 && own_rows * bound < 0.3 * spacing && own_bound < bound)
            spacing = apart / own_rows, bound = own_bound;
    }
    const double rows = fmax(1, round((last - first) / spacing));
    table->spacing = (last - first) / rows;
    table->spacing_bound = (last_bound + 1e-9 * spacing) / rows;
    double low = 0, high = INFINITY; /* what every row allows, each by its own digits */
    for (size_t r = 0; r < file->count; r++) {
        const double apart = times[r] - first, own_rows = round(apart / table->spacing);
        const double own_bound = 0.51 * time_bound(file, columns, r) / columns->time_factor;
        if (!(own_rows >= 1))
            continue;
        low = fmax(low, (apart - own_bound) / own_rows);
        high = fmin(high, (apart + own_bound) / own_rows);
    }
    if (first == 0 && low < high) {
        table->spacing = (low + high) / 2;
        table->spacing_bound = (high - low) / 2 + 1e-9 * spacing / rows;
    }
    table->dt_bound = table->spacing_bound * columns->time_factor;
    return true;
}

/* Counted from 1, as where arrays begin so. */
static bool counted_from_one(const OverlayColumn *column, size_t count)
{
    return column->least == 1 && column->largest == (double)count;
}

/* Ends of bonds in order of their numbers. */
typedef struct Ends {
    long i, j;
    size_t bond;
} Ends;

static int by_ends(const void *a, const void *b)
{
    const Ends *p = a, *q = b;
    return p->i != q->i ? (p->i < q->i ? -1 : 1) : p->j != q->j ? (p->j < q->j ? -1 : 1) : 0;
}

static Ends *ends_of(const Simulation *sim, int set)
{
    const size_t count = sim->counts[set];
    Ends *ends = malloc((count + 1) * sizeof *ends);
    const int fi = simulation_find_field(sim, set, "i"), fj = simulation_find_field(sim, set, "j");
    for (size_t k = 0; ends && k < count; k++) {
        const long i = (long)simulation_value(sim, fi, k), j = (long)simulation_value(sim, fj, k);
        ends[k] = i < j ? (Ends){i, j, k} : (Ends){j, i, k};
    }
    if (ends)
        qsort(ends, count, sizeof *ends, by_ends);
    return ends;
}

/* Of which thing a row is. */
static bool thing_of(const DiagnoseTable *table, const ColumnMap *columns, const Simulation *sim,
                     const Ends *ends, size_t row, size_t *thing, Status *status)
{
    const Overlay *file = &table->file;
    const size_t count = sim->counts[table->set];
    if (ends) {
        long i, j;
        const double a = file->columns[columns->i].values[row], b = file->columns[columns->j].values[row];
        const Ends key = whole_number(fmin(a, b), 1e15, &i) && whole_number(fmax(a, b), 1e15, &j)
                             ? (Ends){i, j, 0}
                             : (Ends){-1, -1, 0};
        const Ends *found = bsearch(&key, ends, count, sizeof *ends, by_ends);
        if (!found)
            return status_refuse(status, "%s: row %zu: there is no bond from %g to %g", file->file, row + 1,
                                 a, b);
        *thing = found->bond;
        return true;
    }
    const OverlayColumn *column = &file->columns[columns->thing];
    const double index = column->values[row] - (counted_from_one(column, count) ? 1 : 0);
    long number;
    if (!whole_number(index, (double)count - 1, &number))
        return status_refuse(status, "%s: row %zu: %s %g: the scenario has %zu (0 to %zu)", file->file,
                             row + 1, table->thing, column->values[row], count, count - 1);
    *thing = (size_t)number;
    return true;
}

static bool place_of(const DiagnoseTable *table, const ColumnMap *columns, const Simulation *sim,
                     const Ends *ends, size_t row, Place *place, Status *status)
{
    const Overlay *file = &table->file;
    long stage = 0;
    *place = (Place){.row = row};
    if (columns->step >= 0) {
        if (!whole_number(file->columns[columns->step].values[row], 1e12, &place->step))
            return status_refuse(status, "%s: row %zu: step %g is not a whole number from 0 on", file->file,
                                 row + 1, file->columns[columns->step].values[row]);
    } else {
        const double time = file->columns[columns->time].values[row];
        const double steps = table->spacing > 0 ? floor(time / table->spacing + 0.25) : 0; /* half ones too */
        if (!(steps >= -0.5 && steps <= 1e12))
            return status_refuse(status, "%s: row %zu: no time", file->file, row + 1);
        place->step = (long)steps; /* in order; which they are a reading says */
    }
    if (table->of_stages) {
        const int column = columns->stage_id >= 0 ? columns->stage_id : columns->stage;
        if (!whole_number(file->columns[column].values[row], table->n_stages, &stage) || stage < 1 ||
            place->step < 1)
            return status_refuse(status, "%s: row %zu: %s (1 to %d, of steps from 1 on)", file->file, row + 1,
                                 "no such stage", table->n_stages);
        place->stage = (int)stage;
    }
    return table->set < 0 || thing_of(table, columns, sim, ends, row, &place->thing, status);
}

/* Places in order become moments. */
static bool take_moments(DiagnoseTable *table, const Place *places, Status *status)
{
    const size_t count = table->file.count;
    for (size_t r = 0; r < count; r++) {
        const Place *now = &places[r], *before = r > 0 ? &places[r - 1] : NULL;
        const bool same = before && now->step == before->step && now->stage == before->stage;
        if (same && now->thing == before->thing) {
            char thing[48] = "";
            if (table->set >= 0)
                snprintf(thing, sizeof thing, ", %s %zu", table->thing, now->thing);
            return status_refuse(status, "%s: rows %zu and %zu are both of step %ld%s", table->file.file,
                                 before->row + 1, now->row + 1, now->step, thing);
        }
        if (!same)
            table->moments[table->n_moments++] = (DiagnoseMoment){now->step, now->stage, r, 0};
        table->moments[table->n_moments - 1].count++;
        table->rows[r] = now->row;
        table->things[r] = now->thing;
    }
    return true;
}

static bool place_rows(DiagnoseTable *table, const ColumnMap *columns, const Simulation *sim, Status *status)
{
    const size_t count = table->file.count;
    const bool by_ends_alone = table->set >= 0 && columns->thing < 0;
    Place *places = malloc(count * sizeof *places);
    Ends *ends = by_ends_alone ? ends_of(sim, table->set) : NULL;
    table->moments = malloc(count * sizeof *table->moments);
    table->rows = malloc(count * sizeof *table->rows);
    table->things = malloc(count * sizeof *table->things);
    bool sound = (places && table->moments && table->rows && table->things && (ends || !by_ends_alone)) ||
                 status_fail(status, "not enough memory for %s", table->file.file);
    bool ordered = true;
    for (size_t r = 0; r < count && sound; r++) {
        sound = place_of(table, columns, sim, ends, r, &places[r], status);
        ordered = ordered && (r == 0 || places[r].step >= places[r - 1].step);
    }
    if (sound && !ordered)
        diagnose_note(table, "its rows are not in the order of their steps: they were sorted");
    if (sound)
        qsort(places, count, sizeof *places, by_place);
    sound = sound && take_moments(table, places, status);
    free(places);
    free(ends);
    return sound;
}

/* What is not a number (nan, inf) is missing where numbers of the same thing follow, as in the first row of a
 * velocity; from the last of them on it is what became of a run. */
static bool find_lost(DiagnoseTable *table, size_t things, Status *status)
{
    const size_t count = table->file.count;
    bool *follow = malloc(things * sizeof *follow);
    for (int c = 0; c < table->as.n_columns && follow; c++) {
        double *values = table->file.columns[table->as.columns[c].theirs].values;
        memset(follow, 0, things * sizeof *follow);
        for (size_t r = count; r-- > 0;) {
            double *value = &values[table->rows[r]];
            ASSERT_INDEX(table->things[r], things);
            if (isinf(*value) && follow[table->things[r]])
                *value = NAN;
            follow[table->things[r]] = follow[table->things[r]] || isfinite(*value);
        }
    }
    const bool sound = follow || status_fail(status, "out of memory");
    free(follow);
    return sound;
}

static void say_what_is_odd(DiagnoseTable *table, const ColumnMap *columns, const Simulation *sim)
{
    const Overlay *file = &table->file;
    size_t gaps = 0;
    for (size_t m = 2; m < table->n_moments && !table->of_stages; m++)
        gaps += table->moments[m].step - table->moments[m - 1].step !=
                table->moments[1].step - table->moments[0].step;
    if (gaps > 0)
        diagnose_note(table, "steps are missing (gaps: %zu); those that are there were compared", gaps);
    if (table->set >= 0 && columns->thing >= 0 &&
        counted_from_one(&file->columns[columns->thing], sim->counts[table->set]))
        diagnose_note(table, "its %s are counted from 1: %s 1 is our %s 0", sim->sets[table->set].plural,
                      table->thing, table->thing);
    for (int c = 0; c < table->as.n_columns; c++) {
        const DiagnoseColumn *column = &table->as.columns[c];
        const char *theirs = file->columns[column->theirs].name;
        for (int i = column->theirs + 1; i < file->n_columns; i++)
            if (*theirs && strcasecmp(theirs, file->columns[i].name) == 0)
                diagnose_note(table, "it has several columns %s: the first counts", theirs);
    }
}

Simulation *diagnose_simulate(const Settings *settings, int threads, Status *status)
{
    Settings asked = *settings;
    strcpy(settings_edit_output(&asked)->columns, "all");
    settings_edit_output(&asked)->follow[0] = '\0';
    return problem_simulate(&asked, threads, status);
}

/* --- the whole ------------------------------------------------------------------------------------------ */

/* More entries than these add nothing. */
enum { ENTRIES_MAX = 8000000 };

/* Whether rows hold no number of any column. */
static bool is_empty(const DiagnoseTable *table, const DiagnoseMoment *moment)
{
    for (size_t row = moment->first; row < moment->first + moment->count; row++)
        for (int c = 0; c < table->as.n_columns; c++)
            if (!isnan(diagnose_theirs(table, &table->as.columns[c], row)))
                return false;
    return true;
}

/* `last`: the scenario's own last step. A file that asks for far more than that is a slip. */
static bool cut(DiagnoseTable *table, long last, Status *status)
{
    const double steps = fmax(1e5, 10.0 * (double)last);
    const size_t most = ENTRIES_MAX / (size_t)table->as.n_columns;
    size_t kept = table->n_moments;
    while (kept > 1 && is_empty(table, &table->moments[kept - 1]))
        kept--;
    while (kept > 1 && (diagnose_rows(table, kept) > most || (double)table->moments[kept - 1].step > steps))
        kept--;
    if ((double)table->moments[0].step > steps)
        return status_refuse(status, "%s: begins at step %ld, and the scenario has %ld", table->file.file,
                             table->moments[0].step, last);
    table->n_moments = table->all_moments = kept;
    return true;
}

static void find_range(OverlayColumn *column, size_t count)
{
    column->least = column->largest = NAN;
    for (size_t r = 0; r < count; r++) {
        column->least = fmin(column->least, column->values[r]);
        column->largest = fmax(column->largest, column->values[r]);
    }
}

/* The number of a thing in a head: 50 of "v50" behind a stem of one letter. False: it has no such stem. */
static bool number_in(const char *head, const char *stem, size_t length, double *number)
{
    return strncmp(head, stem, length) == 0 && isdigit((unsigned char)head[length]) &&
           text_to_double(head + length, number);
}

/* Of a wide table, times and then a column for each thing of a set, a long one: a row for each thing, as
 * tables of things are. */
static bool lengthen(Overlay *file, const Simulation *sim, Status *status)
{
    const char *last = file->columns[file->n_columns - 1].name;
    const size_t stem = strcspn(last, "0123456789");
    double number;
    int first = *last ? file->n_columns : 1;
    while (*last && first > 0 && stem > 0 && number_in(file->columns[first - 1].name, last, stem, &number))
        first--;
    const size_t wide = (size_t)(file->n_columns - first), count = file->count;
    int set = 0;
    while (set < sim->n_sets && (sim->counts[set] != wide || sim->sets[set].ready_after > 0))
        set++;
    if (set == sim->n_sets || wide < 3 || first < 1)
        return true;
    if (count > OVERLAY_CELLS_MAX / wide / (size_t)(first + 2))
        return status_refuse(status, "%s: too many numbers (at most 64 million, a row for each %s)",
                             file->file, sim->sets[set].name);
    Overlay tall = {.count = count * wide, .n_columns = first + 2, .y = -1};
    memcpy(tall.file, file->file, sizeof tall.file);
    tall.columns = calloc((size_t)tall.n_columns, sizeof *tall.columns);
    bool sound = tall.columns != NULL;
    for (int c = 0; c < tall.n_columns && sound; c++) {
        OverlayColumn *column = &tall.columns[c];
        *column = file->columns[c < first ? c : first];
        sound = (column->values = malloc((tall.count + 1) * sizeof *column->values)) != NULL;
        for (size_t r = 0; r < tall.count && sound; r++) {
            const OverlayColumn *of = &file->columns[first + (int)(r % wide)];
            number = (double)(r % wide);
            if (*last)
                number_in(of->name, last, stem, &number);
            column->values[r] = c < first    ? file->columns[c].values[r / wide]
                                : c == first ? number
                                             : of->values[r / wide];
        }
        for (int i = 0; i < (int)wide && c > first; i++) {
            column->digits = file->columns[first + i].digits > column->digits
                                 ? file->columns[first + i].digits
                                 : column->digits;
            column->places = file->columns[first + i].places > column->places
                                 ? file->columns[first + i].places
                                 : column->places;
        }
        find_range(column, tall.count);
    }
    if (!sound) {
        overlay_close(&tall);
        return status_fail(status, "not enough memory for %s", file->file);
    }
    snprintf(tall.columns[first].name, OVERLAY_NAME_MAX, "%s", sim->sets[set].name);
    snprintf(tall.columns[first + 1].name, OVERLAY_NAME_MAX, "%.*s", (int)stem, last);
    clean_name(tall.columns[first + 1].name);
    if (strcasecmp(tall.columns[first + 1].name, "p") == 0) /* p0, p1: particles, of any quantity */
        tall.columns[first + 1].name[0] = '\0';
    if (!*last)
        snprintf(tall.columns[0].name, OVERLAY_NAME_MAX,
                 counts_steps(&file->columns[0], count, sim->dt) ? "step" : "time");
    overlay_close(file);
    *file = tall;
    return true;
}

static bool read_rows(DiagnoseTable *table, const Settings *settings, const char *map, Simulation *sim,
                      Status *status)
{
    ColumnMap columns;
    Names names = {.n_mapped = 0};
    if (!read_map(&names, &table->file, map, status) || !find_columns(table, &names, sim, &columns, status))
        return false;
    snprintf(table->thing, sizeof table->thing, "%s", table->set < 0 ? "" : sim->sets[table->set].name);
    table->stages_by_id = columns.stage_id >= 0;
    table->of_next = !table->of_stages && table->set >= 0 && sim->sets[table->set].ready_after > 0;
    table->particles = sim->counts[0];
    table->noise_growth = 1e-2;
    table->noise = noise_of(sim);
    table->as.dt = table->scenario_dt = sim->dt;
    table->as.last = INFINITY;
    table->as.time_factor = columns.time >= 0 ? columns.time_factor : 1;
    table->timed = columns.time >= 0;
    table->time_column = columns.time >= 0 ? columns.time : columns.step;
    table->step_column = columns.step;
    if (table->timed && columns.step >= 0)
        time_step_of_steps(table, &columns, sim->dt);
    if ((table->timed && columns.step < 0 && !time_step_of_times(table, &columns, status)) ||
        !place_rows(table, &columns, sim, status) ||
        !find_lost(table, table->set < 0 ? 1 : sim->counts[table->set], status))
        return false;
    say_what_is_odd(table, &columns, sim);
    return cut(table, problem_last_step(sim->dt, settings_time(settings)->end), status);
}

bool diagnose_read_from(DiagnoseTable *table, FILE *stream, const char *file, const Settings *settings,
                        const char *map, Status *status)
{
    *table = (DiagnoseTable){.set = -1, .file = {.y = -1}};
    Simulation *sim = diagnose_simulate(settings, 1, status);
    if (!sim)
        return false;
    for (int i = 0; i < sim->n_stages && i < DIAGNOSE_STAGES_MAX; i++)
        snprintf(table->stage_ids[table->n_stages++], sizeof table->stage_ids[0], "%s", sim->stages[i].id);
    bool sound = overlay_read(&table->file, stream, file, take_word, NULL, table, status);
    if (sound)
        clean_names(table);
    sound = sound && lengthen(&table->file, sim, status) && read_rows(table, settings, map, sim, status);
    simulation_destroy(sim);
    if (!sound)
        diagnose_close(table);
    return sound;
}

bool diagnose_read(DiagnoseTable *table, const char *path, const Settings *settings, const char *map,
                   Status *status)
{
    FILE *stream = input_open(path, OVERLAY_BYTES_MAX, status);
    *table = (DiagnoseTable){.set = -1, .file = {.y = -1}};
    const bool sound = stream && diagnose_read_from(table, stream, path, settings, map, status);
    if (stream)
        fclose(stream);
    return sound;
}

bool diagnose_overlay(DiagnoseTable *table, Overlay *out)
{
    Overlay *file = &table->file;
    if (table->set >= 0 || table->of_stages)
        return false;
    for (int c = 0; c < table->as.n_columns; c++) {
        OverlayColumn *theirs = &file->columns[table->as.columns[c].theirs];
        memcpy(theirs->name, table->as.columns[c].name, sizeof theirs->name);
        for (size_t r = 0; r < file->count; r++)
            theirs->values[r] *= isfinite(theirs->values[r]) ? table->as.columns[c].factor : NAN;
        find_range(theirs, file->count);
    }
    OverlayColumn *time = &file->columns[table->time_column];
    snprintf(time->name, sizeof time->name, "time");
    for (size_t m = 0; m < table->n_moments; m++)
        time->values[table->rows[table->moments[m].first]] = (double)table->moments[m].step * table->as.dt;
    find_range(time, file->count);
    *out = *file;
    *file = (Overlay){.y = -1};
    return true;
}

void diagnose_close(DiagnoseTable *table)
{
    overlay_close(&table->file);
    free(table->moments);
    free(table->rows);
    free(table->things);
    *table = (DiagnoseTable){.set = -1, .file = {.y = -1}};
}

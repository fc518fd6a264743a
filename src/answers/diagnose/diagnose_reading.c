/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a foreign table is meant (diagnose_internal.h): in what unit and step its times are, whether a row
 * carries the time of its step, and what its columns are of: the centre of mass or one point, in which unit.
 *
 * A reading is a hypothesis. Each is tried against the right code of each order of the stages, over the first
 * rows; a column may be any quantity that its name allows. The first that agrees throughout counts; where
 * none does, those whose first row agrees, the longest first. */
#include "answers/diagnose/diagnose_internal.h"

#include "base/assertion.h"
#include "base/wait.h"
#include "base/text.h"
#include "problems/problem.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_time.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

bool diagnose_time_is_up(const Search *search)
{
    search->found->time_up = search->found->time_up || clock_seconds() > search->until;
    return search->found->time_up;
}

/* --- times ---------------------------------------------------------------------------------------------- */

/* The time of a moment as it is written. */
static double time_of(const DiagnoseTable *table, size_t moment)
{
    ASSERT_INDEX(moment, table->all_moments);
    const int column = table->step_column >= 0 ? table->step_column : table->time_column;
    return table->file.columns[column].values[table->rows[table->moments[moment].first]];
}

/* The steps that the times of a reading are of: whole ones, or all half a step off. False: they are of none.
 */
static bool steps_of(DiagnoseTable *table, const DiagnoseReading *reading)
{
    const OverlayColumn *times = &table->file.columns[table->time_column];
    bool half = false;
    for (size_t m = 0; m < table->all_moments; m++) {
        double step;
        if (table->step_column >= 0)
            step = time_of(table, m);
        else {
            const double written = time_of(table, m), time = written * reading->time_factor;
            /* of few digits it may be of the nearest step alone */
            const double bound =
                fmin(0.51 * reading->time_factor * diagnose_last_digit(times, written), 0.45 * reading->dt);
            const double exact = time / reading->dt;
            half = m == 0 ? fabs(exact - floor(exact) - 0.5) < 0.01 : half;
            step = half ? floor(exact) : round(exact);
            if (!(fabs(time - (step + (half ? 0.5 : 0)) * reading->dt) <=
                  bound + 2e-6 * reading->dt + DIAGNOSE_SAME_STEP * time))
                return false;
        }
        step += (double)reading->shift;
        if (!(step >= 0 && step < 1e12) ||
            (m > 0 && step <= (double)table->moments[m - 1].step && !table->of_stages))
            return false;
        table->moments[m].step = (long)step;
    }
    table->half = half;
    const double most = fmax(1e5, 10 * reading->last);
    table->n_moments = table->all_moments;
    while (table->n_moments > 0 && (double)table->moments[table->n_moments - 1].step > most)
        table->n_moments--;
    return table->n_moments > (table->all_moments > 1 ? 1 : 0);
}

bool diagnose_read_as(DiagnoseTable *table, const DiagnoseReading *reading)
{
    if (!table->of_stages && !steps_of(table, reading))
        return false;
    table->as = *reading;
    if (table->spacing > 0)
        table->dt_bound = table->spacing_bound / table->spacing * reading->dt;
    return true;
}

/* --- what a column may be ------------------------------------------------------------------------------- */

enum { ENOUGH_DIGITS = 6, FIELDS_MAX = 64 }; /* more than any simulation has */

/* A quantity that a column may be, and how long it agrees. */
typedef struct Source {
    int of; /* fields come first, then series */
    size_t thing;
    double factor;
    size_t agreed, telling; /* entries; of them those above round-off */
    bool over, first;       /* it departs; its first entry that is not 0 agrees */
    double off;             /* its largest difference beyond the digits written, over its size */
} Source;

typedef struct Sources {
    Source *all;
    size_t count, room;
} Sources;

static const double signs_and_units[] = {1, -1, 1e-3, 1e3};

static bool add_source(Sources *sources, int of, size_t thing, double mass)
{
    for (size_t i = 0; i < sizeof signs_and_units / sizeof *signs_and_units + (mass > 0); i++) {
        if (sources->count == sources->room) {
            const size_t room = sources->room ? 2 * sources->room : 64;
            Source *more = realloc(sources->all, room * sizeof *more);
            if (!more)
                return false;
            sources->all = more;
            sources->room = room;
        }
        const double factor = i < 4 ? signs_and_units[i] : 1 / mass;
        sources->all[sources->count++] = (Source){.of = of, .thing = thing, .factor = factor};
    }
    return true;
}

/* The particles in the order in which a course looks at them: the tip, the middle, any; of many every so
 * manieth. */
enum { POINTS_MAX = 1000 };
static size_t nth_point(size_t n, size_t count)
{
    const size_t middle = count / 2, tip = count - 1;
    if (n < 2)
        return n == 0 ? tip : middle;
    const size_t k = count > POINTS_MAX ? (n - 2) * (count - 2) / (POINTS_MAX - 2) : n - 2;
    return k < middle ? k : k + 1; /* count - 2 of them are left */
}

/* A velocity may be that of a node: mapped, or after the force. */
static bool find_nodes(const DiagnoseTable *table, const DiagnoseColumn *column, Simulation *sim,
                       Sources *out)
{
    bool sound = true;
    for (int f = 0;
         f < sim->n_fields && f < FIELDS_MAX && table->set < 0 && text_has_word(column->kinds, "v"); f++)
        if (sim->sets[sim->fields[f].set].ready_after > 0 &&
            (strcmp(sim->fields[f].quantity.name, "velocity") == 0 ||
             strcmp(sim->fields[f].quantity.name, "velocity_new") == 0))
            for (size_t k = 0; k < sim->counts[sim->fields[f].set] && k < POINTS_MAX && sound; k++)
                sound = add_source(out, f, k, 0);
    return sound;
}

static bool find_sources(const DiagnoseTable *table, const DiagnoseColumn *column, Simulation *sim,
                         Sources *out)
{
    const bool of_series = table->set < 0;
    const int masses = simulation_find_field(sim, 0, "mass");
    double mass = 0; /* a column of momentum over it is v_cm */
    if (of_series && (text_has_word(column->kinds, "v_cm") || strcmp(column->name, "v_cm") == 0))
        for (size_t k = 0; masses >= 0 && k < sim->counts[0]; k++)
            mass += simulation_value(sim, masses, k);
    const int own = of_series ? simulation_find_series(sim, column->name)
                              : simulation_find_field(sim, table->set, column->name);
    bool sound = true;
    if (own >= 0)
        sound = add_source(out, of_series ? sim->n_fields + own : own, 0, column->own ? 0 : mass);
    for (int i = 0; i < sim->n_series && of_series && sound; i++)
        if (i != own && text_has_word(column->kinds, sim->series[i].name))
            sound = add_source(out, sim->n_fields + i, 0, mass);
    for (int f = 0; f < sim->n_fields && f < FIELDS_MAX && sound; f++) {
        const Field *field = &sim->fields[f];
        if (field->set != (of_series ? 0 : table->set) || !text_has_word(column->kinds, field->quantity.name))
            continue;
        if (!of_series)
            sound = f == own || add_source(out, f, 0, 0);
        const size_t points = sim->counts[0] < POINTS_MAX ? sim->counts[0] : POINTS_MAX;
        for (size_t k = 0; of_series && k < points && sound && points > 2; k++)
            sound = add_source(out, f, nth_point(k, sim->counts[0]), 0);
    }
    return sound;
}

/* --- one trial ------------------------------------------------------------------------------------------ */

enum {
    MOMENTS_MAX = 150,
    TRIAL_STEPS_MAX = 20000,
    TRIALS_MAX = 64,
    TRIAL_TIMES_MAX = 40,
    OTHERS_ROWS_LEAST = 5
};
#define TOLERANCE 2e-6 /* two readings are distinguished by more than single precision */
#define FINE      1e-9 /* or, where its numbers are finer, by as much as that of a scheme from another's */

typedef struct Trial {
    DiagnoseReading reading;
    bool plain;      /* it is kept where none agrees */
    bool denied;     /* its row of step 0 is not the start */
    int firsts;      /* columns that agree in the first row that is not 0 */
    int begun;       /* columns that agree in the first row */
    size_t agreed;   /* rows, the sum of all columns */
    bool throughout; /* all of them to the end */
    double off;      /* by so much at most, as a share of a column's size */
} Trial;

typedef struct TrialTimes {
    double factor, dt;
    long shift;
    bool plain;
} TrialTimes;

typedef struct Trials {
    const Search *search;
    Trial all[TRIALS_MAX];
    int count;
    Sources sources[DIAGNOSE_COLUMNS_MAX];
    double *row, *field[FIELDS_MAX];
    bool nodes;                        /* a velocity is one of a node */
    bool moves[DIAGNOSE_COLUMNS_MAX];  /* of a column: it had numbers other than 0 before */
    double fine;                       /* what agrees so well needs no other code */
    TrialTimes times[TRIAL_TIMES_MAX]; /* that were tried */
    int n_times;
    double doubt; /* of few digits: the step of the rows, with which no right code agrees, as one does with
                     another */
    double *size, *most; /* of the unit of fields and series at the start; of themselves so far */
    bool wanted[FIELDS_MAX];
} Trials;

static bool is_given(const DiagnoseTable *table, int c)
{
    const OverlayColumn *column = &table->file.columns[table->as.columns[c].theirs];
    const double most = fmax(fabs(column->least), fabs(column->largest)); /* of what may not be finite */
    return most > 0 && !(isinf(column->least) && isinf(column->largest));
}

static void compare_sources(Trials *trials, const Simulation *sim, size_t moment)
{
    const DiagnoseTable *table = trials->search->table;
    const DiagnoseMoment *now = &table->moments[moment];
    for (int c = 0; c < table->as.n_columns; c++) {
        const OverlayColumn *column = &table->file.columns[table->as.columns[c].theirs];
        for (size_t k = now->first; k < now->first + now->count; k++) {
            const double written = column->values[table->rows[k]];
            const double digit = 0.51 * diagnose_last_digit(column, written);
            if (!isfinite(written))
                continue;
            for (size_t i = 0; i < trials->sources[c].count; i++) {
                Source *source = &trials->sources[c].all[i];
                if (source->over)
                    continue;
                const size_t thing = table->set < 0 ? source->thing : table->things[k];
                const double ours = source->of >= sim->n_fields ? trials->row[source->of - sim->n_fields]
                                                                : trials->field[source->of][thing];
                const double size = trials->most[source->of];
                const double factor = source->factor * table->as.columns[c].factor;
                const double theirs = written * factor;
                const double beyond = fmax(0, fabs(theirs - ours) - digit * fabs(factor));
                const double scale =
                    fmax(fmax(size, fabs(theirs)), table->as.columns[c].terms * fabs(factor));
                source->over = !(beyond <= TOLERANCE * scale);
                source->off = scale > 0 ? fmax(source->off, beyond / scale) : source->off;
                source->agreed += !source->over;
                source->telling += !source->over && written != 0 && fabs(ours) > 1e3 * TOLERANCE * size;
                source->first = source->first || (!trials->moves[c] && source->telling > 0);
            }
        }
        for (size_t k = now->first; k < now->first + now->count; k++)
            trials->moves[c] = trials->moves[c] || fabs(column->values[table->rows[k]]) > 0;
    }
}

static const Quantity *nth_quantity(const Simulation *sim, int i)
{
    return i < sim->n_fields ? &sim->fields[i].quantity : &sim->series[i - sim->n_fields];
}

/* What numbers of the unit of each source are at most when the run begins. */
static void find_sizes(Trials *trials, Simulation *sim)
{
    simulation_row(sim, trials->row);
    for (int c = 0; c < trials->search->table->as.n_columns; c++)
        for (size_t k = 0; k < trials->sources[c].count; k++) {
            const int i = trials->sources[c].all[k].of;
            int alike = 0;
            while (!diagnose_are_alike(nth_quantity(sim, alike), nth_quantity(sim, i)))
                alike++;
            if (trials->size[alike] < 0)
                trials->size[alike] = diagnose_size_at_start(sim, nth_quantity(sim, i), trials->row);
            trials->size[i] = trials->size[alike];
        }
}

static void read_fields(Simulation *sim, void *context)
{
    Trials *trials = context;
    bool ready = !trials->nodes;
    for (int f = 0; f < sim->n_fields && f < FIELDS_MAX; f++) {
        const int set = sim->fields[f].set;
        if (!trials->wanted[f])
            continue;
        if (!ready)
            simulation_make_ready(sim, set);
        ready = true;
        sim->method->field(sim, f, 0, sim->counts[set], trials->field[f]);
        for (size_t k = 0; k < sim->counts[set]; k++)
            trials->most[f] = fmax(trials->most[f], fabs(trials->field[f][k]));
    }
}

/* The run as far as some source of some column agrees, and the time lasts. False: it was given up. */
static bool go_along(Trials *trials, Simulation *sim)
{
    const DiagnoseTable *table = trials->search->table;
    const size_t most = table->n_moments < MOMENTS_MAX ? table->n_moments : MOMENTS_MAX;
    size_t m = 0;
    for (bool any = true; m < most && any && table->moments[m].step <= TRIAL_STEPS_MAX; m++) {
        if (cancel_requested(&trials->search->task->cancel, 0))
            return false;
        if (diagnose_time_is_up(trials->search))
            break;
        if (!simulation_steps(sim, table->moments[m].step - sim->step, NULL, NULL, NULL)) {
            for (int c = 0; c < table->as.n_columns; c++) /* the file's run goes on */
                for (size_t i = 0; i < trials->sources[c].count; i++)
                    trials->sources[c].all[i].over = true;
            break;
        }
        simulation_row(sim, trials->row);
        for (int i = 0; i < sim->n_series; i++)
            trials->most[sim->n_fields + i] = fmax(trials->most[sim->n_fields + i], fabs(trials->row[i]));
        if (!trials->nodes)
            read_fields(sim, trials);
        else if (!simulation_visit(sim, NULL, read_fields, trials))
            return false;
        compare_sources(trials, sim, m);
        any = false;
        for (int c = 0; c < table->as.n_columns; c++)
            for (size_t i = 0; i < trials->sources[c].count && !any; i++)
                any = !trials->sources[c].all[i].over && is_given(table, c);
    }
    return true;
}

/* Whether a column whose name says nothing agrees with a source by more than chance. */
static bool is_evidence(const DiagnoseTable *table, int c, const Source *source)
{
    enum { ENTRIES = 3, DIGITS = 4 };
    return source->telling >= ENTRIES ||
           (source->first && table->file.columns[table->as.columns[c].theirs].digits >= DIGITS);
}

static void keep_best(const Trials *trials, const Simulation *sim, Trial *trial)
{
    const DiagnoseTable *table = trials->search->table;
    trial->throughout = true;
    for (int c = 0; c < table->as.n_columns; c++) {
        const Sources *sources = &trials->sources[c];
        const Source *best = NULL;
        for (size_t i = 0; i < sources->count; i++) /* zeros alone are of any that is held */
            if (!best || (sources->all[i].telling > 0 &&
                          (sources->all[i].agreed > best->agreed ||
                           (sources->all[i].agreed == best->agreed && sources->all[i].off < trials->fine &&
                            best->off > trials->fine))))
                best = &sources->all[i];
        DiagnoseColumn *column = &trial->reading.columns[c];
        if (!best || !is_given(table, c))
            continue;
        if ((trials->nodes || strcmp(column->name, "?") == 0) && !is_evidence(table, c, best)) {
            trial->throughout = trial->throughout && !trials->nodes;
            continue;
        }
        trial->throughout = trial->throughout && !best->over && best->agreed > 0;
        trial->off = fmax(trial->off, best->off);
        trial->denied = trial->denied || (table->moments[0].step == 0 && best->agreed == 0);
        trial->agreed += best->agreed;
        trial->firsts += best->first;
        trial->begun += best->agreed > 0;
        if (best->agreed == 0)
            continue;
        column->scale = best->factor;
        column->factor *= best->factor;
        const Quantity *quantity = nth_quantity(sim, best->of);
        snprintf(column->name, sizeof column->name, "%s", quantity->name);
        snprintf(column->unit, sizeof column->unit, "%s", quantity->unit);
        column->natural = fmax(trials->size[best->of], column->terms * fabs(column->factor));
        if (table->set < 0 && best->of < sim->n_fields) {
            const char *thing = sim->sets[sim->fields[best->of].set].name;
            snprintf(column->point, sizeof column->point, "%s %zu %s", thing, best->thing, quantity->name);
            snprintf(column->name, sizeof column->name, "%s_%zu_%.20s", thing, best->thing, quantity->name);
        }
    }
    trial->throughout = trial->throughout && trial->agreed > 0;
    /* what nothing of ours is like is left out */
    DiagnoseColumn *columns = trial->reading.columns;
    trial->reading.n_columns = 0;
    for (int c = 0; c < table->as.n_columns; c++)
        if (strcmp(columns[c].name, "?") != 0)
            columns[trial->reading.n_columns++] = columns[c];
    for (int c = 0; c < trial->reading.n_columns; c++)
        for (columns[c].group = 0; strcmp(columns[columns[c].group].unit, columns[c].unit) != 0;)
            columns[c].group++;
}

static bool make_room(Trials *trials, const Simulation *sim)
{
    const DiagnoseTable *table = trials->search->table;
    const size_t all = (size_t)(sim->n_series + sim->n_fields);
    bool sound = true;
    memset(trials->wanted, 0, sizeof trials->wanted);
    memset(trials->moves, 0, sizeof trials->moves);
    for (int c = 0; c < table->as.n_columns; c++)
        for (size_t i = 0; i < trials->sources[c].count; i++)
            if (trials->sources[c].all[i].of < sim->n_fields)
                trials->wanted[trials->sources[c].all[i].of] = true;
    for (int f = 0; f < FIELDS_MAX && sound; f++) { /* another scheme has others */
        free(trials->field[f]);
        trials->field[f] = NULL;
        if (trials->wanted[f])
            sound =
                (trials->field[f] = malloc((sim->counts[sim->fields[f].set] + 1) * sizeof(double))) != NULL;
    }
    free(trials->row);
    free(trials->size);
    free(trials->most);
    trials->row = malloc(((size_t)sim->n_series + 1) * sizeof *trials->row);
    trials->size = malloc((all + 1) * sizeof *trials->size);
    trials->most = calloc(all + 1, sizeof *trials->most);
    for (size_t i = 0; trials->size && i < all; i++)
        trials->size[i] = -1;
    return sound && trials->row && trials->size && trials->most;
}

/* One reading beside a code with its time step. False: it was given up, or there is no memory. */
static bool try_reading(Trials *trials, const DiagnoseReading *reading, const Settings *settings, bool plain)
{
    DiagnoseTable *table = trials->search->table;
    const DiagnoseTable begun = *table;
    if (trials->count == TRIALS_MAX || diagnose_time_is_up(trials->search) ||
        !diagnose_read_as(table, reading))
        return true;
    Simulation *sim = diagnose_simulate(settings, trials->search->task->threads, NULL);
    bool sound = true;
    for (int c = 0; c < table->as.n_columns && sim && sound; c++) {
        trials->sources[c].count = 0;
        sound = (trials->nodes ? find_nodes : find_sources)(table, &table->as.columns[c], sim,
                                                            &trials->sources[c]);
    }
    if (sim && sound && (sound = make_room(trials, sim))) {
        Trial *trial = &trials->all[trials->count++];
        *trial = (Trial){.reading = *reading, .plain = plain && !trials->nodes};
        find_sizes(trials, sim);
        sound = go_along(trials, sim);
        keep_best(trials, sim, trial);
        trials->count -= trial->reading.n_columns == 0 || (!trial->plain && !trial->throughout);
    }
    simulation_destroy(sim);
    *table = begun;
    return sound;
}

/* --- the hypotheses ------------------------------------------------------------------------------------- */

static bool is_whole(double number, double bound)
{
    return number >= 0.5 && fabs(number - round(number)) <= bound + DIAGNOSE_SAME_STEP * number;
}

/* A reading of times with columns as the file has them. */
static DiagnoseReading reading_of(const Trials *trials, const TrialTimes *times)
{
    DiagnoseReading reading = trials->search->table->as;
    reading.dt = times->dt;
    reading.time_factor = times->factor;
    reading.shift = times->shift;
    reading.last = (double)problem_last_step(times->dt, settings_time(trials->search->task->settings)->end);
    return reading;
}

/* Whether rows may carry the time before their step: the row of step 0 is not the start, or times are those
 * of half steps. */
static bool begins_later(const Trials *trials, double factor, double dt)
{
    const DiagnoseTable *table = trials->search->table;
    const double first = table->step_column < 0 ? time_of(table, 0) * factor / dt : 0;
    bool later = fabs(first - floor(first) - 0.5) < 0.01;
    for (int i = 0; i < trials->count && !later; i++)
        later = trials->all[i].plain && trials->all[i].reading.shift == 0 && trials->all[i].denied;
    return later;
}

/* Whether its rows are those of the scenario's own steps. */
static bool has_own_steps(const DiagnoseTable *table)
{
    return fabs(table->spacing - table->scenario_dt) <=
           table->spacing_bound + DIAGNOSE_SAME_STEP * table->spacing;
}

/* One reading of the times with each shift and each order of the stages; *found: one agrees throughout. */
static bool try_times(Trials *trials, double factor, double dt, bool plain, bool *found)
{
    static const long shifts[] = {0, 1, -1};
    const DiagnoseTable *table = trials->search->table;
    const Settings *right = trials->search->task->settings;
    const Parameter *order = parameter_find("mpm.algorithm");
    const bool ordered = parameter_applies_to(right, order);
    for (size_t s = 0; s < sizeof shifts / sizeof *shifts && !*found; s++) {
        const TrialTimes times = {factor, dt, shifts[s], plain};
        const DiagnoseReading reading = reading_of(trials, &times);
        if (!trials->nodes && trials->n_times < TRIAL_TIMES_MAX &&
            (plain || ((times.shift == 0 || (times.shift == 1 && begins_later(trials, factor, dt))) &&
                       factor == trials->times[0].factor &&
                       (!has_own_steps(table) || 10.5 * dt > table->spacing * factor))))
            trials->times[trials->n_times++] = times;
        for (int i = -1; i < (ordered ? parameter_in(order, right->problem).n_choices : 0) && !*found; i++) {
            Settings settings = *right;
            if (i == (int)settings_number(right, order) && ordered)
                continue;
            if (i >= 0)
                settings_put(&settings, order, i);
            const int before = trials->count;
            if (diagnose_hold_step(&settings, dt, NULL) && !try_reading(trials, &reading, &settings, plain))
                return false;
            *found = trials->count > before && trials->all[before].throughout &&
                     trials->all[before].off <= trials->fine;
        }
    }
    return true;
}

/* A plain reading beside another code. False: it was given up, or there is no memory. */
static bool try_code(Trials *trials, const DiagnoseReading *reading, const Settings *settings, bool *found)
{
    const int count = trials->count;
    if (!try_reading(trials, reading, settings, false))
        return false;
    const Trial *trial = &trials->all[count];
    const bool agrees = trials->count > count && trial->agreed >= OTHERS_ROWS_LEAST;
    trials->count = agrees ? trials->count : count;
    *found = agrees && trial->off <= trials->fine;
    return true;
}

/* Beside right codes of all schemes, which a file without its start does not show; or beside each with one
 * mistake: the start may be wrong, or what a column is may show only later, as of two particles that begin
 * alike. Passes 0 and 1: codes of few choices, with plain times, then others; 2 and 3: of many. */
typedef struct Round {
    bool wrong;       /* codes with a mistake */
    int pass, end;    /* from this pass to before that one, */
    int end_of_plane; /* or, of a plane, whose runs take longer, that one */
} Round;

static const Round rounds[] = {{false, 0, 3, 3}, {true, 0, 3, 2}, {false, 3, 4, 0}, {true, 3, 4, 0}};
enum { ROUNDS = sizeof rounds / sizeof *rounds };

/* Whether the columns have our names and begin as those of the right code: errors in later rows do not matter
 * of reading, but for a time step that nothing shows. */
static bool is_settled(const Trials *trials)
{
    const DiagnoseTable *table = trials->search->table;
    bool settled = trials->count > 0 && trials->all[0].reading.shift == 0 && trials->all[0].firsts > 0;
    for (int c = 0; c < table->as.n_columns; c++)
        settled = settled && table->as.columns[c].own;
    return settled;
}

static bool is_stable(const Settings *settings)
{
    Simulation *sim = problem_simulate(settings, 1, NULL);
    simulation_destroy(sim);
    return sim;
}

static bool try_codes(Trials *trials, const Round *round, int end, bool *found)
{
    enum { FEW_CHOICES = 1, SOME_CHOICES = 2 };
    DiagnoseTable *table = trials->search->table;
    const double dt = table->as.dt;
    const bool wrong = round->wrong, settled = is_settled(trials);
    const Settings *right = trials->search->task->settings;
    const bool of_plane = diagnose_is_of_plane(right);
    const bool sparse = table->timed && !has_own_steps(table);
    const double ratio = table->spacing * trials->times[0].factor / table->scenario_dt;
    const bool of_own_steps = is_whole(ratio, table->spacing_bound / fmax(table->spacing, 1e-300) * ratio);
    const Parameter *mistake = parameter_find(right->method == METHOD_PD ? "pd.mistake" : "mpm.mistake");
    const int mistakes =
        wrong && parameter_applies_to(right, mistake) ? parameter_in(mistake, right->problem).n_choices : 1;
    bool sound = true;
    for (int pass = round->pass; pass < end; pass++)
        for (int i = 0; i < trials->n_times && sound && !*found; i++) {
            const TrialTimes *times = &trials->times[i];
            const DiagnoseReading reading = reading_of(trials, times);
            DiagnoseScheme *schemes;
            Settings held = *right;
            if (times->plain != (pass % 2 == 0) ||
                (settled && (times->plain || (wrong && pass > 2 && !sparse))) ||
                (wrong && pass == 1 && of_plane &&
                 (of_own_steps || 10.5 * times->dt < table->spacing * times->factor)) ||
                (wrong && pass > 1 && table->set >= 0 && strcmp(table->as.columns[0].name, "?") == 0) ||
                !diagnose_hold_step(&held, times->dt, NULL) || !is_stable(&held))
                continue;
            settings_edit_lattice(&held)->step_is_known = true; /* none of the codes looks for its own */
            table->as.dt = times->dt;                           /* that of the schemes */
            const int count = diagnose_schemes(&held, table,
                                               pass < 2            ? FEW_CHOICES
                                               : wrong && pass > 2 ? SOME_CHOICES
                                                                   : ANY_CHOICES,
                                               &schemes);
            table->as.dt = dt;
            for (int s = 0; s < count; s++)
                for (int m = wrong;
                     m < mistakes && sound && !*found && (schemes[s].choices > FEW_CHOICES) == (pass >= 2) &&
                     !diagnose_time_is_up(trials->search);
                     m++) {
                    Settings settings = schemes[s].settings;
                    if (wrong)
                        settings_put(&settings, mistake, m);
                    sound = try_code(trials, &reading, &settings, found);
                }
            free(schemes);
        }
    return sound;
}

static bool is_round_to(double number, int digits, double bound)
{
    double rounded;
    return text_to_double(text_rounded(number, digits).text, &rounded) && fabs(rounded - number) <= bound;
}

/* The roundest step that times of few digits allow: a round number, or one of a round Courant number; of two
 * that are as round the nearer. */
static double roundest(double spacing, double bound, double dt)
{
    double best = INFINITY;
    for (int digits = 1; digits <= 6 && isinf(best); digits++)
        for (int k = 0; k < 2; k++) {
            const double unit = k == 0 ? dt : 1;
            double rounded;
            if (is_round_to(spacing / unit, digits, bound / unit) &&
                text_to_double(text_rounded(spacing / unit, digits).text, &rounded) &&
                fabs(rounded * unit - spacing) < fabs(best - spacing))
                best = rounded * unit;
        }
    return isinf(best) ? spacing : best;
}

/* The units of times in the order in which they are likely: rows far apart may be in ms. */
static bool try_all_times(Trials *trials, bool *found)
{
    const DiagnoseTable *table = trials->search->table;
    const double dt = table->scenario_dt, share = table->spacing_bound / fmax(table->spacing, 1e-300);
    const bool far = table->spacing > 99 * dt, farther = table->spacing > 1e5 * dt;
    /* the unit in their head first, but for one that --map has given */
    const double told = table->head_factor, first = told > 0 ? told : farther ? 1e-6 : far ? 1e-3 : 1;
    const double factors[] = {first, first == 1 ? 1e-3 : 1, first == 1e-6 ? 1e-3 : 1e-6};
    static const double steps[] = {2, 5, 0.5, 2.5, 4, 3, 8, 0.2, 0.1, 0.25, 9}; /* where no time shows it */
    static const int parts[] = {2, 3, 4, 5, 8, 10, 20, 25, 40, 50, 100};
    if (table->step_column >= 0 || table->of_stages || !(table->spacing > 0)) {
        if (!try_times(trials, table->as.time_factor, table->as.dt, true, found))
            return false;
        for (size_t i = 0; !table->timed && !table->of_stages && i < sizeof steps / sizeof *steps && !*found;
             i++)
            if (!try_times(trials, 1, steps[i] * dt, false, found))
                return false;
            else if (*found && diagnose_digits_written(table) <= ENOUGH_DIGITS)
                trials->doubt = dt; /* or by a wrong code with the scenario's */
        return true;
    }
    for (int pass = 0; pass < 2; pass++) /* the plain ones first */
        for (size_t f = 0; f < sizeof factors / sizeof *factors && !*found; f++) {
            const bool given = table->as.time_factor != 1;
            const double factor = given ? table->as.time_factor : factors[f];
            const double spacing = roundest(table->spacing * factor, table->spacing_bound * factor, dt);
            const bool likely = f == 0 || (f == 1 && far && !(told > 0));
            if (given && f > 0)
                continue;
            if (f > 0 && !likely && !(spacing > dt / 50 && spacing < 1000 * dt))
                continue;
            const bool multiple = is_whole(spacing / dt, share * spacing / dt);
            /* a table without its start begins after one step, whatever its rows are apart */
            const double begun = time_of(table, 0) * factor;
            if (pass == 0 && begun > 0 && spacing / begun > 1.5 &&
                fabs(begun - dt) > DIAGNOSE_SAME_STEP * dt &&
                is_whole(spacing / begun, share * spacing / begun) &&
                !try_times(trials, factor, begun, likely, found))
                return false;
            if (pass == 0 && multiple && !*found && !try_times(trials, factor, dt, likely, found))
                return false;
            if (*found && pass == 0 && spacing > 1.5 * dt && diagnose_digits_written(table) < ENOUGH_DIGITS) {
                *found = false; /* or by a wrong code with the step of its rows */
                if (!try_times(trials, factor, spacing, likely, found))
                    return false;
                trials->doubt = !*found ? spacing : 0;
                *found = true;
            }
            if (pass == 0 && !*found &&
                !(multiple && fabs(spacing - dt) <= share * spacing + DIAGNOSE_SAME_STEP * dt) &&
                !try_times(trials, factor, spacing, likely, found))
                return false;
            /* any part of the rows' time that is a round multiple of the scenario's step, the roundest first
             */
            for (int digits = 1; pass == 1 && digits <= 2; digits++)
                for (int k = 2; k <= 100 && !*found; k++) {
                    const double ratio = spacing / k / dt, bound = (share + DIAGNOSE_SAME_STEP) * ratio;
                    if (ratio > 0.05 && ratio < 20 && is_round_to(ratio, digits, bound) &&
                        (digits == 1 || !is_round_to(ratio, 1, bound)) &&
                        !try_times(trials, factor, spacing / k, false, found))
                        return false;
                }
            for (size_t i = 0; pass == 1 && i < sizeof parts / sizeof *parts && !*found; i++)
                if (spacing / parts[i] > dt / 20 && spacing / parts[i] < 20 * dt &&
                    !try_times(trials, factor, spacing / parts[i], false, found))
                    return false;
        }
    return true;
}

static bool is_same(const DiagnoseReading *a, const DiagnoseReading *b, int columns)
{
    bool same = a->dt == b->dt && a->time_factor == b->time_factor && a->shift == b->shift;
    for (int c = 0; c < columns; c++)
        same = same && strcmp(a->columns[c].name, b->columns[c].name) == 0 &&
               a->columns[c].factor == b->columns[c].factor;
    return same;
}

/* A sign or a power of a thousand may be a mistake and no unit. */
static int add_unscaled(const DiagnoseReading *reading, DiagnoseReading *out)
{
    bool scaled = false;
    *out = *reading;
    for (int c = 0; c < out->n_columns; c++) {
        DiagnoseColumn *column = &out->columns[c];
        scaled = scaled || column->scale != 1;
        column->factor /= column->scale;
        column->scale = 1;
    }
    return scaled;
}

/* The most columns of which a plain reading agrees in the first row. */
static int most_firsts(const Trials *trials)
{
    int most = 0;
    for (int i = 0; i < trials->count; i++)
        if (trials->all[i].plain && trials->all[i].firsts > most)
            most = trials->all[i].firsts;
    return most;
}

/* A start that agrees is better evidence than many rows of a column that hardly changes; where nothing agrees
 * the times are as they stand. */
static bool is_likelier(const Trial *one, const Trial *other)
{
    return one->begun == 0 && other->begun == 0 ? false
           : one->denied != other->denied       ? !one->denied
           : one->begun != other->begun         ? one->begun > other->begun
                                                : one->agreed > other->agreed;
}

/* The best comes first. */
static int choose(const Trials *trials, DiagnoseReading out[READINGS_MAX])
{
    const int most = most_firsts(trials);
    int count = 0;
    const Trial *nearest = NULL;
    for (int i = 0; i < trials->count; i++)
        if (trials->all[i].throughout && (!nearest || trials->all[i].off < nearest->off))
            nearest = &trials->all[i];
    if (nearest)
        out[count++] = nearest->reading;
    bool taken[TRIALS_MAX] = {false}, denied = most > 0;
    while (count < READINGS_MAX) {
        int best = -1;
        for (int i = 0; i < trials->count; i++)
            if (!taken[i] && trials->all[i].plain &&
                (trials->all[i].firsts == most ||
                 (most > 0 && trials->all[i].begun == trials->search->table->as.n_columns)) &&
                (best < 0 || is_likelier(&trials->all[i], &trials->all[best])))
                best = i;
        /* a sum that is kept agrees in rows of any step */
        for (int i = 0; i < trials->count && best < 0 && denied; i++)
            best = !taken[i] && trials->all[i].plain && !trials->all[i].denied ? i : -1;
        if (best < 0)
            break;
        taken[best] = true;
        denied = denied && trials->all[best].denied;
        bool same = false;
        for (int i = 0; i < count; i++)
            same = same || is_same(&out[i], &trials->all[best].reading, trials->search->table->as.n_columns);
        if (!same)
            out[count++] = trials->all[best].reading;
    }
    if (trials->doubt > 0 && count == READINGS_MAX)
        count--;
    for (int i = 0; i < trials->count && trials->doubt > 0 && count > 0 && count < READINGS_MAX; i++)
        if (trials->all[i].reading.dt == trials->doubt && trials->all[i].firsts > 0) {
            memmove(&out[1], &out[0], (size_t)count++ * sizeof *out);
            out[0] = trials->all[i].reading;
            out[0].otherwise = out[1].dt;
            return count;
        }
    return count > 0 && count < READINGS_MAX ? count + add_unscaled(&out[0], &out[count]) : count;
}

/* Whether the best reading has a column of one point, which several share at the start. */
static bool is_of_point(const Trials *trials)
{
    const Trial *best = NULL;
    for (int i = 0; i < trials->count; i++)
        if (trials->all[i].plain && (!best || trials->all[i].agreed > best->agreed))
            best = &trials->all[i];
    for (int c = 0; best && c < best->reading.n_columns; c++)
        if (*best->reading.columns[c].point)
            return true;
    return false;
}

int diagnose_readings(const Search *search, bool deep, DiagnoseReading out[READINGS_MAX])
{
    const DiagnoseTable begun = *search->table;
    bool given = false;
    out[0] = begun.as;
    for (int c = 0; c < begun.as.n_columns; c++)
        given = given || is_given(&begun, c);
    if (begun.of_stages || begun.of_next)
        return 1;
    Trials *trials = calloc(1, sizeof *trials);
    bool found = false;
    int count = 0;
    if (trials) {
        trials->search = search;
        trials->fine = diagnose_digits_written(search->table) > 8 && !diagnose_is_single(search->table)
                           ? FINE
                           : TOLERANCE;
        const bool of_bar = !diagnose_is_of_plane(search->task->settings);
        const int ways =
            1 + (of_bar && begun.as.n_columns == 1 && text_has_word(begun.as.columns[0].kinds, "v"));
        bool sound = true;
        for (int way = 0; way < ways && sound && !found; way++) {
            trials->nodes = way > 0;
            sound = try_all_times(trials, &found);
        }
        /* where they are settled, others are for times that nothing shows, when no code explains these; wrong
         * codes with a part of the rows' time likewise */
        const bool settled = is_settled(trials),
                   few = !given || begun.file.count * (size_t)begun.as.n_columns < OTHERS_ROWS_LEAST,
                   useless = few || (settled ? !begun.timed && !deep : deep && of_bar);
        for (int i = 0; i < ROUNDS * ways && sound && !found && trials->doubt == 0 && !useless; i++) {
            const Round *round = &rounds[i / ways];
            trials->nodes = i % ways > 0;
            if (of_bar ? !(settled && round->wrong) || deep
                       : !round->wrong || (deep && (most_firsts(trials) == 0 || is_of_point(trials))))
                sound = try_codes(trials, round, of_bar ? round->end : round->end_of_plane, &found);
        }
        for (int i = 0; i < trials->count; i++)
            found = found || trials->all[i].throughout;
        count = !sound ? -1 : deep && !found ? 0 : choose(trials, out);
        for (int f = 0; f < FIELDS_MAX; f++)
            free(trials->field[f]);
        for (int c = 0; c < DIAGNOSE_COLUMNS_MAX; c++)
            free(trials->sources[c].all);
        free(trials->row);
        free(trials->size);
        free(trials->most);
    }
    free(trials);
    *search->table = begun;
    return count;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The search for the code that made a file's numbers (diagnose.h). */
#include "answers/diagnose_internal.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "scenario/concern_body.h"
#include "scenario/concern_cells.h"

#include "base/wait.h"
#include "base/math/functions.h"
#include "base/text.h"
#include "problems/problem.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* --- the right run -------------------------------------------------------------------------------------- */

/* It may end by itself; numbers of the file that go on depart there. */
static bool walk_right(Search *search)
{
    Status why = {STATUS_DONE, ""};
    search->walk = (Walk){.table = search->table,
                          .moments = SIZE_MAX,
                          .to_end = true,
                          .values = search->values,
                          .grown = search->grown};
    const bool sound =
        diagnose_walk(&search->walk, &search->right, search->task->threads, search->task->cancel, &why);
    if (!sound && search->status)
        *search->status = why;
    const DiagnoseTable *table = search->table;
    Walk *walk = &search->walk;
    if (sound && walk->failed && !walk->departure.is && walk->compared < table->n_moments) {
        const DiagnoseMoment *next = &table->moments[walk->compared];
        const double theirs = diagnose_theirs(table, &table->columns[0], next->first);
        if (isfinite(theirs))
            walk->departure = (Departure){.is = true,
                                          .moment = walk->compared,
                                          .row = next->first,
                                          .step = next->step,
                                          .stage = next->stage,
                                          .thing = table->things[next->first],
                                          .theirs = theirs,
                                          .ours = NAN,
                                          .theirs_before = NAN,
                                          .ours_before = NAN};
    }
    return sound;
}

/* Where the file departs it may do so by no more than round-off does that grows, as at a node that hardly has
 * mass. Rows in which that is as large as the numbers have no information. */
static bool walk_with_round_off(Search *search)
{
    size_t moments;
    bool stopped = false;
    search->grown = diagnose_grown(search, &search->right, &moments, &stopped);
    if (stopped)
        return status_fail(search->status, "interrupted");
    if (!search->grown || moments == 0)
        return true;
    if (moments < search->walk.compared) {
        search->table->n_moments = moments;
        diagnose_note(search->table, "round-off grows to the size of the numbers: compared up to step %ld",
                      search->table->moments[moments - 1].step);
    }
    return walk_right(search);
}

static bool read_columns(Search *search)
{
    if (!walk_right(search) || !diagnose_judge_columns(search))
        return false;
    return search->found->verdict != DIAGNOSE_UNKNOWN ||
           (walk_right(search) && (!search->walk.departure.is || walk_with_round_off(search)));
}

static int digits_of(const Search *search, double worst)
{
    const double digits = worst > 0 ? floor(-math_log10(worst)) : 17;
    return (int)fmax(0, fmin(fmin(digits, diagnose_digits_written(search->table)), 16));
}

/* The row of the same thing before. */
static void look_back(Search *search)
{
    const DiagnoseTable *table = search->table;
    Departure *departure = &search->found->departure;
    const DiagnoseColumn *column = &table->columns[departure->column];
    for (size_t row = table->moments[departure->moment].first; row-- > 0;)
        if (table->things[row] == departure->thing) {
            departure->theirs_before = diagnose_theirs(table, column, row);
            departure->ours_before =
                search->values[row * (size_t)table->n_columns + (size_t)departure->column];
            return;
        }
}

static void name_departure(Search *search)
{
    const DiagnoseTable *table = search->table;
    Departure *departure = &search->found->departure;
    const DiagnoseColumn *column = &table->columns[departure->column];
    const double bound = diagnose_bound(table, column, departure->theirs, column->natural, departure->step);
    look_back(search);
    if (departure->ours != 0 && isfinite(departure->theirs))
        diagnose_name_factor(departure->theirs / departure->ours, 1e-12 + 2 * bound / fabs(departure->ours),
                             &search->right, departure->factors, sizeof departure->factors);
    const double change = departure->ours - departure->ours_before;
    if (isfinite(change) && fabs(change) > 20 * bound)
        diagnose_name_factor((departure->theirs - departure->theirs_before) / change,
                             1e-9 + 4 * bound / fabs(change), &search->right, departure->change_factors,
                             sizeof departure->change_factors);
    for (int c = 0; c < table->n_columns; c++)
        if (!table->columns[c].silent && !search->walk.departs[c] && !diagnose_is_still(search, c))
            text_list_add(search->found->agreeing, sizeof search->found->agreeing, table->columns[c].name);
    search->found->farthest = search->walk.farthest;
    departure->row = table->rows[departure->row] + 1;
    if (departure->stage > 0)
        departure->stage_id = table->stage_ids[departure->stage - 1];
}

/* --- other codes ---------------------------------------------------------------------------------------- */

/* Fewer can be had with any value, or with two mistakes of some. */
enum { ENTRIES_LEAST = 3 };

/* A last digit or two may be rounded the other way. */
static double beyond_of(const Walk *walk)
{
    return walk->off_digits < ENTRIES_LEAST ? 0 : walk->beyond;
}

/* A code that agrees takes its place among those found. */
static void keep(Search *search, const Candidate *candidate, const Settings *wrong, const Walk *walk)
{
    Diagnosis *found = search->found;
    if (found->n_explanations == EXPLANATIONS_MAX) {
        found->more++;
        return;
    }
    Explanation *explanation = &found->explanations[found->n_explanations];
    diagnose_explain(candidate, candidate->kind == DIAGNOSE_SCHEME ? &search->given : &search->right, wrong,
                     explanation);
    for (int i = 0; i < found->n_explanations; i++)
        if (strcmp(found->explanations[i].id, explanation->id) == 0) /* by another scheme */
            return;
    explanation->digits = digits_of(search, walk->worst);
    explanation->beyond = beyond_of(walk);
    for (size_t m = 0; m < walk->compared; m++)
        explanation->rows += search->table->moments[m].count;
    explanation->grown = walk->failed || walk->moments < search->table->n_moments;
    if (found->n_explanations++ == 0 && search->walk.departure.is) {
        search->by_first = *wrong;
        search->of_first = search->right;
        return;
    }
    if (found->n_explanations > DIAGNOSE_NAMED_MAX + 1) /* which are not printed */
        return;
    diagnose_tell_apart(wrong, &search->by_first, search->table, explanation);
}

/* Entries that agree with the right code of the scheme whose mistakes are tried, which is run when they are
 * first asked for. */
static size_t own_entries(Search *search)
{
    if (!search->own_is_known) {
        Walk walk = {.table = search->table, .moments = SIZE_MAX, .grown = search->grown};
        search->found->tried++;
        diagnose_walk(&walk, &search->right, search->task->threads, search->task->cancel, NULL);
        search->own = walk.entries;
        search->own_is_known = true;
    }
    return search->own;
}

/* Whether a run that fails, or in which round-off grows, explains more than chance does of where the right
 * ones depart, the scenario's and that of its own scheme: by the digits of all these entries, but for those
 * that a value was fitted to. Many codes share the start; a right code does not end where the file goes on.
 */
static bool is_beyond_chance(Search *search, const Candidate *candidate, const Walk *walk)
{
    enum { DIGITS = 11 }; /* some 1e5 codes are tried */
    const DiagnoseTable *table = search->table;
    const int digits = diagnose_digits_written(table); /* 0: no column has digits */
    const size_t start = table->moments[0].step > 0 ? 0 : table->moments[0].count * (size_t)table->n_columns,
                 right = search->walk.entries, before = right > start ? right : start,
                 least = (size_t)(DIGITS / (digits > 0 ? digits : 1) + 1) +
                         (candidate->kind == DIAGNOSE_VALUE ? 1 : 0);
    return (candidate->kind != DIAGNOSE_SCHEME || 2 * walk->compared >= table->n_moments) &&
           walk->entries >= before + least &&
           (candidate->kind == DIAGNOSE_SCHEME || walk->entries >= own_entries(search) + least);
}

/* Whether numbers far below those of their unit agree by more than being as small. */
static bool is_alike(const DiagnoseTable *table, const Walk *walk)
{
    const double share = 0.02;
    bool alike = true;
    for (int c = 0; c < table->n_columns; c++)
        alike = alike && (walk->most[c] == 0 || walk->off[c] <= share * walk->most[c]);
    return alike;
}

/* A code that agrees for a while and then by less and less: compared again with what round-off grows to in
 * it. False: it was given up. */
static bool try_again(Search *search, const Candidate *candidate, const Settings *wrong, Walk *walk,
                      bool *agrees)
{
    size_t moments;
    bool stopped = false;
    double *grown = diagnose_grown(search, wrong, &moments, &stopped);
    if (grown && moments > search->walk.departure.moment) {
        *walk = (Walk){.table = search->table, .moments = moments, .grown = grown};
        diagnose_walk(walk, wrong, search->task->threads, search->task->cancel, NULL);
        stopped = walk->stopped;
        *agrees = !stopped && !walk->departure.is && is_alike(search->table, walk) &&
                  is_beyond_chance(search, candidate, walk);
        walk->grown = NULL;
    }
    free(grown);
    return !stopped || status_fail(search->status, "interrupted");
}

/* False: it was given up. */
static bool try_one(Search *search, const Candidate *candidate, Walk *walk, Settings *wrong, bool *agrees)
{
    *agrees = false;
    *walk = (Walk){.table = search->table, .moments = SIZE_MAX, .grown = search->grown};
    if (diagnose_time_is_up(search) || !diagnose_settings_of(candidate, &search->right, search->table, wrong))
        return true;
    Status why = {STATUS_DONE, ""};
    search->found->tried++;
    if (!diagnose_walk(walk, wrong, search->task->threads, search->task->cancel, &why) && walk->stopped) {
        if (search->status)
            *search->status = why;
        return false;
    }
    walk->grown = NULL;
    /* it has to agree beyond where the right one departs, by more than chance where it fails, or as far as
     * the right one does */
    const bool departs = search->walk.departure.is;
    const size_t shown = departs ? search->walk.departure.moment : 0;
    *agrees = !walk->departure.is && walk->entries > 0 &&
              (departs ? is_alike(search->table, walk) && walk->compared > shown &&
                             (!walk->failed || is_beyond_chance(search, candidate, walk))
                       : walk->compared >= search->walk.compared);
    return *agrees || !departs || search->nearer || candidate->kind == DIAGNOSE_VALUE || walk->jump > 1e-3 ||
           !is_beyond_chance(search, candidate, walk) || try_again(search, candidate, wrong, walk, agrees);
}

static bool has_value(const Diagnosis *found, const Parameter *parameter)
{
    for (int i = 0; i < found->n_explanations; i++)
        if (found->explanations[i].kind != DIAGNOSE_MISTAKE &&
            strncmp(found->explanations[i].id, parameter->key, strlen(parameter->key)) == 0)
            return true;
    return false;
}

/* A factor of few digits: a slip, not a fit. */
static bool is_round(double factor, const Settings *right)
{
    char name[96];
    double shorter;
    diagnose_name_factor(factor, 1e-9, right, name, sizeof name);
    return *name || (text_to_double(text_rounded(factor, 3).text, &shorter) &&
                     fabs(shorter - factor) <= 1e-9 * fabs(factor));
}

/* Beyond it a value stands for something else, as no stiffness for no force. */
#define LEAST_FACTOR 1e-4

/* Whether a code with that value makes a time step that the file's times may mean. */
static bool may_be_its_step(const Search *search, const Settings *wrong)
{
    double own;
    return problem_time_step(wrong, &own, NULL) &&
           fabs(own - search->table->dt) <= search->table->dt_bound + 1e-12 * search->table->dt;
}

/* One parameter's value, with the file's time step or with one that follows from it. Beside a simpler
 * explanation only a round one. False: it was given up. */
static bool try_value(Search *search, const Parameter *parameter, const TimeSettings *own_step, bool simpler)
{
    Candidate candidate = {diagnose_kind(parameter), parameter, 0, 0, own_step};
    const DiagnoseTask task = {
        .settings = &search->right, .threads = search->task->threads, .cancel = search->task->cancel};
    Settings wrong;
    Walk walk;
    bool agrees;
    if (diagnose_time_is_up(search))
        return true;
    if (!diagnose_find_value(&task, search->table, &search->walk.departure, parameter, own_step,
                             &candidate.value, &search->found->tried))
        return !cancel_requested(&search->task->cancel, 0) || status_fail(search->status, "interrupted");
    const double now = settings_number(&search->right, parameter);
    const double factor = now != 0 ? candidate.value / now : candidate.value;
    if ((now != 0 && fabs(factor - 1) < 1e-5) || /* of another time step, or of fewer digits */
        (now != 0 && !(fabs(factor) > LEAST_FACTOR && fabs(factor) < 1 / LEAST_FACTOR)) ||
        (simpler && !is_round(factor, &search->right)))
        return true;
    if (!try_one(search, &candidate, &walk, &wrong, &agrees))
        return false;
    if (agrees && (!own_step || may_be_its_step(search, &wrong)))
        keep(search, &candidate, &wrong, &walk);
    return true;
}

/* Of schemes that differ in a share alone one is enough. */
static bool is_share_to_seek(const Search *search, const Parameter *parameter)
{
    return diagnose_is_share(parameter) &&
           settings_number(&search->right, parameter) == settings_number(&search->given, parameter);
}

/* One value that is another, or a round share of the scheme that is `right` at present. Where times of few
 * digits leave the step open, it may be that of the value. */
static bool try_values(Search *search, bool shares)
{
    const DiagnoseTable *table = search->table;
    const bool simpler = shares || search->found->n_explanations > 0,
               open = table->dt_bound > 1e-12 * table->dt;
    const double a_slip = 1e-8; /* less is round-off, which any value fits */
    search->own_is_known = false;
    if (search->walk.departing < ENTRIES_LEAST || search->walk.farthest < a_slip)
        return true;
    for (int by_value = 0; by_value <= (open && !simpler); by_value++)
        for (int i = 0; i < n_parameters; i++)
            if (!diagnose_time_is_up(search) && diagnose_is_tried(&search->right, &parameters[i]) &&
                parameters[i].type == PARAMETER_REAL &&
                (!shares || is_share_to_seek(search, &parameters[i])) &&
                !has_value(search->found, &parameters[i]) &&
                !try_value(search, &parameters[i], by_value ? settings_time(search->task->settings) : NULL,
                           simpler))
                return false;
    return true;
}

typedef enum Listed { MISTAKES, MISTAKES_AND_VALUES, PAIRS_OF_MISTAKES } Listed;

/* What may be wrong in the code of the scheme that is `right` at present. False: it was given up. */
static bool try_listed(Search *search, Listed what)
{
    Candidate *candidates = malloc(CANDIDATES_MAX * sizeof *candidates);
    Settings wrong;
    Walk walk;
    bool sound = candidates || status_fail(search->status, "out of memory"), agrees;
    const int count = !sound ? 0
                      : what == PAIRS_OF_MISTAKES
                          ? diagnose_pairs(&search->right, candidates)
                          : diagnose_candidates(&search->right, what == MISTAKES_AND_VALUES, candidates);
    search->own_is_known = false;
    for (int i = 0; i < count && sound; i++) {
        if (candidates[i].kind == DIAGNOSE_SCHEME)
            continue;
        sound = try_one(search, &candidates[i], &walk, &wrong, &agrees);
        if (sound && agrees)
            keep(search, &candidates[i], &wrong, &walk);
    }
    free(candidates);
    return sound;
}

/* A few numbers do not single out one of thousands of codes, and each of the plane is built for them. */
static bool of_few_numbers(const Search *search)
{
    enum { FEW_DIGITS = 15 };
    const size_t departing = search->walk.departing;
    return diagnose_is_of_plane(&search->right) &&
           (departing < 2 || departing * (size_t)diagnose_digits_written(search->table) < FEW_DIGITS);
}

/* A code that agrees has to be nearer than the others by so much to be likelier. */
#define NEARER 4

/* How far the nearest right code that agrees is from the file, beyond the digits written. */
static double right_beyond(const Search *search)
{
    const Diagnosis *found = search->found;
    double beyond = search->walk.departure.is ? INFINITY : beyond_of(&search->walk);
    for (int i = 0; i < found->n_explanations; i++)
        if (found->explanations[i].kind == DIAGNOSE_SCHEME)
            beyond = fmin(beyond, found->explanations[i].beyond);
    return beyond;
}

/* Right codes of schemes from the first on, none of more choices than the first that agrees; *fewest: of at
 * most so many. False: it was given up. */
static bool try_right(Search *search, const DiagnoseScheme *schemes, int first, int count, int *fewest)
{
    const Candidate candidate = {.kind = DIAGNOSE_SCHEME};
    Settings same;
    Walk walk;
    bool agrees, sound = true;
    for (int s = first; s < count && sound && schemes[s].choices <= *fewest; s++) {
        search->right = schemes[s].settings;
        sound = try_one(search, &candidate, &walk, &same, &agrees);
        search->right = search->given;
        if (sound && agrees) {
            keep(search, &candidate, &same, &walk);
            *fewest = schemes[s].choices;
        }
    }
    return sound;
}

/* Right codes, or else mistakes, of schemes of at most so many choices that are nearer than the right code
 * that agrees, where it is farther off than round-off. */
static bool try_nearer(Search *search, const DiagnoseScheme *schemes, int count, int choices, bool wrong)
{
    const double right = right_beyond(search), round_off = 1e-13;
    DiagnoseTable *table = search->table;
    const double noise = table->noise, growth = table->noise_growth;
    double *grown = search->grown;
    bool sound = true;
    if (right < round_off)
        return true;
    table->noise = right / NEARER, table->noise_growth = 0;
    search->grown = NULL;
    search->nearer = true;
    if (!wrong)
        sound = try_right(search, schemes, 0, count, &choices);
    for (int s = 0; s < count && sound && wrong && schemes[s].choices <= choices; s++) {
        search->right = schemes[s].settings;
        sound = try_listed(search, MISTAKES);
    }
    search->nearer = false;
    search->right = search->given;
    search->grown = grown;
    table->noise = noise, table->noise_growth = growth;
    return sound;
}

/* Right codes of all schemes; where one agrees also the mistakes that the file cannot show, in the first of
 * them and in the scenario's. */
static bool try_schemes(Search *search, const DiagnoseScheme *schemes, int count)
{
    int fewest = INT_MAX;
    bool sound = try_right(search, schemes, 1, count, &fewest);
    for (int s = 0; s < (of_few_numbers(search) ? 1 : count) && sound && search->found->n_explanations == 0;
         s++) {
        search->right = schemes[s].settings;
        sound = try_values(search, true);
    }
    search->right = search->given;
    if (!sound || search->found->n_explanations == 0)
        return sound;
    sound = try_nearer(search, schemes, count, fewest, true);
    search->right = search->by_first;
    sound = sound && try_listed(search, MISTAKES);
    search->right = search->given;
    return sound && try_listed(search, MISTAKES);
}

/* Half a kick at once is a kick of two halves without the second: such codes of bonds are one. */
static bool try_other_steppings(Search *search)
{
    const Parameter *stepping = parameter_find("pd.stepping");
    const int now = (int)settings_number(&search->of_first, stepping);
    bool sound = true;
    if (search->found->n_explanations == 0 || search->found->explanations[0].kind != DIAGNOSE_MISTAKE ||
        !parameter_applies_to(&search->of_first, stepping))
        return true;
    for (int i = 0; sound && i < parameter_in(stepping, search->right.problem).n_choices; i++) {
        search->right = search->of_first;
        settings_put(&search->right, stepping, i);
        sound = i == now || try_listed(search, MISTAKES);
    }
    search->right = search->given;
    return sound;
}

/* Where no right code agrees: what is wrong in one place, in codes of fewer choices first; then one wrong
 * value of any size, and two mistakes, by each algorithm. */
static bool try_product(Search *search, const DiagnoseScheme *schemes, int count)
{
    const bool few = search->walk.departing < ENTRIES_LEAST;
    enum { CHOICES_OF_PLANE = 3 };
    const bool plane = diagnose_is_of_plane(&search->right);
    const int all = schemes[count - 1].choices,
              most = of_few_numbers(search)                                    ? 0
                     : few && plane                                            ? 1
                     : plane && !search->task->pairs && all > CHOICES_OF_PLANE ? CHOICES_OF_PLANE
                                                                               : all;
    bool sound = true;
    for (int choices = 0; choices <= most && sound && search->found->n_explanations == 0; choices++) {
        for (int s = 0; s < count && sound; s++) {
            if (schemes[s].choices != choices)
                continue;
            search->right = schemes[s].settings;
            sound = try_listed(search, choices <= 1 ? MISTAKES_AND_VALUES : MISTAKES);
        }
        search->right = search->given;
        /* after mistakes in other schemes, to whose numbers a value may fit */
        sound = sound && (choices != (most < 1 ? most : 1) || try_values(search, false));
    }
    sound = sound && try_other_steppings(search);
    /* two mistakes, where no one thing explains the file */
    search->found->pairs_left = !few && search->found->n_explanations == 0 && !search->task->pairs && plane;
    for (int s = 0; s < count && sound && !few && search->found->n_explanations == 0; s++)
        if (s == 0 || (schemes[s].choices == 1 && settings_transfer(&schemes[s].settings)->algorithm !=
                                                      settings_transfer(&search->given)->algorithm)) {
            search->right = schemes[s].settings;
            sound = (s == 0 || try_values(search, false)) &&
                    (search->found->n_explanations > 0 || search->found->pairs_left ||
                     try_listed(search, PAIRS_OF_MISTAKES));
        }
    return sound;
}

/* Where the file departs, other right codes, or wrong ones; else the mistakes that it cannot show. */
static bool try_all(Search *search, bool wrong)
{
    DiagnoseScheme *schemes;
    search->given = search->by_first = search->right;
    const bool agrees = !search->walk.departure.is;
    const int count = diagnose_schemes(&search->right, search->table, agrees ? 1 : ANY_CHOICES, &schemes);
    if (!schemes)
        return status_fail(search->status, "out of memory");
    const bool sound = agrees
                           ? try_nearer(search, schemes, count, 1, false) &&
                                 try_nearer(search, schemes, count, 1, true) && try_listed(search, MISTAKES)
                       : wrong ? try_product(search, schemes, count)
                               : try_schemes(search, schemes, count);
    free(schemes);
    search->right = search->given;
    return sound;
}

/* --- the whole ------------------------------------------------------------------------------------------ */

/* How far the numbers agree with the right code's, and where they depart. */
static void tell_walk(Search *search)
{
    Diagnosis *found = search->found;
    const DiagnoseTable *table = search->table;
    const Walk *walk = &search->walk;
    found->compared = found->agreed = 0;
    found->agreeing[0] = '\0';
    for (size_t m = 0; m < walk->compared; m++) {
        found->compared += table->moments[m].count;
        found->agreed += m < walk->agreed ? table->moments[m].count : 0;
    }
    found->agreed_step = walk->agreed > 0 ? table->moments[walk->agreed - 1].step : -1;
    found->digits = digits_of(search, walk->worst);
    found->naive =
        search->right.method == METHOD_PD && walk->worst > 1e-11 && walk->worst < table->noise * 10;
    found->departure = walk->departure;
    diagnose_name_scheme(&search->right, found->scheme, sizeof found->scheme);
    if (walk->departure.is)
        name_departure(search);
}

/* The right code that agrees, by the scenario's scheme or another, as the first of those that may be meant.
 */
static void put_right_first(Diagnosis *found)
{
    Explanation *first = &found->explanations[0];
    if (first->kind != DIAGNOSE_SCHEME) {
        const int moved =
            found->n_explanations < EXPLANATIONS_MAX ? found->n_explanations++ : EXPLANATIONS_MAX - 1;
        memmove(first + 1, first, (size_t)moved * sizeof *first);
        *first = (Explanation){.kind = DIAGNOSE_SCHEME, .digits = found->digits, .rows = found->agreed};
        memcpy(first->scheme, found->scheme, sizeof first->scheme);
    }
    strcpy(first->id, "right");
    strcpy(first->words, "the right code, but the file is nearer to what follows");
}

/* Of right codes that agree that of fewest choices, or one that is orders nearer, comes first. Returns
 * whether it is another than the scenario's. */
static bool take_right(Search *search, double orders)
{
    Diagnosis *found = search->found;
    const bool departs = search->walk.departure.is;
    double beyond = departs ? found->explanations[0].beyond : beyond_of(&search->walk);
    int first = departs ? 0 : -1, kept = 0;
    for (int i = 0; i < found->n_explanations; i++)
        if (found->explanations[i].kind == DIAGNOSE_SCHEME &&
            found->explanations[i].beyond * orders < beyond) {
            first = i;
            beyond = found->explanations[i].beyond;
        }
    const Explanation right = found->explanations[first < 0 ? 0 : first];
    for (int i = 0; i < found->n_explanations; i++)
        if (found->explanations[i].kind != DIAGNOSE_SCHEME)
            found->explanations[kept++] = found->explanations[i];
    found->n_explanations = kept;
    if (first < 0)
        return false;
    memmove(&found->explanations[1], &found->explanations[0], (size_t)kept * sizeof right);
    found->explanations[0] = right;
    found->n_explanations++;
    return true;
}

/* Of codes that agree the nearest: mistakes whose numbers, beyond the digits written, are orders nearer than
 * those of the right code, which agrees but for what round-off may come to. Where they are nearer by less,
 * the right code remains the first of them. False: a right code explains the file. */
static bool take_nearest(Search *search)
{
    const double orders = 1e2, round_off = 1e-15;
    Diagnosis *found = search->found;
    const bool departs = search->walk.departure.is;
    if (departs && (found->n_explanations == 0 || found->explanations[0].kind != DIAGNOSE_SCHEME))
        return false;
    const double right = right_beyond(search);
    const bool other = take_right(search, orders);
    double best = right;
    for (int i = 0; i < found->n_explanations; i++)
        if (found->explanations[i].kind == DIAGNOSE_MISTAKE)
            best = fmin(best, found->explanations[i].beyond);
    best = fmax(best, round_off);
    if (right < NEARER * best)
        return other;
    found->one_is_right = right < orders * best;
    if (found->one_is_right)
        put_right_first(found);
    const double near = found->one_is_right ? right / NEARER : best * orders;
    int kept = found->one_is_right;
    for (int i = kept; i < found->n_explanations; i++)
        if (found->explanations[i].kind == DIAGNOSE_MISTAKE && found->explanations[i].beyond < near)
            found->explanations[kept++] = found->explanations[i];
    found->n_explanations = kept;
    search->of_first = departs ? search->by_first : search->given;
    if (found->one_is_right)
        return true;
    free(search->grown);
    search->grown = NULL;
    search->table->noise = best; /* where the right one departs by more */
    return true;
}

/* Beside right codes, or beside wrong ones, which are tried where no right one agrees. */
static bool judge(Search *search, bool wrong)
{
    Diagnosis *found = search->found;
    const Walk *walk = &search->walk;
    if (!read_columns(search))
        return false;
    if (found->verdict != DIAGNOSE_UNKNOWN)
        return true;
    tell_walk(search);
    settings_edit_lattice(&search->right)->step_is_known = true;
    const bool lost = search->walk.departure.moment == 0 && isinf(search->walk.departure.theirs);
    if (!lost && !try_all(search, wrong)) /* no code has nan in its first row */
        return false;
    const bool nearer = take_nearest(search), departs = walk->departure.is || nearer;
    if (departs && found->n_explanations > 0 && found->explanations[0].kind != DIAGNOSE_SCHEME) {
        search->right = search->of_first; /* what is wrong is reported beside the right code of its scheme */
        if (!walk_right(search))
            return false;
        if (walk->departure.is)
            tell_walk(search);
        search->right = search->given;
    }
    found->verdict = !departs                    ? DIAGNOSE_RIGHT
                     : found->n_explanations > 0 ? DIAGNOSE_EXPLAINED
                                                 : DIAGNOSE_UNKNOWN;
    return true;
}

/* The table as it was read before, with the steps of its rows, which are kept outside it. */
static void put_back(DiagnoseTable *table, const DiagnoseTable *left)
{
    const DiagnoseReading reading = {
        .dt = left->dt, .time_factor = left->time_factor, .shift = left->shift, .last = INFINITY};
    *table = *left;
    diagnose_read_as(table, &reading);
    *table = *left;
}

/* What was found last, or before, where that is nothing. Returns whether it was not given up. */
static bool known_or(Search *search, bool sound, const Diagnosis *before, const DiagnoseTable *as_before)
{
    if (sound && search->found->verdict == DIAGNOSE_UNKNOWN) {
        *search->found = *before;
        put_back(search->table, as_before);
    }
    return sound;
}

/* Each way to read the table, the likeliest first, up to one that a right code explains, then to one that a
 * mistake does; else as the first that a value does, or as the first. Where nothing gives the time step but
 * the numbers, readings with another than the scenario's come after its mistakes: a few digits of a curve fit
 * them both. */
static bool judge_readings(Search *search, const DiagnoseReading *readings, int count)
{
    DiagnoseTable *table = search->table;
    const DiagnoseTable begun = *table;
    const Diagnosis nothing = *search->found;
    Diagnosis first = nothing;
    DiagnoseTable as_first = begun;
    Status why = {STATUS_DONE, ""};
    bool is_first = false;
    for (int i = 0; i < 4 * count && !(is_first && diagnose_time_is_up(search)); i++) {
        const Diagnosis before = *search->found;
        const bool wrong = i / count % 2, guessed = i >= 2 * count;
        if (guessed != (!begun.timed && readings[i % count].dt != begun.scenario_dt))
            continue;
        *table = begun;
        *search->found = nothing;
        search->found->tried = before.tried;
        search->found->time_up = before.time_up;
        free(search->grown);
        search->grown = NULL;
        search->right = *search->task->settings;
        if (!diagnose_read_as(table, &readings[i % count]) ||
            !diagnose_hold_step(&search->right, table->dt, &why))
            continue;
        if (!judge(search, wrong))
            return false;
        const bool by_value = search->found->verdict == DIAGNOSE_EXPLAINED &&
                              search->found->explanations[0].kind == DIAGNOSE_VALUE;
        const bool known = search->found->verdict != DIAGNOSE_UNKNOWN,
                   few_rows = table->n_moments < table->all_moments / 2; /* where round-off grows */
        if (known && !by_value && !few_rows)
            return true;
        /* a value that fits a few rows is less likely than a mistake in another reading */
        if (is_first ? known && first.verdict == DIAGNOSE_UNKNOWN : wrong || known)
            is_first = true, first = *search->found, as_first = *table;
    }
    if (!is_first)
        return status_refuse(search->status, "%s: the scenario cannot be run with its time step %.10g%s%s",
                             table->file.file, readings[0].dt, *why.text ? ": " : "", why.text);
    first.tried = search->found->tried;
    first.time_up = search->found->time_up;
    *search->found = first;
    put_back(table, &as_first);
    return true;
}

/* What each step adds to the round-off of single precision, as a share of that of a number: a place in the
 * bar has lost the digits of a place in its cell, so weights and forces have, of which a step takes the share
 * C. */
static double single_growth(const Settings *settings, double dt)
{
    const Parameter *length = parameter_find("bar.length"), *cell = parameter_find("mesh.cell_size");
    if (!parameter_applies_to(settings, length) || !parameter_applies_to(settings, cell))
        return 0.1;
    const Material *material = settings_material(settings);
    const double wide = settings_number(settings, cell);
    return fmax(0.1, 0.3 * settings_number(settings, length) / wide * dt / wide *
                         sqrt(material->youngs_modulus / material->density));
}

/* Numbers of single precision are judged by its round-off; where no code agrees to double precision, by what
 * 8 digits and more have lost, or by single precision where no more digits are written. */
static bool judge_by_noise(Search *search, const DiagnoseReading *readings, int count)
{
    DiagnoseTable *table = search->table;
    const double single = 1.2e-7, rounded = 1e-11;
    const Diagnosis begun = *search->found;
    const DiagnoseTable as_read = *table;
    search->found->single = diagnose_is_single(table);
    if (search->found->single)
        table->noise = single, table->noise_growth = single_growth(&search->right, table->dt);
    if (!judge_readings(search, readings, count))
        return false;
    const int digits = diagnose_digits_written(table);
    if (search->found->verdict != DIAGNOSE_UNKNOWN || search->found->single || digits < 5)
        return true;
    const Diagnosis before = *search->found;
    const DiagnoseTable as_before = *table;
    const double noise = digits > 7 ? rounded : single;
    if (noise <= as_read.noise)
        return true;
    *table = as_read;
    table->noise = noise;
    table->noise_growth = noise == single ? single_growth(&search->right, table->dt) : 1e-2;
    *search->found = begun;
    search->found->single = noise == single;
    return known_or(search, judge_readings(search, readings, count), &before, &as_before);
}

/* By the likely readings; in the plane, where they lead to nothing, by that with which a wrong code agrees:
 * of what point a column is may show only where the right one departs. */
static bool judge_all(Search *search, DiagnoseReading *readings, int count)
{
    const Diagnosis begun = *search->found;
    const DiagnoseTable as_read = *search->table;
    if (!judge_by_noise(search, readings, count))
        return false;
    if (search->found->verdict != DIAGNOSE_UNKNOWN || diagnose_time_is_up(search) || of_few_numbers(search))
        return true;
    const Diagnosis before = *search->found;
    const DiagnoseTable as_before = *search->table;
    *search->table = as_read;
    count = diagnose_readings(search, true, readings);
    if (count < 0)
        return status_fail(search->status,
                           cancel_requested(&search->task->cancel, 0) ? "interrupted" : "out of memory");
    *search->found = begun;
    return known_or(search, count == 0 || judge_by_noise(search, readings, count), &before, &as_before);
}

bool diagnose(const DiagnoseTask *task, DiagnoseTable *table, Diagnosis *found, Status *status)
{
    enum { FEW = 20000 };
    Search *search = calloc(1, sizeof *search);
    *found = (Diagnosis){.agreed_step = -1, .verdict = DIAGNOSE_UNKNOWN, .rows = table->file.count};
    if (!search)
        return status_fail(status, "out of memory");
    DiagnoseTask alone = *task; /* a short run of few has no work for several threads */
    if (table->particles < FEW)
        alone.threads = 1;
    *search = (Search){.task = &alone,
                       .table = table,
                       .found = found,
                       .until = task->seconds > 0 ? clock_seconds() + task->seconds : INFINITY,
                       .right = *task->settings,
                       .status = status};
    search->values = malloc((table->file.count * (size_t)table->n_columns + 1) * sizeof *search->values);
    for (size_t i = 0; search->values && i < table->file.count * (size_t)table->n_columns; i++)
        search->values[i] = NAN;
    DiagnoseReading *readings = malloc(READINGS_MAX * sizeof *readings);
    bool sound = (search->values && readings) || status_fail(status, "out of memory");
    sound =
        sound && settings_refuse_mistake(&search->right, "a file is compared with the right code", status);
    int count = sound ? diagnose_readings(search, false, readings) : -1;
    if (count == 0 && diagnose_is_of_plane(&search->right)) /* no right code has such a first row */
        count = diagnose_readings(search, true, readings);
    sound = sound &&
            (count > 0 ||
             status_refuse(
                 status,
                 count < 0 ? "interrupted"
                 : diagnose_time_is_up(search)
                     ? "%s: the time was up before its columns were known (--time)"
                     : "%s: none of its columns is ours, as far as its first rows tell (--map 1=time,2=v_cm)",
                 table->file.file)) &&
            judge_all(search, readings, count);
    diagnose_conclude(found, table);
    free(readings);
    free(search->values);
    free(search->grown);
    free(search);
    return sound;
}

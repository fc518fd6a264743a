/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The search for the code that made a file's numbers (diagnose.h). */
#include "answers/diagnose/diagnose_internal.h"
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
    const DiagnoseTable *table = search->table;
    Walk *walk = &search->walk;
    *walk = (Walk){.table = table, .to_end = true, .values = search->values, .grown = search->grown};
    if (!diagnose_walk(walk, search->task, &search->right, search->status))
        return false;
    if (walk->failed && !walk->departure.is && walk->compared < table->n_moments) {
        const size_t row = table->moments[walk->compared].first;
        const double theirs = diagnose_theirs(table, &table->as.columns[0], row);
        if (isfinite(theirs))
            walk->departure = diagnose_departure(table, walk->compared, row, 0, theirs, NAN);
    }
    return true;
}

/* Walks along the right run once to see what the columns are worth, then beside those that are left. Where
 * the file departs it may do so by no more than round-off does that grows, as at a node that hardly has mass.
 * Rows in which that is as large as the numbers have no information. */
static bool read_columns(Search *search)
{
    size_t moments;
    bool stopped = false;
    if (!walk_right(search) || !diagnose_judge_columns(search))
        return false;
    if (search->found->verdict != DIAGNOSE_UNKNOWN)
        return true;
    if (!walk_right(search))
        return false;
    if (!search->walk.departure.is)
        return true;
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

static int digits_of(const Search *search, double worst)
{
    const double digits = worst > 0 ? floor(-math_log10(worst)) : 17;
    return (int)fmax(0, fmin(fmin(digits, diagnose_digits_written(search->table)), 16));
}

/* Names the factors by which the file departs, from what is right and, since the row of the same thing
 * before, from its change; and the columns that do not depart. */
static void name_departure(Search *search)
{
    const DiagnoseTable *table = search->table;
    Diagnosis *found = search->found;
    Departure *departure = &found->departure;
    const DiagnoseColumn *column = &table->as.columns[departure->column];
    const double bound = diagnose_rounding(table, column, departure->theirs) +
                         diagnose_noise(table, column->natural, departure->step);
    double theirs_before = NAN, ours_before = NAN;
    size_t before = table->moments[departure->moment].first;
    while (before > 0 && table->things[before - 1] != departure->thing)
        before--;
    if (before-- > 0) {
        theirs_before = diagnose_theirs(table, column, before);
        ours_before = search->values[before * (size_t)table->as.n_columns + (size_t)departure->column];
    }
    if (departure->ours != 0 && isfinite(departure->theirs))
        diagnose_name_factor(departure->theirs / departure->ours, 1e-12 + 2 * bound / fabs(departure->ours),
                             &search->right, departure->factors, sizeof departure->factors);
    const double change = departure->ours - ours_before;
    if (isfinite(change) && fabs(change) > 20 * bound)
        diagnose_name_factor((departure->theirs - theirs_before) / change, 1e-9 + 4 * bound / fabs(change),
                             &search->right, departure->change_factors, sizeof departure->change_factors);
    for (int c = 0; c < table->as.n_columns; c++)
        if (!table->as.columns[c].silent && !search->walk.departs[c] && !diagnose_is_still(search, c))
            text_list_add(found->agreeing, sizeof found->agreeing, table->as.columns[c].name);
    found->farthest = search->walk.farthest;
    departure->row = table->rows[departure->row] + 1;
    if (departure->stage > 0)
        departure->stage_id = table->stage_ids[departure->stage - 1];
}

/* --- other codes ---------------------------------------------------------------------------------------- */

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
    explanation->beyond = walk->beyond;
    explanation->rows = diagnose_rows(search->table, walk->compared);
    explanation->grown = walk->failed || walk->moments < search->table->n_moments;
    if (found->n_explanations++ == 0 && search->walk.departure.is) {
        search->by_first = *wrong;
        search->of_first = search->right;
        return;
    }
    if (found->n_explanations <= DIAGNOSE_NAMED_MAX + 1) /* others are not printed */
        diagnose_tell_apart(wrong, &search->by_first, search->table, explanation);
}

/* Whether a run that fails, or in which round-off grows, explains more than chance does of where the right
 * ones depart, the scenario's and that of its own scheme, which is run when it is first asked for: by the
 * digits of all these entries, but for those that a value was fitted to. Many codes share the start; a right
 * code does not end where the file goes on. */
static bool is_beyond_chance(Search *search, const Candidate *candidate, const Walk *walk)
{
    enum { DIGITS = 11 }; /* some 1e5 codes are tried */
    const DiagnoseTable *table = search->table;
    const int digits = diagnose_digits_written(table); /* 0: no column has digits */
    const size_t start =
                     table->moments[0].step > 0 ? 0 : table->moments[0].count * (size_t)table->as.n_columns,
                 right = search->walk.entries, before = right > start ? right : start,
                 least = (size_t)(DIGITS / (digits > 0 ? digits : 1) + 1) +
                         (candidate->kind == DIAGNOSE_VALUE ? 1 : 0);
    if (walk->entries < before + least)
        return false;
    if (candidate->kind == DIAGNOSE_SCHEME)
        return 2 * walk->compared >= table->n_moments;
    if (!search->own_is_known) {
        Walk own = {.table = table, .grown = search->grown};
        search->found->tried++;
        diagnose_walk(&own, search->task, &search->right, NULL);
        search->own = own.entries;
        search->own_is_known = true;
    }
    return walk->entries >= search->own + least;
}

/* Whether numbers far below those of their unit agree by more than being as small. */
static bool is_alike(const DiagnoseTable *table, const Walk *walk)
{
    const double share = 0.02;
    bool alike = true;
    for (int c = 0; c < table->as.n_columns; c++)
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
        diagnose_walk(walk, search->task, wrong, NULL);
        stopped = walk->stopped;
        *agrees = !stopped && !walk->departure.is && is_alike(search->table, walk) &&
                  is_beyond_chance(search, candidate, walk);
    }
    free(grown);
    return !stopped || status_fail(search->status, "interrupted");
}

/* Keeps a code that agrees: beyond where the right one departs, by more than chance where it fails, or as far
 * as the right one does. One that makes its own time step has to make the file's. False: it was given up. */
static bool try_one(Search *search, const Candidate *candidate)
{
    const DiagnoseTable *table = search->table;
    const Walk *right = &search->walk;
    Walk walk = {.table = table, .grown = search->grown};
    Settings wrong;
    Status why = {STATUS_DONE, ""};
    double dt;
    if (diagnose_time_is_up(search) || !diagnose_settings_of(candidate, &search->right, table, &wrong))
        return true;
    search->found->tried++;
    if (!diagnose_walk(&walk, search->task, &wrong, &why) && walk.stopped)
        return status_take(search->status, &why);
    bool agrees = !walk.departure.is && walk.entries > 0;
    if (!right->departure.is)
        agrees = agrees && walk.compared >= right->compared;
    else {
        agrees = agrees && is_alike(table, &walk) && walk.compared > right->departure.moment &&
                 (!walk.failed || is_beyond_chance(search, candidate, &walk));
        if (!agrees && !search->nearer && candidate->kind != DIAGNOSE_VALUE && !(walk.jump > 1e-3) &&
            is_beyond_chance(search, candidate, &walk) &&
            !try_again(search, candidate, &wrong, &walk, &agrees))
            return false;
    }
    if (agrees && candidate->own_step)
        agrees = problem_time_step(&wrong, &dt, NULL) &&
                 fabs(dt - table->as.dt) <= table->dt_bound + 1e-12 * table->as.dt;
    if (agrees)
        keep(search, candidate, &wrong, &walk);
    return true;
}

/* One parameter's value, with the file's time step or with one that follows from it. Beside a simpler
 * explanation only a round one: a factor of few digits is a slip, not a fit. False: it was given up. */
static bool try_value(Search *search, const Parameter *parameter, const TimeSettings *own_step, bool simpler)
{
    const double least = 1e-4; /* beyond it a value stands for something else, as no stiffness for no force */
    Candidate candidate = {diagnose_kind(parameter), parameter, 0, 0, own_step};
    DiagnoseTask task = *search->task;
    char name[96];
    double shorter;
    if (diagnose_time_is_up(search))
        return true;
    task.settings = &search->right;
    if (!diagnose_find_value(&task, search->table, &search->walk.departure, parameter, own_step,
                             &candidate.value, &search->found->tried))
        return !cancel_requested(&task.cancel, 0) || status_fail(search->status, "interrupted");
    const double now = settings_number(&search->right, parameter);
    const double factor = now != 0 ? candidate.value / now : candidate.value;
    if (now != 0 && (fabs(factor - 1) < 1e-5 || /* of another time step, or of fewer digits */
                     !(fabs(factor) > least && fabs(factor) < 1 / least)))
        return true;
    diagnose_name_factor(factor, 1e-9, &search->right, name, sizeof name);
    if (simpler && !*name &&
        !(text_to_double(text_rounded(factor, 3).text, &shorter) &&
          fabs(shorter - factor) <= 1e-9 * fabs(factor)))
        return true;
    return try_one(search, &candidate);
}

/* One value that is another, or a round share of a scheme: of schemes that differ in a share alone one is
 * enough. Where times of few digits leave the step open, it may be that of the value. */
static bool try_values(Search *search, const Settings *scheme, bool shares)
{
    const DiagnoseTable *table = search->table;
    const Diagnosis *found = search->found;
    const bool simpler = shares || found->n_explanations > 0, open = table->dt_bound > 1e-12 * table->as.dt;
    const double a_slip = 1e-8; /* less is round-off, which any value fits */
    bool sound = true;
    if (search->walk.departing < DIAGNOSE_ENTRIES_LEAST || search->walk.farthest < a_slip)
        return true;
    search->right = *scheme;
    search->own_is_known = false;
    for (int by_value = 0; by_value <= (open && !simpler); by_value++)
        for (int i = 0; i < n_parameters && sound; i++) {
            const Parameter *parameter = &parameters[i];
            bool tried =
                parameter->type == PARAMETER_REAL && diagnose_is_tried(&search->right, parameter) &&
                (!shares || (diagnose_is_share(parameter) && settings_number(&search->right, parameter) ==
                                                                 settings_number(&search->given, parameter)));
            for (int k = 0; k < found->n_explanations && tried; k++) /* which may have one */
                tried = found->explanations[k].kind == DIAGNOSE_MISTAKE ||
                        strncmp(found->explanations[k].id, parameter->key, strlen(parameter->key)) != 0;
            if (tried)
                sound = try_value(search, parameter, by_value ? settings_time(search->task->settings) : NULL,
                                  simpler);
        }
    search->right = search->given;
    return sound;
}

/* What may be wrong in the code of a scheme. False: it was given up. */
static bool try_listed(Search *search, const Settings *scheme, DiagnoseListed what)
{
    Candidate *candidates = malloc(CANDIDATES_MAX * sizeof *candidates);
    bool sound = candidates || status_fail(search->status, "out of memory");
    const int count = sound ? diagnose_candidates(scheme, what, candidates) : 0;
    search->right = *scheme;
    search->own_is_known = false;
    for (int i = 0; i < count && sound; i++)
        sound = candidates[i].kind == DIAGNOSE_SCHEME || try_one(search, &candidates[i]);
    search->right = search->given;
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
    double beyond = search->walk.departure.is ? INFINITY : search->walk.beyond;
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
    bool sound = true;
    for (int s = first; s < count && sound && schemes[s].choices <= *fewest; s++) {
        const int before = search->found->n_explanations;
        search->right = schemes[s].settings;
        sound = try_one(search, &candidate);
        if (search->found->n_explanations > before)
            *fewest = schemes[s].choices;
    }
    search->right = search->given;
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
    table->noise = right / NEARER;
    table->noise_growth = 0;
    search->grown = NULL;
    search->nearer = true;
    if (!wrong)
        sound = try_right(search, schemes, 0, count, &choices);
    for (int s = 0; s < count && sound && wrong && schemes[s].choices <= choices; s++)
        sound = try_listed(search, &schemes[s].settings, MISTAKES);
    search->nearer = false;
    search->grown = grown;
    table->noise = noise;
    table->noise_growth = growth;
    return sound;
}

/* Right codes of all schemes; where one agrees also the mistakes that the file cannot show, in the first of
 * them and in the scenario's. */
static bool try_schemes(Search *search, const DiagnoseScheme *schemes, int count)
{
    int fewest = INT_MAX;
    bool sound = try_right(search, schemes, 1, count, &fewest);
    const int most = of_few_numbers(search) ? 1 : count;
    for (int s = 0; s < most && sound && search->found->n_explanations == 0; s++)
        sound = try_values(search, &schemes[s].settings, true);
    if (!sound || search->found->n_explanations == 0)
        return sound;
    return try_nearer(search, schemes, count, fewest, true) &&
           try_listed(search, &search->by_first, MISTAKES) && try_listed(search, &search->given, MISTAKES);
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
        Settings other = search->of_first;
        settings_put(&other, stepping, i);
        sound = i == now || try_listed(search, &other, MISTAKES);
    }
    return sound;
}

/* Where no right code agrees: what is wrong in one place, in codes of fewer choices first; then one wrong
 * value of any size, and two mistakes, by each algorithm. */
static bool try_product(Search *search, const DiagnoseScheme *schemes, int count)
{
    enum { CHOICES_OF_PLANE = 3 };
    const bool few = search->walk.departing < DIAGNOSE_ENTRIES_LEAST;
    const bool plane = diagnose_is_of_plane(&search->right);
    const int all = schemes[count - 1].choices,
              most = of_few_numbers(search)                                    ? 0
                     : few && plane                                            ? 1
                     : plane && !search->task->pairs && all > CHOICES_OF_PLANE ? CHOICES_OF_PLANE
                                                                               : all;
    bool sound = true;
    for (int choices = 0; choices <= most && sound && search->found->n_explanations == 0; choices++) {
        for (int s = 0; s < count && sound; s++)
            if (schemes[s].choices == choices)
                sound =
                    try_listed(search, &schemes[s].settings, choices <= 1 ? MISTAKES_AND_VALUES : MISTAKES);
        /* after mistakes in other schemes, to whose numbers a value may fit */
        sound = sound && (choices != (most < 1 ? most : 1) || try_values(search, &search->given, false));
    }
    sound = sound && try_other_steppings(search);
    /* two mistakes, where no one thing explains the file */
    search->found->pairs_left = !few && search->found->n_explanations == 0 && !search->task->pairs && plane;
    for (int s = 0; s < count && sound && !few && search->found->n_explanations == 0; s++)
        if (s == 0 || (schemes[s].choices == 1 && settings_transfer(&schemes[s].settings)->algorithm !=
                                                      settings_transfer(&search->given)->algorithm))
            sound = (s == 0 || try_values(search, &schemes[s].settings, false)) &&
                    (search->found->n_explanations > 0 || search->found->pairs_left ||
                     try_listed(search, &schemes[s].settings, PAIRS_OF_MISTAKES));
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
    const bool sound = agrees ? try_nearer(search, schemes, count, 1, false) &&
                                    try_nearer(search, schemes, count, 1, true) &&
                                    try_listed(search, &search->given, MISTAKES)
                       : wrong ? try_product(search, schemes, count)
                               : try_schemes(search, schemes, count);
    free(schemes);
    return sound;
}

/* --- the whole ------------------------------------------------------------------------------------------ */

/* How far the numbers agree with the right code's, and where they depart. */
static void tell_walk(Search *search)
{
    Diagnosis *found = search->found;
    const DiagnoseTable *table = search->table;
    const Walk *walk = &search->walk;
    found->agreeing[0] = '\0';
    found->compared = diagnose_rows(table, walk->compared);
    found->agreed = diagnose_rows(table, walk->agreed);
    found->agreed_step = walk->agreed > 0 ? table->moments[walk->agreed - 1].step : -1;
    found->digits = digits_of(search, walk->worst);
    found->naive =
        search->right.method == METHOD_PD && walk->worst > 1e-11 && walk->worst < table->noise * 10;
    found->departure = walk->departure;
    diagnose_name_scheme(&search->right, found->scheme, sizeof found->scheme);
    if (walk->departure.is)
        name_departure(search);
}

/* Of right codes that agree that of fewest choices, or one that is orders nearer, comes first. Returns
 * whether it is another than the scenario's. */
static bool take_right(Search *search, double orders)
{
    Diagnosis *found = search->found;
    const bool departs = search->walk.departure.is;
    double beyond = departs ? found->explanations[0].beyond : search->walk.beyond;
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
    Explanation *first = found->explanations;
    if (found->one_is_right) { /* by the scenario's scheme or another: the first of what may be meant */
        if (first->kind != DIAGNOSE_SCHEME) {
            found->n_explanations += found->n_explanations < EXPLANATIONS_MAX;
            memmove(first + 1, first, (size_t)(found->n_explanations - 1) * sizeof *first);
            *first = (Explanation){.kind = DIAGNOSE_SCHEME, .digits = found->digits, .rows = found->agreed};
            memcpy(first->scheme, found->scheme, sizeof first->scheme);
        }
        strcpy(first->id, "right");
        strcpy(first->words, "the right code, but the file is nearer to what follows");
    }
    const double near = found->one_is_right ? right / NEARER : best * orders;
    int kept = found->one_is_right;
    for (int i = kept; i < found->n_explanations; i++)
        if (first[i].kind == DIAGNOSE_MISTAKE && first[i].beyond < near)
            first[kept++] = first[i];
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

/* What is known of a file: what was found, and the table as it was read for that. */
typedef struct Known {
    Diagnosis found;
    DiagnoseTable table;
} Known;

/* Puts it back, with the steps of the table's rows, which are kept outside it. */
static void put_back(Search *search, const Known *known)
{
    *search->found = known->found;
    diagnose_read_as(search->table, &known->table.as);
    *search->table = known->table;
}

/* Each way to read the table, the likeliest first, up to one that a right code explains, then to one that a
 * mistake does; else as the first that a value does, or as the first. Where nothing gives the time step but
 * the numbers, readings with another than the scenario's come after its mistakes: a few digits of a curve fit
 * them both. */
static bool judge_readings(Search *search, const DiagnoseReading *readings, int count)
{
    DiagnoseTable *table = search->table;
    Diagnosis *found = search->found;
    const Known begun = {*found, *table};
    Known first = begun;
    Status why = {STATUS_DONE, ""};
    bool is_first = false;
    for (int i = 0; i < 4 * count && !(is_first && diagnose_time_is_up(search)); i++) {
        const DiagnoseReading *reading = &readings[i % count];
        const long tried = found->tried;
        const bool time_up = found->time_up, wrong = i / count % 2, guessed = i >= 2 * count;
        if (guessed != (!begun.table.timed && reading->dt != begun.table.scenario_dt))
            continue;
        *table = begun.table;
        *found = begun.found;
        found->tried = tried;
        found->time_up = time_up;
        free(search->grown);
        search->grown = NULL;
        search->right = *search->task->settings;
        if (!diagnose_read_as(table, reading) || !diagnose_hold_step(&search->right, table->as.dt, &why))
            continue;
        if (!judge(search, wrong))
            return false;
        const bool known = found->verdict != DIAGNOSE_UNKNOWN,
                   by_value =
                       found->verdict == DIAGNOSE_EXPLAINED && found->explanations[0].kind == DIAGNOSE_VALUE,
                   few_rows = table->n_moments < table->all_moments / 2; /* where round-off grows */
        if (known && !by_value && !few_rows)
            return true;
        /* a value that fits a few rows is less likely than a mistake in another reading */
        if (is_first ? known && first.found.verdict == DIAGNOSE_UNKNOWN : wrong || known) {
            is_first = true;
            first = (Known){*found, *table};
        }
    }
    if (!is_first)
        return status_refuse(search->status, "%s: the scenario cannot be run with its time step %.10g%s%s",
                             table->file.file, readings[0].dt, *why.text ? ": " : "", why.text);
    first.found.tried = found->tried;
    first.found.time_up = found->time_up;
    put_back(search, &first);
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

/* By the likely readings and then, where they lead to nothing, by that with which a wrong code agrees: of
 * what point a column is may show only where the right one departs. By each, numbers of single precision are
 * judged by its round-off; where no code agrees to double precision, by what 8 digits and more have lost, or
 * by single precision where no more digits are written. What is known first counts if all lead to nothing. */
static bool judge_all(Search *search, DiagnoseReading *readings, int count)
{
    enum { LIKELY, LIKELY_AGAIN, DEEP, DEEP_AGAIN, TRIES };
    const double single = 1.2e-7, rounded = 1e-11;
    DiagnoseTable *table = search->table;
    Diagnosis *found = search->found;
    const Known begun = {*found, *table};
    Known first = begun;
    for (int try = LIKELY; try < TRIES; try++) {
        const bool again = try == LIKELY_AGAIN || try == DEEP_AGAIN;
        const int digits = diagnose_digits_written(table);
        const double noise = again && digits > 7 ? rounded : single;
        if (again && (found->single || digits < 5 || noise <= begun.table.noise))
            continue;
        if (try == DEEP) {
            put_back(search, &first);
            if (diagnose_time_is_up(search) || of_few_numbers(search))
                return true;
            *table = begun.table;
            count = diagnose_readings(search, true, readings);
            if (count < 0)
                return status_fail(search->status, cancel_requested(&search->task->cancel, 0)
                                                       ? "interrupted"
                                                       : "out of memory");
            if (count == 0)
                break;
        }
        *found = begun.found;
        *table = begun.table;
        found->single = again ? noise == single : diagnose_is_single(table);
        if (again || found->single)
            table->noise = noise;
        if (found->single)
            table->noise_growth = single_growth(&search->right, table->as.dt);
        if (!judge_readings(search, readings, count))
            return false;
        if (found->verdict != DIAGNOSE_UNKNOWN)
            return true;
        if (try == LIKELY)
            first = (Known){*found, *table};
    }
    put_back(search, &first);
    return true;
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
    search->values = diagnose_room(table);
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

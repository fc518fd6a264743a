/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a diagnosis came to, in words (diagnose.h). */
#include "answers/diagnose.h"

#include "base/text.h"
#include "base/visible.h"

#include <math.h>
#include <string.h>
#include <strings.h>

const char *const diagnose_words[] = {"right", "right but", "mistake", "one of", "unknown"};

const Explanation *diagnosis_acquits(const Diagnosis *found)
{
    for (int i = 0; i < found->n_explanations && found->verdict == DIAGNOSE_EXPLAINED && !found->one_is_right;
         i++) {
        const Explanation *one = &found->explanations[i];
        if (one->kind == DIAGNOSE_SCHEME)
            return one;
    }
    return NULL;
}

/* By how many steps the times of rows are off: a node's velocity is of the step that begins with its row. */
static long shift_of(const DiagnoseTable *table)
{
    return table->shift == -1 && strncmp(table->columns[0].point, "node ", 5) == 0 ? 0 : table->shift;
}

/* How right numbers are written otherwise than the scenario's; "": no such thing. */
static void tell_but(const Diagnosis *found, const DiagnoseTable *table, char *out, size_t size)
{
    bool sign = false, unit = table->spacing > 0 && table->time_factor != 1;
    out[0] = '\0';
    for (int c = 0; c < table->n_columns; c++) {
        sign = sign || table->columns[c].scale == -1;
        unit = unit || table->columns[c].scale == 1e-3 || table->columns[c].scale == 1e3;
    }
    const struct {
        bool is;
        const char *words;
    } all[] = {{shift_of(table) > 0, "labelled a step early"},
               {shift_of(table) < 0, "labelled a step late"},
               {table->half, "labelled with half steps"},
               {unit, "in another unit"},
               {sign, "with the other sign"},
               {found->single, "in single precision"}};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (all[i].is)
            text_append(out, size, "%s%s", *out ? ", " : "", all[i].words);
}

DiagnoseWord diagnosis_word(const Diagnosis *found, const DiagnoseTable *table)
{
    char but[200];
    if (found->verdict == DIAGNOSE_RIGHT || diagnosis_acquits(found)) {
        tell_but(found, table, but, sizeof but);
        return *but ? WORD_RIGHT_BUT : WORD_RIGHT;
    }
    return found->verdict != DIAGNOSE_EXPLAINED                ? WORD_UNKNOWN
           : found->n_explanations > 1 || table->otherwise > 0 ? WORD_ONE_OF
                                                               : WORD_MISTAKE;
}

/* "Right, USL", "Right, USF, but labelled a step early", "Mistake: pic", "One of: a, b". */
static void tell_verdict(const Diagnosis *found, const DiagnoseTable *table, char *out, size_t size)
{
    const Explanation *right = diagnosis_acquits(found);
    const DiagnoseWord word = diagnosis_word(found, table);
    const char *scheme = right ? right->scheme : found->scheme;
    char but[200];
    out[0] = '\0';
    tell_but(found, table, but, sizeof but);
    if (word <= WORD_RIGHT_BUT)
        text_append(out, size, "Right%s%s%s%s", *scheme ? ", " : "", scheme, *but ? ", but " : "", but);
    else if (word == WORD_UNKNOWN)
        text_append(out, size, "Unknown");
    else {
        text_append(out, size, word == WORD_MISTAKE ? "Mistake: " : "One of: ");
        for (int i = 0; i < found->n_explanations && i < DIAGNOSE_NAMED_MAX; i++)
            text_append(out, size, "%s%s", i > 0 ? ", " : "", found->explanations[i].id);
        if (*found->explanations[0].scheme)
            text_append(out, size, " (%s)", found->explanations[0].scheme);
    }
}

static void tell_moment(const Departure *departure, FILE *out)
{
    if (departure->stage > 0)
        visible_print(out, "at step %ld, after stage %d (%s)", departure->step, departure->stage,
                      departure->stage_id);
    else
        visible_print(out, departure->step == 0 ? "at the start (step %ld)" : "at step %ld", departure->step);
}

static void tell_departure(const Diagnosis *found, const DiagnoseTable *table, FILE *out)
{
    const Departure *departure = &found->departure;
    const DiagnoseColumn *column = &table->columns[departure->column];
    fputs("They first depart ", out);
    tell_moment(departure, out);
    if (table->set >= 0)
        visible_print(out, ", %s %zu", table->thing, departure->thing);
    visible_print(out, ", row %zu, column %s:\n", departure->row, column->name);
    if (isinf(departure->theirs))
        visible_print(out, "  yours is not a number from here on (nan or inf), right %.16g\n",
                      departure->ours);
    else
        visible_print(
            out, "  yours %.16g, right %.16g: ratio %s, difference %s\n", departure->theirs, departure->ours,
            departure->ours != 0 ? text_rounded(departure->theirs / departure->ours, 8).text : "none",
            text_rounded(departure->theirs - departure->ours, 3).text);
    if (*departure->factors)
        visible_print(out, "  the ratio is %s\n", departure->factors);
    if (*departure->change_factors)
        visible_print(out, "  it has changed since the row before by the right amount times %s\n",
                      departure->change_factors);
    if (table->of_next)
        visible_print(out, "  Rows of a grid are of the step that follows: this one of step %ld.\n",
                      departure->step + 1);
    else if (*found->agreeing)
        visible_print(out, "  %s: as they should be in all rows. Look at how %s is made of the same run.\n",
                      found->agreeing, column->name);
    else if (departure->step == 0)
        fputs("  No step is done yet: what is wrong is the start.\n", out);
    else if (departure->moment == 0)
        fputs("  There is no row before it, so the start and the loop cannot be distinguished.\n", out);
}

static void tell_agreement(const Diagnosis *found, const DiagnoseTable *table, FILE *out)
{
    const Explanation *right = diagnosis_acquits(found);
    const size_t agreed = right ? right->rows : found->agreed;
    const char *rows = agreed == 1 ? "row" : "rows";
    if (found->verdict == DIAGNOSE_RIGHT || right)
        visible_print(out, "Your numbers are those of the right code, to %d digits over %zu %s.\n",
                      right ? right->digits : found->digits, agreed, rows);
    else if (found->agreed == 0)
        fputs("Your numbers agree with the right code's in no row.\n", out);
    else
        visible_print(
            out, "Your numbers agree with the right code's to %d digits over %s%zu %s (to step %ld).\n",
            found->digits, table->of_stages ? "" : "the first ", found->agreed, rows, found->agreed_step);
    if (found->verdict == DIAGNOSE_RIGHT && found->naive)
        fputs("No more digits are possible where a bond's |y| - |xi| is taken without rearranging: that is "
              "round-off, not a mistake.\n",
              out);
}

static void tell_explanation(const Explanation *explanation, FILE *out)
{
    const size_t length = strlen(explanation->words);
    const bool ends = length > 0 && explanation->words[length - 1] == '.';
    visible_print(out, "  %s: %s%s\n", explanation->id, explanation->words, ends ? "" : ".");
    if (*explanation->where)
        visible_print(out, "  %s\n", explanation->where);
}

static void tell_explanations(const Diagnosis *found, const DiagnoseTable *table, const char *scenario,
                              const char *file, FILE *out)
{
    if (table->otherwise > 0)
        visible_print(
            out,
            "Or they are a right code's with dt %.10g, of which not every step is written: more digits "
            "tell (--template).\n",
            table->otherwise);
    const Explanation *first = &found->explanations[0];
    visible_print(out, "They are those of this code, to %d digits over %zu rows:\n", first->digits,
                  first->rows);
    tell_explanation(first, out);
    if (first->grown)
        fputs("  (no farther: such a run blows up, or lets round-off grow to the size of its numbers)\n",
              out);
    for (int i = 1; i < found->n_explanations && i < DIAGNOSE_NAMED_MAX; i++) {
        const Explanation *rival = &found->explanations[i];
        visible_print(out, i == 1 ? "This file cannot tell it from:\n" : "or\n");
        tell_explanation(rival, out);
        if (*rival->apart) {
            visible_print(out, "  (%s: %s, then\n", rival->apart,
                          *rival->set ? "let your code run so" : "let your code write it");
            visible_print(out, "  matvib diagnose %s%s%s %s)\n", scenario, *rival->set ? " --set " : "",
                          rival->set, file);
        } else
            visible_print(out, "  (none of %d runs of both distinguishes them)\n", rival->compared);
    }
    const int more = found->more + found->n_explanations - DIAGNOSE_NAMED_MAX;
    if (more > 0)
        visible_print(out, "and %d more: the file has too few rows or digits.\n", more);
}

static void tell_hidden(const Diagnosis *found, FILE *out)
{
    const Explanation *right = diagnosis_acquits(found);
    int told = 0, more = found->more;
    for (int i = 0; i < found->n_explanations; i++) {
        const Explanation *hidden = &found->explanations[i];
        if (hidden == right)
            continue;
        if (told == DIAGNOSE_NAMED_MAX) {
            more++;
            continue;
        }
        if (told++ == 0)
            fputs("Not shown by this file, with or without them its numbers are the same:\n", out);
        visible_print(out, "  %s%s%s%s\n", hidden->id, *hidden->apart ? " (" : "", hidden->apart,
                      *hidden->apart ? ")" : "");
    }
    if (more > 0)
        visible_print(out, "  and %d more\n", more);
}

static void tell_nothing_found(const Diagnosis *found, const DiagnoseTable *table, const char *scenario,
                               FILE *out)
{
    const Departure *departure = &found->departure;
    visible_print(
        out,
        "None of %ld other codes gives these numbers: no one mistake, scheme or value that is known here.\n",
        found->tried);
    if (found->pairs_left && !found->time_up)
        fputs("Two mistakes at once, or one beside four other choices, were not tried (--pairs).\n", out);
    if (found->farthest < 1e-6)
        visible_print(out, "No number is farther off than %s of the largest of its kind.\n",
                      text_rounded(found->farthest, 1).text);
    if (*found->agreeing)
        return;
    if (departure->step == 0 && !table->of_next)
        fputs("Look at how the start is made: places, masses, velocities of t = 0.\n", out);
    else if (!table->of_stages) {
        const long step = departure->step + table->of_next;
        visible_print(
            out, "Look into step %ld: compare your numbers after each of its stages with those of\n", step);
        visible_print(out, "  matvib run %s --stages %ld:%ld --particles p.csv\n", scenario, step, step);
    } else
        visible_print(out, "Look at what stage %d (%s) does with what the stages before it gave.\n",
                      departure->stage, departure->stage_id);
}

/* A unit or a sign: what a number of the file is in ours. */
static const char *scale_words(const DiagnoseColumn *column)
{
    return column->scale == 1      ? ""
           : column->scale == -1   ? ", with the other sign"
           : column->scale == 1e-3 ? ", in thousandths"
           : column->scale == 1e3  ? ", in thousands"
                                   : ", times the mass of the bar";
}

void diagnosis_read_as(const DiagnoseTable *table, char *out, size_t size)
{
    char names[120] = "";
    out[0] = '\0';
    for (int c = 0; c < table->n_columns; c++) {
        const DiagnoseColumn *column = &table->columns[c];
        const char *theirs = table->file.columns[column->theirs].name;
        char of[160];
        if (strcasecmp(theirs, column->name) == 0 && column->scale == 1) {
            text_list_add(names, sizeof names, column->name);
            continue;
        }
        snprintf(of, sizeof of, "%s", *column->point ? column->point : column->name);
        if (*column->point) { /* "particle 49 v" */
            const char *field = strrchr(column->point, ' ');
            snprintf(of, sizeof of, "%s of %.*s", field + 1, (int)(field - column->point), column->point);
        }
        text_append(out, size, "%s: %s%s; ", *theirs ? theirs : "a column without a name", of,
                    scale_words(column));
    }
    if (*names)
        text_append(out, size, "%s; ", names);
    if (shift_of(table) == 1)
        text_append(out, size, "rows carry the time before their step; ");
    else if (shift_of(table) == -1)
        text_append(out, size, "rows carry the time after their step; ");
    if (table->half)
        text_append(out, size, "times of half steps; ");
    if (table->spacing > 0 && table->time_factor == 1e-3)
        text_append(out, size, "times in ms; ");
    else if (table->spacing > 0 && table->time_factor == 1e-6)
        text_append(out, size, "times in \xc2\xb5s; ");
    const long every = table->n_moments > 1 ? table->moments[1].step - table->moments[0].step : 1;
    text_append(out, size, "dt %.10g", table->dt);
    if (fabs(table->dt - table->scenario_dt) > table->dt_bound + 1e-12 * table->dt)
        text_append(out, size, " (the scenario's is %.10g)", table->scenario_dt);
    if (every > 1 && !table->of_stages)
        text_append(out, size, ", a row every %ld steps", every);
}

void diagnosis_tell(const Diagnosis *found, const DiagnoseTable *table, const char *scenario,
                    const char *file, FILE *out)
{
    char read_as[400], verdict[400];
    diagnosis_read_as(table, read_as, sizeof read_as);
    tell_verdict(found, table, verdict, sizeof verdict);
    visible_print(out, "Read as: %s\n", read_as);
    visible_print(out, "%s.\n", verdict);
    for (int i = 0; i < table->n_notes; i++)
        visible_print(out, "(%s)\n", table->notes[i]);
    if (found->verdict == DIAGNOSE_COPIED) {
        fputs("This is the exact answer, not a run: there is no code to be judged.\n", out);
        return;
    }
    if (found->verdict == DIAGNOSE_MUTE) {
        fputs("This file shows nothing: its columns are empty, or are only round-off even in the right "
              "run.\nWrite an energy, or the velocity of one particle (--template).\n",
              out);
        return;
    }
    if (found->time_up)
        fputs("Not everything was tried in the time (--time).\n", out);
    const bool right = diagnosis_word(found, table) <= WORD_RIGHT_BUT;
    if (!found->one_is_right)
        tell_agreement(found, table, out);
    if (found->departure.is && !right && !found->one_is_right)
        tell_departure(found, table, out);
    if (right)
        tell_hidden(found, out);
    else if (found->verdict == DIAGNOSE_EXPLAINED)
        tell_explanations(found, table, scenario, file, out);
    else
        tell_nothing_found(found, table, scenario, out);
    if (found->compared == 1 && found->verdict == DIAGNOSE_RIGHT)
        fputs("One row is not enough: it shows one moment only.\n", out);
    else if (found->compared < found->rows)
        visible_print(out, "Of its last rows %zu were not compared.\n", found->rows - found->compared);
}

void diagnosis_sum_up(const Diagnosis *found, const DiagnoseTable *table, char *out, size_t size)
{
    const Departure *departure = &found->departure;
    const Explanation *first = &found->explanations[0];
    char read_as[400], verdict[400];
    out[0] = '\0';
    diagnosis_read_as(table, read_as, sizeof read_as);
    text_append(out, size, "%s, read as %s. ", table->file.file, read_as);
    if (found->verdict == DIAGNOSE_COPIED || found->verdict == DIAGNOSE_MUTE) {
        text_append(out, size,
                    found->verdict == DIAGNOSE_COPIED ? "Unknown: the exact answer, not a run."
                                                      : "Unknown: its columns show nothing.");
        return;
    }
    const Explanation *right = diagnosis_acquits(found);
    tell_verdict(found, table, verdict, sizeof verdict);
    text_append(out, size, "%s", verdict);
    if (diagnosis_word(found, table) <= WORD_RIGHT_BUT) {
        text_append(out, size, ", to %d digits over %zu rows.", right ? right->digits : found->digits,
                    right ? right->rows : found->agreed);
        for (int i = 0, told = 0; i < found->n_explanations && told < DIAGNOSE_NAMED_MAX; i++)
            if (&found->explanations[i] != right)
                text_append(out, size, "%s%s", told++ == 0 ? " It cannot show " : ", ",
                            found->explanations[i].id);
        return;
    }
    text_append(out, size, ". ");
    if (departure->is)
        text_append(out, size, "It departs at step %ld%s%s in %s: yours %s, right %s", departure->step,
                    departure->stage > 0 ? ", stage " : "", departure->stage > 0 ? departure->stage_id : "",
                    table->columns[departure->column].name,
                    isinf(departure->theirs) ? "no number" : text_rounded(departure->theirs, 9).text,
                    text_rounded(departure->ours, 9).text);
    if (*departure->factors)
        text_append(out, size, " (times %s)", departure->factors);
    text_append(out, size, departure->is ? ". " : "");
    if (found->verdict == DIAGNOSE_UNKNOWN) {
        text_append(out, size, "None of %ld other codes gives these numbers%s.", found->tried,
                    found->pairs_left ? "; :diagnose FILE pairs tries two mistakes at once" : "");
        return;
    }
    text_append(out, size, "To %d digits over %zu rows: %s", first->digits, found->compared, first->words);
}

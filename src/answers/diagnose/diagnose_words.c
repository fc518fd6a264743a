/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a diagnosis came to, in words (diagnose.h). */
#include "answers/diagnose/diagnose_internal.h"

#include "base/text.h"
#include "base/visible.h"

#include <math.h>
#include <string.h>
#include <strings.h>

const char *const diagnose_words[] = {"right", "right but", "mistake", "one of", "unknown"};

/* By how many steps the times of rows are off: a node's velocity is of the step that begins with its row. */
static long shift_of(const DiagnoseTable *table)
{
    return table->as.shift == -1 && strncmp(table->as.columns[0].point, "node ", 5) == 0 ? 0
                                                                                         : table->as.shift;
}

void diagnose_conclude(Diagnosis *found, const DiagnoseTable *table)
{
    bool sign = false, unit = table->spacing > 0 && table->as.time_factor != 1;
    for (int c = 0; c < table->as.n_columns; c++) {
        sign = sign || table->as.columns[c].scale == -1;
        unit = unit || table->as.columns[c].scale == 1e-3 || table->as.columns[c].scale == 1e3;
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
            text_list_add(found->but, sizeof found->but, all[i].words);
    const bool explained = found->verdict == DIAGNOSE_EXPLAINED;
    Explanation *one = found->explanations;
    if (explained) /* of the code that makes these numbers */
        memcpy(found->scheme, one->scheme, sizeof found->scheme);
    for (int i = 0; i < found->n_explanations && explained && !found->one_is_right; i++)
        if (one[i].kind == DIAGNOSE_SCHEME) { /* a right code by another scheme */
            memcpy(found->scheme, one[i].scheme, sizeof found->scheme);
            found->digits = one[i].digits;
            found->agreed = one[i].rows;
            found->verdict = DIAGNOSE_RIGHT;
            memmove(&one[i], &one[i + 1], (size_t)(--found->n_explanations - i) * sizeof *one);
            break;
        }
    found->word = found->verdict == DIAGNOSE_RIGHT       ? (*found->but ? WORD_RIGHT_BUT : WORD_RIGHT)
                  : found->verdict != DIAGNOSE_EXPLAINED ? WORD_UNKNOWN
                  : found->n_explanations > 1 || table->as.otherwise > 0 ? WORD_ONE_OF
                                                                         : WORD_MISTAKE;
}

/* "Right, USL", "Right, USF, but labelled a step early", "Mistake: pic", "One of: a, b". */
static void tell_verdict(const Diagnosis *found, char *out, size_t size)
{
    out[0] = '\0';
    if (found->word == WORD_UNKNOWN) {
        text_append(out, size, "Unknown");
        return;
    }
    if (found->word <= WORD_RIGHT_BUT) {
        text_append(out, size, "Right%s%s%s%s", *found->scheme ? ", " : "", found->scheme,
                    *found->but ? ", but " : "", found->but);
        return;
    }
    text_append(out, size, found->word == WORD_MISTAKE ? "Mistake: " : "One of: ");
    for (int i = 0; i < found->n_explanations && i < DIAGNOSE_NAMED_MAX; i++)
        text_append(out, size, "%s%s", i > 0 ? ", " : "", found->explanations[i].id);
    if (*found->scheme)
        text_append(out, size, " (%s)", found->scheme);
}

static void tell_departure(const Diagnosis *found, const DiagnoseTable *table, FILE *out)
{
    const Departure *departure = &found->departure;
    const double theirs = departure->theirs, ours = departure->ours;
    const char *column = table->as.columns[departure->column].name;
    const bool at_start = departure->stage == 0 && departure->step == 0;
    visible_print(out, "They first depart at %s %ld%s", at_start ? "the start (step" : "step",
                  departure->step, at_start ? ")" : "");
    if (departure->stage > 0)
        visible_print(out, ", after stage %d (%s)", departure->stage, departure->stage_id);
    if (table->set >= 0)
        visible_print(out, ", %s %zu", table->thing, departure->thing);
    visible_print(out, ", row %zu, column %s:\n", departure->row, column);
    if (isinf(theirs))
        visible_print(out, "  yours is not a number from here on (nan or inf), right %.16g\n", ours);
    else
        visible_print(out, "  yours %.16g, right %.16g: ratio %s, difference %s\n", theirs, ours,
                      ours != 0 ? text_rounded(theirs / ours, 8).text : "none",
                      text_rounded(theirs - ours, 3).text);
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
                      found->agreeing, column);
    else if (departure->step == 0)
        fputs("  No step is done yet: what is wrong is the start.\n", out);
    else if (departure->moment == 0)
        fputs("  There is no row before it, so the start and the loop cannot be distinguished.\n", out);
}

static void tell_agreement(const Diagnosis *found, const DiagnoseTable *table, FILE *out)
{
    const char *rows = found->agreed == 1 ? "row" : "rows";
    if (found->verdict == DIAGNOSE_RIGHT)
        visible_print(out, "Your numbers are those of the right code, to %d digits over %zu %s.\n",
                      found->digits, found->agreed, rows);
    else if (found->agreed == 0)
        fputs("Your numbers agree with the right code's in no row.\n", out);
    else
        visible_print(
            out, "Your numbers agree with the right code's to %d digits over %s%zu %s (to step %ld).\n",
            found->digits, table->of_stages ? "" : "the first ", found->agreed, rows, found->agreed_step);
    if (found->verdict == DIAGNOSE_RIGHT && found->naive && !found->departure.is)
        fputs("No more digits are possible where a bond's |y| - |xi| is taken without rearranging: that is "
              "round-off, not a mistake.\n",
              out);
}

static void tell_explanations(const Diagnosis *found, const DiagnoseTable *table, const char *scenario,
                              const char *file, FILE *out)
{
    if (table->as.otherwise > 0)
        visible_print(
            out,
            "Or they are a right code's with dt %.10g, of which not every step is written: more digits "
            "tell (--template).\n",
            table->as.otherwise);
    for (int i = 0; i < found->n_explanations && i < DIAGNOSE_NAMED_MAX; i++) {
        const Explanation *one = &found->explanations[i];
        const size_t length = strlen(one->words);
        if (i == 0)
            visible_print(out, "They are those of this code, to %d digits over %zu rows:\n", one->digits,
                          one->rows);
        else
            fputs(i == 1 ? "This file cannot tell it from:\n" : "or\n", out);
        visible_print(out, "  %s: %s%s\n", one->id, one->words,
                      length > 0 && one->words[length - 1] == '.' ? "" : ".");
        if (*one->where)
            visible_print(out, "  %s\n", one->where);
        if (i == 0 && one->grown)
            fputs("  (no farther: such a run blows up, or lets round-off grow to the size of its numbers)\n",
                  out);
        else if (i > 0 && *one->apart) {
            visible_print(out, "  (%s: %s, then\n", one->apart,
                          *one->set ? "let your code run so" : "let your code write it");
            visible_print(out, "  matvib diagnose %s%s%s %s)\n", scenario, *one->set ? " --set " : "",
                          one->set, file);
        } else if (i > 0)
            visible_print(out, "  (none of %d runs of both distinguishes them)\n", one->compared);
    }
    const int more = found->more + found->n_explanations - DIAGNOSE_NAMED_MAX;
    if (more > 0)
        visible_print(out, "and %d more: the file has too few rows or digits.\n", more);
}

static void tell_hidden(const Diagnosis *found, FILE *out)
{
    const int more = found->more + (int)fmax(0, found->n_explanations - DIAGNOSE_NAMED_MAX);
    if (found->n_explanations > 0)
        fputs("Not shown by this file, with or without them its numbers are the same:\n", out);
    for (int i = 0; i < found->n_explanations && i < DIAGNOSE_NAMED_MAX; i++) {
        const Explanation *hidden = &found->explanations[i];
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
    const long step = departure->step + table->of_next;
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
    if (step == 0)
        fputs("Look at how the start is made: places, masses, velocities of t = 0.\n", out);
    else if (!table->of_stages) {
        visible_print(
            out, "Look into step %ld: compare your numbers after each of its stages with those of\n", step);
        visible_print(out, "  matvib run %s --stages %ld:%ld --particles p.csv\n", scenario, step, step);
    } else
        visible_print(out, "Look at what stage %d (%s) does with what the stages before it gave.\n",
                      departure->stage, departure->stage_id);
}

void diagnosis_read_as(const DiagnoseTable *table, char *out, size_t size)
{
    static const struct {
        double scale;
        const char *words;
    } scales[] = {
        {1, ""}, {-1, ", with the other sign"}, {1e-3, ", in thousandths"}, {1e3, ", in thousands"}};
    char names[120] = "";
    out[0] = '\0';
    for (int c = 0; c < table->as.n_columns; c++) {
        const DiagnoseColumn *column = &table->as.columns[c];
        const char *theirs = table->file.columns[column->theirs].name, *field = strrchr(column->point, ' ');
        const char *scale = ", times the mass of the bar";
        if (strcasecmp(theirs, column->name) == 0 && column->scale == 1) {
            text_list_add(names, sizeof names, column->name);
            continue;
        }
        for (size_t i = 0; i < sizeof scales / sizeof *scales; i++)
            scale = column->scale == scales[i].scale ? scales[i].words : scale;
        text_append(out, size, "%s: ", *theirs ? theirs : "a column without a name");
        if (field) /* "particle 49 v" */
            text_append(out, size, "%s of %.*s", field + 1, (int)(field - column->point), column->point);
        else
            text_append(out, size, "%s", column->name);
        text_append(out, size, "%s; ", scale);
    }
    if (*names)
        text_append(out, size, "%s; ", names);
    if (shift_of(table) != 0)
        text_append(out, size, "rows carry the time %s their step; ",
                    shift_of(table) > 0 ? "before" : "after");
    if (table->half)
        text_append(out, size, "times of half steps; ");
    if (table->spacing > 0 && (table->as.time_factor == 1e-3 || table->as.time_factor == 1e-6))
        text_append(out, size, "times in %s; ", table->as.time_factor == 1e-3 ? "ms" : "\xc2\xb5s");
    const long every = table->n_moments > 1 ? table->moments[1].step - table->moments[0].step : 1;
    text_append(out, size, "dt %.10g", table->as.dt);
    if (fabs(table->as.dt - table->scenario_dt) > table->dt_bound + 1e-12 * table->as.dt)
        text_append(out, size, " (the scenario's is %.10g)", table->scenario_dt);
    if (every > 1 && !table->of_stages)
        text_append(out, size, ", a row every %ld steps", every);
}

void diagnosis_tell(const Diagnosis *found, const DiagnoseTable *table, const char *scenario,
                    const char *file, FILE *out)
{
    char read_as[400], verdict[400];
    diagnosis_read_as(table, read_as, sizeof read_as);
    tell_verdict(found, verdict, sizeof verdict);
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
    if (!found->one_is_right)
        tell_agreement(found, table, out);
    if (found->departure.is && found->verdict != DIAGNOSE_RIGHT && !found->one_is_right)
        tell_departure(found, table, out);
    if (found->verdict == DIAGNOSE_RIGHT)
        tell_hidden(found, out);
    else if (found->verdict == DIAGNOSE_EXPLAINED)
        tell_explanations(found, table, scenario, file, out);
    else
        tell_nothing_found(found, table, scenario, out);
    if (found->compared == 1 && found->verdict == DIAGNOSE_RIGHT && !found->departure.is)
        fputs("One row is not enough: it shows one moment only.\n", out);
    else if (found->compared < found->rows)
        visible_print(out, "Of its last rows %zu were not compared.\n", found->rows - found->compared);
}

void diagnosis_sum_up(const Diagnosis *found, const DiagnoseTable *table, char *out, size_t size)
{
    const Departure *departure = &found->departure;
    char read_as[400], verdict[400];
    out[0] = '\0';
    diagnosis_read_as(table, read_as, sizeof read_as);
    tell_verdict(found, verdict, sizeof verdict);
    text_append(out, size, "%s, read as %s. %s", table->file.file, read_as, verdict);
    if (found->verdict == DIAGNOSE_COPIED || found->verdict == DIAGNOSE_MUTE) {
        text_append(out, size,
                    found->verdict == DIAGNOSE_COPIED ? ": the exact answer, not a run."
                                                      : ": its columns show nothing.");
        return;
    }
    if (found->verdict == DIAGNOSE_RIGHT) {
        text_append(out, size, ", to %d digits over %zu rows.", found->digits, found->agreed);
        for (int i = 0; i < found->n_explanations && i < DIAGNOSE_NAMED_MAX; i++)
            text_append(out, size, "%s%s", i == 0 ? " It cannot show " : ", ", found->explanations[i].id);
        return;
    }
    text_append(out, size, ". ");
    if (departure->is)
        text_append(out, size, "It departs at step %ld%s%s in %s: yours %s, right %s", departure->step,
                    departure->stage > 0 ? ", stage " : "", departure->stage > 0 ? departure->stage_id : "",
                    table->as.columns[departure->column].name,
                    isinf(departure->theirs) ? "no number" : text_rounded(departure->theirs, 9).text,
                    text_rounded(departure->ours, 9).text);
    if (*departure->factors)
        text_append(out, size, " (times %s)", departure->factors);
    text_append(out, size, departure->is ? ". " : "");
    if (found->verdict == DIAGNOSE_UNKNOWN)
        text_append(out, size, "None of %ld other codes gives these numbers%s.", found->tried,
                    found->pairs_left ? "; :diagnose FILE pairs tries two mistakes at once" : "");
    else
        text_append(out, size, "To %d digits over %zu rows: %s", found->explanations[0].digits,
                    found->compared, found->explanations[0].words);
}

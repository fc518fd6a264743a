/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command line of verify: which checks there are, and which of them run. */
#include "cli/verify/verify.h"
#include "base/text.h"
#include "base/threads.h"
#include "cli/options.h"
#include "base/cancel.h"
#include "base/math/functions.h"

#include <string.h>

const char *verify_name(int index)
{
    return verify_checks[index].name;
}

/* --- the command line ---------------------------------------------------------------------------- */

static int rows_to_run(const VerifyCheck *check, bool full)
{
    int count = 0;
    for (int i = 0; i < check->n_rows; i++)
        count += full || !check->rows[i].full;
    return count;
}

static bool is_named(const Options *options, const VerifyCheck *check)
{
    for (int i = 0; i < options->n_words; i++)
        if (strcmp(options->words[i], check->name) == 0)
            return true;
    return false;
}

/* Whether a check is to be run, and whether with the rows of --full. */
static bool is_wanted(const Options *options, const VerifyCheck *check)
{
    return options->n_words ? is_named(options, check) : options->full || rows_to_run(check, false) > 0;
}

static bool is_whole(const Options *options, const VerifyCheck *check)
{
    return options->full || (is_named(options, check) && rows_to_run(check, false) == 0);
}

/* --- running ------------------------------------------------------------------------------------- */

int verify_main(int count, char **arguments, FILE *out, Status *status)
{
    Options options;
    if (!options_parse("verify", count, arguments, &options, status))
        return STATUS_USAGE;
    for (int i = 0; i < options.n_words; i++) {
        const char *name = options.words[i];
        const VerifyCheck *nearest = verify_checks;
        for (const VerifyCheck *check = verify_checks; check->name; check++)
            if (text_distance(name, check->name) < text_distance(name, nearest->name))
                nearest = check;
        if (strcmp(nearest->name, name) != 0) {
            status_refuse(status, "verify: unknown name \"%s\" (the nearest is %s; --list shows all)", name,
                          nearest->name);
            return STATUS_USAGE;
        }
    }
    if (options.list) {
        for (const VerifyCheck *check = verify_checks; check->name; check++)
            fprintf(out, "%-12s %s%s\n", check->name, check->title,
                    rows_to_run(check, false) ? "" : " (--full)");
        return STATUS_DONE;
    }
    Progress progress;
    progress_begin(&progress, false);
    Quantities json = {.out = out};
    if (options.json) {
        json = quantities_open(out, "verify");
        quantities_begin(&json, "quantities");
    }
    Verify verify = {.json = options.json ? &json : NULL,
                     .out = out,
                     .threads = threads_default(false),
                     .progress = &progress};
    for (const VerifyCheck *check = verify_checks; check->name; check++)
        verify.to_do += is_wanted(&options, check) ? rows_to_run(check, is_whole(&options, check)) : 0;
    /* none for a pipe that is closed */
    for (const VerifyCheck *check = verify_checks; check->name && !ferror(out) && !progress_signal(); check++)
        if (is_wanted(&options, check))
            verify_check_run(&verify, check, is_whole(&options, check));
    if (!options.full && !options.json && !progress_signal()) {
        /* What a run without --full did not do, so that it is not taken for the whole. */
        bool first = true;
        for (const VerifyCheck *check = verify_checks; check->name; check++) {
            int left_out = check->n_rows - rows_to_run(check, false);
            /* a check that was asked for by name runs although it belongs to --full */
            if (left_out == 0 ||
                (options.n_words && (!is_named(&options, check) || left_out == check->n_rows)))
                continue;
            if (first)
                fputs("Left out without --full:\n", out);
            first = false;
            fprintf(out, "  %-12s %d of %d rows\n", check->name, left_out, check->n_rows);
        }
    }
    return verify_end(&verify, status);
}

/* The runner of verify: makes the runs that rows name, one run for consecutive rows of the same scenario, and
 * prints each number, and under it its verdicts: against our reference, its bounds, the paper.
 */

/* --- a row --------------------------------------------------------------------------------------- */

/* "2..3", ">= 2", "<= 3", or "2" alone; where that is long, the middle and how far it may be off. */
static void print_band(char out[64], Band band, int decimals)
{
    enum { LONG = 18 };
    const int of_number = decimals;
    int length = 0;
    /* more digits than the number has, where both ends would look the same */
    while (band.high > band.low && band.high - band.low < 1.9 * math_pow(10, -decimals) && decimals < 12)
        decimals++;
    if (band.low == band.high)
        snprintf(out, 64, "%.*f", decimals, band.low);
    else if (isinf(band.low) || isinf(band.high))
        snprintf(out, 64, isinf(band.low) ? "<= %.*f" : ">= %.*f", decimals,
                 isinf(band.low) ? band.high : band.low);
    else
        length = snprintf(out, 64, "%.*f..%.*f", decimals, band.low, decimals, band.high);
    if (length > LONG)
        snprintf(out, 64, "%.*f +- %.0e", of_number, (band.low + band.high) / 2, (band.high - band.low) / 2);
}

static const char *const column_words[VERIFY_COLUMNS] = {[VERIFY_THEORY] = "theory",
                                                         [VERIFY_EIGENVALUE] = "eigenvalue",
                                                         [VERIFY_PREDICTED] = "predicted",
                                                         [VERIFY_MEASURED] = "measured"};

/* A label, and under each column its number; nothing behind the last. */
static void print_columns(FILE *out, const char *label, const char *const numbers[VERIFY_COLUMNS])
{
    int last = VERIFY_COLUMNS - 1;
    while (last > 0 && !*numbers[last])
        last--;
    fprintf(out, "  %-30s", label);
    for (int i = 0; i <= last; i++)
        fprintf(out, " %10s", numbers[i]);
    fputc('\n', out);
}

static void print_row(FILE *out, const VerifyRow *row, const VerifyNumbers *numbers)
{
    char texts[VERIFY_COLUMNS][32];
    const char *words[VERIFY_COLUMNS];
    for (int i = 0; i < VERIFY_COLUMNS; i++) {
        texts[i][0] = '\0';
        if (!isnan(numbers->values[i]))
            snprintf(texts[i], 32, "%.*f", row->decimals, numbers->values[i]);
        words[i] = texts[i];
    }
    if (isnan(numbers->values[numbers->own]))
        words[numbers->own] = "none";
    print_columns(out, row->what, words);
}

/* What may be asked of a row's own number, in this order. */
enum { REPRODUCES, BOUNDED, NEAR, VERDICTS };

static const char *const paper_words[AGREEMENTS] = {
    [PAPER_AGREES] = "agrees", [PAPER_NEAR] = "near", [PAPER_DIFFERS] = "differs"};

static void print_verdicts(FILE *out, const VerifyRow *row, const VerifyNumbers *numbers,
                           const Verdict verdicts[VERDICTS])
{
    static const char *const names[] = {"our reference", "bound"};
    static const char *const good[] = {"reproduces", "holds"};
    const Band bands[] = {row->reference, row->bound};
    static const char *const beside[VERIFY_COLUMNS] = {[VERIFY_THEORY] = "theory",
                                                       [VERIFY_EIGENVALUE] = "the eigenvalue",
                                                       [VERIFY_PREDICTED] = "the prediction"};

    for (int i = REPRODUCES; i < NEAR; i++)
        if (verdicts[i] != VERDICT_NONE) {
            char band[64];
            print_band(band, bands[i], row->decimals);
            fprintf(out, "    %s: %s: %s\n", names[i], band,
                    verdicts[i] == VERDICT_GOOD ? good[i] : "MISSED");
        }
    if (verdicts[NEAR] != VERDICT_NONE)
        fprintf(out, "    off %s by %.1e (at most %.1e): %s\n", beside[numbers->beside],
                fabs(numbers->values[numbers->own] - numbers->values[numbers->beside]), row->tolerance,
                verdicts[NEAR] == VERDICT_GOOD ? "holds" : "MISSED");
}

static void print_agreement(FILE *out, const Claim *claim, double number, Agreement agreement)
{
    if (agreement == PAPER_SILENT)
        return;
    fprintf(out, "    the paper: \"%s\"", claim->words);
    if (isnan(claim->number))
        fprintf(out, " (taken as %g..%g)", claim->range.low, claim->range.high);
    fprintf(out, ": %s", paper_words[agreement]);
    if (!isnan(claim->number) && !isnan(number))
        fprintf(out, fabs(number / claim->number - 1) < 0.1 ? ", %+.1f %%" : ", %+.0f %%",
                100 * (number / claim->number - 1));
    if (claim->remark)
        fprintf(out, "\n      (%s)", claim->remark);
    fputc('\n', out);
}

/* Behind the last comma of a row's words or, in brackets, in its check's title: "period, ms"; NULL: the words
 * say it all. */
static const char *unit_of(const VerifyCheck *check, const VerifyRow *row, char out[16])
{
    const char *comma = strrchr(row->what, ','), *bracket = strrchr(check->title, '(');
    const char *unit = comma && comma[1] == ' ' ? comma + 2 : NULL;
    if (unit && *unit && !strchr("0123456789.", *unit) && !strpbrk(unit, " <>="))
        return snprintf(out, 16, "%s", unit) < 16 ? out : NULL;
    const size_t length = bracket ? strcspn(bracket + 1, ") ") : 0;
    if (length == 0 || length >= 16 || bracket[1 + length] != ')')
        return NULL;
    snprintf(out, 16, "%.*s", (int)length, bracket + 1);
    return out;
}

/* What print_row(), print_verdicts() and print_agreement() say. */
static void put_row(Verify *verify, const VerifyCheck *check, const VerifyRow *row,
                    const VerifyNumbers *numbers, const Verdict verdicts[VERDICTS], Agreement paper,
                    Agreement also)
{
    static const char *const kinds[VERDICTS] = {"reference", "bound", "near"};
    char unit[16];
    quantities_add(verify->json, row->what + strspn(row->what, " "), numbers->values[numbers->own],
                   unit_of(check, row, unit));
    quantities_text(verify->json, "check", check->name);
    for (int i = 0; i < VERIFY_COLUMNS; i++)
        if (!isnan(numbers->values[i]))
            quantities_number(verify->json, column_words[i], numbers->values[i]);
    for (int i = 0; i < VERDICTS; i++)
        if (verdicts[i] != VERDICT_NONE)
            quantities_text(verify->json, kinds[i], verdicts[i] == VERDICT_GOOD ? "holds" : "missed");
    if (paper != PAPER_SILENT)
        quantities_text(verify->json, "paper", paper_words[paper]);
    if (also != PAPER_SILENT)
        quantities_text(verify->json, "paper_also", paper_words[also]);
    if (verify->run.failure.code != STATUS_DONE)
        quantities_text(verify->json, "failure", verify->run.failure.text);
}

/* --- running ------------------------------------------------------------------------------------- */

static bool show_progress(double share, void *context)
{
    const Verify *verify = context;
    const double done = (double)verify->rows + share;
    return progress_show(done / (double)verify->to_do, verify->progress);
}

static void run_row(Verify *verify, const VerifyCheck *check, const VerifyRow *row, const char *scenario)
{
    VerifyRun *run = &verify->run;
    if (!(run->scenario && strcmp(run->scenario, scenario) == 0)) {
        verify_run_close(run);
        const Cancel cancel = {verify->progress ? show_progress : NULL, verify};
        verify_run_open(run, scenario, verify->threads, cancel);
    }
    const VerifyNumbers numbers = verify_numbers(run->failure.code == STATUS_DONE ? run : NULL, row);
    if (progress_signal())
        return;
    if (verify->progress)
        progress_end(verify->progress);
    const double number = numbers.values[numbers.own];
    const Verdict verdicts[VERDICTS] = {verify_reproduces(row, &numbers), verify_is_bounded(row, &numbers),
                                        verify_is_near(row, &numbers)};
    const Agreement paper = verify_agreement(&row->paper, number),
                    also = verify_agreement(&row->also, number);
    if (verify->json) {
        put_row(verify, check, row, &numbers, verdicts, paper, also);
    } else {
        print_row(verify->out, row, &numbers);
        print_verdicts(verify->out, row, &numbers, verdicts);
        print_agreement(verify->out, &row->paper, number, paper);
        print_agreement(verify->out, &row->also, number, also);
        if (run->failure.code != STATUS_DONE)
            fprintf(verify->out, "    %s\n", run->failure.text);
    }
    fflush(verify->out);
    verify->rows++;
    verify->references[verdicts[REPRODUCES]]++;
    verify->bounds[verdicts[BOUNDED]]++;
    verify->bounds[verdicts[NEAR]]++;
    verify->papers[paper]++;
    if (also != PAPER_SILENT)
        verify->papers[also]++;
}

void verify_check_run(Verify *verify, const VerifyCheck *check, bool full)
{
    const char *scenario = NULL;
    if (!verify->json) {
        fprintf(verify->out, "%s  %s\n", check->name, check->title);
        print_columns(verify->out, "", column_words);
    }
    fflush(verify->out);
    for (int i = 0; i < check->n_rows && !ferror(verify->out) && !progress_signal(); i++) {
        scenario = check->rows[i].scenario ? check->rows[i].scenario : scenario;
        if (full || !check->rows[i].full)
            run_row(verify, check, &check->rows[i], scenario);
    }
    if (progress_signal() || verify->json)
        return;
    fprintf(verify->out, check->note ? "  %s\n\n" : "\n", check->note);
}

int verify_end(Verify *verify, Status *status)
{
    verify_run_close(&verify->run);
    const long *references = verify->references, *bounds = verify->bounds, *papers = verify->papers;
    const long missed = references[VERDICT_MISSED] + bounds[VERDICT_MISSED];
    if (verify->json)
        quantities_close(verify->json); /* what there is, whole */
    if (progress_signal()) {
        if (verify->progress)
            progress_end(verify->progress);
        status_fail(status, "verify: interrupted after %ld rows", verify->rows);
        return 128 + progress_signal();
    }
    if (ferror(verify->out))
        return STATUS_DONE; /* not all was run; closing the stream reports the error */
    if (!verify->json) {
        fprintf(verify->out, "ours: %ld of %ld reproduced; %ld of %ld bounds hold\n",
                references[VERDICT_GOOD], references[VERDICT_GOOD] + references[VERDICT_MISSED],
                bounds[VERDICT_GOOD], bounds[VERDICT_GOOD] + bounds[VERDICT_MISSED]);
        fprintf(verify->out, "paper: %ld agree, %ld near, %ld differ%s, %ld not given\n",
                papers[PAPER_AGREES], papers[PAPER_NEAR], papers[PAPER_DIFFERS],
                papers[PAPER_DIFFERS] == 1 ? "s" : "", papers[PAPER_SILENT]);
    }
    if (missed == 0)
        return STATUS_DONE;
    status_fail(status, "verify: %ld of %ld missed", missed,
                missed + references[VERDICT_GOOD] + bounds[VERDICT_GOOD]);
    return STATUS_FAILED;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The runner of verify: makes the runs that rows name, one run for consecutive rows of the same scenario, and
 * prints each number, and under it its verdicts: against our reference, its bounds, the paper (verify_row.h).
 */
#include "cli/verify/verify_runner.h"

#include "base/cancel.h"
#include "base/math/functions.h"

#include <string.h>

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

static void print_verdicts(FILE *out, const VerifyRow *row, const VerifyNumbers *numbers, Verdict reproduces,
                           Verdict bounded, Verdict near)
{
    static const char *const good[] = {"MISSED", "reproduces", "holds"};
    static const char *const beside[VERIFY_COLUMNS] = {[VERIFY_THEORY] = "theory",
                                                       [VERIFY_EIGENVALUE] = "the eigenvalue",
                                                       [VERIFY_PREDICTED] = "the prediction"};

    char band[64];
    if (reproduces != VERDICT_NONE) {
        print_band(band, row->reference, row->decimals);
        fprintf(out, "    our reference: %s: %s\n", band, good[reproduces == VERDICT_GOOD ? 1 : 0]);
    }
    if (bounded != VERDICT_NONE) {
        print_band(band, row->bound, row->decimals);
        fprintf(out, "    bound: %s: %s\n", band, good[bounded == VERDICT_GOOD ? 2 : 0]);
    }
    if (near != VERDICT_NONE)
        fprintf(out, "    off %s by %.1e (at most %.1e): %s\n", beside[numbers->beside],
                fabs(numbers->values[numbers->own] - numbers->values[numbers->beside]), row->tolerance,
                good[near == VERDICT_GOOD ? 2 : 0]);
}

static void print_agreement(FILE *out, const Claim *claim, double number, Agreement agreement)
{
    static const char *const words[AGREEMENTS] = {
        [PAPER_AGREES] = "agrees", [PAPER_NEAR] = "near", [PAPER_DIFFERS] = "differs"};
    if (agreement == PAPER_SILENT)
        return;
    fprintf(out, "    the paper: \"%s\"", claim->words);
    if (isnan(claim->number))
        fprintf(out, " (taken as %g..%g)", claim->range.low, claim->range.high);
    fprintf(out, ": %s", words[agreement]);
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
                    const VerifyNumbers *numbers, const Verdict verdicts[3], Agreement paper, Agreement also)
{
    static const char *const kinds[] = {"reference", "bound", "near"};
    static const char *const papers[AGREEMENTS] = {
        [PAPER_AGREES] = "agrees", [PAPER_NEAR] = "near", [PAPER_DIFFERS] = "differs"};
    char unit[16];
    quantities_add(verify->json, row->what + strspn(row->what, " "), numbers->values[numbers->own],
                   unit_of(check, row, unit));
    quantities_text(verify->json, "check", check->name);
    for (int i = 0; i < VERIFY_COLUMNS; i++)
        if (!isnan(numbers->values[i]))
            quantities_number(verify->json, column_words[i], numbers->values[i]);
    for (int i = 0; i < 3; i++)
        if (verdicts[i] != VERDICT_NONE)
            quantities_text(verify->json, kinds[i], verdicts[i] == VERDICT_GOOD ? "holds" : "missed");
    if (paper != PAPER_SILENT)
        quantities_text(verify->json, "paper", papers[paper]);
    if (also != PAPER_SILENT)
        quantities_text(verify->json, "paper_also", papers[also]);
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
    const Verdict reproduces = verify_reproduces(row, &numbers), bounded = verify_is_bounded(row, &numbers),
                  near = verify_is_near(row, &numbers);
    const Agreement paper = verify_agreement(&row->paper, number),
                    also = verify_agreement(&row->also, number);
    if (verify->json) {
        put_row(verify, check, row, &numbers, (const Verdict[]){reproduces, bounded, near}, paper, also);
    } else {
        print_row(verify->out, row, &numbers);
        print_verdicts(verify->out, row, &numbers, reproduces, bounded, near);
        print_agreement(verify->out, &row->paper, number, paper);
        print_agreement(verify->out, &row->also, number, also);
    }
    if (!verify->json && run->failure.code != STATUS_DONE)
        fprintf(verify->out, "    %s\n", run->failure.text);
    fflush(verify->out);
    verify->rows++;
    verify->references[reproduces]++;
    verify->bounds[bounded]++;
    verify->bounds[near]++;
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

static void print_counts(const Verify *verify)
{
    const long *references = verify->references, *bounds = verify->bounds, *papers = verify->papers;
    fprintf(verify->out, "ours: %ld of %ld reproduced; %ld of %ld bounds hold\n", references[VERDICT_GOOD],
            references[VERDICT_GOOD] + references[VERDICT_MISSED], bounds[VERDICT_GOOD],
            bounds[VERDICT_GOOD] + bounds[VERDICT_MISSED]);
    fprintf(verify->out, "paper: %ld agree, %ld near, %ld differ%s, %ld not given\n", papers[PAPER_AGREES],
            papers[PAPER_NEAR], papers[PAPER_DIFFERS], papers[PAPER_DIFFERS] == 1 ? "s" : "",
            papers[PAPER_SILENT]);
}

int verify_end(Verify *verify, Status *status)
{
    verify_run_close(&verify->run);
    const long *references = verify->references, *bounds = verify->bounds;
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
    if (!verify->json)
        print_counts(verify);
    if (missed == 0)
        return STATUS_DONE;
    status_fail(status, "verify: %ld of %ld missed", missed,
                missed + references[VERDICT_GOOD] + bounds[VERDICT_GOOD]);
    return STATUS_FAILED;
}

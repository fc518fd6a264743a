/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The runner of verify: makes the runs that rows name, one run for consecutive rows of the same scenario, and
 * prints each number with its two verdicts, against our reference and against the paper (verify_row.h). */
#include "cli/verify/verify_runner.h"

#include <string.h>

/* --- a row --------------------------------------------------------------------------------------- */

static void print_number(char out[32], double value, int decimals)
{
    out[0] = '\0';
    if (!isnan(value))
        snprintf(out, 32, "%.*f", decimals, value);
}

enum { REFERENCE_WIDTH = 18 };

/* "2..3", ">= 2", "<= 3", or "2" alone; where that has no room, the middle and how far it may be off. */
static void print_reference(char out[64], const VerifyRow *row)
{
    double low = row->reference.low, high = row->reference.high;
    int decimals = row->decimals, length = 0;
    /* more digits than the number has, where both ends would look the same */
    while (high > low && high - low < 1.9 * pow(10, -decimals) && decimals < 12)
        decimals++;
    out[0] = '\0';
    if (low == 0 && high == 0)
        return;
    if (low == high)
        snprintf(out, 64, "%.*f", decimals, low);
    else if (isinf(low) || isinf(high))
        snprintf(out, 64, isinf(low) ? "<= %.*f" : ">= %.*f", decimals, isinf(low) ? high : low);
    else
        length = snprintf(out, 64, "%.*f..%.*f", decimals, low, decimals, high);
    if (length > REFERENCE_WIDTH)
        snprintf(out, 64, "%.*f +- %.0e", row->decimals, (low + high) / 2, (high - low) / 2);
}

static void print_head(FILE *out)
{
    fprintf(out, "  %-26s %10s %10s  %-18s  %s\n", "", "theory", "measured", "our reference", "");
}

static void print_row(FILE *out, const VerifyRow *row, double measured, double theory, bool reproduced)
{
    char numbers[2][32], reference[64];
    print_number(numbers[0], theory, row->decimals);
    print_number(numbers[1], measured, row->decimals);
    print_reference(reference, row);
    fprintf(out, "  %-26s %10s %10s  %-18s  %s\n", row->what, numbers[0],
            isnan(measured) ? "none" : numbers[1], reference, reproduced ? "yes" : "MISSED");
}

static void print_agreement(FILE *out, const Claim *claim, double measured, Agreement agreement)
{
    static const char *const words[AGREEMENTS] = {
        [PAPER_AGREES] = "agrees", [PAPER_NEAR] = "near", [PAPER_DIFFERS] = "differs"};
    if (agreement == PAPER_SILENT)
        return;
    fprintf(out, "    the paper: \"%s\": %s", claim->words, words[agreement]);
    if (!isnan(claim->number) && !isnan(measured))
        fprintf(out, fabs(measured / claim->number - 1) < 0.1 ? ", %+.1f %%" : ", %+.0f %%",
                100 * (measured / claim->number - 1));
    if (claim->remark)
        fprintf(out, "\n      (%s)", claim->remark);
    fputc('\n', out);
}

/* --- running ------------------------------------------------------------------------------------- */

static bool same_run(const VerifyRun *run, const char *scenario)
{
    return run->scenario && strcmp(run->scenario, scenario) == 0;
}

static bool show_progress(double share, void *context)
{
    const Verify *verify = context;
    const double done = (double)(verify->reproduced + verify->missed) + share;
    return progress_show(done / (double)verify->to_do, verify->progress);
}

static void run_row(Verify *verify, const VerifyRow *row, const char *scenario)
{
    VerifyRun *run = &verify->run;
    if (!same_run(run, scenario)) {
        verify_run_close(run);
        const Patience patience = {verify->progress ? show_progress : NULL, verify};
        verify_run_open(run, scenario, verify->threads, patience);
    }
    double measured = NAN, theory = NAN;
    if (run->failure.code == STATUS_DONE) {
        measured = row->quantity(run, row);
        theory = row->theory ? row->theory(run, row) : NAN;
    }
    if (progress_signal())
        return;
    if (verify->progress)
        progress_end(verify->progress);
    bool reproduced = verify_reproduces(row, measured, theory);
    Agreement agreement = verify_agreement(&row->paper, measured);
    print_row(verify->out, row, measured, theory, reproduced);
    print_agreement(verify->out, &row->paper, measured, agreement);
    if (run->failure.code != STATUS_DONE)
        fprintf(verify->out, "    %s\n", run->failure.text);
    fflush(verify->out);
    verify->reproduced += reproduced;
    verify->missed += !reproduced;
    verify->papers[agreement]++;
}

void verify_check_run(Verify *verify, const VerifyCheck *check, bool full)
{
    const char *scenario = NULL;
    fprintf(verify->out, "%s  %s\n", check->name, check->title);
    print_head(verify->out);
    fflush(verify->out);
    for (int i = 0; i < check->n_rows && !ferror(verify->out) && !progress_signal(); i++) {
        scenario = check->rows[i].scenario ? check->rows[i].scenario : scenario;
        if (full || !check->rows[i].full)
            run_row(verify, &check->rows[i], scenario);
    }
    if (progress_signal())
        return;
    fprintf(verify->out, check->note ? "  %s\n\n" : "\n", check->note);
}

int verify_end(Verify *verify, Status *status)
{
    verify_run_close(&verify->run);
    long all = verify->reproduced + verify->missed;
    if (progress_signal()) {
        if (verify->progress)
            progress_end(verify->progress);
        status_fail(status, STATUS_FAILED, "verify: interrupted after %ld rows", all);
        return 128 + progress_signal();
    }
    if (ferror(verify->out))
        return STATUS_DONE; /* not all was run; closing the stream reports the error */
    fprintf(verify->out,
            "ours: %ld of %ld reproduced; paper: %ld agree, %ld near, %ld differ%s, %ld not given\n",
            verify->reproduced, all, verify->papers[PAPER_AGREES], verify->papers[PAPER_NEAR],
            verify->papers[PAPER_DIFFERS], verify->papers[PAPER_DIFFERS] == 1 ? "s" : "",
            verify->papers[PAPER_SILENT]);
    if (verify->missed == 0)
        return STATUS_DONE;
    status_fail(status, STATUS_FAILED, "verify: %ld of %ld missed", verify->missed, all);
    return STATUS_FAILED;
}

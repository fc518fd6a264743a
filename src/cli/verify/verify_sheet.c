#include "cli/verify/verify_sheet.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

Bound within(double centre, double tolerance)
{
    return (Bound){centre - tolerance, centre + tolerance};
}

Verdict verdict_of(double measured, const Bound *bounds, int count)
{
    if (count == 0)
        return VERDICT_SHOWN;
    for (int i = 0; i < count; i++)
        if (!(measured >= bounds[i].low && measured <= bounds[i].high))
            return VERDICT_MISSED;
    return VERDICT_HOLDS;
}

static const char *word_of(Verdict verdict)
{
    static const char *const words[] = {
        [VERDICT_SHOWN] = "-", [VERDICT_HOLDS] = "holds", [VERDICT_MISSED] = "MISSED"};
    return words[verdict];
}

static void count_verdict(Verify *verify, Verdict verdict)
{
    verify->held += verdict == VERDICT_HOLDS;
    verify->missed += verdict == VERDICT_MISSED;
}

int verify_end(Verify *verify, Status *status)
{
    long all = verify->held + verify->missed;
    if (ferror(verify->out))
        return STATUS_DONE; /* not all was run; who closes the stream tells */
    fprintf(verify->out, "%ld of %ld hold\n", verify->held, all);
    if (verify->missed == 0)
        return STATUS_DONE;
    status_fail(status, STATUS_FAILED, "verify: %ld of %ld missed", verify->missed, all);
    return STATUS_FAILED;
}

/* --- rows ---------------------------------------------------------------------------------------- */

static const char row_layout[] = "  %-22s %-10s %9s %9s %16s  %s\n";

void verify_head(Verify *verify, const char *quantity)
{
    fprintf(verify->out, row_layout, quantity ? quantity : "", "paper", "predicted", "measured", "allowed",
            "");
}

/* A number, or nothing where there is none. */
static void number_text(char out[32], double value, int decimals)
{
    out[0] = '\0';
    if (!isnan(value))
        snprintf(out, 32, "%.*f", decimals, value);
}

enum { ALLOWED_WIDTH = 16 };

/* What all bounds together leave: "2..3", ">= 2", "<= 3", or "2" alone; where that has no room, how far the
 * number may be off. */
static void allowed_text(char out[64], const VerifyRow *row)
{
    double low = -INFINITY, high = INFINITY;
    for (int i = 0; i < row->n_bounds; i++)
        low = fmax(low, row->bounds[i].low), high = fmin(high, row->bounds[i].high);
    /* more digits than the number has, where both ends would look the same */
    int decimals = row->decimals, length = 0;
    while (high > low && high - low < 1.9 * pow(10, -decimals) && decimals < 12)
        decimals++;
    out[0] = '\0';
    if (low == high)
        snprintf(out, 64, "%.*f", decimals, low);
    else if (isfinite(low) && isfinite(high))
        length = snprintf(out, 64, "%.*f..%.*f", decimals, low, decimals, high);
    else if (isfinite(low))
        snprintf(out, 64, ">= %.*f", decimals, low);
    else if (isfinite(high))
        snprintf(out, 64, "<= %.*f", decimals, high);
    if (length > ALLOWED_WIDTH)
        snprintf(out, 64, "within %.0e", (high - low) / 2);
}

void verify_row(Verify *verify, const VerifyRow *row)
{
    char predicted[32], measured[32], allowed[64];
    number_text(predicted, row->predicted, row->decimals);
    number_text(measured, row->measured, row->decimals);
    allowed_text(allowed, row);
    Verdict verdict = verdict_of(row->measured, row->bounds, row->n_bounds);
    count_verdict(verify, verdict);
    fprintf(verify->out, row_layout, row->what, row->paper ? row->paper : "", predicted,
            isnan(row->measured) ? "none" : measured, allowed, word_of(verdict));
    fflush(verify->out);
}

/* --- tables of their own ------------------------------------------------------------------------- */

static void print_cell(Verify *verify, const VerifyColumn *column, bool first, const char *text)
{
    fprintf(verify->out, first ? "%-*s" : "%*s", column->width, text);
}

void verify_columns(Verify *verify, const VerifyColumn *columns, int count)
{
    fputs("  ", verify->out);
    for (int i = 0; i < count; i++)
        print_cell(verify, &columns[i], i == 0, columns[i].heading);
    fputc('\n', verify->out);
}

void verify_line(Verify *verify, const VerifyColumn *columns, int count, const char *const *cells,
                 Verdict verdict)
{
    count_verdict(verify, verdict);
    fputs("  ", verify->out);
    for (int i = 0; i < count; i++)
        print_cell(verify, &columns[i], i == 0, cells[i]);
    fprintf(verify->out, "  %s\n", word_of(verdict));
    fflush(verify->out);
}

void verify_note(Verify *verify, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("  ", verify->out);
    vfprintf(verify->out, format, arguments);
    fputc('\n', verify->out);
    va_end(arguments);
    fflush(verify->out);
}

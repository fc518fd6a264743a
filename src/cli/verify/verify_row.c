/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Verdicts on a number. */
#include "cli/verify/verify_row.h"

static bool lies_in(Band band, double number)
{
    return number >= band.low && number <= band.high; /* what is not a number lies nowhere */
}

VerifyNumbers verify_numbers(VerifyRun *run, const VerifyRow *row)
{
    const VerifyQuantity quantities[VERIFY_COLUMNS] = {[VERIFY_THEORY] = row->theory,
                                                       [VERIFY_EIGENVALUE] = row->eigenvalue,
                                                       [VERIFY_PREDICTED] = row->predicted,
                                                       [VERIFY_MEASURED] = row->quantity};
    VerifyNumbers numbers;
    const double scale = row->scale != 0 ? row->scale : 1;
    int found = 0;
    for (int i = VERIFY_COLUMNS; i-- > 0;) {
        numbers.values[i] = run && quantities[i] ? scale * quantities[i](run, row) : NAN;
        if (quantities[i] && found++ == 0)
            numbers.own = numbers.beside = (VerifyColumn)i;
        else if (quantities[i] && found == 2)
            numbers.beside = (VerifyColumn)i;
    }
    return numbers;
}

static Verdict of_band(Band band, double number)
{
    if (band.low == 0 && band.high == 0)
        return VERDICT_NONE;
    return lies_in(band, number) ? VERDICT_GOOD : VERDICT_MISSED;
}

Verdict verify_reproduces(const VerifyRow *row, const VerifyNumbers *numbers)
{
    return of_band(row->reference, numbers->values[numbers->own]);
}

Verdict verify_is_bounded(const VerifyRow *row, const VerifyNumbers *numbers)
{
    return of_band(row->bound, numbers->values[numbers->own]);
}

Verdict verify_is_near(const VerifyRow *row, const VerifyNumbers *numbers)
{
    if (!(row->tolerance > 0))
        return VERDICT_NONE;
    double off = fabs(numbers->values[numbers->own] - numbers->values[numbers->beside]);
    return off <= row->tolerance ? VERDICT_GOOD : VERDICT_MISSED;
}

Agreement verify_agreement(const Claim *claim, double measured)
{
    if (!claim->words)
        return PAPER_SILENT;
    if (isnan(claim->number))
        return lies_in(claim->range, measured) ? PAPER_AGREES : PAPER_DIFFERS;
    double off = fabs(measured / claim->number - 1);
    return off <= claim->agrees ? PAPER_AGREES : off <= claim->near ? PAPER_NEAR : PAPER_DIFFERS;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Verdicts on a number. */
#include "cli/verify/verify_row.h"

static bool lies_in(Band band, double number)
{
    return number >= band.low && number <= band.high; /* what is no number lies nowhere */
}

bool verify_reproduces(const VerifyRow *row, double measured, double theory)
{
    if ((row->reference.low != 0 || row->reference.high != 0) && !lies_in(row->reference, measured))
        return false;
    if (row->tolerance > 0 && !(fabs(measured - theory) <= row->tolerance))
        return false;
    return !isnan(measured);
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

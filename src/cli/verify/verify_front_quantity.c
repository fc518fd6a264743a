/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers of the cracks of a plate, of the front that grows from a cut's end (fronts.h), at the end of the
 * run. */
#include "cli/verify/verify_quantity.h"

#include "methods/bonds/cracks/fronts.h"

typedef enum FrontNumber { BRANCH_X, BRANCH_TIME, HALF_ANGLE, FASTEST, ANGLE } FrontNumber;

static double number_of(const CrackFront *front, FrontNumber which, double height)
{
    const double of_branch[] = {front->branch[0], front->branch_time, front->half_angle};
    if (which <= HALF_ANGLE)
        return front->branched ? of_branch[which] : NAN;
    return which == FASTEST ? front->fastest : fabs(crack_fronts_angle(front, height));
}

/* Of the first front; NAN: there is no front, or it has no such number. */
static double front_number(const VerifyRun *run, FrontNumber which, double height)
{
    CrackFronts fronts = {0};
    double number = NAN;
    if (crack_fronts_update(&fronts, run->passing.sim) && fronts.count > 0)
        number = number_of(&fronts.fronts[0], which, height);
    crack_fronts_free(&fronts);
    return number;
}

double quantity_branch_x(VerifyRun *run, const VerifyRow *row)
{
    return front_number(run, BRANCH_X, row->from);
}

double quantity_branch_time(VerifyRun *run, const VerifyRow *row)
{
    return front_number(run, BRANCH_TIME, row->from);
}

double quantity_half_angle(VerifyRun *run, const VerifyRow *row)
{
    return front_number(run, HALF_ANGLE, row->from);
}

double quantity_front_speed(VerifyRun *run, const VerifyRow *row)
{
    return front_number(run, FASTEST, row->from);
}

double quantity_front_angle(VerifyRun *run, const VerifyRow *row)
{
    return front_number(run, ANGLE, row->from);
}

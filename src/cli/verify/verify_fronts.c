/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers of the cracks of a plate, of the front that grows from a cut's end (fronts.h), at the end of the
 * run. */
#include "cli/verify/verify_quantity.h"

#include "methods/bonds/cracks/fronts.h"

/* The number `what` of the first front; NAN: there is no front, or it has no such number. */
static double front_number(VerifyRun *run, const VerifyRow *row,
                           double (*what)(const VerifyRun *, const VerifyRow *, const CrackFront *))
{
    CrackFronts fronts = {0};
    double number = NAN;
    if (crack_fronts_update(&fronts, run->passing.sim) && fronts.count > 0)
        number = what(run, row, &fronts.fronts[0]);
    crack_fronts_free(&fronts);
    return row->scale != 0 ? row->scale * number : number;
}

static double branch_x(const VerifyRun *run, const VerifyRow *row, const CrackFront *front)
{
    (void)run, (void)row;
    return front->branched ? front->branch[0] : NAN;
}

static double branch_time(const VerifyRun *run, const VerifyRow *row, const CrackFront *front)
{
    (void)run, (void)row;
    return front->branched ? front->branch_time : NAN;
}

static double half_angle(const VerifyRun *run, const VerifyRow *row, const CrackFront *front)
{
    (void)run, (void)row;
    return front->branched ? front->half_angle : NAN;
}

static double fastest(const VerifyRun *run, const VerifyRow *row, const CrackFront *front)
{
    (void)run, (void)row;
    return front->fastest;
}

static double angle_over(const VerifyRun *run, const VerifyRow *row, const CrackFront *front)
{
    (void)run;
    return fabs(crack_fronts_angle(front, row->from));
}

double fronts_branch_x(VerifyRun *run, const VerifyRow *row)
{
    return front_number(run, row, branch_x);
}

double fronts_branch_time(VerifyRun *run, const VerifyRow *row)
{
    return front_number(run, row, branch_time);
}

double fronts_half_angle(VerifyRun *run, const VerifyRow *row)
{
    return front_number(run, row, half_angle);
}

double fronts_speed(VerifyRun *run, const VerifyRow *row)
{
    return front_number(run, row, fastest);
}

double fronts_angle(VerifyRun *run, const VerifyRow *row)
{
    return front_number(run, row, angle_over);
}

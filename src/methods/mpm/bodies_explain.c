/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sums behind the stages that bodies do otherwise than beams: walls and contact with normal, gap,
 * velocity of approach and impulse; stress that turns; momentum that fades. */
#include "base/assertion.h"
#include "methods/mpm/bodies_inner.h"
#include "methods/mpm/subject.h"

double bodies_given(const Mpm *mpm, int axis, int p, int a, int b, const MpmWeights *w)
{
    const double s[2] = {a - (mpm->s[0][p] - mpm->edge), b - (mpm->s[1][p] - mpm->edge)};
    double v = mpm->v[axis][p];
    for (int k = 0; mpm->head->transfer == MPM_APIC && k < 2; k++) {
        const double D = bodies_spread(mpm, mpm->s[k][p], w->n[k]) * mpm->dx;
        v += D > 0.0 ? mpm->rate[2 * axis + k][p] / D * s[k] : 0.0;
    }
    return v;
}

static double was(const Subject *subject, const double *now)
{
    return calculation_before(mpm_of_const(subject->sim)->block, now, subject->before);
}

/* The other body's part at the node, from the momenta before the stage; of the fields in their order. */
static bool write_meeting(const Subject *subject, int a, int b)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const int node = subject->index % mpm->grid_nodes, own = subject->index / mpm->grid_nodes;
    const int at[2] = {a * mpm->grid_nodes + node, b * mpm->grid_nodes + node};
    double q[2][2];
    for (int k = 0; k < 2; k++)
        for (int axis = 0; axis < 2; axis++)
            q[k][axis] = was(subject, &mpm->momentum[axis][at[k]]);
    const Meeting meeting = bodies_meet(mpm, node, a, b, (const double(*)[2])q);
    if (!isfinite(meeting.distance))
        return false;
    Calculation *to = subject->calculation;
    const double sign = own == a ? 1.0 : -1.0;
    calculation_write(to, "with %s: ", mpm->bodies->def.bodies[own == a ? b : a].name);
    calculation_number(to, "n = (", sign * meeting.normal[0]);
    calculation_number(to, ", ", sign * meeting.normal[1]);
    calculation_value(to, ")   gap in cells = ", meeting.distance);
    calculation_value(to, "vₙ = (v - v_common)·n = ",
                      own == a ? meeting.approach
                               : meeting.approach * mpm->node_mass[at[0]] / mpm->node_mass[at[1]]);
    if (meeting.impulse[0] == 0.0 && meeting.impulse[1] == 0.0) {
        calculation_write(to, meeting.approach > 0.0 ? "too far apart: nothing is given\n"
                                                     : "they part: nothing is given\n");
        return true;
    }
    calculation_number(to, "this body gives it (", sign * meeting.impulse[0]);
    calculation_number(to, ", ", sign * meeting.impulse[1]);
    calculation_write(to, ")\n");
    return true;
}

void bodies_write_fix(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const int own = subject->index / mpm->grid_nodes, fields = mpm->bodies->n_fields;
    const bool wall = bodies_at_wall(mpm, subject->index);
    bool any = wall;
    if (!subject->before)
        return;
    if (wall)
        calculation_write(subject->calculation, "a wall acts on this node\n");
    /* contact beside a wall begins with what the wall leaves */
    for (int other = 0; !wall && other < fields; other++)
        if (other != own)
            any = write_meeting(subject, other < own ? other : own, other < own ? own : other) || any;
    for (int axis = 0; any && axis < 2; axis++) {
        calculation_number(subject->calculation,
                           axis ? "py: " : "px: ", was(subject, &mpm->momentum[axis][subject->index]));
        calculation_value(subject->calculation, " → ", mpm->momentum[axis][subject->index]);
    }
    if (!any)
        calculation_write(subject->calculation, "no wall and no other body here: its momentum stays\n");
}

/* The stress before and after; the hypoelastic one is turned, then strained. */
void bodies_write_strain(const Subject *subject)
{
    static const char *const names[3] = {"σxx", "σyy", "σxy"}, *const strains[3] = {"exx", "eyy", "gxy"};
    static const char *const labels[3] = {"Δεxx = Σ Δt N,x vx = ", "   Δεyy = Σ Δt N,y vy = ", "   Δγxy = "};
    const Mpm *mpm = mpm_of_const(subject->sim);
    Calculation *to = subject->calculation;
    const int p = subject->index;
    if (mpm_has_done(mpm, OP_STRAIN)) {
        for (int k = 0; k < 3; k++)
            calculation_number(to, labels[k],
                               simulation_named(subject->sim, MPM_PARTICLES, strains[k], (size_t)p));
        calculation_write(to, "\n");
    }
    for (int k = 0; subject->before && k < 3; k++) {
        calculation_write(to, "%s: ", names[k]);
        calculation_number(to, "", was(subject, &mpm->stress[k][p]));
        calculation_value(to, " → ", mpm->stress[k][p]);
    }
    calculation_value(to, "det F = V/V₀ = ", mpm->volume[p] / mpm->bodies->volume);
}

/* q + dt (f - damping q); the momentum before is solved for. */
void bodies_write_integrate(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    static const char *const labels[2] = {"px = px + Δt (fx - α px) = ", "py = py + Δt (fy - α py) = "};
    for (int axis = 0; axis < 2; axis++) {
        const double now = mpm->momentum[axis][subject->index], f = mpm->force[axis][subject->index];
        const double rate = mpm->bodies->def.damping, before = (now - mpm->dt * f) / (1.0 - mpm->dt * rate);
        calculation_change(subject->calculation, labels[axis], before, mpm->dt, f - rate * before, now, NULL);
    }
}

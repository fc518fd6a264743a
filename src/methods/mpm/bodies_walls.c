/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Walls and contact, on the momenta of nodes (stage `fix`).
 *
 *     wall      acts on its nodes and all beyond, in the order left, right, bottom, top:
 *               clamp     q = q0 = 0
 *               slip      where q goes out of the box and |mean place - wall| <= gap: its normal part goes
 *               friction  besides, the tangential part is reduced by at most mu times what was removed
 *     contact   of the fields a < b in their order, where (r_b/m_b - r_a/m_a) . n <= 2 gap:
 *               n = (n_a - n_b)/|n_a - n_b|
 *               v = (q_a + q_b)/(m_a + m_b)
 *               vn = (q_a/m_a - v) . n      vt = q_a/m_a - v - vn n
 *               vn > 0: J = m_a (vn n + min(1, mu vn/|vt|) vt), q_a -= J, q_b += J
 *
 * n_i = sum m grad N points out of a body; a wall's n points out of the box.
 * Bardenhagen, Brackbill, Sulsky 2000; the gap after Nairn 2013. Contact keeps momentum and the grid's
 * angular momentum exactly. Energy that friction takes: impulse times the mean of the relative tangential
 * velocities before and after. */
#include "methods/mpm/mistakes.h"

#include <stdio.h>

bool bodies_at_wall(const Mpm *mpm, int node)
{
    const int place = node % mpm->grid_nodes;
    const int i = place % mpm->gx - BODIES_PADDING, j = place / mpm->gx - BODIES_PADDING;
    const bool at[WALLS] = {i <= 0, i >= mpm->box[0], j <= 0, j >= mpm->box[1]};
    for (int wall = 0; wall < WALLS; wall++)
        if (at[wall] && mpm->def.walls[wall] != WALL_OPEN)
            return true;
    return false;
}

/* A wall is at `place` in cells. Returns the energy that friction takes. */
static double hold(Mpm *mpm, int node, int wall, double place)
{
    const int axis = wall / 2;
    double *const normal = &mpm->momentum[axis][node], *const along = &mpm->momentum[1 - axis][node];
    const MpmDef *def = &mpm->def;
    if (def->walls[wall] == WALL_CLAMP) {
        *normal = *along = 0.0;
        mpm->start[0][node] = mpm->start[1][node] = 0.0;
        return 0.0;
    }
    const double mass = mpm->node_mass[node];
    if (!(wall % 2 ? *normal > 0.0 : *normal < 0.0) ||
        !(fabs(mpm->moment[axis][node] / mass - place * mpm->dx) <= def->gap * mpm->dx))
        return 0.0;
    mpm->touched[node] |= 1u << (BODIES_MAX + wall);
    const double most = def->wall_friction * fabs(*normal), before = fabs(*along);
    *normal = 0.0;
    if (def->walls[wall] != WALL_FRICTION || !(most > 0.0))
        return 0.0;
    const double after = before > most ? before - most : 0.0;
    *along = *along > 0.0 ? after : -after;
    return (before - after) * (before + after) / (2.0 * mass);
}

Meeting bodies_meet(const Mpm *mpm, int node, int a, int b, const double q[2][2])
{
    const int at[2] = {a * mpm->grid_nodes + node, b * mpm->grid_nodes + node};
    const double m[2] = {mpm->node_mass[at[0]], mpm->node_mass[at[1]]}, both = m[0] + m[1];
    Meeting meeting = {{0.0, 0.0}, INFINITY, 0.0, {0.0, 0.0}, 0.0};
    double *const n = meeting.normal, v[2], length = 0.0;
    if (!(m[0] > mpm->floor && m[1] > mpm->floor))
        return meeting;
    const double other = mpm_does(mpm, WRONG_NORMAL_OF_ONE) ? 0.0 : 1.0;
    for (int axis = 0; axis < 2; axis++) {
        n[axis] = mpm->normal[axis][at[0]] - other * mpm->normal[axis][at[1]];
        length += n[axis] * n[axis];
    }
    if (!(length > 0.0))
        return meeting;
    length = 1.0 / sqrt(length);
    meeting.distance = 0.0;
    for (int axis = 0; axis < 2; axis++) {
        const double *const r = mpm->moment[axis];
        n[axis] *= length;
        meeting.distance += (r[at[1]] / m[1] - r[at[0]] / m[0]) * n[axis] / mpm->dx;
        v[axis] = q[0][axis] / m[0] - (q[0][axis] + q[1][axis]) / both;
        meeting.approach += v[axis] * n[axis];
    }
    const MpmDef *def = &mpm->def;
    if (meeting.distance > 2.0 * def->gap || !(meeting.approach > 0.0))
        return meeting;
    const double vn = meeting.approach, t[2] = {v[0] - vn * n[0], v[1] - vn * n[1]};
    const double vt = sqrt(t[0] * t[0] + t[1] * t[1]), most = def->friction * vn;
    const double share = vt > most ? most / vt : 1.0;
    for (int axis = 0; axis < 2; axis++)
        meeting.impulse[axis] = m[0] * (vn * n[axis] + share * t[axis]);
    /* of b the velocity relative to v is -m_a/m_b times that of a */
    meeting.lost = 0.5 * m[0] * both / m[1] * (vt * vt) * (share * (2.0 - share));
    return meeting;
}

static void touch(Mpm *mpm, int node)
{
    int there[BODIES_MAX], count = 0;
    for (int field = 0; field < mpm->n_fields; field++)
        if (mpm->node_mass[field * mpm->grid_nodes + node] > mpm->floor)
            there[count++] = field;
    for (int a = 0; a < count; a++)
        for (int b = a + 1; b < count; b++) {
            const int i = there[a] * mpm->grid_nodes + node, j = there[b] * mpm->grid_nodes + node;
            const Meeting meeting =
                bodies_meet(mpm, node, there[a], there[b],
                            (const double[2][2]){{mpm->momentum[0][i], mpm->momentum[1][i]},
                                                 {mpm->momentum[0][j], mpm->momentum[1][j]}});
            for (int axis = 0; axis < 2; axis++) {
                mpm->momentum[axis][i] -= meeting.impulse[axis];
                mpm->momentum[axis][j] += meeting.impulse[axis];
            }
            mpm->lost[node] += meeting.lost;
            if (meeting.impulse[0] != 0.0 || meeting.impulse[1] != 0.0)
                mpm->touched[i] |= 1u << there[b];
        }
}

/* q += dt (f - damping q) */
void bodies_integrate(Mpm *mpm, int first, int end)
{
    const double dt = mpm->dt, damping = mpm->def.damping;
    for (int k = 0; k < 2 * mpm->n_fields; k++) {
        const size_t field = (size_t)(k / 2) * (size_t)mpm->grid_nodes;
        double *const q = mpm->momentum[k % 2] + field;
        const double *const f = mpm->force[k % 2] + field;
#pragma omp simd
        for (int i = first; i < end; i++)
            q[i] += dt * (f[i] - damping * q[i]);
    }
}

/* Walls and contact, and then the velocities of nodes: after the first `fix` those that strain with USF;
 * after the second carry = q/m and kick = (q - q0)/m of eqs. 14, 15, and the velocity that strains with USL;
 * after the third that of MUSL. */
void bodies_fix(Mpm *mpm, MpmOp op, int first, int end)
{
    const bool idle = op == OP_FIX && mpm_does(mpm, WRONG_NO_FIRST_FIX);
    const bool late = op == OP_FIX && mpm_does(mpm, WRONG_START_LATE);
    for (int i = first; op == OP_FIX && i < end; i++)
        mpm->lost[i] = 0.0;
    for (int field = 0; field < mpm->n_fields; field++)
        for (int i = first; i < end; i++) {
            const int node = field * mpm->grid_nodes + i;
            const double mass = mpm->node_mass[node];
            if (op == OP_FIX) {
                mpm->touched[node] = 0;
                mpm->inverse[node] = mass > mpm->floor ? 1.0 / mass : 0.0;
                for (int axis = 0; axis < 2; axis++)
                    mpm->start[axis][node] = mpm->momentum[axis][node];
            }
            if (idle || !(mass > mpm->floor))
                continue;
            const int at[2] = {i % mpm->gx - BODIES_PADDING, i / mpm->gx - BODIES_PADDING};
            double lost = 0.0;
            for (int wall = 0; wall < WALLS; wall++) {
                const int axis = wall / 2, edge = wall % 2 ? mpm->box[axis] : 0;
                const BodyWall kind = mpm->def.walls[wall];
                if (kind == WALL_OPEN || !(wall % 2 ? at[axis] >= edge : at[axis] <= edge))
                    continue;
                const double more = hold(mpm, node, wall, edge);
                /* in a corner a clamp takes what friction took before it */
                lost = kind == WALL_CLAMP ? 0.0 : lost + more;
            }
            mpm->lost[i] += lost;
        }
    for (int i = first; mpm->n_fields > 1 && !idle && i < end; i++)
        touch(mpm, i);
    for (int field = 0; field < mpm->n_fields; field++)
        for (int axis = 0; axis < 2; axis++)
            for (int i = field * mpm->grid_nodes + first; i < field * mpm->grid_nodes + end; i++) {
                const double q = mpm->momentum[axis][i], v = q * mpm->inverse[i];
                if (op != OP_FIX_MOVED || mpm->head->algorithm != MPM_USF)
                    mpm->velocity[axis][i] = v;
                if (late)
                    mpm->start[axis][i] = q;
                if (op != OP_FIX_MOVED)
                    continue;
                mpm->carry[axis][i] = v;
                mpm->kick[axis][i] = (q - mpm->start[axis][i]) * mpm->inverse[i];
            }
}

static void report_push(Mpm *mpm, int field, int other, EventKind kind)
{
    const bool touches = kind == EVENT_TOUCH, is_wall = other >= BODIES_MAX;
    char text[120], where[48] = "", wall[24];
    if (is_wall)
        snprintf(wall, sizeof wall, "the %s wall", bodies_walls[other - BODIES_MAX]);
    if (touches) {
        /* in the middle of the nodes at which it pushes */
        const uint32_t *const touched = mpm->touched + field * mpm->grid_nodes;
        double x = 0.0, y = 0.0, count = 0.0;
        for (int i = 0; i < mpm->grid_nodes; i++)
            if (touched[i] >> other & 1) {
                x += mpm->xmin + i % mpm->gx * mpm->dx;
                y += mpm->ymin + i / mpm->gx * mpm->dx;
                count++;
            }
        snprintf(where, sizeof where, " at (%.3g, %.3g)", x / count, y / count);
    }
    snprintf(text, sizeof text, "%s %s %s%s",
             mpm->n_fields > 1 || mpm->def.n_bodies == 1 ? mpm->def.bodies[field].name : "a body",
             touches ? "touches" : "leaves", is_wall ? wall : mpm->def.bodies[other].name, where);
    batch_report(&mpm->sim, kind, text);
}

/* What both `fix` of a step did to particles; MUSL's third one is for the strain alone. What a field pushes
 * for the first time is reported, and what it first pushes no more. */
void bodies_note_contact(Mpm *mpm)
{
    MpmHead *head = mpm->head;
    double sum = 0.0;
    for (int i = 0; i < mpm->grid_nodes; i++)
        sum += mpm->lost[i];
    head->friction += sum;
    const bool pushed = bodies_push(head), had_met = head->met > 0;
    for (int field = 0; field < mpm->n_fields; field++) {
        uint32_t now = 0;
        for (int i = 0; i < mpm->grid_nodes; i++)
            now |= mpm->touched[field * mpm->grid_nodes + i];
        const uint32_t first = now & ~head->met_by[field],
                       ended = head->met_by[field] & ~now & ~head->parted_from[field];
        for (int other = 0; (first | ended) && other < BODIES_MAX + WALLS; other++)
            if (first >> other & 1) {
                long *const met = other < BODIES_MAX ? &head->met : &head->hit;
                *met = *met > 0 ? *met : mpm->sim.step + 1;
                report_push(mpm, field, other, EVENT_TOUCH);
            } else if (ended >> other & 1)
                report_push(mpm, field, other, EVENT_PART);
        head->touching[field] = now;
        head->met_by[field] |= first;
        head->parted_from[field] |= ended;
    }
    if (mpm->n_fields == 2 && pushed != bodies_push(head)) {
        double row[BODIES_X + 2 * BODY_COLUMNS];
        mpm_row_of_bodies(&mpm->sim, row);
        if (pushed)
            head->parting = -bodies_closing(row);
        else if (!had_met)
            head->meeting = bodies_closing(row);
    }
}

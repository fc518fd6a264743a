/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines, groups, tips, branches and paths of the cracks of a plate (front_shape.h, fronts.h). */
#include "methods/bonds/cracks/front_shape.h"

#include "base/math/functions.h"
#include "methods/bonds/cracks/crack.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- lines ----------------------------------------------------------------------------------- */

static int front_lines(const Beam *beam, int axis)
{
    return axis == 0 ? beam->lattice.nx : beam->lattice.ny;
}

double front_place(const Beam *beam, int axis, int line)
{
    return axis == 0 ? lattice_x(&beam->lattice, line) : lattice_y(&beam->lattice, line);
}

static size_t front_node(const Beam *beam, int axis, int line, int across)
{
    return axis == 0 ? lattice_node(&beam->lattice, line, across)
                     : lattice_node(&beam->lattice, across, line);
}

int front_line_of(const Beam *beam, int axis, size_t node)
{
    return (axis == 0 ? lattice_column : lattice_row)(&beam->lattice, node);
}

/* The first line beyond a front's end, in its direction; and whether the plate has a line. */
static int front_first_line(const Beam *beam, const CrackFront *front)
{
    const double spacing = beam->lattice.spacing,
                 at = (front->end[front->axis] - front_place(beam, front->axis, 0)) / spacing;
    return front->sign > 0 ? (int)floor(at + 1e-6) + 1 : (int)ceil(at - 1e-6) - 1;
}

static bool front_has_line(const Beam *beam, const CrackFront *front, int line)
{
    return line >= 0 && line < front_lines(beam, front->axis);
}

int front_groups(const Growth *growth, int front, int line, Group groups[FRONT_GROUPS_MAX])
{
    const Beam *beam = growth->beam;
    const int axis = growth->fronts->fronts[front].axis;
    const int across = front_lines(beam, 1 - axis);
    int count = 0;
    double sum = 0, weights = 0;
    for (int k = 0, inside = 0; k <= across; k++) {
        const size_t node = k < across ? front_node(beam, axis, line, k) : 0;
        const bool is = k < across && growth->cracked[node] && growth->front_of[node] == front;
        if (is && !inside) {
            if (count == FRONT_GROUPS_MAX)
                break;
            groups[count] = (Group){.low = k};
            sum = weights = 0;
        }
        if (is) {
            sum += beam->damage[node] * front_place(beam, 1 - axis, k);
            weights += beam->damage[node];
        } else if (inside) {
            groups[count].high = k - 1;
            groups[count++].centre = sum / weights;
        }
        inside = is;
    }
    return count;
}

/* --- as it is now ---------------------------------------------------------------------------- */

static bool touch(const Group *a, const Group *b)
{
    return a->low <= b->high + 1 && b->low <= a->high + 1;
}

/* From line to line: a group that touches none of the next line is a tip, when it has come far enough by
 * itself or nothing has come farther. */
void front_find_tips(const Growth *growth, int f)
{
    const Beam *beam = growth->beam;
    CrackFront *front = &growth->fronts->fronts[f];
    Group before[FRONT_GROUPS_MAX], now[FRONT_GROUPS_MAX];
    int n_before = 0;
    const int long_enough = (int)ceil(2 * beam->def.horizon / beam->lattice.spacing);
    for (int line = front_first_line(beam, front), left = 1; left; line += front->sign) {
        left = front_has_line(beam, front, line);
        const int n = left ? front_groups(growth, f, line, now) : 0;
        for (int a = 0; a < n_before; a++)
            for (int b = 0; b < n; b++)
                before[a].successors += touch(&before[a], &now[b]);
        for (int a = 0; a < n_before; a++) {
            const double at = front_place(beam, front->axis, line - front->sign);
            const bool farthest =
                fabs(at - front->end[front->axis]) > front->advance - beam->lattice.spacing / 2;
            if (before[a].successors == 0 && (farthest || before[a].behind > long_enough) &&
                front->n_tips < CRACK_TIPS_MAX) {
                double *tip = front->tips[front->n_tips++];
                tip[front->axis] = at;
                tip[1 - front->axis] = before[a].centre;
            }
        }
        for (int b = 0; b < n; b++)
            for (int a = 0; a < n_before; a++)
                if (touch(&before[a], &now[b]) && before[a].successors == 1 &&
                    before[a].behind >= now[b].behind)
                    now[b].behind = before[a].behind + 1;
        memcpy(before, now, sizeof now);
        n_before = n;
    }
}

bool front_find_lines(const Growth *growth, int f)
{
    const Beam *beam = growth->beam;
    CrackFront *front = &growth->fronts->fronts[f];
    front->away = malloc(2 * ((size_t)growth->lines + 1) * sizeof *front->away);
    if (!front->away)
        return false;
    front->centre = front->away + growth->lines + 1;
    for (int line = front_first_line(beam, front); front_has_line(beam, front, line); line += front->sign) {
        double sum = 0, weights = 0;
        for (int k = 0; k < front_lines(beam, 1 - front->axis); k++) {
            const size_t node = front_node(beam, front->axis, line, k);
            if (growth->front_of[node] != f)
                continue;
            sum += beam->damage[node] * front_place(beam, 1 - front->axis, k);
            weights += beam->damage[node];
        }
        if (weights == 0)
            continue;
        front->away[front->n_lines] = fabs(front_place(beam, front->axis, line) - front->end[front->axis]);
        front->centre[front->n_lines++] = sum / weights;
    }
    return true;
}

double crack_fronts_angle(const CrackFront *front, double reach)
{
    const double one =
                     front->branched ? fabs(front->branch[front->axis] - front->end[front->axis]) : INFINITY,
                 last = fmin(front->beside + reach, one);
    FittedLine fit = {0};
    for (size_t k = 0; k < front->n_lines; k++)
        if (front->away[k] >= front->beside * (1 - 1e-9) && front->away[k] <= last * (1 + 1e-9))
            line_add(&fit, front->sign * front->away[k], front->centre[k]);
    const double slope = line_slope(&fit);
    if (isnan(slope))
        return NAN;
    double way[2];
    way[front->axis] = front->sign;
    way[1 - front->axis] = front->sign * slope;
    const double cosine = (way[0] * front->along[0] + way[1] * front->along[1]) / math_hypot(1, slope);
    return math_acos(fmin(1, fmax(-1, cosine))) * 180 / M_PI;
}

/* --- branches -------------------------------------------------------------------------------- */

/* Half the angle between the outermost groups of the lines from the branch on, the first one among them, over
 * a quarter of what the plate measures across the front. */
static double half_angle(const Growth *growth, int f, int from)
{
    const Beam *beam = growth->beam;
    const CrackFront *front = &growth->fronts->fronts[f];
    Group groups[FRONT_GROUPS_MAX];
    FittedLine low = {0}, high = {0};
    const int lines = front_lines(beam, 1 - front->axis) / 4;
    for (int k = 0; k < lines; k++) {
        const int line = from + k * front->sign;
        const int n = front_has_line(beam, front, line) ? front_groups(growth, f, line, groups) : 0;
        if (n == 0)
            return NAN;
        if (n < 2)
            continue;
        line_add(&low, k * beam->lattice.spacing, groups[0].centre);
        line_add(&high, k * beam->lattice.spacing, groups[n - 1].centre);
    }
    const double angle = (math_atan(line_slope(&high)) - math_atan(line_slope(&low))) / 2 * 180 / M_PI;
    return angle > 0 ? angle : NAN; /* branches that meet again have none */
}

void front_find_branch(const Growth *growth, int f)
{
    const Beam *beam = growth->beam;
    CrackFront *front = &growth->fronts->fronts[f];
    const int32_t *split = growth->split + (size_t)f * (size_t)growth->lines;
    Group groups[FRONT_GROUPS_MAX];
    const int wanted = (int)lround(beam->def.horizon / beam->lattice.spacing);
    int in_row = 0;
    for (int line = front_first_line(beam, front); front_has_line(beam, front, line); line += front->sign) {
        const int n = front_groups(growth, f, line, groups);
        const double away = fabs(front_place(beam, front->axis, line) - front->end[front->axis]);
        /* near the end of the cut itself single nodes beside it are cracked too */
        in_row = n > 1 && split[line] >= 0 && away > beam->def.horizon ? in_row + 1 : 0;
        if (in_row < wanted)
            continue;
        const int first = line - (wanted - 1) * front->sign;
        const int32_t later = split[first] > split[line] ? split[first] : split[line];
        const int n_first = front_groups(growth, f, first, groups);
        front->branched = true;
        front->branch[front->axis] = front_place(beam, front->axis, first);
        front->branch[1 - front->axis] = (groups[0].centre + groups[n_first - 1].centre) / 2;
        front->branch_time = later * beam->sim.dt;
        front->half_angle = half_angle(growth, f, first);
        return;
    }
}

/* Goes along the lines from `from` on with the lowest group, the highest one, or the middle of all, and puts
 * down a place for each horizon, and the last. */
enum { LOWEST, HIGHEST, MIDDLE };

static bool add_path(const Growth *growth, int f, const double start[2], int from, int until, int which)
{
    const Beam *beam = growth->beam;
    CrackFront *front = &growth->fronts->fronts[f];
    CrackPath *path = &front->paths[front->n_paths];
    Group groups[FRONT_GROUPS_MAX];
    const int step = (int)lround(beam->def.horizon / beam->lattice.spacing);
    path->x = malloc(2 * ((size_t)growth->lines + 1) * sizeof *path->x);
    if (!path->x)
        return false;
    path->y = path->x + growth->lines + 1;
    front->n_paths++;
    path->count = 1;
    path->x[0] = start[0], path->y[0] = start[1];
    double place[2] = {start[0], start[1]};
    int since = 0;
    for (int line = from; line != until && front_has_line(beam, front, line); line += front->sign) {
        const int n = front_groups(growth, f, line, groups);
        since++;
        if (n == 0)
            continue;
        place[front->axis] = front_place(beam, front->axis, line);
        place[1 - front->axis] = which == LOWEST    ? groups[0].centre
                                 : which == HIGHEST ? groups[n - 1].centre
                                                    : (groups[0].centre + groups[n - 1].centre) / 2;
        if (since < step)
            continue;
        path->x[path->count] = place[0], path->y[path->count++] = place[1];
        since = 0;
    }
    if (place[0] != path->x[path->count - 1] || place[1] != path->y[path->count - 1])
        path->x[path->count] = place[0], path->y[path->count++] = place[1];
    return true;
}

bool front_find_paths(const Growth *growth, int f)
{
    const Beam *beam = growth->beam;
    const CrackFront *front = &growth->fronts->fronts[f];
    const int first = front_first_line(beam, front), none = -2;
    if (!front->branched)
        return add_path(growth, f, front->end, first, none, MIDDLE);
    const int fork =
        (int)lround((front->branch[front->axis] - front_place(beam, front->axis, 0)) / beam->lattice.spacing);
    return add_path(growth, f, front->end, first, fork + front->sign, MIDDLE) &&
           add_path(growth, f, front->branch, fork + front->sign, none, LOWEST) &&
           add_path(growth, f, front->branch, fork + front->sign, none, HIGHEST);
}

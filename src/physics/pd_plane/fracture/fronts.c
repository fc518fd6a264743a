/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cracks of a plate (fronts.h). First the cracked nodes as they are now are dealt out to the ends of the
 * cuts; then the run's broken bonds are gone through in the order in which they broke, and each node cracks
 * once more, for the advance over time and the steps at which lines split. Called after whole steps by
 * whoever shows or tabulates the cracks; nothing here changes the motion. */
#include "physics/pd_plane/fracture/fronts.h"

#include "physics/pd_plane/beam_internal.h"
#include "physics/pd_plane/fracture/crack.h"
#include "physics/pd_plane/fracture/crack_speed.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NO_FRONT = 255, GROUPS_MAX = 32, OF_CUT = -1 };
#define BESIDE_CUT   0.002 /* m; the angle of a front is measured from here */
#define BRANCH_REACH 0.01  /* m; the angle of branches is measured over so much */

/* A bond that broke in the run. */
typedef struct Break {
    int32_t step;
    uint32_t nodes[2];
    double weight;
} Break;

/* A front while it is worked out. */
typedef struct Growth {
    const Beam *beam;
    CrackFronts *fronts;
    uint8_t *front_of;    /* per node: index, NO_FRONT: not cracked now, or of none */
    uint8_t *cracked;     /* per node, at the step that the second pass has come to */
    double *all, *broken; /* per node: weights of its family, and of its broken bonds; all 0: not looked up */
    Break *breaks;
    size_t n_breaks, n_of_cuts; /* those of the cuts come first */
    int32_t *split; /* per front and line: the first step looked at in which it was split; -1: never */
    int lines;      /* as many as the larger of columns and rows */
} Growth;

/* --- lines ----------------------------------------------------------------------------------- */

static double place_on(const Beam *beam, int axis, int line)
{
    return axis == 0 ? lattice_x(&beam->lattice, line) : lattice_y(&beam->lattice, line);
}

static int lines_of(const Beam *beam, int axis)
{
    return axis == 0 ? beam->lattice.nx : beam->lattice.ny;
}

static size_t node_on(const Beam *beam, int axis, int line, int across)
{
    const size_t nx = (size_t)beam->lattice.nx;
    return axis == 0 ? (size_t)across * nx + (size_t)line : (size_t)line * nx + (size_t)across;
}

static int line_of(const Beam *beam, int axis, size_t node)
{
    const size_t nx = (size_t)beam->lattice.nx;
    return (int)(axis == 0 ? node % nx : node / nx);
}

/* The first line beyond a front's end, and where the lines end, in its direction. */
static int first_line(const Beam *beam, const CrackFront *front)
{
    const double spacing = beam->lattice.spacing,
                 at = (front->end[front->axis] - place_on(beam, front->axis, 0)) / spacing;
    return front->sign > 0 ? (int)floor(at + 1e-6) + 1 : (int)ceil(at - 1e-6) - 1;
}

static bool has_line(const Beam *beam, const CrackFront *front, int line)
{
    return line >= 0 && line < lines_of(beam, front->axis);
}

/* A group of neighbouring cracked nodes of a line. */
typedef struct Group {
    int low, high;  /* across */
    double centre;  /* sum phi x / sum phi */
    int behind;     /* lines back to where it split off, or to the front's end */
    int successors; /* groups of the next line that touch it */
} Group;

/* At most GROUPS_MAX of them, in order. */
static int groups_of(const Beam *beam, const uint8_t *cracked, const uint8_t *front_of, int front, int axis,
                     int line, Group groups[GROUPS_MAX])
{
    const int across = lines_of(beam, 1 - axis);
    int count = 0;
    double sum = 0, weights = 0;
    for (int k = 0, inside = 0; k <= across; k++) {
        const size_t node = k < across ? node_on(beam, axis, line, k) : 0;
        const bool is = k < across && cracked[node] && front_of[node] == front;
        if (is && !inside) {
            if (count == GROUPS_MAX)
                break;
            groups[count] = (Group){.low = k};
            sum = weights = 0;
        }
        if (is) {
            sum += beam->damage[node] * place_on(beam, 1 - axis, k);
            weights += beam->damage[node];
        } else if (inside) {
            groups[count].high = k - 1;
            groups[count++].centre = sum / weights;
        }
        inside = is;
    }
    return count;
}

/* --- whose node it is ------------------------------------------------------------------------ */

static bool is_inside(const Beam *beam, const double place[2])
{
    const double spacing = beam->lattice.spacing;
    return place[0] > spacing && place[0] < beam->def.length - spacing && place[1] > spacing &&
           place[1] < beam->def.height - spacing;
}

static void add_end(CrackFronts *fronts, const Beam *beam, const PlateCut *cut, const double from[2],
                    const double to[2])
{
    const double x = to[0] - from[0], y = to[1] - from[1], length = hypot(x, y);
    if (!is_inside(beam, to) || fronts->count == CRACK_FRONTS_MAX)
        return;
    CrackFront *front = &fronts->fronts[fronts->count++];
    *front = (CrackFront){.end = {to[0], to[1]},
                          .along = {x / length, y / length},
                          .first = NAN,
                          .branch_time = NAN,
                          .half_angle = NAN,
                          .angle = NAN,
                          .fastest = NAN,
                          .fastest_at = NAN};
    memcpy(front->cut, cut->name, sizeof front->cut);
    front->axis = fabs(x) >= fabs(y) ? 0 : 1;
    front->sign = front->along[front->axis] > 0 ? 1 : -1;
}

/* Beyond the end, or so far to a side that the cut itself damaged no bond of it. */
static bool is_beyond(const Beam *beam, const CrackFront *front, double x, double y)
{
    const double along = x * front->along[0] + y * front->along[1],
                 aside = fabs(x * front->along[1] - y * front->along[0]);
    return along > 1e-6 * beam->lattice.spacing || aside > beam->def.horizon;
}

static int nearest_front(const CrackFronts *fronts, const Beam *beam, double x, double y)
{
    int nearest = NO_FRONT;
    double least = INFINITY;
    for (int f = 0; f < fronts->count; f++) {
        const double *end = fronts->fronts[f].end, distance = hypot(x - end[0], y - end[1]);
        if (distance < least)
            least = distance, nearest = f;
    }
    if (nearest == NO_FRONT)
        return NO_FRONT;
    const CrackFront *front = &fronts->fronts[nearest];
    return is_beyond(beam, front, x - front->end[0], y - front->end[1]) ? nearest : NO_FRONT;
}

/* Deals the cracked nodes out, and turns each front to the axis along which it has come farther. */
static void deal(Growth *growth)
{
    const Beam *beam = growth->beam;
    const size_t nx = (size_t)beam->lattice.nx;
    double least[CRACK_FRONTS_MAX][2] = {{0}}, most[CRACK_FRONTS_MAX][2] = {{0}};
    for (size_t node = 0; node < lattice_nodes(&beam->lattice); node++) {
        growth->front_of[node] = NO_FRONT;
        /* what a cut alone has damaged so much is no crack */
        const bool of_cut = growth->all[node] > 0 && growth->broken[node] > CRACK_DAMAGE * growth->all[node];
        if (beam->damage[node] <= CRACK_DAMAGE || beam->unbreakable[node] || of_cut)
            continue;
        const double place[2] = {lattice_x(&beam->lattice, (int)(node % nx)),
                                 lattice_y(&beam->lattice, (int)(node / nx))};
        const int f = nearest_front(growth->fronts, beam, place[0], place[1]);
        growth->front_of[node] = (uint8_t)f;
        for (int d = 0; f != NO_FRONT && d < 2; d++) {
            least[f][d] = fmin(least[f][d], place[d] - growth->fronts->fronts[f].end[d]);
            most[f][d] = fmax(most[f][d], place[d] - growth->fronts->fronts[f].end[d]);
        }
    }
    for (int f = 0; f < growth->fronts->count; f++) {
        CrackFront *front = &growth->fronts->fronts[f];
        const int own = front->axis;
        const double reach[2] = {fmax(-least[f][0], most[f][0]), fmax(-least[f][1], most[f][1])};
        if (reach[1 - own] > reach[own]) {
            front->axis = 1 - own;
            front->sign = most[f][1 - own] >= -least[f][1 - own] ? 1 : -1;
        }
    }
}

/* --- as it is now ---------------------------------------------------------------------------- */

static void add_tip(const Beam *beam, CrackFront *front, int line, const Group *group)
{
    if (front->n_tips == CRACK_TIPS_MAX)
        return;
    double *tip = front->tips[front->n_tips++];
    tip[front->axis] = place_on(beam, front->axis, line);
    tip[1 - front->axis] = group->centre;
}

static bool touch(const Group *a, const Group *b)
{
    return a->low <= b->high + 1 && b->low <= a->high + 1;
}

/* From line to line: a group that touches none of the next line is a tip, when it has come far enough by
 * itself or nothing has come farther. */
static void find_tips(const Growth *growth, int f)
{
    const Beam *beam = growth->beam;
    CrackFront *front = &growth->fronts->fronts[f];
    Group before[GROUPS_MAX], now[GROUPS_MAX];
    int n_before = 0;
    const int long_enough = (int)ceil(2 * beam->def.horizon / beam->lattice.spacing);
    for (int line = first_line(beam, front), left = 1; left; line += front->sign) {
        left = has_line(beam, front, line);
        const int n =
            left ? groups_of(beam, growth->cracked, growth->front_of, f, front->axis, line, now) : 0;
        for (int a = 0; a < n_before; a++)
            for (int b = 0; b < n; b++)
                before[a].successors += touch(&before[a], &now[b]);
        for (int a = 0; a < n_before; a++) {
            const double at = fabs(place_on(beam, front->axis, line - front->sign) - front->end[front->axis]);
            const bool farthest = at > front->advance - beam->lattice.spacing / 2;
            if (before[a].successors == 0 && (farthest || before[a].behind > long_enough))
                add_tip(beam, front, line - front->sign, &before[a]);
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

/* y = a + b x by least squares, gathered pair by pair. */
typedef struct Line {
    double n, x, y, xx, xy;
} Line;

static void line_add(Line *line, double x, double y)
{
    line->n += 1, line->x += x, line->y += y, line->xx += x * x, line->xy += x * y;
}

static double line_slope(const Line *line)
{
    return line->n < 2 ? NAN
                       : (line->n * line->xy - line->x * line->y) / (line->n * line->xx - line->x * line->x);
}

/* The damage-weighted centre of all groups of a line. False: none. */
static bool line_centre(const Beam *beam, const CrackFront *front, int line, double *centre)
{
    double sum = 0, weights = 0;
    for (int k = 0; k < lines_of(beam, 1 - front->axis); k++) {
        const size_t node = node_on(beam, front->axis, line, k);
        const double damage = beam->damage[node];
        const double across = place_on(beam, 1 - front->axis, k);
        double from[2];
        from[front->axis] = place_on(beam, front->axis, line) - front->end[front->axis];
        from[1 - front->axis] = across - front->end[1 - front->axis];
        if (damage <= CRACK_DAMAGE || beam->unbreakable[node] || !is_beyond(beam, front, from[0], from[1]))
            continue;
        sum += damage * across;
        weights += damage;
    }
    *centre = weights > 0 ? sum / weights : NAN;
    return weights > 0;
}

double crack_fronts_angle(const Simulation *sim, const CrackFront *front, double reach)
{
    const Beam *beam = (const Beam *)sim;
    const double tolerance = 1e-6 * beam->lattice.spacing;
    Line fit = {0};
    for (int line = first_line(beam, front); has_line(beam, front, line); line += front->sign) {
        const double away = fabs(place_on(beam, front->axis, line) - front->end[front->axis]);
        double centre;
        if (away < BESIDE_CUT - tolerance || away > BESIDE_CUT + reach + tolerance ||
            !line_centre(beam, front, line, &centre))
            continue;
        line_add(&fit, front->sign * away, centre);
    }
    const double slope = line_slope(&fit);
    double way[2];
    way[front->axis] = front->sign;
    way[1 - front->axis] = front->sign * slope;
    const double cosine = (way[0] * front->along[0] + way[1] * front->along[1]) / hypot(1, slope);
    return acos(fmin(1, fmax(-1, cosine))) * 180 / M_PI;
}

/* --- once more through the run --------------------------------------------------------------- */

static int earlier(const void *a, const void *b)
{
    const Break *one = a, *other = b;
    return (one->step > other->step) - (one->step < other->step);
}

static double weight_of_family(const Beam *beam, size_t node)
{
    const size_t nx = (size_t)beam->lattice.nx;
    BondPlace family[FAMILY_MAX];
    const size_t n = beam_family(beam, (int)(node % nx), (int)(node / nx), family);
    double all = 0;
    for (size_t k = 0; k < n; k++)
        all += beam->lattice.offsets[family[k].offset].weight;
    return all;
}

/* One bond of a node is gone; returns the share of its family that is. */
static double weaken(Growth *growth, size_t node, double weight)
{
    if (growth->all[node] == 0)
        growth->all[node] = weight_of_family(growth->beam, node);
    growth->broken[node] += weight;
    return growth->broken[node] / growth->all[node];
}

/* Each bond that broke up to the state's step, and the weights of the nodes at its ends; the cuts' bonds
 * count in the damage from the start. */
static bool gather(Growth *growth)
{
    const Beam *beam = growth->beam;
    const Lattice *lattice = &beam->lattice;
    const size_t nx = (size_t)lattice->nx;
    size_t room = 0;
    for (size_t byte = 0; byte < lattice_slots(lattice) / 8; byte++)
        for (size_t bit = 0; beam->broken[byte] >> bit != 0; bit++) {
            if (!(beam->broken[byte] >> bit & 1))
                continue;
            const size_t slot = 8 * byte + bit;
            const BondPlace place = lattice_slot_place(lattice, slot);
            const Offset *offset = &lattice->offsets[place.offset];
            const bool of_cut = beam->notched[byte] >> bit & 1;
            if (growth->n_breaks == room) {
                room = room ? 2 * room : 1024;
                Break *more = realloc(growth->breaks, room * sizeof *more);
                if (!more)
                    return false;
                growth->breaks = more;
            }
            if (!of_cut && beam->broken_at[slot] > beam->sim.step)
                continue; /* in the step that has begun */
            growth->breaks[growth->n_breaks++] = (Break){
                .step = of_cut ? OF_CUT : beam->broken_at[slot],
                .nodes = {(uint32_t)((size_t)place.j * nx + (size_t)place.i),
                          (uint32_t)((size_t)(place.j + offset->q) * nx + (size_t)(place.i + offset->p))},
                .weight = offset->weight};
        }
    qsort(growth->breaks, growth->n_breaks, sizeof *growth->breaks, earlier);
    for (; growth->n_of_cuts < growth->n_breaks && growth->breaks[growth->n_of_cuts].step == OF_CUT;
         growth->n_of_cuts++)
        for (int end = 0; end < 2; end++)
            weaken(growth, growth->breaks[growth->n_of_cuts].nodes[end],
                   growth->breaks[growth->n_of_cuts].weight);
    return true;
}

/* One bond of a node is gone in the run: it may have cracked. */
static void take_break(Growth *growth, size_t node, const Break *gone)
{
    const Beam *beam = growth->beam;
    if (weaken(growth, node, gone->weight) <= CRACK_DAMAGE || growth->cracked[node] ||
        growth->front_of[node] == NO_FRONT)
        return;
    growth->cracked[node] = 1;
    CrackFront *front = &growth->fronts->fronts[growth->front_of[node]];
    const double advance = front->sign * (place_on(beam, front->axis, line_of(beam, front->axis, node)) -
                                          front->end[front->axis]);
    if (advance <= 0)
        return;
    if (!front->begun)
        front->first = gone->step * beam->sim.dt;
    front->begun = true;
    front->advance = fmax(front->advance, advance);
}

static void look_for_splits(Growth *growth, int32_t step)
{
    const Beam *beam = growth->beam;
    Group groups[GROUPS_MAX];
    for (int f = 0; f < growth->fronts->count; f++) {
        const CrackFront *front = &growth->fronts->fronts[f];
        int32_t *split = growth->split + (size_t)f * (size_t)growth->lines;
        for (int line = first_line(beam, front);
             has_line(beam, front, line) &&
             fabs(place_on(beam, front->axis, line) - front->end[front->axis]) <
                 front->advance + beam->lattice.spacing / 2;
             line += front->sign)
            if (split[line] < 0 &&
                groups_of(beam, growth->cracked, growth->front_of, f, front->axis, line, groups) > 1)
                split[line] = step;
    }
}

static void go_through(Growth *growth)
{
    const Beam *beam = growth->beam;
    CrackFronts *fronts = growth->fronts;
    const long last = beam->sim.step, every = lround(fronts->every / beam->sim.dt);
    size_t next = growth->n_of_cuts;
    for (long step = 0; step <= last; step++) {
        const size_t before = next;
        for (; next < growth->n_breaks && growth->breaks[next].step <= step; next++)
            for (int end = 0; end < 2; end++)
                take_break(growth, growth->breaks[next].nodes[end], &growth->breaks[next]);
        if (step % CRACK_FRONT_LOOK == 0 && (next > before || step > 0))
            look_for_splits(growth, (int32_t)step);
        for (int f = 0; step % every == 0 && f < fronts->count; f++)
            fronts->fronts[f].advances[step / every] = fronts->fronts[f].advance;
    }
}

/* --- branches -------------------------------------------------------------------------------- */

/* Half the angle between the outermost groups of the lines over BRANCH_REACH from the branch on. */
static double half_angle(const Growth *growth, int f, int from)
{
    const Beam *beam = growth->beam;
    const CrackFront *front = &growth->fronts->fronts[f];
    Group groups[GROUPS_MAX];
    Line low = {0}, high = {0};
    const int lines = (int)lround(BRANCH_REACH / beam->lattice.spacing);
    for (int k = 0; k <= lines; k++) {
        const int line = from + k * front->sign;
        const int n = has_line(beam, front, line)
                          ? groups_of(beam, growth->cracked, growth->front_of, f, front->axis, line, groups)
                          : 0;
        if (n == 0)
            return NAN;
        if (n < 2)
            continue;
        line_add(&low, k * beam->lattice.spacing, groups[0].centre);
        line_add(&high, k * beam->lattice.spacing, groups[n - 1].centre);
    }
    return (atan(line_slope(&high)) - atan(line_slope(&low))) / 2 * 180 / M_PI;
}

static void find_branch(const Growth *growth, int f)
{
    const Beam *beam = growth->beam;
    CrackFront *front = &growth->fronts->fronts[f];
    const int32_t *split = growth->split + (size_t)f * (size_t)growth->lines;
    Group groups[GROUPS_MAX];
    const int wanted = (int)lround(beam->def.horizon / beam->lattice.spacing);
    int in_row = 0;
    for (int line = first_line(beam, front); has_line(beam, front, line); line += front->sign) {
        const int n = groups_of(beam, growth->cracked, growth->front_of, f, front->axis, line, groups);
        const double away = fabs(place_on(beam, front->axis, line) - front->end[front->axis]);
        /* near the end of the cut itself single nodes beside it are cracked too */
        in_row = n > 1 && split[line] >= 0 && away > beam->def.horizon ? in_row + 1 : 0;
        if (in_row < wanted)
            continue;
        const int first = line - (wanted - 1) * front->sign;
        const int32_t later = split[first] > split[line] ? split[first] : split[line];
        const int n_first = groups_of(beam, growth->cracked, growth->front_of, f, front->axis, first, groups);
        front->branched = true;
        front->branch[front->axis] = place_on(beam, front->axis, first);
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
    Group groups[GROUPS_MAX];
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
    for (int line = from; line != until && has_line(beam, front, line); line += front->sign) {
        const int n = groups_of(beam, growth->cracked, growth->front_of, f, front->axis, line, groups);
        since++;
        if (n == 0)
            continue;
        place[front->axis] = place_on(beam, front->axis, line);
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

static bool find_paths(const Growth *growth, int f)
{
    const Beam *beam = growth->beam;
    const CrackFront *front = &growth->fronts->fronts[f];
    const int first = first_line(beam, front), none = -2;
    if (!front->branched)
        return add_path(growth, f, front->end, first, none, MIDDLE);
    const int fork =
        (int)lround((front->branch[front->axis] - place_on(beam, front->axis, 0)) / beam->lattice.spacing);
    return add_path(growth, f, front->end, first, fork + front->sign, MIDDLE) &&
           add_path(growth, f, front->branch, fork + front->sign, none, LOWEST) &&
           add_path(growth, f, front->branch, fork + front->sign, none, HIGHEST);
}

static double path_length(const CrackPath *path)
{
    double length = 0;
    for (size_t k = 1; k < path->count; k++)
        length += hypot(path->x[k] - path->x[k - 1], path->y[k] - path->y[k - 1]);
    return length;
}

/* --- all together ---------------------------------------------------------------------------- */

double crack_fronts_speed(const CrackFronts *fronts, const CrackFront *front, size_t sample)
{
    const size_t half = fronts->window / 2;
    if (sample < half || sample + half >= fronts->n_samples)
        return NAN;
    double across[CRACK_FRONT_WINDOW_MAX] = {0};
    return crack_speed(front->advances + (sample - half), across, 2 * half + 1, fronts->every);
}

static void find_fastest(const CrackFronts *fronts, CrackFront *front)
{
    for (size_t k = 0; front->begun && k < fronts->n_samples; k++) {
        const double speed = crack_fronts_speed(fronts, front, k);
        if (isfinite(speed) && !(speed <= front->fastest)) {
            front->fastest = speed;
            front->fastest_at = (double)k * fronts->every;
        }
    }
}

static double length_of_cuts(const Beam *beam)
{
    double length = 0;
    for (int i = 0; i < beam->def.plate.n_cuts; i++) {
        const PlateCut *cut = &beam->def.plate.cuts[i];
        length += hypot(cut->x1 - cut->x0, cut->y1 - cut->y0);
    }
    return length;
}

/* Times at which the advance is kept: as many as fit into the window of a speed, at most one a step. */
static bool plan_samples(CrackFronts *fronts, const Beam *beam)
{
    const double dt = beam->sim.dt;
    const double window = crack_speed_window(beam->def.horizon, beam->def.youngs_modulus, beam->def.density);
    const long every = (long)fmax(1, ceil(window / dt / (CRACK_FRONT_WINDOW_MAX - 2)));
    fronts->every = (double)every * dt;
    fronts->window = 2 * (size_t)fmax(1, round(window / fronts->every / 2)) + 1;
    fronts->n_samples = (size_t)(beam->sim.step / every) + 1;
    for (int f = 0; f < fronts->count; f++)
        if (!(fronts->fronts[f].advances = calloc(fronts->n_samples, sizeof(double))))
            return false;
    return true;
}

static bool work_out(Growth *growth)
{
    const Beam *beam = growth->beam;
    CrackFronts *fronts = growth->fronts;
    if (!plan_samples(fronts, beam) || !gather(growth))
        return false;
    deal(growth);
    memset(growth->split, -1, (size_t)fronts->count * (size_t)growth->lines * sizeof *growth->split);
    go_through(growth);
    for (int f = 0; f < fronts->count; f++) {
        CrackFront *front = &fronts->fronts[f];
        find_tips(growth, f);
        find_branch(growth, f);
        find_fastest(fronts, front);
        const double reach = front->branched
                                 ? fabs(front->branch[front->axis] - front->end[front->axis]) - BESIDE_CUT
                                 : INFINITY;
        front->angle = crack_fronts_angle(&beam->sim, front, reach);
        if (!find_paths(growth, f))
            return false;
        for (int k = 0; k < front->n_paths; k++)
            fronts->length += path_length(&front->paths[k]);
    }
    fronts->surface = beam->facts.notch_bonds > 0 ? (double)beam->head->broken * length_of_cuts(beam) /
                                                        (double)beam->facts.notch_bonds
                                                  : NAN;
    return true;
}

static bool measure(CrackFronts *fronts, const Beam *beam)
{
    const size_t nodes = lattice_nodes(&beam->lattice);
    const int nx = beam->lattice.nx, ny = beam->lattice.ny;
    Growth growth = {.beam = beam, .fronts = fronts, .lines = nx > ny ? nx : ny};
    growth.front_of = malloc(nodes);
    growth.cracked = calloc(nodes, 1);
    growth.all = calloc(nodes, sizeof *growth.all);
    growth.broken = calloc(nodes, sizeof *growth.broken);
    growth.split = malloc((size_t)fronts->count * (size_t)growth.lines * sizeof *growth.split);
    const bool sound =
        growth.front_of && growth.cracked && growth.all && growth.broken && growth.split && work_out(&growth);
    free(growth.front_of);
    free(growth.cracked);
    free(growth.all);
    free(growth.broken);
    free(growth.split);
    free(growth.breaks);
    return sound;
}

void crack_fronts_free(CrackFronts *fronts)
{
    for (int f = 0; f < fronts->count; f++) {
        free(fronts->fronts[f].advances);
        for (int k = 0; k < fronts->fronts[f].n_paths; k++)
            free(fronts->fronts[f].paths[k].x);
    }
    *fronts = (CrackFronts){.count = 0};
}

bool crack_fronts_update(CrackFronts *fronts, const Simulation *sim)
{
    const Beam *beam = sim->method->links == beam_links ? (const Beam *)sim : NULL;
    if (beam && fronts->count > 0 && fronts->of == sim && fronts->step == sim->step &&
        fronts->broken == beam->head->broken && fronts->dissipated == beam->head->dissipated)
        return true;
    crack_fronts_free(fronts);
    if (!beam || beam->def.problem != BEAM_PLATE)
        return false;
    for (int i = 0; i < beam->def.plate.n_cuts; i++) {
        const PlateCut *cut = &beam->def.plate.cuts[i];
        const double from[2] = {cut->x0, cut->y0}, to[2] = {cut->x1, cut->y1};
        add_end(fronts, beam, cut, from, to);
        add_end(fronts, beam, cut, to, from);
    }
    if (fronts->count == 0 || !measure(fronts, beam)) {
        crack_fronts_free(fronts);
        return false;
    }
    fronts->of = sim;
    fronts->step = sim->step;
    fronts->broken = beam->head->broken;
    fronts->dissipated = beam->head->dissipated;
    return true;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exact answers beside a run of bodies, and what the run has come to:
 *
 *     free flight   x = x0 + v0 t + g t^2/2, of one body until it meets a wall
 *     first touch   |D + V t| = R_a + R_b, two round bodies; blocks: their edges
 *     momentum      p = p0 + M g t
 *     angular       L = L0 + M ((c - m) x g t + v x g t^2/2), m the box's middle
 *     slips         a = g (sin - mu cos), spin = -2 mu g t cos/R
 *     rolls         a = (2/3) g sin, spin = -a t/R
 *     spins         mean (sxx + syy)/2 = rho w^2 R^2/4, I/I0 - 1 = rho w^2 R^2 (1 - n)(7 + n)/(12 E'),
 *                   n = nu/(1 - nu), E' = E/(1 - nu^2) in plane strain, n = nu, E' = E in plane stress
 *     vibrates      u = V/(k c) sin(k x) sin(k c t), k = pi/W, c = sqrt(E/rho), sxx = E du/dx: a block with a
 *                   small wave between two clamps, nu = 0
 *     falls         a block 5:1 clamped at its end: converged finite elements
 * (tests/independent/cantilever.py)
 *
 * Gravity cancels in first touch. Momenta are exact until a wall can act: in a box with walls until the
 * first touch of any two, for a body that was struck flies another way. A disc let go on an incline, a wall
 * with friction, slips where tan(angle) > 3 mu, else it rolls, until it comes to the wall ahead. */
#include "base/math/functions.h"
#include "problems/bodies_answers.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { X, Y, VX, VY, SPIN, OF_BODY };

typedef struct Answers {
    MpmDef def;
    double start[BODIES_X + BODIES_MAX * OF_BODY]; /* the row at t = 0 */
    double mass, centre[2];                        /* of all, at t = 0 */
    double met, hit;    /* when bodies, and one and a wall, touch first; INFINITY: never; NAN: not known */
    double free;        /* until then no wall acts: the first of both in a box with walls */
    bool slides;        /* down an incline, from rest */
    double rate, turns; /* with this acceleration, and so much spin in a unit of time */
    double until;       /* when the disc comes to the wall ahead; INFINITY: it is open */
    bool falls;         /* a clamped block that has a reference */
    bool vibrates;      /* between two clamps */
    char names[OF_BODY][BODY_NAME_MAX + 24];
} Answers;

/* --- first touch ---------------------------------------------------------------------------------- */

/* The first t >= 0 with a t^2 + b t + c <= 0, of what touches only if it closes; INFINITY: never. */
static double first_root(double a, double b, double c, double close)
{
    if (c <= close)
        return b < 0 || (b == 0 && a < 0) ? 0 : INFINITY;
    if (a == 0)
        return b < 0 ? -c / b : INFINITY;
    const double whole = b * b - 4 * a * c;
    if (whole < 0)
        return INFINITY;
    /* of both roots without cancellation the least that is positive */
    const double q = -0.5 * (b + (b < 0 ? -sqrt(whole) : sqrt(whole)));
    const double one = q / a, other = q != 0 ? c / q : INFINITY;
    const double least = fmin(one, other), most = fmax(one, other);
    return least > 0 ? least : most > 0 ? most : INFINITY;
}

static bool is_round(const BodyDef *body)
{
    return body->shape != BODY_BLOCK;
}

/* Two blocks that do not turn: from when on they overlap along both axes. */
static double blocks_meet(const BodyDef *a, const BodyDef *b)
{
    double from = 0, until = INFINITY, low[2][2], high[2][2];
    bodies_bounds(a, low[0], high[0]);
    bodies_bounds(b, low[1], high[1]);
    for (int axis = 0; axis < 2; axis++) {
        const double v = b->velocity[axis] - a->velocity[axis];
        const double before = high[0][axis] - low[1][axis], behind = low[0][axis] - high[1][axis];
        if (v == 0 && (before <= 0 || behind >= 0))
            return INFINITY;
        if (v == 0)
            continue;
        from = fmax(from, (v < 0 ? before : behind) / v);
        until = fmin(until, (v < 0 ? behind : before) / v);
    }
    return from < until ? from : INFINITY;
}

/* Whether each of its points has the same velocity at t = 0. */
static bool moves_rigidly(const BodyDef *body)
{
    return body->spin == 0 && body->wave == 0;
}

static double pair_meets(const BodyDef *a, const BodyDef *b, double close)
{
    double D[2], V[2], centre[2][2];
    if (!is_round(a) && !is_round(b))
        return moves_rigidly(a) && moves_rigidly(b) ? blocks_meet(a, b) : NAN;
    if (is_round(a) != is_round(b))
        return NAN;
    bodies_centre(a, centre[0]);
    bodies_centre(b, centre[1]);
    for (int axis = 0; axis < 2; axis++) {
        D[axis] = centre[1][axis] - centre[0][axis];
        V[axis] = b->velocity[axis] - a->velocity[axis];
    }
    const double R = a->size[a->shape == BODY_RING ? 3 : 2] + b->size[b->shape == BODY_RING ? 3 : 2];
    const double apart = D[0] * D[0] + D[1] * D[1] - R * R;
    if (apart < -close * R)
        return NAN; /* one is within the other */
    return first_root(V[0] * V[0] + V[1] * V[1], 2 * (D[0] * V[0] + D[1] * V[1]), apart, close * R);
}

static double wall_meets(const MpmDef *def, const BodyDef *body, int wall, double close)
{
    const int axis = wall / 2, far = wall % 2;
    const double out = far ? 1 : -1;
    double low[2], high[2];
    bodies_bounds(body, low, high);
    if (!moves_rigidly(body) && !is_round(body))
        return NAN;
    const double distance = far ? (axis ? def->height : def->length) - high[axis] : low[axis];
    if (def->walls[wall] == WALL_CLAMP && distance <= close)
        return 0;
    return first_root(-0.5 * out * def->gravity[axis], -out * body->velocity[axis], distance, close);
}

/* What is nearer touches. */
static double closeness(const MpmDef *def)
{
    return 1e-9 * (def->length + def->height);
}

/* NAN where one of them is not known. */
static void find_touches(Answers *answers)
{
    const MpmDef *def = &answers->def;
    const double close = closeness(def);
    bool walled = false;
    answers->met = answers->hit = INFINITY;
    for (int a = 0; a < def->n_bodies; a++) {
        for (int b = a + 1; b < def->n_bodies; b++) {
            const double met = pair_meets(&def->bodies[a], &def->bodies[b], close);
            answers->met = isnan(met) || isnan(answers->met) ? NAN : fmin(met, answers->met);
        }
        for (int wall = 0; wall < WALLS; wall++)
            if (def->walls[wall] != WALL_OPEN) {
                const double hit = wall_meets(def, &def->bodies[a], wall, close);
                answers->hit = isnan(hit) || isnan(answers->hit) ? NAN : fmin(hit, answers->hit);
                walled = true;
            }
    }
    answers->free = !walled                                      ? INFINITY
                    : isnan(answers->met) || isnan(answers->hit) ? NAN
                                                                 : fmin(answers->met, answers->hit);
}

static void find_slide(Answers *answers)
{
    const MpmDef *def = &answers->def;
    const BodyDef *body = &def->bodies[0];
    const double along = fabs(def->gravity[0]), down = -def->gravity[1], mu = def->wall_friction;
    const double sign = def->gravity[0] < 0 ? -1 : 1, R = body->size[2];
    answers->slides = def->n_bodies == 1 && body->shape == BODY_DISC &&
                      def->walls[WALL_BOTTOM] == WALL_FRICTION && along > 0 && down > 0 && body->spin == 0 &&
                      body->velocity[0] == 0 && body->velocity[1] == 0 && fabs(body->size[1] - R) <= 1e-6 * R;
    const bool slips = along > 3 * mu * down;
    answers->rate = sign * (slips ? along - mu * down : 2 * along / 3);
    answers->turns = slips ? -sign * 2 * mu * down / R : -answers->rate / R;
    const double way = sign > 0 ? def->length - body->size[0] - R : body->size[0] - R;
    answers->until = def->walls[sign > 0 ? WALL_RIGHT : WALL_LEFT] == WALL_OPEN
                         ? INFINITY
                         : sqrt(2 * fmax(way, 0) / fabs(answers->rate));
}

/* --- a clamped block that falls ------------------------------------------------------------------- */

/* Displacements over L, of the centre of mass and of the middle of the free end, at E/(rho g L) = 50. */
enum { CENTRE = 0, TIP = 2, FALL_ROWS = 101 };
static const double fall_rows[FALL_ROWS][4] = {
#include "problems/cantilever_rows.inc"
};

static bool is_about(double value, double right)
{
    return fabs(value - right) <= 1e-9 * right;
}

static double fall_length(const MpmDef *def)
{
    return def->bodies[0].size[2] - def->bodies[0].size[0];
}

static bool find_fall(const MpmDef *def)
{
    const BodyDef *body = &def->bodies[0];
    const double L = fall_length(def), g = -def->gravity[1];
    return def->n_bodies == 1 && body->shape == BODY_BLOCK && body->size[0] == 0 && body->velocity[0] == 0 &&
           body->velocity[1] == 0 && moves_rigidly(body) && def->gravity[0] == 0 && g > 0 &&
           def->law == LAW_NEO_HOOKEAN && def->damping == 0 && is_about(def->poisson, 0.3) &&
           is_about(L / (body->size[3] - body->size[1]), 5) &&
           is_about(def->youngs_modulus / (def->density * g * L), 50) &&
           def->walls[WALL_LEFT] == WALL_CLAMP && def->walls[WALL_RIGHT] == WALL_OPEN &&
           def->walls[WALL_BOTTOM] == WALL_OPEN && def->walls[WALL_TOP] == WALL_OPEN;
}

/* Cubic between rows (Catmull, Rom), which are sqrt(L/(1000 g)) apart. NAN: behind the last but one. */
static double fallen(const Answers *answers, int what, double time)
{
    const double L = fall_length(&answers->def);
    const double place = time / sqrt(L / (-1000 * answers->def.gravity[1]));
    const int k = place < FALL_ROWS - 2 ? (int)place : -1;
    if (k < 0)
        return NAN;
    const double s = place - k, a = fall_rows[k > 0 ? k - 1 : 1][what], b = fall_rows[k][what],
                 c = fall_rows[k + 1][what], d = fall_rows[k + 2][what]; /* it begins at rest: even */
    return L * (b + 0.5 * s * (c - a + s * (2 * a - 5 * b + 4 * c - d + s * (3 * (b - c) + d - a))));
}

/* --- a block that vibrates between clamps ---------------------------------------------------------- */

/* Along x alone: nothing moves across it. Small: the largest strain is wave/c. */
static bool find_vibration(const MpmDef *def)
{
    const BodyDef *body = &def->bodies[0];
    return def->n_bodies == 1 && body->wave != 0 && body->size[0] == 0 &&
           is_about(body->size[2], def->length) &&
           fabs(body->wave) <= 1e-3 * sqrt(def->youngs_modulus / def->density) && body->velocity[0] == 0 &&
           body->velocity[1] == 0 && body->spin == 0 && def->poisson == 0 && def->damping == 0 &&
           def->gravity[0] == 0 && def->gravity[1] == 0 && def->walls[WALL_LEFT] == WALL_CLAMP &&
           def->walls[WALL_RIGHT] == WALL_CLAMP && def->walls[WALL_BOTTOM] == WALL_OPEN &&
           def->walls[WALL_TOP] == WALL_OPEN;
}

/* The root mean square of displacement, or of stress, less the exact one, over the largest of the motion. */
static double vibration_error(const Answers *answers, const Simulation *sim, bool stress)
{
    const MpmDef *def = &answers->def;
    const double k = M_PI / def->length, c = sqrt(def->youngs_modulus / def->density);
    const double largest = def->bodies[0].wave / (k * c) * (stress ? k * def->youngs_modulus : 1);
    const double now = largest * math_sin(k * c * simulation_time(sim));
    const int field = stress ? simulation_find_field(sim, 0, "sxx") : sim->displacement[0];
    double sum = 0;
    for (size_t p = 0; p < sim->counts[0]; p++) {
        const double phase = k * simulation_value(sim, sim->position[0], p);
        const double off =
            simulation_value(sim, field, p) - now * (stress ? math_cos(phase) : math_sin(phase));
        sum += off * off;
    }
    return sqrt(sum / (double)sim->counts[0]) / fabs(largest);
}

/* --- columns -------------------------------------------------------------------------------------- */

static const Answers *answers_of(const References *refs)
{
    return refs->own;
}

static double momentum(const Answers *answers, int axis, double time)
{
    return time <= answers->free /* no wall has acted */
               ? answers->start[BODIES_MOMENTUM_X + axis] + answers->mass * answers->def.gravity[axis] * time
               : NAN;
}

static double angular(const Answers *answers, double time)
{
    const MpmDef *def = &answers->def;
    const double *const g = def->gravity, *const start = answers->start;
    if (!(time <= answers->free))
        return NAN;
    const double moment[2] = {answers->centre[0] - 0.5 * def->length, answers->centre[1] - 0.5 * def->height};
    const double fall = start[BODIES_MOMENTUM_X] * g[1] - start[BODIES_MOMENTUM_Y] * g[0];
    return start[BODIES_ANGULAR] + answers->mass * (moment[0] * g[1] - moment[1] * g[0]) * time +
           0.5 * fall * time * time;
}

ANSWER(exact_px, momentum(answers_of(refs), 0, time))
ANSWER(exact_py, momentum(answers_of(refs), 1, time))
ANSWER(exact_angular, angular(answers_of(refs), time))

/* Of the only body. */
static double motion(const Answers *answers, int what, double time)
{
    const double *const start = answers->start + BODIES_X, *const g = answers->def.gravity;
    const double t = time;
    if (answers->slides && time > answers->until)
        return NAN;
    if (answers->slides)
        return what == X      ? start[X] + 0.5 * answers->rate * t * t
               : what == VX   ? answers->rate * t
               : what == SPIN ? answers->turns * t
               : what == Y    ? start[Y]
                              : 0;
    if (!(time <= answers->free) || (what == SPIN && !is_round(&answers->def.bodies[0])))
        return NAN;
    return what == X    ? start[X] + start[VX] * t + 0.5 * g[0] * t * t
           : what == Y  ? start[Y] + start[VY] * t + 0.5 * g[1] * t * t
           : what == VX ? start[VX] + g[0] * t
           : what == VY ? start[VY] + g[1] * t
                        : NAN;
}

ANSWER(reference_x, answers_of(refs)->start[BODIES_X + X] + fallen(answers_of(refs), CENTRE, time))
ANSWER(reference_y, answers_of(refs)->start[BODIES_X + Y] + fallen(answers_of(refs), CENTRE + 1, time))

ANSWER(exact_x, motion(answers_of(refs), X, time))
ANSWER(exact_y, motion(answers_of(refs), Y, time))
ANSWER(exact_vx, motion(answers_of(refs), VX, time))
ANSWER(exact_vy, motion(answers_of(refs), VY, time))
ANSWER(exact_spin, motion(answers_of(refs), SPIN, time))

static void plan_motion(References *refs, Answers *answers)
{
    static const struct {
        const char *name, *unit;
        Answer *answer;
    } of[OF_BODY] = {[X] = {"x", "length", exact_x},
                     [Y] = {"y", "length", exact_y},
                     [VX] = {"vx", "length/time", exact_vx},
                     [VY] = {"vy", "length/time", exact_vy},
                     [SPIN] = {"spin", "rad/time", exact_spin}};
    for (int k = 0; k < OF_BODY; k++) {
        char column[BODY_NAME_MAX + 8];
        if (k == SPIN && !answers->slides)
            continue;
        snprintf(column, sizeof column, "%s.%s", answers->def.bodies[0].name, of[k].name);
        snprintf(answers->names[k], sizeof answers->names[k], "%s_exact", column);
        plan_answer(refs, &(Quantity){answers->names[k], "exact", of[k].unit, "of a rigid body"},
                    COLUMN_EXACT, column, of[k].answer);
    }
}

bool bodies_prepare(References *refs, const MpmDef *def, const Simulation *sim, Status *status)
{
    static const Quantity px = {"momentum_x_exact", "exact", "mass*length/time", "momentum along x, exact"};
    static const Quantity py = {"momentum_y_exact", "exact", "mass*length/time", "momentum along y, exact"};
    static const Quantity turn = {"angular_exact", "exact", "mass*length^2/time", "angular momentum, exact"};
    Answers *answers = plan_own(refs, sizeof *answers, NULL, status);
    if (!answers)
        return false;
    answers->def = *def;
    mpm_row_of_bodies(sim, answers->start);
    answers->mass = (double)sim->counts[0] * simulation_named(sim, 0, "mass", 0);
    for (int axis = 0; axis < 2; axis++) {
        for (size_t p = 0; p < sim->counts[0]; p++)
            answers->centre[axis] += simulation_value(sim, sim->position[axis], p);
        answers->centre[axis] /= (double)sim->counts[0];
    }
    find_touches(answers);
    find_slide(answers);
    answers->falls = !refs->unaccounted[REFERENCE_EXACT] && find_fall(def);
    answers->vibrates = !refs->unaccounted[REFERENCE_EXACT] && find_vibration(def);
    plan_rest_of_method(refs, sim);
    if (answers->free > 0) {
        plan_answer(refs, &px, COLUMN_EXACT, "momentum_x", exact_px);
        plan_answer(refs, &py, COLUMN_EXACT, "momentum_y", exact_py);
        plan_answer(refs, &turn, COLUMN_EXACT, "angular", exact_angular);
    }
    if (def->n_bodies == 1 && (answers->slides || answers->free > 0))
        plan_motion(refs, answers);
    for (int k = X; answers->falls && k <= Y; k++) {
        char column[BODY_NAME_MAX + 8];
        snprintf(column, sizeof column, "%s.%s", def->bodies[0].name, k == X ? "x" : "y");
        snprintf(answers->names[k], sizeof answers->names[k], "%s_reference", column);
        plan_answer(refs,
                    &(Quantity){answers->names[k], "reference", "length", "of converged finite elements"},
                    COLUMN_EXACT, column, k == X ? reference_x : reference_y);
    }
    return true;
}

/* --- findings ------------------------------------------------------------------------------------- */

static void add(Finding *out, int *count, const char *name, const char *label, double measured, double exact,
                const char *word)
{
    if (*count < FINDINGS_MAX)
        out[(*count)++] = (Finding){name, label, measured, exact, word, NULL};
}

/* Of a disc that spins alone: means over the time so far, about which it breathes. */
static void add_spin(const Answers *answers, const BodiesSeen *seen, Finding *out, int *count)
{
    const MpmDef *def = &answers->def;
    const bool stress = def->plane == PLANE_STRESS;
    const double nu = def->poisson, n = stress ? nu : nu / (1 - nu);
    const double E = def->youngs_modulus / (stress ? 1 : 1 - nu * nu);
    const double v = def->bodies[0].spin * def->bodies[0].size[2], pull = def->density * v * v;
    const bool free = isinf(answers->free);
    add(out, count, "growth", "growth of I", seen->growth, free ? pull * (1 - n) * (7 + n) / (12 * E) : NAN,
        NULL);
    add(out, count, "mean_stress", "mean stress", seen->pull, free ? pull / 4 : NAN, NULL);
}

int bodies_findings(const References *refs, const Simulation *sim, Finding out[FINDINGS_MAX])
{
    const Answers *answers = answers_of(refs);
    const MpmDef *def = &answers->def;
    const BodiesSeen seen = bodies_seen(sim);
    const double now = simulation_time(sim), *const start = answers->start;
    double row[BODIES_X + BODIES_MAX * OF_BODY];
    int n = 0;
    bool walls = false;
    mpm_row_of_bodies(sim, row);
    for (int wall = 0; wall < WALLS; wall++)
        walls = walls || def->walls[wall] == WALL_SLIP || def->walls[wall] == WALL_FRICTION;
    const double met = answers->met < answers->hit ? answers->met : NAN,
                 hit = answers->hit < answers->met ? answers->hit : NAN;
    if (def->n_bodies > 1 && def->fields == FIELDS_EACH)
        add(out, &n, "first_touch", "first touch", seen.met, met, NULL);
    if (walls && answers->hit != 0)
        add(out, &n, "wall_touch", "first touch of a wall", seen.hit, isfinite(hit) ? hit : NAN, NULL);
    if (def->n_bodies == 2 && def->gravity[0] == 0 && def->gravity[1] == 0 && bodies_closing(start) > 0) {
        /* while they push each other still, that of now */
        const double apart = def->fields != FIELDS_EACH ? -bodies_closing(row) / bodies_closing(start)
                             : isnan(seen.parting)      ? -bodies_closing(row) / seen.meeting
                                                        : seen.parting / seen.meeting;
        add(out, &n, "restitution", "restitution", apart > 0 ? apart : NAN, NAN, NULL);
    }
    const bool known = !refs->unaccounted[REFERENCE_EXACT];
    const double p[2] = {momentum(answers, 0, now), momentum(answers, 1, now)};
    if (known && isfinite(p[0]) && isfinite(p[1])) {
        const double off[2] = {row[BODIES_MOMENTUM_X] - p[0], row[BODIES_MOMENTUM_Y] - p[1]};
        const double size = sqrt(2 * answers->mass * fmax(start[BODIES_KINETIC], row[BODIES_KINETIC]));
        if (size > 0)
            add(out, &n, "momentum_error", "error of momentum",
                sqrt(off[0] * off[0] + off[1] * off[1]) / size, 0, NULL);
    }
    const double L = angular(answers, now);
    if (known && isfinite(L) &&
        fabs(L) > 1e-9 * sqrt(2 * answers->mass * start[BODIES_KINETIC]) * (def->length + def->height))
        add(out, &n, "angular_kept", "angular momentum/exact", row[BODIES_ANGULAR] / L, 1, NULL);
    if (def->n_bodies == 2) {
        const double spin = row[BODIES_X + OF_BODY + SPIN];
        double low[2], high[2];
        bodies_bounds(&def->bodies[1], low, high);
        const double turning = fabs(spin) * 0.5 * (high[0] - low[0]);
        const bool rounding = turning < 1e-9 * sqrt(2 * start[BODIES_KINETIC] / answers->mass);
        add(out, &n, "body_spin", "spin of the second", rounding ? 0 : spin, NAN, NULL);
    }
    if (answers->slides && now > 0)
        add(out, &n, "acceleration", "mean acceleration", row[BODIES_X + VX] / now,
            now <= answers->until ? answers->rate : NAN, NULL);
    /* once it has left the floor: y + v^2/(2 g) */
    if (def->n_bodies == 1 && def->walls[WALL_BOTTOM] == WALL_SLIP && def->gravity[0] == 0 &&
        def->gravity[1] < 0 &&
        wall_meets(def, &def->bodies[0], WALL_BOTTOM, closeness(def)) <= answers->hit) {
        const double up = row[BODIES_X + VY];
        add(out, &n, "bounce_height", "height of the bounce",
            isfinite(seen.hit) && !seen.on_floor ? row[BODIES_X + Y] - up * up / (2 * def->gravity[1]) : NAN,
            NAN, NULL); /* a part of the motion becomes vibration: its start is not an answer */
    }
    if (known && isfinite(seen.growth))
        add_spin(answers, &seen, out, &n);
    if (answers->falls) {
        double tip[2];
        bodies_tip(sim, tip);
        add(out, &n, "tip_x", "tip moved x", tip[0], fallen(answers, TIP, now), "reference");
        add(out, &n, "tip_y", "y", tip[1], fallen(answers, TIP + 1, now), "reference");
    }
    if (answers->vibrates) {
        add(out, &n, "u_error", "error of u", vibration_error(answers, sim, false), 0, NULL);
        add(out, &n, "sxx_error", "error of sxx", vibration_error(answers, sim, true), 0, NULL);
    }
    add(out, &n, "stretch", "largest stretch", seen.stretch, NAN, NULL);
    if (isfinite(seen.torn))
        add(out, &n, "torn", "torn at t =", seen.torn, NAN, NULL);
    return n;
}

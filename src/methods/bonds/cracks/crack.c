/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The crack of the notched beam (crack.h), measured from the damage of nodes: path, tip, length, angle and
 * speed. Called at the end of the damage stage (bonds_break.c) and by code that shows or tabulates the crack;
 * nothing here changes the motion. */
#include "methods/bonds/cracks/crack.h"
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_internal.h"
#include "base/math/functions.h"

#include <math.h>

#define BEFORE_NOTCH 5.0 /* horizons; the crack is looked for from here */

/* NULL: the simulation is not a beam with a notch. */
static const Beam *notched(const Simulation *sim)
{
    const Beam *beam = sim->method->links == beam_links ? (const Beam *)sim : NULL;
    return beam && beam->def.problem == BEAM_NOTCHED ? beam : NULL;
}

/* Rows in which there can be a crack: a row that lies just at the notch's end is the notch's. */
static bool is_above_notch(const Beam *beam, int j)
{
    return lattice_y(&beam->lattice, j) > beam->def.notch_depth + 1e-6 * beam->lattice.spacing;
}

/* A cracked node where the crack is looked for, from the load to five horizons beyond the notch, outside the
 * protected zones. Farther out single nodes beside supports and load may be damaged too. */
static bool is_cracked(const Beam *beam, int i, int j)
{
    const size_t node = lattice_node(&beam->lattice, i, j);
    if (beam->damage[node] <= CRACK_DAMAGE || beam->unbreakable[node])
        return false;
    const double notch = beam->def.notch_position, load = beam->def.load_position;
    const double before = BEFORE_NOTCH * beam->def.horizon, x = lattice_x(&beam->lattice, i);
    return load < notch ? x >= load && x <= notch + before : x >= notch - before && x <= load;
}

/* sum phi x / sum phi over the row's cracked nodes. False: there are none, or the row is the notch's. */
static bool row_centre(const Beam *beam, int j, double *centre)
{
    double sum = 0, weights = 0;
    for (int i = 0; is_above_notch(beam, j) && i < beam->lattice.nx; i++)
        if (is_cracked(beam, i, j)) {
            double damage = beam->damage[lattice_node(&beam->lattice, i, j)];
            sum += damage * lattice_x(&beam->lattice, i);
            weights += damage;
        }
    *centre = weights > 0 ? sum / weights : 0;
    return weights > 0;
}

size_t crack_path(const Simulation *sim, double *x, double *y, size_t max)
{
    ASSERT(max == 0 || (x && y));
    const Beam *beam = notched(sim);
    size_t n = 0;
    for (int j = 0; beam && j < beam->lattice.ny && n < max; j++)
        if (row_centre(beam, j, &x[n]))
            y[n++] = lattice_y(&beam->lattice, j);
    return n;
}

/* The tip: of the highest row with a cracked node the node with most damage. False: it has not begun. */
static bool find_tip(const Beam *beam, double *x, double *y)
{
    *x = beam->def.notch_position;
    *y = beam->def.notch_depth;
    for (int j = beam->lattice.ny - 1; j >= 0 && is_above_notch(beam, j); j--) {
        double most = 0;
        for (int i = 0; i < beam->lattice.nx; i++) {
            double damage = beam->damage[lattice_node(&beam->lattice, i, j)];
            if (damage > most && is_cracked(beam, i, j)) {
                most = damage;
                *x = lattice_x(&beam->lattice, i);
            }
        }
        if (most > 0) {
            *y = lattice_y(&beam->lattice, j);
            return true;
        }
    }
    return false;
}

/* The path goes from the notch's end through the centres of the rows, upwards: sum hypot(dx, dy), m. Rows
 * that did not break are bridged by a straight line. Length and tip only grow: where a centre moves back
 * because its row breaks further, the crack does not shrink. */
void crack_follow(Beam *beam)
{
    StateHead *head = beam->head;
    double x = beam->def.notch_position, y = beam->def.notch_depth, length = 0;
    for (int j = 0; j < beam->lattice.ny; j++) {
        double next_y = lattice_y(&beam->lattice, j), next_x;
        if (!row_centre(beam, j, &next_x))
            continue;
        length += math_hypot(next_x - x, next_y - y);
        x = next_x;
        y = next_y;
    }
    head->crack_length = fmax(head->crack_length, length);
    if (find_tip(beam, &x, &y) && y > head->tip_y) {
        head->tip_x = x;
        head->tip_y = y;
    }
}

/* --- how fast ------------------------------------------------------------------------------------- */

/* The tip is noted every so many steps that the ring of CRACK_TIPS places holds the window of crack.h,
 * at least two of them; the speed is then the slope of a line through n_tips places. */
void crack_begin(Beam *beam)
{
    const double dt = beam->sim.dt,
                 window = crack_speed_window(beam->def.horizon, beam->def.youngs_modulus, beam->def.density);
    beam->tip_every = (long)fmin(1e9, fmax(1, ceil(window / dt / (CRACK_TIPS - 1))));
    beam->n_tips = (int)fmax(2, fmin(CRACK_TIPS, round(window / ((double)beam->tip_every * dt)) + 1));
    beam->head->tip_x = beam->def.notch_position;
    beam->head->tip_y = beam->def.notch_depth;
}

/* The speed from the last n_tips places up to number `last` in the ring; 0 while there are fewer. */
static double speed_up_to(const Beam *beam, long last)
{
    double x[CRACK_TIPS], y[CRACK_TIPS];
    if (last < beam->n_tips - 1)
        return 0;
    for (int k = 0; k < beam->n_tips; k++) {
        const long at = (last - beam->n_tips + 1 + k) % CRACK_TIPS;
        x[k] = beam->head->tips_x[at];
        y[k] = beam->head->tips_y[at];
    }
    return crack_tip_speed(x, y, (size_t)beam->n_tips, (double)beam->tip_every * beam->sim.dt);
}

void crack_note_tip(Beam *beam, long step)
{
    ASSERT_INT(step, >=, beam->sim.step);
    StateHead *head = beam->head;
    if (step % beam->tip_every)
        return;
    const long number = step / beam->tip_every;
    head->tips_x[number % CRACK_TIPS] = head->tip_x;
    head->tips_y[number % CRACK_TIPS] = head->tip_y;
    if (head->arrival < 0)
        head->fastest = fmax(head->fastest, speed_up_to(beam, number));
}

double crack_speed_now(const Beam *beam)
{
    return speed_up_to(beam, beam->sim.step / beam->tip_every);
}

static double time_of(const Beam *beam, long step)
{
    return step < 0 ? NAN : (double)step * beam->sim.dt;
}

bool crack_measure(const Simulation *sim, Crack *crack)
{
    const Beam *beam = notched(sim);
    if (!beam)
        return false;
    *crack = (Crack){
        .first_break = time_of(beam, beam->head->first_break),
        .twentieth_break = time_of(beam, beam->head->twentieth_break),
        .arrival = time_of(beam, beam->head->arrival),
        .speed = crack_speed_now(beam),
        .fastest = beam->head->fastest,
        .broken = beam->head->broken,
        .beam_height = beam->def.height,
    };
    crack->begun = find_tip(beam, &crack->x, &crack->y);
    crack->length = beam->head->crack_length;
    return true;
}

/* The angle of the path against the vertical, degrees, over `height` from a horizon above the notch's end:
 * the straight line x = a + b y through the rows' centres by least squares,
 *
 *     b = (n sum xy - sum x sum y)/(n sum y^2 - (sum y)^2),   angle = atan b
 *
 * NAN with fewer than two rows. */
double crack_angle(const Simulation *sim, double height)
{
    ASSERT_REAL(height, >, 0);
    const Beam *beam = notched(sim);
    if (!beam)
        return NAN;
    double low = beam->def.notch_depth + beam->def.horizon, tolerance = 1e-6 * beam->lattice.spacing;
    FittedLine line = {0};
    for (int j = 0; j < beam->lattice.ny; j++) {
        double y = lattice_y(&beam->lattice, j), x;
        if (y < low - tolerance || y > low + height + tolerance || !row_centre(beam, j, &x))
            continue;
        line_add(&line, y, x);
    }
    return math_atan(line_slope(&line)) * 180 / M_PI;
}

/* The speed of the crack's tip from its places, and Rayleigh's speed to compare it with. In plane stress with
 * nu = 1/3 c_s^2 = G/rho with G = E/(2 (1 + nu)) = 3E/8, and x = (c_R/c_s)^2 solves Rayleigh's equation
 *
 *     x^3 - 8 x^2 + (24 - 16 k) x - 16 (1 - k) = 0,   k = (c_s/c_p)^2 = (1 - nu)/2 = 1/3,
 *
 * whose root between 0 and 1 is 2 - 2/sqrt(3). */

double crack_speed_rayleigh(double youngs_modulus, double density)
{
    ASSERT_REAL(youngs_modulus, >, 0);
    ASSERT_REAL(density, >, 0);
    return sqrt(2 - 2 / sqrt(3)) * sqrt(3 * youngs_modulus / (8 * density));
}

double crack_speed_window(double horizon, double youngs_modulus, double density)
{
    ASSERT_REAL(horizon, >, 0);
    return 4 * horizon / crack_speed_rayleigh(youngs_modulus, density);
}

/* The slope of the least-squares line through a_k over k, times 1/dt, of x and of y; then the length of both
 * together:
 *
 *     slope = sum (k - m) a_k / sum (k - m)^2,   m = (n - 1)/2,   sum (k - m)^2 = n (n^2 - 1)/12 */
double crack_tip_speed(const double *x, const double *y, size_t n, double dt)
{
    double sum_x = 0, sum_y = 0;
    const double count = (double)n;
    if (n < 2)
        return 0;
    ASSERT_REAL(dt, >, 0);
    for (size_t k = 0; k < n; k++) {
        const double from_middle = (double)k - (count - 1) / 2;
        sum_x += from_middle * x[k];
        sum_y += from_middle * y[k];
    }
    return math_hypot(sum_x, sum_y) / (count * (count * count - 1) / 12 * dt);
}

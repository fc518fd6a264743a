/* Stages and whole steps of a bar: who calls the kernels on which cells, and what may stop a run. */
#include "physics/mpm/bar_state.h"
#include "physics/mpm/kernels.h"
#include "physics/mpm/shape.h"

#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The energy may be multiplied by this before the run is stopped. Heating by cell crossing is a matter of
 * some ten per cent, at worst a small factor; beyond a factor of a hundred in velocity nothing of the bar is
 * left to be seen, and an unstable run gets there in a few hundred steps. */
static const double energy_bound = 1e4;

/* Growth that is reported, each once. */
static const double energy_levels[] = {1.1, 2.0, 10.0, 100.0, 1000.0};
static const char *const energy_words[] = {"by 10 %", "to twice", "to 10 times", "to 100 times",
                                           "to 1000 times"};
enum { ENERGY_LEVELS = sizeof energy_levels / sizeof energy_levels[0] };

/* " in step 13, t = 1.3" for the step that is going on. */
static void step_words(const Bar *bar, char *out, size_t size)
{
    char time[NUMBER_TEXT_MAX];
    text_rounded(time, (double)(bar->sim.step + 1) * bar->dt, 6);
    snprintf(out, size, "in step %ld, t = %s", bar->sim.step + 1, time);
}

static bool fail_particle(Bar *bar, Status *status, int particle, const char *what)
{
    char when[80];
    step_words(bar, when, sizeof when);
    return simulation_fail(&bar->sim, status, "particle %d %s %s", particle, what, when);
}

/* Events become true with the step that is going on, which the driver has not counted yet. */
static void report(Bar *bar, EventKind kind, const char *text)
{
    int before = bar->sim.n_events;
    simulation_report(&bar->sim, kind, text);
    if (bar->sim.n_events > before)
        bar->sim.events[before].step = bar->sim.step + 1;
}

static void note_crossing(Bar *bar, int particle, int cell)
{
    uint64_t bit = (uint64_t)1 << (particle % 64);
    if (bar->crossed[particle / 64] & bit)
        return;
    bar->crossed[particle / 64] |= bit;
    if (bar->sim.n_events == SIMULATION_EVENTS_MAX) {
        bar->sim.events_beyond++;
        return;
    }
    char text[80];
    snprintf(text, sizeof text, "particle %d crossed into cell %d", particle, cell);
    report(bar, EVENT_CROSSING, text);
}

void bar_count_odd_cells(Bar *bar)
{
    memset(bar->odd, 0, ((size_t)bar->n_cells / BAR_CELL_BLOCK + 1) * sizeof *bar->odd);
    for (int c = 0; c < bar->n_cells; c++)
        if (bar->first[c + 1] - bar->first[c] != bar->slots)
            bar->odd[c / BAR_CELL_BLOCK]++;
}

static bool is_odd(const Bar *bar, int c)
{
    return bar->first[c + 1] - bar->first[c] != bar->slots;
}

/* Cell c begins with another particle: this changes how many it and the cell before it hold. */
static void set_first(Bar *bar, int c, int particle)
{
    for (int side = c - 1; side <= c; side++)
        if (is_odd(bar, side))
            bar->odd[side / BAR_CELL_BLOCK]--;
    bar->first[c] = particle;
    for (int side = c - 1; side <= c; side++)
        if (is_odd(bar, side))
            bar->odd[side / BAR_CELL_BLOCK]++;
}

/* --- forget the grid: particles find their cells -------------------------------------------------- */

/* Counts the cell edges passed; s comes back to [0, 1). */
static int pass_edges(double *s)
{
    double edges = floor(*s);
    *s -= edges;
    if (*s >= 1.0) { /* a hair left of an edge, which is the edge itself in double precision */
        *s = 0.0;
        edges += 1.0;
    }
    return (int)edges;
}

/* The particles of one cell. Those that stay or go to a neighbour are settled; a jump over a whole cell is
 * left to the end of the stage. */
static bool settle_cell(Bar *bar, int c, Status *status)
{
    const int begin = bar->first[c], end = bar->first[c + 1];
    double before = -INFINITY;
    for (int p = begin; p < end; p++) {
        double moved = bar->moved[p % bar->slots][p / bar->slots];
        if (!(moved >= before))
            return fail_particle(bar, status, p, "was overtaken by its neighbour (1 + de <= 0)");
        before = moved;
        bar->jumped = bar->jumped || moved < -1.0 || moved >= 2.0;
    }
    if (bar->jumped)
        return true;
    int into_left = begin, from_right = end;
    for (int p = begin; p < end; p++) {
        int j = p % bar->slots, k = p / bar->slots;
        double moved = bar->moved[j][k];
        if (moved >= 0.0 && moved < 1.0) {
            bar->s[j][k] = moved;
            continue;
        }
        double s = moved;
        int target = c + pass_edges(&s);
        if (target < 0 || target >= bar->n_cells)
            return fail_particle(bar, status, p, "left the mesh");
        if (target < c) {
            if (p > 0 && bar->first[c - 1] < p && !(s >= bar->s[(p - 1) % bar->slots][(p - 1) / bar->slots]))
                return fail_particle(bar, status, p, "was overtaken by its neighbour (1 + de <= 0)");
            into_left = p + 1;
        } else if (target > c && from_right == end)
            from_right = p;
        bar->s[j][k] = bar->moved[j][k] = s;
        if (target != c) {
            bar->head->cell_sum += target - c;
            note_crossing(bar, p, target);
        }
    }
    if (into_left != begin)
        set_first(bar, c, into_left);
    if (from_right != end)
        set_first(bar, c + 1, from_right);
    return true;
}

/* After a jump: all particles from where they were, in one go. */
static bool settle_all(Bar *bar, Status *status)
{
    memcpy(bar->old_first, bar->first, ((size_t)bar->n_cells + 1) * sizeof *bar->first);
    int next = 0; /* the next cell whose first particle is not known */
    int last_cell = 0;
    double last_s = 0.0;
    for (int c = 0; c < bar->n_cells; c++)
        for (int p = bar->old_first[c]; p < bar->old_first[c + 1]; p++) {
            int j = p % bar->slots, k = p / bar->slots;
            double s = bar->moved[j][k];
            if (!(s >= -(double)c && s < (double)(bar->n_cells - c)))
                return fail_particle(bar, status, p, "left the mesh");
            int target = c + pass_edges(&s);
            if (target == bar->n_cells)
                return fail_particle(bar, status, p, "left the mesh");
            if (target < last_cell || (target == last_cell && s < last_s))
                return fail_particle(bar, status, p, "was overtaken by its neighbour (1 + de <= 0)");
            last_cell = target;
            last_s = s;
            while (next <= target)
                bar->first[next++] = p;
            bar->s[j][k] = bar->moved[j][k] = s;
            if (target != c) {
                bar->head->cell_sum += target - c;
                note_crossing(bar, p, target);
            }
        }
    while (next <= bar->n_cells)
        bar->first[next++] = bar->n_particles;
    bar_count_odd_cells(bar);
    return true;
}

static bool forget(Bar *bar, int first, int end, Status *status)
{
    if (first == 0)
        bar->jumped = false;
    for (int c = first; c < end && !bar->jumped;) {
        int limit = c + BAR_CELL_BLOCK < end ? c + BAR_CELL_BLOCK : end, run = bar_run_end(bar, c, limit) - c;
        if (run > 0 && bar->kernels->settle(bar, run, bar->first[c])) {
            c += run;
            continue;
        }
        int stop = run > 0 ? c + run : c + 1;
        for (; c < stop && !bar->jumped; c++)
            if (!settle_cell(bar, c, status))
                return false;
    }
    if (end == bar->n_cells && bar->jumped)
        return settle_all(bar, status);
    return true;
}

/* --- the energy ----------------------------------------------------------------------------------- */

static int blocks_of(int count)
{
    return (count + BAR_SUM_BLOCK - 1) / BAR_SUM_BLOCK;
}

/* sum m D C^2 / 2 with D = sum N d^2: what the particles' affine motion holds */
static double affine_energy(const Bar *bar)
{
    double sum = 0.0;
    for (int c = 0; c < bar->n_cells; c++)
        for (int p = bar->first[c]; p < bar->first[c + 1]; p++) {
            int j = p % bar->slots, k = p / bar->slots;
            double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX], spread = 0.0, s = bar->s[j][k];
            shape_at(bar->def.shape, bar->gimp_half, bar->n_cells, c, s, n, dn);
            for (int a = 0; a < bar->support; a++) {
                double arm = shape_node_offset(bar->def.shape, bar->n_cells, c, a) - s;
                spread += n[a] * (arm * arm);
            }
            double speed = bar->affine[j][k] * bar->dx;
            sum += spread * (speed * speed);
        }
    return 0.5 * bar->mass * sum;
}

static void particle_row(const Bar *bar, double *v_cm, double *x_cm, double *kinetic, double *strain)
{
    double sums[4] = {0.0};
    bar->kernels->particle_sums(bar, 0, blocks_of(bar->places), sums);
    *v_cm = sums[0] / bar->n_particles;
    *x_cm = bar->dx * (((double)bar->head->cell_sum + sums[1]) / bar->n_particles);
    *kinetic = 0.5 * bar->mass * sums[2];
    if (bar->head->transfer == MPM_APIC)
        *kinetic += affine_energy(bar);
    *strain = sums[3] / (2.0 * bar->def.youngs_modulus);
}

double bar_energy(const Bar *bar)
{
    double v_cm, x_cm, kinetic, strain;
    particle_row(bar, &v_cm, &x_cm, &kinetic, &strain);
    return kinetic + strain;
}

/* At the end of some steps, the same ones however the run is cut and watched. */
static bool check_energy(Bar *bar, Status *status)
{
    if ((bar->sim.step + 1) % BAR_CHECK_EVERY != 0)
        return true;
    BarHead *head = bar->head;
    if (fabs(head->work) > head->peak_work)
        head->peak_work = fabs(head->work);
    double reference = bar->energy_start + head->peak_work, energy = bar_energy(bar);
    if (!(energy <= energy_bound * reference)) {
        char when[80];
        step_words(bar, when, sizeof when);
        return simulation_fail(
            &bar->sim, status,
            "the energy has grown to more than %g times what was put in, %s: the run is unstable"
            " (a smaller courant number, or another algorithm)",
            energy_bound, when);
    }
    while (head->energy_level < ENERGY_LEVELS && energy > energy_levels[head->energy_level] * reference) {
        char text[80];
        snprintf(text, sizeof text, "the energy has grown %s", energy_words[head->energy_level++]);
        report(bar, EVENT_ENERGY, text);
    }
    return true;
}

/* --- stages --------------------------------------------------------------------------------------- */

/* Supports hold the nodes that come with these cells. */
static void fix(Bar *bar, int first, int end)
{
    int last = end == bar->n_cells ? bar->n_nodes : end;
    for (int i = first; i < last && i < bar->fixed_left; i++)
        bar->node_momentum[i] = 0.0;
    for (int i = last - 1; i >= first && i >= bar->n_nodes - bar->fixed_right; i--)
        bar->node_momentum[i] = 0.0;
}

static bool do_op(Bar *bar, BarOp op, int first, int end, Status *status)
{
    const BarKernels *kernels = bar->kernels;
    switch (op) {
    case OP_MAP:
        kernels->map(bar, first, end, false);
        return true;
    case OP_FIX:
        fix(bar, first, end);
        return true;
    case OP_STRAIN: {
        int bad = kernels->strain(bar, first, end);
        return bad < 0 || fail_particle(bar, status, bad, "was crushed (1 + de <= 0)");
    }
    case OP_FORCE:
        kernels->force(bar, first, end);
        return true;
    case OP_INTEGRATE:
        kernels->integrate(bar, first, end);
        return true;
    case OP_UPDATE:
        kernels->update(bar, first, end);
        return true;
    case OP_MAP_AGAIN:
        kernels->map(bar, first, end, true);
        fix(bar, first, end);
        return true;
    case OP_FORGET:
        return forget(bar, first, end, status) && (end < bar->n_cells || check_energy(bar, status));
    case OP_COUNT:
        break;
    }
    return true;
}

bool bar_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status)
{
    Bar *bar = bar_of(sim);
    const BarSchedule *schedule = bar_schedule(bar->head, bar->def.shape);
    /* what a step that can be looked at has not written yet is 0, so that its snapshots are the same bytes
     * whatever ran before */
    if (stage == 0 && first == 0)
        memset((char *)bar->block + bar->bytes_apic, 0, bar->bytes_whole - bar->bytes_apic);
    return do_op(bar, schedule->ops[stage], (int)first, (int)end, status);
}

/* --- rows and whole steps ------------------------------------------------------------------------- */

/* The particles' part of a row, and of the grid's as it stands after map and boundary conditions. */
static void write_row(const Bar *bar, double *row)
{
    double v_cm, x_cm, kinetic, strain, grid = 0.0;
    particle_row(bar, &v_cm, &x_cm, &kinetic, &strain);
    bar->kernels->node_sums(bar, 0, blocks_of(bar->n_nodes), &grid);
    row[0] = v_cm;
    row[1] = x_cm;
    row[2] = kinetic;
    row[3] = 0.5 * grid;
    row[4] = strain;
    row[5] = bar->head->work;
    row[6] = kinetic + strain;
}

static void map_and_fix(Bar *bar)
{
    bar->kernels->map(bar, 0, bar->n_cells, false);
    fix(bar, 0, bar->n_cells);
}

void bar_row(Simulation *sim, double *row)
{
    Bar *bar = bar_of(sim);
    map_and_fix(bar); /* the grid is scratch between steps */
    write_row(bar, row);
}

/* What a batch of steps goes back to if one of them fails. */
typedef struct Mark {
    long step;
    int n_events;
    long events_beyond;
} Mark;

static Mark set_mark(Bar *bar)
{
    memcpy(bar->backup, bar->block, bar->bytes_apic);
    return (Mark){bar->sim.step, bar->sim.n_events, bar->sim.events_beyond};
}

static void go_back(Bar *bar, Mark mark)
{
    memcpy(bar->block, bar->backup, bar->bytes_apic);
    bar_count_odd_cells(bar);
    bar->sim.step = mark.step;
    bar->sim.n_events = mark.n_events;
    bar->sim.events_beyond = mark.events_beyond;
    bar->sim.failed = false;
}

/* Whole steps over the whole bar, stage by stage. The map of the next step also serves the row. */
static bool whole_steps(Bar *bar, long count, double *rows, Status *status)
{
    const BarSchedule *schedule = bar_schedule(bar->head, bar->def.shape);
    if (count > 0)
        map_and_fix(bar);
    for (long n = 0; n < count; n++) {
        for (int stage = 2; stage < schedule->count; stage++)
            if (!do_op(bar, schedule->ops[stage], 0, bar->n_cells, status))
                return false;
        bar->sim.step++;
        if (rows || n + 1 < count)
            map_and_fix(bar);
        if (rows)
            write_row(bar, rows + n * BAR_SERIES);
    }
    return true;
}

bool bar_steps(Simulation *sim, long count, double *rows, long *done, Status *status)
{
    Bar *bar = bar_of(sim);
    *done = 0;
    while (*done < count) {
        long batch = BAR_CHECK_EVERY - sim->step % BAR_CHECK_EVERY;
        if (batch > count - *done)
            batch = count - *done;
        double *here = rows ? rows + *done * BAR_SERIES : NULL;
        Mark mark = set_mark(bar);
        if (whole_steps(bar, batch, here, status)) {
            *done += batch;
            continue;
        }
        /* find the step that fails, and stand before it */
        go_back(bar, mark);
        for (;;) {
            mark = set_mark(bar);
            if (!whole_steps(bar, 1, here, status))
                break;
            ++*done;
            here = rows ? here + BAR_SERIES : NULL;
        }
        Status failure = sim->failure;
        go_back(bar, mark);
        sim->failed = true;
        sim->failure = failure;
        return false;
    }
    return true;
}

/* The sum behind a stage with its numbers, for one particle or one node: what a teacher would write on the
 * board. ASCII, at most three lines of 76 columns; a sum of many terms ends in "...". */
#include "physics/mpm/bar_state.h"
#include "physics/mpm/shape.h"

#include "base/text.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { COLUMNS = 76, LINES = 3, ROOM_FOR_RESULT = 16, TERMS_MAX = 16, DIGITS = 4, FINE_DIGITS = 6 };

typedef struct Lines {
    char text[3 * (COLUMNS + 1) + 1];
    char line[256]; /* the line being written, not yet cut */
    int count;      /* whole lines written */
} Lines;

__attribute__((format(printf, 2, 3))) static void put(Lines *lines, const char *format, ...)
{
    size_t used = strlen(lines->line);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(lines->line + used, sizeof lines->line - used, format, arguments);
    va_end(arguments);
}

static void put_digits(Lines *lines, const char *words, double value, int digits)
{
    char number[NUMBER_TEXT_MAX];
    text_rounded(number, value, digits);
    put(lines, "%s%s", words, number);
}

static void put_number(Lines *lines, const char *words, double value)
{
    put_digits(lines, words, value, DIGITS);
}

static void end_line(Lines *lines)
{
    if (lines->count == LINES)
        return;
    size_t used = strlen(lines->text);
    lines->line[COLUMNS] = '\0';
    snprintf(lines->text + used, sizeof lines->text - used, "%s%s", used ? "\n" : "", lines->line);
    lines->line[0] = '\0';
    lines->count++;
}

/* A sum of products of up to two factors. */
typedef struct Sum {
    int count;
    struct {
        double factor[2];
        int factors;
    } terms[TERMS_MAX];
} Sum;

static void add_term(Sum *sum, int factors, double a, double b)
{
    if (sum->count == TERMS_MAX)
        return;
    sum->terms[sum->count].factors = factors;
    sum->terms[sum->count].factor[0] = a;
    sum->terms[sum->count++].factor[1] = b;
}

/* "0.5 x 0.75 + 0.5 x 0.25", as many terms as leave room for the result, on one line or the next ones up to
 * line number `last`. */
static void put_sum(Lines *lines, const Sum *sum, int last)
{
    for (int i = 0; i < sum->count; i++) {
        char term[4 * NUMBER_TEXT_MAX] = "", number[NUMBER_TEXT_MAX];
        for (int f = 0; f < sum->terms[i].factors; f++) {
            size_t used = strlen(term);
            double factor = sum->terms[i].factor[f];
            const char *joint = f ? " x " : "";
            if (f == 0 && i > 0) { /* "a - b", not "a + -b" */
                joint = factor < 0.0 ? " - " : " + ";
                factor = fabs(factor);
            }
            text_rounded(number, factor, DIGITS);
            snprintf(term + used, sizeof term - used, "%s%s", joint, number);
        }
        size_t room = lines->count < last ? COLUMNS : COLUMNS - ROOM_FOR_RESULT;
        if (strlen(lines->line) + strlen(term) > room) {
            if (lines->count == last) {
                put(lines, i ? " + ..." : "...");
                return;
            }
            end_line(lines);
            put(lines, "    ");
        }
        put(lines, "%s", term);
    }
    if (sum->count == 0)
        put(lines, "0");
}

/* --- what is asked about -------------------------------------------------------------------------- */

typedef struct Subject {
    const Bar *bar;
    const unsigned char *before; /* NULL: not known */
    int index;
} Subject;

/* A particle with its nodes, at the beginning of the step. */
typedef struct View {
    int cell, slot, k;
    double s, v, stress, volume;
    double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX]; /* dn by x */
} View;

static View view_particle(const Bar *bar, int particle, int cell)
{
    View view = {.cell = cell, .slot = particle % bar->slots, .k = particle / bar->slots};
    view.s = bar->s[view.slot][view.k];
    view.v = bar->v[view.slot][view.k];
    view.stress = bar->stress[view.slot][view.k];
    view.volume = bar->volume[view.slot][view.k];
    shape_at(bar->def.shape, bar->gimp_half, bar->n_cells, cell, view.s, view.n, view.dn);
    for (int a = 0; a < bar->support; a++)
        view.dn[a] /= bar->dx;
    return view;
}

/* Calls `visit` for each particle that has a part in a node. */
static void each_particle(const Bar *bar, int node, void (*visit)(const Bar *, const View *, int a, Sum *),
                          Sum *sum)
{
    for (int cell = node - bar->support + 1; cell <= node; cell++) {
        if (cell < 0 || cell >= bar->n_cells)
            continue;
        for (int p = bar->first[cell]; p < bar->first[cell + 1]; p++) {
            View view = view_particle(bar, p, cell);
            if (view.n[node - cell] != 0.0 || view.dn[node - cell] != 0.0)
                visit(bar, &view, node - cell, sum);
        }
    }
}

static double velocity_of(const Bar *bar, int node)
{
    return bar->node_momentum[node] * bar->node_inverse[node];
}

static double integrated_velocity(const Bar *bar, int node)
{
    return bar->node_drift[node] * (bar->dx / bar->dt);
}

/* A number of the state before the stage. */
static double number_before(const Subject *subject, const double *now)
{
    double value;
    memcpy(&value,
           subject->before + ((const unsigned char *)now - (const unsigned char *)subject->bar->block),
           sizeof value);
    return value;
}

/* --- map ------------------------------------------------------------------------------------------ */

static void mass_term(const Bar *bar, const View *view, int a, Sum *sum)
{
    (void)bar;
    add_term(sum, 1, view->n[a], 0);
}

static double given_velocity(const Bar *bar, const View *view, int a)
{
    if (bar->head->transfer != MPM_APIC)
        return view->v;
    double arm = shape_node_offset(bar->def.shape, bar->n_cells, view->cell, a) - view->s;
    return view->v + bar->affine[view->slot][view->k] * (bar->dx * arm);
}

static void momentum_term(const Bar *bar, const View *view, int a, Sum *sum)
{
    add_term(sum, 2, given_velocity(bar, view, a), view->n[a]);
}

static void say_mapped_momentum(const Bar *bar, int node, Lines *lines)
{
    Sum sum = {0};
    each_particle(bar, node, momentum_term, &sum);
    put(lines, "p%d = m sum v N = ", node);
    put_number(lines, "", bar->mass);
    put(lines, " (");
    put_sum(lines, &sum, lines->count + 1);
    /* the boundary conditions may have taken the momentum at hand away already */
    double total = 0;
    for (int i = 0; i < sum.count; i++)
        total += sum.terms[i].factor[0] * sum.terms[i].factor[1];
    put_number(lines, ") = ", bar->mass * total);
    end_line(lines);
}

static void map_node(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    Sum sum = {0};
    each_particle(bar, subject->index, mass_term, &sum);
    put(lines, "m%d = m sum N = ", subject->index);
    put_number(lines, "", bar->mass);
    put(lines, " (");
    put_sum(lines, &sum, 0);
    put_number(lines, ") = ", bar->node_mass[subject->index]);
    end_line(lines);
    say_mapped_momentum(bar, subject->index, lines);
    if (bar->node_inverse[subject->index] == 0.0) {
        put(lines, "no mass to speak of: the node is inactive");
        end_line(lines);
    }
}

/* "0.375 to node 8, 0.125 to node 9" */
static void put_shares(const Bar *bar, const View *view, const double *share, Lines *lines)
{
    const char *comma = "";
    for (int a = 0; a < bar->support; a++) {
        if (view->n[a] == 0.0 && view->dn[a] == 0.0)
            continue;
        put_digits(lines, comma, share[a], bar->support > 3 ? 3 : DIGITS);
        put(lines, " to %d", view->cell + a);
        comma = ", ";
    }
    end_line(lines);
}

static void map_particle(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    View view = view_particle(bar, subject->index, bar_cell_of(bar, subject->index));
    double share[BAR_SUPPORT_MAX];
    put(lines, "N = ");
    put_shares(bar, &view, view.n, lines);
    for (int a = 0; a < bar->support; a++)
        share[a] = bar->mass * view.n[a];
    put_number(lines, "m = ", bar->mass);
    put(lines, ": ");
    put_shares(bar, &view, share, lines);
    for (int a = 0; a < bar->support; a++)
        share[a] *= given_velocity(bar, &view, a);
    put_digits(lines, "m v = ", bar->mass * view.v, 3);
    put(lines, ": ");
    put_shares(bar, &view, share, lines);
}

static void map_again_node(const Subject *subject, Lines *lines)
{
    say_mapped_momentum(subject->bar, subject->index, lines);
    if (bar_node_is_fixed(subject->bar, subject->index)) {
        put(lines, "node %d is fixed: p%d = 0", subject->index, subject->index);
        end_line(lines);
    }
}

static void map_again_particle(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    View view = view_particle(bar, subject->index, bar_cell_of(bar, subject->index));
    double share[BAR_SUPPORT_MAX];
    for (int a = 0; a < bar->support; a++)
        share[a] = bar->mass * given_velocity(bar, &view, a) * view.n[a];
    put_digits(lines, "new m v = ", bar->mass * view.v, 3);
    put(lines, ": ");
    put_shares(bar, &view, share, lines);
}

/* --- boundary conditions -------------------------------------------------------------------------- */

static void fix_node(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    int i = subject->index;
    if (bar_node_is_fixed(bar, i)) {
        put(lines, "node %d is fixed: p%d = ", i, i);
        if (subject->before) {
            put_number(lines, "", number_before(subject, &bar->node_momentum[i]));
            put(lines, " -> ");
        }
        put_number(lines, "0, its mass ", bar->node_mass[i]);
        put(lines, " stays");
    } else {
        put_number(lines, "a free node: its momentum ", bar->node_momentum[i]);
        put(lines, " stays");
    }
    end_line(lines);
}

static void fix_particle(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    int cell = bar_cell_of(bar, subject->index);
    int fixed = -1;
    for (int node = cell; node < cell + bar->support; node++)
        if (bar_node_is_fixed(bar, node))
            fixed = node;
    if (fixed >= 0)
        put(lines, "its node %d is fixed and cannot move", fixed);
    else
        put(lines, "none of its nodes is fixed: nothing changes here");
    end_line(lines);
}

/* --- strain and stress ---------------------------------------------------------------------------- */

static void strain_node(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    int i = subject->index;
    put(lines, "v%d = p%d/m%d = ", i, i, i);
    put_number(lines, "", bar->node_momentum[i]);
    put_number(lines, " / ", bar->node_mass[i]);
    put_number(lines, " = ", velocity_of(bar, i));
    end_line(lines);
}

static void strain_particle(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    View view = view_particle(bar, subject->index, bar_cell_of(bar, subject->index));
    Sum sum = {0};
    double velocity[BAR_SUPPORT_MAX], gradient = 0;
    for (int a = 0; a < bar->support; a++)
        velocity[a] = velocity_of(bar, view.cell + a);
    if (bar->def.shape == MPM_HAT)
        bar_lend_velocity(bar, view.cell, velocity);
    for (int a = 0; a < bar->support; a++) {
        gradient += view.dn[a] * velocity[a];
        if (view.dn[a] != 0.0)
            add_term(&sum, 2, view.dn[a], velocity[a]);
    }
    double de = bar->dt * gradient;
    put_number(lines, "de = dt sum N' v = ", bar->dt);
    put(lines, " (");
    put_sum(lines, &sum, 1);
    put_number(lines, ") = ", de);
    end_line(lines);
    double density = bar->mass / view.volume;
    put_digits(lines, "stress ", view.stress - bar->def.youngs_modulus * de, FINE_DIGITS);
    put_digits(lines, " -> ", view.stress, FINE_DIGITS);
    put_digits(lines, "   density ", density * (1.0 + de), FINE_DIGITS);
    put_digits(lines, " -> ", density, FINE_DIGITS);
    end_line(lines);
}

/* The whole force on a node: eq. 12, none at a support. */
static double node_force(const Bar *bar, int i)
{
    if (bar_node_is_fixed(bar, i))
        return 0.0;
    return bar_is_loaded(bar) ? bar->node_f_int[i] + bar->node_f_ext[i] : bar->node_f_int[i];
}

/* --- nodal forces --------------------------------------------------------------------------------- */

static void force_term(const Bar *bar, const View *view, int a, Sum *sum)
{
    (void)bar;
    add_term(sum, 2, -view->dn[a], view->stress * view->volume);
}

static void force_node(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    int i = subject->index;
    Sum sum = {0};
    each_particle(bar, i, force_term, &sum);
    put(lines, "f_int = -sum N' (stress V) = ");
    put_sum(lines, &sum, 1);
    put_number(lines, " = ", bar->node_f_int[i]);
    end_line(lines);
    if (bar_node_is_fixed(bar, i))
        put(lines, "node %d is fixed: f%d = 0, the support bears the rest", i, i);
    else {
        put_number(lines, "f = f_int + f_ext = ", bar->node_f_int[i]);
        put_number(lines, " + ", node_force(bar, i) - bar->node_f_int[i]);
        put_number(lines, " = ", node_force(bar, i));
    }
    end_line(lines);
}

static void force_particle(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    View view = view_particle(bar, subject->index, bar_cell_of(bar, subject->index));
    double share[BAR_SUPPORT_MAX], pull = view.stress * view.volume;
    put_number(lines, "stress x V = ", view.stress);
    put_number(lines, " x ", view.volume);
    put_number(lines, " = ", pull);
    put(lines, "   (V = m/rho)");
    end_line(lines);
    for (int a = 0; a < bar->support; a++)
        share[a] = -view.dn[a] * pull;
    put(lines, "-N' stress V: ");
    put_shares(bar, &view, share, lines);
}

/* --- integrate momentum --------------------------------------------------------------------------- */

static void integrate_node(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    int i = subject->index;
    double force = node_force(bar, i);
    put(lines, "p%d = p + dt f = ", i);
    put_number(lines, "", bar->node_momentum[i] - bar->dt * force);
    put_number(lines, " + ", bar->dt);
    put_number(lines, " x ", force);
    put_number(lines, " = ", bar->node_momentum[i]);
    end_line(lines);
    put(lines, "v%d = p%d/m%d = ", i, i, i);
    put_number(lines, "", velocity_of(bar, i));
    end_line(lines);
}

static void integrate_particle(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    View view = view_particle(bar, subject->index, bar_cell_of(bar, subject->index));
    int said = 0;
    for (int a = 0; a < bar->support && said < 3; a++) {
        int i = view.cell + a;
        if (view.n[a] == 0.0)
            continue;
        put(lines, "its node %d: p ", i);
        put_number(lines, "", bar->node_momentum[i] - bar->dt * node_force(bar, i));
        put_number(lines, " -> ", bar->node_momentum[i]);
        end_line(lines);
        said++;
    }
}

/* --- update particles ----------------------------------------------------------------------------- */

static void update_node(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    int i = subject->index;
    put(lines, "node %d gives its acceleration f/m = ", i);
    put_number(lines, "", bar->node_kick[i] / bar->dt);
    put_number(lines, " and its velocity p/m = ", integrated_velocity(bar, i));
    end_line(lines);
}

static void update_particle(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    const BarHead *head = bar->head;
    View view = view_particle(bar, subject->index, bar_cell_of(bar, subject->index));
    Sum kicks = {0}, drifts = {0};
    double kick = 0, speed = 0;
    for (int a = 0; a < bar->support; a++) {
        if (view.n[a] == 0.0)
            continue;
        int i = view.cell + a;
        add_term(&kicks, 2, view.n[a], bar->node_kick[i] / bar->dt);
        add_term(&drifts, 2, view.n[a], integrated_velocity(bar, i));
        kick += view.n[a] * bar->node_kick[i];
        speed += view.n[a] * integrated_velocity(bar, i);
    }
    const double *v = &bar->v[view.slot][view.k];
    if (head->transfer == MPM_APIC) {
        put(lines, "v = sum N v_i = ");
        put_sum(lines, &drifts, 0);
        put_number(lines, " = ", *v);
        end_line(lines);
        put_number(lines, "C = ", bar->affine[view.slot][view.k]);
        end_line(lines);
    } else if (head->flip_fraction == 1.0) {
        put_number(lines, "v = ", *v - kick);
        put_number(lines, " + ", bar->dt);
        put(lines, " (");
        put_sum(lines, &kicks, 0);
        put_number(lines, ") = ", *v);
        end_line(lines);
    } else {
        const double alpha = head->flip_fraction;
        if (alpha > 0.0) {
            double old = (*v - (1.0 - alpha) * speed) / alpha - kick;
            put_number(lines, "FLIP: ", old);
            put_number(lines, " + ", bar->dt);
            put(lines, " (");
            put_sum(lines, &kicks, 0);
            put_number(lines, ") = ", old + kick);
            end_line(lines);
        }
        put_number(lines, "PIC: ", speed);
        put_number(lines, "   v = ", alpha);
        put_number(lines, " FLIP + ", 1.0 - alpha);
        put_number(lines, " PIC = ", *v);
        end_line(lines);
    }
    put_digits(lines, "x = ", ((view.cell - bar->origin) + view.s) * bar->dx, FINE_DIGITS);
    put_number(lines, " + ", bar->dt);
    put(lines, " (");
    put_sum(lines, &drifts, lines->count);
    put_digits(lines, ") = ", ((view.cell - bar->origin) + bar->moved[view.slot][view.k]) * bar->dx,
               FINE_DIGITS);
    end_line(lines);
}

/* --- forget the grid ------------------------------------------------------------------------------ */

static void forget_node(const Subject *subject, Lines *lines)
{
    put(lines, "node %d is empty again, at x = ", subject->index);
    put_number(lines, "", bar_node_position(subject->bar, subject->index));
    end_line(lines);
}

static void forget_particle(const Subject *subject, Lines *lines)
{
    const Bar *bar = subject->bar;
    int cell = bar_cell_of(bar, subject->index);
    double left = (cell - bar->origin) * bar->dx;
    double s = bar->s[subject->index % bar->slots][subject->index / bar->slots];
    put_digits(lines, "x = ", left + s * bar->dx, FINE_DIGITS);
    put(lines, " lies in cell %d, from ", cell);
    put_number(lines, "", left);
    put_number(lines, " to ", left + bar->dx);
    end_line(lines);
}

typedef void Saying(const Subject *subject, Lines *lines);

static const struct {
    Saying *particle, *node;
} sayings[OP_COUNT] = {
    [OP_MAP] = {map_particle, map_node},
    [OP_FIX] = {fix_particle, fix_node},
    [OP_STRAIN] = {strain_particle, strain_node},
    [OP_FORCE] = {force_particle, force_node},
    [OP_INTEGRATE] = {integrate_particle, integrate_node},
    [OP_UPDATE] = {update_particle, update_node},
    [OP_MAP_AGAIN] = {map_again_particle, map_again_node},
    [OP_FORGET] = {forget_particle, forget_node},
};

void bar_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, char *out,
                 size_t size)
{
    const Bar *bar = bar_of_const(sim);
    const BarSchedule *schedule = bar_schedule(bar->head, bar->def.shape);
    if (size == 0)
        return;
    out[0] = '\0';
    /* the sum can be written while its numbers are there: right after the stage */
    int just_done = sim->stage > 0 ? sim->stage - 1 : schedule->count - 1;
    if (stage != just_done || index >= sim->counts[set])
        return;
    Subject subject = {.bar = bar, .before = before, .index = (int)index};
    Lines lines = {.text = ""};
    (set == 0 ? sayings[schedule->ops[stage]].particle : sayings[schedule->ops[stage]].node)(&subject,
                                                                                             &lines);
    snprintf(out, size, "%s", lines.text);
}

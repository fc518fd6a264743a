/* The sums behind a stage with their numbers, for one particle or one node: what a teacher would write on the
 * board. The terms are those of bar_exchange.c, put together by bar_sums.c. */
#include "physics/mpm_bar/bar_sums.h"
#include "physics/mpm_bar/shape.h"

static double *velocity_of_particle(const Bar *bar, int particle)
{
    return &bar->v[particle % bar->slots][particle / bar->slots];
}

/* --- map ------------------------------------------------------------------------------------------ */

static void say_momentum(const BarSubject *subject, BarExchange exchange)
{
    const BarLabel label = bar_label("p", subject->index, " = ");
    WorkingSum sum = {.label = label.text};
    sum.result = bar_add_gifts(subject, exchange, &sum);
    working_sum(subject->working, &sum);
}

static void map_node(const BarSubject *subject)
{
    const BarLabel label = bar_label("m", subject->index, " = ");
    WorkingSum sum = {.label = label.text, .result = subject->bar->node_mass[subject->index]};
    bar_add_gifts(subject, GIVE_MASS, &sum);
    working_sum(subject->working, &sum);
    say_momentum(subject, GIVE_MOMENTUM);
}

static void map_particle(const BarSubject *subject)
{
    const Bar *bar = subject->bar;
    WorkingSum sum = {.label = "N: ", .result = 1};
    for (size_t i = 0; i < subject->n_links; i++)
        working_add(&sum, 1, subject->links[i].weight, 0, 0)->to = (long)subject->links[i].index;
    working_sum(subject->working, &sum);
    bar_say_shares(subject, GIVE_MASS, "m N: ", bar->mass);
    bar_say_shares(subject, GIVE_MOMENTUM, "m v N: ", bar->mass * *velocity_of_particle(bar, subject->index));
}

static void map_again_node(const BarSubject *subject)
{
    say_momentum(subject, GIVE_MOMENTUM_AGAIN);
    if (bar_node_is_fixed(subject->bar, subject->index))
        working_say(subject->working, "the node is fixed: p%d = 0\n", subject->index);
}

static void map_again_particle(const BarSubject *subject)
{
    bar_say_shares(subject, GIVE_MOMENTUM_AGAIN,
                   "new m v N: ", subject->bar->mass * *velocity_of_particle(subject->bar, subject->index));
}

/* --- boundary conditions -------------------------------------------------------------------------- */

static void fix_node(const BarSubject *subject)
{
    const Bar *bar = subject->bar;
    Working *working = subject->working;
    const int i = subject->index;
    working_say(working, "p%d", i);
    if (!bar_node_is_fixed(bar, i)) {
        working_number(working, " = ", bar->node_momentum[i]);
        working_say(working, " stays: no support holds the node\n");
        return;
    }
    if (subject->before)
        working_number(working, ": ", working_before(bar->block, &bar->node_momentum[i], subject->before));
    working_say(working, " → 0: a support holds the node\n");
    working_number(working, "its mass ", bar->node_mass[i]);
    working_say(working, " stays\n");
}

static void fix_particle(const BarSubject *subject)
{
    for (size_t i = 0; i < subject->n_links; i++)
        if (bar_node_is_fixed(subject->bar, (int)subject->links[i].index)) {
            working_say(subject->working, "its node %zu is fixed and cannot move\n", subject->links[i].index);
            return;
        }
    working_say(subject->working, "none of its nodes is fixed: nothing changes here\n");
}

/* --- strain and stress ---------------------------------------------------------------------------- */

static void strain_node(const BarSubject *subject)
{
    const int i = subject->index;
    bar_say_ratio(subject, bar_label("v", i, " = p/m = ").text, subject->bar->node_momentum[i],
                  bar_node_velocity(subject->bar, i));
}

static void strain_particle(const BarSubject *subject)
{
    const Bar *bar = subject->bar;
    const int slot = subject->index % bar->slots, k = subject->index / bar->slots;
    const double stress = bar->stress[slot][k], density = bar->mass / bar->volume[slot][k];
    WorkingSum strain = {.label = "Δε = "};
    const double increment = strain.result = bar_add_gifts(subject, TAKE_STRAIN, &strain);
    working_sum(subject->working, &strain);

    const double modulus = bar->def.youngs_modulus;
    working_change(subject->working, "σ = σ + E Δε = ", stress - modulus * increment, modulus, increment,
                   stress, NULL);

    WorkingSum thin = {.label = "ρ = ρ/(1 + Δε) = ", .result = density};
    working_add(&thin, 1, density * (1 + increment), 0, 0)->divisor = 1 + increment;
    working_sum(subject->working, &thin);
}

/* --- nodal forces --------------------------------------------------------------------------------- */

static void force_node(const BarSubject *subject)
{
    const Bar *bar = subject->bar;
    const int i = subject->index;
    WorkingSum internal = {.label = "f_int = Σ -N′ (σ V) = ", .result = bar->node_f_int[i]};
    bar_add_gifts(subject, GIVE_F_INT, &internal);
    working_sum(subject->working, &internal);
    const bool loaded = bar_is_loaded(bar) && bar->node_f_ext[i] != 0.0;
    if (loaded) {
        WorkingSum external = {.label = "f_ext = ", .result = bar->node_f_ext[i]};
        bar_add_gifts(subject, GIVE_F_EXT, &external);
        working_sum(subject->working, &external);
    }
    if (bar_node_is_fixed(bar, i)) {
        working_say(subject->working, "the node is fixed: f = 0, the support bears the rest\n");
    } else if (loaded) {
        WorkingSum whole = {.label = "f = f_int + f_ext = ", .result = bar_node_force(bar, i)};
        working_add(&whole, 1, bar->node_f_int[i], 0, 0);
        working_add(&whole, 1, bar->node_f_ext[i], 0, 0);
        working_sum(subject->working, &whole);
    } else {
        working_say(subject->working, "no load acts here: f = f_int\n");
    }
}

static void force_particle(const BarSubject *subject)
{
    const Bar *bar = subject->bar;
    const int slot = subject->index % bar->slots, k = subject->index / bar->slots;
    const double stress = bar->stress[slot][k], volume = bar->volume[slot][k];
    WorkingSum pull = {.label = "σ V = ", .result = stress * volume};
    working_add(&pull, 2, stress, volume, 0);
    working_sum(subject->working, &pull);
    bar_say_shares(subject, GIVE_F_INT, "-N′ σ V: ", 0);
    if (bar_is_loaded(bar)) {
        double f[EXCHANGE_FACTORS_MAX] = {0};
        bar_exchange(&bar->sim, GIVE_F_EXT, (size_t)subject->index, subject->links[0].index, f);
        bar_say_shares(subject, GIVE_F_EXT, "N load: ", f[1]);
    }
}

/* --- integrate momentum --------------------------------------------------------------------------- */

static void say_integrated(const BarSubject *subject, int node)
{
    const Bar *bar = subject->bar;
    const double force = bar_node_force(bar, node);
    const BarLabel label = bar_label("p", node, " = p + Δt f = ");
    const double momentum = bar->node_momentum[node];
    working_change(subject->working, label.text, momentum - bar->dt * force, bar->dt, force, momentum, NULL);
}

static void integrate_node(const BarSubject *subject)
{
    say_integrated(subject, subject->index);
    strain_node(subject);
}

static void integrate_particle(const BarSubject *subject)
{
    for (size_t i = 0; i < subject->n_links; i++)
        if (subject->links[i].weight != 0.0)
            say_integrated(subject, (int)subject->links[i].index);
}

/* --- update particles ----------------------------------------------------------------------------- */

static void update_node(const BarSubject *subject)
{
    const Bar *bar = subject->bar;
    const int i = subject->index;
    /* the momentum at hand may be mapped anew already; the drift is of the one that was integrated */
    const double speed = bar_integrated_velocity(bar, i);
    bar_say_ratio(subject, "it gives a = f/m = ", bar_node_force(bar, i), bar->node_kick[i] / bar->dt);
    bar_say_ratio(subject, "and v = p/m = ", speed * bar->node_mass[i], speed);
}

/* The slope of the velocity that APIC carries: of a hat the gradient, else from the nodes' distances. */
static void say_slope(const BarSubject *subject)
{
    const Bar *bar = subject->bar;
    const int cell = bar_cell_of(bar, subject->index);
    const int slot = subject->index % bar->slots, k = subject->index / bar->slots;
    const bool hat = bar->def.shape == MPM_HAT;
    WorkingSum sum = {.label = hat ? "C = Σ N′ v = " : "C = Σ N v d / Σ N d² = ",
                      .result = bar->affine[slot][k]};
    for (size_t i = 0; i < subject->n_links; i++) {
        const Link *link = &subject->links[i];
        const double speed = bar_integrated_velocity(bar, (int)link->index);
        const double offset = shape_node_offset(bar->def.shape, bar->n_cells, cell, (int)link->index - cell);
        const double arm = bar->dx * (offset - bar->s[slot][k]);
        if (hat)
            working_add(&sum, 2, link->gradient[0], speed, 0);
        else
            working_add(&sum, 3, link->weight, speed, arm);
        sum.divisor += hat ? 0 : link->weight * arm * arm;
    }
    working_sum(subject->working, &sum);
}

static void say_velocity(const BarSubject *subject)
{
    const Bar *bar = subject->bar;
    const double alpha = bar->head->flip_fraction, now = *velocity_of_particle(bar, subject->index);
    if (bar->head->transfer == MPM_APIC || alpha == 0.0) {
        WorkingSum mean = {.label = "v = Σ N v_i = ", .result = now};
        bar_add_gifts(subject, TAKE_VELOCITY, &mean);
        working_sum(subject->working, &mean);
        return;
    }
    WorkingSum flip = {.label = alpha == 1.0 ? "v = " : "FLIP: ", .has_base = true, .scale = bar->dt};
    WorkingSum mean = {.label = "PIC: "};
    double kick = 0;
    for (size_t i = 0; i < subject->n_links; i++) {
        const Link *link = &subject->links[i];
        const int node = (int)link->index;
        if (link->weight == 0.0)
            continue;
        kick += link->weight * bar->node_kick[node];
        mean.result += link->weight * bar_integrated_velocity(bar, node);
        working_add(&flip, 2, link->weight, bar->node_kick[node] / bar->dt, 0);
        working_add(&mean, 2, link->weight, bar_integrated_velocity(bar, node), 0);
    }
    flip.result = alpha == 1.0 ? now : (now - (1.0 - alpha) * mean.result) / alpha;
    flip.base = flip.result - kick;
    working_sum(subject->working, &flip);
    if (alpha == 1.0)
        return;
    working_sum(subject->working, &mean);
    WorkingSum blend = {.label = "v = ", .result = now};
    working_add(&blend, 2, alpha, flip.result, 0);
    working_add(&blend, 2, 1.0 - alpha, mean.result, 0);
    working_sum(subject->working, &blend);
}

static void update_particle(const BarSubject *subject)
{
    const Bar *bar = subject->bar;
    const int slot = subject->index % bar->slots, k = subject->index / bar->slots;
    const int from_origin = bar_cell_of(bar, subject->index) - bar->origin;
    say_velocity(subject);
    WorkingSum place = {.label = "x = ",
                        .has_base = true,
                        .base = (from_origin + bar->s[slot][k]) * bar->dx,
                        .result = (from_origin + bar->moved[slot][k]) * bar->dx};
    bar_add_gifts(subject, TAKE_PLACE, &place);
    working_sum(subject->working, &place);
    if (bar->head->transfer == MPM_APIC)
        say_slope(subject);
}

/* --- forget the grid ------------------------------------------------------------------------------ */

static void forget_node(const BarSubject *subject)
{
    working_number(subject->working, "the node is empty again, and where it was: x = ",
                   bar_node_position(subject->bar, subject->index));
    working_end_line(subject->working);
}

static void forget_particle(const BarSubject *subject)
{
    const Bar *bar = subject->bar;
    const int cell = bar_cell_of(bar, subject->index);
    const double left = (cell - bar->origin) * bar->dx;
    const double s = bar->s[subject->index % bar->slots][subject->index / bar->slots];
    working_number(subject->working, "x = ", left + s * bar->dx);
    working_say(subject->working, " lies in cell %d, from", cell);
    working_number(subject->working, " ", left);
    working_number(subject->working, " to ", left + bar->dx);
    working_end_line(subject->working);
}

typedef void Saying(const BarSubject *subject);

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

void bar_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, int terms,
                 char *out, size_t size)
{
    const Bar *bar = bar_of_const(sim);
    const BarSchedule *schedule = bar_schedule(bar->head, bar->def.shape);
    Working working;
    working_open(&working, out, size, terms);
    /* the sum can be written while its numbers are there: right after the stage */
    int just_done = sim->stage > 0 ? sim->stage - 1 : schedule->count - 1;
    if (stage != just_done || index >= sim->counts[set])
        return;
    BarSubject subject = {.bar = bar, .before = before, .set = set, .index = (int)index, .working = &working};
    subject.n_links = bar_links(sim, set, index, subject.links, LINKS_MAX);
    (set == BAR_PARTICLES ? sayings[schedule->ops[stage]].particle
                          : sayings[schedule->ops[stage]].node)(&subject);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mistakes of a bar's code: their rows, and the numbers that such a code takes (bar_mistakes.h). */
#include "methods/mpm/line/bar_mistakes.h"
#include "base/assertion.h"
#include "methods/mpm/line/kernels/bar_kernels.h"

#include <math.h>

/* --- the rows --------------------------------------------------------------------------------------- */

static double volume_of_cell(const Bar *bar, int particle, double volume)
{
    (void)particle;
    return volume * bar->slots;
}

static double mass_for_volume(const Bar *bar, int particle, double volume)
{
    (void)volume;
    return bar_particle_mass(bar, particle);
}

static double no_volume(const Bar *bar, int particle, double volume)
{
    (void)bar, (void)particle, (void)volume;
    return 1.0;
}

static double not_thinned(double volume, double stretch)
{
    (void)stretch;
    return volume;
}

static double thickened(double volume, double stretch)
{
    return volume / stretch;
}

static const BarMistake mistakes[] = {
#define MISTAKE(name, op, words, line, plain, ...)                                                           \
    {.id = name, .sentence = words, .stage = op, .equation = line, .ascii = plain, __VA_ARGS__},
#include "methods/mpm/line/bar_mistake_rows.inc"
#undef MISTAKE
};
enum { MISTAKES = sizeof mistakes / sizeof *mistakes };

const char *const bar_mistake_words[] = {
    "none",
#define MISTAKE(name, ...) name,
#include "methods/mpm/line/bar_mistake_rows.inc"
#undef MISTAKE
    NULL,
};

static const BarMistake *bar_mistake_of(int mistake)
{
    return mistake > 0 && mistake <= MISTAKES ? &mistakes[mistake - 1] : NULL;
}

/* One of two that differ from what is right, 0; false: both do, by other values. */
static bool join(int one, int other, int *out)
{
    *out = one ? one : other;
    return !one || !other || one == other;
}

bool bar_mistakes_join(int one, int other, BarMistake *out)
{
    const BarMistake *a = bar_mistake_of(one), *b = bar_mistake_of(other);
    int holds, moves, algorithm;
    if (!a || !b || a == b || (a->thinned && b->thinned) || (a->volume && b->volume) ||
        !join((int)a->holds, (int)b->holds, &holds) || !join((int)a->moves, (int)b->moves, &moves) ||
        !join((int)a->algorithm, (int)b->algorithm, &algorithm))
        return false;
    *out = *a;
    if (!out->also_equation && b->stage != a->stage) {
        out->also = b->stage;
        out->also_equation = b->equation;
        out->also_ascii = b->ascii;
    }
    out->of_start = a->of_start || b->of_start;
    out->starts_at_centres = a->starts_at_centres || b->starts_at_centres;
    out->starts_as_held = a->starts_as_held || b->starts_as_held;
    out->mass_of_cell = a->mass_of_cell || b->mass_of_cell;
    out->keeps_grid = a->keeps_grid || b->keeps_grid;
    out->holds = (BarHolds)holds;
    out->holds_next = a->holds_next || b->holds_next;
    out->held_yield = a->held_yield || b->held_yield;
    out->no_span = a->no_span || b->no_span;
    out->no_spacing = a->no_spacing || b->no_spacing;
    out->only_newest = a->only_newest || b->only_newest;
    out->stress_before = a->stress_before || b->stress_before;
    out->thinned = a->thinned ? a->thinned : b->thinned;
    out->volume = a->volume ? a->volume : b->volume;
    out->pushes = a->pushes || b->pushes;
    out->first_kick = fmax(a->first_kick, b->first_kick);
    out->new_weights = a->new_weights || b->new_weights;
    out->moves = (BarMoves)moves;
    out->algorithm = (MpmAlgorithm)algorithm;
    out->of_grid = a->of_grid || b->of_grid;
    return true;
}

const BarMistake *bar_mistake_if(const Bar *bar, int mistake)
{
    return bar->both ? bar->both : bar_mistake_of(mistake);
}

const BarMistake *bar_mistake(const Bar *bar)
{
    return bar_mistake_if(bar, bar->head->mistake);
}

bool bar_mistake_is_of_start(int mistake)
{
    const BarMistake *row = bar_mistake_of(mistake);
    return row && row->of_start;
}

bool bar_mistake_starts_as_held(int mistake)
{
    const BarMistake *row = bar_mistake_of(mistake);
    return row && row->starts_as_held;
}

const char *bar_mistake_sentence(int mistake)
{
    const BarMistake *row = bar_mistake_of(mistake);
    return row ? row->sentence : NULL;
}

bool bar_check_mistake(const BarDef *def, Status *status)
{
    BarMistake both;
    if (def->mistake_beside != 0 && !bar_mistakes_join(def->mistake, def->mistake_beside, &both))
        return status_refuse(status, "mpm.mistake: these two are no two mistakes");
    if (def->mistake == 0)
        return true;
    const BarMistake *row = bar_mistake_of(def->mistake);
    if (!row)
        return status_refuse(status, "mpm.mistake: %d is no choice (0 to %d)", def->mistake, MISTAKES);
    const char *other = def->algorithm != MPM_USF   ? "mpm.algorithm = usf"
                        : def->shape != MPM_HAT     ? "mpm.shape = hat"
                        : def->transfer != MPM_FLIP ? "mpm.transfer = flip"
                        : def->flip_fraction != 1.0 ? "mpm.flip_fraction = 1"
                        : def->mass_blend != 1.0    ? "mpm.mass_blend = 1"
                        : def->joint > 0.0          ? "bar2.joint = 0"
                        : def->forces               ? "the forces of [load]"
                                                    : NULL;
    return !other || status_refuse(status, "mpm.mistake: %s is defined for %s only",
                                   def->conceals_mistake ? "?" : row->id, other);
}

/* --- the numbers that such a code takes ------------------------------------------------------------- */

double bar_strain_span(const Bar *bar)
{
    const BarMistake *mistake = bar_mistake(bar);
    return mistake && mistake->no_span ? 1.0 : bar->dt;
}

double bar_slope_scale(const Bar *bar)
{
    const BarMistake *mistake = bar_mistake(bar);
    return mistake && mistake->no_spacing ? 1.0 : 1.0 / bar->dx;
}

double bar_force_volume(const Bar *bar, int particle)
{
    ASSERT_INDEX(particle, bar->n_particles);
    const BarMistake *mistake = bar_mistake(bar);
    const double volume = bar->volume[particle % bar->slots][particle / bar->slots];
    return mistake && mistake->volume ? mistake->volume(bar, particle, volume) : volume;
}

double bar_load_share(const Bar *bar)
{
    const BarMistake *mistake = bar_mistake(bar);
    return mistake && mistake->first_kick > 0.0 && bar->sim.step == 0 ? mistake->first_kick : 1.0;
}

double bar_force_share(const Bar *bar)
{
    const BarMistake *mistake = bar_mistake(bar);
    return mistake && mistake->pushes ? bar_load_share(bar) : -bar_load_share(bar);
}

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

/* All particles had the same share of a cell. */
static double volume_at_start(const Bar *bar, int particle, double volume)
{
    (void)particle, (void)volume;
    return bar->dx / bar->slots;
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
    out->does = a->does | b->does;
    out->holds = (BarHolds)holds;
    out->thinned = a->thinned ? a->thinned : b->thinned;
    out->volume = a->volume ? a->volume : b->volume;
    out->first_kick = fmax(a->first_kick, b->first_kick);
    out->moves = (BarMoves)moves;
    out->algorithm = (MpmAlgorithm)algorithm;
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

static bool does(const BarMistake *mistake, unsigned wrong)
{
    return mistake && (mistake->does & wrong) != 0;
}

bool bar_does(const Bar *bar, unsigned wrong)
{
    return does(bar_mistake(bar), wrong);
}

bool bar_mistake_is_of_start(int mistake)
{
    return does(bar_mistake_of(mistake), BAR_WRONG_OF_START);
}

bool bar_mistake_starts_as_held(int mistake)
{
    return does(bar_mistake_of(mistake), BAR_WRONG_STARTS_AS_HELD);
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
    return bar_does(bar, BAR_WRONG_NO_SPAN) ? 1.0 : bar->dt;
}

double bar_slope_scale(const Bar *bar)
{
    return bar_does(bar, BAR_WRONG_NO_SPACING) ? 1.0 : 1.0 / bar->dx;
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
    return bar_does(bar, BAR_WRONG_PUSHES) ? bar_load_share(bar) : -bar_load_share(bar);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mistakes of a bar's code: their rows, and the numbers that such a code takes (mistakes.h). */
#include "methods/mpm/mistakes.h"
#include "base/assertion.h"

#include <math.h>

/* --- the rows --------------------------------------------------------------------------------------- */

static double volume_of_cell(const Mpm *mpm, int particle, double volume)
{
    (void)particle;
    return volume * mpm->bar.particles_per_cell;
}

static double mass_for_volume(const Mpm *mpm, int particle, double volume)
{
    (void)volume;
    return mpm_mass(mpm, particle);
}

/* All particles had the same share of a cell. */
static double volume_at_start(const Mpm *mpm, int particle, double volume)
{
    (void)particle, (void)volume;
    return mpm->dx / mpm->bar.particles_per_cell;
}

static double no_volume(const Mpm *mpm, int particle, double volume)
{
    (void)mpm, (void)particle, (void)volume;
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
#include "methods/mpm/mistake_rows.inc"
#undef MISTAKE
};
enum { MISTAKES = sizeof mistakes / sizeof *mistakes };

const char *const bar_mistake_words[] = {
    "none",
#define MISTAKE(name, ...) name,
#include "methods/mpm/mistake_rows.inc"
#undef MISTAKE
    NULL,
};

static const BarMistake *mistake_of(int mistake)
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
    const BarMistake *a = mistake_of(one), *b = mistake_of(other);
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

const BarMistake *mpm_mistake_if(const Mpm *mpm, int mistake)
{
    return mpm->both ? mpm->both : mistake_of(mistake);
}

const BarMistake *mpm_mistake(const Mpm *mpm)
{
    return mpm_mistake_if(mpm, mpm->head->mistake);
}

static bool does(const BarMistake *mistake, unsigned wrong)
{
    return mistake && (mistake->does & wrong) != 0;
}

bool mpm_does(const Mpm *mpm, unsigned wrong)
{
    return does(mpm_mistake(mpm), wrong);
}

bool bar_mistake_is_of_start(int mistake)
{
    return does(mistake_of(mistake), WRONG_OF_START);
}

bool bar_mistake_starts_as_held(int mistake)
{
    return does(mistake_of(mistake), WRONG_STARTS_AS_HELD);
}

const char *bar_mistake_sentence(int mistake)
{
    const BarMistake *row = mistake_of(mistake);
    return row ? row->sentence : NULL;
}

bool bar_mistake_check(const BarDef *def, Status *status)
{
    BarMistake both;
    if (def->mistake_beside != 0 && !bar_mistakes_join(def->mistake, def->mistake_beside, &both))
        return status_refuse(status, "mpm.mistake: these two are no two mistakes");
    if (def->mistake == 0)
        return true;
    const BarMistake *row = mistake_of(def->mistake);
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

double mpm_strain_span(const Mpm *mpm)
{
    return mpm_does(mpm, WRONG_NO_SPAN) ? 1.0 : mpm->dt;
}

double mpm_slope_scale(const Mpm *mpm)
{
    return mpm_does(mpm, WRONG_NO_SPACING) ? 1.0 : 1.0 / mpm->dx;
}

double mpm_force_volume(const Mpm *mpm, int particle)
{
    ASSERT_INDEX(particle, mpm->n_particles);
    const BarMistake *mistake = mpm_mistake(mpm);
    const double volume = mpm->volume[particle];
    return mistake && mistake->volume ? mistake->volume(mpm, particle, volume) : volume;
}

double mpm_load_share(const Mpm *mpm)
{
    const BarMistake *mistake = mpm_mistake(mpm);
    return mistake && mistake->first_kick > 0.0 && mpm->sim.step == 0 ? mistake->first_kick : 1.0;
}

double mpm_force_share(const Mpm *mpm)
{
    return mpm_does(mpm, WRONG_PUSHES) ? mpm_load_share(mpm) : -mpm_load_share(mpm);
}

BarHolds mpm_holds(const Mpm *mpm)
{
    const BarMistake *mistake = mpm_mistake(mpm);
    return mistake ? mistake->holds : HOLDS_BEFORE_STRAIN;
}

BarMoves mpm_moves_by(const Mpm *mpm)
{
    const BarMistake *mistake = mpm_mistake(mpm);
    return mistake ? mistake->moves : MOVES_WITH_NODES;
}

double mpm_moving_velocity(const Mpm *mpm, int particle, int node)
{
    const BarMoves moves = mpm_moves_by(mpm);
    return moves == MOVES_BY_ITSELF        ? mpm->v[0][particle]
           : moves == MOVES_WITH_OLD_NODES ? mpm->velocity[0][node]
                                           : mpm->carry[0][node];
}

/* The stress before this step's strain is the one after it less E de: the nodes still have the velocities
 * that strained. */
double mpm_force_stress(const Mpm *mpm, int particle)
{
    MpmWeights w;
    double v[SHAPE_SUPPORT_MAX];
    const int base = mpm->base[particle];
    if (!mpm_does(mpm, WRONG_STRESS_BEFORE))
        return mpm->stress[0][particle];
    mpm_weights(mpm, 1, MPM_HAT, mpm->half, base, &mpm->s[0][particle], &w);
    mpm_line_velocities(MPM_HAT, mpm->velocity[0], mpm->inverse, base, v);
    const double de = mpm_strain_span(mpm) * mpm_slope_scale(mpm) * (w.dn[0][0] * v[0] + w.dn[0][1] * v[1]);
    return mpm->stress[0][particle] - mpm_modulus(mpm, particle) * de;
}

void mpm_kick_weights(const Mpm *mpm, int particle, int *base, double n[2])
{
    *base = mpm->base[particle];
    double s = mpm->s[0][particle], dn[2];
    if (mpm_does(mpm, WRONG_NEW_WEIGHTS)) {
        const double r = mpm->rest[0][particle] + mpm->u[0][particle] / mpm->dx; /* perhaps beyond the mesh */
        *base = (int)fmin(fmax(floor(r), 0.0), mpm->cells - 1.0);
        s = fmin(fmax(r - *base, 0.0), 1.0);
    }
    shape_at(MPM_HAT, mpm->half, mpm->cells, *base, s, n, dn);
}

double mpm_kick_at_new_place(const Mpm *mpm, int particle)
{
    double n[2];
    int base;
    mpm_kick_weights(mpm, particle, &base, n);
    return n[0] * mpm->kick[0][base] + n[1] * mpm->kick[0][base + 1];
}

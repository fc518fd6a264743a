/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mistakes of a bar's code: their rows, and the numbers that such a code takes (mistakes.h). */
#include "methods/mpm/mistakes.h"
#include "base/assertion.h"

#include <stdlib.h>
#include <string.h>

/* --- the rows --------------------------------------------------------------------------------------- */

/* Particles in a cell. */
static int in_a_cell(const Mpm *mpm)
{
    const int across = mpm->def.particles_per_cell;
    return mpm->dim == 1 ? mpm->def.particles_per_cell : across * across;
}

static double volume_of_cell(const Mpm *mpm, int particle, double volume)
{
    (void)particle;
    return volume * in_a_cell(mpm);
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
    return mpm->dx * (mpm->dim == 1 ? 1.0 : mpm->dx) / in_a_cell(mpm);
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

/* Sum N v d in units of dx^2/s, d = x_i - x. */
static double first_moment(const Mpm *mpm, const MpmWeights *w, int particle)
{
    double v[SHAPE_SUPPORT_MAX], sum = 0.0;
    const int base = mpm->base[particle];
    mpm_line_velocities(mpm->shape, mpm->carry[0], mpm->inverse, base, v);
    for (int a = 0; a < mpm->support; a++)
        sum += w->n[0][a] * v[a] *
               (shape_node_offset(mpm->shape, mpm_half(mpm, particle), mpm->cells, base, a) -
                mpm->s[0][particle]);
    return sum;
}

/* As if D were dx^2/4, which is that of quadratic B-splines. */
static double affine_of_bspline(const Mpm *mpm, const MpmWeights *w, int particle)
{
    return 4.0 * first_moment(mpm, w, particle) / mpm->dx;
}

static double affine_undivided(const Mpm *mpm, const MpmWeights *w, int particle)
{
    return first_moment(mpm, w, particle) * mpm->dx;
}

static const BarMistake mistakes[] = {
#define MISTAKE(name, op, words, line, ...)                                                                  \
    {.id = name, .sentence = words, .stage = op, .equation = line, __VA_ARGS__},
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

/* What a code does that makes two of them. False: they are one and the same thing done otherwise. */
static bool bar_mistakes_join(int one, int other, BarMistake *out)
{
    const BarMistake *a = mistake_of(one), *b = mistake_of(other);
    int holds, moves;
    if (!a || !b || a == b || (a->thinned && b->thinned) || (a->volume && b->volume) ||
        (a->box > 0 && b->box > 0) || (a->affine && b->affine) ||
        (fmax(a->slope_of_strain, a->slope_of_force) > 0 &&
         fmax(b->slope_of_strain, b->slope_of_force) > 0) ||
        !join((int)a->holds, (int)b->holds, &holds) || !join((int)a->moves, (int)b->moves, &moves))
        return false;
    *out = *a;
    if (!out->also_equation && b->stage != a->stage) {
        out->also = b->stage;
        out->also_equation = b->equation;
    }
    out->does = a->does | b->does;
    out->only = a->only | b->only;
    out->holds = (BarHolds)holds;
    out->thinned = a->thinned ? a->thinned : b->thinned;
    out->volume = a->volume ? a->volume : b->volume;
    out->first_kick = fmax(a->first_kick, b->first_kick);
    out->moves = (BarMoves)moves;
    out->slope_of_strain = fmax(a->slope_of_strain, b->slope_of_strain);
    out->slope_of_force = fmax(a->slope_of_force, b->slope_of_force);
    out->box = fmax(a->box, b->box);
    out->affine = a->affine ? a->affine : b->affine;
    return true;
}

const BarMistake *mpm_mistake_if(const Mpm *mpm, int mistake)
{
    return mpm->both ? mpm->both : mpm->bodies ? NULL : mistake_of(mistake);
}

const BarMistake *mpm_mistake(const Mpm *mpm)
{
    return mpm->head ? mpm_mistake_if(mpm, mpm->head->mistake) : NULL; /* a lattice alone has no state */
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

bool bar_mistake_check(const MpmDef *def, Status *status)
{
    const bool in_plane = def->problem != MPM_BAR;
    BarMistake both;
    if (def->mistake_beside != 0 && !bar_mistakes_join(def->mistake, def->mistake_beside, &both))
        return status_refuse(status, "mpm.mistake: these two cannot be combined");
    if (def->mistake == 0)
        return true;
    const BarMistake *row = def->mistake_beside != 0 ? &both : mistake_of(def->mistake);
    if (!row)
        return status_refuse(status, "mpm.mistake: %d is not a choice (0 to %d)", def->mistake, MISTAKES);
    const unsigned only = row->only;
    const char *other = (only & (ONLY_LINE | ONLY_APIC)) && in_plane       ? "bars"
                        : (only & ONLY_USF) && def->algorithm != MPM_USF   ? "mpm.algorithm = usf"
                        : (only & ONLY_MUSL) && def->algorithm != MPM_MUSL ? "mpm.algorithm = musl"
                        : (only & ONLY_HAT) && def->shape != MPM_HAT       ? "mpm.shape = hat"
                        : (only & ONLY_GIMP) && def->shape != MPM_GIMP     ? "mpm.shape = gimp"
                        : (only & ONLY_FLIP) && def->transfer != MPM_FLIP  ? "mpm.transfer = flip"
                        : (only & ONLY_APIC) && def->transfer != MPM_APIC  ? "mpm.transfer = apic"
                        : def->transfer == MPM_FMPM                        ? "mpm.transfer = flip or apic"
                        : row->box > 1 && def->particles_per_cell < 2 ? "mesh.particles_per_cell of 2 or more"
                        : !in_plane && def->mass_blend != 1.0         ? "mpm.mass_blend = 1"
                        : def->joint > 0.0                            ? "bar2.joint = 0"
                        : def->forces                                 ? "the forces of [load]"
                                                                      : NULL;
    return !other || status_refuse(status, "mpm.mistake: %s is defined for %s only",
                                   def->conceals_mistake ? "?" : row->id, other);
}

/* --- the numbers that such a code takes ------------------------------------------------------------- */

double mpm_strain_span(const Mpm *mpm)
{
    return mpm_does(mpm, WRONG_NO_SPAN) ? 1.0 : mpm->dt;
}

double mpm_slope_scale(const Mpm *mpm, MpmOp op)
{
    const BarMistake *mistake = mpm_mistake(mpm);
    const double wrong = !mistake          ? 0.0
                         : op == OP_STRAIN ? mistake->slope_of_strain
                                           : mistake->slope_of_force;
    return wrong > 0.0 ? wrong : 1.0 / mpm->dx;
}

double mpm_force_volume(const Mpm *mpm, int particle)
{
    ASSERT_INDEX(particle, mpm->n_particles);
    const BarMistake *mistake = mpm_mistake(mpm);
    const double volume =
        mpm_does(mpm, WRONG_VOLUME_LATE) ? mpm->kept_volume[particle] : mpm->volume[particle];
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

double mpm_moving_velocity(const Mpm *mpm, int axis, int particle, int node)
{
    const BarMoves moves = mpm_moves_by(mpm);
    const double kick = mpm->kick[axis][node], carry = mpm->carry[axis][node];
    return moves == MOVES_BY_ITSELF        ? mpm->v[axis][particle]
           : moves == MOVES_WITH_OLD_NODES ? carry - kick
           : moves == MOVES_WITH_MEAN      ? carry - 0.5 * kick
           : moves == MOVES_WITH_MAPPED    ? mpm->velocity[axis][node]
                                           : carry;
}

/* Eqs. 5 to 7: dt sym(sum v_i grad N_i), along a line dt sum N'_i v_i. */
void mpm_strain_step(const Mpm *mpm, int p, double e[MPM_STRESSES])
{
    const MpmWeights w = mpm_weights_of(mpm, p);
    const double rate = mpm_strain_span(mpm) * mpm_slope_scale(mpm, OP_STRAIN);
    double v[SHAPE_SUPPORT_MAX];
    e[0] = e[1] = e[2] = 0.0;
    if (mpm->dim == 1)
        mpm_line_velocities(mpm->shape, mpm->velocity[0], mpm->inverse, mpm->base[p], v);
    for (int b = 0; b < (mpm->dim == 1 ? 1 : mpm->support); b++)
        for (int a = 0; a < mpm->support; a++) {
            if (mpm->dim == 1) {
                e[0] += w.dn[0][a] * v[a];
                continue;
            }
            const int i = mpm->base[p] + b * mpm->gx + a;
            const double bx = w.dn[0][a] * w.n[1][b], by = w.n[0][a] * w.dn[1][b];
            const double x = mpm->bodies ? bodies_velocity_for(mpm, 0, i, p) : mpm->velocity[0][i];
            const double y = mpm->bodies ? bodies_velocity_for(mpm, 1, i, p) : mpm->velocity[1][i];
            e[0] += bx * x;
            e[1] += by * y;
            e[2] += by * x + bx * y;
        }
    for (int k = 0; k < MPM_STRESSES; k++)
        e[k] *= rate;
}

/* The stress before this step's strain is the one after it less D de: the nodes still have the velocities
 * that strained. In the plane it has turned. */
void mpm_force_stress(const Mpm *mpm, int particle, double stress[MPM_STRESSES])
{
    if (mpm_does(mpm, WRONG_STRESS_OF_NEXT) && particle + 1 < mpm->n_particles)
        particle++;
    for (int k = 0; k < (mpm->dim == 1 ? 1 : MPM_STRESSES); k++)
        stress[k] = mpm->stress[k][particle];
    if (!mpm_does(mpm, WRONG_STRESS_BEFORE))
        return;
    double e[MPM_STRESSES];
    mpm_strain_step(mpm, particle, e);
    if (mpm->dim == 1) {
        stress[0] -= mpm_modulus(mpm, particle) * e[0];
        return;
    }
    stress[0] -= mpm->D11 * e[0] + mpm->D12 * e[1];
    stress[1] -= mpm->D12 * e[0] + mpm->D11 * e[1];
    stress[2] -= mpm->slide * e[2];
}

void mpm_kick_weights(const Mpm *mpm, int particle, int *base, double n[SHAPE_SUPPORT_MAX])
{
    *base = mpm->base[particle];
    double s = mpm->s[0][particle], dn[SHAPE_SUPPORT_MAX];
    if (mpm_does(mpm, WRONG_NEW_WEIGHTS)) {
        const double r = mpm->rest[0][particle] + mpm->u[0][particle] / mpm->dx; /* perhaps beyond the mesh */
        *base = (int)fmin(fmax(floor(r), 0.0), ceil(mpm->high[0]) - 1.0);
        s = fmin(fmax(r - *base, 0.0), 1.0);
    }
    shape_at(mpm->shape, mpm_half(mpm, particle), mpm->cells, *base, s, n, dn);
}

double mpm_kick_at_new_place(const Mpm *mpm, int particle)
{
    double n[SHAPE_SUPPORT_MAX], sum = 0.0;
    int base;
    mpm_kick_weights(mpm, particle, &base, n);
    for (int a = 0; a < mpm->support; a++)
        sum += n[a] * mpm->kick[0][base + a];
    return sum;
}

void mpm_move_with_mapped(Mpm *mpm)
{
    for (int p = 0; mpm_moves_by(mpm) == MOVES_WITH_MAPPED && p < mpm->n_particles; p++) {
        const MpmWeights w = mpm_weights_of(mpm, p);
        for (int axis = 0; axis < mpm->dim; axis++) {
            double sum = 0.0;
            for (int b = 0; b < (mpm->dim == 1 ? 1 : mpm->support); b++)
                for (int a = 0; a < mpm->support; a++)
                    sum += w.n[0][a] * (mpm->dim == 1 ? 1.0 : w.n[1][b]) *
                           mpm->velocity[axis][mpm->base[p] + b * mpm->gx + a];
            mpm->u[axis][p] += mpm->dt * sum;
        }
    }
}

/* --- made and changed ------------------------------------------------------------------------------- */

bool mpm_take_both(Mpm *mpm, const MpmDef *def, Status *status)
{
    const int beside = def->problem == MPM_BODIES ? 0 : def->mistake_beside;
    mpm->both = beside ? malloc(sizeof *mpm->both) : NULL;
    return !beside || (mpm->both && bar_mistakes_join(def->mistake, beside, mpm->both)) ||
           status_fail(status, "not enough memory for two mistakes");
}

bool mpm_change_mistake(Mpm *mpm, int mistake, bool concealed, Status *status)
{
    const int before = mpm->head->mistake;
    if (mistake == before)
        return true;
    if (bar_mistake_is_of_start(mistake) || bar_mistake_is_of_start(before))
        return status_refuse(
            status, "mpm.mistake: %s is made at the start and holds for the whole run",
            concealed ? "?" : bar_mistake_words[bar_mistake_is_of_start(mistake) ? mistake : before]);
    if (does(mistake_of(mistake), WRONG_KEEPS_GRID | WRONG_VOLUME_LATE) && !mpm_can_keep(mpm))
        return status_refuse(status, "mpm.mistake: %s cannot begin in mid-run here: set it at the start",
                             concealed ? "?" : bar_mistake_words[mistake]);
    mpm->head->mistake = mistake;
    if (!mpm_can_keep(mpm))
        return true;
    memset(mpm->kept_mass, 0, (size_t)mpm->n_nodes * sizeof(double));
    for (int axis = 0; axis < mpm->dim; axis++)
        memset(mpm->kept_momentum[axis], 0, (size_t)mpm->n_nodes * sizeof(double));
    for (int p = 0; p < mpm->n_particles; p++)
        mpm->kept_volume[p] = mpm_does(mpm, WRONG_VOLUME_LATE) ? mpm->volume[p] : 0.0;
    return true;
}

void mpm_write_wrongly(const Mpm *mpm, Stage *stage, MpmOp op)
{
    const BarMistake *mistake = mpm_mistake(mpm);
    const bool also = mistake && mistake->also_equation && op == mistake->also;
    if (!mistake || mpm->def.conceals_mistake || (op != mistake->stage && !also))
        return;
    stage->sentence = mistake->sentence;
    stage->source = mpm->dim == 2 ? "the right code's line" : mistake->id;
    if (mpm->dim == 2) /* the wrong one is that of a bar */
        return;
    stage->equation = also ? mistake->also_equation : mistake->equation;
}

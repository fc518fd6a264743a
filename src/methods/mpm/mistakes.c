/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mistakes of codes: their rows, and the numbers that such a code takes (mistakes.h). */
#include "methods/mpm/mistakes.h"
#include "base/assertion.h"

#include <string.h>

/* --- the rows --------------------------------------------------------------------------------------- */

/* What it is defined for, beside lumped masses and one material; of FLIP also shares of PIC. */
enum { USF, MUSL, HAT, GIMP, FLIP, APIC, LINE, HYPOELASTIC, TURNING, CONTACT, TOUCHING };
#define ONLY(what) (1u << (what))

typedef struct Mistake {
    const char *id, *sentence;
    MpmOp stage;
    const char *equation; /* what differs between marks (STAGE_WRONG in method.h) */
    uint64_t does;        /* DOES() */
    unsigned only;        /* ONLY() */
    MpmOp also;           /* another stage that has it too, with its line; equation NULL: none */
    const char *also_equation;
} Mistake;

#define MISTAKE(name, op, words, line, ...)                                                                  \
    {.id = name, .sentence = words, .stage = op, .equation = line, .does = __VA_ARGS__},
static const Mistake mistakes[] = {
    {.id = "none"},
#include "methods/mpm/mistake_rows.inc"
};
static const Mistake of_bodies[] = {
    {.id = "none"},
#include "methods/mpm/bodies_mistake_rows.inc"
};
#undef MISTAKE

#define MISTAKE(name, ...) name,
const char *const mpm_mistake_words[] = {
    "none",
#include "methods/mpm/mistake_rows.inc"
    NULL,
};
const char *const mpm_body_mistake_words[] = {
    "none",
#include "methods/mpm/bodies_mistake_rows.inc"
    NULL,
};
#undef MISTAKE

static const Mistake *mistake_of(MpmProblem problem, int mistake)
{
    ASSERT_INDEX(mistake, problem == MPM_BODIES ? (int)(sizeof of_bodies / sizeof *of_bodies)
                                                : (int)(sizeof mistakes / sizeof *mistakes));
    return problem == MPM_BODIES ? &of_bodies[mistake] : &mistakes[mistake];
}

bool mpm_mistake_is_of_start(int mistake)
{
    return mistakes[mistake].does & DOES(OF_START);
}

bool mpm_mistake_starts_as_held(int mistake)
{
    return mistakes[mistake].does & DOES(STARTS_AS_HELD);
}

const char *mpm_mistake_sentence(int mistake)
{
    return mistakes[mistake].sentence;
}

const char *mpm_body_mistake_sentence(int mistake)
{
    return of_bodies[mistake].sentence;
}

/* Of each line a code does one thing: of two mistakes in it they are one and the same thing done otherwise.
 */
static const uint64_t alternatives[] = {
    DOES(BOX_WHOLE) | DOES(BOX_QUARTER),
    DOES(HOLDS_LATE) | DOES(HOLDS_NEVER),
    DOES(SLOPE_UNSCALED) | DOES(SLOPE_OF_STRAIN) | DOES(SLOPE_OF_FORCE),
    DOES(VOLUME_STAYS) | DOES(VOLUME_DIVIDED),
    DOES(VOLUME_OF_CELL) | DOES(VOLUME_IS_MASS) | DOES(VOLUME_OF_START) | DOES(NO_VOLUME),
    DOES(MOVES_BY_ITSELF) | DOES(MOVES_WITH_OLD) | DOES(MOVES_WITH_MEAN) | DOES(MOVES_WITH_MAPPED),
    DOES(AFFINE_OF_BSPLINE) | DOES(AFFINE_UNDIVIDED),
    DOES(SPIN_SIGN) | DOES(NO_ROTATION),
};

bool mpm_check_mistakes(const MpmDef *def, Status *status)
{
    const bool bodies = def->problem == MPM_BODIES, bar = def->problem == MPM_BAR;
    const char *const key = bodies ? "mpm.body_mistake" : "mpm.mistake";
    const Mistake *row = mistake_of(def->problem, def->mistake),
                  *beside = mistake_of(def->problem, def->mistake_beside);
    bool touching = def->n_bodies > 1, apart = row->does != 0 && row != beside;
    for (int wall = 0; wall < WALLS; wall++)
        touching = touching || def->walls[wall] != WALL_OPEN;
    for (size_t k = 0; k < sizeof alternatives / sizeof *alternatives; k++) {
        const uint64_t first = row->does & alternatives[k], second = beside->does & alternatives[k];
        apart = apart && (first == 0 || second == 0 || first == second);
    }
    const struct {
        unsigned only; /* 0: all */
        bool fits;
        const char *other;
    } conditions[] = {
        {ONLY(LINE) | ONLY(APIC), bar, "bars"},
        {ONLY(USF), def->algorithm == MPM_USF, "mpm.algorithm = usf"},
        {ONLY(MUSL), def->algorithm == MPM_MUSL, "mpm.algorithm = musl"},
        {ONLY(HAT), def->shape == MPM_HAT, "mpm.shape = hat"},
        {ONLY(GIMP), def->shape == MPM_GIMP, "mpm.shape = gimp"},
        {ONLY(HYPOELASTIC), def->law == LAW_HYPOELASTIC, "material.law = hypoelastic"},
        {ONLY(TURNING), def->rotation == ROTATION_JAUMANN, "mpm.rotation = jaumann"},
        {ONLY(CONTACT), def->fields == FIELDS_EACH && def->n_bodies > 1,
         "contact.fields = each and two bodies"},
        {ONLY(TOUCHING), touching, "walls or two bodies"},
        {ONLY(FLIP), def->transfer == MPM_FLIP, "mpm.transfer = flip"},
        {ONLY(APIC), def->transfer == MPM_APIC, "mpm.transfer = apic"},
        {0, !bar || def->transfer != MPM_FMPM, "mpm.transfer = flip or apic"},
        {0, !((row->does | beside->does) & DOES(BOX_WHOLE)) || def->particles_per_cell > 1,
         "mesh.particles_per_cell of 2 or more"},
        {0, !bar || def->mass_blend == 1.0, "mpm.mass_blend = 1"},
        {0, !bar || def->joint == 0.0, "bar2.joint = 0"},
        {0, !def->forces, "the forces of [load]"},
    };
    if (def->mistake_beside != 0 && !apart)
        return status_refuse(status, "%s: these two cannot be combined", key);
    for (size_t k = 0; def->mistake != 0 && k < sizeof conditions / sizeof *conditions; k++)
        if (!conditions[k].fits &&
            (conditions[k].only == 0 || (row->only | beside->only) & conditions[k].only))
            return status_refuse(status, "%s: %s is defined for %s only", key,
                                 def->conceals_mistake ? "?" : row->id, conditions[k].other);
    return true;
}

uint64_t mpm_wrong_with(const Mpm *mpm, int mistake)
{
    return mistake_of(mpm->def.problem, mistake)->does |
           mistake_of(mpm->def.problem, mpm->def.mistake_beside)->does;
}

/* --- the numbers that such a code takes ------------------------------------------------------------- */

double mpm_strain_span(const Mpm *mpm)
{
    return mpm_does(mpm, WRONG_NO_SPAN) ? 1.0 : mpm->dt;
}

double mpm_slope_scale(const Mpm *mpm, MpmOp op)
{
    return mpm_does(mpm, WRONG_SLOPE_UNSCALED)                                             ? 1.0
           : mpm_does(mpm, op == OP_STRAIN ? WRONG_SLOPE_OF_STRAIN : WRONG_SLOPE_OF_FORCE) ? 0.5
                                                                                           : 1.0 / mpm->dx;
}

double mpm_force_volume(const Mpm *mpm, int particle)
{
    ASSERT_INDEX(particle, mpm->n_particles);
    const int P = mpm->def.particles_per_cell, in_a_cell = mpm->dim == 1 ? P : P * P;
    const double volume =
        mpm_does(mpm, WRONG_VOLUME_LATE) ? mpm->kept_volume[particle] : mpm->volume[particle];
    return mpm_does(mpm, WRONG_VOLUME_OF_CELL)   ? volume * in_a_cell
           : mpm_does(mpm, WRONG_VOLUME_IS_MASS) ? mpm_mass(mpm, particle)
           : mpm_does(mpm, WRONG_VOLUME_OF_START) /* all particles had the same share of a cell */
               ? mpm->dx * (mpm->dim == 1 ? 1.0 : mpm->dx) / in_a_cell
               : mpm_does(mpm, WRONG_NO_VOLUME) ? 1.0 : volume;
}

double mpm_load_share(const Mpm *mpm)
{
    return mpm_does(mpm, WRONG_HALF_FIRST_KICK) && mpm->sim.step == 0 ? 0.5 : 1.0;
}

double mpm_force_share(const Mpm *mpm)
{
    return mpm_does(mpm, WRONG_PUSHES) ? mpm_load_share(mpm) : -mpm_load_share(mpm);
}

double mpm_moving_velocity(const Mpm *mpm, int axis, int particle, int node)
{
    const double kick = mpm->kick[axis][node], carry = mpm->carry[axis][node];
    return mpm_does(mpm, WRONG_MOVES_BY_ITSELF)     ? mpm->v[axis][particle]
           : mpm_does(mpm, WRONG_MOVES_WITH_OLD)    ? carry - kick
           : mpm_does(mpm, WRONG_MOVES_WITH_MEAN)   ? carry - 0.5 * kick
           : mpm_does(mpm, WRONG_MOVES_WITH_MAPPED) ? mpm->velocity[axis][node]
                                                    : carry;
}

double mpm_straining_velocity(const Mpm *mpm, int axis, int p, int node)
{
    double v[SHAPE_SUPPORT_MAX];
    if (mpm->dim == 2)
        return mpm->bodies && !(mpm->inverse[node] > 0.0) ? mpm->v[axis][p] : mpm->velocity[axis][node];
    mpm_line_velocities(mpm->shape, mpm->velocity[0], mpm->inverse, mpm->base[p], v);
    return v[node - mpm->base[p]];
}

/* Eqs. 5 to 7: dt sym(sum v_i grad N_i), along a line dt sum N'_i v_i. */
void mpm_strain_step(const Mpm *mpm, int p, double e[MPM_STRESSES])
{
    const MpmWeights w = mpm_weights_of(mpm, p);
    const double rate = mpm_strain_span(mpm) * mpm_slope_scale(mpm, OP_STRAIN);
    e[0] = e[1] = e[2] = 0.0;
    for (int b = 0; b < mpm_across(mpm); b++)
        for (int a = 0; a < mpm->support; a++) {
            const int i = mpm->base[p] + b * mpm->gx + a;
            const double bx = w.dn[0][a] * w.n[1][b], by = w.n[0][a] * w.dn[1][b];
            const double x = mpm_straining_velocity(mpm, 0, p, i);
            const double y = mpm->dim == 2 ? mpm_straining_velocity(mpm, 1, p, i) : 0.0;
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
    const double r = mpm->rest[0][particle] + mpm->u[0][particle] / mpm->dx; /* perhaps beyond the mesh */
    double s, dn[SHAPE_SUPPORT_MAX];
    *base = (int)fmin(fmax(floor(r), 0.0), ceil(mpm->high[0]) - 1.0);
    s = fmin(fmax(r - *base, 0.0), 1.0);
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
    for (int p = 0; mpm_does(mpm, WRONG_MOVES_WITH_MAPPED) && p < mpm->n_particles; p++) {
        const MpmWeights w = mpm_weights_of(mpm, p);
        for (int axis = 0; axis < mpm->dim; axis++) {
            double sum = 0.0;
            for (int b = 0; b < mpm_across(mpm); b++)
                for (int a = 0; a < mpm->support; a++)
                    sum += w.n[0][a] * w.n[1][b] * mpm->velocity[axis][mpm->base[p] + b * mpm->gx + a];
            mpm->u[axis][p] += mpm->dt * sum;
        }
    }
}

/* --- changed, and shown ------------------------------------------------------------------------------ */

bool mpm_change_mistake(Mpm *mpm, int mistake, Status *status)
{
    const int before = mpm->head->mistake;
    const bool concealed = mpm->def.conceals_mistake;
    if (mistake == before)
        return true;
    if (mpm_mistake_is_of_start(mistake) || mpm_mistake_is_of_start(before))
        return status_refuse(
            status, "mpm.mistake: %s is made at the start and holds for the whole run",
            concealed ? "?" : mpm_mistake_words[mpm_mistake_is_of_start(mistake) ? mistake : before]);
    if ((mistakes[mistake].does & (DOES(KEEPS_GRID) | DOES(VOLUME_LATE))) && !mpm_can_keep(mpm))
        return status_refuse(status, "mpm.mistake: %s cannot begin in mid-run here: set it at the start",
                             concealed ? "?" : mpm_mistake_words[mistake]);
    mpm->head->mistake = mistake;
    mpm->wrong = mpm_wrong_with(mpm, mistake);
    if (!mpm_can_keep(mpm))
        return true;
    memset(mpm->block + mpm->bytes_apic, 0, mpm->bytes_kept - mpm->bytes_apic);
    for (int p = 0; p < mpm->n_particles; p++)
        mpm->kept_volume[p] = mpm_does(mpm, WRONG_VOLUME_LATE) ? mpm->volume[p] : 0.0;
    return true;
}

void mpm_write_wrongly(const Mpm *mpm, Stage *stage, MpmOp op)
{
    const Mistake *mistake = mistake_of(mpm->def.problem, mpm->head->mistake);
    const bool also = mistake->also_equation && op == mistake->also;
    if (mpm->head->mistake == 0 || mpm->def.conceals_mistake || (op != mistake->stage && !also))
        return;
    stage->sentence = mistake->sentence;
    stage->source = mistake->id;
    if (mpm->def.problem == MPM_BEAM) /* the wrong line is that of a bar */
        stage->source = "the right code's line";
    else
        stage->equation = also ? mistake->also_equation : mistake->equation;
}

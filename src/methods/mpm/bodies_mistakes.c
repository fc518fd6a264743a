/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mistakes of a code for bodies, one a row: what differs stands between » and «. What each does is asked
 * by the stages (bodies_does). */
#include "methods/mpm/engine.h"

/* What a mistake is defined for. */
enum { ONLY_TURNING = 1, ONLY_HYPOELASTIC = 2, ONLY_CONTACT = 4, ONLY_PLAIN_FLIP = 8, ONLY_TOUCHING = 16 };

typedef struct BodiesMistakeRow {
    const char *sentence;
    MpmOp stage;
    const char *equation;
    unsigned only;
} BodiesMistakeRow;

const char *const bodies_mistake_words[] = {
    [BODIES_RIGHT] = "none",
    [BODIES_SPIN_SIGN] = "spin_sign",
    [BODIES_NO_ROTATION] = "no_rotation",
    [BODIES_TENSOR_SHEAR] = "tensor_shear",
    [BODIES_VOLUME_KEPT] = "body_volume_kept",
    [BODIES_NORMAL_OF_ONE] = "normal_of_one",
    [BODIES_START_AFTER_CONTACT] = "start_after_contact",
    [BODIES_NO_FIRST_FIX] = "no_first_fix",
    NULL,
};

static const BodiesMistakeRow mistakes[BODIES_MISTAKES] = {
    [BODIES_SPIN_SIGN] = {"The stress is turned against the way that the body turns.", OP_STRAIN,
                          "Δω = Δt »(∂u/∂y - ∂v/∂x)«/2      σ ← Q σ Qᵀ + D Δt sym L", ONLY_TURNING},
    [BODIES_NO_ROTATION] = {"The stress does not turn with the body.", OP_STRAIN,
                            "L = Σ v_i ⊗ ∇N_i      σ ← »σ« + D Δt sym L", ONLY_TURNING},
    [BODIES_TENSOR_SHEAR] = {"G is multiplied with the tensor's shear strain, half of the angle.", OP_STRAIN,
                             "σ_xy ← σ_xy + G Δt (∂u/∂y + ∂v/∂x)»/2«", ONLY_HYPOELASTIC},
    [BODIES_VOLUME_KEPT] = {"A particle keeps the volume that it had at the start.", OP_STRAIN,
                            "σ ← Q σ Qᵀ + D Δt sym L      V ← »V«", ONLY_HYPOELASTIC},
    [BODIES_NORMAL_OF_ONE] = {"The normal of contact is that of one body alone.", OP_FIX,
                              "contact: n = n_a/|n_a|»  , not of n_a - n_b«", ONLY_CONTACT},
    [BODIES_START_AFTER_CONTACT] = {"Particles take their change from p after the first fix: "
                                    "they miss its impulse.",
                                    OP_FIX, "q0 = q »after walls and contact«",
                                    ONLY_PLAIN_FLIP | ONLY_TOUCHING},
    [BODIES_NO_FIRST_FIX] = {"Walls and contact act only after the force.", OP_FIX,
                             "q ← »q«,   walls and contact »after the force only«", ONLY_TOUCHING},
};

const char *bodies_mistake_sentence(int mistake)
{
    return mistake > 0 && mistake < BODIES_MISTAKES ? mistakes[mistake].sentence : NULL;
}

static bool touches(const MpmDef *def)
{
    bool any = def->n_bodies > 1;
    for (int wall = 0; wall < WALLS; wall++)
        any = any || def->walls[wall] != WALL_OPEN;
    return any;
}

static const char *missing_for(const MpmDef *def, unsigned only)
{
    const bool hypoelastic = def->law == LAW_HYPOELASTIC;
    return only & (ONLY_TURNING | ONLY_HYPOELASTIC) && !hypoelastic   ? "material.law = hypoelastic"
           : only & ONLY_TURNING && def->rotation != ROTATION_JAUMANN ? "mpm.rotation = jaumann"
           : only & ONLY_CONTACT && !(def->fields == FIELDS_EACH && def->n_bodies > 1)
               ? "contact.fields = each and two bodies"
           : only & ONLY_TOUCHING && !touches(def)               ? "walls or two bodies"
           : only & ONLY_PLAIN_FLIP && def->transfer != MPM_FLIP ? "mpm.transfer = flip"
                                                                 : NULL;
}

bool bodies_mistake_check(const MpmDef *def, Status *status)
{
    const int made[2] = {def->mistake, def->mistake_beside};
    if (made[1] != 0 &&
        (made[0] == made[1] || (made[0] <= BODIES_NO_ROTATION && made[1] <= BODIES_NO_ROTATION)))
        return status_refuse(status, "mpm.body_mistake: these two cannot be combined");
    for (int k = 0; k < 2; k++) {
        if (made[k] < 0 || made[k] >= BODIES_MISTAKES)
            return status_refuse(status, "mpm.body_mistake: %d is not a choice (0 to %d)", made[k],
                                 BODIES_MISTAKES - 1);
        const char *other = missing_for(def, mistakes[made[k]].only);
        if (other)
            return status_refuse(status, "mpm.body_mistake: %s is defined for %s only",
                                 def->conceals_mistake ? "?" : bodies_mistake_words[made[k]], other);
    }
    return true;
}

void bodies_write_wrongly(const Mpm *mpm, MpmOp op, Stage *stage)
{
    const int mistake = mpm->def.mistake;
    if (mistake == 0 || mpm->def.conceals_mistake || mistakes[mistake].stage != op)
        return;
    stage->equation = mistakes[mistake].equation;
    stage->source = bodies_mistake_words[mistake];
    stage->sentence = mistakes[mistake].sentence;
}

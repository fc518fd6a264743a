/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What acts on the bar from outside, eq. 11, a row for each term:
 *
 *     f_ext(i) = sum over p of N_i(p) (m b + t V/h + ...)        V = m/rho
 *
 * Equation, names and note of the force stage are made of the rows that are at work, so that the screen
 * cannot show another force than the one that acts. */
#include "base/assertion.h"
#include "base/text.h"
#include "methods/mpm/engine.h"

#include <string.h>

static double body_force(const Simulation *sim, size_t particle, int axis, const void *context)
{
    (void)context, (void)axis;
    const Mpm *mpm = mpm_of_const(sim);
    return mpm_mass(mpm, (int)particle) * mpm->head->body_force;
}

static double traction(const Simulation *sim, size_t particle, int axis, const void *context)
{
    (void)context, (void)axis;
    const Mpm *mpm = mpm_of_const(sim);
    const int p = (int)particle;
    const int side = (p >= mpm->n_particles - mpm->layer_right) - (p < mpm->layer_left);
    return side * mpm->head->traction * mpm->volume[p] / mpm->layer;
}

static const ForceTerm of_body = {
    .name = "body force", .equation = "Σ N_i m_p b", .load = "m b", .on = body_force};
static const ForceTerm of_traction = {
    .name = "traction", .equation = "Σ N_i t m_p/(ρ_p h)", .load = "t V/h", .on = traction};

ForceTerms mpm_forces(const Mpm *mpm)
{
    ForceTerms forces = {0};
    if (mpm->head->body_force != 0.0)
        forces_add(&forces, &of_body);
    if (mpm->head->traction != 0.0)
        forces_add(&forces, &of_traction);
    forces_add_all(&forces, mpm->def.forces);
    return forces;
}

double mpm_load_on(const Mpm *mpm, int particle)
{
    ASSERT_INDEX(particle, mpm->n_particles);
    const ForceTerms forces = mpm_forces(mpm);
    return forces_on(&forces, &mpm->sim, (size_t)particle, 0);
}

/* --- what is said of them ------------------------------------------------------------------------- */

static size_t columns_of(const char *text)
{
    size_t columns = 0;
    for (; *text; text++)
        columns += ((unsigned char)*text & 0xc0) != 0x80;
    return columns;
}

/* "f_int = ...    f_ext = A + B", the second in a line of its own where both are too long for one, then the
 * stage's own equation, in which f_ext stands only if there is one. */
void mpm_word_forces(Mpm *mpm, Stage *stage)
{
    enum { LINE = 76 };
    static const char internal[] = "f_int = -Σ N_i′ σ_p m_p/ρ_p", second[] = " + f_ext";
    const ForceTerms forces = mpm_forces(mpm);
    ForceWords *words = &mpm->force_words, terms;
    const char *const whole = stage->equation, *const at = strstr(whole, second);
    forces_word(&forces, &terms);
    *words = terms;
    words->equation[0] = '\0';
    const bool fits = columns_of(internal) + columns_of("    f_ext = ") + columns_of(terms.equation) <= LINE;
    if (*terms.equation)
        text_append(words->equation, sizeof words->equation, "%s%sf_ext = %s\n%s", internal,
                    fits ? "    " : "\n", terms.equation, whole);
    else
        text_append(words->equation, sizeof words->equation, "%s\n%.*s%s", internal,
                    (int)(at ? at - whole : 0), whole, at ? at + strlen(second) : whole);
    stage->equation = words->equation;
}

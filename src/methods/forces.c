/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Terms of the external force, and what is said of those at work. */
#include "methods/forces.h"

#include "base/assertion.h"
#include "base/text.h"

#include <string.h>

void forces_add(ForceTerms *forces, const ForceTerm *term)
{
    ASSERT_INT(forces->count, <, FORCE_TERMS_MAX);
    forces->terms[forces->count++] = term;
}

void forces_add_all(ForceTerms *forces, const ForceTerm *terms)
{
    for (; terms && terms->name; terms++)
        forces_add(forces, terms);
}

double forces_on(const ForceTerms *forces, const Simulation *sim, size_t particle, int axis)
{
    ASSERT_INDEX(axis, sim->dimensions);
    ASSERT_INDEX(particle, sim->counts[0]);
    double force = 0;
    for (int i = 0; i < forces->count; i++)
        force += forces->terms[i]->on(sim, particle, axis, forces->terms[i]->context);
    return force;
}

double forces_of_definition(const ForceTerm *terms, const Simulation *sim, size_t particle, int axis)
{
    ForceTerms forces = {0};
    forces_add_all(&forces, terms);
    return forces_on(&forces, sim, particle, axis);
}

void forces_word(const ForceTerms *forces, ForceWords *words)
{
    memset(words, 0, sizeof *words);
    text_append(words->meaning, sizeof words->meaning, "force of %s",
                forces->count > 0 ? "" : "the loads: none acts");
    for (int i = 0; i < forces->count; i++) {
        const ForceTerm *term = forces->terms[i];
        const char *plus = i > 0 ? " + " : "";
        text_append(words->equation, sizeof words->equation, "%s%s", plus, term->equation);
        text_append(words->load, sizeof words->load, "%s%s", i > 0 ? plus : "load = ", term->load);
        text_append(words->meaning, sizeof words->meaning, "%s%s", i > 0 ? " and " : "", term->name);
        if (term->sentence)
            text_append(words->sentence, sizeof words->sentence, "%s%s", *words->sentence ? " " : "",
                        term->sentence);
    }
}

void forces_word_stage(const ForceTerms *forces, ForceWords *words, Stage *stage)
{
    ForceWords of;
    forces_word(forces, &of);
    *words = of;
    if (forces->count == 0) {
        stage->equation = "no load acts: f(i) stays";
        stage->sentence = "Without loads the bonds' force is all that a node feels.";
        return;
    }
    words->equation[0] = '\0';
    text_append(words->equation, sizeof words->equation, "f(i) += %s", of.equation);
    stage->equation = words->equation;
    stage->sentence =
        *words->sentence ? words->sentence : "What acts from outside is added to the bonds' force.";
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The references of a run (references.h): made by its solver, then read by whatever shows, writes or judges
 * the run. */
#include "base/assertion.h"
#include "scenario/settings.h"
#include "base/text.h"
#include "answers/references.h"
#include "problems/solver.h"
#include "scenario/parameters.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

References *references_create(const Settings *settings, const Simulation *sim, Status *status)
{
    const Solver *solver = problem_allows(settings->problem, settings->method, status)
                               ? problem_solver(settings->problem, settings->method)
                               : NULL;
    if (!solver)
        return NULL;
    References *refs = calloc(1, sizeof *refs);
    if (!refs) {
        status_fail(status, "not enough memory for the reference solutions");
        return NULL;
    }
    static const Quantity step = {"step", "step", "1", "whole time steps done"};
    Quantity time = {"time", "t", settings->problem->unit_of_time, "step * dt"};
    refs->solver = solver;
    for (int i = 0; i < REFERENCES; i++)
        refs->unaccounted[i] = answer_invalid_because(settings, (Reference)i);
    refs->dt = sim->dt;
    plan_answer(refs, &step, COLUMN_MEASURED, NULL, NULL);
    plan_answer(refs, &time, COLUMN_MEASURED, NULL, NULL);
    if (solver->prepare && !solver->prepare(refs, settings, sim, status)) {
        references_destroy(refs);
        return NULL;
    }
    plan_rest_of_method(refs, sim);
    return refs;
}

void references_destroy(References *refs)
{
    if (!refs)
        return;
    if (refs->own && refs->release)
        refs->release(refs->own);
    free(refs->own);
    free(refs->window.values);
    free(refs);
}

int references_columns(const References *refs, Column columns[COLUMNS_MAX])
{
    for (int i = 0; i < refs->n_columns; i++)
        columns[i] = refs->plan[i].column;
    return refs->n_columns;
}

int references_column(const Column *columns, int count, const char *name)
{
    for (int i = 0; i < count; i++)
        if (strcmp(columns[i].quantity.name, name) == 0)
            return i;
    return -1;
}

Finding finding_named(const Finding *findings, int count, const char *name)
{
    for (int i = 0; i < count; i++)
        if (strcmp(findings[i].name, name) == 0)
            return findings[i];
    return (Finding){.measured = NAN, .exact = NAN};
}

long references_memory(const References *refs)
{
    return refs->window.size;
}

void references_reset(References *refs)
{
    refs->window.filled = refs->window.next = 0;
}

static void fill_row(References *refs, long step, double time, const double *method_row,
                     const double *earlier, double *row)
{
    row[0] = (double)step;
    row[1] = time;
    for (int i = 2; i < refs->n_columns; i++) {
        const PlannedColumn *planned = &refs->plan[i];
        ASSERT(planned->answer || planned->from_method >= 0);
        if (!planned->answer)
            row[i] = method_row[planned->from_method];
        else if (planned->remembers && earlier)
            row[i] = earlier[i];
        else
            row[i] = planned->answer(refs, step, time, method_row);
    }
}

void references_row(References *refs, long step, double time, const double *method_row, double *row)
{
    ASSERT_INT(step, >=, 0);
    Window *window = &refs->window;
    if (window->size > 0) {
        window->values[window->next] = method_row[window->of];
        window->next = (window->next + 1) % window->size;
        window->filled += window->filled < window->size;
    }
    fill_row(refs, step, time, method_row, NULL, row);
}

void references_row_again(References *refs, long step, double time, const double *method_row,
                          const double *earlier, double *row)
{
    ASSERT_INT(step, >=, 0);
    fill_row(refs, step, time, method_row, earlier, row);
}

double references_profile(const References *refs, const char *field, double x, double time)
{
    const Solver *solver = refs->solver;
    return solver->profile && !refs->unaccounted[REFERENCE_EXACT] ? solver->profile(refs, field, x, time)
                                                                  : NAN;
}

double references_section(const References *refs, const char *field, double x, double y, double time)
{
    const Solver *solver = refs->solver;
    return solver->section && !refs->unaccounted[REFERENCE_EXACT] ? solver->section(refs, field, x, y, time)
                                                                  : NAN;
}

double references_envelope(const References *refs, const char *column, double time)
{
    const Solver *solver = refs->solver;
    return solver->envelope && !refs->unaccounted[REFERENCE_EXACT] ? solver->envelope(refs, column, time)
                                                                   : NAN;
}

double references_standing_frequency(const References *refs, double time)
{
    const Solver *solver = refs->solver;
    return solver->standing_frequency && !refs->unaccounted[REFERENCE_FREQUENCY]
               ? solver->standing_frequency(refs, time)
               : NAN;
}

int references_findings(const References *refs, const Simulation *sim, Finding out[FINDINGS_MAX])
{
    const Solver *solver = refs->solver;
    const int count = solver && solver->findings ? solver->findings(refs, sim, out) : 0;
    int n = 0;
    for (int i = 0; i < count; i++) {
        if (refs->unaccounted[REFERENCE_EXACT] && out[i].exact == 0)
            continue; /* an error of what is not known */
        out[n] = out[i];
        if (refs->unaccounted[REFERENCE_EXACT])
            out[n].exact = NAN;
        n++;
    }
    return n;
}

void findings_text(const Finding *findings, int n_findings, bool with_exact, char *out, size_t size)
{
    ASSERT_INT(n_findings, <=, FINDINGS_MAX);
    out[0] = '\0';
    for (int i = 0; i < n_findings; i++) {
        const Finding *finding = &findings[i];
        text_append(out, size, "%s%s %s", i ? "  " : "", finding->label,
                    isfinite(finding->measured) ? text_rounded(finding->measured, 4).text
                    : finding->missing          ? finding->missing
                                                : "not yet");
        if (with_exact && isfinite(finding->exact) && finding->exact != 0)
            text_append(out, size, " (%s %s)", finding->word ? finding->word : "exact",
                        text_rounded(finding->exact, 4).text);
    }
}

int references_thickness_lines(const References *refs, double out[THICKNESS_LINES_MAX])
{
    const Solver *solver = refs->solver;
    return solver->thickness_lines && !refs->unaccounted[REFERENCE_PREDICTED]
               ? solver->thickness_lines(refs, out)
               : 0;
}

/* Whether a reference accounts for a run (references.h): every row of the parameter table whose value is not
 * neutral must be in the list that the solver gave for that reference, and so must every parameter that is
 * changed in mid-run. */

static bool is_at_work(const Settings *settings, const Parameter *parameter)
{
    return !parameter->output && parameter_applies_to(settings, parameter) &&
           settings_are_at_work(settings, parameter);
}

/* NULL: the reference does not exist. */
static const Validity *validity_of(const Settings *settings, Reference reference)
{
    const Solver *solver = problem_solver(settings->problem, settings->method);
    return solver && solver->validity[reference].keys ? &solver->validity[reference] : NULL;
}

const char *answer_unlisted_now(const Settings *settings, Reference reference)
{
    const Validity *known = validity_of(settings, reference);
    for (int i = 0; known && i < n_parameters; i++)
        if (text_place_in(parameters[i].key, known->keys) < 0 && is_at_work(settings, &parameters[i]))
            return parameters[i].key;
    return NULL;
}

const char *answer_unaccounted_now(const Settings *settings, Reference reference)
{
    const Validity *known = validity_of(settings, reference);
    const char *key = answer_unlisted_now(settings, reference);
    if (key)
        return key;
    const Solver *solver = known ? problem_solver(settings->problem, settings->method) : NULL;
    return solver && solver->unaccounted ? solver->unaccounted(settings, reference) : NULL;
}

const char *answer_invalid_because(const Settings *settings, Reference reference)
{
    const Validity *known = validity_of(settings, reference);
    for (int i = 0; known && i < settings->n_changes; i++)
        if (text_place_in(settings->changes[i].to.key, known->changes) < 0) {
            const Parameter *parameter = parameter_find(settings->changes[i].to.key);
            return parameter ? parameter->key : NULL;
        }
    return answer_unaccounted_now(settings, reference);
}

bool answers_known_text(const Settings *settings, char out[KNOWN_TEXT_MAX], long *step)
{
    const char *const names[REFERENCES] = {settings->problem->answer, "predicted", "frequency", "energy E*"};
    const char *unaccounted = NULL;
    out[0] = '\0';
    for (int i = 0; i < REFERENCES; i++) {
        const char *key = answer_invalid_because(settings, (Reference)i);
        unaccounted = unaccounted ? unaccounted : key;
        if (key && strcmp(key, unaccounted) == 0)
            text_list_add(out, KNOWN_TEXT_MAX, names[i]);
    }
    if (!unaccounted)
        return false;
    text_append(out, KNOWN_TEXT_MAX, ": not known with %s", unaccounted);
    if (step)
        *step = 0;
    const Parameter *parameter = parameter_find(unaccounted);
    for (int i = settings->n_changes - 1; step && !is_at_work(settings, parameter) && i >= 0; i--)
        if (strcmp(settings->changes[i].to.key, unaccounted) == 0)
            *step = settings->changes[i].step;
    return true;
}

/* E*, the energy that a scheme keeps to round-off while kinetic + strain ripples: hands the
 * questions on to the solver; the sums are in bar_answers.c. With USF E* = sum m v^n
 * v^{n+1}/2 + strain(stress^{n+1}). */

bool references_have_invariant(const Settings *settings)
{
    const Solver *solver = problem_solver(settings->problem, settings->method);
    return solver && solver->invariant && solver->invariant_kept(settings) &&
           !answer_unaccounted_now(settings, REFERENCE_ENERGY);
}

double references_invariant(Simulation *sim, const Settings *settings)
{
    ASSERT_INT(sim->stage, ==, 0);
    const Solver *solver = problem_solver(settings->problem, settings->method);
    return solver && solver->invariant ? solver->invariant(sim, settings) : NAN;
}

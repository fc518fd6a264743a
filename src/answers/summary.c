/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The words at the end of a run (summary.h): measured frequency beside predicted and exact, change of the
 * energy, crack. Written from a RunSummary by `matvib run`, from a live experiment by the laboratory. */
#include "answers/summary.h"
#include "base/assertion.h"
#include "scenario/settings.h"
#include "base/text.h"
#include "answers/references.h"
#include "scenario/parameters.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define ENERGY_TOLD 10.0 /* per cent that a sound run does not oscillate by */

/* The mean over `count` rows of total less work: what a scheme without loss keeps. */
static double mean_energy(const double *rows, size_t count, int n_columns, int total, int work)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        const double *row = rows + i * (size_t)n_columns;
        sum += row[total] - (work >= 0 ? row[work] : 0);
    }
    return sum / (double)count;
}

/* The time over which means are taken: one period, in which kinetic and strain energy change places twice, so
 * that a scheme's oscillation of the total at twice the frequency averages out; a tenth of the run where
 * there is none. */
static double span_of(RunSummary *summary, double end)
{
    const Readout *readout = &summary->readout;
    const double turn = readout->predicted_known ? readout->predicted : readout->exact;
    const double period = readout->is_period ? turn : 2 * M_PI / turn;
    const bool known = readout->moving && readout->exact_known && !readout->drifting && period > 0;
    summary->energy_measure = known && end >= period ? ENERGY_PERIOD : ENERGY_TENTH;
    return summary->energy_measure == ENERGY_PERIOD ? period : end / 10;
}

/* How much the energy has changed, in percent. E* (references.h) where it exists, for it does not oscillate;
 * else
 *
 *     100 (mean of the last span - mean of the first)/(mean of the first)
 *
 * of total less work, unless that is not part of its balance. A run that begins at rest has nothing at first,
 * one that is struck next to nothing: then it is a share of the largest work done. Weight does work where the
 * total has a potential, whose zero is anywhere: what it has lost. rows: count x n_columns;
 * nothing is set where there is no energy to speak of. */
static void take_energy(RunSummary *summary, const Simulation *sim, const Column *columns, int n_columns,
                        const double *rows, size_t count, const double invariant[2])
{
    const size_t width = (size_t)n_columns;
    const int total = references_column(columns, n_columns, "total");
    const int work =
        simulation_has(sim, HAS_RELATIVE_ENERGY) ? -1 : references_column(columns, n_columns, "work");
    if (invariant[0] > 0 && isfinite(invariant[1])) {
        summary->energy_measure = ENERGY_INVARIANT;
        summary->energy_change = 100 * (invariant[1] / invariant[0] - 1);
        return;
    }
    if (total < 0 || count == 0)
        return;
    const int potential = references_column(columns, n_columns, "potential"),
              worked = potential < 0 ? work : potential;
    const double level = potential < 0 ? 0 : rows[potential], start = rows[total] - level;
    double largest = 0;
    /* the work of a load oscillates with the body, so the largest is taken, not that at the end */
    for (size_t i = 0; i < count && worked >= 0; i++)
        largest = fmax(largest, fabs(rows[i * width + (size_t)worked] - level));
    summary->energy_of_work = !(start > 0) || largest > start;
    if (summary->energy_of_work && !(largest > 0))
        return;
    /* by the material point method it is that of the nodes' velocity at the end of the step */
    summary->energy_of_ahead = summary->energy_of_work && potential < 0 && simulation_has(sim, HAS_MESH);
    const double end = rows[(count - 1) * width + 1], span = span_of(summary, end) * (1 - 1e-9);
    size_t first = 1, last = 1;
    while (first < count && rows[first * width + 1] < span)
        first++;
    while (last < count && rows[(count - last - 1) * width + 1] > end - span)
        last++;
    const double before = mean_energy(rows, first, n_columns, total, work);
    const double after = mean_energy(rows + (count - last) * width, last, n_columns, total, work);
    summary->energy_change = 100 * (after - before) / (summary->energy_of_work ? largest : before - level);
    const int kinetic = references_column(columns, n_columns, "kinetic");
    summary->energy_of_feed =
        summary->readout.drifting && kinetic >= 0 && rows[kinetic] > 0.5 * fabs(rows[total]);
    double most = rows[total];
    for (size_t i = 0; i < count; i++)
        most = fmax(most, mean_energy(rows + i * width, 1, n_columns, total, work));
    summary->energy_most = summary->energy_of_work ? 0 : 100 * (most - rows[total]) / start;
}

void summary_rows(RunSummary *summary, const Simulation *sim, const Column *columns, int n_columns,
                  const double *rows, size_t count, const double invariant[2])
{
    ASSERT_INT(n_columns, <=, COLUMNS_MAX);
    take_energy(summary, sim, columns, n_columns, rows, count, invariant);
    summary->at_rest = sim->at_rest;
    const double *last = count > 0 ? rows + (count - 1) * (size_t)n_columns : NULL;
    const int broken = references_column(columns, n_columns, "broken_bonds");
    const int length = references_column(columns, n_columns, "crack_length");
    summary->broken_bonds = last && broken >= 0 ? last[broken] : NAN;
    summary->crack_length = last && length >= 0 ? last[length] : NAN;
}

void summary_crack(RunSummary *summary, const Simulation *sim, const Settings *settings)
{
    summary->crack_known = crack_facts(sim, &summary->crack);
    CrackFronts fronts = {.count = 0};
    summary->fronts_known = crack_fronts_update(&fronts, sim);
    if (summary->fronts_known)
        crack_fronts_facts(&fronts, &summary->fronts);
    summary->price_known = (summary->crack_known || summary->fronts_known) &&
                           crack_price(sim, settings, summary->fronts_known ? &fronts : NULL,
                                       &settings->cancel, &summary->price);
    crack_fronts_free(&fronts);
    if (summary->crack_known || summary->fronts_known)
        summary->rayleigh_speed = crack_rayleigh_speed(settings);
}

/* All of it from a live run, at the step on screen; what follows from rows is that of the newest step. */
void summary_of(const Experiment *experiment, RunSummary *summary)
{
    const Record *record = experiment_record(experiment);
    const Simulation *sim = experiment_simulation(experiment);
    int n;
    const Column *columns = experiment_columns(experiment, &n);
    *summary = (RunSummary){0};
    summary->mistake = settings_mistake(experiment_settings(experiment));
    summary->dt = sim->dt;
    summary->steps = experiment_newest(experiment);
    summary->time = (double)summary->steps * summary->dt;
    summary->rows = summary->steps + 1;
    summary->readout = *experiment_readout(experiment);
    summary->readout.time = summary->time;
    summary->readout.late = readout_late(&summary->readout, summary->time);
    summary->failed = experiment_failed(experiment, &summary->failure);
    double invariant[2] = {NAN, NAN};
    if (sim->step != summary->steps || !experiment_invariant(experiment, &invariant[1], &invariant[0]))
        invariant[0] = NAN;
    summary_rows(summary, sim, columns, n, record->rows, record->count, invariant);
    summary->n_derived = experiment_derived(experiment, summary->derived);
    if (sim->step != summary->steps)
        return; /* the findings and the crack are those of the step on screen */
    summary->n_findings = references_findings(experiment_references(experiment), sim, summary->findings);
    summary_crack(summary, sim, experiment_settings(experiment));
}

void summary_now(const Experiment *experiment, SummaryPart part, RunSummary *summary)
{
    const Simulation *sim = experiment_simulation(experiment);
    const Record *record = experiment_record(experiment);
    double invariant[2] = {NAN, NAN};
    int n;
    const Column *columns = experiment_columns(experiment, &n);
    *summary = (RunSummary){.readout = *experiment_readout(experiment),
                            .steps = sim->step,
                            .broken_bonds = NAN,
                            .crack_length = NAN};
    if (part == SUMMARY_ENERGY && sim->stage == 0) {
        if (!experiment_invariant(experiment, &invariant[1], &invariant[0]))
            invariant[0] = NAN;
        /* behind the step on screen there are rows that one has stepped back from */
        const size_t rows = record->count > 0 ? record_find(record, simulation_time(sim)) + 1 : 0;
        take_energy(summary, sim, columns, n, record->rows, rows, invariant);
    } else if (part == SUMMARY_FINDINGS) {
        summary->n_findings = references_findings(experiment_references(experiment), sim, summary->findings);
    } else if (part == SUMMARY_CRACK) {
        const CrackFronts *fronts = experiment_fronts(experiment);
        summary->crack_known = crack_facts(sim, &summary->crack);
        summary->fronts_known = fronts != NULL;
        if (fronts)
            crack_fronts_facts(fronts, &summary->fronts);
    }
}

static void add_known(char out[SUMMARY_MAX], const char *word, bool known, double value)
{
    if (!known)
        return;
    text_append(out, SUMMARY_MAX, "  %s %s", word, text_rounded(value, 7).text);
}

/* Of a run without a frequency that is said only where nothing else was found. */
static void add_readout(char out[SUMMARY_MAX], const Readout *readout, const char *answer, bool found,
                        bool wrong)
{
    const char *what = readout->is_period ? "period" : "frequency";
    if (!readout->moving) {
        if (!found && !readout->unjudged)
            text_append(out, SUMMARY_MAX, "nothing vibrates: no %s to measure\n", what);
        return;
    }
    text_append(out, SUMMARY_MAX, "%s%s", what, wrong ? " with a mistake" : "");
    if (readout->unaccounted)
        text_append(out, SUMMARY_MAX, "  not known with %s", readout->unaccounted);
    else if (!readout->measured_known)
        text_append(out, SUMMARY_MAX, "  %s", readout->unmeasured);
    add_known(out, "measured", readout->measured_known, readout->measured);
    add_known(out, wrong ? "predicted (right code)" : "predicted", readout->predicted_known,
              readout->predicted);
    add_known(out, answer, readout->exact_known, readout->exact);
    add_known(out, "at its real size", isfinite(readout->real_size), readout->real_size);
    if (readout->is_period && (readout->measured_known || readout->predicted_known || readout->exact_known))
        text_append(out, SUMMARY_MAX, "  s");
    text_append(out, SUMMARY_MAX, "\n");
    if (readout->measured_known && isfinite(readout->r2))
        text_append(out, SUMMARY_MAX, "uncertainty  %s  R2 %.4f\n",
                    text_rounded(readout->uncertainty, 2).text, readout->r2);
    if (!readout->measured_known || !readout->exact_known)
        return;
    text_append(out, SUMMARY_MAX, "error%s  frequency %+.4g %%  period %+.4g %%",
                wrong ? " with a mistake" : "", readout->error_frequency, readout->error_period);
    if (readout->predicted_known)
        text_append(out, SUMMARY_MAX, "  (frequency predicted %+.4g %%)", readout->predicted_error_frequency);
    if (readout->predicted_known && readout->overlap < READOUT_PURE)
        text_append(out, SUMMARY_MAX, "  (a mixture of modes: overlap %.3g with the one predicted)",
                    readout->overlap);
    text_append(out, SUMMARY_MAX, "\n");
    if (isfinite(readout->late))
        text_append(out, SUMMARY_MAX, "%.3g periods %s%s\n", fabs(readout->late),
                    readout->late < 0 ? "ahead" : "behind",
                    strcmp(readout->column, "strain") == 0 ? " (measured on the strain energy)" : "");
}

/* How fast a damped oscillation dies, and how fast it oscillates meanwhile; what a motion that dies keeps.
 * One that theory says is kept has E* for that. */
static void add_decay(char out[SUMMARY_MAX], const Readout *readout, bool wrong)
{
    if (isfinite(readout->decay_exact)) {
        text_append(out, SUMMARY_MAX, "decay");
        add_known(out, "measured", isfinite(readout->decay_measured), readout->decay_measured);
        add_known(out, "theory", true, readout->decay_exact);
        text_append(out, SUMMARY_MAX, "  1/s, half the damping\nfrequency");
        add_known(out, "measured", readout->measured_known, 1 / readout->measured);
        add_known(out, "predicted", readout->predicted_known, 1 / readout->predicted);
        add_known(out, "theory", readout->exact_known, 1 / readout->exact);
        text_append(out, SUMMARY_MAX, "  Hz\n");
    }
    if (!(readout->kept_predicted < READOUT_UNDAMPED))
        return;
    text_append(out, SUMMARY_MAX, wrong ? "with a mistake a period keeps" : "a period keeps");
    if (isfinite(readout->kept_measured))
        text_append(out, SUMMARY_MAX, "  measured %.4g %%", 100 * readout->kept_measured);
    text_append(out, SUMMARY_MAX, "  predicted%s %.4g %%  of the energy\n", wrong ? " (right code)" : "",
                100 * readout->kept_predicted);
}

/* A time in microseconds, or that it has not come. */
static void add_time(char out[SUMMARY_MAX], const char *word, double seconds, const char *never,
                     const char *unit)
{
    if (isnan(seconds))
        text_append(out, SUMMARY_MAX, "%s %s", word, never);
    else
        text_append(out, SUMMARY_MAX, "%s %.2f %s", word, 1e6 * seconds, unit);
}

/* Each share per area of the crack, so that it can be set beside G0. */
static void add_cost(char out[SUMMARY_MAX], const RunSummary *summary)
{
    const CrackPrice *price = &summary->price;
    const CrackCost *cost = &price->cost;
    if (!summary->price_known)
        return;
    text_append(out, SUMMARY_MAX, "cost  %.1f J/m^2: path %.1f  beside %.1f  far %.1f\n",
                cost->total / cost->area, cost->through / cost->area, cost->beside / cost->area,
                cost->far / cost->area);
    text_append(out, SUMMARY_MAX, "G0  %.1f J/m^2, on this lattice %.1f\n", price->critical_energy,
                cost->plane);
}

void summary_crack_text(const RunSummary *summary, const char *microseconds, char out[SUMMARY_MAX])
{
    const Crack *crack = &summary->crack.measured;
    out[0] = '\0';
    if (summary->fronts_known) {
        char lines[2][160];
        crack_fronts_lines(&summary->fronts, summary->rayleigh_speed, microseconds, lines[0], lines[1]);
        text_append(out, SUMMARY_MAX, "cracks  %s\n%s%s", lines[0], lines[1], lines[1][0] ? "\n" : "");
    }
    if (!summary->crack_known) {
        add_cost(out, summary);
        return;
    }
    add_time(out, "crack  first break", crack->first_break, "none", microseconds);
    add_time(out, "  twentieth", crack->twentieth_break, "none", microseconds);
    add_time(out, "  protected zone", crack->arrival, "not yet", microseconds);
    text_append(out, SUMMARY_MAX, "\n");
    bool any = false;
    for (int i = 0; i < CRACK_ANGLES; i++) {
        if (isnan(summary->crack.angles[i]))
            continue;
        text_append(out, SUMMARY_MAX, "%s%.1f deg over %.0f mm", any ? "  " : "angle of fit  ",
                    summary->crack.angles[i], 1e3 * summary->crack.heights[i]);
        any = true;
    }
    text_append(out, SUMMARY_MAX, "%s", any ? "\n" : "");
    if (crack->begun)
        text_append(out, SUMMARY_MAX, "tip  x %.1f mm  y %.1f mm", 1e3 * crack->x, 1e3 * crack->y);
    else
        text_append(out, SUMMARY_MAX, "no crack yet");
    text_append(out, SUMMARY_MAX, "  broken bonds %ld\n", crack->broken);
    if (crack->fastest > 0)
        text_append(out, SUMMARY_MAX, "tip's speed  at most %.0f m/s = %.2f c_R\n", crack->fastest,
                    crack->fastest / summary->rayleigh_speed);
    add_cost(out, summary);
}

void summary_energy_text(const RunSummary *summary, char out[SUMMARY_MAX])
{
    static const char *const names[] = {[ENERGY_INVARIANT] = "energy E*",
                                        [ENERGY_PERIOD] = "energy, first period to last,",
                                        [ENERGY_TENTH] = "energy, first tenth to last,"};
    const double change = summary->energy_change;
    out[0] = '\0';
    if (summary->energy_measure == ENERGY_NOT_KNOWN || !isfinite(change))
        return;
    text_append(out, SUMMARY_MAX, "%s", summary->mistake ? "with a mistake: " : "");
    text_append(out, SUMMARY_MAX,
                fabs(change) < 5e-4 ? "%s changed by %.3f %% of the %s" : "%s changed by %+.3g %% of the %s",
                names[summary->energy_measure], fabs(change) < 5e-4 ? 0 : change,
                summary->energy_of_ahead  ? "work, which is half a step ahead of the motion"
                : summary->energy_of_work ? "work"
                : summary->energy_of_feed ? "start, nearly all of it feed motion"
                                          : "start");
    /* what came within the first tenth is not in the change from it to the last */
    if (summary->energy_most > ENERGY_TOLD && summary->energy_most > 2 * change)
        text_append(out, SUMMARY_MAX, "; at most %+.3g %% on the way", summary->energy_most);
}

void summary_text(const RunSummary *summary, const Settings *settings, char out[SUMMARY_MAX])
{
    const Problem *facts = settings->problem;
    out[0] = '\0';
    text_append(out, SUMMARY_MAX, "%ld steps to t = %s%s%s  (dt %s)%s\n", summary->steps,
                text_rounded(summary->time, 8).text, facts->si ? " " : "",
                facts->si ? facts->unit_of_time : "", text_rounded(summary->dt, 6).text,
                summary->failed    ? ", where the run failed"
                : summary->at_rest ? ", where it came to rest"
                                   : "");
    if (summary->mistake)
        text_append(out, SUMMARY_MAX, "with a mistake: %s\n", summary->mistake);
    if (!summary->crack_known && !summary->fronts_known)
        add_readout(out, &summary->readout, facts->answer, summary->n_findings > 0 || summary->at_rest,
                    summary->mistake != NULL);
    add_decay(out, &summary->readout, summary->mistake != NULL);
    char found[SUMMARY_MAX];
    const int in_a_line = summary->n_findings > 4 ? 2 : 4;
    for (int i = 0; i < summary->n_findings; i += in_a_line) {
        const int left = summary->n_findings - i;
        findings_text(summary->findings + i, left < in_a_line ? left : in_a_line, true, found, sizeof found);
        text_append(out, SUMMARY_MAX, "%s\n", found);
    }
    char unaccounted[KNOWN_TEXT_MAX];
    if (answers_known_text(settings, unaccounted, NULL))
        text_append(out, SUMMARY_MAX, "%s\n", unaccounted);
    char text[SUMMARY_MAX];
    summary_crack_text(summary, "us", text);
    text_append(out, SUMMARY_MAX, "%s", text);
    summary_energy_text(summary, text);
    text_append(out, SUMMARY_MAX, "%s%s", text, *text ? "\n" : "");
}

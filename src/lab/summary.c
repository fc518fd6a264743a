#include "lab/summary.h"
#include "base/text.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static int find(const Column *columns, int n_columns, const char *name)
{
    for (int i = 0; i < n_columns; i++)
        if (strcmp(columns[i].quantity.name, name) == 0)
            return i;
    return -1;
}

/* The mean over `count` rows of what is there without the work of loads. */
static double mean_energy(const double *rows, size_t count, int n_columns, int total, int work)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        const double *row = rows + i * (size_t)n_columns;
        sum += row[total] - (work >= 0 ? row[work] : 0);
    }
    return sum / (double)count;
}

static void take_energies(RunSummary *summary, const Column *columns, int n_columns, const double *rows,
                          size_t count)
{
    int total = find(columns, n_columns, "total"), work = find(columns, n_columns, "work");
    if (total < 0 || count == 0)
        return;
    const double *newest = rows + (count - 1) * (size_t)n_columns;
    summary->energy_start = rows[total];
    summary->energy_end = newest[total];
    summary->work = work >= 0 ? newest[work] : 0;
    size_t tenth = count < 20 ? 1 : count / 10;
    double before = mean_energy(rows, tenth, n_columns, total, work);
    double after = mean_energy(rows + (count - tenth) * (size_t)n_columns, tenth, n_columns, total, work);
    double scale = summary->energy_start > 0 ? before : 0;
    /* the work of a load swings with the body, so its value at the end says little */
    for (size_t i = 0; i < count && work >= 0 && !(summary->energy_start > 0); i++)
        scale = fmax(scale, fabs(rows[i * (size_t)n_columns + (size_t)work]));
    summary->energy_drift = scale > 0 ? 100 * (after - before) / scale : 0;
}

void summary_rows(RunSummary *summary, const Column *columns, int n_columns, const double *rows, size_t count)
{
    take_energies(summary, columns, n_columns, rows, count);
    summary->n_columns = n_columns;
    memcpy(summary->columns, columns, (size_t)n_columns * sizeof *columns);
    if (count > 0)
        memcpy(summary->last_row, rows + (count - 1) * (size_t)n_columns, (size_t)n_columns * sizeof *rows);
}

void summary_of(Experiment *experiment, RunSummary *summary)
{
    const Record *record = experiment_record(experiment);
    int n;
    const Column *columns = experiment_columns(experiment, &n);
    *summary = (RunSummary){0};
    summary->dt = experiment_simulation(experiment)->dt;
    summary->steps = experiment_newest(experiment);
    summary->time = (double)summary->steps * summary->dt;
    summary->rows = summary->steps + 1;
    summary->readout = *experiment_readout(experiment);
    summary->readout.time = summary->time;
    summary->readout.late = readout_late(&summary->readout, summary->time);
    summary->failed = experiment_failed(experiment, &summary->failure);
    summary_rows(summary, columns, n, record->rows, record->count);
    summary->n_derived = experiment_derived(experiment, summary->derived);
    /* the crack is that of the step on screen */
    if (experiment_simulation(experiment)->step == summary->steps)
        summary->crack_known = crack_facts(experiment_simulation(experiment), &summary->crack);
}

typedef struct Writer {
    char *out;
    size_t used;
} Writer;

static void add(Writer *writer, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void add(Writer *writer, const char *format, ...)
{
    if (writer->used >= SUMMARY_MAX)
        return;
    va_list arguments;
    va_start(arguments, format);
    int n = vsnprintf(writer->out + writer->used, SUMMARY_MAX - writer->used, format, arguments);
    va_end(arguments);
    writer->used += n > 0 ? (size_t)n : 0;
}

static void add_known(Writer *writer, const char *word, bool known, double value)
{
    char text[NUMBER_TEXT_MAX];
    if (!known)
        return;
    text_rounded(text, value, 7);
    add(writer, "  %s %s", word, text);
}

static void add_readout(Writer *writer, const Readout *readout)
{
    if (!readout->moving)
        return;
    add(writer, "%s", readout->is_period ? "period" : "frequency");
    if (!readout->measured_known)
        add(writer, "  too short a run to measure it");
    add_known(writer, "measured", readout->measured_known, readout->measured);
    add_known(writer, "predicted", readout->predicted_known, readout->predicted);
    add_known(writer, "exact", readout->exact_known, readout->exact);
    if (readout->is_period && (readout->measured_known || readout->predicted_known || readout->exact_known))
        add(writer, "  s");
    add(writer, "\n");
    if (!readout->measured_known || !readout->exact_known)
        return;
    add(writer, "error  frequency %+.4g %%  period %+.4g %%", readout->error_frequency,
        readout->error_period);
    if (readout->predicted_known)
        add(writer, "  (frequency predicted %+.4g %%)", readout->predicted_error_frequency);
    add(writer, "\n%s by %.3g periods%s\n", readout->late < 0 ? "early" : "late", fabs(readout->late),
        strcmp(readout->column, "strain") == 0 ? " (measured on the strain energy)" : "");
}

static void add_time(Writer *writer, const char *word, double seconds, const char *never)
{
    if (isnan(seconds))
        add(writer, "%s %s", word, never);
    else
        add(writer, "%s %.2f us", word, 1e6 * seconds);
}

void summary_crack_text(const RunSummary *summary, char out[SUMMARY_MAX])
{
    Writer writer = {out, 0};
    const Crack *crack = &summary->crack.measured;
    out[0] = '\0';
    if (!summary->crack_known)
        return;
    add_time(&writer, "crack  first break", crack->first_break, "none");
    add_time(&writer, "  twentieth", crack->twentieth_break, "none");
    add_time(&writer, "  protected zone", crack->arrival, "not yet");
    add(&writer, "\n");
    bool any = false;
    for (int i = 0; i < CRACK_ANGLES; i++) {
        if (isnan(summary->crack.angles[i]))
            continue;
        add(&writer, "%s%.1f deg over %.0f mm", any ? "  " : "angle  ", summary->crack.angles[i],
            1e3 * crack_heights[i]);
        any = true;
    }
    add(&writer, "%s", any ? "\n" : "");
    if (crack->begun)
        add(&writer, "tip  x %.1f mm  y %.1f mm", 1e3 * crack->x, 1e3 * crack->y);
    else
        add(&writer, "no crack yet");
    add(&writer, "  broken bonds %ld\n", crack->broken);
}

const char *summary_drift_base(const RunSummary *summary)
{
    return summary->energy_start > 0 ? "" : " of the work";
}

void summary_text(const RunSummary *summary, const Settings *settings, char out[SUMMARY_MAX])
{
    Writer writer = {out, 0};
    const ProblemFacts *facts = &problem_facts[settings->problem];
    out[0] = '\0';
    char time[NUMBER_TEXT_MAX], dt[NUMBER_TEXT_MAX];
    text_rounded(time, summary->time, 8);
    text_rounded(dt, summary->dt, 6);
    add(&writer, "%ld steps to t = %s%s%s  (dt %s)%s\n", summary->steps, time, facts->si ? " " : "",
        facts->si ? facts->unit_of_time : "", dt, summary->failed ? ", where the run failed" : "");
    add_readout(&writer, &summary->readout);
    char crack[SUMMARY_MAX];
    summary_crack_text(summary, crack);
    add(&writer, "%senergy drift %+.3g %%%s\n", crack, summary->energy_drift, summary_drift_base(summary));
}

#include "cli/verify/verify_trace.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool no_memory(Status *status)
{
    return status_fail(status, STATUS_FAILED, "not enough memory for the trace of a run");
}

/* Rows come from the fast path where every step is kept. */
static bool fill_rows(Trace *trace, Simulation *sim, long every, Status *status)
{
    size_t columns = (size_t)trace->columns;
    simulation_row(sim, trace->rows);
    if (every == 1)
        return simulation_steps(sim, (long)trace->count - 1, trace->rows + columns, NULL, status);
    for (size_t k = 1; k < trace->count; k++) {
        if (!simulation_steps(sim, every, NULL, NULL, status))
            return false;
        simulation_row(sim, trace->rows + k * columns);
    }
    return true;
}

bool trace_take(Trace *trace, Simulation *sim, long steps, long every, Status *status)
{
    *trace = (Trace){.count = (size_t)(steps / every) + 1,
                     .spacing = (double)every * sim->dt,
                     .columns = sim->n_series,
                     .series = sim->series};
    trace->rows = calloc(trace->count * (size_t)trace->columns, sizeof *trace->rows);
    if (!trace->rows)
        return no_memory(status);
    if (fill_rows(trace, sim, every, status))
        return true;
    trace_free(trace);
    return false;
}

void trace_free(Trace *trace)
{
    free(trace->rows);
    *trace = (Trace){0};
}

static size_t column_of(const Trace *trace, const char *name)
{
    size_t column = 0;
    while ((int)column + 1 < trace->columns && strcmp(trace->series[column].name, name) != 0)
        column++;
    return column;
}

double *trace_column(const Trace *trace, const char *name)
{
    double *values = malloc(trace->count * sizeof *values);
    size_t column = column_of(trace, name);
    for (size_t k = 0; values && k < trace->count; k++)
        values[k] = trace->rows[k * (size_t)trace->columns + column];
    return values;
}

/* The rows of an interval: from *first, as many as returned. */
static size_t rows_between(const Trace *trace, double first, double last, size_t *begin)
{
    /* a time that should be a row's may miss it by rounding */
    double slack = 1e-9;
    double from = ceil(first / trace->spacing - slack), to = floor(last / trace->spacing + slack);
    from = fmax(from, 0), to = fmin(to, (double)trace->count - 1);
    *begin = (size_t)from;
    return to >= from ? (size_t)(to - from) + 1 : 0;
}

double trace_mean(const Trace *trace, const char *name, double first, double last)
{
    size_t begin, count = rows_between(trace, first, last, &begin), column = column_of(trace, name);
    double sum = 0;
    for (size_t k = begin; k < begin + count; k++)
        sum += trace->rows[k * (size_t)trace->columns + column];
    return sum / (double)count;
}

bool trace_frequency(const Trace *trace, const char *name, double first, double last, double start,
                     FrequencyFit *fit, Status *status)
{
    size_t begin, count = rows_between(trace, first, last, &begin);
    double *values = trace_column(trace, name);
    if (!values)
        return no_memory(status);
    bool done = frequency_fit(values + begin, count, (double)begin * trace->spacing, trace->spacing, start,
                              fit, status);
    free(values);
    return done;
}

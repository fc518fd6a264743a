/* A run as verification sees it: rows of the series at equal times. */
#ifndef CLI_VERIFY_TRACE_H
#define CLI_VERIFY_TRACE_H

#include "physics/method.h"
#include "theory/frequency.h"

typedef struct Trace {
    size_t count;   /* rows, that of step 0 included */
    double spacing; /* time between two rows */
    int columns;
    const Quantity *series; /* belongs to the simulation */
    double *rows;
} Trace;

/* Runs `steps` steps and keeps every `every`-th row. False: not enough memory, or the run failed; the trace
 * is then empty. */
bool trace_take(Trace *trace, Simulation *sim, long steps, long every, Status *status);
void trace_free(Trace *trace);

/* One column as a series; NULL: not enough memory. The caller frees it. The name must be a series of the run.
 */
double *trace_column(const Trace *trace, const char *name);

/* A column's mean over the rows with first <= time <= last. */
double trace_mean(const Trace *trace, const char *name, double first, double last);

/* A column's frequency over the rows with first <= time <= last; from `start`, or by itself where that is 0.
 */
bool trace_frequency(const Trace *trace, const char *name, double first, double last, double start,
                     FrequencyFit *fit, Status *status);

#endif

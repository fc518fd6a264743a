/* The sum behind a stage, with its numbers. */
#include "physics/mpm/bar_state.h"

void bar_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, char *out,
                 size_t size)
{
    (void)sim, (void)stage, (void)set, (void)index, (void)before;
    if (size > 0)
        out[0] = '\0';
}

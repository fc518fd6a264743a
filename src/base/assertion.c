/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The line that a failed assertion prints before it aborts; see assertion.h. */
#include "base/assertion.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

_Noreturn void assertion_fail(const char *file, int line, const char *function, const char *text)
{
    fprintf(stderr, "%s:%d: %s: %s does not hold\n", file, line, function, text);
    abort();
}

_Noreturn void assertion_fail_int(const char *file, int line, const char *function, const char *text,
                                  int64_t left, const char *operation, int64_t right)
{
    fprintf(stderr, "%s:%d: %s: %s does not hold: %" PRId64 " %s %" PRId64 "\n", file, line, function, text,
            left, operation, right);
    abort();
}

_Noreturn void assertion_fail_real(const char *file, int line, const char *function, const char *text,
                                   double left, const char *operation, double right)
{
    fprintf(stderr, "%s:%d: %s: %s does not hold: %.17g %s %.17g\n", file, line, function, text, left,
            operation, right);
    abort();
}

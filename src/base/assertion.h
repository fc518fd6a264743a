/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Assertions: what the caller of a function has promised, held while matvib is developed.
 *
 * They catch errors of the program, never of its user: bad input is a Status. They are on in a build
 * configured with --enable-assertions (the one with sanitizers of .ci/run) and cost nothing in the others,
 * where their arguments are compiled but not evaluated: an argument must have no side effect.
 *
 *     ASSERT(simulation->model);      file:line: function: simulation->model does not hold
 *     ASSERT_INT(stage, <, STAGES);   file:line: function: stage < STAGES does not hold: 8 < 8
 *     ASSERT_INDEX(node, n_nodes);    file:line: function: node is one of n_nodes does not hold: 9 of 9
 *     ASSERT_REAL(dt, >, 0);          file:line: function: dt > 0 does not hold: -0.1 > 0
 *
 * A failure writes that line to standard error and aborts, so that a core or a debugger shows the caller. */
#ifndef BASE_ASSERTION_H
#define BASE_ASSERTION_H

#include <stdint.h>

/* Always there, so that a file may switch assertions on for itself by defining MATVIB_ASSERTIONS before it
 * includes this. */
_Noreturn void assertion_fail(const char *file, int line, const char *function, const char *text);
_Noreturn void assertion_fail_int(const char *file, int line, const char *function, const char *text,
                                  int64_t left, const char *operation, int64_t right);
_Noreturn void assertion_fail_real(const char *file, int line, const char *function, const char *text,
                                   double left, const char *operation, double right);

#ifdef MATVIB_ASSERTIONS
#define ASSERT(condition) ((condition) ? (void)0 : assertion_fail(__FILE__, __LINE__, __func__, #condition))
/* Each side is evaluated once. */
#define ASSERT_INT(left, operation, right)                                                                   \
    ASSERTION_COMPARE(int64_t, assertion_fail_int, left, operation, right)
/* 0 <= index < count */
#define ASSERT_INDEX(index, count)                                                                           \
    do {                                                                                                     \
        const int64_t assertion_index = (int64_t)(index), assertion_count = (int64_t)(count);                \
        if (assertion_index < 0 || assertion_index >= assertion_count)                                       \
            assertion_fail_int(__FILE__, __LINE__, __func__, #index " is one of " #count, assertion_index,   \
                               "of", assertion_count);                                                       \
    } while (0)
#define ASSERT_REAL(left, operation, right)                                                                  \
    ASSERTION_COMPARE(double, assertion_fail_real, left, operation, right)
#define ASSERTION_COMPARE(type, fail, left, operation, right)                                                \
    do {                                                                                                     \
        const type assertion_left = (type)(left), assertion_right = (type)(right);                           \
        if (!(assertion_left operation assertion_right))                                                     \
            fail(__FILE__, __LINE__, __func__, #left " " #operation " " #right, assertion_left, #operation,  \
                 assertion_right);                                                                           \
    } while (0)
#else
#define ASSERT(condition)                   ((void)sizeof((condition) ? 1 : 0))
#define ASSERT_INT(left, operation, right)  ((void)sizeof((int64_t)(left)operation(int64_t)(right)))
#define ASSERT_INDEX(index, count)          ((void)sizeof((int64_t)(index) < (int64_t)(count)))
#define ASSERT_REAL(left, operation, right) ((void)sizeof((double)(left)operation(double)(right)))
#endif

#endif

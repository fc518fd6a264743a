/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What went wrong, as a value.
 *
 * A function that can fail returns false and fills a Status; nothing but main prints or exits. The code is
 * the exit status that the failure deserves, the text is one line without a final full stop or newline:
 * "FILE:LINE: KEY: what is wrong (what is allowed)" for bad input. */
#ifndef BASE_STATUS_H
#define BASE_STATUS_H

#include <stdbool.h>

typedef enum StatusCode {
    STATUS_DONE = 0,   /* nothing went wrong */
    STATUS_FAILED = 1, /* the run or the check failed: unstable, left the mesh, a miss, cannot write */
    STATUS_USAGE = 2   /* bad usage or bad input */
} StatusCode;

typedef struct Status {
    StatusCode code;
    char text[512];
} Status;

/* Both fill the status (which may be NULL) and return false, so that a caller writes
 * `return status_refuse(status, "...")`: bad usage or input is refused, anything else has failed. Longer text
 * is cut; what it repeats from outside, such as the name of a file, becomes visible as visible_text() does
 * it. */
bool status_refuse(Status *status, const char *format, ...) __attribute__((format(printf, 2, 3)));
bool status_fail(Status *status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Takes over what another one says: the only way to hand it on to a status that may be NULL. Returns false.
 */
bool status_take(Status *status, const Status *why);

/* Puts "prefix: " before the text of a failure; for a caller who knows the file or the key. Returns false. */
bool status_prefix(Status *status, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The summary of a command as one object of JSON (RFC 8259) on a stream:
 *
 *     {"command": "run", "scenario": "mode5", "quantities": [
 *       {"name": "frequency_measured", "value": 5.4140744171, "unit": "1/time"}, ...]}
 *
 * Members of the object come before its quantities, members of a quantity behind its unit. Numbers have 17
 * digits and read back to the same; what is not a number is null, and so is a unit that is not known (NULL).
 */
#ifndef CLI_QUANTITIES_H
#define CLI_QUANTITIES_H

#include <stdio.h>

typedef struct Quantities {
    FILE *out;
    long count;
} Quantities;

Quantities quantities_open(FILE *out, const char *command);
void quantities_begin(Quantities *, const char *key); /* a list, behind the object's own members */
void quantities_add(Quantities *, const char *name, double value, const char *unit);
void quantities_end(Quantities *);   /* of a list that others follow */
void quantities_close(Quantities *); /* of the last list, and of the object */

/* A member of the object or, once the list has begun, of the last quantity. */
void quantities_text(Quantities *, const char *key, const char *text); /* NULL: null */
void quantities_number(Quantities *, const char *key, double value);

#endif

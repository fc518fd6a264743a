/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A number as a person types it: arithmetic, SI prefixes and units, "70 GPa", "25/3", "5 mm + 2 cm", "99.9
 * %".
 *
 * Plain numbers are those of text_to_double(), and what a decimal prefix shifts is the number that would have
 * been typed without it, to the last bit: "5 mm" is 0.005. */
#ifndef BASE_QUANTITY_H
#define BASE_QUANTITY_H

#include <math.h>
#include <stdbool.h>

enum { QUANTITY_WHY_MAX = 80 };

/* Whether it is 0, or from 1e-50 to 1e50 in size: then what is made of several such numbers, E/(rho dx^2)
 * say, is neither infinite nor denormal. Iterations that wait for eps x to be small never end with a denormal
 * x. */
static inline bool quantity_is_sound(double value)
{
    return value == 0 || (fabs(value) >= 1e-50 && fabs(value) <= 1e50);
}

/* Reads a text as a value in `unit`, such as "Pa", "kg/m^3" or "m/s"; of another word, or "", nothing is
 * known, and no unit may be in the text. A text without a unit is meant in that unit. False: `why` (of
 * QUANTITY_WHY_MAX bytes) says what is wrong, "is not a number", "divides by zero", "is not in Pa", "cannot
 * be read: no unit t/m^3 here", "is too small to compute with"; nothing else is written. Any bytes may stand
 * in the text. */
bool quantity_read(const char *text, const char *unit, double *value, char *why);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Equations and labels in ASCII: one table for all of them. */
#ifndef BASE_SPELL_H
#define BASE_SPELL_H

#include <stddef.h>

/* "Δε = Δt Σ N′v" is "de = dt sum N'v"; a symbol that becomes a word is kept apart from letters and digits
 * beside it: "nπ/L" is "n pi/L". What is not known stays. */
void spell_ascii(const char *utf8, char *out, size_t size);

#endif

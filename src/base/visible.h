/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The one door for text from outside: files and their names, arguments, the environment.
 *
 * A terminal obeys bytes, and a reader believes what he sees. So whatever comes from outside and goes to a
 * terminal passes here, where everything that would act or hide instead of being seen is written out:
 * "\x1b" for a control byte and for bytes that are not UTF-8, "\u202e" for a control of the upper half (C1),
 * for what turns the direction of writing (U+061C, 200E, 200F, 202A-202E, 2066-2069), for what has no width
 * (U+200B-200D, 2060, FEFF, ...) and for line ends other than a newline. The written form is for eyes: a
 * backslash stands for itself, so it does not always read back.
 *
 * status_fail(), the messages and questions of the laboratory and visible_print() do it; who puts text from
 * outside elsewhere does it. Sources: Unicode 15, chapters 2.11, 23.2 to 23.4; UAX 9; ECMA-48, 8.3. */
#ifndef BASE_VISIBLE_H
#define BASE_VISIBLE_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Whether a text can be shown as it is: one line of UTF-8 in which no character hides. */
bool visible_is_clean(const char *text);

/* Copies a text as it can be shown; what does not fit is left out, never half of a character. `out` must not
 * overlap the text. Returns the length. What is clean stays the same. */
size_t visible_text(char *out, size_t size, const char *text);

/* The same of a text by its format, of at most 2000 bytes. */
size_t visible_format(char *out, size_t size, const char *format, va_list)
    __attribute__((format(printf, 3, 0)));

/* Prints one line of at most 2000 bytes as it can be shown. A newline is kept at the end of the line only. */
void visible_print(FILE *, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Writes over the line that the terminal is in, for progress; "" only clears it. */
void visible_progress(FILE *, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif

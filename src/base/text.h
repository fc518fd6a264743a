/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers and words as text, the same in every locale and on every machine. */
#ifndef BASE_TEXT_H
#define BASE_TEXT_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { NUMBER_TEXT_MAX = 32 };

/* A number as text; it stands where a function of such numbers is called: text_rounded(x, 4).text. */
typedef struct NumberText {
    char text[NUMBER_TEXT_MAX];
} NumberText;

/* Writes the shortest decimal text that reads back to the same double (".1" is written "0.1", 1e-7 as
 * "1e-7"), with a point in every locale; "nan", "inf", "-inf" for what is not a number. `out` holds
 * NUMBER_TEXT_MAX characters. Returns the length. */
size_t text_shortest(char *out, double value);

/* A number for reading: `digits` significant digits, trailing zeros cut, never an exponent's padding. */
NumberText text_rounded(double value, int digits);

/* The largest number of so many digits that is not above `most`: a limit, as it may be copied. */
NumberText text_limit(double most, int digits);

/* Cuts "1e-07" to "1e-7" and "1e+16" to "1e16". Returns the length. */
size_t text_trim_exponent(char *text);

/* Reads a finite number that fills the whole text, spaces around it allowed. False: it does not. */
bool text_to_double(const char *text, double *value);
bool text_to_long(const char *text, long *value);

/* Reads "80x24": two whole numbers from `least` to `most`. */
bool text_to_size(const char *text, long least, long most, int size[2]);

/* Closes a stream of open_memstream(). Whether all that was written is in `*text`: where memory is short at
 * the end it is NULL, and fclose() does not report it. `*text` is freed by the caller either way. */
bool text_stream_close(FILE *stream, char *const *text);

/* Writes a text as XML has it, in an element or an attribute; a control character becomes a space. */
void text_put_xml(FILE *stream, const char *text);

/* Writes bytes as a string of JSON has them, with its quotes. */
void text_put_json(FILE *stream, const char *bytes, size_t count);

/* The number of edits (insert, delete, replace, swap neighbours) between two words; for "did you mean". */
size_t text_distance(const char *a, const char *b);

/* Adds an item to a list "one, two". Where it does not fit whole " ..." is added in its place: false. */
bool text_list_add(char *list, size_t size, const char *item);

/* A number for people in at most `width` columns: as many digits as fit, at most `digits`. */
NumberText text_fitted(double value, int digits, int width);

/* A factor by which something is enlarged: "5000", not "5e3". */
NumberText text_factor(double factor);

/* Appends to a text; what does not fit is cut. */
void text_append(char *out, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Appends a word as a shell reads it: in single quotes where it has more than letters, digits, _./=,:+%@-. */
void text_append_shell(char *out, size_t size, const char *word);

/* Words separated by spaces, one after the other, cut where `out` is too short; false: there is no more.
 * Items of a list may be separated by commas too. */
bool text_next_word(const char **text, char *out, size_t size);
bool text_next_item(const char **list, char *out, size_t size);

/* Whether one of the words of a list is this one. */
bool text_has_word(const char *list, const char *word);

const char *text_last_word(const char *text);

/* Whether a first line, "sep=;", tells a spreadsheet what separates the cells below. */
bool text_tells_separator(const char *line);

/* One more of what is allowed: "usf | usl"; what has no room is left out. */
void text_or(char *out, size_t size, const char *word);

/* Where a word stands among words that end with a NULL (NULL: there are none); -1: nowhere. */
int text_place_in(const char *word, const char *const words[]);

/* Equations and labels in ASCII: one table for all of them. */

/* "Δε = Δt Σ N′v" is "de = dt sum N'v"; a symbol that becomes a word is kept apart from letters and digits
 * beside it: "nπ/L" is "n pi/L". What is not known stays. */
void text_to_ascii(const char *utf8, char *out, size_t size);

#endif

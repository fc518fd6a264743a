/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Variants of an exercise: a parameter that has another value for each student, drawn from the name, so that
 * who copies an answer copies that of another question. The same name gets the same value on every machine.
 */
#ifndef LESSONS_VARIANT_H
#define LESSONS_VARIANT_H

#include "base/text.h"
#include "scenario/assignment.h"

enum { STUDENT_MAX = 128, VARIANT_WORDS_MAX = 16 };

typedef struct Variant {
    char key[KEY_MAX];
    double from, to;
    bool whole;                               /* whole numbers only */
    const char *words[VARIANT_WORDS_MAX + 1]; /* of a choice: those to draw from, ended by NULL */
    int n_words;                              /* 0: it has numbers */
    bool concealed;                           /* the words are mistakes, which the laboratory does not show */
} Variant;

/* "KEY from A to B", "KEY from WORD, WORD ...". */
bool variant_read(const char *text, Variant *, Status *);

/* The word of a choice's value as variant_draw() writes it: without what conceals it. */
const char *variant_word(const char *value);

/* The value for a student ("": nobody in particular) in a lesson of that title: one of some twenty to fifty
 * from A to B with few digits; one of the words, a mistake as "?WORD". */
void variant_draw(const Variant *, const char *title, const char *student, char out[NUMBER_TEXT_MAX]);

/* The value on the side of a drawn one that another student has: direction -1 or 1. False: there is none. */
bool variant_beside(const Variant *, const char *value, int direction, char out[NUMBER_TEXT_MAX]);

/* A student's name with single spaces between its words and none around them, its characters composed: the
 * same name has the same bytes, whatever keyboard or system they come from (NFC, Unicode annex 15, by
 * libutf8proc). False: it is none, and the status says why; so it does of accents that a program built
 * without that library cannot compose. */
bool variant_student(const char *text, char out[STUDENT_MAX], Status *);

/* A name as part of the name of a file: its letters and digits, one hyphen for all that is between them; "":
 * it has none. Letters beyond ASCII are known to libutf8proc, without it they are left out. */
void variant_file_word(const char *name, char *out, size_t size);

#endif

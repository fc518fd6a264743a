/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is kept between two visits: files in $XDG_STATE_HOME/matvib or ~/.local/state/matvib. */
#ifndef LAB_SESSION_STATE_FILE_H
#define LAB_SESSION_STATE_FILE_H

#include "base/output.h"
#include "lessons/lesson_shown.h"

/* The path of such a file. NULL: there is no home, or no memory; else free() it. */
char *state_file(const char *name);

/* A file that holds one word: which of some it is, NULL where there is none of them; and another in its
 * place, if that can be kept. */
const char *state_file_word(const char *name, const char *const words[]);
void state_file_put(Asker, const char *name, const char *word);

extern const char state_file_sheet[]; /* the chosen sheet: one of parameter_sheet_words */

/* How far one has come in each lesson, kept between two visits: a file with one line a lesson, NAME PAGE. */

/* Raises the pages reached to those of the file. False: it may hold more, or there is no home. */
bool state_file_read_lessons(int reached[LESSONS_MAX]);

/* Another laboratory may have come further meanwhile, or a recorded session not as far: nothing is taken
 * back, and where it is not known how far one came nothing is written. That it cannot be kept does no harm.
 */
void state_file_write_lessons(Asker, const int reached[LESSONS_MAX]);

#endif

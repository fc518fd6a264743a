/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far one has come in each lesson, kept between two visits: a file with one line a lesson, NAME PAGE. */
#ifndef LAB_LESSON_LESSON_PROGRESS_H
#define LAB_LESSON_LESSON_PROGRESS_H

#include "base/output.h"
#include "lessons/lesson_shown.h"

/* Raises the pages that were reached to those of the file. False: it may hold more than could be read, or
 * there is no home. */
bool lesson_progress_read(int reached[LESSONS_MAX]);

/* Another laboratory may have come further meanwhile, or a recorded session not as far: nothing is taken
 * back, and where it is not known how far one came nothing is written. That it cannot be kept does no harm.
 */
void lesson_progress_write(Asker, const int reached[LESSONS_MAX]);

#endif

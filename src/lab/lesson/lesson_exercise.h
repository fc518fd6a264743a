/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exercises of a page: answers are asked for, judged and noted. */
#ifndef LAB_LESSON_LESSON_EXERCISE_H
#define LAB_LESSON_LESSON_EXERCISE_H

typedef struct Laboratory Laboratory;

/* Asks for the number or the words of the page. */
void lesson_exercise_ask(Laboratory *);

/* Notes the choice that was taken; only the first one counts, for then the right one is told. */
void lesson_exercise_choose(Laboratory *, int choice);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lessons: pages beside the run, and what the laboratory does when one is opened. */
#ifndef LAB_LESSON_LESSON_PLAY_H
#define LAB_LESSON_LESSON_PLAY_H

#include "lab/lesson/lesson_entry.h"

bool lesson_play_open(Laboratory *, const char *name, Status *);
bool lesson_play_answer(Laboratory *, const char *text);
void lesson_play_close(Laboratory *);
void lesson_play_toggle(Laboratory *);
bool lesson_play_turn(Laboratory *, int direction); /* false: the keys are not those of a page */
bool lesson_play_key(Laboratory *, const Key *);    /* false: it is not for the lesson */
void lesson_play_search(Laboratory *);              /* asks for words; in the list */
void lesson_play_move(Laboratory *, int x, int y);
void lesson_play_enter(Laboratory *);               /* opens the chosen one, serves the page, or goes on */
bool lesson_play_click(Laboratory *, int x, int y); /* false: there is none in that cell */

#endif

/* Lessons: pages beside the run, and what the laboratory does when one is opened. */
#ifndef TUI_LESSON_PLAY_H
#define TUI_LESSON_PLAY_H

#include "base/output.h"
#include "lab/lessons/lesson.h"
#include "tui/terminal/keys.h"
#include "view/help/commands.h"

typedef struct Laboratory Laboratory;

enum { LESSON_QUEUE_MAX = 256, LESSON_NAME_MAX = 256 };

/* The lesson that is open, and what is still to be done for its page. */
typedef struct LessonPlay {
    Lesson lesson;
    char name[LESSON_NAME_MAX];
    const char *queue[LESSON_QUEUE_MAX];
    int n_queue, next;
    CommandSet used; /* since the page was opened */
    bool warned;     /* that the page still waits */
    Asker asker;     /* who turned to the page */
    bool busy;
} LessonPlay;

bool lesson_play_open(Laboratory *, const char *name, Status *);
bool lesson_play_answer(Laboratory *, const char *text);
void lesson_play_close(Laboratory *);
void lesson_play_toggle(Laboratory *);
bool lesson_play_key(Laboratory *, const Key *); /* false: it is not for the lesson */
void lesson_play_move(Laboratory *, int x, int y);
void lesson_play_enter(Laboratory *);               /* opens the chosen one, or edits a field of the page */
bool lesson_play_click(Laboratory *, int x, int y); /* false: there is none in that cell */

/* What is left to be done, once the run has come to where it should be. */
void lesson_play_continue(Laboratory *);

#endif

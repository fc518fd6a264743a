/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The screen in plain words. What panes draw as words (a stage, a lesson, a table) is written as it is
 * drawn, without frames; what views draw as curves or colours is described in sentences of what they plot. */
#ifndef PICTURE_WORDS_TELL_H
#define PICTURE_WORDS_TELL_H

#include "panes/screen.h"
#include "picture/canvas.h"

/* --- the text ------------------------------------------------------------------------------------- */

enum { WORDS_WIDTH = 72 }; /* no line has more columns */

typedef struct Words {
    char *text; /* lines, each ended by '\n'; NULL: nothing has been said */
    size_t used, room;
    bool lost; /* memory was short */
} Words;

void words_close(Words *); /* also forgets what was said */

/* One paragraph, broken at spaces, its further lines `indent` columns to the right. */
void words_say(Words *, int indent, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* The rows of a canvas that hold words, as lines: of a heading's rule only the words stay, of frames and
 * empty rows nothing. `numbered`: each line begins with its number. */
void words_canvas(Words *, const Canvas *, bool numbered);

/* --- the screen ----------------------------------------------------------------------------------- */

/* The parts of the screen, in the order in which they are described. */
typedef enum TellPart {
    TELL_ABOUT, /* what the scenario asks, and what about */
    TELL_LESSON,
    TELL_WHERE,  /* scenario, time, step, state */
    TELL_NUMBER, /* that the scenario is about */
    TELL_SETUP,  /* how the body is held, cut, loaded and moved */
    TELL_FOCUS,  /* which pane the keys go to */
    TELL_PARAMETER,
    TELL_BODY,  /* what it is made of, and the chosen particle or node with its numbers */
    TELL_STAGE, /* the stage at hand; between steps what comes, at the end what came out */
    TELL_UPPER,
    TELL_LOWER,
    TELL_INSPECTOR,
    TELL_PARTS, /* so far what is described by itself when it has changed; the others are asked for */
    TELL_PARAMETERS = TELL_PARTS,
    TELL_WHY, /* what the scenario says of itself, and of what the error of a mode is made */
    TELL_HELP,
    TELL_COUNT
} TellPart;

void tell_part(const Screen *, TellPart, Words *);

/* By what a person calls it: a view (and its present variant) or a part; "" all parts. False: there is no
 * such thing. `known` says what there is. */
bool tell_named(const Screen *, const char *word, Words *);
void tell_names(char *out, size_t size);

/* The word of a part by its number, from 0 on; NULL: there are no more. */
const char *tell_word(int i);

/* A question or a field that is open, and what may be answered. */
void tell_prompt(const Screen *, Words *);

/* One view: from what it plots, and by its own function what stands out. */
void tell_view(const Screen *, const View *, Words *);

struct Picture;

/* tell_picture.c: the curves of a plot, the colours of a map, the rows of a list, or why there are none.
 * `cursor` is the place at which each curve is read too; NAN: none. */
void tell_picture(const struct Picture *, double cursor, Words *);

#endif

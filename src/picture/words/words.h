/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is told in plain words: a growing text of short lines for a user without a screen. Signs are
 * printable ASCII; letters that come from outside stay what they are, in UTF-8. */
#ifndef PICTURE_WORDS_WORDS_H
#define PICTURE_WORDS_WORDS_H

#include "picture/canvas.h"

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

#endif

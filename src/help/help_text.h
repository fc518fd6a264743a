/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the help says of a problem and its method: the words of its curves, and what is solved. */
#ifndef HELP_HELP_TEXT_H
#define HELP_HELP_TEXT_H

#include "methods/method.h"

#include <stddef.h>

typedef struct HelpWord {
    const char *word, *meaning;
} HelpWord;

typedef struct HelpPassage {
    bool heading;
    const char *text;
} HelpPassage;

typedef struct HelpText {
    const char *step; /* heading of the stages, which stand between `answers` and `after` */
    const HelpWord *words;
    size_t n_words;
    const HelpPassage *before;
    size_t n_before;
    const HelpPassage *answers;
    size_t n_answers;
    const HelpPassage *after;
    size_t n_after;
} HelpText;

/* What fits what the simulation has. */
const HelpText *help_text_of(const Simulation *);

#endif

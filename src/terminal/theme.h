/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a style looks like on a terminal of 256, 8 or no colours, on dark and on light ground. */
#ifndef TERMINAL_THEME_H
#define TERMINAL_THEME_H

#include "picture/canvas.h"

/* Attributes beside colour; they alone carry the meaning where there is no colour. */
enum { LOOK_BOLD = 1, LOOK_UNDERLINE = 2, LOOK_REVERSE = 4, LOOK_DIM = 8 };

enum { LOOK_DEFAULT = -1 }; /* the terminal's own colour */

typedef struct Look {
    int foreground, background; /* colour numbers, or LOOK_DEFAULT */
    unsigned attributes;
} Look;

/* `colours` is 256, 8 or 0; `back` is a cell's: 0, or 1 + the style whose colour is its background. */
Look theme_look(int colours, bool light, unsigned style, unsigned back);

/* Whether the terminal has a light ground: "light", "dark", or "auto" (NULL) by COLORFGBG (may be NULL). */
bool theme_is_light(const char *theme, const char *colorfgbg);

#endif

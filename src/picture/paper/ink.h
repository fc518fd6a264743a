/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How the styles of the screen look on white paper. Private to src/picture/paper. */
#ifndef PICTURE_PAPER_INK_H
#define PICTURE_PAPER_INK_H

#include <stdbool.h>

#include "picture/paper/paper.h"
#include "picture/picture.h"

#define BLACK 0x000000u
#define WHITE 0xffffffu
#define GREY  0x5f5f5fu /* words that explain */
#define GRID  0xe4e4e4u

Colour ink_of(Style);

/* Whether it is that of an earlier run behind. */
bool ink_is_ghost(Style);

/* The line of a stroke or of a legend's entry. Earlier runs have dashes of their own, by their letter. */
Pencil ink_pencil(Style, LineStyle, char letter);

Colour ink_pale(Colour); /* halfway to white */

/* A band: the denser it is filled on screen, the darker. */
Colour ink_fill(Style, int fill);

/* Of a heat map: share 0 to 1 of its range. Light is little; of a signed field white is zero. */
Colour ink_heat(double share, bool is_signed);

/* Words with the powers of ten and squares of a printed text: "x10^-3" as a times sign and raised digits. */
void ink_words(const char *text, char *out, size_t size);

#endif

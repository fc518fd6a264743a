/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a terminal's colours are outside of one. */
#include "film/film.h"

#include "terminal/theme.h"

/* xterm's palette: 16 named colours, a cube of six levels each way, 24 greys. */
static unsigned palette(int colour)
{
    static const unsigned named[16] = {0x000000, 0xcd0000, 0x00cd00, 0xcdcd00, 0x0000ee, 0xcd00cd,
                                       0x00cdcd, 0xe5e5e5, 0x7f7f7f, 0xff0000, 0x00ff00, 0xffff00,
                                       0x5c5cff, 0xff00ff, 0x00ffff, 0xffffff};
    static const unsigned levels[6] = {0, 95, 135, 175, 215, 255};
    if (colour < 16)
        return named[colour];
    if (colour >= 232) {
        const unsigned grey = 8 + 10 * (unsigned)(colour - 232);
        return grey << 16 | grey << 8 | grey;
    }
    const int place = colour - 16;
    return levels[place / 36] << 16 | levels[place / 6 % 6] << 8 | levels[place % 6];
}

unsigned film_ink(int colour, bool light)
{
    return colour != LOOK_DEFAULT ? palette(colour) : light ? 0x202020 : 0xd8d8d8;
}

unsigned film_paper(int colour, bool light)
{
    return colour != LOOK_DEFAULT ? palette(colour) : light ? 0xffffff : 0x141618;
}

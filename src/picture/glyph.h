/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Characters, UTF-8 in and out, with the cells that each takes; and what things are drawn as. */
#ifndef PICTURE_GLYPH_H
#define PICTURE_GLYPH_H

#include <stddef.h>
#include <stdint.h>

/* What curves, frames and marks are drawn with. */
typedef enum Glyphs {
    GLYPHS_BRAILLE, /* 2x4 dots a cell */
    GLYPHS_BLOCK,   /* half blocks: what the Linux console has too */
    GLYPHS_ASCII,   /* one letter a curve; nothing else on the screen is beyond ASCII either */
    GLYPHS_COUNT,
    GLYPHS_NONE = GLYPHS_COUNT /* no cells: what is drawn goes into a picture, as finely as possible */
} Glyphs;

/* The next scalar value of a text, which moves on; 0 at its end, '?' for bytes that are not UTF-8. */
uint32_t glyph_next(const char **text);

/* Writes one scalar value; returns the bytes used. */
size_t glyph_put(char out[4], uint32_t glyph);

/* Cells that a character takes, 1 or 2, in any locale; 0: it cannot be shown in cells. */
int glyph_columns(uint32_t glyph);

/* The character, or what is shown for one that cannot be: a space for a control, else '?'. */
uint32_t glyph_shown(uint32_t glyph);

/* What stands for it where only ASCII can be shown, one cell for one cell; '?' where nothing does. */
uint32_t glyph_ascii(uint32_t glyph);

/* The same where letters are written in words: one that nothing stands for stays what it is. */
uint32_t glyph_told(uint32_t glyph);

/* The bit of a dot in a character of braille, 0x2800 and more: column 0 or 1, row 0 to 3 from above. */
uint8_t glyph_dot(int x, int y);

/* The head of an arrow of so many columns and rows; a row is as high as two columns are wide. */
uint32_t glyph_arrow(double across, double down);

/* Cells that a text takes; characters that it has. */
int glyphs_columns(const char *utf8);
int glyphs_count(const char *utf8);

/* The bytes of the next line of a paragraph, at most `width` columns, broken at a space or a '\n'; `rest` is
 * where the line after it begins. Where two spaces part formulas or phrases, it is broken there. */
size_t glyphs_line(const char *text, int width, const char **rest);

/* Text as a set of glyphs has it: with ASCII "→" becomes "->", "Δε" "de", and so on. */
void glyphs_plain(Glyphs, const char *text, char *out, size_t size);

/* --- styles --------------------------------------------------------------------------------------- */

/* What a cell or a stroke means, which the theme colours; never the only carrier of meaning. */
typedef enum Style {
    STYLE_NORMAL,
    STYLE_TITLE, /* title line and key line */
    STYLE_FRAME, /* borders, axes */
    STYLE_FOCUS, /* border of the focused pane */
    STYLE_HEADING,
    STYLE_FAINT,    /* ghosts, hints, read-only rows */
    STYLE_SELECTED, /* the chosen row */
    STYLE_EDIT,     /* a field under edit */
    STYLE_CHANGED,  /* a value that the last stage changed */
    STYLE_WARNING,
    STYLE_ERROR,
    STYLE_KEY,      /* a key's name in the key line */
    STYLE_MEASURED, /* curves */
    STYLE_PREDICTED,
    STYLE_EXACT,
    STYLE_SECOND, /* the second run of a duel, a second curve */
    STYLE_THIRD,
    STYLE_GHOST_A, /* earlier runs that are kept, by their letters */
    STYLE_GHOST_B,
    STYLE_GHOST_C,
    STYLE_GHOST_D,
    STYLE_GHOST_E,
    STYLE_RAMP_0, /* heat maps: STYLE_RAMP_0 + 0..RAMP_STEPS-1 */
    STYLE_COUNT = STYLE_RAMP_0 + 16
} Style;

enum { RAMP_STEPS = 16 };

#endif

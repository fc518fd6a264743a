/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What things are drawn as, in every back end. */
#ifndef PICTURE_STYLE_H
#define PICTURE_STYLE_H

/* What a cell or a stroke means; the theme gives it a colour and attributes. Never the only carrier of
 * meaning. */
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

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which panes there are, which one the keys go to, and what the terminal can show of them. */
#ifndef PANES_SHEET_H
#define PANES_SHEET_H

#include "picture/glyph.h"

#include <stdbool.h>

typedef enum PaneId {
    PANE_PARAMETERS,
    PANE_MESH,
    PANE_UPPER,
    PANE_LOWER,
    PANE_BOX,
    PANE_INSPECTOR,
    PANE_COUNT
} PaneId;

/* What a terminal can show, and what was asked for. */
typedef struct ScreenLook {
    Glyphs glyphs;
    int colours; /* 0: none; 8; 256 */
    bool light;  /* a light background */
} ScreenLook;

/* How much there is on the screen, in the order of parameter_sheet_words. */
typedef enum Sheet { SHEET_FULL, SHEET_PLAIN } Sheet;

typedef struct PanesShown {
    PaneId focus;
    bool zoomed;             /* the focused pane fills the screen */
    Sheet sheet;             /* see screen_is_plain() */
    bool lecture;            /* the plain sheet with thick curves and its number large */
    bool inspecting;         /* the inspector is open, see inspector_find() */
    PaneId before_inspector; /* the pane that had the focus before it was opened */
    PaneId last_plot;        /* the plot that was looked at last: what z magnifies */
    PaneId before_zoom;      /* the pane that had the focus before that */
    bool followed;           /* the focus came to a plot with a view that was asked for */
} PanesShown;

typedef struct HelpShown {
    bool open;
    int page, scroll;
    int found; /* the line of the page that a search found, from 1; 0: none */
    char sought[64];
} HelpShown;

#endif

/* From one picture to the next: the bytes that change a terminal's screen, and no more.
 *
 * Curses would do it too, but flushes at every move of the cursor; here a picture is one write, so that it is
 * seen whole even at the far end of a slow line. What a terminal understands is taken from its description
 * (terminfo) when the painter is opened; afterwards there are only canvases in and bytes out. */
#ifndef TUI_PAINTER_H
#define TUI_PAINTER_H

#include "view/draw/canvas.h"

#include <stdbool.h>
#include <stddef.h>

/* What the terminal's description must tell; an empty text: it cannot. */
typedef struct Capabilities {
    char move[64]; /* with two parameters, as terminfo writes it */
    char clear[32], plain[32], bold[32], dim[32], underline[32], reverse[32];
    char foreground[160], background[160]; /* with one parameter */
    char hide_cursor[32], show_cursor[32];
    bool margin_scrolls; /* a character in the last cell of the screen makes it scroll */
} Capabilities;

typedef struct Painter {
    Capabilities can;
    int colours; /* 256, 8 or 0 */
    bool light, utf8;
    Canvas shown; /* what the terminal shows; width 0: not known */
    bool cursor_shown;
    int x, y;             /* where the terminal writes next; -1: not known */
    unsigned style, back; /* in force at the terminal; STYLE_COUNT: not known */
    char *bytes;
    size_t length, room;
    bool failed; /* no memory: the picture is given up, the next is drawn whole */
} Painter;

void painter_close(Painter *);
void painter_forget(Painter *); /* what is shown is not known any more */

/* The bytes that turn what is shown into this canvas; none if there is no difference. They are valid until
 * the next call. What lies beyond width x height is left out. */
const char *painter_paint(Painter *, const Canvas *, int width, int height, size_t *length);

#endif

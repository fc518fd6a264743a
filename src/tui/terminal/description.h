/* What is known of the terminal before a byte goes to it: its description in the terminfo database, or that
 * of a relative, and what follows from it. One description is in force at a time. */
#ifndef TUI_DESCRIPTION_H
#define TUI_DESCRIPTION_H

#include "base/status.h"
#include "tui/terminal/painter.h"
#include "view/panes/screen.h"

/* What takes the screen over and gives it back, with the modes that the keys and the mouse need. */
typedef struct ScreenFrame {
    char enter[128], leave[160];
} ScreenFrame;

/* Puts the description of TERM in force. `*stand_in`: the known terminal that an unknown one is taken for;
 * NULL: it is known itself. False: standard input or output is no terminal, or one that cannot place its
 * cursor. */
bool description_open(const char *term, const char **stand_in, Status *);
void description_close(void);

void description_read(Capabilities *);
int description_colours(const Capabilities *); /* 256, 8 or 0; NO_COLOR is honoured */
bool description_has_mouse(void);
void description_frame(bool mouse, ScreenFrame *);

/* The glyph set for a name, a locale's character set and a TERM; false: the name is unknown. */
bool description_choose_glyphs(const char *name, const char *codeset, const char *term, Glyphs *);

#endif

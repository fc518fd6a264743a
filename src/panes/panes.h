/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The panes of the screen: each draws itself into an area from what the screen says. */
#ifndef PANES_PANES_H
#define PANES_PANES_H

#include "base/text.h"
#include "panes/entry.h"
#include "picture/canvas.h"
#include "picture/axes.h"
#include "picture/cells/cells.h"
#include "picture/plot.h"
#include "panes/screen.h"

typedef enum LayoutKind { LAYOUT_TOO_SMALL, LAYOUT_ONE_PANE, LAYOUT_FULL } LayoutKind;

/* From here on large digits are twice as large; in a lecture they are larger from LECTURE_HEIGHT on. */
enum { ROOMY_WIDTH = 120, ROOMY_HEIGHT = 36, LECTURE_HEIGHT = 22 };

enum { SIDES_MAX = 3, GUTTER = 6, SIDE_BY_SIDE = 120 /* columns from which on two runs stand so */ };

typedef struct Layout {
    LayoutKind kind;
    Rect title, keys;
    Rect question; /* of the plain sheet, so the number; width 0: there is none */
    Rect number;   /* what the scenario is about, in large digits */
    Rect timeline; /* one row under the plots; width 0: there is none */
    Rect panes[PANE_COUNT];
    Rect sides[SIDES_MAX]; /* what joins on a large screen: energies, particles, nodes */
} Layout;

Layout layout_make(const Screen *, int width, int height);

void pane_title(const Screen *, Area);
bool title_has_headline(const Screen *, int width); /* what the run is about is in it */

/* Of the plain sheet: the number that the scenario is about, in large digits with its words below; how many
 * rows it takes; what is asked, and the parameters that it is asked about, with what `t` tries. */
void pane_number(const Screen *, Area);
int pane_number_rows(const Screen *, int width, int height);
void pane_question(const Screen *, Area);
int pane_question_rows(const Screen *, int width);
void pane_asked(const Screen *, Area);
/* The first sentence of what a scenario says of itself that asks something; "": none does. */
void pane_question_text(const Screen *, char out[ABOUT_MAX]);
int pane_asked_rows(const Screen *);

void pane_keys(const Screen *, Area);

/* What the bar and the help say of a command: of a digit, what its view says. NULL: no view has it. */
const char *pane_command_brief(const Command *);
const char *pane_command_help(const Command *);

/* What the key line offers on this screen, help aside: a command, perhaps with another one that shares its
 * word, their keys as the line has them, and the word. Returns how many. */
enum { KEY_OFFERS_MAX = 12 };
typedef struct KeyOffer {
    const Command *command, *pair; /* pair: NULL: none */
    char keys[2][COMMAND_KEY_MAX];
    const char *word;
} KeyOffer;
int pane_key_offers(const Screen *, KeyOffer out[KEY_OFFERS_MAX]);
void pane_parameters(const Screen *, Area);
int pane_parameters_first(const ParametersShown *shown, int count,
                          int room); /* row at the top of so much room */
void pane_lesson(const Screen *, Area);
/* What is to be done to go on: "Space runs to t 5". */
void pane_lesson_footer(const Screen *, char *out, size_t size);
/* Rows that all of it needs; without gaps between paragraphs if with them it is more than `most`. */
int pane_lesson_rows(const Screen *, int width, int most);
int pane_lesson_at(const Screen *, Area, int row); /* whose title is in that row; -1: none */
void pane_timeline(const Screen *, Area);
void pane_box(const Screen *, Area);
void pane_stage(const Screen *, Area);
/* A view, both runs of a duel as it likes; one of its variants, for the run that the screen shows. */
void pane_view(const View *, const Screen *, Area, bool focused);
void pane_view_variant(const View *, const Screen *, Area, Style heading, int variant);
void pane_inspector(const Screen *, Area);
int pane_runs_rows(const Screen *); /* that a table of the runs in one picture takes; 0: there is none */
void help_draw(const Screen *, Area);

/* A text under edit in its field, with the cursor of the terminal. */
void pane_field(Area field, const char *text, int cursor);

/* One parameter with its value, as a row of its own; `chosen`: the arrows change it. */
void pane_parameter(const Screen *, Area, int y, const Parameter *, bool chosen);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A view: one picture of a run that can be in either of the two plot panes.
 *
 * A view is one value of type View in one file, src/views/view_NAME.c, with static functions behind it;
 * view_list.c names it once. Scenario keys ([view] upper, lower), `:show`, `figure --view`, the digit keys,
 * the key line, completion, the help and the manual all read that list, so no other file knows that the
 * view is there, and none knows the key that it usually has. A view decides by what the simulation has
 * (methods/method.h, Simulation.has) whether there is something to show. */
#ifndef VIEWS_VIEW_H
#define VIEWS_VIEW_H

#include "panes/screen.h"
#include "picture/picture.h"

typedef struct ConvergenceStudy ConvergenceStudy; /* answers/convergence.h */
typedef struct Rect Rect;                         /* picture/canvas.h */

/* How two runs of a duel are shown. */
typedef enum ViewDuel {
    DUEL_IN_AXES,  /* in the same axes; on a wide screen each in its own */
    DUEL_TOGETHER, /* always in the same: a run is a dot, or a letter in a list */
    DUEL_APART     /* always each in its own, as far as there is room: else A alone */
} ViewDuel;

/* Whether it is in its pane when a run says nothing of views; of several the one that asks for more. */
typedef enum ViewOpening { OPENS_ON_DEMAND, OPENS_ALWAYS, OPENS_IN_PLANE } ViewOpening;

struct View {
    const char *word;  /* names it wherever a view is named: small letters and '-', e.g. "energies" */
    const char *brief; /* for the key line, at most 8 columns; NULL: its word */
    const char *help;  /* one line */
    int digit;         /* the key that shows it, 1 to 9; 0: it is shown by its word alone */

    PaneId home; /* PANE_LOWER: a picture over time; PANE_UPPER: one over x, of one moment */
    ViewOpening opens;

    void (*describe)(const Screen *, int variant, Picture *); /* what it shows */
    /* The words of its variants, counted from 0; NULL: there are no more. NULL: they have no names. */
    const char *(*variant_word)(const Screen *, int variant);
    int (*variants)(const Screen *); /* how many there are without names; NULL: as many as words, or one */

    ViewDuel duel;
    bool names_run;         /* in DUEL_IN_AXES: its legend does not say whose picture it is */
    bool has_time_axis;     /* along which the arrows move a cursor */
    bool is_list;           /* in which the arrows go from row to row */
    bool is_map;            /* of the body itself: it can be magnified, displacements drawn larger */
    bool is_wide;           /* a drawing across the screen: a lesson's text stands above it, not beside */
    bool no_figure;         /* makes none */
    unsigned on_paper_with; /* which of these the simulation must have for it; 0: nothing */
    unsigned needs;         /* one of these the simulation must have (method.h); 0: nothing */
    const char *lacking;    /* why there is nothing to show without */

    /* Whether a variant shows the start of the run whatever the time; NULL: none does. */
    bool (*shows_start)(const Screen *, int variant);

    /* The study whose points a variant shows, worked out while one waits; NULL: it shows none. */
    const ConvergenceStudy *(*study)(const Screen *, int variant);

    /* The column or field that its present variant draws, for a foreign curve beside it; NULL: none. */
    const char *(*curve)(const Screen *);
};

/* The list, in the order of help and manual; view_list.c. */
extern const View *const views[];
extern const int n_views;

/* One view by what a person calls it: its word or its digit. NULL: there is none. */
const View *view_named(const char *word);
const View *view_of_digit(int digit);

/* "profile, probe, ... or 1 to 9": what view_named() takes. */
void view_names(char *out, size_t size);

/* What is in a plot pane when such a run is opened. */
const View *view_at_home(PaneId, const Simulation *);

/* The plot pane in which the number that the scenario is about is seen. */
PaneId view_pane_of_number(const Screen *);

/* What is in the plot panes when the run is opened: as the scenario says, else as the views like. */
void views_open(Screen *, const ViewSettings *);

/* The name of the curve on screen that is meant, of the plot over time or of the field along the bar: that in
 * focus, else the first of the list with such an axis. */
const char *view_curve(const Screen *, bool over_time);

/* The view that is a map; NULL: there is none. */
const View *view_of_map(void);

/* Whether the views with their variants and the number that a scenario names exist; false: the status says
 * which and what there is. Variants that differ from those of `known` (NULL: none) are asked of a run that is
 * made for it. */
bool view_check(const Settings *, const Settings *known, Status *);

/* --- one view on one screen -------------------------------------------------------------------------- */

/* Why it has nothing to show for this run; NULL: it has. */
const char *view_missing(const View *, const Screen *);

/* How many variants there are, at least 1, and the one that is chosen, counted from 0. */
int view_variants(const View *, const Screen *);
int view_variant(const View *, const Screen *);
void view_choose_variant(const View *, Screen *, int variant);

/* Whether it can be drawn on paper for this run. */
bool view_is_on_paper(const View *, const Screen *);

/* The word of a variant; NULL: there is no such variant, or only one. */
const char *view_variant_word(const View *, const Screen *, int variant);

/* Which of them has that word; -1: none. */
int view_variant_named(const View *, const Screen *, const char *word);

/* The study whose points the present variant shows; NULL: none. */
const ConvergenceStudy *view_study(const View *, const Screen *);

/* Makes its picture for a page or for words, of so many characters. */
void view_describe(const View *, const Screen *, int columns, int rows, Picture *);

/* Keys and mouse in its pane, which lies at `rect`, answered by what its picture says of its places. Arrows
 * in a list, `page` rows at a time; what Enter does there: the step to go to, or -1, and what is to be drawn
 * over time in the words of `:plot`, or ""; a click, and the wheel: false where they hit nothing. */
void view_move(const View *, Screen *, Rect rect, int x, int y, int page);
long view_enter(const View *, Screen *, char follow[FOLLOW_TEXT_MAX]);
bool view_click(const View *, Screen *, Rect rect, int x, int y);
bool view_scroll(const View *, Screen *, Rect rect, int x, int y, int by);

/* --- views that others name, and pictures in files of their own ----------------------------------- */

extern const View view_profile, view_probe, view_energies, view_table, view_beam, view_log;

/* What the inspector shows (inspector/inspector.h); it is in no list, for it has a pane of its own. */
extern const View view_inspector;

/* The body in the pane that is its own, where a map is in neither plot pane; no word shows it. */
extern const View view_strip;

/* Of a body that breaks: the crack's path, angle and speed among the probe's pictures, what it costs and
 * where that went among the energies. A count of 0, a word of NULL: it does not break. */
int crack_variants(const Screen *);
const char *crack_variant_word(int variant);
void crack_describe(const Screen *, int variant, Picture *);
const char *crack_cost_variant_word(const Screen *, int variant);
void crack_cost_describe(const Screen *, int variant, Picture *);

/* One bond with its two ends, or the strongest of a family, in the place of a cell where there is no mesh. */
void cell_bonds_describe(const Screen *, int variant, Picture *);

/* The map with where it is held and loaded alone: where a node lies in it. False: there is none. */
bool view_map_small(const Screen *, Picture *);

/* "640 m/s = 0.30 c_R, fastest 904 = 0.42": how fast a crack's tip is now. */
void beam_lines_tip_speed(const Crack *, double rayleigh, char out[160]);

/* Two notes of what a beam's run is judged by; false: a bar, or what comes to rest: findings say more. */
bool beam_lines(const Screen *, char first[160], char second[160]);

/* They are below other plots of the run too; `first` takes the place of the first one, "": nothing does. */
void beam_note_lines(const Screen *, Picture *, const char *first);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is in the plot panes, and what is chosen, read and magnified there. */
#ifndef VIEWS_VIEWS_SHOWN_H
#define VIEWS_VIEWS_SHOWN_H

#include "methods/method.h"

typedef struct View View; /* views/view.h */

enum { VIEWS_MAX = 32 };

typedef enum ReferencesShown { SHOW_ALL, SHOW_EXACT, SHOW_PREDICTED, SHOW_NONE, SHOW_COUNT } ReferencesShown;

/* Which of its variants a view shows; of one that is not named, the first. */
typedef struct ViewVariant {
    const View *view;
    int variant;
} ViewVariant;

typedef struct ViewsShown {
    const View *upper, *lower;
    ViewVariant variants[VIEWS_MAX];
    int n_variants;
    ReferencesShown references;
} ViewsShown;

/* The axis of time. */
typedef struct TimeShown {
    double window; /* its length; 0: automatic */
    double cursor; /* the time of the plot's cursor; NAN: none */
} TimeShown;

/* What is seen of the map of a body. */
typedef struct MapEye {
    bool open;        /* arrows, + and - move it */
    double magnified; /* 1: the whole body */
    double centre[2]; /* shares of its length and height */
} MapEye;

/* Where one reads in the log. */
typedef struct LogPlace {
    int event; /* the chosen one; -1: the newest */
    int first; /* the first one shown, as far as that leaves the chosen one in sight */
} LogPlace;

/* The things that all panes speak of. */
typedef struct Selection {
    size_t particle, node;
    bool is_node;     /* stage box and inspector follow the node, not the particle */
    int table_column; /* the one that is marked in a table */
} Selection;

/* The chosen particle or, where a node is chosen, node: so many on. */
void selection_next(Selection *, const Simulation *, int direction, size_t by);

/* The one that is looked at first: in the middle of a bar, of a beam's middle row. */
size_t selection_middle(const Simulation *);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The terms that a stage passes between one thing of a mesh and those that it is linked with, as the pictures
 * of a cell write them: on arrows, strongest first, and so that they add up as they stand. */
#ifndef VIEWS_CELL_TERMS_H
#define VIEWS_CELL_TERMS_H

#include "panes/screen.h"
#include "picture/picture.h"
#include "picture/sum_column.h"

enum { CELL_LINKS_MAX = 256, CELL_TERM_WIDTH = 10 };

/* What a stage passes between the chosen one and its links, in one exchange. */
typedef struct Flowing {
    const Exchange *exchange;
    double terms[CELL_LINKS_MAX],
        last[CELL_LINKS_MAX]; /* and the last factor of each, which is of the giver */
    double sum;
    Writing writing;
} Flowing;

typedef struct CellTerms {
    const Simulation *sim;
    int set; /* of the chosen one: 0 a particle, 1 a node */
    size_t index;
    Link links[CELL_LINKS_MAX];
    size_t n_links;
    size_t order[CELL_LINKS_MAX]; /* of links: the first ones are drawn */
    size_t shown;
    Flowing flows[PICTURE_ARROW_LINES];
    int n_flows;
    bool to_nodes;
} CellTerms;

/* The links of `set`, `index`, which are in `terms` with `sim`, and what passes in the stage (NULL:
 * nothing), strongest first; of more links than `most`, most - 1 are shown. Of one unit the stronger exchange
 * comes first, of two that with more factors: mass with velocity before mass alone. */
void cell_terms_find(CellTerms *, const Stage *, size_t most);

/* A term as it is in a sum of such a writing. */
NumberText cell_term_text(double value, Writing);

/* The words on the arrow of a link. */
void cell_terms_arrow(const CellTerms *, size_t link, PictureArrow *);

/* The weaker ones, each exchange as one number: "5 more: m v N 0.01, m N 0.2"; "": there are none. */
void cell_terms_rest(const CellTerms *, char *out, size_t size);

/* A line "p 0.035" of a field by its name, or with what it was before the stage "p 0.0012→0". */
void cell_value_add(const Screen *, int set, size_t index, const char *name, const char *label, bool change,
                    char *out, size_t size);

#endif

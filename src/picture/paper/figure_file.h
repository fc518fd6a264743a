/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figures for paper: what views show, taken down as pictures (picture/picture.h) and drawn with lines and
 * fonts on one page with title, axes, legend and the parameters of the run, as SVG, PDF or PNG;
 * or, of curves, written as the source of a picture of pgfplots (LaTeX) or of gnuplot.
 *
 * Colours are distinguishable in all kinds of colour vision, and lines by their dashes, so that a copy in
 * black and white says the same. The same figure gives the same bytes. */
#ifndef PICTURE_PAPER_FIGURE_FILE_H
#define PICTURE_PAPER_FIGURE_FILE_H

#include "base/output.h"
#include "panes/screen.h"
#include "picture/picture.h"

enum { FIGURE_PANELS_MAX = 24, FIGURE_TEXT_MAX = 12288 };

typedef struct FigurePanel {
    char caption[64]; /* "t 12.3": where a picture is of one moment, or there are several */
    Picture picture;
} FigurePanel;

typedef struct Figure {
    char title[256];
    char parameters[FIGURE_TEXT_MAX]; /* phrases separated by two spaces */
    double width, height;             /* mm; height 0: as much as it takes */
    bool bare;                        /* curves and axes alone, from edge to edge */
    FigurePanel *panels[FIGURE_PANELS_MAX];
    int count;
} Figure;

/* Whether a name ends in .svg, .pdf, .png, .tex or .gp. */
bool figure_is_name(const char *file);

/* Whether a file of that name can be written, by its ending. Nothing is touched. */
bool figure_allowed(const char *file, Status *);

/* The view of a name on this screen: "profile:stress" chooses a variant, "profile" has the one on screen. */
bool figure_view(Screen *, const char *name, const View **view, Status *);

/* The names that figure_view() takes for this screen, one a line, each with what it shows. */
void figure_names(const Screen *, FILE *);

void figure_open(Figure *, double width, double height);
void figure_close(Figure *);

/* Adds what a view shows at present as the next of so many panels. False: it has nothing to show (the status
 * says why), or there are too many panels. */
bool figure_add(Figure *, const Screen *, const View *, int panels, Status *);

/* The least factor of displacements among the maps of the figure; 0: there are none. *differ: several. */
double figure_enlargement(const Figure *, bool *differ);

/* Whether a file of that name can hold the figure: LaTeX and gnuplot draw curves alone. */
bool figure_suits(const Figure *, const char *file, Status *);

/* Draws the page, whole or not at all. Maps of one field share the range of their colours. */
bool figure_write(Figure *, Asker, const char *file, bool force, Status *);

/* plot_source.c: the panels in so many columns as a file to \input in LaTeX, or a script of gnuplot. */
void figure_write_tex(FILE *, const Figure *, int columns);
void figure_write_gnuplot(FILE *, const Figure *, int columns);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the words and numbers of tables stand, on rows and columns of characters: numbers that are added up
 * have their points under each other, and what gives way where room is short does so by one order for cells
 * and paper. */
#ifndef PICTURE_TABLE_H
#define PICTURE_TABLE_H

#include "picture/picture.h"
#include "picture/sum_column.h"

typedef struct TableSheet TableSheet;

/* A back end fills the first members. */
struct TableSheet {
    int columns, rows;
    Glyphs glyphs;
    /* Writes words that begin at a column or, `to_end`, end before it. NULL: nowhere. */
    void (*write)(const TableSheet *, int column, int row, const char *text, Style, bool to_end);
    /* So many columns stand for a thing. NULL: nobody asks. */
    void (*stand)(const TableSheet *, int column, int row, int width, PictureThing);
    void *back_end; /* its own */
};

/* Writes all that stands below the heading: notes, what is around, tables. */
void tables_write(const Picture *, const TableSheet *);

/* How all terms of a column are written in so many columns of characters, with their sum. */
Writing table_writing(const PictureTable *, const TableColumn *, int width, double *sum);

/* The decimals of a row under them: what is added to something keeps all of them. */
int table_decimals(const TableColumn *, TableTotal, Writing);

/* Whether what is around and the tables have no room beside each other. */
bool tables_are_parted(const Picture *, int columns);

/* The columns and rows that what is around takes where it is beside the tables; false: it does not. */
bool tables_around(const Picture *, int columns, int *width, int *height);

#endif

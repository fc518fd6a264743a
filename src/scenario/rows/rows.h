/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a plate has any number of: cuts, loads, supports, impulses, protected regions; and the bodies of a
 * box. Each is a row of the scenario file, a name chosen by the user and its values in one line,
 *
 *     [loads]
 *     top = top 0% 100% 0 12MPa ramp 1us
 *
 * and so data: one table (row_kinds) says for each kind what values its rows have. The scenario reader and
 * writer, --set, comparisons, the manual and the editor of rows on screen read that table and the functions
 * below. A value is one word: "5mm", "25/3mm", "50%" (a share of the plate's length or height). The section
 * of the probe has one row without a name, whose values are its keys.
 *
 * As keys: "loads.top" is a row, "loads.top.sy" one of its values, "probe.x" one of the probe's. */
#ifndef SCENARIO_ROWS_ROWS_H
#define SCENARIO_ROWS_ROWS_H

#include "base/status.h"

#include <stdbool.h>

typedef struct Settings Settings; /* settings.h */

enum {
    ROWS_OF_KIND_MAX = 16, /* of a kind */
    ROW_NAME_MAX = 24,     /* bytes, with the final zero */
    ROW_VALUES_MAX = 16,   /* of a row */
    ROW_TEXT_MAX = 256
};

typedef enum RowKinds {
    ROWS_CUTS,
    ROWS_LOADS,
    ROWS_SUPPORTS,
    ROWS_IMPULSES,
    ROWS_PROTECTED,
    ROWS_PROBE,
    ROWS_BODIES,
    ROW_KINDS
} RowKinds;

typedef struct Row {
    char name[ROW_NAME_MAX];       /* letters, digits, _ and -; "" where the kind has no names */
    double values[ROW_VALUES_MAX]; /* by the kind's columns; shares in per cent, words by index */
    unsigned shares, given;        /* a bit for each: it is a share; it is there */
} Row;

typedef struct RowList {
    Row rows[ROWS_OF_KIND_MAX];
    int count;
} RowList;

/* What a value of a row is. */
typedef enum RowValue {
    ROW_ALONG_X,    /* a place along the plate's length, or a share of it */
    ROW_ALONG_Y,    /* likewise of its height */
    ROW_ALONG_EDGE, /* likewise of the edge that the row's first value names */
    ROW_EDGE,       /* a word: top, bottom, left, right */
    ROW_SHAPE,      /* a word: disc, ring, block */
    ROW_SIZE,       /* above 0 */
    ROW_NUMBER,
    ROW_TIME /* above 0 */
} RowValue;

typedef struct RowColumn {
    const char *word; /* "x0"; of an optional value it stands before it in the line */
    RowValue value;
    const char *unit;
    bool optional;
    bool follows;     /* an optional one that comes with the one before, without a word of its own */
    const char *line; /* the word before it in the line, where that is another; NULL: none */
    unsigned of;      /* the choices of the row's first word that have it, a bit for each; 0: all */
    double absent;    /* what settings_row_value() says of an optional one that is not there */
} RowColumn;

typedef struct RowKind {
    const char *section; /* "cuts" */
    const char *one;     /* "cut" */
    const char *form;    /* "X0 Y0 X1 Y1" */
    const char *help;    /* one line */
    int concern;         /* of the problems that have such rows: problems/problem.h */
    const char *fresh;   /* a new row's values; NULL where none can be added */
    const char *usual;   /* not NULL: there is one row without a name, and this is its usual text */
    bool needs_optional; /* at least one of the optional values must be there */
    bool plain_names;    /* a to z, 0 to 9 and _, a letter first */
    RowColumn columns[ROW_VALUES_MAX];
    int n_columns;
} RowKind;

extern const RowKind row_kinds[ROW_KINDS];

extern const char *const row_edge_words[]; /* top, bottom, left, right, NULL */
enum { ROW_TOP, ROW_BOTTOM, ROW_LEFT, ROW_RIGHT };
extern const char *const row_shape_words[]; /* disc, ring, block, NULL: BodyShape */

/* The words of a value that is one; NULL: it is a number. */
const char *const *row_words(RowValue);

/* Whether a row of the kind has the value at all: a disc has no second radius. */
bool row_has(const RowKind *, const Row *, int column);

/* The kind whose section this is; -1: none. */
int row_kind_find(const char *section);

/* Whether the problem of these settings has rows of the kind. */
bool settings_have_rows(const Settings *, int kind);

/* All rows as a problem begins with: none, but for those that are always there. */
void settings_default_rows(Settings *);

/* The row of that name; -1: there is none. */
int settings_row_find(const Settings *, int kind, const char *name);

/* Adds a row, or replaces the one of that name in its place. False: the name or the text is not allowed, or
 * there are ROWS_OF_KIND_MAX already; the status's text is "loads.top: what is wrong (what is allowed)", and
 * nothing is changed. */
bool settings_row_set(Settings *, int kind, const char *name, const char *text, Status *);

/* False: there is none of that name, and the status says which there are. */
bool settings_row_remove(Settings *, int kind, const char *name, Status *);

/* A row as text that settings_row_set() reads back to the same bits; and for reading: at most six digits. */
void settings_row_get(const Settings *, int kind, int row, char out[ROW_TEXT_MAX]);
void settings_row_show(const Settings *, int kind, int row, char out[ROW_TEXT_MAX]);

/* One value of a row in SI units (an edge: its index), shares worked out; of an optional one that is not
 * there what its column says. */
double settings_row_value(const Settings *, int kind, int row, int column);

/* Sets a row, one value of it, or by the word "none" takes the row away, by its key: "loads.top",
 * "loads.top.sy", "probe.x". */
bool settings_row_key_set(Settings *, const char *key, const char *text, Status *);

/* Whether a key is of a section of rows that these settings have. */
bool settings_row_is_key(const Settings *, const char *key);

/* What the key of one value of a row is about, whether or not there is such a row; NULL: no such key. */
const RowColumn *row_key_column(const char *key);

/* The number behind the key of one value, NAN: the key is none; to be varied like a parameter. */
double settings_row_number(const Settings *, const char *key);

/* What a key stands for, to be read: a row's text, a value in SI units, an edge's word; "none": there is
 * none. */
void settings_row_key_show(const Settings *, const char *key, char out[ROW_TEXT_MAX]);

/* The row or value that a key of screen.ask names: "loads.top" a row, "loads.top.sy" one value of it,
 * "loads.sy" that value of all loads, which change by one factor. */
typedef struct RowPlace {
    int kind, row; /* of all rows the first whose value is there and not 0 */
    int value;     /* its column, counted from 1; 0: the row as a whole */
    bool all;
} RowPlace;

/* False: the key means no row or value, and the status says which there are; true with a row of -1: of the
 * values that it means none is there now. */
bool settings_row_asked(const Settings *, const char *key, RowPlace *, Status *);

/* What it is called, "sy of load top", and its value with its unit; the whole row: its name and its line. */
void settings_row_place_show(const Settings *, const RowPlace *, char name[64], char value[ROW_TEXT_MAX]);

/* One value: from its text, or from a number in SI units, where what was a share of the plate stays one. */
bool settings_row_place_set(Settings *, const RowPlace *, const char *text, Status *);
void settings_row_place_put(Settings *, const RowPlace *, double value);

/* Do all rows lie on the plate? Else the status names the row, what is wrong and what is allowed. */
bool settings_rows_check(const Settings *, Status *);

/* Whether two settings of one problem have the same rows. */
bool settings_rows_same(const Settings *a, const Settings *b);

typedef struct RowDifference {
    int kind;
    const Row *in_a, *in_b; /* NULL: there is none of that name */
} RowDifference;

/* Difference number `which`, those of the rows of `a` first. False: there are no more. */
bool settings_rows_difference(const Settings *a, const Settings *b, int which, RowDifference *);

/* What it is about ("load top"), and what it is in `a` and in `b`: what differs of the row ("sy 7e6"), its
 * text, or "none". */
void row_difference_show(const RowDifference *, char about[64], char in_a[ROW_TEXT_MAX],
                         char in_b[ROW_TEXT_MAX]);

/* The line of one row; for the files of this folder. `about` is the row's key, for messages. */

/* Reads a whole line, and one value from its word; the name is kept. False: nothing is changed, the status
 * says what is allowed. */
bool row_read(const RowKind *, const char *text, Row *, const char *about, Status *);
bool row_read_value(const RowKind *, int column, const char *word, Row *, const char *about, Status *);

/* The line of a row with so many significant digits; 0: as it takes to read back to the same bits. */
void row_write(const RowKind *, const Row *, int digits, char out[ROW_TEXT_MAX]);

/* What a row has that another one has otherwise: "sy 7e+6 until 1e-5". */
void row_write_difference(const RowKind *, const Row *, const Row *other, char out[ROW_TEXT_MAX]);

/* Of what a place is: "plate", "box". */
const char *row_whole_word(const RowKind *);

bool row_same(const RowKind *, const Row *a, const Row *b);

#endif

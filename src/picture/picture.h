/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a view shows, as data in its own coordinates: title, axes, strokes, marks, legend, words. A view
 * describes it once; back ends make cells of it (cells/), a page (paper/) or sentences (words/), and each of
 * them decides how many ticks, lines and words it has room for. */
#ifndef PICTURE_PICTURE_H
#define PICTURE_PICTURE_H

#include "picture/plot.h"

enum {
    PICTURE_KEYS_MAX = 32,
    PICTURE_NOTES_MAX = 16,
    PICTURE_LABELS_MAX = 48,
    PICTURE_ARROWS_MAX = 32,
    PICTURE_ARROW_LINES = 4,
    PICTURE_KINDS_MAX = 16,
    PICTURE_TEXT_MAX = 384
};

/* What it is: words describe each in another way. */
typedef enum PictureKind {
    PICTURE_FUNCTION, /* curves over x */
    PICTURE_UPRIGHT,  /* curves that go across, over a height */
    PICTURE_PATH,     /* lines in a plane, which may turn back */
    PICTURE_BARS,     /* a bar for each of some parts, beside levels */
    PICTURE_MAP,      /* a body as it lies */
    PICTURE_DRAWING,  /* things in their places, with numbers and arrows; its axes are not drawn */
    PICTURE_STRIP,    /* a body in a few rows */
    PICTURE_LIST,     /* rows below each other, of things or events */
    PICTURE_TABLES    /* one thing with what it exchanges with others, as sums */
} PictureKind;

/* What a strip is of. */
typedef enum StripKind { STRIP_CELLS, STRIP_NODES, STRIP_BODY } StripKind;

/* In a legend's entry for a piece of its line: a mark, a run's letter, or one of these. */
enum { SIGN_DOTS = 0x110000, SIGN_BAND };

/* An entry of the legend. */
typedef struct PictureKey {
    LineStyle line;
    char ascii; /* what the line is drawn with where there are only letters */
    Style style;
    const char *name;
    uint32_t sign; /* 0: a piece of the line */
    int fill;      /* of SIGN_BAND, as the stroke's */
} PictureKey;

/* A thing that a place of a picture stands for: the index in its set. */
typedef struct PictureThing {
    int set; /* -1: there is none */
    size_t index;
} PictureThing;

typedef enum MarkKind {
    MARK_PLACE, /* a dot, ring or letter */
    MARK_AGAIN, /* a letter once more on its curve, where curves cannot be distinguished by their dashes */
    MARK_DOT,   /* on one of many dots, which a curve may cover where it is wide; a page shows them all */
    MARK_FINE,  /* narrower than a character: others may be in the same one */
    MARK_RULE,  /* a vertical line across the plot, perhaps with a word at its head */
    /* of a body: */
    MARK_BESIDE, /* just outside its place, on `side` */
    MARK_STANDS, /* below or above it, wherever that is: a support, a load */
    MARK_BAR,    /* which shows a share, the side[0]-th to the right of its place */
    MARK_CHOSEN  /* where one is on the screen: none on a page */
} MarkKind;

typedef struct PictureMark {
    double x, y;
    uint32_t glyph;
    Style style;
    MarkKind kind;
    char ascii;       /* in place of the glyph where there are only letters; 0: what usually stands for it */
    char letter;      /* beside it; 0: none */
    const char *word; /* of a rule; NULL: none */
    bool is_target;   /* of the mouse, which finds this thing there */
    PictureThing thing;
    signed char side[2]; /* of its place on which it stands: to the right, upwards */
    double share;        /* of a bar: 0 to 1 */
    double half;         /* of its width */
} PictureMark;

/* A line of words beside the picture: phrases that are separated by two spaces. */
typedef struct PictureNote {
    Style style; /* STYLE_FAINT: an explanation, not a result */
    bool joins;  /* goes on behind the one before where lines are long */
    bool flows;  /* goes on behind the one before where there is room for both */
    bool spare;  /* shown where the plot is larger than it must be; with others of the kind, or not at all */
    bool told;   /* in words alone, behind the others: what a look at the picture says */
    int rows;    /* that it may take where there are many; 0 is 1 */
    uint32_t sign; /* of the mark that it describes; 0: none */
    Style sign_style;
    char text[PICTURE_TEXT_MAX];
    char brief[PICTURE_TEXT_MAX]; /* the same where that has no room; "": it is cut */
} PictureNote;

/* A body of coloured pieces on a lattice, or pieces anywhere in one row (is_cloud): piece k lies in column k
 * % nx and row k / nx, row 0 below, and is centred at (x, y) as drawn, displacements enlarged, in the
 * coordinates of the plot, m. Its heading is what the colours mean; the first of the notes says how it is
 * drawn, the second what its lines and bars are. */
typedef struct PictureMap {
    int nx, ny;
    double *x, *y, *value;
    bool *torn;       /* too much to have a colour; a cell in which most are shows none */
    double size;      /* of a piece, both ways */
    double low, high; /* range of the colours */
    int kinds; /* values are numbers of so many things, each with its colour and name; 0: of the ramp */
    const char *kind_names[PICTURE_KINDS_MAX];
    bool is_cloud;   /* its lengths have no unit */
    bool is_signed;  /* zero is in the middle */
    bool open_ended; /* some values lie above it */
    char unit[16];   /* SI; "" for a number */
    char brief[48];  /* the heading where room is short */

    /* how it lies, by picture_lay_body() */
    double enlarged;            /* the factor of the displacements across it, */
    double along;               /* and of those along it */
    double middle[2], scale[2]; /* the place in the middle; characters to a metre, across and down */
    int keys_at;                /* of them, from where on it leaves room for its lines' names; 0: nowhere */
    bool is_part;               /* it is magnified: how long a part is in sight is given beside the colours */
    bool is_near;               /* its pieces are seen one by one, as dots */
} PictureMap;

/* What a body asks for when it is laid out. */
typedef struct BodyRoom {
    double low[2], size[2]; /* where it lies before it moves, m */
    double spacing;         /* of its pieces */
    double travel;          /* its way to the right: displacements along it are drawn as they are */
    bool travels;
    double reach;     /* the largest displacement across it; 0: not known */
    double enlarged;  /* if that is given; 0: as there is room */
    bool in_box;      /* it moves in a box, which is drawn with both lengths to one scale, and walls around */
    bool pressed;     /* between a load above and supports below: deep, it keeps its shape */
    bool on_mesh;     /* seen from near it is drawn as it is, in its cells */
    double magnified; /* and then what is in the middle, with its displacement */
    double eye[2], moved[2];
} BodyRoom;

/* Words at a place of the plot, centred on its height, no higher than 1 in its coordinates. Beside a body
 * with its dimensions those in STYLE_NORMAL are sizes, which keep a space from lines. */
typedef struct PictureLabel {
    double x, y;
    int side;      /* of the place on which they stand: -1 left, 0 both, 1 right; a line is broken for both */
    double height; /* of the band that they name; 0: of none */
    bool spare;    /* of a drawing: shown where arrows have left room */
    Style style;
    const char *thing; /* said before them in words, where the place does not say: "node"; NULL: nothing */
    bool says_thing;   /* in a drawing too, where there is room */
    char text[96];     /* of a drawing: lines below each other, as many as have room, separated by '\n' */
} PictureLabel;

/* What goes from one place of a drawing to another. It is a stroke of the plot too, but of a body, where it
 * leaves the things at its ends free. */
typedef struct PictureArrow {
    double from[2], to[2];
    Style style;
    int side; /* of `at`, on which its words stand: -1 left, 1 right; 0: on its way */
    double at[2];
    double place; /* of its words: the share of its way, where there is room */
    char text[PICTURE_ARROW_LINES][48],
        brief[PICTURE_ARROW_LINES][32]; /* what goes, first what is shown if there is room for one */
    char told[192];                     /* the whole as words have it */
} PictureArrow;

typedef enum ListKind {
    LIST_NUMBER, /* its values are written alike */
    LIST_COUNT,  /* whole numbers */
    LIST_SIGN,   /* a letter */
    LIST_WORDS   /* the last one: on as many lines as they take */
} ListKind;

typedef struct PictureColumn {
    ListKind kind;
    char name[88]; /* at its head */
} PictureColumn;

typedef struct PictureCell {
    double value;
    const char *words; /* not copied: they live as long as the picture */
    char letter;
    Style style;
} PictureCell;

/* Rows, one of them chosen; each begins with a name, number or time, and stands for a thing or an event. */
typedef struct PictureList {
    int set;              /* whose things they are; -1: events */
    size_t count, chosen; /* of all rows */
    size_t first, rows;   /* those that are described: as many as can be in sight */
    size_t top;           /* of events the first one in sight, as it was left */
    char what[24];        /* above the rows' names: "particle"; "": columns have no names */
    char (*names)[48];
    int n_columns, chosen_column; /* -1: none */
    PictureColumn *columns;
    PictureCell *cells; /* column after column */
} PictureList;

enum { TABLE_COLUMNS_MAX = 10, TABLE_ROWS_MAX = 64 };

/* A column of terms that add up as they are printed, or of their factors. */
typedef struct TableColumn {
    char name[32]; /* at its head: a formula */
    const char *label,
        *brief; /* of terms, above that: what their sum is, in full or where columns stand close; or NULL */
    bool adds;
    Style style; /* of terms */
    unsigned in; /* of a factor: the columns of terms that have it, a bit for each */
    bool stays;  /* of a factor: it is shown with any term, if there is room */
    double values[TABLE_ROWS_MAX];
    double base, result; /* what the sum is added to, and what there is then; NAN: not known */
} TableColumn;

/* The rows below the terms. */
typedef enum TableTotal { TOTAL_SUM, TOTAL_BASE, TOTAL_RESULT, TOTALS } TableTotal;

/* Things in rows, what they give or get in columns, and the sums of that. One of a single column lies on its
 * side. Where room is short, this says which rows and columns go: of rows those of the highest rank, which
 * are then summed up; of columns factors, then all terms but those with the longest formula. */
typedef struct PictureTable {
    char title[200], brief[96]; /* "": none; where there is no room for it */
    char notes[100];            /* what factors stand for */
    const char *what;           /* above the rows' names; this and those below are not copied */
    const char *more;           /* the name of those that are summed up, behind their number */
    size_t count, own;          /* rows; the one of the thing that is looked at, or `count` */
    struct TableRow {
        char name[24];
        int rank;
        PictureThing thing;
    } rows[TABLE_ROWS_MAX];
    int n_columns;
    TableColumn columns[TABLE_COLUMNS_MAX];
    bool of_directions; /* terms belong together: all factors but the first give way before one of them */
    struct TableTotals {
        const char *name; /* NULL: there is no such row */
        Style style;
    } totals[TOTALS];
} PictureTable;

enum { AROUND_MAX = 8, AROUND_SIDE = 2 * AROUND_MAX + 1 };

/* The things around the one that is looked at, on a lattice, each with its number. */
typedef struct PictureAround {
    int reach;        /* places to each side of it */
    char meaning[64]; /* of numbers and signs */
    struct AroundPlace {
        bool is_there;
        double value;
        uint32_t sign; /* in place of its number; 0: none */
        Style style;
        PictureThing thing;
    } places[AROUND_SIDE][AROUND_SIDE]; /* from below, from the left */
} PictureAround;

typedef struct Picture {
    /* what it is asked for with */
    int columns; /* characters in a line of words */
    int rows;    /* lines of them that there is room for, heading and all */
    int across;  /* characters across the plot; 0: there is no room for one */
    int dots;    /* that a curve can have across */
    int body[2]; /* characters across and down that a body can take, within a frame; of a strip: takes */
    bool whole;  /* there are no places between characters, and no rows beyond these */

    PictureKind kind;
    StripKind strip; /* of PICTURE_STRIP */
    bool of_moment;  /* of that time alone, not of all up to it */
    bool compares;   /* its curves are of one quantity: words say how far the measured one is from others */
    bool has_axes;   /* if not, there is nothing to draw and the notes say why */
    bool bare;       /* the axes only say where things are: a drawing, with labels */
    double stretch;  /* a length upwards is drawn so many times as long as one across; 0: as there is room */
    char time[48];   /* "t 12.34" */
    char name[PICTURE_TEXT_MAX], unit[24]; /* of what goes up: "v_cm"; its unit, SI, or "" */
    char heading[PICTURE_TEXT_MAX];        /* the two with the axis's power of ten */
    char x_name[PICTURE_TEXT_MAX];
    Plot plot;            /* its axes, and the strokes */
    PictureMap *map;      /* NULL: it is a plot */
    PictureList *list;    /* NULL: it is a picture in axes */
    PictureTable *tables; /* by weight: the first is shown in any case, others whole or not at all */
    int n_tables;
    PictureAround *around; /* beside the tables; NULL: nothing */
    bool tables_first;     /* where there is no room for both, that is what is looked at */
    char brief[96];        /* of tables the heading where room is short */
    char hints[2][64];     /* behind it, what keys do there, in full or in short; */
    char turn_hint[24];    /* and what shows the other one, where there is no room for both */
    long step;             /* Enter goes there: of a list on its chosen row; -1: nowhere */
    char follow[64];       /* or draws this over time, as `:plot` has it; "": nothing */
    bool of_side;          /* of one run of two: whose it is will stand at the end of the heading */
    PictureMark *marks;
    size_t n_marks, marks_room;
    PictureLabel labels[PICTURE_LABELS_MAX + 1]; /* as with notes below */
    int n_labels;
    PictureArrow arrows[PICTURE_ARROWS_MAX];
    int n_arrows;
    PictureKey keys[PICTURE_KEYS_MAX]; /* their names stand here too: a picture is not copied */
    char key_names[PICTURE_KEYS_MAX][96];
    int n_keys;
    PictureNote notes[PICTURE_NOTES_MAX + 1]; /* the last one takes what has no room */
    int n_notes;
} Picture;

/* For so many characters in a line of words and across the plot, with so many dots in one, and rows. */
void picture_open(Picture *, int columns, int rows, int across, int dots);
void picture_close(Picture *);

/* Without memory something is left out of what is added; the plot is `lost` then. */

/* Both axes with their names and SI units; "": none. Strokes come after them. Ticks are found for the room
 * that there is in the end, by picture_ticks(). */
void picture_axes(Picture *, Axis x, const char *x_name, const char *x_unit, Axis y, const char *name,
                  const char *unit);

void picture_ticks(Picture *, int along, int up);

/* There is nothing to draw; the text, which may be "", says why. */
void picture_say(Picture *, const char *name, const char *format, ...) __attribute__((format(printf, 3, 4)));

void picture_heading(Picture *, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Room for a map of so many pieces, to be filled; NULL: no memory. */
PictureMap *picture_map(Picture *, int nx, int ny);

/* Where the map lies in its picture: lengths to scale; displacements enlarged so that they are seen, by what
 * the whole run reaches, so that they keep still; the height stretched (`stretch`) where the body is too
 * slender for its room; or a part of it magnified. Axes show what is in sight. */
void picture_lay_body(Picture *, const BodyRoom *);

/* The colour of a thing among those of a map's kinds. */
Style picture_kind_style(int kind);

/* In which of so many steps from the map's low to its high a value is; of kinds: which one it is. */
int picture_map_step(const PictureMap *, double value, int steps);

/* Whether a place is in sight, or no farther from it than so much, m. */
bool picture_in_sight(const Picture *, double x, double y, double margin);

/* A line over a body, as the first members of `pen` say; where the last one ended its dashes go on. */
void picture_trace(Picture *, const double from[2], const double to[2], const Stroke *pen);

/* A strip has room beside it for its keys or notes, of which the first is beside the first row, the
 * second beside the last. A low pane has no heading; in a tall one a row of pieces keeps to a few rows, and
 * has the labels below each other under them. */
void picture_lay_strip(Picture *, StripKind, const char *heading);

/* Pieces in a row, so many whole columns each; where they have no room, a part of them around one, which may
 * end so many beyond the last one. `aside`: columns that are not a piece's. What comes out: columns of a
 * piece, the first one in sight, how many are. */
typedef struct StripRow {
    long pieces, beyond, around;
    int aside;
    int per;
    long first, shown;
} StripRow;
void picture_lay_row(const Picture *, StripRow *);

/* How a body with its dimensions is laid out, in characters: its size in m, the rows that things above and
 * below it need, and so many rows of lengths below that. What comes out: characters to a metre, its edges as
 * rows above 0, the distance of two lengths, how many there is room for, and how much it is stretched. False:
 * it has no room, and the picture says so. */
typedef struct DrawingRoom {
    double size[2];
    int around, lengths;
    double scale, top, bottom, apart, stretch;
} DrawingRoom;
bool picture_lay_drawing(Picture *, DrawingRoom *);

/* The same mark along a line, as often as there is room for it; `scale`: characters to its lengths. */
void picture_spread(Picture *, const double from[2], const double to[2], const double scale[2],
                    const PictureMark *);

/* Room for a list of so many rows, of which those around the chosen one are described; NULL: no memory. */
PictureList *picture_list(Picture *, int set, size_t count, size_t chosen, int n_columns);
PictureCell *picture_cell(const PictureList *, int column, size_t row); /* of those described */

/* One more table, whose rows are numbered from 0 on; and the things around. NULL: no memory. */
PictureTable *picture_table(Picture *);
PictureAround *picture_around(Picture *);

void picture_mark(Picture *, double x, double y, uint32_t glyph, Style);
void picture_thing(Picture *, double x, double y, uint32_t glyph, Style,
                   PictureThing); /* for the mouse too */
void picture_add_mark(Picture *, PictureMark);
void picture_rule(Picture *, double x, Style, const char *word);
/* Straight, from place to place. */
void picture_line(Picture *, double x0, double y0, double x1, double y1, Pen);
void picture_level(Picture *, double y, Pen, const char *name); /* from edge to edge; NULL: no name */
/* A rectangle that is filled. */
void picture_box(Picture *, const double x[2], const double y[2], Pen);
/* More can be said of the label that is returned. */
PictureLabel *picture_label(Picture *, double x, double y, int side, Style, const char *format, ...)
    __attribute__((format(printf, 6, 7)));
void picture_arrow(Picture *, const PictureArrow *);
void picture_key(Picture *, PictureKey);
void picture_name(Picture *, Pen, const char *name); /* an entry with a piece of its line */
char picture_run_of(const PictureKey *);             /* the letter of an earlier run; 0: it is none */

/* Of words in a note: what is shown, and what instead where room is short. */
#define LONG_SHORT(words, shorter) "\1" words "\2" shorter "\3"

/* Below it; more can be said of the note that is returned. Its text is shown in full or, with the shorter
 * words that LONG_SHORT() has in it, in brief. */
PictureNote *picture_note(Picture *, Style, const char *format, ...) __attribute__((format(printf, 3, 4)));

#endif

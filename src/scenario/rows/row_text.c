/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One row of a kind: its line in, its values, its line out. */
#include "base/assertion.h"
#include "base/quantity.h"
#include "base/text.h"
#include "scenario/rows/rows.h"
#include "problems/problem.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <math.h>

/* --- a line in words ------------------------------------------------------------------------------ */

enum { WORDS_MAX = 16, WORD_MAX = 48 };

typedef struct Words {
    char all[WORDS_MAX][WORD_MAX];
    int count;
} Words;

const char *const *row_words(RowValue value)
{
    return value == ROW_EDGE ? row_edge_words : value == ROW_SHAPE ? row_shape_words : NULL;
}

bool row_has(const RowKind *kind, const Row *row, int column)
{
    const unsigned of = kind->columns[column].of;
    return of == 0 || of >> (int)row->values[0] & 1;
}

static const char *word_in_line(const RowColumn *column)
{
    return column->line ? column->line : column->word;
}

/* The optional value that a word stands for; -1: none. */
static int option_of(const RowKind *kind, const char *word)
{
    for (int i = 0; i < kind->n_columns; i++)
        if (kind->columns[i].optional && !kind->columns[i].follows &&
            strcmp(word_in_line(&kind->columns[i]), word) == 0)
            return i;
    return -1;
}

/* "5 mm" and "50 %" are one value: a unit goes with the number before it. */
static bool goes_with(const RowKind *kind, const char *last, const char *word)
{
    bool has_units = false; /* bodies have none: a word behind a number is another value */
    for (int i = 0; i < kind->n_columns; i++)
        has_units = has_units || *kind->columns[i].unit;
    const bool unit =
        *word == '%' || (has_units && (isalpha((unsigned char)*word) || (unsigned char)*word >= 0x80));
    const char end = last[strlen(last) - 1];
    return unit && option_of(kind, word) < 0 && text_place_in(word, row_words(kind->columns[0].value)) < 0 &&
           (isdigit((unsigned char)end) || end == '.' || end == ')') &&
           strlen(last) + strlen(word) < WORD_MAX;
}

/* False: a word is longer than any value, or there are more than any row has. */
static bool cut_into_words(const RowKind *kind, const char *text, Words *words)
{
    char word[WORD_MAX];
    words->count = 0;
    for (text += strspn(text, " \t"); *text; text += strspn(text, " \t")) {
        const size_t length = strcspn(text, " \t");
        if (length >= sizeof word)
            return false;
        memcpy(word, text, length);
        word[length] = '\0';
        text += length;
        char *last = words->count > 0 ? words->all[words->count - 1] : NULL;
        if (last && goes_with(kind, last, word))
            strcat(last, word);
        else if (words->count < WORDS_MAX)
            strcpy(words->all[words->count++], word);
        else
            return false;
    }
    return true;
}

/* --- one value ------------------------------------------------------------------------------------ */

static bool is_place(RowValue value)
{
    return value == ROW_ALONG_X || value == ROW_ALONG_Y || value == ROW_ALONG_EDGE;
}

static bool read_number(const RowColumn *column, const char *word, bool share, double *value,
                        const char *about, Status *status)
{
    char why[QUANTITY_WHY_MAX], number[WORD_MAX];
    snprintf(number, sizeof number, "%.*s", (int)(strlen(word) - share), word);
    const bool place = is_place(column->value), bare = !*column->unit;
    if (!share && strchr(word, '%'))
        snprintf(why, sizeof why, place ? "is not a share" : "is a share, which only a place can be");
    else if (quantity_read(number, share ? "" : column->unit, value, why))
        return true;
    return status_refuse(status, "%s: %s: %s %s (%s%s%s%s)", about, column->word, word, why,
                         place  ? "a place"
                         : bare ? "a number"
                                : "",
                         bare    ? ""
                         : place ? " in "
                                 : "in ",
                         column->unit, place ? ", or a share such as 50%" : "");
}

const char *row_whole_word(const RowKind *kind)
{
    return kind->concern == CONCERN_PLATE ? "plate" : "box";
}

bool row_read_value(const RowKind *kind, int index, const char *word, Row *row, const char *about,
                    Status *status)
{
    ASSERT_INDEX(index, kind->n_columns);
    const RowColumn *column = &kind->columns[index];
    const unsigned bit = 1u << index;
    const char *sign = strchr(word, '%'); /* behind all of a share */
    const bool share = is_place(column->value) && sign && sign > word && !sign[1];
    const char *const *words = row_words(column->value);
    double value = 0;
    if (words) {
        char allowed[64] = "";
        value = text_place_in(word, words);
        for (int i = 0; words[i]; i++)
            text_append(allowed, sizeof allowed, "%s%s",
                        i == 0         ? ""
                        : words[i + 1] ? ", "
                                       : " or ",
                        words[i]);
        if (value < 0)
            return status_refuse(status, "%s: unknown %s %.60s: %s", about, column->word, word, allowed);
    } else if (strlen(word) >= WORD_MAX) {
        return status_refuse(status, "%s: %s: the value is too long (at most %d bytes)", about, column->word,
                             WORD_MAX - 1);
    } else if (!read_number(column, word, share, &value, about, status)) {
        return false;
    }
    if (is_place(column->value) && !(value >= 0 && (!share || value <= 100)))
        return status_refuse(status, "%s: %s: %s is off the %s (%s)", about, column->word, word,
                             row_whole_word(kind), share ? "0% to 100%" : "0 or more");
    if (column->value == ROW_SIZE && !(value > 0))
        return status_refuse(status, "%s: %s: %s is not allowed (a size above 0)", about, column->word, word);
    if (column->value == ROW_TIME && !(value > 0))
        return status_refuse(status, "%s: %s: %s is not allowed (a time above 0)", about, column->word, word);
    row->values[index] = value;
    row->shares = share ? row->shares | bit : row->shares & ~bit;
    row->given |= bit;
    return true;
}

/* --- a row ---------------------------------------------------------------------------------------- */

static bool refuse(const RowKind *kind, const char *about, const char *what, Status *status)
{
    return status_refuse(status, "%s: %s (%s)", about, what, kind->form);
}

bool row_read(const RowKind *kind, const char *text, Row *row, const char *about, Status *status)
{
    Words words;
    Row read = {0};
    int column = 0, at = 0;
    memcpy(read.name, row->name, sizeof read.name);
    if (!cut_into_words(kind, text, &words))
        return refuse(kind, about, "has more or longer values than it can have", status);
    for (; column < kind->n_columns && !kind->columns[column].optional; column++) {
        if (!row_has(kind, &read, column))
            continue;
        if (at == words.count || option_of(kind, words.all[at]) >= 0) {
            char what[64];
            snprintf(what, sizeof what, "%s is missing", kind->columns[column].word);
            return refuse(kind, about, at == 0 ? "has no value" : what, status);
        }
        if (!row_read_value(kind, column, words.all[at++], &read, about, status))
            return false;
    }
    const unsigned fixed = read.given;
    while (at < words.count) {
        char what[WORD_MAX + 64];
        const char *word = words.all[at];
        const int option = option_of(kind, word);
        if (option < 0)
            snprintf(what, sizeof what, "unexpected %s", word);
        else if (read.given >> option & 1)
            snprintf(what, sizeof what, "%s is given twice", word);
        else {
            int last = option, value = option;
            while (last + 1 < kind->n_columns && kind->columns[last + 1].follows)
                last++;
            for (; value <= last && at + 1 + value - option < words.count; value++)
                if (!row_read_value(kind, value, words.all[at + 1 + value - option], &read, about, status))
                    return false;
            at += 2 + last - option;
            if (value > last)
                continue;
            snprintf(what, sizeof what, "%s has no value", last > option ? kind->columns[value].word : word);
        }
        return refuse(kind, about, what, status);
    }
    if (kind->needs_optional && read.given == fixed)
        return refuse(kind, about, "gives no velocity", status);
    *row = read;
    return true;
}

/* `digits` 0: as many as it takes to read back to the same bits. */
static void add_value(const RowKind *kind, const Row *row, int index, int digits, char *out, size_t size)
{
    char number[NUMBER_TEXT_MAX];
    const RowColumn *column = &kind->columns[index];
    if (digits == 0)
        text_shortest(number, row->values[index]);
    else
        strcpy(number, text_rounded(row->values[index], digits).text);
    const bool named = column->optional && !column->follows;
    text_append(out, size, "%s%s%s%s%s", *out ? " " : "", named ? word_in_line(column) : "", named ? " " : "",
                row_words(column->value) ? row_words(column->value)[(int)row->values[index]] : number,
                row->shares >> index & 1 ? "%" : "");
}

void row_write(const RowKind *kind, const Row *row, int digits, char out[ROW_TEXT_MAX])
{
    out[0] = '\0';
    for (int i = 0; i < kind->n_columns; i++)
        if (row->given >> i & 1)
            add_value(kind, row, i, digits, out, ROW_TEXT_MAX);
}

static bool same_value(const Row *a, const Row *b, int index)
{
    const unsigned bit = 1u << index;
    return a->values[index] == b->values[index] && (a->shares & bit) == (b->shares & bit) &&
           (a->given & bit) == (b->given & bit);
}

bool row_same(const RowKind *kind, const Row *a, const Row *b)
{
    for (int i = 0; i < kind->n_columns; i++)
        if (!same_value(a, b, i))
            return false;
    return strcmp(a->name, b->name) == 0;
}

void row_write_difference(const RowKind *kind, const Row *row, const Row *other, char out[ROW_TEXT_MAX])
{
    out[0] = '\0';
    for (int i = 0; i < kind->n_columns; i++) {
        if (same_value(row, other, i))
            continue;
        if (!kind->columns[i].optional)
            text_append(out, ROW_TEXT_MAX, "%s%s", *out ? " " : "", kind->columns[i].word);
        if (row->given >> i & 1)
            add_value(kind, row, i, 6, out, ROW_TEXT_MAX);
        else
            text_append(out, ROW_TEXT_MAX, "%sno %s", *out ? " " : "", kind->columns[i].word);
    }
}

/* The table of kinds of rows (rows.h): nothing else. A kind that is new is one entry here, and what is made
 * of its rows stands with the solver. */

const char *const row_edge_words[] = {"top", "bottom", "left", "right", NULL};
const char *const row_shape_words[] = {"disc", "ring", "block", NULL};

#define VALUE(name, its_value, its_unit)  .word = name, .value = its_value, .unit = its_unit
#define OPTION(name, its_value, its_unit) VALUE(name, its_value, its_unit), .optional = true
#define RECTANGLE                                                                                            \
    {VALUE("x0", ROW_ALONG_X, "m")}, {VALUE("y0", ROW_ALONG_Y, "m")}, {VALUE("x1", ROW_ALONG_X, "m")},       \
    {                                                                                                        \
        VALUE("y1", ROW_ALONG_Y, "m")                                                                        \
    }
enum { DISC = 1 << 0, RING = 1 << 1, BLOCK = 1 << 2 };

#define KIND(its_section, its_one, its_form) .section = its_section, .one = its_one, .form = its_form
#define COLUMNS(...)                                                                                         \
    .columns = {__VA_ARGS__}, .n_columns = sizeof((RowColumn[]){__VA_ARGS__}) / sizeof(RowColumn)

const RowKind row_kinds[ROW_KINDS] = {
    [ROWS_CUTS] = {KIND("cuts", "cut", "X0 Y0 X1 Y1"), .concern = CONCERN_PLATE, .fresh = "25% 50% 75% 50%",
                   .help = "a straight cut from one place to another: the bonds that cross it are gone",
                   COLUMNS(RECTANGLE)},
    [ROWS_LOADS] = {KIND("loads", "load", "EDGE FROM TO SX SY [ramp T] [until T]"), .concern = CONCERN_PLATE,
                    .fresh = "top 0% 100% 0 1e6",
                    .help =
                        "a traction on a stretch of an edge (top | bottom | left | right) from t = 0 on; it "
                        "rises in the time ramp and is gone after until",
                    COLUMNS({VALUE("edge", ROW_EDGE, "")}, {VALUE("from", ROW_ALONG_EDGE, "m")},
                            {VALUE("to", ROW_ALONG_EDGE, "m")}, {VALUE("sx", ROW_NUMBER, "Pa")},
                            {VALUE("sy", ROW_NUMBER, "Pa")}, {OPTION("ramp", ROW_TIME, "s")},
                            {OPTION("until", ROW_TIME, "s"), .absent = HUGE_VAL})},
    [ROWS_SUPPORTS] = {KIND("supports", "support", "X0 Y0 X1 Y1 [ux V] [uy V]"), .concern = CONCERN_PLATE,
                       .fresh = "0% 0% 10% 10% ux 0 uy 0",
                       .help = "a rectangle that moves with a given velocity, along x, y or both; 0 holds it",
                       .needs_optional = true,
                       COLUMNS(RECTANGLE, {OPTION("ux", ROW_NUMBER, "m/s")},
                               {OPTION("uy", ROW_NUMBER, "m/s")})},
    [ROWS_IMPULSES] = {KIND("impulses", "impulse", "X0 Y0 X1 Y1 VX VY"), .concern = CONCERN_PLATE,
                       .fresh = "25% 25% 75% 75% 0 1", .help = "the velocity of a rectangle at t = 0",
                       COLUMNS(RECTANGLE, {VALUE("vx", ROW_NUMBER, "m/s")},
                               {VALUE("vy", ROW_NUMBER, "m/s")})},
    [ROWS_PROTECTED] = {KIND("protected", "protected region", "X0 Y0 X1 Y1"), .concern = CONCERN_PLATE,
                        .fresh = "0% 0% 10% 100%",
                        .help = "a rectangle whose nodes keep their bonds, however far these stretch",
                        COLUMNS(RECTANGLE)},
    [ROWS_PROBE] = {KIND("probe", "probe", "X Y"), .concern = CONCERN_PLATE, .usual = "50% 50%",
                    .help = "the place whose motion the time plots show",
                    COLUMNS({VALUE("x", ROW_ALONG_X, "m")}, {VALUE("y", ROW_ALONG_Y, "m")})},
    [ROWS_BODIES] =
        {KIND("bodies", "body",
              "disc CX CY R | ring CX CY RI RO | block X0 Y0 X1 Y1, then [velocity VX VY] [spin W] [wave V]"),
         .concern = CONCERN_BODIES, .fresh = "disc 50% 50% 0.1",
         .help = "an elastic body with its velocity and its spin about its centre, counterclockwise; wave: a "
                 "block's velocity V sin(pi (x - X0)/(X1 - X0)) along x",
         .plain_names = true,
         COLUMNS({VALUE("shape", ROW_SHAPE, "")}, {VALUE("cx", ROW_ALONG_X, ""), .of = DISC | RING},
                 {VALUE("cy", ROW_ALONG_Y, ""), .of = DISC | RING}, {VALUE("r", ROW_SIZE, ""), .of = DISC},
                 {VALUE("ri", ROW_SIZE, ""), .of = RING}, {VALUE("ro", ROW_SIZE, ""), .of = RING},
                 {VALUE("x0", ROW_ALONG_X, ""), .of = BLOCK}, {VALUE("y0", ROW_ALONG_Y, ""), .of = BLOCK},
                 {VALUE("x1", ROW_ALONG_X, ""), .of = BLOCK}, {VALUE("y1", ROW_ALONG_Y, ""), .of = BLOCK},
                 {OPTION("vx", ROW_NUMBER, ""), .line = "velocity"},
                 {OPTION("vy", ROW_NUMBER, ""), .follows = true}, {OPTION("spin", ROW_NUMBER, "")},
                 {OPTION("wave", ROW_NUMBER, "")})},
};

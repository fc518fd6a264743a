/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the words and numbers of tables stand. */
#include "picture/table.h"

#include "base/text.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    NAMES_LEAST = 9,
    FACTOR_MOST = 12,
    FACTOR_LEAST = 6,
    FACTOR_DIGITS = 6,
    TERM_MOST = 12,
    TERM_LEAST = 7,
    ASIDE_ROWS = 2,  /* of a table that lies on its side, */
    ASIDE_FROM = 8,  /* for which there is room from so many rows on */
    BESIDE = 43,     /* columns of tables beside what is around, which has a gap behind it */
    PLACE_LEAST = 4, /* columns of a number there */
    PLACE_MOST = 6,
    TEXT_MAX = 400
};

/* A part of the sheet, as far as it has been written on. */
typedef struct Part {
    const TableSheet *sheet;
    int left, columns, y;
} Part;

static int columns_of(const TableSheet *sheet, const char *text)
{
    char plain[TEXT_MAX];
    glyphs_plain(sheet->glyphs, text, plain, sizeof plain);
    return glyphs_columns(plain);
}

static void write_words(const Part *part, int column, int row, const char *text, Style style, bool to_end)
{
    char plain[TEXT_MAX];
    glyphs_plain(part->sheet->glyphs, text, plain, sizeof plain);
    if (row < part->sheet->rows && part->sheet->write)
        part->sheet->write(part->sheet, part->left + column, row, plain, style, to_end);
}

static void write_number(const Part *part, int end, int row, double value, Writing writing, int decimals,
                         Style style)
{
    char text[64];
    const int shift = isnan(value) ? 0 : sum_column_number(value, writing, decimals, text);
    if (!isnan(value))
        write_words(part, end - shift, row, text, style, true);
}

static void stand(const Part *part, int column, int row, int width, PictureThing thing)
{
    if (part->sheet->stand && thing.set >= 0 && row < part->sheet->rows)
        part->sheet->stand(part->sheet, part->left + column, row, width, thing);
}

/* --- what is seen of a table ------------------------------------------------------------------------- */

typedef struct Plan {
    const PictureTable *table;
    const TableColumn *columns[TABLE_COLUMNS_MAX];
    int n_columns, names, widths[TABLE_COLUMNS_MAX];
    int limit;             /* ranks below it are shown row by row, */
    size_t shown;          /* so many of them */
    bool labelled, scaled; /* there are rows for labels and powers of ten */
    int height;
    Writing writings[TABLE_COLUMNS_MAX];
} Plan;

static int larger(int a, int b)
{
    return a > b ? a : b;
}

/* The columns of these bits; false: their factors have no room. */
static bool take_columns(Plan *plan, const TableSheet *sheet, unsigned wanted, int width)
{
    int terms = 0, room = width - plan->names;
    plan->n_columns = 0;
    for (int c = 0; c < plan->table->n_columns; c++)
        if (wanted & 1u << c) {
            terms += plan->table->columns[c].adds;
            plan->columns[plan->n_columns++] = &plan->table->columns[c];
        }
    const int term = terms * TERM_MOST > room ? larger(room / terms, TERM_LEAST) : TERM_MOST;
    for (int c = 0; c < plan->n_columns; c++) {
        const TableColumn *column = plan->columns[c];
        plan->widths[c] = column->adds ? term : larger(columns_of(sheet, column->name) + 1, FACTOR_LEAST);
        room -= plan->widths[c];
    }
    /* Columns of factors get what room there is, the narrow ones first. */
    for (int least = FACTOR_LEAST, left = room; least < FACTOR_MOST && left > 0; least++) {
        int narrow = 0;
        for (int c = 0; c < plan->n_columns; c++)
            narrow += !plan->columns[c]->adds && plan->widths[c] == least;
        for (int c = 0; c < plan->n_columns && narrow <= left; c++)
            plan->widths[c] += !plan->columns[c]->adds && plan->widths[c] == least;
        left -= narrow;
    }
    return room >= 0 || plan->n_columns == terms;
}

static void choose_columns(Plan *plan, const TableSheet *sheet, int width)
{
    const PictureTable *table = plan->table;
    unsigned terms = 0, factors = 0, stay = 0;
    int longest = -1;
    for (int c = 0; c < table->n_columns; c++) {
        const TableColumn *column = &table->columns[c];
        terms |= column->adds ? 1u << c : 0;
        stay |= column->stays ? 1u << c : 0;
        if (column->adds && (longest < 0 || columns_of(sheet, column->name) >
                                                columns_of(sheet, table->columns[longest].name)))
            longest = c;
    }
    if (take_columns(plan, sheet, (1u << table->n_columns) - 1, width) || longest < 0 ||
        (table->of_directions && take_columns(plan, sheet, terms | 1, width)))
        return;
    for (int c = 0; c < table->n_columns; c++)
        factors |= table->columns[c].in & 1u << longest ? 1u << c : 0;
    const unsigned last[] = {1u << longest | factors | stay, 1u << longest | factors, 1u << longest};
    for (int i = 0; i < 3 && !take_columns(plan, sheet, last[i], width);)
        i++;
}

/* The terms of a column as they are written: one by one, then the others as one. Returns how many. */
static size_t terms_of(const Plan *plan, const TableColumn *column, double terms[TABLE_ROWS_MAX + 1],
                       double *sum)
{
    double others = 0;
    size_t count = 0;
    *sum = 0;
    for (size_t i = 0; i < plan->table->count; i++) {
        const double value = column->values[i];
        *sum += value;
        if (plan->table->rows[i].rank < plan->limit)
            terms[count++] = value;
        else
            others += value;
    }
    if (plan->shown < plan->table->count)
        terms[count++] = others;
    return count;
}

static double base_of(const TableColumn *column)
{
    return isnan(column->base) ? 0 : column->base;
}

Writing table_writing(const PictureTable *table, const TableColumn *column, int width, double *sum)
{
    const Plan all = {.table = table, .limit = INT_MAX, .shown = table->count};
    double terms[TABLE_ROWS_MAX + 1];
    const size_t count = terms_of(&all, column, terms, sum);
    return writing_of(terms, count, base_of(column), *sum, width);
}

static Plan plan_of(const TableSheet *sheet, const PictureTable *table, int width, int rows)
{
    Plan plan = {
        .table = table, .limit = INT_MAX, .shown = table->count, .names = columns_of(sheet, table->what)};
    for (size_t i = 0; i < table->count; i++)
        plan.names = larger(plan.names, columns_of(sheet, table->rows[i].name));
    for (TableTotal i = 0; i < TOTALS; i++)
        plan.names = larger(plan.names, table->totals[i].name ? columns_of(sheet, table->totals[i].name) : 0);
    plan.names = larger(plan.names + 1, NAMES_LEAST);
    double terms[TABLE_ROWS_MAX + 1], sum;
    int around = 1 + (table->title[0] != '\0'); /* rows of heads and totals */
    choose_columns(&plan, sheet, width);
    for (TableTotal i = 0; i < TOTALS; i++)
        around += table->totals[i].name != NULL;
    for (int c = 0; c < plan.n_columns; c++)
        plan.labelled |= plan.columns[c]->label != NULL;
    around += plan.labelled;
    for (int pass = 0; pass < 3; pass++) { /* with fewer rows numbers may be larger, and take a row */
        for (int c = 0; c < plan.n_columns; c++) {
            const size_t count = terms_of(&plan, plan.columns[c], terms, &sum);
            if (plan.columns[c]->adds)
                plan.writings[c] =
                    writing_of(terms, count, base_of(plan.columns[c]), sum, plan.widths[c] - 1);
            plan.scaled |= plan.writings[c].exponent != 0;
        }
        /* The rows of the highest rank go first, all of them. */
        while (plan.shown > 0 &&
               (int)(plan.shown + (plan.shown < table->count)) > rows - around - plan.scaled) {
            int highest = INT_MIN;
            for (size_t i = 0; i < table->count; i++)
                if (table->rows[i].rank < plan.limit)
                    highest = larger(highest, table->rows[i].rank);
            plan.limit = highest;
            plan.shown = 0;
            for (size_t i = 0; i < table->count; i++)
                plan.shown += table->rows[i].rank < highest;
        }
    }
    plan.height = around + plan.scaled + (int)plan.shown + (plan.shown < table->count);
    return plan;
}

/* --- a table ------------------------------------------------------------------------------------------ */

/* Names the columns; returns where the first label above them begins. */
static int write_heads(const Plan *plan, const Part *part, int y)
{
    int begin = part->columns, end = plan->names;
    char text[16];
    bool beside_factors = true; /* where a long label has room */
    const int names = y + plan->labelled + plan->scaled;
    write_words(part, plan->names - 1, names, plan->table->what, STYLE_HEADING, true);
    for (int c = 0; c < plan->n_columns; c++) {
        const TableColumn *column = plan->columns[c];
        end += plan->widths[c];
        write_words(part, end - 1, names, column->name, STYLE_HEADING, true);
        if (!column->adds)
            continue;
        if (column->label) {
            const bool is_long = !beside_factors && columns_of(part->sheet, column->label) >= plan->widths[c];
            const char *label = is_long ? column->brief : column->label;
            write_words(part, end - 1, y, label, STYLE_HEADING, true);
            begin = beside_factors ? end - 1 - columns_of(part->sheet, label) : begin;
            beside_factors = false;
        }
        snprintf(text, sizeof text, "x10^%d", plan->writings[c].exponent);
        if (plan->writings[c].exponent != 0)
            write_words(part, end - 1, y + plan->labelled, text, STYLE_HEADING, true);
    }
    return begin;
}

int table_decimals(const TableColumn *column, TableTotal total, Writing writing)
{
    return total != TOTAL_RESULT && base_of(column) != 0 ? writing.decimals : writing.sum_decimals;
}

static void write_table(const Plan *plan, const Part *part, int y)
{
    const PictureTable *table = plan->table;
    const int titled = table->title[0] != '\0', labels = write_heads(plan, part, y + titled);
    char text[48];
    if (titled) {
        /* The notes on factors stand before the labels or, without room, behind a short title. */
        const int notes = columns_of(part->sheet, table->notes);
        const bool before = plan->labelled && 1 + notes < labels;
        const bool whole = before && 1 + columns_of(part->sheet, table->title) <= part->columns;
        const char *title = whole ? table->title : table->brief;
        const int end = before ? 1 : 1 + columns_of(part->sheet, title) + 2;
        write_words(part, 1, y, title, STYLE_HEADING, false);
        if (before || end + notes < part->columns)
            write_words(part, end, y + before, table->notes, STYLE_FAINT, false);
    }
    y += titled + plan->labelled + plan->scaled + 1;
    for (int c = 0, end = plan->names; c < plan->n_columns; c++) {
        const TableColumn *column = plan->columns[c];
        const Writing writing = plan->writings[c];
        double values[TABLE_ROWS_MAX + 1], sum;
        const size_t count = terms_of(plan, column, values, &sum);
        end += plan->widths[c];
        if (column->adds) {
            /* Its terms, one below the other, and the rows under them. */
            const double totals[TOTALS] = {sum, column->base, column->result};
            int under = y + (int)count;
            for (size_t i = 0; i < count; i++)
                write_number(part, end - 1, y + (int)i, values[i], writing, writing.decimals,
                             i < plan->shown ? column->style : STYLE_FAINT);
            for (TableTotal i = 0; i < TOTALS; i++)
                if (table->totals[i].name)
                    write_number(part, end - 1, under++, totals[i], writing,
                                 table_decimals(column, i, writing), table->totals[i].style);
        } else {
            const Format format = format_of(values, plan->shown, FACTOR_DIGITS, plan->widths[c] - 1);
            for (size_t j = 0; j < plan->shown; j++) {
                format_number(values[j], format, text);
                write_words(part, end - 1, y + (int)j, text, STYLE_NORMAL, true);
            }
        }
    }
    for (size_t i = 0; i < table->count; i++)
        if (table->rows[i].rank < plan->limit) {
            stand(part, 0, y, part->columns, table->rows[i].thing);
            write_words(part, plan->names - 1, y++, table->rows[i].name, STYLE_NORMAL, true);
        }
    snprintf(text, sizeof text, "%zu %s", table->count - plan->shown, table->more);
    if (plan->shown < table->count)
        write_words(part, plan->names - 1, y++, text, STYLE_FAINT, true);
    for (TableTotal i = 0; i < TOTALS; i++)
        if (table->totals[i].name)
            write_words(part, plan->names - 1, y++, table->totals[i].name, STYLE_HEADING, true);
}

/* A row of things with the one of their numbers and its sum below; false: there is no room. */
static bool write_aside(const PictureTable *table, const Part *part, int y)
{
    const TableColumn *column = &table->columns[0];
    const int room = (part->columns - NAMES_LEAST) / (int)(table->count + 1);
    const int width = room > TERM_MOST ? TERM_MOST : room;
    if (width < TERM_LEAST)
        return false;
    double sum;
    char text[24];
    const Writing writing = table_writing(table, column, width - 1, &sum);
    int end = NAMES_LEAST - 1;
    write_words(part, end, y, table->what, STYLE_HEADING, true);
    write_words(part, end, y + 1, column->name, STYLE_HEADING, true);
    for (size_t i = 0; i < table->count; i++) {
        end += width;
        stand(part, end - width + 1, y, width, table->rows[i].thing);
        stand(part, end - width + 1, y + 1, width, table->rows[i].thing);
        write_words(part, end, y, table->rows[i].name, STYLE_HEADING, true);
        write_number(part, end, y + 1, column->values[i], writing, writing.decimals,
                     i == table->own ? STYLE_CHANGED : STYLE_NORMAL);
    }
    end += width;
    snprintf(text, sizeof text, "x10^%d", writing.exponent);
    write_words(part, end, y, writing.exponent != 0 ? text : table->totals[TOTAL_SUM].name, STYLE_HEADING,
                true);
    write_number(part, end, y + 1, sum, writing, writing.sum_decimals, table->totals[TOTAL_SUM].style);
    return true;
}

/* --- all of them --------------------------------------------------------------------------------------- */

/* The first one in any case, with a row before it where that costs none of it; the others whole, and one that
 * lies on its side before any of them. */
static void write_tables(const Picture *picture, Part *part)
{
    const int top = part->y;
    int aside = 0, rows = part->sheet->rows;
    bool written = false;
    for (int i = 0; i < picture->n_tables && rows >= ASIDE_FROM; i++)
        aside += picture->tables[i].n_columns == 1 ? ASIDE_ROWS : 0;
    rows -= aside;
    for (int i = 0; i < picture->n_tables; i++) {
        const PictureTable *table = &picture->tables[i];
        if (table->n_columns == 1) {
            const int gap = part->y > 0 && part->y < rows;
            if (aside >= ASIDE_ROWS && write_aside(table, part, part->y + gap))
                part->y += gap + ASIDE_ROWS;
            aside = aside >= ASIDE_ROWS ? aside - ASIDE_ROWS : 0;
            rows = part->sheet->rows - aside;
            continue;
        }
        int begin = part->y + (part->y > 0);
        Plan plan = plan_of(part->sheet, table, part->columns, rows - begin);
        const bool whole = plan.shown == table->count && begin + plan.height <= rows;
        if (!whole && written)
            continue;
        if (!whole && begin > top)
            plan = plan_of(part->sheet, table, part->columns, rows - --begin);
        write_table(&plan, part, begin);
        part->y = begin + plan.height;
        written = true;
    }
}

/* Of phrases that are separated by two spaces those that have room. */
static void write_notes(const Picture *picture, Part *part, bool spare)
{
    for (int i = 0; i < picture->n_notes; i++) {
        const PictureNote *note = &picture->notes[i];
        char text[TEXT_MAX], *gap = text;
        if (note->told || note->spare != spare)
            continue;
        const bool is_long = note->brief[0] && columns_of(part->sheet, note->text) >= part->columns;
        snprintf(text, sizeof text, "%s", is_long ? note->brief : note->text);
        while (gap && columns_of(part->sheet, text) >= part->columns) {
            gap = NULL;
            for (char *at = text; (at = strstr(at, "  ")); at++)
                gap = at;
            if (gap)
                *gap = '\0';
        }
        write_words(part, 1, part->y++, text, note->style, false);
    }
}

/* Columns of a place. */
static int place_width(const Picture *picture, int columns)
{
    const int room = (columns - BESIDE - 1) / (2 * picture->around->reach + 1);
    return room > PLACE_MOST ? PLACE_MOST : larger(room, PLACE_LEAST);
}

/* --- what is around ------------------------------------------------------------------------------------ */

bool tables_around(const Picture *picture, int columns, int *width, int *height)
{
    if (!picture->around)
        return false;
    const int side = 2 * picture->around->reach + 1;
    *width = place_width(picture, columns) * side + 2;
    *height = side + 1;
    return *width + BESIDE - 1 <= columns;
}

bool tables_are_parted(const Picture *picture, int columns)
{
    int width, height;
    return picture->around && !tables_around(picture, columns, &width, &height);
}

static void write_around(const Picture *picture, Part *part, int columns)
{
    const PictureAround *around = picture->around;
    const int width = place_width(picture, columns), side = 2 * around->reach + 1;
    for (int row = 0; row < side; row++, part->y++)
        for (int column = 0; column < side; column++) {
            const struct AroundPlace *place = &around->places[side - 1 - row][column];
            const int end = (column + 1) * width;
            char text[24];
            if (place->sign)
                text[glyph_put(text, place->sign)] = '\0';
            else
                snprintf(text, sizeof text, "%.0f", round(place->value) + 0.0);
            if (glyphs_columns(text) > width - (text[0] != '-')) /* far beyond: about to break, or unstable */
                strcpy(text, place->value > 0 ? ">>" : "<<");
            if (place->is_there) {
                stand(part, end - width, part->y, width, place->thing);
                write_words(part, end, part->y, text, place->style, true);
            }
        }
    write_words(part, 1, part->y++, around->meaning, STYLE_FAINT, false);
}

void tables_write(const Picture *picture, const TableSheet *sheet)
{
    Part part = {.sheet = sheet, .columns = sheet->columns};
    int width, height;
    const bool parted = tables_are_parted(picture, sheet->columns);
    if (tables_around(picture, sheet->columns, &width, &height)) {
        Part left = part;
        write_around(picture, &left, sheet->columns);
        part.left = width - 1;
        part.columns -= part.left;
    }
    if (parted && picture->tables_first)
        write_tables(picture, &part);
    else if (parted)
        write_around(picture, &part, sheet->columns);
    write_notes(picture, &part, false);
    if (!parted)
        write_tables(picture, &part);
    write_notes(picture, &part, true);
}

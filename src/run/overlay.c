/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads a table of any origin (overlay.h). Bounds on lines, cells and memory: files come from anywhere. */
#include "run/overlay.h"

#include "base/assertion.h"
#include "base/input.h"
#include "base/text.h"
#include "base/visible.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

/* --- lines ---------------------------------------------------------------------------------------- */

typedef struct Reader {
    FILE *stream;
    const char *file;
    Status *status;
    long line;
    char separator;
    bool decimal_comma;
    char text[OVERLAY_LINE_MAX];
    char comment[OVERLAY_LINE_MAX]; /* the last one */
    char cut[OVERLAY_LINE_MAX];     /* its cells, each with a final zero: no longer than the line */
    char *cells[OVERLAY_COLUMNS_MAX];
    size_t room;
    OverlayWord word;
    void *context; /* of word */
} Reader;

static bool fail(const Reader *reader, const char *what)
{
    return status_refuse(reader->status, "%s:%ld: %s", reader->file, reader->line, what);
}

/* The next line without its end: LF, CR LF or CR. */
static InputGot next_line(Reader *reader)
{
    size_t length = 0;
    int byte;
    reader->line++;
    while ((byte = getc(reader->stream)) != EOF && byte != '\n' && byte != '\r') {
        const bool mark = reader->line == 1 && length < 2 && (byte == 0xff || byte == 0xfe);
        if (mark && length == 1 && (unsigned char)reader->text[0] >= 0xfe)
            return fail(reader, "is UTF-16 text (save it as CSV in UTF-8)");
        if (byte < ' ' && byte != '\t')
            return fail(reader, "holds bytes that are not text (a CSV file is expected)");
        if (length + 1 == sizeof reader->text)
            return fail(reader, "the line is too long (at most 16383 bytes)");
        reader->text[length++] = (char)byte;
    }
    if (ferror(reader->stream))
        return status_refuse(reader->status, "%s: cannot be read: %s", reader->file, strerror(errno));
    if (byte == EOF && length == 0)
        return INPUT_END;
    if (byte == '\r' && (byte = getc(reader->stream)) != '\n' && byte != EOF)
        ungetc(byte, reader->stream);
    reader->text[length] = '\0';
    if (reader->line == 1 && strncmp(reader->text, "\xef\xbb\xbf", 3) == 0)
        memmove(reader->text, reader->text + 3, length - 2);
    return INPUT_LINE;
}

/* The next line that holds something. A comment, as numpy, MATLAB and Fortran begin it, is kept: names may be
 * in it. What separates cells the rows show. */
static InputGot next_row(Reader *reader)
{
    InputGot got;
    while ((got = next_line(reader)) == INPUT_LINE) {
        const char *text = reader->text + strspn(reader->text, " \t;,");
        if (reader->line == 1 && text_tells_separator(text))
            continue;
        if (*text && !strchr("#%!", *text))
            break;
        if (*text)
            snprintf(reader->comment, sizeof reader->comment, "%s", text + 1);
    }
    return got;
}

/* --- cells ---------------------------------------------------------------------------------------- */

/* Whether a cell ends here. A unit behind a blank belongs to its name: "time (ms) v". */
static bool ends_cell(const Reader *reader, const char *at)
{
    if (reader->separator != ' ')
        return *at == '\0' || *at == reader->separator;
    const char unit = at[strspn(at, " \t")];
    return *at == '\0' || (strchr(" \t", *at) && unit != '(' && unit != '[');
}

/* Cuts the line into cells, quotes undone; 0: it cannot be. */
static int cut_cells(Reader *reader)
{
    const char *from = reader->text, *blanks = reader->separator == '\t' ? " " : " \t";
    char *to = reader->cut;
    for (int count = 0;;) {
        if (count == OVERLAY_COLUMNS_MAX)
            return fail(reader, "too many columns (at most 256)");
        char *cell = reader->cells[count++] = to;
        from += strspn(from, blanks);
        if (*from == '"') {
            for (from++; *from && (*from != '"' || from[1] == '"'); *to++ = *from++)
                from += *from == '"';
            if (*from != '"')
                return fail(reader, "a quoted cell is not closed");
            from++;
            from += strspn(from, blanks);
            if (*from && *from != reader->separator)
                return fail(reader, "there is text after a quoted cell");
        } else {
            while (!ends_cell(reader, from))
                *to++ = *from++;
            while (to > cell && strchr(blanks, to[-1]))
                to--;
        }
        *to++ = '\0';
        if (reader->separator == ' ') /* or several */
            from += strspn(from, blanks);
        else if (*from)
            from++;
        else
            return count;
        if (!*from && reader->separator == ' ')
            return count;
    }
}

bool overlay_is_not_finite(const char *cell)
{
    const char *word = cell + (*cell == '-' || *cell == '+');
    return (strncasecmp(word, "nan", 3) == 0 && (!word[3] || word[3] == '(')) ||
           strcasecmp(word, "inf") == 0 || strcasecmp(word, "infinity") == 0 || strncmp(word, "1.#", 3) == 0;
}

/* False: neither a number nor a missing one. Fortran writes double precision as 4.85D-05. */
static bool number_of(const Reader *reader, char *cell, double *value)
{
    *value = NAN;
    if (!*cell || strcasecmp(cell, "na") == 0 || overlay_is_not_finite(cell))
        return true;
    char *comma = reader->decimal_comma && !strchr(cell, '.') ? strchr(cell, ',') : NULL;
    char *power = strpbrk(cell, "dD");
    const char letter = power ? *power : '\0';
    if (comma)
        *comma = '.';
    if (power)
        *power = 'e';
    const bool sound = text_to_double(cell, value);
    if (comma)
        *comma = ',';
    if (power)
        *power = letter;
    return sound;
}

/* --- the table ------------------------------------------------------------------------------------ */

static bool no_memory(const Reader *reader)
{
    return status_fail(reader->status, "not enough memory for %s", reader->file);
}

static bool make_room(Reader *reader, Overlay *overlay)
{
    if (overlay->count < reader->room)
        return true;
    const size_t most = OVERLAY_CELLS_MAX / (size_t)overlay->n_columns;
    if (overlay->count == most)
        return fail(reader, "too many numbers (at most 64 million)");
    size_t room = reader->room ? 2 * reader->room : 256;
    room = room < most ? room : most;
    for (int i = 0; i < overlay->n_columns; i++) {
        double *values = realloc(overlay->columns[i].values, room * sizeof *values);
        if (!values)
            return no_memory(reader);
        overlay->columns[i].values = values;
    }
    reader->room = room;
    return true;
}

enum { POWER_MAX = 400 }; /* no double has more; 0e99999999999 is 0 */

/* How exactly a number is written, for its column: "0.0120" has 3 digits and 4 places. */
static void note_digits(OverlayColumn *column, const char *cell)
{
    int digits = 0, places = 0;
    bool fraction = false;
    for (; *cell && !strchr("eEdD", *cell); cell++)
        if (*cell == '.' || *cell == ',')
            fraction = true;
        else if (*cell >= '0' && *cell <= '9') {
            digits += digits > 0 || *cell != '0';
            places += fraction;
        }
    const long power = *cell ? strtol(cell + 1, NULL, 10) : 0;
    places -= (int)(power < -POWER_MAX ? -POWER_MAX : power > POWER_MAX ? POWER_MAX : power);
    column->digits = digits > column->digits ? digits : column->digits;
    column->places = places > column->places ? places : column->places;
}

/* Takes the line that was cut; `cells` of them. */
static bool take_row(Reader *reader, Overlay *overlay, int cells)
{
    char what[160];
    if (cells != overlay->n_columns) {
        snprintf(what, sizeof what, "%d value%s in a table of %d columns", cells, cells == 1 ? "" : "s",
                 overlay->n_columns);
        return fail(reader, what);
    }
    if (!make_room(reader, overlay))
        return false;
    for (int i = 0; i < cells; i++) {
        OverlayColumn *column = &overlay->columns[i];
        double value;
        /* The reader may know the value of a cell with a word. */
        const char *cell = reader->cells[i];
        const bool letter = (*cell >= 'a' && *cell <= 'z') || (*cell >= 'A' && *cell <= 'Z');
        if (reader->word && (letter || overlay_is_not_finite(cell)) &&
            reader->word(column->name, cell, &value, reader->context)) {
            ;
        } else if (number_of(reader, reader->cells[i], &value)) {
            if (!isnan(value))
                note_digits(column, cell);
        } else {
            char text[OVERLAY_NAME_MAX];
            visible_text(text, sizeof text, cell);
            snprintf(what, sizeof what, "column %d%s%s: '%s' is not a number", i + 1,
                     column->name[0] ? ", " : "", column->name, text);
            return fail(reader, what);
        }
        column->values[overlay->count] = value;
        column->least = fmin(column->least, value); /* a missing one counts for neither */
        column->largest = fmax(column->largest, value);
    }
    overlay->count++;
    return true;
}

/* From the first line: how cells are separated, how many there are, their names or the first row. */
static bool take_head(Reader *reader, Overlay *overlay)
{
    bool names = false;
    double value;
    reader->separator = strchr(reader->text, ';')    ? ';'
                        : strchr(reader->text, '\t') ? '\t'
                        : strchr(reader->text, ',')  ? ','
                                                     : ' ';
    reader->decimal_comma = reader->separator != ',';
    const int cells = cut_cells(reader);
    if (cells == 0)
        return false;
    if (cells == 1)
        return fail(reader,
                    "one column only (a time and a value are expected, separated by , or ; or blanks)");
    overlay->columns = calloc((size_t)cells, sizeof *overlay->columns);
    if (!overlay->columns)
        return no_memory(reader);
    overlay->n_columns = cells;
    for (int i = 0; i < cells; i++) {
        overlay->columns[i].least = overlay->columns[i].largest = NAN;
        overlay->columns[i].places = -POWER_MAX;
        names |= !number_of(reader, reader->cells[i], &value);
    }
    if (!names) {
        if (!take_row(reader, overlay, cells))
            return false;
        /* names may be in the comment above the first row, where numpy writes them */
        Status *status = reader->status;
        strcpy(reader->text, reader->comment);
        reader->status = NULL; /* what a comment says is never wrong */
        names = cut_cells(reader) == cells;
        reader->status = status;
        for (int i = 0; i < cells && names; i++)
            names = *reader->cells[i] && !number_of(reader, reader->cells[i], &value);
    }
    for (int i = 0; i < cells && names; i++)
        visible_text(overlay->columns[i].name, OVERLAY_NAME_MAX, reader->cells[i]);
    return true;
}

static bool read_table(Reader *reader, Overlay *overlay, OverlayProgress go_on, void *context)
{
    enum { LINES_A_TURN = 16384 };
    struct stat file;
    const double size =
        fstat(fileno(reader->stream), &file) == 0 && S_ISREG(file.st_mode) ? (double)file.st_size : 0;
    InputGot got = next_row(reader);
    if (got == INPUT_END)
        return fail(reader, "holds no numbers");
    if (got == INPUT_WRONG || !take_head(reader, overlay))
        return false;
    for (long turn = 1; (got = next_row(reader)) == INPUT_LINE; turn++) {
        const int cells = cut_cells(reader);
        if (cells == 0 || !take_row(reader, overlay, cells))
            return false;
        if (turn % LINES_A_TURN == 0 && go_on &&
            !go_on(size > 0 ? (double)ftell(reader->stream) / size : 0, context))
            return status_fail(reader->status, "%s: not read to its end", reader->file);
    }
    if (got == INPUT_END && overlay->count == 0)
        return fail(reader, "holds names but no numbers");
    return got == INPUT_END;
}

bool overlay_read(Overlay *overlay, FILE *stream, const char *file, OverlayWord word, OverlayProgress go_on,
                  void *context, Status *status)
{
    Reader *reader = calloc(1, sizeof *reader);
    *overlay = (Overlay){.y = -1};
    if (!reader)
        return status_fail(status, "not enough memory for %s", file);
    *reader = (Reader){.stream = stream, .file = file, .status = status, .word = word, .context = context};
    const char *slash = strrchr(file, '/');
    visible_text(overlay->file, OVERLAY_NAME_MAX, slash ? slash + 1 : file);
    const bool sound = read_table(reader, overlay, go_on, context);
    free(reader);
    if (!sound)
        overlay_close(overlay);
    return sound;
}

bool overlay_load(Overlay *overlay, const char *path, OverlayProgress go_on, void *context, Status *status)
{
    *overlay = (Overlay){.y = -1};
    FILE *stream = input_open(path, OVERLAY_BYTES_MAX, status);
    if (!stream)
        return false;
    const bool sound = overlay_read(overlay, stream, path, NULL, go_on, context, status);
    fclose(stream);
    return sound;
}

void overlay_close(Overlay *overlay)
{
    for (int i = 0; i < overlay->n_columns; i++)
        free(overlay->columns[i].values);
    free(overlay->columns);
    *overlay = (Overlay){.y = -1};
}

/* --- which columns -------------------------------------------------------------------------------- */

static int column_named(const Overlay *overlay, const char *name)
{
    for (int i = 0; i < overlay->n_columns && *name; i++)
        if (strcasecmp(overlay->columns[i].name, name) == 0)
            return i;
    return -1;
}

static int first_named(const Overlay *overlay, const char *const *names)
{
    int found = -1;
    for (; *names && found < 0; names++)
        found = column_named(overlay, *names);
    return found;
}

static const char *const times[] = {"time", "t", "zeit", NULL}, *const places[] = {"x", "x0", NULL};

int overlay_column(const Overlay *overlay, const char *text, Status *status)
{
    long number;
    int found = column_named(overlay, text);
    if (found < 0 && text_to_long(text, &number) && number >= 1 && number <= overlay->n_columns)
        found = (int)number - 1;
    if (found >= 0)
        return found;
    char list[200] = "";
    for (int i = 0; i < overlay->n_columns && overlay->columns[i].name[0]; i++)
        if (!text_list_add(list, sizeof list, overlay->columns[i].name))
            break;
    status_refuse(status, "%s:1: no column %.40s (%s%s1 to %d)", overlay->file, text, list,
                  list[0] ? ", or " : "", overlay->n_columns);
    return -1;
}

typedef struct Place {
    double x;
    size_t row;
} Place;

static int by_x(const void *a, const void *b)
{
    const Place *one = a, *other = b;
    if (one->x < other->x || one->x > other->x)
        return one->x < other->x ? -1 : 1;
    return one->row < other->row ? -1 : one->row > other->row;
}

/* Rows in the order of x, those without an x left out. */
static bool sort_rows(Overlay *overlay, Status *status)
{
    const double *x = overlay->columns[overlay->x].values;
    size_t kept = 0;
    bool ordered = true;
    for (size_t i = 0; i < overlay->count; i++)
        ordered = ordered && !isnan(x[i]) && (i == 0 || x[i - 1] <= x[i]);
    if (ordered)
        return true;
    Place *order = malloc(overlay->count * sizeof *order);
    double *sorted = malloc(overlay->count * sizeof *sorted);
    if (!order || !sorted) {
        free(order);
        free(sorted);
        return status_fail(status, "not enough memory for %s", overlay->file);
    }
    for (size_t i = 0; i < overlay->count; i++)
        if (!isnan(x[i]))
            order[kept++] = (Place){x[i], i};
    qsort(order, kept, sizeof *order, by_x);
    for (int c = 0; c < overlay->n_columns; c++) {
        double *values = overlay->columns[c].values;
        for (size_t i = 0; i < kept; i++)
            sorted[i] = values[order[i].row];
        memcpy(values, sorted, kept * sizeof *values);
    }
    overlay->count = kept;
    free(order);
    free(sorted);
    return true;
}

bool overlay_choose(Overlay *overlay, const char *x, const char *y, const char *curve, const char *field,
                    Status *status)
{
    int column = x ? overlay_column(overlay, x, status) : first_named(overlay, times);
    if (x && column < 0)
        return false;
    const int place = first_named(overlay, places);
    /* a table of a profile may hold its time too */
    if (!x && place >= 0 &&
        (column < 0 || (!y && column_named(overlay, curve) < 0 && column_named(overlay, field) >= 0)))
        column = place;
    overlay->x = column < 0 ? 0 : column;
    overlay->along = false;
    for (int i = 0; places[i] && !overlay->along; i++)
        overlay->along = strcasecmp(overlay->columns[overlay->x].name, places[i]) == 0;
    overlay->y = -1;
    const char *with = overlay->along ? field : curve;
    if (y && (overlay->y = overlay_column(overlay, y, status)) < 0)
        return false;
    if (!y && column_named(overlay, with) < 0) {
        if (overlay->n_columns != 2)
            return status_refuse(status,
                                 "%s:1: which of its %d columns? (overlay FILE X Y, by name or number)",
                                 overlay->file, overlay->n_columns);
        overlay->y = 1 - overlay->x;
    }
    visible_text(overlay->curve, OVERLAY_NAME_MAX, with);
    return sort_rows(overlay, status);
}

int overlay_column_for(const Overlay *overlay, const char *curve, bool along)
{
    if (along != overlay->along || overlay->count == 0)
        return -1;
    if (overlay->y >= 0)
        return strcmp(curve, overlay->curve) == 0 ? overlay->y : -1;
    return column_named(overlay, curve);
}

size_t overlay_find(const Overlay *overlay, double x)
{
    ASSERT_INDEX(overlay->x, overlay->n_columns);
    const double *values = overlay->count ? overlay->columns[overlay->x].values : NULL;
    size_t low = 0, high = overlay->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (values[middle] <= x)
            low = middle + 1;
        else
            high = middle;
    }
    return low > 0 ? low - 1 : overlay->count;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sentences about a plot or a map, from the display list that figures are made of (picture.h). */
#include "picture/table.h"
#include "picture/words/tell.h"

#include "base/math/functions.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define ROUNDING 1e-9 /* of what an axis shows */

enum { DIGITS = 4, LIST_DIGITS = 5, TERM_COLUMNS = 11, NAME_MAX = 96 };

/* --- numbers with their names ---------------------------------------------------------------------- */

/* Of "v_cm x10^-3", "t, ms", "x": the power of ten belongs to an axis's labels, a unit to the values. */
typedef struct Measure {
    char name[PICTURE_TEXT_MAX], unit[24];
    double scale;   /* values are divided by it */
    double nothing; /* anything smaller is round-off */
} Measure;

static Measure measure_of(const Axis *axis, const char *name)
{
    Measure measure = {.scale = 1, .nothing = ROUNDING * fmax(fabs(axis->low), fabs(axis->high))};
    glyphs_plain(GLYPHS_ASCII, name, measure.name, sizeof measure.name);
    char *power = strstr(measure.name, " x10^"), *comma = strrchr(measure.name, ',');
    if (power) {
        *power = '\0';
    } else if (comma && (!comma[1] || comma[1] == ' ')) {
        const char *word = comma + 1 + strspn(comma + 1, " ");
        const size_t unit = strcspn(word, " "); /* behind it stands how the axis goes */
        measure.scale = math_pow(10, axis->exponent);
        if (unit > 0)
            snprintf(measure.unit, sizeof measure.unit, " %.*s", unit < 22 ? (int)unit : 22, word);
        *comma = '\0';
    }
    return measure;
}

static const char *number(const Measure *measure, double value, char out[NAME_MAX])
{
    snprintf(out, NAME_MAX, "%s%s",
             text_rounded(fabs(value) < measure->nothing ? 0 : value / measure->scale, DIGITS).text,
             measure->unit);
    return out;
}

/* --- a curve --------------------------------------------------------------------------------------- */

typedef struct Curve {
    const double *points; /* x, y, ...; the finite ones count */
    size_t count;
    bool upright; /* x is plotted over y */
    size_t first, last, least, greatest;
    long crossings; /* of zero */
    double crossed; /* where the last one was */
} Curve;

static bool is_finite(const Curve *curve, size_t i)
{
    return isfinite(curve->points[2 * i]) && isfinite(curve->points[2 * i + 1]);
}

static double x_at(const Curve *curve, size_t i)
{
    return curve->points[2 * i + curve->upright];
}

static double y_at(const Curve *curve, size_t i)
{
    return curve->points[2 * i + !curve->upright];
}

/* False: nothing of it is a number. */
static bool look_at(const double *points, size_t count, bool upright, Curve *curve)
{
    *curve = (Curve){.points = points, .count = count, .upright = upright, .first = count};
    size_t before = count; /* the last one that is not on zero itself */
    for (size_t i = 0; i < count; i++) {
        if (!is_finite(curve, i))
            continue;
        if (curve->first == count)
            curve->first = curve->least = curve->greatest = i;
        curve->last = i;
        curve->least = y_at(curve, i) < y_at(curve, curve->least) ? i : curve->least;
        curve->greatest = y_at(curve, i) > y_at(curve, curve->greatest) ? i : curve->greatest;
        if (y_at(curve, i) == 0)
            continue;
        if (before < count && (y_at(curve, before) > 0) != (y_at(curve, i) > 0)) {
            const double share = y_at(curve, before) / (y_at(curve, before) - y_at(curve, i));
            curve->crossings++;
            curve->crossed = x_at(curve, before) + share * (x_at(curve, i) - x_at(curve, before));
        }
        before = i;
    }
    return curve->first < count;
}

/* Between its points; NAN: it does not reach there. Points ascend in x. */
static double value_at(const Curve *curve, double x)
{
    size_t low = curve->first, high = curve->last;
    if (!(x >= x_at(curve, low) && x <= x_at(curve, high)))
        return NAN;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        *(x_at(curve, middle) <= x ? &low : &high) = middle;
    }
    const double width = x_at(curve, high) - x_at(curve, low);
    const double share = width > 0 ? (x - x_at(curve, low)) / width : 0;
    return y_at(curve, low) + share * (y_at(curve, high) - y_at(curve, low));
}

static bool ascends(const Curve *curve)
{
    for (size_t i = curve->first; i < curve->last; i++)
        if (!(x_at(curve, i) < x_at(curve, i + 1)))
            return false;
    return true;
}

static bool is_monotone(const Curve *curve, int direction)
{
    double before = y_at(curve, curve->first);
    for (size_t i = curve->first; i <= curve->last; i++) {
        if (!is_finite(curve, i))
            continue;
        if (direction * (y_at(curve, i) - before) < 0)
            return false;
        before = y_at(curve, i);
    }
    return true;
}

/* --- what is said of it ---------------------------------------------------------------------------- */

/* The legend's entry that looks like the stroke; entries of the same look come in the same order. */
static void name_of(const Picture *picture, int index, char name[NAME_MAX])
{
    const Stroke *stroke = &picture->plot.strokes[index];
    int earlier = 0;
    for (int i = 0; i < index; i++)
        earlier +=
            picture->plot.strokes[i].style == stroke->style && picture->plot.strokes[i].line == stroke->line;
    const PictureKey *named = NULL;
    for (int i = 0; i < picture->n_keys; i++) {
        const PictureKey *key = &picture->keys[i];
        const bool of_run =
            (key->name[0] == 'A' || key->name[0] == 'B') && (!key->name[1] || key->name[1] == ' ');
        const bool alike = stroke->kind == STROKE_BAND ? !of_run : key->line == stroke->line;
        if (key->style == stroke->style && alike && (!named || earlier-- > 0))
            named = key;
    }
    if (named && picture_run_of(named))
        snprintf(name, NAME_MAX, "earlier run %c, %.70s", picture_run_of(named), named->name);
    else
        snprintf(name, NAME_MAX, "%.90s",
                 named                             ? named->name
                 : stroke->kind == STROKE_BAND     ? "a part"
                 : stroke->style == STYLE_MEASURED ? "measured"
                                                   : "a curve");
}

static void say_curve(Words *words, const char *name, const Curve *curve, const Measure *x, const Measure *y)
{
    char a[NAME_MAX], b[NAME_MAX], c[NAME_MAX], d[NAME_MAX], text[1200] = "";
    const double first = y_at(curve, curve->first), last = y_at(curve, curve->last);
    const double least = y_at(curve, curve->least), greatest = y_at(curve, curve->greatest);
    if (curve->first == curve->last) {
        words_say(words, 4, "  %s: %s at %s %s.", name, number(y, first, a), x->name,
                  number(x, x_at(curve, curve->first), b));
        return;
    }
    text_append(text, sizeof text, "from %s %s to %s: ", x->name, number(x, x_at(curve, curve->first), a),
                number(x, x_at(curve, curve->last), b));
    if (!(greatest - least > y->nothing))
        text_append(text, sizeof text, "stays at %s", number(y, first, a));
    else if (is_monotone(curve, 1) || is_monotone(curve, -1))
        text_append(text, sizeof text, "%s all the way from %s to %s", last > first ? "rises" : "falls",
                    number(y, first, a), number(y, last, b));
    else
        text_append(text, sizeof text, "begins at %s, least %s at %s, greatest %s at %s", number(y, first, a),
                    number(y, least, b), number(x, x_at(curve, curve->least), c), number(y, greatest, d),
                    number(x, x_at(curve, curve->greatest), (char[NAME_MAX]){0}));
    const bool changes = greatest - least > y->nothing;
    number(x, curve->crossed, a);
    if (changes && curve->crossings == 1)
        text_append(text, sizeof text, "; crosses zero once, at %s", a);
    else if (changes && curve->crossings > 1)
        text_append(text, sizeof text, "; crosses zero %ld times, the last at %s", curve->crossings, a);
    if (changes && !is_monotone(curve, 1) && !is_monotone(curve, -1)) {
        size_t before = curve->last;
        while (before > curve->first && (!is_finite(curve, before) || y_at(curve, before) == last))
            before--;
        text_append(text, sizeof text, "; ends at %s, %s", number(y, last, a),
                    y_at(curve, before) < last ? "rising" : "falling");
    }
    words_say(words, 4, "  %s: %s.", name, text);
}

static void say_band(Words *words, const char *name, const double *points, size_t count, const Measure *x,
                     const Measure *y)
{
    double most = -1, at = NAN, last = NAN;
    for (size_t i = 0; i + 1 < count; i += 2) {
        const double height = points[2 * i + 3] - points[2 * i + 1];
        if (!isfinite(height))
            continue;
        last = height;
        if (height > most)
            most = height, at = points[2 * i];
    }
    char a[NAME_MAX], b[NAME_MAX], c[NAME_MAX];
    if (!isnan(at))
        words_say(words, 4, "  %s: a band of height %s at the end, at most %s at %s %s.", name,
                  number(y, last, a), number(y, most, b), x->name, number(x, at, c));
}

/* A line in a plane turns back as it likes: where it begins and ends, and how far it reaches. */
static void say_path(Words *words, const char *name, const Curve *curve, const Measure *x, const Measure *y)
{
    char texts[8][NAME_MAX];
    double low[2], high[2];
    for (int d = 0; d < 2; d++) {
        low[d] = INFINITY, high[d] = -INFINITY;
        for (size_t i = curve->first; i <= curve->last; i++)
            if (is_finite(curve, i)) {
                low[d] = fmin(low[d], curve->points[2 * i + (size_t)d]);
                high[d] = fmax(high[d], curve->points[2 * i + (size_t)d]);
            }
    }
    number(x, x_at(curve, curve->first), texts[0]);
    number(y, y_at(curve, curve->first), texts[1]);
    if (curve->first == curve->last) {
        words_say(words, 4, "  %s: at %s %s, %s %s.", name, x->name, texts[0], y->name, texts[1]);
        return;
    }
    words_say(words, 4, "  %s: a path from %s %s, %s %s to %s, %s; it lies between %s and %s, %s and %s.",
              name, x->name, texts[0], y->name, texts[1], number(x, x_at(curve, curve->last), texts[2]),
              number(y, y_at(curve, curve->last), texts[3]), number(x, low[0], texts[4]),
              number(x, high[0], texts[5]), number(y, low[1], texts[6]), number(y, high[1], texts[7]));
}

/* The same thing drawn as a line and as dots is described once; two cracks that grow alike are two. */
static bool is_told(const Picture *picture, int index)
{
    const Plot *plot = &picture->plot;
    for (int i = 0; i < index; i++)
        if (plot->strokes[i].kind != plot->strokes[index].kind &&
            plot->strokes[i].count == plot->strokes[index].count &&
            plot->strokes[i].style == plot->strokes[index].style &&
            memcmp(plot->points + 2 * plot->strokes[i].first, plot->points + 2 * plot->strokes[index].first,
                   2 * plot->strokes[i].count * sizeof(double)) == 0)
            return true;
    return false;
}

/* Each of the values from stroke to stroke, in the kind of picture that it is. */
static void say_stroke(const Picture *picture, int index, double cursor, const Curve *curve, const Measure *x,
                       const Measure *y, Words *words)
{
    const Stroke *stroke = &picture->plot.strokes[index];
    bool is_path = picture->kind == PICTURE_PATH;
    char name[NAME_MAX], a[NAME_MAX], b[NAME_MAX], c[NAME_MAX], d[NAME_MAX];
    /* one that turns back is none of x, whatever the picture says */
    for (size_t i = curve->first; i < curve->last && stroke->kind == STROKE_LINE; i++)
        is_path |= x_at(curve, i + 1) < x_at(curve, i);
    name_of(picture, index, name);
    if (stroke->kind == STROKE_BAND && picture->kind == PICTURE_BARS)
        words_say(words, 4, "  %s %s: %s.", x->name, number(x, (x_at(curve, 0) + x_at(curve, 2)) / 2, a),
                  number(y, y_at(curve, 1), b));
    else if (stroke->kind == STROKE_BAND)
        say_band(words, name, curve->points, stroke->count, x, y);
    else if (is_path)
        say_path(words, name, curve, x, y);
    else if (stroke->kind == STROKE_DOTS)
        words_say(words, 4, "  %s: %zu dots, least %s at %s %s, greatest %s at %s.", name, curve->count,
                  number(y, y_at(curve, curve->least), a), x->name, number(x, x_at(curve, curve->least), b),
                  number(y, y_at(curve, curve->greatest), c), number(x, x_at(curve, curve->greatest), d));
    else
        say_curve(words, name, curve, x, y);
    if (stroke->kind == STROKE_LINE && !is_path && isfinite(value_at(curve, cursor)))
        words_say(words, 4, "  %s at the cursor, %s %s: %s.", name, x->name, number(x, cursor, a),
                  number(y, value_at(curve, cursor), b));
}

static void say_strokes(const Picture *picture, double cursor, Words *words)
{
    const Plot *plot = &picture->plot;
    const bool upright = picture->kind == PICTURE_UPRIGHT;
    const Measure across = measure_of(&plot->x, picture->x_name);
    const Measure up = measure_of(&plot->y, picture->heading);
    Measure x = upright ? up : across, y = upright ? across : up;
    const char *height = strrchr(up.name, ','); /* "bending, y": the picture, and what goes up in it */
    if (upright && height)
        snprintf(x.name, sizeof x.name, "%s", height + 1 + strspn(height + 1, " "));
    Curve measured = {.count = 0};
    char name[NAME_MAX], whose[NAME_MAX] = "";
    words_say(words, 4, "  %s over %s.", y.name, x.name);
    for (int i = 0; i < plot->n_strokes; i++) {
        const Stroke *stroke = &plot->strokes[i];
        const double *points = plot->points + 2 * stroke->first;
        Curve curve;
        if (stroke->count == 0 || is_told(picture, i) || !look_at(points, stroke->count, upright, &curve))
            continue;
        say_stroke(picture, i, cursor, &curve, &x, &y, words);
        if (stroke->kind == STROKE_LINE && stroke->style == STYLE_MEASURED && measured.count == 0) {
            measured = curve;
            name_of(picture, i, whose);
        }
    }
    for (int i = 0; i < plot->n_strokes && measured.count > 0; i++) {
        const Stroke *stroke = &plot->strokes[i];
        const double *points = plot->points + 2 * stroke->first;
        const bool marked = stroke->count == 2 && points[0] == plot->x.low && points[2] == plot->x.high;
        Curve curve;
        /* another curve of the same thing, not a value that is marked from edge to edge */
        if (!picture->compares || stroke->kind != STROKE_LINE || marked ||
            (stroke->style != STYLE_EXACT && stroke->style != STYLE_PREDICTED &&
             stroke->style != STYLE_SECOND) ||
            !look_at(points, stroke->count, upright, &curve))
            continue;
        name_of(picture, i, name);
        /* How far the measured curve is from another one. */
        double most = 0, at = NAN, end = NAN;
        if (ascends(&measured) && ascends(&curve)) {
            for (size_t j = measured.first; j <= measured.last; j++) {
                const double away = y_at(&measured, j) - value_at(&curve, x_at(&measured, j));
                if (!isfinite(away))
                    continue;
                end = away;
                if (isnan(at) || fabs(away) > most)
                    most = fabs(away), at = x_at(&measured, j);
            }
            char a[NAME_MAX], b[NAME_MAX], c[NAME_MAX];
            if (!isnan(at) && !(most > y.nothing))
                words_say(words, 4, "  %s lies on %s.", whose, name);
            else if (!isnan(at))
                words_say(words, 4, "  %s is away from %s by at most %s, at %s %s; at the end it is %s %s.",
                          whose, name, number(&y, most, a), x.name, number(&x, at, b),
                          number(&y, fabs(end), c),
                          end > 0   ? "above"
                          : end < 0 ? "below"
                                    : "beside");
        }
    }
}

/* --- a map ------------------------------------------------------------------------------------------ */

/* "greatest: 1.2 J/m^3, 37 % along, at the upper edge." */
static void say_piece(Words *words, const char *what, const PictureMap *map, size_t piece)
{
    char place[NAME_MAX];
    /* "37 % along, at the upper edge" */
    const int column = (int)(piece % (size_t)map->nx), row = (int)(piece / (size_t)map->nx);
    const double along = map->nx > 1 ? 100.0 * column / (map->nx - 1) : 0;
    if (map->is_cloud)
        snprintf(place, NAME_MAX, "at %s, %s", text_rounded(map->x[piece], DIGITS).text,
                 text_rounded(map->y[piece], DIGITS).text);
    else if (row == 0 || row == map->ny - 1)
        snprintf(place, NAME_MAX, "%.0f %% along, at the %s edge", along, row == 0 ? "lower" : "upper");
    else
        snprintf(place, NAME_MAX, "%.0f %% along, %.0f %% up", along, 100.0 * row / (map->ny - 1));
    words_say(words, 4, "  %s: %s%s%s, %s.", what, text_rounded(map->value[piece], DIGITS).text,
              map->unit[0] ? " " : "", map->unit, place);
}

static void say_map(const Picture *picture, Words *words)
{
    const PictureMap *map = picture->map;
    if (map->kinds) {
        /* Of each thing where it lies. */
        for (int kind = 0; kind < map->kinds; kind++) {
            size_t count = 0;
            double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
            for (size_t i = 0; i < (size_t)map->nx; i++) {
                const double place[2] = {map->x[i], map->y[i]};
                if ((int)map->value[i] != kind)
                    continue;
                count++;
                for (int d = 0; d < 2; d++) {
                    low[d] = fmin(low[d], place[d]);
                    high[d] = fmax(high[d], place[d]);
                }
            }
            words_say(words, 4, "  %s: %zu particles, x from %s to %s, y from %s to %s.",
                      map->kind_names[kind], count, text_rounded(low[0], DIGITS).text,
                      text_rounded(high[0], DIGITS).text, text_rounded(low[1], DIGITS).text,
                      text_rounded(high[1], DIGITS).text);
        }
        return;
    }
    const size_t count = (size_t)map->nx * (size_t)map->ny;
    size_t least = count, greatest = count, shown = 0;
    for (size_t i = 0; i < count; i++) {
        if (map->torn[i] || !isfinite(map->value[i]))
            continue;
        shown++;
        least = least == count || map->value[i] < map->value[least] ? i : least;
        greatest = greatest == count || map->value[i] > map->value[greatest] ? i : greatest;
    }
    if (map->is_cloud)
        words_say(words, 4, "  %d particles, coloured by %s.", map->nx, picture->heading);
    else
        words_say(words, 4, "  %d by %d nodes, coloured by %s; displacements are drawn %s times as large.",
                  map->nx, map->ny, picture->heading, text_factor(map->enlarged).text);
    if (shown > 0 && map->value[greatest] == map->value[least]) {
        words_say(words, 4, "  everywhere %s%s%s.", text_rounded(map->value[least], DIGITS).text,
                  map->unit[0] ? " " : "", map->unit);
    } else if (shown > 0) {
        say_piece(words, "greatest", map, greatest);
        say_piece(words, "least", map, least);
    }
    if (shown < count)
        words_say(words, 4, "  %zu nodes are too much damaged to have a colour.", count - shown);
    for (int i = 0; i < picture->n_keys; i++)
        if (picture_run_of(&picture->keys[i]))
            words_say(words, 4, "  dashed over it, %c: %s.", (char)picture->keys[i].sign,
                      picture->keys[i].name);
}

/* "particle: x; velocity", then "25: 12.75, 0.08" or "t 5.1: bond broke" of rows around the chosen one. */
static void say_list(const Picture *picture, Words *words)
{
    const PictureList *list = picture->list;
    const size_t around = (size_t)picture->rows / 2;
    char text[1024] = "", value[NUMBER_TEXT_MAX];
    for (int c = 0; c < list->n_columns; c++)
        text_append(text, sizeof text, "%s %s", c ? ";" : "", list->columns[c].name);
    if (list->what[0])
        words_say(words, 4, "  %s:%s", list->what, text);
    for (size_t i = 0; i < list->rows; i++) {
        const size_t row = list->first + i;
        if (row + around < list->chosen || row > list->chosen + around)
            continue;
        text[0] = '\0';
        for (int c = 0; c < list->n_columns; c++) {
            const PictureCell *cell = picture_cell(list, c, i);
            const ListKind kind = list->columns[c].kind;
            strcpy(value, text_rounded(cell->value, LIST_DIGITS).text);
            if (kind == LIST_SIGN)
                snprintf(value, sizeof value, "%c", cell->letter);
            if (kind != LIST_SIGN || cell->letter)
                text_append(text, sizeof text, "%s %s", *text && list->what[0] ? "," : "",
                            kind == LIST_WORDS ? cell->words : value);
        }
        words_say(words, 4, "  %s:%s", list->names[i], text);
    }
}

/* Terms and sums as they add up on paper too, in the power of ten that stands at the head. */
static void say_table(const PictureTable *table, Words *words)
{
    Writing writings[TABLE_COLUMNS_MAX] = {{0}};
    double totals[TABLE_COLUMNS_MAX][TOTALS];
    char text[1024] = "", value[64];
    if (table->title[0])
        words_say(words, 4, table->notes[0] ? "  %s; %s." : "  %s.", table->title, table->notes);
    for (int c = 0; c < table->n_columns; c++) {
        const TableColumn *column = &table->columns[c];
        totals[c][TOTAL_BASE] = column->base;
        totals[c][TOTAL_RESULT] = column->result;
        if (column->adds)
            writings[c] = table_writing(table, column, TERM_COLUMNS, &totals[c][TOTAL_SUM]);
        text_append(text, sizeof text, "%s %s%s%s", c ? ";" : "", column->name, column->label ? ", " : "",
                    column->label ? column->label : "");
        if (writings[c].exponent != 0)
            text_append(text, sizeof text, " x10^%d", writings[c].exponent);
    }
    words_say(words, 4, "  %s:%s", table->what, text);
    for (size_t i = 0; i < table->count; i++) {
        text[0] = '\0';
        for (int c = 0; c < table->n_columns; c++) {
            strcpy(value, text_rounded(table->columns[c].values[i], LIST_DIGITS).text);
            if (table->columns[c].adds)
                sum_column_number(table->columns[c].values[i], writings[c], writings[c].decimals, value);
            text_append(text, sizeof text, "%s %s", c ? "," : "", value);
        }
        words_say(words, 4, "  %s:%s", table->rows[i].name, text);
    }
    for (TableTotal i = 0; i < TOTALS; i++) {
        text[0] = '\0';
        for (int c = 0; c < table->n_columns; c++) {
            if (!table->columns[c].adds || isnan(totals[c][i]))
                continue;
            sum_column_number(totals[c][i], writings[c], table_decimals(&table->columns[c], i, writings[c]),
                              value);
            text_append(text, sizeof text, "%s %s", *text ? "," : "", value);
        }
        if (table->totals[i].name && *text)
            words_say(words, 4, "  %s:%s", table->totals[i].name, text);
    }
}

void tell_picture(const Picture *picture, double cursor, Words *words)
{
    const bool drawn = picture->kind == PICTURE_DRAWING, strip = picture->kind == PICTURE_STRIP;
    if (picture->map)
        say_map(picture, words);
    else if (picture->plot.n_strokes > 0 && !drawn && !picture->bare)
        say_strokes(picture, cursor, words);
    if (drawn || picture->bare || !picture->has_axes)
        words_say(words, 4, "  %s.", drawn ? picture->name : picture->heading);
    else {
        const Measure x = measure_of(&picture->plot.x, picture->x_name);
        char place[NAME_MAX];
        for (size_t i = 0; i < picture->n_marks; i++)
            if (picture->marks[i].kind == MARK_RULE && picture->marks[i].word && picture->marks[i].word[1])
                words_say(words, 4, "  at %s %s: %s.", x.name, number(&x, picture->marks[i].x, place),
                          picture->marks[i].word);
    }
    if (picture->list)
        say_list(picture, words);
    for (int i = 0; i < picture->n_labels && picture->bare; i++) {
        /* Of a drawing a thing with the numbers below its name, if it has any; and its words. */
        const PictureLabel *label = &picture->labels[i];
        const bool label_drawn = drawn || strip;
        if (!label_drawn || !label->thing || strchr(label->text, '\n')) {
            char text[2 * sizeof label->text] = "";
            for (const char *here = label->text; *here; here++)
                text_append(text, sizeof text, *here == '\n' ? ", " : "%c", *here);
            words_say(words, 4, label_drawn ? "  %s%s%s." : "  in the drawing: %s%s%s",
                      label->thing ? label->thing : "", label->thing ? " " : "", text);
        }
    }
    for (int i = 0; i < picture->n_arrows; i++)
        if (picture->arrows[i].told[0])
            words_say(words, 4, "  %s.", picture->arrows[i].told);
    for (int i = 0; i < picture->n_notes; i++)
        if (picture->notes[i].text[strspn(picture->notes[i].text, " ")])
            words_say(words, 4, "  %s", picture->notes[i].text + strspn(picture->notes[i].text, " "));
    if (picture->around) {
        /* The rows from above, as they lie. */
        const PictureAround *around = picture->around;
        const int side = 2 * around->reach + 1;
        words_say(words, 4, "  around it, row by row from above, # is the node itself: %s", around->meaning);
        for (int q = side - 1; q >= 0; q--) {
            char text[16 * AROUND_SIDE] = "";
            for (int p = 0; p < side; p++) {
                const struct AroundPlace *place = &around->places[q][p];
                char sign[8];
                sign[glyph_put(sign, place->sign)] = '\0';
                if (place->is_there && place->sign)
                    text_append(text, sizeof text, " %s", sign);
                else if (place->is_there)
                    text_append(text, sizeof text, " %.0f", round(place->value) + 0.0);
            }
            words_say(words, 4, " %s", text);
        }
    }
    for (int i = 0; i < picture->n_tables; i++)
        say_table(&picture->tables[i], words);
}

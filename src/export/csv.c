/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Header and rows of a table (export.h); the number format is that of base/text.h, with whole numbers written
 * directly, since they are most of a table. */
#include "export/export.h"

#include "base/assertion.h"
#include "base/text.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

static char separator(Dialect dialect)
{
    return dialect == DIALECT_SEMICOLON ? ';' : ',';
}

void csv_header(FILE *stream, Dialect dialect, const char *const *names, int count)
{
    ASSERT_INT(count, >=, 1);
    for (int i = 0; i < count; i++)
        fprintf(stream, "%s%c", names[i], i + 1 < count ? separator(dialect) : '\n');
}

/* Whole numbers make up much of a table, and need no search for the shortest text. */
static size_t write_number(char *out, double value)
{
    if (!(fabs(value) < 1e15) || value != floor(value) || (value == 0 && signbit(value)))
        return text_shortest(out, value);
    char digits[NUMBER_TEXT_MAX];
    size_t n = 0, length = 0;
    unsigned long long rest = (unsigned long long)fabs(value);
    do
        digits[n++] = (char)('0' + rest % 10);
    while ((rest /= 10) > 0);
    if (value < 0)
        out[length++] = '-';
    while (n > 0)
        out[length++] = digits[--n];
    return length;
}

static void write_numbers(FILE *stream, Dialect dialect, const double *row, int count)
{
    char text[NUMBER_TEXT_MAX];
    for (int i = 0; i < count; i++) {
        size_t length = isnan(row[i]) ? 0 : write_number(text, row[i]);
        char *point = dialect == DIALECT_SEMICOLON ? memchr(text, '.', length) : NULL;
        if (point)
            *point = ',';
        if (i > 0)
            fputc(separator(dialect), stream);
        fwrite(text, 1, length, stream);
    }
}

void csv_begin(FILE *stream, Dialect dialect, const double *row, int count, const char *word)
{
    write_numbers(stream, dialect, row, count);
    if (count > 0)
        fputc(separator(dialect), stream);
    if (word)
        fprintf(stream, "%s%c", word, separator(dialect));
}

void csv_row(FILE *stream, Dialect dialect, const double *row, int count)
{
    write_numbers(stream, dialect, row, count);
    fputc('\n', stream);
}

void csv_words(FILE *stream, Dialect dialect, const char *const *cells, int count)
{
    for (int i = 0; i < count; i++) {
        const char *text = cells[i];
        double number;
        const bool is_number = text_to_double(text, &number);
        const bool formula = !is_number && *text && strchr("=+-@\t\r\n", *text);
        const bool quoted = strpbrk(text, "\"\r\n,;") != NULL;
        if (quoted)
            fputc('"', stream);
        if (formula)
            fputc('\'', stream);
        for (; *text; text++) {
            if (*text == '"')
                fputc('"', stream);
            fputc(is_number && *text == '.' && dialect == DIALECT_SEMICOLON ? ',' : *text, stream);
        }
        if (quoted)
            fputc('"', stream);
        fputc(i + 1 < count ? separator(dialect) : '\n', stream);
    }
}

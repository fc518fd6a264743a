/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers and words as text (text.h), by snprintf() and strtod(): LC_NUMERIC stays "C" in this program. */
#include "base/math/functions.h"
#include "base/text.h"

#include "base/assertion.h"
#include "base/cancel.h"
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

size_t text_trim_exponent(char *text)
{
    char *e = strchr(text, 'e');
    if (!e)
        return strlen(text);
    char *to = e + 1;
    const char *from = to;
    if (*from == '-')
        to++, from++;
    else if (*from == '+')
        from++;
    while (*from == '0' && from[1])
        from++;
    memmove(to, from, strlen(from) + 1);
    return strlen(text);
}

size_t text_shortest(char *out, double value)
{
    if (!isfinite(value)) {
        strcpy(out, isnan(value) ? "nan" : value > 0 ? "inf" : "-inf");
        return strlen(out);
    }
    /* fifteen digits always survive the way through a normal double, so fewer need not be tried there */
    int digits = isnormal(value) || value == 0 ? 15 : 1;
    for (; digits <= 17; digits++) {
        snprintf(out, NUMBER_TEXT_MAX, "%.*g", digits, value);
        if (strtod(out, NULL) == value)
            break;
    }
    return text_trim_exponent(out);
}

NumberText text_rounded(double value, int digits)
{
    ASSERT_INT(digits, >=, 1);
    NumberText number;
    if (!isfinite(value))
        text_shortest(number.text, value);
    else
        snprintf(number.text, sizeof number.text, "%.*g", digits, value == 0 ? 0.0 : value);
    text_trim_exponent(number.text);
    return number;
}

NumberText text_limit(double most, int digits)
{
    const NumberText number = text_rounded(most, digits);
    double read;
    if (!text_to_double(number.text, &read) || read <= most)
        return number;
    return text_rounded(read - math_pow(10, floor(math_log10(fabs(most))) - digits + 1), digits);
}

static const char spaces[] = " \t\n\v\f\r";

bool text_to_double(const char *text, double *value)
{
    /* strtod takes hexadecimal, "inf" and "nan" too: none of them is a parameter */
    for (const char *c = text; *c; c++)
        if (!isdigit((unsigned char)*c) && !isspace((unsigned char)*c) && !strchr("+-.eE", *c))
            return false;
    char *end;
    double read = strtod(text, &end);
    if (end == text || end[strspn(end, spaces)] || !isfinite(read))
        return false;
    *value = read;
    return true;
}

bool text_to_long(const char *text, long *value)
{
    char *end;
    const int before = shortage_begin();
    long read = strtol(text, &end, 10);
    const bool fits = errno == 0;
    shortage_end(before);
    if (end == text || end[strspn(end, spaces)] || !fits)
        return false;
    *value = read;
    return true;
}

bool text_to_size(const char *text, long least, long most, int size[2])
{
    for (int i = 0; i < 2; i++) {
        char *end;
        const long read = isdigit((unsigned char)*text) ? strtol(text, &end, 10) : -1;
        if (read < least || read > most || *end != (i ? '\0' : 'x'))
            return false;
        size[i] = (int)read;
        text = end + 1;
    }
    return true;
}

static size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

bool text_stream_close(FILE *stream, char *const *text)
{
    const bool written = ferror(stream) == 0;
    return fclose(stream) == 0 && written && *text;
}

size_t text_distance(const char *a, const char *b)
{
    enum { MAX = 64 };
    size_t n = strlen(a), m = strlen(b);
    if (n >= MAX || m >= MAX)
        return MAX;
    size_t rows[3][MAX];
    size_t *before = rows[0], *last = rows[1], *now = rows[2];
    for (size_t j = 0; j <= m; j++)
        last[j] = before[j] = j;
    for (size_t i = 1; i <= n; i++) {
        now[0] = i;
        for (size_t j = 1; j <= m; j++) {
            size_t replaced = last[j - 1] + (a[i - 1] != b[j - 1]);
            now[j] = smaller(replaced, smaller(last[j], now[j - 1]) + 1);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = smaller(now[j], before[j - 2] + 1);
        }
        size_t *free_row = before;
        before = last, last = now, now = free_row;
    }
    return last[m];
}

bool text_list_add(char *list, size_t size, const char *item)
{
    ASSERT_INT(size, >, 0);
    static const char more[] = " ...";
    const size_t used = strlen(list);
    if (used + strlen(item) + sizeof ", " + sizeof more <= size) {
        snprintf(list + used, size - used, "%s%s", used ? ", " : "", item);
        return true;
    }
    if (used + sizeof more <= size)
        snprintf(list + used, size - used, "%s", more + (used == 0));
    return false;
}

NumberText text_fitted(double value, int digits, int width)
{
    NumberText number;
    do
        number = text_rounded(value, digits);
    while ((int)strlen(number.text) > width && --digits > 0);
    return number;
}

NumberText text_factor(double factor)
{
    NumberText number = text_rounded(factor, 2);
    if (factor >= 1 && factor < 1e7)
        snprintf(number.text, sizeof number.text, "%.0f", factor);
    return number;
}

void text_append(char *out, size_t size, const char *format, ...)
{
    ASSERT_INT(size, >, 0);
    const size_t used = strlen(out);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(out + used, size - used, format, arguments);
    va_end(arguments);
}

void text_append_shell(char *out, size_t size, const char *word)
{
    static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./=,:+%@-";
    if (*word && word[strspn(word, plain)] == '\0') {
        text_append(out, size, "%s", word);
        return;
    }
    text_append(out, size, "'");
    for (; *word; word++)
        text_append(out, size, *word == '\'' ? "'\\''" : "%c", *word);
    text_append(out, size, "'");
}

void text_or(char *out, size_t size, const char *word)
{
    text_append(out, size, "%s%s", *out ? " | " : "", word);
}

static bool next_of(const char **text, const char *between, char *out, size_t size)
{
    *text += strspn(*text, between);
    const size_t length = strcspn(*text, between);
    if (length == 0)
        return false;
    snprintf(out, size, "%.*s", (int)length, *text);
    *text += length;
    return true;
}

bool text_next_word(const char **text, char *out, size_t size)
{
    return next_of(text, " ", out, size);
}

bool text_next_item(const char **list, char *out, size_t size)
{
    return next_of(list, ", ", out, size);
}

bool text_has_word(const char *list, const char *word)
{
    for (char item[128]; text_next_item(&list, item, sizeof item);)
        if (strcmp(item, word) == 0)
            return true;
    return false;
}

const char *text_last_word(const char *text)
{
    const char *space = strrchr(text, ' ');
    return space ? space + 1 : text;
}

int text_place_in(const char *word, const char *const words[])
{
    for (int i = 0; words && words[i]; i++)
        if (strcmp(words[i], word) == 0)
            return i;
    return -1;
}

void text_put_xml(FILE *stream, const char *text)
{
    static const char signs[] = "<>&\"", *const names[] = {"lt", "gt", "amp", "quot"};
    for (; *text; text++) {
        const char *sign = strchr(signs, *text);
        if (sign)
            fprintf(stream, "&%s;", names[sign - signs]);
        else
            fputc((unsigned char)*text < ' ' ? ' ' : *text, stream);
    }
}

void text_put_json(FILE *stream, const char *bytes, size_t count)
{
    fputc('"', stream);
    for (size_t i = 0; i < count; i++) {
        const unsigned char byte = (unsigned char)bytes[i];
        if (byte == '"' || byte == '\\')
            fprintf(stream, "\\%c", byte);
        else if (byte < ' ' || byte == 0x7f)
            fprintf(stream, "\\u%04x", byte);
        else
            fputc(byte, stream);
    }
    fputc('"', stream);
}

/* Of letters, and of signs that are read as words. */
static const char *const symbols[][2] = {
    {"Δ", "d"},     {"ε", "e"},     {"σ", "s"},     {"ω", "w"},      {"Ω", "W"},
    {"α", "alpha"}, {"β", "beta"},  {"γ", "gamma"}, {"δ", "delta"},  {"ρ", "rho"},
    {"φ", "phi"},   {"ξ", "xi"},    {"η", "eta"},   {"μ", "mu"},     {"ν", "nu"},
    {"π", "pi"},    {"κ", "kappa"}, {"θ", "theta"}, {"λ", "lambda"}, {"τ", "tau"},
    {"Σ", "sum"},   {"∫", "int"},   {"√", "sqrt"},  {"∂", "d"},      {"∇", "grad "},
};
static const char *const marks[][2] = {
    {"→", "->"},  {"←", "<-"},   {"×", "x"},  {"′", "'"},  {"↑", "Up"},  {"↓", "Down"}, {"½", "1/2"},
    {"⅔", "2/3"}, {"⁻¹", "^-1"}, {"²", "^2"}, {"³", "^3"}, {"⁴", "^4"},  {"₀", "0"},    {"₁", "1"},
    {"−", "-"},   {"≤", "<="},   {"≥", ">="}, {"±", "+-"}, {"…", "..."}, {"°", " deg"}, {"»", ">>"},
    {"«", "<<"},  {"·", "."},    {"ᵀ", "^T"}, {"ₙ", "n"},  {"ₜ", "t"},   {"⊗ ", ""},
};

static const char *spelled(const char *const table[][2], size_t count, const char **text)
{
    for (size_t i = 0; i < count; i++) {
        const size_t length = strlen(table[i][0]);
        if (strncmp(*text, table[i][0], length) == 0) {
            *text += length;
            return table[i][1];
        }
    }
    return NULL;
}

static bool is_alphanumeric(const char *text, size_t at)
{
    return isalnum((unsigned char)text[at]) != 0;
}

void text_to_ascii(const char *text, char *out, size_t size)
{
    size_t used = 0;
    bool word = false; /* the last symbol became one */
    while (*text != '\0') {
        const char *from = spelled(symbols, sizeof symbols / sizeof *symbols, &text), *symbol = from;
        if (!from)
            from = spelled(marks, sizeof marks / sizeof *marks, &text);
        const char letter[] = {*text, '\0'};
        if (!from) {
            from = letter;
            text++;
        }
        /* "d" of "dσ" and "Δσ" belongs to what is behind it, unless it ends a word or a product. */
        const bool apart =
            used > 0 && is_alphanumeric(out, used - 1) && is_alphanumeric(from, 0) &&
            (word || (symbol && !(out[used - 1] == 'd' && (used == 1 || !is_alphanumeric(out, used - 2)))));
        if (used + apart + strlen(from) >= size)
            break;
        used += (size_t)snprintf(out + used, size - used, "%s%s", apart ? " " : "", from);
        word = symbol && symbol[1];
    }
    out[used] = '\0';
}

bool text_tells_separator(const char *line)
{
    return strncasecmp(line, "sep=", 4) == 0 && strlen(line) <= 5;
}

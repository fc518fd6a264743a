/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "sums.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- expressions: + - × x / and brackets; "to 12" and "(3 more)" are words --- */

typedef struct Reader {
    const char *at;
    bool good;
    double largest;
} Reader;

static void skip(Reader *reader)
{
    for (;;) {
        int words = 0;
        while (*reader->at == ' ')
            reader->at++;
        sscanf(reader->at, "to %*d%n", &words);
        if (words == 0)
            sscanf(reader->at, "(%*d more)%n", &words);
        if (words == 0)
            return;
        reader->at += words;
    }
}

static double sum(Reader *reader);

static double factor(Reader *reader)
{
    skip(reader);
    if (*reader->at == '(') {
        reader->at++;
        const double value = sum(reader);
        skip(reader);
        reader->good &= *reader->at == ')';
        reader->at += *reader->at == ')';
        return value;
    }
    char *end;
    const double value = strtod(reader->at, &end);
    reader->good &= end != reader->at;
    reader->at = end;
    reader->largest = fmax(reader->largest, fabs(value));
    return value;
}

static double product(Reader *reader)
{
    double value = factor(reader);
    for (skip(reader); reader->good && (*reader->at == 'x' || *reader->at == '/'); skip(reader)) {
        const bool times = *reader->at++ == 'x';
        const double other = factor(reader);
        value = times ? value * other : value / other;
    }
    return value;
}

static double sum(Reader *reader)
{
    double value = product(reader);
    for (skip(reader); reader->good && (*reader->at == '+' || *reader->at == '-'); skip(reader)) {
        const double sign = *reader->at++ == '+' ? 1 : -1;
        value += sign * product(reader);
    }
    return value;
}

/* Half of the last place of a printed number: .005 of "0.12" and .0005e-3 of "1.120e-3". */
static double half_of_last_place(const char *number)
{
    const char *point = NULL;
    int places = 0;
    for (; *number == '-' || *number == '.' || isdigit((unsigned char)*number); number++) {
        places += point != NULL;
        if (*number == '.')
            point = number;
    }
    const int exponent = *number == 'e' ? atoi(number + 1) : 0;
    return 0.5 * pow(10, exponent - places);
}

bool read_sum(const char *line, PrintedSum *out)
{
    /* plain: no-break spaces are spaces, × is x */
    char plain[8192];
    size_t used = 0;
    for (; *line != '\0' && *line != '\n' && used + 1 < sizeof plain; line++) {
        const bool space = strncmp(line, "\u00a0", 2) == 0, times = strncmp(line, "×", 2) == 0;
        plain[used++] = space ? ' ' : times ? 'x' : *line;
        line += space || times;
    }
    plain[used] = '\0';
    char *result = strrchr(plain, '=');
    if (!result)
        return false;
    *result++ = '\0';
    char *end;
    out->result = strtod(result, &end);
    if (end == result)
        return false;
    out->last = half_of_last_place(result + strspn(result, " "));
    char *equals = strrchr(plain, '='), *colon = strrchr(plain, ':');
    char *from = equals > colon ? equals : colon;
    if (!from)
        return false;
    Reader reader = {from + 1, true, 0};
    out->value = sum(&reader);
    skip(&reader);
    out->largest = reader.largest;
    const size_t label = strcspn(plain, "=:");
    snprintf(out->label, sizeof out->label, "%.*s", (int)(label < 60 ? label : 60), plain);
    for (size_t n = strlen(out->label); n > 0 && out->label[n - 1] == ' '; n--)
        out->label[n - 1] = '\0';
    return reader.good && *reader.at == '\0';
}

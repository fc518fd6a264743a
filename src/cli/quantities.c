/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes the summary of a command as JSON (quantities.h). */
#include "cli/quantities.h"

#include "base/text.h"

#include <math.h>
#include <string.h>

static void put_text(FILE *out, const char *text)
{
    if (text)
        text_put_json(out, text, strlen(text));
    else
        fputs("null", out);
}

static void put_key(Quantities *list, const char *key)
{
    fputs(", ", list->out);
    put_text(list->out, key);
    fputs(": ", list->out);
}

Quantities quantities_open(FILE *out, const char *command)
{
    fputs("{\"command\": ", out);
    put_text(out, command);
    return (Quantities){out, 0};
}

void quantities_begin(Quantities *list, const char *key)
{
    put_key(list, key);
    fputc('[', list->out);
    list->count = 0;
}

void quantities_add(Quantities *list, const char *name, double value, const char *unit)
{
    fputs(list->count++ > 0 ? "},\n  {\"name\": " : "\n  {\"name\": ", list->out);
    put_text(list->out, name);
    quantities_number(list, "value", value);
    quantities_text(list, "unit", unit);
}

void quantities_end(Quantities *list)
{
    fputs(list->count > 0 ? "}]" : "]", list->out);
}

void quantities_close(Quantities *list)
{
    quantities_end(list);
    fputs("}\n", list->out);
}

void quantities_text(Quantities *list, const char *key, const char *text)
{
    put_key(list, key);
    put_text(list->out, text);
}

void quantities_number(Quantities *list, const char *key, double value)
{
    put_key(list, key);
    if (isfinite(value))
        fprintf(list->out, "%.17g", value);
    else
        fputs("null", list->out);
}

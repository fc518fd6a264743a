/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes the rows of a sweep: as CSV, with the shortest digits that read back, or aligned for reading.
 * Columns that no row has are left out. */
#include "cli/sweep/sweep_table.h"
#include "scenario/rows/rows.h"
#include "base/text.h"
#include "export/csv.h"

#include <math.h>
#include <string.h>

enum { TABLE_COLUMNS_MAX = AXES_MAX + RESULT_COLUMNS };

void sweep_table_choose_columns(SweepTable *table)
{
    table->rows = 0;
    for (int i = 0; i < table->plan->n_combinations; i++)
        table->rows += table->results[i].done;
    for (int column = 0; column < RESULT_COLUMNS; column++) {
        table->has[column] = false;
        for (int i = 0; i < table->plan->n_combinations; i++)
            table->has[column] =
                table->has[column] || (table->results[i].done && isfinite(table->results[i].cells[column]));
    }
}

static int names_of(const SweepTable *table, const char *names[TABLE_COLUMNS_MAX])
{
    int n = 0;
    for (int k = 0; k < table->plan->n_keys; k++)
        names[n++] = table->plan->keys[k].key;
    for (int column = 0; column < RESULT_COLUMNS; column++)
        if (table->has[column])
            names[n++] = sweep_result_name((ResultColumn)column);
    return n;
}

static void row_of(const SweepTable *table, int combination, double row[TABLE_COLUMNS_MAX])
{
    int n = table->plan->n_keys;
    memcpy(row, table->keys + (size_t)combination * (size_t)n, (size_t)n * sizeof *row);
    for (int column = 0; column < RESULT_COLUMNS; column++)
        if (table->has[column])
            row[n++] = table->results[combination].cells[column];
}

void sweep_table_write_csv(const SweepTable *table, Dialect dialect, FILE *stream)
{
    const char *names[TABLE_COLUMNS_MAX];
    double row[TABLE_COLUMNS_MAX];
    int n = names_of(table, names);
    csv_header(stream, dialect, names, n);
    for (int i = 0; i < table->plan->n_combinations; i++)
        if (table->results[i].done) {
            row_of(table, i, row);
            csv_row(stream, dialect, row, n);
        }
}

/* --- aligned -------------------------------------------------------------------------------------- */

static const char *word_of(const Parameter *parameter, const Problem *problem, double value)
{
    static const char *const flags[] = {"no", "yes"};
    if (!parameter)
        return NULL;
    if (parameter->type == PARAMETER_CHOICE)
        return parameter->choices[(int)value];
    if (parameter->type == PARAMETER_FLAG)
        return flags[value != 0];
    return value == parameter->automatic_value ? parameter_automatic(parameter, problem) : NULL;
}

static void cell_text(const SweepTable *table, int column, double value, char out[VALUE_MAX])
{
    const SweepPlan *plan = table->plan;
    const char *word =
        column < plan->n_keys ? word_of(plan->keys[column].parameter, table->problem, value) : NULL;
    if (word)
        snprintf(out, VALUE_MAX, "%s", word);
    else if (isnan(value))
        snprintf(out, VALUE_MAX, "-");
    else
        strcpy(out, text_rounded(value, 6).text);
}

void sweep_table_write_text(const SweepTable *table, FILE *stream)
{
    const char *names[TABLE_COLUMNS_MAX];
    double row[TABLE_COLUMNS_MAX];
    char text[VALUE_MAX];
    int width[TABLE_COLUMNS_MAX], n = names_of(table, names), last = table->plan->n_combinations;
    for (int column = 0; column < n; column++)
        width[column] = (int)strlen(names[column]);
    for (int i = 0; i < last; i++) {
        row_of(table, i, row);
        for (int column = 0; table->results[i].done && column < n; column++) {
            cell_text(table, column, row[column], text);
            if ((int)strlen(text) > width[column])
                width[column] = (int)strlen(text);
        }
    }
    for (int column = 0; column < n; column++)
        fprintf(stream, "%*s%s", width[column], names[column], column + 1 < n ? "  " : "\n");
    for (int i = 0; i < last; i++) {
        row_of(table, i, row);
        for (int column = 0; table->results[i].done && column < n; column++) {
            cell_text(table, column, row[column], text);
            fprintf(stream, "%*s%s", width[column], text, column + 1 < n ? "  " : "\n");
        }
    }
}

/* --- what the columns mean ------------------------------------------------------------------------ */

static void describe_key(const SweepTable *table, const SweepKey *key, FILE *stream)
{
    const Parameter *parameter = key->parameter;
    if (!parameter) {
        const RowColumn *column = row_key_column(key->key);
        fprintf(stream, "%s [%s]: %s of that row of the plate\n", key->key, column ? column->unit : "1",
                column ? column->word : "value");
        return;
    }
    const char *unit = parameter_unit(parameter, table->problem);
    fprintf(stream, "%s [%s]: %s", key->key, unit && *unit ? unit : "1",
            parameter_help(parameter, table->problem));
    if (parameter->type == PARAMETER_FLAG)
        fputs(" (0 = no, 1 = yes)", stream);
    else if (parameter_automatic(parameter, table->problem))
        fprintf(stream, " (0 = %s)", parameter_automatic(parameter, table->problem));
    for (int i = 0; parameter->type == PARAMETER_CHOICE && parameter->choices[i]; i++)
        fprintf(stream, "%s%d = %s%s", i ? ", " : " (", i, parameter->choices[i],
                parameter->choices[i + 1] ? "" : ")");
    fputc('\n', stream);
}

void sweep_table_describe(const SweepTable *table, FILE *stream)
{
    for (int k = 0; k < table->plan->n_keys; k++)
        describe_key(table, &table->plan->keys[k], stream);
    for (int column = 0; column < RESULT_COLUMNS; column++)
        if (table->has[column]) {
            Quantity quantity = sweep_result_quantity((ResultColumn)column);
            fprintf(stream, "%s [%s]: %s\n", quantity.name, quantity.unit, quantity.meaning);
        }
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The files of an export: tables, frames for ParaView, the scenarios that are beside. */
#include "base/text.h"

#include "base/assertion.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "export/export.h"
#include "export/export_internal.h"
#include "scenario/parameters.h"
#include "scenario/scenario.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CHUNK = 512 }; /* things of a table at once */

/* --- what is to be written ------------------------------------------------------------------------- */

static const char *const plurals[TABLES] = {"particles", "nodes", "bonds"};

static const char *table_name(const Outputs *outputs, int i)
{
    const char *const given[TABLES] = {outputs->particles, outputs->nodes, outputs->bonds};
    return given[i];
}

enum { NAMES_A_QUESTION = 256 };

static char *name_beside(const char *name)
{
    char *out;
    return asprintf(&out, "%s.ini", name) < 0 ? NULL : out;
}

static bool take_table_names(OutputNames *names, const char *name, Status *status)
{
    if (!name)
        return true;
    if (!output_names_take(names, name, status))
        return false;
    if (output_is_direct(name))
        return true;
    char *beside = name_beside(name);
    bool good = beside ? output_names_take(names, beside, status)
                       : status_fail(status, "not enough memory for file names");
    free(beside);
    return good;
}

static bool take_vtk_names(OutputNames *names, const char *name, size_t frames, const Cancel *cancel,
                           Status *status)
{
    if (!name)
        return true;
    if (output_is_standard(name))
        return status_refuse(status, "--vtk: needs a file, not standard output");
    bool good = true;
    for (size_t i = 0; good && i < frames + (frames > 1); i++) {
        char *one = i < frames ? vtk_frame_name(name, i, frames) : vtk_collection_name(name);
        good = one ? output_names_take(names, one, status)
                   : status_fail(status, "not enough memory for file names");
        free(one);
        if (good && i % NAMES_A_QUESTION == 0 && cancel_requested(cancel, (double)i / (double)frames))
            good = status_fail(status, "the export was cancelled");
    }
    return good;
}

/* Nothing is touched before all names are known to be good. */
bool export_check_names(const Export *export, Status *status)
{
    const Outputs *outputs = export->outputs;
    OutputNames names = {.asker = outputs->asker, .force = outputs->force};
    bool good = take_table_names(&names, outputs->series, status);
    for (int i = 0; good && i < TABLES; i++)
        good = take_table_names(&names, table_name(outputs, i), status);
    good =
        good && take_vtk_names(&names, outputs->vtk, export->frames.count, &export->settings->cancel, status);
    return output_names_differ(&names, good, status);
}

static bool find_set(Table *table, const Simulation *sim, const char *asked, int i, Status *status)
{
    for (table->set = 0; table->set < sim->n_sets; table->set++)
        if (strcmp(sim->sets[table->set].plural, plurals[i]) == 0)
            break;
    if (table->set == sim->n_sets)
        return status_refuse(status, "--%s: the method %s has none", plurals[i], sim->method->name);
    for (int f = 0; f < sim->n_fields && table->n_fields < TABLE_FIELDS_MAX; f++)
        /* What a set's table has, more that is asked for, and all of it after stages. */
        if (sim->fields[f].set == table->set && (sim->fields[f].in_table || table->of_stages ||
                                                 simulation_asks(asked, sim->fields[f].quantity.name)))
            table->fields[table->n_fields++] = f;
    table->indexed = table->n_fields == 0 || !sim->fields[table->fields[0]].integer;
    return true;
}

static bool open_beside(OutputFile *beside, const OutputFile *file, const Outputs *outputs, Status *status)
{
    /* a scenario is written beside files only */
    if (file->target == NULL)
        return true;
    char *name = name_beside(file->name);
    bool opened = name ? output_open(beside, outputs->asker, name, outputs->force, status)
                       : status_fail(status, "not enough memory for file names");
    free(name);
    return opened;
}

static void write_table_header(const Export *export, const Table *table)
{
    const char *names[TABLE_FIELDS_MAX + 4] = {"step", table->of_stages ? "stage" : "time"};
    int n = 2;
    if (table->of_stages)
        names[n++] = "stage_id";
    if (table->indexed)
        names[n++] = export->run.sim->sets[table->set].name;
    for (int i = 0; i < table->n_fields; i++)
        names[n++] = export->run.sim->fields[table->fields[i]].quantity.name;
    csv_header(table->file.stream, export->outputs->dialect, names, n);
}

bool export_open_files(Export *export, Status *status)
{
    const Outputs *outputs = export->outputs;
    if (outputs->series) {
        if (!output_open(&export->series, outputs->asker, outputs->series, outputs->force, status) ||
            !open_beside(&export->series_beside, &export->series, outputs, status))
            return false;
        const char *names[COLUMNS_MAX];
        for (int i = 0; i < export->n_written; i++)
            names[i] = export->columns[export->written[i]].quantity.name;
        csv_header(export->series.stream, export->outputs->dialect, names, export->n_written);
    }
    for (int i = 0; i < TABLES; i++) {
        Table *table = &export->tables[i];
        table->name = table_name(outputs, i);
        table->of_stages = outputs->stages[0] > 0;
        if (!table->name)
            continue;
        if (!find_set(table, export->run.sim, settings_output(export->settings)->columns, i, status) ||
            !output_open(&table->file, outputs->asker, table->name, outputs->force, status) ||
            !open_beside(&table->beside, &table->file, outputs, status))
            return false;
        write_table_header(export, table);
    }
    return true;
}

/* What is not known is NAN, and left out; an infinite number is a result that was not computed. */
static bool too_large(const Quantity *quantity, long step, Status *status)
{
    return status_fail(status,
                       "%s in step %ld is too large for a number: a value of the scenario is too large "
                       "or too small",
                       quantity->name, step);
}

bool export_write_row(Export *export, const double *row, Status *status)
{
    export->rows++;
    if (!export->series.stream)
        return true;
    double written[COLUMNS_MAX];
    for (int i = 0; i < export->n_written; i++) {
        written[i] = row[export->written[i]];
        if (isinf(written[i]))
            return too_large(&export->columns[export->written[i]].quantity, (long)row[0], status);
    }
    csv_row(export->series.stream, export->outputs->dialect, written, export->n_written);
    return output_sound(&export->series, status);
}

/* --- frames ---------------------------------------------------------------------------------------- */

/* A table of the present state, on its way into its file. */
typedef struct Sheet {
    Table *table;
    Dialect dialect;
    double *fields;
    int *infinite; /* the field that was, or -1 */
    long step;
    int stage; /* so many are done of the step that leads to `step`; 0: a whole step */
} Sheet;

static void write_things(const Simulation *sim, const Sheet *sheet)
{
    const Table *table = sheet->table;
    const size_t count = sim->counts[table->set];
    const char *const id = sheet->stage > 0 ? sim->stages[sheet->stage - 1].id : NULL;
    const double head[2] = {(double)sheet->step, id ? sheet->stage : simulation_time(sim)};
    const int indices = table->indexed ? 1 : 0;
    double row[TABLE_FIELDS_MAX + 1];
    for (size_t first = 0; first < count; first += CHUNK) {
        const size_t n = count - first < CHUNK ? count - first : CHUNK;
        for (int f = 0; f < table->n_fields; f++)
            sim->method->field(sim, table->fields[f], first, n, sheet->fields + (size_t)f * CHUNK);
        for (size_t k = 0; k < n; k++) {
            row[0] = (double)(first + k);
            for (int f = 0; f < table->n_fields; f++) {
                row[indices + f] = sheet->fields[(size_t)f * CHUNK + k];
                *sheet->infinite = isinf(row[indices + f]) ? table->fields[f] : *sheet->infinite;
            }
            csv_begin(table->file.stream, sheet->dialect, head, 2, id);
            csv_row(table->file.stream, sheet->dialect, row, indices + table->n_fields);
        }
    }
}

static void write_later_things(Simulation *sim, void *context)
{
    const Sheet *sheet = context;
    simulation_make_ready(sim, sheet->table->set);
    write_things(sim, sheet);
}

/* `stage`: 0 at a whole step; then what is ready only after some stages is taken from the next step. */
static bool write_table(Export *export, Table *table, long step, int stage, Status *status)
{
    Simulation *sim = export->run.sim;
    int infinite = -1;
    Sheet sheet = {table,
                   export->outputs->dialect,
                   malloc(((size_t)table->n_fields + 1) * CHUNK * sizeof *sheet.fields),
                   &infinite,
                   step,
                   stage};
    bool written = sheet.fields != NULL;
    if (written && (stage > 0 || sim->sets[table->set].ready_after == 0))
        write_things(sim, &sheet);
    else
        written = written && simulation_visit(sim, NULL, write_later_things, &sheet);
    free(sheet.fields);
    if (infinite >= 0)
        return too_large(&sim->fields[infinite].quantity, step, status);
    return written ? output_sound(&table->file, status)
                   : status_fail(status, "not enough memory to write %s", table->name);
}

static bool write_tables(Export *export, long step, int stage, Status *status)
{
    for (int i = 0; i < TABLES; i++)
        if (export->tables[i].name && !write_table(export, &export->tables[i], step, stage, status))
            return false;
    return true;
}

bool export_write_stage(Export *export, long step, int stage, Status *status)
{
    ASSERT_INT(step, >=, 0);
    const int only = export->outputs->stage;
    return (only > 0 && stage != only) || write_tables(export, step, stage, status);
}

static bool write_vtk(Export *export, Status *status)
{
    if (!export->outputs->vtk)
        return true;
    OutputFile *file = &export->vtk[export->next_frame];
    char *name = vtk_frame_name(export->outputs->vtk, export->next_frame, export->frames.count);
    bool written = name && output_open(file, export->outputs->asker, name, export->outputs->force, status);
    if (!name || (written && !vtk_write_frame(file->stream, export->run.sim, export->outputs->vtk_data)))
        written = status_fail(status, "not enough memory to write %s", export->outputs->vtk);
    free(name);
    return written && output_finish(file, status);
}

bool export_write_frame(Export *export, Status *status)
{
    export->frames.steps[export->next_frame] = export->run.sim->step;
    if (!write_tables(export, export->run.sim->step, 0, status) || !write_vtk(export, status))
        return false;
    export->next_frame++;
    return true;
}

/* --- the end --------------------------------------------------------------------------------------- */

static void describe(FILE *to, const Quantity *quantity)
{
    fprintf(to, "%s [%s]: %s\n", quantity->name, quantity->unit, quantity->meaning);
}

/* `table`: NULL for the series. */
static bool write_beside(const Export *export, const Settings *scenario, OutputFile *beside,
                         const Table *table, Status *status)
{
    char *comment = NULL;
    size_t size = 0;
    if (!beside->stream)
        return true;
    FILE *text = open_memstream(&comment, &size);
    if (!text)
        return status_fail(status, "not enough memory to write %s", beside->name);
    fprintf(text, "matvib " PACKAGE_VERSION "\n");
    if (*export->run.failure.text)
        fprintf(text, "the run stopped: %s\n", export->run.failure.text);
    if (export->outputs->dialect == DIALECT_SEMICOLON)
        fprintf(text,
                "written with --dialect semicolon, which no scenario holds: give it again for these bytes\n");
    if (table) {
        /* To which moment a row belongs. */
        const Simulation *sim = export->run.sim;
        const int ready = sim->sets[table->set].ready_after;
        if (table->of_stages)
            fprintf(text,
                    "written with --stages %ld:%ld, which no scenario holds: give it again for these bytes\n",
                    export->outputs->stages[0], export->outputs->stages[1]);
        else if (ready > 0)
            fprintf(text,
                    "A row of step n has the values of the step that follows, after its stage %d (%s).\n",
                    ready, sim->stages[ready - 1].name);
    }
    fprintf(text, "\nColumns:\n");
    if (table) {
        const Simulation *sim = export->run.sim;
        describe(text, &export->columns[0].quantity);
        if (table->of_stages)
            fprintf(text, "stage [1]: so many stages are done of the step that leads to `step`\n"
                          "stage_id: the last of them\n");
        else
            describe(text, &export->columns[1].quantity);
        if (table->indexed)
            fprintf(text, "%s [1]: which one, counted from 0\n", sim->sets[table->set].name);
        for (int i = 0; i < table->n_fields; i++)
            describe(text, &sim->fields[table->fields[i]].quantity);
    } else {
        for (int i = 0; i < export->n_written; i++)
            describe(text, &export->columns[export->written[i]].quantity);
    }
    bool written = text_stream_close(text, &comment)
                       ? scenario_write(beside->stream, scenario, comment, status)
                       : status_fail(status, "not enough memory to write %s", beside->name);
    free(comment);
    return written && output_finish(beside, status);
}

static bool write_collection(Export *export, Status *status)
{
    if (!export->outputs->vtk || export->frames.count < 2)
        return true;
    char *name = vtk_collection_name(export->outputs->vtk);
    bool opened = name && output_open(&export->collection, export->outputs->asker, name,
                                      export->outputs->force, status);
    if (!name)
        status_fail(status, "not enough memory to write %s", export->outputs->vtk);
    free(name);
    if (!opened)
        return false;
    vtk_begin_collection(export->collection.stream);
    for (size_t i = 0; i < export->next_frame; i++)
        vtk_add_to_collection(export->collection.stream, export->vtk[i].name,
                              (double)export->frames.steps[i] * export->run.sim->dt);
    vtk_end_collection(export->collection.stream);
    return output_finish(&export->collection, status);
}

/* The scenario that gives these files again. A run that failed wrote frames of a plan for a longer run: they
 * are named one by one; if they are too many for that, the scenario is the one that fails. */
static Settings scenario_beside(const Export *export)
{
    Settings scenario = *export->settings;
    size_t n = export->next_frame, length = 0;
    problem_end_at(&scenario, export->run.sim->dt, export->run.last);
    if (export->planned_last == export->run.last ||
        (settings_output(&scenario)->frames < 2 && !*settings_output(export->settings)->at))
        return scenario;
    char at[LIST_MAX] = "";
    for (size_t i = 0; i < n; i++) {
        char text[NUMBER_TEXT_MAX];
        text_shortest(text, (double)export->frames.steps[i] * export->run.sim->dt);
        length += (size_t)snprintf(at + length, length < sizeof at ? sizeof at - length : 0, "%s%s",
                                   i > 0 ? "," : "", text);
        if (length >= sizeof at || n > TIMES_MAX)
            return *export->settings;
    }
    memcpy(settings_edit_output(&scenario)->at, at, length + 1);
    settings_edit_output(&scenario)->frames = 0;
    return scenario;
}

bool export_finish_files(Export *export, Status *status)
{
    Settings scenario = scenario_beside(export);
    bool good = !export->series.stream || output_finish(&export->series, status);
    good = good && write_beside(export, &scenario, &export->series_beside, NULL, status);
    for (int i = 0; good && i < TABLES; i++) {
        Table *table = &export->tables[i];
        if (table->name)
            good = output_finish(&table->file, status) &&
                   write_beside(export, &scenario, &table->beside, table, status);
    }
    return good && write_collection(export, status);
}

bool export_commit_files(Export *export, Status *status)
{
    bool good = output_commit(&export->series, status) && output_commit(&export->series_beside, status);
    for (int i = 0; good && i < TABLES; i++)
        good = output_commit(&export->tables[i].file, status) &&
               output_commit(&export->tables[i].beside, status);
    for (size_t i = 0; good && i < export->next_frame && export->vtk; i++)
        good = output_commit(&export->vtk[i], status);
    return good && output_commit(&export->collection, status);
}

void export_close_files(Export *export)
{
    output_close(&export->series);
    output_close(&export->series_beside);
    for (int i = 0; i < TABLES; i++) {
        output_close(&export->tables[i].file);
        output_close(&export->tables[i].beside);
    }
    for (size_t i = 0; export->vtk && i < export->frames.count; i++)
        output_close(&export->vtk[i]);
    output_close(&export->collection);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "export/crate.h"

#include "scenario/settings.h"
#include "base/output.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char file_name[] = "ro-crate-metadata.json";

Crate crate_of_run(const Outputs *outputs)
{
    return (Crate){
        .tables = {{outputs->series, "Series of the run: a row for each recorded time step"},
                   {outputs->particles, "Particles at some times of the run"},
                   {outputs->nodes, "Nodes of the grid at some times of the run"},
                   {outputs->bonds, "Bonds at some times of the run"}},
        .command = "matvib run",
        .source = "Scenario that made it: matvib run with this file writes the same bytes",
        .asker = outputs->asker,
        .force = outputs->force,
    };
}

static const char *base_name(const char *file)
{
    const char *slash = strrchr(file, '/');
    return slash ? slash + 1 : file;
}

/* The first table; NULL: there is none. */
static const char *first_file(const Crate *crate)
{
    for (int i = 0; i < CRATE_TABLES_MAX; i++)
        if (crate->tables[i].file)
            return crate->tables[i].file;
    return NULL;
}

/* The name of the metadata beside a table; free() it. */
static char *metadata_name(const char *table)
{
    char *name;
    const int folder = (int)(base_name(table) - table);
    return asprintf(&name, "%.*s%s", folder, table, file_name) < 0 ? NULL : name;
}

bool crate_may_begin(const Crate *crate, Status *status)
{
    const char *first = first_file(crate);
    if (!first)
        return status_refuse(status, "--crate: there is no table to describe (%s)",
                             strcmp(crate->command, "matvib run") == 0 ? "--series, ..." : "--output FILE");
    for (int i = 0; i < CRATE_TABLES_MAX; i++) {
        const char *file = crate->tables[i].file;
        if (file && output_is_direct(file))
            return status_refuse(status, "--crate: %.200s is no file that stays", file);
        if (file && (base_name(file) - file != base_name(first) - first ||
                     strncmp(file, first, (size_t)(base_name(first) - first)) != 0))
            return status_refuse(status, "--crate: %.200s lies in another folder than %.200s", file, first);
    }
    for (int i = 0; i < CRATE_TABLES_MAX; i++)
        if (crate->tables[i].file && strcmp(base_name(crate->tables[i].file), file_name) == 0)
            return status_refuse(status, "%s: is the name of the metadata that --crate writes",
                                 crate->tables[i].file);
    char *name = metadata_name(first);
    const bool may = name ? output_may_begin(name, crate->asker, crate->force, status)
                          : status_fail(status, "out of memory");
    free(name);
    return may;
}

static void put(FILE *stream, const char *text)
{
    text_put_json(stream, text, strlen(text));
}

/* The name of a table, or of the scenario beside it. */
static void put_name(FILE *stream, const char *table, bool beside)
{
    fputc('"', stream);
    text_put_escaped(stream, base_name(table), strlen(base_name(table)));
    fputs(beside ? ".ini\"" : "\"", stream);
}

static void put_reference(FILE *stream, const char *table, bool beside)
{
    fputs("{\"@id\": ", stream);
    put_name(stream, table, beside);
    fputc('}', stream);
}

/* All tables, and what stands beside them, parted by commas. */
static void put_references(FILE *stream, const Crate *crate, bool beside)
{
    bool first = true;
    for (int i = 0; i < CRATE_TABLES_MAX; i++)
        for (int k = 0; crate->tables[i].file && k <= (beside && crate->source); k++) {
            fputs(first ? "" : ", ", stream);
            put_reference(stream, crate->tables[i].file, k > 0);
            first = false;
        }
}

static void put_root(FILE *stream, const Crate *crate, const Settings *settings, const char *date)
{
    fputs("  {\n   \"@id\": \"./\",\n   \"@type\": \"Dataset\",\n   \"name\": ", stream);
    put(stream, *settings->title ? settings->title : settings->problem->title);
    fputs(",\n   \"description\": ", stream);
    put(stream, *settings->about ? settings->about : settings->problem->title);
    fprintf(
        stream,
        ",\n   \"datePublished\": \"%s\",\n   \"license\": \"not stated: it is for the author to choose\",\n"
        "   \"hasPart\": [",
        date);
    put_references(stream, crate, true);
    fputs("]\n  },\n", stream);
}

static void put_file(FILE *stream, const char *table, bool beside, const char *description,
                     const char *format)
{
    fputs("  {\n   \"@id\": ", stream);
    put_name(stream, table, beside);
    fputs(",\n   \"@type\": \"File\",\n   \"name\": ", stream);
    put_name(stream, table, beside);
    fprintf(stream, ",\n   \"description\": \"%s\",\n   \"encodingFormat\": \"%s\"\n  },\n", description,
            format);
}

/* How the tables came to be: the program made them of the scenario. */
static void put_action(FILE *stream, const Crate *crate)
{
    fprintf(stream,
            "  {\n   \"@id\": \"#run\",\n   \"@type\": \"CreateAction\",\n   \"name\": \"%s\",\n"
            "   \"instrument\": {\"@id\": \"#matvib\"},\n",
            crate->command);
    if (crate->source) {
        fputs("   \"object\": ", stream);
        put_reference(stream, first_file(crate), true);
        fputs(",\n", stream);
    }
    fputs("   \"result\": [", stream);
    put_references(stream, crate, false);
    fputs("]\n  },\n", stream);
}

static void put_crate(FILE *stream, const Crate *crate, const Settings *settings, const char *date)
{
    fprintf(stream,
            "{\n \"@context\": \"https://w3id.org/ro/crate/1.1/context\",\n \"@graph\": [\n"
            "  {\n   \"@id\": \"%s\",\n   \"@type\": \"CreativeWork\",\n"
            "   \"conformsTo\": {\"@id\": \"https://w3id.org/ro/crate/1.1\"},\n"
            "   \"about\": {\"@id\": \"./\"}\n  },\n",
            file_name);
    put_root(stream, crate, settings, date);
    for (int i = 0; i < CRATE_TABLES_MAX; i++) {
        const CrateTable *table = &crate->tables[i];
        if (table->file)
            put_file(stream, table->file, false, table->description, "text/csv");
        if (table->file && crate->source)
            put_file(stream, table->file, true, crate->source, "text/plain");
    }
    put_action(stream, crate);
    fputs("  {\n   \"@id\": \"#matvib\",\n   \"@type\": \"SoftwareApplication\",\n   \"name\": \"matvib\",\n"
          "   \"softwareVersion\": \"" PACKAGE_VERSION "\"\n  }\n ]\n}\n",
          stream);
}

bool crate_write(const Crate *crate, const Settings *settings, const char *date, Status *status)
{
    OutputFile file;
    char *name = metadata_name(first_file(crate));
    if (!name)
        return status_fail(status, "out of memory");
    bool sound = output_open(&file, crate->asker, name, crate->force, status);
    if (sound) {
        put_crate(file.stream, crate, settings, date);
        sound = output_end(&file, true, status);
    }
    free(name);
    return sound;
}

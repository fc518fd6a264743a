/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "lab/export/crate.h"

#include "base/output.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char file_name[] = "ro-crate-metadata.json";

/* A table that may be there, and what it holds. */
typedef struct Part {
    const char *file; /* FILE.ini, its scenario, stands beside it */
    const char *description;
} Part;

enum { PARTS = 4 };

static void list_parts(const Outputs *outputs, Part parts[PARTS])
{
    const char *const files[PARTS] = {outputs->series, outputs->particles, outputs->nodes, outputs->bonds};
    static const char *const holds[PARTS] = {
        "Series of the run: a row for each recorded time step", "Particles at some times of the run",
        "Nodes of the grid at some times of the run", "Bonds at some times of the run"};
    for (int i = 0; i < PARTS; i++)
        parts[i] = (Part){files[i], holds[i]};
}

static const char *base_name(const char *file)
{
    const char *slash = strrchr(file, '/');
    return slash ? slash + 1 : file;
}

/* The first table; NULL: there is none. */
static const char *first_file(const Part parts[PARTS])
{
    for (int i = 0; i < PARTS; i++)
        if (parts[i].file)
            return parts[i].file;
    return NULL;
}

/* The name of the metadata beside a table; free() it. */
static char *metadata_name(const char *table)
{
    char *name;
    const int folder = (int)(base_name(table) - table);
    return asprintf(&name, "%.*s%s", folder, table, file_name) < 0 ? NULL : name;
}

bool crate_may_begin(const Outputs *outputs, bool force, Status *status)
{
    Part parts[PARTS];
    list_parts(outputs, parts);
    const char *first = first_file(parts);
    if (!first || outputs->vtk)
        return status_fail(status, STATUS_USAGE, "--crate: %s",
                           first ? "describes tables, not --vtk"
                                 : "there is no table to describe (--series, ...)");
    for (int i = 0; i < PARTS; i++) {
        const char *file = parts[i].file;
        if (file && output_is_direct(file))
            return status_fail(status, STATUS_USAGE, "--crate: %.200s is no file that stays", file);
        if (file && (base_name(file) - file != base_name(first) - first ||
                     strncmp(file, first, (size_t)(base_name(first) - first)) != 0))
            return status_fail(status, STATUS_USAGE, "--crate: %.200s lies in another folder than %.200s",
                               file, first);
    }
    char *name = metadata_name(first);
    const bool may =
        name ? output_may_begin(name, force, status) : status_fail(status, STATUS_FAILED, "out of memory");
    free(name);
    return may;
}

static void put(FILE *stream, const char *text)
{
    text_put_json(stream, text, strlen(text));
}

/* {"@id": "NAME"}, with what is put behind the name. */
static void put_reference(FILE *stream, const char *name, const char *behind)
{
    char *whole;
    if (asprintf(&whole, "%s%s", name, behind) < 0)
        return;
    fputs("{\"@id\": ", stream);
    put(stream, whole);
    fputc('}', stream);
    free(whole);
}

static void put_root(FILE *stream, const Part parts[PARTS], const Settings *settings, const char *date)
{
    bool first = true;
    fputs("  {\n   \"@id\": \"./\",\n   \"@type\": \"Dataset\",\n   \"name\": ", stream);
    put(stream, *settings->title ? settings->title : settings->problem->title);
    fputs(",\n   \"description\": ", stream);
    put(stream, *settings->about ? settings->about : settings->problem->title);
    fprintf(
        stream,
        ",\n   \"datePublished\": \"%s\",\n   \"license\": \"not stated: it is for the author to choose\",\n"
        "   \"hasPart\": [",
        date);
    for (int i = 0; i < PARTS; i++)
        if (parts[i].file)
            for (int k = 0; k < 2; k++) {
                fputs(first ? "" : ", ", stream);
                put_reference(stream, base_name(parts[i].file), k ? ".ini" : "");
                first = false;
            }
    fputs("]\n  },\n", stream);
}

static void put_file(FILE *stream, const char *name, const char *behind, const char *description,
                     const char *format)
{
    char *whole;
    if (asprintf(&whole, "%s%s", name, behind) < 0)
        return;
    fputs("  {\n   \"@id\": ", stream);
    put(stream, whole);
    fputs(",\n   \"@type\": \"File\",\n   \"name\": ", stream);
    put(stream, whole);
    fprintf(stream, ",\n   \"description\": \"%s\",\n   \"encodingFormat\": \"%s\"\n  },\n", description,
            format);
    free(whole);
}

/* How the tables came to be: the program made them of the scenario. */
static void put_action(FILE *stream, const Part parts[PARTS])
{
    bool first = true;
    fputs("  {\n   \"@id\": \"#run\",\n   \"@type\": \"CreateAction\",\n   \"name\": \"matvib run\",\n"
          "   \"instrument\": {\"@id\": \"#matvib\"},\n   \"object\": ",
          stream);
    put_reference(stream, base_name(first_file(parts)), ".ini");
    fputs(",\n   \"result\": [", stream);
    for (int i = 0; i < PARTS; i++)
        if (parts[i].file) {
            fputs(first ? "" : ", ", stream);
            put_reference(stream, base_name(parts[i].file), "");
            first = false;
        }
    fputs("]\n  },\n", stream);
}

static void put_crate(FILE *stream, const Part parts[PARTS], const Settings *settings, const char *date)
{
    fprintf(stream,
            "{\n \"@context\": \"https://w3id.org/ro/crate/1.1/context\",\n \"@graph\": [\n"
            "  {\n   \"@id\": \"%s\",\n   \"@type\": \"CreativeWork\",\n"
            "   \"conformsTo\": {\"@id\": \"https://w3id.org/ro/crate/1.1\"},\n"
            "   \"about\": {\"@id\": \"./\"}\n  },\n",
            file_name);
    put_root(stream, parts, settings, date);
    for (int i = 0; i < PARTS; i++)
        if (parts[i].file) {
            put_file(stream, base_name(parts[i].file), "", parts[i].description, "text/csv");
            put_file(stream, base_name(parts[i].file), ".ini",
                     "Scenario that made it: matvib run with this file writes the same bytes", "text/plain");
        }
    put_action(stream, parts);
    fputs("  {\n   \"@id\": \"#matvib\",\n   \"@type\": \"SoftwareApplication\",\n   \"name\": \"matvib\",\n"
          "   \"softwareVersion\": \"" PACKAGE_VERSION "\"\n  }\n ]\n}\n",
          stream);
}

bool crate_write(const Outputs *outputs, const Settings *settings, const char *date, Status *status)
{
    Part parts[PARTS];
    OutputFile file;
    list_parts(outputs, parts);
    char *name = metadata_name(first_file(parts));
    if (!name)
        return status_fail(status, STATUS_FAILED, "out of memory");
    bool sound = output_open(&file, outputs->asker, name, outputs->force, status);
    if (sound) {
        put_crate(file.stream, parts, settings, date);
        sound = output_finish(&file, status) && output_commit(&file, status);
        output_close(&file);
    }
    free(name);
    return sound;
}

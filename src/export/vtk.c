/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes .vtu and .pvd files (export.h) as XML, numbers as in CSV or as they are in memory. Nothing is kept
 * between frames. */
#include "export/export.h"
#include "base/text.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

static int base_length(const char *name)
{
    size_t n = strlen(name);
    bool known = n > 4 && (strcmp(name + n - 4, ".vtu") == 0 || strcmp(name + n - 4, ".pvd") == 0);
    return (int)(known ? n - 4 : n);
}

char *vtk_frame_name(const char *name, size_t i, size_t count)
{
    char *out;
    int made = count > 1 ? asprintf(&out, "%.*s-%04zu.vtu", base_length(name), name, i)
                         : asprintf(&out, "%.*s.vtu", base_length(name), name);
    return made < 0 ? NULL : out;
}

char *vtk_collection_name(const char *name)
{
    char *out;
    return asprintf(&out, "%.*s.pvd", base_length(name), name) < 0 ? NULL : out;
}

/* --- a frame: its arrays, one after the other ---------------------------------------------------- */

/* Where an array is in the frame, and how its numbers are written. */
typedef struct Writer {
    FILE *stream;
    const Simulation *sim;
    VtkData data;
    bool in_tail;    /* the second time, of raw data: the numbers alone */
    uint64_t offset; /* of the next array among the raw data */
    double *values[SIMULATION_DIMENSIONS_MAX];
} Writer;

/* The head of an array of `bytes` bytes. Whether numbers follow. */
static bool begin_array(Writer *writer, const char *type, const char *name, int components, uint64_t bytes)
{
    if (writer->in_tail) {
        fwrite(&bytes, sizeof bytes, 1, writer->stream);
        return true;
    }
    fprintf(writer->stream, "<DataArray type=\"%s\" Name=\"%s\"", type, name);
    if (components > 1)
        fprintf(writer->stream, " NumberOfComponents=\"%d\"", components);
    if (writer->data == VTK_TEXT) {
        fputs(" format=\"ascii\">\n", writer->stream);
        return true;
    }
    fprintf(writer->stream, " format=\"appended\" offset=\"%" PRIu64 "\"/>\n", writer->offset);
    writer->offset += sizeof bytes + bytes;
    return false;
}

static void end_array(const Writer *writer)
{
    if (writer->data == VTK_TEXT)
        fputs("</DataArray>\n", writer->stream);
}

/* Up to three components of each point; absent ones are 0. */
static void write_array(Writer *writer, const char *name, const double *const *components, int n)
{
    const size_t count = writer->sim->counts[0];
    if (!begin_array(writer, "Float64", name, n, count * (size_t)n * sizeof(double)))
        return;
    for (size_t k = 0; k < count; k++)
        for (int c = 0; c < n; c++) {
            char text[NUMBER_TEXT_MAX];
            const double value = components[c] ? components[c][k] : 0;
            if (writer->data == VTK_RAW) {
                fwrite(&value, sizeof value, 1, writer->stream);
            } else {
                fwrite(text, 1, text_shortest(text, value), writer->stream);
                fputc(c + 1 < n ? ' ' : '\n', writer->stream);
            }
        }
    end_array(writer);
}

static void write_vector(Writer *writer, const char *name, const int *fields)
{
    const Simulation *sim = writer->sim;
    const double *components[3] = {NULL, NULL, NULL};
    for (int d = 0; d < sim->dimensions; d++) {
        sim->method->field(sim, fields[d], 0, sim->counts[0], writer->values[d]);
        components[d] = writer->values[d];
    }
    write_array(writer, name, components, 3);
}

/* Cell k has point k alone: k itself, and the end k + 1 of its list. */
static void write_indices(Writer *writer, const char *name, size_t first)
{
    const size_t count = writer->sim->counts[0];
    if (!begin_array(writer, "Int64", name, 1, count * sizeof(int64_t)))
        return;
    for (size_t k = 0; k < count; k++) {
        const int64_t index = (int64_t)(k + first);
        if (writer->data == VTK_RAW)
            fwrite(&index, sizeof index, 1, writer->stream);
        else
            fprintf(writer->stream, "%" PRId64 "\n", index);
    }
    end_array(writer);
}

static void write_types(Writer *writer)
{
    enum { VERTEX = 1 };
    const size_t count = writer->sim->counts[0];
    if (!begin_array(writer, "UInt8", "types", 1, count))
        return;
    for (size_t k = 0; k < count; k++)
        if (writer->data == VTK_RAW)
            fputc(VERTEX, writer->stream);
        else
            fprintf(writer->stream, "%d\n", VERTEX);
    end_array(writer);
}

static bool is_in_vector(const Simulation *sim, int field)
{
    for (int d = 0; d < sim->dimensions; d++)
        if (field == sim->position[d] || field == sim->displacement[d] || field == sim->velocity[d])
            return true;
    return false;
}

/* A word of the frame, which the raw data do not have. */
static void write_tag(const Writer *writer, const char *tag)
{
    if (!writer->in_tail)
        fputs(tag, writer->stream);
}

/* All arrays, in the order in which they stand: once, and for raw data once more. */
static void write_arrays(Writer *writer)
{
    const Simulation *sim = writer->sim;
    write_tag(writer, "<Points>\n");
    write_vector(writer, "position", sim->position);
    write_tag(writer, "</Points>\n<Cells>\n");
    write_indices(writer, "connectivity", 0);
    write_indices(writer, "offsets", 1);
    write_types(writer);
    write_tag(writer, "</Cells>\n<PointData>\n");
    write_vector(writer, "displacement", sim->displacement);
    write_vector(writer, "velocity", sim->velocity);
    for (int f = 0; f < sim->n_fields; f++) {
        const Field *field = &sim->fields[f];
        if (field->set != 0 || !field->in_table || is_in_vector(sim, f))
            continue;
        sim->method->field(sim, f, 0, sim->counts[0], writer->values[0]);
        write_array(writer, field->quantity.name, (const double *const[]){writer->values[0]}, 1);
    }
    write_tag(writer, "</PointData>\n");
}

bool vtk_write_frame(FILE *stream, const Simulation *sim, VtkData data)
{
    const size_t count = sim->counts[0];
    const uint16_t one = 1;
    Writer writer = {.stream = stream, .sim = sim, .data = data};
    bool enough = true;
    for (int d = 0; d < SIMULATION_DIMENSIONS_MAX; d++) {
        writer.values[d] = malloc((count + 1) * sizeof(double));
        enough = enough && writer.values[d];
    }
    if (enough) {
        fprintf(stream,
                "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                "byte_order=\"%s\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
                "<Piece NumberOfPoints=\"%zu\" NumberOfCells=\"%zu\">\n",
                *(const unsigned char *)&one == 1 ? "LittleEndian" : "BigEndian", count, count);
        write_arrays(&writer);
        fputs("</Piece>\n</UnstructuredGrid>\n", stream);
        if (data == VTK_RAW) {
            writer.in_tail = true;
            fputs("<AppendedData encoding=\"raw\">\n_", stream);
            write_arrays(&writer);
            fputs("\n</AppendedData>\n", stream);
        }
        fputs("</VTKFile>\n", stream);
    }
    for (int d = 0; d < SIMULATION_DIMENSIONS_MAX; d++)
        free(writer.values[d]);
    return enough;
}

void vtk_begin_collection(FILE *stream)
{
    fputs("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n", stream);
}

/* ParaView looks for frames beside the collection. XML's own signs in a name are written as it wants them. */
void vtk_add_to_collection(FILE *stream, const char *frame_name, double time)
{
    const char *slash = strrchr(frame_name, '/');
    char text[NUMBER_TEXT_MAX];
    text_shortest(text, time);
    fprintf(stream, "<DataSet timestep=\"%s\" part=\"0\" file=\"", text);
    text_put_xml(stream, slash ? slash + 1 : frame_name);
    fputs("\"/>\n", stream);
}

void vtk_end_collection(FILE *stream)
{
    fputs("</Collection>\n</VTKFile>\n", stream);
}

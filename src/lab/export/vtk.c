/* Writes .vtu and .pvd files (vtk.h) as XML text, numbers as in CSV. Nothing is kept between frames. */
#include "lab/export/vtk.h"
#include "base/text.h"

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

/* Up to three components of `count` points; absent ones are 0. */
static void write_numbers(FILE *stream, const double *const *components, int n, size_t count)
{
    char text[NUMBER_TEXT_MAX];
    for (size_t k = 0; k < count; k++) {
        for (int c = 0; c < n; c++) {
            size_t length = text_shortest(text, components[c] ? components[c][k] : 0);
            fwrite(text, 1, length, stream);
            fputc(c + 1 < n ? ' ' : '\n', stream);
        }
    }
}

typedef struct Arrays {
    const Simulation *sim;
    double *values[SIMULATION_DIMENSIONS_MAX];
} Arrays;

static void write_vector(FILE *stream, const Arrays *arrays, const char *name, const int *fields)
{
    const Simulation *sim = arrays->sim;
    const double *components[3] = {NULL, NULL, NULL};
    for (int d = 0; d < sim->dimensions; d++) {
        sim->method->field(sim, fields[d], 0, sim->counts[0], arrays->values[d]);
        components[d] = arrays->values[d];
    }
    fprintf(stream, "<DataArray type=\"Float64\" Name=\"%s\" NumberOfComponents=\"3\" format=\"ascii\">\n",
            name);
    write_numbers(stream, components, 3, sim->counts[0]);
    fputs("</DataArray>\n", stream);
}

static bool is_in_vector(const Simulation *sim, int field)
{
    for (int d = 0; d < sim->dimensions; d++)
        if (field == sim->position[d] || field == sim->displacement[d] || field == sim->velocity[d])
            return true;
    return false;
}

static void write_cells(FILE *stream, size_t count)
{
    static const char *const names[] = {"connectivity", "offsets"};
    fputs("<Cells>\n", stream);
    for (size_t first = 0; first < 2; first++) {
        fprintf(stream, "<DataArray type=\"Int64\" Name=\"%s\" format=\"ascii\">\n", names[first]);
        for (size_t k = 0; k < count; k++)
            fprintf(stream, "%zu\n", k + first);
        fputs("</DataArray>\n", stream);
    }
    fputs("<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n", stream);
    for (size_t k = 0; k < count; k++)
        fputs("1\n", stream);
    fputs("</DataArray>\n</Cells>\n", stream);
}

bool vtk_write_frame(FILE *stream, const Simulation *sim)
{
    size_t count = sim->counts[0];
    Arrays arrays = {.sim = sim};
    bool enough = true;
    for (int d = 0; d < SIMULATION_DIMENSIONS_MAX; d++) {
        arrays.values[d] = malloc((count + 1) * sizeof(double));
        enough = enough && arrays.values[d];
    }
    if (enough) {
        fprintf(stream,
                "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
                "<Piece NumberOfPoints=\"%zu\" NumberOfCells=\"%zu\">\n<Points>\n",
                count, count);
        write_vector(stream, &arrays, "position", sim->position);
        fputs("</Points>\n", stream);
        write_cells(stream, count);
        fputs("<PointData>\n", stream);
        write_vector(stream, &arrays, "displacement", sim->displacement);
        write_vector(stream, &arrays, "velocity", sim->velocity);
        for (int f = 0; f < sim->n_fields; f++) {
            const Field *field = &sim->fields[f];
            if (field->set != 0 || !field->in_table || is_in_vector(sim, f))
                continue;
            sim->method->field(sim, f, 0, count, arrays.values[0]);
            fprintf(stream, "<DataArray type=\"Float64\" Name=\"%s\" format=\"ascii\">\n",
                    field->quantity.name);
            write_numbers(stream, (const double *const[]){arrays.values[0]}, 1, count);
            fputs("</DataArray>\n", stream);
        }
        fputs("</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n", stream);
    }
    for (int d = 0; d < SIMULATION_DIMENSIONS_MAX; d++)
        free(arrays.values[d]);
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

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "plate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NODES };
enum { F_X0, F_Y0, F_UX, F_UY, F_VX, F_VY, F_FORCE, F_HELD, N_FIELDS };
enum { STAGE_KICK, STAGE_DRIFT, STAGE_FORCE, STAGE_KICK_AGAIN, N_STAGES };

static const double pi = 3.14159265358979323846;

/* The state: three arrays of one block, and one live number before them. */
typedef struct Plate {
    Simulation sim;
    int columns, rows;
    long fails_at;
    size_t nodes;
    double *state;
    double *tension, *u, *v, *force;
} Plate;

static const Set sets[] = {{"particle", "particles", 0}};

#define ROW(name, label, unit, meaning, table, whole)                                                        \
    {                                                                                                        \
        {name, label, unit, meaning}, NODES, table, whole, 0, 0                                              \
    }
static const Field fields[N_FIELDS] = {
    [F_X0] = ROW("x0", "x0", "length", "column of the node", true, false),
    [F_Y0] = ROW("y0", "y0", "length", "row of the node", true, false),
    [F_UX] = ROW("ux", "ux", "length", "always 0", true, false),
    [F_UY] = ROW("uy", "uy", "length", "displacement", true, false),
    [F_VX] = ROW("vx", "vx", "length/time", "always 0", true, false),
    [F_VY] = ROW("vy", "vy", "length/time", "velocity", true, false),
    [F_FORCE] = ROW("force", "force", "force", "pull of the four neighbours", false, false),
    [F_HELD] = ROW("held", "held", "1", "1: a node of the rim", false, true),
};

static const Quantity series[] = {
    {"u_middle", "u", "length", "displacement of the middle node"},
    {"kinetic", "kinetic", "energy", "kinetic energy"},
    {"strain", "strain", "energy", "energy of the links"},
    {"total", "total", "energy", "their sum"},
};

static const Stage stages[N_STAGES] = {
    {"kick", "half kick", "v += dt/2 f", "", "Half of the force's pull.", "force", "vy"},
    {"drift", "drift", "u += dt v", "", "Nodes move.", "vy", "uy"},
    {"force", "force", "f = Σ (u' - u)", "", "Neighbours pull.", "uy", "force"},
    {"kick2", "half kick", "v += dt/2 f", "", "The other half.", "force", "vy"},
};

static bool is_held(const Plate *plate, int i, int j)
{
    return i == 0 || j == 0 || i == plate->columns - 1 || j == plate->rows - 1;
}

static size_t at(const Plate *plate, int i, int j)
{
    return (size_t)j * (size_t)plate->columns + (size_t)i;
}

static double pull(const Plate *plate, int i, int j)
{
    size_t here = at(plate, i, j), up = (size_t)plate->columns;
    const double *u = plate->u;
    return is_held(plate, i, j)
               ? 0
               : *plate->tension * (u[here - 1] + u[here + 1] + u[here - up] + u[here + up] - 4 * u[here]);
}

static bool stage(Simulation *sim, int which, size_t first, size_t end, Status *status)
{
    Plate *plate = (Plate *)sim;
    if (plate->fails_at > 0 && sim->step + 1 >= plate->fails_at && which == STAGE_FORCE)
        return simulation_fail(sim, status, "the plate tears in step %ld, t = %g", sim->step + 1,
                               (double)(sim->step + 1) * sim->dt);
    for (size_t k = at(plate, 0, (int)first); k < at(plate, 0, (int)end); k++) {
        int i = (int)(k % (size_t)plate->columns), j = (int)(k / (size_t)plate->columns);
        if (which == STAGE_DRIFT)
            plate->u[k] += sim->dt * plate->v[k];
        else if (which == STAGE_FORCE)
            plate->force[k] = pull(plate, i, j);
        else
            plate->v[k] += sim->dt / 2 * plate->force[k];
    }
    return true;
}

static void row(Simulation *sim, double *out)
{
    const Plate *plate = (const Plate *)sim;
    double kinetic = 0, strain = 0;
    for (int j = 0; j < plate->rows; j++)
        for (int i = 0; i < plate->columns; i++) {
            size_t k = at(plate, i, j);
            kinetic += plate->v[k] * plate->v[k] / 2;
            double right = i + 1 < plate->columns ? plate->u[k + 1] - plate->u[k] : 0;
            double above = j + 1 < plate->rows ? plate->u[k + (size_t)plate->columns] - plate->u[k] : 0;
            strain += *plate->tension * (right * right + above * above) / 2;
        }
    out[0] = plate->u[at(plate, plate->columns / 2, plate->rows / 2)];
    out[1] = kinetic;
    out[2] = strain;
    out[3] = kinetic + strain;
}

static void field(const Simulation *sim, int which, size_t first, size_t count, double *out)
{
    const Plate *plate = (const Plate *)sim;
    for (size_t n = 0; n < count; n++) {
        size_t k = first + n;
        int i = (int)(k % (size_t)plate->columns), j = (int)(k / (size_t)plate->columns);
        const double values[N_FIELDS] = {[F_X0] = i,
                                         [F_Y0] = j,
                                         [F_UX] = 0,
                                         [F_UY] = plate->u[k],
                                         [F_VX] = 0,
                                         [F_VY] = plate->v[k],
                                         [F_FORCE] = plate->force[k],
                                         [F_HELD] = is_held(plate, i, j)};
        out[n] = values[which];
    }
}

static size_t links(const Simulation *sim, int set, size_t index, Link *out, size_t max)
{
    const Plate *plate = (const Plate *)sim;
    int i = (int)(index % (size_t)plate->columns), j = (int)(index / (size_t)plate->columns);
    static const int beside[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    size_t count = 0;
    for (int b = 0; b < 4; b++) {
        int p = i + beside[b][0], q = j + beside[b][1];
        if (p < 0 || q < 0 || p >= plate->columns || q >= plate->rows)
            continue;
        if (count < max)
            out[count] = (Link){.set = set,
                                .index = at(plate, p, q),
                                .stretch = 1,
                                .stiffness = plate->u[at(plate, p, q)] - plate->u[index]};
        count++;
    }
    return count;
}

static void explain(const Simulation *sim, int which, int set, size_t index, const void *before, int terms,
                    char *out, size_t size)
{
    (void)set, (void)before, (void)terms;
    snprintf(out, size, "node %zu after %s", index, sim->stages[which].name);
}

static size_t state_size(const Simulation *sim)
{
    return (1 + 3 * ((const Plate *)sim)->nodes) * sizeof(double);
}

static void load(Simulation *sim, const void *bytes)
{
    memcpy(((Plate *)sim)->state, bytes, state_size(sim));
}

static bool change(Simulation *sim, const char *key, double value, Status *status)
{
    if (strcmp(key, "plate.tension") != 0 || !(value > 0))
        return status_refuse(status, "%s: cannot change in mid-run", key);
    *((Plate *)sim)->tension = value;
    return true;
}

static void destroy(Simulation *sim)
{
    free(((Plate *)sim)->state);
    free(sim);
}

static const Method method = {
    .name = "plate",
    .title = "membrane on a lattice",
    .destroy = destroy,
    .stage = stage,
    .row = row,
    .field = field,
    .links = links,
    .explain = explain,
    .state_size = state_size,
    .load = load,
    .change = change,
};

static double shape(const Plate *plate, int i, int j)
{
    return is_held(plate, i, j) ? 0 : sin(pi * i / (plate->columns - 1)) * sin(pi * j / (plate->rows - 1));
}

Simulation *plate_create(int columns, int rows, long fails_at)
{
    Plate *plate = calloc(1, sizeof *plate);
    if (!plate)
        return NULL;
    plate->columns = columns;
    plate->rows = rows;
    plate->fails_at = fails_at;
    plate->nodes = (size_t)columns * (size_t)rows;
    plate->state = calloc(1 + 3 * plate->nodes, sizeof(double));
    if (!plate->state) {
        free(plate);
        return NULL;
    }
    plate->tension = plate->state;
    plate->u = plate->state + 1;
    plate->v = plate->u + plate->nodes;
    plate->force = plate->v + plate->nodes;
    *plate->tension = 1;
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++)
            plate->u[at(plate, i, j)] = shape(plate, i, j);
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++)
            plate->force[at(plate, i, j)] = pull(plate, i, j);
    plate->sim = (Simulation){
        .method = &method,
        .state = plate->state,
        .stages = stages,
        .n_stages = N_STAGES,
        .stage_items = (size_t)rows,
        .sets = sets,
        .n_sets = 1,
        .counts = {plate->nodes},
        .fields = fields,
        .n_fields = N_FIELDS,
        .series = series,
        .n_series = (int)(sizeof series / sizeof *series),
        .has = HAS_PLANE | HAS_BONDS,
        .columns = (size_t)columns,
        .rows = (size_t)rows,
        .spacing = 1,
        .dimensions = 2,
        .position = {F_X0, F_Y0},
        .displacement = {F_UX, F_UY},
        .velocity = {F_VX, F_VY},
        .dt = 0.5,
    };
    return &plate->sim;
}

/* A mode is an eigenvector of the four neighbours; velocity Verlet turns its angle by
 * 2 asin(dt omega / 2) in a step. */
double plate_frequency(int columns, int rows, double dt)
{
    double a = sin(pi / 2 / (columns - 1)), b = sin(pi / 2 / (rows - 1));
    double omega = 2 * sqrt(a * a + b * b);
    return 2 * asin(dt * omega / 2) / dt;
}

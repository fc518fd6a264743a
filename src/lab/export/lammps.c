/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes a beam as input for LAMMPS (lammps.h). The beam is built as for a run and read back through
 * method.h: nodes, bonds, supports, loads. The notch is the hard part: peri/pmb cuts bonds by types of
 * atoms only, so nodes with the same cut bonds share a type, and pairs of types are excluded. */
#include "lab/export/lammps.h"

#include "base/text.h"
#include "lab/settings/parameters.h"
#include "lab/problems/references.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { TYPES_MAX = 256, PRINT_ROWS = 1000 };

/* What becomes of a node at the notch. */
typedef enum Side { SIDE_NONE, SIDE_LEFT, SIDE_RIGHT } Side;

/* The beam at t = 0 in arrays over its nodes. */
typedef struct Nodes {
    const Simulation *sim;
    const Settings *settings;
    size_t count, n_bonds;
    double *x, *y, *ux, *uy;
    double *held, *loaded, *protected_node, *probe;
    double *bond_i, *bond_j, *cut;
    int *type;   /* of an atom, from 1 */
    Side *side;  /* only nodes with cut bonds have one */
    bool *whole; /* all bonds of the node to the other side are cut */
    int n_types;
    bool type_protected[TYPES_MAX + 1];
    size_t type_node[TYPES_MAX + 1]; /* one node of that type; the only one unless its class is whole */
} Nodes;

static double *read_field(const Nodes *nodes, int set, const char *name)
{
    const Simulation *sim = nodes->sim;
    double *values = malloc((sim->counts[set] + 1) * sizeof *values);
    if (values)
        sim->method->field(sim, simulation_find_field(sim, set, name), 0, sim->counts[set], values);
    return values;
}

static void free_nodes(Nodes *nodes)
{
    double *arrays[] = {nodes->x,
                        nodes->y,
                        nodes->ux,
                        nodes->uy,
                        nodes->held,
                        nodes->loaded,
                        nodes->protected_node,
                        nodes->probe,
                        nodes->bond_i,
                        nodes->bond_j,
                        nodes->cut};
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++)
        free(arrays[k]);
    free(nodes->type);
    free(nodes->side);
    free(nodes->whole);
}

static bool read_nodes(Nodes *nodes, Status *status)
{
    struct {
        double **array;
        int set;
        const char *name;
    } wanted[] = {{&nodes->x, 0, "x0"},        {&nodes->y, 0, "y0"},
                  {&nodes->ux, 0, "ux"},       {&nodes->uy, 0, "uy"},
                  {&nodes->held, 0, "held"},   {&nodes->loaded, 0, "loaded"},
                  {&nodes->probe, 0, "probe"}, {&nodes->protected_node, 0, "protected"},
                  {&nodes->bond_i, 1, "i"},    {&nodes->bond_j, 1, "j"},
                  {&nodes->cut, 1, "notch"}};
    nodes->count = nodes->sim->counts[0];
    nodes->n_bonds = nodes->sim->counts[1];
    bool enough = true;
    for (size_t k = 0; k < sizeof wanted / sizeof *wanted; k++) {
        *wanted[k].array = read_field(nodes, wanted[k].set, wanted[k].name);
        enough = enough && *wanted[k].array;
    }
    nodes->type = calloc(nodes->count, sizeof *nodes->type);
    nodes->side = calloc(nodes->count, sizeof *nodes->side);
    nodes->whole = calloc(nodes->count, sizeof *nodes->whole);
    if (!enough || !nodes->type || !nodes->side || !nodes->whole)
        return status_fail(status, STATUS_FAILED, "not enough memory for %zu nodes", nodes->count);
    return true;
}

/* --- the notch as types of atoms --- */

/* A type for the nodes that are alike; those whose bonds are cut in part have one each. */
static int new_type(Nodes *nodes, size_t node)
{
    if (nodes->n_types == TYPES_MAX)
        return 0;
    nodes->type_protected[++nodes->n_types] = nodes->protected_node[node] != 0;
    nodes->type_node[nodes->n_types] = node;
    return nodes->n_types;
}

static bool set_types(Nodes *nodes, Status *status)
{
    double notch = nodes->settings->notch.position;
    int common[2][3] = {{0}}; /* protected or not; no side, left, right */
    for (size_t b = 0; b < nodes->n_bonds; b++) {
        size_t ends[2] = {(size_t)nodes->bond_i[b], (size_t)nodes->bond_j[b]};
        for (int e = 0; e < 2 && nodes->cut[b] != 0; e++) {
            nodes->side[ends[e]] = nodes->x[ends[e]] < nodes->x[ends[1 - e]] ? SIDE_LEFT : SIDE_RIGHT;
            nodes->whole[ends[e]] = true;
        }
    }
    for (size_t b = 0; b < nodes->n_bonds; b++) {
        size_t i = (size_t)nodes->bond_i[b], j = (size_t)nodes->bond_j[b];
        double tolerance = 1e-6 * nodes->settings->lattice.spacing;
        bool across = (nodes->x[i] - notch < -tolerance) != (nodes->x[j] - notch < -tolerance);
        if (across && nodes->cut[b] == 0)
            nodes->whole[i] = nodes->whole[j] = false;
    }
    for (size_t node = 0; node < nodes->count; node++) {
        int *shared = nodes->side[node] == SIDE_NONE || nodes->whole[node]
                          ? &common[nodes->protected_node[node] != 0][nodes->side[node]]
                          : NULL;
        int type = shared && *shared ? *shared : new_type(nodes, node);
        if (type == 0)
            return status_fail(status, STATUS_FAILED, "notch: its end needs more than %d types of atoms",
                               TYPES_MAX);
        if (shared)
            *shared = type;
        nodes->type[node] = type;
    }
    return true;
}

static bool is_cut(const Nodes *nodes, size_t a, size_t b)
{
    for (size_t k = 0; k < nodes->n_bonds; k++) {
        size_t i = (size_t)nodes->bond_i[k], j = (size_t)nodes->bond_j[k];
        if (nodes->cut[k] != 0 && ((i == a && j == b) || (i == b && j == a)))
            return true;
    }
    return false;
}

/* Pairs of types between which there are no bonds from the start. */
static void write_notch(FILE *file, const Nodes *nodes)
{
    for (int a = 1; a <= nodes->n_types; a++)
        for (int b = a + 1; b <= nodes->n_types; b++) {
            size_t one = nodes->type_node[a], other = nodes->type_node[b];
            if (nodes->side[one] == SIDE_NONE || nodes->side[other] == SIDE_NONE ||
                nodes->side[one] == nodes->side[other])
                continue;
            if (nodes->whole[one] || nodes->whole[other] || is_cut(nodes, one, other))
                fprintf(file, "neigh_modify exclude type %d %d\n", a, b);
        }
}

/* --- the files --- */

/* A line with numbers in their shortest text: each '@' is the next of them. */
static void line(FILE *file, const char *pattern, const double *numbers)
{
    char text[NUMBER_TEXT_MAX];
    for (const char *c = pattern; *c; c++) {
        if (*c != '@') {
            fputc(*c, file);
            continue;
        }
        text_shortest(text, *numbers++);
        fputs(text, file);
    }
}

#define LINE(file, pattern, ...) line(file, pattern, (const double[]){__VA_ARGS__})

static void write_data(FILE *file, const Nodes *nodes)
{
    double dx = nodes->settings->lattice.spacing, least[2] = {HUGE_VAL, HUGE_VAL},
           most[2] = {-HUGE_VAL, -HUGE_VAL};
    for (size_t k = 0; k < nodes->count; k++) {
        const double place[2] = {nodes->x[k], nodes->y[k]};
        for (int d = 0; d < 2; d++) {
            least[d] = fmin(least[d], place[d]);
            most[d] = fmax(most[d], place[d]);
        }
    }
    fprintf(file, "%s\n\n%zu atoms\n%d atom types\n\n",
            *nodes->settings->title ? nodes->settings->title : nodes->settings->problem->word, nodes->count,
            nodes->n_types);
    LINE(file, "@ @ xlo xhi\n@ @ ylo yhi\n@ @ zlo zhi\n\nAtoms # peri: id type volume density x y z\n\n",
         least[0] - dx / 2, most[0] + dx / 2, least[1] - dx / 2, most[1] + dx / 2, -dx / 2, dx / 2);
    for (size_t k = 0; k < nodes->count; k++) {
        fprintf(file, "%zu %d ", k + 1, nodes->type[k]);
        LINE(file, "@ @ @ @ 0\n", dx * dx * dx, nodes->settings->material.density, nodes->x[k], nodes->y[k]);
    }
}

static void write_displacement(FILE *file, const Nodes *nodes, const double *u)
{
    fprintf(file, "%zu\n", nodes->count);
    for (size_t k = 0; k < nodes->count; k++) {
        fprintf(file, "%zu ", k + 1);
        LINE(file, "@\n", u[k]);
    }
}

static bool starts_bent(const Nodes *nodes)
{
    for (size_t k = 0; k < nodes->count; k++)
        if (nodes->ux[k] != 0 || nodes->uy[k] != 0)
            return true;
    return false;
}

static void write_head(FILE *file, const Nodes *nodes)
{
    const Settings *settings = nodes->settings;
    fprintf(file, "# %s\n# Written by matvib " PACKAGE_VERSION "; run it with: lmp -in in.matvib\n#\n",
            *settings->title ? settings->title : settings->problem->title);
    fputs("# What differs from matvib's own run of this scenario:\n", file);
    if (settings->lattice.surface_correction != SURFACE_NONE)
        fputs("# - there is no surface correction, so the skin is soft; compare with\n"
              "#   pd.surface_correction=none\n",
              file);
    if (settings->lattice.volume_correction != VOLUME_PARTIAL)
        fputs("# - volumes near the horizon count in part; compare with pd.volume_correction=partial\n",
              file);
    fputs("# - a bond that reaches the critical stretch still pulls once and breaks before the next step\n"
          "# - nodes without a bond push each other away when they come very close (short-range forces)\n",
          file);
    if (settings->bonds.protected_depth > 0 && (settings->problem->concerns & CONCERN_NOTCH))
        fputs("# - LAMMPS of May 2026 and before breaks the bonds of a node by the largest critical stretch "
              "among\n"
              "#   them, so that the zone that never breaks reaches up to one horizon further; since June "
              "2026\n"
              "#   each bond breaks by its own, as here\n",
              file);
    fputs("# - the volume of a node is dx^3 where matvib has dx^2 and unit thickness; the micromodulus is "
          "that\n"
          "#   of the two-dimensional model over dx, so forces per volume are the same\n\n",
          file);
}

static double derived(const Nodes *nodes, const char *name)
{
    Derived numbers[DERIVED_MAX];
    int count = problem_derived(nodes->settings, nodes->sim, numbers);
    for (int k = 0; k < count; k++)
        if (strcmp(numbers[k].name, name) == 0)
            return numbers[k].value;
    return NAN;
}

static void write_pairs(FILE *file, const Nodes *nodes)
{
    const Lattice *lattice = &nodes->settings->lattice;
    const double critical = nodes->settings->bonds.critical_stretch;
    double micromodulus = derived(nodes, "micromodulus");
    /* the last bonds of a family end at the horizon but for the rounding of positions */
    double horizon = lattice->horizon * (1 + 1e-9), never = 1e9;
    double breaks = critical > 0 ? critical : never;
    LINE(file, "pair_style peri/pmb\npair_coeff * * @ @ @ 0\n", micromodulus / lattice->spacing, horizon,
         breaks);
    for (int a = 1; a <= nodes->n_types && critical > 0; a++)
        for (int b = a; b <= nodes->n_types; b++)
            if (nodes->type_protected[a] || nodes->type_protected[b]) {
                fprintf(file, "pair_coeff %d %d ", a, b);
                LINE(file, "@ @ @ 0\n", micromodulus / lattice->spacing, horizon, never);
            }
}

/* "group NAME id 1 2 3" for the nodes that fit; false: there are none. */
static bool write_group(FILE *file, const Nodes *nodes, const char *name,
                        bool fits(const Nodes *, size_t node))
{
    bool any = false;
    for (size_t k = 0; k < nodes->count; k++)
        if (fits(nodes, k)) {
            if (!any)
                fprintf(file, "group %s id", name);
            fprintf(file, " %zu", k + 1);
            any = true;
        }
    if (any)
        fputc('\n', file);
    return any;
}

static bool is_held_y(const Nodes *nodes, size_t node)
{
    return nodes->held[node] != 0;
}

static bool is_held_x(const Nodes *nodes, size_t node)
{
    bool pinned =
        !(nodes->settings->problem->concerns & CONCERN_SUPPORTS) || nodes->settings->supports.pinned;
    return pinned && nodes->held[node] != 0 &&
           nodes->x[node] < nodes->x[0] + nodes->settings->geometry.length / 2;
}

static bool is_loaded(const Nodes *nodes, size_t node)
{
    return nodes->loaded[node] != 0;
}

static void write_forces(FILE *file, const Nodes *nodes)
{
    const Settings *settings = nodes->settings;
    const double dx = settings->lattice.spacing;
    fputs("fix motion all nve\n", file);
    if (nodes->settings->problem->concerns & CONCERN_MOTION) {
        LINE(file, "region channel block INF @ INF INF INF INF units box\n", -1e-6 * dx);
        fprintf(file,
                "group held dynamic all region channel every 1\n"
                "fix hold held setforce %s 0 0\n",
                settings->motion.clamp == CLAMP_FULL ? "0" : "NULL");
        LINE(file, "velocity all set @ 0 0 units box\n", settings->motion.speed);
        return;
    }
    if (write_group(file, nodes, "load", is_loaded)) {
        LINE(file,
             "variable ramped equal step*dt/@\n"
             "variable load equal -@*((v_ramped<1)*v_ramped+(v_ramped>=1))\n",
             settings->loads.ramp > 0 ? settings->loads.ramp : 1e-300, settings->loads.stress / dx);
        fputs("fix push load addforce 0 v_load 0\n", file);
    }
    if (write_group(file, nodes, "held_y", is_held_y))
        fputs("fix hold_y held_y setforce NULL 0 NULL\n", file);
    if (write_group(file, nodes, "held_x", is_held_x))
        fputs("fix hold_x held_x setforce 0 NULL NULL\n", file);
}

/* The probe is the mean over its nodes. */
static void write_probe(FILE *file, const Nodes *nodes)
{
    size_t count = 0;
    double rest = 0;
    fputs("variable probe_y equal \"(", file);
    for (size_t k = 0; k < nodes->count; k++)
        if (nodes->probe[k] != 0) {
            fprintf(file, "%sy[%zu]", count++ ? "+" : "", k + 1);
            rest += nodes->y[k];
        }
    fprintf(file, ")/%zu\"\nvariable probe_v equal \"(", count);
    count = 0;
    for (size_t k = 0; k < nodes->count; k++)
        if (nodes->probe[k] != 0)
            fprintf(file, "%svy[%zu]", count++ ? "+" : "", k + 1);
    fprintf(file, ")/%zu\"\n", count);
    LINE(file, "variable u_probe equal v_probe_y-(@)\n", rest / (double)count);
    fputs("variable time equal step*dt\n", file);
}

static void write_script(FILE *file, const Nodes *nodes)
{
    const Settings *settings = nodes->settings;
    double dx = settings->lattice.spacing, dt = nodes->sim->dt;
    long steps = problem_last_step(dt, settings->time.end), every = settings->output.every;
    if (steps / every > PRINT_ROWS * 10)
        every *= steps / every / PRINT_ROWS;
    write_head(file, nodes);
    fputs("units si\ndimension 2\nboundary s s p\natom_style peri\natom_modify map array\n", file);
    LINE(file, "lattice sq @\n", dx);
    fputs("read_data data.matvib\n\n", file);
    write_pairs(file, nodes);
    LINE(file, "neighbor @ bin\n", settings->lattice.horizon / 20);
    write_notch(file, nodes);
    fputc('\n', file);
    write_forces(file, nodes);
    fputc('\n', file);
    LINE(file, "timestep @\nthermo 1000\n", dt);
    if (starts_bent(nodes))
        fputs("\n# bonds are made of the straight beam, then it is bent\nrun 0\n"
              "variable ux atomfile ux.matvib\nvariable uy atomfile uy.matvib\n"
              "displace_atoms all move v_ux v_uy 0 units box\n\n",
              file);
    write_probe(file, nodes);
    fprintf(file,
            "fix probe all print %ld \"$(step),$(v_time:%%.16g),$(v_u_probe:%%.16g),$(v_probe_v:%%.16g)\" &\n"
            "    file probe.csv title step,time,u_probe,v_probe screen no\n",
            every);
    if (settings->bonds.critical_stretch > 0)
        fprintf(file,
                "compute damage all damage/atom\n"
                "dump damage all custom %ld damage.dump id x y c_damage\n",
                steps > 10 ? steps / 10 : 1);
    fprintf(file, "run %ld\n", steps);
}

typedef enum FileKind { FILE_SCRIPT, FILE_DATA, FILE_UX, FILE_UY, N_FILES } FileKind;

static const char *const file_names[N_FILES] = {"in.matvib", "data.matvib", "ux.matvib", "uy.matvib"};

static void write_file(FILE *file, FileKind kind, const Nodes *nodes)
{
    switch (kind) {
    case FILE_SCRIPT:
        write_script(file, nodes);
        break;
    case FILE_DATA:
        write_data(file, nodes);
        break;
    case FILE_UX:
    case FILE_UY:
        write_displacement(file, nodes, kind == FILE_UX ? nodes->ux : nodes->uy);
        break;
    case N_FILES:
        break;
    }
}

static bool write_all(const Nodes *nodes, Asker asker, const char *folder, bool force, Status *status)
{
    OutputFile files[N_FILES] = {0};
    int count = starts_bent(nodes) ? N_FILES : FILE_UX;
    bool done = true;
    for (int k = 0; k < count && done; k++) {
        char *name;
        if (asprintf(&name, "%s/%s", folder, file_names[k]) < 0) {
            done = status_fail(status, STATUS_FAILED, "not enough memory for the names of files");
            break; /* the files begun are removed below */
        }
        done = output_open(&files[k], asker, name, force, status);
        free(name);
    }
    for (int k = 0; k < count && done; k++) {
        write_file(files[k].stream, (FileKind)k, nodes);
        done = output_finish(&files[k], status) &&
               (patience_lasts(&nodes->settings->patience, (k + 1.0) / count) ||
                status_fail(status, STATUS_FAILED, "interrupted"));
    }
    for (int k = 0; k < count && done; k++)
        done = output_commit(&files[k], status);
    for (int k = 0; k < count; k++)
        output_close(&files[k]);
    return done;
}

/* What pair_style peri/pmb and its integrator have nothing for. */
static bool has_its_like(const Settings *settings, Status *status)
{
    if (settings->lattice.influence != INFLUENCE_CONSTANT)
        return status_fail(status, STATUS_USAGE, "pd.influence: LAMMPS gets constant only");
    if (settings->damping.rate != 0 || settings->time.rest)
        return status_fail(status, STATUS_USAGE, "damping.rate: LAMMPS gets runs without damping only (0)");
    return settings->loads.body_force == 0 ||
           status_fail(status, STATUS_USAGE, "load.body_force: LAMMPS gets beams without weight only (0)");
}

bool lammps_export(const Settings *settings, Asker asker, const char *folder, bool force, Status *status)
{
    if (settings->problem->concerns & CONCERN_PLATE)
        return status_fail(status, STATUS_USAGE,
                           "scenario.problem: plates are not written for LAMMPS (beams are)");
    if (!(settings->problem->concerns & CONCERN_BEAM))
        return status_fail(status, STATUS_USAGE, "scenario.problem: LAMMPS gets beams only (not bar)");
    if (settings->n_changes > 0)
        return status_fail(status, STATUS_USAGE, "changes: LAMMPS gets runs without changes in mid-run only");
    if (!has_its_like(settings, status))
        return false;
    Simulation *sim = problem_simulate(settings, 1, status);
    if (!sim)
        return false;
    Nodes nodes = {.sim = sim, .settings = settings};
    bool made = false, done = read_nodes(&nodes, status) && set_types(&nodes, status) &&
                              output_make_folder(asker, folder, &made, status) &&
                              write_all(&nodes, asker, folder, force, status);
    if (made && !done)
        output_remove_folder(asker, folder);
    free_nodes(&nodes);
    simulation_destroy(sim);
    return done;
}

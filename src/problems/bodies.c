/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elastic bodies in a box, by the material point method: settings to simulation, derived numbers, the row of
 * the problem. */
#include "base/math/functions.h"
#include "methods/mpm/bodies.h"
#include "problems/bodies_answers.h"
#include "problems/solver.h"
#include "scenario/concern_body.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/parameters.h"
#include "scenario/settings.h"

#include <math.h>
#include <string.h>

/* --- settings to simulation ----------------------------------------------------------------------- */

/* A row's values in the order of its shape: disc cx cy r; ring cx cy ri ro; block x0 y0 x1 y1. */
static BodyDef body_of(const Settings *settings, int row)
{
    static const int columns[][4] = {
        [BODY_DISC] = {1, 2, 3, 3}, [BODY_RING] = {1, 2, 4, 5}, [BODY_BLOCK] = {6, 7, 8, 9}};
    enum { VX = 10, VY, SPIN, WAVE };
    _Static_assert((int)BODY_NAME_MAX == (int)ROW_NAME_MAX && (int)BODIES_MAX == (int)ROWS_OF_KIND_MAX,
                   "rows go over whole");
    BodyDef body = {.shape = (BodyShape)settings_row_value(settings, ROWS_BODIES, row, 0)};
    memcpy(body.name, settings->rows[ROWS_BODIES].rows[row].name, sizeof body.name);
    for (int k = 0; k < 4; k++)
        body.size[k] = settings_row_value(settings, ROWS_BODIES, row, columns[body.shape][k]);
    body.velocity[0] = settings_row_value(settings, ROWS_BODIES, row, VX);
    body.velocity[1] = settings_row_value(settings, ROWS_BODIES, row, VY);
    body.spin = settings_row_value(settings, ROWS_BODIES, row, SPIN);
    body.wave = settings_row_value(settings, ROWS_BODIES, row, WAVE);
    return body;
}

static BodiesDef definition(const Settings *settings, int threads)
{
    const Domain *domain = settings_domain(settings);
    const Material *material = settings_material(settings);
    const Transfer *transfer = settings_transfer(settings);
    const Contact *contact = settings_contact(settings);
    const double angle = settings_loads(settings)->incline * (M_PI / 180),
                 g = settings_loads(settings)->gravity;
    BodiesDef def = {
        .width = settings_geometry(settings)->length,
        .height = settings_geometry(settings)->height,
        .walls = {domain->left, domain->right, domain->bottom, domain->top},
        .wall_friction = domain->friction,
        .n_bodies = settings->rows[ROWS_BODIES].count,
        .youngs_modulus = material->youngs_modulus,
        .density = material->density,
        .poisson = material->poisson,
        .law = material->law,
        .plane = material->plane,
        .cell_size = settings_mesh(settings)->cell_size,
        .particles_per_cell = settings_mesh(settings)->particles_per_cell,
        .algorithm = transfer->algorithm,
        .shape = transfer->shape,
        .transfer = transfer->transfer,
        .flip_fraction = transfer->flip_fraction,
        .rotation = transfer->rotation,
        .fields = contact->fields,
        .friction = contact->friction,
        .gap = contact->gap == CONTACT_GAP_OFF ? INFINITY : contact->gap,
        .gravity = {angle != 0 ? g * math_sin(angle) : 0, -g * math_cos(angle)},
        .damping = settings_damping(settings)->rate,
        .courant = settings_time(settings)->courant,
        .mistake = transfer->body_mistake,
        .mistake_beside = transfer->mistake_beside,
        .conceals_mistake = settings->concealed,
        .threads = threads,
        .cancel = settings->cancel,
    };
    for (int row = 0; row < def.n_bodies; row++)
        def.bodies[row] = body_of(settings, row);
    return def;
}

static bool check(const Settings *settings, Status *status)
{
    const BodiesDef def = definition(settings, 1);
    if (def.damping == DAMPING_CRITICAL)
        return status_refuse(status, "damping.rate: critical is not for bodies (a rate, at least 0)");
    return bodies_check(&def, status) &&
           problem_check_steps(settings_time(settings)->end, bodies_step(&def), status);
}

static Simulation *simulate(const Settings *settings, int threads, Status *status)
{
    const BodiesDef def = definition(settings, threads);
    return bodies_create(&def, status);
}

static int derived(const Settings *settings, const Simulation *sim, Derived out[DERIVED_MAX])
{
    const BodiesDef def = definition(settings, 1);
    int n = 0;
    derived_add(out, &n, "dt", "time step dt", "time", bodies_step(&def), false);
    derived_add(out, &n, "wave_speed", "wave speed c", "length/time",
                def.courant * def.cell_size / bodies_step(&def), false);
    if (sim) {
        derived_add(out, &n, "particles", "particles", "1", (double)sim->counts[0], true);
        derived_add(out, &n, "nodes", "nodes", "1", (double)sim->counts[1], true);
    }
    return n;
}

static bool prepare(References *refs, const Settings *settings, const Simulation *sim, Status *status)
{
    const BodiesDef def = definition(settings, 1);
    return bodies_prepare(refs, &def, sim, status);
}

/* What the exact answers account for; rigid motion does not ask how a body is computed. */
static const char *const of_motion[] = {"domain.width",
                                        "domain.height",
                                        "domain.left",
                                        "domain.right",
                                        "domain.bottom",
                                        "domain.top",
                                        "domain.wall_friction",
                                        "material.youngs_modulus",
                                        "material.poisson",
                                        "material.density",
                                        "material.law",
                                        "material.plane",
                                        "mesh.cell_size",
                                        "mesh.particles_per_cell",
                                        "mpm.algorithm",
                                        "mpm.shape",
                                        "mpm.transfer",
                                        "mpm.flip_fraction",
                                        "mpm.rotation",
                                        "mpm.body_mistake",
                                        "contact.fields",
                                        "contact.friction",
                                        "contact.gap",
                                        "load.gravity",
                                        "load.incline",
                                        "time.courant",
                                        "time.end",
                                        NULL};
static const char *const changes[] = {"mpm.algorithm", "mpm.transfer", "mpm.flip_fraction", NULL};

static const Solver bodies_by_mpm = {
    .method = METHOD_MPM,
    .check = check,
    .simulate = simulate,
    .derived = derived,
    .validity = {[REFERENCE_EXACT] = {of_motion, changes}},
    .prepare = prepare,
    .findings = bodies_findings,
};

/* --- the problem ---------------------------------------------------------------------------------- */

static const ParameterUse uses[] = {
    {USE("domain.width", 1)},
    {USE("domain.height", 1)},
    {USE("material.youngs_modulus", 1000)},
    {USE("material.poisson", 0.3)},
    {USE("material.density", 1000)},
    {USE("mesh.cell_size", 0.05), .help = "size dx of a cell; the box is a whole number of cells each way"},
    {USE("mesh.particles_per_cell", 2), .help = "particles along each side of a cell at t = 0: P x P in all"},
    {USE("mpm.shape", MPM_GIMP), .choices = 3, .others = "is for bars"},
    {USE("mpm.transfer", MPM_FLIP), .choices = 2, .others = "is for bars"},
    {USE("damping.rate", 0), .methods = BY_MPM, .help = "rate at which the momentum of the nodes fades"},
    {USE("time.courant", 0.2)},
    {USE("time.end", 4)},
};

static const Solver *const solvers[] = {&bodies_by_mpm, NULL};

const Problem problem_bodies = {
    .word = "bodies",
    .title = "elastic bodies that move, turn, bend and meet",
    .body = "bodies",
    .about = "energy_change",
    .concerns = CONCERN_BODIES,
    USES(uses),
    .solvers = solvers,
    IN_OWN_UNITS,
};

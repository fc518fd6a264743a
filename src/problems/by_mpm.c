/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All problems by the material point method: settings to simulation. */
#include "base/math/functions.h"
#include "problems/solver.h"
#include "scenario/concern_body.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"

#include <math.h>
#include <string.h>

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

MpmDef mpm_definition(const Settings *settings, int threads)
{
    const int concerns = settings->problem->concerns;
    const bool bodies = concerns & CONCERN_BODIES, bar = concerns & CONCERN_MESH;
    const Transfer *transfer = settings_transfer(settings);
    const Loads *loads = settings_loads(settings);
    const Domain *domain = settings_domain(settings);
    const double angle = loads->incline * (M_PI / 180), g = loads->gravity;
    MpmDef def = {
        .problem = bodies ? MPM_BODIES
                   : bar  ? MPM_BAR
                          : MPM_BEAM,
        .length = settings_geometry(settings)->length,
        .height = settings_geometry(settings)->height,
        .thickness = settings_geometry(settings)->thickness,
        .youngs_modulus = settings_material(settings)->youngs_modulus,
        .density = settings_material(settings)->density,
        .poisson = settings_material(settings)->poisson,
        .cell_size = settings_mesh(settings)->cell_size,
        .particles_per_cell = settings_mesh(settings)->particles_per_cell,
        .padding = settings_mesh(settings)->padding,
        .algorithm = transfer->algorithm,
        .shape = transfer->shape,
        .transfer = transfer->transfer,
        .flip_fraction = transfer->flip_fraction,
        .rotation = bar ? ROTATION_NONE : transfer->rotation, /* a bar has no such parameter */
        .mistake = bodies ? transfer->body_mistake : transfer->mistake,
        .mistake_beside = transfer->mistake_beside,
        .conceals_mistake = settings->concealed,
        .courant = settings_time(settings)->courant,
        .threads = threads,
        .cancel = settings->cancel,

        .supports = settings_supports(settings)->ends,
        .joint = settings_joint(settings)->place,
        .joint_modulus = settings_joint(settings)->beyond.youngs_modulus,
        .joint_density = settings_joint(settings)->beyond.density,
        .offset = settings_start(settings)->offset,
        .body_force = loads->body_force,
        .traction = loads->traction,
        .traction_layer = loads->traction_layer,
        .fmpm_order = transfer->fmpm_order,
        .mass_blend = transfer->mass_blend,

        .leaves_channel = concerns & CONCERN_MOTION,
        .grid_velocity = settings_mesh(settings)->velocity,
        .amplitude = settings_start(settings)->amplitude,
        .start = settings_start(settings)->start,
        .stress = settings_start(settings)->stress,
        .ends = settings_supports(settings)->sections,
        .speed = settings_motion(settings)->speed,
        .channel = settings_motion(settings)->channel,
        .clamp = settings_motion(settings)->clamp,
        .end = settings_time(settings)->end,

        .walls = {domain->left, domain->right, domain->bottom, domain->top},
        .wall_friction = domain->friction,
        .n_bodies = settings->rows[ROWS_BODIES].count,
        .law = settings_material(settings)->law,
        .plane = settings_material(settings)->plane,
        .fields = settings_contact(settings)->fields,
        .friction = settings_contact(settings)->friction,
        .gap =
            settings_contact(settings)->gap == CONTACT_GAP_OFF ? INFINITY : settings_contact(settings)->gap,
        .gravity = {angle != 0 ? g * math_sin(angle) : 0, -g * math_cos(angle)},
        .damping = settings_damping(settings)->rate,
    };
    for (int row = 0; row < def.n_bodies; row++)
        def.bodies[row] = body_of(settings, row);
    return def;
}

MpmDef mpm_right_definition(const Settings *settings)
{
    MpmDef def = mpm_definition(settings, 1);
    def.mistake = def.mistake_beside = 0;
    return def;
}

bool mpm_check_settings(const Settings *settings, Status *status)
{
    const MpmDef def = mpm_definition(settings, 1);
    if (def.problem == MPM_BODIES && def.damping == DAMPING_CRITICAL)
        return status_refuse(status, "damping.rate: critical is not for bodies (a rate, at least 0)");
    return mpm_check(&def, status) &&
           problem_check_steps(settings_time(settings)->end, mpm_time_step(&def), status);
}

Simulation *mpm_simulate(const Settings *settings, int threads, Status *status)
{
    const MpmDef def = mpm_definition(settings, threads);
    return mpm_create(&def, status);
}

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
    const Geometry *geometry = settings_geometry(settings);
    const Material *material = settings_material(settings);
    const Joint *joint = settings_joint(settings);
    const Mesh *mesh = settings_mesh(settings);
    const Transfer *transfer = settings_transfer(settings);
    const Start *start = settings_start(settings);
    const Loads *loads = settings_loads(settings);
    const Motion *motion = settings_motion(settings);
    const Domain *domain = settings_domain(settings);
    const Contact *contact = settings_contact(settings);
    const double angle = loads->incline * (M_PI / 180), g = loads->gravity;
    MpmDef def = {
        .problem = bodies ? MPM_BODIES
                   : bar  ? MPM_BAR
                          : MPM_BEAM,
        .length = geometry->length,
        .height = geometry->height,
        .thickness = geometry->thickness,
        .youngs_modulus = material->youngs_modulus,
        .density = material->density,
        .poisson = material->poisson,
        .cell_size = mesh->cell_size,
        .particles_per_cell = mesh->particles_per_cell,
        .padding = mesh->padding,
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
        .joint = joint->place,
        .joint_modulus = joint->beyond.youngs_modulus,
        .joint_density = joint->beyond.density,
        .offset = start->offset,
        .body_force = loads->body_force,
        .traction = loads->traction,
        .traction_layer = loads->traction_layer,
        .fmpm_order = transfer->fmpm_order,
        .mass_blend = transfer->mass_blend,

        .leaves_channel = concerns & CONCERN_MOTION,
        .grid_velocity = mesh->velocity,
        .amplitude = start->amplitude,
        .start = start->start,
        .stress = start->stress,
        .ends = settings_supports(settings)->sections,
        .speed = motion->speed,
        .channel = motion->channel,
        .clamp = motion->clamp,
        .end = settings_time(settings)->end,

        .walls = {domain->left, domain->right, domain->bottom, domain->top},
        .wall_friction = domain->friction,
        .n_bodies = settings->rows[ROWS_BODIES].count,
        .law = material->law,
        .plane = material->plane,
        .fields = contact->fields,
        .friction = contact->friction,
        .gap = contact->gap == CONTACT_GAP_OFF ? INFINITY : contact->gap,
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

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A beam or a plate as its engine by peridynamics wants it. */
#include "base/assertion.h"
#include "answers/beam_answers.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "scenario/rows/rows.h"
#include "methods/bonds/plane/bonds_plane.h"

#include <string.h>

static BeamProblem engine_problem(const Problem *problem)
{
    return problem->concerns & CONCERN_PLATE    ? BEAM_PLATE
           : problem->concerns & CONCERN_MOTION ? BEAM_MOVING_CANTILEVER
           : problem->concerns & CONCERN_NOTCH  ? BEAM_NOTCHED
                                                : BEAM_SIMPLY_SUPPORTED;
}

static void copy_name(char to[PLATE_NAME_MAX], const Row *row)
{
    _Static_assert((int)PLATE_NAME_MAX == (int)ROW_NAME_MAX, "names go over whole");
    memcpy(to, row->name, PLATE_NAME_MAX);
}

/* Columns 0 to 3 are a rectangle; 4 and 5 velocities. */
static int take_regions(const Settings *settings, int kind, bool moved, PlateRegion out[PLATE_ROWS_MAX])
{
    const RowList *list = &settings->rows[kind];
    for (int row = 0; row < list->count; row++) {
        double value[6] = {0};
        for (int k = 0; k < (moved ? 6 : 4); k++)
            value[k] = settings_row_value(settings, kind, row, k);
        out[row] = (PlateRegion){.x0 = value[0],
                                 .y0 = value[1],
                                 .x1 = value[2],
                                 .y1 = value[3],
                                 .gives_x = list->rows[row].given >> 4 & 1,
                                 .gives_y = list->rows[row].given >> 5 & 1,
                                 .vx = value[4],
                                 .vy = value[5]};
        copy_name(out[row].name, &list->rows[row]);
    }
    return list->count;
}

static void take_cuts(const Settings *settings, PlateDef *plate)
{
    const RowList *list = &settings->rows[ROWS_CUTS];
    plate->n_cuts = list->count;
    for (int row = 0; row < list->count; row++) {
        double value[4];
        for (int k = 0; k < 4; k++)
            value[k] = settings_row_value(settings, ROWS_CUTS, row, k);
        plate->cuts[row] = (PlateCut){.x0 = value[0], .y0 = value[1], .x1 = value[2], .y1 = value[3]};
        copy_name(plate->cuts[row].name, &list->rows[row]);
    }
}

static void take_loads(const Settings *settings, PlateDef *plate)
{
    static const PlateEdge edges[] = {[ROW_TOP] = PLATE_TOP,
                                      [ROW_BOTTOM] = PLATE_BOTTOM,
                                      [ROW_LEFT] = PLATE_LEFT,
                                      [ROW_RIGHT] = PLATE_RIGHT};
    const RowList *list = &settings->rows[ROWS_LOADS];
    plate->n_loads = list->count;
    for (int row = 0; row < list->count; row++) {
        double value[7];
        for (int k = 0; k < 7; k++)
            value[k] = settings_row_value(settings, ROWS_LOADS, row, k);
        plate->loads[row] = (PlateLoad){.edge = edges[(int)value[0]],
                                        .from = value[1],
                                        .to = value[2],
                                        .sx = value[3],
                                        .sy = value[4],
                                        .ramp = value[5],
                                        .until = value[6]};
        copy_name(plate->loads[row].name, &list->rows[row]);
    }
}

/* The rows of the scenario in metres. */
static PlateDef plate_definition(const Settings *settings)
{
    PlateDef plate = {0};
    _Static_assert((int)PLATE_ROWS_MAX == (int)ROWS_OF_KIND_MAX, "rows go over whole");
    if (!settings_have_rows(settings, ROWS_PROBE))
        return plate;
    take_cuts(settings, &plate);
    take_loads(settings, &plate);
    plate.n_supports = take_regions(settings, ROWS_SUPPORTS, true, plate.supports);
    plate.n_impulses = take_regions(settings, ROWS_IMPULSES, true, plate.impulses);
    plate.n_unbreakable = take_regions(settings, ROWS_PROTECTED, false, plate.unbreakable);
    plate.probe_x = settings_row_value(settings, ROWS_PROBE, 0, 0);
    plate.probe_y = settings_row_value(settings, ROWS_PROBE, 0, 1);
    return plate;
}

BeamDef beam_definition(const Settings *settings, int threads)
{
    ASSERT_INT(threads, >=, 1);
    return (BeamDef){
        .problem = engine_problem(settings->problem),
        .length = settings_geometry(settings)->length,
        .height = settings_geometry(settings)->height,
        .thickness = settings_geometry(settings)->thickness,
        .youngs_modulus = settings_material(settings)->youngs_modulus,
        .density = settings_material(settings)->density,
        .horizon = settings_lattice(settings)->horizon,
        .spacing = settings_lattice(settings)->spacing,
        .surface_correction = settings_lattice(settings)->surface_correction,
        .volume_correction = settings_lattice(settings)->volume_correction,
        .influence = settings_lattice(settings)->influence,
        .stepping = settings_lattice(settings)->stepping,
        .critical_stretch = settings_bonds(settings)->critical_stretch,
        .protected_depth = settings_bonds(settings)->protected_depth,
        .amplitude = settings_start(settings)->amplitude,
        .speed = settings_motion(settings)->speed,
        .channel = settings_motion(settings)->channel,
        .clamp = settings_motion(settings)->clamp,
        .notch_position = settings_notch(settings)->position,
        .notch_depth = settings_notch(settings)->depth,
        .load_stress = settings_loads(settings)->stress,
        .load_ramp = settings_loads(settings)->ramp,
        .load_position = settings_loads(settings)->position,
        .load_width = settings_loads(settings)->width,
        .support_left = settings_supports(settings)->left,
        .support_right = settings_supports(settings)->right,
        .pinned = settings_supports(settings)->pinned,
        .plate = plate_definition(settings),
        .body_force = settings_loads(settings)->body_force,
        .damping =
            settings_damping(settings)->rate == DAMPING_CRITICAL ? 0 : settings_damping(settings)->rate,
        .critically_damped = settings_damping(settings)->rate == DAMPING_CRITICAL ||
                             (settings_time(settings)->rest && settings_damping(settings)->rate == 0),
        .to_rest = settings_time(settings)->rest,
        .changes_until = settings->n_changes > 0 ? settings->changes[settings->n_changes - 1].step : 0,
        .mistake = settings_lattice(settings)->mistake,
        .conceals_mistake = settings->concealed,
        .mistake_beside = settings_lattice(settings)->mistake_beside,
        .dt = settings_time(settings)->step,
        .end = settings_time(settings)->end,
        .threads = threads,
        .cancel = settings->cancel,
    };
}

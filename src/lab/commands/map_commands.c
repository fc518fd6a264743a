/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands of the map of a beam: magnify, move, draw displacements larger or smaller. */
#include "lab/laboratory.h"
#include "scenario/concern_body.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "lab/commands/commands.h"
#include "base/math/functions.h"
#include "base/text.h"
#include "views/view.h"
#include "panes/screen.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define FIRST_MAGNIFIED 4.0
#define MOST_MAGNIFIED  1024.0
#define STRIDE          0.2 /* of what is seen, for an arrow */

/* The crack's tip is what there is to see of a beam that cracks; else the chosen node. */
static void look_at_something(Screen *screen)
{
    const Settings *settings = experiment_settings(screen->experiment);
    const double *row = experiment_row(screen->experiment);
    int count, x = -1, y = -1;
    const Column *columns = experiment_columns(screen->experiment, &count);
    for (int i = 0; i < count; i++) {
        x = strcmp(columns[i].quantity.name, "crack_x") == 0 ? i : x;
        y = strcmp(columns[i].quantity.name, "crack_y") == 0 ? i : y;
    }
    if (x >= 0 && y >= 0 && row) {
        screen->eye.centre[0] = row[x] / settings_geometry(settings)->length;
        screen->eye.centre[1] = row[y] / settings_geometry(settings)->height;
    } else {
        /* The place of a node as shares of the beam's length and height. */
        const Simulation *simulation = experiment_simulation(screen->experiment);
        const size_t nx = simulation->columns, ny = simulation->rows;
        screen->eye.centre[0] = ((double)(screen->chosen.particle % nx) + 0.5) / (double)nx;
        screen->eye.centre[1] = ((double)(screen->chosen.particle / nx) + 0.5) / (double)ny;
    }
}

static double limited(double value, double least, double most)
{
    return value < least ? least : value > most ? most : value;
}

void command_map_whole(Screen *screen)
{
    screen->eye.open = false;
    screen->eye.magnified = 1;
}

void command_map_magnify(Screen *screen, int direction)
{
    const double most = fmax(FIRST_MAGNIFIED, (double)experiment_simulation(screen->experiment)->columns / 4);
    const double wanted = direction > 0 ? 2 * screen->eye.magnified : screen->eye.magnified / 2;
    screen->eye.magnified = limited(wanted, 1, ldexp(1, (int)ceil(math_log2(most))));
}

void command_map_pan(Screen *screen, int x, int y)
{
    const Settings *settings = experiment_settings(screen->experiment);
    const double stride = STRIDE / screen->eye.magnified;
    screen->eye.centre[0] = limited(screen->eye.centre[0] + x * stride, 0, 1);
    /* a pane is not as high as it is wide */
    const double upwards =
        fmin(0.25, stride * settings_geometry(settings)->length / settings_geometry(settings)->height / 2);
    screen->eye.centre[1] = limited(screen->eye.centre[1] - y * upwards, 0, 1);
}

void command_map_zoom(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    if (!simulation_has_map(experiment_simulation(laboratory_run(lab)))) {
        laboratory_say(lab, MESSAGE_INFO,
                       "Z magnifies the map of a beam or plate; n and N change the time window of a plot");
        return;
    }
    if (screen->eye.open) {
        command_map_whole(&lab->screen);
        return;
    }
    if (!screen->views.upper->is_map && !screen->views.lower->is_map)
        screen->views.upper = view_of_map();
    screen->panes.focus = screen->views.upper->is_map ? PANE_UPPER : PANE_LOWER;
    screen->eye.open = true;
    screen->eye.magnified = FIRST_MAGNIFIED;
    look_at_something(screen);
}

bool command_answer_magnify(Laboratory *lab, const char *text)
{
    Screen *screen = &lab->screen;
    double times;
    if (!simulation_has_map(experiment_simulation(laboratory_run(lab))))
        return prompt_refuse(&lab->prompting, "there is no map of a bar (only of a beam or plate)");
    if (!text_to_double(text, &times) || !(times >= 1 && times <= MOST_MAGNIFIED))
        return prompt_refuse(&lab->prompting, "a number from 1 to 1024, as in 16");
    if (!screen->views.upper->is_map && !screen->views.lower->is_map)
        screen->views.upper = view_of_map();
    command_map_whole(screen);
    screen->eye.magnified = times;
    if (times > 1)
        look_at_something(screen);
    return true;
}

bool command_map_is_focused(const Screen *screen)
{
    return simulation_has_map(experiment_simulation(screen->experiment)) &&
           ((screen->panes.focus == PANE_UPPER && screen->views.upper->is_map) ||
            (screen->panes.focus == PANE_LOWER && screen->views.lower->is_map));
}

/* The size of displacements is part of the scenario's view, which an edit changes without a new run. */
void command_map_enlarge(Laboratory *lab, int direction)
{
    Screen *screen = &lab->screen;
    Settings settings = *experiment_settings(laboratory_run(lab));
    const double now = view_map_enlargement(screen, lab->width, lab->height);
    Status status = {STATUS_DONE, ""};
    if (direction == 0)
        settings_edit_view(&settings)->exaggeration[0] = '\0';
    else
        snprintf(settings_edit_view(&settings)->exaggeration, sizeof settings_view(&settings)->exaggeration,
                 "%.15g", player_next_125(now > 0 ? now : 1, direction));
    if (!experiment_edit(laboratory_run(lab), &settings, &status))
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
    else if (direction == 0)
        laboratory_say(lab, MESSAGE_INFO, "displacements are drawn as large as the pane allows");
    else
        laboratory_say(lab, MESSAGE_INFO, "displacements are drawn x %s (a: as the pane allows)",
                       settings_view(&settings)->exaggeration);
}

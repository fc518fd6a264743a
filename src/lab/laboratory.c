/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Opening, drawing and closing the laboratory. */
#include "lab/laboratory.h"
#include "views/view.h"

#include <stdlib.h>
#include <string.h>

bool laboratory_open(Laboratory *lab, const LaboratoryOptions *options, const Host *host, Status *status)
{
    *lab = (Laboratory){.host = *host,
                        .options = *options,
                        .overlay = {.y = -1},
                        .player = {.run_limit = -1, .playback = {.pace = 1}}};
    lab->options.threads = options->threads > 0 ? options->threads : 1;
    lab->options.history = options->history ? options->history : (size_t)256 << 20;
    lab->asker = options->replay || options->last ? ASKER_REPLAY : laboratory_user(lab);
    lab->carry_out = laboratory_command;
    lab->run_line = line_run;
    lab->utf8 = true;
    lab->editing.undo = calloc(UNDO_MAX, sizeof *lab->editing.undo);
    lab->editing.redo = calloc(UNDO_MAX, sizeof *lab->editing.redo);
    lab->editing.draft = calloc(1, sizeof *lab->editing.draft);
    if (!lab->editing.undo || !lab->editing.redo || !lab->editing.draft) {
        laboratory_close(lab);
        return status_fail(status, "out of memory");
    }
    screen_default(&lab->screen);
    lab->screen.parameters = &lab->parameters;
    lab->screen.help = &lab->help;
    lab->screen.playback = &lab->player.playback;
    lab->screen.bookmarks = &lab->player.bookmarks;
    lab->screen.lesson = &lab->play.shown;
    lab->screen.prompt = &lab->prompting.shown;
    lab->screen.message = &lab->message;
    lab->screen.used = &lab->used;
    lab->screen.diagnosis = lab->diagnosis;
    if (options->sheet && strcmp(options->sheet, parameter_sheet_words[SHEET_PLAIN]) == 0)
        lab->screen.panes.sheet = SHEET_PLAIN;
    Experiment *experiment = opening_experiment(lab, options->settings, status);
    if (!experiment) {
        laboratory_close(lab);
        return false;
    }
    opening_name(lab, options->scenario);
    opening_begin(lab, experiment);
    if (options->is_coarse)
        opening_tell_coarse(lab);
    if (options->paused)
        lab->player.resume = lab->player.playback.state = STATE_PAUSED;
    if (options->reached)
        memcpy(lab->play.shown.reached, options->reached, sizeof lab->play.shown.reached);
    lab->screen.offers_lesson = options->first_start && !options->lesson;
    if (options->lesson && !lesson_play_open(lab, options->lesson, status)) {
        laboratory_close(lab);
        return false;
    }
    return true;
}

void laboratory_close(Laboratory *lab)
{
    lesson_play_close(lab);
    duel_close(&lab->player.duel);
    experiment_destroy(laboratory_run(lab));
    overlay_close(&lab->overlay);
    free(lab->editing.undo);
    free(lab->editing.redo);
    free(lab->editing.draft);
    lab->screen.experiment = lab->player.duel.a = NULL;
    lab->editing.undo = lab->editing.redo = lab->editing.draft = NULL;
}

bool laboratory_draw(Laboratory *lab, Canvas *canvas, int width, int height)
{
    player_drop_part(&lab->player);
    /* without room for all panes the plot is first, of bodies their map; Tab reaches the others */
    const PaneId plot = lab->screen.views.upper->is_map &&
                                simulation_has(experiment_simulation(lab->screen.experiment), HAS_BODIES)
                            ? PANE_UPPER
                            : PANE_LOWER;
    const bool was_whole = lab->width == 0 || screen_is_whole(&lab->screen, lab->width, lab->height);
    const bool is_whole = screen_is_whole(&lab->screen, width, height);
    if (was_whole && !is_whole && lab->screen.panes.focus == PANE_PARAMETERS && !lab->play.shown.open &&
        !lab->parameters.edit.open && !lab->prompting.shown.open) {
        lab->screen.panes.focus = plot;
        lab->focus_lent = true;
    } else if (!was_whole && is_whole && lab->focus_lent) {
        /* the focus was only lent: Enter and the arrows mean the parameters again */
        if (lab->screen.panes.focus == plot)
            lab->screen.panes.focus = PANE_PARAMETERS;
        lab->focus_lent = false;
    }
    lab->width = width;
    lab->height = height;
    if (screen_view_in(&lab->screen, lab->screen.panes.focus))
        lab->screen.panes.last_plot = lab->screen.panes.focus;
    lab->player.playback.goes_on = lab->player.resume == STATE_RUNNING;
    if ((canvas->width != width || canvas->height != height) && !canvas_open(canvas, width, height, NULL))
        return false;
    screen_draw(&lab->screen, canvas);
    return true;
}

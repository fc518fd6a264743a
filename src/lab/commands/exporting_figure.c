/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A view as a figure for paper: `:figure [VIEW] FILE`, or x and a name that ends in .svg, .pdf or .png;
 * without its word the focused one. */
#include "lab/laboratory.h"
#include "lab/writing.h"

#include "picture/paper/figure_file.h"
#include "views/views.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Where no plot has the focus it is the lower one, as for the cursor. */
static const View *view_in_focus(const Screen *screen)
{
    if (screen->panes.inspecting && screen->panes.focus == PANE_INSPECTOR)
        return &view_inspector;
    return screen->panes.focus == PANE_UPPER ? screen->views.upper : screen->views.lower;
}

static bool write_figure(Laboratory *lab, bool force)
{
    const Screen *screen = &lab->screen;
    const View *view = lab->exporting.view;
    Status status = {STATUS_DONE, ""};
    Figure figure;
    if (!writing_allowed(lab, lab->exporting.name))
        return true;
    laboratory_say(lab, MESSAGE_INFO, "drawing %s", lab->exporting.name); /* a large map takes a moment */
    if (!laboratory_go_on(lab)) {
        laboratory_say(lab, MESSAGE_INFO, "cancelled");
        return true;
    }
    figure_open(&figure, 0, 0);
    const bool sound = figure_add(&figure, screen, view, 1, &status) &&
                       figure_write(&figure, lab->asker, lab->exporting.name, force, &status);
    figure_close(&figure);
    if (!sound) {
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
        return true;
    }
    char *whole = realpath(lab->exporting.name, NULL);
    laboratory_say(lab, MESSAGE_INFO, "wrote %s: the view %s", whole ? whole : lab->exporting.name,
                   view->word);
    free(whole);
    return true;
}

static bool answer_replace(Laboratory *lab, const char *text)
{
    (void)text;
    return write_figure(lab, true);
}

/* The view that the first word names, where a file stands behind it; the rest is the file. */
static const View *take_view(const Screen *screen, const char **words)
{
    char word[32] = "";
    const size_t length = strcspn(*words, " ");
    if (length < sizeof word)
        snprintf(word, sizeof word, "%.*s", (int)length, *words);
    const View *named = view_named(word);
    if (!named || !(*words)[length])
        return view_in_focus(screen);
    *words += length + strspn(*words + length, " ");
    return named;
}

bool exporting_figure(Laboratory *lab, const char *words)
{
    Status status = {STATUS_DONE, ""};
    const Screen *screen = &lab->screen;
    const char *file = words;
    const View *view = take_view(screen, &file);
    if (!*file)
        return prompt_refuse(&lab->prompting, "a file is wanted: FILE.svg, FILE.pdf or FILE.png");
    if (!figure_allowed(file, &status))
        return prompt_refuse(&lab->prompting, status.text);
    if (!writing_name_fits(lab, file))
        return false;
    if (view_missing(view, screen))
        return prompt_refuse(&lab->prompting, view_missing(view, screen));
    player_pause(lab);
    if (lab->player.playback.state == STATE_COMPUTING)
        return prompt_refuse(&lab->prompting, "wait until the run has come to its time, or cancel with Esc");
    if (!view_makes_figure(view, screen))
        return prompt_refuse(&lab->prompting,
                             "this view makes no figure: name another, as in figure probe probe.svg");
    char name[NAME_MAX_BYTES];
    snprintf(name, sizeof name, "%s", file); /* the text may be the name already */
    snprintf(lab->exporting.name, sizeof lab->exporting.name, "%s", name);
    lab->exporting.view = view;
    if (access(name, F_OK) != 0)
        return write_figure(lab, false);
    prompt_ask_replace(&lab->prompting, answer_replace, name);
    return true;
}

/* The focused view as a figure for paper: `:figure FILE`, or x and a name that ends in .svg, .pdf or .png. */
#include "tui/control/laboratory.h"
#include "tui/control/writing.h"

#include "figure/figure.h"
#include "view/views/view.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* Where no plot has the focus it is the lower one, as for the cursor. */
static const View *view_in_focus(const Screen *screen)
{
    return screen->panes.focus == PANE_UPPER ? screen->views.upper : screen->views.lower;
}

static bool write_figure(Laboratory *lab, bool force)
{
    const Screen *screen = &lab->screen;
    const View *view = view_in_focus(screen);
    Status status = {STATUS_DONE, ""};
    Figure figure;
    if (!writing_allowed(lab, lab->exporting.name))
        return true;
    laboratory_say(lab, MESSAGE_INFO, "drawing %s", lab->exporting.name); /* a large map takes a moment */
    if (!lab->host.go_on(lab->host.context)) {
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

bool exporting_figure(Laboratory *lab, const char *file)
{
    Status status = {STATUS_DONE, ""};
    if (!*file)
        return prompt_refuse(&lab->prompting, "a file is wanted: FILE.svg, FILE.pdf or FILE.png");
    if (!figure_allowed(file, &status))
        return prompt_refuse(&lab->prompting, status.text);
    if (!writing_name_fits(lab, file))
        return false;
    player_pause(lab);
    if (lab->screen.playback.state == STATE_COMPUTING)
        return prompt_refuse(&lab->prompting, "wait until the run has come to its time, or cancel with Esc");
    if (!view_makes_figure(view_in_focus(&lab->screen), &lab->screen))
        return prompt_refuse(
            &lab->prompting,
            "this view makes no figure: put a plot or the beam into the pane and focus it (Tab)");
    char name[NAME_MAX_BYTES];
    snprintf(name, sizeof name, "%s", file); /* the text may be the name already */
    snprintf(lab->exporting.name, sizeof lab->exporting.name, "%s", name);
    if (access(name, F_OK) != 0)
        return write_figure(lab, false);
    prompt_ask_replace(&lab->prompting, answer_replace, name);
    return true;
}

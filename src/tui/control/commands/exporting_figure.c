/* The focused view as a figure for paper: `:figure FILE`, or x and a name that ends in .svg, .pdf or .png. */
#include "tui/control/laboratory.h"

#include "figure/figure.h"
#include "view/views/view.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* Where no plot has the focus it is the lower one, as for the cursor. */
static const View *view_in_focus(const Screen *screen)
{
    return screen->focus == PANE_UPPER ? screen->upper : screen->lower;
}

static bool write_figure(Laboratory *lab, bool force)
{
    const Screen *screen = &lab->screen;
    const View *view = view_in_focus(screen);
    Status status = {STATUS_DONE, ""};
    Figure figure;
    if (!may_write(lab, lab->export_name))
        return true;
    say(lab, MESSAGE_INFO, "drawing %s", lab->export_name); /* a large map takes a moment */
    if (!lab->host.go_on(lab->host.context)) {
        say(lab, MESSAGE_INFO, "cancelled");
        return true;
    }
    figure_open(&figure, 0, 0);
    const bool sound = figure_add(&figure, screen, view, 1, &status) &&
                       figure_write(&figure, lab->asker, lab->export_name, force, &status);
    figure_close(&figure);
    if (!sound) {
        say(lab, MESSAGE_ERROR, "%s", status.text);
        return true;
    }
    char *whole = realpath(lab->export_name, NULL);
    say(lab, MESSAGE_INFO, "wrote %s: the view %s", whole ? whole : lab->export_name, view->word);
    free(whole);
    return true;
}

static bool answer_replace(Laboratory *lab, const char *text)
{
    (void)text;
    return write_figure(lab, true);
}

bool draw_figure(Laboratory *lab, const char *file)
{
    Status status = {STATUS_DONE, ""};
    if (!*file)
        return refuse(lab, "a file is wanted: FILE.svg, FILE.pdf or FILE.png");
    if (!figure_allowed(file, &status))
        return refuse(lab, status.text);
    if (!name_can_be(lab, file))
        return false;
    pause_run(lab);
    if (lab->screen.state == STATE_COMPUTING)
        return refuse(lab, "wait until the run has come to its time, or cancel with Esc");
    if (!view_makes_figure(view_in_focus(&lab->screen), &lab->screen))
        return refuse(lab,
                      "this view makes no figure: put a plot or the beam into the pane and focus it (Tab)");
    char name[NAME_MAX_BYTES];
    snprintf(name, sizeof name, "%s", file); /* the text may be the name already */
    snprintf(lab->export_name, sizeof lab->export_name, "%s", name);
    if (access(name, F_OK) != 0)
        return write_figure(lab, false);
    ask_replace(lab, answer_replace, name);
    return true;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All that is drawn, as one view of its parts: everything seen is a function of a Screen. Nothing here knows
 * keys or terminals. What the owner of a part says of it is read by its pointer; what a view moves itself, as
 * the arrows and the mouse want it, is in the Screen. */
#ifndef PANES_SCREEN_H
#define PANES_SCREEN_H

#include "panes/sheet.h"
#include "run/experiment.h"
#include "views/views_shown.h"

/* Two runs share a picture, or each has its own. */
typedef enum DuelSide { SIDE_BOTH, SIDE_A, SIDE_B } DuelSide;

typedef struct Screen {
    const Experiment *experiment; /* the run that is drawn; looking changes none */
    const struct Duel *duel;      /* whose A it is; its second run is drawn beside. NULL: there is none */
    DuelSide side;                /* a picture of one run of it only */
    const char *scenario;         /* name shown in the title line */

    ScreenLook look;
    PanesShown panes;
    ViewsShown views;
    TimeShown time;
    Selection chosen;
    LogPlace log;
    MapEye eye;
    bool offers_lesson; /* to who is here for the first time, until a key is pressed */

    const struct ParametersShown *parameters; /* panes/parameters_shown.h */
    const HelpShown *help;
    const struct Playback *playback;       /* run/playback.h */
    const struct Bookmarks *bookmarks;     /* likewise */
    const struct LessonShown *lesson;      /* lessons/lesson_shown.h */
    const struct Prompt *prompt;           /* panes/key_line.h */
    const struct Message *message;         /* likewise */
    const struct CommandSet *used;         /* for hints that go once their command was used */
    const struct Convergence *convergence; /* what is known of the run's studies; NULL: nothing */
    const struct Overlay *overlay;         /* a foreign series over the plots; NULL: none */
    const struct RunSummary *summary;      /* what the run came to; NULL: not known */
    const char *diagnosis;                 /* what is said of somebody's own code, in the box; "": nothing */
} Screen;

/* The parts that nobody has said anything of are empty, and the run is paused. */
void screen_default(Screen *);

/* Takes over window, references and colour of the beam as far as a scenario names them. */
void screen_read_view(Screen *, const ViewSettings *);

/* The view in a pane; NULL: it is no plot pane. */
const View *screen_view_in(const Screen *, PaneId);

#endif

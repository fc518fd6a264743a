/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The laboratory's state and what changes it: keys and frames. A host (a terminal's event loop, a script)
 * owns clock and picture and calls in here; session/laboratory_main.h is how the program opens it. Each part
 * of the state is described where its functions are. */
#ifndef LAB_LABORATORY_H
#define LAB_LABORATORY_H

#include "base/output.h"
#include "answers/convergence.h"
#include "answers/run_summary.h"
#include "run/overlay.h"
#include "lab/edit.h"
#include "lab/lesson/lesson_play.h"
#include "lab/player.h"
#include "lab/prompt/prompt.h"
#include "lab/session/laboratory_main.h"
#include "terminal/keys.h"
#include "panes/screen.h"
#include "picture/canvas.h"
#include "run/experiment.h"

#include <stdbool.h>

#define FRAME_SECONDS 0.033 /* a frame is at most that long, so a key is answered within it */
#define QUIET_SECONDS 0.15  /* work that takes no longer is not worth a picture that reports it */

typedef struct Session Session;

enum { NAME_MAX_BYTES = 256 };

/* What the laboratory asks of its host. */
typedef struct Host {
    double (*now)(void *context); /* seconds, only ever growing */
    /* `steps` time steps were done: lets a virtual clock go on. */
    void (*worked)(void *context, long steps);
    /* In the middle of work that cannot be cut into frames, message.text says what: draw, look for ^C;
     * false: give up. While the laboratory is being opened there is nothing to draw. */
    bool (*go_on)(void *context);
    void (*redraw)(void *context);  /* everything again; NULL: nobody looks */
    void (*suspend)(void *context); /* ^Z; NULL: there is no shell */
    void *context;
    /* A key waits, for which the engine makes room at once; NULL: keys come between frames. */
    bool (*key_waits)(void *context);
    /* What `:tell` was asked for, in lines; NULL: it is said in the key line. */
    void (*tell)(void *context, const char *text);
} Host;

/* What keys before this one have left behind. */
typedef struct InputState {
    enum { DRAG_NOTHING, DRAG_VALUE, DRAG_TIME } drag; /* what the pressed mouse holds */
    int drag_x;                                        /* where it was nudged last */
    bool pasted_line; /* a pasted line has ended; what is pasted behind it is another word */
} InputState;

/* The points of the study of convergence that a view shows, worked out while nothing else is to be done. */
typedef struct Refining {
    Convergence convergence;         /* behind screen.convergence */
    const ConvergenceStudy *stopped; /* by hand, until a view is asked for again; NULL: none */
} Refining;

/* The file or files that are being asked for. */
typedef struct Exporting {
    char name[2 * NAME_MAX_BYTES];           /* as long as an answer may be */
    bool newest;                             /* of the run: to its newest step, not to here */
    const View *view;                        /* of a figure */
    void (*write)(Laboratory *, bool force); /* what is asked about writes so */
} Exporting;

struct Laboratory {
    Screen screen;

    /* The tables of commands and of lines stand above all that they call; from there they are reached so. */
    void (*carry_out)(Laboratory *, CommandId);
    bool (*run_line)(Laboratory *, const char *line, Status *);

    Host host;
    LaboratoryOptions options;
    Asker asker;        /* on whose behalf the laboratory does what it does now */
    Session *recording; /* notes every key; NULL: none */
    bool utf8;          /* glyphs beyond ASCII can be shown */
    bool closed;        /* the user has left */
    bool given_up;      /* work of this key or frame is: ^C, or a session that is done again says so */

    Player player;
    Prompting prompting;
    Editing editing;
    LessonPlay play;
    Homework homework;
    Exporting exporting;
    Refining refining;
    InputState held;
    /* what the screen points at, with what belongs to player, prompts and lessons */
    ParametersShown parameters;
    HelpShown help;
    Message message;
    CommandSet used;
    RunSummary summary;
    Overlay overlay;
    char diagnosis[700];
    char scenario[NAME_MAX_BYTES];

    int width, height; /* of the picture, for focus and mouse */
    bool focus_lent;   /* to the lower plot, while there is no room for all panes */
    double said_at;    /* when the message came */
    double work_since; /* when work that is not cut into frames began */
};

/* The run that keys and edits act on; the screen has a const view of it. NULL while the laboratory opens. */
static inline Experiment *laboratory_run(const Laboratory *lab)
{
    return lab->player.duel.a;
}

static inline const Settings *laboratory_settings(const Laboratory *lab)
{
    return experiment_settings(laboratory_run(lab));
}

static inline const Simulation *laboratory_simulation(const Laboratory *lab)
{
    return experiment_simulation(laboratory_run(lab));
}

/* At t = 0, running or paused as the options say. False: the status says why; nothing is left open. */
bool laboratory_open(Laboratory *, const LaboratoryOptions *, const Host *, Status *);
void laboratory_close(Laboratory *);

/* Whose keys come from its host, a session that is done again apart. */
Asker laboratory_user(const Laboratory *);

/* One key. */
void laboratory_key(Laboratory *, const Key *);

/* Carries out a command, as its key does. */
void laboratory_command(Laboratory *, CommandId);

/* Whether there is a function that carries it out: true for every row of the command table. */
bool laboratory_can(CommandId);

/* Whether there is work for frames; if not, the host may sleep until a key. */
bool laboratory_active(const Laboratory *);

/* After so many seconds a frame gives the key line back its keys; -1: no message is in their place. */
double laboratory_message_left(const Laboratory *);

/* One frame's share of the engine's work, until `deadline` at the latest (by the host's clock). False: there
 * is nothing new to be drawn, for a step that takes longer than the frame goes on; to draw now would throw
 * away what has been done of it. */
bool laboratory_frame(Laboratory *, double deadline);

/* In work that is not cut into frames: asks the host, and notes in the session if it is to be given up. */
bool laboratory_go_on(Laboratory *);

/* Likewise, with these words in the key line meanwhile; the message of before comes back. */
bool laboratory_work(Laboratory *, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Draws on a canvas of this size. */
bool laboratory_draw(Laboratory *, Canvas *, int width, int height);

/* In the key line until a key is pressed or, MESSAGE_INFO, it has been read; MESSAGE_NONE: nothing more. */
void laboratory_say(Laboratory *, MessageKind, const char *format, ...) __attribute__((format(printf, 3, 4)));
void laboratory_tell(Laboratory *, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Asks how far and under which name, "": none is known, as far as that is needed. False: refused. */
bool exporting_ask(Laboratory *, const char *name, Status *);

/* "[VIEW] FILE": a view, or else the focused one, as a figure. False: refused, as an answer to a prompt. */
bool exporting_figure(Laboratory *, const char *words, Status *);

void exporting_scenario_ask(Laboratory *); /* writing the scenario as a file */
bool exporting_scenario(Laboratory *, const char *text, Status *);

/* `:fit KEY,...` searches the parameters with which the run agrees best with the series that lies over it,
 * and has the run made again with them; one undo takes it back. Intervals and residuals are said. */
bool fitting_answer(Laboratory *, const char *words, Status *);

/* `:diagnose FILE`: which code made the numbers of a file, as against the scenario on screen, is said in the
 * box, and a series lies over the plots from then on. The run on screen stays as it is. */
bool fitting_diagnose(Laboratory *, const char *words, Status *);

/* Whether a study on screen lacks points and nothing else goes on. */
bool refining_is_due(const Laboratory *);

/* The next point. A key that waits is let through, and the point begun again afterwards. */
void refining_work(Laboratory *);

/* False: there is nothing to stop. */
bool refining_stop(Laboratory *);

/* Its simulation shows on the screen how far its building has come, now and when it is made again. */
Experiment *opening_experiment(Laboratory *, const Settings *, Status *);

/* This run takes the place of the one before, which goes; what belongs to a run and not to the way it is
 * looked at begins again. */
void opening_begin(Laboratory *, Experiment *);
void opening_name(Laboratory *, const char *name);

/* Another scenario in the place of this one, or its coarse form, which is then said; at full size, "" that of
 * which this is the coarse form. */
bool opening_answer(Laboratory *, const char *text, Status *);
bool opening_whole(Laboratory *, const char *text, Status *);
void opening_tell_coarse(Laboratory *); /* says that this is the coarse form of what was asked for */

/* Asks which scenario is opened, with a list to choose from. */
void opening_ask(Laboratory *);

#endif

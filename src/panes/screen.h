/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All that is drawn, as one view of its parts: everything seen is a function of a Screen. Nothing here knows
 * keys or terminals. What the owner of a part says of it is read by its pointer; what a view moves itself, as
 * the arrows and the mouse want it, is in the Screen. */
#ifndef PANES_SCREEN_H
#define PANES_SCREEN_H

#include "help/command.h"
#include "methods/method.h"
#include "picture/canvas.h"
#include "picture/glyph.h"
#include "run/experiment.h"

#include <stdbool.h>

typedef enum PaneId {
    PANE_PARAMETERS,
    PANE_MESH,
    PANE_UPPER,
    PANE_LOWER,
    PANE_BOX,
    PANE_INSPECTOR,
    PANE_COUNT
} PaneId;

/* What a terminal can show, and what was asked for. */
typedef struct ScreenLook {
    Glyphs glyphs;
    int colours; /* 0: none; 8; 256 */
    bool light;  /* a light background */
} ScreenLook;

/* How much there is on the screen, in the order of parameter_sheet_words. */
typedef enum Sheet { SHEET_FULL, SHEET_PLAIN } Sheet;

typedef struct PanesShown {
    PaneId focus;
    bool zoomed;             /* the focused pane fills the screen */
    Sheet sheet;             /* see screen_is_plain() */
    bool lecture;            /* the plain sheet with thick curves and its number large */
    bool inspecting;         /* the inspector is open, see inspector_find() */
    PaneId before_inspector; /* the pane that had the focus before it was opened */
    PaneId last_plot;        /* the plot that was looked at last: what z magnifies */
    PaneId before_zoom;      /* the pane that had the focus before that */
    bool followed;           /* the focus came to a plot with a view that was asked for */
} PanesShown;

typedef struct HelpShown {
    bool open;
    int page, scroll;
    int found; /* the line of the page that a search found, from 1; 0: none */
    char sought[64];
} HelpShown;

/* --- what is chosen and read in the plots --------------------------------------------------------- */

typedef struct View View; /* views/view.h */

enum { VIEWS_MAX = 32 };

typedef enum ReferencesShown { SHOW_ALL, SHOW_EXACT, SHOW_PREDICTED, SHOW_NONE, SHOW_COUNT } ReferencesShown;

/* Which of its variants a view shows; of one that is not named, the first. */
typedef struct ViewVariant {
    const View *view;
    int variant;
    char word[64]; /* by which another run has it, at another place or not at all; "": it has no name */
} ViewVariant;

typedef struct ViewsShown {
    const View *upper, *lower;
    ViewVariant variants[VIEWS_MAX];
    int n_variants;
    ReferencesShown references;
} ViewsShown;

/* The axis of time. */
typedef struct TimeShown {
    double window; /* its length; 0: automatic */
    double cursor; /* the time of the plot's cursor; NAN: none */
} TimeShown;

/* What is seen of the map of a body. */
typedef struct MapEye {
    bool open;        /* arrows, + and - move it */
    double magnified; /* 1: the whole body */
    double centre[2]; /* shares of its length and height */
} MapEye;

/* Where one reads in the log. */
typedef struct LogPlace {
    int event; /* the chosen one; -1: the newest */
    int first; /* the first one shown, as far as that leaves the chosen one in sight */
} LogPlace;

/* The things that all panes speak of. */
typedef struct Selection {
    size_t particle, node;
    bool is_node;     /* stage box and inspector follow the node, not the particle */
    int table_column; /* the one that is marked in a table */
} Selection;

/* The chosen particle or, where a node is chosen, node: so many on. */
void selection_next(Selection *, const Simulation *, int direction, size_t by);

/* The one that is looked at first: in the middle of a bar, of a beam's middle row. */
size_t selection_middle(const Simulation *);

/* --- the screen ----------------------------------------------------------------------------------- */

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

    const struct ParametersShown *parameters; /* panes/entry.h */
    const HelpShown *help;
    const struct Playback *playback;       /* run/playback.h */
    const struct Bookmarks *bookmarks;     /* likewise */
    const struct LessonShown *lesson;      /* lessons/lesson_shown.h */
    const struct Prompt *prompt;           /* panes/entry.h */
    const struct Message *message;         /* likewise */
    const struct CommandSet *used;         /* for hints that go once their command was used */
    const struct Convergence *convergence; /* what is known of the run's studies; NULL: nothing */
    const struct Overlay *overlay;         /* a foreign series over the plots; NULL: none */
    const struct RunSummary *summary;      /* what the run came to; NULL: not known */
    const char *diagnosis;                 /* what is said of somebody's own code, in the box; "": nothing */
} Screen;

static inline const Settings *screen_settings(const Screen *screen)
{
    return experiment_settings(screen->experiment);
}

static inline const Simulation *screen_simulation(const Screen *screen)
{
    return experiment_simulation(screen->experiment);
}

/* Whether its simulation has all of these (HAS_...). */
static inline bool screen_has(const Screen *screen, unsigned what)
{
    return simulation_has(screen_simulation(screen), what);
}

/* The parts that nobody has said anything of are empty, and the run is paused. */
void screen_default(Screen *);

/* Takes over window, references and colour of the beam as far as a scenario names them. */
void screen_read_view(Screen *, const ViewSettings *);

/* The view in a pane; NULL: it is not a plot pane. */
const View *screen_view_in(const Screen *, PaneId);

/* --- what panes and views ask of the runs on it --------------------------------------------------- */

/* One picture, one number and few parameters: by the sheet, or for a lecture. */
bool screen_is_plain(const Screen *);

/* What `t` would try: "cell size 0.5". False: nothing is asked. */
bool screen_question(const Screen *, char *out, size_t size);

/* The number that the scenario is about at the step on screen, in digits and what stands behind them:
 * "periods behind". False: it is not known, or hidden: "..." or "?". */
enum { NUMBER_DIGITS_MAX = 16, NUMBER_WORDS_MAX = 80 };
bool screen_number(const Screen *, char digits[NUMBER_DIGITS_MAX], char words[NUMBER_WORDS_MAX]);

/* How events are marked in timelines and plots; where several share a cell the one further down is seen. */
typedef struct EventMark {
    EventKind kind;
    const char *letter;
    Style style;
    const char *word; /* for the legend */
} EventMark;
enum { SCREEN_MARKS = 10 };
extern const EventMark screen_marks[SCREEN_MARKS];
const char *screen_event_letter(EventKind); /* " ": it has none */

/* The second run of a duel; NULL: there is none. */
const Experiment *screen_second_run(const Screen *);

/* The run beside the one on this screen, A of B and B of A; NULL: there is one alone. */
const Experiment *screen_other_run(const Screen *);

/* Both runs of a duel share the picture: what only one of them can have is left to pictures of one run. */
bool screen_is_shared(const Screen *);

/* The screen of one run of a duel, for a picture of its own. */
Screen screen_of_side(const Screen *, DuelSide);

/* The run whose times the axes of time go by: A, in a picture of B as well. */
const Experiment *screen_clock_run(const Screen *);

bool screen_shows_exact(const Screen *);
bool screen_shows_predicted(const Screen *);
bool screen_is_running(const Screen *);
bool screen_is_inside(const Screen *);  /* in a step, or right behind its last stage */
bool screen_is_rewound(const Screen *); /* more has been computed than is shown */

/* What is settled by the problem of the run shown, its units above all. */
const Problem *screen_problem(const Screen *);

/* Words that are used where they are asked for: screen_time_text(screen, t).text. */
typedef struct ScreenText {
    char text[48];
} ScreenText;

/* "t 12.34" with as many decimals as the time step has: columns do not dance. */
ScreenText screen_time_text(const Screen *, double time);

/* How far a particle field reaches: what it is now and, where the exact answer is known, will be; rounded up
 * so that a scale made of it keeps still. */
double screen_field_reach(const Screen *, int field, const double *now, size_t count);

/* A derived number by name; NAN: there is none. */
double screen_derived(const Screen *, const char *name);

/* The stage that the box speaks of: the last one done (*done) or, between steps, the next. */
int screen_box_stage(const Screen *, bool *done);

/* A field of all nodes as it is or was before the last stage, so that what they held can be drawn when the
 * grid has been put back. The largest amount; -1: they have no such field. */
double screen_node_values(const Screen *, const char *field, bool before, double *out);

/* " m/s" after a value of a field; "" where it has none, and for the bar, whose units are whatever one likes
 * so long as they fit together. */
ScreenText screen_unit_text(const Screen *, const Field *);

/* --- between which things a stage hands on -------------------------------------------------------- */

typedef enum Flow { FLOW_NONE, FLOW_TO_NODES, FLOW_TO_PARTICLES, FLOW_FORGET } Flow;

/* What the stage just done has handed on, if it is to be seen: one is, and no run goes on (inside). */
Flow flow_of_stage(const Screen *, bool *inside);

/* The set that a stage writes to. A name that particles and nodes share (mass, x) counts as the one that the
 * other names of the stage show. */
int flow_target(const Simulation *, const Stage *);

/* --- as cells, and what lies where ---------------------------------------------------------------- */

/* Draws everything. Below 40x12 a message. Never fails: what has no room is left out by a fixed order. */
void screen_draw(const Screen *, Canvas *);

/* Where a pane lies at this size; width 0: it is not shown. */
Rect screen_pane(const Screen *, int width, int height, PaneId);

/* Whether the pane shows the diagnosis of a foreign code at this size. */
bool screen_shows_diagnosis(const Screen *, int width, int height);

/* Whether all panes of the sheet have room; else only the focused one, or the two plots, are seen. */
bool screen_is_whole(const Screen *, int width, int height);

/* The command under column x of the key line; COMMAND_NONE: none. */
CommandId screen_key_command(const Screen *, int width, int x);

/* In the plot panes and the strip: a click on something that a view shows, and so many lines of the wheel.
 * False: nothing of a view lies there. */
bool screen_click_view(Screen *, int width, int height, int x, int y);
bool screen_scroll_view(Screen *, int width, int height, int x, int y, int by);

/* The row of the parameter pane at a place of the screen; -1: none. */
int screen_parameter_at(const Screen *, int width, int height, int x, int y);

/* How far the text of a lesson can be scrolled at this size; 0: all is seen. */
int screen_lesson_most(const Screen *, int width, int height);

/* Lessons in the list, and the one in a cell of it; -1: none. */
int screen_lesson_count(void);
int screen_lesson_at(const Screen *, int width, int height, int x, int y);

/* How many pages the help has, and how far the open one can be scrolled. */
int help_pages(const Screen *);
int help_most(const Screen *, int width, int height);

/* Finds the next line with these words, in any case, behind the last one found, through all pages and around.
 * False: there is none, and `at` stays as it is. */
bool help_search(const Screen *, int width, const char *words, HelpShown *at);

/* The step of a bookmark in the run as it is now. */
long screen_bookmark_step(const Screen *, int index);

/* The step that lies under a cell of the timeline; -1: the cell is not on it. */
long screen_timeline_step(const Screen *, int width, int height, int x, int y);

/* The step of the place of the timeline that is nearest to a column, in whatever row the mouse is. */
long screen_timeline_nearest(const Screen *, int width, int height, int x);

/* The place of the body, m, that is drawn in a cell as long as nothing has moved. False: no map is there. */
bool view_map_place(const Screen *, int width, int height, int x, int y, double place[2]);

/* The factor by which the beam's map draws displacements; 0: it is not shown. */
double view_map_enlargement(const Screen *, int width, int height);

#endif

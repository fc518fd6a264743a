/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The screen's state and its drawing: everything seen is a function of a Screen. The laboratory (tui) changes
 * the state on commands; nothing here knows keys or terminals. */
#ifndef VIEW_SCREEN_H
#define VIEW_SCREEN_H

#include "run/duel.h"
#include "answers/summary.h"
#include "run/stop.h"
#include "lessons/lesson.h"
#include "picture/canvas.h"
#include "help/command.h"

typedef struct Convergence Convergence; /* answers/convergence.h */
typedef struct Overlay Overlay;         /* run/overlay.h */

enum { FRAMES_PER_SECOND = 30 };

typedef enum PaneId {
    PANE_PARAMETERS,
    PANE_MESH,
    PANE_UPPER,
    PANE_LOWER,
    PANE_BOX,
    PANE_INSPECTOR,
    PANE_COUNT
} PaneId;

typedef enum RunState {
    STATE_PAUSED,
    STATE_RUNNING,
    STATE_COMPUTING, /* on the way to a time that was asked for */
    STATE_ENDED,     /* at time.end, paused; the summary is shown */
    STATE_FAILED
} RunState;

typedef enum ReferencesShown { SHOW_ALL, SHOW_EXACT, SHOW_PREDICTED, SHOW_NONE, SHOW_COUNT } ReferencesShown;

typedef enum MessageKind { MESSAGE_NONE, MESSAGE_INFO, MESSAGE_WARNING, MESSAGE_ERROR } MessageKind;

/* Two runs share a picture, or each has its own. */
typedef enum DuelSide { SIDE_BOTH, SIDE_A, SIDE_B } DuelSide;

enum { SCENARIOS_MAX = 96, SCENARIO_NAME_MAX = 64 };

/* Scenarios to choose from while a name is asked for: those whose name or title holds what was typed. */
typedef struct ScenarioList {
    struct {
        char name[SCENARIO_NAME_MAX];
        char title[TITLE_MAX];
    } entries[SCENARIOS_MAX];
    int count;
    int shown[SCENARIOS_MAX]; /* indices of entries */
    int n_shown;
    int chosen; /* of those shown; -1: none */
    int open;   /* of those shown, the one that is on screen; -1: none */
} ScenarioList;

/* A line that asks for text, or for yes or no. */
typedef struct Prompt {
    bool open;
    bool yes_no;
    bool wants_y; /* of yes and no: Enter is no */
    char question[96];
    char text[256];
    int cursor;                    /* in characters */
    char problem[320];             /* why the last answer was refused; "" at first */
    char hint[320];                /* what may be answered; shown as long as nothing was refused */
    const ScenarioList *scenarios; /* above the line; NULL: none */
} Prompt;

enum { ROW_NEW = -1 };

/* One row of the parameter pane. */
typedef struct ParameterRow {
    const char *heading;        /* a heading, or NULL */
    const Parameter *parameter; /* an editable row, or NULL */
    int derived;                /* index of a read-only row, or -1 */
    bool is_row;                /* a row of a plate (scenario/rows/rows.h) */
    RowPlace place;             /* which one, or ROW_NEW: the place for one more; or one value of it */
} ParameterRow;

enum { LESSONS_MAX = 32 };

enum { PARAMETER_ROWS_MAX = 192 };

/* A place in the run: by time, for another mesh has other steps. */
typedef struct Bookmark {
    double time; /* of the whole step before it */
    int stage;
} Bookmark;

enum { BOOKMARKS_MAX = 9 };

typedef struct Bookmarks {
    Bookmark places[BOOKMARKS_MAX]; /* ascending */
    int count;
} Bookmarks;

/* The lesson beside the run, in place of the parameters. */
typedef struct LessonShown {
    bool open;
    const Lesson *lesson; /* NULL: the list of lessons */
    int chosen;           /* in the list */
    int page;
    int answer;        /* the choice that was taken; -1: none as yet */
    int marked;        /* the choice that the arrows stand on, which Enter takes; -1: none */
    bool met;          /* what the page waits for has happened */
    char verdict[320]; /* on the last answer, or the last run; "": none */
    bool verdict_right;
    bool counts; /* answers are somebody's homework: of a choice the first one is marked */
    int scroll;
    int reached[LESSONS_MAX]; /* per lesson of the program: pages that were turned to */
} LessonShown;

/* What can stand in the plot panes: views/view.h. */
typedef struct View View;

enum { VIEWS_MAX = 32 };

/* Which of its variants a view shows; of one that is not named, the first. */
typedef struct ViewVariant {
    const View *view;
    int variant;
} ViewVariant;

/* Typing a value into the selected parameter. */
typedef struct FieldEdit {
    bool open;
    char text[LIST_MAX];
    int cursor;        /* in characters */
    char problem[160]; /* why the last entry was refused */
} FieldEdit;

/* The things that all panes speak of. */
typedef struct Selection {
    size_t particle, node;
    bool is_node;     /* stage box and inspector follow the node, not the particle */
    int table_column; /* the one that is marked in a table */
} Selection;

/* Where one reads in the log. */
typedef struct LogPlace {
    int event; /* the chosen one; -1: the newest */
    int first; /* the first one shown, as far as that leaves the chosen one in sight */
} LogPlace;

/* What is seen of the map of a body. */
typedef struct MapEye {
    bool open;        /* arrows, + and - move it */
    double magnified; /* 1: the whole body */
    double centre[2]; /* shares of its length and height */
} MapEye;

/* What the player shows of itself. */
typedef struct Playback {
    RunState state;
    double pace;                /* steps per frame; FRAMES_PER_SECOND frames */
    double rate;                /* steps per frame that the engine reaches; shown where it is the limit */
    bool at_limit;              /* the engine is slower than the pace asked for */
    bool slow;                  /* STATE_PAUSED, but stage follows stage by itself */
    bool looping;               /* running comes back at the end of a stretch of time */
    char until[STOP_WORDS_MAX]; /* what it stops at; "": nothing */
    long until_step;            /* where that is; -1: not known */
    double work_share;          /* STATE_COMPUTING: share done */
    bool goes_on;               /* STATE_COMPUTING: once that is done the run goes on */
} Playback;

/* What a terminal can show, and what was asked for. */
typedef struct ScreenLook {
    Glyphs glyphs;
    int colours; /* 0: none; 8; 256 */
    bool light;  /* a light background */
} ScreenLook;

/* How much there is on the screen, in the order of parameter_sheet_words. */
typedef enum Sheet { SHEET_FULL, SHEET_PLAIN } Sheet;

/* Which panes there are and which one the keys go to. */
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

/* What stands in the two plot panes. */
typedef struct ViewsShown {
    const View *upper, *lower;
    ViewVariant variants[VIEWS_MAX];
    int n_variants;
    ReferencesShown references;
} ViewsShown;

/* A row of a plate (scenario/rows/rows.h) that is being moved on the map. */
enum { ROW_FIRST_END, ROW_SECOND_END, ROW_BOTH_ENDS, ROW_ENDS };

typedef struct RowsShown {
    bool placing;
    int kind, row;         /* which one */
    int end;               /* which of its ends the arrows move */
    const Settings *draft; /* while it is moved: with the row where it is now */
} RowsShown;

/* The parameter pane. */
typedef struct ParametersShown {
    RowsShown rows;
    int selected;    /* row */
    char filter[32]; /* parameters whose label or key holds it */
    FieldEdit edit;
} ParametersShown;

/* The axis of time. */
typedef struct TimeShown {
    double window; /* its length; 0: automatic */
    double cursor; /* the time of the plot's cursor; NAN: none */
} TimeShown;

typedef struct HelpShown {
    bool open;
    int page, scroll;
} HelpShown;

typedef struct Message {
    MessageKind kind;
    char text[512];
} Message;

typedef struct Screen {
    const Experiment *experiment; /* the run that is drawn; looking changes none */
    const Duel *duel;             /* whose A it is; its second run is drawn beside. NULL: there is none */
    DuelSide side;                /* a picture of one run of it only */
    const char *scenario;         /* name shown in the title line */

    ScreenLook look;
    Playback playback;
    PanesShown panes;
    ViewsShown views;
    TimeShown time;
    ParametersShown parameters;
    Selection chosen;
    LogPlace log;
    MapEye eye;
    Bookmarks bookmarks;
    const Convergence *convergence; /* what is known of the run's studies; NULL: nothing */
    const Overlay *overlay;         /* a foreign series over the plots; NULL: none */
    char diagnosis[700];            /* what is said of somebody's own code, in the box; "": nothing */

    LessonShown lesson;
    bool offers_lesson; /* to who is here for the first time, until a key is pressed */
    Prompt prompt;
    Message message;
    HelpShown help;

    CommandSet used; /* for hints that go once their command was used */
    bool summary_known;
    RunSummary summary;
} Screen;

enum { HELP_PAGES = 4 }; /* keys, curves, what is solved, where the papers are silent */

void screen_default(Screen *);

/* Takes over window, references and colour of the beam as far as a scenario names them. */
void screen_read_view(Screen *, const ViewSettings *);

/* Draws everything. Below 40x12 a message. Never fails: what has no room is left out by a fixed order. */
void screen_draw(const Screen *, Canvas *);

/* What stands in the plot panes when the run is opened: as the scenario says, else as the views like. */
void views_open(Screen *, const ViewSettings *);

/* The view in a pane; NULL: it is no plot pane. */
const View *screen_view_in(const Screen *, PaneId);

/* The rows of the parameter pane, for drawing and for moving in it. Returns how many. */
int screen_parameter_rows(const Screen *, ParameterRow rows[PARAMETER_ROWS_MAX]);

/* Whether a row of a plate, or the place for a new one, is chosen among them. */
bool screen_selected_row(const Screen *, RowPlace *);

/* Where a pane lies at this size; width 0: it is not shown. For focus and mouse. */
Rect screen_pane(const Screen *, int width, int height, PaneId);

/* Whether all panes of the sheet have room; on a smaller screen only the focused one, or the two plots, are
 * seen. */
bool screen_is_whole(const Screen *, int width, int height);

/* The command under column x of the key line, for the mouse; COMMAND_NONE: none. */
CommandId screen_key_command(const Screen *, int width, int x);

/* The mouse in the plot panes: a click on something that a view shows, and so many lines of the wheel. False:
 * nothing of a view lies there. */
bool screen_click_view(Screen *, int width, int height, int x, int y);
bool screen_scroll_view(Screen *, int width, int height, int x, int y, int by);

/* The chosen particle or, where a node is chosen, node: so many on. */
void selection_next(Selection *, const Simulation *, int direction, size_t by);

/* The settings whose rows the map shows: while one is moved those with it where it is now. Which row is
 * chosen in the parameter pane, if that has the focus; else kind -1. */
const Settings *screen_rows_shown(const Screen *, int *kind, int *row);

/* The arrows change this one or, where there is no row for it, the first one. */
void screen_select(Screen *, const Parameter *);

/* The row of the parameter pane at a place of the screen, for the mouse; -1: none. */
int screen_parameter_at(const Screen *, int width, int height, int x, int y);

/* How far the text of a lesson can be scrolled at this size; 0: all is seen. */
int screen_lesson_most(const Screen *, int width, int height);

/* Lessons in the list, and the one in a cell of it; -1: none. */
int screen_lesson_count(void);
int screen_lesson_at(const Screen *, int width, int height, int x, int y);

/* How many pages the help has, and how far the open one can be scrolled. */
int help_pages(void);
int help_most(const Screen *, int width, int height);

/* The step of a bookmark in the run as it is now. */
long screen_bookmark_step(const Screen *, int index);

/* The step that lies under a cell of the timeline, for the mouse; -1: the cell is not on it. */
long screen_timeline_step(const Screen *, int width, int height, int x, int y);

/* The step of the place of the timeline that is nearest to a column, in whatever row the mouse is. */
long screen_timeline_nearest(const Screen *, int width, int height, int x);

/* The particle that is looked at first: in the middle of a bar, of a beam's middle row. */
size_t screen_middle_particle(const Simulation *);

/* The place of the body, m, that is drawn in a cell of the screen as long as nothing has moved. False: no map
 * is drawn there. */
bool view_map_place(const Screen *, int width, int height, int x, int y, double place[2]);

/* The factor by which the beam's map draws displacements; 0: it is not shown. */
double view_map_enlargement(const Screen *, int width, int height);

/* The particle or node of the strip that is drawn nearest to a place of it becomes the chosen one. */
bool screen_choose_in_strip(Screen *, int width, int height, int x, int y);

/* The names of the curves on screen: of the plot over time, and of the field along the bar. */
const char *view_time_curve(const Screen *);
const char *view_profile_curve(const Screen *);

/* The time at the left and right end of the time plots, as drawn at present. */
void time_plot_window(const Screen *, double *from, double *to);

#endif

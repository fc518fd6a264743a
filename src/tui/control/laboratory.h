/* The laboratory's state and what changes it: keys and frames. A host (a terminal's event loop, a script)
 * owns clock and picture and calls in here; see session/laboratory_main.h for the door to the whole. */
#ifndef TUI_LABORATORY_H
#define TUI_LABORATORY_H

#include "base/output.h"
#include "lab/run/overlay.h"
#include "tui/terminal/keys.h"
#include "tui/control/session/laboratory_main.h"
#include "view/panes/screen.h"

#define FRAME_SECONDS 0.033 /* a frame is at most that long, so a key is answered within it */

enum { UNDO_MAX = 32, NAME_MAX_BYTES = 256, LINE_HISTORY_MAX = 32 };

/* What was entered behind `:`, the newest last. */
typedef struct LineHistory {
    char lines[LINE_HISTORY_MAX][sizeof((Prompt *)0)->text];
    char unfinished[sizeof((Prompt *)0)->text]; /* what was being typed when an earlier one was fetched */
    int count, at;                              /* at: the one on screen; count: the unfinished one */
} LineHistory;

typedef struct Laboratory Laboratory;
typedef struct Session Session;

/* Work whose speed is known apart: a run that goes on (of a duel: both), each run on its way to a time. */
enum { RATE_RUN, RATE_FIRST, RATE_SECOND, RATES };

/* What the laboratory asks of its host. */
typedef struct Host {
    double (*now)(void *context); /* seconds, only ever growing */
    /* `steps` time steps were done: lets a virtual clock go on. */
    void (*worked)(void *context, long steps);
    /* In the middle of work that cannot be cut into frames, screen.message says what: draw, look for ^C;
     * false: give up. While the laboratory is being opened there is nothing to draw. */
    bool (*go_on)(void *context);
    void (*redraw)(void *context);  /* everything anew */
    void (*suspend)(void *context); /* ^Z */
    void *context;
    bool (*key_waits)(
        void *context); /* the engine makes room for it at once; NULL: keys come between frames */
} Host;

enum { LESSON_QUEUE_MAX = 256 };

/* The lesson that is open, and what is still to be done for its page. */
typedef struct LessonPlay {
    Lesson lesson;
    char name[NAME_MAX_BYTES];
    const char *queue[LESSON_QUEUE_MAX];
    int n_queue, next;
    uint64_t used; /* bit i: command i has been used since the page was opened */
    bool warned;   /* that the page still waits */
    Asker asker;   /* who turned to the page */
    bool busy;
} LessonPlay;

/* Takes an answer to a prompt. False: refused, prompt.problem says why, the prompt stays. */
typedef bool (*Answer)(Laboratory *, const char *text);

/* What is special about typing the answer to one kind of question; each member may be NULL. */
typedef struct Completion Completion;
typedef struct Typing {
    bool (*key)(Laboratory *, const char *key);         /* false: the key does what it does everywhere */
    void (*offer)(Completion *, const Laboratory *lab); /* what Tab completes */
    void (*typed)(Laboratory *, const char *key);       /* the text has changed */
} Typing;

struct Laboratory {
    Screen screen;

    /* The tables of commands and of lines stand above all that they call; from there they are reached so. */
    void (*carry_out)(Laboratory *, CommandId);
    bool (*run_line)(Laboratory *, const char *line);

    Duel duel;         /* behind screen.duel */
    bool second_ended; /* that the second run stopped has been said */
    Host host;
    LaboratoryOptions options;
    int width, height; /* of the picture, for focus and mouse */
    bool focus_lent;   /* to the lower plot, while there is no room for all panes */
    bool utf8;         /* glyphs beyond ASCII can be shown */
    bool closed;       /* the user has left */

    Settings *undo, *redo; /* UNDO_MAX each, the newest last */
    int n_undo, n_redo;
    bool changed;    /* parameters were edited since the last export: quitting asks */
    double said_at;  /* when the message came */
    double built_at; /* when the building of a simulation began */
    bool fresh;      /* the text under edit is the old value: a first character replaces it */
    RunState resume; /* after computing: running or paused */
    long goal_step;  /* where computing goes */
    int goal_stage;
    double anchor_time;  /* the time that edits in a row come back to, */
    long anchor_step;    /* and the step that it was at the last of them; -1: none */
    long work_total;     /* steps of the work under way when it began */
    long run_limit;      /* running does not go beyond this step; -1: none */
    Asker asker;         /* on whose behalf the laboratory does what it does now */
    Session *recording;  /* notes every key; NULL: none */
    double owed;         /* steps not yet done for the pace; less than one */
    bool pace_automatic; /* + and - were not used */
    double rates[RATES]; /* steps per second of the engine alone; 0: not known */
    bool in_parts;       /* a step that takes long is under way, in parts: nothing new to look at as yet */
    double part_seconds; /* what it has taken so far */
    int frames_in_time;  /* since the engine was last the limit */
    enum { DRAG_NOTHING, DRAG_VALUE, DRAG_TIME } drag; /* what the pressed mouse holds */
    int drag_x;                                        /* where it was nudged last */
    bool pasted_line; /* a pasted line has ended; what is pasted behind it is another word */
    Answer answer;
    const Typing *typing;   /* NULL: nothing special */
    int suggestion;         /* for a duel, the one that is offered; -1: what was the last one's */
    int tabbed;             /* candidates that Tab has shown; the next Tab shows those behind them */
    ScenarioList scenarios; /* behind screen.prompt.scenarios */
    LineHistory past;
    LessonPlay play;
    Overlay overlay; /* behind screen.overlay */
    char export_name[NAME_MAX_BYTES];
    bool export_newest; /* the export that is being asked for goes to the newest step, not to here */
    char scenario[NAME_MAX_BYTES]; /* behind screen.scenario */
};

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

/* One frame's share of the engine's work, until `deadline` at the latest (by the host's clock). False: there
 * is nothing new to be drawn, for a step that takes longer than the frame goes on; to draw now would throw
 * away what has been done of it. */
bool laboratory_frame(Laboratory *, double deadline);

/* Draws on a canvas of this size. */
bool laboratory_draw(Laboratory *, Canvas *, int width, int height);

/* --- between the files of the laboratory ------------------------------------------------------------- */

void say(Laboratory *, MessageKind, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* The state after a change: at the end, failed, computing, ... */
void settle(Laboratory *);
void pause_run(Laboratory *);

/* Back to where the step that is done in parts began, for whoever wants to look or to do something else. */
void drop_part(Laboratory *);
void seek(Laboratory *, long step, int stage);

/* duel_change(); the chosen particle stays the one nearest to where it was at first. */
bool change_runs(Laboratory *, const Settings *, DuelChange, Status *);

/* New parameters, undoable. False: refused, the status says why. */
bool change_settings(Laboratory *, const Settings *, DuelChange, Status *);
void settings_changed(Laboratory *); /* what follows from it */
bool open_scenario(Laboratory *, const char *name, Status *);

/* opening.c: a run is made, and put in the place of another. */
Experiment *make_experiment(const Laboratory *, const Settings *, Status *);
void show_building_of(Laboratory *, Settings *); /* how far its building has come; copies of them do too */
void begin_run(Laboratory *); /* what belongs to a run and not to the way it is looked at */
void name_scenario(Laboratory *, const char *name);

void choose_pace(Laboratory *);

/* Where the steps of a key begin: the place on screen, or where the work on the way will end. */
void present(const Laboratory *, long *step, int *stage);

void show_view(Laboratory *, const View *);
void show_digit(Laboratory *, int digit); /* the view that has this key */
const Parameter *selected_parameter(const Laboratory *);
void move_selection(Laboratory *, int rows);
void nudge_selected(Laboratory *, int direction);
void begin_edit(Laboratory *);
void edit_key(Laboratory *, const Key *);

/* map_commands.c: the map of a beam. */
void map_zoom(Laboratory *);  /* begins to magnify it, or ends that */
void map_whole(Laboratory *); /* ends it */
void map_magnify(Laboratory *, int direction);
void map_pan(Laboratory *, int x, int y);
bool map_is_focused(const Laboratory *);
void map_enlarge(Laboratory *, int direction); /* displacements; 0: automatic */

double next_125(double value, int direction); /* the next number of 1, 2, 5, 10, ... above or below */

void ask(Laboratory *, Answer, bool yes_no, const char *text, const char *format, ...)
    __attribute__((format(printf, 5, 6)));
void fill_prompt(Laboratory *, const char *text); /* in place of what was typed; typing replaces it */
void close_prompt(Laboratory *);
void prompt_key(Laboratory *, const Key *);

/* complete.c: Tab, and what it offers in the questions that have something to offer. */
void complete_prompt(Laboratory *);
void complete_line(Completion *, const Laboratory *);
void complete_assignments(Completion *, const Laboratory *); /* KEY=VALUE ... */
void complete_scenarios(Completion *, const Laboratory *);
void complete_files(Completion *, const Laboratory *);

void ask_line(Laboratory *);

/* A second run beside the first: begins with the scenario's keys, or ends it; asks where there are no keys.
 */
void toggle_duel(Laboratory *);
void open_duel(Laboratory *);                      /* of a scenario that has keys for one */
bool answer_duel(Laboratory *, const char *words); /* "KEY=VALUE ..." */
void tell_second(Laboratory *);                    /* says once that the second run stopped */
void duel_over(Laboratory *, const Status *);      /* says so if a change ended it, and why */

/* Whether who asks may write a file; if not, that is said. */
bool may_write(Laboratory *, const char *name);

/* Asks whether a file that exists is replaced: only y does. */
void ask_replace(Laboratory *, Answer, const char *name);

/* An answer that is the name of a file: whether it can be one. If not, the prompt stays and says why. */
bool name_can_be(Laboratory *, const char *name);

/* lesson_play.c */

/* Raises the pages that were reached to those of the file. False: it may hold more than could be read, or
 * there is no home. */
bool read_progress(int reached[LESSONS_MAX]);
bool open_lesson(Laboratory *, const char *name, Status *);
bool answer_lesson(Laboratory *, const char *text);
void close_lesson(Laboratory *);
void toggle_lessons(Laboratory *);
bool lesson_key(Laboratory *, const Key *); /* false: it is not for the lesson */
void move_in_lesson(Laboratory *, int x, int y);
void enter_in_lesson(Laboratory *);            /* opens the chosen one, or edits a field of the page */
bool click_lesson(Laboratory *, int x, int y); /* false: there is none in that cell */
void continue_lesson(Laboratory *); /* what is left to be done, once the run has come to where it should be */

/* Says in the question that is open why its answer is not taken; returns false. */
bool refuse(Laboratory *, const char *why);

/* The focused view as a figure. False: refused, as an answer to a prompt. */
bool draw_figure(Laboratory *, const char *file);

/* Asks how far and under which name, as far as that is not known; `name` "": it is asked for. False: refused.
 */
bool ask_export(Laboratory *, const char *name);
bool answer_go_to(Laboratory *, const char *text);
bool answer_open(Laboratory *, const char *text);

/* scenario_prompt.c: asks which scenario, with a list to choose from. */
void ask_scenario(Laboratory *);
bool answer_write(Laboratory *, const char *text);
bool run_line(Laboratory *, const char *line); /* the same without remembering it */
bool answer_filter(Laboratory *, const char *text);

#endif

/* What each command does: one function each, found by its id. */
#include "base/text.h"
#include "tui/control.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef void (*Carry)(Laboratory *);

#define AGAIN_SECONDS 2.0 /* of computing; a finished run that took longer is not given up unasked */

/* --- time ------------------------------------------------------------------------------------------- */

/* To t = 0 with the same parameters. */
static void begin_again(Laboratory *lab, bool running)
{
    Status status = {STATUS_DONE, ""};
    if (!duel_restart(&lab->duel, false, &status)) {
        say(lab, MESSAGE_ERROR, "%s", status.text);
        return;
    }
    say(lab, MESSAGE_NONE, "%s", "");
    lab->resume = running ? STATE_RUNNING : STATE_PAUSED;
    lab->owed = 0;
    lab->screen.summary_known = false;
    lab->screen.cursor_time = NAN;
    settle(lab);
    duel_over(lab, &status);
}

static bool answer_again(Laboratory *lab, const char *text)
{
    (void)text;
    begin_again(lab, true);
    return true;
}

/* A run that is soon computed again begins anew at once; one that took long is not thrown away by a slip. */
static void run_again(Laboratory *lab)
{
    const double rate = lab->rates[RATE_RUN];
    double seconds = rate > 0 ? (double)experiment_last_step(lab->screen.experiment) / rate : 0;
    char takes[NUMBER_TEXT_MAX];
    if (seconds < AGAIN_SECONDS) {
        begin_again(lab, true);
        return;
    }
    text_rounded(takes, seconds, 2);
    ask(lab, answer_again, true, "", "run again from t = 0? it takes about %s s", takes);
}

static void run_or_pause(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    if (screen->state == STATE_ENDED)
        run_again(lab);
    else if (screen->state == STATE_FAILED)
        say(lab, MESSAGE_INFO, "the run cannot go on: change a parameter, step back, or r to begin again");
    else if (screen->state == STATE_COMPUTING)
        lab->resume = lab->resume == STATE_RUNNING ? STATE_PAUSED : STATE_RUNNING;
    else if (screen->state == STATE_RUNNING)
        pause_run(lab);
    else {
        lab->resume = STATE_RUNNING;
        lab->owed = 0;
        screen->rate = 0;
        settle(lab);
    }
}

/* A step that has begun counts as one of those that are done. */
static void step_by(Laboratory *lab, long steps)
{
    long step;
    int stage;
    present(lab, &step, &stage);
    pause_run(lab);
    if (steps < 0 && stage > 0)
        steps++;
    if (steps < 0 && step == 0 && stage == 0)
        say(lab, MESSAGE_INFO, "this is t = 0");
    else if (steps > 0 && step >= experiment_last_step(lab->screen.experiment))
        say(lab, MESSAGE_INFO, "this is the end of the run");
    else
        seek(lab, step + steps, 0);
}

static void step_forward(Laboratory *lab)
{
    step_by(lab, 1);
}

static void step_back(Laboratory *lab)
{
    step_by(lab, -1);
}

static void step_forward_ten(Laboratory *lab)
{
    step_by(lab, 10);
}

static void step_back_ten(Laboratory *lab)
{
    step_by(lab, -10);
}

static void stage_forward(Laboratory *lab)
{
    Experiment *experiment = lab->screen.experiment;
    long step;
    int stage;
    present(lab, &step, &stage);
    pause_run(lab);
    if (experiment_at_end(experiment)) {
        say(lab, MESSAGE_INFO, "this is the end of the run");
        return;
    }
    if (lab->screen.state == STATE_COMPUTING) {
        bool whole = stage + 1 >= experiment_simulation(experiment)->n_stages;
        seek(lab, whole ? step + 1 : step, whole ? 0 : stage + 1);
        return;
    }
    Status status = {STATUS_DONE, ""};
    duel_next_stage(&lab->duel, &status);
    settle(lab);
    if (status.text[0])
        say(lab, MESSAGE_ERROR, "%s", status.text);
    else if (lab->duel.b && experiment_stage(experiment) == 1)
        say(lab, MESSAGE_INFO, "A goes by stages; B waits at its step %ld, before A's step ends",
            experiment_step(lab->duel.b));
}

static void stage_back(Laboratory *lab)
{
    long step;
    int stage;
    present(lab, &step, &stage);
    pause_run(lab);
    if (stage > 0)
        seek(lab, step, stage - 1);
    else if (step > 0)
        seek(lab, step - 1, experiment_simulation(lab->screen.experiment)->n_stages - 1);
    else
        say(lab, MESSAGE_INFO, "this is t = 0");
}

double next_125(double value, int direction)
{
    static const double mantissas[] = {1, 2, 5};
    double best = 0;
    for (int decade = -3; decade <= 9; decade++)
        for (int i = 0; i < 3; i++) {
            double candidate = mantissas[i] * pow(10, decade);
            if (direction > 0 && candidate > value * (1 + 1e-9) && (best <= 0 || candidate < best))
                best = candidate;
            if (direction < 0 && candidate < value * (1 - 1e-9) && candidate > best)
                best = candidate;
        }
    return best > 0 ? best : value;
}

static void change_pace(Laboratory *lab, int direction)
{
    Screen *screen = &lab->screen;
    if (screen->zooming && map_is_focused(lab)) {
        map_magnify(lab, direction);
        return;
    }
    double pace = next_125(screen->pace, direction);
    if (pace < 0.01 || pace > 1e7)
        return;
    screen->pace = pace;
    screen->at_limit = false;
    lab->pace_automatic = false;
    lab->owed = 0;
    if (pace >= 1)
        say(lab, MESSAGE_INFO, "%g steps a frame", pace);
    else
        say(lab, MESSAGE_INFO, "a step every %g frames", round(1 / pace));
}

static void faster(Laboratory *lab)
{
    change_pace(lab, 1);
}

static void slower(Laboratory *lab)
{
    change_pace(lab, -1);
}

static void to_start(Laboratory *lab)
{
    pause_run(lab);
    seek(lab, 0, 0);
}

static void to_newest(Laboratory *lab)
{
    pause_run(lab);
    seek(lab, experiment_newest(lab->screen.experiment), 0);
}

static void go_to(Laboratory *lab)
{
    ask(lab, answer_go_to, false, "", "go to time (or #step)");
}

static void restart(Laboratory *lab)
{
    bool computing = lab->screen.state == STATE_COMPUTING;
    begin_again(lab, (computing ? lab->resume : lab->screen.state) == STATE_RUNNING);
}

/* The first bookmark that is not before a place. */
static int bookmark_from(const Screen *screen, long step, int stage)
{
    int at = 0;
    while (at < screen->n_bookmarks &&
           (screen_bookmark_step(screen, at) < step ||
            (screen_bookmark_step(screen, at) == step && screen->bookmarks[at].stage < stage)))
        at++;
    return at;
}

static bool is_bookmark(const Screen *screen, int at, long step, int stage)
{
    return at < screen->n_bookmarks && screen_bookmark_step(screen, at) == step &&
           screen->bookmarks[at].stage == stage;
}

/* Where there is one already it is taken away. */
static void bookmark(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    long step;
    int stage;
    present(lab, &step, &stage);
    const int at = bookmark_from(screen, step, stage);
    Bookmark *place = &screen->bookmarks[at];
    const size_t after = (size_t)(screen->n_bookmarks - at);
    if (is_bookmark(screen, at, step, stage)) {
        memmove(place, place + 1, (after - 1) * sizeof *place);
        screen->n_bookmarks--;
        say(lab, MESSAGE_INFO, "the bookmark at step %ld is gone", step);
    } else if (screen->n_bookmarks == BOOKMARKS_MAX) {
        say(lab, MESSAGE_INFO, "there is room for %d bookmarks: m on one of them takes it away",
            BOOKMARKS_MAX);
    } else {
        memmove(place + 1, place, after * sizeof *place);
        *place = (Bookmark){(double)step * experiment_simulation(screen->experiment)->dt, stage};
        screen->n_bookmarks++;
        say(lab, MESSAGE_INFO, "bookmark at step %ld: ' comes back here, m again takes it away", step);
    }
}

/* To the next one in the run, from the last one to the first. */
static void jump(Laboratory *lab)
{
    const Screen *screen = &lab->screen;
    const int n_stages = experiment_simulation(screen->experiment)->n_stages;
    long step;
    int stage;
    if (screen->n_bookmarks == 0) {
        say(lab, MESSAGE_INFO, "no bookmark yet: m sets one");
        return;
    }
    present(lab, &step, &stage);
    int at = bookmark_from(screen, step, stage);
    at += is_bookmark(screen, at, step, stage);
    at %= screen->n_bookmarks;
    stage = screen->bookmarks[at].stage;
    pause_run(lab);
    seek(lab, screen_bookmark_step(screen, at), stage < n_stages ? stage : 0);
    if (screen->n_bookmarks > 1)
        say(lab, MESSAGE_INFO, "bookmark %d of %d", at + 1, screen->n_bookmarks);
}

/* --- moving about ----------------------------------------------------------------------------------- */

static void focus_by(Laboratory *lab, int direction)
{
    Screen *screen = &lab->screen;
    Screen whole = *screen;
    whole.zoomed = false; /* a pane that fills the screen can be left for any that the whole picture has */
    int focus = (int)screen->focus;
    for (int i = 0; i < PANE_COUNT; i++) {
        focus = (focus + direction + PANE_COUNT) % PANE_COUNT;
        whole.focus = (PaneId)focus; /* a small screen has the one that is asked for */
        if (screen_pane(&whole, lab->width, lab->height, (PaneId)focus).width > 0)
            break;
    }
    screen->focus = (PaneId)focus;
    screen->cursor_time = NAN;
}

static void next_pane(Laboratory *lab)
{
    focus_by(lab, 1);
}

static void previous_pane(Laboratory *lab)
{
    focus_by(lab, -1);
}

static void choose_particle(Laboratory *lab, int direction, size_t by)
{
    Screen *screen = &lab->screen;
    const Simulation *simulation = experiment_simulation(screen->experiment);
    bool node = screen->node_chosen && simulation->n_sets > 1;
    size_t *chosen = node ? &screen->node : &screen->particle;
    size_t count = simulation->counts[node ? 1 : 0];
    if (count == 0)
        return;
    if (direction < 0)
        *chosen = *chosen > by ? *chosen - by : 0;
    else
        *chosen = *chosen + by < count ? *chosen + by : count - 1;
}

static int view_in(const Screen *screen, PaneId pane)
{
    return pane == PANE_UPPER ? screen->upper : pane == PANE_LOWER ? screen->lower : 0;
}

static bool is_time_plot(int view)
{
    return view == 2 || view == 3;
}

/* Moves the cursor of a time plot by about a column. */
static void move_cursor(Laboratory *lab, int columns)
{
    Screen *screen = &lab->screen;
    double from, to;
    screen_time_window(screen, &from, &to);
    int width = screen_pane(screen, lab->width, lab->height, screen->focus).width - 10;
    double column = (to - from) / (width > 20 ? width : 20);
    if (isnan(screen->cursor_time))
        screen->cursor_time = experiment_time(screen->experiment);
    else
        screen->cursor_time += columns * column;
    if (screen->cursor_time < from)
        screen->cursor_time = from;
    if (screen->cursor_time > to)
        screen->cursor_time = to;
}

enum { TABLE_VIEW = 7, LOG_VIEW = 9 };

static void move(Laboratory *lab, int x, int y, int page)
{
    Screen *screen = &lab->screen;
    int view = view_in(screen, screen->focus);
    const bool map = map_is_focused(lab);
    if (screen->zooming && map) {
        map_pan(lab, x, y);
        return;
    }
    if ((screen->focus == PANE_INSPECTOR || map) && screen_move_inspector(screen, x, y, page))
        return;
    if (screen->focus == PANE_PARAMETERS && screen->lesson.open) {
        move_in_lesson(lab, x, y);
    } else if (screen->focus == PANE_PARAMETERS) {
        if (x)
            nudge_selected(lab, x);
        else
            move_selection(lab, y * page);
    } else if (view == TABLE_VIEW) {
        /* the rows are those of the set that the table shows */
        const int sets = experiment_simulation(screen->experiment)->n_sets;
        screen->node_chosen = screen->variant[TABLE_VIEW] % sets == 1;
        if (y)
            choose_particle(lab, y, (size_t)page);
        else
            screen_scroll_table(screen, lab->width, lab->height, x);
    } else if (view == LOG_VIEW) {
        if (y)
            screen_move_in_log(screen, lab->width, lab->height, y * page);
    } else if (is_time_plot(view)) {
        move_cursor(lab, x ? x : y * page);
    } else if (x || page > 1) {
        screen->node_chosen &= experiment_simulation(screen->experiment)->method->shapes != NULL;
        choose_particle(lab, x ? x : y, (size_t)page);
    } else {
        screen_choose_across(screen, y < 0);
    }
}

static void up(Laboratory *lab)
{
    move(lab, 0, -1, 1);
}

static void down(Laboratory *lab)
{
    move(lab, 0, 1, 1);
}

static void left(Laboratory *lab)
{
    move(lab, -1, 0, 1);
}

static void right(Laboratory *lab)
{
    move(lab, 1, 0, 1);
}

static void page_up(Laboratory *lab)
{
    move(lab, 0, -1, 10);
}

static void page_down(Laboratory *lab)
{
    move(lab, 0, 1, 10);
}

static void enter(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    if (screen->focus == PANE_PARAMETERS) {
        if (!screen->lesson.open ||
            (screen->lesson.lesson && screen->lesson.lesson->pages[screen->lesson.page].n_fields > 0))
            begin_edit(lab);
    } else if (is_time_plot(view_in(screen, screen->focus)) && !isnan(screen->cursor_time)) {
        pause_run(lab);
        seek(lab, lround(screen->cursor_time / experiment_simulation(screen->experiment)->dt), 0);
        screen->cursor_time = NAN;
    } else if (view_in(screen, screen->focus) == LOG_VIEW && screen_log_chosen(screen) >= 0) {
        const long step = screen_log_step(screen), broken = screen_broken_node(screen, step);
        if (broken >= 0) { /* where it happened is what one wants to look at */
            screen->particle = (size_t)broken;
            screen->node_chosen = false;
        }
        pause_run(lab);
        seek(lab, step, 0);
    }
}

static void close_inspector(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    screen->inspecting = false;
    screen->zoomed = false;
    if (screen->focus == PANE_INSPECTOR)
        screen->focus = screen->before_inspector;
}

static void inspect(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    if (screen->inspecting) {
        close_inspector(lab);
    } else if (!screen_has_inspector(screen)) {
        say(lab, MESSAGE_INFO, "there is no inspector for this method");
    } else {
        screen->inspecting = true;
        screen->before_inspector = screen->focus;
        screen->focus = PANE_INSPECTOR;
        screen->cursor_time = NAN;
    }
}

/* Closes what lies on top; false: there is nothing. */
static bool close_top(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    if (screen->help)
        screen->help = false;
    else if (screen->prompt.open)
        close_prompt(lab);
    else if (screen->editing)
        screen->editing = false;
    else if (!isnan(screen->cursor_time))
        screen->cursor_time = NAN;
    else if (screen->zooming)
        map_whole(lab);
    else if (screen->zoomed)
        screen->zoomed = false;
    else if (screen->inspecting)
        close_inspector(lab);
    else if (screen->filter[0])
        screen->filter[0] = '\0';
    else
        return false;
    return true;
}

static void cancel(Laboratory *lab)
{
    if (lab->screen.state == STATE_COMPUTING) {
        duel_cancel(&lab->duel);
        pause_run(lab);
    } else
        close_top(lab);
}

/* --- views ------------------------------------------------------------------------------------------ */

/* Pictures over x are at home above, pictures over time below. */
static PaneId home_of(int view)
{
    return view == 1 || view == 4 || view == 7 || view == 8 ? PANE_UPPER : PANE_LOWER;
}

void show_view(Laboratory *lab, int view)
{
    Screen *screen = &lab->screen;
    const char *missing = screen_view_missing(screen, view);
    if (missing) {
        say(lab, MESSAGE_INFO, "view %d: %s", view, missing);
        return;
    }
    if (screen->inspecting) /* it lies over the plots: who asks for one wants to see it */
        close_inspector(lab);
    bool in_plot = screen->focus == PANE_UPPER || screen->focus == PANE_LOWER;
    if (screen->upper == view || screen->lower == view) {
        PaneId at = in_plot && view_in(screen, screen->focus) == view ? screen->focus
                    : screen->upper == view                           ? PANE_UPPER
                                                                      : PANE_LOWER;
        if (screen->zoomed && screen->focus != at)
            screen->focus = at;
        else
            screen->variant[view]++;
        return;
    }
    PaneId pane = in_plot ? screen->focus : home_of(view);
    if (pane == PANE_UPPER)
        screen->upper = view;
    else
        screen->lower = view;
    if (screen->zoomed)
        screen->focus = pane;
    screen->table_column = 0;
    screen->cursor_time = NAN;
}

static void zoom(Laboratory *lab)
{
    lab->screen.zoomed = !lab->screen.zoomed;
}

static void lecture(Laboratory *lab)
{
    lab->screen.lecture = !lab->screen.lecture;
    if (lab->screen.lecture && lab->screen.lesson.open)
        say(lab, MESSAGE_INFO, "a lesson keeps its page; the rest gets large when T closes it");
    else if (lab->screen.lecture && !screen_is_whole(lab->width, lab->height))
        say(lab, MESSAGE_INFO, "large letters want 80x24 at least; the curves are thick");
}

static void change_window(Laboratory *lab, int direction)
{
    Screen *screen = &lab->screen;
    double from, to;
    if (map_is_focused(lab)) {
        map_enlarge(lab, direction);
        return;
    }
    screen_time_window(screen, &from, &to);
    double length = screen->window > 0 ? screen->window : to - from;
    const double dt = experiment_simulation(screen->experiment)->dt, least = 10 * dt;
    const double end = dt * (double)experiment_last_step(screen->experiment);
    double window = next_125(length, direction);
    /* the table of 1, 2, 5 does not reach into the microseconds of a crack */
    if (length < 1e-2)
        window = 1e-6 * next_125(1e6 * length, direction);
    if (window < least || (direction > 0 && length >= end)) {
        say(lab, MESSAGE_INFO,
            direction < 0 ? "the time window has ten steps, no fewer"
                          : "the time window holds the whole run");
        return;
    }
    screen->window = window;
    if (experiment_settings(screen->experiment)->problem == PROBLEM_BAR)
        say(lab, MESSAGE_INFO, "time window %g", window);
    else
        say(lab, MESSAGE_INFO, "time window %g ms", window / 1e-3);
}

static void narrower(Laboratory *lab)
{
    change_window(lab, -1);
}

static void wider(Laboratory *lab)
{
    change_window(lab, 1);
}

static void automatic(Laboratory *lab)
{
    if (map_is_focused(lab)) {
        map_enlarge(lab, 0);
        return;
    }
    lab->screen.window = 0;
    say(lab, MESSAGE_INFO, "time window automatic");
}

static void cycle_references(Laboratory *lab)
{
    static const char *const texts[SHOW_COUNT] = {"all", "exact only", "predicted only", "none"};
    lab->screen.references = (ReferencesShown)((lab->screen.references + 1) % SHOW_COUNT);
    say(lab, MESSAGE_INFO, "reference curves: %s", texts[lab->screen.references]);
}

static void cycle_glyphs(Laboratory *lab)
{
    static const char *const texts[GLYPHS_COUNT] = {"braille", "block", "ASCII"};
    if (!lab->utf8) {
        say(lab, MESSAGE_INFO, "this locale has ASCII only");
        return;
    }
    lab->screen.glyphs = (Glyphs)((lab->screen.glyphs + 1) % GLYPHS_COUNT);
    say(lab, MESSAGE_INFO, "glyphs: %s", texts[lab->screen.glyphs]);
}

/* --- comparing -------------------------------------------------------------------------------------- */

/* In a duel the other answer is on screen already: on to one that is not. */
static bool is_second(const Laboratory *lab, const Settings *settings, const Parameter *parameter)
{
    const Experiment *second = lab->duel.b;
    return second &&
           settings_number(settings, parameter) == settings_number(experiment_settings(second), parameter);
}

/* "cell size 1 -> 0.5, from t = 0 on; a: before" */
static void say_answer(Laboratory *lab, const Parameter *parameter, const Settings *before)
{
    const Experiment *experiment = lab->screen.experiment;
    const Ghost *ghosts = experiment_ghosts(experiment);
    char from[LIST_MAX], to[LIST_MAX], ghost[24] = "";
    settings_show(before, parameter, from);
    settings_show(experiment_settings(experiment), parameter, to);
    for (int i = 0; i < GHOSTS_MAX; i++)
        if (ghosts[i].used && !ghosts[i].pinned)
            snprintf(ghost, sizeof ghost, "; %c: before", ghosts[i].letter);
    say(lab, MESSAGE_INFO, "%s%s %.60s -> %.60s, from t = 0 on%s", lab->duel.b ? "A: " : "", parameter->label,
        from, to, ghost);
}

/* Another run beside this one: what the scenario asks about holds from t = 0 on. */
static void question(Laboratory *lab)
{
    Settings settings = *experiment_settings(lab->screen.experiment);
    const Settings before = settings;
    const Parameter *parameter = settings_question(&settings);
    Status status = {STATUS_DONE, ""};
    if (!parameter || !settings_answer_otherwise(&settings, parameter))
        say(lab, MESSAGE_INFO, "this scenario asks no question");
    else if (is_second(lab, &settings, parameter) &&
             (!settings_nudge(&settings, parameter, 1) || settings_same(&before, &settings, NULL, 0)))
        say(lab, MESSAGE_INFO, "both answers are on screen already; d ends the duel");
    else if (!change_settings(lab, &settings, experiment_rerun, &status))
        say(lab, MESSAGE_ERROR, "%s", status.text);
    else if (lab->screen.message_kind == MESSAGE_NONE)
        say_answer(lab, parameter, &before);
}

static int pinned(const Experiment *experiment)
{
    const Ghost *ghosts = experiment_ghosts(experiment);
    int count = 0;
    for (int i = 0; i < GHOSTS_MAX; i++)
        count += ghosts[i].used && ghosts[i].pinned;
    return count;
}

static void pin(Laboratory *lab)
{
    Status status = {STATUS_DONE, ""};
    int had = pinned(lab->screen.experiment);
    if (!experiment_pin(lab->screen.experiment, &status))
        say(lab, MESSAGE_ERROR, "%s", status.text);
    else if (pinned(lab->screen.experiment) > had)
        say(lab, MESSAGE_INFO, "these curves stay as a ghost; c again takes them away");
    else
        say(lab, MESSAGE_INFO, "the ghost of these curves is gone");
}

static void swap_settings(Laboratory *lab, Settings *from, int *n_from, Settings *to, int *n_to,
                          const char *none)
{
    Status status = {STATUS_DONE, ""};
    if (*n_from == 0) {
        say(lab, MESSAGE_INFO, "%s", none);
        return;
    }
    Settings old = *experiment_settings(lab->screen.experiment);
    if (!change_runs(lab, &from[*n_from - 1], experiment_replace, &status)) {
        say(lab, MESSAGE_ERROR, "%s", status.text);
        return;
    }
    to[(*n_to)++] = old;
    --*n_from;
    settings_changed(lab);
    duel_over(lab, &status);
}

static void undo(Laboratory *lab)
{
    swap_settings(lab, lab->undo, &lab->n_undo, lab->redo, &lab->n_redo, "nothing to undo");
}

static void redo(Laboratory *lab)
{
    swap_settings(lab, lab->redo, &lab->n_redo, lab->undo, &lab->n_undo, "nothing to redo");
}

/* --- files, help, leaving --------------------------------------------------------------------------- */

static void open_file(Laboratory *lab)
{
    ask_scenario(lab);
}

static void write_file(Laboratory *lab)
{
    char name[NAME_MAX_BYTES];
    snprintf(name, sizeof name, "%.200s%s", lab->scenario, strchr(lab->scenario, '.') ? "" : ".ini");
    ask(lab, answer_write, false, name, "write scenario to");
}

static void export_run_as_files(Laboratory *lab)
{
    ask_export(lab, "");
}

static void filter(Laboratory *lab)
{
    if (lab->screen.inspecting)
        close_inspector(lab);
    lab->screen.focus = PANE_PARAMETERS;
    ask(lab, answer_filter, false, lab->screen.filter, "parameters whose name holds");
}

static void help(Laboratory *lab)
{
    lab->screen.help = true;
    lab->screen.help_page = lab->screen.help_scroll = 0;
}

static void quit(Laboratory *lab)
{
    if (close_top(lab))
        return;
    if (lab->changed)
        ask(lab, answer_quit, true, "", "parameters were changed and nothing was exported: leave?");
    else
        lab->closed = true;
}

static void interrupt(Laboratory *lab)
{
    if (lab->screen.state == STATE_COMPUTING) {
        duel_cancel(&lab->duel);
        pause_run(lab);
        say(lab, MESSAGE_INFO, "cancelled");
    } else if (lab->screen.prompt.open && lab->answer == answer_quit)
        lab->closed = true; /* whoever presses it twice means it */
    else if (!close_top(lab))
        quit(lab);
}

static void redraw(Laboratory *lab)
{
    lab->host.redraw(lab->host.context);
}

static void suspend(Laboratory *lab)
{
    lab->host.suspend(lab->host.context);
}

static const Carry carries[COMMAND_COUNT] = {
    [COMMAND_RUN_PAUSE] = run_or_pause,
    [COMMAND_STEP_FORWARD] = step_forward,
    [COMMAND_STEP_BACK] = step_back,
    [COMMAND_STEP_FORWARD_TEN] = step_forward_ten,
    [COMMAND_STEP_BACK_TEN] = step_back_ten,
    [COMMAND_STAGE_FORWARD] = stage_forward,
    [COMMAND_STAGE_BACK] = stage_back,
    [COMMAND_FASTER] = faster,
    [COMMAND_SLOWER] = slower,
    [COMMAND_START] = to_start,
    [COMMAND_NEWEST] = to_newest,
    [COMMAND_GO_TO] = go_to,
    [COMMAND_RESTART] = restart,
    [COMMAND_NEXT_PANE] = next_pane,
    [COMMAND_PREVIOUS_PANE] = previous_pane,
    [COMMAND_UP] = up,
    [COMMAND_DOWN] = down,
    [COMMAND_LEFT] = left,
    [COMMAND_RIGHT] = right,
    [COMMAND_PAGE_UP] = page_up,
    [COMMAND_PAGE_DOWN] = page_down,
    [COMMAND_ENTER] = enter,
    [COMMAND_CANCEL] = cancel,
    [COMMAND_UNDO] = undo,
    [COMMAND_REDO] = redo,
    [COMMAND_INSPECT] = inspect,
    [COMMAND_ZOOM] = zoom,
    [COMMAND_ZOOM_2D] = map_zoom,
    [COMMAND_NARROWER] = narrower,
    [COMMAND_WIDER] = wider,
    [COMMAND_AUTOMATIC] = automatic,
    [COMMAND_REFERENCES] = cycle_references,
    [COMMAND_QUESTION] = question,
    [COMMAND_PIN] = pin,
    [COMMAND_DUEL] = toggle_duel,
    [COMMAND_BOOKMARK] = bookmark,
    [COMMAND_JUMP] = jump,
    [COMMAND_LESSONS] = toggle_lessons,
    [COMMAND_EXPORT] = export_run_as_files,
    [COMMAND_OPEN] = open_file,
    [COMMAND_WRITE] = write_file,
    [COMMAND_LINE] = ask_line,
    [COMMAND_HELP] = help,
    [COMMAND_GLYPHS] = cycle_glyphs,
    [COMMAND_LECTURE] = lecture,
    [COMMAND_FILTER] = filter,
    [COMMAND_QUIT] = quit,
    [COMMAND_INTERRUPT] = interrupt,
    [COMMAND_REDRAW] = redraw,
    [COMMAND_SUSPEND] = suspend,
};

bool laboratory_can(CommandId id)
{
    return (id >= COMMAND_VIEW_1 && id <= COMMAND_VIEW_9) ||
           (id > COMMAND_NONE && id < COMMAND_COUNT && carries[id]);
}

void laboratory_command(Laboratory *lab, CommandId id)
{
    if (!laboratory_can(id))
        return;
    lab->screen.used |= (uint64_t)1 << id;
    lab->play.used |= (uint64_t)1 << id;
    if (id >= COMMAND_VIEW_1 && id <= COMMAND_VIEW_9)
        show_view(lab, (int)(id - COMMAND_VIEW_1) + 1);
    else
        carries[id](lab);
}

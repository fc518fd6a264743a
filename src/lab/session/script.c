/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The script player: a table of instructions over a laboratory with a virtual clock. */
#include "lab/session/script.h"
#include "base/wait.h"

#include "scenario/concern_time.h"
#include "base/input.h"
#include "base/text.h"
#include "lab/laboratory.h"
#include "lab/session/session.h"
#include "film/film.h"
#include "terminal/grid.h"

#include <langinfo.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Keys of a script follow at once; who looks at a film of it wants to see each. */
#define KEY_SECONDS    0.5
#define LETTER_SECONDS 0.12

#define BEYOND_PATIENCE 1e9 /* seconds: longer than any frame */

enum { SCENE_KEYS = 4, LINE_BYTES_MAX = 4096, SCRIPT_BYTES_MAX = 100000000 };

struct Script {
    Laboratory lab;
    Canvas canvas;
    int width, height;
    double time; /* virtual */
    double rate; /* steps per second; 0: without limit */
    /* Seconds that an instruction may take for work that is not cut into frames; 0: as long as it takes. */
    double cancel;
    double begun;                 /* when the instruction began */
    const ScriptInstruction *row; /* that is done */
    char scene[80];               /* of a lecture, under way; "": none */
    int scene_keys;               /* that it has cost */
    Camera *camera;               /* NULL: nobody films */
    double keys_seconds;          /* of the film: what keys have taken, which take no time here */
    const SessionEvent *awaited;  /* of the session that is filmed: the next key */
};

static bool go_on(void *context)
{
    const Script *script = context;
    if (script->camera && !camera_goes_on(script->camera))
        return false;
    return script->cancel == 0 || clock_seconds() - script->begun < script->cancel;
}

/* What waits for the clock waits no longer once the camera stops, or the time to cancel has come. */
static double now(void *context)
{
    const Script *script = context;
    return script->time + (go_on(context) ? 0 : BEYOND_PATIENCE);
}

static void worked(void *context, long steps)
{
    Script *script = context;
    if (script->rate > 0)
        script->time += (double)steps / script->rate;
}

/* What the camera sees of the screen as it was drawn last. */
static bool film(Script *script, bool must, Status *status)
{
    if (!script->camera)
        return true;
    const Experiment *experiment = laboratory_run(&script->lab);
    const long last = experiment_last_step(experiment);
    return camera_look(
        script->camera, &script->canvas,
        &(CameraMoment){.seconds = script->time + script->keys_seconds,
                        .time = experiment_time(experiment),
                        .share = last > 0 ? (double)experiment_step(experiment) / (double)last : 0,
                        .must = must},
        status);
}

static bool draw(Script *script, Status *status)
{
    if (!laboratory_draw(&script->lab, &script->canvas, script->width, script->height))
        return status_fail(status, "out of memory");
    return film(script, false, status);
}

static bool frame(Script *script, Status *status)
{
    double begin = script->time;
    laboratory_frame(&script->lab, begin + FRAME_SECONDS);
    if (script->time < begin + FRAME_SECONDS)
        script->time = begin + FRAME_SECONDS;
    return !script->camera || draw(script, status);
}

static bool frame_of_work(Script *script, Status *status)
{
    return script->lab.player.playback.state != STATE_COMPUTING || frame(script, status);
}

/* Frame by frame to a time; half a frame of grace, so that rounding does not decide about a frame. */
static bool frames_until(Script *script, double time, Status *status)
{
    while (script->time < time - FRAME_SECONDS / 2)
        if (!frame(script, status))
            return false;
    return true;
}

/* As the event loop does it: work that a key asks for begins in the same frame, and the screen is drawn. */
static bool press(Script *script, const char *name, int x, int y, double seconds, Status *status)
{
    Key key = {.x = x, .y = y};
    if (script->lab.closed)
        return status_fail(status, "key %s: the laboratory has been left", name);
    if (script->scene[0] && ++script->scene_keys > SCENE_KEYS)
        return status_fail(status, "key %s: the scene '%s' costs more than %d keys", name, script->scene,
                           SCENE_KEYS);
    snprintf(key.name, sizeof key.name, "%s", name);
    laboratory_key(&script->lab, &key);
    script->keys_seconds += seconds;
    return frame_of_work(script, status) && draw(script, status);
}

static bool do_key(Script *script, char *rest, Status *status)
{
    char *place;
    for (char *name = strtok_r(rest, " \t", &place); name; name = strtok_r(NULL, " \t", &place))
        if (!keys_known(name))
            return status_refuse(
                status, "key: %.40s is not a key (a character, Space, Enter, Esc, Up, F1, ^C, ...)", name);
        else if (!press(script, name, -1, -1, KEY_SECONDS, status))
            return false;
    return true;
}

static bool do_mouse(Script *script, char *rest, Status *status)
{
    const bool click = script->row->by;
    int x, y;
    char end;
    if (sscanf(rest, "%d %d%c", &x, &y, &end) != 2)
        return status_refuse(status, "%s: a column and a row are expected, not: %s", script->row->name, rest);
    return press(script, click ? "Click" : "Drag", x, y, KEY_SECONDS, status);
}

static bool do_type(Script *script, char *rest, Status *status)
{
    char name[KEY_NAME_MAX];
    bool sound = true;
    for (const char *left = rest; *left && sound;) {
        left = keys_of_text(left, name);
        sound = press(script, name, -1, -1, LETTER_SECONDS, status);
    }
    return sound;
}

/* In front of a class nobody can follow more than a few keys. */
static bool do_scene(Script *script, char *rest, Status *status)
{
    if (!*rest || strlen(rest) >= sizeof script->scene)
        return status_refuse(status, "scene: a short name is expected, not: %s", rest);
    snprintf(script->scene, sizeof script->scene, "%s", rest);
    script->scene_keys = 0;
    return true;
}

static bool do_wait(Script *script, char *rest, Status *status)
{
    double seconds;
    char end;
    if (sscanf(rest, "%lf%c", &seconds, &end) != 1 || seconds < 0 || seconds > 1e6)
        return status_refuse(status, "wait: not a number of seconds: %s", rest);
    return frames_until(script, script->time + seconds, status) && draw(script, status);
}

static bool do_size(Script *script, char *rest, Status *status)
{
    int size[2];
    if (!text_to_size(rest, 1, SCRIPT_CELLS_MAX, size))
        return status_refuse(status, "size: not a size: %s (as in 80x24; at most %d each)", rest,
                             SCRIPT_CELLS_MAX);
    script->width = size[0];
    script->height = size[1];
    return draw(script, status);
}

static bool read_number(const Script *script, const char *rest, double *number, Status *status)
{
    return (text_to_double(rest, number) && *number >= 0) ||
           status_refuse(status, "%s: not a number of %s: %s", script->row->name,
                         strcmp(script->row->arguments, "STEPS") == 0 ? "steps" : "seconds", rest);
}

static bool do_rate(Script *script, char *rest, Status *status)
{
    if (!read_number(script, rest, &script->rate, status))
        return false;
    for (int i = 0; i < RATES; i++)
        script->lab.player.rates[i] = script->rate;
    return true;
}

static bool do_cancel_after(Script *script, char *rest, Status *status)
{
    return read_number(script, rest, &script->cancel, status);
}

static bool do_print(Script *script, char *name, Status *status)
{
    if (!draw(script, status))
        return false;
    if (script->camera) /* it is in the film */
        return true;
    char *text = script->row->by ? canvas_dump_styles(&script->canvas) : canvas_dump(&script->canvas);
    if (!text)
        return status_fail(status, "out of memory");
    if (*name)
        printf("--- %s\n", name);
    fputs(text, stdout);
    free(text);
    return true;
}

static bool do_look_for(Script *script, char *text, Status *status)
{
    const bool wanted = script->row->by;
    if (!draw(script, status))
        return false;
    char *dump = canvas_dump(&script->canvas);
    if (!dump)
        return status_fail(status, "out of memory");
    bool found = strstr(dump, text) != NULL;
    if (found != wanted)
        fputs(dump, stdout);
    free(dump);
    if (found == wanted)
        return true;
    return status_fail(status, "'%s' is %s", text, found ? "on the screen" : "not on the screen");
}

static bool do_closed(Script *script, char *rest, Status *status)
{
    (void)rest;
    return script->lab.closed || status_fail(status, "the laboratory is still open");
}

const ScriptInstruction script_instructions[] = {
    {"key", "NAME...", "presses keys by name: Space, Enter, ^C, ], ...", do_key, false},
    {"type", "TEXT", "presses the characters of the text one by one", do_type, false},
    {"click", "X Y", "presses the mouse in a column and a row, from 0", do_mouse, true},
    {"drag", "X Y", "moves the mouse there, its button still pressed", do_mouse, false},
    {"scene", "NAME",
     "a scene of a lecture begins; until the next one not more than four keys and clicks are pressed",
     do_scene, false},
    {"wait", "SECONDS", "lets that much time pass, frame by frame", do_wait, false},
    {"size", "WIDTHxHEIGHT", "resizes the screen", do_size, false},
    {"rate", "STEPS", "the engine does that many steps in a second; 0, as at first: as many as are asked for",
     do_rate, false},
    {"cancel-after", "SECONDS",
     "work that is not cut into frames is given up after so long, as by ^C; 0, as at first: never",
     do_cancel_after, false},
    {"screen", "[NAME]", "prints the screen, under a line with the name", do_print, false},
    {"styles", "[NAME]", "prints its styles, one letter a cell", do_print, true},
    {"expect", "TEXT", "the text is on the screen, within one line", do_look_for, true},
    {"reject", "TEXT", "the text is not on the screen", do_look_for, false},
    {"closed", "", "the laboratory has been left", do_closed, false},
    {NULL, NULL, NULL, NULL, false},
};

static bool play_line(Script *script, char *line, Status *status)
{
    script->begun = clock_seconds();
    line += strspn(line, " \t");
    if (!*line || *line == '#')
        return true;
    size_t length = strcspn(line, " ");
    char *rest = line + length + (line[length] == ' ');
    for (const ScriptInstruction *row = script_instructions; row->name; row++)
        if (strlen(row->name) == length && strncmp(line, row->name, length) == 0) {
            script->row = row;
            return row->run(script, rest, status);
        }
    char known[256] = "";
    for (const ScriptInstruction *row = script_instructions; row->name; row++)
        text_or(known, sizeof known, row->name);
    return status_refuse(status, "unknown instruction: %.60s (%s)", line, known);
}

static bool play(Script *script, FILE *file, const char *name, Status *status)
{
    InputLines lines = {.stream = file, .name = name};
    char line[LINE_BYTES_MAX + 1];
    InputGot got;
    if (!draw(script, status))
        return false;
    while ((got = input_line(&lines, line, sizeof line, status)) == INPUT_LINE)
        if (!play_line(script, line, status))
            return status_prefix(status, "%s:%ld", name, lines.number);
    return got == INPUT_END;
}

static bool open_script(Script *script, const LaboratoryOptions *options, Status *status)
{
    Host host = {now, worked, go_on, NULL, NULL, script, NULL, NULL};
    const char *codeset = nl_langinfo(CODESET);
    Glyphs glyphs;
    if (!grid_choose_glyphs(options->glyphs, codeset, NULL, &glyphs))
        return status_refuse(status, "--glyphs: unknown set '%s' (auto, braille, block or ascii)",
                             options->glyphs);
    script->camera = options->camera;
    if (!laboratory_open(&script->lab, options, &host, status))
        return false;
    script->lab.screen.look.glyphs = glyphs;
    script->lab.screen.look.colours = 256;
    script->lab.screen.look.light = theme_is_light(options->theme, NULL);
    script->lab.utf8 = strcmp(codeset, "UTF-8") == 0;
    script->width = options->width > 0 ? options->width : 80;
    script->height = options->height > 0 ? options->height : 24;
    return true;
}

/* The session first, as fast as it can; the script goes on where it was left. */
static bool replay_all(Script *script, const Session *session, Status *status)
{
    Replay replay = {.session = session};
    bool sound = true;
    for (const SessionEvent *event; sound && (event = replay_next(&replay));) {
        if (event->width > 0 && event->height > 0 && event->width <= SCRIPT_CELLS_MAX &&
            event->height <= SCRIPT_CELLS_MAX) {
            script->width = event->width;
            script->height = event->height;
        }
        sound = draw(script, status);
        if (sound && script->camera && event != script->awaited) {
            /* until it is due the run goes on as it did then, but not beyond where the key came */
            script->awaited = event;
            script->lab.player.run_limit = event->on_the_way ? -1 : event->step;
            sound = frames_until(script, script->time + event->seconds, status);
            script->lab.player.run_limit = -1;
        }
        if (sound && replay_go_on(&replay, &script->lab, script->time + FRAME_SECONDS))
            sound = frame_of_work(script, status);
    }
    if (session)
        replay_end(&replay, &script->lab);
    return sound && draw(script, status);
}

/* Whether the run from where the camera begins has room in a film: at its pace so many steps are a frame, and
 * a picture is due each so many frames, if there is a step between. A run that may end by itself is only
 * tried. */
static bool has_room(const Script *script, double dt, Status *status)
{
    const Laboratory *lab = &script->lab;
    const Camera *camera = script->camera;
    const double from = fmax(camera->from, 0),
                 to = fmin(camera->to, (double)experiment_last_step(laboratory_run(lab)) * dt),
                 steps = (to - from) / dt, frames = steps / lab->player.playback.pace,
                 due = fmax(ceil((1 - 1e-9) * camera->speed / camera->fps / FRAME_SECONDS), 1),
                 pictures = fmin(frames / due, steps);
    if (pictures < FILM_PICTURES_MAX || camera->idle < 1 / camera->fps ||
        settings_time(laboratory_settings(lab))->rest)
        return true;
    return status_refuse(
        status, "the film would have about %.0f pictures (at most %d: --to %g, or --speed %g)", pictures,
        FILM_PICTURES_MAX,
        from + player_next_125(FILM_PICTURES_MAX * fmax(due * lab->player.playback.pace, 1) * dt, -1),
        player_next_125(camera->fps * FRAME_SECONDS * frames / FILM_PICTURES_MAX, 1));
}

/* Without keys: the run itself, to its end or to where the camera is told to stop. */
static bool film_run(Script *script, Status *status)
{
    Laboratory *lab = &script->lab;
    const double dt = laboratory_simulation(lab)->dt;
    if (laboratory_active(lab) && !has_room(script, dt, status))
        return false;
    if (script->camera->from > 0)
        player_seek(lab, (long)fmin(ceil(script->camera->from / dt - 1e-9), 1e15), 0);
    while (laboratory_active(lab) && experiment_time(laboratory_run(lab)) <= script->camera->to)
        if (!frame(script, status))
            return false;
    return true;
}

int script_play(FILE *file, const char *name, const LaboratoryOptions *options, const Session *replay,
                Session *recording, Status *status)
{
    Script *script = calloc(1, sizeof *script);
    bool sound = false;
    if (!script)
        status_fail(status, "out of memory");
    else if (open_script(script, options, status)) {
        script->lab.recording = recording;
        session_note_start(recording, &script->lab);
        sound = replay_all(script, replay, status) && (!file || play(script, file, name, status));
        if (sound && script->camera)
            sound = (file || replay || film_run(script, status)) && draw(script, status) &&
                    film(script, true, status) &&
                    camera_end(script->camera, script->time + script->keys_seconds, status);
        session_note(recording, &script->lab, (SessionEvent){.is_end = true, .key = {.x = -1}});
        laboratory_close(&script->lab);
        canvas_close(&script->canvas);
    }
    free(script);
    return sound ? 0 : (int)status->code;
}

int script_run(const LaboratoryOptions *options, const Session *replay, Session *recording, Status *status)
{
    if (!options->script)
        return script_play(NULL, NULL, options, replay, recording, status);
    if (strcmp(options->script, "-") == 0)
        return script_play(stdin, "standard input", options, replay, recording, status);
    FILE *file = input_open(options->script, SCRIPT_BYTES_MAX, status);
    if (!file)
        return (int)status->code;
    const int result = script_play(file, options->script, options, replay, recording, status);
    fclose(file);
    return result;
}

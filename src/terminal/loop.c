/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "terminal/terminal.h"
#include "base/wait.h"

#include "base/visible.h"
#include "lab/laboratory.h"
#include "lab/session/session.h"
#include "scenario/changes.h"
#include "scenario/scenario.h"
#include "scenario/settings.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define PROGRESS_SECONDS 0.1 /* between pictures during work that is not cut into frames */

/* Pictures of a run take an eighth of the time at most; there are five a second at least. */
#define PICTURE_SHARE 8
#define REST_SECONDS  0.2

typedef struct Loop {
    Laboratory lab;
    Terminal *terminal;
    Canvas canvas;
    double due;       /* when the next frame of a run begins */
    double draw_time; /* what a picture takes, so that the engine leaves room for it */
    double drawn_at;
    long frames;
    int frame_fd; /* -1: nobody listens */
    Replay replay;
    bool fast;          /* replay as fast as it can */
    double replayed_at; /* when its last key was done again */
    bool told;          /* something stands on the shell's last line that tell how far the opening has come */
    bool stale;         /* the picture shown is out of date */
    bool moved;         /* the run went on since then */
    bool more_keys;     /* are answered before it sleeps */
    Settings told_settings; /* those of `address` */
    char *address;          /* of a page: the scenario, and what was changed of it */
    bool unannounced;       /* a picture is not yet announced, for the terminal has not taken all of it */
} Loop;

static double now(void *context)
{
    (void)context;
    return clock_seconds();
}

static void worked(void *context, long steps)
{
    (void)context;
    (void)steps;
}

/* A name from a file may hold what parts the commands. */
static void add_word(FILE *stream, const char *word)
{
    for (; *word; word++)
        if (*word != ';')
            fputc(*word, stream);
}

static void add_assignment(void *context, const char *key, const char *value)
{
    fprintf(context, ";K%s=", key);
    add_word(context, value);
}

/* Behind the picture, for a page whose address follows what is opened and changed: ";T1" where all is larger,
 * behind it how many exercises have an answer, ";N" and the scenario's name, ";K" and each KEY=VALUE. */
static void describe_address(Loop *loop)
{
    const Settings *settings = experiment_settings(laboratory_run(&loop->lab));
    if (!loop->canvas.vectored)
        return;
    if (!loop->address || memcmp(settings, &loop->told_settings, sizeof *settings) != 0) {
        size_t size;
        Settings now;
        free(loop->address);
        loop->address = NULL;
        FILE *stream = open_memstream(&loop->address, &size);
        if (!stream)
            return;
        memcpy(&loop->told_settings, settings, sizeof *settings);
        changes_in_force(settings, LONG_MAX, &now);
        fputs(";N", stream);
        add_word(stream, loop->lab.scenario);
        scenario_assignments(loop->lab.scenario, &now, add_assignment, stream);
        fclose(stream);
    }
    int answered = 0;
    for (int i = 0; i < LESSON_PAGES_MAX; i++)
        answered += loop->lab.homework.marks[i].tries > 0;
    canvas_vector(&loop->canvas, ";T%d,%d", loop->canvas.large, answered);
    enum { PIECE = 400 };
    for (size_t at = 0; loop->address && at < strlen(loop->address); at += PIECE)
        canvas_vector(&loop->canvas, "%.*s", PIECE, loop->address + at);
}

static void draw(Loop *loop)
{
    int width, height;
    double begin = now(NULL);
    terminal_size(loop->terminal, &width, &height);
    if (laboratory_draw(&loop->lab, &loop->canvas, width, height)) {
        describe_address(loop);
        terminal_show(loop->terminal, &loop->canvas);
    }
    loop->stale = loop->moved = false;
    loop->unannounced = true;
    loop->frames++;
    loop->drawn_at = now(NULL);
    loop->draw_time = 0.8 * loop->draw_time + 0.2 * (loop->drawn_at - begin);
}

static bool go_on(void *context)
{
    Loop *loop = context;
    Key key;
    bool stop = false;
    if (!loop->terminal) {
        /* Before the screen is taken over, progress stands on the shell's last line, and ^C ends the
         * program. */
        if (isatty(STDERR_FILENO) && !(now(NULL) - loop->drawn_at < PROGRESS_SECONDS)) {
            loop->drawn_at = now(NULL);
            visible_progress(stderr, "%s", loop->lab.message.text);
            loop->told = true;
        }
        return true;
    }
    terminal_wait(loop->terminal, 0);
    while (terminal_key(loop->terminal, &key))
        stop |= strcmp(key.name, "^C") == 0 || strcmp(key.name, "Esc") == 0;
    terminal_resized(loop->terminal);
    if (now(NULL) - loop->drawn_at > PROGRESS_SECONDS && !terminal_is_behind(loop->terminal))
        draw(loop);
    return !stop && terminal_signal(loop->terminal) == 0;
}

static bool key_waits(void *context)
{
    const Loop *loop = context;
    return terminal_has_input(loop->terminal);
}

static void redraw(void *context)
{
    Loop *loop = context;
    terminal_redraw(loop->terminal);
}

static void suspend(void *context)
{
    Loop *loop = context;
    terminal_suspend(loop->terminal);
    loop->due = now(NULL);
}

static bool open_loop(Loop *loop, const LaboratoryOptions *options, Status *status)
{
    Host host = {now, worked, go_on, redraw, suspend, loop, key_waits, NULL};
    /* the laboratory first: what is wrong with a scenario is said where the shell can show it */
    bool open = laboratory_open(&loop->lab, options, &host, status);
    if (loop->told)
        visible_progress(stderr, "%s", "");
    loop->told = false;
    if (!open)
        return false;
    loop->terminal = terminal_open(options, status);
    if (!loop->terminal) {
        laboratory_close(&loop->lab);
        return false;
    }
    Screen *screen = &loop->lab.screen;
    const TerminalLook look = terminal_look(loop->terminal);
    screen->look = (ScreenLook){look.glyphs, look.colours, look.light};
    loop->lab.utf8 = look.utf8;
    if (look.stand_in && !screen->message->text[0])
        laboratory_say(&loop->lab, MESSAGE_INFO, "TERM=%.40s is not known here: drawn as on %s",
                       getenv("TERM"), look.stand_in);
    return true;
}

static bool is_replaying(const Loop *loop)
{
    return replay_next(&loop->replay) != NULL;
}

/* When the next key of the replay is due; only while there is one. */
static double replay_due(const Loop *loop)
{
    return loop->fast ? 0 : loop->replayed_at + replay_next(&loop->replay)->seconds;
}

static void end_replay(Loop *loop, const char *how)
{
    replay_end(&loop->replay, &loop->lab);
    laboratory_say(&loop->lab, MESSAGE_INFO, "%s: the laboratory is yours", how);
    loop->stale = true;
}

/* Keys of the replay that are due. Until then a run goes on as it does, but not beyond where the key came. */
static void replay_round(Loop *loop)
{
    Laboratory *lab = &loop->lab;
    double deadline = now(NULL) + FRAME_SECONDS - loop->draw_time;
    while (is_replaying(loop) && !lab->closed && now(NULL) >= replay_due(loop)) {
        loop->stale = true;
        if (!replay_go_on(&loop->replay, lab, deadline))
            return;
        loop->replayed_at = now(NULL);
        if (!is_replaying(loop))
            end_replay(loop, "session restored");
        if (!loop->fast || lab->player.playback.state == STATE_COMPUTING || now(NULL) >= deadline)
            return;
    }
    if (is_replaying(loop))
        lab->player.run_limit =
            replay_next(&loop->replay)->on_the_way ? -1 : replay_next(&loop->replay)->step;
}

/* Keys that wait are answered before a picture is made, but where they come faster than they are answered it
 * shows for all that how far they have led. True: more of them may wait, read from the terminal already. */
static bool answer_keys(Loop *loop)
{
    Laboratory *lab = &loop->lab;
    const double latest = now(NULL) + FRAME_SECONDS;
    Key key;
    while (!lab->closed && terminal_signal(loop->terminal) == 0) {
        if (!terminal_key(loop->terminal, &key))
            return false;
        /* a terminal may send reports that nobody asked for */
        if (key.x < 0 || !lab->options.no_mouse)
            laboratory_key(lab, &key);
        loop->stale = true;
        if (now(NULL) >= latest)
            return true;
    }
    return false;
}

static void one_round(Loop *loop)
{
    Laboratory *lab = &loop->lab;
    Key key;
    while (is_replaying(loop) && terminal_key(loop->terminal, &key))
        end_replay(loop, "the replay ends here");
    if (is_replaying(loop))
        replay_round(loop);
    const bool had_more = loop->more_keys;
    loop->more_keys = answer_keys(loop);
    loop->unannounced |= had_more && !loop->more_keys; /* it sleeps now */
    if (terminal_resized(loop->terminal))
        loop->stale = true;
    if (lab->closed)
        return;
    double begin = now(NULL);
    /* a key between two frames is shown at once, but does not make the run go faster */
    if ((laboratory_active(lab) && (begin >= loop->due || lab->player.playback.state == STATE_COMPUTING)) ||
        laboratory_message_left(lab) == 0) {
        if (laboratory_frame(lab, begin + FRAME_SECONDS - loop->draw_time))
            loop->moved = true;
        loop->due = loop->due + FRAME_SECONDS > begin ? loop->due + FRAME_SECONDS : begin + FRAME_SECONDS;
        /* where the engine is the limit it does not wait for a frame that has room for another step */
        if (lab->player.frames_in_time == 0)
            loop->due = now(NULL);
    }
    /* the run has its share of the time since the last picture */
    const double rest = fmin(PICTURE_SHARE * loop->draw_time, REST_SECONDS);
    loop->stale |= loop->moved && (!laboratory_active(lab) || now(NULL) - loop->drawn_at >= rest);
    if (loop->stale && !terminal_is_behind(loop->terminal))
        draw(loop);
    if (loop->unannounced && !terminal_is_behind(loop->terminal)) {
        char text[48];
        loop->unannounced = false;
        if (loop->frame_fd >= 0) {
            int length = snprintf(text, sizeof text, "frame %ld%s\n", loop->frames,
                                  laboratory_active(&loop->lab) || loop->more_keys ? "" : " idle");
            ssize_t written = write(loop->frame_fd, text, (size_t)length);
            (void)written; /* unread frames are dropped */
        }
    }
    if (is_replaying(loop)) {
        const double frame = laboratory_active(lab) ? loop->due : INFINITY;
        terminal_wait(loop->terminal, fmax(0, fmin(replay_due(loop), frame) - now(NULL)));
    } else if (loop->more_keys) {
        terminal_wait(loop->terminal, 0);
    } else if (!laboratory_active(lab)) {
        terminal_wait(loop->terminal, laboratory_message_left(lab));
        loop->due = now(NULL);
    } else {
        const bool computing = lab->player.playback.state == STATE_COMPUTING;
        terminal_wait(loop->terminal, computing ? 0 : fmax(0, loop->due - now(NULL)));
    }
}

int loop_run(const LaboratoryOptions *options, const Session *replay, Session *recording, Status *status)
{
    Loop *loop = calloc(1, sizeof *loop);
    if (!loop) {
        status_fail(status, "out of memory");
        return STATUS_FAILED;
    }
    const char *descriptor = getenv("MATVIB_FRAME_FD");
    loop->frame_fd = descriptor && *descriptor ? atoi(descriptor) : -1;
    if (!open_loop(loop, options, status)) {
        free(loop);
        return (int)status->code;
    }
    int signal_number = 0;
    loop->canvas.vectored = getenv("MATVIB_VECTORS") != NULL;
    loop->lab.recording = recording;
    session_note_start(recording, &loop->lab);
    loop->replay = (Replay){.session = replay};
    loop->fast = options->fast;
    loop->replayed_at = now(NULL);
    if (is_replaying(loop))
        laboratory_say(&loop->lab, MESSAGE_INFO, "replaying a session: any key takes over");
    else if (replay)
        end_replay(loop, "the session has no keys");
    loop->stale = true;
    loop->due = now(NULL);
    while (!loop->lab.closed && signal_number == 0) {
        one_round(loop);
        signal_number = terminal_signal(loop->terminal);
    }
    terminal_close(loop->terminal);
    session_note(recording, &loop->lab, (SessionEvent){.is_end = true, .key = {.x = -1}});
    laboratory_close(&loop->lab);
    canvas_close(&loop->canvas);
    free(loop->address);
    free(loop);
    return signal_number ? 128 + signal_number : 0;
}

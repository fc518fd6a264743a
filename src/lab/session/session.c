/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keeping a session: its keys in memory and, as they come, in a file. */
#include "lab/session/session_internal.h"
#include "base/hash.h"
#include "base/text.h"
#include "base/visible.h"
#include "scenario/scenario.h"
#include "lab/laboratory.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EVENTS_MAX = 1000000 };

static bool no_memory(Status *status)
{
    return status_fail(status, "not enough memory for a session");
}

bool session_append(Session *session, const SessionEvent *event)
{
    if (session->count == session->room) {
        size_t room = session->room ? 2 * session->room : 64;
        SessionEvent *events =
            room <= 2 * (size_t)EVENTS_MAX ? realloc(session->events, room * sizeof *events) : NULL;
        if (!events)
            return false;
        session->events = events;
        session->room = room;
    }
    session->events[session->count++] = *event;
    return true;
}

Session *session_begin(const LaboratoryOptions *options, Status *status)
{
    Session *session = calloc(1, sizeof *session);
    if (!session) {
        no_memory(status);
        return NULL;
    }
    session->settings = *options->settings;
    session->paused = options->paused;
    session->first = options->first_start;
    session->sheet = options->sheet;
    visible_text(session->scenario, sizeof session->scenario, options->scenario);
    visible_text(session->lesson, sizeof session->lesson, options->lesson ? options->lesson : "");
    visible_text(session->student, sizeof session->student, options->student ? options->student : "");
    visible_text(session->id, sizeof session->id, options->student_id ? options->student_id : "");
    snprintf(session->program, sizeof session->program, "%s", PACKAGE_VERSION);
    session->check = HASH_BEGIN;
    if (options->reached)
        memcpy(session->reached, options->reached, sizeof session->reached);
    return session;
}

static void put(FILE *file, uint64_t *check, const char *text)
{
    *check = hash_bytes(*check, text, strlen(text));
    fputs(text, file);
}

static void write_event(FILE *file, uint64_t *check, const SessionEvent *event)
{
    char line[SESSION_LINE_MAX] = "";
    text_append(line, sizeof line, "%s %s%ld",
                event->is_end    ? "end"
                : event->is_stop ? "stop"
                                 : "at",
                event->on_the_way ? "~" : "", event->step);
    if (event->stage > 0)
        text_append(line, sizeof line, "/%d", event->stage);
    text_append(line, sizeof line, " %.3f %dx%d", event->seconds, event->width, event->height);
    if (!event->is_end && !event->is_stop)
        text_append(line, sizeof line, " %s", event->key.name);
    if (event->key.x >= 0)
        text_append(line, sizeof line, " %d %d", event->key.x, event->key.y);
    text_append(line, sizeof line, "\n");
    put(file, check, line);
    if (event->is_end)
        fprintf(file, "check %016" PRIx64 "\n", *check);
}

/* Behind its own lines those of the scenario, each marked. */
static bool write_head(FILE *file, uint64_t *check, const Session *session, Status *status)
{
    char *text = NULL;
    size_t size = 0;
    FILE *memory = open_memstream(&text, &size);
    long own = 0;
    if (!memory)
        return no_memory(status);
    fprintf(memory, "# matvib session: matvib --replay FILE does it again\nscenario %s\n%s",
            session->scenario, session->paused ? "paused\n" : "");
    if (session->first)
        fputs("first\n", memory);
    if (session->sheet)
        fprintf(memory, "sheet %s\n", session->sheet);
    if (*session->lesson)
        fprintf(memory, "lesson %s\n", session->lesson);
    if (*session->student)
        fprintf(memory, "student %s\n", session->student);
    if (*session->id)
        fprintf(memory, "id %s\n", session->id);
    fprintf(memory, "version %016" PRIx64 " %s\n", session->version, session->program);
    for (int i = 0; i < LESSONS_MAX && builtin_lessons[i].name; i++)
        if (session->reached[i] > 0)
            fprintf(memory, "reached %s %d\n", builtin_lessons[i].name, session->reached[i]);
    own = ftell(memory);
    bool sound = scenario_write(memory, &session->settings, NULL, status);
    if (!text_stream_close(memory, &text) && sound)
        sound = no_memory(status);
    for (char *line = text, *end; sound && (end = strchr(line, '\n')); line = end + 1) {
        *end = '\0';
        put(file, check, line < text + own ? "" : *line ? "| " : "|");
        put(file, check, line);
        put(file, check, "\n");
    }
    free(text);
    return sound;
}

/* Behind a key that was not kept the others would mean something else. */
void session_note(Session *session, const Laboratory *lab, SessionEvent event)
{
    if (!session)
        return;
    const Experiment *experiment = laboratory_run(lab);
    OutputFile *file = &session->file;
    Status *trouble = &session->trouble;
    const double now = lab->host.now(lab->host.context);
    event.on_the_way = lab->player.playback.state == STATE_COMPUTING;
    event.step = experiment_step(experiment);
    event.stage = experiment_stage(experiment);
    event.seconds = fmin(fmax(now - session->last, 0), SESSION_SECONDS_MOST);
    event.width = lab->width;
    event.height = lab->height;
    if (!session->full)
        session->full = !session_append(session, &event);
    session->last = now;
    if (session->full || !session->record)
        return;
    /* A line is in the file before its key does anything, so that what crashed can be done again. */
    if (!session->begun) {
        session->begun = true;
        if (!output_open(file, ASKER_COMMAND_LINE, session->record, session->replaces, trouble) ||
            !write_head(file->stream, &session->check, session, trouble) || !output_publish(file, trouble))
            output_close(file);
    }
    if (!file->stream)
        return;
    write_event(file->stream, &session->check, &event);
    fflush(file->stream);
    if (!output_sound(file, trouble))
        output_close(file);
}

void session_record(Session *session, const char *file, bool force)
{
    session->record = file;
    session->replaces = force;
}

/* What is missing in what was recorded or kept, if something is. */
static bool is_whole(const Session *session, const char *name, Status *status)
{
    return !session->full ||
           status_fail(status, "%s: memory was short for more than its first %zu keys", name, session->count);
}

/* Whether its file has begun, or would have if memory had not been short for the first key already. */
static bool is_recorded(const Session *session)
{
    return session->record && session_has_keys(session);
}

bool session_is_lost(Session *session, Status *status)
{
    if (session->told || !is_recorded(session) || (session->trouble.code == STATUS_DONE && !session->full))
        return false;
    session->told = true;
    status_take(status, &session->trouble);
    return session->trouble.code != STATUS_DONE || !is_whole(session, session->record, status);
}

bool session_finish(Session *session, Status *status)
{
    OutputFile *file = &session->file;
    if (file->stream)
        output_finish(file, &session->trouble);
    output_close(file);
    if (session->trouble.code != STATUS_DONE)
        return status_take(status, &session->trouble);
    return !is_recorded(session) || is_whole(session, session->record, status);
}

void session_note_start(Session *session, const Laboratory *lab)
{
    session->last = lab->host.now(lab->host.context);
    session->version = lab->options.lesson ? lab->play.lesson.version : 0;
}

bool session_keep(const Session *session, const char *name, Status *status)
{
    OutputFile file;
    if (!output_open_own(&file, ASKER_COMMAND_LINE, name, status))
        return false;
    uint64_t check = HASH_BEGIN;
    bool sound = write_head(file.stream, &check, session, status);
    for (size_t i = 0; i < session->count; i++)
        write_event(file.stream, &check, &session->events[i]);
    return output_end(&file, sound, status) && is_whole(session, name, status);
}

bool session_has_keys(const Session *session)
{
    return session->count > 0 || session->full;
}

void session_options(const Session *session, LaboratoryOptions *options)
{
    options->settings = &session->settings;
    options->scenario = session->scenario;
    options->paused = session->paused;
    options->first_start = session->first;
    options->sheet = session->sheet;
    options->lesson = *session->lesson ? session->lesson : NULL;
    options->student = *session->student ? session->student : NULL;
    options->student_id = *session->id ? session->id : NULL;
    options->reached = session->reached;
}

const SessionEvent *session_event(const Session *session, size_t index)
{
    return index < session->count ? &session->events[index] : NULL;
}

void session_free(Session *session)
{
    if (session) {
        output_close(&session->file);
        free(session->events);
    }
    free(session);
}

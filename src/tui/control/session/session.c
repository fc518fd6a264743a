/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keeping a session: its keys in memory and, as they come, in a file; and reading such a file. */
#include "tui/control/session/session.h"

#include "base/hash.h"
#include "base/input.h"
#include "base/text.h"
#include "base/visible.h"
#include "base/output.h"
#include "lab/settings/scenario.h"
#include "lab/settings/scenario_lines.h"
#include "tui/control/laboratory.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    EVENTS_MAX = 1000000,
    SIZE_MOST = 10000, /* cells */
    LINE_BYTES_MAX = 1100,
    SESSION_BYTES_MAX = 200000000,
    PROGRAM_MAX = 64
};

#define SECONDS_MOST 1e6 /* between two keys: eleven days */

struct Session {
    Settings settings;
    char scenario[SESSION_NAME_MAX], lesson[SESSION_NAME_MAX];
    int reached[LESSONS_MAX];
    char student[STUDENT_MAX], program[PROGRAM_MAX];
    uint64_t version; /* of the lesson's text */
    uint64_t check;   /* of the lines so far */
    bool ended, sound;
    bool paused, first;
    SessionEvent *events;
    size_t count, room;
    bool full;
    const char *record; /* the file that lines go to as they come; NULL: none */
    bool replaces, begun;
    OutputFile file; /* behind `record`, once there is a key */
    Status trouble;  /* why not all of it could be written */
    double last;     /* when the last event came, by the host's clock */
};

/* --- recording -------------------------------------------------------------------------------------- */

static bool append_event(Session *session, const SessionEvent *event)
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
        status_fail(status, STATUS_FAILED, "not enough memory for a session");
        return NULL;
    }
    session->settings = *options->settings;
    session->paused = options->paused;
    session->first = options->first_start;
    visible_text(session->scenario, sizeof session->scenario, options->scenario);
    visible_text(session->lesson, sizeof session->lesson, options->lesson ? options->lesson : "");
    visible_text(session->student, sizeof session->student, options->student ? options->student : "");
    snprintf(session->program, sizeof session->program, "%s", PACKAGE_VERSION);
    session->check = HASH_BEGIN;
    if (options->reached)
        memcpy(session->reached, options->reached, sizeof session->reached);
    return session;
}

static SessionEvent event_now(const Session *session, const Laboratory *lab, double now)
{
    const Experiment *experiment = lab->screen.experiment;
    return (SessionEvent){.on_the_way = lab->screen.playback.state == STATE_COMPUTING,
                          .step = experiment_step(experiment),
                          .stage = experiment_stage(experiment),
                          .seconds = fmin(fmax(now - session->last, 0), SECONDS_MOST),
                          .width = lab->width,
                          .height = lab->height,
                          .key = {.x = -1, .y = -1}};
}

static bool write_head(FILE *, uint64_t *check, const Session *, Status *);
static void write_event(FILE *, uint64_t *check, const SessionEvent *);

/* A line is in the file before its key does anything, so that what crashed can be done again. */
static void record_event(Session *session, const SessionEvent *event)
{
    OutputFile *file = &session->file;
    Status *trouble = &session->trouble;
    if (!session->begun) {
        session->begun = true;
        if (!output_open(file, ASKER_COMMAND_LINE, session->record, session->replaces, trouble) ||
            !write_head(file->stream, &session->check, session, trouble) || !output_publish(file, trouble))
            output_close(file);
    }
    if (!file->stream)
        return;
    write_event(file->stream, &session->check, event);
    fflush(file->stream);
    if (!output_sound(file, trouble))
        output_close(file);
}

/* Behind a key that was not kept the others would mean something else. */
static void note(Session *session, const SessionEvent *event, double now)
{
    if (!session->full)
        session->full = !append_event(session, event);
    if (!session->full && session->record)
        record_event(session, event);
    session->last = now;
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
           status_fail(status, STATUS_FAILED, "%s: memory was short for more than its first %zu keys", name,
                       session->count);
}

bool session_finish(Session *session, Status *status)
{
    OutputFile *file = &session->file;
    if (file->stream)
        output_finish(file, &session->trouble);
    output_close(file);
    if (session->trouble.code != STATUS_DONE) {
        *status = session->trouble;
        return false;
    }
    return !session->begun || is_whole(session, session->record, status);
}

void session_note_start(Session *session, const Laboratory *lab)
{
    session->last = lab->host.now(lab->host.context);
    session->version = lab->options.lesson ? lab->play.lesson.version : 0;
}

void session_note(Session *session, const Laboratory *lab, const Key *key)
{
    double now = lab->host.now(lab->host.context);
    SessionEvent event = event_now(session, lab, now);
    event.key = *key;
    note(session, &event, now);
}

void session_note_end(Session *session, const Laboratory *lab)
{
    double now = lab->host.now(lab->host.context);
    SessionEvent event = event_now(session, lab, now);
    event.is_end = true;
    note(session, &event, now);
}

static void put(FILE *file, uint64_t *check, const char *text)
{
    *check = hash_bytes(*check, text, strlen(text));
    fputs(text, file);
}

static void write_event(FILE *file, uint64_t *check, const SessionEvent *event)
{
    char line[LINE_BYTES_MAX] = "";
    text_append(line, sizeof line, "%s %s%ld", event->is_end ? "end" : "at", event->on_the_way ? "~" : "",
                event->step);
    if (event->stage > 0)
        text_append(line, sizeof line, "/%d", event->stage);
    text_append(line, sizeof line, " %.3f %dx%d", event->seconds, event->width, event->height);
    if (!event->is_end)
        text_append(line, sizeof line, " %s", event->key.name);
    if (!event->is_end && event->key.x >= 0)
        text_append(line, sizeof line, " %d %d", event->key.x, event->key.y);
    text_append(line, sizeof line, "\n");
    put(file, check, line);
    if (event->is_end)
        fprintf(file, "check %016" PRIx64 "\n", *check);
}

static bool write_scenario_lines(FILE *file, const Session *session, Status *status)
{
    char *text = NULL;
    size_t size = 0;
    FILE *memory = open_memstream(&text, &size);
    bool sound = memory && scenario_write(memory, &session->settings, NULL, status);
    if (memory && !text_stream_close(memory, &text))
        sound = false;
    for (char *line = text; sound && line && *line;) {
        size_t length = strcspn(line, "\n");
        fprintf(file, "|%s%.*s\n", length ? " " : "", (int)length, line);
        line += length + (line[length] == '\n');
    }
    free(text);
    if (!sound && !*status->text)
        status_fail(status, STATUS_FAILED, "not enough memory for a session");
    return sound;
}

static bool write_head_lines(FILE *file, const Session *session, Status *status)
{
    fprintf(file, "# matvib session: matvib --replay FILE does it again\nscenario %s\n%s", session->scenario,
            session->paused ? "paused\n" : "");
    if (session->first)
        fputs("first\n", file);
    if (*session->lesson)
        fprintf(file, "lesson %s\n", session->lesson);
    if (*session->student)
        fprintf(file, "student %s\n", session->student);
    if (session->version)
        fprintf(file, "version %016" PRIx64 " %s\n", session->version, session->program);
    for (int i = 0; i < LESSONS_MAX && builtin_lessons[i].name; i++)
        if (session->reached[i] > 0)
            fprintf(file, "reached %s %d\n", builtin_lessons[i].name, session->reached[i]);
    return write_scenario_lines(file, session, status);
}

static bool write_head(FILE *file, uint64_t *check, const Session *session, Status *status)
{
    char *text = NULL;
    size_t size = 0;
    FILE *memory = open_memstream(&text, &size);
    bool sound = memory && write_head_lines(memory, session, status);
    if (memory && !text_stream_close(memory, &text))
        sound = false;
    if (sound)
        put(file, check, text);
    else if (!*status->text)
        status_fail(status, STATUS_FAILED, "not enough memory for a session");
    free(text);
    return sound;
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
    sound = sound && output_finish(&file, status) && output_commit(&file, status);
    output_close(&file);
    return sound && is_whole(session, name, status);
}

bool session_has_keys(const Session *session)
{
    return session->count > 0 || session->full;
}

/* --- reading ---------------------------------------------------------------------------------------- */

static const char *const allowed = "scenario NAME | paused | first | lesson NAME | student NAME | version "
                                   "HASH PROGRAM | reached NAME PAGE | "
                                   "\"| ...\" | at ... | end ... | check HASH";

static bool read_place(char *word, SessionEvent *event)
{
    char *stage = strchr(word, '/');
    long number = 0;
    event->on_the_way = *word == '~';
    word += event->on_the_way;
    if (stage)
        *stage++ = '\0';
    if (!text_to_long(word, &event->step) || event->step < 0 || (stage && !text_to_long(stage, &number)) ||
        number < 0 || number > 1000)
        return false;
    event->stage = (int)number;
    return true;
}

static bool read_event(char *line, bool is_end, SessionEvent *event)
{
    enum { PLACE, SECONDS, SIZE, NAME, X, Y, WORDS };
    char *words[WORDS + 1] = {NULL}, *rest;
    int count = 0, size[2];
    for (char *word = strtok_r(line, " ", &rest); word && count <= WORDS; word = strtok_r(NULL, " ", &rest))
        words[count++] = word;
    *event = (SessionEvent){.is_end = is_end, .key = {.x = -1, .y = -1}};
    if (is_end ? count != NAME : count != X && count != WORDS)
        return false;
    if (!read_place(words[PLACE], event) || !text_to_double(words[SECONDS], &event->seconds) ||
        event->seconds < 0 || event->seconds > SECONDS_MOST || !text_to_size(words[SIZE], 0, SIZE_MOST, size))
        return false;
    event->width = size[0];
    event->height = size[1];
    if (is_end)
        return true;
    long x = -1, y = -1;
    if (strlen(words[NAME]) >= sizeof event->key.name || !visible_is_clean(words[NAME]) ||
        (count == WORDS && (!text_to_long(words[X], &x) || !text_to_long(words[Y], &y) || x < 0 ||
                            x > SIZE_MOST || y < 0 || y > SIZE_MOST)))
        return false;
    strcpy(event->key.name, words[NAME]);
    event->key.x = (int)x;
    event->key.y = (int)y;
    return true;
}

static bool read_reached(Session *session, const char *text, Status *status)
{
    const char *space = strrchr(text, ' ');
    long page;
    if (!space || !text_to_long(space, &page) || page < 0 || page > LESSON_PAGES_MAX)
        return status_fail(status, STATUS_USAGE, "not a page of a lesson (reached NAME PAGE)");
    for (int i = 0; i < LESSONS_MAX && builtin_lessons[i].name; i++)
        if (strncmp(builtin_lessons[i].name, text, (size_t)(space - text)) == 0 &&
            !builtin_lessons[i].name[space - text])
            session->reached[i] = (int)page;
    return true;
}

/* "HASH REST": sixteen digits; the rest is NULL where there is none. */
static bool read_hash(const char *text, uint64_t *hash, const char **rest)
{
    enum { DIGITS = 16 };
    if (strspn(text, "0123456789abcdef") != DIGITS || (text[DIGITS] && text[DIGITS] != ' '))
        return false;
    *hash = strtoull(text, NULL, 16);
    *rest = text[DIGITS] ? text + DIGITS + 1 : NULL;
    return true;
}

static bool read_version(Session *session, const char *text, Status *status)
{
    const char *program;
    if (!read_hash(text, &session->version, &program) || !program || strlen(program) >= PROGRAM_MAX)
        return status_fail(status, STATUS_USAGE, "not a version (version HASH PROGRAM)");
    return strcpy(session->program, program);
}

static bool read_check(Session *session, const char *text, Status *status)
{
    const char *rest;
    uint64_t check;
    if (!read_hash(text, &check, &rest) || rest)
        return status_fail(status, STATUS_USAGE, "not a check (check HASH)");
    session->sound = session->ended && check == session->check;
    return true;
}

static bool read_lesson(Session *session, const char *text, Status *status)
{
    return strlen(text) < sizeof session->lesson
               ? strcpy(session->lesson, text) != NULL
               : status_fail(status, STATUS_USAGE, "the lesson's name is too long");
}

static bool read_student(Session *session, const char *text, Status *status)
{
    return variant_student(text, session->student, status);
}

/* What a session says of its origin: a word, then a text. */
static const struct {
    const char *word;
    bool (*read)(Session *, const char *text, Status *);
} origins[] = {{"lesson ", read_lesson},
               {"student ", read_student},
               {"version ", read_version},
               {"check ", read_check},
               {"reached ", read_reached}};

/* One line; those of the scenario go on to `scenario`. */
static bool read_line(Session *session, char *line, FILE *scenario, Status *status)
{
    SessionEvent event;
    if (strncmp(line, "check ", 6) != 0) {
        session->check = hash_bytes(hash_bytes(session->check, line, strlen(line)), "\n", 1);
        session->sound = false; /* unless the check comes behind it */
    }
    if (!*line || *line == '#')
        return true;
    if (!visible_is_clean(line))
        return status_fail(status, STATUS_USAGE, "is not text in UTF-8");
    if (*line == '|') {
        if (ftell(scenario) > SCENARIO_BYTES_MAX)
            return status_fail(status, STATUS_USAGE, "its scenario is too long");
        fprintf(scenario, "%s\n", line + 1 + (line[1] == ' '));
        return true;
    }
    if (strncmp(line, "scenario ", 9) == 0 && line[9] && strlen(line + 9) < sizeof session->scenario)
        return strcpy(session->scenario, line + 9);
    for (size_t i = 0; i < sizeof origins / sizeof *origins; i++) {
        const size_t length = strlen(origins[i].word);
        if (strncmp(line, origins[i].word, length) == 0 && line[length])
            return origins[i].read(session, line + length, status);
    }
    if (strcmp(line, "paused") == 0)
        return session->paused = true;
    if (strcmp(line, "first") == 0)
        return session->first = true;
    bool is_end = strncmp(line, "end ", 4) == 0;
    if (!is_end && strncmp(line, "at ", 3) != 0)
        return status_fail(status, STATUS_USAGE, "unknown line: %.40s (%s)", line, allowed);
    if (!read_event(line + (is_end ? 4 : 3), is_end, &event))
        return status_fail(status, STATUS_USAGE,
                           "not a place of a session (%s STEP[/STAGE] SECONDS WIDTHxHEIGHT%s)",
                           is_end ? "end" : "at", is_end ? "" : " KEY [X Y]");
    if (session->count && session->events[session->count - 1].is_end)
        return status_fail(status, STATUS_USAGE, "comes after the end");
    session->ended = is_end;
    return append_event(session, &event) ||
           status_fail(status, STATUS_FAILED, "not enough memory for a session of this length");
}

static bool read_lines(Session *session, FILE *file, const char *name, FILE *scenario, Status *status)
{
    InputLines lines = {.stream = file, .name = name};
    char line[LINE_BYTES_MAX + 1];
    InputGot got;
    while ((got = input_line(&lines, line, sizeof line, status)) == INPUT_LINE && !lines.cut)
        if (!read_line(session, line, scenario, status))
            return status_prefix(status, "%s:%ld", name, lines.number);
    return got != INPUT_WRONG; /* a last line that was cut when the computer stopped is dropped */
}

static bool read_scenario(Session *session, const char *name, const char *text, size_t size, Status *status)
{
    if (size == 0)
        return status_fail(status, STATUS_USAGE, "%s: is no session (its scenario is missing)", name);
    FILE *memory = fmemopen((void *)text, size, "r");
    char origin[SESSION_NAME_MAX];
    snprintf(origin, sizeof origin, "%.200s (scenario)", name);
    bool sound = memory && scenario_read(memory, origin, &session->settings, status);
    if (memory)
        fclose(memory);
    if (!sound && !*status->text)
        status_fail(status, STATUS_FAILED, "not enough memory for a session");
    return sound;
}

Session *session_read_stream(FILE *file, const char *name, Status *status)
{
    Session *session = calloc(1, sizeof *session);
    char *text = NULL;
    size_t size = 0;
    FILE *scenario = open_memstream(&text, &size);
    bool sound = session && scenario;
    if (session)
        session->check = HASH_BEGIN;
    if (!sound)
        status_fail(status, STATUS_FAILED, "not enough memory for a session");
    sound = sound && read_lines(session, file, name, scenario, status);
    if (scenario && !text_stream_close(scenario, &text))
        sound = sound && status_fail(status, STATUS_FAILED, "not enough memory for a session");
    sound = sound && read_scenario(session, name, text, size, status);
    free(text);
    if (sound)
        return session;
    session_free(session);
    return NULL;
}

Session *session_read(const char *name, Status *status)
{
    FILE *file = input_open(name, SESSION_BYTES_MAX, status);
    if (!file)
        return NULL;
    Session *session = session_read_stream(file, name, status);
    fclose(file);
    return session;
}

void session_options(const Session *session, LaboratoryOptions *options)
{
    options->settings = &session->settings;
    options->scenario = session->scenario;
    options->paused = session->paused;
    options->first_start = session->first;
    options->lesson = *session->lesson ? session->lesson : NULL;
    options->student = *session->student ? session->student : NULL;
    options->reached = session->reached;
}

void session_facts(const Session *session, SessionFacts *facts)
{
    *facts = (SessionFacts){.student = session->student,
                            .lesson = session->lesson,
                            .program = session->program,
                            .version = session->version,
                            .ended = session->ended,
                            .sound = session->sound};
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

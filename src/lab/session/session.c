/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keeping a session: its keys in memory and, as they come, in a file; and reading one (session.h). */
#include "lab/session/session_internal.h"
#include "base/hash.h"
#include "base/input.h"
#include "base/text.h"
#include "base/visible.h"
#include "scenario/parameters.h"
#include "scenario/scenario.h"
#include "scenario/scenario_lines.h"
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

/* False: no memory, or the session is very long. */
static bool append(Session *session, const SessionEvent *event)
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
        session->full = !append(session, &event);
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

/* --- reading: a file from anybody, so every number has a range ---------------------------------------- */

enum { SIZE_MOST = 10000 /* cells */, SESSION_BYTES_MAX = 200000000 };

static const char *const allowed =
    "scenario NAME | paused | first | sheet WORD | lesson NAME | student NAME | version "
    "HASH PROGRAM | reached NAME PAGE | "
    "\"| ...\" | at ... | stop ... | end ... | check HASH";

/* Behind its first word. */
static bool read_event(char *line, bool has_key, SessionEvent *event)
{
    enum { PLACE, SECONDS, SIZE, NAME, X, Y, WORDS };
    char *words[WORDS + 1] = {NULL}, *rest;
    int count = 0, size[2];
    for (char *word = strtok_r(line, " ", &rest); word && count <= WORDS; word = strtok_r(NULL, " ", &rest))
        words[count++] = word;
    *event = (SessionEvent){.key = {.x = -1, .y = -1}};
    if (has_key ? count != X && count != WORDS : count != NAME)
        return false;
    char *place = words[PLACE], *stage = strchr(place, '/');
    long number = 0;
    event->on_the_way = *place == '~';
    if (stage)
        *stage++ = '\0';
    if (!text_to_long(place + event->on_the_way, &event->step) || event->step < 0 ||
        (stage && !text_to_long(stage, &number)) || number < 0 || number > 1000 ||
        !text_to_double(words[SECONDS], &event->seconds) || event->seconds < 0 ||
        event->seconds > SESSION_SECONDS_MOST || !text_to_size(words[SIZE], 0, SIZE_MOST, size))
        return false;
    event->stage = (int)number;
    event->width = size[0];
    event->height = size[1];
    if (!has_key)
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
        return status_refuse(status, "not a page of a lesson (reached NAME PAGE)");
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

/* What another version recorded ends elsewhere, or nowhere, when this one does it again. */
static bool is_foreign(const Session *session)
{
    return *session->program && strcmp(session->program, PACKAGE_VERSION) != 0;
}

static bool read_version(Session *session, const char *text, Status *status)
{
    const char *program;
    if (!read_hash(text, &session->version, &program) || !program || strlen(program) >= SESSION_PROGRAM_MAX)
        return status_refuse(status, "not a version (version HASH PROGRAM)");
    return strcpy(session->program, program);
}

static bool read_check(Session *session, const char *text, Status *status)
{
    const char *rest;
    uint64_t check;
    if (!read_hash(text, &check, &rest) || rest)
        return status_refuse(status, "not a check (check HASH)");
    session->sound = session->ended && check == session->check;
    return true;
}

static bool read_lesson(Session *session, const char *text, Status *status)
{
    return strlen(text) < sizeof session->lesson ? strcpy(session->lesson, text) != NULL
                                                 : status_refuse(status, "the lesson's name is too long");
}

static bool read_sheet(Session *session, const char *text, Status *status)
{
    const int sheet = text_place_in(text, parameter_sheet_words);
    session->sheet = sheet >= 0 ? parameter_sheet_words[sheet] : NULL;
    return sheet >= 0 || status_refuse(status, "not a sheet (sheet plain, sheet full)");
}

/* What a session says of its origin: a word, then a text. */
static const struct {
    const char *word;
    bool (*read)(Session *, const char *text, Status *);
} origins[] = {{"lesson ", read_lesson},
               {"sheet ", read_sheet},
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
        return status_refuse(status, "is not text in UTF-8");
    if (*line == '|') {
        if (ftell(scenario) > SCENARIO_BYTES_MAX)
            return status_refuse(status, "its scenario is too long");
        fprintf(scenario, "%s\n", line + 1 + (line[1] == ' '));
        return true;
    }
    if (strncmp(line, "scenario ", 9) == 0 && line[9] && strlen(line + 9) < sizeof session->scenario)
        return strcpy(session->scenario, line + 9);
    if (strncmp(line, "student ", 8) == 0 && line[8])
        return variant_student(line + 8, session->student, status);
    if (strncmp(line, "id ", 3) == 0 && line[3])
        return variant_student(line + 3, session->id, status);
    for (size_t i = 0; i < sizeof origins / sizeof *origins; i++) {
        const size_t length = strlen(origins[i].word);
        if (strncmp(line, origins[i].word, length) == 0 && line[length])
            return origins[i].read(session, line + length, status);
    }
    if (strcmp(line, "paused") == 0)
        return session->paused = true;
    if (strcmp(line, "first") == 0)
        return session->first = true;
    static const char *const words[] = {"at ", "stop ", "end "};
    enum { AT, STOP, END, EVENT_WORDS } word = AT;
    while (word < EVENT_WORDS && strncmp(line, words[word], strlen(words[word])) != 0)
        word++;
    if (word == EVENT_WORDS)
        return status_refuse(status, "unknown line: %.40s (%s)", line, allowed);
    if (!read_event(line + strlen(words[word]), word == AT, &event))
        return status_refuse(status, "not a place of a session (%sSTEP[/STAGE] SECONDS WIDTHxHEIGHT%s)",
                             words[word], word == AT ? " KEY [X Y]" : "");
    /* What a key did depends neither on the size of the screen nor on when it was pressed. */
    char text[sizeof event.key.name + 64];
    const int length = snprintf(text, sizeof text, "%ld/%d %s", event.step, event.stage, event.key.name);
    session->keys = hash_bytes(session->keys, text, (size_t)length + 1);
    event.is_stop = word == STOP;
    event.is_end = word == END;
    if (session->count && session->events[session->count - 1].is_end)
        return status_refuse(status, "comes after the end");
    session->ended = event.is_end;
    return append(session, &event) || status_fail(status, "not enough memory for a session of this length");
}

static bool read_scenario(Session *session, const char *name, const char *text, size_t size, Status *status)
{
    if (is_foreign(session))
        return true;
    if (size == 0)
        return status_refuse(status, "%s: is not a session (its scenario is missing)", name);
    if (!*session->program)
        return status_refuse(
            status, "%s: is not a session of matvib " PACKAGE_VERSION " (it names no version)", name);
    FILE *memory = fmemopen((void *)text, size, "r");
    char origin[SESSION_NAME_MAX];
    snprintf(origin, sizeof origin, "%.200s (scenario)", name);
    if (!memory)
        return no_memory(status);
    const bool sound = scenario_read(memory, origin, &session->settings, status);
    fclose(memory);
    return sound;
}

Session *session_read_stream(FILE *file, const char *name, Status *status)
{
    Session *session = calloc(1, sizeof *session);
    char *text = NULL;
    size_t size = 0;
    FILE *scenario = open_memstream(&text, &size);
    bool sound = session && scenario;
    InputLines lines = {.stream = file, .name = name};
    char line[SESSION_LINE_MAX + 1];
    InputGot got = INPUT_LINE;
    if (session)
        session->check = session->keys = HASH_BEGIN;
    if (!sound)
        no_memory(status);
    /* a last line that was cut when the computer stopped is dropped */
    while (sound && !is_foreign(session) &&
           (got = input_line(&lines, line, sizeof line, status)) == INPUT_LINE && !lines.cut)
        sound =
            read_line(session, line, scenario, status) || status_prefix(status, "%s:%ld", name, lines.number);
    sound = sound && got != INPUT_WRONG;
    if (scenario && !text_stream_close(scenario, &text))
        sound = sound && no_memory(status);
    sound = sound && read_scenario(session, name, text, size, status);
    free(text);
    if (sound)
        return session;
    session_free(session);
    return NULL;
}

Session *session_read_facts(const char *name, Status *status)
{
    FILE *file = input_open(name, SESSION_BYTES_MAX, status);
    if (!file)
        return NULL;
    Session *session = session_read_stream(file, name, status);
    fclose(file);
    return session;
}

Session *session_read(const char *name, Status *status)
{
    Session *session = session_read_facts(name, status);
    if (!session || !is_foreign(session))
        return session;
    status_refuse(status, "%s: is of matvib %s (this is %s, which replays its own sessions only)", name,
                  session->program, PACKAGE_VERSION);
    session_free(session);
    return NULL;
}

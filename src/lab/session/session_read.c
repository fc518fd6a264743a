/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reading the file of a session (session.h); a file from anybody, so every number has a range. */
#include "lab/session/session_internal.h"

#include "base/hash.h"
#include "base/input.h"
#include "base/text.h"
#include "base/visible.h"
#include "scenario/parameters.h"
#include "scenario/scenario.h"
#include "scenario/scenario_lines.h"

#include <stdlib.h>
#include <string.h>

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
    return session_append(session, &event) ||
           status_fail(status, "not enough memory for a session of this length");
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
        return status_fail(status, "not enough memory for a session");
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
        status_fail(status, "not enough memory for a session");
    /* a last line that was cut when the computer stopped is dropped */
    while (sound && !is_foreign(session) &&
           (got = input_line(&lines, line, sizeof line, status)) == INPUT_LINE && !lines.cut)
        sound =
            read_line(session, line, scenario, status) || status_prefix(status, "%s:%ld", name, lines.number);
    sound = sound && got != INPUT_WRONG;
    if (scenario && !text_stream_close(scenario, &text))
        sound = sound && status_fail(status, "not enough memory for a session");
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

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A table of words, line by line (roster.h); a file from anybody, so all of it has a bound. */
#include "cli/roster.h"

#include "base/input.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

enum { ROSTER_BYTES_MAX = 10000000, LINE_BYTES = 4096, CELLS_MAX = 64 };

typedef enum Role { ROLE_NAME, ROLE_FIRST, ROLE_LAST, ROLE_ID, ROLES } Role;

/* What a column is called, the better words first. */
static const char *const heads[ROLES][5] = {{"Full name", "Name"},
                                            {"First name", "Given name"},
                                            {"Surname", "Last name", "Family name"},
                                            {"ID number", "ID", "Email address", "Username"}};

typedef struct Roster {
    InputLines lines;
    char text[LINE_BYTES];
    char *cells[CELLS_MAX];
    int count;
    char separator;
    int at[ROLES]; /* columns; -1: none */
} Roster;

/* A cell without its quotes, in place; the end of it and its separator. NULL: a quote is not closed. */
static char *take_cell(char *from, char separator)
{
    char *to = from, *at = from;
    bool quoted = *at == '"';
    for (at += quoted; *at && (quoted || *at != separator); at++) {
        if (quoted && *at == '"' && at[1] != '"') {
            quoted = false;
            continue;
        }
        at += quoted && *at == '"';
        *to++ = *at;
    }
    char *next = *at ? at + 1 : at;
    *to = '\0';
    return quoted ? NULL : next;
}

/* The cells of the next line that has any. */
static InputGot read_row(Roster *roster, Status *status)
{
    InputGot got;
    do
        got = input_line(&roster->lines, roster->text, sizeof roster->text, status);
    while (got == INPUT_LINE && !roster->text[strspn(roster->text, " \t,;")]);
    if (got != INPUT_LINE)
        return got;
    if (!roster->separator)
        roster->separator = strchr(roster->text, ';') ? ';' : strchr(roster->text, '\t') ? '\t' : ',';
    const char *end = roster->text + strlen(roster->text);
    roster->count = 0;
    for (char *cell = roster->text; cell && cell < end && roster->count < CELLS_MAX;) {
        roster->cells[roster->count++] = cell;
        cell = take_cell(cell, roster->separator);
        if (!cell) {
            status_refuse(status, "%s:%ld: a quote is not closed", roster->lines.name, roster->lines.number);
            return INPUT_WRONG;
        }
    }
    return INPUT_LINE;
}

static int find_column(const Roster *roster, Role role)
{
    for (int word = 0; heads[role][word]; word++)
        for (int i = 0; i < roster->count; i++)
            if (strcasecmp(roster->cells[i], heads[role][word]) == 0)
                return i;
    return -1;
}

static const char *cell_of(const Roster *roster, Role role)
{
    const int at = roster->at[role];
    return at >= 0 && at < roster->count ? roster->cells[at] : "";
}

static bool enrol(const Roster *roster, Students *students, Status *status)
{
    char whole[LINE_BYTES], name[STUDENT_MAX], id[STUDENT_MAX] = "";
    snprintf(whole, sizeof whole, "%s %s %s", cell_of(roster, ROLE_NAME),
             roster->at[ROLE_NAME] < 0 ? cell_of(roster, ROLE_FIRST) : "",
             roster->at[ROLE_NAME] < 0 ? cell_of(roster, ROLE_LAST) : "");
    return (variant_student(whole, name, status) &&
            (!*cell_of(roster, ROLE_ID) || variant_student(cell_of(roster, ROLE_ID), id, status)) &&
            students_enrol(students, name, id, status)) ||
           status_prefix(status, "%s:%ld", roster->lines.name, roster->lines.number);
}

static bool read_head(Roster *roster, Status *status)
{
    const InputGot got = read_row(roster, status);
    for (Role role = 0; role < ROLES; role++)
        roster->at[role] = got == INPUT_LINE ? find_column(roster, role) : -1;
    return got != INPUT_WRONG &&
           (roster->at[ROLE_NAME] >= 0 || (roster->at[ROLE_FIRST] >= 0 && roster->at[ROLE_LAST] >= 0) ||
            status_refuse(
                status,
                "%s:1: no column of names in the head (Full name, or First name and Surname; ID number "
                "where there is one)",
                roster->lines.name));
}

bool roster_read(const char *file, Students *students, Status *status)
{
    FILE *stream = input_open(file, ROSTER_BYTES_MAX, status);
    if (!stream)
        return false;
    Roster roster = {.lines = {.stream = stream, .name = file}};
    InputGot got = INPUT_LINE;
    bool sound = read_head(&roster, status);
    while (sound && (got = read_row(&roster, status)) == INPUT_LINE)
        sound = enrol(&roster, students, status);
    fclose(stream);
    return sound && got != INPUT_WRONG;
}

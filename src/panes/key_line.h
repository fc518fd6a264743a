/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is in the key line in place of keys: a question, or a message. */
#ifndef PANES_KEY_LINE_H
#define PANES_KEY_LINE_H

#include "scenario/assignment.h"

#include <stdbool.h>

typedef enum MessageKind { MESSAGE_NONE, MESSAGE_INFO, MESSAGE_WARNING, MESSAGE_ERROR } MessageKind;

typedef struct Message {
    MessageKind kind;
    char text[512];
} Message;

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

#endif

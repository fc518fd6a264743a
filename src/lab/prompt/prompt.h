/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Questions at the foot of the screen: asked, typed into, answered. A question is answered by a function of
 * the code that asked it, and may bring keys and completions of its own. */
#ifndef LAB_PROMPT_PROMPT_H
#define LAB_PROMPT_PROMPT_H

#include "base/status.h"
#include "terminal/keys.h"
#include "panes/entry.h"

#include <dirent.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct Laboratory Laboratory;

enum { LINE_HISTORY_MAX = 32 };

/* What was entered behind `:`, the newest last. */
typedef struct LineHistory {
    char lines[LINE_HISTORY_MAX][sizeof((Prompt *)0)->text];
    char unfinished[sizeof((Prompt *)0)->text]; /* what was being typed when an earlier one was fetched */
    int count, at;                              /* at: the one on screen; count: the unfinished one */
} LineHistory;

/* Takes an answer to a prompt. False: refused, the status says why, and the prompt stays and shows it. */
typedef bool (*Answer)(Laboratory *, const char *text, Status *);

/* What is special about typing the answer to one kind of question; each member may be NULL. */
typedef struct Completion Completion;
typedef struct Typing {
    bool yes_no;                                        /* yes or no is asked, not a text */
    bool (*key)(Laboratory *, const char *key);         /* false: the key does what it does everywhere */
    void (*offer)(Completion *, const Laboratory *lab); /* what Tab completes */
    void (*typed)(Laboratory *, const char *key);       /* the text has changed */
    bool retyped; /* a name, or an answer: another replaces a refused one, and none of its letters is a key */
    const char *leaves; /* but these, which no such answer begins with */
} Typing;

typedef struct Prompting {
    Prompt shown; /* behind screen.prompt */
    Answer answer;
    const Typing *typing;   /* NULL: nothing special */
    bool fresh;             /* the text is a proposal: a first character replaces it */
    int tabbed;             /* candidates that Tab has shown; the next Tab shows those behind them */
    int suggestion;         /* for a duel, the one that is offered; -1: what was the last one's */
    ScenarioList scenarios; /* behind shown->scenarios */
    LineHistory past;
} Prompting;

extern const Typing prompt_yes_no, prompt_retyped; /* with that alone */

/* Typing NULL: nothing is special. */
void prompt_ask(Laboratory *, Answer, const Typing *, const char *text, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/* Asks whether a file that exists is replaced: only y does. */
void prompt_ask_replace(Laboratory *, Answer, const char *name);

void prompt_fill(Prompting *, const char *text); /* in place of what was typed; typing replaces it */
void prompt_close(Prompting *);

void prompt_key(Laboratory *, const Key *);

/* complete.c: Tab, and what it offers in the questions that have something to offer. */
void complete_tab(Laboratory *);
void complete_line(Completion *, const Laboratory *);
void complete_assignments(Completion *, const Laboratory *); /* KEY=VALUE ... */
void complete_scenarios(Completion *, const Laboratory *);
void complete_files(Completion *, const Laboratory *);
int complete_by_name(const struct dirent **, const struct dirent **); /* an order for scandir() */

/* Editing one line of UTF-8 text; shared by fields and prompts. */

/* Applies a key to a text of at most size - 1 bytes; the cursor counts characters. `fresh`: the first
 * printing character replaces the whole text. False: not a key of an editor. */
bool prompt_edit_line(char *text, size_t size, int *cursor, const char *key, bool fresh);

/* The command line behind `:`: commands by name, KEY=VALUE, a time, and verbs that take arguments. */

void line_ask(Laboratory *);

/* Does what a line says, without remembering it. False: the status says why not. */
bool line_run(Laboratory *, const char *line, Status *);

#endif

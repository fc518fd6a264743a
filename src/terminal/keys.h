/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keys by name, read through curses.
 *
 * Names: a printing character stands for itself ("q", "?", "Ω"); "Space" "Enter" "Tab" "S-Tab" "Esc"
 * "Backspace" "Delete" "Insert" "Home" "End" "PageUp" "PageDown" "Up" "Down" "Left" "Right" "F1".."F12";
 * "^A" is Control-A; "S-" "M-" "C-" before a named key are Shift, Alt, Control; "Click", "Drag", "WheelUp"
 * and "WheelDown" carry the cell under the mouse; "P-" before a character, "Space" or "Enter" says that it
 * was pasted.
 *
 * What a terminal's description does not tell is given to curses by define_key(), so Home is Home under any
 * TERM. What curses does not know it passes on byte by byte; by the grammar of such sequences (ECMA-48) they
 * are swallowed whole: a focus report or a strange function key never turns into Esc, "[" and digits. */
#ifndef TERMINAL_KEYS_H
#define TERMINAL_KEYS_H

#include <stdbool.h>

enum { KEY_NAME_MAX = 16, KEYS_WAITING = 10 };

typedef struct Key {
    char name[KEY_NAME_MAX];
    int x, y; /* of the mouse, from 0; else -1 */
} Key;

typedef enum KeyState {
    KEYS_GROUND,
    KEYS_ESCAPE,   /* after Esc, which began nothing that curses knows */
    KEYS_CSI,      /* after Esc [ */
    KEYS_SS3,      /* after Esc O */
    KEYS_STRING,   /* in a control string, up to BEL or Esc \ */
    KEYS_MOUSE,    /* bytes of an unrequested mouse report are to come */
    KEYS_CHARACTER /* bytes of a UTF-8 character are to come */
} KeyState;

typedef struct KeyReader {
    KeyState state;
    bool pasting;              /* in bracketed paste */
    bool held;                 /* the mouse's button */
    bool answered;             /* the terminal told that it can hold a picture back */
    bool parameters;           /* of a CSI: one was given */
    char string_end;           /* the byte before in a string, if it was Esc */
    int wanted;                /* bytes to come, KEYS_MOUSE and KEYS_CHARACTER */
    char character[5];         /* as far as it has come */
    double fed;                /* when the last byte came, s */
    Key waiting[KEYS_WAITING]; /* read together with one that was given */
    int n_waiting, next_waiting;
} KeyReader;

struct _win_st;

/* Tells curses the sequences that a description may lack, and how long to wait behind Esc. Once for each
 * terminal that is opened; keys come from this window. */
void keys_define(struct _win_st *);

/* The next key that has come in; false: none. Never waits for more than the 25 ms after Esc. `now` is any
 * clock's time in s. */
bool keys_read(KeyReader *, struct _win_st *from, double now, Key *);

/* What was pasted, of the name of such a key; NULL: it was pressed. */
const char *keys_pasted(const char *name);

/* Whether a name is one of those above; the mouse's apart. */
bool keys_known(const char *name);

#endif

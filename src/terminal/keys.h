/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keys by name, read through curses.
 *
 * Names: a printing character stands for itself ("q", "?", "Ω"); "Space" "Enter" "Tab" "S-Tab" "Esc"
 * "Backspace" "Delete" "Insert" "Home" "End" "PageUp" "PageDown" "Up" "Down" "Left" "Right" "F1".."F12";
 * "^A" is Control-A; "S-" "M-" "C-" before a named key are Shift, Alt, Control; "Click", "Drag", "WheelUp"
 * and "WheelDown" carry the cell under the mouse; "P-" before a character, "Space" or "Enter" says that it
 * was pasted.
 *
 * Bytes are read by the grammar of such sequences (ECMA-48), so Home is Home under any TERM, and what is not
 * known is swallowed whole: a focus report or a strange function key never turns into Esc, "[" and digits. A
 * line may tear a sequence: how long the rest is waited for depends on what has come. */
#ifndef TERMINAL_KEYS_H
#define TERMINAL_KEYS_H

#include <stdbool.h>
#include <stddef.h>

enum { KEY_NAME_MAX = 16, KEYS_ROOM = 1024, KEY_SEQUENCE_MAX = 64 };

typedef struct Key {
    char name[KEY_NAME_MAX];
    int x, y; /* of the mouse, from 0; else -1 */
} Key;

typedef enum KeyState {
    KEYS_GROUND,
    KEYS_ESCAPE,     /* after Esc, or after two */
    KEYS_CSI,        /* after Esc [ */
    KEYS_SS3,        /* after Esc O */
    KEYS_CONSOLE,    /* after Esc [ [ */
    KEYS_MOUSE,      /* after Esc [ M: three bytes are to come */
    KEYS_STRING,     /* in a control string, up to BEL or Esc \ */
    KEYS_STRING_END, /* in it, after Esc */
    KEYS_CHARACTER   /* bytes of a UTF-8 character are to come */
} KeyState;

typedef struct KeyReader {
    KeyState state;
    bool alt;                    /* two Esc came: Alt with a key of rxvt's, or both were pressed */
    bool pasting;                /* in bracketed paste */
    bool answered;               /* the terminal told that it can hold a picture back */
    int reports;                 /* status reports (CSI 0 n) that have come */
    int wanted;                  /* bytes to come, KEYS_CHARACTER */
    char text[KEY_SEQUENCE_MAX]; /* of a sequence or a character, as far as it has come */
    int length, n_pasted;        /* bytes so far */
    double escape_seconds;       /* how long Esc alone waits */
    double fed, began;           /* when the last byte came, and the first of what has begun, s */
    double paste_began;
    unsigned char bytes[KEYS_ROOM];
    size_t next, count; /* of these bytes */
    Key waiting;        /* given next */
    bool waits;
} KeyReader;

/* `escdelay`: milliseconds for which the rest of a sequence is waited for after Esc; NULL, or no such number:
 * 100. */
void keys_open(KeyReader *, const char *escdelay);

/* Bytes that have come, KEYS_ROOM at most, once keys_next() has used up those before. `now` is any clock's
 * time in s. */
void keys_feed(KeyReader *, const void *bytes, size_t count, double now);

/* The next key; false: all bytes are used up. */
bool keys_next(KeyReader *, Key *);

/* No more bytes have come: once the time is due, the sequence that has begun ends, which may be a key. */
bool keys_silence(KeyReader *, double now, Key *);
double keys_due(const KeyReader *); /* INFINITY: nothing has begun */

/* What was pasted, of the name of such a key; NULL: it was pressed. */
const char *keys_pasted(const char *name);

/* Whether a name is one of those above; the mouse's apart. */
bool keys_known(const char *name);

/* The key that types the first character of a text; returns what is behind it. */
const char *keys_of_text(const char *text, char name[KEY_NAME_MAX]);

#endif

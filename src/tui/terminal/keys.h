/* Bytes from a terminal in, names of keys out: a state machine that knows no terminal and no clock.
 *
 * Names: a printing character stands for itself ("q", "?", "Ω"); "Space" "Enter" "Tab" "S-Tab" "Esc"
 * "Backspace" "Delete" "Insert" "Home" "End" "PageUp" "PageDown" "Up" "Down" "Left" "Right" "F1".."F12";
 * "^A" is Control-A; "S-" "M-" "C-" before a named key are Shift, Alt, Control; "Click", "WheelUp" and
 * "WheelDown" carry the cell under the mouse; "P-" before a character, "Space" or "Enter" says that it was
 * pasted.
 *
 * Sequences are told apart by their grammar (ECMA-48) rather than by the terminal's description, so Home is
 * Home under any TERM, and what is not understood is swallowed whole: a focus report or a strange function
 * key never turns into Esc, "[" and digits. */
#ifndef TUI_KEYS_H
#define TUI_KEYS_H

#include <stdbool.h>
#include <stddef.h>

enum { KEY_NAME_MAX = 16, KEY_PARAMETERS_MAX = 4 };

typedef struct Key {
    char name[KEY_NAME_MAX];
    int x, y; /* of the mouse, from 0 */
} Key;

typedef enum KeyState {
    KEY_GROUND,
    KEY_ESCAPE,   /* after Esc */
    KEY_CSI,      /* after Esc [ */
    KEY_LINUX,    /* after Esc [ [: a function key of the Linux console */
    KEY_SS3,      /* after Esc O */
    KEY_STRING,   /* in a control string, up to BEL or Esc \ */
    KEY_PASTE,    /* in bracketed paste, up to Esc [ 201 ~ */
    KEY_MOUSE,    /* three bytes of the old mouse report are to come */
    KEY_CHARACTER /* bytes of a UTF-8 character are to come */
} KeyState;

typedef struct KeyDecoder {
    KeyState state;
    int escapes;                        /* Esc before the sequence: 1, or 2 for Alt */
    char prefix;                        /* '<', '?', ... of a CSI; 0: none */
    int parameters[KEY_PARAMETERS_MAX]; /* -1: not given */
    int n_parameters;
    int wanted;   /* bytes to come, KEY_MOUSE, KEY_CHARACTER and KEY_PASTE */
    char text[5]; /* of the character */
    size_t length;
    size_t matched; /* bytes of the end of a paste or a string seen; more: another sequence in a paste */
} KeyDecoder;

void keys_reset(KeyDecoder *);

/* Takes one byte. True: it completed a key, which stands in *key. */
bool keys_feed(KeyDecoder *, unsigned char byte, Key *key);

/* What was pasted, of the name of such a key; NULL: it was pressed. */
const char *keys_pasted(const char *name);

/* Whether a name is one of those above; the mouse's apart. */
bool keys_known(const char *name);

/* How long to wait for the next byte before keys_expire() is due, in milliseconds; -1: nothing is open. */
int keys_timeout(const KeyDecoder *);

/* No byte came in time: a lone Esc was the key, anything else is dropped. Call until it returns false. */
bool keys_expire(KeyDecoder *, Key *key);

#endif

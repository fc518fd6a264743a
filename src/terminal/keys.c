/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "terminal/keys.h"

#include <stdio.h>
#include <string.h>

#include <curses.h>

#define SEQUENCE_SECONDS 0.5 /* after which a sequence is given up */
#define PASTE_SECONDS    5.0 /* the rest of it must not become keys where the line is slow */

enum { ESCAPE_MS = 25, MODIFIERS = 8, FIRST_CODE = 0x2000 };

/* Codes of ours, beyond those that curses gives to keys of a description. */
enum {
    CODE_PASTE = FIRST_CODE - 16, /* bracketed paste begins */
    CODE_PASTE_END,
    CODE_HOLDS /* the terminal holds a picture back until it is whole */
};

/* Keys by what terminals send. Of one with a letter "Esc [ letter" and "Esc O letter", of one with a number
 * "Esc [ number ~", each also with a second parameter: 1 + Shift + 2 Alt + 4 Control. */
static const struct {
    const char *name;
    int code; /* of curses; 0: it has none, or another row has it */
    char letter;
    int number;
} rows[] = {
    {"Up", KEY_UP, 'A', 0},       {"Down", KEY_DOWN, 'B', 0},
    {"Right", KEY_RIGHT, 'C', 0}, {"Left", KEY_LEFT, 'D', 0},
    {"Home", KEY_HOME, 'H', 1},   {"End", KEY_END, 'F', 4},
    {"Home", KEY_FIND, 0, 7},     {"End", KEY_SELECT, 0, 8},
    {"Insert", KEY_IC, 0, 2},     {"Delete", KEY_DC, 0, 3},
    {"PageUp", KEY_PPAGE, 0, 5},  {"PageDown", KEY_NPAGE, 0, 6},
    {"F1", KEY_F(1), 'P', 11},    {"F2", KEY_F(2), 'Q', 12},
    {"F3", KEY_F(3), 'R', 13},    {"F4", KEY_F(4), 'S', 14},
    {"F5", KEY_F(5), 0, 15},      {"F6", KEY_F(6), 0, 17},
    {"F7", KEY_F(7), 0, 18},      {"F8", KEY_F(8), 0, 19},
    {"F9", KEY_F(9), 0, 20},      {"F10", KEY_F(10), 0, 21},
    {"F11", KEY_F(11), 0, 23},    {"F12", KEY_F(12), 0, 24},
    {"Enter", KEY_ENTER, 0, 0},   {"Backspace", KEY_BACKSPACE, 0, 0},
    {"S-Tab", KEY_BTAB, 0, 0},
};
enum { N_ROWS = sizeof rows / sizeof *rows };

/* Sequences of one key each. */
static const struct {
    const char *sequence;
    int code;
} singles[] = {
    {"\033[Z", KEY_BTAB},           {"\033\t", KEY_BTAB}, /* the Linux console */
    {"\033[[A", KEY_F(1)},          {"\033[[B", KEY_F(2)},         {"\033[[C", KEY_F(3)},
    {"\033[[D", KEY_F(4)},          {"\033[[E", KEY_F(5)},         {"\033OM", KEY_ENTER},
    {"\033[200~", CODE_PASTE},      {"\033[201~", CODE_PASTE_END}, {"\033[?2026;1$y", CODE_HOLDS},
    {"\033[?2026;2$y", CODE_HOLDS},
};

/* The keypad in application mode, which PuTTY keeps even with NumLock: Esc O and a letter. */
static const char keypad_letters[] = "jklmnopqrstuvwxyX", keypad_keys[] = "*+,-./0123456789=";

static const char *const modifier_names[MODIFIERS] = {"", "S-", "M-", "S-M-", "C-", "S-C-", "M-C-", "S-M-C-"};

/* --- what curses is told --------------------------------------------------------------------------- */

static void define(int code, const char *format, int a, int b)
{
    char sequence[24];
    snprintf(sequence, sizeof sequence, format, a, b);
    define_key(sequence, code);
}

static int modified_code(int row, int modifiers)
{
    return FIRST_CODE + MODIFIERS * row + modifiers;
}

static void define_letter(int row)
{
    const char letter = rows[row].letter;
    define(rows[row].code, "\033[%c", letter, 0);
    define(rows[row].code, "\033O%c", letter, 0);
    define(modified_code(row, 2), "\033\033[%c", letter, 0); /* rxvt: Alt */
    define(modified_code(row, 2), "\033\033O%c", letter, 0);
    for (int modifiers = 1; modifiers < MODIFIERS; modifiers++)
        define(modified_code(row, modifiers), "\033[1;%d%c", 1 + modifiers, letter);
}

static void define_number(int row)
{
    const int number = rows[row].number;
    define(rows[row].code, "\033[%d~", number, 0);
    define(modified_code(row, 1), "\033[%d$", number, 0); /* rxvt: Shift, Control, both, Alt */
    define(modified_code(row, 4), "\033[%d^", number, 0);
    define(modified_code(row, 5), "\033[%d@", number, 0);
    define(modified_code(row, 2), "\033\033[%d~", number, 0);
    for (int modifiers = 1; modifiers < MODIFIERS; modifiers++)
        define(modified_code(row, modifiers), "\033[%d;%d~", number, 1 + modifiers);
}

void keys_define(WINDOW *from)
{
    keypad(from, TRUE); /* takes the description's keys; what comes later replaces them */
    set_escdelay(ESCAPE_MS);
    for (int row = 0; row < N_ROWS; row++) {
        if (rows[row].letter)
            define_letter(row);
        if (rows[row].number)
            define_number(row);
    }
    for (size_t i = 0; i < sizeof singles / sizeof *singles; i++)
        define_key(singles[i].sequence, singles[i].code);
    for (int i = 0; keypad_letters[i]; i++)
        define(modified_code(N_ROWS + i, 0), "\033O%c", keypad_letters[i], 0);
}

/* --- what curses tells ----------------------------------------------------------------------------- */

static bool give(const KeyReader *reader, Key *key, const char *modifiers, const char *name)
{
    *key = (Key){.x = -1, .y = -1};
    snprintf(key->name, sizeof key->name, "%s%s%s", reader->pasting ? "P-" : "", modifiers, name);
    return true;
}

static bool give_letter(const KeyReader *reader, Key *key, const char *modifiers, int letter)
{
    return give(reader, key, modifiers, (char[]){(char)letter, '\0'});
}

static void keep(KeyReader *reader, const Key *key)
{
    if (reader->n_waiting < KEYS_WAITING)
        reader->waiting[reader->n_waiting++] = *key;
}

static bool give_waiting(KeyReader *reader, Key *key)
{
    if (reader->next_waiting < reader->n_waiting) {
        *key = reader->waiting[reader->next_waiting++];
        return true;
    }
    reader->next_waiting = reader->n_waiting = 0;
    return false;
}

/* The name of an event; NULL: it has none. Motion is told while the button is held, by some terminals always.
 */
static const char *name_event(KeyReader *reader, const MEVENT *event)
{
    const bool held = reader->held;
    if (event->bstate & (BUTTON1_PRESSED | BUTTON1_RELEASED))
        reader->held = (event->bstate & BUTTON1_PRESSED) != 0;
    if (event->bstate & BUTTON1_PRESSED)
        return held ? "Drag" : "Click";
    if (event->bstate & REPORT_MOUSE_POSITION)
        return held ? "Drag" : NULL;
    return event->bstate & BUTTON4_PRESSED ? "WheelUp" : event->bstate & BUTTON5_PRESSED ? "WheelDown" : NULL;
}

/* Events that came together, which curses tells from the last to the first. Of a way only its end counts. */
static bool take_mouse(KeyReader *reader, Key *key)
{
    MEVENT events[KEYS_WAITING];
    int count = 0;
    while (count < KEYS_WAITING && getmouse(&events[count]) == OK)
        count++;
    while (count-- > 0) {
        const char *name = name_event(reader, &events[count]);
        if (!name || reader->pasting || events[count].x < 0 || events[count].y < 0)
            continue;
        const bool goes_on = reader->n_waiting > 0 && strcmp(name, "Drag") == 0 &&
                             strcmp(reader->waiting[reader->n_waiting - 1].name, name) == 0;
        give(reader, key, "", name);
        key->x = events[count].x;
        key->y = events[count].y;
        reader->n_waiting -= goes_on;
        keep(reader, key);
    }
    return give_waiting(reader, key);
}

static bool name_code(const KeyReader *reader, int code, Key *key)
{
    for (int row = 0; row < N_ROWS; row++)
        if (code == rows[row].code)
            return give(reader, key, "", rows[row].name);
    const int row = (code - FIRST_CODE) / MODIFIERS;
    if (code < FIRST_CODE || row >= N_ROWS + (int)sizeof keypad_keys - 1)
        return false;
    return row < N_ROWS ? give(reader, key, modifier_names[(code - FIRST_CODE) % MODIFIERS], rows[row].name)
                        : give_letter(reader, key, "", keypad_keys[row - N_ROWS]);
}

static bool take_code(KeyReader *reader, int code, Key *key)
{
    const bool escaped = reader->state == KEYS_ESCAPE;
    reader->state = KEYS_GROUND; /* what was begun was cut short */
    if (code == KEY_MOUSE)
        return take_mouse(reader, key);
    if (code == CODE_PASTE || code == CODE_PASTE_END)
        reader->pasting = code == CODE_PASTE;
    if (code == CODE_HOLDS)
        reader->answered = true;
    if (reader->pasting || !name_code(reader, code, key)) /* in a paste only text means something */
        return false;
    if (escaped) { /* Esc, and then a key */
        keep(reader, key);
        give(reader, key, "", "Esc");
    }
    return true;
}

static bool is_continuation(int byte)
{
    return (byte & 0xc0) == 0x80;
}

static bool begin(KeyReader *reader, KeyState state)
{
    reader->state = state;
    reader->parameters = false;
    reader->string_end = '\0';
    return false;
}

/* Bytes of UTF-8, in any locale; what is none is dropped. */
static bool begin_character(KeyReader *reader, int byte)
{
    reader->wanted = byte >= 0xc2 && byte < 0xe0   ? 1
                     : byte >= 0xe0 && byte < 0xf0 ? 2
                     : byte >= 0xf0 && byte < 0xf5 ? 3
                                                   : 0;
    reader->character[0] = (char)byte;
    reader->character[1] = '\0';
    return begin(reader, reader->wanted > 0 ? KEYS_CHARACTER : KEYS_GROUND);
}

static bool take_continuation(KeyReader *reader, int byte, Key *key)
{
    const size_t length = strlen(reader->character);
    reader->character[length] = (char)byte;
    reader->character[length + 1] = '\0';
    if (--reader->wanted > 0)
        return false;
    reader->state = KEYS_GROUND;
    return give(reader, key, "", reader->character);
}

static bool take_control(const KeyReader *reader, int byte, Key *key)
{
    if (byte == '\r' || byte == '\n')
        return give(reader, key, "", "Enter");
    if (reader->pasting)
        return byte == '\t' && give(reader, key, "", "Space");
    if (byte == '\t')
        return give(reader, key, "", "Tab");
    if (byte == 0x08 || byte == 0x7f)
        return give(reader, key, "", "Backspace");
    return give_letter(reader, key, "^", byte + '@');
}

static bool take_ground(KeyReader *reader, int byte, Key *key)
{
    reader->state = KEYS_GROUND;
    if (byte == 0x1b)
        return begin(reader, KEYS_ESCAPE);
    if (byte < ' ' || byte == 0x7f)
        return take_control(reader, byte, key);
    if (byte >= 0x80)
        return begin_character(reader, byte);
    return byte == ' ' ? give(reader, key, "", "Space") : give_letter(reader, key, "", byte);
}

/* Behind an Esc that began nothing known. */
static bool take_escape(KeyReader *reader, int byte, Key *key)
{
    switch (byte) {
    case '[':
        return begin(reader, KEYS_CSI);
    case 'O':
        return begin(reader, KEYS_SS3);
    case 'P':
    case ']':
    case 'X':
    case '^':
    case '_':
        return begin(reader, KEYS_STRING);
    case 0x1b: /* the one before was pressed, of this one is still to be seen */
        return !reader->pasting && give(reader, key, "", "Esc");
    default:
        reader->state = KEYS_GROUND;
        return !reader->pasting && byte > ' ' && byte < 0x7f && give_letter(reader, key, "M-", byte);
    }
}

/* Swallows; the last byte of a CSI is one of @ to ~. */
static bool take_csi(KeyReader *reader, int byte)
{
    if (byte >= ' ' && byte < '@') {
        reader->parameters = true;
        return false;
    }
    if (byte == '[' && !reader->parameters) { /* a function key of the Linux console: one byte more */
        reader->wanted = 1;
        return begin(reader, KEYS_MOUSE);
    }
    if (byte == 'M' && !reader->parameters) { /* the old report of the mouse */
        reader->wanted = 3;
        return begin(reader, KEYS_MOUSE);
    }
    return begin(reader, KEYS_GROUND);
}

static bool take_string(KeyReader *reader, int byte)
{
    const bool ends = byte == 0x07 || (reader->string_end == 0x1b && byte == '\\');
    reader->string_end = (char)byte;
    return ends ? begin(reader, KEYS_GROUND) : false;
}

static bool take_byte(KeyReader *reader, int byte, Key *key)
{
    const bool in_sequence = reader->state == KEYS_CSI || reader->state == KEYS_SS3;
    /* a control byte or a letter of another script: the sequence was cut short, this begins anew */
    if (in_sequence && (byte < ' ' || byte >= 0x7f))
        return take_ground(reader, byte, key);
    switch (reader->state) {
    case KEYS_ESCAPE:
        return take_escape(reader, byte, key);
    case KEYS_CSI:
        return take_csi(reader, byte);
    case KEYS_SS3:
        return byte >= '0' && byte <= '9' ? false : begin(reader, KEYS_GROUND);
    case KEYS_STRING:
        return take_string(reader, byte);
    case KEYS_MOUSE:
        return --reader->wanted == 0 ? begin(reader, KEYS_GROUND) : false;
    case KEYS_CHARACTER:
        return is_continuation(byte) ? take_continuation(reader, byte, key) : take_ground(reader, byte, key);
    case KEYS_GROUND:
    default:
        return take_ground(reader, byte, key);
    }
}

/* A sequence that was cut short is given up after a while. */
static void expire(KeyReader *reader, double now)
{
    if (now - reader->fed > SEQUENCE_SECONDS)
        reader->state = KEYS_GROUND;
    if (now - reader->fed > PASTE_SECONDS)
        reader->pasting = false;
}

bool keys_read(KeyReader *reader, WINDOW *from, double now, Key *key)
{
    if (give_waiting(reader, key))
        return true;
    expire(reader, now);
    /* behind a report of the mouse that it does not pass on curses once says ERR though more has come */
    for (int code, silent = 0; silent < 2;) {
        code = wgetch(from);
        silent = code == ERR ? silent + 1 : 0;
        if (code == ERR)
            continue;
        reader->fed = now;
        if (code <= 0xff ? take_byte(reader, code, key) : take_code(reader, code, key))
            return true;
    }
    if (reader->state != KEYS_ESCAPE)
        return false;
    /* curses has waited: nothing stands behind it, so it was pressed */
    reader->state = KEYS_GROUND;
    return !reader->pasting && give(reader, key, "", "Esc");
}

/* --- names ----------------------------------------------------------------------------------------- */

static bool is_named(const char *name)
{
    static const char *const names[] = {"Space", "Tab", "Esc"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(name, names[i]) == 0)
            return true;
    for (int row = 0; row < N_ROWS; row++)
        if (strcmp(name, rows[row].name) == 0)
            return true;
    return false;
}
const char *keys_pasted(const char *name)
{
    return name[0] == 'P' && name[1] == '-' && name[2] ? name + 2 : NULL;
}

bool keys_known(const char *name)
{
    static const char order[] = "SMC";
    size_t length = 1;
    if (!*name)
        return false;
    if (keys_pasted(name))
        return keys_known(name + 2);
    while (((unsigned char)name[length] & 0xc0) == 0x80)
        length++;
    if (!name[length])
        return true;
    if (name[0] == '^')
        return name[1] >= '@' && name[1] <= '_' && !name[2];
    const char *base = name;
    for (const char *modifier = order; *modifier; modifier++)
        if (base[0] == *modifier && base[1] == '-')
            base += 2;
    return is_named(base) || (base == name + 2 && name[0] == 'M' && base[0] > ' ' && !base[1]);
}

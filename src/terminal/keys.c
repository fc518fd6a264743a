/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "terminal/keys.h"

#include "base/assertion.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Seconds of silence, and in all, after which what has begun is given up. */
#define ESCAPE_SECONDS 0.1 /* behind a lone Esc, where ESCDELAY does not say */
#define BYTE_SECONDS   1.0 /* to the next byte of a sequence that is known to be one */
#define PASTE_SILENCE  5.0 /* the rest of it must not become keys where the line is slow */
#define PASTE_SECONDS  10.0

enum { ESCDELAY_MAX = 10000, STRING_MAX = 4096, PASTE_MAX = 1 << 20 };
enum { SHIFT = 1, ALT = 2, CONTROL = 4, MODIFIERS = 8 };

/* Keys by what terminals send. Of one with a letter "Esc [ letter" and "Esc O letter", of one with a number
 * "Esc [ number ~", each also with a second parameter: 1 + Shift + 2 Alt + 4 Control. */
static const struct {
    const char *name;
    char letter;
    int number;
} rows[] = {
    {"Up", 'A', 0},      {"Down", 'B', 0},   {"Right", 'C', 0}, {"Left", 'D', 0}, {"Home", 'H', 1},
    {"End", 'F', 4},     {"Home", 0, 7},     {"End", 0, 8},     {"Insert", 0, 2}, {"Delete", 0, 3},
    {"PageUp", 0, 5},    {"PageDown", 0, 6}, {"F1", 'P', 11},   {"F2", 'Q', 12},  {"F3", 'R', 13},
    {"F4", 'S', 14},     {"F5", 0, 15},      {"F6", 0, 17},     {"F7", 0, 18},    {"F8", 0, 19},
    {"F9", 0, 20},       {"F10", 0, 21},     {"F11", 0, 23},    {"F12", 0, 24},   {"Enter", 0, 0},
    {"Backspace", 0, 0}, {"Space", 0, 0},    {"Tab", 0, 0},     {"Esc", 0, 0},
};
enum { N_ROWS = sizeof rows / sizeof *rows };

/* The keypad in application mode, which PuTTY keeps even with NumLock: Esc O and a letter. */
static const char keypad_letters[] = "jklmnopqrstuvwxyX", keypad_keys[] = "*+,-./0123456789=";

void keys_open(KeyReader *reader, const char *escdelay)
{
    char *end;
    const long delay = escdelay && *escdelay ? strtol(escdelay, &end, 10) : -1;
    const bool sound = delay >= 0 && delay <= ESCDELAY_MAX && !*end;
    *reader = (KeyReader){.escape_seconds = sound ? (double)delay / 1000 : ESCAPE_SECONDS};
}

/* --- keys that are complete ------------------------------------------------------------------------ */

static bool give(const KeyReader *reader, Key *key, int modifiers, const char *name)
{
    static const char *const words[MODIFIERS] = {"", "S-", "M-", "S-M-", "C-", "S-C-", "M-C-", "S-M-C-"};
    *key = (Key){.x = -1, .y = -1};
    snprintf(key->name, sizeof key->name, "%s%s%.9s", reader->pasting ? "P-" : "", words[modifiers], name);
    return true;
}

static bool give_letter(const KeyReader *reader, Key *key, int modifiers, int letter)
{
    return give(reader, key, modifiers, (char[]){(char)letter, '\0'});
}

/* Esc was pressed before this key. */
static bool give_behind_escape(KeyReader *reader, Key *key)
{
    reader->waiting = *key;
    reader->waits = true;
    return give(reader, key, 0, "Esc");
}

static bool give_row(const KeyReader *reader, Key *key, int modifiers, char letter, int number)
{
    for (int row = 0; row < N_ROWS; row++)
        if (letter ? rows[row].letter == letter : number > 0 && rows[row].number == number)
            return give(reader, key, modifiers | (reader->alt ? ALT : 0), rows[row].name);
    return false;
}

/* A report of the mouse: what was pressed, +32: moved with it held, +4, 8, 16: modifiers; from which cell. */
static bool give_mouse(const KeyReader *reader, Key *key, int button, bool released, int x, int y)
{
    const int what = button & ~(4 | 8 | 16);
    const char *name = released     ? NULL
                       : what == 0  ? "Click"
                       : what == 32 ? "Drag"
                       : what == 64 ? "WheelUp"
                       : what == 65 ? "WheelDown"
                                    : NULL;
    if (!name || x < 0 || y < 0)
        return false;
    give(reader, key, 0, name);
    key->x = x;
    key->y = y;
    return true;
}

/* --- sequences ------------------------------------------------------------------------------------- */

static bool begin(KeyReader *reader, KeyState state)
{
    reader->state = state;
    reader->text[reader->length = 0] = '\0';
    return false;
}

/* Numbers separated by ';'; -1: something else. */
static int read_numbers(const char *text, int *numbers, int most)
{
    int count = 0;
    for (; *text; count++) {
        if (count == most || *text < '0' || *text > '9')
            return -1;
        for (numbers[count] = 0; *text >= '0' && *text <= '9'; text++)
            if (numbers[count] < 100000)
                numbers[count] = 10 * numbers[count] + (*text - '0');
        text += *text == ';';
    }
    return count;
}

/* The end of "Esc [ text final". What is not known is swallowed. */
static bool read_csi(KeyReader *reader, char final, Key *key)
{
    const char *text = reader->text;
    int numbers[3];
    reader->state = KEYS_GROUND;
    if (final == 'y' && (strcmp(text, "?2026;1$") == 0 || strcmp(text, "?2026;2$") == 0))
        reader->answered = true;
    if (final == 'n' && (strcmp(text, "0") == 0 || strcmp(text, "3") == 0))
        reader->reports++;
    const bool mouse = *text == '<' && (final == 'M' || final == 'm');
    const int count = read_numbers(text + mouse, numbers, 3);
    if (final == '~' && count == 1 && (numbers[0] == 200 || numbers[0] == 201)) {
        reader->pasting = numbers[0] == 200;
        reader->paste_began = reader->began;
        reader->n_pasted = 0;
        return false;
    }
    if (reader->pasting) /* only text means something */
        return false;
    if (mouse)
        return count == 3 &&
               give_mouse(reader, key, numbers[0], final == 'm', numbers[1] - 1, numbers[2] - 1);
    if (count < 0 || count > 2 || (count == 2 && (numbers[1] < 1 || numbers[1] > MODIFIERS)))
        return false;
    const int modifiers = count == 2 ? numbers[1] - 1 : 0;
    if (final == 'Z')
        return give(reader, key, modifiers | SHIFT | (reader->alt ? ALT : 0), "Tab");
    if (final == '$' || final == '^' || final == '@') /* rxvt */
        return count == 1 && give_row(reader, key,
                                      final == '$'   ? SHIFT
                                      : final == '^' ? CONTROL
                                                     : SHIFT | CONTROL,
                                      0, numbers[0]);
    if (final == '~')
        return count > 0 && give_row(reader, key, modifiers, 0, numbers[0]);
    return (count == 0 || numbers[0] == 1) && give_row(reader, key, modifiers, final, 0);
}

/* The last byte is one of @ to ~, of rxvt's keys a $ behind a number. */
static bool take_csi(KeyReader *reader, int byte, Key *key)
{
    char *text = reader->text;
    const bool number = reader->length > 0 && strspn(text, "0123456789") == (size_t)reader->length;
    if (byte >= ' ' && byte < '@' && !(byte == '$' && number)) {
        text[reader->length++] = (char)byte;
        text[reader->length] = '\0';
        return reader->length + 1 == KEY_SEQUENCE_MAX && begin(reader, KEYS_GROUND);
    }
    if (reader->length == 0 && byte == '[') /* a function key of the Linux console: one byte more */
        return begin(reader, KEYS_CONSOLE);
    if (reader->length == 0 && byte == 'M') /* the old report of the mouse */
        return begin(reader, KEYS_MOUSE);
    /* A report of the terminal or of its mouse goes with no Alt: an Esc right before it was pressed by
     * itself. */
    const char final = (char)byte;
    const bool any = read_csi(reader, final, key);
    if (!reader->alt || reader->pasting)
        return any;
    if (any)
        return key->x < 0 || give_behind_escape(reader, key);
    return final != '~' && give(reader, key, 0, "Esc");
}

static bool take_ss3(KeyReader *reader, int byte, Key *key)
{
    if (byte >= '0' && byte <= '9' && ++reader->length < KEY_SEQUENCE_MAX)
        return false;
    const bool known = reader->length == 0 && !reader->pasting;
    begin(reader, KEYS_GROUND);
    const char *keypad = strchr(keypad_letters, byte);
    if (!known)
        return false;
    if (byte == 'M')
        return give(reader, key, reader->alt ? ALT : 0, "Enter");
    return keypad ? give_letter(reader, key, reader->alt ? ALT : 0, keypad_keys[keypad - keypad_letters])
                  : give_row(reader, key, 0, (char)byte, 0);
}

static bool take_ground(KeyReader *reader, int byte, Key *key)
{
    begin(reader, KEYS_GROUND);
    reader->alt = false;
    reader->began = reader->fed;
    if (byte == 0x1b)
        return begin(reader, KEYS_ESCAPE);
    if (byte == '\r' || byte == '\n')
        return give(reader, key, 0, "Enter");
    if (byte == '\t')
        return give(reader, key, 0, reader->pasting ? "Space" : "Tab");
    if (byte < ' ' || byte == 0x7f) {
        const char control[] = {'^', (char)(byte + '@'), '\0'};
        return !reader->pasting && give(reader, key, 0, byte == 0x08 || byte == 0x7f ? "Backspace" : control);
    }
    if (byte >= 0x80) {
        /* Bytes of UTF-8, in any locale; what is none is dropped. */
        reader->wanted = byte >= 0xc2 && byte < 0xe0   ? 1
                         : byte >= 0xe0 && byte < 0xf0 ? 2
                         : byte >= 0xf0 && byte < 0xf5 ? 3
                                                       : 0;
        begin(reader, reader->wanted > 0 ? KEYS_CHARACTER : KEYS_GROUND);
        reader->text[reader->length++] = (char)byte;
        return false;
    }
    return byte == ' ' ? give(reader, key, 0, "Space") : give_letter(reader, key, 0, byte);
}

static bool take_escape(KeyReader *reader, int byte, Key *key)
{
    const bool twice = reader->alt;
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
    case 0x1b: /* the one before was pressed; of this one, or of both (rxvt's Alt), is still to be seen */
        reader->alt = true;
        reader->state = KEYS_ESCAPE;
        return twice && !reader->pasting && give(reader, key, 0, "Esc");
    default:
        begin(reader, KEYS_GROUND);
        if (reader->pasting || byte >= 0x7f || (byte <= ' ' && byte != '\t'))
            return false;
        if (byte == '\t') /* the Linux console */
            give(reader, key, SHIFT, "Tab");
        else
            give_letter(reader, key, ALT, byte);
        return !twice || give_behind_escape(reader, key);
    }
}

static bool take_byte(KeyReader *reader, int byte, Key *key)
{
    const unsigned char *report = (const unsigned char *)reader->text;
    const bool in_sequence =
        reader->state == KEYS_CSI || reader->state == KEYS_SS3 || reader->state == KEYS_CONSOLE;
    if (byte == '\3') {
        /* ^C is the way out of whatever has not ended. What came with it of a paste or a string is dropped,
         * as a terminal's driver does, for no rest of a text may become commands. */
        if (reader->pasting || reader->state == KEYS_STRING)
            reader->next = reader->count;
        reader->pasting = false;
        return take_ground(reader, '\3', key);
    }
    if (reader->pasting && ++reader->n_pasted > PASTE_MAX)
        reader->pasting = false;
    /* a control byte or a letter of another script: the sequence was cut short, this begins again */
    if (in_sequence && (byte < ' ' || byte >= 0x7f))
        return take_ground(reader, byte, key);
    switch (reader->state) {
    case KEYS_ESCAPE:
        return take_escape(reader, byte, key);
    case KEYS_CSI:
        return take_csi(reader, byte, key);
    case KEYS_SS3:
        return take_ss3(reader, byte, key);
    case KEYS_CONSOLE:
        begin(reader, KEYS_GROUND);
        return byte >= 'A' && byte <= 'E' && !reader->pasting && give_row(reader, key, 0, 0, 11 + byte - 'A');
    case KEYS_MOUSE: /* three bytes, each with 32 added; places count from 1 */
        reader->text[reader->length++] = (char)byte;
        if (reader->length < 3)
            return false;
        reader->state = KEYS_GROUND;
        return !reader->pasting &&
               give_mouse(reader, key, report[0] - 32, false, report[1] - 33, report[2] - 33);
    case KEYS_STRING:
        if (byte == 0x1b)
            return begin(reader, KEYS_STRING_END);
        return (byte == 0x07 || ++reader->length > STRING_MAX) && begin(reader, KEYS_GROUND);
    case KEYS_STRING_END:
        return byte == '\\' ? begin(reader, KEYS_GROUND) : take_escape(reader, byte, key);
    case KEYS_CHARACTER:
        if ((byte & 0xc0) != 0x80)
            return take_ground(reader, byte, key);
        reader->text[reader->length++] = (char)byte;
        if (--reader->wanted > 0)
            return false;
        reader->text[reader->length] = '\0';
        reader->state = KEYS_GROUND;
        return give(reader, key, 0, reader->text);
    case KEYS_GROUND:
    default:
        return take_ground(reader, byte, key);
    }
}

void keys_feed(KeyReader *reader, const void *bytes, size_t count, double now)
{
    ASSERT(reader->next == reader->count && count <= KEYS_ROOM);
    memcpy(reader->bytes, bytes, count);
    reader->count = count;
    reader->next = 0;
    reader->fed = now;
}

bool keys_next(KeyReader *reader, Key *key)
{
    if (reader->waits) {
        *key = reader->waiting;
        reader->waits = false;
        return true;
    }
    while (reader->next < reader->count)
        if (take_byte(reader, reader->bytes[reader->next++], key))
            return true;
    return false;
}

/* --- silence --------------------------------------------------------------------------------------- */

static double paste_due(const KeyReader *reader)
{
    return reader->pasting ? fmin(reader->fed + PASTE_SILENCE, reader->paste_began + PASTE_SECONDS)
                           : INFINITY;
}

double keys_due(const KeyReader *reader)
{
    const double next_byte = fmax(BYTE_SECONDS, reader->escape_seconds);
    if (reader->state == KEYS_GROUND)
        return paste_due(reader);
    if (reader->state == KEYS_ESCAPE && !reader->pasting)
        return reader->fed + reader->escape_seconds;
    const double due = fmin(reader->fed + next_byte, reader->began + 5 * next_byte);
    return fmin(due, paste_due(reader));
}

bool keys_silence(KeyReader *reader, double now, Key *key)
{
    if (now < keys_due(reader))
        return false;
    const bool pressed = reader->state == KEYS_ESCAPE && !reader->pasting;
    reader->pasting = now < paste_due(reader) && reader->pasting;
    begin(reader, KEYS_GROUND);
    if (!pressed)
        return false;
    give(reader, key, 0, "Esc");
    return !reader->alt || give_behind_escape(reader, key);
}

/* --- names ----------------------------------------------------------------------------------------- */

const char *keys_pasted(const char *name)
{
    return name[0] == 'P' && name[1] == '-' && name[2] ? name + 2 : NULL;
}

const char *keys_of_text(const char *text, char name[KEY_NAME_MAX])
{
    int length = 1;
    while (((unsigned char)text[length] & 0xc0) == 0x80 && length < 4)
        length++;
    snprintf(name, KEY_NAME_MAX, "%.*s", *text == ' ' ? 5 : length, *text == ' ' ? "Space" : text);
    return text + length;
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
    for (int row = 0; row < N_ROWS; row++)
        if (strcmp(base, rows[row].name) == 0)
            return true;
    return base == name + 2 && name[0] == 'M' && base[0] > ' ' && !base[1];
}

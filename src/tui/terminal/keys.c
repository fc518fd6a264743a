#include "tui/terminal/keys.h"

#include <stdio.h>
#include <string.h>

enum { ESCAPE_MS = 25, SEQUENCE_MS = 500, PASTE_MS = 5000, PARAMETER_MOST = 9999, NUMBER_MOST = 24 };

static const char paste_end[] = "\033[201~";

void keys_reset(KeyDecoder *decoder)
{
    *decoder = (KeyDecoder){.state = KEY_GROUND};
}

static bool give(Key *key, const char *modifiers, const char *name)
{
    *key = (Key){.x = -1, .y = -1};
    snprintf(key->name, sizeof key->name, "%s%s", modifiers, name);
    return true;
}

static bool give_control(Key *key, unsigned char byte)
{
    switch (byte) {
    case '\t':
        return give(key, "", "Tab");
    case '\r':
    case '\n':
        return give(key, "", "Enter");
    case 0x08:
    case 0x7f:
        return give(key, "", "Backspace");
    default:
        return give(key, "^", (char[]){(char)(byte + '@'), '\0'});
    }
}

/* Keys whose CSI or SS3 sequence ends in a letter. */
static const char *letter_key(char letter)
{
    static const struct {
        char letter;
        const char *name;
    } letters[] = {
        {'A', "Up"},  {'B', "Down"}, {'C', "Right"}, {'D', "Left"}, {'H', "Home"},
        {'F', "End"}, {'P', "F1"},   {'Q', "F2"},    {'R', "F3"},   {'S', "F4"},
    };
    for (size_t i = 0; i < sizeof letters / sizeof *letters; i++)
        if (letters[i].letter == letter)
            return letters[i].name;
    return NULL;
}

/* Keys whose CSI sequence ends in ~ (rxvt: also in ^, $ or @). */
static const char *number_key(int number)
{
    static const char *const names[] = {
        [1] = "Home",     [2] = "Insert", [3] = "Delete", [4] = "End",  [5] = "PageUp",
        [6] = "PageDown", [7] = "Home",   [8] = "End",    [11] = "F1",  [12] = "F2",
        [13] = "F3",      [14] = "F4",    [15] = "F5",    [17] = "F6",  [18] = "F7",
        [19] = "F8",      [20] = "F9",    [21] = "F10",   [23] = "F11", [24] = "F12",
    };
    return number > 0 && (size_t)number < sizeof names / sizeof *names ? names[number] : NULL;
}

/* xterm's second parameter is 1 + Shift + 2 Alt + 4 Control. */
static const char *modifiers(int parameter, bool alt)
{
    static const char *const names[] = {"", "S-", "M-", "S-M-", "C-", "S-C-", "M-C-", "S-M-C-"};
    int bits = parameter >= 2 && parameter <= 8 ? parameter - 1 : 0;
    return names[bits | (alt ? 2 : 0)];
}

static bool begin(KeyDecoder *decoder, KeyState state)
{
    decoder->state = state;
    decoder->prefix = '\0';
    decoder->n_parameters = 0;
    decoder->matched = 0;
    decoder->wanted = 0;
    decoder->parameters[0] = -1;
    return false;
}

static bool begin_escape(KeyDecoder *decoder)
{
    begin(decoder, KEY_ESCAPE);
    decoder->escapes = 1;
    return false;
}

static bool mouse(const KeyDecoder *decoder, char final, Key *key)
{
    if (decoder->n_parameters != 3 || final != 'M')
        return false;
    /* bits 2 to 4 are Shift, Alt, Control; bit 5 is motion; bit 6 the wheel */
    int button = decoder->parameters[0] & ~0x1c;
    const char *name = button == 0 ? "Click" : button == 64 ? "WheelUp" : button == 65 ? "WheelDown" : NULL;
    if (!name)
        return false;
    give(key, "", name);
    key->x = decoder->parameters[1] - 1;
    key->y = decoder->parameters[2] - 1;
    return key->x >= 0 && key->y >= 0;
}

static bool finish_csi(KeyDecoder *decoder, char final, Key *key)
{
    decoder->state = KEY_GROUND;
    if (decoder->prefix == '<')
        return mouse(decoder, final, key);
    if (decoder->prefix)
        return false;
    int first = decoder->parameters[0], second = decoder->n_parameters > 1 ? decoder->parameters[1] : 0;
    bool alt = decoder->escapes > 1;
    if (final == 'M' && decoder->n_parameters == 0) {
        begin(decoder, KEY_MOUSE);
        decoder->wanted = 3;
        return false;
    }
    if (final == 'Z' && decoder->n_parameters == 0)
        return give(key, "", "S-Tab");
    if (final == '~' || final == '^' || final == '$' || final == '@') {
        if (final == '~' && first == 200)
            return begin(decoder, KEY_PASTE);
        const char *name = number_key(first);
        int rxvt = final == '$' ? 2 : final == '^' ? 5 : final == '@' ? 6 : second;
        return name && give(key, modifiers(rxvt, alt), name);
    }
    const char *name = letter_key(final);
    /* a cursor report ends in R too, but has a row before */
    if (!name || (first > 1 && decoder->n_parameters > 1))
        return false;
    return give(key, modifiers(second, alt), name);
}

/* The keypad in application mode, which PuTTY keeps even with NumLock. */
static bool give_keypad(Key *key, unsigned char byte)
{
    static const char keys[] = "*+,-./0123456789";
    if (byte == 'M')
        return give(key, "", "Enter");
    if (byte == 'X')
        return give(key, "", "=");
    return byte >= 'j' && byte <= 'y' && give(key, "", (char[]){keys[byte - 'j'], '\0'});
}

static bool feed_csi(KeyDecoder *decoder, unsigned char byte, Key *key)
{
    if (byte == '[' && decoder->n_parameters == 0 && !decoder->prefix)
        return begin(decoder, KEY_LINUX);
    if (byte >= '0' && byte <= '9') {
        if (decoder->n_parameters == 0)
            decoder->n_parameters = 1;
        if (decoder->n_parameters <= KEY_PARAMETERS_MAX) {
            int *value = &decoder->parameters[decoder->n_parameters - 1];
            *value = (*value < 0 ? 0 : *value) * 10 + (byte - '0');
            if (*value > PARAMETER_MOST)
                *value = PARAMETER_MOST;
        }
        return false;
    }
    if (byte == ';' || byte == ':') {
        if (decoder->n_parameters == 0)
            decoder->n_parameters = 1;
        if (decoder->n_parameters <= KEY_PARAMETERS_MAX)
            decoder->n_parameters++;
        if (decoder->n_parameters <= KEY_PARAMETERS_MAX)
            decoder->parameters[decoder->n_parameters - 1] = -1;
        return false;
    }
    if (byte >= '<' && byte <= '?') {
        decoder->prefix = (char)byte;
        return false;
    }
    /* rxvt ends Shift-Home in $, which the grammar takes for an intermediate byte */
    if (byte < 0x40 && !(byte == '$' && !decoder->prefix && decoder->n_parameters == 1))
        return false;
    return finish_csi(decoder, (char)byte, key);
}

static bool feed_escape(KeyDecoder *decoder, unsigned char byte, Key *key)
{
    switch (byte) {
    case 0x1b:
        if (decoder->escapes < 2)
            decoder->escapes++;
        return false;
    case '[':
        return begin(decoder, KEY_CSI);
    case 'O':
        return begin(decoder, KEY_SS3);
    case 'P':
    case ']':
    case 'X':
    case '^':
    case '_':
        return begin(decoder, KEY_STRING);
    default:
        break;
    }
    decoder->state = KEY_GROUND;
    if (decoder->escapes > 1)
        return give(key, "", "Esc");
    if (byte == '\t') /* Shift-Tab of the Linux console */
        return give(key, "", "S-Tab");
    return byte > ' ' && byte < 0x7f && give(key, "M-", (char[]){(char)byte, '\0'});
}

static bool is_continuation(unsigned char byte)
{
    return (byte & 0xc0) == 0x80;
}

/* False: no character of UTF-8 begins so. */
static bool begin_character(KeyDecoder *decoder, unsigned char byte)
{
    decoder->wanted = byte >= 0xc2 && byte < 0xe0   ? 1
                      : byte >= 0xe0 && byte < 0xf0 ? 2
                      : byte >= 0xf0 && byte < 0xf5 ? 3
                                                    : 0;
    decoder->text[0] = (char)byte;
    decoder->length = 1;
    return decoder->wanted > 0;
}

/* True: it is complete. */
static bool continue_character(KeyDecoder *decoder, unsigned char byte)
{
    decoder->text[decoder->length++] = (char)byte;
    decoder->text[decoder->length] = '\0';
    return --decoder->wanted == 0;
}

static bool feed_character(KeyDecoder *decoder, unsigned char byte, Key *key)
{
    if (!is_continuation(byte)) {
        decoder->state = KEY_GROUND;
        return keys_feed(decoder, byte, key);
    }
    if (!continue_character(decoder, byte))
        return false;
    decoder->state = KEY_GROUND;
    return give(key, "", decoder->text);
}

static bool feed_ground(KeyDecoder *decoder, unsigned char byte, Key *key)
{
    if (byte == 0x1b)
        return begin_escape(decoder);
    if (byte < ' ' || byte == 0x7f)
        return give_control(key, byte);
    if (byte == ' ')
        return give(key, "", "Space");
    if (byte < 0x80)
        return give(key, "", (char[]){(char)byte, '\0'});
    if (begin_character(decoder, byte))
        decoder->state = KEY_CHARACTER;
    return false;
}

/* Text, but no keys: neither a control byte nor a sequence inside means anything, only the end of the paste.
 */
static bool feed_paste(KeyDecoder *decoder, unsigned char byte, Key *key)
{
    enum { FOREIGN = sizeof paste_end };
    if (byte == 0x1b) {
        decoder->matched = 1;
        decoder->wanted = 0;
        return false;
    }
    if (decoder->matched > 0) {
        if (decoder->matched < FOREIGN && byte == (unsigned char)paste_end[decoder->matched])
            decoder->matched++;
        else
            decoder->matched = byte < '@' ? FOREIGN : 0;
        if (decoder->matched == sizeof paste_end - 1)
            decoder->state = KEY_GROUND;
        return false;
    }
    if (byte == '\r' || byte == '\n')
        return give(key, "P-", "Enter");
    if (byte == ' ' || byte == '\t')
        return give(key, "P-", "Space");
    if (byte > ' ' && byte < 0x7f)
        return give(key, "P-", (char[]){(char)byte, '\0'});
    if (decoder->wanted > 0 && is_continuation(byte))
        return continue_character(decoder, byte) && give(key, "P-", decoder->text);
    begin_character(decoder, byte);
    return false;
}

static bool feed_string(KeyDecoder *decoder, unsigned char byte)
{
    bool closes = byte == 0x07 || (decoder->matched == 1 && byte == '\\');
    decoder->matched = byte == 0x1b ? 1 : 0;
    if (closes)
        decoder->state = KEY_GROUND;
    return false;
}

bool keys_feed(KeyDecoder *decoder, unsigned char byte, Key *key)
{
    KeyState state = decoder->state;
    bool in_sequence = state == KEY_CSI || state == KEY_SS3 || state == KEY_LINUX;
    if (in_sequence && (byte < ' ' || byte >= 0x7f)) {
        /* a control byte or a letter of another script: the sequence was cut short, this begins anew */
        decoder->state = KEY_GROUND;
        return feed_ground(decoder, byte, key);
    }
    const char *name;
    switch (state) {
    case KEY_ESCAPE:
        return feed_escape(decoder, byte, key);
    case KEY_CSI:
        return feed_csi(decoder, byte, key);
    case KEY_LINUX:
        decoder->state = KEY_GROUND;
        return byte >= 'A' && byte <= 'E' && give(key, "", (char[]){'F', (char)(byte - 'A' + '1'), '\0'});
    case KEY_SS3:
        if (byte >= '0' && byte <= '9')
            return false;
        decoder->state = KEY_GROUND;
        name = letter_key((char)byte);
        return name ? give(key, modifiers(0, decoder->escapes > 1), name) : give_keypad(key, byte);
    case KEY_STRING:
        return feed_string(decoder, byte);
    case KEY_PASTE:
        return feed_paste(decoder, byte, key);
    case KEY_MOUSE:
        if (--decoder->wanted == 0)
            decoder->state = KEY_GROUND;
        return false;
    case KEY_CHARACTER:
        return feed_character(decoder, byte, key);
    case KEY_GROUND:
    default:
        return feed_ground(decoder, byte, key);
    }
}

int keys_timeout(const KeyDecoder *decoder)
{
    switch (decoder->state) {
    case KEY_GROUND:
        return -1;
    case KEY_ESCAPE:
        return ESCAPE_MS;
    case KEY_PASTE: /* the rest of it must not become keys where the line is slow */
        return PASTE_MS;
    default:
        return SEQUENCE_MS;
    }
}

bool keys_expire(KeyDecoder *decoder, Key *key)
{
    bool escape = decoder->state == KEY_ESCAPE;
    if (escape && --decoder->escapes > 0)
        return give(key, "", "Esc");
    decoder->state = KEY_GROUND;
    return escape && give(key, "", "Esc");
}

static bool is_named(const char *name)
{
    static const char *const names[] = {"Space", "Enter", "Tab", "Esc", "Backspace"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(name, names[i]) == 0)
            return true;
    for (char letter = 'A'; letter <= 'Z'; letter++)
        if (letter_key(letter) && strcmp(name, letter_key(letter)) == 0)
            return true;
    for (int number = 1; number <= NUMBER_MOST; number++)
        if (number_key(number) && strcmp(name, number_key(number)) == 0)
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

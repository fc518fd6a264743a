#include "view/draw/canvas.h"

#include <stdlib.h>
#include <string.h>

enum { REPLACEMENT = '?', ELLIPSIS = 0x2026 };

uint32_t utf8_next(const char **text)
{
    const unsigned char *s = (const unsigned char *)*text;
    if (*s == '\0')
        return 0;
    const int length = *s < 0x80 ? 1 : *s < 0xc2 ? 0 : *s < 0xe0 ? 2 : *s < 0xf0 ? 3 : *s < 0xf5 ? 4 : 0;
    static const uint32_t first_mask[] = {0, 0x7f, 0x1f, 0x0f, 0x07};
    uint32_t glyph = *s & first_mask[length];
    for (int i = 1; i < length; i++) {
        if ((s[i] & 0xc0) != 0x80) {
            *text += i;
            return REPLACEMENT;
        }
        glyph = glyph << 6 | (s[i] & 0x3f);
    }
    *text += length ? length : 1;
    return length ? glyph : REPLACEMENT;
}

size_t utf8_put(char out[4], uint32_t glyph)
{
    if (glyph < 0x80) {
        out[0] = (char)glyph;
        return 1;
    }
    if (glyph < 0x800) {
        out[0] = (char)(0xc0 | glyph >> 6);
        out[1] = (char)(0x80 | (glyph & 0x3f));
        return 2;
    }
    if (glyph < 0x10000) {
        out[0] = (char)(0xe0 | glyph >> 12);
        out[1] = (char)(0x80 | (glyph >> 6 & 0x3f));
        out[2] = (char)(0x80 | (glyph & 0x3f));
        return 3;
    }
    out[0] = (char)(0xf0 | glyph >> 18);
    out[1] = (char)(0x80 | (glyph >> 12 & 0x3f));
    out[2] = (char)(0x80 | (glyph >> 6 & 0x3f));
    out[3] = (char)(0x80 | (glyph & 0x3f));
    return 4;
}

int text_columns(const char *utf8)
{
    int columns = 0;
    while (utf8_next(&utf8))
        columns++;
    return columns;
}

bool canvas_open(Canvas *canvas, int width, int height, Status *status)
{
    width = width > 0 ? width : 1;
    height = height > 0 ? height : 1;
    Cell *cells = realloc(canvas->cells, (size_t)width * (size_t)height * sizeof *cells);
    if (!cells)
        return status_fail(status, STATUS_FAILED, "not enough memory for a screen of %dx%d", width, height);
    canvas->cells = cells;
    canvas->width = width;
    canvas->height = height;
    canvas_clear(canvas);
    return true;
}

void canvas_close(Canvas *canvas)
{
    free(canvas->cells);
    *canvas = (Canvas){.cursor_x = -1, .cursor_y = -1};
}

void canvas_clear(Canvas *canvas)
{
    const size_t count = (size_t)canvas->width * (size_t)canvas->height;
    for (size_t i = 0; i < count; i++)
        canvas->cells[i] = (Cell){.glyph = ' ', .style = STYLE_NORMAL};
    canvas->cursor_x = canvas->cursor_y = -1;
}

void canvas_put(Canvas *canvas, int x, int y, uint32_t glyph, Style style)
{
    if (x < 0 || y < 0 || x >= canvas->width || y >= canvas->height)
        return;
    canvas->cells[(size_t)y * (size_t)canvas->width + (size_t)x] =
        (Cell){.glyph = glyph ? glyph : ' ', .style = (uint16_t)style};
}

/* A terminal must never see one, wherever the text comes from. */
static bool is_control(uint32_t glyph)
{
    return glyph < ' ' || (glyph >= 0x7f && glyph < 0xa0);
}

/* Half a number is worse than none: the ellipsis takes the place of all of it. */
static void drop_cut_number(Canvas *canvas, int x, int y, int ellipsis, Style style)
{
    if (y < 0 || y >= canvas->height)
        return;
    const Cell *row = canvas->cells + (size_t)y * (size_t)canvas->width;
    int at = ellipsis;
    while (at > x && at <= canvas->width && row[at - 1].glyph < 0x80 &&
           strchr("0123456789.", (int)row[at - 1].glyph))
        at--;
    for (int i = at; i <= ellipsis && at < ellipsis; i++)
        canvas_put(canvas, i, y, i == at ? ELLIPSIS : ' ', style);
}

int canvas_text(Canvas *canvas, int x, int y, int width, const char *text, Style style)
{
    int used = 0;
    if (canvas->large && style == STYLE_FAINT)
        style = STYLE_NORMAL;
    while (used < width) {
        uint32_t glyph = utf8_next(&text);
        if (!glyph)
            break;
        const bool cut = used == width - 1 && *text != '\0';
        canvas_put(canvas, x + used++, y, cut ? ELLIPSIS : is_control(glyph) ? ' ' : glyph, style);
        if (cut)
            drop_cut_number(canvas, x, y, x + used - 1, style);
    }
    return used;
}

/* --- text characters for terminals without UTF-8 --- */

/* What stands for a character where only ASCII can be shown; one column for one column, so that nothing
 * moves. Texts that matter (equations) have a better ASCII form of their own. */
static const struct {
    uint32_t first, last;
    char ascii;
} foldings[] = {
    {0x00b0, 0x00b0, 'o'}, {0x00b1, 0x00b1, '~'}, {0x00b2, 0x00b2, '2'}, {0x00b3, 0x00b3, '3'},
    {0x00b5, 0x00b5, 'u'}, {0x00b7, 0x00b7, '.'}, {0x00b9, 0x00b9, '1'}, {0x00bd, 0x00bd, '2'},
    {0x00d7, 0x00d7, 'x'}, {0x0394, 0x0394, 'D'}, {0x03a3, 0x03a3, 'S'}, {0x03a9, 0x03a9, 'W'},
    {0x03b1, 0x03b1, 'a'}, {0x03b2, 0x03b2, 'b'}, {0x03b3, 0x03b3, 'g'}, {0x03b4, 0x03b4, 'd'},
    {0x03b5, 0x03b5, 'e'}, {0x03b7, 0x03b7, 'n'}, {0x03b8, 0x03b8, 'q'}, {0x03ba, 0x03ba, 'k'},
    {0x03bb, 0x03bb, 'l'}, {0x03bc, 0x03bc, 'u'}, {0x03bd, 0x03bd, 'v'}, {0x03be, 0x03be, 'x'},
    {0x03c0, 0x03c0, 'p'}, {0x03c1, 0x03c1, 'r'}, {0x03c3, 0x03c3, 's'}, {0x03c4, 0x03c4, 't'},
    {0x03c6, 0x03c6, 'f'}, {0x03c9, 0x03c9, 'w'}, {0x2013, 0x2014, '-'}, {0x2018, 0x2019, '\''},
    {0x201c, 0x201d, '"'}, {0x2022, 0x2022, '*'}, {0x2026, 0x2026, '~'}, {0x2032, 0x2032, '\''},
    {0x2039, 0x2039, '<'}, {0x203a, 0x203a, '>'}, {0x2190, 0x2190, '<'}, {0x2191, 0x2191, '^'},
    {0x2192, 0x2192, '>'}, {0x2193, 0x2193, 'v'}, {0x2202, 0x2202, 'd'}, {0x2212, 0x2212, '-'},
    {0x221a, 0x221a, 'V'}, {0x2248, 0x2248, '='}, {0x2264, 0x2264, '<'}, {0x2265, 0x2265, '>'},
    {0x2500, 0x2501, '-'}, {0x2502, 0x2503, '|'}, {0x2504, 0x2505, '-'}, {0x250c, 0x254b, '+'},
    {0x254c, 0x254d, '-'}, {0x2580, 0x2580, '"'}, {0x2584, 0x2584, '_'}, {0x2588, 0x2588, '#'},
    {0x258c, 0x258c, '|'}, {0x2590, 0x2590, '|'}, {0x2591, 0x2591, '.'}, {0x2592, 0x2592, '%'},
    {0x2593, 0x2593, '#'}, {0x25a0, 0x25a0, '#'}, {0x25b2, 0x25b2, '^'}, {0x25ba, 0x25ba, '>'},
    {0x25bc, 0x25bc, 'v'}, {0x25c4, 0x25c4, '<'}, {0x25cb, 0x25cb, 'o'}, {0x25cf, 0x25cf, 'O'},
    {0x2800, 0x28ff, ':'},
};

static uint32_t glyph_ascii(uint32_t glyph)
{
    if (glyph < 0x80)
        return glyph;
    for (size_t i = 0; i < sizeof foldings / sizeof *foldings; i++)
        if (glyph >= foldings[i].first && glyph <= foldings[i].last)
            return (uint32_t)foldings[i].ascii;
    return REPLACEMENT;
}

void canvas_to_ascii(Canvas *canvas)
{
    const size_t count = (size_t)canvas->width * (size_t)canvas->height;
    for (size_t i = 0; i < count; i++)
        canvas->cells[i].glyph = glyph_ascii(canvas->cells[i].glyph);
}

/* --- dumps --- */

char *canvas_dump(const Canvas *canvas)
{
    char *out = malloc((size_t)canvas->height * ((size_t)canvas->width * 4 + 1) + 1);
    if (!out)
        return NULL;
    size_t used = 0;
    for (int y = 0; y < canvas->height; y++) {
        const Cell *row = canvas->cells + (size_t)y * (size_t)canvas->width;
        int end = canvas->width;
        while (end > 0 && (row[end - 1].glyph == ' ' || row[end - 1].glyph == 0))
            end--;
        for (int x = 0; x < end; x++)
            used += utf8_put(out + used, row[x].glyph ? row[x].glyph : ' ');
        out[used++] = '\n';
    }
    out[used] = '\0';
    return out;
}

char *canvas_dump_styles(const Canvas *canvas)
{
    static const char letters[STYLE_COUNT] = {
        [STYLE_NORMAL] = '.',   [STYLE_TITLE] = 'T',     [STYLE_FRAME] = '-',    [STYLE_FOCUS] = 'F',
        [STYLE_HEADING] = 'H',  [STYLE_FAINT] = 'f',     [STYLE_SELECTED] = 'S', [STYLE_EDIT] = 'E',
        [STYLE_CHANGED] = 'C',  [STYLE_WARNING] = 'W',   [STYLE_ERROR] = '!',    [STYLE_KEY] = 'K',
        [STYLE_MEASURED] = 'm', [STYLE_PREDICTED] = 'p', [STYLE_EXACT] = 'e',    [STYLE_SECOND] = '2',
        [STYLE_THIRD] = '3',
    };
    char *out = malloc((size_t)canvas->height * ((size_t)canvas->width + 1) + 1);
    if (!out)
        return NULL;
    size_t used = 0;
    for (int y = 0; y < canvas->height; y++) {
        const Cell *row = canvas->cells + (size_t)y * (size_t)canvas->width;
        for (int x = 0; x < canvas->width; x++) {
            int ramp = row[x].style - STYLE_RAMP_0;
            out[used++] = ramp >= 0 ? "0123456789ABCDEF"[ramp % RAMP_STEPS] : letters[row[x].style];
        }
        out[used++] = '\n';
    }
    out[used] = '\0';
    return out;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Legends and the heading line of a plot, which gives way by a fixed order where room is short. */
#include "picture/cells/cells.h"

#include "base/assertion.h"
#include <stdio.h>
#include <string.h>

enum { GAP_MOST = 2 }; /* behind an entry */

static int draw_entries(Area area, int x, int y, int gap, const Legend *legend, int n_legend)
{
    for (int i = 0; i < n_legend; i++) {
        const int columns = 3 + glyphs_columns(legend[i].name);
        if (x + columns + 1 > area.rect.width)
            return i;
        area_blank(area, x - 1, x + columns + 2, y, STYLE_FRAME);
        const char *key =
            legend[i].key ? legend[i].key : plot_key(legend[i].line, legend[i].letter, area.glyphs);
        area_text(area, x, y, key, legend[i].style);
        area_text(area, x + 3, y, legend[i].name, STYLE_NORMAL);
        x += columns + gap;
    }
    return n_legend;
}

int legend_draw(Area area, int x, int y, const Legend *legend, int n_legend)
{
    return draw_entries(area, x, y, GAP_MOST, legend, n_legend);
}

const char *legend_short_name(const char *name)
{
    static const char *const words[][2] = {
        {"predicted", "pred"},
        {"predicted (right code)", "right"},
        {"measured", "meas"},
        {"displacement", "displ."},
        {"measured, middle row", "meas"},
        {"error of w, % (square-root scale)", "% error, sqrt scale"},
        {"% error, sqrt scale", "error of w, %"},
        {"force, N/m^5", "f, N/m^5"},
        {"30° from the notch (paper)", "30° (paper)"},
    };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(name, words[i][0]) == 0)
            return words[i][1];
    return strncmp(name, "filtered ", 9) == 0 ? "filt" : name;
}

enum { NAME_KINDS = 4 };

/* The value alone of "courant number 0.1": its last word or, with its unit, from its number on. */
static const char *value_of(const char *name)
{
    const char *value = name;
    for (const char *word = name; (word = strchr(word, ' ')) != NULL;) {
        const bool has_number = strchr("-.0123456789", *value) != NULL;
        value = has_number ? value : word + 1;
        word++;
    }
    return value;
}

/* How an entry is named where room is short, by what gives way first; NULL: it is not of that kind. */
static const char *shorter_name(const Legend *entry, int kind)
{
    const bool ghost = entry->key && entry->key[0] && entry->key[1] == ':';
    const bool run = (entry->name[0] == 'A' || entry->name[0] == 'B') && entry->name[1] == ' ';
    switch (kind) {
    case 0:
        return !run ? NULL : entry->name[0] == 'A' ? "A" : "B";
    case 1:
        return legend_short_name(entry->name);
    case 2:
        return ghost ? value_of(entry->name) : NULL;
    default:
        return ghost ? "" : NULL; /* its letter has to do */
    }
}

static int legend_columns(const Legend *legend, int n_legend, int gap)
{
    int columns = 1 - gap; /* after the last one there is no gap */
    for (int i = 0; i < n_legend; i++)
        columns += 3 + glyphs_columns(legend[i].name) + gap;
    return columns;
}

/* One kind of names after the other gives way until the whole legend has room: so many kinds. */
static void shorten_legend(int room, int kinds, int gap, Legend *legend, int n_legend)
{
    for (int kind = 0; kind < kinds; kind++)
        for (int i = 0, columns = legend_columns(legend, n_legend, gap); i < n_legend && columns > room;
             i++) {
            const char *name = shorter_name(&legend[i], kind);
            columns -= name ? glyphs_columns(legend[i].name) - glyphs_columns(name) : 0;
            legend[i].name = name ? name : legend[i].name;
        }
}

/* As many as there is room for; where there are none `legend` may be NULL. Returns how many. */
static int copy_legend(Legend shown[LEGENDS_MAX], const Legend *legend, int n_legend)
{
    n_legend = n_legend < LEGENDS_MAX ? n_legend : LEGENDS_MAX;
    for (int i = 0; i < n_legend; i++)
        shown[i] = legend[i];
    return n_legend;
}

int legend_draw_short(Area area, int x, int y, const Legend *legend, int n_legend)
{
    ASSERT_INT(n_legend, >=, 1);
    Legend shown[LEGENDS_MAX];
    const int room = area.rect.width - x;
    for (int kinds = NAME_KINDS - 1; kinds <= NAME_KINDS; kinds++) {
        n_legend = copy_legend(shown, legend, n_legend);
        shorten_legend(room, kinds, GAP_MOST, shown, n_legend);
        if (legend_columns(shown, 1, GAP_MOST) <= room)
            break;
    }
    return legend_draw(area, x, y, shown, n_legend);
}

int heading_draw(Area area, Style heading, const char *name, const char *scale, const Legend *legend,
                 int n_legend, bool goes_on)
{
    enum { CLOSE = 2, LETTERS_ONLY }; /* what gives way, one after the other */
    char text[160];
    Legend shown[LEGENDS_MAX];
    int x = 0, gap = GAP_MOST;
    for (int pass = 0; pass <= (goes_on ? CLOSE : LETTERS_ONLY); pass++) {
        const char *title = name;
        for (int i = 0; i < pass && i < CLOSE; i++)
            title = legend_short_name(title);
        snprintf(text, sizeof text, "%s%s%s", title, !scale[0] ? "" : scale[0] == 'x' ? " " : ", ", scale);
        x = 4 + glyphs_columns(text) + 1;
        gap = pass >= CLOSE ? 1 : GAP_MOST;
        const int room = area.rect.width - x;
        n_legend = copy_legend(shown, legend, n_legend);
        shorten_legend(room, pass >= LETTERS_ONLY ? NAME_KINDS : NAME_KINDS - 2, gap, shown, n_legend);
        if (legend_columns(shown, n_legend, gap) <= room)
            break;
    }
    area_rule(area, text, heading);
    return draw_entries(area, x, 0, gap, shown, n_legend);
}

bool heading_hint(Area area, int begin, int end, const char *hint)
{
    char text[96];
    glyphs_plain(area.glyphs, hint, text, sizeof text);
    if (begin + glyphs_columns(text) >= end)
        return false;
    area_text_right(area, end, 0, text, STYLE_FAINT);
    return true;
}

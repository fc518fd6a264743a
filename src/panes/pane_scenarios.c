/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of scenarios above the line that asks for one: their names, with a mark at the one that is open,
 * and their titles beside them or, where there is no room, that of the chosen one below. */
#include "panes/panes.h"
#include "panes/key_line.h"

static int widest(const ScenarioList *list, bool of_titles)
{
    int width = 0;
    for (int i = 0; i < list->n_shown; i++) {
        const int entry = list->shown[i];
        const int columns =
            glyphs_columns(of_titles ? list->entries[entry].title : list->entries[entry].name);
        width = columns > width ? columns : width;
    }
    return width;
}

static void fill(Area area, int y, Style style)
{
    for (int x = 0; x < area.rect.width; x++)
        area_put(area, x, y, ' ', style);
}

void pane_scenarios(const ScenarioList *list, Area area, int bottom)
{
    const int names = widest(list, false), width = area.rect.width;
    const bool beside = 1 + names + 2 + widest(list, true) + 1 <= width;
    const char *chosen = list->chosen >= 0 ? list->entries[list->shown[list->chosen]].title : "";
    const int below = !beside && *chosen ? area_paragraph_lines(width - 2, chosen) : 0;
    const int room = bottom - 1 - below; /* the title line stays */
    const int rows = list->n_shown < room ? list->n_shown : room;
    if (rows < 1)
        return;
    int first = (list->chosen >= 0 ? list->chosen : list->open) - rows / 2;
    first = first > list->n_shown - rows ? list->n_shown - rows : first;
    first = first > 0 ? first : 0;
    for (int row = 0; row < rows; row++) {
        const int i = first + row, y = bottom - below - rows + row, entry = list->shown[i];
        const Style style = i == list->chosen ? STYLE_SELECTED : STYLE_TITLE;
        fill(area, y, style);
        area_text(area, 0, y, i == list->open ? ">" : "", style);
        area_text(area, 1, y, list->entries[entry].name, style);
        if (beside)
            area_text(area, 1 + names + 2, y, list->entries[entry].title, style);
        const bool more_above = row == 0 && first > 0, more_below = row == rows - 1 && i < list->n_shown - 1;
        if (more_above || more_below)
            area_text_right(area, width - 1, y, more_above ? "↑" : "↓", style);
    }
    for (int y = bottom - below; y < bottom; y++)
        fill(area, y, STYLE_TITLE);
    area_paragraph(area, 1, bottom - below, width - 2, below, chosen, STYLE_TITLE);
}

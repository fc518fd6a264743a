/* The readout of a duel in the box at the bottom: label, A, B; in as many columns beside each other as the
 * table needs and the box has room for. */
#include "view/panes.h"

#include "lab/comparison.h"

#include <string.h>

enum { LABEL_LEAST = 12, VALUE_LEAST = 7, GROUPS_MAX = 3 };

/* What may be told: no theory where a class is to guess. */
static int rows_shown(const Screen *screen, Comparison rows[COMPARISONS_MAX])
{
    const int all = duel_compare(screen->duel, rows);
    int count = 0;
    for (int i = 0; i < all; i++)
        if (rows[i].kind == COLUMN_MEASURED || (rows[i].kind == COLUMN_EXACT && shows_exact(screen)) ||
            (rows[i].kind == COLUMN_PREDICTED && shows_predicted(screen)))
            rows[count++] = rows[i];
    return count;
}

/* How wide the table of these rows is: the widest label and the widest value of each run. */
static void measure(const Comparison *rows, int count, int *label, int values[2])
{
    *label = LABEL_LEAST;
    values[0] = values[1] = VALUE_LEAST;
    for (int i = 0; i < count; i++) {
        *label = text_columns(rows[i].label) > *label ? text_columns(rows[i].label) : *label;
        for (int run = 0; run < 2; run++)
            if (text_columns(rows[i].values[run]) > values[run])
                values[run] = text_columns(rows[i].values[run]);
    }
}

static void draw_group(Area area, const Comparison *rows, int count)
{
    int label, values[2];
    measure(rows, count, &label, values);
    const int ends[2] = {label + 1 + values[0], label + 1 + values[0] + 1 + values[1]};
    const Style styles[2] = {STYLE_MEASURED, STYLE_SECOND};
    for (int run = 0; run < 2; run++) {
        const char letter[] = {' ', "AB"[run], ' ', '\0'};
        area_text_right(area, ends[run] + 2, 0, letter, styles[run]);
    }
    for (int y = 0; y < count; y++) {
        area_text(area, 1, 1 + y, rows[y].label, STYLE_NORMAL);
        for (int run = 0; run < 2; run++)
            area_text_right(area, ends[run] + 1, 1 + y, rows[y].values[run], styles[run]);
    }
}

void pane_duel(const Screen *screen, Area area)
{
    Comparison rows[COMPARISONS_MAX];
    int count = rows_shown(screen, rows), label, values[2];
    const int height = area.rect.height - 1;
    measure(rows, count, &label, values);
    const int width = 1 + label + 1 + values[0] + 1 + values[1] + 1;
    int groups = area.rect.width / width;
    groups = groups > GROUPS_MAX ? GROUPS_MAX : groups < 1 ? 1 : groups;
    area_rule(area, 0, "Duel", is_focused(screen, PANE_BOX) ? STYLE_FOCUS : STYLE_HEADING);
    if (height < 1)
        return;
    if (count > groups * height)
        count = groups * height;
    const int used = (count + height - 1) / height;
    for (int i = 0; i < used; i++) {
        const int first = i * height, here = count - first < height ? count - first : height;
        draw_group(area_part(area, i * (area.rect.width / used), 0, width, area.rect.height), rows + first,
                   here);
    }
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Round ticks and the places of values: linear, by square roots, by powers of ten; and how axes are drawn. */
#include "picture/axes.h"

#include "picture/cells/cells.h"

#include "base/assertion.h"
#include "base/math/functions.h"
#include "base/text.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Powers of ten by a table: pow(10, -3) is not 1e-3 everywhere, and pictures are compared exactly. */
double axis_power_of_ten(int exponent)
{
    double power = 1;
    for (int i = 0; i < (exponent < 0 ? -exponent : exponent); i++)
        power *= 10;
    return exponent < 0 ? 1 / power : power;
}

static int decade_of(double value)
{
    int decade = (int)floor(math_log10(value));
    /* log10 of 1000 may be a hair below 3 */
    while (axis_power_of_ten(decade + 1) <= value * (1 + 1e-12))
        decade++;
    while (axis_power_of_ten(decade) > value * (1 + 1e-12))
        decade--;
    return decade;
}

static double round_on(double value, const double *ladder, int rungs)
{
    if (!(value > 1e-290) || !(value < 1e290))
        return 1;
    double power = axis_power_of_ten(decade_of(value));
    for (int i = 0; i < rungs; i++)
        if (ladder[i] * power >= value * (1 - 1e-12))
            return ladder[i] * power;
    return 10 * power;
}

double axis_round_up(double value)
{
    static const double ladder[] = {1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8};
    return round_on(value, ladder, sizeof ladder / sizeof *ladder);
}

double axis_step_up(double value)
{
    static const double ladder[] = {1, 2, 5};
    return round_on(value, ladder, 3);
}

double axis_step_down(double value)
{
    double up = axis_step_up(value);
    if (up <= value * (1 + 1e-12))
        return up;
    double power = axis_power_of_ten(decade_of(up));
    double digit = up / power;
    return digit > 4 ? 2 * power : digit > 1.5 ? power : power / 2;
}

static int ticks_within(double low, double high, double step)
{
    double slack = 1e-9 * (high - low);
    return (int)(floor((high + slack) / step) - ceil((low - slack) / step)) + 1;
}

static Axis linear(double low, double high, int most)
{
    Axis axis = {.low = low, .high = high};
    axis.step = axis_step_down((high - low) / (most + 1));
    while (ticks_within(low, high, axis.step) > most)
        axis.step = axis_step_up(axis.step * 1.5);

    double largest = fmax(fabs(low), fabs(high));
    int decade = decade_of(largest), step_decade = decade_of(axis.step);
    if (decade >= 4 || decade < -1)
        axis.exponent = decade >= 0 ? decade / 3 * 3 : -((2 - decade) / 3 * 3);
    axis.decimals = axis.exponent - step_decade;
    axis.decimals = axis.decimals < 0 ? 0 : axis.decimals > 9 ? 9 : axis.decimals;
    return axis;
}

Axis axis_with_ticks(Axis axis, int most)
{
    ASSERT_INT(most, >=, 0);
    Axis made = axis;
    most = most < 2 ? 2 : most > TICKS_MAX ? TICKS_MAX : most;
    if (axis.scale == SCALE_LINEAR) {
        made = linear(axis.low, axis.high, most);
        /* steps of 2 are too many and those of 5 go beyond 4: 0 must not be the only tick */
        if (axis.symmetric && made.step > axis.high * (1 + 1e-9))
            made = linear(-made.step, made.step, most);
        if (axis.whole && made.step < 1) {
            made.step = 1;
            made.decimals = 0;
        }
    } else if (axis.scale == SCALE_LOG) {
        const int decades = decade_of(axis.high) - decade_of(axis.low), step = (decades + most - 1) / most;
        made.step = step < 1 ? 1 : step;
    } else
        made.step = 1.0 / most;
    made.symmetric = axis.symmetric;
    made.whole = axis.whole;
    made.moves = axis.moves;
    return made;
}

Axis axis_make(double low, double high)
{
    if (!(low < high) || !isfinite(low) || !isfinite(high) || !isfinite(high - low))
        low = 0, high = 1;
    return linear(low, high, TICKS_USUAL);
}

Axis axis_symmetric(double amplitude)
{
    double end = amplitude > 0 ? axis_round_up(amplitude * 1.02) : 1;
    Axis axis = axis_make(-end, end);
    axis.symmetric = true;
    return axis;
}

Axis axis_around(double low, double high)
{
    if (!isfinite(low) || !isfinite(high) || low > high)
        low = 0, high = 1;
    double reach = fmax(fabs(low), fabs(high));
    if (reach == 0)
        return axis_make(0, 1);
    if (low >= 0 && low < 0.6 * high)
        return axis_make(0, axis_round_up(high));
    if (high <= 0 && high > 0.6 * low)
        return axis_make(-axis_round_up(-low), 0);
    if (high - low <= 1e-9 * reach) {
        double room = reach > 0 ? 0.05 * reach : 1;
        return axis_make(low - room, high + room);
    }
    double step = axis_step_up((high - low) / 4);
    return axis_make(floor(low / step) * step, ceil(high / step) * step);
}

Axis axis_count(double high)
{
    Axis axis = axis_make(0, high > 1 ? ceil(axis_round_up(high)) : 1);
    axis.whole = true;
    return axis_with_ticks(axis, TICKS_USUAL);
}

Axis axis_make_root(double low, double high)
{
    if (!(low < high) || !isfinite(low) || !isfinite(high))
        low = -1, high = 0;
    return (Axis){.scale = SCALE_ROOT, .low = low, .high = high, .step = 1.0 / TICKS_USUAL};
}

Axis axis_make_log(double low, double high)
{
    ASSERT_REAL(low, >, 0);
    ASSERT_REAL(low, <=, high);
    if (!(low > 0) || !(low < high) || !isfinite(high))
        low = 0.1, high = 1;
    const int first = decade_of(low), last = decade_of(high) + (decade_of(high) < math_log10(high) - 1e-9);
    const int decades = last > first ? last - first : 1;
    return axis_with_ticks((Axis){.scale = SCALE_LOG,
                                  .low = axis_power_of_ten(first),
                                  .high = axis_power_of_ten(first + decades)},
                           TICKS_USUAL);
}

double axis_place(const Axis *axis, double value)
{
    if (axis->scale == SCALE_ROOT)
        return value < 0 ? -sqrt(-value) : sqrt(value);
    if (axis->scale == SCALE_LOG && !isnan(value))
        return value > 0 ? math_log10(value) : -400; /* below all that a double can be */
    return value;
}

static double axis_length(const Axis *axis)
{
    return axis_place(axis, axis->high) - axis_place(axis, axis->low);
}

double axis_share(const Axis *axis, double value)
{
    return (axis_place(axis, value) - axis_place(axis, axis->low)) / axis_length(axis);
}

double axis_enlargement(double reach, double room)
{
    if (!(reach > 0))
        return 1;
    /* a coarse step: a scale that changes is worse than one that is a little small */
    double factor = room / axis_step_up(reach);
    return factor < 1 ? 1 : axis_step_down(factor);
}

int axis_ticks(const Axis *axis, double ticks[TICKS_MAX])
{
    if (axis->scale == SCALE_ROOT) {
        /* From 0 outwards, each far enough from the one before. */
        static const double ladder[] = {1, 5, 20, 50};
        const double least = axis->step * axis_length(axis) * (1 - 1e-9);
        double below[TICKS_MAX];
        int n_below = 0, count = 0;
        for (int sign = -1; sign <= 1; sign += 2) {
            const double end = sign < 0 ? -axis->low : axis->high;
            double before = 0;
            if (end <= 0)
                continue;
            for (int decade = decade_of(end) / 2 * 2 - 6; decade <= decade_of(end) + 2; decade += 2)
                for (int i = 0; i < 4; i++) {
                    const double value = ladder[i] * axis_power_of_ten(decade), place = sqrt(value);
                    if (value > end * (1 + 1e-9) || place - before < least)
                        continue;
                    before = place;
                    if (sign < 0 && n_below < TICKS_MAX / 2 - 1)
                        below[n_below++] = -value;
                    else if (sign > 0 && count < TICKS_MAX / 2)
                        ticks[n_below + 1 + count++] = value;
                }
        }
        for (int i = 0; i < n_below; i++)
            ticks[i] = below[n_below - 1 - i];
        ticks[n_below] = 0;
        return n_below + 1 + count;
    }
    if (axis->scale == SCALE_LOG) {
        const int first = decade_of(axis->low), last = decade_of(axis->high), step = (int)axis->step;
        int count = 0;
        for (int decade = first; decade <= last && count < TICKS_MAX; decade++)
            if ((last - decade) % step == 0)
                ticks[count++] = axis_power_of_ten(decade);
        return count;
    }
    double slack = 1e-9 * (axis->high - axis->low);
    double first = ceil((axis->low - slack) / axis->step);
    int count = ticks_within(axis->low, axis->high, axis->step);
    count = count < TICKS_MAX ? count : TICKS_MAX;
    for (int i = 0; i < count; i++)
        ticks[i] = (first + i) * axis->step;
    return count;
}

void axis_label(const Axis *axis, double tick, char out[TICK_TEXT_MAX])
{
    const int decade = axis->scale == SCALE_LOG ? decade_of(tick) : 0;
    const double scaled = tick / axis_power_of_ten(axis->exponent);
    const bool nothing = fabs(scaled) < 0.5 * axis_power_of_ten(-axis->decimals); /* never "-0" */
    if (axis->scale == SCALE_LINEAR)
        snprintf(out, TICK_TEXT_MAX, "%.*f", axis->decimals, nothing ? 0 : scaled);
    else if (decade < -2 || decade > 3)
        snprintf(out, TICK_TEXT_MAX, "1e%d", decade);
    else
        snprintf(out, TICK_TEXT_MAX, "%g", tick);
}

void axis_scale_text(const Axis *axis, const char *unit, char out[TICK_TEXT_MAX])
{
    static const struct {
        int exponent;
        const char *prefix;
    } prefixes[] = {{-9, "n"}, {-6, "µ"}, {-3, "m"}, {0, ""}, {3, "k"}, {6, "M"}, {9, "G"}};
    static const char *const units[] = {"m", "s", "Pa", "J", "m/s", "Hz", "N", "J/m³", NULL};
    const bool si = text_place_in(unit, units) >= 0;
    out[0] = '\0';
    for (size_t i = 0; si && i < sizeof prefixes / sizeof *prefixes; i++)
        if (axis->exponent == prefixes[i].exponent) {
            snprintf(out, TICK_TEXT_MAX, "%s%s", prefixes[i].prefix, unit);
            return;
        }
    if (axis->exponent)
        snprintf(out, TICK_TEXT_MAX, "x10^%d%s%s", axis->exponent, si ? " " : "", si ? unit : "");
}

void axis_name(const char *name, const char *scale, char *out, size_t size)
{
    snprintf(out, size, "%s%s%s", name, !scale[0] ? "" : scale[0] == 'x' ? " " : ", ", scale);
}

int axis_column(const Axis *axis, double value, int cells)
{
    ASSERT_INT(cells, >=, 0);
    double place = axis_share(axis, value) * cells;
    if (!(place >= -1e-9 * cells) || !(place <= cells * (1 + 1e-9)))
        return -1;
    int column = (int)floor(place + 1e-9);
    return column < cells ? column : cells - 1;
}

int axis_row(const Axis *axis, double value, int cells)
{
    ASSERT_INT(cells, >=, 0);
    double place =
        (axis_place(axis, axis->high) - axis_place(axis, value)) / axis_length(axis) * (4 * cells - 1);
    if (!(place >= -0.5) || !(place <= 4 * cells - 0.5))
        return -1;
    int row = (int)floor(place + 0.5 + 1e-9) / 4;
    return row < cells ? row : cells - 1;
}

/* As many ticks as stand evenly, each so many after the other, the one at zero among them where that can be.
 * To be read from afar not each of them. Of roots and logarithms all: they never lie evenly, or always do. */
static int even_ticks(Area area, const Axis *axis, bool up, int room, double ticks[TICKS_MAX])
{
    const int count = axis_ticks(axis, ticks);
    int zero = 0, cells[TICKS_MAX];
    for (int i = 0; i < count; i++) {
        cells[i] = up ? axis_row(axis, ticks[i], room) : axis_column(axis, ticks[i], room);
        zero = fabs(ticks[i]) < fabs(ticks[zero]) ? i : zero;
    }
    for (int stride = area.canvas->large && count > 3 ? 2 : 1; stride < count; stride++)
        for (int turn = 0; turn < stride; turn++) {
            /* Where all are two cells apart or more one is rounding, but two beside one is another scale. */
            const int first = (zero + turn) % stride;
            int n = 0, least = INT_MAX, most = 0;
            for (int i = first; i < count; i += stride, n++) {
                const int distance = n > 0 ? abs(cells[i] - cells[i - stride]) : 0;
                least = n > 0 && distance < least ? distance : least;
                most = distance > most ? distance : most;
            }
            const bool even = least > 0 && (most == least || (least > 1 && most - 1 == least));
            if (n < 2 || (axis->scale == SCALE_LINEAR && !even))
                continue;
            for (int i = 0; i < n; i++)
                ticks[i] = ticks[first + i * stride];
            return n;
        }
    return count;
}

Area axes_draw(Area area, const Axis *x, const Axis *y, const char *x_name, int gutter)
{
    int rows = area.rect.height - 1, columns = area.rect.width - gutter - 1;
    if (rows < 1 || columns < 4)
        return area_part(area, 0, 0, 0, 0);
    Area inner = area_part(area, gutter + 1, 0, columns, rows);

    double ticks[TICKS_MAX];
    char text[TICK_TEXT_MAX];
    for (int row = 0; row < rows; row++)
        area_put(area, gutter, row, 0x2502, STYLE_FRAME);
    int zero = y->low < 0 && y->high > 0 ? axis_row(y, 0, rows) : -1;
    int count = even_ticks(area, y, true, rows, ticks), before = rows + 1;
    for (int i = 0; i < count; i++) {
        int row = axis_row(y, ticks[i], rows);
        axis_label(y, ticks[i], text);
        /* where two would be in one row the first has it, but the line of 0 is that of 0 alone */
        const bool beside_zero = row == zero && fabs(ticks[i]) > 1e-9 * (y->high - y->low);
        if (row < 0 || row == before || beside_zero || glyphs_columns(text) > gutter)
            continue;
        before = row;
        area_text_right(area, gutter, row, text, STYLE_NORMAL);
        area_put(area, gutter, row, 0x2524, STYLE_FRAME);
    }
    for (int column = 0; zero >= 0 && column < columns; column++)
        area_put(inner, column, zero, 0x2500, STYLE_FRAME);

    int name = glyphs_columns(x_name), limit = area.rect.width - (name ? name + 1 : 0), used = gutter - 1;
    count = even_ticks(area, x, false, columns, ticks);
    for (int i = 0; i < count; i++) {
        int column = axis_column(x, ticks[i], columns);
        axis_label(x, ticks[i], text);
        int width = glyphs_columns(text), start = gutter + 1 + column - width / 2;
        if (start + width > area.rect.width && !name)
            start = area.rect.width - width;
        if (column < 0 || start <= used || start + width > limit)
            continue;
        area_text(area, start, rows, text, STYLE_NORMAL);
        used = start + width;
    }
    area_text_right(area, area.rect.width, rows, x_name, STYLE_FAINT);
    return inner;
}

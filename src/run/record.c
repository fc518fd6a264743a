/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keeps rows and keyframes of a run within a budget (record.h). */
#include "run/record.h"

#include "base/assertion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS_LEAST = 16 };

static double *row_at(Record *record, size_t i)
{
    return record->rows + i * (size_t)record->n_columns;
}

static size_t bytes_of(const Record *record, size_t rows)
{
    return rows * (size_t)record->n_columns * sizeof(double);
}

static bool is_due(const Record *record, double step)
{
    return (long)step % record->spacing == 0;
}

void record_open(Record *record, int n_columns, long every, size_t budget)
{
    ASSERT_INT(n_columns, >=, 2); /* step and time */
    size_t most = budget / ((size_t)n_columns * sizeof(double));
    *record = (Record){.n_columns = n_columns,
                       .spacing = every > 0 ? every : 1,
                       .most = most < ROWS_LEAST ? ROWS_LEAST : most};
}

void record_close(Record *record)
{
    free(record->rows);
    *record = (Record){0};
}

static bool make_room(Record *record)
{
    if (record->count < record->room)
        return true;
    if (record->room == record->most) {
        while (record->count == record->room) {
            /* Doubles the spacing and drops the rows that no longer are due; the newest is about to be
             * followed. */
            size_t kept = 0;
            record->spacing *= 2;
            record->thinned = true;
            for (size_t i = 0; i < record->count; i++)
                if (is_due(record, row_at(record, i)[0])) {
                    if (kept != i)
                        memcpy(row_at(record, kept), row_at(record, i), bytes_of(record, 1));
                    kept++;
                }
            record->count = kept;
        }
        return true;
    }
    size_t room = record->room ? 2 * record->room : 1024;
    if (room > record->most)
        room = record->most;
    double *rows = realloc(record->rows, bytes_of(record, room));
    if (!rows)
        return false;
    record->rows = rows;
    record->room = room;
    return true;
}

bool record_append(Record *record, const double *row)
{
    if (record->loose_last) {
        record->count--;
        record->loose_last = false;
    }
    ASSERT(record->count == 0 || row[0] > row_at(record, record->count - 1)[0]); /* each step once */
    if (!make_room(record))
        return false;
    memcpy(row_at(record, record->count++), row, bytes_of(record, 1));
    record->loose_last = !is_due(record, row[0]);
    return true;
}

void record_cut(Record *record, long step)
{
    ASSERT_INT(step, >=, 0);
    size_t count = record->count;
    while (count > 0 && row_at(record, count - 1)[0] > (double)step)
        count--;
    if (count == record->count)
        return;
    record->count = count;
    record->loose_last = count > 0 && !is_due(record, row_at(record, count - 1)[0]);
}

bool record_copy(Record *to, const Record *from)
{
    *to = *from;
    to->rows = NULL;
    to->room = from->count;
    if (from->count == 0)
        return true;
    to->rows = malloc(bytes_of(from, from->count));
    if (!to->rows) {
        *to = (Record){0};
        return false;
    }
    memcpy(to->rows, from->rows, bytes_of(from, from->count));
    return true;
}

const double *record_row(const Record *record, size_t i)
{
    ASSERT_INT(i, <, record->count);
    return record->rows + i * (size_t)record->n_columns;
}

double record_known(const Record *record, size_t i, int column)
{
    ASSERT_INDEX(i, record->count);
    ASSERT_INDEX(column, record->n_columns);
    enum { LOOK_BACK = 64 };
    double value = record_row(record, i)[column];
    for (int k = 0; k < LOOK_BACK && isnan(value) && i > 0; k++)
        value = record_row(record, --i)[column];
    return value;
}

const double *record_of_step(const Record *record, long step)
{
    ASSERT_INT(record->spacing, >=, 1);
    if (record->count == 0 || step < 0)
        return NULL;
    size_t i = (size_t)(step / record->spacing);
    if (i >= record->count || (step % record->spacing != 0))
        i = record->count - 1;
    const double *row = record_row(record, i);
    return row[0] == (double)step ? row : NULL;
}

size_t record_find(const Record *record, double t)
{
    ASSERT_INT(record->n_columns, >=, 2);
    size_t low = 0, high = record->count; /* rows before `low` are not later, from `high` on they are */
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (record_row(record, middle)[1] <= t)
            low = middle + 1;
        else
            high = middle;
    }
    return low > 0 ? low - 1 : 0;
}

/* Replaying a few dozen steps takes no noticeable time; a shorter interval would fill the memory with small
 * frames. */
enum { FIRST_INTERVAL = 32 };

void history_open(History *history, size_t budget)
{
    *history = (History){.budget = budget, .interval = FIRST_INTERVAL};
}

static void drop(History *history, size_t i)
{
    history->used -= history->frames[i].size;
    free(history->frames[i].bytes);
}

void history_close(History *history)
{
    for (size_t i = 0; i < history->count; i++)
        free(history->frames[i].bytes);
    free(history->frames);
    *history = (History){0};
}

static void thin(History *history)
{
    size_t kept = 0;
    history->interval *= 2;
    for (size_t i = 0; i < history->count; i++) {
        if (history->frames[i].step % history->interval == 0)
            history->frames[kept++] = history->frames[i];
        else
            drop(history, i);
    }
    history->count = kept;
}

void history_set_budget(History *history, size_t budget)
{
    history->budget = budget;
    while (history->count > 1 && history->used > budget)
        thin(history);
}

bool history_keep(History *history, const Simulation *sim)
{
    ASSERT_INT(sim->stage, ==, 0); /* a keyframe is a whole step */
    ASSERT_INT(sim->item, ==, 0);
    bool first = history->count == 0;
    if (sim->step % history->interval != 0 ||
        (!first && history->frames[history->count - 1].step >= sim->step))
        return true;
    size_t size = simulation_snapshot_size(sim);
    while (!first && history->used + size > history->budget) {
        if (history->count == 1)
            return true; /* nothing to give up but t = 0 */
        thin(history);
        if (sim->step % history->interval != 0)
            return true;
    }
    if (history->count == history->room) {
        const size_t room = first ? 16 : 2 * history->room;
        Keyframe *frames = realloc(history->frames, room * sizeof *frames);
        if (!frames)
            return !first;
        history->frames = frames;
        history->room = room;
    }
    unsigned char *bytes = malloc(size);
    if (!bytes)
        return !first;
    simulation_snapshot(sim, bytes);
    history->frames[history->count++] = (Keyframe){sim->step, size, bytes};
    history->used += size;
    return true;
}

const Keyframe *history_nearest(const History *history, long step)
{
    ASSERT_INT(step, >=, 0);
    size_t low = 0, high = history->count; /* frames before `low` are not later, from `high` on they are */
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (history->frames[middle].step <= step)
            low = middle + 1;
        else
            high = middle;
    }
    return low > 0 ? &history->frames[low - 1] : NULL;
}

void history_cut(History *history, long step)
{
    ASSERT_INT(step, >=, 0);
    while (history->count > 1 && history->frames[history->count - 1].step >= step)
        drop(history, --history->count);
}

void history_reset(History *history)
{
    history_cut(history, 1);
    history->interval = FIRST_INTERVAL;
}

long history_next(const History *history, long step)
{
    ASSERT_INT(step, >=, 0);
    return history->interval - step % history->interval;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The file FILE.partial (sweep_partial.h): opened and locked, its whole rows read back, rows appended and
 * flushed one by one, removed at the end. The key of a row is a hash (FNV-1a) of the scenario
 * that it came from, so rows survive reordering of the sweep but not a change of the run. */
#include "cli/sweep/sweep_partial.h"

#include "base/hash.h"
#include "base/input.h"
#include "base/output.h"
#include "base/text.h"
#include "scenario/scenario.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* --- the number of a combination ------------------------------------------------------------------ */

uint64_t sweep_partial_number(const Settings *settings, long steps)
{
    char *text = NULL, end[24];
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    if (!stream)
        return 0;
    bool written = scenario_write(stream, settings, NULL, NULL);
    written = text_stream_close(stream, &text) && written;
    int n = snprintf(end, sizeof end, "%ld", steps);
    uint64_t number = written ? hash_bytes(hash_bytes(HASH_BEGIN, text, size), end, (size_t)n) : 0;
    free(text);
    return !written ? 0 : number ? number : 1;
}

/* --- lines ---------------------------------------------------------------------------------------- */

enum { LINE_BYTES = 20 + RESULT_COLUMNS * (NUMBER_TEXT_MAX + 1) };

/* The columns of a row: another version of the program may have others. */
static void heading(char out[LINE_BYTES * 2])
{
    int n =
        sprintf(out, "# matvib " PACKAGE_VERSION " sweep: rows so far, for the same command to go on from\n"
                     "combination");
    for (int i = 0; i < RESULT_COLUMNS; i++)
        n += sprintf(out + n, ",%s", sweep_result_name((ResultColumn)i));
    sprintf(out + n, "\n");
}

static bool read_cells(const char *text, double cells[RESULT_COLUMNS])
{
    for (int i = 0; i < RESULT_COLUMNS; i++) {
        char *end;
        if (*text++ != ',')
            return false;
        cells[i] = strtod(text, &end);
        if (end == text)
            return false;
        text = end;
    }
    return *text == '\0';
}

static bool read_line(const char *line, uint64_t *number, double cells[RESULT_COLUMNS])
{
    char *end;
    *number = strtoull(line, &end, 16);
    return end == line + 16 && read_cells(end, cells);
}

/* Rows come nearly in the order of the combinations, so the search begins behind the last one found. */
typedef struct Search {
    const uint64_t *numbers;
    int count, at;
} Search;

static bool put_row(Search *search, uint64_t number, const double cells[RESULT_COLUMNS], SweepResult *results)
{
    bool known = false;
    for (int i = 0; i < search->count; i++) {
        int at = (search->at + i) % search->count;
        if (search->numbers[at] != number)
            continue;
        known = true;
        if (results[at].done)
            continue; /* the same values are there twice */
        results[at].done = true;
        memcpy(results[at].cells, cells, sizeof results[at].cells);
        search->at = (at + 1) % search->count;
        break;
    }
    return known;
}

/* --- the file ------------------------------------------------------------------------------------- */

static bool cannot_write(const SweepPartial *partial, Status *status)
{
    return status_fail(status, STATUS_FAILED, "%s: cannot be written: %s", partial->name, strerror(errno));
}

/* A lock of this process alone: its workers do not hold it. */
static bool lock(const SweepPartial *partial, Status *status)
{
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    if (fcntl(fileno(partial->stream), F_SETLK, &whole) == 0)
        return true;
    if (errno == EACCES || errno == EAGAIN)
        return status_fail(status, STATUS_USAGE, "%s: another sweep is writing it", partial->name);
    return cannot_write(partial, status);
}

static bool begin(SweepPartial *partial, Status *status)
{
    char text[LINE_BYTES * 2];
    heading(text);
    return (output_cut(partial->stream, 0) && fputs(text, partial->stream) >= 0 &&
            fflush(partial->stream) == 0) ||
           cannot_write(partial, status);
}

/* Returns where the last whole line ends; the last line may be torn where the computer stopped. -1: there is
 * a line that does not belong to this sweep. */
static long read_rows(SweepPartial *partial, Search *search, SweepResult *results)
{
    InputLines lines = {.stream = partial->stream, .name = partial->name};
    char expected[LINE_BYTES * 2], line[LINE_BYTES * 2];
    long end = 0;
    heading(expected);
    const char *wanted = expected;
    InputGot got;
    while ((got = input_line(&lines, line, sizeof line, NULL)) == INPUT_LINE && !lines.cut) {
        const size_t length = strcspn(wanted, "\n");
        uint64_t number;
        double cells[RESULT_COLUMNS];
        bool good = *wanted ? strlen(line) == length && strncmp(line, wanted, length) == 0
                            : read_line(line, &number, cells) && put_row(search, number, cells, results);
        if (!good)
            return -1;
        if (*wanted)
            wanted += length + 1;
        else
            partial->rows++;
        end = ftell(partial->stream);
    }
    if (got == INPUT_WRONG && !ferror(partial->stream))
        return -1;
    return *wanted && end > 0 ? 0 : end;
}

static bool resume(SweepPartial *partial, Search *search, bool force, SweepResult *results, Status *status)
{
    long end = read_rows(partial, search, results);
    if (end >= 0 &&
        !text_at_end(partial->stream, partial->name, status)) /* rows must not be cut off for that */
        return false;
    if (end < 0 && !force)
        return status_fail(status, STATUS_USAGE, "%s: holds rows of another sweep (--force begins anew)",
                           partial->name);
    if (end > 0)
        return output_cut(partial->stream, end) || cannot_write(partial, status);
    for (int i = 0; i < search->count; i++)
        results[i].done = false;
    partial->rows = 0;
    return begin(partial, status);
}

bool sweep_partial_open(SweepPartial *partial, const char *output, const uint64_t *numbers, int count,
                        bool force, SweepResult *results, Status *status)
{
    *partial = (SweepPartial){0};
    if (asprintf(&partial->name, "%s.partial", output) < 0) {
        partial->name = NULL;
        return status_fail(status, STATUS_FAILED, "not enough memory for the name of a file");
    }
    partial->stream = output_update(ASKER_COMMAND_LINE, partial->name, status);
    Search search = {numbers, count, 0};
    bool opened =
        partial->stream && lock(partial, status) && resume(partial, &search, force, results, status);
    if (!opened) {
        if (partial->stream)
            fclose(partial->stream);
        free(partial->name);
        *partial = (SweepPartial){0};
    }
    return opened;
}

bool sweep_partial_add(SweepPartial *partial, uint64_t number, const SweepResult *result, Status *status)
{
    char line[LINE_BYTES];
    int n = sprintf(line, "%016" PRIx64, number);
    for (int i = 0; i < RESULT_COLUMNS; i++) {
        line[n++] = ',';
        n += (int)text_shortest(line + n, result->cells[i]);
    }
    strcpy(line + n, "\n");
    partial->rows++;
    return !partial->stream || (fputs(line, partial->stream) >= 0 && fflush(partial->stream) == 0) ||
           cannot_write(partial, status);
}

void sweep_partial_close(SweepPartial *partial, bool finished)
{
    if (partial->stream) {
        /* before the lock goes with the stream */
        if (finished || partial->rows == 0)
            output_remove(ASKER_COMMAND_LINE, partial->name);
        fclose(partial->stream);
    }
    free(partial->name);
    *partial = (SweepPartial){0};
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Without libFuzzer: every file of a corpus, and a number of broken copies of each, always the same ones.
 *
 * Usage: fuzz_TARGET FILE-OR-FOLDER...     MATVIB_MUTANTS says how many copies (30) */
#include "fuzz/fuzz.h"

#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { INPUT_MAX = 1 << 16 };

static uint64_t random_state;

static size_t below(size_t limit)
{
    uint64_t *r = &random_state;
    *r ^= *r << 13, *r ^= *r >> 7, *r ^= *r << 17;
    return limit > 0 ? (size_t)(*r >> 11) % limit : 0;
}

/* One change: a byte, a piece taken away, doubled or put elsewhere, the end cut off. Returns the new size. */
static size_t change(uint8_t *data, size_t size)
{
    static const uint8_t odd[] = {0,    0xff, '\n', ';', '=', '"', '[', 0x1b,
                                  0x80, '-',  '9',  '.', ',', 'e', ' ', '#'};
    uint8_t piece[64];
    size_t from = below(size), length = 1 + below(sizeof piece - 1), to = below(size + 1);
    if (size == 0)
        return 0;
    length = length < size - from ? length : size - from;
    switch (below(6)) {
    case 0:
        data[from] ^= (uint8_t)(1u << below(8));
        return size;
    case 1:
        data[from] = odd[below(sizeof odd)];
        return size;
    case 2:
        memmove(data + from, data + from + length, size - from - length);
        return size - length;
    case 3:
        return from;
    default:
        if (size + length > INPUT_MAX)
            return size;
        memcpy(piece, data + from, length);
        memmove(data + to + length, data + to, size - to);
        memcpy(data + to, piece, length);
        return size + length;
    }
}

static bool is_short(FILE *file, uint8_t *data, size_t *size)
{
    *size = fread(data, 1, INPUT_MAX, file);
    return feof(file) || *size < INPUT_MAX;
}

static bool run_file(const char *path, long mutants)
{
    static uint8_t original[INPUT_MAX], mutant[INPUT_MAX];
    size_t size;
    FILE *file = fopen(path, "rb");
    bool sound = file && is_short(file, original, &size);
    if (file)
        fclose(file);
    if (!sound)
        return false;
    random_state = 0x9e3779b97f4a7c15u;
    LLVMFuzzerTestOneInput(original, size);
    for (long i = 0; i < mutants; i++) {
        size_t length = size;
        memcpy(mutant, original, size);
        for (size_t changes = 1 + below(6); changes > 0; changes--)
            length = change(mutant, length);
        LLVMFuzzerTestOneInput(mutant, length);
    }
    return true;
}

static bool run_path(const char *path, long mutants, long *files)
{
    struct stat what;
    if (stat(path, &what) != 0)
        return false;
    if (!S_ISDIR(what.st_mode)) {
        ++*files;
        return run_file(path, mutants);
    }
    struct dirent **entries;
    int count = scandir(path, &entries, NULL, alphasort);
    bool sound = count >= 0;
    for (int i = 0; i < count; i++) {
        char inside[4096];
        snprintf(inside, sizeof inside, "%s/%s", path, entries[i]->d_name);
        if (entries[i]->d_name[0] != '.')
            sound = run_path(inside, mutants, files) && sound;
        free(entries[i]);
    }
    if (count >= 0)
        free(entries);
    return sound;
}

int main(int count, char **arguments)
{
    const char *wanted = getenv("MATVIB_MUTANTS");
    long files = 0;
    for (int i = 1; i < count; i++)
        if (!run_path(arguments[i], wanted ? atol(wanted) : 30, &files)) {
            fprintf(stderr, "%s: %s cannot be read\n", arguments[0], arguments[i]);
            return 1;
        }
    return files > 0 ? 0 : 1;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Opening and reading files from outside (input.h): with O_NONBLOCK, so that a pipe does not wait. */
#include "base/input.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool cannot_read(const char *name, Status *status)
{
    const int why = errno ? errno : EIO;
    status_refuse(status, "%s: cannot be read: %s", name, strerror(why));
    errno = why;
    return false;
}

static bool too_large(const char *name, long most, Status *status)
{
    return status_refuse(status, "%s: is too large (at most %ld kB)", name, most / 1000);
}

/* What was opened without waiting is a file, and reads on as files do. */
static bool is_file(int descriptor, const char *name, long most, Status *status)
{
    struct stat what;
    if (fstat(descriptor, &what) != 0)
        return cannot_read(name, status);
    errno = S_ISDIR(what.st_mode) ? EISDIR : 0;
    if (errno)
        return cannot_read(name, status);
    if (!S_ISREG(what.st_mode))
        return status_refuse(status, "%s: is a pipe or a device (a file is expected)", name);
    if (what.st_size > most)
        return too_large(name, most, status);
    const int flags = fcntl(descriptor, F_GETFL);
    return (flags >= 0 && fcntl(descriptor, F_SETFL, flags & ~O_NONBLOCK) == 0) || cannot_read(name, status);
}

const char input_standard_name[] = "-";

/* What standard input held, once it was taken; as long as the program runs. */
static struct {
    char *text;
    size_t length;
} standard;

bool input_take_standard(long most, Status *status)
{
    if (standard.text)
        return true;
    standard.text = malloc((size_t)most + 1);
    if (!standard.text)
        return cannot_read(input_standard_name, status);
    standard.length = fread(standard.text, 1, (size_t)most + 1, stdin);
    return !ferror(stdin) || cannot_read(input_standard_name, status);
}

/* The names of what is read, as long as the program runs; a sweep reads on many threads. */
static struct {
    pthread_mutex_t lock;
    char **names;
    size_t count;
} noted = {.lock = PTHREAD_MUTEX_INITIALIZER};

static bool is_noted(const char *real)
{
    for (size_t i = 0; i < noted.count; i++)
        if (strcmp(noted.names[i], real) == 0)
            return true;
    return false;
}

bool input_is_read(const char *real)
{
    pthread_mutex_lock(&noted.lock);
    const bool is_read = is_noted(real);
    pthread_mutex_unlock(&noted.lock);
    return is_read;
}

bool input_note(const char *name, Status *status)
{
    char *real = realpath(name, NULL);
    if (!real)
        return errno != ENOMEM || cannot_read(name, status); /* what is not there nobody overwrites */
    pthread_mutex_lock(&noted.lock);
    bool sound = true;
    if (!is_noted(real)) {
        char **grown = realloc(noted.names, (noted.count + 1) * sizeof *grown);
        sound = grown != NULL;
        if (grown) {
            noted.names = grown;
            noted.names[noted.count++] = real;
            real = NULL;
        }
    }
    pthread_mutex_unlock(&noted.lock);
    free(real);
    if (!sound)
        errno = ENOMEM;
    return sound || cannot_read(name, status);
}

FILE *input_open(const char *name, long most, Status *status)
{
    if (standard.text && strcmp(name, input_standard_name) == 0) {
        if (standard.length > (size_t)most) {
            errno = 0;
            too_large(input_standard_name, most, status);
            return NULL;
        }
        if (standard.length == 0)
            return input_text("", input_standard_name, status);
        FILE *stream = fmemopen(standard.text, standard.length, "r");
        if (!stream)
            cannot_read(input_standard_name, status);
        return stream;
    }
    const int descriptor = open(name, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor < 0) {
        cannot_read(name, status);
        return NULL;
    }
    if (is_file(descriptor, name, most, status) && input_note(name, status)) {
        FILE *stream = fdopen(descriptor, "r");
        if (stream)
            return stream;
        cannot_read(name, status);
    }
    const int why = errno;
    close(descriptor);
    errno = why;
    return NULL;
}

FILE *input_text(const char *text, const char *name, Status *status)
{
    FILE *stream = fmemopen((void *)text, strlen(text), "r");
    if (!stream)
        status_fail(status, "%s: not enough memory to read it", name);
    return stream;
}

/* U+FEFF in UTF-8: spreadsheets and editors of Windows begin their files so. */
static const char byte_order_mark[] = "\xef\xbb\xbf";

InputGot input_line(InputLines *lines, char *line, size_t size, Status *status)
{
    size_t length = 0;
    int byte;
    errno = 0;
    while ((byte = getc(lines->stream)) != EOF && byte != '\n') {
        if (length == 0)
            lines->number++;
        if (byte == '\0')
            return status_refuse(status, "%s:%ld: holds a zero byte (text is expected)", lines->name,
                                 lines->number);
        if (length + 1 == size)
            return status_refuse(status, "%s:%ld: the line is too long (at most %zu bytes)", lines->name,
                                 lines->number, size - 1);
        line[length++] = (char)byte;
    }
    if (ferror(lines->stream))
        return cannot_read(lines->name, status);
    if (byte == EOF && length == 0)
        return INPUT_END;
    lines->number += length == 0;
    lines->cut = byte == EOF;
    length -= length > 0 && line[length - 1] == '\r';
    line[length] = '\0';
    if (lines->number == 1 && strncmp(line, byte_order_mark, strlen(byte_order_mark)) == 0)
        memmove(line, line + strlen(byte_order_mark), length - strlen(byte_order_mark) + 1);
    return INPUT_LINE;
}

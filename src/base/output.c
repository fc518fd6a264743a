/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The gate for writing (output.h), and everything else that the program does to a disk. */
#include "base/output.h"

#include "base/input.h"
#include "base/signals.h"
#include "base/visible.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

bool output_allowed(Asker asker, const char *name, Status *status)
{
    switch (asker) {
    case ASKER_KEYBOARD:
    case ASKER_COMMAND_LINE:
    case ASKER_SCRIPT:
        return true;
    case ASKER_REPLAY:
        return status_fail(status, "a replay writes no files: %s is not written", name);
    case ASKER_LESSON:
        return status_fail(status, "a lesson writes no files: %s is not written", name);
    case ASKER_NOBODY:
        break;
    }
    return status_fail(status, "nobody asked for it: %s is not written", name);
}

bool output_is_standard(const char *name)
{
    return strcmp(name, "-") == 0;
}

static bool cannot_write(const char *name, Status *status)
{
    return status_fail(status, "%s: cannot be written: %s", name, strerror(errno));
}

bool output_is_direct(const char *name)
{
    struct stat what;
    return output_is_standard(name) ||
           (stat(name, &what) == 0 && !S_ISREG(what.st_mode) && !S_ISDIR(what.st_mode));
}

static bool no_memory(Status *status)
{
    return status_fail(status, "not enough memory for the names of files");
}

char *output_real_name(const char *name, Status *status)
{
    char *whole = realpath(name, NULL); /* also through a symbolic link */
    if (whole)
        return whole;
    if (errno == ENOMEM)
        return no_memory(status), NULL;
    char *copies[2] = {strdup(name), strdup(name)}, *real = NULL;
    if (copies[0] && copies[1]) {
        char *folder = realpath(dirname(copies[0]), NULL), *base = basename(copies[1]);
        if (!folder)
            cannot_write(name, status);
        else if (asprintf(&real, "%s/%s", strcmp(folder, "/") == 0 ? "" : folder, base) < 0)
            real = NULL, no_memory(status);
        free(folder);
    } else
        no_memory(status);
    free(copies[0]);
    free(copies[1]);
    return real;
}

/* Whether the folder is there and takes a new file: a run of hours should not find that out at its end. */
static bool folder_takes(const char *name, Status *status)
{
    struct stat what;
    char *copy = strdup(name);
    if (!copy)
        return no_memory(status);
    const char *folder = dirname(copy);
    bool there = true;
    const bool known = stat(folder, &what) == 0; /* where it cannot be known, opening reports it */
    if (!known && (errno == ENOENT || errno == ENOTDIR))
        there = status_refuse(status, "%s: there is no folder %s", name, folder);
    else if (known && !S_ISDIR(what.st_mode))
        there = status_refuse(status, "%s: %s is not a folder", name, folder);
    free(copy);
    char *real = there ? output_real_name(name, status) : NULL;
    if (!real)
        return false;
    strrchr(real, '/')[0] = '\0';
    const bool takes = access(*real ? real : "/", W_OK | X_OK) == 0;
    free(real);
    return takes || cannot_write(name, status);
}

static bool overwrites_input(const char *name, Status *status)
{
    return status_refuse(status, "%s: the output would overwrite an input", name);
}

/* What a file of this program begins with, as its first line has it; what has no lines says of which kind it
 * is. */
static const char *const beginnings[] = {"step,time",
                                         "step,stage",
                                         "name,exercise,value,",
                                         "ID number,Full name,Grade,",
                                         "name,verdict,",
                                         "# matvib session: ",
                                         "matvib run ",
                                         "{\"version\": 2, \"width\"",
                                         "%PDF-",
                                         "% matvib ",
                                         "\x89PNG",
                                         "GIF8",
                                         "RIFF",
                                         "<svg "};
static const char *const columns[] = {",fitted,residual",
                                      ",steps,wall"}; /* of tables that begin as they may */

static bool begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

/* Whether this program wrote it, as far as its head shows; of one that is empty nothing is lost. */
static bool is_own(const char *name)
{
    static const char mark[] = "\xef\xbb\xbf", version[] = "# matvib ", xml[] = "<?xml ";
    char text[4096], *head = text;
    /* the head of the file, its commas as they were before a dialect */
    const int descriptor = open(name, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    const ssize_t length = descriptor < 0 ? -1 : read(descriptor, text, sizeof text - 1);
    if (descriptor >= 0)
        close(descriptor);
    text[length > 0 ? length : 0] = '\0';
    for (char *at = text; (at = strchr(at, ';'));)
        *at++ = ',';
    if (length < 0)
        return false;
    head += begins(text, mark) ? strlen(mark) : 0;
    if (!*head || (begins(head, xml) && (strstr(head, "\n<svg ") || strstr(head, "\n<VTKFile "))))
        return true;
    head[strcspn(head, "\r\n")] = '\0';
    bool known = begins(head, version) && isdigit((unsigned char)head[strlen(version)]);
    for (size_t i = 0; i < sizeof beginnings / sizeof *beginnings; i++)
        known |= begins(head, beginnings[i]);
    for (size_t i = 0; i < sizeof columns / sizeof *columns; i++)
        known |= strstr(head, columns[i]) != NULL;
    return known;
}

/* A regular file that is there. */
static bool may_replace(const char *name, Asker asker, bool force, Status *status)
{
    char *real = asker == ASKER_COMMAND_LINE ? output_real_name(name, NULL) : NULL;
    const bool is_input = real && input_is_read(real);
    free(real);
    if (is_input)
        return overwrites_input(name, status);
    if (asker == ASKER_COMMAND_LINE && !is_own(name))
        return status_refuse(status, "%s: exists and was not written by matvib (choose another name)", name);
    return force || status_refuse(status, "%s: exists (--force replaces it)", name);
}

bool output_may_begin(const char *name, Asker asker, bool force, Status *status)
{
    struct stat what;
    if (*name == '\0')
        return status_refuse(status, "a file needs a name");
    if (!visible_is_clean(name))
        return status_refuse(status, "%s: not a file name (UTF-8 without control characters)", name);
    if (output_is_standard(name))
        return true;
    if (stat(name, &what) != 0 && errno == ENAMETOOLONG)
        return status_refuse(status, "%s: the name is too long (most systems allow 255 bytes)", name);
    if (stat(name, &what) != 0 && lstat(name, &what) == 0 && S_ISLNK(what.st_mode))
        return status_refuse(status, "%s: is a link that leads nowhere", name);
    if (stat(name, &what) != 0)
        return folder_takes(name, status);
    if (S_ISDIR(what.st_mode))
        return status_refuse(status, "%s: is a folder", name);
    return !S_ISREG(what.st_mode) || (may_replace(name, asker, force, status) && folder_takes(name, status));
}

bool output_names_take(OutputNames *names, const char *name, Status *status)
{
    if (!name)
        return true;
    if (!output_may_begin(name, names->asker, names->force, status))
        return false;
    if (output_is_standard(name))
        return names->standard++ == 0 || status_refuse(status, "two outputs cannot both be standard output");
    if (names->count == names->room) {
        names->room = 2 * names->room + 16;
        char **grown = realloc(names->real, names->room * sizeof *grown);
        if (!grown)
            return no_memory(status);
        names->real = grown;
    }
    names->real[names->count] = output_real_name(name, status);
    return names->real[names->count] && ++names->count;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* There may be a million of them: two that are alike stand side by side once they are sorted. */
bool output_names_differ(OutputNames *names, bool sound, Status *status)
{
    if (names->count > 0)
        qsort(names->real, names->count, sizeof *names->real, compare_names);
    for (size_t i = 1; sound && i < names->count; i++)
        if (strcmp(names->real[i - 1], names->real[i]) == 0)
            sound = status_refuse(status, "%s: two outputs cannot be the same file", names->real[i]);
    for (size_t i = 0; i < names->count; i++)
        free(names->real[i]);
    free(names->real);
    return sound;
}

/* Bytes of the name of a file that the name of its temporary file begins with: that has more behind it, and a
 * name has no more than 255. */
static size_t stem_length(const char *base)
{
    enum { MOST = 255 - 32 };
    const size_t length = strlen(base);
    return length < MOST ? length : MOST;
}

/* The number of the process that a temporary file of this target belongs to; 0: it is none. */
static pid_t writer_of(const char *entry, const char *target)
{
    const size_t length = stem_length(target);
    long process;
    int end = 0;
    if (strncmp(entry, target, length) != 0 ||
        sscanf(entry + length, ".%ld-%*d.part%n", &process, &end) != 1 || end == 0 ||
        entry[length + (size_t)end])
        return 0;
    return process > 0 ? (pid_t)process : 0;
}

void output_remove_remains(const char *name)
{
    enum { LEAST_AGE = 60 }; /* s; in a folder shared by machines a process may be another's */
    char *copies[2] = {strdup(name), strdup(name)};
    DIR *folder = copies[0] && copies[1] ? opendir(dirname(copies[0])) : NULL;
    const char *target = folder ? basename(copies[1]) : NULL;
    for (const struct dirent *entry; folder && (entry = readdir(folder));) {
        struct stat what;
        const pid_t writer = writer_of(entry->d_name, target);
        if (writer > 0 && kill(writer, 0) != 0 && errno == ESRCH &&
            fstatat(dirfd(folder), entry->d_name, &what, AT_SYMLINK_NOFOLLOW) == 0 &&
            time(NULL) - what.st_mtime > LEAST_AGE)
            unlinkat(dirfd(folder), entry->d_name, 0);
    }
    if (folder)
        closedir(folder);
    free(copies[0]);
    free(copies[1]);
}

/* Files under temporary names, removed when a signal ends the program at once. */
typedef struct Temporary {
    struct Temporary *previous, *next;
    char *name;
} Temporary;

static Temporary *volatile first;
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

static void remove_temporaries(void)
{
    for (const Temporary *one = first; one; one = one->next)
        unlink(one->name);
}

/* It is removed, or has another name. */
static void leave_list(OutputFile *file)
{
    Temporary *one = file->temporary;
    file->temporary = NULL;
    if (!one)
        return;
    pthread_mutex_lock(&lock);
    if (one->next)
        one->next->previous = one->previous;
    if (one->previous)
        one->previous->next = one->next;
    else if (first == one)
        first = one->next;
    pthread_mutex_unlock(&lock);
    free(one->name);
    free(one);
}

/* A new file beside the target, with these rights, or with those that the user's mask gives. */
static bool open_temporary(OutputFile *file, mode_t rights, Status *status)
{
    int descriptor = -1;
    const char *slash = strrchr(file->target, '/'), *base = slash ? slash + 1 : file->target;
    const int stem = (int)((size_t)(base - file->target) + stem_length(base));
    const mode_t mode = rights ? rights : 0666;
    Temporary *one = file->temporary = calloc(1, sizeof *one);
    if (!one)
        return no_memory(status);
    signals_before_end(remove_temporaries);
    for (int i = 0; i < 100 && descriptor < 0; i++) {
        free(one->name);
        if (asprintf(&one->name, "%.*s.%ld-%d.part", stem, file->target, (long)getpid(), i) < 0) {
            one->name = NULL;
            break;
        }
        descriptor = open(one->name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (descriptor < 0 && errno != EEXIST)
            break;
    }
    if (descriptor >= 0) {
        pthread_mutex_lock(&lock);
        one->next = first;
        if (first)
            first->previous = one;
        first = one;
        pthread_mutex_unlock(&lock);
    }
    if (descriptor >= 0 && rights)
        (void)!fchmod(descriptor, mode);
    if (descriptor >= 0)
        file->stream = fdopen(descriptor, "w");
    if (file->stream)
        return true;
    one->name ? cannot_write(file->name, status) : no_memory(status);
    if (descriptor >= 0) {
        close(descriptor);
        unlink(one->name);
    }
    leave_list(file);
    return false;
}

bool output_open(OutputFile *file, Asker asker, const char *name, bool force, Status *status)
{
    *file = (OutputFile){.replaces = force, .spares = asker == ASKER_COMMAND_LINE};
    if (!output_allowed(asker, name, status) || !output_may_begin(name, asker, force, status))
        return false;
    file->name = strdup(name);
    if (!file->name)
        return no_memory(status);
    bool opened;
    file->standard = output_is_standard(name);
    if (file->standard) {
        file->stream = stdout;
        opened = true;
    } else if (output_is_direct(name)) {
        /* Opening a pipe without a reader would block for ever, with nothing on screen to show why. */
        const int descriptor =
            open(name, O_WRONLY | O_NOCTTY | O_CLOEXEC | (asker == ASKER_COMMAND_LINE ? 0 : O_NONBLOCK));
        file->stream = descriptor < 0 ? NULL : fdopen(descriptor, "w");
        if (!file->stream && descriptor >= 0)
            close(descriptor);
        opened = file->stream || cannot_write(name, status);
    } else {
        file->target = output_real_name(name, status);
        struct stat what;
        const bool there = file->target && stat(file->target, &what) == 0; /* keeps its rights */
        opened = file->target && open_temporary(file, there ? what.st_mode & 07777 : 0, status);
    }
    if (!opened)
        output_close(file);
    return opened;
}

bool output_open_own(OutputFile *file, Asker asker, const char *name, Status *status)
{
    *file = (OutputFile){.replaces = true};
    if (!output_allowed(asker, name, status))
        return false;
    file->name = strdup(name);
    file->target = strdup(name);
    if ((file->name && file->target) ? open_temporary(file, 0600, status) : no_memory(status))
        return true;
    output_close(file);
    return false;
}

bool output_sound(const OutputFile *file, Status *status)
{
    return !ferror(file->stream) || cannot_write(file->name, status);
}

bool output_finish(OutputFile *file, Status *status)
{
    bool arrived = fflush(file->stream) == 0 && !ferror(file->stream) &&
                   (!file->target || fsync(fileno(file->stream)) == 0);
    int why = errno;
    if (!file->standard) {
        arrived = fclose(file->stream) == 0 && arrived;
        file->stream = NULL;
    }
    if (!arrived && why != 0)
        errno = why;
    return arrived || cannot_write(file->name, status);
}

bool output_commit(OutputFile *file, Status *status)
{
    if (!file->temporary)
        return true;
    if (file->spares && file->replaces && input_is_read(file->target))
        return overwrites_input(file->name, status);
    /* A name that another program has taken since is refused: link() never replaces. Where there are no links
     * (some file systems of sticks and servers) the second comer wins. */
    if (!file->replaces && link(file->temporary->name, file->target) == 0)
        unlink(file->temporary->name);
    else if (!file->replaces && errno == EEXIST)
        return status_fail(status, "%s: another program has written it (--force replaces it)", file->name);
    else if (rename(file->temporary->name, file->target) != 0)
        return cannot_write(file->name, status);
    leave_list(file);
    /* Brings a new name to the disk; without it the file may be gone after the computer stopped. */
    char *copy = strdup(file->target);
    if (!copy)
        return no_memory(status);
    const int folder = open(dirname(copy), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    free(copy);
    /* some file systems, and folders without read permission, do not support it */
    const bool arrived = folder < 0 || fsync(folder) == 0 || errno == EINVAL || errno == ENOTSUP;
    const int why = errno;
    if (folder >= 0)
        close(folder);
    errno = why;
    return arrived || cannot_write(file->name, status);
}

bool output_publish(OutputFile *file, Status *status)
{
    return ((fflush(file->stream) == 0 && (!file->target || fsync(fileno(file->stream)) == 0)) ||
            cannot_write(file->name, status)) &&
           output_commit(file, status);
}

void output_close(OutputFile *file)
{
    if (file->stream && !file->standard)
        fclose(file->stream);
    if (file->temporary)
        unlink(file->temporary->name);
    leave_list(file);
    free(file->name);
    free(file->target);
    *file = (OutputFile){0};
}

void output_make_own_folders(Asker asker, const char *file)
{
    char *path = output_allowed(asker, file, NULL) ? strdup(file) : NULL;
    for (char *slash = path ? strchr(path + 1, '/') : NULL; slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        mkdir(path, 0700); /* where that fails, so will the file */
        if (!strchr(slash + 1, '/'))
            (void)!chmod(path, 0700); /* private to the user, even if another made the folder */
        *slash = '/';
    }
    free(path);
}

bool output_end(OutputFile *file, bool wanted, Status *status)
{
    const bool there = wanted && output_finish(file, status) && output_commit(file, status);
    output_close(file);
    return there;
}

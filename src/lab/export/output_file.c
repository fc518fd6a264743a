#include "lab/export/output_file.h"

#include "base/visible.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

bool output_is_standard(const char *name)
{
    return strcmp(name, "-") == 0;
}

static bool cannot_write(const char *name, Status *status)
{
    return status_fail(status, STATUS_FAILED, "%s: cannot be written: %s", name, strerror(errno));
}

bool output_is_direct(const char *name)
{
    struct stat what;
    return output_is_standard(name) ||
           (stat(name, &what) == 0 && !S_ISREG(what.st_mode) && !S_ISDIR(what.st_mode));
}

static bool no_memory(Status *status)
{
    return status_fail(status, STATUS_FAILED, "not enough memory for the names of files");
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

bool output_has_folder(const char *name, Status *status)
{
    struct stat what;
    char *copy = strdup(name);
    if (!copy)
        return no_memory(status);
    const char *folder = dirname(copy);
    bool there = true;
    const bool known = stat(folder, &what) == 0; /* one that may not be looked into is told by who opens */
    if (!known && (errno == ENOENT || errno == ENOTDIR))
        there = status_fail(status, STATUS_USAGE, "%s: there is no folder %s", name, folder);
    else if (known && !S_ISDIR(what.st_mode))
        there = status_fail(status, STATUS_USAGE, "%s: %s is no folder", name, folder);
    free(copy);
    return there;
}

/* Whether the folder is there and takes a new file: a run of hours should not find that out at its end. */
static bool folder_takes(const char *name, Status *status)
{
    if (!output_has_folder(name, status))
        return false;
    char *real = output_real_name(name, status);
    if (!real)
        return false;
    strrchr(real, '/')[0] = '\0';
    const bool takes = access(*real ? real : "/", W_OK | X_OK) == 0;
    free(real);
    return takes || cannot_write(name, status);
}

bool output_may_begin(const char *name, bool force, Status *status)
{
    struct stat what;
    if (*name == '\0')
        return status_fail(status, STATUS_USAGE, "a file needs a name");
    if (!text_is_clean(name))
        return status_fail(status, STATUS_USAGE,
                           "%s: is no name for a file (UTF-8 without control characters)", name);
    if (output_is_standard(name))
        return true;
    if (stat(name, &what) != 0)
        return folder_takes(name, status);
    if (S_ISDIR(what.st_mode))
        return status_fail(status, STATUS_USAGE, "%s: is a folder", name);
    if (S_ISREG(what.st_mode) && !force)
        return status_fail(status, STATUS_USAGE, "%s: exists (--force replaces it)", name);
    return !S_ISREG(what.st_mode) || folder_takes(name, status);
}

/* The number of the process that a temporary file of this target belongs to; 0: it is none. */
static pid_t writer_of(const char *entry, const char *target)
{
    const size_t length = strlen(target);
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

/* A new file beside the target, with the rights that the user's mask (or the file to be replaced) gives. */
static bool open_temporary(OutputFile *file, Status *status)
{
    struct stat what;
    int descriptor = -1;
    bool replaces = stat(file->target, &what) == 0;
    mode_t mode = replaces ? what.st_mode & 07777 : 0666;
    for (int i = 0; i < 100 && descriptor < 0; i++) {
        free(file->temporary);
        if (asprintf(&file->temporary, "%s.%ld-%d.part", file->target, (long)getpid(), i) < 0) {
            file->temporary = NULL;
            return no_memory(status);
        }
        descriptor = open(file->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (descriptor < 0 && errno != EEXIST)
            break;
    }
    if (descriptor >= 0 && replaces)
        (void)!fchmod(descriptor, mode);
    if (descriptor >= 0)
        file->stream = fdopen(descriptor, "w");
    if (file->stream)
        return true;
    cannot_write(file->name, status);
    if (descriptor >= 0) {
        close(descriptor);
        unlink(file->temporary);
    }
    free(file->temporary);
    file->temporary = NULL;
    return false;
}

bool output_open(OutputFile *file, const char *name, bool force, Status *status)
{
    *file = (OutputFile){.replaces = force};
    if (!output_may_begin(name, force, status))
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
        file->stream = fopen(name, "we");
        opened = file->stream || cannot_write(name, status);
    } else {
        file->target = output_real_name(name, status);
        opened = file->target && open_temporary(file, status);
    }
    if (!opened)
        output_close(file);
    return opened;
}

bool output_sound(const OutputFile *file, Status *status)
{
    return !ferror(file->stream) || cannot_write(file->name, status);
}

bool output_finish(OutputFile *file, Status *status)
{
    bool arrived = fflush(file->stream) == 0 && !ferror(file->stream) &&
                   (!file->temporary || fsync(fileno(file->stream)) == 0);
    int why = errno;
    if (!file->standard) {
        arrived = fclose(file->stream) == 0 && arrived;
        file->stream = NULL;
    }
    if (!arrived && why != 0)
        errno = why;
    return arrived || cannot_write(file->name, status);
}

/* A name that another program has taken since is refused: link() never replaces. Where there are no links
 * (some file systems of sticks and servers) the second comer wins. */
static bool take_free_name(const OutputFile *file, Status *status)
{
    if (link(file->temporary, file->target) == 0) {
        unlink(file->temporary);
        return true;
    }
    if (errno == EEXIST)
        return status_fail(status, STATUS_FAILED, "%s: another program has written it (--force replaces it)",
                           file->name);
    return rename(file->temporary, file->target) == 0 || cannot_write(file->name, status);
}

bool output_commit(OutputFile *file, Status *status)
{
    if (!file->temporary)
        return true;
    if (!file->replaces) {
        if (!take_free_name(file, status))
            return false;
    } else if (rename(file->temporary, file->target) != 0)
        return cannot_write(file->name, status);
    free(file->temporary);
    file->temporary = NULL;
    return true;
}

void output_close(OutputFile *file)
{
    if (file->stream && !file->standard)
        fclose(file->stream);
    if (file->temporary)
        unlink(file->temporary);
    free(file->name);
    free(file->target);
    free(file->temporary);
    *file = (OutputFile){0};
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Linked with the whole program, this lets one thing go wrong in it: an allocation, of ours or of any
 * library, or something that is given to a disk.
 *
 *     MATVIB_FAULT=memory:N    the N-th allocation from main on finds no memory
 *     MATVIB_FAULT=disk:N      the N-th call that writes, makes or renames a file finds the disk full
 *     MATVIB_FAULT=thread:N    the N-th thread is not started
 *     MATVIB_FAULT=hang:N      the N-th new file is waited for without an end
 *     MATVIB_FAULT_COUNT=FILE  how many there were, written at the end (N = 0: none fails)
 *
 * The functions named malloc and so on go before those of the C library, for the libraries too. Writes fail
 * in the kernel, where those of stdio arrive as well: a filter of system calls asks a thread of this file,
 * which counts and answers. Standard error is left alone, for it has to tell. */
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <linux/filter.h>
#include <linux/seccomp.h>

enum { COUNT_FD = 900 };

static long fails_at;
static atomic_long n_calls;
static atomic_bool memory_fails, thread_fails, hangs;

/* --- memory ------------------------------------------------------------------------------------------ */

#ifndef MATVIB_SANITIZERS /* which has a malloc of its own */

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

static bool fails(void)
{
    if (!memory_fails || ++n_calls != fails_at)
        return false;
    errno = ENOMEM;
    return true;
}

void *malloc(size_t size)
{
    return fails() ? NULL : __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
    return fails() ? NULL : __libc_calloc(count, size);
}

void *realloc(void *old, size_t size)
{
    return fails() ? NULL : __libc_realloc(old, size);
}

void *aligned_alloc(size_t alignment, size_t size)
{
    return fails() ? NULL : __libc_memalign(alignment, size);
}

int posix_memalign(void **block, size_t alignment, size_t size)
{
    void *aligned = aligned_alloc(alignment, size);
    if (aligned)
        *block = aligned;
    return aligned ? 0 : ENOMEM;
}

#endif

/* --- disk -------------------------------------------------------------------------------------------- */

static _Noreturn void *answer_calls(void *context)
{
    const int listener = *(const int *)context;
    for (;;) {
        struct seccomp_notif call = {0};
        if (ioctl(listener, SECCOMP_IOCTL_NOTIF_RECV, &call) != 0)
            continue; /* who asked is gone */
        struct seccomp_notif_resp answer = {.id = call.id, .flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE};
        if (++n_calls == fails_at) {
            answer.flags = 0;
            answer.error = -ENOSPC;
        }
        ioctl(listener, SECCOMP_IOCTL_NOTIF_SEND, &answer);
    }
}

enum { PROGRAM_MAX = 64 };

typedef struct Program {
    struct sock_filter steps[PROGRAM_MAX];
    unsigned short count;
} Program;

static void add(Program *program, int code, size_t value, int then, int otherwise)
{
    program->steps[program->count++] =
        (struct sock_filter){(uint16_t)code, (uint8_t)then, (uint8_t)otherwise, (uint32_t)value};
}

static void load(Program *program, size_t offset)
{
    add(program, BPF_LD | BPF_W | BPF_ABS, offset, 0, 0);
}

/* The half of an argument in which a descriptor or flags stand. */
static void load_argument(Program *program, int which)
{
    const size_t low = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? 0 : 4;
    load(program, offsetof(struct seccomp_data, args) + 8 * (size_t)which + low);
}

static void answer(Program *program, uint32_t what)
{
    add(program, BPF_RET | BPF_K, what, 0, 0);
}

/* Skips `steps` unless the number that was loaded is this one. */
static void unless(Program *program, long value, int steps)
{
    add(program, BPF_JMP | BPF_JEQ | BPF_K, (size_t)value, 0, steps);
}

static void compose(Program *program)
{
    static const long always[] = {
        SYS_fsync,  SYS_linkat, SYS_renameat2, SYS_mkdirat,
#ifdef SYS_rename /* newer machines have only the others */
        SYS_rename, SYS_link,   SYS_mkdir,
#endif
    };
    static const long to_descriptor[] = {SYS_write, SYS_writev};
    load(program, offsetof(struct seccomp_data, nr));
    for (size_t i = 0; i < sizeof always / sizeof *always; i++) {
        unless(program, always[i], 1);
        answer(program, SECCOMP_RET_USER_NOTIF);
    }
    for (size_t i = 0; i < sizeof to_descriptor / sizeof *to_descriptor; i++) {
        unless(program, to_descriptor[i], 6);
        load_argument(program, 0);
        unless(program, STDERR_FILENO, 1);
        answer(program, SECCOMP_RET_ALLOW);
        unless(program, COUNT_FD, 1);
        answer(program, SECCOMP_RET_ALLOW);
        answer(program, SECCOMP_RET_USER_NOTIF);
    }
    unless(program, SYS_openat, 3);
    load_argument(program, 2);
    add(program, BPF_JMP | BPF_JSET | BPF_K, O_WRONLY | O_RDWR | O_CREAT, 0, 1);
    answer(program, SECCOMP_RET_USER_NOTIF);
    answer(program, SECCOMP_RET_ALLOW);
}

static bool watch_disk(void)
{
    static int listener; /* for the thread */
    Program program = {.count = 0};
    compose(&program);
    struct sock_fprog filter = {program.count, program.steps};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        return false;
    listener = (int)syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_NEW_LISTENER, &filter);
    if (listener < 0)
        return false;
    sigset_t all, before;
    pthread_t thread;
    sigfillset(&all); /* signals are the program's */
    pthread_sigmask(SIG_BLOCK, &all, &before);
    const bool runs = pthread_create(&thread, NULL, answer_calls, &listener) == 0;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return runs;
}

/* --- threads ----------------------------------------------------------------------------------------- */

typedef int CreateThread(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);

int pthread_create(pthread_t *restrict thread, const pthread_attr_t *restrict attributes,
                   void *(*start)(void *), void *restrict argument)
{
    if (thread_fails && ++n_calls == fails_at)
        return EAGAIN;
    void *const found = dlsym(RTLD_NEXT, "pthread_create");
    CreateThread *create;
    memcpy(&create, &found, sizeof create);
    return create(thread, attributes, start, argument);
}

/* --- what never ends --------------------------------------------------------------------------------- */

int link(const char *before, const char *after)
{
    if (hangs && ++n_calls == fails_at)
        for (;;)
            continue;
    return linkat(AT_FDCWD, before, AT_FDCWD, after, 0);
}

/* --- the beginning and the end ------------------------------------------------------------------------- */

static void write_count(void)
{
    char text[32];
    const long count = n_calls;
    memory_fails = false;
    const int length = snprintf(text, sizeof text, "%ld\n", count);
    if (write(COUNT_FD, text, (size_t)length) != length)
        _exit(99);
}

__attribute__((constructor)) static void begin(void)
{
    const char *fault = getenv("MATVIB_FAULT"), *file = getenv("MATVIB_FAULT_COUNT");
    char kind[8];
    if (!fault || sscanf(fault, "%7[a-z]:%ld", kind, &fails_at) != 2)
        return;
    const int descriptor = file ? open(file, O_WRONLY | O_CREAT | O_TRUNC, 0600) : -1;
    if (descriptor >= 0 && dup3(descriptor, COUNT_FD, O_CLOEXEC) == COUNT_FD) {
        close(descriptor);
        atexit(write_count);
    }
    if (strcmp(kind, "memory") == 0)
        memory_fails = true;
    else if (strcmp(kind, "thread") == 0)
        thread_fails = true;
    else if (strcmp(kind, "hang") == 0)
        hangs = true;
    else if (!watch_disk()) {
        fprintf(stderr, "faults: the kernel takes no filter: %s\n", strerror(errno));
        _exit(77);
    }
}

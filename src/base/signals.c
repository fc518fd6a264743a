/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Handlers that note the first signal and do nothing else (signals.h). Which handlers stood before is kept,
 * so that a signal can be taken back before the process ends itself by it. */
#include "base/signals.h"
#include "base/wait.h"

#include <stdbool.h>
#include <stddef.h>
#include <unistd.h>

static const int named[] = {
    SIGHUP,    SIGINT,  SIGQUIT, SIGPIPE,   SIGALRM, SIGTERM, SIGUSR1,
    SIGUSR2,   SIGXCPU, SIGXFSZ, SIGVTALRM, SIGPROF, SIGSYS,  SIGTRAP,
#ifdef SIGIO
    SIGIO,
#endif
#ifdef SIGPWR
    SIGPWR,
#endif
#ifdef SIGSTKFLT
    SIGSTKFLT,
#endif
#ifdef SIGEMT
    SIGEMT,
#endif
};
enum { N_NAMED = sizeof named / sizeof *named, SIGNALS_MAX = N_NAMED + 64 };

#define TOGETHER_SECONDS 0.5

static volatile sig_atomic_t ended_by;
static double ended_at;
static void (*farewell)(void);
static struct {
    int number;
    struct sigaction before;
} taken[SIGNALS_MAX];
static int n_taken;

static void (*clean_up)(void);

void signals_end_at_once(int number)
{
    if (clean_up)
        clean_up();
    signal(number, SIG_DFL);
    raise(number);
}

static void guard(int number)
{
    struct sigaction before, action = {.sa_handler = signals_end_at_once};
    sigemptyset(&action.sa_mask);
    if (sigaction(number, NULL, &before) == 0 && before.sa_handler == SIG_DFL)
        sigaction(number, &action, NULL);
}

void signals_before_end(void (*clean)(void))
{
    static const int faults[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
    if (clean_up)
        return;
    clean_up = clean;
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++)
        guard(faults[i]);
    for (int i = 0; i < N_NAMED; i++)
        guard(named[i]);
#ifdef SIGRTMIN
    for (int number = SIGRTMIN; number <= SIGRTMAX; number++)
        guard(number);
#endif
}

void signals_end(int number)
{
    if (ended_by != 0)
        return;
    ended_at = clock_seconds();
    ended_by = number;
}

void signals_farewell(void (*last)(void))
{
    farewell = last;
}

static void note(int number, siginfo_t *info, void *context)
{
    (void)context;
    const bool own_write = (number == SIGPIPE || number == SIGXFSZ) && info->si_pid == getpid();
    if (!own_write && ended_by != 0 && clock_seconds() - ended_at >= TOGETHER_SECONDS) {
        if (farewell)
            farewell();
        signals_end_at_once(number);
    } else if (!own_write)
        signals_end(number);
}

static void take(int number)
{
    struct sigaction before, action = {.sa_sigaction = note, .sa_flags = SA_SIGINFO};
    sigemptyset(&action.sa_mask);
    if (n_taken == SIGNALS_MAX || sigaction(number, NULL, &before) != 0)
        return;
    /* that a write fails instead of ending the program is the program's own wish */
    const bool ignored = before.sa_handler == SIG_IGN && number != SIGPIPE && number != SIGXFSZ;
    const bool handled = before.sa_handler != SIG_IGN && before.sa_handler != SIG_DFL &&
                         before.sa_handler != signals_end_at_once;
    if (ignored || handled || sigaction(number, &action, NULL) != 0)
        return;
    taken[n_taken].number = number;
    taken[n_taken++].before = before;
}

void signals_catch(void)
{
    for (int i = 0; i < N_NAMED; i++)
        take(named[i]);
#ifdef SIGRTMIN
    for (int number = SIGRTMIN; number <= SIGRTMAX; number++)
        take(number);
#endif
}

void signals_forget(void)
{
    ended_by = 0;
}

int signals_ended_by(void)
{
    return (int)ended_by;
}

void signals_block(sigset_t *before)
{
    sigset_t blocked;
    sigemptyset(&blocked);
    for (int i = 0; i < n_taken; i++)
        sigaddset(&blocked, taken[i].number);
    sigprocmask(SIG_BLOCK, &blocked, before);
}

void signals_release(void)
{
    for (int i = 0; i < n_taken; i++)
        if (!ended_by || taken[i].number == SIGINT || taken[i].number == SIGQUIT)
            sigaction(taken[i].number, &taken[i].before, NULL);
    n_taken = 0;
}

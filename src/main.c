/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arguments in, exit status out: the only place that prints an error or exits. */
#include "base/visible.h"
#include "cli/cli.h"
#include "cli/options.h"
#include "methods/bonds/plane/lattice/bonds.h"
#include "scenario/scenario.h"

#include <curses.h>
#include <describe.h>
#include <errno.h>
#include <gsl/gsl_version.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#ifdef HAVE_CAIRO
#include <cairo.h>
#endif

/* "rnu mode1" is not a scenario but a slip of the fingers, or a command that this version has not. */
static bool is_slip(const char *word, Status *status)
{
    if (*word == '-' || scenario_builtin(word) || access(word, F_OK) == 0 || errno != ENOENT)
        return false;
    if (!options_stand("command", word, status))
        return true;
    const char *nearest = cli_nearest(word);
    if (nearest && !cli_find(nearest))
        return false; /* a scenario is meant, and its reader says which */
    if (nearest)
        status_refuse(status, "%.60s: no such command, scenario or file (did you mean %s?)", word, nearest);
    else
        status_refuse(status, "%.60s: no such command, scenario or file (see: matvib --help)", word);
    return true;
}

static bool asks_for_help(int count, char **arguments)
{
    for (int i = 0; i < count && strcmp(arguments[i], "--") != 0; i++)
        if (options_asks_help(arguments[i]))
            return true;
    return false;
}

static void print_version(void)
{
    const char *described = DESCRIBE;
    puts("matvib " PACKAGE_VERSION);
    if (*described)
        printf("commit: %s\n", described);
    printf("kernels:");
    for (int level = 0; level < CPU_LEVELS && bonds_cpu_has((CpuLevel)level); level++)
        printf(" %s", bonds_cpu_name((CpuLevel)level));
    puts("\nlibraries: ncurses " NCURSES_VERSION ", GSL " GSL_VERSION
#ifdef HAVE_CAIRO
         ", cairo " CAIRO_VERSION_STRING
#endif
#ifdef HAVE_GIF
         ", giflib"
#endif
#ifdef HAVE_UTF8PROC
         ", utf8proc"
#endif
    );
}

static int run(int count, char **arguments, Status *status)
{
    if (count > 0 && (strcmp(arguments[0], "--version") == 0 || strcmp(arguments[0], "-V") == 0)) {
        print_version();
        return STATUS_DONE;
    }
    const CliCommand *command = count > 0 ? cli_find(arguments[0]) : NULL;
    if (asks_for_help(count, arguments)) {
        cli_print_help(command);
        return STATUS_DONE;
    }
    if (command)
        return cli_do(command, count - 1, arguments + 1, status);
    return count > 0 && is_slip(arguments[0], status) ? (int)status->code
                                                      : cli_do(&cli_laboratory, count, arguments, status);
}

/* Of a write that failed a while ago stdio knows that it failed but no longer why; who tries once more is
 * told. What was written is broken already. */
static const char *why_not_written(void)
{
    return write(STDOUT_FILENO, "\n", 1) < 0 ? strerror(errno) : "not all of it was written";
}

/* Whether all of standard output has arrived; if not, the status says why. */
static bool close_output(Status *status)
{
    const bool lost = ferror(stdout) != 0;
    const char *why = fflush(stdout) != 0 ? strerror(errno) : lost ? why_not_written() : NULL;
    if (fclose(stdout) != 0 && !why)
        why = strerror(errno);
    return !why || status_fail(status, "standard output: %s", why);
}

int main(int count, char **arguments)
{
    Status status = {0}, output = {0};
    signal(SIGPIPE, SIG_IGN); /* a closed pipe is a failed write, said in one line */
    signal(SIGXFSZ, SIG_IGN); /* so is a file that grows beyond ulimit -f */
    int result = run(count - 1, arguments + 1, &status);
    const bool complete = close_output(&output);
    if (!complete && result == STATUS_DONE) {
        status = output;
        result = STATUS_FAILED;
    }
    if (result != STATUS_DONE && *status.text)
        visible_print(stderr, "matvib: %s\n", status.text);
    return result;
}

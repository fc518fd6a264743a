/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the moving picture costs: share of a core, bytes and writes for each frame of mode1 at 80x24; how soon
 * a key is answered while the notched beam runs; and whether a plate of four million bonds keeps 30 frames a
 * second and a key's answer within one, seen as a map over its series and over its cracks. Measured on the
 * real program in a pseudo terminal.
 *
 * Usage: bench_screen [SECONDS] */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include <utmp.h>

typedef struct Cost {
    double seconds, cpu;
    long bytes, frames, pieces; /* pieces: reads that found something; at least the number of writes seen */
} Cost;

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* The program in a terminal of 80x24, and the pipe through which it tells about its pictures. */
typedef struct Program {
    pid_t child;
    int master, slave, frames;
} Program;

enum { WORDS_MAX = 16 };

/* The words after "matvib", with spaces between them. */
static pid_t start(int master, int slave, int frames, const char *words)
{
    const char *program = getenv("MATVIB");
    pid_t child = fork();
    if (child != 0)
        return child;
    char number[16];
    snprintf(number, sizeof number, "%d", frames);
    setenv("MATVIB_FRAME_FD", number, 1);
    setenv("TERM", "xterm-256color", 1);
    setenv("LC_ALL", "C.UTF-8", 1);
    close(master);
    login_tty(slave);
    char line[400], *arguments[WORDS_MAX] = {"matvib"};
    int n = 1;
    snprintf(line, sizeof line, "%s", words);
    for (char *word = strtok(line, " "); word && n < WORDS_MAX - 1; word = strtok(NULL, " "))
        arguments[n++] = word;
    execv(program ? program : "./matvib", arguments);
    _exit(127);
}

static long count_lines(int descriptor)
{
    char text[4096];
    long lines = 0;
    ssize_t got = read(descriptor, text, sizeof text);
    for (ssize_t i = 0; i < got; i++)
        lines += text[i] == '\n';
    return lines;
}

static double cpu_of(const struct rusage *usage)
{
    return (double)usage->ru_utime.tv_sec + (double)usage->ru_stime.tv_sec +
           1e-6 * (double)(usage->ru_utime.tv_usec + usage->ru_stime.tv_usec);
}

static bool open_program(Program *program, const char *words)
{
    struct winsize size = {.ws_row = 24, .ws_col = 80};
    int frames[2];
    if (openpty(&program->master, &program->slave, NULL, NULL, &size) != 0 || pipe(frames) != 0)
        return false;
    fcntl(frames[0], F_SETFD, FD_CLOEXEC);
    program->frames = frames[0];
    program->child = start(program->master, program->slave, frames[1], words);
    close(frames[1]);
    return program->child > 0;
}

/* Ends it and tells what it has used. */
static bool close_program(Program *program, struct rusage *usage)
{
    int status;
    kill(program->child, SIGTERM);
    bool ended = wait4(program->child, &status, 0, usage) == program->child;
    close(program->master);
    close(program->slave);
    close(program->frames);
    return ended;
}

/* Reads a piece of what is drawn, and answers as terminals do: without it each picture waits for a time-out.
 */
static ssize_t take_output(const Program *program)
{
    static const char query[] = "\033[5n", answer[] = "\033[0n";
    char text[65536];
    const ssize_t got = read(program->master, text, sizeof text);
    if (got > 0 && memmem(text, (size_t)got, query, sizeof query - 1) &&
        write(program->master, answer, sizeof answer - 1) < 0)
        return -1;
    return got;
}

static int measure(const char *words, double seconds, Cost *cost)
{
    Program program;
    if (!open_program(&program, words))
        return 1;
    *cost = (Cost){0};
    double begin = now(), left;
    while ((left = begin + seconds - now()) > 0) {
        struct pollfd both[2] = {{.fd = program.master, .events = POLLIN},
                                 {.fd = program.frames, .events = POLLIN}};
        if (poll(both, 2, (int)(1e3 * left) + 1) < 0 && errno != EINTR)
            break;
        if (both[0].revents & POLLIN) {
            const ssize_t got = take_output(&program);
            cost->bytes += got > 0 ? got : 0;
            cost->pieces++;
        }
        if (both[1].revents & POLLIN)
            cost->frames += count_lines(program.frames);
        else if (both[1].revents)
            break;
    }
    cost->seconds = now() - begin;
    struct rusage usage;
    if (!close_program(&program, &usage))
        return 1;
    cost->cpu = cpu_of(&usage);
    return cost->frames > 0 ? 0 : 1;
}

/* Reads what comes, up to a time or, with `idle`, until the program tells that it waits for a key. */
static bool listen_until(const Program *program, double until, bool idle)
{
    char text[65536];
    double left;
    while ((left = until - now()) > 0) {
        struct pollfd both[2] = {{.fd = program->master, .events = POLLIN},
                                 {.fd = program->frames, .events = POLLIN}};
        if (poll(both, 2, (int)(1e3 * left) + 1) < 0 && errno != EINTR)
            return false;
        if (both[0].revents & POLLIN && take_output(program) < 0)
            return false;
        if (both[1].revents & POLLIN) {
            ssize_t got = read(program->frames, text, sizeof text - 1);
            text[got > 0 ? got : 0] = '\0';
            if (idle && strstr(text, "idle"))
                return true;
        } else if (both[1].revents)
            return false;
    }
    return !idle;
}

static int by_size(const void *a, const void *b)
{
    double one = *(const double *)a, other = *(const double *)b;
    return (one > other) - (one < other);
}

/* Presses Space again and again at odd moments; an answer is the picture that says PAUSED. */
static int measure_keys(const char *words, double warm, double answers[], int count)
{
    Program program;
    struct rusage usage;
    if (!open_program(&program, words) || !listen_until(&program, now() + warm, false))
        return 1;
    bool sound = true;
    for (int i = 0; sound && i < count; i++) {
        double begin = now();
        sound = write(program.master, " ", 1) == 1 && listen_until(&program, begin + 10, true);
        answers[i] = now() - begin;
        sound = sound && write(program.master, " ", 1) == 1 &&
                listen_until(&program, now() + 0.04 + 0.007 * (i % 8), false);
    }
    qsort(answers, (size_t)count, sizeof *answers, by_size);
    return close_program(&program, &usage) && sound ? 0 : 1;
}

/* The first seconds, in which the program starts, are taken away from a longer run. */
static int measure_running(const char *words, double warm, double seconds, Cost *cost)
{
    Cost first;
    if (measure(words, warm, &first) != 0 || measure(words, seconds + warm, cost) != 0)
        return 1;
    cost->seconds -= first.seconds, cost->cpu -= first.cpu;
    cost->bytes -= first.bytes, cost->frames -= first.frames, cost->pieces -= first.pieces;
    return 0;
}

static int bench_keys(const char *words, const char *title, double warm)
{
    enum { KEYS = 24 };
    double answers[KEYS];
    if (measure_keys(words, warm, answers, KEYS) != 0) {
        fprintf(stderr, "bench_screen: %s did not answer\n", title);
        return 1;
    }
    printf("a key while %s runs at 80x24: answered within %.0f ms (median), %.0f ms (worst of %d)\n", title,
           1e3 * answers[KEYS / 2], 1e3 * answers[KEYS - 1], KEYS);
    return 0;
}

/* Frames of a plate whose steps take a good part of a frame each. */
static int bench_large(const char *view, double seconds)
{
    char words[300], title[80];
    Cost cost;
    snprintf(words, sizeof words,
             "branching --set pd.spacing=0.000155 --set pd.horizon=0.00062 --set time.step=3e-8 --set "
             "view.lower=%s",
             view);
    snprintf(title, sizeof title, "a plate of 4e6 bonds over %s", view);
    if (measure_running(words, 8, seconds, &cost) != 0) {
        fprintf(stderr, "bench_screen: %s did not run\n", title);
        return 1;
    }
    printf("%s at 80x24 for %.0f s: %.1f frames a second, %.0f %% of a core\n", title, cost.seconds,
           (double)cost.frames / cost.seconds, 100 * cost.cpu / cost.seconds);
    return bench_keys(words, title, 8);
}

int main(int count, char **arguments)
{
    const double seconds = count > 1 ? atof(arguments[1]) : 10;
    Cost cost;
    if (measure_running("mode1", 1, seconds, &cost) != 0) {
        fputs("bench_screen: the program did not run\n", stderr);
        return 1;
    }
    printf("moving picture, mode1 at 80x24 for %.0f s: %.1f frames a second, %.2f %% of a core,\n"
           "%.0f bytes and %.2f pieces a frame (aims: 30 frames, below 2 %% and 1000 bytes)\n",
           cost.seconds, (double)cost.frames / cost.seconds, 100 * cost.cpu / cost.seconds,
           (double)cost.bytes / (double)cost.frames, (double)cost.pieces / (double)cost.frames);
    return bench_keys("notched-beam", "the notched beam", 1.5) ||
           bench_large("probe:broken_bonds", seconds) || bench_large("cracks", seconds);
}

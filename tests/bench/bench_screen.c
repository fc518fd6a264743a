/* What the moving picture costs: share of a core, bytes and writes for each frame of mode1 at 80x24, measured
 * on the real program in a pseudo terminal.
 *
 * Usage: bench_screen [SECONDS] */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
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

static pid_t start(int master, int slave, int frames)
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
    execl(program ? program : "./matvib", "matvib", "mode1", (char *)NULL);
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

static int measure(double seconds, Cost *cost)
{
    struct winsize size = {.ws_row = 24, .ws_col = 80};
    int master, slave, frames[2];
    if (openpty(&master, &slave, NULL, NULL, &size) != 0 || pipe(frames) != 0)
        return 1;
    fcntl(frames[0], F_SETFD, FD_CLOEXEC);
    pid_t child = start(master, slave, frames[1]);
    close(frames[1]);
    *cost = (Cost){0};
    double begin = now(), left;
    while ((left = begin + seconds - now()) > 0) {
        struct pollfd both[2] = {{.fd = master, .events = POLLIN}, {.fd = frames[0], .events = POLLIN}};
        if (poll(both, 2, (int)(1e3 * left) + 1) < 0 && errno != EINTR)
            break;
        if (both[0].revents & POLLIN) {
            char text[65536];
            ssize_t got = read(master, text, sizeof text);
            cost->bytes += got > 0 ? got : 0;
            cost->pieces++;
        }
        if (both[1].revents & POLLIN)
            cost->frames += count_lines(frames[0]);
        else if (both[1].revents)
            break;
    }
    cost->seconds = now() - begin;
    kill(child, SIGTERM);
    int status;
    struct rusage usage;
    if (wait4(child, &status, 0, &usage) != child)
        return 1;
    cost->cpu = cpu_of(&usage);
    close(master);
    close(slave);
    close(frames[0]);
    return cost->frames > 0 ? 0 : 1;
}

int main(int count, char **arguments)
{
    double seconds = count > 1 ? atof(arguments[1]) : 10;
    Cost cost;
    if (measure(seconds, &cost) != 0) {
        fputs("bench_screen: the program did not run\n", stderr);
        return 1;
    }
    printf("moving picture, mode1 at 80x24 for %.0f s: %.1f frames a second, %.2f %% of a core,\n"
           "%.0f bytes and %.2f pieces a frame\n",
           cost.seconds, (double)cost.frames / cost.seconds, 100 * cost.cpu / cost.seconds,
           (double)cost.bytes / (double)cost.frames, (double)cost.pieces / (double)cost.frames);
    return 0;
}

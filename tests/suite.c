/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "suite.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const char *source_path(const char *relative)
{
    static char path[4096];
    const char *top = getenv("MATVIB_SRCDIR");
    snprintf(path, sizeof path, "%s/%s", top ? top : ".", relative);
    return path;
}

/* Row by row, as comments of the TAP: too long for the message of a test. */
static void tell_difference(const char *is, const char *wanted)
{
    enum { MOST = 50 };
    for (int row = 0, told = 0; (*is || *wanted) && told < MOST; row++) {
        const int one = (int)strcspn(is, "\n"), other = (int)strcspn(wanted, "\n");
        if (one != other || strncmp(is, wanted, (size_t)one) != 0) {
            printf("# row %2d is        |%.*s|\n#        should be |%.*s|\n", row, one, is, other, wanted);
            told++;
        }
        is += one + (is[one] == '\n');
        wanted += other + (wanted[other] == '\n');
    }
    fflush(stdout);
}

void suite_compare(const char *relative, const char *text, const char *what)
{
    if (getenv("MATVIB_REGENERATE")) {
        FILE *file = fopen(source_path(relative), "w");
        ck_assert_msg(file != NULL, "%s cannot be written", relative);
        fputs(text, file);
        fclose(file);
        return;
    }
    FILE *file = fopen(source_path(relative), "r");
    ck_assert_msg(file != NULL, "%s is missing", relative);
    char *golden = NULL;
    size_t room = 0;
    if (getdelim(&golden, &room, '\0', file) < 0)
        ck_abort_msg("%s cannot be read", relative);
    fclose(file);
    const bool same = strcmp(text, golden) == 0;
    if (!same)
        tell_difference(text, golden);
    free(golden);
    ck_assert_msg(same, "%s (%s) differs", relative, what);
}

bool suite_wide(void)
{
    return getenv("MATVIB_WIDE") != NULL;
}

bool suite_long(void)
{
    return suite_wide() && getenv("MATVIB_LONG") != NULL;
}

bool suite_sanitized(void)
{
#ifdef MATVIB_SANITIZERS
    return true;
#else
    return false;
#endif
}

static bool forked;

void suite_fork(void)
{
    forked = true;
}

int main(int count, char **arguments)
{
    /* seconds: finds what hangs, and on a busy machine nothing else */
    setenv("CK_DEFAULT_TIMEOUT", "600", 0);
    const char *name = strrchr(arguments[0], '/');
    Suite *suite = suite_create(name ? name + 1 : arguments[0]);
    add_cases(suite);
    SRunner *runner = srunner_create(suite);
    if (!forked && !suite_wide() && !getenv("CK_FORK")) {
        enum { HOUR = 3600 };
        srunner_set_fork_status(runner, CK_NOFORK);
        alarm(HOUR); /* Check's time-outs are for processes of its own */
    }
    /* one word on the command line: told for people, that case alone */
    if (count > 1)
        srunner_run(runner, NULL, strcmp(arguments[1], "all") ? arguments[1] : NULL, CK_VERBOSE);
    else {
        srunner_set_tap(runner, "/dev/stdout");
        srunner_run_all(runner, CK_SILENT);
    }
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

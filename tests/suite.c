/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "suite.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *source_path(const char *relative)
{
    static char path[4096];
    const char *top = getenv("MATVIB_SRCDIR");
    snprintf(path, sizeof path, "%s/%s", top ? top : ".", relative);
    return path;
}

bool suite_wide(void)
{
    return getenv("MATVIB_WIDE") != NULL;
}

int main(int count, char **arguments)
{
    setenv("CK_DEFAULT_TIMEOUT", "600",
           0); /* seconds: finds what hangs, and on a busy machine nothing else */
    const char *name = strrchr(arguments[0], '/');
    Suite *suite = suite_create(name ? name + 1 : arguments[0]);
    add_cases(suite);
    SRunner *runner = srunner_create(suite);
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

/* Arguments in, exit status out: the only place that prints an error or exits. */
#include "cli/verify.h"

#include <stdio.h>
#include <string.h>

int main(int count, char **arguments)
{
    if (count > 1 && strcmp(arguments[1], "--version") == 0) {
        puts("matvib " PACKAGE_VERSION);
        return 0;
    }
    if (count > 1 && strcmp(arguments[1], "verify") == 0) {
        Status status = {0};
        int result = verify_main(count - 2, arguments + 2, stdout, &status);
        if (result != 0)
            fprintf(stderr, "matvib: %s\n", status.text);
        return result;
    }
    fputs("matvib: nothing to run yet\n", stderr);
    return 2;
}

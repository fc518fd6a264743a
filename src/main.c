/* Arguments in, exit status out: the only place that prints an error or exits. */
#include <stdio.h>
#include <string.h>

int main(int count, char **arguments)
{
    if (count > 1 && strcmp(arguments[1], "--version") == 0) {
        puts("matvib " PACKAGE_VERSION);
        return 0;
    }
    fputs("matvib: nothing to run yet\n", stderr);
    return 2;
}

#include "tui/laboratory.h"

#include "tui/loop.h"
#include "tui/script.h"

#include <locale.h>

int laboratory_main(const LaboratoryOptions *options, Status *status)
{
    /* names, widths and the character set are the user's; numbers have a point everywhere */
    setlocale(LC_ALL, "");
    setlocale(LC_NUMERIC, "C");
    return options->script ? script_run(options, status) : loop_run(options, status);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/describe.h"

#include "base/text.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Today in UTC, YYYY-MM-DD; SOURCE_DATE_EPOCH names another day, for those who want the same bytes again. */
static void read_date(char date[16])
{
    const char *given = getenv("SOURCE_DATE_EPOCH");
    long seconds;
    const time_t day = given && text_to_long(given, &seconds) ? (time_t)seconds : time(NULL);
    struct tm fields;
    if (!gmtime_r(&day, &fields) || strftime(date, 16, "%Y-%m-%d", &fields) == 0)
        strcpy(date, "1970-01-01");
}

bool describe_may_begin(const Options *options, const Crate *crate, Status *status)
{
    return !options->crate || crate_may_begin(crate, status);
}

bool describe(const Options *options, const Crate *crate, const Settings *settings, Status *status)
{
    char date[16];
    read_date(date);
    return !options->crate || crate_write(crate, settings, date, status);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any bytes as a number with units: refused with a reason, or finite; what is read is the same however it is
 * written again, and numbers without letters mean the same in every unit. */
#include "fuzz/fuzz.h"

#include "base/quantity.h"
#include "base/text.h"

#include <math.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const units[] = {"", "Pa", "kg/m^3", "m", "s", "steps", "J/m^2"};
    char text[256], shortest[NUMBER_TEXT_MAX], why[QUANTITY_WHY_MAX];
    if (size >= sizeof text)
        size = sizeof text - 1;
    memcpy(text, data, size);
    text[size] = '\0';
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        double value = NAN, again;
        memset(why, 'x', sizeof why);
        if (!quantity_read(text, units[i], &value, why)) {
            FUZZ_ASSERT(memchr(why, '\0', sizeof why) && why[0] && isnan(value));
            continue;
        }
        FUZZ_ASSERT(isfinite(value));
        text_shortest(shortest, value);
        FUZZ_ASSERT(quantity_read(shortest, units[i], &again, why) && again == value);
    }
    return 0;
}

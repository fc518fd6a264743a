/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers with arithmetic, prefixes and units: the right value to the last bit, and why not where there is
 * none. */
#include "base/quantity.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *text, *unit;
    double value;
} sound[] = {
    {"0.25", "m", 0.25},
    {" 1e-3 ", "", 1e-3},
    {"25/3", "", 25.0 / 3},
    {"2+3*4", "", 14},
    {"(2+3)*4", "", 20},
    {"2 - 3 - 4", "", -5},
    {"8/4/2", "", 1},
    {"-3^2", "", -9},
    {"-(1+1)^-2", "", -0.25},
    {"1e3*2", "", 2000},
    {"2 pi", "", 2 * 3.14159265358979323846},
    {"99.9 %", "", 0.999},
    {"5k", "", 5000},
    {"2.5 M", "", 2.5e6},
    {"70 GPa", "Pa", 70e9},
    {"70 kN/mm^2", "Pa", 70e9},
    {"34.48 GPa", "Pa", 34.48e9},
    {"5 mm", "m", 0.005},
    {"0.35mm", "m", 0.35e-3},
    {"5 mm + 2 cm", "m", 0.025},
    {"1/2 mm", "m", 0.5e-3},
    {"3 um", "m", 3e-6},
    {"3 \302\265m", "m", 3e-6},
    {"2.7 g/cm^3", "kg/m^3", 2700},
    {"2700 kg m^-3", "kg/m^3", 2700},
    {"74 us", "s", 74e-6},
    {"7 pm", "m", 7e-12},
    {"36 km/(3600 s)", "m/s", 10},
    {"100 J/m^2", "J/m^2", 100},
    {"2700 kg/m3", "kg/m^3", 2700},
    {"2.7 g/cm3", "kg/m^3", 2700},
    {"70 kN/mm2", "Pa", 70e9},
    {"9.81 m/s2", "m/s^2", 9.81},
    {"1/ms", "1/s", 1000},
    {"3 1/ms", "1/s", 3000},
    {"(1+1) 1/ms", "1/s", 2000},
    {"25 mm", "mm", 25}, /* a unit with a prefix of its own */
    {"2 m / (8 m)", "m", 0.25},
    {"2 * -3^2 + abs(1 - 3)", "", -16},
    {"6 mm / -2", "m", -0.003},
};

START_TEST(a_quantity_has_its_value)
{
    double value = NAN;
    char why[QUANTITY_WHY_MAX] = "";
    ck_assert_msg(quantity_read(sound[_i].text, sound[_i].unit, &value, why), "%s: %s", sound[_i].text, why);
    ck_assert_msg(value == sound[_i].value, "%s is %.17g, not %.17g", sound[_i].text, value, sound[_i].value);
}
END_TEST

static const char *const bad[][3] = {
    {"", "m", "is not a number"},
    {"abc", "m", "is not a number"},
    {"0x10", "", "cannot be read: no unit x10 here"},
    {"inf", "", "is not a number"},
    {"nan", "", "is not a number"},
    {"1 2", "", "is not a number"},
    {"5 mx", "m", "cannot be read: no unit mx here"},
    {"5 c", "m", "cannot be read: no unit c here"},
    {"2.7 t/m^3", "kg/m^3", "cannot be read: no unit t/m^3 here"},
    {"2.7 kg/ft3 (about)", "kg/m^3", "cannot be read: no unit ft3 here"},
    {"1 kHz", "1/s", "cannot be read: no unit kHz here"},
    {"3 furlongs", "m", "cannot be read: no unit furlongs here"},
    {"3 "
     "\303\245\303\245\303\245\303\245\303\245\303\245\303\245\303\245\303\245\303\245\303\245\303\245\303"
     "\245\303\245\303\245\303\245",
     "m",
     "cannot be read: no unit "
     "\303\245\303\245\303\245\303\245\303\245\303\245\303\245\303\245\303\245\303\245\303\245\303\245\303"
     "\245\303\245\303\245 here"},
    {"7m0" /* bytes that begin no character */
     "\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264"
     "\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264",
     "m",
     "cannot be read: no unit "
     "\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264\264"
     "\264\264\264\264\264\264 here"},
    {"t/m^3", "kg/m^3", "is not a number"},
    {"5 m22", "m", "has a power that is not a whole number up to 9"},
    {"5 k3", "", "is not a number"},
    {"2 1/3", "", "is not a number"},
    {"3 +", "", "is not a number"},
    {"1,5", "", "is not a number"},
    {"(1+2", "", "has a bracket that is not closed"},
    {"1+2)", "", "is not a number"},
    {"1/0", "", "divides by zero"},
    {"0^-1", "", "divides by zero"},
    {"2^0.5", "", "has a power that is not a whole number up to 9"},
    {"2^10", "", "has a power that is not a whole number up to 9"},
    {"5 s", "m", "is not in m"},
    {"5 Pa", "kg/m^3", "is not in kg/m^3"},
    {"5 + 2 mm", "m", "adds what has different units"},
    {"5 mm", "", "has a unit where none is known"},
    {"5 mm", "steps", "has a unit where none is known"},
    {"1e308*10", "", "is too large"},
    {"1e51", "", "is too large to compute with"},
    {"-1e308", "", "is too large to compute with"},
    {"1e-306", "", "is too small to compute with"},
    {"1e-40 mm^4", "m^4", "is too small to compute with"},
    {"1e200^9", "", "is too large"},
    {"(m^9)^9", "m", "is not a number"},
    {"((((((((((((((((((((((1))))))))))))))))))))))", "", "has too many brackets in each other (at most 20)"},
};

START_TEST(what_is_no_quantity_says_why)
{
    double value = 7;
    char why[QUANTITY_WHY_MAX] = "";
    ck_assert_msg(!quantity_read(bad[_i][0], bad[_i][1], &value, why), "%s is taken as %g", bad[_i][0],
                  value);
    ck_assert_str_eq(why, bad[_i][2]);
    ck_assert_double_eq(value, 7);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("quantity");
    tcase_add_loop_test(tcase, a_quantity_has_its_value, 0, sizeof sound / sizeof *sound);
    tcase_add_loop_test(tcase, what_is_no_quantity_says_why, 0, sizeof bad / sizeof *bad);
    suite_add_tcase(suite, tcase);
}

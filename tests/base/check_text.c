/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers survive the way through text; words are compared as a person would. */
#include "base/text.h"
#include "suite.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static void expect_text(double value, const char *text)
{
    char out[NUMBER_TEXT_MAX];
    text_shortest(out, value);
    ck_assert_str_eq(out, text);
}

START_TEST(shortest_is_what_a_person_would_write)
{
    expect_text(0.1, "0.1");
    expect_text(1e-7, "1e-7");
    expect_text(25, "25");
    expect_text(100000, "100000");
    expect_text(1e16, "1e16");
    expect_text(5e-324, "5e-324");
    expect_text(-0.06366459530600058, "-0.06366459530600058");
    expect_text(0, "0");
}
END_TEST

START_TEST(shortest_reads_back)
{
    uint64_t random = 88172645463325252u;
    for (int i = 0; i < 200000; i++) {
        random ^= random << 13, random ^= random >> 7, random ^= random << 17;
        double value;
        memcpy(&value, &random, sizeof value);
        if (!isfinite(value))
            continue;
        char out[NUMBER_TEXT_MAX];
        ck_assert_uint_lt(text_shortest(out, value), NUMBER_TEXT_MAX);
        ck_assert(strtod(out, NULL) == value);
    }
    char out[NUMBER_TEXT_MAX];
    text_shortest(out, -DBL_MAX);
    ck_assert(strtod(out, NULL) == -DBL_MAX);
}
END_TEST

START_TEST(only_whole_numbers_are_read)
{
    double value;
    ck_assert(text_to_double(" 1.5e-3 ", &value) && value == 1.5e-3);
    const char *bad[] = {"", " ", "1,5", "0x10", "nan", "inf", "1e999", "3 4", "1.2.3", "-"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        ck_assert_msg(!text_to_double(bad[i], &value), "\"%s\" was read as %g", bad[i], value);
    long whole;
    ck_assert(text_to_long("42", &whole) && whole == 42);
    ck_assert(!text_to_long("4.2", &whole) && !text_to_long("99999999999999999999", &whole));
}
END_TEST

START_TEST(distance_counts_edits)
{
    ck_assert_uint_eq(text_distance("usf", "usf"), 0);
    ck_assert_uint_eq(text_distance("lenght", "length"), 1);
    ck_assert_uint_eq(text_distance("mesh.cellsize", "mesh.cell_size"), 1);
    ck_assert_uint_eq(text_distance("", "abc"), 3);
}
END_TEST

/* A name from outside does nothing in a command that is pasted. */
START_TEST(words_are_quoted_for_a_shell)
{
    static const char *const words[][2] = {{"mode5", "mode5"},
                                           {"mesh.cell_size=0.5", "mesh.cell_size=0.5"},
                                           {"", "''"},
                                           {"my bar.ini", "'my bar.ini'"},
                                           {"a;rm b", "'a;rm b'"},
                                           {"$(id)`id`", "'$(id)`id`'"},
                                           {"it's", "'it'\\''s'"}};
    char text[40] = "";
    text_append_shell(text, sizeof text, words[_i][0]);
    ck_assert_str_eq(text, words[_i][1]);
}
END_TEST

START_TEST(symbols_are_spelled)
{
    static const char *const pairs[][2] = {
        {"Δε = Δt Σ N′v    σ ← σ + E Δε", "de = dt sum N'v    s <- s + E de"},
        {"ρ dv/dt = dσ/dx + ρ b", "rho dv/dt = ds/dx + rho b"},
        {"v = A φ(x) cos ωt, β = (n−½)π/L", "v = A phi(x) cos wt, beta = (n-1/2)pi/L"},
        {"ω² = 8EG/(ρδ²) Σ (w_m/m) sin²(mβΔx/2)", "w^2 = 8EG/(rho delta^2) sum (w_m/m) sin^2(m beta dx/2)"},
        {"s₀ = √(4πG₀/(9Eδ)) ≥ 2/√3", "s0 = sqrt(4 pi G0/(9E delta)) >= 2/sqrt 3"},
        {"f(i) = Σ »2« c G w s V (ξ+η)/|ξ+η|", "f(i) = sum >>2<< c G w s V (xi+eta)/|xi+eta|"},
        {"M_L⁻¹ M_C", "M_L^-1 M_C"},
        {"é stays", "é stays"},
        {"", ""},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        char out[80], little[8];
        text_to_ascii(pairs[i][0], out, sizeof out);
        ck_assert_str_eq(out, pairs[i][1]);
        text_to_ascii(pairs[i][0], little, sizeof little); /* what does not fit is left out whole */
        ck_assert(strncmp(little, out, strlen(little)) == 0);
    }
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *numbers = tcase_create("numbers");
    tcase_add_test(numbers, shortest_is_what_a_person_would_write);
    tcase_add_test(numbers, shortest_reads_back);
    tcase_add_test(numbers, only_whole_numbers_are_read);
    suite_add_tcase(suite, numbers);
    TCase *words = tcase_create("words");
    tcase_add_test(words, distance_counts_edits);
    tcase_add_test(words, symbols_are_spelled);
    tcase_add_loop_test(words, words_are_quoted_for_a_shell, 0, 7);
    suite_add_tcase(suite, words);
}

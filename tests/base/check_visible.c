/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Text from outside is shown, never obeyed: control bytes, what turns the direction, what has no width. */
#include "base/status.h"
#include "base/visible.h"
#include "suite.h"

#include <stdlib.h>
#include <string.h>

static const struct {
    const char *text, *shown;
} hiding[] = {
    {"\x1b[2J", "\\x1b[2J"},
    {"a\nb\r\t\x7f", "a\\x0ab\\x0d\\x09\\x7f"},
    {"\xc2\x9b"
     "31m",
     "\\u009b31m"}, /* CSI as one character of the upper half */
    {"\x9b"
     "31m",
     "\\x9b31m"}, /* and as a byte */
    {"\xe2\x80\xae"
     "gpj.exe",
     "\\u202egpj.exe"},
    {"\xe2\x81\xa6\xe2\x81\xa9\xe2\x80\x8e\xe2\x80\x8f\xd8\x9c", "\\u2066\\u2069\\u200e\\u200f\\u061c"},
    {"a\xe2\x80\x8b\xe2\x80\x8c\xe2\x80\x8d\xe2\x81\xa0\xef\xbb\xbf"
     "b",
     "a\\u200b\\u200c\\u200d\\u2060\\ufeffb"},
    {"\xe2\x80\xa8\xe2\x80\xa9\xc2\xad", "\\u2028\\u2029\\u00ad"}, /* line ends; a hyphen that is none */
    {"\xf3\xa0\x81\x81", "\\U000e0041"},                           /* a tag */
    {"\xc3", "\\xc3"},                                             /* cut */
    {"\xc0\xaf", "\\xc0\\xaf"},                                    /* longer than need be */
    {"\xed\xa0\x80", "\\xed\\xa0\\x80"},                           /* half of a pair of UTF-16 */
    {"\xed\xbf\xbf", "\\xed\\xbf\\xbf"},                           /* the last of those */
    {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"},                  /* beyond Unicode */
    {"\xff\xfe", "\\xff\\xfe"},
};

START_TEST(what_acts_or_hides_is_written_out)
{
    char out[128];
    for (size_t i = 0; i < sizeof hiding / sizeof *hiding; i++) {
        ck_assert_uint_eq(visible_text(out, sizeof out, hiding[i].text), strlen(hiding[i].shown));
        ck_assert_str_eq(out, hiding[i].shown);
        ck_assert_msg(!visible_is_clean(hiding[i].text), "%s is taken for clean", hiding[i].shown);
        ck_assert_msg(visible_is_clean(out), "%s is not clean", out);
    }
}
END_TEST

START_TEST(what_is_text_stays)
{
    static const char *const clean[] = {"", "plain \\ text",
                                        "Stäbe, ω = 5.65 · 10³, ⠿ ▒ 日本 \xf0\x9f\x8e\xb8", "e\xcc\x81"};
    char out[128];
    for (size_t i = 0; i < sizeof clean / sizeof *clean; i++) {
        ck_assert(visible_is_clean(clean[i]));
        visible_text(out, sizeof out, clean[i]);
        ck_assert_str_eq(out, clean[i]);
    }
}
END_TEST

START_TEST(what_does_not_fit_is_left_out_whole)
{
    char out[8];
    for (size_t size = 1; size <= sizeof out; size++) {
        memset(out, '#', sizeof out);
        const size_t length = visible_text(out, size, "a\x1b\xc3\xa4z");
        ck_assert_uint_lt(length, size);
        ck_assert_uint_eq(strlen(out), length);
        ck_assert_uint_eq(length, size < 6 ? size > 1 : size < 8 ? 5 : 7);
    }
    ck_assert_uint_eq(visible_text(NULL, 0, "a"), 0);
}
END_TEST

START_TEST(an_error_shows_what_it_repeats)
{
    Status status = {STATUS_DONE, ""};
    status_refuse(&status, "%s: is a folder", "a\x1b[31m");
    status_prefix(&status, "%s", "b\xe2\x80\xae");
    ck_assert_str_eq(status.text, "b\\u202e: a\\x1b[31m: is a folder");
}
END_TEST

START_TEST(a_printed_line_stays_one)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    visible_print(stream, "matvib: %s\n", "x\nmatvib: all is well\r");
    visible_print(stream, "%s", "no end");
    fclose(stream);
    ck_assert_str_eq(text, "matvib: x\\x0amatvib: all is well\\x0d\nno end");
    free(text);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *door = tcase_create("visible");
    tcase_add_test(door, what_acts_or_hides_is_written_out);
    tcase_add_test(door, what_is_text_stays);
    tcase_add_test(door, what_does_not_fit_is_left_out_whole);
    tcase_add_test(door, an_error_shows_what_it_repeats);
    tcase_add_test(door, a_printed_line_stays_one);
    suite_add_tcase(suite, door);
}

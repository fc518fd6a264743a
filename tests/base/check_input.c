/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is read comes from a file, is opened without waiting and has bounds. */
#include "base/input.h"
#include "suite.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/matvib-input-XXXXXX";

static const char *in_folder(const char *name)
{
    static char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static void begin(void)
{
    strcpy(folder + strlen(folder) - 6, "XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
}

static void end(void)
{
    unlink(in_folder("file"));
    rmdir(folder);
}

static void refused(const char *name, const char *why, int number)
{
    Status status = {STATUS_DONE, ""};
    ck_assert_ptr_null(input_open(name, 10, &status));
    const int got = errno;
    ck_assert_int_eq(status.code, STATUS_USAGE);
    ck_assert_msg(strncmp(status.text, name, strlen(name)) == 0 &&
                      strcmp(status.text + strlen(name), why) == 0,
                  "%s", status.text);
    ck_assert_int_eq(got, number);
}

START_TEST(what_is_no_file_is_refused_at_once)
{
    refused(in_folder("none"), ": cannot be read: No such file or directory", ENOENT);
    refused(folder, ": cannot be read: Is a directory", EISDIR);
    refused("/dev/zero", ": is a pipe or a device (a file is expected)", 0);
    ck_assert_int_eq(mkfifo(in_folder("file"), 0600), 0);
    refused(in_folder("file"), ": is a pipe or a device (a file is expected)", 0); /* nobody writes to it */
}
END_TEST

START_TEST(a_file_has_a_size)
{
    Status status = {STATUS_DONE, ""};
    FILE *file = fopen(in_folder("file"), "w");
    fputs("123456789\n", file);
    fclose(file);
    file = input_open(in_folder("file"), 10, &status);
    ck_assert_msg(file != NULL, "%s", status.text);
    ck_assert_msg((fcntl(fileno(file), F_GETFL) & O_NONBLOCK) == 0, "reading may fail for want of bytes");
    fclose(file);
    ck_assert_int_eq(truncate(in_folder("file"), 11), 0);
    refused(in_folder("file"), ": is too large (at most 0 kB)", 0);
}
END_TEST

static InputLines lines;

static InputGot next(char line[8], Status *status)
{
    return input_line(&lines, line, 8, status);
}

static void open_text(const char *text, size_t size)
{
    lines = (InputLines){.stream = fmemopen((void *)text, size, "r"), .name = "f"};
}

START_TEST(lines_come_without_their_ends)
{
    char line[8];
    open_text("one\r\n\n1234567\nlast", 18);
    ck_assert_int_eq(next(line, NULL), INPUT_LINE);
    ck_assert_str_eq(line, "one");
    ck_assert_int_eq(next(line, NULL), INPUT_LINE);
    ck_assert_str_eq(line, "");
    ck_assert_int_eq(lines.number, 2);
    ck_assert_int_eq(next(line, NULL), INPUT_LINE);
    ck_assert_str_eq(line, "1234567");
    ck_assert(!lines.cut);
    ck_assert_int_eq(next(line, NULL), INPUT_LINE);
    ck_assert_str_eq(line, "last");
    ck_assert(lines.cut);
    ck_assert_int_eq(lines.number, 4);
    ck_assert_int_eq(next(line, NULL), INPUT_END);
    fclose(lines.stream);
}
END_TEST

START_TEST(lines_have_a_length)
{
    char line[8];
    Status status = {STATUS_DONE, ""};
    open_text("a\n12345678\n", 11);
    ck_assert_int_eq(next(line, &status), INPUT_LINE);
    ck_assert_int_eq(next(line, &status), INPUT_WRONG);
    ck_assert_str_eq(status.text, "f:2: the line is too long (at most 7 bytes)");
    ck_assert_int_eq(status.code, STATUS_USAGE);
    fclose(lines.stream);
    open_text("a\0b\n", 4);
    ck_assert_int_eq(next(line, &status), INPUT_WRONG);
    ck_assert_str_eq(status.text, "f:1: holds a zero byte (text is expected)");
    fclose(lines.stream);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *files = tcase_create("input");
    tcase_add_checked_fixture(files, begin, end);
    tcase_add_test(files, what_is_no_file_is_refused_at_once);
    tcase_add_test(files, a_file_has_a_size);
    tcase_add_test(files, lines_come_without_their_ends);
    tcase_add_test(files, lines_have_a_length);
    suite_add_tcase(suite, files);
}

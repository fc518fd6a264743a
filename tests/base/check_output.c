/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The gate for writing: who may, what stands there while and after, and that it reaches the disk. fsync() is
 * this program's own, so that it is seen what is brought to the disk and when. */
#include "base/output.h"
#include "suite.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#include <utime.h>

static int synced_files, synced_folders;

int fsync(int descriptor)
{
    struct stat what;
    ck_assert_int_eq(fstat(descriptor, &what), 0);
    synced_files += S_ISREG(what.st_mode);
    synced_folders += S_ISDIR(what.st_mode);
    return 0;
}

static char folder[64];
static Status status;

/* In turns one of three, so that two names can be used at once. */
static const char *in_folder(const char *name)
{
    static char paths[3][512];
    static int turn;
    turn = (turn + 1) % 3;
    snprintf(paths[turn], sizeof paths[turn], "%s/%s", folder, name);
    return paths[turn];
}

static void begin(void)
{
    strcpy(folder, "/tmp/matvib-output-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
    status = (Status){STATUS_DONE, ""};
    synced_files = synced_folders = 0;
    umask(022);
}

static void end(void)
{
    char command[128];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    ck_assert_int_eq(system(command), 0);
}

static void put(const char *name, const char *text)
{
    FILE *file = fopen(name, "w");
    ck_assert_ptr_nonnull(file);
    fputs(text, file);
    fclose(file);
}

static void expect_text(const char *name, const char *text)
{
    char line[64] = "";
    FILE *file = fopen(name, "r");
    ck_assert_msg(file != NULL, "%s is not there", name);
    ck_assert(fgets(line, sizeof line, file) || !*text);
    fclose(file);
    ck_assert_str_eq(line, text);
}

static mode_t rights_of(const char *name)
{
    struct stat what;
    ck_assert_int_eq(lstat(name, &what), 0);
    return what.st_mode & 07777;
}

static bool write_file(Asker asker, const char *name, bool force)
{
    OutputFile file;
    if (!output_open(&file, asker, name, force, &status))
        return false;
    fputs("new", file.stream);
    const bool done = output_finish(&file, &status) && output_commit(&file, &status);
    output_close(&file);
    return done;
}

static void expect_refused(const char *name, bool force, const char *why)
{
    ck_assert(!write_file(ASKER_COMMAND_LINE, name, force));
    ck_assert_msg(strstr(status.text, why) != NULL, "%s", status.text);
}

/* Nobody was asked about a name on the command line; a person was. */
START_TEST(what_is_foreign_stays)
{
    put(in_folder("old"), "old");
    expect_refused(in_folder("old"), true, "was not written by matvib");
    expect_text(in_folder("old"), "old");
    ck_assert(write_file(ASKER_KEYBOARD, in_folder("old"), true));
    expect_text(in_folder("old"), "new");
}
END_TEST

START_TEST(who_asks_decides)
{
    static const struct {
        Asker asker;
        bool may;
    } askers[] = {
        {ASKER_NOBODY, false}, {ASKER_KEYBOARD, true}, {ASKER_COMMAND_LINE, true},
        {ASKER_SCRIPT, true},  {ASKER_REPLAY, false},  {ASKER_LESSON, false},
    };
    for (size_t i = 0; i < sizeof askers / sizeof *askers; i++) {
        const Asker asker = askers[i].asker;
        const bool may = askers[i].may;
        OutputFile file;
        put(in_folder("old"), "step,time");
        ck_assert_int_eq(write_file(asker, in_folder("old"), true), may);
        expect_text(in_folder("old"), may ? "new" : "step,time");
        ck_assert_int_eq(output_open(&file, asker, "-", true, &status), may);
        output_close(&file);
        ck_assert_int_eq(output_open_own(&file, asker, in_folder("own"), &status), may);
        output_close(&file);
        output_make_own_folders(asker, in_folder("state/matvib/file"));
        ck_assert_int_eq(access(in_folder("state"), F_OK) == 0, may);
        rmdir(in_folder("state/matvib"));
        rmdir(in_folder("state"));
    }
}
END_TEST

START_TEST(file_and_folder_reach_the_disk)
{
    OutputFile file;
    for (int force = 0; force < 2; force++) { /* a new name, and one that is taken over */
        synced_files = synced_folders = 0;
        ck_assert(output_open(&file, ASKER_KEYBOARD, in_folder("a"), force, &status));
        fputs("new", file.stream);
        ck_assert_int_eq(access(in_folder("a"), F_OK) == 0, force);
        ck_assert(output_finish(&file, &status));
        ck_assert_int_eq(synced_files, 1);
        ck_assert(output_commit(&file, &status));
        ck_assert_int_eq(synced_folders, 1);
        output_close(&file);
        expect_text(in_folder("a"), "new");
    }
}
END_TEST

START_TEST(a_published_file_takes_more)
{
    OutputFile file;
    ck_assert(output_open(&file, ASKER_KEYBOARD, in_folder("a"), false, &status));
    fputs("head", file.stream);
    ck_assert(output_publish(&file, &status));
    ck_assert_int_eq(synced_files + synced_folders, 2);
    expect_text(in_folder("a"), "head");
    fputs(", line", file.stream);
    ck_assert(output_finish(&file, &status) && output_commit(&file, &status));
    ck_assert_int_eq(synced_files, 2);
    output_close(&file);
    expect_text(in_folder("a"), "head, line");
}
END_TEST

START_TEST(what_is_replaced_keeps_its_rights)
{
    put(in_folder("a"), "old");
    ck_assert_int_eq(chmod(in_folder("a"), 0640), 0);
    ck_assert(write_file(ASKER_KEYBOARD, in_folder("a"), true));
    ck_assert_int_eq(rights_of(in_folder("a")), 0640);
    ck_assert(write_file(ASKER_KEYBOARD, in_folder("b"), false));
    ck_assert_int_eq(rights_of(in_folder("b")), 0644);
}
END_TEST

START_TEST(names_are_judged_before_anything_is_done)
{
    ck_assert_int_eq(symlink("/nowhere/at-all", in_folder("link")), 0);
    expect_refused(in_folder("link"), false, ": is a link that leads nowhere");
    expect_refused(in_folder("link"), true, ": is a link that leads nowhere");
    ck_assert_int_eq(status.code, STATUS_USAGE);
    expect_refused(in_folder("\x1b[2J"), false, "/\\x1b[2J: not a file name");
    expect_refused(in_folder("\xc2\x9b"), false, "/\\u009b: not a file name");
    expect_refused(in_folder("\xe2\x80\xaegpj"), false, "/\\u202egpj: not a file name");
}
END_TEST

START_TEST(a_name_may_be_as_long_as_names_are)
{
    char name[256];
    for (int length = 200; length < 256; length++) {
        memset(name, 'a', sizeof name);
        name[length] = '\0';
        ck_assert_msg(write_file(ASKER_KEYBOARD, in_folder(name), false), "%d: %s", length, status.text);
        expect_text(in_folder(name), "new");
    }
}
END_TEST

START_TEST(a_link_of_our_own_is_replaced_and_not_followed)
{
    OutputFile file;
    put(in_folder("diary"), "dear diary");
    ck_assert_int_eq(symlink("diary", in_folder("last")), 0);
    ck_assert(output_open_own(&file, ASKER_COMMAND_LINE, in_folder("last"), &status));
    fputs("keys", file.stream);
    ck_assert(output_finish(&file, &status) && output_commit(&file, &status));
    output_close(&file);
    expect_text(in_folder("diary"), "dear diary");
    expect_text(in_folder("last"), "keys");
    ck_assert_int_eq(rights_of(in_folder("last")), 0600);
}
END_TEST

START_TEST(what_is_kept_is_for_the_user_alone)
{
    output_make_own_folders(ASKER_COMMAND_LINE, in_folder("state/matvib/lessons"));
    ck_assert_int_eq(rights_of(in_folder("state/matvib")), 0700);
    ck_assert_int_eq(rights_of(in_folder("state")), 0700);
    ck_assert_int_eq(chmod(in_folder("state/matvib"), 0777), 0);
    ck_assert_int_eq(chmod(in_folder("state"), 0755), 0);
    output_make_own_folders(ASKER_COMMAND_LINE, in_folder("state/matvib/lessons"));
    ck_assert_int_eq(rights_of(in_folder("state/matvib")), 0700);
    ck_assert_int_eq(rights_of(in_folder("state")), 0755); /* is not ours alone */
}
END_TEST

static void leave_part(const char *target, long process, long age)
{
    char name[300];
    snprintf(name, sizeof name, "%s.%ld-0.part", target, process);
    put(in_folder(name), "half");
    const time_t then = time(NULL) - age;
    ck_assert_int_eq(utime(in_folder(name), &(struct utimbuf){then, then}), 0);
}

START_TEST(only_what_the_dead_left_is_removed)
{
    enum { NOBODY = 99999999 }; /* more than a system gives */
    char mine[64], longest[256], of_longest[256];
    memset(longest, 'a', 255);
    longest[255] = '\0';
    snprintf(mine, sizeof mine, "t.%ld-0.part", (long)getpid());
    snprintf(of_longest, sizeof of_longest, "%.223s.%d-0.part", longest, NOBODY);
    leave_part("t", getpid(), 3600);
    leave_part("t", 1, 3600); /* another's, that always lives */
    leave_part("t", NOBODY, 3600);
    leave_part("u", NOBODY, 3600);
    output_remove_remains(in_folder("t"));
    ck_assert_msg(access(in_folder(mine), F_OK) == 0, "that of a living process is removed");
    ck_assert_msg(access(in_folder("t.1-0.part"), F_OK) == 0, "that of another living process is removed");
    ck_assert_int_ne(access(in_folder("t.99999999-0.part"), F_OK), 0);
    ck_assert_int_eq(access(in_folder("u.99999999-0.part"), F_OK), 0);
    leave_part("t", NOBODY, 0);
    output_remove_remains(in_folder("t"));
    ck_assert_int_eq(access(in_folder("t.99999999-0.part"), F_OK), 0); /* too young to be judged */
    put(in_folder(of_longest), "half");
    ck_assert_int_eq(utime(in_folder(of_longest), &(struct utimbuf){1, 1}), 0);
    output_remove_remains(in_folder(longest));
    ck_assert_int_ne(access(in_folder(of_longest), F_OK), 0);
}
END_TEST

START_TEST(a_keyboard_does_not_wait_for_a_reader)
{
    OutputFile file;
    ck_assert_int_eq(mkfifo(in_folder("pipe"), 0600), 0);
    ck_assert(!output_open(&file, ASKER_KEYBOARD, in_folder("pipe"), true, &status));
    ck_assert_ptr_nonnull(strstr(status.text, ": cannot be written: "));
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *gate = tcase_create("output");
    tcase_add_checked_fixture(gate, begin, end);
    tcase_add_test(gate, who_asks_decides);
    tcase_add_test(gate, what_is_foreign_stays);
    tcase_add_test(gate, file_and_folder_reach_the_disk);
    tcase_add_test(gate, a_published_file_takes_more);
    tcase_add_test(gate, what_is_replaced_keeps_its_rights);
    tcase_add_test(gate, names_are_judged_before_anything_is_done);
    tcase_add_test(gate, a_name_may_be_as_long_as_names_are);
    tcase_add_test(gate, a_link_of_our_own_is_replaced_and_not_followed);
    tcase_add_test(gate, what_is_kept_is_for_the_user_alone);
    tcase_add_test(gate, only_what_the_dead_left_is_removed);
    tcase_add_test(gate, a_keyboard_does_not_wait_for_a_reader);
    suite_add_tcase(suite, gate);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Films hold what the screen showed: a .cast played to a terminal, the pictures of a GIF counted and
 * measured. Both against what a script prints of the same keys. */
#include "suite.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <vterm.h>

#if defined HAVE_CAIRO && defined HAVE_GIF
#include <gif_lib.h>
#endif

enum { WIDTH = 80, HEIGHT = 24, LINE = 1 << 20 };

static char folder[] = "/tmp/matvib-film-XXXXXX";

static void enter_folder(void)
{
    strcpy(folder + strlen(folder) - 6, "XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
}

static void leave_folder(void)
{
    static const char *const files[] = {"keys.script", "screen.txt", "film.cast", "film.gif"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        remove(files[i]);
    ck_assert_int_eq(chdir("/"), 0);
    ck_assert_int_eq(rmdir(folder), 0);
}

static void write_script(const char *text)
{
    FILE *file = fopen("keys.script", "w");
    ck_assert_ptr_nonnull(file);
    fputs(text, file);
    fclose(file);
}

static void run_program(const char *arguments)
{
    char command[1024];
    const char *program = getenv("MATVIB");
    snprintf(command, sizeof command, "LC_ALL=C.UTF-8 %s %s", program ? program : "./matvib", arguments);
    ck_assert_msg(system(command) == 0, "%s", command);
}

/* The text between the quotes at `from` as bytes; the number of them. */
static size_t unquote(const char *from, char *bytes)
{
    size_t count = 0;
    unsigned code;
    for (; *from != '"'; from++) {
        ck_assert_int_ne(*from, '\0');
        if (*from != '\\')
            bytes[count++] = *from;
        else if (*++from != 'u')
            bytes[count++] = *from;
        else {
            ck_assert_int_eq(sscanf(from + 1, "%4x", &code), 1);
            bytes[count++] = (char)code;
            from += 4;
        }
    }
    return count;
}

/* Plays a recording to a terminal. Returns the pictures in it; *seconds is its length. */
static int play_cast(const char *name, VTerm *vterm, double *seconds)
{
    FILE *file = fopen(name, "r");
    char *line = malloc(LINE), *bytes = malloc(LINE);
    int pictures = 0, width = 0, height = 0;
    ck_assert(file && line && bytes && fgets(line, LINE, file));
    ck_assert_int_eq(sscanf(line, "{\"version\": 2, \"width\": %d, \"height\": %d", &width, &height), 2);
    ck_assert_int_eq(width, WIDTH);
    ck_assert_int_eq(height, HEIGHT);
    for (double last = 0; fgets(line, LINE, file); last = *seconds) {
        ck_assert_int_eq(sscanf(line, "[%lf, \"o\", ", seconds), 1);
        ck_assert_double_ge(*seconds, last);
        const size_t count = unquote(strstr(line, "\"o\", \"") + 6, bytes);
        vterm_input_write(vterm, bytes, count);
        pictures += count > 0;
    }
    fclose(file);
    free(line);
    free(bytes);
    return pictures;
}

static void read_row(VTermScreen *screen, int row, char *text, size_t size)
{
    const VTermRect rect = {row, row + 1, 0, WIDTH};
    size_t length = vterm_screen_get_text(screen, text, size - 1, rect);
    while (length > 0 && text[length - 1] == ' ')
        length--;
    text[length] = '\0';
}

static void compare_with_script(VTermScreen *screen)
{
    FILE *printed = fopen("screen.txt", "r");
    char wanted[1024], shown[1024];
    ck_assert_ptr_nonnull(printed);
    for (int row = 0; row < HEIGHT; row++) {
        ck_assert_ptr_nonnull(fgets(wanted, sizeof wanted, printed));
        wanted[strcspn(wanted, "\n")] = '\0';
        read_row(screen, row, shown, sizeof shown);
        ck_assert_str_eq(shown, wanted);
    }
    fclose(printed);
}

static const char keys[] =
    "wait 1\nkey Space\nkey ]\nkey ]\ntype :#40\nkey Enter\nwait 1\ntype :\\\"\nscreen\n";

START_TEST(cast_equals_the_scripts_screen)
{
    double seconds = 0;
    VTerm *vterm = vterm_new(HEIGHT, WIDTH);
    vterm_set_utf8(vterm, 1);
    VTermScreen *screen = vterm_obtain_screen(vterm);
    vterm_screen_enable_altscreen(screen, 1);
    vterm_screen_reset(screen, 1);
    write_script(keys);
    run_program("mode5 --script keys.script >screen.txt");
    run_program("movie keys.script --output film.cast >/dev/null");
    ck_assert_int_gt(play_cast("film.cast", vterm, &seconds), 10);
    compare_with_script(screen);
    /* two seconds of waiting, four keys, six letters, and the last picture stands for two */
    ck_assert_double_eq_tol(seconds, 2 + 4 * 0.5 + 6 * 0.12 + 2, 0.2);
    vterm_free(vterm);
}
END_TEST

#if defined HAVE_CAIRO && defined HAVE_GIF

START_TEST(gif_has_the_pictures_of_the_cast)
{
    double seconds = 0;
    int error = 0;
    long hundredths = 0;
    VTerm *vterm = vterm_new(HEIGHT, WIDTH);
    write_script(keys);
    run_program("movie keys.script --fps 8 --output film.cast >/dev/null");
    run_program("movie keys.script --fps 8 --output film.gif >/dev/null");
    const int pictures = play_cast("film.cast", vterm, &seconds);
    GifFileType *gif = DGifOpenFileName("film.gif", &error);
    ck_assert_ptr_nonnull(gif);
    ck_assert_int_eq(DGifSlurp(gif), GIF_OK);
    ck_assert_int_eq(gif->SWidth, 8 * WIDTH);
    ck_assert_int_eq(gif->SHeight, 17 * HEIGHT);
    ck_assert_int_eq(gif->ImageCount, pictures);
    for (int i = 0; i < gif->ImageCount; i++) {
        GraphicsControlBlock block;
        const GifImageDesc *image = &gif->SavedImages[i].ImageDesc;
        ck_assert_int_eq(DGifSavedExtensionToGCB(gif, i, &block), GIF_OK);
        hundredths += block.DelayTime;
        ck_assert_int_le(image->Left + image->Width, gif->SWidth);
        ck_assert_int_le(image->Top + image->Height, gif->SHeight);
        ck_assert(i > 0 || (image->Width == gif->SWidth && image->Height == gif->SHeight));
    }
    ck_assert_double_eq_tol((double)hundredths / 100, seconds, 0.011);
    DGifCloseFile(gif, &error);
    vterm_free(vterm);
}
END_TEST

#endif

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("film");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, cast_equals_the_scripts_screen);
#if defined HAVE_CAIRO && defined HAVE_GIF
    tcase_add_test(tcase, gif_has_the_pictures_of_the_cast);
#endif
    suite_add_tcase(suite, tcase);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The variants of a lesson: a student's values, set by its pages and told in its texts (lesson.h). */
#include "lessons/lesson.h"

#include "base/assertion.h"
#include "base/text.h"
#include "scenario/parameters.h"

#include <stdlib.h>
#include <string.h>

/* "{mesh.cell_size}": the length of what stands between the braces; 0: no parameter does. */
static size_t braced_key(const char *text, char key[KEY_MAX])
{
    const size_t length = *text == '{' ? strcspn(text + 1, "} ") : 0;
    if (length == 0 || length >= KEY_MAX || text[1 + length] != '}')
        return 0;
    snprintf(key, KEY_MAX, "%.*s", (int)length, text + 1);
    return parameter_find(key) ? length : 0;
}

const LessonVariant *lesson_variant(const Lesson *lesson, const char *key, int page)
{
    ASSERT_INT(page, >=, 0);
    for (int i = lesson->n_variants - 1; i >= 0; i--)
        if (lesson->variants[i].page <= page && strcmp(lesson->variants[i].variant.key, key) == 0)
            return &lesson->variants[i];
    return NULL;
}

bool lesson_knows_braces(const Lesson *lesson, const char *line, Status *status)
{
    char key[KEY_MAX];
    for (; (line = strchr(line, '{')); line++)
        if (braced_key(line, key) && !lesson_variant(lesson, key, lesson->n_pages))
            return status_refuse(status, "{%s}: there is no @variant of it above", key);
    return true;
}

/* Which choice is the right one for whom a word was drawn. */
static void choose(const Lesson *lesson, LessonPage *page)
{
    const LessonVariant *variant =
        *page->if_key ? lesson_variant(lesson, page->if_key, (int)(page - lesson->pages)) : NULL;
    for (int i = 0; variant && i < page->n_choices; i++)
        if (page->if_words[i] && variant_has_word(page->if_words[i], variant_word(variant->value)))
            page->right = i;
}

/* Puts the values in the place of their keys. */
static bool fill_in(const Lesson *lesson, int page, char **text, Status *status)
{
    char *filled = NULL, key[KEY_MAX];
    size_t size = 0, length;
    if (!*text || !strchr(*text, '{'))
        return true;
    FILE *stream = open_memstream(&filled, &size);
    if (!stream)
        return status_fail(status, "not enough memory for a lesson");
    for (const char *c = *text; *c; c++) {
        const LessonVariant *variant =
            (length = braced_key(c, key)) > 0 ? lesson_variant(lesson, key, page) : NULL;
        if (variant) {
            fputs(variant->variant.concealed ? "?" : variant->value, stream);
            c += length + 1;
        } else {
            fputc(*c, stream);
        }
    }
    if (!text_stream_close(stream, &filled)) {
        free(filled);
        return status_fail(status, "not enough memory for a lesson");
    }
    free(*text);
    *text = filled;
    return true;
}

static bool set_variant(Lesson *lesson, LessonVariant *variant, const char *student, Status *status)
{
    char **line = &lesson->pages[variant->page].first.actions[variant->action];
    variant_draw(&variant->variant, lesson->title, student, variant->value);
    free(*line);
    if (asprintf(line, "set %s %s", variant->variant.key, variant->value) >= 0)
        return true;
    *line = NULL;
    return status_fail(status, "not enough memory for a lesson");
}

bool lesson_draw(Lesson *lesson, const char *student, Status *status)
{
    bool sound = true;
    for (int i = 0; i < lesson->n_variants && sound; i++)
        sound = set_variant(lesson, &lesson->variants[i], student, status);
    for (int i = 0; i < lesson->n_pages && sound; i++) {
        LessonPage *page = &lesson->pages[i];
        sound = fill_in(lesson, i, &page->first.text, status) &&
                fill_in(lesson, i, &page->revealed.text, status) &&
                fill_in(lesson, i, &page->question, status);
        choose(lesson, page);
        for (int k = 0; k < page->n_choices && sound; k++)
            sound = fill_in(lesson, i, &page->choices[k], status);
    }
    return sound;
}

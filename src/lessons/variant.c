/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws values from names (variant.h). */
#include "lessons/lesson.h"
#include "base/assertion.h"
#include "lessons/variant.h"
#include "base/text.h"

#include "base/hash.h"
#include "base/math/functions.h"
#include "base/visible.h"
#include "scenario/parameters.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#ifdef HAVE_UTF8PROC
#include <utf8proc.h>
#endif

enum { VALUES_MOST = 50 };

static bool is_allowed(const Parameter *parameter, double value)
{
    return value >= parameter->least && value <= parameter->most &&
           !(parameter->above_least && value == parameter->least);
}

/* All bits of a hash matter for its remainder (the finish of splitmix64, S. Vigna, public domain). */
static uint64_t mix(uint64_t hash)
{
    hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ hash >> 27) * 0x94d049bb133111ebu;
    return hash ^ hash >> 31;
}

const char *variant_word(const char *value)
{
    return value + (*value == '?');
}

/* The words behind "KEY from"; of mistakes none but mistakes. */
static bool read_words(const char *list, const Parameter *parameter, Variant *variant, Status *status)
{
    char item[KEY_MAX];
    variant->concealed = parameter->wrong;
    while (text_next_item(&list, item, sizeof item)) {
        const int choice = text_place_in(item, parameter->choices);
        if (choice < 0 || (parameter->wrong && choice == 0))
            return status_refuse(status, "%s: %s is none of its words (see: matvib params)", variant->key,
                                 item);
        if (text_place_in(item, variant->words) >= 0)
            return status_refuse(status, "%s: %s listed twice", variant->key, item);
        if (variant->n_words == VARIANT_WORDS_MAX)
            return status_refuse(status, "%s: too many words (at most %d)", variant->key, VARIANT_WORDS_MAX);
        variant->words[variant->n_words++] = parameter->choices[choice];
    }
    return variant->n_words >= 2 ||
           status_refuse(status, "%s: two words at least are expected to draw from", variant->key);
}

bool variant_read(const char *text, Variant *variant, Status *status)
{
    int words = 0;
    *variant = (Variant){.from = NAN};
    if (sscanf(text, "%39s from %n", variant->key, &words) == 1 && words > 0) {
        const Parameter *choice = parameter_find(variant->key);
        if (choice && choice->type == PARAMETER_CHOICE)
            return read_words(text + words, choice, variant, status);
    }
    char from[NUMBER_TEXT_MAX], to[NUMBER_TEXT_MAX], more;
    *variant = (Variant){.from = NAN};
    if (sscanf(text, "%39s from %31s to %31s %c", variant->key, from, to, &more) != 3 ||
        !text_to_double(from, &variant->from) || !text_to_double(to, &variant->to))
        return status_refuse(status, "\"%.60s\" is not a variant (KEY from A to B, KEY from WORD, WORD ...)",
                             text);
    const Parameter *parameter = parameter_find(variant->key);
    if (!parameter)
        return status_refuse(status, "%s is not a parameter (see: matvib params)", variant->key);
    if (parameter->type != PARAMETER_REAL && parameter->type != PARAMETER_INTEGER)
        return status_refuse(status, "%s has no numbers to draw from", variant->key);
    variant->whole = parameter->type == PARAMETER_INTEGER;
    const double range = variant->to - variant->from;
    if (!(range > 0) || !(range >= 1e-9 * fmax(fabs(variant->from), fabs(variant->to))) ||
        fabs(variant->from) > 1e100 || fabs(variant->to) > 1e100 || range < 1e-100 ||
        (variant->whole && (range < 1 || variant->from != floor(variant->from))))
        return status_refuse(status, "%s: nothing lies between %s and %s (the smaller one first)",
                             variant->key, from, to);
    return (is_allowed(parameter, variant->from) && is_allowed(parameter, variant->to)) ||
           status_refuse(status, "%s: from %s to %s is more than is allowed (see: matvib params)",
                         variant->key, from, to);
}

/* The values that there are: whole numbers of steps, from the first to the last. */
typedef struct Values {
    int mantissa, exponent;
    double step, first, last;
} Values;

/* The distance of neighbours is 1, 2 or 5 times a power of ten: mantissa x 10^exponent, the finest with which
 * there are not more than VALUES_MOST. */
static Values values_of(const Variant *variant)
{
    static const int mantissas[] = {1, 2, 5};
    const double range = variant->to - variant->from;
    const int first = (int)floor(math_log10(range / VALUES_MOST)) - 1;
    Values values;
    int i = variant->whole && first < 0 ? -3 * first : 0;
    do {
        values.mantissa = mantissas[i % 3];
        values.exponent = first + i++ / 3;
        values.step = values.mantissa * math_pow(10, values.exponent);
    } while (range / values.step > VALUES_MOST - 1 + 1e-6);
    values.first = ceil(variant->from / values.step - 1e-6);
    values.last = floor(variant->to / values.step + 1e-6);
    return values;
}

/* Written as a whole number of steps, so that no rounding of a product is in it. */
static void write_value(const Values *values, double steps, char out[NUMBER_TEXT_MAX])
{
    char text[NUMBER_TEXT_MAX];
    snprintf(text, sizeof text, "%.0fe%d", steps * values->mantissa, values->exponent);
    enum { DIGITS = 6 }; /* more than most have; 8.5e10 is read better than 85000000000 */
    const double value = strtod(text, NULL);
    strcpy(out, text_rounded(value, DIGITS).text);
    if (strtod(out, NULL) != value)
        text_shortest(out, value);
}

static void write_word(const Variant *variant, int index, char out[NUMBER_TEXT_MAX])
{
    snprintf(out, NUMBER_TEXT_MAX, "%s%s", variant->concealed ? "?" : "", variant->words[index]);
}

void variant_draw(const Variant *variant, const char *title, const char *student, char out[NUMBER_TEXT_MAX])
{
    uint64_t hash = HASH_BEGIN;
    const char *const parts[] = {student, title, variant->key};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        hash = hash_bytes(hash, parts[i], strlen(parts[i]) + 1); /* with the end, so that parts stay parts */
    for (int i = 0; i < variant->n_words;
         i++) /* who has the first of one list need not have that of another */
        hash = hash_bytes(hash, variant->words[i], strlen(variant->words[i]) + 1);
    if (variant->n_words > 0) {
        write_word(variant, (int)(mix(hash) % (uint64_t)variant->n_words), out);
        return;
    }
    const Values values = values_of(variant);
    const double index = (double)(mix(hash) % (uint64_t)(values.last - values.first + 1));
    write_value(&values, values.first + index, out);
}

bool variant_beside(const Variant *variant, const char *value, int direction, char out[NUMBER_TEXT_MAX])
{
    for (int i = 0; i < variant->n_words; i++)
        if (strcmp(variant->words[i], variant_word(value)) == 0 && i + direction >= 0 &&
            i + direction < variant->n_words) {
            write_word(variant, i + direction, out);
            return true;
        }
    if (variant->n_words > 0)
        return false;
    const Values values = values_of(variant);
    const double steps = round(strtod(value, NULL) / values.step) + direction;
    if (!(steps >= values.first && steps <= values.last))
        return false;
    write_value(&values, steps, out);
    return true;
}

/* Bytes of the blank that a text begins with: a space, or what only looks like one (no-break, wide, ...). */
static size_t blank_bytes(const char *text)
{
    static const char *const blanks[] = {" ", "\xc2\xa0", "\xe2\x80\xaf", "\xe2\x81\x9f", "\xe3\x80\x80"};
    for (size_t i = 0; i < sizeof blanks / sizeof *blanks; i++)
        if (strncmp(text, blanks[i], strlen(blanks[i])) == 0)
            return strlen(blanks[i]);
    const bool is_typographic = strncmp(text, "\xe2\x80", 2) == 0 && (unsigned char)text[2] >= 0x80 &&
                                (unsigned char)text[2] <= 0x8a; /* U+2000 to U+200A */
    return is_typographic ? 3 : 0;
}

#ifdef HAVE_UTF8PROC
static bool is_letter(const char *text, size_t bytes)
{
    utf8proc_int32_t character;
    if (utf8proc_iterate((const utf8proc_uint8_t *)text, (utf8proc_ssize_t)bytes, &character) < 1)
        return false;
    const utf8proc_category_t category = utf8proc_category(character);
    return (category >= UTF8PROC_CATEGORY_LU && category <= UTF8PROC_CATEGORY_MC) ||
           category == UTF8PROC_CATEGORY_ND;
}

static char *compose(const char *text, Status *status)
{
    char *composed = (char *)utf8proc_NFC((const utf8proc_uint8_t *)text);
    if (!composed)
        status_fail(status, "not enough memory for a name");
    return composed;
}
#else
static bool is_letter(const char *text, size_t bytes)
{
    return bytes == 1 && isalnum((unsigned char)*text);
}

/* Combining marks of letters (U+0300 to U+036F), voicing marks of kana and the parts of Korean syllables. */
static bool is_combining(const char *text)
{
    const unsigned char *byte = (const unsigned char *)text;
    return byte[0] == 0xcc || (byte[0] == 0xcd && byte[1] < 0xb0) ||
           (byte[0] == 0xe3 && byte[1] == 0x82 && (byte[2] == 0x99 || byte[2] == 0x9a)) ||
           (byte[0] == 0xe1 && byte[1] >= 0x84 && byte[1] <= 0x87);
}

static char *compose(const char *text, Status *status)
{
    char *same = strdup(text);
    for (const char *at = text; same && *at; at++)
        if (is_combining(at)) {
            status_refuse(status,
                          "%.80s: an accent is a character of its own (a letter with its accent as one; this "
                          "matvib was built without libutf8proc, which joins them)",
                          text);
            free(same);
            return NULL;
        }
    if (!same)
        status_fail(status, "not enough memory for a name");
    return same;
}
#endif

bool variant_student(const char *text, char out[STUDENT_MAX], Status *status)
{
    enum { CHARACTERS_MAX = 60 };
    size_t used = 0;
    int characters = 0;
    bool space = false, fits = true;
    if (!visible_is_clean(text))
        return status_refuse(status, "%.80s: is not a name (UTF-8 without control characters)", text);
    char *name = compose(text, status);
    if (!name)
        return false;
    for (const char *at = name; *at && fits;) {
        const size_t blank = blank_bytes(at);
        if (blank > 0) {
            space = used > 0;
            at += blank;
            continue;
        }
        characters += ((unsigned char)*at & 0xc0) != 0x80;
        fits = characters <= CHARACTERS_MAX && used + 2 < STUDENT_MAX;
        if (space && fits)
            out[used++] = ' ';
        space = false;
        if (fits)
            out[used++] = *at;
        at++;
    }
    free(name);
    out[used] = '\0';
    if (used == 0)
        return status_refuse(status, "the name is empty");
    return fits || status_refuse(status, "the name is too long (at most %d characters, %d bytes)",
                                 CHARACTERS_MAX, STUDENT_MAX - 2);
}

void variant_file_word(const char *name, char *out, size_t size)
{
    size_t used = 0;
    bool gap = false;
    for (size_t bytes; *name; name += bytes) {
        bytes = 1;
        while (((unsigned char)name[bytes] & 0xc0) == 0x80)
            bytes++;
        if (!is_letter(name, bytes)) {
            gap = used > 0;
            continue;
        }
        if (used + gap + bytes >= size)
            break;
        if (gap)
            out[used++] = '-';
        memcpy(out + used, name, bytes);
        used += bytes;
        gap = false;
    }
    out[used] = '\0';
}

/* The variants of a lesson: a student's values, set by its pages and shown in its texts (lesson.h). */

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

bool lesson_draw(Lesson *lesson, const char *student, Status *status)
{
    bool sound = true;
    for (int i = 0; i < lesson->n_variants; i++) {
        LessonVariant *variant = &lesson->variants[i];
        char **line = &lesson->pages[variant->page].first.actions[variant->action];
        variant_draw(&variant->variant, lesson->title, student, variant->value);
        free(*line);
        if (asprintf(line, "set %s %s", variant->variant.key, variant->value) < 0) {
            *line = NULL;
            return status_fail(status, "not enough memory for a lesson");
        }
    }
    for (int i = 0; i < lesson->n_pages && sound; i++) {
        LessonPage *page = &lesson->pages[i];
        sound = fill_in(lesson, i, &page->first.text, status) &&
                fill_in(lesson, i, &page->revealed.text, status) &&
                fill_in(lesson, i, &page->question, status);
        const LessonVariant *variant = *page->if_key ? lesson_variant(lesson, page->if_key, i) : NULL;
        for (int k = 0; k < page->n_choices && sound; k++) {
            /* the right one for whom a word was drawn */
            if (variant && page->if_words[k] &&
                text_has_word(page->if_words[k], variant_word(variant->value)))
                page->right = k;
            sound = fill_in(lesson, i, &page->choices[k], status);
        }
    }
    return sound;
}

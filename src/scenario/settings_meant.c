/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which key is meant by its end or by the words beside its field on screen. */
#include "scenario/parameters.h"

#include "base/text.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* How a key may be called; each in turn, the first by which there is one. */
typedef enum Call { CALL_WHOLE, CALL_NAME, CALL_END, CALL_LABEL, CALLS } Call;

/* "CELL SIZE" is "cell size". */
static bool same_words(const char *a, const char *b)
{
    while (*a && tolower((unsigned char)*a) == tolower((unsigned char)*b))
        a++, b++;
    return !*a && !*b;
}

/* Whether the word ends the key, behind a mark. */
static bool ends_with(const char *key, const char *word, const char *marks)
{
    const size_t length = strlen(key), end = strlen(word);
    return length > end && end > 0 && strchr(marks, key[length - end - 1]) &&
           strcmp(key + length - end, word) == 0;
}

static bool is_called(const char *key, const char *label, const char *words, Call call)
{
    switch (call) {
    case CALL_WHOLE:
        return strcmp(key, words) == 0;
    case CALL_NAME:
        return ends_with(key, words, ".");
    case CALL_END:
        return ends_with(key, words, "_");
    case CALL_LABEL:
    case CALLS:
        break;
    }
    return label && same_words(label, words);
}

bool settings_meant_key(const Settings *settings, const char *words, char key[KEY_MAX], Status *status)
{
    const char *found = NULL;
    char list[120] = "";
    int count = 0;
    for (Call call = CALL_WHOLE; call < CALLS && count == 0; call++) {
        for (int i = 0; i < n_parameters; i++)
            if (parameter_applies_to(settings, &parameters[i]) &&
                is_called(parameters[i].key, parameters[i].label, words, call)) {
                found = parameters[i].key;
                text_list_add(list, sizeof list, found);
                count++;
            }
        for (int i = 0; i < n_text_keys; i++)
            if (is_called(text_keys[i].key, NULL, words, call)) {
                found = text_keys[i].key;
                text_list_add(list, sizeof list, found);
                count++;
            }
    }
    if (count > 1)
        return status_refuse(status, "%s: which one? (%s)", words, list);
    /* what is none stays as it was typed, for the function that refuses it */
    snprintf(key, KEY_MAX, "%s", found ? found : words);
    return true;
}

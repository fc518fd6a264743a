/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any bytes as keys: every key has a name, and after enough silence the next one is itself. */
#include "fuzz/fuzz.h"

#include "terminal/keys.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void check_key(const Key *key)
{
    size_t length = strnlen(key->name, KEY_NAME_MAX);
    FUZZ_ASSERT(length > 0 && length < KEY_NAME_MAX);
    for (size_t i = 0; i < length; i++)
        FUZZ_ASSERT((unsigned char)key->name[i] > ' ' && key->name[i] != 0x7f);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    KeyReader reader;
    Key key;
    keys_open(&reader, NULL);
    for (size_t i = 0; i < size; i += KEYS_ROOM) {
        keys_feed(&reader, data + i, size - i < KEYS_ROOM ? size - i : KEYS_ROOM, 0);
        while (keys_next(&reader, &key))
            check_key(&key);
    }
    while (keys_silence(&reader, 60, &key) || keys_next(&reader, &key))
        check_key(&key);
    keys_feed(&reader, "q", 1, 60);
    FUZZ_ASSERT(keys_next(&reader, &key) && strcmp(key.name, "q") == 0);
    FUZZ_ASSERT(!keys_next(&reader, &key) && !keys_silence(&reader, 120, &key));
    return 0;
}

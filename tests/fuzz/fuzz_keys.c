/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any bytes as keys: every key has a name, and after enough silence the next one is itself. */
#include "fuzz/fuzz.h"

#include "lab/keyboard.h"

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
    enum { PIECE = 1000 };
    static Keyboard keyboard;
    Key key;
    FUZZ_ASSERT(keyboard.grid.curses || keyboard_open(&keyboard, "xterm-256color"));
    for (size_t i = 0; i < size; i += PIECE) {
        FUZZ_ASSERT(keyboard_type(&keyboard, data + i, size - i < PIECE ? size - i : PIECE));
        while (keyboard_next(&keyboard, &key))
            check_key(&key);
    }
    keyboard.time += 60;
    FUZZ_ASSERT(keyboard_type(&keyboard, "q", 1) && keyboard_next(&keyboard, &key));
    FUZZ_ASSERT(strcmp(key.name, "q") == 0 && !keyboard_next(&keyboard, &key));
    return 0;
}

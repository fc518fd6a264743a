/* Any bytes as keys: every key has a name, and after enough silence nothing is left open. */
#include "fuzz/fuzz.h"

#include "tui/terminal/keys.h"

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
    KeyDecoder decoder;
    Key key;
    keys_reset(&decoder);
    for (size_t i = 0; i < size; i++) {
        if (keys_feed(&decoder, data[i], &key))
            check_key(&key);
        /* a pause now and then, where the bytes say so */
        if (data[i] % 17 == 3 && keys_timeout(&decoder) >= 0)
            while (keys_expire(&decoder, &key))
                check_key(&key);
    }
    while (keys_expire(&decoder, &key))
        check_key(&key);
    FUZZ_ASSERT(keys_timeout(&decoder) == -1);
    return 0;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A number that stands for some bytes, the same on every machine: distinguishes two texts by chance, not
 * against somebody who means to deceive.
 *
 * Source: FNV-1a with 64 bits, RFC 9923. */
#ifndef BASE_HASH_H
#define BASE_HASH_H

#include <stddef.h>
#include <stdint.h>

#define HASH_BEGIN 0xcbf29ce484222325u

/* Goes on with more bytes. */
static inline uint64_t hash_bytes(uint64_t hash, const char *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++)
        hash = (hash ^ (unsigned char)bytes[i]) * 0x100000001b3u;
    return hash;
}

#endif

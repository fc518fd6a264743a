/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A target of fuzzing: a program that takes any bytes and must neither crash nor hang nor leak. The name is
 * that of libFuzzer, so that the same file serves it and the plain driver beside. */
#ifndef TESTS_FUZZ_H
#define TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Fails loudly, where there is no test around. */
#define FUZZ_ASSERT(condition)                                                                               \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);                                  \
            abort();                                                                                         \
        }                                                                                                    \
    } while (0)

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "export/wav.h"

#include "base/math/functions.h"

#include <math.h>
#include <stdint.h>

#define FADE_SECONDS 0.02
#define LOUDNESS     0.35 /* of what a sample can hold; both together stay below 1 on one loudspeaker */

static const double tau = 6.283185307179586;

/* Numbers stand with their lowest byte first. */
static void put_number(FILE *file, uint32_t number, int bytes)
{
    for (int i = 0; i < bytes; i++)
        fputc((int)(number >> 8 * i & 0xff), file);
}

static void put_head(FILE *file, uint32_t samples)
{
    const uint32_t channels = 2, width = 2, data = samples * channels * width;
    fputs("RIFF", file);
    put_number(file, 36 + data, 4);
    fputs("WAVEfmt ", file);
    put_number(file, 16, 4);
    put_number(file, 1, 2); /* PCM */
    put_number(file, channels, 2);
    put_number(file, WAV_RATE, 4);
    put_number(file, WAV_RATE * channels * width, 4);
    put_number(file, channels * width, 2);
    put_number(file, 8 * width, 2);
    fputs("data", file);
    put_number(file, data, 4);
}

/* s(t) = a(t) sin(2 pi f t), a rising and falling evenly at the ends */
static void put_sample(FILE *file, double frequency, double time, double seconds)
{
    const double edge = fmin(1, fmin(time, seconds - time) / FADE_SECONDS);
    const long value = lround(32767 * LOUDNESS * edge * math_sin(tau * frequency * time));
    put_number(file, (uint32_t)(value & 0xffff), 2);
}

void wav_write(FILE *file, double left, double right, double seconds)
{
    const uint32_t samples = (uint32_t)lround(seconds * WAV_RATE);
    put_head(file, samples);
    for (uint32_t i = 0; i < samples; i++) {
        const double time = (double)i / WAV_RATE;
        put_sample(file, left, time, seconds);
        put_sample(file, right, time, seconds);
    }
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two tones as a file of sound (RIFF WAVE, PCM, 16 bits, 44.1 kHz): one for each ear. */
#ifndef EXPORT_WAV_H
#define EXPORT_WAV_H

#include <stdio.h>

enum { WAV_RATE = 44100 }; /* samples in a second, Hz */

/* Pure tones of these frequencies, Hz, for so many seconds. They fade in and out over a fiftieth of a second,
 * so that nothing clicks. */
void wav_write(FILE *, double left, double right, double seconds);

#endif

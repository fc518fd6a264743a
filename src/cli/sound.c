/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib sound SCENARIO --output FILE.wav`: a run's frequency in the left ear, the exact one (of a beam:
 * Timoshenko's) in the right ear, so that an error of a few percent is heard as an interval. */
#include "cli/cli.h"
#include "scenario/settings.h"
#include "cli/options.h"
#include "base/math/functions.h"
#include "base/output.h"

#include <math.h>
#include <stdio.h>
#include <stdint.h>

/* Two tones as a file of sound (RIFF WAVE, PCM, 16 bits, 44.1 kHz): one for each ear. */

enum { WAV_RATE = 44100 }; /* samples in a second, Hz */

#define FADE_SECONDS 0.02
#define LOUDNESS     0.35 /* of what a sample can hold; both together stay below 1 on one loudspeaker */

static const double tau = 6.283185307179586;

/* Numbers stand with their lowest byte first. */
static void put_number(FILE *file, uint32_t number, int bytes)
{
    for (int i = 0; i < bytes; i++)
        fputc((int)(number >> 8 * i & 0xff), file);
}

/* s(t) = a(t) sin(2 pi f t), a rising and falling evenly at the ends */
static void put_sample(FILE *file, double frequency, double time, double seconds)
{
    const double edge = fmin(1, fmin(time, seconds - time) / FADE_SECONDS);
    const long value = lround(32767 * LOUDNESS * edge * math_sin(tau * frequency * time));
    put_number(file, (uint32_t)(value & 0xffff), 2);
}

#define PITCH 440.0 /* of what cannot be heard as it is, Hz */

/* What is heard well by small loudspeakers and by most ears, Hz. */
#define HEARD_LEAST 80.0
#define HEARD_MOST  6000.0

/* What both ears get. */
typedef struct Tones {
    double measured, exact; /* of the run: in Hz where its time is in seconds, else per unit of time */
    double times;           /* heard so many times as high */
    bool in_hertz;
} Tones;

static double frequency(const Readout *readout, double number)
{
    return readout->is_period ? 1 / number : number / tau;
}

static bool is_heard(double hertz)
{
    return hertz >= HEARD_LEAST && hertz <= HEARD_MOST;
}

/* `pitch`: what the exact tone is to have, Hz; 0: its own where that can be heard. */
static bool tune(const Readout *readout, double pitch, Tones *tones, Status *status)
{
    if (!readout->measured_known || !readout->exact_known)
        return status_refuse(status, "there is no steady frequency beside an exact one to be heard%s%s",
                             readout->unaccounted   ? ": not known with "
                             : *readout->unmeasured ? ": "
                                                    : "",
                             readout->unaccounted ? readout->unaccounted : readout->unmeasured);
    tones->measured = frequency(readout, readout->measured);
    tones->exact = frequency(readout, readout->exact);
    tones->in_hertz = readout->is_period; /* a bar's time has no unit */
    const bool as_it_is =
        pitch <= 0 && tones->in_hertz && is_heard(tones->exact) && is_heard(tones->measured);
    tones->times = as_it_is ? 1 : (pitch > 0 ? pitch : PITCH) / tones->exact;
    return tones->measured * tones->times < WAV_RATE / 2.0 ||
           status_refuse(status, "the measured tone would be too high to be heard (a lower --pitch)");
}

static bool write_tones(const Options *options, const Tones *tones, Status *status)
{
    const double seconds = options->seconds;
    OutputFile file;
    if (!output_open(&file, ASKER_COMMAND_LINE, options->output, options->force, status))
        return false;
    /* Pure tones of these frequencies, Hz, for so many seconds. They fade in and out over a fiftieth of a
     * second, so that nothing clicks. */
    const uint32_t samples = (uint32_t)lround(seconds * WAV_RATE);
    const uint32_t channels = 2, width = 2, data = samples * channels * width;
    fputs("RIFF", file.stream);
    put_number(file.stream, 36 + data, 4);
    fputs("WAVEfmt ", file.stream);
    put_number(file.stream, 16, 4);
    put_number(file.stream, 1, 2); /* PCM */
    put_number(file.stream, channels, 2);
    put_number(file.stream, WAV_RATE, 4);
    put_number(file.stream, WAV_RATE * channels * width, 4);
    put_number(file.stream, channels * width, 2);
    put_number(file.stream, 8 * width, 2);
    fputs("data", file.stream);
    put_number(file.stream, data, 4);
    for (uint32_t i = 0; i < samples; i++) {
        const double time = (double)i / WAV_RATE;
        put_sample(file.stream, tones->measured * tones->times, time, seconds);
        put_sample(file.stream, tones->exact * tones->times, time, seconds);
    }
    return output_end(&file, true, status);
}

int cli_sound(Options *options, Status *status)
{
    Settings settings;
    if (!options_load(options, options->words[0], &settings, status))
        return (int)status->code;
    if (!options->output)
        return progress_result(status_refuse(status, "sound: --output FILE is missing (FILE.wav)"), status);
    if (!output_may_begin(options->output, ASKER_COMMAND_LINE, options->force, status))
        return (int)status->code;
    Progress progress;
    progress_begin(&progress, options->quiet);
    settings.cancel = (Cancel){progress_show, &progress};
    RunSummary summary;
    Tones tones = {0};
    bool sound = export_run(&settings, &(Outputs){0}, progress_threads(options->threads), progress_show,
                            &progress, &summary, status);
    progress_end(&progress);
    if (progress_signal())
        return progress_result(false, status);
    if (!sound)
        options_blame(options, options->words[0], status);
    sound = sound && tune(&summary.readout, options->pitch, &tones, status) &&
            write_tones(options, &tones, status);
    if (sound && !options->quiet) {
        const double cents = 1200 / M_LN2 * math_log(tones.measured / tones.exact);
        const char *unit = tones.in_hertz ? " Hz" : " per unit of time";
        printf("left: measured %.6g%s   right: exact %.6g%s   %.0f cents %s\n", tones.measured, unit,
               tones.exact, unit, fabs(cents), cents < 0 ? "flat" : "sharp");
        if (tones.times == 1)
            printf("heard at their real pitch\n");
        else
            printf("heard %.6g times as high: %.6g and %.6g Hz\n", tones.times, tones.measured * tones.times,
                   tones.exact * tones.times);
        printf("wrote %s\n", options->output);
    }
    return progress_result(sound, status);
}

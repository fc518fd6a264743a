#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# matvib sound as people type it: what it says, its length, bytes that repeat, refusals. What is in the file is
# measured by check_sound.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=sound

bytes() { test "$(wc -c <"$1")" -eq "$2"; }

expect "the fifth mode" 0 mode5 --output a.wav
result "says both frequencies and the interval" says out "^left: measured 0.861677 per unit of time   right: exact 0.9 per unit of time   75 cents flat$"
result "and where they are heard" says out '^heard 488.889 times as high: 421.264 and 440 Hz$'
result "and what it wrote" says out '^wrote a.wav$'
result "six seconds of two ears" bytes a.wav $((44 + 6 * 44100 * 4))
result "a file of sound" test "$(head -c 4 a.wav)" = RIFF
expect "the same again" 0 mode5 --output b.wav --quiet
result "has the same bytes" cmp a.wav b.wav
result "and says nothing" test ! -s out
expect "half a second" 0 mode1 --seconds .5 --output c.wav
result "is as long" bytes c.wav $((44 + 22050 * 4))
expect "another pitch" 0 mode1 --seconds .5 --pitch 220 --output d.wav
result "is heard there" says out 'and 220 Hz$'
expect "a beam without correction" 0 supported-beam-uncorrected --set pd.spacing=0.0025 --set pd.horizon=0.0075 --output e.wav
result "at its real pitch" says out '^heard at their real pitch$'

refuse "no file" "sound: --output FILE is missing (FILE.wav)" mode5
refuse "a file that exists" "a.wav: exists (--force replaces it)" mode5 --output a.wav
refuse "too long" "--seconds: not a number from 0.1 to 600: 1e9" mode5 --seconds 1e9 --output z.wav
refuse "no pitch" "--pitch: not a number from 20 to 10000: high" mode5 --pitch high --output z.wav
refuse "nothing steady" "there is no steady frequency beside an exact one to be heard" notched-beam-coarse --end 1e-5 --output z.wav
result "nothing is left behind" test ! -e z.wav

echo "1..$number"

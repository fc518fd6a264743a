#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The summaries of run, fit and verify as JSON: one object that others can read, with the numbers that the text has.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"

# is_json FILE: read by who knows JSON, where there is one
is_json() { ! command -v python3 >/dev/null 2>&1 || python3 -c 'import json, sys; json.load(open(sys.argv[1]))' "$1"; }
# value FILE NAME: of a quantity, as it is written
value() { sed -n "s/^  {\"name\": \"$2\", \"value\": \([^,]*\), \"unit\": .*/\1/p" "$1"; }
# unit FILE NAME
unit() { sed -n "s/^  {\"name\": \"$2\", \"value\": [^,]*, \"unit\": \([^,}]*\)[,}].*/\1/p" "$1"; }
# near FILE NAME NUMBER: the value, rounded to as many digits as the text has
near() { value "$1" "$2" | awk -v said="$3" '{ print $0, said; exit sprintf("%.7g", $1) + 0 != said + 0 }'; }

printf '[scenario]\ntitle = A "bar" \\ of tin\nproblem = bar\n[time]\nend = 20\n' >quoted.ini
expect "a run" 0 run quoted.ini --json
cp out run.json
result "is JSON" is_json run.json
result "its title has what it has" grep -q -F '"title": "A \"bar\" \\ of tin"' run.json
"$MATVIB" run quoted.ini >text
measured=$(sed -n 's/^frequency  measured \([0-9.]*\) .*/\1/p' text)
exact=$(sed -n 's/^frequency .*exact \([0-9.]*\)$/\1/p' text)
result "the text has a frequency" test -n "$measured" -a -n "$exact"
result "it is the measured one" near run.json frequency_measured "$measured"
result "and the exact one" near run.json frequency_exact "$exact"
result "steps as the text has them" test "$(value run.json steps)" = "$(sed -n 's/^\([0-9]*\) steps .*/\1/p' text)"
result "with a unit" test "$(unit run.json frequency_measured)" = '"1/time"'
result "and 17 digits" test "$(value run.json frequency_predicted | tr -d '.' | wc -c)" -ge 17
expect "a beam" 0 run supported-beam-coarse --end 1e-4 --json --quiet
result "is JSON, quiet too" is_json out
result "in seconds" test "$(unit out period_theory)" = '"s"'
expect "too short a run" 0 run mode5 --steps 3 --json
result "a number that is none is null" test "$(value out frequency_measured)" = null
result "and why" says out '"why": "too short a run to measure it"'
result "no nan" sh -c '! grep -i -w -e nan -e inf out'
expect "bodies that meet" 0 run two-discs --json
result "is JSON" is_json out
result "has when they touch" test "$(value out touch)" = "$(value out first_touch)"
result "in words, and when they part" says out '"text": "left leaves right"}'
expect "a beam that tears" 0 run falling-beam --set mpm.shape=hat --json
result "has when it tears" test "$(value out tear)" = "$(value out torn)"
expect "a wrong code" 0 run mode5 --steps 3 --set mpm.mistake=keep_grid --json
result "says so" says out '"mistake": "keep_grid"'
expect "a run that fails" 1 run mode5 --set mpm.mistake=x_by_own_velocity --end 40 --json
result "is JSON too" is_json out
result "with the reason" says out '"failure": "'
result "on standard error in one line" lines err 1

# is RIGHT DIGITS ARGUMENTS...: the frequency that is measured, rounded to so many digits, and that others find in the
# same series; it explains most of the series, to a small share of itself
is() {
	right=$1 digits=$2
	shift 2
	"$MATVIB" run "$@" --json >out
	result "$*: w $right" test "$(value out frequency_measured | awk -v d="$digits" '{ printf "%." d "g", $1 }')" = "$right"
	result "it is most of the series" holds 'r2 > .85 && r2 <= 1 && u > 0 && u < 5e-4 * w'
}
holds() {
	awk -v w="$(value out frequency_measured)" -v u="$(value out frequency_uncertainty)" -v r2="$(value out frequency_r2)" \
		"BEGIN { exit !($1) }"
}
# beside what is expected: a side lobe is not what is measured
is 7.82 3 mode5 --set mpm.shape=gimp --set initial.mode=8 --set initial.offset=.4
is 7.659 4 mode5 --set mpm.mistake=volume_of_cell --end 13.1
is 5.416 4 mode5 --set mpm.mistake=mass_for_volume --set bar.density=2 --end 13.1
is 2.797 4 mode5 --set mpm.mistake=gradient_without_h --set mesh.cell_size=.5 --end 20 --every 2
# with its decay; the eigenvalue is .862755
is 0.86275 5 mode1 --set bar.length=18 --set initial.velocity=1e-7 --set initial.offset=.3 --set mesh.particles_per_cell=5 \
	--set mpm.algorithm=musl --set mpm.shape=bspline3 --set mpm.flip_fraction=.5 --end 60
set -- mode5 --set mpm.mistake=fix_after_strain --end 20
expect "what is not one frequency" 0 run "$@" --json
result "has no number" test "$(value out frequency_measured)" = null
result "and this reason" says out '"why": "not one frequency: R2 < 0.5"'
result "with its R2" holds 'r2 >= 0 && r2 < .5 && u == ""'
result "and no lag" test -z "$(value out late)"
expect "in words" 0 run "$@"
result "it says so too" says out '^frequency with a mistake  not one frequency: R2 < 0.5 '
result "and nothing more" test -z "$(grep -e '^uncertainty' -e '^error' -e 'periods behind' -e 'periods ahead' out)"
expect "and is no sound" 2 sound "$@" --output none.wav
result "for this reason" says err 'there is no steady frequency .*: not one frequency: R2 < 0.5'

expect "a run that follows a particle" 0 run mode1 --set output.follow='particle 3 v' --end 1 --json
result "is JSON" is_json out

"$MATVIB" run mode5 --end 5 --set bar.youngs_modulus=93 --every 10 --series d.csv --quiet
expect "a fit" 0 fit mode5 --data d.csv --vary bar.youngs_modulus,bar.density --output f.csv --json
result "is JSON" is_json out
result "of the parameters sought" says out '{"name": "bar.youngs_modulus", "value": [0-9.e+-]*, "unit": "[^"]*", "half_width_95": '
result "and how they hang together" says out '{"name": "correlation", .*"of": "bar.youngs_modulus", "and": "bar.density"'

expect "verify" 0 verify M-fig3 P-surface --json
result "is JSON" is_json out
cp out verify.json
"$MATVIB" verify M-fig3 P-surface >text
said=$(sed -n 's/^ours: [0-9]* of \([0-9]*\) reproduced; [0-9]* of \([0-9]*\) bounds hold$/\1 \2/p' text | awk '{ print $1 + $2 }')
result "every reference and bound that the text counts" test "$(grep -o -e '"reference": "' -e '"bound": "' -e '"near": "' verify.json | wc -l)" = "$said"
result "in per cent" test "$(unit verify.json 'error of omega, %' | head -n 1)" = '"%"'

subcommand=run
refuse "standard output is taken" '--json: standard output has a table (--series FILE)' mode5 --json --series -
"$MATVIB" run mode5 --json --set mesh.cell=1 >out 2>err
result "an error is a line on standard error" test $? -eq 2 -a ! -s out -a "$(wc -l <err)" -eq 1
echo "1..$number"

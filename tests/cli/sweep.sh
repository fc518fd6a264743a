#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Sweeps: what they measure, the order of their rows, interruptions, wrong words.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=sweep

# without_wall FILE: all columns but the wall time
without_wall() { awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "wall") wall = i } { $wall = ""; print }' "$1"; }
# holds FILE CONDITION: of the awk program's named columns, in its last block
holds() { awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next } { for (name in at) v[name, NR - 1] = $at[name] }
	END { exit !('"$2"') }' "$1"; }

# --- the bar: half the cell, a quarter of the error

expect "cell sizes" 0 mode5 --vary mesh.cell_size=1,0.5,0.25
cp out cells.csv
result "the columns of a bar" test "$(head -n 1 out)" = \
	mesh.cell_size,frequency_measured,frequency_uncertainty,frequency_r2,frequency_predicted,frequency_exact,frequency_error,\
energy_left,steps,wall,kept_measured,kept_predicted
result "a row each" test "$(wc -l <out)" -eq 4
result "nothing on stderr" test ! -s err
result "second order in the cell size" holds out \
	'v["frequency_error", 1] / v["frequency_error", 2] > 3.7 && v["frequency_error", 1] / v["frequency_error", 2] < 4.3 &&
	 v["frequency_error", 2] / v["frequency_error", 3] > 3.7 && v["frequency_error", 2] / v["frequency_error", 3] < 4.3'
result "as predicted, within 0.1 %" holds out \
	'(v["frequency_measured", 1] / v["frequency_predicted", 1] - 1) ^ 2 < 1e-6 && (v["frequency_measured", 3] / v["frequency_predicted", 3] - 1) ^ 2 < 1e-6'
result "how well each is known" holds out \
	'v["frequency_r2", 1] > .99 && v["frequency_r2", 1] < 1 && v["frequency_uncertainty", 1] > 1e-5 && v["frequency_uncertainty", 1] < 1e-3'
result "as many steps as the cells ask for" holds out 'v["steps", 1] == 10000 && v["steps", 3] == 40000'

expect "cures of the late frequency" 0 mode5 --vary mpm.mass_blend=1,.5,auto --set initial.velocity=1e-6 --end 20
result "late, less late, hardly late" holds out \
	'(v["frequency_error", 1] + 4.2388) ^ 2 < 1e-8 && (v["frequency_error", 2] + 1.3589) ^ 2 < 1e-8 &&
	 (v["frequency_error", 3] + .036126) ^ 2 < 1e-12'
result "each as its masses predict" holds out \
	'(v["frequency_measured", 1] / v["frequency_predicted", 1] - 1) ^ 2 < 1e-17 &&
	 (v["frequency_measured", 2] / v["frequency_predicted", 2] - 1) ^ 2 < 1e-17 &&
	 (v["frequency_measured", 3] / v["frequency_predicted", 3] - 1) ^ 2 < 1e-17'
expect "filters" 0 mode5 --set mpm.transfer=fmpm --vary mpm.fmpm_order=2,3,4 --set initial.velocity=1e-6 --end 10
result "that take less and less in each period" holds out \
	'(v["kept_predicted", 1] - .684) ^ 2 < 2.6e-7 && (v["kept_predicted", 2] - .978) ^ 2 < 2.6e-7 &&
	 (v["kept_predicted", 3] - .9987) ^ 2 < 2.6e-9'
result "as measured" holds out \
	'(v["kept_measured", 1] - v["kept_predicted", 1]) ^ 2 < 1e-12 &&
	 (v["kept_measured", 2] - v["kept_predicted", 2]) ^ 2 < 1e-12 &&
	 (v["kept_measured", 3] - v["kept_predicted", 3]) ^ 2 < 1e-12'

expect "a range and choices" 0 mode5 --vary time.courant=.1:.3:3 --vary mpm.algorithm=usf,usl,musl --end 30 --threads 3
result "the product in order, choices as indices" test "$(cut -d, -f1,2 out | tr '\n' ' ')" = \
	'time.courant,mpm.algorithm 0.1,0 0.1,1 0.1,2 0.2,0 0.2,1 0.2,2 0.3,0 0.3,1 0.3,2 '
without_wall out >three
expect "the same with one thread" 0 mode5 --vary time.courant=.1,.2,.3 --vary mpm.algorithm=usf,usl,musl --end 30 --threads 1
without_wall out >one
result "the same rows" cmp -s one three
expect "both methods" 0 mode5 --vary scenario.method=mpm,pd --end 30
result "each with its own prediction" holds out \
	'v["frequency_error", 1] < -4.2 && v["frequency_error", 2] > -1.3 && (v["frequency_measured", 2] / v["frequency_predicted", 2] - 1) ^ 2 < 1e-8'
expect "the number of steps" 0 mode5 --vary time.courant=.1,.2 --steps 700
result "is the same for all" holds out 'v["steps", 1] == 700 && v["steps", 2] == 700'

# --- beams: the two coarsest rows of table 1

expect "table 1" 0 supported-beam --vary pd.horizon=5e-3,2.5e-3 --with pd.spacing=1.2e-3,.6e-3 --end 2e-3
result "the columns of a beam" test "$(head -n 1 out)" = pd.horizon,pd.spacing,period_measured,period_uncertainty,period_r2,period_predicted,period_theory,period_error,\
period_euler,period_error_euler,real_height,real_span,energy_left,steps,wall
result "horizon and spacing side by side" test "$(cut -d, -f1,2 out | tail -n 2 | tr '\n' ' ')" = \
	'0.005,0.0012 0.0025,0.0006 '
result "periods to 2e-3" holds out \
	'(v["period_measured", 1] / .9927e-3 - 1) ^ 2 < 4e-6 && (v["period_measured", 2] / .9150e-3 - 1) ^ 2 < 4e-6'
result "errors against both theories" holds out \
	'(v["period_error", 1] - 100 * (v["period_measured", 1] / v["period_theory", 1] - 1)) ^ 2 < 1e-12 &&
	 (v["period_error_euler", 1] - 100 * (v["period_measured", 1] / .860109e-3 - 1)) ^ 2 < 1e-6'
result "the height as it is" holds out '(v["real_height", 1] - .0048) ^ 2 < 1e-18'
expect "the notched beam" 0 notched-beam-coarse --vary load.stress=60e6,70e6 --steps 20
result "has no frequency, but bonds" test "$(head -n 1 out)" = \
	load.stress,real_height,real_span,crack_length,broken_bonds,steps,wall
expect "the crack of it" 0 notched-beam-coarse --set pd.spacing=2e-3 --set pd.horizon=6.5e-3 --vary load.stress=120e6,140e6 --end 200e-6
result "has its first break and its angle" holds out \
	'v["first_break", 2] > 5e-5 && v["first_break", 2] < v["first_break", 1] &&
	 v["crack_angle", 1] > 5 && v["crack_angle", 1] < 60'

# --- a plate: straight at half the load, two branches at the whole

set -- branching-coarse --set pd.spacing=1e-3 --set pd.horizon=4e-3 --set time.step=2e-7
expect "the cracks of a plate" 0 "$@" --vary loads.top.sy=6e6,12e6 --with loads.bottom.sy=-6e6,-12e6
result "have columns" test "$(head -n 1 out)" = loads.top.sy,loads.bottom.sy,real_height,crack_angle,tip_speed,tips,branched,\
branch_x,branch_time,half_angle,crack_cost,broken_bonds,steps,wall
result "without branches those of branches are empty" holds out \
	'v["branched", 1] == 0 && v["tips", 1] == 1 && v["branch_x", 1] == "" && v["branch_time", 1] == "" && v["half_angle", 1] == "" && v["crack_cost", 1] > 204'
result "with branches they say where and when" holds out \
	'v["branched", 2] == 1 && v["tips", 2] == 2 && (v["branch_x", 2] - .0815) ^ 2 < 1e-8 && v["branch_time", 2] > 2e-5 && v["branch_time", 2] < 4e-5'
cp out cracks.csv
"$MATVIB" run "$@" >run.out 2>err
same() {
	set -- $(tail -n 1 cracks.csv | cut -d, -f5,6,8-11 | tr , ' ')
	LC_ALL=C printf '%d tips  fastest %.0f m/s|branch x %.1f|, %.1f us|half angle %.0f deg|cost  %.1f J|' "$2" "$1" \
		"$(awk "BEGIN { print 1e3 * $3 }")" "$(awk "BEGIN { print 1e6 * $4 }")" "$5" "$6" | tr '|' '\n' >wanted
	while read -r part; do grep -q -F -e "$part" run.out || { echo "no: $part"; cat run.out; return 1; }; done <wanted
}
result "as one run says" same

# --- combinations without a row

expect "unstable steps" 1 mode5 --vary time.courant=0.1,3,0.5 --end 30
result "the others have rows" test "$(cut -d, -f1 out | tr '\n' ' ')" = 'time.courant 0.1 0.5 '
result "it says which" says err '^left out: time.courant=3: .*unstable'
result "it counts" says err '^matvib: 1 of 3 combinations have no row$'
expect "a run too short" 0 mode5 --vary time.end=0.1,30
result "says so" says err '^no frequency: time.end=0.1: too short'
result "and leaves its cells empty" says out '^0.1,,,,5.4[0-9]*,5.65[0-9]*,,'
expect "a motion that decays" 0 mode10 --vary mpm.algorithm=usf,usl
result "is measured with its decay" holds out \
	'(v["frequency_measured", 2] / v["frequency_predicted", 2] - 1) ^ 2 < 1e-9 && v["energy_left", 2] < .05'
expect "a motion that has decayed at once" 0 mode5 --vary mpm.mistake=none,stress_not_added
result "says so too" says err '^no frequency: mpm.mistake=stress_not_added: the motion has decayed'
result "and keeps its energy" holds out 'v["frequency_measured", 2] == "" && v["energy_left", 2] < .05'
expect "energy that is kept" 0 mode5 --set initial.velocity=1e-6 --vary time.courant=.1,.5,1,1.5 --end 7
result "at any time step" holds out \
	'(v["energy_left", 2] - 1) ^ 2 < 1e-8 && (v["energy_left", 3] - 1) ^ 2 < 1e-8 && (v["energy_left", 4] - 1) ^ 2 < 1e-8'
expect "no row at all" 1 mode5 --vary time.courant=3,4 --output none.csv
result "no table either" test ! -e none.csv 

# --- files

expect "a file" 0 mode5 --vary mpm.algorithm=usf,usl --end 30 --output table.csv
result "no more on stdout" test ! -s out
result "no other files" test "$(echo table*)" = "table.csv table.csv.ini"
result "what the indices mean" says table.csv.ini 'mpm.algorithm .*0 = usf, 1 = usl, 2 = musl'
result "the command" says table.csv.ini '^# matvib sweep mode5 --vary mpm.algorithm=usf,usl --end 30'
"$MATVIB" show table.csv.ini >out 2>err
result "the scenario reads back" test ! -s err
cp table.csv before.csv
refuse "it is not replaced" 'table.csv: exists (--force replaces it)' mode5 --vary mpm.algorithm=usf --output table.csv
result "and has not changed" cmp -s table.csv before.csv
expect "--force" 0 mode5 --vary mpm.algorithm=musl --end 30 --output table.csv --force --dialect semicolon
result "replaces it" says table.csv '^2;5,'

# --- an interruption: the third run would take days

signal=TERM ended=143
env --default-signal=INT true 2>/dev/null && signal=INT ended=130
set -- sweep mode5 --threads 2 --vary time.end=20,1e8,30,1e8 --output long.csv
if test $signal = INT; then
	env --default-signal=INT "$MATVIB" "$@" >out 2>err &
else
	"$MATVIB" "$@" >out 2>err &
fi
sweep=$!
soon works $sweep 50
kill -$signal $sweep
ends $sweep
got=$?
result "the signal's status" test $got -eq $ended
result "it says so" test "$(cat err)" = 'matvib: interrupted'
result "and leaves nothing" test "$(echo long*)" = 'long*'

# --- a scenario that changes meanwhile: the second run would be of another one

cp "$MATVIB_SRCDIR/data/scenarios/mode5.ini" changing.ini
"$MATVIB" sweep changing.ini --threads 1 --vary time.end=1e4,20 >out 2>err &
sweep=$!
soon works $sweep 20
sed -i 's/^mode *=.*/mode = 6/' changing.ini
ends $sweep
result "is not mixed with another" says err '^left out: time.end=20: changing.ini has changed since the sweep began$'

"$MATVIB" sweep mode1 --vary initial.mode=1,2 --set 'scenario.title=a$(b) it'"'"'s' --end .1 --output quoted.csv --quiet
result "the command beside a table can be pasted" grep -q -F -e "'scenario.title=a\$(b) it'\\''s' --end .1" quoted.csv.ini
rm -f quoted.csv*

# --- values of the rows of a plate

expect "the pull on a plate" 0 branching-coarse --set pd.spacing=1e-3 --set pd.horizon=4e-3 --set time.step=2e-7 \
	--vary loads.top.sy=6MPa,12e6 --with loads.bottom.sy=-6MPa,-12e6
result "is a column" test "$(head -n 1 out | cut -d, -f1,2)" = loads.top.sy,loads.bottom.sy
result "in its unit, and breaks more bonds" holds out \
	'v["loads.top.sy", 1] == 6e6 && v["loads.bottom.sy", 2] == -12e6 &&
	 v["broken_bonds", 1] < v["broken_bonds", 2] && v["broken_bonds", 2] == 4341'

# --- wrong words

refuse "a whole row" '--vary: loads.top: is a whole row (one value of it can be varied, such as loads.NAME.sy)' \
	branching-coarse --vary 'loads.top=top 0 1cm 0 1'
refuse "an edge" '--vary: loads.top.edge: is a text (numbers and choices can be varied)' \
	branching-coarse --vary loads.top.edge=left
refuse "a row that there is not" '--vary: loads.tip: there is no load of that name (top, bottom)' \
	branching-coarse --vary loads.tip.sy=1

refuse "nothing to vary" '--vary is missing (--vary KEY=A,B,C or KEY=LO:HI:N)' mode5
refuse "no scenario" 'SCENARIO is missing (see: matvib --help)' --vary time.end=1
refuse "no values" '--vary: "time.end" varies nothing (KEY=A,B,C or KEY=LO:HI:N)' mode5 --vary time.end
refuse "an empty value" '--vary: time.end: an empty value (A,B,C or LO:HI:N)' mode5 --vary time.end=1,,2
refuse "a range of one" '--vary: time.end: 1:2:1 is not a range (LO:HI:N, N from 2 to 100000)' mode5 --vary time.end=1:2:1
refuse "an unknown key" '--vary: mesh.cellsize: unknown key (did you mean mesh.cell_size?)' mode5 --vary mesh.cellsize=1
refuse "out of range, the last value" '--vary: mesh.particles_per_cell: 9 is out of range (1 to 8)' \
	mode5 --vary mesh.particles_per_cell=1:9:9
refuse "a text" '--vary: initial.overtones: is a text (numbers and choices can be varied)' \
	mode5 --vary initial.overtones=3:0.1
refuse "twice" '--with: time.end: is varied twice (once)' mode5 --vary time.end=1,2 --with time.end=1,2
refuse "--with alone" '--with: time.end: needs a --vary before it' mode5 --with time.end=1
refuse "--with too short" '--with: mesh.cell_size: has 1 values beside 2 of time.end (as many)' \
	mode5 --vary time.end=1,2 --with mesh.cell_size=1
refuse "too many" '--vary: 1000000 combinations are too many (at most 100000)' \
	mode5 --vary time.end=1:2:1000 --vary bar.density=1:2:1000
refuse "jobs" '--jobs: is --threads N now, which shares the runs out too' \
	mode5 --vary time.end=1,2 --jobs 2
refuse "two ends" '--vary: time.end: --steps says when the run ends (one of them)' mode5 --vary time.end=1,2 --steps 9
refuse "a plan" '--plan: is gone (a shell loop over matvib run SCENARIO --set KEY=VALUE does it)' mode1 --vary initial.mode=1,2 --plan
refuse "metadata of a sweep" '--crate: is gone (FILE.csv.ini beside a table says what it holds and makes it again)' mode1 --vary initial.mode=1,2 --crate

expect "a gap that is off" 0 two-discs --vary contact.gap=.4,off --end 0.1 --output gap.csv --force
result "is written so" sh -c 'sed -n 3p gap.csv | grep -q "^off,"'
echo "1..$number"

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# matvib fit as people type it: what it says and writes, and what it refuses. What it finds is measured by
# check_fit.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=fit
# the libraries below cairo keep what they know of fonts to the end
printf 'leak:libfontconfig\nleak:libcairo\n' >"$scratch/.leaks"
LSAN_OPTIONS="suppressions=$scratch/.leaks:print_suppressions=0${LSAN_OPTIONS:+:$LSAN_OPTIONS}"
export LSAN_OPTIONS

"$MATVIB" run mode5 --end 5 --set bar.youngs_modulus=93 --every 10 --series d.csv --quiet
expect "a series of a softer bar" 0 mode5 --data d.csv --vary bar.youngs_modulus --output f.csv --figure f.svg
result "says which column" says out '^v_cm, 5[0-9] data, [0-9]* runs: [0-9]* beginnings, 1 search, [0-9]* iterations$'
result "finds what it was made with" says out '^bar.youngs_modulus  *93  '
result "says where it began" says out ' 100$'
result "what is left" says out '^that is round-off: the run goes through all data, and there is no noise'
result "what no interval covers" says out '^Intervals cover noise in the data. They do not cover the error of mesh and time step'
result "and what it wrote" says out '^wrote f.svg$'
result "a table" test "$(head -n 1 f.csv)" = time,v_cm,fitted,residual
result "with a line for each datum" lines f.csv "$(wc -l <d.csv)"
result "a picture" grep -q '<svg' f.svg
result "with the data's name" grep -q 'd.csv' f.svg
"$MATVIB" show mode1 >load.ini && printf '[changes]\n300 = load.body_force=0.01\n' >>load.ini
"$MATVIB" run load.ini --end 6 --every 20 --series l.csv --quiet
expect "a load that comes in mid-run" 0 load.ini --set bar.youngs_modulus=105 --data l.csv --vary bar.youngs_modulus
result "comes in each run" says out '^bar.youngs_modulus  *100  '
"$MATVIB" run load.ini --end 50 --series own.csv --quiet
expect "a search that begins at the answer" 0 load.ini --end 50 --data own.csv --vary bar.youngs_modulus
result "stays there" says out '^bar.youngs_modulus  *100  '
"$MATVIB" run hanging-beam --set pd.spacing=2.5e-3 --set pd.horizon=8e-3 --set time.step=auto --every 500 --series h.csv --quiet
awk -F, 'NR > 1 { u = $3 } { print $2 "," $3 } END { print "0.004," u }' h.csv >still.csv
expect "data beyond rest" 0 hanging-beam --set pd.spacing=2.5e-3 --set pd.horizon=8e-3 --set time.step=auto --set load.body_force=-9 --data still.csv --vary load.body_force
result "are of a body that hangs still" says out '^load.body_force  *-9.81  '
"$MATVIB" run mode5 --set bar.youngs_modulus=90 --end 20 --every 20 --series s.csv --quiet
expect "data that oscillate once less" 0 mode5 --data s.csv --vary bar.youngs_modulus
result "are not taken for those beside them" says out '^bar.youngs_modulus  *90  '
awk -F, 'NR == 1 { print "time,v_cm" } NR > 1 { print $2 "," 0.007 * sin(3 * $2 * $2) }' s.csv >wild.csv
expect "data of something else" 0 mode5 --data wild.csv --vary bar.youngs_modulus
result "are no noise" says out '^they are not noise: .* the intervals do not hold$'
result "and no fit" says out '^nearly as large as the data: that is a minimum, and no fit$'
printf '[scenario]\nproblem = plate\n[plate]\nlength = 40mm\nheight = 20mm\n[pd]\nspacing = 1mm\nhorizon = 4mm\n[loads]\nl = top 0 100%% 0 1e4\n[supports]\ns = 0 0 1mm 100%% ux 0 uy 0\n[time]\nend = 2e-5\n' >plate.ini
"$MATVIB" run plate.ini --series p.csv --quiet
expect "the load of a plate" 0 plate.ini --set loads.l.sy=2e4 --data p.csv --vary loads.l.sy
result "is found" says out '^loads.l.sy  *10000 '
expect "an edge" 2 plate.ini --data p.csv --vary loads.l.edge
result "is no number" says err 'loads.l.edge: is not a real number and cannot be fitted'
expect "two parameters that only their ratio tells" 0 mode5 --data d.csv --vary bar.youngs_modulus,bar.density
result "are told by their correlation" says out '^correlation of bar.youngs_modulus and bar.density: 1.000$'
printf 't;u\n0;0,0071\n0,1;0,0061\n0,2;0,0035\n0,3;0,0002\n' >own.csv
expect "a table with names of its own" 0 mode5 --data own.csv --vary initial.velocity --column v_cm
result "is fitted too" says out '^v_cm, 4 data'
cut -d, -f2,3 d.csv >one.csv
refuse "a column that the table has not" "one.csv: its column is v_cm, not kinetic" mode5 --data one.csv --vary bar.density --column kinetic

refuse "table and picture in one file" "$(pwd -P)/t.svg: two outputs cannot be the same file" mode5 --data d.csv --vary bar.density --output t.svg --figure ./t.svg
refuse "over its data" "d.csv: the output would overwrite an input" mode5 --data d.csv --vary bar.density --output d.csv --force

# at the end of its range a parameter has a slope on one side; an interval beyond it stands for the other
"$MATVIB" run mode5 --end 1.2 --series n.csv --quiet --force
awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; print "time,v_cm"; next } { x = (x * 69069 + 1) % 4294967296; print $at["time"], $at["v_cm"] - 4e-4 * (x / 4294967296 - .5) }' n.csv >noisy.csv
expect "a share that is all" 0 mode5 --data noisy.csv --vary mpm.flip_fraction
result "is known as well as the noise allows" sh -c 'awk "\$1 == \"mpm.flip_fraction\" { n = \$2 > .9999 && \$3 > .0018 && \$3 < .0028 } END { exit !n }" out'
expect "a length that is not a whole number of cells" 2 mode5 --data noisy.csv --vary bar.length
result "is told so" says err '^matvib: bar.length: there is no run with a little more or less: mesh.cell_size: the length [0-9.]* must be'
printf 'time,v_cm\n0,0\n1,0\n2,0\n3,0\n' >zero.csv
refuse "data that are 0" "the data are all 0" mode5 --data zero.csv --vary bar.density
printf 'time,v_cm\n0,.007\n1,1e308\n2,-1e308\n3,1e308\n' >far.csv
refuse "data beyond all squares" "the data are so far from any run that least squares have no number" mode5 --data far.csv --vary bar.density
printf 'time,v_cm\n0,.007\n1,.001\n2,.004\n1e7,.1\n' >long.csv
refuse "data that ask for a run without end" "the data end at t = 1e+07, more than 1000 times the run's own end (time.end = 100)" mode5 --data long.csv --vary bar.density
refuse "no data" "fit: --data FILE is missing" mode5 --vary bar.density
refuse "no parameters" "fit: --vary KEY,... is missing" mode5 --data d.csv
refuse "a parameter that it has not" "beam.length: this run has no such parameter" mode5 --data d.csv --vary beam.length
refuse "one that is no number" "mpm.shape: is not a real number and cannot be fitted" mode5 --data d.csv --vary mpm.shape
refuse "a column that it has not" "--column: u_probe is not a column of the series ($("$MATVIB" run mode5 --steps 1 --columns all --series - --quiet | head -n 1 | tr ',' '\n' | grep -v -x -e step -e time -e 'v_cm_.*' | paste -sd , | sed 's/,/, /g'))" mode5 --data d.csv --vary bar.density --column u_probe
refuse "a file that exists" "f.csv: exists (--force replaces it)" mode5 --data d.csv --vary bar.density --output f.csv
printf 'time,v_cm\n-1,0\n0,1\n1,2\n' >early.csv
refuse "times before the run" "early.csv: a time below 0: -1 (a run begins at 0)" mode5 --data early.csv --vary bar.density
printf 'time,v_cm\n1,0\n' >few.csv
refuse "too few" "1 data are too few for 1 parameters" mode5 --data few.csv --vary bar.density
"$MATVIB" fit mode5 --data /dev/zero --vary bar.density >out 2>err
result "a device is no file" test $? -eq 2

echo "1..$number"

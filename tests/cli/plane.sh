#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Beams by the material point method as people type them: columns, tables, frames, bytes that repeat, sweeps, figures,
# a session, and a long run that is given up.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=run

header() { test "$(head -n 1 "$1")" = "$2"; }
# sums FILE COLUMN: of a table's column
sums() { awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; next } { s += $c } END { printf "%.9g\n", s }' "$1"; }

# --- tables ---
expect "a supported beam" 0 supported-beam-mpm-coarse --steps 40 --columns all --series s.csv --particles p.csv --nodes n.csv \
	--vtk v --frames 2
result "columns of its series" header s.csv \
	step,time,u_probe,v_probe,u_euler,v_euler,u_timoshenko,v_timoshenko,u_plane,v_plane,kinetic,kinetic_grid,kinetic_null,strain,work,total,momentum_x,momentum_y,reaction_x,reaction_y
result "columns of particles" header p.csv \
	step,time,particle,x0,y0,x,y,ux,uy,vx,vy,sxx,syy,sxy,density,mass,mises,speed,strain_energy,kinetic_energy,exx,eyy,gxy,probe
result "columns of nodes" header n.csv step,time,node,x,y,mass,px,py,fx,fy,vx,vy,ax,ay,active,fixed,held_x,held_y
result "a row each step" lines s.csv 42
result "1,280 particles, twice" lines p.csv 2561
result "85 x 9 nodes, twice" lines n.csv 1531
result "all mass is on the nodes" test "$(sums p.csv mass)" = "$(sums n.csv mass)"
result "every cell is a number" sh -c '! grep -q -i -e nan -e inf -e ,, -e ",$" s.csv p.csv n.csv'
result "seen and null space are parts of the kinetic energy" awk -F, \
	'NR > 1 && !($12 >= 0 && $13 >= 0 && $12 + $13 <= $11 * (1 + 1e-9)) { exit 1 }' s.csv
result "the summary tells what its mesh predicts" says out 'predicted 0.0008605907 '
result "frames for ParaView" test -s v-0000.vtu -a -s v-0001.vtu -a -s v.pvd
for name in displacement velocity sxx syy sxy density; do
	result "with $name" says v-0001.vtu "Name=\"$name\""
done
expect "it repeats" 0 s.csv.ini --series t.csv --particles q.csv --nodes m.csv --frames 2 --quiet
for pair in "s t" "p q" "n m"; do
	result "with the same bytes: ${pair% *}.csv" cmp "${pair% *}.csv" "${pair#* }.csv"
done
rm -f ./*.csv ./*.ini v*

expect "a beam that leaves its channel, one thread" 0 moving-cantilever-mpm --steps 30 --every 7 --threads 1 \
	--series a.csv --particles p.csv --nodes n.csv --quiet
result "columns of its series" header a.csv \
	step,time,u_probe,v_probe,length,u_modal,v_modal,kinetic,strain,work,total
result "every seventh row and the last" sh -c 'test "$(cut -d, -f1 a.csv | tr "\n" " ")" = "step 0 7 14 21 28 30 "'
for threads in 2 3; do
	expect "$threads threads" 0 moving-cantilever-mpm --steps 30 --every 7 --threads $threads \
		--series b.csv --particles q.csv --nodes m.csv --quiet --force
	for pair in "a b" "p q" "n m"; do
		result "give the same bytes: ${pair% *}.csv" cmp "${pair% *}.csv" "${pair#* }.csv"
	done
done
expect "every row" 0 moving-cantilever-mpm --steps 30 --series c.csv --quiet
result "has those of every seventh in it" sh -c 'test "$(grep -c -x -F -f a.csv c.csv)" = 7'
expect "with a summary" 0 moving-cantilever-mpm-coarse --end 1e-4
result "the channel's work is no part of its energy" says out 'energy, first tenth to last, .* % of the start'
rm -f ./*.csv ./*.ini

# --- a change in mid-run, written down and given again ---
"$MATVIB" show supported-beam-mpm-coarse >changes.ini
printf '[changes]\n20 = mpm.algorithm=musl\n30 = mpm.flip_fraction=0.99\n' >>changes.ini
expect "with changes on its way" 0 changes.ini --steps 40 --series a.csv --quiet
expect "without" 0 supported-beam-mpm-coarse --steps 40 --series b.csv --quiet
result "the same up to there" sh -c 'head -n 22 a.csv >c && head -n 22 b.csv | cmp - c'
result "and not behind" sh -c '! cmp -s a.csv b.csv'
expect "what stands beside" 0 a.csv.ini --series d.csv --quiet
result "has the changes in it" cmp a.csv d.csv
rm -f ./*.csv ./*.ini c

# --- list, show, sweep, figure ---
subcommand=
"$MATVIB" list >listed
for name in supported-beam-mpm moving-cantilever-mpm moving-cantilever-hat supported-beam-duel; do
	for form in $name $name-coarse; do
		result "list: $form" says listed "^$form "
		"$MATVIB" show $form 2>/dev/null | grep -v '^#' >one.ini
		"$MATVIB" show one.ini 2>/dev/null | grep -v '^#' >two.ini
		result "show: $form gives itself" sh -c 'test -s one.ini && cmp one.ini two.ini'
	done
done
subcommand=sweep
expect "cells of two sizes" 0 supported-beam-mpm-coarse --vary mesh.cell_size=2.5e-3,1.25e-3 --with time.courant=1,1 --end 1e-3
result "each with its period" awk -F, 'NR == 1 { next } { d = $3 / $6 - 1; if (d * d > 4e-8) exit 1 } END { exit NR != 3 }' out
subcommand=figure
for view in beam probe energies; do
	expect "a figure of $view" 0 supported-beam-mpm-coarse --end 2e-5 --view $view --output $view.svg
	result "is a page" sh -c "grep -c '<text' $view.svg | grep -q '[0-9][0-9]'"
done

# --- a long run is told of and given up ---
subcommand=run
env --default-signal=INT "$MATVIB" run moving-cantilever-mpm --series i.csv >out 2>err &
long=$!
result "a long run gets going" soon sh -c 'ls | grep -q part'
soon works $long 30
kill -s INT $long
ends $long
result "is given up by ^C" test $? -eq 130
result "and leaves nothing" sh -c '! ls | grep -q i.csv'
echo "1..$number"

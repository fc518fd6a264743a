#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The numbers of every stage as tables: a row for each thing after each stage of some steps, so that an own code can
# be set beside it line by line. That they are the run's own: their last stage is the table of the whole step, their
# sums are those of the equations, and who looks changes nothing.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=run

header() { test "$(head -n 1 "$1")" = "$2"; }
# column FILE NAME: which one it is
column() { head -n 1 "$1" | tr ',' '\n' | grep -n -x "$2" | cut -d: -f1; }
# pick FILE STEP STAGE NAME...: columns of the rows of a stage
pick() {
	file=$1 step=$2 stage=$3
	shift 3
	places=
	for name in "$@"; do places=$places${places:+,}$(column "$file" "$name"); done
	awk -F, -v OFS=, -v step="$step" -v stage="$stage" -v places="$places" 'NR > 1 && $1 == step && $2 == stage {
		n = split(places, place, ",")
		line = $(place[1])
		for (i = 2; i <= n; i++) line = line "," $(place[i])
		print line
	}' "$file"
}
# total FILE STEP STAGE NAME: the sum of a column over all things
total() { pick "$@" | awk '{ sum += $1 } END { printf "%.10g\n", sum }'; }
# whole FILE NAME...: columns of a table at times
whole() {
	file=$1
	shift
	places=
	for name in "$@"; do places=$places${places:+,}$(column "$file" "$name"); done
	tail -n +2 "$file" | cut -d, -f"$places"
}
same() { test -s "$1" && cmp -s "$1" "$2"; }

# --- a bar ---
expect "a bar" 0 mode5 --steps 3 --stages 1:3 --particles p.csv --nodes n.csv --series s.csv --quiet
result "columns of particles" says p.csv '^step,stage,stage_id,particle,x0,x,u,v,stress,strain,density,mass'
result "columns of nodes" says n.csv '^step,stage,stage_id,node,x,mass,momentum,velocity,f_int,f_ext,f'
result "each particle after each of seven stages of three steps" lines p.csv $((3 * 7 * 50 + 1))
result "each node too" lines n.csv $((3 * 7 * 30 + 1))
result "stages have their names" test "$(cut -d, -f1-3 p.csv | tail -n +2 | uniq | head -n 3 | tr '\n' ' ')" = "1,1,map 1,2,fix 1,3,strain "
expect "the same without a look inside" 0 mode5 --steps 3 --particles q.csv --series t.csv --quiet
result "who looks changes nothing" same s.csv t.csv
for field in x v stress density; do
	pick p.csv 3 7 $field >a
	whole q.csv $field >b
	result "behind the last stage $field is that of the step" same a b
done
# eq. 2 and 3: the grid has the mass and the momentum of all particles
result "the grid has the mass" test "$(total n.csv 2 1 mass)" = "$(total p.csv 2 1 mass)"
pick p.csv 2 1 mass v | awk -F, '{ sum += $1 * $2 } END { printf "%.10g\n", sum }' >a
total n.csv 2 1 momentum >b
result "and the momentum" same a b
pick p.csv 2 1 v >a
pick p.csv 1 7 v >b
result "mapping changes no velocity of a particle" same a b
result "what stands beside says how" says p.csv.ini '^# written with --stages 1:3, which no scenario holds'
result "and what a row is" says p.csv.ini '^# stage \[1\]: so many stages are done of the step that leads to `step`$'
expect "that run again" 0 p.csv.ini --stages 1:3 --particles r.csv --quiet
result "the same bytes" same p.csv r.csv
expect "one step, far on" 0 mode5 --steps 700 --stages 640 --nodes m.csv --quiet
result "is there alone" test "$(tail -n +2 m.csv | cut -d, -f1 | sort -u)" = 640
expect "with a decimal comma" 0 mode5 --steps 1 --stages 1 --particles d.csv --dialect semicolon --quiet
result "in the same columns" says d.csv '^1;1;map;12;6,25;6,25;0;'

# --- beams, by bonds and by cells ---
expect "a beam" 0 supported-beam-coarse --set pd.spacing=1mm --set pd.horizon=4mm --steps 2 --stages 2:2 --particles f.csv --bonds g.csv --quiet
result "forces, which no table at times has" test -n "$(column f.csv fx)"
result "bonds at each stage" says g.csv '^step,stage,stage_id,'
# pull = c G w V s, V the square of the spacing; some are corrected, some cut
pick g.csv 2 4 c G w stretch pull | awk -F, '{ pull = $1 * $2 * $3 * 0.001 ^ 2 * $4; off = pull - $5
	if (off * off > 1e-24 * pull * pull) wrong++; corrected += $2 > 2; cut += $3 < 1; count++ }
	END { exit wrong || !corrected || !cut || !count }'
result "what a bond pulls with, from its c, G and w" test $? -eq 0
expect "a beam by cells" 0 supported-beam-mpm-coarse --steps 2 --stages 1:2 --particles h.csv --nodes k.csv --quiet
result "the grid has its mass" test "$(total k.csv 2 1 mass)" = "$(total h.csv 2 1 mass)"

# --- more columns of tables at times ---
expect "a field that tables leave out" 0 supported-beam-coarse --steps 2 --columns fx,fy --particles c.csv --quiet
result "is behind the others" test -n "$(column c.csv fx)" -a -n "$(column c.csv ux)"
result "to which moment a row of nodes belongs is said" sh -c '"$MATVIB" run mode1 --steps 2 --nodes e.csv --quiet &&
	grep -q "^# A row of step n has the values of the step that follows, after its stage [0-9]* (.*)\.$" e.csv.ini'

# --- refused ---
refuse "step 0" '--stages: FROM:TO, two numbers of steps from 1 on, not "0:3"' mode5 --stages 0:3 --particles z.csv
refuse "backwards" '--stages: FROM:TO, two numbers of steps from 1 on, not "3:1"' mode5 --stages 3:1 --particles z.csv
refuse "words" '--stages: FROM:TO, two numbers of steps from 1 on, not "1:all"' mode5 --stages 1:all --particles z.csv
refuse "beyond the end" '--stages: the run has 3 steps' mode5 --steps 3 --stages 1:4 --particles z.csv
refuse "no table" '--stages: which table? (--particles, --nodes, --bonds)' mode5 --stages 1:3 --series z.csv
refuse "and times" '--stages: in place of --frames' mode5 --stages 1:3 --particles z.csv --frames 3
result "nothing is left behind" test ! -e z.csv
echo "1..$number"

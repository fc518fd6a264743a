#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# export-lammps: the files and what is refused; where LAMMPS is installed, its probe beside ours.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=export-lammps

"$MATVIB" export-lammps notched-beam-coarse --output notched >/dev/null 2>&1
cp -r notched first
result "the script names the data" grep -q 'read_data data.matvib' notched/in.matvib
"$MATVIB" show notched-beam-coarse >resolved.ini
nodes=$(awk '/^Atoms/ { on = 1 } on && NF == 7 { n++ } END { print n }' notched/data.matvib)
result "an atom for each node" test "$nodes" -eq "$((210 * 70))"
result "the number of its bonds beside" test "$(wc -l <notched/bonds.matvib)" -eq "$((nodes + 1))"
result "no more beside" test "$(ls notched | wc -l)" -eq 3
refuse "files are not overwritten" 'notched/in.matvib: exists (--force replaces it)' notched-beam-coarse --output notched
result "unless it is said" "$MATVIB" export-lammps supported-beam-coarse --output notched --force
result "a bent beam has its displacements beside" test -s notched/uy.matvib
differs() { # SCENARIO PATTERN...: each is in the head of the script; behind - they are not
	"$MATVIB" export-lammps "$1" --output differs --force >/dev/null
	sed '/^$/q' differs/in.matvib >head
	wanted=yes
	shift
	for pattern in "$@"; do
		if [ "$pattern" = - ]; then wanted=no; continue; fi
		grep -q -e "$pattern" head && found=yes || found=no
		test $found = $wanted || { echo "$pattern: $found"; cat head; return 1; }
	done
}
result "the head says what differs: of a plate" differs branching-ornl 'pd.volume_correction=partial' 'largest critical stretch' \
	'still pulls once' c_damage short-range - 'surface correction' viscous 'at rest'
result "of a beam that comes to rest" differs hanging-beam 'pd.surface_correction=none' 'fix viscous' 'at rest, every 16 steps' \
	- 'critical stretch' 'pd.volume_correction'
# the step is that of the lattice without the correction, which matvib would find anew
step=$(sed -n 's/^#   and with time.step=\(.*\), the step of this script$/\1/p' notched/in.matvib)
result "and names the time step of the beam to compare with" grep -q -x "timestep $step" notched/in.matvib
result "bonds are made before they are counted" awk '/^run 0 post no/ { made = 1 } /^fix probe/ { exit !made }' first/in.matvib
refuse "a bar is refused" 'scenario.problem: LAMMPS gets beams and plates only (not bar)' mode1 --output bar
result "and leaves nothing" test ! -e bar
refuse "cells are refused" 'scenario.method: LAMMPS gets nodes with bonds only (pd)' supported-beam-mpm-coarse --output cells
refuse "bonds that soften with their length are refused" \
	'pd.influence: LAMMPS has bonds of one stiffness for every length (constant)' branching-coarse --set pd.influence=conical --output conical
refuse "bonds beyond the horizon are refused" \
	'pd.volume_correction: LAMMPS has no bonds longer than the horizon (none | partial)' branching-coarse --set pd.volume_correction=hhb --output beyond
printf '[changes]\n10 = load.stress=1e6\n' | cat resolved.ini - >changed.ini
refuse "changes in mid-run are refused" 'changes: LAMMPS gets runs without changes in mid-run only' changed.ini --output changed
refuse "a folder must be named" '--output: is missing (a folder)' notched-beam-coarse
refuse "a file is no folder" 'resolved.ini: is no folder' notched-beam-coarse --output resolved.ini

glass() {
	cat <<-END
		[scenario]
		problem = plate
		method = pd
		[plate]
		length = 0.04
		height = 0.02
		thickness = 0.001
		youngs_modulus = 65e9
		density = 2235
		[pd]
		spacing = 1e-3
		horizon = 3e-3
		surface_correction = none
	END
}
# everything that a plate may have, and neither symmetric nor on the way to break
plate() { # CUTS
	glass
	cat <<-END
		critical_stretch = 0
		[cuts]
		$1
		[loads]
		top = top 25% 75% 2e6 12e6 ramp 8e-6
		bottom = bottom 0% 100% 0 -6e6 until 12e-6
		right = right 0% 60% 3e6 1e6
		[supports]
		held = 0 0 1e-3 20e-3 uy 0
		pulled = 0 0 1e-3 8e-3 ux -2
		[impulses]
		struck = 32e-3 14e-3 36e-3 18e-3 3 -5
		[protected]
		corner = 0 0 12e-3 8e-3
		[probe]
		x = 62%
		y = 70%
		[time]
		step = 1e-7
		end = 4e-5
	END
}
plate 'slanted = 9e-3 6e-3 21e-3 13e-3
upright = 30e-3 0 30e-3 9e-3' >plate.ini
# many cuts, some across each other, and nearer than a horizon
plate "$(awk 'BEGIN { srand(3); for (k = 0; k < 16; k++) printf "c%d = %g%% %g%% %g%% %g%%\n", k,
	100 * rand(), 100 * rand(), 100 * rand(), 100 * rand() }')" >cuts.ini

# types that LAMMPS leaves out are those of the bonds that are cut, and of no others
apart() {
	awk 'FILENAME == "cut/in.matvib" { if ($2 == "exclude") out[$4, $5] = out[$5, $4] = 1; next }
		FILENAME == "cut/data.matvib" { if (NF == 7) type[$1 - 1] = $2; next }
		FNR == 1 { split($0, names, ","); for (k in names) at[names[k]] = k; FS = ","; next }
		{ split($0, c, ","); cut = c[at["broken_at"]] == 0; n += cut; m += !cut
		  wrong += (type[c[at["i"]]], type[c[at["j"]]]) in out != cut }
		END { print n " cut, " m " not, " wrong + 0 " wrong"; exit !(n > 1000 && m > 5000 && wrong == 0) }' \
		cut/in.matvib cut/data.matvib cut.csv
}
"$MATVIB" export-lammps cuts.ini --set pd.critical_stretch=.4 --output cut >/dev/null
"$MATVIB" run cuts.ini --set pd.critical_stretch=.4 --steps 1 --bonds cut.csv --quiet
result "types part the bonds that are cut, and no others" apart
counted() {
	awk 'FILENAME == "cut/bonds.matvib" { if (FNR > 1) left[$1 - 1] = $2; next }
		FNR == 1 { split($0, names, ","); for (k in names) at[names[k]] = k; FS = ","; next }
		{ split($0, c, ","); if (c[at["broken_at"]] != 0) { left[c[at["i"]]]--; left[c[at["j"]]]-- } }
		END { for (k in left) { n++; wrong += left[k] != 0 } print n " nodes, " wrong + 0 " wrong"; exit !(n == 800 && wrong == 0) }' \
		cut/bonds.matvib cut.csv
}
result "the bonds of each node are counted without those" counted
protected_last() {
	first=$(sed -n 's/^pair_coeff \* \([0-9][0-9]*\)\* .*/\1/p' cut/in.matvib)
	awk -v first="$first" 'NF == 7 { inside = $5 < .012 && $6 < .008; n += inside; wrong += inside != ($2 >= first) }
		END { exit !(n == 12 * 8 && wrong == 0) }' cut/data.matvib
}
result "those that never break come last" protected_last

# the corner at the right below: density times 1 + alpha dt/2, and alpha dt/2 of the first half kick at rest
"$MATVIB" export-lammps plate.ini --set damping.rate=20000 --output braking >/dev/null
braked() {
	awk '$1 != 40 { next }
		NF == 7 { density = $4 / 2235 - 1.001 }
		NF == 4 { x = $2 / (1e-3 * 5e-8 * 3e9 / 2235) - 1; y = $3 / (1e-3 * 5e-8 * -5e9 / 2235) - 1 }
		END { print density, x, y; exit !(density * density + x * x + y * y < 1e-18) }' braking/data.matvib
}
result "damping is in density and first velocities" braked

# the largest difference of each column that both have, over its largest value, is below the limit, of a
# displacement a twentieth of it: nine digits and seven, as the manual says
agree() { # LIMIT THEIRS OURS
	awk -F, -v limit="$1" '
		FNR == 1 { file++; for (k = 1; k <= NF; k++) name[file, k] = $k; next }
		file == 1 { rows[$1]; for (k = 2; k <= NF; k++) theirs[$1, name[1, k]] = $k; next }
		$1 in rows && $1 > 0 {
			n++
			for (k = 2; k <= NF; k++) {
				c = name[2, k]
				if (!(($1, c) in theirs)) continue
				d = theirs[$1, c] - $k; if (d < 0) d = -d; a = $k < 0 ? -$k : $k
				if (d > most[c]) most[c] = d; if (a > size[c]) size[c] = a
			}
		}
		END {
			for (c in size) { columns++; print c " off by " most[c] ", largest " size[c]; bad += most[c] > limit * size[c] / (c ~ /^u/ ? 20 : 1) }
			exit !(n > 100 && columns >= 3 && !bad)
		}' "$2" "$3"
}
ran() { cd "$1" && OMP_NUM_THREADS=1 lmp -in in.matvib -screen none; }
both() { # NAME ARGUMENTS...: theirs to NAME/probe.csv, ours to NAME.csv
	name=$1
	shift
	"$MATVIB" export-lammps "$@" --output "$name" >/dev/null
	"$MATVIB" run "$@" --series "$name.csv" --quiet
	(ran "$name") >/dev/null 2>&1
}

# the physics that both have: no surface correction, nothing breaks
motion() { # NAME ARGUMENTS...
	if command -v lmp >/dev/null 2>&1; then
		both "$@" --set pd.surface_correction=none
		result "$1 moves in LAMMPS as here" agree 1e-7 "$1/probe.csv" "$1.csv"
	else
		skip "$1" "lmp is not installed"
	fi
}
motion supported supported-beam-coarse --steps 400
motion moving moving-cantilever-coarse --steps 400
motion notched-whole notched-beam-coarse --steps 400 --set pd.critical_stretch=0
motion plate plate.ini
motion damped plate.ini --set damping.rate=20000
motion heavy supported-beam-coarse --steps 400 --set load.body_force=-9.81e4
motion braked moving-cantilever-coarse --steps 400 --set damping.rate=20000 --set initial.amplitude=3e-5

{
	glass
	cat <<-END
		critical_energy = 204
		[cuts]
		notch = 0 50% 30% 50%
		[loads]
		top = top 0% 100% 0 14e6
		bottom = bottom 0% 100% 0 -14e6
		[probe]
		x = 50%
		y = 90%
		[time]
		end = 2e-5
	END
} >breaks.ini
# broken bonds: the first alike in both, and nearly as many at the end
counts() { # LIMIT THEIRS OURS
	awk -F, -v limit="$1" '
		FNR == 1 { file++; for (k = 1; k <= NF; k++) if ($k == "broken_bonds") at = k; next }
		file == 1 { theirs[$1] = $at; next }
		$1 == 0 { none = theirs[$1] == 0 && $at == 0 }
		theirs[$1] + $at > 0 && !broken { broken = 1; first = $1; alike = theirs[$1] == $at }
		{ ours = $at; last = $1 }
		END {
			d = (theirs[last] - ours) / ours; if (d < 0) d = -d
			print "first at " first ", at the end " theirs[last] " and " ours
			exit !(none && first > 1 && alike && ours > 100 && d < limit)
		}' "$2" "$3"
}
# LAMMPS breaks a bond one step later, so the two part by an amount of first order in the time step
off() { # THEIRS OURS: the largest difference of u_probe over its largest value
	awk -F, 'FNR == 1 { file++; next } file == 1 { u[$1] = $3; next }
		{ d = u[$1] - $3; if (d < 0) d = -d; if (d > most) most = d; a = $3 < 0 ? -$3 : $3; if (a > size) size = a }
		END { print most / size }' "$1" "$2"
}
first_order() {
	coarse=$(off coarse/probe.csv coarse.csv) fine=$(off fine/probe.csv fine.csv)
	echo "off by $coarse, with a fifth of the step by $fine"
	awk -v a="$coarse" -v b="$fine" 'BEGIN { exit !(a < .25 && a / b > 4 && a / b < 6.5) }'
}
if command -v lmp >/dev/null 2>&1; then
	both coarse breaks.ini --set time.step=1e-7
	both fine breaks.ini --set time.step=2e-8
	result "bonds break in LAMMPS as here" counts 0.02 fine/probe.csv fine.csv
	result "a bond breaks one step later there" first_order
	both rest hanging-beam --set pd.surface_correction=none --set pd.spacing=2.5mm --set pd.horizon=7.5mm --set time.step=5e-7
	result "a damped beam comes to rest in the same step" grep -q "^Loop time of .* for $(tail -n 1 rest.csv | cut -d, -f1) steps" rest/log.lammps
	result "in the same place" agree 1e-5 rest/probe.csv rest.csv
else
	skip "bonds break in LAMMPS as here" "lmp is not installed"
fi

# a disk that takes no more in the middle of a file, a signal while it works: nothing stays behind
(ulimit -f 64 && exec "$MATVIB" export-lammps notched-beam --output ended) >out 2>err
result "a file that cannot grow ends it" test $? -eq 1
result "in a line" says err '^matvib: ended/data.matvib: cannot be written: '
result "and leaves no folder" test ! -e ended
"$MATVIB" export-lammps supported-beam --set beam.length=2 --output ended >/dev/null 2>&1 &
soon works $! 20
kill -TERM $!
ends $!
result "a signal ends it with its status" test $? -eq 143
result "and leaves no folder" test ! -e ended
echo "1..$number"

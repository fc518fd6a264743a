#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# export-lammps: the files and what is refused; where LAMMPS is installed, its probe beside ours.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=export-lammps

"$MATVIB" export-lammps notched-beam-coarse --output notched >/dev/null 2>&1
result "the script names the data" grep -q 'read_data data.matvib' notched/in.matvib
"$MATVIB" show notched-beam-coarse >resolved.ini
nodes=$(awk '/^Atoms/ { on = 1 } on && NF == 7 { n++ } END { print n }' notched/data.matvib)
result "an atom for each node" test "$nodes" -eq "$((210 * 70))"
result "no more beside" test "$(ls notched | wc -l)" -eq 2
refuse "files are not overwritten" 'notched/in.matvib: exists (--force replaces it)' notched-beam-coarse --output notched
result "unless it is said" "$MATVIB" export-lammps supported-beam-coarse --output notched --force
result "a bent beam has its displacements beside" test -s notched/uy.matvib
refuse "a bar is refused" 'scenario.problem: LAMMPS gets beams only (not bar)' mode1 --output bar
result "and leaves nothing" test ! -e bar
refuse "a folder must be named" '--output: is missing (a folder)' notched-beam-coarse
refuse "a file is no folder" 'resolved.ini: is no folder' notched-beam-coarse --output resolved.ini

# the largest difference of the probe's motion, over its largest value, is below the limit
agree() {
	awk -F, -v limit="$1" '
		FNR == 1 { file++; next }
		file == 1 { u[$1] = $3; v[$1] = $4; next }
		$1 in u {
			n++
			du = u[$1] - $3; dv = v[$1] - $4
			if (du < 0) du = -du; if (dv < 0) dv = -dv
			au = $3 < 0 ? -$3 : $3; av = $4 < 0 ? -$4 : $4
			if (du > most_u) most_u = du; if (dv > most_v) most_v = dv
			if (au > size_u) size_u = au; if (av > size_v) size_v = av
		}
		END {
			print n " rows, u off by " most_u / size_u ", v by " most_v / size_v
			exit !(n > 100 && most_u < limit * size_u && most_v < limit * size_v)
		}' "$2" "$3"
}
ran() { cd "$1" && OMP_NUM_THREADS=1 lmp -in in.matvib -screen none; }

# the physics that both have: no surface correction, nothing breaks
for scenario in supported-beam-coarse moving-cantilever-coarse notched-beam-coarse; do
	if ! command -v lmp >/dev/null 2>&1; then
		skip "$scenario" "lmp is not installed"
		continue
	fi
	set -- "$scenario" --set pd.surface_correction=none --steps 400
	[ $scenario = notched-beam-coarse ] && set -- "$@" --set pd.critical_stretch=0
	"$MATVIB" export-lammps "$@" --output $scenario >/dev/null
	"$MATVIB" run "$@" --series $scenario.csv --quiet
	(ran $scenario) >/dev/null 2>&1
	result "$scenario moves in LAMMPS as here" agree 1e-7 $scenario/probe.csv $scenario.csv
done

# ended by a signal while it writes: nothing stays behind
"$MATVIB" export-lammps notched-beam --output ended >/dev/null 2>&1 &
asked=0
while [ -z "$(ls -A ended 2>/dev/null)" ] && [ $asked -lt 5000 ]; do
	asked=$((asked + 1))
	sleep 0.002
done
kill -TERM $!
wait $!
result "a signal ends it with its status" test $? -eq 143
result "and leaves no folder" test ! -e ended
echo "1..$number"

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# matvib diagnose as people type it: what it says of files of every kind, and what it refuses. That it is right on any
# setting is tried by check_diagnose.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=diagnose
make() { # FILE ARGUMENTS...
	file=$1
	shift
	rm -f "$file" # which another program may have written, so that --force would spare it
	"$MATVIB" run "$@" --quiet --force --series "$file"
}
digits() { # N COLUMNS <FILE: these columns with so many digits
	awk -F, -v n="$1" -v wanted="$2" 'NR == 1 { k = split(wanted, w, ","); for (i = 1; i <= NF; i++) at[$i] = i; print wanted; next }
		{ for (i = 1; i <= k; i++) printf "%s%s", (w[i] == "step" ? $at[w[i]] : sprintf("%." n "g", $at[w[i]])), (i < k ? "," : "\n") }'
}

# Codes that share no line with ours: those of tests/independent, where there is a python3 with numpy.
python=
for one in python3 /usr/bin/python3; do "$one" -c 'import numpy' 2>/dev/null && python=$one && break; done
settings_of() { # CASE
	awk -v name="$1" '$1 == "case" { on = $2 == name } on && $1 == "set" { printf "--set %s=%s ", $2, $3 }' "$MATVIB_SRCDIR/tests/golden/mistakes.txt"
}
independent() { # CASE SCENARIO ROWS MISTAKE...
	case=$1 scenario=$2 rows=$3
	shift 3
	for mistake; do
		"$python" -B "$MATVIB_SRCDIR/tests/independent/mistakes.py" --mistake "$mistake" "$case" "$rows" >np.csv 2>/dev/null
		# the energy correction calibrates the micromodulus: such a code is right there, and the answer tells of it
		case $mistake in micromodulus_*) status=0 ;; *) status=1 ;; esac
		# shellcheck disable=SC2046
		expect "$mistake by numpy" $status "$scenario" $(settings_of "$case") np.csv
		result "$mistake by numpy: is named" says out "^  $mistake"
	done
}
if [ -n "$python" ]; then
	# that of force_sign blows up, and round-off with it
	bars="force_sign x_by_own_velocity density_kept" beams=${MATVIB_WIDE:+stretch_of_current micromodulus_3d}
	if [ -n "$MATVIB_LONG" ]; then
		bars=$(awk '$1 == "case" { on = $2 == "bar_B" } on && $1 == "mistake" && $2 != "right" && !seen[$2]++ { print $2 }' \
			"$MATVIB_SRCDIR/tests/golden/mistakes.txt")
		beams=$(sed -n 's/^MISTAKE("\([a-z_0-9]*\)".*/\1/p' "$MATVIB_SRCDIR/src/methods/bonds/plane/bonds_mistake_rows.inc")
	fi
	# shellcheck disable=SC2086
	independent bar_B mode5 300 $bars
	# shellcheck disable=SC2086
	independent beam supported-beam 30 $beams
	# a stretch of two lengths less each other loses digits, and is no mistake; that of one fraction is as good as ours
	for stretch in naive_stretch right; do
		"$python" -B "$MATVIB_SRCDIR/tests/independent/mistakes.py" --mistake $stretch beam_plain 30 >np.csv
		# shellcheck disable=SC2046
		expect "a beam by numpy, $stretch" 0 supported-beam $(settings_of beam_plain) np.csv
		result "is right" says out "^Your numbers are those of the right code, to 1[0-6] digits over 31 rows"
		[ $stretch = right ] || result "and hears what it loses" says out '^No more digits are possible where a bond.s |y| - |xi| is taken without rearranging: that is round-off, not a mistake\.$'
		[ $stretch = naive_stretch ] || result "and loses nothing" sh -c '! grep -q "No more digits are possible" out'
	done
	# right codes by one kick a step, and their mistakes; from rest v alone does not tell the two of Euler apart
	for stepping in "euler:symplectic Euler (kick first)" ${MATVIB_WIDE:+"euler_position:symplectic Euler (kick first)" "leapfrog:leapfrog (v half a step behind)" "leapfrog_ahead:leapfrog (v half a step ahead)"}; do
		case=beam_${stepping%%:*} scheme=${stepping#*:}
		"$python" -B "$MATVIB_SRCDIR/tests/independent/mistakes.py" --mistake right "$case" 30 >np.csv
		# shellcheck disable=SC2046
		expect "a beam by ${stepping%%:*}" 0 supported-beam $(settings_of beam) np.csv
		result "is right, by its name" grep -q -F "Right, $scheme, surface energy" out
		"$python" -B "$MATVIB_SRCDIR/tests/independent/mistakes.py" --mistake horizon_as_diameter "$case" 12 >np.csv
		# shellcheck disable=SC2046
		expect "a mistake by ${stepping%%:*}" 1 supported-beam $(settings_of beam) np.csv
		result "is named in that scheme" grep -q -F "Mistake: horizon_as_diameter ($scheme" out
	done
	for mistake in counted_twice ${MATVIB_WIDE:+one_way force_not_reset}; do # the bar by bonds
		"$python" -B "$MATVIB_SRCDIR/tests/independent/mistakes.py" --mistake $mistake bar_bonds_euler 30 >np.csv
		# shellcheck disable=SC2046
		expect "a bar of bonds by euler, $mistake" 1 mode5 $(settings_of bar_bonds) np.csv
		result "is named in that scheme" grep -q "^  $mistake: " out
	done
else
	skip "codes of numpy" "no python3 with numpy"
fi

# Bodies: every mistake of the plane is named, a scheme that keeps angular momentum is not taken for the exact answer,
# momenta that cancel to round-off tell nothing, and neither does another code's round-off.
coarse_cells="--set mesh.cell_size=0.1" # an eighth of the work
for mistake in none $(sed -n 's/^MISTAKE("\([a-z_]*\)".*/\1/p' "$MATVIB_SRCDIR/src/methods/mpm/bodies_mistake_rows.inc"); do
	# shellcheck disable=SC2086
	make bodies.csv two-discs-off-centre $coarse_cells --end 0.6 --set "mpm.body_mistake=$mistake"
	status=1
	[ "$mistake" = none ] && status=0
	# shellcheck disable=SC2086
	expect "bodies, $mistake" $status two-discs-off-centre $coarse_cells bodies.csv
	[ "$mistake" = none ] || result "bodies, $mistake: is named" says out "^Mistake: $mistake (USF, gimp)\.\$"
	[ "$mistake" != none ] || result "bodies, right" says out '^Right, USF, gimp\.$'
done
# shellcheck disable=SC2086
make bodies.csv two-discs-off-centre $coarse_cells --end 0.6 --set mpm.algorithm=musl --set mpm.transfer=apic
# shellcheck disable=SC2086
expect "bodies by MUSL and APIC" 0 two-discs-off-centre $coarse_cells bodies.csv
result "are right, by that scheme" says out '^Right, MUSL, gimp, apic\.$'
make bodies.csv two-discs-off-centre --end 0.6
awk -F, -v OFS=, -v OFMT=%.17g 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
	NR > 1 { $at["momentum_x"] = sprintf("%.3g", 3e-15 * sin(NR)) } { print }' bodies.csv >noise.csv
expect "momenta of round-off" 0 two-discs-off-centre noise.csv
if [ -n "$python" ]; then
	for mistake in right normal_of_one; do
		"$python" -B "$MATVIB_SRCDIR/tests/independent/mistakes.py" --mistake $mistake bodies 60 >np.csv 2>/dev/null
		status=1
		[ $mistake = right ] && status=0
		expect "bodies by numpy, $mistake" $status two-discs-off-centre np.csv --set contact.friction=0.3 \
			--set "bodies.left=disc 0.3 0.45 0.2 velocity 0.2 0 spin 0.5" --set "bodies.right=disc 0.72 0.6 0.2 velocity -0.2 0"
	done
	result "and it is named" says out '^Mistake: normal_of_one '
fi

make right.csv mode5 --steps 50
expect "the right numbers" 0 mode5 right.csv
result "are said to be right" says out '^Your numbers are those of the right code, to 16 digits over 51 rows\.$'
result "and what they hide" says out '^  gradient_without_h (--set mesh.cell_size=0.5 distinguishes them)$'
digits 6 step,v_cm <right.csv >six.csv
expect "six digits of them" 0 mode5 six.csv
result "are judged by six" says out 'to 6 digits over 51 rows'
result "and hide more" says out '^  mass_of_cell (the column kinetic distinguishes them)$'

awk -F, 'NR == 1 { print "step,time,v_cm" } NR > 1 { printf "%d,%.4g,%s\n", $1, $2 * 1.03 / 3600, $3 }' right.csv >hours.csv
expect "times in hours, 3 % too long" 1 mode5 hours.csv --map 'time=time*3600'
result "tell another time step" sh -c 'grep -q "^Read as: v_cm; dt 0.0103" out && ! grep -q "those of the right code, to" out'
"$MATVIB" run mode5 --steps 60 --frames 4 --particles speeds-of.csv --quiet
awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } { print $1, $at["particle"], $at["v"] }' speeds-of.csv >speeds.csv
expect "velocities of particles" 0 mode5 speeds.csv
result "hide what another of their columns tells" says out '^  mass_of_cell (the column mass distinguishes them)$'

make own.csv mode5 --steps 50 --set mpm.mistake=x_by_own_velocity
digits 17 step,v_cm <own.csv >own17.csv
expect "a silent mistake" 1 mode5 own17.csv
result "is named" says out '^  x_by_own_velocity: A particle moves with its own velocity'
result "with its line" says out '^  stage 6, update particles: .*>>v_p<<$'
result "and where it shows first" says out '^They first depart at step 2, row 3, column v_cm:$'
head -n 4 own17.csv >three.csv
expect "three steps of it" 1 mode5 three.csv
result "are enough" says out '^  x_by_own_velocity: '
make offset.csv mode5 --steps 50 --set initial.offset=0.3
expect "an offset between those that a nudge comes to" 1 mode5 offset.csv
result "is found" says out '^  initial\.offset=0\.3: another value, the scenario has 0\.$'
make vol.csv mode5 --steps 50 --set mpm.mistake=volume_of_cell
digits 6 step,v_cm <vol.csv >vol6.csv
expect "rivals" 1 mode5 vol6.csv
result "are all named" sh -c 'grep -q "^  volume_of_cell: " out && grep -q "^  bar.youngs_modulus=200: another value, the scenario.s 100 times 2 = P" out'
result "with the column that tells" says out '^  (the column strain distinguishes them: let your code write it, then$'
result "and the command" says out '^  matvib diagnose mode5 vol6.csv)$'
result "and the factor" says out 'by the right amount times 2 = P, the particles in a cell$'
make start.csv mode5 --steps 50 --set mpm.mistake=mode_of_fixed_fixed
expect "a wrong start" 1 mode5 start.csv
result "is told from a wrong loop" says out 'No step is done yet: what is wrong is the start'

make soft.csv mode5 --steps 50 --set bar.youngs_modulus=93.25 --set time.courant=0.09656603957913985
digits 9 step,time,v_cm,kinetic <soft.csv >soft9.csv
expect "a wrong value" 1 mode5 soft9.csv
result "is found" says out '^  bar.youngs_modulus=93.25: another value'
make odd.csv mode5 --steps 50 --set bar.youngs_modulus=93.25
awk -F, 'NR == 1 { print "step,time,v_cm,kinetic" } NR > 1 { printf "%d,%.4f,%s,%s\n", $1, $2, $3, $7 }' odd.csv >odd4.csv
expect "a wrong value, its time step with few digits" 1 mode5 odd4.csv
result "is found too" says out '^  bar.youngs_modulus=93.25: another value'
make usl.csv mode5 --steps 50 --set mpm.algorithm=usl
expect "another scheme" 0 mode5 usl.csv
result "is right" sh -c 'grep -q "^Right, USL.$" out && ! grep -q "depart" out'
make clamped.csv mode5 --steps 50 --set bar.supports=free-fixed
expect "another support" 1 mode5 clamped.csv
result "is the one thing that is wrong" says out '^Mistake: bar\.supports=free-fixed (USF)\.$'
result "and no choice of a scheme" says out '^  bar\.supports=free-fixed: another value, the scenario has fixed-free\.$'
make blended.csv mode5 --steps 50 --set mpm.flip_fraction=0.5
expect "a share that the scenario has at its bound" 0 mode5 blended.csv
result "is a scheme" says out '^Right, USF, flip_fraction 0\.5\.$'
make blended.csv mode5 --steps 50 --set mpm.flip_fraction=0.95 --set mpm.algorithm=usl --set mpm.shape=gimp
expect "a share in another scheme" 0 mode5 blended.csv
result "is one too" says out '^Right, USL, gimp, flip_fraction 0\.95\.$'
make longest.csv mode5-peridynamics --steps 50 --set pd.stepping=euler_position --set pd.surface_correction=energy --set pd.volume_correction=partial --set pd.influence=conical
expect "a scheme of the longest name" 0 mode5-peridynamics longest.csv
result "is named in full" says out '^Right, symplectic Euler (move first), surface energy, volume partial, influence conical\.$'
make pushing.csv mode5 --steps 50 --set mpm.algorithm=usl --set mpm.shape=gimp --set mpm.mistake=force_sign
awk -F, 'NR == 1 { print "t/ms,v_cm" } NR > 1 { print 1000 * $2 "," $3 }' right.csv >ms.csv
expect "a head with its unit behind a stroke" 0 mode5 ms.csv
result "is read" says out '^Read as: v_cm; times in ms; dt 0\.01$'
for head in "sim time (ms),v_cm" "time in ms,v_cm" "time (ms) v_cm"; do
	awk -F, -v head="$head" -v comma="$(echo "$head" | tr -cd ,)" 'NR == 1 { print head } NR > 1 { print 1000 * $2 (comma ? "," : " ") $3 }' right.csv >ms.csv
	expect "the head $head" 0 mode5 ms.csv
	result "has a unit" says out '^Read as: v_cm; times in ms; dt 0\.01$'
done
expect "a mistake in another scheme" 1 mode5 pushing.csv
result "is named with its scheme" says out '^Mistake: force_sign (USL, gimp)\.$'
small="--set beam.length=0.02 --set beam.height=0.002 --set pd.spacing=0.0005 --set pd.horizon=0.0015 --set time.step=5e-8"
# shellcheck disable=SC2086
make wide.csv supported-beam $small --steps 12 --set pd.horizon=0.0015075
# shellcheck disable=SC2086
expect "a horizon that is longer by a little" 0 supported-beam $small wide.csv
result "is right too" says out "^Right, surface energy, volume partial"
# shellcheck disable=SC2086
make plain.csv supported-beam $small --steps 12 --set pd.surface_correction=none --set pd.volume_correction=none
# shellcheck disable=SC2086
expect "a plate without corrections" 0 supported-beam $small plain.csv
result "is right, and what it leaves out is told" says out '^Right, no corrections\.$'
for id in one_way_row_major u_added_twice stretch_without_length; do
	# shellcheck disable=SC2086
	make wrong_$id.csv supported-beam $small --steps 12 --set pd.mistake=$id
	# shellcheck disable=SC2086
	expect "a plate with $id" 1 supported-beam $small wrong_$id.csv
	result "is named: $id" says out "^Mistake: $id"
done
# half of each force by symplectic Euler is the same code
# shellcheck disable=SC2086
make wrong_kick.csv supported-beam $small --steps 12 --set pd.mistake=no_second_kick
# shellcheck disable=SC2086
expect "a plate without its second half kick" 1 supported-beam $small wrong_kick.csv
result "has two names" says out "^One of: no_second_kick, half_bond"
make dt.csv mode5 --steps 50 --set time.courant=0.07
expect "another time step" 0 mode5 dt.csv
result "is taken from the file" sh -c 'grep -q "; dt 0.007 (the scenario.s is 0.01)$" out && grep -q "those of the right code" out'
cut -d, -f2,3 dt.csv >times.csv
expect "times alone" 0 mode5 times.csv
result "tell it too" sh -c 'grep -q "^Read as: v_cm; dt 0.007 (the" out && grep -q "those of the right code" out'
awk -F, 'NR == 1 { print "n;vcm" } NR > 1 { v = sprintf("%.12g", 1000 * $3); sub(/\./, ",", v); print $1 ";" v }' right.csv >units.csv
(printf 'sep=;\r\n' && cat units.csv) >sep.csv
expect "a separator that is told to a spreadsheet" 0 mode5 sep.csv
expect "other names, signs and units" 0 mode5 units.csv
result "are read" sh -c 'grep -q "^Read as: vcm: v_cm, in thousandths; dt 0.01$" out && grep -q "those of the right code" out'
sed 's/v_cm/speed/; s/,v_cm.*//' units.csv | sed 's/vcm/speed/' >map.csv
expect "a column by --map" 0 mode5 map.csv --map 'speed=v_cm*0.001'
result "is compared" says out 'those of the right code, to 1[12] digits'
awk -F, 'NR == 1 { print "step,v_cm" } NR > 1 { print $1 + 1 "," $3 }' right.csv >one.csv
expect "rows counted from 1" 0 mode5 one.csv
result "are told" sh -c 'grep -q "^Read as: v_cm; rows carry the time after their step; dt 0.01$" out && grep -q "those of the right code" out'
make stiff.csv mode5 --steps 50 --set bar.youngs_modulus=250 --set bar.density=1.2
awk -F, 'NR > 1 && NR % 2 == 0 { print $1, $3 }' stiff.csv >second.csv
expect "every second step without heads" 0 mode5 second.csv --set bar.youngs_modulus=250 --set bar.density=1.2
result "is no time" says out '; dt 0\.00692820323, a row every 2 steps$'
awk -F, 'NR == 1 { print "t,v" } NR > 2 { printf "%g,%s\n", $2 - .01, $3 }' right.csv >before.csv
expect "times before their step" 0 mode5 before.csv
result "are told too" sh -c 'grep -q "^Read as: v: v_cm; rows carry the time before their step; dt 0.01$" out && grep -q "those of the right code" out'
awk -F, 'NR == 1 { print "t,v_cm" } NR > 1 { printf "%g,%.9g\n", $2, $3 + 1e-5 * cos(NR * NR) }' right.csv >disturbed.csv
expect "times of noise" 1 mode5 disturbed.csv
result "are as they stand" says out '^Read as: v_cm; dt 0.01$'
awk -F, 'NR == 1 { print "step,v_cm" } NR > 1 { print $1 "," $3 * (1 + $1 * $1 * 1e-4) }' right.csv >wild.csv
expect "numbers of no code" 1 mode5 wild.csv
result "are not blamed on one" sh -c 'grep -q "^None of [0-9]* other codes gives these numbers" out && grep -q "stages 1:1" out'

make s.csv mode5 --steps 3
for table in particles nodes; do
	"$MATVIB" run mode5 --steps 3 --frames 4 --set mpm.mistake=moved_weights --$table t.csv --quiet --force
	expect "a table of $table" 1 mode5 t.csv
	result "tells as much" says out '^  moved_weights: '
	"$MATVIB" run mode5 --steps 2 --stages 1:2 --set mpm.mistake=half_first_kick --$table t.csv --quiet --force
	expect "$table after stages" 1 mode5 t.csv
	result "tell as much" says out '^  half_first_kick: '
	result "and the stage" says out "after stage [46] "
done
result "of the nodes' force" says out '^They first depart at step 1, after stage 4 (force), node 0, row 91, column f_int:$'
awk -F, -v OFS=, 'NR == 1 { $3 = ""; print } NR > 1 { $3 = "x"; print }' t.csv | cut -d, -f1,2,4- >numbers.csv
expect "stages by number" 1 mode5 numbers.csv
result "are as good as by name" says out '^  half_first_kick: '
thin="--set beam.length=10mm --set beam.height=1mm"
# shellcheck disable=SC2086
make wild.csv supported-beam-coarse $thin --steps 9
awk -F, 'NR == 1 { print "step,v_probe" } NR > 1 { print $1 "," $4 * (1 + $1 * $1 * 1e-4) }' wild.csv >bent.csv
# shellcheck disable=SC2086
expect "numbers of no beam" 1 supported-beam-coarse $thin bent.csv
result "say what was not tried" says out '^Two mistakes at once, or one beside four other choices, were not tried (--pairs)\.$'
# shellcheck disable=SC2086
expect "two mistakes of a beam at once" 1 supported-beam-coarse $thin bent.csv --pairs
result "are tried then" sh -c 'grep -q "^None of" out && ! grep -q "not tried" out'
# a beam is built for each code: beside one or two wrong numbers few are tried
# shellcheck disable=SC2086
make whole.csv supported-beam-coarse $thin --steps 40
for wrong in 1 2; do
	awk -F, -v wrong=$wrong 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; print "time,u_probe"; next }
		{ t[NR] = $at["time"]; u[NR] = $at["u_probe"] }
		END { for (k = 2; k <= NR; k++) printf "%s,%.17g\n", t[k], (k > NR - wrong ? 1.0123 * u[k] : u[k]) }' whole.csv >last.csv
	# shellcheck disable=SC2086
	expect "the last numbers of a beam ($wrong)" 1 supported-beam-coarse $thin last.csv
	result "are soon judged" sh -c 'n=$(sed -n "s/^None of \([0-9]*\) other codes.*/\1/p" out) && [ "$n" -gt 0 ] && [ "$n" -lt 1500 ]'
done
# a value beside the right one that no run can have is not tried
thick="--set beam.length=15mm --set beam.height=3mm"
# shellcheck disable=SC2086
make whole.csv supported-beam-coarse $thick --steps 2
awk -F, 'NR == 1 { print "step,v_probe" } NR > 1 { print $1 "," 1.05 * $4 }' whole.csv >fast.csv
# shellcheck disable=SC2086
expect "numbers of no beam of six rows" 1 supported-beam-coarse $thick fast.csv
result "are of none of its neighbours" says out '^None of [0-9]* other codes gives these numbers'
# shellcheck disable=SC2086
"$MATVIB" run supported-beam-coarse $thin --steps 2 --set pd.mistake=one_way --bonds b.csv --particles p.csv --quiet
# shellcheck disable=SC2086
expect "bonds" 1 supported-beam-coarse $thin b.csv
result "tell a beam's mistake" says out '^  one_way: A bond pulls at its left end only'
awk -F, -v OFS=, 'NR > 1 { $3++ } 1' p.csv >p1.csv
# shellcheck disable=SC2086
expect "particles counted from 1" 1 supported-beam-coarse $thin p1.csv
result "are told" sh -c 'grep -q "particle 1 is our particle 0" out && grep -q "^  one_way: " out'

awk -F, 'NR == 1 { print "step,v_cm" } NR > 1 { print $1 "," $4 }' right.csv >exact.csv
expect "the exact answer" 1 mode5 exact.csv
result "is no run" says out '^This is the exact answer, not a run'
"$MATVIB" run mode5 --steps 20 --frames 3 --particles place.csv --quiet
awk -F, -v OFS=, 'NR == 1 { print "step,particle,x0,u,v,mass" } NR > 1 { b = 4.5 * 3.14159265358979312 / 25; w = 10 * b
	print $1, $3, $4, sprintf("%.15g,%.15g,%s", 0.1 / w * sin(w * $2) * sin(b * $4), 0.1 * cos(w * $2) * sin(b * $4), 0.5) }' place.csv >profile.csv
expect "the exact profile of particles" 1 mode5 profile.csv
result "is no run" sh -c 'grep -q "^(its column u is the exact profile" out && grep -q "^This is the exact answer, not a run" out'
expect "particles of a run" 0 mode5 place.csv
result "are of a run" says out '^Your numbers are those of the right code'
awk -F, 'NR == 1 { print "step,v_cm" } NR > 1 { print $1 ",0" }' right.csv >zero.csv
expect "zeros" 1 mode5 zero.csv
result "agree with nothing" sh -c 'grep -q "zero throughout" out && grep -q "^This file shows nothing" out'
awk -F, 'NR == 1 { print "step,v_cm" } NR > 1 { print $1 "," }' right.csv >empty.csv
expect "an empty column" 1 mode5 empty.csv
result "agrees with nothing" says out '^(its column v_cm is empty)$'
head -n 2 right.csv >row.csv
expect "the start alone" 1 mode5 row.csv
result "tells nothing" sh -c 'grep -q "^(it has t = 0 alone, which the scenario gives)$" out && grep -q "^This file shows nothing" out'
awk 'NR == 1 || NR == 30' right.csv >row.csv
expect "one row" 0 mode5 row.csv
result "is little" says out '^One row is not enough'
awk -F, 'NR == 1 || NR % 3 == 0' right.csv >gaps.csv
awk 'NR == 1; NR > 1 { line[NR] = $0 } END { for (i = NR; i > 1; i--) print line[i] }' gaps.csv >back.csv
expect "rows out of order, some missing" 0 mode5 back.csv
result "are sorted" sh -c 'grep -q "were sorted" out && grep -q "those of the right code" out'
sed '20,$s/^\([0-9]*,[^,]*\),[^,]*/\1,nan/' own.csv >nan.csv
expect "NaN from a row on" 1 mode5 nan.csv
result "is left out" says out '^  x_by_own_velocity: '
result "and told" says out '^(its column v_cm is not a number from row 19 on: left out)$'
for step in 29 30 31 32; do echo "$step,,nan,nan,inf,-inf,nan"; done >tail.csv
awk 'BEGIN { print "step,v_cm"; for (i = 0; i < 10; i++) print i ",nan" }' >none.csv
expect "no number at all" 1 mode5 none.csv
result "agrees in no row" says out "^Your numbers agree with the right code's in no row.\$"
awk -F, -v OFS=, 'NR == 1 || NR <= 30 { print $1, $2, $3, $6, $7, $8, $10 }' right.csv | cat - tail.csv >lost.csv
expect "a run that is no number in the end" 1 mode5 lost.csv --time 0.1
result "is not right" sh -c 'grep -q "^They first depart at step 29, row 30, column v_cm:$" out && grep -q "^  yours is not a number from here on (nan or inf), right " out'
expect "such a run as JSON" 1 mode5 lost.csv --json --time 0.1
result "is JSON" sh -c 'command -v python3 >/dev/null || exit 0; python3 -c "import json, sys; row = json.load(open(\"out\"))[0]; assert row[\"verdict\"] == \"unknown\" and row[\"yours\"] is None"'
for word in 'nan(ind)' -1.#IND 1.#INF Infinity; do # as Windows and Fortran write it
	sed "/^29,/,\$s/nan/$word/" lost.csv >words.csv
	expect "such a run with $word" 1 mode5 words.csv --time 0.1
	result "departs there" says out '^They first depart at step 29, row 30, column v_cm:$'
done
awk -F, 'NR <= 31; NR > 31 && NR <= 41 { print $1 ",,,,,,,,," }' right.csv >blank.csv
expect "rows of nothing at the end" 0 mode5 blank.csv
result "are not counted" says out '^Your numbers are those of the right code, to 16 digits over 30 rows.$'
printf 'step,v_cm\n0,1e308\n1,1\n2,2\n3,1\n' >huge.csv
expect "a number too large for a ratio" 1 mode5 huge.csv
result "has none" sh -c '! grep -q "the ratio is" out'

# one column alone may be wrong, and nothing of the run
awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; print; next } { $at["kinetic"] = sprintf("%.17g", 2 * $at["kinetic"]); print }' right.csv >twice.csv
expect "a column twice too large" 1 mode5 twice.csv
result "is told from the run" sh -c 'grep -q "v_cm, .*strain, .*: as they should be in all rows. Look at how kinetic is made" out && ! grep -q "what is wrong is the start" out'

# a sign, and a power of a thousand that is no unit
make sign.csv mode5 --steps 50 --set initial.velocity=-0.1
expect "another sign" 1 mode5 sign.csv
result "is a value" says out '^  initial.velocity=-0.1: another value, the scenario.s 0.1 times -1.$'
make slow.csv mode5 --steps 50 --set initial.velocity=0.0001
expect "a thousandth of the speed" 1 mode5 slow.csv
result "is a value too" sh -c 'grep -q "^  initial.velocity=0.0001: " out && ! grep -q "in thousand" out'
awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; print; next } { $at["v_cm"] = sprintf("%.17g", 1000 * $at["v_cm"]); print }' right.csv >milli.csv
expect "a unit of its own" 0 mode5 milli.csv
result "is one where the run is right" sh -c 'grep -q "^Read as: v_cm: v_cm, in thousandths; x_cm," out && grep -q "those of the right code" out'

# round-off that grows where a node hardly has mass, by a code whose last digits are others
grown="--set initial.mode=2 --set initial.velocity=2 --set bar.supports=free-free --set mpm.algorithm=usl --set load.body_force=0.3"
# shellcheck disable=SC2086
make grown.csv mode1 $grown --steps 200 --set bar.youngs_modulus=100.0000000000001
# shellcheck disable=SC2086
expect "round-off that grows" 0 mode1 $grown grown.csv
result "is no mistake" says out '^Your numbers are those of the right code, to [0-9]* digits over 201 rows.$'

# a code that cannot run so far is shown by a file that does
coarse="--set initial.mode=5 --set initial.velocity=2 --set bar.density=2 --set mesh.cell_size=0.5"
# shellcheck disable=SC2086
make far.csv mode1 $coarse --steps 200
# shellcheck disable=SC2086
expect "a run that a mistake ends at once" 0 mode1 $coarse far.csv
result "has not that mistake" sh -c 'grep -q "those of the right code" out && ! grep -q strain_without_dt out'

# rows of which codes that fail at once have only the first
# shellcheck disable=SC2086
"$MATVIB" run mode1 $coarse --steps 1 --quiet --force --series first.csv
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; print "step,v_cm,kinetic" } NR == 2 { v = $at["v_cm"]; print 0 "," v "," $at["kinetic"]
	for (k = 1; k < 9; k++) print k "," v + k ",1" }' first.csv >wildly.csv
# shellcheck disable=SC2086
expect "codes that blow up at once" 1 mode1 $coarse wildly.csv
result "explain no file by its first row" says out '^Unknown\.$'

awk -F, -v OFS=, 'NR == 1 { print "step,v_cm,v_cm"; next } { print $1, $3, $3 + 1 }' right.csv >double.csv
expect "a column that is there twice" 0 mode5 double.csv
result "is told" says out '^(it has several columns v_cm: the first counts)$'
single() { # FORMAT: v_cm of the right run, nearly, in single precision
	awk -F, -v format="%d,$1\n" 'function single(x, unit) { for (unit = 1; unit > x; unit /= 2); return int(x / unit * 8388608 + 0.5) / 8388608 * unit }
		NR == 1 { print "step,v_cm"; next } { v = $3 < 0 ? -$3 : $3; v = single(v * (1 + 4e-8)); printf format, $1, ($3 < 0 ? -v : v) }' right.csv
}
single %.12g >single.csv
expect "single precision" 0 mode5 single.csv
result "is known" says out '^Right, USF, but in single precision\.$'
awk -F, 'NR == 1 { print "step,v_cm"; next } { printf "%d,%.8g\n", $1, $3 * (1 + 4e-8) }' right.csv >eight.csv
expect "eight digits of others" 1 mode5 eight.csv
result "are none" sh -c 'grep -q "^None of" out && ! grep -q "single precision" out'

# a bar by bonds, whose spacing is that of its particles
make bonds.csv mode5-peridynamics --steps 9
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; print "step,v_cm"; next } { printf "%d,%.17g\n", $1, 1.37 * $at["v_cm"] }' bonds.csv >factor.csv
expect "any factor" 1 mode5-peridynamics factor.csv
result "has no name" sh -c 'grep -q "ratio 1.37," out && ! grep -q "1/dx" out'

# a curve of one point, every fourth step, another time step, milliseconds, a wide table, none of whose names is ours
make tip.csv mode5 --steps 60 --set "output.follow=particle 49 v"
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; print "time (s);Geschwindigkeit [m/s]"; next } (NR - 2) % 4 == 0 { t = $2; v = $at["particle_49_v"]; sub(/\./, ",", t); sub(/\./, ",", v); print t ";" v }' tip.csv >tip4.csv
expect "the tip of a bar, every fourth step" 0 mode5 tip4.csv
result "is read" sh -c 'grep -q "^Read as: Geschwindigkeit: v of particle 49; dt 0.01, a row every 4 steps$" out && grep -q "those of the right code" out'
make named.csv mode5 --steps 30 --set "output.follow=particle 49 v,particle 49 x"
for as in v=speed v=v_tip x=u_tip x=pos; do
	awk -F, -v name="${as#*=}" -v wanted="particle_49_${as%=*}" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; print "time," name; next } { print $2 "," $at[wanted] }' named.csv >tip.csv
	expect "the tip's ${as%=*} by the name ${as#*=}" 0 mode5 tip.csv
	result "is read" says out "^Read as: ${as#*=}: ${as%=*} of particle 49; dt 0.01$"
done
for language in python matlab fortran julia; do
	expect "a template in $language" 0 --template $language
	result "is written" says out step,time,v_cm
done
make dt2.csv mode5 --steps 60 --set time.courant=0.2
awk -F, 'NR > 1 { printf "%.15g %.15g\n", 1000 * $2, -$3 }' dt2.csv >ms.txt
expect "twice the time step, in ms, without names" 0 mode5 ms.txt
result "are read" sh -c 'grep -q "^Read as: a column without a name: v_cm, with the other sign; times in ms; dt 0.02 (the scenario.s is 0.01)$" out && grep -q "those of the right code" out'
{ echo '% t (us), v_cm' && awk -F, 'NR > 1 { printf "%.15g, %.15g\n", 1e6 * $2, $3 }' dt2.csv; } >us.txt
expect "twice the time step, in microseconds, named as MATLAB comments" 0 mode5 us.txt
result "are read" says out '^Read as: v_cm; times in µs; dt 0.02 (the scenario.s is 0.01)$'
"$MATVIB" run mode5 --steps 5 --frames 6 --particles long.csv --quiet
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next } { row[$2] = row[$2] " " $at["u"] } END { for (k = 0; k <= 5; k++) print k / 100 row[k / 100] }' long.csv >wide.txt
expect "a wide table" 0 mode5 wide.txt
result "is one of particles" sh -c 'grep -q "^Read as: a column without a name: u; dt 0.01$" out && grep -q "those of the right code, to 1[4-6] digits over 300 rows" out'
awk 'BEGIN { printf "t"; for (k = 50; k > 0; k--) printf ",u%d", k; print "" } { printf "%s", $1; for (k = 51; k > 1; k--) printf ",%s", $k; print "" }' wide.txt >down.csv
expect "a wide table that counts down" 0 mode5 down.csv
sed '1s/u/P/g' down.csv >points.csv
expect "a wide table of P1, P2" 0 mode5 points.csv
result "is of particles, not of momenta" says out '^Read as: a column without a name: u; dt 0.01$'
result "is read by its heads" sh -c 'grep -q "^Right, USF.$" out && grep -q "particle 1 is our particle 0" out'
sed '1s/u7,/u8,/' down.csv >same.csv
refuse "a wide table with a head twice" "same.csv: rows 43 and 44 are both of step 0, particle 7" mode5 same.csv
awk 'BEGIN { printf "t"; for (k = 1; k < 200; k++) printf ",a"; for (k = 0; k < 50; k++) printf ",u%d", k; print ""
	for (r = 0; r < 6500; r++) { printf "%d", r; for (k = 1; k < 250; k++) printf ",1"; print "" } }' >broad.csv
refuse "a wide table that would grow beyond bounds" "broad.csv: too many numbers (at most 64 million, a row for each particle)" mode5 broad.csv

# as numpy writes a table
awk -F, 'NR == 1 { print "# step v_cm x_cm"; next } { printf "%.18e %.18e %.18e\n", $1, $3, $6 }' right.csv >numpy.txt
expect "a table of numpy" 0 mode5 numpy.txt
result "is read" says out '^Your numbers are those of the right code'

# the time that a file is given
"$MATVIB" run mode5 --steps 2 --stages 1:2 --particles stages.csv --quiet
expect "no time for other codes" 0 mode5 stages.csv --time 1e-9
result "is told beside any verdict" sh -c 'grep -q "^Right, USF\.$" out && grep -q "^Not everything was tried in the time (--time)\.$" out'
expect "no time for other codes, as JSON" 0 mode5 stages.csv --time 1e-9 --json
result "is told too" says out '"time_up": true'
refuse "no time to read" "right.csv: the time was up before its columns were known (--time)" mode5 right.csv --time 1e-9

make soft.csv mode5 --steps 50 --set mpm.mistake=stress_not_added
printf 'step,v_cm\n0,quick\n' >broken.csv
expect "many files" 2 mode5 right.csv own.csv soft.csv broken.csv --output marks.csv
result "have a line each" sh -c 'grep -q "^own.csv  *mistake  *16  USF  *x_by_own_velocity, update$" out && grep -q "^broken.csv  *unread" out'
result "and say how many were not read" says err '^matvib: 1 of 4 files cannot be judged$'
result "and a row each" sh -c 'test "$(wc -l <marks.csv)" -eq 5 && grep -q "^name,verdict,scheme,digits,mistake,stage$" marks.csv && grep -q "^soft.csv,mistake,USF,16,stress_not_added,strain$" marks.csv'
refuse "the table over a file" "own.csv: the output would overwrite an input" mode5 own.csv --output own.csv --force
refuse "a table that exists" "marks.csv: exists (--force replaces it)" mode5 own.csv --output marks.csv
expect "as JSON" 1 mode5 own.csv right.csv --json
result "it is JSON" sh -c 'command -v python3 >/dev/null || exit 0; python3 -c "import json, sys; rows = json.load(open(\"out\")); assert rows[0][\"verdict\"] == \"mistake\" and rows[0][\"mistake\"] == [\"x_by_own_velocity\"] and rows[0][\"scheme\"] == \"USF\" and rows[0][\"digits\"] == 16 and rows[0][\"step\"] == 1 and rows[1][\"verdict\"] == \"right\" and rows[1][\"mistake\"] == [] and rows[1][\"read_as\"].endswith(\"dt 0.01\")"'
"$MATVIB" diagnose mode5 own.csv own17.csv soft.csv --threads 1 >one.out
"$MATVIB" diagnose mode5 own.csv own17.csv soft.csv --threads 3 >three.out
result "threads leave no trace" cmp one.out three.out

refuse "steps far beyond the run" "x.csv: begins at step 99999999999, and the scenario has 10000" mode5 "$(printf 'step,v_cm\n99999999999,2\n' >x.csv; echo x.csv)"
refuse "no step" "x.csv:1: no column step or time (--map 1=time names the first so)" mode5 "$(printf 'a,v_cm\n1,2\n' >x.csv; echo x.csv)"
refuse "half a step" "x.csv: row 2: step 0.5 is not a whole number from 0 on" mode5 "$(printf 'step,v_cm\n0,2\n.5,2\n' >x.csv; echo x.csv)"
refuse "a step twice" "x.csv: rows 1 and 3 are both of step 0" mode5 "$(printf 'step,v_cm\n0,2\n1,2\n0,3\n' >x.csv; echo x.csv)"
refuse "a word" "x.csv:3: column 2, v_cm: 'fast' is not a number" mode5 "$(printf 'step,v_cm\n0,2\n1,fast\n' >x.csv; echo x.csv)"
refuse "nothing of ours" "x.csv: none of its columns is ours, as far as its first rows tell (--map 1=time,2=v_cm)" mode5 "$(printf 'step,foo\n0,2\n' >x.csv; echo x.csv)"
refuse "a mistake of the scenario's" "mpm.mistake: force_sign is a mistake, and a file is compared with the right code" mode5 right.csv --set mpm.mistake=force_sign
refuse "no file" "SCENARIO FILE is missing (see: matvib --help)" mode5
refuse "a map by no number" "--map: invalid factor fast" mode5 right.csv --map 1=v_cm*fast
refuse "a map without a column" "--map: right.csv:1: no column speed (step, time, v_cm, v_cm_exact, v_cm_predicted, x_cm, kinetic, strain, work, total, or 1 to 10)" mode5 right.csv --map speed=v_cm
echo "1..$number"

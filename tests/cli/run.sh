#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# matvib run as people type it: columns, bytes that repeat, files whole or not at all, exit statuses.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=run

header() { test "$(head -n 1 "$1")" = "$2"; }
nothing_else() { test "$(ls)" = "$(printf 'err\nout')"; }

# --- tables ---
expect "the paper's first mode runs" 0 mode1 --series a.csv --particles p.csv --nodes n.csv
result "columns of the series" header a.csv \
	step,time,v_cm,v_cm_exact,v_cm_predicted,x_cm,kinetic,strain,work,total
result "columns of the particles" header p.csv step,time,particle,x0,x,u,v,stress,strain,density,mass
result "columns of the nodes" header n.csv step,time,node,x,mass,momentum,velocity,f_int,f_ext,f
result "a row for each step" lines a.csv 10002
result "the summary tells the frequency" says out '^frequency  measured 0.62798[0-9]* *predicted 0.6279837 *exact 0.6283185'
result "and what was written" says out '^wrote a.csv, p.csv, n.csv$'
result "nothing on stderr" lines err 0
result "the scenario stands beside" says a.csv.ini '^# v_cm_predicted \[length/time\]: '

expect "it repeats" 0 a.csv.ini --series b.csv --quiet
result "the same bytes" cmp -s a.csv b.csv
result "also beside" cmp -s a.csv.ini b.csv.ini
result "quiet" lines out 0

expect "columns that are asked for" 0 mode1 --steps 9 --columns kinetic_null,v_cm --series c.csv --quiet
result "are written" header c.csv step,time,v_cm,kinetic_null
result "and asked for beside" says c.csv.ini '^columns = kinetic_null,v_cm$'
expect "all" 0 mode1 --steps 9 --columns all --series c.csv --quiet --force
result "are all" header c.csv \
	step,time,v_cm,v_cm_exact,v_cm_predicted,x_cm,x_cm_rate,kinetic,kinetic_grid,kinetic_null,strain,work,total,momentum,reaction
expect "what stands beside repeats them" 0 c.csv.ini --series d.csv --quiet
result "with the same bytes" cmp -s c.csv d.csv
refuse "a column that there is not" "--columns: output.columns: v_probe is not a column of the series (all, step, time, v_cm, v_cm_exact, v_cm_predicted, x_cm, kinetic, strain, work, total, x_cm_rate, kinetic_grid, kinetic_null, momentum, reaction)" \
	mode1 --steps 9 --columns v_cm,v_probe --series e.csv

"$MATVIB" show mode1 >shown.ini
expect "what show prints repeats it too" 0 shown.ini --series - --quiet
result "the same bytes on standard output" cmp -s a.csv out

expect "an existing file is refused" 2 mode5 --series a.csv
result "in one line" lines err 1
result "that says how" says err '^matvib: a.csv: exists (--force replaces it)$'
result "and is left alone" cmp -s a.csv b.csv
expect "unless it may be replaced" 0 mode5 --series a.csv --force --quiet
ln -s nowhere/at-all dangling.csv
refuse "a link to nothing is judged before the run" 'dangling.csv: is a link that leads nowhere' \
	mode1 --set time.end=1e9 --series dangling.csv
longest=$(printf "%0250d" 0)
expect "a name of 250 bytes, 254 with .ini" 0 mode1 --end 1 --series "$longest" --quiet
result "is a file like others" test -s "$longest" -a -s "$longest.ini"
rm -f dangling.csv "$longest" "$longest.ini"
refuse "a name that a terminal would obey" \
	'a\x1b[2J.csv: not a file name (UTF-8 without control characters)' mode1 --series "$(printf 'a\033[2J.csv')"
refuse "a density beyond numbers blames the density" \
	'--set: beam.density: 1e-300 is too small to compute with (> 0)' \
	notched-beam-coarse --set pd.spacing=2e-3 --set pd.horizon=8e-3 --set beam.density=1e-300
# of squares that are denormal the search for eigenvalues never ended, and no signal ended it
printf '[scenario]\nproblem = bar\nmethod = pd\n[bar]\nyoungs_modulus = 1e-306\n' >soft.ini
refuse "so does a stiffness" 'soft.ini:5: bar.youngs_modulus: 1e-306 is too small to compute with (> 0)' \
	soft.ini --steps 2
refuse "and a thickness" '--set: beam.thickness: 1e308 is too large to compute with (> 0)' \
	supported-beam-coarse --set beam.thickness=1e308
rm -f soft.ini
result "then it is another" sh -c '! cmp -s a.csv b.csv'
rm -f ./*.csv ./*.ini

# --- what cannot be measured, and what is kept ---
printf '[scenario]\nproblem = plate\n[plate]\nlength = 40mm\nheight = 20mm\n[pd]\nspacing = 1mm\nhorizon = 4mm\n' >plate.ini
expect "a plate that comes to rest" 0 plate.ini --set 'loads.l=top 0 100% 0 1e4' --set 'supports.s=0 0 1mm 100% ux 0 uy 0' \
	--set time.rest=yes --end 0.01
result "says so" says out '^1248 steps to .*, where it came to rest$'
result "and not that nothing vibrates" sh -c '! grep -q "nothing vibrates" out'
expect "a cut along nodes" 0 plate.ini --set 'cuts.a=0 10.5mm 100% 10.5mm' --end 1e-6
result "is told of" says out '^cut a runs along nodes'
cp plate.ini own.ini
for option in --series --particles --nodes; do
	expect "$option onto the scenario" 2 own.ini --end 1e-6 $option own.ini --force
	result "is refused" says err '^matvib: own.ini: the output would overwrite an input$'
done
while read -r own options; do
	cp plate.ini "$own"
	expect "$options makes a name that is read" 2 "$own" --end 1e-6 $options --force
	result "which is refused" says err "^matvib: $own: the output would overwrite an input\$"
	result "and stays" cmp plate.ini "$own"
	rm "$own"
done <<-'END'
	x.vtu --vtk x
	x.pvd --vtk x --frames 2
	x-0001.vtu --vtk x.vtu --frames 2
	s.csv.ini --series s.csv
	p.csv.ini --particles p.csv
END
result "which stays" cmp plate.ini own.ini
"$MATVIB" sweep own.ini --vary plate.height=20mm,30mm --output own.ini --force >out 2>err
result "so by a sweep" says err '^matvib: own.ini: the output would overwrite an input$'
expect "a plate that is struck too hard" 0 plate.ini --set 'impulses.i=0 0 1mm 100% 400 0' --end 2e-5
result "tells what its energy was on the way" says out '^energy, .* of the start; at most [+]14.2 % on the way$'
expect "a beam by bonds that leaves its channel" 0 moving-cantilever-coarse --end 2e-5
result "says what its energy is" says out '^energy, .* of the start, nearly all of it feed motion$'
expect "by points" 0 moving-cantilever-mpm-coarse --end 2e-5
result "it is that of the oscillation" says out '^energy, .* of the start$'
expect "a bar at rest" 0 mode5 --set initial.velocity=0 --end 1
result "has no frequency" says out '^nothing vibrates: no frequency to measure$'
result "and no energy to keep" sh -c '! grep -q energy out'
expect "a short run" 0 mode5 --end 1 --set initial.velocity=1e-6
result "keeps E*" says out '^energy E\* changed by [+-]*[0-9.e-]* % of the start$'
expect "a plate that cracks" 0 branching-coarse
result "its cracks" says out '^cracks  2 tips  fastest 1862 m/s = 0.61 c_R  broken bonds 9622$'
result "where and when it branched, and how rough it is" says out \
	'^branch x 69.8, y 20.0 mm, 26.0 us  half angle 26 deg  surface made / length 1.39$'
result "what it cost" says out '^cost  248.0 J/m^2: path 182.1  beside 65.9  far 0.0$'
expect "a bar under a load" 0 pull --end 20
result "by the work" says out '^energy, first period to last, .* % of the work, which is half a step ahead of the motion$'

# --- who said it ---
printf '[scenario]\nproblem = simply-supported-beam\n[pd]\nhorizon = 2e-3\nspacing = .5e-3\n[time]\nstep = 1e-6\n' >t.ini
expect "a step too long" 2 t.ini
result "in its line" says err '^matvib: t.ini:7: time.step: 1e-06 is above the critical'
printf '[scenario]\nproblem = simply-supported-beam\n[beam]\nheight = 1e-4\n' >t.ini
expect "a beam too thin" 2 t.ini
result "in the line of the key that was written" says err '^matvib: t.ini:4: pd.spacing: the beam is only 0 nodes high (at least 2; beam.height is 0.0001)$'
expect "the same from outside" 2 supported-beam --set beam.height=1e-4
result "by its option" says err '^matvib: --set: pd.spacing: the beam is only 0 nodes high'
rm -f ./*.ini

# --- how far ---
expect "so many steps" 0 mode1 --steps 25 --series - --quiet
result "and the start" lines out 27
expect "to a time" 0 mode1 --end 0.245 --every 10 --series - --quiet
result "every tenth and the last" sh -c 'test "$(cut -d, -f1 out | tr "\n" " ")" = "step 0 10 20 25 "'
expect "frames" 0 mode1 --end 1 --frames 3 --particles - --quiet
result "first, middle and last" sh -c 'test "$(cut -d, -f1 out | uniq | tr "\n" " ")" = "step 0 50 100 "'
expect "named times" 0 mode1 --end 1 --at 0.1,0.333 --nodes - --quiet
result "the nearest steps" sh -c 'test "$(cut -d, -f1 out | uniq | tr "\n" " ")" = "step 10 33 "'
expect "frames and named times exclude each other" 2 mode1 --frames 3 --at 1,2
result "in words" says err '^matvib: --at: --frames is given too (one of them)$'
expect "in either order" 2 mode1 --at 1,2 --frames 3
expect "also through --set" 2 mode1 --set output.at=1 --frames 3
expect "also behind it" 2 mode1 --frames 3 --set output.at=1
expect "frames of no table" 2 mode1 --end 1 --frames 3 --series -
result "in words" says err '^matvib: --frames: there is no table to write at these times (--particles, --nodes, --bonds or --vtk)$'
expect "nor at named times" 2 mode1 --at 1,2
expect "no frames at all" 2 mode1 --frames 0
result "tells what is allowed" says err 'output.frames: 0 is out of range (empty | 1 to 1000000)$'
expect "steps and end exclude each other" 2 mode1 --steps 3 --end 5
expect "the semicolon of spreadsheets" 0 mode1 --steps 1 --series - --dialect semicolon --quiet
result "with a decimal comma" says out '^1;0,01;0,0636'
expect "semicolons in a file" 0 mode1 --steps 1 --series d.csv --dialect semicolon --quiet
result "are told beside" says d.csv.ini '^# written with --dialect semicolon'
expect "and given again" 0 d.csv.ini --series e.csv --dialect semicolon --quiet
result "give the same bytes" cmp -s d.csv e.csv
rm -f ./*.csv ./*.ini
expect "a summary beside a table" 0 mode1 --end 1 --series -
result "goes to stderr" says err '^100 steps to t = 1  (dt 0.01)$'
result "and leaves the table alone" lines out 102

# --- the bar by peridynamics ---
expect "the bar by the other method" 0 mode5 --set scenario.method=pd --end 20 --series p.csv --particles q.csv --bonds b.csv
result "columns of its series" header p.csv \
	step,time,v_cm,v_cm_exact,v_cm_predicted,x_cm,kinetic,strain,work,total
result "columns of its particles" header q.csv \
	step,time,particle,x0,x,u,v,stress,strain,density,mass,strain_energy,surface_factor
result "columns of its bonds" header b.csv step,time,i,j,x_i,x_j,stretch
result "144 of them" lines b.csv 145
"$MATVIB" run mode5 --set scenario.method=pd --steps 3 --bonds f.csv --columns all --quiet
result "its factors by --columns all: c G w s h is the pull" awk -F, 'NR > 1 { d = $10 * $11 * $12 * $7 * 0.5 - $8; if (d * d > 1e-24 || $10 == 0) exit 1 }' f.csv
result "the summary tells its prediction" says out '^frequency  measured 5.5876[0-9]*  predicted 5.58684  exact 5.654867$'
result "what it predicts is what it does" awk -F, 'NR > 1 { d = $3 - $5; if (d * d > 1e-24) exit 1 }' p.csv
result "the scenario beside names the method" says p.csv.ini '^method = pd$'
expect "it repeats" 0 p.csv.ini --series r.csv --quiet
result "the same bytes" cmp -s p.csv r.csv
expect "it has no nodes of a mesh" 2 mode5 --set scenario.method=pd --nodes n.csv
expect "a key of the other method" 2 mode5 --set mpm.shape=gimp --set scenario.method=pd
result "is refused by name" says err '^matvib: --set: mpm.shape: is not a parameter of method pd (only of mpm)$'
expect "too large a step" 2 mode5 --set scenario.method=pd --set time.courant=1
result "both steps are named" says err 'the time step 0.1 is above the critical one, 0.0880243 (courant at most 0.88024)$'
rm -f ./*.csv ./*.ini

# --- beams ---
"$MATVIB" show supported-beam-mpm-coarse --set time.unstable=yes >own.ini
expect "the other method's leave for an unstable step" 2 own.ini --set scenario.method=pd --set time.step=1
result "is none" says err 'time.step: 1 is above the critical time step (at most 1.077e-7, or auto)$'
expect "a beam" 0 supported-beam-coarse --steps 20 --series s.csv --bonds b.csv --vtk v --frames 2 --quiet
result "columns of a supported beam" header s.csv \
	step,time,u_probe,v_probe,u_euler,v_euler,u_timoshenko,v_timoshenko,kinetic,strain,work,dissipated,total,broken_bonds
result "columns of bonds" header b.csv step,time,i,j,x_i,y_i,x_j,y_j,stretch,broken,broken_at
result "frames for ParaView" test -s v-0000.vtu -a -s v-0001.vtu -a -s v.pvd
expect "with raw numbers" 0 supported-beam-coarse --steps 20 --vtk r.pvd --vtk-data raw
result "told by the name of what was written" says out '^wrote r.vtu$'
result "they take less room" test "$(wc -c <r.vtu)" -lt "$(wc -c <v-0001.vtu)"
cat >read.py <<'END'
import sys
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
def points(name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    data = reader.GetOutput().GetPointData().GetArray("velocity")
    return [data.GetTuple(k) for k in range(data.GetNumberOfTuples())]
a, b = points(sys.argv[1]), points(sys.argv[2])
sys.exit(a != b or len(a) == 0)
END
if python3 -c 'import vtkmodules.vtkIOXML' 2>/dev/null; then
	result "VTK reads the same in both" python3 read.py r.vtu v-0001.vtu
else
	skip "VTK reads the same in both" "no VTK for Python"
fi
expect "one thread" 0 supported-beam-coarse --steps 20 --threads 1 --series - --quiet
result "gives the same bytes" cmp -s s.csv out
expect "it repeats" 0 s.csv.ini --threads 3 --series - --quiet
result "with the time step that was found" cmp -s s.csv out
rm -f ./*.csv ./*.ini v* r.vtu read.py
expect "a beam that cracks" 0 notched-beam-coarse --set pd.spacing=2e-3 --set pd.horizon=6.5e-3 --set load.stress=12e7 --series n.csv
first=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "broken_bonds") c = i; next } $c > 0 { print $2; exit }' n.csv)
seen=$(sed -n 's/^crack  first break \([0-9.]*\) us  twentieth [0-9.]* us  protected zone [0-9.]* us$/\1/p' out)
result "tells its times" test -n "$seen"
result "none before a bond breaks" awk "BEGIN { exit !($seen >= $first * 1e6 - 0.01) }"
result "its angles" says out '^angle of fit  [0-9.]* deg over 10 mm  [0-9.]* deg over 20 mm  [0-9.]* deg over 38 mm$'
broken=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "broken_bonds") c = i; next } { last = $c } END { print last }' n.csv)
result "its tip and the bonds of the last row" says out "^tip  x [0-9.]* mm  y [0-9.]* mm  broken bonds $broken\$"
result "the energy by the work" says out ' % of the work$'
result "and no frequency" sh -c '! grep -q frequency out'
expect "before anything breaks" 0 notched-beam-coarse --steps 5
result "says that" says out '^crack  first break none  twentieth none  protected zone not yet$'
result "with no tip yet" says out '^no crack yet  broken bonds 0$'
result "without an angle" sh -c '! grep -q angle out'
rm -f ./*.csv ./*.ini

# --- what goes wrong ---
expect "no scenario" 2
expect "an unknown scenario" 2 mode99
expect "an unknown option" 2 mode1 --serie x.csv
result "asks whether it was meant" says err 'did you mean --series?'
expect "bonds of a bar" 2 mode1 --bonds b.csv
expect "an unstable Courant number" 2 mode1 --set time.courant=1.8
result "is refused with both numbers" says err '^matvib: .*time.courant: 1.8 .*1.732'
expect "one that only the ends do not stand" 2 mode1 --set mpm.shape=bspline2 --set mpm.algorithm=usl --set time.courant=1.2
result "is refused with what they do" says err 'at most 0.99856, or time.unstable = yes)$'
expect "the same on purpose" 1 mode1 --set mpm.shape=bspline2 --set mpm.algorithm=usl --set time.courant=1.4 \
	--set time.unstable=yes --end 1000 --series unstable.csv
result "fails as usual" says err '1 + de <= 0'
result "and its rows are there" test "$(wc -l <unstable.csv)" -gt 10
rm -f unstable.csv unstable.csv.ini

# with a spline the tenth sine is a mixture of the mesh's modes, with a hat it is one of them
expect "a mixture of modes" 0 mode10 --set mpm.shape=bspline2 --end 20
result "is said to be one" says out 'a mixture of modes: overlap 0\.7'
expect "one mode of the mesh" 0 mode10 --end 20
result "is no mixture" sh -c '! grep -q mixture out'
expect "one file for two tables" 2 mode1 --series x.csv --nodes ./x.csv
expect "standard output for two tables" 2 mode1 --series - --nodes -
expect "a folder that is not there" 2 mode1 --series none/x.csv
result "is told" says err '^matvib: none/x.csv: there is no folder none$'
expect "a folder that is a file" 2 mode1 --series out/x.csv
result "is told" says err '^matvib: out/x.csv: out is not a folder$'
expect "more steps than can be done" 2 supported-beam-coarse --end 1e12
result "are counted at once" says err '^matvib: .*time.end: 1e+12 takes 9.33e+18 steps'
expect "a full device" 1 mode1 --series /dev/full
result "says so" says err '^matvib: /dev/full: cannot be written: No space left on device$'
result "nothing is left behind" nothing_else
(ulimit -f 8 && exec "$MATVIB" run mode1 --quiet --series x.csv) >out 2>err
result "a disk that is full on the way" test $? -eq 1
result "says so" says err '^matvib: x.csv: cannot be written: File too large$'
result "nothing is left behind" nothing_else

# two programs that find a name free: the slower one is refused, and what stands there is of one piece
slow() { "$MATVIB" run mode1 --quiet --set "initial.mode=$1" --series one.csv 2>"err$1"; echo $? >"status$1"; }
slow 1 &
slow 2 &
wait
result "one of two programs gets the name" sh -c 'sort status1 status2 | tr -d "\n" | grep -qx "0[12]"'
result "the other is told" sh -c 'cat err1 err2 | grep -q "^matvib: one.csv: .*--force replaces it"'
mode=$(sed -n 's/^mode = //p' one.csv.ini)
"$MATVIB" run mode1 --quiet --set "initial.mode=$mode" --series other.csv
result "both files are of the same run" cmp -s one.csv other.csv
rm -f one.csv* other.csv* err1 err2 status1 status2
result "and nothing else is left" nothing_else
if test "$(id -u)" -ne 0; then
	mkdir closed && chmod a-w closed
	expect "a folder that cannot be written" 1 mode1 --series closed/x.csv
	chmod u+w closed && ln -s /dev/null closed/null && chmod a-w closed
	expect "a device in it takes all" 0 mode1 --steps 10 --series closed/null
	chmod u+w closed && rm -r closed
fi

expect "a bar that leaves its mesh" 1 mode1 --set bar.supports=free-free --set initial.mode=0 \
	--set initial.velocity=1 --set mesh.padding=1 --series f.csv
result "says which particle, when" says err '^matvib: particle [0-9]* .*step'
result "tells how far it came" says out 'where the run failed$'
result "and is written up to there" sh -c 'test "$(wc -l <f.csv)" -gt 100 && test -s f.csv.ini'
result "with the failure in what stands beside" says f.csv.ini '^# the run stopped: particle [0-9]* left the mesh in step'
expect "what stands beside ends before" 0 f.csv.ini --series g.csv --quiet
result "with the same bytes" cmp -s f.csv g.csv
rm -f ./*.csv ./*.ini

# --- interrupted --- (a shell starts what runs behind it with SIGINT ignored, nohup with SIGHUP, other programs with
# SIGPIPE or SIGXFSZ; env gives them all back)
for signal in HUP INT QUIT TERM PIPE ALRM USR1 USR2 XCPU XFSZ VTALRM PROF SYS TRAP; do
	env --default-signal "$MATVIB" run mode1 --end 1e6 --series i.csv --particles p.csv >out 2>err &
	soon test -e "p.csv.$!-0.part"
	soon test -e "i.csv.$!-0.part"
	kill -s "$signal" $!
	ends $!
	got=$?
	env --default-signal sh -c "kill -s $signal \$\$" # which number that is, this shell knows
	result "interrupted by $signal" test "$got" -eq $?
	result "leaves nothing" nothing_else
done

# --- APIC with hats, where an end moves past a node: named before the run, and where it fails
drifts="mode1 --set mpm.transfer=apic --set initial.mode=0 --set bar.supports=free-free --set initial.velocity=2.5
	--set mesh.particles_per_cell=1 --set mesh.padding=200"
# shellcheck disable=SC2086 # words
expect "a drifting bar of one particle a cell" 1 $drifts --end 60
result "is warned of by name" says out '^APIC with hats lets round-off grow at nodes of tiny mass beside a moving end: gimp does not$'
result "and so it fails" says err 'was crushed (1 + de <= 0) (APIC with hats lets round-off grow'
# shellcheck disable=SC2086 # words
expect "boxes do not" 0 $drifts --end 60 --set mpm.shape=gimp
result "and are not warned of" test -z "$(grep 'APIC with hats' out)"
expect "nor is an end that stays in its cell" 0 mode1 --set mpm.transfer=apic --steps 10
result "either" test -z "$(grep 'APIC with hats' out)"

# --- long names: a scenario stands beside a table, with .ini behind its name
long=$(printf '%0247d' 0)
expect "a name of 251 bytes" 0 mode1 --steps 5 --series "$long.csv" --quiet
result "has its scenario beside it" test -s "$long.csv.ini"
rm -f "$long"*
refuse "one of 252 is refused at once" "0$long.csv.ini: the name is too long (most systems allow 255 bytes)" \
	mode1 --end 1e9 --series "0$long.csv"
result "and nothing is written" nothing_else

# what the run is judged by is solved before it: a motion of minutes
env --default-signal=INT "$MATVIB" run moving-cantilever-coarse --set motion.speed=1e-6 --end 2 --series i.csv >out 2>err &
motion=$!
soon works $motion 40
kill -s INT $motion
ends $motion
result "a motion is given up by ^C" test $? -eq 130
result "it says so" says err "motion was cancelled$"
result "and leaves nothing" nothing_else

# a bar is for people: a log gets none, however long the run
expect "a run of some seconds" 0 notched-beam --steps 500 --threads 1
result "no bar where standard error is no terminal" test ! -s err

# the stress of bonds at rest has the mean that the loads ask for: sum V syy = sum y F, y as it is pulled
expect "a plate at rest" 0 pulled-plate --set pd.critical_energy=1e6 --set damping.rate=5e4 --end 1e-3 --set pd.spacing=1e-3 \
	--set pd.horizon=4e-3 --set time.step=2e-7 --columns sxx,syy,sxy --particles pulled.csv --quiet
result "its stress is in balance with its loads" awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
	{ n++; sxx += $at["sxx"]; syy += $at["syy"] } $at["y0"] > .039 { top += $at["uy"]; k++ } $at["y0"] < .001 { low += $at["uy"] }
	END { right = 6e6 * (.039 + (top - low) / k) / .04; exit !(k == 100 && (syy / n / right - 1) ^ 2 < 1e-16 && (sxx / n) ^ 2 < 1) }' pulled.csv
refuse "critical damping of a plate that nothing holds" "pulled-plate: damping.rate: critical is twice a lowest frequency that is not known here: \
nothing holds the plate, its two lowest lie too close, or the lattice is too fine (a number, 1/s)" \
	pulled-plate --set pd.spacing=2e-3 --set pd.horizon=6e-3 --set time.step=auto --set time.rest=yes --steps 1
free="pulled-plate --set pd.spacing=2e-3 --set pd.horizon=6e-3 --set time.step=auto --set loads.top=none --set loads.bottom=none --steps 2"
expect "a free plate may move as a whole, however fast" 0 $free --set "impulses.a=0% 0% 100% 100% 6000 0"
expect "a part of it may not" 2 $free --set "impulses.a=0% 0% 90% 100% 6000 0"
expect "nor one that is held" 2 $free --set "impulses.a=0% 0% 100% 100% 6000 0" --set "supports.b=0 0 5mm 5mm ux 0"
for pulse in 500,1,1 -3,1,1 50,101,1; do
	refuse "a pulse $pulse" "--set: initial.pulse: $pulse is not on the bar (centre 0 to 100, width at most 100)" \
		pulse --set initial.pulse=$pulse
done
refuse "the first option with which it fails is named" '--set: mesh.cell_size: the length 25.5 must be a whole number of cells, not 25.5' \
	mode5 --set bar.length=25.5 --set initial.mode=3 --end 5
printf '[scenario]\nproblem = bodies\n' >bodies.ini
refuse "or the file" 'bodies.ini:2: bodies: there is none (at least one line, NAME = disc CX CY R)' bodies.ini --end 1
expect "v_cm of a fine mesh is predicted" 0 mode5 --set mesh.cell_size=0.025 --set initial.velocity=1e-7 \
	--set initial.overtones=3:3e-8,7:1e-8 --end 0.5 --series fine.csv --columns v_cm,v_cm_predicted --quiet
result "to the size of its strain" awk -F, 'NR > 1 { d = $3 - $4; if (d * d > 1e-30) bad = 1; n++ } END { exit bad || n < 1000 }' fine.csv
expect "a bar of bonds whose second run is another method" 0 mode5-peridynamics --set pd.mistake=one_way --steps 2
result "may be wrong" says out 'with a mistake: one_way'
expect "a mistake of contact where nothing touches" 2 spinning-disc --set mpm.body_mistake=no_first_fix --steps 1
expect "a wave of a disc" 2 spinning-disc --set bodies.disc="disc .5 .5 .3 wave 1"
result "says what has one" says err 'bodies.disc: wave is for a block'
echo "1..$number"

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# list, show, params, --help and what is answered to a wrong command line.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"

expect "version" 0 --version
result "the version is its first line" sh -c 'head -n 1 out | grep -qx "matvib [0-9.]*\(~dev\)\{0,1\}"'
described=$("$MATVIB_SRCDIR/tools/describe" "$MATVIB_SRCDIR")
result "then which commit it is" test "$(sed -n 's/^commit: //p' out | sed 's/-dirty$//')" = "${described%-dirty}"
result "kernels and libraries" sh -c 'grep -q "^kernels: plain" out && grep -q "^libraries: ncurses .*, GSL " out'
expect "help" 0 --help
result "help fits 100 columns" test -z "$(awk 'length > 100' out)"
result "help names the commands" says out 'matvib show SCENARIO'
for command in list show params verify; do
	expect "help of $command" 0 $command --help
	result "$command says how it is used" says out "^usage: matvib $command"
done

expect "help as a command" 0 help
result "is --help" sh -c '"$MATVIB" -h | cmp -s - out'
expect "help COMMAND" 0 help sweep
result "is its --help" sh -c '"$MATVIB" sweep -h | cmp -s - out'
refuse "help of what is none" 'zebra: no such command or scenario (see: matvib help)' help zebra
expect "-V" 0 -V
result "is --version" sh -c '"$MATVIB" --version | cmp -s - out'

"$MATVIB" run mode5 --steps 5 --quiet --series long.csv
"$MATVIB" show mode5 | "$MATVIB" run - --steps 5 -q -oshort.csv >out 2>&1
result "- is a scenario on standard input, -o and -q say it shortly" cmp -s long.csv short.csv
result "-q is quiet" test ! -s out
printf '[scenario]\n' | "$MATVIB" show - >out 2>err
result "a wrong line of it has its number" says err '^matvib: -:1: holds no scenario'
head -c 5000001 /dev/zero | "$MATVIB" show - >out 2>err
result "it has a size" says err '^matvib: -: is too large (at most 5000 kB)'
printf 'q' | "$MATVIB" - >out 2>err
result "the laboratory has its keys there" says err '^matvib: -: keys come from standard input'
printf ':open -\n.\n' | timeout 20 "$MATVIB" mode1 --plain --paused >out 2>err
result "once it is open no word reads there" says out '^-: no such scenario or file'
result "and the next line is still a line" says out 'step 1 of'
refuse "a letter that is none" '-x: unknown option (see: matvib show --help)' show mode1 -x
refuse "a letter without its value" '-o: has no value (FILE)' run mode1 -o
refuse "a letter that has none" '-q: takes no value' run mode1 -qo

expect "list" 0 list
result "all built-ins with titles" test "$(awk 'NF > 2' out | wc -l)" -eq "$(ls "$MATVIB_SRCDIR"/data/scenarios/*.ini | wc -l)"
cut -d' ' -f1 out >names
expect "describe" 0 describe mode1
cp out described
expect "list of one" 0 list mode1
result "says the same" cmp out described
result "the first is mode1" test "$(head -n 1 names)" = mode1

"$MATVIB" show mode5 | sed -n '/^\[scenario\]/{n;s/ =.*//p;}' >out
result "a scenario begins with its title" test "$(cat out)" = title
# what show prints is a scenario file that comes to the same
while read -r scenario; do
	"$MATVIB" show "$scenario" >first.ini 2>err && "$MATVIB" show first.ini >second.ini 2>>err
	cmp first.ini second.ini >out 2>&1
	result "show $scenario reads back" test ! -s out
done <names
sed 's/$/\r/' first.ini >dos.ini
"$MATVIB" show dos.ini >second.ini 2>err
result "CR LF is accepted" cmp -s first.ini second.ini
printf '\357\273\277' | cat - first.ini >bom.ini
"$MATVIB" show bom.ini >second.ini 2>err
result "a byte order mark is accepted" cmp -s first.ini second.ini

expect "--set" 0 show mode5 --set mesh.cell_size=0.5 --set=initial.overtones=7:0.01 --end 20
result "--set is in the scenario" says out '^cell_size = 0.5$'
result "--set=KEY=VALUE too" says out '^overtones = 7:0.01$'
result "--end too" says out '^end = 20$'
expect "a fracture energy" 0 show notched-beam --set pd.critical_energy=50
result "the energy is the handle" says out '^critical_energy = 50$'
result "the stretch is a comment" says out '^# critical_stretch = 0.0010'

expect "--steps of the bar" 0 show mode1 --steps 100
result "a hundred steps of 0.01" says out '^end = 1$'
expect "--steps of a beam with its own step" 0 show supported-beam-coarse --steps 10
result "derived values are comments" says out '^# dt_crit = [0-9.]*e-7 s$'
"$MATVIB" run supported-beam-coarse --steps 9 --quiet --series own.csv
"$MATVIB" run supported-beam-coarse --steps 9 --quiet --series copied.csv --set "time.step=$("$MATVIB" show supported-beam-coarse | sed -n 's/^# dt = \(.*\) s$/\1/p')"
result "the step that is shown makes the run again" cmp own.csv copied.csv
"$MATVIB" show notched-beam-coarse --set pd.critical_energy=50 >energy.ini
"$MATVIB" show notched-beam-coarse --set "pd.critical_stretch=$(sed -n 's/^# critical_stretch = //p' energy.ini | tail -n 1)" >stretch.ini
"$MATVIB" run energy.ini --steps 9 --quiet --series own.csv --force
"$MATVIB" run stretch.ini --steps 9 --quiet --series copied.csv --force
result "and so does the stretch" cmp own.csv copied.csv
expect "a step beyond the largest stable one" 2 run mode5 --end 1 --set time.courant=1.75
most=$(sed -n 's/.*(at most \([0-9.]*\), .*/\1/p' err)
expect "the largest that is said" 0 run mode5 --end 1 --set "time.courant=$most"
expect "a step beyond the critical one" 2 run supported-beam-coarse --steps 2 --set time.step=3e-7
most=$(sed -n 's/.*(at most \([0-9.e-]*\), .*/\1/p' err)
expect "the critical one that is said" 0 run supported-beam-coarse --steps 2 --set "time.step=$most"
result "a wrong step is said" test "$("$MATVIB" show mode1 --set time.courant=3 | grep -c '^# a run is refused')" -eq 1

expect "params" 0 params
result "a word has no unit" says out '^  load.traction_layer = auto  *auto | > 0$'
result "nothing has no unit" says out '^  output.at =  *time,time,...$'
result "every problem" test "$(grep -c -E '^(bar|simply-supported-beam|moving-cantilever|notched-beam) \(' out)" -eq 4
result "params fits 120 columns" test -z "$(awk 'length > 120' out)"
for name in pulse two-materials hanging-beam two-discs mode5-peridynamics; do
	expect "params of $name" 0 params $name
done
expect "params of beams in cells" 0 params simply-supported-beam
result "a mistake of bars alone is marked" says out '^      cells_kept  .*  \[bars only\]$'
result "one of both is not" says out '^      force_sign  .*sign\.$'
expect "params of one problem" 0 params notched-beam
result "its parameters" says out '^  load.stress = 6e7 Pa .*\[live\]$'
result "and what follows from them" says out '^  bonds = 1388854$'
result "no others" test "$(grep -c mesh.cell_size out)" -eq 0

refuse "unknown scenario" 'mode11: no such scenario or file (did you mean mode1?)' show mode11
refuse "unknown scenario, none near" 'zebra: no such scenario or file (see: matvib list)' show zebra
refuse "no scenario" 'SCENARIO is missing (see: matvib --help)' show
refuse "two scenarios" 'mode5: is one argument too many (SCENARIO)' show mode1 mode5
refuse "list takes one scenario" 'mode1: is one argument too many ([SCENARIO])' list mode5 mode1
refuse "a folder" '/: cannot be read: Is a directory' show /
refuse "unknown option" '--sett: unknown option (did you mean --set?)' show mode1 --sett a=b
refuse "unknown option, none near" '--zebra: unknown option (see: matvib show --help)' show mode1 --zebra
refuse "option of another command" '--paused: unknown option (see: matvib show --help)' show mode1 --paused
refuse "option without value" '--set: has no value (KEY=VALUE)' show mode1 --set
refuse "--set without =" '--set: "mode" sets nothing (KEY=VALUE)' show mode1 --set mode
refuse "--set of an unknown key" '--set: mesh.cellsize: unknown key (did you mean mesh.cell_size?)' \
	show mode1 --set mesh.cellsize=1
refuse "--set out of range" '--set: mesh.particles_per_cell: 9 is out of range (1 to 8)' \
	show mode1 --set mesh.particles_per_cell=9
refuse "Poisson's ratio of bonds" '--set: beam.poisson: is 1/3 here and cannot be set: bonds pull along their own line alone; a sheet of such springs grows narrower by a third of its stretch' \
	show supported-beam --set beam.poisson=0.3
refuse "which a bar has not" '--set: beam.poisson: is not a parameter of problem bar (only of simply-supported-beam, moving-cantilever)' show mode1 --set beam.poisson=0.3
refuse "a view that is none" '--set: view.upper: 99 is not allowed (1 to 9, or a view'\''s word)' show mode1 --set view.upper=99
refuse "half a view" '--set: view.lower: 1.5 is not allowed (1 to 9, or a view'\''s word)' show mode1 --set view.lower=1.5
refuse "a window without length" '--set: view.window: 0 is not allowed (> 0)' show mode1 --set view.window=0
refuse "a pace in words" '--set: view.pace: fast is not allowed (> 0)' show mode1 --set view.pace=fast
refuse "curves that are none" \
	'--set: view.references: some is not allowed (all | exact | predicted | none)' show mode1 --set view.references=some
refuse "a word that names none" '--set: view.lower: bogus is not allowed (profile, probe, energies, shapes, dispersion, convergence, spectrum, tables, beam, section, cracks, cell, log, or 1 to 9)' show mode1 --set view.lower=bogus
refuse "a picture of a view that is none" \
	'--set: view.upper: shapes:zzz is not allowed (shapes with one of values, slopes)' show mode1 --set view.upper=shapes:zzz
refuse "a picture of a view that has one" '--set: view.upper: beam:zzz is not allowed (beam alone)' show mode1 --set view.upper=beam:zzz
refuse "a colour of a beam that is none" '--set: view.upper: beam:zzz is not allowed (beam with one of uy, ux, velocity, energy, damage, family, surface_factor, stress_xx, stress_yy, stress_xy, drawing)' show supported-beam --set view.upper=beam:zzz
expect "a view by its word" 0 show mode1 --set view.upper=energies
expect "a view, a window, curves" 0 show mode1 --set view.upper=3 --set view.window=20 --set view.references=exact
result "they are in the scenario" says out '^references = exact$'
refuse "--end that is no time" '--end: time.end: soon is not a number (> 0)' show mode1 --end soon
refuse "--end and --steps" '--steps: --end says when the run ends (one of them)' show mode1 --end 3 --steps 4
refuse "a length that is wrong without --steps" "--set: mesh.cell_size: the length 25.3 must be a whole number of cells, not 25.3" show mode1 --set bar.length=25.3 --steps 4
refuse "no steps" '--steps: 0 is not allowed (a whole number, 1 or more)' show mode1 --steps 0
refuse "no step of the best blend" '--set: time.courant: 1.75 is unstable on this mesh (at most 1.581, or time.unstable = yes)' run mode5 --end 1 --set mpm.mass_blend=auto --set time.courant=1.75
refuse "too many nodes" '--set: pd.spacing: 1.47e+08 nodes with 14 bonds each are too many for memory (at most 19173961 nodes: a larger spacing, or a smaller horizon)' show notched-beam --set pd.spacing=1e-5 --set pd.horizon=3e-5
refuse "both handles" '--set: pd.critical_stretch: pd.critical_stretch and pd.critical_energy say the same (one of them)' \
	show notched-beam --set pd.critical_energy=1 --set pd.critical_stretch=1e-3
refuse "unknown problem" \
	'params: beam is not a problem (bar | simply-supported-beam | moving-cantilever | notched-beam | plate | one-particle | hanging-column | bodies) or a scenario' params beam
refuse "laboratory: unknown option" '--pause: unknown option (did you mean --paused?)' --pause
refuse "laboratory: unknown scenario" 'mode11: no such scenario or file (did you mean mode1?)' mode11
: >empty
refuse "a lesson that there is not" 'one-stop: no such lesson or file (did you mean one-step?)' lesson one-stop --script empty
"$MATVIB" lesson --list >lessons && grep -q '^one-step  * 15 min  One step of MPM$' lessons
result "lesson --list tells the names" test $? -eq 0
refuse "a command that went" 'export-lammps: is gone (what agreed with LAMMPS, and how, is in matvib-checks(7))' export-lammps notched-beam
refuse "a slip in a command" 'rnu: no such command, scenario or file (did you mean run?)' rnu mode1
refuse "laboratory: two scenarios" 'mode5: is one argument too many ([SCENARIO])' mode1 mode5
refuse "laboratory: wrong word" '--glyphs: dots is not a choice (auto | braille | block | ascii)' --glyphs dots
refuse "laboratory: wrong size" '--size: 80 is not a size (such as 80x24; at most 1000 each)' --size 80
refuse "laboratory: wrong history" '--history: 1Q is not a size (such as 64M or 2G)' --history 1Q
refuse "laboratory: wrong threads" '--threads: 0 is not allowed (a whole number, 1 or more)' --threads 0
refuse "laboratory: too many threads" '--threads: 100000 are too many (1 to 1024)' --threads 100000

expect "list of a scenario" 0 list mode5
result "list SCENARIO tells what it is about" says out '^Solid is the fifth mode on this mesh'
expect "help on a scenario" 0 help pulse
result "help SCENARIO tells its title" says out '^pulse: A pulse comes back$'
expect "params of a scenario" 0 params mode10
result "params SCENARIO has its values" says out 'initial.mode = 10 '

# no command word: the laboratory, which needs a terminal or a script
refuse "laboratory: no terminal" 'the laboratory needs a terminal; without one use: matvib run SCENARIO, matvib lesson --list, or --plain' mode5 </dev/null
printf 'screen\nkey q\nclosed\n' >keys
expect "laboratory: a script" 0 --script keys --size 100x30 --paused mode10 --set mesh.cell_size=0.5 --glyphs ascii
result "it opens the scenario" says out 'mode10 .*PAUSED'
result "with the value that was set" says out 'cell size *0.5'
result "in the size asked for" test "$(awk 'length > n { n = length } END { print n }' out)" -eq 100
expect "laboratory: mode5 without a name" 0 --script keys
result "it is mode5" says out 'mode5 '

printf 'zebra\n' >keys
refuse "a script with an unknown instruction" \
	'keys:1: unknown instruction: zebra (key | type | click | drag | scene | wait | size | rate | cancel-after | screen | styles | expect | reject | closed)' \
	--script keys

printf '[scenario]\nproblem = bar\n[mesh]\n cell_size = 0.5\n' >bad.ini
refuse "a damaged file" 'bad.ini:4: cell_size: is indented (keys begin in the first column)' show bad.ini
printf '[scenario]\nproblem = b\000ar\n' >bad.ini
refuse "a NUL byte" 'bad.ini:2: holds a zero byte (text is expected)' show bad.ini
printf '[scenario]\nproblem = bar\n' >show
"$MATVIB" show ./show >out 2>err
result "a file that is named like a command" says out '^problem = bar$'

printf 'key .\nscreen\nkey .\nscreen\nkey .\nscreen\n' >screens
full() { # ARGUMENTS...: whose output, of a few bytes or of many, finds the disk full
	"$MATVIB" "$@" 2>err >/dev/full
	got=$?
	: >out
	result "a full disk, $*: status 1" test "$got" -eq 1
	result "a full disk, $*: one line" test "$(wc -l <err) $(grep -c '^matvib: .*: No space left on device$' err)" = '1 1'
}
if test -w /dev/full; then
	full --version
	full --help
	full list
	full lesson --list
	full params
	full show notched-beam
	full run mode1 --steps 400 --series - --quiet
	full verify M-dt
	full mode1 --paused --script screens
fi
{
	"$MATVIB" params 2>err
	echo $? >status
} | :
: >out
result "a closed pipe: no signal" test "$(cat status)" -le 1
# opening never waits: a pipe without a writer is refused
mkfifo pipe
for words in 'show pipe' 'run pipe' 'lesson pipe' '--replay pipe' 'mode1 --script pipe'; do
	# shellcheck disable=SC2086
	refuse "$words" 'pipe: is a pipe or a device (a file is expected)' $words
done
printf 'key :\ntype overlay pipe\nkey Enter\nexpect is a pipe or a device\n' >over
expect "an overlay" 0 mode1 --paused --script over
echo "1..$number"

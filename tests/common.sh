# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced first by each test script: makes a scratch folder, enters it, removes it at the end, has the program keep
# its state there, and counts results as TAP. A script of one subcommand says which: subcommand=run
number=0
subcommand=
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
XDG_STATE_HOME=$scratch/state
export XDG_STATE_HOME

# result NAME COMMAND...: it holds if the command does; if not, what was printed is told, by it and before
result() {
	number=$((number + 1))
	name=$1
	shift
	if "$@" >"$scratch/.printed" 2>&1; then echo "ok $number - $name"; else
		echo "not ok $number - $name"
		for file in "$scratch/.printed" "$scratch/out" "$scratch/err"; do
			test ! -f "$file" || tail -n 40 "$file" | sed 's/^/# /'
		done
	fi
}
skip() { # NAME WHY
	number=$((number + 1))
	echo "ok $number - $1 # SKIP $2"
}
# expect NAME STATUS ARGUMENTS...: runs it, and keeps what it wrote in out and err
expect() {
	name=$1 wanted=$2
	shift 2
	"$MATVIB" ${subcommand:+"$subcommand"} "$@" >out 2>err
	got=$?
	result "$name: status $wanted" test "$got" -eq "$wanted"
}
# refuse NAME LINE ARGUMENTS...: bad usage; nothing on standard output, on standard error this one line
refuse() {
	name=$1 line="matvib: $2"
	shift 2
	"$MATVIB" ${subcommand:+"$subcommand"} "$@" >out 2>err
	got=$?
	test "$got" -eq 2 || echo "status $got, not 2" >>out
	rest=
	{ IFS= read -r first && ! IFS= read -r rest && test "$first$rest" = "$line"; } <err || printf 'wanted: %s\n' "$line" >>out
	result "$name" test ! -s out
}
says() { grep -q -e "$2" "$1"; } # FILE PATTERN
lines() { test "$(wc -l <"$1")" -eq "$2"; }

# soon COMMAND...: asked again every twentieth of a second until it holds; what does not come in two minutes, on
# whatever machine, does not come
soon() {
	tries=2400
	until "$@"; do
		tries=$((tries - 1))
		test "$tries" -gt 0 || return 1
		sleep 0.05
	done
}
# ends PID: its status; what is deaf is killed, and has that one
ends() {
	soon gone "$1" || kill -s KILL "$1"
	wait "$1"
}
# works PID HUNDREDTHS: the process has had so much of a processor, or is no more; where this is not told, it has
works() { test ! -r "/proc/$1/stat" || awk -v most="$2" '{ exit $14 + $15 < most }' "/proc/$1/stat" || gone "$1"; }
# PID: by /proc, for ps is not everywhere; one that is dead and not yet waited for is gone too
gone() {
	if test -r "/proc/$1/stat"; then
		case $(sed 's/.*) //' "/proc/$1/stat" 2>/dev/null) in '' | Z*) ;; *) false ;; esac
	else
		! kill -0 "$1" 2>/dev/null
	fi
}

#!/bin/sh
# The layers hold: no lower layer refers to the terminal, to a higher layer, or (physics) to the outside world.
cd "${MATVIB_BUILDDIR:-.}" || exit 1
number=0
say() { # RESULT NAME
	number=$((number + 1))
	echo "$1 $number - $2"
}
undefined() { # LIBRARY: the symbols that it wants from elsewhere
	nm --undefined-only "$1" 2>/dev/null | awk 'NF == 2 { print $2 }' | sort -u
}
defined() {
	nm --defined-only "$1" 2>/dev/null | awk 'NF == 3 && $2 ~ /[TDBRC]/ { print $3 }' | sort -u
}
judge() { # NAME: well if nothing was found
	if [ -z "$found" ]; then
		say ok "$1"
	else
		say 'not ok' "$1"
		echo "$found" | sed 's/^/# /'
	fi
}
lacks() { # LIBRARY PATTERN NAME
	found=$(undefined "$1" | grep -E -x "$2")
	judge "$3"
}
shares_none() { # LIBRARY OTHER ALLOWED NAME: the library wants nothing that the other defines but what is allowed
	wanted=$(mktemp) given=$(mktemp)
	undefined "$1" >"$wanted"
	defined "$2" | grep -v "$3" >"$given"
	found=$(comm -12 "$wanted" "$given")
	rm -f "$wanted" "$given"
	judge "$4"
}
below() { # LOWER HIGHER...: the lower library wants nothing that a higher one defines
	lower=$1
	shift
	for higher in "$@"; do
		shares_none "$lower" "$higher" '^$' "$lower does not need $higher"
	done
}
curses='initscr|newterm|endwin|wget_wch|wgetch|stdscr|w?add.*str|wrefresh|setupterm|tigetstr|tputs|putp'
for library in libbase.a libphysics.a libtheory.a liblab.a libview.a libfigure.a libcli.a; do
	lacks $library "$curses" "$library does not touch the terminal"
done
for library in libphysics.a $(ls libbar*.a libpd_*.a 2>/dev/null); do
	lacks $library 'printf|fprintf|__printf_chk|__fprintf_chk|puts|putchar|exit|_exit|abort|time|clock|clock_gettime|gettimeofday|rand|random|drand48|fopen|open|getenv' \
		"$library prints nothing, opens nothing, tells no time"
done
for library in libbase.a libphysics.a libtheory.a liblab.a libview.a libfigure.a libtui.a; do
	lacks $library 'exit|_exit|quick_exit' "$library does not exit"
done
below libbase.a libphysics.a libtheory.a liblab.a libview.a libfigure.a libtui.a libcli.a
below libphysics.a libtheory.a liblab.a libview.a libfigure.a libtui.a libcli.a
below libtheory.a libphysics.a liblab.a libview.a libfigure.a libtui.a libcli.a
below liblab.a libview.a libfigure.a libtui.a libcli.a
below libview.a libfigure.a libtui.a libcli.a
below libfigure.a libtui.a libcli.a
below libtui.a libcli.a
# A front end knows a method by method.h alone; what is of one problem it asks the laboratory.
for library in libview.a libfigure.a libtui.a; do
	shares_none $library libphysics.a '^simulation_' "$library calls no method by its name"
done
for folder in view figure tui; do
	found=$(grep -rn '#include "physics/[^"]*/' "${MATVIB_SRCDIR:-..}/src/$folder")
	judge "src/$folder includes no method's header"
done
echo "1..$number"

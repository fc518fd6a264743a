#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The layers hold: no lower layer refers to the terminal, to a higher layer, or (physics) to the outside world; and
# within a layer no file needs one that needs it back.
cd "${MATVIB_BUILDDIR:-.}" || exit 1
ls libbase.a "${MATVIB_SRCDIR:-..}/src/base" >/dev/null || exit 1
number=0
say() { # RESULT NAME
	number=$((number + 1))
	echo "$1 $number - $2"
}
# Of each library, once: the symbols that it wants from elsewhere, and those that it defines.
symbols=$(mktemp -d) || exit 1
trap 'rm -rf "$symbols"' EXIT
for library in lib*.a; do
	nm -A "$library" 2>/dev/null | LC_ALL=C sort >"$symbols/$library"
	awk '$(NF - 1) == "U" { print $NF }' "$symbols/$library" | LC_ALL=C sort -u >"$symbols/$library.wanted"
	awk '$(NF - 1) ~ /^[TDBRC]$/ { print $NF }' "$symbols/$library" | LC_ALL=C sort -u >"$symbols/$library.defined"
done
judge() { # NAME: well if nothing was found
	if [ -z "$found" ]; then
		say ok "$1"
	else
		say 'not ok' "$1"
		echo "$found" | sed 's/^/# /'
	fi
}
lacks() { # LIBRARY PATTERN NAME
	found=$(grep -E -x "$2" "$symbols/$1.wanted")
	judge "$3"
}
shares_none() { # LIBRARY OTHER ALLOWED NAME: the library wants nothing that the other defines but what is allowed
	found=$(LC_ALL=C comm -12 "$symbols/$1.wanted" "$symbols/$2.defined" | grep -v "$3")
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
for library in libbase.a libmethods.a libtheory.a librun.a libviews.a libpaper.a libcli.a; do
	lacks $library "$curses" "$library does not touch the terminal"
done
for library in libmethods.a $(ls libkernels*.a); do
	lacks $library 'printf|fprintf|__printf_chk|__fprintf_chk|puts|putchar|exit|_exit|abort|time|clock|clock_gettime|gettimeofday|rand|random|drand48|fopen|open|getenv' \
		"$library prints nothing, opens nothing, tells no time"
done
# What is not exact in libm, and complex division, differ in the last digit from one machine or compiler to the other.
libm='a?(sin|cos|tan)h?|atan2|sincos|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|cbrt|hypot|erfc?|[lt]gamma|[jy][01n]|fma|c(abs|arg|exp|log|pow|sqrt)|ca?(sin|cos|tan)h?|__divdc3'
for library in lib[!s]*.a; do
	case $library in libfuzzmain.a) continue ;; esac
	lacks "$library" "($libm)[fl]?" "$library calls the elementary functions of src/base/math"
done
for library in libbase.a libmethods.a libtheory.a librun.a libviews.a libpaper.a liblab.a; do
	lacks $library 'exit|_exit|quick_exit' "$library does not exit"
done
below libbase.a libmethods.a libtheory.a librun.a libviews.a libpaper.a liblab.a libcli.a
below libmethods.a libtheory.a librun.a libviews.a libpaper.a liblab.a libcli.a
below libtheory.a libmethods.a librun.a libviews.a libpaper.a liblab.a libcli.a
below librun.a libviews.a libpaper.a liblab.a libcli.a
below libviews.a libpaper.a liblab.a libcli.a
below libpaper.a liblab.a libcli.a
below liblab.a libcli.a
# A front end knows a method by method.h alone; what is of one problem it asks the laboratory.
for library in libviews.a libpaper.a liblab.a; do
	shares_none $library libmethods.a '^simulation_' "$library calls no method by its name"
done
for folder in picture views panes help film plain terminal lab; do
	found=$(grep -rn '#include "methods/[^"]*/' "${MATVIB_SRCDIR:-..}/src/$folder")
	judge "src/$folder includes no method's header"
done
# A view makes a picture and knows neither canvas nor page nor list of words.
found=$(cd "${MATVIB_SRCDIR:-..}/src/views" && grep -rnE --include='*.[ch]' \
	'#include "(picture/(canvas|table|cells/|paper/|words/)|panes/panes)' .)
judge "src/views includes nothing that draws"
# They ask a simulation what it has and a problem for its concerns, never which problem or method it is or how many
# dimensions it has. verify alone speaks of named problems: it is about them.
for folder in picture views panes help film plain terminal lab cli; do
	found=$(cd "${MATVIB_SRCDIR:-..}/src/$folder" && grep -rnE --include='*.[ch]' \
		'\<(PROBLEM|METHOD)_[A-Z]|\<problem_[a-z0-9_]+\>([^(]|$)|(->|\.)dimensions\>|(problem|method)->(word|name), "' . | grep -v '^\./verify/')
	judge "src/$folder asks for no problem, method or number of dimensions"
done
# The product includes nothing of the tests, whose folder is on the path of includes too.
found=$(cd "${MATVIB_SRCDIR:-..}/src" && grep -rnoE --include='*.[ch]' '#include "[^"]+"' . | while IFS='"' read -r place header rest; do
	test -e "$header" || test -e "${place%/*}/$header" || echo "$place$header"
done)
judge "src includes files of src only"

# A new parameter is a member of one concern of a scenario and a row of the table: what is compiled anew then are the files
# that see that concern's header, directly or through others. 40 at most, of about 320. Of what the laboratory shows of
# questions, lessons and the player, which the laboratory itself owns: 60.
found=$(cd "${MATVIB_SRCDIR:-..}/src" && find . -name '*.[ch]' -o -name '*.inc' | xargs grep -oE '^#include "[^"]+"' | awk '
	{
		file = $0; sub(/:.*/, "", file); sub(/^\.\//, "", file)
		header = $0; sub(/^[^"]*"/, "", header); sub(/"$/, "", header)
		users[header] = users[header] " " file
	}
	function see(header, n, i, by) { # marks who sees it; the last three are local
		n = split(users[header], by, " ")
		for (i = 1; i <= n; i++)
			if (!(by[i] in seen)) { seen[by[i]]; see(by[i]) }
	}
	END {
		for (header in users) {
			concern = header ~ /^scenario\/(concern_[a-z]*\.h|parameter_rows\.inc)$/
			part = header ~ /^(panes\/entry|lessons\/lesson_shown|run\/playback)\.h$/
			if (!concern && !part) continue
			concerns += concern
			parts += part
			split("", seen)
			see(header)
			count = 0
			for (file in seen) if (file ~ /\.c$/) count++
			if (concern && count > most) most = count
			if (count > (concern ? 40 : 60)) print header " is seen by " count " files"
		}
		if (concerns < 7 || most < 10 || parts != 3) print "found " concerns " headers of concerns, seen by " most + 0 " files: looks in vain"
	}')
judge "a new parameter recompiles 40 files at most, a member of what the screen shows 60"

# Circles: object files of one library that refer to each other, directly or through others. There is none: what none of
# those left needs, or needs none of them, is taken away until that is all.
find_circles() { # LIBRARY...: what is left, each with what it needs of which other
	(cd "$symbols" && cat "$@") | awk '
		{
			sub(/^[^:]*:/, "")
			member = $1
			sub(/:.*/, "", member)
			sub(/^.*_a-/, "", member) # what a library with flags of its own puts before
			if ($(NF - 1) == "U") uses[member, $NF]
			else if ($(NF - 1) ~ /^[TDBRCVW]$/) home[$NF] = member
			if (!(member in left)) { left[member]; members[++n] = member }
		}
		END {
			for (use in uses) {
				split(use, part, SUBSEP)
				if (part[2] in home && home[part[2]] != part[1]) edges[part[1], home[part[2]]] = part[2]
			}
			do {
				split("", needs)
				split("", needed)
				for (edge in edges) {
					split(edge, part, SUBSEP)
					if (part[1] in left && part[2] in left) { needs[part[1]]; needed[part[2]] }
				}
				gone = 0
				for (i = 1; i <= n; i++)
					if (members[i] in left && !(members[i] in needs && members[i] in needed)) { delete left[members[i]]; gone++ }
			} while (gone)
			for (edge in edges) {
				split(edge, part, SUBSEP)
				if (part[1] in left && part[2] in left) print part[1] " needs " edges[edge] " of " part[2]
			}
		}'
}
for layer in base methods theory run views paper lab cli; do
	libraries=lib$layer.a
	[ $layer = methods ] && libraries="$libraries $(ls libkernels*.a)"
	# shellcheck disable=SC2086 # several libraries
	found=$(find_circles $libraries)
	judge "$layer has no circle of files"
done
# Names: what a library exports begins with a word of its file's or folder's name, or with a type's that a header of the
# folder declares (n_ before a table's): who reads a call knows where to look.
find_strangers() { # LIBRARY...: "file name" of what does not
	{
		(cd src && find . -name '*.c') | sed 's/^\.\///' # made by the build
		(cd "${MATVIB_SRCDIR:-..}/src" && find . -name '*.c' &&
			find . -name '*.h' -exec grep -HE '^(} |typedef (struct|enum|union|unsigned|double)[^{(]*;|typedef (struct|enum|union) [A-Z])' {} +) |
			sed 's/^\.\///'
		nm -A --defined-only --extern-only "$@" 2>/dev/null
	} | awk '
		function word(w) { sub(/s$/, "", w); return tolower(w) }
		function begins(name, w) { w = word(w); return w != "" && (name == w || name == w "s" || index(name, w "_") == 1 || index(name, w "s_") == 1) }
		/^[^:]*\.c$/ { # where a file lies
			path = $0; sub(/\.c$/, "", path)
			file = path; sub(/.*\//, "", file)
			paths[file] = paths[file] " " path
			next
		}
		/^[^:]*\.h:/ { # a type
			folder = $0; sub(/\/[^\/]*$/, "", folder); sub(/:.*/, "", folder); sub(/\/[^\/]*\.h$/, "", folder)
			type = $0; sub(/^[^:]*:/, "", type); sub(/ \{.*/, "", type); sub(/;.*/, "", type); sub(/.*[ }*]/, "", type)
			while (match(type, /[a-z][A-Z]/)) type = substr(type, 1, RSTART) "_" substr(type, RSTART + 1)
			types[folder] = types[folder] " " type
			next
		}
		NF > 2 {
			file = $1; sub(/:[^:]*$/, "", file); sub(/.*:/, "", file); sub(/\.o$/, "", file); sub(/.*_a-/, "", file)
			name = $NF; sub(/^n_/, "", name)
			found = 0
			n = split(paths[file], ways, " ")
			for (i = 1; i <= n; i++) {
				folder = ways[i]; sub(/\/[^\/]*$/, "", folder)
				m = split(ways[i] types[folder], words, /[\/ ]/)
				for (k = 1; k <= m; k++) if (begins(name, words[k])) found = 1
				m = split(ways[i], words, /[\/_]/)
				for (k = 1; k <= m; k++) if (begins(name, words[k])) found = 1
			}
			if (!found && !(file == "functions" && $NF ~ "^(" libm ")$")) print file ".c exports " $NF
		}' libm="$libm" | sort -u
}
found=$(find_strangers libbase.a libmethods.a $(ls libkernels*.a) libtheory.a librun.a libviews.a libpaper.a liblab.a libcli.a)
judge "every exported name has its module's prefix"
echo "1..$number"

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# One gate for writing, one for reading, one door to the terminal: no other file opens, makes, renames or removes
# files, and none puts text on standard error past visible_print(). What is asked are the object files and, for what
# goes to standard error, the lines. CONTRIBUTING.md, "What may come from outside", says why.
cd "${MATVIB_BUILDDIR:-.}" || exit 1
source="${MATVIB_SRCDIR:-..}/src"
ls libbase.a "$source/base/output.c" >/dev/null || exit 1
number=0
judge() { # NAME: well if nothing was found
	number=$((number + 1))
	if [ -z "$found" ]; then
		echo "ok $number - $1"
	else
		echo "not ok $number - $1"
		echo "$found" | sed 's/^/# /'
	fi
}
# every symbol that an object file of the product wants from elsewhere: "liblab.a:terminal.o open"
wanted=$(for library in lib*.a; do
	case $library in libsuite.a | libfuzz*) ;; *) nm -A --undefined-only "$library" 2>/dev/null ;; esac
done | awk '{ sub(/:$/, "", $1); print $1, $NF }' | sed 's/ _/ /; s/@.*//')
main=$(nm --undefined-only src/main.o 2>/dev/null | awk '{ print "main.o", $NF }')
only() { # SYMBOLS ALLOWED NAME: those symbols are needed by the allowed object files only
	found=$(printf '%s\n%s\n' "$wanted" "$main" | grep -E " ($1)(64)?\$" | grep -v -E "^($2) ")
	judge "$3"
}
# the tests look where they think they do
found=$(printf '%s\n' "$wanted" | grep -q '^libbase.a:output.o rename' || echo 'output.o renames nothing')
judge "the gate is found"

only 'fopen|freopen|tmpfile|mkstemp|mkostemp|creat|openat' 'nobody' "no file is opened by another way"
only 'open' 'libbase.a:(input|output).o|liblab.a:terminal.o' \
	"files are opened by the gates, the terminal by itself"
only 'rename|renameat|renameat2|link|linkat|symlink|unlink|unlinkat|remove|mkdir|mkdirat|rmdir|truncate|ftruncate|chmod|fchmod' \
	'libbase.a:output.o|liblab.a:grid.o' "files are made, renamed and removed by the gate"
only 'system|popen|execl|execlp|execle|execv|execvp|execve|posix_spawn' 'nobody' "no program is started"
only '(mv)?w?add(n)?(w)?str|w?add_wch|waddch|addch|tputs|putp|vid_puts' 'liblab.a:(grid|painter|terminal).o' \
	"the terminal is written to by its own files"

# Text for standard error goes through the door; what is left are words of the program itself.
found=$(cd "$source" && grep -rnE --include='*.c' '(^|[^_])(f?printf|vf?printf|puts|putc|fputc|fputs|fwrite)\([^;]*stderr' . |
	grep -v -E '^\./base/(visible|assertion)\.c:|fputs\("[^"%]*", stderr\)')
judge "standard error gets text through the door"
found=$(cd "$source" && grep -rnE --include='*.c' 'perror\(|psignal\(|dprintf\(|write\(STDERR_FILENO|write\(2,' .)
judge "and by no other way"
found=$(cd "$source" && grep -rnE --include='*.c' 'asker *= *ASKER_(COMMAND_LINE|KEYBOARD|SCRIPT)' run export lessons scenario problems answers picture views panes help)
judge "who asks is not made up below the front ends"
# A status may be NULL: whoever does not want to know passes none.
found=$(cd "$source" && grep -rnE --include='*.c' '^ *\*status = ' . | grep -v -E '^\./(base/status\.c|cli/|plain/)')
judge "a status is handed on by status_take()"
echo "1..$number"

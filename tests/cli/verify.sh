#!/bin/sh
# The command as people type it: tables on stdout, one line on stderr, exit statuses.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=verify

echo 1..11
expect "figure 3 of the bar holds" 0 M-fig3
result "it names the figure" says out '^M-fig3  mode 5'
result "it tells paper, prediction and measurement" says out 'error of omega, % *about 5 *-4.239 *-4.239 .*holds'
result "it says how many hold" says out '^[0-9]* of [0-9]* hold$'
result "nothing on stderr" lines err 0
expect "the list" 0 --list
result "names figures of both papers" says out '^P-fig10 '
expect "an unknown name is bad usage" 2 M-fig1
result "one line says what is allowed" lines err 1
result "which line" says err '^matvib: verify: unknown name "M-fig1" (.*--list'
expect "an unknown option is bad usage" 2 --fast

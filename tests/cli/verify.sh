#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The command as people type it: tables on stdout, one line on stderr, exit statuses.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=verify

expect "figure 3 of the bar is reproduced" 0 M-fig3
result "it names the figure" says out '^M-fig3  mode 5'
result "it tells eigenvalue and measurement" says out 'error of omega, % *-4.239 *-4.239$'
result "under them our reference" says out '^    our reference: -4.240..-4.238: reproduces$'

result "and the paper" says out '^    the paper: "approximately 5% of the analytical value": near, -15 %$'

result "it counts ours" says out '^ours: 6 of 6 reproduced; 1 of 1 bounds hold$'
result "and the paper's" says out '^paper: 1 agree, 2 near, 0 differ, 3 not given$'

result "nothing on stderr" lines err 0
expect "loads, no prediction, both sides of a critical step, a crack that branches" 0 M-load M-alone P-step P-rest P-branching
result "work and places are those of theory" says out '^  traction: work, 1e-6 '
result "and an unstable step is seen to be so" says out '^  E/E0 at 1.045 of it  *inf$'
expect "bodies: APIC strains and turns exactly, keeps momenta, and a beam falls as finite elements do" 0 B-affine B-kept B-order B-fall
result "an order of two" says out '^    order, dx .1 to .05  *1.95$'
result "FLIP loses what APIC keeps" says out '^    angular momentum/exact  *1.000000000000  *0.6806'
expect "the list" 0 --list
result "names figures of both papers" says out '^P-fig10 '
expect "an unknown name is bad usage" 2 M-fig1
result "one line says what is allowed" lines err 1
result "which line" says err '^matvib: verify: unknown name "M-fig1" (.*--list'
expect "an unknown option is bad usage" 2 --fast

# --- interrupted, in the middle of a run of some ten seconds
"$MATVIB" verify P-fig10 --full >out 2>err &
soon test -s out
soon works $! 20
kill -TERM $!
ends $!
result "a signal ends it with its status" test $? -eq 143
result "and it says so" says err '^matvib: verify: interrupted after 0 rows$'
result "without counts" sh -c '! grep -q "^ours:" out'
echo "1..$number"

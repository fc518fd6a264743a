# Writes the rows of `matvib verify` as a C table: awk -f claims.awk FILE... > FILE.c. In the files (data/verify):
#
#     # words                        for who reads it
#     NAME := words                  {NAME} stands for them in the lines below; like forms, in this file
#     form NAME | KEY=WORDS | ...    what a row of that form is made of, $1, $2, ... being its cells; a line that
#                                    begins with blanks goes on; a second form of the name makes a second row
#     [NAME] title                   a check
#     note words                     printed under its rows
#     NAME | CELL | CELL ...         a row of that form; of the form "row" each cell is KEY=WORDS
#
# Keys are the members of VerifyRow (src/cli/verify/verify.h); one without words is left out. what: each ">"
# before it sets it in. Numbers may be constant expressions. reference, bound: "A +- B", "A .. B", or one number.
# paper, also: "prints A: WORDS", "about A: WORDS" or "taken as A .. B: WORDS", and "// REMARK" behind.

function fail(why)
{
    print FILENAME ":" FNR ": " why > "/dev/stderr"
    exit 1
}

function trim(text)
{
    gsub(/^[ \t]+|[ \t]+$/, "", text)
    return text
}

function quoted(text)
{
    gsub(/\\/, "\\\\", text)
    gsub(/"/, "\\\"", text)
    return "\"" text "\""
}

# A text with other words for each `name` in it.
function replaced(text, name, words,    at, done)
{
    for (; (at = index(text, name)) > 0; text = substr(text, at + length(name)))
        done = done substr(text, 1, at - 1) words
    return done text
}

function band(text,    ends)
{
    if (split(text, ends, / [+]- /) == 2)
        return "WITHIN(" ends[1] ", " ends[2] ")"
    if (split(text, ends, / [.][.] /) == 2)
        return "{" ends[1] ", " ends[2] "}"
    return "{" text ", " text "}"
}

function claim(text,    at, head, words, parts)
{
    at = index(text, ": ")
    head = substr(text, 1, at - 1)
    words = substr(text, at + 2)
    if (sub(/^taken as /, "", head) && split(head, parts, / [.][.] /) == 2)
        return "CLAIM(" quoted(words) ", " parts[1] ", " parts[2] ")"
    if (sub(/^about /, "", head))
        return "ABOUT(" quoted(words) ", " head ")"
    if (!sub(/^prints /, "", head))
        fail("what does the paper say? " text)
    if (split(words, parts, / \/\/ /) == 2)
        return "PRINTS_WITH_REMARK(" quoted(parts[1]) ", " head ", " quoted(parts[2]) ")"
    return "PRINTS(" quoted(words) ", " head ")"
}

function value(key, words,    inset)
{
    if (key == "what") {
        for (; sub(/^>/, "", words);)
            inset = inset "  "
        return quoted(inset trim(words))
    }
    if (key ~ /^(scenario|column|other)$/)
        return quoted(words)
    if (key ~ /^(quantity|theory|eigenvalue|predicted)$/)
        return "quantity_" words
    if (key ~ /^(reference|bound)$/)
        return band(words)
    if (key ~ /^(paper|also)$/)
        return claim(words)
    return words
}

function put_row(form, cells, count,    members, n, i, k, at, key, words, row)
{
    n = split(form, members, "|")
    for (i = 1; i <= n; i++) {
        if ((at = index(members[i], "=")) == 0)
            fail("no KEY=WORDS: " members[i])
        key = trim(substr(members[i], 1, at - 1))
        words = substr(members[i], at + 1)
        for (k = 9; k > 0; k--)
            words = replaced(words, "$" k, k <= count ? trim(cells[k]) : "")
        if ((words = trim(words)) != "")
            row = row "." key " = " value(key, words) ", "
    }
    print "    {" row "},"
}

function end_check()
{
    if (checks)
        print "};"
}

BEGIN {
    print "/* SPDX-License-Identifier: GPL-3.0-or-later */"
    print "/* Generated from data/verify by tools/claims.awk. */"
    print "#include \"cli/verify/verify.h\""
}

FNR == 1 { # names and forms are a file's own
    n_names = 0
    split("", n_forms)
}

/^#/ || NF == 0 { next }

{
    for (i = 1; i <= n_names; i++)
        $0 = replaced($0, "{" names[i] "}", stands_for[i])
}

$2 == ":=" {
    names[++n_names] = $1
    stands_for[n_names] = trim(substr($0, index($0, ":=") + 2))
    next
}

/^form / {
    at = index($0, "|")
    form = trim(substr($0, 6, at - 6))
    forms[form, ++n_forms[form]] = substr($0, at + 1)
    next
}

/^ / {
    forms[form, n_forms[form]] = forms[form, n_forms[form]] $0
    next
}

/^\[/ {
    end_check()
    at = index($0, "]")
    name[++checks] = quoted(substr($0, 2, at - 2))
    title[checks] = quoted(substr($0, at + 2))
    printf "\nstatic const VerifyRow rows_%d[] = {\n", checks
    next
}

/^note / {
    note[checks] = note[checks] (note[checks] ? "\n     \"\\n\" " : "") quoted(substr($0, 6))
    next
}

/^row / {
    put_row(substr($0, index($0, "|") + 1), cells, 0)
    next
}

{
    n = split($0, words, "|")
    form = trim(words[1])
    if (!(form in n_forms))
        fail("no form " form)
    for (i = 2; i <= n; i++)
        cells[i - 1] = words[i]
    for (i = 1; i <= n_forms[form]; i++)
        put_row(forms[form, i], cells, n - 1)
}

END {
    end_check()
    print "\nconst VerifyCheck verify_checks[] = {"
    for (i = 1; i <= checks; i++)
        printf "    {%s, %s, VERIFY_ROWS(rows_%d), %s},\n", name[i], title[i], i, note[i] ? note[i] : "NULL"
    print "    {.name = NULL},\n};"
}

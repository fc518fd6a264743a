/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The one grammar of what is typed: quantities ("70 GPa"), what an exercise asks ("abs(error) < 1 and cells
 * <= 60") and answers to it. By recursive descent, with the usual precedence:
 *
 *     truth     both { "or" both }
 *     both      relation { "and" relation }
 *     relation  sum [("<" | "<=" | ">" | ">=" | "=" | "!=") sum]
 *     sum       product { ("+" | "-") product }
 *     product   signed { ("*" | "/") signed | unit }       a unit behind a number multiplies it
 *     signed    ("-" | "+") signed | power
 *     power     primary ["%"] ["^" ["-"] digit]
 *     primary   NUMBER | WORD | "abs" "(" sum ")" | "(" truth ")"
 *
 * What words are, and what is made of numbers and verbs, which come in the order of a stack, is the
 * dialect's. */
#ifndef BASE_GRAMMAR_H
#define BASE_GRAMMAR_H

#include <stdbool.h>
#include <stddef.h>

/* Signs between two sides by how close they bind. */
typedef enum GrammarLevel {
    LEVEL_OR,
    LEVEL_AND,
    LEVEL_RELATION,
    LEVEL_SUM,
    LEVEL_PRODUCT,
    LEVELS
} GrammarLevel;

typedef enum GrammarVerb {
    VERB_MINUS,
    VERB_ABS,
    VERB_PERCENT,
    VERB_POWER,
    VERB_ADD,
    VERB_SUBTRACT,
    VERB_MULTIPLY,
    VERB_DIVIDE,
    VERB_LESS,
    VERB_NOT_MORE,
    VERB_MORE,
    VERB_NOT_LESS,
    VERB_EQUAL,
    VERB_UNEQUAL,
    VERB_AND,
    VERB_OR
} GrammarVerb;

typedef struct Grammar Grammar;

/* Each returns false where it has refused. */
typedef struct GrammarDialect {
    GrammarLevel level; /* of a whole text, and of the text in brackets */
    bool has_units;
    bool (*number)(Grammar *, double value);
    bool (*word)(Grammar *); /* a letter is at `at` */
    bool (*apply)(Grammar *, GrammarVerb, int power);

    /* NULL, or reads the sign of a relation and what is right of it where that is not a sum, as the left
     * side, a single word, has it. */
    bool (*choose)(Grammar *, GrammarVerb, bool *chosen);

    /* Says that the text is wrong: what is expected in place of `token`; or, `wanted` NULL, what it is. */
    bool (*refuse)(Grammar *, const char *wanted, const char *token);
} GrammarDialect;

struct Grammar {
    const GrammarDialect *dialect;
    void *context;
    const char *text, *at; /* begins there; the next token */
    const char *end;       /* of the last token */
    int depth, operands;   /* and how many steps have come of it */
};

Grammar grammar_of(const GrammarDialect *, void *context, const char *text);

/* One side; *truth: it is a relation, and no number. */
bool grammar_read(Grammar *, GrammarLevel, bool *truth);
bool grammar_expect(Grammar *, bool truth, bool wanted); /* refuses what is not of the wanted kind */

/* For dialects: a letter; a sign or word if it comes next; past so many bytes; a power as behind "^". */
bool grammar_is_letter(char);
bool grammar_take(Grammar *, const char *token);
void grammar_pass(Grammar *, size_t length);
bool grammar_read_power(Grammar *, int *power);
bool grammar_refuse(Grammar *, const char *wanted); /* quotes the text from here on */

/* The next token: a word with digits, points and hyphens in it, a number, a sign. */
size_t grammar_token(const Grammar *, char *out, size_t size);

#endif

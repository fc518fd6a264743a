/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/spell.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Of letters, and of signs that are read as words. */
static const char *const symbols[][2] = {
    {"Δ", "d"},      {"ε", "e"},     {"σ", "s"},     {"ω", "w"},   {"Ω", "W"},     {"α", "alpha"},
    {"β", "beta"},   {"γ", "gamma"}, {"δ", "delta"}, {"ρ", "rho"}, {"φ", "phi"},   {"ξ", "xi"},
    {"η", "eta"},    {"μ", "mu"},    {"ν", "nu"},    {"π", "pi"},  {"κ", "kappa"}, {"θ", "theta"},
    {"λ", "lambda"}, {"τ", "tau"},   {"Σ", "sum"},   {"∫", "int"}, {"√", "sqrt"},  {"∂", "d"},
};
static const char *const marks[][2] = {
    {"→", "->"},  {"←", "<-"},   {"×", "x"},    {"′", "'"},  {"↑", "Up"}, {"↓", "Down"},
    {"½", "1/2"}, {"⅔", "2/3"},  {"⁻¹", "^-1"}, {"²", "^2"}, {"³", "^3"}, {"⁴", "^4"},
    {"₀", "0"},   {"₁", "1"},    {"−", "-"},    {"≤", "<="}, {"≥", ">="}, {"±", "+-"},
    {"…", "..."}, {"°", " deg"}, {"»", ">>"},   {"«", "<<"},
};

static const char *spelled(const char *const table[][2], size_t count, const char **text)
{
    for (size_t i = 0; i < count; i++) {
        const size_t length = strlen(table[i][0]);
        if (strncmp(*text, table[i][0], length) == 0) {
            *text += length;
            return table[i][1];
        }
    }
    return NULL;
}

static bool is_alphanumeric(const char *text, size_t at)
{
    return isalnum((unsigned char)text[at]) != 0;
}

void spell_ascii(const char *text, char *out, size_t size)
{
    size_t used = 0;
    bool word = false; /* the last symbol became one */
    while (*text != '\0') {
        const char *from = spelled(symbols, sizeof symbols / sizeof *symbols, &text), *symbol = from;
        if (!from)
            from = spelled(marks, sizeof marks / sizeof *marks, &text);
        const char letter[] = {*text, '\0'};
        if (!from) {
            from = letter;
            text++;
        }
        /* "d" of "dσ" and "Δσ" belongs to what is behind it, unless it ends a word or a product. */
        const bool apart =
            used > 0 && is_alphanumeric(out, used - 1) && is_alphanumeric(from, 0) &&
            (word || (symbol && !(out[used - 1] == 'd' && (used == 1 || !is_alphanumeric(out, used - 2)))));
        if (used + apart + strlen(from) >= size)
            break;
        used += (size_t)snprintf(out + used, size - used, "%s%s", apart ? " " : "", from);
        word = symbol && symbol[1];
    }
    out[used] = '\0';
}

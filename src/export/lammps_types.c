/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cuts as types of atoms.
 *
 * A cut parts bonds one by one, and LAMMPS leaves out pairs by the types of the two alone. So types are given
 * such that any two of them, as far as their nodes are in reach of each other, have either all bonds or none:
 * far from the ends of a straight cut one type on each of its sides does, at an end nodes need their own.
 * Where no two nodes are in reach, their types say nothing of each other; so the ends of several cuts share
 * theirs. Each node with a cut bond joins the first type that agrees, or makes one.
 *
 * (Special bonds would leave out pairs one by one, but need atom_style hybrid, and with peri in it LAMMPS of
 * September 2021 crashes.) */
#include "export/lammps_internal.h"
#include "scenario/settings.h"
#include "problems/problem.h"

#include <stdlib.h>

enum { TYPES_MAX = 1000 };

/* Of two nodes in reach, or of all such pairs between two types. */
enum { RELATION_NONE, RELATION_WHOLE, RELATION_CUT };

typedef struct Partner {
    size_t node;
    unsigned char relation;
} Partner;

/* Numbers are those of nodes with cut bonds, which alone have partners here. */
typedef struct Sorting {
    size_t *number, count; /* of all nodes from 1; 0: it has no cut bond */
    size_t *first;         /* partner of each, and one more */
    Partner *partners;
    unsigned char *toward[TYPES_MAX]; /* how a type's nodes stand to each node */
    unsigned char *between;           /* and to each type; TYPES_MAX a row */
    bool is_protected[TYPES_MAX];
    int n_types;
} Sorting;

static void free_sorting(Sorting *sorting)
{
    free(sorting->number);
    free(sorting->first);
    free(sorting->partners);
    free(sorting->between);
    for (int t = 0; t < sorting->n_types; t++)
        free(sorting->toward[t]);
}

/* The bonds between nodes with cut bonds, by their nodes. */
static bool list_partners(Sorting *sorting, const LammpsBody *body)
{
    sorting->number = calloc(body->count, sizeof *sorting->number);
    sorting->between = calloc(TYPES_MAX, TYPES_MAX);
    if (!sorting->number || !sorting->between)
        return false;
    for (size_t b = 0; b < body->n_bonds; b++)
        if (body->cut[b] != 0)
            sorting->number[(size_t)body->bond_i[b]] = sorting->number[(size_t)body->bond_j[b]] = 1;
    for (size_t k = 0; k < body->count; k++)
        if (sorting->number[k] != 0)
            sorting->number[k] = ++sorting->count;
    sorting->first = calloc(sorting->count + 2, sizeof *sorting->first);
    if (!sorting->first)
        return false;
    for (int filling = 0; filling < 2; filling++) {
        for (size_t b = 0; b < body->n_bonds; b++) {
            const size_t ends[] = {sorting->number[(size_t)body->bond_i[b]],
                                   sorting->number[(size_t)body->bond_j[b]]};
            for (int e = 0; e < 2 && ends[0] != 0 && ends[1] != 0; e++) {
                /* counted one place further, so that filling ends with each at the first of its own */
                size_t *place = &sorting->first[ends[e]];
                if (filling)
                    sorting->partners[--*place] =
                        (Partner){ends[1 - e] - 1, body->cut[b] != 0 ? RELATION_CUT : RELATION_WHOLE};
                else
                    ++*place;
            }
        }
        for (size_t k = 1; k <= sorting->count + 1 && !filling; k++)
            sorting->first[k] += sorting->first[k - 1];
        if (!filling)
            sorting->partners = calloc(sorting->first[sorting->count + 1] + 1, sizeof *sorting->partners);
        if (!sorting->partners)
            return false;
    }
    return true;
}

static bool agree(unsigned char a, unsigned char b)
{
    return a == RELATION_NONE || b == RELATION_NONE || a == b;
}

static unsigned char *between(Sorting *sorting, int a, int b)
{
    return &sorting->between[a * TYPES_MAX + b];
}

/* Whether a node may be of a type: it stands to each partner, and to each type, as that does. */
static bool fits(Sorting *sorting, size_t node, int type)
{
    for (size_t p = sorting->first[node + 1]; p < sorting->first[node + 2]; p++)
        if (!agree(sorting->toward[type][sorting->partners[p].node], sorting->partners[p].relation))
            return false;
    for (int other = 0; other < sorting->n_types; other++)
        if (sorting->toward[other] && !agree(*between(sorting, type, other), sorting->toward[other][node]))
            return false;
    return true;
}

static void join(Sorting *sorting, size_t node, int type)
{
    for (size_t p = sorting->first[node + 1]; p < sorting->first[node + 2]; p++)
        sorting->toward[type][sorting->partners[p].node] = sorting->partners[p].relation;
    for (int other = 0; other < sorting->n_types; other++)
        if (sorting->toward[other] && sorting->toward[other][node] != RELATION_NONE)
            *between(sorting, type, other) = *between(sorting, other, type) = sorting->toward[other][node];
}

/* The first type that fits; -1: there are too many, or memory is short. Types 0 and 1 are those of nodes
 * without cut bonds. */
static int find_type(Sorting *sorting, size_t node, bool is_protected)
{
    for (int type = 2; type < sorting->n_types; type++)
        if (sorting->is_protected[type] == is_protected && fits(sorting, node, type))
            return type;
    if (sorting->n_types == TYPES_MAX)
        return -1;
    unsigned char *toward = calloc(sorting->count, 1);
    if (!toward)
        return -1;
    sorting->toward[sorting->n_types] = toward;
    sorting->is_protected[sorting->n_types] = is_protected;
    return sorting->n_types++;
}

/* The numbers of the types for LAMMPS, from 1: those that are protected come last. */
static void number_types(Sorting *sorting, LammpsBody *body, int numbers[TYPES_MAX])
{
    body->n_types = 0;
    for (int is_protected = 0; is_protected < 2; is_protected++) {
        for (int type = 0; type < sorting->n_types; type++)
            if (sorting->is_protected[type] == is_protected && (type != 1 || lammps_protects(body)))
                numbers[type] = ++body->n_types;
        if (!is_protected)
            body->first_protected = body->n_types + 1;
    }
}

static bool keep(Sorting *sorting, LammpsBody *body)
{
    int numbers[TYPES_MAX];
    number_types(sorting, body, numbers);
    const size_t n = (size_t)body->n_types + 1;
    body->apart = calloc(n * n, sizeof *body->apart);
    if (!body->apart)
        return false;
    for (int a = 2; a < sorting->n_types; a++)
        for (int b = 2; b < sorting->n_types; b++)
            body->apart[(size_t)numbers[a] * n + (size_t)numbers[b]] =
                *between(sorting, a, b) == RELATION_CUT;
    for (size_t k = 0; k < body->count; k++)
        body->type[k] = numbers[body->type[k]];
    return true;
}

static bool sort_nodes(Sorting *sorting, LammpsBody *body, Status *status)
{
    const bool protects = lammps_protects(body);
    sorting->n_types = 2;
    sorting->is_protected[1] = true;
    for (size_t k = 0; k < body->count; k++) {
        const bool is_protected = protects && body->protected_node[k] != 0;
        body->type[k] = is_protected;
        if (sorting->number[k] == 0)
            continue;
        const size_t node = sorting->number[k] - 1;
        body->type[k] = find_type(sorting, node, is_protected);
        if (body->type[k] < 0)
            return sorting->n_types < TYPES_MAX
                       ? status_fail(status, "not enough memory for the cuts")
                       : status_fail(status, "%s: LAMMPS would need more than %d types of atoms",
                                     body->settings->problem->concerns & CONCERN_PLATE ? "cuts" : "notch",
                                     TYPES_MAX);
        join(sorting, node, body->type[k]);
    }
    return true;
}

bool lammps_set_types(LammpsBody *body, Status *status)
{
    Sorting sorting = {0};
    bool done = false;
    body->type = calloc(body->count, sizeof *body->type);
    if (!body->type || !list_partners(&sorting, body))
        status_fail(status, "not enough memory for %zu nodes", body->count);
    else if (sort_nodes(&sorting, body, status))
        done = keep(&sorting, body) || status_fail(status, "not enough memory for %d types", body->n_types);
    free_sorting(&sorting);
    return done;
}

void lammps_write_cuts(FILE *file, const LammpsBody *body)
{
    const size_t n = (size_t)body->n_types + 1;
    for (size_t a = 1; a < n; a++)
        for (size_t b = a; b < n; b++)
            if (body->apart[a * n + b])
                fprintf(file, "neigh_modify exclude type %zu %zu\n", a, b);
}

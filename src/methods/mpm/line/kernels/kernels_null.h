/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Part of kernels.c: what the grid cannot see of the particles' motion (bar_null.h), for hats.
 *
 * Where a range of cells is left by all unknowns but its two outermost nodes, orthogonal transformations
 * leave a triangle of it:
 *
 *     x u_near + y u_far = v
 *                t u_far = u          and the sum of the squares of what no u can change
 *
 * For one cell that is the triangle of its particles' rows. Two neighbours, both with the node they share as
 * the near one, make one: the shared node's two entries are rotated into one row, which this node satisfies;
 * three rows are left for two nodes, and a rotation for each of these leaves one number. Eight cells go in
 * three levels of pairs, then eight of these, and so on: what is done depends on the cells' numbers alone,
 * and the lanes of a vector hold different eights.
 *
 * Rotations are merged so that a pair of cells takes two roots: with B the row that the shared node leaves
 * behind, kept q^(1/2) times too large, and A the row (t | u),
 *     q = x^2 + x'^2   q2 = t^2 q + B^2   ->  of A and B the near row (t q A + b B) / (q q2)^(1/2), and t B -
 * b A, q2^(1/2) times too large; likewise this with the other triangle's (t | u). Where such a product is too
 * small for a double - a node without particles, a support, a node that only the far end of a long row of
 * cells hangs on - the lane is done with plain rotations, in which a zero is allowed. */
#include "methods/mpm/line/bar_null.h"

/* Below this, the product of squares may have lost digits to underflow. */
static const double null_small = 1e-250;

typedef struct Triangles {
    Vector part[NULL_PARTS];
} Triangles;

KERNEL_INLINE BarTriangle lane_of(const Vector *part, int lane)
{
    BarTriangle triangle;
    for (int i = 0; i < NULL_PARTS; i++)
        triangle.part[i] = part[i][lane];
    return triangle;
}

KERNEL_INLINE void set_lane(Vector *part, int lane, BarTriangle triangle)
{
    for (int i = 0; i < NULL_PARTS; i++)
        part[i][lane] = triangle.part[i];
}

/* x where the mask holds, else 0. */
KERNEL_INLINE Vector only(VectorMask mask, Vector x)
{
    return (Vector)((VectorMask)x & mask);
}

/* Not all of `count` vectors are 0. */
KERNEL_INLINE VectorMask is_there(const Vector *part, int count)
{
    VectorMask there = {0};
    for (int i = 0; i < count; i++)
        there |= part[i] != 0.0;
    return there;
}

/* --- the triangle of a cell ----------------------------------------------------------------------- */

/* Cells with P particles at s, both nodes free. The right node is the near one, or the left. The mask: lanes
 * to be done otherwise. */
KERNEL_INLINE VectorMask triangle_of_cells(int slots, bool left, const Vector *s, const Vector *v,
                                           Triangles *triangles)
{
    const Vector none = {0};
    Vector x = left ? 1.0 - s[0] : s[0], y = left ? s[0] : 1.0 - s[0], value = v[0];
    Vector t = none, u = none, sum = none;
    VectorMask fine = x * x > null_small;
    for (int j = 1; j < slots; j++) {
        const Vector near = left ? 1.0 - s[j] : s[j], far = left ? s[j] : 1.0 - s[j];
        const Vector q = x * x + near * near, over = 1.0 / vector_root(q);
        const Vector rest = (x * far - near * y) * over, rest_value = (x * v[j] - near * value) * over;
        y = (x * y + near * far) * over;
        value = (x * value + near * v[j]) * over;
        x = q * over;
        if (j == 1) {
            t = rest;
            u = rest_value;
        } else {
            const Vector q2 = t * t + rest * rest, over2 = 1.0 / vector_root(q2);
            const Vector lost = (t * rest_value - rest * u) * over2;
            fine &= q2 > null_small;
            sum += lost * lost;
            u = (t * u + rest * rest_value) * over2;
            t = q2 * over2;
        }
    }
    triangles->part[NULL_X] = x;
    triangles->part[NULL_Y] = y;
    triangles->part[NULL_V] = value;
    triangles->part[NULL_T] = t;
    triangles->part[NULL_U] = u;
    triangles->part[NULL_SUM] = sum;
    return ~fine;
}

/* Whether all nodes of cells [c, c + VECTOR_WIDTH eights) are free. */
KERNEL_INLINE bool nodes_are_free(const Bar *bar, int c)
{
    const int end = c + 8 * VECTOR_WIDTH;
    VectorMask free = bar->node_inverse[end] > 0.0 ? ~(VectorMask){0} : (VectorMask){0};
    for (int i = c; i < end; i += VECTOR_WIDTH)
        free &= vector_load(bar->node_inverse + i) > 0.0;
    return c >= bar->fixed_left && end < bar->n_nodes - bar->fixed_right && vector_is_zero(~free);
}

/* Particles of every eighth cell from c on, where such a cell is like most: P particles, both nodes free.
 * The mask: where not. */
KERNEL_INLINE VectorMask gather_cells(const Bar *bar, int slots, int c, int end, Vector *s, Vector *v)
{
    VectorMask other = {0};
    for (int j = 0; j < slots; j++)
        s[j] = v[j] = (Vector){0};
    for (int lane = 0; lane < VECTOR_WIDTH; lane++, c += 8) {
        if (c >= end || bar->first[c + 1] - bar->first[c] != slots || !bar_node_moves(bar, c) ||
            !bar_node_moves(bar, c + 1)) {
            other[lane] = -1;
            continue;
        }
        Place at = place_of(bar, bar->first[c]);
        for (int j = 0; j < slots; j++, at = next_place(bar, at)) {
            s[j][lane] = bar->s[at.slot][at.k];
            v[j][lane] = bar->v[at.slot][at.k];
        }
    }
    return other;
}

/* The lanes that are not like most, by plain rotations; cells behind the end are empty. */
static __attribute__((noinline)) void mend_cells(const Bar *bar, int c, int end, VectorMask bad,
                                                 Triangles *triangles)
{
    for (int lane = 0; lane < VECTOR_WIDTH; lane++, c += 8)
        if (bad[lane])
            set_lane(triangles->part, lane, c < end ? bar_null_cell(bar, c, c % 2) : (BarTriangle){{0}});
}

/* The triangles of `lanes` eights of cells from c on: eight[r] those of each eight's cell r. */
KERNEL_INLINE void triangles_of_cells(const Bar *bar, int slots, int c, int lanes, Triangles *eight)
{
    const int whole = c + 8 * VECTOR_WIDTH, end = c + 8 * lanes < bar->n_cells ? c + 8 * lanes : bar->n_cells;
    if (bar->first[c] == bar->first[end]) {
        for (int r = 0; r < 8; r++)
            for (int i = 0; i < NULL_PARTS; i++)
                eight[r].part[i] = (Vector){0};
        return;
    }
    const bool run = whole <= end && bar_run_end(bar, c, end) == end && nodes_are_free(bar, c);
    double *s_of[BAR_SLOTS_MAX], *v_of[BAR_SLOTS_MAX];
    slots_of_run(bar->s, slots, bar->first[c], s_of);
    slots_of_run(bar->v, slots, bar->first[c], v_of);
#pragma GCC unroll 8
    for (int r = 0; r < 8; r++) {
        Vector s[BAR_SLOTS_MAX], v[BAR_SLOTS_MAX];
        VectorMask bad = {0};
        s[0] = v[0] = (Vector){0};
        if (run)
            for (int j = 0; j < slots; j++) {
                s[j] = vector_load_every_eighth(s_of[j] + r);
                v[j] = vector_load_every_eighth(v_of[j] + r);
            }
        else
            bad = gather_cells(bar, slots, c + r, end, s, v);
        bad |= triangle_of_cells(slots, r % 2, s, v, &eight[r]);
        if (!vector_is_zero(bad))
            mend_cells(bar, c + r, end, bad, &eight[r]);
    }
}

/* --- two triangles into one ----------------------------------------------------------------------- */

/* Likewise where a pair's merged rotations would lose digits. */
static __attribute__((noinline)) void mend(Triangles *joined, const Vector *a, const Vector *b,
                                           VectorMask bad)
{
    for (int lane = 0; lane < VECTOR_WIDTH; lane++)
        if (bad[lane]) {
            const BarTriangle first = lane_of(a, lane), second = lane_of(b, lane);
            set_lane(joined->part, lane, bar_null_join(&first, &second));
        }
}

/* The near node is the first one's far node. The result may take the place of one of the two. */
KERNEL_INLINE void join(Triangles *joined, const Triangles *first, const Triangles *second)
{
    Vector a[NULL_PARTS], b[NULL_PARTS];
#pragma GCC unroll 8
    for (int i = 0; i < NULL_PARTS; i++) {
        a[i] = first->part[i];
        b[i] = second->part[i];
    }
    const Vector q = a[NULL_X] * a[NULL_X] + b[NULL_X] * b[NULL_X];
    const Vector near = b[NULL_X] * a[NULL_Y], far = a[NULL_X] * b[NULL_Y];
    const Vector value = b[NULL_X] * a[NULL_V] - a[NULL_X] * b[NULL_V];

    const Vector t = a[NULL_T] * q, q2 = a[NULL_T] * t + near * near, square = q * q2;
    const VectorMask fine = square > null_small;
    const Vector over = only(fine, 1.0 / vector_root(square)), turn = near * over;
    const Vector far2 = a[NULL_T] * far, value2 = a[NULL_T] * value - near * a[NULL_U];

    const Vector t3 = b[NULL_T] * q2, q3 = b[NULL_T] * t3 + far2 * far2, square3 = q2 * q3;
    const VectorMask fine3 = square3 > null_small;
    const Vector over3 = only(fine3, 1.0 / vector_root(square3));
    const Vector lost = (b[NULL_T] * value2 + far2 * b[NULL_U]) * over3;

    joined->part[NULL_X] = q2 * over;
    joined->part[NULL_Y] = -(far * turn);
    joined->part[NULL_V] = (t * over) * a[NULL_U] + turn * value;
    joined->part[NULL_T] = q3 * over3;
    joined->part[NULL_U] = (t3 * b[NULL_U] - far2 * value2) * over3;
    joined->part[NULL_SUM] = (a[NULL_SUM] + b[NULL_SUM]) + lost * lost * q2;
    if (vector_is_zero(~(fine & fine3)))
        return;
    /* where all is 0, nothing is lost */
    const Vector rest[] = {b[NULL_T], b[NULL_U], far2, value2};
    const VectorMask bad =
        (~fine & (is_there(a, NULL_SUM) | is_there(b, NULL_SUM))) | (~fine3 & is_there(rest, 4));
    if (!vector_is_zero(bad))
        mend(joined, a, b, bad);
}

/* Eights of neighbours, lane by lane, into one each. Those with even numbers have their right node as the
 * near one, the others the left. The first lane's eight has this number. */
static void join_eights(Triangles *eight, int number, Triangles *one)
{
    for (int count = 4; count > 1; count /= 2)
        for (int k = 0; k < count; k++)
            join(&eight[k], &eight[2 * k + 1 - k % 2], &eight[2 * k + k % 2]);
    VectorMask odd;
    for (int lane = 0; lane < VECTOR_WIDTH; lane++)
        odd[lane] = -(int64_t)((number + lane) % 2);
    Triangles first, second;
    for (int i = 0; i < NULL_PARTS; i++) {
        const VectorMask left = (VectorMask)eight[0].part[i], right = (VectorMask)eight[1].part[i];
        first.part[i] = (Vector)((left & odd) | (right & ~odd));
        second.part[i] = (Vector)((right & odd) | (left & ~odd));
    }
    join(one, &first, &second);
}

/* --- the whole bar -------------------------------------------------------------------------------- */

/* Makes one of `count` triangles, eights by eights, and joins it to what stands left of them. What is missing
 * of an eight is empty. */
static void fold_waiting(BarNullTree *tree, int count)
{
    do {
        const int eights = (count + 7) / 8, lanes = (eights + VECTOR_WIDTH - 1) / VECTOR_WIDTH * VECTOR_WIDTH;
        for (int i = 0; i < NULL_PARTS; i++)
            memset(tree->part[i] + count, 0, (size_t)(8 * lanes - count) * sizeof(double));
        for (int k = 0; k < eights; k += VECTOR_WIDTH) {
            Triangles eight[8], one;
            for (int r = 0; r < 8; r++)
                for (int i = 0; i < NULL_PARTS; i++)
                    eight[r].part[i] = vector_load_every_eighth(tree->part[i] + 8 * k + r);
            join_eights(eight, eights > 1 ? k : 1, &one);
            for (int i = 0; i < NULL_PARTS; i++)
                vector_store(tree->part[i] + k, one.part[i]);
        }
        count = eights;
    } while (count > 1);
    BarTriangle all;
    for (int i = 0; i < NULL_PARTS; i++)
        all.part[i] = tree->part[i][0];
    tree->before = bar_null_join(&all, &tree->before);
}

/* On from the cell where it stands to `end`: eights of cells into one triangle each, and these in groups of
 * NULL_WAITING into the one of all cells before. */
KERNEL_INLINE void null_of_cells(const Bar *bar, int slots, BarNull *null, int end)
{
    BarNullTree *tree = &null->tree;
    while (null->next < end) {
        const int c = null->next, eights = (end - c + 7) / 8;
        const int lanes = eights < VECTOR_WIDTH ? eights : VECTOR_WIDTH;
        Triangles eight[8], one;
        triangles_of_cells(bar, slots, c, lanes, eight);
        join_eights(eight, c / 8, &one);
        for (int i = 0; i < NULL_PARTS; i++)
            vector_store(tree->part[i] + tree->waiting, one.part[i]);
        null->next += 8 * lanes;
        tree->waiting += lanes;
        if (tree->waiting >= NULL_WAITING) {
            fold_waiting(tree, NULL_WAITING);
            tree->waiting -= NULL_WAITING;
            for (int i = 0; i < NULL_PARTS; i++)
                vector_store(tree->part[i], vector_load(tree->part[i] + NULL_WAITING));
        }
    }
    if (end == bar->n_cells && tree->waiting > 0) {
        fold_waiting(tree, tree->waiting);
        tree->waiting = 0;
    }
}

static void null_space(const Bar *bar, BarNull *null, int end)
{
    if (bar->slots == 2)
        null_of_cells(bar, 2, null, end);
    else
        null_of_cells(bar, bar->slots, null, end);
}

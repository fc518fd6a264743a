/* See bonds.h. Compiled once for each CpuLevel, with KERNEL_NAME(x) giving the level's suffix.
 *
 * Vectors are those of the compiler (one type, as wide as the level allows); blocks are always eight columns,
 * and every sum keeps eight partial sums, so that the width leaves no trace. */
#include "physics/pd/bonds.h"

#include <math.h>
#include <stdlib.h>

#if defined(__AVX512F__)
enum { LANES = 8 };
#define LEVEL   CPU_AVX512
#define KERNELS bond_kernels_avx512
#elif defined(__AVX2__)
enum { LANES = 4 };
#define LEVEL   CPU_AVX2
#define KERNELS bond_kernels_avx2
#else
enum { LANES = 2 };
#define LEVEL   CPU_PLAIN
#define KERNELS bond_kernels_plain
#endif

enum { PARTS = LATTICE_BLOCK / LANES };

typedef double Vector __attribute__((vector_size(LANES * sizeof(double))));
typedef double Loose __attribute__((vector_size(LANES * sizeof(double)), aligned(sizeof(double))));
typedef int64_t Mask __attribute__((vector_size(LANES * sizeof(double))));

#define INLINE static inline __attribute__((always_inline))

INLINE Vector load(const double *from)
{
    return *(const Loose *)from;
}

INLINE void store(double *to, Vector value)
{
    *(Loose *)to = value;
}

INLINE bool any(Mask mask)
{
    int64_t all = 0;
    for (int lane = 0; lane < LANES; lane++)
        all |= mask[lane];
    return all != 0;
}

/* The eight partial sums of a block, always added up in this order. */
static double sum_lanes(const double *lanes)
{
    return ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) + ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
}

/* Bonds of one direction whose owners stand side by side. */
typedef struct Segment {
    const Offset *direction;
    double series_limit, break_limit;
    const double *ux, *uy; /* of the owners */
    const double *vx, *vy; /* of the other ends */
    double *coefficient;
    size_t count; /* whole blocks */
} Segment;

/* The series over a segment: forces into fx, fy, the sum of c G w V s^2 into eight parts. False: a
 * live bond lies beyond the series' range or may break, and the segment is to be done bond by bond. */
INLINE bool by_series(const Segment *segment, bool with_forces, bool with_energy, double *restrict fx,
                      double *restrict fy, double *sums)
{
    const Offset *direction = segment->direction;
    const double *restrict coefficient = segment->coefficient;
    const double *restrict ux = segment->ux, *restrict uy = segment->uy;
    const double *restrict vx = segment->vx, *restrict vy = segment->vy;
    const double x = direction->x, y = direction->y, squared = direction->squared;
    const double c0 = direction->series[0], c1 = direction->series[1], c2 = direction->series[2];
    const double c3 = direction->series[3], c4 = direction->series[4], c5 = direction->series[5];
    const Mask magnitude = (Mask){0} + INT64_MAX;
    const Vector limit = (Vector){0} + segment->series_limit;
    Mask beyond = {0};
    Vector sum[PARTS];
    for (int part = 0; part < PARTS; part++)
        sum[part] = (Vector){0};

    for (size_t i = 0; i < segment->count; i += LATTICE_BLOCK) {
        for (int part = 0; part < PARTS; part++) {
            const size_t at = i + (size_t)(part * LANES);
            const Vector ex = load(vx + at) - load(ux + at), ey = load(vy + at) - load(uy + at);
            const Vector rx = x + ex, ry = y + ey;
            const Vector d = ex * (x + rx) + ey * (y + ry);
            const Vector k = load(coefficient + at);
            /* written so that a d which is no number counts as beyond */
            beyond |= ~((Vector)((Mask)d & magnitude) < limit) & (k != 0);
            const Vector series = ((((c5 * d + c4) * d + c3) * d + c2) * d + c1) * d + c0;
            const Vector t = d * series, g = k * t;
            if (with_forces) {
                store(fx + at, g * rx);
                store(fy + at, g * ry);
            }
            if (with_energy) /* s^2 = (t |xi|)^2 (1 + e) */
                sum[part] += g * t * (squared + d);
        }
    }
    if (with_energy)
        for (int part = 0; part < PARTS; part++)
            store(sums + part * LANES, sum[part]);
    return !any(beyond);
}

/* One bond with the root: eta, d and the length. */
typedef struct Bond {
    double rx, ry, d, stretch, length;
} Bond;

static Bond bond_at(const Segment *segment, size_t i)
{
    const Offset *direction = segment->direction;
    double ex = segment->vx[i] - segment->ux[i], ey = segment->vy[i] - segment->uy[i];
    Bond bond = {.rx = direction->x + ex, .ry = direction->y + ey};
    bond.d = ex * (direction->x + bond.rx) + ey * (direction->y + bond.ry);
    bond.length = sqrt(bond.rx * bond.rx + bond.ry * bond.ry);
    bond.stretch = bond.d / (direction->length * (bond.length + direction->length));
    return bond;
}

static double bond_energy(const Segment *segment, size_t i, const Bond *bond)
{
    return segment->coefficient[i] * bond->stretch * bond->stretch;
}

static void write_down(BondLog *log, size_t slot, double energy)
{
    if (log->n_breaks == log->capacity) {
        size_t capacity = log->capacity ? 2 * log->capacity : 256;
        BondBreak *breaks = realloc(log->breaks, capacity * sizeof *breaks);
        if (!breaks) {
            log->no_memory = true;
            return;
        }
        log->breaks = breaks;
        log->capacity = capacity;
    }
    log->breaks[log->n_breaks++] = (BondBreak){(uint32_t)slot, energy};
}

/* The bond has reached s0; whether it breaks is up to its ends. */
static bool may_break(const BondSystem *system, BondPlace bond)
{
    const Offset *direction = &system->lattice->offsets[bond.offset];
    size_t nx = (size_t)system->lattice->nx;
    size_t a = (size_t)bond.j * nx + (size_t)bond.i;
    size_t b = (size_t)(bond.j + direction->q) * nx + (size_t)(bond.i + direction->p);
    return !system->unbreakable[a] && !system->unbreakable[b];
}

/* Bond by bond with the root: breaks what has to break and writes the forces of the rest. */
static void by_root(const BondSystem *system, const Segment *segment, BondPlace first, double *fx, double *fy,
                    BondLog *log)
{
    const Offset *direction = segment->direction;
    for (size_t i = 0; i < segment->count; i++) {
        fx[i] = fy[i] = 0;
        if (segment->coefficient[i] == 0)
            continue;
        Bond bond = bond_at(segment, i);
        BondPlace place = {first.i + (int)i, first.j, first.offset};
        if (bond.d >= segment->break_limit && may_break(system, place)) {
            size_t slot = lattice_slot(system->lattice, place);
            double energy = bond_energy(segment, i, &bond) * direction->length * system->energy_scale;
            segment->coefficient[i] = 0;
            system->broken[slot / 8] = (uint8_t)(system->broken[slot / 8] | 1u << slot % 8);
            write_down(log, slot, energy);
            continue;
        }
        if (!(bond.d < 0.44 * direction->squared)) {
            log->strained = true;
            if (!(bond.d < 3 * direction->squared) && !log->unstable) {
                log->unstable = true;
                log->unstable_slot = lattice_slot(system->lattice, place);
            }
        }
        double g = segment->coefficient[i] * bond.stretch / bond.length;
        fx[i] = g * bond.rx;
        fy[i] = g * bond.ry;
    }
}

static void energy_by_root(const Segment *segment, double *sums)
{
    for (int lane = 0; lane < LATTICE_BLOCK; lane++)
        sums[lane] = 0;
    for (size_t i = 0; i < segment->count; i++)
        if (segment->coefficient[i] != 0) {
            Bond bond = bond_at(segment, i);
            sums[i % LATTICE_BLOCK] += bond_energy(segment, i, &bond);
        }
}

/* The energy of a segment as a function of displacements and coefficients alone, however it is asked for. */
static double segment_energy(const BondSystem *system, const Segment *segment, const double *by_series_sums)
{
    const Offset *direction = segment->direction;
    double sums[LATTICE_BLOCK];
    if (by_series_sums || by_series(segment, false, true, NULL, NULL, sums))
        return sum_lanes(by_series_sums ? by_series_sums : sums) * direction->length * system->energy_scale;
    energy_by_root(segment, sums);
    return sum_lanes(sums) * direction->length * system->energy_scale;
}

static Segment segment_of(const BondSystem *system, int j, int o, size_t from, size_t count)
{
    const Lattice *lattice = system->lattice;
    const Offset *direction = &lattice->offsets[o];
    size_t own = lattice_at(lattice, 0, j) + from;
    size_t other = lattice_at(lattice, 0, j + direction->q) + from;
    ptrdiff_t shift = direction->p;
    return (Segment){direction,
                     system->series_limit[o],
                     system->break_limit[o],
                     system->ux + own,
                     system->uy + own,
                     system->ux + other + shift,
                     system->uy + other + shift,
                     system->coefficient + lattice_slot(lattice, (BondPlace){(int)from, j, o}),
                     count};
}

INLINE void add_own(double *restrict force, const double *restrict parts, int n, size_t count)
{
    for (size_t i = 0; i < count; i += LANES) {
        Vector sum = load(force + i);
        for (int o = 0; o < n; o++)
            sum += load(parts + o * BONDS_SPAN + LATTICE_BLOCK + i);
        store(force + i, sum);
    }
}

/* The other ends: the same force, reversed, p columns on. `parts` hold a block of zeros on either side. */
INLINE void subtract_other(double *restrict force, const double *restrict parts, const Offset *offsets, int n,
                           size_t count)
{
    for (size_t i = 0; i < count + 2 * LATTICE_BLOCK; i += LANES) {
        Vector sum = load(force + i - LATTICE_BLOCK);
        for (int o = 0; o < n; o++)
            sum -= load(parts + o * BONDS_SPAN + (ptrdiff_t)i - offsets[o].p);
        store(force + i - LATTICE_BLOCK, sum);
    }
}

static void clear_margins(double *parts, int n, size_t count)
{
    for (int o = 0; o < n; o++)
        for (int i = 0; i < LATTICE_BLOCK; i++) {
            parts[o * BONDS_SPAN + i] = 0;
            parts[o * BONDS_SPAN + LATTICE_BLOCK + (ptrdiff_t)count + i] = 0;
        }
}

/* All bonds from columns [from, from + count) of row j to row j + q. */
INLINE double tile(const BondSystem *system, int j, int q, size_t from, size_t count, double *const *fx,
                   double *const *fy, BondLog *log, bool with_energy)
{
    const Lattice *lattice = system->lattice;
    const int first = lattice->first[q], n = lattice->first[q + 1] - first;
    double *px = log->scratch, *py = px + BONDS_SCRATCH / 2;
    double energy = 0, sums[LATTICE_BLOCK];

    clear_margins(px, n, count);
    clear_margins(py, n, count);
    for (int o = 0; o < n; o++) {
        Segment segment = segment_of(system, j, first + o, from, count);
        double *sx = px + o * BONDS_SPAN + LATTICE_BLOCK, *sy = py + o * BONDS_SPAN + LATTICE_BLOCK;
        bool fine = by_series(&segment, true, with_energy, sx, sy, sums);
        if (!fine)
            by_root(system, &segment, (BondPlace){(int)from, j, first + o}, sx, sy, log);
        if (with_energy)
            energy += segment_energy(system, &segment, fine ? sums : NULL);
    }
    add_own(fx[0] + from, px, n, count);
    add_own(fy[0] + from, py, n, count);
    subtract_other(fx[q] + from, px, lattice->offsets + first, n, count);
    subtract_other(fy[q] + from, py, lattice->offsets + first, n, count);
    return energy;
}

/* Calls for every tile of row j: whole blocks, as even as they come. */
typedef struct Tiles {
    size_t n, blocks;
} Tiles;

static Tiles tiles_of(const Lattice *lattice)
{
    size_t blocks = lattice->columns / LATTICE_BLOCK, most = BONDS_TILE / LATTICE_BLOCK;
    return (Tiles){(blocks + most - 1) / most, blocks};
}

static size_t tile_start(Tiles tiles, size_t t)
{
    return tiles.blocks * t / tiles.n * LATTICE_BLOCK;
}

static int rows_above(const Lattice *lattice, int j)
{
    int above = lattice->ny - 1 - j;
    return above < lattice->reach ? above : lattice->reach;
}

static void forces(const BondSystem *system, int j, double *const *fx, double *const *fy, BondLog *log,
                   double *energy)
{
    Tiles tiles = tiles_of(system->lattice);
    double sum = 0;
    for (int q = 0; q <= rows_above(system->lattice, j); q++)
        for (size_t t = 0; t < tiles.n; t++) {
            size_t from = tile_start(tiles, t), count = tile_start(tiles, t + 1) - from;
            if (energy)
                sum += tile(system, j, q, from, count, fx, fy, log, true);
            else
                tile(system, j, q, from, count, fx, fy, log, false);
        }
    if (energy)
        *energy = sum;
}

static double energy_of_row(const BondSystem *system, int j)
{
    const Lattice *lattice = system->lattice;
    Tiles tiles = tiles_of(lattice);
    double sum = 0;
    for (int q = 0; q <= rows_above(lattice, j); q++)
        for (size_t t = 0; t < tiles.n; t++) {
            size_t from = tile_start(tiles, t), count = tile_start(tiles, t + 1) - from;
            double part = 0;
            for (int o = lattice->first[q]; o < lattice->first[q + 1]; o++) {
                Segment segment = segment_of(system, j, o, from, count);
                part += segment_energy(system, &segment, NULL);
            }
            sum += part;
        }
    return sum;
}

static void add(double *y, const double *x, double factor, size_t count)
{
    for (size_t i = 0; i < count; i += LANES)
        store(y + i, load(y + i) + factor * load(x + i));
}

static double dot(const double *x, const double *y, size_t count)
{
    Vector sum[PARTS];
    double lanes[LATTICE_BLOCK];
    for (int part = 0; part < PARTS; part++)
        sum[part] = (Vector){0};
    for (size_t i = 0; i < count; i += LATTICE_BLOCK)
        for (int part = 0; part < PARTS; part++)
            sum[part] += load(x + i + part * LANES) * load(y + i + part * LANES);
    for (int part = 0; part < PARTS; part++)
        store(lanes + part * LANES, sum[part]);
    return sum_lanes(lanes);
}

extern const BondKernels KERNELS;
const BondKernels KERNELS = {LEVEL, forces, energy_of_row, add, dot};

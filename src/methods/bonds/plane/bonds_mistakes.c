/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mistakes of a beam's code, and what they do (bonds_mistakes.h). */
#include "methods/bonds/plane/bonds_mistakes.h"

#include "base/assertion.h"
#include <limits.h>
#include <math.h>

/* --- the rows --------------------------------------------------------------------------------------- */

static double of_three_dimensions(const BeamDef *def)
{
    const double delta = def->horizon;
    return 12 * def->youngs_modulus / (M_PI * delta * delta * delta * delta);
}

static double of_plane_strain(const BeamDef *def)
{
    const double delta = def->horizon;
    return 48 * def->youngs_modulus / (5 * M_PI * delta * delta * delta);
}

/* Of a bond's pull the share that an end gets. */
#define SHARE(name, value)                                                                                   \
    static double name(const BondEnd *end)                                                                   \
    {                                                                                                        \
        (void)end;                                                                                           \
        return value;                                                                                        \
    }

SHARE(to_the_left_one, end->left ? 1 : 0)
SHARE(to_the_owner, end->owner ? 1 : 0)
SHARE(to_both_twice, 2)
SHARE(to_the_other_side, -1)
SHARE(to_both_by_half, 0.5)
SHARE(but_to_the_first, end->to_first ? 0 : 1)
SHARE(but_to_the_last, end->to_last ? 0 : 1)
SHARE(over_the_length_now, end->rest / end->now)
SHARE(over_no_length, end->rest)

#define LINES(...) __VA_ARGS__
static const BondsMistake mistakes[] = {
#define MISTAKE(name, words, written, ...)                                                                   \
    {.id = name, .sentence = words, .lines = LINES written, __VA_ARGS__},
#include "methods/bonds/plane/bonds_mistake_rows.inc"
#undef MISTAKE
};
enum { MISTAKES = sizeof mistakes / sizeof *mistakes };

const char *const beam_mistake_words[] = {
    "none",
#define MISTAKE(name, ...) name,
#include "methods/bonds/plane/bonds_mistake_rows.inc"
#undef MISTAKE
    NULL,
};

static const BondsMistake *row_of(int mistake)
{
    return mistake > 0 && mistake <= MISTAKES ? &mistakes[mistake - 1] : NULL;
}

const BondsMistake *bonds_mistake(const Beam *beam)
{
    return row_of(beam->head->mistake);
}

static unsigned does_of(int mistake, int beside)
{
    const BondsMistake *const one = row_of(mistake), *const other = row_of(beside);
    return (one ? one->does : 0) | (other ? other->does : 0);
}

bool bonds_does(const Beam *beam, unsigned wrong)
{
    return does_of(beam->head->mistake, beam->def.mistake_beside) & wrong;
}

bool bonds_does_by(const BeamDef *def, unsigned wrong)
{
    return does_of(def->mistake, def->mistake_beside) & wrong;
}

double bonds_micromodulus(const BeamDef *def, double right)
{
    const BondsMistake *const one = row_of(def->mistake), *const other = row_of(def->mistake_beside);
    return one && one->micromodulus       ? one->micromodulus(def)
           : other && other->micromodulus ? other->micromodulus(def)
                                          : right;
}

bool beam_mistake_is_of_start(int mistake)
{
    return does_of(mistake, 0) & BONDS_WRONG_OF_START;
}

const char *beam_mistake_sentence(int mistake)
{
    const BondsMistake *row = row_of(mistake);
    return row ? row->sentence : NULL;
}

bool bonds_check_mistake(const BeamDef *def, Status *status)
{
    const BondsMistake *const row = row_of(def->mistake), *const beside = row_of(def->mistake_beside);
    const unsigned does = does_of(def->mistake, def->mistake_beside);
    if (def->mistake_beside != 0 &&
        (!row || !beside || row == beside || (row->micromodulus && beside->micromodulus)))
        return status_refuse(status, "pd.mistake: these two cannot be combined");
    if (def->mistake == 0)
        return true;
    if (!row)
        return status_refuse(status, "pd.mistake: %d is not a choice (0 to %d)", def->mistake, MISTAKES);
    const struct {
        unsigned does; /* that of which it is asked; 0: of all */
        bool fits;
        const char *other;
    } conditions[] = {
        {BONDS_WRONG_IN_PLANE, def->problem != BEAM_BAR, "beams and plates"},
        {0, def->influence == INFLUENCE_CONSTANT, "pd.influence = constant"},
        {0, def->critical_stretch == 0, "pd.critical_stretch = 0"},
        {0, def->damping == 0 && !def->critically_damped, "damping.rate = 0"},
        {BONDS_WRONG_WITHIN_HORIZON | BONDS_WRONG_NO_VOLUME_FACTOR, def->volume_correction != VOLUME_HHB,
         "pd.volume_correction = partial or none"},
        {BONDS_WRONG_NO_FIRST_FORCE, def->stepping != STEPPING_EULER_POSITION,
         "pd.stepping = verlet, euler or leapfrog"},
        {BONDS_WRONG_HALF_HORIZON, def->horizon >= 2 * def->spacing * (1 - 1e-9),
         "pd.horizon = 2 spacings or more"},
        {BONDS_WRONG_WITHIN_HORIZON, def->horizon >= def->spacing * (1 + 1e-6),
         "pd.horizon = more than 1 spacing"},
        {BONDS_WRONG_KICKS_LATE | BONDS_WRONG_KICKS_BEFORE, def->stepping == STEPPING_VERLET,
         "pd.stepping = verlet"},
        {BONDS_WRONG_HOLDS_EDGES | BONDS_WRONG_HOLDS_BOTH, def->problem == BEAM_SIMPLY_SUPPORTED,
         "simply supported beams"},
    };
    for (size_t k = 0; k < sizeof conditions / sizeof *conditions; k++)
        if ((conditions[k].does == 0 || (conditions[k].does & does)) && !conditions[k].fits)
            return status_refuse(status, "pd.mistake: %s is defined for %s only",
                                 def->conceals_mistake ? "?" : row->id, conditions[k].other);
    return true;
}

bool bonds_change_mistake(Beam *beam, double mistake, Status *status)
{
    BeamDef def = beam->def;
    def.critical_stretch = beam->head->critical_stretch;
    def.mistake = mistake >= 0 && mistake == floor(mistake) && mistake < INT_MAX ? (int)mistake : -1;
    if (!bonds_check_mistake(&def, status))
        return false;
    const int of_start = beam_mistake_is_of_start(def.mistake) ? def.mistake : beam->head->mistake;
    if (def.mistake != beam->head->mistake && beam_mistake_is_of_start(of_start))
        return status_refuse(status, "pd.mistake: %s is made at the start and holds for the whole run",
                             def.conceals_mistake ? "?" : beam_mistake_words[of_start]);
    beam->head->mistake = def.mistake;
    return true;
}

double bonds_kick_share(const Beam *beam, bool second, long step)
{
    static const double shares[][2] = {[STEPPING_VERLET] = {0.5, 0.5},
                                       [STEPPING_EULER] = {1, 0},
                                       [STEPPING_EULER_POSITION] = {0, 1},
                                       [STEPPING_LEAPFROG] = {1, 0},
                                       [STEPPING_LEAPFROG_AHEAD] = {0, 1}};
    const unsigned missing = BONDS_WRONG_KICKS_LATE | (second      ? BONDS_WRONG_KICKS_BEFORE
                                                       : step == 0 ? BONDS_WRONG_NO_FIRST_FORCE
                                                                   : 0);
    const Stepping stepping = beam->def.stepping;
    if (bonds_does(beam, missing))
        return 0;
    const bool leaps = stepping >= STEPPING_LEAPFROG;
    return leaps && !second && step == 0 ? 0.5 : shares[stepping][second];
}

/* --- bonds ------------------------------------------------------------------------------------------ */

/* The partner that comes first (way -1) or last (1) in the list of node (i, j), by rows; offsets are in that
 * order. */
static void partner_at_end(const Lattice *lattice, int i, int j, int way, int *p, int *q)
{
    for (int turn = 0; turn < 2; turn++, way = -way) /* then those on the other side, the nearest first */
        for (int k = 0; k < lattice->n_offsets; k++) {
            const Offset *offset = &lattice->offsets[turn == 0 ? lattice->n_offsets - 1 - k : k];
            *p = way * offset->p;
            *q = way * offset->q;
            if (lattice_has(lattice, i + *p, j + *q))
                return;
        }
}

/* Of the end of a bond at (i, j) whose partner is (p, q) away. */
static void find_in_list(const Lattice *lattice, int i, int j, int p, int q, BondEnd *end)
{
    int x, y;
    partner_at_end(lattice, i, j, -1, &x, &y);
    end->to_first = x == p && y == q;
    partner_at_end(lattice, i, j, 1, &x, &y);
    end->to_last = x == p && y == q;
}

/* Of the pull of a bond what an end gets: 1 by the right code. */
static double share_of(const Beam *beam, const BondEnd *end)
{
    const BondsMistake *const rows[] = {row_of(beam->head->mistake), row_of(beam->def.mistake_beside)};
    double product = 1;
    for (size_t k = 0; k < 2; k++)
        product *= rows[k] && rows[k]->share ? rows[k]->share(end) : 1;
    return product;
}

BondNow beam_bond(const Beam *beam, BondPlace place)
{
    ASSERT(lattice_has(&beam->lattice, place.i, place.j));
    ASSERT_INDEX(place.offset, beam->lattice.n_offsets);
    const Lattice *lattice = &beam->lattice;
    const Offset *offset = &lattice->offsets[place.offset];
    const double ex = lattice_apart(lattice, place, beam->nodes.ux),
                 ey = lattice_apart(lattice, place, beam->nodes.uy);
    const double x = offset->x + ex, y = offset->y + ey, length = sqrt(x * x + y * y);
    const bool left = offset->p > 0 || (offset->p == 0 && offset->q > 0);
    BondEnd own = {.left = left, .owner = true, .rest = offset->length, .now = length};
    BondEnd other = {.left = !left, .rest = offset->length, .now = length};
    if (bonds_does(beam, BONDS_WRONG_BY_LIST)) {
        find_in_list(lattice, place.i, place.j, offset->p, offset->q, &own);
        find_in_list(lattice, place.i + offset->p, place.j + offset->q, -offset->p, -offset->q, &other);
    }
    BondNow bond = {.stretch = offset_stretch(offset, ex, ey),
                    .stiffness = beam->coefficient[lattice_slot(lattice, place)],
                    .share = {share_of(beam, &own), share_of(beam, &other)},
                    .direction = {x / length, y / length}};
    if (bonds_does(beam, BONDS_WRONG_ALONG_REST)) {
        bond.direction[0] = offset->x / offset->length;
        bond.direction[1] = offset->y / offset->length;
    }
    bond.energy = bond.stiffness * bond.stretch * bond.stretch * offset->length * beam->system.energy_scale;
    return bond;
}

void bonds_forces_of_row(Beam *beam, int j, double *const *fx, double *const *fy, BondLog *log,
                         double *energy)
{
    const Lattice *lattice = &beam->lattice;
    double sum = 0;
    for (int o = 0; o < lattice->n_offsets; o++) {
        const Offset *offset = &lattice->offsets[o];
        for (int i = 0; i < lattice->nx; i++) {
            if (!lattice_has(lattice, i + offset->p, j + offset->q))
                continue;
            const size_t slot = lattice_slot(lattice, (BondPlace){i, j, o});
            if (beam->coefficient[slot] == 0)
                continue;
            const BondNow bond = beam_bond(beam, (BondPlace){i, j, o});
            const double pull = bond.stiffness * bond.stretch, *n = bond.direction;
            const double own = pull * bond.share[0], other = pull * bond.share[1];
            fx[0][i] += own * n[0];
            fy[0][i] += own * n[1];
            fx[offset->q][i + offset->p] -= other * n[0];
            fy[offset->q][i + offset->p] -= other * n[1];
            sum += pull * bond.stretch * offset->length;
            if (!isfinite(own + n[0] + n[1]) && !log->unstable) {
                log->unstable = true;
                log->unstable_slot = slot;
            }
        }
    }
    if (energy)
        *energy = sum * beam->system.energy_scale;
}

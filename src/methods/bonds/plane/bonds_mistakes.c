/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mistakes of a beam's code, and what they do (bonds_mistakes.h). */
#include "methods/bonds/plane/bonds_mistakes.h"

#include "base/assertion.h"
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

bool bonds_mistakes_join(int one, int other, BondsMistake *out)
{
    const BondsMistake *a = row_of(one), *b = row_of(other);
    if (!a || !b || a == b || (a->micromodulus && b->micromodulus))
        return false;
    *out = *a;
    out->does = a->does | b->does;
    out->micromodulus = a->micromodulus ? a->micromodulus : b->micromodulus;
    out->share_beside = b->share;
    return true;
}

const BondsMistake *bonds_mistake_of(int mistake, int beside, BondsMistake *room)
{
    return beside && bonds_mistakes_join(mistake, beside, room) ? room : row_of(mistake);
}

const BondsMistake *bonds_mistake(const Beam *beam)
{
    return beam->both ? beam->both : row_of(beam->head->mistake);
}

static bool mistake_does(const BondsMistake *mistake, unsigned wrong)
{
    return mistake && (mistake->does & wrong) != 0;
}

bool bonds_does(const Beam *beam, unsigned wrong)
{
    return mistake_does(bonds_mistake(beam), wrong);
}

bool bonds_does_by(const BeamDef *def, unsigned wrong)
{
    BondsMistake room;
    return mistake_does(bonds_mistake_of(def->mistake, def->mistake_beside, &room), wrong);
}

bool beam_mistake_is_of_start(int mistake)
{
    return mistake_does(row_of(mistake), BONDS_WRONG_OF_START);
}

const char *beam_mistake_sentence(int mistake)
{
    const BondsMistake *row = row_of(mistake);
    return row ? row->sentence : NULL;
}

bool bonds_check_mistake(const BeamDef *def, Status *status)
{
    BondsMistake both;
    if (def->mistake_beside != 0 && !bonds_mistakes_join(def->mistake, def->mistake_beside, &both))
        return status_refuse(status, "pd.mistake: these two cannot be combined");
    if (def->mistake == 0)
        return true;
    const BondsMistake *row = bonds_mistake_of(def->mistake, def->mistake_beside, &both);
    if (!row)
        return status_refuse(status, "pd.mistake: %d is not a choice (0 to %d)", def->mistake, MISTAKES);
    const bool hhb = def->volume_correction == VOLUME_HHB &&
                     mistake_does(row, BONDS_WRONG_WITHIN_HORIZON | BONDS_WRONG_NO_VOLUME_FACTOR);
    const bool stepped = def->stepping != STEPPING_VERLET &&
                         mistake_does(row, BONDS_WRONG_KICKS_LATE | BONDS_WRONG_KICKS_BEFORE);
    const bool first =
        def->stepping == STEPPING_EULER_POSITION && mistake_does(row, BONDS_WRONG_NO_FIRST_FORCE);
    const bool near =
        def->horizon < 2 * def->spacing * (1 - 1e-9) && mistake_does(row, BONDS_WRONG_HALF_HORIZON);
    const bool alone =
        def->horizon < def->spacing * (1 + 1e-6) && mistake_does(row, BONDS_WRONG_WITHIN_HORIZON);
    const bool held = def->problem != BEAM_SIMPLY_SUPPORTED &&
                      mistake_does(row, BONDS_WRONG_HOLDS_EDGES | BONDS_WRONG_HOLDS_BOTH);
    const char *other = def->influence != INFLUENCE_CONSTANT          ? "pd.influence = constant"
                        : def->critical_stretch != 0                  ? "pd.critical_stretch = 0"
                        : def->damping != 0 || def->critically_damped ? "damping.rate = 0"
                        : hhb     ? "pd.volume_correction = partial or none"
                        : first   ? "pd.stepping = verlet, euler or leapfrog"
                        : near    ? "pd.horizon = 2 spacings or more"
                        : alone   ? "pd.horizon = more than 1 spacing"
                        : stepped ? "pd.stepping = verlet"
                        : held    ? "simply supported beams"
                                  : NULL;
    if (def->problem == BEAM_BAR && mistake_does(row, BONDS_WRONG_IN_PLANE))
        return status_refuse(status, "pd.mistake: %s is defined for beams and plates only",
                             def->conceals_mistake ? "?" : row->id);
    return !other || status_refuse(status, "pd.mistake: %s is defined for %s only",
                                   def->conceals_mistake ? "?" : row->id, other);
}

bool bonds_mistake_may_change(int from, int to, bool conceals, Status *status)
{
    const int of_start = beam_mistake_is_of_start(to) ? to : from;
    return from == to || !beam_mistake_is_of_start(of_start) ||
           status_refuse(status, "pd.mistake: %s is made at the start and holds for the whole run",
                         conceals ? "?" : beam_mistake_words[of_start]);
}

double bonds_kick_share(Stepping stepping, const BondsMistake *mistake, bool second, long step)
{
    static const double shares[][2] = {[STEPPING_VERLET] = {0.5, 0.5},
                                       [STEPPING_EULER] = {1, 0},
                                       [STEPPING_EULER_POSITION] = {0, 1},
                                       [STEPPING_LEAPFROG] = {1, 0},
                                       [STEPPING_LEAPFROG_AHEAD] = {0, 1}};
    const unsigned missing = BONDS_WRONG_KICKS_LATE | (second      ? BONDS_WRONG_KICKS_BEFORE
                                                       : step == 0 ? BONDS_WRONG_NO_FIRST_FORCE
                                                                   : 0);
    if (mistake_does(mistake, missing))
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
static double mistake_share(const BondsMistake *mistake, const BondEnd *end)
{
    double (*const shares[])(const BondEnd *) = {mistake ? mistake->share : NULL,
                                                 mistake ? mistake->share_beside : NULL};
    double product = 1;
    for (size_t i = 0; i < 2; i++)
        product *= shares[i] ? shares[i](end) : 1;
    return product;
}

BondNow beam_bond(const Beam *beam, BondPlace place)
{
    ASSERT(lattice_has(&beam->lattice, place.i, place.j));
    ASSERT_INDEX(place.offset, beam->lattice.n_offsets);
    const Lattice *lattice = &beam->lattice;
    const Offset *offset = &lattice->offsets[place.offset];
    const BondsMistake *mistake = bonds_mistake(beam);
    const double ex = lattice_apart(lattice, place, beam->nodes.ux),
                 ey = lattice_apart(lattice, place, beam->nodes.uy);
    const double x = offset->x + ex, y = offset->y + ey, length = sqrt(x * x + y * y);
    const bool left = offset->p > 0 || (offset->p == 0 && offset->q > 0);
    BondEnd own = {.left = left, .owner = true, .rest = offset->length, .now = length};
    BondEnd other = {.left = !left, .rest = offset->length, .now = length};
    if (mistake_does(mistake, BONDS_WRONG_BY_LIST)) {
        find_in_list(lattice, place.i, place.j, offset->p, offset->q, &own);
        find_in_list(lattice, place.i + offset->p, place.j + offset->q, -offset->p, -offset->q, &other);
    }
    BondNow bond = {.stretch = offset_stretch(offset, ex, ey),
                    .stiffness = beam->coefficient[lattice_slot(lattice, place)],
                    .share = {mistake_share(mistake, &own), mistake_share(mistake, &other)},
                    .direction = {x / length, y / length}};
    if (mistake_does(mistake, BONDS_WRONG_ALONG_REST)) {
        bond.direction[0] = offset->x / offset->length;
        bond.direction[1] = offset->y / offset->length;
    }
    bond.energy = bond.stiffness * bond.stretch * bond.stretch * offset->length * beam->system.energy_scale;
    return bond;
}

void bonds_forces_of_row(Beam *beam, int j, double *const *fx, double *const *fy, BondLog *log,
                         double *energy)
{
    ASSERT_INDEX(j, beam->lattice.ny);
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

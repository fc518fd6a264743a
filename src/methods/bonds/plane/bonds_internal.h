/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files of this folder share: the model and the state of a beam. Not for front ends. */
#ifndef METHODS_BONDS_PLANE_BONDS_INTERNAL_H
#define METHODS_BONDS_PLANE_BONDS_INTERNAL_H

#include "methods/bonds/plane/bonds_plane.h"
#include "methods/bonds/plane/lattice/bonds.h"
#include "methods/bonds/plane/lattice/lattice.h"
#include "methods/bonds/plane/plate/patches.h"
#include "methods/pool.h"

/* The stages of a step (velocity Verlet, eqs. 9 to 11). */
enum {
    STAGE_HALF_KICK,
    STAGE_DRIFT,
    STAGE_CONSTRAINTS,
    STAGE_BONDS,
    STAGE_BODY_FORCE,
    STAGE_SECOND_KICK,
    STAGE_DAMAGE,
    N_STAGES
};

/* See bonds_fields.c. */
enum { SET_PARTICLE, SET_BOND, N_SETS };

/* The head of the state: single numbers that change. */
enum { CRACK_TIPS = 64 };
typedef struct StateHead {
    double work, dissipated, damped;      /* J */
    double load_stress, critical_stretch; /* live parameters; of a bar its traction */
    double body_force;                    /* likewise */
    double most_kinetic;                  /* the largest kinetic energy so far, where rest is looked for, J */
    double kinetic_left;                  /* the newest of these over it */
    long moved;                           /* the last step that was looked at and was not at rest */
    bool rested;                          /* the motion has come to rest */
    int mistake;                          /* 0: none; a live parameter */
    double crack_length;                  /* of the path, as long as it ever was, m */
    long broken;                          /* bonds that broke in the run; the notch's are not among them */
    long near_tip;                        /* of these with their middle within 2 delta of the notch's end */
    long first_break, twentieth_break;    /* steps at which near_tip reached 1 and 20; -1: not yet */
    long arrival;        /* step at which the crack reached the protected zone; -1: not yet */
    double tip_x, tip_y; /* the crack's tip at its farthest, m: it never goes back */
    double fastest;      /* its largest speed before it arrived, m/s */
    double tips_x[CRACK_TIPS],
        tips_y[CRACK_TIPS]; /* where it was, one in every Beam.tip_every steps, in a ring */
} StateHead;

typedef struct NodeArrays {
    double *ux, *uy, *vx, *vy;
    double *fx, *fy; /* force density, N/m^3 */
} NodeArrays;

typedef struct Beam {
    Simulation sim; /* first */
    BeamDef def;
    Lattice lattice;
    BondSystem system;
    const BondKernels *kernels;
    BeamFacts facts;
    Stage stages[N_STAGES];                        /* of this problem */
    Exchange exchanges[SIMULATION_DIMENSIONS_MAX]; /* likewise */
    ForceWords force_words;                        /* of the stage that adds what acts from outside */

    void *block; /* of most arrays of the model, the state and what follows from it */

    /* the model */
    double *coefficient;  /* of the intact or broken bonds now: it follows the state's bits */
    uint8_t *notched;     /* per slot one bit: cut by the notch */
    uint8_t *unbreakable; /* per node */
    uint8_t *rooted;      /* per segment of bonds; see BondSystem */
    PlateCut cuts[PLATE_ROWS_MAX];
    Support supports[PLATE_ROWS_MAX];
    Load loads[PLATE_ROWS_MAX]; /* of the notched beam the pressure alone, at 1 Pa: StateHead.load_stress is
                                   live */
    int n_cuts, n_supports, n_loads;
    int probe_i[2], probe_j[2];
    double damping;  /* alpha */
    double period;   /* the longest of the lattice, s, where damping or rest ask for it; else NAN */
    long rest_steps; /* so many steps rest has to last, after the last that something is ordered for */
    long last_order;
    bool free_body; /* neither supports nor loads; for tests */

    /* the state: one block that begins with its head; then six node arrays and the bits of broken bonds */
    void *state;
    size_t state_size;
    StateHead *head;
    NodeArrays nodes;
    size_t array; /* doubles in a node array */
    uint8_t *broken;

    /* per slot the step after which its bond was broken; it means something only where the state's bit is
     * set, so a restore need not touch it */
    int32_t *broken_at;

    /* follows from the state */
    double *damage;  /* per node, as of the last damage stage */
    uint32_t *dirty; /* nodes whose bonds broke since */
    size_t n_dirty;
    uint8_t *is_dirty;
    long tip_every; /* steps from one place of the tip in StateHead to the next */
    int n_tips;     /* how many of them its speed is taken over */
    double strain;  /* J; valid while strain_known */
    bool strain_known;
    double kinetic; /* likewise, of a step whose row is taken */
    bool kinetic_known;

    /* bands of rows: what a thread takes at once. Forces on rows above the band go to the band's own halo and
     * are added in the order of bands, so that the number of threads leaves no trace. */
    int n_bands;
    int *band_first; /* first row of each band; one more: ny */
    int *band_of_row;
    double *halo; /* per band: reach rows of fx, then of fy */
    double *row_energy;
    double *row_work;   /* per row the work done in the first half of a step and in the second, J */
    double *row_speeds; /* per row sum |v|^2 and sum vy at mid-step, for what damping and weight do in it */
    BondLog *band_logs; /* one per band */
    double *scratch;    /* one per worker */
    Pool *pool;         /* NULL: one thread */
    void *backup;       /* the state when a batch of steps began */
    bool with_energy;   /* of the sweep over bonds under way: it takes their energies too */
    bool asks;          /* likewise: it may be given up; see beam_ask_forces() */
    double built;       /* share of the building that is done meanwhile */
    _Atomic bool given_up; /* by BeamDef.cancel */
} Beam;

/* For tests: a kernel level by force, a body that nothing holds or loads, and any initial motion. */
typedef struct BeamOptions {
    bool force_level;
    CpuLevel level;
    bool free_body;
    void (*initial)(double x, double y, double u[2], double v[2], const void *context);
    const void *context;
} BeamOptions;

Simulation *beam_create_with(const BeamDef *definition, const BeamOptions *options, Status *status);

/* bonds_line.c: what a bar has alone. */
void bonds_line_complete(
    BeamDef *); /* what does not count, and a spacing of which the length is a multiple */
void bonds_line_set_loads(Beam *);
void bonds_line_mirror(Beam *); /* u of mirrored nodes, u(-X) = -u(X) */
double bonds_line_energy_of_images(
    const Beam *); /* half of that of the bonds to them: the other half is theirs, J */
double bonds_line_strain(const Beam *, int i); /* at the node in column i */
double bonds_line_stress(const Beam *, int i);

/* bonds_critical.c: 2 / omega_max of the body as if nothing held it; the displacements and forces are zero
 * afterwards. */
bool beam_critical_step(Beam *beam, double *step, Status *status);

/* The section of its sizes in a scenario file, and what it is called. */
static inline const char *beam_word(const BeamDef *def)
{
    return def->problem == BEAM_PLATE ? "plate" : def->problem == BEAM_BAR ? "bar" : "beam";
}

/* bonds_problem.c */
bool beam_set_bonds(Beam *beam, Status *); /* coefficients, and the notch */
bool beam_set_problem(Beam *beam, Status *status);
void beam_simple_supports(const Lattice *, Support supports[2]); /* one node at each end, at mid-height */
int beam_held_columns(const Beam *beam, double time);            /* columns inside the channel */
bool beam_set_motion(Beam *beam, const BeamOptions *options, Status *status); /* false: interrupted */

/* bonds_bands.c */
/* Asks BeamDef.cancel. False: the building is to be given up, from now on. */
bool beam_go_on(Beam *beam, double share, Status *status);
void beam_run(Beam *beam, PoolWork *work, int chunks); /* context: the beam */
void beam_bonds_of_row(Beam *beam, int j, BondLog *log, bool with_energy);
void beam_add_halos(Beam *beam, int j);              /* what the bands below have for row j */
void beam_bond_forces(Beam *beam, bool with_energy); /* all bands; halos are still to be added */
/* With halos. While the beam is being built, asking on the way; false: to be given up. */
bool beam_ask_forces(Beam *beam, double share, Status *status);
double beam_strain(Beam *beam);
void beam_keep_strain(Beam *beam); /* the sum of what a sweep over all rows has left, until u changes */

/* bonds_damping.c */
bool beam_check_damping(double damping, double dt, Status *); /* false: more than the step can follow */
bool beam_set_damping(Beam *beam, Status *status);
void beam_brake(Beam *beam, int j, bool second); /* row j before the first half kick, or after the second */
void beam_note_speeds(Beam *beam, int j);        /* of row j at the drift ... */
void beam_add_speeds(Beam *beam);                /* ... and what comes of them, of rows in turn */
double beam_weight(const Beam *);                /* of a node upwards, N/m^3 */
double beam_load_on(const Simulation *, size_t node, int axis); /* Method.load_on, N/m^3 */
void beam_weigh(Beam *beam, int j); /* adds the weight of row j to its forces, and a definition's own */
/* In a state at the end of the step of this number. */
void beam_look_for_rest(Beam *beam, long step);

/* bonds_step.c */
bool beam_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status);
bool beam_steps(Simulation *sim, long count, double *rows, long *done, Status *status);

/* plate/beam_loads.c: what loads and moving supports do to row j. */
void beam_load_force(const Beam *beam, const Load *, double time, double force[2]); /* on a node, N/m^3 */
ForceTerms beam_terms(const Beam *beam);                                            /* those at work */
double beam_own_power(const Beam *beam, int j);      /* of the definition's own terms, W/m^3 */
void beam_add_loads(Beam *beam, int j, double time); /* to its forces */
void beam_note_work(Beam *beam, int j, long step);   /* in the drift, and ... */
void beam_reaction(const Beam *, double force[2]);   /* of all that holds the body, on it, N */
void beam_note_reaction(Beam *beam, int j);          /* ... in the second kick; */
void beam_add_work(Beam *beam, int half);            /* and once all rows are there, half 0 or 1 */

/* bonds_break.c */
double beam_energy_at(const Beam *beam, BondPlace, double squared); /* of a whole bond whose s^2 is this, J */
bool beam_take_log(Beam *beam, BondLog *log, long step);            /* false: memory was short */
/* Sum of w over a node's family, and over its bonds that broke in steps up to this one. */
double beam_family_weight(const Beam *beam, size_t node, long step, double *broken);
void beam_update_damage(Beam *beam, long step);
void beam_rebuild_damage(Beam *beam);
void beam_report(Beam *beam, EventKind, long step, const char *text); /* at the end of that step */

/* Whether a place is inside, more than a spacing from the edges: a crack runs on from a cut that ends there.
 */
bool beam_holds(const Beam *beam, double x, double y);

/* Bonds can break from now on. */
void beam_set_breaking(Beam *beam);

/* crack.c: called after every change of damage; keeps the crack's length at its longest */
void crack_follow(Beam *beam);

/* Before the first step: over which times the tip's speed is taken. */
void crack_begin(Beam *beam);

/* At the end of every step: where the tip is. */
void crack_note_tip(Beam *beam, long step);

/* The tip's speed (crack.h) over the time up to the last whole step, m/s; 0: too few steps yet. */
double crack_speed_now(const Beam *beam);

/* bonds_state.c */
size_t beam_state_size(const Simulation *sim);
void beam_load(Simulation *sim, const void *bytes);
size_t beam_small(Simulation *, double *x, double unit, bool put);
bool beam_change(Simulation *sim, const char *key, double value, Status *status);

/* bonds_series.c */
void beam_set_series(Beam *beam);
void beam_row(Simulation *sim, double *row);
double beam_kinetic(Beam *beam);

/* bonds_fields.c */
void beam_set_fields(Beam *beam);
void beam_field(const Simulation *sim, int field, size_t first, size_t count, double *out);

/* bonds_mistakes.c: one bond as it stands, by eqs. 2 and 3, or as a wrong code takes it. */
typedef struct BondNow {
    double stretch;
    double
        stiffness;   /* c G w V of the right code, N/m^3; 0 when broken: its pull is this times the stretch */
    double share[2]; /* of the pull that its owner and its other end get: 1 by the right code */
    double direction[2]; /* from the owner to the other end as they are now, of length 1 */
    double energy;       /* J */
} BondNow;
BondNow beam_bond(const Beam *beam, BondPlace place);

/* The bonds of a node, by the row of the other end and then by its column; returns how many there are. */
size_t beam_family(const Beam *beam, int i, int j, BondPlace *out);
size_t beam_family_of(const Beam *beam, size_t node, BondPlace *out);
enum { FAMILY_MAX = 2 * LATTICE_OFFSETS_MAX };
size_t beam_links(const Simulation *sim, int set, size_t index, Link *out, size_t max);
int beam_exchange(const Simulation *, int exchange, size_t index, const Link *,
                  double factors[EXCHANGE_FACTORS_MAX]);

/* bonds_explain.c */
void beam_set_stages(Beam *);
void beam_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, int terms,
                  char *out, size_t size);

/* A piece of a block that begins at a cache line (NULL: of none yet), for so many bytes; *used grows by it.
 */
static inline void *beam_piece(void *block, size_t *used, size_t bytes)
{
    void *piece = block ? (char *)block + *used : NULL;
    *used += (bytes + 63) / 64 * 64;
    return piece;
}

/* The bit of a slot: of broken bonds, or of those that the notch cut. */
static inline bool beam_bit(const uint8_t *bits, size_t slot)
{
    return bits[slot / 8] >> slot % 8 & 1;
}

/* The first slot from this one on whose bit is set; `slots`, of which there are whole bytes: none. */
static inline size_t beam_next_bit(const uint8_t *bits, size_t slot, size_t slots)
{
    while (slot < slots && !beam_bit(bits, slot))
        slot += bits[slot / 8] >> slot % 8 ? 1 : 8 - slot % 8;
    return slot;
}

static inline double beam_volume(const Beam *beam)
{
    return beam->lattice.spacing * beam->lattice.depth;
}

#endif

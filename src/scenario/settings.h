/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Everything that a scenario holds: plain values, filled by the parameter table (parameters.h) and by the
 * scenario reader (scenario.h), read by everyone. A copy by assignment is a whole copy. */
#ifndef LAB_SETTINGS_H
#define LAB_SETTINGS_H

#include "base/patience.h"
#include "base/status.h"
#include "base/kinds.h"
#include "scenario/assignment.h"
#include "scenario/rows/rows.h"

/* How a scenario opens; the engine ignores it. Empty: as the laboratory likes. */
typedef struct ViewSettings {
    char upper[VALUE_MAX], lower[VALUE_MAX], window[VALUE_MAX], pace[VALUE_MAX];
    char colour[VALUE_MAX], exaggeration[VALUE_MAX], references[VALUE_MAX];
    char sheet[VALUE_MAX]; /* how much of the screen there is: one of parameter_sheet_words */
    char about[VALUE_MAX]; /* the number that it is about: a word of run_numbers (lessons/run_numbers.h) */
    char ask[LIST_MAX];    /* keys of the parameters that it asks about: settings_asked() */
} ViewSettings;

/* --- what a run is made of: one struct for each concern, which any method may read --------------------- */

typedef struct Geometry {
    double length;            /* L > 0; of a moving beam the part outside the channel at t = 0 */
    double height, thickness; /* of what has more than a length */
} Geometry;

typedef struct Material {
    double youngs_modulus, density; /* E, rho > 0 */
    double poisson;                 /* of a beam in cells; with bonds it is 1/3 */
} Material;

/* From a place on a bar is of another material. */
typedef struct Joint {
    double place; /* 0: it is of one */
    Material beyond;
} Joint;

/* What a mode starts with on a bar of two materials: the sine of a bar of one, or the mode as it is. */
typedef enum StartShape { SHAPE_SINE, SHAPE_EXACT } StartShape;

/* What moves at t = 0, and how. */
typedef struct Start {
    int mode; /* of a bar */
    double velocity;
    char overtones[LIST_MAX]; /* "3:0.03,7:0.01" */
    char pulse[LIST_MAX];     /* "50,3,1e-4": centre, width, velocity; "": none */
    StartShape shape;         /* of a mode of a bar of two materials */
    double amplitude;         /* deflection U of a beam's mode */
    PlaneStart start;         /* of a beam in cells: what of the mode there is at t = 0 */
    PlaneStress stress;       /* that its deflection comes with */
} Start;

/* The cells of the material point method; the bar's lattice left to itself has a node for each particle. */
typedef struct Mesh {
    double cell_size;
    int particles_per_cell;
    int padding;     /* empty cells beyond each free end */
    double velocity; /* of the whole mesh, along a beam that leaves its channel */
} Mesh;

/* With what slope of velocity APIC's particles start: that of the velocity, or none. */
typedef enum AffineStart { AFFINE_GRADIENT, AFFINE_ZERO } AffineStart;

/* How the material point method transfers momentum to its mesh and back. */
typedef struct Transfer {
    MpmAlgorithm algorithm;
    MpmShape shape;
    MpmTransfer transfer;
    double flip_fraction;
    double mass_blend; /* 0: the best one */
    int fmpm_order;
    AffineStart affine_start;
    int mistake;        /* of a code that is wrong in one place; 0: none */
    int mistake_beside; /* and in another one: of a code that is sought, no scenario has it */
} Transfer;

/* The nodes of peridynamics and the reach of their bonds. */
typedef struct Lattice {
    double spacing, horizon; /* 0 on the bar: see lattice_spacing(), lattice_horizon() */
    SurfaceCorrection surface_correction;
    VolumeCorrection volume_correction;
    Influence influence;
    int mistake, mistake_beside; /* as of Transfer */
} Lattice;

/* When a bond breaks. */
typedef struct Bonds {
    double critical_stretch; /* s0; 0: never */
    double critical_energy;  /* G0, J/m^2: equivalent to s0, kept in step with it */
    bool energy_given; /* G0 is the given value and the stretch follows from it; else the other way round */
    double protected_depth; /* bonds nearer than this to load or supports never break */
} Bonds;

/* A beam that leaves its channel. */
typedef struct Motion {
    double speed, channel; /* channel: length of beam inside at t = 0 */
    Clamp clamp;
} Motion;

typedef struct Cut {
    double position, depth; /* from below, at a distance from the left end */
} Cut;

typedef struct Loads {
    double body_force;                    /* per unit mass */
    double traction, traction_layer;      /* at each free end of a bar; 0: the last particle */
    double stress, ramp, position, width; /* pressure on the top of a beam */
} Loads;

typedef struct Supports {
    BarSupports ends;   /* of a bar */
    PlaneEnds sections; /* of a beam in cells */
    double left, right; /* places under a beam */
    bool pinned;        /* the left one holds the beam lengthwise too */
} Supports;

/* Damping by the velocity of things itself. */
typedef struct Damping {
    double rate; /* alpha; DAMPING_CRITICAL: twice the lowest frequency */
} Damping;
#define DAMPING_CRITICAL (-1)

typedef struct TimeSettings {
    double courant; /* of a mesh: the step as a share of the time in which a wave crosses a cell */
    bool unstable;  /* a larger step than the mesh stands is run all the same */
    double step;    /* 0: half the critical one */
    double end;
    bool rest; /* the run ends earlier where it comes to rest */
} TimeSettings;

/* What a run writes; it does not make it another run. */
typedef struct Output {
    int every;              /* steps from row to row */
    int frames;             /* 0: the last step alone */
    char at[LIST_MAX];      /* "0,1e-4,2e-4"; "": none */
    char follow[LIST_MAX];  /* "particle 12 v, node 7 momentum": columns of the series; "": none */
    char columns[LIST_MAX]; /* "all", or those of the series that are written; "": all that cost no more than
                             * the step does */
} Output;

struct Settings {
    char title[TITLE_MAX]; /* one line, UTF-8 */
    char about[ABOUT_MAX];
    const Problem *problem;
    MethodKind method;

    Geometry geometry;
    Material material;
    Joint joint;
    Start start;
    Mesh mesh;
    Transfer mpm;
    Lattice lattice;
    Bonds bonds;
    Motion motion;
    Cut notch;
    Loads loads;
    Supports supports;
    RowList rows[ROW_KINDS]; /* of a plate: by RowKinds */
    Damping damping;
    TimeSettings time;
    Output output;

    bool concealed; /* its mistake is made, but not told: "?" */

    Patience patience; /* asked while the simulation and its references are being made */

    char question[KEY_MAX]; /* what `t` toggles */
    Assignment duel[DUEL_MAX];
    int n_duel;
    Change changes[CHANGES_MAX]; /* ascending in step */
    int n_changes;
    ViewSettings view;
};

/* The words of a scenario file for MethodKind, ended by NULL. */
extern const char *const settings_method_words[];

/* Spacing and horizon of the lattice, with what stands for "auto" on the bar: one node where each particle
 * of the cells would be, and three spacings. */
double lattice_spacing(const Settings *);
double lattice_horizon(const Settings *);

/* The members of a family lie no farther than this. */
double lattice_reach(const Settings *);

/* The lists inside texts. */
enum { OVERTONES_MAX = 15, TIMES_MAX = 64 };

typedef struct Overtone {
    int mode;
    double velocity;
} Overtone;

/* "3:0.03,7:0.01": how many there are, -1 if the text cannot be read (the status says why). */
int overtones_read(const char *text, Overtone out[OVERTONES_MAX], Status *);

typedef struct Pulse {
    double centre, width, velocity;
} Pulse;

/* "50,3,1e-4", centre, width > 0 and velocity; "" is a pulse of velocity 0. False: it cannot be read. */
bool pulse_read(const char *text, Pulse *out, Status *);

/* "0,1e-4,2e-4", ascending: how many there are, or -1. */
int settings_times_read(const char *text, double out[TIMES_MAX], Status *);

#endif

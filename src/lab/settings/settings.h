/* Everything that a scenario says: plain values, filled by the parameter table (parameters.h) and by the
 * scenario reader (scenario.h), read by everyone. A copy by assignment is a whole copy. */
#ifndef LAB_SETTINGS_H
#define LAB_SETTINGS_H

#include "physics/mpm_bar/bar.h"
#include "physics/pd_plane/beam.h"

typedef enum Problem {
    PROBLEM_BAR,
    PROBLEM_SUPPORTED_BEAM,
    PROBLEM_MOVING_CANTILEVER,
    PROBLEM_NOTCHED_BEAM,
    PROBLEM_COUNT
} Problem;

typedef enum MethodKind { METHOD_MPM, METHOD_PD } MethodKind;

enum {
    TITLE_MAX = 80, /* bytes, with the final zero; so the others */
    ABOUT_MAX = 1024,
    LIST_MAX = 256,  /* overtones, times of frames */
    KEY_MAX = 40,    /* "pd.surface_correction" */
    VALUE_MAX = 64,  /* the text of a value */
    DUEL_MAX = 8,    /* keys in which the second run of a duel differs */
    CHANGES_MAX = 64 /* changes of live parameters in mid-run */
};

typedef struct Assignment {
    char key[KEY_MAX];
    char value[VALUE_MAX];
} Assignment;

/* "from this step on, key = value" */
typedef struct Change {
    long step;
    Assignment to;
} Change;

/* How a scenario opens; the engine ignores it. Empty: as the laboratory likes. */
typedef struct ViewSettings {
    char upper[VALUE_MAX], lower[VALUE_MAX], window[VALUE_MAX], pace[VALUE_MAX];
    char colour[VALUE_MAX], exaggeration[VALUE_MAX], references[VALUE_MAX];
} ViewSettings;

typedef struct Settings {
    char title[TITLE_MAX]; /* one line, UTF-8 */
    char about[ABOUT_MAX];
    Problem problem;
    MethodKind method;

    BarDef bar; /* its initial_velocity is filled in when the simulation is built */
    int mode;
    double velocity;
    char overtones[LIST_MAX]; /* "3:0.03,7:0.01" */

    BeamDef beam;           /* its problem, end and threads likewise; its lattice is also the bar's by pd */
    double critical_energy; /* G0, J/m^2: the other handle on beam.critical_stretch, always its equal */
    bool energy_given;      /* G0 was said and the stretch follows from it; else the other way round */

    double end; /* time.end */

    int every;         /* output.every */
    int frames;        /* output.frames; 0: the last step alone */
    char at[LIST_MAX]; /* output.at: "0,1e-4,2e-4"; "": none */

    char question[KEY_MAX]; /* what `t` toggles */
    Assignment duel[DUEL_MAX];
    int n_duel;
    Change changes[CHANGES_MAX]; /* ascending in step */
    int n_changes;
    ViewSettings view;
} Settings;

#endif

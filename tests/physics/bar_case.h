/* Bars as tests want them: a definition with its starting velocity. */
#ifndef TESTS_BAR_CASE_H
#define TESTS_BAR_CASE_H

#include "physics/mpm/bar.h"

enum { BAR_CASE_MODES = 4 };

typedef struct BarCase {
    BarDef def;
    int n_modes;
    struct {
        int number;
        double velocity;
    } modes[BAR_CASE_MODES];
} BarCase;

/* Paper M's bar, mode n with amplitude v0 (n = 0: at rest unless the bar is free at both ends). */
BarCase bar_case(int mode, double v0);

void bar_case_add_mode(BarCase *which, int mode, double v0);

/* beta_n of this bar. */
double bar_case_wave_number(const BarCase *which, int mode);

/* The simulation; stops the test if it cannot be made. */
Simulation *bar_case_create(const BarCase *which);

/* n steps; stops the test if they fail. */
void advance(Simulation *sim, long steps);

/* A series value at the present state, by name. */
double series_now(Simulation *sim, const char *name);

/* A field of set 0 or 1 as an array of its whole length; the caller frees it. */
double *field_now(const Simulation *sim, int set, const char *name);

/* The particle state as bytes: a snapshot between steps. The caller frees it. */
unsigned char *snapshot_now(const Simulation *sim);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bars as tests want them: a definition with its starting velocity. */
#ifndef TESTS_BAR_CASE_H
#define TESTS_BAR_CASE_H

#include "answers/step_modes.h"
#include "methods/mpm/mpm.h"
#include "methods/run_case.h"

enum { BAR_CASE_MODES = 4 };

typedef struct BarCase {
    MpmDef def;
    int n_modes;
    struct {
        int number;
        double velocity;
    } modes[BAR_CASE_MODES];
    bool zero_slope; /* APIC's affine velocities start from 0, not from the velocity's slope */
} BarCase;

/* Paper M's bar, mode n with amplitude v0 (n = 0: at rest unless the bar is free at both ends). */
BarCase bar_case(int mode, double v0);

void bar_case_add_mode(BarCase *which, int mode, double v0);

/* beta_n of this bar. */
double bar_case_wave_number(const BarCase *which, int mode);

/* The simulation; stops the test if it cannot be made. */
Simulation *bar_case_create(const BarCase *which);

/* What its step predicts from its start; the largest stable Courant number. */
StepModes *bar_case_modes(const BarCase *which);
double bar_case_limit(const BarCase *which);

#endif

#include "lab/answers/dispersion.h"
#include "lab/answers/bar_problem.h"
#include "lab/settings/parameters.h"

#include <limits.h>
#include <math.h>

int dispersion_modes(const Settings *settings)
{
    if (settings->problem != PROBLEM_BAR)
        return 0;
    const bool lattice = settings->method == METHOD_PD;
    double modes =
        round(settings->geometry.length / (lattice ? lattice_spacing(settings) : settings->mesh.cell_size));
    return modes >= 1 && modes < INT_MAX ? (int)modes : 0;
}

/* The lumped mesh alone, sqrt(K)/theta; particle -> node -> particle, sqrt(F); the time step. */
static void mesh_factors(const Dispersion *wave, ModeOnMesh *mode)
{
    const double filter = sqrt(wave->filter);
    mode->factors[0] =
        (ModeFactor){"mesh K", "lumped masses on linear springs", wave->space_only / (filter * mode->exact)};
    mode->factors[1] = (ModeFactor){"filter F", "what particle to node to particle leaves", filter};
    mode->factors[2] = (ModeFactor){"dt", NULL, wave->frequency / wave->space_only};
    mode->n_factors = 3;
}

static void lattice_factors(const Dispersion *wave, ModeOnMesh *mode)
{
    mode->factors[0] =
        (ModeFactor){"lattice", "each node bonded to all within the horizon", wave->space_only / mode->exact};
    mode->factors[1] = (ModeFactor){"dt", NULL, wave->frequency / wave->space_only};
    mode->n_factors = 2;
}

bool dispersion_mode(const Settings *settings, int number, ModeOnMesh *out)
{
    BarTheory theory;
    if (number < 1 || number > dispersion_modes(settings) || !bar_theory_of(settings, &theory, NULL))
        return false;
    const double wave_number = bar_wave_number(&theory, number);
    const bool lattice = settings->method == METHOD_PD;
    Dispersion wave;
    if (lattice) {
        const RodLatticeTheory rod = rod_lattice_of(settings);
        wave = rod_dispersion(&theory, &rod, wave_number);
    } else {
        const BarMesh mesh = bar_mesh_of(settings, bar_time_step(settings));
        wave = bar_dispersion(&theory, &mesh, wave_number);
    }
    *out = (ModeOnMesh){.exact = bar_frequency(&theory, number), .predicted = NAN};
    if (!wave.known || !(wave.frequency > 0))
        return true;
    out->predicted = wave.frequency;
    (lattice ? lattice_factors : mesh_factors)(&wave, out);
    return true;
}

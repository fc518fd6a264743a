#include "lab/dispersion.h"
#include "lab/bar_problem.h"

#include <limits.h>
#include <math.h>

int dispersion_modes(const Settings *settings)
{
    if (settings->problem != PROBLEM_BAR || settings->method != METHOD_MPM)
        return 0;
    double cells = round(settings->bar.length / settings->bar.cell_size);
    return cells >= 1 && cells < INT_MAX ? (int)cells : 0;
}

bool dispersion_mode(const Settings *settings, int number, ModeOnMesh *out)
{
    BarTheory theory;
    if (number < 1 || number > dispersion_modes(settings) || !bar_theory_of(settings, &theory, NULL))
        return false;
    BarMesh mesh = bar_mesh_of(settings, bar_time_step(settings));
    Dispersion wave = bar_dispersion(&theory, &mesh, bar_wave_number(&theory, number));
    *out = (ModeOnMesh){.exact = bar_frequency(&theory, number),
                        .predicted = NAN,
                        .by_mesh = NAN,
                        .by_filter = NAN,
                        .by_time = NAN};
    if (!wave.known || !(wave.frequency > 0))
        return true;
    out->predicted = wave.frequency;
    out->by_filter = sqrt(wave.filter);
    out->by_mesh = wave.space_only / (out->by_filter * out->exact);
    out->by_time = wave.frequency / wave.space_only;
    return true;
}

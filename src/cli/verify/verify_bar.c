/* Paper M: the frequencies of modes 1, 5 and 10, figures 2 to 4, and what cells, particles and steps do. */
#include "cli/verify/verify_bar_run.h"
#include "cli/verify/verify_checks.h"

#include <math.h>
#include <stdlib.h>

/* The error of the frequency in percent over t in [0, 20]; NAN: the status says why. */
static double measured_error(const Settings *run, Status *status)
{
    const double end = 20;
    Simulation *sim;
    Trace trace;
    FrequencyFit fit = {.frequency = NAN};
    double start = bar_run_predicted(run);
    if (bar_run_trace(run, end, &sim, &trace, status))
        trace_frequency(&trace, "v_cm", 0, end, isnan(start) ? 0 : start, &fit, status);
    trace_free(&trace);
    simulation_destroy(sim);
    return 100 * (fit.frequency / bar_run_exact(run) - 1);
}

/* --- the error table ----------------------------------------------------------------------------- */

/* One run of the table: the mesh and mode, the paper's words, and the error (percent) that a reference solver
 * measured, to three decimals. */
typedef struct ErrorCase {
    const char *what;
    const char *paper;
    int mode;
    double cell_size, courant;
    int particles_per_cell;
    double reference;
    Bound claim; /* the paper's words as numbers */
} ErrorCase;

#define SAME                                                                                                 \
    {                                                                                                        \
        -0.15, 0.15                                                                                          \
    }
#define ABOUT_1                                                                                              \
    {                                                                                                        \
        -1.5, -0.5                                                                                           \
    }
#define ABOUT_5                                                                                              \
    {                                                                                                        \
        -6, -4                                                                                               \
    }
#define ABOUT_20                                                                                             \
    {                                                                                                        \
        -23, -16                                                                                             \
    }

static bool show_errors(Verify *verify, const ErrorCase *cases, int count, Status *status)
{
    verify_head(verify, "error of omega, %");
    for (int i = 0; i < count; i++) {
        const ErrorCase *one = &cases[i];
        Settings run = bar_run(one->mode);
        run.mesh.cell_size = one->cell_size, run.time.courant = one->courant;
        run.mesh.particles_per_cell = one->particles_per_cell;
        double error = measured_error(&run, status);
        if (isnan(error))
            return false;
        VerifyRow row = {.what = one->what,
                         .paper = one->paper,
                         .predicted = 100 * (bar_run_predicted(&run) / bar_run_exact(&run) - 1),
                         .measured = error,
                         .decimals = 3,
                         .n_bounds = 2,
                         .bounds = {within(one->reference, 0.001), one->claim}};
        verify_row(verify, &row);
    }
    return true;
}

#define SHOW_ERRORS(verify, cases, status)                                                                   \
    show_errors(verify, cases, (int)(sizeof(cases) / sizeof *(cases)), status)

bool verify_cell_size(Verify *verify, Status *status)
{
    static const ErrorCase cases[] = {
        {"n = 1, cell 1/2", "the same", 1, 0.5, 0.1, 2, -0.062, SAME},
        {"n = 5, cell 1/2", "about 1", 5, 0.5, 0.1, 2, -1.087, ABOUT_1},
        {"n = 10, cell 1/2", "5", 10, 0.5, 0.1, 2, -4.721, ABOUT_5},
    };
    if (!SHOW_ERRORS(verify, cases, status))
        return false;
    verify_note(verify, "n = 1: particles cross cells, which the prediction does not know.");
    return true;
}

bool verify_particles(Verify *verify, Status *status)
{
    static const ErrorCase cases[] = {
        {"n = 1, 1 particle", "", 1, 1, 0.1, 1, -0.065, SAME},
        {"n = 5, 1 particle", "", 5, 1, 0.1, 1, -5.235, ABOUT_5},
        {"n = 10, 1 particle", "", 10, 1, 0.1, 1, -22.100, ABOUT_20},
        {"n = 1, 4 particles", "no change", 1, 1, 0.1, 4, -0.050, SAME},
        {"n = 5, 4 particles", "no change", 5, 1, 0.1, 4, -3.991, {-6, -3.9}},
        {"n = 10, 4 particles", "no change", 10, 1, 0.1, 4, -16.662, ABOUT_20},
        {"n = 1, 6 particles", "no change", 1, 1, 0.1, 6, -0.007, SAME},
        {"n = 5, 6 particles", "no change", 5, 1, 0.1, 6, -3.946, {-6, -3.9}},
        {"n = 10, 6 particles", "no change", 10, 1, 0.1, 6, -16.468, ABOUT_20},
    };
    if (!SHOW_ERRORS(verify, cases, status))
        return false;
    verify_note(verify, "n = 1, 6 particles: they cross cells, which the prediction does not know.");
    return true;
}

bool verify_time_step(Verify *verify, Status *status)
{
    static const ErrorCase cases[] = {
        {"n = 1, step 1/2", "no change", 1, 1, 0.05, 2, -0.054, SAME},
        {"n = 5, step 1/2", "no change", 5, 1, 0.05, 2, -4.247, ABOUT_5},
        {"n = 10, step 1/2", "no change", 10, 1, 0.05, 2, -17.743, ABOUT_20},
    };
    return SHOW_ERRORS(verify, cases, status);
}

/* --- figures 2 to 4 ------------------------------------------------------------------------------ */

/* What is known of one figure: the reference's error of omega, its v_cm after 1000 steps with all digits, and
 * its amplitude over t in [90, 100] relative to the exact one. */
typedef struct Figure {
    int mode;
    const char *frequency_words, *period_words, *amplitude_words;
    double error;
    Bound error_claim, period_claim;
    double v_cm, amplitude;
} Figure;

/* Amplitude over t in [90, 100], relative to the exact one. */
static bool late_amplitude(const Settings *run, const Trace *trace, double frequency, double *out,
                           Status *status)
{
    FrequencyFit fit;
    BarTheory bar = bar_run_theory(run);
    if (!trace_frequency(trace, "v_cm", 90, 100, frequency, &fit, status))
        return false;
    *out = fit.amplitude / fabs(bar_centre_velocity(&bar, 0));
    return true;
}

/* The time at which the mesh is late by half a period. */
static double half_a_period_late(double exact, double frequency)
{
    return M_PI / (exact - frequency);
}

/* Measured over predicted frequency at a motion so small that nothing moves on the mesh, less 1, in 1e-9. */
static bool tiny_motion(int mode, double *out, Status *status)
{
    Settings run = bar_run(mode);
    run.start.velocity = 1e-6;
    double error = measured_error(&run, status);
    *out = 1e9 * ((1 + error / 100) * bar_run_exact(&run) / bar_run_predicted(&run) - 1);
    return !isnan(error);
}

static void show_figure(Verify *verify, const Figure *figure, const Settings *run, const FrequencyFit *fit,
                        double v_cm, double amplitude, double tiny)
{
    BarTheory bar = bar_run_theory(run);
    BarMesh mesh = bar_run_mesh(run);
    double exact = bar_run_exact(run), predicted = bar_run_predicted(run);
    double error = 100 * (fit->frequency / exact - 1);
    const VerifyRow rows[] = {
        {"omega", NULL, predicted, fit->frequency, 6, 0, {{0, 0}}},
        {"error of omega, %",
         figure->frequency_words,
         100 * (predicted / exact - 1),
         error,
         3,
         2,
         {within(figure->error, 0.001), figure->error_claim}},
        {"error of the period, %",
         figure->period_words,
         100 * (exact / predicted - 1),
         100 * (exact / fit->frequency - 1),
         3,
         1,
         {figure->period_claim}},
        {"half a period late at",
         NULL,
         half_a_period_late(exact, predicted),
         half_a_period_late(exact, fit->frequency),
         2,
         0,
         {{0, 0}}},
        {"amplitude in [0, 20]",
         figure->amplitude_words,
         NAN,
         fit->amplitude / fabs(bar_centre_velocity(&bar, 0)),
         3,
         0,
         {{0, 0}}},
        {"amplitude in [90, 100]", NULL, NAN, amplitude, 3, 1, {within(figure->amplitude, 0.0015)}},
        {"1000 v_cm at step 1000",
         NULL,
         1000 * bar_predicted_centre_velocity(&bar, &mesh, 1000),
         1000 * v_cm,
         6,
         1,
         {within(1000 * figure->v_cm, 1e-10)}},
        {"v0 1e-6: off by, 1e-9", NULL, 0, tiny, 1, 1, {{-10, 10}}},
    };
    verify_head(verify, NULL);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        verify_row(verify, &rows[i]);
}

static bool run_figure(Verify *verify, const Figure *figure, const Settings *run, const Trace *trace,
                       Status *status)
{
    FrequencyFit fit;
    double amplitude, tiny;
    double *v_cm = trace_column(trace, "v_cm");
    bool sound = v_cm || status_fail(status, STATUS_FAILED, "not enough memory");
    sound = sound && trace_frequency(trace, "v_cm", 0, 20, bar_run_predicted(run), &fit, status) &&
            late_amplitude(run, trace, fit.frequency, &amplitude, status) &&
            tiny_motion(figure->mode, &tiny, status);
    if (sound)
        show_figure(verify, figure, run, &fit, v_cm[1000], amplitude, tiny);
    free(v_cm);
    return sound;
}

static bool verify_figure(Verify *verify, const Figure *figure, Status *status)
{
    Settings run = bar_run(figure->mode);
    Simulation *sim;
    Trace trace;
    bool sound =
        bar_run_trace(&run, 100, &sim, &trace, status) && run_figure(verify, figure, &run, &trace, status);
    trace_free(&trace);
    simulation_destroy(sim);
    return sound;
}

bool verify_mode1(Verify *verify, Status *status)
{
    static const Figure figure = {1,    "the same",    "the same",          "the same", -0.053,
                                  SAME, {-0.15, 0.15}, 0.06366305385680329, 1};
    return verify_figure(verify, &figure, status);
}

bool verify_mode5(Verify *verify, Status *status)
{
    static const Figure figure = {
        5, "about 5", "about 5", "similar", -4.239, ABOUT_5, {4, 6}, -0.0049916966356108716, 0.935};
    return verify_figure(verify, &figure, status);
}

bool verify_mode10(Verify *verify, Status *status)
{
    static const Figure figure = {
        10, "about 20", "about 20", "similar", -17.723, ABOUT_20, {17, 23}, -0.0022030804348109096, 0.383};
    return verify_figure(verify, &figure, status);
}

/* The bar's energy: what the algorithms keep of it, what crossings and stability do to it, and loads. */
#include "cli/verify/verify_bar_run.h"
#include "cli/verify/verify_checks.h"
#include "lab/problems/bar_theory.h"

#include <math.h>
#include <stdlib.h>

static const char *const algorithm_names[] = {[MPM_USF] = "USF", [MPM_MUSL] = "MUSL", [MPM_USL] = "USL"};

/* Mean energy over t in [90, 100] relative to that over [0, 10]. */
static bool energy_left(const Settings *run, double *out, Status *status)
{
    Simulation *sim;
    Trace trace;
    bool sound = bar_run_trace(run, 100, &sim, &trace, status);
    if (sound) {
        double first = trace_mean(&trace, "kinetic", 0, 10) + trace_mean(&trace, "strain", 0, 10);
        double last = trace_mean(&trace, "kinetic", 90, 100) + trace_mean(&trace, "strain", 90, 100);
        *out = last / first;
    }
    trace_free(&trace);
    simulation_destroy(sim);
    return sound;
}

bool verify_energy_left(Verify *verify, Status *status)
{
    static const struct {
        MpmAlgorithm algorithm;
        int mode;
        double reference;
    } cases[] = {{MPM_USF, 1, 1.000},  {MPM_USF, 5, 1.000},  {MPM_USF, 10, 1.008},
                 {MPM_MUSL, 1, 1.000}, {MPM_MUSL, 5, 1.000}, {MPM_MUSL, 10, 0.992},
                 {MPM_USL, 1, 0.9998}, {MPM_USL, 5, 0.207},  {MPM_USL, 10, 0.012}};
    verify_head(verify, "energy left at t = 100");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Settings run = bar_run(cases[i].mode);
        run.mpm.algorithm = cases[i].algorithm;
        double left;
        if (!energy_left(&run, &left, status))
            return false;
        BarTheory bar = bar_run_theory(&run);
        BarMesh mesh = bar_run_mesh(&run);
        double decay = bar_dispersion(&bar, &mesh, bar_wave_number(&bar, run.start.mode)).decay;
        char what[40];
        snprintf(what, sizeof what, "%s, n = %d", algorithm_names[run.mpm.algorithm], run.start.mode);
        VerifyRow row = {.what = what,
                         .predicted = exp(-2 * decay * 90),
                         .measured = left,
                         .decimals = 4,
                         .n_bounds = 1,
                         .bounds = {within(cases[i].reference, 0.003)}};
        verify_row(verify, &row);
    }
    verify_note(verify, "Predicted is what the grid sees; energy hidden in particles stays beside it.");
    return true;
}

/* 1 - mean(kinetic_grid) / mean(kinetic), percent. */
static double hidden_share(const Trace *trace, double first, double last)
{
    return 100 *
           (1 - trace_mean(trace, "kinetic_grid", first, last) / trace_mean(trace, "kinetic", first, last));
}

bool verify_hidden_energy(Verify *verify, Status *status)
{
    static const struct {
        int mode;
        double early, late;
    } cases[] = {{1, 0.07, 0.08}, {5, 5.9, 24.8}, {10, 25.2, 94.2}};
    verify_head(verify, "hidden kinetic, %");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Settings run = bar_run(cases[i].mode);
        Simulation *sim;
        Trace trace;
        bool sound = bar_run_trace(&run, 100, &sim, &trace, status);
        double early = sound ? hidden_share(&trace, 0, 10) : NAN;
        double late = sound ? hidden_share(&trace, 90, 100) : NAN;
        trace_free(&trace);
        simulation_destroy(sim);
        if (!sound)
            return false;
        /* half of the last digit that is known */
        double slack = run.start.mode == 1 ? 0.0051 : 0.051;
        char what[40];
        snprintf(what, sizeof what, "n = %d, t in [0, 10]", run.start.mode);
        verify_row(verify, &(VerifyRow){what, NULL, NAN, early, 2, 1, {within(cases[i].early, slack)}});
        snprintf(what, sizeof what, "n = %d, t in [90, 100]", run.start.mode);
        verify_row(verify, &(VerifyRow){what, NULL, NAN, late, 2, 1, {within(cases[i].late, slack)}});
    }
    return true;
}

/* --- cell crossings ------------------------------------------------------------------------------ */

/* Whether a particle enters another cell within half a period, where displacements are largest. */
static bool crosses(double velocity, bool *out, Status *status)
{
    Settings run = bar_run(1);
    run.start.velocity = velocity;
    Simulation *sim;
    Trace trace;
    bool sound = bar_run_trace(&run, 5, &sim, &trace, status);
    *out = false;
    for (int i = 0; sound && i < sim->n_events; i++)
        *out = *out || sim->events[i].kind == EVENT_CROSSING;
    trace_free(&trace);
    simulation_destroy(sim);
    return sound;
}

/* The smallest v0 of mode 1 with a crossing, by bisection. */
static bool first_crossing(double *out, Status *status)
{
    double low = 0.1, high = 0.3;
    while (high - low > 1e-4) {
        bool crossed;
        if (!crosses((low + high) / 2, &crossed, status))
            return false;
        *(crossed ? &high : &low) = (low + high) / 2;
    }
    *out = high;
    return true;
}

/* Where particles cross cells the hat function's force jumps, and the run is chaotic: v0 in its ninth digit
 * moves what is left by tenths (1.19 to 1.69 for USF, .91 to .94 for MUSL were seen). What holds is that USF
 * heats, MUSL about keeps and USL loses; smooth shapes give the same number every time. */
bool verify_crossing(Verify *verify, Status *status)
{
    static const struct {
        const char *what;
        MpmAlgorithm algorithm;
        MpmShape shape;
        Bound allowed;
    } cases[] = {
        {"USF, hat: heats", MPM_USF, MPM_HAT, {1.05, 1.7}},
        {"MUSL, hat", MPM_MUSL, MPM_HAT, {0.87, 1.05}},
        {"USL, hat: loses", MPM_USL, MPM_HAT, {0.2, 0.4}},
        {"USF, uGIMP: keeps", MPM_USF, MPM_GIMP, {1.0009 - 0.003, 1.0009 + 0.003}},
        {"USF, B-spline 2: keeps", MPM_USF, MPM_BSPLINE2, {0.9986 - 0.003, 0.9986 + 0.003}},
    };
    verify_head(verify, "energy left, v0 = 1");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Settings run = bar_run(1);
        run.start.velocity = 1;
        run.mesh.padding = 16; /* a heated particle may fly beyond four cells */
        run.mpm.algorithm = cases[i].algorithm, run.mpm.shape = cases[i].shape;
        double left;
        if (!energy_left(&run, &left, status))
            return false;
        verify_row(verify, &(VerifyRow){cases[i].what, NULL, NAN, left, 4, 1, {cases[i].allowed}});
    }
    double first;
    if (!first_crossing(&first, status))
        return false;
    /* a particle next to the free end lies a quarter of a cell from its edge and swings by v0 / omega */
    verify_row(verify,
               &(VerifyRow){"mode 1 crosses from v0", NULL, NAN, first, 4, 1, {within(0.157, 0.0015)}});
    verify_note(verify, "Crossings are chaotic with the hat: v0 in its ninth digit moves it by tenths.");
    return true;
}

/* --- loads --------------------------------------------------------------------------------------- */

/* The first local maximum of a series, and the largest value. */
typedef struct Peaks {
    double first, first_time, largest, largest_time;
} Peaks;

static Peaks find_peaks(const double *values, size_t count, double spacing)
{
    Peaks peaks = {.first = NAN, .first_time = NAN, .largest = -INFINITY};
    for (size_t k = 1; k + 1 < count; k++) {
        if (isnan(peaks.first) && values[k] > values[k - 1] && values[k] >= values[k + 1])
            peaks.first = values[k], peaks.first_time = (double)k * spacing;
        if (values[k] > peaks.largest)
            peaks.largest = values[k], peaks.largest_time = (double)k * spacing;
    }
    return peaks;
}

static bool loaded_peaks(double body_force, double traction, Peaks *peaks, Status *status)
{
    Settings run = bar_run(1);
    run.start.velocity = 0;
    run.loads.body_force = body_force, run.loads.traction = traction;
    Simulation *sim;
    Trace trace;
    bool sound = bar_run_trace(&run, 50, &sim, &trace, status);
    double *v_cm = sound ? trace_column(&trace, "v_cm") : NULL;
    if (v_cm)
        *peaks = find_peaks(v_cm, trace.count, trace.spacing);
    else if (sound)
        sound = status_fail(status, STATUS_FAILED, "not enough memory");
    free(v_cm);
    trace_free(&trace);
    simulation_destroy(sim);
    return sound;
}

bool verify_loads(Verify *verify, Status *status)
{
    Peaks weight, pull;
    if (!loaded_peaks(1e-3, 0, &weight, status) || !loaded_peaks(0, 1e-2, &pull, status))
        return false;
    BarTheory bar = {
        .length = 25, .youngs_modulus = 100, .density = 1, .left_fixed = true, .body_force = 1e-3};
    BarTheory pulled = bar;
    pulled.body_force = 0, pulled.traction = 1e-2;
    double exact = 1000 * bar_centre_velocity(&bar, 2.5),
           exact_pull = 1000 * bar_centre_velocity(&pulled, 2.5);
    verify_head(verify, NULL);
    const VerifyRow rows[] = {
        {"b 1e-3: 1000 v_cm peak", NULL, exact, 1000 * weight.first, 4, 1, {within(1.2499, 1.1e-4)}},
        {"at t", NULL, 2.5, weight.first_time, 2, 1, {within(2.49, 0.0051)}},
        {"1000 v_cm, largest", NULL, exact, 1000 * weight.largest, 4, 1, {within(1.2536, 1.1e-4)}},
        {"at t", NULL, NAN, weight.largest_time, 2, 1, {within(22.51, 0.0051)}},
        {"t 1e-2: 1000 v_cm peak", NULL, exact_pull, 1000 * pull.first, 3, 1, {within(0.960, 0.0011)}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        verify_row(verify, &rows[i]);
    return true;
}

/* --- stability ----------------------------------------------------------------------------------- */

/* A velocity that holds every wave of the mesh: x^2 runs through all wave numbers up to pi/dx. */
static double chirp(double x, const void *context)
{
    const BarDef *def = context;
    return 1e-8 * cos(M_PI * x * x / (2 * def->length * def->cell_size));
}

/* Whether the energy stays what it was, but for a ripple, over many steps. */
static bool stays_bounded(BarDef def, double courant, bool *bounded, Status *status)
{
    enum { STEPS = 20000 };
    def.courant = courant;
    def.initial_velocity = chirp, def.initial_context = &def;
    Simulation *sim = bar_create(&def, status);
    if (!sim)
        return false;
    int total = simulation_find_series(sim, "total");
    double row[16];
    simulation_row(sim, row);
    double start = row[total];
    Status stopped; /* a run that blows up may stop by itself: that is the answer, not a failure */
    *bounded = simulation_steps(sim, STEPS, NULL, NULL, &stopped);
    if (*bounded) {
        simulation_row(sim, row);
        *bounded = row[total] < 100 * start;
    }
    simulation_destroy(sim);
    return true;
}

static bool find_limit(BarDef def, double expected, double *limit, Status *status)
{
    double low = expected / 2, high = expected * 1.1;
    while (high - low > 2e-4 * expected) {
        bool bounded;
        if (!stays_bounded(def, (low + high) / 2, &bounded, status))
            return false;
        *(bounded ? &low : &high) = (low + high) / 2;
    }
    *limit = (low + high) / 2;
    return true;
}

/* The prediction is that of an endless mesh. With the hat the bar's ends do not lower it; with B-splines,
 * whose open knots make their last functions narrow, they do: such a bar must be stable where the program
 * does not warn, and not beyond the prediction. */
bool verify_limits(Verify *verify, Status *status)
{
    static const struct {
        const char *what;
        MpmAlgorithm algorithm;
        MpmShape shape;
        MpmTransfer transfer;
        int particles;
        double reference;
        double least;
    } cases[] = {
        {"USF, hat, P = 1", MPM_USF, MPM_HAT, MPM_FLIP, 1, 2, 1.98},
        {"USF, hat, P = 2", MPM_USF, MPM_HAT, MPM_FLIP, 2, 1.7321, 1.715},
        {"USF, hat, P = 4", MPM_USF, MPM_HAT, MPM_FLIP, 4, 1.6583, 1.642},
        {"MUSL, hat, P = 2", MPM_MUSL, MPM_HAT, MPM_FLIP, 2, 1.7321, 1.715},
        {"USL, hat, P = 1", MPM_USL, MPM_HAT, MPM_FLIP, 1, 0.7071, 0.7},
        {"USL, hat, P = 2", MPM_USL, MPM_HAT, MPM_FLIP, 2, 0.7559, 0.748},
        {"USL, hat, P = 4", MPM_USL, MPM_HAT, MPM_FLIP, 4, 0.7698, 0.762},
        {"APIC, hat, P = 2", MPM_USF, MPM_HAT, MPM_APIC, 2, 1, 0.99},
        {"USF, B-spline 2, P = 2", MPM_USF, MPM_BSPLINE2, MPM_FLIP, 2, 2.395, 1},
        {"USL, B-spline 2, P = 2", MPM_USL, MPM_BSPLINE2, MPM_FLIP, 2, 1.350, 0.7},
    };
    verify_head(verify, "largest stable courant");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Settings run = bar_run(1);
        run.mpm.algorithm = cases[i].algorithm, run.mpm.shape = cases[i].shape;
        run.mpm.transfer = cases[i].transfer, run.mesh.particles_per_cell = cases[i].particles;
        BarMesh mesh = bar_run_mesh(&run);
        double limit;
        if (!find_limit(bar_mpm_definition(&run), cases[i].reference, &limit, status))
            return false;
        verify_row(verify, &(VerifyRow){cases[i].what,
                                        NULL,
                                        bar_endless_courant(&mesh),
                                        limit,
                                        4,
                                        1,
                                        {{cases[i].least, 1.01 * cases[i].reference}}});
    }
    verify_note(verify, "Predicted is an endless mesh; the bar's ends lower the limit of B-splines.");
    return true;
}

#include "lab/settings/parameters.h"

#include "base/text.h"
#include "lab/answers/problem.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const char *const problem_words[] = {"bar", "simply-supported-beam", "moving-cantilever", "notched-beam",
                                     NULL};
const char *const method_words[] = {"mpm", "pd", NULL};
const char *const method_titles[] = {"MPM", "PD"};
const char *const reference_words[] = {"all", "exact", "predicted", "none", NULL};
const char *const colour_words[] = {
    "uy", "ux", "velocity", "energy", "damage", "family", "surface_factor", "drawing", NULL};

static const char *const bar_supports[] = {"fixed-free", "free-fixed", "fixed-fixed", "free-free", NULL};
static const char *const algorithms[] = {"usf", "usl", "musl", NULL};
static const char *const shapes[] = {"hat", "gimp", "bspline2", "bspline3", NULL};
static const char *const transfers[] = {"flip", "apic", NULL};
static const char *const surface_corrections[] = {"none", "energy", "volume", NULL};
static const char *const volume_corrections[] = {"none", "partial", NULL};
static const char *const clamps[] = {"full", "guide", NULL};
static const char *const flags[] = {"no", "yes", NULL};

/* Enum members are read and written as int. */
_Static_assert(sizeof(MpmAlgorithm) == sizeof(int) && sizeof(Clamp) == sizeof(int), "enums are ints");

#define AT(member)    .offset = offsetof(Settings, member)
#define ABOVE_ZERO    .least = 0, .most = HUGE_VAL, .above_least = true
#define FROM_ZERO     .least = 0, .most = HUGE_VAL
#define ANY           .least = -HUGE_VAL, .most = HUGE_VAL
#define CHOICE(words) .type = PARAMETER_CHOICE, .choices = words, .nudge = NUDGE_NEXT
#define NO            NAN

/* The order is that of the fields on screen. Defaults: bar, supported beam, moving cantilever, notched beam.
 */
const Parameter parameters[] = {
    {"bar.length", "Bar", "length", "length", "", PARAMETER_REAL, AT(geometry.length), ABOVE_ZERO,
     .nudge = NUDGE_ONE, .help = "length of the bar; a whole number of cells", .defaults = {25, NO, NO, NO}},
    {"bar.youngs_modulus", "Bar", "Young's modulus", "force/area", "", PARAMETER_REAL,
     AT(material.youngs_modulus), ABOVE_ZERO, .nudge = NUDGE_1_2_5, .help = "stiffness E of the material",
     .defaults = {100, NO, NO, NO}},
    {"bar.density", "Bar", "density", "mass/volume", "", PARAMETER_REAL, AT(material.density), ABOVE_ZERO,
     .nudge = NUDGE_1_2_5, .help = "mass of a unit of volume", .defaults = {1, NO, NO, NO}},
    {"bar.supports", "Bar", "supports", "", "", CHOICE(bar_supports), AT(supports.ends),
     .help = "how the left and the right end are held", .defaults = {BAR_FIXED_FREE, NO, NO, NO}},

    {"beam.length", "Beam", "length", "", "m", PARAMETER_REAL, AT(geometry.length), ABOVE_ZERO,
     .nudge = NUDGE_DOUBLE, .help = "length of the beam",
     .help_moving = "length of the part outside the channel at t = 0", .defaults = {NO, 0.1, 0.1, 0.21}},
    {"beam.height", "Beam", "height", "", "m", PARAMETER_REAL, AT(geometry.height), ABOVE_ZERO,
     .nudge = NUDGE_SPACING, .help = "height; the lattice holds whole rows of it",
     .defaults = {NO, 0.005, 0.005, 0.07}},
    {"beam.thickness", "Beam", "thickness", "", "m", PARAMETER_REAL, AT(geometry.thickness), ABOVE_ZERO,
     .nudge = NUDGE_1_2_5, .help = "size across the plane; scales forces and energies",
     .defaults = {NO, 0.005, 0.005, 0.0254}},
    {"beam.youngs_modulus", "Beam", "Young's modulus", "", "Pa", PARAMETER_REAL, AT(material.youngs_modulus),
     ABOVE_ZERO, .nudge = NUDGE_1_2_5, .help = "stiffness E (Poisson's ratio is 1/3 by theory)",
     .defaults = {NO, 71e9, 71e9, 34.48e9}},
    {"beam.density", "Beam", "density", "", "kg/m^3", PARAMETER_REAL, AT(material.density), ABOVE_ZERO,
     .nudge = NUDGE_1_2_5, .help = "mass of a unit of volume", .defaults = {NO, 2700, 2700, 2400}},

    {"motion.speed", "Motion", "speed", "", "m/s", PARAMETER_REAL, AT(motion.speed), FROM_ZERO,
     .nudge = NUDGE_1_2_5, .help = "speed at which the beam leaves its channel",
     .defaults = {NO, NO, 10, NO}},
    {"motion.channel", "Motion", "channel", "", "m", PARAMETER_REAL, AT(motion.channel), ABOVE_ZERO,
     .nudge = NUDGE_1_2_5, .help = "length of beam inside the channel at t = 0",
     .defaults = {NO, NO, 0.055, NO}},
    {"motion.clamp", "Motion", "clamp", "", "", CHOICE(clamps), AT(motion.clamp),
     .help = "what the channel holds: both displacements, or the transverse one only",
     .defaults = {NO, NO, CLAMP_FULL, NO}},

    {"initial.mode", "Start", "mode", "", "", PARAMETER_INTEGER, AT(start.mode), .least = 0, .most = 9999,
     .nudge = NUDGE_ONE, .help = "mode whose shape the velocity has at t = 0; 0: rigid motion of a free bar",
     .defaults = {1, NO, NO, NO}},
    {"initial.velocity", "Start", "velocity", "length/time", "", PARAMETER_REAL, AT(start.velocity), ANY,
     .nudge = NUDGE_1_2_5, .help = "largest velocity of that mode at t = 0", .defaults = {0.1, NO, NO, NO}},
    {"initial.overtones", "Start", "overtones", "", "", PARAMETER_TEXT, AT(start.overtones),
     .help = "more modes with their velocities at t = 0", .defaults = {0, NO, NO, NO}},
    {"initial.amplitude", "Start", "amplitude", "", "m", PARAMETER_REAL, AT(start.amplitude), ANY,
     .nudge = NUDGE_1_2_5, .help = "deflection U of the beam's mode at t = 0",
     .help_moving = "U at t = 0; the tip's deflection is 2 U", .defaults = {NO, 3e-6, 3e-6, NO}},

    {"mesh.cell_size", "Mesh", "cell size", "length", "", PARAMETER_REAL, AT(mesh.cell_size), ABOVE_ZERO,
     .nudge = NUDGE_DOUBLE, .help = "size dx of a cell; the bar is a whole number of cells",
     .defaults = {1, NO, NO, NO}},
    {"mesh.particles_per_cell", "Mesh", "particles/cell", "", "", PARAMETER_INTEGER,
     AT(mesh.particles_per_cell), .least = 1, .most = 8, .nudge = NUDGE_ONE,
     .help = "particles in each cell at t = 0", .defaults = {2, NO, NO, NO}},
    {"mesh.padding", "Mesh", "padding", "cells", "", PARAMETER_INTEGER, AT(mesh.padding), .least = 0,
     .most = 1000000, .nudge = NUDGE_ONE, .only = OF_MPM, .help = "empty cells beyond each free end",
     .defaults = {4, NO, NO, NO}},

    {"mpm.algorithm", "Method", "algorithm", "", "", CHOICE(algorithms), AT(mpm.algorithm), .live = true,
     .only = OF_MPM,
     .help = "when the stress is updated: first, last, or last with the velocity mapped again",
     .defaults = {MPM_USF, NO, NO, NO}},
    {"mpm.shape", "Method", "shape", "", "", CHOICE(shapes), AT(mpm.shape), .only = OF_MPM,
     .help = "shape functions between particles and nodes", .defaults = {MPM_HAT, NO, NO, NO}},
    {"mpm.transfer", "Method", "transfer", "", "", CHOICE(transfers), AT(mpm.transfer), .live = true,
     .only = OF_MPM, .help = "how velocities come back from the grid: increments (blended), or affine",
     .defaults = {MPM_FLIP, NO, NO, NO}},
    {"mpm.flip_fraction", "Method", "FLIP fraction", "", "", PARAMETER_REAL, AT(mpm.flip_fraction),
     .least = 0, .most = 1, .nudge = NUDGE_1_2_5, .live = true, .only = OF_MPM,
     .help = "1: velocity increments from the grid (FLIP), 0: grid velocities (PIC), between: blended",
     .defaults = {1, NO, NO, NO}},

    {"scenario.method", "Method", "method", "", "", CHOICE(method_words), AT(method),
     .help = "the material point method, or bond-based peridynamics on the same points",
     .defaults = {METHOD_MPM, NO, NO, NO}},

    {"pd.spacing", "Lattice", "spacing", "length", "m", PARAMETER_REAL, AT(lattice.spacing), ABOVE_ZERO,
     .automatic = "auto", .automatic_on_bar = true, .nudge = NUDGE_DOUBLE, .only = OF_PD,
     .help = "distance dx of neighbouring lattice nodes; on a bar, auto: one node for each particle",
     .defaults = {0, 0.25e-3, 0.25e-3, 0.5e-3}},
    {"pd.horizon", "Lattice", "horizon", "length", "m", PARAMETER_REAL, AT(lattice.horizon), ABOVE_ZERO,
     .automatic = "auto", .automatic_on_bar = true, .nudge = NUDGE_SPACING, .only = OF_PD,
     .help = "reach delta of the bonds; usually 3 to 4 spacings; on a bar, auto: 3",
     .defaults = {0, 1e-3, 1e-3, 2e-3}},
    {"pd.surface_correction", "Lattice", "surface corr.", "", "", CHOICE(surface_corrections),
     AT(lattice.surface_correction), .bar_choices = 2,
     .help = "how bonds near a surface, where partners are missing, are stiffened", .only = OF_PD,
     .defaults = {SURFACE_ENERGY, SURFACE_ENERGY, SURFACE_ENERGY, SURFACE_ENERGY}},
    {"pd.volume_correction", "Lattice", "volume corr.", "", "", CHOICE(volume_corrections),
     AT(lattice.volume_correction),
     .help = "whether nodes at the horizon's edge count with a part of their cell", .only = OF_PD,
     .defaults = {VOLUME_PARTIAL, VOLUME_PARTIAL, VOLUME_PARTIAL, VOLUME_PARTIAL}},
    {"pd.critical_stretch", "Bonds", "crit. stretch", "", "", PARAMETER_REAL, AT(bonds.critical_stretch),
     .least = 0, .most = 0.499, .nudge = NUDGE_1_2_5, .live = true,
     .help = "stretch s0 at which a bond breaks; 0: bonds never break", .defaults = {NO, 0, 0, 0.00085}},
    {"pd.critical_energy", "Bonds", "crit. energy", "", "J/m^2", PARAMETER_REAL, AT(bonds.critical_energy),
     FROM_ZERO, .nudge = NUDGE_1_2_5,
     .help = "fracture energy G0: the other handle on the critical stretch; give one",
     .defaults = {NO, 0, 0, 0}},
    {"pd.protected", "Bonds", "protected", "", "m", PARAMETER_REAL, AT(bonds.protected_depth), FROM_ZERO,
     .nudge = NUDGE_SPACING, .help = "depth at load and supports in which bonds never break",
     .defaults = {NO, 0, 0, 0.003}},

    {"notch.position", "Notch", "position", "", "m", PARAMETER_REAL, AT(notch.position), ABOVE_ZERO,
     .nudge = NUDGE_SPACING, .help = "distance of the notch from the left end",
     .defaults = {NO, NO, NO, 0.065}},
    {"notch.depth", "Notch", "depth", "", "m", PARAMETER_REAL, AT(notch.depth), FROM_ZERO,
     .nudge = NUDGE_SPACING, .help = "height to which the notch cuts the beam from below",
     .defaults = {NO, NO, NO, 0.0175}},

    {"load.body_force", "Load", "body force", "length/time^2", "", PARAMETER_REAL, AT(loads.body_force), ANY,
     .nudge = NUDGE_1_2_5, .live = true, .help = "force per unit mass, such as gravity, from t = 0 on",
     .defaults = {0, NO, NO, NO}},
    {"load.traction", "Load", "traction", "force/area", "", PARAMETER_REAL, AT(loads.traction), ANY,
     .nudge = NUDGE_1_2_5, .live = true, .help = "pull at each free end, outwards positive, from t = 0 on",
     .defaults = {0, NO, NO, NO}},
    {"load.traction_layer", "Load", "traction layer", "length", "", PARAMETER_REAL, AT(loads.traction_layer),
     FROM_ZERO, .automatic = "auto", .nudge = NUDGE_1_2_5,
     .help = "depth over which the traction is spread; auto: the last particle", .defaults = {0, NO, NO, NO}},
    {"load.stress", "Load", "stress", "", "Pa", PARAMETER_REAL, AT(loads.stress), ANY, .nudge = NUDGE_1_2_5,
     .live = true, .help = "pressure on the top of the beam", .defaults = {NO, NO, NO, 60e6}},
    {"load.ramp", "Load", "ramp", "", "s", PARAMETER_REAL, AT(loads.ramp), FROM_ZERO, .nudge = NUDGE_1_2_5,
     .help = "time in which the pressure rises to its value", .defaults = {NO, NO, NO, 1e-6}},
    {"load.position", "Load", "load position", "", "m", PARAMETER_REAL, AT(loads.position), FROM_ZERO,
     .nudge = NUDGE_SPACING, .help = "middle of the loaded stretch", .defaults = {NO, NO, NO, 0.105}},
    {"load.width", "Load", "load width", "", "m", PARAMETER_REAL, AT(loads.width), ABOVE_ZERO,
     .nudge = NUDGE_SPACING, .help = "length of the loaded stretch", .defaults = {NO, NO, NO, 0.003}},

    {"supports.left", "Supports", "left", "", "m", PARAMETER_REAL, AT(supports.left), FROM_ZERO,
     .nudge = NUDGE_SPACING, .help = "place of the left support", .defaults = {NO, NO, NO, 0.005}},
    {"supports.right", "Supports", "right", "", "m", PARAMETER_REAL, AT(supports.right), FROM_ZERO,
     .nudge = NUDGE_SPACING, .help = "place of the right support", .defaults = {NO, NO, NO, 0.205}},
    {"supports.pinned", "Supports", "pinned", "", "", PARAMETER_FLAG, AT(supports.pinned), .choices = flags,
     .nudge = NUDGE_NEXT, .help = "whether the left support holds the beam lengthwise too",
     .defaults = {NO, NO, NO, 0}},

    {"time.courant", "Time", "courant number", "", "", PARAMETER_REAL, AT(time.courant), ABOVE_ZERO,
     .nudge = NUDGE_1_2_5, .help = "time step as a share of the time in which a wave crosses a cell",
     .defaults = {0.1, NO, NO, NO}},
    {"time.step", "Time", "time step", "", "s", PARAMETER_REAL, AT(time.step), FROM_ZERO, .automatic = "auto",
     .nudge = NUDGE_DOUBLE, .help = "time step; auto: half the critical one", .defaults = {NO, 0, 0, 1e-7}},
    {"time.end", "Time", "end", "time", "s", PARAMETER_REAL, AT(time.end), ABOVE_ZERO, .nudge = NUDGE_1_2_5,
     .help = "time at which the run ends", .defaults = {100, 1.8e-3, 5e-3, 3e-4}},

    {"output.every", "Output", "row every", "steps", "steps", PARAMETER_INTEGER, AT(output.every), .least = 1,
     .most = 1000000000, .nudge = NUDGE_1_2_5, .help = "steps from one row of the series to the next",
     .defaults = {1, 1, 1, 1}},
    {"output.frames", "Output", "frames", "", "", PARAMETER_INTEGER, AT(output.frames), .least = 0,
     .most = 1000000, .automatic = "", .nudge = NUDGE_1_2_5,
     .help = "times at which tables are written, evenly from 0 to the end; empty: the last step alone",
     .defaults = {0, 0, 0, 0}},
    {"output.at", "Output", "tables at", "time", "s", PARAMETER_TEXT, AT(output.at),
     .help = "named times at which tables are written, ascending, parted by commas",
     .defaults = {0, 0, 0, 0}},
};

const int n_parameters = (int)(sizeof parameters / sizeof *parameters);

#define TEXT(member) offsetof(Settings, member), sizeof(((Settings *)NULL)->member)

const TextKey text_keys[] = {
    {"scenario.title", TEXT(title), "one line that names the scenario in lists", TEXT_ANY},
    {"scenario.about", TEXT(about), "what there is to see; further lines are indented", TEXT_ANY},
    {"question.key", TEXT(question), "the choice that the key t toggles", TEXT_ANY},
    {"view.upper", TEXT(view.upper), "view in the upper plot, 1 to 9", TEXT_VIEW},
    {"view.lower", TEXT(view.lower), "view in the lower plot, 1 to 9", TEXT_VIEW},
    {"view.window", TEXT(view.window), "length of the time window", TEXT_POSITIVE},
    {"view.pace", TEXT(view.pace), "steps per frame", TEXT_POSITIVE},
    {"view.colour", TEXT(view.colour), "what colours a beam, or its drawing with dimensions", TEXT_COLOUR},
    {"view.exaggeration", TEXT(view.exaggeration), "factor by which displacements are drawn", TEXT_POSITIVE},
    {"view.references", TEXT(view.references), "reference curves: all, exact, predicted, none",
     TEXT_REFERENCES},
};

const int n_text_keys = (int)(sizeof text_keys / sizeof *text_keys);

const Parameter *parameter_find(const char *key)
{
    for (int i = 0; i < n_parameters; i++)
        if (strcmp(parameters[i].key, key) == 0)
            return &parameters[i];
    return NULL;
}

const TextKey *text_key_find(const char *key)
{
    for (int i = 0; i < n_text_keys; i++)
        if (strcmp(text_keys[i].key, key) == 0)
            return &text_keys[i];
    return NULL;
}

bool parameter_applies(const Parameter *parameter, Problem problem)
{
    return !isnan(parameter->defaults[problem]);
}

bool settings_have(const Settings *settings, const Parameter *parameter)
{
    const MethodKind other = parameter->only == OF_MPM ? METHOD_PD : METHOD_MPM;
    return parameter_applies(parameter, settings->problem) &&
           (parameter->only == OF_EVERY_METHOD || settings->method != other);
}

/* The distance of a wrong word from a right one; the right name in a wrong section, or in none, is one slip.
 */
static size_t slip(const char *right, const char *wrong)
{
    const char *right_dot = strchr(right, '.'), *wrong_dot = strchr(wrong, '.');
    if (right_dot && strcmp(right_dot + 1, wrong_dot ? wrong_dot + 1 : wrong) == 0)
        return 1;
    return text_distance(right, wrong);
}

static void keep_nearest(const char *right, const char *wrong, const char **nearest, size_t *least)
{
    size_t distance = slip(right, wrong);
    if (distance < *least)
        *least = distance, *nearest = right;
}

static size_t too_far(const char *wrong)
{
    size_t length = strlen(wrong), share = length / 3;
    return length < 3 ? length : (share < 2 ? 2 : share) + 1;
}

const char *nearest_word(const char *const *words, const char *wrong)
{
    const char *nearest = NULL;
    size_t least = too_far(wrong);
    for (; *words; words++)
        keep_nearest(*words, wrong, &nearest, &least);
    return nearest;
}

/* Who leaves the section away means the same. */
static void keep_nearest_key(const char *right, const char *wrong, const char **nearest, size_t *least)
{
    const char *dot = strchr(wrong, '.') ? NULL : strchr(right, '.');
    const size_t before = *least;
    keep_nearest(right, wrong, nearest, least);
    if (dot)
        keep_nearest(dot + 1, wrong, nearest, least);
    if (*least < before)
        *nearest = right;
}

const char *parameter_nearest(Problem problem, const char *key)
{
    const char *nearest = NULL;
    size_t least = too_far(key);
    for (int i = 0; i < n_parameters; i++)
        if (parameter_applies(&parameters[i], problem))
            keep_nearest_key(parameters[i].key, key, &nearest, &least);
    for (int i = 0; i < n_text_keys; i++)
        keep_nearest(text_keys[i].key, key, &nearest, &least);
    return nearest;
}

const char *parameter_unit(const Parameter *parameter, Problem problem)
{
    return problem_facts[problem].si ? parameter->unit_beam : parameter->unit_bar;
}

const char *parameter_help(const Parameter *parameter, Problem problem)
{
    const bool moving = problem == PROBLEM_MOVING_CANTILEVER && parameter->help_moving;
    return moving ? parameter->help_moving : parameter->help;
}

const char *parameter_automatic(const Parameter *parameter, Problem problem)
{
    return parameter->automatic_on_bar && problem != PROBLEM_BAR ? NULL : parameter->automatic;
}

int parameter_choices(const Parameter *parameter, Problem problem)
{
    int count = 0;
    if (problem == PROBLEM_BAR && parameter->bar_choices > 0)
        return parameter->bar_choices;
    while (parameter->choices && parameter->choices[count])
        count++;
    return count;
}

void parameter_range(const Parameter *parameter, Problem problem, char *out, size_t size)
{
    char least[NUMBER_TEXT_MAX], most[NUMBER_TEXT_MAX];
    text_shortest(least, parameter->least);
    text_shortest(most, parameter->most);
    const char *automatic = parameter_automatic(parameter, problem);
    const char *or_word = automatic ? *automatic ? automatic : "empty" : "";
    const char *or_bar = automatic ? " | " : "";
    if (parameter->choices) {
        size_t used = 0;
        for (int i = 0; i < parameter_choices(parameter, problem) && used < size; i++)
            used += (size_t)snprintf(out + used, size - used, "%s%s", i ? " | " : "", parameter->choices[i]);
    } else if (parameter->type == PARAMETER_TEXT) {
        snprintf(out, size, "%s",
                 strcmp(parameter->key, "initial.overtones") == 0 ? "mode:velocity,..." : "time,time,...");
    } else if (isinf(parameter->least)) {
        snprintf(out, size, "any number");
    } else if (isinf(parameter->most)) {
        const char *sign = parameter->above_least || automatic ? ">" : ">=";
        snprintf(out, size, "%s%s%s %s", or_word, or_bar, sign, least);
    } else {
        snprintf(out, size, "%s%s%s to %s", or_word, or_bar, automatic && parameter->least == 0 ? "1" : least,
                 most);
    }
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The script for LAMMPS: what differs, bonds, supports, loads, damping, rest, and what is written. */
#include "export/lammps_internal.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "base/kinds.h"
#include "problems/problem.h"

#include <math.h>

enum { PRINT_ROWS = 1000 };

static bool leaves_channel(const LammpsBody *body)
{
    return body->settings->problem->concerns & CONCERN_MOTION;
}

/* --- what differs --------------------------------------------------------------------------------------- */

static void write_body_differences(FILE *file, const LammpsBody *body)
{
    const Settings *settings = body->settings;
    const bool surface = settings_lattice(settings)->surface_correction != SURFACE_NONE,
               volume = settings_lattice(settings)->volume_correction != VOLUME_PARTIAL;
    if (surface)
        fputs("# - there is no surface correction, so the skin is soft; compare with\n"
              "#   pd.surface_correction=none\n",
              file);
    if (volume)
        fputs("# - volumes near the horizon count in part; compare with pd.volume_correction=partial\n",
              file);
    /* matvib would find another step for the other lattice, and the rows of the two would not meet */
    if (surface || volume)
        LAMMPS_LINE(file, "#   and with time.step=@, the step of this script\n", body->sim->dt);
    fputs("# - nodes that come nearer than nine tenths of their first distance, and than 1.35 dx, push each "
          "other\n"
          "#   away (short-range forces), though not across a cut\n"
          "# - a bond whose length differs from its first by less than 2.2e-16 m does not pull\n"
          "# - the volume of a node is dx^3 where matvib has dx^2 and unit thickness; the micromodulus is "
          "that\n"
          "#   of the two-dimensional model over dx, so forces per volume are the same\n",
          file);
}

static void write_breaking_differences(FILE *file, const LammpsBody *body)
{
    if (!lammps_breaks(body))
        return;
    fputs(
        "# - a bond that reaches the critical stretch still pulls once and breaks before the next step, so\n"
        "#   from the first break on the two runs part slowly; none breaks by the forces at t = 0\n",
        file);
    if (lammps_protects(body))
        fputs("# - LAMMPS of May 2026 and before breaks the bonds of a node by the largest critical stretch "
              "among\n"
              "#   them, so that the zone that never breaks reaches up to one horizon further; since June "
              "2026\n"
              "#   each bond breaks by its own, as here\n",
              file);
    fputs("# - c_damage counts volumes near the horizon whole, and bonds that a cut parts not at all;\n"
          "#   broken_bonds counts the bonds broken in the run, as here\n",
          file);
}

static void write_rest_differences(FILE *file, const LammpsBody *body)
{
    if (body->facts.damping > 0)
        fputs(
            "# - the damping of central differences is fix viscous with the density times 1 + alpha dt/2 and "
            "first\n"
            "#   velocities that make its first half step the same; kinetic energies have that factor too\n",
            file);
    if (settings_time(body->settings)->rest)
        fprintf(
            file,
            "# - the run ends when it is once found at rest, every %d steps; where it is damped less than\n"
            "#   critically matvib waits half a period longer\n",
            BEAM_REST_EVERY);
}

static void write_head(FILE *file, const LammpsBody *body)
{
    const Settings *settings = body->settings;
    fprintf(file, "# %s\n# Written by matvib " PACKAGE_VERSION "; run it with: lmp -in in.matvib\n#\n",
            *settings->title ? settings->title : settings->problem->title);
    fputs("# What differs from matvib's own run of this scenario:\n", file);
    write_body_differences(file, body);
    write_breaking_differences(file, body);
    write_rest_differences(file, body);
    fputc('\n', file);
}

/* --- the model ------------------------------------------------------------------------------------------ */

static void write_model(FILE *file, const LammpsBody *body)
{
    fputs("units si\ndimension 2\nboundary s s p\natom_style peri\natom_modify map array\n", file);
    LAMMPS_LINE(file, "lattice sq @\nread_data data.matvib\n\n", settings_lattice(body->settings)->spacing);
}

static void write_pairs(FILE *file, const LammpsBody *body)
{
    const Lattice *lattice = settings_lattice(body->settings);
    /* the last bonds of a family end at the horizon but for the rounding of positions */
    const double stiffness = body->facts.micromodulus / lattice->spacing,
                 horizon = lattice->horizon * (1 + 1e-9), never = 1e9;
    LAMMPS_LINE(file, "pair_style peri/pmb\npair_coeff * * @ @ @ 0\n", stiffness, horizon,
                lammps_breaks(body) ? settings_bonds(body->settings)->critical_stretch : never);
    if (lammps_protects(body)) {
        fprintf(file, "pair_coeff * %d* ", body->first_protected);
        LAMMPS_LINE(file, "@ @ @ 0\n", stiffness, horizon, never);
    }
    LAMMPS_LINE(file, "neighbor @ bin\nneigh_modify delay 0\n", lattice->horizon / 20);
    lammps_write_cuts(file, body);
}

/* The nodes of a patch join a group. */
static void write_group(FILE *file, const LammpsBody *body, const char *name, const Patch *patch)
{
    fprintf(file, "group %s id", name);
    for (int j = patch->j; j < patch->j + patch->rows; j++) {
        const int first = j * body->facts.nx + patch->i + 1;
        fprintf(file, " %d:%d", first, first + patch->columns - 1);
    }
    fputc('\n', file);
}

static void write_supports(FILE *file, const LammpsBody *body)
{
    static const char *const names[] = {"held_x", "held_y"}, *const forces[] = {"0 NULL NULL", "NULL 0 NULL"};
    for (int axis = 0; axis < 2; axis++) {
        bool any = false;
        for (const Support *s = body->supports; s < body->supports + body->n_supports; s++)
            if (axis == 0 ? s->x : s->y) {
                write_group(file, body, names[axis], &s->patch);
                any = true;
            }
        if (any)
            fprintf(file, "fix hold_%s %s setforce %s\n", names[axis], names[axis], forces[axis]);
    }
}

static void write_channel(FILE *file, const LammpsBody *body)
{
    LAMMPS_LINE(file, "region channel block INF @ INF INF INF INF units box\n",
                -1e-6 * settings_lattice(body->settings)->spacing);
    fprintf(file,
            "group held dynamic all region channel every 1\n"
            "fix hold held setforce %s 0 0\n",
            settings_motion(body->settings)->clamp == CLAMP_FULL ? "0" : "NULL");
}

/* A traction over dx, times its share of now (load_share() of patches.h): min(1, t/ramp), and from the step
 * nearest to `until` on nothing, in that one half. */
static void write_load(FILE *file, const LammpsBody *body, int number)
{
    const Load *load = &body->loads[number - 1];
    const double dx = settings_lattice(body->settings)->spacing;
    char name[32];
    snprintf(name, sizeof name, "load%d", number);
    write_group(file, body, name, &load->patch);
    fprintf(file, "variable share%d equal 1", number);
    if (load->ramp > 0)
        LAMMPS_LINE(file, "*((v_time<@)*v_time/@+(v_time>=@))", load->ramp, load->ramp, load->ramp);
    if (isfinite(load->until)) {
        const double last = round(load->until / body->sim->dt);
        LAMMPS_LINE(file, "*((step<@)+(step==@)/2)", last, last);
    }
    fprintf(file, "\nvariable load%d_x equal v_share%d", number, number);
    LAMMPS_LINE(file, "*(@)\n", load->sx / dx);
    fprintf(file, "variable load%d_y equal v_share%d", number, number);
    LAMMPS_LINE(file, "*(@)\n", load->sy / dx);
    fprintf(file, "fix push%d load%d addforce v_load%d_x v_load%d_y 0\n", number, number, number, number);
}

/* Whatever holds comes last: it takes all forces away. */
static void write_forces(FILE *file, const LammpsBody *body)
{
    const Settings *settings = body->settings;
    const double density = settings_material(settings)->density, braking = body->facts.damping * density;
    const double along = leaves_channel(body) ? braking * settings_motion(settings)->speed : 0,
                 across = density * settings_loads(settings)->body_force;
    fputs("variable time equal step*dt\nfix motion all nve\n", file);
    if (along != 0 || across != 0)
        LAMMPS_LINE(file, "fix weight all addforce @ @ 0\n", along, across);
    for (int number = 1; number <= body->n_loads; number++)
        write_load(file, body, number);
    if (braking > 0)
        LAMMPS_LINE(file, "fix brake all viscous @\n", braking);
    if (leaves_channel(body))
        write_channel(file, body);
    write_supports(file, body);
}

/* --- what it writes ------------------------------------------------------------------------------------- */

/* A variable that is the mean of a property over the nodes of the probe, less what it was at first. */
static void write_mean(FILE *file, const LammpsBody *body, const char *name, const char *property,
                       const double *first)
{
    size_t count = 0;
    double sum = 0;
    fprintf(file, "variable %s equal \"(", name);
    for (size_t k = 0; k < body->count; k++)
        if (body->probe[k] != 0) {
            fprintf(file, "%s%s[%zu]", count++ ? "+" : "", property, k + 1);
            sum += first ? first[k] : 0;
        }
    fprintf(file, ")/%zu", count);
    LAMMPS_LINE(file, first ? "-(@)\"\n" : "\"\n", sum / (double)count);
}

static void write_probe(FILE *file, const LammpsBody *body, long every)
{
    const bool two_ways = body->settings->problem->concerns & CONCERN_PLATE;
    write_mean(file, body, "u_probe", "y", body->y);
    write_mean(file, body, "v_probe", "vy", NULL);
    if (two_ways) {
        write_mean(file, body, "ux_probe", "x", body->x);
        write_mean(file, body, "vx_probe", "vx", NULL);
    }
    if (lammps_breaks(body))
        fputs("compute damage all damage/atom\nvariable whole atomfile bonds.matvib\n"
              "variable broken atom c_damage*v_whole/2\ncompute broken all reduce sum v_broken\n",
              file);
    fprintf(file,
            "fix probe all print %ld \"$(step),$(v_time:%%.16g),$(v_u_probe:%%.16g),$(v_v_probe:%%.16g)",
            every);
    fprintf(file, "%s%s\" &\n    file probe.csv title step,time,u_probe,v_probe%s%s screen no\n",
            two_ways ? ",$(v_ux_probe:%.16g),$(v_vx_probe:%.16g)" : "",
            lammps_breaks(body) ? ",$(c_broken:%.0f)" : "", two_ways ? ",ux_probe,vx_probe" : "",
            lammps_breaks(body) ? ",broken_bonds" : "");
}

static void write_rest(FILE *file)
{
    fprintf(file, "compute moving all ke\nfix moving all vector %d c_moving\n", BEAM_REST_EVERY);
    LAMMPS_LINE(file, "variable rested equal \"c_moving<=@*max(f_moving)\"\n", BEAM_REST_SHARE);
    fprintf(file, "fix rest all halt %d v_rested != 0 error continue\n", BEAM_REST_EVERY);
}

void lammps_write_script(FILE *file, const LammpsBody *body)
{
    const Settings *settings = body->settings;
    const double dt = body->sim->dt;
    const long steps = problem_last_step(dt, settings_time(settings)->end);
    long every = settings_output(settings)->every;
    if (steps / every > PRINT_ROWS * 10)
        every *= steps / every / PRINT_ROWS;
    write_head(file, body);
    write_model(file, body);
    write_pairs(file, body);
    fputc('\n', file);
    write_forces(file, body);
    LAMMPS_LINE(file, "\ntimestep @\nthermo 1000\n", dt);
    if (lammps_starts_bent(body))
        fputs("\n# bonds are made of the straight beam, then it is bent\nrun 0\n"
              "variable ux atomfile ux.matvib\nvariable uy atomfile uy.matvib\n"
              "displace_atoms all move v_ux v_uy 0 units box\n\n",
              file);
    if (lammps_breaks(body) && !lammps_starts_bent(body))
        fputs("\n# bonds are made before they are counted, or those that do not count yet seem broken\nrun 0 "
              "post no\n",
              file);
    write_probe(file, body, every);
    if (lammps_breaks(body))
        fprintf(file, "dump damage all custom %ld damage.dump id x y c_damage\n",
                steps > 10 ? steps / 10 : 1);
    if (settings_time(settings)->rest)
        write_rest(file);
    fprintf(file, "run %ld\n", steps);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes a beam or a plate as input for LAMMPS (lammps.h): what is refused, and the files, all or none. */
#include "export/lammps.h"
#include "scenario/concern_bonds.h"
#include "scenario/settings.h"
#include "base/kinds.h"
#include "export/lammps_internal.h"
#include "problems/problem.h"
#include "scenario/parameters.h"

#include <stdlib.h>

typedef enum FileKind { FILE_SCRIPT, FILE_DATA, FILE_BONDS, FILE_UX, FILE_UY, N_FILES } FileKind;

static const char *const file_names[N_FILES] = {"in.matvib", "data.matvib", "bonds.matvib", "ux.matvib",
                                                "uy.matvib"};

static void write_file(FILE *file, FileKind kind, const LammpsBody *body)
{
    switch (kind) {
    case FILE_SCRIPT:
        lammps_write_script(file, body);
        break;
    case FILE_DATA:
        lammps_write_data(file, body);
        break;
    case FILE_BONDS:
        lammps_write_numbers(file, body, body->whole);
        break;
    case FILE_UX:
        lammps_write_numbers(file, body, body->ux);
        break;
    case FILE_UY:
        lammps_write_numbers(file, body, body->uy);
        break;
    case N_FILES:
        break;
    }
}

static bool write_all(const LammpsBody *body, Asker asker, const char *folder, bool force, Status *status)
{
    OutputFile files[N_FILES] = {0};
    FileKind kinds[N_FILES] = {FILE_SCRIPT, FILE_DATA};
    int count = FILE_BONDS;
    bool done = true;
    if (lammps_breaks(body))
        kinds[count++] = FILE_BONDS;
    if (lammps_starts_bent(body)) {
        kinds[count++] = FILE_UX;
        kinds[count++] = FILE_UY;
    }
    for (int k = 0; k < count && done; k++) {
        char *name;
        if (asprintf(&name, "%s/%s", folder, file_names[kinds[k]]) < 0) {
            done = status_fail(status, "not enough memory for the names of files");
            break; /* the files begun are removed below */
        }
        done = output_open(&files[k], asker, name, force, status);
        free(name);
    }
    for (int k = 0; k < count && done; k++) {
        write_file(files[k].stream, kinds[k], body);
        done = output_finish(&files[k], status) &&
               (patience_lasts(&body->settings->patience, (k + 1.0) / count) ||
                status_fail(status, "interrupted"));
    }
    for (int k = 0; k < count && done; k++)
        done = output_commit(&files[k], status);
    for (int k = 0; k < count; k++)
        output_close(&files[k]);
    return done;
}

/* What is no body of nodes and bonds in the plane, and what pair_style peri/pmb has nothing for. */
static bool has_its_like(const Settings *settings, Status *status)
{
    if (!(settings->problem->concerns & (CONCERN_BEAM | CONCERN_PLATE)))
        return status_refuse(status, "scenario.problem: LAMMPS gets beams and plates only (not %s)",
                             settings->problem->word);
    if (settings->method != METHOD_PD)
        return status_refuse(status, "scenario.method: LAMMPS gets nodes with bonds only (pd)");
    if (!settings_refuse_mistake(settings, "LAMMPS is no wrong code", status))
        return false;
    if (settings->n_changes > 0)
        return status_refuse(status, "changes: LAMMPS gets runs without changes in mid-run only");
    if (settings_lattice(settings)->volume_correction == VOLUME_HHB)
        return status_refuse(
            status, "pd.volume_correction: LAMMPS has no bonds longer than the horizon (none | partial)");
    return settings_lattice(settings)->influence == INFLUENCE_CONSTANT ||
           status_refuse(status,
                         "pd.influence: LAMMPS has bonds of one stiffness for every length (constant)");
}

bool lammps_export(const Settings *settings, Asker asker, const char *folder, bool force, Status *status)
{
    if (!has_its_like(settings, status))
        return false;
    Simulation *sim = problem_simulate(settings, 1, status);
    if (!sim)
        return false;
    LammpsBody body = {.sim = sim, .settings = settings};
    bool made = false, done = lammps_body_read(&body, status) && lammps_set_types(&body, status) &&
                              output_make_folder(asker, folder, &made, status) &&
                              write_all(&body, asker, folder, force, status);
    if (made && !done)
        output_remove_folder(asker, folder);
    lammps_body_free(&body);
    simulation_destroy(sim);
    return done;
}

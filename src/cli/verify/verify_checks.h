/* The checks of a verification, one function each. A check prints its table; it returns false, with a status,
 * where a run could not be made or stopped: that is a miss too. */
#ifndef CLI_VERIFY_CHECKS_H
#define CLI_VERIFY_CHECKS_H

#include "base/status.h"
#include "cli/verify/verify_sheet.h"

#include <stdbool.h>

/* The bar by the material point method: verify_bar.c, verify_energy.c. */
bool verify_mode1(Verify *verify, Status *status);
bool verify_mode5(Verify *verify, Status *status);
bool verify_mode10(Verify *verify, Status *status);
bool verify_cell_size(Verify *verify, Status *status);
bool verify_particles(Verify *verify, Status *status);
bool verify_time_step(Verify *verify, Status *status);
bool verify_energy_left(Verify *verify, Status *status);
bool verify_hidden_energy(Verify *verify, Status *status);
bool verify_crossing(Verify *verify, Status *status);
bool verify_loads(Verify *verify, Status *status);
bool verify_limits(Verify *verify, Status *status);

/* The same bar by peridynamics: verify_rod.c. */
bool verify_rod(Verify *verify, Status *status);

/* Beams by peridynamics: verify_beam.c, verify_moving.c, verify_notch.c. */
bool verify_surface(Verify *verify, Status *status);
bool verify_critical_step(Verify *verify, Status *status);
bool verify_table1(Verify *verify, Status *status);
bool verify_midpoint(Verify *verify, Status *status);
bool verify_midpoint_velocity(Verify *verify, Status *status);
bool verify_moving_tip(Verify *verify, Status *status);
bool verify_moving_velocity(Verify *verify, Status *status);
bool verify_crack_times(Verify *verify, Status *status);
bool verify_crack_path(Verify *verify, Status *status);

#endif

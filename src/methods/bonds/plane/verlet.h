/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stages of velocity Verlet (paper P, eqs. 9 to 11) as people read them: rows of the stage tables of
 * beams and of the bar, each with the fields that it reads and writes there. */
#ifndef METHODS_BONDS_PLANE_VERLET_H
#define METHODS_BONDS_PLANE_VERLET_H

#define VERLET_HALF_KICK(fields_read, fields_written)                                                        \
    {                                                                                                        \
        "half-kick", "half kick", "v(n+½) = v(n) + Δt/2 a(n),   a = f/ρ", "eq. 9",                           \
            "The force of the last step gives every node half a step's worth of new velocity.", fields_read, \
            fields_written                                                                                   \
    }

#define VERLET_DRIFT(fields_read, fields_written)                                                            \
    {                                                                                                        \
        "drift", "drift", "u(n+1) = u(n) + Δt v(n+½)", "eq. 10",                                             \
            "Every node moves on with its half-step velocity.", fields_read, fields_written                  \
    }

#define VERLET_SECOND_KICK(says, fields_read, fields_written)                                                \
    {                                                                                                        \
        "second-kick", "second half kick", "v(n+1) = v(n+½) + Δt/2 a(n+1)", "eq. 11", says, fields_read,     \
            fields_written                                                                                   \
    }

#endif

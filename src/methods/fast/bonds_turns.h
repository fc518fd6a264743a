/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Part of bonds_step.c: whole steps by bands of rows, several threads at once, in which the end of a step and
 * the start of the next are one pass over a band while its rows are in the cache. */

/* What a step does before its bond forces, on one row: nothing here looks at another row. */
static void begin_row(Beam *beam, int j, long step)
{
    half_kick(beam, j, step);
    drift(beam, j, step);
    constraints(beam, j, step);
}

/* And behind them: the row first receives what the bands below have for it. */
static void end_row(Beam *beam, int j, long step)
{
    beam_add_halos(beam, j);
    body_force(beam, j, step);
    second_kick(beam, j, step);
}

static void begin_chunk(void *context, int band, int worker)
{
    (void)worker;
    Beam *beam = context;
    for (int j = beam->band_first[band]; j < beam->band_first[band + 1]; j++)
        begin_row(beam, j, beam->sim.step);
}

static void end_chunk(void *context, int band, int worker)
{
    (void)worker;
    Beam *beam = context;
    for (int j = beam->band_first[band]; j < beam->band_first[band + 1]; j++)
        end_row(beam, j, beam->sim.step);
}

/* Of a step whose row is taken: with what the row needs of the velocities. */
static void watched_end_chunk(void *context, int band, int worker)
{
    Beam *beam = context;
    end_chunk(context, band, worker);
    for (int j = beam->band_first[band]; j < beam->band_first[band + 1]; j++)
        beam_note_squares(beam, j);
}

/* The end of this step and the start of the next, while the row is at hand. */
static void turn_chunk(void *context, int band, int worker)
{
    (void)worker;
    Beam *beam = context;
    for (int j = beam->band_first[band]; j < beam->band_first[band + 1]; j++) {
        end_row(beam, j, beam->sim.step);
        begin_row(beam, j, beam->sim.step + 1);
    }
}

/* Whole steps, fewer where the beam comes to rest; rows: n_series numbers for each, or NULL. The end of a
 * step and the beginning of the next touch the same row of nodes and nothing else, so they are one pass while
 * the row is in the cache (turn_chunk); only a row of the series in between parts them. On failure the state
 * is in the middle of the step that failed. */
static bool run_turns(Beam *beam, long count, double *rows, Status *status)
{
    Simulation *sim = &beam->sim;
    bool begun = false;
    for (long n = 0; n < count && !beam->sim.at_rest; n++) {
        beam->strain_known = beam->kinetic_known = false;
        if (!begun) {
            beam_run(beam, begin_chunk, beam->n_bands);
            beam_add_work(beam, 0);
            beam_add_speeds(beam);
        }

        beam_bond_forces(beam, rows != NULL);
        bool sound = true;
        for (int band = 0; band < beam->n_bands; band++)
            sound = take_log(beam, &beam->band_logs[band], sim->step, status) && sound;
        if (!sound)
            return false;

        bool pause = rows || n + 1 == count || beam_asks_for_rest(beam, sim->step + 1);
        beam_run(beam, rows ? watched_end_chunk : pause ? end_chunk : turn_chunk, beam->n_bands);
        if (rows)
            beam_keep_kinetic(beam);
        begun = !pause;
        beam_add_work(beam, 1);
        if (begun) {
            beam_add_work(beam, 0);
            beam_add_speeds(beam);
        }
        beam_update_damage(beam, sim->step + 1);
        if (pause)
            beam_look_for_rest(beam, sim->step + 1);
        sim->step++;
        if (rows)
            beam_row(sim, rows + n * sim->n_series);
    }
    return true;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stages and whole steps as the driver asks for them (method.h), by one thread or several. Whole steps go in
 * batches (batch.h). */
#include "base/assertion.h"
#include "methods/mpm/mistakes.h"

#include <stdio.h>
#include <string.h>

/* How a particle ended that is not where it could go on. */
static const char *end_of(const Mpm *mpm, int p)
{
    if (mpm->bodies)
        return mpm->head->torn > 0
                   ? "left the box, torn from its body (gimp or more particles hold it longer)"
                   : "left the box by an open side (a wall there, a larger box, or an earlier end)";
    if (mpm->dim == 2)
        return "left the grid";
    const bool box = mpm->shape == MPM_GIMP || mpm->shape == MPM_CPDI;
    const double r = mpm->rest[0][p] + mpm->u[0][p] / mpm->dx;
    if (r >= mpm->low[0] && r < mpm->high[0])
        return "was overtaken by its neighbour (1 + de <= 0)";
    return box && (r < mpm->low[0] ? mpm->fixed_left : mpm->fixed_right) > 0
               ? "left the mesh through a support (its box reaches past the fixed node, which stops only the "
                 "grid)"
               : "left the mesh";
}

/* The first particle that a stage could not go on with. */
static bool judge(Mpm *mpm, MpmOp op, int first, int end, Status *status)
{
    int worst = -1;
    for (int k = first; k < end; k++) {
        MpmChunk *chunk = &mpm->chunks[k];
        if (chunk->trouble < 0 || chunk->found_by != op)
            continue;
        if (worst < 0 || chunk->trouble < worst)
            worst = chunk->trouble;
        chunk->trouble = -1;
    }
    if (worst < 0)
        return true;
    for (int k = 0; k < mpm->n_chunks; k++)
        mpm->chunks[k].trouble = -1;
    return mpm_fail_particle(
        mpm, status, worst,
        op != OP_STRAIN ? end_of(mpm, worst)
        : mpm->bodies
            ? "was turned inside out (det F <= 0; a smaller Courant number, gimp, musl or more particles)"
        : mpm->dim == 1 ? "was crushed (1 + de <= 0)"
                        : "was crushed (1 + exx + eyy <= 0)");
}

/* --- one stage ------------------------------------------------------------------------------------- */

/* What went wrong in a chunk stays so until somebody has looked: later stages leave it alone. */
static void do_item(Mpm *mpm, MpmTask task, int item)
{
    if (mpm_op_of_nodes(task.op)) {
        const int64_t n = mpm->bodies ? mpm->grid_nodes : mpm->n_nodes;
        mpm_do_nodes(mpm, task.op, (int)(n * item / mpm->n_chunks), (int)(n * (item + 1) / mpm->n_chunks));
        return;
    }
    MpmChunk *chunk = &mpm->chunks[item];
    if (task.op == OP_FORGET)
        chunk->span = (MpmSpan){INT_MAX, 0};
    for (int row = 0; row < chunk->rows && chunk->trouble < 0; row++) {
        const int first = chunk->first + row * chunk->stride;
        chunk->trouble = mpm_do_particles(mpm, task, &chunk->span, first, first + chunk->count);
        chunk->found_by = task.op;
    }
}

/* Some stages that follow each other on each chunk, or on as great a share of the nodes. */
typedef struct Group {
    Mpm *mpm;
    const MpmTask *tasks;
    int count, first; /* first: the item with which a job begins */
} Group;

static void do_items(void *context, int item, int worker)
{
    const Group *group = context;
    (void)worker;
    for (int k = 0; k < group->count; k++)
        do_item(group->mpm, group->tasks[k], group->first + item);
}

/* Whether no two chunks [first, end), which are in the order of the body, give to the same node. */
static bool are_apart(const Mpm *mpm, int first, int end)
{
    for (int k = first; k + 1 < end; k++)
        if (mpm->chunks[k].span.high + mpm->support > mpm->chunks[k + 1].span.low)
            return false;
    return true;
}

static void run_items(Group *group, int end, bool shared)
{
    if (group->mpm->pool && shared)
        pool_run(group->mpm->pool, do_items, group, end - group->first);
    else
        for (int item = 0; item < end - group->first; item++)
            do_items(group, item, 0);
}

/* Some stages over everything. Those on particles that follow each other are done chunk by chunk, one after
 * the other while the chunk is in the cache, up to one that gives to the nodes: the order of every sum is the
 * same. By several threads that one begins again, as it asks which chunks are apart. A wrong code looks at
 * what the stage before has left as a whole. */
static bool do_all(Mpm *mpm, const MpmTask *tasks, int count, Status *status)
{
    const int n = mpm->n_chunks, even = (n + 1) / 2;
    for (int first = 0, end; first < count; first = end) {
        end = first + 1;
        while (end < count && !mpm_op_of_nodes(tasks[end].op) && !mpm_op_of_nodes(tasks[end - 1].op) &&
               !mpm_op_gives(tasks[end - 1].op) && mpm->wrong == 0 &&
               !(mpm->pool && tasks[end - 1].op == OP_FORGET))
            end++;
        for (int k = first; k < end; k++)
            mpm_begin_stage(mpm, tasks[k].op, tasks[k].step);
        Group group = {mpm, tasks + first, end - first, 0};
        if (mpm_op_gives(tasks[end - 1].op)) {
            run_items(&group, even, are_apart(mpm, 0, even));
            group.first = even;
            run_items(&group, n, are_apart(mpm, even, n));
        } else
            run_items(&group, n, true);
        for (int k = first; k < end; k++)
            if (!judge(mpm, tasks[k].op, 0, n, status) || !mpm_end_stage(mpm, tasks[k].op, status))
                return false;
    }
    return true;
}

static void mpm_map_and_fix(Mpm *mpm)
{
    Status unused; /* neither of them fails */
    do_all(mpm, (MpmTask[]){{OP_MAP, mpm->sim.step}, {OP_FIX, mpm->sim.step}}, 2, &unused);
}

/* Fails where energy > 1e4 (E_0 + max |work|), and reports growth on the way. Heating by cell crossing is a
 * matter of some ten per cent, at worst a small factor; an unstable run gets to a hundred in velocity in a
 * few hundred steps, and a beam of hats that leaves its channel a while before its particles leave the grid.
 *
 * Seen from a beam the channel moves nothing that it holds and does no work: its work in the laboratory, some
 * times the energy of the vibration, is left out. A beam that does not vibrate has what rounding makes of its
 * common speed, at most some 1e-20 of 1/2 m v0^2 in a million steps. */
static bool check_energy(Mpm *mpm, Status *status)
{
    static const double levels[] = {1.1, 2.0, 10.0, 100.0, 1000.0}, bound = 1e4;
    static const char *const words[] = {"by 10 %", "to twice", "to 10 times", "to 100 times",
                                        "to 1000 times"};
    enum { LEVELS = sizeof levels / sizeof *levels };
    const bool beam = mpm->def.problem == MPM_BEAM;
    MpmHead *head = mpm->head;
    if ((mpm->sim.step + 1) % BATCH_STEPS != 0)
        return true;
    const double body = mpm->mass[0] * mpm->n_particles * mpm->def.thickness;
    const double rounding = 1e-20 * body * mpm->speed * mpm->speed / 2;
    head->peak_work = fmax(head->peak_work, beam ? 0 : fabs(mpm->head->work));
    const double reference = fmax(mpm->energy_start, rounding) + head->peak_work, energy = mpm_energy(mpm);
    if (!(energy <= bound * reference)) { /* a NaN fails too */
        char when[BATCH_WORDS_MAX];
        batch_step_words(&mpm->sim, beam ? " s" : "", when);
        return simulation_fail(&mpm->sim, status,
                               "the energy has grown to more than %g times what was put in, %s: the run is "
                               "unstable (a smaller Courant number, or %s)",
                               bound, when,
                               mpm->bodies ? "uGIMP, MUSL, or more particles"
                               : beam      ? "other shapes"
                               : bar_feels_light_nodes(&mpm->def, mpm->head->transfer)
                                   ? "another shape: " BAR_LIGHT_NODES
                                   : "another algorithm");
    }
    while (head->level < LEVELS && energy > levels[head->level] * reference) {
        char text[80];
        snprintf(text, sizeof text, "the energy has grown %s", words[head->level++]);
        batch_report(&mpm->sim, EVENT_ENERGY, text);
    }
    return true;
}

/* One stage on its items [first, end), serially, for the stage stepper (method.h); an item is a chunk, or as
 * great a share of the nodes. The energy is checked behind the last stage. */
bool mpm_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status)
{
    ASSERT_INDEX(stage, sim->n_stages);
    ASSERT_INT(first, <=, end);
    ASSERT_INT(end, <=, sim->stage_items);
    Mpm *mpm = mpm_of(sim);
    mpm->notes_sums = true;
    /* what a step that can be looked at has not written yet is 0, so that its snapshots are the same bytes
     * whatever ran before */
    if (stage == 0 && first == 0)
        memset(mpm->block + mpm->bytes_placed, 0, mpm->bytes_whole - mpm->bytes_placed);
    const MpmTask task = {mpm->ops[stage], sim->step};
    if (first == 0)
        mpm_begin_stage(mpm, task.op, task.step);
    for (size_t item = first; item < end; item++)
        do_item(mpm, task, (int)item);
    const bool whole = end == sim->stage_items;
    if (!judge(mpm, task.op, (int)first, (int)end, status) || (whole && !mpm_end_stage(mpm, task.op, status)))
        return false;
    if (!whole || stage + 1 < mpm->sim.n_stages)
        return true;
    const MpmTask forget = {OP_FORGET, sim->step}; /* in the plane a part of the last stage */
    return (mpm->dim == 1 || do_all(mpm, &forget, 1, status)) && check_energy(mpm, status);
}

/* --- whole steps ----------------------------------------------------------------------------------- */

static void keep(Simulation *sim)
{
    Mpm *mpm = mpm_of(sim);
    memcpy(mpm->backup, mpm->block, mpm_lasting_bytes(mpm, mpm->head));
}

static void put_back(Simulation *sim)
{
    Mpm *mpm = mpm_of(sim);
    memcpy(mpm->block, mpm->backup, mpm_lasting_bytes(mpm, mpm->head));
    mpm_find_all(mpm);
}

/* A row may need the grid after map and supports, which are also the first two stages of the next step: they
 * are done once for both, and the map goes with the stages before it. */
static bool whole_steps(Simulation *sim, long count, double *rows, Status *status)
{
    Mpm *mpm = mpm_of(sim);
    const bool rates = rows && mpm_row_has_rates(mpm);
    if (count > 0)
        mpm_map_and_fix(mpm);
    for (long n = 0; n < count; n++) {
        const bool last = n + 1 == count, more = !last || (rows && mpm_row_needs_grid(mpm));
        MpmTask tasks[OP_COUNT + 2];
        int n_tasks = 0;
        mpm->notes_sums = last || rates;
        for (int stage = 2; stage < mpm->sim.n_stages; stage++)
            tasks[n_tasks++] = (MpmTask){mpm->ops[stage], sim->step};
        if (mpm->dim == 2)
            tasks[n_tasks++] = (MpmTask){OP_FORGET, sim->step};
        if (more)
            tasks[n_tasks++] = (MpmTask){OP_MAP, sim->step + 1};
        if (!do_all(mpm, tasks, n_tasks, status) || !check_energy(mpm, status))
            return false;
        sim->step++;
        if (more && !do_all(mpm, &(MpmTask){OP_FIX, sim->step}, 1, status))
            return false;
        if (rows)
            mpm_write_row(mpm, rows + n * sim->n_series, !sim->spares_rows || last);
    }
    return true;
}

bool mpm_steps(Simulation *sim, long count, double *rows, long *done, Status *status)
{
    ASSERT_INT(count, >=, 0);
    ASSERT_INT(sim->stage, ==, 0);
    static const Batches batches = {keep, put_back, whole_steps};
    return batch_steps(sim, &batches, count, rows, done, status);
}

void mpm_row(Simulation *sim, double *row)
{
    ASSERT_INT(sim->stage, ==, 0);
    Mpm *mpm = mpm_of(sim);
    if (mpm_row_needs_grid(mpm))
        mpm_map_and_fix(mpm); /* the grid is scratch between steps */
    mpm_write_row(mpm, row, true);
}

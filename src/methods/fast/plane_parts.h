/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Part of plane_do.c: whole steps in parts, each done by all threads.
 *
 * Stages that follow each other on particles are done block by block, one after the other while the block is
 * in the cache, those on nodes likewise; in between everybody waits. So a step of USF has four parts, and its
 * last is the first of the next step: strain and force | gather, supports, integrate | update and map |
 * gather, supports. */

/* Stages that are done in one go by everybody. What a chunk writes (its particles, its patch; its rows of
 * nodes) no other chunk of the part reads, so their order is free. */
typedef struct Part {
    Plane *plane;
    const PlaneTask *tasks;
    int count;
    int columns;   /* of nodes in a chunk */
    PlaneOp given; /* of nodes: the stage whose patches come first; PLANE_OPS: none */
} Part;

static void block_chunk(void *context, int block, int worker)
{
    const Part *part = context;
    do_block(part->plane, block, worker, part->tasks, part->count);
}

/* Nodes are shared out by columns, of all rows: then those around the blocks that a thread has done are in
 * its core's cache. A chunk is done some rows at a time, one stage after the other. */
static void nodes_chunk(void *context, int chunk, int worker)
{
    enum { NODES_AT_A_TIME = 1024 };
    (void)worker;
    const Part *part = context;
    Plane *plane = part->plane;
    const int column = chunk * part->columns, rows = 1 + NODES_AT_A_TIME / part->columns;
    for (int row = 0; row < plane->gy; row += rows) {
        const PlaneNodes nodes = {row, smaller(row + rows, plane->gy), column,
                                  smaller(column + part->columns, plane->gx)};
        if (part->given != PLANE_OPS)
            gather(plane, part->given, nodes);
        for (int k = 0; k < part->count; k++)
            do_nodes(plane, part->tasks[k], nodes);
    }
}

/* One thread goes along whole rows, as they lie in memory. */
static int columns_of_chunk(const Plane *plane)
{
    enum { CHUNKS_A_THREAD = 4, COLUMNS_AT_LEAST = 32 };
    const int threads = plane->def.threads;
    return threads == 1 ? plane->gx : larger(plane->gx / (CHUNKS_A_THREAD * threads) + 1, COLUMNS_AT_LEAST);
}

static void run_part(Part *part, PoolWork *work, int chunks)
{
    if (part->plane->pool)
        pool_run(part->plane->pool, work, part, chunks);
    else
        for (int chunk = 0; chunk < chunks; chunk++)
            work(part, chunk, 0);
}

bool plane_do_all(Plane *plane, const PlaneTask *tasks, int count, Status *status)
{
    ASSERT_INT(count, >=, 1);
    const int columns = columns_of_chunk(plane);
    PlaneOp given = PLANE_OPS;
    for (int end = 0; end < count;) {
        const int first = end;
        const bool nodes = of_nodes(tasks[first].op);
        while (end < count && of_nodes(tasks[end].op) == nodes)
            end++;
        Part part = {plane, tasks + first, end - first, columns, given};
        if (!nodes) {
            run_part(&part, block_chunk, plane->n_blocks);
            if (!judge(plane, part.tasks, part.count, 0, plane->n_blocks, status))
                return false;
            for (int k = first; k < end; k++)
                if (tasks[k].op == PLANE_UPDATE)
                    report_crossings(plane);
            given = gives(tasks[end - 1].op) ? tasks[end - 1].op : PLANE_OPS;
            if (given != PLANE_OPS && any_far(plane)) {
                gather_all(plane, given);
                given = PLANE_OPS;
            }
            continue;
        }
        run_part(&part, nodes_chunk, (plane->gx + part.columns - 1) / part.columns);
        for (int k = first; k < end; k++)
            if (tasks[k].op == PLANE_HOLD_FORCE)
                add_work(plane);
        given = PLANE_OPS;
    }
    return true;
}

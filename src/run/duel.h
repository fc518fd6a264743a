/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A duel: two runs from one initial state which differ in a few keys, stepped together in time.
 *
 * A is the run that keys and edits act on, B follows it. They may differ in time step, columns, numbers of
 * particles and whatever else the keys change, so only times are compared: while A stands at (or within the
 * step after) a time, B stands at its last whole step that is not beyond it. B is interpolated nowhere. A run
 * B that fails stays where it failed; A goes on.
 *
 * Where there is no B every verb acts on A alone, so that a caller need not ask. Work is done in pieces, as
 * in experiment.h. */
#ifndef RUN_DUEL_H
#define RUN_DUEL_H

#include "run/experiment.h"

enum { DUEL_NAME_MAX = 48 };

typedef struct Duel {
    Experiment *a; /* belongs to the caller */
    Experiment *b; /* NULL: there is no duel */
    Assignment keys[DUEL_MAX];
    int n_keys;
    char names[2][DUEL_NAME_MAX]; /* by the values that differ: "USF", "USL" */
    bool same_exact;              /* both have the same exact answer */
    size_t history;               /* memory for keyframes of both */
    int threads;
} Duel;

/* No duel as yet; another A takes the place of the one before, whose duel is over. */
void duel_open(Duel *, Experiment *a, size_t history, int threads);
void duel_close(Duel *);

/* Assignments "KEY=VALUE KEY=VALUE", separated by spaces. Returns how many, or -1: the status says why. */
int duel_read_keys(const char *text, Assignment keys[DUEL_MAX], Status *);

/* The other way round, for a prompt. */
void duel_write_keys(const Assignment *keys, int n_keys, char *out, size_t size);

/* What is worth a duel where nobody said. `which` 0: what the scenario asks about, at its next choice; above:
 * the other choices and sizes that there are, those of the method first. Returns how many keys; 0: there are
 * no more. */
int duel_suggest(const Settings *, int which, Assignment keys[DUEL_MAX]);

/* Begins a duel; B has A's settings but for these keys, and seeks A's time: call duel_work() until nothing is
 * pending. Both share the memory for keyframes. A duel that there is ends first. False: refused (a key is
 * wrong, nothing would differ), and all is as before. */
bool duel_start(Duel *, const Assignment *keys, int n_keys, Status *);

/* Ends it; B's curves stay behind A's as the unpinned ghost. */
void duel_end(Duel *);

/* As the verbs of experiment.h, for both. False: A failed. */
bool duel_next_stage(Duel *, Status *); /* A by stages; B stays at its whole step */
void duel_seek(Duel *, long step, int stage);

/* Whose work is next, of one that is pending; NULL: nothing is. */
Experiment *duel_turn(const Duel *);
bool duel_pending(const Duel *, long *steps_left); /* of both */
bool duel_work(Duel *, Effort, bool *whole, Status *);
void duel_drop_part(Duel *);

/* Goes on: all of so many steps, or a part of the one at hand; it is whole when B has followed. */
bool duel_advance(Duel *, Effort, bool *whole, Status *);

/* A stays where it has come to, and B comes there too; a B that A waits for is given up, with the duel. */
void duel_cancel(Duel *);

/* Begins again at t = 0. False: refused. If B alone cannot be made the duel is over; the status says why. */
bool duel_restart(Duel *, bool keep_ghost, Status *);

/* experiment_edit(), experiment_rerun() or experiment_replace(). */
typedef bool (*DuelChange)(Experiment *, const Settings *, Status *);

/* New settings for A, and for B but for its keys. What makes a new run makes two: a live parameter holds from
 * t = 0 on for both. False: refused, nothing has changed. If B alone cannot be made the duel is over and the
 * status says why. */
bool duel_change(Duel *, const Settings *, DuelChange, Status *);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The run on screen and the second one beside it: playing, pausing, going to another time. */
#ifndef LAB_PLAYER_H
#define LAB_PLAYER_H

#include "base/status.h"
#include "run/duel.h"
#include "run/playback.h"

typedef struct Laboratory Laboratory;

/* Work whose speed is known apart: a run that goes on (of a duel: both), each run on its way to a time. */
enum { RATE_RUN, RATE_FIRST, RATE_SECOND, RATES };

/* A stretch of time that a run goes through again and again. */
typedef struct Stretch {
    bool on;
    double from, to;
} Stretch;

/* A place of the run: behind so many stages of the step after `step` whole ones. */
typedef struct Place {
    long step;
    int stage;
} Place;

typedef struct Player {
    Duel duel;         /* behind screen.duel */
    Playback playback; /* behind screen.playback */
    Bookmarks bookmarks;
    bool second_ended;   /* that the second run stopped has been said */
    RunState resume;     /* after computing: running or paused */
    long work_total;     /* steps of the work under way when it began */
    long run_limit;      /* running does not go beyond this step; -1: none */
    Stop stop;           /* running does not go beyond this either, and then pauses */
    Stretch loop;        /* at its end it comes back to its beginning */
    int slow_frames;     /* of slow motion: for each stage */
    int slow_left;       /* until the next one */
    double owed;         /* steps not yet done for the pace; less than one */
    bool pace_automatic; /* + and - were not used */
    double rates[RATES]; /* steps per second of the engine alone; 0: not known */
    bool in_parts;       /* a step that takes long is under way, in parts: nothing new to look at as yet */
    double part_seconds; /* what it has taken so far */
    int frames_in_time;  /* since the engine was last the limit */
} Player;

/* The speed of the engine is not known any more: another run takes another time for a step. */
void player_forget_rates(Player *);

/* Back to where the step that is done in parts began, for a command that wants to look or do something. */
void player_drop_part(Player *);

/* So many steps a frame that one exact period lasts 3 s; where the run comes to be half a period late, that
 * it is so within ten seconds, as far as the eye can follow; a run without a period, 15 s as a whole. */
void player_choose_pace(Player *);
double player_pace_for(double steps, double seconds); /* so many steps in so many seconds; looks steady */
double player_next_125(double value, int direction);  /* the next number of 1, 2, 5, 10, ... above or below */

/* The state after a change: at the end, failed, computing, ... */
void player_settle(Laboratory *);
void player_pause(Laboratory *);
void player_seek(Laboratory *, long step, int stage);
void player_go_to(Laboratory *, long step); /* paused */

/* A run that goes on, now or later, pauses there and says so; whatever else moves it in time, the stop stays
 * until it is reached or passed. STOP_NEVER: nothing stops it. */
void player_stop_at(Laboratory *, const Stop *);

/* From one time to another, again and again while it runs; `to` beyond `from`. Off: it runs on. */
void player_loop(Laboratory *, const Stretch *);

/* How many whole steps a run that goes on may do, as far as that is known: before each piece of work. */
long player_steps_ahead(const Laboratory *);

/* The run has gone on: it pauses or jumps back where it has come to a stop or to the end of a stretch. True:
 * it does not go on in this frame. */
bool player_arrive(Laboratory *);

/* Where the steps of a key begin: the place on screen, or where the work on the way will end. */
Place player_place(const Laboratory *);

void player_tell_second(Laboratory *);                    /* says once that the second run stopped */
void player_tell_duel_over(Laboratory *, const Status *); /* says so if a change ended it, and why */

#endif

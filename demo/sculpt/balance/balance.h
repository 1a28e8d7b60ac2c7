// SPDX-License-Identifier: MIT
// The Balance workspace, seen from inside.

#ifndef SCULPT_BALANCE_BALANCE_H
#define SCULPT_BALANCE_BALANCE_H

#include "balance_desk.h"

enum { BALANCE_UNDO_MAX = 64 };

typedef struct balance {
    desk base;
    balance_state state;
    sf_mesh *given;                          // as it was opened
    sf_mesh *placed;                         // turned as the plan says
    sf_stance *stances[BALANCE_STANCES_MAX]; // of what is placed
    sf_stand *stand;                         // NULL until it is prepared
    int is_pending;                          // one round is owed
    int left_out;                            // handles that it could not be prepared with
    balance_plan undo[BALANCE_UNDO_MAX], redo[BALANCE_UNDO_MAX];
    int last_setting; // that was written to the list of undone plans; -1 none
    int is_dragging;  // the selected handle: 1 gripped, 2 moved
    unsigned mods;    // keys that were held when it was gripped
    double grip_mm[3];
} balance;

// ---------------------------------------------------------------------------------------------
// Plans (plan.c)
// ---------------------------------------------------------------------------------------------

// Remember the plan before a change. Settings that follow each other are one change; -1 is none.
void balance_remember(balance *b, int setting);

// Take another plan, or the one before, or the one after. A shape that stands is begun anew.
void balance_undo(balance *b);
void balance_redo(balance *b);

// Forget both lists.
void balance_forget(balance *b);

// ---------------------------------------------------------------------------------------------
// The shape (shape.c)
// ---------------------------------------------------------------------------------------------

// Another shape, which is the desk's from now on; it stands as it lies. 0 where it is none that can
// stand: then it stays the caller's, all is as it was, and `why` gets a sentence.
int balance_take_mesh(balance *b, sf_mesh *mesh, char why[DESK_WHY_SIZE]);

// Bring what is placed to where the plan says, and judge it. 0 where there is no memory: then it
// rests as before.
int balance_place(balance *b);

// The shape that the desk begins with: balls that lean. NULL where there is no memory.
sf_mesh *balance_first_mesh(void);

// ---------------------------------------------------------------------------------------------
// Work (work.c)
// ---------------------------------------------------------------------------------------------

// The next piece: what rounds need, or a round.
void balance_step(balance *b);

// What was computed is of another plan: begin anew.
void balance_drop(balance *b);

// Judge a centre of mass; NULL stances are passed over.
void balance_judge(balance *b, const double com_mm[3]);

// Handles by themselves, as many as are wanted. 0 where that fails; said says why.
int balance_put_handles(balance *b);

// A handle in the middle of the solid behind a ray.
int balance_put_handle(balance *b, const double eye_mm[3], const double along[3]);

// What became of a handle so far.
sf_pose balance_pose_of(const balance *b, size_t handle);

// Give a handle a pose, and lock it.
void balance_set_pose(balance *b, size_t handle, const sf_pose *pose);
void balance_lock(balance *b, size_t handle, int lock);

// The outside as it is now, and the cavity, which may be empty.
sf_mesh_view balance_outer(const balance *b);
sf_mesh_view balance_cavity(const balance *b);

// ---------------------------------------------------------------------------------------------
// The pointer (hand.c)
// ---------------------------------------------------------------------------------------------

void balance_hover(desk *d, const desk_pointer *p);
void balance_press(desk *d, const desk_pointer *p);
void balance_drag(desk *d, const desk_pointer *p);
void balance_release(desk *d);

// Where a handle is now.
void balance_handle_place(const balance *b, size_t handle, double at_mm[3]);

// ---------------------------------------------------------------------------------------------
// Showing (show.c)
// ---------------------------------------------------------------------------------------------

int balance_show(desk *d, stage *s);

#endif

// SPDX-License-Identifier: MIT
// The Balance workspace: a shape is made to stand or to hang, by carving and by bending, with its
// handles in a person's hand.

#ifndef SCULPT_BALANCE_BALANCE_DESK_H
#define SCULPT_BALANCE_BALANCE_DESK_H

#include <sf/stand.h>

#include "desk/desk.h"

enum { BALANCE_HANDLES_MAX = 16, BALANCE_STANCES_MAX = 4 };

// Settings, as numbers of EVENT_SET.
typedef enum balance_setting {
    BALANCE_TOOL = DESK_BALANCE_FIRST,
    BALANCE_GAMMA,      // degrees that the ground may tilt
    BALANCE_WALL,       // mm
    BALANCE_CARVING,    // one of balance_carving
    BALANCE_BENDS,      // whether it may bend
    BALANCE_RESOLUTION, // voxels along the longest side
    BALANCE_GLASS,      // whether the hull is seen through
    BALANCE_SELECTED,   // a handle, or -1
    BALANCE_SCALE,      // of the selected handle
    BALANCE_COUNT       // of handles that are placed by themselves
} balance_setting;

// Actions, as numbers of EVENT_DO.
typedef enum balance_action {
    BALANCE_RUN = DESK_BALANCE_FIRST, // go on by itself, or stop
    BALANCE_ROUND,                    // one round
    BALANCE_PLACE,                    // handles by themselves, in the place of all
    BALANCE_LOCK,                     // the selected handle, or let it go
    BALANCE_REMOVE,                   // the selected handle
    BALANCE_ONE_STANCE                // the first one alone
} balance_action;

// What the left button does.
typedef enum balance_tool {
    BALANCE_HANDLES, // selects and drags handles
    BALANCE_PUT,     // puts a handle into the middle of the solid behind the pointer
    BALANCE_STAND,   // stands it on the face below the pointer; with shift, on that as well
    BALANCE_HANG,    // hangs it from the point below the pointer; with shift, from that as well
    BALANCE_TOOL_COUNT
} balance_tool;

typedef enum balance_carving {
    BALANCE_SOLID,
    BALANCE_SUPPORT_FREE,
    BALANCE_PLANES
} balance_carving;

// A handle: where it is in the shape before bending, and what a person made of it.
typedef struct balance_handle {
    double at_mm[3];
    sf_pose pose; // looked at where it is locked
    int locked;
} balance_handle;

// What a person has asked for: all that can be undone.
typedef struct balance_plan {
    sf_transform turn; // from the file to where it rests
    sf_stance_options stances[BALANCE_STANCES_MAX];
    size_t stance_count;
    balance_handle handles[BALANCE_HANDLES_MAX];
    size_t handle_count;
    double gamma_deg, wall_mm;
    balance_carving carving;
    int bends;
    uint32_t resolution;
} balance_plan;

// What there is, for who shows it.
typedef struct balance_state {
    balance_plan plan;
    balance_tool tool;
    int selected, hovered; // handles, or -1
    int shows_glass;
    int is_running;
    uint32_t wanted; // handles that are placed by themselves
    double size_mm;  // longest side
    size_t triangle_count;
    int has_report; // a round was gone
    sf_stand_report report;
    double com_mm[3];
    double before_rad, margin_rad; // of the solid as it was asked about, and now
    int stands, safe;
    sf_stance_verdict verdicts[BALANCE_STANCES_MAX];
    size_t undo_count, redo_count;
} balance_state;

// A desk with a shape of its own on it; NULL where there is no memory.
desk *balance_desk_create(void);

// Its state; it stays until the desk is touched.
const balance_state *balance_desk_state(const desk *d);

#endif

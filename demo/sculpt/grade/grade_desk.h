// SPDX-License-Identifier: MIT
// The Grade workspace: a cage whose points are selected, painted and moved, with the shape that it
// makes, a cut through it, and the printed slice there.

#ifndef SCULPT_GRADE_GRADE_DESK_H
#define SCULPT_GRADE_GRADE_DESK_H

#include <sf/cage.h>
#include <sf/cage_history.h>
#include <sf/paint.h>

#include "desk/desk.h"

enum { GRADE_MATERIALS_MAX = 4 };

// Settings, as numbers of EVENT_SET.
typedef enum grade_setting {
    GRADE_TOOL = DESK_GRADE_FIRST,
    GRADE_CHANNEL,   // which property is shown and painted
    GRADE_OPERATION, // one of sf_paint_operation
    GRADE_AMOUNT,
    GRADE_RADIUS, // of the brush, mm
    GRADE_FALLOFF,
    GRADE_WHERE,     // which points a brush takes: one of sf_paint_where
    GRADE_CAGE,      // whether the cage is shown
    GRADE_CUT,       // whether it is cut
    GRADE_CUT_AXIS,  // 0, 1, 2
    GRADE_CUT_SIDE,  // whether what lies beyond the cut stays, and not what lies before it
    GRADE_CUT_SHARE, // 0 to 1 of the way along that axis
    GRADE_MATERIALS, // of the printed slice
    GRADE_RESOLUTION // voxels of it along the longest side
} grade_setting;

// Actions, as numbers of EVENT_DO.
typedef enum grade_action {
    GRADE_ALL = DESK_GRADE_FIRST, // select all points
    GRADE_NONE,                   // select none
    GRADE_APPLY,                  // the operation, to what is selected
    GRADE_SMOOTH_PLACES           // what is selected towards the middle of its neighbours
} grade_action;

// What the left button does.
typedef enum grade_tool {
    GRADE_SELECT, // a point; with shift it is added, or taken away
    GRADE_BRUSH,  // paints points around the place on the surface
    GRADE_MOVE,   // drags what is selected, or the point below the pointer
    GRADE_TOOL_COUNT
} grade_tool;

// What there is, for who shows it.
typedef struct grade_state {
    grade_tool tool;
    sf_cage_view cage;
    size_t channel;
    double low, high; // of its values, which the colours span
    sf_paint_operation operation;
    double amount;
    sf_paint_brush brush;
    int shows_cage, is_cut, cut_axis, keeps_beyond;
    double cut_share;
    double low_mm[3], high_mm[3]; // of the shape
    uint32_t materials, resolution;
    const double *selected; // 0 or 1 for each point
    size_t selected_count;
    int hovered;                          // a point, or -1
    int has_place;                        // of the brush
    double place_mm[3];                   // where
    size_t inverted_cells;                // that lie inside out
    size_t first_inverted;                // the first of them
    size_t triangles;                     // of the surface that is shown
    uint64_t counts[GRADE_MATERIALS_MAX]; // voxels of the slice, by material
    double pitch_mm;                      // of its voxels
    sf_cage_history_state history;
} grade_state;

// A desk with a cage of its own on it; NULL where there is no memory.
desk *grade_desk_create(void);

// Its state; it stays until the desk is touched.
const grade_state *grade_desk_state(const desk *d);

#endif

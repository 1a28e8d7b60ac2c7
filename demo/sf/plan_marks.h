// SPDX-License-Identifier: MIT
// Marks of a plan, in pictures and in their legends.

#ifndef DEMO_SF_PLAN_MARKS_H
#define DEMO_SF_PLAN_MARKS_H

typedef enum plan_mark {
    MARK_SHADOW,  // the shape from above
    MARK_SUPPORT, // the polygon that it stands on
    MARK_SAFE,    // where its centre of mass may lie
    MARK_STRING,  // the point that it hangs from
    MARK_BEFORE,  // its centre of mass, as it was
    MARK_AFTER,   // and as it is
    MARK_COUNT
} plan_mark;

// Colours, 0 to 1.
extern const double marks_paper[3], marks_shadow[3], marks_outline[3];
extern const double marks_support[3], marks_rim[3], marks_safe[3], marks_safe_rim[3];
extern const double marks_before[3];

// No mark goes farther than that from its middle, in units.
#define MARKS_REACH 19.0
#define MARKS_RING 8.0 // the radius of MARK_BEFORE
#define MARKS_DOT 4.0  // of MARK_AFTER

// The colour of a mark at x, y units from its middle, or NULL beside it. Areas are shown as a small
// square of them.
const double *marks_colour(plan_mark mark, double x, double y);

#endif

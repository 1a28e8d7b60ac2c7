// SPDX-License-Identifier: MIT
// A stance seen from above: its polygon, its safe region and centres of mass, in the plane.

#ifndef DEMO_SF_PLAN_VIEW_H
#define DEMO_SF_PLAN_VIEW_H

#include "stand_model.h"

// A straight border: a place is inside of it where a x + b y + c >= 0, and (a, b) has length 1.
typedef struct border {
    double a, b, c;
} border;

typedef struct plan {
    double right[3], ahead[3]; // what is x and y, in build axes
    double *corners;           // x, y of each corner of the polygon, counter-clockwise
    size_t corner_count;
    border *edges, *safes; // of the polygon; of the safe region at the height of the centre of mass
    size_t edge_count, safe_count;
    int is_never_safe;          // whether a side that runs level rules all of it out
    double before[2], after[2]; // centres of mass
} plan;

// Look at a stance of a model. Returns 0 when there is no memory; release it in any case.
int plan_make(const model *m, size_t stance, plan *made);

void plan_place(const plan *p, const double at[3], double xy[2]);

// How far inside of all borders a place lies, or minus how far outside.
double plan_depth(const border *borders, size_t count, const double at[2]);

void plan_release(plan *p);

#endif

// SPDX-License-Identifier: MIT
// A stance seen from above: what it touches, its safe region and centres of mass, in the plane.

#ifndef DEMO_SF_PLAN_VIEW_H
#define DEMO_SF_PLAN_VIEW_H

#include "stand_model.h"

// A straight border: a place is inside of it where a x + b y + c >= 0, and (a, b) has length 1.
typedef struct border {
    double a, b, c;
} border;

// A convex region; of one or two corners, it has no borders.
typedef struct region {
    double *corners; // x, y of each, counter-clockwise
    size_t corner_count;
    border *borders;
    size_t border_count;
    double low[2], high[2]; // its box; nothing is in it where there are no corners
} region;

enum { PLAN_NAME_SIZE = 40 };

typedef struct plan {
    sf_stance_kind kind;
    double right[3], ahead[3];     // what is x and y of the plan, in build axes
    char names[2][PLAN_NAME_SIZE]; // what these are of the input's axes
    region support;                // polygon of contacts; the point that it hangs from
    region safe;                   // at the height of the centre of mass
    double before[2], after[2];    // centres of mass
} plan;

// Look at a stance of a model. Returns 0 when there is no memory; release it in any case.
int plan_make(const cli_job *job, const model *m, size_t stance, plan *made);

void plan_place(const plan *p, const double at[3], double xy[2]);

// How far inside of all borders a place lies, or minus how far outside.
double plan_depth(const region *r, const double at[2]);

// Widen a box, so that a place is in it.
void plan_take_in(const double at[2], double low[2], double high[2]);

void plan_release(plan *p);

#endif

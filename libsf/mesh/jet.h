// SPDX-License-Identifier: MIT
// A winding number around a point, to second order.

#ifndef SF_MESH_JET_H
#define SF_MESH_JET_H

#include <math.h>

// value + slope . d + d . bend . d / 2 at the offset d, in turns; off by no more than
// error + rest (|d| / reach)^3 for any d within `reach`.
typedef struct sfi_jet {
    double value, slope[3];
    double bend[6]; // xx, yy, zz, xy, yz, zx
    double error, rest;
    double ball_inverse; // 1 / reach^2
} sfi_jet;

// A point as seen from the middle, with its distance from there and one over that.
typedef struct sfi_sight {
    double at[3], length, inverse;
} sfi_sight;

// Add what edges of a triangle add to slope and bend: edge i, from corner i to the next, for each
// bit i that is set. The edges of a closed loop together give those of its winding number.
void sfi_jet_add_edges(sfi_jet *jet, const sfi_sight corner[3], unsigned edges);
// Add a dipole: a vector area, seen at `to`. Value, slope and bend.
void sfi_jet_add_dipole(sfi_jet *jet, const double area[3], const double to[3]);

// What is cut off of a dipole that stays `gap` > 0 away from a ball of radius `reach`.
double sfi_jet_dipole_rest(double area, double gap, double reach);
// The same of an edge.
static inline double sfi_jet_edge_rest(double length, double gap, double reach)
{
    double inverse = 1.0 / gap, near = length * inverse, share = reach * inverse;
    const double quarter_turn = 0x1.921fb54442d18p+0, over_sphere = 0x1.45f306dc9c883p-4;
    return (near < quarter_turn ? near : quarter_turn) * share * share * share * over_sphere;
}

static inline double sfi_jet_at(const sfi_jet *jet, const double d[3])
{
    const double *b = jet->bend;
    return jet->value + d[0] * (jet->slope[0] + 0.5 * b[0] * d[0] + b[3] * d[1]) +
           d[1] * (jet->slope[1] + 0.5 * b[1] * d[1] + b[4] * d[2]) +
           d[2] * (jet->slope[2] + 0.5 * b[2] * d[2] + b[5] * d[0]);
}

static inline double sfi_jet_error(const sfi_jet *jet, const double d[3])
{
    double share = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) * jet->ball_inverse;
    return jet->error + jet->rest * share * sqrt(share);
}

// Take another point for the middle, and a ball within the one before.
void sfi_jet_move(sfi_jet *jet, const double d[3], double reach);

#endif

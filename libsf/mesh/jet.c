// SPDX-License-Identifier: MIT
// A winding number around a point, to second order, and a bound for the rest.
//
// But for whole turns, the winding number of a surface depends on its boundary only: surfaces with
// the same boundary differ by a closed one. Its slope is therefore a sum over boundary edges, the
// law of Biot and Savart, with a and b the ends of an edge as seen from the point:
//
//     4 pi slope = sum of integral dl x p / |p|^3 = sum of (b x a) s,
//     s = (|a| + |b|) / (|a||b| (|a||b| + a.b)).
//
// When the point moves by d, b x a grows by d x (b - a), and ln s by what its factors give.
//
// The rest: a component of p / |p|^3 is a derivative of 1 / |p|, whose nth derivatives along unit
// vectors are at most n! / |p|^(n+1) (n! P_n(cos) / r^(n+1) along one vector, and a symmetric form
// is largest there: S. Banach, 1938). The third derivative of an edge's share is thus at most
// 6 int dl / |p|^4 <= 6 min(L / g^4, (pi / 2) / g^3), g being the least |p|: the nearer end of a
// line seen at g from its foot gives half the second, from further along the line less. A dipole's
// third derivative is at most 24 A / g^5. A sixth of these times the ball's radius cubed is left.
//
// Source: J. D. Jackson, "Classical Electrodynamics", 3rd edition, 1998, 5.2; the bounds are ours.

#include "mesh/jet.h"

#include "mesh/vector.h"

#include <math.h>

#define PI 0x1.921fb54442d18p+1

static const int first[6] = {0, 1, 2, 0, 1, 2}, second[6] = {0, 1, 2, 1, 2, 0};

static inline void add_edge(double sum[9], const sfi_sight *a, const sfi_sight *b)
{
    double n[3], slope[3];
    sfi_cross(a->at, b->at, n);
    double dot = sfi_dot(a->at, b->at), product = a->length * b->length;
    double both = a->length + b->length;
    // Where the point looks at the edge from near by, the sum is small: n^2 over the difference.
    double near = dot < 0.0 ? sfi_dot(n, n) / (product - dot) : product + dot;
    if (!(near > 0.0)) {
        return; // within the edge: the caller's bound is infinite there
    }
    double over = 1.0 / (near * both), share = both * both * over; // (|a| + |b|) / near
    double s = share * a->inverse * b->inverse * (1.0 / (4 * PI)), even = near * over;
    double by_a = (b->length * a->inverse * even + share) * a->inverse;
    double by_b = (a->length * b->inverse * even + share) * b->inverse;
    for (int i = 0; i < 3; i++) {
        n[i] *= s;
        sum[i] += n[i];
        slope[i] = by_a * a->at[i] + by_b * b->at[i];
    }
    for (int i = 0; i < 3; i++) {
        int next = i < 2 ? i + 1 : 0;
        sum[3 + i] += n[i] * slope[i];
        sum[6 + i] += 0.5 * (n[i] * slope[next] + n[next] * slope[i]);
    }
}

void sfi_jet_add_edges(sfi_jet *jet, const sfi_sight corner[3], unsigned edges)
{
    double sum[9] = {0.0};
    for (int i = 0; i < 3; i++) {
        if (edges >> i & 1) {
            add_edge(sum, corner + i, corner + (i < 2 ? i + 1 : 0));
        }
    }
    for (int i = 0; i < 3; i++) {
        jet->slope[i] += sum[i];
        jet->bend[i] += sum[3 + i];
        jet->bend[3 + i] += sum[6 + i];
    }
}

void sfi_jet_add_dipole(sfi_jet *jet, const double area[3], const double to[3])
{
    double square = sfi_dot(to, to), third = 1.0 / (square * sqrt(square) * (4 * PI));
    double along = sfi_dot(area, to) / square;
    jet->value += along * square * third;
    for (int i = 0; i < 3; i++) {
        jet->slope[i] += third * (3 * along * to[i] - area[i]);
    }
    for (int i = 0; i < 6; i++) {
        int u = first[i], v = second[i];
        double same = u == v ? along : 0.0;
        jet->bend[i] += 3 * third *
                        (5 * along * to[u] * to[v] / square -
                         (area[u] * to[v] + area[v] * to[u]) / square - same);
    }
}

double sfi_jet_dipole_rest(double area, double gap, double reach)
{
    double share = reach / gap;
    return 4 * area / (gap * gap) * share * share * share / (4 * PI);
}

void sfi_jet_move(sfi_jet *jet, const double d[3], double reach)
{
    jet->error += jet->rest;
    jet->rest = 0.0;
    jet->ball_inverse = 1.0 / (reach * reach);
    jet->value = sfi_jet_at(jet, d);
    for (int i = 0; i < 3; i++) {
        jet->slope[i] += jet->bend[i] * d[i];
    }
    for (int i = 3; i < 6; i++) {
        jet->slope[first[i]] += jet->bend[i] * d[second[i]];
        jet->slope[second[i]] += jet->bend[i] * d[first[i]];
    }
}

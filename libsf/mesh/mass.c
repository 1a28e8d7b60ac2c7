// SPDX-License-Identifier: MIT
// Volume, centre of mass and inertia of the solid that a closed mesh bounds, density 1.
//
// By the divergence theorem each integral over the solid is a sum over triangles of integrals over
// the tetrahedra that they span with a reference point. For a tetrahedron (0, a, b, c) with
// V6 = a . (b x c), six times its signed volume, and s = a + b + c:
//
//     volume            V6 / 6
//     integral of x_i   V6 / 24  s_i
//     integral of x_i x_j   V6 / 120 (s_i s_j + a_i a_j + b_i b_j + c_i c_j)
//
// which sum to the corrected formulas of Prevost, Whiting, Lefebvre, Sorkine-Hornung, "Make It
// Stand", 2013, equation 3 (as printed its mass is three times too large) and to Eberly,
// "Polyhedral Mass Properties (Revisited)", 2002. The reference point is the middle of the bounding
// box: far from the origin the terms would cancel otherwise. Sums are compensated (Neumaier, 1974),
// in the order of the triangles, so that they are the same bytes everywhere. Inertia moves to the
// centre of mass by the parallel axis theorem.

#include <sf/mesh.h>

#include "base/status.h"

#include <math.h>
#include <string.h>

typedef struct sum {
    double value, error;
} sum;

static void add(sum *s, double term)
{
    double total = s->value + term;
    if (fabs(s->value) >= fabs(term)) {
        s->error += (s->value - total) + term;
    } else {
        s->error += (term - total) + s->value;
    }
    s->value = total;
}

static double total(const sum *s)
{
    return s->value + s->error;
}

// Volume, area, first and second moments about the reference point; seconds as xx yy zz xy xz yz.
typedef struct sums {
    sum volume, area, first[3], second[6];
} sums;

static const int pair_of[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

static void cross(const double u[3], const double v[3], double w[3])
{
    w[0] = u[1] * v[2] - u[2] * v[1];
    w[1] = u[2] * v[0] - u[0] * v[2];
    w[2] = u[0] * v[1] - u[1] * v[0];
}

static void add_triangle(sums *to, const double a[3], const double b[3], const double c[3])
{
    double u[3], v[3], n[3], bc[3], s[3];
    for (int i = 0; i < 3; i++) {
        u[i] = b[i] - a[i];
        v[i] = c[i] - a[i];
        s[i] = a[i] + b[i] + c[i];
    }
    cross(u, v, n);
    cross(b, c, bc);
    double six = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
    add(&to->area, 0.5 * sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]));
    add(&to->volume, six / 6.0);
    for (int i = 0; i < 3; i++) {
        add(&to->first[i], six / 24.0 * s[i]);
    }
    for (int k = 0; k < 6; k++) {
        int i = pair_of[k][0], j = pair_of[k][1];
        add(&to->second[k], six / 120.0 * (s[i] * s[j] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j]));
    }
}

static void corner(sf_mesh_view mesh, size_t index, const double middle[3], double p[3])
{
    const double *v = mesh.vertices + 3 * (size_t)mesh.triangles[index];
    for (int i = 0; i < 3; i++) {
        p[i] = v[i] - middle[i];
    }
}

sf_status sf_mesh_measure(sf_mesh_view mesh, sf_mass *mass)
{
    double low[3], high[3], middle[3];
    if (mass == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_mesh_bounds(mesh, low, high));
    for (int i = 0; i < 3; i++) {
        middle[i] = low[i] + 0.5 * (high[i] - low[i]);
    }
    sums all;
    memset(&all, 0, sizeof all);
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        double a[3], b[3], c[3];
        corner(mesh, 3 * t, middle, a);
        corner(mesh, 3 * t + 1, middle, b);
        corner(mesh, 3 * t + 2, middle, c);
        add_triangle(&all, a, b, c);
    }
    sf_mass result;
    double volume = total(&all.volume), shift[3], second[6];
    result.volume_mm3 = volume;
    result.area_mm2 = total(&all.area);
    for (int i = 0; i < 3; i++) {
        shift[i] = volume != 0.0 ? total(&all.first[i]) / volume : 0.0;
        result.com_mm[i] = middle[i] + shift[i];
    }
    for (int k = 0; k < 6; k++) {
        second[k] = total(&all.second[k]) - volume * shift[pair_of[k][0]] * shift[pair_of[k][1]];
    }
    result.inertia_mm5[0] = second[1] + second[2];
    result.inertia_mm5[1] = second[0] + second[2];
    result.inertia_mm5[2] = second[0] + second[1];
    for (int k = 3; k < 6; k++) {
        result.inertia_mm5[k] = -second[k];
    }
    *mass = result;
    return SF_OK;
}

// SPDX-License-Identifier: MIT
// How mass and centre of mass change when vertices move.
//
// A closed mesh is the sum of the tetrahedra between the origin and its triangles. With
// D = a . (b x c) and s = a + b + c of the triangle (a, b, c)
//
//     m   = sum D / 6                d m   / d a = (b x c) / 6
//     M_d = sum D s_d / 24           d M_d / d a = ((b x c) s_d + D e_d) / 24
//
// and cyclically for b and c. The paper differentiates surface integrals instead, which give the
// same on closed meshes; its printed derivative of g lacks a term, diag(s + v_p) being right.
// Single terms are as large as the mesh is far from the origin, so they are taken about the middle
// of the mesh, and the moments moved: M = M' + middle m. Two sums are known: that over all vertices
// of d m is 0, and that of d M is m times the identity, because moving the whole changes no mass.
//
// Source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing Shapes
// for 3D Fabrication", SIGGRAPH 2013, appendix, corrected.

#include "balance/bend/gradient.h"

#include "base/status.h"
#include "mesh/vector.h"

#include <sf/bend.h>

#include <math.h>
#include <string.h>

// What the triangle (a, b, c) contributes at its corner a, up to the factors 1/6 and 1/24.
typedef struct contribution {
    double face[3]; // b x c
    double det;     // a . (b x c)
    double sum[3];  // a + b + c
} contribution;

static void contribute(const double *a, const double *b, const double *c, const double middle[3],
                       contribution *made)
{
    double p[3], q[3], r[3];
    sfi_subtract(a, middle, p);
    sfi_subtract(b, middle, q);
    sfi_subtract(c, middle, r);
    sfi_cross(q, r, made->face);
    made->det = sfi_dot(p, made->face);
    for (int d = 0; d < 3; d++) {
        made->sum[d] = p[d] + q[d] + r[d];
    }
}

void sfi_vertex_gradient(const double *vertices, const uint32_t *triangles,
                         const sfi_incidence *incidence, size_t v, const double middle[3],
                         double gradient[12])
{
    double face[3] = {0, 0, 0}, mixed[9] = {0}, det = 0;
    for (size_t i = incidence->start[v]; i < incidence->start[v + 1]; i++) {
        uint32_t next, last;
        contribution t;
        sfi_incidence_others(triangles, incidence->corner[i], &next, &last);
        contribute(vertices + 3 * v, vertices + 3 * (size_t)next, vertices + 3 * (size_t)last,
                   middle, &t);
        for (int d = 0; d < 3; d++) {
            face[d] += t.face[d];
            for (int e = 0; e < 3; e++) {
                mixed[3 * d + e] += t.sum[d] * t.face[e];
            }
        }
        det += t.det;
    }
    for (int d = 0; d < 3; d++) {
        gradient[d] = face[d] / 6;
        for (int e = 0; e < 3; e++) {
            gradient[3 + 3 * d + e] = (mixed[3 * d + e] + (d == e ? det : 0)) / 24;
        }
    }
}

// Adds what a triangle contributes at its corner `a`, moments about the origin.
static void scatter(const double *a, const double *b, const double *c, const double middle[3],
                    double density, double *gradient)
{
    contribution t;
    contribute(a, b, c, middle, &t);
    for (int e = 0; e < 3; e++) {
        double mass = density * t.face[e] / 6;
        gradient[e] += mass;
        for (int d = 0; d < 3; d++) {
            double moment = density * (t.sum[d] * t.face[e] + (d == e ? t.det : 0)) / 24;
            gradient[3 + 3 * d + e] += moment + middle[d] * mass;
        }
    }
}

sf_status sf_mesh_body_gradient(sf_mesh_view mesh, double density, double *gradient)
{
    double low[3], high[3], middle[3];
    if (gradient == NULL || !isfinite(density)) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_mesh_bounds(mesh, low, high));
    for (int i = 0; i < 3; i++) {
        middle[i] = low[i] + 0.5 * (high[i] - low[i]);
    }
    memset(gradient, 0, mesh.vertex_count * 12 * sizeof *gradient);
    for (size_t c = 0; c < 3 * mesh.triangle_count; c++) {
        size_t t = c - c % 3;
        size_t here = mesh.triangles[c], next = mesh.triangles[t + (c + 1 - t) % 3],
               last = mesh.triangles[t + (c + 2 - t) % 3];
        scatter(mesh.vertices + 3 * here, mesh.vertices + 3 * next, mesh.vertices + 3 * last,
                middle, density, gradient + 12 * here);
    }
    return SF_OK;
}

sf_status sf_body_com_gradient(sf_body body, const double *gradient, size_t count,
                               double *com_gradient)
{
    double com[3];
    if ((count > 0 && (gradient == NULL || com_gradient == NULL)) ||
        sf_body_com(body, com) != SF_OK) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < count; i++) {
        const double *from = gradient + 12 * i;
        for (int d = 0; d < 3; d++) {
            for (int e = 0; e < 3; e++) {
                com_gradient[9 * i + (size_t)(3 * d + e)] =
                    (from[3 + 3 * d + e] - com[d] * from[e]) / body.mass;
            }
        }
    }
    return SF_OK;
}

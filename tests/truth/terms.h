// SPDX-License-Identifier: MIT
// One shape made to stand five ways: carved and bent with all terms, and with carving, the
// Laplacian term or both left out, as in figure 14 of "Make It Stand"; and carved alone. What is
// said of the results comes from the vertices before and after, and knows nothing of handles or
// energies.

#ifndef TESTS_TRUTH_TERMS_H
#define TESTS_TRUTH_TERMS_H

#include "standing.h"

enum { TERMS_ALONE, TERMS_ALL, TERMS_NO_CARVING, TERMS_NO_LAPLACIAN, TERMS_NEITHER, TERMS_WAYS };

static const char *const terms_names[TERMS_WAYS] = {"carving alone", "all terms", "no carving",
                                                    "no Laplacian", "neither"};

// What bending costs, and who looks for the least.
typedef struct terms_costs {
    const char *name;
    sf_stand_solver solver;
    double shifts, scales; // of moved matter and of changed sizes; the paper has neither
} terms_costs;

// How a surface was changed, over its area. Each triangle is a linear map of its plane with two
// stretches: their ratio says what shape was lost, and their product how much larger it is. Both
// are 0 for what is only turned and shifted, and scaling changes the second alone.
typedef struct terms_change {
    double shape;  // root mean square of the logarithm of the ratio
    double size;   // root mean square of the logarithm of the mean stretch
    double growth; // mean of the same
} terms_change;

typedef struct terms_result {
    sf_stand *stand;
    sf_stand_report report;
    double margin_deg;         // from the meshes
    terms_change all, low, up; // of the whole surface, its lower third, and the rest
} terms_result;

static inline void terms_edge(sf_mesh_view mesh, size_t triangle, size_t corner, double edge[3])
{
    const uint32_t *t = mesh.triangles + 3 * triangle;
    for (size_t d = 0; d < 3; d++) {
        edge[d] = mesh.vertices[3 * (size_t)t[corner] + d] - mesh.vertices[3 * (size_t)t[0] + d];
    }
}

// Products of two edges: of the first, of both, of the second.
static inline void terms_products(sf_mesh_view mesh, size_t triangle, double g[3])
{
    double a[3], b[3];
    terms_edge(mesh, triangle, 1, a);
    terms_edge(mesh, triangle, 2, b);
    g[0] = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    g[1] = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    g[2] = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
}

// Squares of the stretches are the eigenvalues of G^-1 H, G and H the products before and after.
static inline void terms_add(const double g[3], const double h[3], terms_change *sum, double *area)
{
    double det = g[0] * g[2] - g[1] * g[1];
    double product = (h[0] * h[2] - h[1] * h[1]) / det;
    double half = 0.5 * (g[2] * h[0] - 2 * g[1] * h[1] + g[0] * h[2]) / det;
    double larger = half + sqrt(fmax(0, half * half - product));
    double shape = 0.5 * log(larger * larger / product), size = 0.25 * log(product);
    double weight = 0.5 * sqrt(det);
    sum->shape += weight * shape * shape;
    sum->size += weight * size * size;
    sum->growth += weight * size;
    *area += weight;
}

// Of the triangles that begin between two heights.
static inline terms_change terms_compare(sf_mesh_view was, sf_mesh_view is, double low, double high)
{
    terms_change sum = {0, 0, 0};
    double area = 0;
    for (size_t t = 0; t < was.triangle_count; t++) {
        double z = was.vertices[3 * (size_t)was.triangles[3 * t] + 2], g[3], h[3];
        terms_products(was, t, g);
        terms_products(is, t, h);
        // What has no area to begin with says nothing.
        int flat = g[0] * g[2] - g[1] * g[1] <= 1e-12 * g[0] * g[2];
        if (z >= low && z < high && !flat) {
            terms_add(g, h, &sum, &area);
        }
    }
    sum.shape = sqrt(sum.shape / area);
    sum.size = sqrt(sum.size / area);
    sum.growth /= area;
    return sum;
}

// The caller destroys what it stands as.
static inline terms_result terms_run(const standing_model *m, const sf_stance_options *stance,
                                     const sf_handle *handles, size_t count,
                                     const terms_costs *costs, int way)
{
    terms_result r;
    sf_stand_options o = standing_options(m, SF_CARVE_PLANE);
    sf_mesh_view was = sf_mesh_get_view(m->mesh);
    o.carve = way != TERMS_NO_CARVING && way != TERMS_NEITHER;
    o.deform = way != TERMS_ALONE;
    o.solver = costs->solver;
    o.weight_details = way != TERMS_NO_LAPLACIAN && way != TERMS_NEITHER;
    o.weight_shifts = costs->shifts;
    o.weight_scales = costs->scales;
    r.stand = standing_create(m, stance, 1, handles, count, &o);
    standing_run(r.stand);
    r.report = sf_stand_describe(r.stand);
    r.margin_deg = standing_margin(r.stand, stance) / STANDING_DEGREE;
    sf_mesh_view is = sf_stand_outer(r.stand);
    double third = m->low[2] + m->size / 3;
    r.all = terms_compare(was, is, -INFINITY, INFINITY);
    r.low = terms_compare(was, is, -INFINITY, third);
    r.up = terms_compare(was, is, third, INFINITY);
    return r;
}

#endif

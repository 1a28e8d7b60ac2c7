// SPDX-License-Identifier: MIT
// What each half of a mesh that was cut has to be, for the tests of cutting: edges are counted one
// by one, and volumes are added.

#ifndef SF_TEST_HALVES_H
#define SF_TEST_HALVES_H

#include "solids.h"

typedef struct halves {
    sf_mesh *mesh[2];
    sf_mesh_view view[2];
} halves;

static inline int compare(const void *a, const void *b)
{
    return memcmp(a, b, 4 * sizeof(uint32_t));
}

// Edges that are not run once each way, by sorting all of them.
static inline size_t unpaired_edges(sf_mesh_view m)
{
    size_t count = 3 * m.triangle_count, wrong = 0;
    uint32_t(*edges)[4] = malloc((count + 1) * sizeof *edges);
    for (size_t i = 0; i < count; i++) {
        uint32_t a = m.triangles[i], b = m.triangles[i - i % 3 + (i + 1) % 3];
        const uint32_t edge[4] = {a < b ? a : b, a < b ? b : a, a < b, 0};
        memcpy(edges[i], edge, sizeof edge);
    }
    qsort(edges, count, sizeof *edges, compare);
    for (size_t i = 0; i < count; i += 2) {
        wrong += i + 1 == count || edges[i][0] != edges[i + 1][0] ||
                 edges[i][1] != edges[i + 1][1] || edges[i][2] == edges[i + 1][2];
    }
    free(edges);
    return wrong;
}

static inline double volume(sf_mesh_view m)
{
    sf_mass mass = {0, 0, {0, 0, 0}, {0, 0, 0, 0, 0, 0}};
    CHECK_EQ(sf_mesh_measure(m, &mass), SF_OK);
    return mass.volume_mm3;
}

// The area of what lies in the plane, as seen from outside the half, and how much of it is seen
// from inside.
static inline double cap_area(sf_mesh_view m, int axis, double at, int is_high, double *turned)
{
    double area = 0;
    int x = (axis + 1) % 3, y = (axis + 2) % 3;
    *turned = 0;
    for (size_t t = 0; t < m.triangle_count; t++) {
        const double *p[3];
        int in = 0;
        for (int i = 0; i < 3; i++) {
            p[i] = m.vertices + 3 * (size_t)m.triangles[3 * t + (size_t)i];
            in += p[i][axis] == at;
        }
        if (in == 3) {
            double twice = (p[1][x] - p[0][x]) * (p[2][y] - p[0][y]) -
                           (p[1][y] - p[0][y]) * (p[2][x] - p[0][x]);
            area += (is_high ? -0.5 : 0.5) * twice;
            *turned += (is_high ? twice : -twice) > 0 ? fabs(0.5 * twice) : 0;
        }
    }
    return area;
}

static inline void check_half(sf_mesh_view m, int axis, double at, int is_high)
{
    CHECK(m.triangle_count > 0);
    CHECK_EQ(sf_mesh_validate(m, NULL), SF_OK);
    CHECK_EQ(unpaired_edges(m), 0);
    size_t beyond = 0;
    for (size_t v = 0; v < m.vertex_count; v++) {
        double z = m.vertices[3 * v + (size_t)axis];
        beyond += is_high ? z < at : z > at;
    }
    CHECK_EQ(beyond, 0);
}

static inline halves cut_view(sf_mesh_view m, int axis, double at)
{
    halves h;
    memset(&h, 0, sizeof h);
    CHECK_EQ(sf_mesh_cut(m, axis, at, NULL, &h.mesh[0], &h.mesh[1], NULL), SF_OK);
    double sum = 0, whole = volume(m);
    for (int i = 0; i < 2 && h.mesh[i] != NULL; i++) {
        h.view[i] = sf_mesh_get_view(h.mesh[i]);
        check_half(h.view[i], axis, at, i);
        sum += volume(h.view[i]);
    }
    CHECK_NEAR(sum, whole, 1e-12 * fabs(whole));
    return h;
}

static inline void end(halves *h)
{
    sf_mesh_destroy(h->mesh[0]);
    sf_mesh_destroy(h->mesh[1]);
}

#endif

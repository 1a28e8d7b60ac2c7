// SPDX-License-Identifier: MIT
// Smoothing the surface of voxels.
//
// A pass is a step towards the middle of the neighbours and a slightly longer one back, which takes
// away steps but not volume (G. Taubin, "A Signal Processing Approach to Fair Surface Design",
// SIGGRAPH 1995, section 2.2). Vertices are held within half a voxel of their place on the lattice,
// so that thin parts cannot vanish (S. F. F. Gibson, "Constrained Elastic Surface Nets", MICCAI
// 1998). Connections do not change: what was closed stays closed. All vertices move at once from
// the positions before, so the order of the triangles has no say.

#include "mesh/smooth.h"

#include "base/memory.h"

#include <string.h>

#define LEASH_VX 0.49
#define STEP_IN 0.5 // Taubin's lambda and mu: what varies over fewer than about 18 vertices goes
#define STEP_OUT (-0.53)

// Sum of the neighbours' positions and their number, each neighbour once a triangle that joins it.
static void sum_neighbours(const double *vertices, const uint32_t *triangles, size_t triangle_count,
                           double *sums, uint32_t *counts)
{
    for (size_t i = 0; i < 3 * triangle_count; i++) {
        size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const double *to = vertices + 3 * (size_t)triangles[next];
        double *sum = sums + 3 * (size_t)triangles[i];
        for (int axis = 0; axis < 3; axis++) {
            sum[axis] += to[axis];
        }
        counts[triangles[i]]++;
    }
}

static double hold(double to, double home, double leash)
{
    return to < home - leash ? home - leash : to > home + leash ? home + leash : to;
}

// One step of all vertices; sums and counts are scratch.
static void step(double *vertices, size_t vertex_count, const uint32_t *triangles,
                 size_t triangle_count, const double *homes, const double leash_mm[3],
                 double factor, double *sums, uint32_t *counts)
{
    memset(sums, 0, vertex_count * 3 * sizeof *sums);
    memset(counts, 0, vertex_count * sizeof *counts);
    sum_neighbours(vertices, triangles, triangle_count, sums, counts);
    for (size_t v = 0; v < vertex_count; v++) {
        for (size_t axis = 0; axis < 3 && counts[v] > 0; axis++) {
            size_t i = 3 * v + axis;
            double to = vertices[i] + factor * (sums[i] / counts[v] - vertices[i]);
            vertices[i] = hold(to, homes[i], leash_mm[axis]);
        }
    }
}

static double lowest_layer(const sf_lattice *lattice)
{
    double lowest = sf_lattice_layer_height(lattice, 0);
    for (uint32_t k = 1; lattice->heights_mm != NULL && k < lattice->nz; k++) {
        double height = sf_lattice_layer_height(lattice, k);
        lowest = height < lowest ? height : lowest;
    }
    return lowest;
}

// The scratch of a call.
typedef struct scratch {
    double *homes, *sums;
    uint32_t *counts;
} scratch;

static sf_status make_passes(double *vertices, size_t vertex_count, const uint32_t *triangles,
                             size_t triangle_count, const double leash_mm[3],
                             const sfi_smoothing *how, const scratch *s)
{
    uint64_t done = how->before;
    for (int pass = 0; pass < how->passes; pass++) {
        if (sf_task_is_cancelled(how->progress->task)) {
            return SF_ERR_CANCELLED;
        }
        step(vertices, vertex_count, triangles, triangle_count, s->homes, leash_mm, STEP_IN,
             s->sums, s->counts);
        step(vertices, vertex_count, triangles, triangle_count, s->homes, leash_mm, STEP_OUT,
             s->sums, s->counts);
        done += how->piece;
        sfi_progress_report(how->progress, done, how->total);
    }
    return SF_OK;
}

sf_status sfi_mesh_smooth(double *vertices, size_t vertex_count, const uint32_t *triangles,
                          size_t triangle_count, const sf_lattice *lattice,
                          const sfi_smoothing *how, const sf_allocator *allocator)
{
    const double leash_mm[3] = {LEASH_VX * lattice->pitch_x_mm, LEASH_VX * lattice->pitch_y_mm,
                                LEASH_VX * lowest_layer(lattice)};
    size_t size = 3 * sizeof(double);
    if (vertex_count == 0) {
        return SF_OK;
    }
    scratch s;
    s.homes = sfi_alloc_array(allocator, vertex_count, size);
    s.sums = sfi_alloc_array(allocator, vertex_count, size);
    s.counts = sfi_alloc_array(allocator, vertex_count, sizeof *s.counts);
    sf_status status = SF_ERR_MEMORY;
    if (s.homes != NULL && s.sums != NULL && s.counts != NULL) {
        memcpy(s.homes, vertices, vertex_count * size);
        status = make_passes(vertices, vertex_count, triangles, triangle_count, leash_mm, how, &s);
    }
    sfi_free_array(allocator, s.homes, vertex_count, size);
    sfi_free_array(allocator, s.sums, vertex_count, size);
    sfi_free_array(allocator, s.counts, vertex_count, sizeof *s.counts);
    return status;
}

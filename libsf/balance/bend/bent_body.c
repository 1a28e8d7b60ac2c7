// SPDX-License-Identifier: MIT
// Mass and first moments of a bent mesh, and how they change with what bends it.
//
// A vertex is v = sum phi_b y_b, so that d f / d y_b = sum over the vertices of phi_b d f / d v:
// one gather around each vertex, twelve products a function, and never a matrix of vertices times
// handles. The values come along for nothing: about a fixed middle the mass is homogeneous of
// degree 3 in the vertices and the moments of degree 4, so that by Euler m = sum v . d m / d v / 3
// and M = sum v . d M / d v / 4.
//
// Vertices are shared out in a fixed number of stretches with sums of their own, which are added in
// their order: the same bytes for any number of threads.

#include "balance/bend/bent_body.h"

#include "balance/bend/gradient.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/task.h"
#include "mesh/vector.h"

#include <string.h>

enum { STRETCHES = 16 };

typedef struct work {
    const double *bent;
    const uint32_t *triangles;
    const sfi_incidence *incidence;
    const sf_blend *basis;
    const double *middle;
    double *sums;      // of each stretch: 4 values, 12 numbers a function, phi
    size_t sums_count; // of one stretch
} work;

static void run_stretch(void *context, size_t index)
{
    work *w = context;
    size_t count = w->basis->point_count, functions = sfi_basis_size(w->basis);
    double *values = w->sums + index * w->sums_count, *gradient = values + 4,
           *phi = gradient + 12 * functions;
    memset(values, 0, w->sums_count * sizeof *values);
    for (size_t v = count / STRETCHES * index + count % STRETCHES * index / STRETCHES,
                end = count / STRETCHES * (index + 1) + count % STRETCHES * (index + 1) / STRETCHES;
         v < end; v++) {
        double g[12], p[3];
        sfi_vertex_gradient(w->bent, w->triangles, w->incidence, v, w->middle, g);
        sfi_subtract(w->bent + 3 * v, w->middle, p);
        for (int f = 0; f < 4; f++) {
            values[f] += sfi_dot(p, g + 3 * f);
        }
        sfi_basis_at(w->basis, v, phi);
        for (size_t b = 0; b < functions; b++) {
            for (size_t k = 0; k < 12; k++) {
                gradient[12 * b + k] += phi[b] * g[k];
            }
        }
    }
}

// All stretches together, and moments about the origin.
static void gather(const work *w, sf_body *body, double *gradient)
{
    size_t numbers = 12 * sfi_basis_size(w->basis);
    double *first = w->sums;
    for (size_t s = 1; s < STRETCHES; s++) {
        for (size_t i = 0; i < 4 + numbers; i++) {
            first[i] += w->sums[s * w->sums_count + i];
        }
    }
    body->mass = first[0] / 3;
    for (size_t d = 0; d < 3; d++) {
        body->moment[d] = first[1 + d] / 4 + w->middle[d] * body->mass;
    }
    for (size_t i = 0; i < numbers; i++) {
        size_t f = i % 12 / 3;
        double mass = first[4 + i - 3 * f];
        gradient[i] = first[4 + i] + (f == 0 ? 0 : w->middle[f - 1] * mass);
    }
}

sf_status sfi_bent_body(const double *bent, const uint32_t *triangles,
                        const sfi_incidence *incidence, const sf_blend *basis,
                        const double middle[3], const sf_allocator *allocator, sf_task *task,
                        sf_body *body, double *gradient)
{
    work w = {bent, triangles, incidence, basis, middle, NULL, 0};
    size_t all;
    if (!sfi_size_mul(sfi_basis_size(basis), 13, &w.sums_count) ||
        !sfi_size_add(w.sums_count, 4, &w.sums_count) ||
        !sfi_size_mul(w.sums_count, STRETCHES, &all)) {
        return SF_ERR_MEMORY;
    }
    w.sums = sfi_alloc_array(allocator, all, sizeof *w.sums);
    if (w.sums == NULL) {
        return SF_ERR_MEMORY;
    }
    sfi_task_for(task, STRETCHES, run_stretch, &w);
    gather(&w, body, gradient);
    sfi_free_array(allocator, w.sums, all, sizeof *w.sums);
    return SF_OK;
}

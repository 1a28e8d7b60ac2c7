// SPDX-License-Identifier: MIT
// A lump with random weights of three handles, bent by any coefficients.

#ifndef SF_TEST_BALANCE_BENT_H
#define SF_TEST_BALANCE_BENT_H

#include "balance/bend/basis.h"
#include "balance/bend/incidence.h"
#include "base/memory.h"
#include "lump.h"

enum { HANDLES = 3, SIZE = 12 * HANDLES };

typedef struct scene {
    sf_mesh *mesh;
    sf_mesh_view view;
    double *weights, centres[3 * HANDLES];
    sfi_incidence incidence;
    sf_blend basis;
    sf_allocator allocator;
} scene;

static inline void begin(scene *s)
{
    s->allocator = sfi_allocator_or_default(NULL);
    s->mesh = lump(0);
    s->view = sf_mesh_get_view(s->mesh);
    s->weights = malloc(s->view.vertex_count * HANDLES * sizeof *s->weights);
    for (size_t v = 0; v < s->view.vertex_count; v++) {
        double *w = s->weights + HANDLES * v;
        w[0] = 0.5 * test_random_unit();
        w[1] = 0.5 * test_random_unit();
        w[2] = 1 - w[0] - w[1];
    }
    for (int i = 0; i < 3 * HANDLES; i++) {
        s->centres[i] = 5 * test_random_unit();
    }
    CHECK_EQ(sfi_incidence_make(s->view, &s->allocator, &s->incidence), SF_OK);
    sf_blend basis = {s->view.vertices, s->weights, s->view.vertex_count, s->centres, HANDLES};
    s->basis = basis;
}

static inline void end(scene *s)
{
    sfi_incidence_free(&s->allocator, &s->incidence);
    free(s->weights);
    sf_mesh_destroy(s->mesh);
}

// The coordinates of everything that was bent.
static inline double *bend(const scene *s, const double *y)
{
    double *bent = calloc(3 * s->view.vertex_count, sizeof *bent), phi[4 * HANDLES];
    for (size_t v = 0; v < s->view.vertex_count; v++) {
        sfi_basis_at(&s->basis, v, phi);
        for (size_t i = 0; i < SIZE; i++) {
            bent[3 * v + i % 3] += phi[i / 3] * y[i];
        }
    }
    return bent;
}

#endif

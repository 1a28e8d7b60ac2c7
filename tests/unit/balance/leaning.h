// SPDX-License-Identifier: MIT
// A tower of voxels that leans so far that it falls, and three handles to set it upright: its foot,
// which is held, its middle and its top, with weights that are tents along the height.

#ifndef SF_TEST_BALANCE_LEANING_H
#define SF_TEST_BALANCE_LEANING_H

#include "balance/bend/posture.h"
#include "base/memory.h"
#include "law/stack.h"

enum { TOWER = 24, FOOT = 6, HANDLES = 3, PARAMETERS = SFI_POSE_SIZE * HANDLES };

typedef struct tower {
    sf_grid *grid;
    sf_mesh *mesh;
    sf_mesh_view view;
    double *weights, centres[3 * HANDLES];
    uint32_t *held;
    sf_halfspace safe[4];
    sfi_incidence incidence;
    sfi_energy energy;
    sfi_skin skin;
    sfi_standing ground;
    sfi_posture posture;
    uint8_t free[PARAMETERS];
    sf_allocator allocator;
} tower;

static inline double tent(double z, double at)
{
    return fmax(0, 1 - fabs(z - at) / (TOWER / 2.0));
}

// The four edges of the foot, each leaning inwards by the tangent of what must be survived.
static inline void stand_on_foot(tower *t, double tangent)
{
    for (int e = 0; e < 4; e++) {
        double length = sqrt(1 + tangent * tangent), in = e % 2 == 0 ? 1 : -1;
        sf_halfspace *h = &t->safe[e];
        memset(h, 0, sizeof *h);
        h->normal[e / 2] = in / length;
        h->normal[2] = -tangent / length;
        h->offset_mm = (e % 2 == 0 ? 0 : -FOOT) / length;
    }
}

static inline void tower_begin(tower *t, double lean)
{
    sf_lattice lattice = {FOOT + TOWER, FOOT, TOWER, 1, 1, 1, NULL, {0, 0, 0}};
    memset(t, 0, sizeof *t);
    t->allocator = sfi_allocator_or_default(NULL);
    CHECK_EQ(sf_grid_create(&lattice, NULL, &t->grid), SF_OK);
    for (uint32_t k = 0; k < TOWER; k++) {
        uint32_t x = (uint32_t)(lean * k);
        sf_rect rect = {x, 0, x + FOOT, FOOT};
        CHECK_EQ(sf_slice_fill(sf_grid_slice(t->grid, k), rect, 1), SF_OK);
    }
    CHECK_EQ(sf_grid_surface(t->grid, NULL, NULL, NULL, &t->mesh), SF_OK);
    t->view = sf_mesh_get_view(t->mesh);
    t->weights = malloc(t->view.vertex_count * HANDLES * sizeof *t->weights);
    t->held = calloc(t->view.vertex_count, sizeof *t->held);
    for (size_t v = 0; v < t->view.vertex_count; v++) {
        double z = t->view.vertices[3 * v + 2];
        for (int j = 0; j < HANDLES; j++) {
            t->weights[HANDLES * v + (size_t)j] = tent(z, j * TOWER / 2.0);
        }
        t->held[v] = z < 0.5;
    }
    for (int j = 0; j < HANDLES; j++) {
        double z = j * TOWER / 2.0;
        t->centres[3 * j] = lean * z + FOOT / 2.0;
        t->centres[3 * j + 1] = FOOT / 2.0;
        t->centres[3 * j + 2] = z;
    }
    stand_on_foot(t, 0.1);
    CHECK_EQ(sfi_incidence_make(t->view, &t->allocator, &t->incidence), SF_OK);
    sf_blend basis = {t->view.vertices, t->weights, t->view.vertex_count, t->centres, HANDLES};
    const double weights[3] = {1, 0.3, 0.05};
    CHECK_EQ(sfi_energy_make(t->view, &t->incidence, &basis, TOWER, weights, &t->allocator, NULL,
                             &t->energy),
             SF_OK);
    sfi_skin skin = {basis, t->view.triangles, &t->incidence};
    sfi_standing ground = {{0, 0, 1}, 0, 0, 4};
    t->skin = skin;
    t->ground = ground;
    sfi_posture posture = {.energy = &t->energy,
                           .skins = &t->skin,
                           .skin_count = 1,
                           .safe = t->safe,
                           .safe_count = 4,
                           .standings = &t->ground,
                           .standing_count = 1,
                           .held = t->held,
                           .clearance_mm = 0.5,
                           .size_mm = TOWER};
    t->posture = posture;
    for (int p = SFI_POSE_SIZE; p < PARAMETERS; p++) {
        t->free[p] = p % SFI_POSE_SIZE < SFI_POSE_TURN;
    }
}

static inline void tower_end(tower *t)
{
    sfi_energy_free(&t->energy);
    sfi_incidence_free(&t->allocator, &t->incidence);
    free(t->weights);
    free(t->held);
    sf_mesh_destroy(t->mesh);
    sf_grid_destroy(t->grid);
}

#endif

// SPDX-License-Identifier: MIT
// How well a shape could stand by carving alone: a margin that nothing carved out of it can pass.
//
// Whoever is told that a shape cannot stand wants to know whether that is the program's fault. Let
// voxels be carved by any fraction, and let nothing need support: what is best then is found
// exactly (balance/forest/bound.c), and is at least as good as all that can be carved. The tangent
// of the tilt that a shape survives is the least, over the edges of its foot, of how far inside the
// centre of mass lies over how high it lies: depth in half-spaces of no margin, measured by the
// height.

#include "balance/stand/stand.h"

#include "balance/forest/forest.h"
#include "base/math.h"
#include "base/memory.h"
#include "base/status.h"

#include <string.h>

// What is asked of one edge: to lie inside it, and what that is measured by.
typedef struct edges {
    sf_halfspace *inside, *height;
    size_t count, capacity;
} edges;

static sf_status add_edges(const sf_stand *stand, const sf_stance *stance, edges *e)
{
    size_t count;
    sf_stance_options o = sf_stance_get_options(stance);
    SF_TRY(sf_stance_halfspaces(stance, e->inside + e->count, e->capacity - e->count, &count));
    for (size_t i = 0; i < count; i++) {
        sf_halfspace *h = &e->height[e->count + i];
        memcpy(h->normal, o.up, sizeof o.up);
        h->offset_mm = sf_stance_ground(stance);
    }
    e->count += count;
    (void)stand;
    return SF_OK;
}

// The stances without any margin: what lies inside their edges just stands.
static sf_status gather(const sf_stand *stand, sf_stance **bare, edges *e)
{
    sf_mesh_view view = sfi_stand_surface_view(&stand->surface, stand->surface.points);
    for (size_t i = 0; i < stand->stance_count; i++) {
        sf_stance_options o = stand->asked[i];
        size_t count = 0;
        o.gamma_rad = 0;
        SF_TRY(sf_stance_create(view, &o, &stand->allocator, &bare[i], NULL));
        sf_status status = sf_stance_halfspaces(bare[i], NULL, 0, &count);
        if (status != SF_OK && status != SF_ERR_CAPACITY) {
            return status;
        }
        e->capacity += count;
    }
    e->inside = sfi_alloc_array(&stand->allocator, e->capacity, sizeof *e->inside);
    e->height = sfi_alloc_array(&stand->allocator, e->capacity, sizeof *e->height);
    if (e->inside == NULL || e->height == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < stand->stance_count; i++) {
        SF_TRY(add_edges(stand, bare[i], e));
    }
    return SF_OK;
}

int sfi_stand_has_best(const sf_stand *stand)
{
    for (size_t i = 0; i < stand->stance_count; i++) {
        if (stand->asked[i].kind != SF_STANCE_STAND) {
            return 0;
        }
    }
    return stand->options.carve;
}

sf_status sfi_stand_best(const sf_stand *stand, const sf_grid *solid, const sf_grid *wall,
                         const float *density, const sf_body *rest, sf_task *task,
                         double *bound_rad)
{
    const sf_allocator *a = &stand->allocator;
    edges e = {NULL, NULL, 0, 0};
    double depth = 0;
    sf_stance **bare = sfi_alloc_array(a, stand->stance_count, sizeof(sf_stance *));
    if (bare == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(bare, 0, stand->stance_count * sizeof(sf_stance *));
    sf_status status = gather(stand, bare, &e);
    if (status == SF_OK) {
        sfi_forest_options options;
        memset(&options, 0, sizeof options);
        options.goal = SFI_FOREST_DEEPEST;
        options.halfspaces = e.inside;
        options.slopes = e.height;
        options.count = e.count;
        options.density = density;
        options.rest = *rest;
        status = sfi_carve_bound(solid, wall, NULL, &options, a, task, &depth, NULL);
    }
    if (status == SF_OK) {
        *bound_rad = sfi_atan(depth);
    }
    for (size_t i = 0; i < stand->stance_count; i++) {
        sf_stance_destroy(bare[i]);
    }
    sfi_free_array(a, bare, stand->stance_count, sizeof(sf_stance *));
    sfi_free_array(a, e.inside, e.capacity, sizeof *e.inside);
    sfi_free_array(a, e.height, e.capacity, sizeof *e.height);
    return status;
}

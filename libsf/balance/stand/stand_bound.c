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

#include "balance/forest/bound.h"
#include "balance/forest/forest.h"
#include "balance/stance/stance.h"
#include "base/math.h"
#include "base/memory.h"
#include "base/status.h"

#include <string.h>

// What is asked of one edge: to lie inside it, and what that is measured by.
typedef struct edges {
    sf_halfspace *inside, *height;
    size_t count, capacity;
} edges;

// Those of the edges alone: off a table's edge a stance asks for a height of 0 as well.
static void add_edges(const sf_stance *stance, edges *e)
{
    size_t count = sfi_edge_count(stance);
    memcpy(e->inside + e->count, stance->halfspaces, count * sizeof *e->inside);
    for (size_t i = 0; i < count; i++) {
        sf_halfspace *h = &e->height[e->count + i];
        memcpy(h->normal, stance->options.up, sizeof h->normal);
        h->offset_mm = stance->ground_mm;
    }
    e->count += count;
}

// The stances without any margin: what lies inside their edges just stands.
static sf_status gather(const sf_stand *stand, sf_stance **bare, edges *e)
{
    sf_mesh_view view = sfi_stand_surface_view(&stand->surface, stand->surface.points);
    for (size_t i = 0; i < stand->stance_count; i++) {
        sf_stance_options o = stand->asked[i];
        o.gamma_rad = 0;
        SF_TRY(sf_stance_create(view, &o, &stand->allocator, &bare[i], NULL));
        e->capacity += sfi_edge_count(bare[i]);
    }
    e->inside = sfi_alloc_array(&stand->allocator, e->capacity, sizeof *e->inside);
    e->height = sfi_alloc_array(&stand->allocator, e->capacity, sizeof *e->height);
    if (e->inside == NULL || e->height == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < stand->stance_count; i++) {
        add_edges(bare[i], e);
    }
    return SF_OK;
}

static int is_at_rest(const sf_stand *stand, const sf_pose *poses)
{
    const sf_pose identity = sf_pose_identity();
    for (size_t j = 0; j < stand->handle_count; j++) {
        if (memcmp(&poses[j], &identity, sizeof identity) != 0) {
            return 0;
        }
    }
    return 1;
}

int sfi_stand_has_best(const sf_stand *stand, const sf_pose *poses)
{
    for (size_t i = 0; i < stand->stance_count; i++) {
        if (stand->asked[i].kind != SF_STANCE_STAND) {
            return 0;
        }
    }
    return stand->options.carve && is_at_rest(stand, poses);
}

// Whether the centre of mass lies above all grounds, whatever is carved. Off a table's edge it may
// come down to the ground and below it, where depth over height is no tangent any more.
static sf_status look_at_heights(const edges *e, sfi_fractional *f, int *are_above)
{
    *are_above = 1;
    for (size_t i = 0; i < e->count && *are_above; i++) {
        sfi_lever height = sfi_lever_of(&e->height[i], 1);
        sf_body lowest;
        int is_next = i == 0 || memcmp(&e->height[i], &e->height[i - 1], sizeof *e->height) != 0;
        if (is_next) {
            SF_TRY(sfi_fractional_find(f, &height, &lowest));
            *are_above = sfi_lever_body(&height, &lowest) > 0;
        }
    }
    return SF_OK;
}

static sf_status find(const sf_stand *stand, const sfi_fractional *f, const edges *e, double *depth)
{
    sfi_forest_options options;
    memset(&options, 0, sizeof options);
    options.goal = SFI_FOREST_DEEPEST;
    options.halfspaces = e->inside;
    options.slopes = e->height;
    options.count = e->count;
    options.density = f->density;
    options.rest = f->rest;
    return sfi_carve_bound(f->solid, f->given, NULL, &options, &stand->allocator, f->task, depth,
                           NULL);
}

sf_status sfi_stand_best(const sf_stand *stand, const sf_grid *solid, const sf_grid *wall,
                         const float *density, const sf_body *rest, sf_task *task, int *has_bound,
                         double *bound_rad)
{
    const sf_allocator *a = &stand->allocator;
    edges e = {NULL, NULL, 0, 0};
    sfi_fractional f = {solid, wall, density, *rest, task, NULL};
    sf_lattice lattice = sf_grid_lattice(solid);
    double depth = 0;
    sf_stance **bare = sfi_alloc_array(a, stand->stance_count, sizeof(sf_stance *));
    if (bare == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(bare, 0, stand->stance_count * sizeof(sf_stance *));
    sf_status status = gather(stand, bare, &e);
    if (status == SF_OK) {
        status = sf_grid_create(&lattice, a, &f.shape);
    }
    if (status == SF_OK) {
        status = look_at_heights(&e, &f, has_bound);
    }
    if (status == SF_OK && *has_bound) {
        status = find(stand, &f, &e, &depth);
        *bound_rad = sfi_atan(depth);
    }
    for (size_t i = 0; i < stand->stance_count; i++) {
        sf_stance_destroy(bare[i]);
    }
    sf_grid_destroy(f.shape);
    sfi_free_array(a, bare, stand->stance_count, sizeof(sf_stance *));
    sfi_free_array(a, e.inside, e.capacity, sizeof *e.inside);
    sfi_free_array(a, e.height, e.capacity, sizeof *e.height);
    return status;
}

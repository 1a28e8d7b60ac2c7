// SPDX-License-Identifier: MIT
// The wall of a solid without a mesh: how near its voxels are to what is not solid.
//
// Two boxes that are (dx, dy, dz) voxels apart have a gap that grows with each of |dx|, |dy|, |dz|:
// for each dz the (dx, dy) with a gap below the thickness are a structuring element. So what is not
// wall is what is left after eroding every layer around by its element; beyond the grid nothing is
// solid.

#include "balance/wall/apart.h"
#include "balance/wall/levels.h"
#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/terms.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

#include <sf/carve.h>

#include <math.h>

typedef struct search {
    const sf_grid *solid;
    sf_grid *wall;
    sf_lattice lattice;
    double limit;
    sf_allocator allocator;
    double *levels; // bottoms of the layers, and the top
    size_t words;   // of each of the two slices
    sf_slice inside, here;
} search;

// Take away what layer j lets no voxel of layer k be; j may be the layer below the grid or above.
// Returns 0 where it is too far off.
static int apply_layer(search *s, int64_t j, int64_t k)
{
    const sf_lattice *l = &s->lattice;
    const double *z = s->levels;
    double gap = j > k ? z[j] - z[k + 1] : j < k ? z[k] - z[j + 1] : 0;
    sf_element element;
    if (gap >= s->limit) {
        return 0;
    }
    if (j < 0 || j == (int64_t)l->nz) {
        sfi_slice_clear(s->inside);
        return 0;
    }
    // Sound slices of one size and a sound element: neither call can fail.
    double left = s->limit * s->limit - gap * gap;
    if (sfi_apart_element(left, SFI_APART_BOXES, l->pitch_x_mm, l->pitch_y_mm, &element) &&
        sf_slice_erode(s->here, sf_grid_slice(s->solid, (uint32_t)j), &element, SF_BORDER_EMPTY) ==
            SF_OK) {
        (void)!sf_slice_and(s->inside, s->inside, s->here);
    }
    return 1;
}

static sf_status find_layer(search *s, uint32_t k)
{
    sf_slice solid = sf_grid_slice(s->solid, k);
    SF_TRY(sf_slice_copy(s->inside, solid));
    for (int64_t j = k; apply_layer(s, j, k);) {
        j++;
    }
    for (int64_t j = (int64_t)k - 1; apply_layer(s, j, k);) {
        j--;
    }
    return sf_slice_subtract(sf_grid_slice(s->wall, k), solid, s->inside);
}

static sf_status find_wall(search *s, sf_task *task)
{
    sfi_progress progress = sfi_progress_begin(task);
    for (uint32_t k = 0; k < s->lattice.nz; k++) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        SF_TRY(find_layer(s, k));
        sfi_progress_report(&progress, k + 1, s->lattice.nz);
    }
    return SF_OK;
}

static sf_status create(search *s, double wall_mm)
{
    s->levels = sfi_levels_create(&s->lattice, &s->allocator);
    s->words = sf_slice_stride(s->lattice.nx) * s->lattice.ny; // as in a grid: does not overflow
    s->inside = s->here = sf_grid_slice(s->solid, 0);
    s->inside.words = sfi_alloc_array(&s->allocator, s->words, 2 * sizeof *s->inside.words);
    if (s->levels == NULL || s->inside.words == NULL) {
        return SF_ERR_MEMORY;
    }
    s->here.words = s->inside.words + s->words;
    s->limit = sfi_levels_forgive(&s->lattice, wall_mm, 0);
    return sf_grid_create(&s->lattice, &s->allocator, &s->wall);
}

static void destroy(search *s)
{
    sf_grid_destroy(s->wall);
    sfi_free_array(&s->allocator, s->inside.words, s->words, 2 * sizeof *s->inside.words);
    sfi_levels_destroy(s->levels, &s->lattice, &s->allocator);
}

sf_status sf_grid_wall_inside(const sf_grid *solid, double wall_mm, const sf_allocator *allocator,
                              sf_task *task, sf_grid *wall)
{
    if (solid == NULL || wall == NULL || solid == wall || !(wall_mm >= 0) || !isfinite(wall_mm)) {
        return SF_ERR_ARGUMENT;
    }
    search s = {.solid = solid, .lattice = sf_grid_lattice(solid)};
    s.allocator = sfi_allocator_or_default(allocator);
    SF_TRY(sfi_terms_match(&s.lattice, wall));
    if (!sfi_apart_fits(wall_mm, s.lattice.pitch_x_mm, s.lattice.pitch_y_mm)) {
        return SF_ERR_UNSUPPORTED;
    }
    sf_status status = create(&s, wall_mm);
    if (status == SF_OK) {
        status = find_wall(&s, task);
    }
    if (status == SF_OK) {
        status = sfi_grid_copy(wall, s.wall);
    }
    destroy(&s);
    return status;
}

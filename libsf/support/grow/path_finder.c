// SPDX-License-Identifier: MIT
// Path finder: the closest supporting path of one voxel by a search of its downward cone.
//
// Let W_t be what t steps down can reach (cone.c), clipped to the grid, and t* the least t such
// that W_t meets matter in its layer. The layers of the cone above are empty, so nothing is in the
// way of any chain to that matter: t* - 1 voxels are filled, and no path does with less, since a
// path of fewer voxels would land higher. Where the whole cone is empty every path goes to the bed,
// through as many voxels, and the best one ends where the matter of the bed slice is closest.
//
// So no map of the grid is needed: rows of the windows are tested a word at a time, layer by layer,
// and the first layer that answers ends the search. A test costs no memory and looks at the grid as
// it is, so nothing gets out of date.
//
// Two things can spoil this: voxels on the way that must not be filled, and exempt voxels, on which
// a path may end in the air. The search goes on as if there were none: if the path that it finds is
// allowed, it is one of the best (more freedom could not make it longer), else, and under slack,
// where a window does not tell who reaches what, the slower search of descent.c answers.
//
// Source: the cost and the paths are T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free
// Shapes for Fabrication", 2016; the search of the cone is the library's own.

#include "base/bits.h"
#include "base/memory.h"
#include "base/status.h"
#include "support/check/row.h"
#include "support/grow/search.h"

struct sf_path_finder {
    sfi_site site;
    sfi_cone cone;
    sfi_bed bed;
    sf_voxel *chain; // a place for each layer
};

// ---------------------------------------------------------------------------------------------
// Windows on a slice
// ---------------------------------------------------------------------------------------------

// Whether any voxel of a rectangle that is not empty is solid. `next` is the slice that is looked
// at after this one, or has no words.
static int any_in(sf_slice slice, sf_slice next, sf_rect r)
{
    size_t first = r.x0 / 64, last = (r.x1 - 1) / 64;
    const uint64_t *ahead = next.words != NULL ? sfi_slice_row(next, r.y0) + first : NULL;
    return sfi_kernels_get()->any_in_rows(sfi_slice_row(slice, r.y0) + first, slice.stride,
                                          r.y1 - r.y0, last - first + 1,
                                          ~UINT64_C(0) << (r.x0 % 64), sfi_tail_mask(r.x1), ahead);
}

#define BAND 16u

// The same for a few rows of a window.
static int any_in_band(sf_slice slice, const sfi_window *window, sf_voxel from, uint32_t y0,
                       uint32_t y1)
{
    uint32_t widest = from.y < y0 ? y0 : from.y < y1 ? from.y : y1 - 1;
    sf_rect around = sfi_window_row(window, from, slice.width, widest);
    around.y0 = y0;
    around.y1 = y1;
    if (!any_in(slice, SFI_NO_SLICE, around)) {
        return 0;
    }
    for (uint32_t y = y0; y < y1; y++) {
        sf_rect part = sfi_window_row(window, from, slice.width, y);
        if (sfi_row_any(sfi_slice_row(slice, y), slice.width, part.x0, part.x1)) {
            return 1;
        }
    }
    return 0;
}

// Most windows are empty, and so is the rectangle around them, which is tested first and at once.
// Where it is not, matter is often in its corners, outside the window; so bands of it come next.
static int any_in_window(sf_slice slice, sf_slice next, const sfi_window *window, sf_voxel from)
{
    uint32_t y0, y1;
    sfi_window_rows(window, from, slice.height, &y0, &y1);
    sf_rect around = sfi_window_row(window, from, slice.width, from.y);
    around.y0 = y0;
    around.y1 = y1;
    if (!any_in(slice, next, around)) {
        return 0;
    }
    for (uint32_t y = y0; y < y1; y += BAND) {
        if (any_in_band(slice, window, from, y, y1 - y < BAND ? y1 : y + BAND)) {
            return 1;
        }
    }
    return 0;
}

// The last solid voxel of x0 <= x < x1, or x1.
static uint32_t find_last(const uint64_t *row, uint32_t x0, uint32_t x1)
{
    for (uint32_t end = x1; end > x0;) {
        uint32_t i = (end - 1) / 64;
        uint64_t w = row[i] & sfi_tail_mask(end);
        w = i == x0 / 64 ? w & ~UINT64_C(0) << (x0 % 64) : w;
        if (w != 0) {
            return i * 64 + sfi_highest_bit(w);
        }
        end = i * 64;
    }
    return x1;
}

// The best solid voxel within a window.
static sfi_spot choose_matter(sf_slice slice, const sfi_window *window, sf_voxel from)
{
    sfi_spot spot = {0, 0, 0, 0, 0};
    uint32_t y0, y1;
    sfi_window_rows(window, from, slice.height, &y0, &y1);
    for (uint32_t y = y0; y < y1; y++) {
        const uint64_t *row = sfi_slice_row(slice, y);
        sf_rect part = sfi_window_row(window, from, slice.width, y);
        uint32_t right = sfi_row_find(row, part.x1, from.x, 0);
        uint32_t left = find_last(row, part.x0, from.x);
        if (left < from.x) {
            sfi_spot_offer(&spot, 0, from, left, y);
        }
        if (right < part.x1) {
            sfi_spot_offer(&spot, 0, from, right, y);
        }
    }
    return spot;
}

// ---------------------------------------------------------------------------------------------
// Search
// ---------------------------------------------------------------------------------------------

// Whether all voxels of a chain may be filled, or are.
static int is_chain_allowed(const sfi_site *site, const sf_voxel *chain, size_t count)
{
    int is_masked = site->terms.forbid != NULL || site->terms.act != NULL;
    for (size_t i = 0; is_masked && i < count; i++) {
        if (!sfi_site_is_passable(site, chain[i])) {
            return 0;
        }
    }
    return 1;
}

// The path that ends in a window, on matter or on the bed; *is_allowed says whether the masks let
// it be.
static sf_status land(sf_path_finder *f, const sfi_window *window, sf_voxel from, int on_matter,
                      sf_path *found, int *is_allowed)
{
    uint32_t z = from.z - window->depth;
    sf_slice slice = sf_grid_slice(f->site.roots, z);
    sfi_spot spot;
    if (on_matter) {
        spot = choose_matter(slice, window, from);
    } else {
        SF_TRY(sfi_bed_update(&f->bed, &f->site));
        spot = sfi_bed_choose(&f->bed, slice, window, from);
    }
    sf_voxel to = {spot.x, spot.y, z};
    size_t count = window->depth - (on_matter ? 1 : 0);
    sfi_cone_chain(window, from, to, f->chain);
    if (!on_matter) {
        f->chain[count - 1] = to;
    }
    *is_allowed = is_chain_allowed(&f->site, f->chain, count);
    *found = sfi_path_make(count, on_matter ? SF_PATH_END_MATTER : SF_PATH_END_BED, to,
                           (uint32_t)spot.first);
    return SF_OK;
}

// *is_answer = 0 where the search cannot tell.
static sf_status search_cone(sf_path_finder *f, sf_voxel from, sf_path *found, int *is_answer)
{
    const sfi_site *site = &f->site;
    sfi_cone_begin(&f->cone, from.z);
    for (uint32_t z = from.z; z-- > site->bed;) {
        sfi_window window;
        SF_TRY(sfi_cone_deepen(&f->cone, &window));
        sf_slice next = z > site->bed ? sf_grid_slice(site->roots, z - 1) : SFI_NO_SLICE;
        int is_hit = any_in_window(sf_grid_slice(site->roots, z), next, &window, from);
        sf_slice exempt = sfi_mask_slice(site->terms.exempt, z);
        if (!is_hit && exempt.words != NULL && any_in_window(exempt, SFI_NO_SLICE, &window, from)) {
            break;
        }
        if (is_hit || z == site->bed) {
            return land(f, &window, from, is_hit, found, is_answer);
        }
    }
    *is_answer = 0;
    return SF_OK;
}

static sf_status search(sf_path_finder *f, sf_voxel from, sf_path *found)
{
    if (sfi_path_is_trivial(&f->site, from, found)) {
        return SF_OK;
    }
    if (from.z < f->site.bed) {
        return SF_ERR_INFEASIBLE;
    }
    int is_answer = 0;
    if (f->site.plain.kind != SF_RULE_SLACK) {
        SF_TRY(search_cone(f, from, found, &is_answer));
    }
    return is_answer ? SF_OK : sfi_descend(&f->site, &f->bed, from, f->chain, found);
}

sf_status sf_path_finder_find(sf_path_finder *finder, sf_voxel from, sf_voxel *path,
                              size_t capacity, sf_path *found)
{
    if (finder == NULL || found == NULL || (path == NULL && capacity > 0) ||
        from.x >= finder->site.lattice.nx || from.y >= finder->site.lattice.ny ||
        from.z >= finder->site.lattice.nz) {
        return SF_ERR_ARGUMENT;
    }
    sf_path answer;
    SF_TRY(search(finder, from, &answer));
    *found = answer;
    if (answer.count > capacity) {
        return SF_ERR_CAPACITY;
    }
    for (size_t i = 0; i < answer.count; i++) {
        path[i] = finder->chain[i];
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Life
// ---------------------------------------------------------------------------------------------

void sf_path_finder_destroy(sf_path_finder *finder)
{
    if (finder == NULL) {
        return;
    }
    sf_allocator allocator = finder->site.allocator;
    sfi_bed_destroy(&finder->bed, &finder->site);
    sfi_cone_destroy(&finder->cone);
    sfi_free_array(&allocator, finder->chain, finder->site.lattice.nz, sizeof *finder->chain);
    sfi_site_close(&finder->site);
    sfi_free_array(&allocator, finder, 1, sizeof *finder);
}

sf_status sf_path_finder_create(const sf_grid *grid, const sf_terms *terms, sf_landing landing,
                                const sf_allocator *allocator, sf_task *task,
                                sf_path_finder **finder)
{
    sf_path_finder made = {0};
    sfi_progress progress = sfi_progress_begin(task);
    if (finder == NULL || grid == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sfi_stage stage = {task, &progress, 0, sf_grid_lattice(grid).nz};
    SF_TRY(sfi_site_open(&made.site, grid, terms, landing, allocator, &stage));
    const sf_lattice *lattice = &made.site.lattice;
    made.cone = sfi_cone_create(&made.site.plain, lattice->nx, lattice->ny, allocator);
    made.chain = sfi_alloc_array(&made.site.allocator, lattice->nz, sizeof *made.chain);
    sf_path_finder *placed = sfi_alloc_array(&made.site.allocator, 1, sizeof *placed);
    if (made.chain == NULL || placed == NULL) {
        sfi_free_array(&made.site.allocator, placed, 1, sizeof *placed);
        sfi_free_array(&made.site.allocator, made.chain, lattice->nz, sizeof *made.chain);
        sfi_site_close(&made.site);
        return SF_ERR_MEMORY;
    }
    *placed = made;
    *finder = placed;
    return SF_OK;
}

sf_status sf_path_finder_refresh(sf_path_finder *finder, sf_task *task)
{
    if (finder == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sfi_progress progress = sfi_progress_begin(task);
    sfi_stage stage = {task, &progress, 0, finder->site.lattice.nz};
    return sfi_site_refresh(&finder->site, &stage);
}

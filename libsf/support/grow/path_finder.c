// SPDX-License-Identifier: MIT
// Path finder: the closest supporting path of one voxel by a search of its downward cone.
//
// Let W_t be what t steps down can reach through empty space (cone.c), clipped to the grid, and t*
// the least t such that W_t holds something to end on in its layer: matter, which under slack must
// have to spare what its place in the window asks for (fringe.c), or an exempt voxel. Nothing is in
// the way of the chains there: matter with too little to spare is passed through like empty space.
// So t* - 1 voxels are filled, or t* on an exempt voxel, and no path does with less, since a path
// of fewer voxels would end higher. Where there is no such t every path goes to the bed, through as
// many voxels, and the best one ends where the matter of the bed slice is closest.
//
// So no map of the grid is needed: rows of the windows are tested a word at a time, layer by layer,
// and the first layer that answers ends the search. For rules that are elements a test costs no
// memory and looks at the grid as it is, so nothing gets out of date. Under slack what matter has
// to spare is kept (site.c), and looked at only where a window's rim meets matter.
//
// Masks can spoil this: voxels on the way that must not be filled. The search goes on as if there
// were none: if the path that it finds is allowed, it is one of the best (more freedom could not
// make it longer), else the slower search of search.c answers.
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

// What a path may end on in one layer: matter that it can rest on, or voxels that are held.
typedef struct ends {
    const sfi_site *site;
    const sfi_window *window;
    sf_voxel from;
    sf_slice slice;
    sf_path_end kind;
} ends;

// Whether the voxel at (x, y), which lies in the window, has to spare what is asked of it. What is
// held has nothing.
static int is_enough(const ends *e, uint32_t x, uint32_t y)
{
    sf_voxel from = e->from, at = {x, y, from.z - e->window->depth};
    uint32_t dx = x > from.x ? x - from.x : from.x - x, dy = y > from.y ? y - from.y : from.y - y;
    uint32_t demand = sfi_window_demand(e->window, dx, dy);
    return demand == 0 || (e->kind == SF_PATH_END_MATTER && sfi_site_slack(e->site, at) >= demand);
}

// The best of them within the window.
static sfi_spot choose_end(const ends *e)
{
    sfi_spot spot = {0, 0, 0, 0, 0};
    sf_voxel from = e->from;
    uint32_t y0, y1;
    sfi_window_rows(e->window, from, e->slice.height, &y0, &y1);
    for (uint32_t y = y0; y < y1; y++) {
        const uint64_t *row = sfi_slice_row(e->slice, y);
        sf_rect part = sfi_window_row(e->window, from, e->slice.width, y);
        uint32_t right = sfi_row_find(row, part.x1, from.x, 0);
        while (right < part.x1 && !is_enough(e, right, y)) {
            right = sfi_row_find(row, part.x1, right + 1, 0);
        }
        uint32_t left = find_last(row, part.x0, from.x), none = from.x;
        while (left < none && !is_enough(e, left, y)) {
            none = left;
            left = find_last(row, part.x0, left);
        }
        if (left < none) {
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

// Whether a path may go through a voxel: it is solid or may be filled.
static int is_passable(const sfi_site *site, sf_voxel v)
{
    uint64_t free = sfi_site_free_word(site, v.z, v.y, v.x / 64);
    uint64_t solid = sfi_slice_row(sf_grid_slice(site->grid, v.z), v.y)[v.x / 64];
    return ((free | solid) >> (v.x % 64) & 1) != 0;
}

// Whether all voxels of a chain may be filled, or are.
static int is_chain_allowed(const sfi_site *site, const sf_voxel *chain, size_t count)
{
    int is_masked = site->terms.forbid != NULL || site->terms.act != NULL;
    for (size_t i = 0; is_masked && i < count; i++) {
        if (!is_passable(site, chain[i])) {
            return 0;
        }
    }
    return 1;
}

// The path that ends at a spot of a window; *is_allowed says whether the masks let it be.
static void land(sf_path_finder *f, const sfi_window *window, sf_voxel from, sf_path_end end,
                 const sfi_spot *spot, sf_path *found, int *is_allowed)
{
    sf_voxel to = {spot->x, spot->y, from.z - window->depth};
    size_t count = window->depth - (end == SF_PATH_END_MATTER ? 1 : 0);
    sfi_cone_chain(window, from, to, f->chain);
    if (end != SF_PATH_END_MATTER) {
        f->chain[count - 1] = to;
    }
    *is_allowed = is_chain_allowed(&f->site, f->chain, count);
    *found = sfi_path_make(count, end, to, (uint32_t)spot->first);
}

// Matter, or what is held, by layers.
static sf_slice ends_in(const sfi_site *site, sf_path_end kind, uint32_t z)
{
    return kind == SF_PATH_END_MATTER ? sf_grid_slice(site->roots, z)
                                      : sfi_mask_slice(site->terms.exempt, z);
}

// The best end within a window, if there is one. SF_OK, or a failure of memory.
static sf_status find_end(sf_path_finder *f, const sfi_window *window, sf_voxel from,
                          sf_path_end *end, sfi_spot *spot)
{
    static const sf_path_end kinds[2] = {SF_PATH_END_MATTER, SF_PATH_END_HELD};
    const sfi_site *site = &f->site;
    uint32_t z = from.z - window->depth;
    for (int i = 0; i < 2; i++) {
        sf_slice slice = ends_in(site, kinds[i], z);
        sf_slice next = z > site->bed ? ends_in(site, kinds[i], z - 1) : SFI_NO_SLICE;
        if (slice.words != NULL && any_in_window(slice, next, window, from)) {
            ends e = {site, window, from, slice, kinds[i]};
            *end = kinds[i];
            *spot = choose_end(&e);
            if (spot->is_found) {
                return SF_OK;
            }
        }
    }
    if (z == site->bed) {
        SF_TRY(sfi_bed_update(&f->bed, site));
        *end = SF_PATH_END_BED;
        *spot = sfi_bed_choose(&f->bed, sf_grid_slice(site->roots, z), window, from);
    }
    return SF_OK;
}

// *is_answer = 0 where the masks are in the way of the path that is found.
static sf_status search_cone(sf_path_finder *f, sf_voxel from, sf_path *found, int *is_answer)
{
    sfi_spot spot = {0, 0, 0, 0, 0};
    sf_path_end end = SF_PATH_END_BED;
    sfi_cone_begin(&f->cone, from.z);
    for (;;) {
        sfi_window window;
        SF_TRY(sfi_cone_deepen(&f->cone, &window));
        SF_TRY(find_end(f, &window, from, &end, &spot));
        if (spot.is_found) {
            land(f, &window, from, end, &spot, found, is_answer);
            return SF_OK;
        }
    }
}

static sf_status search(sf_path_finder *f, sf_voxel from, sf_path *found)
{
    int is_answer;
    if (sfi_path_is_trivial(&f->site, from, found)) {
        return SF_OK;
    }
    if (from.z < f->site.bed) {
        return SF_ERR_INFEASIBLE;
    }
    SF_TRY(search_cone(f, from, found, &is_answer));
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

// Memory for the questions. Where a sweep of the grid was needed, what takes less is made beside
// it, so that no question waits for it: distances on the bed, and under slack the windows that all
// voxels share.
static sf_status prepare(sf_path_finder *f, const sf_allocator *allocator)
{
    const sf_lattice *lattice = &f->site.lattice;
    f->chain = sfi_alloc_array(&f->site.allocator, lattice->nz, sizeof *f->chain);
    if (f->chain == NULL) {
        return SF_ERR_MEMORY;
    }
    SF_TRY(sfi_cone_create(&f->site.plain, lattice->nx, lattice->ny, allocator, &f->cone));
    if (f->site.alive == NULL) {
        return SF_OK;
    }
    SF_TRY(sfi_bed_update(&f->bed, &f->site));
    return sfi_cone_prepare(&f->cone, lattice->nz - 1);
}

sf_status sf_path_finder_create(const sf_grid *grid, const sf_terms *terms, sf_landing landing,
                                const sf_allocator *allocator, sf_task *task,
                                sf_path_finder **finder)
{
    sfi_progress progress = sfi_progress_begin(task);
    if (finder == NULL || grid == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sfi_stage stage = {task, &progress, 0, sf_grid_lattice(grid).nz};
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_path_finder empty = {0}, *made = sfi_alloc_array(&from, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    *made = empty;
    sf_status status = sfi_site_open(&made->site, grid, terms, landing, allocator, &stage);
    if (status != SF_OK) {
        sfi_free_array(&from, made, 1, sizeof *made);
        return status;
    }
    status = prepare(made, allocator);
    if (status != SF_OK) {
        sf_path_finder_destroy(made);
        return status;
    }
    *finder = made;
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

// SPDX-License-Identifier: MIT
// The bed of a path finder: how far each of its voxels lies from the matter of the bed slice, and
// which voxel of a window lies closest.
//
// A window on the bed may be as large as the slice, so its voxels are not asked one by one. The
// distances are cut into tiles, of each of which the least is known. The least over the tiles that
// lie wholly within the window bounds the answer from above; after that only tiles whose least is
// no more than the bound are looked into, those on the window's rim among them. These are few,
// because distances change by no more than a voxel from one to the next.
//
// An empty slice is far from everything, and the voxel straight below is as good as any.

#include "base/memory.h"
#include "base/status.h"
#include "support/grow/search.h"

#define TILE 16u

static uint32_t tiles_in(uint32_t extent)
{
    return (extent + TILE - 1) / TILE;
}

static size_t tile_count(const sfi_site *site)
{
    return (size_t)tiles_in(site->lattice.nx) * tiles_in(site->lattice.ny);
}

void sfi_bed_destroy(sfi_bed *bed, const sfi_site *site)
{
    size_t area = (size_t)site->lattice.nx * site->lattice.ny;
    sfi_free_array(&site->allocator, bed->square, area, sizeof *bed->square);
    sfi_free_array(&site->allocator, bed->tiles, tile_count(site), sizeof *bed->tiles);
    sfi_free_array(&site->allocator, bed->scratch, site->lattice.nx, 3 * sizeof *bed->scratch);
    sf_grid_destroy(bed->seen);
    bed->square = bed->tiles = bed->scratch = NULL;
    bed->seen = NULL;
}

static sf_status create_bed(sfi_bed *bed, const sfi_site *site)
{
    sf_lattice one = site->lattice;
    one.nz = 1;
    one.heights_mm = NULL;
    size_t area = (size_t)one.nx * one.ny; // fits: the grid has that many bits, twice and more
    bed->square = sfi_alloc_array(&site->allocator, area, sizeof *bed->square);
    bed->tiles = sfi_alloc_array(&site->allocator, tile_count(site), sizeof *bed->tiles);
    bed->scratch = sfi_alloc_array(&site->allocator, one.nx, 3 * sizeof *bed->scratch);
    sf_status status = bed->square != NULL && bed->tiles != NULL && bed->scratch != NULL
                           ? sf_grid_create(&one, &site->allocator, &bed->seen)
                           : SF_ERR_MEMORY;
    if (status != SF_OK) {
        sfi_bed_destroy(bed, site);
    }
    return status;
}

// least[x] = the least of a column of the rows y0 <= y < y1.
static void find_columns(const sfi_bed *bed, uint32_t width, uint32_t y0, uint32_t y1,
                         uint32_t *restrict least)
{
    for (uint32_t x = 0; x < width; x++) {
        least[x] = UINT32_MAX;
    }
    for (uint32_t y = y0; y < y1; y++) {
        const uint32_t *square = bed->square + (size_t)y * width;
        for (uint32_t x = 0; x < width; x++) {
            least[x] = square[x] < least[x] ? square[x] : least[x];
        }
    }
}

static void find_tiles(sfi_bed *bed, uint32_t width, uint32_t height)
{
    uint32_t *tile = bed->tiles, *columns = bed->scratch;
    for (uint32_t y = 0; y < height; y += TILE) {
        find_columns(bed, width, y, height - y < TILE ? height : y + TILE, columns);
        for (uint32_t x = 0; x < width; x++) {
            uint32_t before = x % TILE == 0 ? UINT32_MAX : *tile;
            *tile = columns[x] < before ? columns[x] : before;
            tile += x % TILE == TILE - 1 || x == width - 1;
        }
    }
}

sf_status sfi_bed_update(sfi_bed *bed, const sfi_site *site)
{
    sf_slice now = sf_grid_slice(site->roots, site->bed);
    if (bed->square == NULL) {
        SF_TRY(create_bed(bed, site));
    } else if (sf_slice_equal(sf_grid_slice(bed->seen, 0), now)) {
        return SF_OK;
    }
    SF_TRY(sf_slice_copy(sf_grid_slice(bed->seen, 0), now));
    sfi_slice_distance(now, bed->square, bed->scratch);
    find_tiles(bed, now.width, now.height);
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The best voxel of a window
// ---------------------------------------------------------------------------------------------

// A window on the bed: the slice's size, and its rows within the slice.
typedef struct reach {
    const sfi_window *window;
    sf_voxel from;
    uint32_t width, height, y0, y1;
} reach;

static uint32_t apart(uint32_t a, uint32_t b)
{
    return a > b ? a - b : b - a;
}

// The least over the tiles of a row of tiles that lie wholly within the window.
static uint32_t least_inside(const sfi_bed *bed, const reach *r, uint32_t row)
{
    uint32_t y0 = row * TILE, y1 = y0 + TILE < r->height ? y0 + TILE : r->height;
    uint32_t least = UINT32_MAX;
    if (y0 < r->y0 || y1 > r->y1) {
        return least;
    }
    uint32_t up = apart(y0, r->from.y), down = apart(y1 - 1, r->from.y);
    sf_rect part = sfi_window_row(r->window, r->from, r->width, up > down ? y0 : y1 - 1);
    uint32_t end = part.x1 == r->width ? tiles_in(r->width) : part.x1 / TILE;
    for (uint32_t i = tiles_in(part.x0); i < end; i++) {
        uint32_t here = bed->tiles[(size_t)row * tiles_in(r->width) + i];
        least = here < least ? here : least;
    }
    return least;
}

// Offer what of a tile lies within the window and is no farther from matter than the best so far.
static void look_into(const sfi_bed *bed, const reach *r, uint32_t row, uint32_t column,
                      sfi_spot *spot)
{
    uint32_t x0 = column * TILE, y0 = row * TILE > r->y0 ? row * TILE : r->y0;
    for (uint32_t y = y0; y < row * TILE + TILE && y < r->y1; y++) {
        sf_rect part = sfi_window_row(r->window, r->from, r->width, y);
        const uint32_t *square = bed->square + (size_t)y * r->width;
        uint32_t x = part.x0 > x0 ? part.x0 : x0;
        for (; x < x0 + TILE && x < part.x1; x++) {
            if (square[x] <= spot->first) {
                sfi_spot_offer(spot, square[x], r->from, x, y);
            }
        }
    }
}

sfi_spot sfi_bed_choose(const sfi_bed *bed, sf_slice slice, const sfi_window *window, sf_voxel from)
{
    reach r = {window, from, slice.width, slice.height, 0, 0};
    sfi_window_rows(window, from, slice.height, &r.y0, &r.y1);
    uint32_t middle = bed->square[(size_t)from.y * slice.width + from.x], least = middle;
    sfi_spot spot = {0, 0, 0, 0, 0};
    sfi_spot_offer(&spot, middle, from, from.x, from.y);
    if (middle == SFI_DISTANCE_NONE) {
        return spot;
    }
    uint32_t first = r.y0 / TILE, end = tiles_in(r.y1), columns = tiles_in(slice.width);
    for (uint32_t row = first; row < end; row++) {
        uint32_t here = least_inside(bed, &r, row);
        least = here < least ? here : least;
    }
    sf_rect around = sfi_window_row(window, from, slice.width, from.y);
    for (uint32_t row = first; row < end; row++) {
        for (uint32_t i = around.x0 / TILE; i < tiles_in(around.x1); i++) {
            uint32_t here = bed->tiles[(size_t)row * columns + i];
            if (here <= least && here <= spot.first) {
                look_into(bed, &r, row, i, &spot);
            }
        }
    }
    return spot;
}

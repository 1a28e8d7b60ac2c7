// SPDX-License-Identifier: MIT
// Grids: stacks of slices that own their memory.
//
// All voxels are in one allocation, slice after slice, rows on 64-byte boundaries, so that a sweep
// from the bottom up reads memory in order. A lattice with heights of its own keeps them in a
// second.

#include "voxel/grid.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"
#include "voxel/rect.h"
#include "voxel/slice.h"

#include <string.h>

struct sf_grid {
    sf_allocator allocator;
    sf_lattice lattice;
    uint64_t *words;
    double *heights;    // nz of them, or NULL
    size_t stride;      // words from row to row
    size_t slice_words; // words from slice to slice
    size_t total_words;
};

static void destroy(sf_grid *grid)
{
    sf_allocator allocator = grid->allocator;
    sfi_free_array(&allocator, grid->words, grid->total_words, sizeof *grid->words);
    sfi_free_array(&allocator, grid->heights, grid->lattice.nz, sizeof *grid->heights);
    sfi_free_array(&allocator, grid, 1, sizeof *grid);
}

// A grid with its memory, the voxels not yet set.
static sf_status create(const sf_lattice *lattice, const sf_allocator *allocator, sf_grid **out)
{
    SF_TRY(sf_lattice_validate(lattice));
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_grid empty = {from, *lattice, NULL, NULL, sf_slice_stride(lattice->nx), 0, 0};
    size_t bytes;
    if (!sfi_size_mul(empty.stride, lattice->ny, &empty.slice_words) ||
        !sfi_size_mul(empty.slice_words, lattice->nz, &empty.total_words) ||
        !sfi_size_mul(empty.total_words, sizeof(uint64_t), &bytes)) {
        return SF_ERR_OVERFLOW;
    }
    sf_grid *grid = sfi_alloc_array(&from, 1, sizeof *grid);
    if (grid == NULL) {
        return SF_ERR_MEMORY;
    }
    *grid = empty;
    grid->words = sfi_alloc_array(&from, grid->total_words, sizeof *grid->words);
    if (lattice->heights_mm != NULL) {
        grid->heights = sfi_alloc_array(&from, lattice->nz, sizeof *grid->heights);
    }
    if (grid->words == NULL || (lattice->heights_mm != NULL && grid->heights == NULL)) {
        destroy(grid);
        return SF_ERR_MEMORY;
    }
    if (grid->heights != NULL) {
        memcpy(grid->heights, lattice->heights_mm, lattice->nz * sizeof *grid->heights);
    }
    grid->lattice.heights_mm = grid->heights;
    *out = grid;
    return SF_OK;
}

sf_status sf_grid_create(const sf_lattice *lattice, const sf_allocator *allocator, sf_grid **grid)
{
    if (grid == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(create(lattice, allocator, grid));
    memset((*grid)->words, 0, (*grid)->total_words * sizeof *(*grid)->words);
    return SF_OK;
}

// A row and its padding, which need not be zero in the grid but is in the copy.
static void copy_row(uint64_t *to, const uint64_t *from, const sf_grid *grid)
{
    size_t words = sfi_row_words(grid->lattice.nx);
    memcpy(to, from, words * sizeof *to);
    to[words - 1] &= sfi_tail_mask(grid->lattice.nx);
    memset(to + words, 0, (grid->stride - words) * sizeof *to);
}

sf_status sf_grid_clone(const sf_grid *grid, const sf_allocator *allocator, sf_grid **clone)
{
    if (grid == NULL || clone == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_grid *copy;
    SF_TRY(create(&grid->lattice, allocator, &copy));
    size_t rows = grid->total_words / grid->stride;
    for (size_t r = 0; r < rows; r++) {
        copy_row(copy->words + r * grid->stride, grid->words + r * grid->stride, grid);
    }
    *clone = copy;
    return SF_OK;
}

void sf_grid_destroy(sf_grid *grid)
{
    if (grid != NULL) {
        destroy(grid);
    }
}

sf_allocator sfi_grid_allocator(const sf_grid *grid)
{
    return grid->allocator;
}

sf_lattice sf_grid_lattice(const sf_grid *grid)
{
    return grid->lattice;
}

sf_slice sf_grid_slice(const sf_grid *grid, uint32_t k)
{
    sf_slice slice = {NULL, 0, 0, 0};
    if (grid != NULL && k < grid->lattice.nz) {
        slice.words = grid->words + (size_t)k * grid->slice_words;
        slice.width = grid->lattice.nx;
        slice.height = grid->lattice.ny;
        slice.stride = grid->stride;
    }
    return slice;
}

int sf_grid_equal(const sf_grid *a, const sf_grid *b)
{
    if (a == NULL || b == NULL || a->lattice.nx != b->lattice.nx ||
        a->lattice.ny != b->lattice.ny || a->lattice.nz != b->lattice.nz) {
        return 0;
    }
    for (uint32_t k = 0; k < a->lattice.nz; k++) {
        if (!sf_slice_equal(sf_grid_slice(a, k), sf_grid_slice(b, k))) {
            return 0;
        }
    }
    return 1;
}

sf_status sfi_grid_copy(sf_grid *to, const sf_grid *from)
{
    for (uint32_t k = 0; k < to->lattice.nz; k++) {
        SF_TRY(sf_slice_copy(sf_grid_slice(to, k), sf_grid_slice(from, k)));
    }
    return SF_OK;
}

int sfi_grid_within(const sf_grid *part, const sf_grid *whole)
{
    uint32_t width = part->lattice.nx;
    for (uint32_t k = 0; k < part->lattice.nz; k++) {
        sf_slice a = sf_grid_slice(part, k), b = sf_grid_slice(whole, k);
        for (uint32_t y = 0; y < a.height; y++) {
            const uint64_t *p = sfi_slice_row(a, y), *q = sfi_slice_row(b, y);
            uint64_t out = 0;
            for (size_t i = 0; i < sfi_row_words(width); i++) {
                out |= sfi_row_word(p, i, width) & ~q[i];
            }
            if (out != 0) {
                return 0;
            }
        }
    }
    return 1;
}

uint64_t sf_grid_popcount(const sf_grid *grid)
{
    uint64_t sum = 0;
    for (uint32_t k = 0; grid != NULL && k < grid->lattice.nz; k++) {
        sum += sf_slice_popcount(sf_grid_slice(grid, k));
    }
    return sum;
}

sf_box sf_grid_bounds(const sf_grid *grid)
{
    sf_box box = {0, 0, 0, 0, 0, 0};
    for (uint32_t k = 0; grid != NULL && k < grid->lattice.nz; k++) {
        box = sfi_box_union(box, sf_slice_bounds(sf_grid_slice(grid, k)), k);
    }
    return box;
}

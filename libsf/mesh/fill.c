// SPDX-License-Identifier: MIT
// Filling layers: what one thread does.
//
// A window of rows is filled by collecting its crossings in a buffer of fixed size; when they do
// not fit, the window is halved, down to a single row, whose crossings can be summed piecemeal. So
// memory is bounded, nothing is allocated, and nothing can fail.

#include "mesh/fill.h"

#include "base/status.h"
#include "mesh/shell.h"
#include "simd/kernels.h"

#include <string.h>

#define CROSSINGS 65536u // capacity of a lane's buffer

static sf_slice target_slice(const sfi_target *to, uint32_t k)
{
    return to->grid != NULL ? sf_grid_slice(to->grid, k) : to->slice;
}

// A cancelled call leaves at once; whoever asked sees that it was.
static int stopped(const sfi_target *to)
{
    return sf_task_is_cancelled(to->task);
}

// Crossings of the window, from a list of triangles. Returns 0 when the window must be halved.
static int collect(const sf_voxelizer *v, sfi_lane *lane, const uint32_t *list, size_t count,
                   sfi_window window)
{
    size_t rows = (size_t)(window.k1 - window.k0) * (window.y1 - window.y0);
    size_t done = 0;
    while (done < count) {
        done += sfi_crossings_add(&lane->crossings, &v->frame, &v->skin, list + done, count - done,
                                  window);
        if (done < count && rows > 1) {
            return 0;
        }
        if (done < count) {
            sfi_lane_spill(lane);
        }
    }
    return 1;
}

static void fill_row(const sf_voxelizer *v, sfi_fill_lane *lane, sfi_window window, uint32_t y,
                     uint32_t k, sf_slice slice)
{
    uint64_t *words = slice.words + (size_t)y * slice.stride;
    size_t row = (size_t)(k - window.k0) * (window.y1 - window.y0) + (y - window.y0);
    if (v->skin.winding.node_count > 0) {
        size_t changes = sfi_lane_row(&lane->rows, row);
        sfi_row_fill_open(&lane->rows, &lane->holes, changes, &v->frame, &v->skin, y, k, words);
    } else {
        sfi_lane_fill(&lane->rows, row, v->fill, words);
    }
}

// The bits of n that stand at even places, close together.
static uint32_t even_bits(uint32_t n)
{
    uint32_t bits = 0;
    for (uint32_t i = 0; n >> 2 * i != 0; i++) {
        bits |= (n >> 2 * i & 1) << i;
    }
    return bits;
}

// Where there are holes: box by box, and in a box by the boxes within, halves within halves.
static void fill_tile(const sf_voxelizer *v, sfi_fill_lane *lane, sfi_window window, uint32_t y0,
                      uint32_t k0, const sfi_target *to)
{
    for (uint32_t i = 0; i < SFI_HOLE_BOX * SFI_HOLE_BOX && !stopped(to); i++) {
        uint32_t y = y0 + even_bits(i), k = k0 + even_bits(i >> 1);
        if (y >= window.y0 && y < window.y1 && k >= window.k0 && k < window.k1) {
            fill_row(v, lane, window, y, k, target_slice(to, k));
        }
    }
}

static void fill_rows(const sf_voxelizer *v, sfi_fill_lane *lane, sfi_window window,
                      const sfi_target *to)
{
    if (v->skin.winding.node_count == 0) {
        for (uint32_t k = window.k0; k < window.k1 && !stopped(to); k++) {
            sf_slice slice = target_slice(to, k);
            for (uint32_t y = window.y0; y < window.y1; y++) {
                fill_row(v, lane, window, y, k, slice);
            }
        }
        return;
    }
    const uint32_t side = SFI_HOLE_BOX;
    for (uint32_t k = window.k0 / side * side; k < window.k1; k += side) {
        for (uint32_t y = window.y0 / side * side; y < window.y1; y += side) {
            fill_tile(v, lane, window, y, k, to);
        }
    }
}

static int fill_window(const sf_voxelizer *v, sfi_fill_lane *lane, sfi_window window,
                       const sfi_target *to)
{
    uint32_t width = window.y1 - window.y0;
    size_t rows = (size_t)(window.k1 - window.k0) * width, count;
    const uint32_t *list = sfi_buckets_slab(&v->buckets, window.k0, &count);
    sfi_lane_clear(&lane->rows, rows);
    if (!collect(v, &lane->rows, list, count, window) ||
        !collect(v, &lane->rows, v->buckets.tall, v->buckets.tall_count, window)) {
        return 0;
    }
    if (!lane->rows.spilled) {
        sfi_lane_sort(&lane->rows, rows);
    }
    fill_rows(v, lane, window, to);
    return 1;
}

// In windows as large as the buffer allows.
static void fill_by_crossings(const sf_voxelizer *v, sfi_fill_lane *lane, uint32_t k0, uint32_t k1,
                              const sfi_target *to)
{
    uint32_t layers = k1 - k0, width = v->frame.ny;
    while (k0 < k1 && !stopped(to)) {
        uint32_t y = 0;
        layers = layers < k1 - k0 ? layers : k1 - k0;
        while (y < v->frame.ny && !stopped(to)) {
            uint32_t y1 = width < v->frame.ny - y ? y + width : v->frame.ny;
            sfi_window window = {k0, k0 + layers, y, y1};
            if (fill_window(v, lane, window, to)) {
                y = y1;
            } else if (layers > 1) {
                layers = (layers + 1) / 2;
            } else {
                width = (y1 - y + 1) / 2;
            }
        }
        k0 += layers;
    }
}

static void fill_by_touch(const sf_voxelizer *v, sfi_fill_lane *lane, uint32_t k0, uint32_t k1,
                          const sfi_target *to)
{
    size_t count;
    const uint32_t *list = sfi_buckets_slab(&v->buckets, k0, &count);
    for (uint32_t k = k0; k < k1 && !stopped(to); k++) {
        sf_slice slice = target_slice(to, k);
        for (uint32_t y = 0; y < slice.height; y++) {
            memset(slice.words + (size_t)y * slice.stride, 0, sfi_row_words(slice.width) * 8);
        }
        sfi_shell_add(&v->frame, &v->skin, list, count, k, slice);
        sfi_shell_add(&v->frame, &v->skin, v->buckets.tall, v->buckets.tall_count, k, slice);
        lane->rows.solid_voxels += sf_slice_popcount(slice);
    }
}

void sfi_fill_layers(const sf_voxelizer *v, sfi_fill_lane *lane, uint32_t k0, uint32_t k1,
                     const sfi_target *to)
{
    if (v->fill == SF_FILL_SURFACE) {
        fill_by_touch(v, lane, k0, k1, to);
    } else {
        fill_by_crossings(v, lane, k0, k1, to);
    }
}

void sfi_fill_reach(const sfi_frame *frame, const sfi_skin *skin, size_t triangle, uint32_t *k0,
                    uint32_t *k1)
{
    const uint32_t *corner = skin->triangles + 3 * triangle;
    int32_t low = INT32_MAX, high = INT32_MIN;
    for (int i = 0; i < 3; i++) {
        int32_t z = skin->points[corner[i]].z;
        low = z < low ? z : low;
        high = z > high ? z : high;
    }
    sfi_frame_layers(frame, low, high, k0, k1);
}

sf_status sfi_fill_lane_create(const sf_voxelizer *v, sfi_fill_lane *lane)
{
    memset(lane, 0, sizeof *lane);
    size_t rows = (size_t)v->buckets.layers * v->frame.ny;
    SF_TRY(sfi_lane_create(v->frame.nx, rows, CROSSINGS, &v->allocator, &lane->rows));
    if (v->skin.winding.node_count == 0) {
        return SF_OK;
    }
    sf_status status = sfi_hole_lane_create(v->frame.nx, &v->allocator, &lane->holes);
    if (status != SF_OK) {
        sfi_lane_destroy(&lane->rows, &v->allocator);
    }
    return status;
}

void sfi_fill_lane_destroy(sfi_fill_lane *lane, const sf_allocator *allocator)
{
    sfi_hole_lane_destroy(&lane->holes, allocator);
    sfi_lane_destroy(&lane->rows, allocator);
}

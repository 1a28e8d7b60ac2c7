// SPDX-License-Identifier: MIT
// Rays through a grid: a 3-D digital differential analyser over voxels, and over blocks of 8 x 8 x
// 8 voxels where these hold no matter.
//
// From the cell that a ray is in, the distances to the three planes ahead say which face it leaves
// by (J. Amanatides, A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics
// 1987). Planes are looked up, not accumulated, so that layers of different heights cost nothing
// and a jump over an empty block is a step like any other, only with planes further away.
//
// A voxel has six normals, which would make every slope look like stairs. The normal of a hit is
// the way from the centre of the matter in a small ball around it to the centre of the ball. Where
// the shape stands on a bed it is continued below as in a mirror, so that its foot is not taken for
// an edge and drawn dark.

#include "volume.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK = 8, REACH = 6 };

// ---------------------------------------------------------------------------------------------
// Making ready
// ---------------------------------------------------------------------------------------------

// Words of a row, and one of them, in which whatever stands past the width reads as empty.
static size_t row_words(sf_slice slice)
{
    return ((size_t)slice.width + 63) / 64;
}

static uint64_t row_word(sf_slice slice, uint32_t y, size_t i)
{
    uint64_t word = slice.words[(size_t)y * slice.stride + i];
    unsigned past = i + 1 == row_words(slice) ? (64 - slice.width % 64) % 64 : 0;
    return word << past >> past;
}

static void mark_blocks(volume *v, uint32_t k)
{
    sf_slice slice = sf_grid_slice(v->grid, k);
    for (uint32_t y = 0; y < slice.height; y++) {
        uint8_t *blocks = v->blocks + ((size_t)(k / BLOCK) * v->block_ny + y / BLOCK) * v->block_nx;
        for (size_t w = 0; w < row_words(slice); w++) {
            uint64_t word = row_word(slice, y, w);
            for (uint32_t byte = 0; word != 0; byte++, word >>= 8) {
                if ((word & 255) != 0) {
                    blocks[8 * w + byte] = 1;
                }
            }
        }
    }
}

int volume_create(volume *v, const sf_grid *grid)
{
    memset(v, 0, sizeof *v);
    v->grid = grid;
    v->mirror = INT64_MIN;
    v->lattice = sf_grid_lattice(grid);
    v->block_nx = (v->lattice.nx + BLOCK - 1) / BLOCK;
    v->block_ny = (v->lattice.ny + BLOCK - 1) / BLOCK;
    v->block_nz = (v->lattice.nz + BLOCK - 1) / BLOCK;
    v->floors_mm = malloc(((size_t)v->lattice.nz + 1) * sizeof *v->floors_mm);
    v->blocks = calloc((size_t)v->block_nx * v->block_ny, v->block_nz);
    if (v->floors_mm == NULL || v->blocks == NULL) {
        volume_destroy(v);
        return 0;
    }
    v->floors_mm[0] = v->lattice.origin_mm[2];
    for (uint32_t k = 0; k < v->lattice.nz; k++) {
        v->floors_mm[k + 1] = v->floors_mm[k] + sf_lattice_layer_height(&v->lattice, k);
        mark_blocks(v, k);
    }
    return 1;
}

void volume_destroy(volume *v)
{
    free(v->floors_mm);
    free(v->blocks);
    memset(v, 0, sizeof *v);
}

// ---------------------------------------------------------------------------------------------
// Marching
// ---------------------------------------------------------------------------------------------

static double plane(const volume *v, int axis, int64_t index)
{
    switch (axis) {
    case 0:
        return v->lattice.origin_mm[0] + (double)index * v->lattice.pitch_x_mm;
    case 1:
        return v->lattice.origin_mm[1] + (double)index * v->lattice.pitch_y_mm;
    default:
        return v->floors_mm[index];
    }
}

// The cell in low..high (inclusive) that a coordinate lies in, or the nearest.
static int64_t locate(const volume *v, int axis, double coordinate, int64_t low, int64_t high)
{
    if (axis == 2) {
        while (low < high) {
            int64_t middle = low + (high - low) / 2;
            if (v->floors_mm[middle + 1] <= coordinate) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }
    double pitch = axis == 0 ? v->lattice.pitch_x_mm : v->lattice.pitch_y_mm;
    double index = floor((coordinate - v->lattice.origin_mm[axis]) / pitch);
    return index < (double)low ? low : index > (double)high ? high : (int64_t)index;
}

// Part of the ray that lies in the grid's box. Returns 0 when none does.
static int clip(const volume *v, const int64_t count[3], const double origin[3],
                const double direction[3], double *enter, double *leave)
{
    *enter = 0;
    *leave = INFINITY;
    for (int axis = 0; axis < 3; axis++) {
        double low = plane(v, axis, 0), high = plane(v, axis, count[axis]);
        if (direction[axis] == 0) {
            if (origin[axis] < low || origin[axis] >= high) {
                return 0;
            }
            continue;
        }
        double a = (low - origin[axis]) / direction[axis];
        double b = (high - origin[axis]) / direction[axis];
        *enter = fmax(*enter, fmin(a, b));
        *leave = fmin(*leave, fmax(a, b));
    }
    return *enter < *leave;
}

static int is_solid(const volume *v, const int64_t cell[3])
{
    sf_slice slice = sf_grid_slice(v->grid, (uint32_t)cell[2]);
    return (int)(slice.words[(size_t)cell[1] * slice.stride + (size_t)(cell[0] / 64)] >>
                     (cell[0] % 64) &
                 1);
}

static int block_is_empty(const volume *v, const int64_t cell[3])
{
    return !v->blocks[((size_t)(cell[2] / BLOCK) * v->block_ny + (size_t)(cell[1] / BLOCK)) *
                          v->block_nx +
                      (size_t)(cell[0] / BLOCK)];
}

// Go from a cell, or from the empty block around it, through the face that the ray leaves by.
// Returns 0 when that leads out of the grid.
static int step(const volume *v, const int64_t count[3], const double origin[3],
                const double direction[3], int whole_block, int64_t cell[3], double *t)
{
    int64_t low[3], high[3]; // cells of this stride
    int face = -1;
    double nearest = INFINITY;
    for (int axis = 0; axis < 3; axis++) {
        low[axis] = whole_block ? cell[axis] / BLOCK * BLOCK : cell[axis];
        high[axis] = whole_block ? low[axis] + BLOCK - 1 : cell[axis];
        high[axis] = high[axis] < count[axis] ? high[axis] : count[axis] - 1;
        if (direction[axis] != 0) {
            int64_t ahead = direction[axis] > 0 ? high[axis] + 1 : low[axis];
            double at = (plane(v, axis, ahead) - origin[axis]) / direction[axis];
            if (at < nearest) {
                nearest = at;
                face = axis;
            }
        }
    }
    *t = nearest > *t ? nearest : *t;
    for (int axis = 0; axis < 3; axis++) {
        if (axis == face) {
            cell[axis] = direction[axis] > 0 ? high[axis] + 1 : low[axis] - 1;
        } else if (whole_block) {
            double at = origin[axis] + *t * direction[axis];
            cell[axis] = locate(v, axis, at, low[axis], high[axis]);
        }
    }
    return face >= 0 && cell[face] >= 0 && cell[face] < count[face];
}

int volume_march(const volume *v, const double origin_mm[3], const double direction[3], hit *found)
{
    const int64_t count[3] = {v->lattice.nx, v->lattice.ny, v->lattice.nz};
    double t, leave;
    int64_t cell[3];
    if (!clip(v, count, origin_mm, direction, &t, &leave)) {
        return 0;
    }
    for (int axis = 0; axis < 3; axis++) {
        double at = origin_mm[axis] + t * direction[axis];
        cell[axis] = locate(v, axis, at, 0, count[axis] - 1);
    }
    for (;;) {
        int empty = block_is_empty(v, cell);
        if (!empty && is_solid(v, cell)) {
            found->t = t;
            found->x = (uint32_t)cell[0];
            found->y = (uint32_t)cell[1];
            found->z = (uint32_t)cell[2];
            return 1;
        }
        if (!step(v, count, origin_mm, direction, empty, cell, &t)) {
            return 0;
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Normals
// ---------------------------------------------------------------------------------------------

// Voxels x - REACH .. x + REACH of a row, as bits 0 .. 2 * REACH; what lies outside is empty.
static uint64_t window(const volume *v, int64_t x, int64_t y, int64_t z)
{
    z = z < v->mirror ? 2 * v->mirror - 1 - z : z;
    if (y < 0 || y >= v->lattice.ny || z < 0 || z >= v->lattice.nz) {
        return 0;
    }
    sf_slice slice = sf_grid_slice(v->grid, (uint32_t)z);
    size_t at = (size_t)x / 64;
    uint32_t row = (uint32_t)y;
    int64_t shift = x % 64;
    uint64_t here = row_word(slice, row, at), before = at > 0 ? row_word(slice, row, at - 1) : 0;
    uint64_t after = at + 1 < row_words(slice) ? row_word(slice, row, at + 1) : 0;
    uint64_t bits = shift < REACH ? here << (REACH - shift) | before >> (64 - REACH + shift)
                                  : here >> (shift - REACH);
    if (shift + REACH > 63) {
        bits |= after << (64 - shift + REACH);
    }
    return bits & ((UINT64_C(1) << (2 * REACH + 1)) - 1);
}

void volume_look_around(const volume *v, hit *found)
{
    int sum[3] = {0, 0, 0}, solid = 0, total = 0;
    for (int dz = -REACH; dz <= REACH; dz++) {
        for (int dy = -REACH; dy <= REACH; dy++) {
            int left = (2 * REACH + 1) * (2 * REACH + 1) / 4 - dy * dy - dz * dz;
            if (left < 0) {
                continue;
            }
            int half = (int)sqrt((double)left);
            uint64_t bits = window(v, found->x, (int64_t)found->y + dy, (int64_t)found->z + dz);
            total += 2 * half + 1;
            for (int dx = -half; bits != 0 && dx <= half; dx++) {
                int bit = (int)(bits >> (dx + REACH) & 1);
                sum[0] += bit * dx;
                sum[1] += bit * dy;
                sum[2] += bit * dz;
                solid += bit;
            }
        }
    }
    const double pitch[3] = {v->lattice.pitch_x_mm, v->lattice.pitch_y_mm,
                             sf_lattice_layer_height(&v->lattice, found->z)};
    double length = 0;
    for (int i = 0; i < 3; i++) {
        found->normal[i] = -sum[i] / pitch[i];
        length += found->normal[i] * found->normal[i];
    }
    for (int i = 0; i < 3; i++) {
        found->normal[i] = length > 0 ? found->normal[i] / sqrt(length) : i == 2;
    }
    found->openness = 1 - (double)solid / total;
}

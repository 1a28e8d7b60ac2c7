// SPDX-License-Identifier: MIT
// Rays through a grid: a 3-D digital differential analyser over the voxels of a block of 8 x 8 x 8,
// and jumps over cubes of blocks that hold no matter.
//
// From the cell that a ray is in, the distances to the three planes ahead say which face it leaves
// by (J. Amanatides, A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics
// 1987). Planes are looked up, not accumulated, so that layers of different heights cost nothing
// and a jump is a step like any other, only with planes further away. How far away, a distance map
// of the blocks says (D. Cohen, Z. Sheffer, "Proximity clouds, an acceleration technique for 3D
// grids", 1994): the longest of the three distances, which is exact after one sweep each way.
//
// A voxel has six normals, which would make every slope look like stairs. The normal of a hit is
// the way from the centre of the matter in a small ball around it to the centre of the ball. Where
// the shape stands on a bed it is continued below as in a mirror, so that its foot is not taken for
// an edge and drawn dark.

#include "volume.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK = 8, REACH = 6, WINDOWS = 1 << (2 * REACH + 1) };

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

static uint8_t *gap_at(const volume *v, int64_t x, int64_t y, int64_t z)
{
    return v->gaps + ((size_t)z * v->block_ny + (size_t)y) * v->block_nx + (size_t)x;
}

static void mark_blocks(volume *v, uint32_t k)
{
    sf_slice slice = v->slices[k];
    for (uint32_t y = 0; y < slice.height; y++) {
        uint8_t *gaps = gap_at(v, 0, y / BLOCK, k / BLOCK);
        for (size_t w = 0; w < row_words(slice); w++) {
            uint64_t word = row_word(slice, y, w);
            for (uint32_t byte = 0; word != 0; byte++, word >>= 8) {
                if ((word & 255) != 0) {
                    gaps[8 * w + byte] = 0;
                }
            }
        }
    }
}

// One more than the least gap among the neighbours that a sweep has been at: the 13 before a block
// in the order of rows and layers, or the 13 behind it.
static void lower_gap(const volume *v, const int64_t at[3], int way)
{
    uint8_t *gap = gap_at(v, at[0], at[1], at[2]);
    for (int i = 0; i < 13 && *gap > 0; i++) {
        int64_t x = at[0] + way * (i % 3 - 1), y = at[1] + way * (i / 3 % 3 - 1);
        int64_t z = at[2] + way * (i / 9 - 1);
        if (x >= 0 && x < v->block_nx && y >= 0 && y < v->block_ny && z >= 0 && z < v->block_nz) {
            uint8_t near = *gap_at(v, x, y, z);
            *gap = near < *gap ? (uint8_t)(near + 1) : *gap;
        }
    }
}

static void measure_gaps(volume *v)
{
    int64_t row = v->block_nx, layer = row * v->block_ny, count = layer * v->block_nz;
    for (int way = 1; way >= -1; way -= 2) {
        for (int64_t i = 0; i < count; i++) {
            int64_t b = way > 0 ? i : count - 1 - i;
            const int64_t at[3] = {b % row, b % layer / row, b / layer};
            lower_gap(v, at, way);
        }
    }
}

// How many of the voxels of a window are solid, and the sum of their places.
static void count_windows(volume *v)
{
    for (uint32_t bits = 0; bits < WINDOWS; bits++) {
        for (int dx = -REACH; dx <= REACH; dx++) {
            int bit = (int)(bits >> (dx + REACH) & 1);
            v->windows[bits].solid += (int8_t)bit;
            v->windows[bits].sum += (int8_t)(bit * dx);
        }
    }
}

int volume_create(volume *v, const sf_grid *grid)
{
    memset(v, 0, sizeof *v);
    v->mirror = INT64_MIN;
    v->lattice = sf_grid_lattice(grid);
    v->bounds = sf_grid_bounds(grid);
    v->block_nx = (v->lattice.nx + BLOCK - 1) / BLOCK;
    v->block_ny = (v->lattice.ny + BLOCK - 1) / BLOCK;
    v->block_nz = (v->lattice.nz + BLOCK - 1) / BLOCK;
    size_t blocks = (size_t)v->block_nx * v->block_ny * v->block_nz;
    v->floors_mm = malloc(((size_t)v->lattice.nz + 1) * sizeof *v->floors_mm);
    v->slices = malloc(v->lattice.nz * sizeof *v->slices);
    v->gaps = malloc(blocks);
    v->windows = calloc(WINDOWS, sizeof *v->windows);
    if (v->floors_mm == NULL || v->slices == NULL || v->gaps == NULL || v->windows == NULL) {
        volume_destroy(v);
        return 0;
    }
    memset(v->gaps, UINT8_MAX, blocks);
    v->floors_mm[0] = v->lattice.origin_mm[2];
    for (uint32_t k = 0; k < v->lattice.nz; k++) {
        v->floors_mm[k + 1] = v->floors_mm[k] + sf_lattice_layer_height(&v->lattice, k);
        v->slices[k] = sf_grid_slice(grid, k);
        mark_blocks(v, k);
    }
    measure_gaps(v);
    count_windows(v);
    return 1;
}

void volume_destroy(volume *v)
{
    free(v->floors_mm);
    free(v->slices);
    free(v->gaps);
    free(v->windows);
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

// A ray, and the cells that it can meet: low..high (inclusive).
typedef struct ray {
    const double *origin, *direction;
    double inverse[3]; // of the direction
    int64_t low[3], high[3];
} ray;

// Where the ray meets a plane; never, where it runs along it.
static double meets(const volume *v, const ray *r, int axis, int64_t index)
{
    return r->direction[axis] != 0 ? (plane(v, axis, index) - r->origin[axis]) * r->inverse[axis]
                                   : INFINITY;
}

// Part of the ray that lies in the box of all matter. Returns 0 when none does.
static int clip(const volume *v, const ray *r, double *enter)
{
    double leave = INFINITY;
    *enter = 0;
    for (int axis = 0; axis < 3; axis++) {
        double low = plane(v, axis, r->low[axis]), high = plane(v, axis, r->high[axis] + 1);
        if (r->direction[axis] == 0) {
            if (r->origin[axis] < low || r->origin[axis] >= high) {
                return 0;
            }
            continue;
        }
        double a = meets(v, r, axis, r->low[axis]), b = meets(v, r, axis, r->high[axis] + 1);
        double near = a < b ? a : b, far = a < b ? b : a;
        *enter = near > *enter ? near : *enter;
        leave = far < leave ? far : leave;
    }
    return *enter < leave;
}

static int is_solid(const volume *v, const int64_t cell[3])
{
    sf_slice slice = v->slices[cell[2]];
    return (int)(slice.words[(size_t)cell[1] * slice.stride + (size_t)(cell[0] / 64)] >>
                     (cell[0] % 64) &
                 1);
}

static int smallest(const double t[3])
{
    int least = t[0] <= t[1] ? 0 : 1;
    return t[2] < t[least] ? 2 : least;
}

// Go voxel by voxel to the first solid one of a block: 1; or out of the block: 0; or out of the box
// of all matter: -1.
static int cross_block(const volume *v, const ray *r, int64_t cell[3], double *t)
{
    double ahead[3];
    for (int axis = 0; axis < 3; axis++) {
        ahead[axis] = meets(v, r, axis, cell[axis] + (r->direction[axis] > 0));
    }
    while (!is_solid(v, cell)) {
        int face = smallest(ahead);
        int64_t from = cell[face];
        *t = ahead[face] > *t ? ahead[face] : *t;
        cell[face] += r->direction[face] > 0 ? 1 : -1;
        if (cell[face] < r->low[face] || cell[face] > r->high[face]) {
            return -1;
        }
        if (cell[face] / BLOCK != from / BLOCK) {
            return 0;
        }
        ahead[face] = meets(v, r, face, cell[face] + (r->direction[face] > 0));
    }
    return 1;
}

// Go through the face by which the ray leaves the empty cube around a cell, that many blocks each
// way from the cell's own. Returns 0 when that leads out of the box of all matter.
static int jump(const volume *v, const ray *r, int64_t gap, int64_t cell[3], double *t)
{
    int64_t low[3], high[3];
    double ahead[3];
    for (int axis = 0; axis < 3; axis++) {
        int64_t block = cell[axis] / BLOCK;
        low[axis] = (block - gap + 1) * BLOCK;
        high[axis] = (block + gap) * BLOCK - 1;
        low[axis] = low[axis] > r->low[axis] ? low[axis] : r->low[axis];
        high[axis] = high[axis] < r->high[axis] ? high[axis] : r->high[axis];
        ahead[axis] = meets(v, r, axis, r->direction[axis] > 0 ? high[axis] + 1 : low[axis]);
    }
    int face = smallest(ahead);
    *t = ahead[face] > *t ? ahead[face] : *t;
    for (int axis = 0; axis < 3; axis++) {
        double at = r->origin[axis] + *t * r->direction[axis];
        cell[axis] = axis != face             ? locate(v, axis, at, low[axis], high[axis])
                     : r->direction[axis] > 0 ? high[axis] + 1
                                              : low[axis] - 1;
    }
    return cell[face] >= r->low[face] && cell[face] <= r->high[face];
}

int volume_march(const volume *v, const double origin_mm[3], const double direction[3], hit *found)
{
    ray r = {origin_mm,
             direction,
             {1 / direction[0], 1 / direction[1], 1 / direction[2]},
             {v->bounds.x0, v->bounds.y0, v->bounds.z0},
             {(int64_t)v->bounds.x1 - 1, (int64_t)v->bounds.y1 - 1, (int64_t)v->bounds.z1 - 1}};
    double t;
    int64_t cell[3] = {0, 0, 0};
    int met = clip(v, &r, &t) ? 0 : -1;
    for (int axis = 0; met == 0 && axis < 3; axis++) {
        cell[axis] =
            locate(v, axis, origin_mm[axis] + t * direction[axis], r.low[axis], r.high[axis]);
    }
    while (met == 0) {
        int64_t gap = *gap_at(v, cell[0] / BLOCK, cell[1] / BLOCK, cell[2] / BLOCK);
        if (gap == 0) {
            met = cross_block(v, &r, cell, &t);
        } else {
            met = jump(v, &r, gap, cell, &t) ? 0 : -1;
        }
    }
    if (met > 0) {
        found->t = t;
        found->x = (uint32_t)cell[0];
        found->y = (uint32_t)cell[1];
        found->z = (uint32_t)cell[2];
    }
    return met > 0;
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
    sf_slice slice = v->slices[z];
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
    return bits & (WINDOWS - 1);
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
            bits &= (UINT64_C(1) << (REACH + half + 1)) - (UINT64_C(1) << (REACH - half));
            total += 2 * half + 1;
            solid += v->windows[bits].solid;
            sum[0] += v->windows[bits].sum;
            sum[1] += v->windows[bits].solid * dy;
            sum[2] += v->windows[bits].solid * dz;
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

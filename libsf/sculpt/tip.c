// SPDX-License-Identifier: MIT
// Tips: the voxels that a brush covers.
//
// A tip is a mask, cut to the box around its voxels, and an anchor. It is kept mirrored as well,
// along x, along y and along both, because a stroke with mirrors puts it so; of these only what
// looks different takes memory, and what a formula makes never does.

#include "sculpt/tip.h"

#include <math.h>

#include "base/memory.h"
#include "base/status.h"
#include "voxel/grid.h"
#include "voxel/slice.h"
#include "voxel/stamp.h"

#define EXTENT_MAX 4096u
#define RADIUS_MAX 1024.0

static sf_lattice plain_lattice(uint32_t nx, uint32_t ny, uint32_t nz)
{
    sf_lattice lattice = {nx, ny, nz, 1, 1, 1, NULL, {0, 0, 0}};
    return lattice;
}

// ---------------------------------------------------------------------------------------------
// Life
// ---------------------------------------------------------------------------------------------

static void set_all(sf_grid *to, const sf_grid *from, unsigned way)
{
    sf_lattice lattice = sf_grid_lattice(from);
    for (uint32_t z = 0; z < lattice.nz; z++) {
        sf_slice in = sf_grid_slice(from, z), out = sf_grid_slice(to, z);
        for (uint32_t y = 0; y < lattice.ny; y++) {
            for (uint32_t x = 0; x < lattice.nx; x++) {
                if (sf_slice_get(in, x, y)) {
                    (void)!sf_slice_set(out, way & 1 ? lattice.nx - 1 - x : x,
                                        way & 2 ? lattice.ny - 1 - y : y, 1);
                }
            }
        }
    }
}

// The mask of one way, made unless it looks like one that is there.
static sf_status flip(sf_tip *tip, unsigned way)
{
    sf_grid *mirrored;
    sf_lattice lattice = sf_grid_lattice(tip->masks[0]);
    SF_TRY(sf_grid_create(&lattice, &tip->allocator, &mirrored));
    set_all(mirrored, tip->masks[0], way);
    for (unsigned i = 0; i < way; i++) {
        if (sf_grid_equal(mirrored, tip->masks[i])) {
            sf_grid_destroy(mirrored);
            mirrored = tip->masks[i];
            break;
        }
    }
    tip->masks[way] = mirrored;
    return SF_OK;
}

// A tip of a mask, which it takes over, also when it fails. is_even: it looks the same mirrored.
static sf_status adopt(sf_grid *mask, sf_dab anchor, int is_even, const sf_allocator *allocator,
                       sf_tip **tip)
{
    sf_lattice lattice = sf_grid_lattice(mask);
    sf_tip *made = sfi_alloc_array(allocator, 1, sizeof *made);
    if (made == NULL) {
        sf_grid_destroy(mask);
        return SF_ERR_MEMORY;
    }
    sf_tip empty = {.allocator = *allocator};
    *made = empty;
    made->masks[0] = mask;
    for (unsigned way = 0; way < SFI_FLIP_COUNT; way++) {
        sf_dab a = anchor;
        a.x = way & 1 ? (int32_t)lattice.nx - 1 - a.x : a.x;
        a.y = way & 2 ? (int32_t)lattice.ny - 1 - a.y : a.y;
        made->anchors[way] = a;
        made->masks[way] = is_even ? mask : made->masks[way];
        sf_status status = made->masks[way] == NULL ? flip(made, way) : SF_OK;
        if (status != SF_OK) {
            sf_tip_destroy(made);
            return status;
        }
    }
    *tip = made;
    return SF_OK;
}

void sf_tip_destroy(sf_tip *tip)
{
    if (tip == NULL) {
        return;
    }
    sf_allocator allocator = tip->allocator;
    for (unsigned way = SFI_FLIP_COUNT; way-- > 0;) {
        int is_shared = 0;
        for (unsigned i = 0; i < way; i++) {
            is_shared |= tip->masks[i] == tip->masks[way];
        }
        if (!is_shared) {
            sf_grid_destroy(tip->masks[way]);
        }
    }
    sfi_free_array(&allocator, tip, 1, sizeof *tip);
}

const sf_grid *sf_tip_mask(const sf_tip *tip, sf_dab *anchor)
{
    if (tip != NULL && anchor != NULL) {
        *anchor = tip->anchors[0];
    }
    return tip != NULL ? tip->masks[0] : NULL;
}

// ---------------------------------------------------------------------------------------------
// By formula
// ---------------------------------------------------------------------------------------------

// |d| over the radius, where a radius of 0 leaves only 0.
static double share(double d, double radius)
{
    return d == 0 ? 0 : radius > 0 ? d / radius : 2;
}

// Whether the voxel at (dx, dy, dz) from the anchor lies in the shape.
static int is_inside(sf_tip_shape shape, const double r[3], double dx, double dy, double dz)
{
    double a = share(fabs(dx), r[0]), b = share(fabs(dy), r[1]), c = share(fabs(dz), r[2]);
    double wide = r[2] > 0 ? (r[2] - dz) / (2 * r[2]) : 1; // of the cone, at this height
    switch (shape) {
    case SF_TIP_SPHERE:
        return a * a + b * b + c * c <= 1;
    case SF_TIP_BOX:
        return a <= 1 && b <= 1 && c <= 1;
    case SF_TIP_CYLINDER:
        return a * a + b * b <= 1 && c <= 1;
    default:
        return a * a + b * b <= wide * wide && c <= 1;
    }
}

// All shapes are even and convex along x: a row is from -w to w.
static void draw(sf_tip_shape shape, const double r[3], sf_grid *mask)
{
    sf_lattice lattice = sf_grid_lattice(mask);
    uint32_t mx = lattice.nx / 2, my = lattice.ny / 2, mz = lattice.nz / 2;
    for (uint32_t z = 0; z < lattice.nz; z++) {
        for (uint32_t y = 0; y < lattice.ny; y++) {
            double dy = (double)y - my, dz = (double)z - mz;
            uint32_t low = 0, high = mx + 1; // the row reaches to below `low`, not to `high`
            while (low < high) {
                uint32_t w = low + (high - low) / 2;
                if (is_inside(shape, r, w, dy, dz)) {
                    low = w + 1;
                } else {
                    high = w;
                }
            }
            sf_rect row = {mx + 1 - low, y, mx + low, y + 1};
            if (low > 0) {
                (void)!sf_slice_fill(sf_grid_slice(mask, z), row, 1);
            }
        }
    }
}

sf_status sf_tip_create(sf_tip_shape shape, const double radius_vx[3],
                        const sf_allocator *allocator, sf_tip **tip)
{
    if (radius_vx == NULL || tip == NULL || (int)shape < SF_TIP_SPHERE || shape > SF_TIP_CONE) {
        return SF_ERR_ARGUMENT;
    }
    sf_dab anchor;
    int32_t *reach[3] = {&anchor.x, &anchor.y, &anchor.z};
    for (int i = 0; i < 3; i++) {
        if (!(radius_vx[i] >= 0 && radius_vx[i] <= RADIUS_MAX)) {
            return SF_ERR_ARGUMENT;
        }
        *reach[i] = (int32_t)radius_vx[i];
    }
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_lattice lattice = plain_lattice((uint32_t)anchor.x * 2 + 1, (uint32_t)anchor.y * 2 + 1,
                                       (uint32_t)anchor.z * 2 + 1);
    sf_grid *mask;
    SF_TRY(sf_grid_create(&lattice, &from, &mask));
    draw(shape, radius_vx, mask);
    return adopt(mask, anchor, 1, &from, tip);
}

// ---------------------------------------------------------------------------------------------
// Of a mask, of an image
// ---------------------------------------------------------------------------------------------

sf_status sf_tip_create_mask(const sf_grid *mask, sf_dab anchor, const sf_allocator *allocator,
                             sf_tip **tip)
{
    if (mask == NULL || tip == NULL || !sfi_dab_is_valid(anchor)) {
        return SF_ERR_ARGUMENT;
    }
    sf_box b = sf_grid_bounds(mask);
    if (b.x1 == 0) {
        return SF_ERR_ARGUMENT; // nothing is solid
    }
    if (b.x1 - b.x0 > EXTENT_MAX || b.y1 - b.y0 > EXTENT_MAX || b.z1 - b.z0 > EXTENT_MAX) {
        return SF_ERR_OVERFLOW;
    }
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_lattice lattice = plain_lattice(b.x1 - b.x0, b.y1 - b.y0, b.z1 - b.z0);
    int64_t by[3] = {-(int64_t)b.x0, -(int64_t)b.y0, -(int64_t)b.z0};
    sf_grid *part;
    SF_TRY(sf_grid_create(&lattice, &from, &part));
    (void)sfi_grid_stamp(part, mask, by);
    anchor.x += (int32_t)by[0];
    anchor.y += (int32_t)by[1];
    anchor.z += (int32_t)by[2];
    return adopt(part, anchor, 0, &from, tip);
}

// Voxels above a pixel.
static uint32_t rise(uint8_t value, uint32_t depth_vx)
{
    return (value * depth_vx + 127) / 255;
}

sf_status sf_tip_create_stamp(const uint8_t *heights, size_t row_bytes, uint32_t width,
                              uint32_t height, uint32_t depth_vx, const sf_allocator *allocator,
                              sf_tip **tip)
{
    if (heights == NULL || tip == NULL || width < 1 || width > EXTENT_MAX || height < 1 ||
        height > EXTENT_MAX || depth_vx < 1 || depth_vx > EXTENT_MAX || row_bytes < width) {
        return SF_ERR_ARGUMENT;
    }
    uint32_t highest = 1;
    for (size_t i = 0; i < (size_t)width * height; i++) {
        uint32_t top = rise(heights[i / width * row_bytes + i % width], depth_vx);
        highest = top > highest ? top : highest;
    }
    sf_lattice lattice = plain_lattice(width, height, highest);
    sf_grid *mask;
    SF_TRY(sf_grid_create(&lattice, allocator, &mask));
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < width; x++) {
            uint32_t top = rise(heights[y * row_bytes + x], depth_vx);
            for (uint32_t z = 0; z < top; z++) {
                (void)!sf_slice_set(sf_grid_slice(mask, z), x, y, 1);
            }
        }
    }
    sf_dab anchor = {(int32_t)(width / 2), (int32_t)(height / 2), 0};
    sf_status status = sf_tip_create_mask(mask, anchor, allocator, tip);
    sf_grid_destroy(mask);
    return status;
}

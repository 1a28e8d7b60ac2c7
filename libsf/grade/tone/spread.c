// SPDX-License-Identifier: MIT
// The Gaussian of a mask, in millimetres, as integers.
//
// An isotropic mask pushes by exp(-d^2 / 2 s^2), d the distance in mm. But a plane through noise
// that is blue in space is nearly white: the Fourier slice theorem adds up all frequencies across
// it. What is printed and seen are planes. So the mask for slices pushes by that Gaussian within a
// slice and along a column, and not at all in between; each slice is then blue by itself, and so is
// each column of the stack.
//
// The deviation s is `spread` times the geometric mean of the pitches (of x and y for slices), so
// that on square voxels it is a number of voxels, and on others equally far in mm to all sides.
// Where layers are thin, columns would have a say over many of them, at the expense of the slices:
// along a column it is at most 4/3 `spread` layers. (At 0.0423 x 0.0846 x 0.027 mm and a tone of
// 0.1 that lowers what is left below 0.125 cycles a voxel from 0.085 of white noise to 0.07.)
//
// Weights are rounded to 2^-20, and those below 2^-10 are left out. Sums of integers are exact in
// any order, so that a field that is updated a million times is what a fresh sum would be.
//
// Source: A. Wolfe, N. Morrical, T. Akenine-Moeller, R. Ramamoorthi, "Spatiotemporal Blue Noise
// Masks", 2022, equation 4.

#include "grade/tone/spread.h"

#include "base/math.h"
#include "base/memory.h"
#include "base/status.h"

#include <math.h>

#define UNIT 1048576.0
#define LEAST 1024u
#define COLUMN (4.0 / 3.0)

// Newton's steps from above fall until they are as close as doubles get.
static double cube_root(double v)
{
    double root = v > 1.0 ? v : 1.0;
    for (;;) {
        double next = (2.0 * root + v / (root * root)) / 3.0;
        if (!(next < root)) {
            return root;
        }
        root = next;
    }
}

// The deviation along x, y and z, in voxels.
static void deviations(const sf_mask_options *o, double voxels[3])
{
    const double *p = o->pitch_mm;
    // Taken relative to x, so that products neither overflow nor vanish.
    double y = p[1] / p[0], z = p[2] / p[0];
    double s = o->spread * (o->kind == SF_MASK_SLICE ? sqrt(y) : cube_root(y * z));
    voxels[0] = s;
    voxels[1] = s / y;
    voxels[2] = s / z;
    if (o->kind == SF_MASK_SLICE && voxels[2] > COLUMN * o->spread) {
        voxels[2] = COLUMN * o->spread;
    }
}

// The weight of an offset of so many voxels along x, y and z.
static uint32_t weight_of(const sf_mask_options *o, const double voxels[3], const int64_t offset[3])
{
    double sum = 0.0;
    if (o->kind == SF_MASK_SLICE && offset[2] != 0 && (offset[0] != 0 || offset[1] != 0)) {
        return 0;
    }
    for (int n = 0; n < 3; n++) {
        double t = (double)offset[n] / voxels[n];
        sum += t * t;
    }
    uint32_t weight = (uint32_t)floor(UNIT * sfi_exp(-0.5 * sum) + 0.5);
    return weight >= LEAST ? weight : 0;
}

static uint32_t around(int64_t offset, uint32_t period)
{
    int64_t rest = offset % (int64_t)period;
    return (uint32_t)(rest < 0 ? rest + (int64_t)period : rest);
}

// Count the pushes and, where there is a place for them, write them.
static size_t list(const sf_mask_options *o, sfi_push *pushes)
{
    double voxels[3];
    int64_t reach[3], d[3];
    size_t count = 0;
    deviations(o, voxels);
    for (int n = 0; n < 3; n++) {
        // exp(-t^2 / 2) < 2^-10 beyond t = 3.73.
        reach[n] = (int64_t)floor(3.75 * voxels[n]) + 1;
    }
    for (d[2] = -reach[2]; d[2] <= reach[2]; d[2]++) {
        for (d[1] = -reach[1]; d[1] <= reach[1]; d[1]++) {
            for (d[0] = -reach[0]; d[0] <= reach[0]; d[0]++) {
                uint32_t weight = weight_of(o, voxels, d);
                if (weight > 0 && pushes != NULL) {
                    sfi_push push = {around(d[0], o->nx), around(d[1], o->ny), around(d[2], o->nz),
                                     weight};
                    pushes[count] = push;
                }
                count += weight > 0;
            }
        }
    }
    return count;
}

sf_status sfi_spread_create(const sf_mask_options *options, const sf_allocator *allocator,
                            sfi_spread *spread)
{
    size_t count = list(options, NULL);
    sfi_push *pushes = sfi_alloc_array(allocator, count, sizeof *pushes);
    if (pushes == NULL) {
        return SF_ERR_MEMORY;
    }
    list(options, pushes);
    spread->pushes = pushes;
    spread->count = count;
    return SF_OK;
}

void sfi_spread_destroy(sfi_spread *spread, const sf_allocator *allocator)
{
    sfi_free_array(allocator, spread->pushes, spread->count, sizeof *spread->pushes);
}

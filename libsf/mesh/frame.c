// SPDX-License-Identifier: MIT
// The fixed-point frame: where the corners of a mesh lie among the voxels, in whole units.
//
// Every position is rounded once, to 1/256 of a voxel, and everything after that is exact integer
// arithmetic on the rounded mesh. So a row of voxels that meets a shared edge is counted by exactly
// one of its triangles, whatever the hardware; a file with float noise in the seventh digit has its
// designed planes back; and results do not change when mesh and lattice are scaled together by a
// power of two. A finer unit would stay exact as well, but it would bring the noise of float32
// files back (2^-15 voxel at 512 voxels), and 1/512 voxel is a fiftieth of what any printer holds.
//
// Bounds. Coordinates stay within 2^29 units (two million voxels) of the lattice's corner, so a
// difference has 30 bits, an edge function (two products) 61 bits, and int64_t holds it exactly.
// What lies further away is refused: it is a broken coordinate or the wrong unit of length.
//
// Layers of different heights. A slanted triangle is not linear in the layer's number, so z is not
// mapped to layer numbers. It is measured in 1/256 of the mean height instead, and each layer's
// centre is rounded to those units; a row then is just a plane z = centre.

#include "mesh/frame.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <string.h>

// v / voxel * 256, rounded; the shift makes the number positive, where the cast is a floor.
static int snap_one(double v_mm, double origin_mm, double voxel_mm, int32_t *unit)
{
    double v = (v_mm - origin_mm) / voxel_mm * SFI_UNITS;
    if (!(v >= -SFI_UNITS_MAX && v <= SFI_UNITS_MAX)) {
        return 0;
    }
    *unit = (int32_t)(v + (SFI_UNITS_MAX + 0.5)) - SFI_UNITS_MAX;
    return 1;
}

int sfi_frame_snap(const sfi_frame *frame, const double xyz_mm[3], sfi_point *point)
{
    return snap_one(xyz_mm[0], frame->origin_mm[0], frame->voxel_mm[0], &point->x) &&
           snap_one(xyz_mm[1], frame->origin_mm[1], frame->voxel_mm[1], &point->y) &&
           snap_one(xyz_mm[2], frame->origin_mm[2], frame->voxel_mm[2], &point->z);
}

// Tables of centres and bottoms for layers of different heights.
static sf_status measure_layers(const sf_lattice *lattice, const sf_allocator *allocator,
                                sfi_frame *frame)
{
    size_t nz = lattice->nz;
    double total = 0.0, bottom = 0.0;
    for (size_t k = 0; k < nz; k++) {
        total += lattice->heights_mm[k];
    }
    frame->voxel_mm[2] = total / (double)nz;
    frame->centers = sfi_alloc_array(allocator, 2 * nz + 1, sizeof(int32_t));
    if (frame->centers == NULL) {
        return SF_ERR_MEMORY;
    }
    frame->bottoms = frame->centers + nz;
    int good = total <= 1e300;
    for (size_t k = 0; k < nz && good; k++) {
        double height = lattice->heights_mm[k];
        good = snap_one(bottom, 0.0, frame->voxel_mm[2], &frame->bottoms[k]) &&
               snap_one(bottom + height / 2, 0.0, frame->voxel_mm[2], &frame->centers[k]);
        bottom += height;
    }
    good = good && snap_one(bottom, 0.0, frame->voxel_mm[2], &frame->bottoms[nz]);
    return good ? SF_OK : SF_ERR_OVERFLOW;
}

sf_status sfi_frame_create(const sf_lattice *lattice, const sf_allocator *allocator,
                           sfi_frame *frame, sf_fault *fault)
{
    memset(frame, 0, sizeof *frame);
    if (lattice->nz > SFI_FRAME_LAYERS_MAX) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "The lattice has %llu layers and a mesh can be sliced into at most "
                             "%u at a time; slice it in pieces or take thicker layers.",
                             (unsigned long long)lattice->nz, SFI_FRAME_LAYERS_MAX);
    }
    frame->nx = lattice->nx;
    frame->ny = lattice->ny;
    frame->nz = lattice->nz;
    frame->voxel_mm[0] = lattice->pitch_x_mm;
    frame->voxel_mm[1] = lattice->pitch_y_mm;
    frame->voxel_mm[2] = lattice->layer_mm;
    memcpy(frame->origin_mm, lattice->origin_mm, sizeof frame->origin_mm);
    if (lattice->heights_mm == NULL) {
        return SF_OK;
    }
    sf_status status = measure_layers(lattice, allocator, frame);
    if (status != SF_OK) {
        sfi_frame_destroy(frame, allocator);
        return sfi_fault_set(fault, status, 0, 0, "%s", sf_status_message(status));
    }
    return SF_OK;
}

void sfi_frame_destroy(sfi_frame *frame, const sf_allocator *allocator)
{
    sfi_free_array(allocator, frame->centers, 2 * (size_t)frame->nz + 1, sizeof(int32_t));
    frame->centers = NULL;
    frame->bottoms = NULL;
}

// Number of centres below `z`, or at or below it when `at` is 1.
static uint32_t count_below(const sfi_frame *frame, int32_t z, int at)
{
    uint32_t low = 0, high = frame->nz;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (frame->centers[middle] < z || (at && frame->centers[middle] == z)) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

void sfi_frame_layers(const sfi_frame *frame, int32_t low, int32_t high, uint32_t *k0, uint32_t *k1)
{
    if (frame->centers == NULL) {
        sfi_frame_range(low, high, frame->nz, k0, k1);
        return;
    }
    *k0 = count_below(frame, low, 0);
    *k1 = count_below(frame, high, 1);
}

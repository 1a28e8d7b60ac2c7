// SPDX-License-Identifier: MIT
// Faces drawn along a line.

#include "grade/build/draft.h"

#include "base/status.h"
#include "grade/cage/cage.h"

#include <math.h>

// A face and a vector that make less of a volume than this share of area times length lie along
// each other: rounding alone makes some 10^-16.
static const double LEAST_SLOPE = 1e-9;

// How far a face looks along a vector, as a share of its area and of the vector's length: -1 to 1.
// 0 for a face without an area.
static double facing(const sf_cage_view *v, size_t face, const double vector[3])
{
    double area[3] = {0}, dot = 0, square = 0, length = 0;
    uint32_t start = v->starts[face], count = v->starts[face + 1] - start;
    const double *a = v->positions + 3 * (size_t)v->corners[start];
    for (uint32_t i = 1; i + 1 < count; i++) {
        const double *p = v->positions + 3 * (size_t)v->corners[start + i];
        const double *q = v->positions + 3 * (size_t)v->corners[start + i + 1];
        for (uint32_t x = 0; x < 3; x++) {
            uint32_t y = (x + 1) % 3, z = (x + 2) % 3;
            area[x] += (p[y] - a[y]) * (q[z] - a[z]) - (p[z] - a[z]) * (q[y] - a[y]);
        }
    }
    for (uint32_t x = 0; x < 3; x++) {
        dot += area[x] * vector[x];
        square += area[x] * area[x];
        length += vector[x] * vector[x];
    }
    return square > 0 && length > 0 ? dot / (sqrt(square) * sqrt(length)) : 0;
}

// Whether the faces look against the vector. All must look to one side of it.
static sf_status find_side(const sf_cage_view *v, const double vector[3], int *against,
                           sf_fault *fault)
{
    *against = facing(v, 0, vector) < 0;
    for (size_t f = 0; f < v->cell_count; f++) {
        double slope = facing(v, f, vector);
        if (!(fabs(slope) > LEAST_SLOPE)) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "face %zu lies along the vector, or has no area; the vector must "
                                 "lead out of all faces",
                                 f);
        }
        if ((slope < 0) != *against) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "along the vector face %zu looks the other way than face 0; the "
                                 "faces must not fold back, and must be turned alike",
                                 f);
        }
    }
    return SF_OK;
}

static void add_cell(const sf_cage_view *v, size_t face, uint32_t layer, int reversed,
                     sfi_draft *draft)
{
    uint32_t corners[2 * SF_CAGE_POLYGON_MAX];
    uint32_t start = v->starts[face], count = v->starts[face + 1] - start;
    uint32_t points = (uint32_t)v->point_count;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t point = v->corners[start + (reversed ? count - 1 - i : i)] + points * layer;
        corners[i] = point;
        corners[count + i] = point + points;
    }
    sfi_draft_cell(draft, 2 * count, corners);
}

sf_status sf_cage_extrude(const sf_cage *faces, const double vector_mm[3], uint32_t layers,
                          const sf_allocator *allocator, sf_cage **cage, sf_fault *fault)
{
    sf_cage_view v = sf_cage_get_view(faces);
    if (faces == NULL || vector_mm == NULL || cage == NULL || layers == 0) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t axis = 0; axis < 3; axis++) {
        if (!(fabs(vector_mm[axis]) <= 2 * SFI_CAGE_REACH)) {
            return SF_ERR_ARGUMENT;
        }
    }
    if (v.dimension != 2) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "only faces can be drawn along a line");
    }
    int against;
    SF_TRY(find_side(&v, vector_mm, &against, fault));
    if ((double)v.point_count * ((double)layers + 1) > SF_CAGE_POINT_MAX) {
        return SF_ERR_OVERFLOW;
    }
    sfi_draft draft;
    sfi_draft_begin(allocator, &draft);
    for (uint32_t layer = 0; layer <= layers; layer++) {
        for (size_t i = 0; i < v.point_count && draft.status == SF_OK; i++) {
            double at[3], t = (double)layer / layers;
            for (size_t axis = 0; axis < 3; axis++) {
                at[axis] = v.positions[3 * i + axis] + t * vector_mm[axis];
            }
            (void)sfi_draft_point(&draft, at);
        }
    }
    for (uint32_t layer = 0; layer < layers; layer++) {
        for (size_t face = 0; face < v.cell_count && draft.status == SF_OK; face++) {
            add_cell(&v, face, layer, against, &draft);
        }
    }
    return sfi_draft_end(&draft, cage, fault);
}

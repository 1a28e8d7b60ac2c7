// SPDX-License-Identifier: MIT
// Exact moments of slices and grids.
//
// Mass, centre of mass and inertia of a voxel shape are sums of 1, x and x * y over its voxels.
// They are kept as integers in voxel indices, so they do not depend on the order of summing, on
// threads or on the instruction set, and sums of parts are the sum of the whole. A row gives its
// number of voxels, its sum of x and of x * x; y and z are the same for a whole row and a whole
// slice, so the other sums follow by multiplication. Sums over a slice fit in 64 bits for every
// slice within the limits (65535 rows of at most 2^46.5 for x * x); sums over a grid need 128.

#include "base/status.h"
#include "base/task.h"
#include "simd/kernels.h"
#include "voxel/slice.h"
#include "voxel/wide.h"

#include <string.h>

sf_status sf_slice_measure(sf_slice slice, sf_slice_sums *sums)
{
    const sfi_kernels *kernels = sfi_kernels_get();
    SF_TRY(sfi_slice_validate(slice));
    if (sums == NULL) {
        return SF_ERR_ARGUMENT;
    }
    memset(sums, 0, sizeof *sums);
    size_t last = sfi_row_words(slice.width) - 1;
    for (uint64_t y = 0; y < slice.height; y++) {
        const uint64_t *row = sfi_slice_row(slice, (uint32_t)y);
        uint64_t tail = row[last] & sfi_tail_mask(slice.width), first = 64 * (uint64_t)last;
        uint64_t body[3] = {0, 0, 0}, end[3] = {0, 0, 0};
        if (last > 0) {
            kernels->row_sums(row, last, body);
        }
        kernels->row_sums(&tail, 1, end); // as if it were the first word
        uint64_t n = body[0] + end[0], x = body[1] + end[1] + first * end[0];
        sums->count += n;
        sums->x += x;
        sums->xx += body[2] + end[2] + first * (2 * end[1] + first * end[0]);
        sums->y += y * n;
        sums->yy += y * y * n;
        sums->xy += y * x;
    }
    return SF_OK;
}

// Add a slice that lies in layer k.
static void add_slice(sf_moments *m, const sf_slice_sums *s, uint64_t k)
{
    m->count += s->count;
    sfi_wide_add(&m->x, sfi_wide_product(s->x, 1));
    sfi_wide_add(&m->y, sfi_wide_product(s->y, 1));
    sfi_wide_add(&m->z, sfi_wide_product(s->count, k));
    sfi_wide_add(&m->xx, sfi_wide_product(s->xx, 1));
    sfi_wide_add(&m->yy, sfi_wide_product(s->yy, 1));
    sfi_wide_add(&m->zz, sfi_wide_product(s->count, k * k));
    sfi_wide_add(&m->xy, sfi_wide_product(s->xy, 1));
    sfi_wide_add(&m->xz, sfi_wide_product(s->x, k));
    sfi_wide_add(&m->yz, sfi_wide_product(s->y, k));
}

// Slices that are measured side by side, one sum each.
enum { ROUND = 64 };

typedef struct round {
    const sf_grid *grid;
    uint32_t first;
    sf_slice_sums sums[ROUND];
    sf_status status[ROUND];
} round;

static void measure_slice(void *context, size_t index)
{
    round *r = context;
    sf_slice slice = sf_grid_slice(r->grid, r->first + (uint32_t)index);
    r->status[index] = sf_slice_measure(slice, &r->sums[index]);
}

sf_status sf_grid_measure(const sf_grid *grid, sf_task *task, sf_moments *moments)
{
    if (grid == NULL || moments == NULL) {
        return SF_ERR_ARGUMENT;
    }
    uint32_t nz = sf_grid_lattice(grid).nz;
    sfi_progress progress = sfi_progress_begin(task);
    sf_moments sum;
    round r;
    memset(&sum, 0, sizeof sum);
    r.grid = grid;
    for (r.first = 0; r.first < nz; r.first += ROUND) {
        uint32_t count = nz - r.first < ROUND ? nz - r.first : ROUND;
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        sfi_task_for(task, count, measure_slice, &r);
        for (uint32_t i = 0; i < count; i++) {
            SF_TRY(r.status[i]);
            add_slice(&sum, &r.sums[i], (uint64_t)r.first + i);
        }
        sfi_progress_report(&progress, (uint64_t)r.first + count, nz);
    }
    *moments = sum;
    return SF_OK;
}

// SPDX-License-Identifier: MIT
// The parts of a path finder: what the bed is like, which landing is best, the search layer by
// layer.

#ifndef SF_SUPPORT_SEARCH_H
#define SF_SUPPORT_SEARCH_H

#include "support/grow/cone.h"
#include "support/grow/site.h"
#include "voxel/distance.h"

// Squared distances to the matter of the bed slice, made when first asked for and again whenever
// that slice is another.
typedef struct sfi_bed {
    uint32_t *square;  // by voxels; NULL before
    uint32_t *tiles;   // the least in each tile of them (bed.c)
    uint32_t *scratch; // for sfi_slice_distance()
    sf_grid *seen;     // one layer: the bed slice that they are for
} sfi_bed;

sf_status sfi_bed_update(sfi_bed *bed, const sfi_site *site);
void sfi_bed_destroy(sfi_bed *bed, const sfi_site *site);

// The best landing so far, in the plane: least `first` (on the bed the squared distance to matter,
// else 0), then the least distance from the middle, the least y, the least x.
typedef struct sfi_spot {
    uint64_t first, off;
    uint32_t x, y;
    int is_found;
} sfi_spot;

static inline void sfi_spot_offer(sfi_spot *spot, uint64_t first, sf_voxel from, uint32_t x,
                                  uint32_t y)
{
    uint64_t dx = x > from.x ? x - from.x : from.x - x, dy = y > from.y ? y - from.y : from.y - y;
    uint64_t off = dx * dx + dy * dy;
    int is_better = !spot->is_found;
    if (!is_better && first != spot->first) {
        is_better = first < spot->first;
    } else if (!is_better && off != spot->off) {
        is_better = off < spot->off;
    } else if (!is_better) {
        is_better = y < spot->y || (y == spot->y && x < spot->x);
    }
    if (is_better) {
        sfi_spot better = {first, off, x, y, 1};
        *spot = better;
    }
}

// The voxel of the bed within a window that is closest to the bed's matter.
sfi_spot sfi_bed_choose(const sfi_bed *bed, sf_slice slice, const sfi_window *window,
                        sf_voxel from);

// The closest path by a search layer by layer, for every rule and all masks. `chain` has a place
// for each layer. SF_OK; SF_ERR_INFEASIBLE: there is none; SF_ERR_MEMORY, SF_ERR_OVERFLOW.
sf_status sfi_descend(const sfi_site *site, sfi_bed *bed, sf_voxel from, sf_voxel *chain,
                      sf_path *found);

#endif

// SPDX-License-Identifier: MIT
// Against grow: a repair that costs no more than sf_grid_grow().
//
// A forest's choice of supporters is another than grow's: where pillars are long grow shares them
// and is far cheaper than the first forest; and now and then it is luckier than all rounds, by a
// voxel or two. So grow is asked, on the shape without what no support can reach: S = V and G. It
// always can: G is the trim of S and of all that may be added, because it is the trim of V and
// that, and holds nothing of V but S. Where all of V can stay, S is V, and this is what a caller
// would get from grow itself.
//
// Grow takes time by the grid, and repair mostly by what hangs in it. In a large grid in which the
// first result already comes at a small part of what hangs, grow would take long to lose: the part
// of its voxels that a forest cannot share is of the size of what is repaired. So there it is not
// asked, and nothing is promised.

#include "support/repair/against_grow.h"

#include <sf/grow.h>

#include "base/status.h"
#include "voxel/slice.h"

// Voxels from the bed up, up to which grow is asked whatever it takes; and beyond, where the cost
// is more than one in so many of the voxels that do not stand.
#define ALWAYS (UINT64_C(1) << 26)
#define PART 64

int sfi_is_grow_asked(const sfi_job *job, uint64_t first)
{
    uint64_t layer = (uint64_t)job->lattice.nx * job->lattice.ny;
    return first > 0 &&
           (layer * (job->lattice.nz - job->bed) <= ALWAYS || first > sfi_job_hanging(job) / PART);
}

sf_status sfi_grow_rest(const sfi_job *job, const sf_terms *terms, const sf_grid *room,
                        sf_grid **grown)
{
    SF_TRY(sf_grid_create(&job->lattice, job->allocator, grown));
    sf_status status = SF_OK;
    for (uint32_t k = 0; status == SF_OK && k < job->lattice.nz; k++) {
        status = sf_slice_and(sf_grid_slice(*grown, k), sf_grid_slice(job->drawn, k),
                              sf_grid_slice(room, k));
    }
    if (status == SF_OK) {
        status = sf_grid_grow(*grown, terms, job->allocator, sfi_pace_next(job->pace), NULL, NULL);
    }
    if (status != SF_OK) {
        sf_grid_destroy(*grown);
        *grown = NULL;
    }
    return status;
}

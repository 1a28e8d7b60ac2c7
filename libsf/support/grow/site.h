// SPDX-License-Identifier: MIT
// Where paths may run and what they may land on: a grid under terms, made ready for the search.

#ifndef SF_SUPPORT_SITE_H
#define SF_SUPPORT_SITE_H

#include <sf/grow.h>

#include "base/task.h"
#include "support/grow/reserve.h"
#include "support/rule/carry.h"
#include "support/rule/terms.h"
#include "voxel/slice.h"

typedef struct sfi_site {
    sf_terms terms;     // a copy
    sf_rule plain;      // its rule without bridges: what a path goes by
    sf_lattice lattice; // of the grid
    uint32_t bed;       // layer 0 where an empty grid was to choose it
    sf_landing landing;
    const sf_grid *grid;
    const sf_grid *roots; // matter that a path may land on: grid, or alive
    sf_grid *alive;       // what is alive under the whole rule; NULL where nobody asks
    sfi_reserve reserve;  // under slack what `alive` has to spare
    size_t code_bytes;    // of the codes of one layer; 0 where that is more than a size_t holds
    sf_allocator allocator;
} sfi_site;

// Progress of a call that is several sweeps: this one begins at `done` of `total` layers.
typedef struct sfi_stage {
    sf_task *task;
    sfi_progress *progress;
    uint64_t done, total;
} sfi_stage;

// SF_OK, what sfi_terms_check() says, or a failure of memory or a cancel; then the site is closed.
sf_status sfi_site_open(sfi_site *site, const sf_grid *grid, const sf_terms *terms,
                        sf_landing landing, const sf_allocator *allocator, const sfi_stage *stage);
void sfi_site_close(sfi_site *site);

// The same for terms that were checked, where only the masks and the plain rule are asked for: no
// field is made, nothing has to be closed.
void sfi_site_place(sfi_site *site, const sf_grid *grid, const sf_terms *terms,
                    const sfi_ground *ground, const sf_allocator *allocator);

// Memory for the codes of all voxels of the grid: NULL with SF_OK where the rule has none.
sf_status sfi_codes_create(const sfi_site *site, uint8_t **codes);
void sfi_codes_destroy(const sfi_site *site, uint8_t *codes);

// Look at the grid anew. A failure leaves the site as it was.
sf_status sfi_site_refresh(sfi_site *site, const sfi_stage *stage);

// Where a field goes: what is alive, what of it without bridges, and codes; each but the first may
// be NULL. Codes are layer after layer, sfi_slack_stride(nx) * ny bytes each; under slack they go
// there, or into an empty reserve.
typedef struct sfi_field {
    sf_grid *alive, *own;
    uint8_t *codes;
    sfi_reserve *reserve;
} sfi_field;

// Fill a field of `solid` under the terms' rule and with their exempt voxels, in all layers. A
// cancel, honoured at every slice, or a failure of memory leaves it half done.
sf_status sfi_field_fill(const sfi_field *field, const sf_grid *solid, const sf_terms *terms,
                         uint32_t bed, const sf_allocator *allocator, const sfi_stage *stage);

// 64 voxels of a row, from column 64 * i on: which of them are empty and may be filled.
uint64_t sfi_site_free_word(const sfi_site *site, uint32_t z, uint32_t y, size_t i);

// Under slack, what matter has to spare; none where it is dead.
uint32_t sfi_site_slack(const sfi_site *site, sf_voxel v);

// A path, its end and its cost, apart from its voxels: those of a finder and of a map are one.
// bed_square is that of sfi_slice_distance() where the end is the bed.
sf_path sfi_path_make(size_t count, sf_path_end end, sf_voxel landing, uint32_t bed_square);

// The path of a voxel that needs none, because it lies on the bed or is exempt. Returns 0 for one
// that has to be asked about.
int sfi_path_is_trivial(const sfi_site *site, sf_voxel from, sf_path *found);

#endif

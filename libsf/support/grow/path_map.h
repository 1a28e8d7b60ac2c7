// SPDX-License-Identifier: MIT
// The two forms of a path map, and the sweeps that make them.

#ifndef SF_SUPPORT_PATH_MAP_H
#define SF_SUPPORT_PATH_MAP_H

#include "support/grow/search.h"

// The cost of a voxel that no path can enter.
#define SFI_COST_NONE UINT32_MAX

struct sf_path_map {
    sfi_site site;
    sf_path_cost cost;
    sfi_bed bed;        // distances on the bed
    uint32_t layers;    // from the bed layer up
    uint64_t *codes;    // narrow: a nibble for each voxel of layers bed + 1, ...; or NULL
    size_t code_words;  // of one layer
    uint32_t *costs;    // wide: of each voxel of layers bed, ...; or NULL
    size_t cost_places; // of one layer
};

// Fill map->codes, or map->costs; what is allocated beyond is given back.
sf_status sfi_path_map_sweep_codes(sf_path_map *map, const sfi_stage *stage);
sf_status sfi_path_map_sweep_costs(sf_path_map *map, const sfi_stage *stage);

// The step that a code of simd/kernels.h stands for; 0 where there is none.
int sfi_path_code_step(unsigned code, int *dx, int *dy);

#endif

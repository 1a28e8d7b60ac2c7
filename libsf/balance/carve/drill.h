// SPDX-License-Identifier: MIT
// A shaft on its way down, out of a void and into the open.

#ifndef SF_BALANCE_DRILL_H
#define SF_BALANCE_DRILL_H

#include <sf/carve.h>

#include "voxel/pieces.h"

// What a shaft is drilled in.
typedef struct sfi_ground_plan {
    sf_grid *made; // the part as it is by now
    sf_lattice lattice;
    const double *levels;
    const sf_terms *terms; // or NULL
    sf_rule_angles angles; // of the terms' rule
    const float *density;
    sf_element disk;          // what a hole is in a layer
    const sfi_pieces *pieces; // what is empty in the part as it came
    const uint8_t *is_open;   // of each of these
} sfi_ground_plan;

// Directions that a shaft can take on its way down: straight, or aslant to one of eight sides.
#define SFI_DRILL_DIRECTIONS 9u
extern const signed char sfi_drill_directions[SFI_DRILL_DIRECTIONS][2];

// Where a shaft is. A shaft that is begun at (x, y, layer) has its disk there, in a void.
typedef struct sfi_drill {
    int64_t x, y;
    int64_t layer;
    unsigned direction;
    double left; // of a step, where steps are of the angle
} sfi_drill;

sfi_drill sfi_drill_begin(uint32_t x, uint32_t y, uint32_t layer, unsigned direction);

// One layer down.
void sfi_drill_step(const sfi_ground_plan *plan, sfi_drill *drill);

// Whether voxel (x, y) of a layer lies in the open: outside the grid, or empty and connected to it.
int sfi_drill_is_open(const sfi_ground_plan *plan, int64_t x, int64_t y, int64_t layer);

// What a shaft goes through from its begin on.
typedef struct sfi_bore {
    int is_allowed; // takes nothing that must stay
    uint64_t voxels;
    sf_body body;
    sfi_drill end; // the first layer in which all of it is open
} sfi_bore;

sfi_bore sfi_drill_measure(const sfi_ground_plan *plan, sfi_drill begin);

// Take it out of a grid, which is the part as it is or a copy of it.
void sfi_drill_remove(const sfi_ground_plan *plan, sfi_drill begin, sf_grid *grid);

// Pieces that are marked, each once in the list, which has room for all.
typedef struct sfi_marks {
    uint8_t *is_marked; // of each piece
    uint32_t *list;
    size_t count;
} sfi_marks;

// Mark the voids that it opens.
void sfi_drill_mark(const sfi_ground_plan *plan, sfi_drill begin, sfi_marks *marks);

// The same for voxels of a grid that are taken out as well.
void sfi_drill_mark_around(const sfi_ground_plan *plan, const sf_grid *grid, sf_box box,
                           sfi_marks *marks);

#endif

// SPDX-License-Identifier: MIT
// A model, seen from inside.
//
// Two states, `now` and `before`: what the model is, and what it was before the stroke that is
// under way. They differ only within `touched`; with no stroke under way they are the same.

#ifndef SF_SCULPT_MODEL_H
#define SF_SCULPT_MODEL_H

#include <sf/grow.h>
#include <sf/preserve.h>
#include <sf/sculpt.h>

#include "sculpt/arena.h"
#include "sculpt/history.h"

typedef struct sfi_state {
    sf_grid *drawn, *printable;
    uint8_t *materials;
} sfi_state;

// The stroke that is under way.
typedef struct sfi_sculpt_stroke {
    int is_under_way;
    sf_brush brush;
    sf_box tips;       // around what `tips` holds
    sf_box grown;      // around what `grown` holds
    sf_box braced;     // around what was put below the tips beside that
    sfi_touch touched; // by all calls
    uint64_t path_voxels;
} sfi_sculpt_stroke;

struct sf_sculpt {
    sf_allocator allocator; // of the block that all of this lies in
    size_t size;            // of the block
    sfi_arena arena;
    sf_allocator scratch; // takes from the arena
    sf_sculpt_options options;
    sf_lattice lattice; // its heights belong to a grid
    sf_terms terms;
    sfi_state now, before;
    sf_grid *tips;          // U: the union of the stroke's tips
    sf_grid *grown;         // add-grow: paths, and the tips along them
    sf_path_finder *finder; // on before.printable
    sf_voxel *path;         // a place for each layer
    sfi_history history;
    sfi_sculpt_stroke stroke;
};

// Materials of row y in layer z.
static inline uint8_t *sfi_material_row(const sf_sculpt *m, const sfi_state *state, uint32_t y,
                                        uint32_t z)
{
    return state->materials + ((size_t)z * m->lattice.ny + y) * m->lattice.nx;
}

// Make `to` what `from` is within the boxes of `touched`; both are states of the model.
void sfi_sculpt_copy(const sf_sculpt *m, const sfi_state *to, const sfi_state *from,
                     const sfi_touch *touched);

// What a brush does, each for the dabs within `fresh`, the box around what was stamped by this
// call. Boxes of what they changed are joined to *touched. SF_OK, or what they cannot have.
sf_status sfi_brush_add(sf_sculpt *m, sf_box fresh, sfi_touch *touched);
sf_status sfi_brush_remove(sf_sculpt *m, sf_box fresh, sfi_touch *touched);
sf_status sfi_brush_paint(sf_sculpt *m, sf_box fresh, sfi_touch *touched);
sf_status sfi_brush_preserve(sf_sculpt *m, sfi_touch *touched);
sf_status sfi_brush_smooth(sf_sculpt *m, sfi_touch *touched);
sf_status sfi_brush_grow(sf_sculpt *m, sf_box fresh, sfi_touch *touched);

// For sfi_brush_grow(): put the closest supporting path of a dab into `grown`, with the tip along
// it, mirrored this way. *fresh grows by the box around it.
sf_status sfi_grow_paths(sf_sculpt *m, const int64_t at[3], unsigned way, sf_box *fresh);

// For sfi_brush_grow(): add to `drawn` what carries the tips that are drawn and not printable;
// *braced is the box around it.
sf_status sfi_brace(sf_sculpt *m, sf_box *braced);

// Bring T up to date within a box of D that changed, and join what changed to *touched.
sf_status sfi_sculpt_trim(sf_sculpt *m, sf_box box, sfi_touch *touched);

// Count what a stroke did, in the boxes that it touched.
void sfi_sculpt_count(const sf_sculpt *m, sf_sculpt_change *change);

// End what is under way as a step of the history: `before` becomes `now`. `change` may be NULL.
void sfi_sculpt_commit(sf_sculpt *m, int keep_ghosts, sf_sculpt_change *change);

// *to grown by *from.
void sfi_touch_join(sfi_touch *to, const sfi_touch *from);

#endif

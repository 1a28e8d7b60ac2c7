// SPDX-License-Identifier: MIT
// A model, seen from inside.
//
// Two states, `now` and `before`: what the model is, and what it was before the stroke that is
// under way. They differ only where `touched` says; with no stroke under way they are the same.
// Then all that is drawn is printable, unless the model keeps ghosts: so without these `before` has
// one grid for both.

#ifndef SF_SCULPT_MODEL_H
#define SF_SCULPT_MODEL_H

#include <sf/grow.h>
#include <sf/preserve.h>
#include <sf/sculpt.h>

#include "sculpt/arena.h"
#include "sculpt/ring.h"
#include "voxel/area.h"

typedef struct sfi_state {
    sf_grid *drawn, *printable;
    uint8_t *materials;
} sfi_state;

// Where the three parts of a model changed.
typedef struct sfi_touch {
    sfi_area drawn, printable, material;
} sfi_touch;

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
    sfi_ring history;
    // The stroke that is under way.
    int is_under_way;
    sf_brush brush;
    uint64_t path_voxels;
    sfi_area in_tips, in_grown; // where these grids hold something
    sfi_area braced;            // where there is more below the tips than that
    sfi_touch touched;          // by all of the stroke
    // The call that is under way.
    sfi_area fresh;   // where tips, and what they grow, were put
    sfi_area work;    // scratch
    sfi_touch called; // what it touched
};

// Materials of row y in layer z.
static inline uint8_t *sfi_material_row(const sf_sculpt *m, const sfi_state *state, uint32_t y,
                                        uint32_t z)
{
    return state->materials + ((size_t)z * m->lattice.ny + y) * m->lattice.nx;
}

// Make `to` what `from` is where `touched` says; both are states of the model.
void sfi_sculpt_copy(const sf_sculpt *m, const sfi_state *to, const sfi_state *from,
                     const sfi_touch *touched);

// What a brush does with the tips of the stroke, of which those in `fresh` came with this call.
// What it changes is joined to `called`. SF_OK, or what an operator cannot have.
sf_status sfi_brush_add(sf_sculpt *m);
sf_status sfi_brush_remove(sf_sculpt *m);
sf_status sfi_brush_paint(sf_sculpt *m);
sf_status sfi_brush_preserve(sf_sculpt *m);
sf_status sfi_brush_smooth(sf_sculpt *m);
sf_status sfi_brush_grow(sf_sculpt *m);

// For sfi_brush_grow(): put the closest supporting path of a dab into `grown`, with the tip along
// it, mirrored this way. `fresh` grows by it.
sf_status sfi_grow_paths(sf_sculpt *m, const int64_t at[3], unsigned way);

// For sfi_brush_grow(): add to `drawn` what carries the tips that are drawn and not printable;
// `braced` says where.
sf_status sfi_brace(sf_sculpt *m);

// Bring T up to date where D changed.
sf_status sfi_sculpt_trim(sf_sculpt *m, const sfi_area *changed);

// Count what a stroke did, where it touched the model.
void sfi_sculpt_count(const sf_sculpt *m, sf_sculpt_change *change);

// *differs grown by where `now` is not `before`, within an area: D and materials; T.
void sfi_drawn_differences(const sf_sculpt *m, const sfi_area *within, sfi_touch *differs);
void sfi_printable_differences(const sf_sculpt *m, const sfi_area *within, sfi_area *differs);

// The boxes around what was touched.
void sfi_sculpt_boxes(const sfi_touch *touched, sf_sculpt_change *change);

// End what is under way as a step of the history: `before` becomes `now`. `change` may be NULL.
void sfi_sculpt_commit(sf_sculpt *m, int keep_ghosts, sf_sculpt_change *change);

void sfi_touch_clear(sfi_touch *touch);

// *to grown by *from.
void sfi_touch_join(sfi_touch *to, const sfi_touch *from);

#endif

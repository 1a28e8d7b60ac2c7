// SPDX-License-Identifier: MIT
// A model on the GPU, seen from inside.

#ifndef SCULPT_GPU_MODEL_H
#define SCULPT_GPU_MODEL_H

#include "gpu_sculpt.h"

// Buffers. The first ten are bound where their number says, as in state.glsl and tip.glsl.
enum {
    GPU_DRAWN,
    GPU_PRINTABLE,
    GPU_MATERIALS,
    GPU_DRAWN_BEFORE,
    GPU_PRINTABLE_BEFORE,
    GPU_MATERIALS_BEFORE,
    GPU_TIPS,
    GPU_LEDGER,
    GPU_TIP,
    GPU_PUTS,
    GPU_GROWN,
    GPU_BRACED,
    GPU_HISTORY,
    GPU_SLICE, // one layer of words, and five more
    GPU_OTHER_SLICES,
    GPU_LANDINGS,
    GPU_CHAINS,
    GPU_ROW_SQUARE,
    GPU_SQUARE,
    GPU_PASS, // bits and materials between passes of smooth-trim, made when first used
    GPU_PASS_MATERIALS,
    GPU_BUFFER_COUNT
};

#define GPU_FIXED_COUNT 10u // bound by number
#define GPU_OWN_COUNT 5u    // binding points after these, whose buffers each program names

// Programs, by the names in programs.c.
enum {
    GPU_RUN_OPEN,
    GPU_RUN_STAMP,
    GPU_RUN_SET,
    GPU_RUN_PAINT,
    GPU_RUN_TRIM,
    GPU_RUN_WALK,
    GPU_RUN_PRESERVE,
    GPU_RUN_SMOOTH,
    GPU_RUN_PATH,
    GPU_RUN_BED_ROWS,
    GPU_RUN_BED_COLUMNS,
    GPU_RUN_LAND,
    GPU_RUN_EMIT,
    GPU_RUN_BRACE,
    GPU_RUN_SETTLE,
    GPU_RUN_STEP,
    GPU_RUN_RECORD,
    GPU_RUN_APPLY,
    GPU_RUN_COUNT
};

// Verbs of step.comp, and modes of set.comp.
enum { GPU_STEP_COUNT, GPU_STEP_END, GPU_STEP_GIVE_UP, GPU_STEP_UNDO, GPU_STEP_REDO };
enum { GPU_SET_ADD, GPU_SET_REMOVE, GPU_SET_KEEP, GPU_SET_GROW, GPU_SET_BRACE };

// Dabs that go to the card at once.
#define GPU_PUT_MAX 256u

// A dab as tip.glsl knows it.
typedef struct gpu_put {
    int32_t x, y, z;
    int32_t corner_x, corner_y, corner_z;
    uint32_t way, unused;
} gpu_put;

// The stroke that is under way.
typedef struct gpu_stroke {
    int is_under_way, has_begun; // the second: there was a call with dabs
    sf_brush brush;
    sf_dab anchor;
    uint32_t tip_nx, tip_ny, tip_nz;
    sf_box tips; // around the union of the tips
} gpu_stroke;

struct gpu_sculpt {
    sf_sculpt_options options;
    sf_lattice lattice; // without heights
    uint32_t row_words;
    size_t words;     // of a grid
    size_t block_max; // bytes of a buffer that a shader may see
    unsigned buffers[GPU_BUFFER_COUNT];
    unsigned programs[GPU_RUN_COUNT];
    gpu_stroke stroke;
    char why[1024];
};

// Compile all programs. SF_ERR_INFEASIBLE: one does not compile, and model->why says which.
sf_status gpu_programs_create(gpu_sculpt *model);
void gpu_programs_destroy(gpu_sculpt *model);

// Make a program current, with its buffers, so that its uniforms can be set; then dispatch it, over
// groups of its own or over as many as serve words spread over the grid. What it writes is visible
// to all that follows.
void gpu_use(const gpu_sculpt *model, unsigned program);
void gpu_dispatch(uint32_t groups, uint32_t groups_y);
void gpu_dispatch_spread(const gpu_sculpt *model);

// Bind other buffers than the program's own to the binding points that it names; for smooth-trim.
void gpu_bind_own(const gpu_sculpt *model, const unsigned char own[GPU_OWN_COUNT]);

// End what is under way as a step of the history, or take it back.
void gpu_commit(gpu_sculpt *model, int keeps_ghosts, unsigned kept_back_kind);
void gpu_give_up(gpu_sculpt *model);

// A call begins that changes what is drawn within a box, which may be empty.
void gpu_open(gpu_sculpt *model, sf_box box);

// What a brush does once the tips of a call are in the union, within the box that was opened.
void gpu_brush_apply(gpu_sculpt *model);

// The box around the stroke's tips and a tip's width more on every side. Braces lie in it or below.
sf_box gpu_brace_box(const gpu_sculpt *model);

// The closest supporting paths of puts that are on the card, with the tip along them.
void gpu_brush_paths(gpu_sculpt *model, uint32_t count, uint32_t pieces);

// Whether OpenGL had enough memory since it was asked last.
int gpu_had_memory(void);

#endif

// SPDX-License-Identifier: MIT
// Brushes: which shaders make of the tips what each kind of brush promises.
//
// The order of dispatches is that of the calls in libsf/sculpt/brush_*.c. Add-trim, remove-trim and
// paint look only at the box around the new tips, the others at the box around all of the stroke's,
// from the state before it.

#include <epoxy/gl.h>

#include "model.h"

static uint32_t in_all_bytes(uint8_t material)
{
    return material * 0x01010101u;
}

static void set(const gpu_sculpt *m, unsigned mode)
{
    gpu_use(m, GPU_RUN_SET);
    glUniform1ui(2, mode);
    glUniform1ui(3, in_all_bytes(m->stroke.brush.material));
    gpu_dispatch_spread(m);
}

static void walk(const gpu_sculpt *m)
{
    gpu_use(m, GPU_RUN_WALK);
    gpu_dispatch(1, 1);
}

static void preserve(const gpu_sculpt *m)
{
    gpu_use(m, GPU_RUN_PRESERVE);
    gpu_dispatch(1, 1);
    set(m, GPU_SET_KEEP);
}

static void paint(const gpu_sculpt *m)
{
    gpu_use(m, GPU_RUN_PAINT);
    glUniform1ui(3, in_all_bytes(m->stroke.brush.material));
    gpu_dispatch_spread(m);
}

// Passes go to and fro between two pairs of buffers, so that the last one ends in the model's own.
static void smooth(const gpu_sculpt *m)
{
    static const unsigned char pairs[2][2] = {{GPU_DRAWN, GPU_MATERIALS},
                                              {GPU_PASS, GPU_PASS_MATERIALS}};
    uint32_t passes = m->stroke.brush.passes;
    unsigned char own[GPU_OWN_COUNT] = {GPU_DRAWN_BEFORE, GPU_MATERIALS_BEFORE, 0, 0,
                                        GPU_BUFFER_COUNT};
    for (uint32_t i = 0; i < passes; i++) {
        const unsigned char *to = pairs[(passes - 1 - i) % 2];
        own[2] = to[0];
        own[3] = to[1];
        gpu_use(m, GPU_RUN_SMOOTH);
        gpu_bind_own(m, own);
        glUniform1ui(2, i + 1 == passes ? 1 : 0);
        gpu_dispatch_spread(m);
        own[0] = to[0];
        own[1] = to[1];
    }
    walk(m);
}

void gpu_brush_paths(gpu_sculpt *m, uint32_t count, uint32_t pieces)
{
    gpu_use(m, GPU_RUN_PATH);
    gpu_dispatch(count, 1);
    gpu_use(m, GPU_RUN_BED_ROWS);
    gpu_dispatch_spread(m);
    gpu_use(m, GPU_RUN_BED_COLUMNS);
    gpu_dispatch_spread(m);
    gpu_use(m, GPU_RUN_LAND);
    gpu_dispatch(count, 1);
    gpu_use(m, GPU_RUN_EMIT);
    gpu_dispatch(pieces, count);
}

sf_box gpu_brace_box(const gpu_sculpt *m)
{
    sf_box b = m->stroke.tips;
    uint32_t nx = m->stroke.tip_nx, ny = m->stroke.tip_ny;
    if (b.x0 < b.x1) {
        b.x0 = b.x0 > nx ? b.x0 - nx : 0;
        b.y0 = b.y0 > ny ? b.y0 - ny : 0;
        b.x1 = m->lattice.nx - b.x1 > nx ? b.x1 + nx : m->lattice.nx;
        b.y1 = m->lattice.ny - b.y1 > ny ? b.y1 + ny : m->lattice.ny;
    }
    return b;
}

static void grow(const gpu_sculpt *m)
{
    sf_box b = gpu_brace_box(m);
    set(m, GPU_SET_GROW);
    walk(m);
    gpu_use(m, GPU_RUN_BRACE);
    glUniform3ui(2, b.x0, b.y0, b.z0);
    glUniform3ui(3, b.x1, b.y1, b.z1);
    gpu_dispatch(1, 1);
    set(m, GPU_SET_BRACE);
    walk(m);
}

void gpu_brush_apply(gpu_sculpt *m)
{
    switch (m->stroke.brush.kind) {
    case SF_BRUSH_ADD_TRIM:
        set(m, GPU_SET_ADD);
        walk(m);
        break;
    case SF_BRUSH_REMOVE_TRIM:
        set(m, GPU_SET_REMOVE);
        walk(m);
        break;
    case SF_BRUSH_REMOVE_PRESERVE:
        preserve(m);
        break;
    case SF_BRUSH_ADD_GROW:
        grow(m);
        break;
    case SF_BRUSH_SMOOTH_TRIM:
        smooth(m);
        break;
    default:
        paint(m);
        break;
    }
}

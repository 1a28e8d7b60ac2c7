// SPDX-License-Identifier: MIT
// History: steps end, are taken back and are done again, on the card alone.
//
// Where a step lies and how long it is stands in the ledger (step.comp); the host never knows.

#include <epoxy/gl.h>

#include "model.h"

void gpu_open(gpu_sculpt *m, sf_box b)
{
    gpu_use(m, GPU_RUN_OPEN);
    glUniform3ui(2, b.x0, b.y0, b.z0);
    glUniform3ui(3, b.x1, b.y1, b.z1);
    glUniform1ui(4, m->stroke.has_begun ? 0 : 1);
    gpu_dispatch(1, 1);
    m->stroke.has_begun = 1;
}

static void step(const gpu_sculpt *m, unsigned verb)
{
    gpu_use(m, GPU_RUN_STEP);
    glUniform1ui(2, verb);
    gpu_dispatch(1, 1);
}

static void record(gpu_sculpt *m, int is_given_up)
{
    gpu_use(m, GPU_RUN_RECORD);
    glUniform1ui(2, is_given_up ? 1 : 0);
    gpu_dispatch_spread(m);
    m->stroke.is_under_way = m->stroke.has_begun = 0;
}

void gpu_commit(gpu_sculpt *m, int keeps_ghosts, unsigned kept_back_kind)
{
    step(m, GPU_STEP_COUNT);
    gpu_use(m, GPU_RUN_SETTLE);
    glUniform1ui(2, keeps_ghosts ? 1 : 0);
    glUniform1ui(3, kept_back_kind);
    gpu_dispatch_spread(m);
    step(m, GPU_STEP_END);
    record(m, 0);
}

void gpu_give_up(gpu_sculpt *m)
{
    step(m, GPU_STEP_GIVE_UP);
    record(m, 1);
}

static sf_status apply(gpu_sculpt *m, unsigned verb)
{
    if (m == NULL || m->stroke.is_under_way) {
        return SF_ERR_ARGUMENT;
    }
    step(m, verb);
    gpu_use(m, GPU_RUN_APPLY);
    gpu_dispatch_spread(m);
    return SF_OK;
}

sf_status gpu_sculpt_undo(gpu_sculpt *m)
{
    return apply(m, GPU_STEP_UNDO);
}

sf_status gpu_sculpt_redo(gpu_sculpt *m)
{
    return apply(m, GPU_STEP_REDO);
}

sf_status gpu_sculpt_drop_ghosts(gpu_sculpt *m)
{
    if (m == NULL || m->stroke.is_under_way) {
        return SF_ERR_ARGUMENT;
    }
    sf_box all = {0, 0, 0, m->lattice.nx, m->lattice.ny, m->lattice.nz};
    gpu_open(m, all);
    gpu_commit(m, 0, 0);
    return SF_OK;
}

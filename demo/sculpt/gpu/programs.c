// SPDX-License-Identifier: MIT
// Programs: the shaders, the buffers that each names, and how they are run.
//
// Every dispatch is followed by a barrier, because each shader reads what the one before it wrote.
// No dispatch asks how the last one went: what a shader cannot know before it runs (how far a
// cascade reached, how long a step is) it reads from the ledger.

#include <epoxy/gl.h>
#include <stdio.h>

#include "gl/program.h"
#include "model.h"

#define NO GPU_BUFFER_COUNT

typedef struct program {
    const char *name;
    unsigned char own[GPU_OWN_COUNT]; // buffers at binding points 10 to 14
} program;

static const program programs[GPU_RUN_COUNT] = {
    [GPU_RUN_OPEN] = {"open.comp", {NO, NO, NO, NO, NO}},
    [GPU_RUN_STAMP] = {"stamp.comp", {NO, NO, NO, NO, NO}},
    [GPU_RUN_SET] = {"set.comp", {GPU_GROWN, GPU_BRACED, NO, NO, NO}},
    [GPU_RUN_PAINT] = {"paint.comp", {NO, NO, NO, NO, NO}},
    [GPU_RUN_TRIM] = {"trim.comp", {NO, NO, NO, NO, NO}},
    [GPU_RUN_WALK] = {"walk.comp", {NO, NO, NO, NO, NO}},
    [GPU_RUN_PRESERVE] = {"preserve.comp", {NO, NO, GPU_SLICE, GPU_OTHER_SLICES, NO}},
    [GPU_RUN_SMOOTH] = {"smooth.comp", {NO, NO, NO, NO, NO}}, // by pass
    [GPU_RUN_PATH] = {"path.comp", {NO, NO, GPU_LANDINGS, GPU_CHAINS, GPU_SQUARE}},
    [GPU_RUN_BED_ROWS] = {"bed_rows.comp", {NO, NO, NO, GPU_ROW_SQUARE, NO}},
    [GPU_RUN_BED_COLUMNS] = {"bed_columns.comp", {NO, NO, NO, GPU_ROW_SQUARE, GPU_SQUARE}},
    [GPU_RUN_LAND] = {"land.comp", {NO, NO, GPU_LANDINGS, GPU_CHAINS, GPU_SQUARE}},
    [GPU_RUN_EMIT] = {"emit.comp", {GPU_GROWN, NO, GPU_LANDINGS, GPU_CHAINS, GPU_SQUARE}},
    [GPU_RUN_BRACE] = {"brace.comp", {NO, GPU_BRACED, GPU_SLICE, GPU_OTHER_SLICES, NO}},
    [GPU_RUN_SETTLE] = {"settle.comp", {NO, NO, NO, NO, NO}},
    [GPU_RUN_STEP] = {"step.comp", {NO, NO, NO, NO, NO}},
    [GPU_RUN_RECORD] = {"record.comp", {GPU_GROWN, NO, GPU_HISTORY, NO, NO}},
    [GPU_RUN_APPLY] = {"apply.comp", {NO, NO, GPU_HISTORY, NO, NO}},
};

sf_status gpu_programs_create(gpu_sculpt *m)
{
    for (unsigned i = 0; i < GPU_RUN_COUNT; i++) {
        char log[800] = "";
        m->programs[i] = gl_compute_program(programs[i].name, log, sizeof log);
        if (m->programs[i] == 0) {
            snprintf(m->why, sizeof m->why, "The shader %s does not compile here: %s",
                     programs[i].name, log);
            return SF_ERR_INFEASIBLE;
        }
        glProgramUniform4ui(m->programs[i], 0, m->lattice.nx, m->lattice.ny, m->lattice.nz,
                            m->row_words);
        glProgramUniform1ui(m->programs[i], 1, m->options.bed_layer);
    }
    return SF_OK;
}

void gpu_programs_destroy(gpu_sculpt *m)
{
    for (unsigned i = 0; i < GPU_RUN_COUNT; i++) {
        glDeleteProgram(m->programs[i]); // 0 is ignored
    }
}

void gpu_bind_own(const gpu_sculpt *m, const unsigned char own[GPU_OWN_COUNT])
{
    GLuint names[GPU_OWN_COUNT];
    for (unsigned i = 0; i < GPU_OWN_COUNT; i++) {
        names[i] = own[i] != NO ? m->buffers[own[i]] : 0;
    }
    glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, GPU_FIXED_COUNT, GPU_OWN_COUNT, names);
}

void gpu_use(const gpu_sculpt *m, unsigned which)
{
    glUseProgram(m->programs[which]);
    glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, 0, GPU_FIXED_COUNT, m->buffers);
    gpu_bind_own(m, programs[which].own);
}

void gpu_dispatch(uint32_t groups, uint32_t groups_y)
{
    glDispatchCompute(groups, groups_y, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void gpu_dispatch_spread(const gpu_sculpt *m)
{
    size_t groups = m->words / 256 + 1;
    gpu_dispatch(groups < 1024 ? (uint32_t)groups : 1024, 1);
}

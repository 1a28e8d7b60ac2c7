// SPDX-License-Identifier: MIT
// Models: buffers on the card, and whether it can hold them.
//
// Two states, the union of tips and what add-grow adds are a bit for each voxel and twice a byte,
// so 512^3 voxels take some 0.4 GB with the history. All of it is made at once, but for the buffers
// between the passes of a smooth-trim, which are made when first asked for.

#include "model.h"

#include <epoxy/gl.h>
#include <stdio.h>
#include <stdlib.h>

#include "ledger.h"

int gpu_had_memory(void)
{
    int had = 1;
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
        had &= error != GL_OUT_OF_MEMORY;
    }
    return had;
}

gpu_view gpu_sculpt_view(const gpu_sculpt *m)
{
    gpu_view view = {m->buffers[GPU_DRAWN],
                     m->buffers[GPU_PRINTABLE],
                     m->buffers[GPU_MATERIALS],
                     m->buffers[GPU_LEDGER],
                     m->lattice.nx,
                     m->lattice.ny,
                     m->lattice.nz,
                     m->row_words};
    return view;
}

// ---------------------------------------------------------------------------------------------
// What the card can do
// ---------------------------------------------------------------------------------------------

// Points where the current context falls short, as a sentence; NULL where it does not.
static const char *find_fault(void)
{
    GLint bindings = 0, blocks = 0, invocations = 0;
    if (epoxy_gl_version() < 45) {
        return "The brushes on the graphics card need OpenGL 4.5, which is not there.";
    }
    glGetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &bindings);
    glGetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &blocks);
    glGetIntegerv(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, &invocations);
    if (bindings < (GLint)(GPU_FIXED_COUNT + GPU_OWN_COUNT) || blocks < 14 || invocations < 256) {
        return "The graphics card binds too few buffers at once for the brushes.";
    }
    return NULL;
}

static sf_status check_options(const sf_sculpt_options *o, const char **why)
{
    *why = "The options of the model are none.";
    if (o == NULL || o->struct_size < sizeof *o || sf_lattice_validate(&o->lattice) != SF_OK ||
        o->bed_layer >= o->lattice.nz) {
        return SF_ERR_ARGUMENT;
    }
    *why =
        "On the graphics card brushes know the rule box3 only; other rules are served without it.";
    const sf_bridge *b = &o->rule.bridge;
    int has_bridges = b->span_x != 0 || b->span_y != 0 || b->span_diagonal != 0;
    return o->rule.kind == SF_RULE_BOX3 && !has_bridges ? SF_OK : SF_ERR_ARGUMENT;
}

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

static uint64_t bytes_of(const gpu_sculpt *m, unsigned which)
{
    uint64_t area = (uint64_t)m->lattice.nx * m->lattice.ny;
    switch (which) {
    case GPU_MATERIALS:
    case GPU_MATERIALS_BEFORE:
        return (uint64_t)m->words * 32;
    case GPU_LEDGER:
        return sizeof(ledger) + LEDGER_STEPS * 8;
    case GPU_TIP:
        return 64;
    case GPU_PUTS:
        return GPU_PUT_MAX * sizeof(gpu_put);
    case GPU_HISTORY:
        return (uint64_t)m->options.history_size / 4 * 4 + 64;
    case GPU_SLICE:
        return (uint64_t)m->row_words * m->lattice.ny * 4;
    case GPU_OTHER_SLICES:
        return (uint64_t)m->row_words * m->lattice.ny * 4 * 5;
    case GPU_LANDINGS:
        return GPU_PUT_MAX * 16;
    case GPU_CHAINS:
        return (uint64_t)GPU_PUT_MAX * m->lattice.nz * 4;
    case GPU_ROW_SQUARE:
    case GPU_SQUARE:
        return area * 4;
    case GPU_PASS:
    case GPU_PASS_MATERIALS:
        return 0;
    default:
        return m->words * 4;
    }
}

// Whether no buffer is larger than a shader may see.
static int fits(gpu_sculpt *m)
{
    GLint64 most = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    m->block_max = most < 0 || most > INT32_MAX ? INT32_MAX : (size_t)most;
    for (unsigned i = 0; i < GPU_BUFFER_COUNT; i++) {
        if (bytes_of(m, i) > m->block_max) {
            return 0;
        }
    }
    return 1;
}

static void make_buffers(gpu_sculpt *m)
{
    glCreateBuffers(GPU_BUFFER_COUNT, m->buffers);
    for (unsigned i = 0; i < GPU_BUFFER_COUNT; i++) {
        GLsizeiptr size = (GLsizeiptr)bytes_of(m, i);
        if (i == GPU_TIP) {
            glNamedBufferData(m->buffers[i], size, NULL, GL_STREAM_DRAW);
        } else if (size > 0) {
            glNamedBufferStorage(m->buffers[i], size, NULL, GL_DYNAMIC_STORAGE_BIT);
        } else {
            glDeleteBuffers(1, &m->buffers[i]);
            m->buffers[i] = 0;
        }
        if (size > 0) {
            glClearNamedBufferData(m->buffers[i], GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, NULL);
        }
    }
    ledger l = {.capacity = (uint32_t)(m->options.history_size / 4)};
    glNamedBufferSubData(m->buffers[GPU_LEDGER], 0, sizeof l, &l);
}

static sf_status fill(gpu_sculpt *m)
{
    if (!fits(m)) {
        snprintf(m->why, sizeof m->why,
                 "The model or its history is larger than the graphics card's largest buffer.");
        return SF_ERR_OVERFLOW;
    }
    (void)gpu_had_memory(); // what went wrong before is not ours
    sf_status status = gpu_programs_create(m);
    if (status != SF_OK) {
        return status;
    }
    make_buffers(m);
    if (!gpu_had_memory()) {
        snprintf(m->why, sizeof m->why, "The graphics card has too little memory for the model.");
        return SF_ERR_MEMORY;
    }
    return SF_OK;
}

sf_status gpu_sculpt_create(const sf_sculpt_options *options, const char **why, gpu_sculpt **model)
{
    static char last[sizeof((gpu_sculpt *)0)->why];
    sf_status status = check_options(options, why);
    if (status != SF_OK) {
        return status;
    }
    *why = find_fault();
    if (*why != NULL) {
        return SF_ERR_INFEASIBLE;
    }
    gpu_sculpt *made = calloc(1, sizeof *made);
    if (made == NULL) {
        *why = "There is no memory for the model.";
        return SF_ERR_MEMORY;
    }
    made->options = *options;
    made->lattice = options->lattice;
    made->lattice.heights_mm = made->options.lattice.heights_mm = NULL;
    made->row_words = (options->lattice.nx + 63) / 64 * 2;
    made->words = (size_t)made->row_words * options->lattice.ny * options->lattice.nz;
    status = fill(made);
    if (status != SF_OK) {
        snprintf(last, sizeof last, "%s", made->why);
        *why = last;
        gpu_sculpt_destroy(made);
        return status;
    }
    *model = made;
    return SF_OK;
}

void gpu_sculpt_destroy(gpu_sculpt *m)
{
    if (m != NULL) {
        gpu_programs_destroy(m);
        glDeleteBuffers(GPU_BUFFER_COUNT, m->buffers);
        free(m);
    }
}

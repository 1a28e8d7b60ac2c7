// SPDX-License-Identifier: MIT
// Strokes: dabs go to the card, and the shaders do the rest.
//
// The host knows where tips are put, so it computes the boxes around them; what then happens within
// these only the card knows. The same checks as in libsf/sculpt/stroke.c, before anything is done.

#include <epoxy/gl.h>
#include <stdlib.h>

#include "model.h"

#define DAB_MAX (INT32_C(1) << 30)

static sf_box join(sf_box a, sf_box b)
{
    if (a.x0 >= a.x1) {
        return b;
    }
    if (b.x0 >= b.x1) {
        return a;
    }
    sf_box all = {a.x0 < b.x0 ? a.x0 : b.x0, a.y0 < b.y0 ? a.y0 : b.y0, a.z0 < b.z0 ? a.z0 : b.z0,
                  a.x1 > b.x1 ? a.x1 : b.x1, a.y1 > b.y1 ? a.y1 : b.y1, a.z1 > b.z1 ? a.z1 : b.z1};
    return all;
}

// ---------------------------------------------------------------------------------------------
// Puts
// ---------------------------------------------------------------------------------------------

// low <= i < low + size, clipped to 0 <= i < end; returns whether anything is left.
static int clip(int64_t low, uint32_t size, uint32_t end, uint32_t *from, uint32_t *to)
{
    int64_t high = low + size;
    *from = low > 0 ? (uint32_t)(low < end ? low : end) : 0;
    *to = high > 0 ? (uint32_t)(high < end ? high : end) : 0;
    return *from < *to;
}

// A dab put in one way. Returns whether it does anything; *box is where its tip lies in the grid.
static int make_put(const gpu_sculpt *m, sf_dab d, unsigned way, gpu_put *put, sf_box *box)
{
    const gpu_stroke *s = &m->stroke;
    const sf_lattice *l = &m->lattice;
    int64_t x = way & 1 ? (int64_t)l->nx - 1 - d.x : d.x,
            y = way & 2 ? (int64_t)l->ny - 1 - d.y : d.y;
    int64_t ax = way & 1 ? (int64_t)s->tip_nx - 1 - s->anchor.x : s->anchor.x;
    int64_t ay = way & 2 ? (int64_t)s->tip_ny - 1 - s->anchor.y : s->anchor.y;
    int64_t corner[3] = {x - ax, y - ay, (int64_t)d.z - s->anchor.z};
    sf_box b, none = {0, 0, 0, 0, 0, 0};
    int covers = clip(corner[0], s->tip_nx, l->nx, &b.x0, &b.x1) &
                 clip(corner[1], s->tip_ny, l->ny, &b.y0, &b.y1) &
                 clip(corner[2], s->tip_nz, l->nz, &b.z0, &b.z1);
    int has_path = s->brush.kind == SF_BRUSH_ADD_GROW && x >= 0 && x < l->nx && y >= 0 &&
                   y < l->ny && d.z >= 0 && d.z < (int64_t)l->nz;
    *box = covers ? b : none;
    if (!covers && !has_path) {
        return 0;
    }
    // What covers something or lies in the grid fits 32 bits: anchors and dabs are within 2^30.
    gpu_put made = {(int32_t)x,         (int32_t)y,         d.z, (int32_t)corner[0],
                    (int32_t)corner[1], (int32_t)corner[2], way, 0};
    *put = made;
    return 1;
}

// Ways that the brush's mirrors ask for: the next after `way`, 4 after the last.
static unsigned next_way(const gpu_sculpt *m, unsigned way)
{
    unsigned mirrors = (m->stroke.brush.mirror_x ? 1u : 0) | (m->stroke.brush.mirror_y ? 2u : 0);
    do {
        way++;
    } while (way < 4 && (way & ~mirrors) != 0);
    return way;
}

// The box around the tips of dabs, and whether any of them does anything.
static int find_box(const gpu_sculpt *m, const sf_dab *dabs, size_t count, sf_box *fresh)
{
    int does_anything = 0;
    for (size_t i = 0; i < count; i++) {
        for (unsigned way = 0; way < 4; way = next_way(m, way)) {
            gpu_put put;
            sf_box box;
            if (make_put(m, dabs[i], way, &put, &box)) {
                *fresh = join(*fresh, box);
                does_anything = 1;
            }
        }
    }
    return does_anything;
}

static void send_puts(gpu_sculpt *m, const gpu_put *puts, uint32_t count)
{
    uint32_t row = (m->stroke.tip_nx + 31) / 32;
    uint32_t pieces = (row + 1) * m->stroke.tip_ny * m->stroke.tip_nz;
    if (count > 0) {
        glNamedBufferSubData(m->buffers[GPU_PUTS], 0, (GLsizeiptr)(count * sizeof *puts), puts);
        gpu_use(m, GPU_RUN_STAMP);
        gpu_dispatch((pieces + 63) / 64, count);
        if (m->stroke.brush.kind == SF_BRUSH_ADD_GROW) {
            gpu_brush_paths(m, count, (pieces + 63) / 64);
        }
    }
}

static void put_tips(gpu_sculpt *m, const sf_dab *dabs, size_t count)
{
    gpu_put puts[GPU_PUT_MAX];
    uint32_t filled = 0;
    for (size_t i = 0; i < count; i++) {
        for (unsigned way = 0; way < 4; way = next_way(m, way)) {
            sf_box box;
            filled += (uint32_t)make_put(m, dabs[i], way, &puts[filled], &box);
            if (filled == GPU_PUT_MAX) {
                send_puts(m, puts, filled);
                filled = 0;
            }
        }
    }
    send_puts(m, puts, filled);
}

// ---------------------------------------------------------------------------------------------
// Tips
// ---------------------------------------------------------------------------------------------

// A row of a tip as it is, and mirrored; `to` is 0 on entry.
static void write_row(const uint64_t *row, uint32_t row_words, uint32_t *to)
{
    for (uint32_t i = 0; i < row_words; i++) {
        to[i] = (uint32_t)(row[i / 2] >> i % 2 * 32);
    }
}

static void write_mirrored(sf_slice slice, uint32_t y, uint32_t *to)
{
    for (uint32_t x = 0; x < slice.width; x++) {
        uint32_t at = slice.width - 1 - x;
        to[at / 32] |= (uint32_t)sf_slice_get(slice, x, y) << at % 32;
    }
}

// One way of a tip.
static void write_way(const sf_grid *mask, unsigned way, uint32_t row_words, uint32_t *words)
{
    sf_lattice l = sf_grid_lattice(mask);
    for (uint32_t z = 0; z < l.nz; z++) {
        sf_slice slice = sf_grid_slice(mask, z);
        for (uint32_t y = 0; y < l.ny; y++) {
            uint32_t to = way & 2 ? l.ny - 1 - y : y;
            uint32_t *row = words + ((size_t)z * l.ny + to) * row_words;
            if (way & 1) {
                write_mirrored(slice, y, row);
            } else {
                write_row(slice.words + y * slice.stride, row_words, row);
            }
        }
    }
}

// The tip, in each way up to the last that is asked for, in its buffer.
static sf_status send_tip(gpu_sculpt *m, const sf_brush *brush)
{
    const sf_grid *mask = sf_tip_mask(brush->tip, &m->stroke.anchor);
    sf_lattice l = sf_grid_lattice(mask);
    unsigned ways = 1 + (brush->mirror_x ? 1u : 0) + (brush->mirror_y ? 2u : 0);
    uint32_t row_words = (l.nx + 31) / 32;
    size_t one = (size_t)row_words * l.ny * l.nz;
    if (one > m->block_max / 4 / ways) {
        return SF_ERR_MEMORY;
    }
    uint32_t *words = calloc(one, ways * sizeof *words);
    if (words == NULL) {
        return SF_ERR_MEMORY;
    }
    for (unsigned way = 0; way < 4; way = next_way(m, way)) {
        write_way(mask, way, row_words, words + way * one);
    }
    glNamedBufferData(m->buffers[GPU_TIP], (GLsizeiptr)(one * ways * sizeof *words), words,
                      GL_STREAM_DRAW);
    free(words);
    static const unsigned users[] = {GPU_RUN_STAMP, GPU_RUN_EMIT, GPU_RUN_LAND};
    for (unsigned i = 0; i < sizeof users / sizeof *users; i++) {
        glProgramUniform4ui(m->programs[users[i]], 5, row_words, l.ny, l.nz, (GLuint)one);
    }
    m->stroke.tip_nx = l.nx;
    m->stroke.tip_ny = l.ny;
    m->stroke.tip_nz = l.nz;
    return gpu_had_memory() ? SF_OK : SF_ERR_MEMORY;
}

// What passes of smooth-trim go to and fro between, when more than one is asked for first.
static sf_status make_pass(gpu_sculpt *m)
{
    if (m->buffers[GPU_PASS] != 0) {
        return SF_OK;
    }
    GLuint made[2];
    glCreateBuffers(2, made);
    glNamedBufferStorage(made[0], (GLsizeiptr)(m->words * 4), NULL, 0);
    glNamedBufferStorage(made[1], (GLsizeiptr)(m->words * 32), NULL, 0);
    if (!gpu_had_memory()) {
        glDeleteBuffers(2, made);
        return SF_ERR_MEMORY;
    }
    m->buffers[GPU_PASS] = made[0];
    m->buffers[GPU_PASS_MATERIALS] = made[1];
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The calls
// ---------------------------------------------------------------------------------------------

static int is_brush(const sf_brush *b)
{
    return b != NULL && b->struct_size >= sizeof *b && sf_brush_kind_name(b->kind) != NULL &&
           b->tip != NULL && b->material != 0 && b->passes >= 1 && b->passes <= SF_BRUSH_PASSES_MAX;
}

sf_status gpu_sculpt_begin(gpu_sculpt *m, const sf_brush *brush)
{
    if (m == NULL || m->stroke.is_under_way || !is_brush(brush)) {
        return SF_ERR_ARGUMENT;
    }
    gpu_stroke stroke = {.is_under_way = 0, .brush = *brush};
    m->stroke = stroke;
    sf_status status = send_tip(m, brush);
    if (status == SF_OK && brush->kind == SF_BRUSH_SMOOTH_TRIM && brush->passes > 1) {
        status = make_pass(m);
    }
    m->stroke.is_under_way = status == SF_OK;
    return status;
}

// Where this call changes what is drawn, as far as the host knows.
static sf_box box_to_open(const gpu_sculpt *m, sf_box fresh)
{
    sf_box all = m->stroke.tips;
    switch (m->stroke.brush.kind) {
    case SF_BRUSH_REMOVE_PRESERVE:
    case SF_BRUSH_SMOOTH_TRIM:
        return all;
    case SF_BRUSH_ADD_GROW: // braces reach down to the bed
        all = gpu_brace_box(m);
        all.z0 = all.x0 < all.x1 && m->options.bed_layer < all.z0 ? m->options.bed_layer : all.z0;
        return all;
    default:
        return fresh;
    }
}

static int are_dabs(const sf_dab *dabs, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const int32_t numbers[3] = {dabs[i].x, dabs[i].y, dabs[i].z};
        for (int k = 0; k < 3; k++) {
            if (numbers[k] < -DAB_MAX || numbers[k] > DAB_MAX) {
                return 0;
            }
        }
    }
    return 1;
}

sf_status gpu_sculpt_dab(gpu_sculpt *m, const sf_dab *dabs, size_t count)
{
    if (m == NULL || !m->stroke.is_under_way || (dabs == NULL && count > 0) ||
        !are_dabs(dabs, count)) {
        return SF_ERR_ARGUMENT;
    }
    sf_box fresh = {0, 0, 0, 0, 0, 0};
    if (!find_box(m, dabs, count, &fresh)) {
        return SF_OK;
    }
    m->stroke.tips = join(m->stroke.tips, fresh);
    gpu_open(m, box_to_open(m, fresh));
    put_tips(m, dabs, count);
    gpu_brush_apply(m);
    return SF_OK;
}

// 0 none, 1 of the tips what is not printable, 2 what is.
static unsigned kept_back_kind(sf_brush_kind kind)
{
    int adds = kind == SF_BRUSH_ADD_TRIM || kind == SF_BRUSH_ADD_GROW;
    return adds ? 1 : kind == SF_BRUSH_REMOVE_PRESERVE ? 2 : 0;
}

sf_status gpu_sculpt_end(gpu_sculpt *m)
{
    if (m == NULL || !m->stroke.is_under_way) {
        return SF_ERR_ARGUMENT;
    }
    sf_box none = {0, 0, 0, 0, 0, 0};
    if (!m->stroke.has_begun) {
        gpu_open(m, none);
    }
    gpu_commit(m, m->options.keep_drawn, kept_back_kind(m->stroke.brush.kind));
    return SF_OK;
}

sf_status gpu_sculpt_abandon(gpu_sculpt *m)
{
    if (m == NULL) {
        return SF_ERR_ARGUMENT;
    }
    if (m->stroke.is_under_way) {
        sf_box none = {0, 0, 0, 0, 0, 0};
        if (!m->stroke.has_begun) {
            gpu_open(m, none);
        }
        gpu_give_up(m);
    }
    return SF_OK;
}

sf_status gpu_sculpt_stroke(gpu_sculpt *m, const sf_brush *brush, const sf_dab *dabs, size_t count)
{
    sf_status status = gpu_sculpt_begin(m, brush);
    if (status != SF_OK) {
        return status;
    }
    status = gpu_sculpt_dab(m, dabs, count);
    if (status != SF_OK) {
        (void)gpu_sculpt_abandon(m);
        return status;
    }
    return gpu_sculpt_end(m);
}

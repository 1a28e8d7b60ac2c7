// SPDX-License-Identifier: MIT
// Transfer: a shape goes to the card, and comes back. The only file that reads anything back.
//
// Words of libsf have 64 bits, those of the card 32; a row goes over as the halves of its words,
// whatever the machine's order of bytes.

#include <epoxy/gl.h>
#include <stdlib.h>

#include "ledger.h"
#include "model.h"

static int is_shape(const gpu_sculpt *m, const sf_grid *grid)
{
    sf_lattice l = sf_grid_lattice(grid);
    return l.nx == m->lattice.nx && l.ny == m->lattice.ny && l.nz == m->lattice.nz;
}

// ---------------------------------------------------------------------------------------------
// To the card
// ---------------------------------------------------------------------------------------------

static void pack(const gpu_sculpt *m, const sf_grid *grid, uint32_t *words)
{
    for (uint32_t z = 0; z < m->lattice.nz; z++) {
        sf_slice slice = sf_grid_slice(grid, z);
        for (uint32_t y = 0; y < slice.height; y++) {
            const uint64_t *row = slice.words + y * slice.stride;
            for (uint32_t i = 0; i < m->row_words; i += 2) {
                words[i] = (uint32_t)row[i / 2];
                words[i + 1] = (uint32_t)(row[i / 2] >> 32);
            }
            words += m->row_words;
        }
    }
}

static int is_solid(const uint32_t *words, size_t voxel)
{
    return (int)(words[voxel / 32] >> voxel % 32 & 1);
}

// Bytes in the card's order, 0 where nothing is drawn, 1 where nothing is said.
static void pack_materials(const gpu_sculpt *m, const uint32_t *drawn, const uint8_t *from,
                           uint32_t *to)
{
    size_t rows = (size_t)m->lattice.ny * m->lattice.nz, row_bytes = (size_t)m->row_words * 32;
    for (size_t y = 0; y < rows; y++) {
        for (uint32_t x = 0; x < m->lattice.nx; x++) {
            size_t voxel = y * row_bytes + x;
            uint32_t said = from != NULL ? from[y * m->lattice.nx + x] : 1;
            said = said == 0 ? 1 : said;
            to[voxel / 4] |= is_solid(drawn, voxel) ? said << voxel % 4 * 8 : 0;
        }
    }
}

static void send(const gpu_sculpt *m, const uint32_t *bits, const uint32_t *materials)
{
    glNamedBufferSubData(m->buffers[GPU_DRAWN], 0, (GLsizeiptr)(m->words * 4), bits);
    glNamedBufferSubData(m->buffers[GPU_MATERIALS], 0, (GLsizeiptr)(m->words * 32), materials);
    gpu_use(m, GPU_RUN_TRIM);
    for (uint32_t z = 0; z < m->lattice.nz; z++) {
        glUniform1ui(2, z);
        gpu_dispatch((m->row_words * m->lattice.ny + 63) / 64, 1);
    }
}

sf_status gpu_sculpt_replace(gpu_sculpt *m, const sf_grid *drawn, const uint8_t *materials)
{
    if (m == NULL || m->stroke.is_under_way) {
        return SF_ERR_ARGUMENT;
    }
    if (drawn != NULL && !is_shape(m, drawn)) {
        return SF_ERR_SHAPE;
    }
    uint32_t *bits = calloc(m->words, sizeof *bits), *bytes = calloc(m->words, 32);
    if (bits == NULL || bytes == NULL) {
        free(bits);
        free(bytes);
        return SF_ERR_MEMORY;
    }
    if (drawn != NULL) {
        pack(m, drawn, bits);
        pack_materials(m, bits, materials, bytes);
    }
    sf_box all = {0, 0, 0, m->lattice.nx, m->lattice.ny, m->lattice.nz};
    gpu_open(m, all);
    send(m, bits, bytes);
    gpu_commit(m, m->options.keep_drawn, 0);
    free(bits);
    free(bytes);
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Back
// ---------------------------------------------------------------------------------------------

static void unpack(const gpu_sculpt *m, const uint32_t *words, sf_grid *grid)
{
    for (uint32_t z = 0; z < m->lattice.nz; z++) {
        sf_slice slice = sf_grid_slice(grid, z);
        for (uint32_t y = 0; y < slice.height; y++) {
            uint64_t *row = slice.words + y * slice.stride;
            for (uint32_t i = 0; i < m->row_words; i += 2) {
                row[i / 2] = words[i] | (uint64_t)words[i + 1] << 32;
            }
            words += m->row_words;
        }
    }
}

static void unpack_materials(const gpu_sculpt *m, const uint32_t *from, uint8_t *to)
{
    size_t rows = (size_t)m->lattice.ny * m->lattice.nz, row_bytes = (size_t)m->row_words * 32;
    for (size_t y = 0; y < rows; y++) {
        for (uint32_t x = 0; x < m->lattice.nx; x++) {
            size_t voxel = y * row_bytes + x;
            *to++ = (uint8_t)(from[voxel / 4] >> voxel % 4 * 8);
        }
    }
}

sf_status gpu_sculpt_fetch(const gpu_sculpt *m, sf_grid *drawn, sf_grid *printable,
                           uint8_t *materials)
{
    if (m == NULL) {
        return SF_ERR_ARGUMENT;
    }
    if ((drawn != NULL && !is_shape(m, drawn)) || (printable != NULL && !is_shape(m, printable))) {
        return SF_ERR_SHAPE;
    }
    sf_grid *grids[2] = {drawn, printable};
    static const unsigned char buffers[2] = {GPU_DRAWN, GPU_PRINTABLE};
    uint32_t *words = malloc(m->words * (materials != NULL ? 32 : 4));
    if (words == NULL) {
        return SF_ERR_MEMORY;
    }
    for (int i = 0; i < 2; i++) {
        if (grids[i] != NULL) {
            glGetNamedBufferSubData(m->buffers[buffers[i]], 0, (GLsizeiptr)(m->words * 4), words);
            unpack(m, words, grids[i]);
        }
    }
    if (materials != NULL) {
        glGetNamedBufferSubData(m->buffers[GPU_MATERIALS], 0, (GLsizeiptr)(m->words * 32), words);
        unpack_materials(m, words, materials);
    }
    free(words);
    return SF_OK;
}

sf_status gpu_sculpt_report(const gpu_sculpt *m, gpu_report *report)
{
    if (m == NULL || report == NULL) {
        return SF_ERR_ARGUMENT;
    }
    ledger l;
    glGetNamedBufferSubData(m->buffers[GPU_LEDGER], 0, sizeof l, &l);
    gpu_report made = {l.added_voxels, l.removed_voxels, l.lost_voxels,  l.kept_back_voxels,
                       l.path_voxels,  l.here - l.first, l.end - l.here, l.forgotten};
    *report = made;
    return SF_OK;
}

// SPDX-License-Identifier: MIT
// A model of the library's, copied to where a view looks for it, row by row of what changed.

#include "upload.h"

#include <epoxy/gl.h>
#include <stdlib.h>
#include <string.h>

struct view_upload {
    GLuint buffers[3]; // drawn, printable, materials
    gpu_view view;
    uint8_t *layer; // of materials, rows padded to whole words
};

view_upload *view_upload_create(const sf_lattice *lattice, const char **why)
{
    GLint64 most = 0;
    uint32_t row_words = (lattice->nx + 63) / 64 * 2;
    size_t words = (size_t)row_words * lattice->ny * lattice->nz;
    view_upload *made = calloc(1, sizeof *made);
    *why = "There is no memory for the model's copy on the graphics card.";
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    if (made == NULL || (made->layer = malloc((size_t)row_words * 32 * lattice->ny)) == NULL) {
        free(made);
        return NULL;
    }
    if (words * 32 > (size_t)most) {
        *why = "The model is too large for this graphics card; take fewer voxels.";
        free(made->layer);
        free(made);
        return NULL;
    }
    const size_t sizes[3] = {words * 4, words * 4, words * 32};
    while (glGetError() != GL_NO_ERROR) {
    }
    glCreateBuffers(3, made->buffers);
    for (int i = 0; i < 3; i++) {
        glNamedBufferStorage(made->buffers[i], (GLsizeiptr)sizes[i], NULL, GL_DYNAMIC_STORAGE_BIT);
        glClearNamedBufferData(made->buffers[i], GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, NULL);
    }
    gpu_view view = {made->buffers[0], made->buffers[1], made->buffers[2], 0,
                     lattice->nx,      lattice->ny,      lattice->nz,      row_words};
    made->view = view;
    if (glGetError() != GL_NO_ERROR) {
        view_upload_destroy(made);
        return NULL;
    }
    *why = NULL;
    return made;
}

void view_upload_destroy(view_upload *upload)
{
    if (upload != NULL) {
        glDeleteBuffers(3, upload->buffers);
        free(upload->layer);
        free(upload);
    }
}

// Words of a row as the card has them: each of the library's is two, the low half first.
static void halve(const uint64_t *from, uint32_t count, uint32_t *to)
{
    for (uint32_t i = 0; i < count; i++) {
        to[i] = (uint32_t)(from[i / 2] >> (i % 2 * 32));
    }
}

// Rows y0 to y1 of a layer of bits.
static void copy_bits(const view_upload *u, GLuint buffer, sf_slice slice, uint32_t z, uint32_t y0,
                      uint32_t y1, uint32_t *scratch)
{
    uint32_t row_words = u->view.row_words;
    for (uint32_t y = y0; y < y1; y++) {
        halve(slice.words + (size_t)y * slice.stride, row_words,
              scratch + (size_t)(y - y0) * row_words);
    }
    glNamedBufferSubData(buffer, (GLintptr)(((size_t)z * u->view.ny + y0) * row_words * 4),
                         (GLsizeiptr)((size_t)(y1 - y0) * row_words * 4), scratch);
}

static void copy_materials(const view_upload *u, const uint8_t *materials, uint32_t z, uint32_t y0,
                           uint32_t y1)
{
    size_t padded = (size_t)u->view.row_words * 32, first = (size_t)z * u->view.ny + y0;
    memset(u->layer, materials == NULL, padded * (y1 - y0));
    for (uint32_t y = y0; materials != NULL && y < y1; y++) {
        memcpy(u->layer + padded * (y - y0), materials + ((size_t)z * u->view.ny + y) * u->view.nx,
               u->view.nx);
    }
    glNamedBufferSubData(u->buffers[2], (GLintptr)(first * padded),
                         (GLsizeiptr)(padded * (y1 - y0)), u->layer);
}

int view_upload_copy(view_upload *upload, const sf_grid *drawn, const sf_grid *printable,
                     const uint8_t *materials, const sf_box *box)
{
    gpu_view v = upload->view;
    sf_box all = {0, 0, 0, v.nx, v.ny, v.nz}, b = box != NULL ? *box : all;
    if (b.y0 >= b.y1 || b.z0 >= b.z1) {
        return 1;
    }
    uint32_t *scratch = malloc((size_t)(b.y1 - b.y0) * v.row_words * sizeof *scratch);
    if (scratch == NULL) {
        return 0;
    }
    for (uint32_t z = b.z0; z < b.z1; z++) {
        copy_bits(upload, upload->buffers[0], sf_grid_slice(drawn, z), z, b.y0, b.y1, scratch);
        copy_bits(upload, upload->buffers[1], sf_grid_slice(printable, z), z, b.y0, b.y1, scratch);
        copy_materials(upload, materials, z, b.y0, b.y1);
    }
    free(scratch);
    return 1;
}

gpu_view view_upload_view(const view_upload *upload)
{
    return upload->view;
}

// SPDX-License-Identifier: MIT
// Twins: a model on the graphics card and one of the library, made by the same options, and what of
// them differs. A context without a screen; without it a test fails, unless SF_NO_GL=1 says that
// there is none to be had.

#ifndef SF_TEST_GL_TWIN_H
#define SF_TEST_GL_TWIN_H

#include "gl/headless.h"
#include "gpu/gpu_sculpt.h"
#include "test.h"

#include <sf/sculpt.h>

// Whether the program can go on; else it should return gl_status.
static int gl_status;

static inline int gl_begin(gl_headless **context)
{
    const char *no_gl = getenv("SF_NO_GL"), *why = "";
    if (no_gl != NULL && strcmp(no_gl, "1") == 0) {
        printf("1..0 # SKIP SF_NO_GL=1: there is no OpenGL 4.5\n");
        return 0;
    }
    *context = gl_headless_create(&why);
    if (*context == NULL) {
        printf("not ok 1 - a context without a screen\n# %s\n1..1\n", why);
        gl_status = 1;
    }
    return *context != NULL;
}

typedef struct twin {
    sf_sculpt_options options;
    sf_sculpt *cpu;
    gpu_sculpt *gpu;
    sf_grid *drawn, *printable; // as fetched
    uint8_t *materials;
    size_t voxels;
} twin;

static inline sf_sculpt_options twin_options(uint32_t nx, uint32_t ny, uint32_t nz)
{
    sf_sculpt_options options = sf_sculpt_options_default();
    sf_lattice lattice = {nx, ny, nz, 1, 1, 1, NULL, {0, 0, 0}};
    options.lattice = lattice;
    options.history_size = (size_t)16 << 20;
    return options;
}

static inline twin twin_new(const sf_sculpt_options *options)
{
    twin t = {.options = *options};
    const sf_lattice *l = &options->lattice;
    const char *why = "";
    t.voxels = (size_t)l->nx * l->ny * l->nz;
    t.materials = malloc(t.voxels);
    CHECK(t.materials != NULL);
    CHECK(sf_sculpt_create(options, NULL, &t.cpu) == SF_OK);
    CHECK(gpu_sculpt_create(options, &why, &t.gpu) == SF_OK);
    CHECK(sf_grid_create(l, NULL, &t.drawn) == SF_OK);
    CHECK(sf_grid_create(l, NULL, &t.printable) == SF_OK);
    if (t.gpu == NULL) {
        printf("# %s\n", why);
    }
    return t;
}

static inline void twin_free(twin *t)
{
    sf_grid_destroy(t->drawn);
    sf_grid_destroy(t->printable);
    sf_sculpt_destroy(t->cpu);
    gpu_sculpt_destroy(t->gpu);
    free(t->materials);
}

// 0 where the twins are the same; else 1 drawn, 2 printable, 4 materials differ.
static inline int twin_differs(twin *t)
{
    CHECK(gpu_sculpt_fetch(t->gpu, t->drawn, t->printable, t->materials) == SF_OK);
    int differs = !sf_grid_equal(t->drawn, sf_sculpt_drawn(t->cpu));
    differs |= !sf_grid_equal(t->printable, sf_sculpt_printable(t->cpu)) * 2;
    differs |= (memcmp(t->materials, sf_sculpt_materials(t->cpu), t->voxels) != 0) * 4;
    return differs;
}

#endif

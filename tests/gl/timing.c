// SPDX-License-Identifier: MIT
// How long the brushes take on this machine's OpenGL, whatever that is: strokes of one dab of
// radius 20 in places all over a model of 512^3, each waited for. Built with the tests and run by
// hand; after the strokes the model is compared with the library's, so that what was measured was
// right.

#include <epoxy/gl.h>
#include <time.h>

#include "twin.h"

#define DABS 60

static double now_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void say(const char *what, double *ms, int count)
{
    qsort(ms, (size_t)count, sizeof *ms, by_size);
    printf("# %-16s median %7.2f ms   worst %7.2f ms\n", what, ms[count / 2], ms[count - 1]);
    fflush(stdout);
}

// A shape for brushes to work on: a thick shell of hills.
static void put_hills(twin *t)
{
    const sf_lattice *l = &t->options.lattice;
    for (uint32_t z = 0; z < l->nz; z++) {
        for (uint32_t y = 0; y < l->ny; y++) {
            uint32_t half = l->nx / 2, up = z / 3 + (y / 40 % 2) * 12;
            sf_rect row = {up < half ? up : half, y, l->nx - (up < half ? up : half), y + 1};
            if (row.x0 < row.x1 && y > z / 4 && y + z / 4 < l->ny) {
                CHECK(sf_slice_fill(sf_grid_slice(t->drawn, z), row, 1) == SF_OK);
            }
        }
    }
    CHECK(sf_sculpt_replace(t->cpu, t->drawn, NULL, NULL) == SF_OK);
    double start = now_ms();
    CHECK(gpu_sculpt_replace(t->gpu, t->drawn, NULL) == SF_OK);
    glFinish();
    printf("# %-16s %.1f ms\n", "whole model", now_ms() - start);
}

static void time_brush(twin *t, sf_brush_kind kind, const sf_tip *tip)
{
    double ms[DABS], undo_ms[DABS];
    uint32_t n = t->options.lattice.nx;
    sf_brush brush = sf_brush_default();
    brush.kind = kind;
    brush.tip = tip;
    brush.material = 2;
    for (int i = -1; i < DABS; i++) { // the first compiles, and does not count
        sf_dab dab = {(int32_t)test_random_below(n), (int32_t)test_random_below(n),
                      (int32_t)test_random_below(n - 60)};
        CHECK(sf_sculpt_stroke(t->cpu, &brush, &dab, 1, NULL) == SF_OK);
        glFinish();
        double start = now_ms();
        CHECK(gpu_sculpt_stroke(t->gpu, &brush, &dab, 1) == SF_OK);
        glFinish();
        double end = now_ms();
        CHECK(gpu_sculpt_undo(t->gpu) == SF_OK);
        glFinish();
        ms[i < 0 ? 0 : i] = end - start;
        undo_ms[i < 0 ? 0 : i] = now_ms() - end;
        CHECK(gpu_sculpt_redo(t->gpu) == SF_OK);
    }
    say(sf_brush_kind_name(kind), ms, DABS);
    say("  its undo", undo_ms, DABS);
}

static void at_512(void)
{
    sf_sculpt_options options = twin_options(512, 512, 512);
    options.history_size = (size_t)64 << 20;
    twin t = twin_new(&options);
    sf_tip *tip = NULL;
    const double radius[3] = {20, 20, 20};
    CHECK(sf_tip_create(SF_TIP_SPHERE, radius, NULL, &tip) == SF_OK);
    put_hills(&t);
    for (int kind = 0; kind < SF_BRUSH_KIND_COUNT; kind++) {
        time_brush(&t, (sf_brush_kind)kind, tip);
    }
    CHECK_EQ(twin_differs(&t), 0);
    sf_tip_destroy(tip);
    twin_free(&t);
}

int main(void)
{
    gl_headless *context = NULL;
    if (!gl_begin(&context)) {
        return gl_status;
    }
    printf("# %s\n", (const char *)glGetString(GL_RENDERER));
    TEST(at_512);
    gl_headless_destroy(context);
    return test_finish();
}

// SPDX-License-Identifier: MIT
// The promise that a model lives on the graphics card: no stroke, undo or redo reads anything back
// or waits for the card, and how many dispatches a call takes depends on its brush and its dabs
// alone, not on how far a cascade reaches. All calls of OpenGL that could are counted by a shim.
// After two hundred strokes on trust the model is the library's, bit for bit.

#include "random_strokes.h"
#include "shim.h"
#include "twin.h"

static void no_readback_between_strokes(void)
{
    sf_sculpt_options options = twin_options(64, 64, 64);
    twin t = twin_new(&options);
    shim_readbacks = 0;
    for (int i = 0; i < 200; i++) {
        random_stroke s = random_stroke_new(&options.lattice, 8);
        CHECK(sf_sculpt_stroke(t.cpu, &s.brush, s.dabs, s.count, NULL) == SF_OK);
        CHECK(gpu_sculpt_stroke(t.gpu, &s.brush, s.dabs, s.count) == SF_OK);
        if (i % 7 == 6) {
            CHECK(sf_sculpt_undo(t.cpu, NULL) == SF_OK);
            CHECK(gpu_sculpt_undo(t.gpu) == SF_OK);
        }
        if (i % 14 == 13) {
            CHECK(sf_sculpt_redo(t.cpu, NULL) == SF_OK);
            CHECK(gpu_sculpt_redo(t.gpu) == SF_OK);
        }
        random_stroke_free(&s);
    }
    CHECK_EQ(shim_readbacks, 0);
    CHECK_EQ(twin_differs(&t), 0);
    CHECK(shim_readbacks > 0); // so the shim sees them
    twin_free(&t);
}

// Dispatches of a stroke of one dab of a ball at a height.
static long dispatches(twin *t, sf_brush_kind kind, uint32_t passes, int32_t z)
{
    sf_brush brush = sf_brush_default();
    sf_tip *tip = NULL;
    const double radius[3] = {5, 5, 5};
    sf_dab dab = {30, 30, z};
    CHECK(sf_tip_create(SF_TIP_SPHERE, radius, NULL, &tip) == SF_OK);
    brush.kind = kind;
    brush.tip = tip;
    brush.passes = passes;
    shim_dispatches = 0;
    CHECK(gpu_sculpt_stroke(t->gpu, &brush, &dab, 1) == SF_OK);
    CHECK(sf_sculpt_stroke(t->cpu, &brush, &dab, 1, NULL) == SF_OK);
    sf_tip_destroy(tip);
    return shim_dispatches;
}

static void as_many_dispatches_whatever_falls(void)
{
    sf_sculpt_options options = twin_options(64, 64, 64);
    twin t = twin_new(&options);
    long first = dispatches(&t, SF_BRUSH_ADD_TRIM, 1, 60); // in the air: nothing stays
    for (int32_t z = 0; z < 60; z += 3) {                  // a pillar
        CHECK_EQ(dispatches(&t, SF_BRUSH_ADD_TRIM, 1, z), first);
    }
    CHECK(sf_grid_popcount(sf_sculpt_printable(t.cpu)) > 3000);
    long falls = dispatches(&t, SF_BRUSH_REMOVE_TRIM, 1, 3); // all of it falls
    CHECK(sf_grid_popcount(sf_sculpt_printable(t.cpu)) < 600);
    CHECK_EQ(dispatches(&t, SF_BRUSH_REMOVE_TRIM, 1, 50), falls);
    long from_bed = dispatches(&t, SF_BRUSH_ADD_GROW, 1, 50);
    CHECK_EQ(dispatches(&t, SF_BRUSH_ADD_GROW, 1, 52), from_bed);
    long one = dispatches(&t, SF_BRUSH_SMOOTH_TRIM, 1, 20);
    CHECK_EQ(dispatches(&t, SF_BRUSH_SMOOTH_TRIM, 4, 20), one + 3);
    printf("# dispatches of a stroke of a dab: add-trim %ld, remove-trim %ld, remove-preserve %ld, "
           "add-grow %ld, smooth-trim %ld, paint %ld\n",
           first, falls, dispatches(&t, SF_BRUSH_REMOVE_PRESERVE, 1, 20), from_bed, one,
           dispatches(&t, SF_BRUSH_PAINT, 1, 20));
    CHECK_EQ(twin_differs(&t), 0);
    twin_free(&t);
}

int main(void)
{
    gl_headless *context = NULL;
    if (!gl_begin(&context)) {
        return gl_status;
    }
    shim_install();
    TEST(no_readback_between_strokes);
    TEST(as_many_dispatches_whatever_falls);
    gl_headless_destroy(context);
    return test_finish();
}

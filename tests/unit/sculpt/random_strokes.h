// SPDX-License-Identifier: MIT
// Random strokes: tips of all shapes, all brushes, dabs on, in, above and beyond a small grid.

#ifndef SF_TEST_SCULPT_RANDOM_STROKES_H
#define SF_TEST_SCULPT_RANDOM_STROKES_H

#include <sf/sf.h>

#include "test.h"

#define STROKE_DABS_MAX 6

typedef struct random_stroke {
    sf_brush brush;
    sf_tip *tip;
    sf_dab dabs[STROKE_DABS_MAX];
    size_t count;
} random_stroke;

// A tip of any shape, by formula, of a random mask or as a stamp, up to `reach` voxels.
static inline sf_tip *random_tip(uint32_t reach)
{
    sf_tip *tip = NULL;
    uint32_t pick = test_random_below(8);
    if (pick < 6) {
        double r[3];
        for (int i = 0; i < 3; i++) {
            r[i] = test_random_unit() * reach;
        }
        CHECK(sf_tip_create((sf_tip_shape)(pick % 4), r, NULL, &tip) == SF_OK);
    } else if (pick == 6) {
        sf_lattice lattice = {1 + test_random_below(reach),
                              1 + test_random_below(reach),
                              1 + test_random_below(reach),
                              1,
                              1,
                              1,
                              NULL,
                              {0, 0, 0}};
        sf_grid *mask = NULL;
        CHECK(sf_grid_create(&lattice, NULL, &mask) == SF_OK);
        for (uint32_t z = 0; z < lattice.nz; z++) {
            for (uint32_t y = 0; y < lattice.ny; y++) {
                sf_slice_get(sf_grid_slice(mask, z), 0, y);
                sf_grid_slice(mask, z).words[y * sf_grid_slice(mask, z).stride] =
                    test_random() & ((UINT64_C(1) << lattice.nx) - 1);
            }
        }
        CHECK(sf_slice_set(sf_grid_slice(mask, 0), 0, 0, 1) == SF_OK);
        sf_dab anchor = {(int32_t)test_random_below(5) - 1, (int32_t)test_random_below(5), 1};
        CHECK(sf_tip_create_mask(mask, anchor, NULL, &tip) == SF_OK);
        sf_grid_destroy(mask);
    } else {
        uint8_t heights[64];
        for (int i = 0; i < 64; i++) {
            heights[i] = (uint8_t)test_random_below(256);
        }
        heights[9] = 255;
        CHECK(sf_tip_create_stamp(heights, 8, 7, 6, 1 + test_random_below(reach), NULL, &tip) ==
              SF_OK);
    }
    return tip;
}

static inline int32_t random_near(uint32_t n)
{
    return (int32_t)test_random_below(n + 4) - 2;
}

static inline random_stroke random_stroke_new(const sf_lattice *l, uint32_t reach)
{
    static const sf_brush_kind kinds[12] = {
        SF_BRUSH_ADD_TRIM,    SF_BRUSH_ADD_TRIM,        SF_BRUSH_ADD_GROW,
        SF_BRUSH_ADD_GROW,    SF_BRUSH_ADD_GROW,        SF_BRUSH_ADD_TRIM,
        SF_BRUSH_REMOVE_TRIM, SF_BRUSH_REMOVE_PRESERVE, SF_BRUSH_REMOVE_PRESERVE,
        SF_BRUSH_SMOOTH_TRIM, SF_BRUSH_SMOOTH_TRIM,     SF_BRUSH_PAINT};
    random_stroke s = {.brush = sf_brush_default(), .tip = random_tip(reach)};
    s.brush.kind = kinds[test_random_below(12)];
    s.brush.tip = s.tip;
    s.brush.material = (uint8_t)(1 + test_random_below(4));
    s.brush.passes = 1 + test_random_below(3);
    s.brush.mirror_x = test_random_below(4) == 0;
    s.brush.mirror_y = test_random_below(4) == 0;
    s.count = 1 + test_random_below(STROKE_DABS_MAX);
    sf_dab at = {random_near(l->nx), random_near(l->ny), random_near(l->nz * 2 / 3)};
    for (size_t i = 0; i < s.count; i++) {
        s.dabs[i] = at;
        at.x += (int32_t)test_random_below(5) - 2;
        at.y += (int32_t)test_random_below(5) - 2;
        at.z += (int32_t)test_random_below(5) - 2;
    }
    return s;
}

static inline void random_stroke_free(random_stroke *s)
{
    sf_tip_destroy(s->tip);
}

#endif

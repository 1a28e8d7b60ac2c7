// SPDX-License-Identifier: MIT
// What a call says it changed is what a host draws anew, and no more than it must (the promise of
// sf_sculpt_change): the boxes hold all that a call changed, lie within what the stroke changed,
// and are empty where it changed nothing. Judged by comparing all voxels before and after.

#include <sf/sf.h>

#include "random_strokes.h"
#include "test.h"

static sf_sculpt_options small_options(void)
{
    sf_sculpt_options options = sf_sculpt_options_default();
    sf_lattice lattice = {40, 36, 30, 1, 1, 1, NULL, {0, 0, 0}};
    options.lattice = lattice;
    options.history_size = 1 << 16;
    return options;
}

// A model's three parts as bytes: is drawn, is printable, material.
#define BOX_X 40
#define BOX_Y 36
#define BOX_Z 30
#define BOX_COUNT (BOX_X * BOX_Y * BOX_Z)

typedef struct parts {
    uint8_t bytes[3][BOX_COUNT];
} parts;

static void look(const sf_sculpt *model, parts *p)
{
    for (uint32_t i = 0; i < BOX_COUNT; i++) {
        uint32_t x = i % BOX_X, y = i / BOX_X % BOX_Y, z = i / BOX_X / BOX_Y;
        p->bytes[0][i] = (uint8_t)sf_slice_get(sf_grid_slice(sf_sculpt_drawn(model), z), x, y);
        p->bytes[1][i] = (uint8_t)sf_slice_get(sf_grid_slice(sf_sculpt_printable(model), z), x, y);
    }
    memcpy(p->bytes[2], sf_sculpt_materials(model), BOX_COUNT);
}

static int is_in(sf_box b, uint32_t i)
{
    uint32_t x = i % BOX_X, y = i / BOX_X % BOX_Y, z = i / BOX_X / BOX_Y;
    return x >= b.x0 && x < b.x1 && y >= b.y0 && y < b.y1 && z >= b.z0 && z < b.z1;
}

// The box around where two models differ.
static sf_box box_of(const uint8_t *a, const uint8_t *b)
{
    sf_box box = {UINT32_MAX, UINT32_MAX, UINT32_MAX, 0, 0, 0}, none = {0, 0, 0, 0, 0, 0};
    for (uint32_t i = 0; i < BOX_COUNT; i++) {
        uint32_t x = i % BOX_X, y = i / BOX_X % BOX_Y, z = i / BOX_X / BOX_Y;
        if (a[i] != b[i]) {
            box.x0 = x < box.x0 ? x : box.x0;
            box.y0 = y < box.y0 ? y : box.y0;
            box.z0 = z < box.z0 ? z : box.z0;
            box.x1 = x >= box.x1 ? x + 1 : box.x1;
            box.y1 = y >= box.y1 ? y + 1 : box.y1;
            box.z1 = z + 1;
        }
    }
    return box.x1 > 0 ? box : none;
}

// The boxes of one call of a stroke: around all that it changed, and within the box around what the
// stroke changes now or did before the call.
static void check_boxes(const sf_sculpt_change *c, const parts *start, const parts *was,
                        const parts *is)
{
    const sf_box said[3] = {c->drawn, c->printable, c->material};
    for (int k = 0; k < 3; k++) {
        sf_box a = box_of(start->bytes[k], was->bytes[k]),
               b = box_of(start->bytes[k], is->bytes[k]);
        for (uint32_t i = 0; i < BOX_COUNT; i++) {
            CHECK(was->bytes[k][i] == is->bytes[k][i] || is_in(said[k], i));
        }
        CHECK(said[k].x1 <= (a.x1 > b.x1 ? a.x1 : b.x1));
        CHECK(said[k].y1 <= (a.y1 > b.y1 ? a.y1 : b.y1));
        CHECK(said[k].z1 <= (a.z1 > b.z1 ? a.z1 : b.z1));
        CHECK(said[k].x1 == 0 || a.x1 == 0 || b.x1 == 0 ||
              said[k].z0 >= (a.z0 < b.z0 ? a.z0 : b.z0));
    }
}

static void boxes(void)
{
    static parts start, was, is;
    sf_sculpt *model = NULL;
    sf_sculpt_options o = small_options();
    o.keep_drawn = 1;
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_OK);
    for (int n = 0; n < 300 && test_case_failures == 0; n++) {
        sf_sculpt_change change;
        random_stroke s = random_stroke_new(&o.lattice, 7);
        look(model, &start);
        was = start;
        CHECK(sf_sculpt_begin(model, &s.brush) == SF_OK);
        for (size_t i = 0; i < s.count; i++) {
            CHECK(sf_sculpt_dab(model, &s.dabs[i], 1, &change) == SF_OK);
            look(model, &is);
            check_boxes(&change, &start, &was, &is);
            was = is;
        }
        CHECK(sf_sculpt_end(model, NULL) == SF_OK);
        random_stroke_free(&s);
    }
    sf_sculpt_destroy(model);
}

// Putting the same shape in place of itself changes nothing; another, where they differ.
static void boxes_of_replace(void)
{
    static parts was, is;
    for (int keeps = 0; keeps < 2; keeps++) {
        sf_sculpt *model = NULL;
        sf_sculpt_options o = small_options();
        sf_sculpt_change c;
        sf_grid *shape = NULL;
        o.keep_drawn = keeps;
        CHECK(sf_sculpt_create(&o, NULL, &model) == SF_OK);
        CHECK(sf_grid_create(&o.lattice, NULL, &shape) == SF_OK);
        CHECK(sf_slice_set(sf_grid_slice(shape, 0), 5, 6, 1) == SF_OK);
        CHECK(sf_slice_set(sf_grid_slice(shape, 9), 30, 31, 1) == SF_OK); // hangs
        CHECK(sf_sculpt_replace(model, shape, NULL, &c) == SF_OK);
        CHECK_EQ(c.drawn.x1, keeps ? 31 : 6);
        CHECK_EQ(c.printable.x1, 6);
        CHECK_EQ(c.material.z1, keeps ? 10 : 1);
        CHECK(sf_sculpt_replace(model, shape, NULL, &c) == SF_OK);
        CHECK_EQ(c.drawn.x1 + c.printable.x1 + c.material.x1, 0);
        CHECK_EQ(sf_sculpt_history_of(model).undo_count, 1);
        look(model, &was);
        CHECK(sf_slice_set(sf_grid_slice(shape, 1), 4, 7, 1) == SF_OK);
        CHECK(sf_sculpt_replace(model, shape, NULL, &c) == SF_OK);
        look(model, &is);
        check_boxes(&c, &was, &was, &is);
        CHECK_EQ(c.added_voxels, 1);
        CHECK(sf_sculpt_undo(model, NULL) == SF_OK);
        look(model, &is);
        CHECK(memcmp(&was, &is, sizeof is) == 0);
        sf_grid_destroy(shape);
        sf_sculpt_destroy(model);
    }
}

int main(void)
{
    TEST(boxes);
    TEST(boxes_of_replace);
    return test_finish();
}

// SPDX-License-Identifier: MIT
// The promise of every brush (TRUST 33-63, 82): after a stroke, and after every part of one, the
// model is what the definition says, bit for bit, materials too; a stroke is one union, however it
// is cut. Random strokes on small grids against the oracle of bytes, under rules that are elements,
// with beds above the lowest layer and with ghosts kept.

#include "oracle.h"
#include "random_strokes.h"

static sf_sculpt_options small_model(uint32_t nx, uint32_t ny, uint32_t nz)
{
    sf_sculpt_options options = sf_sculpt_options_default();
    sf_lattice lattice = {nx, ny, nz, 1, 1, 1, NULL, {0, 0, 0}};
    options.lattice = lattice;
    options.history_size = 1 << 16;
    return options;
}

// A stroke in up to three calls; the model must be the same as in one.
static void put_in_parts(sf_sculpt *model, const random_stroke *s)
{
    size_t first = test_random_below((uint32_t)s->count + 1);
    CHECK(sf_sculpt_begin(model, &s->brush) == SF_OK);
    CHECK(sf_sculpt_dab(model, s->dabs, first, NULL) == SF_OK);
    for (size_t i = s->count; i-- > first;) { // the rest one by one, and backwards
        CHECK(sf_sculpt_dab(model, &s->dabs[i], 1, NULL) == SF_OK);
    }
    CHECK(sf_sculpt_end(model, NULL) == SF_OK);
}

// What a run of strokes did, by kind.
typedef struct tally {
    long strokes[SF_BRUSH_KIND_COUNT], changed[SF_BRUSH_KIND_COUNT], special[SF_BRUSH_KIND_COUNT];
} tally;

static void note(tally *t, sf_brush_kind kind, const sf_sculpt_change *c)
{
    t->strokes[kind]++;
    t->changed[kind] += c->added_voxels + c->removed_voxels + c->lost_voxels > 0;
    t->special[kind] += c->kept_back_voxels + c->lost_voxels + c->path_voxels > 0;
}

static void run(const sf_sculpt_options *options, int strokes, tally *t)
{
    sf_sculpt *whole = NULL, *parts = NULL;
    oracle o = oracle_new(options);
    CHECK(sf_sculpt_create(options, NULL, &whole) == SF_OK);
    CHECK(sf_sculpt_create(options, NULL, &parts) == SF_OK);
    for (int i = 0; i < strokes && test_case_failures == 0; i++) {
        random_stroke s = random_stroke_new(&options->lattice, 8);
        sf_sculpt_change change;
        CHECK(sf_sculpt_stroke(whole, &s.brush, s.dabs, s.count, &change) == SF_OK);
        put_in_parts(parts, &s);
        oracle_stroke(&o, &s.brush, s.dabs, s.count);
        CHECK_EQ(oracle_differences(&o, whole), 0);
        CHECK_EQ(oracle_differences(&o, parts), 0);
        note(t, s.brush.kind, &change);
        if (test_case_failures > 0) {
            printf("# stroke %d, %s\n", i, sf_brush_kind_name(s.brush.kind));
        }
        random_stroke_free(&s);
    }
    oracle_free(&o);
    sf_sculpt_destroy(whole);
    sf_sculpt_destroy(parts);
}

static void box3(void)
{
    tally t = {{0}, {0}, {0}};
    sf_sculpt_options a = small_model(40, 30, 36), b = small_model(70, 13, 20);
    run(&a, 700, &t);
    run(&b, 500, &t);
    for (int k = 0; k < SF_BRUSH_KIND_COUNT; k++) {
        printf("# %s: %ld strokes, %ld changed the shape, %ld held back, lost or led\n",
               sf_brush_kind_name((sf_brush_kind)k), t.strokes[k], t.changed[k], t.special[k]);
        CHECK(t.strokes[k] > 40);
        CHECK(k == SF_BRUSH_PAINT || t.changed[k] * 3 >= t.strokes[k]);
    }
}

static void ghosts(void)
{
    tally t = {{0}, {0}, {0}};
    sf_sculpt_options options = small_model(40, 30, 30);
    options.keep_drawn = 1;
    run(&options, 500, &t);
}

static void bed_above(void)
{
    tally t = {{0}, {0}, {0}};
    sf_sculpt_options options = small_model(33, 33, 30);
    options.bed_layer = 5;
    run(&options, 300, &t);
}

static void other_rules(void)
{
    tally t = {{0}, {0}, {0}};
    sf_sculpt_options options = small_model(40, 30, 26);
    CHECK(sf_rule_make(SF_RULE_OCTAGON, 0.7, &options.lattice, NULL, &options.rule, NULL) == SF_OK);
    run(&options, 250, &t);
    CHECK(sf_rule_make(SF_RULE_DISK, 1.2, &options.lattice, NULL, &options.rule, NULL) == SF_OK);
    run(&options, 250, &t);
}

// Most of what a brush covers lies beyond the border.
static void thin(void)
{
    tally t = {{0}, {0}, {0}};
    sf_sculpt_options flat = small_model(128, 1, 40), tall = small_model(1, 65, 40);
    flat.keep_drawn = 1;
    run(&flat, 1200, &t);
    run(&tall, 800, &t);
}

int main(void)
{
    TEST(box3);
    TEST(ghosts);
    TEST(bed_above);
    TEST(other_rules);
    TEST(thin);
    return test_finish();
}

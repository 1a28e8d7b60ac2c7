// SPDX-License-Identifier: MIT
// After every stroke of a long session (TRUST 33-63): the printable shape is support-free, judged
// by the checker; it is the trim of what is drawn, made anew; undo gives the exact bits back and
// redo the next ones. 14,000 strokes at 64^3, in sessions that end when the grid is full, and
// counts that show that the strokes were not idle. A longer run at 512^3:
//
//     build/tests/unit/sculpt/unit-sculpt-many 512 200

#include <sf/sf.h>

#include "random_strokes.h"
#include "test.h"

static uint32_t side = 64;
static int stroke_count = 14000;

// What strokes of one kind did.
typedef struct tally {
    long strokes, changed, special;
} tally;

static size_t voxels(void)
{
    return (size_t)side * side * side;
}

static void check_model(const sf_sculpt *model)
{
    sf_check_options check = sf_check_options_default();
    sf_check_report report;
    sf_grid *fresh = NULL;
    check.bed_layer = 0;
    CHECK(sf_grid_check(sf_sculpt_printable(model), &check, NULL, NULL, &report, NULL) == SF_OK);
    CHECK_EQ(report.unsupported_voxels, 0);
    CHECK(sf_grid_clone(sf_sculpt_drawn(model), NULL, &fresh) == SF_OK);
    CHECK(sf_grid_trim(fresh, &check.rule, 0, NULL, NULL) == SF_OK);
    CHECK(sf_grid_equal(fresh, sf_sculpt_printable(model)));
    sf_grid_destroy(fresh);
}

// What a brush of each kind is there for: it trims, keeps, leads a path, lets something fall.
static int is_special(sf_brush_kind kind, const sf_sculpt_change *c)
{
    switch (kind) {
    case SF_BRUSH_ADD_TRIM:
    case SF_BRUSH_REMOVE_PRESERVE:
        return c->kept_back_voxels > 0;
    case SF_BRUSH_ADD_GROW:
        return c->path_voxels > 0;
    case SF_BRUSH_REMOVE_TRIM:
    case SF_BRUSH_SMOOTH_TRIM:
        return c->lost_voxels > 0;
    default:
        return 0;
    }
}

// Its own promise: what lies outside the tips.
static void check_change(sf_brush_kind kind, const sf_sculpt_change *c, const sf_grid *before,
                         const sf_grid *after)
{
    uint64_t more = sf_grid_popcount(after) - sf_grid_popcount(before);
    CHECK_EQ(more, c->added_voxels - c->removed_voxels - c->lost_voxels);
    if (kind == SF_BRUSH_ADD_TRIM || kind == SF_BRUSH_ADD_GROW) {
        CHECK_EQ(c->removed_voxels + c->lost_voxels, 0);
    }
    if (kind == SF_BRUSH_REMOVE_PRESERVE) {
        CHECK_EQ(c->added_voxels + c->lost_voxels, 0);
    }
    if (kind == SF_BRUSH_ADD_GROW) {
        CHECK_EQ(c->kept_back_voxels, 0); // the bed is the lowest layer: all is carried
    }
}

static void one(sf_sculpt *model, tally *t)
{
    sf_lattice l = sf_sculpt_options_of(model).lattice;
    sf_sculpt_change change;
    sf_grid *before = NULL, *after = NULL;
    uint8_t *were = malloc(voxels()), *are = malloc(voxels());
    size_t steps = sf_sculpt_history_of(model).undo_count;
    random_stroke s = random_stroke_new(&l, side / 6);
    CHECK(sf_grid_clone(sf_sculpt_printable(model), NULL, &before) == SF_OK);
    memcpy(were, sf_sculpt_materials(model), voxels());
    CHECK(sf_sculpt_stroke(model, &s.brush, s.dabs, s.count, &change) == SF_OK);
    check_model(model);
    CHECK(sf_grid_clone(sf_sculpt_printable(model), NULL, &after) == SF_OK);
    memcpy(are, sf_sculpt_materials(model), voxels());
    check_change(s.brush.kind, &change, before, after);
    if (sf_sculpt_history_of(model).undo_count > steps) {
        CHECK(sf_sculpt_undo(model, NULL) == SF_OK);
        CHECK(sf_grid_equal(before, sf_sculpt_printable(model)));
        CHECK(memcmp(were, sf_sculpt_materials(model), voxels()) == 0);
        CHECK(sf_sculpt_redo(model, NULL) == SF_OK);
    }
    CHECK(sf_grid_equal(after, sf_sculpt_printable(model)));
    CHECK(sf_grid_equal(after, sf_sculpt_drawn(model)));
    CHECK(memcmp(are, sf_sculpt_materials(model), voxels()) == 0);
    t[s.brush.kind].strokes++;
    t[s.brush.kind].changed += change.added_voxels + change.removed_voxels + change.lost_voxels > 0;
    t[s.brush.kind].special += is_special(s.brush.kind, &change);
    random_stroke_free(&s);
    sf_grid_destroy(before);
    sf_grid_destroy(after);
    free(were);
    free(are);
}

static void sessions(void)
{
    tally t[SF_BRUSH_KIND_COUNT] = {{0, 0, 0}};
    sf_sculpt *model = NULL;
    sf_sculpt_options options = sf_sculpt_options_default();
    sf_lattice lattice = {side, side, side, 0.25, 0.25, 0.25, NULL, {0, 0, 0}};
    options.lattice = lattice;
    options.history_size = (size_t)1 << 22;
    CHECK(sf_sculpt_create(&options, NULL, &model) == SF_OK);
    for (int i = 0; i < stroke_count && test_case_failures == 0; i++) {
        if (sf_grid_popcount(sf_sculpt_printable(model)) > voxels() / 3) {
            CHECK(sf_sculpt_replace(model, NULL, NULL, NULL) == SF_OK);
        }
        one(model, t);
    }
    sf_sculpt_destroy(model);
    long changed = 0, special = 0;
    for (int k = 0; k < SF_BRUSH_KIND_COUNT; k++) {
        printf("# %s: %ld strokes, %ld changed voxels, %ld trimmed, kept, led or let fall\n",
               sf_brush_kind_name((sf_brush_kind)k), t[k].strokes, t[k].changed, t[k].special);
        changed += t[k].changed;
        special += t[k].special;
        CHECK(stroke_count < 10000 || k == SF_BRUSH_PAINT || t[k].special >= 500);
    }
    CHECK(changed * 10 >= (long)stroke_count * 3);
    CHECK(special > 0);
}

int main(int argc, char **argv)
{
    side = argc > 1 ? (uint32_t)atoi(argv[1]) : side;
    stroke_count = argc > 2 ? atoi(argv[2]) : stroke_count;
    TEST(sessions);
    return test_finish();
}

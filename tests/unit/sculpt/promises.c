// SPDX-License-Identifier: MIT
// What a model promises beside its shapes: a refused call changes nothing; a call that wants for
// memory gives up the stroke and leaves the model as it was before it; after a model is made
// nothing is allocated; a stroke that is abandoned was never there; what a call says it changed, it
// did, and nothing else.

#include <sf/sf.h>

#include "failing_allocator.h"
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

static sf_tip *ball(double r)
{
    sf_tip *tip = NULL;
    const double radius[3] = {r, r, r};
    CHECK(sf_tip_create(SF_TIP_SPHERE, radius, NULL, &tip) == SF_OK);
    return tip;
}

// ---------------------------------------------------------------------------------------------
// Refusals
// ---------------------------------------------------------------------------------------------

static void options_refused(void)
{
    sf_sculpt *model = (sf_sculpt *)1;
    sf_sculpt_options o = small_options();
    CHECK(sf_sculpt_create(NULL, NULL, &model) == SF_ERR_ARGUMENT);
    CHECK(sf_sculpt_create(&o, NULL, NULL) == SF_ERR_ARGUMENT);
    o.struct_size--;
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_ERR_ARGUMENT);
    o = small_options();
    o.bed_layer = 30;
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_ERR_ARGUMENT);
    o.bed_layer = SF_BED_AUTO;
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_ERR_ARGUMENT);
    o = small_options();
    o.lattice.nx = 0;
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_ERR_ARGUMENT);
    o.lattice.nx = SF_EXTENT_MAX;
    o.lattice.ny = SF_EXTENT_MAX;
    o.lattice.nz = SF_LAYER_MAX;
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_ERR_OVERFLOW);
    o = small_options();
    o.history_size = SIZE_MAX;
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_ERR_OVERFLOW);
    CHECK(model == (sf_sculpt *)1);
    sf_sculpt_destroy(NULL);
    CHECK(sf_sculpt_drawn(NULL) == NULL && sf_sculpt_printable(NULL) == NULL);
    CHECK(sf_sculpt_materials(NULL) == NULL);
}

static void brushes_refused(sf_sculpt *model, const sf_tip *tip)
{
    sf_brush b = sf_brush_default();
    CHECK(sf_sculpt_begin(model, NULL) == SF_ERR_ARGUMENT);
    CHECK(sf_sculpt_begin(model, &b) == SF_ERR_ARGUMENT); // no tip
    b.tip = tip;
    CHECK(sf_sculpt_begin(NULL, &b) == SF_ERR_ARGUMENT);
    for (int i = 0; i < 6; i++) {
        sf_brush bad = b;
        bad.struct_size -= i == 0;
        bad.material = i == 1 ? 0 : 1;
        bad.passes = i == 2 ? 0 : i == 3 ? SF_BRUSH_PASSES_MAX + 1 : 1;
        bad.kind = i == 4 ? SF_BRUSH_KIND_COUNT : i == 5 ? (sf_brush_kind)-1 : SF_BRUSH_ADD_TRIM;
        CHECK(sf_sculpt_begin(model, &bad) == SF_ERR_ARGUMENT);
    }
}

static void calls_refused(void)
{
    sf_sculpt *model = NULL;
    sf_sculpt_options o = small_options();
    sf_tip *tip = ball(4);
    sf_brush b = sf_brush_default();
    sf_dab good = {10, 10, 0}, far = {1 << 30, 0, 0}, out = {(1 << 30) + 1, 0, 0};
    sf_sculpt_change change;
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_OK);
    brushes_refused(model, tip);
    b.tip = tip;
    CHECK(sf_sculpt_dab(model, &good, 1, NULL) == SF_ERR_ARGUMENT); // no stroke
    CHECK(sf_sculpt_end(model, NULL) == SF_ERR_ARGUMENT);
    CHECK(sf_sculpt_begin(model, &b) == SF_OK);
    CHECK(sf_sculpt_begin(model, &b) == SF_ERR_ARGUMENT);
    CHECK(sf_sculpt_undo(model, NULL) == SF_ERR_ARGUMENT);
    CHECK(sf_sculpt_redo(model, NULL) == SF_ERR_ARGUMENT);
    CHECK(sf_sculpt_replace(model, NULL, NULL, NULL) == SF_ERR_ARGUMENT);
    CHECK(sf_sculpt_drop_ghosts(model, NULL) == SF_ERR_ARGUMENT);
    CHECK(sf_sculpt_dab(model, NULL, 1, NULL) == SF_ERR_ARGUMENT);
    CHECK(sf_sculpt_dab(model, &out, 1, NULL) == SF_ERR_ARGUMENT); // and the stroke goes on
    CHECK(sf_sculpt_dab(model, &far, 1, &change) == SF_OK);
    CHECK_EQ(change.added_voxels + change.kept_back_voxels, 0);
    CHECK(sf_sculpt_dab(model, NULL, 0, NULL) == SF_OK);
    CHECK(sf_sculpt_dab(model, &good, 1, NULL) == SF_OK);
    CHECK(sf_sculpt_end(model, NULL) == SF_OK);
    CHECK(sf_grid_popcount(sf_sculpt_printable(model)) > 0);
    CHECK(sf_sculpt_stroke(model, &b, &out, 1, NULL) == SF_ERR_ARGUMENT);
    CHECK(sf_sculpt_begin(model, &b) == SF_OK); // a refused stroke is not under way
    CHECK(sf_sculpt_abandon(model, NULL) == SF_OK);
    CHECK(sf_sculpt_abandon(model, NULL) == SF_OK);
    CHECK(sf_sculpt_abandon(NULL, NULL) == SF_ERR_ARGUMENT);
    CHECK(sf_sculpt_replace(model, sf_sculpt_drawn(model), NULL, NULL) == SF_ERR_ARGUMENT);
    CHECK(sf_sculpt_replace(NULL, NULL, NULL, NULL) == SF_ERR_ARGUMENT);
    CHECK(sf_sculpt_undo(NULL, NULL) == SF_ERR_ARGUMENT);
    sf_sculpt_destroy(model);
    sf_tip_destroy(tip);
}

static void names(void)
{
    CHECK_STR(sf_brush_kind_name(SF_BRUSH_ADD_TRIM), "add-trim");
    CHECK_STR(sf_brush_kind_name(SF_BRUSH_REMOVE_PRESERVE), "remove-preserve");
    CHECK_STR(sf_brush_kind_name(SF_BRUSH_ADD_GROW), "add-grow");
    CHECK_STR(sf_brush_kind_name(SF_BRUSH_REMOVE_TRIM), "remove-trim");
    CHECK_STR(sf_brush_kind_name(SF_BRUSH_SMOOTH_TRIM), "smooth-trim");
    CHECK_STR(sf_brush_kind_name(SF_BRUSH_PAINT), "paint");
    CHECK(sf_brush_kind_name(SF_BRUSH_KIND_COUNT) == NULL);
}

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

static void strokes(sf_sculpt *model, int count)
{
    sf_lattice l = sf_sculpt_options_of(model).lattice;
    for (int i = 0; i < count; i++) {
        random_stroke s = random_stroke_new(&l, 7);
        CHECK(sf_sculpt_stroke(model, &s.brush, s.dabs, s.count, NULL) == SF_OK);
        if (i % 7 == 0) {
            (void)!sf_sculpt_undo(model, NULL);
        }
        random_stroke_free(&s);
    }
    CHECK(sf_sculpt_replace(model, NULL, NULL, NULL) == SF_OK);
}

// One request, when a model is made; none after it, whatever the rule.
static void one_request(void)
{
    for (int rule = 0; rule < 5; rule++) {
        failing_allocator f;
        sf_sculpt *model = NULL;
        sf_sculpt_options o = small_options();
        uint64_t table[64];
        if (rule == 1 || rule == 2) {
            CHECK(sf_rule_make(rule == 1 ? SF_RULE_OCTAGON : SF_RULE_DISK, 0.8, &o.lattice, table,
                               &o.rule, NULL) == SF_OK);
        } else if (rule == 3) {
            CHECK(sf_rule_make(SF_RULE_SLACK, 0.8, &o.lattice, table, &o.rule, NULL) == SF_OK);
        } else if (rule == 4) {
            CHECK(sf_rule_set_bridges(&o.rule, 6, 1, &o.lattice, NULL) == SF_OK);
        }
        failing_begin(&f, 0);
        CHECK(sf_sculpt_create(&o, &f.allocator, &model) == SF_ERR_MEMORY);
        failing_begin(&f, 1);
        CHECK(sf_sculpt_create(&o, &f.allocator, &model) == SF_OK);
        strokes(model, 60);
        sf_sculpt_destroy(model);
        CHECK_EQ(f.requests, 1);
        CHECK(f.live == 0 && f.faults == 0);
    }
}

// ---------------------------------------------------------------------------------------------
// Rules beyond elements
// ---------------------------------------------------------------------------------------------

// T = trim(D) after every stroke, and add-grow carries all of its tips.
static void session_under(const sf_sculpt_options *options)
{
    sf_sculpt *model = NULL;
    CHECK(sf_sculpt_create(options, NULL, &model) == SF_OK);
    for (int i = 0; i < 150 && test_case_failures == 0; i++) {
        sf_sculpt_change change;
        sf_grid *fresh = NULL;
        random_stroke s = random_stroke_new(&options->lattice, 7);
        CHECK(sf_sculpt_stroke(model, &s.brush, s.dabs, s.count, &change) == SF_OK);
        CHECK(sf_grid_clone(sf_sculpt_drawn(model), NULL, &fresh) == SF_OK);
        CHECK(sf_grid_trim(fresh, &options->rule, 0, NULL, NULL) == SF_OK);
        CHECK(sf_grid_equal(fresh, sf_sculpt_printable(model)));
        CHECK(s.brush.kind != SF_BRUSH_ADD_GROW || change.kept_back_voxels == 0);
        CHECK(s.brush.kind != SF_BRUSH_REMOVE_PRESERVE ||
              change.lost_voxels + change.added_voxels == 0);
        sf_grid_destroy(fresh);
        random_stroke_free(&s);
    }
    sf_sculpt_destroy(model);
}

static void slack(void)
{
    sf_sculpt_options o = small_options();
    CHECK(sf_rule_make(SF_RULE_SLACK, 0.6, &o.lattice, NULL, &o.rule, NULL) == SF_OK);
    session_under(&o);
    o.keep_drawn = 1;
    session_under(&o);
}

// Rows that are far shorter than what they are padded to, and few layers: what preserve works with
// is then large beside the model.
static void slack_in_narrow_spaces(void)
{
    static const uint32_t counts[3][3] = {{3, 100, 31}, {2, 129, 7}, {1, 100, 3}};
    for (int i = 0; i < 3; i++) {
        sf_sculpt_options o = small_options();
        o.lattice.nx = counts[i][0];
        o.lattice.ny = counts[i][1];
        o.lattice.nz = counts[i][2];
        CHECK(sf_rule_make(SF_RULE_SLACK, 0.6, &o.lattice, NULL, &o.rule, NULL) == SF_OK);
        session_under(&o);
    }
}

static void bridges(void)
{
    sf_sculpt_options o = small_options();
    CHECK(sf_rule_set_bridges(&o.rule, 6, 1, &o.lattice, NULL) == SF_OK);
    session_under(&o);
}

// ---------------------------------------------------------------------------------------------
// Abandon, replace, ghosts
// ---------------------------------------------------------------------------------------------

static void abandon(void)
{
    sf_sculpt *model = NULL;
    sf_sculpt_options o = small_options();
    size_t voxels = (size_t)40 * 36 * 30;
    uint8_t *were = malloc(voxels);
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_OK);
    for (int i = 0; i < 120; i++) {
        sf_grid *drawn = NULL, *printable = NULL;
        random_stroke s = random_stroke_new(&o.lattice, 7);
        CHECK(sf_grid_clone(sf_sculpt_drawn(model), NULL, &drawn) == SF_OK);
        CHECK(sf_grid_clone(sf_sculpt_printable(model), NULL, &printable) == SF_OK);
        memcpy(were, sf_sculpt_materials(model), voxels);
        CHECK(sf_sculpt_begin(model, &s.brush) == SF_OK);
        CHECK(sf_sculpt_dab(model, s.dabs, s.count, NULL) == SF_OK);
        CHECK(sf_sculpt_abandon(model, NULL) == SF_OK);
        CHECK(sf_grid_equal(drawn, sf_sculpt_drawn(model)));
        CHECK(sf_grid_equal(printable, sf_sculpt_printable(model)));
        CHECK(memcmp(were, sf_sculpt_materials(model), voxels) == 0);
        CHECK(sf_sculpt_stroke(model, &s.brush, s.dabs, s.count, NULL) == SF_OK);
        sf_grid_destroy(drawn);
        sf_grid_destroy(printable);
        random_stroke_free(&s);
    }
    free(were);
    sf_sculpt_destroy(model);
}

// A shelf in the air: a ghost, which comes back when a leg is put below it, and goes when asked.
static void ghosts(void)
{
    sf_sculpt *model = NULL;
    sf_sculpt_options o = small_options();
    sf_brush b = sf_brush_default();
    sf_tip *shelf = NULL, *leg = NULL;
    const double flat[3] = {8, 8, 0}, tall[3] = {8, 8, 5};
    sf_dab up = {20, 18, 10}, down = {20, 18, 4};
    sf_sculpt_change change;
    o.keep_drawn = 1;
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_OK);
    CHECK(sf_tip_create(SF_TIP_BOX, flat, NULL, &shelf) == SF_OK);
    CHECK(sf_tip_create(SF_TIP_BOX, tall, NULL, &leg) == SF_OK);
    b.tip = shelf;
    b.material = 3;
    CHECK(sf_sculpt_stroke(model, &b, &up, 1, &change) == SF_OK);
    CHECK_EQ(change.added_voxels, 0);
    CHECK_EQ(change.kept_back_voxels, 17 * 17);
    CHECK_EQ(sf_grid_popcount(sf_sculpt_drawn(model)), 17 * 17);
    b.tip = leg;
    b.material = 2;
    CHECK(sf_sculpt_stroke(model, &b, &down, 1, &change) == SF_OK);
    CHECK_EQ(change.added_voxels, 17 * 17 * 11); // ten layers of leg, and the shelf
    CHECK_EQ(sf_sculpt_materials(model)[(10 * 36 + 18) * 40 + 20], 3);
    CHECK(sf_sculpt_undo(model, NULL) == SF_OK);
    CHECK(sf_sculpt_drop_ghosts(model, &change) == SF_OK);
    CHECK_EQ(sf_grid_popcount(sf_sculpt_drawn(model)), 0);
    CHECK_EQ(change.drawn.x1 - change.drawn.x0, 17);
    CHECK(sf_sculpt_undo(model, NULL) == SF_OK);
    CHECK_EQ(sf_grid_popcount(sf_sculpt_drawn(model)), 17 * 17);
    sf_tip_destroy(shelf);
    sf_tip_destroy(leg);
    sf_sculpt_destroy(model);
}

static void replace(void)
{
    sf_sculpt *model = NULL;
    sf_sculpt_options o = small_options();
    size_t voxels = (size_t)40 * 36 * 30;
    uint8_t *materials = calloc(voxels, 1);
    sf_grid *shape = NULL, *other = NULL;
    sf_lattice wrong = o.lattice;
    sf_sculpt_change change;
    wrong.nz = 29;
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_OK);
    CHECK(sf_grid_create(&o.lattice, NULL, &shape) == SF_OK);
    CHECK(sf_grid_create(&wrong, NULL, &other) == SF_OK);
    CHECK(sf_sculpt_replace(model, other, NULL, NULL) == SF_ERR_SHAPE);
    CHECK(sf_slice_set(sf_grid_slice(shape, 0), 5, 5, 1) == SF_OK);
    CHECK(sf_slice_set(sf_grid_slice(shape, 1), 6, 5, 1) == SF_OK);
    CHECK(sf_slice_set(sf_grid_slice(shape, 1), 9, 5, 1) == SF_OK); // hangs
    materials[5 * 40 + 5] = 7;
    materials[5 * 40 + 6] = 9; // nothing is there
    CHECK(sf_sculpt_replace(model, shape, materials, &change) == SF_OK);
    CHECK_EQ(change.added_voxels, 2);
    CHECK_EQ(sf_grid_popcount(sf_sculpt_drawn(model)), 2);
    CHECK_EQ(sf_sculpt_materials(model)[5 * 40 + 5], 7);
    CHECK_EQ(sf_sculpt_materials(model)[5 * 40 + 6], 0);
    CHECK_EQ(sf_sculpt_materials(model)[(36 + 5) * 40 + 6], 1);
    CHECK(sf_sculpt_undo(model, &change) == SF_OK);
    CHECK_EQ(change.removed_voxels, 2);
    CHECK_EQ(sf_grid_popcount(sf_sculpt_drawn(model)), 0);
    sf_grid_destroy(shape);
    sf_grid_destroy(other);
    free(materials);
    sf_sculpt_destroy(model);
}

// ---------------------------------------------------------------------------------------------
// Lines
// ---------------------------------------------------------------------------------------------

static void lines(void)
{
    sf_dab from = {3, -2, 5}, to = {-4, 1, 5}, dabs[16];
    size_t count = 0;
    CHECK(sf_dab_line(from, to, dabs, 7, &count) == SF_ERR_CAPACITY);
    CHECK_EQ(count, 8);
    CHECK(sf_dab_line(from, to, dabs, 16, &count) == SF_OK);
    for (size_t i = 0; i < count; i++) {
        CHECK_EQ(dabs[i].x, 3 - (int)i);
        CHECK(fabs(dabs[i].y - (-2 + 3.0 * (double)i / 7)) <= 0.5);
        CHECK_EQ(dabs[i].z, 5);
    }
    CHECK(sf_dab_line(from, from, dabs, 1, &count) == SF_OK && count == 1);
    CHECK(sf_dab_line(from, to, NULL, 1, &count) == SF_ERR_ARGUMENT);
    from.x = INT32_MIN;
    CHECK(sf_dab_line(from, to, dabs, 16, &count) == SF_ERR_ARGUMENT);
}

int main(void)
{
    TEST(options_refused);
    TEST(calls_refused);
    TEST(names);
    TEST(one_request);
    TEST(slack);
    TEST(slack_in_narrow_spaces);
    TEST(bridges);
    TEST(abandon);
    TEST(ghosts);
    TEST(replace);
    TEST(lines);
    return test_finish();
}

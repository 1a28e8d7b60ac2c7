// SPDX-License-Identifier: MIT
// What random strokes hardly ever meet, made on purpose, so that each line of the shaders is held
// by something: rings of a history that wrap, boxes of changes that are no larger than need be,
// votes of many materials, tips that leave their own voxel out and lean out of the grid, beds that
// change while nothing else does, and a fall of everything up to the top.

#include "twin.h"

#include <epoxy/gl.h>

enum { RECORD = 11, STEPS = 4096 };

static sf_brush brush_of(sf_brush_kind kind, const sf_tip *tip, uint8_t material)
{
    sf_brush b = sf_brush_default();
    b.kind = kind;
    b.tip = tip;
    b.material = material;
    return b;
}

static sf_tip *box_tip(double x, double y, double z)
{
    const double radius[3] = {x, y, z};
    sf_tip *tip = NULL;
    CHECK(sf_tip_create(SF_TIP_BOX, radius, NULL, &tip) == SF_OK);
    return tip;
}

static void stroke_both(twin *t, const sf_brush *b, sf_dab at)
{
    CHECK(sf_sculpt_stroke(t->cpu, b, &at, 1, NULL) == SF_OK);
    CHECK(gpu_sculpt_stroke(t->gpu, b, &at, 1) == SF_OK);
}

static sf_dab dab(int32_t x, int32_t y, int32_t z)
{
    const sf_dab d = {x, y, z};
    return d;
}

// ---------------------------------------------------------------------------------------------
// The history
// ---------------------------------------------------------------------------------------------

// A ring as step.comp describes it, in words: where each step that is kept begins, and how long.
typedef struct ring {
    uint32_t start[8192], words[8192];
    uint32_t first, end, forgotten, capacity;
} ring;

static void ring_add(ring *r, uint32_t words)
{
    uint32_t head = 0;
    if (r->first < r->end) {
        head = r->start[r->end - 1] + r->words[r->end - 1];
    }
    if (words > r->capacity) {
        r->forgotten += r->end - r->first + 1;
        r->first = r->end;
        return;
    }
    if (head + words > r->capacity) { // what lies up to the ring's end goes, and it begins anew
        while (r->first < r->end && r->start[r->first] >= head) {
            r->first++;
            r->forgotten++;
        }
        head = 0;
    }
    while (r->first < r->end && r->start[r->first] >= head && r->start[r->first] < head + words) {
        r->first++;
        r->forgotten++;
    }
    if (r->end - r->first >= STEPS) {
        r->first++;
        r->forgotten++;
    }
    r->start[r->end] = head;
    r->words[r->end++] = words;
}

static void check_ring(const twin *t, const ring *r)
{
    gpu_report report;
    CHECK(gpu_sculpt_report(t->gpu, &report) == SF_OK);
    CHECK_EQ(report.undo_count, r->end - r->first);
    CHECK_EQ(report.forgotten_count, r->forgotten);
}

// Steps of one word to some, on a bed; each changes as many words as its tip is rows deep.
static void a_ring_forgets_no_more_than_it_must(void)
{
    static ring r;
    sf_sculpt_options o = twin_options(32, 64, 4);
    memset(&r, 0, sizeof r);
    r.capacity = 9 * RECORD + 5;
    o.history_size = 4 * (size_t)r.capacity;
    twin t = twin_new(&o);
    sf_tip *tips[4];
    for (int i = 0; i < 4; i++) {
        tips[i] = box_tip(0, i, 0);
    }
    for (int i = 0; i < 300; i++) {
        int deep = (i * 7 + i / 5) % 4;
        sf_brush b = brush_of(SF_BRUSH_PAINT, tips[deep], (uint8_t)(i % 250 + 2));
        if (i < 20) { // something to paint
            b.kind = SF_BRUSH_ADD_TRIM;
        }
        sf_dab at = dab(i < 20 ? i : 5, i < 20 ? 30 : 30, 0);
        sf_sculpt_change c;
        CHECK(sf_sculpt_stroke(t.cpu, &b, &at, 1, &c) == SF_OK);
        CHECK(gpu_sculpt_stroke(t.gpu, &b, &at, 1) == SF_OK);
        uint32_t rows = 0;
        sf_box both = i < 20 ? c.printable : c.material;
        if (both.x1 > both.x0) {
            rows = both.y1 - both.y0;
        }
        if (rows > 0) {
            ring_add(&r, rows * RECORD);
        }
        check_ring(&t, &r);
    }
    CHECK(r.forgotten > 100);
    for (int i = 0; i < 4; i++) {
        sf_tip_destroy(tips[i]);
    }
    twin_free(&t);
}

static void a_step_that_is_too_large_empties_it(void)
{
    static ring r;
    sf_sculpt_options o = twin_options(32, 64, 4);
    memset(&r, 0, sizeof r);
    r.capacity = 4 * RECORD;
    o.history_size = 4 * (size_t)r.capacity;
    twin t = twin_new(&o);
    sf_tip *small = box_tip(0, 0, 0), *large = box_tip(0, 20, 0);
    for (int i = 0; i < 7; i++) { // after the large one four more, for which there is just room
        sf_brush b = brush_of(SF_BRUSH_ADD_TRIM, i == 2 ? large : small, 1);
        stroke_both(&t, &b, dab(i, 30, 0));
        ring_add(&r, (i == 2 ? 41u : 1u) * RECORD);
        check_ring(&t, &r);
    }
    for (int i = 0; i < 4; i++) { // those after it can be undone, and no more
        CHECK(gpu_sculpt_undo(t.gpu) == SF_OK);
    }
    CHECK(gpu_sculpt_fetch(t.gpu, t.drawn, NULL, NULL) == SF_OK);
    CHECK_EQ(sf_grid_popcount(t.drawn), 2 + 41);
    CHECK(gpu_sculpt_undo(t.gpu) == SF_OK);
    CHECK(gpu_sculpt_fetch(t.gpu, t.drawn, NULL, NULL) == SF_OK);
    CHECK_EQ(sf_grid_popcount(t.drawn), 2 + 41);
    sf_tip_destroy(small);
    sf_tip_destroy(large);
    twin_free(&t);
}

static void no_more_steps_than_places(void)
{
    sf_sculpt_options o = twin_options(32, 4, 4);
    twin t = twin_new(&o);
    sf_tip *tip = box_tip(0, 0, 0);
    for (uint32_t i = 0; i < STEPS + 9; i++) {
        sf_brush b =
            brush_of(i == 0 ? SF_BRUSH_ADD_TRIM : SF_BRUSH_PAINT, tip, (uint8_t)(i % 2 + 1));
        sf_dab at = dab(3, 2, 0);
        CHECK(gpu_sculpt_stroke(t.gpu, &b, &at, 1) == SF_OK);
    }
    gpu_report report;
    CHECK(gpu_sculpt_report(t.gpu, &report) == SF_OK);
    CHECK_EQ(report.undo_count, STEPS);
    CHECK_EQ(report.forgotten_count, 9);
    sf_tip_destroy(tip);
    twin_free(&t);
}

// ---------------------------------------------------------------------------------------------
// Boxes
// ---------------------------------------------------------------------------------------------

// The box of the last change: whole words wide, and no rows or layers beside these.
static void check_box(const twin *t, uint32_t y0, uint32_t z0, uint32_t y1, uint32_t z1)
{
    uint32_t box[6];
    glGetNamedBufferSubData(gpu_sculpt_view(t->gpu).ledger, 12 * 4, sizeof box, box);
    CHECK_EQ(box[1], y0);
    CHECK_EQ(box[2], z0);
    CHECK_EQ(box[4], y1);
    CHECK_EQ(box[5], z1);
}

static void a_box_is_that_of_one_change(void)
{
    sf_sculpt_options o = twin_options(64, 60, 20);
    twin t = twin_new(&o);
    sf_tip *tip = box_tip(1, 1, 1);
    sf_brush b = brush_of(SF_BRUSH_ADD_TRIM, tip, 1);
    sf_dab far = dab(50, 50, 0), near = dab(5, 5, 0);
    stroke_both(&t, &b, far);
    check_box(&t, 49, 0, 52, 2);
    stroke_both(&t, &b, near);
    check_box(&t, 4, 0, 7, 2);
    CHECK(gpu_sculpt_undo(t.gpu) == SF_OK);
    check_box(&t, 4, 0, 7, 2);
    CHECK(gpu_sculpt_undo(t.gpu) == SF_OK);
    check_box(&t, 49, 0, 52, 2);
    CHECK(gpu_sculpt_redo(t.gpu) == SF_OK);
    check_box(&t, 49, 0, 52, 2);
    // A stroke of two calls ends with the box of both, and so does one that is given up.
    for (int ends = 0; ends < 2; ends++) {
        CHECK(gpu_sculpt_begin(t.gpu, &b) == SF_OK);
        CHECK(gpu_sculpt_dab(t.gpu, &near, 1) == SF_OK);
        sf_dab third = dab(20, 20, 0);
        CHECK(gpu_sculpt_dab(t.gpu, &third, 1) == SF_OK);
        CHECK((ends ? gpu_sculpt_end(t.gpu) : gpu_sculpt_abandon(t.gpu)) == SF_OK);
        check_box(&t, 4, 0, 22, 2);
    }
    sf_tip_destroy(tip);
    twin_free(&t);
}

// What stands beside a change and is as it was is no part of it.
static void a_box_without_its_neighbours(void)
{
    sf_sculpt_options o = twin_options(32, 40, 20);
    twin t = twin_new(&o);
    sf_tip *pillar = box_tip(1, 1, 9), *dot = box_tip(0, 0, 0);
    const sf_brush raise = brush_of(SF_BRUSH_ADD_TRIM, pillar, 1);
    const sf_brush add = brush_of(SF_BRUSH_ADD_TRIM, dot, 1);
    const sf_brush take = brush_of(SF_BRUSH_REMOVE_TRIM, dot, 1);
    stroke_both(&t, &raise, dab(10, 10, 9));
    stroke_both(&t, &add, dab(13, 10, 0));
    check_box(&t, 10, 0, 11, 1);
    stroke_both(&t, &take, dab(13, 10, 0));
    check_box(&t, 10, 0, 11, 1);
    CHECK_EQ(twin_differs(&t), 0);
    sf_tip_destroy(pillar);
    sf_tip_destroy(dot);
    twin_free(&t);
}

// ---------------------------------------------------------------------------------------------
// Shapes
// ---------------------------------------------------------------------------------------------

// Everything stands on one voxel of the bed, up to the top; taken away, all of it falls.
static void a_fall_up_to_the_top(void)
{
    for (uint32_t nz = 2; nz < 9; nz++) {
        sf_sculpt_options o = twin_options(70, 20, nz);
        twin t = twin_new(&o);
        sf_grid *shape = NULL;
        CHECK(sf_grid_create(&o.lattice, NULL, &shape) == SF_OK);
        for (uint32_t k = 0; k < nz; k++) {
            CHECK(sf_slice_set(sf_grid_slice(shape, k), 33 + k % 2, 10, 1) == SF_OK);
            CHECK(sf_slice_set(sf_grid_slice(shape, k), 60, 4, 1) == SF_OK);
        }
        CHECK(sf_sculpt_replace(t.cpu, shape, NULL, NULL) == SF_OK);
        CHECK(gpu_sculpt_replace(t.gpu, shape, NULL) == SF_OK);
        sf_tip *tip = box_tip(0, 0, 0);
        sf_brush b = brush_of(SF_BRUSH_REMOVE_TRIM, tip, 1);
        stroke_both(&t, &b, dab(33, 10, 0));
        CHECK_EQ(twin_differs(&t), 0);
        CHECK_EQ(sf_grid_popcount(sf_sculpt_printable(t.cpu)), nz);
        check_box(&t, 10, 0, 11, nz);
        CHECK(sf_sculpt_undo(t.cpu, NULL) == SF_OK && gpu_sculpt_undo(t.gpu) == SF_OK);
        CHECK_EQ(twin_differs(&t), 0);
        sf_tip_destroy(tip);
        sf_grid_destroy(shape);
        twin_free(&t);
    }
}

// Smoothing where nearly every voxel is of a material of its own.
static void votes_of_many_materials(void)
{
    sf_sculpt_options o = twin_options(40, 40, 24);
    for (int round = 0; round < 12; round++) {
        twin t = twin_new(&o);
        sf_grid *shape = NULL;
        uint8_t *materials = calloc(t.voxels, 1);
        CHECK(materials != NULL && sf_grid_create(&o.lattice, NULL, &shape) == SF_OK);
        for (size_t i = 0; i < t.voxels; i++) {
            if (test_random() % 100 < 62) {
                CHECK(sf_slice_set(sf_grid_slice(shape, (uint32_t)(i / 1600)), (uint32_t)(i % 40),
                                   (uint32_t)(i / 40 % 40), 1) == SF_OK);
            }
            materials[i] = (uint8_t)(1 + test_random() % (round % 2 ? 255u : 40u));
        }
        CHECK(sf_sculpt_replace(t.cpu, shape, materials, NULL) == SF_OK);
        CHECK(gpu_sculpt_replace(t.gpu, shape, materials) == SF_OK);
        sf_tip *tip = box_tip(17, 17, 11);
        sf_brush b = brush_of(SF_BRUSH_SMOOTH_TRIM, tip, 1);
        b.passes = 1 + (uint32_t)round % 3;
        stroke_both(&t, &b, dab(20, 20, 11));
        CHECK_EQ(twin_differs(&t), 0);
        sf_tip_destroy(tip);
        sf_grid_destroy(shape);
        free(materials);
        twin_free(&t);
    }
}

// A ring around its anchor, which it leaves out, and which leans to one side.
static sf_tip *ring_tip(int32_t lean)
{
    const sf_lattice l = {9, 9, 2, 1, 1, 1, NULL, {0, 0, 0}};
    const sf_dab anchor = {4 + lean, 4 - lean, 0};
    sf_grid *mask = NULL;
    sf_tip *tip = NULL;
    CHECK(sf_grid_create(&l, NULL, &mask) == SF_OK);
    for (uint32_t k = 0; k < 2; k++) {
        for (uint32_t i = 0; i < 81; i++) {
            uint32_t x = i % 9, y = i / 9;
            if (x < 2 || x > 6 || y < 2 || y > 6) {
                CHECK(sf_slice_set(sf_grid_slice(mask, k), x, y, 1) == SF_OK);
            }
        }
    }
    CHECK(sf_tip_create_mask(mask, anchor, NULL, &tip) == SF_OK);
    sf_grid_destroy(mask);
    return tip;
}

// Paths down along every border, of tips that do not hold the voxel that the path goes through.
static void paths_along_the_border(void)
{
    static const int32_t leans[4] = {0, 3, -3, 7};
    for (int i = 0; i < 4; i++) {
        sf_tip *tip = ring_tip(leans[i]);
        sf_brush b = brush_of(SF_BRUSH_ADD_GROW, tip, 2);
        for (int k = 0; k < 14; k++) {
            sf_sculpt_options o = twin_options(45, 37, 40);
            o.bed_layer = (uint32_t)k % 2 * 3;
            twin t = twin_new(&o);
            for (int again = 0; again < 3; again++) {
                int32_t x = k % 2 ? 44 - k % 4 : k % 5, y = k % 3 ? k % 4 : 36 - k % 6;
                stroke_both(&t, &b, dab(x, (y + 9 * again) % 37, 20 + k + again));
                CHECK_EQ(twin_differs(&t), 0);
                if (again == 1) {
                    CHECK(sf_sculpt_undo(t.cpu, NULL) == SF_OK && gpu_sculpt_undo(t.gpu) == SF_OK);
                    CHECK_EQ(twin_differs(&t), 0);
                }
            }
            twin_free(&t);
        }
        sf_tip_destroy(tip);
    }
}

// Look at the bed without changing anything: a stroke that is given up.
static void look_at_bed(twin *t, const sf_brush *grow, sf_dab at)
{
    sf_sculpt_change c;
    CHECK(sf_sculpt_begin(t->cpu, grow) == SF_OK && gpu_sculpt_begin(t->gpu, grow) == SF_OK);
    CHECK(sf_sculpt_dab(t->cpu, &at, 1, &c) == SF_OK && gpu_sculpt_dab(t->gpu, &at, 1) == SF_OK);
    CHECK(sf_sculpt_abandon(t->cpu, &c) == SF_OK && gpu_sculpt_abandon(t->gpu) == SF_OK);
}

// A plate on the bed and nothing else, put there and taken away, just after the bed was looked at:
// paths come down onto what is there then, and not onto what was.
static void a_bed_that_alone_has_changed(void)
{
    for (uint32_t bed = 0; bed < 3; bed++) {
        sf_sculpt_options o = twin_options(64, 64, 30);
        o.bed_layer = bed;
        twin t = twin_new(&o);
        sf_tip *plate = box_tip(4, 4, 0), *ball = box_tip(1, 1, 1);
        sf_brush put = brush_of(SF_BRUSH_ADD_TRIM, plate, 1);
        sf_brush grow = brush_of(SF_BRUSH_ADD_GROW, ball, 2);
        int32_t z = (int32_t)bed;
        for (int k = 0; k < 4; k++) {
            // Farther than paths lean: they end on the bare bed, as near to what is there as can
            // be.
            static const int32_t places[4][2] = {{6, 7}, {57, 9}, {8, 55}, {56, 58}};
            const sf_dab high = dab(30 + k, 33 - k, 12);
            const sf_dab on_bed = dab(places[k][0], places[k][1], z);
            look_at_bed(&t, &grow, high);
            stroke_both(&t, &put, on_bed);
            stroke_both(&t, &grow, high);
            CHECK_EQ(twin_differs(&t), 0);
            CHECK(sf_sculpt_undo(t.cpu, NULL) == SF_OK && gpu_sculpt_undo(t.gpu) == SF_OK);
            look_at_bed(&t, &grow, high);
            CHECK(sf_sculpt_undo(t.cpu, NULL) == SF_OK && gpu_sculpt_undo(t.gpu) == SF_OK);
            stroke_both(&t, &grow, high); // the plate is gone
            CHECK_EQ(twin_differs(&t), 0);
            CHECK(sf_sculpt_undo(t.cpu, NULL) == SF_OK && gpu_sculpt_undo(t.gpu) == SF_OK);
        }
        sf_tip_destroy(plate);
        sf_tip_destroy(ball);
        twin_free(&t);
    }
}

int main(void)
{
    gl_headless *context = NULL;
    if (!gl_begin(&context)) {
        return gl_status;
    }
    TEST(a_ring_forgets_no_more_than_it_must);
    TEST(a_step_that_is_too_large_empties_it);
    TEST(no_more_steps_than_places);
    TEST(a_box_is_that_of_one_change);
    TEST(a_box_without_its_neighbours);
    TEST(a_fall_up_to_the_top);
    TEST(votes_of_many_materials);
    TEST(paths_along_the_border);
    TEST(a_bed_that_alone_has_changed);
    gl_headless_destroy(context);
    return test_finish();
}

// SPDX-License-Identifier: MIT
// The promise of the brushes on the graphics card (TRUST 33-63, 82): they are the library's, bit
// for bit, materials and counts too. Twelve thousand random strokes at 64^3 on a model of the card
// and on one of the library side by side: whole and in parts, looked at in the middle, given up,
// undone and done again, with ghosts kept, with a bed above the lowest layer; then grids of odd
// sizes. What the library does is held by an oracle of bytes elsewhere (tests/unit/sculpt).
//
// That each line of the shaders is held by this: mutants.md.

#include "random_strokes.h"
#include "twin.h"

// Random strokes at 64^3 altogether.
#define STROKES 12000

// What a run of strokes did, by kind.
typedef struct tally {
    long strokes[SF_BRUSH_KIND_COUNT], changed[SF_BRUSH_KIND_COUNT], special[SF_BRUSH_KIND_COUNT];
} tally;

static void note(tally *t, const random_stroke *s, const sf_sculpt_change *c)
{
    int kind = (int)s->brush.kind, changed = c->printable.x1 + c->material.x1 + c->drawn.x1 > 0;
    int cascades = c->kept_back_voxels + c->lost_voxels + c->path_voxels > 0;
    t->strokes[kind]++;
    t->changed[kind] += changed;
    t->special[kind] += s->brush.kind == SF_BRUSH_PAINT ? changed : cascades;
}

static void compare(twin *t, const char *when)
{
    int differs = twin_differs(t);
    CHECK_EQ(differs, 0);
    if (differs != 0) {
        printf("# %s\n", when);
    }
}

// The counts of the stroke that ended.
static void compare_counts(const twin *t, const sf_sculpt_change *c)
{
    gpu_report r;
    CHECK(gpu_sculpt_report(t->gpu, &r) == SF_OK);
    CHECK_EQ(r.added_voxels, c->added_voxels);
    CHECK_EQ(r.removed_voxels, c->removed_voxels);
    CHECK_EQ(r.lost_voxels, c->lost_voxels);
    CHECK_EQ(r.kept_back_voxels, c->kept_back_voxels);
    CHECK_EQ(r.path_voxels, c->path_voxels);
}

// A stroke: the library in one call, the card in up to three, so that how it is cut is tried too.
static void put_in_parts(twin *t, const random_stroke *s)
{
    size_t first = test_random_below((uint32_t)s->count + 1);
    CHECK(gpu_sculpt_begin(t->gpu, &s->brush) == SF_OK);
    CHECK(gpu_sculpt_dab(t->gpu, s->dabs, first) == SF_OK);
    if (first > 0 && test_random_below(2) == 0) {
        sf_sculpt *cpu = t->cpu;
        CHECK(sf_sculpt_begin(cpu, &s->brush) == SF_OK);
        CHECK(sf_sculpt_dab(cpu, s->dabs, first, NULL) == SF_OK);
        compare(t, "in the middle");
        CHECK(sf_sculpt_abandon(cpu, NULL) == SF_OK);
    }
    for (size_t i = s->count; i-- > first;) { // backwards
        CHECK(gpu_sculpt_dab(t->gpu, &s->dabs[i], 1) == SF_OK);
    }
}

static void stroke(twin *t, const random_stroke *s, sf_sculpt_change *change)
{
    switch (test_random_below(8)) {
    case 0: // given up first
        CHECK(gpu_sculpt_begin(t->gpu, &s->brush) == SF_OK);
        CHECK(gpu_sculpt_dab(t->gpu, s->dabs, s->count) == SF_OK);
        CHECK(gpu_sculpt_abandon(t->gpu) == SF_OK);
        compare(t, "given up");
        CHECK(gpu_sculpt_stroke(t->gpu, &s->brush, s->dabs, s->count) == SF_OK);
        break;
    case 1:
    case 2:
        put_in_parts(t, s);
        CHECK(gpu_sculpt_end(t->gpu) == SF_OK);
        break;
    default:
        CHECK(gpu_sculpt_stroke(t->gpu, &s->brush, s->dabs, s->count) == SF_OK);
    }
    CHECK(sf_sculpt_stroke(t->cpu, &s->brush, s->dabs, s->count, change) == SF_OK);
    compare(t, "after the stroke");
    compare_counts(t, change);
}

// Some steps back, some of them forth again. Where the library has no step the card must not have
// one either.
static void go_back_and_forth(twin *t)
{
    uint32_t back = test_random_below(5), forth = test_random_below(5);
    for (uint32_t i = 0; i < back + forth; i++) {
        sf_status expected = i < back ? sf_sculpt_undo(t->cpu, NULL) : sf_sculpt_redo(t->cpu, NULL);
        CHECK(expected == SF_OK || expected == SF_ERR_INFEASIBLE);
        CHECK((i < back ? gpu_sculpt_undo(t->gpu) : gpu_sculpt_redo(t->gpu)) == SF_OK);
        compare(t, i < back ? "undone" : "done again");
    }
}

static void run(const sf_sculpt_options *options, int strokes, tally *sums)
{
    twin t = twin_new(options);
    for (int i = 0; i < strokes && test_case_failures == 0; i++) {
        random_stroke s = random_stroke_new(&options->lattice, 8);
        sf_sculpt_change change;
        stroke(&t, &s, &change);
        note(sums, &s, &change);
        if (test_random_below(8) == 0) {
            go_back_and_forth(&t);
        }
        if (test_case_failures > 0) {
            printf("# stroke %d, %s\n", i, sf_brush_kind_name(s.brush.kind));
        }
        if (i % 400 == 399) { // begin again, so that there is room for all brushes
            CHECK(gpu_sculpt_replace(t.gpu, NULL, NULL) == SF_OK);
            CHECK(sf_sculpt_replace(t.cpu, NULL, NULL, NULL) == SF_OK);
        }
        random_stroke_free(&s);
    }
    twin_free(&t);
}

static void at_64(void)
{
    tally sums = {{0}, {0}, {0}};
    for (int i = 0; i < 4; i++) {
        sf_sculpt_options options = twin_options(64, 64, 64);
        options.keep_drawn = i & 1;
        options.bed_layer = i < 2 ? 0 : 5;
        run(&options, STROKES * (i < 2 ? 4 : 1) / 10, &sums);
    }
    long strokes = 0, changed = 0;
    for (int k = 0; k < SF_BRUSH_KIND_COUNT; k++) {
        printf("# %s: %ld strokes, %ld changed the shape, %ld held back, lost or led\n",
               sf_brush_kind_name((sf_brush_kind)k), sums.strokes[k], sums.changed[k],
               sums.special[k]);
        CHECK(test_case_failures > 0 || sums.special[k] >= 500);
        strokes += sums.strokes[k];
        changed += sums.changed[k];
    }
    CHECK(test_case_failures > 0 || strokes == STROKES);
    CHECK(changed * 10 >= strokes * 3);
}

static void at_odd_sizes(void)
{
    static const uint32_t sizes[][3] = {{70, 13, 20}, {33, 64, 31}, {97, 5, 40},
                                        {1, 1, 6},    {2, 90, 12},  {128, 3, 1}};
    tally sums = {{0}, {0}, {0}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        sf_sculpt_options options = twin_options(sizes[i][0], sizes[i][1], sizes[i][2]);
        options.keep_drawn = (int)(i & 1);
        run(&options, 120, &sums);
    }
}

// A stroke of a brush along a line, and the model it leaves.
static void draw_line(twin *t, sf_brush_kind kind, const sf_tip *tip, sf_dab from, sf_dab to)
{
    sf_dab dabs[1200];
    size_t count = 0;
    sf_brush brush = sf_brush_default();
    sf_sculpt_change change;
    brush.kind = kind;
    brush.tip = tip;
    brush.material = (uint8_t)(kind + 1);
    brush.mirror_x = brush.mirror_y = 1;
    CHECK(sf_dab_line(from, to, dabs, 1200, &count) == SF_OK);
    CHECK(sf_sculpt_stroke(t->cpu, &brush, dabs, count, &change) == SF_OK);
    CHECK(gpu_sculpt_stroke(t->gpu, &brush, dabs, count) == SF_OK);
    compare(t, sf_brush_kind_name(kind));
    compare_counts(t, &change);
}

// More dabs, four times each, than go to the card at once; a good part of them beyond the grid.
static void along_lines(void)
{
    sf_sculpt_options options = twin_options(64, 64, 64);
    twin t = twin_new(&options);
    sf_tip *tip = NULL;
    const double radius[3] = {3, 2, 4};
    CHECK(sf_tip_create(SF_TIP_SPHERE, radius, NULL, &tip) == SF_OK);
    static const sf_brush_kind kinds[] = {
        SF_BRUSH_ADD_GROW,    SF_BRUSH_ADD_TRIM,        SF_BRUSH_REMOVE_TRIM, SF_BRUSH_ADD_GROW,
        SF_BRUSH_SMOOTH_TRIM, SF_BRUSH_REMOVE_PRESERVE, SF_BRUSH_PAINT,       SF_BRUSH_ADD_GROW};
    for (int i = 0; i < 16; i++) {
        sf_dab from = {(int32_t)test_random_below(300) - 150, (int32_t)test_random_below(80) - 8,
                       (int32_t)test_random_below(80) - 8};
        sf_dab to = {from.x + 400, (int32_t)test_random_below(80) - 8,
                     (int32_t)test_random_below(80) - 8};
        draw_line(&t, kinds[i % 8], tip, from, to);
    }
    sf_tip_destroy(tip);
    twin_free(&t);
}

// Distances on the bed are kept from one path to the next; whatever changes the bed's matter
// between two paths, a stroke, an undo, a redo or another model, they must be found anew.
static void the_bed_is_looked_at_again(void)
{
    sf_sculpt_options options = twin_options(64, 64, 64);
    const double radius[3] = {1, 1, 1};
    sf_tip *tip = NULL;
    CHECK(sf_tip_create(SF_TIP_SPHERE, radius, NULL, &tip) == SF_OK);
    for (int i = 0; i < 12; i++) {
        twin t = twin_new(&options);
        const sf_dab corner = {i & 1 ? 60 : 3, i & 2 ? 60 : 3, 0}, middle = {30, 31, 20};
        const sf_dab other = {63 - corner.x, 26 + i, 0};
        sf_brush brush = sf_brush_default();
        brush.tip = tip;
        CHECK(gpu_sculpt_stroke(t.gpu, &brush, &other, 1) == SF_OK);
        CHECK(sf_sculpt_stroke(t.cpu, &brush, &other, 1, NULL) == SF_OK);
        CHECK(gpu_sculpt_stroke(t.gpu, &brush, &corner, 1) == SF_OK);
        CHECK(sf_sculpt_stroke(t.cpu, &brush, &corner, 1, NULL) == SF_OK);
        for (int step = 0; step < 4; step++) {
            brush.kind = SF_BRUSH_ADD_GROW; // found, and given up, so that the bed stays as it is
            CHECK(gpu_sculpt_begin(t.gpu, &brush) == SF_OK);
            CHECK(gpu_sculpt_dab(t.gpu, &middle, 1) == SF_OK);
            CHECK(sf_sculpt_begin(t.cpu, &brush) == SF_OK);
            CHECK(sf_sculpt_dab(t.cpu, &middle, 1, NULL) == SF_OK);
            compare(&t, "to the bed");
            CHECK(gpu_sculpt_abandon(t.gpu) == SF_OK);
            CHECK(sf_sculpt_abandon(t.cpu, NULL) == SF_OK);
            CHECK((step < 2 ? gpu_sculpt_undo(t.gpu) : gpu_sculpt_redo(t.gpu)) == SF_OK);
            CHECK((step < 2 ? sf_sculpt_undo(t.cpu, NULL) : sf_sculpt_redo(t.cpu, NULL)) == SF_OK);
        }
        CHECK(gpu_sculpt_replace(t.gpu, NULL, NULL) == SF_OK);
        CHECK(sf_sculpt_replace(t.cpu, NULL, NULL, NULL) == SF_OK);
        draw_line(&t, SF_BRUSH_ADD_GROW, tip, middle, middle);
        twin_free(&t);
    }
    sf_tip_destroy(tip);
}

// Anchors far outside their tips and dabs as far as they may be.
static void from_afar(void)
{
    static const int32_t far = 1 << 30;
    sf_sculpt_options options = twin_options(64, 30, 64);
    twin t = twin_new(&options);
    sf_lattice three = {3, 4, 5, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *mask = NULL;
    CHECK(sf_grid_create(&three, NULL, &mask) == SF_OK);
    for (uint32_t z = 0; z < 5; z++) {
        CHECK(sf_slice_fill(sf_grid_slice(mask, z), (sf_rect){0, 0, 3 - z / 2, 4}, 1) == SF_OK);
    }
    const sf_dab anchors[] = {{far, 0, 0},   {-far, far, 2}, {1, 1, -far}, {-40, 3, 1},
                              {40, -20, -3}, {1, 2, 1},      {0, 40, 60}};
    for (size_t i = 0; i < sizeof anchors / sizeof *anchors; i++) {
        sf_tip *tip = NULL;
        CHECK(sf_tip_create_mask(mask, anchors[i], NULL, &tip) == SF_OK);
        for (int kind = 0; kind < SF_BRUSH_KIND_COUNT; kind++) {
            const sf_dab near = {20, 10, 30};
            sf_dab onto = {anchors[i].x > 0 ? anchors[i].x : 0, anchors[i].y > 0 ? anchors[i].y : 0,
                           anchors[i].z > 0 ? anchors[i].z : 0};
            draw_line(&t, (sf_brush_kind)kind, tip, near, near);
            draw_line(&t, (sf_brush_kind)kind, tip, onto, onto);
            draw_line(&t, (sf_brush_kind)kind, tip, (sf_dab){-far, far, far},
                      (sf_dab){-far, far, far});
        }
        sf_tip_destroy(tip);
    }
    sf_grid_destroy(mask);
    twin_free(&t);
}

int main(void)
{
    gl_headless *context = NULL;
    if (!gl_begin(&context)) {
        return gl_status;
    }
    TEST(along_lines);
    TEST(the_bed_is_looked_at_again);
    TEST(from_afar);
    TEST(at_odd_sizes);
    TEST(at_64);
    gl_headless_destroy(context);
    return test_finish();
}

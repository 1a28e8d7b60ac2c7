// SPDX-License-Identifier: MIT
// Why: a print that topples half way is lost. Margins after each layer are held against a search
// that starts anew for every layer: breadth-first over its voxels, sums over the piece, every line
// through two corners of its squares on the bed that has all others on one side (ALGORITHMS 8.4).

#include "failing_allocator.h"
#include "law/stack.h"

#include <sf/printing.h>

#define HALF_PI 1.5707963267948966

typedef struct oracle {
    double margins[64], margin;
    uint32_t layer, toppling, standing;
    uint64_t floating;
    int floating_layer;
} oracle;

// ---------------------------------------------------------------------------------------------
// Anew for every layer
// ---------------------------------------------------------------------------------------------

typedef struct heap { // of voxels that are connected
    int voxels[STACK_VOXELS], count;
} heap;

static void flood(const stack *s, int bed, int top, int start, int corners, uint8_t *seen, heap *h)
{
    int layer = s->nx * s->ny;
    h->count = 0;
    h->voxels[h->count++] = start;
    seen[start] = 1;
    for (int head = 0; head < h->count; head++) {
        int i = h->voxels[head], x = i % s->nx, y = i % layer / s->nx, z = i / layer;
        for (int d = 0; d < 27; d++) {
            int dx = d % 3 - 1, dy = d / 3 % 3 - 1, dz = d / 9 - 1;
            int px = x + dx, py = y + dy, pz = z + dz;
            if (pz < bed || pz > top || (!corners && abs(dx) + abs(dy) + abs(dz) != 1) ||
                !stack_get(s, px, py, pz) || seen[(pz * s->ny + py) * s->nx + px]) {
                continue;
            }
            seen[(pz * s->ny + py) * s->nx + px] = 1;
            h->voxels[h->count++] = (pz * s->ny + py) * s->nx + px;
        }
    }
}

// The margin of a piece, or more than a right angle where it does not stand on the bed.
static double margin_of(const stack *s, const sf_lattice *l, int bed, const heap *h)
{
    static double xs[4 * STACK_VOXELS], ys[4 * STACK_VOXELS];
    int count = 0, layer = s->nx * s->ny;
    double sum[3] = {0, 0, 0}, mass = 0, least = 1e9;
    for (int n = 0; n < h->count; n++) {
        int i = h->voxels[n], x = i % s->nx, y = i % layer / s->nx, z = i / layer;
        double height = sf_lattice_layer_height(l, (uint32_t)z);
        sum[0] += height * (x + 0.5) * l->pitch_x_mm;
        sum[1] += height * (y + 0.5) * l->pitch_y_mm;
        sum[2] += height * (sf_lattice_layer_bottom(l, (uint32_t)z) -
                            sf_lattice_layer_bottom(l, (uint32_t)bed) + 0.5 * height);
        mass += height;
        for (int c = 0; c < 4 && z == bed; c++) {
            xs[count] = (x + c % 2) * l->pitch_x_mm;
            ys[count++] = (y + c / 2) * l->pitch_y_mm;
        }
    }
    for (int a = 0; a < count; a++) {
        for (int b = 0; b < count; b++) {
            double dx = xs[b] - xs[a], dy = ys[b] - ys[a];
            int all = dx != 0 || dy != 0;
            for (int c = 0; c < count && all; c++) {
                all = dx * (ys[c] - ys[a]) - dy * (xs[c] - xs[a]) >= -1e-9;
            }
            if (all) {
                double d =
                    (dx * (sum[1] / mass - ys[a]) - dy * (sum[0] / mass - xs[a])) / hypot(dx, dy);
                least = d < least ? d : least;
            }
        }
    }
    return count > 0 ? atan(least / (sum[2] / mass)) : 9;
}

static void look_anew(const stack *s, const sf_lattice *l, int bed, int corners, oracle *o)
{
    static uint8_t seen[STACK_VOXELS];
    static heap h;
    int layer = s->nx * s->ny;
    oracle none = {{0}, HALF_PI, SF_BED_AUTO, 0, 0, 0, -1};
    *o = none;
    for (int k = 0; k < s->nz; k++) {
        uint32_t standing = 0;
        o->margins[k] = HALF_PI;
        memset(seen, 0, sizeof seen);
        for (int i = bed * layer; i < (k + 1) * layer; i++) {
            if (!s->solid[i] || seen[i]) {
                continue;
            }
            flood(s, bed, k, i, corners, seen, &h);
            double margin = margin_of(s, l, bed, &h);
            int is_new = 1;
            for (int n = 0; n < h.count; n++) {
                is_new = is_new && h.voxels[n] / layer == k;
            }
            if (margin < 2) {
                standing++;
                o->margins[k] = fmin(o->margins[k], margin);
            } else if (is_new) {
                o->floating++;
                o->floating_layer = o->floating_layer < 0 ? k : o->floating_layer;
            }
        }
        o->standing = standing > o->standing ? standing : o->standing;
        o->toppling += o->margins[k] < 0;
        if (standing > 0 && (o->layer == SF_BED_AUTO || o->margins[k] < o->margin - 1e-9)) {
            o->margin = o->margins[k];
            o->layer = (uint32_t)k;
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Against the library
// ---------------------------------------------------------------------------------------------

// What the report says of the worst piece must give its margin.
static void check_report(const sf_printing_report *r, const sf_lattice *l)
{
    double along[3], from[3], bed = sf_lattice_layer_bottom(l, r->bed_layer);
    for (int d = 0; d < 3; d++) {
        along[d] = r->edge_mm[1][d] - r->edge_mm[0][d];
        from[d] = r->com_mm[d] - r->edge_mm[0][d];
    }
    double inside = (along[0] * from[1] - along[1] * from[0]) / hypot(along[0], along[1]);
    CHECK_NEAR(r->margin_rad, atan(inside / from[2]), 1e-9);
    CHECK_NEAR(r->edge_mm[0][2], bed, 1e-9);
    CHECK_NEAR(r->edge_mm[1][2], bed, 1e-9);
    CHECK(r->piece.z0 == r->bed_layer && r->piece.z1 <= r->layer + 1);
    CHECK(r->piece_voxels > 0);
}

static void compare(const stack *s, sf_grid *grid, uint32_t bed_layer, int corners)
{
    static oracle o;
    double margins[64];
    sf_lattice l = sf_grid_lattice(grid);
    sf_printing_options options = sf_printing_options_default();
    sf_printing_report r;
    int bed = stack_bed(s, bed_layer);
    stack_write(s, grid);
    options.bed_layer = bed_layer;
    options.connectivity = corners ? SF_CONNECT_CORNERS : SF_CONNECT_EDGES;
    options.margins_rad = margins;
    options.margin_capacity = 64;
    CHECK_EQ(sf_grid_printing(grid, &options, NULL, NULL, &r), SF_OK);
    if (bed == s->nz) {
        CHECK_EQ(r.bed_layer, SF_BED_AUTO);
        CHECK_EQ(r.layer, SF_BED_AUTO);
        CHECK_NEAR(r.margin_rad, HALF_PI, 0);
        return;
    }
    look_anew(s, &l, bed, corners, &o);
    CHECK_EQ(r.bed_layer, bed);
    for (int k = 0; k < s->nz; k++) {
        CHECK_NEAR(margins[k], o.margins[k], 1e-9);
    }
    CHECK_NEAR(r.margin_rad, o.margin, 1e-9);
    CHECK_EQ(r.standing_count, o.standing);
    CHECK_EQ(r.floating_count, o.floating);
    CHECK_EQ(r.floating_layer, o.floating_layer < 0 ? SF_BED_AUTO : (uint32_t)o.floating_layer);
    if (r.layer != SF_BED_AUTO) {
        CHECK_NEAR(margins[r.layer], r.margin_rad, 0);
        check_report(&r, &l);
    }
    CHECK_EQ(r.layer == SF_BED_AUTO, o.layer == SF_BED_AUTO);
    int clear = 1; // of angles that are 0 but for rounding
    for (int k = 0; k < s->nz; k++) {
        clear = clear && fabs(o.margins[k]) > 1e-9;
    }
    CHECK(!clear || r.toppling_layers == o.toppling);
}

static void random_shapes(void)
{
    static stack s;
    static const double heights[] = {0.3, 1, 0.01, 2.5, 0.7, 0.1, 1, 1.3};
    for (int kind = 0; kind < 3; kind++) {
        sf_lattice l = {
            9, 7, 8, 0.5, kind == 0 ? 0.5 : 0.8, 0.25, kind == 2 ? heights : NULL, {3, -7, 11}};
        sf_grid *grid = NULL;
        CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
        for (int i = 0; i < 700; i++) {
            if (i % 3 == 0) {
                stack_random_boxes(&s, 9, 7, 8, 5 + (int)test_random_below(6));
            } else {
                stack_random(&s, 9, 7, 8, i % 3 == 1 ? 0.12 : 0.3);
            }
            uint32_t bed = i % 5 == 0 ? test_random_below(8) : SF_BED_AUTO;
            compare(&s, grid, bed, i % 2);
        }
        sf_grid_destroy(grid);
    }
}

// Runs across words, and many pieces.
static void wide_shapes(void)
{
    static stack s;
    sf_lattice l = {130, 3, 4, 0.5, 0.5, 0.5, NULL, {0, 0, 0}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
    for (int i = 0; i < 40; i++) {
        stack_random(&s, 130, 3, 4, 0.1 + 0.2 * test_random_unit());
        compare(&s, grid, SF_BED_AUTO, i % 2);
    }
    sf_grid_destroy(grid);
}

static sf_printing_report report_of(const char *text)
{
    static stack s;
    sf_printing_report r;
    stack_parse(&s, text);
    sf_grid *grid = stack_grid(&s);
    CHECK_EQ(sf_grid_printing(grid, NULL, NULL, NULL, &r), SF_OK);
    sf_grid_destroy(grid);
    return r;
}

static void names_by_hand(void)
{
    // A tower: it stands worst when it is done.
    sf_printing_report r = report_of("##|##|##|##");
    CHECK_NEAR(r.margin_rad, atan(0.5 / 2), 1e-12);
    CHECK_EQ(r.layer, 3);
    CHECK_EQ(r.piece_voxels, 8);
    // An arm to the right that a later one to the left balances.
    r = report_of("...#...|...####|#######|####...");
    CHECK_EQ(r.layer, 1);
    CHECK_EQ(r.toppling_layers, 1);
    CHECK_NEAR(r.margin_rad, atan((0.5 - 6 / 5.0) / (0.5 + 4 / 5.0)), 1e-12);
    CHECK(r.piece.x0 == 3 && r.piece.x1 == 7 && r.piece.z1 == 2);
    // Two legs that lean apart: each falls by itself, together they would not.
    r = report_of("..#.#..|.##.##.|##...##|#.....#");
    CHECK_EQ(r.standing_count, 2);
    CHECK(r.margin_rad < -0.2);
    CHECK(r.toppling_layers >= 2);
    // A block that begins in the air, and is caught.
    r = report_of("###....|#....##|#######");
    CHECK_EQ(r.floating_count, 1);
    CHECK_EQ(r.floating_layer, 1);
    CHECK(r.margin_rad < 0 && r.layer == 2);
    r = report_of("...|...");
    CHECK(r.bed_layer == SF_BED_AUTO && r.layer == SF_BED_AUTO && r.standing_count == 0);
}

// What rests on what lies below it within a voxel is connected with the bed, corner by corner.
static void what_is_support_free_never_floats(void)
{
    static stack s;
    sf_rule rule = sf_rule_box3();
    for (int i = 0; i < 300; i++) {
        sf_printing_report r;
        stack_random(&s, 9, 7, 8, 0.3);
        sf_grid *grid = stack_grid(&s);
        CHECK_EQ(sf_grid_trim(grid, &rule, SF_BED_AUTO, NULL, NULL), SF_OK);
        CHECK_EQ(sf_grid_printing(grid, NULL, NULL, NULL, &r), SF_OK);
        CHECK_EQ(r.floating_count, 0);
        sf_grid_destroy(grid);
    }
}

// ---------------------------------------------------------------------------------------------
// Promises
// ---------------------------------------------------------------------------------------------

typedef struct watch {
    int calls, cancel_at;
    sf_task *task;
    double last;
} watch;

static void watching(void *user, double fraction)
{
    watch *w = user;
    CHECK(fraction >= w->last && fraction <= 1);
    w->last = fraction;
    if (++w->calls == w->cancel_at) {
        sf_task_cancel(w->task);
    }
}

static void failing_calls_change_nothing(void)
{
    static stack s;
    double margins[8], margins_before[8];
    sf_printing_options options = sf_printing_options_default(), bad;
    sf_printing_report report, before;
    stack_random_boxes(&s, 12, 12, 6, 20);
    sf_grid *grid = stack_grid(&s);
    memset(&report, 0x5a, sizeof report);
    memset(margins, 0x5a, sizeof margins);
    before = report;
    memcpy(margins_before, margins, sizeof margins);
    options.margins_rad = margins;
    options.margin_capacity = 8;
    CHECK_EQ(sf_grid_printing(NULL, &options, NULL, NULL, &report), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_printing(grid, &options, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    bad = options;
    bad.struct_size = 8;
    CHECK_EQ(sf_grid_printing(grid, &bad, NULL, NULL, &report), SF_ERR_ARGUMENT);
    bad = options;
    bad.bed_layer = 6;
    CHECK_EQ(sf_grid_printing(grid, &bad, NULL, NULL, &report), SF_ERR_ARGUMENT);
    bad = options;
    bad.connectivity = (sf_connectivity)6;
    CHECK_EQ(sf_grid_printing(grid, &bad, NULL, NULL, &report), SF_ERR_ARGUMENT);
    bad = options;
    bad.margin_capacity = 5;
    CHECK_EQ(sf_grid_printing(grid, &bad, NULL, NULL, &report), SF_ERR_CAPACITY);
    for (int cancel_at = 1; cancel_at < 6; cancel_at++) {
        sf_task task = sf_task_default();
        watch w = {0, cancel_at, &task, 0};
        task.progress = watching;
        task.user = &w;
        CHECK_EQ(sf_grid_printing(grid, &options, NULL, &task, &report), SF_ERR_CANCELLED);
    }
    failing_allocator f;
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status == SF_ERR_MEMORY && k < 100; k++) {
        CHECK(memcmp(&report, &before, sizeof report) == 0);
        CHECK(memcmp(margins, margins_before, sizeof margins) == 0);
        failing_begin(&f, k);
        status = sf_grid_printing(grid, &options, &f.allocator, NULL, &report);
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
    CHECK_EQ(status, SF_OK);
    CHECK(f.requests >= 6);
    CHECK(memcmp(margins + 6, margins_before + 6, 2 * sizeof *margins) == 0);
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(names_by_hand);
    TEST(random_shapes);
    TEST(wide_shapes);
    TEST(what_is_support_free_never_floats);
    TEST(failing_calls_change_nothing);
    return test_finish();
}

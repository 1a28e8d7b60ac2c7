// SPDX-License-Identifier: MIT
// Why: what the voxeliser promises beside its voxels. A failing or cancelled call leaves the grid
// as it was and frees what it took; slices one at a time, a grid at once, and a grid by pieces run
// in any order are the same bytes; bad arguments are refused with a sentence. Guards HOUSE 3:
// strong guarantee, memory, tasks; and the report of each way to fill.

#include "../../failing_allocator.h"
#include "solids.h"

static solid s;

// A closed ball, an open one, or loose triangles: every path through the voxeliser.
static void make_scene(int kind)
{
    s.vertex_count = s.triangle_count = 0;
    double center[3] = {10, 10, 10};
    solid_sphere(&s, center, 8, 8, 10, 0.2);
    if (kind == 1) {
        s.triangle_count -= 5;
    } else if (kind == 2) {
        for (size_t t = 0; t < s.triangle_count; t += 3) {
            solid_flip(&s, t);
        }
    }
}

static sf_grid *dirty_grid(const sf_lattice *lattice)
{
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(lattice, NULL, &grid), SF_OK);
    for (uint32_t k = 0; k < lattice->nz; k += 3) {
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, k), k % 5, k % 7, 1), SF_OK);
    }
    return grid;
}

static void allocations_may_fail(void)
{
    sf_lattice lattice = solid_lattice(20, 20, 20);
    sf_task task = sf_task_default();
    for (int kind = 0; kind < 3; kind++) {
        make_scene(kind);
        for (int surface = 0; surface < 2; surface++) {
            sf_voxelize_options options = sf_voxelize_options_default();
            options.fill = surface ? SF_FILL_SURFACE : SF_FILL_AUTO;
            sf_grid *grid = dirty_grid(&lattice), *before = dirty_grid(&lattice);
            sf_status status = SF_ERR_MEMORY;
            long n = 0;
            for (; status != SF_OK && n < 200; n++) {
                failing_allocator f;
                failing_begin(&f, n);
                sf_voxelize_report report = {SF_FILL_AUTO, 7, 7, 7, 7};
                status =
                    sf_grid_voxelize(grid, solid_view(&s), &options, &f.allocator, &task, &report);
                CHECK_EQ(f.live, 0);
                CHECK_EQ(f.faults, 0);
                if (status != SF_OK) {
                    CHECK_EQ(status, SF_ERR_MEMORY);
                    CHECK(sf_grid_equal(grid, before));
                    CHECK_EQ(report.solid_voxels, 7);
                }
            }
            CHECK(n > 5 && n < 200);
            CHECK(!sf_grid_equal(grid, before));
            sf_grid_destroy(before);
            sf_grid_destroy(grid);
        }
    }
}

static void creation_may_fail(void)
{
    sf_lattice lattice = solid_lattice(20, 20, 20);
    make_scene(1);
    sf_status status = SF_ERR_MEMORY;
    for (long n = 0; status != SF_OK && n < 200; n++) {
        failing_allocator f;
        failing_begin(&f, n);
        sf_voxelizer *v = NULL;
        sf_fault fault;
        status = sf_voxelizer_create(solid_view(&s), &lattice, NULL, &f.allocator, &v, &fault);
        if (status != SF_OK) {
            CHECK_EQ(status, SF_ERR_MEMORY);
            CHECK_EQ(fault.status, SF_ERR_MEMORY);
            CHECK(v == NULL);
        }
        sf_voxelizer_destroy(v);
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
    CHECK_EQ(status, SF_OK);
}

typedef struct host {
    sf_task *task;
    int steps, cancel_at;
    double last;
    size_t widest;
} host;

static void count_progress(void *user, double fraction)
{
    host *h = user;
    CHECK(fraction >= h->last && fraction <= 1);
    h->last = fraction;
    if (h->steps++ == h->cancel_at) {
        sf_task_cancel(h->task);
    }
}

static void backwards(void *user, size_t count, sf_task_body body, void *context)
{
    host *h = user;
    h->widest = count > h->widest ? count : h->widest;
    while (count > 0) {
        body(context, --count);
    }
}

static void a_cancel_changes_nothing(void)
{
    sf_lattice lattice = solid_lattice(20, 1200, 20); // many slabs
    make_scene(0);
    for (int dirty = 0; dirty < 2; dirty++) {
        sf_grid *grid = NULL, *before = NULL;
        CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
        if (dirty) {
            CHECK_EQ(sf_slice_set(sf_grid_slice(grid, 3), 4, 5, 1), SF_OK);
        }
        CHECK_EQ(sf_grid_clone(grid, NULL, &before), SF_OK);
        int cancelled = 0;
        for (int at = -1; at < 2; at++) {
            sf_task task = sf_task_default();
            host h = {&task, 0, at, 0, 0};
            task.progress = count_progress;
            task.user = &h;
            if (at < 0) {
                sf_task_cancel(&task);
            }
            sf_status status = sf_grid_voxelize(grid, solid_view(&s), NULL, NULL, &task, NULL);
            cancelled += status == SF_ERR_CANCELLED;
            CHECK(sf_grid_equal(grid, before));
        }
        CHECK_EQ(cancelled, 3);
        sf_grid_destroy(before);
        sf_grid_destroy(grid);
    }
}

typedef struct stopper {
    sf_task *task;
    const sf_grid *grid;
    int rounds;
} stopper;

// Cancels with one slab begun, and looks whether those that come after still write.
static void stop_midway(void *user, size_t count, sf_task_body body, void *context)
{
    stopper *h = user;
    body(context, 0);
    sf_task_cancel(h->task);
    uint64_t before = sf_grid_popcount(h->grid);
    CHECK(before > 0);
    for (size_t i = 1; i < count; i++) {
        body(context, i);
    }
    CHECK(count > 1);
    CHECK_EQ(sf_grid_popcount(h->grid), before);
    h->rounds++;
}

static void a_cancel_is_heard_within_a_slab(void)
{
    sf_lattice lattice = solid_lattice(20, 1200, 20);
    for (int open = 0; open < 2; open++) {
        double low[3] = {2, 2, 1}, high[3] = {18, 1100, 19};
        s.vertex_count = s.triangle_count = 0;
        solid_box(&s, low, high);
        s.triangle_count -= (size_t)open;
        for (int fill = SF_FILL_AUTO; fill <= SF_FILL_SURFACE; fill++) {
            sf_grid *grid = NULL;
            CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
            sf_task task = sf_task_default();
            stopper h = {&task, grid, 0};
            task.parallel_for = stop_midway;
            task.user = &h;
            sf_voxelize_options options = sf_voxelize_options_default();
            options.fill = (sf_fill)fill;
            CHECK_EQ(sf_grid_voxelize(grid, solid_view(&s), &options, NULL, &task, NULL),
                     SF_ERR_CANCELLED);
            CHECK_EQ(h.rounds, 1);
            CHECK_EQ(sf_grid_popcount(grid), 0);
            sf_grid_destroy(grid);
        }
    }
}

static void pieces_in_any_order(void)
{
    sf_lattice lattice = solid_lattice(21, 1100, 23);
    for (int kind = 0; kind < 3; kind++) {
        make_scene(kind);
        for (size_t i = 0; i < s.vertex_count; i++) {
            s.vertices[3 * i + 1] *= 50;
        }
        for (int fill = SF_FILL_AUTO; fill <= SF_FILL_SURFACE; fill++) {
            sf_voxelize_options options = sf_voxelize_options_default();
            options.fill = (sf_fill)fill;
            sf_voxelize_report plain, pieces;
            sf_grid *one = solid_voxelize(solid_view(&s), &lattice, (sf_fill)fill, &plain);
            sf_grid *two = NULL;
            CHECK_EQ(sf_grid_create(&lattice, NULL, &two), SF_OK);
            sf_task task = sf_task_default();
            host h = {&task, 0, -1, 0, 0};
            task.parallel_for = backwards;
            task.progress = count_progress;
            task.user = &h;
            CHECK_EQ(sf_grid_voxelize(two, solid_view(&s), &options, NULL, &task, &pieces), SF_OK);
            CHECK(sf_grid_equal(one, two));
            CHECK(h.widest > 1 && h.last == 1.0);
            CHECK_EQ(plain.solid_voxels, pieces.solid_voxels);
            CHECK_EQ(plain.odd_rows, pieces.odd_rows);
            CHECK_EQ(plain.fill, pieces.fill);
            sf_grid_destroy(two);
            sf_grid_destroy(one);
        }
    }
}

static void slices_one_at_a_time(void)
{
    sf_lattice lattice = solid_lattice(70, 23, 21);
    uint64_t words[2 * 23];
    for (int kind = 0; kind < 3; kind++) {
        make_scene(kind);
        for (int fill = SF_FILL_AUTO; fill <= SF_FILL_SURFACE; fill++) {
            sf_voxelize_options options = sf_voxelize_options_default();
            options.fill = (sf_fill)fill;
            sf_voxelize_report whole, sum;
            sf_grid *grid = solid_voxelize(solid_view(&s), &lattice, (sf_fill)fill, &whole);
            sf_voxelizer *v = NULL;
            CHECK_EQ(sf_voxelizer_create(solid_view(&s), &lattice, &options, NULL, &v, NULL),
                     SF_OK);
            for (uint32_t n = 0; n < lattice.nz; n++) {
                uint32_t k = n * 8 % lattice.nz; // 8 and 21 have no common factor
                sf_slice slice = {words, 70, 23, 2}, expected = sf_grid_slice(grid, k);
                memset(words, 0xa5, sizeof words);
                CHECK_EQ(sf_voxelizer_slice(v, k, slice), SF_OK);
                for (uint32_t y = 0; y < 23; y++) {
                    CHECK(memcmp(words + 2 * y, expected.words + y * expected.stride, 16) == 0);
                }
            }
            CHECK_EQ(sf_voxelizer_report(v, &sum), SF_OK);
            CHECK_EQ(sum.solid_voxels, whole.solid_voxels);
            CHECK_EQ(sum.odd_rows, whole.odd_rows);
            sf_voxelizer_destroy(v);
            sf_grid_destroy(grid);
        }
    }
}

static void refusals(void)
{
    sf_lattice lattice = solid_lattice(8, 8, 8), bad = solid_lattice(8, 0, 8);
    sf_voxelizer *v = NULL;
    sf_fault fault;
    make_scene(0);
    sf_mesh_view view = solid_view(&s), broken = view;
    CHECK_EQ(sf_voxelizer_create(view, &bad, NULL, NULL, &v, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_voxelizer_create(view, NULL, NULL, NULL, &v, &fault), SF_ERR_ARGUMENT);
    sf_voxelize_options options = sf_voxelize_options_default();
    options.fill = (sf_fill)9;
    CHECK_EQ(sf_voxelizer_create(view, &lattice, &options, NULL, &v, &fault), SF_ERR_ARGUMENT);
    broken.vertex_count = 5;
    CHECK_EQ(sf_voxelizer_create(broken, &lattice, NULL, NULL, &v, &fault), SF_ERR_ARGUMENT);
    s.vertices[4] = NAN;
    CHECK_EQ(sf_voxelizer_create(view, &lattice, NULL, NULL, &v, &fault), SF_ERR_UNSUPPORTED);
    CHECK(strstr(fault.message, "ertex 1 ") != NULL);
    s.vertices[4] = 1e9;
    CHECK_EQ(sf_voxelizer_create(view, &lattice, NULL, NULL, &v, &fault), SF_ERR_UNSUPPORTED);
    CHECK(v == NULL);
    sf_mesh_view nothing = {NULL, 0, NULL, 0};
    CHECK_EQ(sf_voxelizer_create(nothing, &lattice, NULL, NULL, &v, &fault), SF_OK);
    uint64_t words[8];
    sf_slice slice = {words, 8, 8, 1}, narrow = {words, 7, 8, 1}, none = {NULL, 8, 8, 1};
    CHECK_EQ(sf_voxelizer_slice(v, 8, slice), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_voxelizer_slice(v, 0, none), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_voxelizer_slice(v, 0, narrow), SF_ERR_SHAPE);
    CHECK_EQ(sf_voxelizer_slice(v, 0, slice), SF_OK);
    CHECK_EQ(sf_slice_popcount(slice), 0);
    sf_voxelizer_destroy(v);
    CHECK_EQ(sf_grid_voxelize(NULL, view, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
}

int main(void)
{
    TEST(allocations_may_fail);
    TEST(creation_may_fail);
    TEST(a_cancel_changes_nothing);
    TEST(a_cancel_is_heard_within_a_slab);
    TEST(pieces_in_any_order);
    TEST(slices_one_at_a_time);
    TEST(refusals);
    return test_finish();
}

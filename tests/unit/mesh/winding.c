// SPDX-License-Identifier: MIT
// Why: an open mesh is voxelised by boxes that know the winding number in them to second order,
// with a bound for the rest; a bound that is too small would be a wrong voxel somewhere, on some
// mesh. Here boxes of every size in a soup, in smooth loops and in a long slit are compared, at
// their voxels, with the sum over all triangles. Guards the design notes, 7.2.

#include "mesh/winding.h"

#include "base/memory.h"
#include "test.h"

#define POINTS 1024
#define SPAN 65536 // 256 voxels

typedef struct scene {
    sfi_point points[POINTS];
    uint32_t corners[POINTS];
    size_t starts[POINTS], count, loops;
    double pitch[3];
} scene;

static scene s;

static void add_point(double x, double y, double z)
{
    s.points[s.count] = (sfi_point){(int32_t)x, (int32_t)y, (int32_t)z};
    s.corners[s.count] = (uint32_t)s.count;
    s.count++;
}

static void add_soup(int triangles)
{
    for (int t = 0; t < triangles; t++) {
        s.starts[s.loops++] = s.count;
        for (int i = 0; i < 3; i++) {
            add_point(SPAN * test_random_unit(), SPAN * test_random_unit(),
                      SPAN * test_random_unit());
        }
    }
}

static void add_rim(double x, double y, double z, double radius, int edges)
{
    s.starts[s.loops++] = s.count;
    for (int i = 0; i < edges; i++) {
        double angle = 6.283185307179586 * i / edges;
        add_point(x + radius * cos(angle), y + radius * sin(angle),
                  z + radius / 4 * sin(2 * angle));
    }
}

static sfi_winding cover(double y_pitch)
{
    sfi_loops loops = {s.corners, s.count, s.starts, s.loops, POINTS};
    sfi_frame frame = {.nx = 256, .ny = 256, .nz = 256, .voxel_mm = {1.0, y_pitch, 0.75}};
    sfi_winding winding;
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    s.starts[s.loops] = s.count;
    CHECK_EQ(sfi_winding_create(&frame, s.points, &loops, &allocator, &winding), SF_OK);
    return winding;
}

static sfi_point corner_of(sfi_point q, int32_t side, int32_t last)
{
    int32_t box = side * 256;
    sfi_point corner = {q.x / box * box + 128 + last * (box - 256),
                        q.y / box * box + 128 + last * (box - 256),
                        q.z / box * box + 128 + last * (box - 256)};
    return corner;
}

// How many boxes around the voxel could say something about it.
static int check_voxel(const sfi_winding *w, sfi_point q)
{
    static sfi_winding_box box[5];
    double exact, rounding, error, at[3];
    int said = 0;
    exact = sfi_winding_estimate(w, s.points, q, 0.0, &rounding);
    for (int level = 0; level < 5; level++) {
        sfi_winding_survey(w, s.points, corner_of(q, 32 >> level, 0), corner_of(q, 32 >> level, 1),
                           level > 0 ? &box[level - 1] : NULL, &box[level]);
        if (!box[level].dense) {
            double value = sfi_winding_in(w, s.points, &box[level], q, &error);
            CHECK_NEAR(value, exact, error);
        }
        if (!box[level].dense && box[level].smooth) {
            sfi_winding_place(w, &q, at);
            for (int i = 0; i < 3; i++) {
                at[i] -= box[level].place[i];
            }
            double turns = sfi_jet_at(&box[level].all, at) - exact;
            turns = box[level].plain ? turns : turns - floor(turns + 0.5);
            CHECK_NEAR(turns, 0.0, sfi_jet_error(&box[level].all, at));
            said++;
        }
    }
    return said;
}

static void check_scene(double y_pitch, int least)
{
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    sfi_winding winding = cover(y_pitch);
    int said = 0;
    for (int n = 0; n < 500; n++) {
        sfi_point q = {(int32_t)test_random_below(256) * 256 + 128,
                       (int32_t)test_random_below(256) * 256 + 128,
                       (int32_t)test_random_below(256) * 256 + 128};
        said += check_voxel(&winding, q);
    }
    printf("# %d of 2500 boxes are smooth\n", said);
    CHECK(said > least);
    sfi_winding_destroy(&winding, &allocator);
}

static void a_soup(void)
{
    s.count = s.loops = 0;
    add_soup(100);
    check_scene(1.0, 800);
}

static void smooth_rims(void)
{
    s.count = s.loops = 0;
    add_rim(32768, 32768, 32768, 20000, 200);
    add_rim(20000, 40000, 50000, 9000, 7);
    add_rim(50000, 40000, 20000, 1000, 30);
    check_scene(1.5, 1900);
}

// Edges much longer than boxes and closer together than voxels.
static void a_long_slit(void)
{
    s.count = s.loops = 0;
    s.starts[s.loops++] = s.count;
    add_point(1000, 30000, 30000);
    add_point(64000, 35000, 31000);
    add_point(64000, 35100, 31000);
    add_point(1000, 30100, 30000);
    add_soup(3);
    check_scene(1.0, 1500);
}

int main(void)
{
    TEST(a_soup);
    TEST(smooth_rims);
    TEST(a_long_slit);
    return test_finish();
}

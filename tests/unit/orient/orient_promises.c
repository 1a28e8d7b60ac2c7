// SPDX-License-Identifier: MIT
// Why: an orientation is the same bytes with any threads (P1), its turn is a rotation that puts
// what it says on the bed, and a call that fails or is cancelled leaves everything as it was (P2).

#include "failing_allocator.h"
#include "solids.h"
#include "test.h"

#include <sf/orient.h>

static shape part;

static sf_orient_options tiny(void)
{
    sf_orient_options options = sf_orient_options_default();
    options.direction_count = 60;
    options.coarse_count = 6;
    options.fine_count = 3;
    options.coarse_resolution = 12;
    options.resolution = 20;
    return options;
}

static void turns_are_rotations(void)
{
    static sf_orientation found[300];
    sf_orient_options options = tiny();
    size_t count;
    options.coarse_count = options.fine_count = 300;
    solid_wedge(&part);
    CHECK_EQ(sf_mesh_orient(shape_view(&part), &options, NULL, NULL, found, 300, &count, NULL),
             SF_OK);
    for (size_t i = 0; i < count; i++) {
        const double *m = found[i].turn.matrix, *up = found[i].up;
        double low = 1e9, high = -1e9, determinant = 0;
        for (int r = 0; r < 3; r++) {
            for (int q = 0; q < 3; q++) {
                double dot =
                    m[3 * r] * m[3 * q] + m[3 * r + 1] * m[3 * q + 1] + m[3 * r + 2] * m[3 * q + 2];
                CHECK_NEAR(dot, r == q, 1e-12);
            }
            CHECK_NEAR(m[3 * r] * up[0] + m[3 * r + 1] * up[1] + m[3 * r + 2] * up[2], r == 2,
                       1e-12);
            determinant += m[r] * (m[3 + (r + 1) % 3] * m[6 + (r + 2) % 3] -
                                   m[3 + (r + 2) % 3] * m[6 + (r + 1) % 3]);
        }
        CHECK_NEAR(determinant, 1, 1e-12);
        for (size_t v = 0; v < part.vertex_count; v++) {
            const double *p = part.vertices + 3 * v;
            double z = m[6] * p[0] + m[7] * p[1] + m[8] * p[2] + found[i].turn.shift_mm[2];
            low = z < low ? z : low;
            high = z > high ? z : high;
        }
        CHECK_NEAR(low, 0, 1e-12);
        CHECK_NEAR(high, found[i].height_mm, 1e-12);
    }
}

// As it is given, a mesh is turned by nothing but the identity.
static void given_is_the_identity(void)
{
    sf_orient_options options = tiny();
    sf_orientation found[3], given;
    size_t count;
    solid_t(&part);
    CHECK_EQ(sf_mesh_orient(shape_view(&part), &options, NULL, NULL, found, 3, &count, &given),
             SF_OK);
    for (int i = 0; i < 9; i++) {
        CHECK(given.turn.matrix[i] == (i % 4 == 0));
    }
}

static void backwards(void *user, size_t count, sf_task_body body, void *context)
{
    *(size_t *)user += count;
    for (size_t i = count; i-- > 0;) {
        body(context, i);
    }
}

static void same_bytes_with_any_threads(void)
{
    sf_orient_options options = tiny();
    static sf_orientation a[3], b[3];
    size_t count, pieces = 0;
    sf_task task = sf_task_default();
    task.parallel_for = backwards;
    task.user = &pieces;
    solid_a(&part);
    memset(a, 0, sizeof a);
    memset(b, 0, sizeof b);
    CHECK_EQ(sf_mesh_orient(shape_view(&part), &options, NULL, NULL, a, 3, &count, NULL), SF_OK);
    CHECK_EQ(sf_mesh_orient(shape_view(&part), &options, NULL, &task, b, 3, &count, NULL), SF_OK);
    CHECK(memcmp(a, b, sizeof a) == 0);
    CHECK(pieces > 0);
}

// Inside out, a part is what it is.
static void inside_out_is_the_same(void)
{
    sf_orient_options options = tiny();
    static sf_orientation a[3], b[3];
    size_t count;
    solid_table(&part);
    CHECK_EQ(sf_mesh_orient(shape_view(&part), &options, NULL, NULL, a, 3, &count, NULL), SF_OK);
    for (size_t i = 0; i < part.triangle_count; i++) {
        uint32_t *t = part.triangles + 3 * i, swap = t[0];
        t[0] = t[1];
        t[1] = swap;
    }
    CHECK_EQ(sf_mesh_orient(shape_view(&part), &options, NULL, NULL, b, 3, &count, NULL), SF_OK);
    CHECK_EQ(a[0].trimmed_voxels, b[0].trimmed_voxels);
    CHECK_NEAR(a[0].unsupported_mm2, b[0].unsupported_mm2, 1e-9);
    CHECK_NEAR(a[0].up[2], b[0].up[2], 1e-12);
}

typedef struct watch {
    int calls, cancel_at;
    double last;
    sf_task *task;
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

static void progress_and_cancel(void)
{
    sf_orient_options options = tiny();
    static sf_orientation found[3], before[3];
    size_t count = 77;
    sf_status status = SF_ERR_CANCELLED;
    int cancel_at = 1;
    solid_t(&part);
    memset(before, 0x5a, sizeof before);
    memcpy(found, before, sizeof before);
    for (; status == SF_ERR_CANCELLED && cancel_at < 50; cancel_at++) {
        sf_task task = sf_task_default();
        watch w = {0, cancel_at, 0, &task};
        CHECK(memcmp(found, before, sizeof before) == 0);
        CHECK_EQ(count, 77);
        task.progress = watching;
        task.user = &w;
        status = sf_mesh_orient(shape_view(&part), &options, NULL, &task, found, 3, &count, NULL);
        CHECK(status != SF_OK || w.last == 1.0);
    }
    CHECK_EQ(status, SF_OK);
    CHECK(cancel_at > 8);
}

static void failing_allocations(void)
{
    sf_orient_options options = tiny();
    static sf_orientation found[3], before[3];
    size_t count = 77;
    failing_allocator f;
    sf_status status = SF_ERR_MEMORY;
    options.coarse_count = 3;
    solid_t(&part);
    memset(before, 0x5a, sizeof before);
    memcpy(found, before, sizeof before);
    for (long k = 0; status == SF_ERR_MEMORY && k < 1000; k++) {
        CHECK(memcmp(found, before, sizeof before) == 0);
        CHECK_EQ(count, 77);
        failing_begin(&f, k);
        status =
            sf_mesh_orient(shape_view(&part), &options, &f.allocator, NULL, found, 3, &count, NULL);
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
    CHECK_EQ(status, SF_OK);
    CHECK(f.requests > 20);
}

static sf_status with(sf_orient_options options)
{
    static sf_orientation found[3];
    size_t count;
    return sf_mesh_orient(shape_view(&part), &options, NULL, NULL, found, 3, &count, NULL);
}

static void bad_arguments(void)
{
    sf_orient_options o = tiny();
    sf_orientation found[3];
    size_t count = 0;
    sf_mesh_view none = {NULL, 0, NULL, 0};
    solid_t(&part);
    CHECK_EQ(sf_mesh_orient(none, &o, NULL, NULL, found, 3, &count, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_orient(shape_view(&part), &o, NULL, NULL, NULL, 3, &count, NULL),
             SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_orient(shape_view(&part), &o, NULL, NULL, found, 3, NULL, NULL),
             SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_orient(shape_view(&part), &o, NULL, NULL, found, 2, &count, NULL),
             SF_ERR_CAPACITY);
    CHECK_EQ(count, 3);
    for (int i = 0; i < 9; i++) {
        sf_orient_options bad = o;
        bad.struct_size = i == 0 ? 8 : bad.struct_size;
        bad.angle_rad = i == 1 ? NAN : i == 2 ? -1 : bad.angle_rad;
        bad.coarse_count = i == 3 ? 0 : bad.coarse_count;
        bad.resolution = i == 4 ? 16385 : bad.resolution;
        bad.weight_height = i == 5 ? NAN : bad.weight_height;
        bad.weight_margin = i == 6 ? -1 : bad.weight_margin;
        bad.rule = i == 7 ? (sf_rule_kind)9 : bad.rule;
        bad.fine_count = i == 8 ? 0 : bad.fine_count;
        CHECK_EQ(with(bad), SF_ERR_ARGUMENT);
    }
    o.rule = SF_RULE_DISK;
    o.angle_rad = 0.2;
    CHECK_EQ(with(o), SF_ERR_UNSUPPORTED);
    // A mesh that is one point.
    solid_clear(&part);
    solid_box(&part, 3, 3, 3, 3, 3, 3);
    CHECK_EQ(with(tiny()), SF_ERR_ARGUMENT);
}

int main(void)
{
    TEST(turns_are_rotations);
    TEST(given_is_the_identity);
    TEST(same_bytes_with_any_threads);
    TEST(inside_out_is_the_same);
    TEST(progress_and_cancel);
    TEST(failing_allocations);
    TEST(bad_arguments);
    return test_finish();
}

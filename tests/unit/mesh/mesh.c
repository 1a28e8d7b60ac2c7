// SPDX-License-Identifier: MIT
// Why: a mesh lets in nothing that is no mesh, so that whoever holds one need not look again (its
// invariant); a view is somebody else's, and its counts must not wrap before they are refused; and
// memory may run out at any request without anything lost (TRUST 85).

#include "failing_allocator.h"
#include "test.h"

#include <sf/mesh.h>

static const double corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
static const uint32_t faces[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

static sf_mesh_view tetrahedron(void)
{
    sf_mesh_view view = {corners, 4, faces, 4};
    return view;
}

// Three times this is 2 or 1, so a loop to three times the count would look at next to nothing.
static void counts_that_wrap_are_refused(void)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    double low[3], high[3];
    sf_mass mass;
    sf_topology topology;
    sf_mesh *merged = NULL;
    sf_mesh_view view = tetrahedron();
    view.triangle_count = SIZE_MAX / 3 + 1;
    CHECK_EQ(sf_mesh_validate(view, &fault), SF_ERR_OVERFLOW);
    CHECK_EQ(fault.status, SF_ERR_OVERFLOW);
    CHECK(strstr(fault.message, "triangles") != NULL);
    CHECK_EQ(sf_mesh_bounds(view, low, high), SF_ERR_OVERFLOW);
    CHECK_EQ(sf_mesh_measure(view, &mass), SF_ERR_OVERFLOW);
    CHECK_EQ(sf_mesh_analyze(view, NULL, &topology), SF_ERR_OVERFLOW);
    CHECK_EQ(sf_mesh_merge(view, NULL, &merged), SF_ERR_OVERFLOW);
    CHECK(merged == NULL);
    view = tetrahedron();
    view.vertex_count = SIZE_MAX / 3 + 1;
    CHECK_EQ(sf_mesh_validate(view, &fault), SF_ERR_OVERFLOW);
}

static void views_that_are_no_mesh_are_refused(void)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    double bad[12];
    uint32_t lost[3] = {0, 1, 4};
    sf_mesh_view view = tetrahedron();
    CHECK_EQ(sf_mesh_validate(view, &fault), SF_OK);
    CHECK_EQ(fault.status, SF_OK);
    memcpy(bad, corners, sizeof bad);
    bad[7] = NAN;
    view.vertices = bad;
    CHECK_EQ(sf_mesh_validate(view, &fault), SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, "vertex 2 ") != NULL);
    view = tetrahedron();
    view.triangles = lost;
    view.triangle_count = 1;
    CHECK_EQ(sf_mesh_validate(view, &fault), SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, "vertex 4,") != NULL);
    view.triangles = NULL;
    CHECK_EQ(sf_mesh_validate(view, NULL), SF_ERR_ARGUMENT);
    view.triangle_count = 0;
    CHECK_EQ(sf_mesh_validate(view, NULL), SF_OK);
}

static void same_as_tetrahedron(const sf_mesh *mesh)
{
    sf_mesh_view view = sf_mesh_get_view(mesh);
    CHECK_EQ(view.vertex_count, 4);
    CHECK_EQ(view.triangle_count, 4);
    CHECK(memcmp(view.vertices, corners, sizeof corners) == 0);
    CHECK(memcmp(view.triangles, faces, sizeof faces) == 0);
}

static void a_mesh_lets_nothing_in_that_is_no_mesh(void)
{
    const double infinite[3] = {0, INFINITY, 0};
    const uint32_t lost[3] = {0, 1, 4};
    sf_mesh *mesh = NULL;
    CHECK_EQ(sf_mesh_create(NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_create(NULL, &mesh), SF_OK);
    CHECK_EQ(sf_mesh_add_vertices(mesh, corners, 4), SF_OK);
    CHECK_EQ(sf_mesh_add_triangles(mesh, faces, 4), SF_OK);
    CHECK_EQ(sf_mesh_add_vertices(mesh, infinite, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_add_vertices(mesh, NULL, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_add_vertices(NULL, corners, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_add_vertices(mesh, corners, SIZE_MAX / 3 + 1), SF_ERR_OVERFLOW);
    CHECK_EQ(sf_mesh_add_triangles(mesh, lost, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_add_triangles(mesh, NULL, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_add_triangles(NULL, faces, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_add_triangles(mesh, faces, SIZE_MAX / 3 + 1), SF_ERR_OVERFLOW);
    CHECK_EQ(sf_mesh_add_vertices(mesh, NULL, 0), SF_OK);
    CHECK_EQ(sf_mesh_add_triangles(mesh, NULL, 0), SF_OK);
    same_as_tetrahedron(mesh);
    sf_mesh_destroy(mesh);
    sf_mesh_destroy(NULL);
    CHECK_EQ(sf_mesh_get_view(NULL).vertex_count, 0);
}

static void memory_runs_out_anywhere(void)
{
    for (long n = 0;; n++) {
        failing_allocator from;
        sf_mesh *mesh = NULL;
        failing_begin(&from, n);
        sf_status status = sf_mesh_create(&from.allocator, &mesh);
        CHECK((status == SF_OK) == (mesh != NULL));
        // One at a time, so that arrays grow while they hold something.
        for (size_t v = 0; v < 30 && status == SF_OK; v++) {
            status = sf_mesh_add_vertices(mesh, corners + 3 * (v % 4), 1);
            CHECK_EQ(sf_mesh_get_view(mesh).vertex_count, v + (status == SF_OK));
        }
        for (size_t t = 0; t < 30 && status == SF_OK; t++) {
            status = sf_mesh_add_triangles(mesh, faces + 3 * (t % 4), 1);
            CHECK_EQ(sf_mesh_get_view(mesh).triangle_count, t + (status == SF_OK));
        }
        if (mesh != NULL) {
            CHECK_EQ(sf_mesh_validate(sf_mesh_get_view(mesh), NULL), SF_OK);
        }
        sf_mesh_destroy(mesh);
        CHECK(from.live == 0 && from.faults == 0);
        if (status == SF_OK) {
            CHECK(n > 4);
            break;
        }
        CHECK_EQ(status, SF_ERR_MEMORY);
    }
}

// The same tetrahedron with corners of its own for every face, as STL has it; and no more requests
// than for what is needed at once, however many vertices there are.
static void merging_takes_memory_once(void)
{
    double apart[36];
    uint32_t numbers[12];
    for (size_t i = 0; i < 12; i++) {
        memcpy(apart + 3 * i, corners + 3 * faces[i], 3 * sizeof *apart);
        numbers[i] = (uint32_t)i;
    }
    sf_mesh_view view = {apart, 12, numbers, 4};
    const uint32_t expected[12] = {0, 1, 2, 0, 2, 3, 0, 3, 1, 2, 1, 3};
    for (long n = 0;; n++) {
        failing_allocator from;
        sf_mesh *merged = NULL;
        failing_begin(&from, n);
        sf_status status = sf_mesh_merge(view, &from.allocator, &merged);
        CHECK(status == SF_OK ? merged != NULL : status == SF_ERR_MEMORY && merged == NULL);
        if (status == SF_OK) {
            sf_mesh_view made = sf_mesh_get_view(merged);
            CHECK(made.vertex_count == 4 && made.triangle_count == 4);
            CHECK(memcmp(made.triangles, expected, sizeof expected) == 0);
            CHECK(memcmp(made.vertices + 3, corners + 6, 3 * sizeof(double)) == 0);
            CHECK_EQ(from.live, 3); // the mesh and its two arrays, which are just as large
            CHECK_EQ(from.requests, 5);
        }
        sf_mesh_destroy(merged);
        CHECK(from.live == 0 && from.faults == 0);
        if (status == SF_OK) {
            break;
        }
    }
    view.vertex_count = view.triangle_count = 0;
    sf_mesh *nothing = NULL;
    CHECK_EQ(sf_mesh_merge(view, NULL, &nothing), SF_OK);
    CHECK_EQ(sf_mesh_get_view(nothing).vertex_count, 0);
    sf_mesh_destroy(nothing);
}

// Many points; and arrays of nothing are not asked for.
static void merging_points_alone(void)
{
    double points[300];
    for (size_t i = 0; i < 300; i++) {
        points[i] = (double)i;
    }
    failing_allocator from;
    failing_begin(&from, -1);
    sf_mesh_view view = {points, 100, NULL, 0};
    sf_mesh *merged = NULL;
    CHECK_EQ(sf_mesh_merge(view, &from.allocator, &merged), SF_OK);
    CHECK_EQ(sf_mesh_get_view(merged).vertex_count, 100);
    CHECK_EQ(sf_mesh_get_view(merged).triangle_count, 0);
    CHECK_EQ(from.requests, 4);
    sf_mesh_destroy(merged);
    CHECK(from.live == 0 && from.faults == 0);
}

int main(void)
{
    TEST(counts_that_wrap_are_refused);
    TEST(views_that_are_no_mesh_are_refused);
    TEST(a_mesh_lets_nothing_in_that_is_no_mesh);
    TEST(merging_takes_memory_once);
    TEST(merging_points_alone);
    TEST(memory_runs_out_anywhere);
    return test_finish();
}

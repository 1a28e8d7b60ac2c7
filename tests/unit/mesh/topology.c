// SPDX-License-Identifier: MIT
// Why: whether a mesh is closed, oriented and in one piece decides how it is filled; the counts
// must be those of a person looking at it, and short memory must leave nothing behind (TRUST B8,
// 85).

#include "failing_allocator.h"
#include "shapes.h"
#include "test.h"

static shape s;

static void start(void)
{
    memset(&s, 0, sizeof s);
}

static const double zero[3] = {0, 0, 0}, one[3] = {1, 1, 1}, two[3] = {2, 2, 2},
                    three[3] = {3, 3, 3};

static sf_topology analyze(void)
{
    sf_topology found;
    memset(&found, 0, sizeof found);
    CHECK_EQ(sf_mesh_analyze(shape_view(&s), NULL, &found), SF_OK);
    return found;
}

static void a_box_is_one_closed_shell(void)
{
    start();
    shape_box(&s, zero, one, 0);
    sf_topology t = analyze();
    CHECK(t.closed && t.oriented && !t.flipped);
    CHECK_EQ(t.vertex_count, 8);
    CHECK_EQ(t.shells, 1);
    CHECK_EQ(t.boundary_edges + t.nonmanifold_edges + t.misoriented_edges, 0);
}

static void a_soup_is_read_by_position(void)
{
    start();
    shape_box(&s, zero, one, 0);
    static shape soup;
    memset(&soup, 0, sizeof soup);
    for (size_t i = 0; i < 3 * s.triangle_count; i++) {
        const double *p = s.vertices + 3 * s.triangles[i];
        shape_vertex(&soup, p[0] == 0 ? -0.0 : p[0], p[1], p[2]);
    }
    for (uint32_t t = 0; t < s.triangle_count; t++) {
        shape_triangle(&soup, 3 * t, 3 * t + 1, 3 * t + 2);
    }
    s = soup;
    sf_topology t = analyze();
    CHECK(t.closed && t.oriented);
    CHECK_EQ(t.vertex_count, 8);
    sf_mesh *merged;
    CHECK_EQ(sf_mesh_merge(shape_view(&s), NULL, &merged), SF_OK);
    CHECK_EQ(sf_mesh_get_view(merged).vertex_count, 8);
    CHECK_EQ(sf_mesh_get_view(merged).triangle_count, 12);
    sf_mesh_destroy(merged);
}

// A box of loose triangles: corners that differ by what rounding leaves are one, corners that
// 32-bit floats tell apart are not.
static void rounding_errors_are_no_holes(void)
{
    static shape box;
    for (int apart = 0; apart < 2; apart++) {
        double noise = apart ? 0x1p-23 : 1e-16;
        memset(&box, 0, sizeof box);
        start();
        shape_box(&box, zero, one, 0);
        for (size_t i = 0; i < 3 * box.triangle_count; i++) {
            const double *p = box.vertices + 3 * (size_t)box.triangles[i];
            double off = i % 2 == 0 ? noise : 0;
            shape_vertex(&s, p[0] - off, p[1], p[2] + off);
        }
        for (uint32_t t = 0; t < box.triangle_count; t++) {
            shape_triangle(&s, 3 * t, 3 * t + 1, 3 * t + 2);
        }
        sf_topology t = analyze();
        CHECK_EQ(t.closed, !apart);
        CHECK(apart ? t.vertex_count > 8 : t.vertex_count == 8);
    }
}

static void a_missing_and_a_turned_face_are_seen(void)
{
    start();
    shape_box(&s, zero, one, 0);
    s.triangle_count--;
    sf_topology t = analyze();
    CHECK(!t.closed);
    CHECK_EQ(t.boundary_edges, 3);
    start();
    shape_box(&s, zero, one, 0);
    uint32_t kept = s.triangles[1];
    s.triangles[1] = s.triangles[2];
    s.triangles[2] = kept;
    t = analyze();
    CHECK(t.closed && !t.oriented);
    CHECK_EQ(t.misoriented_edges, 3);
}

static void inverted_and_touching_boxes_are_told_apart(void)
{
    start();
    shape_box(&s, zero, one, 1);
    sf_topology t = analyze();
    CHECK(t.closed && t.oriented && t.flipped);
    CHECK_EQ(t.flipped_shells, 1);
    start();
    shape_box(&s, zero, one, 0);
    shape_box(&s, one, two, 0); // one point in common
    t = analyze();
    CHECK_EQ(t.shells, 2);
    CHECK_EQ(t.vertex_count, 15);
    start();
    double edge_low[3] = {1, 1, 0}, edge_high[3] = {2, 2, 1};
    shape_box(&s, zero, one, 0);
    shape_box(&s, edge_low, edge_high, 0); // one edge in common
    t = analyze();
    CHECK_EQ(t.nonmanifold_edges, 1);
    CHECK_EQ(t.shells, 1);
    CHECK_EQ(t.boundary_edges, 0);
    CHECK(t.closed && t.oriented);
    start();
    shape_box(&s, zero, three, 0);
    shape_box(&s, one, two, 1); // a cavity
    t = analyze();
    CHECK_EQ(t.shells, 2);
    CHECK_EQ(t.flipped_shells, 1);
    CHECK(!t.flipped);
}

static void short_memory_leaves_nothing_behind(void)
{
    start();
    shape_box(&s, zero, one, 0);
    for (long k = 0;; k++) {
        failing_allocator f;
        failing_begin(&f, k);
        sf_topology t, before;
        memset(&t, 0x5a, sizeof t);
        before = t;
        sf_mesh *merged = NULL;
        sf_status first = sf_mesh_analyze(shape_view(&s), &f.allocator, &t);
        sf_status second = sf_mesh_merge(shape_view(&s), &f.allocator, &merged);
        if (first != SF_OK) {
            CHECK_EQ(first, SF_ERR_MEMORY);
            CHECK(memcmp(&t, &before, sizeof t) == 0);
        }
        if (second != SF_OK) {
            CHECK_EQ(second, SF_ERR_MEMORY);
            CHECK(merged == NULL);
        }
        sf_mesh_destroy(merged);
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
        if (first == SF_OK && second == SF_OK) {
            CHECK(k > 5);
            break;
        }
    }
}

static void wrong_meshes_are_refused(void)
{
    sf_mesh *mesh;
    CHECK_EQ(sf_mesh_create(NULL, &mesh), SF_OK);
    double points[9] = {0, 0, 0, 1, 0, 0, 0, 1, NAN};
    uint32_t corners[3] = {0, 1, 2};
    CHECK_EQ(sf_mesh_add_vertices(mesh, points, 3), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_get_view(mesh).vertex_count, 0);
    points[8] = 0;
    CHECK_EQ(sf_mesh_add_triangles(mesh, corners, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_add_vertices(mesh, points, 3), SF_OK);
    CHECK_EQ(sf_mesh_add_triangles(mesh, corners, 1), SF_OK);
    sf_transform mirror = {{-1, 0, 0, 0, 2, 0, 0, 0, 1}, {5, 0, 0}}, flat = {{0}, {0}};
    CHECK_EQ(sf_mesh_transform(mesh, &flat), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_transform(mesh, &mirror), SF_OK);
    sf_mesh_view view = sf_mesh_get_view(mesh);
    CHECK_NEAR(view.vertices[3], 4, 0);
    CHECK_NEAR(view.vertices[7], 2, 0);
    CHECK_EQ(view.triangles[1], 2); // mirrored, so turned
    sf_mesh_destroy(mesh);
    sf_topology t;
    sf_mesh_view empty = {NULL, 0, NULL, 0};
    CHECK_EQ(sf_mesh_analyze(empty, NULL, &t), SF_ERR_ARGUMENT);
}

int main(void)
{
    TEST(a_box_is_one_closed_shell);
    TEST(a_soup_is_read_by_position);
    TEST(rounding_errors_are_no_holes);
    TEST(a_missing_and_a_turned_face_are_seen);
    TEST(inverted_and_touching_boxes_are_told_apart);
    TEST(short_memory_leaves_nothing_behind);
    TEST(wrong_meshes_are_refused);
    return test_finish();
}

// SPDX-License-Identifier: MIT
// Why: a hollow print is opened along a plane, and each half must be a solid that slices by itself:
// closed, oriented, with caps that have holes where cavities are, and nothing won or lost (TRUST
// B8, 85). Edges are counted here one by one; what a half encloses is judged by solid angles, and
// how much by formula; the meshes are put together by hand or from voxels.

#include "failing_allocator.h"
#include "halves.h"

static solid s;

static void start(void)
{
    memset(&s, 0, sizeof s);
}

static void box(double x0, double y0, double z0, double x1, double y1, double z1, int inside_out)
{
    const double low[3] = {x0, y0, z0}, high[3] = {x1, y1, z1};
    size_t first = s.triangle_count;
    solid_box(&s, low, high);
    if (inside_out) {
        solid_flip(&s, first);
    }
}

static void ball(double x, double y, double z, double radius, int inside_out)
{
    const double centre[3] = {x, y, z};
    size_t first = s.triangle_count;
    solid_sphere(&s, centre, radius, 12, 20, 0);
    if (inside_out) {
        solid_flip(&s, first);
    }
}

static halves cut(int axis, double at)
{
    return cut_view(solid_view(&s), axis, at);
}

// The caps cover an area once, and nothing twice.
static void check_caps(const halves *h, int axis, double at, double area)
{
    for (int i = 0; i < 2; i++) {
        double turned;
        CHECK_NEAR(cap_area(h->view[i], axis, at, i, &turned), area, 1e-9 * (1 + area));
        CHECK_NEAR(turned, 0, 1e-15 * area); // the test rounds
    }
}

static double winding(sf_mesh_view m, const double q[3])
{
    double sum = 0;
    for (size_t t = 0; t < m.triangle_count; t++) {
        const uint32_t *c = m.triangles + 3 * t;
        sum += solid_angle(m.vertices + 3 * (size_t)c[0], m.vertices + 3 * (size_t)c[1],
                           m.vertices + 3 * (size_t)c[2], q);
    }
    return sum / (4 * 3.14159265358979323846);
}

// Random places are as deep inside the half on their side as they were, and outside the other.
static void check_inside(const halves *h, int axis, double at, double low, double high)
{
    for (int i = 0; i < 200; i++) {
        double q[3];
        for (int d = 0; d < 3; d++) {
            q[d] = low + (high - low) * test_random_unit();
        }
        double was = winding(solid_view(&s), q);
        int side = q[axis] > at;
        CHECK_NEAR(winding(h->view[side], q), was, 1e-6);
        CHECK_NEAR(winding(h->view[1 - side], q), 0, 1e-6);
    }
}

// ---------------------------------------------------------------------------------------------
// Shapes by hand
// ---------------------------------------------------------------------------------------------

static void a_box_is_two_boxes(void)
{
    for (int axis = 0; axis < 3; axis++) {
        for (int i = 0; i < 20; i++) {
            double at = 0.01 + 0.98 * test_random_unit();
            start();
            box(0, 0, 0, 1, 1, 1, 0);
            halves h = cut(axis, at);
            check_caps(&h, axis, at, 1);
            CHECK_NEAR(volume(h.view[0]), at, 1e-14);
            CHECK_EQ(h.view[0].triangle_count, 2 * h.view[0].vertex_count - 4);
            end(&h);
        }
    }
}

static void a_hollow_ball_has_rings_for_caps(void)
{
    for (int axis = 0; axis < 3; axis++) {
        const double places[] = {0, 0.1, -0.7, 0.95, 1.4};
        for (size_t i = 0; i < 5; i++) {
            start();
            ball(0, 0, 0, 2, 0);
            ball(0, 0, 0, 1, 1);
            halves h = cut(axis, places[i]);
            double turned, area = cap_area(h.view[0], axis, places[i], 0, &turned);
            check_caps(&h, axis, places[i], area);
            CHECK(area > 0 && area < 4 * 3.15);
            check_inside(&h, axis, places[i], -2.2, 2.2);
            end(&h);
        }
    }
}

static void shells_in_shells_are_islands_in_holes(void)
{
    start();
    box(0, 0, 0, 9, 9, 9, 0);
    box(1, 1, 1, 8, 8, 8, 1);
    box(2, 2, 2, 7, 4, 7, 0);
    box(2.5, 2.5, 2.5, 3.5, 3.5, 6, 1);
    box(5, 2.25, 2.5, 6, 3.75, 6, 1);
    box(3, 5, 3, 6, 7, 4, 0); // the plane passes above
    halves h = cut(2, 4.5);
    check_caps(&h, 2, 4.5, 81 - 49 + 10 - 1 - 1.5);
    check_inside(&h, 2, 4.5, -0.5, 9.5);
    end(&h);
    h = cut(0, 4.5);
    check_caps(&h, 0, 4.5, 81 - 49 + 2 * 5 + 2 * 1);
    end(&h);
}

static void several_bodies_may_lie_on_either_side(void)
{
    start();
    box(0, 0, 0, 1, 1, 1, 0);
    box(0, 0, 2, 1, 1, 3, 0);
    halves h = cut(2, 1.5); // nothing is crossed
    CHECK_EQ(h.view[0].triangle_count, 12);
    CHECK_EQ(h.view[1].triangle_count, 12);
    end(&h);
    h = cut(2, 0.5);
    CHECK_NEAR(volume(h.view[1]), 1.5, 1e-14);
    end(&h);
    h = cut(2, 1); // touches a face, and there are bodies on both sides
    CHECK_NEAR(volume(h.view[0]), 1, 1e-14);
    end(&h);
}

static void vertices_and_edges_may_lie_in_the_plane(void)
{
    static const double tips[6][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                      {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    static const uint32_t faces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                         {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    start();
    for (int i = 0; i < 6; i++) {
        solid_vertex(&s, tips[i][0], tips[i][1], tips[i][2]);
    }
    for (int i = 0; i < 8; i++) {
        solid_triangle(&s, faces[i][0], faces[i][1], faces[i][2]);
    }
    for (int axis = 0; axis < 3; axis++) {
        halves h = cut(axis, 0); // four edges in the plane, and no triangle crosses it
        check_caps(&h, axis, 0, 2);
        CHECK_EQ(h.view[0].vertex_count, 5);
        CHECK_EQ(h.view[0].triangle_count, 6);
        end(&h);
    }
    for (int i = 0; i < 6; i++) { // two corners in the plane, and two edges that cross it
        double *p = s.vertices + 3 * i, x = p[0], y = p[1];
        p[0] = x - y;
        p[1] = x + y;
    }
    s.vertices[0] = 1.5;
    halves h = cut(0, 0);
    end(&h);
    h = cut(2, 1e-13); // within the grain: on the plane
    CHECK_NEAR(h.view[0].vertices[2], 1e-13, 1e-30);
    CHECK_EQ(h.view[0].triangle_count, 6);
    end(&h);
}

// A square pyramid whose tip touches the plane from below beside a body that crosses it.
static void what_only_touches_stays_whole(void)
{
    start();
    box(5, 0, 0, 6, 1, 2, 0);
    uint32_t v = solid_vertex(&s, 0, 0, 0);
    solid_vertex(&s, 1, 0, 0);
    solid_vertex(&s, 0, 1, 0);
    solid_vertex(&s, 0, 0, 1);
    solid_triangle(&s, v, v + 2, v + 1);
    solid_triangle(&s, v, v + 1, v + 3);
    solid_triangle(&s, v + 1, v + 2, v + 3);
    solid_triangle(&s, v + 2, v, v + 3);
    halves h = cut(2, 1);
    check_caps(&h, 2, 1, 1);
    CHECK_NEAR(volume(h.view[0]), 1 + 1.0 / 6, 1e-14);
    end(&h);
}

static void what_is_inside_out_stays_so(void)
{
    start();
    ball(0, 0, 0, 2, 1);
    ball(0, 0, 0, 1, 0);
    halves h = cut(2, 0.3);
    check_inside(&h, 2, 0.3, -2.2, 2.2);
    for (int i = 0; i < 2; i++) {
        double turned, area = cap_area(h.view[i], 2, 0.3, i, &turned);
        CHECK(area < 0);
        CHECK_NEAR(turned, -area, 1e-14);
    }
    end(&h);
}

// Bodies that run through each other: contours cross in the plane, and caps lie over each other,
// with a hole for the cavity.
static void overlapping_bodies_stay_closed(void)
{
    double turned;
    start();
    ball(0, 0, 0, 2, 0);
    ball(2.5, 0.3, 0.2, 1.5, 0);
    ball(0, 0, 0, 1, 1);
    box(-0.4, -5, -0.3, 0.3, 5, 0.6, 0);
    for (int axis = 0; axis < 3; axis++) {
        halves h = cut(axis, 0.17);
        check_inside(&h, axis, 0.17, -3, 4.5);
        check_caps(&h, axis, 0.17, cap_area(h.view[0], axis, 0.17, 0, &turned));
        end(&h);
    }
}

// ---------------------------------------------------------------------------------------------
// Voxels
// ---------------------------------------------------------------------------------------------

enum { SIDE = 9 };

static sf_grid *random_grid(uint32_t fill)
{
    sf_lattice lattice = {SIDE, SIDE, SIDE, 0.7, 0.7, 0.7, NULL, {-3, 1, 0.1}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    for (uint32_t i = 0; i < SIDE * SIDE * SIDE; i++) {
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, i / SIDE / SIDE), i % SIDE, i / SIDE % SIDE,
                              test_random_below(100) < fill),
                 SF_OK);
    }
    return grid;
}

// Rooms and corridors at random, cut between voxels, where whole faces lie in the plane, and
// through them.
static void voxels_are_cut_anywhere(void)
{
    static const uint32_t fills[] = {10, 30, 50, 70, 95};
    for (int round = 0; round < 150; round++) {
        sf_surface_options how = sf_surface_options_default();
        sf_grid *grid = random_grid(fills[round % 5]);
        sf_mesh *mesh = NULL;
        how.smooth_passes = round % 3 == 2 ? 3 : 0;
        CHECK_EQ(sf_grid_surface(grid, &how, NULL, NULL, &mesh), SF_OK);
        int axis = round % 3;
        sf_lattice l = sf_grid_lattice(grid);
        double at = l.origin_mm[axis] + 0.7 * (1 + test_random_below(2 * SIDE - 3) * 0.5);
        halves h = cut_view(sf_mesh_get_view(mesh), axis, at);
        double low, high;
        double a = cap_area(h.view[0], axis, at, 0, &low);
        double b = cap_area(h.view[1], axis, at, 1, &high);
        CHECK(a > 0 || b > 0 || how.smooth_passes > 0); // smooth crumbs may lie beside it
        CHECK_NEAR(low + high, 0, 1e-15 * (a + b));
        end(&h);
        sf_mesh_destroy(mesh);
        sf_grid_destroy(grid);
    }
}

// ---------------------------------------------------------------------------------------------
// Promises
// ---------------------------------------------------------------------------------------------

static void any_size_is_cut(void)
{
    const double sizes[] = {1e-250, 1e-30, 1e-6, 1e11, 1e12};
    for (size_t i = 0; i < 5; i++) {
        start();
        ball(0, 0, 0, 1, 0);
        ball(0, 0, 0, 0.5, 1);
        for (size_t v = 0; v < 3 * s.vertex_count; v++) {
            s.vertices[v] *= sizes[i];
        }
        sf_mesh *mesh[2] = {NULL, NULL};
        CHECK_EQ(sf_mesh_cut(solid_view(&s), 1, 0.1 * sizes[i], NULL, &mesh[0], &mesh[1], NULL),
                 SF_OK);
        for (int side = 0; side < 2 && mesh[side] != NULL; side++) {
            check_half(sf_mesh_get_view(mesh[side]), 1, 0.1 * sizes[i], side);
            sf_mesh_destroy(mesh[side]);
        }
    }
    s.vertices[0] = 2e12;
    sf_mesh *low = NULL, *high = NULL;
    CHECK_EQ(sf_mesh_cut(solid_view(&s), 1, 1, NULL, &low, &high, NULL), SF_ERR_OVERFLOW);
    CHECK(low == NULL && high == NULL);
}

static void what_cannot_be_cut_is_refused(void)
{
    sf_mesh *low = NULL, *high = NULL;
    start();
    box(0, 0, 0, 1, 1, 1, 0);
    sf_mesh_view m = solid_view(&s), none = {NULL, 0, NULL, 0};
    const double beside[] = {-1, 0, 1, 2};
    for (int i = 0; i < 12; i++) {
        CHECK_EQ(sf_mesh_cut(m, i % 3, beside[i / 3], NULL, &low, &high, NULL), SF_ERR_INFEASIBLE);
    }
    sf_fault fault = {SF_OK, 0, 0, ""};
    s.vertices[0] = -0.5; // one corner of the box, along x
    CHECK_EQ(sf_mesh_cut(m, 0, 3, NULL, &low, &high, &fault), SF_ERR_INFEASIBLE);
    CHECK_EQ(fault.status, SF_ERR_INFEASIBLE);
    CHECK(strcmp(fault.message, "The plane x = 3 mm leaves nothing on one side: the mesh goes from "
                                "-0.5 to 1 mm along x.") == 0);
    s.vertices[0] = 0;
    CHECK_EQ(sf_mesh_cut(none, 0, 0.5, NULL, &low, &high, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_cut(m, -1, 0.5, NULL, &low, &high, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_cut(m, 3, 0.5, NULL, &low, &high, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_cut(m, 0, NAN, NULL, &low, &high, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_cut(m, 0, INFINITY, NULL, &low, &high, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_cut(m, 0, 0.5, NULL, NULL, &high, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_cut(m, 0, 0.5, NULL, &low, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_cut(m, 0, 0.5, NULL, &low, &low, NULL), SF_ERR_ARGUMENT);
    m.triangle_count--;
    CHECK_EQ(sf_mesh_cut(m, 0, 0.5, NULL, &low, &high, &fault), SF_ERR_UNSUPPORTED);
    CHECK(strcmp(fault.message, "The mesh is open: 3 edges have one triangle only.") == 0);
    m.triangle_count++;
    uint32_t kept = s.triangles[0];
    s.triangles[0] = s.triangles[1];
    s.triangles[1] = kept;
    CHECK_EQ(sf_mesh_cut(m, 0, 0.5, NULL, &low, &high, NULL), SF_ERR_UNSUPPORTED);
    CHECK(low == NULL && high == NULL);
}

static int same(sf_mesh_view a, sf_mesh_view b)
{
    return a.vertex_count == b.vertex_count && a.triangle_count == b.triangle_count &&
           memcmp(a.vertices, b.vertices, 3 * a.vertex_count * sizeof(double)) == 0 &&
           memcmp(a.triangles, b.triangles, 3 * a.triangle_count * sizeof(uint32_t)) == 0;
}

// An indexed mesh and the same as loose triangles give the same halves.
static void loose_triangles_are_cut_alike(void)
{
    static double loose[9 * SOLID_TRIANGLES];
    static uint32_t numbers[3 * SOLID_TRIANGLES];
    start();
    ball(0, 0, 0, 2, 0);
    ball(0.1, 0, 0, 1.2, 1);
    for (size_t i = 0; i < 3 * s.triangle_count; i++) {
        memcpy(loose + 3 * i, s.vertices + 3 * (size_t)s.triangles[i], 3 * sizeof(double));
        numbers[i] = (uint32_t)i;
    }
    sf_mesh_view soup = {loose, 3 * s.triangle_count, numbers, s.triangle_count};
    halves h = cut_view(soup, 1, 0.25), again = cut_view(soup, 1, 0.25), other = cut(1, 0.25);
    for (int i = 0; i < 2; i++) {
        CHECK(same(h.view[i], again.view[i]));
        CHECK_EQ(h.view[i].triangle_count, other.view[i].triangle_count);
        CHECK_NEAR(volume(h.view[i]), volume(other.view[i]), 1e-13);
    }
    end(&h);
    end(&again);
    end(&other);
}

static void short_memory_leaves_nothing_behind(void)
{
    start(); // filled together, and tour by tour
    ball(0, 0, 0, 2, 0);
    ball(0, 0, 0, 1, 1);
    ball(1.5, 0, 0, 1, 0);
    sf_status status = SF_ERR_MEMORY;
    long k = 0;
    for (; status != SF_OK && k < 500; k++) {
        failing_allocator f;
        sf_mesh *low = NULL, *high = NULL;
        failing_begin(&f, k);
        status = sf_mesh_cut(solid_view(&s), 2, 0.1, &f.allocator, &low, &high, NULL);
        if (status != SF_OK) {
            CHECK_EQ(status, SF_ERR_MEMORY);
            CHECK(low == NULL && high == NULL);
        }
        sf_mesh_destroy(low);
        sf_mesh_destroy(high);
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
    CHECK(k > 40 && k < 500);
}

int main(void)
{
    TEST(a_box_is_two_boxes);
    TEST(a_hollow_ball_has_rings_for_caps);
    TEST(shells_in_shells_are_islands_in_holes);
    TEST(several_bodies_may_lie_on_either_side);
    TEST(vertices_and_edges_may_lie_in_the_plane);
    TEST(what_only_touches_stays_whole);
    TEST(what_is_inside_out_stays_so);
    TEST(overlapping_bodies_stay_closed);
    TEST(voxels_are_cut_anywhere);
    TEST(any_size_is_cut);
    TEST(what_cannot_be_cut_is_refused);
    TEST(loose_triangles_are_cut_alike);
    TEST(short_memory_leaves_nothing_behind);
    return test_finish();
}

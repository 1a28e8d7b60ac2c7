// SPDX-License-Identifier: MIT
// Why: people begin with these shapes, and nothing can be made of a cage that is inside out.
// Volumes are held against formulas (of turned faces Pappus's, with the polygon that a circle
// becomes), counts against Euler's, random trees of struts against having no inverted cell.
// Promises: every builder says what it cannot build; functions of places are called for each, and
// what gives up changes nothing.

#include "cages.h"
#include "failing_allocator.h"

#include <sf/cage_build.h>

static const double PI = 3.14159265358979323846;

static sf_cage_report report_of(const sf_cage *cage)
{
    sf_cage_report report = {0};
    CHECK(cage != NULL);
    if (cage != NULL) {
        sf_fault fault = {0};
        CHECK_EQ(sf_cage_check(cage, NULL, &report, &fault), SF_OK);
        if (report.inverted_cells > 0) {
            printf("# %s\n", fault.message);
        }
        CHECK_EQ(report.inverted_cells, 0);
    }
    return report;
}

static void blocks_are_boxes(void)
{
    const uint32_t counts[3] = {4, 3, 2};
    const double low[3] = {-1, 0, 5}, high[3] = {1, 1.5, 6};
    sf_cage *cage = NULL;
    CHECK_EQ(sf_cage_block(counts, low, high, NULL, &cage), SF_OK);
    sf_cage_report r = report_of(cage);
    sf_cage_view v = sf_cage_get_view(cage);
    CHECK(v.point_count == 60 && v.cell_count == 24);
    CHECK_NEAR(r.volume_mm3, 3, 1e-14);
    CHECK(v.positions[3 * 59] == 1 && v.positions[3 * 59 + 2] == 6);
    sf_cage_destroy(cage);
    const uint32_t none[3] = {1, 0, 1}, many[3] = {4096, 4096, 4096};
    CHECK_EQ(sf_cage_block(none, low, high, NULL, &cage), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_cage_block(counts, high, low, NULL, &cage), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_cage_block(many, low, high, NULL, &cage), SF_ERR_OVERFLOW);
}

// A triangle and a quadrilateral and a pentagon side by side, in the plane of x and `up`, from x0
// on; area 1/2 + 1 + 5/4.
static sf_cage *faces(double x0, int up, int reversed)
{
    static const double xy[8][2] = {{0, 0}, {1, 0}, {1, 1},     {2, 0},
                                    {2, 1}, {3, 0}, {3.5, 0.5}, {3, 1}};
    static const uint32_t loops[12] = {0, 1, 2, 1, 3, 4, 2, 3, 5, 6, 7, 4};
    static const uint32_t starts[4] = {0, 3, 7, 12};
    double positions[24] = {0};
    uint32_t corners[12];
    for (int i = 0; i < 8; i++) {
        positions[3 * i] = x0 + xy[i][0];
        positions[3 * i + up] = xy[i][1];
    }
    for (int f = 0; f < 3; f++) {
        for (uint32_t i = starts[f]; i < starts[f + 1]; i++) {
            corners[i] = loops[reversed ? starts[f] + starts[f + 1] - 1 - i : i];
        }
    }
    sf_cage_view view = {2, 8, positions, 3, starts, corners, 0, NULL, 0, NULL, 0, NULL};
    sf_cage *cage = NULL;
    CHECK_EQ(sf_cage_create(&view, NULL, &cage, NULL), SF_OK);
    return cage;
}

static void faces_are_drawn_along_a_line(void)
{
    for (int reversed = 0; reversed < 2; reversed++) {
        sf_cage *flat = faces(0, 1, reversed), *cage = NULL;
        const double up[3] = {0.5, 0, 3}, down[3] = {0, 1, -2}, along[3] = {1, 1, 0};
        sf_fault fault = {0};
        CHECK_EQ(sf_cage_extrude(flat, up, 4, NULL, &cage, NULL), SF_OK);
        CHECK_NEAR(report_of(cage).volume_mm3, 2.75 * 3, 1e-13);
        CHECK_EQ(sf_cage_get_view(cage).cell_count, 12);
        sf_cage_destroy(cage);
        CHECK_EQ(sf_cage_extrude(flat, down, 1, NULL, &cage, NULL), SF_OK);
        CHECK_NEAR(report_of(cage).volume_mm3, 2.75 * 2, 1e-13);
        CHECK_EQ(sf_cage_extrude(cage, up, 1, NULL, &cage, &fault), SF_ERR_UNSUPPORTED);
        sf_cage_destroy(cage);
        cage = NULL;
        CHECK_EQ(sf_cage_extrude(flat, along, 1, NULL, &cage, &fault), SF_ERR_ARGUMENT);
        CHECK(strstr(fault.message, "face 0 lies along the vector") != NULL);
        CHECK_EQ(sf_cage_extrude(flat, up, 0, NULL, &cage, NULL), SF_ERR_ARGUMENT);
        sf_cage_destroy(flat);
    }
}

// A square of two random edges from the origin, and a vector within it.
static sf_cage *tilted(double vector[3])
{
    static const uint32_t starts[2] = {0, 4}, corners[4] = {0, 1, 2, 3};
    double p[12] = {0};
    for (int i = 0; i < 3; i++) {
        p[3 + i] = test_random_unit() - 0.5;
        p[9 + i] = test_random_unit() - 0.5;
        p[6 + i] = p[3 + i] + p[9 + i];
    }
    double a = test_random_unit(), b = test_random_unit();
    for (int i = 0; i < 3; i++) {
        vector[i] = a * p[3 + i] + b * p[9 + i];
    }
    sf_cage_view view = {2, 4, p, 1, starts, corners, 0, NULL, 0, NULL, 0, NULL};
    sf_cage *cage = NULL;
    CHECK_EQ(sf_cage_create(&view, NULL, &cage, NULL), SF_OK);
    return cage;
}

static void faces_lead_to_one_side_of_the_line(void)
{
    sf_fault fault = {0};
    sf_cage *cage = NULL;
    for (int i = 0; i < 1000; i++) { // rounding takes none of these vectors out of its plane
        double along[3];
        sf_cage *flat = tilted(along);
        CHECK_EQ(sf_cage_extrude(flat, along, 1, NULL, &cage, &fault), SF_ERR_ARGUMENT);
        sf_cage_destroy(flat);
    }
    // The second face folds back below the first.
    static const double p[18] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0, -1, 0.5, 1, -1};
    static const uint32_t starts[3] = {0, 4, 8}, corners[8] = {0, 1, 2, 3, 1, 4, 5, 2};
    const double up[3] = {0, 0, 1}, far[3] = {0, 0, 1e200};
    sf_cage_view view = {2, 6, p, 2, starts, corners, 0, NULL, 0, NULL, 0, NULL};
    sf_cage *folded = NULL;
    CHECK_EQ(sf_cage_create(&view, NULL, &folded, NULL), SF_OK);
    CHECK_EQ(sf_cage_extrude(folded, up, 1, NULL, &cage, &fault), SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, "face 1 looks the other way than face 0") != NULL);
    CHECK_EQ(sf_cage_extrude(folded, far, 1, NULL, &cage, NULL), SF_ERR_ARGUMENT);
    CHECK(cage == NULL);
    sf_cage_destroy(folded);
}

// Pappus: area times the way of the centroid; of n sectors sin(2 pi / n) n / 2 instead of pi.
static double pappus(double moment, uint32_t sectors, double angle)
{
    return moment * sectors * sin(angle / sectors);
}

static void faces_are_turned_about_an_axis(void)
{
    static const double angles[3] = {2 * 3.14159265358979323846, 1, 3};
    // x dA of the triangle, the quadrilateral and the pentagon (a square and a triangle of 1/4).
    const double moment = 0.5 * (2.0 / 3) + 1.5 + (2.5 + 0.25 * (3 + 0.5 / 3)), area = 2.75;
    for (int reversed = 0; reversed < 2; reversed++) {
        sf_cage *flat = faces(2, 2, reversed), *cage = NULL;
        for (int i = 0; i < 3; i++) {
            for (uint32_t sectors = 3; sectors < 9; sectors++) {
                CHECK_EQ(sf_cage_revolve(flat, sectors, angles[i], NULL, &cage, NULL), SF_OK);
                sf_cage_report r = report_of(cage);
                CHECK_NEAR(r.volume_mm3, pappus(moment + 2 * area, sectors, angles[i]), 1e-12);
                CHECK_EQ(sf_cage_get_view(cage).point_count, 8 * (i == 0 ? sectors : sectors + 1));
                CHECK_EQ(r.components, 1);
                sf_cage_destroy(cage);
            }
        }
        sf_cage_destroy(flat);
    }
}

// A square with an edge on the axis, and a triangle on top of it with one: a cylinder with a cone.
static void edges_on_the_axis_become_wedges_and_tetrahedra(void)
{
    static const double positions[15] = {0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 3};
    static const uint32_t starts[3] = {0, 4, 7}, corners[7] = {0, 1, 2, 3, 3, 2, 4};
    static const uint32_t turned[7] = {3, 2, 1, 0, 4, 2, 3};
    for (int reversed = 0; reversed < 2; reversed++) {
        sf_cage_view view = {2, 5,    positions, 2,    starts, reversed ? turned : corners,
                             0, NULL, 0,         NULL, 0,      NULL};
        sf_cage *flat = NULL, *cage = NULL;
        sf_fault fault = {0};
        CHECK_EQ(sf_cage_create(&view, NULL, &flat, NULL), SF_OK);
        CHECK_EQ(sf_cage_revolve(flat, 7, 2 * PI, NULL, &cage, &fault), SF_OK);
        CHECK_NEAR(report_of(cage).volume_mm3, pappus(0.5 + 2.0 / 6, 7, 2 * PI), 1e-13);
        CHECK_EQ(sf_cage_get_view(cage).point_count, 3 + 2 * 7);
        sf_cage_destroy(cage);
        CHECK_EQ(sf_cage_revolve(flat, 2, 2 * PI, NULL, &cage, &fault), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_cage_revolve(flat, 5, 7, NULL, &cage, &fault), SF_ERR_ARGUMENT);
        sf_cage_destroy(flat);
    }
    static const uint32_t tip[3] = {4, 2, 1}, one[2] = {0, 3}; // one corner on the axis
    sf_cage_view view = {2, 5, positions, 1, one, tip, 0, NULL, 0, NULL, 0, NULL};
    sf_cage *flat = NULL, *cage = NULL;
    sf_fault fault = {0};
    CHECK_EQ(sf_cage_create(&view, NULL, &flat, NULL), SF_OK);
    CHECK_EQ(sf_cage_revolve(flat, 5, 2 * PI, NULL, &cage, &fault), SF_ERR_UNSUPPORTED);
    CHECK(strstr(fault.message, "face 0 touches the axis") != NULL);
    sf_cage_destroy(flat);
    flat = faces(-1, 2, 0);
    CHECK_EQ(sf_cage_revolve(flat, 5, 2 * PI, NULL, &cage, &fault), SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, "beyond the axis") != NULL);
    sf_cage_destroy(flat);
}

// A tree whose nodes lie on a jittered grid, each connected to one before it.
static void random_trees_have_no_inverted_cells(void)
{
    int built = 0;
    for (int round = 0; round < 100; round++) {
        sf_skeleton_node nodes[12];
        sf_skeleton_strut struts[11];
        size_t count = 2 + test_random_below(11);
        int steps[12][3] = {{0}};
        for (size_t i = 0; i < count; i++) {
            nodes[i].half_side_mm = 0.3 + 0.4 * test_random_unit();
            if (i > 0) {
                size_t from = test_random_below((uint32_t)i);
                uint32_t axis = test_random_below(3);
                memcpy(steps[i], steps[from], sizeof steps[i]);
                steps[i][axis] += test_random_below(2) ? 1 : -1;
                struts[i - 1].nodes[0] = (uint32_t)from;
                struts[i - 1].nodes[1] = (uint32_t)i;
                struts[i - 1].cells = 1 + test_random_below(4);
            }
            for (int axis = 0; axis < 3; axis++) {
                nodes[i].at_mm[axis] = 4 * steps[i][axis] + 1.2 * (test_random_unit() - 0.5);
            }
        }
        sf_cage *cage = NULL;
        sf_fault fault = {0};
        sf_status status = sf_cage_skeleton(count, nodes, count - 1, struts, NULL, &cage, &fault);
        if (status == SF_ERR_UNSUPPORTED) { // two struts through one side: said so
            CHECK(strstr(fault.message, "through the side") != NULL && cage == NULL);
            continue;
        }
        CHECK_EQ(status, SF_OK);
        sf_cage_report r = report_of(cage);
        CHECK_EQ(r.components, 1);
        CHECK_EQ(r.boundary_points - 2 * r.boundary_faces + r.boundary_faces, 2); // a ball
        sf_cage_destroy(cage);
        built++;
    }
    printf("# %d trees of 100 could be built\n", built);
    CHECK(built > 20);
}

static void skeletons_that_cannot_be_are_refused(void)
{
    sf_skeleton_node nodes[3] = {{{0, 0, 0}, 1}, {{5, 0, 0}, 1}, {{5, 1, 3}, 1}};
    sf_skeleton_strut struts[2] = {{{0, 1}, 2}, {{0, 2}, 2}};
    sf_cage *cage = NULL;
    sf_fault fault = {0};
    CHECK_EQ(sf_cage_skeleton(3, nodes, 2, struts, NULL, &cage, &fault), SF_ERR_UNSUPPORTED);
    CHECK(strstr(fault.message, "strut 1 leaves node 0") != NULL);
    struts[1].nodes[0] = 2;
    CHECK_EQ(sf_cage_skeleton(3, nodes, 2, struts, NULL, &cage, &fault), SF_ERR_ARGUMENT);
    struts[1].nodes[0] = 3;
    CHECK_EQ(sf_cage_skeleton(3, nodes, 2, struts, NULL, &cage, &fault), SF_ERR_ARGUMENT);
    nodes[1].at_mm[0] = 1.5;
    CHECK_EQ(sf_cage_skeleton(2, nodes, 1, struts, NULL, &cage, &fault), SF_ERR_UNSUPPORTED);
    CHECK(strstr(fault.message, "shorter") != NULL);
    nodes[1].half_side_mm = 0;
    CHECK_EQ(sf_cage_skeleton(2, nodes, 1, struts, NULL, &cage, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_cage_skeleton(0, nodes, 0, NULL, NULL, &cage, &fault), SF_ERR_ARGUMENT);
    CHECK(cage == NULL);
    nodes[1].at_mm[0] = 5;
    nodes[1].half_side_mm = 1;
    for (long k = 0;; k++) {
        failing_allocator memory;
        failing_begin(&memory, k);
        sf_status status = sf_cage_skeleton(2, nodes, 1, struts, &memory.allocator, &cage, NULL);
        sf_cage_destroy(cage);
        cage = NULL;
        CHECK(memory.live == 0 && memory.faults == 0);
        if (status == SF_OK) {
            break;
        }
        CHECK_EQ(status, SF_ERR_MEMORY);
    }
}

static int swell(void *user, const double at[3], double moved[3])
{
    int *calls = user;
    for (int axis = 0; axis < 3; axis++) {
        moved[axis] = 2 * at[axis];
    }
    return --*calls != 0;
}

static int sum_up(void *user, const double at[3], double *value)
{
    int *calls = user;
    *value = at[0] + at[1] + at[2];
    return --*calls != 0;
}

static void functions_of_places_are_called_for_each(void)
{
    test_cage c = test_cage_block(2, 2, 1);
    c.values = calloc(c.points, sizeof *c.values);
    sf_cage *cage = test_cage_make(&c);
    int calls = 5, never = -1;
    CHECK_EQ(sf_cage_map_positions(cage, swell, &calls, NULL), SF_ERR_CANCELLED);
    CHECK(memcmp(sf_cage_get_view(cage).positions, c.positions, 3 * c.points * sizeof(double)) ==
          0);
    CHECK_EQ(sf_cage_map_positions(cage, swell, &never, NULL), SF_OK);
    CHECK_EQ(never, -1 - (int)c.points);
    CHECK_NEAR(report_of(cage).volume_mm3, 32, 1e-13);
    calls = 3;
    CHECK_EQ(sf_cage_map_values(cage, 0, sum_up, &calls, NULL), SF_ERR_CANCELLED);
    CHECK(sf_cage_get_view(cage).channels[0].values[1] == 0);
    CHECK_EQ(sf_cage_map_values(cage, 0, sum_up, &never, NULL), SF_OK);
    for (size_t i = 0; i < c.points; i++) {
        const double *p = sf_cage_get_view(cage).positions + 3 * i;
        CHECK(sf_cage_get_view(cage).channels[0].values[i] == p[0] + p[1] + p[2]);
    }
    CHECK_EQ(sf_cage_map_values(cage, 1, sum_up, &never, NULL), SF_ERR_ARGUMENT);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

static int twice(void *user, const double at[3], double *value)
{
    (void)user;
    (void)at;
    *value *= 2;
    return 1;
}

// A value that eight corners name is what it was for each of them, not what the last made of it.
static void functions_find_values_as_they_were(void)
{
    test_cage c = test_cage_block(2, 2, 2);
    c.value_count = 2;
    c.values = calloc(2, sizeof *c.values);
    c.indices = calloc(64, sizeof *c.indices);
    c.values[0] = 3;
    c.values[1] = 5;
    c.indices[7] = 1;
    sf_cage *cage = test_cage_make(&c);
    CHECK_EQ(sf_cage_map_values(cage, 0, twice, NULL, NULL), SF_OK);
    CHECK(sf_cage_get_view(cage).channels[0].values[0] == 6);
    CHECK(sf_cage_get_view(cage).channels[0].values[1] == 10);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

// What needs memory, one after the other; what is changed in place is `cage`.
static sf_status build(int way, sf_cage *cage, sf_cage *flat, const sf_allocator *allocator,
                       sf_cage **made)
{
    const uint32_t counts[3] = {3, 2, 2};
    const double low[3] = {0, 0, 0}, high[3] = {1, 1, 1}, up[3] = {0, 1, 0};
    int calls = 1000;
    switch (way) {
    case 0:
        return sf_cage_block(counts, low, high, allocator, made);
    case 1:
        return sf_cage_extrude(flat, up, 3, allocator, made, NULL);
    case 2:
        return sf_cage_revolve(flat, 5, 3, allocator, made, NULL);
    case 3:
        return sf_cage_map_positions(cage, swell, &calls, allocator);
    default:
        return sf_cage_map_values(cage, 0, twice, NULL, allocator);
    }
}

static void without_memory_nothing_is_built_or_changed(void)
{
    test_cage c = test_cage_block(3, 2, 2);
    c.values = calloc(c.points, sizeof *c.values);
    c.values[3] = 7;
    sf_cage *cage = test_cage_make(&c), *flat = faces(2, 2, 0);
    for (int way = 0; way < 5; way++) {
        sf_status status = SF_ERR_MEMORY;
        for (long k = 0; status == SF_ERR_MEMORY; k++) {
            failing_allocator memory;
            sf_cage *made = NULL;
            sf_cage_view v = sf_cage_get_view(cage);
            CHECK(memcmp(v.positions, c.positions, 3 * c.points * sizeof(double)) == 0);
            CHECK(memcmp(v.channels[0].values, c.values, c.points * sizeof(double)) == 0);
            failing_begin(&memory, k);
            status = build(way, cage, flat, &memory.allocator, &made);
            CHECK((status == SF_OK && (way > 2 || made != NULL)) || made == NULL);
            CHECK(status == SF_OK ? k > 0 : status == SF_ERR_MEMORY);
            sf_cage_destroy(made);
            CHECK(memory.live == 0 && memory.faults == 0);
        }
        if (way == 3) {
            CHECK_EQ(sf_cage_set_positions(cage, 0, c.points, c.positions), SF_OK);
        }
    }
    sf_cage_destroy(flat);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

int main(void)
{
    TEST(without_memory_nothing_is_built_or_changed);
    TEST(faces_lead_to_one_side_of_the_line);
    TEST(functions_find_values_as_they_were);
    TEST(blocks_are_boxes);
    TEST(faces_are_drawn_along_a_line);
    TEST(faces_are_turned_about_an_axis);
    TEST(edges_on_the_axis_become_wedges_and_tetrahedra);
    TEST(random_trees_have_no_inverted_cells);
    TEST(skeletons_that_cannot_be_are_refused);
    TEST(functions_of_places_are_called_for_each);
    return test_finish();
}

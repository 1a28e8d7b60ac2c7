// SPDX-License-Identifier: MIT
// Why: all that a cage can be wrong in is found when it is made, and named; everything after that
// relies on it. Counts are held against Euler's formula and by hand, volumes against boxes and
// against tetrahedra of the same points. Promises: refused cages leave nothing behind, for memory
// that runs out at any request too.

#include "cages.h"
#include "failing_allocator.h"

static sf_cage_report report_of(const test_cage *c)
{
    sf_cage *cage = test_cage_make(c);
    sf_cage_report report;
    CHECK_EQ(sf_cage_check(cage, NULL, &report, NULL), SF_OK);
    sf_cage_destroy(cage);
    return report;
}

static void a_block_is_counted_as_by_hand(void)
{
    test_cage c = test_cage_block(4, 3, 2);
    sf_cage_report r = report_of(&c);
    CHECK_EQ(r.boundary_faces, 2 * (4 * 3 + 3 * 2 + 4 * 2));
    CHECK_EQ(r.boundary_points, 5 * 4 * 3 - 3 * 2 * 1);
    CHECK_EQ(r.boundary_points - 2 * r.boundary_faces + r.boundary_faces, 2); // Euler
    CHECK(r.loose_points == 0 && r.components == 1 && r.inverted_cells == 0);
    CHECK(r.irregular_points == 0 && r.irregular_edges == 0);
    CHECK_EQ(r.first_inverted, 24);
    CHECK_NEAR(r.volume_mm3, 24, 1e-12);
    test_cage_free(&c);
}

static void around_a_line_edges_and_points_are_irregular(void)
{
    for (uint32_t n = 3; n < 8; n++) {
        test_cage c = test_cage_wheel(n, 3, 0.01);
        sf_cage_report r = report_of(&c);
        CHECK_EQ(r.irregular_edges, n == 4 ? 0 : 3);
        CHECK_EQ(r.irregular_points, n == 4 ? 0 : 2);
        CHECK_EQ(r.boundary_faces, 2 * n + 3 * 2 * n);
        test_cage_free(&c);
    }
}

// A cube as two wedges, as six tetrahedra, and with a loose point and a second part far away.
static void wedges_and_tetrahedra_fill_a_cube(void)
{
    static const uint32_t wedges[12] = {0, 1, 2, 4, 5, 6, 0, 2, 3, 4, 6, 7};
    static const uint32_t tets[24] = {0, 1, 2, 6, 0, 2, 3, 6, 0, 3, 7, 6,
                                      0, 7, 4, 6, 0, 4, 5, 6, 0, 5, 1, 6};
    static const uint32_t hex[8] = {0, 1, 3, 2, 4, 5, 7, 6}; // of the block's numbers
    for (int kind = 0; kind < 2; kind++) {
        size_t cells = kind == 0 ? 2 : 6, corners = kind == 0 ? 6 : 4;
        test_cage c = test_cage_begin(3, 9, cells, corners), block = test_cage_block(1, 1, 1);
        for (size_t i = 0; i < 8; i++) {
            memcpy(c.positions + 3 * i, block.positions + 3 * hex[i], 3 * sizeof(double));
        }
        memcpy(c.corners, kind == 0 ? wedges : tets, cells * corners * sizeof(uint32_t));
        sf_cage_report r = report_of(&c);
        CHECK_EQ(r.boundary_faces, kind == 0 ? 8 : 12);
        CHECK_NEAR(r.volume_mm3, 1, 1e-15);
        CHECK(r.loose_points == 1 && r.components == 1 && r.inverted_cells == 0);
        test_cage_free(&block);
        test_cage_free(&c);
    }
}

static void inverted_cells_are_counted_and_named(void)
{
    test_cage c = test_cage_block(3, 3, 3);
    test_cage_place(&c, 1 + 4 * (1 + 4 * 1), 2.5, 2.5,
                    2.5); // the corner of eight cells, pulled through
    sf_cage *cage = test_cage_make(&c);
    sf_cage_report r;
    sf_fault fault = {0};
    CHECK_EQ(sf_cage_check(cage, NULL, &r, &fault), SF_OK);
    CHECK(r.inverted_cells > 0 && r.inverted_cells <= 8);
    int has_it = 0; // only cells of the moved point can be at fault
    for (int i = 0; i < 8; i++) {
        has_it |= c.corners[8 * r.first_inverted + (size_t)i] == 21;
    }
    CHECK(has_it && strstr(fault.message, "is inverted or flat at its corner") != NULL);
    CHECK_NEAR(r.volume_mm3, 27, 1e-12); // the outside is as it was
    double back[3] = {1, 1, 1};
    CHECK_EQ(sf_cage_set_positions(cage, 21, 1, back), SF_OK);
    CHECK_EQ(sf_cage_check(cage, NULL, &r, NULL), SF_OK);
    CHECK_EQ(r.inverted_cells, 0);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

static void refuse(const test_cage *c, sf_status expected, const char *part)
{
    sf_channel density = {sf_property_density(), c->points, c->values, NULL};
    sf_cage_view view = {c->dimension, c->points,  c->positions,      c->cells,
                         c->starts,    c->corners, c->creases,        c->crease,
                         c->sharps,    c->sharp,   c->values != NULL, &density};
    failing_allocator memory;
    failing_begin(&memory, -1);
    sf_cage *cage = NULL;
    sf_fault fault = {0};
    CHECK_EQ(sf_cage_create(&view, &memory.allocator, &cage, &fault), expected);
    CHECK(cage == NULL && memory.live == 0 && memory.faults == 0);
    if (strstr(fault.message, part) == NULL) {
        printf("# \"%s\" says nothing of \"%s\"\n", fault.message, part);
        CHECK(0);
    }
}

static void what_has_no_limit_is_refused(void)
{
    test_cage c = test_cage_block(2, 1, 1);
    c.corners[8] = c.corners[9];
    refuse(&c, SF_ERR_ARGUMENT, "cell 1 has point");
    test_cage_free(&c);

    c = test_cage_block(2, 1, 1); // the same cell twice
    memcpy(c.corners + 8, c.corners, 8 * sizeof(uint32_t));
    refuse(&c, SF_ERR_ARGUMENT, "cells 0 and 1 lie on the same side");
    test_cage_free(&c);

    c = test_cage_block(2, 1, 1); // its second cell turned inside out
    for (int i = 0; i < 4; i++) {
        uint32_t low = c.corners[8 + i];
        c.corners[8 + i] = c.corners[12 + i];
        c.corners[12 + i] = low;
    }
    refuse(&c, SF_ERR_ARGUMENT, "inverted");
    test_cage_free(&c);

    c = test_cage_block(2, 2, 1); // two cells left of four, in an edge
    memcpy(c.corners + 8, c.corners + 24, 8 * sizeof(uint32_t));
    c.cells = 2;
    refuse(&c, SF_ERR_UNSUPPORTED, "edge of points");
    test_cage_free(&c);

    c = test_cage_block(2, 2, 2); // two of eight, in a point
    memcpy(c.corners + 8, c.corners + 56, 8 * sizeof(uint32_t));
    c.cells = 2;
    refuse(&c, SF_ERR_UNSUPPORTED, "in point 13");
    test_cage_free(&c);

    c = test_cage_block(1, 1, 1); // a pyramid
    c.starts[1] = 5;
    refuse(&c, SF_ERR_UNSUPPORTED, "5 corners");
    test_cage_free(&c);
}

static void what_is_no_cage_is_refused(void)
{
    test_cage c = test_cage_block(2, 1, 1);
    c.dimension = 4;
    refuse(&c, SF_ERR_ARGUMENT, "dimension is 4");
    c.dimension = 3;
    c.corners[3] = 12;
    refuse(&c, SF_ERR_ARGUMENT, "has point 12; there are 12");
    c.corners[3] = 3;
    c.positions[4] = NAN;
    refuse(&c, SF_ERR_ARGUMENT, "point 1 has a coordinate");
    c.positions[4] = -2e12;
    refuse(&c, SF_ERR_ARGUMENT, "point 1 has a coordinate");
    c.positions[4] = 0;
    c.starts[1] = 17;
    refuse(&c, SF_ERR_ARGUMENT, "cell 1");
    c.starts[1] = 8;
    c.cells = 0;
    refuse(&c, SF_ERR_ARGUMENT, "no cells");
    test_cage_free(&c);
    CHECK_EQ(sf_cage_create(NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_cage_get_view(NULL).point_count, 0);
    sf_cage_destroy(NULL);
}

static void what_is_sharp_lies_on_the_surface(void)
{
    static const sf_crease good = {{0, 1}, 2}, inside = {{13, 4}, 1}, none = {{0, 13}, 1};
    test_cage c = test_cage_block(2, 2, 2);
    c.creases = 2;
    c.crease[0] = good;
    c.crease[1] = good;
    refuse(&c, SF_ERR_ARGUMENT, "twice");
    c.crease[1] = inside;
    refuse(&c, SF_ERR_UNSUPPORTED, "inside");
    c.crease[1] = none;
    refuse(&c, SF_ERR_ARGUMENT, "no edge");
    c.creases = 1;
    c.crease[0].sharpness = -1;
    refuse(&c, SF_ERR_ARGUMENT, "sharpness");
    c.creases = 0;
    c.sharps = 1;
    c.sharp[0].point = 13;
    c.sharp[0].sharpness = 1;
    refuse(&c, SF_ERR_UNSUPPORTED, "inside");
    c.sharp[0].point = 27;
    refuse(&c, SF_ERR_ARGUMENT, "none of the cage's");
    test_cage_free(&c);
}

static void faces_make_a_cage_of_dimension_2(void)
{
    test_cage c = test_cage_begin(2, 6, 2, 4);
    static const uint32_t strip[8] = {0, 1, 4, 3, 1, 2, 5, 4};
    memcpy(c.corners, strip, sizeof strip);
    sf_cage_report r = report_of(&c);
    CHECK(r.boundary_faces == 6 && r.boundary_points == 6 && r.components == 1);
    c.corners[5] = 5, c.corners[6] = 2; // crossed
    c.corners[4] = 4, c.corners[7] = 1; // and its edge goes the same way as the neighbour's
    refuse(&c, SF_ERR_ARGUMENT, "same direction");
    test_cage_free(&c);
}

static void changes_are_checked(void)
{
    test_cage c = test_cage_block(1, 1, 1);
    c.values = calloc(c.points, sizeof *c.values);
    sf_cage *cage = test_cage_make(&c);
    double values[8] = {1, 2, 3, 4, 5, 6, 7, 8};
    CHECK_EQ(sf_cage_set_values(cage, 0, 0, 8, values), SF_OK);
    CHECK_EQ(sf_cage_set_values(cage, 0, 1, 8, values), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_cage_set_values(cage, 1, 0, 8, values), SF_ERR_ARGUMENT);
    sf_channel young = {sf_property_young(), 8, values, NULL};
    CHECK_EQ(sf_cage_add_property(cage, &young, NULL), SF_OK);
    CHECK_EQ(sf_cage_add_property(cage, &young, NULL), SF_ERR_ARGUMENT);
    sf_cage_view view = sf_cage_get_view(cage);
    CHECK(view.channel_count == 2 && view.channels[1].values[7] == 8);
    CHECK_EQ(sf_cage_remove_property(cage, 0), SF_OK);
    CHECK_EQ(sf_cage_remove_property(cage, 1), SF_ERR_ARGUMENT);
    CHECK_STR(sf_cage_get_view(cage).channels[0].property.name, "Young's modulus");
    double far[3] = {0, INFINITY, 0};
    CHECK_EQ(sf_cage_set_positions(cage, 7, 1, far), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_cage_set_positions(cage, 8, 1, values), SF_ERR_ARGUMENT);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

// A cube, numbered behind a point that no cell uses and that lies as far away as one can.
static void loose_points_do_not_weigh(void)
{
    test_cage c = test_cage_begin(3, 9, 1, 8), block = test_cage_block(1, 1, 1);
    memcpy(c.positions + 3, block.positions, 24 * sizeof(double));
    for (uint32_t i = 0; i < 8; i++) {
        c.corners[i] = block.corners[i] + 1;
    }
    test_cage_place(&c, 0, 1e12, -1e12, 1e12);
    sf_cage_report r = report_of(&c);
    CHECK_EQ(r.loose_points, 1);
    CHECK_NEAR(r.volume_mm3, 1, 1e-12);
    test_cage_free(&block);
    test_cage_free(&c);
}

// So many faces, or creases, in one point that looking at each from each would take minutes.
static void a_hub_takes_no_longer_than_others(void)
{
    enum { SPOKES = 200000 };
    test_cage fan = test_cage_begin(2, SPOKES + 1, SPOKES, 3);
    sf_crease *creases = calloc(SPOKES, sizeof *creases);
    for (uint32_t i = 0; i < SPOKES; i++) {
        uint32_t corners[3] = {0, 1 + i, 1 + (i + 1) % SPOKES};
        memcpy(fan.corners + 3 * (size_t)i, corners, sizeof corners);
        creases[i].points[1] = 1 + i;
        creases[i].sharpness = 2;
    }
    sf_cage_view view = {2,           fan.points, fan.positions, fan.cells, fan.starts,
                         fan.corners, SPOKES,     creases,       0,         NULL,
                         0,           NULL};
    sf_cage *cage = NULL;
    CHECK_EQ(sf_cage_create(&view, NULL, &cage, NULL), SF_OK);
    sf_cage_destroy(cage);
    free(creases);
    test_cage_free(&fan);
    // Faces that have their least points and the sums of their points in common.
    test_cage star = test_cage_begin(3, 4 * (size_t)SPOKES, SPOKES, 4);
    for (uint32_t i = 0; i < SPOKES; i++) {
        uint32_t corners[4] = {0, 1 + i, 2 * SPOKES + 1 - i, 2 * SPOKES + 2 + i};
        memcpy(star.corners + 4 * (size_t)i, corners, sizeof corners);
    }
    refuse(&star, SF_ERR_UNSUPPORTED, "point 0");
    test_cage_free(&star);
}

static void without_memory_there_is_no_cage(void)
{
    test_cage c = test_cage_wheel(5, 2, 0);
    c.values = calloc(c.points, sizeof *c.values);
    c.creases = 1;
    c.crease[0].points[0] = 1;
    c.crease[0].points[1] = 2;
    c.crease[0].sharpness = 1;
    sf_channel density = {sf_property_density(), c.points, c.values, NULL};
    sf_cage_view view = {3, c.points, c.positions, c.cells, c.starts, c.corners,
                         1, c.crease, 0,           NULL,    1,        &density};
    for (long k = 0;; k++) {
        failing_allocator memory;
        failing_begin(&memory, k);
        sf_cage *cage = NULL;
        sf_status status = sf_cage_create(&view, &memory.allocator, &cage, NULL);
        CHECK(status == SF_OK || (status == SF_ERR_MEMORY && cage == NULL));
        sf_cage_destroy(cage);
        CHECK(memory.live == 0 && memory.faults == 0);
        if (status == SF_OK) {
            CHECK(k > 20);
            break;
        }
    }
    test_cage_free(&c);
}

int main(void)
{
    TEST(a_block_is_counted_as_by_hand);
    TEST(around_a_line_edges_and_points_are_irregular);
    TEST(wedges_and_tetrahedra_fill_a_cube);
    TEST(inverted_cells_are_counted_and_named);
    TEST(what_has_no_limit_is_refused);
    TEST(what_is_no_cage_is_refused);
    TEST(what_is_sharp_lies_on_the_surface);
    TEST(faces_make_a_cage_of_dimension_2);
    TEST(changes_are_checked);
    TEST(loose_points_do_not_weigh);
    TEST(a_hub_takes_no_longer_than_others);
    TEST(without_memory_there_is_no_cage);
    return test_finish();
}

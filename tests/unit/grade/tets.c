// SPDX-License-Identifier: MIT
// Why: simulations and files get tetrahedra, and want them to fit together and to be the right way
// out. Those of refined cages are held to conform (each face of two, or on the boundary, whose
// faces are twice the cage's), to be positive on cages that are sane, to fill what the refined
// cells fill, and to follow when the refinement is updated. Volumes are held against the
// boundary's, and what is inverted is counted. Promises: what cannot be is refused and named;
// memory that runs out at any request leaves nothing behind.

#include "cages.h"
#include "failing_allocator.h"

#include <sf/tetra.h>

static sf_refinement *refine(const test_cage *c, uint32_t steps)
{
    sf_cage *cage = test_cage_make(c);
    sf_refine_options options = sf_refine_options_default();
    options.steps = steps;
    sf_refinement *r = NULL;
    CHECK_EQ(sf_refine(cage, &options, NULL, NULL, &r), SF_OK);
    sf_cage_destroy(cage);
    return r;
}

static sf_tets_report report_of(const sf_tets *tets)
{
    sf_tets_report report = {0};
    CHECK_EQ(sf_tets_check(tets, NULL, &report), SF_OK);
    return report;
}

static test_cage kind_of(int kind)
{
    if (kind == 0) {
        return test_cage_block(3, 2, 2);
    }
    if (kind < 5) {
        static const uint32_t around[5] = {0, 3, 5, 6, 8};
        return test_cage_wheel(around[kind], 2, 0);
    }
    size_t cells = kind == 5 ? 2 : 6, corners = kind == 5 ? 6 : 4;
    static const uint32_t wedges[12] = {0, 1, 2, 4, 5, 6, 0, 2, 3, 4, 6, 7};
    static const uint32_t tets[24] = {0, 1, 2, 6, 0, 2, 3, 6, 0, 3, 7, 6,
                                      0, 7, 4, 6, 0, 4, 5, 6, 0, 5, 1, 6};
    test_cage c = test_cage_begin(3, 8, cells, corners);
    for (uint32_t i = 0; i < 8; i++) {
        test_cage_place(&c, i, (i + 1) / 2 % 2, i / 2 % 2, i / 4);
    }
    memcpy(c.corners, kind == 5 ? wedges : tets, cells * corners * sizeof(uint32_t));
    return c;
}

static void those_of_cages_conform_and_fill_them(void)
{
    for (int kind = 0; kind < 7; kind++) {
        test_cage c = kind_of(kind);
        sf_refinement *r = refine(&c, 3);
        for (uint32_t step = 1; step <= 3; step++) {
            sf_cage_view v;
            sf_cage *fine = NULL;
            sf_cage_report cells;
            sf_tets *tets = NULL;
            CHECK_EQ(sf_refinement_get_view(r, step, &v), SF_OK);
            CHECK_EQ(sf_cage_create(&v, NULL, &fine, NULL), SF_OK);
            CHECK_EQ(sf_cage_check(fine, NULL, &cells, NULL), SF_OK);
            CHECK_EQ(sf_tets_of_refinement(r, step, NULL, &tets), SF_OK);
            sf_tets_report found = report_of(tets);
            CHECK_EQ(sf_tets_get_view(tets).tet_count, 6 * v.cell_count);
            CHECK_EQ(found.crowded_faces, 0);
            CHECK_EQ(found.boundary_faces, 2 * cells.boundary_faces);
            CHECK(found.inverted == 0 && found.first_inverted == 6 * v.cell_count);
            // Sides are bent a little; the two differ by how they are cut.
            CHECK_NEAR(found.volume_mm3, cells.volume_mm3, 0.02 * cells.volume_mm3);
            sf_tets_destroy(tets);
            sf_cage_destroy(fine);
        }
        sf_refinement_destroy(r);
        test_cage_free(&c);
    }
}

static void they_follow_their_refinement(void)
{
    test_cage c = test_cage_block(2, 2, 2);
    c.value_count = 2;
    c.values = calloc(2, sizeof *c.values);
    c.values[1] = 1;
    c.indices = calloc(8 * c.cells, sizeof *c.indices);
    for (size_t i = 32; i < 64; i++) {
        c.indices[i] = 1; // the upper half
    }
    sf_refinement *r = refine(&c, 2);
    sf_tets *tets = NULL;
    CHECK_EQ(sf_tets_of_refinement(r, 2, NULL, &tets), SF_OK);
    sf_tets_view v = sf_tets_get_view(tets);
    for (size_t i = 0; i < 4 * v.tet_count; i++) {
        double value = v.channels[0].values[v.channels[0].indices[i]];
        CHECK(value == (i / 4 / 6 >= 4 * 64)); // cells of the upper half come later
    }
    double volume = report_of(tets).volume_mm3, changed[2] = {3, 4};
    for (size_t i = 0; i < 3 * c.points; i++) {
        c.positions[i] *= 2;
    }
    CHECK_EQ(sf_refinement_update_positions(r, c.positions, NULL), SF_OK);
    CHECK_EQ(sf_refinement_update_values(r, 0, changed, NULL), SF_OK);
    CHECK_NEAR(report_of(tets).volume_mm3, 8 * volume, 1e-12 * volume);
    CHECK(v.channels[0].values[v.channels[0].indices[0]] == 3);
    CHECK_EQ(sf_tets_set_values(tets, 0, 0, 1, changed), SF_ERR_UNSUPPORTED);
    sf_tets_destroy(tets);
    tets = NULL;
    CHECK_EQ(sf_tets_of_refinement(r, 0, NULL, &tets), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_tets_of_refinement(r, 3, NULL, &tets), SF_ERR_ARGUMENT);
    for (long k = 0;; k++) {
        failing_allocator memory;
        failing_begin(&memory, k);
        sf_status status = sf_tets_of_refinement(r, 2, &memory.allocator, &tets);
        sf_tets_destroy(tets);
        tets = NULL;
        CHECK(memory.live == 0 && memory.faults == 0);
        if (status == SF_OK) {
            break;
        }
        CHECK_EQ(status, SF_ERR_MEMORY);
    }
    sf_refinement_destroy(r);
    test_cage_free(&c);
}

// Two tetrahedra on a face, of which the second may be turned inside out.
static const double five[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
static const uint32_t pair[8] = {0, 1, 2, 3, 1, 4, 2, 3};

static void what_is_inverted_or_crowded_is_counted(void)
{
    uint32_t corners[12];
    memcpy(corners, pair, sizeof pair);
    memcpy(corners + 8, pair, 4 * sizeof *pair); // the first once more
    sf_tets_view view = {5, five, 2, corners, 0, NULL};
    sf_tets *tets = NULL;
    CHECK_EQ(sf_tets_create(&view, NULL, &tets, NULL), SF_OK);
    sf_tets_report r = report_of(tets);
    CHECK(r.inverted == 0 && r.boundary_faces == 6 && r.crowded_faces == 0);
    CHECK_NEAR(r.volume_mm3, 1.0 / 6 + 2.0 / 6, 1e-15);
    sf_tets_destroy(tets);
    view.tet_count = 3;
    CHECK_EQ(sf_tets_create(&view, NULL, &tets, NULL), SF_OK);
    CHECK_EQ(report_of(tets).crowded_faces, 4);
    sf_tets_destroy(tets);
    corners[5] = 2, corners[6] = 4; // the second turned
    view.tet_count = 2;
    CHECK_EQ(sf_tets_create(&view, NULL, &tets, NULL), SF_OK);
    r = report_of(tets);
    CHECK(r.inverted == 1 && r.first_inverted == 1 && r.crowded_faces == 1);
    CHECK_NEAR(r.volume_mm3, 1.0 / 6 - 2.0 / 6, 1e-15);
    sf_tets_destroy(tets);
}

static void refuse(const sf_tets_view *view, sf_status expected, const char *part)
{
    failing_allocator memory;
    failing_begin(&memory, -1);
    sf_tets *tets = NULL;
    sf_fault fault = {0};
    CHECK_EQ(sf_tets_create(view, &memory.allocator, &tets, &fault), expected);
    CHECK(tets == NULL && memory.live == 0 && strstr(fault.message, part) != NULL);
}

static void what_cannot_be_is_refused(void)
{
    uint32_t corners[8];
    double positions[15], values[5] = {1, 2, 3, 4, 5};
    memcpy(corners, pair, sizeof pair);
    memcpy(positions, five, sizeof five);
    sf_channel density = {sf_property_density(), 5, values, NULL};
    sf_tets_view view = {5, positions, 2, corners, 1, &density};
    corners[6] = 5;
    refuse(&view, SF_ERR_ARGUMENT, "tetrahedron 1 has point 5");
    corners[6] = 1;
    refuse(&view, SF_ERR_ARGUMENT, "tetrahedron 1 has one point at two corners");
    corners[6] = 2;
    positions[7] = INFINITY;
    refuse(&view, SF_ERR_ARGUMENT, "point 2");
    positions[7] = 1;
    values[3] = -1;
    refuse(&view, SF_ERR_ARGUMENT, "value 3");
    values[3] = 1;
    view.tet_count = 0;
    refuse(&view, SF_ERR_ARGUMENT, "no points");
    view.tet_count = 2;
    for (long k = 0;; k++) {
        failing_allocator memory;
        failing_begin(&memory, k);
        sf_tets *tets = NULL;
        sf_status status = sf_tets_create(&view, &memory.allocator, &tets, NULL);
        if (status == SF_OK) {
            CHECK_EQ(sf_tets_set_values(tets, 0, 4, 1, values), SF_OK);
            CHECK(sf_tets_get_view(tets).channels[0].values[4] == 1);
            CHECK_EQ(sf_tets_set_values(tets, 0, 5, 1, values), SF_ERR_ARGUMENT);
            CHECK_EQ(sf_tets_set_values(tets, 1, 0, 1, values), SF_ERR_ARGUMENT);
            sf_tets_report report;
            for (long j = 0; j < 3; j++) {
                failing_allocator scratch;
                failing_begin(&scratch, j);
                CHECK_EQ(sf_tets_check(tets, &scratch.allocator, &report), SF_ERR_MEMORY);
                CHECK_EQ(scratch.live, 0);
            }
        }
        sf_tets_destroy(tets);
        CHECK_EQ(memory.live, 0);
        if (status == SF_OK) {
            break;
        }
        CHECK_EQ(status, SF_ERR_MEMORY);
    }
    sf_tets_destroy(NULL);
    CHECK_EQ(sf_tets_get_view(NULL).tet_count, 0);
}

int main(void)
{
    TEST(those_of_cages_conform_and_fill_them);
    TEST(they_follow_their_refinement);
    TEST(what_is_inverted_or_crowded_is_counted);
    TEST(what_cannot_be_is_refused);
    return test_finish();
}

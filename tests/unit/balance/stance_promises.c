// SPDX-License-Identifier: MIT
// Why: nonsense is refused with a sentence, and a call that fails leaves everything as it was (P2):
// every option out of range, every missing pointer, too little room, memory that ends at the k-th
// request. Bodies without width and centres of mass outside of them get an answer all the same.

#include "failing_allocator.h"
#include "turn.h"

#include <sf/stance.h>

static sf_stance *const before = (sf_stance *)&test_count; // somebody's pointer

static void refused(sf_mesh_view view, const sf_stance_options *options, sf_status expected)
{
    sf_stance *stance = before;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_stance_create(view, options, NULL, &stance, &fault), expected);
    CHECK(stance == before);
    CHECK_EQ(fault.status, expected);
    CHECK(strlen(fault.message) > 10);
    CHECK_EQ(sf_stance_create(view, options, NULL, &stance, NULL), expected);
}

static sf_mesh_view table(soup *s)
{
    s->count = 0;
    for (int i = 0; i < 5; i++) {
        soup_add(s, 10 * cos(i), 10 * sin(i), 0);
        soup_add(s, 10 * cos(i), 10 * sin(i), 5);
    }
    return soup_view(s);
}

static void options_out_of_range(void)
{
    static soup s;
    sf_mesh_view view = table(&s);
    const sf_stance_options good = sf_stance_options_default();
    const double nonsense[] = {NAN, INFINITY, -INFINITY, -1e-300, 1e13, -1};
    CHECK_EQ(good.struct_size, sizeof good);
    for (size_t i = 0; i < sizeof nonsense / sizeof nonsense[0]; i++) {
        double *fields[6];
        sf_stance_options o = good;
        fields[0] = &o.gamma_rad;
        fields[1] = &o.tolerance_rad;
        fields[2] = &o.range_rad;
        fields[3] = &o.contact_mm;
        fields[4] = &o.lever_mm;
        fields[5] = &o.point_mm[1];
        for (int f = 0; f < 6; f++) {
            o = good;
            if (f < 5 || !(fabs(nonsense[i]) <= 1)) {
                *fields[f] = nonsense[i];
                refused(view, &o, SF_ERR_ARGUMENT);
            }
        }
    }
    const double ups[][3] = {
        {0, 0, 0}, {NAN, 0, 1}, {0, INFINITY, 0}, {1e-200, 0, 0}, {1e200, -1e200, 1e200}};
    for (size_t i = 0; i < sizeof ups / sizeof ups[0]; i++) {
        sf_stance_options o = good;
        memcpy(o.up, ups[i], sizeof o.up);
        refused(view, &o, SF_ERR_ARGUMENT);
    }
    sf_stance_options o = good;
    o.struct_size -= 1;
    refused(view, &o, SF_ERR_ARGUMENT);
    o = good;
    o.kind = (sf_stance_kind)7;
    refused(view, &o, SF_ERR_ARGUMENT);
    o.kind = (sf_stance_kind)-1;
    refused(view, &o, SF_ERR_ARGUMENT);
    o = good;
    o.kind = SF_STANCE_ROCK;
    o.range_rad = o.tolerance_rad;
    refused(view, &o, SF_ERR_ARGUMENT);
    o = good;
    o.region_low_mm[1] = 2;
    o.region_high_mm[1] = 1;
    refused(view, &o, SF_ERR_ARGUMENT);
    o.region_high_mm[1] = NAN;
    refused(view, &o, SF_ERR_ARGUMENT);
    o = good;
    o.region_low_mm[0] = 100;
    refused(view, &o, SF_ERR_ARGUMENT);
}

static void meshes_that_are_none(void)
{
    static soup s;
    sf_mesh_view view = table(&s), none = {NULL, 0, NULL, 0}, some;
    sf_stance_options options = sf_stance_options_default();
    sf_stance *stance = before;
    refused(none, &options, SF_ERR_ARGUMENT);
    some = view;
    some.triangle_count = 0;
    refused(some, &options, SF_ERR_ARGUMENT);
    s.triangles[4] = 10;
    refused(view, &options, SF_ERR_ARGUMENT);
    view = soup_view(&s);
    s.vertices[7] = NAN;
    refused(view, &options, SF_ERR_ARGUMENT);
    s.vertices[7] = -1.5e12;
    refused(view, &options, SF_ERR_OVERFLOW);
    view = table(&s);
    refused(view, NULL, SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stance_create(view, &options, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK(stance == before);
    sf_stance_destroy(NULL);
}

static void questions_that_are_none(void)
{
    static soup s;
    sf_stance_options options = sf_stance_options_default();
    sf_stance *stance = NULL;
    sf_stance_verdict verdict, kept;
    sf_halfspace halfspaces[8];
    double xyz[3 * 8], com[3] = {0, 0, 1};
    uint32_t vertices[8];
    size_t count = 77;
    memset(&verdict, 0x5a, sizeof verdict);
    kept = verdict;
    CHECK_EQ(sf_stance_create(table(&s), &options, NULL, &stance, NULL), SF_OK);
    CHECK_EQ(sf_stance_judge(NULL, com, &verdict), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stance_judge(stance, NULL, &verdict), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stance_judge(stance, com, NULL), SF_ERR_ARGUMENT);
    const double nonsense[] = {NAN, INFINITY, -1.1e12};
    for (int i = 0; i < 9; i++) {
        double wrong[3] = {0, 0, 1};
        wrong[i / 3] = nonsense[i % 3];
        CHECK_EQ(sf_stance_judge(stance, wrong, &verdict), SF_ERR_ARGUMENT);
    }
    CHECK(memcmp(&verdict, &kept, sizeof kept) == 0);
    CHECK_EQ(sf_stance_polygon(NULL, xyz, 8, &count), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stance_polygon(stance, NULL, 8, &count), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stance_polygon(stance, xyz, 8, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stance_contacts(NULL, vertices, 8, &count), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stance_contacts(stance, NULL, 8, &count), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stance_contacts(stance, vertices, 8, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stance_halfspaces(NULL, halfspaces, 8, &count), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stance_halfspaces(stance, NULL, 8, &count), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stance_halfspaces(stance, halfspaces, 8, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stance_flatten(NULL, s.vertices, s.count), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stance_flatten(stance, NULL, s.count), SF_ERR_ARGUMENT);
    CHECK_EQ(count, 77);
    xyz[0] = 5;
    CHECK_EQ(sf_stance_polygon(stance, xyz, 4, &count), SF_ERR_CAPACITY);
    CHECK(count == 5 && xyz[0] == 5);
    vertices[0] = 9;
    CHECK_EQ(sf_stance_contacts(stance, vertices, 4, &count), SF_ERR_CAPACITY);
    CHECK(count == 5 && vertices[0] == 9);
    CHECK_EQ(sf_stance_halfspaces(stance, halfspaces, 4, &count), SF_ERR_CAPACITY);
    CHECK_EQ(count, 5);
    sf_stance_destroy(stance);
}

// Points on a coarse lattice, many in one place, line or plane; centres of mass anywhere, in the
// hull or not: there is always an answer, and what is safe stands.
static void strange_bodies(void)
{
    static soup s;
    int safe[3] = {0, 0, 0};
    for (int i = 0; i < 6000; i++) {
        int kind = i % 3, tall = i % 4 > 0;
        sf_stance_options options = sf_stance_options_default();
        sf_stance *stance = NULL;
        sf_stance_verdict v;
        s.count = 0;
        for (int j = 1 + (int)test_random_below(12); j > 0; j--) {
            soup_add(&s, test_random_below(4), test_random_below(3),
                     tall ? test_random_below(4) : 0);
        }
        options.kind = (sf_stance_kind)kind;
        options.gamma_rad = 0.2 * test_random_unit();
        options.tolerance_rad = 0.01 + 0.3 * test_random_unit();
        options.range_rad = options.tolerance_rad + 0.01 + 0.5 * test_random_unit();
        options.point_mm[2] = 3;
        options.lever_mm = 0.01;
        options.region_low_mm[0] = i % 7 == 0 ? 1 : -INFINITY;
        if (i % 5 == 0) {
            random_direction(options.up);
        }
        sf_status status = sf_stance_create(soup_view(&s), &options, NULL, &stance, NULL);
        CHECK(status == SF_OK || status == SF_ERR_ARGUMENT);
        for (int k = 0; k < 10 && status == SF_OK; k++) {
            double size = k < 8 ? 4 : 1e9, com[3];
            for (int d = 0; d < 3; d++) {
                com[d] = size * (k % 2 ? 0.25 * test_random_below(5) : test_random_unit());
            }
            CHECK_EQ(sf_stance_judge(stance, com, &v), SF_OK);
            CHECK(isfinite(v.margin_rad) && fabs(v.margin_rad) <= 3.2 && isfinite(v.slack_mm));
            // What lies in a corner that it rocks on is in balance everywhere, or nowhere.
            CHECK(!v.safe || v.stands || (kind == SF_STANCE_ROCK && v.slack_mm < 1e-7));
            safe[kind] += v.safe;
        }
        sf_stance_destroy(stance);
    }
    CHECK(safe[0] > 100 && safe[1] > 100 && safe[2] > 10);
}

static void memory_that_ends(void)
{
    static soup s;
    for (int kind = SF_STANCE_STAND; kind <= SF_STANCE_HANG; kind++) {
        sf_stance_options options = sf_stance_options_default();
        sf_stance *stance = before;
        sf_status status = SF_ERR_MEMORY;
        failing_allocator f;
        options.kind = (sf_stance_kind)kind;
        for (long k = 0; status == SF_ERR_MEMORY && k < 100; k++) {
            sf_fault fault = {SF_OK, 0, 0, ""};
            failing_begin(&f, k);
            status = sf_stance_create(table(&s), &options, &f.allocator, &stance, &fault);
            CHECK(status == SF_OK || (stance == before && f.live == 0 && f.faults == 0));
            CHECK_EQ(fault.status, status);
        }
        CHECK_EQ(status, SF_OK);
        CHECK(f.requests >= 3);
        sf_stance_destroy(stance);
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
}

int main(void)
{
    TEST(options_out_of_range);
    TEST(meshes_that_are_none);
    TEST(questions_that_are_none);
    TEST(strange_bodies);
    TEST(memory_that_ends);
    return test_finish();
}

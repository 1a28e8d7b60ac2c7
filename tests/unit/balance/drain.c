// SPDX-License-Identifier: MIT
// Why: what is shut into a cavity must get out, and the hole must not cost the part its support.
// Random parts with cavities are drained under rules of all kinds; then a flood fill from outside
// counts what is still shut in, and the slow judge of support looks at every layer. Holes are as
// wide as a rod of their diameter, lie where the balance changes least, and aslant only where
// straight is impossible.

#include "drain_parts.h"
#include "law/alive.h"
#include "unit/mesh/shapes.h"

#include <sf/carve.h>
#include <sf/finding.h>

// ---------------------------------------------------------------------------------------------
// The judges
// ---------------------------------------------------------------------------------------------

// Voids of a stack that no path through faces leads out of, and their voxels.
static uint64_t shut_in(const stack *s, uint64_t *voxels)
{
    static uint8_t seen[STACK_VOXELS];
    static int queue[STACK_VOXELS];
    uint64_t count = 0;
    *voxels = 0;
    memcpy(seen, s->solid, (size_t)stack_count(s));
    for (int start = 0; start < stack_count(s); start++) {
        int head = 0, tail = 0, open = 0;
        if (seen[start]) {
            continue;
        }
        seen[start] = 1;
        queue[tail++] = start;
        for (; head < tail; head++) {
            int x = queue[head] % s->nx, y = queue[head] / s->nx % s->ny;
            int z = queue[head] / s->nx / s->ny;
            for (int d = 0; d < 6; d++) {
                int step = d % 2 ? 1 : -1;
                int u = x + (d / 2 == 0) * step, v = y + (d / 2 == 1) * step;
                int w = z + (d / 2 == 2) * step;
                if (u < 0 || v < 0 || w < 0 || u >= s->nx || v >= s->ny || w >= s->nz) {
                    open = 1;
                    continue;
                }
                int at = (w * s->ny + v) * s->nx + u;
                if (!seen[at]) {
                    seen[at] = 1;
                    queue[tail++] = at;
                }
            }
        }
        count += !open;
        *voxels += open ? 0 : (uint64_t)tail;
    }
    return count;
}

// ---------------------------------------------------------------------------------------------
// Random parts
// ---------------------------------------------------------------------------------------------

// A part that prints under a rule, hollowed as far as that allows.
static sf_grid *hollow_part(const alive_rule *rule, const sf_terms *terms)
{
    static stack drawn, s;
    sf_lattice l = stack_lattice(24, 18, 14);
    sf_grid *wall = NULL, *made = NULL;
    stack_random_boxes(&drawn, 24, 18, 14, 7);
    alive_trim(rule, &drawn, NULL, stack_bed(&drawn, SF_BED_AUTO), &s);
    sf_grid *solid = stack_grid(&s);
    CHECK_EQ(sf_grid_create(&l, NULL, &wall), SF_OK);
    CHECK_EQ(sf_grid_create(&l, NULL, &made), SF_OK);
    CHECK_EQ(sf_grid_wall_inside(solid, 0.1, NULL, NULL, wall), SF_OK);
    CHECK_EQ(sf_grid_carve(solid, wall, terms, NULL, NULL, NULL, made, NULL), SF_OK);
    sf_grid_destroy(solid);
    sf_grid_destroy(wall);
    return made;
}

static void check_holes(const sf_grid *made, const sf_grid *was, const sf_drain *drains,
                        const sf_drain_report *r)
{
    static stack before, after;
    uint64_t voxels = 0, shut = 0, missing = 0, drilled = 0;
    stack_read(&before, was);
    stack_read(&after, made);
    CHECK_EQ(r->void_count, shut_in(&before, &voxels));
    CHECK_EQ(r->void_voxels, voxels);
    shut = shut_in(&after, &voxels);
    CHECK_EQ(r->closed_count, shut);
    CHECK_EQ(r->closed_voxels, voxels);
    CHECK_EQ(r->drained_count, r->void_count - shut);
    CHECK(stack_within(&after, &before));
    for (int i = 0; i < stack_count(&before); i++) {
        missing += (uint64_t)(before.solid[i] && !after.solid[i]);
    }
    CHECK_EQ(r->removed_voxels, missing);
    CHECK_NEAR(r->removed.mass, (double)missing * 1e-3, 1e-12);
    for (uint64_t i = 0; i < r->drain_count; i++) {
        drilled += drains[i].voxels;
        CHECK(drains[i].voxels > 0 && drains[i].to_mm[2] <= drains[i].from_mm[2]);
    }
    CHECK_EQ(drilled, missing);
}

static void nothing_stays_shut_or_hangs(void)
{
    uint64_t voids = 0, closed = 0, aslant = 0, narrow = 0, kept = 0;
    for (int i = 0; i < 16; i++) {
        sf_rule rule = alive_rule_by_number(i);
        alive_rule alive;
        sf_terms terms = sf_terms_default();
        terms.rule = rule;
        alive_prepare(&alive, &rule, 14);
        for (int round = 0; round < 12; round++) {
            sf_drain drains[64];
            sf_drain_report r;
            sf_drain_options o = sf_drain_options_default();
            sf_grid *made = hollow_part(&alive, &terms), *was = NULL;
            CHECK_EQ(sf_grid_clone(made, NULL, &was), SF_OK);
            o.diameter_mm = round % 3 == 0 ? 0.05 : round % 3 == 1 ? 0.12 : 0.25;
            o.drains = drains;
            o.drain_capacity = 64;
            CHECK_EQ(sf_grid_drain(made, &terms, &o, NULL, NULL, &r), SF_OK);
            check_holes(made, was, drains, &r);
            static stack s;
            stack_read(&s, made);
            CHECK(alive_is_free(&alive, &s, NULL, stack_bed(&s, SF_BED_AUTO)));
            voids += r.void_count;
            closed += r.closed_count;
            narrow += o.diameter_mm < 0.1 ? r.void_count : 0;
            kept += o.diameter_mm < 0.1 ? r.closed_count : 0;
            for (uint64_t j = 0; j < r.drain_count; j++) {
                aslant += drains[j].from_mm[0] != drains[j].to_mm[0] ||
                          drains[j].from_mm[1] != drains[j].to_mm[1];
            }
            sf_grid_destroy(made);
            sf_grid_destroy(was);
        }
    }
    printf("# %llu voids, %llu stay closed, %llu holes aslant\n", (unsigned long long)voids,
           (unsigned long long)closed, (unsigned long long)aslant);
    CHECK(voids > 100 && closed < voids / 2 && aslant > 0);
    CHECK(kept <= narrow / 8); // a hole of one voxel fits everywhere, and few places forbid it
}

// Where no hole fits, voids are filled with what was there, and what cannot be stays as it was.
static void what_is_not_drained_is_filled(void)
{
    uint64_t filled = 0, closed = 0;
    for (int i = 0; i < 96; i++) {
        static stack before, after;
        sf_rule rule = alive_rule_by_number(i);
        alive_rule alive;
        sf_terms terms = sf_terms_default();
        sf_drain_report r;
        sf_drain_options o = sf_drain_options_default();
        uint64_t voxels = 0, added = 0, gone = 0;
        terms.rule = rule;
        alive_prepare(&alive, &rule, 14);
        sf_grid *made = hollow_part(&alive, &terms), *was = NULL;
        CHECK_EQ(sf_grid_clone(made, NULL, &was), SF_OK);
        o.diameter_mm = 0.25;
        o.fill = 1;
        CHECK_EQ(sf_grid_drain(made, &terms, &o, NULL, NULL, &r), SF_OK);
        stack_read(&before, was);
        stack_read(&after, made);
        CHECK(alive_is_free(&alive, &after, NULL, stack_bed(&after, SF_BED_AUTO)));
        CHECK_EQ(shut_in(&after, &voxels), r.closed_count);
        CHECK_EQ(voxels, r.closed_voxels);
        CHECK_EQ(r.void_count, r.drained_count + r.filled_count + r.closed_count);
        for (int j = 0; j < stack_count(&before); j++) {
            added += (uint64_t)(!before.solid[j] && after.solid[j]);
            gone += (uint64_t)(before.solid[j] && !after.solid[j]);
        }
        CHECK_EQ(added, r.filled_voxels);
        CHECK_EQ(gone, r.removed_voxels);
        filled += r.filled_count;
        closed += r.closed_count;
        if (r.filled_count > 0) { // nothing is added where nothing may be
            sf_grid *everywhere = NULL;
            CHECK_EQ(sf_grid_clone(was, NULL, &everywhere), SF_OK);
            terms.forbid = everywhere;
            for (uint32_t k = 0; k < 14; k++) {
                sf_rect all = {0, 0, 24, 18};
                CHECK_EQ(sf_slice_fill(sf_grid_slice(everywhere, k), all, 1), SF_OK);
            }
            uint64_t drained = r.drained_count;
            CHECK_EQ(sf_grid_drain(was, &terms, &o, NULL, NULL, &r), SF_OK);
            CHECK_EQ(r.filled_count, 0);
            CHECK_EQ(r.drained_count, drained);
            sf_grid_destroy(everywhere);
        }
        sf_grid_destroy(made);
        sf_grid_destroy(was);
    }
    printf("# %llu voids were filled, %llu stay closed\n", (unsigned long long)filled,
           (unsigned long long)closed);
    CHECK(filled > 10 && closed < filled);
}

// ---------------------------------------------------------------------------------------------
// Made to measure
// ---------------------------------------------------------------------------------------------

// A rod of the diameter stands in the hole: every voxel that it touches is gone.
static void a_rod_passes(void)
{
    for (int i = 1; i < 12; i++) {
        sf_grid *grid = empty_grid(40, 40, 12, 0.5);
        sf_drain drain;
        sf_drain_report r;
        sf_drain_options o = sf_drain_options_default();
        fill(grid, 2, 2, 0, 38, 38, 12, 1);
        fill(grid, 6, 6, 3, 34, 34, 9, 0);
        o.diameter_mm = 0.4 * i;
        o.drains = &drain;
        o.drain_capacity = 1;
        CHECK_EQ(sf_grid_drain(grid, NULL, &o, NULL, NULL, &r), SF_OK);
        CHECK_EQ(r.drain_count, 1);
        CHECK_EQ(r.drained_count, 1);
        double radius = 0.5 * o.diameter_mm;
        CHECK(drain.from_mm[0] == drain.to_mm[0] && drain.from_mm[1] == drain.to_mm[1]);
        CHECK_NEAR(drain.from_mm[2], 1.5, 1e-12);
        CHECK_NEAR(drain.to_mm[2], 0, 1e-12);
        for (int turn = 0; turn < 64; turn++) {
            double x = drain.from_mm[0] + 0.999 * radius * cos(turn * 0.1);
            double y = drain.from_mm[1] + 0.999 * radius * sin(turn * 0.1);
            for (uint32_t k = 0; k < 3; k++) {
                CHECK(!sf_slice_get(sf_grid_slice(grid, k), (uint32_t)(2 * x), (uint32_t)(2 * y)));
            }
        }
        CHECK(3.1416 * radius * radius * 1.5 <= (double)r.removed_voxels * 0.125);
        CHECK((double)r.removed_voxels * 0.125 <=
              3.1416 * (radius + 0.71) * (radius + 0.71) * 1.5 + 0.2);
        sf_grid_destroy(grid);
    }
}

// Two voids above each other, the lower one drained first, so that one short hole serves the upper.
static void voids_drain_into_each_other(void)
{
    sf_grid *grid = empty_grid(20, 20, 40, 1);
    sf_drain drains[4];
    sf_drain_report r;
    sf_drain_options o = sf_drain_options_default();
    fill(grid, 1, 1, 0, 19, 19, 40, 1);
    fill(grid, 4, 4, 30, 16, 16, 36, 0);
    fill(grid, 4, 4, 3, 16, 16, 27, 0);
    o.diameter_mm = 2;
    o.drains = drains;
    o.drain_capacity = 4;
    CHECK_EQ(sf_grid_drain(grid, NULL, &o, NULL, NULL, &r), SF_OK);
    CHECK_EQ(r.drain_count, 2);
    CHECK_NEAR(drains[0].to_mm[2], 0, 1e-12);
    CHECK_NEAR(drains[1].from_mm[2] - drains[1].to_mm[2], 3, 1e-12);
    CHECK_EQ(drains[0].void_voxels, 12 * 12 * 24);
    sf_grid_destroy(grid);
}

// A cavity behind a foot that must stay whole, in the side of a tower: the way out is aslant, no
// flatter than the rule, and the tower prints.
static void aslant_where_straight_is_impossible(void)
{
    for (int i = 0; i < 8; i++) {
        sf_rule rule = alive_rule_by_number(i);
        sf_grid *grid = empty_grid(30, 24, 15, 0.1), *keep = empty_grid(30, 24, 15, 0.1);
        sf_drain drain;
        sf_drain_report r;
        sf_drain_options o = sf_drain_options_default();
        sf_terms terms = sf_terms_default();
        terms.rule = rule;
        fill(grid, 6, 4, 0, 24, 20, 15, 1);
        fill(grid, 8, 8, 12, 11, 16, 14, 0); // under a ceiling that is 3 wide
        fill(keep, 0, 0, 0, 30, 24, 1, 1);
        terms.keep = keep;
        o.diameter_mm = 0.12;
        o.drains = &drain;
        o.drain_capacity = 1;
        static stack s;
        alive_rule alive;
        alive_prepare(&alive, &rule, 15);
        stack_read(&s, grid);
        int printed = alive_is_free(&alive, &s, NULL, 0);
        CHECK_EQ(sf_grid_drain(grid, &terms, &o, NULL, NULL, &r), SF_OK);
        stack_read(&s, grid);
        CHECK(!printed || alive_is_free(&alive, &s, NULL, 0));
        if (i != 1 && i != 5) { // what allows 30 degrees reaches no side on the way to the foot
            CHECK_EQ(r.drained_count, 1);
            CHECK(drain.to_mm[0] < 0.75 && drain.to_mm[2] > 0.1);
        }
        sf_grid_destroy(grid);
        sf_grid_destroy(keep);
    }
}

// A ball: whatever is drilled out of its underside leaves a rim that stood on it. That goes as
// well, and nothing hangs that did not.
static void through_an_underside(double diameter_mm)
{
    sf_grid *grid = empty_grid(44, 44, 40, 1), *before = empty_grid(44, 44, 40, 1);
    sf_grid *after = empty_grid(44, 44, 40, 1);
    sf_drain drain;
    sf_drain_report r;
    sf_drain_options o = sf_drain_options_default();
    sf_terms terms = sf_terms_default();
    for (uint32_t i = 0; i < 44 * 44 * 40; i++) {
        double x = i % 44 - 21.5, y = i / 44 % 44 - 21.5, z = i / 44 / 44 - 19.5;
        double squared = x * x + y * y + z * z;
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, i / 44 / 44), i % 44, i / 44 % 44,
                              squared < 400 && squared > 200),
                 SF_OK);
    }
    CHECK_EQ(sf_grid_unsupported(grid, &terms, NULL, NULL, before, NULL), SF_OK);
    o.diameter_mm = diameter_mm;
    o.drains = &drain;
    o.drain_capacity = 1;
    uint64_t solid = sf_grid_popcount(grid);
    CHECK_EQ(sf_grid_drain(grid, &terms, &o, NULL, NULL, &r), SF_OK);
    CHECK_EQ(r.drained_count, 1);
    CHECK_EQ(r.removed_voxels, drain.voxels);
    CHECK_EQ(drain.voxels, solid - sf_grid_popcount(grid));
    CHECK_NEAR(r.removed.mass, (double)drain.voxels, 1e-9);
    CHECK_EQ(sf_grid_unsupported(grid, &terms, NULL, NULL, after, NULL), SF_OK);
    for (uint32_t k = 0; k < 40; k++) {
        sf_slice slice = sf_grid_slice(after, k);
        CHECK_EQ(sf_slice_subtract(slice, slice, sf_grid_slice(before, k)), SF_OK);
        CHECK_EQ(sf_slice_popcount(slice), 0);
    }
    sf_grid_destroy(grid);
    sf_grid_destroy(before);
    sf_grid_destroy(after);
}

static void through_a_shallow_underside(void)
{
    for (double diameter_mm = 3; diameter_mm < 17; diameter_mm += 1) {
        through_an_underside(diameter_mm);
    }
}

// A long box: the hole is where it weighs on the balance least, and far from the other one.
static void balance_and_distance(void)
{
    static shape s;
    const double low[3] = {1, 1, 0}, high[3] = {59, 13, 12};
    sf_stance_options pose = sf_stance_options_default();
    sf_stance *stance = NULL;
    s.vertex_count = s.triangle_count = 0;
    shape_box(&s, low, high, 0);
    CHECK_EQ(sf_stance_create(shape_view(&s), &pose, NULL, &stance, NULL), SF_OK);
    for (int heavy = 0; heavy < 3; heavy++) {
        sf_grid *grid = empty_grid(60, 14, 12, 1);
        const sf_stance *stances[1] = {stance};
        sf_drain drains[2];
        sf_drain_report r;
        sf_drain_options o = sf_drain_options_default();
        double x = 10 + 20 * heavy;
        sf_body body = {100, {100 * x, 700, 500}};
        fill(grid, 1, 1, 0, 59, 13, 12, 1);
        fill(grid, 4, 4, 3, 56, 10, 9, 0);
        o.diameter_mm = 2;
        o.count = 2;
        o.drains = drains;
        o.drain_capacity = 2;
        o.stances = stances;
        o.stance_count = 1;
        o.body = body;
        CHECK_EQ(sf_grid_drain(grid, NULL, &o, NULL, NULL, &r), SF_OK);
        CHECK_EQ(r.drain_count, 2);
        CHECK_NEAR(drains[0].from_mm[0], x, 1);
        CHECK(fabs(drains[1].from_mm[0] - drains[0].from_mm[0]) >= (heavy == 1 ? 12 : 26));
        sf_grid_destroy(grid);
    }
    sf_stance_destroy(stance);
}

static void what_hung_hangs_on(void)
{
    sf_grid *grid = empty_grid(20, 20, 20, 1);
    sf_drain_report r;
    sf_drain_options o = sf_drain_options_default();
    sf_terms terms = sf_terms_default();
    fill(grid, 2, 2, 0, 18, 18, 20, 1);
    fill(grid, 5, 5, 4, 15, 15, 14, 0); // the ceiling hangs
    o.diameter_mm = 3;
    CHECK_EQ(sf_grid_drain(grid, &terms, &o, NULL, NULL, &r), SF_OK);
    CHECK_EQ(r.drained_count, 1);
    CHECK_EQ(r.drains_dropped, 1);
    o.void_min = 2000;
    fill(grid, 2, 2, 0, 18, 18, 4, 1);
    CHECK_EQ(sf_grid_drain(grid, &terms, &o, NULL, NULL, &r), SF_OK);
    CHECK_EQ(r.closed_count, 1);
    CHECK_EQ(r.closed_voxels, 1000);
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(nothing_stays_shut_or_hangs);
    TEST(what_is_not_drained_is_filled);
    TEST(a_rod_passes);
    TEST(voids_drain_into_each_other);
    TEST(aslant_where_straight_is_impossible);
    TEST(through_a_shallow_underside);
    TEST(balance_and_distance);
    TEST(what_hung_hangs_on);
    return test_finish();
}

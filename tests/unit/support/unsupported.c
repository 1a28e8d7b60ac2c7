// SPDX-License-Identifier: MIT
// Why: who changes a shape and must not make anything hang that did not needs to know which voxels
// nothing carried before. They are held against the definition, a layer at a time under every kind
// of rule, and against the count of a check; with them exempt the shape is support-free, and with
// any one less it is not, where there are no bridges.

#include "failing_allocator.h"
#include "law/alive.h"

enum { NX = 12, NY = 9, NZ = 8, COUNT = NX * NY * NZ };

// Layer by layer: what is dead in it while everything below lives or is exempt.
static void tell(const alive_rule *rule, const stack *s, const stack *exempt, int bed, stack *dead)
{
    static stack part, given;
    static int field[STACK_VOXELS];
    stack_clear(dead, NX, NY, NZ);
    stack_clear(&part, NX, NY, NZ);
    stack_clear(&given, NX, NY, NZ);
    if (exempt != NULL) {
        given = *exempt;
    }
    for (int z = 0; z < NZ; z++) {
        memcpy(part.solid + z * NX * NY, s->solid + z * NX * NY, NX * NY);
        alive_field(rule, &part, &given, bed, field);
        for (int i = z * NX * NY; i < (z + 1) * NX * NY; i++) {
            dead->solid[i] = part.solid[i] && field[i] < 0;
            given.solid[i] |= dead->solid[i];
        }
    }
}

static void compare(const alive_rule *rule, const stack *s, const stack *exempt, uint32_t bed_layer)
{
    static stack want, found;
    sf_terms terms = sf_terms_default();
    sf_grid *grid = stack_grid(s), *mask = exempt != NULL ? stack_grid(exempt) : NULL, *out = NULL;
    sf_lattice l = sf_grid_lattice(grid);
    uint64_t count = 0;
    terms.rule = rule->rule;
    terms.bed_layer = bed_layer;
    terms.exempt = mask;
    CHECK_EQ(sf_grid_create(&l, NULL, &out), SF_OK);
    CHECK_EQ(sf_grid_unsupported(grid, &terms, NULL, NULL, out, &count), SF_OK);
    stack_read(&found, out);
    tell(rule, s, exempt, stack_bed(s, bed_layer), &want);
    CHECK(stack_equal(&found, &want));
    CHECK_EQ(count, stack_volume(&want));
    if (exempt == NULL) {
        sf_check_options o = sf_check_options_default();
        sf_check_report r;
        o.rule = rule->rule;
        o.bed_layer = bed_layer;
        CHECK_EQ(sf_grid_check(grid, &o, NULL, NULL, &r, NULL), SF_OK);
        CHECK(r.unsupported_voxels == count ||
              stack_bed(s, bed_layer) != stack_bed(s, SF_BED_AUTO));
        terms.exempt = out;
        CHECK_EQ(sf_grid_feasible(grid, grid, &terms, NULL, NULL, NULL, NULL), SF_OK);
        // With one less something hangs; but exempt voxels can be the ends of a bridge over it.
        int no_bridges = rule->rule.bridge.span_x + rule->rule.bridge.span_y == 0 &&
                         rule->rule.bridge.span_diagonal == 0;
        for (int i = 0; no_bridges && i < COUNT; i += 7) {
            sf_slice slice = sf_grid_slice(out, (uint32_t)(i / NX / NY));
            if (want.solid[i]) {
                uint32_t x = (uint32_t)(i % NX), y = (uint32_t)(i / NX % NY);
                CHECK_EQ(sf_slice_set(slice, x, y, 0), SF_OK);
                CHECK_EQ(sf_grid_feasible(grid, grid, &terms, NULL, NULL, NULL, NULL),
                         SF_ERR_INFEASIBLE);
                CHECK_EQ(sf_slice_set(slice, x, y, 1), SF_OK);
            }
        }
    }
    sf_grid_destroy(grid);
    sf_grid_destroy(mask);
    sf_grid_destroy(out);
}

static void definition_agrees(void)
{
    for (int i = 0; i < 160; i++) {
        static stack s, exempt;
        static alive_rule alive;
        sf_rule rule = alive_rule_by_number(i);
        alive_prepare(&alive, &rule, NZ);
        stack_random_boxes(&s, NX, NY, NZ, 8);
        stack_random(&exempt, NX, NY, NZ, 0.1);
        compare(&alive, &s, NULL, i % 3 == 0 ? 2 : SF_BED_AUTO);
        compare(&alive, &s, &exempt, i % 3 == 1 ? 1 : SF_BED_AUTO);
    }
}

static void failures_change_nothing(void)
{
    static stack s, other;
    sf_rule rule = alive_rule_by_number(14);
    sf_terms terms = sf_terms_default(), bad = terms;
    stack_random_boxes(&s, NX, NY, NZ, 8);
    stack_clear(&other, NX - 1, NY, NZ);
    sf_grid *grid = stack_grid(&s), *out = stack_grid(&s), *small = stack_grid(&other);
    terms.rule = rule;
    sf_status status = SF_ERR_MEMORY;
    for (long at = 0; status != SF_OK && at < 20; at++) {
        failing_allocator f;
        uint64_t count = 7;
        failing_begin(&f, at);
        status = sf_grid_unsupported(grid, &terms, &f.allocator, NULL, out, &count);
        CHECK(status == SF_OK ||
              (status == SF_ERR_MEMORY && count == 7 && sf_grid_equal(grid, out)));
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
    CHECK_EQ(status, SF_OK);
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(sf_grid_unsupported(grid, &terms, NULL, &task, out, NULL), SF_ERR_CANCELLED);
    bad.struct_size = 0;
    CHECK_EQ(sf_grid_unsupported(NULL, &terms, NULL, NULL, out, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_unsupported(grid, NULL, NULL, NULL, out, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_unsupported(grid, &bad, NULL, NULL, out, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_unsupported(grid, &terms, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_unsupported(grid, &terms, NULL, NULL, grid, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_unsupported(grid, &terms, NULL, NULL, small, NULL), SF_ERR_SHAPE);
    terms.exempt = out;
    CHECK_EQ(sf_grid_unsupported(grid, &terms, NULL, NULL, out, NULL), SF_ERR_ARGUMENT);
    sf_grid_destroy(grid);
    sf_grid_destroy(out);
    sf_grid_destroy(small);
}

int main(void)
{
    TEST(definition_agrees);
    TEST(failures_change_nothing);
    return test_finish();
}

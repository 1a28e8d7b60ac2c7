// SPDX-License-Identifier: MIT
// Why: bits past the width are ignored on entry, by operators as by everything else (TRUST 31;
// padding.c has the rest). A bit there that an operator took for a voxel would be matter to land
// on beyond the grid, a culprit that nobody can see, or a cost past the end of the caller's array.

#include "twins.h"

#include <sf/grow.h>
#include <sf/preserve.h>
#include <sf/repair.h>

// A shape and its masks: `other` is all that a mask may be.
typedef struct given {
    sf_grid *shape;
    const sf_grid *other;
    sf_terms terms;
} given;

// Each returns its counts, as bytes that can be compared.
typedef struct counts {
    sf_status status;
    uint64_t of[8];
} counts;

static counts shape_is_grown(const given *g)
{
    sf_grow_report r = {0, 0, 0};
    sf_status status = sf_grid_grow(g->shape, &g->terms, stack_allocator(), NULL, NULL, &r);
    counts c = {status, {r.kept_voxels, r.added_voxels, r.bed_layer}};
    return c;
}

static counts shape_is_repaired(const given *g)
{
    static uint8_t add[130 * 9 * 5], remove[130 * 9 * 5];
    sf_lattice l = sf_grid_lattice(g->shape);
    size_t voxels = (size_t)l.nx * l.ny * l.nz;
    // At the end of their arrays, so that a cost past the last one would be another's.
    uint8_t *a = add + sizeof add - voxels, *r = remove + sizeof remove - voxels;
    for (size_t i = 0; i < voxels; i++) {
        a[i] = (uint8_t)(1 + i % 5);
        r[i] = (uint8_t)(1 + i % 7);
    }
    sf_repair_options options = sf_repair_options_default();
    sf_repair_report out = {0};
    options.terms = g->terms;
    options.add_cost = a;
    options.remove_cost = r;
    sf_status status = sf_grid_repair(g->shape, &options, stack_allocator(), NULL, NULL, &out);
    counts c = {status,
                {out.added_voxels, out.removed_voxels, out.cost, out.first_cost, out.trim_cost,
                 out.grow_cost, out.culprit_count, out.bed_layer}};
    return c;
}

static counts shape_is_preserved(const given *g)
{
    sf_preserve_options options = sf_preserve_options_default();
    sf_preserve_report r = {0, 0, 0, 0};
    options.accept_unsupported = 1;
    sf_status status =
        sf_grid_preserve(g->shape, g->other, &g->terms, &options, stack_allocator(), NULL, &r);
    counts c = {status, {r.removed_voxels, r.kept_voxels, r.lost_outside, r.added_voxels}};
    return c;
}

static counts shape_is_trimmed_on_terms(const given *g)
{
    sf_trim_report r = {0, 0, 0};
    sf_status status = sf_grid_trim_on(g->shape, &g->terms, stack_allocator(), NULL, NULL, &r);
    counts c = {status, {r.kept_voxels, r.removed_voxels, r.bed_layer}};
    return c;
}

// The path of the last voxel of every row, summed up.
static counts paths_are_found(const given *g)
{
    counts c = {SF_OK, {0}};
    sf_lattice l = sf_grid_lattice(g->shape);
    sf_path_map_options options = sf_path_map_options_default();
    sf_path_map *map = NULL;
    sf_voxel path[8];
    sf_path found;
    CHECK_EQ(sf_path_map_create(g->shape, &g->terms, &options, NULL, NULL, &map), SF_OK);
    for (uint32_t z = 0; z < l.nz; z++) {
        for (uint32_t y = 0; y < l.ny; y++) {
            sf_voxel from = {l.nx - 1, y, z};
            sf_status status = sf_path_map_walk(map, from, path, 8, &found);
            c.of[0] += (uint64_t)status;
            for (size_t i = 0; status == SF_OK && i < found.count; i++) {
                CHECK(path[i].x < l.nx);
                c.of[1] = c.of[1] * 31 + path[i].x * 7 + path[i].y;
            }
        }
    }
    sf_path_map_destroy(map);
    return c;
}

static void operators_work(twins t, const sf_rule *rule)
{
    static counts (*const all[])(const given *) = {shape_is_grown, shape_is_repaired,
                                                   shape_is_preserved, shape_is_trimmed_on_terms,
                                                   paths_are_found};
    sf_lattice l = sf_grid_lattice(t.clean);
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        twins other = make_twins((int)l.nx, (int)l.ny, (int)l.nz);
        given a = {NULL, other.clean, sf_terms_default()};
        given b = {NULL, other.soiled, sf_terms_default()};
        a.terms.rule = b.terms.rule = *rule;
        if (test_random_below(2) == 0) {
            a.terms.forbid = other.clean;
            b.terms.forbid = other.soiled;
        }
        CHECK_EQ(sf_grid_clone(t.clean, stack_allocator(), &a.shape), SF_OK);
        CHECK_EQ(sf_grid_clone(t.soiled, stack_allocator(), &b.shape), SF_OK);
        soil_grid(b.shape);
        counts p = all[i](&a), q = all[i](&b);
        CHECK_EQ(p.status, q.status);
        for (size_t j = 0; j < sizeof p.of / sizeof *p.of; j++) {
            CHECK_EQ(p.of[j], q.of[j]);
        }
        CHECK(sf_grid_equal(a.shape, b.shape));
        sf_grid_destroy(a.shape);
        sf_grid_destroy(b.shape);
        end_twins(other);
    }
}

static void by_every_rule(twins t)
{
    for (int i = 0; i < 7; i++) {
        sf_rule rule = rule_by_number(i);
        operators_work(t, &rule);
    }
}

static void padding_has_no_say_in_operators(void)
{
    with_twins(by_every_rule);
}

int main(void)
{
    TEST(padding_has_no_say_in_operators);
    return test_finish();
}

// SPDX-License-Identifier: MIT
// Why: a path finder trusts windows where a search layer by layer would look at everything. Here
// what it finds on grids that no oracle of bytes could take, ends on large empty beds among them,
// is compared with what that search finds (ALGORITHMS 2.2).

#include "law/stack.h"

#include "support/grow/search.h"

// Boxes, beams and grains in a grid that no oracle of bytes could take; few leave the bed to most.
static sf_grid *random_grid(const sf_lattice *lattice, int boxes)
{
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(lattice, NULL, &grid), SF_OK);
    for (int i = 0; i < boxes; i++) {
        uint32_t x = test_random_below(lattice->nx), y = test_random_below(lattice->ny);
        uint32_t z = test_random_below(lattice->nz), most = i % 4 > 0 ? 4 : 24;
        uint32_t x1 = x + 1 + test_random_below(most), y1 = y + 1 + test_random_below(most);
        uint32_t z1 = z + 1 + test_random_below(most);
        sf_rect rect = {x, y, x1 < lattice->nx ? x1 : lattice->nx,
                        y1 < lattice->ny ? y1 : lattice->ny};
        for (; z < z1 && z < lattice->nz; z++) {
            CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, z), rect, 1), SF_OK);
        }
    }
    return grid;
}

static void compare(const sf_grid *grid, const sf_terms *terms, sf_landing landing, int count)
{
    static sf_voxel path[128], chain[128];
    sf_lattice lattice = sf_grid_lattice(grid);
    sf_path_finder *finder = NULL;
    sfi_site site;
    sfi_bed bed = {0};
    sfi_progress progress = sfi_progress_begin(NULL);
    sfi_stage stage = {NULL, &progress, 0, lattice.nz};
    CHECK_EQ(sf_path_finder_create(grid, terms, landing, NULL, NULL, &finder), SF_OK);
    CHECK_EQ(sfi_site_open(&site, grid, terms, landing, NULL, &stage), SF_OK);
    for (int i = 0; i < count; i++) {
        sf_voxel from = {test_random_below(lattice.nx), test_random_below(lattice.ny),
                         site.bed + 1 + test_random_below(lattice.nz - site.bed - 1)};
        sf_path a, b;
        int is_held = sf_slice_get(sfi_mask_slice(terms->exempt, from.z), from.x, from.y);
        sf_status status = sfi_descend(&site, &bed, from, chain, &b);
        CHECK_EQ(sf_path_finder_find(finder, from, path, 128, &a), is_held ? SF_OK : status);
        if (is_held || status != SF_OK) {
            continue; // a held voxel needs no search
        }
        CHECK(a.count == b.count && a.end == b.end && a.cost == b.cost);
        CHECK(a.landing.x == b.landing.x && a.landing.y == b.landing.y &&
              a.landing.z == b.landing.z && a.bed_square == b.bed_square);
    }
    sfi_bed_destroy(&bed, &site);
    sfi_site_close(&site);
    sf_path_finder_destroy(finder);
}

// Now and then masks, thin enough for paths to be found with and without regard to them.
static void add_masks(int i, const sf_lattice *lattice, sf_terms *terms, sf_grid *masks[2])
{
    for (int m = 0; m < 2; m++) {
        CHECK_EQ(sf_grid_create(lattice, NULL, &masks[m]), SF_OK);
        for (uint32_t k = 0; k < (m == 0 ? 30u : 2000u); k++) {
            sf_slice slice = sf_grid_slice(masks[m], test_random_below(lattice->nz));
            uint32_t x = test_random_below(lattice->nx), y = test_random_below(lattice->ny);
            CHECK_EQ(sf_slice_set(slice, x, y, 1), SF_OK);
        }
    }
    terms->exempt = i % 5 == 1 || i % 5 == 3 ? masks[0] : NULL;
    terms->forbid = i % 5 == 2 || i % 5 == 3 ? masks[1] : NULL;
}

static void a_finder_finds_what_a_search_finds(void)
{
    static const sf_rule_kind kinds[6] = {SF_RULE_SLACK, SF_RULE_DISK,    SF_RULE_SLACK,
                                          SF_RULE_SLACK, SF_RULE_OCTAGON, SF_RULE_BOX3};
    for (int i = 0; i < 60; i++) {
        double heights[70];
        uint64_t table[140];
        sf_lattice lattice = {150, 70, 70, 0.1, i % 12 == 2 ? 0.14 : 0.1, 0.1, NULL, {0}};
        sf_grid *masks[2];
        for (int k = 0; k < 70; k++) {
            heights[k] = 0.1 + 0.1 * test_random_unit();
        }
        lattice.heights_mm = i % 12 == 0 ? heights : NULL;
        sf_terms terms = sf_terms_default();
        double radians = 0.8 + 0.3 * test_random_unit();
        CHECK_EQ(sf_rule_make(kinds[i % 6], radians, &lattice, table, &terms.rule, NULL), SF_OK);
        sf_grid *grid = random_grid(&lattice, i % 3 == 2 ? 40 : 5);
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, 0), i % 2 == 0 ? 0 : 149, (uint32_t)i % 70, 1),
                 SF_OK);
        add_masks(i, &lattice, &terms, masks);
        compare(grid, &terms, i % 7 == 0 ? SF_LANDING_ALIVE : SF_LANDING_ANY, 200);
        sf_grid_destroy(grid);
        sf_grid_destroy(masks[0]);
        sf_grid_destroy(masks[1]);
    }
}

int main(void)
{
    TEST(a_finder_finds_what_a_search_finds);
    return test_finish();
}

// SPDX-License-Identifier: MIT
// Why: the best closed set of a forest is claimed to be found exactly. All closed sets of small
// forests are tried: of random ones, and of those that carving grows in small random grids, whose
// supporters must also be what they are said to be.

#include "balance/forest/places.h"

#include "law/alive.h"

// The least weight of all sets that are closed and hold what is forced.
static int64_t brute_force(uint32_t count, const uint32_t *next, const int32_t *weight,
                           const uint8_t *state)
{
    int64_t best = INT64_MAX;
    for (uint32_t set = 0; set < 1u << count; set++) {
        int64_t sum = 0;
        int good = 1;
        for (uint32_t i = 0; i < count && good; i++) {
            int in = (int)(set >> i & 1);
            good = in ? next[i] == SFI_PLACE_ROOT || (set >> next[i] & 1) != 0
                      : (state[i] & SFI_PLACE_FORCED) == 0;
            sum += in ? weight[i] : 0;
        }
        best = good && sum < best ? sum : best;
    }
    return best;
}

// Solve, and compare.
static void check_forest(uint32_t count, const uint32_t *next, const int32_t *weight,
                         uint8_t *state)
{
    int64_t gain[32], best = brute_force(count, next, weight, state), sum = 0;
    uint8_t forced[32];
    memcpy(forced, state, count);
    sfi_closure_least(count, next, weight, gain, state);
    for (uint32_t i = 0; i < count; i++) {
        if ((state[i] & SFI_PLACE_KEPT) != 0) {
            sum += weight[i];
            CHECK(next[i] == SFI_PLACE_ROOT || (state[next[i]] & SFI_PLACE_KEPT) != 0);
        } else {
            CHECK((forced[i] & SFI_PLACE_FORCED) == 0);
        }
    }
    CHECK_EQ(sum, best);
}

static void random_forests(void)
{
    for (int round = 0; round < 400; round++) {
        uint32_t count = 1 + test_random_below(14), next[32];
        int32_t weight[32];
        uint8_t state[32];
        for (uint32_t i = 0; i < count; i++) {
            next[i] = i == 0 || test_random_below(4) == 0 ? SFI_PLACE_ROOT : test_random_below(i);
            weight[i] = (int32_t)test_random_below(9) - 4;
            state[i] = test_random_below(6) == 0 ? SFI_PLACE_FORCED : 0;
        }
        check_forest(count, next, weight, state);
    }
}

// Each place rests on one below it, in the rule's element.
static void check_supporters(const sfi_places *p)
{
    const sfi_interior *in = p->in;
    for (uint32_t k = 0; k < in->lattice.nz; k++) {
        sf_element e = {0, {0}};
        CHECK(k == 0 || sf_rule_element(&in->plain, k - 1, &e) == SF_OK);
        for (uint32_t i = 0; i < in->lattice.nx * in->lattice.ny; i++) {
            uint32_t x = i % in->lattice.nx, y = i / in->lattice.nx;
            if (!sf_slice_get(sf_grid_slice(in->places, k), x, y)) {
                continue;
            }
            uint32_t next = p->next[sfi_place_at(p, k, x, y)], found = 0;
            if (next == SFI_PLACE_ROOT) {
                CHECK(sf_slice_get(sf_grid_slice(in->rooted, k), x, y));
                continue;
            }
            for (uint32_t j = 0; j < in->lattice.nx * in->lattice.ny; j++) {
                uint32_t ux = j % in->lattice.nx, uy = j / in->lattice.nx;
                if (sf_slice_get(sf_grid_slice(in->places, k - 1), ux, uy) &&
                    sfi_place_at(p, k - 1, ux, uy) == next) {
                    found = 1;
                    CHECK(element_has(&e, (int)ux - (int)x, (int)uy - (int)y));
                }
            }
            CHECK(found);
        }
    }
}

static sf_status grow(sfi_places *p, const sfi_lever *lever)
{
    sfi_places_weigh(p, lever);
    sf_status status = sfi_places_route(p);
    status = status == SF_OK ? sfi_places_force(p) : status;
    return status == SF_OK ? sfi_places_route(p) : status;
}

static sfi_lever random_lever(void)
{
    sfi_lever l = {{0, 0, 0}, 0};
    for (int i = 0; i < 3; i++) {
        l.pull[i] = test_random_unit() - 0.5;
    }
    l.base = -0.15 * (l.pull[0] + l.pull[1] + l.pull[2]) + 0.1 * (test_random_unit() - 0.5);
    return l;
}

// One small grid: returns 1 where its forest was small enough to try all sets.
static int one_grid(int round)
{
    static stack s, wall;
    sfi_interior in;
    sfi_places p;
    sf_terms terms = sf_terms_default();
    int small = 0, width = 1 + (int)test_random_below(2);
    alive_rule alive;
    terms.rule = alive_rule_by_number(round % 5);
    alive_prepare(&alive, &terms.rule, 4);
    stack_random(&s, 3 + (int)test_random_below(2), 2 + (int)test_random_below(2), 4, 0.8);
    stack_random(&wall, s.nx, s.ny, s.nz, 0.4);
    stack_combine(&wall, &s, &wall, STACK_AND);
    sf_grid *solid = stack_grid(&s), *stays = stack_grid(&wall);
    CHECK_EQ(sfi_interior_create(solid, stays, &terms, 0, (uint32_t)width, NULL, NULL, &in), SF_OK);
    CHECK_EQ(sfi_places_create(&in, NULL, &p), SF_OK);
    sfi_lever first = random_lever(), second = random_lever();
    CHECK_EQ(grow(&p, &first), SF_OK);
    check_supporters(&p);
    if (p.count > 0 && p.count <= 16) {
        small = 1;
        sfi_places_weigh(&p, &second);
        check_forest(p.count, p.next, p.weight, p.state);
    }
    sfi_places_destroy(&p);
    sfi_interior_destroy(&in);
    sf_grid_destroy(solid);
    sf_grid_destroy(stays);
    return small;
}

static void forests_of_grids(void)
{
    int small = 0;
    for (int round = 0; round < 1500; round++) {
        small += one_grid(round);
    }
    CHECK(small > 500);
}

int main(void)
{
    TEST(random_forests);
    TEST(forests_of_grids);
    return test_finish();
}

// SPDX-License-Identifier: MIT
// Why: the best closed set of a forest is claimed to be found exactly. All closed sets of small
// forests are tried: of random ones, and of those that carving grows in small random grids, whose
// supporters must also be what they are said to be. Struts have no such promise; of small grids
// they must be no dearer than one greedy try, and nearly always the cheapest of all sets that
// carry.

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

// --- Struts --------------------------------------------------------------------------------------

enum { STRUT_PLACES = 12, STRUT_ASKED = 64 };

// A small forest as masks of places: what may carry each place (0: rooted) and each asked voxel.
typedef struct few {
    uint32_t count, asked_count, below[STRUT_PLACES], carriers[STRUT_ASKED];
    int64_t cost[STRUT_PLACES];
} few;

// Places of layer k one of whose `width` x `width` voxels lies in the element around (x, y).
static uint32_t carriers_of(const sfi_places *p, uint32_t k, uint32_t x, uint32_t y, uint32_t width)
{
    sf_element e = {0, {0}};
    uint32_t found = 0;
    CHECK_EQ(sf_rule_element(&p->in->plain, k, &e), SF_OK);
    for (uint32_t i = 0; i < p->in->lattice.nx * p->in->lattice.ny; i++) {
        uint32_t ux = i % p->in->lattice.nx, uy = i / p->in->lattice.nx;
        if (!sf_slice_get(sf_grid_slice(p->in->places, k), ux, uy)) {
            continue;
        }
        for (uint32_t j = 0; j < width * width; j++) {
            if (element_has(&e, (int)(ux + j % width) - (int)x, (int)(uy + j / width) - (int)y)) {
                found |= UINT32_C(1) << sfi_place_at(p, k, ux, uy);
            }
        }
    }
    return found;
}

static int look_at_few(const sfi_places *p, few *f)
{
    const sf_lattice *l = &p->in->lattice;
    memset(f, 0, sizeof *f);
    f->count = p->count;
    for (uint32_t v = 0; v < l->nx * l->ny * l->nz && p->count <= STRUT_PLACES; v++) {
        uint32_t x = v % l->nx, y = v / l->nx % l->ny, k = v / (l->nx * l->ny);
        if (sf_slice_get(sf_grid_slice(p->in->places, k), x, y)) {
            uint32_t i = sfi_place_at(p, k, x, y);
            f->cost[i] = p->weight[i] > 0 ? p->weight[i] : 0;
            f->below[i] = sf_slice_get(sf_grid_slice(p->in->rooted, k), x, y)
                              ? 0
                              : carriers_of(p, k - 1, x, y, 1);
        }
        if (sf_slice_get(sf_grid_slice(p->in->wall, k), x, y) &&
            !sf_slice_get(sf_grid_slice(p->in->held, k), x, y)) {
            CHECK(f->asked_count < STRUT_ASKED);
            f->carriers[f->asked_count++] = carriers_of(p, k - 1, x, y, p->in->width);
        }
    }
    return p->count > 0 && p->count <= STRUT_PLACES && f->asked_count > 0;
}

static int carries_all(const few *f, uint32_t set)
{
    for (uint32_t i = 0; i < f->count; i++) {
        if ((set >> i & 1) != 0 && f->below[i] != 0 && (f->below[i] & set) == 0) {
            return 0;
        }
    }
    for (uint32_t a = 0; a < f->asked_count; a++) {
        if ((f->carriers[a] & set) == 0) {
            return 0;
        }
    }
    return 1;
}

static int64_t cost_of(const few *f, uint32_t set)
{
    int64_t sum = 0;
    for (uint32_t i = 0; i < f->count; i++) {
        sum += (set >> i & 1) != 0 ? f->cost[i] : 0;
    }
    return sum;
}

// Places that are forced, as a mask, with those that they rest on.
static uint32_t forced(const sfi_places *p)
{
    uint32_t set = 0;
    for (uint32_t i = p->count; i-- > 0;) {
        set |= (p->state[i] & SFI_PLACE_FORCED) != 0 ? UINT32_C(1) << i : 0;
        set |= (set >> i & 1) != 0 && p->next[i] != SFI_PLACE_ROOT ? UINT32_C(1) << p->next[i] : 0;
    }
    return set;
}

typedef struct tally {
    int forests, once, tries; // all; where one try, and where many, found the cheapest struts
} tally;

// Struts carry what is asked; many tries are no dearer than one; none is cheaper than the least of
// all sets.
static void check_struts(sfi_places *p, tally *t)
{
    few f;
    int64_t least = INT64_MAX;
    CHECK_EQ(sfi_places_route(p, NULL), SF_OK);
    CHECK_EQ(sfi_places_force(p), SF_OK);
    CHECK_EQ(sfi_places_route(p, NULL), SF_OK);
    int small = look_at_few(p, &f);
    int64_t once = small ? cost_of(&f, forced(p)) : 0;
    CHECK_EQ(sfi_places_scaffold(p), SF_OK);
    if (!small) {
        return;
    }
    int64_t tries = cost_of(&f, forced(p));
    CHECK(carries_all(&f, forced(p)));
    for (uint32_t set = 0; set < UINT32_C(1) << f.count; set++) {
        int64_t cost = cost_of(&f, set);
        least = cost < least && carries_all(&f, set) ? cost : least;
    }
    CHECK(least <= tries && tries <= once);
    t->forests++;
    t->once += once == least;
    t->tries += tries == least;
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
static int one_grid(int round, tally *t)
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
    sfi_places_weigh(&p, &first);
    check_struts(&p, t);
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
    tally t = {0, 0, 0};
    for (int round = 0; round < 1500; round++) {
        small += one_grid(round, &t);
    }
    CHECK(small > 500);
    printf("# of %d forests, one try found the cheapest struts in %d, many in %d\n", t.forests,
           t.once, t.tries);
    CHECK(t.forests > 100 && t.tries >= t.once && t.tries >= 0.98 * t.forests);
}

int main(void)
{
    TEST(random_forests);
    TEST(forests_of_grids);
    return test_finish();
}

// SPDX-License-Identifier: MIT
// Why: a price that nobody can pay is no price. What sf_findings_cost() says is held against a set
// of voxels that really fixes the finding, against the cheapest path where a region is one voxel
// (ALGORITHMS 2.1), and against all sets that there are where a grid is tiny; ranks against the
// definition; and a call that fails leaves everything as it was (P2).

#include "failing_allocator.h"
#include "law/stack.h"

#include <sf/finding.h>

#define FINDINGS 2048
#define FAR 1000000

typedef struct costed {
    sf_check_report report;
    sf_finding findings[FINDINGS];
    sf_finding_cost costs[FINDINGS];
    size_t count;
} costed;

static void find_costs(costed *c, const sf_grid *grid, const sf_terms *terms, sf_grid *added)
{
    sf_check_options options = sf_check_options_default();
    options.rule = terms->rule;
    options.bed_layer = terms->bed_layer;
    options.findings = c->findings;
    options.finding_capacity = FINDINGS;
    CHECK_EQ(sf_grid_check(grid, &options, stack_allocator(), NULL, &c->report, &c->count), SF_OK);
    CHECK_EQ(sf_findings_cost(grid, terms, c->findings, c->count, stack_allocator(), NULL, c->costs,
                              added),
             SF_OK);
}

static sf_grid *empty_like(const stack *s)
{
    sf_lattice lattice = stack_lattice(s->nx, s->ny, s->nz);
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, stack_allocator(), &grid), SF_OK);
    return grid;
}

// Voxels that must be added below (x, y, z) so that it is carried; straight from the definition.
static int path_cost(const stack *s, const stack *barred, const sf_rule *rule, int bed, int x,
                     int y, int z)
{
    static int cost[STACK_VOXELS];
    int layer = s->nx * s->ny, target = (z * s->ny + y) * s->nx + x;
    for (int i = bed * layer; i <= target; i++) {
        int px = i % s->nx, py = i % layer / s->nx, pz = i / layer;
        cost[i] = pz == bed ? 0 : FAR;
        sf_element e = {0, {0}};
        if (pz > bed) {
            e = stack_step(rule, pz - 1);
        }
        for (int j = pz > bed ? (pz - 1) * layer : 0; pz > bed && j < pz * layer; j++) {
            if (element_has(&e, j % s->nx - px, j % layer / s->nx - py)) {
                int via = s->solid[j] ? 0 : barred->solid[j] ? FAR : cost[j] + 1;
                cost[i] = via < cost[i] ? via : cost[i];
            }
        }
    }
    return cost[target];
}

// Whatever the rule: with what is added the shape needs no supports, and the sums are right.
static void fixed(const stack *s, const sf_terms *terms, const costed *c, const sf_grid *added)
{
    static stack more, both;
    sf_check_options options = sf_check_options_default();
    sf_check_report report;
    uint64_t sum = 0;
    int possible = 1;
    for (size_t i = 0; i < c->count; i++) {
        CHECK_EQ(c->costs[i].trim_voxels, c->findings[i].volume);
        CHECK(c->costs[i].grow_voxels > 0);
        possible = possible && c->costs[i].grow_voxels != SF_COST_NONE;
        sum += c->costs[i].grow_voxels;
    }
    stack_read(&more, added);
    stack_combine(&both, &more, s, STACK_AND);
    CHECK_EQ(stack_volume(&both), 0);
    if (!possible) {
        return;
    }
    CHECK(stack_volume(&more) <= sum);
    CHECK(c->count != 1 || stack_volume(&more) == sum);
    stack_combine(&both, &more, s, STACK_OR);
    sf_grid *grid = stack_grid(&both);
    options.rule = terms->rule;
    options.bed_layer = (uint32_t)stack_bed(s, terms->bed_layer);
    if (stack_volume(s) > 0) {
        CHECK_EQ(sf_grid_check(grid, &options, stack_allocator(), NULL, &report, NULL), SF_OK);
        CHECK(report.support_free);
    }
    sf_grid_destroy(grid);
}

static sf_rule any_rule(int i)
{
    sf_lattice lattice = stack_lattice(8, 8, 8);
    sf_rule rule = rule_by_number(i);
    if (i % 9 >= 7) {
        rule = rule_of_angle(SF_RULE_SLACK, i % 9 == 7 ? 35.0 : 58.0);
    }
    if (i % 4 == 3) {
        CHECK_EQ(sf_rule_set_bridges(&rule, 0.4, 0.1, &lattice, NULL), SF_OK);
    }
    return rule;
}

static void added_voxels_fix_it(void)
{
    static stack s;
    static costed c;
    for (int i = 0; i < 700; i++) {
        sf_terms terms = sf_terms_default();
        int nx = i % 10 == 0 ? stack_wide() : 1 + (int)test_random_below(14);
        int ny = 1 + (int)test_random_below(nx > 60 ? 3 : 9);
        if (i % 2 == 0) {
            stack_random_boxes(&s, nx, ny, 9, 6);
        } else {
            stack_random(&s, nx, ny, 9, 0.3 * test_random_unit());
        }
        terms.rule = any_rule(i);
        terms.bed_layer = i % 3 == 0 ? test_random_below(4) : SF_BED_AUTO;
        sf_grid *grid = stack_grid(&s), *added = empty_like(&s);
        find_costs(&c, grid, &terms, added);
        fixed(&s, &terms, &c, added);
        sf_grid_destroy(grid);
        sf_grid_destroy(added);
    }
}

// A region of one voxel costs its closest supporting path, whatever is barred.
static void one_voxel_is_exact(void)
{
    static stack s, barred;
    static costed c;
    int exact = 0;
    for (int i = 0; i < 400; i++) {
        sf_terms terms = sf_terms_default();
        stack_random(&s, 9, 6, 8, 0.05);
        stack_random(&barred, 9, 6, 8, i % 2 == 0 ? 0.0 : 0.5);
        terms.rule = rule_by_number(i);
        terms.bed_layer = i % 3 == 0 ? test_random_below(3) : SF_BED_AUTO;
        sf_grid *grid = stack_grid(&s), *forbid = stack_grid(&barred), *added = empty_like(&s);
        terms.forbid = forbid;
        find_costs(&c, grid, &terms, added);
        int bed = stack_bed(&s, terms.bed_layer);
        for (size_t f = 0; f < c.count; f++) {
            const sf_finding *finding = &c.findings[f];
            if (finding->area != 1 || finding->volume != 1) {
                continue; // the box may be wider than the region
            }
            int z = (int)finding->layer, best = FAR;
            if (z > bed) {
                best = path_cost(&s, &barred, &terms.rule, bed, (int)finding->box.x0,
                                 (int)finding->box.y0, z);
            }
            CHECK_EQ(c.costs[f].grow_voxels, best >= FAR ? SF_COST_NONE : (uint64_t)best);
            exact++;
        }
        static stack drawn;
        stack_read(&drawn, added);
        stack_combine(&drawn, &drawn, &barred, STACK_AND);
        CHECK_EQ(stack_volume(&drawn), 0);
        sf_grid_destroy(grid);
        sf_grid_destroy(forbid);
        sf_grid_destroy(added);
    }
    CHECK(exact > 500);
}

// Where only `act` may grow, nothing else does; where nothing may, there is no price.
static void masks_are_kept(void)
{
    static stack s, act, drawn;
    static costed c;
    sf_terms terms = sf_terms_default();
    stack_random(&s, 9, 9, 8, 0.1);
    stack_random(&act, 9, 9, 8, 0.7);
    sf_grid *grid = stack_grid(&s), *mask = stack_grid(&act), *added = empty_like(&s);
    terms.act = mask;
    find_costs(&c, grid, &terms, added);
    stack_read(&drawn, added);
    CHECK(stack_volume(&drawn) > 0);
    CHECK(stack_within(&drawn, &act));
    stack_clear(&act, 9, 9, 8);
    stack_write(&act, mask);
    find_costs(&c, grid, &terms, added);
    CHECK(c.count > 0);
    for (size_t i = 0; i < c.count; i++) {
        CHECK(c.costs[i].grow_voxels == SF_COST_NONE);
    }
    CHECK_EQ(sf_grid_popcount(added), 0);
    sf_grid_destroy(grid);
    sf_grid_destroy(mask);
    sf_grid_destroy(added);
}

// The least set of voxels that fixes the only finding of a row, by trying all; layers of 5 x 1.
static int least(const stack *s, int top)
{
    int best = FAR, places = 5 * top;
    for (unsigned set = 0; set < 1u << places; set++) {
        static stack t;
        int size = 0, good = 1;
        t = *s;
        for (int i = 0; i < places; i++) {
            size += (int)(set >> i & 1);
            good = good && !((set >> i & 1) && s->solid[i]);
            t.solid[i] = (uint8_t)(t.solid[i] | (set >> i & 1));
        }
        for (int z = 1; good && z <= top && size < best; z++) {
            for (int x = 0; x < 5; x++) {
                // Matter as drawn below the region may hang: that is another finding's matter.
                int judged = z == top ? stack_get(s, x, 0, z)
                                      : stack_get(&t, x, 0, z) && !stack_get(s, x, 0, z);
                int held = stack_get(&t, x - 1, 0, z - 1) || stack_get(&t, x, 0, z - 1) ||
                           stack_get(&t, x + 1, 0, z - 1);
                good = good && (!judged || held);
            }
        }
        best = good && size < best ? size : best;
    }
    return best;
}

static void near_the_least(void)
{
    static stack s;
    static costed c;
    long cost = 0, optimum = 0;
    for (int i = 0; i < 60; i++) {
        sf_terms terms = sf_terms_default();
        stack_random(&s, 5, 1, 4, 0.1);
        for (int x = 0; x < 5; x++) {
            *stack_at(&s, x, 0, 3) = x >= i % 3 && x < 3 + i % 3;
        }
        terms.bed_layer = 0;
        sf_grid *grid = stack_grid(&s);
        find_costs(&c, grid, &terms, NULL);
        if (c.count > 0 && c.findings[c.count - 1].layer == 3) {
            int sum = 0, best = least(&s, 3);
            for (size_t f = 0; f < c.count; f++) {
                sum += c.findings[f].layer == 3 ? (int)c.costs[f].grow_voxels : 0;
            }
            CHECK(sum >= best);
            cost += sum;
            optimum += best;
        }
        sf_grid_destroy(grid);
    }
    printf("# greedy %ld voxels, least %ld\n", cost, optimum);
    CHECK(optimum > 0);
    CHECK(4 * cost <= 5 * optimum);
}

// A roof far above the bed stands on a tree, not on a forest of poles.
static void a_roof_stands_on_a_tree(void)
{
    static stack s;
    static costed c;
    sf_terms terms = sf_terms_default();
    stack_clear(&s, 25, 25, 40);
    *stack_at(&s, 0, 0, 0) = 1;
    for (int i = 0; i < 21 * 21; i++) {
        *stack_at(&s, 2 + i % 21, 2 + i / 21, 39) = 1;
    }
    sf_grid *grid = stack_grid(&s);
    find_costs(&c, grid, &terms, NULL);
    CHECK_EQ(c.count, 1);
    // 7 x 7 poles would be 39 * 49 = 1911 voxels.
    CHECK(c.costs[0].grow_voxels >= 49 + 38);
    CHECK(c.costs[0].grow_voxels < 400);
    printf("# a roof of 441 voxels, 38 layers up: %llu\n",
           (unsigned long long)c.costs[0].grow_voxels);
    sf_grid_destroy(grid);
}

static void ranks(void)
{
    static sf_finding findings[300];
    static sf_finding_cost costs[300];
    static uint32_t order[300];
    for (int round = 0; round < 40; round++) {
        size_t count = test_random_below(300);
        for (size_t i = 0; i < count; i++) {
            findings[i].cause = test_random_below(2) ? SF_FINDING_ROOT : 0;
            costs[i].trim_voxels = test_random_below(9);
            costs[i].grow_voxels = i % 5 == 0 ? SF_COST_NONE : test_random_below(9);
        }
        CHECK_EQ(sf_findings_rank(findings, costs, count, order), SF_OK);
        static uint8_t seen[300];
        memset(seen, 0, sizeof seen);
        for (size_t i = 0; i < count; i++) {
            seen[order[i]]++;
            if (i == 0) {
                continue;
            }
            const sf_finding_cost *a = &costs[order[i - 1]], *b = &costs[order[i]];
            uint64_t p = a->trim_voxels < a->grow_voxels ? a->trim_voxels : a->grow_voxels;
            uint64_t q = b->trim_voxels < b->grow_voxels ? b->trim_voxels : b->grow_voxels;
            int follows_a = findings[order[i - 1]].cause != SF_FINDING_ROOT;
            int follows_b = findings[order[i]].cause != SF_FINDING_ROOT;
            CHECK(p > q || (p == q && (follows_a < follows_b ||
                                       (follows_a == follows_b && order[i - 1] < order[i]))));
        }
        for (size_t i = 0; i < count; i++) {
            CHECK_EQ(seen[i], 1);
        }
    }
    CHECK_EQ(sf_findings_rank(NULL, costs, 1, order), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_findings_rank(findings, NULL, 1, order), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_findings_rank(findings, costs, 1, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_findings_rank(NULL, NULL, 0, NULL), SF_OK);
}

typedef struct watch {
    int calls, cancel_at;
    double last;
    sf_task *task;
} watch;

static void watching(void *user, double fraction)
{
    watch *w = user;
    CHECK(fraction >= w->last && fraction <= 1);
    w->last = fraction;
    if (++w->calls == w->cancel_at) {
        sf_task_cancel(w->task);
    }
}

static void bad_arguments(const sf_grid *grid, const sf_terms *terms, costed *c, sf_grid *added)
{
    static sf_finding other[FINDINGS];
    const sf_finding *f = c->findings;
    sf_finding_cost *out = c->costs;
    sf_terms bad = *terms;
    bad.bed_layer = 8;
    CHECK_EQ(sf_findings_cost(NULL, terms, f, 1, stack_allocator(), NULL, out, added),
             SF_ERR_ARGUMENT);
    CHECK_EQ(sf_findings_cost(grid, NULL, f, 1, stack_allocator(), NULL, out, added),
             SF_ERR_ARGUMENT);
    CHECK_EQ(sf_findings_cost(grid, terms, NULL, 1, stack_allocator(), NULL, out, added),
             SF_ERR_ARGUMENT);
    CHECK_EQ(sf_findings_cost(grid, terms, f, 1, stack_allocator(), NULL, NULL, added),
             SF_ERR_ARGUMENT);
    CHECK_EQ(sf_findings_cost(grid, &bad, f, 1, stack_allocator(), NULL, out, added),
             SF_ERR_ARGUMENT);
    bad = *terms;
    bad.forbid = added;
    CHECK_EQ(sf_findings_cost(grid, &bad, f, 1, stack_allocator(), NULL, out, added),
             SF_ERR_ARGUMENT);
    // Findings of something else: one too many, another area, another layer.
    for (int i = 0; i < 3; i++) {
        memcpy(other, c->findings, sizeof other);
        other[c->count] = other[c->count - 1];
        other[3].area += i == 1;
        other[3].layer += i == 2;
        CHECK_EQ(sf_findings_cost(grid, terms, other, c->count + (i == 0), stack_allocator(), NULL,
                                  out, added),
                 SF_ERR_ARGUMENT);
    }
}

static void cancelled(const sf_grid *grid, const sf_terms *terms, costed *c, sf_grid *added)
{
    for (int cancel_at = 1; cancel_at < 7; cancel_at++) {
        sf_task task = sf_task_default();
        watch w = {0, cancel_at, 0, &task};
        task.progress = watching;
        task.user = &w;
        CHECK_EQ(sf_findings_cost(grid, terms, c->findings, c->count, stack_allocator(), &task,
                                  c->costs, added),
                 SF_ERR_CANCELLED);
    }
}

static void failing_calls_change_nothing(void)
{
    static stack s, drawn, drawn_before;
    static costed c, before;
    sf_terms terms = sf_terms_default();
    stack_random(&s, 20, 10, 8, 0.15);
    sf_grid *grid = stack_grid(&s), *added = empty_like(&s);
    terms.rule = any_rule(7);
    find_costs(&c, grid, &terms, NULL);
    memset(c.costs, 0x5a, sizeof c.costs);
    stack_random(&drawn_before, 20, 10, 8, 0.5);
    stack_write(&drawn_before, added);
    before = c;
    CHECK(c.count > 10);
    bad_arguments(grid, &terms, &c, added);
    cancelled(grid, &terms, &c, added);
    failing_allocator a;
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status == SF_ERR_MEMORY && k < 100; k++) {
        CHECK(memcmp(&c, &before, sizeof c) == 0);
        stack_read(&drawn, added);
        CHECK(stack_equal(&drawn, &drawn_before));
        failing_begin(&a, k);
        status =
            sf_findings_cost(grid, &terms, c.findings, c.count, &a.allocator, NULL, c.costs, added);
        CHECK_EQ(a.live, 0);
        CHECK_EQ(a.faults, 0);
    }
    CHECK_EQ(status, SF_OK);
    CHECK(a.requests > 10);
    sf_grid_destroy(grid);
    sf_grid_destroy(added);
}

// A shorter array of findings gets the same costs; none at all is fine.
static void fewer_findings(void)
{
    static stack s;
    static costed c;
    static sf_finding_cost shorter[FINDINGS];
    sf_terms terms = sf_terms_default();
    stack_random(&s, 20, 10, 8, 0.15);
    sf_grid *grid = stack_grid(&s), *added = stack_grid(&s);
    find_costs(&c, grid, &terms, NULL);
    CHECK_EQ(sf_findings_cost(grid, &terms, c.findings, c.count / 2, stack_allocator(), NULL,
                              shorter, NULL),
             SF_OK);
    for (size_t i = 0; i < c.count / 2; i++) {
        CHECK_EQ(shorter[i].trim_voxels, c.costs[i].trim_voxels);
        CHECK_EQ(shorter[i].grow_voxels, c.costs[i].grow_voxels);
    }
    CHECK_EQ(sf_findings_cost(grid, &terms, NULL, 0, stack_allocator(), NULL, NULL, added), SF_OK);
    CHECK_EQ(sf_grid_popcount(added), 0);
    sf_grid_destroy(grid);
    sf_grid_destroy(added);
}

int main(void)
{
    TEST(added_voxels_fix_it);
    TEST(one_voxel_is_exact);
    TEST(masks_are_kept);
    TEST(near_the_least);
    TEST(a_roof_stands_on_a_tree);
    TEST(ranks);
    TEST(failing_calls_change_nothing);
    TEST(fewer_findings);
    return test_finish();
}

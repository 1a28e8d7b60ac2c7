// SPDX-License-Identifier: MIT
// TRUST items 33-43: adding and removing a brush with a trim after it. A brush D is added to A by
// trim(A + D) and removed by trim(A - D). All stacks with all pairs of brushes of 3x1x3 and 2x2x2,
// 10^5 random ones under every rule, and the laws that do not hold with their counter-examples:
// they say why a stroke is collected into one brush, why undo keeps what was there, and why the bed
// must be given to whoever edits.

#include "alive.h"
#include "tiny.h"

static uint32_t add(const tiny *t, uint32_t a, uint32_t d)
{
    return t->trim[a | d];
}

static uint32_t take(const tiny *t, uint32_t a, uint32_t d)
{
    return t->trim[a & ~d];
}

// Item 35's other way to add: nothing of A is asked, and of D only what is carried is taken.
static uint32_t add_carried(const tiny *t, uint32_t a, uint32_t d)
{
    uint32_t result = a | (d & t->layer);
    for (int v = t->nx * t->ny; v < t->voxels; v++) {
        result |= d >> v & 1 && (t->carriers[v] & result) ? 1u << v : 0;
    }
    return result;
}

// ---------------------------------------------------------------------------------------------
// All stacks, all brushes
// ---------------------------------------------------------------------------------------------

// Laws of one stack and one brush; `is_free` says whether the stack is support-free.
static uint32_t broken_by_one(const tiny *t, uint32_t a, uint32_t d, int is_free)
{
    uint32_t sum = add(t, a, d), rest = take(t, a, d), loose = add_carried(t, a, d), broken = 0;
    broken += is_free && ((a & ~sum) != 0 || (sum & ~a & ~d) != 0); // 33
    broken += (is_free && loose != sum) || (loose & ~a & ~d) != 0;  // 35
    broken += (a & ~loose) != 0;                                    // 35: only adds
    broken += add(t, sum, d) != sum;                                // 39, idempotent
    broken += (rest & ~(a & ~d)) != 0 || take(t, rest, d) != rest;  // 40
    broken += is_free && (d & a) == 0 && take(t, sum, d) != a;      // 42
    broken += is_free && (add(t, rest, a & d) & ~a) != 0;           // 43, the true half
    return broken;
}

static uint32_t alternate(const tiny *t, uint32_t a, uint32_t d, uint32_t e)
{
    for (int i = 0; i < t->nz; i++) {
        a = add(t, add(t, a, d), e);
    }
    return a;
}

// Laws of one stack and two brushes.
static uint32_t broken_by_two(const tiny *t, uint32_t a, uint32_t d, uint32_t e, int is_free)
{
    uint32_t joint = add(t, a, d | e), first = add(t, add(t, a, d), e);
    uint32_t second = add(t, add(t, a, e), d), gone = take(t, a, d | e), broken = 0;
    broken += ((first | second) & ~joint) != 0;                                          // 37
    broken += is_free && alternate(t, a, d, e) != joint;                                 // 37
    broken += t->trim[a | d] == (a | d) && t->trim[a | e] == (a | e) && first != second; // 38
    broken += (add(t, a, d) & ~joint) != 0;                                              // 39: in D
    broken += (add(t, a, d) & ~add(t, a | e, d)) != 0;                                   // 39: in A
    broken += take(t, take(t, a, d), e) != gone;                                         // 40
    broken += (gone & ~take(t, a, d)) != 0;                                              // 40: in D
    broken += (take(t, a, d) & ~take(t, a | e, d)) != 0;                                 // 40: in A
    return broken;
}

static void laws_of(int nx, int ny, int nz, const sf_rule *rule, uint32_t stride)
{
    tiny t = tiny_new(nx, ny, nz, rule);
    uint32_t broken = 0;
    for (uint32_t a = 0; a < t.count; a++) {
        int is_free = tiny_is_free(&t, a);
        for (uint32_t d = 0; d < t.count; d++) {
            broken += broken_by_one(&t, a, d, is_free);
            // All pairs of brushes, or with a stride some of them, others for each first brush.
            for (uint32_t e = (a + d) % stride; e < t.count; e += stride) {
                broken += broken_by_two(&t, a, d, e, is_free);
            }
        }
    }
    CHECK_EQ(broken, 0);
    tiny_delete(&t);
}

static void all_triples(void)
{
    sf_rule box = sf_rule_box3();
    laws_of(3, 1, 3, &box, 1);
    laws_of(2, 2, 2, &box, 1);
}

static void where_steps_differ(void)
{
    sf_rule rules[2] = {rule_of_angle(SF_RULE_OCTAGON, 30.0), rule_of_radius(0)};
    for (int i = 0; i < 2; i++) {
        laws_of(3, 1, 3, &rules[i], 7);
        laws_of(2, 2, 2, &rules[i], 1);
    }
}

// ---------------------------------------------------------------------------------------------
// Random ones, every rule
// ---------------------------------------------------------------------------------------------

typedef struct bench_of {
    alive_rule alive;
    sf_grid *grid;
    int nx, ny, nz;
} bench_of;

// result = the library's trim of p combined with q.
static void trim_of(const bench_of *b, const stack *p, int operation, const stack *q, stack *result)
{
    stack_combine(result, p, q, operation);
    stack_put(result, b->grid);
    CHECK_EQ(sf_grid_trim(b->grid, &b->alive.rule, 0, NULL, NULL), SF_OK);
    stack_take(result, b->grid);
}

static void draw(const bench_of *b, stack *s)
{
    if (test_random_below(3) == 0) {
        stack_random_boxes(s, b->nx, b->ny, b->nz, 1 + (int)test_random_below(3));
    } else {
        stack_random(s, b->nx, b->ny, b->nz, 0.1 + 0.7 * test_random_unit());
    }
}

static void check_adding(const bench_of *b, const stack *a, const stack *d, const stack *e)
{
    static stack with_d, with_e, first, second, both, joint, naive;
    trim_of(b, a, STACK_OR, d, &with_d);
    trim_of(b, a, STACK_OR, e, &with_e);
    stack_combine(&both, d, e, STACK_OR);
    trim_of(b, a, STACK_OR, &both, &joint);
    stack_combine(&both, a, &both, STACK_OR);
    alive_trim(&b->alive, &both, NULL, 0, &naive);
    CHECK(stack_equal(&naive, &joint));
    trim_of(b, &with_d, STACK_OR, e, &first);
    trim_of(b, &with_e, STACK_OR, d, &second);
    stack_combine(&both, a, d, STACK_OR);
    CHECK(stack_within(a, &with_d) && stack_within(&with_d, &both));       // 33
    CHECK(stack_within(&first, &joint) && stack_within(&second, &joint));  // 37
    CHECK(stack_within(&with_d, &joint) && stack_within(&with_e, &joint)); // 39
    if (stack_equal(&both, &with_d)) {
        stack_combine(&both, a, e, STACK_OR);
        CHECK(!stack_equal(&both, &with_e) || stack_equal(&first, &second)); // 38
    }
    const sf_bridge *bridge = &b->alive.rule.bridge;
    if (bridge->span_x == 0 && bridge->span_y == 0 && bridge->span_diagonal == 0) {
        for (int i = 1; i < b->nz; i++) {
            trim_of(b, &first, STACK_OR, d, &both);
            trim_of(b, &both, STACK_OR, e, &first);
        }
        CHECK(stack_equal(&first, &joint)); // 37
    }
    trim_of(b, &with_d, STACK_OR, d, &both);
    CHECK(stack_equal(&both, &with_d)); // 39
    stack_combine(&both, d, a, STACK_MINUS);
    trim_of(b, &with_d, STACK_MINUS, &both, &second);
    CHECK(stack_equal(&second, a)); // 42
}

static void check_taking(const bench_of *b, const stack *a, const stack *d, const stack *e)
{
    static stack without, in_turn, both, joint, smaller, naive;
    trim_of(b, a, STACK_MINUS, d, &without);
    stack_combine(&both, a, d, STACK_MINUS);
    alive_trim(&b->alive, &both, NULL, 0, &naive);
    CHECK(stack_equal(&naive, &without));
    CHECK(stack_within(&without, &both)); // 40
    trim_of(b, &without, STACK_MINUS, e, &in_turn);
    stack_combine(&both, d, e, STACK_OR);
    trim_of(b, a, STACK_MINUS, &both, &joint);
    CHECK(stack_equal(&in_turn, &joint) && stack_within(&joint, &without)); // 40
    trim_of(b, a, STACK_AND, e, &smaller);
    trim_of(b, &smaller, STACK_MINUS, d, &in_turn);
    CHECK(stack_within(&in_turn, &without)); // 40: in A
    stack_combine(&both, a, d, STACK_AND);
    trim_of(b, &without, STACK_OR, &both, &in_turn);
    CHECK(stack_within(&in_turn, a)); // 43
}

static void random_brushes(void)
{
    static bench_of b;
    static stack a, d, e;
    for (int i = 0; i < 1000; i++) {
        sf_rule rule = alive_rule_by_number(i);
        b.nx = 1 + (int)test_random_below(6);
        b.ny = 1 + (int)test_random_below(5);
        b.nz = 2 + (int)test_random_below(4);
        alive_prepare(&b.alive, &rule, b.nz);
        stack_clear(&a, b.nx, b.ny, b.nz);
        b.grid = stack_grid(&a);
        for (int j = 0; j < 100 && test_case_failures == 0; j++) {
            draw(&b, &a);
            draw(&b, &d);
            draw(&b, &e);
            trim_of(&b, &a, STACK_OR, &a, &a);
            check_adding(&b, &a, &d, &e);
            check_taking(&b, &a, &d, &e);
        }
        sf_grid_destroy(b.grid);
    }
}

// ---------------------------------------------------------------------------------------------
// False
// ---------------------------------------------------------------------------------------------

static void false_laws(void)
{
    sf_rule rule = sf_rule_box3();
    tiny t = tiny_new(3, 1, 2, &rule);
    uint32_t above = tiny_parse("...|#.."), below = tiny_parse("#..|..."), both = above | below;
    // 34: adding nothing changes nothing. A stack that hangs is trimmed.
    CHECK_EQ(add(&t, above, 0), 0);
    // 35: adding only what is carried leaves a support-free stack.
    CHECK_EQ(add_carried(&t, above, 0), above);
    CHECK(!tiny_is_free(&t, above));
    // 36: order does not matter.
    CHECK_EQ(add(&t, add(&t, 0, above), below), below);
    CHECK_EQ(add(&t, add(&t, 0, below), above), both);
    // 37: alternating reaches the joint brush, from a stack that hangs.
    CHECK_EQ(add(&t, above, below), both);
    CHECK_EQ(alternate(&t, above, 0, below), below);
    // 39: two brushes at once are what each adds alone.
    CHECK_EQ(add(&t, 0, both), both);
    CHECK_EQ(add(&t, 0, above) | add(&t, 0, below), below);
    // 41: removing changes nothing outside the brush.
    CHECK_EQ(take(&t, both, below), 0);
    // 43: what was removed comes back when it is added: undo must keep what was there.
    CHECK_EQ(add(&t, take(&t, both, below), both & below), below);
    tiny_delete(&t);
}

// 37 with bridges: a gap of two voxels is spanned at once or not at all.
static void alternating_spans_no_gap(void)
{
    static stack s;
    sf_rule rule = sf_rule_box3();
    rule.bridge.span_x = 4;
    const char *steps[3] = {"#....#|#....#", "#....#|###..#", "#....#|#..###"};
    for (int i = 0; i < 3; i++) {
        stack_parse(&s, steps[i]);
        library_trim(&s, &s, &rule, 0);
        CHECK_EQ(stack_get(&s, 2, 0, 1) + stack_get(&s, 3, 0, 1), 0);
    }
    stack_parse(&s, "#....#|######");
    CHECK(stack_is_support_free(&s, &rule, 0) == 0); // by the plain rule
    library_trim(&s, &s, &rule, 0);
    CHECK_EQ(stack_volume(&s), 8);
}

// 39 with a bed that the shape chooses: more below, and what rested on the bed hangs.
static void the_bed_must_be_given(void)
{
    static stack a, both, alone, joint;
    sf_rule rule = sf_rule_box3();
    stack_parse(&a, "....|##..");
    stack_parse(&both, "...#|##..");
    library_trim(&alone, &a, &rule, SF_BED_AUTO);
    library_trim(&joint, &both, &rule, SF_BED_AUTO);
    CHECK(stack_equal(&alone, &a));
    CHECK_EQ(stack_volume(&joint), 1);
    library_trim(&alone, &a, &rule, 0);
    CHECK(stack_within(&alone, &joint));
}

int main(void)
{
    TEST(all_triples);
    TEST(where_steps_differ);
    TEST(random_brushes);
    TEST(false_laws);
    TEST(alternating_spans_no_gap);
    TEST(the_bed_must_be_given);
    return test_finish();
}

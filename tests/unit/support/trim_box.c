// SPDX-License-Identifier: MIT
// Why: brushes stay quick because only what can have changed is trimmed again; that is worth
// nothing unless the result is bit for bit the full trim (TRUST 16, ALGORITHMS 1.3). Random strokes
// that add and remove matter, on every rule, against sf_grid_trim() of the whole; the grown box
// must not be the whole grid in disguise, so what is reported as changed is held against the
// differences too.

#include "law/stack.h"

#include "base/memory.h"

static sf_box random_box(int nx, int ny, int nz)
{
    sf_box b;
    b.x0 = test_random_below((uint32_t)nx);
    b.y0 = test_random_below((uint32_t)ny);
    b.z0 = test_random_below((uint32_t)nz);
    b.x1 = b.x0 + 1 + test_random_below((uint32_t)nx - b.x0);
    b.y1 = b.y0 + 1 + test_random_below((uint32_t)ny - b.y0);
    b.z1 = b.z0 + 1 + test_random_below((uint32_t)nz - b.z0);
    return b;
}

enum { EDIT_ADD, EDIT_REMOVE, EDIT_NOISE };

static void edit(stack *s, sf_box b, int how)
{
    for (uint32_t z = b.z0; z < b.z1; z++) {
        for (uint32_t y = b.y0; y < b.y1; y++) {
            for (uint32_t x = b.x0; x < b.x1; x++) {
                uint8_t *v = stack_at(s, (int)x, (int)y, (int)z);
                int noise = how == EDIT_NOISE && test_random_below(2);
                *v = how == EDIT_ADD ? 1 : how == EDIT_REMOVE ? 0 : (uint8_t)(*v ^ noise);
            }
        }
    }
}

static sf_box box_of_differences(const stack *a, const stack *b)
{
    sf_box box = {0, 0, 0, 0, 0, 0};
    for (int i = 0; i < stack_count(a); i++) {
        if (a->solid[i] == b->solid[i]) {
            continue;
        }
        uint32_t x = (uint32_t)(i % a->nx), y = (uint32_t)(i / a->nx % a->ny);
        uint32_t z = (uint32_t)(i / a->nx / a->ny);
        if (box.z1 == 0) {
            sf_box first = {x, y, z, x + 1, y + 1, z + 1};
            box = first;
        }
        box.x0 = x < box.x0 ? x : box.x0;
        box.y0 = y < box.y0 ? y : box.y0;
        box.x1 = x >= box.x1 ? x + 1 : box.x1;
        box.y1 = y >= box.y1 ? y + 1 : box.y1;
        box.z1 = z + 1;
    }
    return box;
}

static int same_box(sf_box a, sf_box b)
{
    return a.x0 == b.x0 && a.y0 == b.y0 && a.z0 == b.z0 && a.x1 == b.x1 && a.y1 == b.y1 &&
           a.z1 == b.z1;
}

// A session of strokes on one shape.
static void session(int nx, int ny, int nz, const sf_rule *rule, uint32_t bed, int strokes)
{
    static stack drawn, expected, before, after;
    stack_random_boxes(&drawn, nx, ny, nz, 6);
    sf_grid *d = stack_grid(&drawn), *t = NULL;
    CHECK_EQ(sf_grid_clone(d, stack_allocator(), &t), SF_OK);
    CHECK_EQ(sf_grid_trim(t, rule, bed, NULL, NULL), SF_OK);
    for (int i = 0; i < strokes; i++) {
        sf_box box = random_box(nx, ny, nz), changed;
        edit(&drawn, box, (int)test_random_below(3));
        stack_write(&drawn, d);
        stack_read(&before, t);
        CHECK_EQ(sf_grid_trim_box(d, t, rule, bed, box, &changed), SF_OK);
        stack_read(&after, t);
        stack_trim(&expected, &drawn, rule, bed);
        CHECK(stack_equal(&expected, &after));
        CHECK(same_box(changed, box_of_differences(&before, &after)));
    }
    sf_grid_destroy(d);
    sf_grid_destroy(t);
}

static void strokes_equal_the_full_trim(void)
{
    for (int i = 0; i < 60; i++) {
        sf_rule rule = rule_by_number(i);
        int nx = i % 6 == 0 ? 200 : stack_width(), ny = 4 + (int)test_random_below(12);
        uint32_t bed = i % 3 == 0 ? test_random_below(3) : SF_BED_AUTO;
        session(nx, ny, 8, &rule, bed, 12);
    }
}

// With the bed found by itself a stroke can move it, up or down, and all changes.
static void strokes_that_move_the_bed(void)
{
    sf_rule rule = sf_rule_box3();
    for (int i = 0; i < 100; i++) {
        session(6, 3, 4, &rule, SF_BED_AUTO, 10);
    }
}

// Removing from a support-free shape, in place.
static void removal_in_place(void)
{
    static stack s, expected, found;
    for (int i = 0; i < 200; i++) {
        sf_rule rule = rule_by_number(i);
        int nx = stack_width(), ny = 9, nz = 9;
        uint32_t bed = i % 5 == 0 ? test_random_below(2) : SF_BED_AUTO;
        stack_random_boxes(&expected, nx, ny, nz, 12);
        stack_trim(&s, &expected, &rule, bed);
        for (int stroke = 0; stroke < 4; stroke++) {
            sf_box box = random_box(nx, ny, nz);
            edit(&s, box, EDIT_REMOVE);
            sf_grid *grid = stack_grid(&s);
            stack_trim(&expected, &s, &rule, bed);
            sf_box changed;
            CHECK_EQ(sf_grid_trim_box(grid, grid, &rule, bed, box, &changed), SF_OK);
            stack_read(&found, grid);
            CHECK(stack_equal(&expected, &found));
            CHECK(same_box(changed, box_of_differences(&s, &found)));
            sf_grid_destroy(grid);
            s = expected;
        }
    }
}

static void *refuse(void *user, size_t size, size_t align)
{
    sf_allocator libc = sfi_allocator_or_default(NULL);
    return *(int *)user ? NULL : libc.alloc(libc.user, size, align);
}

static void give_back(void *user, void *memory, size_t size)
{
    (void)user;
    sf_allocator libc = sfi_allocator_or_default(NULL);
    libc.free(libc.user, memory, size);
}

static void failing_calls_change_nothing(void)
{
    int refusing = 0;
    sf_allocator allocator = {refuse, give_back, &refusing};
    sf_lattice lattice = stack_lattice(20, 10, 5), other = stack_lattice(20, 10, 6);
    sf_grid *d, *t, *tall;
    CHECK_EQ(sf_grid_create(&lattice, stack_allocator(), &d), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, &allocator, &t), SF_OK);
    CHECK_EQ(sf_grid_create(&other, stack_allocator(), &tall), SF_OK);
    CHECK_EQ(sf_slice_set(sf_grid_slice(d, 0), 3, 3, 1), SF_OK);
    sf_rule rule = sf_rule_box3(), unknown = {.kind = (sf_rule_kind)9};
    sf_box box = {0, 0, 0, 20, 10, 5}, wide = {0, 0, 0, 21, 10, 5}, none = {5, 5, 2, 5, 9, 3};
    sf_box changed = {9, 9, 9, 9, 9, 9};
    CHECK_EQ(sf_grid_trim_box(NULL, t, &rule, 0, box, &changed), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_trim_box(d, NULL, &rule, 0, box, &changed), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_trim_box(d, t, NULL, 0, box, &changed), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_trim_box(d, t, &unknown, 0, box, &changed), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_trim_box(d, t, &rule, 5, box, &changed), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_trim_box(d, t, &rule, 0, wide, &changed), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_trim_box(d, tall, &rule, 0, box, &changed), SF_ERR_SHAPE);
    refusing = 1;
    CHECK_EQ(sf_grid_trim_box(d, t, &rule, 0, box, &changed), SF_ERR_MEMORY);
    CHECK_EQ(sf_grid_popcount(t), 0);
    CHECK_EQ(changed.x0, 9);
    // An empty box needs nothing and changes nothing.
    CHECK_EQ(sf_grid_trim_box(d, t, &rule, 0, none, &changed), SF_OK);
    CHECK_EQ(sf_grid_popcount(t), 0);
    CHECK_EQ(changed.x1, 0);
    refusing = 0;
    CHECK_EQ(sf_grid_trim_box(d, t, &rule, 0, box, NULL), SF_OK);
    CHECK_EQ(sf_grid_popcount(t), 1);
    sf_grid_destroy(d);
    sf_grid_destroy(t);
    sf_grid_destroy(tall);
}

int main(void)
{
    TEST(strokes_equal_the_full_trim);
    TEST(strokes_that_move_the_bed);
    TEST(removal_in_place);
    TEST(failing_calls_change_nothing);
    return test_finish();
}

// SPDX-License-Identifier: MIT
// Why: pieces of a grid by its runs must be those that a flood fill finds, numbered by their first
// voxel: 26 neighbours of what is solid, 6 of what is empty. Noise at every density has pieces that
// meet again layers later; memory that is refused and cancels must leave nothing behind (TRUST 70).

#include "voxel/pieces.h"
#include "base/memory.h"
#include "failing_allocator.h"
#include "law/stack.h"

static uint32_t label[STACK_VOXELS];
static int queue[STACK_VOXELS];

// Labels from 1 on by breadth-first search; returns how many.
static uint32_t flood(const stack *s, int solid)
{
    uint32_t count = 0;
    memset(label, 0, sizeof label);
    for (int start = 0; start < stack_count(s); start++) {
        if (s->solid[start] != solid || label[start] != 0) {
            continue;
        }
        int head = 0, tail = 0;
        label[start] = ++count;
        queue[tail++] = start;
        for (; head < tail; head++) {
            int x = queue[head] % s->nx, y = queue[head] / s->nx % s->ny;
            int z = queue[head] / s->nx / s->ny;
            for (int d = 0; d < 27; d++) {
                int dx = d % 3 - 1, dy = d / 3 % 3 - 1, dz = d / 9 - 1;
                int u = x + dx, v = y + dy, w = z + dz, at = (w * s->ny + v) * s->nx + u;
                if ((!solid && abs(dx) + abs(dy) + abs(dz) > 1) || u < 0 || v < 0 || w < 0 ||
                    u >= s->nx || v >= s->ny || w >= s->nz || s->solid[at] != solid ||
                    label[at] != 0) {
                    continue;
                }
                label[at] = count;
                queue[tail++] = at;
            }
        }
    }
    return count;
}

static void compare(const stack *s)
{
    sf_grid *grid = stack_grid(s);
    sf_allocator libc = sfi_allocator_or_default(NULL);
    for (int solid = 0; solid < 2; solid++) {
        sfi_pieces p;
        uint32_t count = flood(s, solid);
        CHECK_EQ(
            sfi_pieces_create(grid, solid ? SFI_PIECES_SOLID : SFI_PIECES_EMPTY, &libc, NULL, &p),
            SF_OK);
        CHECK_EQ(p.count, count);
        for (int i = 0; i < stack_count(s); i++) {
            uint32_t x = (uint32_t)(i % s->nx), y = (uint32_t)(i / s->nx % s->ny);
            uint32_t at = sfi_pieces_at(&p, x, y, (uint32_t)(i / s->nx / s->ny));
            CHECK_EQ(at, label[i] - 1);
        }
        sfi_pieces_destroy(&p, &libc);
    }
    sf_grid_destroy(grid);
}

static void flood_fill_agrees(void)
{
    static stack s;
    for (int i = 0; i < 300; i++) {
        int nx = 1 + (int)test_random_below(20), ny = 1 + (int)test_random_below(9);
        stack_random(&s, nx, ny, 1 + (int)test_random_below(9), test_random_unit());
        compare(&s);
    }
    stack_random(&s, 150, 13, 12, 0.4);
    compare(&s);
    stack_random(&s, 150, 13, 12, 0.7);
    compare(&s);
}

static void nothing_and_everything(void)
{
    static stack s;
    stack_clear(&s, 70, 3, 4);
    compare(&s);
    memset(s.solid, 1, sizeof s.solid);
    compare(&s);
}

static void failures_leave_nothing(void)
{
    static stack s;
    stack_random(&s, 60, 20, 5, 0.5);
    sf_grid *grid = stack_grid(&s);
    sf_status status = SF_ERR_MEMORY;
    for (long at = 0; status != SF_OK && at < 100; at++) {
        failing_allocator f;
        sfi_pieces p;
        failing_begin(&f, at);
        status = sfi_pieces_create(grid, SFI_PIECES_EMPTY, &f.allocator, NULL, &p);
        if (status == SF_OK) {
            CHECK(at > 2);
            sfi_pieces_destroy(&p, &f.allocator);
        } else {
            CHECK_EQ(status, SF_ERR_MEMORY);
        }
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
    failing_allocator f;
    sfi_pieces p;
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    failing_begin(&f, -1);
    CHECK_EQ(sfi_pieces_create(grid, SFI_PIECES_SOLID, &f.allocator, &task, &p), SF_ERR_CANCELLED);
    CHECK_EQ(f.live, 0);
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(flood_fill_agrees);
    TEST(nothing_and_everything);
    TEST(failures_leave_nothing);
    return test_finish();
}

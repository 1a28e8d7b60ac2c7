// SPDX-License-Identifier: MIT
// Boxes around the triangles of a mesh, to find out whether any of them comes near.
//
// Triangles are put in the order of a curve that fills space (morton.c). Then eight boxes in a row
// make a block, which has a box one level up, and so on: building is a sort and one pass, and the
// tree needs no links. The boxes of a block lie side by side in memory, so that a compiler can look
// at several with one instruction.
//
// A search leaves out what is not near, so that a no has looked at little more than what might have
// been a yes, and goes into the nearest box first, so that a yes is soon found.

#include "balance/wall/near.h"

#include "base/memory.h"
#include "base/status.h"
#include "mesh/morton.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define NOWHERE (-1e150) // half the size of a box that there is not

static const double *corner_of(const sf_mesh_view *mesh, size_t triangle, int i)
{
    return mesh->vertices + 3 * (size_t)mesh->triangles[3 * triangle + (size_t)i];
}

// Triangles in the order of their middles.
static sf_status sort(sfi_near *near, const sf_allocator *allocator)
{
    const sf_mesh_view *mesh = &near->mesh;
    size_t count = mesh->triangle_count;
    near->order = sfi_alloc_array(allocator, count, sizeof *near->order);
    double *middles = sfi_alloc_array(allocator, count, 3 * sizeof *middles);
    sf_status status = SF_ERR_MEMORY;
    for (size_t i = 0; middles != NULL && i < 3 * count; i++) {
        middles[i] = 0;
        for (int j = 0; j < 3; j++) {
            middles[i] += corner_of(mesh, i / 3, j)[i % 3] / 3;
        }
    }
    if (near->order != NULL && middles != NULL) {
        status = sfi_morton_order(middles, count, allocator, near->order);
    }
    sfi_free_array(allocator, middles, count, 3 * sizeof *middles);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Boxes
// ---------------------------------------------------------------------------------------------

typedef struct span {
    double low, high;
} span;

static span triangle_span(const sfi_near *near, size_t place, int axis)
{
    size_t t = near->order[place];
    double v = corner_of(&near->mesh, t, 0)[axis];
    span s = {v, v};
    for (int i = 1; i < 3; i++) {
        v = corner_of(&near->mesh, t, i)[axis];
        s.low = v < s.low ? v : s.low;
        s.high = v > s.high ? v : s.high;
    }
    return s;
}

static span block_span(const sfi_near_block *block, int axis)
{
    span s = {DBL_MAX, -DBL_MAX};
    for (size_t i = 0; i < SFI_NEAR_SPAN; i++) {
        double low = block->middle[axis][i] - block->half[axis][i];
        double high = block->middle[axis][i] + block->half[axis][i];
        if (block->half[axis][i] >= 0) {
            s.low = low < s.low ? low : s.low;
            s.high = high > s.high ? high : s.high;
        }
    }
    return s;
}

// Around a span, with room for what rounding costs here and one level up.
static void lay_box(sfi_near_block *block, size_t i, int axis, span s)
{
    double middle = 0.5 * s.low + 0.5 * s.high, largest = fabs(s.low) + fabs(s.high);
    block->middle[axis][i] = middle;
    block->half[axis][i] = 0.5 * s.high - 0.5 * s.low + largest * (8 * DBL_EPSILON);
}

static void lay_boxes(sfi_near *near)
{
    size_t all = near->first[near->levels], count = near->mesh.triangle_count;
    for (size_t i = 0; i < all * 3 * SFI_NEAR_SPAN; i++) {
        size_t j = i % (3 * SFI_NEAR_SPAN);
        sfi_near_block *block = &near->blocks[i / (3 * SFI_NEAR_SPAN)];
        block->middle[j / SFI_NEAR_SPAN][j % SFI_NEAR_SPAN] = 0;
        block->half[j / SFI_NEAR_SPAN][j % SFI_NEAR_SPAN] = NOWHERE;
    }
    for (size_t level = 0; level < near->levels; level++) {
        for (size_t i = 0; i < 3 * count; i++) {
            int axis = (int)(i % 3);
            span s = level == 0 ? triangle_span(near, i / 3, axis)
                                : block_span(&near->blocks[near->first[level - 1] + i / 3], axis);
            lay_box(&near->blocks[near->first[level] + i / 3 / SFI_NEAR_SPAN],
                    i / 3 % SFI_NEAR_SPAN, axis, s);
        }
        count = near->first[level + 1] - near->first[level];
    }
}

sf_status sfi_near_create(sf_mesh_view mesh, const sf_allocator *allocator, sfi_near *near)
{
    memset(near, 0, sizeof *near);
    near->mesh = mesh;
    if (mesh.triangle_count == 0) {
        return SF_OK;
    }
    if (mesh.triangle_count > UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    size_t count = (mesh.triangle_count - 1) / SFI_NEAR_SPAN + 1;
    for (near->levels = 1; count > 1; near->levels++) {
        near->first[near->levels] = near->first[near->levels - 1] + count;
        count = (count - 1) / SFI_NEAR_SPAN + 1;
    }
    near->first[near->levels] = near->first[near->levels - 1] + 1;
    sf_status status = sort(near, allocator);
    if (status == SF_OK) {
        near->blocks = sfi_alloc_array(allocator, near->first[near->levels], sizeof *near->blocks);
        status = near->blocks != NULL ? SF_OK : SF_ERR_MEMORY;
    }
    if (status != SF_OK) {
        sfi_near_destroy(near, allocator);
        return status;
    }
    lay_boxes(near);
    return SF_OK;
}

void sfi_near_destroy(sfi_near *near, const sf_allocator *allocator)
{
    sfi_free_array(allocator, near->order, near->mesh.triangle_count, sizeof *near->order);
    sfi_free_array(allocator, near->blocks, near->first[near->levels], sizeof *near->blocks);
    memset(near, 0, sizeof *near);
}

// ---------------------------------------------------------------------------------------------
// Searching
// ---------------------------------------------------------------------------------------------

// A box, and the nearest triangle so far, which must be nearer than what the query began with. Who
// asks for any has found it then.
typedef struct query {
    const double *middle, *half;
    double squared, limit;
    int wants_any, has_any;
} query;

static void ask_triangle(const sfi_near *near, size_t place, query *q)
{
    double corners[3][3];
    for (int i = 0; i < 3; i++) {
        const double *corner = corner_of(&near->mesh, near->order[place], i);
        for (int j = 0; j < 3; j++) {
            corners[i][j] = corner[j] - q->middle[j];
        }
    }
    double gap = sfi_triangle_gap((const double(*)[3])corners, q->half, q->limit,
                                  q->wants_any ? q->limit : 0);
    if (gap < q->squared) {
        q->squared = gap;
        q->limit = sqrt(gap);
        q->has_any = 1;
    }
}

// Squared gap between the box of the query and each of a block.
static void measure(const sfi_near_block *block, const query *q, double gaps[SFI_NEAR_SPAN])
{
    for (size_t i = 0; i < SFI_NEAR_SPAN; i++) {
        gaps[i] = 0;
    }
    for (int j = 0; j < 3; j++) {
        double middle = q->middle[j], half = q->half[j];
        for (size_t i = 0; i < SFI_NEAR_SPAN; i++) {
            double gap = fabs(block->middle[j][i] - middle) - block->half[j][i] - half;
            gap = 0.5 * (gap + fabs(gap)); // 0 where it is negative, without a branch
            gaps[i] += gap * gap;
        }
    }
}

// A block to look into.
typedef struct visit {
    double gap; // of its box
    size_t level, index;
} visit;

// Put the near boxes of a block on the stack, the nearest last; level 0: ask the triangles.
static void look_into(const sfi_near *near, visit here, query *q, visit *stack, size_t *depth)
{
    double gaps[SFI_NEAR_SPAN], least = DBL_MAX;
    measure(&near->blocks[near->first[here.level] + here.index], q, gaps);
    for (size_t i = 0; i < SFI_NEAR_SPAN && !(q->wants_any && q->has_any); i++) {
        size_t inner = here.index * SFI_NEAR_SPAN + i;
        if (!(gaps[i] < q->squared)) {
            continue;
        }
        if (here.level == 0) {
            ask_triangle(near, inner, q);
            continue;
        }
        visit next = {gaps[i], here.level - 1, inner};
        stack[*depth] = next;
        if (gaps[i] > least) {
            stack[*depth] = stack[*depth - 1];
            stack[*depth - 1] = next;
        }
        least = gaps[i] < least ? gaps[i] : least;
        *depth += 1;
    }
}

static void search(const sfi_near *near, query *q)
{
    visit stack[SFI_NEAR_LEVELS * SFI_NEAR_SPAN];
    size_t depth = 0;
    if (near->levels > 0) {
        visit root = {0, near->levels - 1, 0};
        stack[depth++] = root;
    }
    while (depth > 0 && !(q->wants_any && q->has_any)) {
        visit here = stack[--depth];
        if (here.gap < q->squared) {
            look_into(near, here, q, stack, &depth);
        }
    }
}

int sfi_near_any(const sfi_near *near, const double middle[3], const double half[3], double limit)
{
    query q = {middle, half, limit * limit, limit, 1, 0};
    search(near, &q);
    return q.has_any;
}

double sfi_near_least(const sfi_near *near, const double middle[3], const double half[3],
                      double limit)
{
    query q = {middle, half, limit * limit, limit, 0, 0};
    search(near, &q);
    return q.limit;
}

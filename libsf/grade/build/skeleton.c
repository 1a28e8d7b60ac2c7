// SPDX-License-Identifier: MIT
// Bodies along a skeleton.
//
// A node is a cube, and a strut a row of hexahedra from a side of one cube to a side of another.
// Which corners go together is chosen so that the four edges along the strut are shortest in all:
// then it is not twisted more than it must be.

#include "grade/build/draft.h"

#include "base/memory.h"
#include "base/status.h"

#include <math.h>
#include <string.h>

// Corners around each side of a cube, low and high by axis, seen from outside counter-clockwise.
static const uint8_t sides[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                    {2, 3, 7, 6}, {0, 3, 2, 1}, {4, 5, 6, 7}};
static const int8_t corners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                     {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

typedef struct frame {
    const sf_skeleton_node *nodes;
    uint8_t *taken; // of each node the sides that struts have left through
    sfi_draft draft;
} frame;

static void add_node(frame *f, size_t node)
{
    uint32_t points[8];
    for (int i = 0; i < 8; i++) {
        double at[3];
        for (int axis = 0; axis < 3; axis++) {
            at[axis] = f->nodes[node].at_mm[axis] + corners[i][axis] * f->nodes[node].half_side_mm;
        }
        points[i] = sfi_draft_point(&f->draft, at);
    }
    sfi_draft_cell(&f->draft, 8, points);
}

// The side of a cube that a direction is nearest to.
static uint32_t side_towards(const double d[3])
{
    uint32_t best = 0;
    for (uint32_t axis = 1; axis < 3; axis++) {
        best = fabs(d[axis]) > fabs(d[best]) ? axis : best;
    }
    return 2 * best + (d[best] > 0);
}

static void place_of(const frame *f, uint32_t point, double at[3])
{
    memcpy(at, f->draft.positions + 3 * (size_t)point, 3 * sizeof *at);
}

static double distance(const frame *f, uint32_t a, uint32_t b)
{
    double p[3], q[3], sum = 0;
    place_of(f, a, p);
    place_of(f, b, q);
    for (int axis = 0; axis < 3; axis++) {
        sum += (p[axis] - q[axis]) * (p[axis] - q[axis]);
    }
    return sqrt(sum);
}

// The corners of the far side in the order of the near ones: it is seen from the other end, so it
// goes around the other way, from whichever corner makes the edges shortest.
static void match(const frame *f, const uint32_t near[4], const uint32_t far[4],
                  uint32_t matched[4])
{
    double least = INFINITY;
    for (uint32_t first = 0; first < 4; first++) {
        double sum = 0;
        for (uint32_t i = 0; i < 4; i++) {
            sum += distance(f, near[i], far[(first + 4 - i) % 4]);
        }
        if (sum < least) {
            least = sum;
            for (uint32_t i = 0; i < 4; i++) {
                matched[i] = far[(first + 4 - i) % 4];
            }
        }
    }
}

static void add_strut(frame *f, const uint32_t near[4], const uint32_t far[4], uint32_t cells)
{
    uint32_t here[4], cell[8];
    memcpy(here, near, sizeof here);
    for (uint32_t k = 1; k <= cells && f->draft.status == SF_OK; k++) {
        for (uint32_t i = 0; i < 4; i++) {
            double a[3], b[3], at[3], t = (double)k / cells;
            place_of(f, near[i], a);
            place_of(f, far[i], b);
            for (int axis = 0; axis < 3; axis++) {
                at[axis] = (1 - t) * a[axis] + t * b[axis];
            }
            cell[i] = here[i];
            cell[4 + i] = k == cells ? far[i] : sfi_draft_point(&f->draft, at);
        }
        sfi_draft_cell(&f->draft, 8, cell);
        memcpy(here, cell + 4, sizeof here);
    }
}

// The points of the side of a node through which a strut leaves; marks it as taken.
static sf_status leave(frame *f, size_t strut, uint32_t node, const double d[3], uint32_t points[4],
                       sf_fault *fault)
{
    uint32_t side = side_towards(d);
    if (f->taken[node] >> side & 1) {
        return sfi_fault_set(
            fault, SF_ERR_UNSUPPORTED, 0, 0,
            "strut %zu leaves node %lu through the side that another one has; give "
            "it a node of its own in between",
            strut, (unsigned long)node);
    }
    f->taken[node] = (uint8_t)(f->taken[node] | 1u << side);
    for (uint32_t i = 0; i < 4; i++) {
        points[i] = 8 * node + sides[side][i];
    }
    return SF_OK;
}

static sf_status connect(frame *f, size_t strut, const sf_skeleton_strut *s, sf_fault *fault)
{
    uint32_t near[4], far[4], matched[4];
    double d[3], back[3], longest = 0;
    const sf_skeleton_node *a = &f->nodes[s->nodes[0]], *b = &f->nodes[s->nodes[1]];
    for (int axis = 0; axis < 3; axis++) {
        d[axis] = b->at_mm[axis] - a->at_mm[axis];
        back[axis] = -d[axis];
        longest = fabs(d[axis]) > longest ? fabs(d[axis]) : longest;
    }
    if (!(longest > a->half_side_mm + b->half_side_mm)) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "strut %zu is shorter than its two nodes are wide", strut);
    }
    SF_TRY(leave(f, strut, s->nodes[0], d, near, fault));
    SF_TRY(leave(f, strut, s->nodes[1], back, far, fault));
    match(f, near, far, matched);
    add_strut(f, near, matched, s->cells);
    return f->draft.status;
}

static sf_status check(size_t node_count, const sf_skeleton_node *nodes, size_t strut_count,
                       const sf_skeleton_strut *struts, sf_fault *fault)
{
    for (size_t i = 0; i < node_count; i++) {
        const sf_skeleton_node *n = &nodes[i];
        if (!isfinite(n->at_mm[0] + n->at_mm[1] + n->at_mm[2]) ||
            !(n->half_side_mm > 0 && isfinite(n->half_side_mm))) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "node %zu has a place that is not finite or no side above 0", i);
        }
    }
    for (size_t i = 0; i < strut_count; i++) {
        const sf_skeleton_strut *s = &struts[i];
        if (s->nodes[0] >= node_count || s->nodes[1] >= node_count || s->nodes[0] == s->nodes[1] ||
            s->cells == 0 || s->cells > 1u << 20) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "strut %zu names nodes that there are not, one twice, or no cells",
                                 i);
        }
    }
    return SF_OK;
}

sf_status sf_cage_skeleton(size_t node_count, const sf_skeleton_node *nodes, size_t strut_count,
                           const sf_skeleton_strut *struts, const sf_allocator *allocator,
                           sf_cage **cage, sf_fault *fault)
{
    if (node_count == 0 || nodes == NULL || cage == NULL || (strut_count > 0 && struts == NULL)) {
        return SF_ERR_ARGUMENT;
    }
    if (node_count > SF_CAGE_POINT_MAX / 8) {
        return SF_ERR_OVERFLOW;
    }
    SF_TRY(check(node_count, nodes, strut_count, struts, fault));
    sf_allocator kept = sfi_allocator_or_default(allocator);
    frame f;
    f.nodes = nodes;
    f.taken = sfi_alloc_array(&kept, node_count, 1);
    if (f.taken == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(f.taken, 0, node_count);
    sfi_draft_begin(allocator, &f.draft);
    for (size_t i = 0; i < node_count && f.draft.status == SF_OK; i++) {
        add_node(&f, i);
    }
    sf_status status = f.draft.status;
    for (size_t i = 0; status == SF_OK && i < strut_count; i++) {
        status = connect(&f, i, &struts[i], fault);
    }
    f.draft.status = status;
    status = sfi_draft_end(&f.draft, cage, fault);
    sfi_free_array(&kept, f.taken, node_count, 1);
    return status;
}

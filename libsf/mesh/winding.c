// SPDX-License-Identifier: MIT
// How far the patches over a mesh's holes wind around a point.
//
// An open mesh has no inside, but it has a winding number: the solid angle that it fills around a
// point, over 4 pi, which is 1 within a closed mesh, 0 outside, and falls off smoothly through a
// hole. To compute it, close every hole with a patch. Mesh and patches together are closed, and
// their winding number is an integer that crossings give exactly; the patches' own is subtracted.
// It does not matter which patch is taken, so each loop is halved, and its halves again: the
// triangle between both ends and the middle, and a smaller patch over each half.
//
// That makes a tree, built here. Seen from afar a patch is a dipole: its vector area in place of
// its triangles is wrong by at most 2 S r / g^3, with S the area, r the radius, g the distance from
// the ball, since (x - q) / |x - q|^3 changes by at most 2 / |x - q|^3 a unit. The slivers along a
// smooth rim have next to no area, so a point looks at few triangles however long the rim is.

#include "mesh/winding.h"

#include "base/memory.h"
#include "base/size.h"
#include "mesh/vector.h"

#include <math.h>
#include <string.h>

typedef struct stretch {
    size_t edge0, edge1, loop0, loop1;
} stretch;

static uint32_t point_at(const sfi_loops *loops, size_t loop, size_t edge)
{
    return loops->points[edge == loops->starts[loop + 1] ? loops->starts[loop] : edge];
}

// Corners of the node over a stretch; returns where it is to be halved.
static stretch name_node(const sfi_loops *loops, stretch s, sfi_winding_node *node)
{
    stretch left = s;
    node->edges = (uint32_t)(s.edge1 - s.edge0);
    node->corner[0] = node->corner[1] = node->corner[2] = SFI_NOBODY;
    if (s.loop1 - s.loop0 > 1) {
        left.loop1 = s.loop0 + (s.loop1 - s.loop0) / 2;
        left.edge1 = loops->starts[left.loop1];
        return left;
    }
    left.edge1 = s.edge0 + (s.edge1 - s.edge0) / 2;
    node->corner[0] = point_at(loops, s.loop0, s.edge0);
    node->corner[1] = point_at(loops, s.loop0, node->edges > 1 ? left.edge1 : s.edge1);
    if (node->edges > 1 && s.edge1 - s.edge0 < loops->starts[s.loop1] - loops->starts[s.loop0]) {
        node->corner[2] = point_at(loops, s.loop0, s.edge1);
    }
    return left;
}

static void name_nodes(const sfi_loops *loops, sfi_winding *w)
{
    stretch stack[80]; // one waiting sibling for each halving of at most 2^32 edges, twice
    size_t depth = 0;
    stack[depth++] = (stretch){0, loops->edge_count, 0, loops->loop_count};
    for (size_t i = 0; i < w->node_count; i++) {
        stretch s = stack[--depth], left = name_node(loops, s, &w->nodes[i]);
        w->patch_count += w->nodes[i].corner[2] != SFI_NOBODY;
        if (w->nodes[i].edges > 1) {
            int apart = s.loop1 - s.loop0 > 1;
            stretch right = {left.edge1, s.edge1, apart ? left.loop1 : s.loop0, s.loop1};
            stack[depth++] = right;
            stack[depth++] = left;
        }
    }
}

typedef struct extent {
    double low[3], high[3];
} extent;

static void measure_edge(const sfi_winding *w, const sfi_point *points, sfi_winding_node *node,
                         extent *box)
{
    double a[3], b[3], ab[3];
    sfi_winding_place(w, points + node->corner[0], a);
    sfi_winding_place(w, points + node->corner[1], b);
    sfi_subtract(b, a, ab);
    node->length = sqrt(sfi_dot(ab, ab));
    for (int i = 0; i < 3; i++) {
        box->low[i] = a[i] < b[i] ? a[i] : b[i];
        box->high[i] = a[i] < b[i] ? b[i] : a[i];
        node->area[i] = 0.0;
    }
    node->area_sum = 0.0;
}

static void measure_patch(const sfi_winding *w, const sfi_point *points, sfi_winding_node *node,
                          extent *box)
{
    const sfi_winding_node *left = node + 1, *right = node + 2 * (size_t)left->edges;
    const extent *a = box + 1, *b = box + 2 * (size_t)left->edges;
    double half[3] = {0.0, 0.0, 0.0};
    if (node->corner[2] != SFI_NOBODY) {
        double p[3][3], u[3], v[3];
        for (int i = 0; i < 3; i++) {
            sfi_winding_place(w, points + node->corner[i], p[i]);
        }
        sfi_subtract(p[1], p[0], u);
        sfi_subtract(p[2], p[0], v);
        sfi_cross(u, v, half);
    }
    node->length = left->length + right->length;
    node->area_sum = left->area_sum + right->area_sum + sqrt(sfi_dot(half, half)) / 2;
    for (int i = 0; i < 3; i++) {
        node->area[i] = left->area[i] + right->area[i] + half[i] / 2;
        box->low[i] = a->low[i] < b->low[i] ? a->low[i] : b->low[i];
        box->high[i] = a->high[i] > b->high[i] ? a->high[i] : b->high[i];
    }
}

// Children follow their parents, so the way back meets them first.
static void measure_nodes(const sfi_point *points, sfi_winding *w, extent *boxes)
{
    for (size_t i = w->node_count; i-- > 0;) {
        sfi_winding_node *node = w->nodes + i;
        if (node->edges == 1) {
            measure_edge(w, points, node, boxes + i);
        } else {
            measure_patch(w, points, node, boxes + i);
        }
        double diagonal[3];
        for (int c = 0; c < 3; c++) {
            node->center[c] = (boxes[i].low[c] + boxes[i].high[c]) / 2;
            diagonal[c] = (boxes[i].high[c] - boxes[i].low[c]) / 2;
        }
        node->radius = sqrt(sfi_dot(diagonal, diagonal));
    }
}

sf_status sfi_winding_create(const sfi_frame *frame, const sfi_point *points,
                             const sfi_loops *loops, const sf_allocator *allocator,
                             sfi_winding *winding)
{
    memset(winding, 0, sizeof *winding);
    for (int i = 0; i < 3; i++) {
        winding->scale[i] = frame->voxel_mm[i] / frame->voxel_mm[0];
    }
    if (loops->edge_count == 0) {
        return SF_OK;
    }
    size_t count;
    if (loops->edge_count > UINT32_MAX / 2 || !sfi_size_mul(loops->edge_count, 2, &count)) {
        return SF_ERR_OVERFLOW;
    }
    winding->node_count = count - 1;
    winding->nodes = sfi_alloc_array(allocator, winding->node_count, sizeof *winding->nodes);
    extent *boxes = sfi_alloc_array(allocator, winding->node_count, sizeof *boxes);
    int good = winding->nodes != NULL && boxes != NULL;
    if (good) {
        name_nodes(loops, winding);
        measure_nodes(points, winding, boxes);
    }
    sfi_free_array(allocator, boxes, winding->node_count, sizeof *boxes);
    if (!good) {
        sfi_winding_destroy(winding, allocator);
    }
    return good ? SF_OK : SF_ERR_MEMORY;
}

void sfi_winding_destroy(sfi_winding *winding, const sf_allocator *allocator)
{
    sfi_free_array(allocator, winding->nodes, winding->node_count, sizeof *winding->nodes);
    memset(winding, 0, sizeof *winding);
}

void sfi_winding_patches(const sfi_winding *winding, uint32_t *triangles)
{
    for (size_t i = 0; i < winding->node_count; i++) {
        const uint32_t *corner = winding->nodes[i].corner;
        if (corner[2] != SFI_NOBODY) {
            memcpy(triangles, corner, 3 * sizeof *triangles);
            triangles += 3;
        }
    }
}

void sfi_winding_flip(sfi_winding *winding)
{
    for (size_t i = 0; i < winding->node_count; i++) {
        sfi_winding_node *node = winding->nodes + i;
        uint32_t swap = node->corner[0];
        node->corner[0] = node->corner[1];
        node->corner[1] = swap;
        for (int c = 0; c < 3; c++) {
            node->area[c] = -node->area[c];
        }
    }
}

// SPDX-License-Identifier: MIT
// Rings: what the smooth shape within a cell depends on.
//
// The shape over a cell is determined by the cells that touch it. Two cells whose rings are the
// same but for the numbers of points have the same formulas, so rings are written down in a way
// that makes "the same" a comparison of bytes: cells in the order in which they are reached across
// faces, first those of the first cell in the order of its sides, then those of the second, and
// points in the order in which cells bring them. Each cell is turned as if it had been shifted
// there from the one that it was reached from. Around an edge of other than four cells the turns do
// not match up, and that is how the ring of an irregular cell differs from the regular one.

#include "grade/limit/ring.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

static uint32_t corner_count(const sfi_complex *c)
{
    return 1u << c->dimension;
}

static const uint32_t *corners_of(const sfi_complex *c, uint32_t cell)
{
    const sfi_lists *lists = c->dimension == 3 ? &c->cell_points : &c->face_points;
    return lists->items + lists->starts[cell];
}

sf_status sfi_ring_finder_begin(const sfi_complex *complex, const sf_allocator *allocator,
                                sfi_ring_finder *finder)
{
    const sfi_complex *c = complex;
    sfi_ring_finder f;
    memset(&f, 0, sizeof f);
    f.allocator = *allocator;
    f.complex = c;
    f.ring.dimension = c->dimension;
    const sfi_lists *cells = c->dimension == 3 ? &c->cell_points : &c->face_points;
    uint32_t count = c->dimension == 3 ? c->cells : c->faces;
    f.cell_marks = sfi_alloc_array(allocator, count, sizeof *f.cell_marks);
    f.point_marks = sfi_alloc_array(allocator, c->points, sizeof *f.point_marks);
    f.point_locals = sfi_alloc_array(allocator, c->points, sizeof *f.point_locals);
    sf_status status = f.cell_marks == NULL || f.point_marks == NULL || f.point_locals == NULL
                           ? SF_ERR_MEMORY
                           : sfi_lists_turn(allocator, count, cells->starts, cells->items,
                                            c->points, &f.point_cells);
    if (status == SF_OK) {
        status = sfi_pairs_turn(allocator, c->edges, c->edge_points, c->points, &f.point_edges);
    }
    if (status == SF_OK && c->dimension == 2) {
        status = sfi_lists_turn(allocator, c->faces, c->face_points.starts, c->face_edges, c->edges,
                                &f.edge_faces);
    }
    if (status != SF_OK) {
        sfi_ring_finder_free(&f);
        return status;
    }
    memset(f.cell_marks, 0, count * sizeof *f.cell_marks);
    memset(f.point_marks, 0, c->points * sizeof *f.point_marks);
    *finder = f;
    return SF_OK;
}

void sfi_ring_finder_free(sfi_ring_finder *finder)
{
    const sf_allocator *allocator = &finder->allocator;
    const sfi_complex *c = finder->complex;
    if (c == NULL) {
        return;
    }
    uint32_t count = c->dimension == 3 ? c->cells : c->faces;
    sfi_free_array(allocator, finder->cell_marks, count, sizeof(uint32_t));
    sfi_free_array(allocator, finder->point_marks, c->points, sizeof(uint32_t));
    sfi_free_array(allocator, finder->point_locals, c->points, sizeof(uint32_t));
    sfi_lists_free(allocator, c->points, &finder->point_cells);
    sfi_lists_free(allocator, c->points, &finder->point_edges);
    sfi_lists_free(allocator, c->edges, &finder->edge_faces);
    sfi_free_array(allocator, finder->cells_at, finder->cell_capacity, sizeof(uint32_t));
    sfi_free_array(allocator, finder->points_at, finder->point_capacity, sizeof(uint32_t));
    sfi_free_array(allocator, finder->ring.items, finder->item_capacity, sizeof(uint32_t));
    sfi_free_array(allocator, finder->ring.outside, finder->outside_capacity, sizeof(uint32_t));
    sfi_free_array(allocator, finder->ring.shifts, finder->shift_capacity, 1);
    sfi_free_array(allocator, finder->ring.sharp, finder->sharp_capacity, sizeof(sfi_ring_sharp));
    memset(finder, 0, sizeof *finder);
}

// The number in its cell of the face (in dimension 2 the edge) that lies at a side: the prism over
// a square has its faces below, above, then in front, right, behind and left.
static uint32_t face_at_side(uint32_t dimension, uint32_t axis, uint32_t high)
{
    static const uint8_t solid[3][2] = {{5, 3}, {2, 4}, {0, 1}}, flat[2][2] = {{3, 1}, {0, 2}};
    return dimension == 3 ? solid[axis][high] : flat[axis][high];
}

uint32_t sfi_ring_across(const sfi_ring_finder *finder, uint32_t cell, uint32_t axis, uint32_t high)
{
    const sfi_ring_finder *f = finder;
    const sfi_complex *c = f->complex;
    uint32_t side = face_at_side(c->dimension, axis, high);
    if (c->dimension == 3) {
        const uint32_t *cells =
            c->face_cells + 2 * (size_t)c->cell_faces.items[c->cell_faces.starts[cell] + side];
        return cells[0] == cell ? cells[1] : cells[0];
    }
    uint32_t edge = c->face_edges[c->face_points.starts[cell] + side];
    const uint32_t *faces = f->edge_faces.items + f->edge_faces.starts[edge];
    if (f->edge_faces.starts[edge + 1] - f->edge_faces.starts[edge] < 2) {
        return SFI_NONE;
    }
    return faces[0] == cell ? faces[1] : faces[0];
}

// The place in a cell, as the complex has it, of a point.
static uint32_t place_of(const sfi_complex *c, uint32_t cell, uint32_t point)
{
    const uint32_t *corners = corners_of(c, cell);
    uint32_t corner = 0;
    while (corners[corner] != point) {
        corner++;
    }
    return sfi_hex_bits(corner);
}

// The side of a cell, as the complex has it, that holds those points of a turned cell whose place
// has `high` along `axis`.
static void turned_side(const sfi_complex *c, uint32_t cell, const uint32_t *points, uint32_t axis,
                        uint32_t high, uint32_t *own_axis, uint32_t *own_high)
{
    uint32_t all = 7, any = 0;
    for (uint32_t place = 0; place < corner_count(c); place++) {
        if ((place >> axis & 1) == high) {
            uint32_t own = place_of(c, cell, points[place]);
            all &= own;
            any |= own;
        }
    }
    uint32_t fixed = ~(all ^ any) & (corner_count(c) - 1); // the one axis along which they agree
    *own_axis = fixed == 1 ? 0 : fixed == 2 ? 1 : 2;
    *own_high = all >> *own_axis & 1;
}

// Append a cell whose points are given by place, in the complex, and where it lies.
static sf_status append(sfi_ring_finder *f, uint32_t cell, const uint32_t *points,
                        const int8_t *shift)
{
    const sf_allocator *allocator = &f->allocator;
    sfi_ring *ring = &f->ring;
    size_t corners = corner_count(f->complex), cells = (size_t)ring->cells + 1;
    if (!sfi_grow_array(allocator, (void **)&f->cells_at, &f->cell_capacity, cells,
                        sizeof(uint32_t)) ||
        !sfi_grow_array(allocator, (void **)&ring->outside, &f->outside_capacity, cells,
                        sizeof(uint32_t)) ||
        !sfi_grow_array(allocator, (void **)&ring->shifts, &f->shift_capacity, 3 * cells, 1) ||
        !sfi_grow_array(allocator, (void **)&ring->items, &f->item_capacity, corners * cells,
                        sizeof(uint32_t)) ||
        !sfi_grow_array(allocator, (void **)&f->points_at, &f->point_capacity,
                        ring->points + corners, sizeof(uint32_t))) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t place = 0; place < corners; place++) {
        uint32_t point = points[place];
        if (f->point_marks[point] != f->round) {
            f->point_marks[point] = f->round;
            f->point_locals[point] = ring->points;
            f->points_at[ring->points++] = point;
        }
        ring->items[corners * ring->cells + place] = f->point_locals[point];
    }
    memcpy(ring->shifts + 3 * (size_t)ring->cells, shift, 3);
    f->cells_at[ring->cells] = cell;
    ring->outside[ring->cells++] = 0;
    return SF_OK;
}

// The points of the cell across a side, turned as the cell that it is reached from.
static void turn_neighbour(const sfi_complex *c, uint32_t cell, const uint32_t *from, uint32_t axis,
                           uint32_t high, uint32_t *points)
{
    uint32_t own_axis = 0, own_high = 0, bit = 1u << axis;
    uint32_t shared[SFI_RING_CORNERS];
    for (uint32_t place = 0; place < corner_count(c); place++) {
        shared[place] = from[high ? place | bit : place & ~bit];
    }
    turned_side(c, cell, shared, axis, high, &own_axis, &own_high);
    for (uint32_t place = 0; place < corner_count(c); place++) {
        uint32_t own = place_of(c, cell, shared[place]);
        if ((place >> axis & 1) == high) { // away from the side that is shared
            own ^= 1u << own_axis;
        }
        points[place] = corners_of(c, cell)[sfi_hex_bits(own)];
    }
}

static int touches_first(const sfi_ring *ring, const uint32_t *items, uint32_t axis, uint32_t high)
{
    uint32_t corners = 1u << ring->dimension;
    for (uint32_t place = 0; place < corners; place++) {
        if ((place >> axis & 1) == high && items[place] < corners) {
            return 1;
        }
    }
    return 0;
}

// Look across all sides of cell `index` of the ring. Marks are twice the round: cells of the ring
// that are not in it yet; and one more: that are.
static sf_status look_around(sfi_ring_finder *f, uint32_t index)
{
    const sfi_complex *c = f->complex;
    uint32_t corners = corner_count(c);
    for (uint32_t side = 0; side < 2 * c->dimension; side++) {
        uint32_t axis = side / 2, high = side % 2, own_axis, own_high;
        uint32_t here[SFI_RING_CORNERS], there[SFI_RING_CORNERS];
        const uint32_t *items = f->ring.items + (size_t)corners * index;
        for (uint32_t place = 0; place < corners; place++) {
            here[place] = f->points_at[items[place]];
        }
        turned_side(c, f->cells_at[index], here, axis, high, &own_axis, &own_high);
        uint32_t next = sfi_ring_across(f, f->cells_at[index], own_axis, own_high);
        if (next == SFI_NONE) {
            f->ring.outside[index] |= touches_first(&f->ring, items, axis, high) ? 1u << side : 0;
        } else if (f->cell_marks[next] == 2 * f->round) {
            f->cell_marks[next]++;
            turn_neighbour(c, next, here, axis, high, there);
            int8_t shift[3];
            memcpy(shift, f->ring.shifts + 3 * (size_t)index, sizeof shift);
            shift[axis] = (int8_t)(shift[axis] + (high ? 1 : -1));
            SF_TRY(append(f, next, there, shift));
        }
    }
    return SF_OK;
}

static sf_status add_sharp(sfi_ring_finder *f, uint32_t a, uint32_t b, double sharpness)
{
    sfi_ring *ring = &f->ring;
    if (!sfi_grow_array(&f->allocator, (void **)&ring->sharp, &f->sharp_capacity,
                        (size_t)ring->sharps + 1, sizeof *ring->sharp)) {
        return SF_ERR_MEMORY;
    }
    sfi_ring_sharp sharp = {a, b, sharpness < SF_SHARP ? sharpness : SF_SHARP};
    uint32_t at = ring->sharps++;
    for (; at > 0 &&
           (ring->sharp[at - 1].a > a || (ring->sharp[at - 1].a == a && ring->sharp[at - 1].b > b));
         at--) {
        ring->sharp[at] = ring->sharp[at - 1];
    }
    ring->sharp[at] = sharp;
    return SF_OK;
}

// Sharp points of the first cell, and sharp edges from them, each once.
static sf_status find_sharp(sfi_ring_finder *f)
{
    const sfi_complex *c = f->complex;
    uint32_t corners = corner_count(c);
    for (uint32_t a = 0; a < corners; a++) {
        uint32_t point = f->points_at[a];
        if (c->point_sharpness[point] > 0) {
            SF_TRY(add_sharp(f, a, a, c->point_sharpness[point]));
        }
        for (uint32_t i = f->point_edges.starts[point]; i < f->point_edges.starts[point + 1]; i++) {
            uint32_t edge = f->point_edges.items[i];
            const uint32_t *ends = c->edge_points + 2 * (size_t)edge;
            uint32_t b = f->point_locals[ends[0] == point ? ends[1] : ends[0]];
            if (c->edge_sharpness[edge] > 0 && (b > a || b >= corners)) {
                SF_TRY(add_sharp(f, a, b, c->edge_sharpness[edge]));
            }
        }
    }
    return SF_OK;
}

sf_status sfi_ring_find(sfi_ring_finder *finder, uint32_t cell)
{
    sfi_ring_finder *f = finder;
    const sfi_complex *c = f->complex;
    uint32_t first[SFI_RING_CORNERS];
    f->round++;
    f->ring.cells = f->ring.points = f->ring.sharps = 0;
    for (uint32_t place = 0; place < corner_count(c); place++) {
        uint32_t point = corners_of(c, cell)[sfi_hex_bits(place)];
        first[place] = point;
        for (uint32_t i = f->point_cells.starts[point]; i < f->point_cells.starts[point + 1]; i++) {
            f->cell_marks[f->point_cells.items[i]] = 2 * f->round;
        }
    }
    f->cell_marks[cell]++;
    static const int8_t here[3] = {0, 0, 0};
    SF_TRY(append(f, cell, first, here));
    for (uint32_t i = 0; i < f->ring.cells; i++) {
        SF_TRY(look_around(f, i));
    }
    return find_sharp(f);
}

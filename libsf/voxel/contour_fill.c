// SPDX-License-Identifier: MIT
// Contours to voxels: the rows of a lattice, each cut by the edges that it crosses.
//
// Points become integers once, 8192 to a voxel, with voxel centres at odd multiples of 4096. From
// there on nothing is rounded. An edge crosses the row whose centre line y lies at y0 <= y < y1 (y0
// its lower end), and turns what is inside for all centres right of the crossing or on it. Both
// rules are half open, so edges that are shared cancel exactly, a point on a centre line is crossed
// once or twice but never by half, and edges along a row count for nothing.
//
// The crossing of an edge is the least i with 8192 i + 4096 >= x0 + dx (y - y0) / dy, or
//     i = ceil(((x0 - 4096) dy + dx (y - y0)) / (8192 dy)).
// Coordinates are at most 2^30, so |x0 - 4096| dy <= 2^61, dx (y - y0) <= 2^62, and their sum fits
// an int64_t.
//
// Edges wait in a list for the first row that they cross, and then are looked at row by row until
// the last: memory knows the points and the rows, never how often they cross.
//
// Source: W. J. Bouknight, "A Procedure for Generation of Three-Dimensional Half-Toned Computer
// Graphics Presentations", Communications of the ACM 13(9), 1970.

#include "base/memory.h"
#include "base/status.h"
#include "voxel/contour.h"
#include "voxel/slice.h"

#include <math.h>

#define UNIT 8192
#define NO_EDGE UINT32_MAX

// From its lower end to its upper one; `way` is 1 where the contour goes up, -1 where down.
typedef struct edge {
    int32_t x0, y0, x1, y1, way;
    uint32_t row_end; // the row after the last that it crosses
    uint32_t next;    // of those that begin in the same row
} edge;

// Where a row is crossed: the first voxel behind the crossing, above its way (1 for up).
typedef uint64_t crossing;

typedef struct drawing {
    const sf_lattice *lattice;
    const sf_contours *contours;
    sf_contour_fill fill;
    sfi_contour_run run;
    void *user;
    edge *edges;
    size_t edge_capacity, edge_count;
    uint32_t *first;  // of each row, the first edge that begins there
    uint32_t *active; // edges that the row crosses
    size_t active_count;
    crossing *crossings;
} drawing;

sf_status sfi_contour_check(const sf_contours *contours, size_t *points)
{
    if (contours == NULL || (contours->starts == NULL && contours->contour_count > 0) ||
        contours->contour_count == SIZE_MAX) {
        return SF_ERR_ARGUMENT;
    }
    *points = 0;
    if (contours->contour_count == 0) {
        return SF_OK;
    }
    for (size_t i = 0; i < contours->contour_count; i++) {
        if (contours->starts[i] > contours->starts[i + 1]) {
            return SF_ERR_ARGUMENT;
        }
    }
    *points = contours->starts[contours->contour_count];
    return contours->starts[0] != 0 || (contours->points_mm == NULL && *points > 0)
               ? SF_ERR_ARGUMENT
               : SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Edges
// ---------------------------------------------------------------------------------------------

// A point in 1/8192 voxel from the lattice's corner.
static sf_status snap(const drawing *d, size_t point, int32_t at[2], sf_fault *fault)
{
    double pitch[2] = {d->lattice->pitch_x_mm, d->lattice->pitch_y_mm};
    for (int i = 0; i < 2; i++) {
        double mm = d->contours->points_mm[2 * point + (size_t)i];
        double voxels = (mm - d->lattice->origin_mm[i]) / pitch[i];
        if (!isfinite(mm)) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "point %zu of the contours is not finite", point);
        }
        if (!(fabs(voxels) <= SF_CONTOUR_REACH_MAX)) {
            return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                                 "point %zu of the contours lies more than 131072 voxels from the "
                                 "lattice's corner; take larger voxels",
                                 point);
        }
        at[i] = (int32_t)floor(voxels * UNIT + 0.5);
    }
    return SF_OK;
}

// The first row whose centre line lies at y or above it, at most `rows`.
static uint32_t row_from(int32_t y, uint32_t rows)
{
    int64_t up = (int64_t)y - UNIT / 2 + (UNIT - 1);
    uint32_t row = up <= 0 ? 0 : (uint32_t)(up / UNIT);
    return row < rows ? row : rows;
}

static void add_edge(drawing *d, const int32_t a[2], const int32_t b[2])
{
    int up = a[1] < b[1];
    const int32_t *low = up ? a : b, *high = up ? b : a;
    uint32_t begin = row_from(low[1], d->lattice->ny), end = row_from(high[1], d->lattice->ny);
    if (begin >= end) {
        return; // also where it lies along the rows
    }
    edge made = {low[0], low[1], high[0], high[1], up ? 1 : -1, end, d->first[begin]};
    d->first[begin] = (uint32_t)d->edge_count;
    d->edges[d->edge_count++] = made;
}

static sf_status add_edges(drawing *d, sf_fault *fault)
{
    for (uint32_t y = 0; y < d->lattice->ny; y++) {
        d->first[y] = NO_EDGE;
    }
    for (size_t c = 0; c < d->contours->contour_count; c++) {
        size_t begin = d->contours->starts[c], end = d->contours->starts[c + 1];
        int32_t last[2], here[2];
        if (begin < end) {
            SF_TRY(snap(d, end - 1, last, fault));
        }
        for (size_t i = begin; i < end; i++) {
            SF_TRY(snap(d, i, here, fault));
            add_edge(d, last, here);
            last[0] = here[0];
            last[1] = here[1];
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Rows
// ---------------------------------------------------------------------------------------------

static int64_t ceil_div(int64_t a, int64_t b)
{
    return a >= 0 ? (a + b - 1) / b : -(-a / b);
}

static crossing cross(const edge *e, uint32_t y, uint32_t width)
{
    int64_t line = (int64_t)y * UNIT + UNIT / 2, dy = (int64_t)e->y1 - e->y0;
    int64_t dx = (int64_t)e->x1 - e->x0;
    // ceil_div adds less than 8192 dy <= 2^44 to it.
    int64_t x = ceil_div(((int64_t)e->x0 - UNIT / 2) * dy + dx * (line - e->y0), UNIT * dy);
    uint64_t voxel = x <= 0 ? 0 : x >= width ? width : (uint64_t)x;
    return voxel << 1 | (e->way > 0);
}

// Heapsort, or insertion where there are few: J. W. J. Williams, "Algorithm 232", 1964.
static void sink(crossing *items, size_t at, size_t count)
{
    crossing held = items[at];
    for (size_t child; (child = 2 * at + 1) < count; at = child) {
        child += child + 1 < count && items[child] < items[child + 1];
        if (held >= items[child]) {
            break;
        }
        items[at] = items[child];
    }
    items[at] = held;
}

static void sort(crossing *items, size_t count)
{
    if (count <= 24) {
        for (size_t i = 1; i < count; i++) {
            crossing held = items[i];
            size_t at = i;
            for (; at > 0 && items[at - 1] > held; at--) {
                items[at] = items[at - 1];
            }
            items[at] = held;
        }
        return;
    }
    for (size_t i = count / 2; i-- > 0;) {
        sink(items, i, count);
    }
    for (size_t i = count; i-- > 1;) {
        crossing last = items[i];
        items[i] = items[0];
        items[0] = last;
        sink(items, 0, i);
    }
}

// Hand on the runs of a row whose crossings are sorted.
static sf_status hand_on(const drawing *d, uint32_t y)
{
    int64_t turns = 0;
    uint32_t begun = 0, width = d->lattice->nx;
    int inside = 0;
    for (size_t i = 0; i < d->active_count; i++) {
        uint32_t x = (uint32_t)(d->crossings[i] >> 1);
        turns += d->fill == SF_CONTOUR_EVEN_ODD || (d->crossings[i] & 1) != 0 ? 1 : -1;
        if (i + 1 < d->active_count && d->crossings[i + 1] >> 1 == x) {
            continue; // what happens in one place happens at once
        }
        int now = d->fill == SF_CONTOUR_EVEN_ODD ? (turns & 1) != 0 : turns != 0;
        if (inside && !now && begun < x) {
            SF_TRY(d->run(d->user, begun, x, y));
        }
        if (now && !inside) {
            begun = x;
        }
        inside = now;
    }
    return inside && begun < width ? d->run(d->user, begun, width, y) : SF_OK;
}

static sf_status draw_rows(drawing *d)
{
    for (uint32_t y = 0; y < d->lattice->ny; y++) {
        size_t kept = 0;
        for (size_t i = 0; i < d->active_count; i++) {
            if (d->edges[d->active[i]].row_end > y) {
                d->active[kept++] = d->active[i];
            }
        }
        for (uint32_t e = d->first[y]; e != NO_EDGE; e = d->edges[e].next) {
            d->active[kept++] = e;
        }
        d->active_count = kept;
        for (size_t i = 0; i < kept; i++) {
            d->crossings[i] = cross(&d->edges[d->active[i]], y, d->lattice->nx);
        }
        sort(d->crossings, kept);
        SF_TRY(hand_on(d, y));
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Drawing
// ---------------------------------------------------------------------------------------------

static sf_status draw(drawing *d, const sf_allocator *allocator, sf_fault *fault)
{
    size_t n = d->edge_capacity, rows = d->lattice->ny;
    d->first = sfi_alloc_array(allocator, rows, sizeof *d->first);
    d->edges = sfi_alloc_array(allocator, n, sizeof *d->edges);
    d->active = sfi_alloc_array(allocator, n, sizeof *d->active);
    sf_status status = SF_ERR_MEMORY;
    if (d->first != NULL && d->edges != NULL && d->active != NULL) {
        status = add_edges(d, fault);
    }
    size_t edges = d->edge_count;
    if (status == SF_OK && edges > 0) {
        d->crossings = sfi_alloc_array(allocator, edges, sizeof *d->crossings);
        status = d->crossings != NULL ? draw_rows(d) : SF_ERR_MEMORY;
    }
    sfi_free_array(allocator, d->crossings, edges, sizeof *d->crossings);
    sfi_free_array(allocator, d->active, n, sizeof *d->active);
    sfi_free_array(allocator, d->edges, n, sizeof *d->edges);
    sfi_free_array(allocator, d->first, rows, sizeof *d->first);
    return status;
}

sf_status sfi_contour_draw(const sf_lattice *lattice, const sf_contours *contours,
                           sf_contour_fill fill, const sf_allocator *allocator, sf_fault *fault,
                           sfi_contour_run run, void *user)
{
    size_t points = 0;
    SF_TRY(sf_lattice_validate(lattice));
    SF_TRY(sfi_contour_check(contours, &points));
    if (fill != SF_CONTOUR_NONZERO && fill != SF_CONTOUR_EVEN_ODD) {
        return SF_ERR_ARGUMENT;
    }
    if (points >= NO_EDGE) {
        return SF_ERR_OVERFLOW;
    }
    if (points == 0) {
        return SF_OK;
    }
    drawing d = {.lattice = lattice,
                 .contours = contours,
                 .fill = fill,
                 .run = run,
                 .user = user,
                 .edge_capacity = points};
    sf_allocator from = sfi_allocator_or_default(allocator);
    return draw(&d, &from, fault);
}

// A slice that is drawn into: emptied at the first run, when nothing can be refused any more.
typedef struct canvas {
    sf_slice slice;
    int is_clear;
} canvas;

static sf_status paint(void *user, uint32_t x0, uint32_t x1, uint32_t y)
{
    canvas *to = user;
    sf_rect rect = {x0, y, x1, y + 1};
    if (!to->is_clear) {
        sfi_slice_clear(to->slice);
        to->is_clear = 1;
    }
    return sf_slice_fill(to->slice, rect, 1);
}

sf_status sf_slice_from_contours(sf_slice dst, const sf_lattice *lattice,
                                 const sf_contours *contours, sf_contour_fill fill,
                                 const sf_allocator *allocator, sf_fault *fault)
{
    SF_TRY(sfi_slice_validate(dst));
    SF_TRY(sf_lattice_validate(lattice));
    if (dst.width != lattice->nx || dst.height != lattice->ny) {
        return SF_ERR_SHAPE;
    }
    canvas to = {dst, 0};
    SF_TRY(sfi_contour_draw(lattice, contours, fill, allocator, fault, paint, &to));
    if (!to.is_clear) {
        sfi_slice_clear(dst);
    }
    return SF_OK;
}

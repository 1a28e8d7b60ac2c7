// SPDX-License-Identifier: MIT
// Skins: the limit surface, cut into triangles that close.
//
// The outside of a solid is a surface by itself, of quadrilaterals; it is charted as such, because
// where blocks have smooth edges the solid is irregular and its surface is not. All sides are cut
// into the same number of strips along both axes, and what lies on edges and corners is worked out
// once for all that meet there, so that the triangles close by their numbers.
//
// How many strips: between the corners of a triangle of a grid m times as fine, a surface deviates
// from it by no more than (|f_uu| + 2 |f_uv| + |f_vv|) / (8 m^2) (the remainder of Taylor's
// formula), and second derivatives of a spline lie within the second differences of its
// coefficients. Of irregular sides the pieces are asked for theirs, twice over.

#include "grade/sample/skin.h"

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "grade/cage/sharp.h"
#include "grade/limit/descend.h"
#include "grade/limit/spline.h"

#include <math.h>
#include <string.h>

enum { MOST_STRIPS = 64, BOUND_DEPTH = 2 };

// What it takes to cut a skin.
typedef struct cutter {
    const sf_limit *limit;
    const double *positions; // of the points that pieces are made of
    sf_allocator allocator;
    uint32_t sides;
    uint32_t *starts, *corners; // of the sides, as cells of dimension 2
    sfi_complex surface;
    sfi_chart chart;
    uint32_t strips;
    double bound; // of the deviation with one strip
    double *scratch;
    size_t scratch_count;
} cutter;

static void free_cutter(cutter *c)
{
    sfi_chart_free(&c->chart);
    sfi_complex_free(&c->surface);
    sfi_free_array(&c->allocator, c->starts, (size_t)c->sides + 1, sizeof *c->starts);
    sfi_free_array(&c->allocator, c->corners, 4 * (size_t)c->sides, sizeof *c->corners);
    sfi_free_array(&c->allocator, c->scratch, c->scratch_count, sizeof *c->scratch);
}

// The corners around each side of a hexahedron, seen from outside counter-clockwise.
static const uint8_t side_corners[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                           {2, 3, 7, 6}, {0, 3, 2, 1}, {4, 5, 6, 7}};

static sf_status collect_sides(cutter *c)
{
    const sfi_chart *solid = &c->limit->charts[0];
    const uint32_t *corners = c->limit->refined->layouts[0].corners[1];
    size_t count = 0;
    for (size_t i = 0; i < 6 * (size_t)solid->pieces; i++) {
        count += solid->across[i] == SFI_NONE;
    }
    if (count == 0) {
        return SF_ERR_UNSUPPORTED; // cells that close upon themselves: all faces have two
    }
    c->sides = (uint32_t)count;
    c->starts = sfi_alloc_array(&c->allocator, count + 1, sizeof *c->starts);
    c->corners = sfi_alloc_array(&c->allocator, 4 * count, sizeof *c->corners);
    if (c->starts == NULL || c->corners == NULL) {
        return SF_ERR_MEMORY;
    }
    uint32_t side = 0;
    for (size_t i = 0; i < 6 * (size_t)solid->pieces; i++) {
        for (uint32_t j = 0; solid->across[i] == SFI_NONE && j < 4; j++) {
            c->corners[4 * (size_t)side + j] = corners[8 * (i / 6) + side_corners[i % 6][j]];
        }
        side += solid->across[i] == SFI_NONE;
    }
    for (uint32_t i = 0; i <= c->sides; i++) {
        c->starts[i] = 4 * i;
    }
    return SF_OK;
}

static sf_status chart_surface(cutter *c, sf_task *task)
{
    const sfi_layout *layout = &c->limit->refined->layouts[0];
    sfi_corners corners = {2, layout->points[1], c->sides, c->starts, c->corners};
    sf_cage_view sharp;
    memset(&sharp, 0, sizeof sharp);
    sharp.crease_count = layout->crease_counts[1];
    sharp.creases = layout->creases[1];
    sharp.sharp_count = layout->sharp_counts[1];
    sharp.sharps = layout->sharps[1];
    SF_TRY(sfi_complex_build(&corners, &c->allocator, &c->surface, NULL));
    SF_TRY(sfi_sharp_set(&sharp, &c->surface, NULL));
    SF_TRY(sfi_chart_make(&c->surface, 0, &c->allocator, task, &c->chart));
    c->scratch_count = (size_t)(3 + BOUND_DEPTH) * 3 * c->chart.atlas.most_points;
    c->scratch = sfi_alloc_array(&c->allocator, c->scratch_count, sizeof *c->scratch);
    return c->scratch == NULL ? SF_ERR_MEMORY : SF_OK;
}

// ---------------------------------------------------------------------------------------------
// How fine
// ---------------------------------------------------------------------------------------------

static double length(const double d[3])
{
    return sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

// The largest of the second differences a - b - c + d of coefficients at i, i + bc, i + bc' , i +
// dd.
static double difference(const sfi_spline *s, uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
    double sum[3];
    for (uint32_t axis = 0; axis < 3; axis++) {
        sum[axis] = s->rest[3 * a + axis] - s->rest[3 * b + axis] - s->rest[3 * c + axis] +
                    s->rest[3 * d + axis];
    }
    return length(sum);
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

static double spline_bound(const sfi_spline *s)
{
    double uu = 0, uv = 0, vv = 0;
    for (uint32_t y = 0; y < 4; y++) {
        for (uint32_t x = 0; x < 4; x++) {
            uint32_t i = 4 * y + x;
            uu = x < 2 ? larger(uu, difference(s, i, i + 1, i + 1, i + 2)) : uu;
            vv = y < 2 ? larger(vv, difference(s, i, i + 4, i + 4, i + 8)) : vv;
            uv = x < 3 && y < 3 ? larger(uv, difference(s, i, i + 1, i + 4, i + 5)) : uv;
        }
    }
    return (uu + 2 * uv + vv) / 8;
}

// A bound of the deviation over one side, of which the ring's positions are given.
static double side_bound(const cutter *c, uint32_t kind, const double *values, uint32_t depth)
{
    const sfi_kind *k = &c->chart.atlas.kinds[kind];
    if (k->is_regular) {
        sfi_spline spline;
        sfi_spline_gather(&k->net, 2, 3, values, &spline);
        return spline_bound(&spline);
    }
    double bound = 0;
    double *ring = c->scratch + (size_t)(3 + depth) * 3 * c->chart.atlas.most_points;
    for (uint32_t place = 0; depth < BOUND_DEPTH && place < 4; place++) {
        sfi_matrix_apply(&k->steps[place], 3, values, ring, NULL);
        bound = larger(bound, 4 * side_bound(c, k->children[place], ring, depth + 1));
    }
    return bound;
}

static void choose_strips(cutter *c, double tolerance)
{
    for (uint32_t side = 0; side < c->sides; side++) {
        sfi_chart_gather(&c->chart, side, 3, c->positions, c->scratch);
        c->bound = larger(c->bound, side_bound(c, c->chart.kinds[side], c->scratch, 0));
    }
    c->strips = 1;
    while (c->strips < MOST_STRIPS &&
           c->bound > tolerance * (double)c->strips * (double)c->strips) {
        c->strips++;
    }
}

// ---------------------------------------------------------------------------------------------
// Vertices and triangles
// ---------------------------------------------------------------------------------------------

// Numbers of vertices: those of points, then of edges, then within sides.
static uint32_t edge_vertex(const cutter *c, uint32_t edge, uint32_t from, uint32_t at)
{
    int forwards = c->surface.edge_points[2 * (size_t)edge] == from;
    uint32_t place = forwards ? at : c->strips - at;
    return c->surface.points + edge * (c->strips - 1) + place - 1;
}

// The vertex at (x, y) of a side's grid, x from its first corner to its second, y to its fourth.
static uint32_t vertex_at(const cutter *c, uint32_t side, uint32_t x, uint32_t y)
{
    const uint32_t *p = c->surface.face_points.items + 4 * (size_t)side;
    const uint32_t *e = c->surface.face_edges + 4 * (size_t)side;
    uint32_t m = c->strips;
    int x_end = x == 0 || x == m, y_end = y == 0 || y == m;
    if (x_end && y_end) {
        return p[y == 0 ? (x == 0 ? 0 : 1) : (x == 0 ? 3 : 2)];
    }
    if (y_end) {
        return y == 0 ? edge_vertex(c, e[0], p[0], x) : edge_vertex(c, e[2], p[3], x);
    }
    if (x_end) {
        return x == 0 ? edge_vertex(c, e[3], p[0], y) : edge_vertex(c, e[1], p[1], y);
    }
    return c->surface.points + c->surface.edges * (m - 1) + (side * (m - 1) + y - 1) * (m - 1) + x -
           1;
}

// Work out the vertices of a side that nobody has so far.
static void place_vertices(const cutter *c, uint32_t side, uint8_t *done, double *vertices)
{
    const sfi_atlas *atlas = &c->chart.atlas;
    double *ring = c->scratch, *rest = ring + 3 * (size_t)atlas->most_points;
    sfi_chart_gather(&c->chart, side, 3, c->positions, ring);
    for (uint32_t y = 0; y <= c->strips; y++) {
        for (uint32_t x = 0; x <= c->strips; x++) {
            uint32_t vertex = vertex_at(c, side, x, y);
            double u[2] = {(double)x / c->strips, (double)y / c->strips};
            if (!done[vertex]) {
                done[vertex] = 1;
                sfi_limit_at(atlas, c->chart.kinds[side], 3, ring, u, rest,
                             vertices + 3 * (size_t)vertex, NULL);
            }
        }
    }
}

static void place_triangles(const cutter *c, uint32_t side, uint32_t *triangles)
{
    for (uint32_t y = 0; y < c->strips; y++) {
        for (uint32_t x = 0; x < c->strips; x++) {
            uint32_t a = vertex_at(c, side, x, y), b = vertex_at(c, side, x + 1, y);
            uint32_t d = vertex_at(c, side, x, y + 1), e = vertex_at(c, side, x + 1, y + 1);
            uint32_t two[6] = {a, b, e, a, e, d};
            memcpy(triangles, two, sizeof two);
            triangles += 6;
        }
    }
}

// Points inside of the solid have numbers too, but no side: they are left at the first vertex used,
// where nothing refers to them.
static void fill_unused(const uint8_t *done, size_t count, double *vertices)
{
    size_t used = 0;
    while (used < count && !done[used]) {
        used++;
    }
    for (size_t i = 0; i < count; i++) {
        if (!done[i]) {
            memcpy(vertices + 3 * i, vertices + 3 * used, 3 * sizeof *vertices);
        }
    }
}

static sf_status fill(cutter *c, sf_task *task, sfi_skin *skin)
{
    size_t m = c->strips, inside = (m - 1) * (m - 1);
    skin->vertex_count = c->surface.points + c->surface.edges * (m - 1) + c->sides * inside;
    skin->triangle_count = 2 * m * m * c->sides;
    if (skin->vertex_count > INT32_MAX || skin->triangle_count > INT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    skin->vertices = sfi_alloc_array(&c->allocator, skin->vertex_count, 3 * sizeof(double));
    skin->triangles = sfi_alloc_array(&c->allocator, skin->triangle_count, 3 * sizeof(uint32_t));
    uint8_t *done = sfi_alloc_array(&c->allocator, skin->vertex_count, 1);
    sf_status status =
        skin->vertices == NULL || skin->triangles == NULL || done == NULL ? SF_ERR_MEMORY : SF_OK;
    if (done != NULL) {
        memset(done, 0, skin->vertex_count);
    }
    sfi_progress progress = sfi_progress_begin(task);
    for (uint32_t side = 0; status == SF_OK && side < c->sides; side++) {
        place_vertices(c, side, done, skin->vertices);
        place_triangles(c, side, skin->triangles + 6 * m * m * side);
        if (side % 256 == 0) {
            sfi_progress_report(&progress, side, c->sides);
            status = sf_task_is_cancelled(task) ? SF_ERR_CANCELLED : SF_OK;
        }
    }
    if (status == SF_OK) {
        fill_unused(done, skin->vertex_count, skin->vertices);
    }
    sfi_free_array(&c->allocator, done, skin->vertex_count, 1);
    return status;
}

void sfi_skin_free(sfi_skin *skin)
{
    sfi_free_array(&skin->allocator, skin->vertices, skin->vertex_count, 3 * sizeof(double));
    sfi_free_array(&skin->allocator, skin->triangles, skin->triangle_count, 3 * sizeof(uint32_t));
    memset(skin, 0, sizeof *skin);
}

sf_status sfi_skin_make(const sf_limit *limit, double tolerance_mm, const sf_allocator *allocator,
                        sf_task *task, sfi_skin *skin)
{
    cutter c;
    sfi_skin made;
    memset(&c, 0, sizeof c);
    memset(&made, 0, sizeof made);
    c.limit = limit;
    c.positions = limit->refined->positions[1];
    c.allocator = made.allocator = *allocator;
    sfi_progress progress = sfi_progress_begin(task);
    sfi_part part;
    sf_status status = collect_sides(&c);
    if (status == SF_OK) {
        sfi_part_begin(&part, &progress, 0, 0.5);
        status = chart_surface(&c, &part.task);
    }
    if (status == SF_OK) {
        choose_strips(&c, tolerance_mm);
        made.error_mm = c.bound / ((double)c.strips * c.strips);
        sfi_part_begin(&part, &progress, 0.5, 1);
        status = fill(&c, &part.task, &made);
    }
    free_cutter(&c);
    if (status == SF_OK) {
        *skin = made;
    } else {
        sfi_skin_free(&made);
    }
    return status;
}

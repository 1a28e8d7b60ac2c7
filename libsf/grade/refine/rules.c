// SPDX-License-Identifier: MIT
// Rules of subdivision: where the points of the finer mesh come to lie.
//
// Inside, the rules of K. I. Joy and R. MacCracken, "The refinement rules for Catmull-Clark
// solids", 1999: on a regular grid they are those of the tri-cubic B-spline. On the boundary those
// of E. Catmull and J. Clark, "Recursively generated B-spline surfaces on arbitrary topological
// meshes", 1978, so that the outside does not depend on the inside. Sharp edges and points, also
// partly sharp ones, after T. DeRose, M. Kass and T. Truong, "Subdivision surfaces in character
// animation", 1998: a sharpness falls by 1 with each step, and where it passes 0 within the step
// the two rules are mixed.
//
// With n cells around an edge the rule above is, along the edge, not the product of a surface's
// rule and a curve's: an extruded shape is not what its cross section is. The separable rule is
// that product, at points with just two such edges in a line.

#include "grade/refine/rules.h"

#include "base/status.h"

// ---------------------------------------------------------------------------------------------
// Means
// ---------------------------------------------------------------------------------------------

static void add_list(sfi_row *row, const sfi_lists *lists, uint32_t list, double weight)
{
    uint32_t start = lists->starts[list], end = lists->starts[list + 1];
    for (uint32_t i = start; i < end; i++) {
        sfi_row_add(row, lists->items[i], weight / (end - start));
    }
}

static void add_cell(const sfi_rules *r, sfi_row *row, uint32_t cell, double weight)
{
    add_list(row, &r->complex->cell_points, cell, weight);
}

static void add_face(const sfi_rules *r, sfi_row *row, uint32_t face, double weight)
{
    add_list(row, &r->complex->face_points, face, weight);
}

static void add_edge(const sfi_rules *r, sfi_row *row, uint32_t edge, double weight)
{
    const uint32_t *ends = r->complex->edge_points + 2 * (size_t)edge;
    sfi_row_add(row, ends[0], weight / 2);
    sfi_row_add(row, ends[1], weight / 2);
}

typedef void add_element(const sfi_rules *r, sfi_row *row, uint32_t element, double weight);

// The mean of what a list names.
static void add_mean(const sfi_rules *r, sfi_row *row, add_element *add, const sfi_lists *lists,
                     uint32_t list, double weight)
{
    uint32_t start = lists->starts[list], end = lists->starts[list + 1];
    for (uint32_t i = start; i < end; i++) {
        add(r, row, lists->items[i], weight / (end - start));
    }
}

static uint32_t list_size(const sfi_lists *lists, uint32_t list)
{
    return lists->starts[list + 1] - lists->starts[list];
}

// ---------------------------------------------------------------------------------------------
// Faces and edges
// ---------------------------------------------------------------------------------------------

static void add_face_point(const sfi_rules *rules, sfi_row *row, uint32_t face)
{
    const uint32_t *cells = rules->complex->face_cells + 2 * (size_t)face;
    if (sfi_on_surface(rules->complex, face)) {
        add_face(rules, row, face, 1);
        return;
    }
    add_cell(rules, row, cells[0], 0.25);
    add_face(rules, row, face, 0.5);
    add_cell(rules, row, cells[1], 0.25);
}

// Half the mean of the surface's faces there, half the middle.
static void add_smooth_edge(const sfi_rules *r, sfi_row *row, uint32_t edge, double weight)
{
    const sfi_lists *lists = &r->edge_faces;
    uint32_t count = 0;
    for (uint32_t i = lists->starts[edge]; i < lists->starts[edge + 1]; i++) {
        count += sfi_on_surface(r->complex, lists->items[i]) ? 1 : 0;
    }
    for (uint32_t i = lists->starts[edge]; i < lists->starts[edge + 1]; i++) {
        if (sfi_on_surface(r->complex, lists->items[i])) {
            add_face(r, row, lists->items[i], weight / 2 / count);
        }
    }
    add_edge(r, row, edge, weight / 2);
}

static void add_edge_point(const sfi_rules *rules, sfi_row *row, uint32_t edge)
{
    const sfi_complex *c = rules->complex;
    if (c->dimension == 3 && !c->edge_outside[edge]) {
        double n = list_size(&rules->edge_faces, edge);
        add_mean(rules, row, add_cell, &rules->edge_cells, edge, 1 / n);
        add_mean(rules, row, add_face, &rules->edge_faces, edge, 2 / n);
        add_edge(rules, row, edge, (n - 3) / n);
        return;
    }
    double sharpness = c->edge_sharpness[edge];
    if (c->dimension == 2 && c->edge_outside[edge]) {
        sharpness = SF_SHARP;
    }
    double sharp = sharpness < 1 ? sharpness : 1;
    if (sharp > 0) {
        add_edge(rules, row, edge, sharp);
    }
    if (sharp < 1) {
        add_smooth_edge(rules, row, edge, 1 - sharp);
    }
}

// ---------------------------------------------------------------------------------------------
// Points of the surface
// ---------------------------------------------------------------------------------------------

static double edge_sharpness(const sfi_complex *c, uint32_t edge)
{
    return c->dimension == 2 && c->edge_outside[edge] ? SF_SHARP : c->edge_sharpness[edge];
}

static int edge_on_surface(const sfi_complex *c, uint32_t edge)
{
    return c->dimension == 2 || c->edge_outside[edge];
}

// What a point of the surface is, by what is sharp there.
typedef struct sharpness {
    uint32_t edges;     // how many are sharp
    uint32_t crease[2]; // two of them
    int corner;         // the point itself is
} sharpness;

// Which kind of rule that asks for.
typedef enum kind { SMOOTH, CREASE, CORNER } kind;

static kind kind_of(const sharpness *s)
{
    return s->corner || s->edges > 2 ? CORNER : s->edges == 2 ? CREASE : SMOOTH;
}

// Before this step and after it. `passing` is the mean sharpness, at most 1, of what stops to be
// sharp in it.
static void look(const sfi_rules *r, uint32_t point, sharpness *before, sharpness *after,
                 double *passing)
{
    const sfi_complex *c = r->complex;
    double own = c->point_sharpness[point], sum = 0;
    uint32_t count = 0;
    sharpness none = {0, {0, 0}, 0};
    *before = *after = none;
    before->corner = own > 0;
    after->corner = sfi_less_sharp(own) > 0;
    if (before->corner && !after->corner) {
        sum += own;
        count++;
    }
    for (uint32_t i = r->point_edges.starts[point]; i < r->point_edges.starts[point + 1]; i++) {
        uint32_t edge = r->point_edges.items[i];
        double sharp = edge_on_surface(c, edge) ? edge_sharpness(c, edge) : 0;
        if (sharp > 0) {
            before->crease[before->edges++ & 1] = edge;
        }
        if (sfi_less_sharp(sharp) > 0) {
            after->crease[after->edges++ & 1] = edge;
        } else if (sharp > 0) {
            sum += sharp;
            count++;
        }
    }
    *passing = count == 0 || sum >= count ? 1 : sum / count;
}

// (mean of faces + 2 mean of edges + (n - 3) point) / n, of those on the surface.
static void add_smooth_point(const sfi_rules *r, sfi_row *row, uint32_t point, double weight)
{
    const sfi_complex *c = r->complex;
    const sfi_lists *faces = &r->point_faces, *edges = &r->point_edges;
    double n = 0, m = 0;
    for (uint32_t i = faces->starts[point]; i < faces->starts[point + 1]; i++) {
        n += sfi_on_surface(c, faces->items[i]);
    }
    for (uint32_t i = edges->starts[point]; i < edges->starts[point + 1]; i++) {
        m += edge_on_surface(c, edges->items[i]);
    }
    for (uint32_t i = faces->starts[point]; i < faces->starts[point + 1]; i++) {
        if (sfi_on_surface(c, faces->items[i])) {
            add_face(r, row, faces->items[i], weight / n / n);
        }
    }
    for (uint32_t i = edges->starts[point]; i < edges->starts[point + 1]; i++) {
        if (edge_on_surface(c, edges->items[i])) {
            add_edge(r, row, edges->items[i], 2 * weight / n / m);
        }
    }
    sfi_row_add(row, point, weight * (n - 3) / n);
}

static void add_surface_point(const sfi_rules *r, sfi_row *row, uint32_t point, const sharpness *s,
                              double weight)
{
    switch (kind_of(s)) {
    case SMOOTH:
        add_smooth_point(r, row, point, weight);
        break;
    case CREASE:
        sfi_row_add(row, point, weight / 2);
        add_edge(r, row, s->crease[0], weight / 4);
        add_edge(r, row, s->crease[1], weight / 4);
        break;
    default:
        sfi_row_add(row, point, weight);
    }
}

// ---------------------------------------------------------------------------------------------
// Points inside
// ---------------------------------------------------------------------------------------------

// The two edges of a point that are in a line and around which the same number of cells, but not
// four, go, where all its other edges are regular: an extruded point. Returns that number, or 0.
static uint32_t extruded(const sfi_rules *r, uint32_t point, uint32_t line[2])
{
    const sfi_lists *edges = &r->point_edges;
    uint32_t found = 0;
    for (uint32_t i = edges->starts[point]; i < edges->starts[point + 1]; i++) {
        if (list_size(&r->edge_faces, edges->items[i]) != 4) {
            if (found == 2) {
                return 0;
            }
            line[found++] = edges->items[i];
        }
    }
    uint32_t n = found == 2 ? list_size(&r->edge_faces, line[0]) : 0;
    if (n == 0 || list_size(&r->edge_faces, line[1]) != n || list_size(edges, point) != n + 2 ||
        list_size(&r->point_cells, point) != 2 * n) {
        return 0;
    }
    return n;
}

static int face_has_edge(const sfi_complex *c, uint32_t face, uint32_t edge)
{
    for (uint32_t i = c->face_points.starts[face]; i < c->face_points.starts[face + 1]; i++) {
        if (c->face_edges[i] == edge) {
            return 1;
        }
    }
    return 0;
}

// Along the line a curve's rule, across it the surface's with n faces.
static void add_extruded(const sfi_rules *r, sfi_row *row, uint32_t point, uint32_t n,
                         const uint32_t line[2])
{
    const sfi_lists *faces = &r->point_faces, *edges = &r->point_edges;
    double count = n;
    for (int end = 0; end < 2; end++) {
        add_mean(r, row, add_cell, &r->edge_cells, line[end], 0.25 / count);
        add_mean(r, row, add_face, &r->edge_faces, line[end], 0.5 / count);
        add_edge(r, row, line[end], 0.25 * (count - 3) / count);
    }
    for (uint32_t i = faces->starts[point]; i < faces->starts[point + 1]; i++) {
        uint32_t face = faces->items[i];
        if (!face_has_edge(r->complex, face, line[0]) &&
            !face_has_edge(r->complex, face, line[1])) {
            add_face(r, row, face, 0.5 / count / count);
        }
    }
    for (uint32_t i = edges->starts[point]; i < edges->starts[point + 1]; i++) {
        if (edges->items[i] != line[0] && edges->items[i] != line[1]) {
            add_edge(r, row, edges->items[i], 1 / count / count);
        }
    }
    sfi_row_add(row, point, 0.5 * (count - 3) / count);
}

static void add_inner_point(const sfi_rules *r, sfi_row *row, uint32_t point)
{
    uint32_t line[2];
    uint32_t n = r->separable ? extruded(r, point, line) : 0;
    if (n != 0) {
        add_extruded(r, row, point, n, line);
        return;
    }
    add_mean(r, row, add_cell, &r->point_cells, point, 1.0 / 8);
    add_mean(r, row, add_face, &r->point_faces, point, 3.0 / 8);
    add_mean(r, row, add_edge, &r->point_edges, point, 3.0 / 8);
    sfi_row_add(row, point, 1.0 / 8);
}

static void add_point(const sfi_rules *rules, sfi_row *row, uint32_t point)
{
    const sfi_complex *c = rules->complex;
    if (list_size(&rules->point_edges, point) == 0) {
        sfi_row_add(row, point, 1); // no cell uses it
        return;
    }
    if (c->dimension == 3 && !c->point_outside[point]) {
        add_inner_point(rules, row, point);
        return;
    }
    sharpness before, after;
    double passing;
    look(rules, point, &before, &after, &passing);
    if (kind_of(&before) == kind_of(&after)) {
        passing = 1;
    }
    add_surface_point(rules, row, point, &before, passing);
    if (passing < 1) {
        add_surface_point(rules, row, point, &after, 1 - passing);
    }
}

void sfi_rules_row(const sfi_rules *rules, uint32_t point, sfi_row *row)
{
    const sfi_complex *c = rules->complex;
    if (point < c->points) {
        add_point(rules, row, point);
    } else if (point - c->points < c->edges) {
        add_edge_point(rules, row, point - c->points);
    } else if (point - c->points - c->edges < c->faces) {
        add_face_point(rules, row, point - c->points - c->edges);
    } else {
        add_cell(rules, row, point - c->points - c->edges - c->faces, 1);
    }
}

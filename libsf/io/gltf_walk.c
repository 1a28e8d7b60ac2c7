// SPDX-License-Identifier: MIT
// From the tree of nodes of a glTF scene to one mesh.
//
// A node's place in the world is its parent's place times its own. The tree is walked with a stack
// of our own, because its depth comes from a file, and each node is visited once: a node with two
// parents, or its own ancestor, makes the file invalid, and is refused. What metres and y up become
// is one matrix more, above the roots: so that a file of ours, whose node holds the very inverse,
// comes back to the same floats, 1000 times 0.001 being 1.

#include "io/gltf_model.h"

#include "base/memory.h"
#include "base/status.h"

#include <float.h>
#include <math.h>
#include <string.h>

typedef struct place {
    double m[12]; // three rows of four
} place;

typedef struct visit {
    int node;
    place at; // of its parent
} visit;

typedef struct walking {
    const sfi_gltf_model *model;
    const sf_read_limits *limits;
    const sf_allocator *allocator;
    sf_mesh *mesh;
    sf_gltf_report *report;
    sf_fault *fault;
    visit *stack;
    unsigned char *seen; // a byte for each node
    size_t depth;
    uint64_t bytes_left; // what may still be made
} walking;

static sf_status damaged(const walking *w, const char *sentence)
{
    return sfi_fault_set(w->fault, SF_ERR_FORMAT, 0, 0, "%s", sentence);
}

// ---------------------------------------------------------------------------------------------
// Places
// ---------------------------------------------------------------------------------------------

// Metres with y up to mm with z up.
static place world(void)
{
    place p = {{1000, 0, 0, 0, 0, 0, -1000, 0, 0, 1000, 0, 0}};
    return p;
}

static place times(const place *a, const place *b)
{
    place p;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            double sum = j == 3 ? a->m[4 * i + 3] : 0;
            for (int k = 0; k < 3; k++) {
                sum += a->m[4 * i + k] * b->m[4 * k + j];
            }
            p.m[4 * i + j] = sum;
        }
    }
    return p;
}

static double determinant(const place *p)
{
    const double *m = p->m;
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
           m[2] * (m[4] * m[9] - m[5] * m[8]);
}

// Move, turn and stretch as one. The rotation of a unit quaternion (x, y, z, w) has the rows
// (1 - 2yy - 2zz, 2xy - 2zw, 2xz + 2yw) and so on; others are divided by their length first.
static int compose(const sfi_gltf_node *node, place *p)
{
    const double *q = node->turn;
    double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    if (!(square > 0 && square <= DBL_MAX)) {
        return 0;
    }
    double s = 2 / square, x = q[0], y = q[1], z = q[2], v = q[3];
    double turned[9] = {1 - s * (y * y + z * z), s * (x * y - z * v),     s * (x * z + y * v),
                        s * (x * y + z * v),     1 - s * (x * x + z * z), s * (y * z - x * v),
                        s * (x * z - y * v),     s * (y * z + x * v),     1 - s * (x * x + y * y)};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            p->m[4 * i + j] = turned[3 * i + j] * node->stretch[j];
        }
        p->m[4 * i + 3] = node->move[i];
    }
    return 1;
}

static sf_status own_place(const walking *w, const sfi_gltf_node *node, place *p)
{
    int good = node->placing == SFI_GLTF_PARTS && compose(node, p);
    if (node->placing == SFI_GLTF_MATRIX) {
        for (int i = 0; i < 12; i++) {
            p->m[i] = node->matrix[4 * (i % 4) + i / 4];
        }
        good = node->matrix[3] == 0 && node->matrix[7] == 0 && node->matrix[11] == 0 &&
               node->matrix[15] == 1;
    }
    for (int i = 0; i < 12 && good; i++) {
        good = fabs(p->m[i]) <= DBL_MAX;
    }
    return good ? SF_OK
                : damaged(w, "a node's matrix, rotation, scale or translation is none; correct it "
                             "or export the file again");
}

// ---------------------------------------------------------------------------------------------
// Triangles
// ---------------------------------------------------------------------------------------------

// Repetition makes much of little, so what is made is held against the file's size. A piece costs
// something even where nothing is made of it, or a mesh of many lines that many nodes repeat would
// take minutes.
enum { PIECE_BYTES = 64 };

static sf_status pay(walking *w, size_t count, size_t bytes)
{
    if (count > w->bytes_left / bytes) {
        return sfi_fault_set(w->fault, SF_ERR_OVERFLOW, 0, 0,
                             "the file's nodes repeat its meshes until they are 64 times the file; "
                             "save the part as STL or PLY");
    }
    w->bytes_left -= count * bytes;
    return SF_OK;
}

static sf_status add_vertices(walking *w, const sfi_gltf_array *positions, const place *at)
{
    size_t have = sf_mesh_get_view(w->mesh).vertex_count, sparse = 0;
    if (positions->count > w->limits->vertices_max - have) {
        return sfi_fault_set(w->fault, SF_ERR_OVERFLOW, 0, 0,
                             "the file has more than %zu vertices; raise vertices_max",
                             w->limits->vertices_max);
    }
    SF_TRY(pay(w, positions->count, 3 * sizeof(double)));
    for (size_t i = 0; i < positions->count; i++) {
        double from[4], to[3];
        sfi_gltf_numbers(positions, i, &sparse, from);
        for (int k = 0; k < 3; k++) {
            const double *row = at->m + 4 * k;
            to[k] = row[0] * from[0] + row[1] * from[1] + row[2] * from[2] + row[3];
            if (!(fabs(to[k]) <= DBL_MAX)) {
                return damaged(w, "a vertex has a coordinate that is infinite or not a number; "
                                  "correct it or export the file again");
            }
        }
        SF_TRY(sf_mesh_add_vertices(w->mesh, to, 1));
    }
    return SF_OK;
}

// What the corners of triangles are numbered by: a list, or the vertices one after the other.
typedef struct corners {
    sfi_gltf_array list;
    int has_list, mode;
    size_t count, vertices;
} corners;

static sf_status take_corners(const walking *w, const sfi_gltf_primitive *p, size_t vertices,
                              corners *c)
{
    c->has_list = p->indices >= 0;
    c->mode = p->mode;
    c->count = c->vertices = vertices;
    if (!c->has_list) {
        return SF_OK;
    }
    SF_TRY(sfi_gltf_array_of(w->model, p->indices, "corners", &c->list, w->fault));
    int kind = c->list.component;
    if (c->list.width != 1 || c->list.sparse_count > 0 || c->list.bytes == NULL ||
        (kind != SFI_GLTF_UBYTE && kind != SFI_GLTF_USHORT && kind != SFI_GLTF_UINT)) {
        return damaged(w,
                       "the corners of a mesh are not given as a list of whole numbers; export the "
                       "file again");
    }
    c->count = c->list.count;
    return SF_OK;
}

static uint64_t corner_at(const corners *c, size_t i)
{
    return c->has_list ? sfi_gltf_whole(&c->list, i) : i;
}

// Triangle t of a list, a strip (every other one turned) or a fan.
static void triangle_at(const corners *c, size_t t, size_t place_of[3])
{
    int odd = t % 2 == 1;
    for (size_t k = 0; k < 3; k++) {
        place_of[k] = c->mode == SFI_GLTF_TRIANGLES ? 3 * t + k : t + k;
    }
    if (c->mode == SFI_GLTF_FAN) {
        place_of[0] = 0, place_of[1] = t + 1, place_of[2] = t + 2;
    } else if (c->mode == SFI_GLTF_STRIP && odd) {
        place_of[1] = t + 2, place_of[2] = t + 1;
    }
}

static sf_status add_triangles(walking *w, const corners *c, size_t base, int is_mirrored)
{
    size_t have = sf_mesh_get_view(w->mesh).triangle_count;
    size_t count = c->mode == SFI_GLTF_TRIANGLES ? c->count / 3 : c->count < 3 ? 0 : c->count - 2;
    if (count > w->limits->triangles_max - have) {
        return sfi_fault_set(w->fault, SF_ERR_OVERFLOW, 0, 0,
                             "the file has more than %zu triangles; raise triangles_max",
                             w->limits->triangles_max);
    }
    SF_TRY(pay(w, count, 3 * sizeof(uint32_t)));
    for (size_t t = 0; t < count; t++) {
        size_t place_of[3];
        uint32_t triangle[3];
        triangle_at(c, t, place_of);
        for (int k = 0; k < 3; k++) {
            uint64_t corner = corner_at(c, place_of[k]);
            if (corner >= c->vertices) {
                return sfi_fault_set(
                    w->fault, SF_ERR_FORMAT, 0, 0,
                    "a triangle names vertex %llu, counted from 0, but its mesh has "
                    "only %zu",
                    (unsigned long long)corner, c->vertices);
            }
            triangle[is_mirrored && k > 0 ? 3 - k : k] = (uint32_t)(base + corner);
        }
        SF_TRY(sf_mesh_add_triangles(w->mesh, triangle, 1));
    }
    return SF_OK;
}

static sf_status add_piece(walking *w, const sfi_gltf_primitive *p, const place *at)
{
    sfi_gltf_array positions;
    corners c;
    SF_TRY(pay(w, 1, PIECE_BYTES));
    if (p->mode >= 0 && p->mode < SFI_GLTF_TRIANGLES) {
        w->report->passed++;
        return SF_OK;
    }
    if (p->mode < 0 || p->mode > SFI_GLTF_FAN) {
        return damaged(w, "a mesh is of a mode that there is not; export the file again");
    }
    SF_TRY(sfi_gltf_array_of(w->model, p->positions, "vertices", &positions, w->fault));
    if (positions.width != 3 || positions.component == SFI_GLTF_UINT) {
        return damaged(w, "the vertices of a mesh are not given as three numbers each; export the "
                          "file again");
    }
    SF_TRY(take_corners(w, p, positions.count, &c));
    size_t base = sf_mesh_get_view(w->mesh).vertex_count;
    w->report->pieces++;
    w->report->morphed += p->has_targets != 0;
    SF_TRY(add_vertices(w, &positions, at));
    return add_triangles(w, &c, base, determinant(at) < 0);
}

// ---------------------------------------------------------------------------------------------
// Nodes
// ---------------------------------------------------------------------------------------------

static sf_status push(walking *w, const int *nodes, size_t count, const place *at)
{
    for (size_t i = count; i > 0; i--) { // so that the first is visited first
        int node = nodes[i - 1];
        if (node < 0 || (size_t)node >= w->model->node_count) {
            return damaged(w, "a scene or a node names a node that is not there; export the file "
                              "again");
        }
        if (w->seen[node]) {
            return damaged(w, "a node stands twice in the scene, or within itself; export the file "
                              "again");
        }
        w->seen[node] = 1;
        w->stack[w->depth].node = node;
        w->stack[w->depth++].at = *at;
    }
    return SF_OK;
}

static sf_status visit_node(walking *w, const visit *v)
{
    const sfi_gltf_node *node = &w->model->nodes[v->node];
    place own, at;
    SF_TRY(own_place(w, node, &own));
    at = times(&v->at, &own);
    w->report->nodes++;
    if (node->mesh >= 0) {
        if ((size_t)node->mesh >= w->model->mesh_count) {
            return damaged(w, "a node names a mesh that is not there; export the file again");
        }
        const sfi_gltf_mesh *mesh = &w->model->meshes[node->mesh];
        w->report->skinned += node->skin >= 0;
        for (size_t i = 0; i < mesh->count; i++) {
            SF_TRY(add_piece(w, &w->model->primitives[mesh->first + i], &at));
        }
    }
    return push(w, w->model->children + node->first, node->count, &at);
}

static sf_status walk(walking *w)
{
    place top = world();
    memset(w->seen, 0, w->model->node_count);
    SF_TRY(push(w, w->model->roots, w->model->root_count, &top));
    while (w->depth > 0) {
        visit next = w->stack[--w->depth];
        SF_TRY(visit_node(w, &next));
    }
    if (sf_mesh_get_view(w->mesh).triangle_count == 0) {
        return damaged(w, "the file's scene holds no triangles; check what was exported");
    }
    return SF_OK;
}

sf_status sfi_gltf_walk(const sfi_gltf_model *model, uint64_t file_size,
                        const sf_read_limits *limits, const sf_allocator *allocator, sf_mesh *mesh,
                        sf_gltf_report *report, sf_fault *fault)
{
    walking w = {model, limits, allocator, mesh, report, fault, NULL, NULL, 0, 0};
    size_t count = model->node_count;
    w.bytes_left = ((uint64_t)256 << 20) + 64 * (file_size < UINT64_MAX / 128 ? file_size : 0);
    if (count == 0) {
        return damaged(&w, "the file holds no nodes, so nothing is shown; check what was exported");
    }
    // Each node is pushed once, so the stack needs no more places than there are nodes.
    w.stack = sfi_alloc_array(allocator, count, sizeof *w.stack);
    w.seen = sfi_alloc_array(allocator, count, 1);
    sf_status status = w.stack == NULL || w.seen == NULL ? SF_ERR_MEMORY : walk(&w);
    sfi_free_array(allocator, w.seen, count, 1);
    sfi_free_array(allocator, w.stack, count, sizeof *w.stack);
    return status;
}

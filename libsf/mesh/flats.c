// SPDX-License-Identifier: MIT
// The faces of a hull out of its triangles.
//
// Neighbours in one plane are one face; an edge of a triangle is one of its face's rim where the
// triangle across belongs to another. A point on the rims is a corner of the hull where at least
// three faces meet: with two it lies in the middle of an edge. A rim is walked from triangle to
// triangle around each of its points, so that no list of edges is ever sorted.

#include "mesh/flats.h"

#include "base/memory.h"

sf_status sfi_hull_allocate(sfi_hull *h, size_t corners, size_t faces, size_t edges,
                            const sf_allocator *allocator)
{
    h->corners = sfi_alloc_array(allocator, corners, sizeof *h->corners);
    h->corner_count = h->corners != NULL ? corners : 0;
    h->starts = sfi_alloc_array(allocator, faces + 1, sizeof *h->starts);
    if (h->corners == NULL || h->starts == NULL) {
        sfi_free_array(allocator, h->starts, faces + 1, sizeof *h->starts);
        h->starts = NULL;
        return SF_ERR_MEMORY;
    }
    h->face_count = faces;
    h->starts[faces] = edges;
    if (edges > 0) {
        h->loops = sfi_alloc_array(allocator, edges, sizeof *h->loops);
        h->across = sfi_alloc_array(allocator, edges, sizeof *h->across);
    }
    return edges == 0 || (h->loops != NULL && h->across != NULL) ? SF_OK : SF_ERR_MEMORY;
}

typedef struct merger {
    const double *at;
    size_t point_count;
    const sfi_faces *from;
    uint32_t *face_of; // of each triangle
    uint32_t *stack;   // of triangles; then the successor of a point around a face
    uint32_t *meeting; // faces that meet in a point; then its place among the corners
    size_t face_count, edge_count, corner_count;
} merger;

// Triangles of one plane get one number.
static void number_faces(merger *m)
{
    const sfi_face *t = m->from->faces;
    for (size_t i = 0; i < m->from->count; i++) {
        m->face_of[i] = UINT32_MAX;
    }
    for (size_t i = 0; i < m->from->count; i++) {
        size_t depth = 0;
        if (t[i].is_gone || m->face_of[i] != UINT32_MAX) {
            continue;
        }
        m->stack[depth++] = (uint32_t)i;
        m->face_of[i] = (uint32_t)m->face_count;
        while (depth > 0) {
            const sfi_face *f = &t[m->stack[--depth]];
            for (int j = 0; j < 3; j++) {
                const sfi_face *g = &t[f->beside[j]];
                uint32_t a = f->corner[j], b = f->corner[(j + 1) % 3];
                uint32_t far = g->corner[0] != a && g->corner[0] != b   ? g->corner[0]
                               : g->corner[1] != a && g->corner[1] != b ? g->corner[1]
                                                                        : g->corner[2];
                if (m->face_of[f->beside[j]] == UINT32_MAX &&
                    sfi_side(m->at, f->corner[0], f->corner[1], f->corner[2], far) == 0) {
                    m->face_of[f->beside[j]] = (uint32_t)m->face_count;
                    m->stack[depth++] = f->beside[j];
                }
            }
        }
        m->face_count++;
    }
}

static int is_rim(const merger *m, size_t triangle, int j)
{
    const sfi_face *f = &m->from->faces[triangle];
    return !f->is_gone && m->face_of[f->beside[j]] != m->face_of[triangle];
}

// Count faces around points, corners, and edges between corners.
static void count_corners(merger *m)
{
    for (size_t p = 0; p < m->point_count; p++) {
        m->meeting[p] = 0;
    }
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i < m->from->count; i++) {
            for (int j = 0; j < 3; j++) {
                uint32_t p = m->from->faces[i].corner[j];
                if (is_rim(m, i, j)) {
                    m->meeting[p] += pass == 0;
                    m->edge_count += pass == 1 && m->meeting[p] >= 3;
                }
            }
        }
    }
    for (size_t p = 0; p < m->point_count; p++) {
        m->corner_count += m->meeting[p] >= 3;
    }
}

// Number the corners by their points, and let each face have as many places as it has corners.
static void lay_out(merger *m, sfi_hull *h)
{
    uint32_t corners = 0;
    for (size_t f = 0; f < h->face_count; f++) {
        h->starts[f] = 0;
    }
    for (size_t i = 0; i < m->from->count; i++) {
        for (int j = 0; j < 3; j++) {
            if (is_rim(m, i, j) && m->meeting[m->from->faces[i].corner[j]] >= 3) {
                h->starts[m->face_of[i]]++;
            }
        }
    }
    size_t sum = 0;
    for (size_t f = 0; f < h->face_count; f++) {
        size_t here = h->starts[f];
        h->starts[f] = sum;
        sum += here;
    }
    for (size_t p = 0; p < m->point_count; p++) {
        int is_corner = m->meeting[p] >= 3;
        if (is_corner) {
            h->corners[corners] = (uint32_t)p;
        }
        m->meeting[p] = is_corner ? corners++ : UINT32_MAX;
    }
}

// The place of a point among a triangle's corners.
static int place_of(const sfi_face *f, uint32_t point)
{
    return f->corner[0] == point ? 0 : f->corner[1] == point ? 1 : 2;
}

// The edge of the rim after an edge of the rim: the face's triangles around its end, one by one.
static void advance(const merger *m, size_t *triangle, int *j)
{
    const sfi_face *t = m->from->faces;
    uint32_t point = t[*triangle].corner[(*j + 1) % 3];
    *j = (*j + 1) % 3;
    while (!is_rim(m, *triangle, *j)) {
        *triangle = t[*triangle].beside[*j];
        *j = place_of(&t[*triangle], point);
    }
}

// Walk around the face of a triangle from an edge of its rim that begins in a corner.
static void walk(const merger *m, size_t triangle, int j, sfi_hull *h)
{
    const sfi_face *t = m->from->faces;
    size_t from = triangle, place = h->starts[m->face_of[triangle]];
    int from_j = j;
    do {
        uint32_t corner = m->meeting[t[triangle].corner[j]];
        if (corner != UINT32_MAX) {
            h->loops[place] = corner;
            h->across[place++] = m->face_of[t[triangle].beside[j]];
        }
        advance(m, &triangle, &j);
    } while (triangle != from || j != from_j);
}

static void fill_loops(merger *m, sfi_hull *h)
{
    for (size_t f = 0; f < m->face_count; f++) {
        m->stack[f] = 0; // not done
    }
    for (size_t i = 0; i < m->from->count; i++) {
        for (int j = 0; j < 3; j++) {
            if (is_rim(m, i, j) && m->meeting[m->from->faces[i].corner[j]] != UINT32_MAX &&
                m->stack[m->face_of[i]] == 0) {
                m->stack[m->face_of[i]] = 1;
                walk(m, i, j, h);
            }
        }
    }
}

sf_status sfi_hull_merge(const double *at, size_t count, const sfi_faces *triangles,
                         const sf_allocator *allocator, sfi_hull *h)
{
    merger m = {.at = at, .point_count = count, .from = triangles};
    m.face_of = sfi_alloc_array(allocator, triangles->count, sizeof *m.face_of);
    m.stack = sfi_alloc_array(allocator, triangles->count, sizeof *m.stack);
    m.meeting = sfi_alloc_array(allocator, count, sizeof *m.meeting);
    sf_status status = SF_ERR_MEMORY;
    if (m.face_of != NULL && m.stack != NULL && m.meeting != NULL) {
        number_faces(&m);
        count_corners(&m);
        status = sfi_hull_allocate(h, m.corner_count, m.face_count, m.edge_count, allocator);
    }
    if (status == SF_OK) {
        lay_out(&m, h);
        fill_loops(&m, h);
    }
    sfi_free_array(allocator, m.face_of, triangles->count, sizeof *m.face_of);
    sfi_free_array(allocator, m.stack, triangles->count, sizeof *m.stack);
    sfi_free_array(allocator, m.meeting, count, sizeof *m.meeting);
    return status;
}

// SPDX-License-Identifier: MIT
// The surface of the shape, live.
//
// The cage is refined a few times, once; after an edit the new numbers go through the same matrices
// (sf/refine.h). What lies on the boundary is then put to where it would come in the end, by the
// limit masks of Catmull-Clark surfaces: a point with n faces around it goes to
//
//     (n^2 p + 4 sum of edge neighbours + sum of face neighbours) / (n (n + 5)),
//
// one on a crease to (4 p + both crease neighbours) / 6, a corner stays. So what is seen is the
// limit surface itself, at the corners of small faces, whatever the inside does.
//
// Source: M. Halstead, M. Kass, T. DeRose, "Efficient, fair interpolation using Catmull-Clark
// surfaces", SIGGRAPH 1993.

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "grade.h"

// As many steps as leave no more faces than this.
#define FACES_MOST 60000u

enum { SMOOTH, ON_CREASE, CORNER };

// ---------------------------------------------------------------------------------------------
// Faces of the boundary
// ---------------------------------------------------------------------------------------------

static const int sides[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

typedef struct face {
    uint32_t sorted[4], corners[4], places[4];
} face;

static int compare(const void *a, const void *b)
{
    const face *p = a, *q = b;
    for (int i = 0; i < 4; i++) {
        if (p->sorted[i] != q->sorted[i]) {
            return p->sorted[i] < q->sorted[i] ? -1 : 1;
        }
    }
    return p->places[0] < q->places[0] ? -1 : 1;
}

static face make_face(const sf_cage_view *v, size_t first, const int *side)
{
    face f;
    for (int i = 0; i < 4; i++) {
        f.places[i] = (uint32_t)first + (uint32_t)side[i];
        f.corners[i] = f.sorted[i] = v->corners[f.places[i]];
    }
    for (int i = 1; i < 4; i++) {
        for (int j = i; j > 0 && f.sorted[j] < f.sorted[j - 1]; j--) {
            uint32_t t = f.sorted[j];
            f.sorted[j] = f.sorted[j - 1];
            f.sorted[j - 1] = t;
        }
    }
    return f;
}

// All faces of all cells; those that two cells have follow each other when they are sorted.
static sf_status find_faces(const sf_cage_view *v, grade_surface *s)
{
    static const int whole[4] = {0, 1, 2, 3};
    size_t each = v->dimension == 3 ? 6 : 1, count = each * v->cell_count, kept = 0;
    face *all = malloc(count * sizeof *all);
    s->corners = malloc(4 * count * sizeof *s->corners);
    s->places = malloc(4 * count * sizeof *s->places);
    s->values = malloc(4 * count * sizeof *s->values);
    if (all == NULL || s->corners == NULL || s->places == NULL || s->values == NULL) {
        free(all);
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        const int *side = each == 6 ? sides[i % 6] : whole;
        all[i] = make_face(v, v->starts[i / each], side);
    }
    if (each == 6) {
        qsort(all, count, sizeof *all, compare);
    }
    for (size_t i = 0; i < count; i++) {
        int again = each == 6 && i + 1 < count &&
                    memcmp(all[i].sorted, all[i + 1].sorted, sizeof all[i].sorted) == 0;
        if (again) {
            i++; // between two cells
            continue;
        }
        memcpy(s->corners + 4 * kept, all[i].corners, sizeof all[i].corners);
        memcpy(s->places + 4 * kept, all[i].places, sizeof all[i].places);
        kept++;
    }
    free(all);
    s->face_count = kept;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Neighbours
// ---------------------------------------------------------------------------------------------

// For each point, of each face around it: the next corner, and the one across.
static sf_status find_rings(size_t point_count, grade_surface *s)
{
    s->starts = calloc(point_count + 2, sizeof *s->starts);
    s->ring = malloc((8 * s->face_count + 1) * sizeof *s->ring);
    s->points = malloc((3 * point_count + 1) * sizeof *s->points);
    s->normals = malloc((3 * point_count + 1) * sizeof *s->normals);
    if (s->starts == NULL || s->ring == NULL || s->points == NULL || s->normals == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < 4 * s->face_count; i++) {
        s->starts[s->corners[i] + 2] += 2;
    }
    for (size_t i = 2; i < point_count + 2; i++) {
        s->starts[i] += s->starts[i - 1];
    }
    for (size_t i = 0; i < 4 * s->face_count; i++) {
        const uint32_t *f = s->corners + i / 4 * 4;
        uint32_t *at = &s->starts[s->corners[i] + 1];
        s->ring[(*at)++] = f[(i + 1) % 4];
        s->ring[(*at)++] = f[(i + 2) % 4];
    }
    return SF_OK;
}

sf_status grade_surface_make(const sf_cage *cage, grade_surface *s)
{
    sf_refine_options o = sf_refine_options_default();
    sf_cage_view v = sf_cage_get_view(cage);
    size_t faces = v.dimension == 3 ? 6 * v.cell_count : v.cell_count;
    memset(s, 0, sizeof *s);
    while (o.steps < 3 && faces * ((size_t)1 << 2 * (o.steps + 1)) <= FACES_MOST) {
        o.steps++;
    }
    s->steps = o.steps;
    sf_status status = sf_refine(cage, &o, NULL, NULL, &s->refinement);
    if (status == SF_OK) {
        status = sf_refinement_get_view(s->refinement, s->steps, &v);
    }
    if (status == SF_OK) {
        status = find_faces(&v, s);
    }
    if (status == SF_OK) {
        status = find_rings(v.point_count, s);
    }
    if (status == SF_OK) {
        status = grade_surface_move(s, sf_cage_get_view(cage).positions);
    }
    if (status != SF_OK) {
        grade_surface_free(s);
    }
    return status;
}

void grade_surface_free(grade_surface *s)
{
    sf_refinement_destroy(s->refinement);
    free(s->corners);
    free(s->places);
    free(s->values);
    free(s->starts);
    free(s->ring);
    free(s->points);
    free(s->normals);
    memset(s, 0, sizeof *s);
}

// ---------------------------------------------------------------------------------------------
// Where points come in the end
// ---------------------------------------------------------------------------------------------

typedef struct sharpness {
    uint8_t *kind;    // of each point
    uint32_t *crease; // two neighbours of each
    uint8_t *creases; // how many there are
} sharpness;

static void note_crease(sharpness *h, uint32_t a, uint32_t b)
{
    for (int i = 0; i < h->creases[a] && i < 2; i++) {
        if (h->crease[2 * (size_t)a + (size_t)i] == b) {
            return; // an open edge that was made sharp as well
        }
    }
    if (h->creases[a] < 2) {
        h->crease[2 * (size_t)a + h->creases[a]] = b;
    }
    h->creases[a] = (uint8_t)(h->creases[a] < 3 ? h->creases[a] + 1 : 3);
}

// Edges of one face alone, which a cage of faces may have, are sharp by themselves: no face comes
// back along them.
static void note_open_edges(const grade_surface *s, size_t point_count, sharpness *h)
{
    for (uint32_t a = 0; a < point_count; a++) {
        for (uint32_t i = s->starts[a]; i < s->starts[a + 1]; i += 2) {
            uint32_t b = s->ring[i], k = s->starts[b];
            while (k < s->starts[b + 1] && s->ring[k] != a) {
                k += 2;
            }
            if (k >= s->starts[b + 1]) {
                note_crease(h, a, b);
                note_crease(h, b, a);
            }
        }
    }
}

// What is still sharp after the steps is taken to stay so.
static int find_sharpness(const grade_surface *s, const sf_cage_view *v, sharpness *h)
{
    h->kind = calloc(v->point_count + 1, 1);
    h->creases = calloc(v->point_count + 1, 1);
    h->crease = malloc((2 * v->point_count + 1) * sizeof *h->crease);
    if (h->kind == NULL || h->creases == NULL || h->crease == NULL) {
        return 0;
    }
    if (v->dimension == 2) {
        note_open_edges(s, v->point_count, h);
    }
    for (size_t i = 0; i < v->crease_count; i++) {
        if (v->creases[i].sharpness >= 1) {
            note_crease(h, v->creases[i].points[0], v->creases[i].points[1]);
            note_crease(h, v->creases[i].points[1], v->creases[i].points[0]);
        }
    }
    for (size_t i = 0; i < v->point_count; i++) {
        h->kind[i] = h->creases[i] == 2 ? ON_CREASE : h->creases[i] > 2 ? CORNER : SMOOTH;
    }
    for (size_t i = 0; i < v->sharp_count; i++) {
        if (v->sharps[i].sharpness >= 1) {
            h->kind[v->sharps[i].point] = CORNER;
        }
    }
    return 1;
}

static void free_sharpness(sharpness *h)
{
    free(h->kind);
    free(h->crease);
    free(h->creases);
}

// One number of a point: `from` has `stride` numbers for each.
static double push(const grade_surface *s, const sharpness *h, const double *from, size_t stride,
                   size_t point, size_t axis)
{
    const uint32_t *ring = s->ring + s->starts[point];
    size_t n = (s->starts[point + 1] - s->starts[point]) / 2;
    double own = from[stride * point + axis], edges = 0, across = 0;
    if (h->kind[point] == ON_CREASE) {
        const uint32_t *c = h->crease + 2 * point;
        return (4 * own + from[stride * c[0] + axis] + from[stride * c[1] + axis]) / 6;
    }
    if (h->kind[point] == CORNER || n < 3) {
        return own;
    }
    for (size_t i = 0; i < n; i++) {
        edges += from[stride * ring[2 * i] + axis];
        across += from[stride * ring[2 * i + 1] + axis];
    }
    double m = (double)n;
    return (m * m * own + 4 * edges + across) / (m * (m + 5));
}

// Normals: the mean of those of the faces around, by their size.
static void find_normals(grade_surface *s, size_t point_count)
{
    memset(s->normals, 0, 3 * point_count * sizeof *s->normals);
    for (size_t f = 0; f < s->face_count; f++) {
        const uint32_t *c = s->corners + 4 * f;
        double d[3], e[3];
        for (int i = 0; i < 3; i++) {
            d[i] =
                s->points[3 * (size_t)c[2] + (size_t)i] - s->points[3 * (size_t)c[0] + (size_t)i];
            e[i] =
                s->points[3 * (size_t)c[3] + (size_t)i] - s->points[3 * (size_t)c[1] + (size_t)i];
        }
        for (int i = 0; i < 3; i++) {
            double n = d[(i + 1) % 3] * e[(i + 2) % 3] - d[(i + 2) % 3] * e[(i + 1) % 3];
            for (int k = 0; k < 4; k++) {
                s->normals[3 * (size_t)c[k] + (size_t)i] += n;
            }
        }
    }
}

sf_status grade_surface_move(grade_surface *s, const double *positions)
{
    sf_cage_view v;
    sharpness h;
    sf_status status = sf_refinement_update_positions(s->refinement, positions, NULL);
    if (status == SF_OK) {
        status = sf_refinement_get_view(s->refinement, s->steps, &v);
    }
    if (status != SF_OK) {
        return status;
    }
    if (!find_sharpness(s, &v, &h)) {
        free_sharpness(&h);
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < 3 * v.point_count; i++) {
        s->points[i] = push(s, &h, v.positions, 3, i / 3, i % 3);
    }
    free_sharpness(&h);
    find_normals(s, v.point_count);
    return SF_OK;
}

// A property that jumps somewhere is read as it is; a smooth one where it comes in the end.
static void read_values(grade_surface *s, size_t channel)
{
    sf_cage_view v;
    sharpness h = {NULL, NULL, NULL};
    if (sf_refinement_get_view(s->refinement, s->steps, &v) != SF_OK ||
        channel >= v.channel_count) {
        return;
    }
    const sf_channel *c = &v.channels[channel];
    int is_smooth = c->indices == NULL && find_sharpness(s, &v, &h);
    for (size_t i = 0; i < 4 * s->face_count; i++) {
        size_t value = c->indices != NULL ? c->indices[s->places[i]] : s->corners[i];
        s->values[i] = is_smooth ? push(s, &h, c->values, 1, s->corners[i], 0) : c->values[value];
    }
    free_sharpness(&h);
}

sf_status grade_surface_paint(grade_surface *s, size_t channel, const double *values)
{
    sf_status status = sf_refinement_update_values(s->refinement, channel, values, NULL);
    if (status == SF_OK) {
        read_values(s, channel);
    }
    return status;
}

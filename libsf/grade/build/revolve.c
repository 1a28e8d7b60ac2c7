// SPDX-License-Identifier: MIT
// Faces turned about an axis.
//
// Points of sector s lie s / sectors of the way around. Those on the axis stay where they are and
// are there once, so that a face with an edge on it becomes a wedge, or of a triangle a
// tetrahedron; one that touches the axis with a single corner would become a cell with a tip, and
// none is served.

#include "grade/build/draft.h"

#include "base/math.h"
#include "base/memory.h"
#include "base/status.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

// Cosine and sine by the tangent of the half angle: the same bytes everywhere.
static void turn(double angle, double *cosine, double *sine)
{
    double a = angle > PI ? angle - 2 * PI : angle;
    if (!(a < PI)) {
        *cosine = -1;
        *sine = 0;
        return;
    }
    double t = sfi_tan(a / 2);
    *cosine = (1 - t * t) / (1 + t * t);
    *sine = 2 * t / (1 + t * t);
}

// What turns, and how.
typedef struct spindle {
    sf_cage_view v;
    uint32_t sectors, rings; // rings of points: one more unless it closes
    double angle;
    int reversed;      // faces look along -y
    uint32_t *numbers; // of each point in each ring, in the cage
    sfi_draft draft;
} spindle;

static int on_axis(const spindle *s, uint32_t point)
{
    return s->v.positions[3 * (size_t)point] == 0;
}

static uint32_t number(const spindle *s, uint32_t point, uint32_t ring)
{
    return s->numbers[(size_t)(ring % s->rings) * s->v.point_count + point];
}

static void add_points(spindle *s)
{
    for (uint32_t ring = 0; ring < s->rings; ring++) {
        double cosine, sine;
        turn(s->angle * ring / s->sectors, &cosine, &sine);
        for (uint32_t i = 0; i < s->v.point_count && s->draft.status == SF_OK; i++) {
            const double *p = s->v.positions + 3 * (size_t)i;
            double at[3] = {p[0] * cosine, p[0] * sine, p[2]};
            uint32_t *to = &s->numbers[(size_t)ring * s->v.point_count + i];
            *to = ring > 0 && on_axis(s, i) ? s->numbers[i] : sfi_draft_point(&s->draft, at);
        }
    }
}

// A face with its edge on the axis, from corner `first` to the next one.
static void add_wedge(spindle *s, uint32_t ring, uint32_t count, const uint32_t *loop,
                      uint32_t first)
{
    uint32_t a = loop[first], b = loop[(first + 1) % count];
    uint32_t c = loop[(first + 2) % count], d = loop[(first + 3) % count];
    if (count == 3) {
        const uint32_t tet[4] = {number(s, a, 0), number(s, b, 0), number(s, c, ring),
                                 number(s, c, ring + 1)};
        const uint32_t other[4] = {tet[1], tet[0], tet[2], tet[3]};
        sfi_draft_cell(&s->draft, 4, s->reversed ? tet : other);
        return;
    }
    const uint32_t wedge[6] = {number(s, a, 0), number(s, d, ring), number(s, d, ring + 1),
                               number(s, b, 0), number(s, c, ring), number(s, c, ring + 1)};
    const uint32_t other[6] = {wedge[3], wedge[4], wedge[5], wedge[0], wedge[1], wedge[2]};
    sfi_draft_cell(&s->draft, 6, s->reversed ? wedge : other);
}

// Away from the axis a prism: from the face here to the one in the next ring.
static void add_prism(spindle *s, uint32_t ring, uint32_t count, const uint32_t *loop)
{
    uint32_t corners[2 * SF_CAGE_POLYGON_MAX];
    for (uint32_t i = 0; i < count; i++) {
        uint32_t point = loop[s->reversed ? i : count - 1 - i];
        corners[i] = number(s, point, ring);
        corners[count + i] = number(s, point, ring + 1);
    }
    sfi_draft_cell(&s->draft, 2 * count, corners);
}

static sf_status add_face(spindle *s, size_t face, uint32_t ring, sf_fault *fault)
{
    uint32_t start = s->v.starts[face], count = s->v.starts[face + 1] - start;
    const uint32_t *loop = s->v.corners + start;
    uint32_t touching = 0, first = count;
    for (uint32_t i = 0; i < count; i++) {
        touching += (uint32_t)on_axis(s, loop[i]);
        if (on_axis(s, loop[i]) && on_axis(s, loop[(i + 1) % count])) {
            first = i;
        }
    }
    if (touching == 0) {
        add_prism(s, ring, count, loop);
    } else if (touching == 2 && first < count && count <= 4) {
        add_wedge(s, ring, count, loop, first);
    } else {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "face %zu touches the axis so that no served cell comes of it; a "
                             "triangle or a quadrilateral may have one edge there",
                             face);
    }
    return s->draft.status;
}

// Area of the faces in the plane of x and z; above 0 where they look along -y.
static double area(const sf_cage_view *v)
{
    double sum = 0;
    for (size_t f = 0; f < v->cell_count; f++) {
        uint32_t start = v->starts[f], count = v->starts[f + 1] - start;
        for (uint32_t i = 0; i < count; i++) {
            const double *p = v->positions + 3 * (size_t)v->corners[start + i];
            const double *q = v->positions + 3 * (size_t)v->corners[start + (i + 1) % count];
            sum += p[0] * q[2] - q[0] * p[2];
        }
    }
    return sum;
}

static sf_status check(const sf_cage_view *v, uint32_t sectors, double angle, sf_fault *fault)
{
    int is_whole = angle == 2 * PI;
    if (!(angle > 0 && angle <= 2 * PI) || sectors < (is_whole ? 3u : 1u) || sectors > 1u << 20 ||
        !(angle / sectors < PI)) {
        return sfi_fault_set(
            fault, SF_ERR_ARGUMENT, 0, 0,
            "the angle is above 0 and at most a full turn, in sectors of less than "
            "half a turn");
    }
    if (v->dimension != 2) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0, "only faces can be turned");
    }
    for (size_t i = 0; i < v->point_count; i++) {
        if (v->positions[3 * i] < 0) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "point %zu lies beyond the axis, at an x below 0", i);
        }
    }
    return SF_OK;
}

sf_status sf_cage_revolve(const sf_cage *faces, uint32_t sectors, double angle_rad,
                          const sf_allocator *allocator, sf_cage **cage, sf_fault *fault)
{
    if (faces == NULL || cage == NULL) {
        return SF_ERR_ARGUMENT;
    }
    spindle s = {.v = sf_cage_get_view(faces), .sectors = sectors, .angle = angle_rad};
    SF_TRY(check(&s.v, sectors, angle_rad, fault));
    s.rings = angle_rad == 2 * PI ? sectors : sectors + 1;
    s.reversed = area(&s.v) < 0;
    if ((double)s.rings * (double)s.v.point_count > SF_CAGE_POINT_MAX) {
        return SF_ERR_OVERFLOW;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    size_t count = (size_t)s.rings * s.v.point_count;
    s.numbers = sfi_alloc_array(&kept, count, sizeof *s.numbers);
    if (s.numbers == NULL) {
        return SF_ERR_MEMORY;
    }
    sfi_draft_begin(allocator, &s.draft);
    add_points(&s);
    sf_status status = s.draft.status;
    for (uint32_t ring = 0; ring < sectors; ring++) {
        for (size_t face = 0; status == SF_OK && face < s.v.cell_count; face++) {
            status = add_face(&s, face, ring, fault);
        }
    }
    s.draft.status = status;
    status = sfi_draft_end(&s.draft, cage, fault);
    sfi_free_array(&kept, s.numbers, count, sizeof *s.numbers);
    return status;
}

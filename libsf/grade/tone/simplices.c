// SPDX-License-Identifier: MIT
// Delaunay simplices of a few points, by looking at all that could be made.
//
// Lift each point to the height |f|^2: a simplex is Delaunay's where no other point lies below the
// plane through its lifted corners. Fractions of sum 1 are barycentric coordinates in the simplex
// of the pure materials, so weights w with sum w_i F_i = F say how F lies to the corners F_i, and
// the plane's height at F is sum w_i h_i.
//
// Measured mixtures come in regular patterns, where many points share a sphere and the choice is
// open. Heights are therefore raised by up to 1e-8, each point by another amount, so that there is
// one answer and it is a triangulation; points are at least 0.001 apart, so none is raised above
// the planes of its neighbours (5e-7 at least). Simplices flatter than 1e-9 are on the rim and
// none.
//
// Source: K. Q. Brown, "Voronoi diagrams from convex hulls", 1979; for raising H. Edelsbrunner, E.
// P. Muecke, "Simulation of simplicity", 1990.

#include "grade/tone/simplices.h"

#include "base/memory.h"
#include "base/status.h"
#include "grade/tone/solve.h"

#include <string.h>

#define CANDIDATES_MAX 4194304.0
#define FLATTEST 1e-9

int sfi_simplices_fit(size_t points, size_t side)
{
    double count = 1.0;
    for (size_t i = 0; i < side; i++) {
        count *= (double)(points - i) / (double)(i + 1);
    }
    return count <= CANDIDATES_MAX;
}

// Neighbours' numbers must have nothing to do with each other: a plain product leaves the corners
// of every parallelogram of a pattern in one plane. (splitmix64, as for masks.)
static double height_of(const double *f, size_t side, size_t point)
{
    uint64_t mixed = ((uint64_t)point + 1) * UINT64_C(0x9e3779b97f4a7c15);
    mixed = (mixed ^ (mixed >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    mixed = (mixed ^ (mixed >> 27)) * UINT64_C(0x94d049bb133111eb);
    mixed ^= mixed >> 31;
    double height = 1e-8 * (double)(mixed >> 11) * 0x1p-53;
    for (size_t j = 0; j < side; j++) {
        height += f[j] * f[j];
    }
    return height;
}

typedef struct search {
    const double *fractions;
    size_t points, side;
    double heights[SF_MIXTURE_MAX];
} search;

// The plane through the lifted corners, as its heights above the pure materials: the height at F is
// then sum F_j plane_j. 0 where the corners lie in less.
static int plane_of(const search *s, const uint32_t *corners, double *plane)
{
    double rows[SFI_SOLVE_MAX][SFI_SOLVE_MAX];
    for (size_t i = 0; i < s->side; i++) {
        memcpy(rows[i], s->fractions + corners[i] * s->side, s->side * sizeof(double));
        plane[i] = s->heights[corners[i]];
    }
    return sfi_solve(rows, plane, (int)s->side, FLATTEST);
}

static int is_empty_below(const search *s, const uint32_t *corners, const double *plane)
{
    size_t corner = 0;
    for (size_t p = 0; p < s->points; p++) {
        if (corner < s->side && corners[corner] == p) {
            corner++;
            continue;
        }
        double height = 0.0;
        for (size_t j = 0; j < s->side; j++) {
            height += s->fractions[p * s->side + j] * plane[j];
        }
        if (s->heights[p] < height) {
            return 0;
        }
    }
    return 1;
}

// The next choice of corners in lexical order; 0 after the last.
static int next_choice(uint32_t *corners, size_t side, size_t points)
{
    size_t i = side;
    while (i > 0 && corners[i - 1] == points - side + i - 1) {
        i--;
    }
    if (i == 0) {
        return 0;
    }
    corners[i - 1]++;
    for (; i < side; i++) {
        corners[i] = corners[i - 1] + 1;
    }
    return 1;
}

static sf_status keep(sfi_simplices *to, const uint32_t *corners, const sf_allocator *allocator)
{
    void *memory = to->corners;
    if (!sfi_grow_array(allocator, &memory, &to->capacity, (to->count + 1) * to->side,
                        sizeof *to->corners)) {
        return SF_ERR_MEMORY;
    }
    to->corners = memory;
    memcpy(to->corners + to->count * to->side, corners, to->side * sizeof *corners);
    to->count++;
    return SF_OK;
}

sf_status sfi_simplices_create(const double *fractions, size_t points, size_t side,
                               const sf_allocator *allocator, sfi_simplices *simplices)
{
    search s = {fractions, points, side, {0.0}};
    uint32_t corners[SFI_SOLVE_MAX];
    double plane[SFI_SOLVE_MAX];
    sf_status status = SF_OK;
    memset(simplices, 0, sizeof *simplices);
    simplices->side = side;
    for (size_t p = 0; p < points; p++) {
        s.heights[p] = height_of(fractions + p * side, side, p);
    }
    for (uint32_t i = 0; i < side; i++) {
        corners[i] = i;
    }
    do {
        if (plane_of(&s, corners, plane) && is_empty_below(&s, corners, plane)) {
            status = keep(simplices, corners, allocator);
        }
    } while (status == SF_OK && next_choice(corners, side, points));
    if (status != SF_OK) {
        sfi_simplices_destroy(simplices, allocator);
    }
    return status;
}

void sfi_simplices_destroy(sfi_simplices *simplices, const sf_allocator *allocator)
{
    sfi_free_array(allocator, simplices->corners, simplices->capacity, sizeof *simplices->corners);
    memset(simplices, 0, sizeof *simplices);
}

// SPDX-License-Identifier: MIT
// Walking through a solid.
//
// The place of a voxel is close to that of its neighbour, so Newton's method begins there and is
// done in a step or two; where it leaves a piece, it goes on in the one across that side, whose
// axes may be turned. The last step is not taken twice: it is so small that the property at its end
// follows from its derivatives. Whoever does not arrive is searched for.

#include "grade/sample/walk.h"

#include <math.h>
#include <string.h>

enum { STEPS = 12, HOPS = 4 };

static const double LAST_STEP = 1e-3; // of a spline's extent: what is left out is its square
static const double SLACK = 1e-9;     // of a piece

// ---------------------------------------------------------------------------------------------
// Across sides
// ---------------------------------------------------------------------------------------------

// The place in a piece, as sfi_hex_bits(), of one of its points; 8 if it has not got it.
static uint32_t bits_of(const uint32_t *corners, uint32_t point)
{
    for (uint32_t i = 0; i < 8; i++) {
        if (corners[i] == point) {
            return sfi_hex_bits(i);
        }
    }
    return 8;
}

// The same place in the piece across a side: how far it is beyond that side stays, and along the
// side it is turned as the points that both have.
static void turn(const uint32_t *from, const uint32_t *to, uint32_t axis, uint32_t high,
                 const double u[3], double turned[3])
{
    uint32_t origin = high << axis, first = bits_of(to, from[sfi_hex_bits(origin)]), seen = 0;
    for (uint32_t along = 0; along < 3; along++) {
        if (along != axis) {
            uint32_t second = bits_of(to, from[sfi_hex_bits(origin | 1u << along)]);
            uint32_t step = first ^ second, own = step == 1 ? 0 : step == 2 ? 1 : 2;
            turned[own] = first >> own & 1 ? 1 - u[along] : u[along];
            seen |= step;
        }
    }
    uint32_t across = 7 & ~seen, own = across == 1 ? 0 : across == 2 ? 1 : 2;
    double beyond = high ? u[axis] - 1 : -u[axis];
    turned[own] = first >> own & 1 ? 1 - beyond : beyond;
}

// Move into the piece that holds a place, or to the border where there is none. Returns 0 for the
// border.
static int settle(const sfi_walker *w, const uint32_t *corners, uint32_t *piece, double u[3])
{
    int inside = 1;
    for (int hop = 0; hop < HOPS; hop++) {
        uint32_t worst = 6;
        double most = SLACK;
        for (uint32_t side = 0; side < 6; side++) {
            double beyond = side % 2 ? u[side / 2] - 1 : -u[side / 2];
            if (beyond > most) {
                most = beyond;
                worst = side;
            }
        }
        if (worst == 6) {
            return inside;
        }
        uint32_t next = w->tree.chart->across[6 * (size_t)*piece + worst];
        if (next == SFI_NONE) {
            u[worst / 2] = worst % 2;
            inside = 0;
            continue;
        }
        double turned[3];
        turn(corners + 8 * (size_t)*piece, corners + 8 * (size_t)next, worst / 2, worst % 2, u,
             turned);
        memcpy(u, turned, sizeof turned);
        *piece = next;
    }
    for (uint32_t axis = 0; axis < 3; axis++) {
        u[axis] = u[axis] < 0 ? 0 : u[axis] > 1 ? 1 : u[axis];
    }
    return inside;
}

// ---------------------------------------------------------------------------------------------
// Newton's method
// ---------------------------------------------------------------------------------------------

// The step from where the derivatives (four numbers by each parameter) are to where the residual
// vanishes. Returns 0 where they span nothing.
static int newton_step(const double d[12], const double r[3], double du[3])
{
    const double *a = d, *b = d + 4, *c = d + 8;
    double bc[3] = {b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2],
                    b[0] * c[1] - b[1] * c[0]};
    double ca[3] = {c[1] * a[2] - c[2] * a[1], c[2] * a[0] - c[0] * a[2],
                    c[0] * a[1] - c[1] * a[0]};
    double ab[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                    a[0] * b[1] - a[1] * b[0]};
    double det = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
    if (!(fabs(det) > 0)) {
        return 0;
    }
    du[0] = (r[0] * bc[0] + r[1] * bc[1] + r[2] * bc[2]) / det;
    du[1] = (r[0] * ca[0] + r[1] * ca[1] + r[2] * ca[2]) / det;
    du[2] = (r[0] * ab[0] + r[1] * ab[1] + r[2] * ab[2]) / det;
    return isfinite(du[0] + du[1] + du[2]);
}

static double largest(const double v[3])
{
    double x = fabs(v[0]), y = fabs(v[1]), z = fabs(v[2]);
    return x > y ? (x > z ? x : z) : (y > z ? y : z);
}

// Returns 1 on arrival.
static int walk(sfi_walker *w, const uint32_t *corners, const double point[3], uint32_t *piece,
                double u[3], double *value)
{
    const sfi_leaf *leaf = NULL;
    uint32_t leaf_piece = SFI_NONE;
    for (int step = 0; step < STEPS; step++) {
        double local[3], found[4], d[12], r[3], du[3], before[3];
        memcpy(before, u, sizeof before);
        int inside = settle(w, corners, piece, u);
        for (uint32_t axis = 0; leaf != NULL && axis < 3; axis++) {
            local[axis] = (u[axis] - leaf->origin[axis]) / leaf->size;
        }
        if (leaf == NULL || *piece != leaf_piece || largest(local) > 1 || local[0] < 0 ||
            local[1] < 0 || local[2] < 0) {
            leaf = sfi_tree_leaf(&w->tree, *piece, u);
            leaf_piece = *piece;
        }
        for (uint32_t axis = 0; axis < 3; axis++) {
            local[axis] = (u[axis] - leaf->origin[axis]) / leaf->size;
        }
        sfi_leaf_at(leaf, local, found, d);
        for (uint32_t axis = 0; axis < 3; axis++) {
            r[axis] = point[axis] - found[axis];
        }
        if (!newton_step(d, r, du)) {
            return 0;
        }
        double length = largest(du), scale = length * leaf->size > 0.5 ? 0.5 / length : leaf->size;
        int stays = step > 0 && !inside && largest(r) <= w->reach;
        for (uint32_t axis = 0; axis < 3; axis++) {
            double next = u[axis] + scale * du[axis];
            stays = stays && (fabs(next - before[axis]) < 1e-4 || (next < 0 && u[axis] <= 0) ||
                              (next > 1 && u[axis] >= 1));
        }
        if (stays) { // at the border, as near as it gets
            *value = found[3];
            return 1;
        }
        for (uint32_t axis = 0; axis < 3; axis++) {
            u[axis] += scale * du[axis];
        }
        if (length <= LAST_STEP) {
            *value = found[3] + d[3] * du[0] + d[7] * du[1] + d[11] * du[2];
            return 1;
        }
    }
    return 0;
}

int sfi_walk_to(sfi_walker *walker, const double point[3], sf_place *place, double *value)
{
    sf_place at = *place;
    const uint32_t *corners = walker->corners;
    if (at.piece != SF_NO_PIECE && walk(walker, corners, point, &at.piece, at.u, value)) {
        *place = at;
        return 1;
    }
    walker->located++;
    if (sf_locator_find(walker->locator, 1, point, walker->reach, &walker->tree.allocator, NULL,
                        &at, NULL) != SF_OK ||
        at.piece == SF_NO_PIECE) {
        return 0;
    }
    double found[SFI_TREE_WIDTH];
    sfi_tree_at(&walker->tree, &at, found);
    *value = found[3];
    *place = at;
    return 1;
}

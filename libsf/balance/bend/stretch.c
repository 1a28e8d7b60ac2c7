// SPDX-License-Identifier: MIT
// How bending stretches the solid, at places spread through it.
//
// With v = sum phi_b y_b (balance/bend/basis.h) the derivative of a bent point by the point is
//
//     J = sum over b of y_b (grad phi_b)^T,
//     grad phi = (p - c)_q grad w + w e_q  and  grad w  for the four functions of a handle,
//
// linear in the coefficients. Its determinant is the factor by which volume grows, and
// d det J / d y_b = cof(J) grad phi_b. The slopes of the functions do not change while handles
// move.

#include "balance/bend/stretch.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "mesh/vector.h"

#include <string.h>

// Slopes of the functions at p, from the weights there and their slopes.
static void fill(const double *p, const double *centres, const double *w, const double *slope,
                 size_t handle_count, double *to)
{
    for (size_t j = 0; j < handle_count; j++) {
        for (size_t k = 0; k < 3; k++) {
            for (size_t q = 0; q < 3; q++) {
                to[12 * j + 3 * q + k] =
                    (p[q] - centres[3 * j + q]) * slope[3 * j + k] + (q == k ? w[j] : 0);
            }
            to[12 * j + 9 + k] = slope[3 * j + k];
        }
    }
}

static sf_status sample(const sf_weights *weights, const sf_grid *solid, size_t step,
                        double *scratch, sfi_stretch *made)
{
    sf_lattice l = sf_grid_lattice(solid);
    size_t handles = made->handle_count, seen = 0;
    for (uint32_t k = 0; k < l.nz; k++) {
        for (uint32_t y = 0; y < l.ny; y++) {
            for (uint32_t x = 0; x < l.nx; x++) {
                if (!sf_slice_get(sf_grid_slice(solid, k), x, y) || seen++ % step != 0) {
                    continue;
                }
                double p[3] = {l.origin_mm[0] + (x + 0.5) * l.pitch_x_mm,
                               l.origin_mm[1] + (y + 0.5) * l.pitch_y_mm,
                               l.origin_mm[2] + (k + 0.5) * l.layer_mm};
                SF_TRY(sf_weights_at(weights, p, scratch, scratch + handles));
                fill(p, sf_weights_centers(weights), scratch, scratch + handles, handles,
                     made->slopes + 12 * handles * made->place_count++);
            }
        }
    }
    return SF_OK;
}

sf_status sfi_stretch_reserve(size_t handle_count, size_t most, const sf_allocator *allocator,
                              sfi_stretch *stretch)
{
    sfi_stretch made = {NULL, 0, handle_count, 0};
    if (!sfi_size_mul(most, handle_count, &made.number_count) ||
        !sfi_size_mul(made.number_count, 12, &made.number_count)) {
        return SF_ERR_OVERFLOW;
    }
    made.slopes = sfi_alloc_array(allocator, made.number_count, sizeof *made.slopes);
    if (made.slopes == NULL) {
        return SF_ERR_MEMORY;
    }
    *stretch = made;
    return SF_OK;
}

sf_status sfi_stretch_add(const sf_weights *weights, const sfi_spot *spot, sfi_stretch *stretch)
{
    size_t handles = stretch->handle_count, room = 12 * handles;
    double w[SF_HANDLE_MAX], slope[3 * SF_HANDLE_MAX];
    if ((stretch->place_count + 1) * room > stretch->number_count) {
        return SF_ERR_CAPACITY;
    }
    sfi_weights_at(weights, spot, w, slope);
    fill(spot->at, weights->centers, w, slope, handles,
         stretch->slopes + room * stretch->place_count++);
    return SF_OK;
}

sf_status sfi_stretch_make(const sf_weights *weights, const sf_grid *solid, size_t most,
                           const sf_allocator *allocator, sfi_stretch *stretch)
{
    size_t handles = weights->count;
    size_t solids = (size_t)sf_grid_popcount(solid), step = solids / most + 1;
    sfi_stretch made;
    SF_TRY(sfi_stretch_reserve(handles, solids / step + 1, allocator, &made));
    double *scratch = sfi_alloc_array(allocator, handles, 4 * sizeof *scratch);
    sf_status status = SF_ERR_MEMORY;
    if (scratch != NULL) {
        status = sample(weights, solid, step, scratch, &made);
    }
    sfi_free_array(allocator, scratch, handles, 4 * sizeof *scratch);
    if (status != SF_OK) {
        sfi_stretch_free(allocator, &made);
        return status;
    }
    *stretch = made;
    return SF_OK;
}

void sfi_stretch_free(const sf_allocator *allocator, sfi_stretch *stretch)
{
    sfi_free_array(allocator, stretch->slopes, stretch->number_count, sizeof *stretch->slopes);
    memset(stretch, 0, sizeof *stretch);
}

// Row d of J at j + 3 d.
static void derive(const sfi_stretch *stretch, size_t place, const double *y, double j[9])
{
    const double *slopes = stretch->slopes + 12 * stretch->handle_count * place;
    memset(j, 0, 9 * sizeof *j);
    for (size_t b = 0; b < 4 * stretch->handle_count; b++) {
        for (size_t d = 0; d < 3; d++) {
            for (size_t k = 0; k < 3; k++) {
                j[3 * d + k] += y[3 * b + d] * slopes[3 * b + k];
            }
        }
    }
}

double sfi_stretch_at(const sfi_stretch *stretch, size_t place, const double *coefficients)
{
    double j[9], cross[3];
    derive(stretch, place, coefficients, j);
    sfi_cross(j + 3, j + 6, cross);
    return sfi_dot(j, cross);
}

void sfi_stretch_gradient(const sfi_stretch *stretch, size_t place, const double *coefficients,
                          double *gradient)
{
    const double *slopes = stretch->slopes + 12 * stretch->handle_count * place;
    double j[9], cofactor[9];
    derive(stretch, place, coefficients, j);
    sfi_cross(j + 3, j + 6, cofactor);
    sfi_cross(j + 6, j, cofactor + 3);
    sfi_cross(j, j + 3, cofactor + 6);
    for (size_t b = 0; b < 4 * stretch->handle_count; b++) {
        for (size_t d = 0; d < 3; d++) {
            gradient[3 * b + d] = sfi_dot(cofactor + 3 * d, slopes + 3 * b);
        }
    }
}

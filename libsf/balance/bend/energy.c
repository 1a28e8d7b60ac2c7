// SPDX-License-Identifier: MIT
// What bending costs: lost details, moved matter, changed sizes.
//
//     E = a E_details / norm  +  b mean |u|^2 / size^2  +  c sum over handles of (s - 1)^2
//
// The first is the paper's energy, freed of its unit. Alone it is blind to a uniform change of
// size, and an optimiser that is asked for balance shrinks the model towards its foot; so the
// second asks how far matter has moved, on average over the vertices, and the third how much sizes
// have changed. All are sums of squares of what is linear in the coefficients of
// balance/bend/basis.h, in which the first two are therefore fixed forms, of 12 N rows for N
// handles: they are computed once for a shape, and an energy is then some thousand products,
// however many vertices there are.
//
// Source: R. Prevost and others, "Make It Stand", SIGGRAPH 2013, equation 13, for the first term.

#include "balance/bend/energy.h"

#include "balance/bend/laplacian.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <string.h>

// form = sum over the points of phi phi^T, for each coordinate, over count * size^2.
static void form_shifts(const sf_blend *basis, double size_mm, double *phi, double *form)
{
    size_t functions = sfi_basis_size(basis), rows = 3 * functions;
    double share = 1 / ((double)basis->point_count * size_mm * size_mm);
    memset(form, 0, rows * rows * sizeof *form);
    for (size_t v = 0; v < basis->point_count; v++) {
        sfi_basis_at(basis, v, phi);
        for (size_t a = 0; a < functions; a++) {
            for (size_t b = 0; b < functions; b++) {
                form[3 * a * rows + 3 * b] += share * phi[a] * phi[b];
            }
        }
    }
    for (size_t a = 0; a < functions; a++) {
        for (size_t b = 0; b < functions; b++) {
            double value = form[3 * a * rows + 3 * b];
            form[(3 * a + 1) * rows + 3 * b + 1] = value;
            form[(3 * a + 2) * rows + 3 * b + 2] = value;
        }
    }
}

static sf_status take_memory(size_t handle_count, sfi_energy *made)
{
    size_t rows, square;
    if (!sfi_size_mul(handle_count, 12, &rows) || !sfi_size_mul(rows, rows, &square)) {
        return SF_ERR_MEMORY;
    }
    made->details = sfi_alloc_array(&made->allocator, square, sizeof *made->details);
    made->shifts = sfi_alloc_array(&made->allocator, square, sizeof *made->shifts);
    made->curvature = sfi_alloc_array(&made->allocator, square, sizeof *made->curvature);
    made->rest = sfi_alloc_array(&made->allocator, rows, sizeof *made->rest);
    made->centres = sfi_alloc_array(&made->allocator, 3 * handle_count, sizeof *made->centres);
    int all = made->details != NULL && made->shifts != NULL && made->curvature != NULL &&
              made->rest != NULL && made->centres != NULL;
    return all ? SF_OK : SF_ERR_MEMORY;
}

static void rest_coefficients(const sf_blend *basis, double *rest)
{
    const sf_pose at_rest = sf_pose_identity();
    for (size_t j = 0; j < basis->handle_count; j++) {
        sfi_pose_coefficients(&at_rest, basis->centers_mm + 3 * j, 1, rest + 12 * j);
    }
}

static sf_status fill(sf_mesh_view mesh, const sfi_incidence *incidence, const sf_blend *basis,
                      double size_mm, sf_task *task, sfi_energy *made)
{
    size_t square = 144 * basis->handle_count * basis->handle_count;
    double norm;
    // The curvature is written last, and lends its first row until then.
    form_shifts(basis, size_mm, made->curvature, made->shifts);
    SF_TRY(
        sfi_laplacian_form(mesh, incidence, basis, &made->allocator, task, made->details, &norm));
    for (size_t i = 0; i < square; i++) {
        made->details[i] = norm > 0 ? made->details[i] / norm : 0;
        made->curvature[i] =
            2 * (made->weights[0] * made->details[i] + made->weights[1] * made->shifts[i]);
    }
    memcpy(made->centres, basis->centers_mm, 3 * basis->handle_count * sizeof *made->centres);
    rest_coefficients(basis, made->rest);
    return SF_OK;
}

sf_status sfi_energy_make(sf_mesh_view mesh, const sfi_incidence *incidence, const sf_blend *basis,
                          double size_mm, const double weights[3], const sf_allocator *allocator,
                          sf_task *task, sfi_energy *energy)
{
    sfi_energy made;
    memset(&made, 0, sizeof made);
    made.handle_count = basis->handle_count;
    made.allocator = *allocator;
    memcpy(made.weights, weights, sizeof made.weights);
    sf_status status = take_memory(basis->handle_count, &made);
    if (status == SF_OK) {
        status = fill(mesh, incidence, basis, size_mm, task, &made);
    }
    if (status != SF_OK) {
        sfi_energy_free(&made);
        return status;
    }
    *energy = made;
    return SF_OK;
}

void sfi_energy_free(sfi_energy *energy)
{
    size_t rows = 12 * energy->handle_count, square = rows * rows;
    sf_allocator *a = &energy->allocator;
    sfi_free_array(a, energy->details, square, sizeof *energy->details);
    sfi_free_array(a, energy->shifts, square, sizeof *energy->shifts);
    sfi_free_array(a, energy->curvature, square, sizeof *energy->curvature);
    sfi_free_array(a, energy->rest, rows, sizeof *energy->rest);
    sfi_free_array(a, energy->centres, 3 * energy->handle_count, sizeof *energy->centres);
    memset(energy, 0, sizeof *energy);
}

size_t sfi_energy_scratch(size_t handle_count)
{
    return 36 * handle_count;
}

// slope += factor * form x; returns x . form x.
static double apply(const double *form, const double *x, size_t rows, double factor, double *slope)
{
    double value = 0;
    for (size_t i = 0; i < rows; i++) {
        double sum = 0;
        for (size_t j = 0; j < rows; j++) {
            sum += form[i * rows + j] * x[j];
        }
        slope[i] += factor * sum;
        value += sum * x[i];
    }
    return value;
}

void sfi_energy_at(const sfi_energy *energy, const sf_pose *poses, double *scratch, double terms[3],
                   double *gradient, double *hessian)
{
    size_t count = energy->handle_count, rows = 12 * count;
    double *y = scratch, *moved = y + rows, *slope = moved + rows;
    sfi_pose_coefficients(poses, energy->centres, count, y);
    for (size_t i = 0; i < rows; i++) {
        moved[i] = y[i] - energy->rest[i];
    }
    memset(slope, 0, rows * sizeof *slope);
    const double *w = energy->weights;
    terms[0] = w[0] * apply(energy->details, y, rows, 2 * w[0], slope);
    terms[1] = w[1] * apply(energy->shifts, moved, rows, 2 * w[1], slope);
    terms[2] = 0;
    for (size_t j = 0; j < count; j++) {
        terms[2] += w[2] * (poses[j].scale - 1) * (poses[j].scale - 1);
    }
    if (gradient != NULL) {
        sfi_pose_pull(poses, count, slope, gradient);
        for (size_t j = 0; j < count; j++) {
            gradient[SFI_POSE_SIZE * j + SFI_POSE_SCALE] += 2 * w[2] * (poses[j].scale - 1);
        }
    }
    if (hessian != NULL) {
        sfi_pose_pull_form(poses, count, energy->curvature, hessian);
        for (size_t j = 0; j < count; j++) {
            size_t at = SFI_POSE_SIZE * j + SFI_POSE_SCALE;
            hessian[at * SFI_POSE_SIZE * count + at] += 2 * w[2];
        }
    }
}

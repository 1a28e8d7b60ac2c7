// SPDX-License-Identifier: MIT
// What bending costs: lost details, moved matter, changed sizes.

#ifndef SF_BALANCE_ENERGY_H
#define SF_BALANCE_ENERGY_H

#include "balance/bend/basis.h"
#include "balance/bend/incidence.h"
#include "balance/bend/pose.h"

#include <sf/bend.h>

typedef struct sfi_energy {
    size_t handle_count;
    double *details;   // form in the coefficients: the Laplacian energy over its norm
    double *shifts;    // form in the coefficients' change: mean |u|^2 over the size squared
    double *curvature; // second derivatives of both with their weights
    double *rest;      // coefficients at rest
    double *centres;   // of the handles
    double weights[3]; // of details, shifts and scales
    sf_allocator allocator;
} sfi_energy;

// For a mesh whose vertices are the basis' points. `size_mm` is what shifts are measured by.
sf_status sfi_energy_make(sf_mesh_view mesh, const sfi_incidence *incidence, const sf_blend *basis,
                          double size_mm, const double weights[3], const sf_allocator *allocator,
                          sf_task *task, sfi_energy *energy);

// Free what was made; one that is all zero is none.
void sfi_energy_free(sfi_energy *energy);

// The energy of poses: its terms, each with its weight. `gradient`, 7 numbers a handle, and
// `hessian`, square of these, may be NULL; the latter is that of Gauss and Newton, positive
// semidefinite. `scratch` is of sfi_energy_scratch(handle_count) numbers.
void sfi_energy_at(const sfi_energy *energy, const sf_pose *poses, double *scratch, double terms[3],
                   double *gradient, double *hessian);
size_t sfi_energy_scratch(size_t handle_count);

#endif

// SPDX-License-Identifier: MIT
// Carving that leaves nothing hanging: the wall, and inside it what carries the wall and what
// balances the part.

#ifndef SF_BALANCE_FOREST_H
#define SF_BALANCE_FOREST_H

#include <sf/body.h>
#include <sf/support.h>

#include "balance/forest/lagrange.h"

// What to carve for. All zero is: as light as can be, single voxels.
typedef struct sfi_forest_options {
    sfi_forest_goal goal;           // not looked at without half-spaces: then as little as can be
    const sf_halfspace *halfspaces; // where the centre of mass may lie, all stances together
    size_t count;                   // of half-spaces
    // What depth is. A centre of mass c is at depth d in a half-space when
    //     normal . c - offset >= d (slope normal . c - slope offset)
    // NULL: d is the distance, in mm where normals have length 1. With slopes that give the height
    // of c above the ground, and half-spaces of no margin, d is the tangent of the tilt that it
    // stands. A slope must count more than 0 for every body that can result.
    const sf_halfspace *slopes;
    const float *density; // NULL for 1; else of each voxel as in sf_grid_body(), 0 or more
    sf_body rest;         // all that weighs and is no voxel of the solid
    uint32_t strut_width; // 0 counts as 1; at most SF_REACH_MAX
} sfi_forest_options;

typedef struct sfi_forest_report {
    sfi_forest_goal goal; // what was reached for: the deepest where not all could hold
    int holds;            // every half-space holds for the result
    sf_body body;         // of the result, and the rest
    double depth; // least depth of the result in a half-space; 0 without any, or without mass
    double bound; // no carving, support-free or not, has a better mass (goals most and
                  // least) or depth (deepest); without half-spaces the mass of the wall
    uint64_t removed_voxels; // of the solid
    uint64_t kept_voxels;    // in the result and not in the wall
    uint64_t thin_voxels;    // of those, single ones where no strut of the width fits
    uint64_t asked_voxels;   // of the wall, what it does not carry itself
    uint32_t evaluations;    // of the forest
} sfi_forest_report;

// result = a shape between wall and solid that meets the half-spaces, or comes as near as was
// found. Each of its voxels that was supported in the solid is supported in it, under the whole
// rule; added voxels are in squares of the strut's width that lie in a slice of it, but for the
// thin ones.
//
// terms: rule, bed, exempt; of the solid, `keep` stays, and so does all outside `act`. What the
// solid itself does not support counts as exempt. With SF_BED_AUTO the bed is the first layer of
// the solid that holds matter. All grids have one size; result is none of the others.
//
// SF_ERR_ARGUMENT: a NULL pointer, terms that do not serve the solid, a width or a goal outside its
// range, a density that is negative or not finite, half-spaces without an array, numbers that are
// not finite, a body without mass, slopes that count 0 or less for the solid, one grid given twice;
// SF_ERR_SHAPE; SF_ERR_INFEASIBLE: the wall is not within the solid; SF_ERR_MEMORY;
// SF_ERR_OVERFLOW: 2^32 - 16 voxels or more; SF_ERR_CANCELLED; SF_ERR_INTERNAL: the result failed
// its check. `report` may be NULL.
sf_status sfi_carve_forest(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                           const sfi_forest_options *options, const sf_allocator *allocator,
                           sf_task *task, sf_grid *result, sfi_forest_report *report);

// The best that any carving can reach, support-free or not: the fractional optimum over the voxels
// that may be carved. depth: the largest depth in all half-spaces; mass (or NULL): the most that
// may stay while all of them hold, 0 where they cannot. terms may be NULL where there are no masks.
// Codes as above; SF_ERR_ARGUMENT also where there are no half-spaces.
sf_status sfi_carve_bound(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                          const sfi_forest_options *options, const sf_allocator *allocator,
                          sf_task *task, double *depth, double *mass);

#endif

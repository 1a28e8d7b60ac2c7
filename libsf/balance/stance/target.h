// SPDX-License-Identifier: MIT
// Where a centre of mass may lie, and where it should go.

#ifndef SF_BALANCE_TARGET_H
#define SF_BALANCE_TARGET_H

#include <sf/body.h>

// One stance: up, a unit vector, and its half-spaces, the normals of which have length 1 (or 0).
typedef struct sfi_base {
    double up[3];
    const sf_halfspace *halfspaces;
    size_t count;
} sfi_base;

// A place across a base's up, in the two directions that sfi_base_across() gives, from a given
// centre of mass.
typedef struct sfi_offset {
    double along[2];
} sfi_offset;

// Two unit vectors across up, and across each other.
void sfi_base_across(const sfi_base *base, double across[2][3]);

// Least over all half-spaces of all bases of how far inside it the place lies; 0 without any.
double sfi_bases_slack(const sfi_base *bases, size_t count, const double com_mm[3]);

// Doubles of scratch that sfi_base_target() needs for a base of so many half-spaces.
size_t sfi_base_scratch(size_t halfspace_count);

// What a target is for.
typedef enum sfi_target {
    SFI_TARGET_NEAREST, // the safe place that is closest; where none is safe, as below
    SFI_TARGET_DEEPEST  // the place of largest least slack, and of several the closest
} sfi_target;

// The target at the height of a centre of mass, from there, no farther than about `reach_mm`.
sfi_offset sfi_base_target(const sfi_base *base, const double com_mm[3], sfi_target which,
                           double reach_mm, double *scratch);

#endif

// SPDX-License-Identifier: MIT
// A bent shape and what is asked of it: where its weight may lie, what must not touch the ground.

#ifndef SF_BALANCE_POSTURE_H
#define SF_BALANCE_POSTURE_H

#include "balance/bend/energy.h"
#include "balance/bend/stretch.h"

// A closed mesh that bends: the outside of the shape, or, inside out, its cavity.
typedef struct sfi_skin {
    sf_blend basis; // of the mesh's vertices
    const uint32_t *triangles;
    const sfi_incidence *incidence;
} sfi_skin;

// One way in which it must stand or hang.
typedef struct sfi_standing {
    double up[3];     // of length 1
    double height_mm; // of the ground along it, which only contacts may touch; -INFINITY: it hangs
    size_t safe_first, safe_count; // its half-spaces
} sfi_standing;

enum { SFI_STANDINGS_MAX = 32, SFI_SKINS_MAX = 2 };

// Everything that does not change while handles move.
typedef struct sfi_posture {
    const sfi_energy *energy;
    const sfi_skin *skins; // the outside first
    size_t skin_count;
    double loose_mass;        // of what is carried along: magnets, and what weighs more than 1
    const double *loose_sums; // the sum of its mass times each function of the basis
    const sf_halfspace *safe; // where the centre of mass must lie; normals of length 1
    size_t safe_count;
    const sfi_standing *standings;
    size_t standing_count;
    const uint32_t *held; // of each vertex of the outside: bit i where it may touch ground i
    const uint32_t *foot; // bit i where it must stay above ground i, but may come close; or NULL
    const sfi_stretch *stretches[2]; // where volume must not shrink too far; each may be NULL
    double clearance_mm;             // how far all others must stay above
    double size_mm;                  // of the shape: lengths are measured by it
} sfi_posture;

// What poses make of a shape.
typedef struct sfi_posture_state {
    double terms[3]; // of the energy
    double energy;   // their sum
    sf_body body;    // all together
    double unsafe;   // how far the centre of mass lies outside the safe set, over the size
    double sunk;     // how far the lowest vertex lies too low, over the size
    double crushed;  // how far the least growth of volume lies below what is allowed
} sfi_posture_state;

// Least factor by which bending may change volume anywhere.
#define SFI_LEAST_GROWTH 0.25

// Rows gradient . change of coefficients >= -value, in lengths over the size: first those of the
// safe set, then those of vertices near the ground, then growth of volume where it is least.
typedef struct sfi_posture_rows {
    double *gradients; // 12 numbers a handle for each row
    double *values;
    size_t count, safe_count;
} sfi_posture_rows;

// Room for looking at one posture; filled anew by every look.
typedef struct sfi_posture_scratch {
    double *bent[SFI_SKINS_MAX]; // x, y, z of each vertex of each skin
    double *memory;              // all numbers but those
    double *by_body, *by_skin;   // 48 numbers a handle: of the whole body, of one skin
    double *coefficients, *energy, *functions;
    uint32_t *lowest; // vertex of each cell of the ground
    double *growth;   // of each place of the stretches
    sfi_posture_rows rows;
    size_t vertex_counts[SFI_SKINS_MAX], memory_count, row_capacity, place_count;
    sf_allocator allocator;
} sfi_posture_scratch;

sf_status sfi_posture_scratch_make(const sfi_posture *posture, const sf_allocator *allocator,
                                   sfi_posture_scratch *scratch);
void sfi_posture_scratch_free(sfi_posture_scratch *scratch);

// Bend, weigh, and fill in the rows. SF_ERR_MEMORY; SF_ERR_CANCELLED; SF_ERR_ARGUMENT: no mass is
// left, or a pose is not finite.
sf_status sfi_posture_look(const sfi_posture *posture, const sf_pose *poses, sf_task *task,
                           sfi_posture_scratch *scratch, sfi_posture_state *state);

#endif

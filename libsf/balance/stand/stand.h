// SPDX-License-Identifier: MIT
// What is inside a shape on its way to standing.

#ifndef SF_BALANCE_STAND_H
#define SF_BALANCE_STAND_H

#include "balance/bend/descent.h"
#include "balance/bend/sqp.h"
#include "balance/stand/stand_surface.h"

#include <sf/blend.h>
#include <sf/stand.h>

// A carving of the shape as it is bent at the time.
typedef struct sfi_carved {
    sf_grid *solid, *result;
    float *density; // of each voxel, as sfi_stand_weigh() says; or NULL
    size_t voxel_count;
    sf_mesh *cavity;        // its triangles look into the hollow
    double *rest, *weights; // of the cavity's vertices, before bending; NULL where nothing bends
    size_t point_count;
    sfi_incidence incidence;
    double loose_mass;  // of what is carried along
    double *loose_sums; // by function; NULL where nothing bends
    sf_body body;       // the outside, the cavity, and what is carried along
    uint64_t overlap_voxels, hanging_voxels;
    double bound_rad; // best margin of all carvings of this shape, where it was asked for
    int has_bound;
} sfi_carved;

// What a shape rests on: as it was asked for, with the reserve that bending aims at, and of these
// the half-spaces, one stance after the other.
typedef struct sfi_stances {
    sf_stance **asked, **aimed;
    sfi_standing *standings;
    sf_halfspace *safe;
    size_t safe_count;
} sfi_stances;

// The best round, and how many there were since.
typedef struct sfi_record {
    sf_pose *poses; // NULL where nothing bends
    double energy, margin_rad;
    uint32_t idle;
    int rank; // 2: as was asked; 1: not folded; 0
} sfi_record;

struct sf_stand {
    sf_allocator allocator;
    sf_stand_options options; // every 0 replaced by what it stands for
    sf_ballast *ballast;      // the options' own
    double size_mm;           // the longest side
    sf_mesh *outer;           // the triangles that were handed in
    double *vertices;         // its own, where they are
    sfi_stand_surface surface;
    double *bent; // the surface's points, where they are
    sf_stance_options *asked;
    size_t stance_count;
    sfi_stances stances;
    uint32_t *held; // of each point: bit i where it may touch the ground of stance i
    uint32_t *foot; // bit i where it may come close to it: it belongs to what stands there
    // Handles: those that were handed in, then the one that holds still. None where nothing bends.
    sf_handle *handles;
    sf_pose *poses;
    uint8_t *free; // of each parameter
    size_t handle_count;
    sf_grid *base; // the voxels that hold still
    sf_weights *field;
    double *weights;     // of the surface's points
    sfi_stretch stretch; // places spread through the solid
    sfi_stretch watched; // and those where steps have folded it
    sfi_energy energy;
    double *energy_scratch;
    sfi_descent descent;
    // The last round.
    sfi_carved carved;
    sf_stand_report report;
    sfi_record best;
    uint32_t first_round; // how many rounds there were when poses were last set
};

// Whether handles may move at all.
static inline int sfi_stand_bends(const sf_stand *stand)
{
    return stand->handle_count > 0;
}

// The stances of a shape whose surface has been made, of its points anywhere.
sf_status sfi_stances_make(const sf_stand *stand, const double *points, sfi_stances *stances,
                           sf_fault *fault);
void sfi_stances_free(const sf_stand *stand, sfi_stances *stances);

// Contacts onto the ground, and the stances of what results.
sf_status sfi_stand_take_stances(sf_stand *stand, sf_fault *fault);

// What bending into poses costs.
double sfi_stand_energy(const sf_stand *stand, const sf_pose *poses);

// Handles, weights and energy. The stances have been made.
sf_status sfi_stand_take_handles(const sf_handle *handles, size_t count, sf_task *task,
                                 sf_stand *stand, sf_fault *fault);

// A box of cubes around a mesh, with one to spare on each side, on places that do not depend on it.
sf_status sfi_stand_lattice(const sf_stand *stand, sf_mesh_view mesh, sf_lattice *lattice);

// Carve the shape that is bent as `bent` and `poses` say, for stances.
sf_status sfi_carved_make(const sf_stand *stand, const double *bent, const sf_pose *poses,
                          sf_stance *const *stances, sf_carve_goal goal, sf_task *task,
                          sfi_carved *carved);
// Whether a bound may be asked for of the shape in these poses: it is as it was handed in, all
// stances stand, and something is carved.
int sfi_stand_has_best(const sf_stand *stand, const sf_pose *poses);

// The margin that no carving of the solid can pass; `rest` is what weighs and is no voxel of it.
// There is none where carving could bring the centre of mass down to a ground.
sf_status sfi_stand_best(const sf_stand *stand, const sf_grid *solid, const sf_grid *wall,
                         const float *density, const sf_body *rest, sf_task *task, int *has_bound,
                         double *bound_rad);

void sfi_carved_free(const sf_stand *stand, sfi_carved *carved);

// What 1 mm3 weighs in each voxel of a bent shape, solid or not, in (layer, y, x) order; NULL where
// that is 1 everywhere. SF_ERR_ARGUMENT: a density that is not above 0 or not finite.
sf_status sfi_stand_weigh(const sf_stand *stand, const sf_pose *poses, const sf_grid *solid,
                          sf_task *task, float **density, size_t *count);

// Add to a wall the voxels of the solid that options.keep names, followed back like those that are
// weighed.
sf_status sfi_stand_keep(const sf_stand *stand, const sf_pose *poses, const sf_grid *solid,
                         sf_task *task, sf_grid *wall);

// Add to a body what the voxels of a grid weigh more or less than 1; `density` as from
// sfi_stand_weigh().
sf_status sfi_stand_weigh_more(const sf_grid *grid, const float *density, sf_body *body);

// What the solid weighs as it was handed in, before there are handles: a mesh, and what its voxels
// weigh more or less than 1. Masses in points are not in it.
sf_status sfi_stand_weigh_given(const sf_stand *stand, sf_mesh_view mesh, sf_task *task,
                                sf_body *body);

// A mass that is carried along, where it was before bending, into the sums of what bends. `scratch`
// has room for 5 numbers a handle, and is not looked at where nothing bends.
sf_status sfi_stand_carry(const sf_stand *stand, double mass, const double rest[3], double *scratch,
                          sfi_carved *carved);

// The same of all that the voxels left of a shape weigh more or less than 1.
sf_status sfi_stand_carry_all(const sf_stand *stand, const sf_pose *poses, const float *density,
                              sf_task *task, double *scratch, sfi_carved *carved);

#endif

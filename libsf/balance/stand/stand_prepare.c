// SPDX-License-Identifier: MIT
// A shape before bending: its stances, its handles, and what bending it would cost.
//
// Contacts are put onto the ground first, and everything else is made from the shape with its feet
// flat. The voxels that contacts lie in, and the one that it hangs from, are a handle of their own
// that never moves: weights are 1 for it on all corners of their cells, and 0 for every other
// handle, so that contacts stay exactly where they are and a stance that was made once stays true.
// Only what a shape rocks on is found anew after every bending.
//
// Whoever stands so may touch the ground: contacts, and what the held cells do not let go. All
// other vertices have to stay clear of it.
//
// Source: R. Prevost and others, "Make It Stand", SIGGRAPH 2013, section 5, handle placement.

#include "balance/stand/stand.h"

#include "balance/stance/stance.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "mesh/vector.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

// A vertex whose weight for what holds still is at least this moves along with it.
#define HELD 0.999
// Places at which bending is watched not to crush the solid.
enum { PLACES = 4096 };
// And most of those that are watched beside them, because the shape was folded there.
enum { WATCHED_MOST = 2048 };

// --- Stances -------------------------------------------------------------------------------------

// The same stance, asked for a little more than it has to give, but for no more than can be asked.
static sf_stance_options reserved(const sf_stand *stand, const sf_stance_options *asked)
{
    sf_stance_options o = *asked;
    double reserve = stand->options.reserve_rad, least = 0.5 * o.tolerance_rad;
    o.gamma_rad = o.gamma_rad + reserve < SFI_TILT_MAX ? o.gamma_rad + reserve : SFI_TILT_MAX;
    o.tolerance_rad = o.tolerance_rad - reserve > least ? o.tolerance_rad - reserve : least;
    return o;
}

static sf_status count_halfspaces(const sf_stance *stance, size_t *count)
{
    sf_status status = sf_stance_halfspaces(stance, NULL, 0, count);
    return status == SF_ERR_CAPACITY ? SF_OK : status;
}

// The half-spaces that bending aims at, of stances that ask for the reserve as well.
static sf_status gather_halfspaces(const sf_stand *stand, sf_stance *const *aims,
                                   sf_halfspace **safe, size_t *safe_count, sfi_standing *standings)
{
    size_t all = 0, at = 0, count;
    for (size_t i = 0; i < stand->stance_count; i++) {
        SF_TRY(count_halfspaces(aims[i], &count));
        all += count;
    }
    sf_halfspace *made = sfi_alloc_array(&stand->allocator, all, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < stand->stance_count; i++) {
        sf_stance_options o = sf_stance_get_options(aims[i]);
        sf_status status = sf_stance_halfspaces(aims[i], made + at, all - at, &count);
        if (status != SF_OK) {
            sfi_free_array(&stand->allocator, made, all, sizeof *made);
            return status;
        }
        memcpy(standings[i].up, o.up, sizeof o.up);
        standings[i].height_mm = o.kind == SF_STANCE_STAND ? sf_stance_ground(aims[i]) : -INFINITY;
        standings[i].safe_first = at;
        standings[i].safe_count = count;
        at += count;
    }
    *safe = made;
    *safe_count = all;
    return SF_OK;
}

void sfi_stances_free(const sf_stand *stand, sfi_stances *stances)
{
    for (size_t i = 0; i < stand->stance_count; i++) {
        if (stances->asked != NULL) {
            sf_stance_destroy(stances->asked[i]);
        }
        if (stances->aimed != NULL) {
            sf_stance_destroy(stances->aimed[i]);
        }
    }
    const sf_allocator *a = &stand->allocator;
    sfi_free_array(a, stances->asked, stand->stance_count, sizeof *stances->asked);
    sfi_free_array(a, stances->aimed, stand->stance_count, sizeof *stances->aimed);
    sfi_free_array(a, stances->standings, stand->stance_count, sizeof *stances->standings);
    sfi_free_array(a, stances->safe, stances->safe_count, sizeof *stances->safe);
    memset(stances, 0, sizeof *stances);
}

static sf_status take(const sf_allocator *allocator, size_t count, size_t size, void *pointer)
{
    void *made = sfi_alloc_array(allocator, count, size);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, count * size);
    memcpy(pointer, &made, sizeof made);
    return SF_OK;
}

static sf_status fill_stances(const sf_stand *stand, sf_mesh_view mesh, sfi_stances *made,
                              sf_fault *fault)
{
    const sf_allocator *a = &stand->allocator;
    size_t count = stand->stance_count;
    SF_TRY(take(a, count, sizeof *made->asked, &made->asked));
    SF_TRY(take(a, count, sizeof *made->aimed, &made->aimed));
    SF_TRY(take(a, count, sizeof *made->standings, &made->standings));
    for (size_t i = 0; i < count; i++) {
        sf_stance_options aimed = reserved(stand, &stand->asked[i]);
        SF_TRY(sf_stance_create(mesh, &stand->asked[i], a, &made->asked[i], fault));
        SF_TRY(sf_stance_create(mesh, &aimed, a, &made->aimed[i], fault));
    }
    return gather_halfspaces(stand, made->aimed, &made->safe, &made->safe_count, made->standings);
}

sf_status sfi_stances_make(const sf_stand *stand, const double *points, sfi_stances *stances,
                           sf_fault *fault)
{
    sfi_stances made;
    memset(&made, 0, sizeof made);
    sf_mesh_view view = sfi_stand_surface_view(&stand->surface, points);
    sf_status status = fill_stances(stand, view, &made, fault);
    if (status != SF_OK) {
        sfi_stances_free(stand, &made);
        return status;
    }
    *stances = made;
    return SF_OK;
}

// Put all contacts of standing stances onto their grounds.
static sf_status flatten(sf_stand *stand)
{
    for (size_t i = 0; i < stand->stance_count; i++) {
        if (stand->asked[i].kind == SF_STANCE_STAND) {
            SF_TRY(sf_stance_flatten(stand->stances.asked[i], stand->surface.points,
                                     stand->surface.point_count));
        }
    }
    return SF_OK;
}

sf_status sfi_stand_take_stances(sf_stand *stand, sf_fault *fault)
{
    sfi_stances flat;
    SF_TRY(sfi_stances_make(stand, stand->surface.points, &stand->stances, fault));
    SF_TRY(flatten(stand));
    SF_TRY(sfi_stances_make(stand, stand->surface.points, &flat, fault));
    sfi_stances_free(stand, &stand->stances);
    stand->stances = flat;
    return SF_OK;
}

// --- What holds still ----------------------------------------------------------------------------

// The voxels whose closed boxes hold a point; none where it lies outside of the lattice.
static sf_status hold(sf_grid *base, const double p[3])
{
    sf_lattice l = sf_grid_lattice(base);
    const double pitch[3] = {l.pitch_x_mm, l.pitch_y_mm, l.layer_mm};
    const uint32_t counts[3] = {l.nx, l.ny, l.nz};
    uint32_t low[3], high[3];
    for (int d = 0; d < 3; d++) {
        double at = (p[d] - l.origin_mm[d]) / pitch[d];
        double first = floor(at - 1e-9), last = floor(at + 1e-9);
        if (!(last >= 0 && first < counts[d])) {
            return SF_OK;
        }
        low[d] = first > 0 ? (uint32_t)first : 0;
        high[d] = last < counts[d] ? (uint32_t)last : counts[d] - 1;
    }
    for (uint32_t k = low[2]; k <= high[2]; k++) {
        sf_rect rect = {low[0], low[1], high[0] + 1, high[1] + 1};
        SF_TRY(sf_slice_fill(sf_grid_slice(base, k), rect, 1));
    }
    return SF_OK;
}

static sf_status hold_contacts(sf_stand *stand, const sf_stance *stance, size_t index)
{
    size_t count = 0;
    sf_status status = sf_stance_contacts(stance, NULL, 0, &count);
    if (status != SF_ERR_CAPACITY || count == 0) {
        return status == SF_ERR_CAPACITY ? SF_OK : status;
    }
    uint32_t *contacts = sfi_alloc_array(&stand->allocator, count, sizeof *contacts);
    if (contacts == NULL) {
        return SF_ERR_MEMORY;
    }
    status = sf_stance_contacts(stance, contacts, count, &count);
    for (size_t i = 0; i < count && status == SF_OK; i++) {
        stand->held[contacts[i]] |= UINT32_C(1) << index;
        status = hold(stand->base, stand->surface.points + 3 * (size_t)contacts[i]);
    }
    sfi_free_array(&stand->allocator, contacts, count, sizeof *contacts);
    return status;
}

static sf_status hold_all(sf_stand *stand)
{
    for (size_t i = 0; i < stand->stance_count; i++) {
        if (stand->asked[i].kind == SF_STANCE_HANG) {
            SF_TRY(hold(stand->base, stand->asked[i].point_mm));
        } else {
            SF_TRY(hold_contacts(stand, stand->stances.asked[i], i));
        }
    }
    // The handle holds voxels of the shape, or that its surface touches.
    return SF_OK;
}

static int is_within(const double p[3], const double low[3], const double high[3])
{
    return p[0] >= low[0] && p[1] >= low[1] && p[2] >= low[2] && p[0] <= high[0] &&
           p[1] <= high[1] && p[2] <= high[2];
}

// The feet: what already comes closer to the ground than all else may, in the region of contacts.
static void mark_feet(sf_stand *stand)
{
    for (size_t i = 0; i < stand->stance_count; i++) {
        const sfi_standing *ground = &stand->stances.standings[i];
        const sf_stance_options *o = &stand->asked[i];
        for (size_t v = 0; v < stand->surface.point_count && isfinite(ground->height_mm); v++) {
            const double *p = stand->surface.points + 3 * v;
            double height = sfi_dot(ground->up, p) - ground->height_mm;
            if (height < stand->options.clearance_mm &&
                is_within(p, o->region_low_mm, o->region_high_mm)) {
                stand->foot[v] |= UINT32_C(1) << i;
            }
        }
    }
}

// What holds still cannot be told to touch the ground or not.
static void hold_neighbours(sf_stand *stand)
{
    uint32_t all = 0;
    for (size_t i = 0; i < stand->stance_count; i++) {
        all |= UINT32_C(1) << i;
    }
    for (size_t v = 0; v < stand->surface.point_count; v++) {
        if (stand->weights[stand->handle_count * (v + 1) - 1] >= HELD) {
            stand->held[v] = all;
        }
    }
}

// --- Handles -------------------------------------------------------------------------------------

sf_status sfi_stand_lattice(const sf_stand *stand, sf_mesh_view view, sf_lattice *lattice)
{
    double low[3], high[3], pitch = stand->options.pitch_mm;
    uint32_t counts[3];
    memset(lattice, 0, sizeof *lattice);
    SF_TRY(sf_mesh_bounds(view, low, high));
    for (int d = 0; d < 3; d++) {
        double first = floor(low[d] / pitch) - 1, last = floor(high[d] / pitch) + 2;
        if (!(last - first <= SF_EXTENT_MAX)) {
            return SF_ERR_OVERFLOW;
        }
        lattice->origin_mm[d] = first * pitch;
        counts[d] = (uint32_t)(last - first);
    }
    lattice->nx = counts[0];
    lattice->ny = counts[1];
    lattice->nz = counts[2];
    lattice->pitch_x_mm = lattice->pitch_y_mm = lattice->layer_mm = pitch;
    return SF_OK;
}

// The shape before bending, with every voxel that its surface touches.
static sf_status make_domain(const sf_stand *stand, sf_task *task, sf_grid **domain)
{
    sf_mesh_view view = sfi_stand_surface_view(&stand->surface, stand->surface.points);
    sf_lattice lattice;
    sf_grid *solid = NULL;
    SF_TRY(sfi_stand_lattice(stand, view, &lattice));
    SF_TRY(sf_grid_create(&lattice, &stand->allocator, &solid));
    sf_voxelize_options options = sf_voxelize_options_default();
    options.fill = SF_FILL_WINDING;
    sf_status status = sf_grid_voxelize(solid, view, &options, &stand->allocator, NULL, NULL);
    if (status == SF_OK) {
        status = sf_grid_cover(solid, view, &stand->allocator, task, domain);
    }
    sf_grid_destroy(solid);
    return status;
}

static sf_status clip(sf_grid *base, const sf_grid *domain)
{
    for (uint32_t k = 0; k < sf_grid_lattice(base).nz; k++) {
        sf_slice slice = sf_grid_slice(base, k);
        SF_TRY(sf_slice_and(slice, slice, sf_grid_slice(domain, k)));
    }
    return SF_OK;
}

static sf_status make_field(const sf_handle *handles, sf_task *task, const sf_grid *domain,
                            sf_stand *stand, sf_fault *fault)
{
    size_t own = stand->handle_count - 1, points = stand->surface.point_count, numbers;
    sf_lattice lattice = sf_grid_lattice(domain);
    SF_TRY(sf_grid_create(&lattice, &stand->allocator, &stand->base));
    SF_TRY(hold_all(stand));
    SF_TRY(clip(stand->base, domain));
    memcpy(stand->handles, handles, own * sizeof *handles);
    if (sf_handle_base(stand->base, &stand->handles[own]) != SF_OK) {
        return sfi_fault_set(fault, SF_ERR_INFEASIBLE, 0, 0,
                             "what it stands on or hangs from lies outside the shape; choose "
                             "contacts or a point on its surface");
    }
    SF_TRY(sf_weights_create(domain, stand->handles, stand->handle_count, NULL, &stand->allocator,
                             task, &stand->field, fault));
    if (!sfi_size_mul(points, stand->handle_count, &numbers)) {
        return SF_ERR_OVERFLOW;
    }
    SF_TRY(take(&stand->allocator, numbers, sizeof(double), &stand->weights));
    SF_TRY(sf_weights_sample(stand->field, stand->surface.points, points, task, stand->weights));
    hold_neighbours(stand);
    mark_feet(stand);
    SF_TRY(
        sfi_stretch_reserve(stand->handle_count, WATCHED_MOST, &stand->allocator, &stand->watched));
    return sfi_stretch_make(stand->field, domain, PLACES, &stand->allocator, &stand->stretch);
}

static void free_parameters(sf_stand *stand)
{
    for (size_t p = 0; p < SFI_POSE_SIZE * stand->handle_count; p++) {
        int turns = p % SFI_POSE_SIZE >= SFI_POSE_TURN;
        int locked = stand->handles[p / SFI_POSE_SIZE].locked;
        stand->free[p] = !locked && (!turns || stand->options.turn);
    }
}

sf_status sfi_stand_take_handles(const sf_handle *handles, size_t count, sf_task *task,
                                 sf_stand *stand, sf_fault *fault)
{
    const sf_allocator *a = &stand->allocator;
    const sf_stand_options *o = &stand->options;
    const double weights[3] = {o->weight_details, o->weight_shifts, o->weight_scales};
    sf_grid *domain = NULL;
    stand->handle_count = count + 1;
    SF_TRY(take(a, stand->handle_count, sizeof *stand->handles, &stand->handles));
    SF_TRY(take(a, stand->handle_count, sizeof *stand->poses, &stand->poses));
    SF_TRY(take(a, stand->handle_count, sizeof *stand->best.poses, &stand->best.poses));
    SF_TRY(take(a, SFI_POSE_SIZE * stand->handle_count, 1, &stand->free));
    SF_TRY(
        take(a, sfi_energy_scratch(stand->handle_count), sizeof(double), &stand->energy_scratch));
    SF_TRY(make_domain(stand, task, &domain));
    sf_status status = make_field(handles, task, domain, stand, fault);
    sf_grid_destroy(domain);
    SF_TRY(status);
    for (size_t j = 0; j < stand->handle_count; j++) {
        stand->poses[j] = sf_pose_identity();
    }
    free_parameters(stand);
    sf_blend basis = {stand->surface.points, stand->weights, stand->surface.point_count,
                      sf_weights_centers(stand->field), stand->handle_count};
    return sfi_energy_make(sfi_stand_surface_view(&stand->surface, stand->surface.points),
                           &stand->surface.incidence, &basis, stand->size_mm, weights, a, task,
                           &stand->energy);
}

double sfi_stand_energy(const sf_stand *stand, const sf_pose *poses)
{
    double terms[3];
    sfi_energy_at(&stand->energy, poses, stand->energy_scratch, terms, NULL, NULL);
    return terms[0] + terms[1] + terms[2];
}

// SPDX-License-Identifier: MIT
// A shape on its way to standing: making it, asking it, posing its handles by hand.
//
// What happens in a round stands in balance/stand/stand_round.c, what is carved in
// balance/stand/stand_carve.c, and what is prepared once in balance/stand/stand_prepare.c. Here
// options and meshes are looked at before anything is made of them: whoever gets past this file has
// a closed surface that looks outwards, a positive volume, and numbers that mean something.

#include "balance/stand/stand.h"

#include "balance/stance/stance.h"
#include "base/memory.h"
#include "base/status.h"
#include "mesh/mesh.h"

#include <math.h>
#include <string.h>

#define DEGREE_RAD 0.017453292519943295
#define SIXTY_FOURTH 0.015625

enum { STANCES_MAX = SFI_STANDINGS_MAX };

sf_stand_options sf_stand_options_default(void)
{
    sf_stand_options options = {.struct_size = sizeof options,
                                .carve = 1,
                                .deform = 1,
                                .carve_mode = SF_CARVE_SUPPORT_FREE,
                                .strut_width_vx = 2,
                                .rule = SF_RULE_OCTAGON,
                                .angle_rad = 45 * DEGREE_RAD,
                                .solver = SF_STAND_PROGRAMS,
                                .mu = 0.5,
                                .weight_details = 1,
                                .weight_shifts = 0.3,
                                .weight_scales = 0.05,
                                .scale_low = 0.7,
                                .scale_high = 1.4,
                                .reserve_rad = 0.1 * DEGREE_RAD};
    return options;
}

// --- What is refused -----------------------------------------------------------------------------

static int is_within(double value, double low, double high)
{
    return value >= low && value <= high;
}

// What is wrong with options, or NULL.
static const char *find_fault(const sf_stand_options *o)
{
    if (o->struct_size < sizeof *o) {
        return "the options have no struct_size; make them with sf_stand_options_default()";
    }
    if (!is_within(o->pitch_mm, 0, 1e9) || !is_within(o->wall_mm, 0, 1e9) ||
        !is_within(o->clearance_mm, 0, 1e9) || !is_within(o->shift_max_mm, 0, 1e9)) {
        return "pitch, wall, clearance and the longest shift are lengths in mm, 0 for the default, "
               "at most 1e9";
    }
    if ((int)o->carve_mode < 0 || o->carve_mode > SF_CARVE_PLANE || (int)o->solver < 0 ||
        o->solver > SF_STAND_DESCENT) {
        return "there is no such way of carving, or no such solver";
    }
    if (!is_within(o->mu, 0, 1)) {
        return "mu is the share of the shape in the sum: 0 to 1";
    }
    if (!is_within(o->weight_details, 0, 1e9) || !is_within(o->weight_shifts, 0, 1e9) ||
        !is_within(o->weight_scales, 0, 1e9)) {
        return "the weights of the energy are numbers from 0 to 1e9";
    }
    if (!(o->scale_low > 0) || !is_within(1, o->scale_low, o->scale_high) ||
        !(o->scale_high <= 1e3)) {
        return "scales are bounded by a number in (0, 1] and one in [1, 1000]";
    }
    if (!is_within(o->reserve_rad, 0, 0.2)) {
        return "the reserve is an angle of 0 to 0.2 radians";
    }
    if (o->strut_width_vx < 1 || o->strut_width_vx > SF_REACH_MAX) {
        return "struts are 1 to 255 voxels wide";
    }
    if (o->ballast_count > 0 && o->ballast == NULL) {
        return "there is a number of masses, but no array of them";
    }
    return NULL;
}

static int ballast_is_finite(const sf_stand_options *o)
{
    for (size_t i = 0; i < o->ballast_count; i++) {
        const sf_ballast *b = &o->ballast[i];
        if (!(b->mass >= 0) || !isfinite(b->mass + b->at_mm[0] + b->at_mm[1] + b->at_mm[2])) {
            return 0;
        }
    }
    return 1;
}

static sf_status check_call(size_t stance_count, const sf_handle *handles, size_t handle_count,
                            const sf_stand_options *options, sf_fault *fault)
{
    const char *wrong = find_fault(options);
    if (wrong == NULL && !ballast_is_finite(options)) {
        wrong = "a mass in a point is negative or not a number";
    }
    if (wrong == NULL && (stance_count < 1 || stance_count > STANCES_MAX)) {
        wrong = "there are 1 to 32 stances";
    }
    if (wrong == NULL && (handle_count >= SF_HANDLE_MAX || (handle_count > 0 && !handles))) {
        wrong = "there are at most 63 handles, in an array";
    }
    for (size_t i = 0; wrong == NULL && i < handle_count; i++) {
        wrong = handles[i].kind == SF_HANDLE_BASE
                    ? "a base is among the handles; what it stands on is one already"
                    : NULL;
    }
    return wrong == NULL ? SF_OK : sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "%s", wrong);
}

static sf_status check_mesh(sf_mesh_view mesh, const sf_allocator *allocator, sf_fault *fault)
{
    sf_topology topology;
    sf_mass mass;
    double low[3], extent[3];
    SF_TRY(sfi_mesh_box(mesh, low, extent, fault)); // before squares and cubes of it may overflow
    SF_TRY(sf_mesh_analyze(mesh, allocator, &topology));
    SF_TRY(sf_mesh_measure(mesh, &mass));
    if (!topology.closed) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "the mesh has holes (%zu edges with one triangle), so it has no "
                             "weight; close it first",
                             topology.boundary_edges);
    }
    if (!topology.oriented || !(mass.volume_mm3 > 0)) {
        return sfi_fault_set(
            fault, SF_ERR_UNSUPPORTED, 0, 0, "%s",
            topology.oriented ? "the mesh is inside out: turn its triangles around first"
                              : "the triangles of the mesh do not agree on what is outside; turn "
                                "them first");
    }
    return SF_OK;
}

// --- Making --------------------------------------------------------------------------------------

static sf_status copy_mesh(sf_mesh_view mesh, sf_stand *s)
{
    uint32_t *triangles;
    SF_TRY(sfi_mesh_make(&s->allocator, mesh.vertex_count, mesh.triangle_count, &s->outer,
                         &s->vertices, &triangles));
    memcpy(s->vertices, mesh.vertices, 3 * mesh.vertex_count * sizeof *s->vertices);
    memcpy(triangles, mesh.triangles, 3 * mesh.triangle_count * sizeof *triangles);
    return SF_OK;
}

static sf_status copy_ballast(sf_stand *s)
{
    sf_stand_options *o = &s->options;
    if (o->ballast_count == 0) {
        return SF_OK;
    }
    s->ballast = sfi_alloc_array(&s->allocator, o->ballast_count, sizeof *s->ballast);
    if (s->ballast == NULL) {
        return SF_ERR_MEMORY;
    }
    memcpy(s->ballast, o->ballast, o->ballast_count * sizeof *s->ballast);
    o->ballast = s->ballast;
    return SF_OK;
}

static sf_status take_sizes(sf_mesh_view mesh, sf_stand *s)
{
    double low[3], high[3];
    SF_TRY(sf_mesh_bounds(mesh, low, high));
    for (int d = 0; d < 3; d++) {
        s->size_mm = high[d] - low[d] > s->size_mm ? high[d] - low[d] : s->size_mm;
    }
    sf_stand_options *o = &s->options;
    o->pitch_mm = o->pitch_mm > 0 ? o->pitch_mm : SIXTY_FOURTH * s->size_mm;
    o->wall_mm = o->wall_mm > 0 ? o->wall_mm : 0.01 * s->size_mm;
    o->clearance_mm = o->clearance_mm > 0 ? o->clearance_mm : 0.01 * s->size_mm;
    o->shift_max_mm = o->shift_max_mm > 0 ? o->shift_max_mm : 0.5 * s->size_mm;
    if (o->rounds_max == 0) {
        o->rounds_max = o->solver == SF_STAND_DESCENT ? 400 : 40;
    }
    return SF_OK;
}

// The balance of the solid as it was given.
static sf_status weigh_before(sf_mesh_view mesh, sf_task *task, sf_stand *s, sf_fault *fault)
{
    sf_body body;
    sf_status weighed = sfi_stand_weigh_given(s, mesh, task, &body);
    if (weighed == SF_ERR_ARGUMENT) {
        return sfi_fault_set(fault, weighed, 0, 0, "a density is not above 0, or no finite number");
    }
    SF_TRY(weighed);
    body = sf_body_add(body, 1, sf_ballast_body(s->options.ballast, s->options.ballast_count));
    SF_TRY(sf_body_com(body, s->report.com_before_mm));
    s->report.margin_before_rad = INFINITY;
    for (size_t i = 0; i < s->stance_count; i++) {
        sf_stance_verdict v;
        SF_TRY(sf_stance_judge(s->stances.asked[i], s->report.com_before_mm, &v));
        if (v.margin_rad < s->report.margin_before_rad) {
            s->report.margin_before_rad = v.margin_rad;
        }
    }
    memcpy(s->report.com_mm, s->report.com_before_mm, sizeof s->report.com_mm);
    s->report.margin_rad = s->report.margin_before_rad;
    s->report.mass = body.mass;
    s->report.bound_rad = 90 * DEGREE_RAD;
    s->report.least_det = 1;
    return SF_OK;
}

static sf_status make(sf_mesh_view mesh, const sf_stance_options *stances, const sf_handle *handles,
                      size_t handle_count, sf_task *task, sf_stand *s, sf_fault *fault)
{
    const sf_allocator *a = &s->allocator;
    SF_TRY(check_mesh(mesh, a, fault));
    SF_TRY(take_sizes(mesh, s));
    SF_TRY(copy_mesh(mesh, s));
    SF_TRY(copy_ballast(s));
    s->asked = sfi_alloc_array(a, s->stance_count, sizeof *s->asked);
    SF_TRY(sfi_stand_surface_make(mesh, a, &s->surface));
    s->bent = sfi_alloc_array(a, s->surface.point_count, 3 * sizeof *s->bent);
    s->held = sfi_alloc_array(a, s->surface.point_count, sizeof *s->held);
    s->foot = sfi_alloc_array(a, s->surface.point_count, sizeof *s->foot);
    if (s->asked == NULL || s->bent == NULL || s->held == NULL || s->foot == NULL) {
        return SF_ERR_MEMORY;
    }
    memcpy(s->asked, stances, s->stance_count * sizeof *stances);
    memset(s->held, 0, s->surface.point_count * sizeof *s->held);
    memset(s->foot, 0, s->surface.point_count * sizeof *s->foot);
    SF_TRY(sfi_stand_take_stances(s, fault));
    SF_TRY(weigh_before(mesh, task, s, fault));
    if (handle_count > 0 && s->options.deform) {
        SF_TRY(sfi_stand_take_handles(handles, handle_count, task, s, fault));
    }
    memcpy(s->bent, s->surface.points, 3 * s->surface.point_count * sizeof *s->bent);
    sfi_stand_surface_spread(&s->surface, s->bent, s->vertices);
    s->descent = sfi_descent_begin(s->options.mu);
    return SF_OK;
}

sf_status sf_stand_create(sf_mesh_view mesh, const sf_stance_options *stances, size_t stance_count,
                          const sf_handle *handles, size_t handle_count,
                          const sf_stand_options *options, const sf_allocator *allocator,
                          sf_task *task, sf_stand **stand, sf_fault *fault)
{
    sf_stand_options chosen = options != NULL ? *options : sf_stand_options_default();
    sf_allocator a = sfi_allocator_or_default(allocator);
    if (stances == NULL || stand == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "a pointer is missing");
    }
    SF_TRY(check_call(stance_count, handles, handle_count, &chosen, fault));
    sf_stand *made = sfi_alloc_array(&a, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = a;
    made->options = chosen;
    made->stance_count = stance_count;
    sf_status status = make(mesh, stances, handles, handle_count, task, made, fault);
    if (status != SF_OK) {
        sf_stand_destroy(made);
        return status;
    }
    *stand = made;
    return SF_OK;
}

static void free_handles(sf_stand *s)
{
    const sf_allocator *a = &s->allocator;
    size_t count = s->handle_count;
    sfi_free_array(a, s->handles, count, sizeof *s->handles);
    sfi_free_array(a, s->poses, count, sizeof *s->poses);
    sfi_free_array(a, s->best.poses, count, sizeof *s->best.poses);
    sfi_free_array(a, s->free, SFI_POSE_SIZE * count, 1);
    sfi_free_array(a, s->energy_scratch, sfi_energy_scratch(count), sizeof(double));
    sfi_free_array(a, s->weights, s->surface.point_count * count, sizeof *s->weights);
    sf_grid_destroy(s->base);
    sf_weights_destroy(s->field);
    sfi_stretch_free(a, &s->stretch);
    sfi_stretch_free(a, &s->watched);
    sfi_energy_free(&s->energy);
}

void sf_stand_destroy(sf_stand *stand)
{
    if (stand == NULL) {
        return;
    }
    sf_allocator a = stand->allocator;
    sfi_carved_free(stand, &stand->carved);
    sfi_stances_free(stand, &stand->stances);
    free_handles(stand);
    sfi_free_array(&a, stand->asked, stand->stance_count, sizeof *stand->asked);
    sfi_free_array(&a, stand->bent, stand->surface.point_count, 3 * sizeof *stand->bent);
    sfi_free_array(&a, stand->held, stand->surface.point_count, sizeof *stand->held);
    sfi_free_array(&a, stand->foot, stand->surface.point_count, sizeof *stand->foot);
    sfi_stand_surface_free(&a, &stand->surface);
    sf_mesh_destroy(stand->outer);
    sfi_free_array(&a, stand->ballast, stand->options.ballast_count, sizeof *stand->ballast);
    sfi_free_array(&a, stand, 1, sizeof *stand);
}

// --- Asking --------------------------------------------------------------------------------------

sf_stand_report sf_stand_describe(const sf_stand *stand)
{
    sf_stand_report none;
    memset(&none, 0, sizeof none);
    return stand != NULL ? stand->report : none;
}

static int is_finite_pose(const sf_pose *pose)
{
    double sum = pose->scale;
    for (int i = 0; i < 9; i++) {
        sum += pose->turn[i] + (i < 3 ? pose->shift_mm[i] : 0);
    }
    return isfinite(sum) && pose->scale > 0;
}

// Whether there is such a handle, beside the one that holds still.
static int has_handle(const sf_stand *stand, size_t handle)
{
    return stand != NULL && stand->handle_count > 0 && handle < stand->handle_count - 1;
}

sf_status sf_stand_set_pose(sf_stand *stand, size_t handle, const sf_pose *pose, int lock)
{
    if (!has_handle(stand, handle) || pose == NULL || !is_finite_pose(pose)) {
        return SF_ERR_ARGUMENT;
    }
    stand->poses[handle] = *pose;
    stand->handles[handle].locked = lock != 0;
    for (size_t p = 0; p < SFI_POSE_SIZE; p++) {
        stand->free[SFI_POSE_SIZE * handle + p] =
            !lock && (p < SFI_POSE_TURN || stand->options.turn);
    }
    stand->report.ended = 0;
    stand->first_round = stand->report.rounds;
    stand->descent = sfi_descent_begin(stand->options.mu);
    stand->best.idle = 0;
    stand->best.rank = 0;
    stand->best.margin_rad = -INFINITY;
    return SF_OK;
}

sf_pose sf_stand_get_pose(const sf_stand *stand, size_t handle)
{
    return has_handle(stand, handle) ? stand->poses[handle] : sf_pose_identity();
}

sf_mesh_view sf_stand_outer(const sf_stand *stand)
{
    return sf_mesh_get_view(stand != NULL ? stand->outer : NULL);
}

sf_mesh_view sf_stand_cavity(const sf_stand *stand)
{
    return sf_mesh_get_view(stand != NULL ? stand->carved.cavity : NULL);
}

const sf_grid *sf_stand_grid(const sf_stand *stand)
{
    return stand != NULL ? stand->carved.result : NULL;
}

const float *sf_stand_density(const sf_stand *stand)
{
    return stand != NULL ? stand->carved.density : NULL;
}

const sf_stance *sf_stand_stance(const sf_stand *stand, size_t index)
{
    return stand != NULL && index < stand->stance_count ? stand->stances.asked[index] : NULL;
}

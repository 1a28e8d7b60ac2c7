// SPDX-License-Identifier: MIT
// Carving a shape as it is bent at the time.
//
// The bent outside becomes voxels anew, on a lattice of its own, and its wall is measured anew: so
// the wall is as thick as it was asked for on the shape that will be printed, and a support-free
// cavity is support-free on the layers that will be printed. Carving voxels that bend along with
// the shape, as the paper does, promises neither.
//
// What bends next is the surface of the cavity together with the outside. Its vertices lie in the
// bent shape, so each is first followed back to where it was before bending; there its weights are
// looked up. What weighs more or less than 1 (balance/stand/stand_density.c), and masses in points,
// are carried along, as sums of mass times function (balance/bend/posture.h).
//
// Weights of voxels differ a little from those of meshes. What the outside weighs beyond its voxels
// is handed to the carving as a body of its own, so that the balance is that of the meshes.
//
// Source: R. Prevost and others, "Make It Stand", SIGGRAPH 2013, section 4 for the loop; that it
// starts from new voxels in each round is the library's own.

#include "balance/stand/stand.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "mesh/mesh.h"
#include "support/rule/terms.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

// How near a bent vertex must be to its own, in voxels.
#define UNBEND_VX 1e-6

typedef struct carving {
    const sf_stand *stand;
    const double *bent;
    const sf_pose *poses;
    sf_mesh_view outside;
    sf_task *task;
    sf_lattice lattice;
    sf_grid *wall, *other; // other: the solid by parity, then what hangs, then what is hollow
    sf_body ballast;
    sf_rule rule;
    sfi_carved made;
} carving;

// --- Voxels --------------------------------------------------------------------------------------

static sf_status fill(const carving *c, sf_fill fill, sf_grid *grid)
{
    sf_voxelize_options options = sf_voxelize_options_default();
    options.fill = fill;
    return sf_grid_voxelize(grid, c->outside, &options, &c->stand->allocator, NULL, NULL);
}

// Solid where the winding number says so. Where parity says otherwise the shape lies over itself.
static sf_status make_voxels(carving *c)
{
    const sf_allocator *a = &c->stand->allocator;
    SF_TRY(sfi_stand_lattice(c->stand, c->outside, &c->lattice));
    SF_TRY(sf_grid_create(&c->lattice, a, &c->made.solid));
    SF_TRY(sf_grid_create(&c->lattice, a, &c->made.result));
    SF_TRY(sf_grid_create(&c->lattice, a, &c->wall));
    SF_TRY(sf_grid_create(&c->lattice, a, &c->other));
    SF_TRY(fill(c, SF_FILL_WINDING, c->made.solid));
    SF_TRY(fill(c, SF_FILL_PARITY, c->other));
    for (uint32_t k = 0; k < c->lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(c->other, k);
        SF_TRY(sf_slice_xor(slice, slice, sf_grid_slice(c->made.solid, k)));
        c->made.overlap_voxels += sf_slice_popcount(slice);
    }
    return SF_OK;
}

// --- Weights -------------------------------------------------------------------------------------

static sf_status unbend(const carving *c, const double *bent, size_t count, double *rest)
{
    memcpy(rest, bent, 3 * count * sizeof *rest);
    if (!sfi_stand_bends(c->stand)) {
        return SF_OK;
    }
    return sf_weights_unbend(c->stand->field, c->poses, bent, count,
                             UNBEND_VX * c->stand->options.pitch_mm, &c->stand->allocator, c->task,
                             rest, NULL, NULL);
}

static sf_status find_ballast(carving *c, double *scratch)
{
    const sf_stand *s = c->stand;
    for (size_t i = 0; i < s->options.ballast_count; i++) {
        sf_ballast b = s->options.ballast[i];
        SF_TRY(sfi_stand_carry(s, b.mass, b.at_mm, scratch, &c->made));
        if (sfi_stand_bends(s)) {
            SF_TRY(sf_weights_at(s->field, b.at_mm, scratch, NULL));
            sf_blend blend = {s->options.ballast[i].at_mm, scratch, 1, sf_weights_centers(s->field),
                              s->handle_count};
            SF_TRY(sf_blend_apply(blend, c->poses, NULL, b.at_mm));
        }
        c->ballast = sf_body_add(c->ballast, 1, sf_ballast_body(&b, 1));
    }
    return SF_OK;
}

// --- The cavity ----------------------------------------------------------------------------------

// What hangs in the carved shape and was carried in the solid, both on the solid's bed. What hangs
// in the solid itself may hang on: where the wall is thin some of it may even be carved away.
static sf_status count_hanging(carving *c)
{
    const sf_allocator *a = &c->stand->allocator;
    sf_terms terms = sf_terms_default();
    uint32_t bed = sfi_first_matter(c->made.solid);
    terms.rule = c->rule;
    terms.bed_layer = bed < c->lattice.nz ? bed : SF_BED_AUTO;
    SF_TRY(sf_grid_unsupported(c->made.solid, &terms, a, NULL, c->wall, NULL));
    SF_TRY(sf_grid_unsupported(c->made.result, &terms, a, NULL, c->other, NULL));
    for (uint32_t k = 0; k < c->lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(c->other, k);
        SF_TRY(sf_slice_subtract(slice, slice, sf_grid_slice(c->wall, k)));
        c->made.hanging_voxels += sf_slice_popcount(slice);
    }
    return SF_OK;
}

static sf_status carve(carving *c, sf_stance *const *stances, sf_carve_goal goal)
{
    const sf_stand *s = c->stand;
    const sf_allocator *a = &s->allocator;
    sf_terms terms = sf_terms_default();
    sf_carve_options options = sf_carve_options_default();
    sf_body mesh, voxels;
    SF_TRY(sf_grid_wall(c->made.solid, c->outside, s->options.wall_mm, a, c->task, c->wall));
    SF_TRY(sfi_stand_keep(s, c->poses, c->made.solid, c->task, c->wall));
    SF_TRY(sf_mesh_body(c->outside, 1, &mesh));
    SF_TRY(sf_grid_body(c->made.solid, NULL, NULL, &voxels));
    terms.rule = c->rule;
    options.mode = s->options.carve_mode;
    options.goal = goal;
    options.density = c->made.density;
    options.rest = sf_body_add(sf_body_add(mesh, -1, voxels), 1, c->ballast);
    options.stances = (const sf_stance *const *)stances;
    options.stance_count = s->stance_count;
    options.strut_width_vx = s->options.strut_width_vx;
    if (s->report.rounds == 0 && sfi_stand_has_best(s, c->poses)) {
        SF_TRY(sfi_stand_best(s, c->made.solid, c->wall, c->made.density, &options.rest, c->task,
                              &c->made.has_bound, &c->made.bound_rad));
    }
    return sf_grid_carve(c->made.solid, c->wall, &terms, &options, a, c->task, c->made.result,
                         NULL);
}

static sf_status keep_all(carving *c)
{
    for (uint32_t k = 0; k < c->lattice.nz; k++) {
        SF_TRY(sf_slice_copy(sf_grid_slice(c->made.result, k), sf_grid_slice(c->made.solid, k)));
    }
    return SF_OK;
}

// The surface of what is hollow, turned to look into it.
static sf_status make_cavity(carving *c)
{
    const sf_allocator *a = &c->stand->allocator;
    sf_mesh *surface = NULL;
    double *vertices;
    uint32_t *triangles;
    for (uint32_t k = 0; k < c->lattice.nz; k++) {
        SF_TRY(sf_slice_subtract(sf_grid_slice(c->other, k), sf_grid_slice(c->made.solid, k),
                                 sf_grid_slice(c->made.result, k)));
    }
    SF_TRY(sf_grid_surface(c->other, NULL, a, NULL, &surface));
    sf_mesh_view view = sf_mesh_get_view(surface);
    sf_status status = sfi_mesh_make(a, view.vertex_count, view.triangle_count, &c->made.cavity,
                                     &vertices, &triangles);
    if (status == SF_OK && view.triangle_count > 0) {
        memcpy(vertices, view.vertices, 3 * view.vertex_count * sizeof *vertices);
        for (size_t i = 0; i < 3 * view.triangle_count; i++) {
            triangles[i] = view.triangles[i - i % 3 + (3 - i % 3) % 3];
        }
    }
    sf_mesh_destroy(surface);
    return status;
}

// Where the cavity's vertices were before bending, and their weights there.
static sf_status follow_back(carving *c)
{
    const sf_stand *s = c->stand;
    sf_mesh_view view = sf_mesh_get_view(c->made.cavity);
    size_t numbers;
    if (!sfi_stand_bends(s) || view.triangle_count == 0) {
        return SF_OK;
    }
    c->made.point_count = view.vertex_count;
    c->made.rest = sfi_alloc_array(&s->allocator, view.vertex_count, 3 * sizeof(double));
    if (!sfi_size_mul(view.vertex_count, s->handle_count, &numbers)) {
        return SF_ERR_OVERFLOW;
    }
    c->made.weights = sfi_alloc_array(&s->allocator, numbers, sizeof(double));
    if (c->made.rest == NULL || c->made.weights == NULL) {
        return SF_ERR_MEMORY;
    }
    SF_TRY(unbend(c, view.vertices, view.vertex_count, c->made.rest));
    SF_TRY(sf_weights_sample(s->field, c->made.rest, view.vertex_count, c->task, c->made.weights));
    return sfi_incidence_make(view, &s->allocator, &c->made.incidence);
}

static sf_status weigh(carving *c)
{
    sf_body cavity = {0, {0, 0, 0}};
    SF_TRY(sf_mesh_body(c->outside, 1, &c->made.body));
    if (sf_mesh_get_view(c->made.cavity).triangle_count > 0) {
        SF_TRY(sf_mesh_body(sf_mesh_get_view(c->made.cavity), 1, &cavity));
    }
    c->made.body = sf_body_add(c->made.body, 1, cavity);
    c->made.body = sf_body_add(c->made.body, 1, c->ballast);
    SF_TRY(sfi_stand_weigh_more(c->made.result, c->made.density, &c->made.body));
    return c->made.body.mass > 0 ? SF_OK : SF_ERR_ARGUMENT;
}

static sf_status go(carving *c, sf_stance *const *stances, sf_carve_goal goal, double *scratch)
{
    const sf_stand_options *o = &c->stand->options;
    SF_TRY(make_voxels(c));
    SF_TRY(sf_rule_make(o->rule, o->angle_rad, &c->lattice, NULL, &c->rule, NULL));
    SF_TRY(sfi_stand_weigh(c->stand, c->poses, c->made.solid, c->task, &c->made.density,
                           &c->made.voxel_count));
    SF_TRY(find_ballast(c, scratch));
    SF_TRY(o->carve ? carve(c, stances, goal) : keep_all(c));
    SF_TRY(count_hanging(c));
    SF_TRY(make_cavity(c));
    SF_TRY(follow_back(c));
    SF_TRY(sfi_stand_carry_all(c->stand, c->poses, c->made.density, c->task, scratch, &c->made));
    return weigh(c);
}

void sfi_carved_free(const sf_stand *stand, sfi_carved *carved)
{
    const sf_allocator *a = &stand->allocator;
    sf_grid_destroy(carved->solid);
    sf_grid_destroy(carved->result);
    sfi_free_array(a, carved->density, carved->voxel_count, sizeof *carved->density);
    sf_mesh_destroy(carved->cavity);
    sfi_incidence_free(a, &carved->incidence);
    sfi_free_array(a, carved->rest, carved->point_count, 3 * sizeof(double));
    sfi_free_array(a, carved->weights, carved->point_count * stand->handle_count, sizeof(double));
    sfi_free_array(a, carved->loose_sums, 4 * stand->handle_count, sizeof(double));
    memset(carved, 0, sizeof *carved);
}

sf_status sfi_carved_make(const sf_stand *stand, const double *bent, const sf_pose *poses,
                          sf_stance *const *stances, sf_carve_goal goal, sf_task *task,
                          sfi_carved *carved)
{
    const sf_allocator *a = &stand->allocator;
    size_t handles = stand->handle_count, room = 5 * handles;
    carving c;
    double *scratch = NULL;
    memset(&c, 0, sizeof c);
    c.stand = stand;
    c.bent = bent;
    c.poses = poses;
    c.outside = sfi_stand_surface_view(&stand->surface, bent);
    c.task = task;
    sf_status status = SF_OK;
    if (sfi_stand_bends(stand)) {
        scratch = sfi_alloc_array(a, room, sizeof *scratch);
        c.made.loose_sums = sfi_alloc_array(a, 4 * handles, sizeof(double));
        status = scratch != NULL && c.made.loose_sums != NULL ? SF_OK : SF_ERR_MEMORY;
    }
    if (status == SF_OK) {
        if (c.made.loose_sums != NULL) {
            memset(c.made.loose_sums, 0, 4 * handles * sizeof(double));
        }
        status = go(&c, stances, goal, scratch);
    }
    sf_grid_destroy(c.wall);
    sf_grid_destroy(c.other);
    sfi_free_array(a, scratch, room, sizeof *scratch);
    if (status != SF_OK) {
        sfi_carved_free(stand, &c.made);
        return status;
    }
    *carved = c.made;
    return SF_OK;
}

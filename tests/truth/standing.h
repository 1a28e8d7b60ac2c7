// SPDX-License-Identifier: MIT
// Real models that are made to stand, and what is said of the meshes that come out of it, computed
// from the definitions and with nothing of the library.

#ifndef TESTS_TRUTH_STANDING_H
#define TESTS_TRUTH_STANDING_H

#include "data_file.h"
#include "unit/balance/judge.h"

#include <sf/stand.h>

#include <time.h>

#define STANDING_DEGREE 0.017453292519943295

// A model, turned so that `up` (0 x, 1 y, 2 z of the file) is +z, and looking outwards.
typedef struct standing_model {
    sf_mesh *mesh;
    double low[3], high[3], size;
} standing_model;

static inline sf_mesh *standing_turned_out(sf_mesh *mesh)
{
    sf_mesh_view view = sf_mesh_get_view(mesh);
    sf_mesh *turned = NULL;
    sf_mass mass;
    CHECK_EQ(sf_mesh_measure(view, &mass), SF_OK);
    if (mass.volume_mm3 > 0) {
        return mesh;
    }
    CHECK_EQ(sf_mesh_create(NULL, &turned), SF_OK);
    CHECK_EQ(sf_mesh_add_vertices(turned, view.vertices, view.vertex_count), SF_OK);
    for (size_t t = 0; t < view.triangle_count; t++) {
        const uint32_t *i = view.triangles + 3 * t, back[3] = {i[0], i[2], i[1]};
        CHECK_EQ(sf_mesh_add_triangles(turned, back, 1), SF_OK);
    }
    sf_mesh_destroy(mesh);
    return turned;
}

// x and y of the file that come to lie where, with `up` upwards: axis `a` becomes axis (a + 2 - up)
// modulo 3.
static inline int standing_axis(int up, int axis)
{
    return (axis + 2 - up) % 3;
}

static inline standing_model standing_read(const char *path, int up)
{
    standing_model m = {standing_turned_out(data_mesh(path)), {0, 0, 0}, {0, 0, 0}, 0};
    sf_transform turn = {{0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0}};
    for (int a = 0; a < 3; a++) {
        turn.matrix[3 * standing_axis(up, a) + a] = 1;
    }
    CHECK_EQ(sf_mesh_transform(m.mesh, &turn), SF_OK);
    CHECK_EQ(sf_mesh_bounds(sf_mesh_get_view(m.mesh), m.low, m.high), SF_OK);
    for (int d = 0; d < 3; d++) {
        m.size = fmax(m.size, m.high[d] - m.low[d]);
    }
    return m;
}

// Contacts within a hundredth of the height, three degrees.
static inline sf_stance_options standing_stance(const standing_model *m)
{
    sf_stance_options o = sf_stance_options_default();
    o.gamma_rad = 3 * STANDING_DEGREE;
    o.contact_mm = 0.01 * (m->high[2] - m->low[2]);
    return o;
}

static inline sf_stand_options standing_options(const standing_model *m, sf_carve_mode mode)
{
    sf_stand_options o = sf_stand_options_default();
    o.wall_mm = 0.01 * m->size;
    o.pitch_mm = m->size / 64;
    o.carve_mode = mode;
    return o;
}

// The voxels of a model, on cubes of this edge.
static inline sf_grid *standing_voxels(const standing_model *m, double pitch)
{
    sf_lattice l;
    sf_grid *solid = NULL;
    memset(&l, 0, sizeof l);
    for (int d = 0; d < 3; d++) {
        l.origin_mm[d] = (floor(m->low[d] / pitch) - 1) * pitch;
    }
    l.nx = (uint32_t)((m->high[0] - l.origin_mm[0]) / pitch) + 2;
    l.ny = (uint32_t)((m->high[1] - l.origin_mm[1]) / pitch) + 2;
    l.nz = (uint32_t)((m->high[2] - l.origin_mm[2]) / pitch) + 2;
    l.pitch_x_mm = l.pitch_y_mm = l.layer_mm = pitch;
    CHECK_EQ(sf_grid_create(&l, NULL, &solid), SF_OK);
    sf_voxelize_options o = sf_voxelize_options_default();
    o.fill = SF_FILL_WINDING;
    CHECK_EQ(sf_grid_voxelize(solid, sf_mesh_get_view(m->mesh), &o, NULL, NULL, NULL), SF_OK);
    return solid;
}

static inline void standing_mark(sf_grid *grid, const double p[3])
{
    sf_lattice l = sf_grid_lattice(grid);
    CHECK_EQ(sf_slice_set(sf_grid_slice(grid, (uint32_t)((p[2] - l.origin_mm[2]) / l.layer_mm)),
                          (uint32_t)((p[0] - l.origin_mm[0]) / l.pitch_x_mm),
                          (uint32_t)((p[1] - l.origin_mm[1]) / l.pitch_y_mm), 1),
             SF_OK);
}

static inline int standing_in_region(const sf_stance_options *o, const double p[3])
{
    int inside = 1;
    for (int d = 0; d < 3; d++) {
        inside = inside && p[d] >= o->region_low_mm[d] && p[d] <= o->region_high_mm[d];
    }
    return inside;
}

// Handles that are placed away from what it stands on or hangs from; how many.
static inline size_t standing_handles(const standing_model *m, const sf_stance_options *o,
                                      double pitch, uint32_t wanted, sf_handle handles[16])
{
    sf_grid *solid = standing_voxels(m, pitch), *base = NULL;
    sf_lattice l = sf_grid_lattice(solid);
    sf_mesh_view view = sf_mesh_get_view(m->mesh);
    sf_place_options place = sf_place_options_default();
    sf_fault fault = {SF_OK, 0, 0, ""};
    size_t count = 0;
    CHECK_EQ(sf_grid_create(&l, NULL, &base), SF_OK);
    double ground = INFINITY;
    for (size_t v = 0; v < view.vertex_count; v++) {
        const double *p = view.vertices + 3 * v;
        ground = standing_in_region(o, p) ? fmin(ground, p[2]) : ground;
    }
    for (size_t v = 0; v < view.vertex_count && o->kind == SF_STANCE_STAND; v++) {
        const double *p = view.vertices + 3 * v;
        if (standing_in_region(o, p) && p[2] <= ground + o->contact_mm) {
            standing_mark(base, p);
        }
    }
    if (o->kind == SF_STANCE_HANG) {
        standing_mark(base, o->point_mm);
    }
    place.count = wanted;
    place.base = base;
    CHECK_EQ(sf_handles_place(solid, &place, NULL, NULL, handles, 16, &count, &fault), SF_OK);
    sf_grid_destroy(base);
    sf_grid_destroy(solid);
    return count;
}

static inline sf_stand *standing_create(const standing_model *m, const sf_stance_options *stances,
                                        size_t stance_count, const sf_handle *handles,
                                        size_t handle_count, const sf_stand_options *o)
{
    sf_stand *stand = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_stand_create(sf_mesh_get_view(m->mesh), stances, stance_count, handles,
                                       handle_count, o, NULL, NULL, &stand, &fault);
    CHECK_EQ(status, SF_OK);
    if (status != SF_OK) {
        printf("# %s\n", fault.message);
    }
    return stand;
}

static inline double standing_seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

// All rounds; milliseconds of the processor for each.
static inline double standing_run(sf_stand *stand)
{
    double from = standing_seconds();
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    return 1e3 * (standing_seconds() - from) / sf_stand_describe(stand).rounds;
}

// --- From the definitions ------------------------------------------------------------------------

// The least tilt that makes it fall: over a fan of directions, the furthest vertex on the ground in
// that direction decides. What is on the ground lies as low as the lowest vertex of the region.
static inline double standing_margin(const sf_stand *stand, const sf_stance_options *o)
{
    sf_mesh_view outer = sf_stand_outer(stand);
    double com[3], ground = INFINITY, least = INFINITY;
    judge_com(outer, sf_stand_cavity(stand), com);
    for (size_t v = 0; v < outer.vertex_count; v++) {
        const double *p = outer.vertices + 3 * v;
        ground = standing_in_region(o, p) ? fmin(ground, p[2]) : ground;
    }
    for (int i = 0; i < 1440; i++) {
        double angle = i * 6.283185307179586 / 1440, furthest = -INFINITY;
        double x = cos(angle), y = sin(angle);
        for (size_t v = 0; v < outer.vertex_count; v++) {
            const double *p = outer.vertices + 3 * v;
            if (p[2] < ground + 1e-9 && standing_in_region(o, p)) {
                furthest = fmax(furthest, p[0] * x + p[1] * y);
            }
        }
        least = fmin(least, atan2(furthest - com[0] * x - com[1] * y, com[2] - ground));
    }
    return least;
}

#endif

// SPDX-License-Identifier: MIT
// The tip of the brush in hand.
//
// A mesh becomes voxels on the model's own pitch when the tip is made, so it is as fine as the
// model and as large as the radius says.

#include "tip.h"

#include <math.h>

// From mm to voxels of the model.
static void radius_of(const editor *e, double radius[3])
{
    sf_lattice l = sf_sculpt_options_of(e->model).lattice;
    radius[0] = e->brush.radius_mm / l.pitch_x_mm;
    radius[1] = e->brush.radius_mm / l.pitch_y_mm;
    radius[2] = e->brush.radius_mm / l.layer_mm;
}

// The mesh about the origin, its longest half side 1.
static sf_status bring_to_unit(sf_mesh *mesh)
{
    double low[3], high[3], half = 0;
    sf_status status = sf_mesh_bounds(sf_mesh_get_view(mesh), low, high);
    for (int i = 0; status == SF_OK && i < 3; i++) {
        half = fmax(half, 0.5 * (high[i] - low[i]));
    }
    if (status != SF_OK || !(half > 0)) {
        return SF_ERR_ARGUMENT;
    }
    sf_transform t = {{1 / half, 0, 0, 0, 1 / half, 0, 0, 0, 1 / half}, {0, 0, 0}};
    for (int i = 0; i < 3; i++) {
        t.shift_mm[i] = -0.5 * (low[i] + high[i]) / half;
    }
    return sf_mesh_transform(mesh, &t);
}

// The mesh as voxels of the model's pitch over the radius; the anchor is the one in the middle.
static sf_status make_mask(editor *e, sf_grid **mask, sf_dab *anchor)
{
    double r[3];
    radius_of(e, r);
    const int32_t half[3] = {(int32_t)ceil(r[0]), (int32_t)ceil(r[1]), (int32_t)ceil(r[2])};
    const sf_lattice l = {
        2 * (uint32_t)half[0] + 1,
        2 * (uint32_t)half[1] + 1,
        2 * (uint32_t)half[2] + 1,
        1 / r[0],
        1 / r[1],
        1 / r[2],
        NULL,
        {-(half[0] + 0.5) / r[0], -(half[1] + 0.5) / r[1], -(half[2] + 0.5) / r[2]}};
    const sf_dab middle = {half[0], half[1], half[2]};
    *anchor = middle;
    sf_status status = sf_grid_create(&l, NULL, mask);
    if (status == SF_OK) {
        status = sf_grid_voxelize(*mask, sf_mesh_get_view(e->tip_mesh), NULL, NULL, NULL, NULL);
    }
    return status;
}

static int make_of_mesh(editor *e)
{
    sf_grid *mask = NULL;
    sf_dab anchor;
    sf_status status = make_mask(e, &mask, &anchor);
    if (status == SF_OK) {
        status = sf_tip_create_mask(mask, anchor, NULL, &e->tip);
    }
    sf_grid_destroy(mask);
    return status == SF_OK;
}

int tip_make(editor *e)
{
    double radius[3];
    if (e->tip != NULL) {
        return 1;
    }
    if (e->brush.shape == TIP_MESH) {
        return e->tip_mesh != NULL && make_of_mesh(e);
    }
    radius_of(e, radius);
    return sf_tip_create((sf_tip_shape)e->brush.shape, radius, NULL, &e->tip) == SF_OK;
}

void tip_forget(editor *e)
{
    sf_tip_destroy(e->tip);
    e->tip = NULL;
}

int tip_record(editor *e, uint32_t *tip)
{
    double radius[3];
    sf_grid *mask = NULL;
    sf_dab anchor;
    if (e->brush.shape != TIP_MESH) {
        radius_of(e, radius);
        return sf_session_add_tip(e->session, (sf_tip_shape)e->brush.shape, radius, tip) == SF_OK;
    }
    sf_status status = make_mask(e, &mask, &anchor);
    if (status == SF_OK) {
        status = sf_session_add_mask(e->session, mask, anchor, tip);
    }
    sf_grid_destroy(mask);
    return status == SF_OK;
}

int tip_take_mesh(editor *e, sf_mesh *mesh)
{
    if (bring_to_unit(mesh) != SF_OK) {
        return 0;
    }
    tip_destroy(e);
    e->tip_mesh = mesh;
    e->brush.shape = TIP_MESH;
    return 1;
}

void tip_destroy(editor *e)
{
    tip_forget(e);
    sf_mesh_destroy(e->tip_mesh);
    e->tip_mesh = NULL;
}

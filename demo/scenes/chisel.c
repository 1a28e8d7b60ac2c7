// SPDX-License-Identifier: MIT
// A sculptor's hand.

#include "chisel.h"

#include <math.h>

void chisel_lift(chisel *c)
{
    if (c->status == SF_OK && c->count > 0) {
        c->status = sf_session_add_stroke(c->session, &c->brush, c->tip, c->dabs, c->count);
    }
    c->count = 0;
}

void chisel_take(chisel *c, sf_brush_kind kind, uint8_t material, sf_tip_shape shape, double rx_mm,
                 double ry_mm, double rz_mm)
{
    const double radius[3] = {rx_mm / c->pitch_mm, ry_mm / c->pitch_mm, rz_mm / c->pitch_mm};
    chisel_lift(c);
    c->brush.kind = kind;
    c->brush.material = material;
    if (c->status == SF_OK) {
        c->status = sf_session_add_tip(c->session, shape, radius, &c->tip);
    }
}

void chisel_take_ball(chisel *c, sf_brush_kind kind, uint8_t material, double r_mm)
{
    chisel_take(c, kind, material, SF_TIP_SPHERE, r_mm, r_mm, r_mm);
}

void chisel_mirror(chisel *c, int x, int y)
{
    chisel_lift(c);
    c->brush.mirror_x = x;
    c->brush.mirror_y = y;
}

// The voxel that holds a place.
static sf_dab voxel_of(const chisel *c, const double at[3])
{
    double middle = 0.5 * c->resolution;
    sf_dab dab = {(int32_t)floor(middle + at[0] / c->pitch_mm),
                  (int32_t)floor(middle + at[1] / c->pitch_mm),
                  (int32_t)floor(at[2] / c->pitch_mm)};
    return dab;
}

static void put(chisel *c, sf_dab from, sf_dab to)
{
    size_t count = 0;
    if (c->status == SF_OK) {
        c->status = sf_dab_line(from, to, c->dabs + c->count, CHISEL_DABS_MAX - c->count, &count);
        c->count += c->status == SF_OK ? count : 0;
    }
}

void chisel_at(chisel *c, double x, double y, double z)
{
    const double at[3] = {x, y, z};
    put(c, voxel_of(c, at), voxel_of(c, at));
}

void chisel_line(chisel *c, const double from[3], const double to[3])
{
    put(c, voxel_of(c, from), voxel_of(c, to));
}

// SPDX-License-Identifier: MIT
// A sculptor's hand: strokes of balls, boxes and cones in millimetres, into a session.
//
// Places are mm from the middle of the bed, z up from it. A hand that has failed once does nothing
// more, so that a scene is a list of strokes and asks at its end.

#ifndef DEMO_SCENES_CHISEL_H
#define DEMO_SCENES_CHISEL_H

#include <sf/session.h>

#define CHISEL_PI 3.14159265358979323846
#define CHISEL_DABS_MAX 8192

typedef struct chisel {
    sf_session *session;
    sf_status status;
    uint32_t resolution;
    double pitch_mm;
    sf_brush brush;
    uint32_t tip;
    sf_dab dabs[CHISEL_DABS_MAX];
    size_t count;
} chisel;

// Take a brush and a tip; what was collected before is a stroke of its own.
void chisel_take(chisel *c, sf_brush_kind kind, uint8_t material, sf_tip_shape shape, double rx_mm,
                 double ry_mm, double rz_mm);

// The same with a ball.
void chisel_take_ball(chisel *c, sf_brush_kind kind, uint8_t material, double r_mm);

// Mirror what follows across x = 0, y = 0.
void chisel_mirror(chisel *c, int x, int y);

// Put the tip on a place, or all along a line, a voxel apart; collected until the stroke ends.
void chisel_at(chisel *c, double x, double y, double z);
void chisel_line(chisel *c, const double from[3], const double to[3]);

// End the stroke.
void chisel_lift(chisel *c);

#endif

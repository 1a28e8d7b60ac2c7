// SPDX-License-Identifier: MIT
// Levers: what a mass counts for, depending on where it lies.
//
// A mass m at p counts m * (pull . p + base). All that carving asks of a shape is of this kind: its
// mass (base 1), and whether a half-space holds for its centre of mass c, for normal . c >= offset
// just when the lever with pull = normal, base = -offset sums up to 0 or more over its matter. So a
// body tells all of them, levers add up, and no ratio is ever needed.

#ifndef SF_BALANCE_LEVER_H
#define SF_BALANCE_LEVER_H

#include <sf/body.h>

typedef struct sfi_lever {
    double pull[3], base;
} sfi_lever;

// The lever of a half-space, divided by `unit`.
static inline sfi_lever sfi_lever_of(const sf_halfspace *h, double unit)
{
    sfi_lever l = {{h->normal[0] / unit, h->normal[1] / unit, h->normal[2] / unit},
                   -h->offset_mm / unit};
    return l;
}

// a + factor * b.
static inline sfi_lever sfi_lever_add(sfi_lever a, double factor, const sfi_lever *b)
{
    for (int i = 0; i < 3; i++) {
        a.pull[i] += factor * b->pull[i];
    }
    a.base += factor * b->base;
    return a;
}

// What a mass of 1 at p counts.
static inline double sfi_lever_at(const sfi_lever *l, double x, double y, double z)
{
    return l->pull[0] * x + l->pull[1] * y + l->pull[2] * z + l->base;
}

// What a body counts.
static inline double sfi_lever_body(const sfi_lever *l, const sf_body *b)
{
    return l->pull[0] * b->moment[0] + l->pull[1] * b->moment[1] + l->pull[2] * b->moment[2] +
           l->base * b->mass;
}

#endif

// SPDX-License-Identifier: MIT
// What a target makes of bytes: numbers, small ones most of the time, and odd ones now and then.
//
// Whoever draws never runs out: behind the last byte there are zeros, so that an input may be cut
// anywhere and still says something, which is how engines make their inputs smaller. A draw that is
// sane gives no odd numbers; tests that want calls to succeed ask for that.

#ifndef SF_FUZZ_DRAW_H
#define SF_FUZZ_DRAW_H

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>

typedef struct draw {
    const uint8_t *bytes;
    size_t size, at;
    int sane; // no odd numbers, no missing pointers
} draw;

static inline uint8_t draw_byte(draw *d)
{
    return d->at < d->size ? d->bytes[d->at++] : 0;
}

static inline uint32_t draw_word(draw *d)
{
    uint32_t word = 0;
    for (int i = 0; i < 4; i++) {
        word = word << 8 | draw_byte(d);
    }
    return word;
}

// A number below `bound`, of one byte.
static inline uint32_t draw_below(draw *d, uint32_t bound)
{
    return draw_byte(d) % bound;
}

// Whether something odd is to happen, one time in `rarity`; costs no byte where all is sane.
static inline int draw_odd(draw *d, uint32_t rarity)
{
    return !d->sane && draw_byte(d) % rarity == rarity - 1;
}

static inline uint64_t draw_count(draw *d)
{
    static const uint64_t odd[] = {0,
                                   64,
                                   255,
                                   65535,
                                   65536,
                                   INT32_MAX,
                                   (uint64_t)INT32_MAX + 1,
                                   UINT32_MAX,
                                   (uint64_t)UINT32_MAX + 1,
                                   (uint64_t)1 << 62,
                                   UINT64_MAX - 7,
                                   UINT64_MAX};
    if (draw_odd(d, 16)) {
        return odd[draw_below(d, sizeof odd / sizeof *odd)];
    }
    return draw_below(d, 8);
}

static inline double draw_double(draw *d)
{
    static const double odd[] = {0,     -0.0,   -1,     NAN,         INFINITY, -INFINITY,
                                 1e300, -1e300, 5e-324, DBL_MIN,     DBL_MAX,  -DBL_MAX,
                                 1e12,  1e100,  1e-100, 4294967296.0};
    static const double usual[] = {0.5, 1, 0.25, 2, 0.1, 3, 0.785, 1.5};
    if (draw_odd(d, 16)) {
        return odd[draw_below(d, sizeof odd / sizeof *odd)];
    }
    uint32_t byte = draw_byte(d);
    return byte < 128 ? usual[byte % 8] : (byte - 128) / 16.0;
}

// A place along an axis, in mm: within a box of a few.
static inline double draw_place(draw *d)
{
    return draw_odd(d, 24) ? draw_double(d) : draw_byte(d) / 32.0 - 1;
}

#endif

// SPDX-License-Identifier: MIT
// The downward cone of a voxel, for every rule: windows that hold what can carry it through empty
// space.

#ifndef SF_SUPPORT_CONE_H
#define SF_SUPPORT_CONE_H

#include <sf/grow.h>

#include "support/grow/fringe.h"

// The windows below one voxel: window t holds the offsets that t steps down can make. Begin with
// sfi_cone_begin(), then sfi_cone_deepen() for t = 1, 2, ...
typedef struct sfi_cone {
    sf_rule rule; // without bridges
    uint32_t width, height;
    uint32_t top;      // layer of the voxel
    uint32_t depth;    // of the last window
    uint32_t surplus;  // slack: of the last window
    sfi_fringe fringe; // disk and slack
} sfi_cone;

typedef struct sfi_window {
    const sfi_cone *cone;
    uint32_t depth;
    uint32_t reach_y;           // rows above and below, within the slice's height
    uint64_t axis, corner;      // closed form: farthest along an axis, and |dx| + |dy| at most
    const sfi_fringe_row *rows; // or by rows; else NULL
    const uint8_t *demands;
    uint32_t surplus;
} sfi_window;

// A row beyond the window.
#define SFI_WINDOW_NONE UINT32_MAX

// SF_ERR_MEMORY; then there is nothing to destroy. Destroying what was never created does nothing.
sf_status sfi_cone_create(const sf_rule *plain, uint32_t width, uint32_t height,
                          const sf_allocator *allocator, sfi_cone *cone);
void sfi_cone_destroy(sfi_cone *cone);

// Make the windows that all voxels share, down to `depth`, if there are such and they are kept by
// rows. Later that costs no more than here, but whoever asks first pays for it. SF_ERR_MEMORY,
// SF_ERR_OVERFLOW.
sf_status sfi_cone_prepare(sfi_cone *cone, uint32_t depth);

void sfi_cone_begin(sfi_cone *cone, uint32_t top);

// The next window, until the one after it. SF_ERR_MEMORY, SF_ERR_OVERFLOW.
sf_status sfi_cone_deepen(sfi_cone *cone, sfi_window *window);

// Farthest dx of a window at dy rows from the middle, which may lie beyond the slice; or
// SFI_WINDOW_NONE.
static inline uint32_t sfi_window_half_width(const sfi_window *window, uint32_t dy)
{
    if (dy > window->reach_y) {
        return SFI_WINDOW_NONE;
    }
    if (window->rows != NULL) {
        return window->rows[dy].reach[window->surplus] - 1u;
    }
    uint64_t slant = window->corner - dy;
    return (uint32_t)(slant < window->axis ? slant : window->axis);
}

// What matter at an offset of a window must have to spare, at least.
static inline uint32_t sfi_window_demand(const sfi_window *window, uint32_t dx, uint32_t dy)
{
    if (window->rows == NULL || dx < window->rows[dy].free) {
        return 0;
    }
    const sfi_fringe_row *row = &window->rows[dy];
    uint32_t demand = window->demands[row->first + (dx - row->free)];
    return demand > window->surplus ? demand - window->surplus : 0;
}

// The rows of a window around `from`, within a slice: y0 <= y < y1.
static inline void sfi_window_rows(const sfi_window *window, sf_voxel from, uint32_t height,
                                   uint32_t *y0, uint32_t *y1)
{
    *y0 = from.y > window->reach_y ? from.y - window->reach_y : 0;
    *y1 = window->reach_y < height - from.y ? from.y + window->reach_y + 1 : height;
}

// The part of row y, one of its rows, within a window around `from`.
static inline sf_rect sfi_window_row(const sfi_window *window, sf_voxel from, uint32_t width,
                                     uint32_t y)
{
    uint32_t half = sfi_window_half_width(window, y > from.y ? y - from.y : from.y - y);
    sf_rect part = {from.x > half ? from.x - half : 0, y,
                    half < width - from.x ? from.x + half + 1 : width, y + 1};
    return part;
}

// Write the voxels of a chain down from `from` to `to`, both left out, window->depth layers apart
// and within the window: each step lies in its layer's element, and under slack the chain stands on
// matter that has to spare what `to` is asked for.
void sfi_cone_chain(const sfi_window *window, sf_voxel from, sf_voxel to, sf_voxel *chain);

#endif

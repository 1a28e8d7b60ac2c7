// SPDX-License-Identifier: MIT
// Windows of a downward cone that are kept row by row: under slack with what each voxel of them
// asks for, and for disks, which ask for nothing.

#ifndef SF_SUPPORT_FRINGE_H
#define SF_SUPPORT_FRINGE_H

#include "support/rule/rule.h"

// Row dy of a window, from the middle on: dx < free needs no slack; then come those that do, whose
// demands are kept; dx >= reach is beyond the window.
typedef struct sfi_fringe_row {
    uint32_t first; // place of the row's first demand, among those of the window
    uint16_t free;
    uint16_t reach[2]; // by surplus
} sfi_fringe_row;

typedef struct sfi_fringe_window {
    size_t first_row, first_demand;
    uint32_t rows[2]; // by surplus: rows that reach beyond 0
} sfi_fringe_window;

typedef struct sfi_fringe {
    sf_rule rule; // disk or slack, no bridges
    uint32_t width, height;
    sf_allocator allocator;
    int is_lasting;     // steps are alike, so windows are those of every voxel
    sf_element element; // that of all steps where they are
    uint32_t most;      // the largest demand that is kept
    uint32_t top;       // the layer that windows are known for, where they are not lasting
    uint32_t depth;     // windows known, beside that of depth 0
    int is_whole;       // the last of them is all of the slice, and needs no slack
    sfi_fringe_window *windows;
    size_t window_capacity;
    sfi_fringe_row *rows;
    size_t row_count, row_capacity;
    uint8_t *demands;
    size_t demand_count, demand_capacity;
    int16_t *scratch;                          // a row
    uint8_t (*costs)[SFI_SLACK_REACH_MAX + 1]; // slack, by dy and dx
} sfi_fringe;

// SF_ERR_MEMORY; then there is nothing to destroy. Destroying what was never created (all zero)
// does nothing.
sf_status sfi_fringe_create(const sf_rule *plain, uint32_t width, uint32_t height,
                            const sf_allocator *allocator, sfi_fringe *fringe);
void sfi_fringe_destroy(sfi_fringe *fringe);

// From here on windows are those below a voxel of layer `top`.
void sfi_fringe_begin(sfi_fringe *fringe, uint32_t top);

// Make the windows down to `depth` <= top known. A failure leaves those that were. SF_ERR_MEMORY,
// SF_ERR_OVERFLOW.
sf_status sfi_fringe_deepen(sfi_fringe *fringe, uint32_t depth);

// What reaching over (dx, dy) costs, and what a step up from layer k gives; 0 for disks.
static inline uint32_t sfi_fringe_cost(const sfi_fringe *fringe, uint32_t dx, uint32_t dy)
{
    return fringe->costs != NULL ? fringe->costs[dy][dx] : 0;
}

uint32_t sfi_fringe_gain(const sfi_fringe *fringe, uint32_t k);

// The element of a step from layer k, which the rule serves.
sf_status sfi_fringe_element(const sfi_fringe *fringe, uint32_t k, sf_element *element);

#endif

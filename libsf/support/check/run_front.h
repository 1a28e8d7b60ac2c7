// SPDX-License-Identifier: MIT
// A layer as runs, and whether another one rests on it whole.

#ifndef SF_SUPPORT_RUN_FRONT_H
#define SF_SUPPORT_RUN_FRONT_H

#include <sf/rule.h>

// The runs of a layer in row order, and where each row begins among them (height + 1 places). Not
// valid: nothing is known of the layer here.
typedef struct sfi_run_front {
    sf_run *runs;
    uint32_t *rows;
    uint32_t capacity, count, height;
    int is_valid;
} sfi_run_front;

// Keep a layer's runs, if there is room for them.
void sfi_run_front_take(sfi_run_front *front, const sf_run *runs, size_t count);

// Whether every run lies within the front dilated by the element. May say no where that is so, of
// runs that are in many pieces over what is below; never yes where it is not. The front is valid.
int sfi_run_front_carries(const sfi_run_front *front, const sf_run *runs, size_t count,
                          const sf_element *element);

#endif

// SPDX-License-Identifier: MIT
// What the ways to carve are given, once all of it has been checked.

#ifndef SF_BALANCE_CARVING_H
#define SF_BALANCE_CARVING_H

#include <sf/carve.h>

#include "balance/stance/target.h"

typedef struct sfi_carving {
    const sf_grid *solid;
    const sf_grid *needed; // what must stay: the wall, and what the terms keep; within the solid
    sf_lattice lattice;
    const sf_carve_options *options;
    const sfi_base *bases;
    size_t base_count;
    sf_body body; // of the solid, with the options' rest
    sf_allocator allocator;
    sf_task *task;
} sfi_carving;

#endif

// SPDX-License-Identifier: MIT
// The operators of libsf, one call for all of them.

#include "operators.h"

#include <sf/grow.h>
#include <sf/preserve.h>
#include <sf/repair.h>

const char *operators_phase(sf_operation operation)
{
    switch (operation) {
    case SF_OPERATION_TRIM:
        return "trimming";
    case SF_OPERATION_GROW:
        return "growing";
    case SF_OPERATION_REPAIR:
        return "repairing";
    default:
        return "removing";
    }
}

int operators_may_refuse(const order *o)
{
    return o->operation == SF_OPERATION_GROW ||
           (o->operation != SF_OPERATION_PRESERVE && o->terms.keep != NULL);
}

static sf_status repair_grid(const order *o, sf_grid *grid, sf_grid *culprits, sf_task *task,
                             uint64_t *cost)
{
    sf_repair_options how = sf_repair_options_default();
    sf_repair_report done;
    how.terms = o->terms;
    how.min_feature_vx = o->min_feature_vx;
    sf_status status = sf_grid_repair(grid, &how, NULL, task, culprits, &done);
    if (status == SF_OK) {
        *cost = done.cost;
    }
    return status;
}

static sf_status preserve_grid(const order *o, sf_grid *grid, sf_task *task)
{
    sf_preserve_options how = sf_preserve_options_default();
    how.mode = o->mode;
    return sf_grid_preserve(grid, o->brush, &o->terms, &how, NULL, task, NULL);
}

sf_status operators_apply(const order *o, sf_grid *grid, sf_grid *culprits, sf_task *task,
                          uint64_t *cost)
{
    *cost = UINT64_MAX;
    switch (o->operation) {
    case SF_OPERATION_TRIM:
        return sf_grid_trim_on(grid, &o->terms, NULL, task, culprits, NULL);
    case SF_OPERATION_GROW:
        return sf_grid_grow(grid, &o->terms, NULL, task, culprits, NULL);
    case SF_OPERATION_REPAIR:
        return repair_grid(o, grid, culprits, task, cost);
    case SF_OPERATION_PRESERVE:
        return preserve_grid(o, grid, task);
    default:
        return SF_ERR_ARGUMENT;
    }
}

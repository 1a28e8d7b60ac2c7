// SPDX-License-Identifier: MIT
// Connected components of a slice, by its runs.
//
// Two runs touch when their rows are neighbours and their intervals overlap (four neighbours) or
// overlap once one of them is widened by a voxel (eight neighbours). A sweep over two rows at a
// time finds every such pair, because both rows are sorted; sets of runs are joined in a forest
// that takes no memory (voxel/run_forest.h). Following runs point downwards, and one pass in order
// turns parents into numbers.

#include "base/status.h"
#include "voxel/rect.h"
#include "voxel/run_forest.h"

// Within the largest slice and not empty: so that sums of ends never wrap.
static int is_run(const sf_run *run)
{
    return run->x0 < run->x1 && run->x1 <= SF_EXTENT_MAX && run->y < SF_EXTENT_MAX;
}

// Row order, left to right, with at least one empty voxel between neighbours of a row.
static int in_order(const sf_run *runs, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (!is_run(&runs[i])) {
            return 0;
        }
        if (i > 0 && (runs[i].y < runs[i - 1].y ||
                      (runs[i].y == runs[i - 1].y && runs[i].x0 <= runs[i - 1].x1))) {
            return 0;
        }
    }
    return 1;
}

// Join runs of one row (first..end) with those of the row below it (from..first).
static void join_rows(sf_run *runs, size_t from, size_t first, size_t end, uint32_t slack)
{
    size_t below = from;
    for (size_t i = first; i < end; i++) {
        while (below < first && runs[below].x1 + slack <= runs[i].x0) {
            below++;
        }
        for (size_t j = below; j < first && runs[j].x0 < runs[i].x1 + slack; j++) {
            sfi_run_join(runs, (uint32_t)j, (uint32_t)i);
        }
    }
}

static size_t row_end(const sf_run *runs, size_t count, size_t first)
{
    size_t end = first;
    while (end < count && runs[end].y == runs[first].y) {
        end++;
    }
    return end;
}

sf_status sf_runs_label(sf_run *runs, size_t count, sf_connectivity connectivity,
                        uint32_t *component_count)
{
    if ((runs == NULL && count > 0) || component_count == NULL ||
        (connectivity != SF_CONNECT_EDGES && connectivity != SF_CONNECT_CORNERS) ||
        !in_order(runs, count)) {
        return SF_ERR_ARGUMENT;
    }
    if (count > UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    for (size_t i = 0; i < count; i++) {
        runs[i].label = (uint32_t)i;
    }
    for (size_t from = 0, first = 0, end; first < count; from = first, first = end) {
        end = row_end(runs, count, first);
        if (first > 0 && runs[from].y + 1 == runs[first].y) {
            join_rows(runs, from, first, end, connectivity == SF_CONNECT_CORNERS);
        }
    }
    uint32_t next = 0;
    for (size_t i = 0; i < count; i++) {
        runs[i].label = runs[i].label == i ? next++ : runs[runs[i].label].label;
    }
    *component_count = next;
    return SF_OK;
}

sf_status sf_runs_measure(const sf_run *runs, size_t count, sf_component *components,
                          size_t capacity)
{
    if ((runs == NULL && count > 0) || (components == NULL && capacity > 0)) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < count; i++) {
        if (runs[i].label >= capacity) {
            return SF_ERR_CAPACITY;
        }
        if (!is_run(&runs[i])) {
            return SF_ERR_ARGUMENT;
        }
    }
    for (size_t i = 0; i < capacity; i++) {
        sf_component none = {0, {0, 0, 0, 0}};
        components[i] = none;
    }
    for (size_t i = 0; i < count; i++) {
        sf_component *c = &components[runs[i].label];
        sf_rect run = {runs[i].x0, runs[i].y, runs[i].x1, runs[i].y + 1};
        c->area += runs[i].x1 - runs[i].x0;
        c->bounds = sfi_rect_union(c->bounds, run);
    }
    return SF_OK;
}

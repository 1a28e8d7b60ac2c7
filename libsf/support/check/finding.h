// SPDX-License-Identifier: MIT
// What the checker asks of findings: name the unsupported regions of a layer, and say which finding
// each lost voxel is due to.

#ifndef SF_SUPPORT_FINDING_H
#define SF_SUPPORT_FINDING_H

#include <sf/support.h>

// Label of lost matter that no finding in the caller's array answers for. Larger than every index,
// so that the lowest index wins without asking.
#define SFI_NOBODY UINT32_MAX

// Findings and runs are counted in 31 bits: the top bit of a run's label is taken while its region
// is not closed yet.
#define SFI_FINDING_MAX 0x7ffffffeu

// Lost matter of one layer as runs; `label` is the finding that it is due to. Two stretches, each
// in row order: first what was carried, but by lost matter only, then what nothing carried.
typedef struct sfi_lost {
    sf_run *runs;
    uint32_t carried_count;
    uint32_t count;
} sfi_lost;

// One unsupported region while its rows go by: a node of a union-find forest. Only those that the
// row above the current one touches are kept, at most (width + 1) / 2.
typedef struct sfi_region {
    uint32_t parent;         // a root is its own
    uint32_t x0, y0, x1, y1; // y1 is the row after its last
    uint32_t cause;          // lowest finding that lost matter beside it is due to, or SFI_NOBODY
    uint32_t first_run;      // its root among the runs kept, or SFI_NOBODY
    uint8_t touches_carried, touches_kept, is_closed;
    uint64_t area;
} sfi_region;

// A run of the row above, or of the current one, and its region.
typedef struct sfi_region_run {
    uint32_t x0, x1, region;
} sfi_region_run;

// The state of the findings; all its arrays lie in the checker's memory but the findings.
typedef struct sfi_finder {
    uint32_t width, height;
    uint32_t finding_capacity, finding_count, run_capacity;
    sf_finding *findings;
    sfi_lost below, here;
    uint64_t *bits;      // one row
    uint32_t *owner;     // one finding a column; NULL when no runs are kept
    sfi_region *regions; // the open ones
    uint32_t *moved;     // where each went when the closed ones were dropped
    uint32_t region_count;
    sfi_region_run *above, *current;
    uint32_t above_count;
    uint64_t island_count, overhang_count, findings_dropped, runs_dropped, unlinked_voxels;
} sfi_finder;

// A layer of which the trim loses something. carried: what the layer below carries of it; kept:
// what trimming leaves. All of one size, with zero padding; kept lies in carried, carried in solid.
typedef struct sfi_layer {
    uint32_t k;
    sf_slice solid, carried, kept;
    const sf_element *element; // the step from the layer below
} sfi_layer;

// lost.c: owner[x] becomes the lowest label of the runs that the element lets reach voxel (x, y).
// *cursor, 0 at first, moves on with y, which must not fall from call to call.
void sfi_lost_gather(const sf_run *runs, uint32_t count, uint32_t *cursor, uint32_t y,
                     const sf_element *element, uint32_t width, uint32_t *owner);

// lost.c: keep a run of lost matter of this layer; returns its index, or SFI_NOBODY when full.
uint32_t sfi_lost_keep(sfi_finder *finder, uint32_t x0, uint32_t x1, uint32_t y, uint32_t label);

// lost.c: hand all that was carried, but by lost matter only, to the findings it is due to.
void sfi_lost_follow(sfi_finder *finder, const sfi_layer *layer);

// finding.c: name the regions of a layer that nothing carries. After sfi_lost_follow().
void sfi_finder_name(sfi_finder *finder, const sfi_layer *layer);

// finding.c: the next layer's turn; what was kept of this one is below it.
void sfi_finder_advance(sfi_finder *finder);

// check.c: width and height of the slices that a checker takes.
void sfi_checker_extent(const sf_checker *checker, uint32_t *width, uint32_t *height);

#endif

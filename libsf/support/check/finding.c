// SPDX-License-Identifier: MIT
// Findings: the unsupported regions of a layer, each named once, in one pass over its rows.
//
// A region is an 8-connected component of U = S_{k+1} \ dilate(S_k). It is an island when nothing
// carried lies beside it, for then it is a whole component of S_{k+1}; else it is an overhang.
//
// Regions are found by union-find over runs, row by row. A region stays open while the row above
// has a run of it, and what is known of it (area, box, what lies beside it) sits in its root. Open
// regions have runs in the row above that are a column apart from each other, and a region is made
// only for a run a column apart from all of these: so (width + 1) / 2 regions always suffice, and
// the counts are exact whatever the shape, in memory that knows the width only.
//
// Findings are numbered as their regions close: by layer, then by last row, then from left to right
// in that row. That order needs no look ahead and no sorting, and a shorter array holds a prefix.
//
// Runs that are kept for the next layer cannot wait for their region to close, so they form a
// forest of their own: the label of an open run is OPEN and the index of an earlier run of its
// region, that of the root is replaced by the finding as the region closes, and one pass in order
// of index then resolves all others, because parents come first.
//
// An overhang follows an earlier finding when all that it touches is lost: it grows from matter
// that hangs in the air already. When it touches kept matter, it would be there anyway.
//
// Source of the scheme: A. Rosenfeld, J. L. Pfaltz, "Sequential Operations in Digital Picture
// Processing", J. ACM 13(4), 1966; runs in place of pixels.

#include "support/check/finding.h"
#include "support/check/row.h"
#include "voxel/slice.h"

#define OPEN 0x80000000u

static uint32_t find(sfi_region *regions, uint32_t i)
{
    while (regions[i].parent != i) {
        regions[i].parent = regions[regions[i].parent].parent;
        i = regions[i].parent;
    }
    return i;
}

static uint32_t lower(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

static uint32_t upper(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

// The kept runs of two regions become one tree; returns its root.
static uint32_t unite_runs(sf_run *runs, uint32_t a, uint32_t b)
{
    uint32_t root = lower(a, b), other = upper(a, b);
    if (other != SFI_NOBODY && other != root) {
        runs[other].label = OPEN | root;
    }
    return root;
}

// Two roots become one; returns it.
static uint32_t unite(sfi_finder *finder, uint32_t i, uint32_t j)
{
    if (i == j) {
        return i;
    }
    sfi_region *into = &finder->regions[lower(i, j)], *from = &finder->regions[upper(i, j)];
    from->parent = into->parent;
    into->x0 = lower(into->x0, from->x0);
    into->y0 = lower(into->y0, from->y0);
    into->x1 = upper(into->x1, from->x1);
    into->y1 = upper(into->y1, from->y1);
    into->cause = lower(into->cause, from->cause);
    into->first_run = unite_runs(finder->here.runs, into->first_run, from->first_run);
    into->touches_carried |= from->touches_carried;
    into->touches_kept |= from->touches_kept;
    into->area += from->area;
    return into->parent;
}

// The region of a run: that of all runs of the row above that touch it, or a new one. *a is the
// first run above that may touch this or a later one.
static uint32_t region_of(sfi_finder *finder, uint32_t x0, uint32_t x1, uint32_t y, uint32_t *a)
{
    const sfi_region_run *above = finder->above;
    while (*a < finder->above_count && above[*a].x1 < x0) {
        ++*a;
    }
    uint32_t region = SFI_NOBODY;
    for (uint32_t b = *a; b < finder->above_count && above[b].x0 <= x1; b++) {
        uint32_t root = find(finder->regions, above[b].region);
        region = region == SFI_NOBODY ? root : unite(finder, region, root);
    }
    if (region == SFI_NOBODY) {
        region = finder->region_count++;
        sfi_region fresh = {region, x0, y, x1, y + 1, SFI_NOBODY, SFI_NOBODY, 0, 0, 0, 0};
        finder->regions[region] = fresh;
    }
    return region;
}

// Whether a slice has a voxel beside a run of row y, corners included.
static uint8_t has_beside(sf_slice slice, uint32_t x0, uint32_t x1, uint32_t y)
{
    uint32_t from = x0 > 0 ? x0 - 1 : 0, first = y > 0 ? y - 1 : 0;
    for (uint32_t row = first; row <= y + 1 && row < slice.height; row++) {
        if (sfi_row_any(sfi_slice_row(slice, row), slice.width, from, x1 + 1)) {
            return 1;
        }
    }
    return 0;
}

// Add a run of row y to its region.
static void measure(sfi_finder *finder, const sfi_layer *layer, sfi_region_run run, uint32_t y)
{
    sfi_region *region = &finder->regions[run.region];
    region->x0 = lower(region->x0, run.x0);
    region->x1 = upper(region->x1, run.x1);
    region->y1 = y + 1;
    region->area += run.x1 - run.x0;
    if (has_beside(layer->carried, run.x0, run.x1, y)) {
        region->touches_carried = 1;
        region->touches_kept |= has_beside(layer->kept, run.x0, run.x1, y);
        for (uint32_t x = run.x0; finder->owner != NULL && x < run.x1; x++) {
            region->cause = lower(region->cause, finder->owner[x]);
        }
    }
    // Once the array is full no region of this layer that opens now can have a place in it.
    if (finder->finding_count == finder->finding_capacity) {
        return;
    }
    uint32_t kept = sfi_lost_keep(finder, run.x0, run.x1, y, OPEN | finder->here.count);
    if (kept != SFI_NOBODY) {
        region->first_run = unite_runs(finder->here.runs, region->first_run, kept);
    }
}

// Give each column the lowest finding that lost matter beside it in this layer is due to.
static void look_beside(sfi_finder *finder, uint32_t y, uint32_t *cursor)
{
    if (finder->owner == NULL) {
        return;
    }
    for (uint32_t x = 0; x < finder->width; x++) {
        finder->owner[x] = SFI_NOBODY;
    }
    sf_element box = {1, {1, 1}};
    sfi_lost_gather(finder->here.runs, finder->here.carried_count, cursor, y, &box, finder->width,
                    finder->owner);
}

// Take in the runs of row y, which lie in finder->bits; returns their number.
static uint32_t add_row(sfi_finder *finder, const sfi_layer *layer, uint32_t y)
{
    uint32_t x0, x1 = 0, a = 0, count = 0;
    while (sfi_row_next_run(finder->bits, finder->width, &x0, &x1)) {
        sfi_region_run run = {x0, x1, region_of(finder, x0, x1, y, &a)};
        measure(finder, layer, run, y);
        finder->current[count++] = run;
    }
    return count;
}

static void close_region(sfi_finder *finder, uint32_t k, sfi_region *region)
{
    int is_island = !region->touches_carried;
    int follows = region->touches_carried && !region->touches_kept;
    uint32_t label = SFI_NOBODY;
    region->is_closed = 1;
    *(is_island ? &finder->island_count : &finder->overhang_count) += 1;
    if (finder->finding_count < finder->finding_capacity) {
        sf_finding finding = {is_island ? SF_FINDING_ISLAND : SF_FINDING_OVERHANG,
                              k,
                              follows ? region->cause : SF_FINDING_ROOT,
                              region->area,
                              region->area,
                              {region->x0, region->y0, k, region->x1, region->y1, k + 1}};
        label = finder->finding_count++;
        finder->findings[label] = finding;
    } else {
        finder->findings_dropped++;
        finder->unlinked_voxels += region->area;
    }
    if (region->first_run != SFI_NOBODY) {
        finder->here.runs[region->first_run].label = label;
    }
}

// Close the regions of the row above that row y does not go on with, and forget them.
static void close_regions(sfi_finder *finder, uint32_t k, uint32_t y, uint32_t current_count)
{
    for (uint32_t i = 0; i < finder->above_count; i++) {
        sfi_region *region = &finder->regions[find(finder->regions, finder->above[i].region)];
        if (region->y1 <= y && !region->is_closed) {
            close_region(finder, k, region);
        }
    }
    for (uint32_t i = 0; i < current_count; i++) {
        finder->current[i].region = find(finder->regions, finder->current[i].region);
    }
    uint32_t count = 0;
    for (uint32_t i = 0; i < finder->region_count; i++) {
        if (finder->regions[i].parent == i && !finder->regions[i].is_closed) {
            finder->moved[i] = count;
            finder->regions[count] = finder->regions[i];
            finder->regions[count].parent = count;
            count++;
        }
    }
    finder->region_count = count;
    for (uint32_t i = 0; i < current_count; i++) {
        finder->current[i].region = finder->moved[finder->current[i].region];
    }
}

void sfi_finder_name(sfi_finder *finder, const sfi_layer *layer)
{
    uint32_t cursor = 0, first = finder->here.count;
    // One row past the last closes what is open.
    for (uint32_t y = 0; y <= finder->height; y++) {
        int any = y < finder->height &&
                  sfi_row_without(finder->bits, sfi_slice_row(layer->solid, y),
                                  sfi_slice_row(layer->carried, y), sfi_row_words(finder->width));
        if (!any && finder->above_count == 0) {
            continue;
        }
        uint32_t count = 0;
        if (any) {
            look_beside(finder, y, &cursor);
            count = add_row(finder, layer, y);
        }
        close_regions(finder, layer->k, y, count);
        sfi_region_run *swap = finder->above;
        finder->above = finder->current;
        finder->current = swap;
        finder->above_count = count;
    }
    for (uint32_t i = first; i < finder->here.count; i++) {
        uint32_t label = finder->here.runs[i].label;
        if (label != SFI_NOBODY && (label & OPEN) != 0) {
            finder->here.runs[i].label = finder->here.runs[label & ~OPEN].label;
        }
    }
}

void sfi_finder_advance(sfi_finder *finder)
{
    sfi_lost swap = finder->below;
    finder->below = finder->here;
    finder->here = swap;
    finder->here.carried_count = 0;
    finder->here.count = 0;
}

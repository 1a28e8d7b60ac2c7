// SPDX-License-Identifier: MIT
// Lost matter: which finding is to blame for each voxel that trimming takes.
//
// Let L_k = S_k \ T_k be what trimming takes from layer k. A voxel of L_k that nothing below
// carries belongs to the finding that names its region (finding.c). Any other voxel of L_k is
// carried by S_{k-1} and not by T_{k-1}, so all that carries it is lost, and already belongs to
// findings: it is handed to the first of them. By induction every lost voxel belongs to exactly one
// finding, and the volumes sum up to what trimming takes.
//
// "The first" makes a short array of findings a prefix of a long one, in every field: those that do
// not fit have higher indices and never take a voxel from one that does.
//
// The lost matter of the layer below is kept as labelled runs, the only memory that grows with the
// shape and not with the slice; its capacity is the caller's to choose. For a row, the labels of
// the runs within reach are painted into one number a column, the lowest wins, and the row's lost
// runs are cut where that number changes. That costs the rule's rows times the lost voxels, and
// nothing where nothing is lost.
//
// Freestanding; no memory but the checker's.

#include "support/check/finding.h"
#include "support/check/row.h"
#include "voxel/slice.h"

void sfi_lost_gather(const sf_run *runs, uint32_t count, uint32_t *cursor, uint32_t y,
                     const sf_element *element, uint32_t width, uint32_t *owner)
{
    uint32_t reach = element->reach_y;
    while (*cursor < count && runs[*cursor].y + reach < y) {
        ++*cursor;
    }
    for (uint32_t i = *cursor; i < count && runs[i].y <= y + reach; i++) {
        uint32_t dy = y > runs[i].y ? y - runs[i].y : runs[i].y - y;
        uint32_t w = element->half_width[dy], label = runs[i].label;
        uint32_t x0 = runs[i].x0 > w ? runs[i].x0 - w : 0;
        uint32_t x1 = width - runs[i].x1 > w ? runs[i].x1 + w : width;
        for (uint32_t x = x0; x < x1; x++) {
            owner[x] = label < owner[x] ? label : owner[x];
        }
    }
}

uint32_t sfi_lost_keep(sfi_finder *finder, uint32_t x0, uint32_t x1, uint32_t y, uint32_t label)
{
    sfi_lost *here = &finder->here;
    if (here->count == finder->run_capacity) {
        finder->runs_dropped++;
        return SFI_NOBODY;
    }
    sf_run run = {x0, x1, y, label};
    here->runs[here->count] = run;
    return here->count++;
}

static void widen_box(sf_box *box, uint32_t x0, uint32_t x1, uint32_t y, uint32_t k)
{
    box->x0 = x0 < box->x0 ? x0 : box->x0;
    box->x1 = x1 > box->x1 ? x1 : box->x1;
    box->y0 = y < box->y0 ? y : box->y0;
    box->y1 = y + 1 > box->y1 ? y + 1 : box->y1;
    box->z1 = k + 1;
}

// Voxels x0 <= x < x1 of row y are lost because of the finding `label`.
static void blame(sfi_finder *finder, uint32_t k, uint32_t x0, uint32_t x1, uint32_t y,
                  uint32_t label)
{
    if (label == SFI_NOBODY) {
        finder->unlinked_voxels += x1 - x0;
        return;
    }
    sf_finding *finding = &finder->findings[label];
    finding->volume += x1 - x0;
    widen_box(&finding->box, x0, x1, y, k);
    (void)sfi_lost_keep(finder, x0, x1, y, label);
}

// Cut one lost run where its owner changes.
static void blame_run(sfi_finder *finder, uint32_t k, uint32_t x0, uint32_t x1, uint32_t y)
{
    const uint32_t *owner = finder->owner;
    while (x0 < x1) {
        uint32_t label = owner != NULL ? owner[x0] : SFI_NOBODY, end = owner != NULL ? x0 + 1 : x1;
        while (end < x1 && owner[end] == label) {
            end++;
        }
        blame(finder, k, x0, end, y, label);
        x0 = end;
    }
}

void sfi_lost_follow(sfi_finder *finder, const sfi_layer *layer)
{
    const sfi_lost *below = &finder->below;
    const sf_run *hanging = below->runs + below->carried_count;
    uint32_t cursors[2] = {0, 0}, width = finder->width;
    for (uint32_t y = 0; y < finder->height; y++) {
        const uint64_t *carried = sfi_slice_row(layer->carried, y);
        if (!sfi_row_without(finder->bits, carried, sfi_slice_row(layer->kept, y),
                             sfi_row_words(width))) {
            continue;
        }
        for (uint32_t x = 0; finder->owner != NULL && x < width; x++) {
            finder->owner[x] = SFI_NOBODY;
        }
        if (finder->owner != NULL) {
            sfi_lost_gather(below->runs, below->carried_count, &cursors[0], y, layer->element,
                            width, finder->owner);
            sfi_lost_gather(hanging, below->count - below->carried_count, &cursors[1], y,
                            layer->element, width, finder->owner);
        }
        uint32_t x0, x1 = 0;
        while (sfi_row_next_run(finder->bits, width, &x0, &x1)) {
            blame_run(finder, layer->k, x0, x1, y);
        }
    }
    finder->here.carried_count = finder->here.count;
}

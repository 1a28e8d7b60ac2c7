// SPDX-License-Identifier: MIT
// Where a void could be drained, the best places first.
//
// A shaft begins where its disk fits into the void, and where it fits no more one layer down: the
// voxels of the void's slice eroded by the disk, but for those from which the next disk of the
// shaft lies in the void as well. What a place costs is told by the middle of its shaft alone: how
// much solid it goes through, times how far from the centre of mass, across up, that lies. A
// hundredth of the lattice's diagonal is added to that distance, so that right below the centre of
// mass, where nothing changes the balance, the short way is still the better one.

#include "balance/carve/outlet.h"

#include "base/bits.h"
#include "base/memory.h"
#include "base/status.h"
#include "voxel/slice.h"

#include <float.h>
#include <math.h>

// The largest distance from the centre of mass, across the ups.
static double lever_of(const sfi_levers *levers, const double at[3])
{
    double largest = 0;
    for (size_t i = 0; i < levers->count; i++) {
        const double *up = levers->ups[i];
        double d[3], along = 0, squared = 0;
        for (int j = 0; j < 3; j++) {
            d[j] = at[j] - levers->com[j];
            along += d[j] * up[j];
        }
        for (int j = 0; j < 3; j++) {
            squared += (d[j] - along * up[j]) * (d[j] - along * up[j]);
        }
        largest = sqrt(squared) > largest ? sqrt(squared) : largest;
    }
    return levers->count > 0 ? largest + 0.01 * levers->diagonal : 1;
}

static double cost_of(const sfi_ground_plan *plan, const sfi_levers *levers, sfi_drill at)
{
    const sf_lattice *l = &plan->lattice;
    double length = 0, moment[3] = {0, 0, 0};
    do {
        sfi_drill_step(plan, &at);
        if (at.layer >= 0 && at.x >= 0 && at.y >= 0 && at.x < l->nx && at.y < l->ny &&
            sf_slice_get(sf_grid_slice(plan->made, (uint32_t)at.layer), (uint32_t)at.x,
                         (uint32_t)at.y)) {
            double bottom = plan->levels[at.layer], height = plan->levels[at.layer + 1] - bottom;
            length += height;
            moment[0] += height * (l->origin_mm[0] + ((double)at.x + 0.5) * l->pitch_x_mm);
            moment[1] += height * (l->origin_mm[1] + ((double)at.y + 0.5) * l->pitch_y_mm);
            moment[2] += height * (bottom + 0.5 * height);
            continue;
        }
    } while (!sfi_drill_is_open(plan, at.x, at.y, at.layer));
    for (int j = 0; j < 3; j++) {
        moment[j] /= length > 0 ? length : 1;
    }
    return length * lever_of(levers, moment);
}

// The void's voxels of a layer where the disk fits.
static sf_status fit(const sfi_ground_plan *plan, const sfi_closed_void *hollow, uint32_t k,
                     sf_slice here, sf_slice fits)
{
    const sfi_pieces *p = plan->pieces;
    sfi_slice_clear(here);
    for (size_t i = p->first[k]; i < p->first[k + 1]; i++) {
        const sf_run *run = &p->runs[i];
        if (run->label == hollow->piece) {
            sf_rect rect = {run->x0, run->y, run->x1, run->y + 1};
            SF_TRY(sf_slice_fill(here, rect, 1));
        }
    }
    return sf_slice_erode(fits, here, &plan->disk, SF_BORDER_EMPTY);
}

static sf_status add(const sfi_ground_plan *plan, sfi_drill begin, const sfi_levers *levers,
                     const sf_allocator *allocator, sfi_outlets *outlets)
{
    if (!sfi_grow_array(allocator, (void **)&outlets->list, &outlets->capacity, outlets->count + 1,
                        sizeof *outlets->list)) {
        return SF_ERR_MEMORY;
    }
    sfi_outlet made = {cost_of(plan, levers, begin),
                       (uint32_t)begin.layer,
                       (uint16_t)begin.x,
                       (uint16_t)begin.y,
                       (uint8_t)begin.direction,
                       0};
    outlets->list[outlets->count++] = made;
    return SF_OK;
}

// Places of one layer, for the directions from `first` to `end`; `below` is where the disk fits in
// the layer below.
static sf_status find_layer(const sfi_ground_plan *plan, uint32_t k, sf_slice fits, sf_slice below,
                            unsigned first, unsigned end, const sfi_levers *levers,
                            const sf_allocator *allocator, sfi_outlets *outlets)
{
    for (uint32_t y = 0; y < fits.height; y++) {
        for (size_t i = 0; i < sfi_row_words(fits.width); i++) {
            for (uint64_t word = sfi_slice_row(fits, y)[i]; word != 0; word &= word - 1) {
                uint32_t x = (uint32_t)(64 * i) + sfi_lowest_bit(word);
                for (unsigned d = first; d < end; d++) {
                    sfi_drill begin = sfi_drill_begin(x, y, k, d), next = begin;
                    sfi_drill_step(plan, &next);
                    int goes_on = next.x >= 0 && next.y >= 0 &&
                                  sf_slice_get(below, (uint32_t)next.x, (uint32_t)next.y);
                    if (!goes_on) {
                        SF_TRY(add(plan, begin, levers, allocator, outlets));
                    }
                }
            }
        }
    }
    return SF_OK;
}

sf_status sfi_outlets_find(const sfi_ground_plan *plan, const sfi_closed_void *hollow, int aslant,
                           const sfi_levers *levers, const sf_slice slices[3],
                           const sf_allocator *allocator, sfi_outlets *outlets)
{
    sf_slice fits = slices[0], below = slices[1];
    unsigned first = aslant ? 1 : 0, end = aslant ? SFI_DRILL_DIRECTIONS : 1;
    outlets->count = 0;
    sfi_slice_clear(below);
    for (uint32_t k = hollow->box.z0; k < hollow->box.z1; k++) {
        SF_TRY(fit(plan, hollow, k, slices[2], fits));
        SF_TRY(find_layer(plan, k, fits, below, first, end, levers, allocator, outlets));
        sf_slice swap = fits;
        fits = below;
        below = swap;
    }
    return SF_OK;
}

sfi_outlet *sfi_outlets_best(const sfi_outlets *outlets)
{
    sfi_outlet *best = NULL;
    for (size_t i = 0; i < outlets->count; i++) {
        sfi_outlet *o = &outlets->list[i];
        if (o->state == 0 && (best == NULL || o->cost < best->cost)) {
            best = o;
        }
    }
    return best;
}

static int are_close(const sf_lattice *l, const sfi_outlet *a, const sfi_outlet *b,
                     double radius_mm)
{
    double dx = ((double)a->x - b->x) * l->pitch_x_mm, dy = ((double)a->y - b->y) * l->pitch_y_mm;
    return dx * dx + dy * dy < radius_mm * radius_mm;
}

void sfi_outlets_give_up(const sfi_outlets *outlets, const sf_lattice *lattice,
                         const sfi_outlet *one, double radius_mm)
{
    for (size_t i = 0; i < outlets->count; i++) {
        sfi_outlet *o = &outlets->list[i];
        if (o->direction == one->direction && are_close(lattice, o, one, radius_mm)) {
            o->state |= SFI_OUTLET_VAIN;
        }
    }
}

void sfi_outlets_keep_apart(const sfi_outlets *outlets, const sf_lattice *lattice, double radius_mm)
{
    for (size_t i = 0; i < outlets->count; i++) {
        outlets->list[i].state &= ~SFI_OUTLET_CLOSE & 0xff;
    }
    for (size_t i = 0; i < outlets->count; i++) {
        const sfi_outlet *taken = &outlets->list[i];
        for (size_t j = 0; (taken->state & SFI_OUTLET_TAKEN) && j < outlets->count; j++) {
            if (are_close(lattice, &outlets->list[j], taken, radius_mm)) {
                outlets->list[j].state |= SFI_OUTLET_CLOSE;
            }
        }
    }
}

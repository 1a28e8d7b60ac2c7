// SPDX-License-Identifier: MIT
// Printing: how far from toppling a part is, after each of its layers.
//
// The pieces of what is printed so far, with their moments and what they stand on, come from
// printed.c. A piece's margin changes only where a layer adds to it, so each layer looks at the
// pieces that it touches, and takes the least over all that stand: those that are done still stand
// there. With the centre of mass at height h over the bed, at distance d inside of an edge of the
// hull of what it stands on, the margin is the least atan(d / h), as in tip.c.
//
// Heights are whole units: a layer, where all are alike; else 2^-40 of the whole, to which the
// bottoms of layers are rounded, each at least one above the one before. All sums are integers, of
// at most 2^113.
//
// Source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand", 2013, section
// 3, for what stands; that it is asked of every layer and piece is our own.

#include <sf/printing.h>

#include "balance/stance/printed.h"
#include "base/math.h"
#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/terms.h"

#include <math.h>

#define HALF_PI 1.5707963267948966
#define UNITS 1099511627776.0 // 2^40

typedef struct watch {
    sf_lattice lattice;
    double unit_mm;
    sfi_printed pieces;
    sfi_layer layer;
    uint64_t bed_bottom; // in units
    double *margins;
    sf_printing_report report;
} watch;

sf_printing_options sf_printing_options_default(void)
{
    sf_printing_options options = {.struct_size = sizeof options,
                                   .bed_layer = SF_BED_AUTO,
                                   .connectivity = SF_CONNECT_CORNERS};
    return options;
}

// ---------------------------------------------------------------------------------------------
// Heights
// ---------------------------------------------------------------------------------------------

static void set_unit(watch *w)
{
    double sum = 0;
    for (uint32_t k = 0; w->lattice.heights_mm != NULL && k < w->lattice.nz; k++) {
        sum += w->lattice.heights_mm[k];
    }
    w->unit_mm = w->lattice.heights_mm == NULL ? w->lattice.layer_mm : sum / UNITS;
}

// Go up to the next layer, whose bottom in mm from the lattice's is `bottom`.
static void climb(watch *w, uint32_t k, double *bottom)
{
    double height = sf_lattice_layer_height(&w->lattice, k);
    w->layer.index = k;
    w->layer.bottom = w->layer.top;
    *bottom += height;
    uint64_t top = w->lattice.heights_mm == NULL ? (uint64_t)k + 1
                                                 : (uint64_t)floor(*bottom / w->unit_mm + 0.5);
    w->layer.top = top > w->layer.bottom ? top : w->layer.bottom + 1;
}

// ---------------------------------------------------------------------------------------------
// Margins
// ---------------------------------------------------------------------------------------------

// The centre of mass, in voxels along x and y from the lattice's corner, in units above the bed.
static void find_centre(const watch *w, const sfi_piece *p, double centre[3])
{
    double mass = sfi_exact_double(p->mass);
    centre[0] = sfi_exact_double(p->x) / mass + 0.5;
    centre[1] = sfi_exact_double(p->y) / mass + 0.5;
    centre[2] = sfi_exact_double(p->z) / mass / 2 - (double)w->bed_bottom;
}

static void find_margin(const watch *w, sfi_piece *p)
{
    double centre[3];
    find_centre(w, p, centre);
    double inside =
        sfi_polygon_inside(w->pieces.corners + p->first, p->corners, centre[0], centre[1],
                           w->lattice.pitch_x_mm, w->lattice.pitch_y_mm, &p->edge);
    p->margin_rad = sfi_atan(inside / (centre[2] * w->unit_mm));
}

// Describe the worst piece so far.
static void name(watch *w, const sfi_piece *p)
{
    sf_printing_report *r = &w->report;
    const sf_lattice *l = &w->lattice;
    const double pitch[2] = {l->pitch_x_mm, l->pitch_y_mm};
    const sfi_corner *corners = w->pieces.corners + p->first;
    double centre[3], bed = l->origin_mm[2] + (double)w->bed_bottom * w->unit_mm;
    find_centre(w, p, centre);
    r->margin_rad = p->margin_rad;
    r->layer = w->layer.index;
    r->piece = p->box;
    r->piece_voxels = p->voxels;
    for (int d = 0; d < 2; d++) {
        r->com_mm[d] = l->origin_mm[d] + centre[d] * pitch[d];
    }
    r->com_mm[2] = bed + centre[2] * w->unit_mm;
    for (size_t i = 0; i < 2; i++) {
        const sfi_corner *c = &corners[(p->edge + i) % p->corners];
        r->edge_mm[i][0] = l->origin_mm[0] + (double)c->x * pitch[0];
        r->edge_mm[i][1] = l->origin_mm[1] + (double)c->y * pitch[1];
        r->edge_mm[i][2] = bed;
    }
}

// Look at the pieces after a layer.
static void judge_layer(watch *w)
{
    sf_printing_report *r = &w->report;
    const sfi_piece *worst = NULL;
    uint32_t standing = 0;
    for (uint32_t i = 0; i < w->pieces.sets.count; i++) {
        sfi_piece *p = &w->pieces.list[i];
        if (p->is_on_bed && p->is_here) {
            find_margin(w, p);
        }
        if (p->is_on_bed) {
            standing++;
            worst = worst == NULL || p->margin_rad < worst->margin_rad ? p : worst;
        } else if (p->is_new) {
            r->floating_count++;
            r->floating_layer =
                r->floating_layer == SF_BED_AUTO ? w->layer.index : r->floating_layer;
        }
    }
    r->standing_count = standing > r->standing_count ? standing : r->standing_count;
    r->toppling_layers += worst != NULL && worst->margin_rad < 0;
    if (w->margins != NULL) {
        w->margins[w->layer.index] = worst != NULL ? worst->margin_rad : HALF_PI;
    }
    if (worst != NULL && (r->layer == SF_BED_AUTO || worst->margin_rad < r->margin_rad)) {
        name(w, worst);
    }
}

// ---------------------------------------------------------------------------------------------
// The sweep
// ---------------------------------------------------------------------------------------------

static sf_status sweep(watch *w, const sf_grid *grid, uint32_t bed, sf_task *task)
{
    sfi_progress progress = sfi_progress_begin(task);
    double bottom = 0;
    for (uint32_t k = 0; k < w->lattice.nz; k++) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        climb(w, k, &bottom);
        w->layer.is_bed = k == bed;
        if (k == bed) {
            w->bed_bottom = w->layer.bottom;
        }
        if (k >= bed) {
            SF_TRY(sfi_printed_add(&w->pieces, sf_grid_slice(grid, k), &w->layer));
        }
        judge_layer(w);
        sfi_progress_report(&progress, (uint64_t)k + 1, w->lattice.nz);
    }
    return SF_OK;
}

static sf_status check(const sf_grid *grid, const sf_printing_options *o)
{
    uint32_t nz = sf_grid_lattice(grid).nz;
    if (o->struct_size < sizeof *o ||
        (o->connectivity != SF_CONNECT_EDGES && o->connectivity != SF_CONNECT_CORNERS) ||
        (o->bed_layer != SF_BED_AUTO && o->bed_layer >= nz)) {
        return SF_ERR_ARGUMENT;
    }
    return o->margins_rad != NULL && o->margin_capacity < nz ? SF_ERR_CAPACITY : SF_OK;
}

// All of it, with margins in an array of its own, so that nothing changes where it fails.
static sf_status look(watch *w, const sf_grid *grid, const sf_printing_options *o, sf_task *task)
{
    uint32_t nz = w->lattice.nz;
    uint32_t bed = o->bed_layer == SF_BED_AUTO ? sfi_first_matter(grid) : o->bed_layer;
    set_unit(w);
    w->report.bed_layer = bed < nz ? bed : SF_BED_AUTO;
    if (o->margins_rad != NULL) {
        w->margins = sfi_alloc_array(&w->pieces.sets.allocator, nz, sizeof *w->margins);
        if (w->margins == NULL) {
            return SF_ERR_MEMORY;
        }
    }
    sf_status status = sweep(w, grid, bed, task);
    for (uint32_t k = 0; status == SF_OK && w->margins != NULL && k < nz; k++) {
        o->margins_rad[k] = w->margins[k];
    }
    sfi_free_array(&w->pieces.sets.allocator, w->margins, nz, sizeof *w->margins);
    return status;
}

sf_status sf_grid_printing(const sf_grid *grid, const sf_printing_options *options,
                           const sf_allocator *allocator, sf_task *task, sf_printing_report *report)
{
    const sf_printing_options usual = sf_printing_options_default();
    const sf_printing_options *o = options != NULL ? options : &usual;
    if (grid == NULL || report == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(check(grid, o));
    watch w = {
        .lattice = sf_grid_lattice(grid),
        .pieces.sets = {.allocator = sfi_allocator_or_default(allocator),
                        .connectivity = o->connectivity},
        .report = {.margin_rad = HALF_PI, .layer = SF_BED_AUTO, .floating_layer = SF_BED_AUTO}};
    sf_status status = look(&w, grid, o, task);
    sfi_printed_release(&w.pieces);
    if (status == SF_OK) {
        *report = w.report;
    }
    return status;
}

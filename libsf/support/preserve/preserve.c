// SPDX-License-Identifier: MIT
// Preserve: remove a brush and keep of it what carries the rest.
//
// What must stay is F = V \ B, with B the brush; preserve is complete(V, F), and all laws of it are
// laws of complete: F within V' within V, V' support-free, V' = F just when F is. This file reads
// the terms and leaves the work to the modes.
//
// Accepting what is unsupported: voxels that are not in trim(V) become exempt, so that V is
// support-free apart from exempt voxels by definition. Voxels that must go, Q: the shape to take
// supports from is trim(V \ Q), and F must lie within it; if any support-free set without Q holds
// F, trim(V \ Q) does.
//
// Complete is greedy, and for rules that are elements irredundant as it is: who is kept in layer k
// carries alone somebody in layer k + 1, who is in F or was kept for the same reason, so without
// him a voxel of F hangs. Under slack and with bridges that does not follow, and sfi_spare() tries
// all that was kept.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, section 2.2 (the operator).

#include "base/memory.h"
#include "base/status.h"
#include "support/preserve/complete.h"
#include "support/preserve/removal.h"
#include "support/preserve/spare.h"
#include "support/rule/carry.h"
#include "support/rule/terms.h"
#include "voxel/slice.h"

sf_preserve_options sf_preserve_options_default(void)
{
    sf_preserve_options options = {.struct_size = sizeof options, .strut_width = 3};
    return options;
}

// ---------------------------------------------------------------------------------------------
// The brush
// ---------------------------------------------------------------------------------------------

// Bits of word i, the first of which stands at x, that lie in x0 <= x < x1.
static uint64_t bits_between(uint32_t x, uint32_t x0, uint32_t x1)
{
    if (x >= x1 || x + 64 <= x0) {
        return 0;
    }
    uint64_t from = x0 > x ? ~UINT64_C(0) << (x0 - x) : ~UINT64_C(0);
    return x1 - x < 64 ? from & sfi_tail_mask(x1 - x) : from;
}

static const uint64_t *mask_row(const sf_grid *mask, uint32_t k, uint32_t y)
{
    return mask != NULL ? sfi_slice_row(sf_grid_slice(mask, k), y) : NULL;
}

static void split_row(const sfi_removal *r, const sf_grid *from, uint32_t k, sf_rect part,
                      uint32_t y, uint64_t *taken, uint64_t *rest)
{
    sf_box b = r->box;
    int inside = k >= b.z0 && k < b.z1 && y >= b.y0 && y < b.y1;
    const uint64_t *solid = sfi_slice_row(sf_grid_slice(from, k), y);
    const uint64_t *brush = mask_row(r->brush, k, y), *act = mask_row(r->terms->act, k, y);
    const uint64_t *keep = mask_row(r->terms->keep, k, y);
    for (uint32_t x = part.x0; x < part.x1; x += 64) {
        size_t i = x / 64, at = (x - part.x0) / 64;
        uint64_t all = solid[i] & bits_between(x, part.x0, part.x1);
        uint64_t in = inside ? brush[i] & bits_between(x, b.x0, b.x1) : 0;
        in &= act != NULL ? act[i] : ~UINT64_C(0);
        in &= keep != NULL ? ~keep[i] : ~UINT64_C(0);
        if (taken != NULL) {
            taken[at] = all & in;
        }
        if (rest != NULL) {
            rest[at] = all & ~in;
        }
    }
}

void sfi_removal_split(const sfi_removal *r, const sf_grid *from, uint32_t k, sf_rect part,
                       sf_slice taken, sf_slice rest)
{
    for (uint32_t y = part.y0; y < part.y1; y++) {
        split_row(r, from, k, part, y,
                  taken.words != NULL ? sfi_slice_row(taken, y - part.y0) : NULL,
                  rest.words != NULL ? sfi_slice_row(rest, y - part.y0) : NULL);
    }
}

void sfi_removal_commit(const sfi_removal *r, const sf_grid *after, sf_preserve_report *report)
{
    sf_lattice lattice = sf_grid_lattice(r->grid);
    const sfi_kernels *kernels = sfi_kernels_get();
    sf_rect all = {0, 0, lattice.nx, lattice.ny};
    size_t words = sfi_row_words(lattice.nx);
    for (uint32_t k = 0; k < lattice.nz; k++) {
        for (uint32_t y = 0; y < lattice.ny; y++) {
            uint64_t taken[SFI_ROW_WORDS_MAX], rest[SFI_ROW_WORDS_MAX];
            uint64_t *row = sfi_slice_row(sf_grid_slice(r->grid, k), y);
            const uint64_t *now = sfi_slice_row(sf_grid_slice(after, k), y);
            split_row(r, r->grid, k, all, y, taken, rest);
            uint64_t in = kernels->popcount(taken, words), out = kernels->popcount(rest, words);
            for (size_t i = 0; i < words; i++) {
                taken[i] &= now[i];
                rest[i] &= now[i];
                row[i] = now[i];
            }
            uint64_t in_now = kernels->popcount(taken, words);
            uint64_t out_now = kernels->popcount(rest, words);
            report->kept_voxels += in_now;
            report->removed_voxels += in - in_now;
            report->lost_outside += out - out_now;
            report->added_voxels += kernels->popcount(now, words) - in_now - out_now;
        }
    }
}

// ---------------------------------------------------------------------------------------------
// By complete
// ---------------------------------------------------------------------------------------------

static sf_status complete_to(const sfi_removal *r, const sf_grid *needed, sf_grid *result)
{
    int is_thick = r->options->mode == SF_PRESERVE_CORE;
    sfi_completion c = {r->shape, needed, r->terms, r->bed, is_thick ? r->options->strut_width : 0};
    SF_TRY(sfi_complete_into(result, &c, r->allocator, r->task));
    if (r->options->mode != SF_PRESERVE_IRREDUNDANT || sfi_rule_is_element(&r->terms->rule)) {
        return SF_OK;
    }
    return sfi_spare(result, needed, r->terms, r->bed, r->allocator, r->task);
}

static sf_status by_complete(const sfi_removal *r, sf_preserve_report *report)
{
    sf_lattice lattice = sf_grid_lattice(r->grid);
    sf_rect all = {0, 0, lattice.nx, lattice.ny};
    sf_grid *needed, *result = NULL;
    SF_TRY(sf_grid_create(&lattice, r->allocator, &needed));
    sf_status status = sf_grid_create(&lattice, r->allocator, &result);
    for (uint32_t k = 0; status == SF_OK && k < lattice.nz; k++) {
        sfi_removal_split(r, r->grid, k, all, SFI_NO_SLICE, sf_grid_slice(needed, k));
    }
    if (status == SF_OK) {
        status = complete_to(r, needed, result);
    }
    if (status == SF_OK) {
        sfi_removal_commit(r, result, report);
    }
    sf_grid_destroy(result);
    sf_grid_destroy(needed);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Progress
// ---------------------------------------------------------------------------------------------

static void relay(void *user, double fraction)
{
    sfi_quiet *quiet = user;
    (void)fraction;
    if (sf_task_is_cancelled(quiet->host)) {
        sf_task_cancel(&quiet->task);
    }
}

sf_task *sfi_quiet_begin(sfi_quiet *quiet, const sf_task *host)
{
    if (host == NULL) {
        return NULL;
    }
    quiet->task = sf_task_default();
    quiet->task.progress = relay;
    quiet->task.user = quiet;
    quiet->host = host;
    relay(quiet, 0.0);
    return &quiet->task;
}

// ---------------------------------------------------------------------------------------------
// Terms and options
// ---------------------------------------------------------------------------------------------

// exempt = what the terms name, and all of the grid that they do not carry.
static sf_status accept(const sfi_removal *r, sf_grid *exempt)
{
    sfi_quiet quiet;
    sf_task *task = sfi_quiet_begin(&quiet, r->task);
    SF_TRY(sfi_trim_into(exempt, r->grid, r->terms, r->bed, r->allocator, task));
    for (uint32_t k = 0; k < sf_grid_lattice(exempt).nz; k++) {
        sf_slice slice = sf_grid_slice(exempt, k);
        SF_TRY(sf_slice_subtract(slice, sf_grid_slice(r->grid, k), slice));
        if (r->terms->exempt != NULL) {
            SF_TRY(sf_slice_or(slice, slice, sf_grid_slice(r->terms->exempt, k)));
        }
    }
    return SF_OK;
}

// shape = trim(grid \ must_go), which must hold all that is outside the brush.
static sf_status go_without(const sfi_removal *r, sf_grid *shape)
{
    sfi_quiet quiet;
    sf_lattice lattice = sf_grid_lattice(shape);
    sf_rect all = {0, 0, lattice.nx, lattice.ny};
    for (uint32_t k = 0; k < lattice.nz; k++) {
        SF_TRY(sf_slice_subtract(sf_grid_slice(shape, k), sf_grid_slice(r->grid, k),
                                 sf_grid_slice(r->options->must_go, k)));
    }
    sf_task *task = sfi_quiet_begin(&quiet, r->task);
    SF_TRY(sfi_trim_into(shape, shape, r->terms, r->bed, r->allocator, task));
    for (uint32_t k = 0; k < lattice.nz; k++) {
        for (uint32_t y = 0; y < lattice.ny; y++) {
            uint64_t rest[SFI_ROW_WORDS_MAX], lost = 0;
            const uint64_t *left = sfi_slice_row(sf_grid_slice(shape, k), y);
            split_row(r, r->grid, k, all, y, NULL, rest);
            for (size_t i = 0; i < sfi_row_words(lattice.nx); i++) {
                lost |= rest[i] & ~left[i];
            }
            if (lost != 0) {
                return SF_ERR_INFEASIBLE;
            }
        }
    }
    return SF_OK;
}

static sf_status run_mode(const sfi_removal *r, sf_preserve_report *report)
{
    sf_preserve_mode mode = r->options->mode;
    if (mode == SF_PRESERVE_PAPER_TEXT || mode == SF_PRESERVE_PAPER_SHADER) {
        return sfi_preserve_paper(r, report);
    }
    if (mode == SF_PRESERVE_FAST && sfi_rule_is_element(&r->terms->rule)) {
        return sfi_preserve_fast(r, report);
    }
    return by_complete(r, report);
}

// With exempt voxels and a shape of its own where the options ask for them.
static sf_status run(sfi_removal *r, sf_preserve_report *report)
{
    sf_terms wider = *r->terms;
    sf_grid *exempt = NULL, *shape = NULL;
    sf_lattice lattice = sf_grid_lattice(r->grid);
    sf_status status = SF_OK;
    if (r->options->accept_unsupported) {
        status = sf_grid_create(&lattice, r->allocator, &exempt);
        status = status == SF_OK ? accept(r, exempt) : status;
        wider.exempt = exempt;
        r->terms = &wider;
    }
    if (status == SF_OK && r->options->must_go != NULL) {
        status = sf_grid_create(&lattice, r->allocator, &shape);
        status = status == SF_OK ? go_without(r, shape) : status;
        r->shape = shape;
    }
    if (status == SF_OK) {
        status = run_mode(r, report);
    }
    sf_grid_destroy(exempt);
    sf_grid_destroy(shape);
    return status;
}

static sf_status check_options(const sf_preserve_options *o, const sf_lattice *lattice)
{
    int is_paper = o->mode == SF_PRESERVE_PAPER_TEXT || o->mode == SF_PRESERVE_PAPER_SHADER;
    int is_mode = (unsigned)o->mode <= SF_PRESERVE_PAPER_SHADER;
    if (o->struct_size < sizeof *o || !is_mode || o->strut_width % 2 == 0 || o->strut_width > 255 ||
        (is_paper && o->must_go != NULL) || o->brush_box.x1 > lattice->nx ||
        o->brush_box.y1 > lattice->ny || o->brush_box.z1 > lattice->nz) {
        return SF_ERR_ARGUMENT;
    }
    return o->must_go != NULL ? sfi_terms_match(lattice, o->must_go) : SF_OK;
}

// Where the brush is, as far as that has to be known.
static sf_box find_box(const sf_grid *brush, const sf_preserve_options *o)
{
    sf_box b = o->brush_box, none = {0, 0, 0, 0, 0, 0};
    if (b.x1 == 0 && b.y1 == 0 && b.z1 == 0) {
        return sf_grid_bounds(brush);
    }
    return b.x0 < b.x1 && b.y0 < b.y1 && b.z0 < b.z1 ? b : none;
}

sf_status sf_grid_preserve(sf_grid *grid, const sf_grid *brush, const sf_terms *terms,
                           const sf_preserve_options *options, const sf_allocator *allocator,
                           sf_task *task, sf_preserve_report *report)
{
    sf_preserve_options fallback = sf_preserve_options_default();
    const sf_preserve_options *o = options != NULL ? options : &fallback;
    sfi_ground ground;
    SF_TRY(sfi_terms_check(terms, grid, &ground));
    SF_TRY(check_options(o, &ground.lattice));
    if (brush == NULL || grid == brush || grid == o->must_go || grid == terms->exempt ||
        grid == terms->keep || grid == terms->act || grid == terms->forbid) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_terms_match(&ground.lattice, brush));
    if (sf_task_is_cancelled(task)) {
        return SF_ERR_CANCELLED;
    }
    sf_preserve_report counts = {0, 0, 0, 0};
    sfi_removal removal = {grid,       grid, brush,     terms, find_box(brush, o),
                           ground.bed, o,    allocator, task};
    SF_TRY(run(&removal, &counts));
    if (report != NULL) {
        *report = counts;
    }
    return SF_OK;
}

// SPDX-License-Identifier: MIT
// Terms: a rule, a bed and masks, and what can be had under them.
//
// Let M be what may be solid and P what must be. A support-free R with P within R within M exists
// just when P lies within trim(M): trim(M) is the greatest support-free subset of M, so if any R
// exists it lies within it; and if P does, trim(M) itself is one. A voxel of P outside trim(M) lies
// in no support-free subset of M, so it is impossible even alone; and when all such voxels are
// given up, or exempted, what is left of P lies within trim(M). So P \ trim(M) is exactly what to
// name.
//
// This holds for every monotone rule, with exempt voxels too: they only make the trim larger.

#include "support/rule/terms.h"

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/carry.h"
#include "support/rule/rule.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

sf_terms sf_terms_default(void)
{
    sf_terms terms = {sizeof terms, sf_rule_box3(), SF_BED_AUTO, NULL, NULL, NULL, NULL};
    return terms;
}

sf_status sfi_terms_match(const sf_lattice *lattice, const sf_grid *grid)
{
    sf_lattice other = sf_grid_lattice(grid);
    int same = other.nx == lattice->nx && other.ny == lattice->ny && other.nz == lattice->nz;
    return same ? SF_OK : SF_ERR_SHAPE;
}

int sfi_terms_mask(const sf_terms *terms, const sf_grid *grid)
{
    return grid != NULL && (grid == terms->exempt || grid == terms->keep || grid == terms->forbid ||
                            grid == terms->act);
}

sf_slice sfi_mask_slice(const sf_grid *mask, uint32_t k)
{
    return mask != NULL ? sf_grid_slice(mask, k) : SFI_NO_SLICE;
}

uint32_t sfi_first_matter(const sf_grid *grid)
{
    uint32_t nz = sf_grid_lattice(grid).nz, k = 0;
    while (k < nz && !sfi_slice_any(sf_grid_slice(grid, k))) {
        k++;
    }
    return k;
}

sf_status sfi_terms_check(const sf_terms *terms, const sf_grid *shape, sfi_ground *ground)
{
    if (terms == NULL || shape == NULL || terms->struct_size < sizeof *terms) {
        return SF_ERR_ARGUMENT;
    }
    ground->lattice = sf_grid_lattice(shape);
    if (terms->bed_layer != SF_BED_AUTO && terms->bed_layer >= ground->lattice.nz) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_rule_check(&terms->rule, 0, ground->lattice.nz));
    const sf_grid *masks[4] = {terms->exempt, terms->keep, terms->forbid, terms->act};
    for (int i = 0; i < 4; i++) {
        if (masks[i] != NULL) {
            SF_TRY(sfi_terms_match(&ground->lattice, masks[i]));
        }
    }
    ground->bed = terms->bed_layer == SF_BED_AUTO ? sfi_first_matter(shape) : terms->bed_layer;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Trim with exempt voxels
// ---------------------------------------------------------------------------------------------

// Two fronts, one of them at a time the layer below.
typedef struct sweep {
    sfi_carrier carrier;
    sfi_front fronts[2];
} sweep;

static sf_status sweep_create(sweep *s, const sf_terms *terms, const sf_lattice *lattice,
                              const sf_allocator *allocator)
{
    *s = (sweep){0};
    const sf_rule *rule = &terms->rule;
    SF_TRY(sfi_carrier_create(rule, lattice->nx, lattice->ny, allocator, &s->carrier));
    sf_status status = sfi_front_create(rule, lattice->nx, lattice->ny, allocator, &s->fronts[0]);
    return status != SF_OK
               ? status
               : sfi_front_create(rule, lattice->nx, lattice->ny, allocator, &s->fronts[1]);
}

static void sweep_destroy(sweep *s, const sf_terms *terms, const sf_allocator *allocator)
{
    sfi_front_destroy(&s->fronts[0], &terms->rule, allocator);
    sfi_front_destroy(&s->fronts[1], &terms->rule, allocator);
    sfi_carrier_destroy(&s->carrier, allocator);
}

// The front of layer k from that of layer k - 1.
static sf_status sweep_layer(const sweep *s, uint32_t k, uint32_t bed, sf_slice solid,
                             sf_slice exempt)
{
    return sfi_carry_layer(&s->carrier, k, bed, &s->fronts[(k + 1) % 2], solid, exempt,
                           s->fronts[k % 2], SFI_NO_SLICE);
}

// One layer where the rule is an element and nothing is exempt: bits are all there is, so the
// result is the front.
static sf_status trim_layer(sf_grid *to, const sf_grid *from, const sf_rule *rule, uint32_t bed,
                            uint32_t k)
{
    sf_slice out = sf_grid_slice(to, k), solid = sf_grid_slice(from, k);
    sf_element element;
    if (k == bed) {
        return sf_slice_copy(out, solid);
    }
    if (k < bed) {
        sf_rect all = {0, 0, out.width, out.height};
        return sf_slice_fill(out, all, 0);
    }
    SF_TRY(sf_rule_element(rule, k - 1, &element));
    return sf_slice_and_dilate(out, solid, sf_grid_slice(to, k - 1), &element);
}

static sf_status trim_by_elements(sf_grid *to, const sf_grid *from, const sf_rule *rule,
                                  uint32_t bed, sf_task *task)
{
    uint32_t nz = sf_grid_lattice(from).nz;
    sfi_progress progress = sfi_progress_begin(task);
    for (uint32_t k = 0; k < nz; k++) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        SF_TRY(trim_layer(to, from, rule, bed, k));
        sfi_progress_report(&progress, k + 1, nz);
    }
    return SF_OK;
}

sf_status sfi_trim_into(sf_grid *to, const sf_grid *from, const sf_terms *terms, uint32_t bed,
                        const sf_allocator *allocator, sf_task *task)
{
    if (sfi_rule_is_element(&terms->rule) && terms->exempt == NULL) {
        return trim_by_elements(to, from, &terms->rule, bed, task);
    }
    sf_lattice lattice = sf_grid_lattice(from);
    sweep s;
    sfi_progress progress = sfi_progress_begin(task);
    sf_status status = sweep_create(&s, terms, &lattice, allocator);
    for (uint32_t k = 0; status == SF_OK && k < lattice.nz; k++) {
        if (sf_task_is_cancelled(task)) {
            status = SF_ERR_CANCELLED;
            break;
        }
        status = sweep_layer(&s, k, bed, sf_grid_slice(from, k), sfi_mask_slice(terms->exempt, k));
        if (status == SF_OK) {
            status = sf_slice_copy(sf_grid_slice(to, k), s.fronts[k % 2].alive);
        }
        sfi_progress_report(&progress, k + 1, lattice.nz);
    }
    sweep_destroy(&s, terms, allocator);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Feasible, and trim with masks
// ---------------------------------------------------------------------------------------------

// culprits (or NULL) = needed without what is in `possible`; returns their number.
static uint64_t find_culprits(const sf_grid *needed, const sf_grid *possible, sf_grid *culprits)
{
    sf_lattice lattice = sf_grid_lattice(needed);
    size_t words = sfi_row_words(lattice.nx);
    const sfi_kernels *kernels = sfi_kernels_get();
    uint64_t count = 0;
    for (uint32_t k = 0; k < lattice.nz; k++) {
        sf_slice a = sf_grid_slice(needed, k), b = sf_grid_slice(possible, k);
        sf_slice out = culprits != NULL ? sf_grid_slice(culprits, k) : b;
        for (uint32_t y = 0; y < lattice.ny; y++) {
            uint64_t *row = sfi_slice_row(out, y);
            kernels->subtract_words(row, sfi_slice_row(a, y), sfi_slice_row(b, y), words);
            row[words - 1] &= sfi_tail_mask(lattice.nx);
            count += kernels->popcount(row, words);
        }
    }
    return count;
}

sf_status sf_grid_feasible(const sf_grid *allowed, const sf_grid *needed, const sf_terms *terms,
                           const sf_allocator *allocator, sf_task *task, sf_grid *culprits,
                           uint64_t *count)
{
    sfi_ground ground;
    SF_TRY(sfi_terms_check(terms, allowed, &ground));
    if (needed == NULL || culprits == allowed || culprits == needed ||
        sfi_terms_mask(terms, culprits)) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_terms_match(&ground.lattice, needed));
    if (culprits != NULL) {
        SF_TRY(sfi_terms_match(&ground.lattice, culprits));
    }
    sf_grid *possible;
    SF_TRY(sf_grid_create(&ground.lattice, allocator, &possible));
    sf_status status = sfi_trim_into(possible, allowed, terms, ground.bed, allocator, task);
    if (status == SF_OK) {
        uint64_t missing = find_culprits(needed, possible, culprits);
        if (count != NULL) {
            *count = missing;
        }
        status = missing == 0 ? SF_OK : SF_ERR_INFEASIBLE;
    }
    sf_grid_destroy(possible);
    return status;
}

// must = what the masks keep of the shape.
static sf_status find_kept(sf_grid *must, const sf_grid *shape, const sf_terms *terms)
{
    sf_lattice lattice = sf_grid_lattice(shape);
    for (uint32_t k = 0; k < lattice.nz; k++) {
        sf_slice out = sf_grid_slice(must, k), solid = sf_grid_slice(shape, k);
        if (terms->act != NULL) {
            SF_TRY(sf_slice_subtract(out, solid, sf_grid_slice(terms->act, k)));
        }
        for (uint32_t y = 0; terms->keep != NULL && y < lattice.ny; y++) {
            uint64_t *row = sfi_slice_row(out, y), *in = sfi_slice_row(solid, y);
            const uint64_t *keep = sfi_slice_row(sf_grid_slice(terms->keep, k), y);
            for (size_t i = 0; i < sfi_row_words(lattice.nx); i++) {
                row[i] |= in[i] & keep[i];
            }
            row[sfi_row_words(lattice.nx) - 1] &= sfi_tail_mask(lattice.nx);
        }
    }
    return SF_OK;
}

// Trim the grid into `trimmed`, and say whether anything that must stay is gone.
static sf_status trim_copy(const sf_grid *grid, sf_grid *trimmed, const sf_terms *terms,
                           uint32_t bed, const sf_allocator *allocator, sf_task *task,
                           sf_grid *culprits)
{
    SF_TRY(sfi_trim_into(trimmed, grid, terms, bed, allocator, task));
    if (terms->keep == NULL && terms->act == NULL) {
        return SF_OK;
    }
    sf_grid *must;
    sf_lattice lattice = sf_grid_lattice(grid);
    SF_TRY(sf_grid_create(&lattice, allocator, &must));
    sf_status status = find_kept(must, grid, terms);
    if (status == SF_OK && find_culprits(must, trimmed, must) > 0) {
        status = SF_ERR_INFEASIBLE;
        for (uint32_t k = 0; culprits != NULL && k < lattice.nz; k++) {
            (void)!sf_slice_copy(sf_grid_slice(culprits, k), sf_grid_slice(must, k));
        }
    }
    sf_grid_destroy(must);
    return status;
}

sf_status sf_grid_trim_on(sf_grid *grid, const sf_terms *terms, const sf_allocator *allocator,
                          sf_task *task, sf_grid *culprits, sf_trim_report *report)
{
    sfi_ground ground;
    SF_TRY(sfi_terms_check(terms, grid, &ground));
    if (grid == culprits || sfi_terms_mask(terms, grid) || sfi_terms_mask(terms, culprits)) {
        return SF_ERR_ARGUMENT;
    }
    if (culprits != NULL) {
        SF_TRY(sfi_terms_match(&ground.lattice, culprits));
    }
    sf_grid *trimmed;
    SF_TRY(sf_grid_create(&ground.lattice, allocator, &trimmed));
    sf_status status = trim_copy(grid, trimmed, terms, ground.bed, allocator, task, culprits);
    if (status == SF_OK) {
        uint64_t before = sf_grid_popcount(grid), after = sf_grid_popcount(trimmed);
        for (uint32_t k = 0; k < ground.lattice.nz; k++) {
            (void)!sf_slice_copy(sf_grid_slice(grid, k), sf_grid_slice(trimmed, k));
        }
        if (report != NULL) {
            uint32_t bed = ground.bed < ground.lattice.nz ? ground.bed : SF_BED_AUTO;
            sf_trim_report counts = {after, before - after, bed};
            *report = counts;
        }
    }
    sf_grid_destroy(trimmed);
    return status;
}

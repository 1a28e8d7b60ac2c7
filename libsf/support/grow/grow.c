// SPDX-License-Identifier: MIT
// Grow: what a whole shape lacks to be support-free, added from the top down.
//
// Let S be the shape, free the voxels that may be added, and M' the trim of S with all of these. A
// support-free R with S within R within S and free exists just when S lies within M' (terms.c);
// what of S does not is what to name. Where nothing is masked M' is everything from the bed up,
// because every voxel carries the one above it, and need not be computed.
//
// A price says what a voxel costs if it is added: the number of voxels from it down to matter or to
// the bed, by a map of the whole grid,
//
//     E(v) = 0 in S,   1 on the bed or where exempt,   1 + min E(u) over what can carry v
//     elsewhere.
//
// Then from the top layer down each voxel of R that has no supporter gets one (grow_layer.c), the
// cheapest ones shared by as many as may be (grow_cover.c). What is chosen lies in R from then on
// and is looked at in its own layer, so paths merge where they meet. Under slack a price is a guide
// only, by the octagon of the same reach, and demands go down with what is chosen.
//
// R is support-free: each of its voxels was alive in S, is exempt, spans a gap between anchors, or
// has a supporter in R with slack enough; by induction from the bed all are alive. Nothing but what
// was needed is added, so a support-free shape stays as it is, and growing again changes nothing.
//
// With bridges the plain rule is safe (ALGORITHMS 10.4); new ones are tried along x and along y,
// and the smallest result is kept. Whatever was done, the result is checked under the whole rule.

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "support/grow/growth.h"

// ---------------------------------------------------------------------------------------------
// Prices
// ---------------------------------------------------------------------------------------------

// The rule that prices go by.
static sf_rule price_rule(const sf_rule *plain)
{
    sf_rule rule = *plain;
    if (plain->kind == SF_RULE_SLACK) {
        // On pixels that are not square straight down is all that is sure without a demand.
        sf_rule straight = {.kind = SF_RULE_DISK};
        rule.kind = SF_RULE_OCTAGON;
        rule = plain->slack_x == plain->slack_y ? rule : straight;
    }
    return rule;
}

static void take_least(uint16_t *restrict out, const uint16_t *restrict in, uint32_t count)
{
    for (uint32_t x = 0; x < count; x++) {
        out[x] = in[x] < out[x] ? in[x] : out[x];
    }
}

// The least price of what can carry each voxel of row y.
static void least_below(const sfi_growth *g, const uint16_t *below, const sf_element *e, uint32_t y,
                        uint16_t *out)
{
    uint32_t nx = g->site.lattice.nx, ny = g->site.lattice.ny;
    uint32_t y0 = y > e->reach_y ? y - e->reach_y : 0;
    uint32_t y1 = e->reach_y < ny - y ? y + e->reach_y + 1 : ny;
    for (uint32_t x = 0; x < nx; x++) {
        out[x] = SFI_PRICE_NONE;
    }
    for (uint32_t v = y0; v < y1; v++) {
        const uint16_t *in = below + (size_t)v * nx;
        uint32_t half = e->half_width[v > y ? v - y : y - v];
        for (uint32_t dx = 0; dx <= half && dx < nx; dx++) {
            take_least(out, in + dx, nx - dx);
            take_least(out + dx, in, nx - dx);
        }
    }
}

// Prices of a row, given the least ones below it.
static void settle_row(const sfi_growth *g, uint32_t k, uint32_t y, uint16_t *row)
{
    const sfi_site *site = &g->site;
    const uint64_t *solid = sfi_slice_row(sf_grid_slice(site->grid, k), y);
    sf_slice possible = sfi_mask_slice(g->possible, k),
             exempt = sfi_mask_slice(site->terms.exempt, k);
    uint64_t in = 0, may = 0, held = 0;
    for (uint32_t x = 0; x < site->lattice.nx; x++, in >>= 1, may >>= 1, held >>= 1) {
        if (x % 64 == 0) {
            in = solid[x / 64];
            may = possible.words != NULL ? sfi_slice_row(possible, y)[x / 64] : ~UINT64_C(0);
            held = k == site->bed         ? ~UINT64_C(0)
                   : exempt.words != NULL ? sfi_slice_row(exempt, y)[x / 64]
                                          : 0;
        }
        uint32_t more = row[x] < SFI_PRICE_NONE - 1 ? row[x] + 1u : SFI_PRICE_NONE - 1u;
        uint32_t price = (held & 1) != 0 ? 1 : more;
        price = (in & 1) != 0 ? 0 : price;
        row[x] = (uint16_t)((may & 1) != 0 ? price : SFI_PRICE_NONE);
    }
}

// Fill g->price.
static sf_status fill_prices(sfi_growth *g)
{
    sf_rule rule = price_rule(&g->site.plain);
    for (uint32_t k = g->site.bed; k < g->site.lattice.nz; k++) {
        uint16_t *layer = g->price + (size_t)(k - g->site.bed) * g->area;
        sf_element e = {0, {0}};
        if (sf_task_is_cancelled(g->task)) {
            return SF_ERR_CANCELLED;
        }
        if (k > g->site.bed) {
            SF_TRY(sf_rule_element(&rule, k - 1, &e));
        }
        for (uint32_t y = 0; y < g->site.lattice.ny; y++) {
            uint16_t *row = layer + (size_t)y * g->site.lattice.nx;
            if (k > g->site.bed) {
                least_below(g, layer - g->area, &e, y, row);
            }
            settle_row(g, k, y, row);
        }
        sfi_progress_report(&g->progress, ++g->done, g->total);
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// What is possible, what is alive
// ---------------------------------------------------------------------------------------------

static sf_status fill_field(sfi_growth *g, const sfi_field *field, const sf_grid *solid)
{
    sfi_stage stage = {g->task, &g->progress, g->done, g->total};
    g->done += g->site.lattice.nz;
    return sfi_field_fill(field, solid, &g->site.terms, g->site.bed, &g->site.allocator, &stage);
}

// Whether something may be where it is not possible: masks, or matter below the bed.
static int is_masked(const sfi_growth *g)
{
    return g->site.terms.forbid != NULL || g->site.terms.act != NULL ||
           sfi_first_matter(g->site.grid) < g->site.bed;
}

// g->result = the shape and all that may be added.
static void add_all_free(sfi_growth *g)
{
    for (uint32_t k = g->site.bed; k < g->site.lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(g->result, k);
        for (uint32_t y = 0; y < slice.height; y++) {
            for (size_t i = 0; i < sfi_row_words(slice.width); i++) {
                sfi_slice_row(slice, y)[i] |= sfi_site_free_word(&g->site, k, y, i);
            }
        }
    }
}

static int is_any_impossible(const sfi_growth *g)
{
    for (uint32_t k = 0; k < g->site.lattice.nz; k++) {
        sf_slice may = sf_grid_slice(g->possible, k), is = sf_grid_slice(g->site.grid, k);
        for (uint32_t y = 0; y < is.height; y++) {
            size_t last = sfi_row_words(is.width) - 1;
            const uint64_t *in = sfi_slice_row(is, y), *out = sfi_slice_row(may, y);
            uint64_t lost = in[last] & ~out[last] & sfi_tail_mask(is.width);
            for (size_t i = 0; i < last; i++) {
                lost |= in[i] & ~out[i];
            }
            if (lost != 0) {
                return 1;
            }
        }
    }
    return 0;
}

// M', and SF_ERR_INFEASIBLE where the shape does not lie within it.
static sf_status find_possible(sfi_growth *g)
{
    SF_TRY(sf_grid_create(&g->site.lattice, &g->site.allocator, &g->possible));
    if (sfi_bridge_any(&g->site.terms.rule.bridge)) {
        SF_TRY(sf_grid_create(&g->site.lattice, &g->site.allocator, &g->own));
    }
    SF_TRY(sfi_codes_create(&g->site, &g->spare));
    add_all_free(g);
    sfi_field field = {g->possible, g->own, g->spare, NULL};
    SF_TRY(fill_field(g, &field, g->result));
    return is_any_impossible(g) ? SF_ERR_INFEASIBLE : SF_OK;
}

static void copy_grid(sf_grid *to, const sf_grid *from)
{
    for (uint32_t k = 0; k < sf_grid_lattice(from).nz; k++) {
        (void)!sf_slice_copy(sf_grid_slice(to, k), sf_grid_slice(from, k));
    }
}

// ---------------------------------------------------------------------------------------------
// Runs
// ---------------------------------------------------------------------------------------------

static sf_status run_down(sfi_growth *g, sfi_growth_kind kind)
{
    copy_grid(g->result, g->site.grid);
    SF_TRY(sfi_growth_begin(g));
    for (uint32_t k = g->site.lattice.nz; k-- > g->site.bed;) {
        if (sf_task_is_cancelled(g->task)) {
            return SF_ERR_CANCELLED;
        }
        if (k > g->site.bed) {
            SF_TRY(sfi_growth_layer(g, k, kind));
        }
        sfi_progress_report(&g->progress, ++g->done, g->total);
    }
    return SF_OK;
}

// The kinds of growth that the rule has bridges for.
static int find_kinds(const sf_bridge *bridge, sfi_growth_kind kinds[3])
{
    int count = 0;
    kinds[count++] = SFI_GROW_PLAIN;
    if (bridge->span_x > 0) {
        kinds[count++] = SFI_GROW_X;
    }
    if (bridge->span_y > 0) {
        kinds[count++] = SFI_GROW_Y;
    }
    return count;
}

// The smallest of the runs, left in g->result.
static sf_status run_all(sfi_growth *g)
{
    sfi_growth_kind kinds[3];
    int count = find_kinds(&g->site.terms.rule.bridge, kinds);
    SF_TRY(run_down(g, kinds[0]));
    if (count == 1) {
        return SF_OK;
    }
    sf_grid *best;
    SF_TRY(sf_grid_clone(g->result, &g->site.allocator, &best));
    uint64_t least = sf_grid_popcount(best);
    sf_status status = SF_OK;
    for (int i = 1; status == SF_OK && i < count; i++) {
        status = run_down(g, kinds[i]);
        uint64_t size = sf_grid_popcount(g->result);
        if (status == SF_OK && size < least) {
            copy_grid(best, g->result);
            least = size;
        }
    }
    sf_grid_destroy(g->result);
    g->result = best;
    return status;
}

static sf_status create_run(sfi_growth *g)
{
    sf_lattice layers = g->site.lattice;
    size_t area;
    layers.nz = SFI_GROW_BITS;
    layers.heights_mm = NULL;
    if (!sfi_size_mul(layers.nx, layers.ny, &area) ||
        !sfi_size_mul(area, g->site.lattice.nz - g->site.bed, &area)) {
        return SF_ERR_OVERFLOW;
    }
    SF_TRY(sf_grid_create(&layers, &g->site.allocator, &g->bits));
    SF_TRY(sfi_grow_cover_create(&g->cover, &g->site));
    g->price = sfi_alloc_array(&g->site.allocator, area, sizeof *g->price);
    if (g->price == NULL) {
        return SF_ERR_MEMORY;
    }
    for (int i = 0; i < 2 && g->cover.has_slack; i++) {
        g->demand[i] = sfi_alloc_array(&g->site.allocator, g->area, 1);
        if (g->demand[i] == NULL) {
            return SF_ERR_MEMORY;
        }
    }
    return SF_OK;
}

// Leaves in g->result what the shape grows to.
static sf_status grow(sfi_growth *g)
{
    sfi_growth_kind kinds[3];
    const sf_rule *rule = &g->site.terms.rule;
    int has_field = rule->kind == SF_RULE_SLACK || sfi_bridge_any(&rule->bridge);
    int masked = is_masked(g);
    g->total = (uint64_t)g->site.lattice.nz *
               (uint64_t)(2 + masked + has_field + find_kinds(&rule->bridge, kinds));
    SF_TRY(sf_grid_clone(g->site.grid, &g->site.allocator, &g->result));
    if (masked) {
        SF_TRY(find_possible(g));
    }
    SF_TRY(sf_grid_create(&g->site.lattice, &g->site.allocator, &g->alive));
    sf_grid *check = g->alive;
    if (has_field) {
        SF_TRY(sfi_codes_create(&g->site, &g->codes));
        sfi_field field = {g->alive, NULL, g->codes, NULL};
        SF_TRY(fill_field(g, &field, g->site.grid));
    } else {
        g->alive = NULL; // the bits of the shape tell; its memory is for the check
    }
    sf_status status = create_run(g);
    status = status == SF_OK ? fill_prices(g) : status;
    status = status == SF_OK ? run_all(g) : status;
    g->alive = check;
    SF_TRY(status);
    sfi_field field = {g->alive, NULL, g->codes, NULL};
    SF_TRY(fill_field(g, &field, g->result));
    return sf_grid_equal(g->alive, g->result) ? SF_OK : SF_ERR_INTERNAL;
}

static void growth_clear(sfi_growth *g)
{
    const sf_allocator *a = &g->site.allocator;
    uint32_t nz = g->site.lattice.nz;
    sf_grid_destroy(g->possible);
    sf_grid_destroy(g->own);
    sf_grid_destroy(g->alive);
    sf_grid_destroy(g->result);
    sf_grid_destroy(g->bits);
    sfi_codes_destroy(&g->site, g->spare);
    sfi_codes_destroy(&g->site, g->codes);
    sfi_free_array(a, g->price, g->area * (nz - g->site.bed), sizeof *g->price);
    sfi_free_array(a, g->demand[0], g->area, 1);
    sfi_free_array(a, g->demand[1], g->area, 1);
    sfi_grow_cover_destroy(&g->cover);
}

// ---------------------------------------------------------------------------------------------
// The call
// ---------------------------------------------------------------------------------------------

static sf_status check_call(const sf_grid *grid, const sf_terms *terms, const sf_grid *culprits,
                            sfi_ground *ground)
{
    SF_TRY(sfi_terms_check(terms, grid, ground));
    if (grid == culprits || grid == terms->exempt || grid == terms->keep || grid == terms->forbid ||
        grid == terms->act) {
        return SF_ERR_ARGUMENT;
    }
    return culprits != NULL ? sfi_terms_match(&ground->lattice, culprits) : SF_OK;
}

// What of the shape cannot be had.
static void name_culprits(const sfi_growth *g, sf_grid *culprits)
{
    for (uint32_t k = 0; culprits != NULL && k < g->site.lattice.nz; k++) {
        (void)!sf_slice_subtract(sf_grid_slice(culprits, k), sf_grid_slice(g->site.grid, k),
                                 sf_grid_slice(g->possible, k));
    }
}

sf_status sf_grid_grow(sf_grid *grid, const sf_terms *terms, const sf_allocator *allocator,
                       sf_task *task, sf_grid *culprits, sf_grow_report *report)
{
    sfi_ground ground;
    SF_TRY(check_call(grid, terms, culprits, &ground));
    sf_grow_report counts = {sf_grid_popcount(grid), 0, SF_BED_AUTO};
    if (sf_task_is_cancelled(task)) {
        return SF_ERR_CANCELLED;
    }
    if (ground.bed < ground.lattice.nz) {
        sfi_growth g = {.task = task, .progress = sfi_progress_begin(task)};
        sfi_site_place(&g.site, grid, terms, &ground, allocator);
        g.area = (size_t)ground.lattice.nx * ground.lattice.ny; // fits: less than the grid's bits
        sf_status status = grow(&g);
        if (status == SF_OK) {
            copy_grid(grid, g.result);
            counts.added_voxels = sf_grid_popcount(grid) - counts.kept_voxels;
            counts.bed_layer = ground.bed;
        } else if (status == SF_ERR_INFEASIBLE) {
            name_culprits(&g, culprits);
        }
        growth_clear(&g);
        SF_TRY(status);
    }
    if (report != NULL) {
        *report = counts;
    }
    return SF_OK;
}

// SPDX-License-Identifier: MIT
// Price map: how many voxels must be added to have a voxel solid and carried.
//
//     F_bed(v) = 0 if v is solid, else 1
//     F_k(v)   = 0 if v is solid, else 1 + min over u in N_k(v): F_{k-1}(u)
//
// and none where v may not be added. It is the cost map of the closest supporting path, shifted by
// one: a chain ends at the first matter that it meets, or on the bed. What matter it meets does not
// count: whether that is carried is a question of its own.
//
// N_k is the element of the step, so this serves every rule that is an element. Under slack it is
// the part of the element that a voxel without any slack reaches, so that a chain may follow
// another voxel of a chain wherever it goes: the price is what such chains cost, and at least what
// the cheapest of all costs.
//
// A minimum over an element, row by row: for a row below, the running minimum over |dx| <= w is
// widened by a voxel at a time, and goes out to the rows dy away as soon as w has reached
// half_width[|dy|]. That is one pass over sixteen-bit numbers for each column and row of the
// element, which compilers turn into vectors. Numbers saturate at 65534.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, section 2.2, with the cost reset to zero at matter (ALGORITHMS 2.1).

#include "support/check/price_map.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/carry.h"
#include "support/rule/terms.h"
#include "voxel/slice.h"

sf_status sfi_price_map_element(const sf_rule *rule, uint32_t k, sf_element *element)
{
    SF_TRY(sf_rule_element(rule, k, element));
    if (rule->kind != SF_RULE_SLACK) {
        return SF_OK;
    }
    uint32_t gain = sfi_slack_gain(rule, k);
    for (uint32_t dy = 0; dy <= element->reach_y; dy++) {
        if (sfi_slack_cost(rule, 0, dy) > gain) {
            element->reach_y = (uint16_t)(dy - 1); // dy > 0: straight down costs nothing
            break;
        }
        while (sfi_slack_cost(rule, element->half_width[dy], dy) > gain) {
            element->half_width[dy]--;
        }
    }
    return SF_OK;
}

// to = min(to, from), number by number.
static void lower(uint16_t *restrict to, const uint16_t *restrict from, size_t count)
{
    for (size_t x = 0; x < count; x++) {
        to[x] = from[x] < to[x] ? from[x] : to[x];
    }
}

// A row with SF_REACH_MAX empty places on either side, and its running minimum.
typedef struct rows {
    uint16_t *wide, *least;
    size_t wide_count, least_count;
} rows;

// Hand a row of prices on to all rows of the next layer that the element lets it carry.
static void spread_row(const uint16_t *in, uint16_t *layer, uint32_t y, const sf_lattice *lattice,
                       size_t stride, const sf_element *element, rows *scratch)
{
    uint16_t *row = scratch->wide + SF_REACH_MAX;
    for (uint32_t x = 0; x < lattice->nx; x++) {
        row[x] = scratch->least[x] = in[x];
    }
    for (uint32_t dy = element->reach_y + 1u, w = 0; dy-- > 0;) {
        for (; w < element->half_width[dy]; w++) {
            lower(scratch->least, row - w - 1, lattice->nx);
            lower(scratch->least, row + w + 1, lattice->nx);
        }
        if (y >= dy) {
            lower(layer + (y - dy) * stride, scratch->least, lattice->nx);
        }
        if (dy > 0 && lattice->ny - y > dy) {
            lower(layer + (y + dy) * stride, scratch->least, lattice->nx);
        }
    }
}

static uint64_t word_of(sf_slice slice, uint32_t y, size_t i, uint64_t without)
{
    return slice.words != NULL ? sfi_slice_row(slice, y)[i] : without;
}

// What a row costs once what lies below is known: matter nothing, what may not be added more than
// there is.
static void settle_row(uint16_t *row, sf_slice solid, sf_slice forbid, sf_slice act, uint32_t y)
{
    for (uint32_t x0 = 0; x0 < solid.width; x0 += 64) {
        size_t i = x0 / 64;
        uint64_t in = sfi_slice_row(solid, y)[i];
        uint64_t barred = word_of(forbid, y, i, 0) | ~word_of(act, y, i, ~UINT64_C(0));
        uint32_t end = solid.width - x0 < 64 ? solid.width - x0 : 64;
        for (uint32_t b = 0; b < end; b++) {
            uint32_t price = row[x0 + b];
            price += price < SFI_PRICE_MAP_NONE - 1;
            price = (barred >> b & 1) != 0 ? SFI_PRICE_MAP_NONE : price;
            row[x0 + b] = (uint16_t)((in >> b & 1) != 0 ? 0 : price);
        }
    }
}

static sf_status price_layer(const sfi_price_map *prices, const sf_grid *grid,
                             const sf_terms *terms, uint32_t k, rows *scratch)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    size_t layer_size = prices->height * prices->stride;
    uint16_t *layer = prices->values + (k - prices->bed) * layer_size;
    for (size_t i = 0; i < layer_size; i++) {
        layer[i] = k == prices->bed ? 0 : SFI_PRICE_MAP_NONE;
    }
    if (k > prices->bed) {
        sf_element element;
        SF_TRY(sfi_price_map_element(&terms->rule, k - 1, &element));
        for (uint32_t y = 0; y < lattice.ny; y++) {
            spread_row(sfi_price_map_row(prices, k - 1, y), layer, y, &lattice, prices->stride,
                       &element, scratch);
        }
    }
    sf_slice solid = sf_grid_slice(grid, k);
    sf_slice forbid = sfi_mask_slice(terms->forbid, k), act = sfi_mask_slice(terms->act, k);
    for (uint32_t y = 0; y < lattice.ny; y++) {
        settle_row(layer + y * prices->stride, solid, forbid, act, y);
    }
    return SF_OK;
}

static sf_status price_all(const sfi_price_map *prices, const sf_grid *grid, const sf_terms *terms,
                           sf_task *task, rows *scratch)
{
    for (size_t i = 0; i < scratch->wide_count; i++) {
        scratch->wide[i] = SFI_PRICE_MAP_NONE;
    }
    for (uint32_t k = prices->bed; k < prices->top; k++) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        SF_TRY(price_layer(prices, grid, terms, k, scratch));
    }
    return SF_OK;
}

sf_status sfi_price_map_create(const sf_grid *grid, const sf_terms *terms, uint32_t bed,
                               uint32_t top, const sf_allocator *allocator, sf_task *task,
                               sfi_price_map *prices)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    sfi_price_map made = {NULL, 0, bed, top, lattice.ny, 0};
    if (top <= bed) {
        made.top = bed;
        *prices = made;
        return SF_OK;
    }
    if (!sfi_size_align(lattice.nx, SFI_ALIGN / sizeof *made.values, &made.stride) ||
        !sfi_size_mul(made.stride, lattice.ny, &made.count) ||
        !sfi_size_mul(made.count, top - bed, &made.count)) {
        return SF_ERR_OVERFLOW;
    }
    rows scratch = {NULL, NULL, (size_t)lattice.nx + 2 * SF_REACH_MAX, lattice.nx};
    made.values = sfi_alloc_array(allocator, made.count, sizeof *made.values);
    scratch.wide = sfi_alloc_array(allocator, scratch.wide_count, sizeof *scratch.wide);
    scratch.least = sfi_alloc_array(allocator, scratch.least_count, sizeof *scratch.least);
    sf_status status = SF_ERR_MEMORY;
    if (made.values != NULL && scratch.wide != NULL && scratch.least != NULL) {
        status = price_all(&made, grid, terms, task, &scratch);
    }
    sfi_free_array(allocator, scratch.wide, scratch.wide_count, sizeof *scratch.wide);
    sfi_free_array(allocator, scratch.least, scratch.least_count, sizeof *scratch.least);
    if (status != SF_OK) {
        sfi_price_map_destroy(&made, allocator);
        return status;
    }
    *prices = made;
    return SF_OK;
}

void sfi_price_map_destroy(sfi_price_map *prices, const sf_allocator *allocator)
{
    sfi_free_array(allocator, prices->values, prices->count, sizeof *prices->values);
    prices->values = NULL;
}

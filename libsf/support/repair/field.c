// SPDX-License-Identifier: MIT
// Fields: how much slack is left where, within what a price map holds.
//
// The forest asks two things of slack. A root carries a node only with the slack that the roots
// have by themselves. What a supporter can be given at most is that of the whole room; a forest by
// demand goes by that, where one by label goes by the chain that its price was found along.
//
// A root may be asked for more than it has by itself. It then is a node like any other, which costs
// nothing and needs a supporter; so whatever the room can carry, a forest by demand can.

#include "support/repair/repair.h"

#include "base/status.h"
#include "support/rule/carry.h"

// Codes of layer k, within its rectangle.
static void keep_codes(const sfi_job *job, const sfi_front *front, const sfi_price *p, uint32_t k,
                       uint8_t *codes)
{
    sf_rect r = p->rects[k];
    size_t stride = sfi_slack_stride(job->lattice.nx);
    for (uint32_t y = r.y0; y < r.y1; y++) {
        const uint8_t *in = front->slack + y * stride;
        uint8_t *out = sfi_price_codes(p, codes, k, y);
        for (uint32_t x = r.x0; x < r.x1; x++) {
            out[x] = in[x];
        }
    }
}

static sf_status sweep_field(const sfi_job *job, const sfi_price *p, const sf_grid *grid,
                             const sfi_carrier *carrier, const sfi_front *fronts, uint8_t *codes)
{
    sfi_sweep sweep = sfi_sweep_begin(job->pace, p->top - job->bed);
    for (uint32_t k = job->bed; k < p->top; k++) {
        sf_slice solid = sf_grid_slice(grid, k), exempt = sfi_mask_slice(job->exempt, k);
        const sfi_front *front = &fronts[k % 2], *below = &fronts[(k + 1) % 2];
        SF_TRY(sfi_sweep_layer(&sweep));
        SF_TRY(sfi_carry_layer(carrier, k, job->bed, below, solid, exempt, *front, SFI_NO_SLICE));
        keep_codes(job, front, p, k, codes);
    }
    return SF_OK;
}

sf_status sfi_price_field(const sfi_job *job, const sfi_price *price, const sf_grid *grid,
                          uint8_t *codes)
{
    uint32_t nx = job->lattice.nx, ny = job->lattice.ny;
    sfi_carrier carrier = {0};
    sfi_front fronts[2] = {{SFI_NO_SLICE, NULL}, {SFI_NO_SLICE, NULL}};
    sf_status status = sfi_carrier_create(&job->rule, nx, ny, job->allocator, &carrier);
    for (int i = 0; status == SF_OK && i < 2; i++) {
        status = sfi_front_create(&job->rule, nx, ny, job->allocator, &fronts[i]);
    }
    if (status == SF_OK) {
        status = sweep_field(job, price, grid, &carrier, fronts, codes);
    }
    sfi_front_destroy(&fronts[0], &job->rule, job->allocator);
    sfi_front_destroy(&fronts[1], &job->rule, job->allocator);
    sfi_carrier_destroy(&carrier, job->allocator);
    return status;
}

sf_status sfi_price_by_demand(const sfi_job *job, sfi_price *price)
{
    if (price->count == 0) {
        return SF_OK;
    }
    SF_TRY(sfi_price_field(job, price, job->room, price->codes));
    for (size_t i = 0; i < price->count; i++) {
        // A label may have run out of reach where another chain has not.
        int is_unpriced = price->prices[i] == SFI_PRICE_NONE && price->codes[i] > 0;
        price->prices[i] = (int16_t)(is_unpriced ? SFI_PRICE_MOST : price->prices[i]);
    }
    return SF_OK;
}

sf_rule sfi_careful_rule(const sfi_job *job)
{
    return sfi_rule_plain(&job->rule, job->lattice.nz);
}

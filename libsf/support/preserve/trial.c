// SPDX-License-Identifier: MIT
// Trial: matter taken from a shape on probation, and what that does to the layer above.
//
// Every voxel that is lowered or removed is noted with what it was, so a trial that ends badly is
// undone in the time that it took.
//
// Under slack most trials change a voxel or two of each layer, for many layers. So what rises from
// layer to layer is not a front but the list of losses: a voxel v above a loss u has to be looked
// at only where what u handed on before, its code and the gain less the cost, is what v has; and v
// is done as soon as another below hands on as much. Both are a few bytes of the codes around.
//
// Bridges are kept out of it: while every voxel that was reached is reached still, the gaps between
// them are what they were; where one is not, the caller computes the layer as a front.

#include "support/preserve/trial.h"

#include "base/bytes.h"
#include "base/memory.h"
#include "base/status.h"
#include "support/rule/carry.h"
#include "voxel/slice.h"

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

static size_t code_layers(const sfi_trial *t)
{
    return t->lattice.nz - t->first;
}

sf_status sfi_trial_create(sfi_trial *trial, sf_grid *grid, const sf_terms *terms, uint32_t first,
                           const sf_allocator *allocator)
{
    const sf_rule *rule = &terms->rule;
    memset(trial, 0, sizeof *trial);
    trial->grid = grid;
    trial->terms = terms;
    trial->lattice = sf_grid_lattice(grid);
    trial->first = first;
    trial->allocator = sfi_allocator_or_default(allocator);
    if (rule->kind != SF_RULE_SLACK) {
        return SF_OK;
    }
    if (rule->table == NULL) {
        SF_TRY(sf_rule_element(rule, 0, &trial->element));
    }
    for (uint32_t dy = 0; dy <= SFI_SLACK_REACH_MAX; dy++) {
        for (uint32_t dx = 0; dx <= SFI_SLACK_REACH_MAX; dx++) {
            uint32_t cost = sfi_slack_cost(rule, dx, dy);
            trial->costs[dy][dx] = (uint8_t)(cost < 255 ? cost : 255);
        }
    }
    trial->layer_bytes = sfi_slack_stride(trial->lattice.nx) * trial->lattice.ny;
    trial->codes = sfi_alloc_array(&trial->allocator, code_layers(trial), trial->layer_bytes);
    return trial->codes != NULL ? SF_OK : SF_ERR_MEMORY;
}

void sfi_trial_destroy(sfi_trial *trial)
{
    const sf_allocator *a = &trial->allocator;
    sfi_free_array(a, trial->codes, code_layers(trial), trial->layer_bytes);
    sfi_free_array(a, trial->losses, trial->capacity, sizeof *trial->losses);
    trial->codes = NULL;
    trial->losses = NULL;
    trial->capacity = trial->count = 0;
}

uint8_t *sfi_trial_codes(const sfi_trial *trial, uint32_t k, uint32_t y)
{
    return trial->codes + (k - trial->first) * trial->layer_bytes +
           y * sfi_slack_stride(trial->lattice.nx);
}

sf_status sfi_trial_element(const sfi_trial *trial, uint32_t k, sf_element *element)
{
    if (trial->codes == NULL || trial->terms->rule.table != NULL) {
        return sf_rule_element(&trial->terms->rule, k, element);
    }
    *element = trial->element;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Losses
// ---------------------------------------------------------------------------------------------

static uint64_t *word_at(const sfi_trial *t, uint32_t k, uint32_t y, uint32_t x)
{
    return &sfi_slice_row(sf_grid_slice(t->grid, k), y)[x / 64];
}

sf_status sfi_trial_lower(sfi_trial *trial, uint32_t k, uint32_t y, uint32_t x, uint8_t code)
{
    void *memory = trial->losses;
    if (!sfi_grow_array(&trial->allocator, &memory, &trial->capacity, trial->count + 1,
                        sizeof *trial->losses)) {
        return SF_ERR_MEMORY;
    }
    trial->losses = memory;
    sfi_loss was = {k, y, x, 1};
    if (trial->codes != NULL) {
        uint8_t *now = &sfi_trial_codes(trial, k, y)[x];
        was.code = *now;
        *now = code;
    }
    trial->losses[trial->count++] = was;
    if (code == 0) {
        *word_at(trial, k, y, x) &= ~(UINT64_C(1) << (x % 64));
    }
    return SF_OK;
}

void sfi_trial_undo(sfi_trial *trial)
{
    while (trial->count > 0) {
        const sfi_loss *was = &trial->losses[--trial->count];
        if (trial->codes != NULL) {
            sfi_trial_codes(trial, was->z, was->y)[was->x] = was->code;
        }
        *word_at(trial, was->z, was->y, was->x) |= UINT64_C(1) << (was->x % 64);
    }
}

void sfi_trial_begin(sfi_trial *trial)
{
    trial->count = 0;
}

// ---------------------------------------------------------------------------------------------
// One layer higher
// ---------------------------------------------------------------------------------------------

// The step from layer k - 1 to layer k.
typedef struct rise {
    sfi_trial *trial;
    uint32_t k, gain, top; // top: the code of the cap
    sf_element element;
} rise;

// What a voxel with that code hands on at a cost.
static uint32_t offer(const rise *r, uint8_t code, uint8_t cost)
{
    uint32_t sum = code + r->gain;
    if (code == 0 || sum <= cost) {
        return 0;
    }
    return sum - cost < r->top ? sum - cost : r->top;
}

// The columns of a row that an element with that half width meets around x.
static void columns(const rise *r, uint32_t x, uint32_t w, uint32_t *x0, uint32_t *x1)
{
    uint32_t nx = r->trial->lattice.nx;
    *x0 = x > w ? x - w : 0;
    *x1 = nx - x > w ? x + w + 1 : nx;
}

static uint32_t first_row(const rise *r, uint32_t y)
{
    return y > r->element.reach_y ? y - r->element.reach_y : 0;
}

static uint32_t end_row(const rise *r, uint32_t y)
{
    uint32_t ny = r->trial->lattice.ny;
    return ny - y > r->element.reach_y ? y + r->element.reach_y + 1u : ny;
}

static uint32_t between(uint32_t a, uint32_t b)
{
    return a > b ? a - b : b - a;
}

// The most that is handed on to (x, y) from below; it ends at `enough`, which is the most there
// was.
static uint32_t reached(const rise *r, uint32_t y, uint32_t x, uint32_t enough)
{
    uint32_t best = 0;
    sf_slice exempt = sfi_mask_slice(r->trial->terms->exempt, r->k);
    if (exempt.words != NULL && sf_slice_get(exempt, x, y)) {
        best = 1;
    }
    for (uint32_t v = first_row(r, y); best < enough && v < end_row(r, y); v++) {
        const uint8_t *below = sfi_trial_codes(r->trial, r->k - 1, v);
        uint32_t dy = between(v, y), u, end;
        for (columns(r, x, r->element.half_width[dy], &u, &end); u < end; u++) {
            uint32_t code = offer(r, below[u], r->trial->costs[dy][between(u, x)]);
            best = code > best ? code : best;
        }
    }
    return best < enough ? best : enough;
}

// Look at all above one loss.
static sf_status rise_from(const rise *r, sfi_loss loss, int *died)
{
    for (uint32_t y = first_row(r, loss.y); y < end_row(r, loss.y); y++) {
        const uint8_t *codes = sfi_trial_codes(r->trial, r->k, y);
        uint32_t dy = between(y, loss.y), x, end;
        for (columns(r, loss.x, r->element.half_width[dy], &x, &end); x < end; x++) {
            uint32_t was = offer(r, loss.code, r->trial->costs[dy][between(x, loss.x)]);
            if (codes[x] == 0 || was == 0 || was < codes[x]) {
                continue;
            }
            uint32_t now = reached(r, y, x, codes[x]);
            if (now == 0) {
                *died = 1;
                return SF_OK;
            }
            if (now < codes[x]) {
                SF_TRY(sfi_trial_lower(r->trial, r->k, y, x, (uint8_t)now));
            }
        }
    }
    return SF_OK;
}

sf_status sfi_trial_rise(sfi_trial *trial, uint32_t k, size_t from, int *died)
{
    const sf_rule *rule = &trial->terms->rule;
    rise r = {.trial = trial, .k = k};
    size_t end = trial->count;
    r.gain = sfi_slack_gain(rule, k - 1);
    r.top = rule->slack_cap + 1u;
    SF_TRY(sfi_trial_element(trial, k - 1, &r.element));
    for (size_t i = from; i < end && !*died; i++) {
        SF_TRY(rise_from(&r, trial->losses[i], died));
    }
    return SF_OK;
}

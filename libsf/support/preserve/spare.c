// SPDX-License-Identifier: MIT
// Spare: which voxels of a support-free shape are not needed, tried one by one.
//
// Taking a voxel u out of V' is allowed when all that must stay, F, lies within trim(V' \ u). One
// pass over the voxels, in any order, leaves a set from which none can be taken: who was refused
// was needed in a larger V', and a trim is monotone, so it is needed in the smaller one as well.
//
// The trial is a trim of what can have changed, as in trim_box.c: from u upwards, in a rectangle
// around what did change, grown by the step's element and by what a bridge reaches; it ends at the
// first layer where nothing changed, or when a voxel of F dies. Then all is put back from a journal
// of the voxels that were touched. Under slack what changes is the codes, so all of them are kept,
// a byte for each voxel, from the lowest layer on that has something to spare.
//
// Windows begin and end with words. A window is computed in a small front of its own, because codes
// of a front have the stride of its width.

#include "support/preserve/spare.h"

#include "base/bits.h"
#include "base/bytes.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/carry.h"
#include "voxel/rect.h"
#include "voxel/slice.h"

// What a voxel was.
typedef struct entry {
    uint32_t z, y, x;
    uint8_t code; // under slack; 1 else
} entry;

typedef struct sparing {
    sf_grid *grid;
    const sf_grid *needed;
    const sf_terms *terms;
    sf_lattice lattice;
    uint32_t bed, first; // the lowest layer that is looked at
    uint32_t margin;     // what a bridge reaches within its layer
    sf_allocator allocator;
    uint8_t *codes; // under slack: of layers from `first` on
    size_t layer_bytes;
    void *memory[3]; // for a carrier and two fronts of the whole width
    size_t sizes[3];
    entry *journal;
    size_t count, capacity;
} sparing;

static uint8_t *codes_at(const sparing *s, uint32_t k, uint32_t y)
{
    return s->codes + (k - s->first) * s->layer_bytes + y * sfi_slack_stride(s->lattice.nx);
}

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

static uint32_t bridge_margin(const sf_bridge *b)
{
    uint32_t x = (uint32_t)b->span_x + b->anchor_x, y = (uint32_t)b->span_y + b->anchor_y;
    uint32_t d = (uint32_t)b->span_diagonal + b->anchor_diagonal, most = x > y ? x : y;
    return sfi_bridge_any(b) ? (d > most ? d : most) + 1 : 0;
}

// The first layer that has a voxel which is not needed; nz where none has.
static uint32_t first_to_spare(const sparing *s)
{
    for (uint32_t k = 0; k < s->lattice.nz; k++) {
        sf_slice all = sf_grid_slice(s->grid, k), must = sf_grid_slice(s->needed, k);
        if (!sf_slice_equal(all, must)) {
            return k;
        }
    }
    return s->lattice.nz;
}

static sf_status create(sparing *s)
{
    const sf_rule *rule = &s->terms->rule;
    uint32_t nx = s->lattice.nx, ny = s->lattice.ny;
    if (!sfi_carrier_size(rule, nx, ny, &s->sizes[0]) ||
        !sfi_front_size(rule, nx, ny, &s->sizes[1])) {
        return SF_ERR_OVERFLOW;
    }
    s->sizes[2] = s->sizes[1];
    for (int i = 0; i < 3; i++) {
        s->memory[i] = s->sizes[i] > 0 ? sfi_alloc_array(&s->allocator, 1, s->sizes[i]) : NULL;
        if (s->sizes[i] > 0 && s->memory[i] == NULL) {
            return SF_ERR_MEMORY;
        }
    }
    s->layer_bytes = sfi_slack_stride(nx) * ny;
    if (rule->kind == SF_RULE_SLACK) {
        s->codes = sfi_alloc_array(&s->allocator, s->lattice.nz - s->first, s->layer_bytes);
    }
    return rule->kind == SF_RULE_SLACK && s->codes == NULL ? SF_ERR_MEMORY : SF_OK;
}

static void destroy(sparing *s)
{
    for (int i = 0; i < 3; i++) {
        sfi_free_array(&s->allocator, s->memory[i], 1, s->sizes[i]);
    }
    sfi_free_array(&s->allocator, s->codes, s->lattice.nz - s->first, s->layer_bytes);
    sfi_free_array(&s->allocator, s->journal, s->capacity, sizeof *s->journal);
}

// Codes of the whole grid, those from `first` on kept.
static sf_status fill_codes(sparing *s)
{
    const sf_rule *rule = &s->terms->rule;
    uint32_t nx = s->lattice.nx, ny = s->lattice.ny;
    if (s->codes == NULL) {
        return SF_OK;
    }
    sfi_carrier carrier = sfi_carrier_place(rule, nx, ny, s->memory[0]);
    sfi_front fronts[2] = {sfi_front_place(rule, nx, ny, s->memory[1]),
                           sfi_front_place(rule, nx, ny, s->memory[2])};
    for (uint32_t k = s->bed; k < s->lattice.nz; k++) {
        sf_slice solid = sf_grid_slice(s->grid, k), exempt = sfi_mask_slice(s->terms->exempt, k);
        sfi_front front = fronts[k % 2];
        SF_TRY(k == s->bed ? sfi_carry_bed(&carrier, solid, front)
                           : sfi_carry(&carrier, k, &fronts[(k + 1) % 2], solid, exempt, front,
                                       SFI_NO_SLICE));
        if (k >= s->first) {
            memcpy(codes_at(s, k, 0), front.slack, s->layer_bytes);
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Journal
// ---------------------------------------------------------------------------------------------

static uint64_t *word_at(const sparing *s, uint32_t k, uint32_t y, uint32_t x)
{
    return &sfi_slice_row(sf_grid_slice(s->grid, k), y)[x / 64];
}

// Voxel (x, y) of layer k gets a lower code; 0 removes it.
static sf_status lower(sparing *s, uint32_t k, uint32_t y, uint32_t x, uint8_t code)
{
    void *memory = s->journal;
    if (!sfi_grow_array(&s->allocator, &memory, &s->capacity, s->count + 1, sizeof *s->journal)) {
        return SF_ERR_MEMORY;
    }
    s->journal = memory;
    entry was = {k, y, x, 1};
    if (s->codes != NULL) {
        was.code = codes_at(s, k, y)[x];
        codes_at(s, k, y)[x] = code;
    }
    s->journal[s->count++] = was;
    if (code == 0) {
        *word_at(s, k, y, x) &= ~(UINT64_C(1) << (x % 64));
    }
    return SF_OK;
}

static void put_back(sparing *s)
{
    while (s->count > 0) {
        const entry *was = &s->journal[--s->count];
        if (s->codes != NULL) {
            codes_at(s, was->z, was->y)[was->x] = was->code;
        }
        *word_at(s, was->z, was->y, was->x) |= UINT64_C(1) << (was->x % 64);
    }
}

// ---------------------------------------------------------------------------------------------
// A trial
// ---------------------------------------------------------------------------------------------

// The front of layer k in a window, on what stands below: right within it but for a margin.
static sf_status compute(const sparing *s, uint32_t k, sf_rect part, sfi_front *front)
{
    const sf_rule *rule = &s->terms->rule;
    uint32_t width = part.x1 - part.x0, height = part.y1 - part.y0;
    sfi_carrier carrier = sfi_carrier_place(rule, width, height, s->memory[0]);
    sfi_front below = sfi_front_place(rule, width, height, s->memory[1]);
    *front = sfi_front_place(rule, width, height, s->memory[2]);
    SF_TRY(sf_slice_copy(below.alive, sfi_slice_window(sf_grid_slice(s->grid, k - 1), part)));
    for (uint32_t y = 0; s->codes != NULL && y < height; y++) {
        const uint8_t *from = codes_at(s, k - 1, part.y0 + y) + part.x0;
        uint8_t *to = below.slack + y * sfi_slack_stride(width);
        memcpy(to, from, width);
    }
    return sfi_carry(&carrier, k, &below, sfi_slice_window(sf_grid_slice(s->grid, k), part),
                     sfi_slice_window(sfi_mask_slice(s->terms->exempt, k), part), *front,
                     SFI_NO_SLICE);
}

static void widen(sf_rect *r, uint32_t x, uint32_t y)
{
    sf_rect one = {x, y, x + 1, y + 1};
    if (sfi_rect_is_empty(*r)) {
        *r = one;
        return;
    }
    r->x0 = x < r->x0 ? x : r->x0;
    r->x1 = x >= r->x1 ? x + 1 : r->x1;
    r->y0 = y < r->y0 ? y : r->y0;
    r->y1 = y >= r->y1 ? y + 1 : r->y1;
}

// Bring layer k to what the front of `part` says within r; `changed` is the rectangle around what
// changed. *lost: a voxel that is needed died.
static sf_status commit(sparing *s, uint32_t k, sf_rect part, sf_rect r, const sfi_front *front,
                        sf_rect *changed, int *lost)
{
    sf_slice must = sf_grid_slice(s->needed, k), solid = sf_grid_slice(s->grid, k);
    size_t stride = sfi_slack_stride(part.x1 - part.x0);
    for (uint32_t y = r.y0; y < r.y1; y++) {
        const uint64_t *alive = sfi_slice_row(front->alive, y - part.y0);
        for (uint32_t x = r.x0; x < r.x1; x++) {
            if (!(sfi_slice_row(solid, y)[x / 64] >> (x % 64) & 1)) {
                continue;
            }
            uint8_t now = (uint8_t)(alive[(x - part.x0) / 64] >> (x % 64) & 1), was = 1;
            if (s->codes != NULL) {
                now = front->slack[(y - part.y0) * stride + (x - part.x0)];
                was = codes_at(s, k, y)[x];
            }
            if (now == was) {
                continue;
            }
            if (now == 0 && (sfi_slice_row(must, y)[x / 64] >> (x % 64) & 1)) {
                *lost = 1;
                return SF_OK;
            }
            SF_TRY(lower(s, k, y, x, now));
            widen(changed, x, y);
        }
    }
    return SF_OK;
}

// Trim what changed in layer k and above.
static sf_status follow(sparing *s, uint32_t k, sf_rect dirty, int *lost)
{
    sf_rect edited = dirty;
    // In its own layer a voxel matters to bridges only.
    uint32_t first = s->margin > 0 && k > s->bed ? k : k + 1;
    for (uint32_t j = first; j < s->lattice.nz && !*lost; j++) {
        sf_element e;
        sfi_front front;
        SF_TRY(sf_rule_element(&s->terms->rule, j - 1, &e));
        sf_slice layer = sf_grid_slice(s->grid, j);
        uint32_t rx = e.half_width[0] + s->margin, ry = e.reach_y + s->margin;
        sf_rect r = j > k ? sfi_rect_grow(dirty, rx, ry, layer)
                          : sfi_rect_grow(dirty, s->margin, s->margin, layer);
        sf_rect part = sfi_rect_align(sfi_rect_grow(r, rx, ry, layer), layer);
        sf_rect changed = {0, 0, 0, 0};
        SF_TRY(compute(s, j, part, &front));
        SF_TRY(commit(s, j, part, r, &front, &changed, lost));
        if (j == k) { // the voxel itself has changed
            widen(&changed, edited.x0, edited.y0);
        }
        if (sfi_rect_is_empty(changed)) {
            break;
        }
        dirty = changed;
    }
    return SF_OK;
}

static sf_status try_voxel(sparing *s, uint32_t k, uint32_t y, uint32_t x)
{
    sf_rect dirty = {x, y, x + 1, y + 1};
    int lost = 0;
    s->count = 0;
    SF_TRY(lower(s, k, y, x, 0));
    SF_TRY(follow(s, k, dirty, &lost));
    if (lost) {
        put_back(s);
    }
    return SF_OK;
}

static sf_status try_layer(sparing *s, uint32_t k)
{
    sf_slice solid = sf_grid_slice(s->grid, k), must = sf_grid_slice(s->needed, k);
    for (uint32_t y = 0; y < solid.height; y++) {
        const uint64_t *row = sfi_slice_row(solid, y), *stay = sfi_slice_row(must, y);
        for (size_t i = 0; i < sfi_row_words(solid.width); i++) {
            // What is tried may take others of its layer with it, so the row is read again.
            uint64_t tried = 0, word;
            while ((word = row[i] & ~stay[i] & ~tried) != 0) {
                uint64_t bit = word & (~word + 1);
                tried |= bit;
                SF_TRY(try_voxel(s, k, y, (uint32_t)i * 64 + sfi_lowest_bit(bit)));
            }
        }
    }
    return SF_OK;
}

sf_status sfi_spare(sf_grid *grid, const sf_grid *needed, const sf_terms *terms, uint32_t bed,
                    const sf_allocator *allocator, sf_task *task)
{
    sparing s = {.grid = grid, .needed = needed, .terms = terms, .bed = bed};
    s.lattice = sf_grid_lattice(grid);
    s.allocator = sfi_allocator_or_default(allocator);
    s.margin = bridge_margin(&terms->rule.bridge);
    s.first = first_to_spare(&s);
    if (s.first == s.lattice.nz) {
        return SF_OK;
    }
    // A bridge's layer is computed on the one below, whose codes are needed too.
    s.first = s.first > 0 ? s.first - 1 : 0;
    sf_status status = create(&s);
    if (status == SF_OK) {
        status = fill_codes(&s);
    }
    for (uint32_t k = s.lattice.nz; status == SF_OK && k-- > s.first;) {
        status = sf_task_is_cancelled(task) ? SF_ERR_CANCELLED : try_layer(&s, k);
    }
    destroy(&s);
    return status;
}

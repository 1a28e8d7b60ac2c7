// SPDX-License-Identifier: MIT
// Smooth-trim: what most of its neighbours are, a voxel becomes; then what hangs is trimmed.
//
// In the union of the tips, pass after pass for all voxels at once, a voxel is solid just when at
// least 14 of the 27 around it are, itself among them; 14 is more than half. What is around a
// voxel reaches into what the last call changed, so each call begins anew with the state before the
// stroke.
//
// Sixty-four voxels are counted at once. The nine rows around a row give 27 words, a bit of each
// for each voxel; full adders add them up in bits of weight 1, 2, 4, 8 and 16. A pass goes up layer
// by layer in place, and keeps what the layers below and here were before it.
//
// A voxel that becomes solid takes the material that most of the solid ones around it have, of
// equals the lowest; one that stays keeps its own. Bytes are written only where a voxel was empty
// when the pass began, and read only where one was solid, so they need no copies.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, section 2.2 (a voxel's density by the average of those around it); the bound
// and the rest are the library's own.

#include <string.h>

#include "base/memory.h"
#include "base/status.h"
#include "sculpt/model.h"
#include "sculpt/rows.h"
#include "voxel/slice.h"

// Three layers of bits as they were when a pass began, empty where there is none.
typedef struct around {
    sf_slice layers[3];
    uint32_t z; // of the middle one
} around;

// ---------------------------------------------------------------------------------------------
// Counting
// ---------------------------------------------------------------------------------------------

// a, b and c added: the sum stays in *a, the carry is returned.
static uint64_t full_add(uint64_t *a, uint64_t b, uint64_t c)
{
    uint64_t either = *a ^ b, carry = (*a & b) | (either & c);
    *a = either ^ c;
    return carry;
}

// Adds `count` words of one weight into one, and leaves the carries in their place; returns how
// many of these there are.
static int add_up(uint64_t *words, int count, uint64_t *sum)
{
    int carries = 0;
    *sum = words[0];
    for (int i = 1; i < count; i += 2) {
        words[carries++] = full_add(sum, words[i], i + 1 < count ? words[i + 1] : 0);
    }
    return carries;
}

// Bits of the voxels of word i of row y around which at least 14 are solid.
static uint64_t mostly_solid(const around *a, uint32_t y, size_t i)
{
    uint64_t words[27], weight[5] = {0, 0, 0, 0, 0};
    int count = 0;
    for (int layer = 0; layer < 3; layer++) {
        sf_slice s = a->layers[layer];
        for (int dy = -1; dy <= 1 && s.words != NULL; dy++) {
            if ((dy < 0 && y == 0) || (dy > 0 && y + 1 == s.height)) {
                continue;
            }
            const uint64_t *row = sfi_slice_row(s, y + (uint32_t)dy);
            uint64_t before = i > 0 ? row[i - 1] >> 63 : 0;
            uint64_t after = i + 1 < sfi_row_words(s.width) ? row[i + 1] << 63 : 0;
            words[count++] = row[i];
            words[count++] = row[i] << 1 | before;
            words[count++] = row[i] >> 1 | after;
        }
    }
    for (int w = 0; w < 5 && count > 0; w++) {
        count = add_up(words, count, &weight[w]);
    }
    return weight[4] | (weight[3] & weight[2] & weight[1]); // 16 or more; 14 or 15
}

// ---------------------------------------------------------------------------------------------
// Materials
// ---------------------------------------------------------------------------------------------

// The material that most solid voxels around (x, y) have; there are at least 14.
static uint8_t vote(const sf_sculpt *m, const around *a, uint32_t x, uint32_t y)
{
    uint8_t seen[27];
    uint32_t counts[27], kinds = 0, best = 0;
    for (uint32_t n = 0; n < 27; n++) {
        // Unsigned, so one less than 0 lies beyond the grid as well.
        uint32_t px = x + n % 3 - 1, py = y + n / 3 % 3 - 1, pz = a->z + n / 9 - 1;
        if (a->layers[n / 9].words == NULL || !sf_slice_get(a->layers[n / 9], px, py)) {
            continue;
        }
        uint8_t material = sfi_material_row(m, &m->now, py, pz)[px];
        uint32_t k = 0;
        while (k < kinds && seen[k] != material) {
            k++;
        }
        if (k == kinds) {
            seen[kinds] = material;
            counts[kinds++] = 0;
        }
        counts[k]++;
    }
    for (uint32_t k = 1; k < kinds; k++) {
        int is_more = counts[k] > counts[best];
        best = is_more || (counts[k] == counts[best] && seen[k] < seen[best]) ? k : best;
    }
    return seen[best];
}

// ---------------------------------------------------------------------------------------------
// Passes
// ---------------------------------------------------------------------------------------------

static void smooth_row(sf_sculpt *m, const around *a, sf_rect r, uint32_t y)
{
    const uint64_t *u = sfi_slice_row(sf_grid_slice(m->tips, a->z), y);
    const uint64_t *was = sfi_slice_row(a->layers[1], y);
    uint64_t *d = sfi_slice_row(sf_grid_slice(m->now.drawn, a->z), y);
    uint8_t *materials = sfi_material_row(m, &m->now, y, a->z);
    for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
        if (u[i] == 0) {
            continue;
        }
        uint64_t solid = mostly_solid(a, y, i);
        d[i] = (was[i] & ~u[i]) | (solid & u[i]);
        for (uint64_t fresh = d[i] & ~was[i]; fresh != 0; fresh &= fresh - 1) {
            uint32_t x = (uint32_t)i * 64 + sfi_lowest_bit(fresh);
            materials[x] = vote(m, a, x, y);
        }
    }
}

static const sf_slice no_slice = {NULL, 0, 0, 0};

// The rows of a box, and one more on either side.
static void copy_rows(sf_slice to, sf_slice from, sf_box box)
{
    uint32_t y0 = box.y0 > 0 ? box.y0 - 1 : 0, y1 = box.y1 < from.height ? box.y1 + 1 : box.y1;
    memcpy(sfi_slice_row(to, y0), sfi_slice_row(from, y0),
           (size_t)(y1 - y0) * from.stride * sizeof(uint64_t));
}

// One pass. keep[0] and keep[1] are slices to keep layers in as they were.
static void pass(sf_sculpt *m, sf_slice keep[2], sf_box box)
{
    sf_slice low = box.z0 > 0 ? sf_grid_slice(m->now.drawn, box.z0 - 1) : no_slice;
    for (uint32_t z = box.z0; z < box.z1; z++) {
        sf_slice here = sf_grid_slice(m->now.drawn, z), copy = keep[z % 2];
        sf_rect r = m->in_tips.rects[z];
        copy_rows(copy, here, box);
        around a = {{low, copy, sf_grid_slice(m->now.drawn, z + 1)}, z};
        for (uint32_t y = r.y0; y < r.y1; y++) {
            smooth_row(m, &a, r, y);
        }
        low = copy;
    }
}

// Materials of what is empty go; what is solid as it was before the stroke has its own again.
static void settle(sf_sculpt *m)
{
    for (uint32_t z = m->in_tips.z0; z < m->in_tips.z1; z++) {
        sf_slice drawn = sf_grid_slice(m->now.drawn, z);
        sf_slice before = sf_grid_slice(m->before.drawn, z), tips = sf_grid_slice(m->tips, z);
        sf_rect r = m->in_tips.rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            const uint64_t *d = sfi_slice_row(drawn, y), *b = sfi_slice_row(before, y);
            const uint64_t *u = sfi_slice_row(tips, y);
            uint8_t *materials = sfi_material_row(m, &m->now, y, z);
            const uint8_t *were = sfi_material_row(m, &m->before, y, z);
            for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
                sfi_bytes_set(materials, i, u[i] & ~d[i], 0);
                sfi_bytes_copy(materials, were, i, u[i] & d[i] & b[i]);
            }
        }
    }
}

sf_status sfi_brush_smooth(sf_sculpt *m)
{
    sf_box box = sfi_area_bounds(&m->in_tips);
    sfi_touch restored = {m->in_tips, {0, 0, NULL}, m->in_tips};
    sf_slice keep[2] = {sf_grid_slice(m->now.drawn, 0), sf_grid_slice(m->now.drawn, 0)};
    size_t bytes = keep[0].stride * keep[0].height * sizeof(uint64_t);
    uint64_t *words = sfi_alloc_array(&m->scratch, 2, bytes);
    if (words == NULL) {
        return SF_ERR_MEMORY;
    }
    keep[0].words = words;
    keep[1].words = words + bytes / sizeof *words;
    if (!sfi_area_is_empty(&m->touched.drawn) || !sfi_area_is_empty(&m->touched.material)) {
        sfi_drawn_differences(m, &m->in_tips, &m->called); // of earlier calls, which go
        sfi_sculpt_copy(m, &m->now, &m->before, &restored);
    }
    for (uint32_t i = 0; i < m->brush.passes; i++) {
        pass(m, keep, box);
    }
    settle(m);
    sfi_free_array(&m->scratch, words, 2, bytes);
    sfi_drawn_differences(m, &m->in_tips, &m->called);
    return sfi_sculpt_trim(m, &m->in_tips);
}

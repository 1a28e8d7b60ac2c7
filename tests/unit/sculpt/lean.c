// SPDX-License-Identifier: MIT
// What a brace puts into one layer, voxel by voxel (the promise of libsf/sculpt/brace.c that braces
// are what its formula says, for every element): patches are cut to what hangs and to how far away
// something stands, so here are layers in which that is next to it, across the slice, beyond the
// rectangle or nowhere, in slices of a few words, at their borders, layer after layer. Judged by
// distances that are found by asking every voxel about every other one around it, again and again.

#include <sf/sf.h>

#include "base/memory.h"
#include "sculpt/lean.h"
#include "test.h"

#define SIDE_MAX 150
#define AREA (SIDE_MAX * SIDE_MAX)

// A layer as bytes, and what was put into the one above it.
typedef struct one_layer {
    uint32_t nx, ny;
    uint8_t printable[AREA], tips[AREA], tips_above[AREA], added[AREA], fresh[AREA];
    int steps[AREA];
    sf_rect within;
    sf_element element;
} one_layer;

static one_layer the;

static int is_in(sf_rect r, int x, int y)
{
    return x >= (int)r.x0 && x < (int)r.x1 && y >= (int)r.y0 && y < (int)r.y1;
}

static int stands(int x, int y)
{
    int i = y * (int)the.nx + x;
    return the.printable[i] || the.tips[i];
}

// Whether (dx, dy) belongs to the element.
static int is_offset(int dx, int dy)
{
    int w = abs(dy) <= (int)the.element.reach_y ? the.element.half_width[abs(dy)] : -1;
    return abs(dx) <= w;
}

// ---------------------------------------------------------------------------------------------
// By voxels
// ---------------------------------------------------------------------------------------------

// Whether a voxel within a step of (x, y) is d steps away; d < 0: whether one of them stands.
static int meets(int x, int y, int d)
{
    int ry = the.element.reach_y, rx = the.element.half_width[0];
    for (int py = y - ry; py <= y + ry; py++) {
        for (int px = x - rx; px <= x + rx; px++) {
            if (px >= 0 && py >= 0 && px < (int)the.nx && py < (int)the.ny &&
                is_offset(px - x, py - y) &&
                (d < 0 ? stands(px, py) : the.steps[py * (int)the.nx + px] == d)) {
                return 1;
            }
        }
    }
    return 0;
}

static void find_steps(void)
{
    int is_more = 1;
    for (int y = 0; y < (int)the.ny; y++) {
        for (int x = 0; x < (int)the.nx; x++) {
            the.steps[y * (int)the.nx + x] = is_in(the.within, x, y) && stands(x, y) ? 0 : -1;
        }
    }
    for (int d = 0; is_more; d++) {
        is_more = 0;
        for (int y = (int)the.within.y0; y < (int)the.within.y1; y++) {
            for (int x = (int)the.within.x0; x < (int)the.within.x1; x++) {
                if (the.steps[y * (int)the.nx + x] < 0 && meets(x, y, d)) {
                    the.steps[y * (int)the.nx + x] = d + 1;
                    is_more = 1;
                }
            }
        }
    }
}

// Who carries by offset (dx, dy) those whose distance is c modulo 3 takes all that it reaches.
static void take(uint8_t *rest, uint8_t *added, int c, int dx, int dy)
{
    int nx = (int)the.nx, ny = (int)the.ny;
    memset(the.fresh, 0, sizeof the.fresh);
    for (int i = 0; i < nx * ny; i++) {
        int x = i % nx + dx, y = i / nx + dy;
        if (rest[i] && the.steps[i] >= 0 && the.steps[i] % 3 == c && x >= 0 && y >= 0 && x < nx &&
            y < ny && the.steps[y * nx + x] == the.steps[i] - 1) {
            the.fresh[y * nx + x] = 1;
        }
    }
    for (int i = 0; i < nx * ny; i++) {
        for (int y = 0; the.fresh[i] && y < ny; y++) {
            for (int x = 0; x < nx; x++) {
                rest[y * nx + x] &= !is_offset(x - i % nx, y - i / nx);
            }
        }
        added[i] |= the.fresh[i];
    }
}

// By the longer side, then by the shorter one; then as <support/preserve/priority.c> lists them.
static void take_all(uint8_t *rest, uint8_t *added)
{
    static const int ways[8][3] = {{1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0},
                                   {1, 1, 1}, {-1, 1, 1}, {1, -1, 1}, {-1, -1, 1}};
    for (int c = 0; c < 3; c++) {
        for (int r = 0; r <= (int)SF_REACH_MAX; r++) {
            for (int t = 0; t <= r; t++) {
                for (int i = 0; i < 8; i++) {
                    int dx = ways[i][0] * (ways[i][2] ? t : r);
                    int dy = ways[i][1] * (ways[i][2] ? r : t);
                    if (is_offset(dx, dy)) { // one that comes twice finds nothing left
                        take(rest, added, c, dx, dy);
                    }
                }
            }
        }
    }
}

// the.added = what the layer gets.
static void expect(void)
{
    static uint8_t rest[AREA];
    int nx = (int)the.nx, ny = (int)the.ny, left = 0;
    for (int i = 0; i < nx * ny; i++) {
        rest[i] = (the.added[i] || the.tips_above[i]) && !meets(i % nx, i / nx, -1);
        left |= rest[i];
    }
    memset(the.added, 0, sizeof the.added);
    if (left) {
        find_steps();
        take_all(rest, the.added);
    }
    for (int i = 0; i < nx * ny; i++) {
        the.added[i] |= rest[i];
    }
}

// ---------------------------------------------------------------------------------------------
// Layers
// ---------------------------------------------------------------------------------------------

static sf_rect random_rect(sf_rect in)
{
    uint32_t w = 1 + test_random_below(in.x1 - in.x0), h = 1 + test_random_below(in.y1 - in.y0);
    uint32_t x = in.x0 + test_random_below(in.x1 - in.x0 - w + 1);
    uint32_t y = in.y0 + test_random_below(in.y1 - in.y0 - h + 1);
    sf_rect r = {x, y, x + w, y + h};
    return r;
}

// A few voxels of a rectangle, or many.
static void sprinkle(uint8_t *bytes, sf_rect r)
{
    uint32_t sparse = 1u << test_random_below(9);
    for (uint32_t y = r.y0; y < r.y1; y++) {
        for (uint32_t x = r.x0; x < r.x1; x++) {
            bytes[y * the.nx + x] |= test_random_below(sparse) == 0;
        }
    }
}

static sf_slice slice_of(const uint8_t *bytes, uint64_t *words)
{
    sf_slice slice = {words, the.nx, the.ny, 3};
    memset(words, 0, sizeof(uint64_t) * 3 * SIDE_MAX);
    for (uint32_t i = 0; i < the.nx * the.ny; i++) {
        if (bytes[i]) {
            CHECK(sf_slice_set(slice, i % the.nx, i / the.nx, 1) == SF_OK);
        }
    }
    return slice;
}

static void random_element(int kind)
{
    memset(&the.element, 0, sizeof the.element);
    the.element.reach_y = (uint16_t)(kind < 2 ? 1 : test_random_below(4));
    unsigned w = kind < 2 ? 1 : test_random_below(4);
    for (unsigned dy = 0; dy <= the.element.reach_y; dy++) {
        the.element.half_width[dy] = (uint16_t)w;
        w = kind == 0 ? 1 : kind == 1 ? 0 : test_random_below(w + 1);
    }
}

static void compare(const sfi_lean *lean)
{
    for (uint32_t y = 0; y < the.ny; y++) {
        for (uint32_t x = 0; x < the.nx; x++) {
            sf_rect r = lean->patch.rect;
            int is_put =
                lean->added_in.x0 < lean->added_in.x1 && is_in(r, (int)x, (int)y) &&
                sf_slice_get(sfi_patch_slice(&lean->patch, lean->added), x - r.x0, y - r.y0);
            CHECK_EQ(is_put, the.added[y * the.nx + x]);
            CHECK(!is_put || is_in(lean->added_in, (int)x, (int)y));
        }
    }
}

// Some layers, one below the other. The tips end after a few.
static void one_brace(int kind)
{
    static uint64_t words[3][3 * SIDE_MAX];
    uint32_t most = test_random_below(4) == 0 ? SIDE_MAX : 30;
    the.nx = 1 + test_random_below(most);
    the.ny = 1 + test_random_below(most);
    sf_rect all = {0, 0, the.nx, the.ny}, none = {0, 0, 0, 0};
    the.within = random_rect(all);
    sf_rect tips_in = random_rect(the.within);
    size_t room = sfi_patch_room(the.nx, the.ny);
    uint64_t *memory = malloc(SFI_LEAN_PLANES * room * sizeof *memory);
    memset(memory, 0xa5, SFI_LEAN_PLANES * room * sizeof *memory);
    sfi_lean lean = sfi_lean_begin(memory, room, the.within);
    int layers = 1 + (int)test_random_below(6), tip_layers = 1 + (int)test_random_below(3);
    memset(the.added, 0, sizeof the.added);
    memset(the.tips, 0, sizeof the.tips);
    sprinkle(the.tips, tips_in);
    for (int k = 0; k < layers; k++) {
        int has_tips = k + 1 < tip_layers;
        memcpy(the.tips_above, the.tips, sizeof the.tips);
        memset(the.tips, 0, sizeof the.tips);
        memset(the.printable, 0, sizeof the.printable);
        if (has_tips) {
            sprinkle(the.tips, tips_in);
        }
        if (test_random_below(4) > 0) {
            sprinkle(the.printable, random_rect(all));
        }
        random_element(kind);
        sfi_lean_layer layer = {slice_of(the.printable, words[0]), slice_of(the.tips, words[1]),
                                slice_of(the.tips_above, words[2]), has_tips ? tips_in : none,
                                k < tip_layers ? tips_in : none};
        CHECK(sfi_lean_down(&lean, &the.element, &layer) == SF_OK);
        expect();
        compare(&lean);
    }
    free(memory);
}

static void squares(void)
{
    for (int i = 0; i < 400 && test_case_failures == 0; i++) {
        one_brace(0);
    }
}

static void pluses(void)
{
    for (int i = 0; i < 400 && test_case_failures == 0; i++) {
        one_brace(1);
    }
}

static void all_elements(void)
{
    for (int i = 0; i < 400 && test_case_failures == 0; i++) {
        one_brace(2);
    }
}

int main(void)
{
    TEST(squares);
    TEST(pluses);
    TEST(all_elements);
    return test_finish();
}

// SPDX-License-Identifier: MIT
// Lean: what a brace puts into one layer, below what must stand on it.
//
// What hangs there, R of brace.c, are often a few voxels in a thin ring, some steps away from what
// stands. So patches are cut for it: one around what must stand, in which R is found; and one
// around R, as wide as the distances are that have to be told. How wide that is no one knows
// before; but as a brace comes nearer by a step in each layer, the steps of the layer above are the
// first guess, and where they do not do, twice as many are the next.
//
// Carriers are chosen as sfi_cover_priority() does (support/preserve/priority.c), which also serves
// where an element is neither plus nor square. There are three covers: of what is 3 n, 3 n + 1 and
// 3 n + 2 steps away, as brace.c tells distances modulo 3.

#include "sculpt/lean.h"

#include <string.h>

#include "base/status.h"
#include "sculpt/near.h"
#include "support/preserve/cover.h"
#include "voxel/rect.h"
#include "voxel/slice.h"

// Planes. The first two are of the patch around what must stand.
enum {
    FIRM,
    ABOVE,
    REACHED,
    OTHER,
    INSIDE,
    RINGS,
    REST = RINGS + 3,
    HERE,
    PICKED,
    FRESH,
    WIDE,
    ADDED,
    PLANES_USED
};

// Steps that are looked at where nothing is known.
#define FIRST_STEPS 4u

static uint64_t *plane(const sfi_lean *l, const sfi_patch *p, unsigned which)
{
    return sfi_patch_place(p, l->memory + which * l->room);
}

sfi_lean sfi_lean_begin(uint64_t *memory, size_t room, sf_rect within)
{
    sf_rect nothing = {0, 0, 0, 0};
    sfi_lean lean = {memory, room, within, {{0, 0, 0, 0}, 0, 0}, NULL, nothing, FIRST_STEPS};
    return lean;
}

// ---------------------------------------------------------------------------------------------
// What hangs
// ---------------------------------------------------------------------------------------------

// What stands, in a patch.
static void load_firm(const sfi_patch *p, uint64_t *to, const sfi_lean_layer *layer)
{
    sfi_patch_load(p, to, layer->printable, 0, 0);
    if (!sfi_rect_is_empty(layer->tips_in)) {
        sfi_patch_load(p, to, layer->tips, 0, 0);
    }
}

// What hangs, in a patch that is cut for it, and around it a rectangle, which is empty where
// nothing does.
static sf_status find_hanging(const sfi_lean *l, const sf_element *e, const sfi_lean_layer *layer,
                              sfi_patch *patch, uint64_t **rest, sf_rect *hangs)
{
    sf_rect must = sfi_rect_union(l->added_in, layer->above_in);
    sfi_patch p =
        sfi_patch_make(sfi_rect_grow(must, e->half_width[0], e->reach_y, layer->printable));
    sfi_rows all = {0, p.height};
    uint64_t *firm = plane(l, &p, FIRM), *above = plane(l, &p, ABOVE);
    uint64_t *scratch = plane(l, &p, WIDE);
    load_firm(&p, firm, layer);
    if (!sfi_rect_is_empty(layer->above_in)) {
        sfi_patch_load(&p, above, layer->tips_above, 0, 0);
    }
    if (!sfi_rect_is_empty(l->added_in)) {
        sfi_patch_load(&p, above, sfi_patch_slice(&l->patch, l->added), l->patch.rect.x0,
                       l->patch.rect.y0);
    }
    sfi_step_shape shape = sfi_step_shape_of(e);
    if (shape != SFI_STEP_OTHER) {
        (void)sfi_patch_subtract_step(&p, shape, above, firm, scratch, all);
    } else {
        sf_slice must_stand = sfi_patch_slice(&p, above), spread = sfi_patch_slice(&p, scratch);
        SF_TRY(sf_slice_dilate(spread, sfi_patch_slice(&p, firm), e, SF_BORDER_EMPTY));
        SF_TRY(sf_slice_subtract(must_stand, must_stand, spread));
    }
    *patch = p;
    *rest = above;
    sf_rect r = sf_slice_bounds(sfi_patch_slice(&p, above));
    sf_rect moved = {r.x0 + p.rect.x0, r.y0 + p.rect.y0, r.x1 + p.rect.x0, r.y1 + p.rect.y0};
    *hangs = sfi_rect_is_empty(r) ? r : moved;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Distances
// ---------------------------------------------------------------------------------------------

// What lies within so many steps of a rectangle, and within where it is looked for.
static sf_rect reach(const sfi_lean *l, const sf_element *e, sf_rect r, uint32_t steps,
                     sf_slice slice)
{
    sf_rect grown = sfi_rect_grow(r, steps * e->half_width[0], steps * e->reach_y, slice);
    sf_rect w = l->within;
    grown.x0 = grown.x0 > w.x0 ? grown.x0 : w.x0;
    grown.y0 = grown.y0 > w.y0 ? grown.y0 : w.y0;
    grown.x1 = grown.x1 < w.x1 ? grown.x1 : w.x1;
    grown.y1 = grown.y1 < w.y1 ? grown.y1 : w.y1;
    return grown;
}

static int is_same(sf_rect a, sf_rect b)
{
    return a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1;
}

// A question in a patch.
static sfi_near ask(const sfi_lean *l, const sf_element *e, const sfi_patch *p)
{
    sfi_near n = {.element = e, .patch = *p};
    for (unsigned i = 0; i < 3; i++) {
        n.rings[i] = plane(l, p, RINGS + i);
    }
    n.reached = plane(l, p, REACHED);
    n.other = plane(l, p, OTHER);
    n.wide = plane(l, p, WIDE);
    n.inside = plane(l, p, INSIDE);
    return n;
}

// Distances of what hangs, in a patch that is wide enough for them; `rest` is what hangs in it.
static sf_status find_distances(sfi_lean *l, const sf_element *e, const sfi_lean_layer *layer,
                                sf_slice hanging, const sfi_patch *from, sf_rect hangs,
                                sfi_near *near, uint64_t **rest)
{
    int is_all = 0, is_whole = 0;
    for (uint32_t far = l->far; !is_all && !is_whole; far *= 2) {
        sf_rect r = reach(l, e, hangs, far, layer->printable);
        is_whole = is_same(r, reach(l, e, hangs, 2 * far, layer->printable));
        sfi_patch p = sfi_patch_make(r);
        *near = ask(l, e, &p);
        *rest = plane(l, &p, REST);
        load_firm(&p, near->reached, layer);
        sfi_patch_load(&p, *rest, hanging, from->rect.x0, from->rect.y0);
        near->wanted = *rest;
        near->rows.first = (int64_t)hangs.y0 - r.y0;
        near->rows.end = (int64_t)hangs.y1 - r.y0;
        near->limit = is_whole ? 0 : far;
        uint32_t steps;
        SF_TRY(sfi_find_near(near, &steps, &is_all));
        l->far = is_all ? steps + 1 : far;
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Carriers
// ---------------------------------------------------------------------------------------------

// A cover at work. Rows are those of what hangs; in others nothing is written into `here`.
typedef struct cover {
    sfi_patch patch;
    sfi_step_shape shape;
    sfi_rows rows;
    const uint64_t *carriers;
    uint64_t *here, *picked, *fresh, *wide;
} cover;

// fresh = the carriers at (dx, dy) from what hangs; returns whether there are any.
static int take(const cover *c, int dx, int dy)
{
    int64_t stride = (int64_t)c->patch.stride, back = dy * stride;
    sfi_rows rows = sfi_rows_grow(c->rows, 1);
    const uint64_t *here = c->here - back, *carriers = c->carriers;
    uint64_t *restrict fresh = c->fresh, *restrict picked = c->picked, any = 0;
    for (int64_t i = rows.first * stride; i < rows.end * stride; i++) {
        uint64_t hanging = dx == 0  ? here[i]
                           : dx > 0 ? here[i] << 1 | here[i - 1] >> 63
                                    : here[i] >> 1 | here[i + 1] << 63;
        fresh[i] = hanging & carriers[i];
        picked[i] |= fresh[i];
        any |= fresh[i];
    }
    return any != 0;
}

// picked = carriers of all of `here` that any reaches.
static void pick(const cover *c)
{
    static const int offsets[9][2] = {{0, 0}, {1, 0},  {-1, 0}, {0, 1},  {0, -1},
                                      {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
    int count = c->shape == SFI_STEP_SQUARE ? 9 : 5, left = 1;
    for (int i = 0; i < count && left; i++) {
        if (take(c, offsets[i][0], offsets[i][1])) {
            left =
                sfi_patch_subtract_step(&c->patch, c->shape, c->here, c->fresh, c->wide, c->rows);
        }
    }
}

// One of the three covers, of a plus or a square.
static void cover_small(cover *c, const uint64_t *ring, uint64_t *rest, uint64_t *added)
{
    sfi_rows more = sfi_rows_grow(c->rows, 1);
    int64_t stride = (int64_t)c->patch.stride;
    uint64_t any = 0;
    for (int64_t i = c->rows.first * stride; i < c->rows.end * stride; i++) {
        c->here[i] = rest[i] & ring[i];
        any |= c->here[i];
    }
    if (any == 0) {
        return;
    }
    memset(c->picked + more.first * stride, 0,
           (size_t)((more.end - more.first) * stride) * sizeof any);
    pick(c);
    for (int64_t i = more.first * stride; i < more.end * stride; i++) {
        added[i] |= c->picked[i];
    }
    (void)sfi_patch_subtract_step(&c->patch, c->shape, rest, c->picked, c->wide, c->rows);
}

// The same for any element.
static sf_status cover_any(const cover *c, const sf_element *e, uint64_t *ring, uint64_t *carriers,
                           uint64_t *rest_plane, uint64_t *added_plane)
{
    const sfi_patch *p = &c->patch;
    sf_slice here = sfi_patch_slice(p, c->here), picked = sfi_patch_slice(p, c->picked);
    sf_slice spread = sfi_patch_slice(p, c->wide), rest = sfi_patch_slice(p, rest_plane);
    sf_slice added = sfi_patch_slice(p, added_plane);
    SF_TRY(sf_slice_and(here, rest, sfi_patch_slice(p, ring)));
    SF_TRY(sfi_cover_priority(e, here, sfi_patch_slice(p, carriers), picked,
                              sfi_patch_slice(p, c->fresh), spread));
    SF_TRY(sf_slice_or(added, added, picked));
    SF_TRY(sf_slice_dilate(spread, picked, e, SF_BORDER_EMPTY));
    return sf_slice_subtract(rest, rest, spread);
}

// added = carriers of what hangs, and straight below what has nothing to come nearer to.
static sf_status choose(sfi_lean *l, const sf_element *e, const sfi_near *n, uint64_t *rest)
{
    const sfi_patch *p = &n->patch;
    cover c = {*p, sfi_step_shape_of(e), n->rows, NULL, NULL, NULL, NULL, n->wide};
    c.here = plane(l, p, HERE);
    c.picked = plane(l, p, PICKED);
    c.fresh = plane(l, p, FRESH);
    l->added = plane(l, p, ADDED);
    l->patch = *p;
    for (unsigned i = 0; i < 3; i++) {
        uint64_t *carriers = n->rings[(i + 2) % 3];
        c.carriers = carriers;
        if (c.shape != SFI_STEP_OTHER) {
            cover_small(&c, n->rings[i], rest, l->added);
        } else {
            SF_TRY(cover_any(&c, e, n->rings[i], carriers, rest, l->added));
        }
    }
    for (size_t i = 0; i < p->stride * p->height; i++) {
        l->added[i] |= rest[i];
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The layer
// ---------------------------------------------------------------------------------------------

sf_status sfi_lean_down(sfi_lean *lean, const sf_element *element, const sfi_lean_layer *layer)
{
    sf_rect hangs = {0, 0, 0, 0};
    sfi_patch above;
    sfi_near near = {0};
    uint64_t *hanging = NULL, *rest = NULL;
    if (!sfi_rect_is_empty(lean->added_in) || !sfi_rect_is_empty(layer->above_in)) {
        SF_TRY(find_hanging(lean, element, layer, &above, &hanging, &hangs));
    }
    lean->added_in = hangs;
    if (sfi_rect_is_empty(hangs)) {
        return SF_OK;
    }
    SF_TRY(find_distances(lean, element, layer, sfi_patch_slice(&above, hanging), &above, hangs,
                          &near, &rest));
    lean->added_in = reach(lean, element, hangs, 1, layer->printable);
    return choose(lean, element, &near, rest);
}

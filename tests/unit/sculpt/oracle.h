// SPDX-License-Identifier: MIT
// The oracle of brushes: a model of bytes, and each brush written straight from its definition in
// <sf/sculpt.h>, for the union of all dabs at once. It shares with the library only what has tests
// of its own elsewhere: a rule's elements, sf_grid_preserve() and sf_path_finder_find().

#ifndef SF_TEST_SCULPT_ORACLE_H
#define SF_TEST_SCULPT_ORACLE_H

#include <sf/sf.h>

#include "test.h"

typedef struct oracle {
    int nx, ny, nz, bed, keep_drawn;
    int low[2], high[2]; // the rectangle of the stroke's tips, their boxes clipped to the grid
    size_t count;
    sf_rule rule;
    uint8_t *d, *t, *m;        // drawn, printable, materials
    uint8_t *d0, *t0, *m0;     // before the stroke
    uint8_t *u, *grown, *next; // union of tips; what grow adds; scratch
} oracle;

static inline oracle oracle_new(const sf_sculpt_options *options)
{
    oracle o = {.nx = (int)options->lattice.nx,
                .ny = (int)options->lattice.ny,
                .nz = (int)options->lattice.nz,
                .bed = (int)options->bed_layer,
                .keep_drawn = options->keep_drawn,
                .rule = options->rule};
    o.count = (size_t)o.nx * (size_t)o.ny * (size_t)o.nz;
    uint8_t **parts[9] = {&o.d, &o.t, &o.m, &o.d0, &o.t0, &o.m0, &o.u, &o.grown, &o.next};
    for (int i = 0; i < 9; i++) {
        *parts[i] = calloc(o.count, 1);
    }
    return o;
}

static inline void oracle_free(oracle *o)
{
    uint8_t *parts[9] = {o->d, o->t, o->m, o->d0, o->t0, o->m0, o->u, o->grown, o->next};
    for (int i = 0; i < 9; i++) {
        free(parts[i]);
    }
}

static inline int oracle_has(const oracle *o, int x, int y, int z)
{
    return x >= 0 && x < o->nx && y >= 0 && y < o->ny && z >= 0 && z < o->nz;
}

static inline size_t oracle_at(const oracle *o, int x, int y, int z)
{
    return ((size_t)z * (size_t)o->ny + (size_t)y) * (size_t)o->nx + (size_t)x;
}

static inline int oracle_get(const oracle *o, const uint8_t *part, int x, int y, int z)
{
    return oracle_has(o, x, y, z) && part[oracle_at(o, x, y, z)] != 0;
}

// Whether the element at (x, y) meets `part` in layer z.
static inline int oracle_meets(const oracle *o, const uint8_t *part, const sf_element *e, int x,
                               int y, int z)
{
    for (int dy = -(int)e->reach_y; dy <= (int)e->reach_y; dy++) {
        int w = e->half_width[dy < 0 ? -dy : dy];
        for (int dx = -w; dx <= w; dx++) {
            if (oracle_get(o, part, x + dx, y + dy, z)) {
                return 1;
            }
        }
    }
    return 0;
}

#define ORACLE_EACH(o, x, y, z)                                                                    \
    for (int z = 0; z < (o)->nz; z++)                                                              \
        for (int y = 0; y < (o)->ny; y++)                                                          \
            for (int x = 0; x < (o)->nx; x++)

// t = trim(d).
static inline void oracle_trim(oracle *o)
{
    sf_element e = {0, {0}};
    ORACLE_EACH(o, x, y, z)
    {
        if (x == 0 && y == 0 && z > 0) {
            CHECK(sf_rule_element(&o->rule, (uint32_t)z - 1, &e) == SF_OK);
        }
        size_t i = oracle_at(o, x, y, z);
        o->t[i] =
            o->d[i] != 0 && z >= o->bed && (z == o->bed || oracle_meets(o, o->t, &e, x, y, z - 1));
    }
}

// A grid of bytes, to be destroyed.
static inline sf_grid *oracle_grid(const oracle *o, const uint8_t *part)
{
    sf_lattice lattice = {(uint32_t)o->nx, (uint32_t)o->ny, (uint32_t)o->nz, 1, 1, 1, NULL,
                          {0, 0, 0}};
    sf_grid *grid = NULL;
    CHECK(sf_grid_create(&lattice, NULL, &grid) == SF_OK);
    ORACLE_EACH(o, x, y, z)
    {
        if (part[oracle_at(o, x, y, z)] != 0) {
            CHECK(sf_slice_set(sf_grid_slice(grid, (uint32_t)z), (uint32_t)x, (uint32_t)y, 1) ==
                  SF_OK);
        }
    }
    return grid;
}

// ---------------------------------------------------------------------------------------------
// Tips
// ---------------------------------------------------------------------------------------------

// part |= the tip at (x, y, z), mirrored by flipping offsets.
static inline void oracle_put(const oracle *o, uint8_t *part, const sf_tip *tip, int x, int y,
                              int z, int flip_x, int flip_y)
{
    sf_dab anchor;
    const sf_grid *mask = sf_tip_mask(tip, &anchor);
    sf_lattice l = sf_grid_lattice(mask);
    for (int k = 0; k < (int)l.nz; k++) {
        for (int j = 0; j < (int)l.ny; j++) {
            for (int i = 0; i < (int)l.nx; i++) {
                int px = x + (flip_x ? anchor.x - i : i - anchor.x);
                int py = y + (flip_y ? anchor.y - j : j - anchor.y), pz = z + k - anchor.z;
                if (oracle_has(o, px, py, pz) &&
                    sf_slice_get(sf_grid_slice(mask, (uint32_t)k), (uint32_t)i, (uint32_t)j)) {
                    part[oracle_at(o, px, py, pz)] = 1;
                }
            }
        }
    }
}

static inline int oracle_clip(int64_t x, int most)
{
    return x < 0 ? 0 : x > most ? most : (int)x;
}

// low and high grown by the box of the tip at (x, y, z), as far as it lies within the grid.
static inline void oracle_bound(oracle *o, const sf_tip *tip, int x, int y, int z, int flip_x,
                                int flip_y)
{
    sf_dab a;
    sf_lattice l = sf_grid_lattice(sf_tip_mask(tip, &a));
    int64_t from[3] = {(int64_t)x - (flip_x ? (int64_t)l.nx - 1 - a.x : a.x),
                       (int64_t)y - (flip_y ? (int64_t)l.ny - 1 - a.y : a.y), (int64_t)z - a.z};
    const int most[3] = {o->nx, o->ny, o->nz};
    const int64_t size[3] = {l.nx, l.ny, l.nz};
    int low[3], high[3], is_inside = 1;
    for (int i = 0; i < 3; i++) {
        low[i] = oracle_clip(from[i], most[i]);
        high[i] = oracle_clip(from[i] + size[i], most[i]);
        is_inside &= low[i] < high[i];
    }
    for (int i = 0; i < 2 && is_inside; i++) {
        o->low[i] = low[i] < o->low[i] ? low[i] : o->low[i];
        o->high[i] = high[i] > o->high[i] ? high[i] : o->high[i];
    }
}

// ---------------------------------------------------------------------------------------------
// Brushes
// ---------------------------------------------------------------------------------------------

static inline void oracle_set_drawn(oracle *o, size_t i, int value, uint8_t material)
{
    o->m[i] = !value ? 0 : o->d0[i] ? o->m0[i] : material;
    o->d[i] = (uint8_t)value;
}

// V' of preserve: t0 without what of u carries nothing.
static inline void oracle_preserve(oracle *o)
{
    sf_grid *shape = oracle_grid(o, o->t0), *brush = oracle_grid(o, o->u);
    sf_terms terms = sf_terms_default();
    sf_preserve_options options = sf_preserve_options_default();
    terms.rule = o->rule;
    terms.bed_layer = (uint32_t)o->bed;
    CHECK(sf_grid_preserve(shape, brush, &terms, &options, NULL, NULL, NULL) == SF_OK);
    ORACLE_EACH(o, x, y, z)
    {
        size_t i = oracle_at(o, x, y, z);
        int kept = sf_slice_get(sf_grid_slice(shape, (uint32_t)z), (uint32_t)x, (uint32_t)y);
        oracle_set_drawn(o, i, o->d0[i] && (!o->u[i] || kept), 0);
    }
    sf_grid_destroy(shape);
    sf_grid_destroy(brush);
}

static inline uint8_t oracle_vote(const oracle *o, const uint8_t *solid, int x, int y, int z)
{
    int counts[256] = {0}, best = 0;
    for (int n = 0; n < 27; n++) {
        int px = x + n % 3 - 1, py = y + n / 3 % 3 - 1, pz = z + n / 9 - 1;
        if (oracle_get(o, solid, px, py, pz)) {
            counts[o->m[oracle_at(o, px, py, pz)]]++;
        }
    }
    for (int k = 1; k < 256; k++) {
        best = counts[k] > counts[best] ? k : best;
    }
    return (uint8_t)best;
}

static inline void oracle_smooth(oracle *o, uint32_t passes)
{
    uint8_t *votes = calloc(o->count, 1);
    for (uint32_t p = 0; p < passes; p++) {
        memcpy(o->next, o->d, o->count);
        memcpy(votes, o->m, o->count);
        ORACLE_EACH(o, x, y, z)
        {
            size_t i = oracle_at(o, x, y, z);
            int around = 0;
            for (int n = 0; n < 27; n++) {
                around += oracle_get(o, o->d, x + n % 3 - 1, y + n / 3 % 3 - 1, z + n / 9 - 1);
            }
            o->next[i] = o->u[i] ? around >= 14 : o->d[i];
            if (o->next[i] && !o->d[i]) {
                votes[i] = oracle_vote(o, o->d, x, y, z);
            }
        }
        memcpy(o->d, o->next, o->count);
        memcpy(o->m, votes, o->count);
    }
    free(votes);
    for (size_t i = 0; i < o->count; i++) {
        o->m[i] = !o->d[i] ? 0 : o->d0[i] ? o->m0[i] : o->m[i];
    }
}

// The rectangle that braces look in: that of the tips' boxes, and a tip's size more on every side.
static inline void oracle_within(const oracle *o, const sf_tip *tip, int low[2], int high[2])
{
    sf_lattice l = sf_grid_lattice(sf_tip_mask(tip, NULL));
    const int more[2] = {(int)l.nx, (int)l.ny}, most[2] = {o->nx, o->ny};
    for (int i = 0; i < 2; i++) {
        low[i] = o->low[i] > more[i] ? o->low[i] - more[i] : 0;
        high[i] = o->high[i] + more[i] < most[i] ? o->high[i] + more[i] : most[i];
    }
}

// How many steps voxel (x, y) of layer k is from what stands there, within a rectangle; -1: none
// is.
static inline void oracle_distances(const oracle *o, const uint8_t *fixed, const sf_element *e,
                                    int k, const int low[2], const int high[2], int *steps)
{
    int changed = 1;
    for (int y = 0; y < o->ny; y++) {
        for (int x = 0; x < o->nx; x++) {
            int is_in = x >= low[0] && x < high[0] && y >= low[1] && y < high[1];
            steps[y * o->nx + x] = is_in && oracle_get(o, fixed, x, y, k) ? 0 : -1;
        }
    }
    for (int d = 0; changed; d++) {
        changed = 0;
        for (int y = low[1]; y < high[1]; y++) {
            for (int x = low[0]; x < high[0]; x++) {
                for (int j = -(int)e->reach_y; steps[y * o->nx + x] < 0 && j <= e->reach_y; j++) {
                    int w = e->half_width[j < 0 ? -j : j];
                    for (int i = -w; i <= w; i++) {
                        int in_grid = oracle_has(o, x + i, y + j, k);
                        if (in_grid && steps[(y + j) * o->nx + x + i] == d) {
                            steps[y * o->nx + x] = d + 1;
                            changed = 1;
                            break;
                        }
                    }
                }
            }
        }
    }
}

// The offsets of a cover, in its order: by rings, in a ring by how far off the axis.
static inline int oracle_offsets(const sf_element *e, int offsets[][2])
{
    int count = 0;
    for (int r = 0; r < 256; r++) {
        for (int t = 0; t <= r; t++) {
            for (int i = 0; i < 8; i++) {
                int dx = i < 4 ? r : t, dy = i < 4 ? t : r, sx = i & 1, sy = i >> 1 & 1;
                int is_twice = (sx && dx == 0) || (sy && dy == 0) || (i >= 4 && r == t);
                if (!is_twice && dy <= e->reach_y && dx <= e->half_width[dy]) {
                    offsets[count][0] = sx ? -dx : dx;
                    offsets[count++][1] = sy ? -dy : dy;
                }
            }
        }
    }
    return count;
}

// One layer of a brace, of rules that are elements: see libsf/sculpt/brace.c. `above` is a whole
// model of which only layer k + 1 counts; x gets layer k.
static inline void oracle_brace_layer(oracle *o, int k, uint8_t *x, const uint8_t *above,
                                      const int low[2], const int high[2])
{
    static int offsets[1024][2];
    sf_element e;
    int n = o->nx * o->ny, *steps = malloc((size_t)n * sizeof *steps);
    uint8_t *fixed = calloc(o->count, 1), *rest = calloc((size_t)n, 1), *fresh = malloc((size_t)n);
    size_t base = oracle_at(o, 0, 0, k);
    CHECK(sf_rule_element(&o->rule, (uint32_t)k, &e) == SF_OK);
    int count = oracle_offsets(&e, offsets);
    for (int i = 0; i < n; i++) {
        fixed[base + (size_t)i] = o->t[base + (size_t)i] || o->u[base + (size_t)i];
    }
    for (int i = 0; i < n; i++) {
        rest[i] = oracle_get(o, above, i % o->nx, i / o->nx, k + 1) &&
                  !oracle_meets(o, fixed, &e, i % o->nx, i / o->nx, k);
    }
    oracle_distances(o, fixed, &e, k, low, high, steps);
    for (int c = 0; c < 3; c++) {
        for (int f = 0; f < count; f++) {
            memset(fresh, 0, (size_t)n);
            for (int i = 0; i < n; i++) {
                int px = i % o->nx + offsets[f][0], py = i / o->nx + offsets[f][1];
                int here = steps[i];
                if (rest[i] && here >= 0 && here % 3 == c && oracle_has(o, px, py, k) &&
                    steps[py * o->nx + px] == here - 1) {
                    fresh[py * o->nx + px] = 1;
                }
            }
            for (int i = 0; i < n; i++) {
                x[base + (size_t)i] |= fresh[i];
            }
            for (int i = 0; i < n; i++) {
                rest[i] = rest[i] && !oracle_meets(o, x, &e, i % o->nx, i / o->nx, k);
            }
        }
    }
    for (int i = 0; i < n; i++) {
        x[base + (size_t)i] |= rest[i];
    }
    free(steps);
    free(fixed);
    free(rest);
    free(fresh);
}

// What the paths and the tips need below them; oracle_trim() has run with both drawn.
static inline void oracle_brace(oracle *o, const sf_brush *brush)
{
    int low[2], high[2];
    uint8_t *x = calloc(o->count, 1), *above = calloc(o->count, 1);
    oracle_within(o, brush->tip, low, high);
    for (int k = o->nz - 2; k >= o->bed; k--) {
        for (int i = 0; i < o->nx * o->ny; i++) {
            size_t a = oracle_at(o, 0, 0, k + 1) + (size_t)i;
            above[a] = o->u[a] || x[a];
        }
        oracle_brace_layer(o, k, x, above, low, high);
    }
    for (size_t i = 0; i < o->count; i++) {
        if (x[i] && !o->d[i]) {
            oracle_set_drawn(o, i, 1, brush->material);
        }
    }
    free(x);
    free(above);
}

static inline void oracle_path(oracle *o, const sf_tip *tip, const sf_grid *shape, int x, int y,
                               int z, int flip_x, int flip_y)
{
    sf_terms terms = sf_terms_default();
    sf_path_finder *finder = NULL;
    sf_path found;
    if (!oracle_has(o, x, y, z) || z < o->bed) {
        return;
    }
    sf_voxel *path = malloc((size_t)o->nz * sizeof *path),
             from = {(uint32_t)x, (uint32_t)y, (uint32_t)z};
    terms.rule = o->rule;
    terms.bed_layer = (uint32_t)o->bed;
    CHECK(sf_path_finder_create(shape, &terms, SF_LANDING_ANY, NULL, NULL, &finder) == SF_OK);
    CHECK(sf_path_finder_find(finder, from, path, (size_t)o->nz, &found) == SF_OK);
    for (size_t i = 0; i < found.count; i++) {
        int px = (int)path[i].x, py = (int)path[i].y, pz = (int)path[i].z;
        o->grown[oracle_at(o, px, py, pz)] = 1;
        oracle_put(o, o->grown, tip, px, py, pz, flip_x, flip_y);
    }
    free(path);
    sf_path_finder_destroy(finder);
}

static inline void oracle_collect(oracle *o, const sf_brush *brush, const sf_dab *dabs,
                                  size_t count)
{
    sf_grid *shape = oracle_grid(o, o->t0);
    memset(o->u, 0, o->count);
    memset(o->grown, 0, o->count);
    o->low[0] = o->low[1] = INT32_MAX;
    o->high[0] = o->high[1] = 0;
    for (size_t n = 0; n < count; n++) {
        for (int way = 0; way < 4; way++) {
            int fx = way & 1, fy = way >> 1;
            if ((fx && !brush->mirror_x) || (fy && !brush->mirror_y)) {
                continue;
            }
            int x = fx ? o->nx - 1 - dabs[n].x : dabs[n].x;
            int y = fy ? o->ny - 1 - dabs[n].y : dabs[n].y;
            oracle_put(o, o->u, brush->tip, x, y, dabs[n].z, fx, fy);
            oracle_bound(o, brush->tip, x, y, dabs[n].z, fx, fy);
            if (brush->kind == SF_BRUSH_ADD_GROW) {
                oracle_path(o, brush->tip, shape, x, y, dabs[n].z, fx, fy);
            }
        }
    }
    sf_grid_destroy(shape);
}

// The model after a stroke, but for ghosts that go when it ends.
static inline void oracle_apply(oracle *o, const sf_brush *brush)
{
    int is_grow = brush->kind == SF_BRUSH_ADD_GROW;
    for (size_t i = 0; i < o->count; i++) {
        int more = o->u[i] || (is_grow && o->grown[i]);
        if (brush->kind == SF_BRUSH_ADD_TRIM || is_grow) {
            oracle_set_drawn(o, i, o->d0[i] || more, brush->material);
        } else if (brush->kind == SF_BRUSH_REMOVE_TRIM) {
            oracle_set_drawn(o, i, o->d0[i] && !o->u[i], 0);
        } else if (brush->kind == SF_BRUSH_PAINT && o->u[i] && o->d0[i]) {
            o->m[i] = brush->material;
        }
    }
    if (brush->kind == SF_BRUSH_REMOVE_PRESERVE) {
        oracle_preserve(o);
    }
    if (brush->kind == SF_BRUSH_SMOOTH_TRIM) {
        oracle_smooth(o, brush->passes);
    }
    oracle_trim(o);
    if (is_grow) {
        oracle_brace(o, brush);
        oracle_trim(o);
    }
}

static inline void oracle_stroke(oracle *o, const sf_brush *brush, const sf_dab *dabs, size_t count)
{
    memcpy(o->d0, o->d, o->count);
    memcpy(o->t0, o->t, o->count);
    memcpy(o->m0, o->m, o->count);
    oracle_collect(o, brush, dabs, count);
    oracle_apply(o, brush);
    for (size_t i = 0; !o->keep_drawn && i < o->count; i++) {
        o->m[i] = o->t[i] ? o->m[i] : 0;
        o->d[i] = o->t[i];
    }
}

// ---------------------------------------------------------------------------------------------
// Comparing
// ---------------------------------------------------------------------------------------------

// Voxels in which a model is not what the oracle says.
static inline long oracle_differences(const oracle *o, const sf_sculpt *model)
{
    long count = 0;
    const uint8_t *materials = sf_sculpt_materials(model);
    ORACLE_EACH(o, x, y, z)
    {
        size_t i = oracle_at(o, x, y, z);
        sf_slice d = sf_grid_slice(sf_sculpt_drawn(model), (uint32_t)z);
        sf_slice t = sf_grid_slice(sf_sculpt_printable(model), (uint32_t)z);
        count += sf_slice_get(d, (uint32_t)x, (uint32_t)y) != o->d[i];
        count += sf_slice_get(t, (uint32_t)x, (uint32_t)y) != o->t[i];
        count += materials[i] != o->m[i];
    }
    return count;
}

#endif

// SPDX-License-Identifier: MIT
// The oracle of the laws: small stacks of slices, a byte per voxel, everything written the slow way
// straight from its definition. Nothing here calls the library but to convert.
//
// A stack can be written as text, layers from the bottom up: "#..|.#." is two layers of a row of
// three; rows of one layer are parted by '/'.

#ifndef SF_TEST_STACK_H
#define SF_TEST_STACK_H

#include "failing_allocator.h"
#include "test.h"

#include <sf/support.h>

#define STACK_VOXELS 32768

typedef struct stack {
    int nx, ny, nz;
    uint8_t solid[STACK_VOXELS];
} stack;

static inline int stack_count(const stack *s)
{
    return s->nx * s->ny * s->nz;
}

static inline uint8_t *stack_at(stack *s, int x, int y, int z)
{
    return &s->solid[(z * s->ny + y) * s->nx + x];
}

// Whether a voxel is solid; outside none is.
static inline int stack_get(const stack *s, int x, int y, int z)
{
    return x >= 0 && y >= 0 && z >= 0 && x < s->nx && y < s->ny && z < s->nz &&
           s->solid[(z * s->ny + y) * s->nx + x];
}

static inline void stack_clear(stack *s, int nx, int ny, int nz)
{
    s->nx = nx;
    s->ny = ny;
    s->nz = nz;
    size_t count = (size_t)nx * (size_t)ny * (size_t)nz;
    if (count > STACK_VOXELS) {
        abort();
    }
    memset(s->solid, 0, count);
}

static inline void stack_parse(stack *s, const char *text)
{
    int nx = (int)strcspn(text, "/|"), ny = 1, nz = 1;
    for (const char *c = text; *c != '\0'; c++) {
        ny += *c == '/' && nz == 1;
        nz += *c == '|';
    }
    stack_clear(s, nx, ny, nz);
    int i = 0;
    for (const char *c = text; *c != '\0'; c++) {
        if (*c == '#' || *c == '.') {
            s->solid[i++] = *c == '#';
        }
    }
}

static inline void stack_random(stack *s, int nx, int ny, int nz, double density)
{
    stack_clear(s, nx, ny, nz);
    for (int i = 0; i < stack_count(s); i++) {
        s->solid[i] = test_random_unit() < density;
    }
}

// Lumps: unions of random boxes, more like a shape than noise is.
static inline void stack_random_boxes(stack *s, int nx, int ny, int nz, int boxes)
{
    stack_clear(s, nx, ny, nz);
    for (int i = 0; i < boxes; i++) {
        int x0 = (int)test_random_below((uint32_t)nx), y0 = (int)test_random_below((uint32_t)ny);
        int z0 = (int)test_random_below((uint32_t)nz);
        int wx = 1 + (int)test_random_below((uint32_t)nx / 2 + 1);
        int wy = 1 + (int)test_random_below((uint32_t)ny / 2 + 1);
        int wz = 1 + (int)test_random_below((uint32_t)nz / 2 + 1);
        for (int z = z0; z < z0 + wz && z < nz; z++) {
            for (int y = y0; y < y0 + wy && y < ny; y++) {
                for (int x = x0; x < x0 + wx && x < nx; x++) {
                    *stack_at(s, x, y, z) = 1;
                }
            }
        }
    }
}

static inline int stack_equal(const stack *a, const stack *b)
{
    return a->nx == b->nx && a->ny == b->ny && a->nz == b->nz &&
           memcmp(a->solid, b->solid, (size_t)stack_count(a)) == 0;
}

static inline int stack_within(const stack *a, const stack *b)
{
    for (int i = 0; i < stack_count(a); i++) {
        if (a->solid[i] && !b->solid[i]) {
            return 0;
        }
    }
    return 1;
}

static inline uint64_t stack_volume(const stack *s)
{
    uint64_t sum = 0;
    for (int i = 0; i < stack_count(s); i++) {
        sum += s->solid[i];
    }
    return sum;
}

enum { STACK_OR, STACK_AND, STACK_MINUS, STACK_XOR };

// result may be a or b.
static inline void stack_combine(stack *result, const stack *a, const stack *b, int operation)
{
    int count = stack_count(a);
    result->nx = a->nx;
    result->ny = a->ny;
    result->nz = a->nz;
    for (int i = 0; i < count; i++) {
        int p = a->solid[i], q = b->solid[i];
        int r = operation == STACK_OR      ? p | q
                : operation == STACK_AND   ? p & q
                : operation == STACK_MINUS ? p & !q
                                           : p ^ q;
        result->solid[i] = (uint8_t)r;
    }
}

static inline int element_has(const sf_element *e, int dx, int dy)
{
    int ax = dx < 0 ? -dx : dx, ay = dy < 0 ? -dy : dy;
    return ay <= (int)e->reach_y && ax <= (int)e->half_width[ay];
}

// What a rule asks between layers k and k + 1.
static inline sf_element stack_step(const sf_rule *rule, int k)
{
    sf_element e = {0, {0}};
    CHECK_EQ(sf_rule_element(rule, (uint32_t)k, &e), SF_OK);
    return e;
}

// Whether layer z - 1 of `below` carries voxel (x, y, z) by the element.
static inline int stack_carried(const stack *below, int x, int y, int z, const sf_element *e)
{
    for (int dy = -(int)e->reach_y; dy <= (int)e->reach_y; dy++) {
        for (int dx = -(int)e->half_width[0]; dx <= (int)e->half_width[0]; dx++) {
            if (element_has(e, dx, dy) && stack_get(below, x + dx, y + dy, z - 1)) {
                return 1;
            }
        }
    }
    return 0;
}

static inline int stack_bed(const stack *s, uint32_t bed_layer)
{
    if (bed_layer != SF_BED_AUTO) {
        return (int)bed_layer;
    }
    for (int i = 0; i < stack_count(s); i++) {
        if (s->solid[i]) {
            return i / (s->nx * s->ny);
        }
    }
    return s->nz;
}

// Trim by the recursion of ALGORITHMS 1.1; result must not be s.
static inline void stack_trim(stack *result, const stack *s, const sf_rule *rule,
                              uint32_t bed_layer)
{
    int bed = stack_bed(s, bed_layer);
    stack_clear(result, s->nx, s->ny, s->nz);
    for (int z = bed; z < s->nz; z++) {
        sf_element e = {0, {0}};
        if (z > bed) {
            e = stack_step(rule, z - 1);
        }
        for (int y = 0; y < s->ny; y++) {
            for (int x = 0; x < s->nx; x++) {
                int stays =
                    stack_get(s, x, y, z) && (z == bed || stack_carried(result, x, y, z, &e));
                *stack_at(result, x, y, z) = (uint8_t)stays;
            }
        }
    }
}

// Voxels that have a chain down to the bed, by breadth-first search from the bed (TRUST 4): a way
// to the trim that shares no thought with the recursion.
static inline void stack_chains(stack *result, const stack *s, const sf_rule *rule,
                                uint32_t bed_layer)
{
    static int queue[STACK_VOXELS];
    int head = 0, tail = 0, layer = s->nx * s->ny, bed = stack_bed(s, bed_layer);
    stack_clear(result, s->nx, s->ny, s->nz);
    for (int i = bed * layer; i < (bed + 1) * layer && i < stack_count(s); i++) {
        if (s->solid[i]) {
            result->solid[i] = 1;
            queue[tail++] = i;
        }
    }
    while (head < tail) {
        int i = queue[head++], z = i / layer, y = i % layer / s->nx, x = i % s->nx;
        if (z + 1 >= s->nz) {
            continue;
        }
        sf_element e = stack_step(rule, z);
        for (int dy = -(int)e.reach_y; dy <= (int)e.reach_y; dy++) {
            for (int dx = -(int)e.half_width[0]; dx <= (int)e.half_width[0]; dx++) {
                if (!element_has(&e, dx, dy) || !stack_get(s, x + dx, y + dy, z + 1)) {
                    continue;
                }
                uint8_t *v = stack_at(result, x + dx, y + dy, z + 1);
                if (!*v) {
                    *v = 1;
                    queue[tail++] = (int)(v - result->solid);
                }
            }
        }
    }
}

// Voxels that the layer below does not carry: sum over k of |S_{k+1} \ dilate(S_k)|, the bed slice
// counting as carried.
static inline uint64_t stack_unsupported(const stack *s, const sf_rule *rule, uint32_t bed_layer)
{
    int bed = stack_bed(s, bed_layer);
    uint64_t sum = 0;
    for (int z = 0; z < s->nz; z++) {
        sf_element e = {0, {0}};
        if (z > 0) {
            e = stack_step(rule, z - 1);
        }
        for (int i = 0; i < s->nx * s->ny; i++) {
            int x = i % s->nx, y = i / s->nx;
            sum += stack_get(s, x, y, z) && z != bed && !stack_carried(s, x, y, z, &e);
        }
    }
    return sum;
}

static inline int stack_is_support_free(const stack *s, const sf_rule *rule, uint32_t bed_layer)
{
    return stack_unsupported(s, rule, bed_layer) == 0;
}

// ---------------------------------------------------------------------------------------------
// To and from the library
// ---------------------------------------------------------------------------------------------

// Where grids of stacks live, and what calls take their memory from: it is full of other bytes each
// time, so who counts on zeros, or reads past the last word of a row, finds something else.
static failing_allocator stack_memory;

static inline const sf_allocator *stack_allocator(void)
{
    if (stack_memory.allocator.alloc == NULL) {
        failing_begin(&stack_memory, -1);
    }
    return &stack_memory.allocator;
}

// Widths of random tests: around the end of a row's first word and of its second; half of them
// narrow.
static inline int stack_wide(void)
{
    return 61 + (int)test_random_below(70);
}

static inline int stack_width(void)
{
    return test_random_below(2) == 0 ? stack_wide() : 1 + (int)test_random_below(20);
}

static inline sf_lattice stack_lattice(int nx, int ny, int nz)
{
    sf_lattice lattice = {(uint32_t)nx, (uint32_t)ny, (uint32_t)nz, 0.1,
                          0.1,          0.1,          NULL,         {0.0, 0.0, 0.0}};
    return lattice;
}

static inline void stack_write(const stack *s, sf_grid *grid)
{
    for (int z = 0; z < s->nz; z++) {
        sf_slice slice = sf_grid_slice(grid, (uint32_t)z);
        for (int y = 0; y < s->ny; y++) {
            for (int x = 0; x < s->nx; x++) {
                CHECK_EQ(sf_slice_set(slice, (uint32_t)x, (uint32_t)y, stack_get(s, x, y, z)),
                         SF_OK);
            }
        }
    }
}

static inline sf_grid *stack_grid(const stack *s)
{
    sf_lattice lattice = stack_lattice(s->nx, s->ny, s->nz);
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, stack_allocator(), &grid), SF_OK);
    stack_write(s, grid);
    return grid;
}

static inline void stack_read(stack *s, const sf_grid *grid)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    stack_clear(s, (int)lattice.nx, (int)lattice.ny, (int)lattice.nz);
    for (int z = 0; z < s->nz; z++) {
        sf_slice slice = sf_grid_slice(grid, (uint32_t)z);
        for (int y = 0; y < s->ny; y++) {
            for (int x = 0; x < s->nx; x++) {
                *stack_at(s, x, y, z) = (uint8_t)sf_slice_get(slice, (uint32_t)x, (uint32_t)y);
            }
        }
    }
}

// The library's trim of a stack.
static inline void library_trim(stack *result, const stack *s, const sf_rule *rule,
                                uint32_t bed_layer)
{
    sf_grid *grid = stack_grid(s);
    CHECK_EQ(sf_grid_trim(grid, rule, bed_layer, NULL, NULL), SF_OK);
    stack_read(result, grid);
    sf_grid_destroy(grid);
}

// A rule whose every step is the disk of this radius in voxels; 0 is straight down only.
static inline sf_rule rule_of_radius(unsigned radius)
{
    sf_rule rule = {.kind = SF_RULE_DISK,
                    .reach_x_q24 = (uint64_t)radius << 24,
                    .reach_y_q24 = (uint64_t)radius << 24};
    return rule;
}

// A rule for cubes at an angle, from whatever kind; the octagon has a step of its own per layer.
static inline sf_rule rule_of_angle(sf_rule_kind kind, double degrees)
{
    sf_lattice lattice = stack_lattice(8, 8, 8);
    sf_rule rule = sf_rule_box3();
    CHECK_EQ(
        sf_rule_make(kind, degrees * (3.14159265358979323846 / 180.0), &lattice, NULL, &rule, NULL),
        SF_OK);
    return rule;
}

// The rules that random tests go through.
static inline sf_rule rule_by_number(int i)
{
    switch (i % 7) {
    case 0:
        return sf_rule_box3();
    case 1:
        return rule_of_angle(SF_RULE_OCTAGON, 30.0);
    case 2:
        return rule_of_angle(SF_RULE_OCTAGON, 45.0);
    case 3:
        return rule_of_angle(SF_RULE_OCTAGON, 62.0);
    case 4:
        return rule_of_angle(SF_RULE_DISK, 45.0);
    case 5:
        return rule_of_angle(SF_RULE_DISK, 72.0);
    default:
        return rule_of_radius(0);
    }
}

#endif

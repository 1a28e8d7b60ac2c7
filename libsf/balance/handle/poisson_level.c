// SPDX-License-Identifier: MIT
// The Laplacian of a domain on all levels.
//
// On each level the same finite volumes: between two corners of a cell flows a quarter of its
// volume over the square of their distance, and nothing flows where there is no cell; so constants
// have no flow, and the surface is natural. A coarse cell has the volume of the fine ones in it,
// which makes the coarse energy of a function that is linear in each coarse cell that of the fine
// one. Where a coarse cell covers a gap between two limbs it joins them; the outer iteration mends
// that.
//
// Values go up and down by trilinear interpolation in the indices, and its transpose: a fine node
// in the middle of an edge, face or cell of coarse ones has two, four or eight parents.

#include "balance/handle/poisson.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <string.h>

static void destroy_level(const sf_allocator *a, sfi_level *l)
{
    sfi_free_array(a, l->neighbour, 6 * l->count, sizeof *l->neighbour);
    sfi_free_array(a, l->flow, 6 * l->count, sizeof *l->flow);
    sfi_free_array(a, l->diagonal, l->count, sizeof *l->diagonal);
    sfi_free_array(a, l->begin, l->count + 1, sizeof *l->begin);
    sfi_free_array(a, l->parent, l->parent_count, sizeof *l->parent);
}

void sfi_poisson_destroy(sfi_poisson *p)
{
    if (p->level_count > 0) {
        sfi_free_array(&p->allocator, p->mass, p->level[0].count, sizeof *p->mass);
    }
    for (uint32_t i = 0; i < p->level_count; i++) {
        destroy_level(&p->allocator, &p->level[i]);
    }
    p->level_count = 0;
}

// ---------------------------------------------------------------------------------------------
// One level
// ---------------------------------------------------------------------------------------------

// Let flow go between two corners of a cell, the second above the first along `axis`.
static void join(sfi_level *l, uint32_t low, uint32_t high, size_t axis, float flow)
{
    l->neighbour[6 * (size_t)low + 3 + axis] = high;
    l->flow[6 * (size_t)low + 3 + axis] += flow;
    l->neighbour[6 * (size_t)high + 2 - axis] = low;
    l->flow[6 * (size_t)high + 2 - axis] += flow;
}

static void add_cell(const sfi_domain *d, size_t cell, sfi_level *l)
{
    const uint32_t *corners = d->corners + 8 * cell, *place = d->place + 3 * cell;
    for (size_t axis = 0; axis < 3; axis++) {
        const double *plane = d->planes[axis] + place[axis];
        double edge = (plane[1] - plane[0]) / d->unit_mm;
        float flow = (float)(0.25 * (double)d->volume[cell] / (edge * edge));
        for (size_t c = 0; c < 8; c++) {
            if ((c >> axis & 1) == 0) {
                join(l, corners[c], corners[c | (size_t)1 << axis], axis, flow);
            }
        }
    }
}

static sf_status make_level(const sfi_domain *d, const sf_allocator *a, sfi_level *l)
{
    size_t six;
    if (!sfi_size_mul(d->node_count, 6, &six)) {
        return SF_ERR_OVERFLOW;
    }
    l->count = d->node_count;
    l->neighbour = sfi_alloc_array(a, six, sizeof *l->neighbour);
    l->flow = sfi_alloc_array(a, six, sizeof *l->flow);
    l->diagonal = sfi_alloc_array(a, l->count, sizeof *l->diagonal);
    if (l->neighbour == NULL || l->flow == NULL || l->diagonal == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(l->flow, 0, six * sizeof *l->flow);
    for (size_t i = 0; i < six; i++) {
        l->neighbour[i] = (uint32_t)(i / 6);
    }
    for (size_t cell = 0; cell < d->cell_count; cell++) {
        add_cell(d, cell, l);
    }
    for (size_t i = 0; i < l->count; i++) {
        const float *f = l->flow + 6 * i;
        l->diagonal[i] = ((f[0] + f[1]) + (f[2] + f[3])) + (f[4] + f[5]);
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Parents
// ---------------------------------------------------------------------------------------------

// The planes of the coarse domain that a fine plane lies between: one, or two next to each other.
static uint32_t span(uint32_t plane, uint32_t last, uint32_t *low)
{
    *low = plane == last ? (plane + 1) / 2 : plane / 2;
    return plane % 2 == 0 || plane == last ? 1 : 2;
}

// All nodes of a coarse domain by their place: a scan over the cells around would cost more.
static sf_status tabulate(const sfi_domain *d, uint32_t **table, size_t *table_count)
{
    size_t row = (size_t)d->cells[0] + 1, slab;
    if (!sfi_size_mul(row, (size_t)d->cells[1] + 1, &slab) ||
        !sfi_size_mul(slab, (size_t)d->cells[2] + 1, table_count)) {
        return SF_ERR_OVERFLOW;
    }
    *table = sfi_alloc_array(&d->allocator, *table_count, sizeof **table);
    if (*table == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < d->node_count; i++) {
        const uint32_t *p = d->node_place + 3 * i;
        (*table)[p[2] * slab + p[1] * row + p[0]] = (uint32_t)i;
    }
    return SF_OK;
}

// Parents of one fine node, or with no table only their number.
static size_t find_parents(const sfi_domain *fine, const sfi_domain *coarse, size_t node,
                           const uint32_t *table, uint32_t *parents)
{
    uint32_t low[3], count[3];
    size_t row = (size_t)coarse->cells[0] + 1, slab = row * ((size_t)coarse->cells[1] + 1), n = 0;
    for (int axis = 0; axis < 3; axis++) {
        count[axis] =
            span(fine->node_place[3 * node + (size_t)axis], fine->cells[axis], &low[axis]);
    }
    for (uint32_t z = low[2]; table != NULL && z < low[2] + count[2]; z++) {
        for (uint32_t y = low[1]; y < low[1] + count[1]; y++) {
            for (uint32_t x = low[0]; x < low[0] + count[0]; x++) {
                parents[n++] = table[z * slab + y * row + x];
            }
        }
    }
    return (size_t)count[0] * count[1] * count[2];
}

static sf_status make_parents(const sfi_domain *fine, const sfi_domain *coarse,
                              const sf_allocator *a, sfi_level *l)
{
    l->begin = sfi_alloc_array(a, l->count + 1, sizeof *l->begin);
    if (l->begin == NULL) {
        return SF_ERR_MEMORY;
    }
    size_t total = 0;
    for (size_t i = 0; i < l->count; i++) {
        l->begin[i] = (uint32_t)total;
        total += find_parents(fine, coarse, i, NULL, NULL);
        if (total > UINT32_MAX) {
            return SF_ERR_OVERFLOW;
        }
    }
    l->begin[l->count] = (uint32_t)total;
    l->parent = sfi_alloc_array(a, total, sizeof *l->parent);
    if (l->parent == NULL) {
        return SF_ERR_MEMORY;
    }
    l->parent_count = total;
    uint32_t *table;
    size_t table_count;
    SF_TRY(tabulate(coarse, &table, &table_count));
    for (size_t i = 0; i < l->count; i++) {
        find_parents(fine, coarse, i, table, l->parent + l->begin[i]);
    }
    sfi_free_array(&coarse->allocator, table, table_count, sizeof *table);
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// All levels
// ---------------------------------------------------------------------------------------------

static sf_status weigh_nodes(const sfi_domain *d, sfi_poisson *p)
{
    p->mass = sfi_alloc_array(&p->allocator, d->node_count, sizeof *p->mass);
    if (p->mass == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(p->mass, 0, d->node_count * sizeof *p->mass);
    for (size_t c = 0; c < 8 * d->cell_count; c++) {
        p->mass[d->corners[c]] += 0.125 * (double)d->volume[c / 8];
    }
    return SF_OK;
}

static int is_bottom(const sfi_domain *d)
{
    return d->node_count <= SFI_BOTTOM_NODES ||
           (d->cells[0] == 1 && d->cells[1] == 1 && d->cells[2] == 1);
}

// Levels below the finest one. `fine` is destroyed with each step down, but for the first.
static sf_status make_levels(const sfi_domain *domain, sfi_poisson *p)
{
    sfi_domain fine = *domain, coarse;
    sf_status status = SF_OK;
    while (status == SF_OK && !is_bottom(&fine) && p->level_count < SFI_LEVELS_MAX) {
        sfi_level *above = &p->level[p->level_count - 1], *l = above + 1;
        status = sfi_domain_coarsen(&fine, &coarse);
        if (status != SF_OK) {
            break;
        }
        memset(l, 0, sizeof *l);
        p->level_count++;
        status = make_level(&coarse, &p->allocator, l);
        if (status == SF_OK) {
            status = make_parents(&fine, &coarse, &p->allocator, above);
        }
        if (p->level_count > 2) {
            sfi_domain_destroy(&fine);
        }
        fine = coarse;
    }
    if (p->level_count > 1) {
        sfi_domain_destroy(&fine);
    }
    return status;
}

sf_status sfi_poisson_create(const sfi_domain *domain, sfi_poisson *poisson)
{
    sfi_poisson made;
    memset(&made, 0, sizeof made);
    made.allocator = domain->allocator;
    made.level_count = 1;
    sf_status status = make_level(domain, &made.allocator, &made.level[0]);
    if (status == SF_OK) {
        status = weigh_nodes(domain, &made);
    }
    if (status == SF_OK) {
        status = make_levels(domain, &made);
    }
    if (status != SF_OK) {
        sfi_poisson_destroy(&made);
        return status;
    }
    *poisson = made;
    return SF_OK;
}

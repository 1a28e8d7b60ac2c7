// SPDX-License-Identifier: MIT
// Densities: what 1 mm3 of each voxel weighs.
//
// Which region a voxel belongs to is found first, as a number of two bytes, and densities are
// written when nothing can fail any more. A voxel belongs to a region, as everywhere, at its
// centre.

#include "balance/wall/levels.h"
#include "base/bits.h"
#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/terms.h"
#include "voxel/slice.h"

#include <sf/density.h>

#include <float.h>
#include <math.h>
#include <string.h>

typedef struct survey {
    sf_lattice lattice;
    sf_allocator allocator;
    uint16_t *owner; // of each voxel: 1 + its region, or 0
    size_t count;    // voxels
    double *levels;
    sf_grid *scratch; // for meshes
} survey;

sf_density_options sf_density_options_default(void)
{
    sf_density_options options = {sizeof options, 1, 1, NULL, NULL, 0};
    return options;
}

static int is_density(double density)
{
    return density > 0 && (float)density > 0 && density <= FLT_MAX;
}

static sf_status check_region(const sf_lattice *lattice, const sf_density_region *r)
{
    if (!is_density(r->density)) {
        return SF_ERR_ARGUMENT;
    }
    switch (r->shape) {
    case SF_DENSITY_BOX:
        for (int i = 0; i < 3; i++) {
            if (!isfinite(r->low_mm[i]) || !isfinite(r->high_mm[i])) {
                return SF_ERR_ARGUMENT;
            }
        }
        return SF_OK;
    case SF_DENSITY_MESH:
        return sf_mesh_validate(r->mesh, NULL);
    case SF_DENSITY_MASK:
        return r->mask != NULL ? sfi_terms_match(lattice, r->mask) : SF_ERR_ARGUMENT;
    default:
        return SF_ERR_ARGUMENT;
    }
}

static sf_status check(const sf_lattice *lattice, const sf_density_options *o, const float *density)
{
    SF_TRY(sf_lattice_validate(lattice));
    if (density == NULL || o->struct_size < sizeof *o || !is_density(o->density) ||
        !(o->infill > 0 && o->infill <= 1) || !is_density(o->density * o->infill) ||
        (o->regions == NULL && o->region_count > 0)) {
        return SF_ERR_ARGUMENT;
    }
    if (o->region_count > SF_DENSITY_REGIONS_MAX) {
        return SF_ERR_OVERFLOW;
    }
    if (o->wall != NULL) {
        SF_TRY(sfi_terms_match(lattice, o->wall));
    }
    for (size_t i = 0; i < o->region_count; i++) {
        SF_TRY(check_region(lattice, &o->regions[i]));
    }
    return SF_OK;
}

static void own_mask(survey *s, const sf_grid *mask, uint16_t owner)
{
    const sf_lattice *l = &s->lattice;
    for (uint32_t k = 0; k < l->nz; k++) {
        sf_slice slice = sf_grid_slice(mask, k);
        for (uint32_t y = 0; y < l->ny; y++) {
            uint16_t *row = s->owner + ((size_t)k * l->ny + y) * l->nx;
            for (size_t i = 0; i < sfi_row_words(l->nx); i++) {
                uint64_t word = sfi_row_word(sfi_slice_row(slice, y), i, l->nx);
                for (; word != 0; word &= word - 1) {
                    row[64 * i + sfi_lowest_bit(word)] = owner;
                }
            }
        }
    }
}

static int is_within(double at, double low, double high)
{
    return at >= low && at < high;
}

static void own_box(survey *s, const sf_density_region *r, uint16_t owner)
{
    const sf_lattice *l = &s->lattice;
    for (uint32_t k = 0; k < l->nz; k++) {
        double z = 0.5 * (s->levels[k] + s->levels[k + 1]);
        for (uint32_t y = 0; is_within(z, r->low_mm[2], r->high_mm[2]) && y < l->ny; y++) {
            double v = l->origin_mm[1] + (y + 0.5) * l->pitch_y_mm;
            uint16_t *row = s->owner + ((size_t)k * l->ny + y) * l->nx;
            for (uint32_t x = 0; is_within(v, r->low_mm[1], r->high_mm[1]) && x < l->nx; x++) {
                double u = l->origin_mm[0] + (x + 0.5) * l->pitch_x_mm;
                row[x] = is_within(u, r->low_mm[0], r->high_mm[0]) ? owner : row[x];
            }
        }
    }
}

static sf_status own_mesh(survey *s, sf_mesh_view mesh, uint16_t owner, sf_task *task)
{
    if (s->scratch == NULL) {
        SF_TRY(sf_grid_create(&s->lattice, &s->allocator, &s->scratch));
    }
    SF_TRY(sf_grid_voxelize(s->scratch, mesh, NULL, &s->allocator, task, NULL));
    own_mask(s, s->scratch, owner);
    return SF_OK;
}

static sf_status find_owners(survey *s, const sf_density_options *o, sf_task *task)
{
    sfi_progress progress = sfi_progress_begin(task);
    for (size_t i = 0; i < o->region_count; i++) {
        const sf_density_region *r = &o->regions[i];
        uint16_t owner = (uint16_t)(i + 1);
        sfi_part part;
        sfi_part_begin(&part, &progress, (double)i / (double)o->region_count,
                       (double)(i + 1) / (double)o->region_count);
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        if (r->shape == SF_DENSITY_BOX) {
            own_box(s, r, owner);
        } else if (r->shape == SF_DENSITY_MASK) {
            own_mask(s, r->mask, owner);
        } else {
            SF_TRY(own_mesh(s, r->mesh, owner, &part.task));
        }
    }
    if (sf_task_is_cancelled(task)) {
        return SF_ERR_CANCELLED;
    }
    sfi_progress_report(&progress, 1, 1);
    return SF_OK;
}

static void write_densities(const survey *s, const sf_density_options *o, float *density)
{
    const sf_lattice *l = &s->lattice;
    size_t row = 0;
    for (uint32_t k = 0; k < l->nz; k++) {
        for (uint32_t y = 0; y < l->ny; y++, row += l->nx) {
            for (uint32_t x = 0; x < l->nx; x++) {
                uint16_t owner = s->owner[row + x];
                int dense = o->wall == NULL || sf_slice_get(sf_grid_slice(o->wall, k), x, y);
                density[row + x] = (float)(owner > 0 ? o->regions[owner - 1].density
                                           : dense   ? o->density
                                                     : o->density * o->infill);
            }
        }
    }
}

sf_status sf_lattice_density(const sf_lattice *lattice, const sf_density_options *options,
                             const sf_allocator *allocator, sf_task *task, float *density)
{
    sf_density_options standard = sf_density_options_default();
    const sf_density_options *o = options != NULL ? options : &standard;
    SF_TRY(check(lattice, o, density));
    survey s = {.lattice = *lattice, .allocator = sfi_allocator_or_default(allocator)};
    if (!sfi_size_mul(lattice->nx, lattice->ny, &s.count) ||
        !sfi_size_mul(s.count, lattice->nz, &s.count) || s.count > SIZE_MAX / sizeof *density) {
        return SF_ERR_OVERFLOW;
    }
    s.owner = sfi_alloc_array(&s.allocator, s.count, sizeof *s.owner);
    s.levels = sfi_levels_create(lattice, &s.allocator);
    sf_status status = SF_ERR_MEMORY;
    if (s.owner != NULL && s.levels != NULL) {
        memset(s.owner, 0, s.count * sizeof *s.owner);
        status = find_owners(&s, o, task);
    }
    if (status == SF_OK) {
        write_densities(&s, o, density);
    }
    sf_grid_destroy(s.scratch);
    sfi_levels_destroy(s.levels, lattice, &s.allocator);
    sfi_free_array(&s.allocator, s.owner, s.count, sizeof *s.owner);
    return status;
}

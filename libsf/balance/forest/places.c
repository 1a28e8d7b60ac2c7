// SPDX-License-Identifier: MIT
// Places: the squares that may be added, numbered, and weighed by levers.
//
// A place weighs what of its square is not wall. Within kept matter each voxel lies in as many
// squares as a square has voxels, so that what places weigh in sum is in proportion to what their
// union weighs; at its borders, and for a strut by itself, it is less. So weights decide between
// places, and what a result weighs is always counted by its voxels.
//
// Weights are integers, the most that a place of the lattice could count being 2^30: sums of any
// number of them are exact, and which set is least does not depend on the order of a sum.

#include "balance/forest/places.h"

#include "base/bits.h"
#include "base/memory.h"
#include "base/status.h"
#include "voxel/slice.h"

#include <math.h>

#define PLACES_MOST (UINT32_MAX - 15)

uint32_t sfi_place_at(const sfi_places *p, uint32_t k, uint32_t x, uint32_t y)
{
    const uint64_t *row = sfi_slice_row(sf_grid_slice(p->in->places, k), y);
    uint32_t number = p->first[(size_t)k * p->in->lattice.ny + y];
    const sfi_kernels *kernels = sfi_kernels_get();
    uint64_t part = row[x / 64] & ((UINT64_C(1) << (x % 64)) - 1);
    if (x >= 64) {
        number += (uint32_t)kernels->popcount(row, x / 64);
    }
    return number + (uint32_t)kernels->popcount(&part, 1);
}

static sf_status number_rows(sfi_places *p)
{
    sf_lattice l = p->in->lattice;
    const sfi_kernels *kernels = sfi_kernels_get();
    uint64_t count = 0;
    size_t row = 0;
    for (uint32_t k = 0; k < l.nz; k++) {
        sf_slice slice = sf_grid_slice(p->in->places, k);
        for (uint32_t y = 0; y < l.ny; y++) {
            p->first[row++] = (uint32_t)count;
            count += kernels->popcount(sfi_slice_row(slice, y), sfi_row_words(l.nx));
            if (count > PLACES_MOST) {
                return SF_ERR_OVERFLOW;
            }
        }
    }
    p->first[row] = p->count = (uint32_t)count;
    return SF_OK;
}

static void find_heights(sfi_places *p)
{
    const sf_lattice *l = &p->in->lattice;
    double bottom = l->origin_mm[2];
    for (uint32_t k = 0; k < l->nz; k++) {
        double height = sf_lattice_layer_height(l, k);
        p->z_mm[k] = bottom + 0.5 * height;
        bottom += height;
    }
}

// ---------------------------------------------------------------------------------------------
// Masses
// ---------------------------------------------------------------------------------------------

// sums = for each voxel, that of `width` values from it on along x; what is beyond the row is 0.
static void add_along_x(const float *values, uint32_t nx, uint32_t width, float *sums)
{
    for (uint32_t x = 0; x < nx; x++) {
        float sum = 0;
        for (uint32_t i = 0; i < width && x + i < nx; i++) {
            sum += values[x + i];
        }
        sums[x] = sum;
    }
}

// Masses are in units of a volume, and of 2^100 where densities are so large that the sums over a
// square would leave a float's range.
static float unit_of(const sfi_interior *in, const float *density)
{
    sf_lattice l = in->lattice;
    for (uint32_t k = 0; density != NULL && k < l.nz; k++) {
        for (uint32_t y = 0; y < l.ny; y++) {
            const uint64_t *row = sfi_slice_row(sf_grid_slice(in->solid, k), y);
            const float *dense = density + ((size_t)k * l.ny + y) * l.nx;
            for (uint32_t x = 0; x < l.nx; x++) {
                if ((row[x / 64] >> (x % 64) & 1) != 0 && dense[x] > 0x1p60f) {
                    return 0x1p-100f;
                }
            }
        }
    }
    return 1;
}

// What each voxel of layer k weighs, where it is not wall, summed up over `width` of them along x.
static void weigh_rows(const sfi_places *p, const float *density, uint32_t k, float unit,
                       float *values, float *sums)
{
    const sfi_interior *in = p->in;
    sf_lattice l = in->lattice;
    sf_slice solid = sf_grid_slice(in->solid, k), wall = sf_grid_slice(in->wall, k);
    float one = (float)(l.pitch_x_mm * l.pitch_y_mm * sf_lattice_layer_height(&l, k) / p->unit_mm3);
    for (uint32_t y = 0; y < l.ny; y++) {
        const uint64_t *all = sfi_slice_row(solid, y), *stays = sfi_slice_row(wall, y);
        const float *dense = density != NULL ? density + ((size_t)k * l.ny + y) * l.nx : NULL;
        for (uint32_t x = 0; x < l.nx; x++) {
            int is_loose = (int)((all[x / 64] & ~stays[x / 64]) >> (x % 64) & 1);
            values[x] = !is_loose ? 0 : dense != NULL ? dense[x] * unit * one : one;
        }
        add_along_x(values, l.nx, in->width, sums + (size_t)y * l.nx);
    }
}

// Masses of the places of layer k.
static void weigh_layer(sfi_places *p, uint32_t k, const float *sums)
{
    const sfi_interior *in = p->in;
    sf_slice places = sf_grid_slice(in->places, k);
    uint32_t nx = in->lattice.nx, i = p->first[(size_t)k * in->lattice.ny];
    for (uint32_t y = 0; y < in->lattice.ny; y++) {
        const uint64_t *row = sfi_slice_row(places, y);
        for (size_t w = 0; w < sfi_row_words(nx); w++) {
            for (uint64_t word = row[w]; word != 0; word &= word - 1) {
                const float *from = sums + (size_t)y * nx + w * 64 + sfi_lowest_bit(word);
                float sum = 0;
                for (uint32_t j = 0; j < in->width; j++) {
                    sum += from[(size_t)j * nx];
                }
                p->mass[i++] = sum;
                p->most_mass = sum > p->most_mass ? sum : p->most_mass;
            }
        }
    }
}

static sf_status find_masses(sfi_places *p, const float *density)
{
    const sfi_interior *in = p->in;
    size_t nx = in->lattice.nx, ny = in->lattice.ny;
    float *values = sfi_alloc_array(&in->allocator, nx, sizeof *values);
    float *sums = sfi_alloc_array(&in->allocator, ny, nx * sizeof *sums);
    sf_status status = values != NULL && sums != NULL ? SF_OK : SF_ERR_MEMORY;
    float unit = unit_of(in, density);
    for (uint32_t k = 0; status == SF_OK && k < in->lattice.nz; k++) {
        status = sf_task_is_cancelled(in->task) ? SF_ERR_CANCELLED : SF_OK;
        if (status == SF_OK && sfi_slice_any(sf_grid_slice(in->places, k))) {
            weigh_rows(p, density, k, unit, values, sums);
            weigh_layer(p, k, sums);
        }
    }
    sfi_free_array(&in->allocator, values, nx, sizeof *values);
    sfi_free_array(&in->allocator, sums, ny, nx * sizeof *sums);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

static size_t row_count(const sfi_interior *in)
{
    return (size_t)in->lattice.nz * in->lattice.ny + 1; // a grid of that many rows was made
}

static sf_status create(sfi_places *p, const float *density)
{
    const sf_allocator *a = &p->in->allocator;
    const sf_lattice *l = &p->in->lattice;
    p->first = sfi_alloc_array(a, row_count(p->in), sizeof *p->first);
    p->z_mm = sfi_alloc_array(a, l->nz, sizeof *p->z_mm);
    if (p->first == NULL || p->z_mm == NULL) {
        return SF_ERR_MEMORY;
    }
    SF_TRY(number_rows(p));
    find_heights(p);
    p->unit_mm3 = l->pitch_x_mm * l->pitch_y_mm * sf_lattice_layer_height(l, 0);
    if (p->count == 0) {
        return SF_OK;
    }
    p->mass = sfi_alloc_array(a, p->count, sizeof *p->mass);
    p->weight = sfi_alloc_array(a, p->count, sizeof *p->weight);
    p->price = sfi_alloc_array(a, p->count, sizeof *p->price);
    p->next = sfi_alloc_array(a, p->count, sizeof *p->next);
    p->gain = sfi_alloc_array(a, p->count, sizeof *p->gain);
    p->state = sfi_alloc_array(a, p->count, sizeof *p->state);
    p->best = sfi_alloc_array(a, p->count, sizeof *p->best);
    p->load = sfi_alloc_array(a, p->count, sizeof *p->load);
    if (p->mass == NULL || p->weight == NULL || p->price == NULL || p->next == NULL ||
        p->gain == NULL || p->state == NULL || p->best == NULL || p->load == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < p->count; i++) {
        p->state[i] = 0;
        p->load[i] = 0;
    }
    return find_masses(p, density);
}

sf_status sfi_places_create(const sfi_interior *in, const float *density, sfi_places *p)
{
    *p = (sfi_places){.in = in};
    sf_status status = create(p, density);
    if (status != SF_OK) {
        sfi_places_destroy(p);
    }
    return status;
}

void sfi_places_destroy(sfi_places *p)
{
    if (p->in == NULL) {
        return;
    }
    const sf_allocator *a = &p->in->allocator;
    sfi_free_array(a, p->first, row_count(p->in), sizeof *p->first);
    sfi_free_array(a, p->z_mm, p->in->lattice.nz, sizeof *p->z_mm);
    sfi_free_array(a, p->mass, p->count, sizeof *p->mass);
    sfi_free_array(a, p->weight, p->count, sizeof *p->weight);
    sfi_free_array(a, p->price, p->count, sizeof *p->price);
    sfi_free_array(a, p->next, p->count, sizeof *p->next);
    sfi_free_array(a, p->gain, p->count, sizeof *p->gain);
    sfi_free_array(a, p->state, p->count, sizeof *p->state);
    sfi_free_array(a, p->best, p->count, sizeof *p->best);
    sfi_free_array(a, p->load, p->count, sizeof *p->load);
    *p = (sfi_places){0};
}

// ---------------------------------------------------------------------------------------------
// Weights
// ---------------------------------------------------------------------------------------------

// The most that the lever counts anywhere in the lattice's box, either way.
static double most_of(const sfi_places *p, const sfi_lever *lever)
{
    const sf_lattice *l = &p->in->lattice;
    double most = 0, top = p->z_mm[l->nz - 1] - p->z_mm[0];
    for (int corner = 0; corner < 8; corner++) {
        double x = l->origin_mm[0] + (corner & 1 ? l->nx * l->pitch_x_mm : 0);
        double y = l->origin_mm[1] + (corner & 2 ? l->ny * l->pitch_y_mm : 0);
        double here = fabs(sfi_lever_at(lever, x, y, p->z_mm[0] + (corner & 4 ? top : 0)));
        most = here > most ? here : most;
    }
    return most;
}

void sfi_places_weigh(sfi_places *p, const sfi_lever *lever)
{
    const sfi_interior *in = p->in;
    const sf_lattice *l = &in->lattice;
    double most = most_of(p, lever) * p->most_mass, half = 0.5 * in->width;
    double scale = most > 0 ? SFI_PLACE_WEIGHT / most : 0;
    uint32_t i = 0;
    for (uint32_t k = 0; k < l->nz; k++) {
        sf_slice places = sf_grid_slice(in->places, k);
        for (uint32_t y = 0; y < l->ny; y++) {
            const uint64_t *row = sfi_slice_row(places, y);
            double from = sfi_lever_at(lever, l->origin_mm[0] + half * l->pitch_x_mm,
                                       l->origin_mm[1] + (y + half) * l->pitch_y_mm, p->z_mm[k]);
            double step = lever->pull[0] * l->pitch_x_mm;
            for (size_t w = 0; w < sfi_row_words(l->nx); w++) {
                for (uint64_t word = row[w]; word != 0; word &= word - 1) {
                    double x = (double)(w * 64 + sfi_lowest_bit(word));
                    p->weight[i] = (int32_t)floor(p->mass[i] * (from + step * x) * scale + 0.5);
                    i++;
                }
            }
        }
    }
}

void sfi_places_read(const sfi_places *p, uint32_t k, unsigned bits, sf_slice slice)
{
    const sfi_interior *in = p->in;
    sf_slice places = sf_grid_slice(in->places, k);
    uint32_t i = p->first[(size_t)k * in->lattice.ny];
    for (uint32_t y = 0; y < slice.height; y++) {
        const uint64_t *row = sfi_slice_row(places, y);
        uint64_t *out = sfi_slice_row(slice, y);
        for (size_t w = 0; w < sfi_row_words(slice.width); w++) {
            uint64_t read = 0;
            for (uint64_t word = row[w]; word != 0; word &= word - 1) {
                read |= (p->state[i++] & bits) != 0 ? word & (~word + 1) : 0;
            }
            out[w] = read;
        }
    }
}

// SPDX-License-Identifier: MIT
// The sweeps that make a path map, from the bed up.
//
// With N(v) what can carry v, and a(v) what filling v costs,
//
//     E(v) = 0 at matter,   E(v) = a(v) + min over u in N(v) of E(u) elsewhere,
//
// and on the bed, or where a voxel is exempt, E(v) is what filling it costs there. The reset to
// zero at matter is what the paper's map lacks: without it E is the number of layers and what the
// cone meets on the bed, and high above the bed all directions cost the same.
//
// Narrow: where a step reaches no farther than a voxel, a cost and a direction are one number of 16
// bits, 16 cost + code, so that one minimum finds both; only the codes are kept, four bits for each
// voxel, because the cost of a path is its length. The keys of two layers are all that is computed
// with, in rows with a margin of voxels that have no path, so that no row needs to know where it
// ends. The kernel is path_row() of simd/kernels.h.
//
// Wide: elements of any reach and costs of any size, 32 bits for each voxel; the minimum is taken
// offset by offset along whole rows, which compilers turn into vectors.

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"
#include "support/grow/path_map.h"

// What no path may enter, 64 voxels of a row from column 64 * i on.
static uint64_t shut_word(const sfi_site *site, uint32_t z, uint32_t y, size_t i)
{
    return ~(sfi_slice_row(sf_grid_slice(site->grid, z), y)[i] | sfi_site_free_word(site, z, y, i));
}

static int is_exempt(const sfi_site *site, uint32_t z, uint32_t y, uint32_t x)
{
    return site->terms.exempt != NULL && sf_slice_get(sf_grid_slice(site->terms.exempt, z), x, y);
}

static int has_bit(const uint64_t *row, uint32_t x)
{
    return (row[x / 64] >> (x % 64) & 1) != 0;
}

// ---------------------------------------------------------------------------------------------
// Narrow
// ---------------------------------------------------------------------------------------------

#define MARGIN 32 // keys on either side of a row: a cache line

int sfi_path_code_step(unsigned code, int *dx, int *dy)
{
    for (*dy = -1; *dy <= 1; ++*dy) {
        for (*dx = -1; *dx <= 1; ++*dx) {
            unsigned of_x = *dx < 0 ? SFI_PATH_LESS_X : *dx > 0 ? SFI_PATH_MORE_X : 0;
            unsigned of_y = *dy < 0 ? SFI_PATH_LESS_Y : *dy > 0 ? SFI_PATH_MORE_Y : 0;
            if (of_x + of_y == code) {
                return 1;
            }
        }
    }
    return 0;
}

typedef struct key_layers {
    uint16_t *keys; // two layers of ny + 2 rows
    size_t row;     // keys from row to row
    size_t count;   // of all keys
    uint64_t *shut; // a row
    size_t words;
} key_layers;

// Key of voxel (0, y) of one of the layers; y may be -1.
static uint16_t *keys_at(const key_layers *k, uint32_t which, uint32_t ny, int64_t y)
{
    size_t row = (size_t)(y + 1) + (which % 2) * ((size_t)ny + 2);
    return k->keys + row * k->row + MARGIN;
}

static sf_status create_keys(key_layers *k, const sfi_site *site)
{
    k->words = sfi_row_words(site->lattice.nx);
    k->row = 64 * k->words + 2 * MARGIN;
    if (!sfi_size_mul(k->row, 2 * ((size_t)site->lattice.ny + 2), &k->count)) {
        return SF_ERR_OVERFLOW;
    }
    k->keys = sfi_alloc_array(&site->allocator, k->count, sizeof *k->keys);
    k->shut = sfi_alloc_array(&site->allocator, k->words, sizeof *k->shut);
    if (k->keys == NULL || k->shut == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < k->count; i++) {
        k->keys[i] = SFI_PATH_NONE;
    }
    for (size_t i = 0; i < k->words; i++) {
        k->shut[i] = i + 1 < k->words ? 0 : ~sfi_tail_mask(site->lattice.nx);
    }
    return SF_OK;
}

static void destroy_keys(key_layers *k, const sfi_site *site)
{
    sfi_free_array(&site->allocator, k->keys, k->count, sizeof *k->keys);
    sfi_free_array(&site->allocator, k->shut, k->words, sizeof *k->shut);
}

static void fill_shut(const key_layers *k, const sfi_site *site, uint32_t z, uint32_t y)
{
    if (site->terms.forbid != NULL || site->terms.act != NULL) {
        for (size_t i = 0; i < k->words; i++) {
            k->shut[i] = shut_word(site, z, y, i);
        }
    }
}

// A held voxel costs itself and no more.
static void set_held(const key_layers *k, const sfi_site *site, uint32_t z, uint32_t y,
                     uint16_t *keys)
{
    const uint64_t *roots = sfi_slice_row(sf_grid_slice(site->roots, z), y);
    for (uint32_t x = 0; site->terms.exempt != NULL && x < site->lattice.nx; x++) {
        if (is_exempt(site, z, y, x) && !has_bit(roots, x) && !has_bit(k->shut, x)) {
            keys[x] = 16;
        }
    }
}

static void sweep_bed(const key_layers *k, const sf_path_map *map)
{
    const sfi_site *site = &map->site;
    uint32_t nx = site->lattice.nx, ny = site->lattice.ny, bed = site->bed;
    for (uint32_t y = 0; y < ny; y++) {
        const uint64_t *roots = sfi_slice_row(sf_grid_slice(site->roots, bed), y);
        uint16_t *keys = keys_at(k, bed, ny, y);
        fill_shut(k, site, bed, y);
        for (uint32_t x = 0; x < nx; x++) {
            uint32_t steps = sfi_distance_steps(map->bed.square[(size_t)y * nx + x]);
            keys[x] = (uint16_t)(has_bit(roots, x)     ? 0
                                 : has_bit(k->shut, x) ? SFI_PATH_NONE
                                                       : 16 * steps);
        }
        set_held(k, site, bed, y, keys);
    }
}

static sf_status sweep_layer(const key_layers *k, sf_path_map *map, uint32_t z)
{
    const sfi_site *site = &map->site;
    const sfi_kernels *kernels = sfi_kernels_get();
    uint32_t ny = site->lattice.ny;
    uint64_t *codes = map->codes + (size_t)(z - site->bed - 1) * map->code_words;
    sf_slice roots = sf_grid_slice(site->roots, z);
    sf_element e;
    SF_TRY(sf_rule_element(&site->plain, z - 1, &e));
    sfi_path_shape shape = e.reach_y == 0         ? SFI_PATH_POINT
                           : e.half_width[1] == 0 ? SFI_PATH_PLUS
                                                  : SFI_PATH_BOX;
    for (uint32_t y = 0; y < ny; y++) {
        const uint16_t *below[3] = {keys_at(k, z - 1, ny, (int64_t)y - 1), keys_at(k, z - 1, ny, y),
                                    keys_at(k, z - 1, ny, (int64_t)y + 1)};
        uint16_t *keys = keys_at(k, z, ny, y);
        fill_shut(k, site, z, y);
        kernels->path_row(keys, codes + (size_t)y * 4 * k->words, below, shape,
                          sfi_slice_row(roots, y), k->shut, k->words);
        set_held(k, site, z, y, keys);
        // Bits past the width, of which the shape may hold some, are no matter to land on.
        for (size_t x = site->lattice.nx; x < 64 * k->words; x++) {
            keys[x] = SFI_PATH_NONE;
        }
    }
    return SF_OK;
}

sf_status sfi_path_map_sweep_codes(sf_path_map *map, const sfi_stage *stage)
{
    const sfi_site *site = &map->site;
    key_layers k = {0};
    sf_status status = create_keys(&k, site);
    if (status == SF_OK) {
        sweep_bed(&k, map);
    }
    for (uint32_t i = 1; status == SF_OK && i < map->layers; i++) {
        status = sf_task_is_cancelled(stage->task) ? SF_ERR_CANCELLED
                                                   : sweep_layer(&k, map, site->bed + i);
        sfi_progress_report(stage->progress, stage->done + i + 1, stage->total);
    }
    destroy_keys(&k, site);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Wide
// ---------------------------------------------------------------------------------------------

static uint32_t sum_of(uint32_t a, uint32_t b)
{
    return a < SFI_COST_NONE - 1 - b ? a + b : SFI_COST_NONE - 1;
}

static void take_least(uint32_t *restrict out, const uint32_t *restrict in, uint32_t count)
{
    for (uint32_t x = 0; x < count; x++) {
        out[x] = in[x] < out[x] ? in[x] : out[x];
    }
}

// out = the least cost of the voxels below that can carry each voxel of row y.
static void least_below(const uint32_t *below, const sf_element *e, uint32_t y,
                        const sf_lattice *lattice, uint32_t *out)
{
    uint32_t nx = lattice->nx;
    for (uint32_t x = 0; x < nx; x++) {
        out[x] = SFI_COST_NONE;
    }
    uint32_t y0 = y > e->reach_y ? y - e->reach_y : 0;
    uint32_t y1 = e->reach_y < lattice->ny - y ? y + e->reach_y + 1 : lattice->ny;
    for (uint32_t v = y0; v < y1; v++) {
        const uint32_t *in = below + (size_t)v * nx;
        uint32_t half = e->half_width[v > y ? v - y : y - v];
        for (uint32_t dx = 0; dx <= half && dx < nx; dx++) {
            take_least(out, in + dx, nx - dx);
            take_least(out + dx, in, nx - dx);
        }
    }
}

// Costs of layer z, which are the least ones below on entry (above the bed), become its own.
static void settle_layer(const sf_path_map *map, uint32_t z, const uint32_t *square,
                         uint32_t *costs)
{
    const sfi_site *site = &map->site;
    uint32_t nx = site->lattice.nx;
    for (uint32_t y = 0; y < site->lattice.ny; y++) {
        const uint64_t *roots = sfi_slice_row(sf_grid_slice(site->roots, z), y);
        uint32_t *row = costs + (size_t)y * nx;
        uint64_t shut = 0;
        for (uint32_t x = 0; x < nx; x++) {
            shut = x % 64 == 0 ? shut_word(site, z, y, x / 64) : shut;
            uint32_t add = square != NULL ? sfi_distance_steps(square[(size_t)y * nx + x]) : 1;
            if (has_bit(roots, x)) {
                row[x] = 0;
            } else if ((shut >> (x % 64) & 1) != 0) {
                row[x] = SFI_COST_NONE;
            } else if (z == site->bed || is_exempt(site, z, y, x)) {
                int is_one = map->cost == SF_PATH_COST_COUNT && is_exempt(site, z, y, x);
                row[x] = is_one ? 1 : add;
            } else {
                row[x] = row[x] != SFI_COST_NONE ? sum_of(row[x], add) : SFI_COST_NONE;
            }
        }
    }
}

static sf_status sweep_costs_layer(const sf_path_map *map, uint32_t z, uint32_t *square,
                                   uint32_t *scratch)
{
    const sfi_site *site = &map->site;
    uint32_t *costs = map->costs + (size_t)(z - site->bed) * map->cost_places;
    const uint32_t *distances = z == site->bed ? map->bed.square : NULL;
    if (z > site->bed) {
        sf_element e;
        SF_TRY(sf_rule_element(&site->plain, z - 1, &e));
        for (uint32_t y = 0; y < site->lattice.ny; y++) {
            least_below(costs - map->cost_places, &e, y, &site->lattice,
                        costs + (size_t)y * site->lattice.nx);
        }
    }
    if (map->cost == SF_PATH_COST_NEARNESS && z > site->bed) {
        sfi_slice_distance(sf_grid_slice(site->roots, z), square, scratch);
        distances = square;
    }
    settle_layer(map, z, distances, costs);
    return SF_OK;
}

sf_status sfi_path_map_sweep_costs(sf_path_map *map, const sfi_stage *stage)
{
    const sfi_site *site = &map->site;
    int is_near = map->cost == SF_PATH_COST_NEARNESS;
    uint32_t *square = NULL;
    if (is_near) {
        square = sfi_alloc_array(&site->allocator, map->cost_places, sizeof *square);
    }
    sf_status status = is_near && square == NULL ? SF_ERR_MEMORY : SF_OK;
    for (uint32_t i = 0; status == SF_OK && i < map->layers; i++) {
        status = sf_task_is_cancelled(stage->task)
                     ? SF_ERR_CANCELLED
                     : sweep_costs_layer(map, site->bed + i, square, map->bed.scratch);
        sfi_progress_report(stage->progress, stage->done + i + 1, stage->total);
    }
    sfi_free_array(&site->allocator, square, map->cost_places, sizeof *square);
    return status;
}

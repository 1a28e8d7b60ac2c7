// SPDX-License-Identifier: MIT
// Path map: the closest supporting paths of all voxels, for many questions to one grid.
//
// A map is made in one sweep (path_sweep.c) and is either narrow, a direction of four bits for each
// voxel, or wide, a cost of 32 bits. Walking either, each step goes to a voxel below of least cost,
// among these to the closest in the plane, then to the least y, then to the least x: in a narrow
// map that is how the codes are ordered, in a wide one it is looked up. A voxel that is solid has a
// direction too: where it would go if it were in the air.
//
// Which form: a key of the narrow map has twelve bits for the cost, and no cost exceeds the layers
// above the bed and the farthest distance on the bed, so a look at the rule and the bed decides.

#include "support/grow/path_map.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

sf_path_map_options sf_path_map_options_default(void)
{
    sf_path_map_options options = {sizeof options, SF_LANDING_ANY, SF_PATH_COST_COUNT};
    return options;
}

// ---------------------------------------------------------------------------------------------
// Life
// ---------------------------------------------------------------------------------------------

void sf_path_map_destroy(sf_path_map *map)
{
    if (map == NULL) {
        return;
    }
    sf_allocator allocator = map->site.allocator;
    sfi_free_array(&allocator, map->codes, (size_t)map->layers - 1,
                   map->code_words * sizeof *map->codes);
    sfi_free_array(&allocator, map->costs, map->layers, map->cost_places * sizeof *map->costs);
    sfi_bed_destroy(&map->bed, &map->site);
    sfi_site_close(&map->site);
    sfi_free_array(&allocator, map, 1, sizeof *map);
}

// Whether all steps reach no farther than a voxel, and all costs fit a key.
static sf_status decide_form(const sf_path_map *map, int *is_narrow)
{
    const sf_lattice *lattice = &map->site.lattice;
    uint64_t most = 1;
    for (size_t i = 0; i < map->cost_places; i++) {
        uint64_t steps = sfi_distance_steps(map->bed.square[i]);
        most = steps > most ? steps : most;
    }
    *is_narrow = map->cost == SF_PATH_COST_COUNT && map->layers + most <= SFI_PATH_COST_MAX;
    for (uint32_t k = map->site.bed; *is_narrow && k + 1 < lattice->nz; k++) {
        sf_element e;
        SF_TRY(sf_rule_element(&map->site.plain, k, &e));
        *is_narrow = e.reach_y <= 1 && e.half_width[0] == e.reach_y;
    }
    return SF_OK;
}

static sf_status fill_map(sf_path_map *map, sfi_stage *stage)
{
    const sf_lattice *lattice = &map->site.lattice;
    size_t bytes;
    int is_narrow;
    map->layers = lattice->nz - map->site.bed;
    stage->done = stage->total - map->layers;
    map->code_words = 4 * sfi_row_words(lattice->nx) * lattice->ny;
    map->cost_places = (size_t)lattice->nx * lattice->ny;
    SF_TRY(sfi_bed_update(&map->bed, &map->site));
    SF_TRY(decide_form(map, &is_narrow));
    if (!is_narrow) {
        if (!sfi_size_mul(map->cost_places, sizeof *map->costs, &bytes) ||
            !sfi_size_mul(bytes, map->layers, &bytes)) {
            return SF_ERR_OVERFLOW;
        }
        map->costs = sfi_alloc_array(&map->site.allocator, map->layers,
                                     map->cost_places * sizeof *map->costs);
        return map->costs != NULL ? sfi_path_map_sweep_costs(map, stage) : SF_ERR_MEMORY;
    }
    if (!sfi_size_mul(map->code_words, sizeof *map->codes, &bytes) ||
        !sfi_size_mul(bytes, map->layers, &bytes)) {
        return SF_ERR_OVERFLOW;
    }
    map->codes = sfi_alloc_array(&map->site.allocator, (size_t)map->layers - 1,
                                 map->code_words * sizeof *map->codes);
    return map->codes != NULL || map->layers == 1 ? sfi_path_map_sweep_codes(map, stage)
                                                  : SF_ERR_MEMORY;
}

static int is_good(const sf_path_map_options *options)
{
    return options != NULL && options->struct_size >= sizeof *options &&
           (options->landing == SF_LANDING_ANY || options->landing == SF_LANDING_ALIVE) &&
           (options->cost == SF_PATH_COST_COUNT || options->cost == SF_PATH_COST_NEARNESS);
}

sf_status sf_path_map_create(const sf_grid *grid, const sf_terms *terms,
                             const sf_path_map_options *options, const sf_allocator *allocator,
                             sf_task *task, sf_path_map **map)
{
    sfi_ground ground;
    if (map == NULL || !is_good(options)) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_terms_check(terms, grid, &ground));
    if (terms->rule.kind == SF_RULE_SLACK) {
        return SF_ERR_UNSUPPORTED;
    }
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_path_map *made = sfi_alloc_array(&from, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_path_map empty = {.cost = options->cost};
    *made = empty;
    // What is alive is the first half of the work, if it is asked for.
    sfi_progress progress = sfi_progress_begin(task);
    sfi_stage stage = {task, &progress, 0, 2 * (uint64_t)ground.lattice.nz};
    sf_status status = sfi_site_open(&made->site, grid, terms, options->landing, allocator, &stage);
    if (status != SF_OK) {
        sfi_free_array(&from, made, 1, sizeof *made);
        return status;
    }
    status = fill_map(made, &stage);
    if (status != SF_OK) {
        sf_path_map_destroy(made);
        return status;
    }
    *map = made;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Walk
// ---------------------------------------------------------------------------------------------

static uint32_t cost_at(const sf_path_map *map, uint32_t x, uint32_t y, uint32_t z)
{
    size_t layer = (size_t)(z - map->site.bed) * map->cost_places;
    return map->costs[layer + (size_t)y * map->site.lattice.nx + x];
}

// The next voxel of a walk on a map of codes; 0 where there is none.
static int step_by_code(const sf_path_map *map, sf_voxel *at)
{
    size_t words = map->code_words / map->site.lattice.ny;
    const uint64_t *row =
        map->codes + (size_t)(at->z - map->site.bed - 1) * map->code_words + (size_t)at->y * words;
    int dx, dy;
    if (!sfi_path_code_step((unsigned)(row[at->x / 16] >> (at->x % 16 * 4) & 15), &dx, &dy)) {
        return 0;
    }
    at->x = (uint32_t)((int64_t)at->x + dx);
    at->y = (uint32_t)((int64_t)at->y + dy);
    at->z--;
    return 1;
}

// The same on a map of costs.
static int step_by_cost(const sf_path_map *map, sf_voxel *at)
{
    const sf_lattice *lattice = &map->site.lattice;
    sfi_spot spot = {0, 0, 0, 0, 0};
    sf_element e;
    (void)!sf_rule_element(&map->site.plain, at->z - 1, &e); // it has served the sweep already
    uint32_t y0 = at->y > e.reach_y ? at->y - e.reach_y : 0;
    uint32_t y1 = e.reach_y < lattice->ny - at->y ? at->y + e.reach_y + 1 : lattice->ny;
    for (uint32_t y = y0; y < y1; y++) {
        uint32_t half = e.half_width[y > at->y ? y - at->y : at->y - y];
        uint32_t x0 = at->x > half ? at->x - half : 0;
        uint32_t x1 = half < lattice->nx - at->x ? at->x + half + 1 : lattice->nx;
        for (uint32_t x = x0; x < x1; x++) {
            sfi_spot_offer(&spot, cost_at(map, x, y, at->z - 1), *at, x, y);
        }
    }
    at->x = spot.x;
    at->y = spot.y;
    at->z--;
    return spot.first != SFI_COST_NONE;
}

// Walk down from a voxel, writing the path where it is not NULL. Returns 0 where there is none.
static int walk(const sf_path_map *map, sf_voxel from, sf_voxel *path, sf_path *found)
{
    const sfi_site *site = &map->site;
    size_t count = 0;
    sf_path_end end = SF_PATH_END_MATTER;
    sf_voxel at = from;
    for (;;) {
        if (!(map->codes != NULL ? step_by_code(map, &at) : step_by_cost(map, &at))) {
            return 0;
        }
        if (sf_slice_get(sf_grid_slice(site->roots, at.z), at.x, at.y)) {
            break;
        }
        if (path != NULL) {
            path[count] = at;
        }
        count++;
        int is_held = sf_slice_get(sfi_mask_slice(site->terms.exempt, at.z), at.x, at.y);
        if (is_held || at.z == site->bed) {
            end = is_held ? SF_PATH_END_HELD : SF_PATH_END_BED;
            break;
        }
    }
    *found = sfi_path_make(count, end, at, map->bed.square[(size_t)at.y * site->lattice.nx + at.x]);
    return 1;
}

sf_status sf_path_map_walk(const sf_path_map *map, sf_voxel from, sf_voxel *path, size_t capacity,
                           sf_path *found)
{
    if (map == NULL || found == NULL || (path == NULL && capacity > 0) ||
        from.x >= map->site.lattice.nx || from.y >= map->site.lattice.ny ||
        from.z >= map->site.lattice.nz) {
        return SF_ERR_ARGUMENT;
    }
    if (sfi_path_is_trivial(&map->site, from, found)) {
        return SF_OK;
    }
    if (from.z < map->site.bed) {
        return SF_ERR_INFEASIBLE;
    }
    sf_path answer;
    if (!walk(map, from, NULL, &answer)) {
        return SF_ERR_INFEASIBLE;
    }
    if (map->cost == SF_PATH_COST_NEARNESS) {
        sf_voxel first = from;
        (void)!step_by_cost(map, &first);
        answer.cost = cost_at(map, first.x, first.y, first.z);
    }
    *found = answer;
    if (answer.count > capacity) {
        return SF_ERR_CAPACITY;
    }
    (void)!walk(map, from, path, &answer);
    return SF_OK;
}

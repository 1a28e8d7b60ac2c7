// SPDX-License-Identifier: MIT
// Repairs grids from stdin and prints them, for tests/optimum/*.py to compare with the least.
//
// usage: repaired [grow]; with grow, sf_grid_grow() has them.
//
// A grid is a line "nx ny nz" and a line of nx * ny * nz digits 0 or 1 in (layer, y, x) order. Each
// is answered by a line of as many digits. Rule box3, every change costs 1.

#include <sf/grow.h>
#include <sf/repair.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXTENT_MAX 128

static void must(sf_status status)
{
    if (status != SF_OK) {
        fprintf(stderr, "repaired: %s\n", sf_status_message(status));
        exit(1);
    }
}

// Read or write every voxel of a grid. Returns 0 at the end of the input.
static int each_voxel(sf_grid *grid, int is_reading)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    for (uint32_t k = 0; k < lattice.nz; k++) {
        for (uint32_t i = 0; i < lattice.nx * lattice.ny; i++) {
            sf_slice slice = sf_grid_slice(grid, k);
            uint32_t x = i % lattice.nx, y = i / lattice.nx;
            char digit;
            if (!is_reading) {
                putchar(sf_slice_get(slice, x, y) ? '1' : '0');
            } else if (scanf(" %c", &digit) == 1) {
                must(sf_slice_set(slice, x, y, digit == '1'));
            } else {
                return 0;
            }
        }
    }
    return 1;
}

static void make(sf_grid *grid, int is_grow)
{
    sf_repair_options options = sf_repair_options_default();
    must(is_grow ? sf_grid_grow(grid, &options.terms, NULL, NULL, NULL, NULL)
                 : sf_grid_repair(grid, &options, NULL, NULL, NULL, NULL));
}

int main(int argc, char **argv)
{
    int is_grow = argc > 1 && strcmp(argv[1], "grow") == 0;
    unsigned n[3];
    while (scanf("%u %u %u", &n[0], &n[1], &n[2]) == 3) {
        if (n[0] > EXTENT_MAX || n[1] > EXTENT_MAX || n[2] > EXTENT_MAX) {
            return 2;
        }
        sf_lattice lattice = {n[0], n[1], n[2], 1, 1, 1, NULL, {0, 0, 0}};
        sf_grid *grid;
        must(sf_grid_create(&lattice, NULL, &grid));
        if (!each_voxel(grid, 1)) {
            return 2;
        }
        make(grid, is_grow);
        (void)each_voxel(grid, 0);
        putchar('\n');
        sf_grid_destroy(grid);
    }
    return 0;
}

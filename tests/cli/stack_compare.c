// SPDX-License-Identifier: MIT
// Prints how two stacks of one lattice differ: stack-compare A B X0 Y0 Z0 X1 Y1 Z1 counts, voxel by
// voxel, what is solid in A and not in B and the other way round, first of the voxels whose centres
// lie in that box (mm), then of all others: "removed added removed added". Exit status 1 when a
// stack cannot be read or the lattices are not the same.

#include <sf/io.h>

#include <stdio.h>
#include <stdlib.h>

static sf_grid *read_grid(const char *folder)
{
    sf_directory *directory = NULL;
    sf_grid *grid = NULL;
    sf_stack_info info;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_directory_read(folder, NULL, &directory, &fault);
    if (status == SF_OK) {
        status = sf_stack_read(sf_directory_folder(directory), NULL, NULL, &grid, &info, &fault);
        sf_directory_close(directory);
    }
    if (status != SF_OK) {
        fprintf(stderr, "stack-compare: %s: %s\n", folder, fault.message);
    }
    return grid;
}

// Whether the centre of a voxel lies in the box.
static int inside(const sf_lattice *l, uint32_t x, uint32_t y, uint32_t k, const double box[6])
{
    double at[3] = {l->origin_mm[0] + (x + 0.5) * l->pitch_x_mm,
                    l->origin_mm[1] + (y + 0.5) * l->pitch_y_mm,
                    sf_lattice_layer_bottom(l, k) + 0.5 * sf_lattice_layer_height(l, k)};
    for (int i = 0; i < 3; i++) {
        if (at[i] < box[i] || at[i] > box[3 + i]) {
            return 0;
        }
    }
    return 1;
}

static int compare(const sf_grid *a, const sf_grid *b, const double box[6])
{
    sf_lattice l = sf_grid_lattice(a), m = sf_grid_lattice(b);
    unsigned long count[4] = {0, 0, 0, 0};
    if (l.nx != m.nx || l.ny != m.ny || l.nz != m.nz) {
        fprintf(stderr, "stack-compare: the lattices differ\n");
        return 1;
    }
    for (uint32_t k = 0; k < l.nz; k++) {
        sf_slice s = sf_grid_slice(a, k), t = sf_grid_slice(b, k);
        for (uint32_t y = 0; y < l.ny; y++) {
            for (uint32_t x = 0; x < l.nx; x++) {
                int here = sf_slice_get(s, x, y), there = sf_slice_get(t, x, y);
                if (here != there) {
                    count[(inside(&l, x, y, k, box) ? 0 : 2) + (there ? 1 : 0)]++;
                }
            }
        }
    }
    printf("%lu %lu %lu %lu\n", count[0], count[1], count[2], count[3]);
    return 0;
}

int main(int argc, char **argv)
{
    double box[6];
    int failed = 1;
    if (argc != 9) {
        fprintf(stderr, "usage: stack-compare A B X0 Y0 Z0 X1 Y1 Z1\n");
        return 1;
    }
    for (int i = 0; i < 6; i++) {
        box[i] = strtod(argv[3 + i], NULL);
    }
    sf_grid *a = read_grid(argv[1]), *b = read_grid(argv[2]);
    if (a != NULL && b != NULL) {
        failed = compare(a, b, box);
    }
    sf_grid_destroy(a);
    sf_grid_destroy(b);
    return failed;
}

// SPDX-License-Identifier: MIT
// Weights for a script: solids and points on stdin, the values at the corners of cells on stdout.
//
// Each job: nx ny nz pitch_x pitch_y layer method count, then nx * ny * nz digits, layers first,
// then x y z of each point. Each answer: the number of corners, then x y z and the weights of each.

#include "balance/handle/weights.h"

#include <stdio.h>

#define MUST(call)                                                                                 \
    if ((call) != SF_OK) {                                                                         \
        fprintf(stderr, "weighed: %s failed\n", #call);                                            \
        return 1;                                                                                  \
    }

static int read_grid(sf_lattice lattice, sf_grid **grid)
{
    MUST(sf_grid_create(&lattice, NULL, grid));
    for (uint32_t n = 0; n < lattice.nx * lattice.ny * lattice.nz; n++) {
        char digit;
        if (scanf(" %c", &digit) != 1) {
            return 1;
        }
        uint32_t plane = lattice.nx * lattice.ny;
        MUST(sf_slice_set(sf_grid_slice(*grid, n / plane), n % lattice.nx, n % plane / lattice.nx,
                          digit == '1'));
    }
    return 0;
}

static int answer(const sf_grid *grid, int method, size_t count)
{
    sf_handle handles[SF_HANDLE_MAX];
    sf_weights *weights = NULL;
    sf_weights_options options = sf_weights_options_default();
    for (size_t j = 0; j < count; j++) {
        sf_handle h = {SF_HANDLE_POINT, {0, 0, 0}, 0, NULL, 0};
        handles[j] = h;
        if (scanf("%lf %lf %lf", handles[j].at_mm, handles[j].at_mm + 1, handles[j].at_mm + 2) !=
            3) {
            return 1;
        }
    }
    options.method = (sf_weights_method)method;
    options.tolerance = 1e-7;
    MUST(sf_weights_create(grid, handles, count, &options, NULL, NULL, &weights, NULL));
    const sfi_domain *d = &weights->domain;
    printf("%zu\n", d->node_count);
    for (size_t i = 0; i < d->node_count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            printf("%.17g ", d->planes[axis][d->node_place[3 * i + (size_t)axis]]);
        }
        for (size_t j = 0; j < count; j++) {
            printf("%.17g%c", weights->values[i * count + j], j + 1 < count ? ' ' : '\n');
        }
    }
    sf_weights_destroy(weights);
    return 0;
}

int main(void)
{
    sf_lattice l = {0, 0, 0, 0, 0, 0, NULL, {0, 0, 0}};
    int method;
    unsigned count;
    while (scanf("%u %u %u %lf %lf %lf %d %u", &l.nx, &l.ny, &l.nz, &l.pitch_x_mm, &l.pitch_y_mm,
                 &l.layer_mm, &method, &count) == 8) {
        sf_grid *grid = NULL;
        if (count > SF_HANDLE_MAX || read_grid(l, &grid) != 0 || answer(grid, method, count) != 0) {
            return 1;
        }
        sf_grid_destroy(grid);
    }
    return 0;
}

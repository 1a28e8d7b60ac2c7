// SPDX-License-Identifier: MIT
// Where a part lies.

#include "extent.h"

#include "turned.h"

#include <stdio.h>

// The corners of the part, in build axes: its mesh's, or its grid's where it has none.
static void find_corners(const part *p, double low[3], double high[3])
{
    if (p->mesh != NULL && sf_mesh_bounds(sf_mesh_get_view(p->mesh), low, high) == SF_OK) {
        return;
    }
    sf_lattice l = sf_grid_lattice(p->grid);
    for (int i = 0; i < 3; i++) {
        low[i] = l.origin_mm[i];
    }
    high[0] = low[0] + l.nx * l.pitch_x_mm;
    high[1] = low[1] + l.ny * l.pitch_y_mm;
    high[2] = sf_lattice_layer_bottom(&l, l.nz);
}

void extent_words(const cli_job *job, const part *p, char words[EXTENT_WORDS_SIZE])
{
    double build[2][3], a[3], b[3];
    find_corners(p, build[0], build[1]);
    turned_to_input(job, build[0], a);
    turned_to_input(job, build[1], b);
    for (int i = 0; i < 3; i++) {
        if (a[i] > b[i]) {
            double swap = a[i];
            a[i] = b[i];
            b[i] = swap;
        }
    }
    snprintf(words, EXTENT_WORDS_SIZE, "x %.4g to %.4g, y %.4g to %.4g, z %.4g to %.4g mm", a[0],
             b[0], a[1], b[1], a[2], b[2]);
}

// SPDX-License-Identifier: MIT
// Why: scans and cages fall into thousands of pieces, most without a handle, and each follows the
// closest point of those that have one (<sf/weights.h>). Which that is is found again by looking at
// every box, on lattices with layers of any height.

#include "solid.h"

#include <sf/weights.h>

enum { NX = 14, NY = 11, NZ = 9, VOXELS = NX * NY * NZ };

static void split(int voxel, int at[3])
{
    at[0] = voxel % NX;
    at[1] = voxel / NX % NY;
    at[2] = voxel / NX / NY;
}

static int is_solid(const sf_grid *grid, int x, int y, int z)
{
    return x >= 0 && y >= 0 && z >= 0 && x < NX && y < NY && z < NZ &&
           sf_slice_get(sf_grid_slice(grid, (uint32_t)z), (uint32_t)x, (uint32_t)y);
}

// Number the pieces, connected by corners: piece[voxel], or -1. Returns how many there are.
static int find_pieces(const sf_grid *grid, int *piece)
{
    static int queue[VOXELS];
    int count = 0;
    memset(piece, 0xff, VOXELS * sizeof *piece);
    for (int v = 0; v < VOXELS; v++) {
        int at[3], length = 0;
        split(v, at);
        if (piece[v] >= 0 || !is_solid(grid, at[0], at[1], at[2])) {
            continue;
        }
        piece[v] = count;
        queue[length++] = v;
        for (int q = 0; q < length; q++) {
            split(queue[q], at);
            for (int n = 0; n < 27; n++) {
                int x = at[0] + n % 3 - 1, y = at[1] + n / 3 % 3 - 1, z = at[2] + n / 9 - 1;
                int other = (z * NY + y) * NX + x;
                if (is_solid(grid, x, y, z) && piece[other] < 0) {
                    piece[other] = count;
                    queue[length++] = other;
                }
            }
        }
        count++;
    }
    return count;
}

static void box_of(const sf_lattice *l, int voxel, double low[3], double high[3])
{
    const double pitch[2] = {l->pitch_x_mm, l->pitch_y_mm};
    int at[3];
    split(voxel, at);
    for (int d = 0; d < 2; d++) {
        low[d] = l->origin_mm[d] + at[d] * pitch[d];
        high[d] = low[d] + pitch[d];
    }
    low[2] = sf_lattice_layer_bottom(l, (uint32_t)at[2]);
    high[2] = low[2] + sf_lattice_layer_height(l, (uint32_t)at[2]);
}

// Square of the distance from the middle of a voxel to another's box, and the point there.
static double reach(const sf_lattice *l, int voxel, int other, double point[3])
{
    double low[3], high[3], square = 0, middle;
    box_of(l, voxel, low, high);
    for (int d = 0; d < 3; d++) {
        point[d] = 0.5 * (low[d] + high[d]);
    }
    box_of(l, other, low, high);
    for (int d = 0; d < 3; d++) {
        middle = point[d];
        point[d] = fmin(fmax(middle, low[d]), high[d]);
        square += (point[d] - middle) * (point[d] - middle);
    }
    return square;
}

// Whether a loose voxel's weights are those of a closest point; of several as close any will do.
static int follows(const sf_weights *weights, const sf_lattice *l, const int *piece, int held,
                   int number)
{
    double least = 1e9, point[3], w[2], v[2];
    for (int pass = 0; pass < 2; pass++) {
        for (int a = 0; a < VOXELS; a++) {
            for (int b = 0; piece[a] == number && b < VOXELS; b++) {
                double square = piece[b] == held ? reach(l, a, b, point) : 1e9;
                if (pass == 0) {
                    least = fmin(least, square);
                } else if (square <= least * (1 + 1e-12)) {
                    double low[3], high[3], middle[3];
                    box_of(l, a, low, high);
                    for (int d = 0; d < 3; d++) {
                        middle[d] = 0.5 * (low[d] + high[d]);
                    }
                    CHECK_EQ(sf_weights_at(weights, point, w, NULL), SF_OK);
                    CHECK_EQ(sf_weights_at(weights, middle, v, NULL), SF_OK);
                    if (fabs(v[0] - w[0]) < 1e-12 && fabs(v[1] - w[1]) < 1e-12) {
                        return 1;
                    }
                }
            }
        }
    }
    return 0;
}

static void every_loose_piece_follows_the_closest(void)
{
    static int piece[VOXELS];
    static const double heights[NZ] = {1, 0.4, 0.7, 1, 2, 1, 0.5, 0.9, 1.3};
    for (int round = 0; round < 12; round++) {
        sf_lattice lattice = {NX, NY, NZ, 1, 0.8, 1, round % 2 ? heights : NULL, {-3, 2, 5}};
        sf_grid *grid = random_solid(&lattice, 0.04 + 0.02 * (round % 3));
        uint32_t middle = NZ / 2;
        for (uint32_t y = 2; y < 6; y++) { // a bar with a handle at each end
            sf_rect bar = {1, y, 7, y + 1};
            CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, middle), bar, 1), SF_OK);
        }
        int count = find_pieces(grid, piece);
        int held = piece[((int)middle * NY + 3) * NX + 1];
        double low[3], high[3];
        sf_handle handles[2] = {{.kind = SF_HANDLE_POINT}, {.kind = SF_HANDLE_POINT}};
        for (int j = 0; j < 2; j++) {
            box_of(&lattice, ((int)middle * NY + 3) * NX + 1 + 5 * j, low, high);
            for (int d = 0; d < 3; d++) {
                handles[j].at_mm[d] = 0.5 * (low[d] + high[d]);
            }
        }
        sf_weights_options how = sf_weights_options_default();
        how.cell_mm = 0.1; // a cell for each voxel
        sf_weights *weights = NULL;
        CHECK_EQ(sf_weights_create(grid, handles, 2, &how, NULL, NULL, &weights, NULL), SF_OK);
        CHECK_EQ(sf_weights_describe(weights).loose_count, count - 1);
        CHECK(count > 5);
        for (int p = 0; p < count; p++) {
            CHECK(p == held || follows(weights, &lattice, piece, held, p));
        }
        sf_weights_destroy(weights);
        sf_grid_destroy(grid);
    }
}

// One voxel in twenty-seven: twelve thousand pieces, and one handle in a corner. Looked for piece
// by piece this took half a minute.
static void thousands_of_pieces_take_no_time(void)
{
    enum { SIDE = 69 };
    sf_lattice lattice = {SIDE, SIDE, SIDE, 1, 1, 1, NULL, {0, 0, 0}};
    sf_handle handle = {.kind = SF_HANDLE_POINT, .at_mm = {0.5, 0.5, 0.5}};
    sf_grid *grid = NULL;
    sf_weights *weights = NULL;
    double w;
    const double p[3] = {66.5, 3.5, 33.5};
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    for (uint32_t i = 0; i < SIDE * SIDE * SIDE / 27; i++) {
        CHECK_EQ(
            sf_slice_set(sf_grid_slice(grid, 3 * (i / 529)), 3 * (i % 23), 3 * (i / 23 % 23), 1),
            SF_OK);
    }
    CHECK_EQ(sf_weights_create(grid, &handle, 1, NULL, NULL, NULL, &weights, NULL), SF_OK);
    CHECK_EQ(sf_weights_describe(weights).loose_count, 12166);
    CHECK_EQ(sf_weights_at(weights, p, &w, NULL), SF_OK);
    CHECK_NEAR(w, 1, 1e-15);
    sf_weights_destroy(weights);
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(every_loose_piece_follows_the_closest);
    TEST(thousands_of_pieces_take_no_time);
    return test_finish();
}

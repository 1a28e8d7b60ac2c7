// SPDX-License-Identifier: MIT
// Shapes to time on, the same in every run.

#ifndef SF_BENCH_SCENES_H
#define SF_BENCH_SCENES_H

#include <sf/mesh.h>

// n^3 voxels of 1 mm, a third of them in sixty balls; or each at random, one in two.
sf_grid *scene_balls(uint32_t n);
sf_grid *scene_noise(uint32_t n);

// Add the voxels whose centres lie in a ball, in voxels.
void scene_add_ball(sf_grid *grid, double x, double y, double z, double radius);

// n^3 voxels, 23 M of 512^3 solid: four balls over a plate, three of them in the air.
sf_grid *scene_four_balls(uint32_t n);

// A slab of four layers from layer z on, `margin` voxels from the sides of an empty n x n x nz
// grid.
sf_grid *scene_slab(uint32_t n, uint32_t nz, uint32_t z, uint32_t margin);

// The first twelve of the balls: most of the grid is empty, and far from anything.
sf_grid *scene_far_balls(uint32_t n);

// A layer of a resin printer's plate: parts, and thousands of supports. Free its words.
sf_slice scene_plate(uint32_t width, uint32_t height);
sf_slice scene_noise_slice(uint32_t width, uint32_t height);

// A sphere with bumps in the box [0, size]^3, 20 * n^2 triangles with shared vertices.
sf_mesh *scene_bumpy_sphere(uint32_t n, double size);

#endif

// SPDX-License-Identifier: MIT
// Volume, centre of mass and inertia of a grid: exact sums over slices, weighted by their heights.
//
// With origin o, pitch p and index i, a voxel's centre lies at o + (i + 1/2) p, and its own second
// moment about that is p^2 / 12 times its volume. Sums are taken about the middle of the lattice,
// so that moving them to the centre of mass subtracts nothing large.

#include "mass.h"

#include <math.h>
#include <string.h>

// Sums over voxels: volume, first and second moments about a point.
typedef struct sums {
    double volume, first[3], second[3], xy, xz, yz;
} sums;

// A slice of height h whose middle lies at z, all about the middle of the lattice.
static void add_slice(sums *s, const sf_lattice *lattice, sf_slice slice, double h, double z)
{
    sf_slice_sums in;
    if (sf_slice_measure(slice, &in) != SF_OK || in.count == 0) {
        return;
    }
    const double px = lattice->pitch_x_mm, py = lattice->pitch_y_mm;
    const double n = (double)in.count, voxel = px * py * h;
    const double x0 = 0.5 * (1.0 - lattice->nx), y0 = 0.5 * (1.0 - lattice->ny);
    const double x = (double)in.x + n * x0, y = (double)in.y + n * y0;
    const double xx = (double)in.xx + 2 * x0 * (double)in.x + n * x0 * x0;
    const double yy = (double)in.yy + 2 * y0 * (double)in.y + n * y0 * y0;
    const double xy = (double)in.xy + y0 * (double)in.x + x0 * (double)in.y + n * x0 * y0;
    s->volume += voxel * n;
    s->first[0] += voxel * px * x;
    s->first[1] += voxel * py * y;
    s->first[2] += voxel * z * n;
    s->second[0] += voxel * px * px * (xx + n / 12);
    s->second[1] += voxel * py * py * (yy + n / 12);
    s->second[2] += voxel * n * (z * z + h * h / 12);
    s->xy += voxel * px * py * xy;
    s->xz += voxel * px * x * z;
    s->yz += voxel * py * y * z;
}

sf_mass mass_of_grid(const sf_grid *grid)
{
    sf_mass mass;
    sums s;
    memset(&mass, 0, sizeof mass);
    memset(&s, 0, sizeof s);
    sf_lattice lattice = sf_grid_lattice(grid);
    double low = sf_lattice_layer_bottom(&lattice, 0);
    double middle = (low + sf_lattice_layer_bottom(&lattice, lattice.nz)) / 2;
    for (uint32_t k = 0; k < lattice.nz; k++) {
        double h = sf_lattice_layer_height(&lattice, k);
        low = lattice.heights_mm == NULL ? sf_lattice_layer_bottom(&lattice, k) : low;
        add_slice(&s, &lattice, sf_grid_slice(grid, k), h, low + h / 2 - middle);
        low += h;
    }
    const double v = s.volume, x = s.first[0] / v, y = s.first[1] / v, z = s.first[2] / v;
    const double xx = s.second[0] - v * x * x, yy = s.second[1] - v * y * y;
    const double zz = s.second[2] - v * z * z;
    mass.volume_mm3 = v;
    mass.com_mm[0] = lattice.origin_mm[0] + 0.5 * lattice.nx * lattice.pitch_x_mm + x;
    mass.com_mm[1] = lattice.origin_mm[1] + 0.5 * lattice.ny * lattice.pitch_y_mm + y;
    mass.com_mm[2] = middle + z;
    const double inertia[6] = {yy + zz,          xx + zz,          xx + yy,
                               v * x * y - s.xy, v * x * z - s.xz, v * y * z - s.yz};
    memcpy(mass.inertia_mm5, inertia, sizeof inertia);
    return mass;
}

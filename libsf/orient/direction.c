// SPDX-License-Identifier: MIT
// Directions: where to look for a good way up.
//
// Parts stand on flat faces, and most were drawn along axes; so these come first, and a spread over
// the whole sphere finds what nobody thought of.
//
// Flat faces. Normals are sorted into bins of a cube map, 64 x 64 on each side, about a degree and
// a half wide. A bin collects the area of its triangles and remembers the largest of them, whose
// normal stands for the bin: exact for a flat face, however finely it is cut, because neighbours of
// its plane are all the same. The bins with most area, if that is a hundredth of all, are taken.
//
// The spread is a Fibonacci lattice: z in equal steps, longitude by the golden angle. No sine is
// called: the golden angle's turn is applied again and again, and the point is put back on its
// circle each time, so the bytes are the same everywhere.
//
// Source: R. Swinbank, R. J. Purser, "Fibonacci grids: A novel approach to global modelling",
// Quarterly Journal of the Royal Meteorological Society 132, 2006.

#include "orient/direction.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

enum { SIDE = 64, BINS = 6 * SIDE * SIDE };

// Cosine and sine of the golden angle, pi (3 - sqrt 5).
#define GOLDEN_COS (-0.73736887807831963)
#define GOLDEN_SIN 0.67549029426152362

typedef struct bin {
    double area, largest;
    double normal[3]; // of the largest triangle, times its area
} bin;

static double length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

void sfi_facets(sf_mesh_view mesh, int inside_out, sfi_facet *facets)
{
    double half = inside_out ? -0.5 : 0.5;
    for (size_t i = 0; i < mesh.triangle_count; i++) {
        const uint32_t *t = mesh.triangles + 3 * i;
        const double *a = mesh.vertices + 3 * (size_t)t[0], *b = mesh.vertices + 3 * (size_t)t[1],
                     *c = mesh.vertices + 3 * (size_t)t[2];
        double p[3], q[3], *n = facets[i].normal;
        for (int d = 0; d < 3; d++) {
            p[d] = b[d] - a[d];
            q[d] = c[d] - a[d];
        }
        n[0] = half * (p[1] * q[2] - p[2] * q[1]);
        n[1] = half * (p[2] * q[0] - p[0] * q[2]);
        n[2] = half * (p[0] * q[1] - p[1] * q[0]);
    }
}

// ---------------------------------------------------------------------------------------------
// Flat faces
// ---------------------------------------------------------------------------------------------

// The place of a coordinate in [-1, 1] among SIDE.
static size_t place(double t)
{
    double at = floor((t + 1) * (SIDE / 2));
    return at < 0 ? 0 : at > SIDE - 1 ? SIDE - 1 : (size_t)at;
}

static size_t bin_of(const double n[3])
{
    int axis = 0;
    for (int d = 1; d < 3; d++) {
        axis = fabs(n[d]) > fabs(n[axis]) ? d : axis;
    }
    double most = fabs(n[axis]);
    size_t side = (size_t)(2 * axis + (n[axis] < 0));
    return (side * SIDE + place(n[(axis + 1) % 3] / most)) * SIDE + place(n[(axis + 2) % 3] / most);
}

// Sort the facets into bins; returns the area of all.
static double fill_bins(const sfi_facet *facets, size_t count, bin *bins)
{
    double total = 0;
    memset(bins, 0, BINS * sizeof *bins);
    for (size_t i = 0; i < count; i++) {
        const double *n = facets[i].normal;
        double area = length(n);
        if (!(area > 0)) {
            continue;
        }
        bin *b = &bins[bin_of(n)];
        b->area += area;
        if (area > b->largest) {
            b->largest = area;
            memcpy(b->normal, n, sizeof b->normal);
        }
        total += area;
    }
    return total;
}

// The fullest bin, emptied; NULL where none holds `least`.
static bin *take_fullest(bin *bins, double least)
{
    bin *best = &bins[0];
    for (size_t i = 1; i < BINS; i++) {
        best = bins[i].area > best->area ? &bins[i] : best;
    }
    if (!(best->area >= least) || !(best->area > 0)) {
        return NULL;
    }
    best->area = 0;
    return best;
}

// ---------------------------------------------------------------------------------------------
// All of them
// ---------------------------------------------------------------------------------------------

static void add(double (*up)[3], size_t *count, double x, double y, double z)
{
    double v[3] = {x, y, z};
    memcpy(up[*count], v, sizeof v);
    *count += 1;
}

// Whether a direction is among those there are, but for rounding.
static int is_known(double (*up)[3], size_t count, const double v[3])
{
    for (size_t i = 0; i < count; i++) {
        double dx = up[i][0] - v[0], dy = up[i][1] - v[1], dz = up[i][2] - v[2];
        if (dx * dx + dy * dy + dz * dz < 1e-12) {
            return 1;
        }
    }
    return 0;
}

// The largest flat faces to the bed.
static void add_flats(double (*up)[3], size_t *count, bin *bins, double least)
{
    const bin *flat = take_fullest(bins, least);
    for (int i = 0; i < SFI_FLATS_MAX && flat != NULL; i++, flat = take_fullest(bins, least)) {
        double v[3];
        for (int d = 0; d < 3; d++) {
            v[d] = 0 - flat->normal[d] / flat->largest; // no negative zeros
        }
        if (!is_known(up, *count, v)) {
            add(up, count, v[0], v[1], v[2]);
        }
    }
}

static void add_spread(double (*up)[3], size_t *count, size_t spread)
{
    double c = 1, s = 0;
    for (size_t i = 0; i < spread; i++) {
        double z = 1 - (2 * (double)i + 1) / (double)spread, r = sqrt(1 - z * z);
        add(up, count, r * c, r * s, z);
        double turned = c * GOLDEN_COS - s * GOLDEN_SIN;
        s = c * GOLDEN_SIN + s * GOLDEN_COS;
        r = sqrt(turned * turned + s * s);
        c = turned / r;
        s /= r;
    }
}

sf_status sfi_directions(const sfi_facet *facets, size_t facet_count, size_t spread,
                         const sf_allocator *allocator, double (*up)[3], size_t *count)
{
    bin *bins = sfi_alloc_array(allocator, BINS, sizeof *bins);
    if (bins == NULL) {
        return SF_ERR_MEMORY;
    }
    *count = 0;
    for (int axis = 2; axis >= 0; axis--) {
        for (int sign = 1; sign >= -1; sign -= 2) {
            add(up, count, axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0);
        }
    }
    add_flats(up, count, bins, fill_bins(facets, facet_count, bins) / 100);
    add_spread(up, count, spread);
    sfi_free_array(allocator, bins, BINS, sizeof *bins);
    return SF_OK;
}

// For z >= 0: the turn around the axis up x z,
//
//     I + [w]x + [w]x^2 / (1 + z),   w = up x (0, 0, 1) = (y, -x, 0)
//
// and below the plane that of the mirror image, after half a turn around x.
void sfi_direction_turn(const double up[3], double matrix[9])
{
    double flip = up[2] < 0 ? -1 : 1;
    double x = up[0], y = flip * up[1], z = flip * up[2], f = 1 / (1 + z);
    double rows[9] = {1 - x * x * f, -x * y * f, -x, -x * y * f, 1 - y * y * f, -y, x, y, z};
    for (int i = 0; i < 9; i++) {
        matrix[i] = (i % 3 == 0 ? rows[i] : flip * rows[i]) + 0.0; // no negative zeros
    }
}

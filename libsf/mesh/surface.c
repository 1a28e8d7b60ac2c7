// SPDX-License-Identifier: MIT
// The surface of a grid: its voxel faces as a closed, oriented 2-manifold.
//
// Every face between a solid and an empty voxel becomes two triangles. Where voxels touch only
// along an edge or in a corner, plain faces would meet there more than two at an edge, and after
// vertices of equal position are merged no mesh of them would be a manifold. So a lattice vertex
// has a copy for each fan of faces around it (mesh/fans.c), moved by a sixteenth of a voxel. One
// case is left: an edge between two solid voxels that touch only there, both ends of which have one
// fan that uses the edge twice. There each of the two voxels gets a vertex in the middle of the
// edge, moved into the voxel; it belongs to two faces of the same voxel and needs no table.
//
// A sixteenth is far from the half that separates faces from centres of voxels, and each face is
// still crossed once by the line through the two centres: voxelising the surface on the same
// lattice gives the same grid.
//
// The grid is walked twice by the same code, first to count and then to write, with the vertex
// numbers of two lattice layers at hand. Words without a border are passed over whole.

#include <sf/mesh.h>

#include "base/bits.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"
#include "mesh/fans.h"
#include "mesh/mesh.h"
#include "mesh/smooth.h"
#include "simd/kernels.h"
#include "voxel/slice.h"

#include <string.h>

#define SHIFT_VX 0.0625 // how far copies of a vertex move
#define NOBODY UINT32_MAX

// Vertices of one layer of the lattice: number of the first copy, and what lies around.
typedef struct vertex_layer {
    uint32_t *first;
    uint8_t *around;
} vertex_layer;

typedef struct walk {
    const sf_grid *grid;
    sf_lattice lattice;
    sfi_fans fans;
    vertex_layer below, above;                     // of the layer of voxels at work
    size_t layer_vertices;                         // (nx + 1) * (ny + 1)
    double z_mm, height_below_mm, height_above_mm; // of the vertex layer at work
    double *vertices;                              // NULL while counting
    uint32_t *triangles;
    uint64_t vertex_count, triangle_count;
} walk;

// Rows of a slice; beyond the grid there is a row of nothing.
static const uint64_t *row_at(const walk *w, int64_t y, int64_t k)
{
    if (y < 0 || k < 0 || y >= w->lattice.ny || k >= w->lattice.nz) {
        return sfi_empty_row;
    }
    sf_slice slice = sf_grid_slice(w->grid, (uint32_t)k);
    return slice.words + (size_t)y * slice.stride;
}

// ---------------------------------------------------------------------------------------------
// Vertices
// ---------------------------------------------------------------------------------------------

static uint32_t add_vertex(walk *w, double x, double y, double z_mm)
{
    uint64_t number = w->vertex_count++;
    if (w->vertices != NULL) {
        double *at = w->vertices + 3 * number;
        at[0] = w->lattice.origin_mm[0] + x * w->lattice.pitch_x_mm;
        at[1] = w->lattice.origin_mm[1] + y * w->lattice.pitch_y_mm;
        at[2] = z_mm;
    }
    return (uint32_t)number;
}

// z of a shift from the vertex layer at work.
static double shifted_z(const walk *w, int shift)
{
    double height = shift < 0 ? w->height_below_mm : shift > 0 ? w->height_above_mm : 0;
    return w->z_mm + shift * SHIFT_VX * height;
}

// The copies of vertex (x, y) of the layer at work.
static void add_copies(walk *w, uint32_t x, uint32_t y, uint8_t around)
{
    size_t place = (size_t)y * (w->lattice.nx + 1) + x;
    w->above.first[place] = (uint32_t)w->vertex_count;
    w->above.around[place] = around;
    for (unsigned f = 0; f < w->fans.count[around]; f++) {
        const int8_t *shift = w->fans.shift[around][f];
        add_vertex(w, x + SHIFT_VX * shift[0], y + SHIFT_VX * shift[1], shifted_z(w, shift[2]));
    }
}

// Vertices in row y of lattice layer k, from the four rows of voxels around it.
static void add_vertex_row(walk *w, uint32_t y, uint32_t k)
{
    const uint64_t *rows[4] = {row_at(w, (int64_t)y - 1, (int64_t)k - 1),
                               row_at(w, y, (int64_t)k - 1), row_at(w, (int64_t)y - 1, k),
                               row_at(w, y, k)};
    size_t count = sfi_row_words(w->lattice.nx + 1);
    uint64_t carry[4] = {0, 0, 0, 0};
    for (size_t i = 0; i < count; i++) {
        uint64_t right[4], left[4], any = 0, all = ~UINT64_C(0);
        for (int r = 0; r < 4; r++) {
            right[r] = sfi_row_word(rows[r], i, w->lattice.nx);
            left[r] = right[r] << 1 | carry[r];
            carry[r] = right[r] >> 63;
            any |= right[r] | left[r];
            all &= right[r] & left[r];
        }
        for (uint64_t mixed = any & ~all; mixed != 0; mixed &= mixed - 1) {
            uint32_t bit = sfi_lowest_bit(mixed);
            unsigned around = 0;
            for (unsigned r = 0; r < 4; r++) {
                around |= (unsigned)((left[r] >> bit & 1) | (right[r] >> bit & 1) << 1) << 2 * r;
            }
            add_copies(w, (uint32_t)(64 * i) + bit, y, (uint8_t)around);
        }
    }
}

static void add_vertex_layer(walk *w, uint32_t k)
{
    const sf_lattice *l = &w->lattice;
    w->height_below_mm = k > 0 ? sf_lattice_layer_height(l, k - 1) : 0;
    w->height_above_mm = k < l->nz ? sf_lattice_layer_height(l, k) : 0;
    if (l->heights_mm == NULL) {
        w->z_mm = sf_lattice_layer_bottom(l, k);
    } else { // the same sum, term by term
        w->z_mm = k > 0 ? w->z_mm + w->height_below_mm : l->origin_mm[2];
    }
    for (uint32_t y = 0; y <= l->ny; y++) {
        add_vertex_row(w, y, k);
    }
}

// ---------------------------------------------------------------------------------------------
// Faces
// ---------------------------------------------------------------------------------------------

// Corners of a voxel's faces, counter-clockwise from outside, as octants of the voxel: bit 0 set on
// the side of larger x, and so on. Face 2 a is the one towards smaller coordinates on axis a.
static const uint8_t face_corners[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

// One solid voxel whose faces are being added.
typedef struct voxel {
    uint32_t x, y, k;
    uint32_t first[8];   // first copy of each corner's vertex
    uint8_t around[8];   // what lies around each corner
    uint32_t middle[12]; // vertices in the middle of edges, by axis and place
} voxel;

static void look_up_corners(const walk *w, voxel *v)
{
    for (unsigned c = 0; c < 8; c++) {
        const vertex_layer *layer = (c & 4) != 0 ? &w->above : &w->below;
        size_t place = (size_t)(v->y + (c >> 1 & 1)) * (w->lattice.nx + 1) + v->x + (c & 1);
        v->first[c] = layer->first[place];
        v->around[c] = layer->around[place];
    }
    for (int e = 0; e < 12; e++) {
        v->middle[e] = NOBODY;
    }
}

// Seen from its corner c the voxel is the opposite octant.
static uint32_t corner_vertex(const walk *w, const voxel *v, unsigned corner, unsigned axis)
{
    return v->first[corner] + w->fans.fan[v->around[corner]][3 * (7 - corner) + axis];
}

// Whether the edge at a corner is shared with a voxel that touches only there, in the same fan.
static int edge_is_doubled_at(const walk *w, const voxel *v, unsigned corner, unsigned axis,
                              unsigned other_axis)
{
    unsigned self = 7 - corner, opposite = self ^ 1u << axis ^ 1u << other_axis;
    unsigned around = v->around[corner];
    return (around >> opposite & 1) != 0 && (around >> (self ^ 1u << other_axis) & 1) == 0 &&
           w->fans.fan[around][3 * opposite + axis] == w->fans.fan[around][3 * self + axis];
}

// The vertex in the middle of a doubled edge; NOBODY for any other edge.
static uint32_t edge_middle(walk *w, voxel *v, unsigned from, unsigned to, unsigned axis)
{
    unsigned along = (from ^ to) >> 1; // 1, 2, 4 -> 0, 1, 2
    unsigned other = 3 - axis - along, low = from & to;
    if (!edge_is_doubled_at(w, v, from, axis, other) ||
        !edge_is_doubled_at(w, v, to, axis, other)) {
        return NOBODY;
    }
    unsigned first = along == 0 ? 1 : 0, second = along == 2 ? 1 : 2;
    uint32_t *middle = &v->middle[4 * along + (low >> first & 1) + 2 * (low >> second & 1)];
    if (*middle == NOBODY) {
        double at[3];
        for (unsigned a = 0; a < 3; a++) { // the corner, drawn to the voxel's centre
            unsigned far = low >> a & 1;
            at[a] = a == along ? 0.5 : far != 0 ? 1 - SHIFT_VX : SHIFT_VX;
        }
        double height = sf_lattice_layer_height(&w->lattice, v->k);
        double floor_mm =
            w->z_mm - height; // the layer of vertices at work is the voxel's upper one
        *middle = add_vertex(w, v->x + at[0], v->y + at[1], floor_mm + at[2] * height);
    }
    return *middle;
}

static void add_triangle(walk *w, uint32_t a, uint32_t b, uint32_t c)
{
    uint64_t number = w->triangle_count++;
    if (w->triangles != NULL) {
        uint32_t *corner = w->triangles + 3 * number;
        corner[0] = a;
        corner[1] = b;
        corner[2] = c;
    }
}

// A face of four corners and a vertex in the middle of some of its edges, as a fan from the vertex
// at `root`.
static void add_polygon(walk *w, const uint32_t *corners, unsigned count, unsigned root)
{
    for (unsigned i = 1; i + 1 < count; i++) {
        add_triangle(w, corners[root], corners[(root + i) % count],
                     corners[(root + i + 1) % count]);
    }
}

// Diagonals join lattice vertices whose coordinates have an even sum: the same pattern seen from
// every side, so that smoothing has no preferred direction.
static void add_face(walk *w, voxel *v, unsigned face)
{
    const uint8_t *corners = face_corners[face];
    uint32_t polygon[8];
    unsigned count = 0, root = NOBODY, axis = face / 2;
    for (unsigned i = 0; i < 4; i++) {
        unsigned from = corners[i], to = corners[(i + 1) % 4];
        polygon[count++] = corner_vertex(w, v, from, axis);
        uint32_t middle = edge_middle(w, v, from, to, axis);
        if (middle != NOBODY) {
            root = count;
            polygon[count++] = middle;
        }
    }
    if (root == NOBODY) {
        unsigned c = corners[0];
        root = (v->x + v->y + v->k + (c & 1) + (c >> 1 & 1) + (c >> 2)) % 2;
    }
    add_polygon(w, polygon, count, root);
}

static void add_faces_row(walk *w, uint32_t y, uint32_t k)
{
    const uint64_t *row = row_at(w, y, k), *front = row_at(w, (int64_t)y - 1, k);
    const uint64_t *back = row_at(w, (int64_t)y + 1, k), *under = row_at(w, y, (int64_t)k - 1);
    const uint64_t *over = row_at(w, y, (int64_t)k + 1);
    size_t words = sfi_row_words(w->lattice.nx);
    for (size_t i = 0; i < words; i++) {
        uint64_t word = sfi_row_word(row, i, w->lattice.nx);
        uint64_t left = word << 1 | (i > 0 ? row[i - 1] >> 63 : 0);
        uint64_t right = word >> 1 | (i + 1 < words ? row[i + 1] << 63 : 0);
        const uint64_t solid[6] = {left, right, front[i], back[i], under[i], over[i]};
        uint64_t inner = left & right & front[i] & back[i] & under[i] & over[i];
        for (uint64_t border = word & ~inner; border != 0; border &= border - 1) {
            uint32_t bit = sfi_lowest_bit(border);
            voxel v;
            v.x = (uint32_t)(64 * i) + bit;
            v.y = y;
            v.k = k;
            look_up_corners(w, &v);
            for (unsigned face = 0; face < 6; face++) {
                if ((solid[face] >> bit & 1) == 0) {
                    add_face(w, &v, face);
                }
            }
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Walks
// ---------------------------------------------------------------------------------------------

// Walk the grid once. Work is counted in layers: nz for each walk, as much for a smoothing pass.
static sf_status walk_grid(walk *w, sfi_progress *progress, uint64_t before, uint64_t total)
{
    uint32_t nz = w->lattice.nz;
    w->vertex_count = w->triangle_count = 0;
    add_vertex_layer(w, 0);
    for (uint32_t k = 0; k < nz; k++) {
        if (sf_task_is_cancelled(progress->task)) {
            return SF_ERR_CANCELLED;
        }
        vertex_layer swap = w->below;
        w->below = w->above;
        w->above = swap;
        add_vertex_layer(w, k + 1);
        for (uint32_t y = 0; y < w->lattice.ny; y++) {
            add_faces_row(w, y, k);
        }
        sfi_progress_report(progress, before + k + 1, total);
    }
    return SF_OK;
}

// Count, make the mesh, write.
static sf_status walk_twice(walk *w, const sf_allocator *allocator, sfi_progress *progress,
                            uint64_t total, sf_mesh **mesh)
{
    sf_mesh *made = NULL;
    SF_TRY(walk_grid(w, progress, 0, total));
    if (w->vertex_count > UINT32_MAX || w->triangle_count > SIZE_MAX / 3 / sizeof(uint32_t)) {
        return SF_ERR_OVERFLOW;
    }
    SF_TRY(sfi_mesh_make(allocator, (size_t)w->vertex_count, (size_t)w->triangle_count, &made,
                         &w->vertices, &w->triangles));
    sf_status status = walk_grid(w, progress, w->lattice.nz, total);
    if (status != SF_OK) {
        sf_mesh_destroy(made);
        return status;
    }
    *mesh = made;
    return SF_OK;
}

sf_surface_options sf_surface_options_default(void)
{
    sf_surface_options options = {sizeof(sf_surface_options), 0};
    return options;
}

static sf_status make_surface(const sf_grid *grid, int passes, const sf_allocator *allocator,
                              sf_task *task, sf_mesh **mesh)
{
    walk w;
    sf_mesh *made = NULL;
    memset(&w, 0, sizeof w);
    w.grid = grid;
    w.lattice = sf_grid_lattice(grid);
    if (!sfi_size_mul((size_t)w.lattice.nx + 1, (size_t)w.lattice.ny + 1, &w.layer_vertices)) {
        return SF_ERR_OVERFLOW;
    }
    sfi_progress progress = sfi_progress_begin(task);
    uint64_t nz = w.lattice.nz, total = (2 + (uint64_t)passes) * nz;
    sfi_fans_make(&w.fans);
    uint32_t *first = sfi_alloc_array(allocator, w.layer_vertices, 2 * sizeof *first);
    uint8_t *around = sfi_alloc_array(allocator, w.layer_vertices, 2);
    sf_status status = first == NULL || around == NULL ? SF_ERR_MEMORY : SF_OK;
    if (status == SF_OK) {
        vertex_layer below = {first, around};
        vertex_layer above = {first + w.layer_vertices, around + w.layer_vertices};
        w.below = below;
        w.above = above;
        status = walk_twice(&w, allocator, &progress, total, &made);
    }
    sfi_free_array(allocator, first, w.layer_vertices, 2 * sizeof *first);
    sfi_free_array(allocator, around, w.layer_vertices, 2);
    if (status == SF_OK && passes > 0) {
        sfi_smoothing how = {passes, &progress, 2 * nz, nz, total};
        status = sfi_mesh_smooth(w.vertices, (size_t)w.vertex_count, w.triangles,
                                 (size_t)w.triangle_count, &w.lattice, &how, allocator);
    }
    if (status != SF_OK) {
        sf_mesh_destroy(made);
        return status;
    }
    *mesh = made;
    return SF_OK;
}

sf_status sf_grid_surface(const sf_grid *grid, const sf_surface_options *options,
                          const sf_allocator *allocator, sf_task *task, sf_mesh **mesh)
{
    if (grid == NULL || mesh == NULL ||
        (options != NULL &&
         (options->struct_size < sizeof(sf_surface_options) || options->smooth_passes < 0 ||
          options->smooth_passes > SF_SMOOTH_PASSES_MAX))) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator from = sfi_allocator_or_default(allocator);
    return make_surface(grid, options != NULL ? options->smooth_passes : 0, &from, task, mesh);
}

// SPDX-License-Identifier: MIT
// The voxels near a surface, slice by slice.
//
// Where the surface runs within a voxel is not known once it is voxels, so it is taken to be
// anywhere in the closed boxes that it touches. The gap between two boxes that lie (i, j, k) voxels
// apart is (|i| - 1) px along x where i is not 0, and so on; a voxel belongs to the shell where the
// gap to some box of the surface is less than the distance. For each number of layers up or down
// that is an element symmetric in x and y and convex along rows, so a slice of the shell is a union
// of dilations.
//
// Surface just outside the lattice counts too: surfaces are voxelised on a lattice that is wider by
// the reach on every side. Surface slices are kept in a ring as long as the reach up and down, each
// with the number of its layer: going upward, or downward, a slice is voxelised once.
//
// Source: M. Schwarz, H.-P. Seidel, "Fast parallel surface and solid voxelization on GPUs", 2010,
// for what a surface touches.

#include <sf/halftone.h>

#include "base/memory.h"
#include "base/status.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

// A gap that only rounding makes less than the distance is not.
#define ROUNDING 1e-12
#define NO_LAYER UINT32_MAX

struct sf_shell {
    sf_lattice lattice; // the caller's; its heights are those of `wide` from the reach on
    sf_lattice wide;
    double *heights; // of the wide lattice, or NULL
    double distance_mm;
    uint32_t reach[3];
    sf_voxelizer *voxelizer;
    uint32_t ring;   // slices in it
    uint32_t *layer; // which layer of the wide lattice each of them holds
    uint64_t *words; // the ring's, then those of two more
    size_t slice_words, word_count;
    sf_allocator allocator;
};

// Whether gaps of a, b and c along the axes are less than the distance.
static int is_near(const sf_shell *s, double a, double b, double c)
{
    return (a * a + b * b) + c * c < s->distance_mm * s->distance_mm * (1.0 - ROUNDING);
}

static double gap(uint32_t voxels, double pitch)
{
    return voxels > 1 ? (voxels - 1) * pitch : 0.0;
}

// How many voxels away is still near, along one axis; more than SF_REACH_MAX where it is too far.
static uint32_t reach_along(const sf_shell *s, double pitch)
{
    uint32_t reach = 0;
    while (reach <= SF_REACH_MAX && is_near(s, gap(reach + 1, pitch), 0.0, 0.0)) {
        reach++;
    }
    return reach;
}

// What is near at a gap along z, which is near itself.
static sf_element element_at(const sf_shell *s, double gap_z)
{
    sf_element e = {0, {0}};
    for (uint32_t y = 0; y <= s->reach[1]; y++) {
        double gap_y = gap(y, s->lattice.pitch_y_mm);
        if (y > 0 && !is_near(s, 0.0, gap_y, gap_z)) {
            break;
        }
        uint32_t x = 0;
        while (x < s->reach[0] && is_near(s, gap(x + 1, s->lattice.pitch_x_mm), gap_y, gap_z)) {
            x++;
        }
        e.reach_y = (uint16_t)y;
        e.half_width[y] = (uint16_t)x;
    }
    return e;
}

// ---------------------------------------------------------------------------------------------
// Making and freeing
// ---------------------------------------------------------------------------------------------

static double lowest_layer(const sf_lattice *lattice)
{
    double least = sf_lattice_layer_height(lattice, 0);
    for (uint32_t k = 1; lattice->heights_mm != NULL && k < lattice->nz; k++) {
        least = lattice->heights_mm[k] < least ? lattice->heights_mm[k] : least;
    }
    return least;
}

// Heights of the wide lattice: below and above come more of the lowest layer, so that there are
// enough of them.
static sf_status widen_heights(sf_shell *s, double lowest)
{
    const double *from = s->lattice.heights_mm;
    uint32_t r = s->reach[2];
    if (from == NULL) {
        return SF_OK;
    }
    s->heights = sfi_alloc_array(&s->allocator, s->wide.nz, sizeof *s->heights);
    if (s->heights == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t k = 0; k < s->wide.nz; k++) {
        s->heights[k] = k < r || k >= r + s->lattice.nz ? lowest : from[k - r];
    }
    s->wide.heights_mm = s->heights;
    s->lattice.heights_mm = s->heights + r;
    return SF_OK;
}

static sf_status widen_lattice(sf_shell *s)
{
    double lowest = lowest_layer(&s->lattice);
    s->reach[0] = reach_along(s, s->lattice.pitch_x_mm);
    s->reach[1] = reach_along(s, s->lattice.pitch_y_mm);
    s->reach[2] = reach_along(s, lowest);
    s->wide = s->lattice;
    for (int n = 0; n < 3; n++) {
        if (s->reach[n] > SF_REACH_MAX) {
            return SF_ERR_OVERFLOW;
        }
    }
    s->wide.nx += 2 * s->reach[0];
    s->wide.ny += 2 * s->reach[1];
    s->wide.nz += 2 * s->reach[2];
    s->wide.origin_mm[0] -= s->reach[0] * s->lattice.pitch_x_mm;
    s->wide.origin_mm[1] -= s->reach[1] * s->lattice.pitch_y_mm;
    s->wide.origin_mm[2] -= s->reach[2] * lowest;
    SF_TRY(widen_heights(s, lowest));
    return sf_lattice_validate(&s->wide);
}

static sf_status allocate_slices(sf_shell *s)
{
    s->ring = 2 * s->reach[2] + 1;
    if (!sfi_size_mul(sf_slice_stride(s->wide.nx), s->wide.ny, &s->slice_words) ||
        !sfi_size_mul(s->slice_words, (size_t)s->ring + 2, &s->word_count)) {
        return SF_ERR_OVERFLOW;
    }
    s->layer = sfi_alloc_array(&s->allocator, s->ring, sizeof *s->layer);
    s->words = sfi_alloc_array(&s->allocator, s->word_count, sizeof *s->words);
    if (s->layer == NULL || s->words == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(s->layer, 0xff, s->ring * sizeof *s->layer);
    return SF_OK;
}

static sf_status prepare(sf_shell *s, sf_mesh_view mesh, sf_fault *fault)
{
    sf_status status = widen_lattice(s);
    if (status == SF_OK) {
        status = allocate_slices(s);
    }
    if (status != SF_OK) {
        return sfi_fault_set(fault, status, 0, 0, "%s",
                             status == SF_ERR_MEMORY
                                 ? "There is too little memory for the shell."
                                 : "The shell reaches over more than 255 voxels, or over the "
                                   "largest lattice.");
    }
    sf_voxelize_options options = sf_voxelize_options_default();
    options.fill = SF_FILL_SURFACE;
    return sf_voxelizer_create(mesh, &s->wide, &options, &s->allocator, &s->voxelizer, fault);
}

sf_status sf_shell_create(sf_mesh_view mesh, const sf_lattice *lattice, double distance_mm,
                          const sf_allocator *allocator, sf_shell **shell, sf_fault *fault)
{
    sf_allocator a = sfi_allocator_or_default(allocator);
    sf_status status = sf_lattice_validate(lattice);
    if (status == SF_OK && (shell == NULL || !(distance_mm >= 0.0 && distance_mm <= 1e12))) {
        status = SF_ERR_ARGUMENT;
    }
    if (status != SF_OK) {
        return sfi_fault_set(fault, status, 0, 0,
                             "The lattice needs counts within limits and positive pitches, the "
                             "distance must be 0 or more.");
    }
    sf_shell *s = sfi_alloc_array(&a, 1, sizeof *s);
    if (s == NULL) {
        return sfi_fault_set(fault, SF_ERR_MEMORY, 0, 0,
                             "There is too little memory for the shell.");
    }
    memset(s, 0, sizeof *s);
    s->lattice = *lattice;
    s->distance_mm = distance_mm;
    s->allocator = a;
    status = prepare(s, mesh, fault);
    if (status != SF_OK) {
        sf_shell_destroy(s);
        return status;
    }
    *shell = s;
    return SF_OK;
}

void sf_shell_destroy(sf_shell *shell)
{
    if (shell != NULL) {
        sf_allocator a = shell->allocator;
        sf_voxelizer_destroy(shell->voxelizer);
        sfi_free_array(&a, shell->heights, shell->wide.nz, sizeof *shell->heights);
        sfi_free_array(&a, shell->layer, shell->ring, sizeof *shell->layer);
        sfi_free_array(&a, shell->words, shell->word_count, sizeof *shell->words);
        sfi_free_array(&a, shell, 1, sizeof *shell);
    }
}

// ---------------------------------------------------------------------------------------------
// Slices
// ---------------------------------------------------------------------------------------------

// Slice i of the shell's own memory.
static sf_slice own_slice(const sf_shell *s, size_t i)
{
    sf_slice slice = {s->words + i * s->slice_words, s->wide.nx, s->wide.ny,
                      sf_slice_stride(s->wide.nx)};
    return slice;
}

// The surface in a layer of the wide lattice.
static sf_status surface_at(sf_shell *s, uint32_t layer, sf_slice *slice)
{
    uint32_t place = layer % s->ring;
    *slice = own_slice(s, place);
    if (s->layer[place] != layer) {
        s->layer[place] = NO_LAYER;
        SF_TRY(sf_voxelizer_slice(s->voxelizer, layer, *slice));
        s->layer[place] = layer;
    }
    return SF_OK;
}

// Add what is near the surface in a layer, across a gap.
static sf_status add_layer(sf_shell *s, uint32_t layer, double gap_z, sf_slice sum)
{
    sf_slice surface, grown = own_slice(s, (size_t)s->ring + 1);
    SF_TRY(surface_at(s, layer, &surface));
    if (!sfi_slice_any(surface)) {
        return SF_OK;
    }
    sf_element element = element_at(s, gap_z);
    SF_TRY(sf_slice_dilate(grown, surface, &element, SF_BORDER_EMPTY));
    return sf_slice_or(sum, sum, grown);
}

static sf_status gather(sf_shell *s, uint32_t middle, sf_slice sum)
{
    double up = 0.0, down = 0.0;
    sfi_slice_clear(sum);
    SF_TRY(add_layer(s, middle, 0.0, sum));
    for (uint32_t i = 1; i <= s->reach[2] && is_near(s, 0.0, 0.0, up); i++) {
        SF_TRY(add_layer(s, middle + i, up, sum));
        up += sf_lattice_layer_height(&s->wide, middle + i);
    }
    for (uint32_t i = 1; i <= s->reach[2] && is_near(s, 0.0, 0.0, down); i++) {
        SF_TRY(add_layer(s, middle - i, down, sum));
        down += sf_lattice_layer_height(&s->wide, middle - i);
    }
    return SF_OK;
}

sf_status sf_shell_slice(sf_shell *shell, uint32_t k, sf_slice slice)
{
    if (shell == NULL || k >= shell->lattice.nz) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_slice_validate(slice));
    if (slice.width != shell->lattice.nx || slice.height != shell->lattice.ny) {
        return SF_ERR_SHAPE;
    }
    sf_slice sum = own_slice(shell, shell->ring);
    SF_TRY(gather(shell, k + shell->reach[2], sum));
    size_t words = sfi_row_words(slice.width), from = sfi_row_words(sum.width);
    for (uint32_t y = 0; y < slice.height; y++) {
        const uint64_t *row = sfi_slice_row(sum, y + shell->reach[1]);
        uint64_t *to = sfi_slice_row(slice, y);
        for (size_t i = 0; i < words; i++) {
            to[i] = sfi_moved_word(row, from, i, (int64_t)shell->reach[0]);
        }
        to[words - 1] &= sfi_tail_mask(slice.width);
    }
    return SF_OK;
}

// SPDX-License-Identifier: MIT
// What voxels of tetrahedra are: interpolated in those that a slice meets.
//
// Tetrahedra are put into bins by the lowest layer whose middle they reach, and by how many they
// reach through: 1, up to 2, up to 4 and so on. A slice looks at the bins of its own layer and, of
// each height, of as many below as those reach through, so that few tall ones do not make it look
// at all small ones. Within a slice the shares of a tetrahedron's corners are linear along a row,
// so that the voxels it holds are an interval. Who comes first by number keeps a voxel. Solid
// voxels that none holds, by rounding, get what the next in their row has, or, where there is none,
// what the nearest tetrahedron has.

#include "base/memory.h"
#include "base/status.h"
#include "grade/sample/sampler.h"
#include "grade/sample/shares.h"
#include "grade/tetra/faces.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

static const double SLACK = 1e-9; // a share that much below 0 is taken for 0

typedef struct rows {
    sf_allocator allocator;
    sf_tets_view tets;
    sfi_faces faces;
    size_t channels[SF_PROPERTY_MAX];
    uint32_t layers, heights; // of the lattice; and how many classes of heights there are
    uint32_t *starts;         // of each height, of each layer where its tetrahedra begin
    uint32_t *bins;
    sf_slice open; // solid voxels that nobody has told of yet
    size_t open_words;
    uint32_t *owners; // of each voxel that was told of, by which tetrahedron
    double *nearest;  // how far from a voxel that is in none the nearest one is, squared
} rows;

static void destroy_rows(void *state)
{
    rows *r = state;
    sf_allocator allocator = r->allocator;
    sfi_faces_free(&r->faces);
    sfi_free_array(&allocator, r->starts, (size_t)r->heights * r->layers + 1, sizeof *r->starts);
    sfi_free_array(&allocator, r->bins, r->tets.tet_count, sizeof *r->bins);
    sfi_free_array(&allocator, r->open.words, r->open_words, sizeof *r->open.words);
    sfi_free_array(&allocator, r->owners, (size_t)r->open.width * r->open.height,
                   sizeof *r->owners);
    sfi_free_array(&allocator, r->nearest, (size_t)r->open.width * r->open.height,
                   sizeof *r->nearest);
    sfi_free_array(&allocator, r, 1, sizeof *r);
}

// ---------------------------------------------------------------------------------------------
// Slices
// ---------------------------------------------------------------------------------------------

// What a slice is to be told.
typedef struct telling {
    sf_sampler *s;
    rows *rows;
    double z;
    sf_slice solid;
    double *const *values;
} telling;

static void tell_voxel(const telling *t, size_t tet, const double share[4], size_t at)
{
    for (size_t i = 0; i < t->s->channel_count; i++) {
        const sf_channel *c = &t->rows->tets.channels[t->rows->channels[i]];
        const uint32_t *which = (c->indices != NULL ? c->indices : t->rows->tets.corners) + 4 * tet;
        double base = c->values[which[0]], sum = 0;
        for (uint32_t j = 1; j < 4; j++) {
            sum += share[j] * (c->values[which[j]] - base);
        }
        t->values[i][at] = base + sum;
    }
}

static int is_set(const uint64_t *words, uint32_t x)
{
    return (int)(words[x / 64] >> x % 64 & 1);
}

// Voxels of a row from the first whose middle is not before `low` to the last not behind `high`.
static int find_interval(const sf_lattice *l, double low, double high, uint32_t *from, uint32_t *to)
{
    double first = -floor(-((low - l->origin_mm[0]) / l->pitch_x_mm - 0.5 - 1e-6));
    double last = floor((high - l->origin_mm[0]) / l->pitch_x_mm - 0.5 + 1e-6);
    if (!(first < l->nx) || !(last >= 0) || !(first <= last)) {
        return 0;
    }
    *from = first > 0 ? (uint32_t)first : 0;
    *to = last < l->nx - 1 ? (uint32_t)last : l->nx - 1;
    return 1;
}

// Whether a voxel is still to be told of, or was by a tetrahedron that comes later by number.
static int is_wanted(const telling *t, const uint64_t *open, const uint64_t *solid, uint32_t x,
                     size_t at, size_t tet)
{
    return is_set(open, x) || (is_set(solid, x) && t->rows->owners[at] > tet);
}

static void tell_row(const telling *t, size_t tet, const sfi_shares *s, uint32_t y, double low,
                     double high)
{
    const sf_lattice *l = &t->s->lattice;
    uint64_t *open = sfi_slice_row(t->rows->open, y);
    const uint64_t *solid = sfi_slice_row(t->solid, y);
    double dy = sfi_middle(l, 1, y) - s->origin[1], dz = t->z - s->origin[2];
    uint32_t from, to;
    if (!find_interval(l, low, high, &from, &to)) {
        return;
    }
    for (uint32_t x = from; x <= to; x++) {
        double dx = sfi_middle(l, 0, x) - s->origin[0], share[4];
        size_t at = (size_t)l->nx * y + x;
        int within = is_wanted(t, open, solid, x, at, tet);
        for (uint32_t i = 0; within && i < 4; i++) {
            share[i] =
                s->at[i] + s->slopes[i][0] * dx + s->slopes[i][1] * dy + s->slopes[i][2] * dz;
            within = share[i] >= -SLACK;
        }
        if (within) {
            open[x / 64] &= ~((uint64_t)1 << x % 64);
            t->rows->owners[at] = (uint32_t)tet;
            tell_voxel(t, tet, share, at);
        }
    }
}

// Where a row meets a tetrahedron: between the largest and the least of where its shares vanish.
static void row_interval(const sfi_shares *s, double dy, double dz, double *low, double *high)
{
    for (uint32_t i = 0; i < 4; i++) {
        double rest = s->at[i] + s->slopes[i][1] * dy + s->slopes[i][2] * dz + SLACK;
        double slope = s->slopes[i][0];
        if (slope > 0) {
            double x = s->origin[0] - rest / slope;
            *low = x > *low ? x : *low;
        } else if (slope < 0) {
            double x = s->origin[0] - rest / slope;
            *high = x < *high ? x : *high;
        } else if (rest < 0) {
            *high = -INFINITY;
        }
    }
}

static void tell_tet(const telling *t, size_t tet)
{
    const sf_tets_view *v = &t->rows->tets;
    const sf_lattice *l = &t->s->lattice;
    double low[3], high[3];
    sfi_shares s;
    sfi_tet_box(v, tet, low, high);
    if (high[2] < t->z || low[2] > t->z || !sfi_shares_find(v, tet, &s)) {
        return;
    }
    double first = -floor(-((low[1] - l->origin_mm[1]) / l->pitch_y_mm - 0.5 - 1e-6));
    double last = floor((high[1] - l->origin_mm[1]) / l->pitch_y_mm - 0.5 + 1e-6);
    for (double y = first > 0 ? first : 0; y <= last && y < l->ny; y++) {
        double from = low[0], to = high[0];
        row_interval(&s, sfi_middle(l, 1, (uint32_t)y) - s.origin[1], t->z - s.origin[2], &from,
                     &to);
        if (from <= to + l->pitch_x_mm) {
            tell_row(t, tet, &s, (uint32_t)y, from, to);
        }
    }
}

// Open voxels of a row between two that were told of, or an end of the row: each gets what the
// nearer of the two has.
static void fill_gap(const telling *t, const uint64_t *open, size_t offset, uint32_t left,
                     uint32_t right)
{
    uint32_t nx = t->s->lattice.nx;
    for (uint32_t x = left == nx ? 0 : left + 1; x < right && (left < nx || right < nx); x++) {
        int from_left = right == nx || (left < nx && x - left <= right - x);
        if (is_set(open, x)) {
            sfi_copy_values(t->s, t->values, offset + (from_left ? left : right), offset + x);
        }
    }
}

// Fill gaps in rows. Returns whether there are rows with solid voxels none of which was told of;
// only those are open afterwards.
static int fill_open(const telling *t)
{
    uint32_t nx = t->s->lattice.nx;
    int rest = 0;
    for (uint32_t y = 0; y < t->s->lattice.ny; y++) {
        uint64_t *open = sfi_slice_row(t->rows->open, y);
        const uint64_t *row = sfi_slice_row(t->solid, y);
        uint32_t left = nx, count = 0; // the last voxel that was told of; open ones since
        for (uint32_t x = 0; x <= nx; x++) {
            if (x < nx && is_set(open, x)) {
                count++;
            } else if (x == nx || is_set(row, x)) {
                if (count > 0) {
                    fill_gap(t, open, (size_t)nx * y, left, x);
                    t->s->report.filled += count;
                }
                rest |= x == nx && left == nx && count > 0;
                left = x == nx ? left : x;
                count = 0;
            }
        }
        if (left < nx) {
            memset(open, 0, t->rows->open.stride * sizeof *open);
        }
    }
    return rest;
}

// How far a place is from where the shares, those below 0 taken for 0, lie; squared.
static double move_within(const sf_tets_view *v, size_t tet, const double place[3], double share[4])
{
    double sum = 0, distance = 0;
    for (uint32_t i = 0; i < 4; i++) {
        share[i] = share[i] > 0 ? share[i] : 0;
        sum += share[i];
    }
    for (uint32_t axis = 0; axis < 3; axis++) {
        double away = 0;
        for (uint32_t i = 0; i < 4; i++) {
            const double *p = v->positions + 3 * (size_t)v->corners[4 * tet + i];
            away += share[i] / sum * (p[axis] - place[axis]);
        }
        distance += away * away;
    }
    for (uint32_t i = 0; i < 4; i++) {
        share[i] /= sum;
    }
    return distance;
}

static void tell_near_voxel(const telling *t, size_t tet, const sfi_shares *s, uint32_t x,
                            uint32_t y)
{
    const sf_lattice *l = &t->s->lattice;
    double place[3] = {sfi_middle(l, 0, x), sfi_middle(l, 1, y), t->z}, share[4];
    size_t at = (size_t)l->nx * y + x;
    for (uint32_t i = 0; i < 4; i++) {
        share[i] = s->at[i];
        for (uint32_t axis = 0; axis < 3; axis++) {
            share[i] += s->slopes[i][axis] * (place[axis] - s->origin[axis]);
        }
    }
    double distance = move_within(&t->rows->tets, tet, place, share);
    if (distance < t->rows->nearest[at] ||
        (distance <= t->rows->nearest[at] && tet < t->rows->owners[at])) {
        t->rows->nearest[at] = distance;
        t->rows->owners[at] = (uint32_t)tet;
        tell_voxel(t, tet, share, at);
    }
}

// Tell open voxels that are at most one voxel away from a tetrahedron's box, if it is the nearest.
static void tell_near(const telling *t, size_t tet, double height)
{
    const sf_lattice *l = &t->s->lattice;
    double low[3], high[3];
    sfi_shares s;
    sfi_tet_box(&t->rows->tets, tet, low, high);
    if (high[2] < t->z - height || low[2] > t->z + height ||
        !sfi_shares_find(&t->rows->tets, tet, &s)) {
        return;
    }
    double first = floor((low[1] - l->origin_mm[1]) / l->pitch_y_mm - 1);
    double last = floor((high[1] - l->origin_mm[1]) / l->pitch_y_mm + 1);
    for (double y = first > 0 ? first : 0; y <= last && y < l->ny; y++) {
        const uint64_t *open = sfi_slice_row(t->rows->open, (uint32_t)y);
        uint32_t from, to;
        if (find_interval(l, low[0] - l->pitch_x_mm, high[0] + l->pitch_x_mm, &from, &to)) {
            for (uint32_t x = from; x <= to; x++) {
                if (is_set(open, x)) {
                    tell_near_voxel(t, tet, &s, x, (uint32_t)y);
                }
            }
        }
    }
}

typedef void visit(const telling *t, size_t tet, double height);

static void tell_within(const telling *t, size_t tet, double height)
{
    (void)height;
    tell_tet(t, tet);
}

// All tetrahedra that may reach layer k's middle, or lie between it and that of layer `last`.
static void visit_bins(const telling *t, uint32_t k, uint32_t last, visit *visit_one)
{
    const rows *r = t->rows;
    double height = t->s->bottoms[k + 1] - t->s->bottoms[k];
    for (uint32_t class = 0; class < r->heights; class ++) {
        uint32_t reach = (uint32_t)(((uint64_t)1 << class) - 1), first = k > reach ? k - reach : 0;
        const uint32_t *starts = r->starts + (size_t) class * r->layers;
        for (uint32_t i = starts[first]; i < starts[last + 1]; i++) {
            visit_one(t, r->bins[i], height);
        }
    }
}

static sf_status tell(void *state, sf_sampler *s, uint32_t k, double z, sf_slice solid,
                      double *const *values)
{
    rows *r = state;
    telling t = {s, r, z, solid, values};
    for (uint32_t y = 0; y < s->lattice.ny; y++) {
        memcpy(sfi_slice_row(r->open, y), sfi_slice_row(solid, y),
               r->open.stride * sizeof(uint64_t));
    }
    visit_bins(&t, k, k, tell_within);
    if (fill_open(&t)) {
        for (size_t i = 0; i < (size_t)s->lattice.nx * s->lattice.ny; i++) {
            r->nearest[i] = INFINITY;
        }
        visit_bins(&t, k, k + 1 < r->layers ? k + 1 : k, tell_near);
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Making
// ---------------------------------------------------------------------------------------------

// The lowest layer whose middle is not below z; nz if there is none.
static uint32_t layer_from(const sf_sampler *s, double z)
{
    uint32_t low = 0, high = s->lattice.nz;
    while (low < high) {
        uint32_t k = low + (high - low) / 2;
        if ((s->bottoms[k] + s->bottoms[k + 1]) / 2 < z) {
            low = k + 1;
        } else {
            high = k;
        }
    }
    return low;
}

// The layers whose middles a tetrahedron reaches: from *first up to, not including, what is
// returned.
static uint32_t layers_of(const sf_sampler *s, const sf_tets_view *v, size_t tet, uint32_t *first)
{
    double low = INFINITY, high = -INFINITY;
    for (uint32_t i = 0; i < 4; i++) {
        double z = v->positions[3 * (size_t)v->corners[4 * tet + i] + 2];
        low = z < low ? z : low;
        high = z > high ? z : high;
    }
    *first = layer_from(s, low);
    uint32_t end = layer_from(s, high);
    int touches = end < s->lattice.nz && (s->bottoms[end] + s->bottoms[end + 1]) / 2 <= high;
    return end + (touches ? 1 : 0);
}

// The class of a tetrahedron that reaches the middles of `count` layers, 1 or more: 0 for 1, 1 for
// 2, 2 for up to 4 and so on, so that those of class h lie within 2^h layers.
static uint32_t height_of(uint32_t count)
{
    uint32_t height = 0;
    while (height < 32 && ((uint64_t)1 << height) < count) {
        height++;
    }
    return height;
}

// The bin of a tetrahedron. One that reaches no layer's middle is in that of the next above it, for
// what it may be the nearest of.
static size_t bin_of(const sf_sampler *s, const rows *r, size_t tet)
{
    uint32_t first, end = layers_of(s, &r->tets, tet, &first);
    uint32_t height = height_of(first < end ? end - first : 1);
    return (size_t)height * r->layers + (first < r->layers ? first : r->layers - 1);
}

// How many classes of heights there are.
static uint32_t count_heights(const sf_sampler *s, const rows *r)
{
    size_t most = 0;
    for (size_t i = 0; i < r->tets.tet_count; i++) {
        size_t bin = bin_of(s, r, i);
        most = bin > most ? bin : most;
    }
    return (uint32_t)(most / r->layers) + 1;
}

static void fill_bins(const sf_sampler *s, rows *r)
{
    size_t bins = (size_t)r->heights * r->layers;
    memset(r->starts, 0, (bins + 1) * sizeof *r->starts);
    for (size_t i = 0; i < r->tets.tet_count; i++) {
        r->starts[bin_of(s, r, i)]++;
    }
    uint32_t sum = 0;
    for (size_t k = 0; k <= bins; k++) {
        uint32_t here = r->starts[k];
        r->starts[k] = sum;
        sum += here;
    }
    for (size_t i = 0; i < r->tets.tet_count; i++) {
        r->bins[r->starts[bin_of(s, r, i)]++] = (uint32_t)i;
    }
    memmove(r->starts + 1, r->starts, bins * sizeof *r->starts);
    r->starts[0] = 0;
}

static sf_status fill(const sf_lattice *lattice, sf_sampler *s, rows *r, sf_fault *fault)
{
    const sf_allocator *allocator = &r->allocator;
    size_t stride = sfi_row_words(lattice->nx);
    r->layers = lattice->nz;
    r->heights = count_heights(s, r);
    r->open_words = stride * lattice->ny;
    r->starts = sfi_alloc_array(allocator, (size_t)r->heights * r->layers + 1, sizeof *r->starts);
    r->bins = sfi_alloc_array(allocator, r->tets.tet_count, sizeof *r->bins);
    r->open.words = sfi_alloc_array(allocator, r->open_words, sizeof *r->open.words);
    r->open.width = lattice->nx;
    r->open.height = lattice->ny;
    r->open.stride = stride;
    r->owners = sfi_alloc_array(allocator, (size_t)lattice->nx * lattice->ny, sizeof *r->owners);
    r->nearest = sfi_alloc_array(allocator, (size_t)lattice->nx * lattice->ny, sizeof *r->nearest);
    if (r->starts == NULL || r->bins == NULL || r->open.words == NULL || r->owners == NULL ||
        r->nearest == NULL) {
        return SF_ERR_MEMORY;
    }
    fill_bins(s, r);
    SF_TRY(sfi_faces_make(r->tets.corners, r->tets.tet_count, r->tets.point_count, allocator,
                          &r->faces));
    sf_mesh_view surface = {r->tets.positions, r->tets.point_count, r->faces.corners,
                            r->faces.count};
    return sfi_sampler_surface(s, lattice, surface, 0, fault);
}

sf_status sf_sampler_of_tets(const sf_tets *tets, const sf_lattice *lattice, size_t channel_count,
                             const size_t *channels, const sf_allocator *allocator,
                             sf_sampler **sampler, sf_fault *fault)
{
    sf_tets_view view = sf_tets_get_view(tets);
    if (tets == NULL || sampler == NULL || (channel_count > 0 && channels == NULL) ||
        channel_count > SF_PROPERTY_MAX) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < channel_count; i++) {
        if (channels[i] >= view.channel_count) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "there is no property %zu",
                                 channels[i]);
        }
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sf_sampler *made = NULL;
    SF_TRY(sfi_sampler_begin(lattice, channel_count, &kept, &made, fault));
    rows *r = sfi_alloc_array(&kept, 1, sizeof *r);
    if (r == NULL) {
        sf_sampler_destroy(made);
        return SF_ERR_MEMORY;
    }
    memset(r, 0, sizeof *r);
    r->allocator = kept;
    r->tets = view;
    if (channel_count > 0) {
        memcpy(r->channels, channels, channel_count * sizeof *channels);
    }
    sfi_teller teller = {r, tell, destroy_rows};
    made->teller = teller;
    sf_status status = fill(lattice, made, r, fault);
    if (status != SF_OK) {
        sf_sampler_destroy(made);
        return status;
    }
    *sampler = made;
    return SF_OK;
}

// SPDX-License-Identifier: MIT
// What rays measure: thickness behind triangles, and voxels.
//
// Thickness takes rays in a cone about the inward normal: the axis first, then a spiral whose turns
// are the golden angle apart, which spreads any number evenly. Triangles are independent, so pieces
// of 256 go to the host's threads, and the result is the same for any number of them.
//
// Voxels take one ray a column, and of it all hits, sorted: the winding number above a hit is that
// below it plus or minus one. A ray through the centres themselves would run along edges of every
// part that is drawn on a grid of round numbers; so it lies a thousandth of a voxel aside, to the
// side on which the library takes a centre on the surface to lie.

#include "link/embree.h"

extern "C" {
#include "base/status.h"
}

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>

namespace embree {

// ---------------------------------------------------------------------------------------------
// Thickness
// ---------------------------------------------------------------------------------------------

struct spoke {
    double across[2], along, weight; // in the frame of a normal
};

struct measuring {
    const sf_embree *e;
    std::vector<spoke> spokes;
    double *thickness;
    std::atomic<int> is_short_of_memory;
    sf_task *task;
};

static const size_t PIECE = 256;

static std::vector<spoke> make_spokes(const sf_embree_thickness_options &how)
{
    std::vector<spoke> spokes;
    const double golden = 2.399963229728653; // pi (3 - sqrt 5)
    for (uint32_t i = 0; i < how.rays; i++) {
        // Evenly by area on the cap: its height is 1 - cos, and grows evenly.
        double part = how.rays > 1 ? double(i) / (how.rays - 1) : 0;
        double high = 1 - part * (1 - std::cos(how.cone_rad));
        double wide = std::sqrt(std::max(0.0, 1 - high * high));
        double angle = std::acos(std::min(1.0, high));
        // Shapira's weights are the inverse of the angle; the axis counts as its neighbours do.
        double weight = 1 / std::max(angle, how.cone_rad / std::sqrt(double(how.rays)));
        spokes.push_back(
            {{wide * std::cos(golden * i), wide * std::sin(golden * i)}, high, weight});
    }
    return spokes;
}

// The weighted mean of the lengths within a standard deviation of their median.
static double typical(std::vector<std::pair<double, double>> *lengths)
{
    if (lengths->empty()) {
        return std::numeric_limits<double>::infinity();
    }
    std::sort(lengths->begin(), lengths->end());
    double median = (*lengths)[lengths->size() / 2].first, mean = 0, square = 0, sum = 0,
           weight = 0;
    for (const auto &l : *lengths) {
        mean += l.first / double(lengths->size());
    }
    for (const auto &l : *lengths) {
        square += (l.first - mean) * (l.first - mean) / double(lengths->size());
    }
    double within = std::sqrt(square) + 1e-9 * median;
    for (const auto &l : *lengths) {
        if (std::fabs(l.first - median) <= within) {
            sum += l.first * l.second;
            weight += l.second;
        }
    }
    return weight > 0 ? sum / weight : median;
}

// The corners of a triangle as Embree has them.
static const float *corner_of(const sf_embree *e, size_t triangle, int corner)
{
    RTCGeometry shape = rtcGetGeometry(e->scene, 0);
    const float *vertices =
        static_cast<const float *>(rtcGetGeometryBufferData(shape, RTC_BUFFER_TYPE_VERTEX, 0));
    const uint32_t *corners =
        static_cast<const uint32_t *>(rtcGetGeometryBufferData(shape, RTC_BUFFER_TYPE_INDEX, 0));
    return vertices + 3 * size_t(corners[3 * triangle + size_t(corner)]);
}

// The middle of a triangle, its inward normal and two directions across; 0 if it has no area.
static int frame_of(const sf_embree *e, size_t triangle, double middle[3], double frame[3][3])
{
    double u[3], v[3], *n = frame[2], length = 0;
    const float *a = corner_of(e, triangle, 0), *b = corner_of(e, triangle, 1);
    const float *c = corner_of(e, triangle, 2);
    for (int i = 0; i < 3; i++) {
        u[i] = double(b[i]) - double(a[i]);
        v[i] = double(c[i]) - double(a[i]);
        middle[i] = (double(a[i]) + double(b[i]) + double(c[i])) / 3 + e->middle[i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = (u[k] * v[j] - u[j] * v[k]) * (e->turned ? -1 : 1);
        length += n[i] * n[i];
    }
    if (!(length > 0)) {
        return 0;
    }
    int least = 0;
    for (int i = 0; i < 3; i++) {
        n[i] /= std::sqrt(length);
        least = std::fabs(n[i]) < std::fabs(n[least]) ? i : least;
    }
    double axis[3] = {0, 0, 0}, across = 0;
    axis[least] = 1;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        frame[0][i] = axis[j] * n[k] - axis[k] * n[j];
        across += frame[0][i] * frame[0][i];
    }
    for (int i = 0; i < 3; i++) {
        frame[0][i] /= std::sqrt(across);
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        frame[1][i] = n[j] * frame[0][k] - n[k] * frame[0][j];
    }
    return 1;
}

static double thickness_of(const measuring *m, size_t triangle,
                           std::vector<std::pair<double, double>> *lengths)
{
    double middle[3], frame[3][3];
    lengths->clear();
    if (!frame_of(m->e, triangle, middle, frame)) {
        return std::numeric_limits<double>::infinity();
    }
    double start = 1e-5 * m->e->reach; // off the triangle itself
    for (const spoke &s : m->spokes) {
        double direction[3];
        hit h;
        for (int i = 0; i < 3; i++) {
            direction[i] =
                s.across[0] * frame[0][i] + s.across[1] * frame[1][i] + s.along * frame[2][i];
        }
        // A ray that meets the outside of something first did not begin within a solid.
        if (cast(m->e, ray_at(m->e, middle, direction, start), &h) && h.leaves != m->e->turned &&
            h.triangle != triangle) {
            lengths->push_back({double(h.along), s.weight});
        }
    }
    return typical(lengths);
}

static void measure_piece(void *context, size_t piece)
{
    measuring *m = static_cast<measuring *>(context);
    try {
        std::vector<std::pair<double, double>> lengths;
        size_t end = std::min((piece + 1) * PIECE, m->e->triangle_count);
        for (size_t i = piece * PIECE; i < end && !sf_task_is_cancelled(m->task); i++) {
            m->thickness[i] = thickness_of(m, i, &lengths);
        }
    } catch (...) {
        m->is_short_of_memory = 1;
    }
}

static void report(sf_task *task, double fraction)
{
    if (task != nullptr && task->progress != nullptr) {
        task->progress(task->user, fraction);
    }
}

// In ten stretches, so that the host hears of it.
static void measure_all(measuring *m)
{
    size_t pieces = (m->e->triangle_count + PIECE - 1) / PIECE;
    for (size_t i = 0; i < 10 && !sf_task_is_cancelled(m->task); i++) {
        size_t first = pieces * i / 10, count = pieces * (i + 1) / 10 - first;
        struct stretch {
            measuring *m;
            size_t first;
        } s = {m, first};
        auto body = [](void *context, size_t index) {
            stretch *at = static_cast<stretch *>(context);
            measure_piece(at->m, at->first + index);
        };
        if (m->task != nullptr && m->task->parallel_for != nullptr && count > 1) {
            m->task->parallel_for(m->task->user, count, body, &s);
        } else {
            for (size_t k = 0; k < count; k++) {
                body(&s, k);
            }
        }
        report(m->task, double(i + 1) / 10);
    }
}

// ---------------------------------------------------------------------------------------------
// Voxels
// ---------------------------------------------------------------------------------------------

// Set the voxels of column (x, y) that the surface winds around.
static void fill_column(const sf_embree *e, sf_grid *grid, const sf_lattice &l, uint32_t x,
                        uint32_t y, const std::vector<double> &centres, std::vector<hit> *hits)
{
    const double aside = 1e-3;
    double bottom = e->middle[2] - 1.01 * e->reach;
    double from[3] = {l.origin_mm[0] + (x + 0.5 + aside) * l.pitch_x_mm,
                      l.origin_mm[1] + (y + 0.5 + aside) * l.pitch_y_mm, bottom};
    double up[3] = {0, 0, 1};
    cast_through(e, ray_at(e, from, up, 0), hits);
    int winding = 0;
    size_t next = 0;
    for (uint32_t k = 0; k < l.nz && (next < hits->size() || winding != 0); k++) {
        double above = centres[k] + aside * sf_lattice_layer_height(&l, k) - bottom;
        for (; next < hits->size() && double((*hits)[next].along) <= above; next++) {
            winding += (*hits)[next].leaves != e->turned ? -1 : 1;
        }
        if (winding >= 1) {
            sf_slice s = sf_grid_slice(grid, k);
            s.words[y * s.stride + x / 64] |= uint64_t(1) << x % 64;
        }
    }
}

static sf_status fill_grid(const sf_embree *e, sf_grid *grid, sf_task *task)
{
    sf_lattice l = sf_grid_lattice(grid);
    std::vector<double> centres;
    std::vector<hit> hits;
    hits.reserve(1024);
    double bottom = sf_lattice_layer_bottom(&l, 0);
    for (uint32_t k = 0; k < l.nz; k++) {
        double height = sf_lattice_layer_height(&l, k);
        centres.push_back(bottom + height / 2);
        bottom = l.heights_mm != nullptr ? bottom + height : sf_lattice_layer_bottom(&l, k + 1);
    }
    sf_rect all = {0, 0, l.nx, l.ny};
    for (uint32_t k = 0; k < l.nz; k++) {
        SF_TRY(sf_slice_fill(sf_grid_slice(grid, k), all, 0));
    }
    for (uint32_t y = 0; y < l.ny; y++) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < l.nx; x++) {
            fill_column(e, grid, l, x, y, centres, &hits);
        }
        report(task, double(y + 1) / l.ny);
    }
    return SF_OK;
}

} // namespace embree

sf_embree_thickness_options sf_embree_thickness_options_default(void)
{
    sf_embree_thickness_options options = {sizeof options, 31, 1.0471975511965976};
    return options;
}

sf_status sf_embree_thickness(const sf_embree *embree, const sf_embree_thickness_options *options,
                              sf_task *task, double *thickness)
{
    sf_embree_thickness_options how = sf_embree_thickness_options_default();
    if (options != nullptr) {
        std::memcpy(&how, options, std::min(options->struct_size, sizeof how));
    }
    if (embree == nullptr || thickness == nullptr || how.rays < 1 || how.rays > 1024 ||
        !(how.cone_rad > 0 && how.cone_rad <= 1.4)) {
        return SF_ERR_ARGUMENT;
    }
    try {
        embree::measuring m = {embree, embree::make_spokes(how), thickness, {0}, task};
        embree::measure_all(&m);
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        return m.is_short_of_memory ? SF_ERR_MEMORY : SF_OK;
    } catch (...) {
        return SF_ERR_MEMORY; // nothing else is thrown by vectors
    }
}

sf_status sf_embree_voxelize(const sf_embree *embree, sf_grid *grid, sf_task *task)
{
    if (embree == nullptr || grid == nullptr) {
        return SF_ERR_ARGUMENT;
    }
    try {
        return embree::fill_grid(embree, grid, task);
    } catch (...) {
        return SF_ERR_MEMORY; // nothing else is thrown by vectors
    }
}

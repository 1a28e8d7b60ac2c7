// SPDX-License-Identifier: MIT
// A closed surface filled with tetrahedra by TetGen, and painted values spread inside.
//
// TetGen gets each triangle as a facet and the vertices, merged, as points, which stay the first of
// its points. It says of each triangle of the filled surface which facet it lies in: so a point
// that it has added there takes the value between the vertices of that facet. All others are free,
// and sf_tets_spread() settles them. TetGen ends by throwing numbers, which say why; and writes to
// the standard output unless it is told to be quiet.

#include <sf/link/tetgen.h>

extern "C" {
#include "base/status.h"
}

#define TETLIBRARY
#include <tetgen.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

namespace {

struct mesh_guard {
    sf_mesh *mesh = nullptr;
    ~mesh_guard()
    {
        sf_mesh_destroy(mesh);
    }
};

struct job {
    sf_tetgen_options how;
    const sf_allocator *allocator;
    sf_task *task;
    sf_fault *fault;
};

// ---------------------------------------------------------------------------------------------
// What TetGen gets
// ---------------------------------------------------------------------------------------------

sf_status check(sf_mesh_view mesh, const job &j)
{
    const sf_tetgen_options &how = j.how;
    SF_TRY(sf_mesh_validate(mesh, j.fault));
    if (!(how.quality >= 1.1 && how.quality <= 100) ||
        !(how.most_mm3 >= 0 && how.most_mm3 <= 1e30) ||
        (how.values != nullptr && how.property == nullptr)) {
        return sfi_fault_set(
            j.fault, SF_ERR_ARGUMENT, 0, 0,
            "quality is 1.1 to 100, a volume not below 0, and values need a property");
    }
    if (mesh.triangle_count > (size_t)1 << 28 || mesh.vertex_count > (size_t)1 << 29) {
        return sfi_fault_set(j.fault, SF_ERR_OVERFLOW, 0, 0, "the surface has too many triangles");
    }
    for (size_t i = 0; how.values != nullptr && i < mesh.vertex_count; i++) {
        if (!std::isnan(how.values[i]) &&
            !(how.values[i] >= how.property->low && how.values[i] <= how.property->high &&
              std::isfinite(how.values[i]))) {
            return sfi_fault_set(j.fault, SF_ERR_ARGUMENT, 0, 0,
                                 "the value of vertex %zu lies outside of its property's bounds",
                                 i);
        }
    }
    return SF_OK;
}

sf_status check_closed(sf_mesh_view merged, const job &j, double *volume)
{
    sf_topology topology;
    sf_mass mass;
    sf_status status = sf_mesh_analyze(merged, j.allocator, &topology);
    if (status != SF_OK) {
        return status;
    }
    if (merged.triangle_count < 4 || !topology.closed) {
        return sfi_fault_set(
            j.fault, SF_ERR_UNSUPPORTED, 0, 0,
            "the surface is not closed (%zu open edges), so it has no inside; close "
            "it, or go by voxels",
            topology.boundary_edges);
    }
    status = sf_mesh_measure(merged, &mass);
    *volume = std::fabs(mass.volume_mm3);
    return status;
}

// The values of merged vertices: found by their places, which merging does not change.
std::vector<double> merge_values(sf_mesh_view mesh, sf_mesh_view merged, const double *values)
{
    auto less = [](const double *a, const double *b) {
        return std::lexicographical_compare(a, a + 3, b, b + 3);
    };
    std::vector<uint32_t> order(merged.vertex_count);
    std::vector<double> found(merged.vertex_count, NAN);
    for (size_t i = 0; i < order.size(); i++) {
        order[i] = uint32_t(i);
    }
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        return less(merged.vertices + 3 * size_t(a), merged.vertices + 3 * size_t(b));
    });
    for (size_t i = 0; values != nullptr && i < mesh.vertex_count; i++) {
        const double *p = mesh.vertices + 3 * i;
        auto at = std::lower_bound(order.begin(), order.end(), p, [&](uint32_t a, const double *q) {
            return less(merged.vertices + 3 * size_t(a), q);
        });
        if (at != order.end() && !less(p, merged.vertices + 3 * size_t(*at)) &&
            !std::isnan(values[i])) {
            found[*at] = values[i];
        }
    }
    return found;
}

void fill_in(sf_mesh_view merged, tetgenio *in)
{
    in->firstnumber = 0;
    in->numberofpoints = int(merged.vertex_count);
    in->pointlist = new REAL[3 * merged.vertex_count];
    std::copy(merged.vertices, merged.vertices + 3 * merged.vertex_count, in->pointlist);
    in->facetlist = new tetgenio::facet[merged.triangle_count];
    in->facetmarkerlist = new int[merged.triangle_count];
    in->numberoffacets = int(merged.triangle_count);
    for (size_t t = 0; t < merged.triangle_count; t++) {
        tetgenio::init(&in->facetlist[t]); // so that the destructor may run at any time
    }
    for (size_t t = 0; t < merged.triangle_count; t++) {
        tetgenio::facet *f = &in->facetlist[t];
        f->polygonlist = new tetgenio::polygon[1];
        f->numberofpolygons = 1;
        tetgenio::init(&f->polygonlist[0]);
        f->polygonlist[0].vertexlist = new int[3];
        f->polygonlist[0].numberofvertices = 3;
        for (size_t k = 0; k < 3; k++) {
            f->polygonlist[0].vertexlist[k] = int(merged.triangles[3 * t + k]);
        }
        in->facetmarkerlist[t] = int(t) + 1;
    }
}

// ---------------------------------------------------------------------------------------------
// What comes of it
// ---------------------------------------------------------------------------------------------

// Between the corners of a triangle, by areas.
double between(sf_mesh_view m, size_t t, const std::vector<double> &values, const double *p)
{
    double sum = 0, whole = 0;
    for (size_t k = 0; k < 3; k++) {
        const double *a = m.vertices + 3 * size_t(m.triangles[3 * t + (k + 1) % 3]);
        const double *b = m.vertices + 3 * size_t(m.triangles[3 * t + (k + 2) % 3]);
        double n[3], square = 0;
        for (int i = 0; i < 3; i++) {
            int u = (i + 1) % 3, v = (i + 2) % 3;
            n[i] = (a[u] - p[u]) * (b[v] - p[v]) - (a[v] - p[v]) * (b[u] - p[u]);
            square += n[i] * n[i];
        }
        sum += std::sqrt(square) * values[m.triangles[3 * t + k]];
        whole += std::sqrt(square);
    }
    return whole > 0 ? sum / whole : values[m.triangles[3 * t]];
}

// Points of the surface keep what is painted; NaN where nothing is.
std::vector<double> paint(const tetgenio &out, sf_mesh_view merged,
                          const std::vector<double> &painted)
{
    std::vector<double> values(size_t(out.numberofpoints), NAN);
    std::copy(painted.begin(), painted.end(), values.begin());
    for (int f = 0; f < out.numberoftrifaces && out.trifacemarkerlist != nullptr; f++) {
        int marker = out.trifacemarkerlist[f];
        for (int k = 0; k < 3 && marker >= 1 && size_t(marker) <= merged.triangle_count; k++) {
            size_t point = size_t(out.trifacelist[3 * f + k]);
            if (point >= merged.vertex_count && std::isnan(values[point])) {
                values[point] =
                    between(merged, size_t(marker) - 1, painted, out.pointlist + 3 * point);
            }
        }
    }
    return values;
}

sf_status spread(sf_tets *tets, const std::vector<double> &values, const job &j)
{
    std::vector<uint8_t> fixed(values.size());
    size_t count = 0;
    for (size_t i = 0; i < values.size(); i++) {
        fixed[i] = !std::isnan(values[i]);
        count += fixed[i];
    }
    if (count == 0) {
        return sfi_fault_set(j.fault, SF_ERR_ARGUMENT, 0, 0,
                             "no vertex of the surface has a value");
    }
    sf_status status = sf_tets_spread(tets, 0, fixed.data(), j.allocator, j.task, nullptr);
    return status != SF_ERR_INFEASIBLE
               ? status
               : sfi_fault_set(j.fault, status, 0, 0,
                               "the values do not settle: the tetrahedra are too flat; ask for a "
                               "better quality");
}

// TetGen's tetrahedra as ours, whose first three corners are seen the other way round.
sf_status take(const tetgenio &out, std::vector<double> values, const job &j, sf_tets **tets)
{
    std::vector<uint32_t> corners(4 * size_t(out.numberoftetrahedra));
    for (size_t t = 0; t < size_t(out.numberoftetrahedra); t++) {
        const int *from = out.tetrahedronlist + t * size_t(out.numberofcorners);
        const double *p[4];
        for (size_t k = 0; k < 4; k++) {
            corners[4 * t + k] = uint32_t(from[k]);
            p[k] = out.pointlist + 3 * size_t(from[k]);
        }
        double e[3][3], six = 0;
        for (int k = 0; k < 3; k++) {
            for (int i = 0; i < 3; i++) {
                e[k][i] = p[k + 1][i] - p[0][i];
            }
        }
        for (int i = 0; i < 3; i++) {
            int u = (i + 1) % 3, v = (i + 2) % 3;
            six += (e[0][u] * e[1][v] - e[0][v] * e[1][u]) * e[2][i];
        }
        if (six < 0) {
            std::swap(corners[4 * t + 1], corners[4 * t + 2]);
        }
    }
    double least = 0;
    for (double &value : values) { // free points begin at any value that is painted
        least = std::isnan(value) ? least : value;
    }
    std::vector<double> begin(values);
    std::replace_if(
        begin.begin(), begin.end(), [](double v) { return std::isnan(v); }, least);
    sf_channel channel = {};
    if (j.how.property != nullptr) {
        channel.property = *j.how.property;
    }
    channel.value_count = begin.size();
    channel.values = begin.data();
    sf_tets_view view = {size_t(out.numberofpoints),     out.pointlist,
                         size_t(out.numberoftetrahedra), corners.data(),
                         j.how.values != nullptr,        &channel};
    SF_TRY(sf_tets_create(&view, j.allocator, tets, j.fault));
    return j.how.values != nullptr ? spread(*tets, values, j) : SF_OK;
}

// What TetGen means by the numbers that it throws.
sf_status explain(int number, sf_fault *fault)
{
    switch (number) {
    case 1:
        return SF_ERR_MEMORY;
    case 3:
        return sfi_fault_set(
            fault, SF_ERR_UNSUPPORTED, 0, 0,
            "the surface goes through itself, which TetGen cannot fill; repair it, "
            "or go by voxels");
    case 4:
    case 5:
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "the surface has features too small, or facets too close, for TetGen");
    default:
        return sfi_fault_set(fault, SF_ERR_INTERNAL, 0, 0, "TetGen failed, number %d", number);
    }
}

// Whether triangles go through each other. Asked first, because TetGen 1.5.0, when it finds that
// while it fills, frees its memory twice and ends the process.
bool goes_through_itself(sf_mesh_view merged)
{
    tetgenio in, out;
    char switches[] = "pdQ";
    fill_in(merged, &in);
    tetrahedralize(switches, &in, &out);
    return out.numberoftrifaces > 0;
}

sf_status run(sf_mesh_view mesh, const job &j, sf_tets **tets)
{
    mesh_guard guard;
    double volume = 0;
    SF_TRY(check(mesh, j));
    SF_TRY(sf_mesh_merge(mesh, j.allocator, &guard.mesh));
    sf_mesh_view merged = sf_mesh_get_view(guard.mesh);
    SF_TRY(check_closed(merged, j, &volume));
    if (goes_through_itself(merged)) {
        return explain(3, j.fault);
    }
    std::vector<double> painted = merge_values(mesh, merged, j.how.values);
    tetgenio in, out;
    char switches[128];
    fill_in(merged, &in);
    double most = j.how.most_mm3 > 0 ? j.how.most_mm3 : volume / 20000;
    std::snprintf(switches, sizeof switches, "pq%.6fa%.12fzQ", j.how.quality, most);
    for (char *c = switches; *c != '\0'; c++) {
        *c = *c == ',' ? '.' : *c; // whatever the locale
    }
    if (sf_task_is_cancelled(j.task)) {
        return SF_ERR_CANCELLED;
    }
    tetrahedralize(switches, &in, &out);
    if (sf_task_is_cancelled(j.task)) {
        return SF_ERR_CANCELLED;
    }
    if (out.numberoftetrahedra <= 0 || size_t(out.numberofpoints) < merged.vertex_count) {
        return sfi_fault_set(j.fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "TetGen makes nothing of the surface");
    }
    return take(out, paint(out, merged, painted), j, tets);
}

} // namespace

sf_tetgen_options sf_tetgen_options_default(void)
{
    sf_tetgen_options options = {sizeof options, 2, 0, nullptr, nullptr};
    return options;
}

sf_status sf_tetgen_fill(sf_mesh_view mesh, const sf_tetgen_options *options,
                         const sf_allocator *allocator, sf_task *task, sf_tets **tets,
                         sf_fault *fault)
{
    job j = {sf_tetgen_options_default(), allocator, task, fault};
    sf_tets *made = nullptr;
    sf_status status;
    if (options != nullptr) {
        std::memcpy(&j.how, options, std::min(options->struct_size, sizeof j.how));
    }
    if (tets == nullptr) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "there is no place for the tetrahedra");
    }
    try {
        status = run(mesh, j, &made);
    } catch (int number) {
        status = explain(number, fault);
    } catch (const std::bad_alloc &) {
        status = SF_ERR_MEMORY;
    } catch (...) {
        status = sfi_fault_set(fault, SF_ERR_INTERNAL, 0, 0, "TetGen failed in an unknown way");
    }
    if (status == SF_ERR_MEMORY) {
        sfi_fault_set(fault, status, 0, 0, "there is not enough memory for these tetrahedra");
    }
    if (status != SF_OK) {
        sf_tets_destroy(made);
        return status;
    }
    *tets = made;
    return SF_OK;
}

// SPDX-License-Identifier: MIT
// The boundary of a cage, refined by OpenSubdiv.
//
// A face of a cage of cells lies on the boundary if no other cell has it. These faces, turned
// outwards, are handed to OpenSubdiv with the cage's creases, which by the cage's rules lie on
// them. OpenSubdiv refines all of them alike; its masks then move the points of the last level to
// the limit. A mask knows smooth, sharp and nothing between, so levels are added until what is half
// sharp has become smooth; the points that were asked for are found again as the children of their
// children.

#include <sf/link/opensubdiv.h>

extern "C" {
#include "base/status.h"
}

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

// A point as OpenSubdiv adds them up.
struct point {
    double x[3];

    void Clear()
    {
        x[0] = x[1] = x[2] = 0;
    }

    void AddWithWeight(const point &p, double weight)
    {
        for (int i = 0; i < 3; i++) {
            x[i] += weight * p.x[i];
        }
    }
};

// Faces and what is sharp, as OpenSubdiv takes them.
struct control {
    std::vector<int> sizes, corners; // of faces
    std::vector<int> crease_ends, sharp_points;
    std::vector<float> crease_weights, sharp_weights;
    std::vector<point> points;
    double half_sharp; // the largest sharpness that ends
};

// ---------------------------------------------------------------------------------------------
// The boundary
// ---------------------------------------------------------------------------------------------

struct face {
    std::vector<uint32_t> corners, sorted;
};

void add_face(std::vector<face> *faces, const uint32_t *cell, std::initializer_list<size_t> places)
{
    face f;
    for (size_t place : places) {
        f.corners.push_back(cell[place]);
    }
    f.sorted = f.corners;
    std::sort(f.sorted.begin(), f.sorted.end());
    faces->push_back(std::move(f));
}

// The faces of a tetrahedron, or of a prism over a polygon, seen from outside counter-clockwise.
void add_cell(std::vector<face> *faces, const uint32_t *cell, size_t count)
{
    if (count == 4) {
        add_face(faces, cell, {0, 2, 1});
        add_face(faces, cell, {0, 1, 3});
        add_face(faces, cell, {1, 2, 3});
        add_face(faces, cell, {2, 0, 3});
        return;
    }
    size_t n = count / 2;
    face lower, upper;
    for (size_t i = 0; i < n; i++) {
        lower.corners.push_back(cell[n - 1 - i]);
        upper.corners.push_back(cell[n + i]);
        add_face(faces, cell, {i, (i + 1) % n, n + (i + 1) % n, n + i});
    }
    for (face *f : {&lower, &upper}) {
        f->sorted = f->corners;
        std::sort(f->sorted.begin(), f->sorted.end());
        faces->push_back(std::move(*f));
    }
}

// Those of one cell alone, in the order of their points.
std::vector<face> boundary_of(const sf_cage_view &v)
{
    std::vector<face> all, kept;
    for (size_t i = 0; i < v.cell_count; i++) {
        add_cell(&all, v.corners + v.starts[i], v.starts[i + 1] - v.starts[i]);
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const face &a, const face &b) { return a.sorted < b.sorted; });
    for (size_t i = 0; i < all.size(); i++) {
        bool is_inside = (i > 0 && all[i - 1].sorted == all[i].sorted) ||
                         (i + 1 < all.size() && all[i + 1].sorted == all[i].sorted);
        if (!is_inside) {
            kept.push_back(all[i]);
        }
    }
    return kept;
}

std::vector<face> faces_of(const sf_cage_view &v)
{
    std::vector<face> faces(v.cell_count);
    for (size_t i = 0; i < v.cell_count; i++) {
        faces[i].corners.assign(v.corners + v.starts[i], v.corners + v.starts[i + 1]);
    }
    return faces;
}

void take_sharpness(const sf_cage_view &v, const std::vector<int> &number, control *c)
{
    for (size_t i = 0; i < v.crease_count; i++) {
        const sf_crease &crease = v.creases[i];
        c->crease_ends.push_back(number[crease.points[0]]);
        c->crease_ends.push_back(number[crease.points[1]]);
        c->crease_weights.push_back(float(std::min(crease.sharpness, SF_SHARP)));
        c->half_sharp =
            crease.sharpness < SF_SHARP ? std::max(c->half_sharp, crease.sharpness) : c->half_sharp;
    }
    for (size_t i = 0; i < v.sharp_count; i++) {
        const sf_sharp_point &sharp = v.sharps[i];
        c->sharp_points.push_back(number[sharp.point]);
        c->sharp_weights.push_back(float(std::min(sharp.sharpness, SF_SHARP)));
        c->half_sharp =
            sharp.sharpness < SF_SHARP ? std::max(c->half_sharp, sharp.sharpness) : c->half_sharp;
    }
}

control control_of(const sf_cage_view &v)
{
    control c;
    std::vector<face> faces = v.dimension == 3 ? boundary_of(v) : faces_of(v);
    std::vector<int> number(v.point_count, -1);
    c.half_sharp = 0;
    for (const face &f : faces) {
        c.sizes.push_back(int(f.corners.size()));
        for (uint32_t corner : f.corners) {
            if (number[corner] < 0) {
                point p;
                std::memcpy(p.x, v.positions + 3 * size_t(corner), sizeof p.x);
                number[corner] = int(c.points.size());
                c.points.push_back(p);
            }
            c.corners.push_back(number[corner]);
        }
    }
    take_sharpness(v, number, &c);
    return c;
}

// ---------------------------------------------------------------------------------------------
// Refining
// ---------------------------------------------------------------------------------------------

struct job {
    sf_opensubdiv_options how;
    sf_task *task;
    sf_fault *fault;
    int levels; // that are made; at least how.steps
};

void report(const job &j, double fraction)
{
    if (j.task != nullptr && j.task->progress != nullptr) {
        j.task->progress(j.task->user, fraction);
    }
}

// How many levels, and whether their faces, four times as many each time, are not too many.
sf_status plan(const control &c, job *j)
{
    double faces = double(c.corners.size()); // after one level
    j->levels = int(j->how.steps);
    if (j->how.on_limit) {
        // Masks are those of quadrilaterals, which all faces are after a level.
        j->levels = std::max({j->levels, int(std::ceil(c.half_sharp)), 1});
    }
    for (int i = 1; i < j->levels; i++) {
        faces *= 4;
    }
    if (faces > SF_OPENSUBDIV_FACE_MAX) {
        return sfi_fault_set(j->fault, SF_ERR_OVERFLOW, 0, 0,
                             "%d levels, which the steps or the sharpest crease ask for, would be "
                             "more than %u faces; take fewer steps, or softer or harder creases",
                             j->levels, SF_OPENSUBDIV_FACE_MAX);
    }
    return SF_OK;
}

std::unique_ptr<Far::TopologyRefiner> refiner_of(const control &c)
{
    Far::TopologyDescriptor d;
    Sdc::Options rules;
    rules.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    d.numVertices = int(c.points.size());
    d.numFaces = int(c.sizes.size());
    d.numVertsPerFace = c.sizes.data();
    d.vertIndicesPerFace = c.corners.data();
    d.numCreases = int(c.crease_weights.size());
    d.creaseVertexIndexPairs = c.crease_ends.data();
    d.creaseWeights = c.crease_weights.data();
    d.numCorners = int(c.sharp_weights.size());
    d.cornerVertexIndices = c.sharp_points.data();
    d.cornerWeights = c.sharp_weights.data();
    typedef Far::TopologyRefinerFactory<Far::TopologyDescriptor> factory;
    factory::Options options(Sdc::SCHEME_CATMARK, rules);
    options.validateFullTopology = true;
    return std::unique_ptr<Far::TopologyRefiner>(factory::Create(d, options));
}

// The points after `steps`, and those on the limit where that is asked for.
sf_status points_of(const control &c, const Far::TopologyRefiner &refiner, const job &j,
                    std::vector<point> *points)
{
    Far::PrimvarRefinerReal<double> primvars(refiner);
    std::vector<point> now = c.points, next;
    for (int level = 1; level <= j.levels; level++) {
        if (sf_task_is_cancelled(j.task)) {
            return SF_ERR_CANCELLED;
        }
        next.resize(size_t(refiner.GetLevel(level).GetNumVertices()));
        primvars.Interpolate(level, now, next);
        now.swap(next);
        report(j, 0.8 * level / j.levels);
    }
    if (!j.how.on_limit) {
        points->swap(now);
        return SF_OK;
    }
    next.resize(now.size());
    primvars.Limit(now, next);
    int count = refiner.GetLevel(int(j.how.steps)).GetNumVertices();
    for (int i = 0; i < count; i++) {
        int vertex = i;
        for (int level = int(j.how.steps); level < j.levels; level++) {
            vertex = refiner.GetLevel(level).GetVertexChildVertex(vertex);
        }
        points->push_back(next[size_t(vertex)]);
    }
    return SF_OK;
}

sf_status fill(const std::vector<point> &points, const Far::TopologyLevel &level, sf_mesh *mesh)
{
    for (const point &p : points) {
        SF_TRY(sf_mesh_add_vertices(mesh, p.x, 1));
    }
    for (int f = 0; f < level.GetNumFaces(); f++) {
        Far::ConstIndexArray corners = level.GetFaceVertices(f);
        for (int i = 2; i < corners.size(); i++) {
            uint32_t triangle[3] = {uint32_t(corners[0]), uint32_t(corners[i - 1]),
                                    uint32_t(corners[i])};
            SF_TRY(sf_mesh_add_triangles(mesh, triangle, 1));
        }
    }
    return SF_OK;
}

sf_status run(const sf_cage *cage, job *j, sf_mesh *mesh)
{
    control c = control_of(sf_cage_get_view(cage));
    if (c.sizes.empty()) {
        return sfi_fault_set(j->fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "the cage has no boundary, so there is no surface");
    }
    SF_TRY(plan(c, j));
    std::unique_ptr<Far::TopologyRefiner> refiner = refiner_of(c);
    if (refiner == nullptr) {
        return sfi_fault_set(j->fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "OpenSubdiv refuses the cage's boundary");
    }
    Far::TopologyRefiner::UniformOptions levels(j->levels);
    levels.fullTopologyInLastLevel = true;
    refiner->RefineUniform(levels);
    std::vector<point> points;
    SF_TRY(points_of(c, *refiner, *j, &points));
    SF_TRY(fill(points, refiner->GetLevel(int(j->how.steps)), mesh));
    report(*j, 1);
    return SF_OK;
}

} // namespace

sf_opensubdiv_options sf_opensubdiv_options_default(void)
{
    sf_opensubdiv_options options = {sizeof options, 2, 1};
    return options;
}

sf_status sf_opensubdiv_mesh(const sf_cage *cage, const sf_opensubdiv_options *options,
                             const sf_allocator *allocator, sf_task *task, sf_mesh **mesh,
                             sf_fault *fault)
{
    job j = {sf_opensubdiv_options_default(), task, fault, 0};
    if (options != nullptr) {
        std::memcpy(&j.how, options, std::min(options->struct_size, sizeof j.how));
    }
    if (cage == nullptr || mesh == nullptr || j.how.steps > SF_OPENSUBDIV_STEP_MAX) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "no cage, no place for the mesh, or more than %u steps",
                             SF_OPENSUBDIV_STEP_MAX);
    }
    sf_mesh *made = nullptr;
    sf_status status = sf_mesh_create(allocator, &made);
    try {
        status = status == SF_OK ? run(cage, &j, made) : status;
    } catch (const std::bad_alloc &) {
        status = SF_ERR_MEMORY;
    } catch (...) {
        status = sfi_fault_set(fault, SF_ERR_INTERNAL, 0, 0, "OpenSubdiv failed in an unknown way");
    }
    if (status == SF_ERR_MEMORY) {
        sfi_fault_set(fault, status, 0, 0, "there is not enough memory for this surface");
    }
    if (status != SF_OK) {
        sf_mesh_destroy(made);
        return status;
    }
    *mesh = made;
    return SF_OK;
}

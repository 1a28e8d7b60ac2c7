// SPDX-License-Identifier: MIT
// A mesh prepared for Embree, and its rays.
//
// Embree computes in floats. So the mesh is moved, in doubles, to have its middle in the origin,
// and only then rounded; rays are moved alike. The scene is robust, so that no ray slips between
// two triangles that share an edge. Of Embree's threads one is asked for, which is the caller's.

#include "link/embree.h"

extern "C" {
#include "base/memory.h"
#include "base/status.h"
}

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace embree {

// The filter of a ray that goes on: keeps each hit and refuses it.
struct collecting {
    embree_context context; // first, so that a filter's context is this
    std::vector<hit> *hits;
    bool is_short_of_memory;
};

static void keep(const RTCFilterFunctionNArguments *arguments)
{
    collecting *c = reinterpret_cast<collecting *>(arguments->context);
    const RTCRayN *ray = arguments->ray;
    const RTCHitN *at = arguments->hit;
    RTCRayN *r = const_cast<RTCRayN *>(ray);
    RTCHitN *h = const_cast<RTCHitN *>(at);
    float facing = RTCHitN_Ng_x(h, 1, 0) * RTCRayN_dir_x(r, 1, 0) +
                   RTCHitN_Ng_y(h, 1, 0) * RTCRayN_dir_y(r, 1, 0) +
                   RTCHitN_Ng_z(h, 1, 0) * RTCRayN_dir_z(r, 1, 0);
    try { // nothing may be thrown through Embree
        c->hits->push_back({RTCRayN_tfar(r, 1, 0), RTCHitN_primID(h, 1, 0), facing > 0});
    } catch (...) {
        c->is_short_of_memory = true;
    }
    arguments->valid[0] = 0;
}

RTCRayHit ray_at(const sf_embree *e, const double from[3], const double direction[3],
                 double nearest)
{
    RTCRayHit ray = {};
    ray.ray.org_x = float(from[0] - e->middle[0]);
    ray.ray.org_y = float(from[1] - e->middle[1]);
    ray.ray.org_z = float(from[2] - e->middle[2]);
    ray.ray.dir_x = float(direction[0]);
    ray.ray.dir_y = float(direction[1]);
    ray.ray.dir_z = float(direction[2]);
    ray.ray.tnear = float(nearest);
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return ray;
}

int cast(const sf_embree *e, RTCRayHit ray, hit *found)
{
    embree_context context;
    embree_cast(e->scene, &context, nullptr, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return 0;
    }
    float facing =
        ray.hit.Ng_x * ray.ray.dir_x + ray.hit.Ng_y * ray.ray.dir_y + ray.hit.Ng_z * ray.ray.dir_z;
    found->along = ray.ray.tfar;
    found->triangle = ray.hit.primID;
    found->leaves = facing > 0;
    return 1;
}

void cast_through(const sf_embree *e, RTCRayHit ray, std::vector<hit> *hits)
{
    collecting c;
    c.hits = hits;
    c.is_short_of_memory = false;
    hits->clear();
    embree_cast(e->scene, &c.context, keep, &ray);
    if (c.is_short_of_memory) {
        throw std::bad_alloc();
    }
    std::sort(hits->begin(), hits->end(), [](const hit &a, const hit &b) {
        return a.along != b.along ? a.along < b.along : a.triangle < b.triangle;
    });
    // An edge that the ray meets may give a hit of both its triangles: two of a kind at one place.
    float near = float(1e-6 * e->reach);
    hits->erase(std::unique(hits->begin(), hits->end(),
                            [near](const hit &a, const hit &b) {
                                return a.triangle == b.triangle ||
                                       (a.leaves == b.leaves && b.along - a.along <= near);
                            }),
                hits->end());
}

// ---------------------------------------------------------------------------------------------
// Making and freeing
// ---------------------------------------------------------------------------------------------

static sf_status check(sf_mesh_view mesh, sf_embree *e, sf_fault *fault)
{
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    sf_mass mass;
    SF_TRY(sf_mesh_validate(mesh, fault));
    if (mesh.triangle_count == 0) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "a mesh without triangles has no hits");
    }
    if (mesh.triangle_count >= SF_EMBREE_NONE) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "the mesh has 2^32 - 1 triangles or more");
    }
    SF_TRY(sf_mesh_bounds(mesh, low, high));
    for (int i = 0; i < 3; i++) {
        if (!(low[i] >= -1e12 && high[i] <= 1e12)) {
            return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                                 "a corner of the mesh lies beyond 1e12 mm");
        }
        e->middle[i] = (low[i] + high[i]) / 2;
        e->reach = std::max(e->reach, (high[i] - low[i]) / 2);
    }
    e->turned = sf_mesh_measure(mesh, &mass) == SF_OK && mass.volume_mm3 < 0;
    e->triangle_count = mesh.triangle_count;
    return SF_OK;
}

static sf_status fill(sf_mesh_view mesh, sf_embree *e)
{
    RTCGeometry shape = rtcNewGeometry(e->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *vertices = static_cast<float *>(rtcSetNewGeometryBuffer(
        shape, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertex_count));
    uint32_t *corners = static_cast<uint32_t *>(
        rtcSetNewGeometryBuffer(shape, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(uint32_t), mesh.triangle_count));
    if (vertices == nullptr || corners == nullptr) {
        rtcReleaseGeometry(shape);
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < 3 * mesh.vertex_count; i++) {
        vertices[i] = float(mesh.vertices[i] - e->middle[i % 3]);
    }
    std::copy(mesh.triangles, mesh.triangles + 3 * mesh.triangle_count, corners);
    rtcCommitGeometry(shape);
    rtcAttachGeometry(e->scene, shape);
    rtcReleaseGeometry(shape);
    rtcCommitScene(e->scene);
    return SF_OK;
}

static sf_status build(sf_mesh_view mesh, sf_embree *e, sf_fault *fault)
{
    e->device = rtcNewDevice("threads=1,set_affinity=0");
    if (e->device == nullptr) {
        return sfi_fault_set(fault, SF_ERR_INTERNAL, 0, 0, "Embree cannot be used on this machine");
    }
    e->scene = rtcNewScene(e->device);
    rtcSetSceneFlags(e->scene, RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | SF_EMBREE_SCENE_FILTER));
    SF_TRY(fill(mesh, e));
    RTCError error = rtcGetDeviceError(e->device);
    if (error == RTC_ERROR_OUT_OF_MEMORY) {
        return SF_ERR_MEMORY;
    }
    return error == RTC_ERROR_NONE ? SF_OK
                                   : sfi_fault_set(fault, SF_ERR_INTERNAL, 0, 0,
                                                   "Embree refuses the mesh, error %d", int(error));
}

static int is_ray(const double *from, const double *direction)
{
    double length = 0;
    for (int i = 0; i < 3; i++) {
        if (!std::isfinite(from[i]) || !std::isfinite(direction[i])) {
            return 0;
        }
        length = std::max(length, std::fabs(double(float(direction[i]))));
    }
    return length > 0 && std::isfinite(length);
}

static sf_status next(void *user, const double from[3], const double direction[3], double beyond,
                      sf_ray_hit *at, int *found)
{
    const sf_embree *e = static_cast<const sf_embree *>(user);
    hit h = {0, 0, 0};
    if (!is_ray(from, direction)) {
        return SF_ERR_ARGUMENT;
    }
    double length = std::sqrt(direction[0] * direction[0] + direction[1] * direction[1] +
                              direction[2] * direction[2]);
    double step = beyond > 0 ? 2e-6 * e->reach / length : 0;
    *found = cast(e, ray_at(e, from, direction, beyond + step), &h);
    at->along = std::max(double(h.along), std::nextafter(beyond, INFINITY));
    at->triangle = h.triangle;
    at->leaves = h.leaves != e->turned;
    return SF_OK;
}

} // namespace embree

sf_status sf_embree_create(sf_mesh_view mesh, const sf_allocator *allocator, sf_embree **embree,
                           sf_fault *fault)
{
    sf_allocator from = sfi_allocator_or_default(allocator);
    if (embree == nullptr) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "there is no place for the object");
    }
    sf_embree made = {from, nullptr, nullptr, 0, {0, 0, 0}, 0, 0};
    SF_TRY(embree::check(mesh, &made, fault));
    sf_embree *e = static_cast<sf_embree *>(sfi_alloc_array(&from, 1, sizeof *e));
    sf_status status = SF_ERR_MEMORY;
    if (e != nullptr) {
        *e = made;
        try {
            status = embree::build(mesh, e, fault);
        } catch (const std::bad_alloc &) {
            status = SF_ERR_MEMORY;
        } catch (...) {
            status = sfi_fault_set(fault, SF_ERR_INTERNAL, 0, 0, "Embree failed in an unknown way");
        }
    }
    if (status == SF_ERR_MEMORY) {
        sfi_fault_set(fault, status, 0, 0, "there is not enough memory for this mesh");
    }
    if (status != SF_OK) {
        sf_embree_destroy(e);
        return status;
    }
    *embree = e;
    return SF_OK;
}

void sf_embree_destroy(sf_embree *embree)
{
    if (embree != nullptr) {
        sf_allocator from = embree->allocator;
        if (embree->scene != nullptr) {
            rtcReleaseScene(embree->scene);
        }
        if (embree->device != nullptr) {
            rtcReleaseDevice(embree->device);
        }
        sfi_free_array(&from, embree, 1, sizeof *embree);
    }
}

sf_status sf_embree_nearest(const sf_embree *embree, size_t count, const double *from,
                            const double *direction, double *along, uint32_t *triangle)
{
    if (embree == nullptr ||
        (count > 0 && (from == nullptr || direction == nullptr || along == nullptr))) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < count; i++) {
        if (!embree::is_ray(from + 3 * i, direction + 3 * i)) {
            return SF_ERR_ARGUMENT;
        }
    }
    for (size_t i = 0; i < count; i++) {
        embree::hit h = {0, SF_EMBREE_NONE, 0};
        int found =
            embree::cast(embree, embree::ray_at(embree, from + 3 * i, direction + 3 * i, 0), &h);
        along[i] = found ? double(h.along) : std::numeric_limits<double>::infinity();
        if (triangle != nullptr) {
            triangle[i] = found ? h.triangle : SF_EMBREE_NONE;
        }
    }
    return SF_OK;
}

sf_ray_caster sf_embree_caster(const sf_embree *embree)
{
    sf_ray_caster caster = {embree != nullptr ? embree::next : nullptr,
                            const_cast<sf_embree *>(embree)};
    return caster;
}

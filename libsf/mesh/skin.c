// SPDX-License-Identifier: MIT
// A mesh made ready for voxels: snapped, and turned right side out.
//
// Most meshes are closed, and nothing is copied. One that is not is welded where its snapped
// corners coincide (which alone mends STL files and cracks below 1/256 voxel); then its triangles
// are made to look the same way as their neighbours; then what is still open gets patches over its
// holes, which count crossings and are subtracted again by their winding number (winding.c).
//
// A mesh whose normals all look inward encloses a negative volume. It is read with the opposite
// sign, so that it gives the same voxels as the mesh with every triangle flipped. All of this is
// done for SF_FILL_AUTO. SF_FILL_WINDING takes the triangles as they look, and only patches holes;
// SF_FILL_PARITY asks for nothing at all.

#include "mesh/skin.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "mesh/orient.h"

#include <string.h>

#define FAR INT32_MIN

static sf_status check_triangles(sf_mesh_view mesh, const sfi_skin *skin, sf_fault *fault)
{
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        for (size_t i = 0; i < 3; i++) {
            uint32_t corner = mesh.triangles[3 * t + i];
            if (corner >= mesh.vertex_count) {
                return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                     "Triangle %zu names vertex %u, but there are only %zu.", t,
                                     corner, mesh.vertex_count);
            }
            if (skin->points[corner].x == FAR) {
                return sfi_fault_set(
                    fault, SF_ERR_UNSUPPORTED, 0, 0,
                    "Vertex %u of triangle %zu is not finite or lies more than two million voxels "
                    "from the lattice; mend it, or check the unit of length.",
                    corner, t);
            }
        }
    }
    return SF_OK;
}

// Six times the signed volume, in units: exact enough for its sign wherever the sign matters.
static double signed_volume(const sfi_skin *skin)
{
    double sum = 0.0;
    sfi_point o = skin->points[skin->triangles[0]];
    for (size_t t = 0; t < skin->triangle_count; t++) {
        const uint32_t *corner = skin->triangles + 3 * t;
        double v[3][3];
        for (int i = 0; i < 3; i++) {
            const sfi_point *p = skin->points + corner[i];
            v[i][0] = (double)p->x - o.x;
            v[i][1] = (double)p->y - o.y;
            v[i][2] = (double)p->z - o.z;
        }
        sum += v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
               v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
               v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
    }
    return sum;
}

static sf_status set_fault(sf_fault *fault, sf_status status)
{
    return sfi_fault_set(fault, status, 0, 0, "%s", sf_status_message(status));
}

// Replace the triangles, which are welded, by themselves and the patches.
static sf_status append_patches(sfi_skin *skin, const sf_allocator *allocator)
{
    size_t count;
    if (!sfi_size_add(skin->mesh_count, skin->winding.patch_count, &count) || count > UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    uint32_t *all = sfi_alloc_array(allocator, count, 3 * sizeof *all);
    if (all == NULL) {
        return SF_ERR_MEMORY;
    }
    memcpy(all, skin->owned, skin->mesh_count * 3 * sizeof *all);
    sfi_winding_patches(&skin->winding, all + 3 * skin->mesh_count);
    sfi_free_array(allocator, skin->owned, skin->triangle_count, 3 * sizeof *all);
    skin->triangles = skin->owned = all;
    skin->triangle_count = count;
    return SF_OK;
}

static sf_status patch_holes(sfi_skin *skin, const sfi_frame *frame, const sf_allocator *allocator)
{
    sfi_loops loops;
    SF_TRY(sfi_loops_create(skin->points, skin->point_count, skin->triangles, skin->triangle_count,
                            allocator, &loops));
    skin->boundary_edges = loops.edge_count;
    sf_status status = sfi_winding_create(frame, skin->points, &loops, allocator, &skin->winding);
    sfi_loops_destroy(&loops, allocator);
    return status == SF_OK ? append_patches(skin, allocator) : status;
}

static int is_closed(const sfi_skin *skin)
{
    return sfi_chain_closed(skin->points, skin->triangles, skin->triangle_count);
}

// Make a closed chain out of a mesh that is none.
static sf_status mend(sfi_skin *skin, const sfi_frame *frame, sf_fill fill,
                      const sf_allocator *allocator)
{
    if (skin->triangle_count > SFI_CHAIN_MAX) {
        return SF_ERR_OVERFLOW;
    }
    uint32_t *welded = sfi_alloc_array(allocator, skin->triangle_count, 3 * sizeof *welded);
    if (welded == NULL) {
        return SF_ERR_MEMORY;
    }
    size_t turned;
    sf_status status = sfi_chain_weld(skin->points, skin->point_count, skin->triangles,
                                      skin->triangle_count, allocator, welded);
    skin->triangles = skin->owned = welded;
    if (status == SF_OK && fill == SF_FILL_AUTO) {
        status = sfi_orient(welded, skin->triangle_count, skin->point_count, allocator, &turned);
    }
    return status == SF_OK && !is_closed(skin) ? patch_holes(skin, frame, allocator) : status;
}

// Read the whole with the opposite sign.
static void flip(sfi_skin *skin)
{
    skin->flipped = 1;
    if (skin->winding.node_count == 0) {
        skin->mark = SFI_STEP_LEAVES;
        return;
    }
    sfi_winding_flip(&skin->winding);
    for (size_t t = 0; t < skin->triangle_count; t++) {
        uint32_t *corner = skin->owned + 3 * t, swap = corner[0];
        corner[0] = corner[1];
        corner[1] = swap;
    }
}

static sf_status snap(sf_mesh_view mesh, const sfi_frame *frame, const sf_allocator *allocator,
                      sfi_skin *skin, sf_fault *fault)
{
    skin->point_count = mesh.vertex_count;
    skin->points = sfi_alloc_array(allocator, mesh.vertex_count, sizeof(sfi_point));
    if (skin->points == NULL && mesh.vertex_count > 0) {
        return set_fault(fault, SF_ERR_MEMORY);
    }
    for (size_t i = 0; i < mesh.vertex_count; i++) {
        if (!sfi_frame_snap(frame, mesh.vertices + 3 * i, &skin->points[i])) {
            skin->points[i].x = FAR;
        }
    }
    skin->triangles = mesh.triangles;
    skin->triangle_count = skin->mesh_count = mesh.triangle_count;
    return check_triangles(mesh, skin, fault);
}

sf_status sfi_skin_create(sf_mesh_view mesh, const sfi_frame *frame, sf_fill fill,
                          const sf_allocator *allocator, sfi_skin *skin, sf_fault *fault)
{
    memset(skin, 0, sizeof *skin);
    if (mesh.triangle_count == 0) {
        return SF_OK;
    }
    sf_status status = snap(mesh, frame, allocator, skin, fault);
    int signed_fill = fill == SF_FILL_AUTO || fill == SF_FILL_WINDING;
    if (status == SF_OK && signed_fill && !is_closed(skin)) {
        status = mend(skin, frame, fill, allocator);
        if (status != SF_OK) {
            set_fault(fault, status);
        }
    }
    if (status != SF_OK) {
        sfi_skin_destroy(skin, allocator);
        return status;
    }
    if (fill == SF_FILL_AUTO && signed_volume(skin) < 0.0) {
        flip(skin);
    }
    return SF_OK;
}

void sfi_skin_destroy(sfi_skin *skin, const sf_allocator *allocator)
{
    sfi_winding_destroy(&skin->winding, allocator);
    sfi_free_array(allocator, skin->owned, skin->triangle_count, 3 * sizeof *skin->owned);
    sfi_free_array(allocator, skin->points, skin->point_count, sizeof(sfi_point));
    memset(skin, 0, sizeof *skin);
}

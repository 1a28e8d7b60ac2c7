// SPDX-License-Identifier: MIT
// A mesh made ready for voxels: snapped, and turned right side out.
//
// A mesh whose normals all look inward encloses a negative volume. It is read with the opposite
// sign, so that it gives the same voxels as the mesh with every triangle flipped.

#include "mesh/skin.h"

#include "base/memory.h"
#include "base/status.h"
#include "mesh/crossing.h"

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

sf_status sfi_skin_create(sf_mesh_view mesh, const sfi_frame *frame, sf_fill fill,
                          const sf_allocator *allocator, sfi_skin *skin, sf_fault *fault)
{
    memset(skin, 0, sizeof *skin);
    if (mesh.triangle_count == 0) {
        return SF_OK;
    }
    skin->point_count = mesh.vertex_count;
    skin->points = sfi_alloc_array(allocator, mesh.vertex_count, sizeof(sfi_point));
    if (skin->points == NULL) {
        return sfi_fault_set(fault, SF_ERR_MEMORY, 0, 0, "%s", sf_status_message(SF_ERR_MEMORY));
    }
    for (size_t i = 0; i < mesh.vertex_count; i++) {
        if (!sfi_frame_snap(frame, mesh.vertices + 3 * i, &skin->points[i])) {
            skin->points[i].x = FAR;
        }
    }
    skin->triangles = mesh.triangles;
    skin->triangle_count = mesh.triangle_count;
    sf_status status = check_triangles(mesh, skin, fault);
    if (status != SF_OK) {
        sfi_skin_destroy(skin, allocator);
        return status;
    }
    if (fill == SF_FILL_AUTO && signed_volume(skin) < 0.0) {
        skin->mark = SFI_STEP_LEAVES;
    }
    return SF_OK;
}

void sfi_skin_destroy(sfi_skin *skin, const sf_allocator *allocator)
{
    sfi_free_array(allocator, skin->points, skin->point_count, sizeof(sfi_point));
    memset(skin, 0, sizeof *skin);
}

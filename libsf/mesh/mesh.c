// SPDX-License-Identifier: MIT
// The mesh that owns its arrays.
//
// Invariant: every coordinate is finite and every index names a vertex, because nothing else is
// ever let in. So whoever holds an sf_mesh need not validate it.

#include "mesh/mesh.h"

#include "base/memory.h"
#include "base/status.h"

#include <math.h>
#include <string.h>

// Most vertices and triangles that there is a way to address.
static const size_t vertices_max =
    SIZE_MAX / 3 / sizeof(double) < UINT32_MAX ? SIZE_MAX / 3 / sizeof(double) : UINT32_MAX;
static const size_t triangles_max = SIZE_MAX / 3 / sizeof(uint32_t);

struct sf_mesh {
    sf_allocator allocator;
    double *vertices; // three a vertex
    size_t vertex_count, vertex_capacity;
    uint32_t *triangles; // three a triangle
    size_t triangle_count, triangle_capacity;
};

sf_status sf_mesh_create(const sf_allocator *allocator, sf_mesh **mesh)
{
    if (mesh == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_mesh *made = sfi_alloc_array(&from, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_mesh empty = {from, NULL, 0, 0, NULL, 0, 0};
    *made = empty;
    *mesh = made;
    return SF_OK;
}

void sf_mesh_destroy(sf_mesh *mesh)
{
    if (mesh != NULL) {
        sf_allocator allocator = mesh->allocator;
        sfi_free_array(&allocator, mesh->vertices, mesh->vertex_capacity, 3 * sizeof(double));
        sfi_free_array(&allocator, mesh->triangles, mesh->triangle_capacity, 3 * sizeof(uint32_t));
        sfi_free_array(&allocator, mesh, 1, sizeof *mesh);
    }
}

sf_status sfi_mesh_make(const sf_allocator *allocator, size_t vertex_count, size_t triangle_count,
                        sf_mesh **mesh, double **vertices, uint32_t **triangles)
{
    sf_mesh *made = NULL;
    SF_TRY(sf_mesh_create(allocator, &made));
    made->vertices = sfi_alloc_array(&made->allocator, vertex_count, 3 * sizeof(double));
    made->vertex_capacity = made->vertices != NULL ? vertex_count : 0;
    made->triangles = sfi_alloc_array(&made->allocator, triangle_count, 3 * sizeof(uint32_t));
    made->triangle_capacity = made->triangles != NULL ? triangle_count : 0;
    if (made->vertex_capacity < vertex_count || made->triangle_capacity < triangle_count) {
        sf_mesh_destroy(made);
        return SF_ERR_MEMORY;
    }
    made->vertex_count = vertex_count;
    made->triangle_count = triangle_count;
    *mesh = made;
    *vertices = made->vertices;
    *triangles = made->triangles;
    return SF_OK;
}

sf_mesh_view sf_mesh_get_view(const sf_mesh *mesh)
{
    sf_mesh_view view = {NULL, 0, NULL, 0};
    if (mesh != NULL) {
        view.vertices = mesh->vertices;
        view.vertex_count = mesh->vertex_count;
        view.triangles = mesh->triangles;
        view.triangle_count = mesh->triangle_count;
    }
    return view;
}

sf_status sf_mesh_add_vertices(sf_mesh *mesh, const double *xyz, size_t count)
{
    if (mesh == NULL || (xyz == NULL && count > 0)) {
        return SF_ERR_ARGUMENT;
    }
    if (count > vertices_max - mesh->vertex_count) {
        return SF_ERR_OVERFLOW;
    }
    for (size_t i = 0; i < 3 * count; i++) {
        if (!isfinite(xyz[i])) {
            return SF_ERR_ARGUMENT;
        }
    }
    void *memory = mesh->vertices;
    if (!sfi_grow_array(&mesh->allocator, &memory, &mesh->vertex_capacity,
                        mesh->vertex_count + count, 3 * sizeof(double))) {
        return SF_ERR_MEMORY;
    }
    mesh->vertices = memory;
    if (count > 0) {
        memcpy(mesh->vertices + 3 * mesh->vertex_count, xyz, count * 3 * sizeof(double));
    }
    mesh->vertex_count += count;
    return SF_OK;
}

sf_status sf_mesh_add_triangles(sf_mesh *mesh, const uint32_t *indices, size_t count)
{
    if (mesh == NULL || (indices == NULL && count > 0)) {
        return SF_ERR_ARGUMENT;
    }
    if (count > triangles_max - mesh->triangle_count) {
        return SF_ERR_OVERFLOW;
    }
    for (size_t i = 0; i < 3 * count; i++) {
        if (indices[i] >= mesh->vertex_count) {
            return SF_ERR_ARGUMENT;
        }
    }
    void *memory = mesh->triangles;
    if (!sfi_grow_array(&mesh->allocator, &memory, &mesh->triangle_capacity,
                        mesh->triangle_count + count, 3 * sizeof(uint32_t))) {
        return SF_ERR_MEMORY;
    }
    mesh->triangles = memory;
    if (count > 0) {
        memcpy(mesh->triangles + 3 * mesh->triangle_count, indices, count * 3 * sizeof(uint32_t));
    }
    mesh->triangle_count += count;
    return SF_OK;
}

sf_status sf_mesh_validate(sf_mesh_view mesh, sf_fault *fault)
{
    if (mesh.vertex_count > vertices_max || mesh.triangle_count > triangles_max) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "the mesh has %zu vertices and %zu triangles, more than can be "
                             "numbered or addressed; split it",
                             mesh.vertex_count, mesh.triangle_count);
    }
    if ((mesh.vertices == NULL && mesh.vertex_count > 0) ||
        (mesh.triangles == NULL && mesh.triangle_count > 0)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "the mesh has counts but no arrays");
    }
    for (size_t i = 0; i < 3 * mesh.vertex_count; i++) {
        if (!isfinite(mesh.vertices[i])) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "vertex %zu has a coordinate that is no number; remove it", i / 3);
        }
    }
    for (size_t i = 0; i < 3 * mesh.triangle_count; i++) {
        if (mesh.triangles[i] >= mesh.vertex_count) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "triangle %zu names vertex %lu, but there are only %zu", i / 3,
                                 (unsigned long)mesh.triangles[i], mesh.vertex_count);
        }
    }
    return SF_OK;
}

static double determinant(const double m[9])
{
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
           m[2] * (m[3] * m[7] - m[4] * m[6]);
}

static void apply(const sf_transform *t, const double p[3], double q[3])
{
    for (int row = 0; row < 3; row++) {
        const double *m = t->matrix + 3 * row;
        q[row] = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + t->shift_mm[row];
    }
}

sf_status sf_mesh_transform(sf_mesh *mesh, const sf_transform *transform)
{
    if (mesh == NULL || transform == NULL) {
        return SF_ERR_ARGUMENT;
    }
    double det = determinant(transform->matrix);
    if (det == 0.0 || !isfinite(det)) {
        return SF_ERR_ARGUMENT;
    }
    double moved[3];
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        apply(transform, mesh->vertices + 3 * i, moved);
        if (!isfinite(moved[0]) || !isfinite(moved[1]) || !isfinite(moved[2])) {
            return SF_ERR_OVERFLOW;
        }
    }
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        apply(transform, mesh->vertices + 3 * i, moved);
        memcpy(mesh->vertices + 3 * i, moved, sizeof moved);
    }
    for (size_t i = 0; det < 0.0 && i < mesh->triangle_count; i++) {
        uint32_t kept = mesh->triangles[3 * i + 1];
        mesh->triangles[3 * i + 1] = mesh->triangles[3 * i + 2];
        mesh->triangles[3 * i + 2] = kept;
    }
    return SF_OK;
}

sf_status sf_mesh_bounds(sf_mesh_view mesh, double minimum_mm[3], double maximum_mm[3])
{
    SF_TRY(sf_mesh_validate(mesh, NULL));
    if (mesh.triangle_count == 0 || minimum_mm == NULL || maximum_mm == NULL) {
        return SF_ERR_ARGUMENT;
    }
    const double *first = mesh.vertices + 3 * (size_t)mesh.triangles[0];
    for (int axis = 0; axis < 3; axis++) {
        minimum_mm[axis] = maximum_mm[axis] = first[axis];
    }
    for (size_t i = 1; i < 3 * mesh.triangle_count; i++) {
        const double *p = mesh.vertices + 3 * (size_t)mesh.triangles[i];
        for (int axis = 0; axis < 3; axis++) {
            minimum_mm[axis] = p[axis] < minimum_mm[axis] ? p[axis] : minimum_mm[axis];
            maximum_mm[axis] = p[axis] > maximum_mm[axis] ? p[axis] : maximum_mm[axis];
        }
    }
    return SF_OK;
}

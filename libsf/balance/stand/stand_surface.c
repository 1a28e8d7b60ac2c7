// SPDX-License-Identifier: MIT
// The surface of a shape as bending wants it.
//
// Files repeat vertices, one copy for each triangle, and order them as they like. What is bent has
// each position once, because neighbours must be known, and in an order in which neighbours lie
// near each other in memory. Triangles follow their first corner. The way back is one number a
// vertex: the mesh that was handed in keeps its triangles and its vertices, and only their places
// change. Vertices that no triangle uses are no part of it: files hold some, and they weigh
// nothing, stand on nothing and are not to be bent.

#include "balance/stand/stand_surface.h"

#include "base/memory.h"
#include "base/status.h"
#include "mesh/mesh.h"
#include "mesh/morton.h"

#include <string.h>

// Number the points anew, those that triangles use alone. `number` has a place for each.
static void leave_out_unused(sf_mesh_view mesh, uint32_t *number, sfi_stand_surface *made)
{
    uint32_t used = 0;
    for (size_t i = 0; i < made->point_count; i++) {
        number[i] = SFI_NO_POINT;
    }
    for (size_t i = 0; i < 3 * mesh.triangle_count; i++) {
        number[made->point_of[mesh.triangles[i]]] = 0;
    }
    for (size_t i = 0; i < made->point_count; i++) {
        number[i] = number[i] == 0 ? used++ : SFI_NO_POINT;
    }
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        made->point_of[v] = number[made->point_of[v]];
    }
    made->point_count = used;
}

// Find the points.
static sf_status number_points(sf_mesh_view mesh, const sf_allocator *allocator,
                               sfi_stand_surface *made)
{
    SF_TRY(sfi_mesh_positions(mesh, allocator, made->point_of, &made->point_count));
    size_t count = made->point_count;
    uint32_t *number = sfi_alloc_array(allocator, count, sizeof *number);
    if (number == NULL) {
        return SF_ERR_MEMORY;
    }
    leave_out_unused(mesh, number, made);
    sfi_free_array(allocator, number, count, sizeof *number);
    return SF_OK;
}

// The places of the points, each that of its first vertex.
static void collect(sf_mesh_view mesh, const uint32_t *point_of, double *places)
{
    for (size_t v = mesh.vertex_count; v-- > 0;) {
        if (point_of[v] != SFI_NO_POINT) {
            memcpy(places + 3 * (size_t)point_of[v], mesh.vertices + 3 * v, 3 * sizeof *places);
        }
    }
}

// Points in the curve's order, and the numbers of vertices changed to match.
static sf_status arrange(sf_mesh_view mesh, const sf_allocator *allocator, double *places,
                         sfi_stand_surface *made)
{
    size_t count = made->point_count;
    uint32_t *order = sfi_alloc_array(allocator, count, sizeof *order);
    uint32_t *rank = sfi_alloc_array(allocator, count, sizeof *rank);
    sf_status status = order != NULL && rank != NULL ? SF_OK : SF_ERR_MEMORY;
    if (status == SF_OK) {
        collect(mesh, made->point_of, places);
        status = sfi_morton_order(places, count, allocator, order);
    }
    for (size_t i = 0; status == SF_OK && i < count; i++) {
        rank[order[i]] = (uint32_t)i;
        memcpy(made->points + 3 * i, places + 3 * (size_t)order[i], 3 * sizeof *places);
    }
    for (size_t v = 0; status == SF_OK && v < made->vertex_count; v++) {
        if (made->point_of[v] != SFI_NO_POINT) {
            made->point_of[v] = rank[made->point_of[v]];
        }
    }
    sfi_free_array(allocator, order, count, sizeof *order);
    sfi_free_array(allocator, rank, count, sizeof *rank);
    return status;
}

// The triangles that have three corners, in the order of their first one; `start` has point_count +
// 1 places.
static void sort_triangles(sf_mesh_view mesh, size_t *start, sfi_stand_surface *made)
{
    memset(start, 0, (made->point_count + 1) * sizeof *start);
    for (int write = 0; write < 2; write++) {
        for (size_t t = 0; t < mesh.triangle_count; t++) {
            uint32_t p[3];
            for (size_t i = 0; i < 3; i++) {
                p[i] = made->point_of[mesh.triangles[3 * t + i]];
            }
            if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) {
                continue;
            }
            if (write) {
                memcpy(made->triangles + 3 * start[p[0]]++, p, sizeof p);
                made->triangle_count++;
            } else {
                start[p[0] + 1]++;
            }
        }
        for (size_t i = 0; !write && i < made->point_count; i++) {
            start[i + 1] += start[i];
        }
    }
}

static sf_status fill(sf_mesh_view mesh, const sf_allocator *allocator, sfi_stand_surface *made)
{
    SF_TRY(number_points(mesh, allocator, made));
    double *places = sfi_alloc_array(allocator, made->point_count, 3 * sizeof *places);
    size_t *start = sfi_alloc_array(allocator, made->point_count + 1, sizeof *start);
    made->point_room = made->point_count;
    made->points = sfi_alloc_array(allocator, made->point_room, 3 * sizeof *made->points);
    sf_status status = SF_ERR_MEMORY;
    if (places != NULL && start != NULL && made->points != NULL) {
        status = arrange(mesh, allocator, places, made);
    }
    if (status == SF_OK) {
        sort_triangles(mesh, start, made);
        status = made->triangle_count > 0
                     ? sfi_incidence_make(sfi_stand_surface_view(made, made->points), allocator,
                                          &made->incidence)
                     : SF_ERR_ARGUMENT;
    }
    sfi_free_array(allocator, places, made->point_count, 3 * sizeof *places);
    sfi_free_array(allocator, start, made->point_count + 1, sizeof *start);
    return status;
}

sf_status sfi_stand_surface_make(sf_mesh_view mesh, const sf_allocator *allocator,
                                 sfi_stand_surface *surface)
{
    sfi_stand_surface made;
    memset(&made, 0, sizeof made);
    made.vertex_count = mesh.vertex_count;
    made.triangle_room = mesh.triangle_count;
    made.point_of = sfi_alloc_array(allocator, made.vertex_count, sizeof *made.point_of);
    made.triangles = sfi_alloc_array(allocator, made.triangle_room, 3 * sizeof *made.triangles);
    sf_status status = SF_ERR_MEMORY;
    if (made.point_of != NULL && made.triangles != NULL) {
        status = fill(mesh, allocator, &made);
    }
    if (status != SF_OK) {
        sfi_stand_surface_free(allocator, &made);
        return status;
    }
    *surface = made;
    return SF_OK;
}

void sfi_stand_surface_free(const sf_allocator *allocator, sfi_stand_surface *surface)
{
    sfi_incidence_free(allocator, &surface->incidence);
    sfi_free_array(allocator, surface->points, surface->point_room, 3 * sizeof *surface->points);
    sfi_free_array(allocator, surface->triangles, surface->triangle_room,
                   3 * sizeof *surface->triangles);
    sfi_free_array(allocator, surface->point_of, surface->vertex_count, sizeof *surface->point_of);
    memset(surface, 0, sizeof *surface);
}

void sfi_stand_surface_spread(const sfi_stand_surface *surface, const double *points,
                              double *vertices)
{
    for (size_t v = 0; v < surface->vertex_count; v++) {
        uint32_t point = surface->point_of[v];
        if (point != SFI_NO_POINT) {
            memcpy(vertices + 3 * v, points + 3 * (size_t)point, 3 * sizeof *vertices);
        }
    }
}

sf_mesh_view sfi_stand_surface_view(const sfi_stand_surface *surface, const double *points)
{
    sf_mesh_view view = {points, surface->point_count, surface->triangles, surface->triangle_count};
    return view;
}

// SPDX-License-Identifier: MIT
// Triangle meshes: topology, mass, voxels out of a mesh and a mesh out of voxels.
//
// Vertices are three doubles in mm, triangles three vertex indices, counter-clockwise seen from
// outside. A mesh stays in the frame it came in.

#ifndef SF_MESH_H
#define SF_MESH_H

#include <sf/voxel.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Meshes
// ---------------------------------------------------------------------------------------------

/** A view of triangles in somebody's arrays. */
typedef struct sf_mesh_view {
    const double *vertices;    /**< x, y, z of each vertex, mm */
    size_t vertex_count;       /**< at most UINT32_MAX */
    const uint32_t *triangles; /**< three indices of each triangle, each < vertex_count */
    size_t triangle_count;
} sf_mesh_view;

/** A mesh that owns its arrays and can be appended to. */
typedef struct sf_mesh sf_mesh;

SF_API SF_CHECKED sf_status sf_mesh_create(const sf_allocator *allocator, sf_mesh **mesh);
SF_API void sf_mesh_destroy(sf_mesh *mesh);
/** View of the mesh; valid until the mesh is changed or destroyed. */
SF_API sf_mesh_view sf_mesh_get_view(const sf_mesh *mesh);
/** Append vertices (x, y, z each). Finite or refused. */
SF_API SF_CHECKED sf_status sf_mesh_add_vertices(sf_mesh *mesh, const double *xyz, size_t count);
/** Append triangles; every index must name a vertex that exists. */
SF_API SF_CHECKED sf_status sf_mesh_add_triangles(sf_mesh *mesh, const uint32_t *indices,
                                                  size_t count);
/** Check a view: indices in range, coordinates finite. */
SF_API SF_CHECKED sf_status sf_mesh_validate(sf_mesh_view mesh, sf_fault *fault);

/** An affine map: row-major 3x3 matrix, then a shift. p -> m p + shift. */
typedef struct sf_transform {
    double matrix[9];
    double shift_mm[3];
} sf_transform;

/** Apply an affine map to every vertex; a map that mirrors flips every triangle. */
SF_API SF_CHECKED sf_status sf_mesh_transform(sf_mesh *mesh, const sf_transform *transform);

/** Copy of a mesh in which vertices of equal position are one (numbered by first appearance). */
SF_API SF_CHECKED sf_status sf_mesh_merge(sf_mesh_view mesh, const sf_allocator *allocator,
                                          sf_mesh **merged);

/** Smallest box around the vertices used by triangles; minimum then maximum. */
SF_API SF_CHECKED sf_status sf_mesh_bounds(sf_mesh_view mesh, double minimum_mm[3],
                                           double maximum_mm[3]);

// ---------------------------------------------------------------------------------------------
// Topology and mass
// ---------------------------------------------------------------------------------------------

/** How the triangles of a mesh hang together, after vertices of equal position are merged. */
typedef struct sf_topology {
    size_t vertex_count;         /**< distinct positions used by triangles */
    size_t boundary_edges;       /**< edges with one triangle */
    size_t nonmanifold_edges;    /**< edges with more than two triangles */
    size_t misoriented_edges;    /**< edges with two triangles that run it the same way */
    size_t degenerate_triangles; /**< triangles with two equal corners */
    size_t shells;               /**< sets of triangles connected over edges */
    size_t flipped_shells;       /**< closed, consistently oriented shells with negative volume */
    int closed;                  /**< no boundary edges, and an even number of triangles at each */
    int oriented;                /**< every edge is run as often one way as the other */
    int flipped;                 /**< closed, oriented, and the signed volume is negative */
} sf_topology;

SF_API SF_CHECKED sf_status sf_mesh_analyze(sf_mesh_view mesh, const sf_allocator *allocator,
                                            sf_topology *topology);

/** Integrals over a closed mesh of density 1. Inertia about the centre of mass: xx yy zz xy xz yz.
 */
typedef struct sf_mass {
    double volume_mm3;
    double area_mm2;
    double com_mm[3];
    double inertia_mm5[6]; /**< inertia tensor entries Ixx, Iyy, Izz, Ixy, Ixz, Iyz (products
                              negated) */
} sf_mass;

SF_API SF_CHECKED sf_status sf_mesh_measure(sf_mesh_view mesh, sf_mass *mass);

// ---------------------------------------------------------------------------------------------
// Voxels out of a mesh
// ---------------------------------------------------------------------------------------------

/** How inside is decided. */
typedef enum sf_fill {
    SF_FILL_AUTO = 0,    /**< parity where the mesh is closed and simple, winding elsewhere */
    SF_FILL_PARITY = 1,  /**< inside after an odd number of crossings */
    SF_FILL_WINDING = 2, /**< inside where the winding number is at least one half */
    SF_FILL_SURFACE = 3  /**< every voxel that the surface touches, and nothing else */
} sf_fill;

/** How a mesh becomes voxels. Fill with sf_voxelize_options_default(). */
typedef struct sf_voxelize_options {
    size_t struct_size;
    sf_fill fill;
} sf_voxelize_options;

SF_API sf_voxelize_options sf_voxelize_options_default(void);

/** What the voxeliser did. */
typedef struct sf_voxelize_report {
    sf_fill fill;          /**< the way that was taken */
    size_t boundary_edges; /**< directed edges without an opposite */
    int flipped;           /**< 1 when the mesh was read inside out and turned */
    uint64_t odd_rows;     /**< parity: rows with an odd number of crossings (leaks) */
    uint64_t solid_voxels;
} sf_voxelize_report;

/** A voxeliser: slices of a mesh one at a time, with memory for one slab. */
typedef struct sf_voxelizer sf_voxelizer;

/** Prepare. The mesh's arrays must outlive the voxeliser. */
SF_API SF_CHECKED sf_status sf_voxelizer_create(sf_mesh_view mesh, const sf_lattice *lattice,
                                                const sf_voxelize_options *options,
                                                const sf_allocator *allocator,
                                                sf_voxelizer **voxelizer, sf_fault *fault);
SF_API void sf_voxelizer_destroy(sf_voxelizer *voxelizer);
/** Fill slice k of the lattice (any order; ascending is fastest). */
SF_API SF_CHECKED sf_status sf_voxelizer_slice(sf_voxelizer *voxelizer, uint32_t k, sf_slice slice);
/** What was found so far. */
SF_API SF_CHECKED sf_status sf_voxelizer_report(const sf_voxelizer *voxelizer,
                                                sf_voxelize_report *report);

/** Fill a whole grid from a mesh. On failure the grid is as it was. */
SF_API SF_CHECKED sf_status sf_grid_voxelize(sf_grid *grid, sf_mesh_view mesh,
                                             const sf_voxelize_options *options,
                                             const sf_allocator *allocator, sf_task *task,
                                             sf_voxelize_report *report);

// ---------------------------------------------------------------------------------------------
// A mesh out of voxels
// ---------------------------------------------------------------------------------------------

/** How the surface of a grid is made. Fill with sf_surface_options_default(). */
typedef struct sf_surface_options {
    size_t struct_size;
    int smooth_passes; /**< 0 (default): the exact voxel faces; else passes of smoothing */
} sf_surface_options;

SF_API sf_surface_options sf_surface_options_default(void);

/**
 * The boundary of the solid voxels as a closed, oriented 2-manifold in the lattice's frame.
 *
 * It stays 2-manifold after vertices of equal position are merged, and voxelising it on the same
 * lattice gives the same grid back (without smoothing).
 */
SF_API SF_CHECKED sf_status sf_grid_surface(const sf_grid *grid, const sf_surface_options *options,
                                            const sf_allocator *allocator, sf_task *task,
                                            sf_mesh **mesh);

#ifdef __cplusplus
}
#endif

#endif

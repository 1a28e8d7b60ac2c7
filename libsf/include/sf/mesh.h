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
    size_t triangle_count;     /**< number of triangles */
} sf_mesh_view;

/** A mesh that owns its arrays and can be appended to. */
typedef struct sf_mesh sf_mesh;

/**
 * Make an empty mesh.
 *
 * @param allocator  where its memory comes from, now and as it grows; NULL for the C library's
 * @param mesh       receives the mesh
 * @return SF_OK; SF_ERR_ARGUMENT: `mesh` is NULL; SF_ERR_MEMORY.
 * @cost constant.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_create(const sf_allocator *allocator, sf_mesh **mesh);

/**
 * Free a mesh; NULL does nothing.
 *
 * @param mesh  the mesh, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this mesh.
 * @since 0.1
 */
SF_API void sf_mesh_destroy(sf_mesh *mesh);

/**
 * View of a mesh, valid until the mesh is changed or destroyed.
 *
 * @param mesh  the mesh; NULL gives a view of nothing
 * @return the view; its coordinates are finite and its indices name vertices, whatever happened.
 * @cost constant.   @threads any, while nobody changes the mesh.
 * @since 0.1
 */
SF_API sf_mesh_view sf_mesh_get_view(const sf_mesh *mesh);

/**
 * Append vertices.
 *
 * @param mesh   the mesh
 * @param xyz    3 * count coordinates in mm, vertex after vertex; not in the mesh's own arrays; may
 *               be NULL where count is 0
 * @param count  number of vertices
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a coordinate that is not finite; SF_ERR_OVERFLOW:
 * more than UINT32_MAX vertices in all; SF_ERR_MEMORY.
 * @cost O(count) when many calls are taken together.   @threads one per mesh.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_add_vertices(sf_mesh *mesh, const double *xyz, size_t count);

/**
 * Append triangles, counter-clockwise seen from outside.
 *
 * @param mesh     the mesh
 * @param indices  3 * count vertex numbers; not in the mesh's own arrays; may be NULL where count
 *                 is 0. Triangles with two equal corners are taken.
 * @param count    number of triangles
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, an index that names no vertex yet;
 * SF_ERR_OVERFLOW: more triangles than the machine can address; SF_ERR_MEMORY.
 * @cost O(count) when many calls are taken together.   @threads one per mesh.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_add_triangles(sf_mesh *mesh, const uint32_t *indices,
                                                  size_t count);

/**
 * Check a view: arrays where there are counts, indices in range, coordinates finite.
 *
 * @param mesh   the view
 * @param fault  NULL, or receives a sentence that names the first vertex or triangle at fault
 * @return SF_OK; SF_ERR_ARGUMENT: it is no mesh; SF_ERR_OVERFLOW: more than UINT32_MAX vertices, or
 * more vertices or triangles than the machine can address.
 * @cost linear.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_validate(sf_mesh_view mesh, sf_fault *fault);

/** An affine map: p -> matrix p + shift. */
typedef struct sf_transform {
    double matrix[9];   /**< row after row */
    double shift_mm[3]; /**< added last */
} sf_transform;

/**
 * Apply an affine map to every vertex; a map that mirrors turns every triangle around.
 *
 * @param mesh       the mesh, changed in place
 * @param transform  the map; its determinant must be neither 0 nor infinite
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a map that flattens or is not finite;
 * SF_ERR_OVERFLOW: a vertex that would not be finite any more.
 * @cost two passes over the vertices, one over the triangles of a mirrored mesh.
 * @threads one per mesh.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_transform(sf_mesh *mesh, const sf_transform *transform);

/**
 * Copy of a mesh in which vertices of equal position are one.
 *
 * Positions are equal when they are the same once rounded to a grain: the power of two that is
 * 2^-40 to 2^-39 of the largest coordinate. The first vertex at a position stands for all, and
 * vertices are numbered by first appearance. Triangles stay, in their order, also those that lose a
 * corner.
 *
 * @param mesh       the mesh to copy
 * @param allocator  for the copy and for scratch; NULL for the C library's
 * @param merged     receives the copy
 * @return SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_OVERFLOW:
 * more vertices than the machine can address twice; SF_ERR_MEMORY.
 * @cost linear, but for collisions in a hash table.   @threads any; one at a time for each
 * allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_merge(sf_mesh_view mesh, const sf_allocator *allocator,
                                          sf_mesh **merged);

/**
 * Smallest box around the vertices that triangles use.
 *
 * @param mesh        the mesh
 * @param minimum_mm  receives the lower corner
 * @param maximum_mm  receives the upper corner
 * @return SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer, a mesh without
 * triangles.
 * @cost linear.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_bounds(sf_mesh_view mesh, double minimum_mm[3],
                                           double maximum_mm[3]);

// ---------------------------------------------------------------------------------------------
// Topology and mass
// ---------------------------------------------------------------------------------------------

/**
 * How the triangles of a mesh hang together, after vertices of equal position are merged.
 *
 * Where two solids touch along an edge, four triangles meet at it. Such an edge is nonmanifold, but
 * no hole: the mesh is closed. It joins all four: solids that touch so are one shell, and solids
 * that touch only in a point, or run through each other, are two.
 */
typedef struct sf_topology {
    size_t vertex_count;         /**< distinct positions used by triangles */
    size_t boundary_edges;       /**< edges with one triangle */
    size_t nonmanifold_edges;    /**< edges with more than two triangles */
    size_t misoriented_edges;    /**< edges with two triangles that run it the same way */
    size_t degenerate_triangles; /**< triangles with two equal corners */
    size_t shells;               /**< sets of triangles connected over edges, of any number of
                                    triangles each */
    size_t flipped_shells;       /**< closed, consistently oriented shells with negative volume */
    int closed;                  /**< no boundary edges, and an even number of triangles at each */
    int oriented;                /**< every edge is run as often one way as the other */
    int flipped;                 /**< closed, oriented, and the signed volume is negative */
} sf_topology;

/**
 * How the triangles of a mesh hang together: holes, edges of too many triangles, shells, sense.
 *
 * Vertices of equal position are one point, in the sense of sf_mesh_merge(); the mesh itself need
 * not be merged. Triangles with fewer than three points are counted, and take no further part.
 *
 * @param mesh       the mesh; its triangles are at most INT32_MAX
 * @param allocator  for scratch, about 125 bytes a triangle; NULL for the C library's
 * @param topology   receives the counts
 * @return SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer, a mesh without
 * triangles; SF_ERR_OVERFLOW: too many triangles; SF_ERR_MEMORY.
 * @cost nearly linear in vertices and triangles.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_analyze(sf_mesh_view mesh, const sf_allocator *allocator,
                                            sf_topology *topology);

/** Integrals over the solid that a closed mesh bounds, density 1. */
typedef struct sf_mass {
    double volume_mm3;     /**< negative where the mesh is inside out */
    double area_mm2;       /**< of all triangles */
    double com_mm[3];      /**< centre of mass; the middle of the bounds where there is no volume */
    double inertia_mm5[6]; /**< about the centre of mass: Ixx, Iyy, Izz, Ixy, Ixz, Iyz, the last
                                three with the sign that they have in the tensor */
} sf_mass;

/**
 * Volume, area, centre of mass and inertia of the solid that a mesh bounds.
 *
 * Exact but for rounding where the mesh is closed and oriented. Elsewhere only the area means
 * anything: what is open has no volume, and the figures depend on where the mesh lies.
 *
 * @param mesh  the mesh
 * @param mass  receives the integrals
 * @return SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer, a mesh without
 * triangles.
 * @cost two passes over the triangles, in their order: the same bytes on every machine.
 * @threads any.
 * @source R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing Shapes
 * for 3D Fabrication", SIGGRAPH 2013, equation 3, corrected; D. Eberly, "Polyhedral Mass Properties
 * (Revisited)", 2002.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_measure(sf_mesh_view mesh, sf_mass *mass);

// ---------------------------------------------------------------------------------------------
// Two halves
// ---------------------------------------------------------------------------------------------

/**
 * Cut a closed mesh by a plane across an axis into two closed halves.
 *
 * What the plane opens is closed by caps that lie exactly in it: with holes where it meets cavities
 * (shells turned inwards), with islands in them, and with the vertices of the contours.
 * Both caps have the same contours, but for triangles of the mesh within the plane, which belong to
 * neither half; so the volumes of the halves add up to the whole's. Vertices of equal position are
 * one, in the sense of sf_mesh_merge(), and one that is as near to the plane as that lies on it.
 * Each half consists of its vertices, in the order of the mesh's, then those on cut edges; its
 * triangles, in that order, too; and its cap.
 *
 * Where every edge of the mesh has two triangles, every edge of the halves has; where an edge of
 * the mesh only touches the plane and a cap would have it, too, the cap gets a vertex in its
 * middle. Where shells run through each other in the plane, or one through itself, the halves are
 * closed and enclose what they should, but triangles of a cap lie over each other, and may share an
 * edge.
 *
 * @param mesh       closed and oriented, of any number of shells; its triangles at most INT32_MAX
 * @param axis       0, 1 or 2: across x, y or z
 * @param at_mm      where the plane crosses that axis
 * @param allocator  for the halves, and for scratch, about 150 bytes a triangle; NULL for the C
 *                   library's
 * @param low        receives the half with the lower coordinates along the axis
 * @param high       receives the other half; not the same pointer
 * @param fault      NULL, or receives a sentence on failure, such as where the mesh is
 * @return SF_OK; what sf_mesh_analyze() says; SF_ERR_ARGUMENT: a NULL pointer, an axis that there
 * is not, a place that is not finite; SF_ERR_UNSUPPORTED: a mesh that is open, or not oriented
 * alike everywhere; SF_ERR_INFEASIBLE: the plane leaves nothing on one side of it; SF_ERR_OVERFLOW:
 * a coordinate beyond 1e12 mm, more vertices than can be numbered; SF_ERR_MEMORY.
 * @cost linear in vertices and triangles, 0.7 s for 3 million; n log n in the contours, or n n, up
 * to a few seconds, where they cross.
 * @threads any; one at a time for each allocator.
 * @source M. R. Garey, D. S. Johnson, F. P. Preparata, R. E. Tarjan, "Triangulating a simple
 * polygon", 1978; D. Eberly, "Triangulation by ear clipping", 2002, where contours cross.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_cut(sf_mesh_view mesh, int axis, double at_mm,
                                        const sf_allocator *allocator, sf_mesh **low,
                                        sf_mesh **high, sf_fault *fault);

// ---------------------------------------------------------------------------------------------
// Voxels out of a mesh
// ---------------------------------------------------------------------------------------------

/** How inside is decided. A voxel is solid or not at its centre, but for SF_FILL_SURFACE. */
typedef enum sf_fill {
    SF_FILL_AUTO = 0,    /**< winding, after turning what looks the wrong way */
    SF_FILL_PARITY = 1,  /**< inside after an odd number of crossings */
    SF_FILL_WINDING = 2, /**< inside where the winding number is at least one half */
    SF_FILL_SURFACE = 3  /**< every voxel that the surface touches, and nothing else */
} sf_fill;

/** How a mesh becomes voxels. Fill with sf_voxelize_options_default(). */
typedef struct sf_voxelize_options {
    size_t struct_size; /**< sizeof(sf_voxelize_options), set by the default */
    sf_fill fill;       /**< SF_FILL_AUTO by default */
} sf_voxelize_options;

/**
 * Options of the voxeliser, each at its default.
 *
 * @return the options, by value: SF_FILL_AUTO.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_voxelize_options sf_voxelize_options_default(void);

/** What the voxeliser did. */
typedef struct sf_voxelize_report {
    sf_fill fill;          /**< the way that was taken; SF_FILL_WINDING for SF_FILL_AUTO */
    size_t boundary_edges; /**< directed edges without an opposite, once neighbours agree; 0 where
                              parity or surface was asked for */
    int flipped;           /**< 1 when the mesh was read inside out and turned as a whole */
    uint64_t odd_rows;     /**< rows whose crossings do not add up to nothing (leaks): parity only,
                              because winding closes what is open */
    uint64_t solid_voxels; /**< voxels that were set */
} sf_voxelize_report;

/** A voxeliser: slices of a mesh one at a time, with memory for one slab. */
typedef struct sf_voxelizer sf_voxelizer;

/**
 * Prepare to voxelise a mesh on a lattice, slice by slice.
 *
 * Every corner is rounded once to 1/256 of a voxel (1/256 of the mean layer height along z), and
 * what follows is exact on the rounded mesh: a voxel is solid where the winding number around its
 * centre is at least one half, and a centre that lies on the surface counts as lying just beyond it
 * in x, then in y, then in z. So two closed meshes that share a face give disjoint voxels whose
 * union is that of both, and no closed mesh leaks. Corners further than two million voxels from the
 * lattice's origin are refused; what leaves the lattice is cut off.
 *
 * SF_FILL_AUTO takes any mesh: where it is not closed, equal corners are merged, neighbours that
 * disagree are turned (as few as possible in each patch), and holes are spanned by the surface on
 * which the generalised winding number is one half. Around holes that number comes from bounds and,
 * in boxes of 8 voxels, from interpolation with a measured margin; away from a half it is never in
 * doubt. Last, a mesh that encloses a negative volume is turned as a whole. SF_FILL_WINDING takes
 * all triangles as they look, SF_FILL_PARITY counts crossings and reports rows that leak.
 *
 * SF_FILL_SURFACE sets each voxel whose closed box the rounded surface touches.
 *
 * @param mesh        vertices in mm; its arrays must outlive the voxeliser; no triangles is fine
 * @param lattice     where voxels lie; copied as far as needed; at most 2^20 layers
 * @param options     NULL for the default
 * @param allocator   NULL for the C library's; its `user` must outlive the voxeliser
 * @param voxelizer   receives the new voxeliser
 * @param fault       NULL, or receives a sentence on failure
 * @return SF_OK; SF_ERR_ARGUMENT when a pointer is missing, an index names no vertex, or lattice or
 * options are out of range; SF_ERR_UNSUPPORTED when a corner is not finite or too far away, or
 * there are too many layers; SF_ERR_OVERFLOW for more than 2^32 - 1 vertices or triangles (2^30
 * where the mesh is not closed), and for heights of layers that leave the same two million voxels;
 * SF_ERR_MEMORY.
 * @cost linear in vertices and triangles; more memory (about 100 bytes a triangle, for a while)
 * where the mesh is not closed.
 * @threads any; one at a time for each allocator.
 * @source J. Pineda, "A parallel algorithm for polygon rasterization", 1988; A. Jacobson, L. Kavan,
 * O. Sorkine-Hornung, "Robust inside-outside segmentation using generalized winding numbers", 2013;
 * G. Barill and others, "Fast winding numbers for soups and clouds", 2018; M. Schwarz, H.-P.
 * Seidel, "Fast parallel surface and solid voxelization on GPUs", 2010.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_voxelizer_create(sf_mesh_view mesh, const sf_lattice *lattice,
                                                const sf_voxelize_options *options,
                                                const sf_allocator *allocator,
                                                sf_voxelizer **voxelizer, sf_fault *fault);

/**
 * Free a voxeliser; NULL does nothing.
 *
 * @param voxelizer  the voxeliser, freed; NULL does nothing
 * @cost constant.   @threads any; not while the voxeliser is in use.
 * @since 0.1
 */
SF_API void sf_voxelizer_destroy(sf_voxelizer *voxelizer);

/**
 * Fill slice k of the lattice: the same bytes as that slice of sf_grid_voxelize().
 *
 * Slices can be asked for in any order and more than once; each asking counts in the report.
 *
 * @param voxelizer  the voxeliser; only its counters change
 * @param k          layer, below the lattice's nz
 * @param slice      nx by ny voxels; what it held is lost; bits past the width become zero
 * @return SF_OK; SF_ERR_ARGUMENT when a pointer is missing, k is out of range or the stride too
 * small; SF_ERR_SHAPE when the slice is not nx by ny.
 * @cost the crossings of the slab of layers that k lies in, and one pass over the slice; no memory.
 * @threads one at a time for each voxeliser.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_voxelizer_slice(sf_voxelizer *voxelizer, uint32_t k, sf_slice slice);

/**
 * What was found so far: sums over all slices that were filled.
 *
 * @param voxelizer  the voxeliser
 * @param report     receives the report
 * @return SF_OK; SF_ERR_ARGUMENT when a pointer is NULL.
 * @cost constant.   @threads one at a time for each voxeliser.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_voxelizer_report(const sf_voxelizer *voxelizer,
                                                sf_voxelize_report *report);

/**
 * Fill a whole grid from a mesh; on failure the grid is as it was.
 *
 * The rules are those of sf_voxelizer_create(). A cancel is heeded after every slab of layers; so
 * that nothing changes then, a grid that holds solid voxels is filled aside first when a task is
 * given, which takes its memory a second time.
 *
 * @param grid       what it held is lost
 * @param mesh       vertices in mm; no triangles is fine
 * @param options    NULL for the default
 * @param allocator  for scratch; NULL for the C library's
 * @param task       NULL, or progress, cancel and threads; the result is the same bytes with any
 * @param report     NULL, or receives the report on success
 * @return SF_OK; SF_ERR_ARGUMENT, SF_ERR_UNSUPPORTED, SF_ERR_OVERFLOW, SF_ERR_MEMORY as
 * sf_voxelizer_create(); SF_ERR_CANCELLED.
 * @cost linear in triangles, crossings, and words of the grid; around holes, also in the voxels
 * near the surface that spans them. 82,000 triangles on 512^3: 14 ms on one core.
 * @threads any, on distinct grids; the task's hook may run up to 16 pieces at once; one at a time
 * for each allocator.
 * @source as sf_voxelizer_create().
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_voxelize(sf_grid *grid, sf_mesh_view mesh,
                                             const sf_voxelize_options *options,
                                             const sf_allocator *allocator, sf_task *task,
                                             sf_voxelize_report *report);

// ---------------------------------------------------------------------------------------------
// A mesh out of voxels
// ---------------------------------------------------------------------------------------------

/** Most passes of smoothing; the surface has long settled by then. */
#define SF_SMOOTH_PASSES_MAX 1000

/** How the surface of a grid is made. Fill with sf_surface_options_default(). */
typedef struct sf_surface_options {
    size_t struct_size; /**< sizeof(sf_surface_options), set by the default */
    int smooth_passes;  /**< 0 (default): the exact voxel faces; else passes of smoothing,
                           at most SF_SMOOTH_PASSES_MAX */
} sf_surface_options;

/**
 * Options of a surface, each at its default.
 *
 * @return the options, by value: no smoothing.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_surface_options sf_surface_options_default(void);

/**
 * The boundary of the solid voxels as a closed, oriented 2-manifold in the lattice's frame.
 *
 * It stays 2-manifold after vertices of equal position are merged: where voxels touch only along an
 * edge or in a corner, the vertices there are moved by a sixteenth of a voxel into the solid. So
 * voxelising it on the same lattice gives the same grid back. Every voxel face is two triangles, or
 * up to six beside such an edge; a grid without solid voxels gives a mesh without triangles.
 *
 * Smoothing takes steps out of the surface without shrinking it, and keeps every vertex within half
 * a voxel of its place along each axis and the mesh closed. Voxels of what is smoothed are others,
 * and may need support that those of the grid do not.
 *
 * @param grid       the voxels, only read; what lies outside is empty
 * @param options    NULL for the default
 * @param allocator  for the mesh and for scratch, 10 bytes for each column of voxels and, with
 *                   smoothing, 52 for each vertex; NULL for the C library's
 * @param task       NULL, or progress and cancel, which is heeded at every slice and every
 *                   smoothing pass
 * @param mesh       receives the mesh
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, a number
 * of passes outside its range; SF_ERR_OVERFLOW: more than UINT32_MAX vertices, or more triangles
 * than the machine can address; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost two passes over the grid and the boundary; two over the triangles for each smoothing pass.
 * @threads any; the grid is only read; one at a time for each allocator.
 * @source for smoothing G. Taubin, "A Signal Processing Approach to Fair Surface Design", SIGGRAPH
 * 1995, section 2.2; S. F. F. Gibson, "Constrained Elastic Surface Nets", MICCAI 1998.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_surface(const sf_grid *grid, const sf_surface_options *options,
                                            const sf_allocator *allocator, sf_task *task,
                                            sf_mesh **mesh);

#ifdef __cplusplus
}
#endif

#endif

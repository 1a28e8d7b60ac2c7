// SPDX-License-Identifier: MIT
// The words of the headers, for comments. Written by bindings/rust/generate.py.

macro_rules! words {
    (sf_check_options.run_capacity) => {
        "Runs of lost matter kept of each layer, to link the next one to its findings. 0: none, each finding answers for its own region only; but in [`sf_grid_check()`](crate::sys::sf_grid_check) as many as it takes."
    };
    (sf_checker) => {
        "A streaming check that keeps two layers, and two more while a layer is pushed.\n\nA voxel that nothing carries counts once; what rests on it is then judged as if it were carried, under slack with no reach to spare.\n\nLives in memory of the caller's, takes none of its own, and computes with integers only, so that a printer's controller can run it while it reads a job. It needs no end: the report may be asked for after any layer, and the memory may be reused when it is no longer wanted."
    };
    (sf_checker_push) => {
        "Push the next layer as bits.\n\nFindings of the layer are in the array when the call returns, in the order in which their regions end: by last row, then from left to right in that row. Volumes and boxes of earlier findings may have grown.\n\n- cost: a step of the rule, two where matter was lost below (under slack, as long as it tells), and in lost matter its voxels times the rows of the element; whatever the size, up to 9 KiB of stack, 6 on a processor of 32 bits.\n- threads: one per checker.\n- source: T. Reiner, S. Lefebvre, \"Interactive Modeling of Support-free Shapes for Fabrication\", Eurographics 2016, section 3.2.\n- in C: [`sf_checker_push()`](crate::sys::sf_checker_push)"
    };
    (sf_checker_push_grey: row_bytes, threshold) => {
        "Push the next layer as 8-bit rows: solid where the value is at least `threshold`.\n\n- `row_bytes`: bytes from one row to the next, at least the width\n- `threshold`: 1 to 255; 0 makes everything solid\n- cost: as [`sf_checker_push()`](crate::sys::sf_checker_push), and two passes over the pixels.\n- threads: one per checker.\n- in C: [`sf_checker_push_grey()`](crate::sys::sf_checker_push_grey)"
    };
    (sf_checker_report) => {
        "Counts so far.\n\n- cost: constant.\n- threads: one per checker.\n- in C: [`sf_checker_report()`](crate::sys::sf_checker_report)"
    };
    (sf_grid) => {
        "A stack of slices that owns its memory."
    };
    (sf_grid_bounds) => {
        "Smallest box around the solid voxels.\n\n- cost: one pass at most.\n- threads: any.\n- in C: [`sf_grid_bounds()`](crate::sys::sf_grid_bounds)"
    };
    (sf_grid_check) => {
        "Check a whole grid: the streaming check, with every slice pushed from the bottom up.\n\nWidth, height and first layer of the options are the grid's, whatever stands there. Where run_capacity is 0 it is chosen so that all runs fit, so that volumes and causes are exact for all findings in the array. After a failing call the findings array is as it was.\n\n- cost: that of the pushes; more passes where a layer loses more than 262144 runs.\n- threads: any; the grid is only read.\n- in C: [`sf_grid_check()`](crate::sys::sf_grid_check)"
    };
    (sf_grid_clone) => {
        "Make a copy of a grid.\n\n- cost: one pass.\n- threads: any that read; one at a time for each allocator.\n- in C: [`sf_grid_clone()`](crate::sys::sf_grid_clone)"
    };
    (sf_grid_complete: needed) => {
        "A support-free part of a shape that holds what must stay.\n\nFrom the top down, each layer asks the one below for what its voxels need: first of what must stay there anyway, then of as few others as a greedy set cover finds. Of equals the lowest row is taken, and in it the lowest x.\n\n- `needed`: what must stay, within the shape\n- cost: some twenty passes over the grid, under slack five trims, and for each voxel that may carry what hangs the element and a few steps of a heap. 512^3 under box3: 60 ms.\n- threads: any that write distinct results.\n- source: P. Slavik, \"A tight analysis of the greedy algorithm for set cover\", 1996 (greedy); that one sweep serves every monotone rule is the library's own.\n- in C: [`sf_grid_complete()`](crate::sys::sf_grid_complete)"
    };
    (sf_grid_create: lattice) => {
        "Make a grid with all voxels empty on a lattice, which is copied, heights included.\n\n- `lattice`: where the voxels lie; copied\n- cost: one pass over new memory.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_grid_create()`](crate::sys::sf_grid_create)"
    };
    (sf_grid_equal) => {
        "Whether two grids have the same counts and the same solid voxels; lengths are not compared.\n\n- cost: one pass, up to the first row that differs.\n- threads: any.\n- in C: [`sf_grid_equal()`](crate::sys::sf_grid_equal)"
    };
    (sf_grid_feasible: needed) => {
        "Whether something that must stay can be carried within what may be there; and if not, what of it cannot.\n\nA support-free shape R with needed within R within allowed exists just when needed lies within the trim of `allowed`. Each voxel that does not is a culprit: it cannot be carried even alone, and giving up or exempting just the culprits makes the rest possible. True for every rule.\n\n- `needed`: voxels that must be; what of them is not allowed is a culprit\n- cost: a trim.\n- threads: any; the grids but culprits are only read.\n- source: the greatest support-free subset is unique because support-free sets are closed under union.\n- in C: [`sf_grid_feasible()`](crate::sys::sf_grid_feasible)"
    };
    (sf_grid_grow) => {
        "Add what a shape lacks to be support-free, in place; nothing is removed.\n\nFrom the top down: in each layer the voxels that nothing carries are given supporters below, those from which the way to matter or to the bed is shortest, and among these those that carry most; no supporter is kept without which all would be carried. What is added is little, but not the least there is: that is a hard problem even in one layer. Exempt voxels need no support, and what bridges keep alive needs none. The result is checked under the whole rule before the grid is written.\n\n- cost: a map of costs (voxels times those of the element), and for each voxel without support and for each one added the voxels of the element.\n- threads: one per grid.\n- in C: [`sf_grid_grow()`](crate::sys::sf_grid_grow)"
    };
    (sf_grid_measure) => {
        "Exact moments of the solid voxels, in voxel indices; a failing call leaves `moments` as it was.\n\n- cost: one pass, shared among the task's threads.\n- threads: any.\n- in C: [`sf_grid_measure()`](crate::sys::sf_grid_measure)"
    };
    (sf_grid_popcount) => {
        "Number of solid voxels.\n\n- cost: one pass.\n- threads: any.\n- in C: [`sf_grid_popcount()`](crate::sys::sf_grid_popcount)"
    };
    (sf_grid_preserve: brush) => {
        "Remove a brush, and keep of it what carries the rest: nothing outside the brush changes.\n\nWhat counts as the brush is solid in `brush`, lies where the terms let an operator act, and is not to be kept. The shape must be support-free apart from exempt voxels, and then is after it; matter that was accepted as unsupported before the edit stays accepted, be it by the terms or by accept_unsupported. Voxels that must go are feasible just when what is outside the brush lies within trim(shape without them).\n\n- `brush`: a grid of the same counts, only read; not `grid`\n- cost: fast: the volume of the brush's box times the element, and a pass over the grid unless known_support_free and brush_box spare it; else as [`sf_grid_complete()`](crate::sys::sf_grid_complete). Irredundant under slack and with bridges: also, for each voxel that was kept first, what its loss changes above it, up to where something dies: under slack the element for each voxel that falls, with bridges a window of their reach as well. A ball in 256^3 hollowed under slack, 10^5 voxels tried: 0.35 s; with bridges over 3 voxels 2 s.\n- threads: one per grid.\n- source: T. Reiner, S. Lefebvre, \"Interactive Modeling of Support-free Shapes for Fabrication\", Eurographics 2016, sections 2.2 and 3.2 (the operator and both paper modes; as printed it deletes what it should keep).\n- in C: [`sf_grid_preserve()`](crate::sys::sf_grid_preserve)"
    };
    (sf_grid_repair) => {
        "Make a shape support-free at a low cost, in place.\n\nWhat must stay are the solid voxels of `keep` and those outside `act`; what may be added lies in `act`, not in `forbid`, and not below the bed. Where all that must stay can be carried within that, the result is support-free under the whole rule (bridges included), holds what must stay, and costs no more than a trim, where a trim may be done, nor than keeping everything that can be kept along the same supporters. A support-free shape is left as it is. The result was checked before it was written.\n\nNor does it cost more than what [`sf_grid_grow()`](crate::sys::sf_grid_grow) makes under the same terms, with two exceptions: a least width or [`SF_REPAIR_FIRST`](crate::sys::SF_REPAIR_FIRST); and more than 2^26 voxels from the bed up, unless the first result costs more than a 64th of the number of voxels that a trim removes.\n\nNor does it cost more than the same repair with `keep` the whole shape, where that is possible, with two exceptions: [`SF_REPAIR_FIRST`](crate::sys::SF_REPAIR_FIRST), or a least width under slack or with bridges; and more than four million voxels in the air.\n\nWith a least width, additions are squares of that width whose chains of squares stand on squares of what is kept; single voxels only where neither fits. Under slack such chains then take only steps that use up no reach.\n\n- cost: a few sweeps over the grid, 2 bytes for each voxel of the rectangles that the unsupported matter reaches downward (4 under slack), and time by what is unsupported, a reach's area for each voxel of it and again for each round; where grow is asked, what that costs. What could take longer is bounded (docs/repair.md).\n- threads: one per grid.\n- source: a library's own; T. Reiner, S. Lefebvre, \"Interactive Modeling of Support-free Shapes for Fabrication\", Eurographics 2016, for its two ends, trim and grow.\n- in C: [`sf_grid_repair()`](crate::sys::sf_grid_repair)"
    };
    (sf_grid_sha256) => {
        "Fingerprint of a grid's voxels: SHA-256 of its bits, not of its lengths.\n\nThe bytes that are hashed are those of its stack's pictures: every row as (nx + 7) / 8 bytes, voxel x being the bit of value 128 \\>\\> x % 8 in byte x / 8, solid 1, and unused bits 0; in a layer rows from the largest y down, layers from the lowest up. Counts are not among them, so what compares fingerprints compares lattices too.\n\n- cost: one pass, about 5 ns a byte.\n- threads: any; the grid is only read.\n- source: NIST, \"Secure Hash Standard\", FIPS 180-4, 2015.\n- in C: [`sf_grid_sha256()`](crate::sys::sf_grid_sha256)"
    };
    (sf_grid_slice) => {
        "View of slice k, to read or to write: it lives as long as the grid.\n\n- cost: constant.\n- threads: any; distinct slices may be written at once.\n- in C: [`sf_grid_slice()`](crate::sys::sf_grid_slice)"
    };
    (sf_grid_steepest) => {
        "The steepest overhang that a shape has: the least angle for which the rule slack finds nothing.\n\nTo a tenth of a degree, between 5 and 85. An overhang over a height H may be said flatter than it is by the rule's cap over H in its tangent: about two voxels up to 63 degrees, and above that what one step reaches, up to twelve on cubes. So a flat ledge of one layer is given the angle whose step reaches over it.\n\n- cost: about eleven checks under slack.\n- threads: any; the grid is only read.\n- in C: [`sf_grid_steepest()`](crate::sys::sf_grid_steepest)"
    };
    (sf_grid_surface) => {
        "The boundary of the solid voxels as a closed, oriented 2-manifold in the lattice's frame.\n\nIt stays 2-manifold after vertices of equal position are merged: where voxels touch only along an edge or in a corner, the vertices there are moved by a sixteenth of a voxel into the solid. So voxelising it on the same lattice gives the same grid back. Every voxel face is two triangles, or up to six beside such an edge; a grid without solid voxels gives a mesh without triangles.\n\nSmoothing takes steps out of the surface without shrinking it, and keeps every vertex within half a voxel of its place along each axis and the mesh closed. Voxels of what is smoothed are others, and may need support that those of the grid do not.\n\n- cost: two passes over the grid and the boundary; two over the triangles for each smoothing pass.\n- threads: any; the grid is only read; one at a time for each allocator.\n- source: for smoothing G. Taubin, \"A Signal Processing Approach to Fair Surface Design\", SIGGRAPH 1995, section 2.2; S. F. F. Gibson, \"Constrained Elastic Surface Nets\", MICCAI 1998.\n- in C: [`sf_grid_surface()`](crate::sys::sf_grid_surface)"
    };
    (sf_grid_trim) => {
        "Remove everything that is not supported, in place: what is left is the largest support-free part.\n\nFrom the bottom up: T_bed = S_bed, and T_{k+1} is what of S_{k+1} the rule lets rest on T_k; matter below the bed layer is removed. The result contains every support-free part of the shape, so no order of other removals keeps more, and trimming again changes nothing.\n\n- cost: one pass over the grid for box3 and octagon up to reach 1; about 4 \\* reach passes for others; under slack some fifty passes at a surface and few inside; with bridges, in layers where something hangs, some twenty passes over a window around it.\n- threads: one per grid.\n- source: T. Reiner, S. Lefebvre, \"Interactive Modeling of Support-free Shapes for Fabrication\", Eurographics 2016, sections 2.2 and 3.2.\n- in C: [`sf_grid_trim()`](crate::sys::sf_grid_trim)"
    };
    (sf_grid_unsupported) => {
        "Which voxels of a shape nothing carries, as it is drawn: those that a check counts, and all of what lies below the bed.\n\nWhat rests on one of them counts as carried, under slack with no reach to spare. With these exempt, and what the terms exempt already, the shape is support-free.\n\n- cost: a step of the rule for each layer.\n- threads: any that write distinct grids.\n- in C: [`sf_grid_unsupported()`](crate::sys::sf_grid_unsupported)"
    };
    (sf_grid_voids) => {
        "Find the traps of a shape, and the cups that it makes while it prints.\n\nOutside the grid, at its sides and above it, all is empty and open. Voids are listed by the last layer that they have voxels in, and within it by the first of these in row order; a shorter array holds the first of them. After a failing call the array is as it was.\n\n- cost: one pass over the grid, and nearly linear in the runs of empty voxels.\n- threads: any; the grid is only read.\n- source: R. E. Tarjan, \"Efficiency of a Good But Not Linear Set Union Algorithm\", 1975.\n- in C: [`sf_grid_voids()`](crate::sys::sf_grid_voids)"
    };
    (sf_grid_voxelize) => {
        "Fill a whole grid from a mesh; on failure the grid is as it was.\n\nThe rules are those of [`sf_voxelizer_create()`](crate::sys::sf_voxelizer_create). A cancel is heeded after every slab of layers; so that nothing changes then, a grid that holds solid voxels is filled aside first when a task is given, which takes its memory a second time.\n\n- cost: linear in triangles, crossings, and words of the grid; around holes, also in the voxels near the surface that spans them. 82,000 triangles on 512^3: 14 ms on one core.\n- threads: any, on distinct grids; the task's hook may run up to 16 pieces at once; one at a time for each allocator.\n- source: as [`sf_voxelizer_create()`](crate::sys::sf_voxelizer_create).\n- in C: [`sf_grid_voxelize()`](crate::sys::sf_grid_voxelize)"
    };
    (sf_lattice) => {
        "Where the voxels of a grid lie. The lower corner of voxel (0, 0, 0) is at origin_mm."
    };
    (sf_lattice_layer_bottom) => {
        "z of the bottom of layer k in mm, in the lattice's frame.\n\n- cost: constant, or O(k) with heights.\n- threads: any.\n- in C: [`sf_lattice_layer_bottom()`](crate::sys::sf_lattice_layer_bottom)"
    };
    (sf_lattice_layer_height) => {
        "Height of layer k in mm.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_lattice_layer_height()`](crate::sys::sf_lattice_layer_height)"
    };
    (sf_lattice_validate) => {
        "Check a lattice: counts within limits, lengths finite and positive.\n\n- cost: constant, or O(nz) with heights.\n- threads: any.\n- in C: [`sf_lattice_validate()`](crate::sys::sf_lattice_validate)"
    };
    (sf_mesh) => {
        "A mesh that owns its arrays and can be appended to."
    };
    (sf_mesh_analyze) => {
        "How the triangles of a mesh hang together: holes, edges of too many triangles, shells, sense.\n\nVertices of equal position are one point, in the sense of [`sf_mesh_merge()`](crate::sys::sf_mesh_merge); the mesh itself need not be merged. Triangles with fewer than three points are counted, and take no further part.\n\n- cost: nearly linear in vertices and triangles.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_mesh_analyze()`](crate::sys::sf_mesh_analyze)"
    };
    (sf_mesh_bounds) => {
        "Smallest box around the vertices that triangles use.\n\n- cost: linear.\n- threads: any.\n- in C: [`sf_mesh_bounds()`](crate::sys::sf_mesh_bounds)"
    };
    (sf_mesh_cut: axis, at_mm) => {
        "Cut a closed mesh by a plane across an axis into two closed halves.\n\nWhat the plane opens is closed by caps that lie exactly in it: with holes where it meets cavities (shells turned inwards), with islands in them, and with the vertices of the contours. Both caps have the same contours, but for triangles of the mesh within the plane, which belong to neither half; so the volumes of the halves add up to the whole's. Vertices of equal position are one, in the sense of [`sf_mesh_merge()`](crate::sys::sf_mesh_merge), and one that is as near to the plane as that lies on it. Each half consists of its vertices, in the order of the mesh's, then those on cut edges; its triangles, in that order, too; and its cap.\n\nWhere every edge of the mesh has two triangles, every edge of the halves has; where an edge of the mesh only touches the plane and a cap would have it, too, the cap gets a vertex in its middle. Where shells run through each other in the plane, or one through itself, the halves are closed and enclose what they should, but triangles of a cap lie over each other, and may share an edge.\n\n- `axis`: 0, 1 or 2: across x, y or z\n- `at_mm`: where the plane crosses that axis\n- cost: linear in vertices and triangles, 0.7 s for 3 million; n log n in the contours, or n n, up to a few seconds, where they cross.\n- threads: any; one at a time for each allocator.\n- source: M. R. Garey, D. S. Johnson, F. P. Preparata, R. E. Tarjan, \"Triangulating a simple polygon\", 1978; D. Eberly, \"Triangulation by ear clipping\", 2002, where contours cross.\n- in C: [`sf_mesh_cut()`](crate::sys::sf_mesh_cut)"
    };
    (sf_mesh_format_from_name) => {
        "The mesh format that the extension of a file name stands for.\n\n- cost: the length of the name.\n- threads: any.\n- in C: [`sf_mesh_format_from_name()`](crate::sys::sf_mesh_format_from_name)"
    };
    (sf_mesh_measure) => {
        "Volume, area, centre of mass and inertia of the solid that a mesh bounds.\n\nExact but for rounding where the mesh is closed and oriented. Elsewhere only the area means anything: what is open has no volume, and the figures depend on where the mesh lies.\n\n- cost: two passes over the triangles, in their order: the same bytes on every machine.\n- threads: any.\n- source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, \"Make It Stand: Balancing Shapes for 3D Fabrication\", SIGGRAPH 2013, equation 3, corrected; D. Eberly, \"Polyhedral Mass Properties (Revisited)\", 2002.\n- in C: [`sf_mesh_measure()`](crate::sys::sf_mesh_measure)"
    };
    (sf_mesh_merge) => {
        "Copy of a mesh in which vertices of equal position are one.\n\nPositions are equal when they are the same once rounded to a grain: the power of two that is 2^-40 to 2^-39 of the largest coordinate. The first vertex at a position stands for all, and vertices are numbered by first appearance. Triangles stay, in their order, also those that lose a corner.\n\n- cost: linear, but for collisions in a hash table.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_mesh_merge()`](crate::sys::sf_mesh_merge)"
    };
    (sf_mesh_read: format) => {
        "Read a mesh from any source of bytes: STL, OBJ, PLY or OFF.\n\nCoordinates are taken as they are, as mm. Polygons become fans about their first corner. What is no triangle and no vertex (normals, colours, materials, lines, unknown elements) is passed over. STL has no shared vertices, so every facet brings three of its own; [`sf_mesh_merge()`](crate::sys::sf_mesh_merge) joins them.\n\nNo count in a file is believed: memory grows as the bytes come. A binary STL file is as long as its count says or longer (a count of 0 or 2^32 - 1 means: to the end); text STL ends with endsolid; a file that is shorter is refused, because half a part looks like a whole one. So are coordinates that are not finite, faces of fewer than three corners, corners that name no vertex, and files without a triangle. Numbers are read exactly, whatever the locale.\n\n- `format`: the format, or [`SF_MESH_FORMAT_AUTO`](crate::sys::SF_MESH_FORMAT_AUTO) to judge by the first 4096 bytes\n- cost: one pass over the file; while it grows, memory for two and a half times the mesh.\n- threads: any, on distinct sources; one at a time for each allocator.\n- source: 3D Systems, \"StereoLithography Interface Specification\", 1989; Wavefront, \"Object Files\"; G. Turk, \"The PLY Polygon File Format\", 1994; the Geomview manual, \"OFF Files\".\n- in C: [`sf_mesh_read()`](crate::sys::sf_mesh_read)"
    };
    (sf_mesh_transform) => {
        "Apply an affine map to every vertex; a map that mirrors turns every triangle around.\n\n- cost: two passes over the vertices, one over the triangles of a mirrored mesh.\n- threads: one per mesh.\n- in C: [`sf_mesh_transform()`](crate::sys::sf_mesh_transform)"
    };
    (sf_mesh_validate) => {
        "Check a view: arrays where there are counts, indices in range, coordinates finite.\n\n- cost: linear.\n- threads: any.\n- in C: [`sf_mesh_validate()`](crate::sys::sf_mesh_validate)"
    };
    (sf_mesh_write: format) => {
        "Write a mesh as binary STL, OBJ or binary little-endian PLY.\n\nOBJ and PLY keep every bit of every coordinate: OBJ as the fewest of 15 to 17 digits that read back as the same double, PLY as doubles. STL has floats and unit normals; vertices that are equal stay equal. Everything is checked before the first byte is written.\n\n- `format`: [`SF_MESH_FORMAT_STL`](crate::sys::SF_MESH_FORMAT_STL), _OBJ or _PLY\n- cost: one pass to check, one to write; 4 KiB of stack, no memory.\n- threads: any, on distinct sinks.\n- in C: [`sf_mesh_write()`](crate::sys::sf_mesh_write)"
    };
    (sf_preserve_options.accept_unsupported) => {
        "1: what the terms do not carry before the edit counts as exempt. 0 (default): such a shape is refused."
    };
    (sf_preserve_options.brush_box) => {
        "Only the brush's voxels in here count; all zero: all. Saves looking for them."
    };
    (sf_preserve_options.known_support_free) => {
        "1: the caller knows that the shape is support-free, as after a trim, so that fast need not look at all of it. Where it is not, what nothing carried stays as it was, and no more is left so."
    };
    (sf_preserve_options.mode) => {
        "[`SF_PRESERVE_FAST`](crate::sys::SF_PRESERVE_FAST) by default."
    };
    (sf_preserve_options.must_go) => {
        "Voxels that must not stay, or NULL."
    };
    (sf_preserve_options.strut_width) => {
        "Of [`SF_PRESERVE_CORE`](crate::sys::SF_PRESERVE_CORE), in voxels: odd, 1 to 255; 3 by default."
    };
    (sf_preserve_options.trim_after) => {
        "1: the paper's modes end with a trim; by default they do not. A trim minds no masks: it takes what hangs wherever it is."
    };
    (sf_repair_options.add_cost) => {
        "Of adding each voxel, 1..255, nz \\* ny \\* nx of them in (layer, y, x) order; NULL (default): 1 each."
    };
    (sf_repair_options.min_feature_vx) => {
        "Added matter is made of squares of at least this many voxels each way, where there is room for them; 1 (default) asks nothing; at most [`SF_REACH_MAX`](crate::sys::SF_REACH_MAX)."
    };
    (sf_repair_options.remove_cost) => {
        "The same of removing it; NULL (default): 1 each."
    };
    (sf_repair_options.rounds) => {
        "Most rounds of improvement from each start that is tried; 0 (default): until one fails to improve; [`SF_REPAIR_FIRST`](crate::sys::SF_REPAIR_FIRST): none."
    };
    (sf_rule_box3) => {
        "The papers' rule: a voxel is carried by any of the nine below it.\n\nIt takes no angle. On cubic voxels it accepts 45 degrees along the axes and 54.7 degrees along diagonals; [`sf_rule_measure()`](crate::sys::sf_rule_measure) says what it accepts on another lattice.\n\n- cost: constant.\n- threads: any.\n- source: T. Reiner, S. Lefebvre, \"Interactive Modeling of Support-free Shapes for Fabrication\", Eurographics 2016, section 3.2.\n- in C: [`sf_rule_box3()`](crate::sys::sf_rule_box3)"
    };
    (sf_rule_kind_from_name) => {
        "The rule kind of a name, as [`sf_rule_kind_name()`](crate::sys::sf_rule_kind_name) gives it.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_rule_kind_from_name()`](crate::sys::sf_rule_kind_from_name)"
    };
    (sf_rule_make: angle_rad) => {
        "Make a rule for an overhang angle on a lattice.\n\nThe angle is measured from the vertical: 45 degrees is as far out as up, and larger is more daring. The reach of a step from layer k is height_k \\* tan(angle) / pitch voxels, rounded down to 1/2^24 voxel after one part in 2^40 has been forgiven, so that 45 degrees on cubes is exactly 1 whatever way the angle and the pitch were written.\n\nOctagon is the rule to take where an angle is given and pixels are square: it never reaches beyond the asked angle but for less than 1.502 voxel, in any direction and over any number of layers; along the axes and the diagonals it stays at atan(0.924 tan(angle)). Disk is good where the reach is three voxels or more, because each step rounds down anew; it serves pixels that are not square. Box3 ignores the angle. Slack is the rule to take where pixels are not square or where the angle must be met in every direction: no chain of any length reaches beyond the asked angle but for its cap, which is the longest single step, and in the long run it reaches the asked angle to within three percent of its tangent (seven where pixels are oblong). It costs a byte for each voxel of two layers.\n\n- `angle_rad`: [`SF_RULE_ANGLE_MIN_RAD`](crate::sys::SF_RULE_ANGLE_MIN_RAD) to [`SF_RULE_ANGLE_MAX_RAD`](crate::sys::SF_RULE_ANGLE_MAX_RAD) (5 to 85 degrees, each bound with 1e-9 to spare); ignored by box3\n- cost: O(nz) where heights differ, else constant.\n- threads: any.\n- source: The octagon's schedule is a Bresenham line in the number of pluses and squares (J. E. Bresenham, 1965).\n- in C: [`sf_rule_make()`](crate::sys::sf_rule_make)"
    };
    (sf_rule_measure) => {
        "Angles that a rule allows on a lattice.\n\nBox3 and disk: from the reach of single steps, the worst over the layers. Octagon: from its mean reach; a window of L layers is within 1.502 voxel of that. Slack: the asked angle and what its polygon of steps makes of it; a window of L layers is within the cap of that. Bridges are not overhangs and do not count.\n\n- cost: O(nz + d \\* reach^2) where d neighbouring layers differ in height.\n- threads: any.\n- in C: [`sf_rule_measure()`](crate::sys::sf_rule_measure)"
    };
    (sf_rule_set_bridges: span_mm, anchor_mm) => {
        "Let a rule accept bridges: gaps of at most a span between two anchored ends of one layer.\n\nThey run along x, along y and along both diagonals of a pixel. The span is rounded down to whole voxels, the anchor up, each after one part in 2^20 of a voxel has been forgiven; layer heights do not matter.\n\n- `span_mm`: longest gap that is spanned, 0 for no bridges\n- `anchor_mm`: length of carried matter that each end must have; a voxel is asked for at least\n- cost: constant.\n- threads: one per rule.\n- in C: [`sf_rule_set_bridges()`](crate::sys::sf_rule_set_bridges)"
    };
    (sf_slice) => {
        "A view of a plane of bits. Passed by value; the words belong to somebody else."
    };
    (sf_slice_and) => {
        "dst = a AND b: solid where both are.\n\n- cost: one pass.\n- threads: any that write to distinct slices.\n- in C: [`sf_slice_and()`](crate::sys::sf_slice_and)"
    };
    (sf_slice_bounds) => {
        "Smallest rectangle around the solid voxels.\n\n- cost: one pass at most.\n- threads: any.\n- in C: [`sf_slice_bounds()`](crate::sys::sf_slice_bounds)"
    };
    (sf_slice_copy) => {
        "dst = src.\n\nBoth have one size, with any strides. dst may be src (the same words and stride), but must not lie across it; so too for both inputs of the four functions that follow.\n\n- cost: one pass over the slices.\n- threads: any that write to distinct slices.\n- in C: [`sf_slice_copy()`](crate::sys::sf_slice_copy)"
    };
    (sf_slice_fill: rect) => {
        "Make every voxel of a rectangle solid (value != 0) or empty; an empty rectangle changes nothing.\n\n- `rect`: the voxels, all within the slice\n- cost: the words of the rectangle.\n- threads: one per slice.\n- in C: [`sf_slice_fill()`](crate::sys::sf_slice_fill)"
    };
    (sf_slice_get) => {
        "Whether voxel (x, y) is solid.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_slice_get()`](crate::sys::sf_slice_get)"
    };
    (sf_slice_or) => {
        "dst = a OR b: solid where either is.\n\n- cost: one pass.\n- threads: any that write to distinct slices.\n- in C: [`sf_slice_or()`](crate::sys::sf_slice_or)"
    };
    (sf_slice_popcount) => {
        "Number of solid voxels.\n\n- cost: one pass.\n- threads: any.\n- in C: [`sf_slice_popcount()`](crate::sys::sf_slice_popcount)"
    };
    (sf_slice_set) => {
        "Make voxel (x, y) solid (value != 0) or empty.\n\n- cost: constant.\n- threads: one per slice.\n- in C: [`sf_slice_set()`](crate::sys::sf_slice_set)"
    };
    (sf_slice_stride) => {
        "Words from row to row in slices that the library allocates: rows start on 64-byte boundaries.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_slice_stride()`](crate::sys::sf_slice_stride)"
    };
    (sf_slice_subtract) => {
        "dst = a AND NOT b: solid where a is and b is not.\n\n- cost: one pass.\n- threads: any that write to distinct slices.\n- in C: [`sf_slice_subtract()`](crate::sys::sf_slice_subtract)"
    };
    (sf_slice_xor) => {
        "dst = a XOR b: solid where just one is.\n\n- cost: one pass.\n- threads: any that write to distinct slices.\n- in C: [`sf_slice_xor()`](crate::sys::sf_slice_xor)"
    };
    (sf_task) => {
        "How long work talks to its host. Make one with [`sf_task_default()`](crate::sys::sf_task_default), fill in what you need.\n\n`progress` is called on the thread that called the library, with a fraction in \\[0, 1\\] that never falls during one call. `parallel_for` must call `body(context, i)` once for each i in \\[0, count), in any order and on any threads, and return when all are done; NULL runs them one after the other. Results are the same bytes either way."
    };
    (sf_task_cancel) => {
        "Ask a task to stop.\n\nThe request sticks: every later call with this task is cancelled too.\n\n- cost: constant.\n- threads: any, while the task is in use.\n- in C: [`sf_task_cancel()`](crate::sys::sf_task_cancel)"
    };
    (sf_task_default) => {
        "A task without callbacks, not cancelled.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_task_default()`](crate::sys::sf_task_default)"
    };
    (sf_task_is_cancelled) => {
        "Whether a task has been cancelled.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_task_is_cancelled()`](crate::sys::sf_task_is_cancelled)"
    };
    (sf_terms) => {
        "The terms that an operator works on: a rule, a bed, and masks. Fill with [`sf_terms_default()`](crate::sys::sf_terms_default).\n\nA mask is a grid of the same counts as the shape's, and its solid voxels are what it names; NULL where there is none. Masks are only read, and must not be the grid that is changed."
    };
    (sf_terms.act) => {
        "Where an operator may act; NULL: everywhere."
    };
    (sf_terms.exempt) => {
        "NULL, or what counts as carried already, with no reach to spare: overhangs that are accepted, matter that something else holds."
    };
    (sf_terms.forbid) => {
        "NULL, or what is never added."
    };
    (sf_terms.keep) => {
        "NULL, or what is never removed, where it is solid in the shape."
    };
    (sf_version) => {
        "Version of the library that is running, as \"major.minor.patch\".\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_version()`](crate::sys::sf_version)"
    };
    (sf_voids_options.bed_is_open) => {
        "0 (default): the bed closes what is open towards it; 1: it does not, as in a box of powder, or once the part is off the bed."
    };
    (sf_voids_options.cup_area_min) => {
        "Cups of a smaller area are small; 0 by default."
    };
    (sf_voids_options.cup_layers_min) => {
        "Cups of fewer layers are small; 0 by default."
    };
    (sf_voxelizer) => {
        "A voxeliser: slices of a mesh one at a time, with memory for one slab."
    };
    (sf_voxelizer_create) => {
        "Prepare to voxelise a mesh on a lattice, slice by slice.\n\nEvery corner is rounded once to 1/256 of a voxel (1/256 of the mean layer height along z), and what follows is exact on the rounded mesh: a voxel is solid where the winding number around its centre is at least one half, and a centre that lies on the surface counts as lying just beyond it in x, then in y, then in z. So two closed meshes that share a face give disjoint voxels whose union is that of both, and no closed mesh leaks. Corners further than two million voxels from the lattice's origin are refused; what leaves the lattice is cut off.\n\n[`SF_FILL_AUTO`](crate::sys::SF_FILL_AUTO) takes any mesh: where it is not closed, equal corners are merged, neighbours that disagree are turned (as few as possible in each patch), and holes are spanned by the surface on which the generalised winding number is one half. Around holes that number comes from bounds and, in boxes of 8 voxels, from interpolation with a measured margin; away from a half it is never in doubt. Last, a mesh that encloses a negative volume is turned as a whole. [`SF_FILL_WINDING`](crate::sys::SF_FILL_WINDING) takes all triangles as they look, [`SF_FILL_PARITY`](crate::sys::SF_FILL_PARITY) counts crossings and reports rows that leak.\n\n[`SF_FILL_SURFACE`](crate::sys::SF_FILL_SURFACE) sets each voxel whose closed box the rounded surface touches.\n\n- cost: linear in vertices and triangles; more memory (about 100 bytes a triangle, for a while) where the mesh is not closed.\n- threads: any; one at a time for each allocator.\n- source: J. Pineda, \"A parallel algorithm for polygon rasterization\", 1988; A. Jacobson, L. Kavan, O. Sorkine-Hornung, \"Robust inside-outside segmentation using generalized winding numbers\", 2013; G. Barill and others, \"Fast winding numbers for soups and clouds\", 2018; M. Schwarz, H.-P. Seidel, \"Fast parallel surface and solid voxelization on GPUs\", 2010.\n- in C: [`sf_voxelizer_create()`](crate::sys::sf_voxelizer_create)"
    };
    (sf_voxelizer_report) => {
        "What was found so far: sums over all slices that were filled.\n\n- cost: constant.\n- threads: one at a time for each voxeliser.\n- in C: [`sf_voxelizer_report()`](crate::sys::sf_voxelizer_report)"
    };
    (sf_voxelizer_slice: k, slice) => {
        "Fill slice k of the lattice: the same bytes as that slice of [`sf_grid_voxelize()`](crate::sys::sf_grid_voxelize).\n\nSlices can be asked for in any order and more than once; each asking counts in the report.\n\n- `k`: layer, below the lattice's nz\n- `slice`: nx by ny voxels; what it held is lost; bits past the width become zero\n- cost: the crossings of the slab of layers that k lies in, and one pass over the slice; no memory.\n- threads: one at a time for each voxeliser.\n- in C: [`sf_voxelizer_slice()`](crate::sys::sf_voxelizer_slice)"
    };
}

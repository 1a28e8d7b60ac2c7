// SPDX-License-Identifier: MIT
// The words of the headers, for comments. Written by bindings/rust/generate.py.

macro_rules! words {
    (SF_DENSITY_BOX) => {
        "Voxels whose centre lies in low_mm \\<= centre \\< high_mm."
    };
    (SF_DENSITY_MASK) => {
        "Voxels that are solid in a grid."
    };
    (SF_DENSITY_MESH) => {
        "Voxels whose centre lies in the solid that a mesh bounds."
    };
    (sf_ballast_body) => {
        "Body of masses in points, summed in their order.\n\n- cost: linear.\n- threads: any.\n- in C: [`sf_ballast_body()`](crate::sys::sf_ballast_body)"
    };
    (sf_blend) => {
        "Points with their weights: what a pose of all handles bends."
    };
    (sf_blend_apply) => {
        "Bend points: v = sum of w_j (s_j R_j (p - c_j) + c_j + t_j).\n\n- cost: one pass; 86 000 points and six handles take about 1 ms on one core.\n- threads: any that write to distinct arrays.\n- source: the paper's equation 9.\n- in C: [`sf_blend_apply()`](crate::sys::sf_blend_apply)"
    };
    (sf_blend_pull: gradient) => {
        "How a function of the points changes when poses change: the transpose of M times a gradient.\n\n- `gradient`: the function's derivatives by x, y, z of each point\n- cost: one pass.\n- threads: any that write to distinct arrays; one at a time for each allocator.\n- in C: [`sf_blend_pull()`](crate::sys::sf_blend_pull)"
    };
    (sf_blend_push) => {
        "How points move when poses change: the matrix M of the paper's equation 10 times a vector.\n\nThe move is w_j (ds_j R_j (p - c_j) + dt_j + s_j spin_j x R_j (p - c_j)), summed over handles: exact for scales and shifts, in which a blend is linear, and the derivative for spins.\n\n- cost: as [`sf_blend_apply()`](crate::sys::sf_blend_apply).\n- threads: any that write to distinct arrays.\n- in C: [`sf_blend_push()`](crate::sys::sf_blend_push)"
    };
    (sf_body_add: factor) => {
        "a + factor \\* b: with 1 both together, with -1 the one less the other.\n\n- `factor`: how often b is added\n- cost: constant.\n- threads: any.\n- in C: [`sf_body_add()`](crate::sys::sf_body_add)"
    };
    (sf_body_com) => {
        "Centre of mass of a body.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_body_com()`](crate::sys::sf_body_com)"
    };
    (sf_body_com_gradient) => {
        "Gradient of a centre of mass: (d moment - com d mass) / mass.\n\n- cost: linear.\n- threads: any that write distinct arrays.\n- source: the same; (d m / d v) c is an outer product.\n- in C: [`sf_body_com_gradient()`](crate::sys::sf_body_com_gradient)"
    };
    (sf_brush.kind) => {
        "Add-trim by default."
    };
    (sf_brush.material) => {
        "Of what is added or painted: 1 (default) to 255."
    };
    (sf_brush.passes) => {
        "Of smooth-trim: 1 (default) to [`SF_BRUSH_PASSES_MAX`](crate::sys::SF_BRUSH_PASSES_MAX)."
    };
    (sf_cage) => {
        "A cage that owns its arrays."
    };
    (sf_cage_add_property) => {
        "Add a property, as the last channel.\n\n- cost: O(values and corners).\n- threads: one for each cage.\n- in C: [`sf_cage_add_property()`](crate::sys::sf_cage_add_property)"
    };
    (sf_cage_block: counts, low_mm, high_mm) => {
        "A block of hexahedra.\n\nPoint (i, j, k) is number i + (nx + 1) (j + (ny + 1) k), cell (i, j, k) number i + nx (j + ny k).\n\n- `counts`: cells along x, y and z, at least 1\n- `low_mm`: its lower corner\n- `high_mm`: its upper corner, above the lower one along each axis\n- cost: linear.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_cage_block()`](crate::sys::sf_cage_block)"
    };
    (sf_cage_check) => {
        "Look at a cage: how it hangs together, and whether its cells are the right way out.\n\n- cost: linear.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_cage_check()`](crate::sys::sf_cage_check)"
    };
    (sf_cage_create) => {
        "Make a cage of somebody's arrays, which are copied.\n\nRefused is what has no limit: a cell with a point twice, a face of three cells, a boundary that meets itself in an edge or in a point only, cells that lie on the same side of a face they share. Whether cells are inverted is another question: [`sf_cage_check()`](crate::sys::sf_cage_check).\n\n- cost: linear, but for collisions in a hash table.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_cage_create()`](crate::sys::sf_cage_create)"
    };
    (sf_cage_extrude: vector_mm, layers) => {
        "Draw faces along a line: prisms, of quadrilaterals hexahedra.\n\nThe points of layer k are those of the faces, in their order, k / layers of the way; the cells of a layer follow each other in the order of the faces.\n\n- `vector_mm`: how far, across the faces\n- `layers`: how many cells that is, at least 1\n- cost: linear.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_cage_extrude()`](crate::sys::sf_cage_extrude)"
    };
    (sf_cage_get_view) => {
        "View of a cage.\n\n- cost: constant.\n- threads: any, while nobody changes the cage.\n- in C: [`sf_cage_get_view()`](crate::sys::sf_cage_get_view)"
    };
    (sf_cage_history) => {
        "The steps of one cage."
    };
    (sf_cage_history_create: bytes_max) => {
        "A history without steps, of a cage as it is now.\n\n- `bytes_max`: most bytes of all steps together, besides that copy: 8 for each number that a step changes, and up to 24 more where it stands alone\n- cost: O(points and values).\n- threads: any, while nobody changes the cage.\n- in C: [`sf_cage_history_create()`](crate::sys::sf_cage_history_create)"
    };
    (sf_cage_history_get_state) => {
        "What a history holds.\n\n- cost: constant.\n- threads: any, while nobody changes the history.\n- in C: [`sf_cage_history_get_state()`](crate::sys::sf_cage_history_get_state)"
    };
    (sf_cage_history_record) => {
        "Keep what has changed since the last call as one step; nothing, if nothing has.\n\nSteps that could be redone are forgotten then. A step that takes more than all the bytes there are empties the history: it cannot be undone, nor what was before it. Properties that were added at the cage's end are watched from now on; that they were added is no step.\n\n- cost: O(points and values).\n- threads: one for each history, while nobody changes the cage.\n- in C: [`sf_cage_history_record()`](crate::sys::sf_cage_history_record)"
    };
    (sf_cage_history_redo) => {
        "Redo the step that was undone last; where something has changed since, record that instead, after which there is nothing to redo.\n\n- cost: O(points and values).\n- threads: one for each history and cage.\n- in C: [`sf_cage_history_redo()`](crate::sys::sf_cage_history_redo)"
    };
    (sf_cage_history_undo) => {
        "Undo the last step; where something has changed that was not recorded, record it first and undo that.\n\n- cost: O(points and values).\n- threads: one for each history and cage.\n- in C: [`sf_cage_history_undo()`](crate::sys::sf_cage_history_undo)"
    };
    (sf_cage_map_positions) => {
        "Move all points by a function of their places.\n\n- cost: O(points).\n- threads: one for each cage.\n- in C: [`sf_cage_map_positions()`](crate::sys::sf_cage_map_positions)"
    };
    (sf_cage_map_values: channel) => {
        "Set all values of a property by a function of the places of their points.\n\n- `channel`: which property; a value that several corners name gets that of the last one's place\n- cost: O(points and corners).\n- threads: one for each cage.\n- in C: [`sf_cage_map_values()`](crate::sys::sf_cage_map_values)"
    };
    (sf_cage_read) => {
        "Read a cage from any source of bytes.\n\nCoordinates are taken as they are, as mm. Where a file has cells, its faces are passed over; where it has none, its faces are the cage, of dimension 2. A cell that is inverted at every one of its corners, as the wedges of one half of all programs are, is turned: its lower polygon becomes the upper one. Cells that are inverted in part are left to [`sf_cage_check()`](crate::sys::sf_cage_check); faces are never turned. A cell is numbered, in sentences too, among the cells that the cage has, from 0.\n\n- Medit: Vertices, Tetrahedra, Prisms (or Wedges, or Pentahedra), Hexahedra, Triangles and Quadrilaterals; Corners become sharp points, the Edges that Ridges names become creases, both sharp for ever. Where the references of cells are not all the same, they become the property \"reference\", one value for each cell. Other sections of the format are passed over.\n- MFEM: elements, vertices or nodes. Of nodes, the points are taken: what is curved between them is not kept. Attributes become the property \"attribute\", as references do. Meshes with hanging nodes are refused: faces that meet half a face have no common limit.\n- VTK: versions 2.0 to 5.1. Tetrahedra, wedges, hexahedra, voxels, prisms over five and six corners; triangles, quads, pixels and polygons. Point data and cell data with one component are properties under their names; cell data become one value for each cell. Data of several components are passed over. What [`sf_cage_write_vtk()`](crate::sys::sf_cage_write_vtk) has written comes back as it was.\n\nA property of a foreign file has no unit, no bounds, and a UUID that is made of its name (version 8 of RFC 9562: the first 128 bits of the SHA-256 of \"libsf property \" and the name).\n\nNo count in a file is believed: memory grows as the bytes come. Refused are pyramids, elements with curved edges of their own, a cell whose type disagrees with its number of corners, corners that name no point, numbers that are not finite, files that are cut short, and what [`sf_cage_create()`](crate::sys::sf_cage_create) refuses; where hanging nodes are the reason for that, the sentence names one. To stop early, let the source return [`SF_ERR_CANCELLED`](crate::sys::SF_ERR_CANCELLED).\n\n- cost: one pass over the file; memory for about three times the cage.\n- threads: any, on distinct sources; one at a time for each allocator.\n- source: P. Frey, \"MEDIT: An interactive mesh visualization software\", 2001; the MFEM project, \"MFEM mesh formats\"; Kitware, \"VTK file formats\", legacy.\n- in C: [`sf_cage_read()`](crate::sys::sf_cage_read)"
    };
    (sf_cage_read_options) => {
        "What a reader expects and takes at most. Fill with [`sf_cage_read_options_default()`](crate::sys::sf_cage_read_options_default)."
    };
    (sf_cage_read_options.bytes_max) => {
        "Most bytes read from the source."
    };
    (sf_cage_read_options.corners_max) => {
        "Most corners of all cells; beyond [`SF_CAGE_POINT_MAX`](crate::sys::SF_CAGE_POINT_MAX) it is that."
    };
    (sf_cage_read_options.points_max) => {
        "Most points; beyond [`SF_CAGE_POINT_MAX`](crate::sys::SF_CAGE_POINT_MAX) it is that."
    };
    (sf_cage_remove_property: channel) => {
        "Remove a property; those after it move up.\n\n- `channel`: number of the property, counted from 0\n- cost: constant.\n- threads: one for each cage.\n- in C: [`sf_cage_remove_property()`](crate::sys::sf_cage_remove_property)"
    };
    (sf_cage_revolve: sectors, angle_rad) => {
        "Turn faces about the z axis.\n\nThe faces lie in the half-plane of x at least 0 and y = 0; y is not looked at. An edge on the axis stays one: a quadrilateral there becomes a wedge, a triangle a tetrahedron. On the axis are points whose x is 0 and no other number: round what was measured or read.\n\n- `sectors`: how many cells around, at least 3 for a full turn, else at least 1\n- `angle_rad`: how far, above 0 and at most a full turn; only the double nearest to 2 pi closes; for parts less than pi for each sector\n- cost: linear.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_cage_revolve()`](crate::sys::sf_cage_revolve)"
    };
    (sf_cage_set_positions: first) => {
        "Move points.\n\n- `first`: the first point\n- cost: O(count).\n- threads: one for each cage.\n- in C: [`sf_cage_set_positions()`](crate::sys::sf_cage_set_positions)"
    };
    (sf_cage_set_values: channel, first) => {
        "Change values of a property.\n\n- `channel`: which property, below channel_count\n- `first`: the first value\n- cost: O(count).\n- threads: one for each cage.\n- in C: [`sf_cage_set_values()`](crate::sys::sf_cage_set_values)"
    };
    (sf_cage_skeleton: nodes, struts) => {
        "A body along a skeleton: cubes at the nodes, and struts between them, all hexahedra.\n\nA strut leaves a node through the side that its direction is nearest to, and no two struts through the same side. It is not twisted more than it must be. Whether cubes or struts run into each other is not looked at.\n\n- `nodes`: the nodes; their cubes are the first cells, in their order\n- `struts`: the struts; their cells follow\n- cost: linear.\n- threads: any; one at a time for each allocator.\n- source: C. Altenhofen and others, \"Continuous property gradation for multi-material 3D-printed objects\", 2018, on sketched control meshes.\n- in C: [`sf_cage_skeleton()`](crate::sys::sf_cage_skeleton)"
    };
    (sf_cage_view) => {
        "A cage in somebody's arrays.\n\nRefined cages and what is read from files come as this, too. The open edges of a cage of dimension 2 are sharp by themselves; its boundary is cut off square there."
    };
    (sf_cage_view.dimension) => {
        "3: cells; 2: faces."
    };
    (sf_cage_write_vtk) => {
        "Write a cage, or a refined one, as a legacy VTK file, version 3.0, that ParaView opens.\n\nA property is data of points; one that is the same at all corners of each cell, by its indices, is data of cells. Where a property jumps, a point is written once for each set of values that its corners have: first all points in their order, then the other copies. Then the data of points \"sf_point\" say which point each one is a copy of. What VTK has no place for are fields of the grid: \"sf_creases\", rows of two points and a sharpness; \"sf_sharps\", rows of a point and a sharpness; \"[`sf_property`](crate::sys::sf_property):NAME\", of each property, 27 numbers: the bytes of its UUID, the exponents of its unit, then 1 and the low bound or 0 and 0, and the same for the high bound. In names, blanks, % and quotation marks are written as VTK does, % and two digits.\n\n[`sf_cage_read()`](crate::sys::sf_cage_read) makes the same cage of it: the same points, cells and sharp things, and at every corner the same value; corners of a point that have the same value then name the same one. Numbers read back as the same doubles; a zero with a sign loses it in text. A sharpness beyond [`SF_SHARP`](crate::sys::SF_SHARP) is written as that.\n\n- cost: one pass to check, one to write; where a property jumps, 12 bytes for each point and 16 for each corner.\n- threads: any, on distinct sinks; one at a time for each allocator.\n- source: Kitware, \"VTK file formats\", legacy.\n- in C: [`sf_cage_write_vtk()`](crate::sys::sf_cage_write_vtk)"
    };
    (sf_carve_options.density) => {
        "What 1 mm3 of each voxel weighs, above 0, in (layer, y, x) order; NULL (default): 1. What is not solid is not looked at."
    };
    (sf_carve_options.goal) => {
        "[`SF_CARVE_ENOUGH`](crate::sys::SF_CARVE_ENOUGH) by default; without stances not looked at."
    };
    (sf_carve_options.mode) => {
        "[`SF_CARVE_SUPPORT_FREE`](crate::sys::SF_CARVE_SUPPORT_FREE) by default."
    };
    (sf_carve_options.rest) => {
        "What else the part weighs: ballast, and the mesh less its voxels."
    };
    (sf_carve_options.rounds_max) => {
        "Plane: most rounds, each with a plane of its own; 64 by default."
    };
    (sf_carve_options.stances) => {
        "Where the centre of mass may lie: in all of them."
    };
    (sf_carve_options.strut_width_vx) => {
        "Support-free: struts are squares of that many voxels where there is room, 1 to [`SF_REACH_MAX`](crate::sys::SF_REACH_MAX); 2 by default."
    };
    (sf_certificate) => {
        "A certificate; owns its memory, and refers to no grid."
    };
    (sf_certificate_get_view) => {
        "What a certificate says.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_certificate_get_view()`](crate::sys::sf_certificate_get_view)"
    };
    (sf_certificate_make) => {
        "Certify that a shape is support-free but for exempt voxels, after looking at every layer of it.\n\nThe claim's angle and spans must be those that the rule in its terms was made from: the rule is made again, and its integers compared.\n\n- cost: a trim, two fingerprints, and with bridges a walk along each gap.\n- threads: any; grids are only read.\n- source: a field that the layer rule's own step reproduces proves the shape support-free, for every rule that is monotone.\n- in C: [`sf_certificate_make()`](crate::sys::sf_certificate_make)"
    };
    (sf_certificate_view) => {
        "All that a certificate says. Arrays belong to the certificate."
    };
    (sf_certificate_view.added_voxels) => {
        "In the shape, not in the input."
    };
    (sf_certificate_view.angle_rad) => {
        "Its angle; 0 for box3."
    };
    (sf_certificate_view.bed) => {
        "Layer that rests on the bed; nz: no matter."
    };
    (sf_certificate_view.bridge_anchor_mm) => {
        "Carried matter at both ends of one, in mm."
    };
    (sf_certificate_view.bridge_span_mm) => {
        "Its bridges in mm; 0: none."
    };
    (sf_certificate_view.exempt) => {
        "Maximal runs of solid exempt voxels, from the lowest layer up, row by row; label: the layer."
    };
    (sf_certificate_view.input_sha256) => {
        "Fingerprint of what the operation began with."
    };
    (sf_certificate_view.input_voxels) => {
        "Solid voxels of the input."
    };
    (sf_certificate_view.lattice) => {
        "Where it lies; layer 0 is where the rule's schedule begins."
    };
    (sf_certificate_view.output_sha256) => {
        "Fingerprint of the shape."
    };
    (sf_certificate_view.output_voxels) => {
        "Solid voxels of the shape."
    };
    (sf_certificate_view.removed_voxels) => {
        "In the input, not in the shape."
    };
    (sf_certificate_view.spans) => {
        "Gaps that bridges span."
    };
    (sf_certificate_view.steps) => {
        "Integers of each step."
    };
    (sf_certificate_view.tangent) => {
        "The tangent that its integers come from; or 0."
    };
    (sf_certificate_write) => {
        "Write a certificate as JSON, for sf-verify and whoever else wants to check it.\n\ndocs/certificate.md says what each field holds. The last one is the SHA-256 of every byte before it, so the file is to be kept as it is: the same JSON in other words is refused.\n\n- cost: the length of the file; 12 KiB of stack, no memory.\n- threads: any, on distinct sinks.\n- in C: [`sf_certificate_write()`](crate::sys::sf_certificate_write)"
    };
    (sf_channel) => {
        "The values of one property over a mesh."
    };
    (sf_channel.values) => {
        "Finite, within the property's bounds."
    };
    (sf_check_options.run_capacity) => {
        "Runs of lost matter kept of each layer, to link the next one to its findings. 0: none, each finding answers for its own region only; but in [`sf_grid_check()`](crate::sys::sf_grid_check) as many as it takes."
    };
    (sf_checker) => {
        "A streaming check that keeps two layers, and two more while a layer is pushed.\n\nA voxel that nothing carries counts once; what rests on it is then judged as if it were carried, under slack with no reach to spare.\n\nLives in memory of the caller's, takes none of its own, and computes with integers only, so that a printer's controller can run it while it reads a job. It needs no end: the report may be asked for after any layer, and the memory may be reused when it is no longer wanted."
    };
    (sf_checker_push) => {
        "Push the next layer as bits.\n\nFindings of the layer are in the array when the call returns, in the order in which their regions end: by last row, then from left to right in that row. Volumes and boxes of earlier findings may have grown.\n\n- cost: a step of the rule, two where matter was lost below (under slack, as long as it tells), and in lost matter its voxels times the rows of the element; whatever the size, up to 9 KiB of stack, 6 on a processor of 32 bits.\n- threads: one per checker.\n- source: T. Reiner, S. Lefebvre, \"Interactive Modeling of Support-free Shapes for Fabrication\", Eurographics 2016, section 3.2.\n- in C: [`sf_checker_push()`](crate::sys::sf_checker_push)"
    };
    (sf_checker_push_contours: lattice, contours) => {
        "Push the next layer as contours: closed polygons of \\<sf/contour.h\\>.\n\n- `lattice`: of the checker's width and height; pitch and origin are looked at\n- `contours`: the polygons\n- cost: as both.\n- threads: one per checker.\n- in C: [`sf_checker_push_contours()`](crate::sys::sf_checker_push_contours)"
    };
    (sf_checker_push_grey: row_bytes, threshold) => {
        "Push the next layer as 8-bit rows: solid where the value is at least `threshold`.\n\n- `row_bytes`: bytes from one row to the next, at least the width\n- `threshold`: 1 to 255; 0 makes everything solid\n- cost: as [`sf_checker_push()`](crate::sys::sf_checker_push), and two passes over the pixels.\n- threads: one per checker.\n- in C: [`sf_checker_push_grey()`](crate::sys::sf_checker_push_grey)"
    };
    (sf_checker_push_runs: runs) => {
        "Push the next layer as runs.\n\n- `runs`: row by row, left to right, not overlapping but free to touch; labels are ignored; may be NULL where count is 0\n- cost: O(count) where layer_run_capacity serves; else as [`sf_checker_push()`](crate::sys::sf_checker_push) too.\n- threads: one per checker.\n- in C: [`sf_checker_push_runs()`](crate::sys::sf_checker_push_runs)"
    };
    (sf_checker_report) => {
        "Counts so far.\n\n- cost: constant.\n- threads: one per checker.\n- in C: [`sf_checker_report()`](crate::sys::sf_checker_report)"
    };
    (sf_contour_stack) => {
        "Layers of contours with their heights; it owns its memory."
    };
    (sf_contour_stack_add: top_mm) => {
        "Add a layer on top: it reaches from the top of the one below to `top_mm`.\n\n- `top_mm`: above the stack's top so far\n- cost: the points.\n- threads: one per stack.\n- in C: [`sf_contour_stack_add()`](crate::sys::sf_contour_stack_add)"
    };
    (sf_contour_stack_count) => {
        "Number of layers.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_contour_stack_count()`](crate::sys::sf_contour_stack_count)"
    };
    (sf_contour_stack_create: bottom_mm) => {
        "Make a stack without layers.\n\n- `bottom_mm`: height of the lowest layer's underside\n- cost: constant.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_contour_stack_create()`](crate::sys::sf_contour_stack_create)"
    };
    (sf_contour_stack_lattice) => {
        "A lattice that holds all contours of a stack, one layer each.\n\nIts corner is the least x, y and z; it ends at the first voxel beyond the greatest. Heights are rounded to nanometres, as sums of decimals need it; where all are the same, one stands for them.\n\n- cost: one pass.\n- threads: any.\n- in C: [`sf_contour_stack_lattice()`](crate::sys::sf_contour_stack_lattice)"
    };
    (sf_contour_stack_layer: k) => {
        "The contours of a layer and its heights.\n\n- `k`: the layer, below [`sf_contour_stack_count()`](crate::sys::sf_contour_stack_count)\n- cost: constant.\n- threads: any.\n- in C: [`sf_contour_stack_layer()`](crate::sys::sf_contour_stack_layer)"
    };
    (sf_contour_stack_read) => {
        "Read a CLI file, text or binary, with short or long numbers.\n\nA layer's height is that of its top; the lowest one is as thick as the step to the next (where there is only one: down to 0, or a millimetre where it lies there or below). A polygon that says it is an outside turns to the left afterwards, one that says it is a hole to the right, so that [`SF_CONTOUR_NONZERO`](crate::sys::SF_CONTOUR_NONZERO) is the fill to take. Layers of one height that follow each other are one.\n\nNo count is believed: memory grows as points come. Refused are heights that fall, numbers that are not finite, another number of layers than the head says, and files that end early.\n\n- cost: one pass.\n- threads: any, on distinct sources; one at a time for each allocator.\n- source: \"Common Layer Interface (CLI), Version 2.0\", Brite EuRam BE 2578, 1994.\n- in C: [`sf_contour_stack_read()`](crate::sys::sf_contour_stack_read)"
    };
    (sf_contour_stack_trace: top_mm, slice, lattice) => {
        "Trace the border of a slice's voxels and add it as the next layer.\n\nEach contour runs along the sides of voxels with matter on its left: around a piece it turns to the left, around a hole to the right. Pieces that meet in a corner only stay apart. Points are where it turns, so drawing the layer again, under either fill, gives the same voxels.\n\n- `top_mm`: above the stack's top so far\n- `slice`: the slice, of the lattice's nx and ny\n- `lattice`: where voxels lie: nx, ny, pitch and origin are looked at\n- cost: a pass over the slice, and the length of the border in voxels; a slice of memory while it works.\n- threads: one per stack.\n- in C: [`sf_contour_stack_trace()`](crate::sys::sf_contour_stack_trace)"
    };
    (sf_contour_stack_write: format) => {
        "Write a stack as a CLI file, in mm.\n\nWhat turns to the left is written as an outside, what turns to the right as a hole. The file does not say where the lowest layer begins.\n\n- `format`: text or binary\n- cost: one pass; 12 KiB of stack, no memory.\n- threads: any, on distinct sinks.\n- in C: [`sf_contour_stack_write()`](crate::sys::sf_contour_stack_write)"
    };
    (sf_contours) => {
        "A view of the closed polygons of one layer.\n\nContour i has the points starts\\[i\\] to starts\\[i + 1\\] - 1, and its last point is joined to its first. Fewer than three points enclose nothing. A first point that is said again at the end does no harm."
    };
    (sf_contours_area_mm2) => {
        "Signed area of contours: what turns to the left counts, what turns to the right is taken away.\n\nFor contours that cross nothing and whose holes turn the other way it is the area inside, under either fill.\n\n- cost: one pass.\n- threads: any.\n- in C: [`sf_contours_area_mm2()`](crate::sys::sf_contours_area_mm2)"
    };
    (sf_curve) => {
        "A monotone function through measurements."
    };
    (sf_curve_change) => {
        "How far the curve is from the sample that it had to leave the most; 0 for NULL.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_curve_change()`](crate::sys::sf_curve_change)"
    };
    (sf_curve_create: samples, trend) => {
        "Make a curve from samples in any order.\n\nSamples of equal x become their mean. Where the others contradict the trend they are replaced by the closest values that do not (least squares). Between them goes a cubic that is monotone and smooth to its first derivative; beyond the first and the last it is constant.\n\n- `samples`: count of them, finite, below 1e100 in size\n- `trend`: which way it goes\n- cost: sorting the samples.\n- threads: any; one at a time for each allocator.\n- source: M. Ayer and others, \"An empirical distribution function for sampling with incomplete information\", 1955 (pool adjacent violators); F. N. Fritsch, R. E. Carlson, \"Monotone piecewise cubic interpolation\", 1980.\n- in C: [`sf_curve_create()`](crate::sys::sf_curve_create)"
    };
    (sf_curve_inverse: y, miss) => {
        "Where the curve has a value: the least such x, or the end whose value is nearest.\n\n- `y`: the wanted value\n- `miss`: NULL, or receives the value there less the wanted one: 0 but for rounding where the curve has it\n- cost: a binary search and some ten evaluations.\n- threads: any.\n- in C: [`sf_curve_inverse()`](crate::sys::sf_curve_inverse)"
    };
    (sf_curve_value: x) => {
        "The curve at x.\n\n- `x`: anywhere\n- cost: a binary search.\n- threads: any.\n- in C: [`sf_curve_value()`](crate::sys::sf_curve_value)"
    };
    (sf_dab_line) => {
        "The dabs from one to another, a voxel apart: the digital line between them.\n\nThe line has max(|dx|, |dy|, |dz|) steps; each dab is the nearest to the straight line, halves rounded away from `from`.\n\n- cost: linear.\n- threads: any.\n- source: J. E. Bresenham, \"Algorithm for computer control of a digital plotter\", 1965.\n- in C: [`sf_dab_line()`](crate::sys::sf_dab_line)"
    };
    (sf_density_field) => {
        "What matter weighs at a place of the shape as it was before bending: 1 is the part's own; above 0, and finite as a float. Asked once a round for each voxel."
    };
    (sf_density_options.density) => {
        "Of everything that no region says otherwise of, above 0: 1."
    };
    (sf_density_options.infill) => {
        "Share of that in what is not wall, above 0 and at most 1: 1."
    };
    (sf_density_options.wall) => {
        "What is dense; NULL (default): all."
    };
    (sf_diffuser) => {
        "Error diffusion from slice to slice: what one voxel could not be, the next ones are."
    };
    (sf_diffuser_create: width, height, material_count, pitch_mm) => {
        "Begin diffusing errors through slices of one size, from the lowest up.\n\nEach voxel gets the material that it lacks most, and what it got too much or too little goes to the next voxel in the row, the two behind it in the next row, and the one above, more to those that are nearer in mm. Rows run to and fro. Shares of voxels that are empty or outside go up.\n\n- `width`: 1..[`SF_EXTENT_MAX`](crate::sys::SF_EXTENT_MAX)\n- `height`: 1..[`SF_EXTENT_MAX`](crate::sys::SF_EXTENT_MAX)\n- `material_count`: 2..[`SF_MATERIAL_MAX`](crate::sys::SF_MATERIAL_MAX)\n- `pitch_mm`: of a voxel: x, y, z, above 0; no two differ by a factor above 64\n- cost: one pass over the memory.\n- threads: any; one at a time for each allocator.\n- source: R. Floyd, L. Steinberg, \"An adaptive algorithm for spatial greyscale\", 1976, with vectors, in three dimensions.\n- in C: [`sf_diffuser_create()`](crate::sys::sf_diffuser_create)"
    };
    (sf_diffuser_report) => {
        "What became of the tones so far.\n\n- cost: one pass over its memory.\n- threads: one at a time for each diffuser.\n- in C: [`sf_diffuser_report()`](crate::sys::sf_diffuser_report)"
    };
    (sf_diffuser_slice) => {
        "Halftone the next slice up.\n\n- cost: some 20 operations for each voxel and material, one after the other. No memory.\n- threads: one at a time for each diffuser.\n- in C: [`sf_diffuser_slice()`](crate::sys::sf_diffuser_slice)"
    };
    (sf_drain_options.body) => {
        "What the whole part weighs; looked at where there are stances."
    };
    (sf_drain_options.count) => {
        "Holes for each void, far from each other; 1 by default."
    };
    (sf_drain_options.density) => {
        "Of each voxel, as in [`sf_carve_options`](crate::sys::sf_carve_options); NULL (default): 1."
    };
    (sf_drain_options.diameter_mm) => {
        "A round rod of that diameter passes; above 0."
    };
    (sf_drain_options.fill) => {
        "1: a void that no hole fits into, or of fewer voxels than void_min, is filled where that leaves all of it supported and the terms let matter be added; 0 (default): it stays as it is."
    };
    (sf_drain_options.stances) => {
        "Whose balance is to change least."
    };
    (sf_drain_options.void_min) => {
        "Voids of fewer voxels get none; 0 by default."
    };
    (sf_element) => {
        "A structuring element that is symmetric in x and in y and convex along rows.\n\nOffset (dx, dy) belongs to it when |dy| \\<= reach_y and |dx| \\<= half_width\\[|dy|\\]; half_width never grows with |dy|. A single voxel, the plus, the 3x3 square, ellipses and Minkowski sums of these are of this kind."
    };
    (sf_element_box3) => {
        "The 3x3 square.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_element_box3()`](crate::sys::sf_element_box3)"
    };
    (sf_element_ellipse: rx_q16, ry_q16) => {
        "Lattice points of the ellipse (dx / rx)^2 + (dy / ry)^2 \\<= 1, with radii in 1/65536 voxel.\n\nExact: no point is lost or won by rounding. A radius below a voxel gives no reach on its axis.\n\n- `rx_q16`: radius along x, in 1/65536 voxel\n- `ry_q16`: radius along y, in 1/65536 voxel\n- cost: O(rx + ry), in voxels.\n- threads: any.\n- in C: [`sf_element_ellipse()`](crate::sys::sf_element_ellipse)"
    };
    (sf_element_plus3) => {
        "The plus: a voxel and its four edge neighbours.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_element_plus3()`](crate::sys::sf_element_plus3)"
    };
    (sf_element_sum) => {
        "Minkowski sum of two elements: dilating by it is dilating by one and then by the other.\n\n- cost: the product of both reaches along y.\n- threads: any.\n- in C: [`sf_element_sum()`](crate::sys::sf_element_sum)"
    };
    (sf_exchange_is_served) => {
        "Whether this build reads and writes exchange files.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_exchange_is_served()`](crate::sys::sf_exchange_is_served)"
    };
    (sf_exchange_read: bytes_max) => {
        "Read an exchange file.\n\nWhat is there beside the layout is passed over, and nothing outside of the file is looked at: links to other places or files are refused. Every count is held against the size of the file before memory is taken. But libhdf5 itself was not made for files that mean harm: read those of strangers in a process of its own, with limits.\n\n- `bytes_max`: most bytes that are read; 0: 2^32\n- cost: the file and its contents are held in memory for a while.\n- threads: one at a time in a process, whatever uses libhdf5 included.\n- in C: [`sf_exchange_read()`](crate::sys::sf_exchange_read)"
    };
    (sf_exchange_write) => {
        "Write tetrahedra as an exchange file: the same bytes for the same tetrahedra.\n\n- cost: the compressor's; the file is held in memory, twice for a while, from the C library.\n- threads: one at a time in a process, whatever uses libhdf5 included.\n- source: C. Altenhofen and others, \"Continuous property gradation for multi-material 3D-printed objects\", 2018, \"Export and storage format\".\n- in C: [`sf_exchange_write()`](crate::sys::sf_exchange_write)"
    };
    (sf_findings_cost: grid, terms, added) => {
        "What fixing each finding of a check costs: voxels that a trim takes, voxels that growing adds.\n\ngrow_voxels is the size of a set of voxels that fixes the finding: once it is added every voxel of the finding's region is carried, and every voxel of the set by another or by the shape as drawn, down to the bed. So with the sets of all findings added the whole shape is support-free, and the sum of the costs bounds what repair by growth alone adds. The set is found greedily, so the figure is an upper bound; it is least where a region is one voxel and the rule is box3, octagon or disk. Matter below counts as a place to stand on even where it is lost itself: what it needs is the cost of its own finding.\n\nUnder slack the chains count on no reach but that of the step itself, and no rule's chains make use of bridges; both make the figure larger, never wrong.\n\n- `grid`: the shape\n- `terms`: rule and bed layer that the check had; voxels of `forbid`, and those outside `act`, are not added; `exempt` and `keep` are not looked at\n- `added`: NULL, or a grid that is set to all voxels that the sets hold together; neither the shape nor a mask\n- cost: 4 \\* reach passes over two bytes a voxel, and for each finding its region and what stands below it, not the rectangles around them, times the element and the logarithm of their sizes.\n- threads: any; the grids but `added` are only read.\n- source: the costs are the closest supporting paths of T. Reiner, S. Lefebvre, \"Interactive Modeling of Support-free Shapes for Fabrication\", Eurographics 2016, section 2.2, without the distance to the ground; V. Chvatal, \"A Greedy Heuristic for the Set-Covering Problem\", 1979.\n- in C: [`sf_findings_cost()`](crate::sys::sf_findings_cost)"
    };
    (sf_findings_rank: costs) => {
        "Order of findings by what they cost to fix: the dearest first.\n\nThe cost to fix a finding is the lesser of its two; of equal costs those come first that no other finding causes, then those with the lower index.\n\n- `costs`: their costs, or NULL\n- cost: n log n; no memory.\n- threads: any that write to distinct arrays.\n- in C: [`sf_findings_rank()`](crate::sys::sf_findings_rank)"
    };
    (sf_gltf_is_served) => {
        "Whether this build reads glTF.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_gltf_is_served()`](crate::sys::sf_gltf_is_served)"
    };
    (sf_gltf_read) => {
        "Read a glTF file, binary (.glb) or as text (.gltf), as one mesh, in mm with z up.\n\nThe mesh holds the triangles of the scene that the file shows first (without scenes, of all nodes), one vertex for each that the file has, times the nodes that show it; strips and fans become triangles; a node that mirrors turns its triangles, so that outside stays outside. Materials, colours, pictures, cameras and lights are passed over; skins, animations and shapes to blend to as well, and the report counts them. Positions may be interleaved, sparse, and whole numbers (KHR_mesh_quantization). Refused are files that require extensions which change the shape and are not served, such as compressed meshes.\n\nNo path is followed. A buffer may stand in the file itself or be a data: URI; another file's name is asked of `folder` only if it is plain (no separators, no \"..\", no scheme). Pictures are not decoded, and files named like them not opened. Before tinygltf sees it, JSON is held against bounds: 64 levels, 200,000 objects and lists, 2 million values; so its memory, which comes from the C++ library, is some hundred MiB at most beside a few times the file. But it was not made for files that mean harm, and ends the process where memory is too short to destroy its JSON: read files of strangers in a process of its own. Nodes may repeat a mesh, up to 64 times the bytes of the file and 256 MiB.\n\n- cost: one pass; the file is held in memory, its buffers twice for a while.\n- threads: any, on distinct sources; one at a time for each allocator.\n- source: The Khronos Group, \"glTF 2.0 Specification\", 2021.\n- in C: [`sf_gltf_read()`](crate::sys::sf_gltf_read)"
    };
    (sf_gltf_write) => {
        "Write a mesh as binary glTF, with a colour for each vertex or without.\n\nPositions are floats in mm; a node turns them to glTF's axes and metres. What [`sf_gltf_read()`](crate::sys::sf_gltf_read) makes of the file is the same floats again. Colours are given as they are shown on a screen (sRGB) and written as light (linear, 16 bits), which is how glTF has them. The material is matt and seen from both sides.\n\n- cost: one pass to check, one to write; 8 KiB of stack, no memory.\n- threads: any, on distinct sinks.\n- source: The Khronos Group, \"glTF 2.0 Specification\", 2021; IEC 61966-2-1, \"sRGB\", 1999.\n- in C: [`sf_gltf_write()`](crate::sys::sf_gltf_write)"
    };
    (sf_grid) => {
        "A stack of slices that owns its memory."
    };
    (sf_grid_body: density) => {
        "Body of the solid voxels of a grid, each as a box of its layer's height.\n\n- `density`: NULL for 1 everywhere, or what 1 mm3 weighs in each voxel, solid or not, in (layer, y, x) order: nx \\* ny \\* nz numbers. What is not solid is not looked at\n- cost: one pass over the grid; with densities, one over the solid voxels too.\n- threads: any.\n- in C: [`sf_grid_body()`](crate::sys::sf_grid_body)"
    };
    (sf_grid_bounds) => {
        "Smallest box around the solid voxels.\n\n- cost: one pass at most.\n- threads: any.\n- in C: [`sf_grid_bounds()`](crate::sys::sf_grid_bounds)"
    };
    (sf_grid_carve: wall, terms) => {
        "Carve a solid: result holds the wall, lies within the solid, and weighs as the stances need.\n\nSupport-free: what is supported in the solid, exempt voxels included, is supported in the result, under the whole rule; what hangs in the solid may hang on, and counts as exempt. Struts of strut_width_vx stand under what the wall does not carry itself; single voxels where no square fits, and all of them where under slack a step reaches less than a voxel along x or y. Without stances as little stays as is found. With stances, by the goal: the result is close to the best that any carving can do, and what it misses is the price of the struts (docs/balance.md has figures). Where the wall is closed around the inside, no piece floats.\n\nPlane, after the paper: with c the centre of mass and, for each stance with up u, c\\* the place nearest to it among those that are safe at its height, voxels that are not wall are sorted by d = sum over stances of max(0, (r - c\\*) . (c - c\\*)), taken across u; those with d above 0 are removed one by one from the largest d on, of equal ones the lowest layer, row and x first (d is told apart to one part in 2^32 of the largest), the energy, which is the sum of the squared distances to the c\\*, is followed through all of them, and the best prefix is kept. This is done again with the new c until every half-space holds (ENOUGH), or a round removes less than a thousandth of what could be, or does not improve. With [`SF_CARVE_ENOUGH`](crate::sys::SF_CARVE_ENOUGH) the best prefix is the first in which every half-space holds; with [`SF_CARVE_DEEPEST`](crate::sys::SF_CARVE_DEEPEST) it has the largest slack, and c\\* is the place of largest slack. Where nothing is safe at that height, c\\* is the place of largest slack as well. Without stances this mode carves nothing.\n\nThe order leaves no floating pieces around one plane in a solid with a wall all around; several rounds or stances may, so they are looked for.\n\n- `wall`: what must stay, within the solid; see [`sf_grid_wall()`](crate::sys::sf_grid_wall)\n- `terms`: support-free: rule, bed layer and exempt voxels; `keep` stays too, and nothing outside `act` is removed. NULL in mode plane, which looks at no terms\n- cost: plane: for each round a sort in linear time, and a step for each voxel and half-space. Support-free: some 20 sweeps over the solid's voxels without stances, and two more for each of some 10 to 60 questions with them: 82,500 voxels in 0.1 s, 808,000 in half a second.\n- threads: any that write distinct results.\n- source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, \"Make It Stand: Balancing Shapes for 3D Fabrication\", SIGGRAPH 2013, section 4 and equations 7 and 8.\n- in C: [`sf_grid_carve()`](crate::sys::sf_grid_carve)"
    };
    (sf_grid_check) => {
        "Check a whole grid: the streaming check, with every slice pushed from the bottom up.\n\nWidth, height and first layer of the options are the grid's, whatever stands there. Where run_capacity is 0 it is chosen so that all runs fit, so that volumes and causes are exact for all findings in the array. After a failing call the findings array is as it was.\n\n- cost: that of the pushes; more passes where a layer loses more than 262144 runs.\n- threads: any; the grid is only read.\n- in C: [`sf_grid_check()`](crate::sys::sf_grid_check)"
    };
    (sf_grid_clearance: surface) => {
        "How near the voxels of a grid come to a surface: of a cavity, how thick the wall around it is.\n\nThe least distance of any point of a solid voxel, as a box, to any point of a triangle; exact but for rounding, and 0 where a triangle comes within 2^-20 of a voxel or so.\n\n- `surface`: the triangles; they may reach beyond the lattice\n- cost: sorts the triangles; and for each voxel at the border of what is solid the triangles that lie as near as the nearest.\n- threads: any; the task's hook may run up to 16 pieces at once; one at a time for each allocator.\n- in C: [`sf_grid_clearance()`](crate::sys::sf_grid_clearance)"
    };
    (sf_grid_clone) => {
        "Make a copy of a grid.\n\n- cost: one pass.\n- threads: any that read; one at a time for each allocator.\n- in C: [`sf_grid_clone()`](crate::sys::sf_grid_clone)"
    };
    (sf_grid_complete: needed) => {
        "A support-free part of a shape that holds what must stay.\n\nFrom the top down, each layer asks the one below for what its voxels need: first of what must stay there anyway, then of as few others as a greedy set cover finds. Of equals the lowest row is taken, and in it the lowest x.\n\n- `needed`: what must stay, within the shape\n- cost: some twenty passes over the grid, under slack five trims, and for each voxel that may carry what hangs the element and a few steps of a heap. 512^3 under box3: 60 ms.\n- threads: any that write distinct results.\n- source: P. Slavik, \"A tight analysis of the greedy algorithm for set cover\", 1996 (greedy); that one sweep serves every monotone rule is the library's own.\n- in C: [`sf_grid_complete()`](crate::sys::sf_grid_complete)"
    };
    (sf_grid_cover: surface) => {
        "A solid together with the voxels that a surface touches: a domain that holds all of the surface.\n\nWhat of the surface leaves the lattice is not covered.\n\n- `surface`: the triangles that bound them, in the lattice's frame\n- cost: as [`sf_grid_voxelize()`](crate::sys::sf_grid_voxelize) with [`SF_FILL_SURFACE`](crate::sys::SF_FILL_SURFACE).\n- threads: any; one at a time for each allocator.\n- in C: [`sf_grid_cover()`](crate::sys::sf_grid_cover)"
    };
    (sf_grid_create: lattice) => {
        "Make a grid with all voxels empty on a lattice, which is copied, heights included.\n\n- `lattice`: where the voxels lie; copied\n- cost: one pass over new memory.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_grid_create()`](crate::sys::sf_grid_create)"
    };
    (sf_grid_drain: terms) => {
        "Drill a hole into every void that is closed, in place: what is in it can leave.\n\nA void is closed when its empty voxels, connected through faces, touch no side of the grid, nor its top or bottom: the bed is open once the part is off it. Its holes start where a disk of the diameter fits into it, and go straight down until all of the disk is in the open, the holes of other voids included; voids that they pass through are open then too. Where none may be drilled straight, holes go down aslant, in eight directions, as flat as the rule lets ceilings be. Of all places the one is taken whose volume, times its distance from the centre of mass across up where there are stances (the largest of them), is least.\n\nWith terms no hole is drilled that leaves anything unsupported that was supported before it, exempt voxels included, that takes a voxel of `keep`, or one outside `act`; and no void is filled that reaches into `forbid`, or out of `act`. Where no place will do, a hole may take with it what would hang around its lower end, as long as that is no more than a quarter of the hole.\n\n- `terms`: rule, bed layer and masks; NULL: nothing needs support\n- cost: for each hole, and each place that was tried in vain, at most 64 for a void, a trim.\n- threads: one per grid.\n- in C: [`sf_grid_drain()`](crate::sys::sf_grid_drain)"
    };
    (sf_grid_emit) => {
        "Put a brush on every voxel of a path, and leave out of it what would hang in the air.\n\nWhat was solid stays, whatever carries it. What is added is carried, by what was there or by what is added; so the result is support-free if the shape was. The path itself is always added, with or without the brush's anchor.\n\n- cost: the brush's rows for each voxel of the path, and a trim of the layers it meets; under slack of all layers up to there.\n- threads: one per grid.\n- source: T. Reiner, S. Lefebvre, \"Interactive Modeling of Support-free Shapes for Fabrication\", Eurographics 2016, section 2.2 (grow); that what is added must be trimmed is the library's own.\n- in C: [`sf_grid_emit()`](crate::sys::sf_grid_emit)"
    };
    (sf_grid_equal) => {
        "Whether two grids have the same counts and the same solid voxels; lengths are not compared.\n\n- cost: one pass, up to the first row that differs.\n- threads: any.\n- in C: [`sf_grid_equal()`](crate::sys::sf_grid_equal)"
    };
    (sf_grid_feasible: needed) => {
        "Whether something that must stay can be carried within what may be there; and if not, what of it cannot.\n\nA support-free shape R with needed within R within allowed exists just when needed lies within the trim of `allowed`. Each voxel that does not is a culprit: it cannot be carried even alone, and giving up or exempting just the culprits makes the rest possible. True for every rule.\n\n- `needed`: voxels that must be; what of them is not allowed is a culprit\n- cost: a trim.\n- threads: any; the grids but culprits are only read.\n- source: the greatest support-free subset is unique because support-free sets are closed under union.\n- in C: [`sf_grid_feasible()`](crate::sys::sf_grid_feasible)"
    };
    (sf_grid_foot: up, height_mm) => {
        "The foot of a solid: its voxels that lie lowest, seen against a direction.\n\n- `up`: the direction that points up, of any length from 1e-100 to 1e100; +z is not special\n- `height_mm`: how far above the lowest centre of a voxel the centres of the foot may lie; at least 0\n- cost: two passes over the solid voxels.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_grid_foot()`](crate::sys::sf_grid_foot)"
    };
    (sf_grid_from_contours: lattice) => {
        "Draw a stack into a new grid, layer by layer.\n\n- `lattice`: where voxels lie, with as many layers as the stack; heights and z are copied, but not compared\n- cost: [`sf_slice_from_contours()`](crate::sys::sf_slice_from_contours) for each layer.\n- threads: any that read; one at a time for each allocator.\n- in C: [`sf_grid_from_contours()`](crate::sys::sf_grid_from_contours)"
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
    (sf_grid_printing) => {
        "How far from toppling a part is, after each of its layers.\n\nFor every layer k from the bed up, take what is solid from the bed to k, and each connected piece of it that has voxels in the bed layer. It stands on the convex hull of its voxels' squares there; its margin is the least angle by which the bed must be tilted for its centre of mass to pass over an edge of that hull. All voxels have one density, each layer its own height. The margin of layer k is the least over the pieces; below the bed, and where no piece has voxels on the bed, it is 90 degrees.\n\nPieces that float are counted, and do not count in margins until they are connected with one that stands; [`sf_grid_check()`](crate::sys::sf_grid_check) says more about them.\n\nSums are integers: with layers of one height the centre of mass is exact before its last division; heights of layers are rounded to 2^-40 of the whole, and up to it where they are less.\n\n- cost: nearly linear in the runs of all layers, and, for each layer, in the pieces on the bed.\n- threads: any; one at a time for each allocator.\n- source: the margin: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, \"Make It Stand\", 2013, section 3; the pieces: R. E. Tarjan, \"Efficiency of a Good But Not Linear Set Union Algorithm\", 1975.\n- in C: [`sf_grid_printing()`](crate::sys::sf_grid_printing)"
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
    (sf_grid_trim_box: box) => {
        "Bring `printable` = trim(`drawn`) up to date after `drawn` changed within `box`.\n\nBefore the change `printable` was the trim of `drawn`, by the same rule and bed layer; after this call it is again, bit for bit what [`sf_grid_trim()`](crate::sys::sf_grid_trim) of `drawn` gives. Under slack everything is trimmed anew, because what a voxel has to spare is not kept. Else only what can have changed is looked at: the box, and above it what rests on voxels that did change, up to the first layer where none did. Matter may have been added and removed; parts that were trimmed earlier come back where there is support for them now.\n\n`drawn` and `printable` may be one grid, if the change only removed matter and the grid was support-free before it.\n\nWhere bed_layer is [`SF_BED_AUTO`](crate::sys::SF_BED_AUTO) and the change moved the first layer that holds matter, everything is recomputed.\n\n- `box`: a box around the change, within the grid; an empty one changes nothing\n- cost: the volume of the boxes around the change in each layer, grown by the rule's reach and with bridges by their span and anchor; under slack a trim.\n- threads: one per pair of grids.\n- in C: [`sf_grid_trim_box()`](crate::sys::sf_grid_trim_box)"
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
    (sf_grid_wall: surface, wall_mm) => {
        "The wall of a solid: its voxels of which any point is nearer than a thickness to a surface.\n\nVoxels are boxes, and the distance of a box to a triangle is exact but for rounding: a voxel of the solid that is not wall has no point nearer than wall_mm, less one part in 2^40 of the largest coordinate. So much is forgiven, so that walls are whole voxels where the surface lies along the lattice. Of a surface that is not closed only its triangles count: unite this wall with that of [`sf_grid_wall_inside()`](crate::sys::sf_grid_wall_inside). Triangles inside of the solid, where shells run through each other, have a wall around them as well.\n\n- `surface`: its surface; it may reach beyond the lattice\n- `wall_mm`: thickness; 0 gives no wall\n- cost: sorts the triangles; some reach \\* reach passes over bits, with the reach of the wall in voxels; and for about one layer of voxels each the triangles that lie just so far.\n- threads: any that write distinct walls; the task's hook may run up to 16 pieces at once; one at a time for each allocator.\n- in C: [`sf_grid_wall()`](crate::sys::sf_grid_wall)"
    };
    (sf_grid_wall_inside: wall_mm) => {
        "The wall of a solid without a mesh: its voxels that are nearer than a thickness to what is not solid, the outside of the grid included.\n\nThe distance is the gap between two boxes, less the same that [`sf_grid_wall()`](crate::sys::sf_grid_wall) forgives.\n\n- `wall_mm`: thickness; 0 gives no wall\n- cost: reach \\* reach passes over bits, with the reach of the wall in voxels.\n- threads: any that write distinct walls.\n- in C: [`sf_grid_wall_inside()`](crate::sys::sf_grid_wall_inside)"
    };
    (sf_halftone) => {
        "A mask made ready for a number of materials. Slices are made from it at any time, in any order, by any number of threads."
    };
    (sf_halftone_create: material_count) => {
        "Make a mask ready.\n\n- `material_count`: 2..[`SF_MATERIAL_MAX`](crate::sys::SF_MATERIAL_MAX)\n- cost: a pass over the mask.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_halftone_create()`](crate::sys::sf_halftone_create)"
    };
    (sf_halftone_slice) => {
        "Halftone a rectangle of a slice: a row, a tile or all of it, whichever comes first.\n\nTones of solid voxels are at least 0 and add up to at most 1 (with 1e-6 to spare) or 255.\n\n- cost: one pass over the tones; two over those that can be wrong: all but the bytes of two materials. No memory.\n- threads: any, on distinct materials.\n- source: R. Ulichney, \"Digital Halftoning\", 1987, ordered dither.\n- in C: [`sf_halftone_slice()`](crate::sys::sf_halftone_slice)"
    };
    (sf_handle) => {
        "A place of a solid that is posed. Cells are those of [`sf_weights_facts`](crate::sys::sf_weights_facts)."
    };
    (sf_handle.at_mm) => {
        "Its centre: what it turns and scales about."
    };
    (sf_handle.locked) => {
        "1: whoever looks for poses leaves this handle's alone."
    };
    (sf_handle.region) => {
        "Of a base: its voxels, on the solid's lattice; else not looked at."
    };
    (sf_handle_base) => {
        "A base that is held: a locked handle of a region, its centre the centre of the region's voxels.\n\n- cost: one pass over the grid.\n- threads: any.\n- in C: [`sf_handle_base()`](crate::sys::sf_handle_base)"
    };
    (sf_handle_center: from_mm, direction) => {
        "The middle of the solid behind a point, as one who points at a surface means it.\n\nThe ray runs from the point, which may lie anywhere within 1e12 mm, and ends where it first leaves the solid voxels that it has entered. The middle of that stretch is the place of the handle.\n\n- `from_mm`: where the ray begins: on the surface, before it, or in the solid\n- `direction`: where it runs, of any length but 0\n- cost: the voxels that the ray passes.\n- threads: any.\n- source: the paper's section 5; J. Amanatides, A. Woo, \"A Fast Voxel Traversal Algorithm for Ray Tracing\", Eurographics 1987.\n- in C: [`sf_handle_center()`](crate::sys::sf_handle_center)"
    };
    (sf_handle_center_by_rays: from_mm, direction) => {
        "The middle of the solid behind a point, by rays instead of voxels: [`sf_handle_center()`](crate::sys::sf_handle_center) of a surface.\n\nWhere the surface goes through itself, the ray leaves the solid when it has left as often as it entered. A ray that leaves first begins inside.\n\n- `from_mm`: where the ray begins\n- `direction`: where it runs, of any length but 0\n- cost: one call of the caster for each hit.\n- threads: as the caster.\n- source: as [`sf_handle_center()`](crate::sys::sf_handle_center).\n- in C: [`sf_handle_center_by_rays()`](crate::sys::sf_handle_center_by_rays)"
    };
    (sf_handles_place) => {
        "Place handles by themselves: deep in the solid, far from the base and from each other.\n\nPlaces are cells that lie at least as deep as their neighbours; when these are used up, cells at least half as deep as the deepest. Without a base the first handle takes the deepest of all. Each of the others takes the place that is furthest from what is taken, on the way through the solid, with the depth of the place added. No two handles lie within three cells of each other or of the base. The result is the same everywhere.\n\n- cost: n log n of the cells for each handle.\n- threads: any; one at a time for each allocator.\n- source: T. F. Gonzalez, \"Clustering to Minimize the Maximum Intercluster Distance\", 1985.\n- in C: [`sf_handles_place()`](crate::sys::sf_handles_place)"
    };
    (sf_isa_limit) => {
        "Use no instruction set above `limit`, for tests and benches; results never depend on it.\n\n- cost: constant.\n- threads: any; work under way elsewhere may end on the old set.\n- in C: [`sf_isa_limit()`](crate::sys::sf_isa_limit)"
    };
    (sf_job) => {
        "A job being read."
    };
    (sf_job_describe) => {
        "What a job says of itself.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_job_describe()`](crate::sys::sf_job_describe)"
    };
    (sf_job_has_sl1) => {
        "Whether this build reads and writes SL1, which takes libspng and zlib; .photon is always read.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_job_has_sl1()`](crate::sys::sf_job_has_sl1)"
    };
    (sf_job_lattice) => {
        "The lattice of a job: its pixels, its layers and their heights; its corner is 0, 0, 0.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_job_lattice()`](crate::sys::sf_job_lattice)"
    };
    (sf_job_open) => {
        "Open a job: everything but the pictures' pixels is read and checked.\n\nWhich format it is the first bytes say. No name in it ever becomes a path, and no number is believed before the bytes that it speaks of are there. What would make two readers see two jobs is refused: entries that overlap or come twice, pictures of several sizes, layers that are missing. An SL1 job says its pixels in prusaslicer.ini; where that is missing, pictures of 1440 x 2560 are taken for the SL1's own (0.04725 mm), and others must be told of in the options.\n\n- cost: the directory, and the head of each picture; libspng takes its memory from the C library.\n- threads: any, on distinct bytes; one at a time for each allocator.\n- in C: [`sf_job_open()`](crate::sys::sf_job_open)"
    };
    (sf_job_options) => {
        "How a job is understood. Fill with [`sf_job_options_default()`](crate::sys::sf_job_options_default)."
    };
    (sf_job_options.bytes_max) => {
        "Most bytes of the file (default 64 GiB)."
    };
    (sf_job_options.layers_max) => {
        "Most layers (default 1e6)."
    };
    (sf_job_read: k, slice) => {
        "Decode a layer as it is exposed: solid where a pixel has at least the threshold.\n\n- `k`: the layer\n- `slice`: written, of the job's nx and ny; on failure its voxels are not to be used\n- cost: one pass over its bytes and pixels.\n- threads: one per job.\n- in C: [`sf_job_read()`](crate::sys::sf_job_read)"
    };
    (sf_job_read_grey: k, pixels, row_bytes) => {
        "Decode a layer as greys: colours count as bright as they look, and what is transparent is black.\n\n- `k`: the layer\n- `pixels`: written, a byte each, row 0 the lowest; on failure not to be used\n- `row_bytes`: bytes from one row to the next, at least nx\n- cost: as [`sf_job_read()`](crate::sys::sf_job_read).\n- threads: one per job.\n- in C: [`sf_job_read_grey()`](crate::sys::sf_job_read_grey)"
    };
    (sf_job_rewrite: grid) => {
        "Write an SL1 job again with the layers of a grid, and everything else byte for byte.\n\nLayers whose voxels are as they were are copied as they lie in the archive, and so is every other entry: compressed bytes, dates, attributes, comments. A layer that differs becomes a new picture under its name, 8 bits of grey, stored: what was added is 255, what was taken away 0, with the dim rim around it, up to 8 pixels wide, that touches nothing which is left. All other greys stay.\n\n- `grid`: the new layers, with the job's counts\n- cost: each layer is decoded once, those that differ once more and encoded; a layer of bytes and five of bits.\n- threads: one per job.\n- in C: [`sf_job_rewrite()`](crate::sys::sf_job_rewrite)"
    };
    (sf_keep_field) => {
        "Whether what is at a place of the shape as it was before bending must stay: 1, or 0 where it may be carved away. Asked once a round for each voxel."
    };
    (sf_keep_out.where) => {
        "Of the rectangle's size: solid where it must not be."
    };
    (sf_lattice) => {
        "Where the voxels of a grid lie. The lower corner of voxel (0, 0, 0) is at origin_mm."
    };
    (sf_lattice_density) => {
        "What 1 mm3 of each voxel weighs.\n\n- cost: one pass over the voxels for each region, and one more.\n- threads: any that write distinct arrays.\n- in C: [`sf_lattice_density()`](crate::sys::sf_lattice_density)"
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
    (sf_layers) => {
        "Layers being written."
    };
    (sf_layers_add: ids, stride) => {
        "Write the next layer up: layer_00000.png and so on.\n\n- `ids`: a byte a voxel, row 0 first: 0, or material + 1, as [`sf_materials`](crate::sys::sf_materials) has them\n- `stride`: bytes from one row to the next, at least nx\n- cost: a pass, mostly in the compressor, which takes its memory from the C library.\n- threads: one for these layers.\n- in C: [`sf_layers_add()`](crate::sys::sf_layers_add)"
    };
    (sf_layers_begin: lattice, materials) => {
        "Begin to write layers.\n\nPixels are nx by ny, x to the right and y upward, as in [`sf_stack_write()`](crate::sys::sf_stack_write). Entry 0 of the palette is empty space, black and transparent; entry i + 1 is material i.\n\n- `lattice`: where voxels lie; copied\n- `materials`: the materials, in the order of ids; copied; names differ\n- cost: O(nz).\n- threads: any; one at a time for each allocator.\n- in C: [`sf_layers_begin()`](crate::sys::sf_layers_begin)"
    };
    (sf_layers_finish) => {
        "Write stack.json, when all layers are there.\n\n```text\n    {\"format\": \"libsf-stack\", \"version\": 3, \"units\": \"mm\", \"lattice\": as sf_stack_write() has it,\n     \"rule\": null,\n     \"layers\": {\"pattern\": \"layer_%05u.png\", \"count\": nz},\n     \"materials\": [{\"index\": 1, \"name\", \"colour\": \"#rrggbb\", \"density_g_cm3\" or null,\n                    \"voxels\", \"volume_mm3\", \"grams\" or null}, ...],\n     \"solid\": \"not 0\", \"row_order\": \"top_is_max_y\"}\n```\n\n- cost: O(nz).\n- threads: one for these layers.\n- in C: [`sf_layers_finish()`](crate::sys::sf_layers_finish)"
    };
    (sf_limit) => {
        "A cage with all that evaluation needs."
    };
    (sf_limit_bounds) => {
        "A box that holds the shape of a limit of dimension 3, and is hardly larger.\n\n- cost: a microsecond or two for each vertex of the surface.\n- threads: any, while nobody updates the limit; one at a time for each allocator.\n- in C: [`sf_limit_bounds()`](crate::sys::sf_limit_bounds)"
    };
    (sf_limit_check) => {
        "Look whether a shape of dimension 3 lies the right way out everywhere.\n\n- cost: 50 microseconds for a regular piece, up to some milliseconds for others.\n- threads: any, while nobody updates; one at a time for each allocator.\n- source: A. Johnen, J.-F. Remacle, C. Geuzaine, \"Geometrical validity of curvilinear finite elements\", 2013.\n- in C: [`sf_limit_check()`](crate::sys::sf_limit_check)"
    };
    (sf_limit_create) => {
        "Prepare a cage for evaluation.\n\n- cost: some 10 microseconds for each piece, and a millisecond for each kind of irregular neighbourhood; where n cells meet in a point or an edge time and memory grow with n^2: a thousand take a tenth of a second, four thousand two seconds and 200 MB.\n- threads: any; one at a time for each allocator.\n- source: as [`sf_refine()`](crate::sys::sf_refine); the left eigenvectors after M. Halstead, M. Kass, T. DeRose, \"Efficient, fair interpolation using Catmull-Clark surfaces\", 1993; what comes of irregular cells after J. Stam, \"Exact evaluation of Catmull-Clark subdivision surfaces at arbitrary parameter values\", 1998, without his eigenvalues: by going down.\n- in C: [`sf_limit_create()`](crate::sys::sf_limit_create)"
    };
    (sf_limit_piece_count) => {
        "Number of pieces: that of the corners of all cells; 0 for NULL.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_limit_piece_count()`](crate::sys::sf_limit_piece_count)"
    };
    (sf_limit_place: cell, u) => {
        "The place at parameters of a whole cell of the cage: a hexahedron, in dimension 2 a quadrilateral.\n\n- `cell`: the cell\n- `u`: 0 to 1 along the axes from its first corner to its second, fourth and fifth; in dimension 2 the third is not looked at\n- cost: constant.\n- threads: any.\n- in C: [`sf_limit_place()`](crate::sys::sf_limit_place)"
    };
    (sf_limit_positions: places) => {
        "Where places lie.\n\nParameters a little outside of 0 to 1, by 1e-9, are taken for those of the border. On an irregular edge or point derivatives by parameters tend to 0 or grow without bound; there they are those over a millionth of a piece next to it.\n\n- `places`: the places\n- cost: a third of a microsecond in regular pieces; elsewhere some 5 for each level, of which random places need one or two and the worst ones 48.\n- threads: any, while nobody updates; one at a time for each allocator.\n- in C: [`sf_limit_positions()`](crate::sys::sf_limit_positions)"
    };
    (sf_limit_update_positions: positions) => {
        "Take new positions from the cage.\n\n- `positions`: 3 for each of the cage's points, mm, finite and within 10^12\n- cost: one step of refinement.\n- threads: one for each limit.\n- in C: [`sf_limit_update_positions()`](crate::sys::sf_limit_update_positions)"
    };
    (sf_limit_update_values: channel, values) => {
        "Take new values of a property from the cage.\n\n- `channel`: which property\n- `values`: as many as the property has in the cage, finite and within its bounds\n- cost: one step of refinement.\n- threads: one for each limit.\n- in C: [`sf_limit_update_values()`](crate::sys::sf_limit_update_values)"
    };
    (sf_limit_values: channel, places) => {
        "What a property is at places.\n\n- `channel`: which property\n- `places`: the places\n- cost: ,\n- threads: as [`sf_limit_positions()`](crate::sys::sf_limit_positions).\n- in C: [`sf_limit_values()`](crate::sys::sf_limit_values)"
    };
    (sf_locator) => {
        "What it takes to find places: boxes around all pieces."
    };
    (sf_locator_create) => {
        "Prepare a limit of dimension 3 for searches.\n\n- cost: a microsecond for each piece.\n- threads: any, while nobody updates the limit; one at a time for each allocator.\n- in C: [`sf_locator_create()`](crate::sys::sf_locator_create)"
    };
    (sf_locator_find: points, reach_mm) => {
        "Find the places of points.\n\nOf a point within the shape the place found lies within 1e-10 of the cage's diagonal of it. Where the shape overlaps itself it is any of them. Of a point outside the place found is near to the nearest one, if that is within reach. Where cells are folded flat, so that endlessly many places are equally near, the search ends after a hundred thousand tries: with the nearest seen, or none.\n\n- `points`: 3 numbers of each, mm, finite\n- `reach_mm`: how far outside of the shape a point may be, 0 and more\n- cost: some ten microseconds for each point; hundreds close to what is irregular, or outside within reach; some hundreds of milliseconds at worst, where cells are folded flat.\n- threads: any, while nobody updates the limit; one at a time for each allocator.\n- in C: [`sf_locator_find()`](crate::sys::sf_locator_find)"
    };
    (sf_mask) => {
        "A block of ranks, repeated along x, y and z."
    };
    (sf_mask_builtin) => {
        "The mask of 32 x 32 x 32 voxels that is part of the library: what the default options make.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_mask_builtin()`](crate::sys::sf_mask_builtin)"
    };
    (sf_mask_create) => {
        "Make a mask by void and cluster: the same ranks for the same options, on every machine.\n\n- cost: about linear in the voxels: 32^3 takes 0.1 s, 64^3 1.5 s.\n- threads: any; one at a time for each allocator.\n- source: R. Ulichney, \"The void-and-cluster method for dither array generation\", 1993; for slices A. Wolfe, N. Morrical, T. Akenine-Moeller, R. Ramamoorthi, \"Spatiotemporal Blue Noise Masks\", 2022.\n- in C: [`sf_mask_create()`](crate::sys::sf_mask_create)"
    };
    (sf_mask_from_ranks: ranks) => {
        "Make a mask from ranks that were kept, in (layer, y, x) order.\n\n- `ranks`: nx \\* ny \\* nz numbers: each of 0 .. nx \\* ny \\* nz - 1 once\n- cost: one pass.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_mask_from_ranks()`](crate::sys::sf_mask_from_ranks)"
    };
    (sf_mask_options) => {
        "How a mask is made. Fill with [`sf_mask_options_default()`](crate::sys::sf_mask_options_default)."
    };
    (sf_mask_options.pitch_mm) => {
        "Of a voxel; 1 each; no two differ by a factor above 64."
    };
    (sf_mask_options.seed) => {
        "Another seed, another mask: 0."
    };
    (sf_mask_options.spread) => {
        "Standard deviation of the Gaussian that keeps voxels apart, in mean pitches (geometric: of x and y, or of all three); 0.5..4, 1.5."
    };
    (sf_mask_rank) => {
        "The rank at a voxel, anywhere: the mask is repeated.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_mask_rank()`](crate::sys::sf_mask_rank)"
    };
    (sf_mask_size) => {
        "The period of a mask along x, y and z, in voxels.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_mask_size()`](crate::sys::sf_mask_size)"
    };
    (sf_material) => {
        "What a material is called, looks like and weighs."
    };
    (sf_material_uses: counts, material_count, density_g_cm3) => {
        "Voxels, volume and grams of each material, from the counts of each layer.\n\n- `counts`: lattice-\\>nz times material_count numbers: those of [`sf_materials`](crate::sys::sf_materials), layer after layer\n- `material_count`: 1..255\n- `density_g_cm3`: of each material, 0 or more; NULL: no masses, 0\n- cost: one pass over the counts, in their order: the same bytes everywhere.\n- threads: any.\n- in C: [`sf_material_uses()`](crate::sys::sf_material_uses)"
    };
    (sf_mesh) => {
        "A mesh that owns its arrays and can be appended to."
    };
    (sf_mesh_analyze) => {
        "How the triangles of a mesh hang together: holes, edges of too many triangles, shells, sense.\n\nVertices of equal position are one point, in the sense of [`sf_mesh_merge()`](crate::sys::sf_mesh_merge); the mesh itself need not be merged. Triangles with fewer than three points are counted, and take no further part.\n\n- cost: nearly linear in vertices and triangles.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_mesh_analyze()`](crate::sys::sf_mesh_analyze)"
    };
    (sf_mesh_body: density) => {
        "Body of the solid that a closed mesh bounds.\n\n- `density`: what 1 mm3 weighs; finite\n- cost: two passes over the triangles.\n- threads: any.\n- source: [`sf_mesh_measure()`](crate::sys::sf_mesh_measure).\n- in C: [`sf_mesh_body()`](crate::sys::sf_mesh_body)"
    };
    (sf_mesh_body_gradient: density) => {
        "Gradient of the mass and the first moments of a closed mesh by its vertices.\n\n- `density`: what 1 mm3 weighs; finite\n- cost: one pass over the triangles, after one over the vertices.\n- threads: any that write distinct arrays.\n- source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, \"Make It Stand: Balancing Shapes for 3D Fabrication\", SIGGRAPH 2013, appendix, with diag(v_i + v_j + v_k + v_p) for the derivative of g.\n- in C: [`sf_mesh_body_gradient()`](crate::sys::sf_mesh_body_gradient)"
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
    (sf_mesh_orient) => {
        "Find the ways up in which a part prints best, the best one first.\n\nThree rounds. Directions over the sphere are ranked by the area that hangs over and by height; the best coarse_count of them, the axes and the large flat faces by their score at the coarse resolution; the best fine_count of those, and the mesh as it is given, by their score at the fine one. Of equal scores the one with less unsupported area is better, then the one that was thought of earlier: the way it is given, the other axes, the large flat faces, the sphere. So the result is one and the same everywhere, with any number of threads; and it is never worse than the mesh as it is given.\n\nWhat touches the bed is the lowest layer of voxels; the centre of mass is that of the voxels.\n\n- cost: direction_count passes over the mesh; coarse_count + fine_count times voxels and a trim.\n- threads: any; the task's hook may run up to 64 pieces at once.\n- source: the spread of directions is R. Swinbank, R. J. Purser, \"Fibonacci grids: A novel approach to global modelling\", 2006; the cheap score is that of C. Schranz, \"Tweaker - Auto Rotation Module for FDM 3D Printing\", 2016, without its weights.\n- in C: [`sf_mesh_orient()`](crate::sys::sf_mesh_orient)"
    };
    (sf_mesh_read: format) => {
        "Read a mesh from any source of bytes: STL, OBJ, PLY, OFF, 3MF or glTF.\n\nCoordinates are taken as they are, as mm. Polygons become fans about their first corner. What is no triangle and no vertex (normals, colours, materials, lines, unknown elements) is passed over. STL has no shared vertices, so every facet brings three of its own; [`sf_mesh_merge()`](crate::sys::sf_mesh_merge) joins them. Of 3MF, which has units and a build, the whole build becomes one mesh in mm, as [`sf_threemf_read()`](crate::sys::sf_threemf_read) and [`sf_threemf_merge()`](crate::sys::sf_threemf_merge) do it.\n\nglTF says which way is up: it is turned to mm with z up, as [`sf_gltf_read()`](crate::sys::sf_gltf_read) says, which also reads buffers in other files. Its text form is not told from others by its bytes.\n\nNo count in a file is believed: memory grows as the bytes come. A binary STL file is as long as its count says or longer (a count of 0 or 2^32 - 1 means: to the end); text STL ends with endsolid; a file that is shorter is refused, because half a part looks like a whole one. So are coordinates that are not finite, faces of fewer than three corners, corners that name no vertex, and files without a triangle. Numbers are read exactly, whatever the locale.\n\n- `format`: the format, or [`SF_MESH_FORMAT_AUTO`](crate::sys::SF_MESH_FORMAT_AUTO) to judge by the first 4096 bytes\n- cost: one pass over the file; while it grows, memory for two and a half times the mesh.\n- threads: any, on distinct sources; one at a time for each allocator.\n- source: 3D Systems, \"StereoLithography Interface Specification\", 1989; Wavefront, \"Object Files\"; G. Turk, \"The PLY Polygon File Format\", 1994; the Geomview manual, \"OFF Files\".\n- in C: [`sf_mesh_read()`](crate::sys::sf_mesh_read)"
    };
    (sf_mesh_rest: com_mm, ups) => {
        "Where a body comes to rest that is put on level ground in some orientation, and let go.\n\nIt rolls on its convex hull as a body that tips slowly, neither slides nor gains momentum: it tips about the point of what touches the ground that is nearest to the centre of mass seen from above, an edge or a corner, until more of it touches; and so on, until the centre of mass lies over what it touches the ground with. That is the steepest descent of the height of the centre of mass over all orientations, and ends in a local minimum. A start that is balanced on an edge or a corner falls to one side, always the same. Corners within a millionth of the diagonal above the lowest one touch.\n\nA body that is flat lies down on a side; one without any width comes to rest as it lies.\n\n- `com_mm`: its centre of mass, in its convex hull (to a millionth of the diagonal)\n- `ups`: of each start, the direction of the mesh that points up, of any length from 1e-100 to 1e100\n- cost: typically n log n for n vertices; for each start and edge or corner it tips over, one pass over the corners of the hull.\n- threads: any; one at a time for each allocator.\n- source: hull: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, \"The Quickhull Algorithm for Convex Hulls\", 1996; rolling: M. Goldberg, R. K. Guy, \"Stability of Polyhedra (J. H. Conway and R. K. Guy)\", 1969.\n- in C: [`sf_mesh_rest()`](crate::sys::sf_mesh_rest)"
    };
    (sf_mesh_transform) => {
        "Apply an affine map to every vertex; a map that mirrors turns every triangle around.\n\n- cost: two passes over the vertices, one over the triangles of a mirrored mesh.\n- threads: one per mesh.\n- in C: [`sf_mesh_transform()`](crate::sys::sf_mesh_transform)"
    };
    (sf_mesh_validate) => {
        "Check a view: arrays where there are counts, indices in range, coordinates finite.\n\n- cost: linear.\n- threads: any.\n- in C: [`sf_mesh_validate()`](crate::sys::sf_mesh_validate)"
    };
    (sf_mesh_write: format) => {
        "Write a mesh as binary STL, OBJ, binary little-endian PLY, 3MF or binary glTF.\n\nOBJ and PLY keep every bit of every coordinate: OBJ as the fewest of 15 to 17 digits that read back as the same double, PLY as doubles. STL has floats and unit normals; vertices that are equal stay equal. glTF is what [`sf_gltf_write()`](crate::sys::sf_gltf_write) writes, without colours; 3MF has one object, as [`sf_threemf_write()`](crate::sys::sf_threemf_write) writes it. Everything is checked before the first byte is written.\n\n- `format`: [`SF_MESH_FORMAT_STL`](crate::sys::SF_MESH_FORMAT_STL), _OBJ, _PLY, _THREEMF or _GLTF\n- cost: one pass to check, one to write; 8 KiB of stack, and 300 KiB of memory for 3MF alone.\n- threads: any, on distinct sinks.\n- in C: [`sf_mesh_write()`](crate::sys::sf_mesh_write)"
    };
    (sf_mixture) => {
        "Measured mixtures, and what lies between them."
    };
    (sf_mixture_create) => {
        "Span the space of fractions by simplices whose corners are the measured mixtures.\n\nThe simplices are those of Delaunay; where that leaves a choice, as on a regular pattern, a fixed one is made. They fill the convex hull of what was measured, so measure the pure materials too.\n\n- cost: all simplices that could be made are looked at: up to some seconds.\n- threads: any; one at a time for each allocator.\n- source: B. Delaunay, \"Sur la sphere vide\", 1934; K. Q. Brown, \"Voronoi diagrams from convex hulls\", 1979.\n- in C: [`sf_mixture_create()`](crate::sys::sf_mixture_create)"
    };
    (sf_mixture_fractions: wanted, hint) => {
        "Which fractions have the wanted properties: backwards; or the nearest properties that some have.\n\nErrors are measured in scales of each property, squared and added. Where several mixtures do equally well it is one in the first simplex that holds one: fewer properties than materials less one leave such a choice.\n\n- `wanted`: one number for each property\n- `hint`: NULL, or the simplex to look in first, which receives where the answer was: for many points that lie together. Where several simplices have what is wanted, it decides; any number will do to begin with.\n- cost: a small linear system where the hint is right, else up to one for each face of each simplex.\n- threads: any; one at a time for each hint.\n- in C: [`sf_mixture_fractions()`](crate::sys::sf_mixture_fractions)"
    };
    (sf_mixture_properties: fractions, miss) => {
        "What properties a mixture has: forwards, from fractions.\n\n- `fractions`: one for each material; those that lie in no simplex are replaced by the nearest that do\n- `miss`: NULL, or receives how far the fractions lay from the nearest: 0 within\n- cost: a small linear system for each simplex.\n- threads: any.\n- in C: [`sf_mixture_properties()`](crate::sys::sf_mixture_properties)"
    };
    (sf_mixture_simplex: simplex) => {
        "The corners of a simplex: as many measured mixtures as there are materials, in rising order.\n\n- `simplex`: which, below [`sf_mixture_simplex_count()`](crate::sys::sf_mixture_simplex_count)\n- cost: constant.\n- threads: any.\n- in C: [`sf_mixture_simplex()`](crate::sys::sf_mixture_simplex)"
    };
    (sf_mixture_simplex_count) => {
        "How many simplices there are.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_mixture_simplex_count()`](crate::sys::sf_mixture_simplex_count)"
    };
    (sf_paint_brush) => {
        "A brush: a ball, or what a ball sweeps that is drawn along a line. Make one with [`sf_paint_brush_default()`](crate::sys::sf_paint_brush_default)."
    };
    (sf_paint_brush.from_mm) => {
        "Where the middle begins, within 10^12; 0, 0, 0."
    };
    (sf_paint_brush.radius_mm) => {
        "Above 0, and may be infinite: all points; 1."
    };
    (sf_paint_brush.strength) => {
        "Weight in the middle, above 0 and at most 1; 1."
    };
    (sf_paint_brush.to_mm) => {
        "Where it ends, within 10^12; 0, 0, 0."
    };
    (sf_paint_move: weights, vector_mm) => {
        "Move points, each by its weight times a vector.\n\n- `weights`: one for each point, 0 to 1\n- `vector_mm`: the vector\n- cost: O(points).\n- threads: one for each cage.\n- in C: [`sf_paint_move()`](crate::sys::sf_paint_move)"
    };
    (sf_paint_select: weights) => {
        "Add to a selection what a brush touches: each weight becomes the greater of itself and the brush's.\n\n- `weights`: one for each point of the cage, 0 to 1\n- cost: O(points).\n- threads: any, while nobody changes the cage.\n- source: C. Altenhofen and others, \"Continuous property gradation for multi-material 3D-printed objects\", 2018, \"Interaction techniques\".\n- in C: [`sf_paint_select()`](crate::sys::sf_paint_select)"
    };
    (sf_paint_smooth: weights, amount) => {
        "Move points towards the means of their neighbours along edges; those on the boundary towards neighbours on the boundary only, so that an outside does not shrink into its inside.\n\n- `weights`: one for each point, 0 to 1\n- `amount`: how far, 0 to 1\n- cost: O(points and edges).\n- threads: one for each cage.\n- in C: [`sf_paint_smooth()`](crate::sys::sf_paint_smooth)"
    };
    (sf_paint_values: channel, weights, operation, amount) => {
        "Change values of a property.\n\nWhat would leave the property's bounds stays at them.\n\nA value that corners name has the greatest weight of the points where it is named; its neighbours are the values at the other ends of edges, on its own side of a jump.\n\n- `channel`: which property\n- `weights`: one for each point, 0 to 1\n- `operation`: what is done\n- `amount`: by how much\n- cost: O(points and edges).\n- threads: one for each cage.\n- in C: [`sf_paint_values()`](crate::sys::sf_paint_values)"
    };
    (sf_path) => {
        "What is known of a path beside its voxels."
    };
    (sf_path.bed_square) => {
        "On the bed: squared distance of its last voxel to the closest matter of the bed slice, in voxels; 0 else, and where that slice is empty."
    };
    (sf_path.landing) => {
        "The matter below its last voxel; else its last voxel itself, which is the one asked about where the path is empty."
    };
    (sf_path_finder) => {
        "Finds closest supporting paths in a grid, one at a time."
    };
    (sf_path_finder_create: landing) => {
        "Make a path finder for a grid.\n\nWhere any matter may be landed on and the rule is box3, octagon or disk the finder looks at nothing but the grid as it is when it is asked: changes count at once. Under slack, or for landing on living matter only, it keeps what is alive, and [`sf_path_finder_refresh()`](crate::sys::sf_path_finder_refresh) brings that up to date. Bridges carry what stands there, but a path does not count on new ones.\n\n- `landing`: what matter a path may end on\n- cost: a search for the bed. Where the finder keeps what is alive, a trim, and a bit for each voxel; under slack another bit, and a byte for each voxel that lives with less than all reach to spare; on layers of one height also some ten bytes for each layer and row of the grid, until a cone fills its slices. At 512^3 and 45 degrees that is 40 MB.\n- threads: any; the grids are only read.\n- in C: [`sf_path_finder_create()`](crate::sys::sf_path_finder_create)"
    };
    (sf_path_finder_find: from) => {
        "The closest supporting path of a voxel, solid or not: what to fill so that it is carried.\n\nThe path goes from the layer below the voxel downwards, without the voxel itself and without the matter that it lands on. It is empty where the voxel is carried already, lies on the bed or is exempt, below the bed too: what is exempt stands wherever it lies. Among the paths of least cost: matter before a held voxel before the bed; the least distance of the landing from the voxel in the plane (on the bed first the least distance to the matter there), then the least y, then the least x of it. Between voxel and landing the path stays close to the straight line. With a bed slice that is empty it goes straight down if it may.\n\n- `from`: the voxel; whether it may be filled itself is not asked\n- cost: O(t^3 / 64) word reads where the path is t layers long. Once, and again whenever the bed slice has changed, the first path that ends on the bed asks for a distance transform of that slice. Under slack on layers of different heights O(t^2) bytes are made, and kept until a voxel of another layer is asked about. Where the masks lie in the way O(t^3) bytes, and memory for them.\n- threads: one per finder; the grids are only read.\n- source: T. Reiner, S. Lefebvre, \"Interactive Modeling of Support-free Shapes for Fabrication\", Eurographics 2016, section 2.2 (grow), by a search of the downward cone in place of a map.\n- in C: [`sf_path_finder_find()`](crate::sys::sf_path_finder_find)"
    };
    (sf_path_map) => {
        "Costs and directions of the closest supporting paths of all voxels of a grid."
    };
    (sf_path_map_create) => {
        "Make a path map: for many questions to a grid that does not change.\n\nWhere no step reaches farther than a voxel (box3, octagon up to that reach), the cost is [`SF_PATH_COST_COUNT`](crate::sys::SF_PATH_COST_COUNT) and stays below 4095, the map is half a byte for each voxel: a direction. Else it is four bytes, a cost, and directions are found while walking.\n\n- cost: for half a byte a voxel about a nanosecond for four voxels; else voxels times those of the element, and a distance transform of each slice for [`SF_PATH_COST_NEARNESS`](crate::sys::SF_PATH_COST_NEARNESS).\n- threads: any; the grids are only read.\n- source: T. Reiner, S. Lefebvre, \"Interactive Modeling of Support-free Shapes for Fabrication\", Eurographics 2016, sections 2.2 and 3.2, with costs that are zero at matter.\n- in C: [`sf_path_map_create()`](crate::sys::sf_path_map_create)"
    };
    (sf_path_map_walk: from) => {
        "The path of a voxel by the map: one of the least cost.\n\nEach step goes to a voxel of least cost; among these to the closest in the plane, then to the least y, then to the least x. So the path costs what [`sf_path_finder_find()`](crate::sys::sf_path_finder_find) finds, but need not be the same.\n\n- `from`: as in [`sf_path_finder_find()`](crate::sys::sf_path_finder_find)\n- cost: the length of the path; on a map of costs times the voxels of the element.\n- threads: any.\n- in C: [`sf_path_map_walk()`](crate::sys::sf_path_map_walk)"
    };
    (sf_place_options) => {
        "How handles are placed. Fill with [`sf_place_options_default()`](crate::sys::sf_place_options_default)."
    };
    (sf_place_options.ball) => {
        "0: points; else balls of this part of the largest that fits; 0..1."
    };
    (sf_place_options.base) => {
        "NULL, or voxels to keep away from, on the solid's lattice."
    };
    (sf_place_options.count) => {
        "How many handles are wanted: 5; 1..[`SF_HANDLE_MAX`](crate::sys::SF_HANDLE_MAX)."
    };
    (sf_place_options.most_cells) => {
        "The solid is looked at in blocks, at most this many: 32768; at least 64."
    };
    (sf_png_write_rgb: pixels, width, height) => {
        "Write a colour picture as PNG, eight bits of red, green and blue a pixel.\n\n- `pixels`: 3 \\* width \\* height bytes: red, green, blue, row after row from the top\n- `width`: 1..[`SF_EXTENT_MAX`](crate::sys::SF_EXTENT_MAX)\n- `height`: 1..[`SF_EXTENT_MAX`](crate::sys::SF_EXTENT_MAX)\n- cost: one pass, mostly in the compressor, which takes its memory from the C library.\n- threads: any, on distinct sinks.\n- in C: [`sf_png_write_rgb()`](crate::sys::sf_png_write_rgb)"
    };
    (sf_pose_identity) => {
        "The pose that changes nothing.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_pose_identity()`](crate::sys::sf_pose_identity)"
    };
    (sf_pose_move: change) => {
        "Change a pose: scale and shift are added, the spin turns after what is there.\n\n- `change`: the change; its spin shorter than 3 radians\n- cost: constant.\n- threads: one per pose.\n- source: O. Rodrigues, 1840: the axis scaled by the tangent of half the angle.\n- in C: [`sf_pose_move()`](crate::sys::sf_pose_move)"
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
    (sf_printing_options.connectivity) => {
        "[`SF_CONNECT_CORNERS`](crate::sys::SF_CONNECT_CORNERS), the default: voxels that touch in as much as a corner are one piece, so that what is support-free under the rule box3 never floats; [`SF_CONNECT_EDGES`](crate::sys::SF_CONNECT_EDGES): only those that share a face."
    };
    (sf_property) => {
        "What a property is."
    };
    (sf_property.high) => {
        "No value lies above; infinity: no bound."
    };
    (sf_property.low) => {
        "No value lies below; minus infinity: no bound."
    };
    (sf_property.si) => {
        "Exponents of m, kg, s, A, K, mol and cd."
    };
    (sf_property.uuid) => {
        "Its identity, bytes as RFC 9562 orders them; not all 0."
    };
    (sf_property_density) => {
        "Mass density in kg/m3, 0 and more.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_property_density()`](crate::sys::sf_property_density)"
    };
    (sf_property_named) => {
        "A property of which no more than the name is known: a bare number without bounds.\n\nIts UUID is made of the name, and the same wherever that is: the first 16 bytes of SHA-256 of \"libsf property \" and the name, marked as version 8 of RFC 9562. Cages of files without UUIDs have such properties. Whoever publishes a property draws a UUID of its own at random instead.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_property_named()`](crate::sys::sf_property_named)"
    };
    (sf_property_poisson) => {
        "Poisson's ratio, a bare number from -1 to 0.5.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_property_poisson()`](crate::sys::sf_property_poisson)"
    };
    (sf_property_young) => {
        "Young's modulus in Pa, 0 and more.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_property_young()`](crate::sys::sf_property_young)"
    };
    (sf_ray_hit) => {
        "Where a ray meets a surface."
    };
    (sf_ray_hit.along) => {
        "How many times the direction's length from the ray's beginning."
    };
    (sf_ray_hit.triangle) => {
        "Which triangle, or whatever the caster numbers."
    };
    (sf_read_limits) => {
        "Bounds on what a reader takes. Fill with [`sf_read_limits_default()`](crate::sys::sf_read_limits_default)."
    };
    (sf_read_limits.bytes_max) => {
        "Most bytes read from the source (default 8 GiB)."
    };
    (sf_read_limits.triangles_max) => {
        "Most triangles (default 1e9)."
    };
    (sf_read_limits.vertices_max) => {
        "Most vertices, corners of STL facets one by one (default UINT32_MAX)."
    };
    (sf_refine) => {
        "Refine a cage.\n\nAfter a step the points are those of the points before, of the edges, of the faces and of the cells, in that order. Pieces of one cell follow each other; piece j holds the cell's corner j, as its own corner j where the cell is a hexahedron (in dimension 2 a quadrilateral), so that axes are kept, and as its first corner else. Where neighbours name different values of a property at their corners, each side is refined by itself, as if it ended there: the property jumps there, exactly.\n\n- cost: a step eight times as much as the one before; memory likewise.\n- threads: any; one at a time for each allocator.\n- source: K. I. Joy, R. MacCracken, \"The refinement rules for Catmull-Clark solids\", 1999; E. Catmull, J. Clark, \"Recursively generated B-spline surfaces on arbitrary topological meshes\", 1978; T. DeRose, M. Kass, T. Truong, \"Subdivision surfaces in character animation\", 1998; C. Altenhofen and others, \"Continuous property gradation for multi-material 3D-printed objects\", 2018.\n- in C: [`sf_refine()`](crate::sys::sf_refine)"
    };
    (sf_refinement) => {
        "A cage and what it is after each of some steps."
    };
    (sf_refinement_get_view: step) => {
        "The cage after some steps.\n\nIts channels have indices where neighbours' values differ somewhere, also where the cage's own indices make no difference.\n\n- `step`: 0, the cage itself, to the number of steps\n- cost: constant.\n- threads: any, while nobody updates.\n- in C: [`sf_refinement_get_view()`](crate::sys::sf_refinement_get_view)"
    };
    (sf_refinement_stencil: step, point) => {
        "How a point's position depends on the cage: as weights of the cage's points, above 0, that sum to 1.\n\n- `step`: 0 to the number of steps\n- `point`: a point after that step\n- cost: the points that it depends on, at each step; scratch of a number for each point of the step.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_refinement_stencil()`](crate::sys::sf_refinement_stencil)"
    };
    (sf_refinement_update_positions: positions) => {
        "Take new positions from the cage through all steps.\n\n- `positions`: 3 for each of the cage's points, mm, finite and within 10^12; not the refinement's own\n- cost: some 15 products for each new point and coordinate.\n- threads: one for each refinement.\n- in C: [`sf_refinement_update_positions()`](crate::sys::sf_refinement_update_positions)"
    };
    (sf_refinement_update_values: channel, values) => {
        "Take new values of a property from the cage through all steps.\n\n- `channel`: which property\n- `values`: as many as the property has in the cage, finite and within its bounds; not the refinement's own\n- cost: some 15 products for each new value.\n- threads: one for each refinement.\n- in C: [`sf_refinement_update_values()`](crate::sys::sf_refinement_update_values)"
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
    (sf_rule_element: k) => {
        "The element of one step: slice k + 1 must lie within slice k dilated by it.\n\nUnder slack the element holds what can carry at all, where there is slack enough; bridges are not in it. The octagon's elements differ from step to step even where all layers have one height, so k is always the lattice's layer, never a count from the bed.\n\n- `k`: layer below the step, counted from the lattice's layer 0\n- cost: O(reach).\n- threads: any.\n- in C: [`sf_rule_element()`](crate::sys::sf_rule_element)"
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
    (sf_runs_label: connectivity) => {
        "Label runs with their connected component, in place, numbered from 0 by first run.\n\nThe runs are those of [`sf_slice_runs()`](crate::sys::sf_slice_runs): in row order, from left to right, with an empty voxel between those of one row. Labels on entry are ignored.\n\n- `connectivity`: which voxels are neighbours\n- cost: nearly linear in the runs; no memory.\n- threads: one per array.\n- source: R. E. Tarjan, \"Efficiency of a Good But Not Linear Set Union Algorithm\", 1975.\n- in C: [`sf_runs_label()`](crate::sys::sf_runs_label)"
    };
    (sf_runs_measure) => {
        "Area and bounds of each labelled component; places that no run names become zero.\n\n- cost: linear in runs and places.\n- threads: any that write to distinct arrays.\n- in C: [`sf_runs_measure()`](crate::sys::sf_runs_measure)"
    };
    (sf_sampler) => {
        "A solid on a lattice, ready to be sliced."
    };
    (sf_sampler_create: channels) => {
        "Prepare a limit of dimension 3 to be sliced.\n\n- `channels`: which ones\n- cost: a microsecond or two for each vertex of the surface; 40 MB for splines that are kept, and as much for each further property that jumps.\n- threads: any, while nobody updates the limit; one at a time for each allocator.\n- in C: [`sf_sampler_create()`](crate::sys::sf_sampler_create)"
    };
    (sf_sampler_of_tets: channels) => {
        "Prepare tetrahedra to be sliced: the way by which a file comes that holds no cage.\n\nA voxel is solid where the winding number of the tetrahedra's boundary about its centre is at least one half, and has what is interpolated between the corners of the first tetrahedron that holds its centre; where rounding leaves it in none, what the next voxel in its row has, or the nearest tetrahedron. Slices are made as from a limit, by [`sf_sampler_slice()`](crate::sys::sf_sampler_slice).\n\n- `channels`: which ones\n- cost: linear in tetrahedra and layers.\n- threads: any; one at a time for each allocator.\n- source: C. Altenhofen and others, \"Continuous property gradation for multi-material 3D-printed objects\", 2018, \"Volumetric slicing\", with properties interpolated within tetrahedra.\n- in C: [`sf_sampler_of_tets()`](crate::sys::sf_sampler_of_tets)"
    };
    (sf_sampler_report) => {
        "What became of the voxels so far.\n\n- cost: constant.\n- threads: any, while nobody slices.\n- in C: [`sf_sampler_report()`](crate::sys::sf_sampler_report)"
    };
    (sf_sampler_slice: k, solid) => {
        "A slice.\n\nThe same bytes whichever slices were asked for before.\n\n- `k`: which layer\n- `solid`: of the lattice's nx and ny: receives what is solid\n- cost: a third of a microsecond for each solid voxel; of tetrahedra a tenth for each of those that the slice meets.\n- threads: one for each sampler.\n- in C: [`sf_sampler_slice()`](crate::sys::sf_sampler_slice)"
    };
    (sf_sampler_surface) => {
        "The surface by which voxels are solid: closed triangles, outwards.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_sampler_surface()`](crate::sys::sf_sampler_surface)"
    };
    (sf_sculpt) => {
        "A shape that is worked on."
    };
    (sf_sculpt_abandon) => {
        "Give up the stroke that is under way: the model is as it was before it.\n\n- cost: the box around all that the stroke changed.\n- threads: one per model.\n- in C: [`sf_sculpt_abandon()`](crate::sys::sf_sculpt_abandon)"
    };
    (sf_sculpt_begin) => {
        "Begin a stroke; the model is not changed before it has dabs.\n\n- cost: constant; add-grow under a rule with slack, a trim.\n- threads: one per model.\n- in C: [`sf_sculpt_begin()`](crate::sys::sf_sculpt_begin)"
    };
    (sf_sculpt_create) => {
        "Make an empty model.\n\n- cost: a pass over new memory.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_sculpt_create()`](crate::sys::sf_sculpt_create)"
    };
    (sf_sculpt_dab) => {
        "Put the brush on more places in the stroke that is under way.\n\n- cost: add-trim, remove-trim, paint: the new tips' boxes and what changes above them; the others: the box around the whole stroke; add-grow also a search for each dab. Under a rule with slack a trim.\n- threads: one per model.\n- source: T. Reiner, S. Lefebvre, \"Interactive Modeling of Support-free Shapes for Fabrication\", Eurographics 2016, sections 2.2 and 3.2 (the brushes); one union for a stroke, and that add-grow carries all of its tips, are the library's own.\n- in C: [`sf_sculpt_dab()`](crate::sys::sf_sculpt_dab)"
    };
    (sf_sculpt_drawn) => {
        "What is drawn, D: T and the ghosts.\n\n- cost: constant.\n- threads: any, while no call changes the model.\n- in C: [`sf_sculpt_drawn()`](crate::sys::sf_sculpt_drawn)"
    };
    (sf_sculpt_drop_ghosts) => {
        "Let the ghosts go: D becomes T.\n\nOne step of the history where there were any.\n\n- cost: some passes over the grid.\n- threads: one per model.\n- in C: [`sf_sculpt_drop_ghosts()`](crate::sys::sf_sculpt_drop_ghosts)"
    };
    (sf_sculpt_end) => {
        "End the stroke that is under way: it becomes one step of the history, unless it changed nothing.\n\nThe oldest steps are forgotten where the history's memory asks for it. A step that does not fit at all is done and cannot be undone, and all before it are forgotten.\n\n- cost: the box around all that the stroke changed.\n- threads: one per model.\n- in C: [`sf_sculpt_end()`](crate::sys::sf_sculpt_end)"
    };
    (sf_sculpt_history_of) => {
        "What the history of a model holds; the model must not be NULL.\n\n- cost: constant.\n- threads: any, while no call changes the model.\n- in C: [`sf_sculpt_history_of()`](crate::sys::sf_sculpt_history_of)"
    };
    (sf_sculpt_materials) => {
        "Materials of all voxels in (layer, y, x) order, a byte each: 0 where nothing is drawn.\n\n- cost: constant.\n- threads: any, while no call changes the model.\n- in C: [`sf_sculpt_materials()`](crate::sys::sf_sculpt_materials)"
    };
    (sf_sculpt_options.history_size) => {
        "Bytes for undo and redo: 64 MiB by default."
    };
    (sf_sculpt_printable) => {
        "What prints without supports, T; during a stroke as far as the stroke has come.\n\n- cost: constant.\n- threads: any, while no call changes the model.\n- in C: [`sf_sculpt_printable()`](crate::sys::sf_sculpt_printable)"
    };
    (sf_sculpt_redo) => {
        "Do again what was taken back last, unless something else was done since.\n\n- cost: the step's size.\n- threads: one per model.\n- in C: [`sf_sculpt_redo()`](crate::sys::sf_sculpt_redo)"
    };
    (sf_sculpt_replace: drawn, materials) => {
        "Put another shape in place of what is drawn: one step of the history.\n\n- `drawn`: the new D, of the model's counts; not a grid of the model; NULL: empty\n- `materials`: a byte for each voxel in (layer, y, x) order, looked at where drawn is solid, where 0 counts as 1; NULL: all 1\n- cost: a trim, and some passes over the grid.\n- threads: one per model.\n- in C: [`sf_sculpt_replace()`](crate::sys::sf_sculpt_replace)"
    };
    (sf_sculpt_stroke) => {
        "A whole stroke: begin, dab, end.\n\nA call that fails leaves the model as it was.\n\n- cost: as these.\n- threads: one per model.\n- in C: [`sf_sculpt_stroke()`](crate::sys::sf_sculpt_stroke)"
    };
    (sf_sculpt_undo) => {
        "Take back the last step: D, T and materials are what they were before it, bit for bit.\n\n- cost: the step's size.\n- threads: one per model.\n- in C: [`sf_sculpt_undo()`](crate::sys::sf_sculpt_undo)"
    };
    (sf_session) => {
        "A list of steps."
    };
    (sf_session_add_mask: mask, anchor) => {
        "Add a tip of a mask, as [`sf_tip_create_mask()`](crate::sys::sf_tip_create_mask) makes it; also what a stamp or a mesh became.\n\n- `mask`: its voxels, copied\n- `anchor`: its voxel that comes to lie on each dab\n- cost: that of the tip.\n- threads: one per session.\n- in C: [`sf_session_add_mask()`](crate::sys::sf_session_add_mask)"
    };
    (sf_session_add_shape: drawn, materials) => {
        "Add a shape that takes the place of what is drawn, as [`sf_sculpt_replace()`](crate::sys::sf_sculpt_replace) does.\n\n- `drawn`: of the session's counts; copied as runs\n- `materials`: as in [`sf_sculpt_replace()`](crate::sys::sf_sculpt_replace), or NULL\n- cost: a pass over the grid.\n- threads: one per session.\n- in C: [`sf_session_add_shape()`](crate::sys::sf_session_add_shape)"
    };
    (sf_session_add_step: step) => {
        "Add a step that is no stroke.\n\n- `step`: which\n- cost: constant.\n- threads: one per session.\n- in C: [`sf_session_add_step()`](crate::sys::sf_session_add_step)"
    };
    (sf_session_add_stroke: tip, dabs) => {
        "Add a stroke.\n\n- `tip`: number of the tip\n- `dabs`: where, copied; may be NULL where count is 0\n- cost: linear.\n- threads: one per session.\n- in C: [`sf_session_add_stroke()`](crate::sys::sf_session_add_stroke)"
    };
    (sf_session_add_tip: shape, radius_vx) => {
        "Add a tip by formula, as [`sf_tip_create()`](crate::sys::sf_tip_create) makes it.\n\n- `shape`: which\n- `radius_vx`: half its extents\n- cost: that of the tip.\n- threads: one per session.\n- in C: [`sf_session_add_tip()`](crate::sys::sf_session_add_tip)"
    };
    (sf_session_begin) => {
        "Make an empty model in the session's space.\n\n- cost: that.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_session_begin()`](crate::sys::sf_session_begin)"
    };
    (sf_session_count) => {
        "What a session holds.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_session_count()`](crate::sys::sf_session_count)"
    };
    (sf_session_create) => {
        "Make a session without steps.\n\n- cost: constant.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_session_create()`](crate::sys::sf_session_create)"
    };
    (sf_session_keep_state) => {
        "Keep the state of a model as that at the end of the session; another one is forgotten.\n\n- cost: a pass over the grid.\n- threads: one per session.\n- in C: [`sf_session_keep_state()`](crate::sys::sf_session_keep_state)"
    };
    (sf_session_open) => {
        "Open the state that is kept, without playing; its history is empty.\n\n- cost: a trim, and passes over the grid.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_session_open()`](crate::sys::sf_session_open)"
    };
    (sf_session_options.angle_rad) => {
        "Of the rule, as [`sf_rule_make()`](crate::sys::sf_rule_make) takes it; 45 degrees by default."
    };
    (sf_session_options.lattice) => {
        "As in [`sf_sculpt_options`](crate::sys::sf_sculpt_options), with layers of one height."
    };
    (sf_session_options_of) => {
        "The space of a session.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_session_options_of()`](crate::sys::sf_session_options_of)"
    };
    (sf_session_play: step) => {
        "Do one step on a model.\n\n- `step`: number of the step, counted from 0\n- cost: that of the step.\n- threads: one per model.\n- in C: [`sf_session_play()`](crate::sys::sf_session_play)"
    };
    (sf_session_read: bytes_max) => {
        "Read a session.\n\nNo count in a file is believed: memory grows as the bytes come, but for the tips, of which each may ask for a mask of 2^27 voxels at most.\n\n- `bytes_max`: most bytes read; 0 for 1 GiB\n- cost: linear, and the tips.\n- threads: any, on distinct sources.\n- in C: [`sf_session_read()`](crate::sys::sf_session_read)"
    };
    (sf_session_replay) => {
        "Do all steps on a new model, and hold the result against the state that is kept, if one is.\n\n- cost: all steps.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_session_replay()`](crate::sys::sf_session_replay)"
    };
    (sf_session_stroke: step) => {
        "What a step is, where it is a stroke: for a host that does strokes by other means.\n\n- `step`: number of the step\n- cost: constant.\n- threads: any.\n- in C: [`sf_session_stroke()`](crate::sys::sf_session_stroke)"
    };
    (sf_session_tip: tip) => {
        "A tip of a session, to put into a brush.\n\n- `tip`: its number, counted from 0\n- cost: constant.\n- threads: any.\n- in C: [`sf_session_tip()`](crate::sys::sf_session_tip)"
    };
    (sf_session_write) => {
        "Write a session as text.\n\nThe same session gives the same bytes; read and written again it stays.\n\n- cost: linear.\n- threads: any, on distinct sinks.\n- in C: [`sf_session_write()`](crate::sys::sf_session_write)"
    };
    (sf_shell) => {
        "The voxels near the surface of a mesh, a slice at a time."
    };
    (sf_shell_create: distance_mm) => {
        "Prepare to find the voxels that come nearer than a distance to the surface of a mesh.\n\nConservative: with S the voxels whose closed boxes the surface touches, the shell is S and each voxel whose box is less than the distance from the box of one of S. So no point of any other voxel is nearer to the surface than the distance, wherever within its voxels the surface runs, but for the 1/256 voxel to which [`sf_voxelizer_create()`](crate::sys::sf_voxelizer_create) rounds corners.\n\n- `distance_mm`: 0 (S itself) or more; its reach may be at most 255 voxels along each axis\n- cost: as [`sf_voxelizer_create()`](crate::sys::sf_voxelizer_create).\n- threads: any; one at a time for each allocator.\n- source: M. Schwarz, H.-P. Seidel, \"Fast parallel surface and solid voxelization on GPUs\", 2010.\n- in C: [`sf_shell_create()`](crate::sys::sf_shell_create)"
    };
    (sf_shell_slice: k, slice) => {
        "The shell's voxels in layer k: the same bytes in whatever order layers are asked for.\n\n- `k`: layer, below the lattice's nz\n- `slice`: nx by ny voxels; what it held is lost\n- cost: the surface voxels of layers not yet at hand, and a dilation for each layer within reach.\n- threads: one at a time for each shell.\n- in C: [`sf_shell_slice()`](crate::sys::sf_shell_slice)"
    };
    (sf_sl1_settings) => {
        "What a new SL1 job says beside its layers. Fill with [`sf_sl1_settings_default()`](crate::sys::sf_sl1_settings_default)."
    };
    (sf_sl1_settings.exposure_s) => {
        "Of a layer, 0 \\< it \\<= 1e6; 8 by default."
    };
    (sf_sl1_settings.fade_layers) => {
        "Layers from the one to the other; 10 by default."
    };
    (sf_sl1_settings.first_exposure_s) => {
        "Of the first ones; 35 by default."
    };
    (sf_sl1_write: settings) => {
        "Write a grid as a new SL1 job: config.ini, prusaslicer.ini with the display, a PNG a layer.\n\n- `settings`: NULL for [`sf_sl1_settings_default()`](crate::sys::sf_sl1_settings_default)\n- cost: one pass, mostly in the compressor.\n- threads: any that only read the grid.\n- in C: [`sf_sl1_write()`](crate::sys::sf_sl1_write)"
    };
    (sf_slice) => {
        "A view of a plane of bits. Passed by value; the words belong to somebody else."
    };
    (sf_slice_and) => {
        "dst = a AND b: solid where both are.\n\n- cost: one pass.\n- threads: any that write to distinct slices.\n- in C: [`sf_slice_and()`](crate::sys::sf_slice_and)"
    };
    (sf_slice_and_dilate: below, element) => {
        "One step of trimming in one pass: dst = src AND dilate(below), outside empty.\n\nAll three have one size. dst may be src, and must not overlap below.\n\n- `below`: the layer below it, which is dilated\n- `element`: by what\n- cost: one pass for the square and the plus, else as [`sf_slice_dilate()`](crate::sys::sf_slice_dilate).\n- threads: any that write to distinct slices.\n- in C: [`sf_slice_and_dilate()`](crate::sys::sf_slice_and_dilate)"
    };
    (sf_slice_bounds) => {
        "Smallest rectangle around the solid voxels.\n\n- cost: one pass at most.\n- threads: any.\n- in C: [`sf_slice_bounds()`](crate::sys::sf_slice_bounds)"
    };
    (sf_slice_copy) => {
        "dst = src.\n\nBoth have one size, with any strides. dst may be src (the same words and stride), but must not lie across it; so too for both inputs of the four functions that follow.\n\n- cost: one pass over the slices.\n- threads: any that write to distinct slices.\n- in C: [`sf_slice_copy()`](crate::sys::sf_slice_copy)"
    };
    (sf_slice_dilate: element, border) => {
        "Dilation: dst is solid where the element, placed there, meets src or, beyond it, the border.\n\nBoth have one size. dst must not overlap src.\n\n- `element`: by what\n- `border`: what lies outside src\n- cost: 2 reach_y + 1 unions of rows for each row, and a few shifts where half widths change.\n- threads: any that write to distinct slices.\n- in C: [`sf_slice_dilate()`](crate::sys::sf_slice_dilate)"
    };
    (sf_slice_erode: element, border) => {
        "Erosion: dst is solid where the element, placed there, lies in src and, beyond it, in the border.\n\nIt is the complement of the dilation of the complement, the border complemented as well.\n\n- `element`: by what\n- `border`: what lies outside src\n- cost: as [`sf_slice_dilate()`](crate::sys::sf_slice_dilate).\n- threads: any that write to distinct slices.\n- in C: [`sf_slice_erode()`](crate::sys::sf_slice_erode)"
    };
    (sf_slice_fill: rect) => {
        "Make every voxel of a rectangle solid (value != 0) or empty; an empty rectangle changes nothing.\n\n- `rect`: the voxels, all within the slice\n- cost: the words of the rectangle.\n- threads: one per slice.\n- in C: [`sf_slice_fill()`](crate::sys::sf_slice_fill)"
    };
    (sf_slice_from_contours: lattice, contours) => {
        "Draw contours into a slice: dst is solid where they have it inside, and empty elsewhere.\n\n- `lattice`: where voxels lie: nx, ny, pitch and origin are looked at\n- `contours`: the polygons, in the frame of the lattice; what stands out is cut off\n- cost: one pass, and n log n in the crossings of each row.\n- threads: any that write to distinct slices; one at a time for each allocator.\n- source: W. J. Bouknight, \"A Procedure for Generation of Three-Dimensional Half-Toned Computer Graphics Presentations\", 1970 (lists of edges that a row crosses).\n- in C: [`sf_slice_from_contours()`](crate::sys::sf_slice_from_contours)"
    };
    (sf_slice_from_runs: runs) => {
        "Paint runs, in any order and free to overlap: dst is solid where a run is, and empty elsewhere.\n\n- `runs`: the runs; labels are ignored; may be NULL where count is 0\n- cost: one pass, and the runs.\n- threads: one per slice.\n- in C: [`sf_slice_from_runs()`](crate::sys::sf_slice_from_runs)"
    };
    (sf_slice_get) => {
        "Whether voxel (x, y) is solid.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_slice_get()`](crate::sys::sf_slice_get)"
    };
    (sf_slice_measure) => {
        "Exact integer sums over the solid voxels: their number, and those of x, y and their products.\n\n- cost: one pass.\n- threads: any.\n- in C: [`sf_slice_measure()`](crate::sys::sf_slice_measure)"
    };
    (sf_slice_or) => {
        "dst = a OR b: solid where either is.\n\n- cost: one pass.\n- threads: any that write to distinct slices.\n- in C: [`sf_slice_or()`](crate::sys::sf_slice_or)"
    };
    (sf_slice_popcount) => {
        "Number of solid voxels.\n\n- cost: one pass.\n- threads: any.\n- in C: [`sf_slice_popcount()`](crate::sys::sf_slice_popcount)"
    };
    (sf_slice_run_count) => {
        "Number of runs of solid voxels: the capacity that [`sf_slice_runs()`](crate::sys::sf_slice_runs) needs.\n\n- cost: one pass.\n- threads: any.\n- in C: [`sf_slice_run_count()`](crate::sys::sf_slice_run_count)"
    };
    (sf_slice_runs) => {
        "The runs of a slice in row order, from left to right, with label 0.\n\n- cost: two passes, and the runs.\n- threads: any.\n- in C: [`sf_slice_runs()`](crate::sys::sf_slice_runs)"
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
    (sf_stack_has_png) => {
        "Whether this build writes and reads PNG.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_stack_has_png()`](crate::sys::sf_stack_has_png)"
    };
    (sf_stack_read) => {
        "Read a stack back: the grid, its lattice, and the rule it was made under.\n\nLayers of materials (\\<sf/layers.h\\>) are read as what is solid. Pictures may also be grey of 2 to 8 bits, as picture editors save them: half-way and above is solid. Before memory is taken for the grid, every picture that stack.json claims must be there with the claimed size. Fields of stack.json that are not known are passed over.\n\n- cost: two opens of each picture, one pass over their bytes. jansson, libspng and zlib take memory from the C library, in proportion to stack.json (at most 64 MiB) and to a row.\n- threads: any, on distinct folders; one at a time for each allocator.\n- in C: [`sf_stack_read()`](crate::sys::sf_stack_read)"
    };
    (sf_stack_write) => {
        "Write a grid as a stack: layer_00000.png and so on from the bottom, and last stack.json.\n\nEach picture has nx by ny pixels, one bit of grey each: white is solid. It shows the layer from above: x to the right, y upward, so its top row is the largest y. In a build without PNG the pictures are PBM (P4), layer_00000.pbm. stack.json says it all:\n\n```text\n    {\"format\": \"libsf-stack\", \"version\": 1, \"units\": \"mm\",\n     \"lattice\": {\"nx\", \"ny\", \"nz\", \"pitch_mm\": [x, y],\n                 \"layer_mm\" or \"heights_mm\": [...], \"origin_mm\": [x, y, z]},\n     \"rule\": null or {\"kind\": \"box3\" | \"octagon\" | \"disk\" | \"slack\",\n                      \"angle_deg\", \"angle_rad\", \"bridge_mm\": [span, anchor], \"bed_layer\",\n                      \"phase_layer\": 0},\n     \"layers\": {\"pattern\": \"layer_%05u.png\", \"count\": nz},\n     \"solid\": \"white\", \"row_order\": \"top_is_max_y\"}\n```\n\nIts numbers read back as the same doubles. angle_deg is for people: the reader takes angle_rad; box3 has neither. bridge_mm is there only where the rule has bridges, and then the version is 2. bed_layer is null for [`SF_BED_AUTO`](crate::sys::SF_BED_AUTO). phase_layer is the layer that the rule's phase counts from (an octagon's steps differ from layer to layer); so far that is always 0, so a reader takes nothing else, and 0 where it is absent. A folder without stack.json is no stack, so a call that fails leaves none in a folder that had none; over [`sf_directory_write()`](crate::sys::sf_directory_write) it leaves nothing at all.\n\n- cost: one pass over the grid, mostly in the compressor; 12 KiB of stack. libspng and zlib take some 300 KiB from the C library, because they know no other allocators.\n- threads: any that only read the grid, on distinct folders.\n- in C: [`sf_stack_write()`](crate::sys::sf_stack_write)"
    };
    (sf_stance) => {
        "A way for one mesh to come to rest."
    };
    (sf_stance_contacts) => {
        "The vertices that touch the ground, by rising number; none where the body hangs.\n\n- cost: linear.\n- threads: any.\n- in C: [`sf_stance_contacts()`](crate::sys::sf_stance_contacts)"
    };
    (sf_stance_create) => {
        "Make a stance: find what touches the ground, and where the centre of mass may lie.\n\nStanding. The ground lies below the lowest vertex within the region, perpendicular to `up`, and what touches it is every vertex within contact_mm above it. The support polygon is their convex hull, dropped onto the ground. It may be a segment or a point, and then no centre of mass is safe.\n\nHanging. The body swings freely about the point and comes to rest with its centre of mass straight below.\n\nRocking. The body stands on its convex hull (that of the vertices within the region), in the pose in which `up` points up; let go from a tilt of up to range_rad in any direction, it must come back to within tolerance_rad. How it rolls is said at [`sf_mesh_rest()`](crate::sys::sf_mesh_rest). The pose asked for need not be a face of the hull.\n\nThe mesh is not kept. Only vertices that triangles use count. It need not be closed.\n\n- cost: two passes over the mesh; n log n in the vertices that touch the ground; rocking, that of a hull, and the square of the faces and edges within the range, in stretches of 256.\n- threads: any; one at a time for each allocator.\n- source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, \"Make It Stand: Balancing Shapes for 3D Fabrication\", 2013, section 3, figure 2 and the rocking toy of table 1.\n- in C: [`sf_stance_create()`](crate::sys::sf_stance_create)"
    };
    (sf_stance_flatten: vertices) => {
        "Move every contact straight down onto the ground, in the caller's array of vertices.\n\nWith a contact_mm of, say, a tenth of a millimetre, this makes a foot that is almost flat flat, and the support polygon is then what really touches.\n\n- `vertices`: x, y, z of each vertex of the mesh that the stance was made from, or of a deformed one with the same vertices; those of contacts are changed\n- cost: linear in the contacts.\n- threads: any that write to distinct arrays.\n- source: R. Prevost and others, \"Make It Stand\", 2013, section 3: \"we flatten faces surrounding the support, within a threshold\".\n- in C: [`sf_stance_flatten()`](crate::sys::sf_stance_flatten)"
    };
    (sf_stance_get_options) => {
        "The options that a stance was made with, `up` with length 1 and every 0 replaced by what it stands for.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_stance_get_options()`](crate::sys::sf_stance_get_options)"
    };
    (sf_stance_ground) => {
        "Height of the ground: its points p have up . p equal to it.\n\nHanging: the height of the point.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_stance_ground()`](crate::sys::sf_stance_ground)"
    };
    (sf_stance_halfspaces) => {
        "Where the centre of mass may lie: in all of these half-spaces.\n\nStanding, one for each edge of the support polygon: with its inward direction n, a corner p and the height h of the centre c above the ground, n . (c - p) \\>= h tan(gamma). That is exact: the body survives a tilt of gamma in every direction if and only if all hold. A segment has one for either side and either end, a point one for each of four directions; where the mesh goes on below the ground, outside of the region, one more asks for h \\>= 0.\n\nHanging, sixteen planes through the point, which make a pyramid inside the cone of the tolerance (they touch it along the pyramid's edges, and come within 2 % of it between them), and one that asks for the lever.\n\nRocking, as many as it takes (some twenty) so that from every tilt between the tolerance and the range the body rolls straight towards the pose, on a floor that may lean by a tenth of a degree. That is sufficient, not necessary: a body may also come back on a detour. Half-spaces that others imply for all that lies in or near the mesh's box are left out. A centre of mass straight above what touches the ground in the pose, and low enough, is always in all of them, but for the height of the facets within the tolerance.\n\n- cost: linear.\n- threads: any.\n- source: standing: Prevost and others, \"Make It Stand\", 2013, figure 2, but with the height of the centre of mass as it is, where the paper takes it for fixed.\n- in C: [`sf_stance_halfspaces()`](crate::sys::sf_stance_halfspaces)"
    };
    (sf_stance_judge) => {
        "Judge a centre of mass.\n\nStanding, a centre of mass that is not above the ground never tips while it lies inside of an edge (a margin of 90 degrees), and has fallen where it lies outside (minus 90 degrees).\n\n- cost: linear in the half-spaces; rocking, seventeen times that of [`sf_mesh_rest()`](crate::sys::sf_mesh_rest) without its hull.\n- threads: any; one at a time for each allocator where the body rocks.\n- in C: [`sf_stance_judge()`](crate::sys::sf_stance_judge)"
    };
    (sf_stance_polygon) => {
        "The support polygon: corners on the ground, counter-clockwise for an eye that `up` points to.\n\nIt has 2 corners where all contacts lie on a line, and 1 where they are one point, or where the body hangs: the point itself.\n\n- cost: linear.\n- threads: any.\n- in C: [`sf_stance_polygon()`](crate::sys::sf_stance_polygon)"
    };
    (sf_stand) => {
        "A shape on its way to standing."
    };
    (sf_stand_cavity) => {
        "The cavity: closed surfaces whose triangles look into the hollow; none before the first round.\n\n- cost: constant.\n- threads: any, while no round runs.\n- in C: [`sf_stand_cavity()`](crate::sys::sf_stand_cavity)"
    };
    (sf_stand_create: mesh, stances, handles) => {
        "Prepare a shape: voxels, weights of handles, the energy of bending.\n\nContacts of the stances are put onto the ground ([`sf_stance_flatten()`](crate::sys::sf_stance_flatten)), and the cells that they lie in, with the point that it hangs from, are a handle of their own that holds still.\n\n- `mesh`: the surface, closed and oriented outwards, in mm, with z the build direction\n- `stances`: what it is to rest on: each with its own up and contacts\n- `handles`: what bends it, in the mesh's frame, points or balls; those that are locked keep their pose\n- cost: weights, and 0.2 s for the energy of 172 000 triangles and six handles.\n- threads: any; one at a time for each allocator.\n- source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, \"Make It Stand: Balancing Shapes for 3D Fabrication\", SIGGRAPH 2013.\n- in C: [`sf_stand_create()`](crate::sys::sf_stand_create)"
    };
    (sf_stand_density) => {
        "What 1 mm3 weighs in each voxel of [`sf_stand_grid()`](crate::sys::sf_stand_grid), in (layer, y, x) order, with those that were carved; NULL where that is 1 everywhere, and before the first round.\n\n- cost: constant.\n- threads: any, while no round runs.\n- in C: [`sf_stand_density()`](crate::sys::sf_stand_density)"
    };
    (sf_stand_describe) => {
        "How far a shape has come.\n\n- cost: constant.\n- threads: any, while no round runs.\n- in C: [`sf_stand_describe()`](crate::sys::sf_stand_describe)"
    };
    (sf_stand_get_pose) => {
        "Pose of a handle.\n\n- cost: constant.\n- threads: any, while no round runs.\n- in C: [`sf_stand_get_pose()`](crate::sys::sf_stand_get_pose)"
    };
    (sf_stand_grid) => {
        "The carved shape as voxels; NULL before the first round.\n\n- cost: constant.\n- threads: any, while no round runs.\n- in C: [`sf_stand_grid()`](crate::sys::sf_stand_grid)"
    };
    (sf_stand_options.ballast) => {
        "Masses that sit in the shape, where they are before bending; copied; may be NULL where there are none."
    };
    (sf_stand_outer) => {
        "The outside: the triangles of the mesh that was handed in, with its vertices where they are now.\n\n- cost: constant.\n- threads: any, while no round runs.\n- in C: [`sf_stand_outer()`](crate::sys::sf_stand_outer)"
    };
    (sf_stand_round) => {
        "One round: bend, then carve the shape as it is then.\n\nThe first only carves.\n\n- cost: voxels, the exact wall, a carving and a few steps of the solver: some 0.2 s at 172 000 triangles and 80 000 voxels with the paper's carving.\n- threads: one for each shape.\n- in C: [`sf_stand_round()`](crate::sys::sf_stand_round)"
    };
    (sf_stand_run) => {
        "Rounds until the shape is safe and bent no more than it must be, or nothing improves.\n\n- cost: rounds_max rounds at most.\n- threads: one for each shape.\n- in C: [`sf_stand_run()`](crate::sys::sf_stand_run)"
    };
    (sf_stand_set_pose: handle, pose, lock) => {
        "Pose a handle by hand: the next round starts from it, and the count of rounds anew.\n\n- `handle`: which of those handed in\n- `pose`: what becomes of it; its numbers finite, its scale above 0\n- `lock`: 1: it keeps this pose; 0: it may be moved on\n- cost: constant.\n- threads: one for each shape.\n- in C: [`sf_stand_set_pose()`](crate::sys::sf_stand_set_pose)"
    };
    (sf_stand_stance) => {
        "A stance of the shape as it is; NULL for one that there is not.\n\n- cost: constant.\n- threads: any, while no round runs.\n- in C: [`sf_stand_stance()`](crate::sys::sf_stand_stance)"
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
    (sf_tets) => {
        "Tetrahedra that own their arrays, or follow a refinement."
    };
    (sf_tets_check) => {
        "Look at tetrahedra: their volumes, and whether they conform.\n\n- cost: sorting the faces.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_tets_check()`](crate::sys::sf_tets_check)"
    };
    (sf_tets_create) => {
        "Make tetrahedra of somebody's arrays, which are copied.\n\nThose that are inverted or flat are taken all the same: [`sf_tets_check()`](crate::sys::sf_tets_check) counts them.\n\n- cost: linear.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_tets_create()`](crate::sys::sf_tets_create)"
    };
    (sf_tets_get_view) => {
        "View of tetrahedra.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_tets_get_view()`](crate::sys::sf_tets_get_view)"
    };
    (sf_tets_of_refinement: step) => {
        "The tetrahedra of a refined cage of dimension 3: six for each cell of a step.\n\nTheir positions and values are those of the refinement, and change with it. Tetrahedron t lies in cell t / 6 of the step.\n\n- `step`: 1 to the number of steps\n- cost: linear; 96 bytes for each cell, as much again for each property that jumps.\n- threads: any; one at a time for each allocator.\n- source: C. Altenhofen and others, \"Continuous property gradation for multi-material 3D-printed objects\", 2018, \"Implicit tetrahedrization\".\n- in C: [`sf_tets_of_refinement()`](crate::sys::sf_tets_of_refinement)"
    };
    (sf_tets_set_values: channel, first) => {
        "Change values of a property of tetrahedra that own theirs.\n\n- `channel`: which property\n- `first`: the first value\n- cost: O(count).\n- threads: one for these tetrahedra.\n- in C: [`sf_tets_set_values()`](crate::sys::sf_tets_set_values)"
    };
    (sf_tets_view) => {
        "Tetrahedra in somebody's arrays."
    };
    (sf_tets_view.corners) => {
        "Four points each; the second, third and fourth are counter-clockwise seen from the first's other side, so that (b - a) x (c - a) . (d - a) is above 0."
    };
    (sf_threemf) => {
        "A 3MF file that was read."
    };
    (sf_threemf_colour) => {
        "A material, or a colour of a group."
    };
    (sf_threemf_contours) => {
        "The slices of all that a document builds, in their places: parts and solid supports.\n\nWhat is inside is what the contours wind around, [`SF_CONTOUR_NONZERO`](crate::sys::SF_CONTOUR_NONZERO): the specification's fill, where holes turn the other way than what they are holes in. Contours of several items stand beside one another in each layer, so their layers must have the same heights.\n\n- cost: the points.\n- threads: any that read; one at a time for each allocator.\n- source: 3MF Consortium, \"3MF Slice Extension\" 1.0.\n- in C: [`sf_threemf_contours()`](crate::sys::sf_threemf_contours)"
    };
    (sf_threemf_get_view) => {
        "What a document holds.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_threemf_get_view()`](crate::sys::sf_threemf_get_view)"
    };
    (sf_threemf_is_served) => {
        "Whether this build reads and writes 3MF.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_threemf_is_served()`](crate::sys::sf_threemf_is_served)"
    };
    (sf_threemf_is_sliced) => {
        "Whether all that a document builds has slices: its parts and solid supports.\n\n- cost: the number of items.\n- threads: any.\n- in C: [`sf_threemf_is_sliced()`](crate::sys::sf_threemf_is_sliced)"
    };
    (sf_threemf_item) => {
        "An object in its place on the printer's bed. Components are resolved: each of them is one."
    };
    (sf_threemf_kind) => {
        "What an object is for, as its file says."
    };
    (sf_threemf_merge: limits) => {
        "One mesh of all that a document builds: parts and solid supports, in their places.\n\n- `limits`: NULL for [`sf_read_limits_default()`](crate::sys::sf_read_limits_default); items repeat what they place\n- cost: the size of the mesh.\n- threads: any that read; one at a time for each allocator.\n- in C: [`sf_threemf_merge()`](crate::sys::sf_threemf_merge)"
    };
    (sf_threemf_object) => {
        "An object that has triangles of its own."
    };
    (sf_threemf_read) => {
        "Read a 3MF file whole.\n\nLengths become mm, whatever the file's unit. Components become items, one for each place that an object takes. Textures, composites and mixtures of properties are passed over: what they cover has no colour. Metadata, thumbnails, print tickets and elements that are not known are passed over too.\n\nWhat unfolds is bounded: an XML part to 250 times its size in the archive and 1 MiB, all parts together to `bytes_max`, components to 64 within one another and 100,000 items. A DOCTYPE is refused, and so are names that lead out of the archive, two parts with one name, objects that contain themselves, transforms that flatten, and numbers that are not finite.\n\n- cost: the file is held in memory while it is read; one pass over what its parts unfold to.\n- threads: any, on distinct sources; one at a time for each allocator.\n- source: 3MF Consortium, \"3MF Core Specification\" 1.3, \"Production Extension\" 1.1, \"Materials and Properties Extension\" 1.2, \"Slice Extension\" 1.0.\n- in C: [`sf_threemf_read()`](crate::sys::sf_threemf_read)"
    };
    (sf_tip) => {
        "The voxels that a brush covers, around an anchor, which comes to lie on each dab."
    };
    (sf_tip_create: shape, radius_vx) => {
        "Make a tip by formula: the voxels whose centres lie in the shape, its centre on a voxel's centre.\n\nThe anchor is the middle voxel, which is always covered.\n\n- `shape`: which\n- `radius_vx`: half its extents along x, y and z, in voxels; each 0 to 1024\n- cost: the voxels of the box around it.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_tip_create()`](crate::sys::sf_tip_create)"
    };
    (sf_tip_create_mask: mask, anchor) => {
        "Make a tip of any mask: its solid voxels.\n\nA mesh becomes a tip by way of [`sf_grid_voxelize()`](crate::sys::sf_grid_voxelize) on the model's pitch and layer height.\n\n- `mask`: a grid of any size; only its voxels count, not where its lattice lies\n- `anchor`: its voxel that comes to lie on each dab; may lie outside it\n- cost: a pass over the mask.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_tip_create_mask()`](crate::sys::sf_tip_create_mask)"
    };
    (sf_tip_create_stamp: row_bytes, width, height, depth_vx) => {
        "Make a stamp of an image of heights: above pixel (x, y) as many voxels as its value says.\n\nPixel values 0 to 255 stand for 0 to depth_vx voxels, rounded to the nearest. The anchor lies in the lowest layer, in the middle of the image.\n\n- `row_bytes`: bytes from one row to the next, at least the width\n- `width`: pixels along x, 1 to 4096\n- `height`: rows, 1 to 4096\n- `depth_vx`: voxels that 255 stands for, 1 to 4096\n- cost: the voxels of the box around it.\n- threads: any; one at a time for each allocator.\n- in C: [`sf_tip_create_stamp()`](crate::sys::sf_tip_create_stamp)"
    };
    (sf_tip_mask) => {
        "The mask of a tip, and its anchor in it.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_tip_mask()`](crate::sys::sf_tip_mask)"
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
    (sf_weights) => {
        "Weights of the points of a solid for its handles: the values at the corners of its cells."
    };
    (sf_weights_at) => {
        "Weights at a point, and how they change there.\n\nBetween corners values are interpolated along each axis in turn, so that they are continuous and their gradient jumps from cell to cell; on a face between two cells the gradient is that of the upper one, if there is one. Outside the domain a point has the values of the closest point in it, and the gradient there without the axes along which it lies outside that point's cell; more than two cells away, of a point that is about as close.\n\n- cost: constant; a few times as much outside the domain.\n- threads: any.\n- in C: [`sf_weights_at()`](crate::sys::sf_weights_at)"
    };
    (sf_weights_centers) => {
        "The centres of all handles: x, y, z of each, in mm, as they were handed in.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_weights_centers()`](crate::sys::sf_weights_centers)"
    };
    (sf_weights_create: solid, handles) => {
        "Find the weights of a solid for its handles.\n\nCells are blocks of voxels that hold a solid one; along each axis as many voxels as make them nearly cubes. On their corners lives the Laplacian of seven points, made of finite volumes, with no flow through the surface of the cells. CLAMPED weights have the least integral of the squared Laplacian among all with 1 at their handle and 0 at the others; then they are cut off at 0 and 1, and divided by their sum. BOUNDED weights have the least among those that lie within 0 and 1, each handle for itself, and are then divided by their sum. Either way they lie in \\[0, 1\\], sum to 1 up to rounding, and are exactly 1 on their handle's corners and 0 on those of others.\n\nWhat the solver leaves is given as a residual. CLAMPED: the largest last correction, estimated from the decay of the residual's norm, at most `tolerance`. BOUNDED: the largest |w - clamp(w - g / d)| over handles and corners, g the gradient and d its own derivative; at most `tolerance`.\n\nA piece of the solid that touches no handle follows the closest point of a piece that does, as one. Handles may not share corners: they must lie two cells apart.\n\nEach handle must touch the solid: the centre of a point or a ball lies in a cell, and a base has solid voxels.\n\n- `solid`: the voxels; not kept\n- `handles`: the handles; not kept\n- cost: some 30 steps for each four handles, each a few passes over the corners: about 0.15 s for six handles and 20 000 cells on one core. BOUNDED: about twenty times as much.\n- threads: any; one at a time for each allocator.\n- source: A. Jacobson, I. Baran, J. Popovic, O. Sorkine, \"Bounded Biharmonic Weights for Real-Time Deformation\", SIGGRAPH 2011.\n- in C: [`sf_weights_create()`](crate::sys::sf_weights_create)"
    };
    (sf_weights_describe) => {
        "What weights were made of.\n\n- cost: constant.\n- threads: any.\n- in C: [`sf_weights_describe()`](crate::sys::sf_weights_describe)"
    };
    (sf_weights_fold) => {
        "Whether a blend folds the solid over itself: its derivative in the eight corners of each cell.\n\nA cell's own gradients are used, so that each corner is looked at once for every cell around it.\n\n- cost: one pass over the cells, some 2 us each for six handles.\n- threads: any.\n- in C: [`sf_weights_fold()`](crate::sys::sf_weights_fold)"
    };
    (sf_weights_sample) => {
        "Weights at many points.\n\n- cost: two passes over the points; about 0.1 us each for six handles.\n- threads: any that write to distinct arrays.\n- in C: [`sf_weights_sample()`](crate::sys::sf_weights_sample)"
    };
    (sf_weights_unbend: tolerance_mm) => {
        "Where points lie before bending: the inverse of a blend.\n\nNewton's method with the gradients of the weights, each point from the guess handed in or from what the point before it leads to, whichever is closer; so points should come row by row. What fails, or leads out of the domain, is tried from the cells that are bent to where it lies. A rest point in the domain is worth more than one outside; where the bent solid folds over itself more than one is right, and one of them is found.\n\nA point outside the bent solid may have a rest point outside the domain, where the weights reach on as [`sf_weights_at()`](crate::sys::sf_weights_at) says, or none.\n\n- `tolerance_mm`: how near to its bent point the blend of a rest point must come, \\> 0\n- cost: some three evaluations a point: about 1 us each for six handles, and half of that where guesses are good.\n- threads: any that write to distinct arrays; one at a time for each allocator.\n- in C: [`sf_weights_unbend()`](crate::sys::sf_weights_unbend)"
    };
}

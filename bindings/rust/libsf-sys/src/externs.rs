// SPDX-License-Identifier: MIT
// The interface of libsf. Written by bindings/rust/generate.py: change the headers instead.

use core::ffi::{c_char, c_int, c_void};
use core::marker::{PhantomData, PhantomPinned};

/// Version of these headers: what breaks programs raises it.
pub const SF_VERSION_MAJOR: c_int = 0;

/// And what adds to them; before 1.0 it may break them as well.
pub const SF_VERSION_MINOR: c_int = 1;

/// And what mends them.
pub const SF_VERSION_PATCH: c_int = 0;

/// The three as one text, as sf_version() gives that of the library.
pub const SF_VERSION_STRING: &[u8; 6] = b"0.1.0\0";

/// Size of the sentence in an sf_fault, its final zero included, in bytes.
pub const SF_FAULT_MESSAGE_SIZE: c_int = 232;

/// Largest width and height of a slice, in voxels.
pub const SF_EXTENT_MAX: u32 = 65535;

/// Largest reach of a structuring element along x and along y, in voxels.
pub const SF_REACH_MAX: u32 = 255;

/// Largest number of layers in a grid.
pub const SF_LAYER_MAX: u32 = 2147483647;

/// Most passes of smoothing; the surface has long settled by then.
pub const SF_SMOOTH_PASSES_MAX: c_int = 1000;

/// Most handles of one solid.
pub const SF_HANDLE_MAX: u32 = 64;

/// Bytes of a property's name, the 0 at its end included.
pub const SF_PROPERTY_NAME_SIZE: c_int = 48;

/// Largest number of properties of one mesh.
pub const SF_PROPERTY_MAX: c_int = 64;

/// Largest number of corners of a face.
pub const SF_CAGE_POLYGON_MAX: c_int = 32;

/// Largest number of points, and of corners of all cells.
pub const SF_CAGE_POINT_MAX: u32 = 2147483647;

/// From this sharpness on a crease or a point stays sharp for ever.
pub const SF_SHARP: f64 = 10.0;

/// Farthest that a point may lie from the corner of a lattice, in voxels along x or y.
pub const SF_CONTOUR_REACH_MAX: f64 = 131072.0;

/// Longest gap that bridges may span, in voxels.
pub const SF_BRIDGE_SPAN_MAX: u32 = 32767;

/// Smallest overhang angle that a rule can be made for, in radians: 5 degrees.
pub const SF_RULE_ANGLE_MIN_RAD: f64 = 0.08726646259971647;

/// Largest overhang angle that a rule can be made for, in radians: 85 degrees.
pub const SF_RULE_ANGLE_MAX_RAD: f64 = 1.4835298641951802;

/// Bed layer chosen by the shape itself: the first slice that holds matter.
///
/// Where a bed layer is given instead, its slice rests on the bed whole, whatever lies below.
/// Matter below it hangs in the air: a check counts it as unsupported where nothing below carries
/// it and as trimmed everywhere, and a trim removes it.
pub const SF_BED_AUTO: u32 = 4294967295;

/// cause of a finding that no other finding causes.
pub const SF_FINDING_ROOT: u32 = 4294967295;

/// Size of a fingerprint in bytes.
pub const SF_SHA256_SIZE: c_int = 32;

/// Most different elements that a table of a chip can hold.
pub const SF_CHIP_ELEMENT_MAX: u32 = 255;

/// Largest number of regions.
pub const SF_DENSITY_REGIONS_MAX: u32 = 65534;

/// Largest number of steps.
pub const SF_REFINE_STEP_MAX: u32 = 12;

/// grow_voxels of a finding that no growth can fix.
pub const SF_COST_NONE: u64 = 18446744073709551615;

/// Largest number of materials.
pub const SF_MATERIAL_MAX: u32 = 16;

/// Largest number of voxels in a mask.
pub const SF_MASK_SIZE_MAX: u32 = 4194304;

/// Bytes of a material's name, the 0 at its end included.
pub const SF_MATERIAL_NAME_SIZE: c_int = 48;

/// The piece of a place that there is not.
pub const SF_NO_PIECE: u32 = 4294967295;

/// Largest number of samples of a curve.
pub const SF_CURVE_SAMPLE_MAX: u32 = 65536;

/// Largest number of materials in a mixture.
pub const SF_MIXTURE_MATERIAL_MAX: u32 = 6;

/// Largest number of its properties.
pub const SF_MIXTURE_PROPERTY_MAX: u32 = 8;

/// Largest number of measured mixtures.
pub const SF_MIXTURE_MAX: u32 = 256;

/// rounds: stop at the first result, without improving it.
pub const SF_REPAIR_FIRST: u32 = 4294967295;

/// A cost that there is none of: what it would be the cost of is not possible.
pub const SF_REPAIR_NO_COST: u64 = 18446744073709551615;

/// Largest number of voxels of a lattice that is sampled: 2^40.
pub const SF_SAMPLE_VOXEL_MAX: u64 = 1099511627776;

/// Most passes of a smooth-trim.
pub const SF_BRUSH_PASSES_MAX: u32 = 16;

/// What stands for no colour and no stack.
pub const SF_THREEMF_NONE: u32 = 4294967295;

/// What became of a call. Numbers are fixed and never reused.
///
/// Anything but SF_OK changed no object and no output, with one exception: SF_ERR_CAPACITY may
/// leave the number of places needed in the call's count, where its comment says so. An sf_fault is
/// there to be filled, and a sink keeps the bytes that it has had.
pub type sf_status = c_int;
/// done
pub const SF_OK: sf_status = 0;
/// a pointer is NULL or a value lies outside its documented range
pub const SF_ERR_ARGUMENT: sf_status = 1;
/// two objects that must agree in size or lattice do not
pub const SF_ERR_SHAPE: sf_status = 2;
/// the caller's buffer is too small; the need was reported
pub const SF_ERR_CAPACITY: sf_status = 3;
/// a size does not fit the machine or the library's limits
pub const SF_ERR_OVERFLOW: sf_status = 4;
/// the allocator returned NULL
pub const SF_ERR_MEMORY: sf_status = 5;
/// a source or sink failed
pub const SF_ERR_IO: sf_status = 6;
/// the bytes are not what the format allows
pub const SF_ERR_FORMAT: sf_status = 7;
/// well-formed, but not served by this rule, build or version
pub const SF_ERR_UNSUPPORTED: sf_status = 8;
/// the task was cancelled
pub const SF_ERR_CANCELLED: sf_status = 9;
/// a promise of the library was broken: please report it
pub const SF_ERR_INTERNAL: sf_status = 10;
/// what must stay cannot be carried within what may be there
pub const SF_ERR_INFEASIBLE: sf_status = 11;
/// number of codes, not a code
pub const SF_STATUS_COUNT: sf_status = 12;

/// What the voxels outside a slice are taken for.
pub type sf_border = c_int;
/// nothing outside
pub const SF_BORDER_EMPTY: sf_border = 0;
/// matter everywhere outside
pub const SF_BORDER_SOLID: sf_border = 1;

/// Which voxels of a slice count as neighbours.
pub type sf_connectivity = c_int;
/// four neighbours: those that share an edge
pub const SF_CONNECT_EDGES: sf_connectivity = 4;
/// eight neighbours: those that share an edge or a corner
pub const SF_CONNECT_CORNERS: sf_connectivity = 8;

/// Instruction sets that kernels are written for, from plain to fast.
pub type sf_isa = c_int;
/// one bit at a time: the specification
pub const SF_ISA_REFERENCE: sf_isa = 0;
/// 64-bit words, plain C
pub const SF_ISA_WORD: sf_isa = 1;
/// x86, 128 bits
pub const SF_ISA_SSE2: sf_isa = 2;
/// Arm, 128 bits
pub const SF_ISA_NEON: sf_isa = 3;
/// x86, 256 bits
pub const SF_ISA_AVX2: sf_isa = 4;
/// x86, 512 bits, with VBMI2
pub const SF_ISA_AVX512: sf_isa = 5;
/// number of instruction sets, not one of them
pub const SF_ISA_COUNT: sf_isa = 6;

/// How inside is decided. A voxel is solid or not at its centre, but for SF_FILL_SURFACE.
pub type sf_fill = c_int;
/// winding, after turning what looks the wrong way
pub const SF_FILL_AUTO: sf_fill = 0;
/// inside after an odd number of crossings
pub const SF_FILL_PARITY: sf_fill = 1;
/// inside where the winding number is at least one half
pub const SF_FILL_WINDING: sf_fill = 2;
/// every voxel that the surface touches, and nothing else
pub const SF_FILL_SURFACE: sf_fill = 3;

/// What a handle holds.
pub type sf_handle_kind = c_int;
/// the cell that its centre lies in
pub const SF_HANDLE_POINT: sf_handle_kind = 0;
/// that cell, and the corners of cells within a radius
pub const SF_HANDLE_BALL: sf_handle_kind = 1;
/// the cells that hold a voxel of a region
pub const SF_HANDLE_BASE: sf_handle_kind = 2;

/// How weights are found.
pub type sf_weights_method = c_int;
/// the smoothest of all, cut off at 0 and 1: fast
pub const SF_WEIGHTS_CLAMPED: sf_weights_method = 0;
/// the smoothest of those within 0 and 1, each handle for itself
pub const SF_WEIGHTS_BOUNDED: sf_weights_method = 1;

/// Cage file formats.
pub type sf_cage_format = c_int;
/// judge by the first words
pub const SF_CAGE_FORMAT_AUTO: sf_cage_format = 0;
/// Medit .mesh, text, versions 1 to 4
pub const SF_CAGE_FORMAT_MEDIT: sf_cage_format = 1;
/// MFEM .mesh, version 1.x, conforming
pub const SF_CAGE_FORMAT_MFEM: sf_cage_format = 2;
/// legacy VTK, unstructured grid, text and binary
pub const SF_CAGE_FORMAT_VTK: sf_cage_format = 3;

/// How a body comes to rest.
pub type sf_stance_kind = c_int;
/// on its lowest vertices, and stays when it is tilted
pub const SF_STANCE_STAND: sf_stance_kind = 0;
/// from a point, tied to a string
pub const SF_STANCE_HANG: sf_stance_kind = 1;
/// on a rounded base, and rolls back to the pose asked for
pub const SF_STANCE_ROCK: sf_stance_kind = 2;

/// What a set of polygons has inside.
pub type sf_contour_fill = c_int;
/// what the polygons wind around, as their turns sum up: not 0
pub const SF_CONTOUR_NONZERO: sf_contour_fill = 0;
/// what an odd number of polygons encloses
pub const SF_CONTOUR_EVEN_ODD: sf_contour_fill = 1;

/// Which voxels below can carry a voxel.
pub type sf_rule_kind = c_int;
/// the nine voxels below: the papers' rule; takes no angle
pub const SF_RULE_BOX3: sf_rule_kind = 0;
/// a schedule of pluses and squares that stays within the asked angle
pub const SF_RULE_OCTAGON: sf_rule_kind = 1;
/// an ellipse in voxels, a disk in mm, the same for layers of one height
pub const SF_RULE_DISK: sf_rule_kind = 2;
/// the exact angle: what one layer does not reach the next may, added up
pub const SF_RULE_SLACK: sf_rule_kind = 3;

/// What kind of fault a finding is.
pub type sf_finding_kind = c_int;
/// matter that reaches too far out from what is carried
pub const SF_FINDING_OVERHANG: sf_finding_kind = 0;
/// a whole component of a slice with nothing that carries it
pub const SF_FINDING_ISLAND: sf_finding_kind = 1;

/// How a solid is carved.
pub type sf_carve_mode = c_int;
/// the result prints without supports where the solid did
pub const SF_CARVE_SUPPORT_FREE: sf_carve_mode = 0;
/// the paper's: in the order of the distance to a plane, for powder beds and for comparison.
/// Ceilings may hang
pub const SF_CARVE_PLANE: sf_carve_mode = 1;

/// When there is enough carved.
pub type sf_carve_goal = c_int;
/// as much matter stays as can while every half-space holds; where they cannot all hold, as
/// SF_CARVE_NEAREST; support-free: _DEEPEST
pub const SF_CARVE_ENOUGH: sf_carve_goal = 0;
/// the paper's: least distance to the targets, each of them the place of the safe region that is
/// nearest to the centre of mass. Support-free: as SF_CARVE_ENOUGH
pub const SF_CARVE_NEAREST: sf_carve_goal = 1;
/// largest least slack: as far inside all half-spaces as can be
pub const SF_CARVE_DEEPEST: sf_carve_goal = 2;
/// support-free: as little matter stays as can while every half-space holds; where they cannot all
/// hold, as SF_CARVE_DEEPEST
pub const SF_CARVE_LIGHTEST: sf_carve_goal = 3;

/// What made a shape.
pub type sf_operation = c_int;
/// nothing was changed
pub const SF_OPERATION_CHECK: sf_operation = 0;
/// matter was taken away only
pub const SF_OPERATION_TRIM: sf_operation = 1;
/// matter was added only
pub const SF_OPERATION_GROW: sf_operation = 2;
/// both
pub const SF_OPERATION_REPAIR: sf_operation = 3;
/// matter was taken away only
pub const SF_OPERATION_PRESERVE: sf_operation = 4;

/// Mesh file formats.
pub type sf_mesh_format = c_int;
/// reading only: judge by the bytes
pub const SF_MESH_FORMAT_AUTO: sf_mesh_format = 0;
/// text and binary in, binary out
pub const SF_MESH_FORMAT_STL: sf_mesh_format = 1;
/// in and out
pub const SF_MESH_FORMAT_OBJ: sf_mesh_format = 2;
/// text and both binary orders in, binary little-endian out
pub const SF_MESH_FORMAT_PLY: sf_mesh_format = 3;
/// text, in only
pub const SF_MESH_FORMAT_OFF: sf_mesh_format = 4;
/// .3mf in and out, where sf_threemf_is_served(): \<sf/threemf.h\>
pub const SF_MESH_FORMAT_THREEMF: sf_mesh_format = 5;
/// .glb and .gltf in, where sf_gltf_is_served(); .glb out: \<sf/gltf.h\>
pub const SF_MESH_FORMAT_GLTF: sf_mesh_format = 6;

/// Kinds of CLI files.
pub type sf_contour_format = c_int;
/// numbers as text, which read back as the same doubles
pub const SF_CONTOUR_CLI_TEXT: sf_contour_format = 0;
/// floats of 32 bits
pub const SF_CONTOUR_CLI_BINARY: sf_contour_format = 1;

/// What a region is given by.
pub type sf_density_shape = c_int;
/// voxels whose centre lies in low_mm \<= centre \< high_mm
pub const SF_DENSITY_BOX: sf_density_shape = 0;
/// voxels whose centre lies in the solid that a mesh bounds
pub const SF_DENSITY_MESH: sf_density_shape = 1;
/// voxels that are solid in a grid
pub const SF_DENSITY_MASK: sf_density_shape = 2;

/// Which weights points inside of a solid get.
pub type sf_refine_rules = c_int;
/// Joy and MacCracken's everywhere
pub const SF_REFINE_STANDARD: sf_refine_rules = 0;
/// where the cage is extruded along a line that other than four cells go around, the cross section
/// is as the surface of that outline
pub const SF_REFINE_SEPARABLE: sf_refine_rules = 1;

/// What is wrong with a void.
pub type sf_void_kind = c_int;
/// closed for good: what is in it cannot leave
pub const SF_VOID_TRAP: sf_void_kind = 0;
/// closed against the film while its layers print, and open later
pub const SF_VOID_CUP: sf_void_kind = 1;

/// What matter a path may end on.
pub type sf_landing = c_int;
/// any matter from the bed layer up, as in the paper; under slack, matter that hangs in the air has
/// no reach to spare
pub const SF_LANDING_ANY: sf_landing = 0;
/// only what is alive under the whole rule; other matter is passed through, a step like any other,
/// and lies in the path
pub const SF_LANDING_ALIVE: sf_landing = 1;

/// What a path ends on.
pub type sf_path_end = c_int;
/// its last voxel rests on matter of the layer below
pub const SF_PATH_END_MATTER: sf_path_end = 0;
/// its last voxel lies on the bed
pub const SF_PATH_END_BED: sf_path_end = 1;
/// its last voxel is exempt: it needs nothing below it
pub const SF_PATH_END_HELD: sf_path_end = 2;

/// What a path costs.
pub type sf_path_cost = c_int;
/// voxels, and on the bed the distance to its matter: as told above
pub const SF_PATH_COST_COUNT: sf_path_cost = 0;
/// for each voxel the distance to the closest matter of its slice, in voxels, rounded up, and one
/// where the slice is empty: the paper's first cost, which it found too dear
pub const SF_PATH_COST_NEARNESS: sf_path_cost = 1;

/// Between which voxels a mask keeps what is alike apart.
pub type sf_mask_kind = c_int;
/// within each slice, and along each column: slices look even
pub const SF_MASK_SLICE: sf_mask_kind = 0;
/// in all directions alike: the solid is even, its slices less so
pub const SF_MASK_ISOTROPIC: sf_mask_kind = 1;

/// What tones are kept in.
pub type sf_tone_type = c_int;
/// uint8_t: 255 is all
pub const SF_TONE_U8: sf_tone_type = 0;
/// float: 1 is all
pub const SF_TONE_F32: sf_tone_type = 1;
/// double: 1 is all
pub const SF_TONE_F64: sf_tone_type = 2;

/// Formats of jobs.
pub type sf_job_format = c_int;
/// a zip archive with config.ini and a PNG for each layer
pub const SF_JOB_SL1: sf_job_format = 1;
/// .photon of the cbddlp family, versions 1 and 2, one bit a pixel
pub const SF_JOB_PHOTON: sf_job_format = 2;

/// Which way a curve goes.
pub type sf_trend = c_int;
/// the way that changes the samples less; up where both do alike
pub const SF_TREND_AUTO: sf_trend = 0;
/// y never falls with x
pub const SF_TREND_RISING: sf_trend = 1;
/// y never rises with x
pub const SF_TREND_FALLING: sf_trend = 2;

/// How the weight of a brush falls from its middle, with t the distance over the radius.
pub type sf_falloff = c_int;
/// 1 up to the radius
pub const SF_FALLOFF_CONSTANT: sf_falloff = 0;
/// 1 - t
pub const SF_FALLOFF_LINEAR: sf_falloff = 1;
/// 1 - 3 t^2 + 2 t^3
pub const SF_FALLOFF_SMOOTH: sf_falloff = 2;
/// (g(t) - g(1)) / (1 - g(1)), g(t) = exp(-9 t^2 / 2): a bell whose standard deviation is a third
/// of the radius, 0 at the rim
pub const SF_FALLOFF_GAUSSIAN: sf_falloff = 3;

/// Which points a brush takes.
pub type sf_paint_where = c_int;
/// all
pub const SF_PAINT_ALL: sf_paint_where = 0;
/// those on the boundary
pub const SF_PAINT_OUTSIDE: sf_paint_where = 1;
/// the others
pub const SF_PAINT_INSIDE: sf_paint_where = 2;

/// What is done to a value v of weight w.
pub type sf_paint_operation = c_int;
/// v + w (amount - v)
pub const SF_PAINT_SET: sf_paint_operation = 0;
/// v + w amount
pub const SF_PAINT_ADD: sf_paint_operation = 1;
/// v + w amount (mean of its neighbours along edges - v), amount 0 to 1
pub const SF_PAINT_SMOOTH: sf_paint_operation = 2;

/// What is kept of the brush, where something must be.
pub type sf_preserve_mode = c_int;
/// word by word: straight below what hangs, else the nearest. Keeps more than is needed. Rules with
/// slack or bridges have no words to do it by: there it is sf_grid_complete()
pub const SF_PRESERVE_FAST: sf_preserve_mode = 0;
/// no kept voxel of the brush could be removed as well without losing something outside the brush;
/// greedy, then pruned
pub const SF_PRESERVE_IRREDUNDANT: sf_preserve_mode = 1;
/// thick: the core of what hangs, then struts of strut_width, then single voxels where nothing
/// thicker fits
pub const SF_PRESERVE_CORE: sf_preserve_mode = 2;
/// the paper's text: remove all, then from the slice above the brush to the one below it unite each
/// with the erosion of the one above. May leave unsupported matter, and add some
pub const SF_PRESERVE_PAPER_TEXT: sf_preserve_mode = 3;
/// the paper's shader: from the top down a voxel of the brush stays where all above it are solid.
/// May leave unsupported matter
pub const SF_PRESERVE_PAPER_SHADER: sf_preserve_mode = 4;

/// The shapes of tips that are made by formula.
pub type sf_tip_shape = c_int;
/// an ellipsoid
pub const SF_TIP_SPHERE: sf_tip_shape = 0;
/// a box along the axes
pub const SF_TIP_BOX: sf_tip_shape = 1;
/// an elliptic cylinder, upright
pub const SF_TIP_CYLINDER: sf_tip_shape = 2;
/// an elliptic cone, its point up
pub const SF_TIP_CONE: sf_tip_shape = 3;

/// What a brush does.
pub type sf_brush_kind = c_int;
/// adds what of the tips is carried; touches nothing else
pub const SF_BRUSH_ADD_TRIM: sf_brush_kind = 0;
/// removes what carries nothing; touches nothing else
pub const SF_BRUSH_REMOVE_PRESERVE: sf_brush_kind = 1;
/// adds the tips, and below them what they need
pub const SF_BRUSH_ADD_GROW: sf_brush_kind = 2;
/// removes the tips, and above them what then hangs
pub const SF_BRUSH_REMOVE_TRIM: sf_brush_kind = 3;
/// levels bumps and dents, then removes what hangs
pub const SF_BRUSH_SMOOTH_TRIM: sf_brush_kind = 4;
/// gives what is there another material
pub const SF_BRUSH_PAINT: sf_brush_kind = 5;
/// number of kinds, not one of them
pub const SF_BRUSH_KIND_COUNT: sf_brush_kind = 6;

/// Steps that are no strokes and need no more said.
pub type sf_session_step = c_int;
/// sf_sculpt_undo()
pub const SF_SESSION_UNDO: sf_session_step = 0;
/// sf_sculpt_redo()
pub const SF_SESSION_REDO: sf_session_step = 1;
/// sf_sculpt_drop_ghosts()
pub const SF_SESSION_DROP_GHOSTS: sf_session_step = 2;

/// How handles are moved.
pub type sf_stand_solver = c_int;
/// quadratic programs, with the safe set as constraint
pub const SF_STAND_PROGRAMS: sf_stand_solver = 0;
/// the paper's gradient descent on a weighed sum; for comparison
pub const SF_STAND_DESCENT: sf_stand_solver = 1;

/// What an object is for, as its file says.
pub type sf_threemf_kind = c_int;
/// a part
pub const SF_THREEMF_MODEL: sf_threemf_kind = 0;
/// a support that is printed as it is
pub const SF_THREEMF_SOLID_SUPPORT: sf_threemf_kind = 1;
/// a support that the printer's program makes solid
pub const SF_THREEMF_SUPPORT: sf_threemf_kind = 2;
/// a surface without an inside
pub const SF_THREEMF_SURFACE: sf_threemf_kind = 3;
/// anything else, which is not printed
pub const SF_THREEMF_OTHER: sf_threemf_kind = 4;

/// A stack of slices that owns its memory.
#[repr(C)]
pub struct sf_grid {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A mesh that owns its arrays and can be appended to.
#[repr(C)]
pub struct sf_mesh {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A voxeliser: slices of a mesh one at a time, with memory for one slab.
#[repr(C)]
pub struct sf_voxelizer {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// Weights of the points of a solid for its handles: the values at the corners of its cells.
#[repr(C)]
pub struct sf_weights {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A cage that owns its arrays.
#[repr(C)]
pub struct sf_cage {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// The steps of one cage.
#[repr(C)]
pub struct sf_cage_history {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A way for one mesh to come to rest.
#[repr(C)]
pub struct sf_stance {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// Layers of contours with their heights; it owns its memory.
#[repr(C)]
pub struct sf_contour_stack {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A streaming check that keeps two layers, and two more while a layer is pushed.
///
/// A voxel that nothing carries counts once; what rests on it is then judged as if it were carried,
/// under slack with no reach to spare.
///
/// Lives in memory of the caller's, takes none of its own, and computes with integers only, so that
/// a printer's controller can run it while it reads a job. It needs no end: the report may be asked
/// for after any layer, and the memory may be reused when it is no longer wanted.
#[repr(C)]
pub struct sf_checker {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A certificate; owns its memory, and refers to no grid.
#[repr(C)]
pub struct sf_certificate {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A check on a chip; lies in memory of the caller's.
#[repr(C)]
pub struct sf_chip {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A file being read.
#[repr(C)]
pub struct sf_file {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A file being written: nothing shows under its path until sf_save_commit().
#[repr(C)]
pub struct sf_save {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A folder of the disk, being read or being written.
#[repr(C)]
pub struct sf_directory {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A cage and what it is after each of some steps.
#[repr(C)]
pub struct sf_refinement {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// Tetrahedra that own their arrays, or follow a refinement.
#[repr(C)]
pub struct sf_tets {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A search for voids in layers as they come, from the bottom up. It owns its memory.
#[repr(C)]
pub struct sf_void_search {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// Finds closest supporting paths in a grid, one at a time.
#[repr(C)]
pub struct sf_path_finder {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// Costs and directions of the closest supporting paths of all voxels of a grid.
#[repr(C)]
pub struct sf_path_map {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A block of ranks, repeated along x, y and z.
#[repr(C)]
pub struct sf_mask {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A mask made ready for a number of materials. Slices are made from it at any time, in any order,
/// by any number of threads.
#[repr(C)]
pub struct sf_halftone {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// Error diffusion from slice to slice: what one voxel could not be, the next ones are.
#[repr(C)]
pub struct sf_diffuser {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// The voxels near the surface of a mesh, a slice at a time.
#[repr(C)]
pub struct sf_shell {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A job being read.
#[repr(C)]
pub struct sf_job {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// Layers being written.
#[repr(C)]
pub struct sf_layers {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A cage with all that evaluation needs.
#[repr(C)]
pub struct sf_limit {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// What it takes to find places: boxes around all pieces.
#[repr(C)]
pub struct sf_locator {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A monotone function through measurements.
#[repr(C)]
pub struct sf_curve {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// Measured mixtures, and what lies between them.
#[repr(C)]
pub struct sf_mixture {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A solid on a lattice, ready to be sliced.
#[repr(C)]
pub struct sf_sampler {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// The voxels that a brush covers, around an anchor, which comes to lie on each dab.
#[repr(C)]
pub struct sf_tip {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A shape that is worked on.
#[repr(C)]
pub struct sf_sculpt {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A list of steps.
#[repr(C)]
pub struct sf_session {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A shape on its way to standing.
#[repr(C)]
pub struct sf_stand {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A 3MF file that was read.
#[repr(C)]
pub struct sf_threemf {
    _nothing: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// One piece of parallel work: called once for each index, from any thread of the host.
pub type sf_task_body = Option<unsafe extern "C" fn(context: *mut c_void, index: usize)>;

/// A place for another one: what it is before is found in `moved_mm`. Returns 0 to give up.
pub type sf_cage_place_function = Option<unsafe extern "C" fn(user: *mut c_void, at_mm: *const f64, moved_mm: *mut f64) -> c_int>;

/// A value for a place: what it is before is found in `value`. Returns 0 to give up.
pub type sf_cage_value_function = Option<unsafe extern "C" fn(user: *mut c_void, at_mm: *const f64, value: *mut f64) -> c_int>;

/// Decodes row `y` of layer `layer`: called once for each row, y rising from 0, while a layer is
/// pushed. It hands what is solid to sf_chip_solid() or sf_chip_grey(), and returns SF_OK; any
/// other status ends the push, which returns it. It must call nothing else of the checker that it
/// is given.
pub type sf_chip_decode = Option<unsafe extern "C" fn(user: *mut c_void, chip: *mut sf_chip, layer: u32, y: u32) -> sf_status>;

/// What matter weighs at a place of the shape as it was before bending: 1 is the part's own; above
/// 0, and finite as a float. Asked once a round for each voxel.
pub type sf_density_field = Option<unsafe extern "C" fn(user: *mut c_void, p_mm: *const f64) -> f64>;

/// Whether what is at a place of the shape as it was before bending must stay: 1, or 0 where it may
/// be carved away. Asked once a round for each voxel.
pub type sf_keep_field = Option<unsafe extern "C" fn(user: *mut c_void, p_mm: *const f64) -> c_int>;

/// Why a call failed, in words for the person whose data it was. Filled only on failure.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_fault {
    /// the code that the call returned
    pub status: sf_status,
    /// line in a text file, counted from 1; 0 where it does not apply
    pub line: u32,
    /// byte offset in a file, counted from 0; 0 where it does not apply
    pub offset: u64,
    /// what is wrong, where, and what to do; UTF-8
    pub message: [c_char; 232],
}

/// Where an owner takes its memory from. A NULL allocator argument means the C library's.
///
/// `alloc` returns `size` bytes aligned to `align` (a power of two), or NULL; `size` is never 0.
/// `free` gets the same size back; its pointer is never NULL. Both may be called from the thread
/// that calls the library, and from no other. The struct is copied by owners; `user` must outlive
/// them.
///
/// An allocator serves one thread at a time: of the calls that take it, or that change or destroy
/// an owner made with it, one may run at a time, unless its functions lock. The C library's do.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_allocator {
    /// returns memory, or NULL
    pub alloc: Option<unsafe extern "C" fn(user: *mut c_void, size: usize, align: usize) -> *mut c_void>,
    /// takes it back
    pub free: Option<unsafe extern "C" fn(user: *mut c_void, memory: *mut c_void, size: usize)>,
    /// handed to both; may be NULL
    pub user: *mut c_void,
}

/// Where bytes come from.
///
/// `read` stores up to `capacity` bytes (at least 1 is asked for) and their number in `size`; 0
/// bytes with SF_OK means the end. Short reads are fine. A status other than SF_OK is passed on
/// unchanged; a source that claims more than `capacity` is taken for one that failed, SF_ERR_IO.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_source {
    /// stores the next bytes
    pub read: Option<unsafe extern "C" fn(user: *mut c_void, data: *mut c_void, capacity: usize, size: *mut usize) -> sf_status>,
    /// handed to it; may be NULL
    pub user: *mut c_void,
}

/// Where bytes go. `write` takes all `size` bytes or returns a status, which is passed on
/// unchanged.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_sink {
    /// takes bytes
    pub write: Option<unsafe extern "C" fn(user: *mut c_void, data: *const c_void, size: usize) -> sf_status>,
    /// handed to it; may be NULL
    pub user: *mut c_void,
}

/// Bytes in memory, read front to back; the state behind sf_memory_source.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_memory_cursor {
    /// first byte; may be NULL where size is 0
    pub data: *const c_void,
    /// number of bytes
    pub size: usize,
    /// bytes already read; beyond `size` it is at the end
    pub position: usize,
}

/// How long work talks to its host. Make one with sf_task_default(), fill in what you need.
///
/// `progress` is called on the thread that called the library, with a fraction in \[0, 1\] that
/// never falls during one call. `parallel_for` must call `body(context, i)` once for each i in \[0,
/// count), in any order and on any threads, and return when all are done; NULL runs them one after
/// the other. Results are the same bytes either way.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_task {
    /// sizeof(sf_task), set by sf_task_default()
    pub struct_size: usize,
    /// may be NULL
    pub progress: Option<unsafe extern "C" fn(user: *mut c_void, fraction: f64)>,
    /// or NULL
    pub parallel_for: Option<unsafe extern "C" fn(user: *mut c_void, count: usize, body: sf_task_body, context: *mut c_void)>,
    /// handed to both callbacks; may be NULL
    pub user: *mut c_void,
    /// private: use sf_task_cancel() and sf_task_is_cancelled()
    pub cancel_state: c_int,
    /// private: NULL
    pub whole: *const sf_task,
}

/// A view of a plane of bits. Passed by value; the words belong to somebody else.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_slice {
    /// first word of row 0, 8-byte aligned
    pub words: *mut u64,
    /// voxels along x, 1..SF_EXTENT_MAX
    pub width: u32,
    /// rows along y, 1..SF_EXTENT_MAX
    pub height: u32,
    /// words from one row to the next, at least (width + 63) / 64
    pub stride: usize,
}

/// A half-open rectangle of voxels: x0 \<= x \< x1, y0 \<= y \< y1; empty when x0 \>= x1 or y0 \>=
/// y1.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_rect {
    /// first column and row, and those after the last
    pub x0: u32,
    /// first column and row, and those after the last
    pub y0: u32,
    /// first column and row, and those after the last
    pub x1: u32,
    /// first column and row, and those after the last
    pub y1: u32,
}

/// A structuring element that is symmetric in x and in y and convex along rows.
///
/// Offset (dx, dy) belongs to it when |dy| \<= reach_y and |dx| \<= half_width\[|dy|\]; half_width
/// never grows with |dy|. A single voxel, the plus, the 3x3 square, ellipses and Minkowski sums of
/// these are of this kind.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_element {
    /// 0..SF_REACH_MAX
    pub reach_y: u16,
    /// each 0..SF_REACH_MAX; entries past reach_y unused
    pub half_width: [u16; 256],
}

/// Exact sums over the solid voxels of a slice, in voxel indices.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_slice_sums {
    /// number of solid voxels
    pub count: u64,
    /// sum of x, of y
    pub x: u64,
    /// sum of x, of y
    pub y: u64,
    /// sum of x\*x, y\*y, x\*y; all fit for every slice within the limits
    pub xx: u64,
    /// sum of x\*x, y\*y, x\*y; all fit for every slice within the limits
    pub yy: u64,
    /// sum of x\*x, y\*y, x\*y; all fit for every slice within the limits
    pub xy: u64,
}

/// A maximal run of solid voxels in one row: x0 \<= x \< x1.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_run {
    /// half-open
    pub x0: u32,
    /// half-open
    pub x1: u32,
    /// row
    pub y: u32,
    /// component, once labelled; 0-based
    pub label: u32,
}

/// One connected component of a slice.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_component {
    /// voxels
    pub area: u64,
    /// smallest rectangle around it
    pub bounds: sf_rect,
}

/// A half-open box of voxels: a rectangle in the layers z0 \<= z \< z1.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_box {
    /// first voxel, and one beyond the last, of each axis
    pub x0: u32,
    /// first voxel, and one beyond the last, of each axis
    pub y0: u32,
    /// first voxel, and one beyond the last, of each axis
    pub z0: u32,
    /// first voxel, and one beyond the last, of each axis
    pub x1: u32,
    /// first voxel, and one beyond the last, of each axis
    pub y1: u32,
    /// first voxel, and one beyond the last, of each axis
    pub z1: u32,
}

/// An unsigned integer of 128 bits.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_wide {
    /// low + 2^64 high
    pub low: u64,
    /// low + 2^64 high
    pub high: u64,
}

/// Exact sums over the solid voxels of a grid, in voxel indices.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_moments {
    /// number of solid voxels
    pub count: u64,
    /// first moments
    pub x: sf_wide,
    /// first moments
    pub y: sf_wide,
    /// first moments
    pub z: sf_wide,
    /// second moments
    pub xx: sf_wide,
    /// second moments
    pub yy: sf_wide,
    /// second moments
    pub zz: sf_wide,
    /// second moments
    pub xy: sf_wide,
    /// second moments
    pub xz: sf_wide,
    /// second moments
    pub yz: sf_wide,
}

/// Where the voxels of a grid lie. The lower corner of voxel (0, 0, 0) is at origin_mm.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_lattice {
    /// voxels along x and y (1..SF_EXTENT_MAX), layers (1..SF_LAYER_MAX)
    pub nx: u32,
    /// voxels along x and y (1..SF_EXTENT_MAX), layers (1..SF_LAYER_MAX)
    pub ny: u32,
    /// voxels along x and y (1..SF_EXTENT_MAX), layers (1..SF_LAYER_MAX)
    pub nz: u32,
    /// voxel size along x, \> 0
    pub pitch_x_mm: f64,
    /// voxel size along y, \> 0
    pub pitch_y_mm: f64,
    /// layer height, \> 0; unused where heights_mm is given
    pub layer_mm: f64,
    /// NULL, or nz heights \> 0, one per layer from the bottom
    pub heights_mm: *const f64,
    /// x, y, z
    pub origin_mm: [f64; 3],
}

/// A view of triangles in somebody's arrays.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_mesh_view {
    /// x, y, z of each vertex, mm
    pub vertices: *const f64,
    /// at most UINT32_MAX
    pub vertex_count: usize,
    /// three indices of each triangle, each \< vertex_count
    pub triangles: *const u32,
    /// number of triangles
    pub triangle_count: usize,
}

/// An affine map: p -\> matrix p + shift.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_transform {
    /// row after row
    pub matrix: [f64; 9],
    /// added last
    pub shift_mm: [f64; 3],
}

/// How the triangles of a mesh hang together, after vertices of equal position are merged.
///
/// Where two solids touch along an edge, four triangles meet at it. Such an edge is nonmanifold,
/// but no hole: the mesh is closed. It joins all four: solids that touch so are one shell, and
/// solids that touch only in a point, or run through each other, are two.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_topology {
    /// distinct positions used by triangles
    pub vertex_count: usize,
    /// edges with one triangle
    pub boundary_edges: usize,
    /// edges with more than two triangles
    pub nonmanifold_edges: usize,
    /// edges with two triangles that run it the same way
    pub misoriented_edges: usize,
    /// triangles with two equal corners
    pub degenerate_triangles: usize,
    /// sets of triangles connected over edges, of any number of triangles each
    pub shells: usize,
    /// closed, consistently oriented shells with negative volume
    pub flipped_shells: usize,
    /// no boundary edges, and an even number of triangles at each
    pub closed: c_int,
    /// every edge is run as often one way as the other
    pub oriented: c_int,
    /// closed, oriented, and the signed volume is negative
    pub flipped: c_int,
}

/// Integrals over the solid that a closed mesh bounds, density 1.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_mass {
    /// negative where the mesh is inside out
    pub volume_mm3: f64,
    /// of all triangles
    pub area_mm2: f64,
    /// centre of mass; the middle of the bounds where there is no volume
    pub com_mm: [f64; 3],
    /// about the centre of mass: Ixx, Iyy, Izz, Ixy, Ixz, Iyz, the last three with the sign that
    /// they have in the tensor
    pub inertia_mm5: [f64; 6],
}

/// How a mesh becomes voxels. Fill with sf_voxelize_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_voxelize_options {
    /// sizeof(sf_voxelize_options), set by the default
    pub struct_size: usize,
    /// SF_FILL_AUTO by default
    pub fill: sf_fill,
}

/// What the voxeliser did.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_voxelize_report {
    /// the way that was taken; SF_FILL_WINDING for SF_FILL_AUTO
    pub fill: sf_fill,
    /// directed edges without an opposite, once neighbours agree; 0 where parity or surface was
    /// asked for
    pub boundary_edges: usize,
    /// 1 when the mesh was read inside out and turned as a whole
    pub flipped: c_int,
    /// rows whose crossings do not add up to nothing (leaks): parity only, because winding closes
    /// what is open
    pub odd_rows: u64,
    /// voxels that were set
    pub solid_voxels: u64,
}

/// How the surface of a grid is made. Fill with sf_surface_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_surface_options {
    /// sizeof(sf_surface_options), set by the default
    pub struct_size: usize,
    /// 0 (default): the exact voxel faces; else passes of smoothing, at most SF_SMOOTH_PASSES_MAX
    pub smooth_passes: c_int,
}

/// A mass and its first moments about the origin. What is taken away counts negative.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_body {
    /// density times volume in mm3
    pub mass: f64,
    /// the sum of mass times position, in mm
    pub moment: [f64; 3],
}

/// A mass in one point: a magnet, a screw.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_ballast {
    /// density times volume in mm3
    pub mass: f64,
    /// where it sits
    pub at_mm: [f64; 3],
}

/// Where a centre of mass may lie: all c with normal . c \>= offset_mm.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_halfspace {
    /// in the frame of the mesh
    pub normal: [f64; 3],
    /// in mm where `normal` has length 1
    pub offset_mm: f64,
}

/// A place of a solid that is posed. Cells are those of sf_weights_facts.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_handle {
    /// point, ball or base
    pub kind: sf_handle_kind,
    /// its centre: what it turns and scales about
    pub at_mm: [f64; 3],
    /// of a ball, \> 0; not looked at otherwise
    pub radius_mm: f64,
    /// of a base: its voxels, on the solid's lattice; else not looked at
    pub region: *const sf_grid,
    /// 1: whoever looks for poses leaves this handle's alone
    pub locked: c_int,
}

/// Where a ray meets a surface.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_ray_hit {
    /// how many times the direction's length from the ray's beginning
    pub along: f64,
    /// which triangle, or whatever the caster numbers
    pub triangle: u32,
    /// 1: the ray comes from inside there; 0: it enters
    pub leaves: c_int,
}

/// Somebody who finds where rays meet a closed surface, as \<sf/link/embree.h\> does.
///
/// `next` leaves the nearest hit with `along` greater than `beyond`, and 1 in `found`; or 0 in
/// `found` where there is none. What it returns is passed on where it is not SF_OK.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_ray_caster {
    /// finds the next hit
    pub next: Option<unsafe extern "C" fn(user: *mut c_void, from_mm: *const f64, direction: *const f64, beyond: f64, hit: *mut sf_ray_hit, found: *mut c_int) -> sf_status>,
    /// handed to it; may be NULL
    pub user: *mut c_void,
}

/// How handles are placed. Fill with sf_place_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_place_options {
    /// sizeof(sf_place_options), set by the default
    pub struct_size: usize,
    /// how many handles are wanted: 5; 1..SF_HANDLE_MAX
    pub count: u32,
    /// NULL, or voxels to keep away from, on the solid's lattice
    pub base: *const sf_grid,
    /// 0: points; else balls of this part of the largest that fits; 0..1
    pub ball: f64,
    /// the solid is looked at in blocks, at most this many: 32768; at least 64
    pub most_cells: u32,
}

/// What becomes of a handle: p -\> scale \* turn (p - centre) + centre + shift.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_pose {
    /// 1 leaves the size
    pub scale: f64,
    /// a rotation, row after row; not checked to be one
    pub turn: [f64; 9],
    /// added last
    pub shift_mm: [f64; 3],
}

/// A direction in which a pose changes, and what a sum changes by it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_pose_change {
    /// of the scale
    pub scale: f64,
    /// of the shift
    pub shift_mm: [f64; 3],
    /// a small turn after the pose's own, about this axis by its length
    pub spin_rad: [f64; 3],
}

/// How weights are found. Fill with sf_weights_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_weights_options {
    /// sizeof(sf_weights_options), set by the default
    pub struct_size: usize,
    /// SF_WEIGHTS_CLAMPED by default
    pub method: sf_weights_method,
    /// voxels are taken together in blocks until they are no more than this: 32768; at least 8
    pub most_cells: u32,
    /// 0 (default), or how long the edges of a block should be, rounded to whole voxels on each
    /// axis; most_cells is not looked at then
    pub cell_mm: f64,
    /// how far from what is looked for a weight may be, about: 1e-5; 1e-9..1e-2
    pub tolerance: f64,
}

/// What weights were made of.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_weights_facts {
    /// handles
    pub handle_count: usize,
    /// boxes of one block of voxels each, of which at least one is solid
    pub cell_count: usize,
    /// corners of cells, where values are kept
    pub node_count: usize,
    /// pieces of the solid that hold no handle
    pub loose_count: usize,
    /// voxels of a cell along x, y, z
    pub block: [u32; 3],
    /// edges of a cell; along z the mean, where layers differ
    pub cell_mm: [f64; 3],
    /// steps of the solver, summed over groups of handles
    pub iterations: u32,
    /// what is left, as a change of weights: see sf_weights_create()
    pub residual: f64,
}

/// Points with their weights: what a pose of all handles bends.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_blend {
    /// x, y, z of each point as it was
    pub rest_mm: *const f64,
    /// handle_count for each point, as sf_weights_sample() gives them
    pub weights: *const f64,
    /// points
    pub point_count: usize,
    /// x, y, z of each handle, as sf_weights_centers() gives them
    pub centers_mm: *const f64,
    /// 1..SF_HANDLE_MAX
    pub handle_count: usize,
}

/// How a blend stretches the solid, at the corners of all its cells.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_fold {
    /// least determinant of the blend's derivative: the factor by which volume grows there; where
    /// it is not above 0 the solid is folded over
    pub least_det: f64,
    /// where that is, before bending
    pub at_mm: [f64; 3],
    /// how many of the places looked at have none above 0
    pub folded: u64,
    /// how many were looked at: eight a cell
    pub places: u64,
}

/// What a property is.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_property {
    /// UTF-8, not empty, ended by a 0
    pub name: [c_char; 48],
    /// its identity, bytes as RFC 9562 orders them; not all 0
    pub uuid: [u8; 16],
    /// exponents of m, kg, s, A, K, mol and cd
    pub si: [i8; 7],
    /// no value lies below; minus infinity: no bound
    pub low: f64,
    /// no value lies above; infinity: no bound
    pub high: f64,
}

/// The values of one property over a mesh.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_channel {
    /// what it is
    pub property: sf_property,
    /// number of values; that of the mesh's points where indices is NULL
    pub value_count: usize,
    /// finite, within the property's bounds
    pub values: *const f64,
    /// for each corner of each cell, in the mesh's order, its value; NULL: a corner has the value
    /// of its point
    pub indices: *const u32,
}

/// An edge that is kept sharp for a while: by a whole number of steps, or part of one more.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_crease {
    /// its ends; in dimension 3 an edge of the boundary
    pub points: [u32; 2],
    /// 0: smooth; SF_SHARP and more: for ever
    pub sharpness: f64,
}

/// A point that is kept sharp: a corner of the surface.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_sharp_point {
    /// in dimension 3 one of the boundary
    pub point: u32,
    /// as a crease's
    pub sharpness: f64,
}

/// A cage in somebody's arrays.
///
/// Refined cages and what is read from files come as this, too. The open edges of a cage of
/// dimension 2 are sharp by themselves; its boundary is cut off square there.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_cage_view {
    /// 3: cells; 2: faces
    pub dimension: u32,
    /// at most SF_CAGE_POINT_MAX
    pub point_count: usize,
    /// x, y, z of each point, mm
    pub positions: *const f64,
    /// at least 1
    pub cell_count: usize,
    /// cell_count + 1: where the corners of each cell begin
    pub starts: *const u32,
    /// points
    pub corners: *const u32,
    /// edges that are sharp
    pub crease_count: usize,
    /// each edge once
    pub creases: *const sf_crease,
    /// points that are sharp
    pub sharp_count: usize,
    /// each point once
    pub sharps: *const sf_sharp_point,
    /// properties
    pub channel_count: usize,
    /// each UUID and each name once
    pub channels: *const sf_channel,
}

/// What sf_cage_check() counts.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_cage_report {
    /// in dimension 3: faces of one cell; in dimension 2: open edges
    pub boundary_faces: usize,
    /// points on them
    pub boundary_points: usize,
    /// points that no cell uses; they are left alone
    pub loose_points: usize,
    /// parts that share no point
    pub components: usize,
    /// with a corner where the three edges span no positive volume
    pub inverted_cells: usize,
    /// the first of them; the number of cells where there is none
    pub first_inverted: usize,
    /// inside, with other than 8 cells (in dimension 2: 4 faces)
    pub irregular_points: usize,
    /// inside, with other than 4 cells; dimension 3
    pub irregular_edges: usize,
    /// of the cells themselves; dimension 3
    pub volume_mm3: f64,
}

/// A place where struts meet: a cube along the axes.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_skeleton_node {
    /// its middle
    pub at_mm: [f64; 3],
    /// half of the cube's side, above 0
    pub half_side_mm: f64,
}

/// A strut between two nodes.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_skeleton_strut {
    /// which two, not the same
    pub nodes: [u32; 2],
    /// into how many cells it is cut, at least 1
    pub cells: u32,
}

/// What a history holds.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_cage_history_state {
    /// steps that can be undone
    pub undo_count: usize,
    /// steps that can be redone
    pub redo_count: usize,
    /// of both
    pub bytes: usize,
}

/// What a reader expects and takes at most. Fill with sf_cage_read_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_cage_read_options {
    /// sizeof(sf_cage_read_options), set by the default
    pub struct_size: usize,
    /// the format
    pub format: sf_cage_format,
    /// most bytes read from the source
    pub bytes_max: u64,
    /// most points; beyond SF_CAGE_POINT_MAX it is that
    pub points_max: usize,
    /// most corners of all cells; beyond SF_CAGE_POINT_MAX it is that
    pub corners_max: usize,
}

/// What reading found besides the cage.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_cage_reading {
    /// the format of the file
    pub format: sf_cage_format,
    /// cells that were inverted at every corner, and were turned
    pub turned_cells: usize,
    /// elements of a lower dimension than the cage's, which it lacks
    pub passed_over: usize,
}

/// What is asked of a stance. Fill with sf_stance_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_stance_options {
    /// sizeof(sf_stance_options), set by the default
    pub struct_size: usize,
    /// standing by default
    pub kind: sf_stance_kind,
    /// the direction away from the ground, of any length from 1e-100 to 1e100: +z
    pub up: [f64; 3],
    /// standing: the tilt of the ground, in whatever direction, that it must survive: 4 degrees; 0
    /// to 80 degrees
    pub gamma_rad: f64,
    /// hanging, rocking: how far from the pose asked for it may come to rest: 1 degree; more than
    /// 0, at most 45 degrees
    pub tolerance_rad: f64,
    /// rocking: the tilt from which it must still roll back: 20 degrees; more than tolerance_rad,
    /// at most 80 degrees
    pub range_rad: f64,
    /// vertices this close above the lowest one touch the ground; 0, the default: a millionth of
    /// the diagonal of the mesh's box
    pub contact_mm: f64,
    /// only vertices in this box can touch the ground, borders included: everywhere by default
    pub region_low_mm: [f64; 3],
    /// the box's upper corner
    pub region_high_mm: [f64; 3],
    /// hanging: where the string is tied: the origin
    pub point_mm: [f64; 3],
    /// hanging: how far below the point the centre of mass must lie; 0, the default: a hundredth of
    /// the diagonal
    pub lever_mm: f64,
}

/// How a body of a given centre of mass fares in a stance.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_stance_verdict {
    /// standing: the least tilt of the ground, over all directions, that makes it fall, negative
    /// where it falls as it is; hanging: minus the angle between the pose asked for and the one it
    /// comes to rest in; rocking: the same, the worst of those it comes to from the pose and from
    /// sixteen directions at the end of the range
    pub margin_rad: f64,
    /// how far inside of the nearest half-space's plane the centre of mass lies; negative outside
    pub slack_mm: f64,
    /// standing: the edge over which it falls first, two corners; twice the same point where the
    /// polygon is one, or where the body hangs; rocking: an edge of what it comes to rest on
    pub edge_mm: [[f64; 3]; 2],
    /// standing: margin_rad \>= 0; hanging, rocking: it comes to rest within the tolerance, hanging
    /// with the centre of mass not in the point
    pub stands: c_int,
    /// it is in all half-spaces, to a billionth of the diagonal; standing, it also lies above the
    /// ground
    pub safe: c_int,
}

/// How a body lies once it has come to rest on level ground.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_rest {
    /// the direction, in the mesh's frame, away from the ground; length 1
    pub up: [f64; 3],
    /// between the start's up and this one
    pub tilt_rad: f64,
    /// of the centre of mass above the ground
    pub height_mm: f64,
    /// the least tilt of the ground that makes it leave
    pub margin_rad: f64,
    /// corners of the convex hull that touch the ground
    pub contact_count: usize,
    /// how many edges and corners it tipped over on its way
    pub turn_count: u64,
}

/// A view of the closed polygons of one layer.
///
/// Contour i has the points starts\[i\] to starts\[i + 1\] - 1, and its last point is joined to its
/// first. Fewer than three points enclose nothing. A first point that is said again at the end does
/// no harm.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_contours {
    /// x and y of each point; may be NULL where there are none
    pub points_mm: *const f64,
    /// contour_count + 1 numbers that never fall, the first is 0; may be NULL where there is no
    /// contour
    pub starts: *const usize,
    /// how many polygons
    pub contour_count: usize,
}

/// Gaps that matter may span between two anchored ends, in voxels along x, y and both diagonals.
///
/// Let A be the voxels of a slice that are carried by what is alive below, and let A\* be the
/// opening of A along a direction by the anchor: what lies in carried runs of at least that length.
/// A gap is a maximal run, along that direction, of the slice's voxels outside A\*; it is bridged
/// when A\* bounds it on both ends and it is no longer than the span. Bridged voxels are alive, but
/// have no reach to spare, and bridge nothing themselves in their own layer.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_bridge {
    /// longest gap; 0: none along this direction
    pub span_x: u16,
    /// longest gap; 0: none along this direction
    pub span_y: u16,
    /// longest gap; 0: none along this direction
    pub span_diagonal: u16,
    /// carried voxels at each end; 0 counts as 1
    pub anchor_x: u16,
    /// carried voxels at each end; 0 counts as 1
    pub anchor_y: u16,
    /// carried voxels at each end; 0 counts as 1
    pub anchor_diagonal: u16,
}

/// A support rule for one lattice: make it with sf_rule_box3() or sf_rule_make(), and only read it.
///
/// Holds integers only: reaches are in 1/2^24 voxel. The reach of a step is how far, measured in
/// the plane, matter may lie beyond the matter that carries it. `table` belongs to the caller of
/// sf_rule_make() and must outlive every use of the rule.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_rule {
    /// which rule
    pub kind: sf_rule_kind,
    /// layers that the table serves; 0 when all layers have one height
    pub table_count: u32,
    /// one height: reach of one step along x
    pub reach_x_q24: u64,
    /// one height: reach of one step along y
    pub reach_y_q24: u64,
    /// table_count numbers for x, then as many for y; or NULL. Octagon and slack: reach from layer
    /// 0 to each layer. Disk: of each step.
    pub table: *const u64,
    /// slack: units of reach in one voxel along x
    pub slack_x: u16,
    /// slack: the same along y
    pub slack_y: u16,
    /// slack: most that a voxel has to spare, in units, at most 254
    pub slack_cap: u16,
    /// all zero: no bridges; see sf_rule_set_bridges()
    pub bridge: sf_bridge,
}

/// What a rule allows on its lattice, for people: angles from the vertical, in radians.
///
/// The first three hold in the long run, over many layers, in every layer of the lattice; the last
/// is exceeded nowhere but for rounding (octagon: less than 1.502 voxel in the plane, however long
/// the overhang).
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_rule_angles {
    /// an overhang along x is accepted up to this angle
    pub axis_x_rad: f64,
    /// the same along y
    pub axis_y_rad: f64,
    /// the same along the diagonal of a pixel
    pub diagonal_rad: f64,
    /// no overhang beyond this angle is accepted in any direction
    pub steepest_rad: f64,
}

/// The terms that an operator works on: a rule, a bed, and masks. Fill with sf_terms_default().
///
/// A mask is a grid of the same counts as the shape's, and its solid voxels are what it names; NULL
/// where there is none. Masks are only read, and must not be the grid that is changed.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_terms {
    /// sizeof(sf_terms), set by the default
    pub struct_size: usize,
    /// box3 by default; its table must outlive every use of the terms
    pub rule: sf_rule,
    /// layer that rests on the bed, or SF_BED_AUTO (default)
    pub bed_layer: u32,
    /// NULL, or what counts as carried already, with no reach to spare: overhangs that are
    /// accepted, matter that something else holds
    pub exempt: *const sf_grid,
    /// NULL, or what is never removed, where it is solid in the shape
    pub keep: *const sf_grid,
    /// NULL, or what is never added
    pub forbid: *const sf_grid,
    /// where an operator may act; NULL: everywhere
    pub act: *const sf_grid,
}

/// One place where a shape is not supported: an 8-connected region (through edges and corners) of
/// the voxels of one layer that the layer below does not carry.
///
/// Every voxel that trimming takes away is due to exactly one finding: to that of its own region
/// where nothing carries it; else to the one with the lowest index among those that the voxels
/// which carry it are due to, all of which are lost as well.
///
/// Under slack, and with bridges, a voxel can be lost because of matter that lies farther off than
/// what carries it; no finding answers for such voxels (unlinked_voxels).
///
/// An island touches nothing that is carried, and has no cause. An overhang has one when all
/// carried voxels that touch its region, corners included, are lost: the lowest index that these
/// are due to. It grows out of matter that hangs in the air already, so the cause is what to look
/// at first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_finding {
    /// island or overhang
    pub kind: sf_finding_kind,
    /// layer where it starts, counted from the lattice's layer 0
    pub layer: u32,
    /// index of an earlier finding that this one follows, or SF_FINDING_ROOT
    pub cause: u32,
    /// voxels of the region
    pub area: u64,
    /// voxels that trimming takes away because of it, the region included
    pub volume: u64,
    /// smallest box around those voxels
    pub box_: sf_box,
}

/// Counts of a check.
///
/// All counts are exact whatever fits where. The volumes of the findings and unlinked_voxels sum up
/// to trimmed_voxels. While runs_dropped is 0 a shorter array of findings holds just what a longer
/// one would hold in its first places.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_check_report {
    /// layers pushed
    pub layer_count: u32,
    /// the bed layer; SF_BED_AUTO while there was no matter
    pub bed_layer: u32,
    /// |S|
    pub solid_voxels: u64,
    /// sum over k of what of S_{k+1} is not carried by S_k as drawn
    pub unsupported_voxels: u64,
    /// |S| - |trim S|
    pub trimmed_voxels: u64,
    /// findings of kind island
    pub island_count: u64,
    /// findings of kind overhang
    pub overhang_count: u64,
    /// findings that did not fit the caller's array
    pub findings_dropped: u64,
    /// runs of lost matter that did not fit run_capacity
    pub runs_dropped: u64,
    /// trimmed voxels that no finding in the array answers for
    pub unlinked_voxels: u64,
    /// 1 when unsupported_voxels is 0
    pub support_free: c_int,
}

/// How a check runs. Fill with sf_check_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_check_options {
    /// sizeof(sf_check_options), set by the default
    pub struct_size: usize,
    /// box3 by default; its table must outlive the check
    pub rule: sf_rule,
    /// size of the slices that will be pushed; a grid brings its own
    pub width: u32,
    /// size of the slices that will be pushed; a grid brings its own
    pub height: u32,
    /// lattice layer of the first slice pushed; a grid starts at 0
    pub first_layer: u32,
    /// lattice layer that rests on the bed, or SF_BED_AUTO (default)
    pub bed_layer: u32,
    /// runs of lost matter kept of each layer, to link the next one to its findings. 0: none, each
    /// finding answers for its own region only; but in sf_grid_check() as many as it takes
    pub run_capacity: u32,
    /// the caller's array, or NULL for counts only (default)
    pub findings: *mut sf_finding,
    /// places in it
    pub finding_capacity: usize,
    /// a layer pushed as at most that many runs is not painted where all rests; 0 (default): all
    /// are
    pub layer_run_capacity: u32,
}

/// How steep the overhangs of a shape are.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_steepest {
    /// from the vertical: the least angle that it is support-free for; or, where is_bounded is 0,
    /// the largest that was tried
    pub angle_rad: f64,
    /// 0: it is not support-free for any angle that was tried, up to the largest that the lattice
    /// can be served for, at most 85 degrees: an island, or a ledge longer than the last step
    /// reaches
    pub is_bounded: c_int,
    /// the lowest layer that a slightly smaller angle does not carry, or that none does;
    /// SF_BED_AUTO when even 5 degrees carry everything
    pub layer: u32,
    /// box of the finding there; all zero when there is none
    pub box_: sf_box,
}

/// Counts of a trim.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_trim_report {
    /// solid voxels left
    pub kept_voxels: u64,
    /// solid voxels taken away
    pub removed_voxels: u64,
    /// the bed layer; SF_BED_AUTO when the grid holds no matter
    pub bed_layer: u32,
}

/// How to carve. Fill with sf_carve_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_carve_options {
    /// sizeof(sf_carve_options), set by the default
    pub struct_size: usize,
    /// SF_CARVE_SUPPORT_FREE by default
    pub mode: sf_carve_mode,
    /// SF_CARVE_ENOUGH by default; without stances not looked at
    pub goal: sf_carve_goal,
    /// what 1 mm3 of each voxel weighs, above 0, in (layer, y, x) order; NULL (default): 1. What is
    /// not solid is not looked at
    pub density: *const f32,
    /// what else the part weighs: ballast, and the mesh less its voxels
    pub rest: sf_body,
    /// where the centre of mass may lie: in all of them
    pub stances: *const *const sf_stance,
    /// 0 (default): as much is carved as is allowed
    pub stance_count: usize,
    /// support-free: struts are squares of that many voxels where there is room, 1 to SF_REACH_MAX;
    /// 2 by default
    pub strut_width_vx: u32,
    /// plane: most rounds, each with a plane of its own; 64 by default
    pub rounds_max: u32,
}

/// What carving did. Bodies hold `rest`; slacks and distances are over all stances.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_carve_report {
    /// of the solid
    pub solid_voxels: u64,
    /// of the wall
    pub wall_voxels: u64,
    /// carved out
    pub removed_voxels: u64,
    /// neither wall nor carved: what is left inside
    pub kept_voxels: u64,
    /// their volume
    pub removed_mm3: f64,
    /// body of the solid
    pub before: sf_body,
    /// body of the result
    pub after: sf_body,
    /// least over all half-spaces of how far inside it the centre of mass lies; negative: outside.
    /// 0 without stances
    pub slack_before_mm: f64,
    /// the same of the result
    pub slack_mm: f64,
    /// root of the sum, over stances, of the squared distance from the centre of mass to the safe
    /// region, across the stance's up
    pub distance_before_mm: f64,
    /// the same of the result
    pub distance_mm: f64,
    /// plane: rounds that took something away
    pub rounds: u32,
    /// pieces of the result, connected by faces, edges and corners, that hold no voxel of the wall;
    /// 0 where there is no wall
    pub floating_pieces: u64,
    /// and their voxels
    pub floating_voxels: u64,
    /// 1 when every half-space holds, as it does without stances
    pub safe: c_int,
}

/// One hole: a shaft from a void down to the open.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_drain {
    /// middle of its upper end, in the void
    pub from_mm: [f64; 3],
    /// middle of its lower end; straight below where it could be
    pub to_mm: [f64; 3],
    /// solid voxels that were drilled out
    pub voxels: u64,
    /// what they weighed
    pub body: sf_body,
    /// of the void that it was drilled for
    pub void_voxels: u64,
}

/// How holes are drilled. Fill with sf_drain_options_default(), and set the diameter.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_drain_options {
    /// sizeof(sf_drain_options), set by the default
    pub struct_size: usize,
    /// a round rod of that diameter passes; above 0
    pub diameter_mm: f64,
    /// holes for each void, far from each other; 1 by default
    pub count: u32,
    /// voids of fewer voxels get none; 0 by default
    pub void_min: u64,
    /// 1: a void that no hole fits into, or of fewer voxels than void_min, is filled where that
    /// leaves all of it supported and the terms let matter be added; 0 (default): it stays as it is
    pub fill: c_int,
    /// of each voxel, as in sf_carve_options; NULL (default): 1
    pub density: *const f32,
    /// what the whole part weighs; looked at where there are stances
    pub body: sf_body,
    /// whose balance is to change least
    pub stances: *const *const sf_stance,
    /// 0 (default): holes are as short as can be
    pub stance_count: usize,
    /// the caller's array, or NULL for counts only (default)
    pub drains: *mut sf_drain,
    /// places in it
    pub drain_capacity: usize,
}

/// What became of the voids.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_drain_report {
    /// voids that were closed
    pub void_count: u64,
    /// and their voxels
    pub void_voxels: u64,
    /// of these, voids that are open now
    pub drained_count: u64,
    /// voids that were filled
    pub filled_count: u64,
    /// and their voxels
    pub filled_voxels: u64,
    /// voids that are closed still: no hole fits and they are not filled, or none may be drilled.
    /// sf_grid_voids() with an open bed names them
    pub closed_count: u64,
    /// and their voxels
    pub closed_voxels: u64,
    /// holes
    pub drain_count: u64,
    /// holes without a place in the array
    pub drains_dropped: u64,
    /// voxels of all holes
    pub removed_voxels: u64,
    /// what they weighed
    pub removed: sf_body,
}

/// What is to be certified of a shape. Fill with sf_claim_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_claim {
    /// sizeof(sf_claim), set by the default
    pub struct_size: usize,
    /// rule, bed and exempt voxels; the other masks are not looked at
    pub terms: *const sf_terms,
    /// angle that the rule was made for; not looked at for box3
    pub angle_rad: f64,
    /// what sf_rule_set_bridges() was given; 0: no bridges
    pub bridge_span_mm: f64,
    /// the same; not looked at where there are no bridges
    pub bridge_anchor_mm: f64,
    /// what made the shape; SF_OPERATION_CHECK by default
    pub operation: sf_operation,
    /// what it was made from; NULL (default): the shape itself
    pub before: *const sf_grid,
}

/// The counts of one layer.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_certificate_layer {
    /// solid voxels
    pub solid: u64,
    /// those of them that are exempt
    pub exempt: u64,
    /// those that nothing below carries, and bridges hold
    pub bridged: u64,
}

/// The integers of one step, from layer k to layer k + 1.
///
/// Box3 and octagon: voxel (dx, dy) off carries where |dx| and |dy| are at most `first` and |dx| +
/// |dy| is at most `second`. Disk and slack: the reach of the step along x and along y in 1/2^24
/// voxel; slack: and the units that the step gives.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_certificate_step {
    /// see above
    pub first: u64,
    /// see above
    pub second: u64,
    /// slack: units that the step gives; else 0
    pub gain: u32,
}

/// One gap that a bridge spans: `length` voxels from (x, y) along a direction.
///
/// Directions: 0 is (1, 0), 1 is (0, 1), 2 is (1, 1), 3 is (-1, 1). Listed are the gaps, as
/// sf_bridge defines them, that hold a voxel which nothing else carries; layer by layer, direction
/// by direction, and by their first such voxel, row by row.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_certificate_span {
    /// layer of the lattice
    pub layer: u32,
    /// 0 to 3
    pub direction: u32,
    /// first voxel of the gap: its row
    pub y: u32,
    /// and its place in it
    pub x: u32,
    /// voxels of the gap
    pub length: u32,
}

/// All that a certificate says. Arrays belong to the certificate.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_certificate_view {
    /// what made the shape
    pub operation: sf_operation,
    /// where it lies; layer 0 is where the rule's schedule begins
    pub lattice: sf_lattice,
    /// the rule
    pub kind: sf_rule_kind,
    /// its angle; 0 for box3
    pub angle_rad: f64,
    /// the tangent that its integers come from; or 0
    pub tangent: f64,
    /// its bridges in mm; 0: none
    pub bridge_span_mm: f64,
    /// carried matter at both ends of one, in mm
    pub bridge_anchor_mm: f64,
    /// the same in voxels
    pub bridge: sf_bridge,
    /// slack: units in a voxel along x; else 0
    pub slack_x: u16,
    /// the same along y
    pub slack_y: u16,
    /// most units that a voxel has to spare
    pub slack_cap: u16,
    /// the bed as it was given, or SF_BED_AUTO
    pub bed_layer: u32,
    /// layer that rests on the bed; nz: no matter
    pub bed: u32,
    /// fingerprint of what the operation began with
    pub input_sha256: [u8; 32],
    /// fingerprint of the shape
    pub output_sha256: [u8; 32],
    /// solid voxels of the input
    pub input_voxels: u64,
    /// solid voxels of the shape
    pub output_voxels: u64,
    /// in the shape, not in the input
    pub added_voxels: u64,
    /// in the input, not in the shape
    pub removed_voxels: u64,
    /// nz of them
    pub layers: *const sf_certificate_layer,
    /// integers of each step
    pub steps: *const sf_certificate_step,
    /// nz - 1
    pub step_count: usize,
    /// maximal runs of solid exempt voxels, from the lowest layer up, row by row; label: the layer
    pub exempt: *const sf_run,
    /// runs
    pub exempt_count: usize,
    /// gaps that bridges span
    pub spans: *const sf_certificate_span,
    /// gaps
    pub span_count: usize,
}

/// A support rule as a table of bytes: the elements that its steps have, and which step has which.
///
/// Element i begins at elements\[i \* (reach + 2)\]: first its reach_y, at most `reach`, then its
/// half widths, reach_y + 1 of them, which never grow. The bytes belong to whoever made them.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_chip_rule {
    /// element_count elements of reach + 2 bytes each
    pub elements: *const u8,
    /// element of the step from layer first_layer + i to the next, for i below step_count; NULL:
    /// all steps have element 0
    pub steps: *const u8,
    /// steps that `steps` has; 0 where it is NULL
    pub step_count: u32,
    /// lattice layer below the first of these steps
    pub first_layer: u32,
    /// elements, at least one
    pub element_count: u8,
    /// largest reach_y of an element
    pub reach: u8,
}

/// Voxels x0 \<= x \< x1 of one row that the layer below does not carry.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_chip_finding {
    /// lattice layer
    pub layer: u32,
    /// row
    pub y: u32,
    /// half-open, as long as it can be
    pub x0: u32,
    /// half-open, as long as it can be
    pub x1: u32,
}

/// Counts of a check. All are exact, and the same for both forms and on every machine.
///
/// The hashes tell two jobs apart by accident, not by intent: they are no seal. layers_hash is over
/// every maximal run of every layer in order, unsupported_hash over every maximal run that is not
/// carried; both are 0 before the first layer.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_chip_counts {
    /// layers checked
    pub layer_count: u32,
    /// the bed layer; SF_BED_AUTO while there was no matter
    pub bed_layer: u32,
    /// layers with a voxel that is not carried
    pub unsupported_layers: u32,
    /// findings in the caller's array: the first ones
    pub finding_count: u32,
    /// |S|
    pub solid_voxels: u64,
    /// sum over k of what of S_{k+1} is not carried by S_k as drawn, as sf_check_report has it
    pub unsupported_voxels: u64,
    /// in how many runs of rows these lie
    pub unsupported_runs: u64,
    /// of what was read
    pub layers_hash: u64,
    /// of what is not carried
    pub unsupported_hash: u64,
    /// 1 when unsupported_voxels is 0
    pub support_free: c_int,
}

/// How a chip checks. Fill with sf_chip_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_chip_options {
    /// sizeof(sf_chip_options), set by the default
    pub struct_size: usize,
    /// box3 by default; its bytes must outlive the checker
    pub rule: sf_chip_rule,
    /// size of the layers, in voxels; must be set
    pub width: u32,
    /// size of the layers, in voxels; must be set
    pub height: u32,
    /// lattice layer of the first one
    pub first_layer: u32,
    /// lattice layer that rests on the bed, or SF_BED_AUTO (default)
    pub bed_layer: u32,
    /// 0: dense (default); else run-length, with so many runs a layer
    pub run_capacity: u32,
    /// the caller's array, or NULL for counts only (default). Places past finding_count may be
    /// written too
    pub findings: *mut sf_chip_finding,
    /// places in it
    pub finding_capacity: u32,
    /// any number that tells jobs apart: a saved state of another one is refused
    pub job: u32,
}

/// Memory that lasts when the power goes: two slots, one from 0, the other from slot_size on.
///
/// `write` is called with offsets that rise within a slot, but for the last call, which writes its
/// first bytes; it may erase a slot at the first call of a save. Both return SF_OK or a status,
/// which is passed on.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_chip_store {
    /// gives back bytes; any, where none were written
    pub read: Option<unsafe extern "C" fn(user: *mut c_void, offset: u32, data: *mut c_void, size: usize) -> sf_status>,
    /// keeps bytes
    pub write: Option<unsafe extern "C" fn(user: *mut c_void, offset: u32, data: *const c_void, size: usize) -> sf_status>,
    /// handed to both; may be NULL
    pub user: *mut c_void,
    /// bytes of one slot, at least sf_chip_slot_size()
    pub slot_size: u32,
}

/// Bounds on what a reader takes. Fill with sf_read_limits_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_read_limits {
    /// sizeof(sf_read_limits), set by the default
    pub struct_size: usize,
    /// most bytes read from the source (default 8 GiB)
    pub bytes_max: u64,
    /// most triangles (default 1e9)
    pub triangles_max: usize,
    /// most vertices, corners of STL facets one by one (default UINT32_MAX)
    pub vertices_max: usize,
}

/// A folder as a stack sees it: named files, each read or written whole, one at a time.
///
/// A folder that is only written may leave `open` and `close` NULL, one that is only read the
/// others. sf_directory_folder() makes one of a folder of the disk.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_folder {
    /// Open file `name` for reading. SF_ERR_IO when it is not there.
    pub open: Option<unsafe extern "C" fn(user: *mut c_void, name: *const c_char, source: *mut sf_source) -> sf_status>,
    /// Done with a source from `open`.
    pub close: Option<unsafe extern "C" fn(user: *mut c_void, source: sf_source)>,
    /// Begin file `name`; nothing shows under that name until `commit`.
    pub begin: Option<unsafe extern "C" fn(user: *mut c_void, name: *const c_char, sink: *mut sf_sink) -> sf_status>,
    /// Finish the file begun last: publish it (keep != 0) or drop it.
    pub commit: Option<unsafe extern "C" fn(user: *mut c_void, keep: c_int) -> sf_status>,
    /// handed to all four; may be NULL
    pub user: *mut c_void,
}

/// The rule that a stack was made under, as stack.json carries it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_stack_info {
    /// 0: the stack says nothing of a rule, and the rest is 0
    pub has_rule: c_int,
    /// which rule
    pub rule: sf_rule_kind,
    /// its overhang angle, SF_RULE_ANGLE_MIN_RAD to _MAX_RAD; box3: 0
    pub angle_rad: f64,
    /// layer that rests on the bed, or SF_BED_AUTO; the rule's phase counts from layer 0
    pub bed_layer: u32,
    /// bridges of the rule, 0: none; see sf_rule_set_bridges()
    pub bridge_span_mm: f64,
    /// carried matter that each end of one must have
    pub bridge_anchor_mm: f64,
}

/// A region of one density. Only what its shape names is looked at.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_density_region {
    /// how it is said: box, mesh or mask
    pub shape: sf_density_shape,
    /// what 1 mm3 weighs, above 0; infill does not thin it
    pub density: f64,
    /// corners of a box
    pub low_mm: [f64; 3],
    /// corners of a box
    pub high_mm: [f64; 3],
    /// as sf_grid_voxelize() takes it
    pub mesh: sf_mesh_view,
    /// of the grid's counts
    pub mask: *const sf_grid,
}

/// Where densities come from. Fill with sf_density_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_density_options {
    /// sizeof(sf_density_options), set by the default
    pub struct_size: usize,
    /// of everything that no region says otherwise of, above 0: 1
    pub density: f64,
    /// share of that in what is not wall, above 0 and at most 1: 1
    pub infill: f64,
    /// what is dense; NULL (default): all
    pub wall: *const sf_grid,
    /// of regions that overlap the last one counts
    pub regions: *const sf_density_region,
    /// 0 by default
    pub region_count: usize,
}

/// How to refine. Make one with sf_refine_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_refine_options {
    /// sizeof(sf_refine_options), set by sf_refine_options_default()
    pub struct_size: usize,
    /// 1 to SF_REFINE_STEP_MAX; 1
    pub steps: u32,
    /// SF_REFINE_STANDARD
    pub rules: sf_refine_rules,
}

/// Tetrahedra in somebody's arrays.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_tets_view {
    /// at most 2^31 - 1
    pub point_count: usize,
    /// x, y, z of each point, mm
    pub positions: *const f64,
    /// at most 2^29 - 1
    pub tet_count: usize,
    /// four points each; the second, third and fourth are counter-clockwise seen from the first's
    /// other side, so that (b - a) x (c - a) . (d - a) is above 0
    pub corners: *const u32,
    /// properties
    pub channel_count: usize,
    /// their indices are of tetrahedra's corners, in this order
    pub channels: *const sf_channel,
}

/// What sf_tets_spread() did.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_spread_report {
    /// points that kept their values
    pub fixed: usize,
    /// of the solver
    pub iterations: u32,
    /// what is left of the largest force on a free point, as a part of the largest at the start
    pub residual: f64,
}

/// What sf_tets_check() finds.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_tets_report {
    /// of all, those of inverted ones subtracted
    pub volume_mm3: f64,
    /// tetrahedra whose volume is not above 0
    pub inverted: usize,
    /// the first of them; the number of tetrahedra where there is none
    pub first_inverted: usize,
    /// faces of one tetrahedron
    pub boundary_faces: usize,
    /// faces of more than two, or of two on the same side
    pub crowded_faces: usize,
}

/// What fixing a finding takes, in voxels.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_finding_cost {
    /// taken away by a trim: the volume of the finding
    pub trim_voxels: u64,
    /// added below the finding's region so that all of it is carried
    pub grow_voxels: u64,
}

/// A void that has no way out but, if any, upwards.
///
/// Voids are connected through faces (6 neighbours): what flows passes no edge and no corner, and
/// so the walls that hold it may be connected by edges and corners (26 neighbours).
///
/// Let E_k be the empty voxels of the layers from the bed to k. A component of E_k is sealed when
/// it touches neither a side of the grid nor, where that is open, the bed: its only way out is the
/// plane of layer k, which in a resin printer lies at the film, so that pulling the part off works
/// against a vacuum. The voids are the largest of these sets, over all k: those that lie in no
/// other one. A void is a trap where all above its last layer is solid, so that it stays shut, and
/// a cup where the next layer joins it to the outside, or where there is none.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_void {
    /// trap or cup
    pub kind: sf_void_kind,
    /// layer that joins it to the outside; the number of layers where only the end of the print
    /// does; UINT32_MAX for a trap
    pub vent_layer: u32,
    /// voxels
    pub volume: u64,
    /// most voxels of one layer that were sealed in one: what the film pulls at
    pub area: u64,
    /// smallest box around it; where z0 is the bed layer, it also opens once the part is off the
    /// bed
    pub box_: sf_box,
}

/// Counts of voids; exact whatever fits where.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_voids_report {
    /// of all traps
    pub trap_count: u64,
    /// of all traps
    pub trap_voxels: u64,
    /// of those that are not small
    pub cup_count: u64,
    /// of those that are not small
    pub cup_voxels: u64,
    /// cups below cup_area_min or cup_layers_min
    pub small_cup_count: u64,
    /// traps, and cups that are not small, without a place
    pub voids_dropped: u64,
    /// the bed layer; SF_BED_AUTO when there is no matter
    pub bed_layer: u32,
}

/// How voids are looked for. Fill with sf_voids_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_voids_options {
    /// sizeof(sf_voids_options), set by the default
    pub struct_size: usize,
    /// layer that rests on the bed, or SF_BED_AUTO (default); what lies below is not looked at
    pub bed_layer: u32,
    /// 0 (default): the bed closes what is open towards it; 1: it does not, as in a box of powder,
    /// or once the part is off the bed
    pub bed_is_open: c_int,
    /// cups of a smaller area are small; 0 by default
    pub cup_area_min: u64,
    /// cups of fewer layers are small; 0 by default
    pub cup_layers_min: u32,
    /// the caller's array, or NULL for counts only (default)
    pub voids: *mut sf_void,
    /// places in it
    pub void_capacity: usize,
}

/// How glTF is read. Fill with sf_gltf_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_gltf_options {
    /// sizeof(sf_gltf_options), set by the default
    pub struct_size: usize,
    /// most bytes, those of the folder's files included; most triangles and vertices
    pub limits: sf_read_limits,
    /// where buffers outside of the file are, read with `open` and `close`; NULL: there are none
    pub folder: *const sf_folder,
}

/// What was read of a glTF file, and what was passed over.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_gltf_report {
    /// nodes of the scene
    pub nodes: usize,
    /// sets of triangles that were placed
    pub pieces: usize,
    /// sets of points and lines: passed over
    pub passed: usize,
    /// nodes with a skin, whose meshes are taken as modelled, not as posed
    pub skinned: usize,
    /// sets of triangles with other shapes to blend to, which are not blended
    pub morphed: usize,
    /// animations of the file, none of which is played
    pub animations: usize,
}

/// A voxel of a grid.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_voxel {
    /// column, row, layer
    pub x: u32,
    /// column, row, layer
    pub y: u32,
    /// column, row, layer
    pub z: u32,
}

/// What is known of a path beside its voxels.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_path {
    /// voxels of the path: neither the one asked about nor matter below
    pub count: usize,
    /// what it ends on
    pub end: sf_path_end,
    /// the matter below its last voxel; else its last voxel itself, which is the one asked about
    /// where the path is empty
    pub landing: sf_voxel,
    /// as told above
    pub cost: u64,
    /// on the bed: squared distance of its last voxel to the closest matter of the bed slice, in
    /// voxels; 0 else, and where that slice is empty
    pub bed_square: u64,
}

/// How a path map is made. Fill with sf_path_map_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_path_map_options {
    /// sizeof(sf_path_map_options), set by the default
    pub struct_size: usize,
    /// any matter by default
    pub landing: sf_landing,
    /// SF_PATH_COST_COUNT by default
    pub cost: sf_path_cost,
}

/// A brush, and where it goes.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_stroke {
    /// a shape of any size, smaller than the grid or not
    pub brush: *const sf_grid,
    /// its voxel that comes to lie on each voxel of the path
    pub anchor: sf_voxel,
    /// voxels, one for each layer, from the top, as a finder gives them
    pub path: *const sf_voxel,
    /// number of voxels; 0 adds nothing
    pub count: usize,
}

/// Counts of sf_grid_emit().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_emit_report {
    /// voxels that became solid
    pub added_voxels: u64,
    /// voxels of the brush that were left out because nothing carries them; those outside the grid
    /// or the masks do not count
    pub trimmed_voxels: u64,
}

/// Counts of sf_grid_grow().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_grow_report {
    /// solid voxels before, all of which are left
    pub kept_voxels: u64,
    /// voxels that became solid
    pub added_voxels: u64,
    /// the bed layer; SF_BED_AUTO when the grid holds no matter
    pub bed_layer: u32,
}

/// How a mask is made. Fill with sf_mask_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_mask_options {
    /// sizeof(sf_mask_options), set by the default
    pub struct_size: usize,
    /// SF_MASK_SLICE by default
    pub kind: sf_mask_kind,
    /// period in voxels, 32 each: nx a power of two in 4..256, the others in 1..256, their product
    /// at most SF_MASK_SIZE_MAX
    pub nx: u32,
    /// period in voxels, 32 each: nx a power of two in 4..256, the others in 1..256, their product
    /// at most SF_MASK_SIZE_MAX
    pub ny: u32,
    /// period in voxels, 32 each: nx a power of two in 4..256, the others in 1..256, their product
    /// at most SF_MASK_SIZE_MAX
    pub nz: u32,
    /// of a voxel; 1 each; no two differ by a factor above 64
    pub pitch_mm: [f64; 3],
    /// standard deviation of the Gaussian that keeps voxels apart, in mean pitches (geometric: of x
    /// and y, or of all three); 0.5..4, 1.5
    pub spread: f64,
    /// another seed, another mask: 0
    pub seed: u64,
}

/// Tones of one material over a rectangle.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_tone_plane {
    /// first tone of row 0, in the type's own alignment
    pub values: *const c_void,
    /// tones from one row to the next, at least the width
    pub stride: usize,
}

/// Where a material must not be.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_keep_out {
    /// of the rectangle's size: solid where it must not be
    pub where_: sf_slice,
    /// which
    pub material: u32,
    /// which material takes its place there; another one
    pub instead: u32,
}

/// A rectangle of one slice, to be halftoned. Zero what is not needed.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_tones {
    /// sizeof(sf_tones)
    pub struct_size: usize,
    /// voxels, 1..SF_EXTENT_MAX each
    pub width: u32,
    /// voxels, 1..SF_EXTENT_MAX each
    pub height: u32,
    /// where its first voxel lies: which part of the mask applies
    pub x0: u32,
    /// where its first voxel lies: which part of the mask applies
    pub y0: u32,
    /// where its first voxel lies: which part of the mask applies
    pub layer: u32,
    /// of all planes
    pub type_: sf_tone_type,
    /// one for each material but the last, which gets what is left
    pub planes: *const sf_tone_plane,
    /// words NULL: all; else what is empty there gets no material, and its tones are not looked at
    pub solid: sf_slice,
    /// applied in their order; may be NULL where there are none
    pub keep_outs: *const sf_keep_out,
    /// how many
    pub keep_out_count: usize,
}

/// Where materials go. Each pointer may be NULL. Nothing here may overlap what is read.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_materials {
    /// NULL, or one for each material, of the rectangle's size; their words may be NULL
    pub slices: *const sf_slice,
    /// NULL, or a byte a voxel: 0, or material + 1
    pub ids: *mut u8,
    /// bytes from one row to the next, at least the width
    pub ids_stride: usize,
    /// NULL, or receives voxels of each material in the rectangle
    pub counts: *mut u64,
}

/// What became of the tones of one material so far, in voxels: asked = placed + dropped + carried,
/// each to 2^-24 of a voxel.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_diffusion {
    /// sum of the tones of solid voxels
    pub asked: f64,
    /// voxels of the material, before keep-outs
    pub placed: f64,
    /// lost where the next voxel up is empty
    pub dropped: f64,
    /// waiting for the next slice
    pub carried: f64,
}

/// How much of a material a part takes.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_material_use {
    /// how many
    pub voxels: u64,
    /// of these
    pub volume_mm3: f64,
    /// by its density; 0 without one
    pub mass_g: f64,
}

/// Bytes that can be read at any place: a file that stays as it is while it is used.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_bytes {
    /// Store the `size` bytes from `offset` on; all of them, or a status, which is passed on. Never
    /// asked for what lies beyond the size below.
    pub read_at: Option<unsafe extern "C" fn(user: *mut c_void, offset: u64, data: *mut c_void, size: usize) -> sf_status>,
    /// how many there are
    pub size: u64,
    /// handed to it; may be NULL
    pub user: *mut c_void,
}

/// How a job is understood. Fill with sf_job_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_job_options {
    /// sizeof(sf_job_options), set by the default
    pub struct_size: usize,
    /// least grey that is solid, 1..255; 128 by default
    pub threshold: u32,
    /// size of a pixel along x and y; 0 (default): as the job says
    pub pitch_mm: [f64; 2],
    /// most bytes of the file (default 64 GiB)
    pub bytes_max: u64,
    /// most layers (default 1e6)
    pub layers_max: u32,
}

/// What a job says of itself.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_job_info {
    /// which format it is in
    pub format: sf_job_format,
    /// whether pictures have more than black and white
    pub has_greys: c_int,
    /// whether the job says how large a pixel is; 0: the caller did, or the format's first printer
    /// was taken
    pub has_pitch: c_int,
}

/// What a new SL1 job says beside its layers. Fill with sf_sl1_settings_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_sl1_settings {
    /// sizeof(sf_sl1_settings), set by the default
    pub struct_size: usize,
    /// of the job: letters, digits, - and _; "job" by default
    pub name: *const c_char,
    /// of a layer, 0 \< it \<= 1e6; 8 by default
    pub exposure_s: f64,
    /// of the first ones; 35 by default
    pub first_exposure_s: f64,
    /// layers from the one to the other; 10 by default
    pub fade_layers: u32,
}

/// What a material is called, looks like and weighs.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_material {
    /// UTF-8, not empty, no control characters, ended by a 0
    pub name: [c_char; 48],
    /// red, green and blue in its pictures
    pub colour: [u8; 3],
    /// above 0; 0: not known, and then no grams are said
    pub density_g_cm3: f64,
}

/// A place of the shape.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_place {
    /// piece j of a cell: the cell's first corner's place in `corners`, plus j
    pub piece: u32,
    /// 0 to 1 along the piece's axes; in dimension 2 the third is not looked at
    pub u: [f64; 3],
}

/// What sf_limit_check() finds.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_limit_report {
    /// pieces that are proved to lie the right way out everywhere
    pub positive: usize,
    /// pieces of which a part lies inside out
    pub inverted: usize,
    /// the first of these; the number of pieces where there is none
    pub first_inverted: usize,
    /// the others: next to what is irregular nothing can be proved, and where a piece is hardly
    /// bent the right way the proof may be too coarse
    pub open: usize,
}

/// A measurement.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_curve_sample {
    /// what was set: a fraction
    pub x: f64,
    /// what was found: a property, in any unit
    pub y: f64,
    /// how much it counts where measurements disagree, above 0; 1
    pub weight: f64,
}

/// What was measured.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_mixture_samples {
    /// 2..SF_MIXTURE_MATERIAL_MAX
    pub material_count: usize,
    /// 1..SF_MIXTURE_PROPERTY_MAX
    pub property_count: usize,
    /// measured mixtures, at most SF_MIXTURE_MAX
    pub count: usize,
    /// material_count of each: at least 0, of sum 1 within 1e-6
    pub fractions: *const f64,
    /// property_count of each, finite, below 1e100 in size
    pub properties: *const f64,
    /// what of each property counts as one unit of error, above 0; NULL: the span that was measured
    pub scales: *const f64,
}

/// How orientations are looked for. Fill with sf_orient_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_orient_options {
    /// sizeof(sf_orient_options), set by the default
    pub struct_size: usize,
    /// what may rest on what; octagon by default
    pub rule: sf_rule_kind,
    /// overhang from the vertical that still prints; 45 degrees
    pub angle_rad: f64,
    /// what is inside; SF_FILL_AUTO by default
    pub fill: sf_fill,
    /// directions spread over the sphere, beside the six axes and the large flat faces: 1000; at
    /// most 100000
    pub direction_count: u32,
    /// how many of these become voxels at the coarse resolution, beside the axes and the flat
    /// faces, 38 at most: 50; 1..10000
    pub coarse_count: u32,
    /// how many at the fine one, which are the result: 5; 1..1000
    pub fine_count: u32,
    /// voxels on the longest side of the mesh as it is given: 64
    pub coarse_resolution: u32,
    /// the same, for the result: 256; both 1..16384
    pub resolution: u32,
    /// what height counts in the score: 0.02; 0..1000
    pub weight_height: f64,
    /// what leaning counts in the score: 0.02; 0..1000
    pub weight_margin: f64,
}

/// A way to put a part on the bed, and what came of it at the fine resolution.
///
/// The score is trimmed_voxels / solid_voxels (1 where nothing is solid) + weight_height \*
/// height_mm / (diagonal of the mesh's box, as it is given) + weight_margin \* (1 - margin_rad / 90
/// degrees). Less is better.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_orientation {
    /// the mesh's direction that points up, length 1
    pub up: [f64; 3],
    /// turns `up` to +z and puts the lowest vertex on z = 0
    pub turn: sf_transform,
    /// area of the faces that look down more steeply than the angle allows, as seen from below;
    /// faces on the bed are none
    pub unsupported_mm2: f64,
    /// of the part
    pub solid_voxels: u64,
    /// of these, what a trim takes away
    pub trimmed_voxels: u64,
    /// the same in mm3
    pub trimmed_mm3: f64,
    /// from the lowest vertex to the highest
    pub height_mm: f64,
    /// the least angle by which the part must be tipped to fall over an edge of what touches the
    /// bed; negative where it falls as it is
    pub margin_rad: f64,
    /// what is ranked by
    pub score: f64,
}

/// A brush: a ball, or what a ball sweeps that is drawn along a line. Make one with
/// sf_paint_brush_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_paint_brush {
    /// sizeof(sf_paint_brush), set by sf_paint_brush_default()
    pub struct_size: usize,
    /// where the middle begins, within 10^12; 0, 0, 0
    pub from_mm: [f64; 3],
    /// where it ends, within 10^12; 0, 0, 0
    pub to_mm: [f64; 3],
    /// above 0, and may be infinite: all points; 1
    pub radius_mm: f64,
    /// weight in the middle, above 0 and at most 1; 1
    pub strength: f64,
    /// SF_FALLOFF_SMOOTH
    pub falloff: sf_falloff,
    /// SF_PAINT_ALL
    pub where_: sf_paint_where,
}

/// How to preserve. Fill with sf_preserve_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_preserve_options {
    /// sizeof(sf_preserve_options), set by the default
    pub struct_size: usize,
    /// SF_PRESERVE_FAST by default
    pub mode: sf_preserve_mode,
    /// voxels that must not stay, or NULL
    pub must_go: *const sf_grid,
    /// only the brush's voxels in here count; all zero: all. Saves looking for them
    pub brush_box: sf_box,
    /// of SF_PRESERVE_CORE, in voxels: odd, 1 to 255; 3 by default
    pub strut_width: u32,
    /// 1: what the terms do not carry before the edit counts as exempt. 0 (default): such a shape
    /// is refused
    pub accept_unsupported: c_int,
    /// 1: the caller knows that the shape is support-free, as after a trim, so that fast need not
    /// look at all of it. Where it is not, what nothing carried stays as it was, and no more is
    /// left so
    pub known_support_free: c_int,
    /// 1: the paper's modes end with a trim; by default they do not. A trim minds no masks: it
    /// takes what hangs wherever it is
    pub trim_after: c_int,
}

/// What became of a brush.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_preserve_report {
    /// solid voxels of the brush that are gone
    pub removed_voxels: u64,
    /// solid voxels of the brush that are still there
    pub kept_voxels: u64,
    /// solid voxels outside the brush that are gone: 0 but for a paper's mode with a trim after it
    pub lost_outside: u64,
    /// voxels that were not solid and are: 0 but for the paper's text
    pub added_voxels: u64,
}

/// How sf_grid_printing() looks. Fill with sf_printing_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_printing_options {
    /// sizeof(sf_printing_options), set by the default
    pub struct_size: usize,
    /// the layer on the bed, or SF_BED_AUTO, the default: the first that holds matter. What lies
    /// below it is left out
    pub bed_layer: u32,
    /// SF_CONNECT_CORNERS, the default: voxels that touch in as much as a corner are one piece, so
    /// that what is support-free under the rule box3 never floats; SF_CONNECT_EDGES: only those
    /// that share a face
    pub connectivity: sf_connectivity,
    /// NULL, or receives a margin for each layer
    pub margins_rad: *mut f64,
    /// places in it: at least the grid's nz, where it is not NULL
    pub margin_capacity: usize,
}

/// How a print stands, from the first layer to the last.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_printing_report {
    /// the layer on the bed; SF_BED_AUTO where nothing is solid
    pub bed_layer: u32,
    /// the least tilt, over all layers and pieces on the bed, that makes a piece fall; negative
    /// where one falls as it is; 90 degrees where nothing stands on the bed
    pub margin_rad: f64,
    /// after which layer: the lowest, where several are as bad; SF_BED_AUTO where nothing stands on
    /// the bed; what follows is then all zero
    pub layer: u32,
    /// the box around the piece, as it was then
    pub piece: sf_box,
    /// how many voxels it had
    pub piece_voxels: u64,
    /// its centre of mass, in the lattice's frame
    pub com_mm: [f64; 3],
    /// the edge of its contact with the bed over which it falls
    pub edge_mm: [[f64; 3]; 2],
    /// after how many layers some piece falls as it is
    pub toppling_layers: u32,
    /// how many pieces begin in the air, connected with nothing
    pub floating_count: u64,
    /// the lowest layer that one begins in, or SF_BED_AUTO
    pub floating_layer: u32,
    /// the largest number of pieces on the bed after any layer
    pub standing_count: u32,
}

/// How a repair is made. Fill with sf_repair_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_repair_options {
    /// sizeof(sf_repair_options), set by the default
    pub struct_size: usize,
    /// rule, bed and masks: `keep` is never removed, `forbid` never added, and nothing is changed
    /// outside `act`
    pub terms: sf_terms,
    /// of adding each voxel, 1..255, nz \* ny \* nx of them in (layer, y, x) order; NULL (default):
    /// 1 each
    pub add_cost: *const u8,
    /// the same of removing it; NULL (default): 1 each
    pub remove_cost: *const u8,
    /// added matter is made of squares of at least this many voxels each way, where there is room
    /// for them; 1 (default) asks nothing; at most SF_REACH_MAX
    pub min_feature_vx: u32,
    /// most rounds of improvement from each start that is tried; 0 (default): until one fails to
    /// improve; SF_REPAIR_FIRST: none
    pub rounds: u32,
}

/// What a repair did and what it cost.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_repair_report {
    /// voxels added
    pub added_voxels: u64,
    /// voxels removed
    pub removed_voxels: u64,
    /// what that costs; 1 a voxel where no costs were given
    pub cost: u64,
    /// cost of the first result, before any improvement
    pub first_cost: u64,
    /// cost of a trim; SF_REPAIR_NO_COST where it would remove what must stay
    pub trim_cost: u64,
    /// cost of keeping all that can be kept, along the first forest; SF_REPAIR_NO_COST where that
    /// forest does not carry it all
    pub grow_cost: u64,
    /// voxels that must stay and cannot: 0 unless it is infeasible
    pub culprit_count: u64,
    /// most bytes of working memory at one time
    pub peak_memory: u64,
    /// rounds of improvement that were made, over all starts
    pub rounds: u32,
    /// the bed layer; SF_BED_AUTO when the grid holds no matter
    pub bed_layer: u32,
}

/// How to sample. Make one with sf_sample_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_sample_options {
    /// sizeof(sf_sample_options), set by sf_sample_options_default()
    pub struct_size: usize,
    /// how far the surface may be from the limit, as a share of the smallest pitch, above 0 and at
    /// most 1; 0.05
    pub tolerance: f64,
}

/// What became of the voxels of all slices so far.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_sample_report {
    /// solid voxels
    pub solid: u64,
    /// of these, searched for instead of found from their neighbours
    pub located: u64,
    /// of these, that have a neighbour's properties: they lie within the surface and not within the
    /// shape
    pub filled: u64,
}

/// Where a tip is put: a voxel, or one that would be there beyond the grid's border.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_dab {
    /// column, row, layer; each within 2^30 of 0
    pub x: i32,
    /// column, row, layer; each within 2^30 of 0
    pub y: i32,
    /// column, row, layer; each within 2^30 of 0
    pub z: i32,
}

/// A brush. Fill with sf_brush_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_brush {
    /// sizeof(sf_brush), set by the default
    pub struct_size: usize,
    /// add-trim by default
    pub kind: sf_brush_kind,
    /// must outlive the stroke; NULL by default, which no stroke takes
    pub tip: *const sf_tip,
    /// of what is added or painted: 1 (default) to 255
    pub material: u8,
    /// of smooth-trim: 1 (default) to SF_BRUSH_PASSES_MAX
    pub passes: u32,
    /// 1: every tip is also put mirrored, x to nx - 1 - x; 0 by default
    pub mirror_x: c_int,
    /// the same along y; both give four tips for each dab
    pub mirror_y: c_int,
}

/// What a call changed, and what of a stroke was kept back or lost.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_sculpt_change {
    /// box around the voxels of D that this call changed, and around no more than the stroke
    /// changes or did before the call; empty (all zero) where there are none
    pub drawn: sf_box,
    /// the same for T
    pub printable: sf_box,
    /// the same for materials
    pub material: sf_box,
    /// printable now and not before
    pub added_voxels: u64,
    /// within the union of the tips printable before and not now
    pub removed_voxels: u64,
    /// outside it printable before and not now: what fell
    pub lost_voxels: u64,
    /// adding: of the tips, not printable, because nothing carries them; remove-preserve: of the
    /// tips, left, because they carry
    pub kept_back_voxels: u64,
    /// add-grow: of the supporting paths, each voxel once for each
    pub path_voxels: u64,
}

/// How a model is made. Fill with sf_sculpt_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_sculpt_options {
    /// sizeof(sf_sculpt_options), set by the default
    pub struct_size: usize,
    /// 512 x 512 x 512 voxels of 0.25 mm by default, as in the paper
    pub lattice: sf_lattice,
    /// box3 by default; its table must outlive the model
    pub rule: sf_rule,
    /// layer that rests on the bed: 0 by default. SF_BED_AUTO is refused: the bed does not move
    /// while one works
    pub bed_layer: u32,
    /// 1: what is trimmed stays as a ghost; 0 by default
    pub keep_drawn: c_int,
    /// bytes for undo and redo: 64 MiB by default
    pub history_size: usize,
}

/// What a history holds.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_sculpt_history {
    /// steps that can be undone
    pub undo_count: usize,
    /// steps that were undone and can be done again
    pub redo_count: usize,
    /// bytes that they take
    pub size: usize,
    /// steps that were forgotten for want of memory
    pub forgotten_count: usize,
}

/// The space of a session. Fill with sf_session_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_session_options {
    /// sizeof(sf_session_options), set by the default
    pub struct_size: usize,
    /// as in sf_sculpt_options, with layers of one height
    pub lattice: sf_lattice,
    /// box3 by default
    pub rule: sf_rule_kind,
    /// of the rule, as sf_rule_make() takes it; 45 degrees by default
    pub angle_rad: f64,
    /// 0 by default
    pub bed_layer: u32,
    /// 0 by default
    pub keep_drawn: c_int,
    /// 64 MiB by default
    pub history_size: usize,
}

/// What a session holds.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_session_counts {
    /// strokes are steps
    pub tips: usize,
    /// strokes are steps
    pub steps: usize,
    /// dabs of all strokes
    pub strokes: usize,
    /// dabs of all strokes
    pub dabs: usize,
    /// 1: the state at its end as well
    pub has_state: c_int,
}

/// How a shape is made to stand. Fill with sf_stand_options_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_stand_options {
    /// sizeof(sf_stand_options), set by the default
    pub struct_size: usize,
    /// voxels are cubes of this edge; 0 (default): a sixty-fourth of the longest side
    pub pitch_mm: f64,
    /// how thick the wall must be everywhere; 0 (default): a hundredth of the longest side
    pub wall_mm: f64,
    /// 1 (default): the inside is carved; 0: it stays solid
    pub carve: c_int,
    /// 1 (default): the outside is bent where carving is not enough
    pub deform: c_int,
    /// support-free by default
    pub carve_mode: sf_carve_mode,
    /// support-free: width of what is left standing inside; 2
    pub strut_width_vx: u32,
    /// support-free: what may rest on what; octagon
    pub rule: sf_rule_kind,
    /// and how far it may hang over; 45 degrees
    pub angle_rad: f64,
    /// quadratic programs by default
    pub solver: sf_stand_solver,
    /// descent: what the shape weighs in the sum at first; 0.5; 0..1
    pub mu: f64,
    /// what lost details cost; 1; at least 0, as are all three
    pub weight_details: f64,
    /// what moved matter costs; 0.3
    pub weight_shifts: f64,
    /// what changed sizes cost; 0.05
    pub weight_scales: f64,
    /// handles scale by no less; 0.7; more than 0, at most 1
    pub scale_low: f64,
    /// and by no more; 1.4; at least 1
    pub scale_high: f64,
    /// handles move no farther along x, y or z, but by hand or by descent; 0 (default): half the
    /// longest side
    pub shift_max_mm: f64,
    /// 1: handles may turn as well; 0 by default, as in the paper
    pub turn: c_int,
    /// how far above the ground all must stay that does not stand on it; 0 (default): a hundredth
    /// of the longest side
    pub clearance_mm: f64,
    /// bending aims at so much more than the stances ask for, because the carving after it is
    /// another; a tenth of a degree
    pub reserve_rad: f64,
    /// most rounds; 0 (default): 40, or 400 of descent, a step each
    pub rounds_max: u32,
    /// masses that sit in the shape, where they are before bending; copied; may be NULL where there
    /// are none
    pub ballast: *const sf_ballast,
    /// how many; 0 by default
    pub ballast_count: usize,
    /// NULL (default): 1 everywhere
    pub density: sf_density_field,
    /// handed to it; may be NULL
    pub density_user: *mut c_void,
    /// what is never carved, beside the wall; NULL (default): nothing
    pub keep: sf_keep_field,
    /// handed to it; may be NULL
    pub keep_user: *mut c_void,
}

/// How far a shape has come. Angles are the least over all stances.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_stand_report {
    /// rounds so far
    pub rounds: u32,
    /// steps of the solver so far
    pub steps: u32,
    /// 1: another round would change nothing
    pub ended: c_int,
    /// 1: in every stance it rests by itself, but maybe not safely
    pub stands: c_int,
    /// 1: every stance has the margin that it asks for
    pub safe: c_int,
    /// 1: it is safe, and bending has neither folded it over nor sunk it into the ground by more
    /// than a ten-thousandth of its size
    pub succeeded: c_int,
    /// the margin, as sf_stance_judge() gives it: the least
    pub margin_rad: f64,
    /// of the solid as it was given, densities included
    pub margin_before_rad: f64,
    /// standing alone: no carving of the shape as it was given has a better margin, were voxels
    /// carved by any fraction, support-free or not; 90 degrees where nothing was carved, where
    /// handles were posed before the first round, and where carving could bring the centre of mass
    /// to the ground, off a table's edge
    pub bound_rad: f64,
    /// centre of mass of the shape as it is
    pub com_mm: [f64; 3],
    /// and as it was given
    pub com_before_mm: [f64; 3],
    /// density times volume in mm3
    pub mass: f64,
    /// volume of the cavity
    pub carved_mm3: f64,
    /// what bending costs
    pub energy: f64,
    /// how far the vertex that moved most was bent, from where it was with its feet flat
    pub displacement_mm: f64,
    /// least factor by which bending changes volume, anywhere: not above 0 the shape is folded over
    pub least_det: f64,
    /// places where it is
    pub folded: u64,
    /// voxels that the shape fills twice: it runs into itself
    pub overlap_voxels: u64,
    /// how far the lowest vertex that does not stand is too low
    pub sunk_mm: f64,
    /// voxels of the carved shape that nothing supports and that were supported in the solid: 0 but
    /// for the paper's carving
    pub hanging_voxels: u64,
}

/// A material, or a colour of a group.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_threemf_colour {
    /// of a base material; "" for a colour of a group
    pub name: *const c_char,
    /// red, green, blue, and 255 for opaque; sRGB
    pub rgba: [u8; 4],
    /// colours of one group of the file have the same number, from 0
    pub group: u32,
}

/// An object that has triangles of its own.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_threemf_object {
    /// as the file says, or ""
    pub name: *const c_char,
    /// what it is for
    pub kind: sf_threemf_kind,
    /// in mm, in the object's own axes
    pub mesh: sf_mesh_view,
    /// 3 for each triangle, of its corners: numbers of colours, or SF_THREEMF_NONE; NULL where no
    /// triangle has any
    pub colours: *const u32,
    /// number of its stack of slices, or SF_THREEMF_NONE
    pub stack: u32,
    /// 1 where the file says that the triangles only stand for slices
    pub is_rough: c_int,
}

/// An object in its place on the printer's bed. Components are resolved: each of them is one.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_threemf_item {
    /// number of the object
    pub object: u32,
    /// from the object's axes to the bed's, in mm
    pub placed: sf_transform,
}

/// A view of what a file holds; good until the document is destroyed.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_threemf_view {
    /// all materials and colours of all groups
    pub colours: *const sf_threemf_colour,
    /// how many
    pub colour_count: usize,
    /// those with triangles, in the order of the file
    pub objects: *const sf_threemf_object,
    /// how many
    pub object_count: usize,
    /// what is built, in the order of the file
    pub items: *const sf_threemf_item,
    /// how many
    pub item_count: usize,
    /// how many stacks of slices objects have
    pub stack_count: usize,
}

/// A property that varies inside an object.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_threemf_field {
    /// UTF-8, for people; not ""
    pub name: *const c_char,
    /// the value that 0 stands for
    pub low: f64,
    /// the value that 65535 stands for, above `low`
    pub high: f64,
}

/// Properties inside an object, on a lattice: the volumetric extension's stacks of pictures.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_threemf_volume {
    /// number of the object that they fill
    pub object: u32,
    /// in the object's axes; heights_mm is NULL
    pub lattice: sf_lattice,
    /// how many properties, 1 to 64
    pub field_count: usize,
    /// what they are
    pub fields: *const sf_threemf_field,
    /// number of a group of base materials whose fractions are the first properties, one for each;
    /// or SF_THREEMF_NONE
    pub mixed_group: u32,
    /// Fill a layer: planes\[f\]\[y \* nx + x\] for each property f. Called once for each layer,
    /// from the bottom up; a status other than SF_OK ends the writing and is passed on.
    pub layer: Option<unsafe extern "C" fn(user: *mut c_void, k: u32, planes: *const *mut u16) -> sf_status>,
    /// handed to it; may be NULL
    pub user: *mut c_void,
}

/// What a file may hold beside its objects. Fill with sf_threemf_extras_default().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct sf_threemf_extras {
    /// sizeof(sf_threemf_extras), set by the default
    pub struct_size: usize,
    /// a picture of it, a PNG file; NULL: none
    pub thumbnail: *const c_void,
    /// its bytes
    pub thumbnail_size: usize,
    /// properties inside one of the objects; NULL: none
    pub volume: *const sf_threemf_volume,
}

extern "C" {
    /// Version of the library that is running, as "major.minor.patch".
    ///
    /// - returns: a static string, never NULL.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_version() -> *const c_char;

    /// Name of a status code, such as "SF_ERR_SHAPE".
    ///
    /// - `status`: any value; one that is no code gives "SF_STATUS_UNKNOWN"
    /// - returns: a static string, never NULL.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_status_name(status: sf_status) -> *const c_char;

    /// One English sentence that explains a status code.
    ///
    /// - `status`: any value
    /// - returns: a static string, never NULL.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_status_message(status: sf_status) -> *const c_char;

    /// A source that reads from memory.
    ///
    /// - `cursor`: data, size and position, not NULL; must outlive the source; position advances
    ///   with each read
    /// - returns: the source.
    /// - cost: constant.
    /// - threads: any, on distinct cursors.
    /// - since: 0.1
    pub fn sf_memory_source(cursor: *mut sf_memory_cursor) -> sf_source;

    /// A task without callbacks, not cancelled.
    ///
    /// - returns: the task, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_task_default() -> sf_task;

    /// Ask a task to stop.
    ///
    /// The request sticks: every later call with this task is cancelled too.
    ///
    /// - `task`: the task; NULL does nothing
    /// - cost: constant.
    /// - threads: any, while the task is in use.
    /// - since: 0.1
    pub fn sf_task_cancel(task: *mut sf_task);

    /// Whether a task has been cancelled.
    ///
    /// - `task`: the task; NULL counts as never cancelled
    /// - returns: 1 if cancelled, else 0.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_task_is_cancelled(task: *const sf_task) -> c_int;

    /// Use no instruction set above `limit`, for tests and benches; results never depend on it.
    ///
    /// - `limit`: the highest set to use; SF_ISA_COUNT or any other value lifts the limit
    /// - returns: the name of the set now in use: the best one that the processor has within the
    ///   limit; a static string, never NULL.
    /// - cost: constant.
    /// - threads: any; work under way elsewhere may end on the old set.
    /// - since: 0.1
    pub fn sf_isa_limit(limit: sf_isa) -> *const c_char;

    /// Words from row to row in slices that the library allocates: rows start on 64-byte
    /// boundaries.
    ///
    /// - `width`: voxels along x
    /// - returns: the smallest multiple of 8 words that holds `width` voxels.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_slice_stride(width: u32) -> usize;

    /// Whether voxel (x, y) is solid.
    ///
    /// - `slice`: the slice
    /// - `x`: column
    /// - `y`: row
    /// - returns: 1 or 0; 0 for a voxel outside the slice and for a slice without words.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_slice_get(slice: sf_slice, x: u32, y: u32) -> c_int;

    /// Make voxel (x, y) solid (value != 0) or empty.
    ///
    /// - `slice`: the slice, written
    /// - `x`: column, below the width
    /// - `y`: row, below the height
    /// - `value`: 0: empty; else solid
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a slice that is none (no words, a width or height outside
    ///   its range, a stride that is too small), a voxel outside.
    /// - cost: constant.
    /// - threads: one per slice.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_set(slice: sf_slice, x: u32, y: u32, value: c_int) -> sf_status;

    /// Make every voxel of a rectangle solid (value != 0) or empty; an empty rectangle changes
    /// nothing.
    ///
    /// - `slice`: the slice, written
    /// - `rect`: the voxels, all within the slice
    /// - `value`: 0: empty; else solid
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a slice that is none, a rectangle that leaves it.
    /// - cost: the words of the rectangle.
    /// - threads: one per slice.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_fill(slice: sf_slice, rect: sf_rect, value: c_int) -> sf_status;

    /// dst = src.
    ///
    /// Both have one size, with any strides. dst may be src (the same words and stride), but must
    /// not lie across it; so too for both inputs of the four functions that follow.
    ///
    /// - `dst`: the copy, written
    /// - `src`: what is copied
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a slice that is none, a dst across an input;
    ///   SF_ERR_SHAPE: slices that differ in size.
    /// - cost: one pass over the slices.
    /// - threads: any that write to distinct slices.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_copy(dst: sf_slice, src: sf_slice) -> sf_status;

    /// dst = a AND b: solid where both are.
    ///
    /// - `dst`: the result, written
    /// - `a`: one slice
    /// - `b`: the other
    /// - returns: as sf_slice_copy().
    /// - cost: one pass.
    /// - threads: any that write to distinct slices.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_and(dst: sf_slice, a: sf_slice, b: sf_slice) -> sf_status;

    /// dst = a OR b: solid where either is.
    ///
    /// - `dst`: the result, written
    /// - `a`: one slice
    /// - `b`: the other
    /// - returns: as sf_slice_copy().
    /// - cost: one pass.
    /// - threads: any that write to distinct slices.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_or(dst: sf_slice, a: sf_slice, b: sf_slice) -> sf_status;

    /// dst = a XOR b: solid where just one is.
    ///
    /// - `dst`: the result, written
    /// - `a`: one slice
    /// - `b`: the other
    /// - returns: as sf_slice_copy().
    /// - cost: one pass.
    /// - threads: any that write to distinct slices.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_xor(dst: sf_slice, a: sf_slice, b: sf_slice) -> sf_status;

    /// dst = a AND NOT b: solid where a is and b is not.
    ///
    /// - `dst`: the result, written
    /// - `a`: one slice
    /// - `b`: what is taken away from it
    /// - returns: as sf_slice_copy().
    /// - cost: one pass.
    /// - threads: any that write to distinct slices.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_subtract(dst: sf_slice, a: sf_slice, b: sf_slice) -> sf_status;

    /// Whether two slices have the same size and the same solid voxels.
    ///
    /// - `a`: one slice
    /// - `b`: the other
    /// - returns: 1 or 0; 0 where either is no slice.
    /// - cost: one pass, up to the first row that differs.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_slice_equal(a: sf_slice, b: sf_slice) -> c_int;

    /// Number of solid voxels.
    ///
    /// - `slice`: the slice
    /// - returns: the number; 0 for a slice that is none.
    /// - cost: one pass.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_slice_popcount(slice: sf_slice) -> u64;

    /// Smallest rectangle around the solid voxels.
    ///
    /// - `slice`: the slice
    /// - returns: the rectangle; all zero where nothing is solid, and for a slice that is none.
    /// - cost: one pass at most.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_slice_bounds(slice: sf_slice) -> sf_rect;

    /// Exact integer sums over the solid voxels: their number, and those of x, y and their
    /// products.
    ///
    /// - `slice`: the slice
    /// - `sums`: receives the sums
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a slice that is none, a NULL pointer.
    /// - cost: one pass.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_measure(slice: sf_slice, sums: *mut sf_slice_sums) -> sf_status;

    /// The 3x3 square.
    ///
    /// - returns: the element, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_element_box3() -> sf_element;

    /// The plus: a voxel and its four edge neighbours.
    ///
    /// - returns: the element, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_element_plus3() -> sf_element;

    /// Lattice points of the ellipse (dx / rx)^2 + (dy / ry)^2 \<= 1, with radii in 1/65536 voxel.
    ///
    /// Exact: no point is lost or won by rounding. A radius below a voxel gives no reach on its
    /// axis.
    ///
    /// - `rx_q16`: radius along x, in 1/65536 voxel
    /// - `ry_q16`: radius along y, in 1/65536 voxel
    /// - `element`: receives the element
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_OVERFLOW: a radius of SF_REACH_MAX
    ///   + 1 voxels or more.
    /// - cost: O(rx + ry), in voxels.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_element_ellipse(rx_q16: u64, ry_q16: u64, element: *mut sf_element) -> sf_status;

    /// Minkowski sum of two elements: dilating by it is dilating by one and then by the other.
    ///
    /// - `a`: one element
    /// - `b`: the other
    /// - `sum`: receives the sum; may be `a` or `b`
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, an element that breaks its promises;
    ///   SF_ERR_OVERFLOW: a sum that reaches beyond SF_REACH_MAX.
    /// - cost: the product of both reaches along y.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_element_sum(
        a: *const sf_element,
        b: *const sf_element,
        sum: *mut sf_element,
    ) -> sf_status;

    /// Dilation: dst is solid where the element, placed there, meets src or, beyond it, the border.
    ///
    /// Both have one size. dst must not overlap src.
    ///
    /// - `dst`: the result, written
    /// - `src`: what is dilated
    /// - `element`: by what
    /// - `border`: what lies outside src
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a slice that is none, an element that breaks its
    ///   promises, no such border, a dst that overlaps src; SF_ERR_SHAPE: slices that differ in
    ///   size.
    /// - cost: 2 reach_y + 1 unions of rows for each row, and a few shifts where half widths
    ///   change.
    /// - threads: any that write to distinct slices.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_dilate(
        dst: sf_slice,
        src: sf_slice,
        element: *const sf_element,
        border: sf_border,
    ) -> sf_status;

    /// Erosion: dst is solid where the element, placed there, lies in src and, beyond it, in the
    /// border.
    ///
    /// It is the complement of the dilation of the complement, the border complemented as well.
    ///
    /// - `dst`: the result, written
    /// - `src`: what is eroded
    /// - `element`: by what
    /// - `border`: what lies outside src
    /// - returns: as sf_slice_dilate().
    /// - cost: as sf_slice_dilate().
    /// - threads: any that write to distinct slices.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_erode(
        dst: sf_slice,
        src: sf_slice,
        element: *const sf_element,
        border: sf_border,
    ) -> sf_status;

    /// One step of trimming in one pass: dst = src AND dilate(below), outside empty.
    ///
    /// All three have one size. dst may be src, and must not overlap below.
    ///
    /// - `dst`: the result, written
    /// - `src`: the layer that is trimmed
    /// - `below`: the layer below it, which is dilated
    /// - `element`: by what
    /// - returns: as sf_slice_dilate().
    /// - cost: one pass for the square and the plus, else as sf_slice_dilate().
    /// - threads: any that write to distinct slices.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_and_dilate(
        dst: sf_slice,
        src: sf_slice,
        below: sf_slice,
        element: *const sf_element,
    ) -> sf_status;

    /// Number of runs of solid voxels: the capacity that sf_slice_runs() needs.
    ///
    /// - `slice`: the slice
    /// - `count`: receives the number
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a slice that is none, a NULL pointer; SF_ERR_OVERFLOW:
    ///   more runs than a size_t holds.
    /// - cost: one pass.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_run_count(slice: sf_slice, count: *mut usize) -> sf_status;

    /// The runs of a slice in row order, from left to right, with label 0.
    ///
    /// - `slice`: the slice
    /// - `runs`: receives the runs; may be NULL where there are none
    /// - `capacity`: places in `runs`
    /// - `count`: receives the number of runs
    /// - returns: SF_OK; SF_ERR_CAPACITY: more runs than places, with their number in `count` and
    ///   nothing else written; else as sf_slice_run_count().
    /// - cost: two passes, and the runs.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_runs(
        slice: sf_slice,
        runs: *mut sf_run,
        capacity: usize,
        count: *mut usize,
    ) -> sf_status;

    /// Paint runs, in any order and free to overlap: dst is solid where a run is, and empty
    /// elsewhere.
    ///
    /// - `dst`: the slice, written
    /// - `runs`: the runs; labels are ignored; may be NULL where count is 0
    /// - `count`: how many
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a slice that is none, a NULL pointer, a run that is empty
    ///   or leaves the slice.
    /// - cost: one pass, and the runs.
    /// - threads: one per slice.
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_from_runs(dst: sf_slice, runs: *const sf_run, count: usize) -> sf_status;

    /// Label runs with their connected component, in place, numbered from 0 by first run.
    ///
    /// The runs are those of sf_slice_runs(): in row order, from left to right, with an empty voxel
    /// between those of one row. Labels on entry are ignored.
    ///
    /// - `runs`: the runs, whose labels are written; may be NULL where count is 0
    /// - `count`: how many
    /// - `connectivity`: which voxels are neighbours
    /// - `component_count`: receives the number of components
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such connectivity, runs that are
    ///   empty, out of order or beyond the largest slice; SF_ERR_OVERFLOW: more than UINT32_MAX
    ///   runs.
    /// - cost: nearly linear in the runs; no memory.
    /// - threads: one per array.
    /// - source: R. E. Tarjan, "Efficiency of a Good But Not Linear Set Union Algorithm", 1975.
    /// - since: 0.1
    #[must_use]
    pub fn sf_runs_label(
        runs: *mut sf_run,
        count: usize,
        connectivity: sf_connectivity,
        component_count: *mut u32,
    ) -> sf_status;

    /// Area and bounds of each labelled component; places that no run names become zero.
    ///
    /// - `runs`: labelled runs; may be NULL where count is 0
    /// - `count`: how many
    /// - `components`: receives area and bounds, by label; may be NULL where capacity is 0
    /// - `capacity`: places in `components`
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a run that is empty or beyond the largest
    ///   slice; SF_ERR_CAPACITY: a label without a place.
    /// - cost: linear in runs and places.
    /// - threads: any that write to distinct arrays.
    /// - since: 0.1
    #[must_use]
    pub fn sf_runs_measure(
        runs: *const sf_run,
        count: usize,
        components: *mut sf_component,
        capacity: usize,
    ) -> sf_status;

    /// Check a lattice: counts within limits, lengths finite and positive.
    ///
    /// - `lattice`: the lattice
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a count of 0, a pitch or height that is
    ///   no number in (0, 1e12\], an origin beyond 1e12; SF_ERR_OVERFLOW: a count beyond its limit.
    /// - cost: constant, or O(nz) with heights.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_lattice_validate(lattice: *const sf_lattice) -> sf_status;

    /// Height of layer k in mm.
    ///
    /// - `lattice`: a valid lattice, not NULL
    /// - `k`: the layer, below nz
    /// - returns: the height.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_lattice_layer_height(lattice: *const sf_lattice, k: u32) -> f64;

    /// z of the bottom of layer k in mm, in the lattice's frame.
    ///
    /// - `lattice`: a valid lattice, not NULL
    /// - `k`: the layer, or nz for the top
    /// - returns: z; with heights it is their sum from the lowest up, so that it is the same
    ///   everywhere.
    /// - cost: constant, or O(k) with heights.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_lattice_layer_bottom(lattice: *const sf_lattice, k: u32) -> f64;

    /// Make a grid with all voxels empty on a lattice, which is copied, heights included.
    ///
    /// - `lattice`: where the voxels lie; copied
    /// - `allocator`: for the grid; NULL for the C library's
    /// - `grid`: receives the grid
    /// - returns: SF_OK; what sf_lattice_validate() says; SF_ERR_ARGUMENT: a NULL pointer;
    ///   SF_ERR_OVERFLOW: more bytes than a size_t holds; SF_ERR_MEMORY.
    /// - cost: one pass over new memory.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_create(
        lattice: *const sf_lattice,
        allocator: *const sf_allocator,
        grid: *mut *mut sf_grid,
    ) -> sf_status;

    /// Make a copy of a grid.
    ///
    /// - `grid`: the grid to copy
    /// - `allocator`: for the copy, and maybe another than the grid's own; NULL for the C library's
    /// - `clone`: receives the copy
    /// - returns: as sf_grid_create().
    /// - cost: one pass.
    /// - threads: any that read; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_clone(
        grid: *const sf_grid,
        allocator: *const sf_allocator,
        clone: *mut *mut sf_grid,
    ) -> sf_status;

    /// Free a grid.
    ///
    /// - `grid`: the grid, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this grid.
    /// - since: 0.1
    pub fn sf_grid_destroy(grid: *mut sf_grid);

    /// The lattice of a grid.
    ///
    /// - `grid`: the grid, not NULL
    /// - returns: the lattice, by value; its heights_mm, if any, belong to the grid.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_grid_lattice(grid: *const sf_grid) -> sf_lattice;

    /// View of slice k, to read or to write: it lives as long as the grid.
    ///
    /// - `grid`: the grid; NULL has none
    /// - `k`: the layer
    /// - returns: the slice; one without words when k is out of range or the grid NULL.
    /// - cost: constant.
    /// - threads: any; distinct slices may be written at once.
    /// - since: 0.1
    pub fn sf_grid_slice(grid: *const sf_grid, k: u32) -> sf_slice;

    /// Whether two grids have the same counts and the same solid voxels; lengths are not compared.
    ///
    /// - `a`: one grid; NULL equals nothing
    /// - `b`: the other; NULL equals nothing
    /// - returns: 1 or 0; 0 where either is NULL.
    /// - cost: one pass, up to the first row that differs.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_grid_equal(a: *const sf_grid, b: *const sf_grid) -> c_int;

    /// Number of solid voxels.
    ///
    /// - `grid`: the grid; NULL has no voxels
    /// - returns: the number; 0 for NULL.
    /// - cost: one pass.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_grid_popcount(grid: *const sf_grid) -> u64;

    /// Smallest box around the solid voxels.
    ///
    /// - `grid`: the grid; NULL has no voxels
    /// - returns: the box; all zero when there are none, or for NULL.
    /// - cost: one pass at most.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_grid_bounds(grid: *const sf_grid) -> sf_box;

    /// Exact moments of the solid voxels, in voxel indices; a failing call leaves `moments` as it
    /// was.
    ///
    /// - `grid`: the grid
    /// - `task`: NULL, or progress, cancel and threads
    /// - `moments`: receives the sums
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer other than `task`; SF_ERR_CANCELLED, which
    ///   is heeded after every 64 slices.
    /// - cost: one pass, shared among the task's threads.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_measure(
        grid: *const sf_grid,
        task: *mut sf_task,
        moments: *mut sf_moments,
    ) -> sf_status;

    /// Make an empty mesh.
    ///
    /// - `allocator`: where its memory comes from, now and as it grows; NULL for the C library's
    /// - `mesh`: receives the mesh
    /// - returns: SF_OK; SF_ERR_ARGUMENT: `mesh` is NULL; SF_ERR_MEMORY.
    /// - cost: constant.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_create(allocator: *const sf_allocator, mesh: *mut *mut sf_mesh) -> sf_status;

    /// Free a mesh; NULL does nothing.
    ///
    /// - `mesh`: the mesh, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this mesh.
    /// - since: 0.1
    pub fn sf_mesh_destroy(mesh: *mut sf_mesh);

    /// View of a mesh, valid until the mesh is changed or destroyed.
    ///
    /// - `mesh`: the mesh; NULL gives a view of nothing
    /// - returns: the view; its coordinates are finite and its indices name vertices, whatever
    ///   happened.
    /// - cost: constant.
    /// - threads: any, while nobody changes the mesh.
    /// - since: 0.1
    pub fn sf_mesh_get_view(mesh: *const sf_mesh) -> sf_mesh_view;

    /// Append vertices.
    ///
    /// - `mesh`: the mesh
    /// - `xyz`: 3 \* count coordinates in mm, vertex after vertex; not in the mesh's own arrays;
    ///   may be NULL where count is 0
    /// - `count`: number of vertices
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a coordinate that is not finite;
    ///   SF_ERR_OVERFLOW: more than UINT32_MAX vertices in all; SF_ERR_MEMORY.
    /// - cost: O(count) when many calls are taken together.
    /// - threads: one per mesh.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_add_vertices(mesh: *mut sf_mesh, xyz: *const f64, count: usize) -> sf_status;

    /// Append triangles, counter-clockwise seen from outside.
    ///
    /// - `mesh`: the mesh
    /// - `indices`: 3 \* count vertex numbers; not in the mesh's own arrays; may be NULL where
    ///   count is 0. Triangles with two equal corners are taken.
    /// - `count`: number of triangles
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, an index that names no vertex yet;
    ///   SF_ERR_OVERFLOW: more triangles than the machine can address; SF_ERR_MEMORY.
    /// - cost: O(count) when many calls are taken together.
    /// - threads: one per mesh.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_add_triangles(
        mesh: *mut sf_mesh,
        indices: *const u32,
        count: usize,
    ) -> sf_status;

    /// Check a view: arrays where there are counts, indices in range, coordinates finite.
    ///
    /// - `mesh`: the view
    /// - `fault`: NULL, or receives a sentence that names the first vertex or triangle at fault
    /// - returns: SF_OK; SF_ERR_ARGUMENT: it is no mesh; SF_ERR_OVERFLOW: more than UINT32_MAX
    ///   vertices, or more vertices or triangles than the machine can address.
    /// - cost: linear.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_validate(mesh: sf_mesh_view, fault: *mut sf_fault) -> sf_status;

    /// Apply an affine map to every vertex; a map that mirrors turns every triangle around.
    ///
    /// - `mesh`: the mesh, changed in place
    /// - `transform`: the map; its determinant must be neither 0 nor infinite
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a map that flattens or is not finite;
    ///   SF_ERR_OVERFLOW: a vertex that would not be finite any more.
    /// - cost: two passes over the vertices, one over the triangles of a mirrored mesh.
    /// - threads: one per mesh.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_transform(mesh: *mut sf_mesh, transform: *const sf_transform) -> sf_status;

    /// Copy of a mesh in which vertices of equal position are one.
    ///
    /// Positions are equal when they are the same once rounded to a grain: the power of two that is
    /// 2^-40 to 2^-39 of the largest coordinate. The first vertex at a position stands for all, and
    /// vertices are numbered by first appearance. Triangles stay, in their order, also those that
    /// lose a corner.
    ///
    /// - `mesh`: the mesh to copy
    /// - `allocator`: for the copy and for scratch; NULL for the C library's
    /// - `merged`: receives the copy
    /// - returns: SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer;
    ///   SF_ERR_OVERFLOW: more vertices than the machine can address twice; SF_ERR_MEMORY.
    /// - cost: linear, but for collisions in a hash table.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_merge(
        mesh: sf_mesh_view,
        allocator: *const sf_allocator,
        merged: *mut *mut sf_mesh,
    ) -> sf_status;

    /// Smallest box around the vertices that triangles use.
    ///
    /// - `mesh`: the mesh
    /// - `minimum_mm`: receives the lower corner
    /// - `maximum_mm`: receives the upper corner
    /// - returns: SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer, a mesh
    ///   without triangles.
    /// - cost: linear.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_bounds(
        mesh: sf_mesh_view,
        minimum_mm: *mut f64,
        maximum_mm: *mut f64,
    ) -> sf_status;

    /// How the triangles of a mesh hang together: holes, edges of too many triangles, shells,
    /// sense.
    ///
    /// Vertices of equal position are one point, in the sense of sf_mesh_merge(); the mesh itself
    /// need not be merged. Triangles with fewer than three points are counted, and take no further
    /// part.
    ///
    /// - `mesh`: the mesh; its triangles are at most INT32_MAX
    /// - `allocator`: for scratch, about 125 bytes a triangle; NULL for the C library's
    /// - `topology`: receives the counts
    /// - returns: SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer, a mesh
    ///   without triangles; SF_ERR_OVERFLOW: too many triangles; SF_ERR_MEMORY.
    /// - cost: nearly linear in vertices and triangles.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_analyze(
        mesh: sf_mesh_view,
        allocator: *const sf_allocator,
        topology: *mut sf_topology,
    ) -> sf_status;

    /// Volume, area, centre of mass and inertia of the solid that a mesh bounds.
    ///
    /// Exact but for rounding where the mesh is closed and oriented. Elsewhere only the area means
    /// anything: what is open has no volume, and the figures depend on where the mesh lies.
    ///
    /// - `mesh`: the mesh
    /// - `mass`: receives the integrals
    /// - returns: SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer, a mesh
    ///   without triangles.
    /// - cost: two passes over the triangles, in their order: the same bytes on every machine.
    /// - threads: any.
    /// - source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing
    ///   Shapes for 3D Fabrication", SIGGRAPH 2013, equation 3, corrected; D. Eberly, "Polyhedral
    ///   Mass Properties (Revisited)", 2002.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_measure(mesh: sf_mesh_view, mass: *mut sf_mass) -> sf_status;

    /// Cut a closed mesh by a plane across an axis into two closed halves.
    ///
    /// What the plane opens is closed by caps that lie exactly in it: with holes where it meets
    /// cavities (shells turned inwards), with islands in them, and with the vertices of the
    /// contours. Both caps have the same contours, but for triangles of the mesh within the plane,
    /// which belong to neither half; so the volumes of the halves add up to the whole's. Vertices
    /// of equal position are one, in the sense of sf_mesh_merge(), and one that is as near to the
    /// plane as that lies on it. Each half consists of its vertices, in the order of the mesh's,
    /// then those on cut edges; its triangles, in that order, too; and its cap.
    ///
    /// Where every edge of the mesh has two triangles, every edge of the halves has; where an edge
    /// of the mesh only touches the plane and a cap would have it, too, the cap gets a vertex in
    /// its middle. Where shells run through each other in the plane, or one through itself, the
    /// halves are closed and enclose what they should, but triangles of a cap lie over each other,
    /// and may share an edge.
    ///
    /// - `mesh`: closed and oriented, of any number of shells; its triangles at most INT32_MAX
    /// - `axis`: 0, 1 or 2: across x, y or z
    /// - `at_mm`: where the plane crosses that axis
    /// - `allocator`: for the halves, and for scratch, about 150 bytes a triangle; NULL for the C
    ///   library's
    /// - `low`: receives the half with the lower coordinates along the axis
    /// - `high`: receives the other half; not the same pointer
    /// - `fault`: NULL, or receives a sentence on failure, such as where the mesh is
    /// - returns: SF_OK; what sf_mesh_analyze() says; SF_ERR_ARGUMENT: a NULL pointer, an axis that
    ///   there is not, a place that is not finite; SF_ERR_UNSUPPORTED: a mesh that is open, or not
    ///   oriented alike everywhere; SF_ERR_INFEASIBLE: the plane leaves nothing on one side of it;
    ///   SF_ERR_OVERFLOW: a coordinate beyond 1e12 mm, more vertices than can be numbered;
    ///   SF_ERR_MEMORY.
    /// - cost: linear in vertices and triangles, 0.7 s for 3 million; n log n in the contours, or n
    ///   n, up to a few seconds, where they cross.
    /// - threads: any; one at a time for each allocator.
    /// - source: M. R. Garey, D. S. Johnson, F. P. Preparata, R. E. Tarjan, "Triangulating a simple
    ///   polygon", 1978; D. Eberly, "Triangulation by ear clipping", 2002, where contours cross.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_cut(
        mesh: sf_mesh_view,
        axis: c_int,
        at_mm: f64,
        allocator: *const sf_allocator,
        low: *mut *mut sf_mesh,
        high: *mut *mut sf_mesh,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Options of the voxeliser, each at its default.
    ///
    /// - returns: the options, by value: SF_FILL_AUTO.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_voxelize_options_default() -> sf_voxelize_options;

    /// Prepare to voxelise a mesh on a lattice, slice by slice.
    ///
    /// Every corner is rounded once to 1/256 of a voxel (1/256 of the mean layer height along z),
    /// and what follows is exact on the rounded mesh: a voxel is solid where the winding number
    /// around its centre is at least one half, and a centre that lies on the surface counts as
    /// lying just beyond it in x, then in y, then in z. So two closed meshes that share a face give
    /// disjoint voxels whose union is that of both, and no closed mesh leaks. Corners further than
    /// two million voxels from the lattice's origin are refused; what leaves the lattice is cut
    /// off.
    ///
    /// SF_FILL_AUTO takes any mesh: where it is not closed, equal corners are merged, neighbours
    /// that disagree are turned (as few as possible in each patch), and holes are spanned by the
    /// surface on which the generalised winding number is one half. Around holes that number comes
    /// from bounds and, in boxes of 8 voxels, from interpolation with a measured margin; away from
    /// a half it is never in doubt. Last, a mesh that encloses a negative volume is turned as a
    /// whole. SF_FILL_WINDING takes all triangles as they look, SF_FILL_PARITY counts crossings and
    /// reports rows that leak.
    ///
    /// SF_FILL_SURFACE sets each voxel whose closed box the rounded surface touches.
    ///
    /// - `mesh`: vertices in mm; its arrays must outlive the voxeliser; no triangles is fine
    /// - `lattice`: where voxels lie; copied as far as needed; at most 2^20 layers
    /// - `options`: NULL for the default
    /// - `allocator`: NULL for the C library's; its `user` must outlive the voxeliser
    /// - `voxelizer`: receives the new voxeliser
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT when a pointer is missing, an index names no vertex, or
    ///   lattice or options are out of range; SF_ERR_UNSUPPORTED when a corner is not finite or too
    ///   far away, or there are too many layers; SF_ERR_OVERFLOW for more than 2^32 - 1 vertices or
    ///   triangles (2^30 where the mesh is not closed), and for heights of layers that leave the
    ///   same two million voxels; SF_ERR_MEMORY.
    /// - cost: linear in vertices and triangles; more memory (about 100 bytes a triangle, for a
    ///   while) where the mesh is not closed.
    /// - threads: any; one at a time for each allocator.
    /// - source: J. Pineda, "A parallel algorithm for polygon rasterization", 1988; A. Jacobson, L.
    ///   Kavan, O. Sorkine-Hornung, "Robust inside-outside segmentation using generalized winding
    ///   numbers", 2013; G. Barill and others, "Fast winding numbers for soups and clouds", 2018;
    ///   M. Schwarz, H.-P. Seidel, "Fast parallel surface and solid voxelization on GPUs", 2010.
    /// - since: 0.1
    #[must_use]
    pub fn sf_voxelizer_create(
        mesh: sf_mesh_view,
        lattice: *const sf_lattice,
        options: *const sf_voxelize_options,
        allocator: *const sf_allocator,
        voxelizer: *mut *mut sf_voxelizer,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Free a voxeliser; NULL does nothing.
    ///
    /// - `voxelizer`: the voxeliser, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: any; not while the voxeliser is in use.
    /// - since: 0.1
    pub fn sf_voxelizer_destroy(voxelizer: *mut sf_voxelizer);

    /// Fill slice k of the lattice: the same bytes as that slice of sf_grid_voxelize().
    ///
    /// Slices can be asked for in any order and more than once; each asking counts in the report.
    ///
    /// - `voxelizer`: the voxeliser; only its counters change
    /// - `k`: layer, below the lattice's nz
    /// - `slice`: nx by ny voxels; what it held is lost; bits past the width become zero
    /// - returns: SF_OK; SF_ERR_ARGUMENT when a pointer is missing, k is out of range or the stride
    ///   too small; SF_ERR_SHAPE when the slice is not nx by ny.
    /// - cost: the crossings of the slab of layers that k lies in, and one pass over the slice; no
    ///   memory.
    /// - threads: one at a time for each voxeliser.
    /// - since: 0.1
    #[must_use]
    pub fn sf_voxelizer_slice(voxelizer: *mut sf_voxelizer, k: u32, slice: sf_slice) -> sf_status;

    /// What was found so far: sums over all slices that were filled.
    ///
    /// - `voxelizer`: the voxeliser
    /// - `report`: receives the report
    /// - returns: SF_OK; SF_ERR_ARGUMENT when a pointer is NULL.
    /// - cost: constant.
    /// - threads: one at a time for each voxeliser.
    /// - since: 0.1
    #[must_use]
    pub fn sf_voxelizer_report(
        voxelizer: *const sf_voxelizer,
        report: *mut sf_voxelize_report,
    ) -> sf_status;

    /// Fill a whole grid from a mesh; on failure the grid is as it was.
    ///
    /// The rules are those of sf_voxelizer_create(). A cancel is heeded after every slab of layers;
    /// so that nothing changes then, a grid that holds solid voxels is filled aside first when a
    /// task is given, which takes its memory a second time.
    ///
    /// - `grid`: what it held is lost
    /// - `mesh`: vertices in mm; no triangles is fine
    /// - `options`: NULL for the default
    /// - `allocator`: for scratch; NULL for the C library's
    /// - `task`: NULL, or progress, cancel and threads; the result is the same bytes with any
    /// - `report`: NULL, or receives the report on success
    /// - returns: SF_OK; SF_ERR_ARGUMENT, SF_ERR_UNSUPPORTED, SF_ERR_OVERFLOW, SF_ERR_MEMORY as
    ///   sf_voxelizer_create(); SF_ERR_CANCELLED.
    /// - cost: linear in triangles, crossings, and words of the grid; around holes, also in the
    ///   voxels near the surface that spans them. 82,000 triangles on 512^3: 14 ms on one core.
    /// - threads: any, on distinct grids; the task's hook may run up to 16 pieces at once; one at a
    ///   time for each allocator.
    /// - source: as sf_voxelizer_create().
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_voxelize(
        grid: *mut sf_grid,
        mesh: sf_mesh_view,
        options: *const sf_voxelize_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        report: *mut sf_voxelize_report,
    ) -> sf_status;

    /// Options of a surface, each at its default.
    ///
    /// - returns: the options, by value: no smoothing.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_surface_options_default() -> sf_surface_options;

    /// The boundary of the solid voxels as a closed, oriented 2-manifold in the lattice's frame.
    ///
    /// It stays 2-manifold after vertices of equal position are merged: where voxels touch only
    /// along an edge or in a corner, the vertices there are moved by a sixteenth of a voxel into
    /// the solid. So voxelising it on the same lattice gives the same grid back. Every voxel face
    /// is two triangles, or up to six beside such an edge; a grid without solid voxels gives a mesh
    /// without triangles.
    ///
    /// Smoothing takes steps out of the surface without shrinking it, and keeps every vertex within
    /// half a voxel of its place along each axis and the mesh closed. Voxels of what is smoothed
    /// are others, and may need support that those of the grid do not.
    ///
    /// - `grid`: the voxels, only read; what lies outside is empty
    /// - `options`: NULL for the default
    /// - `allocator`: for the mesh and for scratch, 10 bytes for each column of voxels and, with
    ///   smoothing, 52 for each vertex; NULL for the C library's
    /// - `task`: NULL, or progress and cancel, which is heeded at every slice and every smoothing
    ///   pass
    /// - `mesh`: receives the mesh
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, a
    ///   number of passes outside its range; SF_ERR_OVERFLOW: more than UINT32_MAX vertices, or
    ///   more triangles than the machine can address; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: two passes over the grid and the boundary; two over the triangles for each smoothing
    ///   pass.
    /// - threads: any; the grid is only read; one at a time for each allocator.
    /// - source: for smoothing G. Taubin, "A Signal Processing Approach to Fair Surface Design",
    ///   SIGGRAPH 1995, section 2.2; S. F. F. Gibson, "Constrained Elastic Surface Nets", MICCAI
    ///   1998.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_surface(
        grid: *const sf_grid,
        options: *const sf_surface_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        mesh: *mut *mut sf_mesh,
    ) -> sf_status;

    /// Body of the solid that a closed mesh bounds.
    ///
    /// - `mesh`: closed and oriented; inside out it is a cavity, and its mass negative
    /// - `density`: what 1 mm3 weighs; finite
    /// - `body`: receives the body
    /// - returns: SF_OK; what sf_mesh_measure() says; SF_ERR_ARGUMENT: a density that is not
    ///   finite.
    /// - cost: two passes over the triangles.
    /// - threads: any.
    /// - source: sf_mesh_measure().
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_body(mesh: sf_mesh_view, density: f64, body: *mut sf_body) -> sf_status;

    /// Body of the solid voxels of a grid, each as a box of its layer's height.
    ///
    /// - `grid`: the voxels
    /// - `density`: NULL for 1 everywhere, or what 1 mm3 weighs in each voxel, solid or not, in
    ///   (layer, y, x) order: nx \* ny \* nz numbers. What is not solid is not looked at
    /// - `task`: NULL, or progress and cancel, which is heeded at every slice
    /// - `body`: receives the body, in the lattice's frame
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, the density of a solid voxel that is not
    ///   finite; SF_ERR_CANCELLED.
    /// - cost: one pass over the grid; with densities, one over the solid voxels too.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_body(
        grid: *const sf_grid,
        density: *const f32,
        task: *mut sf_task,
        body: *mut sf_body,
    ) -> sf_status;

    /// a + factor \* b: with 1 both together, with -1 the one less the other.
    ///
    /// - `a`: a body
    /// - `factor`: how often b is added
    /// - `b`: a body
    /// - returns: the sum.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_body_add(a: sf_body, factor: f64, b: sf_body) -> sf_body;

    /// Body of masses in points, summed in their order.
    ///
    /// - `ballast`: the masses; may be NULL where count is 0
    /// - `count`: how many
    /// - returns: the body.
    /// - cost: linear.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_ballast_body(ballast: *const sf_ballast, count: usize) -> sf_body;

    /// Centre of mass of a body.
    ///
    /// - `body`: the body
    /// - `com_mm`: receives x, y, z
    /// - returns: SF_OK; SF_ERR_ARGUMENT: `com_mm` is NULL, a body without mass, or with less than
    ///   none.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_body_com(body: sf_body, com_mm: *mut f64) -> sf_status;

    /// Gradient of the mass and the first moments of a closed mesh by its vertices.
    ///
    /// - `mesh`: closed and oriented, else the figures depend on where the mesh lies
    /// - `density`: what 1 mm3 weighs; finite
    /// - `gradient`: receives 12 numbers for each vertex: the derivatives of the mass by the
    ///   vertex's x, y, z, then those of the moments along x, y and z; not the mesh's own arrays
    /// - returns: SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer, a mesh
    ///   without triangles, a density that is not finite.
    /// - cost: one pass over the triangles, after one over the vertices.
    /// - threads: any that write distinct arrays.
    /// - source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing
    ///   Shapes for 3D Fabrication", SIGGRAPH 2013, appendix, with diag(v_i + v_j + v_k + v_p) for
    ///   the derivative of g.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_body_gradient(mesh: sf_mesh_view, density: f64, gradient: *mut f64) -> sf_status;

    /// Gradient of a centre of mass: (d moment - com d mass) / mass.
    ///
    /// - `body`: the body as it is, all parts together
    /// - `gradient`: 12 numbers for each of `count` points, as sf_mesh_body_gradient() gives them
    /// - `count`: number of points
    /// - `com_gradient`: receives 9 numbers for each: the derivatives of the centre's x by the
    ///   point's x, y, z, then those of its y and of its z; not `gradient`
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer where count is not 0, a body without mass.
    /// - cost: linear.
    /// - threads: any that write distinct arrays.
    /// - source: the same; (d m / d v) c is an outer product.
    /// - since: 0.1
    #[must_use]
    pub fn sf_body_com_gradient(
        body: sf_body,
        gradient: *const f64,
        count: usize,
        com_gradient: *mut f64,
    ) -> sf_status;

    /// A base that is held: a locked handle of a region, its centre the centre of the region's
    /// voxels.
    ///
    /// - `region`: the voxels; must outlive the use of the handle
    /// - `handle`: receives the handle
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a region without voxels.
    /// - cost: one pass over the grid.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_handle_base(region: *const sf_grid, handle: *mut sf_handle) -> sf_status;

    /// The foot of a solid: its voxels that lie lowest, seen against a direction.
    ///
    /// - `solid`: the voxels
    /// - `up`: the direction that points up, of any length from 1e-100 to 1e100; +z is not special
    /// - `height_mm`: how far above the lowest centre of a voxel the centres of the foot may lie;
    ///   at least 0
    /// - `allocator`: for the new grid; NULL for the C library's
    /// - `foot`: receives a grid on the solid's lattice
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a direction without length or not finite,
    ///   a height that is no number or below 0, a solid without voxels; SF_ERR_MEMORY.
    /// - cost: two passes over the solid voxels.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_foot(
        solid: *const sf_grid,
        up: *const f64,
        height_mm: f64,
        allocator: *const sf_allocator,
        foot: *mut *mut sf_grid,
    ) -> sf_status;

    /// A solid together with the voxels that a surface touches: a domain that holds all of the
    /// surface.
    ///
    /// What of the surface leaves the lattice is not covered.
    ///
    /// - `solid`: the voxels
    /// - `surface`: the triangles that bound them, in the lattice's frame
    /// - `allocator`: for the new grid and for scratch; NULL for the C library's
    /// - `task`: NULL, or progress, cancel and threads
    /// - `covered`: receives a grid on the solid's lattice
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; what sf_grid_voxelize() says;
    ///   SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: as sf_grid_voxelize() with SF_FILL_SURFACE.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_cover(
        solid: *const sf_grid,
        surface: sf_mesh_view,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        covered: *mut *mut sf_grid,
    ) -> sf_status;

    /// The middle of the solid behind a point, as one who points at a surface means it.
    ///
    /// The ray runs from the point, which may lie anywhere within 1e12 mm, and ends where it first
    /// leaves the solid voxels that it has entered. The middle of that stretch is the place of the
    /// handle.
    ///
    /// - `solid`: the voxels
    /// - `from_mm`: where the ray begins: on the surface, before it, or in the solid
    /// - `direction`: where it runs, of any length but 0
    /// - `center_mm`: receives the middle; may be `from_mm`
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a point beyond 1e12 mm, a direction that
    ///   is not finite or without length; SF_ERR_INFEASIBLE: the ray meets no solid voxel.
    /// - cost: the voxels that the ray passes.
    /// - threads: any.
    /// - source: the paper's section 5; J. Amanatides, A. Woo, "A Fast Voxel Traversal Algorithm
    ///   for Ray Tracing", Eurographics 1987.
    /// - since: 0.1
    #[must_use]
    pub fn sf_handle_center(
        solid: *const sf_grid,
        from_mm: *const f64,
        direction: *const f64,
        center_mm: *mut f64,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// The middle of the solid behind a point, by rays instead of voxels: sf_handle_center() of a
    /// surface.
    ///
    /// Where the surface goes through itself, the ray leaves the solid when it has left as often as
    /// it entered. A ray that leaves first begins inside.
    ///
    /// - `caster`: who finds hits
    /// - `from_mm`: where the ray begins
    /// - `direction`: where it runs, of any length but 0
    /// - `center_mm`: receives the middle; may be `from_mm`
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a point or direction that is not finite,
    ///   a direction without length; SF_ERR_INFEASIBLE: the ray does not enter and leave the
    ///   surface, or meets it more than 100,000 times; SF_ERR_INTERNAL: a caster that goes
    ///   backwards; or what the caster returned.
    /// - cost: one call of the caster for each hit.
    /// - threads: as the caster.
    /// - source: as sf_handle_center().
    /// - since: 0.1
    #[must_use]
    pub fn sf_handle_center_by_rays(
        caster: sf_ray_caster,
        from_mm: *const f64,
        direction: *const f64,
        center_mm: *mut f64,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Options of a placement, each at its default.
    ///
    /// - returns: the options, by value: five points, no base.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_place_options_default() -> sf_place_options;

    /// Place handles by themselves: deep in the solid, far from the base and from each other.
    ///
    /// Places are cells that lie at least as deep as their neighbours; when these are used up,
    /// cells at least half as deep as the deepest. Without a base the first handle takes the
    /// deepest of all. Each of the others takes the place that is furthest from what is taken, on
    /// the way through the solid, with the depth of the place added. No two handles lie within
    /// three cells of each other or of the base. The result is the same everywhere.
    ///
    /// - `solid`: the voxels; their boxes bound the solid
    /// - `options`: NULL for the default
    /// - `allocator`: for scratch, some 40 bytes a cell and 4 for each cell of the box around them;
    ///   NULL for the C library's
    /// - `task`: NULL, or progress and cancel
    /// - `handles`: receives them, in the order in which they were placed, none locked
    /// - `capacity`: places in `handles`, at least the number wanted
    /// - `count`: receives how many were placed: fewer than wanted where there is no room
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options out of range or without their
    ///   struct_size, a solid without voxels; SF_ERR_SHAPE: a base on another lattice;
    ///   SF_ERR_CAPACITY: too few places, with the number wanted in `count`; SF_ERR_INFEASIBLE: no
    ///   place for even one; SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: n log n of the cells for each handle.
    /// - threads: any; one at a time for each allocator.
    /// - source: T. F. Gonzalez, "Clustering to Minimize the Maximum Intercluster Distance", 1985.
    /// - since: 0.1
    #[must_use]
    pub fn sf_handles_place(
        solid: *const sf_grid,
        options: *const sf_place_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        handles: *mut sf_handle,
        capacity: usize,
        count: *mut usize,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// The pose that changes nothing.
    ///
    /// - returns: the pose, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_pose_identity() -> sf_pose;

    /// Change a pose: scale and shift are added, the spin turns after what is there.
    ///
    /// - `pose`: the pose, changed in place
    /// - `change`: the change; its spin shorter than 3 radians
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a number that is not finite, a spin of 3
    ///   radians or more.
    /// - cost: constant.
    /// - threads: one per pose.
    /// - source: O. Rodrigues, 1840: the axis scaled by the tangent of half the angle.
    /// - since: 0.1
    #[must_use]
    pub fn sf_pose_move(pose: *mut sf_pose, change: *const sf_pose_change) -> sf_status;

    /// Options of weights, each at its default.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_weights_options_default() -> sf_weights_options;

    /// Find the weights of a solid for its handles.
    ///
    /// Cells are blocks of voxels that hold a solid one; along each axis as many voxels as make
    /// them nearly cubes. On their corners lives the Laplacian of seven points, made of finite
    /// volumes, with no flow through the surface of the cells. CLAMPED weights have the least
    /// integral of the squared Laplacian among all with 1 at their handle and 0 at the others; then
    /// they are cut off at 0 and 1, and divided by their sum. BOUNDED weights have the least among
    /// those that lie within 0 and 1, each handle for itself, and are then divided by their sum.
    /// Either way they lie in \[0, 1\], sum to 1 up to rounding, and are exactly 1 on their
    /// handle's corners and 0 on those of others.
    ///
    /// What the solver leaves is given as a residual. CLAMPED: the largest last correction,
    /// estimated from the decay of the residual's norm, at most `tolerance`. BOUNDED: the largest
    /// |w - clamp(w - g / d)| over handles and corners, g the gradient and d its own derivative; at
    /// most `tolerance`.
    ///
    /// A piece of the solid that touches no handle follows the closest point of a piece that does,
    /// as one. Handles may not share corners: they must lie two cells apart.
    ///
    /// Each handle must touch the solid: the centre of a point or a ball lies in a cell, and a base
    /// has solid voxels.
    ///
    /// - `solid`: the voxels; not kept
    /// - `handles`: the handles; not kept
    /// - `count`: how many, 1..SF_HANDLE_MAX
    /// - `options`: NULL for the default
    /// - `allocator`: for the weights and for scratch: 8 bytes for each cell of the box around all,
    ///   and per corner 180, 8 a handle, and 310 for each four handles, 460 BOUNDED, but for no
    ///   more than 16 handles at once; where pieces touch no handle 24 bytes for each cell of the
    ///   box; NULL for the C library's
    /// - `task`: NULL, or progress, cancel, and threads, on which groups of four handles run
    /// - `weights`: receives the weights
    /// - `fault`: NULL, or receives a sentence on failure that names the handle
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a solid without voxels, a number of
    ///   handles or options out of range, a handle of no kind, one that is not finite, a ball
    ///   without radius, a base without region or with one without voxels; SF_ERR_SHAPE: a region
    ///   of other counts than the solid's; SF_ERR_INFEASIBLE: a handle outside the solid, two
    ///   handles that touch; SF_ERR_OVERFLOW: more than 2^31 corners; SF_ERR_MEMORY;
    ///   SF_ERR_CANCELLED; SF_ERR_INTERNAL: the solver stood still.
    /// - cost: some 30 steps for each four handles, each a few passes over the corners: about 0.15
    ///   s for six handles and 20 000 cells on one core. BOUNDED: about twenty times as much.
    /// - threads: any; one at a time for each allocator.
    /// - source: A. Jacobson, I. Baran, J. Popovic, O. Sorkine, "Bounded Biharmonic Weights for
    ///   Real-Time Deformation", SIGGRAPH 2011.
    /// - since: 0.1
    #[must_use]
    pub fn sf_weights_create(
        solid: *const sf_grid,
        handles: *const sf_handle,
        count: usize,
        options: *const sf_weights_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        weights: *mut *mut sf_weights,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Free weights.
    ///
    /// - `weights`: the weights, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with these weights.
    /// - since: 0.1
    pub fn sf_weights_destroy(weights: *mut sf_weights);

    /// What weights were made of.
    ///
    /// - `weights`: the weights; NULL gives facts of zeros
    /// - returns: the facts, by value; all zero for NULL.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_weights_describe(weights: *const sf_weights) -> sf_weights_facts;

    /// The centres of all handles: x, y, z of each, in mm, as they were handed in.
    ///
    /// - `weights`: the weights; NULL has none
    /// - returns: an array that lives as long as the weights; NULL for NULL.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_weights_centers(weights: *const sf_weights) -> *const f64;

    /// Weights at a point, and how they change there.
    ///
    /// Between corners values are interpolated along each axis in turn, so that they are continuous
    /// and their gradient jumps from cell to cell; on a face between two cells the gradient is that
    /// of the upper one, if there is one. Outside the domain a point has the values of the closest
    /// point in it, and the gradient there without the axes along which it lies outside that
    /// point's cell; more than two cells away, of a point that is about as close.
    ///
    /// - `weights`: the weights
    /// - `p_mm`: x, y, z; finite
    /// - `w`: receives a weight for each handle
    /// - `gradient`: NULL, or receives x, y, z for each handle, per mm
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a coordinate that is not finite.
    /// - cost: constant; a few times as much outside the domain.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_weights_at(
        weights: *const sf_weights,
        p_mm: *const f64,
        w: *mut f64,
        gradient: *mut f64,
    ) -> sf_status;

    /// Weights at many points.
    ///
    /// - `weights`: the weights
    /// - `xyz_mm`: x, y, z of each point
    /// - `count`: how many
    /// - `task`: NULL, or the host's threads; a cancel is heeded before the first write
    /// - `w`: receives a weight for each handle, point after point; not `xyz_mm`
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer where count is not 0, a coordinate that is
    ///   not finite; SF_ERR_CANCELLED.
    /// - cost: two passes over the points; about 0.1 us each for six handles.
    /// - threads: any that write to distinct arrays.
    /// - since: 0.1
    #[must_use]
    pub fn sf_weights_sample(
        weights: *const sf_weights,
        xyz_mm: *const f64,
        count: usize,
        task: *mut sf_task,
        w: *mut f64,
    ) -> sf_status;

    /// Bend points: v = sum of w_j (s_j R_j (p - c_j) + c_j + t_j).
    ///
    /// - `blend`: the points and their weights; numbers that are not finite give such
    /// - `poses`: one for each handle
    /// - `task`: NULL, or the host's threads; a cancel is heeded before the first write
    /// - `xyz_mm`: receives x, y, z of each point; may be `rest_mm`, and nothing else of the blend
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no or too many handles, a pose that is
    ///   not finite; SF_ERR_CANCELLED.
    /// - cost: one pass; 86 000 points and six handles take about 1 ms on one core.
    /// - threads: any that write to distinct arrays.
    /// - source: the paper's equation 9.
    /// - since: 0.1
    #[must_use]
    pub fn sf_blend_apply(
        blend: sf_blend,
        poses: *const sf_pose,
        task: *mut sf_task,
        xyz_mm: *mut f64,
    ) -> sf_status;

    /// How points move when poses change: the matrix M of the paper's equation 10 times a vector.
    ///
    /// The move is w_j (ds_j R_j (p - c_j) + dt_j + s_j spin_j x R_j (p - c_j)), summed over
    /// handles: exact for scales and shifts, in which a blend is linear, and the derivative for
    /// spins.
    ///
    /// - `blend`: the points and their weights
    /// - `poses`: one for each handle
    /// - `changes`: one for each handle
    /// - `task`: NULL, or the host's threads; a cancel is heeded before the first write
    /// - `moves`: receives x, y, z for each point, in mm; may be `rest_mm`
    /// - returns: as sf_blend_apply().
    /// - cost: as sf_blend_apply().
    /// - threads: any that write to distinct arrays.
    /// - since: 0.1
    #[must_use]
    pub fn sf_blend_push(
        blend: sf_blend,
        poses: *const sf_pose,
        changes: *const sf_pose_change,
        task: *mut sf_task,
        moves: *mut f64,
    ) -> sf_status;

    /// How a function of the points changes when poses change: the transpose of M times a gradient.
    ///
    /// - `blend`: the points and their weights
    /// - `poses`: one for each handle
    /// - `gradient`: the function's derivatives by x, y, z of each point
    /// - `allocator`: for scratch: 96 bytes for each handle and 4096 points; NULL for the C
    ///   library's
    /// - `task`: NULL, or the host's threads and cancel; the result is the same bytes with any
    /// - `changes`: receives the derivatives by scale, shift and spin of each handle
    /// - returns: SF_OK; SF_ERR_ARGUMENT: as sf_blend_apply(); SF_ERR_OVERFLOW; SF_ERR_MEMORY;
    ///   SF_ERR_CANCELLED.
    /// - cost: one pass.
    /// - threads: any that write to distinct arrays; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_blend_pull(
        blend: sf_blend,
        poses: *const sf_pose,
        gradient: *const f64,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        changes: *mut sf_pose_change,
    ) -> sf_status;

    /// Where points lie before bending: the inverse of a blend.
    ///
    /// Newton's method with the gradients of the weights, each point from the guess handed in or
    /// from what the point before it leads to, whichever is closer; so points should come row by
    /// row. What fails, or leads out of the domain, is tried from the cells that are bent to where
    /// it lies. A rest point in the domain is worth more than one outside; where the bent solid
    /// folds over itself more than one is right, and one of them is found.
    ///
    /// A point outside the bent solid may have a rest point outside the domain, where the weights
    /// reach on as sf_weights_at() says, or none.
    ///
    /// - `weights`: the weights
    /// - `poses`: one for each handle
    /// - `bent_mm`: x, y, z of each bent point; finite
    /// - `count`: how many
    /// - `tolerance_mm`: how near to its bent point the blend of a rest point must come, \> 0
    /// - `allocator`: for scratch: 24 bytes a corner, 56 a cell and 450 kB, and without residual_mm
    ///   8 a point; NULL for the C library's
    /// - `task`: NULL, or the host's threads and cancel; the result is the same bytes with any
    /// - `rest_mm`: holds a guess for each point: the bent point itself, or what was found for a
    ///   pose close to this one; receives the rest points; not `bent_mm`
    /// - `residual_mm`: NULL, or receives how far the blend of each rest point is from the bent
    ///   one: at most tolerance_mm where it was found
    /// - `missed`: NULL, or receives how many were not found
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a coordinate, guess or pose that is not
    ///   finite, a tolerance out of range; SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: some three evaluations a point: about 1 us each for six handles, and half of that
    ///   where guesses are good.
    /// - threads: any that write to distinct arrays; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_weights_unbend(
        weights: *const sf_weights,
        poses: *const sf_pose,
        bent_mm: *const f64,
        count: usize,
        tolerance_mm: f64,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        rest_mm: *mut f64,
        residual_mm: *mut f64,
        missed: *mut usize,
    ) -> sf_status;

    /// Whether a blend folds the solid over itself: its derivative in the eight corners of each
    /// cell.
    ///
    /// A cell's own gradients are used, so that each corner is looked at once for every cell around
    /// it.
    ///
    /// - `weights`: the weights
    /// - `poses`: one for each handle
    /// - `task`: NULL, or progress, cancel and threads; the result is the same with any
    /// - `fold`: receives what was found; of equal determinants the first cell's
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a pose that is not finite;
    ///   SF_ERR_CANCELLED.
    /// - cost: one pass over the cells, some 2 us each for six handles.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_weights_fold(
        weights: *const sf_weights,
        poses: *const sf_pose,
        task: *mut sf_task,
        fold: *mut sf_fold,
    ) -> sf_status;

    /// Mass density in kg/m3, 0 and more.
    ///
    /// - returns: the property, by value; its UUID, 408b9c0d-608a-45f0-9af1-ffeeda90d9ea, never
    ///   changes.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_property_density() -> sf_property;

    /// Young's modulus in Pa, 0 and more.
    ///
    /// - returns: the property, by value; its UUID, 2b3d5e79-5dc1-4ea8-8d04-c48865cea0c1, never
    ///   changes.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_property_young() -> sf_property;

    /// Poisson's ratio, a bare number from -1 to 0.5.
    ///
    /// - returns: the property, by value; its UUID, db254ec6-a58b-45d9-97b5-809fe7e620b2, never
    ///   changes.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_property_poisson() -> sf_property;

    /// A property of which no more than the name is known: a bare number without bounds.
    ///
    /// Its UUID is made of the name, and the same wherever that is: the first 16 bytes of SHA-256
    /// of "libsf property " and the name, marked as version 8 of RFC 9562. Cages of files without
    /// UUIDs have such properties. Whoever publishes a property draws a UUID of its own at random
    /// instead.
    ///
    /// - `name`: 1 to 47 bytes of UTF-8, ended by a 0
    /// - `property`: receives the property
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a name that is empty or too long.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_property_named(name: *const c_char, property: *mut sf_property) -> sf_status;

    /// Make a cage of somebody's arrays, which are copied.
    ///
    /// Refused is what has no limit: a cell with a point twice, a face of three cells, a boundary
    /// that meets itself in an edge or in a point only, cells that lie on the same side of a face
    /// they share. Whether cells are inverted is another question: sf_cage_check().
    ///
    /// - `view`: the arrays
    /// - `allocator`: for the cage and for scratch; NULL for the C library's
    /// - `cage`: receives the cage
    /// - `fault`: NULL, or receives a sentence that names the first cell, point, crease or property
    ///   at fault
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a dimension other than 2 or 3, no points
    ///   or cells, an index out of range, a coordinate that is not finite or beyond 10^12 mm, a
    ///   value outside its property's bounds, a name or UUID that is empty or there twice, a crease
    ///   that is no edge, cells that disagree as above; SF_ERR_UNSUPPORTED: a cell of a number of
    ///   corners that no served cell has, a boundary that meets itself, a crease or sharp point
    ///   inside of the solid; SF_ERR_OVERFLOW: more points or corners than SF_CAGE_POINT_MAX;
    ///   SF_ERR_MEMORY.
    /// - cost: linear, but for collisions in a hash table.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_create(
        view: *const sf_cage_view,
        allocator: *const sf_allocator,
        cage: *mut *mut sf_cage,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Free a cage.
    ///
    /// - `cage`: the cage, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this cage.
    /// - since: 0.1
    pub fn sf_cage_destroy(cage: *mut sf_cage);

    /// View of a cage.
    ///
    /// - `cage`: the cage; NULL gives a view of nothing
    /// - returns: the view, valid until properties are added or removed, or the cage is destroyed;
    ///   its values are those of the cage as it changes. NULL gives a view of nothing.
    /// - cost: constant.
    /// - threads: any, while nobody changes the cage.
    /// - since: 0.1
    pub fn sf_cage_get_view(cage: *const sf_cage) -> sf_cage_view;

    /// Move points.
    ///
    /// - `cage`: the cage
    /// - `first`: the first point
    /// - `count`: how many; may be 0
    /// - `xyz`: 3 \* count coordinates, mm; not in the cage's own arrays
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, points that there are not, a coordinate
    ///   that is not finite.
    /// - cost: O(count).
    /// - threads: one for each cage.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_set_positions(
        cage: *mut sf_cage,
        first: usize,
        count: usize,
        xyz: *const f64,
    ) -> sf_status;

    /// Change values of a property.
    ///
    /// - `cage`: the cage
    /// - `channel`: which property, below channel_count
    /// - `first`: the first value
    /// - `count`: how many; may be 0
    /// - `values`: the values; not in the cage's own arrays
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, values that there are not, one that is
    ///   not finite or lies outside the property's bounds.
    /// - cost: O(count).
    /// - threads: one for each cage.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_set_values(
        cage: *mut sf_cage,
        channel: usize,
        first: usize,
        count: usize,
        values: *const f64,
    ) -> sf_status;

    /// Add a property, as the last channel.
    ///
    /// - `cage`: the cage; on failure it is as it was
    /// - `channel`: what it is, and its values; they are copied
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: as sf_cage_create(), more than SF_PROPERTY_MAX;
    ///   SF_ERR_OVERFLOW; SF_ERR_MEMORY.
    /// - cost: O(values and corners).
    /// - threads: one for each cage.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_add_property(
        cage: *mut sf_cage,
        channel: *const sf_channel,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Remove a property; those after it move up.
    ///
    /// - `cage`: the cage
    /// - `channel`: number of the property, counted from 0
    /// - returns: SF_OK; SF_ERR_ARGUMENT: NULL, or there is no such channel.
    /// - cost: constant.
    /// - threads: one for each cage.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_remove_property(cage: *mut sf_cage, channel: usize) -> sf_status;

    /// Look at a cage: how it hangs together, and whether its cells are the right way out.
    ///
    /// - `cage`: the cage
    /// - `allocator`: for scratch; NULL for the C library's
    /// - `report`: receives what was found
    /// - `fault`: NULL, or receives a sentence that names the first inverted cell, where there is
    ///   one
    /// - returns: SF_OK, also where cells are inverted; SF_ERR_ARGUMENT: NULL; SF_ERR_OVERFLOW;
    ///   SF_ERR_MEMORY.
    /// - cost: linear.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_check(
        cage: *const sf_cage,
        allocator: *const sf_allocator,
        report: *mut sf_cage_report,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// A block of hexahedra.
    ///
    /// Point (i, j, k) is number i + (nx + 1) (j + (ny + 1) k), cell (i, j, k) number i + nx (j +
    /// ny k).
    ///
    /// - `counts`: cells along x, y and z, at least 1
    /// - `low_mm`: its lower corner
    /// - `high_mm`: its upper corner, above the lower one along each axis
    /// - `allocator`: NULL for the C library's
    /// - `cage`: receives the cage
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a count of 0, corners that are no box or
    ///   beyond 10^12 mm; SF_ERR_OVERFLOW: more than SF_CAGE_POINT_MAX points or corners;
    ///   SF_ERR_MEMORY.
    /// - cost: linear.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_block(
        counts: *const u32,
        low_mm: *const f64,
        high_mm: *const f64,
        allocator: *const sf_allocator,
        cage: *mut *mut sf_cage,
    ) -> sf_status;

    /// Draw faces along a line: prisms, of quadrilaterals hexahedra.
    ///
    /// The points of layer k are those of the faces, in their order, k / layers of the way; the
    /// cells of a layer follow each other in the order of the faces.
    ///
    /// - `faces`: a cage of dimension 2
    /// - `vector_mm`: how far, across the faces
    /// - `layers`: how many cells that is, at least 1
    /// - `allocator`: NULL for the C library's
    /// - `cage`: receives the cage
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no layers, a vector that is not finite or
    ///   leads farther than 2 10^12 mm, a face within 10^-9 of along it, faces that look to both
    ///   sides of it; SF_ERR_UNSUPPORTED: a cage of dimension 3, or what sf_cage_create() refuses;
    ///   SF_ERR_OVERFLOW; SF_ERR_MEMORY.
    /// - cost: linear.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_extrude(
        faces: *const sf_cage,
        vector_mm: *const f64,
        layers: u32,
        allocator: *const sf_allocator,
        cage: *mut *mut sf_cage,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Turn faces about the z axis.
    ///
    /// The faces lie in the half-plane of x at least 0 and y = 0; y is not looked at. An edge on
    /// the axis stays one: a quadrilateral there becomes a wedge, a triangle a tetrahedron. On the
    /// axis are points whose x is 0 and no other number: round what was measured or read.
    ///
    /// - `faces`: a cage of dimension 2
    /// - `sectors`: how many cells around, at least 3 for a full turn, else at least 1
    /// - `angle_rad`: how far, above 0 and at most a full turn; only the double nearest to 2 pi
    ///   closes; for parts less than pi for each sector
    /// - `allocator`: NULL for the C library's
    /// - `cage`: receives the cage
    /// - `fault`: NULL, or receives a sentence on failure, which names the face at fault
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, sectors or an angle out of range, a point
    ///   with x below 0; SF_ERR_UNSUPPORTED: a cage of dimension 3, a face that touches the axis in
    ///   a point only or that becomes no served cell, or what sf_cage_create() refuses;
    ///   SF_ERR_OVERFLOW; SF_ERR_MEMORY.
    /// - cost: linear.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_revolve(
        faces: *const sf_cage,
        sectors: u32,
        angle_rad: f64,
        allocator: *const sf_allocator,
        cage: *mut *mut sf_cage,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// A body along a skeleton: cubes at the nodes, and struts between them, all hexahedra.
    ///
    /// A strut leaves a node through the side that its direction is nearest to, and no two struts
    /// through the same side. It is not twisted more than it must be. Whether cubes or struts run
    /// into each other is not looked at.
    ///
    /// - `node_count`: 1 or more
    /// - `nodes`: the nodes; their cubes are the first cells, in their order
    /// - `strut_count`: may be 0
    /// - `struts`: the struts; their cells follow
    /// - `allocator`: NULL for the C library's
    /// - `cage`: receives the cage
    /// - `fault`: NULL, or receives a sentence on failure, which names the node or strut at fault
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no nodes, a number out of range, a strut
    ///   from a node to itself; SF_ERR_UNSUPPORTED: two struts through one side of a node, a strut
    ///   shorter than its nodes' cubes are wide, or what sf_cage_create() refuses; SF_ERR_OVERFLOW;
    ///   SF_ERR_MEMORY.
    /// - cost: linear.
    /// - threads: any; one at a time for each allocator.
    /// - source: C. Altenhofen and others, "Continuous property gradation for multi-material
    ///   3D-printed objects", 2018, on sketched control meshes.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_skeleton(
        node_count: usize,
        nodes: *const sf_skeleton_node,
        strut_count: usize,
        struts: *const sf_skeleton_strut,
        allocator: *const sf_allocator,
        cage: *mut *mut sf_cage,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Move all points by a function of their places.
    ///
    /// - `cage`: the cage; on failure it is as it was
    /// - `function`: called for each point in its order
    /// - `user`: handed to it
    /// - `allocator`: for scratch; NULL for the C library's
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a place beyond 10^12 mm or not finite;
    ///   SF_ERR_MEMORY; SF_ERR_CANCELLED: the function gave up.
    /// - cost: O(points).
    /// - threads: one for each cage.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_map_positions(
        cage: *mut sf_cage,
        function: sf_cage_place_function,
        user: *mut c_void,
        allocator: *const sf_allocator,
    ) -> sf_status;

    /// Set all values of a property by a function of the places of their points.
    ///
    /// - `cage`: the cage; on failure it is as it was
    /// - `channel`: which property; a value that several corners name gets that of the last one's
    ///   place
    /// - `function`: called for each point in its order, or for each corner
    /// - `user`: handed to it
    /// - `allocator`: for scratch; NULL for the C library's
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such property, a value that it does
    ///   not allow; SF_ERR_MEMORY; SF_ERR_CANCELLED: the function gave up.
    /// - cost: O(points and corners).
    /// - threads: one for each cage.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_map_values(
        cage: *mut sf_cage,
        channel: usize,
        function: sf_cage_value_function,
        user: *mut c_void,
        allocator: *const sf_allocator,
    ) -> sf_status;

    /// A history without steps, of a cage as it is now.
    ///
    /// - `cage`: the cage; the history copies its positions and values and does not keep it
    /// - `bytes_max`: most bytes of all steps together, besides that copy: 8 for each number that a
    ///   step changes, and up to 24 more where it stands alone
    /// - `allocator`: for the history; NULL for the C library's
    /// - `history`: receives the history
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_MEMORY.
    /// - cost: O(points and values).
    /// - threads: any, while nobody changes the cage.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_history_create(
        cage: *const sf_cage,
        bytes_max: usize,
        allocator: *const sf_allocator,
        history: *mut *mut sf_cage_history,
    ) -> sf_status;

    /// Free a history.
    ///
    /// The cage stays as it is.
    ///
    /// - `history`: the history, freed; NULL does nothing
    /// - cost: O(steps).
    /// - threads: one, and nobody else with this history.
    /// - since: 0.1
    pub fn sf_cage_history_destroy(history: *mut sf_cage_history);

    /// Keep what has changed since the last call as one step; nothing, if nothing has.
    ///
    /// Steps that could be redone are forgotten then. A step that takes more than all the bytes
    /// there are empties the history: it cannot be undone, nor what was before it. Properties that
    /// were added at the cage's end are watched from now on; that they were added is no step.
    ///
    /// - `history`: the history; on failure it is as it was
    /// - `cage`: its cage
    /// - `changed`: NULL, or receives how many numbers are not what they were
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_SHAPE: not its cage, or one that a
    ///   property was removed from; SF_ERR_MEMORY.
    /// - cost: O(points and values).
    /// - threads: one for each history, while nobody changes the cage.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_history_record(
        history: *mut sf_cage_history,
        cage: *const sf_cage,
        changed: *mut usize,
    ) -> sf_status;

    /// Undo the last step; where something has changed that was not recorded, record it first and
    /// undo that.
    ///
    /// - `history`: the history; on failure it is as it was
    /// - `cage`: its cage; on failure it is as it was
    /// - `changed`: NULL, or receives how many numbers are not what they were; 0: there was no step
    /// - returns: as sf_cage_history_record().
    /// - cost: O(points and values).
    /// - threads: one for each history and cage.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_history_undo(
        history: *mut sf_cage_history,
        cage: *mut sf_cage,
        changed: *mut usize,
    ) -> sf_status;

    /// Redo the step that was undone last; where something has changed since, record that instead,
    /// after which there is nothing to redo.
    ///
    /// - `history`: the history; on failure it is as it was
    /// - `cage`: its cage; on failure it is as it was
    /// - `changed`: NULL, or receives how many numbers are not what they were; 0: there was no step
    /// - returns: as sf_cage_history_record().
    /// - cost: O(points and values).
    /// - threads: one for each history and cage.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_history_redo(
        history: *mut sf_cage_history,
        cage: *mut sf_cage,
        changed: *mut usize,
    ) -> sf_status;

    /// What a history holds.
    ///
    /// - `history`: the history; of NULL nothing
    /// - returns: the counts, by value.
    /// - cost: constant.
    /// - threads: any, while nobody changes the history.
    /// - since: 0.1
    pub fn sf_cage_history_get_state(history: *const sf_cage_history) -> sf_cage_history_state;

    /// The default options: any format, 8 GiB, SF_CAGE_POINT_MAX points and corners.
    ///
    /// - returns: the options, by value, with struct_size set.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_cage_read_options_default() -> sf_cage_read_options;

    /// Read a cage from any source of bytes.
    ///
    /// Coordinates are taken as they are, as mm. Where a file has cells, its faces are passed over;
    /// where it has none, its faces are the cage, of dimension 2. A cell that is inverted at every
    /// one of its corners, as the wedges of one half of all programs are, is turned: its lower
    /// polygon becomes the upper one. Cells that are inverted in part are left to sf_cage_check();
    /// faces are never turned. A cell is numbered, in sentences too, among the cells that the cage
    /// has, from 0.
    ///
    /// - Medit: Vertices, Tetrahedra, Prisms (or Wedges, or Pentahedra), Hexahedra, Triangles and
    ///   Quadrilaterals; Corners become sharp points, the Edges that Ridges names become creases,
    ///   both sharp for ever. Where the references of cells are not all the same, they become the
    ///   property "reference", one value for each cell. Other sections of the format are passed
    ///   over.
    /// - MFEM: elements, vertices or nodes. Of nodes, the points are taken: what is curved between
    ///   them is not kept. Attributes become the property "attribute", as references do. Meshes
    ///   with hanging nodes are refused: faces that meet half a face have no common limit.
    /// - VTK: versions 2.0 to 5.1. Tetrahedra, wedges, hexahedra, voxels, prisms over five and six
    ///   corners; triangles, quads, pixels and polygons. Point data and cell data with one
    ///   component are properties under their names; cell data become one value for each cell. Data
    ///   of several components are passed over. What sf_cage_write_vtk() has written comes back as
    ///   it was.
    ///
    /// A property of a foreign file has no unit, no bounds, and a UUID that is made of its name
    /// (version 8 of RFC 9562: the first 128 bits of the SHA-256 of "libsf property " and the
    /// name).
    ///
    /// No count in a file is believed: memory grows as the bytes come. Refused are pyramids,
    /// elements with curved edges of their own, a cell whose type disagrees with its number of
    /// corners, corners that name no point, numbers that are not finite, files that are cut short,
    /// and what sf_cage_create() refuses; where hanging nodes are the reason for that, the sentence
    /// names one. To stop early, let the source return SF_ERR_CANCELLED.
    ///
    /// - `source`: the file, read to where the cage ends, or somewhat beyond
    /// - `options`: NULL for sf_cage_read_options_default()
    /// - `allocator`: for the cage and for reading; NULL for the C library's
    /// - `cage`: where the new cage is left, to be destroyed by the caller; untouched on failure
    /// - `reading`: NULL, or what was found; untouched on failure
    /// - `fault`: NULL, or filled on failure: what is wrong, at which line (of text files) and
    ///   byte, and what to do
    /// - returns: SF_OK; SF_ERR_FORMAT: the bytes are no cage; SF_ERR_UNSUPPORTED: a mesh that a
    ///   cage cannot be; SF_ERR_OVERFLOW: more than the options allow; SF_ERR_MEMORY;
    ///   SF_ERR_ARGUMENT: a NULL pointer or an unknown format; or what the source returned.
    /// - cost: one pass over the file; memory for about three times the cage.
    /// - threads: any, on distinct sources; one at a time for each allocator.
    /// - source: P. Frey, "MEDIT: An interactive mesh visualization software", 2001; the MFEM
    ///   project, "MFEM mesh formats"; Kitware, "VTK file formats", legacy.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_read(
        source: sf_source,
        options: *const sf_cage_read_options,
        allocator: *const sf_allocator,
        cage: *mut *mut sf_cage,
        reading: *mut sf_cage_reading,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Write a cage, or a refined one, as a legacy VTK file, version 3.0, that ParaView opens.
    ///
    /// A property is data of points; one that is the same at all corners of each cell, by its
    /// indices, is data of cells. Where a property jumps, a point is written once for each set of
    /// values that its corners have: first all points in their order, then the other copies. Then
    /// the data of points "sf_point" say which point each one is a copy of. What VTK has no place
    /// for are fields of the grid: "sf_creases", rows of two points and a sharpness; "sf_sharps",
    /// rows of a point and a sharpness; "sf_property:NAME", of each property, 27 numbers: the bytes
    /// of its UUID, the exponents of its unit, then 1 and the low bound or 0 and 0, and the same
    /// for the high bound. In names, blanks, % and quotation marks are written as VTK does, % and
    /// two digits.
    ///
    /// sf_cage_read() makes the same cage of it: the same points, cells and sharp things, and at
    /// every corner the same value; corners of a point that have the same value then name the same
    /// one. Numbers read back as the same doubles; a zero with a sign loses it in text. A sharpness
    /// beyond SF_SHARP is written as that.
    ///
    /// - `view`: the cage; what is read of it is checked before the first byte is written
    /// - `binary`: 0: text; else binary
    /// - `allocator`: for scratch; NULL for the C library's
    /// - `sink`: where the bytes go; on failure it may have had some
    /// - `fault`: NULL, or receives a sentence on failure, but for one of memory or of the sink
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a dimension other than 2 or 3, no points
    ///   or cells, an index out of range, a number that is not finite, a property without a name,
    ///   with that of another, or called "sf_point"; SF_ERR_UNSUPPORTED: a cell of a number of
    ///   corners for which VTK has no type, a prism over more than six; SF_ERR_OVERFLOW: more than
    ///   2^31 - 1 points, copies included; SF_ERR_MEMORY; or what the sink returned.
    /// - cost: one pass to check, one to write; where a property jumps, 12 bytes for each point and
    ///   16 for each corner.
    /// - threads: any, on distinct sinks; one at a time for each allocator.
    /// - source: Kitware, "VTK file formats", legacy.
    /// - since: 0.1
    #[must_use]
    pub fn sf_cage_write_vtk(
        view: *const sf_cage_view,
        binary: c_int,
        allocator: *const sf_allocator,
        sink: sf_sink,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Options of a stance, each at its default.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_stance_options_default() -> sf_stance_options;

    /// Make a stance: find what touches the ground, and where the centre of mass may lie.
    ///
    /// Standing. The ground lies below the lowest vertex within the region, perpendicular to `up`,
    /// and what touches it is every vertex within contact_mm above it. The support polygon is their
    /// convex hull, dropped onto the ground. It may be a segment or a point, and then no centre of
    /// mass is safe.
    ///
    /// Hanging. The body swings freely about the point and comes to rest with its centre of mass
    /// straight below.
    ///
    /// Rocking. The body stands on its convex hull (that of the vertices within the region), in the
    /// pose in which `up` points up; let go from a tilt of up to range_rad in any direction, it
    /// must come back to within tolerance_rad. How it rolls is said at sf_mesh_rest(). The pose
    /// asked for need not be a face of the hull.
    ///
    /// The mesh is not kept. Only vertices that triangles use count. It need not be closed.
    ///
    /// - `mesh`: vertices in mm, with triangles; coordinates up to 1e12
    /// - `options`: what is asked for
    /// - `allocator`: for the stance and for scratch, 30 bytes a vertex, or 500 where it rocks;
    ///   NULL for the C library's
    /// - `stance`: receives the stance
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer, options out
    ///   of range or without their struct_size, a mesh without triangles, no vertex within the
    ///   region, a rocking body whose vertices all lie on a line; SF_ERR_OVERFLOW: a coordinate
    ///   beyond 1e12, more than 2^30 vertices of a body that rocks; SF_ERR_MEMORY.
    /// - cost: two passes over the mesh; n log n in the vertices that touch the ground; rocking,
    ///   that of a hull, and the square of the faces and edges within the range, in stretches of
    ///   256.
    /// - threads: any; one at a time for each allocator.
    /// - source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing
    ///   Shapes for 3D Fabrication", 2013, section 3, figure 2 and the rocking toy of table 1.
    /// - since: 0.1
    #[must_use]
    pub fn sf_stance_create(
        mesh: sf_mesh_view,
        options: *const sf_stance_options,
        allocator: *const sf_allocator,
        stance: *mut *mut sf_stance,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Free a stance; NULL does nothing.
    ///
    /// - `stance`: the stance, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this stance.
    /// - since: 0.1
    pub fn sf_stance_destroy(stance: *mut sf_stance);

    /// The options that a stance was made with, `up` with length 1 and every 0 replaced by what it
    /// stands for.
    ///
    /// - `stance`: the stance, not NULL
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_stance_get_options(stance: *const sf_stance) -> sf_stance_options;

    /// Height of the ground: its points p have up . p equal to it.
    ///
    /// Hanging: the height of the point.
    ///
    /// - `stance`: the stance, not NULL
    /// - returns: the height in mm, in the mesh's frame.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_stance_ground(stance: *const sf_stance) -> f64;

    /// The support polygon: corners on the ground, counter-clockwise for an eye that `up` points
    /// to.
    ///
    /// It has 2 corners where all contacts lie on a line, and 1 where they are one point, or where
    /// the body hangs: the point itself.
    ///
    /// - `stance`: the stance
    /// - `xyz`: receives x, y, z of each corner, in mm; may be NULL where capacity is 0
    /// - `capacity`: corners that it has room for
    /// - `count`: receives how many corners there are
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_CAPACITY: too little room, with
    ///   the number of corners in `count`.
    /// - cost: linear.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_stance_polygon(
        stance: *const sf_stance,
        xyz: *mut f64,
        capacity: usize,
        count: *mut usize,
    ) -> sf_status;

    /// The vertices that touch the ground, by rising number; none where the body hangs.
    ///
    /// - `stance`: the stance
    /// - `vertices`: receives their numbers in the mesh; may be NULL where capacity is 0
    /// - `capacity`: numbers that it has room for
    /// - `count`: receives how many there are
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_CAPACITY: too little room, with
    ///   the number of contacts in `count`.
    /// - cost: linear.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_stance_contacts(
        stance: *const sf_stance,
        vertices: *mut u32,
        capacity: usize,
        count: *mut usize,
    ) -> sf_status;

    /// Move every contact straight down onto the ground, in the caller's array of vertices.
    ///
    /// With a contact_mm of, say, a tenth of a millimetre, this makes a foot that is almost flat
    /// flat, and the support polygon is then what really touches.
    ///
    /// - `stance`: the stance
    /// - `vertices`: x, y, z of each vertex of the mesh that the stance was made from, or of a
    ///   deformed one with the same vertices; those of contacts are changed
    /// - `vertex_count`: how many vertices
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_SHAPE: the mesh had another number
    ///   of vertices.
    /// - cost: linear in the contacts.
    /// - threads: any that write to distinct arrays.
    /// - source: R. Prevost and others, "Make It Stand", 2013, section 3: "we flatten faces
    ///   surrounding the support, within a threshold".
    /// - since: 0.1
    #[must_use]
    pub fn sf_stance_flatten(
        stance: *const sf_stance,
        vertices: *mut f64,
        vertex_count: usize,
    ) -> sf_status;

    /// Where the centre of mass may lie: in all of these half-spaces.
    ///
    /// Standing, one for each edge of the support polygon: with its inward direction n, a corner p
    /// and the height h of the centre c above the ground, n . (c - p) \>= h tan(gamma). That is
    /// exact: the body survives a tilt of gamma in every direction if and only if all hold. A
    /// segment has one for either side and either end, a point one for each of four directions;
    /// where the mesh goes on below the ground, outside of the region, one more asks for h \>= 0.
    ///
    /// Hanging, sixteen planes through the point, which make a pyramid inside the cone of the
    /// tolerance (they touch it along the pyramid's edges, and come within 2 % of it between them),
    /// and one that asks for the lever.
    ///
    /// Rocking, as many as it takes (some twenty) so that from every tilt between the tolerance and
    /// the range the body rolls straight towards the pose, on a floor that may lean by a tenth of a
    /// degree. That is sufficient, not necessary: a body may also come back on a detour.
    /// Half-spaces that others imply for all that lies in or near the mesh's box are left out. A
    /// centre of mass straight above what touches the ground in the pose, and low enough, is always
    /// in all of them, but for the height of the facets within the tolerance.
    ///
    /// - `stance`: the stance
    /// - `halfspaces`: receives them, their normals with length 1; may be NULL where capacity is 0
    /// - `capacity`: half-spaces that it has room for
    /// - `count`: receives how many there are
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_CAPACITY: too little room, with
    ///   the number of half-spaces in `count`.
    /// - cost: linear.
    /// - threads: any.
    /// - source: standing: Prevost and others, "Make It Stand", 2013, figure 2, but with the height
    ///   of the centre of mass as it is, where the paper takes it for fixed.
    /// - since: 0.1
    #[must_use]
    pub fn sf_stance_halfspaces(
        stance: *const sf_stance,
        halfspaces: *mut sf_halfspace,
        capacity: usize,
        count: *mut usize,
    ) -> sf_status;

    /// Judge a centre of mass.
    ///
    /// Standing, a centre of mass that is not above the ground never tips while it lies inside of
    /// an edge (a margin of 90 degrees), and has fallen where it lies outside (minus 90 degrees).
    ///
    /// - `stance`: the stance
    /// - `com_mm`: the centre of mass
    /// - `verdict`: receives the verdict
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a centre of mass that is no place within
    ///   1e12 mm; SF_ERR_MEMORY: only of a body that rocks.
    /// - cost: linear in the half-spaces; rocking, seventeen times that of sf_mesh_rest() without
    ///   its hull.
    /// - threads: any; one at a time for each allocator where the body rocks.
    /// - since: 0.1
    #[must_use]
    pub fn sf_stance_judge(
        stance: *const sf_stance,
        com_mm: *const f64,
        verdict: *mut sf_stance_verdict,
    ) -> sf_status;

    /// Where a body comes to rest that is put on level ground in some orientation, and let go.
    ///
    /// It rolls on its convex hull as a body that tips slowly, neither slides nor gains momentum:
    /// it tips about the point of what touches the ground that is nearest to the centre of mass
    /// seen from above, an edge or a corner, until more of it touches; and so on, until the centre
    /// of mass lies over what it touches the ground with. That is the steepest descent of the
    /// height of the centre of mass over all orientations, and ends in a local minimum. A start
    /// that is balanced on an edge or a corner falls to one side, always the same. Corners within a
    /// millionth of the diagonal above the lowest one touch.
    ///
    /// A body that is flat lies down on a side; one without any width comes to rest as it lies.
    ///
    /// - `mesh`: vertices in mm, with triangles; coordinates up to 1e12; only vertices that
    ///   triangles use count, and it need not be closed
    /// - `com_mm`: its centre of mass, in its convex hull (to a millionth of the diagonal)
    /// - `ups`: of each start, the direction of the mesh that points up, of any length from 1e-100
    ///   to 1e100
    /// - `count`: how many starts
    /// - `allocator`: for scratch, 500 bytes a vertex at worst; NULL for the C library's
    /// - `rests`: receives one for each start
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer, a mesh
    ///   without triangles, a centre of mass outside of the hull, a start that is no direction;
    ///   SF_ERR_OVERFLOW: a coordinate beyond 1e12, more than 2^30 vertices; SF_ERR_MEMORY.
    /// - cost: typically n log n for n vertices; for each start and edge or corner it tips over,
    ///   one pass over the corners of the hull.
    /// - threads: any; one at a time for each allocator.
    /// - source: hull: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull Algorithm for
    ///   Convex Hulls", 1996; rolling: M. Goldberg, R. K. Guy, "Stability of Polyhedra (J. H.
    ///   Conway and R. K. Guy)", 1969.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_rest(
        mesh: sf_mesh_view,
        com_mm: *const f64,
        ups: *const f64,
        count: usize,
        allocator: *const sf_allocator,
        rests: *mut sf_rest,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Draw contours into a slice: dst is solid where they have it inside, and empty elsewhere.
    ///
    /// - `dst`: the slice, written; of the lattice's nx and ny
    /// - `lattice`: where voxels lie: nx, ny, pitch and origin are looked at
    /// - `contours`: the polygons, in the frame of the lattice; what stands out is cut off
    /// - `fill`: what is inside
    /// - `allocator`: for 32 bytes a point and 4 a row while it works; NULL for the C library's
    /// - `fault`: NULL, or filled where a point is refused
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a slice that is none, starts that fall, a
    ///   point that is not finite, no such fill; what sf_lattice_validate() says; SF_ERR_SHAPE: a
    ///   slice of another size; SF_ERR_OVERFLOW: a point farther than SF_CONTOUR_REACH_MAX voxels
    ///   from the lattice's corner, 2^32 - 1 points or more; SF_ERR_MEMORY.
    /// - cost: one pass, and n log n in the crossings of each row.
    /// - threads: any that write to distinct slices; one at a time for each allocator.
    /// - source: W. J. Bouknight, "A Procedure for Generation of Three-Dimensional Half-Toned
    ///   Computer Graphics Presentations", 1970 (lists of edges that a row crosses).
    /// - since: 0.1
    #[must_use]
    pub fn sf_slice_from_contours(
        dst: sf_slice,
        lattice: *const sf_lattice,
        contours: *const sf_contours,
        fill: sf_contour_fill,
        allocator: *const sf_allocator,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Signed area of contours: what turns to the left counts, what turns to the right is taken
    /// away.
    ///
    /// For contours that cross nothing and whose holes turn the other way it is the area inside,
    /// under either fill.
    ///
    /// - `contours`: the polygons; NULL has none
    /// - returns: the area in mm2; not a number where starts fall.
    /// - cost: one pass.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_contours_area_mm2(contours: *const sf_contours) -> f64;

    /// Make a stack without layers.
    ///
    /// - `bottom_mm`: height of the lowest layer's underside
    /// - `allocator`: for the stack; NULL for the C library's
    /// - `stack`: receives the stack
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a height that is not finite or beyond
    ///   1e12; SF_ERR_MEMORY.
    /// - cost: constant.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_contour_stack_create(
        bottom_mm: f64,
        allocator: *const sf_allocator,
        stack: *mut *mut sf_contour_stack,
    ) -> sf_status;

    /// Add a layer on top: it reaches from the top of the one below to `top_mm`.
    ///
    /// - `stack`: the stack
    /// - `top_mm`: above the stack's top so far
    /// - `contours`: the polygons, copied
    /// - `fault`: NULL, or filled where something is refused
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a top that does not rise or is beyond
    ///   1e12, starts that fall, a point that is not finite or beyond 1e12; SF_ERR_OVERFLOW: more
    ///   than SF_LAYER_MAX layers, or sizes that do not fit the machine; SF_ERR_MEMORY.
    /// - cost: the points.
    /// - threads: one per stack.
    /// - since: 0.1
    #[must_use]
    pub fn sf_contour_stack_add(
        stack: *mut sf_contour_stack,
        top_mm: f64,
        contours: *const sf_contours,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Trace the border of a slice's voxels and add it as the next layer.
    ///
    /// Each contour runs along the sides of voxels with matter on its left: around a piece it turns
    /// to the left, around a hole to the right. Pieces that meet in a corner only stay apart.
    /// Points are where it turns, so drawing the layer again, under either fill, gives the same
    /// voxels.
    ///
    /// - `stack`: the stack
    /// - `top_mm`: above the stack's top so far
    /// - `slice`: the slice, of the lattice's nx and ny
    /// - `lattice`: where voxels lie: nx, ny, pitch and origin are looked at
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a slice that is none, a top that does not
    ///   rise or is beyond 1e12; what sf_lattice_validate() says; SF_ERR_SHAPE: a slice of another
    ///   size; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
    /// - cost: a pass over the slice, and the length of the border in voxels; a slice of memory
    ///   while it works.
    /// - threads: one per stack.
    /// - since: 0.1
    #[must_use]
    pub fn sf_contour_stack_trace(
        stack: *mut sf_contour_stack,
        top_mm: f64,
        slice: sf_slice,
        lattice: *const sf_lattice,
    ) -> sf_status;

    /// Number of layers.
    ///
    /// - `stack`: the stack; NULL has none
    /// - returns: the number.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_contour_stack_count(stack: *const sf_contour_stack) -> u32;

    /// The contours of a layer and its heights.
    ///
    /// - `stack`: the stack
    /// - `k`: the layer, below sf_contour_stack_count()
    /// - `contours`: receives a view, good until the stack is changed or destroyed; may be NULL
    /// - `bottom_mm`: receives the height of its underside; may be NULL
    /// - `top_mm`: receives the height of its top; may be NULL
    /// - returns: SF_OK; SF_ERR_ARGUMENT: no stack, or no such layer.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_contour_stack_layer(
        stack: *const sf_contour_stack,
        k: u32,
        contours: *mut sf_contours,
        bottom_mm: *mut f64,
        top_mm: *mut f64,
    ) -> sf_status;

    /// A lattice that holds all contours of a stack, one layer each.
    ///
    /// Its corner is the least x, y and z; it ends at the first voxel beyond the greatest. Heights
    /// are rounded to nanometres, as sums of decimals need it; where all are the same, one stands
    /// for them.
    ///
    /// - `stack`: the stack
    /// - `pitch_x_mm`: voxel size along x, above 0
    /// - `pitch_y_mm`: voxel size along y, above 0
    /// - `heights_mm`: receives a height for each layer; kept by the lattice where they differ
    /// - `capacity`: places in heights_mm, at least sf_contour_stack_count()
    /// - `lattice`: receives the lattice
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a pitch that cannot be, a stack without
    ///   layers or without points; SF_ERR_CAPACITY: too few places; SF_ERR_OVERFLOW: more than
    ///   SF_EXTENT_MAX voxels along x or y.
    /// - cost: one pass.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_contour_stack_lattice(
        stack: *const sf_contour_stack,
        pitch_x_mm: f64,
        pitch_y_mm: f64,
        heights_mm: *mut f64,
        capacity: usize,
        lattice: *mut sf_lattice,
    ) -> sf_status;

    /// Draw a stack into a new grid, layer by layer.
    ///
    /// - `stack`: the stack
    /// - `lattice`: where voxels lie, with as many layers as the stack; heights and z are copied,
    ///   but not compared
    /// - `fill`: what is inside
    /// - `allocator`: for the grid, and as in sf_slice_from_contours(); NULL for the C library's
    /// - `task`: NULL, or progress per layer; a cancel is honoured at every layer
    /// - `grid`: receives the grid, to be destroyed by the caller
    /// - returns: as sf_slice_from_contours() and sf_grid_create(); SF_ERR_SHAPE: another number of
    ///   layers; SF_ERR_CANCELLED.
    /// - cost: sf_slice_from_contours() for each layer.
    /// - threads: any that read; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_from_contours(
        stack: *const sf_contour_stack,
        lattice: *const sf_lattice,
        fill: sf_contour_fill,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        grid: *mut *mut sf_grid,
    ) -> sf_status;

    /// Free a stack.
    ///
    /// - `stack`: the stack, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this stack.
    /// - since: 0.1
    pub fn sf_contour_stack_destroy(stack: *mut sf_contour_stack);

    /// The papers' rule: a voxel is carried by any of the nine below it.
    ///
    /// It takes no angle. On cubic voxels it accepts 45 degrees along the axes and 54.7 degrees
    /// along diagonals; sf_rule_measure() says what it accepts on another lattice.
    ///
    /// - returns: the rule; it serves every lattice.
    /// - cost: constant.
    /// - threads: any.
    /// - source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for
    ///   Fabrication", Eurographics 2016, section 3.2.
    /// - since: 0.1
    pub fn sf_rule_box3() -> sf_rule;

    /// Number of uint64_t that the table of sf_rule_make() needs for a lattice.
    ///
    /// - `lattice`: any lattice; NULL counts as uniform
    /// - returns: 0 where all layers have one height (heights_mm == NULL, or one layer), else 2 \*
    ///   nz.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_rule_table_count(lattice: *const sf_lattice) -> usize;

    /// Make a rule for an overhang angle on a lattice.
    ///
    /// The angle is measured from the vertical: 45 degrees is as far out as up, and larger is more
    /// daring. The reach of a step from layer k is height_k \* tan(angle) / pitch voxels, rounded
    /// down to 1/2^24 voxel after one part in 2^40 has been forgiven, so that 45 degrees on cubes
    /// is exactly 1 whatever way the angle and the pitch were written.
    ///
    /// Octagon is the rule to take where an angle is given and pixels are square: it never reaches
    /// beyond the asked angle but for less than 1.502 voxel, in any direction and over any number
    /// of layers; along the axes and the diagonals it stays at atan(0.924 tan(angle)). Disk is good
    /// where the reach is three voxels or more, because each step rounds down anew; it serves
    /// pixels that are not square. Box3 ignores the angle. Slack is the rule to take where pixels
    /// are not square or where the angle must be met in every direction: no chain of any length
    /// reaches beyond the asked angle but for its cap, which is the longest single step, and in the
    /// long run it reaches the asked angle to within three percent of its tangent (seven where
    /// pixels are oblong). It costs a byte for each voxel of two layers.
    ///
    /// - `kind`: which rule
    /// - `angle_rad`: SF_RULE_ANGLE_MIN_RAD to SF_RULE_ANGLE_MAX_RAD (5 to 85 degrees, each bound
    ///   with 1e-9 to spare); ignored by box3
    /// - `lattice`: the lattice that slices lie on
    /// - `table`: sf_rule_table_count() numbers, or NULL where that is 0 or for box3; written, and
    ///   kept by the rule
    /// - `rule`: the rule
    /// - `fault`: NULL, or where a refusal is explained
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such kind, an angle outside its range
    ///   or not a number; SF_ERR_UNSUPPORTED: octagon on pixels that are not square, disk where a
    ///   step reaches less than a voxel, a step that reaches more than SF_REACH_MAX voxels, slack
    ///   where one reaches more than 63 or where pixels are more than 25 times as long as wide;
    ///   what sf_lattice_validate() says.
    /// - cost: O(nz) where heights differ, else constant.
    /// - threads: any.
    /// - source: The octagon's schedule is a Bresenham line in the number of pluses and squares (J.
    ///   E. Bresenham, 1965).
    /// - since: 0.1
    #[must_use]
    pub fn sf_rule_make(
        kind: sf_rule_kind,
        angle_rad: f64,
        lattice: *const sf_lattice,
        table: *mut u64,
        rule: *mut sf_rule,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// The element of one step: slice k + 1 must lie within slice k dilated by it.
    ///
    /// Under slack the element holds what can carry at all, where there is slack enough; bridges
    /// are not in it. The octagon's elements differ from step to step even where all layers have
    /// one height, so k is always the lattice's layer, never a count from the bed.
    ///
    /// - `rule`: the rule
    /// - `k`: layer below the step, counted from the lattice's layer 0
    /// - `element`: the element
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a rule that sf_rule_make() did not make,
    ///   or a table that does not reach to layer k + 1.
    /// - cost: O(reach).
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_rule_element(rule: *const sf_rule, k: u32, element: *mut sf_element) -> sf_status;

    /// Let a rule accept bridges: gaps of at most a span between two anchored ends of one layer.
    ///
    /// They run along x, along y and along both diagonals of a pixel. The span is rounded down to
    /// whole voxels, the anchor up, each after one part in 2^20 of a voxel has been forgiven; layer
    /// heights do not matter.
    ///
    /// - `rule`: a rule of any kind; only its bridges are changed
    /// - `span_mm`: longest gap that is spanned, 0 for no bridges
    /// - `anchor_mm`: length of carried matter that each end must have; a voxel is asked for at
    ///   least
    /// - `lattice`: the lattice that the rule was made for
    /// - `fault`: NULL, or where a refusal is explained
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a span or an anchor that is negative or
    ///   not a number; SF_ERR_UNSUPPORTED: a span or an anchor of more than SF_BRIDGE_SPAN_MAX
    ///   voxels, a span greater than 0 that is less than a voxel along every direction; what
    ///   sf_lattice_validate() says.
    /// - cost: constant.
    /// - threads: one per rule.
    /// - since: 0.1
    #[must_use]
    pub fn sf_rule_set_bridges(
        rule: *mut sf_rule,
        span_mm: f64,
        anchor_mm: f64,
        lattice: *const sf_lattice,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Angles that a rule allows on a lattice.
    ///
    /// Box3 and disk: from the reach of single steps, the worst over the layers. Octagon: from its
    /// mean reach; a window of L layers is within 1.502 voxel of that. Slack: the asked angle and
    /// what its polygon of steps makes of it; a window of L layers is within the cap of that.
    /// Bridges are not overhangs and do not count.
    ///
    /// - `rule`: the rule
    /// - `lattice`: the lattice that it was made for; any for box3
    /// - `angles`: the angles
    /// - returns: SF_OK; SF_ERR_ARGUMENT: as sf_rule_element(); SF_ERR_SHAPE: the rule was made for
    ///   another number of layers; what sf_lattice_validate() says.
    /// - cost: O(nz + d \* reach^2) where d neighbouring layers differ in height.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_rule_measure(
        rule: *const sf_rule,
        lattice: *const sf_lattice,
        angles: *mut sf_rule_angles,
    ) -> sf_status;

    /// The rule kind of a name, as sf_rule_kind_name() gives it.
    ///
    /// - `name`: zero-terminated; NULL is the name of none
    /// - `kind`: the kind
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, or the name of no kind.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_rule_kind_from_name(name: *const c_char, kind: *mut sf_rule_kind) -> sf_status;

    /// Name of a rule kind, as the command line and stack.json spell it.
    ///
    /// - `kind`: any value
    /// - returns: "box3", "octagon", "disk", "slack", or "unknown"; a static string, never NULL.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_rule_kind_name(kind: sf_rule_kind) -> *const c_char;

    /// Terms without masks: rule box3, bed by the shape itself.
    ///
    /// - returns: the terms, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_terms_default() -> sf_terms;

    /// Whether something that must stay can be carried within what may be there; and if not, what
    /// of it cannot.
    ///
    /// A support-free shape R with needed within R within allowed exists just when needed lies
    /// within the trim of `allowed`. Each voxel that does not is a culprit: it cannot be carried
    /// even alone, and giving up or exempting just the culprits makes the rest possible. True for
    /// every rule.
    ///
    /// - `allowed`: all voxels that may be solid
    /// - `needed`: voxels that must be; what of them is not allowed is a culprit
    /// - `terms`: rule, bed layer and exempt voxels; the other masks are not looked at. With
    ///   SF_BED_AUTO the bed is the first layer that holds matter in `allowed`
    /// - `allocator`: for working memory: a grid, and what a trim takes; NULL for the C library's
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - `culprits`: NULL, or a grid whose voxels are set to the culprits; neither of the others
    /// - `count`: number of culprits; may be NULL
    /// - returns: SF_OK: feasible; SF_ERR_INFEASIBLE: it is not, and culprits and count were
    ///   written; SF_ERR_ARGUMENT: a NULL pointer, terms without their struct_size, a bed layer
    ///   that the grid has not, a rule that does not serve all its layers; SF_ERR_SHAPE: grids that
    ///   differ in counts; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: a trim.
    /// - threads: any; the grids but culprits are only read.
    /// - source: the greatest support-free subset is unique because support-free sets are closed
    ///   under union.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_feasible(
        allowed: *const sf_grid,
        needed: *const sf_grid,
        terms: *const sf_terms,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        culprits: *mut sf_grid,
        count: *mut u64,
    ) -> sf_status;

    /// Options of a check: rule box3, bed by the shape itself, no findings.
    ///
    /// - returns: the options; width and height are 0 and must be set for a streaming check.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_check_options_default() -> sf_check_options;

    /// Bytes of memory that sf_checker_place() needs for these options.
    ///
    /// About four slices (under slack 36, with bridges four more), 42 bytes for each column, and
    /// with findings 32 bytes for each run of run_capacity and 4 for each column; 16 for each run
    /// of layer_run_capacity, and with that 4 for each row.
    ///
    /// - `options`: the options that the checker will be placed with
    /// - `size`: the bytes
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, width
    ///   or height outside 1..SF_EXTENT_MAX, a first or a bed layer of SF_LAYER_MAX or more, a bed
    ///   layer below the first, a capacity without findings, a rule that sf_rule_make() did not
    ///   make or that does not serve the first layer; SF_ERR_OVERFLOW: a capacity of 2^31 - 1 or
    ///   more, or a size that does not fit the machine.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_checker_size(options: *const sf_check_options, size: *mut usize) -> sf_status;

    /// Set up a checker in the caller's memory.
    ///
    /// The findings array and the rule's table stay the caller's and must live as long as the
    /// checker is used; the options are copied.
    ///
    /// - `options`: the options
    /// - `memory`: 64-byte aligned; apart from what the findings lie in
    /// - `memory_size`: its size in bytes, at least sf_checker_size()
    /// - `checker`: the checker, which lies in `memory`
    /// - returns: SF_OK; what sf_checker_size() says; SF_ERR_ARGUMENT: a NULL pointer, memory that
    ///   is not aligned; SF_ERR_CAPACITY: too little memory.
    /// - cost: O(width \* height / 64), under slack O(width \* height).
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_checker_place(
        options: *const sf_check_options,
        memory: *mut c_void,
        memory_size: usize,
        checker: *mut *mut sf_checker,
    ) -> sf_status;

    /// Push the next layer as bits.
    ///
    /// Findings of the layer are in the array when the call returns, in the order in which their
    /// regions end: by last row, then from left to right in that row. Volumes and boxes of earlier
    /// findings may have grown.
    ///
    /// - `checker`: the checker
    /// - `layer`: a slice of the checker's width and height; read only; not in the checker's memory
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a slice that is none, a slice in the
    ///   checker's memory, a rule whose table does not reach to this layer; SF_ERR_SHAPE: another
    ///   size; SF_ERR_OVERFLOW: the layer would be number SF_LAYER_MAX.
    /// - cost: a step of the rule, two where matter was lost below (under slack, as long as it
    ///   tells), and in lost matter its voxels times the rows of the element; whatever the size, up
    ///   to 9 KiB of stack, 6 on a processor of 32 bits.
    /// - threads: one per checker.
    /// - source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for
    ///   Fabrication", Eurographics 2016, section 3.2.
    /// - since: 0.1
    #[must_use]
    pub fn sf_checker_push(checker: *mut sf_checker, layer: sf_slice) -> sf_status;

    /// Push the next layer as runs.
    ///
    /// - `checker`: the checker
    /// - `runs`: row by row, left to right, not overlapping but free to touch; labels are ignored;
    ///   may be NULL where count is 0
    /// - `count`: number of runs
    /// - returns: as sf_checker_push(); SF_ERR_ARGUMENT also: runs that are empty, leave the slice
    ///   or are out of order.
    /// - cost: O(count) where layer_run_capacity serves; else as sf_checker_push() too.
    /// - threads: one per checker.
    /// - since: 0.1
    #[must_use]
    pub fn sf_checker_push_runs(
        checker: *mut sf_checker,
        runs: *const sf_run,
        count: usize,
    ) -> sf_status;

    /// Push the next layer as 8-bit rows: solid where the value is at least `threshold`.
    ///
    /// - `checker`: the checker
    /// - `pixels`: the pixel of voxel (0, 0), then those along x; row y starts at y \* row_bytes
    /// - `row_bytes`: bytes from one row to the next, at least the width
    /// - `threshold`: 1 to 255; 0 makes everything solid
    /// - returns: as sf_checker_push(); SF_ERR_ARGUMENT also: rows that are too short or do not fit
    ///   the machine.
    /// - cost: as sf_checker_push(), and two passes over the pixels.
    /// - threads: one per checker.
    /// - since: 0.1
    #[must_use]
    pub fn sf_checker_push_grey(
        checker: *mut sf_checker,
        pixels: *const u8,
        row_bytes: usize,
        threshold: u8,
    ) -> sf_status;

    /// Push the next layer as contours: closed polygons of \<sf/contour.h\>.
    ///
    /// - `checker`: the checker
    /// - `lattice`: of the checker's width and height; pitch and origin are looked at
    /// - `contours`: the polygons
    /// - `fill`: what is inside
    /// - `allocator`: for drawing and for the layer's runs; NULL for the C library's
    /// - `fault`: NULL, or filled where a point is refused
    /// - returns: as sf_slice_from_contours() and as sf_checker_push_runs().
    /// - cost: as both.
    /// - threads: one per checker.
    /// - since: 0.1
    #[must_use]
    pub fn sf_checker_push_contours(
        checker: *mut sf_checker,
        lattice: *const sf_lattice,
        contours: *const sf_contours,
        fill: sf_contour_fill,
        allocator: *const sf_allocator,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Counts so far.
    ///
    /// - `checker`: the checker
    /// - `report`: the counts
    /// - `finding_count`: findings in the caller's array; may be NULL
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer.
    /// - cost: constant.
    /// - threads: one per checker.
    /// - since: 0.1
    #[must_use]
    pub fn sf_checker_report(
        checker: *const sf_checker,
        report: *mut sf_check_report,
        finding_count: *mut usize,
    ) -> sf_status;

    /// Check a whole grid: the streaming check, with every slice pushed from the bottom up.
    ///
    /// Width, height and first layer of the options are the grid's, whatever stands there. Where
    /// run_capacity is 0 it is chosen so that all runs fit, so that volumes and causes are exact
    /// for all findings in the array. After a failing call the findings array is as it was.
    ///
    /// - `grid`: the shape
    /// - `options`: rule, bed layer, findings
    /// - `allocator`: for working memory: that of a checker, and as many findings as the array has
    ///   places; NULL for the C library's
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - `report`: the counts
    /// - `finding_count`: findings in the caller's array; may be NULL
    /// - returns: SF_OK; what sf_checker_size() says; SF_ERR_ARGUMENT: a NULL pointer, a bed layer
    ///   that the grid has not, a rule that does not serve all its layers; SF_ERR_MEMORY;
    ///   SF_ERR_CANCELLED.
    /// - cost: that of the pushes; more passes where a layer loses more than 262144 runs.
    /// - threads: any; the grid is only read.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_check(
        grid: *const sf_grid,
        options: *const sf_check_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        report: *mut sf_check_report,
        finding_count: *mut usize,
    ) -> sf_status;

    /// Which voxels of a shape nothing carries, as it is drawn: those that a check counts, and all
    /// of what lies below the bed.
    ///
    /// What rests on one of them counts as carried, under slack with no reach to spare. With these
    /// exempt, and what the terms exempt already, the shape is support-free.
    ///
    /// - `grid`: the shape
    /// - `terms`: rule, bed layer and exempt voxels, which count as carried; the other masks are
    ///   not looked at
    /// - `allocator`: for working memory: a grid, two slices, under slack 34, with bridges three
    ///   more; NULL for the C library's
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - `unsupported`: of the same counts, and neither the shape nor a mask: set to these voxels
    /// - `count`: how many; may be NULL
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, terms without their struct_size, a bed
    ///   layer that the grid has not, a rule that does not serve all its layers, one grid given
    ///   twice; SF_ERR_SHAPE: grids that differ in counts; SF_ERR_OVERFLOW; SF_ERR_MEMORY;
    ///   SF_ERR_CANCELLED.
    /// - cost: a step of the rule for each layer.
    /// - threads: any that write distinct grids.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_unsupported(
        grid: *const sf_grid,
        terms: *const sf_terms,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        unsupported: *mut sf_grid,
        count: *mut u64,
    ) -> sf_status;

    /// The steepest overhang that a shape has: the least angle for which the rule slack finds
    /// nothing.
    ///
    /// To a tenth of a degree, between 5 and 85. An overhang over a height H may be said flatter
    /// than it is by the rule's cap over H in its tangent: about two voxels up to 63 degrees, and
    /// above that what one step reaches, up to twelve on cubes. So a flat ledge of one layer is
    /// given the angle whose step reaches over it.
    ///
    /// - `grid`: the shape
    /// - `bed_layer`: layer that rests on the bed, or SF_BED_AUTO
    /// - `allocator`: for working memory: that of a check, and a rule's table; NULL for the C
    ///   library's
    /// - `task`: NULL, or progress; a cancel is honoured at every slice
    /// - `steepest`: the result
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a bed layer that the grid has not;
    ///   SF_ERR_UNSUPPORTED: not even at 5 degrees can the lattice be served; SF_ERR_MEMORY;
    ///   SF_ERR_CANCELLED.
    /// - cost: about eleven checks under slack.
    /// - threads: any; the grid is only read.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_steepest(
        grid: *const sf_grid,
        bed_layer: u32,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        steepest: *mut sf_steepest,
    ) -> sf_status;

    /// Remove everything that is not supported, in place: what is left is the largest support-free
    /// part.
    ///
    /// From the bottom up: T_bed = S_bed, and T_{k+1} is what of S_{k+1} the rule lets rest on T_k;
    /// matter below the bed layer is removed. The result contains every support-free part of the
    /// shape, so no order of other removals keeps more, and trimming again changes nothing.
    ///
    /// - `grid`: the shape, changed in place
    /// - `rule`: a rule for the grid's lattice
    /// - `bed_layer`: layer that rests on the bed, or SF_BED_AUTO: the first that holds matter
    /// - `task`: NULL, or progress per slice; a cancel is honoured only before the first write,
    ///   because there is no second grid to go back to
    /// - `report`: counts, or NULL, which saves counting
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a bed layer that the grid has not, a rule
    ///   that does not serve all its layers; SF_ERR_CANCELLED; under slack and with bridges also
    ///   SF_ERR_MEMORY and SF_ERR_OVERFLOW: working memory, taken from the grid's allocator before
    ///   the first write, was refused or does not fit the machine (under slack 18 slices, with
    ///   bridges five, with both 21).
    /// - cost: one pass over the grid for box3 and octagon up to reach 1; about 4 \* reach passes
    ///   for others; under slack some fifty passes at a surface and few inside; with bridges, in
    ///   layers where something hangs, some twenty passes over a window around it.
    /// - threads: one per grid.
    /// - source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for
    ///   Fabrication", Eurographics 2016, sections 2.2 and 3.2.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_trim(
        grid: *mut sf_grid,
        rule: *const sf_rule,
        bed_layer: u32,
        task: *mut sf_task,
        report: *mut sf_trim_report,
    ) -> sf_status;

    /// Trim on terms: with exempt voxels, and only if nothing that must stay is lost.
    ///
    /// The result is the largest part of the shape that is support-free apart from the exempt
    /// voxels. It is refused where that part lacks a voxel that must stay: one of `keep`, or one
    /// outside `act`.
    ///
    /// - `grid`: the shape, changed in place
    /// - `terms`: rule, bed layer and masks; `forbid` is not looked at, because nothing is added
    /// - `allocator`: for working memory: a grid, with keep or act two, and what a trim takes; NULL
    ///   for the C library's
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - `culprits`: NULL, or a grid that is set, on SF_ERR_INFEASIBLE, to the voxels that must
    ///   stay and cannot
    /// - `report`: counts, or NULL
    /// - returns: SF_OK; SF_ERR_INFEASIBLE: a voxel that must stay cannot, and the shape is as it
    ///   was; and what sf_grid_feasible() says.
    /// - cost: a copy of the grid and a trim.
    /// - threads: one per grid.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_trim_on(
        grid: *mut sf_grid,
        terms: *const sf_terms,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        culprits: *mut sf_grid,
        report: *mut sf_trim_report,
    ) -> sf_status;

    /// Bring `printable` = trim(`drawn`) up to date after `drawn` changed within `box`.
    ///
    /// Before the change `printable` was the trim of `drawn`, by the same rule and bed layer; after
    /// this call it is again, bit for bit what sf_grid_trim() of `drawn` gives. Under slack
    /// everything is trimmed anew, because what a voxel has to spare is not kept. Else only what
    /// can have changed is looked at: the box, and above it what rests on voxels that did change,
    /// up to the first layer where none did. Matter may have been added and removed; parts that
    /// were trimmed earlier come back where there is support for them now.
    ///
    /// `drawn` and `printable` may be one grid, if the change only removed matter and the grid was
    /// support-free before it.
    ///
    /// Where bed_layer is SF_BED_AUTO and the change moved the first layer that holds matter,
    /// everything is recomputed.
    ///
    /// - `drawn`: the shape as drawn, after the change
    /// - `printable`: its support-free part, before the call that of the shape before the change
    /// - `rule`: a rule for the lattice of both
    /// - `bed_layer`: as in sf_grid_trim()
    /// - `box_`: a box around the change, within the grid; an empty one changes nothing
    /// - `changed`: NULL, or where the box around the voxels of `printable` that this call changed
    ///   is left: empty (all zero) when there are none
    /// - returns: SF_OK; SF_ERR_ARGUMENT: as sf_grid_trim(), or a box beyond the grid;
    ///   SF_ERR_SHAPE: the grids differ in counts; SF_ERR_MEMORY: working memory, taken from the
    ///   allocator of `printable`, was refused: a slice, with bridges four, under slack a grid and
    ///   18 slices; SF_ERR_OVERFLOW, under slack: it does not fit the machine.
    /// - cost: the volume of the boxes around the change in each layer, grown by the rule's reach
    ///   and with bridges by their span and anchor; under slack a trim.
    /// - threads: one per pair of grids.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_trim_box(
        drawn: *const sf_grid,
        printable: *mut sf_grid,
        rule: *const sf_rule,
        bed_layer: u32,
        box_: sf_box,
        changed: *mut sf_box,
    ) -> sf_status;

    /// The wall of a solid: its voxels of which any point is nearer than a thickness to a surface.
    ///
    /// Voxels are boxes, and the distance of a box to a triangle is exact but for rounding: a voxel
    /// of the solid that is not wall has no point nearer than wall_mm, less one part in 2^40 of the
    /// largest coordinate. So much is forgiven, so that walls are whole voxels where the surface
    /// lies along the lattice. Of a surface that is not closed only its triangles count: unite this
    /// wall with that of sf_grid_wall_inside(). Triangles inside of the solid, where shells run
    /// through each other, have a wall around them as well.
    ///
    /// - `solid`: the solid
    /// - `surface`: its surface; it may reach beyond the lattice
    /// - `wall_mm`: thickness; 0 gives no wall
    /// - `allocator`: for working memory: two grids, 48 slices, and 100 bytes a triangle; NULL for
    ///   the C library's
    /// - `task`: NULL, or progress, cancel and threads; the result is the same bytes with any
    /// - `wall`: of the solid's counts, and not the solid: set to the wall
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, one grid given twice, a thickness that is
    ///   negative or not finite; what sf_mesh_bounds() says; SF_ERR_SHAPE: grids that differ in
    ///   counts; SF_ERR_OVERFLOW: a coordinate beyond 1e12 mm, a surface around a lattice that is
    ///   as large as can be; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: sorts the triangles; some reach \* reach passes over bits, with the reach of the
    ///   wall in voxels; and for about one layer of voxels each the triangles that lie just so far.
    /// - threads: any that write distinct walls; the task's hook may run up to 16 pieces at once;
    ///   one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_wall(
        solid: *const sf_grid,
        surface: sf_mesh_view,
        wall_mm: f64,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        wall: *mut sf_grid,
    ) -> sf_status;

    /// The wall of a solid without a mesh: its voxels that are nearer than a thickness to what is
    /// not solid, the outside of the grid included.
    ///
    /// The distance is the gap between two boxes, less the same that sf_grid_wall() forgives.
    ///
    /// - `solid`: the solid
    /// - `wall_mm`: thickness; 0 gives no wall
    /// - `allocator`: for working memory: a grid and two slices; NULL for the C library's
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - `wall`: of the solid's counts, and not the solid: set to the wall
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, one grid given twice, a thickness that is
    ///   negative or not finite; SF_ERR_SHAPE: grids that differ in counts; SF_ERR_UNSUPPORTED: a
    ///   wall of more than 253 voxels along x or y; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: reach \* reach passes over bits, with the reach of the wall in voxels.
    /// - threads: any that write distinct walls.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_wall_inside(
        solid: *const sf_grid,
        wall_mm: f64,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        wall: *mut sf_grid,
    ) -> sf_status;

    /// How near the voxels of a grid come to a surface: of a cavity, how thick the wall around it
    /// is.
    ///
    /// The least distance of any point of a solid voxel, as a box, to any point of a triangle;
    /// exact but for rounding, and 0 where a triangle comes within 2^-20 of a voxel or so.
    ///
    /// - `grid`: the voxels
    /// - `surface`: the triangles; they may reach beyond the lattice
    /// - `allocator`: for working memory: a grid and 100 bytes a triangle; NULL for the C library's
    /// - `task`: NULL, or progress, cancel and threads; the result is the same bytes with any
    /// - `least_mm`: receives the distance; infinite where nothing is solid
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; what sf_mesh_bounds() says;
    ///   SF_ERR_OVERFLOW: as sf_grid_wall(); SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: sorts the triangles; and for each voxel at the border of what is solid the triangles
    ///   that lie as near as the nearest.
    /// - threads: any; the task's hook may run up to 16 pieces at once; one at a time for each
    ///   allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_clearance(
        grid: *const sf_grid,
        surface: sf_mesh_view,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        least_mm: *mut f64,
    ) -> sf_status;

    /// Options of carving: support-free, as little as is enough, density 1, no stances, struts two
    /// voxels wide.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_carve_options_default() -> sf_carve_options;

    /// Carve a solid: result holds the wall, lies within the solid, and weighs as the stances need.
    ///
    /// Support-free: what is supported in the solid, exempt voxels included, is supported in the
    /// result, under the whole rule; what hangs in the solid may hang on, and counts as exempt.
    /// Struts of strut_width_vx stand under what the wall does not carry itself; single voxels
    /// where no square fits, and all of them where under slack a step reaches less than a voxel
    /// along x or y. Without stances as little stays as is found. With stances, by the goal: the
    /// result is close to the best that any carving can do, and what it misses is the price of the
    /// struts (docs/balance.md has figures). Where the wall is closed around the inside, no piece
    /// floats.
    ///
    /// Plane, after the paper: with c the centre of mass and, for each stance with up u, c\* the
    /// place nearest to it among those that are safe at its height, voxels that are not wall are
    /// sorted by d = sum over stances of max(0, (r - c\*) . (c - c\*)), taken across u; those with
    /// d above 0 are removed one by one from the largest d on, of equal ones the lowest layer, row
    /// and x first (d is told apart to one part in 2^32 of the largest), the energy, which is the
    /// sum of the squared distances to the c\*, is followed through all of them, and the best
    /// prefix is kept. This is done again with the new c until every half-space holds (ENOUGH), or
    /// a round removes less than a thousandth of what could be, or does not improve. With
    /// SF_CARVE_ENOUGH the best prefix is the first in which every half-space holds; with
    /// SF_CARVE_DEEPEST it has the largest slack, and c\* is the place of largest slack. Where
    /// nothing is safe at that height, c\* is the place of largest slack as well. Without stances
    /// this mode carves nothing.
    ///
    /// The order leaves no floating pieces around one plane in a solid with a wall all around;
    /// several rounds or stances may, so they are looked for.
    ///
    /// - `solid`: the solid
    /// - `wall`: what must stay, within the solid; see sf_grid_wall()
    /// - `terms`: support-free: rule, bed layer and exempt voxels; `keep` stays too, and nothing
    ///   outside `act` is removed. NULL in mode plane, which looks at no terms
    /// - `options`: NULL for the default
    /// - `allocator`: for working memory: NULL for the C library's. Plane: a grid, and 24 bytes for
    ///   each voxel that may be carved. Support-free: a dozen grids, and 25 bytes for each voxel of
    ///   the solid
    /// - `task`: NULL, or progress; a cancel is honoured at least at every layer or round
    /// - `result`: of the solid's counts, another grid than all others
    /// - `report`: what was done; may be NULL
    /// - returns: SF_OK, be it safe or not; SF_ERR_ARGUMENT: a NULL pointer, options without their
    ///   struct_size or with values outside their range, a density of a solid voxel that is not
    ///   above 0 or not finite, a body without mass, no terms in mode support-free or terms that do
    ///   not serve the solid, one grid given twice; SF_ERR_SHAPE: grids that differ in counts;
    ///   SF_ERR_INFEASIBLE: the wall is not within the solid; SF_ERR_OVERFLOW; SF_ERR_MEMORY;
    ///   SF_ERR_CANCELLED; SF_ERR_INTERNAL: the result failed its check.
    /// - cost: plane: for each round a sort in linear time, and a step for each voxel and
    ///   half-space. Support-free: some 20 sweeps over the solid's voxels without stances, and two
    ///   more for each of some 10 to 60 questions with them: 82,500 voxels in 0.1 s, 808,000 in
    ///   half a second.
    /// - threads: any that write distinct results.
    /// - source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing
    ///   Shapes for 3D Fabrication", SIGGRAPH 2013, section 4 and equations 7 and 8.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_carve(
        solid: *const sf_grid,
        wall: *const sf_grid,
        terms: *const sf_terms,
        options: *const sf_carve_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        result: *mut sf_grid,
        report: *mut sf_carve_report,
    ) -> sf_status;

    /// Options of drains: no diameter yet, a hole for each void, no stances, counts only.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_drain_options_default() -> sf_drain_options;

    /// Drill a hole into every void that is closed, in place: what is in it can leave.
    ///
    /// A void is closed when its empty voxels, connected through faces, touch no side of the grid,
    /// nor its top or bottom: the bed is open once the part is off it. Its holes start where a disk
    /// of the diameter fits into it, and go straight down until all of the disk is in the open, the
    /// holes of other voids included; voids that they pass through are open then too. Where none
    /// may be drilled straight, holes go down aslant, in eight directions, as flat as the rule lets
    /// ceilings be. Of all places the one is taken whose volume, times its distance from the centre
    /// of mass across up where there are stances (the largest of them), is least.
    ///
    /// With terms no hole is drilled that leaves anything unsupported that was supported before it,
    /// exempt voxels included, that takes a voxel of `keep`, or one outside `act`; and no void is
    /// filled that reaches into `forbid`, or out of `act`. Where no place will do, a hole may take
    /// with it what would hang around its lower end, as long as that is no more than a quarter of
    /// the hole.
    ///
    /// - `grid`: the part, changed in place
    /// - `terms`: rule, bed layer and masks; NULL: nothing needs support
    /// - `options`: diameter, count, stances
    /// - `allocator`: for working memory: four grids, the runs of what is empty, and 24 bytes for
    ///   each voxel of a void's surface; NULL for the C library's
    /// - `task`: NULL, or progress per void; a cancel is honoured before each try
    /// - `report`: counts; may be NULL
    /// - returns: SF_OK, be all voids open or not; SF_ERR_ARGUMENT: a NULL pointer, options without
    ///   their struct_size, a diameter that is not above 0 or not finite, a count of 0, a capacity
    ///   without an array, a density of a drilled voxel or a body that is not finite, stances and a
    ///   body without mass, terms that do not serve the grid, or name it; SF_ERR_SHAPE: masks of
    ///   other counts; SF_ERR_UNSUPPORTED: a diameter of more than 500 voxels; SF_ERR_OVERFLOW;
    ///   SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: for each hole, and each place that was tried in vain, at most 64 for a void, a trim.
    /// - threads: one per grid.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_drain(
        grid: *mut sf_grid,
        terms: *const sf_terms,
        options: *const sf_drain_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        report: *mut sf_drain_report,
    ) -> sf_status;

    /// Name of an operation, as certificates spell it.
    ///
    /// - `operation`: any value
    /// - returns: "check", "trim", "grow", "repair", "preserve", or "unknown"; a static string,
    ///   never NULL.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_operation_name(operation: sf_operation) -> *const c_char;

    /// Fingerprint of a grid's voxels: SHA-256 of its bits, not of its lengths.
    ///
    /// The bytes that are hashed are those of its stack's pictures: every row as (nx + 7) / 8
    /// bytes, voxel x being the bit of value 128 \>\> x % 8 in byte x / 8, solid 1, and unused bits
    /// 0; in a layer rows from the largest y down, layers from the lowest up. Counts are not among
    /// them, so what compares fingerprints compares lattices too.
    ///
    /// - `grid`: the grid
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - `digest`: the fingerprint; untouched on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_CANCELLED.
    /// - cost: one pass, about 5 ns a byte.
    /// - threads: any; the grid is only read.
    /// - source: NIST, "Secure Hash Standard", FIPS 180-4, 2015.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_sha256(grid: *const sf_grid, task: *mut sf_task, digest: *mut u8) -> sf_status;

    /// A claim about a shape that nothing was done to, without terms, which must be set.
    ///
    /// - returns: the claim, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_claim_default() -> sf_claim;

    /// Certify that a shape is support-free but for exempt voxels, after looking at every layer of
    /// it.
    ///
    /// The claim's angle and spans must be those that the rule in its terms was made from: the rule
    /// is made again, and its integers compared.
    ///
    /// - `shape`: the shape; only read
    /// - `claim`: what is claimed of it; it and what it points to are not needed afterwards
    /// - `allocator`: for the certificate and for working memory; NULL for the C library's
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - `certificate`: where the certificate is left, to be destroyed by the caller; untouched on
    ///   failure
    /// - `fault`: NULL, or filled on failure: what is wrong, for a shape that is not support-free
    ///   with the first voxel that nothing carries
    /// - returns: SF_OK; SF_ERR_INFEASIBLE: the shape is not support-free; SF_ERR_ARGUMENT: a NULL
    ///   pointer, a struct without its size, terms that do not serve the shape, a rule that was not
    ///   made from the claimed numbers, an operation that there is not or that cannot have made
    ///   this shape from that; SF_ERR_SHAPE: grids that differ in counts; SF_ERR_UNSUPPORTED: what
    ///   sf_rule_make() says; SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: a trim, two fingerprints, and with bridges a walk along each gap.
    /// - threads: any; grids are only read.
    /// - source: a field that the layer rule's own step reproduces proves the shape support-free,
    ///   for every rule that is monotone.
    /// - since: 0.1
    #[must_use]
    pub fn sf_certificate_make(
        shape: *const sf_grid,
        claim: *const sf_claim,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        certificate: *mut *mut sf_certificate,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// What a certificate says.
    ///
    /// - `certificate`: the certificate; NULL gives a view of nothing, all zero
    /// - returns: the view, by value; its arrays live as long as the certificate.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_certificate_get_view(certificate: *const sf_certificate) -> sf_certificate_view;

    /// Free a certificate.
    ///
    /// - `certificate`: the certificate, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this certificate.
    /// - since: 0.1
    pub fn sf_certificate_destroy(certificate: *mut sf_certificate);

    /// Turn a rule into the table that a chip reads.
    ///
    /// The table is the same bytes on every machine. Where all steps have one element it has no
    /// steps and serves any number of layers.
    ///
    /// - `rule`: a rule that is an element for each step: box3, octagon or disk, no bridges
    /// - `first_layer`: lattice layer of the first slice that will be checked
    /// - `layer_count`: slices that the table must serve, at least 1
    /// - `memory`: for the table's bytes, kept by `table`; may be NULL where memory_size is 0
    /// - `memory_size`: bytes of it
    /// - `size`: bytes used; with SF_ERR_CAPACITY at least those needed, for another try
    /// - `table`: the table
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no layers, a rule that sf_rule_make() did
    ///   not make or that does not serve all the layers; SF_ERR_UNSUPPORTED: slack or bridges,
    ///   which need more than an element, or more than SF_CHIP_ELEMENT_MAX different elements;
    ///   SF_ERR_CAPACITY: too little memory.
    /// - cost: O(layers \* elements \* reach).
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_chip_rule_make(
        rule: *const sf_rule,
        first_layer: u32,
        layer_count: u32,
        memory: *mut u8,
        memory_size: usize,
        size: *mut usize,
        table: *mut sf_chip_rule,
    ) -> sf_status;

    /// Options of a check on a chip: rule box3, dense, bed by the shape itself, no findings.
    ///
    /// - returns: the options; width and height are 0 and must be set.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_chip_options_default() -> sf_chip_options;

    /// Bytes of memory that sf_chip_place() needs for these options; the same on every machine.
    ///
    /// Dense: 384 bytes, and 4 for every 32 voxels of a row, for height + reach + 2 rows.
    /// Run-length: 400 bytes, 12 for each run of run_capacity, 16 for each row of reach.
    ///
    /// - `options`: the options that the checker will be placed with
    /// - `size`: the bytes
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, width
    ///   or height outside 1..SF_EXTENT_MAX, a first or a bed layer of SF_LAYER_MAX or more, a bed
    ///   layer below the first, a capacity without findings, a table that is none; SF_ERR_OVERFLOW:
    ///   a size that does not fit the machine.
    /// - cost: O(bytes of the table).
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_chip_size(options: *const sf_chip_options, size: *mut usize) -> sf_status;

    /// Set up a check in the caller's memory, before its first layer.
    ///
    /// The findings array and the rule's bytes stay the caller's and must live as long as the
    /// checker is used; the options are copied.
    ///
    /// - `options`: the options
    /// - `memory`: 8-byte aligned; apart from what the findings lie in
    /// - `memory_size`: its size in bytes, at least sf_chip_size()
    /// - `chip`: the checker, which lies in `memory`
    /// - returns: SF_OK; what sf_chip_size() says; SF_ERR_ARGUMENT: a NULL pointer, memory that is
    ///   not aligned; SF_ERR_CAPACITY: too little memory.
    /// - cost: O(memory).
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_chip_place(
        options: *const sf_chip_options,
        memory: *mut c_void,
        memory_size: usize,
        chip: *mut *mut sf_chip,
    ) -> sf_status;

    /// Check the next layer, which a callback decodes row by row.
    ///
    /// When it fails the counts are as before the call. A run-length checker may then be given the
    /// layer again. A dense one has written over the layer below: it returns the same status from
    /// then on, until sf_chip_resume() or sf_chip_place() makes it new.
    ///
    /// - `chip`: the checker
    /// - `decode`: decodes one row
    /// - `user`: handed to decode; may be NULL
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a call from within decode, runs that are
    ///   empty, leave the row or are out of order, a table without a step to this layer;
    ///   SF_ERR_CAPACITY: the layer has more than run_capacity runs; SF_ERR_OVERFLOW: the layer
    ///   would be number SF_LAYER_MAX; what decode returned.
    /// - cost: a row: dense, its words times (2 reach + 4), and those of widening, fewer than the
    ///   largest half width; run-length, (its runs + the runs below within reach) \* (2 reach + 1).
    ///   At most 512 bytes of stack on a processor of 32 bits, beside what decode takes.
    /// - threads: one per checker.
    /// - source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for
    ///   Fabrication", Eurographics 2016, section 3.2 (a slice is checked against the one below).
    /// - since: 0.1
    #[must_use]
    pub fn sf_chip_push(chip: *mut sf_chip, decode: sf_chip_decode, user: *mut c_void) -> sf_status;

    /// Called by a decoder: voxels x0 \<= x \< x1 of its row are solid.
    ///
    /// Runs go from left to right; they may touch, and then count as one.
    ///
    /// - `chip`: the checker that decode was given
    /// - `x0`: first column
    /// - `x1`: the column after the last
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no decoder at work, a run that is empty,
    ///   leaves the row or begins before the end of the last one; SF_ERR_CAPACITY: more than
    ///   run_capacity runs in the layer. The push fails with that status, whatever the decoder
    ///   returns then.
    /// - cost: dense: O(length / 32); run-length: constant.
    /// - threads: one per checker.
    /// - since: 0.1
    #[must_use]
    pub fn sf_chip_solid(chip: *mut sf_chip, x0: u32, x1: u32) -> sf_status;

    /// Called by a decoder: pixels of its row from column x on, solid where they are at least
    /// `threshold`.
    ///
    /// - `chip`: the checker that decode was given
    /// - `x`: column of the first pixel
    /// - `pixels`: one byte each; may be NULL where count is 0
    /// - `count`: number of pixels
    /// - `threshold`: 1 to 255; 0 makes all of them solid
    /// - returns: as sf_chip_solid(); SF_ERR_ARGUMENT also: pixels that are NULL.
    /// - cost: O(count).
    /// - threads: one per checker.
    /// - since: 0.1
    #[must_use]
    pub fn sf_chip_grey(
        chip: *mut sf_chip,
        x: u32,
        pixels: *const u8,
        count: u32,
        threshold: u8,
    ) -> sf_status;

    /// Counts so far.
    ///
    /// - `chip`: the checker
    /// - `counts`: the counts
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer.
    /// - cost: constant.
    /// - threads: one per checker.
    /// - since: 0.1
    #[must_use]
    pub fn sf_chip_report(chip: *const sf_chip, counts: *mut sf_chip_counts) -> sf_status;

    /// Bytes of one slot of a store that every state of a checker fits.
    ///
    /// - `chip`: the checker; NULL has none
    /// - `size`: the bytes
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_OVERFLOW: two slots of it do not
    ///   fit 32 bits.
    /// - cost: constant.
    /// - threads: one per checker.
    /// - since: 0.1
    #[must_use]
    pub fn sf_chip_slot_size(chip: *const sf_chip, size: *mut u32) -> sf_status;

    /// Save the state after the last layer, into the slot that does not hold the last saved one.
    ///
    /// What is written first is the layer, what is written last, 84 bytes at the slot's beginning,
    /// says that it is whole; so a cut at any moment leaves the other slot, which is not touched.
    /// The bytes are the same on every machine.
    ///
    /// - `chip`: the checker
    /// - `store`: where to
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a call from within decode, a slot that is
    ///   too small, a dense checker whose last push failed; SF_ERR_OVERFLOW: as
    ///   sf_chip_slot_size(); what write returned, after which the state may be saved again.
    /// - cost: O(bytes saved).
    /// - threads: one per checker.
    /// - since: 0.1
    #[must_use]
    pub fn sf_chip_save(chip: *mut sf_chip, store: *const sf_chip_store) -> sf_status;

    /// Go on with the newest state in a store that is whole: counts, findings, the last layer.
    ///
    /// layer_count of the counts says which layer to push next. A store that was saved into by a
    /// checker of other options is refused.
    ///
    /// - `chip`: the checker, placed with the options that it had when the state was saved; as it
    ///   was when the call fails
    /// - `store`: where from
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a call from within decode; SF_ERR_FORMAT:
    ///   neither slot holds a whole state; SF_ERR_SHAPE: the newest whole one is of other options;
    ///   SF_ERR_IO: what was whole a moment before is not so any more, and the checker waits for
    ///   another try; what read returned, where no slot could be read.
    /// - cost: two passes over the bytes saved.
    /// - threads: one per checker.
    /// - since: 0.1
    #[must_use]
    pub fn sf_chip_resume(chip: *mut sf_chip, store: *const sf_chip_store) -> sf_status;

    /// The default bounds: 8 GiB, 1e9 triangles, UINT32_MAX vertices.
    ///
    /// - returns: the limits, by value, with struct_size set.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_read_limits_default() -> sf_read_limits;

    /// The mesh format that the extension of a file name stands for.
    ///
    /// - `name`: a file name or a path, upper or lower case; NULL is allowed
    /// - returns: the format; SF_MESH_FORMAT_AUTO when the name ends in none of .stl .obj .ply .off
    ///   .3mf .glb .gltf.
    /// - cost: the length of the name.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_mesh_format_from_name(name: *const c_char) -> sf_mesh_format;

    /// Read a mesh from any source of bytes: STL, OBJ, PLY, OFF, 3MF or glTF.
    ///
    /// Coordinates are taken as they are, as mm. Polygons become fans about their first corner.
    /// What is no triangle and no vertex (normals, colours, materials, lines, unknown elements) is
    /// passed over. STL has no shared vertices, so every facet brings three of its own;
    /// sf_mesh_merge() joins them. Of 3MF, which has units and a build, the whole build becomes one
    /// mesh in mm, as sf_threemf_read() and sf_threemf_merge() do it.
    ///
    /// glTF says which way is up: it is turned to mm with z up, as sf_gltf_read() says, which also
    /// reads buffers in other files. Its text form is not told from others by its bytes.
    ///
    /// No count in a file is believed: memory grows as the bytes come. A binary STL file is as long
    /// as its count says or longer (a count of 0 or 2^32 - 1 means: to the end); text STL ends with
    /// endsolid; a file that is shorter is refused, because half a part looks like a whole one. So
    /// are coordinates that are not finite, faces of fewer than three corners, corners that name no
    /// vertex, and files without a triangle. Numbers are read exactly, whatever the locale.
    ///
    /// - `source`: the file; read to where the mesh ends, or somewhat beyond
    /// - `format`: the format, or SF_MESH_FORMAT_AUTO to judge by the first 4096 bytes
    /// - `limits`: NULL for sf_read_limits_default()
    /// - `allocator`: for the mesh and for reading; NULL for the C library's
    /// - `mesh`: where the new mesh is left, to be destroyed by the caller; untouched on failure
    /// - `fault`: NULL, or filled on failure: what is wrong, at which line (of text files) and
    ///   byte, and what to do
    /// - returns: SF_OK; SF_ERR_FORMAT: the bytes are no mesh; SF_ERR_UNSUPPORTED: glTF or 3MF that
    ///   sf_gltf_read() or sf_threemf_read() do not serve; SF_ERR_OVERFLOW: more than `limits`;
    ///   SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL pointer or an unknown format; or what the source
    ///   returned.
    /// - cost: one pass over the file; while it grows, memory for two and a half times the mesh.
    /// - threads: any, on distinct sources; one at a time for each allocator.
    /// - source: 3D Systems, "StereoLithography Interface Specification", 1989; Wavefront, "Object
    ///   Files"; G. Turk, "The PLY Polygon File Format", 1994; the Geomview manual, "OFF Files".
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_read(
        source: sf_source,
        format: sf_mesh_format,
        limits: *const sf_read_limits,
        allocator: *const sf_allocator,
        mesh: *mut *mut sf_mesh,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Write a mesh as binary STL, OBJ, binary little-endian PLY, 3MF or binary glTF.
    ///
    /// OBJ and PLY keep every bit of every coordinate: OBJ as the fewest of 15 to 17 digits that
    /// read back as the same double, PLY as doubles. STL has floats and unit normals; vertices that
    /// are equal stay equal. glTF is what sf_gltf_write() writes, without colours; 3MF has one
    /// object, as sf_threemf_write() writes it. Everything is checked before the first byte is
    /// written.
    ///
    /// - `mesh`: the mesh; what sf_mesh_validate() takes
    /// - `format`: SF_MESH_FORMAT_STL, _OBJ, _PLY, _THREEMF or _GLTF
    /// - `sink`: where the bytes go; on failure it may have had some
    /// - returns: SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: no sink or no format;
    ///   SF_ERR_UNSUPPORTED: SF_MESH_FORMAT_OFF, or 3MF in a build without; SF_ERR_OVERFLOW: for
    ///   STL and glTF, a coordinate beyond the range of floats, more than UINT32_MAX triangles, and
    ///   for glTF and 3MF a file of 4 GiB; SF_ERR_MEMORY: for 3MF; or what the sink returned.
    /// - cost: one pass to check, one to write; 8 KiB of stack, and 300 KiB of memory for 3MF
    ///   alone.
    /// - threads: any, on distinct sinks.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_write(mesh: sf_mesh_view, format: sf_mesh_format, sink: sf_sink) -> sf_status;

    /// Whether this build writes and reads PNG.
    ///
    /// - returns: 1 when it does; 0 when stacks are written as PBM, PNG stacks cannot be read, and
    ///   sf_png_write_rgb() does not work.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_stack_has_png() -> c_int;

    /// Write a grid as a stack: layer_00000.png and so on from the bottom, and last stack.json.
    ///
    /// Each picture has nx by ny pixels, one bit of grey each: white is solid. It shows the layer
    /// from above: x to the right, y upward, so its top row is the largest y. In a build without
    /// PNG the pictures are PBM (P4), layer_00000.pbm. stack.json says it all:
    ///
    /// ```text
    /// {"format": "libsf-stack", "version": 1, "units": "mm",
    ///  "lattice": {"nx", "ny", "nz", "pitch_mm": [x, y],
    ///              "layer_mm" or "heights_mm": [...], "origin_mm": [x, y, z]},
    ///  "rule": null or {"kind": "box3" | "octagon" | "disk" | "slack",
    ///                   "angle_deg", "angle_rad", "bridge_mm": [span, anchor], "bed_layer",
    ///                   "phase_layer": 0},
    ///  "layers": {"pattern": "layer_%05u.png", "count": nz},
    ///  "solid": "white", "row_order": "top_is_max_y"}
    /// ```
    ///
    /// Its numbers read back as the same doubles. angle_deg is for people: the reader takes
    /// angle_rad; box3 has neither. bridge_mm is there only where the rule has bridges, and then
    /// the version is 2. bed_layer is null for SF_BED_AUTO. phase_layer is the layer that the
    /// rule's phase counts from (an octagon's steps differ from layer to layer); so far that is
    /// always 0, so a reader takes nothing else, and 0 where it is absent. A folder without
    /// stack.json is no stack, so a call that fails leaves none in a folder that had none; over
    /// sf_directory_write() it leaves nothing at all.
    ///
    /// - `grid`: the shape
    /// - `info`: the rule it was made under, or NULL
    /// - `folder`: where to; needs `begin` and `commit`
    /// - `task`: NULL, or progress per layer and a cancel between layers
    /// - `fault`: NULL, or filled on failure with the file that could not be written
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, or a rule, angle or bed layer that there
    ///   is not; SF_ERR_MEMORY; SF_ERR_CANCELLED; SF_ERR_INTERNAL: libspng refuses what it should
    ///   take; or what the folder or its sinks returned.
    /// - cost: one pass over the grid, mostly in the compressor; 12 KiB of stack. libspng and zlib
    ///   take some 300 KiB from the C library, because they know no other allocators.
    /// - threads: any that only read the grid, on distinct folders.
    /// - since: 0.1
    #[must_use]
    pub fn sf_stack_write(
        grid: *const sf_grid,
        info: *const sf_stack_info,
        folder: sf_folder,
        task: *mut sf_task,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Read a stack back: the grid, its lattice, and the rule it was made under.
    ///
    /// Layers of materials (\<sf/layers.h\>) are read as what is solid. Pictures may also be grey
    /// of 2 to 8 bits, as picture editors save them: half-way and above is solid. Before memory is
    /// taken for the grid, every picture that stack.json claims must be there with the claimed
    /// size. Fields of stack.json that are not known are passed over.
    ///
    /// - `folder`: where from; needs `open` and `close`
    /// - `allocator`: for the grid and for reading; NULL for the C library's
    /// - `task`: NULL, or progress per layer and a cancel between layers
    /// - `grid`: where the new grid is left, to be destroyed by the caller; untouched on failure
    /// - `info`: NULL, or where the rule is left; untouched on failure
    /// - `fault`: NULL, or filled on failure: which file, what is wrong, what to do
    /// - returns: SF_OK; SF_ERR_FORMAT: stack.json or a picture is damaged, or they disagree;
    ///   SF_ERR_UNSUPPORTED: a version, rule or kind of picture that this build does not know, or a
    ///   build without jansson, which reads no stacks; SF_ERR_OVERFLOW: larger than this machine
    ///   addresses; SF_ERR_MEMORY; SF_ERR_CANCELLED; SF_ERR_ARGUMENT: a NULL pointer;
    ///   SF_ERR_INTERNAL: libspng refuses what it should take; SF_ERR_IO: a source that claims more
    ///   than it was asked for; or what the folder or its sources returned.
    /// - cost: two opens of each picture, one pass over their bytes. jansson, libspng and zlib take
    ///   memory from the C library, in proportion to stack.json (at most 64 MiB) and to a row.
    /// - threads: any, on distinct folders; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_stack_read(
        folder: sf_folder,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        grid: *mut *mut sf_grid,
        info: *mut sf_stack_info,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Write a certificate as JSON, for sf-verify and whoever else wants to check it.
    ///
    /// docs/certificate.md says what each field holds. The last one is the SHA-256 of every byte
    /// before it, so the file is to be kept as it is: the same JSON in other words is refused.
    ///
    /// - `certificate`: the certificate
    /// - `sink`: where the bytes go; on failure it may have had some
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; or what the sink returned.
    /// - cost: the length of the file; 12 KiB of stack, no memory.
    /// - threads: any, on distinct sinks.
    /// - since: 0.1
    #[must_use]
    pub fn sf_certificate_write(certificate: *const sf_certificate, sink: sf_sink) -> sf_status;

    /// Write a colour picture as PNG, eight bits of red, green and blue a pixel.
    ///
    /// - `pixels`: 3 \* width \* height bytes: red, green, blue, row after row from the top
    /// - `width`: 1..SF_EXTENT_MAX
    /// - `height`: 1..SF_EXTENT_MAX
    /// - `sink`: where the bytes go; on failure it may have had some
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer or a size outside its range;
    ///   SF_ERR_UNSUPPORTED: a build without PNG; SF_ERR_MEMORY; SF_ERR_INTERNAL: libspng refuses
    ///   what it should take; or what the sink returned.
    /// - cost: one pass, mostly in the compressor, which takes its memory from the C library.
    /// - threads: any, on distinct sinks.
    /// - since: 0.1
    #[must_use]
    pub fn sf_png_write_rgb(pixels: *const u8, width: u32, height: u32, sink: sf_sink) -> sf_status;

    /// Open a file for reading.
    ///
    /// - `path`: path of the file, as the C library takes it
    /// - `allocator`: for the object; NULL for the C library's
    /// - `file`: where the open file is left, to be closed by the caller; untouched on failure
    /// - `fault`: NULL, or filled on failure with the path and the reason
    /// - returns: SF_OK; SF_ERR_IO: it is not there, is a folder, or may not be read;
    ///   SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL pointer.
    /// - cost: constant.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_file_open(
        path: *const c_char,
        allocator: *const sf_allocator,
        file: *mut *mut sf_file,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// The source that reads an open file, from where it stands to its end.
    ///
    /// - `file`: the file; NULL gives a source without `read`
    /// - returns: the source; valid until the file is closed. It returns SF_ERR_IO when the disk
    ///   fails.
    /// - cost: constant.
    /// - threads: one per file.
    /// - since: 0.1
    pub fn sf_file_source(file: *mut sf_file) -> sf_source;

    /// Close a file.
    ///
    /// - `file`: the file, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one per file.
    /// - since: 0.1
    pub fn sf_file_close(file: *mut sf_file);

    /// Begin to write a file, without touching what stands at its path.
    ///
    /// The bytes go to a new file beside it, PATH.sf-PROCESS-NUMBER.tmp, until sf_save_commit()
    /// renames that. A symbolic link at the path is replaced by the file, not followed.
    ///
    /// - `path`: path of the file; what stands there must be an ordinary file or nothing
    /// - `allocator`: for the object; NULL for the C library's
    /// - `save`: where the object is left, for sf_save_commit() or sf_save_abort(); untouched on
    ///   failure
    /// - `fault`: NULL, or filled on failure with the path and the reason
    /// - returns: SF_OK; SF_ERR_IO: a folder or a device stands there, or no file can be made
    ///   beside it; SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL pointer or an empty path.
    /// - cost: constant.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_save_begin(
        path: *const c_char,
        allocator: *const sf_allocator,
        save: *mut *mut sf_save,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// The sink that writes a file being saved.
    ///
    /// - `save`: the file; NULL gives a sink without `write`
    /// - returns: the sink; valid until the commit or abort. After a failed write it takes nothing
    ///   more.
    /// - cost: constant.
    /// - threads: one per file.
    /// - since: 0.1
    pub fn sf_save_sink(save: *mut sf_save) -> sf_sink;

    /// Publish a file: sync it to the disk, rename it over its path, sync the folder.
    ///
    /// Whoever opens the path at any time finds the old file or the new one, whole; on failure the
    /// old one, and the new one is gone. The new file has the access rights of the old.
    ///
    /// - `save`: the file; freed, whatever is returned
    /// - `fault`: NULL, or filled on failure with the path and the reason
    /// - returns: SF_OK; SF_ERR_IO: a write or the sync failed, or the path cannot be replaced;
    ///   SF_ERR_ARGUMENT: NULL.
    /// - cost: a sync of the disk.
    /// - threads: one per file.
    /// - since: 0.1
    #[must_use]
    pub fn sf_save_commit(save: *mut sf_save, fault: *mut sf_fault) -> sf_status;

    /// Drop a file being saved; what stands at its path stays.
    ///
    /// - `save`: the file, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one per file.
    /// - since: 0.1
    pub fn sf_save_abort(save: *mut sf_save);

    /// Open a folder for reading its files.
    ///
    /// - `path`: path of the folder
    /// - `allocator`: for the object and the files it opens; NULL for the C library's
    /// - `directory`: where the object is left, for sf_directory_close(); untouched on failure
    /// - `fault`: NULL, or filled on failure with the path and the reason
    /// - returns: SF_OK; SF_ERR_IO: it is not there or no folder; SF_ERR_MEMORY; SF_ERR_ARGUMENT: a
    ///   NULL pointer or an empty path.
    /// - cost: constant.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_directory_read(
        path: *const c_char,
        allocator: *const sf_allocator,
        directory: *mut *mut sf_directory,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Begin to write a folder of files, without touching what stands at its path.
    ///
    /// The files go to a new folder beside it, PATH.sf-PROCESS-NUMBER.tmp, until
    /// sf_directory_commit() renames that. Only an empty folder or an earlier stack is replaced: a
    /// folder that holds stack.json, pictures named like layers, and nothing else.
    ///
    /// - `path`: path of the folder to be; its parent exists
    /// - `allocator`: for the object; NULL for the C library's
    /// - `directory`: where the object is left, for sf_directory_commit() or sf_directory_close();
    ///   untouched on failure
    /// - `fault`: NULL, or filled on failure with the path and the reason
    /// - returns: SF_OK; SF_ERR_IO: something else stands there, or no folder can be made beside
    ///   it; SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL pointer or an empty path.
    /// - cost: the number of entries of the folder that stands there.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_directory_write(
        path: *const c_char,
        allocator: *const sf_allocator,
        directory: *mut *mut sf_directory,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// The folder that a stack is read from or written to.
    ///
    /// File names are plain: no separators, no "..". Each file is synced to the disk as it is
    /// committed.
    ///
    /// - `directory`: the folder; NULL gives a folder without functions
    /// - returns: the folder; valid until the commit or close. One file is written at a time;
    ///   `begin` returns SF_ERR_ARGUMENT for a second one, for a name that is not plain, and for a
    ///   folder being read.
    /// - cost: constant.
    /// - threads: one per folder.
    /// - since: 0.1
    pub fn sf_directory_folder(directory: *mut sf_directory) -> sf_folder;

    /// Publish a folder: rename it to its path, in place of an empty folder or an earlier stack.
    ///
    /// An earlier stack is first renamed aside (PATH.sf-PROCESS-NUMBER.old) and removed when the
    /// new one stands: a crash in between leaves both, whole. On failure the old one stays and the
    /// new one is gone.
    ///
    /// - `directory`: a folder from sf_directory_write(); freed, whatever is returned
    /// - `fault`: NULL, or filled on failure with the path and the reason
    /// - returns: SF_OK; SF_ERR_IO: the path cannot be replaced, or now holds something else;
    ///   SF_ERR_MEMORY; SF_ERR_ARGUMENT: NULL, or a folder being read.
    /// - cost: a sync of the disk, and the number of files of an earlier stack.
    /// - threads: one per folder.
    /// - since: 0.1
    #[must_use]
    pub fn sf_directory_commit(directory: *mut sf_directory, fault: *mut sf_fault) -> sf_status;

    /// Close a folder being read, or drop one being written; what stands at its path stays.
    ///
    /// - `directory`: the folder, freed; NULL does nothing
    /// - cost: for one being written, the number of its files; it needs no memory.
    /// - threads: one per folder.
    /// - since: 0.1
    pub fn sf_directory_close(directory: *mut sf_directory);

    /// Read a CLI file, text or binary, with short or long numbers.
    ///
    /// A layer's height is that of its top; the lowest one is as thick as the step to the next
    /// (where there is only one: down to 0, or a millimetre where it lies there or below). A
    /// polygon that says it is an outside turns to the left afterwards, one that says it is a hole
    /// to the right, so that SF_CONTOUR_NONZERO is the fill to take. Layers of one height that
    /// follow each other are one.
    ///
    /// No count is believed: memory grows as points come. Refused are heights that fall, numbers
    /// that are not finite, another number of layers than the head says, and files that end early.
    ///
    /// - `source`: the file
    /// - `limits`: NULL for sf_read_limits_default(); bytes and vertices count
    /// - `allocator`: for the stack and for reading; NULL for the C library's
    /// - `stack`: receives the stack, to be destroyed by the caller; untouched on failure
    /// - `fault`: NULL, or filled on failure, with the line or byte
    /// - returns: SF_OK; SF_ERR_FORMAT: no CLI file, or a damaged one; SF_ERR_OVERFLOW: more than
    ///   `limits`; SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL pointer, a source without `read`; or what
    ///   the source returned.
    /// - cost: one pass.
    /// - threads: any, on distinct sources; one at a time for each allocator.
    /// - source: "Common Layer Interface (CLI), Version 2.0", Brite EuRam BE 2578, 1994.
    /// - since: 0.1
    #[must_use]
    pub fn sf_contour_stack_read(
        source: sf_source,
        limits: *const sf_read_limits,
        allocator: *const sf_allocator,
        stack: *mut *mut sf_contour_stack,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Write a stack as a CLI file, in mm.
    ///
    /// What turns to the left is written as an outside, what turns to the right as a hole. The file
    /// does not say where the lowest layer begins.
    ///
    /// - `stack`: the stack
    /// - `format`: text or binary
    /// - `sink`: where the bytes go; on failure it may have had some
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no sink, no such format; SF_ERR_OVERFLOW:
    ///   in binary, a polygon of 2^31 points or more; or what the sink returned.
    /// - cost: one pass; 12 KiB of stack, no memory.
    /// - threads: any, on distinct sinks.
    /// - since: 0.1
    #[must_use]
    pub fn sf_contour_stack_write(
        stack: *const sf_contour_stack,
        format: sf_contour_format,
        sink: sf_sink,
    ) -> sf_status;

    /// Options of densities: 1 everywhere.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_density_options_default() -> sf_density_options;

    /// What 1 mm3 of each voxel weighs.
    ///
    /// - `lattice`: where the voxels lie
    /// - `options`: NULL for the default
    /// - `allocator`: for working memory: 2 bytes for each voxel, and with meshes a grid; NULL for
    ///   the C library's
    /// - `task`: NULL, or progress, cancel and threads
    /// - `density`: receives nx \* ny \* nz numbers in (layer, y, x) order; untouched on failure
    /// - returns: SF_OK; what sf_lattice_validate() and sf_grid_voxelize() say; SF_ERR_ARGUMENT: a
    ///   NULL pointer, options without their struct_size, a density that is not above 0 or not
    ///   finite as a float, an infill outside its range, regions without an array, a region without
    ///   its shape; SF_ERR_SHAPE: a wall or a mask of other counts; SF_ERR_OVERFLOW: more than
    ///   SF_DENSITY_REGIONS_MAX regions, or more voxels than the machine can address;
    ///   SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: one pass over the voxels for each region, and one more.
    /// - threads: any that write distinct arrays.
    /// - since: 0.1
    #[must_use]
    pub fn sf_lattice_density(
        lattice: *const sf_lattice,
        options: *const sf_density_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        density: *mut f32,
    ) -> sf_status;

    /// One step, by the standard rules.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_refine_options_default() -> sf_refine_options;

    /// Refine a cage.
    ///
    /// After a step the points are those of the points before, of the edges, of the faces and of
    /// the cells, in that order. Pieces of one cell follow each other; piece j holds the cell's
    /// corner j, as its own corner j where the cell is a hexahedron (in dimension 2 a
    /// quadrilateral), so that axes are kept, and as its first corner else. Where neighbours name
    /// different values of a property at their corners, each side is refined by itself, as if it
    /// ended there: the property jumps there, exactly.
    ///
    /// - `cage`: the cage, not needed any more afterwards
    /// - `options`: NULL for the defaults
    /// - `allocator`: for the refinement and for scratch; NULL for the C library's
    /// - `task`: progress, cancel, threads; NULL for none
    /// - `refinement`: receives the refinement
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, steps or rules that there are not;
    ///   SF_ERR_OVERFLOW: more points or corners than SF_CAGE_POINT_MAX; SF_ERR_MEMORY;
    ///   SF_ERR_CANCELLED.
    /// - cost: a step eight times as much as the one before; memory likewise.
    /// - threads: any; one at a time for each allocator.
    /// - source: K. I. Joy, R. MacCracken, "The refinement rules for Catmull-Clark solids", 1999;
    ///   E. Catmull, J. Clark, "Recursively generated B-spline surfaces on arbitrary topological
    ///   meshes", 1978; T. DeRose, M. Kass, T. Truong, "Subdivision surfaces in character
    ///   animation", 1998; C. Altenhofen and others, "Continuous property gradation for
    ///   multi-material 3D-printed objects", 2018.
    /// - since: 0.1
    #[must_use]
    pub fn sf_refine(
        cage: *const sf_cage,
        options: *const sf_refine_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        refinement: *mut *mut sf_refinement,
    ) -> sf_status;

    /// Free a refinement.
    ///
    /// - `refinement`: the refinement, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this refinement.
    /// - since: 0.1
    pub fn sf_refinement_destroy(refinement: *mut sf_refinement);

    /// The cage after some steps.
    ///
    /// Its channels have indices where neighbours' values differ somewhere, also where the cage's
    /// own indices make no difference.
    ///
    /// - `refinement`: the refinement
    /// - `step`: 0, the cage itself, to the number of steps
    /// - `view`: receives the view, valid until the refinement is destroyed; its values change with
    ///   updates
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a step that there is not.
    /// - cost: constant.
    /// - threads: any, while nobody updates.
    /// - since: 0.1
    #[must_use]
    pub fn sf_refinement_get_view(
        refinement: *const sf_refinement,
        step: u32,
        view: *mut sf_cage_view,
    ) -> sf_status;

    /// Take new positions from the cage through all steps.
    ///
    /// - `refinement`: the refinement
    /// - `positions`: 3 for each of the cage's points, mm, finite and within 10^12; not the
    ///   refinement's own
    /// - `task`: threads; NULL for none; is not cancelled
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a position that cannot be.
    /// - cost: some 15 products for each new point and coordinate.
    /// - threads: one for each refinement.
    /// - since: 0.1
    #[must_use]
    pub fn sf_refinement_update_positions(
        refinement: *mut sf_refinement,
        positions: *const f64,
        task: *mut sf_task,
    ) -> sf_status;

    /// Take new values of a property from the cage through all steps.
    ///
    /// - `refinement`: the refinement
    /// - `channel`: which property
    /// - `values`: as many as the property has in the cage, finite and within its bounds; not the
    ///   refinement's own
    /// - `task`: threads; NULL for none; is not cancelled
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such property, a value that it does
    ///   not allow.
    /// - cost: some 15 products for each new value.
    /// - threads: one for each refinement.
    /// - since: 0.1
    #[must_use]
    pub fn sf_refinement_update_values(
        refinement: *mut sf_refinement,
        channel: usize,
        values: *const f64,
        task: *mut sf_task,
    ) -> sf_status;

    /// How a point's position depends on the cage: as weights of the cage's points, above 0, that
    /// sum to 1.
    ///
    /// - `refinement`: the refinement
    /// - `step`: 0 to the number of steps
    /// - `point`: a point after that step
    /// - `allocator`: for scratch; NULL for the C library's
    /// - `capacity`: places in points and weights
    /// - `points`: receives the cage's points
    /// - `weights`: receives their weights
    /// - `count`: receives their number, also with SF_ERR_CAPACITY
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer (points and weights may be NULL with a
    ///   capacity of 0), a step or point that there is not; SF_ERR_CAPACITY; SF_ERR_MEMORY.
    /// - cost: the points that it depends on, at each step; scratch of a number for each point of
    ///   the step.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_refinement_stencil(
        refinement: *const sf_refinement,
        step: u32,
        point: usize,
        allocator: *const sf_allocator,
        capacity: usize,
        points: *mut u32,
        weights: *mut f64,
        count: *mut usize,
    ) -> sf_status;

    /// Make tetrahedra of somebody's arrays, which are copied.
    ///
    /// Those that are inverted or flat are taken all the same: sf_tets_check() counts them.
    ///
    /// - `view`: the arrays
    /// - `allocator`: for the tetrahedra; NULL for the C library's
    /// - `tets`: receives the tetrahedra
    /// - `fault`: NULL, or receives a sentence that names the first tetrahedron, point or property
    ///   at fault
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no points or tetrahedra, an index out of
    ///   range, a point twice in one tetrahedron, a coordinate that is not finite or beyond 10^12
    ///   mm, a property that cannot be (as sf_cage_create()); SF_ERR_OVERFLOW: too many;
    ///   SF_ERR_MEMORY.
    /// - cost: linear.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_tets_create(
        view: *const sf_tets_view,
        allocator: *const sf_allocator,
        tets: *mut *mut sf_tets,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// The tetrahedra of a refined cage of dimension 3: six for each cell of a step.
    ///
    /// Their positions and values are those of the refinement, and change with it. Tetrahedron t
    /// lies in cell t / 6 of the step.
    ///
    /// - `refinement`: the refinement; it must stay while the tetrahedra are used
    /// - `step`: 1 to the number of steps
    /// - `allocator`: for the tetrahedra; NULL for the C library's
    /// - `tets`: receives the tetrahedra
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a step that there is not;
    ///   SF_ERR_UNSUPPORTED: a refinement of dimension 2; SF_ERR_OVERFLOW: too many; SF_ERR_MEMORY.
    /// - cost: linear; 96 bytes for each cell, as much again for each property that jumps.
    /// - threads: any; one at a time for each allocator.
    /// - source: C. Altenhofen and others, "Continuous property gradation for multi-material
    ///   3D-printed objects", 2018, "Implicit tetrahedrization".
    /// - since: 0.1
    #[must_use]
    pub fn sf_tets_of_refinement(
        refinement: *const sf_refinement,
        step: u32,
        allocator: *const sf_allocator,
        tets: *mut *mut sf_tets,
    ) -> sf_status;

    /// Free tetrahedra.
    ///
    /// - `tets`: the tetrahedra, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with these tetrahedra.
    /// - since: 0.1
    pub fn sf_tets_destroy(tets: *mut sf_tets);

    /// View of tetrahedra.
    ///
    /// - `tets`: the tetrahedra; NULL gives a view of nothing
    /// - returns: a view, valid until they are destroyed, and the refinement, if they follow one;
    ///   of nothing for NULL.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_tets_get_view(tets: *const sf_tets) -> sf_tets_view;

    /// Change values of a property of tetrahedra that own theirs.
    ///
    /// - `tets`: the tetrahedra
    /// - `channel`: which property
    /// - `first`: the first value
    /// - `count`: how many; may be 0
    /// - `values`: the values; not in their own arrays
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, values that there are not, one that is
    ///   not finite or lies outside the property's bounds; SF_ERR_UNSUPPORTED: they follow a
    ///   refinement, which is to be changed instead.
    /// - cost: O(count).
    /// - threads: one for these tetrahedra.
    /// - since: 0.1
    #[must_use]
    pub fn sf_tets_set_values(
        tets: *mut sf_tets,
        channel: usize,
        first: usize,
        count: usize,
        values: *const f64,
    ) -> sf_status;

    /// The tetrahedra of a grid's solid voxels: six for each, around the diagonal from its low
    /// corner.
    ///
    /// They conform, and fill the voxels exactly. They have one property, which is 0 everywhere, or
    /// what of its bounds is nearest to 0: sf_tets_spread() gives it values.
    ///
    /// - `grid`: the voxels
    /// - `property`: the property
    /// - `allocator`: for the tetrahedra and for scratch; NULL for the C library's
    /// - `tets`: receives the tetrahedra, which own their arrays
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a grid without solid voxels;
    ///   SF_ERR_OVERFLOW: more than there are numbers for; SF_ERR_MEMORY; what sf_tets_create()
    ///   says.
    /// - cost: two passes over the grid; 96 bytes for each voxel and 24 for each point, twice for a
    ///   while.
    /// - threads: any; one at a time for each allocator.
    /// - source: H. W. Kuhn, "Some combinatorial lemmas in topology", 1960.
    /// - since: 0.1
    #[must_use]
    pub fn sf_tets_of_grid(
        grid: *const sf_grid,
        property: *const sf_property,
        allocator: *const sf_allocator,
        tets: *mut *mut sf_tets,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Spread a property from some points over all others, harmonically: as heat would settle.
    ///
    /// Each free point gets the value at which the flow of Laplace's equation, by linear elements,
    /// is even; so a property that is linear where it is fixed is linear everywhere, and none lies
    /// outside of what is fixed (flat tetrahedra could overshoot, and are held to it). A part that
    /// hangs together with no fixed point becomes one value, about what it had in the mean. Values
    /// of points are meant: a property that jumps is refused.
    ///
    /// - `tets`: tetrahedra that own their arrays
    /// - `channel`: which property
    /// - `fixed`: for each point: not 0 where its value stays
    /// - `allocator`: for scratch, 48 bytes a tetrahedron and 32 a point; NULL for the C library's
    /// - `task`: NULL, or cancel; nothing has changed then
    /// - `report`: NULL, or receives what was done
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such property, no fixed point;
    ///   SF_ERR_UNSUPPORTED: tetrahedra of a refinement, a property that jumps; SF_ERR_INFEASIBLE:
    ///   it did not settle, because tetrahedra are too flat; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: some hundred passes over the tetrahedra: the more the finer they are.
    /// - threads: one for these tetrahedra; one at a time for each allocator.
    /// - source: R. Courant, "Variational methods for the solution of problems of equilibrium and
    ///   vibrations", 1943; M. Hestenes, E. Stiefel, "Methods of conjugate gradients for solving
    ///   linear systems", 1952.
    /// - since: 0.1
    #[must_use]
    pub fn sf_tets_spread(
        tets: *mut sf_tets,
        channel: usize,
        fixed: *const u8,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        report: *mut sf_spread_report,
    ) -> sf_status;

    /// Look at tetrahedra: their volumes, and whether they conform.
    ///
    /// - `tets`: the tetrahedra
    /// - `allocator`: for scratch; NULL for the C library's
    /// - `report`: receives what was found
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_MEMORY.
    /// - cost: sorting the faces.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_tets_check(
        tets: *const sf_tets,
        allocator: *const sf_allocator,
        report: *mut sf_tets_report,
    ) -> sf_status;

    /// Whether this build reads and writes exchange files.
    ///
    /// - returns: 1 where it has libhdf5, else 0.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_exchange_is_served() -> c_int;

    /// Write tetrahedra as an exchange file: the same bytes for the same tetrahedra.
    ///
    /// - `tets`: the tetrahedra
    /// - `sink`: where the bytes go, when all of them are there; on failure it may have had some
    /// - `fault`: NULL, or filled on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_UNSUPPORTED: a build without
    ///   libhdf5; SF_ERR_MEMORY; SF_ERR_INTERNAL: libhdf5 refuses what it should take; or what the
    ///   sink returned.
    /// - cost: the compressor's; the file is held in memory, twice for a while, from the C library.
    /// - threads: one at a time in a process, whatever uses libhdf5 included.
    /// - source: C. Altenhofen and others, "Continuous property gradation for multi-material
    ///   3D-printed objects", 2018, "Export and storage format".
    /// - since: 0.1
    #[must_use]
    pub fn sf_exchange_write(
        tets: *const sf_tets,
        sink: sf_sink,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Read an exchange file.
    ///
    /// What is there beside the layout is passed over, and nothing outside of the file is looked
    /// at: links to other places or files are refused. Every count is held against the size of the
    /// file before memory is taken. But libhdf5 itself was not made for files that mean harm: read
    /// those of strangers in a process of its own, with limits.
    ///
    /// - `source`: the file, read to its end
    /// - `bytes_max`: most bytes that are read; 0: 2^32
    /// - `allocator`: for the tetrahedra and for reading; NULL for the C library's, which libhdf5
    ///   takes in any case
    /// - `tets`: receives the tetrahedra; untouched on failure
    /// - `fault`: NULL, or filled on failure: what is wrong, and where
    /// - returns: SF_OK; SF_ERR_FORMAT: no HDF5 file, or none of this layout; SF_ERR_UNSUPPORTED: a
    ///   version that is not known, a build without libhdf5; SF_ERR_OVERFLOW: a file larger than
    ///   bytes_max, or more than tetrahedra can be; SF_ERR_ARGUMENT: a NULL pointer, or tetrahedra
    ///   that cannot be, as sf_tets_create(); SF_ERR_MEMORY; SF_ERR_IO: a source that claims more
    ///   than it was asked for; or what the source returned.
    /// - cost: the file and its contents are held in memory for a while.
    /// - threads: one at a time in a process, whatever uses libhdf5 included.
    /// - since: 0.1
    #[must_use]
    pub fn sf_exchange_read(
        source: sf_source,
        bytes_max: u64,
        allocator: *const sf_allocator,
        tets: *mut *mut sf_tets,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// What fixing each finding of a check costs: voxels that a trim takes, voxels that growing
    /// adds.
    ///
    /// grow_voxels is the size of a set of voxels that fixes the finding: once it is added every
    /// voxel of the finding's region is carried, and every voxel of the set by another or by the
    /// shape as drawn, down to the bed. So with the sets of all findings added the whole shape is
    /// support-free, and the sum of the costs bounds what repair by growth alone adds. The set is
    /// found greedily, so the figure is an upper bound; it is least where a region is one voxel and
    /// the rule is box3, octagon or disk. Matter below counts as a place to stand on even where it
    /// is lost itself: what it needs is the cost of its own finding.
    ///
    /// Under slack the chains count on no reach but that of the step itself, and no rule's chains
    /// make use of bridges; both make the figure larger, never wrong.
    ///
    /// - `grid`: the shape
    /// - `terms`: rule and bed layer that the check had; voxels of `forbid`, and those outside
    ///   `act`, are not added; `exempt` and `keep` are not looked at
    /// - `findings`: what sf_grid_check() found in this shape, from its first finding on
    /// - `finding_count`: how many; may be fewer than the check found
    /// - `allocator`: for working memory: two bytes for each voxel below the last finding, a few
    ///   slices, and what the largest region needs; NULL for the C library's
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - `costs`: finding_count places
    /// - `added`: NULL, or a grid that is set to all voxels that the sets hold together; neither
    ///   the shape nor a mask
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, terms without their struct_size, a bed
    ///   layer that the grid has not, a rule that does not serve all its layers, findings that are
    ///   not those of a check of this shape on these terms; SF_ERR_SHAPE: grids that differ in
    ///   counts; SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: 4 \* reach passes over two bytes a voxel, and for each finding its region and what
    ///   stands below it, not the rectangles around them, times the element and the logarithm of
    ///   their sizes.
    /// - threads: any; the grids but `added` are only read.
    /// - source: the costs are the closest supporting paths of T. Reiner, S. Lefebvre, "Interactive
    ///   Modeling of Support-free Shapes for Fabrication", Eurographics 2016, section 2.2, without
    ///   the distance to the ground; V. Chvatal, "A Greedy Heuristic for the Set-Covering Problem",
    ///   1979.
    /// - since: 0.1
    #[must_use]
    pub fn sf_findings_cost(
        grid: *const sf_grid,
        terms: *const sf_terms,
        findings: *const sf_finding,
        finding_count: usize,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        costs: *mut sf_finding_cost,
        added: *mut sf_grid,
    ) -> sf_status;

    /// Order of findings by what they cost to fix: the dearest first.
    ///
    /// The cost to fix a finding is the lesser of its two; of equal costs those come first that no
    /// other finding causes, then those with the lower index.
    ///
    /// - `findings`: the findings; may be NULL where there are none, as may the two others
    /// - `costs`: their costs, or NULL
    /// - `finding_count`: how many, at most UINT32_MAX
    /// - `order`: finding_count places, or NULL: order\[0\] is the index of the dearest finding
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer where there are findings; SF_ERR_OVERFLOW:
    ///   too many findings.
    /// - cost: n log n; no memory.
    /// - threads: any that write to distinct arrays.
    /// - since: 0.1
    #[must_use]
    pub fn sf_findings_rank(
        findings: *const sf_finding,
        costs: *const sf_finding_cost,
        finding_count: usize,
        order: *mut u32,
    ) -> sf_status;

    /// Options of a search for voids: a closed bed, chosen by the shape itself, and counts only.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_voids_options_default() -> sf_voids_options;

    /// Find the traps of a shape, and the cups that it makes while it prints.
    ///
    /// Outside the grid, at its sides and above it, all is empty and open. Voids are listed by the
    /// last layer that they have voxels in, and within it by the first of these in row order; a
    /// shorter array holds the first of them. After a failing call the array is as it was.
    ///
    /// - `grid`: the shape
    /// - `options`: bed, thresholds, array
    /// - `allocator`: for working memory: a slice, the runs of empty voxels of two layers, one
    ///   record for each component that the latest layer has, and as many voids as are listed; NULL
    ///   for the C library's
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - `report`: the counts
    /// - `void_count`: voids in the caller's array; may be NULL
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, a bed
    ///   layer that the grid has not, a capacity without an array; SF_ERR_OVERFLOW; SF_ERR_MEMORY;
    ///   SF_ERR_CANCELLED.
    /// - cost: one pass over the grid, and nearly linear in the runs of empty voxels.
    /// - threads: any; the grid is only read.
    /// - source: R. E. Tarjan, "Efficiency of a Good But Not Linear Set Union Algorithm", 1975.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_voids(
        grid: *const sf_grid,
        options: *const sf_voids_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        report: *mut sf_voids_report,
        void_count: *mut usize,
    ) -> sf_status;

    /// Begin a search for voids in layers that are pushed one at a time.
    ///
    /// - `options`: bed, thresholds, array; copied, and the array must stay
    /// - `width`: of the layers, 1..SF_EXTENT_MAX
    /// - `height`: of the layers, 1..SF_EXTENT_MAX
    /// - `allocator`: for the search, as sf_grid_voids() takes it; NULL for the C library's
    /// - `search`: receives the search
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, a
    ///   capacity without an array, an extent outside its range; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
    /// - cost: a layer of new memory.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_void_search_create(
        options: *const sf_voids_options,
        width: u32,
        height: u32,
        allocator: *const sf_allocator,
        search: *mut *mut sf_void_search,
    ) -> sf_status;

    /// Push the next layer.
    ///
    /// - `search`: the search; after SF_ERR_MEMORY or SF_ERR_OVERFLOW it may only be destroyed
    /// - `layer`: a slice of its width and height; read only
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a slice that is none, a search that is
    ///   finished; SF_ERR_SHAPE: another size; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
    /// - cost: one pass over the layer, and nearly linear in the runs of empty voxels.
    /// - threads: one per search.
    /// - since: 0.1
    #[must_use]
    pub fn sf_void_search_push(search: *mut sf_void_search, layer: sf_slice) -> sf_status;

    /// Say what was found: what sf_grid_voids() says of a grid of these layers.
    ///
    /// - `search`: the search, which takes no more layers
    /// - `report`: the counts
    /// - `void_count`: voids in the caller's array; may be NULL
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, or a search that is finished;
    ///   SF_ERR_MEMORY, or what a push returned before.
    /// - cost: the voids.
    /// - threads: one per search.
    /// - since: 0.1
    #[must_use]
    pub fn sf_void_search_finish(
        search: *mut sf_void_search,
        report: *mut sf_voids_report,
        void_count: *mut usize,
    ) -> sf_status;

    /// Free a search.
    ///
    /// - `search`: the search, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this search.
    /// - since: 0.1
    pub fn sf_void_search_destroy(search: *mut sf_void_search);

    /// Whether this build reads glTF.
    ///
    /// - returns: 1 where it has tinygltf, else 0.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_gltf_is_served() -> c_int;

    /// The default: sf_read_limits_default(), and no folder.
    ///
    /// - returns: the options, by value, with struct_size set.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_gltf_options_default() -> sf_gltf_options;

    /// Read a glTF file, binary (.glb) or as text (.gltf), as one mesh, in mm with z up.
    ///
    /// The mesh holds the triangles of the scene that the file shows first (without scenes, of all
    /// nodes), one vertex for each that the file has, times the nodes that show it; strips and fans
    /// become triangles; a node that mirrors turns its triangles, so that outside stays outside.
    /// Materials, colours, pictures, cameras and lights are passed over; skins, animations and
    /// shapes to blend to as well, and the report counts them. Positions may be interleaved,
    /// sparse, and whole numbers (KHR_mesh_quantization). Refused are files that require extensions
    /// which change the shape and are not served, such as compressed meshes.
    ///
    /// No path is followed. A buffer may stand in the file itself or be a data: URI; another file's
    /// name is asked of `folder` only if it is plain (no separators, no "..", no scheme). Pictures
    /// are not decoded, and files named like them not opened. Before tinygltf sees it, JSON is held
    /// against bounds: 64 levels, 200,000 objects and lists, 2 million values; so its memory, which
    /// comes from the C++ library, is some hundred MiB at most beside a few times the file. But it
    /// was not made for files that mean harm, and ends the process where memory is too short to
    /// destroy its JSON: read files of strangers in a process of its own. Nodes may repeat a mesh,
    /// up to 64 times the bytes of the file and 256 MiB.
    ///
    /// - `source`: the file, read to its end
    /// - `options`: NULL for sf_gltf_options_default()
    /// - `allocator`: for the mesh and for reading; NULL for the C library's
    /// - `mesh`: where the new mesh is left, to be destroyed by the caller; untouched on failure
    /// - `report`: NULL, or what was passed over; untouched on failure
    /// - `fault`: NULL, or filled on failure: what is wrong and what to do
    /// - returns: SF_OK; SF_ERR_FORMAT: no glTF 2.0, damaged, coordinates that are not finite, no
    ///   triangles; SF_ERR_UNSUPPORTED: a required extension that is not served, a build without
    ///   tinygltf; SF_ERR_OVERFLOW: more than the limits; SF_ERR_MEMORY; SF_ERR_IO: a buffer's file
    ///   is not there or its name is not plain; SF_ERR_ARGUMENT: a NULL pointer; or what a source
    ///   returned.
    /// - cost: one pass; the file is held in memory, its buffers twice for a while.
    /// - threads: any, on distinct sources; one at a time for each allocator.
    /// - source: The Khronos Group, "glTF 2.0 Specification", 2021.
    /// - since: 0.1
    #[must_use]
    pub fn sf_gltf_read(
        source: sf_source,
        options: *const sf_gltf_options,
        allocator: *const sf_allocator,
        mesh: *mut *mut sf_mesh,
        report: *mut sf_gltf_report,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Write a mesh as binary glTF, with a colour for each vertex or without.
    ///
    /// Positions are floats in mm; a node turns them to glTF's axes and metres. What sf_gltf_read()
    /// makes of the file is the same floats again. Colours are given as they are shown on a screen
    /// (sRGB) and written as light (linear, 16 bits), which is how glTF has them. The material is
    /// matt and seen from both sides.
    ///
    /// - `mesh`: the mesh; what sf_mesh_validate() takes, with triangles
    /// - `colors`: NULL, or 3 \* vertex_count bytes: red, green, blue of each vertex
    /// - `sink`: where the bytes go; on failure it may have had some
    /// - returns: SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: no sink, no triangles;
    ///   SF_ERR_OVERFLOW: a coordinate beyond the range of floats, or a file of 4 GiB; or what the
    ///   sink returned.
    /// - cost: one pass to check, one to write; 8 KiB of stack, no memory.
    /// - threads: any, on distinct sinks.
    /// - source: The Khronos Group, "glTF 2.0 Specification", 2021; IEC 61966-2-1, "sRGB", 1999.
    /// - since: 0.1
    #[must_use]
    pub fn sf_gltf_write(mesh: sf_mesh_view, colors: *const u8, sink: sf_sink) -> sf_status;

    /// Make a path finder for a grid.
    ///
    /// Where any matter may be landed on and the rule is box3, octagon or disk the finder looks at
    /// nothing but the grid as it is when it is asked: changes count at once. Under slack, or for
    /// landing on living matter only, it keeps what is alive, and sf_path_finder_refresh() brings
    /// that up to date. Bridges carry what stands there, but a path does not count on new ones.
    ///
    /// - `grid`: the shape; it and the masks must outlive the finder
    /// - `terms`: rule, bed layer and masks, copied. With SF_BED_AUTO the bed is the first layer
    ///   that holds matter now (or at the last refresh), layer 0 in an empty grid
    /// - `landing`: what matter a path may end on
    /// - `allocator`: for the finder and what its questions need; NULL for the C library's
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - `finder`: the finder
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such landing, terms without their
    ///   struct_size, a bed layer that the grid has not, a rule that does not serve all its layers;
    ///   SF_ERR_SHAPE: a mask of other counts; SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: a search for the bed. Where the finder keeps what is alive, a trim, and a bit for
    ///   each voxel; under slack another bit, and a byte for each voxel that lives with less than
    ///   all reach to spare; on layers of one height also some ten bytes for each layer and row of
    ///   the grid, until a cone fills its slices. At 512^3 and 45 degrees that is 40 MB.
    /// - threads: any; the grids are only read.
    /// - since: 0.1
    #[must_use]
    pub fn sf_path_finder_create(
        grid: *const sf_grid,
        terms: *const sf_terms,
        landing: sf_landing,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        finder: *mut *mut sf_path_finder,
    ) -> sf_status;

    /// Free a path finder.
    ///
    /// - `finder`: the finder, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this finder.
    /// - since: 0.1
    pub fn sf_path_finder_destroy(finder: *mut sf_path_finder);

    /// Bring what a finder keeps up to date with its grid: the bed, what is alive, its reach.
    ///
    /// - `finder`: the finder; as it was when the call fails
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: as sf_path_finder_create().
    /// - threads: one per finder.
    /// - since: 0.1
    #[must_use]
    pub fn sf_path_finder_refresh(finder: *mut sf_path_finder, task: *mut sf_task) -> sf_status;

    /// The closest supporting path of a voxel, solid or not: what to fill so that it is carried.
    ///
    /// The path goes from the layer below the voxel downwards, without the voxel itself and without
    /// the matter that it lands on. It is empty where the voxel is carried already, lies on the bed
    /// or is exempt, below the bed too: what is exempt stands wherever it lies. Among the paths of
    /// least cost: matter before a held voxel before the bed; the least distance of the landing
    /// from the voxel in the plane (on the bed first the least distance to the matter there), then
    /// the least y, then the least x of it. Between voxel and landing the path stays close to the
    /// straight line. With a bed slice that is empty it goes straight down if it may.
    ///
    /// - `finder`: the finder
    /// - `from`: the voxel; whether it may be filled itself is not asked
    /// - `path`: the voxels, from the top; may be NULL where capacity is 0
    /// - `capacity`: places in `path`; the layers of the grid are always enough
    /// - `found`: what is known of the path
    /// - returns: SF_OK; SF_ERR_CAPACITY: too few places, with `found` filled and `path` not
    ///   written; SF_ERR_INFEASIBLE: there is no path, as for a voxel below the bed layer that is
    ///   not exempt, or where the masks leave no way; SF_ERR_ARGUMENT: a NULL pointer, a voxel
    ///   outside the grid; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
    /// - cost: O(t^3 / 64) word reads where the path is t layers long. Once, and again whenever the
    ///   bed slice has changed, the first path that ends on the bed asks for a distance transform
    ///   of that slice. Under slack on layers of different heights O(t^2) bytes are made, and kept
    ///   until a voxel of another layer is asked about. Where the masks lie in the way O(t^3)
    ///   bytes, and memory for them.
    /// - threads: one per finder; the grids are only read.
    /// - source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for
    ///   Fabrication", Eurographics 2016, section 2.2 (grow), by a search of the downward cone in
    ///   place of a map.
    /// - since: 0.1
    #[must_use]
    pub fn sf_path_finder_find(
        finder: *mut sf_path_finder,
        from: sf_voxel,
        path: *mut sf_voxel,
        capacity: usize,
        found: *mut sf_path,
    ) -> sf_status;

    /// Options of a path map: any matter may be landed on, the cost is the number of voxels.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_path_map_options_default() -> sf_path_map_options;

    /// Make a path map: for many questions to a grid that does not change.
    ///
    /// Where no step reaches farther than a voxel (box3, octagon up to that reach), the cost is
    /// SF_PATH_COST_COUNT and stays below 4095, the map is half a byte for each voxel: a direction.
    /// Else it is four bytes, a cost, and directions are found while walking.
    ///
    /// - `grid`: the shape; it and the masks must outlive the map and must not change
    /// - `terms`: rule, bed layer and masks, copied; bridges as in sf_path_finder_create()
    /// - `options`: the options
    /// - `allocator`: for the map; NULL for the C library's
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - `map`: the map
    /// - returns: as sf_path_finder_create(); SF_ERR_ARGUMENT also: options without their
    ///   struct_size or with values that are none; SF_ERR_UNSUPPORTED: a slack rule, under which a
    ///   cost is not a voxel's alone.
    /// - cost: for half a byte a voxel about a nanosecond for four voxels; else voxels times those
    ///   of the element, and a distance transform of each slice for SF_PATH_COST_NEARNESS.
    /// - threads: any; the grids are only read.
    /// - source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for
    ///   Fabrication", Eurographics 2016, sections 2.2 and 3.2, with costs that are zero at matter.
    /// - since: 0.1
    #[must_use]
    pub fn sf_path_map_create(
        grid: *const sf_grid,
        terms: *const sf_terms,
        options: *const sf_path_map_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        map: *mut *mut sf_path_map,
    ) -> sf_status;

    /// Free a path map.
    ///
    /// - `map`: the map, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this map.
    /// - since: 0.1
    pub fn sf_path_map_destroy(map: *mut sf_path_map);

    /// The path of a voxel by the map: one of the least cost.
    ///
    /// Each step goes to a voxel of least cost; among these to the closest in the plane, then to
    /// the least y, then to the least x. So the path costs what sf_path_finder_find() finds, but
    /// need not be the same.
    ///
    /// - `map`: the map
    /// - `from`: as in sf_path_finder_find()
    /// - `path`: as in sf_path_finder_find()
    /// - `capacity`: as in sf_path_finder_find()
    /// - `found`: what is known of the path
    /// - returns: as sf_path_finder_find(), but for memory, which is not needed.
    /// - cost: the length of the path; on a map of costs times the voxels of the element.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_path_map_walk(
        map: *const sf_path_map,
        from: sf_voxel,
        path: *mut sf_voxel,
        capacity: usize,
        found: *mut sf_path,
    ) -> sf_status;

    /// Put a brush on every voxel of a path, and leave out of it what would hang in the air.
    ///
    /// What was solid stays, whatever carries it. What is added is carried, by what was there or by
    /// what is added; so the result is support-free if the shape was. The path itself is always
    /// added, with or without the brush's anchor.
    ///
    /// - `grid`: the shape, changed in place
    /// - `terms`: rule, bed layer and masks; nothing is added outside `act` or within `forbid`, nor
    ///   below the bed
    /// - `stroke`: brush and path
    /// - `allocator`: for working memory: the layers that the brush meets; NULL for the C library's
    /// - `report`: counts, or NULL
    /// - returns: SF_OK; SF_ERR_INFEASIBLE: a voxel of the path may not be added, or would hang in
    ///   the air; SF_ERR_ARGUMENT: a NULL pointer, an anchor outside the brush, a path outside the
    ///   grid, terms as in sf_path_finder_create(), a brush or a mask that is the grid;
    ///   SF_ERR_SHAPE: a mask of other counts; SF_ERR_OVERFLOW; SF_ERR_MEMORY. Only SF_OK changes
    ///   the grid.
    /// - cost: the brush's rows for each voxel of the path, and a trim of the layers it meets;
    ///   under slack of all layers up to there.
    /// - threads: one per grid.
    /// - source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for
    ///   Fabrication", Eurographics 2016, section 2.2 (grow); that what is added must be trimmed is
    ///   the library's own.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_emit(
        grid: *mut sf_grid,
        terms: *const sf_terms,
        stroke: *const sf_stroke,
        allocator: *const sf_allocator,
        report: *mut sf_emit_report,
    ) -> sf_status;

    /// Add what a shape lacks to be support-free, in place; nothing is removed.
    ///
    /// From the top down: in each layer the voxels that nothing carries are given supporters below,
    /// those from which the way to matter or to the bed is shortest, and among these those that
    /// carry most; no supporter is kept without which all would be carried. What is added is
    /// little, but not the least there is: that is a hard problem even in one layer. Exempt voxels
    /// need no support, and what bridges keep alive needs none. The result is checked under the
    /// whole rule before the grid is written.
    ///
    /// - `grid`: the shape, changed in place
    /// - `terms`: rule, bed layer and masks
    /// - `allocator`: for working memory: two grids and two bytes for each voxel, under slack up to
    ///   four; NULL for the C library's
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - `culprits`: NULL, or a grid that is set, on SF_ERR_INFEASIBLE, to the voxels of the shape
    ///   that cannot be carried whatever may be added
    /// - `report`: counts, or NULL
    /// - returns: SF_OK; SF_ERR_INFEASIBLE: some voxels cannot be carried, and the shape is as it
    ///   was; SF_ERR_ARGUMENT: a NULL pointer, a mask or culprits that are the grid, terms as in
    ///   sf_grid_feasible(); SF_ERR_SHAPE: grids that differ in counts; SF_ERR_OVERFLOW;
    ///   SF_ERR_MEMORY; SF_ERR_CANCELLED; SF_ERR_INTERNAL: the result failed its check.
    /// - cost: a map of costs (voxels times those of the element), and for each voxel without
    ///   support and for each one added the voxels of the element.
    /// - threads: one per grid.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_grow(
        grid: *mut sf_grid,
        terms: *const sf_terms,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        culprits: *mut sf_grid,
        report: *mut sf_grow_report,
    ) -> sf_status;

    /// Options of a mask: those that the built-in one was made with.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_mask_options_default() -> sf_mask_options;

    /// The mask of 32 x 32 x 32 voxels that is part of the library: what the default options make.
    ///
    /// - returns: the mask, which lives as long as the program, never NULL.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_mask_builtin() -> *const sf_mask;

    /// Make a mask by void and cluster: the same ranks for the same options, on every machine.
    ///
    /// - `options`: NULL for the default
    /// - `allocator`: for the mask and for working memory, 38 bytes a voxel in all; NULL for the C
    ///   library's
    /// - `task`: NULL, or progress and cancel
    /// - `mask`: receives the mask
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size or
    ///   outside their ranges; SF_ERR_OVERFLOW: more than SF_MASK_SIZE_MAX voxels; SF_ERR_MEMORY;
    ///   SF_ERR_CANCELLED.
    /// - cost: about linear in the voxels: 32^3 takes 0.1 s, 64^3 1.5 s.
    /// - threads: any; one at a time for each allocator.
    /// - source: R. Ulichney, "The void-and-cluster method for dither array generation", 1993; for
    ///   slices A. Wolfe, N. Morrical, T. Akenine-Moeller, R. Ramamoorthi, "Spatiotemporal Blue
    ///   Noise Masks", 2022.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mask_create(
        options: *const sf_mask_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        mask: *mut *mut sf_mask,
    ) -> sf_status;

    /// Make a mask from ranks that were kept, in (layer, y, x) order.
    ///
    /// - `nx`: period along x, as in sf_mask_options
    /// - `ny`: along y
    /// - `nz`: along z
    /// - `ranks`: nx \* ny \* nz numbers: each of 0 .. nx \* ny \* nz - 1 once
    /// - `allocator`: NULL for the C library's
    /// - `mask`: receives the mask
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a period outside its range;
    ///   SF_ERR_FORMAT: a rank that is too large or occurs twice; SF_ERR_OVERFLOW: more than
    ///   SF_MASK_SIZE_MAX voxels; SF_ERR_MEMORY.
    /// - cost: one pass.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mask_from_ranks(
        nx: u32,
        ny: u32,
        nz: u32,
        ranks: *const u32,
        allocator: *const sf_allocator,
        mask: *mut *mut sf_mask,
    ) -> sf_status;

    /// Free a mask.
    ///
    /// - `mask`: the mask, freed; NULL and the built-in one do nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this mask.
    /// - since: 0.1
    pub fn sf_mask_destroy(mask: *mut sf_mask);

    /// The period of a mask along x, y and z, in voxels.
    ///
    /// - `mask`: the mask; NULL has no size
    /// - `size`: receives the period along x, y and z; not NULL
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_mask_size(mask: *const sf_mask, size: *mut u32);

    /// The rank at a voxel, anywhere: the mask is repeated.
    ///
    /// - `mask`: the mask; NULL gives 0
    /// - `x`: column, of the repeated mask
    /// - `y`: row
    /// - `z`: layer
    /// - returns: the rank; 0 for NULL.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_mask_rank(mask: *const sf_mask, x: u32, y: u32, z: u32) -> u32;

    /// Make a mask ready.
    ///
    /// - `mask`: only read, and only during the call
    /// - `material_count`: 2..SF_MATERIAL_MAX
    /// - `allocator`: 5 bytes for each voxel of the mask, three times that where nx is 32; NULL for
    ///   the C library's
    /// - `halftone`: receives the object
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a number of materials out of range;
    ///   SF_ERR_OVERFLOW: more memory than the machine addresses; SF_ERR_MEMORY.
    /// - cost: a pass over the mask.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_halftone_create(
        mask: *const sf_mask,
        material_count: u32,
        allocator: *const sf_allocator,
        halftone: *mut *mut sf_halftone,
    ) -> sf_status;

    /// Free a halftone.
    ///
    /// - `halftone`: the halftone, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this halftone.
    /// - since: 0.1
    pub fn sf_halftone_destroy(halftone: *mut sf_halftone);

    /// Halftone a rectangle of a slice: a row, a tile or all of it, whichever comes first.
    ///
    /// Tones of solid voxels are at least 0 and add up to at most 1 (with 1e-6 to spare) or 255.
    ///
    /// - `halftone`: mask and number of materials
    /// - `tones`: what each material should fill
    /// - `materials`: receives materials; bits past the width become zero
    /// - `task`: NULL, or cancel, heeded at the start, and threads, at most 16 pieces at once
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a missing struct_size, a size, stride,
    ///   type or material out of range, a slice written that overlaps another, a tone that is no
    ///   number or out of range; SF_ERR_SHAPE: a slice of another size; SF_ERR_CANCELLED. Then
    ///   nothing was written.
    /// - cost: one pass over the tones; two over those that can be wrong: all but the bytes of two
    ///   materials. No memory.
    /// - threads: any, on distinct materials.
    /// - source: R. Ulichney, "Digital Halftoning", 1987, ordered dither.
    /// - since: 0.1
    #[must_use]
    pub fn sf_halftone_slice(
        halftone: *const sf_halftone,
        tones: *const sf_tones,
        materials: *const sf_materials,
        task: *mut sf_task,
    ) -> sf_status;

    /// Begin diffusing errors through slices of one size, from the lowest up.
    ///
    /// Each voxel gets the material that it lacks most, and what it got too much or too little goes
    /// to the next voxel in the row, the two behind it in the next row, and the one above, more to
    /// those that are nearer in mm. Rows run to and fro. Shares of voxels that are empty or outside
    /// go up.
    ///
    /// - `width`: 1..SF_EXTENT_MAX
    /// - `height`: 1..SF_EXTENT_MAX
    /// - `material_count`: 2..SF_MATERIAL_MAX
    /// - `pitch_mm`: of a voxel: x, y, z, above 0; no two differ by a factor above 64
    /// - `allocator`: 4 bytes for each voxel of a slice and material; NULL for the C library's
    /// - `diffuser`: receives the object
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a value out of range; SF_ERR_OVERFLOW:
    ///   more memory than the machine addresses; SF_ERR_MEMORY.
    /// - cost: one pass over the memory.
    /// - threads: any; one at a time for each allocator.
    /// - source: R. Floyd, L. Steinberg, "An adaptive algorithm for spatial greyscale", 1976, with
    ///   vectors, in three dimensions.
    /// - since: 0.1
    #[must_use]
    pub fn sf_diffuser_create(
        width: u32,
        height: u32,
        material_count: u32,
        pitch_mm: *const f64,
        allocator: *const sf_allocator,
        diffuser: *mut *mut sf_diffuser,
    ) -> sf_status;

    /// Free a diffuser.
    ///
    /// - `diffuser`: the diffuser, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this diffuser.
    /// - since: 0.1
    pub fn sf_diffuser_destroy(diffuser: *mut sf_diffuser);

    /// Halftone the next slice up.
    ///
    /// - `diffuser`: what the slices below left over
    /// - `tones`: of the diffuser's width and height; x0, y0 and layer are not looked at
    /// - `materials`: receives materials; bits past the width become zero
    /// - returns: as sf_halftone_slice(), but never SF_ERR_CANCELLED; SF_ERR_SHAPE also where width
    ///   or height differ from the diffuser's.
    /// - cost: some 20 operations for each voxel and material, one after the other. No memory.
    /// - threads: one at a time for each diffuser.
    /// - since: 0.1
    #[must_use]
    pub fn sf_diffuser_slice(
        diffuser: *mut sf_diffuser,
        tones: *const sf_tones,
        materials: *const sf_materials,
    ) -> sf_status;

    /// What became of the tones so far.
    ///
    /// - `diffuser`: the diffuser
    /// - `report`: receives one entry for each material
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer.
    /// - cost: one pass over its memory.
    /// - threads: one at a time for each diffuser.
    /// - since: 0.1
    #[must_use]
    pub fn sf_diffuser_report(diffuser: *const sf_diffuser, report: *mut sf_diffusion) -> sf_status;

    /// Prepare to find the voxels that come nearer than a distance to the surface of a mesh.
    ///
    /// Conservative: with S the voxels whose closed boxes the surface touches, the shell is S and
    /// each voxel whose box is less than the distance from the box of one of S. So no point of any
    /// other voxel is nearer to the surface than the distance, wherever within its voxels the
    /// surface runs, but for the 1/256 voxel to which sf_voxelizer_create() rounds corners.
    ///
    /// - `mesh`: vertices in mm; its arrays must outlive the shell
    /// - `lattice`: where voxels lie; copied
    /// - `distance_mm`: 0 (S itself) or more; its reach may be at most 255 voxels along each axis
    /// - `allocator`: for the voxeliser, a slice for each layer within reach, and four more; NULL
    ///   for the C library's
    /// - `shell`: receives the object
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: SF_OK; what sf_lattice_validate() and sf_voxelizer_create() say; SF_ERR_ARGUMENT:
    ///   a NULL pointer, a distance that is negative or no number; SF_ERR_OVERFLOW: a reach above
    ///   255 voxels; SF_ERR_MEMORY.
    /// - cost: as sf_voxelizer_create().
    /// - threads: any; one at a time for each allocator.
    /// - source: M. Schwarz, H.-P. Seidel, "Fast parallel surface and solid voxelization on GPUs",
    ///   2010.
    /// - since: 0.1
    #[must_use]
    pub fn sf_shell_create(
        mesh: sf_mesh_view,
        lattice: *const sf_lattice,
        distance_mm: f64,
        allocator: *const sf_allocator,
        shell: *mut *mut sf_shell,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Free a shell.
    ///
    /// - `shell`: the shell, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this shell.
    /// - since: 0.1
    pub fn sf_shell_destroy(shell: *mut sf_shell);

    /// The shell's voxels in layer k: the same bytes in whatever order layers are asked for.
    ///
    /// - `shell`: the shell
    /// - `k`: layer, below the lattice's nz
    /// - `slice`: nx by ny voxels; what it held is lost
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a slice that is none, a layer out of
    ///   range; SF_ERR_SHAPE: a slice that is not nx by ny.
    /// - cost: the surface voxels of layers not yet at hand, and a dilation for each layer within
    ///   reach.
    /// - threads: one at a time for each shell.
    /// - since: 0.1
    #[must_use]
    pub fn sf_shell_slice(shell: *mut sf_shell, k: u32, slice: sf_slice) -> sf_status;

    /// Voxels, volume and grams of each material, from the counts of each layer.
    ///
    /// - `lattice`: where voxels lie; its heights count
    /// - `counts`: lattice-\>nz times material_count numbers: those of sf_materials, layer after
    ///   layer
    /// - `material_count`: 1..255
    /// - `density_g_cm3`: of each material, 0 or more; NULL: no masses, 0
    /// - `uses`: receives one entry for each material
    /// - returns: SF_OK; what sf_lattice_validate() says; SF_ERR_ARGUMENT: a NULL pointer, a number
    ///   of materials or a density out of range; SF_ERR_OVERFLOW: more voxels than 64 bits count.
    /// - cost: one pass over the counts, in their order: the same bytes everywhere.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_material_uses(
        lattice: *const sf_lattice,
        counts: *const u64,
        material_count: u32,
        density_g_cm3: *const f64,
        uses: *mut sf_material_use,
    ) -> sf_status;

    /// Bytes of an open file.
    ///
    /// - `file`: the file, which must stay open; not to be read through sf_file_source() meanwhile
    /// - `bytes`: receives them
    /// - `fault`: NULL, or filled on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_IO: it is no file that has a size,
    ///   or the disk fails.
    /// - cost: constant.
    /// - threads: one per file.
    /// - since: 0.1
    #[must_use]
    pub fn sf_file_bytes(
        file: *mut sf_file,
        bytes: *mut sf_bytes,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Bytes of memory.
    ///
    /// - `memory`: data and size, not NULL, which must outlive the bytes; the position is not
    ///   looked at
    /// - returns: the bytes.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_memory_bytes(memory: *mut sf_memory_cursor) -> sf_bytes;

    /// The default options: 128 of 255 is solid, pixels as the job says, 64 GiB and a million
    /// layers.
    ///
    /// - returns: the options, by value, with struct_size set.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_job_options_default() -> sf_job_options;

    /// Whether this build reads and writes SL1, which takes libspng and zlib; .photon is always
    /// read.
    ///
    /// - returns: 1 when it does, else 0.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_job_has_sl1() -> c_int;

    /// Open a job: everything but the pictures' pixels is read and checked.
    ///
    /// Which format it is the first bytes say. No name in it ever becomes a path, and no number is
    /// believed before the bytes that it speaks of are there. What would make two readers see two
    /// jobs is refused: entries that overlap or come twice, pictures of several sizes, layers that
    /// are missing. An SL1 job says its pixels in prusaslicer.ini; where that is missing, pictures
    /// of 1440 x 2560 are taken for the SL1's own (0.04725 mm), and others must be told of in the
    /// options.
    ///
    /// - `bytes`: the file, which must stay
    /// - `options`: NULL for sf_job_options_default()
    /// - `allocator`: for the job and for reading; NULL for the C library's
    /// - `job`: receives the job, for sf_job_close(); untouched on failure
    /// - `fault`: NULL, or filled on failure: what is wrong, where, what to do
    /// - returns: SF_OK; SF_ERR_FORMAT: the file is no job, or damaged; SF_ERR_UNSUPPORTED: an
    ///   encrypted, 64-bit or newer one, several exposures a layer, a build without SL1, or pixels
    ///   of no known size; SF_ERR_OVERFLOW: more than the options allow; SF_ERR_ARGUMENT: no bytes
    ///   or job, options that cannot be; SF_ERR_MEMORY; SF_ERR_INTERNAL: libspng refuses what it
    ///   should take; or what the bytes returned.
    /// - cost: the directory, and the head of each picture; libspng takes its memory from the C
    ///   library.
    /// - threads: any, on distinct bytes; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_job_open(
        bytes: sf_bytes,
        options: *const sf_job_options,
        allocator: *const sf_allocator,
        job: *mut *mut sf_job,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// The lattice of a job: its pixels, its layers and their heights; its corner is 0, 0, 0.
    ///
    /// - `job`: the job; NULL has a lattice of zeros
    /// - returns: the lattice, by value; its heights_mm, if any, belong to the job.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_job_lattice(job: *const sf_job) -> sf_lattice;

    /// What a job says of itself.
    ///
    /// - `job`: the job
    /// - `info`: receives it
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_job_describe(job: *const sf_job, info: *mut sf_job_info) -> sf_status;

    /// Decode a layer as it is exposed: solid where a pixel has at least the threshold.
    ///
    /// - `job`: the job
    /// - `k`: the layer
    /// - `slice`: written, of the job's nx and ny; on failure its voxels are not to be used
    /// - `fault`: NULL, or filled on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: no job, no such layer, a slice that is none;
    ///   SF_ERR_SHAPE: a slice of another size; SF_ERR_FORMAT: damaged, cut short, or more pixels
    ///   than there are; SF_ERR_UNSUPPORTED: an interlaced picture; SF_ERR_MEMORY; SF_ERR_INTERNAL;
    ///   or what the bytes returned.
    /// - cost: one pass over its bytes and pixels.
    /// - threads: one per job.
    /// - since: 0.1
    #[must_use]
    pub fn sf_job_read(
        job: *mut sf_job,
        k: u32,
        slice: sf_slice,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Decode a layer as greys: colours count as bright as they look, and what is transparent is
    /// black.
    ///
    /// - `job`: the job
    /// - `k`: the layer
    /// - `pixels`: written, a byte each, row 0 the lowest; on failure not to be used
    /// - `row_bytes`: bytes from one row to the next, at least nx
    /// - `fault`: NULL, or filled on failure
    /// - returns: as sf_job_read().
    /// - cost: as sf_job_read().
    /// - threads: one per job.
    /// - since: 0.1
    #[must_use]
    pub fn sf_job_read_grey(
        job: *mut sf_job,
        k: u32,
        pixels: *mut u8,
        row_bytes: usize,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Close a job; the bytes are the caller's.
    ///
    /// - `job`: the job, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this job.
    /// - since: 0.1
    pub fn sf_job_close(job: *mut sf_job);

    /// Write an SL1 job again with the layers of a grid, and everything else byte for byte.
    ///
    /// Layers whose voxels are as they were are copied as they lie in the archive, and so is every
    /// other entry: compressed bytes, dates, attributes, comments. A layer that differs becomes a
    /// new picture under its name, 8 bits of grey, stored: what was added is 255, what was taken
    /// away 0, with the dim rim around it, up to 8 pixels wide, that touches nothing which is left.
    /// All other greys stay.
    ///
    /// - `job`: an SL1 job
    /// - `grid`: the new layers, with the job's counts
    /// - `sink`: where the bytes go; on failure it may have had some
    /// - `task`: NULL, or progress per layer; a cancel is honoured at every layer
    /// - `changed`: receives the number of layers that differ; may be NULL
    /// - `fault`: NULL, or filled on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no sink; SF_ERR_UNSUPPORTED: another
    ///   format; SF_ERR_SHAPE: other counts; SF_ERR_OVERFLOW: more than 4 GiB; SF_ERR_CANCELLED; as
    ///   sf_job_read(); or what the sink returned.
    /// - cost: each layer is decoded once, those that differ once more and encoded; a layer of
    ///   bytes and five of bits.
    /// - threads: one per job.
    /// - since: 0.1
    #[must_use]
    pub fn sf_job_rewrite(
        job: *mut sf_job,
        grid: *const sf_grid,
        sink: sf_sink,
        task: *mut sf_task,
        changed: *mut u32,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// The default settings: "job", 8 s, 35 s at first, 10 layers to fade.
    ///
    /// - returns: the settings, by value, with struct_size set.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_sl1_settings_default() -> sf_sl1_settings;

    /// Write a grid as a new SL1 job: config.ini, prusaslicer.ini with the display, a PNG a layer.
    ///
    /// - `grid`: the layers; all heights but the first must be one
    /// - `settings`: NULL for sf_sl1_settings_default()
    /// - `allocator`: for a picture at a time; NULL for the C library's
    /// - `sink`: where the bytes go; on failure it may have had some
    /// - `task`: NULL, or progress per layer; a cancel is honoured at every layer
    /// - `fault`: NULL, or filled on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no sink, settings that cannot be;
    ///   SF_ERR_UNSUPPORTED: layers of several heights, more than 65533, or a build without SL1;
    ///   SF_ERR_OVERFLOW: more than 4 GiB; SF_ERR_MEMORY; SF_ERR_CANCELLED; SF_ERR_INTERNAL; or
    ///   what the sink returned.
    /// - cost: one pass, mostly in the compressor.
    /// - threads: any that only read the grid.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sl1_write(
        grid: *const sf_grid,
        settings: *const sf_sl1_settings,
        allocator: *const sf_allocator,
        sink: sf_sink,
        task: *mut sf_task,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Begin to write layers.
    ///
    /// Pixels are nx by ny, x to the right and y upward, as in sf_stack_write(). Entry 0 of the
    /// palette is empty space, black and transparent; entry i + 1 is material i.
    ///
    /// - `folder`: where to; needs `begin` and `commit`, and must stay
    /// - `lattice`: where voxels lie; copied
    /// - `material_count`: 1..SF_MATERIAL_MAX
    /// - `materials`: the materials, in the order of ids; copied; names differ
    /// - `allocator`: for the object; NULL for the C library's
    /// - `layers`: receives the object
    /// - `fault`: NULL, or filled on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a lattice that cannot be, no materials or
    ///   too many, a name or density that cannot be; SF_ERR_UNSUPPORTED: a build without PNG;
    ///   SF_ERR_MEMORY.
    /// - cost: O(nz).
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_layers_begin(
        folder: sf_folder,
        lattice: *const sf_lattice,
        material_count: u32,
        materials: *const sf_material,
        allocator: *const sf_allocator,
        layers: *mut *mut sf_layers,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Write the next layer up: layer_00000.png and so on.
    ///
    /// - `layers`: the layers
    /// - `ids`: a byte a voxel, row 0 first: 0, or material + 1, as sf_materials has them
    /// - `stride`: bytes from one row to the next, at least nx
    /// - `fault`: NULL, or filled on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a stride that is too small, a material
    ///   that there is not, more layers than the lattice has; SF_ERR_MEMORY; SF_ERR_INTERNAL:
    ///   libspng refuses what it should take; or what the folder or its sinks returned.
    /// - cost: a pass, mostly in the compressor, which takes its memory from the C library.
    /// - threads: one for these layers.
    /// - since: 0.1
    #[must_use]
    pub fn sf_layers_add(
        layers: *mut sf_layers,
        ids: *const u8,
        stride: usize,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Write stack.json, when all layers are there.
    ///
    /// ```text
    /// {"format": "libsf-stack", "version": 3, "units": "mm", "lattice": as sf_stack_write() has it,
    ///  "rule": null,
    ///  "layers": {"pattern": "layer_%05u.png", "count": nz},
    ///  "materials": [{"index": 1, "name", "colour": "#rrggbb", "density_g_cm3" or null,
    ///                 "voxels", "volume_mm3", "grams" or null}, ...],
    ///  "solid": "not 0", "row_order": "top_is_max_y"}
    /// ```
    ///
    /// - `layers`: the layers
    /// - `uses`: NULL, or receives what of each material there is
    /// - `fault`: NULL, or filled on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: NULL, or layers are missing; or what the folder or its
    ///   sinks returned.
    /// - cost: O(nz).
    /// - threads: one for these layers.
    /// - since: 0.1
    #[must_use]
    pub fn sf_layers_finish(
        layers: *mut sf_layers,
        uses: *mut sf_material_use,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Free what layers hold; the folder is the caller's.
    ///
    /// - `layers`: the layers, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with these layers.
    /// - since: 0.1
    pub fn sf_layers_end(layers: *mut sf_layers);

    /// Prepare a cage for evaluation.
    ///
    /// - `cage`: the cage, not needed any more afterwards
    /// - `rules`: which rules inside
    /// - `allocator`: for the limit and for scratch; NULL for the C library's
    /// - `task`: progress, cancel; NULL for none
    /// - `limit`: receives the limit
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, rules that there are not;
    ///   SF_ERR_OVERFLOW: more points or corners than SF_CAGE_POINT_MAX after one step;
    ///   SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: some 10 microseconds for each piece, and a millisecond for each kind of irregular
    ///   neighbourhood; where n cells meet in a point or an edge time and memory grow with n^2: a
    ///   thousand take a tenth of a second, four thousand two seconds and 200 MB.
    /// - threads: any; one at a time for each allocator.
    /// - source: as sf_refine(); the left eigenvectors after M. Halstead, M. Kass, T. DeRose,
    ///   "Efficient, fair interpolation using Catmull-Clark surfaces", 1993; what comes of
    ///   irregular cells after J. Stam, "Exact evaluation of Catmull-Clark subdivision surfaces at
    ///   arbitrary parameter values", 1998, without his eigenvalues: by going down.
    /// - since: 0.1
    #[must_use]
    pub fn sf_limit_create(
        cage: *const sf_cage,
        rules: sf_refine_rules,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        limit: *mut *mut sf_limit,
    ) -> sf_status;

    /// Free a limit.
    ///
    /// - `limit`: the limit surface, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this limit.
    /// - since: 0.1
    pub fn sf_limit_destroy(limit: *mut sf_limit);

    /// Number of pieces: that of the corners of all cells; 0 for NULL.
    ///
    /// - `limit`: the limit surface; NULL has none
    /// - returns: the number.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_limit_piece_count(limit: *const sf_limit) -> usize;

    /// The place at parameters of a whole cell of the cage: a hexahedron, in dimension 2 a
    /// quadrilateral.
    ///
    /// - `limit`: the limit
    /// - `cell`: the cell
    /// - `u`: 0 to 1 along the axes from its first corner to its second, fourth and fifth; in
    ///   dimension 2 the third is not looked at
    /// - `place`: receives the place
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such cell, parameters outside of it;
    ///   SF_ERR_UNSUPPORTED: a cell of another kind, which has no axes: name its pieces.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_limit_place(
        limit: *const sf_limit,
        cell: usize,
        u: *const f64,
        place: *mut sf_place,
    ) -> sf_status;

    /// Where places lie.
    ///
    /// Parameters a little outside of 0 to 1, by 1e-9, are taken for those of the border. On an
    /// irregular edge or point derivatives by parameters tend to 0 or grow without bound; there
    /// they are those over a millionth of a piece next to it.
    ///
    /// - `limit`: the limit
    /// - `count`: how many places; may be 0
    /// - `places`: the places
    /// - `allocator`: for scratch; NULL for the C library's
    /// - `task`: threads; NULL for none; once begun it is not cancelled
    /// - `positions`: receives 3 numbers of each, mm
    /// - `derivatives`: NULL, or receives 9 of each, in dimension 2 6: of x by each parameter, then
    ///   of y, then of z
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a place that there is not; SF_ERR_MEMORY;
    ///   SF_ERR_CANCELLED.
    /// - cost: a third of a microsecond in regular pieces; elsewhere some 5 for each level, of
    ///   which random places need one or two and the worst ones 48.
    /// - threads: any, while nobody updates; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_limit_positions(
        limit: *const sf_limit,
        count: usize,
        places: *const sf_place,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        positions: *mut f64,
        derivatives: *mut f64,
    ) -> sf_status;

    /// What a property is at places.
    ///
    /// - `limit`: the limit
    /// - `channel`: which property
    /// - `count`: how many places; may be 0
    /// - `places`: the places
    /// - `allocator`: for scratch; NULL for the C library's
    /// - `task`: threads; NULL for none; once begun it is not cancelled
    /// - `values`: receives a number of each
    /// - `derivatives`: NULL, or receives 3 of each, in dimension 2 2: by each parameter
    /// - returns: as sf_limit_positions(); SF_ERR_ARGUMENT also: no such property.
    /// - cost: ,
    /// - threads: as sf_limit_positions().
    /// - since: 0.1
    #[must_use]
    pub fn sf_limit_values(
        limit: *const sf_limit,
        channel: usize,
        count: usize,
        places: *const sf_place,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        values: *mut f64,
        derivatives: *mut f64,
    ) -> sf_status;

    /// Look whether a shape of dimension 3 lies the right way out everywhere.
    ///
    /// - `limit`: the limit
    /// - `allocator`: for scratch; NULL for the C library's
    /// - `task`: progress, cancel; NULL for none
    /// - `report`: receives what was found
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_UNSUPPORTED: a limit of dimension
    ///   2; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: 50 microseconds for a regular piece, up to some milliseconds for others.
    /// - threads: any, while nobody updates; one at a time for each allocator.
    /// - source: A. Johnen, J.-F. Remacle, C. Geuzaine, "Geometrical validity of curvilinear finite
    ///   elements", 2013.
    /// - since: 0.1
    #[must_use]
    pub fn sf_limit_check(
        limit: *const sf_limit,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        report: *mut sf_limit_report,
    ) -> sf_status;

    /// Take new positions from the cage.
    ///
    /// - `limit`: the limit
    /// - `positions`: 3 for each of the cage's points, mm, finite and within 10^12
    /// - `task`: threads; NULL for none; is not cancelled
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a position that cannot be.
    /// - cost: one step of refinement.
    /// - threads: one for each limit.
    /// - since: 0.1
    #[must_use]
    pub fn sf_limit_update_positions(
        limit: *mut sf_limit,
        positions: *const f64,
        task: *mut sf_task,
    ) -> sf_status;

    /// Take new values of a property from the cage.
    ///
    /// - `limit`: the limit
    /// - `channel`: which property
    /// - `values`: as many as the property has in the cage, finite and within its bounds
    /// - `task`: threads; NULL for none; is not cancelled
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such property, a value that it does
    ///   not allow.
    /// - cost: one step of refinement.
    /// - threads: one for each limit.
    /// - since: 0.1
    #[must_use]
    pub fn sf_limit_update_values(
        limit: *mut sf_limit,
        channel: usize,
        values: *const f64,
        task: *mut sf_task,
    ) -> sf_status;

    /// Prepare a limit of dimension 3 for searches.
    ///
    /// - `limit`: the limit; it must stay, and its positions as they are, while the locator is used
    /// - `allocator`: for the locator and for scratch; NULL for the C library's
    /// - `locator`: receives the locator
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_UNSUPPORTED: a limit of dimension
    ///   2; SF_ERR_MEMORY.
    /// - cost: a microsecond for each piece.
    /// - threads: any, while nobody updates the limit; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_locator_create(
        limit: *const sf_limit,
        allocator: *const sf_allocator,
        locator: *mut *mut sf_locator,
    ) -> sf_status;

    /// Free a locator.
    ///
    /// - `locator`: the locator, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this locator.
    /// - since: 0.1
    pub fn sf_locator_destroy(locator: *mut sf_locator);

    /// Find the places of points.
    ///
    /// Of a point within the shape the place found lies within 1e-10 of the cage's diagonal of it.
    /// Where the shape overlaps itself it is any of them. Of a point outside the place found is
    /// near to the nearest one, if that is within reach. Where cells are folded flat, so that
    /// endlessly many places are equally near, the search ends after a hundred thousand tries: with
    /// the nearest seen, or none.
    ///
    /// - `locator`: the locator
    /// - `count`: how many points; may be 0
    /// - `points`: 3 numbers of each, mm, finite
    /// - `reach_mm`: how far outside of the shape a point may be, 0 and more
    /// - `allocator`: for scratch; NULL for the C library's
    /// - `task`: threads; NULL for none; once begun it is not cancelled
    /// - `places`: receives the places; their piece is SF_NO_PIECE where none is within reach
    /// - `distances`: NULL, or receives how far from the points they lie, mm; infinite where there
    ///   is none
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a reach that is no number of 0 or more, a
    ///   point that is not finite; SF_ERR_MEMORY; SF_ERR_CANCELLED: the task was cancelled before.
    /// - cost: some ten microseconds for each point; hundreds close to what is irregular, or
    ///   outside within reach; some hundreds of milliseconds at worst, where cells are folded flat.
    /// - threads: any, while nobody updates the limit; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_locator_find(
        locator: *const sf_locator,
        count: usize,
        points: *const f64,
        reach_mm: f64,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        places: *mut sf_place,
        distances: *mut f64,
    ) -> sf_status;

    /// Make a curve from samples in any order.
    ///
    /// Samples of equal x become their mean. Where the others contradict the trend they are
    /// replaced by the closest values that do not (least squares). Between them goes a cubic that
    /// is monotone and smooth to its first derivative; beyond the first and the last it is
    /// constant.
    ///
    /// - `samples`: count of them, finite, below 1e100 in size
    /// - `count`: at least 2 of different x, at most SF_CURVE_SAMPLE_MAX
    /// - `trend`: which way it goes
    /// - `allocator`: for the curve and for scratch; NULL for the C library's
    /// - `curve`: receives the curve
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such trend, too few samples, one that
    ///   is not finite or has no weight; SF_ERR_OVERFLOW: too many samples; SF_ERR_MEMORY.
    /// - cost: sorting the samples.
    /// - threads: any; one at a time for each allocator.
    /// - source: M. Ayer and others, "An empirical distribution function for sampling with
    ///   incomplete information", 1955 (pool adjacent violators); F. N. Fritsch, R. E. Carlson,
    ///   "Monotone piecewise cubic interpolation", 1980.
    /// - since: 0.1
    #[must_use]
    pub fn sf_curve_create(
        samples: *const sf_curve_sample,
        count: usize,
        trend: sf_trend,
        allocator: *const sf_allocator,
        curve: *mut *mut sf_curve,
    ) -> sf_status;

    /// Free a curve.
    ///
    /// - `curve`: the curve, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this curve.
    /// - since: 0.1
    pub fn sf_curve_destroy(curve: *mut sf_curve);

    /// The curve at x.
    ///
    /// - `curve`: the curve
    /// - `x`: anywhere
    /// - `y`: receives the value
    /// - `slope`: NULL, or receives the derivative; 0 beyond the ends
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, an x that is no number.
    /// - cost: a binary search.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_curve_value(
        curve: *const sf_curve,
        x: f64,
        y: *mut f64,
        slope: *mut f64,
    ) -> sf_status;

    /// Where the curve has a value: the least such x, or the end whose value is nearest.
    ///
    /// - `curve`: the curve
    /// - `y`: the wanted value
    /// - `x`: receives the place
    /// - `miss`: NULL, or receives the value there less the wanted one: 0 but for rounding where
    ///   the curve has it
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a y that is no number.
    /// - cost: a binary search and some ten evaluations.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_curve_inverse(
        curve: *const sf_curve,
        y: f64,
        x: *mut f64,
        miss: *mut f64,
    ) -> sf_status;

    /// How far the curve is from the sample that it had to leave the most; 0 for NULL.
    ///
    /// - `curve`: the curve; NULL gives 0
    /// - returns: a distance in y.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_curve_change(curve: *const sf_curve) -> f64;

    /// Span the space of fractions by simplices whose corners are the measured mixtures.
    ///
    /// The simplices are those of Delaunay; where that leaves a choice, as on a regular pattern, a
    /// fixed one is made. They fill the convex hull of what was measured, so measure the pure
    /// materials too.
    ///
    /// - `samples`: what was measured; copied. No two mixtures are closer than 0.001 in every
    ///   fraction, and they do not all lie in a plane (or on a line, or in a point)
    /// - `allocator`: NULL for the C library's
    /// - `mixture`: receives the object
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a count or a number out of range,
    ///   mixtures that are too close or too flat; SF_ERR_OVERFLOW: mixtures of which more than 2^22
    ///   simplices could be made: 256 of three materials, 101 of four, 57 of five, 40 of six can be
    ///   had; SF_ERR_MEMORY.
    /// - cost: all simplices that could be made are looked at: up to some seconds.
    /// - threads: any; one at a time for each allocator.
    /// - source: B. Delaunay, "Sur la sphere vide", 1934; K. Q. Brown, "Voronoi diagrams from
    ///   convex hulls", 1979.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mixture_create(
        samples: *const sf_mixture_samples,
        allocator: *const sf_allocator,
        mixture: *mut *mut sf_mixture,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Free a mixture.
    ///
    /// - `mixture`: the mixture, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this mixture.
    /// - since: 0.1
    pub fn sf_mixture_destroy(mixture: *mut sf_mixture);

    /// How many simplices there are.
    ///
    /// - `mixture`: the mixture; NULL has none
    /// - returns: the number; 0 for NULL.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_mixture_simplex_count(mixture: *const sf_mixture) -> usize;

    /// The corners of a simplex: as many measured mixtures as there are materials, in rising order.
    ///
    /// - `mixture`: the mixture
    /// - `simplex`: which, below sf_mixture_simplex_count()
    /// - `corners`: receives the numbers of the measured mixtures, as many as there are materials
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such simplex.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mixture_simplex(
        mixture: *const sf_mixture,
        simplex: usize,
        corners: *mut u32,
    ) -> sf_status;

    /// What properties a mixture has: forwards, from fractions.
    ///
    /// - `mixture`: what was measured
    /// - `fractions`: one for each material; those that lie in no simplex are replaced by the
    ///   nearest that do
    /// - `properties`: receives one number for each property
    /// - `miss`: NULL, or receives how far the fractions lay from the nearest: 0 within
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a fraction that is not finite.
    /// - cost: a small linear system for each simplex.
    /// - threads: any.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mixture_properties(
        mixture: *const sf_mixture,
        fractions: *const f64,
        properties: *mut f64,
        miss: *mut f64,
    ) -> sf_status;

    /// Which fractions have the wanted properties: backwards; or the nearest properties that some
    /// have.
    ///
    /// Errors are measured in scales of each property, squared and added. Where several mixtures do
    /// equally well it is one in the first simplex that holds one: fewer properties than materials
    /// less one leave such a choice.
    ///
    /// - `mixture`: what was measured
    /// - `wanted`: one number for each property
    /// - `hint`: NULL, or the simplex to look in first, which receives where the answer was: for
    ///   many points that lie together. Where several simplices have what is wanted, it decides;
    ///   any number will do to begin with.
    /// - `fractions`: receives one for each material: at least 0, of sum 1
    /// - `obtained`: NULL, or receives the properties of that mixture
    /// - `miss`: NULL, or receives the distance of these from the wanted, in scales
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a wanted property that is not finite.
    /// - cost: a small linear system where the hint is right, else up to one for each face of each
    ///   simplex.
    /// - threads: any; one at a time for each hint.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mixture_fractions(
        mixture: *const sf_mixture,
        wanted: *const f64,
        hint: *mut usize,
        fractions: *mut f64,
        obtained: *mut f64,
        miss: *mut f64,
    ) -> sf_status;

    /// Options of a search for orientations, each at its default.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_orient_options_default() -> sf_orient_options;

    /// Find the ways up in which a part prints best, the best one first.
    ///
    /// Three rounds. Directions over the sphere are ranked by the area that hangs over and by
    /// height; the best coarse_count of them, the axes and the large flat faces by their score at
    /// the coarse resolution; the best fine_count of those, and the mesh as it is given, by their
    /// score at the fine one. Of equal scores the one with less unsupported area is better, then
    /// the one that was thought of earlier: the way it is given, the other axes, the large flat
    /// faces, the sphere. So the result is one and the same everywhere, with any number of threads;
    /// and it is never worse than the mesh as it is given.
    ///
    /// What touches the bed is the lowest layer of voxels; the centre of mass is that of the
    /// voxels.
    ///
    /// - `mesh`: vertices in mm, with triangles
    /// - `options`: NULL for the default
    /// - `allocator`: for scratch: 24 bytes a vertex and 24 a triangle, 152 a direction, a grid and
    ///   what sf_grid_voxelize() takes; NULL for the C library's
    /// - `task`: NULL, or progress, cancel and threads
    /// - `orientations`: receives the best ones
    /// - `capacity`: places in it
    /// - `count`: receives how many: fine_count, or fewer where so many were not looked at; on
    ///   SF_ERR_CAPACITY, fine_count
    /// - `given`: NULL, or receives the same figures for the mesh as it is given
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options out of range or without their
    ///   struct_size, an angle that sf_rule_make() refuses, what sf_mesh_validate() refuses, a mesh
    ///   without triangles or without extent; SF_ERR_CAPACITY: less than fine_count places;
    ///   SF_ERR_UNSUPPORTED: a rule that does not serve cubes at this angle, a mesh that the
    ///   voxeliser refuses; SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: direction_count passes over the mesh; coarse_count + fine_count times voxels and a
    ///   trim.
    /// - threads: any; the task's hook may run up to 64 pieces at once.
    /// - source: the spread of directions is R. Swinbank, R. J. Purser, "Fibonacci grids: A novel
    ///   approach to global modelling", 2006; the cheap score is that of C. Schranz, "Tweaker -
    ///   Auto Rotation Module for FDM 3D Printing", 2016, without its weights.
    /// - since: 0.1
    #[must_use]
    pub fn sf_mesh_orient(
        mesh: sf_mesh_view,
        options: *const sf_orient_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        orientations: *mut sf_orientation,
        capacity: usize,
        count: *mut usize,
        given: *mut sf_orientation,
    ) -> sf_status;

    /// A ball of radius 1 about the origin, smooth.
    ///
    /// - returns: the brush, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_paint_brush_default() -> sf_paint_brush;

    /// Add to a selection what a brush touches: each weight becomes the greater of itself and the
    /// brush's.
    ///
    /// - `cage`: the cage
    /// - `brush`: the brush
    /// - `weights`: one for each point of the cage, 0 to 1
    /// - `touched`: NULL, or receives how many points the brush gives a weight above 0
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a brush or weight out of range.
    /// - cost: O(points).
    /// - threads: any, while nobody changes the cage.
    /// - source: C. Altenhofen and others, "Continuous property gradation for multi-material
    ///   3D-printed objects", 2018, "Interaction techniques".
    /// - since: 0.1
    #[must_use]
    pub fn sf_paint_select(
        cage: *const sf_cage,
        brush: *const sf_paint_brush,
        weights: *mut f64,
        touched: *mut usize,
    ) -> sf_status;

    /// Change values of a property.
    ///
    /// What would leave the property's bounds stays at them.
    ///
    /// A value that corners name has the greatest weight of the points where it is named; its
    /// neighbours are the values at the other ends of edges, on its own side of a jump.
    ///
    /// - `cage`: the cage; on failure it is as it was
    /// - `channel`: which property
    /// - `weights`: one for each point, 0 to 1
    /// - `operation`: what is done
    /// - `amount`: by how much
    /// - `allocator`: for scratch; NULL for the C library's
    /// - `changed`: NULL, or receives how many values are not what they were
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such property or operation, a weight
    ///   or amount out of range or not finite; SF_ERR_MEMORY.
    /// - cost: O(points and edges).
    /// - threads: one for each cage.
    /// - since: 0.1
    #[must_use]
    pub fn sf_paint_values(
        cage: *mut sf_cage,
        channel: usize,
        weights: *const f64,
        operation: sf_paint_operation,
        amount: f64,
        allocator: *const sf_allocator,
        changed: *mut usize,
    ) -> sf_status;

    /// Move points, each by its weight times a vector.
    ///
    /// - `cage`: the cage; on failure it is as it was
    /// - `weights`: one for each point, 0 to 1
    /// - `vector_mm`: the vector
    /// - `allocator`: for scratch; NULL for the C library's
    /// - `changed`: NULL, or receives how many points are not where they were
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a weight out of range, a point that would
    ///   lie beyond 10^12 mm; SF_ERR_MEMORY.
    /// - cost: O(points).
    /// - threads: one for each cage.
    /// - since: 0.1
    #[must_use]
    pub fn sf_paint_move(
        cage: *mut sf_cage,
        weights: *const f64,
        vector_mm: *const f64,
        allocator: *const sf_allocator,
        changed: *mut usize,
    ) -> sf_status;

    /// Move points towards the means of their neighbours along edges; those on the boundary towards
    /// neighbours on the boundary only, so that an outside does not shrink into its inside.
    ///
    /// - `cage`: the cage; on failure it is as it was
    /// - `weights`: one for each point, 0 to 1
    /// - `amount`: how far, 0 to 1
    /// - `allocator`: for scratch; NULL for the C library's
    /// - `changed`: NULL, or receives how many points are not where they were
    /// - returns: as sf_paint_move().
    /// - cost: O(points and edges).
    /// - threads: one for each cage.
    /// - since: 0.1
    #[must_use]
    pub fn sf_paint_smooth(
        cage: *mut sf_cage,
        weights: *const f64,
        amount: f64,
        allocator: *const sf_allocator,
        changed: *mut usize,
    ) -> sf_status;

    /// A support-free part of a shape that holds what must stay.
    ///
    /// From the top down, each layer asks the one below for what its voxels need: first of what
    /// must stay there anyway, then of as few others as a greedy set cover finds. Of equals the
    /// lowest row is taken, and in it the lowest x.
    ///
    /// - `shape`: support-free, apart from exempt voxels
    /// - `needed`: what must stay, within the shape
    /// - `terms`: rule, bed layer and exempt voxels; the other masks are not looked at. With
    ///   SF_BED_AUTO the bed is the first layer that holds matter in `shape`
    /// - `allocator`: for working memory: a grid, a dozen slices, 4 bytes for each voxel of a
    ///   slice, and under slack 4 \* sqrt(nz) + 4 slices with a byte for each; NULL for the C
    ///   library's
    /// - `task`: NULL, or progress per slice; a cancel is honoured at every slice
    /// - `result`: of the same counts, and neither of the other grids nor a mask
    /// - returns: SF_OK; SF_ERR_INFEASIBLE: `needed` is not within `shape`, or `shape` is not
    ///   support-free (sf_grid_feasible(shape, shape, ...) names the voxels); SF_ERR_ARGUMENT,
    ///   SF_ERR_SHAPE, SF_ERR_MEMORY, SF_ERR_CANCELLED: as sf_grid_feasible().
    /// - cost: some twenty passes over the grid, under slack five trims, and for each voxel that
    ///   may carry what hangs the element and a few steps of a heap. 512^3 under box3: 60 ms.
    /// - threads: any that write distinct results.
    /// - source: P. Slavik, "A tight analysis of the greedy algorithm for set cover", 1996
    ///   (greedy); that one sweep serves every monotone rule is the library's own.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_complete(
        shape: *const sf_grid,
        needed: *const sf_grid,
        terms: *const sf_terms,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        result: *mut sf_grid,
    ) -> sf_status;

    /// Options of preserve: fast, nothing that must go, unsupported shapes refused.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_preserve_options_default() -> sf_preserve_options;

    /// Remove a brush, and keep of it what carries the rest: nothing outside the brush changes.
    ///
    /// What counts as the brush is solid in `brush`, lies where the terms let an operator act, and
    /// is not to be kept. The shape must be support-free apart from exempt voxels, and then is
    /// after it; matter that was accepted as unsupported before the edit stays accepted, be it by
    /// the terms or by accept_unsupported. Voxels that must go are feasible just when what is
    /// outside the brush lies within trim(shape without them).
    ///
    /// - `grid`: the shape, changed in place
    /// - `brush`: a grid of the same counts, only read; not `grid`
    /// - `terms`: rule, bed layer and masks: `act` and `keep` bound the brush; `forbid` bounds what
    ///   the paper's text adds. With SF_BED_AUTO the bed is the first layer that holds matter
    ///   before the edit
    /// - `options`: NULL for the default
    /// - `allocator`: for working memory: in mode fast some bits for each voxel of the brush's box,
    ///   else as sf_grid_complete() and two grids, under slack a byte for each voxel in mode
    ///   irredundant; NULL for the C library's
    /// - `task`: NULL, or progress; a cancel is honoured at every slice, and nothing is written
    ///   before all is known
    /// - `report`: counts, or NULL
    /// - returns: SF_OK; SF_ERR_INFEASIBLE: the shape is not support-free, or something outside the
    ///   brush cannot stay without what must go (sf_grid_feasible() names the voxels), and the
    ///   shape is as it was; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size or
    ///   with values outside their range, a grid that is given twice; and what sf_grid_feasible()
    ///   says.
    /// - cost: fast: the volume of the brush's box times the element, and a pass over the grid
    ///   unless known_support_free and brush_box spare it; else as sf_grid_complete(). Irredundant
    ///   under slack and with bridges: also, for each voxel that was kept first, what its loss
    ///   changes above it, up to where something dies: under slack the element for each voxel that
    ///   falls, with bridges a window of their reach as well. A ball in 256^3 hollowed under slack,
    ///   10^5 voxels tried: 0.35 s; with bridges over 3 voxels 2 s.
    /// - threads: one per grid.
    /// - source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for
    ///   Fabrication", Eurographics 2016, sections 2.2 and 3.2 (the operator and both paper modes;
    ///   as printed it deletes what it should keep).
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_preserve(
        grid: *mut sf_grid,
        brush: *const sf_grid,
        terms: *const sf_terms,
        options: *const sf_preserve_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        report: *mut sf_preserve_report,
    ) -> sf_status;

    /// Options of a look at printing, each at its default.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_printing_options_default() -> sf_printing_options;

    /// How far from toppling a part is, after each of its layers.
    ///
    /// For every layer k from the bed up, take what is solid from the bed to k, and each connected
    /// piece of it that has voxels in the bed layer. It stands on the convex hull of its voxels'
    /// squares there; its margin is the least angle by which the bed must be tilted for its centre
    /// of mass to pass over an edge of that hull. All voxels have one density, each layer its own
    /// height. The margin of layer k is the least over the pieces; below the bed, and where no
    /// piece has voxels on the bed, it is 90 degrees.
    ///
    /// Pieces that float are counted, and do not count in margins until they are connected with one
    /// that stands; sf_grid_check() says more about them.
    ///
    /// Sums are integers: with layers of one height the centre of mass is exact before its last
    /// division; heights of layers are rounded to 2^-40 of the whole, and up to it where they are
    /// less.
    ///
    /// - `grid`: the voxels, only read
    /// - `options`: NULL for the default
    /// - `allocator`: for scratch: the runs of two layers, and a record of some 200 bytes for each
    ///   piece of a layer and each on the bed; NULL for the C library's
    /// - `task`: NULL, or progress and cancel, which is heeded at every layer
    /// - `report`: receives the report
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, no
    ///   such connectivity, a bed_layer that the grid does not have; SF_ERR_CAPACITY: fewer places
    ///   for margins than the grid has layers; SF_ERR_OVERFLOW: more than UINT32_MAX runs in a
    ///   layer, or pieces; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: nearly linear in the runs of all layers, and, for each layer, in the pieces on the
    ///   bed.
    /// - threads: any; one at a time for each allocator.
    /// - source: the margin: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It
    ///   Stand", 2013, section 3; the pieces: R. E. Tarjan, "Efficiency of a Good But Not Linear
    ///   Set Union Algorithm", 1975.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_printing(
        grid: *const sf_grid,
        options: *const sf_printing_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        report: *mut sf_printing_report,
    ) -> sf_status;

    /// Options of a repair: terms by default, every change costs 1, no least width, as good as it
    /// gets.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_repair_options_default() -> sf_repair_options;

    /// Make a shape support-free at a low cost, in place.
    ///
    /// What must stay are the solid voxels of `keep` and those outside `act`; what may be added
    /// lies in `act`, not in `forbid`, and not below the bed. Where all that must stay can be
    /// carried within that, the result is support-free under the whole rule (bridges included),
    /// holds what must stay, and costs no more than a trim, where a trim may be done, nor than
    /// keeping everything that can be kept along the same supporters. A support-free shape is left
    /// as it is. The result was checked before it was written.
    ///
    /// Nor does it cost more than what sf_grid_grow() makes under the same terms, with two
    /// exceptions: a least width or SF_REPAIR_FIRST; and more than 2^26 voxels from the bed up,
    /// unless the first result costs more than a 64th of the number of voxels that a trim removes.
    ///
    /// Nor does it cost more than the same repair with `keep` the whole shape, where that is
    /// possible, with two exceptions: SF_REPAIR_FIRST, or a least width under slack or with
    /// bridges; and more than four million voxels in the air.
    ///
    /// With a least width, additions are squares of that width whose chains of squares stand on
    /// squares of what is kept; single voxels only where neither fits. Under slack such chains then
    /// take only steps that use up no reach.
    ///
    /// - `grid`: the shape, changed in place
    /// - `options`: terms, costs, width
    /// - `allocator`: for working memory: NULL for the C library's
    /// - `task`: NULL, or progress; a cancel is honoured at every layer of every sweep, and within
    ///   layers where one takes long; no report comes after it but that of the layer that was at
    ///   work
    /// - `culprits`: NULL, or a grid that is set, on SF_ERR_INFEASIBLE, to the voxels that must
    ///   stay and cannot; giving up just these, or exempting them, makes the rest possible
    /// - `report`: NULL, or where counts are left; on SF_ERR_INFEASIBLE only the number of
    ///   culprits, the bed and the memory are
    /// - returns: SF_OK; SF_ERR_INFEASIBLE: what must stay cannot, and the shape is as it was;
    ///   SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, a cost of 0, a width
    ///   outside 1..SF_REACH_MAX, terms as in sf_grid_feasible(), one grid given twice;
    ///   SF_ERR_SHAPE: grids that differ in counts; SF_ERR_MEMORY; SF_ERR_OVERFLOW: a slice of 2^32
    ///   voxels or more, its border included; SF_ERR_CANCELLED; SF_ERR_INTERNAL: the result failed
    ///   its check, and the shape is as it was.
    /// - cost: a few sweeps over the grid, 2 bytes for each voxel of the rectangles that the
    ///   unsupported matter reaches downward (4 under slack), and time by what is unsupported, a
    ///   reach's area for each voxel of it and again for each round; where grow is asked, what that
    ///   costs. What could take longer is bounded (docs/repair.md).
    /// - threads: one per grid.
    /// - source: a library's own; T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free
    ///   Shapes for Fabrication", Eurographics 2016, for its two ends, trim and grow.
    /// - since: 0.1
    #[must_use]
    pub fn sf_grid_repair(
        grid: *mut sf_grid,
        options: *const sf_repair_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        culprits: *mut sf_grid,
        report: *mut sf_repair_report,
    ) -> sf_status;

    /// A box that holds the shape of a limit of dimension 3, and is hardly larger.
    ///
    /// - `limit`: the limit
    /// - `allocator`: for scratch; NULL for the C library's
    /// - `task`: progress, cancel; NULL for none
    /// - `low_mm`: receives the lower corner
    /// - `high_mm`: receives the upper one: no side is farther from the shape than a thousandth of
    ///   the box's diagonal, unless the shape is very coarsely bent
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_UNSUPPORTED: a limit of dimension
    ///   2, or one without a boundary; SF_ERR_OVERFLOW: a surface of too many triangles;
    ///   SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: a microsecond or two for each vertex of the surface.
    /// - threads: any, while nobody updates the limit; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_limit_bounds(
        limit: *const sf_limit,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        low_mm: *mut f64,
        high_mm: *mut f64,
    ) -> sf_status;

    /// A twentieth of a voxel.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_sample_options_default() -> sf_sample_options;

    /// Prepare a limit of dimension 3 to be sliced.
    ///
    /// - `limit`: the limit; it must stay, and be as it is, while the sampler is used
    /// - `lattice`: where voxels lie, in the cage's frame; copied
    /// - `options`: NULL for the defaults
    /// - `channel_count`: how many properties are wanted; may be 0, at most SF_PROPERTY_MAX
    /// - `channels`: which ones
    /// - `allocator`: for the sampler and for scratch; NULL for the C library's
    /// - `task`: progress, cancel; NULL for none
    /// - `sampler`: receives the sampler
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a lattice or option out of range, no such
    ///   property; SF_ERR_UNSUPPORTED: a limit of dimension 2 or without a boundary, a shape that
    ///   lies too far from the lattice's origin; SF_ERR_OVERFLOW: more than SF_SAMPLE_VOXEL_MAX
    ///   voxels, or a surface of too many triangles; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: a microsecond or two for each vertex of the surface; 40 MB for splines that are
    ///   kept, and as much for each further property that jumps.
    /// - threads: any, while nobody updates the limit; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sampler_create(
        limit: *const sf_limit,
        lattice: *const sf_lattice,
        options: *const sf_sample_options,
        channel_count: usize,
        channels: *const usize,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        sampler: *mut *mut sf_sampler,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Prepare tetrahedra to be sliced: the way by which a file comes that holds no cage.
    ///
    /// A voxel is solid where the winding number of the tetrahedra's boundary about its centre is
    /// at least one half, and has what is interpolated between the corners of the first tetrahedron
    /// that holds its centre; where rounding leaves it in none, what the next voxel in its row has,
    /// or the nearest tetrahedron. Slices are made as from a limit, by sf_sampler_slice().
    ///
    /// - `tets`: the tetrahedra; they must stay, and be as they are, while the sampler is used
    /// - `lattice`: where voxels lie, in their frame; copied
    /// - `channel_count`: how many properties are wanted; may be 0, at most SF_PROPERTY_MAX
    /// - `channels`: which ones
    /// - `allocator`: for the sampler and for scratch; NULL for the C library's
    /// - `sampler`: receives the sampler
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: as sf_sampler_create(), but never SF_ERR_CANCELLED.
    /// - cost: linear in tetrahedra and layers.
    /// - threads: any; one at a time for each allocator.
    /// - source: C. Altenhofen and others, "Continuous property gradation for multi-material
    ///   3D-printed objects", 2018, "Volumetric slicing", with properties interpolated within
    ///   tetrahedra.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sampler_of_tets(
        tets: *const sf_tets,
        lattice: *const sf_lattice,
        channel_count: usize,
        channels: *const usize,
        allocator: *const sf_allocator,
        sampler: *mut *mut sf_sampler,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Free a sampler.
    ///
    /// - `sampler`: the sampler, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this sampler.
    /// - since: 0.1
    pub fn sf_sampler_destroy(sampler: *mut sf_sampler);

    /// The surface by which voxels are solid: closed triangles, outwards.
    ///
    /// - `sampler`: the sampler; NULL gives a view of nothing
    /// - `error_mm`: NULL, or receives how far it may be from the limit surface, mm
    /// - returns: a view, valid until the sampler is destroyed.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_sampler_surface(sampler: *const sf_sampler, error_mm: *mut f64) -> sf_mesh_view;

    /// A slice.
    ///
    /// The same bytes whichever slices were asked for before.
    ///
    /// - `sampler`: the sampler
    /// - `k`: which layer
    /// - `solid`: of the lattice's nx and ny: receives what is solid
    /// - `values`: channel_count planes of nx \* ny numbers, rows one after the other: receive the
    ///   properties of solid voxels, and 0 elsewhere; may be NULL where there are none
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such layer; SF_ERR_SHAPE: a slice of
    ///   another size; SF_ERR_MEMORY.
    /// - cost: a third of a microsecond for each solid voxel; of tetrahedra a tenth for each of
    ///   those that the slice meets.
    /// - threads: one for each sampler.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sampler_slice(
        sampler: *mut sf_sampler,
        k: u32,
        solid: sf_slice,
        values: *const *mut f64,
    ) -> sf_status;

    /// What became of the voxels so far.
    ///
    /// - `sampler`: the sampler
    /// - `report`: receives the report
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer.
    /// - cost: constant.
    /// - threads: any, while nobody slices.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sampler_report(
        sampler: *const sf_sampler,
        report: *mut sf_sample_report,
    ) -> sf_status;

    /// Make a tip by formula: the voxels whose centres lie in the shape, its centre on a voxel's
    /// centre.
    ///
    /// The anchor is the middle voxel, which is always covered.
    ///
    /// - `shape`: which
    /// - `radius_vx`: half its extents along x, y and z, in voxels; each 0 to 1024
    /// - `allocator`: for the tip; NULL for the C library's
    /// - `tip`: the tip
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such shape, a radius outside its range
    ///   or not a number; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
    /// - cost: the voxels of the box around it.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_tip_create(
        shape: sf_tip_shape,
        radius_vx: *const f64,
        allocator: *const sf_allocator,
        tip: *mut *mut sf_tip,
    ) -> sf_status;

    /// Make a tip of any mask: its solid voxels.
    ///
    /// A mesh becomes a tip by way of sf_grid_voxelize() on the model's pitch and layer height.
    ///
    /// - `mask`: a grid of any size; only its voxels count, not where its lattice lies
    /// - `anchor`: its voxel that comes to lie on each dab; may lie outside it
    /// - `allocator`: for the tip; NULL for the C library's
    /// - `tip`: the tip
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, an anchor beyond 2^30, a mask without
    ///   solid voxels; SF_ERR_OVERFLOW: a mask larger than 4096 voxels along an axis;
    ///   SF_ERR_MEMORY.
    /// - cost: a pass over the mask.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_tip_create_mask(
        mask: *const sf_grid,
        anchor: sf_dab,
        allocator: *const sf_allocator,
        tip: *mut *mut sf_tip,
    ) -> sf_status;

    /// Make a stamp of an image of heights: above pixel (x, y) as many voxels as its value says.
    ///
    /// Pixel values 0 to 255 stand for 0 to depth_vx voxels, rounded to the nearest. The anchor
    /// lies in the lowest layer, in the middle of the image.
    ///
    /// - `heights`: the pixel of voxel (0, 0), then those along x
    /// - `row_bytes`: bytes from one row to the next, at least the width
    /// - `width`: pixels along x, 1 to 4096
    /// - `height`: rows, 1 to 4096
    /// - `depth_vx`: voxels that 255 stands for, 1 to 4096
    /// - `allocator`: for the tip; NULL for the C library's
    /// - `tip`: the tip
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a size outside its range, rows that are
    ///   too short, an image that is 0 or rounds to it everywhere; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
    /// - cost: the voxels of the box around it.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_tip_create_stamp(
        heights: *const u8,
        row_bytes: usize,
        width: u32,
        height: u32,
        depth_vx: u32,
        allocator: *const sf_allocator,
        tip: *mut *mut sf_tip,
    ) -> sf_status;

    /// The mask of a tip, and its anchor in it.
    ///
    /// - `tip`: the tip; NULL has none
    /// - `anchor`: the anchor's place in the mask; may be NULL
    /// - returns: the mask, which lives as long as the tip; NULL for NULL.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_tip_mask(tip: *const sf_tip, anchor: *mut sf_dab) -> *const sf_grid;

    /// Free a tip.
    ///
    /// - `tip`: the tip, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this tip.
    /// - since: 0.1
    pub fn sf_tip_destroy(tip: *mut sf_tip);

    /// Name of a kind of brush, as a person reads and types it: "add-trim", "remove-preserve".
    ///
    /// - `kind`: any value; one that is no kind has no name
    /// - returns: a static string; NULL for one that is no kind.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_brush_kind_name(kind: sf_brush_kind) -> *const c_char;

    /// A brush without a tip: add-trim, material 1, one pass, no mirrors.
    ///
    /// - returns: the brush, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_brush_default() -> sf_brush;

    /// Options of a model: those of the paper.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_sculpt_options_default() -> sf_sculpt_options;

    /// Make an empty model.
    ///
    /// - `options`: lattice, rule and bed
    /// - `allocator`: for all that the model will ever need: for each voxel two bytes and some six
    ///   bits, one more where ghosts are kept, more where a rule has slack or bridges, and the
    ///   history; NULL for the C library's
    /// - `model`: the model
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, a bed
    ///   layer that the lattice has not, a rule that does not serve all its layers; what
    ///   sf_lattice_validate() says; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
    /// - cost: a pass over new memory.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sculpt_create(
        options: *const sf_sculpt_options,
        allocator: *const sf_allocator,
        model: *mut *mut sf_sculpt,
    ) -> sf_status;

    /// Free a model.
    ///
    /// - `model`: the model, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this model.
    /// - since: 0.1
    pub fn sf_sculpt_destroy(model: *mut sf_sculpt);

    /// The options that a model was made with; its lattice's heights belong to the model.
    ///
    /// - `model`: the model, not NULL
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_sculpt_options_of(model: *const sf_sculpt) -> sf_sculpt_options;

    /// What prints without supports, T; during a stroke as far as the stroke has come.
    ///
    /// - `model`: the model; NULL has none
    /// - returns: the grid, which lives as long as the model and must not be written; NULL for
    ///   NULL.
    /// - cost: constant.
    /// - threads: any, while no call changes the model.
    /// - since: 0.1
    pub fn sf_sculpt_printable(model: *const sf_sculpt) -> *const sf_grid;

    /// What is drawn, D: T and the ghosts.
    ///
    /// - `model`: the model; NULL has none
    /// - returns: as sf_sculpt_printable(); NULL for NULL.
    /// - cost: constant.
    /// - threads: any, while no call changes the model.
    /// - since: 0.1
    pub fn sf_sculpt_drawn(model: *const sf_sculpt) -> *const sf_grid;

    /// Materials of all voxels in (layer, y, x) order, a byte each: 0 where nothing is drawn.
    ///
    /// - `model`: the model; NULL has none
    /// - returns: the first of nz \* ny \* nx bytes, which live as long as the model; NULL for
    ///   NULL.
    /// - cost: constant.
    /// - threads: any, while no call changes the model.
    /// - since: 0.1
    pub fn sf_sculpt_materials(model: *const sf_sculpt) -> *const u8;

    /// Begin a stroke; the model is not changed before it has dabs.
    ///
    /// - `model`: no stroke under way
    /// - `brush`: copied
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a brush without its struct_size or tip or
    ///   with values outside their range, a stroke under way; under slack and with bridges,
    ///   add-grow only: SF_ERR_MEMORY.
    /// - cost: constant; add-grow under a rule with slack, a trim.
    /// - threads: one per model.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sculpt_begin(model: *mut sf_sculpt, brush: *const sf_brush) -> sf_status;

    /// Put the brush on more places in the stroke that is under way.
    ///
    /// - `model`: a stroke under way
    /// - `dabs`: where; may be NULL where count is 0
    /// - `count`: how many
    /// - `change`: what changed; may be NULL, which saves counting
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no stroke under way, a dab beyond 2^30:
    ///   the stroke is as it was, and goes on; SF_ERR_MEMORY: what was set aside does not suffice,
    ///   which a rule with slack or bridges can meet: the stroke is given up, as by
    ///   sf_sculpt_abandon().
    /// - cost: add-trim, remove-trim, paint: the new tips' boxes and what changes above them; the
    ///   others: the box around the whole stroke; add-grow also a search for each dab. Under a rule
    ///   with slack a trim.
    /// - threads: one per model.
    /// - source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for
    ///   Fabrication", Eurographics 2016, sections 2.2 and 3.2 (the brushes); one union for a
    ///   stroke, and that add-grow carries all of its tips, are the library's own.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sculpt_dab(
        model: *mut sf_sculpt,
        dabs: *const sf_dab,
        count: usize,
        change: *mut sf_sculpt_change,
    ) -> sf_status;

    /// End the stroke that is under way: it becomes one step of the history, unless it changed
    /// nothing.
    ///
    /// The oldest steps are forgotten where the history's memory asks for it. A step that does not
    /// fit at all is done and cannot be undone, and all before it are forgotten.
    ///
    /// - `model`: a stroke under way
    /// - `change`: what this call changed (ghosts that go), and the stroke's counts; may be NULL
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no stroke under way.
    /// - cost: the box around all that the stroke changed.
    /// - threads: one per model.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sculpt_end(model: *mut sf_sculpt, change: *mut sf_sculpt_change) -> sf_status;

    /// Give up the stroke that is under way: the model is as it was before it.
    ///
    /// - `model`: with no stroke under way nothing happens
    /// - `change`: the boxes that this call changed; may be NULL
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL model.
    /// - cost: the box around all that the stroke changed.
    /// - threads: one per model.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sculpt_abandon(model: *mut sf_sculpt, change: *mut sf_sculpt_change) -> sf_status;

    /// A whole stroke: begin, dab, end.
    ///
    /// A call that fails leaves the model as it was.
    ///
    /// - `model`: no stroke under way
    /// - `brush`: the brush
    /// - `dabs`: where; may be NULL where count is 0
    /// - `count`: how many
    /// - `change`: what changed; its boxes are those of the three calls together, with what was
    ///   drawn and went again as a ghost; may be NULL
    /// - returns: as sf_sculpt_begin() and sf_sculpt_dab().
    /// - cost: as these.
    /// - threads: one per model.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sculpt_stroke(
        model: *mut sf_sculpt,
        brush: *const sf_brush,
        dabs: *const sf_dab,
        count: usize,
        change: *mut sf_sculpt_change,
    ) -> sf_status;

    /// The dabs from one to another, a voxel apart: the digital line between them.
    ///
    /// The line has max(|dx|, |dy|, |dz|) steps; each dab is the nearest to the straight line,
    /// halves rounded away from `from`.
    ///
    /// - `from`: the first
    /// - `to`: the last
    /// - `dabs`: may be NULL where capacity is 0
    /// - `capacity`: places in the array
    /// - `count`: how many there are, both ends counted
    /// - returns: SF_OK; SF_ERR_CAPACITY: too few places, with `count` set; SF_ERR_ARGUMENT: a NULL
    ///   pointer, a dab beyond 2^30.
    /// - cost: linear.
    /// - threads: any.
    /// - source: J. E. Bresenham, "Algorithm for computer control of a digital plotter", 1965.
    /// - since: 0.1
    #[must_use]
    pub fn sf_dab_line(
        from: sf_dab,
        to: sf_dab,
        dabs: *mut sf_dab,
        capacity: usize,
        count: *mut usize,
    ) -> sf_status;

    /// Put another shape in place of what is drawn: one step of the history.
    ///
    /// - `model`: no stroke under way
    /// - `drawn`: the new D, of the model's counts; not a grid of the model; NULL: empty
    /// - `materials`: a byte for each voxel in (layer, y, x) order, looked at where drawn is solid,
    ///   where 0 counts as 1; NULL: all 1
    /// - `change`: what changed; may be NULL
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL model, a stroke under way, a grid of the model;
    ///   SF_ERR_SHAPE: other counts; SF_ERR_MEMORY: as sf_sculpt_dab().
    /// - cost: a trim, and some passes over the grid.
    /// - threads: one per model.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sculpt_replace(
        model: *mut sf_sculpt,
        drawn: *const sf_grid,
        materials: *const u8,
        change: *mut sf_sculpt_change,
    ) -> sf_status;

    /// Let the ghosts go: D becomes T.
    ///
    /// One step of the history where there were any.
    ///
    /// - `model`: no stroke under way
    /// - `change`: what changed; may be NULL
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL model, a stroke under way.
    /// - cost: some passes over the grid.
    /// - threads: one per model.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sculpt_drop_ghosts(model: *mut sf_sculpt, change: *mut sf_sculpt_change) -> sf_status;

    /// What the history of a model holds; the model must not be NULL.
    ///
    /// - `model`: the model, not NULL
    /// - returns: the counts, by value.
    /// - cost: constant.
    /// - threads: any, while no call changes the model.
    /// - since: 0.1
    pub fn sf_sculpt_history_of(model: *const sf_sculpt) -> sf_sculpt_history;

    /// Take back the last step: D, T and materials are what they were before it, bit for bit.
    ///
    /// - `model`: no stroke under way
    /// - `change`: what changed; its counts say what this step adds and removes; may be NULL
    /// - returns: SF_OK; SF_ERR_INFEASIBLE: there is no step to take back; SF_ERR_ARGUMENT: a NULL
    ///   model, a stroke under way.
    /// - cost: the step's size.
    /// - threads: one per model.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sculpt_undo(model: *mut sf_sculpt, change: *mut sf_sculpt_change) -> sf_status;

    /// Do again what was taken back last, unless something else was done since.
    ///
    /// - `model`: no stroke under way
    /// - `change`: as in sf_sculpt_undo()
    /// - returns: SF_OK; SF_ERR_INFEASIBLE: there is nothing to do again; SF_ERR_ARGUMENT as
    ///   sf_sculpt_undo().
    /// - cost: the step's size.
    /// - threads: one per model.
    /// - since: 0.1
    #[must_use]
    pub fn sf_sculpt_redo(model: *mut sf_sculpt, change: *mut sf_sculpt_change) -> sf_status;

    /// Options of a session: those of sf_sculpt_options_default().
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_session_options_default() -> sf_session_options;

    /// Make a session without steps.
    ///
    /// - `options`: the space
    /// - `allocator`: for the session; NULL for the C library's
    /// - `session`: the session
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, a
    ///   lattice with heights, a bed layer that it has not; what sf_lattice_validate() and
    ///   sf_rule_make() say; SF_ERR_MEMORY.
    /// - cost: constant.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_session_create(
        options: *const sf_session_options,
        allocator: *const sf_allocator,
        session: *mut *mut sf_session,
    ) -> sf_status;

    /// Free a session and its tips.
    ///
    /// - `session`: the session, freed; NULL does nothing
    /// - cost: linear.
    /// - threads: one, and nobody else with this session.
    /// - since: 0.1
    pub fn sf_session_destroy(session: *mut sf_session);

    /// The space of a session.
    ///
    /// - `session`: the session, not NULL
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_session_options_of(session: *const sf_session) -> sf_session_options;

    /// What a session holds.
    ///
    /// - `session`: the session, not NULL
    /// - returns: the counts, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_session_count(session: *const sf_session) -> sf_session_counts;

    /// Add a tip by formula, as sf_tip_create() makes it.
    ///
    /// - `session`: the session
    /// - `shape`: which
    /// - `radius_vx`: half its extents
    /// - `tip`: receives its number, counted from 0
    /// - returns: SF_OK; what sf_tip_create() says; SF_ERR_OVERFLOW: 2^20 tips.
    /// - cost: that of the tip.
    /// - threads: one per session.
    /// - since: 0.1
    #[must_use]
    pub fn sf_session_add_tip(
        session: *mut sf_session,
        shape: sf_tip_shape,
        radius_vx: *const f64,
        tip: *mut u32,
    ) -> sf_status;

    /// Add a tip of a mask, as sf_tip_create_mask() makes it; also what a stamp or a mesh became.
    ///
    /// - `session`: the session
    /// - `mask`: its voxels, copied
    /// - `anchor`: its voxel that comes to lie on each dab
    /// - `tip`: receives its number, counted from 0
    /// - returns: SF_OK; what sf_tip_create_mask() says; SF_ERR_OVERFLOW: 2^20 tips.
    /// - cost: that of the tip.
    /// - threads: one per session.
    /// - since: 0.1
    #[must_use]
    pub fn sf_session_add_mask(
        session: *mut sf_session,
        mask: *const sf_grid,
        anchor: sf_dab,
        tip: *mut u32,
    ) -> sf_status;

    /// A tip of a session, to put into a brush.
    ///
    /// - `session`: the session; NULL has none
    /// - `tip`: its number, counted from 0
    /// - returns: the tip, which lives as long as the session; NULL for one that there is not.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_session_tip(session: *const sf_session, tip: u32) -> *const sf_tip;

    /// Add a stroke.
    ///
    /// - `session`: the session
    /// - `brush`: what it does; its own tip is not looked at
    /// - `tip`: number of the tip
    /// - `dabs`: where, copied; may be NULL where count is 0
    /// - `count`: how many
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a brush out of its range, a tip that
    ///   there is not, a dab beyond 2^30; SF_ERR_MEMORY.
    /// - cost: linear.
    /// - threads: one per session.
    /// - since: 0.1
    #[must_use]
    pub fn sf_session_add_stroke(
        session: *mut sf_session,
        brush: *const sf_brush,
        tip: u32,
        dabs: *const sf_dab,
        count: usize,
    ) -> sf_status;

    /// Add a step that is no stroke.
    ///
    /// - `session`: the session
    /// - `step`: which
    /// - returns: SF_OK; SF_ERR_ARGUMENT: NULL, no such step; SF_ERR_MEMORY.
    /// - cost: constant.
    /// - threads: one per session.
    /// - since: 0.1
    #[must_use]
    pub fn sf_session_add_step(session: *mut sf_session, step: sf_session_step) -> sf_status;

    /// Add a shape that takes the place of what is drawn, as sf_sculpt_replace() does.
    ///
    /// - `session`: the session
    /// - `drawn`: of the session's counts; copied as runs
    /// - `materials`: as in sf_sculpt_replace(), or NULL
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_SHAPE; SF_ERR_MEMORY.
    /// - cost: a pass over the grid.
    /// - threads: one per session.
    /// - since: 0.1
    #[must_use]
    pub fn sf_session_add_shape(
        session: *mut sf_session,
        drawn: *const sf_grid,
        materials: *const u8,
    ) -> sf_status;

    /// Keep the state of a model as that at the end of the session; another one is forgotten.
    ///
    /// - `session`: the session
    /// - `model`: NULL: no state is kept
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL session; SF_ERR_SHAPE: other counts;
    ///   SF_ERR_MEMORY.
    /// - cost: a pass over the grid.
    /// - threads: one per session.
    /// - since: 0.1
    #[must_use]
    pub fn sf_session_keep_state(session: *mut sf_session, model: *const sf_sculpt) -> sf_status;

    /// Make an empty model in the session's space.
    ///
    /// - `session`: the session
    /// - `allocator`: for the model; NULL for the C library's
    /// - `model`: receives the model
    /// - returns: as sf_sculpt_create().
    /// - cost: that.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_session_begin(
        session: *const sf_session,
        allocator: *const sf_allocator,
        model: *mut *mut sf_sculpt,
    ) -> sf_status;

    /// Do one step on a model.
    ///
    /// - `session`: the session
    /// - `step`: number of the step, counted from 0
    /// - `allocator`: for a shape that takes the place of another; NULL for the C library's
    /// - `model`: of the session's space
    /// - `change`: what changed; may be NULL
    /// - returns: SF_OK, also where there was nothing to undo or redo; SF_ERR_ARGUMENT: a NULL
    ///   pointer, a step that there is not; SF_ERR_MEMORY: for a shape; what the step's own call
    ///   says.
    /// - cost: that of the step.
    /// - threads: one per model.
    /// - since: 0.1
    #[must_use]
    pub fn sf_session_play(
        session: *const sf_session,
        step: usize,
        allocator: *const sf_allocator,
        model: *mut sf_sculpt,
        change: *mut sf_sculpt_change,
    ) -> sf_status;

    /// What a step is, where it is a stroke: for a host that does strokes by other means.
    ///
    /// - `session`: the session; NULL has no steps
    /// - `step`: number of the step
    /// - `brush`: receives the brush, with its tip, which lives as long as the session; NULL: 0 is
    ///   returned, as for the two others
    /// - `dabs`: receives its dabs, which live until the next one is added, or NULL where there are
    ///   none
    /// - `count`: receives how many; NULL as for the brush
    /// - returns: 1; 0, with nothing written, for a step that is no stroke or not there, and for
    ///   NULL.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_session_stroke(
        session: *const sf_session,
        step: usize,
        brush: *mut sf_brush,
        dabs: *mut *const sf_dab,
        count: *mut usize,
    ) -> c_int;

    /// Do all steps on a new model, and hold the result against the state that is kept, if one is.
    ///
    /// - `session`: the session
    /// - `allocator`: for the model; NULL for the C library's
    /// - `task`: NULL, or progress per step; a cancel is honoured at every step
    /// - `model`: the model
    /// - returns: SF_OK; SF_ERR_FORMAT: the state that is kept is another; what sf_session_begin()
    ///   and sf_session_play() say; SF_ERR_CANCELLED.
    /// - cost: all steps.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_session_replay(
        session: *const sf_session,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        model: *mut *mut sf_sculpt,
    ) -> sf_status;

    /// Open the state that is kept, without playing; its history is empty.
    ///
    /// - `session`: the session
    /// - `allocator`: for the model; NULL for the C library's
    /// - `model`: the model
    /// - returns: SF_OK; SF_ERR_INFEASIBLE: no state is kept; as sf_session_begin().
    /// - cost: a trim, and passes over the grid.
    /// - threads: any; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_session_open(
        session: *const sf_session,
        allocator: *const sf_allocator,
        model: *mut *mut sf_sculpt,
    ) -> sf_status;

    /// Write a session as text.
    ///
    /// The same session gives the same bytes; read and written again it stays.
    ///
    /// - `session`: the session
    /// - `sink`: where the bytes go; on failure it may have had some
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL session, no sink; or what the sink returned.
    /// - cost: linear.
    /// - threads: any, on distinct sinks.
    /// - since: 0.1
    #[must_use]
    pub fn sf_session_write(session: *const sf_session, sink: sf_sink) -> sf_status;

    /// Read a session.
    ///
    /// No count in a file is believed: memory grows as the bytes come, but for the tips, of which
    /// each may ask for a mask of 2^27 voxels at most.
    ///
    /// - `source`: the file
    /// - `bytes_max`: most bytes read; 0 for 1 GiB
    /// - `allocator`: for the session; NULL for the C library's
    /// - `session`: the session; untouched on failure
    /// - `fault`: NULL, or filled on failure: what is wrong, in which line, and what to do
    /// - returns: SF_OK; SF_ERR_FORMAT: the bytes are no session; SF_ERR_UNSUPPORTED: one of a
    ///   later version; SF_ERR_OVERFLOW: more than bytes_max, or a space or a tip that is too
    ///   large; SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL pointer; or what the source returned.
    /// - cost: linear, and the tips.
    /// - threads: any, on distinct sources.
    /// - since: 0.1
    #[must_use]
    pub fn sf_session_read(
        source: sf_source,
        bytes_max: u64,
        allocator: *const sf_allocator,
        session: *mut *mut sf_session,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Options of standing, each at its default.
    ///
    /// - returns: the options, by value.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_stand_options_default() -> sf_stand_options;

    /// Prepare a shape: voxels, weights of handles, the energy of bending.
    ///
    /// Contacts of the stances are put onto the ground (sf_stance_flatten()), and the cells that
    /// they lie in, with the point that it hangs from, are a handle of their own that holds still.
    ///
    /// - `mesh`: the surface, closed and oriented outwards, in mm, with z the build direction
    /// - `stances`: what it is to rest on: each with its own up and contacts
    /// - `stance_count`: how many, 1..32
    /// - `handles`: what bends it, in the mesh's frame, points or balls; those that are locked keep
    ///   their pose
    /// - `handle_count`: how many; 0 where it is not to be bent, and at most SF_HANDLE_MAX - 1
    /// - `options`: NULL for the default
    /// - `allocator`: for all memory: the mesh twice, 8 bytes a vertex and handle, three grids, the
    ///   weights, and with densities 4 bytes a voxel; NULL for the C library's
    /// - `task`: NULL, or progress, cancel and threads
    /// - `stand`: receives the shape
    /// - `fault`: NULL, or receives a sentence on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options out of range or without their
    ///   struct_size, a number of stances or handles out of range, what sf_mesh_validate() and
    ///   sf_stance_create() refuse, a base among the handles, a density that is not above 0 or not
    ///   finite; SF_ERR_UNSUPPORTED: a mesh that is open or inside out, a rule that does not serve;
    ///   SF_ERR_INFEASIBLE: a handle outside the shape, or two that touch, also the one that holds
    ///   still; SF_ERR_OVERFLOW: a coordinate beyond 1e12, more voxels along an axis than a lattice
    ///   has; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: weights, and 0.2 s for the energy of 172 000 triangles and six handles.
    /// - threads: any; one at a time for each allocator.
    /// - source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing
    ///   Shapes for 3D Fabrication", SIGGRAPH 2013.
    /// - since: 0.1
    #[must_use]
    pub fn sf_stand_create(
        mesh: sf_mesh_view,
        stances: *const sf_stance_options,
        stance_count: usize,
        handles: *const sf_handle,
        handle_count: usize,
        options: *const sf_stand_options,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        stand: *mut *mut sf_stand,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Free a shape.
    ///
    /// - `stand`: the shape, freed; NULL does nothing
    /// - cost: constant.
    /// - threads: one, and nobody else with this shape.
    /// - since: 0.1
    pub fn sf_stand_destroy(stand: *mut sf_stand);

    /// One round: bend, then carve the shape as it is then.
    ///
    /// The first only carves.
    ///
    /// - `stand`: the shape; on failure it is as it was
    /// - `task`: NULL, or progress, cancel and threads; the result is the same bytes with any
    /// - `report`: NULL, or receives how far it has come
    /// - returns: SF_OK, be it standing or not; SF_ERR_ARGUMENT: NULL, a density that is not above
    ///   0 or not finite, poses by hand that leave a shape without mass; SF_ERR_OVERFLOW: poses
    ///   that make it too large for its voxels; SF_ERR_MEMORY; SF_ERR_CANCELLED.
    /// - cost: voxels, the exact wall, a carving and a few steps of the solver: some 0.2 s at 172
    ///   000 triangles and 80 000 voxels with the paper's carving.
    /// - threads: one for each shape.
    /// - since: 0.1
    #[must_use]
    pub fn sf_stand_round(
        stand: *mut sf_stand,
        task: *mut sf_task,
        report: *mut sf_stand_report,
    ) -> sf_status;

    /// Rounds until the shape is safe and bent no more than it must be, or nothing improves.
    ///
    /// - `stand`: the shape; on failure it is as the last whole round left it
    /// - `task`: NULL, or progress, cancel and threads
    /// - `report`: NULL, or receives how far it came: `succeeded` says whether it does what was
    ///   asked
    /// - returns: as sf_stand_round().
    /// - cost: rounds_max rounds at most.
    /// - threads: one for each shape.
    /// - since: 0.1
    #[must_use]
    pub fn sf_stand_run(
        stand: *mut sf_stand,
        task: *mut sf_task,
        report: *mut sf_stand_report,
    ) -> sf_status;

    /// How far a shape has come.
    ///
    /// - `stand`: the shape; NULL gives a report of zeros
    /// - returns: the report, by value; all zero for NULL.
    /// - cost: constant.
    /// - threads: any, while no round runs.
    /// - since: 0.1
    pub fn sf_stand_describe(stand: *const sf_stand) -> sf_stand_report;

    /// Pose a handle by hand: the next round starts from it, and the count of rounds anew.
    ///
    /// - `stand`: the shape
    /// - `handle`: which of those handed in
    /// - `pose`: what becomes of it; its numbers finite, its scale above 0
    /// - `lock`: 1: it keeps this pose; 0: it may be moved on
    /// - returns: SF_OK; SF_ERR_ARGUMENT.
    /// - cost: constant.
    /// - threads: one for each shape.
    /// - since: 0.1
    #[must_use]
    pub fn sf_stand_set_pose(
        stand: *mut sf_stand,
        handle: usize,
        pose: *const sf_pose,
        lock: c_int,
    ) -> sf_status;

    /// Pose of a handle.
    ///
    /// - `stand`: the shape; NULL has no handles
    /// - `handle`: which of those handed in
    /// - returns: the pose, by value; the identity for a handle that there is not.
    /// - cost: constant.
    /// - threads: any, while no round runs.
    /// - since: 0.1
    pub fn sf_stand_get_pose(stand: *const sf_stand, handle: usize) -> sf_pose;

    /// The outside: the triangles of the mesh that was handed in, with its vertices where they are
    /// now.
    ///
    /// - `stand`: the shape; NULL gives a view of nothing
    /// - returns: the view, valid until the next round; one of nothing for NULL.
    /// - cost: constant.
    /// - threads: any, while no round runs.
    /// - since: 0.1
    pub fn sf_stand_outer(stand: *const sf_stand) -> sf_mesh_view;

    /// The cavity: closed surfaces whose triangles look into the hollow; none before the first
    /// round.
    ///
    /// - `stand`: the shape; NULL gives a view of nothing
    /// - returns: the view, valid until the next round; one of nothing for NULL.
    /// - cost: constant.
    /// - threads: any, while no round runs.
    /// - since: 0.1
    pub fn sf_stand_cavity(stand: *const sf_stand) -> sf_mesh_view;

    /// The carved shape as voxels; NULL before the first round.
    ///
    /// - `stand`: the shape; NULL has none
    /// - returns: the grid, valid until the next round, or NULL.
    /// - cost: constant.
    /// - threads: any, while no round runs.
    /// - since: 0.1
    pub fn sf_stand_grid(stand: *const sf_stand) -> *const sf_grid;

    /// What 1 mm3 weighs in each voxel of sf_stand_grid(), in (layer, y, x) order, with those that
    /// were carved; NULL where that is 1 everywhere, and before the first round.
    ///
    /// - `stand`: the shape; NULL has none
    /// - returns: the array, valid until the next round, or NULL; it means nothing where the shape
    ///   was empty.
    /// - cost: constant.
    /// - threads: any, while no round runs.
    /// - since: 0.1
    pub fn sf_stand_density(stand: *const sf_stand) -> *const f32;

    /// A stance of the shape as it is; NULL for one that there is not.
    ///
    /// - `stand`: the shape; NULL has none
    /// - `index`: which of the stances handed in
    /// - returns: the stance, valid until the next round, or NULL.
    /// - cost: constant.
    /// - threads: any, while no round runs.
    /// - since: 0.1
    pub fn sf_stand_stance(stand: *const sf_stand, index: usize) -> *const sf_stance;

    /// Whether this build reads and writes 3MF.
    ///
    /// - returns: 1 where it has expat and zlib, else 0.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_threemf_is_served() -> c_int;

    /// Read a 3MF file whole.
    ///
    /// Lengths become mm, whatever the file's unit. Components become items, one for each place
    /// that an object takes. Textures, composites and mixtures of properties are passed over: what
    /// they cover has no colour. Metadata, thumbnails, print tickets and elements that are not
    /// known are passed over too.
    ///
    /// What unfolds is bounded: an XML part to 250 times its size in the archive and 1 MiB, all
    /// parts together to `bytes_max`, components to 64 within one another and 100,000 items. A
    /// DOCTYPE is refused, and so are names that lead out of the archive, two parts with one name,
    /// objects that contain themselves, transforms that flatten, and numbers that are not finite.
    ///
    /// - `source`: the file, read to its end
    /// - `limits`: NULL for sf_read_limits_default(); triangles and vertices of all objects
    ///   together
    /// - `allocator`: for the document and for reading; NULL for the C library's, which expat takes
    ///   in any case
    /// - `document`: receives the document, to be destroyed by the caller; untouched on failure
    /// - `fault`: NULL, or filled on failure: what is wrong, in which part and line of it
    /// - returns: SF_OK; SF_ERR_FORMAT: no 3MF file, or a damaged one; SF_ERR_UNSUPPORTED: the file
    ///   requires an extension that is not read, or the build reads no 3MF; SF_ERR_OVERFLOW: more
    ///   than a limit; SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_IO: a source that
    ///   claims more than it was asked for; or what the source returned.
    /// - cost: the file is held in memory while it is read; one pass over what its parts unfold to.
    /// - threads: any, on distinct sources; one at a time for each allocator.
    /// - source: 3MF Consortium, "3MF Core Specification" 1.3, "Production Extension" 1.1,
    ///   "Materials and Properties Extension" 1.2, "Slice Extension" 1.0.
    /// - since: 0.1
    #[must_use]
    pub fn sf_threemf_read(
        source: sf_source,
        limits: *const sf_read_limits,
        allocator: *const sf_allocator,
        document: *mut *mut sf_threemf,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// What a document holds.
    ///
    /// - `document`: the document; NULL holds nothing
    /// - returns: a view, good until the document is destroyed.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_threemf_get_view(document: *const sf_threemf) -> sf_threemf_view;

    /// One mesh of all that a document builds: parts and solid supports, in their places.
    ///
    /// - `document`: the document
    /// - `limits`: NULL for sf_read_limits_default(); items repeat what they place
    /// - `allocator`: for the mesh; NULL for the C library's
    /// - `mesh`: receives the mesh, to be destroyed by the caller; untouched on failure
    /// - `fault`: NULL, or filled on failure
    /// - returns: SF_OK; SF_ERR_FORMAT: nothing is built that has an inside; SF_ERR_OVERFLOW: more
    ///   than a limit, or a vertex that would not be finite; SF_ERR_UNSUPPORTED: triangles that
    ///   only stand for slices, or a build without 3MF; SF_ERR_ARGUMENT: a NULL pointer;
    ///   SF_ERR_MEMORY.
    /// - cost: the size of the mesh.
    /// - threads: any that read; one at a time for each allocator.
    /// - since: 0.1
    #[must_use]
    pub fn sf_threemf_merge(
        document: *const sf_threemf,
        limits: *const sf_read_limits,
        allocator: *const sf_allocator,
        mesh: *mut *mut sf_mesh,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Whether all that a document builds has slices: its parts and solid supports.
    ///
    /// - `document`: the document; NULL has none
    /// - returns: 1 when each of them has a stack of slices, else 0.
    /// - cost: the number of items.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_threemf_is_sliced(document: *const sf_threemf) -> c_int;

    /// The slices of all that a document builds, in their places: parts and solid supports.
    ///
    /// What is inside is what the contours wind around, SF_CONTOUR_NONZERO: the specification's
    /// fill, where holes turn the other way than what they are holes in. Contours of several items
    /// stand beside one another in each layer, so their layers must have the same heights.
    ///
    /// - `document`: the document
    /// - `allocator`: for the stack; NULL for the C library's
    /// - `stack`: receives the stack, to be destroyed by the caller; untouched on failure
    /// - `fault`: NULL, or filled on failure
    /// - returns: SF_OK; SF_ERR_FORMAT: something that is built has no slices, a slice that is not
    ///   above the one before, or a transform that tilts layers; SF_ERR_UNSUPPORTED: items whose
    ///   layers have other heights, or a build without 3MF; SF_ERR_ARGUMENT: a NULL pointer,
    ///   heights or points beyond 1e12 mm; SF_ERR_OVERFLOW: more than SF_LAYER_MAX layers;
    ///   SF_ERR_MEMORY.
    /// - cost: the points.
    /// - threads: any that read; one at a time for each allocator.
    /// - source: 3MF Consortium, "3MF Slice Extension" 1.0.
    /// - since: 0.1
    #[must_use]
    pub fn sf_threemf_contours(
        document: *const sf_threemf,
        allocator: *const sf_allocator,
        stack: *mut *mut sf_contour_stack,
        fault: *mut sf_fault,
    ) -> sf_status;

    /// Free a document.
    ///
    /// - `document`: the document, freed; NULL does nothing
    /// - cost: the number of its objects.
    /// - threads: one, and nobody else with this document.
    /// - since: 0.1
    pub fn sf_threemf_destroy(document: *mut sf_threemf);

    /// Nothing beside the objects.
    ///
    /// - returns: the extras, by value, with struct_size set.
    /// - cost: constant.
    /// - threads: any.
    /// - since: 0.1
    pub fn sf_threemf_extras_default() -> sf_threemf_extras;

    /// Write a 3MF file: objects, their materials and colours, where they go, and what fills them.
    ///
    /// Coordinates are written in mm, as the fewest of 15 to 17 digits that read back as the same
    /// double. Triangles with two equal corners are left out, because 3MF has none. A group whose
    /// colours have names becomes base materials, another one a group of colours. Equal input gives
    /// equal bytes. Everything but the volume is checked before the first byte is written.
    ///
    /// A volume's property is written as a stack of PNG pictures of 16 bits grey, 3D/volume_F_K.png
    /// with the largest y on top, a function that makes values of them, and a property of the
    /// object's volume data, in the namespace urn:libsf:property:1; fractions of materials are its
    /// composite besides. Between the centres of voxels it is linear.
    ///
    /// - `what`: objects with triangles, their colours, and items; `stack` of each is
    ///   SF_THREEMF_NONE. Colours of a triangle are of one group, or all SF_THREEMF_NONE; base
    ///   materials do not vary within a triangle
    /// - `extras`: NULL for sf_threemf_extras_default()
    /// - `sink`: where the bytes go; on failure it may have had some
    /// - `allocator`: for the compressor, the directory and a layer; NULL for the C library's
    /// - `task`: NULL, or progress per layer of a volume and a cancel between layers
    /// - `fault`: NULL, or filled on failure
    /// - returns: SF_OK; SF_ERR_ARGUMENT: a NULL pointer, what sf_mesh_validate() or
    ///   sf_lattice_validate() says, an object without a triangle of three corners, a number that
    ///   names nothing, a name that is no UTF-8, a map that flattens, a thumbnail that is no PNG;
    ///   SF_ERR_UNSUPPORTED: slices, a volume in a build without PNG, or a build without 3MF;
    ///   SF_ERR_OVERFLOW: more than 4 GiB in the archive or in a part of it (some 40 million
    ///   triangles), or 65,000 layers; SF_ERR_MEMORY; SF_ERR_CANCELLED; SF_ERR_INTERNAL: a
    ///   compressor refuses what it should take; or what the sink or `layer` returned.
    /// - cost: one pass to check and one to write, mostly in the compressor; some 300 KiB, and 2
    ///   bytes for each voxel of a layer of a volume.
    /// - threads: any, on distinct sinks; one at a time for each allocator.
    /// - source: 3MF Consortium, "3MF Core Specification" 1.3, "Volumetric Extension" 0.8.
    /// - since: 0.1
    #[must_use]
    pub fn sf_threemf_write(
        what: *const sf_threemf_view,
        extras: *const sf_threemf_extras,
        sink: sf_sink,
        allocator: *const sf_allocator,
        task: *mut sf_task,
        fault: *mut sf_fault,
    ) -> sf_status;
}

// SPDX-License-Identifier: MIT
// Results and choices of the library as Rust has them. Written by bindings/rust/generate.py.

use crate::plain::Plain;
use crate::sys;

/// What became of a call. Numbers are fixed and never reused.
///
/// Anything but [`SF_OK`](crate::sys::SF_OK) changed no object and no output, with one exception: [`SF_ERR_CAPACITY`](crate::sys::SF_ERR_CAPACITY) may leave the number of places needed in the call's count, where its comment says so. An [`sf_fault`](crate::sys::sf_fault) is there to be filled, and a sink keeps the bytes that it has had.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ErrorKind {
    /// a pointer is NULL or a value lies outside its documented range
    Argument,
    /// two objects that must agree in size or lattice do not
    Shape,
    /// the caller's buffer is too small; the need was reported
    Capacity,
    /// a size does not fit the machine or the library's limits
    Overflow,
    /// the allocator returned NULL
    Memory,
    /// a source or sink failed
    Io,
    /// the bytes are not what the format allows
    Format,
    /// well-formed, but not served by this rule, build or version
    Unsupported,
    /// the task was cancelled
    Cancelled,
    /// a promise of the library was broken: please report it
    Internal,
    /// what must stay cannot be carried within what may be there
    Infeasible,
    /// a number that has no name here
    Other(i32),
}

impl ErrorKind {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_status {
        match self {
            ErrorKind::Argument => sys::SF_ERR_ARGUMENT,
            ErrorKind::Shape => sys::SF_ERR_SHAPE,
            ErrorKind::Capacity => sys::SF_ERR_CAPACITY,
            ErrorKind::Overflow => sys::SF_ERR_OVERFLOW,
            ErrorKind::Memory => sys::SF_ERR_MEMORY,
            ErrorKind::Io => sys::SF_ERR_IO,
            ErrorKind::Format => sys::SF_ERR_FORMAT,
            ErrorKind::Unsupported => sys::SF_ERR_UNSUPPORTED,
            ErrorKind::Cancelled => sys::SF_ERR_CANCELLED,
            ErrorKind::Internal => sys::SF_ERR_INTERNAL,
            ErrorKind::Infeasible => sys::SF_ERR_INFEASIBLE,
            ErrorKind::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_status) -> ErrorKind {
        match c {
            sys::SF_ERR_ARGUMENT => ErrorKind::Argument,
            sys::SF_ERR_SHAPE => ErrorKind::Shape,
            sys::SF_ERR_CAPACITY => ErrorKind::Capacity,
            sys::SF_ERR_OVERFLOW => ErrorKind::Overflow,
            sys::SF_ERR_MEMORY => ErrorKind::Memory,
            sys::SF_ERR_IO => ErrorKind::Io,
            sys::SF_ERR_FORMAT => ErrorKind::Format,
            sys::SF_ERR_UNSUPPORTED => ErrorKind::Unsupported,
            sys::SF_ERR_CANCELLED => ErrorKind::Cancelled,
            sys::SF_ERR_INTERNAL => ErrorKind::Internal,
            sys::SF_ERR_INFEASIBLE => ErrorKind::Infeasible,
            number => ErrorKind::Other(number),
        }
    }
}

/// What the voxels outside a slice are taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Border {
    /// nothing outside
    Empty,
    /// matter everywhere outside
    Solid,
    /// a number that has no name here
    Other(i32),
}

impl Border {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_border {
        match self {
            Border::Empty => sys::SF_BORDER_EMPTY,
            Border::Solid => sys::SF_BORDER_SOLID,
            Border::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_border) -> Border {
        match c {
            sys::SF_BORDER_EMPTY => Border::Empty,
            sys::SF_BORDER_SOLID => Border::Solid,
            number => Border::Other(number),
        }
    }
}

/// Which voxels of a slice count as neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Connectivity {
    /// four neighbours: those that share an edge
    Edges,
    /// eight neighbours: those that share an edge or a corner
    Corners,
    /// a number that has no name here
    Other(i32),
}

impl Connectivity {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_connectivity {
        match self {
            Connectivity::Edges => sys::SF_CONNECT_EDGES,
            Connectivity::Corners => sys::SF_CONNECT_CORNERS,
            Connectivity::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_connectivity) -> Connectivity {
        match c {
            sys::SF_CONNECT_EDGES => Connectivity::Edges,
            sys::SF_CONNECT_CORNERS => Connectivity::Corners,
            number => Connectivity::Other(number),
        }
    }
}

/// Instruction sets that kernels are written for, from plain to fast.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Isa {
    /// one bit at a time: the specification
    Reference,
    /// 64-bit words, plain C
    Word,
    /// x86, 128 bits
    Sse2,
    /// Arm, 128 bits
    Neon,
    /// x86, 256 bits
    Avx2,
    /// x86, 512 bits, with VBMI2
    Avx512,
    /// a number that has no name here
    Other(i32),
}

impl Isa {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_isa {
        match self {
            Isa::Reference => sys::SF_ISA_REFERENCE,
            Isa::Word => sys::SF_ISA_WORD,
            Isa::Sse2 => sys::SF_ISA_SSE2,
            Isa::Neon => sys::SF_ISA_NEON,
            Isa::Avx2 => sys::SF_ISA_AVX2,
            Isa::Avx512 => sys::SF_ISA_AVX512,
            Isa::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_isa) -> Isa {
        match c {
            sys::SF_ISA_REFERENCE => Isa::Reference,
            sys::SF_ISA_WORD => Isa::Word,
            sys::SF_ISA_SSE2 => Isa::Sse2,
            sys::SF_ISA_NEON => Isa::Neon,
            sys::SF_ISA_AVX2 => Isa::Avx2,
            sys::SF_ISA_AVX512 => Isa::Avx512,
            number => Isa::Other(number),
        }
    }
}

/// How inside is decided. A voxel is solid or not at its centre, but for [`SF_FILL_SURFACE`](crate::sys::SF_FILL_SURFACE).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Fill {
    /// winding, after turning what looks the wrong way
    Auto,
    /// inside after an odd number of crossings
    Parity,
    /// inside where the winding number is at least one half
    Winding,
    /// every voxel that the surface touches, and nothing else
    Surface,
    /// a number that has no name here
    Other(i32),
}

impl Fill {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_fill {
        match self {
            Fill::Auto => sys::SF_FILL_AUTO,
            Fill::Parity => sys::SF_FILL_PARITY,
            Fill::Winding => sys::SF_FILL_WINDING,
            Fill::Surface => sys::SF_FILL_SURFACE,
            Fill::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_fill) -> Fill {
        match c {
            sys::SF_FILL_AUTO => Fill::Auto,
            sys::SF_FILL_PARITY => Fill::Parity,
            sys::SF_FILL_WINDING => Fill::Winding,
            sys::SF_FILL_SURFACE => Fill::Surface,
            number => Fill::Other(number),
        }
    }
}

/// What a handle holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum HandleKind {
    /// the cell that its centre lies in
    Point,
    /// that cell, and the corners of cells within a radius
    Ball,
    /// the cells that hold a voxel of a region
    Base,
    /// a number that has no name here
    Other(i32),
}

impl HandleKind {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_handle_kind {
        match self {
            HandleKind::Point => sys::SF_HANDLE_POINT,
            HandleKind::Ball => sys::SF_HANDLE_BALL,
            HandleKind::Base => sys::SF_HANDLE_BASE,
            HandleKind::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_handle_kind) -> HandleKind {
        match c {
            sys::SF_HANDLE_POINT => HandleKind::Point,
            sys::SF_HANDLE_BALL => HandleKind::Ball,
            sys::SF_HANDLE_BASE => HandleKind::Base,
            number => HandleKind::Other(number),
        }
    }
}

/// How weights are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum WeightsMethod {
    /// the smoothest of all, cut off at 0 and 1: fast
    Clamped,
    /// the smoothest of those within 0 and 1, each handle for itself
    Bounded,
    /// a number that has no name here
    Other(i32),
}

impl WeightsMethod {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_weights_method {
        match self {
            WeightsMethod::Clamped => sys::SF_WEIGHTS_CLAMPED,
            WeightsMethod::Bounded => sys::SF_WEIGHTS_BOUNDED,
            WeightsMethod::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_weights_method) -> WeightsMethod {
        match c {
            sys::SF_WEIGHTS_CLAMPED => WeightsMethod::Clamped,
            sys::SF_WEIGHTS_BOUNDED => WeightsMethod::Bounded,
            number => WeightsMethod::Other(number),
        }
    }
}

/// Cage file formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum CageFormat {
    /// judge by the first words
    Auto,
    /// Medit .mesh, text, versions 1 to 4
    Medit,
    /// MFEM .mesh, version 1.x, conforming
    Mfem,
    /// legacy VTK, unstructured grid, text and binary
    Vtk,
    /// a number that has no name here
    Other(i32),
}

impl CageFormat {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_cage_format {
        match self {
            CageFormat::Auto => sys::SF_CAGE_FORMAT_AUTO,
            CageFormat::Medit => sys::SF_CAGE_FORMAT_MEDIT,
            CageFormat::Mfem => sys::SF_CAGE_FORMAT_MFEM,
            CageFormat::Vtk => sys::SF_CAGE_FORMAT_VTK,
            CageFormat::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_cage_format) -> CageFormat {
        match c {
            sys::SF_CAGE_FORMAT_AUTO => CageFormat::Auto,
            sys::SF_CAGE_FORMAT_MEDIT => CageFormat::Medit,
            sys::SF_CAGE_FORMAT_MFEM => CageFormat::Mfem,
            sys::SF_CAGE_FORMAT_VTK => CageFormat::Vtk,
            number => CageFormat::Other(number),
        }
    }
}

/// How a body comes to rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum StanceKind {
    /// on its lowest vertices, and stays when it is tilted
    Stand,
    /// from a point, tied to a string
    Hang,
    /// on a rounded base, and rolls back to the pose asked for
    Rock,
    /// a number that has no name here
    Other(i32),
}

impl StanceKind {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_stance_kind {
        match self {
            StanceKind::Stand => sys::SF_STANCE_STAND,
            StanceKind::Hang => sys::SF_STANCE_HANG,
            StanceKind::Rock => sys::SF_STANCE_ROCK,
            StanceKind::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_stance_kind) -> StanceKind {
        match c {
            sys::SF_STANCE_STAND => StanceKind::Stand,
            sys::SF_STANCE_HANG => StanceKind::Hang,
            sys::SF_STANCE_ROCK => StanceKind::Rock,
            number => StanceKind::Other(number),
        }
    }
}

/// What a set of polygons has inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ContourFill {
    /// what the polygons wind around, as their turns sum up: not 0
    Nonzero,
    /// what an odd number of polygons encloses
    EvenOdd,
    /// a number that has no name here
    Other(i32),
}

impl ContourFill {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_contour_fill {
        match self {
            ContourFill::Nonzero => sys::SF_CONTOUR_NONZERO,
            ContourFill::EvenOdd => sys::SF_CONTOUR_EVEN_ODD,
            ContourFill::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_contour_fill) -> ContourFill {
        match c {
            sys::SF_CONTOUR_NONZERO => ContourFill::Nonzero,
            sys::SF_CONTOUR_EVEN_ODD => ContourFill::EvenOdd,
            number => ContourFill::Other(number),
        }
    }
}

/// Which voxels below can carry a voxel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum RuleKind {
    /// the nine voxels below: the papers' rule; takes no angle
    Box3,
    /// a schedule of pluses and squares that stays within the asked angle
    Octagon,
    /// an ellipse in voxels, a disk in mm, the same for layers of one height
    Disk,
    /// the exact angle: what one layer does not reach the next may, added up
    Slack,
    /// a number that has no name here
    Other(i32),
}

impl RuleKind {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_rule_kind {
        match self {
            RuleKind::Box3 => sys::SF_RULE_BOX3,
            RuleKind::Octagon => sys::SF_RULE_OCTAGON,
            RuleKind::Disk => sys::SF_RULE_DISK,
            RuleKind::Slack => sys::SF_RULE_SLACK,
            RuleKind::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_rule_kind) -> RuleKind {
        match c {
            sys::SF_RULE_BOX3 => RuleKind::Box3,
            sys::SF_RULE_OCTAGON => RuleKind::Octagon,
            sys::SF_RULE_DISK => RuleKind::Disk,
            sys::SF_RULE_SLACK => RuleKind::Slack,
            number => RuleKind::Other(number),
        }
    }
}

/// What kind of fault a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum FindingKind {
    /// matter that reaches too far out from what is carried
    Overhang,
    /// a whole component of a slice with nothing that carries it
    Island,
    /// a number that has no name here
    Other(i32),
}

impl FindingKind {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_finding_kind {
        match self {
            FindingKind::Overhang => sys::SF_FINDING_OVERHANG,
            FindingKind::Island => sys::SF_FINDING_ISLAND,
            FindingKind::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_finding_kind) -> FindingKind {
        match c {
            sys::SF_FINDING_OVERHANG => FindingKind::Overhang,
            sys::SF_FINDING_ISLAND => FindingKind::Island,
            number => FindingKind::Other(number),
        }
    }
}

/// How a solid is carved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum CarveMode {
    /// the result prints without supports where the solid did
    SupportFree,
    /// the paper's: in the order of the distance to a plane, for powder beds and for comparison. Ceilings may hang
    Plane,
    /// a number that has no name here
    Other(i32),
}

impl CarveMode {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_carve_mode {
        match self {
            CarveMode::SupportFree => sys::SF_CARVE_SUPPORT_FREE,
            CarveMode::Plane => sys::SF_CARVE_PLANE,
            CarveMode::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_carve_mode) -> CarveMode {
        match c {
            sys::SF_CARVE_SUPPORT_FREE => CarveMode::SupportFree,
            sys::SF_CARVE_PLANE => CarveMode::Plane,
            number => CarveMode::Other(number),
        }
    }
}

/// When there is enough carved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum CarveGoal {
    /// as much matter stays as can while every half-space holds; where they cannot all hold, as [`SF_CARVE_NEAREST`](crate::sys::SF_CARVE_NEAREST); support-free: _DEEPEST
    Enough,
    /// the paper's: least distance to the targets, each of them the place of the safe region that is nearest to the centre of mass. Support-free: as [`SF_CARVE_ENOUGH`](crate::sys::SF_CARVE_ENOUGH)
    Nearest,
    /// largest least slack: as far inside all half-spaces as can be
    Deepest,
    /// support-free: as little matter stays as can while every half-space holds; where they cannot all hold, as [`SF_CARVE_DEEPEST`](crate::sys::SF_CARVE_DEEPEST)
    Lightest,
    /// a number that has no name here
    Other(i32),
}

impl CarveGoal {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_carve_goal {
        match self {
            CarveGoal::Enough => sys::SF_CARVE_ENOUGH,
            CarveGoal::Nearest => sys::SF_CARVE_NEAREST,
            CarveGoal::Deepest => sys::SF_CARVE_DEEPEST,
            CarveGoal::Lightest => sys::SF_CARVE_LIGHTEST,
            CarveGoal::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_carve_goal) -> CarveGoal {
        match c {
            sys::SF_CARVE_ENOUGH => CarveGoal::Enough,
            sys::SF_CARVE_NEAREST => CarveGoal::Nearest,
            sys::SF_CARVE_DEEPEST => CarveGoal::Deepest,
            sys::SF_CARVE_LIGHTEST => CarveGoal::Lightest,
            number => CarveGoal::Other(number),
        }
    }
}

/// What made a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Operation {
    /// nothing was changed
    Check,
    /// matter was taken away only
    Trim,
    /// matter was added only
    Grow,
    /// both
    Repair,
    /// matter was taken away only
    Preserve,
    /// a number that has no name here
    Other(i32),
}

impl Operation {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_operation {
        match self {
            Operation::Check => sys::SF_OPERATION_CHECK,
            Operation::Trim => sys::SF_OPERATION_TRIM,
            Operation::Grow => sys::SF_OPERATION_GROW,
            Operation::Repair => sys::SF_OPERATION_REPAIR,
            Operation::Preserve => sys::SF_OPERATION_PRESERVE,
            Operation::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_operation) -> Operation {
        match c {
            sys::SF_OPERATION_CHECK => Operation::Check,
            sys::SF_OPERATION_TRIM => Operation::Trim,
            sys::SF_OPERATION_GROW => Operation::Grow,
            sys::SF_OPERATION_REPAIR => Operation::Repair,
            sys::SF_OPERATION_PRESERVE => Operation::Preserve,
            number => Operation::Other(number),
        }
    }
}

/// Mesh file formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum MeshFormat {
    /// reading only: judge by the bytes
    Auto,
    /// text and binary in, binary out
    Stl,
    /// in and out
    Obj,
    /// text and both binary orders in, binary little-endian out
    Ply,
    /// text, in only
    Off,
    /// .3mf in and out, where [`sf_threemf_is_served()`](crate::sys::sf_threemf_is_served): \<sf/threemf.h\>
    Threemf,
    /// .glb and .gltf in, where [`sf_gltf_is_served()`](crate::sys::sf_gltf_is_served); .glb out: \<sf/gltf.h\>
    Gltf,
    /// a number that has no name here
    Other(i32),
}

impl MeshFormat {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_mesh_format {
        match self {
            MeshFormat::Auto => sys::SF_MESH_FORMAT_AUTO,
            MeshFormat::Stl => sys::SF_MESH_FORMAT_STL,
            MeshFormat::Obj => sys::SF_MESH_FORMAT_OBJ,
            MeshFormat::Ply => sys::SF_MESH_FORMAT_PLY,
            MeshFormat::Off => sys::SF_MESH_FORMAT_OFF,
            MeshFormat::Threemf => sys::SF_MESH_FORMAT_THREEMF,
            MeshFormat::Gltf => sys::SF_MESH_FORMAT_GLTF,
            MeshFormat::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_mesh_format) -> MeshFormat {
        match c {
            sys::SF_MESH_FORMAT_AUTO => MeshFormat::Auto,
            sys::SF_MESH_FORMAT_STL => MeshFormat::Stl,
            sys::SF_MESH_FORMAT_OBJ => MeshFormat::Obj,
            sys::SF_MESH_FORMAT_PLY => MeshFormat::Ply,
            sys::SF_MESH_FORMAT_OFF => MeshFormat::Off,
            sys::SF_MESH_FORMAT_THREEMF => MeshFormat::Threemf,
            sys::SF_MESH_FORMAT_GLTF => MeshFormat::Gltf,
            number => MeshFormat::Other(number),
        }
    }
}

/// Kinds of CLI files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ContourFormat {
    /// numbers as text, which read back as the same doubles
    Text,
    /// floats of 32 bits
    Binary,
    /// a number that has no name here
    Other(i32),
}

impl ContourFormat {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_contour_format {
        match self {
            ContourFormat::Text => sys::SF_CONTOUR_CLI_TEXT,
            ContourFormat::Binary => sys::SF_CONTOUR_CLI_BINARY,
            ContourFormat::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_contour_format) -> ContourFormat {
        match c {
            sys::SF_CONTOUR_CLI_TEXT => ContourFormat::Text,
            sys::SF_CONTOUR_CLI_BINARY => ContourFormat::Binary,
            number => ContourFormat::Other(number),
        }
    }
}

/// Which weights points inside of a solid get.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum RefineRules {
    /// Joy and MacCracken's everywhere
    Standard,
    /// where the cage is extruded along a line that other than four cells go around, the cross section is as the surface of that outline
    Separable,
    /// a number that has no name here
    Other(i32),
}

impl RefineRules {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_refine_rules {
        match self {
            RefineRules::Standard => sys::SF_REFINE_STANDARD,
            RefineRules::Separable => sys::SF_REFINE_SEPARABLE,
            RefineRules::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_refine_rules) -> RefineRules {
        match c {
            sys::SF_REFINE_STANDARD => RefineRules::Standard,
            sys::SF_REFINE_SEPARABLE => RefineRules::Separable,
            number => RefineRules::Other(number),
        }
    }
}

/// What is wrong with a void.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum VoidKind {
    /// closed for good: what is in it cannot leave
    Trap,
    /// closed against the film while its layers print, and open later
    Cup,
    /// a number that has no name here
    Other(i32),
}

impl VoidKind {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_void_kind {
        match self {
            VoidKind::Trap => sys::SF_VOID_TRAP,
            VoidKind::Cup => sys::SF_VOID_CUP,
            VoidKind::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_void_kind) -> VoidKind {
        match c {
            sys::SF_VOID_TRAP => VoidKind::Trap,
            sys::SF_VOID_CUP => VoidKind::Cup,
            number => VoidKind::Other(number),
        }
    }
}

/// What matter a path may end on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Landing {
    /// any matter from the bed layer up, as in the paper; under slack, matter that hangs in the air has no reach to spare
    Any,
    /// only what is alive under the whole rule; other matter is passed through, a step like any other, and lies in the path
    Alive,
    /// a number that has no name here
    Other(i32),
}

impl Landing {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_landing {
        match self {
            Landing::Any => sys::SF_LANDING_ANY,
            Landing::Alive => sys::SF_LANDING_ALIVE,
            Landing::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_landing) -> Landing {
        match c {
            sys::SF_LANDING_ANY => Landing::Any,
            sys::SF_LANDING_ALIVE => Landing::Alive,
            number => Landing::Other(number),
        }
    }
}

/// What a path ends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum PathEnd {
    /// its last voxel rests on matter of the layer below
    Matter,
    /// its last voxel lies on the bed
    Bed,
    /// its last voxel is exempt: it needs nothing below it
    Held,
    /// a number that has no name here
    Other(i32),
}

impl PathEnd {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_path_end {
        match self {
            PathEnd::Matter => sys::SF_PATH_END_MATTER,
            PathEnd::Bed => sys::SF_PATH_END_BED,
            PathEnd::Held => sys::SF_PATH_END_HELD,
            PathEnd::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_path_end) -> PathEnd {
        match c {
            sys::SF_PATH_END_MATTER => PathEnd::Matter,
            sys::SF_PATH_END_BED => PathEnd::Bed,
            sys::SF_PATH_END_HELD => PathEnd::Held,
            number => PathEnd::Other(number),
        }
    }
}

/// What a path costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum PathCost {
    /// voxels, and on the bed the distance to its matter: as told above
    Count,
    /// for each voxel the distance to the closest matter of its slice, in voxels, rounded up, and one where the slice is empty: the paper's first cost, which it found too dear
    Nearness,
    /// a number that has no name here
    Other(i32),
}

impl PathCost {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_path_cost {
        match self {
            PathCost::Count => sys::SF_PATH_COST_COUNT,
            PathCost::Nearness => sys::SF_PATH_COST_NEARNESS,
            PathCost::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_path_cost) -> PathCost {
        match c {
            sys::SF_PATH_COST_COUNT => PathCost::Count,
            sys::SF_PATH_COST_NEARNESS => PathCost::Nearness,
            number => PathCost::Other(number),
        }
    }
}

/// Between which voxels a mask keeps what is alike apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum MaskKind {
    /// within each slice, and along each column: slices look even
    Slice,
    /// in all directions alike: the solid is even, its slices less so
    Isotropic,
    /// a number that has no name here
    Other(i32),
}

impl MaskKind {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_mask_kind {
        match self {
            MaskKind::Slice => sys::SF_MASK_SLICE,
            MaskKind::Isotropic => sys::SF_MASK_ISOTROPIC,
            MaskKind::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_mask_kind) -> MaskKind {
        match c {
            sys::SF_MASK_SLICE => MaskKind::Slice,
            sys::SF_MASK_ISOTROPIC => MaskKind::Isotropic,
            number => MaskKind::Other(number),
        }
    }
}

/// Formats of jobs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum JobFormat {
    /// a zip archive with config.ini and a PNG for each layer
    Sl1,
    /// .photon of the cbddlp family, versions 1 and 2, one bit a pixel
    Photon,
    /// a number that has no name here
    Other(i32),
}

impl JobFormat {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_job_format {
        match self {
            JobFormat::Sl1 => sys::SF_JOB_SL1,
            JobFormat::Photon => sys::SF_JOB_PHOTON,
            JobFormat::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_job_format) -> JobFormat {
        match c {
            sys::SF_JOB_SL1 => JobFormat::Sl1,
            sys::SF_JOB_PHOTON => JobFormat::Photon,
            number => JobFormat::Other(number),
        }
    }
}

/// Which way a curve goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Trend {
    /// the way that changes the samples less; up where both do alike
    Auto,
    /// y never falls with x
    Rising,
    /// y never rises with x
    Falling,
    /// a number that has no name here
    Other(i32),
}

impl Trend {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_trend {
        match self {
            Trend::Auto => sys::SF_TREND_AUTO,
            Trend::Rising => sys::SF_TREND_RISING,
            Trend::Falling => sys::SF_TREND_FALLING,
            Trend::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_trend) -> Trend {
        match c {
            sys::SF_TREND_AUTO => Trend::Auto,
            sys::SF_TREND_RISING => Trend::Rising,
            sys::SF_TREND_FALLING => Trend::Falling,
            number => Trend::Other(number),
        }
    }
}

/// How the weight of a brush falls from its middle, with t the distance over the radius.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Falloff {
    /// 1 up to the radius
    Constant,
    /// 1 - t
    Linear,
    /// 1 - 3 t^2 + 2 t^3
    Smooth,
    /// (g(t) - g(1)) / (1 - g(1)), g(t) = exp(-9 t^2 / 2): a bell whose standard deviation is a third of the radius, 0 at the rim
    Gaussian,
    /// a number that has no name here
    Other(i32),
}

impl Falloff {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_falloff {
        match self {
            Falloff::Constant => sys::SF_FALLOFF_CONSTANT,
            Falloff::Linear => sys::SF_FALLOFF_LINEAR,
            Falloff::Smooth => sys::SF_FALLOFF_SMOOTH,
            Falloff::Gaussian => sys::SF_FALLOFF_GAUSSIAN,
            Falloff::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_falloff) -> Falloff {
        match c {
            sys::SF_FALLOFF_CONSTANT => Falloff::Constant,
            sys::SF_FALLOFF_LINEAR => Falloff::Linear,
            sys::SF_FALLOFF_SMOOTH => Falloff::Smooth,
            sys::SF_FALLOFF_GAUSSIAN => Falloff::Gaussian,
            number => Falloff::Other(number),
        }
    }
}

/// Which points a brush takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum PaintWhere {
    /// all
    All,
    /// those on the boundary
    Outside,
    /// the others
    Inside,
    /// a number that has no name here
    Other(i32),
}

impl PaintWhere {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_paint_where {
        match self {
            PaintWhere::All => sys::SF_PAINT_ALL,
            PaintWhere::Outside => sys::SF_PAINT_OUTSIDE,
            PaintWhere::Inside => sys::SF_PAINT_INSIDE,
            PaintWhere::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_paint_where) -> PaintWhere {
        match c {
            sys::SF_PAINT_ALL => PaintWhere::All,
            sys::SF_PAINT_OUTSIDE => PaintWhere::Outside,
            sys::SF_PAINT_INSIDE => PaintWhere::Inside,
            number => PaintWhere::Other(number),
        }
    }
}

/// What is done to a value v of weight w.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum PaintOperation {
    /// v + w (amount - v)
    Set,
    /// v + w amount
    Add,
    /// v + w amount (mean of its neighbours along edges - v), amount 0 to 1
    Smooth,
    /// a number that has no name here
    Other(i32),
}

impl PaintOperation {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_paint_operation {
        match self {
            PaintOperation::Set => sys::SF_PAINT_SET,
            PaintOperation::Add => sys::SF_PAINT_ADD,
            PaintOperation::Smooth => sys::SF_PAINT_SMOOTH,
            PaintOperation::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_paint_operation) -> PaintOperation {
        match c {
            sys::SF_PAINT_SET => PaintOperation::Set,
            sys::SF_PAINT_ADD => PaintOperation::Add,
            sys::SF_PAINT_SMOOTH => PaintOperation::Smooth,
            number => PaintOperation::Other(number),
        }
    }
}

/// What is kept of the brush, where something must be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum PreserveMode {
    /// word by word: straight below what hangs, else the nearest. Keeps more than is needed. Rules with slack or bridges have no words to do it by: there it is [`sf_grid_complete()`](crate::sys::sf_grid_complete)
    Fast,
    /// no kept voxel of the brush could be removed as well without losing something outside the brush; greedy, then pruned
    Irredundant,
    /// thick: the core of what hangs, then struts of strut_width, then single voxels where nothing thicker fits
    Core,
    /// the paper's text: remove all, then from the slice above the brush to the one below it unite each with the erosion of the one above. May leave unsupported matter, and add some
    PaperText,
    /// the paper's shader: from the top down a voxel of the brush stays where all above it are solid. May leave unsupported matter
    PaperShader,
    /// a number that has no name here
    Other(i32),
}

impl PreserveMode {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_preserve_mode {
        match self {
            PreserveMode::Fast => sys::SF_PRESERVE_FAST,
            PreserveMode::Irredundant => sys::SF_PRESERVE_IRREDUNDANT,
            PreserveMode::Core => sys::SF_PRESERVE_CORE,
            PreserveMode::PaperText => sys::SF_PRESERVE_PAPER_TEXT,
            PreserveMode::PaperShader => sys::SF_PRESERVE_PAPER_SHADER,
            PreserveMode::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_preserve_mode) -> PreserveMode {
        match c {
            sys::SF_PRESERVE_FAST => PreserveMode::Fast,
            sys::SF_PRESERVE_IRREDUNDANT => PreserveMode::Irredundant,
            sys::SF_PRESERVE_CORE => PreserveMode::Core,
            sys::SF_PRESERVE_PAPER_TEXT => PreserveMode::PaperText,
            sys::SF_PRESERVE_PAPER_SHADER => PreserveMode::PaperShader,
            number => PreserveMode::Other(number),
        }
    }
}

/// The shapes of tips that are made by formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum TipShape {
    /// an ellipsoid
    Sphere,
    /// a box along the axes
    Box,
    /// an elliptic cylinder, upright
    Cylinder,
    /// an elliptic cone, its point up
    Cone,
    /// a number that has no name here
    Other(i32),
}

impl TipShape {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_tip_shape {
        match self {
            TipShape::Sphere => sys::SF_TIP_SPHERE,
            TipShape::Box => sys::SF_TIP_BOX,
            TipShape::Cylinder => sys::SF_TIP_CYLINDER,
            TipShape::Cone => sys::SF_TIP_CONE,
            TipShape::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_tip_shape) -> TipShape {
        match c {
            sys::SF_TIP_SPHERE => TipShape::Sphere,
            sys::SF_TIP_BOX => TipShape::Box,
            sys::SF_TIP_CYLINDER => TipShape::Cylinder,
            sys::SF_TIP_CONE => TipShape::Cone,
            number => TipShape::Other(number),
        }
    }
}

/// What a brush does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum BrushKind {
    /// adds what of the tips is carried; touches nothing else
    AddTrim,
    /// removes what carries nothing; touches nothing else
    RemovePreserve,
    /// adds the tips, and below them what they need
    AddGrow,
    /// removes the tips, and above them what then hangs
    RemoveTrim,
    /// levels bumps and dents, then removes what hangs
    SmoothTrim,
    /// gives what is there another material
    Paint,
    /// a number that has no name here
    Other(i32),
}

impl BrushKind {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_brush_kind {
        match self {
            BrushKind::AddTrim => sys::SF_BRUSH_ADD_TRIM,
            BrushKind::RemovePreserve => sys::SF_BRUSH_REMOVE_PRESERVE,
            BrushKind::AddGrow => sys::SF_BRUSH_ADD_GROW,
            BrushKind::RemoveTrim => sys::SF_BRUSH_REMOVE_TRIM,
            BrushKind::SmoothTrim => sys::SF_BRUSH_SMOOTH_TRIM,
            BrushKind::Paint => sys::SF_BRUSH_PAINT,
            BrushKind::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_brush_kind) -> BrushKind {
        match c {
            sys::SF_BRUSH_ADD_TRIM => BrushKind::AddTrim,
            sys::SF_BRUSH_REMOVE_PRESERVE => BrushKind::RemovePreserve,
            sys::SF_BRUSH_ADD_GROW => BrushKind::AddGrow,
            sys::SF_BRUSH_REMOVE_TRIM => BrushKind::RemoveTrim,
            sys::SF_BRUSH_SMOOTH_TRIM => BrushKind::SmoothTrim,
            sys::SF_BRUSH_PAINT => BrushKind::Paint,
            number => BrushKind::Other(number),
        }
    }
}

/// Steps that are no strokes and need no more said.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum SessionStep {
    /// [`sf_sculpt_undo()`](crate::sys::sf_sculpt_undo)
    Undo,
    /// [`sf_sculpt_redo()`](crate::sys::sf_sculpt_redo)
    Redo,
    /// [`sf_sculpt_drop_ghosts()`](crate::sys::sf_sculpt_drop_ghosts)
    DropGhosts,
    /// a number that has no name here
    Other(i32),
}

impl SessionStep {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_session_step {
        match self {
            SessionStep::Undo => sys::SF_SESSION_UNDO,
            SessionStep::Redo => sys::SF_SESSION_REDO,
            SessionStep::DropGhosts => sys::SF_SESSION_DROP_GHOSTS,
            SessionStep::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_session_step) -> SessionStep {
        match c {
            sys::SF_SESSION_UNDO => SessionStep::Undo,
            sys::SF_SESSION_REDO => SessionStep::Redo,
            sys::SF_SESSION_DROP_GHOSTS => SessionStep::DropGhosts,
            number => SessionStep::Other(number),
        }
    }
}

/// How handles are moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum StandSolver {
    /// quadratic programs, with the safe set as constraint
    Programs,
    /// the paper's gradient descent on a weighed sum; for comparison
    Descent,
    /// a number that has no name here
    Other(i32),
}

impl StandSolver {
    #[allow(dead_code)]
    pub(crate) fn c(self) -> sys::sf_stand_solver {
        match self {
            StandSolver::Programs => sys::SF_STAND_PROGRAMS,
            StandSolver::Descent => sys::SF_STAND_DESCENT,
            StandSolver::Other(number) => number,
        }
    }

    #[allow(dead_code)]
    pub(crate) fn of(c: sys::sf_stand_solver) -> StandSolver {
        match c {
            sys::SF_STAND_PROGRAMS => StandSolver::Programs,
            sys::SF_STAND_DESCENT => StandSolver::Descent,
            number => StandSolver::Other(number),
        }
    }
}

/// A half-open rectangle of voxels: x0 \<= x \< x1, y0 \<= y \< y1; empty when x0 \>= x1 or y0 \>= y1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Rect {
    /// first column and row, and those after the last
    pub x0: u32,
    /// first column and row, and those after the last
    pub y0: u32,
    /// first column and row, and those after the last
    pub x1: u32,
    /// first column and row, and those after the last
    pub y1: u32,
}

impl Rect {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_rect) -> Rect {
        Rect {
            x0: c.x0,
            y0: c.y0,
            x1: c.x1,
            y1: c.y1,
        }
    }

    pub(crate) fn c(&self) -> sys::sf_rect {
        sys::sf_rect {
            x0: self.x0,
            y0: self.y0,
            x1: self.x1,
            y1: self.y1,
        }
    }
}

/// Exact sums over the solid voxels of a slice, in voxel indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SliceSums {
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

impl SliceSums {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_slice_sums) -> SliceSums {
        SliceSums {
            count: c.count,
            x: c.x,
            y: c.y,
            xx: c.xx,
            yy: c.yy,
            xy: c.xy,
        }
    }
}

/// A maximal run of solid voxels in one row: x0 \<= x \< x1.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Run {
    /// half-open
    pub x0: u32,
    /// half-open
    pub x1: u32,
    /// row
    pub y: u32,
    /// component, once labelled; 0-based
    pub label: u32,
}

// The fields are those of C, in their order.
unsafe impl Plain for Run {
    type C = sys::sf_run;
}

/// One connected component of a slice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Component {
    /// voxels
    pub area: u64,
    /// smallest rectangle around it
    pub bounds: Rect,
}

impl Component {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_component) -> Component {
        Component {
            area: c.area,
            bounds: Rect::of(&c.bounds),
        }
    }
}

/// A half-open box of voxels: a rectangle in the layers z0 \<= z \< z1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct VoxelBox {
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

impl VoxelBox {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_box) -> VoxelBox {
        VoxelBox {
            x0: c.x0,
            y0: c.y0,
            z0: c.z0,
            x1: c.x1,
            y1: c.y1,
            z1: c.z1,
        }
    }

    pub(crate) fn c(&self) -> sys::sf_box {
        sys::sf_box {
            x0: self.x0,
            y0: self.y0,
            z0: self.z0,
            x1: self.x1,
            y1: self.y1,
            z1: self.z1,
        }
    }
}

/// Exact sums over the solid voxels of a grid, in voxel indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Moments {
    /// number of solid voxels
    pub count: u64,
    /// first moments
    pub x: u128,
    /// first moments
    pub y: u128,
    /// first moments
    pub z: u128,
    /// second moments
    pub xx: u128,
    /// second moments
    pub yy: u128,
    /// second moments
    pub zz: u128,
    /// second moments
    pub xy: u128,
    /// second moments
    pub xz: u128,
    /// second moments
    pub yz: u128,
}

impl Moments {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_moments) -> Moments {
        Moments {
            count: c.count,
            x: u128::from(c.x.high) << 64 | u128::from(c.x.low),
            y: u128::from(c.y.high) << 64 | u128::from(c.y.low),
            z: u128::from(c.z.high) << 64 | u128::from(c.z.low),
            xx: u128::from(c.xx.high) << 64 | u128::from(c.xx.low),
            yy: u128::from(c.yy.high) << 64 | u128::from(c.yy.low),
            zz: u128::from(c.zz.high) << 64 | u128::from(c.zz.low),
            xy: u128::from(c.xy.high) << 64 | u128::from(c.xy.low),
            xz: u128::from(c.xz.high) << 64 | u128::from(c.xz.low),
            yz: u128::from(c.yz.high) << 64 | u128::from(c.yz.low),
        }
    }
}

/// An affine map: p -\> matrix p + shift.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// row after row
    pub matrix: [f64; 9],
    /// added last
    pub shift_mm: [f64; 3],
}

// The fields are those of C, in their order.
unsafe impl Plain for Transform {
    type C = sys::sf_transform;
}

/// How the triangles of a mesh hang together, after vertices of equal position are merged.
///
/// Where two solids touch along an edge, four triangles meet at it. Such an edge is nonmanifold, but no hole: the mesh is closed. It joins all four: solids that touch so are one shell, and solids that touch only in a point, or run through each other, are two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Topology {
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
    pub closed: bool,
    /// every edge is run as often one way as the other
    pub oriented: bool,
    /// closed, oriented, and the signed volume is negative
    pub flipped: bool,
}

impl Topology {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_topology) -> Topology {
        Topology {
            vertex_count: c.vertex_count,
            boundary_edges: c.boundary_edges,
            nonmanifold_edges: c.nonmanifold_edges,
            misoriented_edges: c.misoriented_edges,
            degenerate_triangles: c.degenerate_triangles,
            shells: c.shells,
            flipped_shells: c.flipped_shells,
            closed: c.closed != 0,
            oriented: c.oriented != 0,
            flipped: c.flipped != 0,
        }
    }
}

/// Integrals over the solid that a closed mesh bounds, density 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mass {
    /// negative where the mesh is inside out
    pub volume_mm3: f64,
    /// of all triangles
    pub area_mm2: f64,
    /// centre of mass; the middle of the bounds where there is no volume
    pub com_mm: [f64; 3],
    /// about the centre of mass: Ixx, Iyy, Izz, Ixy, Ixz, Iyz, the last three with the sign that they have in the tensor
    pub inertia_mm5: [f64; 6],
}

impl Mass {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_mass) -> Mass {
        Mass {
            volume_mm3: c.volume_mm3,
            area_mm2: c.area_mm2,
            com_mm: c.com_mm,
            inertia_mm5: c.inertia_mm5,
        }
    }
}

/// What the voxeliser did.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct VoxelizeReport {
    /// the way that was taken; [`SF_FILL_WINDING`](crate::sys::SF_FILL_WINDING) for [`SF_FILL_AUTO`](crate::sys::SF_FILL_AUTO)
    pub fill: Fill,
    /// directed edges without an opposite, once neighbours agree; 0 where parity or surface was asked for
    pub boundary_edges: usize,
    /// 1 when the mesh was read inside out and turned as a whole
    pub flipped: bool,
    /// rows whose crossings do not add up to nothing (leaks): parity only, because winding closes what is open
    pub odd_rows: u64,
    /// voxels that were set
    pub solid_voxels: u64,
}

impl VoxelizeReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_voxelize_report) -> VoxelizeReport {
        VoxelizeReport {
            fill: Fill::of(c.fill),
            boundary_edges: c.boundary_edges,
            flipped: c.flipped != 0,
            odd_rows: c.odd_rows,
            solid_voxels: c.solid_voxels,
        }
    }
}

/// A mass and its first moments about the origin. What is taken away counts negative.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Body {
    /// density times volume in mm3
    pub mass: f64,
    /// the sum of mass times position, in mm
    pub moment: [f64; 3],
}

// The fields are those of C, in their order.
unsafe impl Plain for Body {
    type C = sys::sf_body;
}

/// A mass in one point: a magnet, a screw.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ballast {
    /// density times volume in mm3
    pub mass: f64,
    /// where it sits
    pub at_mm: [f64; 3],
}

// The fields are those of C, in their order.
unsafe impl Plain for Ballast {
    type C = sys::sf_ballast;
}

/// Where a centre of mass may lie: all c with normal . c \>= offset_mm.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Halfspace {
    /// in the frame of the mesh
    pub normal: [f64; 3],
    /// in mm where `normal` has length 1
    pub offset_mm: f64,
}

// The fields are those of C, in their order.
unsafe impl Plain for Halfspace {
    type C = sys::sf_halfspace;
}

/// What becomes of a handle: p -\> scale \* turn (p - centre) + centre + shift.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// 1 leaves the size
    pub scale: f64,
    /// a rotation, row after row; not checked to be one
    pub turn: [f64; 9],
    /// added last
    pub shift_mm: [f64; 3],
}

// The fields are those of C, in their order.
unsafe impl Plain for Pose {
    type C = sys::sf_pose;
}

/// A direction in which a pose changes, and what a sum changes by it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PoseChange {
    /// of the scale
    pub scale: f64,
    /// of the shift
    pub shift_mm: [f64; 3],
    /// a small turn after the pose's own, about this axis by its length
    pub spin_rad: [f64; 3],
}

// The fields are those of C, in their order.
unsafe impl Plain for PoseChange {
    type C = sys::sf_pose_change;
}

/// How weights are found. Fill with [`sf_weights_options_default()`](crate::sys::sf_weights_options_default).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightsOptions {
    /// [`SF_WEIGHTS_CLAMPED`](crate::sys::SF_WEIGHTS_CLAMPED) by default
    pub method: WeightsMethod,
    /// voxels are taken together in blocks until they are no more than this: 32768; at least 8
    pub most_cells: u32,
    /// 0 (default), or how long the edges of a block should be, rounded to whole voxels on each axis; most_cells is not looked at then
    pub cell_mm: f64,
    /// how far from what is looked for a weight may be, about: 1e-5; 1e-9..1e-2
    pub tolerance: f64,
}

impl WeightsOptions {
    pub(crate) fn of(c: &sys::sf_weights_options) -> WeightsOptions {
        WeightsOptions {
            method: WeightsMethod::of(c.method),
            most_cells: c.most_cells,
            cell_mm: c.cell_mm,
            tolerance: c.tolerance,
        }
    }

    pub(crate) fn c(&self) -> sys::sf_weights_options {
        let mut c = unsafe { sys::sf_weights_options_default() };
        c.method = self.method.c();
        c.most_cells = self.most_cells;
        c.cell_mm = self.cell_mm;
        c.tolerance = self.tolerance;
        c
    }
}

impl Default for WeightsOptions {
    fn default() -> WeightsOptions {
        WeightsOptions::of(&unsafe { sys::sf_weights_options_default() })
    }
}

/// What weights were made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightsFacts {
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
    /// what is left, as a change of weights: see [`sf_weights_create()`](crate::sys::sf_weights_create)
    pub residual: f64,
}

impl WeightsFacts {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_weights_facts) -> WeightsFacts {
        WeightsFacts {
            handle_count: c.handle_count,
            cell_count: c.cell_count,
            node_count: c.node_count,
            loose_count: c.loose_count,
            block: c.block,
            cell_mm: c.cell_mm,
            iterations: c.iterations,
            residual: c.residual,
        }
    }
}

/// How a blend stretches the solid, at the corners of all its cells.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fold {
    /// least determinant of the blend's derivative: the factor by which volume grows there; where it is not above 0 the solid is folded over
    pub least_det: f64,
    /// where that is, before bending
    pub at_mm: [f64; 3],
    /// how many of the places looked at have none above 0
    pub folded: u64,
    /// how many were looked at: eight a cell
    pub places: u64,
}

// The fields are those of C, in their order.
unsafe impl Plain for Fold {
    type C = sys::sf_fold;
}

/// An edge that is kept sharp for a while: by a whole number of steps, or part of one more.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Crease {
    /// its ends; in dimension 3 an edge of the boundary
    pub points: [u32; 2],
    /// 0: smooth; [`SF_SHARP`](crate::sys::SF_SHARP) and more: for ever
    pub sharpness: f64,
}

// The fields are those of C, in their order.
unsafe impl Plain for Crease {
    type C = sys::sf_crease;
}

/// A point that is kept sharp: a corner of the surface.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SharpPoint {
    /// in dimension 3 one of the boundary
    pub point: u32,
    /// as a crease's
    pub sharpness: f64,
}

// The fields are those of C, in their order.
unsafe impl Plain for SharpPoint {
    type C = sys::sf_sharp_point;
}

/// What [`sf_cage_check()`](crate::sys::sf_cage_check) counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CageReport {
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

impl CageReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_cage_report) -> CageReport {
        CageReport {
            boundary_faces: c.boundary_faces,
            boundary_points: c.boundary_points,
            loose_points: c.loose_points,
            components: c.components,
            inverted_cells: c.inverted_cells,
            first_inverted: c.first_inverted,
            irregular_points: c.irregular_points,
            irregular_edges: c.irregular_edges,
            volume_mm3: c.volume_mm3,
        }
    }
}

/// A place where struts meet: a cube along the axes.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SkeletonNode {
    /// its middle
    pub at_mm: [f64; 3],
    /// half of the cube's side, above 0
    pub half_side_mm: f64,
}

// The fields are those of C, in their order.
unsafe impl Plain for SkeletonNode {
    type C = sys::sf_skeleton_node;
}

/// A strut between two nodes.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct SkeletonStrut {
    /// which two, not the same
    pub nodes: [u32; 2],
    /// into how many cells it is cut, at least 1
    pub cells: u32,
}

// The fields are those of C, in their order.
unsafe impl Plain for SkeletonStrut {
    type C = sys::sf_skeleton_strut;
}

/// What a history holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CageHistoryState {
    /// steps that can be undone
    pub undo_count: usize,
    /// steps that can be redone
    pub redo_count: usize,
    /// of both
    pub bytes: usize,
}

impl CageHistoryState {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_cage_history_state) -> CageHistoryState {
        CageHistoryState {
            undo_count: c.undo_count,
            redo_count: c.redo_count,
            bytes: c.bytes,
        }
    }
}

/// What reading found besides the cage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CageReading {
    /// the format of the file
    pub format: CageFormat,
    /// cells that were inverted at every corner, and were turned
    pub turned_cells: usize,
    /// elements of a lower dimension than the cage's, which it lacks
    pub passed_over: usize,
}

impl CageReading {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_cage_reading) -> CageReading {
        CageReading {
            format: CageFormat::of(c.format),
            turned_cells: c.turned_cells,
            passed_over: c.passed_over,
        }
    }
}

/// What is asked of a stance. Fill with [`sf_stance_options_default()`](crate::sys::sf_stance_options_default).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StanceOptions {
    /// standing by default
    pub kind: StanceKind,
    /// the direction away from the ground, of any length from 1e-100 to 1e100: +z
    pub up: [f64; 3],
    /// standing: the tilt of the ground, in whatever direction, that it must survive: 4 degrees; 0 to 80 degrees
    pub gamma_rad: f64,
    /// hanging, rocking: how far from the pose asked for it may come to rest: 1 degree; more than 0, at most 45 degrees
    pub tolerance_rad: f64,
    /// rocking: the tilt from which it must still roll back: 20 degrees; more than tolerance_rad, at most 80 degrees
    pub range_rad: f64,
    /// vertices this close above the lowest one touch the ground; 0, the default: a millionth of the diagonal of the mesh's box
    pub contact_mm: f64,
    /// only vertices in this box can touch the ground, borders included: everywhere by default
    pub region_low_mm: [f64; 3],
    /// the box's upper corner
    pub region_high_mm: [f64; 3],
    /// hanging: where the string is tied: the origin
    pub point_mm: [f64; 3],
    /// hanging: how far below the point the centre of mass must lie; 0, the default: a hundredth of the diagonal
    pub lever_mm: f64,
}

impl StanceOptions {
    pub(crate) fn of(c: &sys::sf_stance_options) -> StanceOptions {
        StanceOptions {
            kind: StanceKind::of(c.kind),
            up: c.up,
            gamma_rad: c.gamma_rad,
            tolerance_rad: c.tolerance_rad,
            range_rad: c.range_rad,
            contact_mm: c.contact_mm,
            region_low_mm: c.region_low_mm,
            region_high_mm: c.region_high_mm,
            point_mm: c.point_mm,
            lever_mm: c.lever_mm,
        }
    }

    pub(crate) fn c(&self) -> sys::sf_stance_options {
        let mut c = unsafe { sys::sf_stance_options_default() };
        c.kind = self.kind.c();
        c.up = self.up;
        c.gamma_rad = self.gamma_rad;
        c.tolerance_rad = self.tolerance_rad;
        c.range_rad = self.range_rad;
        c.contact_mm = self.contact_mm;
        c.region_low_mm = self.region_low_mm;
        c.region_high_mm = self.region_high_mm;
        c.point_mm = self.point_mm;
        c.lever_mm = self.lever_mm;
        c
    }
}

impl Default for StanceOptions {
    fn default() -> StanceOptions {
        StanceOptions::of(&unsafe { sys::sf_stance_options_default() })
    }
}

/// How a body of a given centre of mass fares in a stance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StanceVerdict {
    /// standing: the least tilt of the ground, over all directions, that makes it fall, negative where it falls as it is; hanging: minus the angle between the pose asked for and the one it comes to rest in; rocking: the same, the worst of those it comes to from the pose and from sixteen directions at the end of the range
    pub margin_rad: f64,
    /// how far inside of the nearest half-space's plane the centre of mass lies; negative outside
    pub slack_mm: f64,
    /// standing: the edge over which it falls first, two corners; twice the same point where the polygon is one, or where the body hangs; rocking: an edge of what it comes to rest on
    pub edge_mm: [[f64; 3]; 2],
    /// standing: margin_rad \>= 0; hanging, rocking: it comes to rest within the tolerance, hanging with the centre of mass not in the point
    pub stands: bool,
    /// it is in all half-spaces, to a billionth of the diagonal; standing, it also lies above the ground
    pub safe: bool,
}

impl StanceVerdict {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_stance_verdict) -> StanceVerdict {
        StanceVerdict {
            margin_rad: c.margin_rad,
            slack_mm: c.slack_mm,
            edge_mm: c.edge_mm,
            stands: c.stands != 0,
            safe: c.safe != 0,
        }
    }
}

/// How a body lies once it has come to rest on level ground.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rest {
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

// The fields are those of C, in their order.
unsafe impl Plain for Rest {
    type C = sys::sf_rest;
}

/// Gaps that matter may span between two anchored ends, in voxels along x, y and both diagonals.
///
/// Let A be the voxels of a slice that are carried by what is alive below, and let A\* be the opening of A along a direction by the anchor: what lies in carried runs of at least that length. A gap is a maximal run, along that direction, of the slice's voxels outside A\*; it is bridged when A\* bounds it on both ends and it is no longer than the span. Bridged voxels are alive, but have no reach to spare, and bridge nothing themselves in their own layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Bridge {
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

impl Bridge {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_bridge) -> Bridge {
        Bridge {
            span_x: c.span_x,
            span_y: c.span_y,
            span_diagonal: c.span_diagonal,
            anchor_x: c.anchor_x,
            anchor_y: c.anchor_y,
            anchor_diagonal: c.anchor_diagonal,
        }
    }
}

/// What a rule allows on its lattice, for people: angles from the vertical, in radians.
///
/// The first three hold in the long run, over many layers, in every layer of the lattice; the last is exceeded nowhere but for rounding (octagon: less than 1.502 voxel in the plane, however long the overhang).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RuleAngles {
    /// an overhang along x is accepted up to this angle
    pub axis_x_rad: f64,
    /// the same along y
    pub axis_y_rad: f64,
    /// the same along the diagonal of a pixel
    pub diagonal_rad: f64,
    /// no overhang beyond this angle is accepted in any direction
    pub steepest_rad: f64,
}

impl RuleAngles {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_rule_angles) -> RuleAngles {
        RuleAngles {
            axis_x_rad: c.axis_x_rad,
            axis_y_rad: c.axis_y_rad,
            diagonal_rad: c.diagonal_rad,
            steepest_rad: c.steepest_rad,
        }
    }
}

/// One place where a shape is not supported: an 8-connected region (through edges and corners) of the voxels of one layer that the layer below does not carry.
///
/// Every voxel that trimming takes away is due to exactly one finding: to that of its own region where nothing carries it; else to the one with the lowest index among those that the voxels which carry it are due to, all of which are lost as well.
///
/// Under slack, and with bridges, a voxel can be lost because of matter that lies farther off than what carries it; no finding answers for such voxels (unlinked_voxels).
///
/// An island touches nothing that is carried, and has no cause. An overhang has one when all carried voxels that touch its region, corners included, are lost: the lowest index that these are due to. It grows out of matter that hangs in the air already, so the cause is what to look at first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Finding {
    /// island or overhang
    pub kind: FindingKind,
    /// layer where it starts, counted from the lattice's layer 0
    pub layer: u32,
    /// index of an earlier finding that this one follows, or [`SF_FINDING_ROOT`](crate::sys::SF_FINDING_ROOT) (`None` here)
    pub cause: Option<u32>,
    /// voxels of the region
    pub area: u64,
    /// voxels that trimming takes away because of it, the region included
    pub volume: u64,
    /// smallest box around those voxels
    pub box_: VoxelBox,
}

impl Finding {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_finding) -> Finding {
        Finding {
            kind: FindingKind::of(c.kind),
            layer: c.layer,
            cause: (c.cause != u32::MAX).then_some(c.cause),
            area: c.area,
            volume: c.volume,
            box_: VoxelBox::of(&c.box_),
        }
    }

    pub(crate) fn c(&self) -> sys::sf_finding {
        sys::sf_finding {
            kind: self.kind.c(),
            layer: self.layer,
            cause: self.cause.unwrap_or(u32::MAX),
            area: self.area,
            volume: self.volume,
            box_: self.box_.c(),
        }
    }
}

/// Counts of a check.
///
/// All counts are exact whatever fits where. The volumes of the findings and unlinked_voxels sum up to trimmed_voxels. While runs_dropped is 0 a shorter array of findings holds just what a longer one would hold in its first places.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CheckReport {
    /// layers pushed
    pub layer_count: u32,
    /// the bed layer; [`SF_BED_AUTO`](crate::sys::SF_BED_AUTO) while there was no matter (`None` here)
    pub bed_layer: Option<u32>,
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
    pub support_free: bool,
}

impl CheckReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_check_report) -> CheckReport {
        CheckReport {
            layer_count: c.layer_count,
            bed_layer: (c.bed_layer != u32::MAX).then_some(c.bed_layer),
            solid_voxels: c.solid_voxels,
            unsupported_voxels: c.unsupported_voxels,
            trimmed_voxels: c.trimmed_voxels,
            island_count: c.island_count,
            overhang_count: c.overhang_count,
            findings_dropped: c.findings_dropped,
            runs_dropped: c.runs_dropped,
            unlinked_voxels: c.unlinked_voxels,
            support_free: c.support_free != 0,
        }
    }
}

/// How steep the overhangs of a shape are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steepest {
    /// from the vertical: the least angle that it is support-free for; or, where is_bounded is 0, the largest that was tried
    pub angle_rad: f64,
    /// 0: it is not support-free for any angle that was tried, up to the largest that the lattice can be served for, at most 85 degrees: an island, or a ledge longer than the last step reaches
    pub is_bounded: bool,
    /// the lowest layer that a slightly smaller angle does not carry, or that none does; [`SF_BED_AUTO`](crate::sys::SF_BED_AUTO) when even 5 degrees carry everything (`None` here)
    pub layer: Option<u32>,
    /// box of the finding there; all zero when there is none
    pub box_: VoxelBox,
}

impl Steepest {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_steepest) -> Steepest {
        Steepest {
            angle_rad: c.angle_rad,
            is_bounded: c.is_bounded != 0,
            layer: (c.layer != u32::MAX).then_some(c.layer),
            box_: VoxelBox::of(&c.box_),
        }
    }
}

/// Counts of a trim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TrimReport {
    /// solid voxels left
    pub kept_voxels: u64,
    /// solid voxels taken away
    pub removed_voxels: u64,
    /// the bed layer; [`SF_BED_AUTO`](crate::sys::SF_BED_AUTO) when the grid holds no matter (`None` here)
    pub bed_layer: Option<u32>,
}

impl TrimReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_trim_report) -> TrimReport {
        TrimReport {
            kept_voxels: c.kept_voxels,
            removed_voxels: c.removed_voxels,
            bed_layer: (c.bed_layer != u32::MAX).then_some(c.bed_layer),
        }
    }
}

/// What carving did. Bodies hold `rest`; slacks and distances are over all stances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarveReport {
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
    pub before: Body,
    /// body of the result
    pub after: Body,
    /// least over all half-spaces of how far inside it the centre of mass lies; negative: outside. 0 without stances
    pub slack_before_mm: f64,
    /// the same of the result
    pub slack_mm: f64,
    /// root of the sum, over stances, of the squared distance from the centre of mass to the safe region, across the stance's up
    pub distance_before_mm: f64,
    /// the same of the result
    pub distance_mm: f64,
    /// plane: rounds that took something away
    pub rounds: u32,
    /// pieces of the result, connected by faces, edges and corners, that hold no voxel of the wall; 0 where there is no wall
    pub floating_pieces: u64,
    /// and their voxels
    pub floating_voxels: u64,
    /// 1 when every half-space holds, as it does without stances
    pub safe: bool,
}

impl CarveReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_carve_report) -> CarveReport {
        CarveReport {
            solid_voxels: c.solid_voxels,
            wall_voxels: c.wall_voxels,
            removed_voxels: c.removed_voxels,
            kept_voxels: c.kept_voxels,
            removed_mm3: c.removed_mm3,
            before: crate::plain::of(&c.before),
            after: crate::plain::of(&c.after),
            slack_before_mm: c.slack_before_mm,
            slack_mm: c.slack_mm,
            distance_before_mm: c.distance_before_mm,
            distance_mm: c.distance_mm,
            rounds: c.rounds,
            floating_pieces: c.floating_pieces,
            floating_voxels: c.floating_voxels,
            safe: c.safe != 0,
        }
    }
}

/// One hole: a shaft from a void down to the open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drain {
    /// middle of its upper end, in the void
    pub from_mm: [f64; 3],
    /// middle of its lower end; straight below where it could be
    pub to_mm: [f64; 3],
    /// solid voxels that were drilled out
    pub voxels: u64,
    /// what they weighed
    pub body: Body,
    /// of the void that it was drilled for
    pub void_voxels: u64,
}

impl Drain {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_drain) -> Drain {
        Drain {
            from_mm: c.from_mm,
            to_mm: c.to_mm,
            voxels: c.voxels,
            body: crate::plain::of(&c.body),
            void_voxels: c.void_voxels,
        }
    }
}

/// What became of the voids.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrainReport {
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
    /// voids that are closed still: no hole fits and they are not filled, or none may be drilled. [`sf_grid_voids()`](crate::sys::sf_grid_voids) with an open bed names them
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
    pub removed: Body,
}

impl DrainReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_drain_report) -> DrainReport {
        DrainReport {
            void_count: c.void_count,
            void_voxels: c.void_voxels,
            drained_count: c.drained_count,
            filled_count: c.filled_count,
            filled_voxels: c.filled_voxels,
            closed_count: c.closed_count,
            closed_voxels: c.closed_voxels,
            drain_count: c.drain_count,
            drains_dropped: c.drains_dropped,
            removed_voxels: c.removed_voxels,
            removed: crate::plain::of(&c.removed),
        }
    }
}

/// The counts of one layer.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CertificateLayer {
    /// solid voxels
    pub solid: u64,
    /// those of them that are exempt
    pub exempt: u64,
    /// those that nothing below carries, and bridges hold
    pub bridged: u64,
}

// The fields are those of C, in their order.
unsafe impl Plain for CertificateLayer {
    type C = sys::sf_certificate_layer;
}

/// The integers of one step, from layer k to layer k + 1.
///
/// Box3 and octagon: voxel (dx, dy) off carries where |dx| and |dy| are at most `first` and |dx| + |dy| is at most `second`. Disk and slack: the reach of the step along x and along y in 1/2^24 voxel; slack: and the units that the step gives.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CertificateStep {
    /// see above
    pub first: u64,
    /// see above
    pub second: u64,
    /// slack: units that the step gives; else 0
    pub gain: u32,
}

// The fields are those of C, in their order.
unsafe impl Plain for CertificateStep {
    type C = sys::sf_certificate_step;
}

/// One gap that a bridge spans: `length` voxels from (x, y) along a direction.
///
/// Directions: 0 is (1, 0), 1 is (0, 1), 2 is (1, 1), 3 is (-1, 1). Listed are the gaps, as [`sf_bridge`](crate::sys::sf_bridge) defines them, that hold a voxel which nothing else carries; layer by layer, direction by direction, and by their first such voxel, row by row.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CertificateSpan {
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

// The fields are those of C, in their order.
unsafe impl Plain for CertificateSpan {
    type C = sys::sf_certificate_span;
}

/// What [`sf_tets_check()`](crate::sys::sf_tets_check) finds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TetsReport {
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

impl TetsReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_tets_report) -> TetsReport {
        TetsReport {
            volume_mm3: c.volume_mm3,
            inverted: c.inverted,
            first_inverted: c.first_inverted,
            boundary_faces: c.boundary_faces,
            crowded_faces: c.crowded_faces,
        }
    }
}

/// What fixing a finding takes, in voxels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FindingCost {
    /// taken away by a trim: the volume of the finding
    pub trim_voxels: u64,
    /// added below the finding's region so that all of it is carried (`None` here)
    pub grow_voxels: Option<u64>,
}

impl FindingCost {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_finding_cost) -> FindingCost {
        FindingCost {
            trim_voxels: c.trim_voxels,
            grow_voxels: (c.grow_voxels != u64::MAX).then_some(c.grow_voxels),
        }
    }

    pub(crate) fn c(&self) -> sys::sf_finding_cost {
        sys::sf_finding_cost {
            trim_voxels: self.trim_voxels,
            grow_voxels: self.grow_voxels.unwrap_or(u64::MAX),
        }
    }
}

/// A void that has no way out but, if any, upwards.
///
/// Voids are connected through faces (6 neighbours): what flows passes no edge and no corner, and so the walls that hold it may be connected by edges and corners (26 neighbours).
///
/// Let E_k be the empty voxels of the layers from the bed to k. A component of E_k is sealed when it touches neither a side of the grid nor, where that is open, the bed: its only way out is the plane of layer k, which in a resin printer lies at the film, so that pulling the part off works against a vacuum. The voids are the largest of these sets, over all k: those that lie in no other one. A void is a trap where all above its last layer is solid, so that it stays shut, and a cup where the next layer joins it to the outside, or where there is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Void {
    /// trap or cup
    pub kind: VoidKind,
    /// layer that joins it to the outside; the number of layers where only the end of the print does; UINT32_MAX for a trap (`None` here)
    pub vent_layer: Option<u32>,
    /// voxels
    pub volume: u64,
    /// most voxels of one layer that were sealed in one: what the film pulls at
    pub area: u64,
    /// smallest box around it; where z0 is the bed layer, it also opens once the part is off the bed
    pub box_: VoxelBox,
}

impl Void {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_void) -> Void {
        Void {
            kind: VoidKind::of(c.kind),
            vent_layer: (c.vent_layer != u32::MAX).then_some(c.vent_layer),
            volume: c.volume,
            area: c.area,
            box_: VoxelBox::of(&c.box_),
        }
    }
}

/// Counts of voids; exact whatever fits where.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct VoidsReport {
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
    /// the bed layer; [`SF_BED_AUTO`](crate::sys::SF_BED_AUTO) when there is no matter (`None` here)
    pub bed_layer: Option<u32>,
}

impl VoidsReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_voids_report) -> VoidsReport {
        VoidsReport {
            trap_count: c.trap_count,
            trap_voxels: c.trap_voxels,
            cup_count: c.cup_count,
            cup_voxels: c.cup_voxels,
            small_cup_count: c.small_cup_count,
            voids_dropped: c.voids_dropped,
            bed_layer: (c.bed_layer != u32::MAX).then_some(c.bed_layer),
        }
    }
}

/// What was read of a glTF file, and what was passed over.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct GltfReport {
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

impl GltfReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_gltf_report) -> GltfReport {
        GltfReport {
            nodes: c.nodes,
            pieces: c.pieces,
            passed: c.passed,
            skinned: c.skinned,
            morphed: c.morphed,
            animations: c.animations,
        }
    }
}

/// A voxel of a grid.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Voxel {
    /// column, row, layer
    pub x: u32,
    /// column, row, layer
    pub y: u32,
    /// column, row, layer
    pub z: u32,
}

// The fields are those of C, in their order.
unsafe impl Plain for Voxel {
    type C = sys::sf_voxel;
}

/// Counts of [`sf_grid_emit()`](crate::sys::sf_grid_emit).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EmitReport {
    /// voxels that became solid
    pub added_voxels: u64,
    /// voxels of the brush that were left out because nothing carries them; those outside the grid or the masks do not count
    pub trimmed_voxels: u64,
}

impl EmitReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_emit_report) -> EmitReport {
        EmitReport {
            added_voxels: c.added_voxels,
            trimmed_voxels: c.trimmed_voxels,
        }
    }
}

/// Counts of [`sf_grid_grow()`](crate::sys::sf_grid_grow).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct GrowReport {
    /// solid voxels before, all of which are left
    pub kept_voxels: u64,
    /// voxels that became solid
    pub added_voxels: u64,
    /// the bed layer; [`SF_BED_AUTO`](crate::sys::SF_BED_AUTO) when the grid holds no matter (`None` here)
    pub bed_layer: Option<u32>,
}

impl GrowReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_grow_report) -> GrowReport {
        GrowReport {
            kept_voxels: c.kept_voxels,
            added_voxels: c.added_voxels,
            bed_layer: (c.bed_layer != u32::MAX).then_some(c.bed_layer),
        }
    }
}

/// What became of the tones of one material so far, in voxels: asked = placed + dropped + carried, each to 2^-24 of a voxel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Diffusion {
    /// sum of the tones of solid voxels
    pub asked: f64,
    /// voxels of the material, before keep-outs
    pub placed: f64,
    /// lost where the next voxel up is empty
    pub dropped: f64,
    /// waiting for the next slice
    pub carried: f64,
}

impl Diffusion {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_diffusion) -> Diffusion {
        Diffusion {
            asked: c.asked,
            placed: c.placed,
            dropped: c.dropped,
            carried: c.carried,
        }
    }
}

/// How much of a material a part takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaterialUse {
    /// how many
    pub voxels: u64,
    /// of these
    pub volume_mm3: f64,
    /// by its density; 0 without one
    pub mass_g: f64,
}

impl MaterialUse {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_material_use) -> MaterialUse {
        MaterialUse {
            voxels: c.voxels,
            volume_mm3: c.volume_mm3,
            mass_g: c.mass_g,
        }
    }
}

/// What a job says of itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct JobInfo {
    /// which format it is in
    pub format: JobFormat,
    /// whether pictures have more than black and white
    pub has_greys: bool,
    /// whether the job says how large a pixel is; 0: the caller did, or the format's first printer was taken
    pub has_pitch: bool,
}

impl JobInfo {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_job_info) -> JobInfo {
        JobInfo {
            format: JobFormat::of(c.format),
            has_greys: c.has_greys != 0,
            has_pitch: c.has_pitch != 0,
        }
    }
}

/// A place of the shape.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// piece j of a cell: the cell's first corner's place in `corners`, plus j
    pub piece: u32,
    /// 0 to 1 along the piece's axes; in dimension 2 the third is not looked at
    pub u: [f64; 3],
}

// The fields are those of C, in their order.
unsafe impl Plain for Place {
    type C = sys::sf_place;
}

/// What [`sf_limit_check()`](crate::sys::sf_limit_check) finds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct LimitReport {
    /// pieces that are proved to lie the right way out everywhere
    pub positive: usize,
    /// pieces of which a part lies inside out
    pub inverted: usize,
    /// the first of these; the number of pieces where there is none
    pub first_inverted: usize,
    /// the others: next to what is irregular nothing can be proved, and where a piece is hardly bent the right way the proof may be too coarse
    pub open: usize,
}

impl LimitReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_limit_report) -> LimitReport {
        LimitReport {
            positive: c.positive,
            inverted: c.inverted,
            first_inverted: c.first_inverted,
            open: c.open,
        }
    }
}

/// A measurement.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CurveSample {
    /// what was set: a fraction
    pub x: f64,
    /// what was found: a property, in any unit
    pub y: f64,
    /// how much it counts where measurements disagree, above 0; 1
    pub weight: f64,
}

// The fields are those of C, in their order.
unsafe impl Plain for CurveSample {
    type C = sys::sf_curve_sample;
}

/// How orientations are looked for. Fill with [`sf_orient_options_default()`](crate::sys::sf_orient_options_default).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrientOptions {
    /// what may rest on what; octagon by default
    pub rule: RuleKind,
    /// overhang from the vertical that still prints; 45 degrees
    pub angle_rad: f64,
    /// what is inside; [`SF_FILL_AUTO`](crate::sys::SF_FILL_AUTO) by default
    pub fill: Fill,
    /// directions spread over the sphere, beside the six axes and the large flat faces: 1000; at most 100000
    pub direction_count: u32,
    /// how many of these become voxels at the coarse resolution, beside the axes and the flat faces, 38 at most: 50; 1..10000
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

impl OrientOptions {
    pub(crate) fn of(c: &sys::sf_orient_options) -> OrientOptions {
        OrientOptions {
            rule: RuleKind::of(c.rule),
            angle_rad: c.angle_rad,
            fill: Fill::of(c.fill),
            direction_count: c.direction_count,
            coarse_count: c.coarse_count,
            fine_count: c.fine_count,
            coarse_resolution: c.coarse_resolution,
            resolution: c.resolution,
            weight_height: c.weight_height,
            weight_margin: c.weight_margin,
        }
    }

    pub(crate) fn c(&self) -> sys::sf_orient_options {
        let mut c = unsafe { sys::sf_orient_options_default() };
        c.rule = self.rule.c();
        c.angle_rad = self.angle_rad;
        c.fill = self.fill.c();
        c.direction_count = self.direction_count;
        c.coarse_count = self.coarse_count;
        c.fine_count = self.fine_count;
        c.coarse_resolution = self.coarse_resolution;
        c.resolution = self.resolution;
        c.weight_height = self.weight_height;
        c.weight_margin = self.weight_margin;
        c
    }
}

impl Default for OrientOptions {
    fn default() -> OrientOptions {
        OrientOptions::of(&unsafe { sys::sf_orient_options_default() })
    }
}

/// A way to put a part on the bed, and what came of it at the fine resolution.
///
/// The score is trimmed_voxels / solid_voxels (1 where nothing is solid) + weight_height \* height_mm / (diagonal of the mesh's box, as it is given) + weight_margin \* (1 - margin_rad / 90 degrees). Less is better.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orientation {
    /// the mesh's direction that points up, length 1
    pub up: [f64; 3],
    /// turns `up` to +z and puts the lowest vertex on z = 0
    pub turn: Transform,
    /// area of the faces that look down more steeply than the angle allows, as seen from below; faces on the bed are none
    pub unsupported_mm2: f64,
    /// of the part
    pub solid_voxels: u64,
    /// of these, what a trim takes away
    pub trimmed_voxels: u64,
    /// the same in mm3
    pub trimmed_mm3: f64,
    /// from the lowest vertex to the highest
    pub height_mm: f64,
    /// the least angle by which the part must be tipped to fall over an edge of what touches the bed; negative where it falls as it is
    pub margin_rad: f64,
    /// what is ranked by
    pub score: f64,
}

impl Orientation {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_orientation) -> Orientation {
        Orientation {
            up: c.up,
            turn: crate::plain::of(&c.turn),
            unsupported_mm2: c.unsupported_mm2,
            solid_voxels: c.solid_voxels,
            trimmed_voxels: c.trimmed_voxels,
            trimmed_mm3: c.trimmed_mm3,
            height_mm: c.height_mm,
            margin_rad: c.margin_rad,
            score: c.score,
        }
    }
}

/// What became of a brush.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PreserveReport {
    /// solid voxels of the brush that are gone
    pub removed_voxels: u64,
    /// solid voxels of the brush that are still there
    pub kept_voxels: u64,
    /// solid voxels outside the brush that are gone: 0 but for a paper's mode with a trim after it
    pub lost_outside: u64,
    /// voxels that were not solid and are: 0 but for the paper's text
    pub added_voxels: u64,
}

impl PreserveReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_preserve_report) -> PreserveReport {
        PreserveReport {
            removed_voxels: c.removed_voxels,
            kept_voxels: c.kept_voxels,
            lost_outside: c.lost_outside,
            added_voxels: c.added_voxels,
        }
    }
}

/// How a print stands, from the first layer to the last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrintingReport {
    /// the layer on the bed; [`SF_BED_AUTO`](crate::sys::SF_BED_AUTO) where nothing is solid (`None` here)
    pub bed_layer: Option<u32>,
    /// the least tilt, over all layers and pieces on the bed, that makes a piece fall; negative where one falls as it is; 90 degrees where nothing stands on the bed
    pub margin_rad: f64,
    /// after which layer: the lowest, where several are as bad; [`SF_BED_AUTO`](crate::sys::SF_BED_AUTO) where nothing stands on the bed; what follows is then all zero (`None` here)
    pub layer: Option<u32>,
    /// the box around the piece, as it was then
    pub piece: VoxelBox,
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
    /// the lowest layer that one begins in, or [`SF_BED_AUTO`](crate::sys::SF_BED_AUTO) (`None` here)
    pub floating_layer: Option<u32>,
    /// the largest number of pieces on the bed after any layer
    pub standing_count: u32,
}

impl PrintingReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_printing_report) -> PrintingReport {
        PrintingReport {
            bed_layer: (c.bed_layer != u32::MAX).then_some(c.bed_layer),
            margin_rad: c.margin_rad,
            layer: (c.layer != u32::MAX).then_some(c.layer),
            piece: VoxelBox::of(&c.piece),
            piece_voxels: c.piece_voxels,
            com_mm: c.com_mm,
            edge_mm: c.edge_mm,
            toppling_layers: c.toppling_layers,
            floating_count: c.floating_count,
            floating_layer: (c.floating_layer != u32::MAX).then_some(c.floating_layer),
            standing_count: c.standing_count,
        }
    }
}

/// What a repair did and what it cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct RepairReport {
    /// voxels added
    pub added_voxels: u64,
    /// voxels removed
    pub removed_voxels: u64,
    /// what that costs; 1 a voxel where no costs were given
    pub cost: u64,
    /// cost of the first result, before any improvement
    pub first_cost: u64,
    /// cost of a trim; [`SF_REPAIR_NO_COST`](crate::sys::SF_REPAIR_NO_COST) where it would remove what must stay (`None` here)
    pub trim_cost: Option<u64>,
    /// cost of keeping all that can be kept, along the first forest; [`SF_REPAIR_NO_COST`](crate::sys::SF_REPAIR_NO_COST) where that forest does not carry it all (`None` here)
    pub grow_cost: Option<u64>,
    /// voxels that must stay and cannot: 0 unless it is infeasible
    pub culprit_count: u64,
    /// most bytes of working memory at one time
    pub peak_memory: u64,
    /// rounds of improvement that were made, over all starts
    pub rounds: u32,
    /// the bed layer; [`SF_BED_AUTO`](crate::sys::SF_BED_AUTO) when the grid holds no matter (`None` here)
    pub bed_layer: Option<u32>,
}

impl RepairReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_repair_report) -> RepairReport {
        RepairReport {
            added_voxels: c.added_voxels,
            removed_voxels: c.removed_voxels,
            cost: c.cost,
            first_cost: c.first_cost,
            trim_cost: (c.trim_cost != u64::MAX).then_some(c.trim_cost),
            grow_cost: (c.grow_cost != u64::MAX).then_some(c.grow_cost),
            culprit_count: c.culprit_count,
            peak_memory: c.peak_memory,
            rounds: c.rounds,
            bed_layer: (c.bed_layer != u32::MAX).then_some(c.bed_layer),
        }
    }
}

/// What became of the voxels of all slices so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SampleReport {
    /// solid voxels
    pub solid: u64,
    /// of these, searched for instead of found from their neighbours
    pub located: u64,
    /// of these, that have a neighbour's properties: they lie within the surface and not within the shape
    pub filled: u64,
}

impl SampleReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_sample_report) -> SampleReport {
        SampleReport {
            solid: c.solid,
            located: c.located,
            filled: c.filled,
        }
    }
}

/// Where a tip is put: a voxel, or one that would be there beyond the grid's border.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Dab {
    /// column, row, layer; each within 2^30 of 0
    pub x: i32,
    /// column, row, layer; each within 2^30 of 0
    pub y: i32,
    /// column, row, layer; each within 2^30 of 0
    pub z: i32,
}

// The fields are those of C, in their order.
unsafe impl Plain for Dab {
    type C = sys::sf_dab;
}

/// What a call changed, and what of a stroke was kept back or lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SculptChange {
    /// box around the voxels of D that this call changed, and around no more than the stroke changes or did before the call; empty (all zero) where there are none
    pub drawn: VoxelBox,
    /// the same for T
    pub printable: VoxelBox,
    /// the same for materials
    pub material: VoxelBox,
    /// printable now and not before
    pub added_voxels: u64,
    /// within the union of the tips printable before and not now
    pub removed_voxels: u64,
    /// outside it printable before and not now: what fell
    pub lost_voxels: u64,
    /// adding: of the tips, not printable, because nothing carries them; remove-preserve: of the tips, left, because they carry
    pub kept_back_voxels: u64,
    /// add-grow: of the supporting paths, each voxel once for each
    pub path_voxels: u64,
}

impl SculptChange {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_sculpt_change) -> SculptChange {
        SculptChange {
            drawn: VoxelBox::of(&c.drawn),
            printable: VoxelBox::of(&c.printable),
            material: VoxelBox::of(&c.material),
            added_voxels: c.added_voxels,
            removed_voxels: c.removed_voxels,
            lost_voxels: c.lost_voxels,
            kept_back_voxels: c.kept_back_voxels,
            path_voxels: c.path_voxels,
        }
    }
}

/// What a history holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SculptHistory {
    /// steps that can be undone
    pub undo_count: usize,
    /// steps that were undone and can be done again
    pub redo_count: usize,
    /// bytes that they take
    pub size: usize,
    /// steps that were forgotten for want of memory
    pub forgotten_count: usize,
}

impl SculptHistory {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_sculpt_history) -> SculptHistory {
        SculptHistory {
            undo_count: c.undo_count,
            redo_count: c.redo_count,
            size: c.size,
            forgotten_count: c.forgotten_count,
        }
    }
}

/// What a session holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SessionCounts {
    /// strokes are steps
    pub tips: usize,
    /// strokes are steps
    pub steps: usize,
    /// dabs of all strokes
    pub strokes: usize,
    /// dabs of all strokes
    pub dabs: usize,
    /// 1: the state at its end as well
    pub has_state: bool,
}

impl SessionCounts {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_session_counts) -> SessionCounts {
        SessionCounts {
            tips: c.tips,
            steps: c.steps,
            strokes: c.strokes,
            dabs: c.dabs,
            has_state: c.has_state != 0,
        }
    }
}

/// How a shape is made to stand. Fill with [`sf_stand_options_default()`](crate::sys::sf_stand_options_default).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StandOptions {
    /// voxels are cubes of this edge; 0 (default): a sixty-fourth of the longest side
    pub pitch_mm: f64,
    /// how thick the wall must be everywhere; 0 (default): a hundredth of the longest side
    pub wall_mm: f64,
    /// 1 (default): the inside is carved; 0: it stays solid
    pub carve: bool,
    /// 1 (default): the outside is bent where carving is not enough
    pub deform: bool,
    /// support-free by default
    pub carve_mode: CarveMode,
    /// support-free: width of what is left standing inside; 2
    pub strut_width_vx: u32,
    /// support-free: what may rest on what; octagon
    pub rule: RuleKind,
    /// and how far it may hang over; 45 degrees
    pub angle_rad: f64,
    /// quadratic programs by default
    pub solver: StandSolver,
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
    /// handles move no farther along x, y or z, but by hand or by descent; 0 (default): half the longest side
    pub shift_max_mm: f64,
    /// 1: handles may turn as well; 0 by default, as in the paper
    pub turn: bool,
    /// how far above the ground all must stay that does not stand on it; 0 (default): a hundredth of the longest side
    pub clearance_mm: f64,
    /// bending aims at so much more than the stances ask for, because the carving after it is another; a tenth of a degree
    pub reserve_rad: f64,
    /// most rounds; 0 (default): 40, or 400 of descent, a step each
    pub rounds_max: u32,
}

impl StandOptions {
    pub(crate) fn of(c: &sys::sf_stand_options) -> StandOptions {
        StandOptions {
            pitch_mm: c.pitch_mm,
            wall_mm: c.wall_mm,
            carve: c.carve != 0,
            deform: c.deform != 0,
            carve_mode: CarveMode::of(c.carve_mode),
            strut_width_vx: c.strut_width_vx,
            rule: RuleKind::of(c.rule),
            angle_rad: c.angle_rad,
            solver: StandSolver::of(c.solver),
            mu: c.mu,
            weight_details: c.weight_details,
            weight_shifts: c.weight_shifts,
            weight_scales: c.weight_scales,
            scale_low: c.scale_low,
            scale_high: c.scale_high,
            shift_max_mm: c.shift_max_mm,
            turn: c.turn != 0,
            clearance_mm: c.clearance_mm,
            reserve_rad: c.reserve_rad,
            rounds_max: c.rounds_max,
        }
    }

    pub(crate) fn c(&self) -> sys::sf_stand_options {
        let mut c = unsafe { sys::sf_stand_options_default() };
        c.pitch_mm = self.pitch_mm;
        c.wall_mm = self.wall_mm;
        c.carve = self.carve.into();
        c.deform = self.deform.into();
        c.carve_mode = self.carve_mode.c();
        c.strut_width_vx = self.strut_width_vx;
        c.rule = self.rule.c();
        c.angle_rad = self.angle_rad;
        c.solver = self.solver.c();
        c.mu = self.mu;
        c.weight_details = self.weight_details;
        c.weight_shifts = self.weight_shifts;
        c.weight_scales = self.weight_scales;
        c.scale_low = self.scale_low;
        c.scale_high = self.scale_high;
        c.shift_max_mm = self.shift_max_mm;
        c.turn = self.turn.into();
        c.clearance_mm = self.clearance_mm;
        c.reserve_rad = self.reserve_rad;
        c.rounds_max = self.rounds_max;
        c
    }
}

impl Default for StandOptions {
    fn default() -> StandOptions {
        StandOptions::of(&unsafe { sys::sf_stand_options_default() })
    }
}

/// How far a shape has come. Angles are the least over all stances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StandReport {
    /// rounds so far
    pub rounds: u32,
    /// steps of the solver so far
    pub steps: u32,
    /// 1: another round would change nothing
    pub ended: bool,
    /// 1: in every stance it rests by itself, but maybe not safely
    pub stands: bool,
    /// 1: every stance has the margin that it asks for
    pub safe: bool,
    /// 1: it is safe, and bending has neither folded it over nor sunk it into the ground by more than a ten-thousandth of its size
    pub succeeded: bool,
    /// the margin, as [`sf_stance_judge()`](crate::sys::sf_stance_judge) gives it: the least
    pub margin_rad: f64,
    /// of the solid as it was given, densities included
    pub margin_before_rad: f64,
    /// standing alone: no carving of the shape as it was given has a better margin, were voxels carved by any fraction, support-free or not; 90 degrees where nothing was carved, where handles were posed before the first round, and where carving could bring the centre of mass to the ground, off a table's edge
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
    /// voxels of the carved shape that nothing supports and that were supported in the solid: 0 but for the paper's carving
    pub hanging_voxels: u64,
}

impl StandReport {
    #[allow(dead_code)]
    pub(crate) fn of(c: &sys::sf_stand_report) -> StandReport {
        StandReport {
            rounds: c.rounds,
            steps: c.steps,
            ended: c.ended != 0,
            stands: c.stands != 0,
            safe: c.safe != 0,
            succeeded: c.succeeded != 0,
            margin_rad: c.margin_rad,
            margin_before_rad: c.margin_before_rad,
            bound_rad: c.bound_rad,
            com_mm: c.com_mm,
            com_before_mm: c.com_before_mm,
            mass: c.mass,
            carved_mm3: c.carved_mm3,
            energy: c.energy,
            displacement_mm: c.displacement_mm,
            least_det: c.least_det,
            folded: c.folded,
            overlap_voxels: c.overlap_voxels,
            sunk_mm: c.sunk_mm,
            hanging_voxels: c.hanging_voxels,
        }
    }
}

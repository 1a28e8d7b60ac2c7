// SPDX-License-Identifier: MIT
// Results and choices of the library as Rust has them. Written by bindings/rust/generate.py.

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
            number => MeshFormat::Other(number),
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
    pub(crate) fn of(c: &sys::sf_trim_report) -> TrimReport {
        TrimReport {
            kept_voxels: c.kept_voxels,
            removed_voxels: c.removed_voxels,
            bed_layer: (c.bed_layer != u32::MAX).then_some(c.bed_layer),
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
    pub(crate) fn of(c: &sys::sf_grow_report) -> GrowReport {
        GrowReport {
            kept_voxels: c.kept_voxels,
            added_voxels: c.added_voxels,
            bed_layer: (c.bed_layer != u32::MAX).then_some(c.bed_layer),
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
    pub(crate) fn of(c: &sys::sf_preserve_report) -> PreserveReport {
        PreserveReport {
            removed_voxels: c.removed_voxels,
            kept_voxels: c.kept_voxels,
            lost_outside: c.lost_outside,
            added_voxels: c.added_voxels,
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
